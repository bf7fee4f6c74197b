#include "batch.h"

#include <fmt/core.h>

#include <cmath>

#include "airlight/error.h"
#include "batch_request.h"
#include "commands.h"
#include "interrupt.h"
#include "json_line.h"
#include "jsonl.h"

namespace airlight::cli {
namespace {

struct Job {
  BatchRequest request;
  std::vector<double> values;
};

void answer_together(Skies& skies, std::span<Job* const> group) {
  const Topic& topic = group.front()->request.topic;
  std::vector<Ray> rays;
  for (const Job* job : group) rays.push_back(job->request.ray);
  const auto all =
      answer(skies.sky(topic.atmosphere, topic.model), *topic.asked, rays, topic.wavelengths, topic.max_order);
  const std::size_t width = all.size() / group.size();
  for (std::size_t i = 0; i < group.size(); ++i) {
    group[i]->values.assign(all.begin() + i * width, all.begin() + (i + 1) * width);
    for (const double value : group[i]->values)
      if (!std::isfinite(value)) group[i]->request.error = "the model's answer is not a finite number";
  }
}

/// Answers jobs of one topic. When one of them is out of range, halves the group until that one stands alone with its
/// error.
void answer_group(Skies& skies, std::span<Job* const> group) {
  check_interrupt();
  try {
    answer_together(skies, group);
  } catch (const InputError& error) {
    if (group.size() == 1) {
      group.front()->request.error = error.what();
      return;
    }
    answer_group(skies, group.first(group.size() / 2));
    answer_group(skies, group.subspan(group.size() / 2));
  } catch (const WorkError& error) {
    for (Job* job : group) job->request.error = error.what();
  }
}

}  // namespace

int answer_batch(const std::string& input, const std::string& output, Skies& skies, const Topic& otherwise) {
  bool all_answered = true;
  const auto answer_chunk = [&](const std::string& name, std::span<const LineReader::Line> lines) {
    std::vector<Job> jobs;
    for (const LineReader::Line& line : lines) {
      jobs.push_back({parse_batch_request(line.text, otherwise), {}});
      if (line.too_long) jobs.back().request.error = fmt::format("longer than {} bytes", LineReader::longest);
    }
    std::map<Topic, std::vector<Job*>> topics;
    for (Job& job : jobs)
      if (job.request.error.empty()) topics[job.request.topic].push_back(&job);
    for (const auto& [topic, group] : topics) answer_group(skies, group);

    std::vector<std::string> texts;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const auto& [request, values] = jobs[i];
      all_answered = all_answered && request.error.empty();
      texts.push_back(
          to_line(request.error.empty()
                      ? nlohmann::ordered_json{{"id", request.id}, {"value", values}}
                      : error_answer(request.id, fmt::format("{}:{}: {}", name, lines[i].number, request.error))));
    }
    return texts;
  };
  answer_lines(input, output, "probe", answer_chunk);
  return all_answered ? ok : failed;
}

}  // namespace airlight::cli
