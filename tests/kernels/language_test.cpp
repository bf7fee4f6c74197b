// The kernel language itself means the same on every target: the second suite of tests/kernels/glsl/language.
#include <gtest/gtest.h>

#include "arguments.h"
#include "engines.h"

namespace airlight::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

const FunctionInfo& function(std::string_view name) {
  return *std::ranges::find(language_functions(), name, &FunctionInfo::kernel_name);
}
const PassInfo& pass(std::string_view name) {
  return *std::ranges::find(language_passes(), name, &PassInfo::kernel_name);
}

using Columns = std::vector<std::vector<double>>;  // one a component

Columns evaluate(Engine& engine, std::string_view name, const std::vector<double>& uniforms, const Columns& varying) {
  const FunctionInfo& f = function(name);
  const int count = int(varying.front().size());
  std::vector<double> flat, results(std::size_t(result_count(f)) * count);
  for (const auto& column : varying) flat.insert(flat.end(), column.begin(), column.end());
  engine.evaluate(f, uniforms, flat, count, results);
  Columns columns;
  for (auto at = results.begin(); at != results.end(); at += count) columns.emplace_back(at, at + count);
  return columns;
}

/// Values that every pair of is tried.
const std::vector<double> numbers = {-inf, -3e38, -2, -1, -0.25, 0, 0.25, 1, 1.5, 2, 3e38, inf};

Columns pairs(const std::vector<double>& first, const std::vector<double>& second) {
  Columns c(2);
  for (double a : first) {
    for (double b : second) {
      c[0].push_back(a);
      c[1].push_back(b);
    }
  }
  return c;
}

class Language : public testing::TestWithParam<std::string> {};

TEST_P(Language, max_and_min_give_the_bound_for_nan) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  std::vector<double> suspects = numbers;
  suspects.push_back(nan);
  const Columns in = pairs(suspects, numbers);
  const auto larger = evaluate(engine, "language_max", {}, in)[0],
             smaller = evaluate(engine, "language_min", {}, in)[0];
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const double a = static_cast<float>(in[0][i]), b = static_cast<float>(in[1][i]);
    EXPECT_EQ(static_cast<float>(larger[i]), static_cast<float>(a > b ? a : b)) << "max(" << a << ", " << b << ")";
    EXPECT_EQ(static_cast<float>(smaller[i]), static_cast<float>(a < b ? a : b)) << "min(" << a << ", " << b << ")";
  }
}

TEST_P(Language, clamp_gives_the_lower_bound_for_nan) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  const std::vector<double> x = {nan, -inf, -2, -0.5, 0, 0.25, 2, inf};
  const std::vector<double> expected = {-1, -1, -1, -0.5, 0, 0.25, 0.5, 0.5};
  EXPECT_EQ(evaluate(engine, "language_clamp", {}, {x, std::vector<double>(8, -1.0), std::vector<double>(8, 0.5)})[0],
            expected);
  // max(x, -1/2) + min(x, 1/2) + clamp(x, -1/2, 1/2), each component on its own
  const std::vector<double> sums = {-0.5, -inf, -3, -1.5, 0, 0.75, 3, inf};
  const std::vector<double> of_nan = {-0.5 + 0.5 - 0.5};
  for (int c = 0; c < 4; ++c) {
    Columns in(5, std::vector<double>(8, 0.0));
    in[c] = x;
    in[4].assign(8, 0.5);
    const auto got = evaluate(engine, "language_bounds4", {}, in);
    EXPECT_EQ(got[c][0], of_nan[0]) << "component " << c;
    for (int i = 1; i < 8; ++i) EXPECT_EQ(got[c][i], sums[i]) << "component " << c << ", x = " << x[i];
    EXPECT_EQ(got[(c + 1) % 4], std::vector<double>(8, 0.0)) << "component " << c << " leaks";
  }
}

TEST_P(Language, comparisons_with_nan_are_false_and_their_negation_true) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  std::vector<double> values = numbers;
  values.push_back(nan);
  const Columns in = pairs(values, values);
  const auto holds = evaluate(engine, "language_compare", {}, in)[0],
             alike = evaluate(engine, "language_alike", {}, in)[0];
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const double a = static_cast<float>(in[0][i]), b = static_cast<float>(in[1][i]);
    EXPECT_EQ(holds[i], (a < b) + 2 * (a <= b) + 4 * (a > b) + 8 * (a >= b)) << a << " and " << b;
    EXPECT_EQ(alike[i], (a > 0) == (b > 0)) << a << " and " << b;
  }
}

