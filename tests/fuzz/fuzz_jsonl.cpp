// Any bytes are answered with a request or an error, never with an exception, and the answer is one line of JSON.
#include <cstdint>
#include <cstdlib>

#include "batch_plane_parallel.h"
#include "batch_request.h"
#include "eval_request.h"
#include "json_line.h"

using namespace airlight::cli;

namespace {

void expect(bool holds) {
  if (!holds) std::abort();
}

template <typename Request>
void check(const Request& request) {
  const std::string line = to_line(error_answer(request.id, request.error));
  expect(line.find('\n') == line.size() - 1);
  expect(nlohmann::json::parse(line)["id"] == request.id || request.id.is_string());  // broken UTF-8 is replaced
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const BatchRequest batch = parse_batch_request(text, {"earth", "skyview", nullptr, {}, 0});
  check(batch);
  expect(!batch.error.empty() || batch.topic.asked);
  if (batch.error.empty() && !batch.topic.own.empty()) parse_plane_parallel(batch.topic.own);
  using Kind = airlight::ParameterInfo::Kind;
  static const airlight::Adapter adapters[] = {
      {.name = "fuzz.adapter",
       .text = "",
       .inputs = {{.name = "number", .low = 0, .high = 1},
                  {.name = "colour", .kind = Kind::colour, .low = 0, .high = 1},
                  {.name = "word", .kind = Kind::word, .words = {"one", "two"}, .otherwise = "one"}},
       .outputs = "",
       .unit = "",
       .call = {}}};
  const EvalRequest eval = parse_eval_request(text, adapters);
  check(eval);
  expect(!eval.error.empty() || eval.function || eval.adapter);
  return 0;
}
