// Compiles the catalogue of messages: `make_messages header FILE OUT` writes the typed makers of one file,
// `make_messages table OUT FILE...` the table of all sentences. What is wrong ends the build with file and line.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

#include "algorithms/messages/catalogue.h"
#include "algorithms/messages/quantity_text.h"
#include "algorithms/messages/sentence_pieces.h"

namespace remount {
namespace {

struct SourceEntry {
  std::string place;  // "pairs.txt:12"
  std::string code;
  std::array<std::string, kLanguages> text;
  bool advises = false;
};

/// Behind the code of an entry: resources/messages/README.md says what it means.
constexpr std::string_view kAdvises = " advises";

[[noreturn]] void fail(const std::string& place, const std::string& what) {
  throw std::runtime_error(place + ": error: " + what);
}

bool is_code(const std::string& code) {
  return !code.empty() && code.front() >= 'a' && code.front() <= 'z' && code.back() != '-' &&
         code.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos && code != kVerbatim &&
         code != kSequence;
}

/// The text of a line that begins with one of the languages' tags.
std::string* language_line(SourceEntry& entry, std::string_view line, std::string_view& text) {
  for (std::size_t i = 0; i < kLanguages; ++i) {
    const std::string head = std::string(kLanguageTags[i]) + ":";
    if (!line.starts_with(head)) continue;
    text = line.substr(head.size());
    return &entry.text[i];
  }
  return nullptr;
}

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(" \r");
  return first == std::string_view::npos ? std::string_view() : text.substr(first, last - first + 1);
}

bool ends_in_chinese(std::string_view text) {
  return text.size() >= 3 && text[text.size() - 3] >= '\xe4' && text[text.size() - 3] <= '\xe9';
}

/// Chinese and Latin letters or numbers, and places, have a space between them; marks of either have none.
bool stand_apart(std::string_view before, std::string_view after) {
  const auto is_latin = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  };
  const bool begins_in_chinese = after.front() >= '\xe4' && after.front() <= '\xe9';
  return (ends_in_chinese(before) && (is_latin(after.front()) || after.front() == '{')) ||
         (begins_in_chinese && (is_latin(before.back()) || before.back() == '}')) ||
         (is_latin(before.back()) && is_latin(after.front()));
}

SourceEntry begun(const std::string& place, std::string_view head) {
  const bool advises = head.ends_with(kAdvises);
  if (advises) head.remove_suffix(kAdvises.size());
  std::string code(trim(head));
  if (!is_code(code)) fail(place, "no code: lower case letters, digits and '-'");
  return {place, std::move(code), {}, advises};
}

/// A code at the beginning of a line, and below it, indented, a text for each language; one that begins with none of
/// their tags goes on the line before.
std::vector<SourceEntry> read_source(const std::string& path) {
  std::ifstream file(path);
  if (!file) fail(path, "cannot be read");
  std::vector<SourceEntry> entries;
  std::string* open = nullptr;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    const std::string place = path + ":" + std::to_string(number);
    std::string_view words = trim(line);
    if (words.empty() || line.front() == '#') continue;
    if (line.front() != ' ') {
      entries.push_back(begun(place, words));
      open = nullptr;
      continue;
    }
    if (entries.empty()) fail(place, "a text before the first code");
    std::string_view text = words;
    if (std::string* in_language = language_line(entries.back(), words, text)) {
      if (!in_language->empty()) fail(place, "this language a second time");
      open = in_language;
    } else if (open == nullptr) {
      fail(place, "a text begins with a language: \"en:\" or \"zh_CN:\"");
    }
    const std::string_view more = trim(text);
    const bool is_first_language = open == &entries.back().text[0];
    if (!open->empty() && !more.empty() && (is_first_language || stand_apart(*open, more))) *open += ' ';
    *open += more;
  }
  return entries;
}

/// Places by name, with what the first language says of each.
using Places = std::map<std::string, const PlaceType*>;

void check_style(const SourceEntry& entry, const SentencePiece& piece, const PlaceType& type) {
  const bool fits = type.kind == PlaceKind::Quantity ? is_quantity_style(type.dimension, piece.style)
                    : type.kind == PlaceKind::Texts || type.kind == PlaceKind::Messages ? is_list_style(piece.style)
                                                                                        : piece.style.empty();
  if (!fits) fail(entry.place, "no style of " + piece.type + ": " + piece.style);
}

/// In the order of the first language.
std::vector<std::pair<std::string, const PlaceType*>> places_of(const SourceEntry& entry) {
  const SentencePieces sentence = sentence_pieces(entry.text[0]);
  if (!sentence.problem.empty()) fail(entry.place, sentence.problem);
  std::vector<std::pair<std::string, const PlaceType*>> places;
  const auto known = [&](const std::string& name) {
    return std::any_of(places.begin(), places.end(), [&](const auto& place) { return place.first == name; });
  };
  for (const SentencePiece& piece : sentence.pieces) {
    if (piece.kind != SentencePiece::Kind::Place) continue;
    if (piece.type.empty()) {
      if (!known(piece.name)) fail(entry.place, "{" + piece.name + "} needs a type: {" + piece.name + ":length}");
      continue;
    }
    const PlaceType* type = find_place_type(piece.type);
    check_style(entry, piece, *type);
    if (!known(piece.name)) places.emplace_back(piece.name, type);
  }
  // What only chooses words is a count as well.
  for (const SentencePiece& piece : sentence.pieces)
    if (piece.kind == SentencePiece::Kind::Choice && !known(piece.name))
      places.emplace_back(piece.name, find_place_type("count"));
  return places;
}