TEST_P(Language, select_chooses_lane_by_lane_and_any_changes_nothing) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  Columns in(9, std::vector<double>(67));
  for (int i = 0; i < 67; ++i) {
    in[0][i] = i % 3 == 0;
    for (int c = 0; c < 4; ++c) {
      in[1 + c][i] = i + 100 * c;
      // What is not chosen may be anything.
      in[5 + c][i] = i % 3 == 0 ? nan : -i;
    }
  }
  const auto got = evaluate(engine, "language_select", {}, in);
  for (int i = 0; i < 67; ++i) {
    for (int c = 0; c < 4; ++c) EXPECT_EQ(got[c][i], i % 3 == 0 ? i + 100 * c : -i);
  }
  std::vector<double> x(67, 0.5), above(67, 0.0);
  x[40] = 1.75;  // one lane of many
  above[40] = 0.75;
  EXPECT_EQ(evaluate(engine, "language_any", {}, {x})[0], above);
}

TEST_P(Language, numbers_split_into_mantissa_and_exponent) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  const std::vector<double> x = {1, 1.5, 2, 3, 0.75, 0.5, 1.1754943508222875e-38, 0x1.8p100, 0x1.fffffep0, 1e-30};
  const auto got = evaluate(engine, "language_parts", {}, {x});
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double v = static_cast<float>(x[i]);
    int exponent = 0;
    EXPECT_EQ(static_cast<float>(got[1][i]), static_cast<float>(2 * std::frexp(v, &exponent))) << v;
    EXPECT_EQ(got[0][i], exponent - 1) << v;
    EXPECT_EQ(static_cast<float>(got[2][i]), static_cast<float>(std::floor(v))) << v;
  }
}

TEST_P(Language, uniform_numbers_of_every_kind_arrive) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  const std::vector<double> uniforms = {3, 0.5, 10, 2, 30, 12};  // count, stride, four weights
  // weights.w + weights.y * (3 x + (0 + 1 + 2) * stride)
  EXPECT_EQ(evaluate(engine, "language_sum", uniforms, {{0, 1, -2}})[0], (std::vector<double>{12 + 3, 12 + 9, 12 - 9}));
}

// Mesa's software driver leaves a shader's loops, without a word, after 65535 turns of all of them together: so no pass may need
// more for one texel.
TEST_P(Language, loops_turn_sixty_thousand_times_a_texel) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  EXPECT_EQ(evaluate(engine, "language_turns", {100, 600}, {{0, 1, 0.5}})[0], (std::vector<double>(3, 60000)));
}

TEST_P(Language, several_results_arrive_in_order) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  const Columns expected = {{3, -1}, {2, -2}, {1, 1}, {3, -1}, {1, 0}};
  EXPECT_EQ(evaluate(engine, "language_outs", {}, {{1, 1}, {2, -2}}), expected);
}

TEST_P(Language, many_arguments_are_evaluated_at_once) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  constexpr int count = 140001;  // more than one texture of arguments
  Columns in(2, std::vector<double>(count));
  for (int i = 0; i < count; ++i) {
    in[0][i] = i;
    in[1][i] = 70000;
  }
  const auto got = evaluate(engine, "language_max", {}, in)[0];
  int wrong = 0;
  for (int i = 0; i < count; ++i) wrong += got[i] != std::max(i, 70000);
  EXPECT_EQ(wrong, 0);
}

// ---- passes ----

std::vector<double> read(Engine& engine, const Table& table) {
  std::vector<double> rgba(4 * table.shape.texels());
  engine.read(table, rgba);
  return rgba;
}

