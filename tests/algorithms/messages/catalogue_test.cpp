#include "algorithms/messages/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "algorithms/messages/message.h"
#include "messages/bags.h"
#include "messages/exports.h"
#include "messages/general.h"

namespace remount {
namespace {

bool goes_on_or_says_what_was_expected(std::string_view english) {
  const auto holds = [&](std::string_view part) { return english.find(part) != std::string_view::npos; };
  return holds(". ") || holds("\n") || holds("expected");
}

/// Errors go on behind the place of which they speak, and begin in lower case.
bool reads_as_an_error(const CatalogueEntry& entry) {
  constexpr std::array<std::string_view, 6> kOthers{"beginnings-apart",         "cli-unexpected",
                                                    "fleet-cell-reference",     "fleet-legend",
                                                    "plane-of-other-direction", "registration-too-far"};
  const char first = entry.text[0].front();
  return first >= 'a' && first <= 'z' && std::find(kOthers.begin(), kOthers.end(), entry.code) == kOthers.end();
}

// Forgotten marks are found here: a new error would get the window's general advice behind its own.
TEST(catalogue, errors_that_say_what_was_expected_or_what_to_do_are_marked) {
  for (const CatalogueEntry& entry : catalogue()) {
    const bool says = goes_on_or_says_what_was_expected(entry.text[0]);
    if (reads_as_an_error(entry)) {
      EXPECT_EQ(entry.advises, says) << entry.code << ": " << entry.text[0];
    }
    if (entry.advises) {
      EXPECT_TRUE(says) << entry.code << ": " << entry.text[0];
    }
  }
}

TEST(catalogue, advice_counts_wherever_it_stands_in_a_message) {
  const Message advice = say::bag_no_header();
  const Message none = say::bag_nothing_readable(Message::verbatim("No disk. A reason was expected"));
  EXPECT_TRUE(advises(advice));
  EXPECT_TRUE(advises(say::bag_nothing_readable(say::of_file("a.bag", advice))));
  EXPECT_TRUE(advises(say::mounting_of_no_format({none, advice})));
  EXPECT_TRUE(advises(Message::sequence({none, none}))) << "goes on after its first sentence";
  EXPECT_FALSE(advises(none)) << "words of others are no advice of ours";
  EXPECT_FALSE(advises(Message()));
  EXPECT_FALSE(advises(Message("of-a-later-version", {})));
}

}  // namespace
}  // namespace remount
