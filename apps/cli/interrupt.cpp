#include "interrupt.h"

#include <unistd.h>

#include <csignal>
#include <initializer_list>

#include "image/output_file.h"

namespace airlight::cli {
namespace {
volatile std::sig_atomic_t flag = 0;

// Both may do only what POSIX allows in a signal handler.
void leave(int) {
  OutputFile::remove_all();
  constexpr char message[] = "airlight: interrupted\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message, sizeof message - 1);
  _exit(130);
}
void on_signal(int) {
  if (flag) leave(0);
  flag = 1;
  alarm(1);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGALRM, leave);
  struct sigaction action = {};
  action.sa_handler = on_signal;  // without SA_RESTART: a read that waits for input returns, and the flag is seen
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before = {};
    // What the parent chose to ignore (nohup, background jobs of simple shells) stays ignored.
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

bool interrupted() { return flag != 0; }

void check_interrupt() {
  if (interrupted()) throw Interrupted{};
}

}  // namespace airlight::cli
