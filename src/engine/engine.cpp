#include "airlight/engine.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <chrono>
#include <cstdio>

#include "airlight/error.h"
#include "engine/cpu/cpu_engine.h"
#include "engine/kernel_index.h"
#include "engine/source_version.h"
#include "engine/stage.h"
#include "engine/table_file.h"
#ifdef AIRLIGHT_HAS_GL
#include "engine/gl/gl_engine.h"
#endif

namespace airlight {
namespace {

// Content hash of 64-bit words: multiply and fold, finished as in MurmurHash3. Not cryptographic: it tells results apart.
class Hash {
 public:
  void add(std::uint64_t word) {
    word *= 0x87c37b91114253d5u;
    word = std::rotl(word, 31) * 0x4cf5ad432745937fu;
    state_ = std::rotl(state_ ^ word, 27) * 5 + 0x52dce729;
  }
  void add(std::span<const double> numbers) {
    add(numbers.size());
    for (double v : numbers) add(std::bit_cast<std::uint64_t>(v));
  }
  void add(std::string_view text) {
    add(text.size());
    for (char c : text) add(static_cast<unsigned char>(c));
  }
  void add(Shape s) {
    add(std::uint64_t(s.width));
    add(std::uint64_t(s.height));
    add(std::uint64_t(s.depth));
  }
  std::uint64_t value() const {
    std::uint64_t h = state_;
    h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdu;
    h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53u;
    return h ^ (h >> 33);
  }

 private:
  std::uint64_t state_ = 0x9e3779b97f4a7c15u;
};

std::uint64_t key_of(std::string_view name, Shape shape, std::span<const double> parameters,
                     std::span<const Table> inputs) {
  Hash hash;
  hash.add(name);
  hash.add(shape);
  hash.add(parameters);
  for (const Table& t : inputs) hash.add(t.hash);
  return hash.value();
}

std::uint64_t numbered(std::uint64_t key, std::size_t i) {
  Hash hash;
  hash.add(key);
  hash.add(i);
  return hash.value();
}

TableFile table_file(const std::string& folder, std::string_view what, std::string_view engine, std::uint64_t key) {
  Hash hash;
  hash.add(key);
  hash.add(source_version());
  hash.add(engine);
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash.value()));
  return {std::filesystem::path(folder) / (std::string(what) + '-' + digits + ".tables"), hash.value(),
          engine == "double" ? 8 : 4};
}

// Tables of a moving sun come and go: what was not used for longest goes first. 512 MB of float texels: the tables of 40
// wavelengths for dozens of observers.
constexpr std::size_t kept_limit = 32u << 20;

}  // namespace

Table Engine::upload(Shape shape, std::span<const double> rgba) {
  assert(rgba.size() == 4 * shape.texels());
  Hash hash;
  hash.add("upload");
  hash.add(shape);
  hash.add(rgba);
  if (const auto* kept = find_kept(hash.value())) return kept->front();
  Table table{shape, hash.value(), make_table(shape, rgba)};
  keep(hash.value(), {table});
  return table;
}

Table Engine::lend(Shape shape, std::span<const double> rgba) {
  assert(rgba.size() == 4 * shape.texels());
  return {shape, ++clock_, make_table(shape, rgba)};
}

void Engine::keep(std::uint64_t key, std::vector<Table> tables) {
  for (const Table& t : tables) kept_texels_ += t.shape.texels();
  while (kept_texels_ > kept_limit && !kept_.empty()) {
    const auto oldest = std::min_element(kept_.begin(), kept_.end(),
                                         [](const auto& a, const auto& b) { return a.second.used < b.second.used; });
    for (const Table& t : oldest->second.tables) kept_texels_ -= t.shape.texels();
    kept_.erase(oldest);
  }
  kept_[key] = {std::move(tables), ++clock_};
}

const std::vector<Table>* Engine::find_kept(std::uint64_t key) {
  const auto found = kept_.find(key);
  if (found == kept_.end()) return nullptr;
  found->second.used = ++clock_;
  return &found->second.tables;
}

void Engine::keep_on_disk(std::string folder, std::function<void(const std::string&)> message) {
  folder_ = std::move(folder);
  message_ = std::move(message);
}

void Engine::watch(std::function<void(double)> watch) { watch_ = std::move(watch); }

