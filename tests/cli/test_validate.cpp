// `airlight validate`: what it is told wrongly it says at once, and a run that was killed goes on.
#ifdef AIRLIGHT_WITH_REFERENCE
#include <gtest/gtest.h>

#include "run_program.h"

namespace airlight {
namespace {

using Words = std::vector<std::string>;

const std::string root = AIRLIGHT_ROOT;

/// One model that needs no tables, at four wavelengths; and no costs, which are never twice the same.
Words quick_run(const Words& more = {}) {
  Words words{"validate", "--quick",      "--model",   "single",
              "--data",   root + "/data", "--against", root + "/docs/validation/quick.json",
              "-o",       "out"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Validate, what_is_told_wrongly_is_said_before_any_work) {
  const std::string data = root + "/data", page = root + "/README.md", quick = root + "/docs/validation/quick.json";
  const struct {
    Words words;
    std::string says;
  } cases[] = {
      {{"--model", "sngle"}, "--model = sngle: unknown"},
      {{"--model", "rama"}, "--model = rama: has no sky"},
      {{"--model", "precomputed:"}, "--model = precomputed:: \"\": expected NAME, or NAME:KEY=VALUE"},
      {{"--model", "precomputed:detail"}, "--model = precomputed:detail: \"detail\": expected NAME, or NAME:KEY=VALUE"},
      {{"--model", "precomputed:panels=8,detail"}, "\"detail\": expected NAME, or NAME:KEY=VALUE"},
      {{"--model", "precomputed:=8"}, "\"=8\": expected NAME, or NAME:KEY=VALUE"},
      {{"--model", "precomputed:panels=8,detail=draft,panels=9"}, "panels: given twice"},
      {{"--model", "hoffman_preetham:beta_mie=1e-6,2e-6,9"}, "hoffman_preetham.beta_mie[2] = 9"},
      {{"--model", "hoffman_preetham:beta_mie=1e-6,2e-6,2e-6,mode=prined"}, "hoffman_preetham.mode = \"prined\""},
      {{"--model", "precomputed:detail=huge"}, "precomputed.detail = \"huge\""},
      {{"--model", "single", "--page", page},
       "--page = " + page + ": expected a line that begins with \"<!-- ledger begin"},
      {{"--model", "single", "--page", "none.md"}, "--page = none.md: cannot be read"},
      {{"--spectrum", "--page", page}, "<!-- spectrum begin"},
      {{"--measured", "--page", page}, "<!-- measured begin"},
      {{"--measured", "--spectrum"}, "excludes"},
      {{"--measured", "--against", quick}, "excludes"},
      {{"--spectrum", "--against", quick}, "excludes"},
      {{"--spectrum", "--quick"}, "excludes"},
      {{"--against", "none.json"}, "--against = none.json: cannot be read"},
      {{"--against", page}, "--against = " + page + ": cannot be read as JSON"},
      {{"--against", quick}, "made at other wavelengths; expected one made without --quick"},
  };
  for (const auto& [words, says] : cases) {
    const Folder folder;
    Words all{"validate", "-o", "out", "--data", data};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = run(folder, all);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << "expected: " << says << "\nsaid: " << outcome.err;
    EXPECT_TRUE(folder.names().empty()) << says;
  }
}

TEST(Validate, a_folder_that_cannot_be_made_is_named) {
  const Folder folder;
  write_file(folder / "out", "a file");
  const Outcome outcome = run(folder, quick_run());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("--output = out: cannot be made a folder"), std::string::npos) << outcome.err;
}

TEST(Validate, a_killed_run_goes_on_to_the_same_ledger) {
  const Folder whole, killed;
  ASSERT_NO_FATAL_FAILURE(run_through_and_after_a_kill(whole, killed, quick_run()));
  for (const char* file : {"out/quick.json", "out/quick.csv", "out/quick.svg", "out/quick.md"})
    EXPECT_EQ(read_file(whole / file), read_file(killed / file)) << file;
  EXPECT_FALSE(std::filesystem::exists(killed / "out/unfinished"));
}

/// What an earlier program, or other questions, left is not taken; what was left whole is.
TEST(Validate, only_answers_to_the_same_questions_are_taken_from_an_unfinished_run) {
  const Folder folder;
  ASSERT_EQ(run(folder, quick_run()).code, 0);
  const std::string right = read_file(folder / "out/quick.csv");
  std::filesystem::create_directories(folder / "out/unfinished");
  for (const std::string& left :
       {std::string("{\"key\": "), std::string("{\"key\": {}, \"done\": {}}"), std::string()}) {
    write_file(folder / "out/unfinished/single.earth.json", left);
    ASSERT_EQ(run(folder, quick_run()).code, 0) << left;
    EXPECT_EQ(read_file(folder / "out/quick.csv"), right) << left;
    std::filesystem::create_directories(folder / "out/unfinished");
  }
}

void replace_all(const std::string& file, const std::string& old, const std::string& by) {
  std::string text = read_file(file);
  ASSERT_NE(text.find(old), std::string::npos) << file;
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size())
    text.replace(at, old.size(), by);
  write_file(file, text);
}

/// Rays that moved since an unfinished run, and measurements, are asked anew: as many as before, but others.
TEST(Validate, other_questions_of_the_same_number_are_asked_anew) {
  const struct {
    std::string part, unfinished, first, result, data, old, by;
    Words words;
  } cases[] = {{"yardstick",
                "out/unfinished",
                "out/quick.json",
                "out/quick.csv",
                "yardstick/rays.jsonl",
                "\"sun_zenith\":30.0",
                "\"sun_zenith\":31.0",
                {"--model", "single", "--against", root + "/docs/validation/quick.json"}},
               {"measured",
                "out/unfinished-measured",
                "out/measured.json",
                "out/measured.md",
                "measured/measured_sky_20130527.json",
                "\"sun_zenith_deg\":46.2",
                "\"sun_zenith_deg\":40.2",
                {"--model", "skyview", "--measured"}}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.part);
    const Folder folder;
    std::filesystem::create_directory(folder / "data");
    std::filesystem::copy(root + "/data/" + c.part, folder / ("data/" + c.part));
    Words words{"validate", "--quick", "--data", "data", "-o", "out"};
    words.insert(words.end(), c.words.begin(), c.words.end());
    // Ends after the last part, as the first of its files cannot be written.
    std::filesystem::create_directories(folder / c.first);
    ASSERT_EQ(run(folder, words).code, 2);
    ASSERT_FALSE(std::filesystem::is_empty(folder / c.unfinished));
    std::filesystem::remove(folder / c.first);

    ASSERT_NO_FATAL_FAILURE(replace_all(folder / ("data/" + c.data), c.old, c.by));
    run(folder, words);  // may be worse than the ledger that it is held against
    const std::string gone_on = read_file(folder / c.result);
    std::filesystem::remove_all(folder / "out");
    run(folder, words);
    EXPECT_EQ(gone_on, read_file(folder / c.result));
    EXPECT_FALSE(gone_on.empty());
  }
}

TEST(Validate, only_the_part_between_the_marks_of_a_page_is_written_anew) {
  const Folder folder;
  write_file(folder / "page.md", "# Above\n<!-- ledger begin: here -->\nold\n<!-- ledger end -->\nbelow\n");
  const Outcome outcome = run(folder, quick_run({"--page", "page.md"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string page = read_file(folder / "page.md");
  EXPECT_TRUE(page.starts_with("# Above\n<!-- ledger begin: here -->\n")) << page;
  EXPECT_TRUE(page.ends_with("<!-- ledger end -->\nbelow\n")) << page;
  EXPECT_EQ(page.find("old\n"), std::string::npos);
  EXPECT_NE(page.find("| single |"), std::string::npos);
  EXPECT_NE(page.find("(out/quick.csv)"), std::string::npos) << "links lead from the page's folder";
}

}  // namespace
}  // namespace airlight
#endif
