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
  Answer answer;
};

void answer_together(Answerers& answerers, std::span<Job* const> group) {
  std::vector<Ray> rays;
  for (const Job* job : group) rays.push_back(job->request.ray);
  std::vector<Answer> answers = answerers.answer(group.front()->request.topic, rays);
  for (std::size_t i = 0; i < group.size(); ++i) {
    group[i]->answer = std::move(answers[i]);
    for (const double value : group[i]->answer.value)
      if (!std::isfinite(value)) group[i]->request.error = "the model's answer is not a finite number";
  }
}

/// Answers jobs of one topic. When one of them is out of range, halves the group until that one stands alone with its
/// error.
void answer_group(Answerers& answerers, std::span<Job* const> group) {
  check_interrupt();
  try {
    answer_together(answerers, group);
  } catch (const InputError& error) {
    if (group.size() == 1) {
      group.front()->request.error = error.what();
      return;
    }
    answer_group(answerers, group.first(group.size() / 2));
    answer_group(answerers, group.subspan(group.size() / 2));
  } catch (const WorkError& error) {
    for (Job* job : group) job->request.error = error.what();
  }
}

}  // namespace

int answer_batch(const std::string& input, const std::string& output, Answerers& answerers, const Topic& otherwise) {
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
    for (const auto& [topic, group] : topics) answer_group(answerers, group);

    std::vector<std::string> texts;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const auto& [request, answer] = jobs[i];
      all_answered = all_answered && request.error.empty();
      nlohmann::ordered_json line{{"id", request.id}, {"value", answer.value}};
      line.update(answer.more);
      texts.push_back(
          to_line(request.error.empty()
                      ? line
                      : error_answer(request.id, fmt::format("{}:{}: {}", name, lines[i].number, request.error))));
    }
    return texts;
  };
  answer_lines(input, output, "probe", answer_chunk);
  return all_answered ? ok : failed;
}

}  // namespace airlight::cli
