#include "model/formats/bags/mcap_file.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/formats/files/crc32.h"
#include "tests/model/formats/bags/bag_fixtures.h"

namespace remount::bags {
namespace {

constexpr ChunkCompression kMcapCompressions[] = {ChunkCompression::None, ChunkCompression::Lz4,
                                                  ChunkCompression::Zstd};
const std::string kMagic("\x89MCAP0\r\n", 8);

std::string written_mcap(const formats::TemporaryFolder& folder, ChunkCompression compression,
                         const std::vector<TestMessage>& messages) {
  const fs::path path = folder.path() / "written.mcap";
  write_messages(*make_mcap_writer(path, MessageEncoding::Cdr, compression, 300), messages);
  const std::string bytes = formats::bytes_of(path);
  fs::remove(path);
  return bytes;
}

// ---- Put together by hand from the format's description

std::string record(std::uint8_t op, const std::string& content) {
  return raw(op) + raw<std::uint64_t>(content.size()) + content;
}

std::string schema() {
  return record(3,
                raw<std::uint16_t>(4) + counted("std_msgs/msg/String") + counted("ros2msg") + counted("string data\n"));
}
std::string channel() {
  return record(4, raw<std::uint16_t>(9) + raw<std::uint16_t>(4) + counted("/greeting") + counted("cdr") +
                       counted(counted("key") + counted("value")));
}
std::string hello() {
  return record(5, raw<std::uint16_t>(9) + raw<std::uint32_t>(0) + raw<std::uint64_t>(1'600'000'000'500'000'000) +
                       raw<std::uint64_t>(1'600'000'000'400'000'000) + "hello");
}
std::string opening() { return kMagic + record(1, counted("ros2") + counted("by hand")); }
std::string closing(std::uint64_t summary) {
  return record(2, raw(summary) + raw<std::uint64_t>(0) + raw<std::uint32_t>(0)) + kMagic;
}

/// As a recorder writes it that makes no chunks.
std::string unchunked() {
  return opening() + schema() + channel() + hello() + record(15, raw<std::uint32_t>(0)) + closing(0);
}

/// One chunk with its index, and a summary.
std::string chunked(std::uint64_t size_lie = 0, std::uint64_t offset_lie = 0, bool message_index = true) {
  const std::string inner = schema() + channel() + hello();
  const std::uint64_t time = 1'600'000'000'500'000'000, offset = schema().size() + channel().size();
  const std::string chunk = record(6, raw(time) + raw(time) + raw(inner.size() + size_lie) + raw<std::uint32_t>(0) +
                                          counted("") + raw<std::uint64_t>(inner.size()) + inner);
  const std::string index =
      message_index ? record(7, raw<std::uint16_t>(9) + counted(raw(time) + raw(offset + offset_lie))) : std::string();
  std::string bytes = opening();
  const std::uint64_t start = bytes.size();
  bytes += chunk + index + record(15, raw<std::uint32_t>(0));
  const std::uint64_t summary = bytes.size();
  const std::string offsets = message_index ? raw<std::uint16_t>(9) + raw<std::uint64_t>(start + chunk.size()) : "";
  bytes += schema() + channel() +
           record(8, raw(time) + raw(time) + raw(start) + raw<std::uint64_t>(chunk.size()) + counted(offsets) +
                         raw<std::uint64_t>(index.size()) + counted("") + raw<std::uint64_t>(inner.size()) +
                         raw<std::uint64_t>(inner.size()));
  return bytes + closing(summary);
}

void expect_hello(const BagFile& bag) {
  ASSERT_EQ(bag.topics().size(), 1u);
  const BagTopic& topic = bag.topics()[0];
  EXPECT_EQ(topic.name, "/greeting");
  EXPECT_EQ(topic.type, "std_msgs/String");
  EXPECT_EQ(topic.encoding, MessageEncoding::Cdr);
  ASSERT_EQ(topic.entries.size(), 1u);
  EXPECT_EQ(topic.entries[0].log_time_ns, 1'600'000'000'500'000'000);
  EXPECT_EQ(bag.message(topic.entries[0]), "hello");
}

TEST(mcap_file, is_read_as_its_format_is_described) {
  const formats::TemporaryFolder folder;
  for (const std::string& bytes : {unchunked(), chunked(), chunked(0, 0, false)}) {
    const auto bag = open_quietly(folder.write("a.mcap", bytes));
    expect_hello(*bag);
    EXPECT_TRUE(bag->findings().empty()) << english(bag->findings()[0].explanation);
  }
}

TEST(mcap_file, is_written_and_read_in_every_compression) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(60);
  for (const ChunkCompression compression : kMcapCompressions) {
    const auto bag = open_quietly(folder.write("a.mcap", written_mcap(folder, compression, messages)));
    EXPECT_EQ(count_and_check(*bag, messages), messages.size());
    EXPECT_TRUE(bag->findings().empty());
  }
}

TEST(mcap_file, that_was_cut_anywhere_gives_its_beginning_with_a_count) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(30);
  for (const ChunkCompression compression : kMcapCompressions) {
    const std::string bytes = written_mcap(folder, compression, messages);
    std::size_t most = 0, refused = 0, warned = 0, nothing_lost = 0;
    for (std::size_t length = 0; length < bytes.size(); length += 13) {
      const fs::path path = folder.write("a.mcap", bytes.substr(0, length));
      try {
        const auto bag = open_quietly(path);
        const std::size_t count = count_and_check(*bag, messages);
        EXPECT_GE(count, most) << "cut at byte " << length;
        most = std::max(most, count);
        if (const drive::Finding* finding = find(*bag, "bag-unindexed")) {
          EXPECT_TRUE(
              formats::contains(english(finding->explanation), "beginning: " + std::to_string(count) + " message"))
              << english(finding->explanation);
          nothing_lost += formats::contains(english(finding->explanation), "; 0 bytes at the end");
          ++warned;
        } else {
          const drive::Finding* end = find(*bag, "bag-cut-end");
          ASSERT_NE(end, nullptr) << "cut at byte " << length << " without a word";
          EXPECT_TRUE(formats::contains(english(end->explanation), "reading them: " + std::to_string(count) + "."))
              << english(end->explanation);
          EXPECT_EQ(count, messages.size()) << "cut at byte " << length;
        }
      } catch (const Error& error) {
        EXPECT_EQ(most, 0u) << "cut at byte " << length << ": " << error.what();
        EXPECT_TRUE(formats::contains(error.what(), "a.mcap")) << error.what();
        ++refused;
      }
    }
    std::cout << "compression " << static_cast<int>(compression) << ": " << refused << " cuts refused, " << warned
              << " gave up to " << most << " of 30 messages\n";
    EXPECT_EQ(most, messages.size());
    EXPECT_LE(nothing_lost, 5u) << "only a cut between two records loses no bytes of one";
    EXPECT_GT(warned, 10u);
  }
}

