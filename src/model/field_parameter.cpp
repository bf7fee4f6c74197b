#include "model/field_parameter.h"

#include <algorithm>
#include <stdexcept>

#include "engine/kernel_index.h"

namespace airlight {

ParameterInfo field_parameter(std::string_view struct_name, std::string_view field, ParameterValue otherwise) {
  const auto fields = kernel_struct(struct_name).fields;
  const auto found = std::ranges::find(fields, field, &ArgumentInfo::name);
  if (found == fields.end())
    throw std::logic_error("struct " + std::string(struct_name) + " has no field " + std::string(field));
  const bool number = components(found->type) == 1;
  return {.name = found->name,
          .kind = number ? ParameterInfo::Kind::number : ParameterInfo::Kind::colour,
          .unit = found->unit,
          .text = found->text,
          .low = found->low,
          .high = found->high,
          .otherwise = std::move(otherwise)};
}

Fields struct_fields(std::string_view struct_name, const Values& values) {
  Fields fields;
  for (const ArgumentInfo& field : kernel_struct(struct_name).fields) {
    const auto found = values.all().find(field.name);
    if (found == values.all().end()) continue;
    if (const auto* numbers = std::get_if<std::vector<double>>(&found->second)) fields.emplace(field.name, *numbers);
  }
  return fields;
}

Fields zero_fields(std::string_view struct_name) {
  Fields fields;
  for (const ArgumentInfo& field : kernel_struct(struct_name).fields)
    fields.emplace(field.name, std::vector<double>(std::size_t(components(field.type)), 0.0));
  return fields;
}

Fields unit_air() {
  Fields air = zero_fields("Air");
  air["solar_irradiance"] = {1, 1, 1, 1};
  return air;
}

}  // namespace airlight
