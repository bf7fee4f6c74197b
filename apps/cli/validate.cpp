// `airlight validate`: how wrong models are, measured; what docs/accuracy.md says is made by it.
#include "validate.h"

#include <fmt/core.h>

#include <fstream>
#include <memory>
#include <sstream>

#include "airlight/error.h"
#include "command_line.h"
#include "commands.h"
#include "options.h"
#include "text_output.h"

namespace airlight::cli {

void write_into_page(const std::string& page, const std::string& name, const std::string& text) {
  std::ifstream file(page);
  std::ostringstream whole;
  if (!(file && whole << file.rdbuf())) throw InputError(fmt::format("{}: cannot be read", page));
  const std::string old = whole.str(), end_mark = fmt::format("<!-- {} end", name);
  const std::size_t begin = old.find(fmt::format("<!-- {} begin", name)), from = old.find('\n', begin),
                    end = old.find(end_mark, begin);
  if (begin == std::string::npos || from == std::string::npos || end == std::string::npos)
    throw InputError(fmt::format("{}: expected a line that begins with \"<!-- {} begin\", and \"{}\" below it", page,
                                 name, end_mark));
  write_text(page, old.substr(0, from + 1) + text + old.substr(end));
}

void add_validate(CommandLine& line) {
  const auto options = std::make_shared<ValidateOptions>();
  const Verb validate = line.verb("validate", "How wrong each model is, beside what it costs (docs/accuracy.md)");
  validate
      .option("-o,--output", options->folder, "folder for tables and chart; started again, an interrupted run goes on")
      .required()
      .type_name("DIR");
  validate.flag("--quick", options->quick, "four of the yardstick's eight wavelengths");
  validate
      .option("--model", options->models,
              "judge this one, with parameters of its own after a colon; may be repeated (default all)")
      .one_value_each()
      .type_name("NAME[:KEY=VALUE,...]");
  const Option measured =
      validate.flag("--measured", options->measured,
                    "compare with measured and published values instead; with --quick precomputed is asked at fewer "
                    "wavelengths; random walks where --model reference asks for them");
  validate
      .flag("--spectrum", options->spectrum,
            "colours of 3, 4, 8 and 16 wavelengths against 40 instead, and the best four with their matrix")
      .excludes(measured);
  validate.option("--data", options->data, "folder of Airlight's data (default data)").type_name("DIR");
  validate
      .option("--against", options->against,
              "ledger.json of an earlier run: the same rays are asked, and a figure that became worse is a failure")
      .type_name("FILE");
  validate.option("--page", options->page, "page (Markdown) whose part between marks is written anew")
      .type_name("FILE");
  validate.runs([options] {
    const auto part = options->measured ? validate_measured : options->spectrum ? validate_spectrum : validate_ledger;
    return part(*options);
  });
}

}  // namespace airlight::cli
