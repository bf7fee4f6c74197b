#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "airlight/error.h"
#include "command_line.h"
#include "commands.h"
#include "interrupt.h"

namespace {

int complain(const std::exception& problem, int code) {
  std::fprintf(stderr, "airlight: %s\n", problem.what());
  return code;
}

int run(int argc, char** argv) {
  using namespace airlight::cli;
  CommandLine line("airlight", "The light of the sky: pictures and numbers in absolute units.", version(),
                   "Exit codes: 0 done; 1 failed while working, or some lines of a batch failed; 2 bad usage or "
                   "input; 130 interrupted.");
  add_sky(line);
  add_render(line);
  add_compare(line);
  add_haze(line);
  add_sequence(line);
  add_realworldz_table(line);
  add_tables(line);
  add_probe(line);
#ifdef AIRLIGHT_WITH_REFERENCE
  add_validate(line);
#endif
  add_eval(line);
  add_models(line);
  add_planets(line);
  add_doctor(line);
  try {
    return line.run(argc, argv);
  } catch (const Interrupted& interruption) {
    return complain(interruption, interrupted_code);
  } catch (const airlight::InputError& error) {
    return complain(error, bad_input);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "airlight: not enough memory\n");
    return failed;
  } catch (const std::exception& error) {
    // A signal that cut a blocking call short shows up as that call's failure.
    return complain(error, interrupted() ? interrupted_code : failed);
  }
}

}  // namespace

int main(int argc, char** argv) {
  // A file size limit is then an error of the write, with a message.
  std::signal(SIGXFSZ, SIG_IGN);
  airlight::cli::catch_interrupts();
  return run(argc, argv);
}