struct Grid {
  Shape shape;
  std::vector<double> rgba;
  /// A texel's channel, places beyond the edge being those of the edge.
  double at(double x, double y, double z, int channel) const {
    const auto inside = [](double v, int size) { return std::size_t(std::clamp(v, 0.0, double(size - 1))); };
    return rgba[4 * ((inside(z, shape.depth) * shape.height + inside(y, shape.height)) * shape.width +
                     inside(x, shape.width)) +
                channel];
  }
  /// Linear between texel centres, whose coordinates are whole here. NaN counts as the first.
  double linear(double x, double y, double z, int channel) const {
    const auto place = [](double v, int size) { return std::isnan(v) ? 0.0 : std::clamp(v, 0.0, double(size - 1)); };
    x = place(x, shape.width), y = place(y, shape.height), z = place(z, shape.depth);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const double i = std::floor(x) + (corner & 1), j = std::floor(y) + (corner >> 1 & 1),
                   k = std::floor(z) + (corner >> 2);
      const double weight = std::max(0.0, 1 - std::fabs(x - i)) * std::max(0.0, 1 - std::fabs(y - j)) *
                            std::max(0.0, 1 - std::fabs(z - k));
      if (weight > 0) sum += weight * at(i, j, k, channel);
    }
    return sum;
  }
};

Grid random_grid(Shape shape, Random& random) {
  Grid grid{shape, std::vector<double>(4 * shape.texels())};
  for (double& v : grid.rgba) v = static_cast<float>(random.unit() - 0.5);
  return grid;
}

/// Coordinates from -0.2 to 1.2 times `size` (1 where a pass takes them in 0..1), the ends of 0..1, and strange ones.
Grid random_places(double width, double height, double depth, Random& random) {
  Grid places{{37, 11, 1}, {}};
  const double strange[] = {nan, inf, -inf, 3e38, -3e38, 0, -0.0, 1, 1e-40};
  for (std::size_t i = 0; i < places.shape.texels(); ++i) {
    double at[4] = {width, height, depth, 1};
    for (double& v : at) v = static_cast<float>(v * (random.unit() * 1.4 - 0.2));
    if (i < 27) at[i / 9] = strange[i % 9] == 1 ? std::array{width, height, depth}[i / 9] : strange[i % 9];
    if (i == 27) at[0] = at[1] = at[2] = nan;
    places.rgba.insert(places.rgba.end(), at, at + 4);
  }
  return places;
}

/// Calls expect(x, y, z of a place, channel) and compares.
template <class Expect>
void compare(const Grid& places, const std::vector<double>& got, double tolerance, const Expect& expect) {
  for (std::size_t i = 0; i < places.shape.texels(); ++i) {
    const double* p = &places.rgba[4 * i];
    for (int c = 0; c < 4; ++c)
      ASSERT_NEAR(got[4 * i + c], expect(p[0], p[1], p[2], c), tolerance)
          << "at " << p[0] << ", " << p[1] << ", " << p[2];
  }
}

const Shape odd_shapes[] = {{7, 5, 1}, {2, 2, 1}, {33, 17, 1}, {2, 9, 1}};
// Texels within 1/2; a coordinate in texels has an error of half an ulp of the table's size, 33 * 2^-24, times slopes of at most 1.
constexpr double rounding = 1e-5;

TEST_P(Language, fetch_takes_the_texel_at_a_whole_place) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  Random random;
  for (Shape shape : odd_shapes) {
    const Grid grid = random_grid(shape, random), places = random_places(shape.width, shape.height, 1, random);
    const Table inputs[] = {engine.upload(places.shape, places.rgba), engine.upload(shape, grid.rgba)};
    const auto whole = [](double v, int size) {
      return std::isnan(v) ? 0.0 : std::floor(std::clamp(v, 0.0, double(size - 1)));
    };
    compare(places, read(engine, engine.run(pass("language_fetch_pass"), {}, inputs, places.shape)[0]), 0,
            [&](double x, double y, double, int c) {
              return grid.at(whole(x, shape.width), whole(y, shape.height), 0, c);
            });
  }
}

TEST_P(Language, lookup_is_bilinear_between_texel_centres) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  Random random;
  for (Shape shape : odd_shapes) {
    const Grid grid = random_grid(shape, random), places = random_places(1, 1, 1, random);
    const Table inputs[] = {engine.upload(places.shape, places.rgba), engine.upload(shape, grid.rgba)};
    compare(places, read(engine, engine.run(pass("language_lookup2_pass"), {}, inputs, places.shape)[0]), rounding,
            [&](double x, double y, double, int c) {
              return grid.linear(x * shape.width - 0.5, y * shape.height - 0.5, 0, c);
            });
  }
}

