#include "sky/orders.h"

#include <algorithm>
#include <cmath>

#include "airlight/error.h"
#include "engine/stage.h"

namespace airlight {
namespace {

// Each order of the thickest air that is let in, over snow, is at most nine tenths of the one before.
constexpr int most_orders = 100;
// Done when an order adds less than a thousandth anywhere, of places above a millionth of the brightest under the same Sun.
constexpr double small_part = 1e-3, dark = 1e-6;
// Under a Sun whose brightest is less than this, of sunlight, it is night (starlight is 1e-9). A part `dark` of it is far above the 1e-30
// that passes keep for no light at all: of that, each order adds as much as the one before, and is no sign that the sum has not settled.
constexpr double night = 1e-20;

std::vector<double> texels(const Binder& binder, const Table& table) {
  std::vector<double> values(4 * table.shape.texels());
  binder.engine().read(table, values);
  return values;
}

/// The largest part that an order has of the sum; of values that matter for their Sun (a column) and wavelength.
double largest_part(const std::vector<double>& order, const std::vector<double>& sum, Shape shape) {
  const std::size_t row = 4 * std::size_t(shape.width);
  std::vector<double> brightest(row, night);
  for (std::size_t i = 0; i < sum.size(); ++i) brightest[i % row] = std::max(brightest[i % row], sum[i]);
  double largest = 0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    if (sum[i] > dark * brightest[i % row]) largest = std::max(largest, order[i] / sum[i]);
  }
  return largest;
}

/// How much of the sum is done after so many orders, if each order's part goes on to shrink as it did last.
double share_done(int orders, double part, double part_before) {
  const double shrinks = std::clamp(part / part_before, 0.05, 0.95);
  const double left = std::max(std::log(small_part / part) / std::log(shrinks), 0.0);
  return orders / (orders + left + 1);  // the last scattering, of the sum, costs half an order
}

}  // namespace

std::vector<Table> sum_orders(const Binder& binder, const OrderPasses& passes) {
  Binder b = binder;
  Table light = b.run_once(passes.first_light)[0], sum = light;
  const auto scatter = [&](const Table& from, const TablePass& source) {
    b.set("light", from);
    return std::vector<Table>{b.run_once(source)[0], b.run_once(passes.ground_light)[0]};
  };
  double done = 0, part_before = 1;
  for (int order = 2;; ++order) {
    const Stage stage(b.engine(), done, 1.0);
    if (order > most_orders)
      throw WorkError("orders of scattering: the sum has not settled after " + std::to_string(most_orders));
    const std::vector<Table> made = scatter(light, passes.next_source);
    b.set("source", made[0]);
    b.set("ground_light", made[1]);
    const Table next = b.run_once(passes.next_light)[0];
    b.set("light", next);
    b.set("others", sum);
    sum = b.run_once(passes.sum, sum.shape)[0];
    const double part = largest_part(texels(b, next), texels(b, sum), sum.shape);
    if (part < small_part) {
      b.set("light_sum", sum);
      b.set("light_before", light);
      sum = b.run_once(passes.closed, sum.shape)[0];
      return scatter(sum, passes.source);
    }
    light = next;
    done = share_done(order, part, part_before);
    part_before = part;
  }
}

}  // namespace airlight
