#include "app/gui/jobs/error_words.h"

#include <gtest/gtest.h>

#include <new>

#include "messages/bags.h"

namespace remount::widgets {
namespace {

QString said(ErrorCode code, const Message& what) { return gui::failure_of(Error(code, "a.bag", what)).what; }

TEST(error_words, advice_follows_what_has_none_of_its_own) {
  const Message no_advice = say::bag_nothing_readable(Message::verbatim("none was expected. None came"));
  EXPECT_TRUE(said(ErrorCode::Format, no_advice).contains("Copy it from its source again"));
  EXPECT_TRUE(said(ErrorCode::Unsupported, no_advice).contains("F1"));
  EXPECT_EQ(said(ErrorCode::Contract, no_advice), "the bag holds no readable message (none was expected. None came).");
}

TEST(error_words, what_advises_itself_stands_alone_but_for_the_disk) {
  EXPECT_EQ(said(ErrorCode::Format, say::bag_no_header()), "expected the header of the bag");
  EXPECT_TRUE(said(ErrorCode::Io, say::bag_no_header()).contains("Is the disk connected"));
}

TEST(error_words, the_place_stands_in_front) {
  EXPECT_EQ(gui::in_words(gui::failure_of(Error(ErrorCode::Format, "a.bag", say::bag_no_header()))),
            "a.bag: expected the header of the bag");
  EXPECT_TRUE(gui::in_words(gui::failure_of(std::bad_alloc())).startsWith("There is not enough memory"));
}

}  // namespace
}  // namespace remount::widgets
