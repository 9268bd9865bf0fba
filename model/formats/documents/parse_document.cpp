#include "model/formats/documents/parse_document.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <unordered_set>

#include "algorithms/core/error.h"
#include "messages/files.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/system_words.h"
#include "model/formats/files/text_file.h"

namespace remount::formats {
namespace {

/// Builds the tree from the events of either parser and keeps the limits.
class TreeBuilder {
 public:
  TreeBuilder(std::string where, const DocumentLimits& limits) : where_(std::move(where)), limits_(limits) {}

  [[noreturn]] void fail(int line, Message what_happened) const {
    throw Error(ErrorCode::Format, line > 0 ? where_ + ":" + std::to_string(line) : where_, std::move(what_happened));
  }

  void scalar(DocumentNode::Kind kind, std::string text, int line) {
    if (awaits_key()) {
      if (kind == DocumentNode::Kind::Null) fail(line, say::document_key_is_null());
      key(std::move(text), line);
      return;
    }
    place(kind, line).text = std::move(text);
  }

  void begin(DocumentNode::Kind kind, int line) {
    if (awaits_key()) fail(line, say::document_key_is_no_text());
    if (static_cast<int>(open_.size()) >= limits_.max_depth) fail(line, say::document_too_deep(limits_.max_depth));
    DocumentNode& node = place(kind, line);
    open_.push_back({&node, {}, false});
  }

  void end() { open_.pop_back(); }

  void key(std::string text, int line) {
    Frame& frame = open_.back();
    if (!frame.seen.insert(text).second) fail(line, say::document_key_twice(text.substr(0, 60)));
    frame.node->keys.push_back(std::move(text));
    frame.has_key = true;
  }

  DocumentNode take() { return std::move(root_); }

 private:
  struct Frame {
    DocumentNode* node;
    std::unordered_set<std::string> seen;
    bool has_key;
  };

  bool awaits_key() const {
    return !open_.empty() && open_.back().node->kind == DocumentNode::Kind::Map && !open_.back().has_key;
  }

  DocumentNode& place(DocumentNode::Kind kind, int line) {
    if (++nodes_ > limits_.max_nodes) fail(line, say::document_too_many_values(limits_.max_nodes));
    DocumentNode* node = &root_;
    if (!open_.empty()) {
      // Only the innermost open container grows, so the pointers to the outer ones stay valid.
      open_.back().has_key = false;
      node = &open_.back().node->add(DocumentNode{});
    }
    node->kind = kind;
    node->line = line;
    return *node;
  }

  std::string where_;
  DocumentLimits limits_;
  DocumentNode root_;
  std::vector<Frame> open_;
  std::size_t nodes_ = 0;
};

class YamlEvents : public YAML::EventHandler {
 public:
  explicit YamlEvents(TreeBuilder& tree) : tree_(tree) {}
  int first_line() const { return first_line_; }

  void OnDocumentStart(const YAML::Mark& mark) override { first_line_ = mark.line + 1; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    check(mark, "", anchor);
    tree_.scalar(DocumentNode::Kind::Null, "", mark.line + 1);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    tree_.fail(mark.line + 1, say::document_no_aliases());
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    check(mark, tag, anchor);
    const bool quoted = tag == "!";
    if (!quoted && (value == "null" || value == "~" || value.empty()))
      tree_.scalar(DocumentNode::Kind::Null, "", mark.line + 1);
    else
      tree_.scalar(quoted ? DocumentNode::Kind::String : DocumentNode::Kind::Plain, value, mark.line + 1);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    check(mark, tag, anchor);
    tree_.begin(DocumentNode::Kind::Sequence, mark.line + 1);
  }
  void OnSequenceEnd() override { tree_.end(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    check(mark, tag, anchor);
    tree_.begin(DocumentNode::Kind::Map, mark.line + 1);
  }
  void OnMapEnd() override { tree_.end(); }

 private:
  void check(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) const {
    if (anchor != YAML::NullAnchor) tree_.fail(mark.line + 1, say::document_no_anchors());
    if (!tag.empty() && tag != "?" && tag != "!") tree_.fail(mark.line + 1, say::document_no_tags(tag.substr(0, 60)));
  }

  TreeBuilder& tree_;
  int first_line_ = 0;
};

class JsonEvents : public nlohmann::json::json_sax_t {
 public:
  JsonEvents(TreeBuilder& tree, std::string_view text) : tree_(tree), text_(text) {}

