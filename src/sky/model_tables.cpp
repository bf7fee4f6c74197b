#include "sky/model_tables.h"

#include "airlight/error.h"
#include "engine/kernel_index.h"
#include "engine/stage.h"
#include "optics/bake.h"
#include "sky/sky_impl.h"

namespace airlight {
namespace {

ModelTables::Texels texels(Engine& engine, const Table& table) {
  std::vector<double> values(4 * table.shape.texels());
  engine.read(table, values);
  return {table.shape, {values.begin(), values.end()}};
}

}  // namespace

ModelTables model_tables(const Atmosphere& atmosphere, std::string_view name, const Parameters& parameters,
                         Engine& engine, const std::array<double, 4>& wavelengths, double altitude,
                         const Direction& sun) {
  const Model& model = find_model(name);
  if (model.colours)
    throw InputError("model " + std::string(name) +
                     " has no tables of air: it answers in colours, from its parameters");
  const BakedAir baked = bake(atmosphere, wavelengths, 0, model.air);
  check_optical_depth(model, atmosphere.name, wavelengths, vertical_optical_depth(baked));
  const Values own_values = model_parameters(model, parameters, std::string(name) + ".");
  const Situation situation{atmosphere.planet.ground_radius, atmosphere.planet.top_altitude, altitude, &own_values};
  Binder binder(engine, model, situation);
  ModelTables result;
  const auto set = [&](const char* argument, const Fields& fields) {
    binder.set(argument, fields);
    result.structs[argument] = fields;
  };
  set("air", baked.numbers);
  set("observer", observer_fields(sun, altitude));
  for (const auto& [argument, table] :
       {std::pair{"zones", &baked.zones}, {"profile", &baked.profile}, {"phases", &baked.phases}}) {
    binder.set(argument, engine.upload(table->shape, table->rgba));
    result.tables[argument] = {table->shape, {table->rgba.begin(), table->rgba.end()}};
  }

  // What only makes other tables is left out.
  std::map<std::string_view, const PassInfo*> read;
  for (const std::string_view pass : {model.rays, model.picture(situation), model.haze(situation)}) {
    if (pass.empty()) continue;
    const PassInfo& info = kernel_pass(pass);
    for (const ArgumentInfo& table : info.tables) read[table.name] = &info;
    for (const ArgumentInfo& argument : info.parameters) {
      const Fields own = model.fields ? model.fields(argument.name, situation) : Fields{};
      if (!own.empty()) result.structs[std::string(argument.name)] = own;
    }
  }
  std::vector<TablePass> makers = model.tables;
  if (model.orders) makers.insert(makers.end(), {model.orders->source, model.orders->ground_light});
  const Stage whole(engine, 0.0, 1.0);
  for (const TablePass& made : makers) {
    for (const std::string_view output : kernel_pass(made.pass).outputs) {
      const auto reader = read.find(output);
      if (reader == read.end()) continue;
      result.tables[std::string(output)] = texels(engine, binder.table(output, *reader->second));
    }
  }
  return result;
}

}  // namespace airlight