// A copy that stopped a little too early: all messages are there, and nothing else would tell.
TEST(mcap_file, that_lacks_a_few_bytes_at_its_end_says_so) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(30);
  for (const ChunkCompression compression : kMcapCompressions) {
    const std::string bytes = written_mcap(folder, compression, messages);
    for (std::size_t missing = 1; missing <= 60; ++missing) {
      const auto bag = open_quietly(folder.write("a.mcap", bytes.substr(0, bytes.size() - missing)));
      EXPECT_EQ(count_and_check(*bag, messages), messages.size()) << missing;
      ASSERT_EQ(bag->findings().size(), 1u) << missing << " bytes are missing";
      EXPECT_EQ(bag->findings()[0].code, "bag-cut-end") << missing;
      EXPECT_EQ(bag->findings()[0].severity, drive::Severity::Warning);
    }
    // One bit of the summary: its checksum tells.
    std::string flipped = bytes;
    flipped[bytes.size() - 60] = static_cast<char>(flipped[bytes.size() - 60] ^ 1);
    EXPECT_NE(find(*open_quietly(folder.write("a.mcap", flipped)), "bag-cut-end"), nullptr);
  }
}

// What a writer may leave out is no damage.
TEST(mcap_file, whose_summary_does_not_repeat_the_channels_is_read_without_a_word) {
  const formats::TemporaryFolder folder;
  std::string bytes = chunked();
  const std::string repeated = schema() + channel();
  const std::size_t at = bytes.rfind(repeated);
  bytes.erase(at, repeated.size());
  const auto bag = open_quietly(folder.write("a.mcap", bytes));
  expect_hello(*bag);
  EXPECT_TRUE(bag->findings().empty()) << english(bag->findings()[0].explanation);
}

