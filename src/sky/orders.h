// Sums a model's orders of scattering (Model::orders).
#pragma once
#include <vector>

#include "sky/binder.h"

namespace airlight {

/// `source` and `ground_light` of all orders: summed until the next adds less than a thousandth, then closed as a geometric series.
/// @throws WorkError where the sum does not settle
std::vector<Table> sum_orders(const Binder& binder, const OrderPasses& passes);

}  // namespace airlight
