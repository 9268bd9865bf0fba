// Blocks of documents that name a file of tests or of examples in their first line stand in that file, piece by piece:
// "…" on a line of its own is where something is left out.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace {

std::string text_of(const std::string& file) {
  std::ifstream stream(std::string(REMOUNT_SOURCE_DIR) + "/" + file);
  EXPECT_TRUE(stream) << file;
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// How many blocks of the document were compared.
int compare_blocks(const std::string& document) {
  const std::string fence = "```", left_out = "\n…\n", text = text_of(document);
  int compared = 0;
  for (std::size_t at = text.find("\n" + fence); at != std::string::npos;) {
    const std::size_t first_line = text.find('\n', at + 1) + 1, end = text.find("\n" + fence, first_line);
    if (end == std::string::npos) throw std::runtime_error("a block does not end");
    std::istringstream block(text.substr(first_line, end - first_line));
    std::string sign, file, line;
    std::getline(block, line);
    std::istringstream(line) >> sign >> file;
    at = text.find("\n" + fence, end + 1);
    if (!file.starts_with("tests/") && !file.starts_with("examples/")) continue;
    std::ostringstream rest;
    rest << block.rdbuf();
    const std::string compiled = text_of(file), shown = rest.str();
    for (std::size_t from = 0; from < shown.size();) {
      const std::size_t to = std::min(shown.find(left_out, from), shown.size());
      EXPECT_NE(compiled.find(shown.substr(from, to - from)), std::string::npos) << "not in " << file << ":\n"
                                                                                 << shown.substr(from, to - from);
      from = to + left_out.size();
    }
    ++compared;
  }
  return compared;
}

TEST(contributing, shows_examples_as_they_are_compiled) { EXPECT_GE(compare_blocks("CONTRIBUTING.md"), 5); }

TEST(library_page, shows_examples_as_they_are_compiled) { EXPECT_GE(compare_blocks("docs/library.md"), 1); }

}  // namespace
