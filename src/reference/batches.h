// Random estimates in independent batches: means, honest errors, and when to stop.
#pragma once
#include <functional>
#include <span>

#include "reference/monte_carlo.h"

namespace airlight::reference {

inline constexpr int batch_size = 32;  ///< walks; inside a batch they may depend on each other (stratification)

/// Makes the estimates of batches `first` to `last`: for each a row of orders by wavelengths, order slowest.
using MakeBatches = std::function<void(long first, long last, std::span<double> rows)>;

/// Runs batches on all threads until the budget is spent. Results do not depend on the number of threads, nor, for
/// budgets without `seconds`, on the machine's speed.
/// @param known  light that is known without error and counts in `target_error`, one value for each wavelength
RandomLight run_batches(const Budget& budget, std::size_t orders, std::span<const double> known,
                        const MakeBatches& make);

}  // namespace airlight::reference
