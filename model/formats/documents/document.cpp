#include "model/formats/documents/document.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "algorithms/core/error.h"
#include "messages/files.h"

namespace remount::formats {

std::string shortest(double value) {
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value);
  return std::string(buffer, end.ptr);
}

DocumentNode DocumentNode::plain(std::string text) {
  DocumentNode node = of_kind(Kind::Plain);
  node.text = std::move(text);
  return node;
}

DocumentNode DocumentNode::of_kind(Kind kind) {
  DocumentNode node;
  node.kind = kind;
  return node;
}

DocumentNode DocumentNode::number(double value) { return std::isfinite(value) ? plain(shortest(value)) : null(); }

DocumentNode DocumentNode::string(std::string_view value) {
  DocumentNode node = of_kind(Kind::String);
  node.text = value;
  return node;
}

DocumentNode DocumentNode::numbers(const std::vector<double>& values) {
  DocumentNode node = sequence();
  node.on_one_line = true;
  for (const double value : values) node.add(number(value));
  return node;
}

DocumentNode& DocumentNode::add(std::string key, DocumentNode value) {
  keys.push_back(std::move(key));
  items.push_back(std::move(value));
  return items.back();
}

DocumentNode& DocumentNode::add(DocumentNode value) {
  items.push_back(std::move(value));
  return items.back();
}

const DocumentNode* DocumentNode::find(std::string_view key) const {
  if (kind != Kind::Map) return nullptr;
  const auto found = std::find(keys.begin(), keys.end(), key);
  return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

void DocumentView::fail(Message what_happened) const {
  throw Error(ErrorCode::Format, node_->line > 0 ? file_ + ":" + std::to_string(node_->line) : file_,
              key_path_.empty() ? what_happened : say::document_at_key(key_path_, what_happened));
}

Message DocumentView::described() const {
  switch (node_->kind) {
    case DocumentNode::Kind::Null:
      return say::document_nothing();
    case DocumentNode::Kind::Sequence:
      return say::document_a_list(node_->items.size());
    case DocumentNode::Kind::Map:
      return say::document_a_map();
    default:
      break;
  }
  return say::document_a_value(node_->text.size() > 60 ? node_->text.substr(0, 60) + "..." : node_->text);
}

DocumentView DocumentView::at(std::string_view key) const {
  if (!is_map()) fail(say::document_expected_map_with(std::string(key), described()));
  const DocumentNode* value = node_->find(key);
  if (value == nullptr) fail(say::document_key_missing(std::string(key)));
  return {*value, file_, key_path_.empty() ? std::string(key) : key_path_ + "." + std::string(key)};
}

std::vector<DocumentView> DocumentView::items() const {
  if (!is_sequence()) fail(say::document_expected_list(described()));
  std::vector<DocumentView> views;
  for (std::size_t i = 0; i < node_->items.size(); ++i)
    views.push_back({node_->items[i], file_, key_path_ + "[" + std::to_string(i) + "]"});
  return views;
}

std::vector<std::pair<std::string, DocumentView>> DocumentView::entries() const {
  if (!is_map()) fail(say::document_expected_map(described()));
  std::vector<std::pair<std::string, DocumentView>> views;
  for (std::size_t i = 0; i < node_->items.size(); ++i)
    views.emplace_back(
        node_->keys[i],
        DocumentView(node_->items[i], file_, key_path_.empty() ? node_->keys[i] : key_path_ + "." + node_->keys[i]));
  return views;
}

std::optional<DocumentView> DocumentView::find(std::string_view key) const {
  return has(key) ? std::optional<DocumentView>(at(key)) : std::nullopt;
}

double DocumentView::number_or_nan() const { return is_null() ? std::numeric_limits<double>::quiet_NaN() : number(); }

double DocumentView::number() const {
  double value = 0.0;
  const char* begin = node_->text.data();
  const char* end = begin + node_->text.size();
  if (node_->text.size() > 1 && *begin == '+') ++begin;
  const auto parsed = std::from_chars(begin, end, value);
  if (node_->kind != DocumentNode::Kind::Plain || parsed.ec != std::errc() || parsed.ptr != end ||
      !std::isfinite(value))
    fail(say::document_expected_number(described()));
  return value;
}

std::vector<double> DocumentView::numbers(std::size_t count) const {
  if (!is_sequence() || node_->items.size() != count) fail(say::document_expected_numbers(count, described()));
  std::vector<double> values;
  for (const DocumentView& item : items()) values.push_back(item.number());
  return values;
}

std::int64_t DocumentView::integer(std::int64_t minimum, std::int64_t maximum) const {
  std::int64_t value = 0;
  const char* end = node_->text.data() + node_->text.size();
  const auto parsed = std::from_chars(node_->text.data(), end, value);
  if (node_->kind != DocumentNode::Kind::Plain || parsed.ec != std::errc() || parsed.ptr != end || value < minimum ||
      value > maximum)
    fail(say::document_expected_integer(minimum, maximum, described()));
  return value;
}

bool DocumentView::boolean() const {
  if (node_->kind == DocumentNode::Kind::Plain && node_->text == "true") return true;
  if (node_->kind == DocumentNode::Kind::Plain && node_->text == "false") return false;
  fail(say::document_expected_boolean(described()));
}

std::string DocumentView::string() const {
  if (node_->kind != DocumentNode::Kind::Plain && node_->kind != DocumentNode::Kind::String)
    fail(say::document_expected_text(described()));
  return node_->text;
}

std::size_t DocumentView::choice(const std::vector<std::string_view>& choices) const {
  const std::string text = string();
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (choices[i] == text) return i;
  fail(say::document_expected_one_of({choices.begin(), choices.end()}, described()));
}

void DocumentView::allow_only(const std::vector<std::string_view>& allowed) const {
  for (const auto& [key, value] : entries()) {
    if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) continue;
    value.fail(say::document_unknown_key({allowed.begin(), allowed.end()}));
  }
}

}  // namespace remount::formats
