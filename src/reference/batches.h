// Random estimates in independent batches: means, honest errors, and when to stop.
#pragma once
#include <functional>
#include <span>

#include "reference/monte_carlo.h"

namespace airlight::reference {

/// Makes the estimates of batches `first` to `last`: for each a row of orders by wavelengths, order slowest.
using MakeBatches = std::function<void(long first, long last, std::span<double> rows)>;

/// Runs batches on all threads until the budget is spent. Results do not depend on the number of threads, nor, for
/// budgets without `seconds`, on the machine's speed.
/// @param batch_walks  in each batch; they may depend on each other (stratification)
/// @param known  light that is known without error and counts in `target_error`, one value for each wavelength
RandomLight run_batches(const Budget& budget, int batch_walks, std::size_t orders, std::span<const double> known,
                        const MakeBatches& make);

}  // namespace airlight::reference
