// The part of `airlight validate` that says what few wavelengths cost in colour, and fits the four of real time.
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "airlight/error.h"
#include "airlight/sky.h"
#include "commands.h"
#include "interrupt.h"
#include "options.h"
#include "text_output.h"
#include "validate.h"
#include "validate/spectral_colour.h"

namespace airlight::cli {
namespace {

using namespace validation;
using Json = nlohmann::ordered_json;

template <class Numbers>
std::string listed(const Numbers& numbers) {
  std::string text;
  for (const double number : numbers) text += fmt::format("{}{:g}", text.empty() ? "" : ", ", number);
  return text;
}

std::string row(const std::string& name, const ColourErrors& errors) {
  return fmt::format("| {} | {:.2f}, {:.2f}, {:.1f} | {:.2f}, {:.2f}, {:.1f} | {} |\n", name, errors.day.median,
                     errors.day.p90, errors.day.worst, errors.twilight.median, errors.twilight.p90,
                     errors.twilight.worst, errors.twilight.where);
}

Json as_json(const ColourErrors& errors) {
  const auto part = [](const ColourError& error) {
    return Json{{"skies", error.count},
                {"median", error.median},
                {"p90", error.p90},
                {"worst", error.worst},
                {"where", error.where}};
  };
  return {{"wavelengths", errors.wavelengths}, {"day", part(errors.day)}, {"twilight", part(errors.twilight)}};
}

Json as_json(const FittedQuad& quad) {
  Json json = as_json(quad.errors);
  json["matrix"] = quad.matrix;  // four rows of X, Y, Z
  return json;
}

}  // namespace

int validate_spectrum(const ValidateOptions& options) {
  if (options.models.size() > 1) throw InputError("--spectrum: expected one --model");
  const std::string model = options.models.empty() ? "skyview" : options.models[0];
  check_model_name(model, "--model", model_names());
  if (model_info(model).colours) throw InputError(fmt::format("--spectrum: model {} knows no spectrum", model));
  const PagePart page(options.page, "spectrum");
  make_report_folder(options.folder);

  Json json{{"model", model}};
  std::string text = fmt::format(
      "Colour error (CIEDE2000 at the exposure that shows the truth as middle grey, so that brightness counts too) of "
      "few\n"
      "wavelengths against 40, light of `{}`: clear and hazy Earth from 2 m and 10 km. Median, 90th percentile, "
      "worst.\n\n"
      "| wavelengths | sun at 60 to 0 degrees | −2 to −12 degrees | worst in twilight |\n|---|---|---|---|\n",
      model);
  for (const int count : {3, 4, 8, 16}) {
    check_interrupt();
    const ColourErrors errors = colour_errors(model, wavelengths_of(count));
    text +=
        row(count <= 4 ? fmt::format("{}: {} nm", count, listed(errors.wavelengths)) : std::to_string(count), errors);
    json["counts"].push_back(as_json(errors));
  }
  const std::vector<SkySpectrum> skies = sky_spectra(model, photometric_wavelengths());
  const FittedQuad shipped = fit_matrix(skies, realtime_quad), best = fit_quad(skies);
  text += row(fmt::format("{} nm, one matrix fitted to all these skies", listed(shipped.wavelengths)), shipped.errors);
  text += row(fmt::format("{} nm, the best quad with one matrix", listed(best.wavelengths)), best.errors);
  json["realtime_with_one_matrix"] = as_json(shipped);
  json["best_quad"] = as_json(best);
  text +=
      "\nPictures take another matrix for each atmosphere, fitted to the spectra that sunlight takes on its ways "
      "through it. The matrices of\n"
      "the last two rows (X, Y, Z in cd m⁻² for 1 W m⁻² sr⁻¹ nm⁻¹ at each of the four) are for programs with one "
      "matrix:\n\n"
      "| nm | X | Y | Z |\n|---|---|---|---|\n";
  for (const FittedQuad* quad : {&shipped, &best})
    for (std::size_t i = 0; i < 4; ++i)
      text += fmt::format("| {:g} | {:.6g} | {:.6g} | {:.6g} |\n", quad->wavelengths[i], quad->matrix[i][0],
                          quad->matrix[i][1], quad->matrix[i][2]);

  write_text(options.folder + "/spectrum.json", json.dump(1) + '\n');
  write_text(options.folder + "/spectrum.md", text);
  page.write(text);
  return ok;
}

}  // namespace airlight::cli