TEST(mcap_file, of_lies_is_refused_or_read_from_its_beginning) {
  const formats::TemporaryFolder folder;
  const auto open_bytes = [&](const std::string& bytes) {
    const auto bag = open_quietly(folder.write("a.mcap", bytes));
    for (const BagTopic& topic : bag->topics())
      for (const BagEntry& entry : topic.entries) bag->message(entry);
  };
  EXPECT_ERROR(open_bytes(chunked(std::uint64_t{1} << 60)), "promises");
  EXPECT_ERROR(open_bytes(chunked(0, 1'000'000)), "a.mcap");
  EXPECT_ERROR(open_bytes(kMagic), "a.mcap");
  std::string version = unchunked();
  version[5] = '1';
  EXPECT_ERROR(open_bytes(version), "another version");
  std::string record_lie = unchunked();
  record_lie.replace(record_lie.find(schema()) + 1, 8, raw<std::uint64_t>(~std::uint64_t{0}));
  EXPECT_ERROR(open_bytes(record_lie), "a.mcap");
  std::string summary_lie = chunked();
  summary_lie.replace(summary_lie.size() - 8 - 20, 8, raw<std::uint64_t>(17));
  const auto bag = open_quietly(folder.write("a.mcap", summary_lie));
  expect_hello(*bag);
}

TEST(mcap_file, that_promises_more_messages_than_its_index_has_is_read_from_its_beginning) {
  const formats::TemporaryFolder folder;
  std::string bytes = chunked();
  // A message outside of chunks, which the index cannot know, and statistics that count it.
  const std::uint64_t at = bytes.find(record(15, raw<std::uint32_t>(0)));
  const std::string more = hello();
  const std::string tail = bytes.substr(at, bytes.size() - at - closing(0).size());
  const std::string statistics = record(11, raw<std::uint64_t>(2) + std::string(34, '\0') + counted(""));
  bytes = bytes.substr(0, at) + more + tail + statistics;
  bytes += closing(at + more.size() + record(15, raw<std::uint32_t>(0)).size());
  const auto bag = open_quietly(folder.write("a.mcap", bytes));
  EXPECT_EQ(message_count(*bag), 2u);
  EXPECT_TRUE(bag->findings().empty());
}

