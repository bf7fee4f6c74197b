#include "sky/model_tables.h"

#include <set>

#include "airlight/error.h"
#include "engine/kernel_index.h"
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

ModelTables model_tables(const Atmosphere& atmosphere, std::string_view name, Engine& engine,
                         const std::array<double, 4>& wavelengths, double altitude, const Direction& sun) {
  const Model& model = find_model(name);
  if (model.colours)
    throw InputError("model " + std::string(name) +
                     " has no tables of air: it answers in colours, from its parameters");
  const BakedAir baked = bake(atmosphere, wavelengths, 0, model.air);
  const Situation situation{atmosphere.planet.ground_radius, atmosphere.planet.top_altitude, altitude};
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
  std::set<std::string_view> read;
  for (const std::string_view pass : {model.rays, model.picture(situation), model.haze(situation)}) {
    if (pass.empty()) continue;
    const PassInfo& info = kernel_pass(pass);
    for (const ArgumentInfo& table : info.tables) read.insert(table.name);
    for (const ArgumentInfo& argument : info.parameters) {
      const Fields own = model.fields ? model.fields(argument.name, situation) : Fields{};
      if (!own.empty()) result.structs[std::string(argument.name)] = own;
    }
  }
  for (const TablePass& made : model.tables) {
    const PassInfo& pass = kernel_pass(made.pass);
    for (std::size_t i = 0; i < pass.outputs.size(); ++i) {
      if (!read.contains(pass.outputs[i])) continue;
      result.tables[std::string(pass.outputs[i])] = texels(engine, binder.run(made.pass, made.shape_for(situation))[i]);
    }
  }
  return result;
}

}  // namespace airlight
