#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "airlight/error.h"
#include "commands.h"
#include "interrupt.h"

namespace {

int complain(const std::exception& problem, int code) {
  std::fprintf(stderr, "airlight: %s\n", problem.what());
  return code;
}

int run(int argc, char** argv) {
  using namespace airlight::cli;
  CLI::App app{"The light of the sky: pictures and numbers in absolute units.", "airlight"};
  app.set_version_flag("--version", version());
  app.require_subcommand(0, 1);  // an unknown word is then named in the message; none at all shows the help
  app.get_formatter()->column_width(38);
  Command chosen;
  add_sky(app, chosen);
  add_render(app, chosen);
  add_compare(app, chosen);
  add_haze(app, chosen);
  add_sequence(app, chosen);
  add_realworldz_table(app, chosen);
  add_tables(app, chosen);
  add_probe(app, chosen);
#ifdef AIRLIGHT_WITH_REFERENCE
  add_validate(app, chosen);
#endif
  add_eval(app, chosen);
  add_models(app, chosen);
  add_planets(app, chosen);
  add_doctor(app, chosen);
  app.footer(
      "Exit codes: 0 done; 1 failed while working, or some lines of a batch failed; 2 bad usage or input; 130 "
      "interrupted.");
  try {
    app.parse(argc, argv);
    if (chosen) return chosen();
    std::fputs(app.help().c_str(), stderr);
    return bad_input;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ok : bad_input;
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
