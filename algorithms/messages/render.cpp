#include "algorithms/messages/render.h"

#include <algorithm>
#include <ostream>

#include "algorithms/messages/quantity_text.h"
#include "algorithms/messages/sentence_pieces.h"

namespace remount {
namespace {

/// How a language joins what follows each other.
struct Joints {
  std::string_view comma, before_last, between_sentences;
};
constexpr std::array<Joints, kLanguages> kJoints{{{", ", " and ", " "}, {"、", "和", ""}}};

const Joints& joints(Language language) { return kJoints[static_cast<std::size_t>(language)]; }

std::string joined(const std::vector<std::string>& parts, std::string_view style, Language language) {
  const Joints& by = joints(language);
  const std::string_view between = style == "lines" ? "\n" : style == "sentences" ? by.between_sentences : by.comma;
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += style == "and" && i + 1 == parts.size() ? by.before_last : between;
    text += parts[i];
  }
  return text;
}

std::vector<std::string> rendered(const std::vector<Message>& messages, Language language) {
  std::vector<std::string> texts;
  texts.reserve(messages.size());
  for (const Message& message : messages) texts.push_back(render(message, language));
  return texts;
}

struct ArgumentText {
  std::string_view style;
  Language language;

  std::string operator()(const Quantity& quantity) const { return quantity_text(quantity, style, language); }
  std::string operator()(std::int64_t count) const { return std::to_string(count); }
  std::string operator()(const std::string& words) const { return words; }
  std::string operator()(const std::vector<std::string>& names) const { return joined(names, style, language); }
  std::string operator()(const Message& message) const { return render(message, language); }
  std::string operator()(const std::vector<Message>& messages) const {
    return joined(rendered(messages, language), style, language);
  }
};

std::string argument_text(const Argument& argument, std::string_view style, Language language) {
  return std::visit(ArgumentText{style, language}, argument.value);
}

/// The places of other languages are shown as the first one says.
std::string_view style_of(const SentencePiece& place, const std::vector<SentencePiece>& first_language) {
  if (!place.style.empty()) return place.style;
  const auto same = std::find_if(first_language.begin(), first_language.end(), [&](const SentencePiece& piece) {
    return piece.kind == SentencePiece::Kind::Place && piece.name == place.name;
  });
  return same == first_language.end() ? std::string_view() : std::string_view(same->style);
}

bool is_one(const Argument& argument) {
  const auto* count = std::get_if<std::int64_t>(&argument.value);
  return count != nullptr && *count == 1;
}

std::string without_entry(const Message& message, Language language) {
  std::vector<std::string> parts;
  for (const Argument& argument : message.arguments())
    parts.push_back(argument.name + " " + argument_text(argument, {}, language));
  return parts.empty() ? message.code() : message.code() + " (" + joined(parts, {}, language) + ")";
}

std::string of_entry(const CatalogueEntry& entry, const Message& message, Language language) {
  const SentencePieces first = sentence_pieces(entry.text.front());
  const SentencePieces sentence = sentence_pieces(entry.text[static_cast<std::size_t>(language)]);
  std::string text;
  for (const SentencePiece& piece : sentence.pieces) {
    if (piece.kind == SentencePiece::Kind::Words) {
      text += piece.words;
      continue;
    }
    const Argument* argument = message.argument(piece.name);
    if (argument == nullptr) {
      text += "{" + piece.name + "}";  // of a file that was changed by hand
    } else if (piece.kind == SentencePiece::Kind::Choice) {
      text += is_one(*argument) ? piece.one : piece.other;
    } else {
      text += argument_text(*argument, style_of(piece, first.pieces), language);
    }
  }
  return text;
}

}  // namespace

std::string render(const Message& message, Language language) {
  if (message.empty()) return {};
  if (message.code() == kVerbatim || message.code() == kSequence) {
    const Argument* words = message.argument(kOnlyPlace);
    return words == nullptr ? std::string() : argument_text(*words, "sentences", language);
  }
  const CatalogueEntry* entry = find_in_catalogue(message.code());
  return entry == nullptr ? without_entry(message, language) : of_entry(*entry, message, language);
}

std::string english(const Message& message) { return render(message, Language::English); }

std::vector<std::string> english(const std::vector<Message>& messages) { return rendered(messages, Language::English); }

std::ostream& operator<<(std::ostream& stream, const Message& message) { return stream << english(message); }

Language language_of(std::string_view tag) { return tag.starts_with("zh") ? Language::Chinese : Language::English; }

}  // namespace remount
