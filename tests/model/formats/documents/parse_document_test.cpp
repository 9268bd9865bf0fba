#include "model/formats/documents/parse_document.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <limits>
#include <random>

#include "algorithms/core/error.h"
#include "model/formats/files/input_file.h"

namespace remount::formats {
namespace {

std::string error_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string yaml_error(const std::string& text, const DocumentLimits& limits = {}) {
  return error_of([&] { parse_yaml(text, "in.yaml", limits); });
}

TEST(parse_document, reads_maps_lists_scalars_and_lines) {
  const DocumentNode root = parse_yaml("a: 1.5\nb: [1, 2, 3]\nc:\n  d: \"7\"\n  e: true\nf: ~\n", "in.yaml");
  const DocumentView view(root, "in.yaml");
  EXPECT_DOUBLE_EQ(view.at("a").number(), 1.5);
  EXPECT_EQ(view.at("b").numbers(3), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(view.at("c").at("d").string(), "7");
  EXPECT_EQ(view.at("c").at("d").line(), 4);
  EXPECT_TRUE(view.at("c").at("e").boolean());
  EXPECT_TRUE(view.at("f").is_null());
}

TEST(parse_document, refuses_what_can_grow_or_hide) {
  EXPECT_NE(yaml_error("a: &x 1\nb: 2\n").find("in.yaml:1: anchors"), std::string::npos) << yaml_error("a: &x 1\n");
  EXPECT_NE(yaml_error("a: &x [1]\nb: *x\n").find("anchors"), std::string::npos);
  EXPECT_NE(yaml_error("&a [*a]").find("anchors"), std::string::npos);
  EXPECT_NE(yaml_error("a: !!binary aGk=\n").find("tags"), std::string::npos);
  EXPECT_NE(yaml_error("a: 1\nb: 2\na: 3\n").find("in.yaml:3: the key \"a\" appears twice"), std::string::npos)
      << yaml_error("a: 1\nb: 2\na: 3\n");
  EXPECT_NE(yaml_error("? [1, 2]\n: 3\n").find("key of a map"), std::string::npos);
  EXPECT_NE(yaml_error("a: 1\n---\nb: 2\n").find("in.yaml:2: a second YAML document"), std::string::npos);
  EXPECT_NE(yaml_error("").find("in.yaml:1: is empty"), std::string::npos) << yaml_error("");
  EXPECT_NE(yaml_error("a: [1, 2\n").find("in.yaml:"), std::string::npos);
}

TEST(parse_document, keeps_its_limits_quickly) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_NE(yaml_error(std::string(400000, '[')), "");
  EXPECT_NE(yaml_error(std::string((1 << 20) + 1, ' ')).find("bytes long"), std::string::npos);
  std::string many = "[";
  for (int i = 0; i < 300000; ++i) many += "1,";
  EXPECT_NE(yaml_error(many + "1]").find("more than 200000 values"), std::string::npos);
  std::string maps;
  for (int i = 0; i < 10000; ++i) maps += std::string("- a: ") + std::to_string(i) + "\n";
  EXPECT_EQ(yaml_error(maps), "");
  EXPECT_NE(error_of([] { parse_json(std::string(500000, '['), "in.json"); }).find("nested deeper"), std::string::npos);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_LT(seconds, 20.0);
  RecordProperty("seconds", std::to_string(seconds));
}

// What is accepted can be written and read again to the same; what is refused is refused with its file.
TEST(parse_document, mutated_documents_are_read_whole_or_refused_with_the_place) {
  const std::string good = "format: x/1\nlist: [1, 2, {a: b}]\nmap:\n  k: \"v\\n\"\n  l: |\n    text\n  m: 'q'\n";
  std::mt19937 random(7);
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = good;
    for (int k = 0; k < 1 + i % 4; ++k)
      text[random() % text.size()] =
          static_cast<char>(i % 2 ? random() % 256 : "[]{}&*!|>-:,#\"'\n\t %@?"[random() % 22]);
    const std::string error = error_of([&] {
      const std::string written = to_yaml(parse_yaml(text, "in.yaml"));
      ++accepted;
      // Bytes that are not UTF-8 are replaced on writing, and two keys may become one.
      if (std::any_of(text.begin(), text.end(), [](char c) { return c < 0; })) return;
      EXPECT_EQ(to_yaml(parse_yaml(written, "again.yaml")), written) << text;
    });
    EXPECT_TRUE(error.empty() || error.starts_with("in.yaml:")) << error << "\n" << text;
    const std::string json_error = error_of([&] { parse_json(text, "in.json"); });
    EXPECT_TRUE(json_error.starts_with("in.json:")) << "no mutation makes JSON of it: " << json_error << "\n" << text;
    if (HasFailure()) return;
  }
  EXPECT_GT(accepted, 2000) << "the mutations are too wild to test reading";
  EXPECT_LT(accepted, 18000) << "the mutations are too tame to test refusal";
}

TEST(parse_document, json_has_the_same_refusals) {
  EXPECT_NE(error_of([] { parse_json("{\"a\": 1, \"a\": 2}", "in.json"); }).find("appears twice"), std::string::npos);
  EXPECT_NE(error_of([] { parse_json("{\n\"a\": 1,\n}", "in.json"); }).find("in.json:3"), std::string::npos)
      << error_of([] { parse_json("{\n\"a\": 1,\n}", "in.json"); });
  EXPECT_NE(error_of([] { parse_json("", "in.json"); }), "");
  EXPECT_NE(error_of([] { parse_json("{} {}", "in.json"); }), "");
}

TEST(document, tree_survives_both_formats) {
  DocumentNode root = DocumentNode::map();
  root.comment = "a comment\nof two lines";
  root.add("word", DocumentNode::string("plain-word"));
  root.add("reserved", DocumentNode::string("true"));
  root.add("number like", DocumentNode::string("12"));
  root.add("odd", DocumentNode::string("tab\t quote\" back\\ line\n colon: # dash - \x01 \xc3\xa9 \xe6\xbc\xa2"));
  root.add("empty", DocumentNode::string(""));
  root.add("nothing", DocumentNode::null());
  root.add("no", DocumentNode::boolean(false));
  root.add("stamp", DocumentNode::integer(1317636475123456789LL));
  root.add("numbers", DocumentNode::numbers({0.1, -1e-300, 3, std::numeric_limits<double>::quiet_NaN()}));
  DocumentNode& list = root.add("list", DocumentNode::sequence());
  DocumentNode entry = DocumentNode::map();
  entry.add("a", DocumentNode::numbers({1, 2}));
  entry.add("b", DocumentNode::map()).add("c", DocumentNode::integer(1));
  list.add(entry);
  entry.on_one_line = true;
  list.add(entry);
  list.add(DocumentNode::sequence());
  DocumentNode nested = DocumentNode::sequence();
  nested.add(DocumentNode::map()).add("x", DocumentNode::integer(1));
  list.add(nested);

  const std::string yaml = to_yaml(root), json = to_json(root);
  const DocumentNode from_yaml = parse_yaml(yaml, "a.yaml"), from_json = parse_json(json, "a.json");
  EXPECT_EQ(DocumentView(from_yaml, "a").at("odd").string(), DocumentView(root, "a").at("odd").string()) << yaml;
  EXPECT_EQ(DocumentView(from_json, "a").at("odd").string(), DocumentView(root, "a").at("odd").string()) << json;
  EXPECT_EQ(DocumentView(from_yaml, "a").at("stamp").integer(0, std::numeric_limits<std::int64_t>::max()),
            1317636475123456789LL);
  EXPECT_EQ(DocumentView(from_yaml, "a").at("reserved").string(), "true");
  EXPECT_EQ(from_yaml.find("reserved")->kind, DocumentNode::Kind::String);
  EXPECT_EQ(to_yaml(from_json), to_yaml(from_yaml));
  EXPECT_EQ(from_yaml.find("list")->items.size(), 4U) << yaml;
  EXPECT_EQ(from_yaml.find("list")->items[3].items[0].find("x")->text, "1") << yaml;
}

TEST(document, invalid_utf8_never_reaches_a_file) {
  DocumentNode root = DocumentNode::map();
  root.add("name", DocumentNode::string("a\xff\xc3(\xed\xa0\x80z"));
  const DocumentNode back = parse_json(to_json(root), "a.json");
  EXPECT_EQ(back.items[0].text.front(), 'a');
  EXPECT_EQ(back.items[0].text.back(), 'z');
  parse_yaml(to_yaml(root), "a.yaml");
}

TEST(document, numbers_are_checked) {
  const DocumentNode root = parse_yaml("a: .nan\nb: 1e999\nc: 12x\nd: \"1\"\ne: 0x10\nf: 1.5\n", "in.yaml");
  const DocumentView view(root, "in.yaml");
  for (const char* key : {"a", "b", "c", "d", "e"}) {
    const std::string error = error_of([&] { view.at(key).number(); });
    EXPECT_NE(error.find("expected a finite number"), std::string::npos) << key << ": " << error;
  }
  EXPECT_NE(error_of([&] { view.at("f").integer(0, 5); }).find("in.yaml:6: f: expected a whole number"),
            std::string::npos);
  EXPECT_NE(error_of([&] { view.at("g"); }).find("\"g\" is missing"), std::string::npos);
  EXPECT_NE(error_of([&] { view.allow_only({"a", "b"}); }).find("in.yaml:3: c: is not a key"), std::string::npos);
}

TEST(parse_document, file_must_be_regular) {
  const auto folder = std::filesystem::temp_directory_path() / ("remount_regular_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const auto fifo = folder / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  EXPECT_NE(error_of([&] { read_document(folder); }), "");
  EXPECT_NE(error_of([&] { read_document(fifo); }), "");
  EXPECT_NE(error_of([&] { read_document("/dev/zero"); }), "");
  EXPECT_NE(error_of([&] { read_document(folder / "none"); }), "");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace remount::formats
