#include "scenefile/air_toml.h"

#include <array>
#include <cmath>

#include "did_you_mean.h"
#include "optics/validate.h"
#include "scenefile/toml_text.h"

namespace airlight {
namespace {

void refuse(const TableReader& reader, const std::optional<Problem>& problem) {
  if (problem) reader.fail_at(problem->key, problem->what);
}

template <typename Types>
[[noreturn]] void unknown_type(const TableReader& reader, const std::string& type, const char* what,
                               const Types& types) {
  reader.fail("type", " = " + toml_text(type) + ": unknown " + what + did_you_mean(type, types));
}

// ---- profiles ----

Profile read_profile_fields(TableReader& reader) {
  constexpr std::array<std::string_view, 5> types{"exponential", "tent", "layers", "table", "us-standard-1976"};
  const std::string type = reader.text("type");
  if (type == "exponential") return ExponentialProfile{reader.number("scale_height")};
  if (type == "tent") return TentProfile{reader.number("altitude"), reader.number("half_width")};
  if (type == "layers") {
    LayersProfile profile;
    for (TableReader& layer : reader.tables("layers")) {
      profile.layers.push_back({layer.number("bottom"), layer.number("top"), layer.number("density")});
      layer.finish();
    }
    return profile;
  }
  if (type == "table") {
    return TableProfile{reader.numbers("altitudes"), reader.numbers("densities"), reader.flag("logarithmic", false)};
  }
  if (type == "us-standard-1976") return StandardAtmosphereProfile{};
  unknown_type(reader, type, "profile", types);
}

std::string fields(const ExponentialProfile& profile) {
  return "type = \"exponential\", scale_height = " + toml_text(profile.scale_height);
}
std::string fields(const TentProfile& profile) {
  return "type = \"tent\", altitude = " + toml_text(profile.altitude) +
         ", half_width = " + toml_text(profile.half_width);
}
std::string fields(const LayersProfile& profile) {
  std::string text;
  for (const LayersProfile::Layer& layer : profile.layers) {
    text += (text.empty() ? "{ bottom = " : ", { bottom = ") + toml_text(layer.bottom) +
            ", top = " + toml_text(layer.top) + ", density = " + toml_text(layer.density) + " }";
  }
  return "type = \"layers\", layers = [" + text + "]";
}
std::string fields(const TableProfile& profile) {
  return "type = \"table\", altitudes = " + toml_text(profile.altitudes) +
         ", densities = " + toml_text(profile.densities) + (profile.logarithmic ? ", logarithmic = true" : "");
}
std::string fields(const StandardAtmosphereProfile&) { return "type = \"us-standard-1976\""; }

// ---- phase functions ----

/// Divided by its integral, so that only its shape matters; one that is normalised already stays as it is, to the bit.
TablePhase normalised(TableReader& reader, TablePhase table) {
  const double integral = table.angles.size() == table.values.size() ? sphere_integral(table) : 0;
  if (!(integral > 0) || !std::isfinite(integral)) {
    reader.fail("values", ": expected as many values as angles, none negative and not all 0");
  }
  if (std::abs(integral - 1) < 1e-12) return table;
  for (double& value : table.values) value /= integral;
  return table;
}

Phase read_phase_fields(TableReader& reader) {
  constexpr std::array<std::string_view, 6> types{
      "rayleigh", "isotropic", "henyey-greenstein", "cornette-shanks", "double-henyey-greenstein", "table"};
  const std::string type = reader.text("type");
  if (type == "rayleigh") return RayleighPhase{reader.number("depolarisation", 0)};
  if (type == "isotropic") return IsotropicPhase{};
  if (type == "henyey-greenstein") return HenyeyGreensteinPhase{reader.number("g")};
  if (type == "cornette-shanks") return CornetteShanksPhase{reader.number("g")};
  if (type == "double-henyey-greenstein") {
    return DoubleHenyeyGreensteinPhase{reader.number("g1"), reader.number("g2"), reader.number("weight")};
  }
  if (type == "table") return normalised(reader, {reader.numbers("angles"), reader.numbers("values")});
  unknown_type(reader, type, "phase function", types);
}

std::string fields(const RayleighPhase& phase) {
  return "type = \"rayleigh\"" +
         (phase.depolarisation == 0 ? "" : ", depolarisation = " + toml_text(phase.depolarisation));
}
std::string fields(const IsotropicPhase&) { return "type = \"isotropic\""; }
std::string fields(const HenyeyGreensteinPhase& phase) {
  return "type = \"henyey-greenstein\", g = " + toml_text(phase.g);
}
std::string fields(const CornetteShanksPhase& phase) { return "type = \"cornette-shanks\", g = " + toml_text(phase.g); }
std::string fields(const DoubleHenyeyGreensteinPhase& phase) {
  return "type = \"double-henyey-greenstein\", g1 = " + toml_text(phase.g1) + ", g2 = " + toml_text(phase.g2) +
         ", weight = " + toml_text(phase.weight);
}
std::string fields(const TablePhase& phase) {
  return "type = \"table\", angles = " + toml_text(phase.angles) + ", values = " + toml_text(phase.values);
}

template <typename Variant>
std::string in_braces(const Variant& variant) {
  return "{ " + std::visit([](const auto& shape) { return fields(shape); }, variant) + " }";
}

}  // namespace

Profile read_profile(TableReader& reader) {
  Profile profile = read_profile_fields(reader);
  reader.finish();
  refuse(reader, find_problem(profile, reader.path()));
  return profile;
}

Phase read_phase(TableReader& reader) {
  Phase phase = read_phase_fields(reader);
  reader.finish();
  refuse(reader, find_problem(phase, reader.path()));
  return phase;
}

std::string profile_toml(const Profile& profile) { return in_braces(profile); }
std::string phase_toml(const Phase& phase) { return in_braces(phase); }

}  // namespace airlight
