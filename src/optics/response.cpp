#include "optics/response.h"

#include <cmath>

#include "airlight/error.h"
#include "optics/csv.h"
#include "optics/number_text.h"

namespace airlight {

Response Response::scaled(double factor) const {
  Response response = *this;
  for (Xyz& row : response.curves)
    for (double& value : row) value *= factor;
  return response;
}

Response parse_response_csv(std::string_view text, const std::string& name) {
  constexpr double lowest = 100, highest = 10'000;  // [nm] beyond which no air here has data
  const std::vector<CsvRow> rows = parse_csv(text, name, "wavelength [nm],first,second,third");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double>& r = rows[i].values;
    const auto refuse = [&](const std::string& expected) {
      throw InputError(name + ":" + std::to_string(rows[i].line) + ": wavelength " + number_text(r[0]) +
                       " nm: expected " + expected);
    };
    for (const double value : r)
      if (!std::isfinite(value)) refuse("finite numbers");
    if (!(r[0] >= lowest && r[0] <= highest) || r[0] != std::floor(r[0])) refuse("100 .. 10000 nm without a fraction");
    if (i > 0 && !(r[0] > rows[i - 1].values[0])) refuse("increasing wavelengths");
  }
  if (rows.size() < 2)
    throw InputError(name + ":" + std::to_string(rows[0].line) + ": expected two rows of numbers or more, got one");
  Response response;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const std::vector<double>&a = rows[i].values, &b = rows[i + 1].values;
    const int steps = int(std::lround(b[0] - a[0]));
    for (int k = 0; k < steps + (i + 2 == rows.size()); ++k) {
      const double t = double(k) / steps;
      response.wavelengths.push_back(a[0] + k);
      response.curves.push_back({a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]), a[3] + t * (b[3] - a[3])});
    }
  }
  return response;
}

}  // namespace airlight
