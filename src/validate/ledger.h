// The ledger: how wrong each model is under each condition, beside what it costs.
#pragma once
#include <string>
#include <vector>

#include "validate/figure.h"
#include "validate/model_answers.h"
#include "validate/yardstick.h"

namespace airlight::validation {

struct LedgerRow {
  std::string model, atmosphere;  ///< the contestant's name
  std::string quantity;           ///< "radiance", "luminance", "transmittance" or "sky_irradiance"
  std::string condition;          ///< "all", "sun 10", "from 10 km", "past a low limb", ...
  Figure figure;                  ///< relative, of transmittance absolute
  std::size_t rays = 0, unanswered = 0;
  double colour_median = 0, colour_p90 = 0;  ///< CIEDE2000 of light made as bright as the truth
};

struct ModelCost {
  std::string model, atmosphere;
  Cost cost;
};

struct Ledger {
  std::vector<double> wavelengths;  ///< [nm]
  std::size_t solved = 0;           ///< rays of the yardstick that were there
  std::size_t irradiances = 0;      ///< of the yardstick
  std::vector<LedgerRow> rows;
  std::vector<ModelCost> costs;
};

/// Values below this share of the brightest under the same sun, at the same wavelength, are not counted.
inline constexpr double dimmest_counted = 1e-5;

/// A published system's unit is its own: the factor that makes its zenith as bright as the truth's, with the sun 60 degrees up in the
/// air `earth`, seen from the ground. @throws InputError where the model says nothing there
double zenith_scale(const Contestant& contestant);

/// Adds the rows of one model in one atmosphere.
/// @param scale  of a published system's values [cd/m^2]; not used for others
void add_rows(Ledger& ledger, const Yardstick& yardstick, const ModelAnswers& answers, double scale);

/// The row of that name; none: nullptr.
const LedgerRow* find_row(const Ledger& ledger, const std::string& model, const std::string& atmosphere,
                          const std::string& quantity, const std::string& condition);

}  // namespace airlight::validation
