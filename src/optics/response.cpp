#include "optics/response.h"

#include <cmath>
#include <cstdio>
#include <sstream>

#include "airlight/error.h"

namespace airlight {

Response Response::scaled(double factor) const {
  Response response = *this;
  for (Xyz& row : response.curves)
    for (double& value : row) value *= factor;
  return response;
}

Response parse_response_csv(std::string_view text, const std::string& name) {
  constexpr double lowest = 100, highest = 10'000;  // [nm] beyond which no air here has data
  std::istringstream csv{std::string(text)};
  std::string line;
  std::vector<std::array<double, 4>> rows;
  for (int number = 1; std::getline(csv, line); ++number) {
    if (number == 1 || line.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::array<double, 4> r{};
    const auto refuse = [&](const char* expected) {
      throw InputError(name + ":" + std::to_string(number) + ": \"" + line.substr(0, 60) + "\": expected " + expected);
    };
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &r[0], &r[1], &r[2], &r[3]) != 4)
      refuse("\"wavelength [nm],first,second,third\"");
    for (const double value : r)
      if (!std::isfinite(value)) refuse("finite numbers");
    if (!(r[0] >= lowest && r[0] <= highest) || r[0] != std::floor(r[0]))
      refuse("a wavelength of 100 .. 10000 nm without a fraction");
    if (!rows.empty() && !(r[0] > rows.back()[0])) refuse("increasing wavelengths");
    rows.push_back(r);
  }
  if (rows.size() < 2) throw InputError(name + ": expected a heading and two lines of numbers or more");
  Response response;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const auto &a = rows[i], &b = rows[i + 1];
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
