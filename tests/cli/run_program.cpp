#include "run_program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>
#include <sstream>
#include <thread>

namespace airlight {

namespace {

std::string read_all(std::FILE* file) {
  std::string text;
  std::rewind(file);
  char block[4096];
  while (const std::size_t n = std::fread(block, 1, sizeof block, file)) text.append(block, n);
  return text;
}

}  // namespace

Program::Program(const Folder& folder, const std::vector<std::string>& arguments, const Setting& setting)
    : in_(std::tmpfile()), out_(std::tmpfile()), err_(std::tmpfile()) {
  std::fwrite(setting.input.data(), 1, setting.input.size(), in_);
  std::fflush(in_);
  std::rewind(in_);
  std::vector<char*> argv{const_cast<char*>(AIRLIGHT_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  process_ = fork();
  if (process_ != 0) return;
  for (const auto& [file, descriptor] : {std::pair{in_, 0}, {out_, 1}, {err_, 2}}) dup2(fileno(file), descriptor);
  for (const std::string& variable : setting.environment) putenv(const_cast<char*>(variable.c_str()));
  if (setting.file_size_limit >= 0) {
    const rlimit limit{rlim_t(setting.file_size_limit), rlim_t(setting.file_size_limit)};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  if (chdir(folder.path().c_str()) == 0) execv(AIRLIGHT_PROGRAM, argv.data());
  _exit(126);
}

Program::~Program() {
  if (running()) {
    kill(process_, SIGKILL);
    waitpid(process_, &status_, 0);
  }
  for (std::FILE* file : {in_, out_, err_}) std::fclose(file);
}

bool Program::running() { return status_ == -1 && waitpid(process_, &status_, WNOHANG) == 0; }

void Program::signal(int number) {
  if (running()) kill(process_, number);
}

Outcome Program::wait(double seconds) {
  using namespace std::chrono;
  const auto end = steady_clock::now() + duration<double>(seconds);
  while (running()) {
    if (steady_clock::now() > end) {
      kill(process_, SIGKILL);
      waitpid(process_, &status_, 0);
      break;
    }
    std::this_thread::sleep_for(2ms);
  }
  return {WIFEXITED(status_) ? WEXITSTATUS(status_) : 1000 + WTERMSIG(status_), read_all(out_), read_all(err_)};
}

Outcome run(const Folder& folder, const std::vector<std::string>& arguments, const Setting& setting) {
  return Program(folder, arguments, setting).wait();
}

void run_through_and_after_a_kill(const Folder& whole, const Folder& killed,
                                  const std::vector<std::string>& arguments) {
  using Clock = std::chrono::steady_clock;
  const auto started = Clock::now();
  const Outcome outcome = run(whole, arguments);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::chrono::duration<double> lasted = Clock::now() - started;
  std::random_device random;
  const double moment = std::uniform_real_distribution(0.0, lasted.count())(random);
  {
    Program program(killed, arguments);
    std::this_thread::sleep_for(std::chrono::duration<double>(moment));
    program.signal(SIGKILL);
    program.wait();
  }
  ASSERT_EQ(run(killed, arguments).code, 0) << "killed after " << moment << " s";
}

std::vector<nlohmann::json> json_lines(const std::string& text) {
  std::vector<nlohmann::json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

}  // namespace airlight