  bool null() override { return scalar(DocumentNode::Kind::Null, ""); }
  bool boolean(bool value) override { return scalar(DocumentNode::Kind::Plain, value ? "true" : "false"); }
  bool number_integer(number_integer_t value) override {
    return scalar(DocumentNode::Kind::Plain, std::to_string(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return scalar(DocumentNode::Kind::Plain, std::to_string(value));
  }
  bool number_float(number_float_t, const string_t& text) override { return scalar(DocumentNode::Kind::Plain, text); }
  bool string(string_t& value) override { return scalar(DocumentNode::Kind::String, value); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return begin(DocumentNode::Kind::Map); }
  bool key(string_t& value) override {
    tree_.key(value, 0);
    return true;
  }
  bool end_object() override { return end(); }
  bool start_array(std::size_t) override { return begin(DocumentNode::Kind::Sequence); }
  bool end_array() override { return end(); }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) override {
    const auto lines =
        std::count(text_.begin(), text_.begin() + static_cast<long>(std::min(position, text_.size())), '\n');
    tree_.fail(static_cast<int>(lines) + 1, say::document_no_json(position));
  }

 private:
  bool scalar(DocumentNode::Kind kind, std::string text) {
    tree_.scalar(kind, std::move(text), 0);
    return true;
  }
  bool begin(DocumentNode::Kind kind) {
    tree_.begin(kind, 0);
    return true;
  }
  bool end() {
    tree_.end();
    return true;
  }

  TreeBuilder& tree_;
  std::string_view text_;
};

void check_size(std::string_view text, const TreeBuilder& tree, const DocumentLimits& limits) {
  if (text.size() > limits.max_bytes) tree.fail(0, say::document_too_long(Bytes{text.size()}, Bytes{limits.max_bytes}));
}

}  // namespace

DocumentNode parse_yaml(std::string_view text, const std::string& where, const DocumentLimits& limits) {
  TreeBuilder tree(where, limits);
  check_size(text, tree, limits);
  std::istringstream stream{std::string(text)};
  try {
    YAML::Parser parser(stream);
    YamlEvents events(tree);
    if (!parser.HandleNextDocument(events)) tree.fail(1, say::document_empty());
    TreeBuilder rest(where, limits);
    YamlEvents rest_events(rest);
    if (parser.HandleNextDocument(rest_events)) tree.fail(rest_events.first_line(), say::document_second());
  } catch (const YAML::Exception& problem) {
    tree.fail(problem.mark.line + 1, say::document_no_yaml(library_words(problem.msg)));
  }
  return tree.take();
}

DocumentNode parse_json(std::string_view text, const std::string& where, const DocumentLimits& limits) {
  TreeBuilder tree(where, limits);
  check_size(text, tree, limits);
  JsonEvents events(tree, text);
  nlohmann::json::sax_parse(text.begin(), text.end(), &events);
  return tree.take();
}

DocumentNode read_document(const std::filesystem::path& path, const DocumentLimits& limits) {
  const std::string text = read_text_file(path, limits.max_bytes);
  const std::filesystem::path ending = path.extension();
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool looks_like_json =
      first != std::string::npos && text[first] == '{' && ending != ".yaml" && ending != ".yml";
  const bool json = ending == ".json" || looks_like_json;
  return json ? parse_json(text, path.string(), limits) : parse_yaml(text, path.string(), limits);
}

}  // namespace remount::formats
