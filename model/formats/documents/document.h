// A small tree of values that YAML and JSON files are read into and written from, with checked access to it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/messages/message.h"

namespace remount::formats {

/// A value: nothing, a plain scalar (number, boolean or bare word), a quoted string, a sequence or a map.
struct DocumentNode {
  enum class Kind { Null, Plain, String, Sequence, Map };

  Kind kind = Kind::Null;
  std::string text;                 ///< of Plain and String
  std::vector<std::string> keys;    ///< of Map, in the order of the file; as many as `items`
  std::vector<DocumentNode> items;  ///< of Sequence and Map
  int line = 0;                     ///< first is 1; 0 where the format does not tell
  bool on_one_line = false;         ///< a wish for writing
  std::string comment;              ///< written before the value where the format has comments

  static DocumentNode null() { return {}; }
  static DocumentNode boolean(bool value) { return plain(value ? "true" : "false"); }
  static DocumentNode integer(std::int64_t value) { return plain(std::to_string(value)); }
  /// The shortest text that reads back to the same double; null where it is not finite.
  static DocumentNode number(double value);
  static DocumentNode string(std::string_view value);
  static DocumentNode sequence() { return of_kind(Kind::Sequence); }
  static DocumentNode numbers(const std::vector<double>& values);
  static DocumentNode map() { return of_kind(Kind::Map); }

  /// Appends to a map / a sequence and returns what was appended.
  DocumentNode& add(std::string key, DocumentNode value);
  DocumentNode& add(DocumentNode value);
  /// The value of a key of a map, or null pointer.
  const DocumentNode* find(std::string_view key) const;

 private:
  static DocumentNode plain(std::string text);
  static DocumentNode of_kind(Kind kind);
};

/// The shortest text that reads back to the same double ("0.1"), independent of the locale.
std::string shortest(double value);

/// JSON, indented by two; nodes with `on_one_line` and sequences of scalars on one line. Ends with a line feed.
std::string to_json(const DocumentNode& node);
/// YAML 1.2 in block style, likewise; with comments.
std::string to_yaml(const DocumentNode& node);

/// A node with the file and the path of keys that lead to it: every access that fails throws Error(Format) with
/// "file:line" and "pairs.proposed: expected ...".
class DocumentView {
 public:
  DocumentView(const DocumentNode& node, std::string_view file) : node_(&node), file_(file) {}

  const DocumentNode& node() const { return *node_; }
  int line() const { return node_->line; }
  bool is_null() const { return node_->kind == DocumentNode::Kind::Null; }
  bool is_map() const { return node_->kind == DocumentNode::Kind::Map; }
  bool is_sequence() const { return node_->kind == DocumentNode::Kind::Sequence; }
  bool has(std::string_view key) const { return node_->find(key) != nullptr; }

  DocumentView at(std::string_view key) const;                   ///< throws where the key is missing
  std::optional<DocumentView> find(std::string_view key) const;  ///< nothing where the key is missing
  std::vector<DocumentView> items() const;                       ///< of a sequence
  /// Keys and values of a map, in the order of the file.
  std::vector<std::pair<std::string, DocumentView>> entries() const;

  double number() const;         ///< finite
  double number_or_nan() const;  ///< NaN where the value is null
  std::vector<double> numbers(std::size_t count) const;
  std::int64_t integer(std::int64_t minimum, std::int64_t maximum) const;
  bool boolean() const;
  std::string string() const;
  /// Index of the string in `choices`.
  std::size_t choice(const std::vector<std::string_view>& choices) const;
  /// Throws where a map has a key that is not in `allowed`: most often a typing error that would be ignored.
  void allow_only(const std::vector<std::string_view>& allowed) const;

  [[noreturn]] void fail(Message what_happened) const;
  Message described() const;  ///< what stands there, for messages: "a map", or the text in quotes

 private:
  DocumentView(const DocumentNode& node, std::string_view file, std::string key_path)
      : node_(&node), file_(file), key_path_(std::move(key_path)) {}

  const DocumentNode* node_;
  std::string file_;
  std::string key_path_;
};

}  // namespace remount::formats
