#include "algorithms/messages/render.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "algorithms/messages/quantity_text.h"
#include "algorithms/messages/sentence_pieces.h"
#include "messages/general.h"

namespace remount {
namespace {

TEST(render, places_hold_names_and_messages) {
  const Message inner = Message::verbatim("a user's words, 50% {of} them");
  const Message message = say::of_file("drive.csv", inner);
  EXPECT_EQ(english(message), "drive.csv: a user's words, 50% {of} them");
  EXPECT_EQ(render(message, Language::Chinese), "drive.csv：a user's words, 50% {of} them");
}

TEST(render, says_nothing_for_nothing) {
  EXPECT_TRUE(Message().empty());
  EXPECT_EQ(english(Message()), "");
  EXPECT_TRUE(Message::verbatim("").empty());
  EXPECT_TRUE(Message::sequence({Message(), Message()}).empty());
}

TEST(render, sentences_are_joined_as_the_language_does) {
  const Message both = Message::sequence({Message::verbatim("One."), Message(), Message::verbatim("Two.")});
  EXPECT_EQ(english(both), "One. Two.");
  EXPECT_EQ(render(both, Language::Chinese), "One.Two.");
}

TEST(render, a_code_of_a_later_version_is_shown_with_its_arguments) {
  const Message later("of-a-later-version", {{"way", value_of(Length{0.25})}, {"scans", value_of(Count(3))}});
  EXPECT_EQ(english(later), "of-a-later-version (way 25.0 cm, scans 3)");
}

TEST(render, messages_of_like_code_and_arguments_are_equal) {
  const auto message = [](double way_m) { return Message("x", {{"way", value_of(Length{way_m})}}); };
  EXPECT_EQ(message(0.5), message(0.5));
  EXPECT_FALSE(message(0.5) == message(0.6));
  EXPECT_EQ(message(std::nan("")), message(std::nan("")));
  EXPECT_FALSE(message(0.5) == Message("x", {{"way", value_of(Angle{0.5})}}));
}

TEST(render, languages_are_known_by_their_tags) {
  EXPECT_EQ(language_of("zh_CN"), Language::Chinese);
  EXPECT_EQ(language_of("zh"), Language::Chinese);
  EXPECT_EQ(language_of("en"), Language::English);
  EXPECT_EQ(language_of("de"), Language::English);
}

TEST(quantity_text, has_a_unit_and_digits_that_suit_the_size_or_the_style) {
  const auto text = [](Dimension dimension, double value, const char* style) {
    const QuantityText shown = quantity_text({dimension, value}, style, Language::English);
    return shown.digits + std::string(shown.unit);
  };
  EXPECT_EQ(text(Dimension::Length, 0.0042, ""), "4.2 mm");
  EXPECT_EQ(text(Dimension::Length, 0.42, ""), "42.0 cm");
  EXPECT_EQ(text(Dimension::Length, 4.2, ""), "4.20 m");
  EXPECT_EQ(text(Dimension::Length, 4.2, "+cm.0"), "+420 cm");
  EXPECT_EQ(text(Dimension::Length, -1e-9, "m.2"), "0.00 m");
  EXPECT_EQ(text(Dimension::Angle, std::numbers::pi, ""), "180.00 deg");
  EXPECT_EQ(text(Dimension::Duration, 0.03, "ms.0"), "30 ms");
  EXPECT_EQ(text(Dimension::Share, 0.5, ""), "50 %");
  EXPECT_EQ(text(Dimension::Number, 1234.0, "g3"), "1.23e+03");
  EXPECT_EQ(text(Dimension::Number, 12.34, ".1"), "12.3");
  EXPECT_EQ(text(Dimension::Bytes, 2.5e9, ""), "2.5 GB");
  EXPECT_EQ(text(Dimension::Length, std::nan(""), "m.2"), "nan m");
  EXPECT_EQ(quantity_text({Dimension::Length, 4.2}, "m.1", Language::Chinese).unit, " 米");
}

TEST(quantity_text, knows_its_styles) {
  EXPECT_TRUE(is_quantity_style(Dimension::Length, "cm.1"));
  EXPECT_FALSE(is_quantity_style(Dimension::Length, "deg.1"));
  EXPECT_FALSE(is_quantity_style(Dimension::Length, "cm"));
  EXPECT_FALSE(is_quantity_style(Dimension::Number, "m.1"));
}

TEST(sentence_pieces, are_words_places_and_choices) {
  const SentencePieces sentence = sentence_pieces("{n:count} {n?pair|pairs} of {{x}}, {way:length,m.1}");
  ASSERT_EQ(sentence.problem, "");
  ASSERT_EQ(sentence.pieces.size(), 5U);
  EXPECT_EQ(sentence.pieces[2].one, "pair");
  EXPECT_EQ(sentence.pieces[2].other, "pairs");
  EXPECT_EQ(sentence.pieces[3].words, " of {x}, ");
  EXPECT_EQ(sentence.pieces[4].style, "m.1");
  for (const char* wrong : {"{", "}", "{a", "{A}", "{a:bogus}", "{n?one}", "{}"})
    EXPECT_NE(sentence_pieces(wrong).problem, "") << wrong;
}

TEST(catalogue, is_ordered_and_found_by_code) {
  for (std::size_t i = 1; i < catalogue().size(); ++i) EXPECT_LT(catalogue()[i - 1].code, catalogue()[i].code);
  for (const CatalogueEntry& entry : catalogue()) {
    EXPECT_EQ(find_in_catalogue(entry.code), &entry);
    for (const std::string_view text : entry.text) EXPECT_EQ(sentence_pieces(text).problem, "") << entry.code;
  }
  EXPECT_EQ(find_in_catalogue("there-is-none"), nullptr);
}

}  // namespace
}  // namespace remount