void check_other_language(const SourceEntry& entry, std::size_t language, const Places& places) {
  const std::string tag(kLanguageTags[language]);
  if (entry.text[language].empty()) fail(entry.place, entry.code + " has no text in " + tag);
  const SentencePieces sentence = sentence_pieces(entry.text[language]);
  if (!sentence.problem.empty()) fail(entry.place, tag + ": " + sentence.problem);
  std::map<std::string, bool> met;
  for (const SentencePiece& piece : sentence.pieces) {
    if (piece.kind == SentencePiece::Kind::Words) continue;
    if (!places.contains(piece.name)) fail(entry.place, tag + " has a place that en has not: " + piece.name);
    met[piece.name] = true;
  }
  for (const SentencePiece& piece : sentence_pieces(entry.text[0]).pieces)
    if (piece.kind == SentencePiece::Kind::Place && !met[piece.name])
      fail(entry.place, tag + " lacks the place " + piece.name);
}

void check(const SourceEntry& entry) {
  if (entry.text[0].empty()) fail(entry.place, entry.code + " has no text in en");
  Places places;
  for (const auto& [name, type] : places_of(entry)) places[name] = type;
  for (std::size_t language = 1; language < kLanguages; ++language) check_other_language(entry, language, places);
}

std::string maker_name(std::string code) {
  std::replace(code.begin(), code.end(), '-', '_');
  return code;
}

bool moves(const PlaceType& type) { return type.kind != PlaceKind::Quantity && type.kind != PlaceKind::Count; }

std::string maker(const SourceEntry& entry) {
  std::string parameters, arguments;
  for (const auto& [name, type] : places_of(entry)) {
    if (!parameters.empty()) parameters += ", ", arguments += ", ";
    parameters += std::string(type->parameter) + " " + name;
    arguments += "{\"" + name + "\", value_of(" + (moves(*type) ? "std::move(" + name + ")" : name) + ")}";
  }
  return "/// " + entry.text[0] + "\ninline Message " + maker_name(entry.code) + "(" + parameters +
         ") {\n  return {\"" + entry.code + "\", {" + arguments + "}};\n}\n";
}

std::string header_of(const std::string& path) {
  std::string text = "// Made of " + path.substr(path.find_last_of('/') + 1) +
                     " by the build.\n#pragma once\n\n#include <utility>\n\n#include "
                     "\"algorithms/messages/message.h\"\n\nnamespace remount::say {\n\n";
  for (const SourceEntry& entry : read_source(path)) {
    check(entry);
    text += maker(entry) + "\n";
  }
  return text + "}  // namespace remount::say\n";
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  // "\n" is written as such in catalogues.
  for (std::size_t at = result.find("\\\\n"); at != std::string::npos; at = result.find("\\\\n", at + 1))
    result.replace(at, 3, "\\n");
  return result + "\"";
}

std::string table_of(const std::vector<std::string>& paths) {
  std::vector<SourceEntry> all;
  for (const std::string& path : paths)
    for (SourceEntry& entry : read_source(path)) {
      check(entry);
      all.push_back(std::move(entry));
    }
  std::sort(all.begin(), all.end(), [](const SourceEntry& a, const SourceEntry& b) { return a.code < b.code; });
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].code == all[i - 1].code) fail(all[i].place, all[i].code + " is at " + all[i - 1].place + " as well");
  std::string text =
      "// Made of resources/messages/ by the build.\n#include \"algorithms/messages/catalogue.h\"\n\nnamespace remount "
      "{\n\nstd::span<const CatalogueEntry> catalogue() {\n  using namespace std::string_view_literals;\n  static "
      "constexpr CatalogueEntry kAll[] = {\n";
  // Literals that know their length: a compiler that had to count all these letters would take more steps than clang
  // allows a constant.
  for (const SourceEntry& entry : all) {
    text += "      {\"" + entry.code + "\"sv, {";
    for (std::size_t i = 0; i < kLanguages; ++i) text += (i > 0 ? ", " : "") + quoted(entry.text[i]) + "sv";
    text += entry.advises ? "}, true},\n" : "}},\n";
  }
  return text + "  };\n  return kAll;\n}\n\n}  // namespace remount\n";
}

/// What has not changed is left as it is, so that nothing is compiled anew for it.
void write_if_changed(const std::string& path, const std::string& text) {
  std::stringstream old;
  if (std::ifstream file(path); file) old << file.rdbuf();
  if (old.str() == text) return;
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) fail(path, "cannot be written");
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.size() == 3 && arguments[0] == "header") {
    write_if_changed(arguments[2], header_of(arguments[1]));
  } else if (arguments.size() >= 3 && arguments[0] == "table") {
    write_if_changed(arguments[1], table_of({arguments.begin() + 2, arguments.end()}));
  } else {
    std::fprintf(stderr, "make_messages header FILE OUT | make_messages table OUT FILE...\n");
    return 2;
  }
  return 0;
}

}  // namespace
}  // namespace remount

int main(int argc, char** argv) {
  try {
    return remount::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