std::vector<std::shared_ptr<void>> Engine::run_pass(const PassInfo& pass, std::span<const double> parameters,
                                                    std::span<const Table> inputs, Shape shape) {
  assert(inputs.size() == pass.tables.size());
  std::vector<std::shared_ptr<void>> outputs;
  for (std::size_t i = 0; i < pass.outputs.size(); ++i) outputs.push_back(make_empty(shape));
  const Stage own(*this, 0.0, 1.0);
  const int all = shape.height * shape.depth;
  // Rows at a time: as many as take about a tenth of a second, so that whoever watches can show progress and stop.
  using Clock = std::chrono::steady_clock;
  constexpr auto patience = std::chrono::milliseconds(100);
  int rows = watch_ ? std::max(1, (1 << 14) / shape.width) : all;
  for (int begin = 0, end = 0; begin < all; begin = end) {
    own.tell();
    const auto started = Clock::now();
    end = std::min(all, begin + rows);
    run_rows(pass, parameters, inputs, shape, begin, end, outputs);
    const auto took = Clock::now() - started;
    if (took > patience) rows = std::max(1, rows / 2);
    if (took < patience / 3) rows = std::min(all, 2 * rows);
  }
  return outputs;
}

std::vector<Table> Engine::make_once(std::string_view what, std::span<const double> parameters,
                                     std::span<const Table> inputs, const std::function<std::vector<Table>()>& make) {
  const std::uint64_t key = key_of(what, {}, parameters, inputs);
  if (const auto* kept = find_kept(key)) return *kept;
  std::vector<Table> tables;
  if (folder_.empty()) {
    tables = make();
  } else {
    const TableFile file = table_file(folder_, what, name(), key);
    std::string trouble;
    if (const auto stored = file.read(trouble)) {
      for (const TableFile::Values& t : *stored) tables.push_back({t.shape, 0, make_table(t.shape, t.rgba)});
    } else {
      if (!trouble.empty() && message_) message_(trouble);
      tables = make();
      std::vector<TableFile::Values> values;
      for (const Table& t : tables) {
        values.push_back({t.shape, std::vector<double>(4 * t.shape.texels())});
        read(t, values.back().rgba);
      }
      trouble = file.write(values);
      if (!trouble.empty() && message_) message_(trouble);
    }
  }
  for (std::size_t i = 0; i < tables.size(); ++i) tables[i].hash = numbered(key, i);
  keep(key, tables);
  return tables;
}

std::vector<Table> Engine::run(const PassInfo& pass, std::span<const double> parameters, std::span<const Table> inputs,
                               Shape shape) {
  const std::uint64_t key = key_of(pass.name, shape, parameters, inputs);
  if (const auto* kept = find_kept(key)) return *kept;
  std::vector<Table> tables;
  for (auto& storage : run_pass(pass, parameters, inputs, shape))
    tables.push_back({shape, numbered(key, tables.size()), std::move(storage)});
  const auto count = runs_.find(pass.name);
  if (count == runs_.end())
    runs_.emplace(pass.name, 1);
  else
    ++count->second;
  keep(key, tables);
  return tables;
}

std::vector<Table> Engine::run_once(const PassInfo& pass, std::span<const double> parameters,
                                    std::span<const Table> inputs, Shape shape) {
  std::vector<Table> tables;
  for (auto& storage : run_pass(pass, parameters, inputs, shape))
    tables.push_back({shape, ++clock_, std::move(storage)});
  return tables;
}

void Engine::draw(const PassInfo& pass, std::span<const double> parameters, std::span<const Table> inputs, Shape shape,
                  int begin, int end, std::span<float> rgba) {
  assert(inputs.size() == pass.tables.size() && rgba.size() == 4 * std::size_t(end - begin) * std::size_t(shape.width));
  draw_rows(pass, parameters, inputs, shape, begin, end, rgba);
}

long Engine::passes_run(std::string_view pass) const {
  const auto found = runs_.find(pass);
  return found == runs_.end() ? 0 : found->second;
}

std::shared_ptr<Engine> make_engine(std::string_view name) {
  if (name == "double") return make_cpu_engine("double");
  if (name == "simd") return make_cpu_engine("");
  if (name == "gl") {
#ifdef AIRLIGHT_HAS_GL
    return make_gl_engine();
#else
    throw WorkError("engine gl: this build of airlight has no OpenGL (AIRLIGHT_WITH_GL=OFF)");
#endif
  }
  throw InputError("unknown engine '" + std::string(name) + "': expected double, simd or gl");
}

}  // namespace airlight
