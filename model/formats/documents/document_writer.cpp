// Text of a document tree: JSON and YAML, the same bytes for the same tree.
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "model/formats/documents/document.h"

namespace remount::formats {
namespace {

using Kind = DocumentNode::Kind;

/// A JSON string, which is a YAML double-quoted string as well. Bytes that are not valid UTF-8 are replaced.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte == '"' || byte == '\\') {
      out += '\\';
      out += text[i++];
    } else if (byte < 0x20 || byte == 0x7f) {
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\u%04x", byte);
      out += escape.data();
      ++i;
    } else if (byte < 0x80) {
      out += text[i++];
    } else {
      const std::size_t length = byte >= 0xf0 && byte < 0xf5   ? 4
                                 : byte >= 0xe0 && byte < 0xf0 ? 3
                                 : byte >= 0xc2 && byte < 0xe0 ? 2
                                                               : 0;
      bool valid = length > 0 && i + length <= text.size();
      for (std::size_t k = 1; valid && k < length; ++k)
        valid = (static_cast<unsigned char>(text[i + k]) & 0xc0) == 0x80;
      // Overlong forms and surrogates, which strict readers refuse.
      if (valid && length > 2) {
        const auto next = static_cast<unsigned char>(text[i + 1]);
        valid = !(byte == 0xe0 && next < 0xa0) && !(byte == 0xed && next >= 0xa0) && !(byte == 0xf0 && next < 0x90) &&
                !(byte == 0xf4 && next >= 0x90);
      }
      out += valid ? text.substr(i, length) : "\xef\xbf\xbd";
      i += valid ? length : 1;
    }
  }
  return out + "\"";
}

/// Whether YAML reads the text as a string without quotes. Only plain words: everything doubtful is quoted.
bool is_bare_word(const std::string& text) {
  static constexpr std::array<std::string_view, 10> kReserved{"true", "false", "null", "yes", "no",
                                                              "on",   "off",   "nan",  "inf", "infinity"};
  if (text.empty() || text.size() > 60) return false;
  std::string lower;
  for (const char c : text) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool inner = (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
    if (!letter && !(inner && !lower.empty()) && !(c == '_' && lower.empty())) return false;
    lower += letter ? static_cast<char>(c | 0x20) : c;
  }
  for (const std::string_view word : kReserved)
    if (lower == word) return false;
  return true;
}

/// What both formats hold without quotes. Other plain text ("-", "x/1") comes from files: one format's may break
/// another.
bool is_number_or_boolean(const std::string& text) {
  if (text == "true" || text == "false") return true;
  const bool begins = !text.empty() && (text.front() == '-' || (text.front() >= '0' && text.front() <= '9'));
  return begins && nlohmann::json::accept(text);
}

std::string word(const std::string& text) { return is_bare_word(text) ? text : quoted(text); }

bool is_container(const DocumentNode& node) { return node.kind == Kind::Sequence || node.kind == Kind::Map; }

bool on_one_line(const DocumentNode& node) {
  if (!is_container(node) || node.on_one_line || node.items.empty()) return true;
  if (node.kind == Kind::Map) return false;
  for (const DocumentNode& item : node.items)
    if (is_container(item)) return false;
  return true;
}

std::string scalar(const DocumentNode& node, bool yaml) {
  if (node.kind == Kind::Null) return "null";
  if (node.kind == Kind::Plain && is_number_or_boolean(node.text)) return node.text;
  return yaml ? word(node.text) : quoted(node.text);
}

void write_line(std::ostream& out, const DocumentNode& node, bool yaml) {
  if (!is_container(node)) {
    out << scalar(node, yaml);
    return;
  }
  const bool map = node.kind == Kind::Map;
  out << (map ? '{' : '[');
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    if (i > 0) out << ", ";
    if (map) out << (yaml ? word(node.keys[i]) : quoted(node.keys[i])) << ": ";
    write_line(out, node.items[i], yaml);
  }
  out << (map ? '}' : ']');
}

void write_json(std::ostream& out, const DocumentNode& node, std::size_t depth) {
  if (on_one_line(node)) {
    write_line(out, node, false);
    return;
  }
  const bool map = node.kind == Kind::Map;
  const std::string indent(2 * (depth + 1), ' ');
  out << (map ? "{\n" : "[\n");
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    out << indent;
    if (map) out << quoted(node.keys[i]) << ": ";
    write_json(out, node.items[i], depth + 1);
    out << (i + 1 < node.items.size() ? ",\n" : "\n");
  }
  out << std::string(2 * depth, ' ') << (map ? '}' : ']');
}

void write_comment(std::ostream& out, const std::string& comment, const std::string& indent) {
  if (comment.empty()) return;
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);) out << indent << (line.empty() ? "#" : "# " + line) << "\n";
}

/// The lines of a block container, each beginning with `indent`, the first with `first_indent` (after "- ").
void write_yaml(std::ostream& out, const DocumentNode& node, const std::string& first_indent,
                const std::string& indent) {
  const bool map = node.kind == Kind::Map;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const DocumentNode& item = node.items[i];
    const bool first = i == 0 && first_indent != indent;
    if (!first) write_comment(out, item.comment, indent);
    out << (first ? first_indent : indent) << (map ? word(node.keys[i]) + ":" : "-");
    if (on_one_line(item)) {
      out << ' ';
      write_line(out, item, true);
      out << '\n';
    } else if (map) {
      out << '\n';
      write_yaml(out, item, indent + "  ", indent + "  ");
    } else {
      write_yaml(out, item, " ", indent + "  ");
    }
  }
}

}  // namespace

std::string to_json(const DocumentNode& node) {
  std::ostringstream out;
  write_json(out, node, 0);
  out << '\n';
  return out.str();
}

std::string to_yaml(const DocumentNode& node) {
  std::ostringstream out;
  write_comment(out, node.comment, "");
  if (on_one_line(node)) {
    write_line(out, node, true);
    out << '\n';
  } else {
    write_yaml(out, node, "", "");
  }
  return out.str();
}

}  // namespace remount::formats
