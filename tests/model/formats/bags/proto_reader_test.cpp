#include "model/formats/bags/proto_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/model/formats/temporary_folder.h"

namespace remount::bags {
namespace {

/// What is read of a message that is wrong.
std::string error_of_walking(std::string_view bytes) {
  return formats::error_of([&] {
    for (ProtoReader reader(bytes, "m"); reader.next();) {
    }
  });
}

// Byte by byte as the wire format has them: the numbers of its own documentation.
TEST(proto_reader, fields_are_those_of_the_wire_format) {
  const std::string bytes("\x08\x96\x01\x12\x07testing\x1d\x00\x00\x80\x3f\x21\x00\x00\x00\x00\x00\x00\x00\xc0", 26);
  ProtoReader reader(bytes, "m");
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.field(), 1U);
  EXPECT_EQ(reader.whole(), 150U);
  EXPECT_FALSE(reader.real() || reader.bytes());
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.field(), 2U);
  EXPECT_EQ(reader.bytes(), "testing");
  EXPECT_EQ(reader.begins(), 5U);
  EXPECT_EQ(reader.length(), 7U);
  EXPECT_FALSE(reader.whole() || reader.real());
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.field(), 3U);
  EXPECT_EQ(reader.real(), 1.0);
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.field(), 4U);
  EXPECT_EQ(reader.real(), -2.0);
  EXPECT_FALSE(reader.whole());
  EXPECT_FALSE(reader.next());
}

TEST(proto_reader, what_is_written_is_read) {
  for (const std::uint64_t value : {std::uint64_t{0}, std::uint64_t{127}, std::uint64_t{128}, std::uint64_t{1} << 63U,
                                    std::numeric_limits<std::uint64_t>::max()}) {
    const std::string bytes = ProtoWriter().whole(101, value).real(5, -1e-300).narrow(7, 0.1f).bytes(16, "").message();
    ProtoReader reader(bytes, "m");
    ASSERT_TRUE(reader.next() && reader.field() == 101);
    EXPECT_EQ(reader.whole(), value);
    ASSERT_TRUE(reader.next() && reader.field() == 5);
    EXPECT_EQ(reader.real(), -1e-300);
    ASSERT_TRUE(reader.next() && reader.field() == 7);
    EXPECT_EQ(reader.real(), static_cast<double>(0.1f));
    ASSERT_TRUE(reader.next() && reader.field() == 16);
    EXPECT_EQ(reader.bytes(), "");
    EXPECT_FALSE(reader.next());
  }
}

TEST(proto_reader, what_is_no_field_is_refused) {
  EXPECT_EQ(error_of_walking(std::string("\x08\x00", 2)), "");
  EXPECT_NE(error_of_walking(std::string("\x00\x00", 2)), "") << "number 0";
  EXPECT_NE(error_of_walking("\x0b"), "") << "a group";
  EXPECT_NE(error_of_walking("\x0f"), "") << "a type that there is not";
  EXPECT_NE(error_of_walking("\x08\xff\xff\xff\xff\xff\xff\xff\xff\xff\x02"), "") << "more than 64 bits";
  EXPECT_NE(error_of_walking("\x08\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\x01"), "") << "a number without end";
  EXPECT_NE(error_of_walking("\x0a\xff\xff\xff\xff\xff\xff\xff\xff\xff\x01"), "") << "as long as there is memory";
  EXPECT_NE(error_of_walking("\x0a\x05"
                             "abcd"),
            "");
}

TEST(proto_reader, a_message_that_ends_anywhere_is_damage_or_the_beginning_of_one) {
  const std::string bytes = ProtoWriter().whole(1, 300).bytes(2, "name").real(3, 0.5).narrow(4, 0.5f).message();
  std::size_t refused = 0;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::string_view begin = std::string_view(bytes).substr(0, size);
    refused += !error_of_walking(begin).empty();
    std::size_t fields = 0, text = 0;
    for (ProtoReader reader(begin, "m", ProtoReader::End::Cut); reader.next(); ++fields)
      if (reader.field() == 2) text = reader.bytes()->size();
    EXPECT_LE(fields, 3U) << size;
    if (size >= 5 && size <= 9) {
      EXPECT_EQ(text, size - 5) << "what there is of the name";
    }
  }
  EXPECT_EQ(refused, bytes.size() - 4) << "all but those that end between two fields";
}

}  // namespace
}  // namespace remount::bags
