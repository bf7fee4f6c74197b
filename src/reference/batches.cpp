#include "reference/batches.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "airlight/error.h"

namespace airlight::reference {
namespace {

void check(const Budget& budget) {
  const auto refuse = [](const std::string& key, double value, const std::string& range) {
    throw InputError("budget: " + key + " is " + std::to_string(value) + "; legal: " + range);
  };
  if (budget.walks < 0) refuse("walks", double(budget.walks), "1 or more, or 0 (no limit)");
  if (!(budget.target_error >= 0)) refuse("target_error", budget.target_error, "above 0, or 0 (no limit)");
  if (!(budget.seconds >= 0)) refuse("seconds", budget.seconds, "above 0, or 0 (no limit)");
  if (budget.walks == 0 && budget.target_error == 0 && budget.seconds == 0)
    throw InputError("budget: one of walks, target_error and seconds shall be above 0");
}

/// Mean and variance of a stream of numbers (Welford 1962).
struct Moments {
  double mean = 0, squares = 0;
  void add(double value, double count) {  // count: of values, this one included
    const double apart = value - mean;
    mean += apart / count;
    squares += apart * (value - mean);
  }
  double standard_error(double count) const { return count > 1 ? std::sqrt(squares / (count - 1) / count) : 0; }
};

Estimate estimate(std::span<const Moments> moments, double count) {
  Estimate result;
  for (const Moments& m : moments) {
    result.mean.push_back(m.mean);
    result.standard_error.push_back(m.standard_error(count));
  }
  return result;
}

/// Batches still to be made for the error asked for; a guess that is made again after each wave.
double missing(std::span<const Moments> total, std::span<const double> known, double done, double target) {
  double most = 0;
  for (std::size_t w = 0; w < total.size(); ++w) {
    const double error = total[w].standard_error(done), allowed = target * (total[w].mean + known[w]);
    if (error > allowed) most = std::max(most, done * (error / allowed) * (error / allowed) - done);
  }
  return most;
}

}  // namespace

RandomLight run_batches(const Budget& budget, int batch_walks, std::size_t orders, std::span<const double> known,
                        const MakeBatches& make) {
  check(budget);
  // A standard error from fewer batches would itself be uncertain by more than a tenth.
  constexpr long first_wave = 64, largest_wave = 1024;
  const std::size_t width = known.size(), row = orders * width;
  std::vector<Moments> by_order(row), total(width);
  std::vector<double> rows;
  const auto started = std::chrono::steady_clock::now();
  long done = 0;
  while (true) {
    double wave = double(done == 0 ? first_wave : std::min(done, largest_wave));
    if (budget.walks > 0) wave = std::min(wave, std::ceil(double(budget.walks) / batch_walks) - double(done));
    if (budget.target_error > 0 && done > 0)
      wave = std::min(wave, std::ceil(missing(total, known, double(done), budget.target_error)));
    if (budget.seconds > 0 && done > 0) {
      const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
      wave = std::min(wave, std::floor((budget.seconds - spent) / spent * double(done)));
    }
    if (!(wave >= 1)) break;
    if (budget.between) budget.between();
    const long count = long(wave);
    rows.assign(std::size_t(count) * row, 0.0);
    tbb::parallel_for(tbb::blocked_range<long>(0, count, 4), [&](const tbb::blocked_range<long>& range) {
      make(done + range.begin(), done + range.end(),
           std::span(rows).subspan(range.begin() * row, (range.end() - range.begin()) * row));
    });
    for (long i = 0; i < count; ++i) {
      const double number = double(++done);
      const std::span<const double> batch = std::span(rows).subspan(i * row, row);
      for (std::size_t k = 0; k < row; ++k) by_order[k].add(batch[k], number);
      for (std::size_t w = 0; w < width; ++w) {
        double sum = 0;
        for (std::size_t order = 0; order < orders; ++order) sum += batch[order * width + w];
        total[w].add(sum, number);
      }
    }
  }
  RandomLight light{estimate(total, double(done)), {}, done * batch_walks};
  for (std::size_t order = 0; order < orders; ++order)
    light.orders.push_back(estimate(std::span(by_order).subspan(order * width, width), double(done)));
  return light;
}

}  // namespace airlight::reference
