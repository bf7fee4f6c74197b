#include "reference/random_picture.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <mutex>
#include <ostream>

#include "reference/monte_carlo.h"

namespace airlight::reference {

RandomPicture::RandomPicture(PictureQuestion question)
    : question_(std::move(question)), sums_(std::size_t(question_.width) * question_.height) {}

void RandomPicture::add_pass(const std::function<void(double)>& look) {
  // The first order is drawn too, apart from the walks: a quadrature for each pixel would cost more than they do.
  const MonteCarlo solver(question_.atmosphere, question_.wavelengths,
                          {.seed = std::uint64_t(passes_) + 1,
                           .kept_orders = 1,
                           .batch_walks = walks_in_a_pass,
                           .first_order_places = places_in_a_pass});
  std::vector<Sums> added(sums_.size());
  std::mutex mutex;
  int rows_done = 0;
  tbb::parallel_for(0, question_.height, [&](int y) {
    for (int x = 0; x < question_.width; ++x) {
      const std::optional<Ray> ray = question_.ray(x, y);
      if (!ray) continue;
      const RandomLight light = solver.radiance(*ray, {.walks = walks_in_a_pass});
      Sums& sums = added[std::size_t(y) * question_.width + x];
      for (std::size_t w = 0; w < question_.wavelengths.size(); ++w) {
        sums.x += question_.weights[w][0] * light.total.mean[w];
        sums.y += question_.weights[w][1] * light.total.mean[w];
        sums.z += question_.weights[w][2] * light.total.mean[w];
      }
      sums.squared_y = sums.y * sums.y;
    }
    const std::lock_guard lock(mutex);
    look(double(++rows_done) / question_.height);
  });
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    sums_[i].x += added[i].x;
    sums_[i].y += added[i].y;
    sums_[i].z += added[i].z;
    sums_[i].squared_y += added[i].squared_y;
  }
  ++passes_;
}

std::array<double, 3> RandomPicture::xyz(int x, int y) const {
  const Sums& sums = sums_[std::size_t(y) * question_.width + x];
  const double scale = passes_ > 0 ? 1.0 / passes_ : 0;
  return {sums.x * scale, sums.y * scale, sums.z * scale};
}

double RandomPicture::error(int x, int y) const {
  const Sums& sums = sums_[std::size_t(y) * question_.width + x];
  if (passes_ < 2 || sums.y <= 0) return 0;
  const double mean = sums.y / passes_, variance = std::max(sums.squared_y / passes_ - mean * mean, 0.0);
  return std::sqrt(variance / (passes_ - 1)) / mean;
}

double RandomPicture::median_error() const {
  constexpr int enough = 4;  // the spread of fewer passes says too little
  if (passes_ < enough) return std::numeric_limits<double>::infinity();
  std::vector<double> errors;
  for (int y = 0; y < question_.height; ++y)
    for (int x = 0; x < question_.width; ++x)
      if (sums_[std::size_t(y) * question_.width + x].y > 0) errors.push_back(error(x, y));
  if (errors.empty()) return 0;
  std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
  return errors[errors.size() / 2];
}

// As text that keeps every bit: the same on every machine, and readable.
void RandomPicture::save(std::ostream& out) const {
  out << std::hexfloat << "passes " << passes_ << " pixels " << sums_.size() << '\n';
  for (const Sums& sums : sums_) out << sums.x << ' ' << sums.y << ' ' << sums.z << ' ' << sums.squared_y << '\n';
  out << "end\n";
}

bool RandomPicture::load(std::istream& in) {
  // operator>> does not read what std::hexfloat writes; strtod does.
  std::string word, number;
  int passes = 0;
  std::size_t pixels = 0;
  if (!(in >> word >> passes) || word != "passes" || passes < 1) return false;
  if (!(in >> word >> pixels) || word != "pixels" || pixels != sums_.size()) return false;
  std::vector<Sums> sums(pixels);
  for (Sums& pixel : sums)
    for (double* const value : {&pixel.x, &pixel.y, &pixel.z, &pixel.squared_y}) {
      if (!(in >> number)) return false;
      char* end = nullptr;
      *value = std::strtod(number.c_str(), &end);
      if (*end != '\0' || !std::isfinite(*value)) return false;
    }
  if (!(in >> word) || word != "end") return false;
  sums_ = std::move(sums);
  passes_ = passes;
  return true;
}

}  // namespace airlight::reference
