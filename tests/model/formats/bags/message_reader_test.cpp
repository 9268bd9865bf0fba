#include "model/formats/bags/message_reader.h"

#include <gtest/gtest.h>

#include "model/formats/bags/message_writer.h"
#include "tests/model/formats/bags/bag_fixtures.h"

namespace remount::bags {
namespace {

TEST(message_reader, aligns_cdr_to_the_size_of_each_field) {
  // uint8, double, string "ab", uint16 after the four bytes that name the representation
  const std::string bytes = std::string{0, 1, 0, 0} + std::string{7} + std::string(7, '\0') + raw(2.5) +
                            raw<std::uint32_t>(3) + std::string("ab\0", 3) + std::string(1, '\0') +
                            raw<std::uint16_t>(513);
  MessageReader reader(bytes, MessageEncoding::Cdr, "m");
  EXPECT_EQ(reader.number<std::uint8_t>(), 7);
  EXPECT_EQ(reader.number<double>(), 2.5);
  EXPECT_EQ(reader.string(), "ab");
  EXPECT_EQ(reader.number<std::uint16_t>(), 513);
  EXPECT_EQ(reader.left(), 0u);
}

TEST(message_reader, reads_cdr_of_either_byte_order) {
  const std::string bytes = std::string{0, 0, 0, 0} + std::string{0, 0, 1, 2} + std::string(4, '\0') +
                            std::string{0x3f, char(0xf0), 0, 0, 0, 0, 0, 0};
  MessageReader reader(bytes, MessageEncoding::Cdr, "m");
  EXPECT_EQ(reader.number<std::uint32_t>(), 258u);
  EXPECT_EQ(reader.number<double>(), 1.0);
}

TEST(message_reader, packs_ros1) {
  const std::string bytes = std::string{7} + raw(2.5) + counted("ab") + raw<std::uint16_t>(513);
  MessageReader reader(bytes, MessageEncoding::Ros1, "m");
  EXPECT_EQ(reader.number<std::uint8_t>(), 7);
  EXPECT_EQ(reader.number<double>(), 2.5);
  EXPECT_EQ(reader.string(), "ab");
  EXPECT_EQ(reader.number<std::uint16_t>(), 513);
}

TEST(message_reader, knows_the_headers_of_both) {
  for (const MessageEncoding encoding : {MessageEncoding::Ros1, MessageEncoding::Cdr}) {
    const std::string bytes = MessageWriter(encoding).header(1'600'000'000'123'456'789, "/base").number(1.5).bytes();
    MessageReader reader(bytes, encoding, "m");
    const MessageHeader header = read_header(reader);
    EXPECT_EQ(header.stamp_ns, 1'600'000'000'123'456'789);
    EXPECT_EQ(header.frame, "base");
    EXPECT_EQ(reader.number<double>(), 1.5);
  }
}

TEST(message_reader, refuses_what_is_not_there) {
  const auto read = [](const std::string& bytes, MessageEncoding encoding, auto&& action) {
    return formats::error_of([&] {
      MessageReader reader(bytes, encoding, "drive.bag: /points, message 3");
      action(reader);
    });
  };
  const auto nothing = [](MessageReader&) {};
  EXPECT_TRUE(formats::contains(read("", MessageEncoding::Cdr, nothing), "message 3"));
  EXPECT_TRUE(formats::contains(read({0, 3, 0, 0}, MessageEncoding::Cdr, nothing), "representation 3"));
  EXPECT_TRUE(formats::contains(read("", MessageEncoding::Other, nothing), "neither"));
  const std::string lie = raw<std::uint32_t>(0xffffffffU);
  EXPECT_TRUE(formats::contains(read(lie, MessageEncoding::Ros1, [](MessageReader& r) { r.string(); }), "message 3"));
  EXPECT_TRUE(
      formats::contains(read(lie, MessageEncoding::Ros1, [](MessageReader& r) { r.byte_sequence(); }), "message 3"));
  EXPECT_TRUE(
      formats::contains(read(lie, MessageEncoding::Ros1, [](MessageReader& r) { r.sequence(13); }), "4294967295"));
}

}  // namespace
}  // namespace remount::bags
