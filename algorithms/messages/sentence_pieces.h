// The text of a catalogue, taken apart: words, places and choices. For the renderer, and for what compiles the
// catalogue.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/messages/message.h"

namespace remount {

/// What may stand in a place.
enum class PlaceKind { Quantity, Count, Text, Texts, Message, Messages };

/// @return nothing where no kind has that name
struct PlaceType {
  std::string_view name;  ///< as catalogues write it: "length"
  PlaceKind kind;
  Dimension dimension;         ///< of a quantity
  std::string_view parameter;  ///< of the maker, in C++
};
const PlaceType* find_place_type(std::string_view name);

struct SentencePiece {
  enum class Kind { Words, Place, Choice } kind = Kind::Words;
  std::string words;  ///< of Words
  std::string name;   ///< of the place
  std::string type;   ///< "length"; empty where the first language says it
  std::string style;
  std::string one, other;  ///< of a choice: for a count of one, and for all others
};

struct SentencePieces {
  std::vector<SentencePiece> pieces;
  std::string problem;  ///< what is wrong with the text; empty where nothing is
};

/// "{name:type,style}", "{name}", "{name?one|other}"; "{{" and "}}" are braces.
SentencePieces sentence_pieces(std::string_view text);

/// How lists are joined, by style: "" with commas, "and" with a word before the last, "lines", "sentences".
bool is_list_style(std::string_view style);

}  // namespace remount
