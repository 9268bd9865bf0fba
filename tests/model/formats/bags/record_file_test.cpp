#include "model/formats/bags/record_file.h"

#include <gtest/gtest.h>

#include <iostream>

#include "model/formats/bags/proto_reader.h"
#include "model/formats/sessions/several_sessions.h"
#include "tests/model/formats/bags/record_bags.h"

namespace remount::bags {
namespace {

std::string record_section(std::uint32_t kind, const std::string& content) {
  return raw(kind) + std::string(4, '\x5a') + raw<std::uint64_t>(content.size()) + content;  // padding is anything
}

std::string record_header_of(std::uint64_t compress, bool complete, std::uint64_t messages) {
  const std::string fields = ProtoWriter()
                                 .whole(1, 1)
                                 .whole(2, 0)
                                 .whole(3, compress)
                                 .whole(4, 20'000'000'000)
                                 .whole(11, messages)
                                 .whole(13, complete ? 1 : 0)
                                 .bytes(16, "map")
                                 .message();
  std::string section = record_section(0, fields);
  section.resize(16 + 2048);
  return section;
}

std::string record_message(const std::string& channel, std::int64_t time_ns, const std::string& content) {
  return ProtoWriter()
      .bytes(1,
             ProtoWriter().bytes(1, channel).whole(2, static_cast<std::uint64_t>(time_ns)).bytes(3, content).message())
      .message();
}

std::string record_channel(const std::string& name, const std::string& type) {
  return record_section(4, ProtoWriter().bytes(1, name).bytes(2, type).bytes(3, std::string(9000, 'd')).message());
}

std::string described_record(std::uint64_t compress = 0, bool complete = true, std::uint64_t messages = 3) {
  const std::string first = record_message("/a", kStart_ns, "one") + record_message("/b", kStart_ns + 1, "two");
  return record_header_of(compress, complete, messages) + record_channel("/a", "apollo.A") + record_section(1, "") +
         record_section(2, first) + record_channel("/b", "other.B") + record_section(1, "") +
         record_section(2, record_message("/a", kStart_ns + 2, "three")) + record_section(3, "");
}

class record_file : public ::testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& bytes) const { return folder_.write(name, bytes); }
  std::string error_of_opening(const fs::path& path) const {
    return formats::error_of([&] { opened_record(path); });
  }
  formats::TemporaryFolder folder_;
};

TEST_F(record_file, is_read_as_its_format_is_described) {
  const auto bag = opened_record(write("a.record", described_record()));
  ASSERT_EQ(bag->topics().size(), 2U);
  const BagTopic &a = bag->topics()[0], &b = bag->topics()[1];
  EXPECT_EQ(a.name, "/a");
  EXPECT_EQ(a.type, "apollo.A");
  EXPECT_EQ(a.encoding, MessageEncoding::Protobuf);
  EXPECT_EQ(b.type, "other.B");
  EXPECT_EQ(b.encoding, MessageEncoding::Other);
  ASSERT_EQ(a.entries.size(), 2U);
  EXPECT_EQ(a.entries[1].log_time_ns, kStart_ns + 2);
  EXPECT_EQ(bag->message(a.entries[0]), "one");
  EXPECT_EQ(bag->message(a.entries[1]), "three");
  EXPECT_EQ(bag->message(a.entries[1], 2), "th");
  EXPECT_EQ(bag->message_end(a.entries[1], 2), "ee");
  EXPECT_EQ(bag->message_end(a.entries[1], 20), "three");
  EXPECT_TRUE(bag->findings().empty());
  EXPECT_EQ(probe_record(bag->files().front()), 95);
}

TEST_F(record_file, is_written_and_read) {
  const std::vector<TestMessage> messages = test_messages(300);
  const fs::path path = folder_.path() / "drive.record";
  write_messages(*make_record_writer(path, 1000), messages);
  const auto bag = opened_record(path);
  EXPECT_EQ(count_and_check(*bag, messages), messages.size());
  EXPECT_TRUE(bag->findings().empty());
}

TEST_F(record_file, that_was_cut_anywhere_gives_its_beginning_with_a_word) {
  const std::vector<TestMessage> messages = test_messages(60);
  const fs::path path = folder_.path() / "drive.record";
  write_messages(*make_record_writer(path, 400), messages);
  const std::string whole = formats::bytes_of(path);
  std::size_t before = 0, refused = 0, told = 0, sizes = 0, complete = 0;
  for (std::size_t size = 0; size < whole.size(); size += size < 2048 ? 97 : size < 3300 ? 1 : 7, ++sizes) {
    write("drive.record", whole.substr(0, size));
    try {
      const auto bag = opened_record(path);
      const std::size_t count = count_and_check(*bag, messages);
      EXPECT_GE(count, before) << size;
      before = count;
      const drive::Finding* cut = find(*bag, "record-cut");
      told += cut != nullptr;
      complete += cut == nullptr && count == messages.size();
      // What was used is not among what cannot be read.
      if (const std::string said = cut ? english(cut->explanation) : ""; said.starts_with("The last ")) {
        EXPECT_LE(std::stoul(said.substr(9)), 600U) << size << ": " << said;
      }
      EXPECT_FALSE(find(*bag, "record-damaged")) << size;
    } catch (const Error& error) {
      EXPECT_EQ(before, 0U) << size << ": " << error.what();
      ++refused;
    }
  }
  EXPECT_EQ(before, messages.size());
  EXPECT_EQ(refused + told + complete, sizes);
  EXPECT_LE(complete, 1U) << "an end right behind the last message";
  std::cout << sizes << " cuts: " << refused << " leave no message, " << told << " are told\n";
}

TEST_F(record_file, that_was_not_closed_or_lacks_messages_says_so) {
  const auto open_one = opened_record(write("a.record", described_record(0, false, 0)));
  EXPECT_EQ(message_count(*open_one), 3U);
  testing::expect_told(open_one->findings(), "record-cut", "was not closed");
  const auto lacking = opened_record(write("a.record", described_record(0, true, 5)));
  testing::expect_told(lacking->findings(), "record-cut", "promises 5 messages, 3 were found");
}

TEST_F(record_file, with_a_damaged_message_gives_the_others) {
  const std::string body = record_message("/a", kStart_ns, "one") + record_message("", kStart_ns + 1, "two") +
                           ProtoWriter().bytes(1, std::string("\x0b\x0b", 2)).message() +
                           record_message("/a", kStart_ns + 3, "four");
  const auto bag = opened_record(
      write("a.record", record_header_of(0, true, 4) + record_channel("/a", "apollo.A") + record_section(2, body)));
  ASSERT_EQ(bag->topics().size(), 1U);
  EXPECT_EQ(bag->message(bag->topics()[0].entries.at(1)), "four");
  testing::expect_told(bag->findings(), "record-damaged", "cannot be read: 2");
}

TEST_F(record_file, that_is_compressed_is_refused_by_name) {
  EXPECT_NE(error_of_opening(write("a.record", described_record(1))).find("BZ2"), std::string::npos);
  EXPECT_NE(error_of_opening(write("a.record", described_record(2))).find("LZ4"), std::string::npos);
  EXPECT_NE(error_of_opening(write("a.record", described_record(7))).find("(7)"), std::string::npos);
}

TEST_F(record_file, is_told_from_other_files) {
  const std::string good = described_record();
  EXPECT_EQ(probe_record(write("a.record", good.substr(0, 2064))), 95) << "a recorder that has just begun";
  std::string other = good;
  other[2064] = 9;
  EXPECT_EQ(probe_record(write("b", other)), 0) << "another section";
  other = good;
  other[0] = 1;
  EXPECT_EQ(probe_record(write("c", other)), 0);
  EXPECT_EQ(probe_record(write("d", std::string(5000, '\0'))), 0);
  EXPECT_EQ(probe_record(write("e", "")), 0);
  EXPECT_NE(error_of_opening(folder_.path() / "c").find("is no record"), std::string::npos);
  EXPECT_EQ(probe_record(folder_.path() / "missing"), 0);
}

TEST_F(record_file, in_parts_is_one_in_their_order) {
  const std::vector<TestMessage> messages = test_messages(90);
  const auto write_part = [&](const char* name, std::size_t from, std::size_t to) {
    write_messages(*make_record_writer(folder_.path() / name, 1000),
                   {messages.begin() + static_cast<long>(from), messages.begin() + static_cast<long>(to)});
  };
  write_part("drive.record.00009", 0, 30);
  write_part("drive.record.00010", 30, 60);
  write_part("drive.record.00011", 60, 90);
  EXPECT_EQ(probe_record(folder_.path()), 95);
  const auto bag = opened_record(folder_.path());
  EXPECT_EQ(count_and_check(*bag, messages), 90U);
  ASSERT_EQ(bag->files().size(), 3U);
  EXPECT_EQ(bag->files()[0].filename(), "drive.record.00009");
  EXPECT_TRUE(bag->findings().empty());
  const BagEntry& last = bag->topics()[0].entries.back();
  EXPECT_EQ(bag->message_end(last, 3), bag->message(last).substr(bag->message(last).size() - 3));

  fs::remove(folder_.path() / "drive.record.00010");
  const auto without = opened_record(folder_.path());
  EXPECT_EQ(count_and_check(*without, messages), 60U);
  testing::expect_told(without->findings(), "record-part-missing", "1 part is missing");

  write("drive.record.00010", formats::bytes_of(folder_.path() / "drive.record.00011").substr(0, 2080));
  const auto broken = opened_record(folder_.path());
  EXPECT_EQ(message_count(*broken), 60U);
  EXPECT_TRUE(find(*broken, "record-part-unreadable"));

  // Of a disk that was full, and of one that was not written to the end.
  for (const std::string& bytes : {std::string(), std::string(5000, '\0')}) {
    write("drive.record.00010", bytes);
    const auto headless = opened_record(folder_.path());
    EXPECT_EQ(message_count(*headless), 60U);
    EXPECT_TRUE(find(*headless, "record-part-unreadable")) << bytes.size();
    EXPECT_FALSE(find(*headless, "record-part-missing"));
  }
  write_part("drive.record.9", 0, 30);
  EXPECT_EQ(probe_record(folder_.path()), 25) << "two say that they are the ninth";
  fs::remove(folder_.path() / "drive.record.9");

  write_part("other.record.00000", 0, 30);
  EXPECT_EQ(probe_record(folder_.path()), 25);
  EXPECT_THROW(opened_record(folder_.path()), formats::SeveralSessions);
}

TEST_F(record_file, of_channels_without_end_ends) {
  std::string body;
  for (int i = 0; i < 6000; ++i) body += record_message("/" + std::to_string(i), kStart_ns + i, "x");
  const auto bag = opened_record(write("a.record", record_header_of(0, true, 6000) + record_section(2, body)));
  EXPECT_EQ(bag->topics().size(), 4096U);
  testing::expect_told(bag->findings(), "record-damaged", "more than 4096 channels");
}

}  // namespace
}  // namespace remount::bags
