// `airlight validate`: how wrong models are, measured; what docs/accuracy.md says is made by it.
#include "validate.h"

#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "airlight/error.h"
#include "command_line.h"
#include "commands.h"
#include "interrupt.h"
#include "options.h"
#include "text_output.h"

namespace airlight::cli {

PagePart::PagePart(std::string page, const std::string& name) : page_(std::move(page)) {
  if (page_.empty()) return;
  std::ifstream file(page_);
  std::ostringstream whole;
  if (!(file && whole << file.rdbuf())) throw InputError(fmt::format("--page = {}: cannot be read", page_));
  const std::string old = whole.str(), end_mark = fmt::format("<!-- {} end", name);
  const std::size_t begin = old.find(fmt::format("<!-- {} begin", name)), from = old.find('\n', begin),
                    end = old.find(end_mark, begin);
  if (begin == std::string::npos || from == std::string::npos || end == std::string::npos)
    throw InputError(fmt::format("--page = {}: expected a line that begins with \"<!-- {} begin\", and \"{}\" below it",
                                 page_, name, end_mark));
  before_ = old.substr(0, from + 1);
  after_ = old.substr(end);
}

void PagePart::write(const std::string& text) const {
  if (!page_.empty()) write_text(page_, before_ + text + after_);
}

void make_report_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(fmt::format("--output = {}: cannot be made a folder: {}", folder, error.message()));
}

void add_validate(CommandLine& line) {
  const auto options = std::make_shared<ValidateOptions>();
  const Verb validate = line.verb("validate", "How wrong each model is, beside what it costs (docs/accuracy.md)");
  validate
      .option("-o,--output", options->folder, "folder for tables and chart; started again, an interrupted run goes on")
      .required()
      .type_name("DIR");
  const Option quick = validate.flag("--quick", options->quick, "four of the yardstick's eight wavelengths");
  validate
      .option("--model", options->models,
              "judge this one, with parameters of its own after a colon, as --set takes them; may be repeated (default "
              "all)")
      .one_value_each()
      .type_name("NAME[:KEY=VALUE,...]");
  const Option measured =
      validate.flag("--measured", options->measured,
                    "compare with measured and published values instead; with --quick precomputed is asked at fewer "
                    "wavelengths; random walks where --model reference asks for them");
  const Option spectrum =
      validate
          .flag("--spectrum", options->spectrum,
                "colours of 3, 4, 8 and 16 wavelengths against 40 instead, and the best four with their matrix")
          .excludes(measured)
          .excludes(quick);
  validate.option("--data", options->data, "folder of Airlight's data (default data)").type_name("DIR");
  validate
      .option("--against", options->against,
              "ledger.json of an earlier run: the same rays are asked, and a figure that became worse is a failure")
      .excludes(measured)
      .excludes(spectrum)
      .type_name("FILE");
  validate.option("--page", options->page, "page (Markdown) whose part between marks is written anew")
      .type_name("FILE");
  validate.runs([options] {
    const auto part = options->measured ? validate_measured : options->spectrum ? validate_spectrum : validate_ledger;
    try {
      return part(*options);
    } catch (const Interrupted&) {
      if (options->spectrum) throw;
      throw Interrupted("what is done is kept, and the same command goes on there");
    }
  });
}

}  // namespace airlight::cli