TEST_P(Language, lookup_repeat_goes_on_where_the_table_began) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  Random random;
  for (Shape shape : odd_shapes) {
    const Grid grid = random_grid(shape, random);
    Grid places = random_places(1, 1, 1, random);
    const double edges[] = {0, 1, -1, 0.5 / shape.width, -1e-9, 1 - 0x1p-24, 4.25, -3.25};
    for (std::size_t i = 0; i < std::size(edges);
         ++i) {  // in place of the strange ones: of 3e38 nothing is left to repeat
      places.rgba[4 * i] = edges[i];
      places.rgba[4 * (i + 9) + 1] = edges[i];
    }
    for (double& v : places.rgba)
      if (!(std::fabs(v) < 10)) v = -0.125;
    const auto wrap = [](double v, int n) { return v - n * std::floor(v / n); };
    const auto texel = [&](double x, double y, int c) {
      return grid.at(wrap(x, shape.width), wrap(y, shape.height), 0, c);
    };
    const Table inputs[] = {engine.upload(places.shape, places.rgba), engine.upload(shape, grid.rgba)};
    // Places of up to 4.25 widths of 33 texels: ten times the rounding of one table.
    compare(places, read(engine, engine.run(pass("language_repeat_pass"), {}, inputs, places.shape)[0]), 10 * rounding,
            [&](double u, double v, double, int c) {
              const double x = u * shape.width - 0.5, y = v * shape.height - 0.5, i = std::floor(x), j = std::floor(y);
              return (1 - x + i) * ((1 - y + j) * texel(i, j, c) + (y - j) * texel(i, j + 1, c)) +
                     (x - i) * ((1 - y + j) * texel(i + 1, j, c) + (y - j) * texel(i + 1, j + 1, c));
            });
  }
}

TEST_P(Language, lookup_repeat_reads_inside_the_table_wherever_it_is_asked) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  Random random;
  for (Shape shape : odd_shapes) {
    const Grid grid = random_grid(shape, random), places = random_places(1e7, 1e7, 1, random);
    const Table inputs[] = {engine.upload(places.shape, places.rgba), engine.upload(shape, grid.rgba)};
    for (double v : read(engine, engine.run(pass("language_repeat_pass"), {}, inputs, places.shape)[0]))
      ASSERT_LE(std::fabs(v), 0.5 + rounding);  // between the texels' values
  }
}

TEST_P(Language, lookup_in_a_volume_is_trilinear) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  Random random;
  for (Shape shape : {Shape{5, 3, 7}, Shape{2, 2, 2}, Shape{9, 4, 3}}) {
    const Grid grid = random_grid(shape, random), places = random_places(1, 1, 1, random);
    const Table inputs[] = {engine.upload(places.shape, places.rgba), engine.upload(shape, grid.rgba)};
    compare(places, read(engine, engine.run(pass("language_lookup3_pass"), {}, inputs, places.shape)[0]), rounding,
            [&](double x, double y, double z, int c) {
              return grid.linear(x * shape.width - 0.5, y * shape.height - 0.5, z * shape.depth - 0.5, c);
            });
  }
}

TEST_P(Language, rows_are_linear_and_cells_keep_their_jumps) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  Random random;
  for (Shape shape : {Shape{6, 3, 1}, Shape{2, 4, 1}, Shape{34, 5, 1}}) {
    const int cells = shape.width / 2;
    const Grid grid = random_grid(shape, random), places = random_places(1, cells, 1, random);
    const Table inputs[] = {engine.upload(places.shape, places.rgba), engine.upload(shape, grid.rgba)};
    const auto got = engine.run(pass("language_rows_pass"), {}, inputs, places.shape);
    compare(places, read(engine, got[0]), rounding, [&](double u, double, double, int c) {
      return grid.linear(std::isnan(u) ? nan : std::clamp(u, 0.0, 1.0) * (shape.width - 1), 1, 0, c);
    });
    compare(places, read(engine, got[1]), rounding, [&](double, double x, double, int c) {
      x = std::isnan(x) ? 0 : std::clamp(x, 0.0, double(cells));
      const double cell = std::min(std::floor(x), cells - 1.0), t = x - cell;
      return (1 - t) * grid.at(2 * cell, 2, 0, c) + t * grid.at(2 * cell + 1, 2, 0, c);
    });
  }
}

