// Man pages and completions are what the program says of itself: every verb and option of the help is in them.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>

#include "tests/app/cli/program_fixture.h"

namespace remount::cli {
namespace {

class cli_program_words : public ProgramFixture<cli_program_words> {
 protected:
  static void SetUpTestSuite() {
    std::string pattern = (std::filesystem::temp_directory_path() / "remount_cli_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }

  /// The verbs that the help lists, and the long options that begin lines of a help.
  static std::set<std::string> matches(const std::string& text, const char* pattern) {
    std::set<std::string> found;
    const std::regex expression(pattern);
    for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it)
      found.insert((*it)[1].str());
    return found;
  }
  static std::set<std::string> verbs() {
    const std::string help = run("--help").out;
    return matches(help.substr(help.find("Subcommands:")), "\n  ([a-z]+)  ");
  }
  /// Writes the help of each verb into "VERB.help", all at once: a process waits longer than it works.
  static void write_helps(const std::set<std::string>& all) {
    std::string command;
    for (const std::string& verb : all)
      command += "'" + std::string(REMOUNT_CLI) + "' " + verb + " --help > '" + path(verb + ".help") + "' & ";
    EXPECT_EQ(std::system((command + "wait").c_str()), 0);
  }
  static std::set<std::string> long_options(const std::string& help) {
    return matches(help, "\n  (?:-[a-z],)?(--[a-z0-9-]+)");
  }
  /// What bash offers behind these words, the last of which is being typed.
  static std::string completed(const std::string& words) {
    const std::string script = path("words.sh");
    std::ofstream(script) << ". '" << path("completion") << "'\nCOMP_WORDS=(" << words
                          << ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\ncompopt() { echo \"options: $*\"; }\n"
                          << "_remount_cli\necho \"${COMPREPLY[*]}\"\n";
    const std::string command = "bash '" + script + "' > '" + path("completed.txt") + "' 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << text_of(path("completed.txt"));
    return text_of(path("completed.txt"));
  }
};

TEST_F(cli_program_words, every_verb_and_option_is_in_the_man_page_and_in_completions) {
  const std::string page = run("--man-page").out, bash = run("--completion bash").out,
                    zsh = run("--completion zsh").out;
  const std::set<std::string> all = verbs();
  EXPECT_GE(all.size(), 14U);
  write_helps(all);
  std::size_t options = 0;
  for (const std::string& verb : all) {
    EXPECT_NE(page.find("\n.SS " + verb + "\n"), std::string::npos) << verb;
    EXPECT_NE(zsh.find("\n  '" + verb + ":"), std::string::npos) << verb;
    const std::size_t section = page.find("\n.SS " + verb + "\n"), next = page.find("\n.S", section + 1);
    const std::string of_verb = page.substr(section, next - section);
    for (const std::string& option : long_options(text_of(path(verb + ".help")))) {
      ++options;
      const std::string in_page = "\\fB" + std::regex_replace(option, std::regex("-"), "\\-") + "\\fR";
      EXPECT_NE(of_verb.find(in_page), std::string::npos) << verb << " " << option;
      EXPECT_NE(bash.find(option), std::string::npos) << verb << " " << option;
      EXPECT_NE(zsh.find("'*" + option + "["), std::string::npos) << verb << " " << option;
    }
  }
  std::printf("%zu verbs, %zu options of verbs\n", all.size(), options);
  EXPECT_GE(options, 100U);
}

TEST_F(cli_program_words, no_line_of_the_man_page_is_an_order_by_accident) {
  const std::set<std::string> known{"TH", "SH", "SS", "TP", "PP", "br", "ad", "\\\""};
  for (const char* language : {"en", "zh_CN"}) {
    const std::string page = run(std::string("--man-page --language ") + language).out;
    EXPECT_GT(page.size(), 10000U) << language;
    for (const std::string& order : matches(page, "\n[.']([^ \n]*)")) EXPECT_TRUE(known.contains(order)) << order;
  }
}

TEST_F(cli_program_words, bash_completes_verbs_options_and_what_they_take) {
  std::ofstream(path("completion")) << run("--completion bash").out;
  EXPECT_EQ(completed("remount-cli ins"), "inspect\n");
  EXPECT_EQ(completed("remount-cli --lang"), "--language\n");
  EXPECT_EQ(completed("remount-cli -q calibrate drive --met"), "--method\n");
  EXPECT_EQ(completed("remount-cli calibrate --method traj"), "trajectory\n");
  EXPECT_EQ(completed("remount-cli export result.yaml --to auto"), "autoware\n");
  EXPECT_EQ(completed("remount-cli simulate figure"), "figure-eight\n");
  EXPECT_EQ(completed("remount-cli report --language zh"), "zh_CN\n");
  EXPECT_EQ(completed("remount-cli calibrate --config x"), "\n") << "left to the names of files";
  EXPECT_EQ(completed("remount-cli calibrate x"), "\n");
  EXPECT_EQ(completed("remount-cli calibrate drive -j x"), "options: +o default +o bashdefault\n\n") << "a number";
  EXPECT_EQ(completed("remount-cli doctor --he"), "--help\n") << "once";
}

TEST_F(cli_program_words, zsh_offers_files_where_files_are_wanted) {
  const std::string zsh = run("--completion zsh").out;
  EXPECT_NE(zsh.find("  '*-j["), std::string::npos);
  for (const auto& [line, wanted] : {std::pair{"\n      '*-j[", ":N: '"},
                                     {"\n      '*--log[", ":FILE:_files'"},
                                     {"\n      '*--nominal[", ":SIX|FILE:_files'"},
                                     {"\n      '*--settled[", ":SECONDS: '"}}) {
    const std::size_t begin = zsh.find(line);
    ASSERT_NE(begin, std::string::npos) << line;
    const std::string found = zsh.substr(begin + 1, zsh.find('\n', begin + 1) - begin - 1);
    EXPECT_NE(found.find(wanted), std::string::npos) << found;
  }
  // Each apostrophe of a meaning leaves the quotes and comes back: what quotes remain stand in pairs.
  EXPECT_NE(zsh.find("'\\''"), std::string::npos);
  std::size_t begin = 0, lines = 0;
  for (std::size_t end = 0; (end = zsh.find('\n', begin)) != std::string::npos; begin = end + 1, ++lines) {
    const std::string line = std::regex_replace(zsh.substr(begin, end - begin), std::regex(R"(\\')"), "");
    EXPECT_EQ(std::count(line.begin(), line.end(), '\'') % 2, 0) << line;
  }
  std::printf("%zu lines\n", lines);
  EXPECT_EQ(matches(zsh, "\n      '[*](--help)\\[").size(), 1U);
  const std::size_t first = zsh.find("'*--help[");
  EXPECT_EQ(zsh.find("'*--help[", first + 1), std::string::npos) << "--help is of all verbs, and said once";
}

TEST_F(cli_program_words, values_are_named_without_words_of_the_parser) {
  for (const char* words : {"--man-page", "--man-page --language zh_CN", "--completion zsh", "--help",
                            "calibrate --help", "batch --help"}) {
    const std::string text = run(words).out;
    EXPECT_FALSE(text.empty()) << words;
    for (const char* type : {"INT in", "FLOAT in", "UINT in"}) EXPECT_EQ(text.find(type), std::string::npos) << words;
  }
  EXPECT_NE(run("--man-page").out.find("\\fIN\\fR\nThreads, at most 1024"), std::string::npos);
}

TEST_F(cli_program_words, the_name_of_the_page_ends_without_a_full_stop) {
  for (const char* language : {"en", "zh_CN"}) {
    const std::string page = run(std::string("--man-page --language ") + language).out;
    const std::size_t begin = page.find("\nremount\\-cli \\- ");
    ASSERT_NE(begin, std::string::npos) << language;
    const std::string name = page.substr(begin + 1, page.find('\n', begin + 1) - begin - 1);
    EXPECT_FALSE(name.ends_with(".") || name.ends_with("。")) << name;
  }
}

TEST_F(cli_program_words, a_shell_that_is_unknown_is_wrong_usage) {
  const Outcome outcome = run("--completion fish");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("fish"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace remount::cli
