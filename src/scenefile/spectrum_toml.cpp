#include "scenefile/spectrum_toml.h"

#include <array>
#include <filesystem>

#include "airlight/error.h"
#include "did_you_mean.h"
#include "optics/csv.h"
#include "optics/shipped_data.h"
#include "scenefile/text_file.h"
#include "scenefile/toml_text.h"

namespace airlight {
namespace {

Spectrum read(const toml::node& node, TableReader& parent, const std::string& key, double path_length);

Sampling read_sampling(TableReader& reader, Sampling fallback) {
  if (!reader.has("sampling")) return fallback;
  const std::string name = reader.text("sampling");
  constexpr std::array<std::string_view, 2> names{"bins", "point"};
  if (name == names[0]) return Sampling::bins;
  if (name == names[1]) return Sampling::point;
  reader.fail("sampling", " = " + toml_text(name) + did_you_mean(name, names));
}

TableSpectrum read_inline_table(TableReader& reader) {
  return {reader.numbers("wavelengths"), reader.numbers("values"), read_sampling(reader, Sampling::point), ""};
}

TableSpectrum read_file(TableReader& reader) {
  const std::string name = reader.text("file");
  // The shipped 10 nm files hold means over bins; what else people bring is most often sampled.
  const bool shipped = !shipped_text(name).empty();
  const Sampling sampling = read_sampling(reader, shipped ? Sampling::bins : Sampling::point);
  const std::string beside = (std::filesystem::path(reader.file()).parent_path() / name).string();
  if (name.find('\0') == std::string::npos) {
    if (const auto text = read_text_file(beside)) {
      TableSpectrum table = parse_spectrum_csv(*text, beside, sampling);
      table.file = name;
      return table;
    }
  }
  if (auto table = shipped_spectrum(name, sampling)) return *std::move(table);
  std::string names;
  for (const ShippedFile& file : shipped_files()) names += (names.empty() ? "" : ", ") + std::string(file.name);
  reader.fail("file",
              " = " + toml_text(name) + ": no such file beside " + reader.file() + ", nor among the shipped " + names);
}

std::vector<Spectrum> read_list(TableReader& reader, const std::string& key) {
  std::vector<Spectrum> spectra;
  if (!reader.has(key)) return spectra;
  for (const toml::node& node : reader.array(key)) {
    spectra.push_back(read(node, reader, key + "[" + std::to_string(spectra.size()) + "]", 0));
  }
  return spectra;
}

Spectrum read_column(TableReader& reader, double path_length) {
  if (!(path_length > 0)) {
    reader.fail("type", " = \"column\": only the absorption of a constituent whose profile holds air can be a column");
  }
  const double dobson = reader.number("dobson");
  const toml::node* cross_section = reader.find("cross_section");
  if (!cross_section) reader.fail("cross_section", " is missing");
  return Spectrum(ColumnSpectrum{dobson, path_length, {read(*cross_section, reader, "cross_section", 0)}});
}

Spectrum read_law(TableReader& reader, double path_length) {
  constexpr std::array<std::string_view, 6> types{"power",  "angstrom", "rayleigh-air",
                                                  "column", "product",  "hestroffer-magnan"};
  const std::string type = reader.text("type");
  if (type == "power") {
    return Spectrum(PowerSpectrum{reader.number("at"), reader.number("value"), reader.number("exponent")});
  }
  if (type == "angstrom") {
    return Spectrum(PowerSpectrum{reader.number("at"), reader.number("value"), -reader.number("exponent")});
  }
  if (type == "rayleigh-air") {
    return Spectrum(RayleighAirSpectrum{reader.number("number_density", RayleighAirSpectrum{}.number_density)});
  }
  if (type == "column") return read_column(reader, path_length);
  if (type == "product") {
    std::vector<Spectrum> factors = read_list(reader, "factors");
    std::vector<Spectrum> complements = read_list(reader, "complements");
    return Spectrum(ProductSpectrum{std::move(factors), std::move(complements)});
  }
  if (type == "hestroffer-magnan") return Spectrum(HestrofferMagnanSpectrum{});
  reader.fail("type", " = " + toml_text(type) + ": unknown law" + did_you_mean(type, types));
}

Spectrum read(const toml::node& node, TableReader& parent, const std::string& key, double path_length) {
  if (const auto* integer = node.as_integer()) return Spectrum(double(integer->get()));
  if (const auto* real = node.as_floating_point()) return Spectrum(real->get());
  if (!node.is_table()) {
    parent.fail(key, ": expected a number, { wavelengths, values }, { file } or { type = \"power\", ... }");
  }
  TableReader reader = parent.child(*node.as_table(), key);
  const double scale = reader.number("scale", 1);
  if (!(scale >= 0 && scale <= 1e60)) reader.fail("scale", " = " + number_text(scale) + ": expected 0 .. 1e+60");
  Spectrum spectrum;
  if (reader.has("type")) {
    spectrum = read_law(reader, path_length);
  } else if (reader.has("file")) {
    spectrum = Spectrum(read_file(reader));
  } else {
    spectrum = Spectrum(read_inline_table(reader));
  }
  reader.finish();
  return spectrum.scaled(scale);
}

// ---- to TOML ----

std::string sampling_text(Sampling sampling) { return sampling == Sampling::bins ? "\"bins\"" : "\"point\""; }

std::string list_text(const std::vector<Spectrum>& spectra) {
  std::string text;
  for (const Spectrum& spectrum : spectra) text += (text.empty() ? "" : ", ") + spectrum_toml(spectrum);
  return "[" + text + "]";
}

std::string fields(const ConstantSpectrum&) { return ""; }  // written as a number

std::string fields(const TableSpectrum& table) {
  const std::string sampling = ", sampling = " + sampling_text(table.sampling);
  if (!table.file.empty()) return "file = " + toml_text(table.file) + sampling;
  return "wavelengths = " + toml_text(table.wavelengths) + ", values = " + toml_text(table.values) + sampling;
}

std::string fields(const PowerSpectrum& law) {
  return "type = \"power\", at = " + toml_text(law.at) + ", value = " + toml_text(law.value) +
         ", exponent = " + toml_text(law.exponent);
}

std::string fields(const RayleighAirSpectrum& law) {
  return "type = \"rayleigh-air\", number_density = " + toml_text(law.number_density);
}

std::string fields(const HestrofferMagnanSpectrum&) { return "type = \"hestroffer-magnan\""; }

std::string fields(const ProductSpectrum& law) {
  std::string text = "type = \"product\"";
  if (!law.factors.empty()) text += ", factors = " + list_text(law.factors);
  if (!law.complements.empty()) text += ", complements = " + list_text(law.complements);
  return text;
}

std::string fields(const ColumnSpectrum& law) {
  return "type = \"column\", dobson = " + toml_text(law.dobson) +
         ", cross_section = " + spectrum_toml(law.cross_section.at(0));
}

}  // namespace

Spectrum read_spectrum(TableReader& reader, const std::string& key, Limits limits, double path_length) {
  const toml::node* node = reader.find(key);
  if (!node) reader.fail(key, " is missing");
  Spectrum spectrum = read(*node, reader, key, path_length);
  if (const auto problem = find_problem(spectrum, reader.path(key), limits))
    reader.fail_at(problem->key, problem->what);
  return spectrum;
}

std::string spectrum_toml(const Spectrum& spectrum) {
  if (const auto* constant = std::get_if<ConstantSpectrum>(&spectrum.law())) {
    return toml_text(constant->value * spectrum.factor());
  }
  std::string text = std::visit([](const auto& law) { return fields(law); }, spectrum.law());
  if (spectrum.factor() != 1) text += ", scale = " + toml_text(spectrum.factor());
  return "{ " + text + " }";
}

}  // namespace airlight