TEST_P(Language, shared_texels_sizes_and_coordinates_arrive) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  Random random;
  const Grid grid = random_grid({7, 5, 1}, random);
  const Table input = engine.upload(grid.shape, grid.rgba);
  const Shape shape{13, 3, 1};
  const auto got = engine.run(pass("language_same_pass"), {}, {&input, 1}, shape);
  const auto texels = read(engine, got[0]), size = read(engine, got[1]);
  for (int y = 0; y < shape.height; ++y) {
    for (int x = 0; x < shape.width; ++x) {
      const std::size_t i = 4 * std::size_t(y * shape.width + x);
      for (int c = 0; c < 4; ++c) ASSERT_EQ(texels[i + c], grid.at(2, 1, 0, c));
      ASSERT_EQ(size[i], 7);
      ASSERT_EQ(size[i + 1], 5);
      ASSERT_NEAR(size[i + 2], (x + 0.5) / shape.width, 1e-7);  // an ulp of 1
      ASSERT_NEAR(size[i + 3], (y + 0.5) / shape.height, 1e-7);
    }
  }
}

TEST_P(Language, parameter_structs_arrive_in_order_and_four_outputs_leave) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  std::vector<double> parameters;
  for (int i = 0; i < 16; ++i) parameters.push_back(i + 0.5);
  const auto got = engine.run(pass("language_parameters_pass"), parameters, {}, {3, 2, 1});
  ASSERT_EQ(got.size(), 4u);
  for (int k = 0; k < 4; ++k) {
    const auto rgba = read(engine, got[k]);
    for (std::size_t i = 0; i < rgba.size(); ++i) ASSERT_EQ(rgba[i], 4 * k + double(i % 4) + 0.5) << "output " << k;
  }
}

TEST_P(Language, volumes_are_filled_slice_by_slice) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  const Shape shape{5, 3, 4};
  const auto got = engine.run(pass("language_volume_pass"), {}, {}, shape);
  const auto once = read(engine, got[0]), twice = read(engine, got[1]);
  std::size_t i = 0;
  for (int z = 0; z < shape.depth; ++z) {
    for (int y = 0; y < shape.height; ++y) {
      for (int x = 0; x < shape.width; ++x, i += 4) {
        const double expected[] = {(x + 0.5) / shape.width, (y + 0.5) / shape.height, (z + 0.5) / shape.depth, 1};
        for (int c = 0; c < 4; ++c) {
          ASSERT_NEAR(once[i + c], expected[c], 1e-7) << x << " " << y << " " << z;
          ASSERT_NEAR(twice[i + c], 2 * expected[c], 2e-7) << x << " " << y << " " << z;
        }
      }
    }
  }
}

// A picture drawn in strips is the picture drawn at once.
TEST_P(Language, strips_of_a_picture_make_up_the_whole) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  const Shape shape{19, 23, 1};
  std::vector<float> strips(4 * shape.texels());
  for (int begin = 0; begin < shape.height; begin += 5) {
    const int end = std::min(begin + 5, shape.height);
    engine.draw(
        pass("language_volume_pass"), {}, {}, shape, begin, end,
        std::span(strips).subspan(4 * std::size_t(begin) * shape.width, 4 * std::size_t(end - begin) * shape.width));
  }
  const auto whole = read(engine, engine.run(pass("language_volume_pass"), {}, {}, shape)[0]);
  for (std::size_t i = 0; i < whole.size(); ++i)
    ASSERT_EQ(strips[i], static_cast<float>(whole[i])) << "texel " << i / 4;
}

TEST_P(Language, tables_keep_what_was_uploaded) {
  AIRLIGHT_ENGINE_OR_SKIP(find_language_engine, GetParam());
  Random random;
  for (Shape shape : {Shape{7, 5, 1}, Shape{3, 4, 5}, Shape{1, 1, 1}}) {
    const Grid grid = random_grid(shape, random);
    EXPECT_EQ(read(engine, engine.upload(shape, grid.rgba)), grid.rgba);
  }
}

std::vector<std::string> all_engines() {
  auto names = engine_names();
  names.insert(names.begin(), "double");
  return names;
}
INSTANTIATE_TEST_SUITE_P(engines, Language, testing::ValuesIn(all_engines()),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace airlight::test
