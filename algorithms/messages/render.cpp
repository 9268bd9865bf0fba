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

/// A sentence of the catalogue taken apart, in all languages; places of others are shown as the first one says.
using ParsedSentence = std::array<std::vector<SentencePiece>, kLanguages>;

std::string_view style_in(const std::vector<SentencePiece>& sentence, const std::string& name) {
  const auto same = std::find_if(sentence.begin(), sentence.end(), [&](const SentencePiece& piece) {
    return piece.kind == SentencePiece::Kind::Place && piece.name == name;
  });
  return same == sentence.end() ? std::string_view() : std::string_view(same->style);
}

ParsedSentence parsed(const CatalogueEntry& entry) {
  ParsedSentence sentence;
  for (std::size_t i = 0; i < kLanguages; ++i) {
    sentence[i] = sentence_pieces(entry.text[i]).pieces;
    for (SentencePiece& piece : sentence[i])
      if (piece.style.empty()) piece.style = style_in(sentence.front(), piece.name);
  }
  return sentence;
}

/// Taken apart once: tables show tens of thousands of messages.
const ParsedSentence& parsed_sentence(const CatalogueEntry& entry) {
  static const std::vector<ParsedSentence> all = [] {
    std::vector<ParsedSentence> sentences;
    sentences.reserve(catalogue().size());
    for (const CatalogueEntry& one : catalogue()) sentences.push_back(parsed(one));
    return sentences;
  }();
  return all[static_cast<std::size_t>(&entry - catalogue().data())];
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
  std::string text;
  for (const SentencePiece& piece : parsed_sentence(entry)[static_cast<std::size_t>(language)]) {
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
      text += argument_text(*argument, piece.style, language);
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