TEST(mcap_file, definitions_of_messages_that_are_not_read_or_come_again_leave_room_for_others) {
  const auto described = [](int id, const std::string& type, const std::string& definition) {
    return record(3, raw(static_cast<std::uint16_t>(id)) + counted(type) + counted("ros2msg") + counted(definition));
  };
  const auto published = [](int id, const std::string& topic) {
    return record(4, raw(static_cast<std::uint16_t>(id)) + raw(static_cast<std::uint16_t>(id)) + counted(topic) +
                         counted("cdr") + counted(""));
  };
  const std::string fields = "builtin_interfaces/Time stamp\nuint8[1206] data\n",
                    longest = fields + "#" + std::string(64'000, '-') + "\n";
  for (const bool again : {true, false}) {
    std::string bytes = opening() + schema() + channel();
    // More than is kept of all: of one type in every chunk, or of types that nobody asks about.
    for (int i = 0; i < 140; ++i)
      bytes += again ? described(20, "velodyne_msgs/msg/VelodynePacket", longest)
                     : described(100 + i, "any_msgs/msg/Other" + std::to_string(i), longest);
    bytes += described(20, "velodyne_msgs/msg/VelodynePacket", longest) + published(20, "/front");
    bytes += described(21, "velodyne_msgs/msg/VelodynePacket", fields) + published(21, "/late");
    const formats::TemporaryFolder folder;
    const auto bag =
        open_quietly(folder.write("a.mcap", bytes + hello() + record(15, raw<std::uint32_t>(0)) + closing(0)));
    ASSERT_EQ(bag->topics().size(), 3U);
    EXPECT_EQ(bag->topics()[0].definition.size(), longest.size()) << bag->topics()[0].name;
    EXPECT_EQ(bag->topics()[1].definition, "") << "of std_msgs/String nothing is read by it";
    EXPECT_EQ(bag->topics()[2].definition, fields) << bag->topics()[2].name;
  }
}

TEST(mcap_file, with_two_channels_of_one_topic_has_their_messages_in_one) {
  const formats::TemporaryFolder folder;
  // Two publishers of one topic; the second has a schema of its own with the same name.
  std::string other_schema = schema(), other_channel = channel(), other_hello = hello();
  other_schema.replace(9, 2, raw<std::uint16_t>(5));
  other_channel.replace(9, 4, raw<std::uint16_t>(3) + raw<std::uint16_t>(5));
  other_hello.replace(9, 2, raw<std::uint16_t>(3));
  const std::uint64_t earlier = 1'600'000'000'300'000'000;
  other_hello.replace(9 + 6, 8, raw(earlier));
  other_hello.replace(other_hello.size() - 5, 5, "there");
  const auto bag =
      open_quietly(folder.write("a.mcap", opening() + schema() + channel() + other_schema + other_channel + hello() +
                                              other_hello + hello() + record(15, raw<std::uint32_t>(0)) + closing(0)));
  ASSERT_EQ(bag->topics().size(), 1u);
  const std::vector<BagEntry>& entries = bag->topics()[0].entries;
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(bag->message(entries[0]), "there") << "in the order of the recorder's times";
  EXPECT_EQ(bag->message(entries[1]), "hello");
  EXPECT_TRUE(bag->findings().empty());

  // As the writers make them, with an index for each channel.
  const auto writer = make_mcap_writer(folder.path() / "b.mcap", MessageEncoding::Cdr, ChunkCompression::Zstd, 300);
  for (int i = 0; i < 2; ++i) writer->add_topic("/a", definition("test_msgs/Text"));
  const std::vector<TestMessage> messages = test_messages(60);
  for (const TestMessage& message : messages) writer->write(message.topic, message.time_ns, message.bytes);
  writer->finish();
  const auto indexed = open_quietly(folder.path() / "b.mcap");
  ASSERT_EQ(indexed->topics().size(), 1u);
  ASSERT_EQ(indexed->topics()[0].entries.size(), messages.size());
  for (std::size_t i = 0; i < messages.size(); ++i)
    EXPECT_EQ(indexed->message(indexed->topics()[0].entries[i]), messages[i].bytes);
}

// ---- Checksums

/// How many messages of the bag can be read; the others must be refused for their chunk's checksum.
std::size_t readable(const BagFile& bag) {
  std::size_t count = 0;
  for (const BagTopic& topic : bag.topics())
    for (const BagEntry& entry : topic.entries) {
      const std::string problem = formats::error_of([&] { bag.message(entry); });
      EXPECT_TRUE(problem.empty() || formats::contains(problem, "checksum of the chunk")) << problem;
      count += problem.empty();
    }
  return count;
}

TEST(mcap_file, whose_chunk_has_a_wrong_checksum_gives_the_other_chunks) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(60);
  for (const ChunkCompression compression : kMcapCompressions) {
    std::string bytes = written_mcap(folder, compression, messages);
    // The second chunk's checksum, behind its times and its size; by the index first, then without one.
    std::size_t offset = kMagic.size(), chunks = 0;
    while (bytes[offset] != 6 || ++chunks < 2) {
      std::uint64_t length = 0;
      std::memcpy(&length, bytes.data() + offset + 1, sizeof length);
      offset += 9 + length;
      ASSERT_LT(offset, bytes.size());
    }
    bytes[offset + 9 + 24] ^= 1;
    const auto indexed = open_quietly(folder.write("a.mcap", bytes));
    const std::size_t left = readable(*indexed);
    EXPECT_EQ(message_count(*indexed), messages.size());
    EXPECT_GT(left, messages.size() / 2) << static_cast<int>(compression);
    EXPECT_LT(left, messages.size()) << static_cast<int>(compression);
    const auto scanned = open_quietly(folder.write("b.mcap", bytes.substr(0, bytes.size() - 40)));
    EXPECT_EQ(message_count(*scanned), left);
    EXPECT_EQ(readable(*scanned), left);
    const drive::Finding* finding = find(*scanned, "bag-unindexed");
    ASSERT_NE(finding, nullptr);
    EXPECT_TRUE(formats::contains(english(finding->explanation), "checksum of the chunk"))
        << english(finding->explanation);
    EXPECT_TRUE(formats::contains(english(finding->explanation), std::to_string(left) + " messages"))
        << english(finding->explanation);
  }
}

