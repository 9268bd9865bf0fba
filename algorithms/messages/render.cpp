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

std::string_view joint_of(std::string_view style, bool before_last, Language language) {
  const Joints& by = kJoints[static_cast<std::size_t>(language)];
  if (style == "lines") return "\n";
  if (style == "sentences") return by.between_sentences;
  return style == "and" && before_last ? by.before_last : by.comma;
}

template <class List, class Say>
void say_all(const List& list, std::string_view style, Language language, RenderedMessage& out, const Say& say) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0) out.words(joint_of(style, i + 1 == list.size(), language));
    say(list[i]);
  }
}

struct ArgumentSaid {
  std::string_view style;
  Language language;
  RenderedMessage& out;

  void operator()(const Quantity& quantity) const {
    const QuantityText text = quantity_text(quantity, style, language);
    out.number(text.digits);
    out.words(text.unit);
  }
  void operator()(std::int64_t count) const { out.number(std::to_string(count)); }
  void operator()(const std::string& words) const { out.words(words); }
  void operator()(const std::vector<std::string>& names) const {
    say_all(names, style, language, out, [this](const std::string& name) { out.words(name); });
  }
  void operator()(const Message& message) const { render(message, language, out); }
  void operator()(const std::vector<Message>& messages) const {
    say_all(messages, style, language, out, [this](const Message& message) { render(message, language, out); });
  }
};

void say(const Argument& argument, std::string_view style, Language language, RenderedMessage& out) {
  std::visit(ArgumentSaid{style, language, out}, argument.value);
}

/// A sentence of the catalogue taken apart, in all languages; places of others are shown as the first one says.
using ParsedSentence = std::array<std::vector<SentencePiece>, kLanguages>;

std::string_view style_in(const std::vector<SentencePiece>& sentence, const std::string& name) {
  const auto same = std::find_if(sentence.begin(), sentence.end(), [&](const SentencePiece& piece) {
    return piece.kind == SentencePiece::Kind::Place && piece.name == name;
  });
  return same == sentence.end() ? std::string_view() : std::string_view(same->style);
}

ParsedSentence parse(const CatalogueEntry& entry) {
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
    for (const CatalogueEntry& one : catalogue()) sentences.push_back(parse(one));
    return sentences;
  }();
  return all[static_cast<std::size_t>(&entry - catalogue().data())];
}

bool is_one(const Argument& argument) {
  const auto* count = std::get_if<std::int64_t>(&argument.value);
  return count != nullptr && *count == 1;
}

void say_without_entry(const Message& message, Language language, RenderedMessage& out) {
  out.words(message.code());
  if (message.arguments().empty()) return;
  out.words(" (");
  say_all(message.arguments(), {}, language, out, [&](const Argument& argument) {
    out.words(argument.name + " ");
    say(argument, {}, language, out);
  });
  out.words(")");
}

void say_entry(const CatalogueEntry& entry, const Message& message, Language language, RenderedMessage& out) {
  for (const SentencePiece& piece : parsed_sentence(entry)[static_cast<std::size_t>(language)]) {
    if (piece.kind == SentencePiece::Kind::Words) {
      out.words(piece.words);
      continue;
    }
    const Argument* argument = message.argument(piece.name);
    if (argument == nullptr) {
      out.words("{" + piece.name + "}");  // of a file that was changed by hand
    } else if (piece.kind == SentencePiece::Kind::Choice) {
      out.words(is_one(*argument) ? piece.one : piece.other);
    } else {
      say(*argument, piece.style, language, out);
    }
  }
}

struct AsText : RenderedMessage {
  void words(std::string_view said) override { text += said; }
  void number(std::string_view digits) override { text += digits; }
  std::string text;
};

}  // namespace

void render(const Message& message, Language language, RenderedMessage& out) {
  if (message.empty()) return;
  if (message.code() == kVerbatim || message.code() == kSequence) {
    if (const Argument* words = message.argument(kOnlyPlace)) say(*words, "sentences", language, out);
    return;
  }
  const CatalogueEntry* entry = find_in_catalogue(message.code());
  if (entry == nullptr)
    say_without_entry(message, language, out);
  else
    say_entry(*entry, message, language, out);
}

std::string render(const Message& message, Language language) {
  AsText out;
  render(message, language, out);
  return std::move(out.text);
}

std::string english(const Message& message) { return render(message, Language::English); }

std::vector<std::string> english(const std::vector<Message>& messages) {
  std::vector<std::string> texts;
  texts.reserve(messages.size());
  for (const Message& message : messages) texts.push_back(english(message));
  return texts;
}

std::ostream& operator<<(std::ostream& stream, const Message& message) { return stream << english(message); }

Language language_of(std::string_view tag) { return tag.starts_with("zh") ? Language::Chinese : Language::English; }

}  // namespace remount
