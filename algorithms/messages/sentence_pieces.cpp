#include "algorithms/messages/sentence_pieces.h"

#include <algorithm>
#include <array>
#include <utility>

namespace remount {
namespace {

constexpr PlaceType kTypes[] = {
    {"length", PlaceKind::Quantity, Dimension::Length, "Length"},
    {"angle", PlaceKind::Quantity, Dimension::Angle, "Angle"},
    {"time", PlaceKind::Quantity, Dimension::Duration, "Duration"},
    {"speed", PlaceKind::Quantity, Dimension::Speed, "Speed"},
    {"turn-rate", PlaceKind::Quantity, Dimension::TurnRate, "TurnRate"},
    {"acceleration", PlaceKind::Quantity, Dimension::Acceleration, "Acceleration"},
    {"frequency", PlaceKind::Quantity, Dimension::Frequency, "Frequency"},
    {"share", PlaceKind::Quantity, Dimension::Share, "Share"},
    {"bytes", PlaceKind::Quantity, Dimension::Bytes, "Bytes"},
    {"number", PlaceKind::Quantity, Dimension::Number, "double"},
    {"count", PlaceKind::Count, Dimension::Number, "Count"},
    {"text", PlaceKind::Text, Dimension::Number, "std::string"},
    {"texts", PlaceKind::Texts, Dimension::Number, "std::vector<std::string>"},
    {"message", PlaceKind::Message, Dimension::Number, "Message"},
    {"messages", PlaceKind::Messages, Dimension::Number, "std::vector<Message>"},
};

bool is_name(std::string_view text) {
  return !text.empty() && text.front() >= 'a' && text.front() <= 'z' &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string_view::npos;
}

/// What stands between braces. @return false where it is nothing that the grammar knows
bool read_place(std::string_view inside, SentencePiece& piece) {
  if (const std::size_t question = inside.find('?'); question != std::string_view::npos) {
    const std::size_t bar = inside.find('|', question);
    if (bar == std::string_view::npos) return false;
    piece.kind = SentencePiece::Kind::Choice;
    piece.name = std::string(inside.substr(0, question));
    piece.one = std::string(inside.substr(question + 1, bar - question - 1));
    piece.other = std::string(inside.substr(bar + 1));
    return is_name(piece.name);
  }
  piece.kind = SentencePiece::Kind::Place;
  const std::size_t colon = inside.find(':');
  piece.name = std::string(inside.substr(0, colon));
  if (colon == std::string_view::npos) return is_name(piece.name);
  const std::string_view rest = inside.substr(colon + 1);
  const std::size_t comma = rest.find(',');
  piece.type = std::string(rest.substr(0, comma));
  if (comma != std::string_view::npos) piece.style = std::string(rest.substr(comma + 1));
  return is_name(piece.name) && find_place_type(piece.type) != nullptr;
}

}  // namespace

const PlaceType* find_place_type(std::string_view name) {
  const auto* found =
      std::find_if(std::begin(kTypes), std::end(kTypes), [name](const PlaceType& type) { return type.name == name; });
  return found == std::end(kTypes) ? nullptr : found;
}

bool is_list_style(std::string_view style) {
  constexpr std::array<std::string_view, 4> kStyles{"", "and", "lines", "sentences"};
  return std::find(kStyles.begin(), kStyles.end(), style) != kStyles.end();
}

SentencePieces sentence_pieces(std::string_view text) {
  SentencePieces result;
  std::string words;
  const auto end_words = [&] {
    if (words.empty()) return;
    SentencePiece piece;
    piece.words = std::exchange(words, {});
    result.pieces.push_back(std::move(piece));
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if ((c == '{' || c == '}') && i + 1 < text.size() && text[i + 1] == c) {
      words += c;
      ++i;
    } else if (c == '}') {
      result.problem = "a '}' without a '{' before it";
      return result;
    } else if (c == '{') {
      const std::size_t end = text.find('}', i);
      SentencePiece piece;
      if (end == std::string_view::npos || !read_place(text.substr(i + 1, end - i - 1), piece)) {
        result.problem = "no place: " + std::string(text.substr(i, end == std::string_view::npos ? end : end - i + 1));
        return result;
      }
      end_words();
      result.pieces.push_back(std::move(piece));
      i = end;
    } else {
      words += c;
    }
  }
  end_words();
  return result;
}

}  // namespace remount
