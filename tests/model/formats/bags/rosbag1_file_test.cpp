#include "model/formats/bags/rosbag1_file.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "tests/model/formats/bags/bag_fixtures.h"

namespace remount::bags {
namespace {

constexpr ChunkCompression kRosbag1Compressions[] = {ChunkCompression::None, ChunkCompression::Bzip2,
                                                     ChunkCompression::Lz4};

std::string written_rosbag1(const formats::TemporaryFolder& folder, ChunkCompression compression,
                            const std::vector<TestMessage>& messages) {
  const fs::path path = folder.path() / "written.bag";
  write_messages(*make_rosbag1_writer(path, compression, 300), messages);
  const std::string bytes = formats::bytes_of(path);
  fs::remove(path);
  return bytes;
}

// ---- A bag put together by hand from the format's description, so that writer and reader cannot err alike

std::string field(const std::string& name, const std::string& value) { return counted(name + "=" + value); }
std::string record(const std::string& header, const std::string& data) { return counted(header) + counted(data); }

struct HandMade {
  std::string chunk_data, chunk, index, bytes;
};

/// One connection, one message "hello" at 1600000000.5 s, in one chunk.
/// @param gap between its parts, as recorders that reserve room leave it
HandMade hand_made(std::uint32_t chunk_size_lie = 0, std::uint32_t count_lie = 1, std::uint32_t offset_lie = 0,
                   const std::string& gap = {}) {
  HandMade bag;
  const std::string time = raw<std::uint32_t>(1'600'000'000) + raw<std::uint32_t>(500'000'000);
  const std::string connection =
      record(field("op", raw<std::uint8_t>(7)) + field("conn", raw<std::uint32_t>(5)) + field("topic", "/greeting"),
             field("topic", "/greeting") + field("type", "std_msgs/String") +
                 field("md5sum", "992ce8a1687cec8c8bd883ec73ca41d1") + field("message_definition", "string data\n"));
  const std::string message =
      record(field("op", raw<std::uint8_t>(2)) + field("conn", raw<std::uint32_t>(5)) + field("time", time), "hello");
  bag.chunk_data = connection + message;
  const auto chunk_size = static_cast<std::uint32_t>(bag.chunk_data.size()) + chunk_size_lie;
  bag.chunk = record(field("op", raw<std::uint8_t>(5)) + field("compression", "none") + field("size", raw(chunk_size)),
                     bag.chunk_data);
  bag.index = record(field("op", raw<std::uint8_t>(4)) + field("ver", raw<std::uint32_t>(1)) +
                         field("conn", raw<std::uint32_t>(5)) + field("count", raw(count_lie)),
                     time + raw(static_cast<std::uint32_t>(connection.size()) + offset_lie));
  const std::string magic = "#ROSBAG V2.0\n";
  const std::uint64_t chunk_pos = magic.size() + 4096,
                      index_pos = chunk_pos + bag.chunk.size() + bag.index.size() + gap.size();
  const std::string head = field("op", raw<std::uint8_t>(3)) + field("index_pos", raw(index_pos)) +
                           field("conn_count", raw<std::uint32_t>(1)) + field("chunk_count", raw<std::uint32_t>(1));
  const std::string info = record(field("op", raw<std::uint8_t>(6)) + field("ver", raw<std::uint32_t>(1)) +
                                      field("chunk_pos", raw(chunk_pos)) + field("start_time", time) +
                                      field("end_time", time) + field("count", raw<std::uint32_t>(1)),
                                  raw<std::uint32_t>(5) + raw<std::uint32_t>(1));
  bag.bytes = magic + record(head, std::string(4096 - 8 - head.size(), ' ')) + bag.chunk + gap + bag.index + gap +
              connection + gap + info + gap;
  return bag;
}

TEST(rosbag1_file, is_read_as_its_format_is_described) {
  const formats::TemporaryFolder folder;
  const auto bag = open_quietly(folder.write("a.bag", hand_made().bytes));
  ASSERT_EQ(bag->topics().size(), 1u);
  const BagTopic& topic = bag->topics()[0];
  EXPECT_EQ(topic.name, "/greeting");
  EXPECT_EQ(topic.type, "std_msgs/String");
  EXPECT_EQ(topic.encoding, MessageEncoding::Ros1);
  ASSERT_EQ(topic.entries.size(), 1u);
  EXPECT_EQ(topic.entries[0].log_time_ns, 1'600'000'000'500'000'000);
  EXPECT_EQ(bag->message(topic.entries[0]), "hello");
  EXPECT_TRUE(bag->findings().empty());
}

// Where the index is said to be lie zeros, or zeros lie between the records.
TEST(rosbag1_file, with_zeros_between_its_parts_has_its_index) {
  const formats::TemporaryFolder folder;
  for (const std::size_t zeros : {4U, 8U, 100U, 4096U, 200'000U}) {
    const auto bag = open_quietly(folder.write("a.bag", hand_made(0, 1, 0, std::string(zeros, '\0')).bytes));
    ASSERT_EQ(bag->topics().size(), 1u) << zeros;
    EXPECT_EQ(bag->message(bag->topics()[0].entries[0]), "hello") << zeros;
    EXPECT_TRUE(bag->findings().empty()) << english(bag->findings().front().explanation);
  }
  // A file system that lost the end of a file that was not closed left zeros there.
  std::string bytes = hand_made().bytes;
  const std::size_t value = bytes.find("index_pos=") + 10;
  bytes.replace(value, 8, std::string(8, '\0'));
  const auto bag = open_quietly(folder.write("a.bag", bytes + std::string(10'000, '\0')));
  EXPECT_EQ(message_count(*bag), 1u);
  EXPECT_TRUE(formats::contains(english(find(*bag, "bag-unindexed")->explanation), "It is readable to its end."));
}

TEST(rosbag1_file, is_written_and_read_in_every_compression) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(60);
  for (const ChunkCompression compression : kRosbag1Compressions) {
    const auto bag = open_quietly(folder.write("a.bag", written_rosbag1(folder, compression, messages)));
    EXPECT_EQ(count_and_check(*bag, messages), messages.size());
    EXPECT_TRUE(bag->findings().empty());
  }
}

TEST(rosbag1_file, that_was_not_closed_is_read_from_its_beginning) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(60);
  for (const ChunkCompression compression : kRosbag1Compressions) {
    std::string bytes = written_rosbag1(folder, compression, messages);
    const std::size_t value = bytes.find("index_pos=") + 10;
    std::uint64_t index_pos = 0;
    std::memcpy(&index_pos, bytes.data() + value, 8);
    bytes.replace(value, 8, raw<std::uint64_t>(0));
    const auto bag = open_quietly(folder.write("a.bag", bytes.substr(0, index_pos)));
    EXPECT_EQ(count_and_check(*bag, messages), messages.size());
    const drive::Finding* finding = find(*bag, "bag-unindexed");
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->severity, drive::Severity::Warning);
    EXPECT_TRUE(formats::contains(english(finding->explanation), "60 messages")) << english(finding->explanation);
  }
}

TEST(rosbag1_file, that_was_cut_anywhere_gives_its_beginning_with_a_count) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(30);
  for (const ChunkCompression compression : kRosbag1Compressions) {
    const std::string bytes = written_rosbag1(folder, compression, messages);
    std::size_t most = 0, refused = 0, warned = 0;
    for (std::size_t length = 0; length < bytes.size(); length += length < 4100 ? 500 : 23) {
      const fs::path path = folder.write("a.bag", bytes.substr(0, length));
      try {
        const auto bag = open_quietly(path);
        const std::size_t count = count_and_check(*bag, messages);
        EXPECT_GE(count, most) << "cut at byte " << length;
        most = std::max(most, count);
        const drive::Finding* finding = find(*bag, "bag-unindexed");
        ASSERT_TRUE(finding) << "cut at byte " << length;
        EXPECT_TRUE(
            formats::contains(english(finding->explanation), "beginning: " + std::to_string(count) + " message"))
            << english(finding->explanation);
        ++warned;
      } catch (const Error& error) {
        EXPECT_EQ(most, 0u) << "cut at byte " << length << ": " << error.what();
        EXPECT_TRUE(formats::contains(error.what(), "a.bag")) << error.what();
        ++refused;
      }
    }
    std::cout << "compression " << static_cast<int>(compression) << ": " << refused << " cuts refused, " << warned
              << " gave up to " << most << " of 30 messages\n";
    EXPECT_EQ(most, messages.size());  // the index alone was cut
    EXPECT_GT(warned, refused / 2);
  }
}

TEST(rosbag1_file, with_a_damaged_chunk_keeps_the_others) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(60);
  std::string bytes = written_rosbag1(folder, ChunkCompression::Bzip2, messages);
  bytes.replace(bytes.find("BZh9", bytes.find("BZh9") + 4) + 6, 4, "evil");
  const auto bag = open_quietly(folder.write("a.bag", bytes));
  std::size_t good = 0;
  std::string first;
  for (const BagTopic& topic : bag->topics())
    for (const BagEntry& entry : topic.entries) try {
        bag->message(entry);
        ++good;
      } catch (const Error& error) {
        if (first.empty()) first = error.what();
      }
  std::cout << good << " of 60 messages are left; " << first << "\n";
  EXPECT_GT(good, 30u);
  EXPECT_LT(good, 60u);
  EXPECT_TRUE(formats::contains(first, "damaged")) << first;
}

TEST(rosbag1_file, of_lies_is_refused_with_the_place) {
  const formats::TemporaryFolder folder;
  const auto open_bytes = [&](const std::string& bytes) {
    const auto bag = open_quietly(folder.write("a.bag", bytes));
    for (const BagTopic& topic : bag->topics())
      for (const BagEntry& entry : topic.entries) bag->message(entry);
  };
  EXPECT_EQ(formats::error_of([&] { open_bytes(hand_made().bytes); }), "");
  EXPECT_ERROR(open_bytes(hand_made(0xf0000000U).bytes), "promises");   // a chunk of four gigabytes
  EXPECT_ERROR(open_bytes(hand_made(0, 1, 1'000'000).bytes), "a.bag");  // an entry beyond its chunk
  EXPECT_ERROR(open_bytes("#ROSBAG V1.2\n" + std::string(5000, ' ')), "older version");
  EXPECT_ERROR(open_bytes("#ROSBAG V2"), "no readable message (it was not closed)");
  EXPECT_ERROR(open_bytes("#ROSBAG V2.0\n"), "a.bag");
  std::string header_lie = hand_made().bytes;
  header_lie.replace(13, 4, raw<std::uint32_t>(0x7fffffff));
  EXPECT_ERROR(open_bytes(header_lie), "header promises");
  std::string encrypted = hand_made().bytes;
  const std::string plain = encrypted.substr(13, 4096);
  const std::string head = plain.substr(4, 60) + field("encryptor", "rosbag/AesCbcEncryptor");
  EXPECT_ERROR(open_bytes("#ROSBAG V2.0\n" +
                          record(field("op", raw<std::uint8_t>(3)) + field("index_pos", raw<std::uint64_t>(0)) +
                                     field("encryptor", "rosbag/AesCbcEncryptor"),
                                 "")),
               "encrypted");
  // An index that lies about its number of entries is left aside: the bag is read from its beginning.
  const auto bag = open_quietly(folder.write("a.bag", hand_made(0, 0x7fffffff).bytes));
  EXPECT_TRUE(find(*bag, "bag-unindexed"));
  EXPECT_EQ(message_count(*bag), 1u);
}

TEST(rosbag1_file, in_a_folder_with_others_is_asked_for) {
  const formats::TemporaryFolder folder;
  folder.write("one/a.bag", hand_made().bytes);
  folder.write("two/a.bag", hand_made().bytes);
  folder.write("two/b.bag", hand_made().bytes);
  EXPECT_EQ(message_count(*open_quietly(folder.path() / "one")), 1u);
  EXPECT_ERROR(open_quietly(folder.path() / "two"), "b.bag");
}

}  // namespace
}  // namespace remount::bags