TEST(mcap_file, whose_summary_has_a_wrong_checksum_is_read_from_its_beginning) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(60);
  std::string bytes = written_mcap(folder, ChunkCompression::Zstd, messages);
  bytes[bytes.size() - kMagic.size() - 1] ^= 1;
  const auto bag = open_quietly(folder.write("a.mcap", bytes));
  EXPECT_EQ(count_and_check(*bag, messages), messages.size());
}

TEST(mcap_file, whose_data_or_attachment_has_a_wrong_checksum_is_read_with_a_warning) {
  const formats::TemporaryFolder folder;
  const std::string attachment = raw<std::uint64_t>(1) + raw<std::uint64_t>(1) + counted("notes.txt") +
                                 counted("text/plain") + raw<std::uint64_t>(5) + "hello";
  const auto bag_of = [&](std::uint32_t attachment_sum, std::uint32_t data_lie) {
    const std::string data = opening() + schema() + channel() + hello() + record(9, attachment + raw(attachment_sum));
    const std::uint32_t data_sum = formats::crc32(data) + data_lie;
    return open_quietly(folder.write("a.mcap", data + record(15, raw(data_sum)) + closing(0)));
  };
  expect_hello(*bag_of(formats::crc32(attachment), 0));
  EXPECT_EQ(find(*bag_of(formats::crc32(attachment), 0), "bag-damaged"), nullptr);
  EXPECT_EQ(find(*bag_of(0, 0), "bag-damaged"), nullptr) << "zero says that there is none";
  for (const bool data : {true, false}) {
    const auto bag = bag_of(formats::crc32(attachment) + (data ? 0 : 1), data ? 1 : 0);
    expect_hello(*bag);
    const drive::Finding* finding = find(*bag, "bag-damaged");
    ASSERT_NE(finding, nullptr);
    EXPECT_TRUE(formats::contains(english(finding->explanation), data ? "data" : "Attachments"))
        << english(finding->explanation);
  }
}

TEST(mcap_file, whose_index_is_damaged_between_whole_chunks_does_not_claim_that_its_end_is_missing) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(30);
  std::string bytes = written_mcap(folder, ChunkCompression::Lz4, messages);
  // The first record of a message index, behind the first chunk: its array promises more than the record holds.
  std::size_t offset = kMagic.size();
  const auto length_at = [&](std::size_t at) {
    std::uint64_t length = 0;
    std::memcpy(&length, bytes.data() + at + 1, sizeof length);
    return length;
  };
  while (bytes[offset] != 7) {
    offset += 9 + length_at(offset);
    ASSERT_LT(offset, bytes.size());
  }
  char& highest = bytes[offset + 9 + 2 + 3];  // of the length, behind the channel
  highest = static_cast<char>(highest ^ 0x40);
  const auto bag = open_quietly(folder.write("a.mcap", bytes));
  EXPECT_EQ(count_and_check(*bag, messages), messages.size());
  EXPECT_EQ(find(*bag, "bag-cut-end"), nullptr);
  ASSERT_NE(find(*bag, "bag-unindexed"), nullptr);
  EXPECT_TRUE(formats::contains(english(find(*bag, "bag-unindexed")->explanation), "30 messages were found; 0 bytes"))
      << english(find(*bag, "bag-unindexed")->explanation);
}

}  // namespace
}  // namespace remount::bags
