// Small bags for the tests of their readers.
#pragma once

#include <fstream>
#include <vector>

#include "model/formats/bags/bag_file.h"
#include "model/formats/bags/bag_writer.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::bags {

namespace fs = std::filesystem;

inline constexpr std::int64_t kStart_ns = 1'600'000'000'000'000'000;

/// Of a type that message_definition does not know; its text is not looked at.
inline MessageDefinition definition(const std::string& type) { return {type, "*", "float64 x\n"}; }

struct TestMessage {
  std::uint32_t topic = 0;  ///< 0 or 1
  std::int64_t time_ns = 0;
  std::string bytes;
};

/// Messages of two topics whose content tells them apart.
inline std::vector<TestMessage> test_messages(int count) {
  std::vector<TestMessage> messages;
  for (int i = 0; i < count; ++i)
    messages.push_back({static_cast<std::uint32_t>(i % 3 == 0), kStart_ns + i * 10'000'000LL,
                        "message " + std::to_string(i) + std::string(static_cast<std::size_t>(i % 7) * 11, 'x')});
  return messages;
}

inline void write_messages(BagWriter& bag, const std::vector<TestMessage>& messages) {
  for (const char* name : {"/a", "/b"}) bag.add_topic(name, definition("test_msgs/Text"));
  for (const TestMessage& message : messages) bag.write(message.topic, message.time_ns, message.bytes);
  bag.finish();
}

inline std::shared_ptr<const BagFile> open_quietly(const fs::path& path) {
  Progress progress;
  return open_bag(path, progress);
}

inline std::string packed(const std::string& bytes) { return pack_chunk(ChunkCompression::Zstd, bytes); }

inline const drive::Finding* find(const BagFile& bag, const std::string& code) {
  return testing::finding_of(bag.findings(), code);
}

/// How many of the messages the bag has; each must be the one that was written, none may be made up.
inline std::size_t count_and_check(const BagFile& bag, const std::vector<TestMessage>& messages) {
  std::size_t count = 0;
  for (const BagTopic& topic : bag.topics()) {
    EXPECT_EQ(topic.type, "test_msgs/Text");
    for (const BagEntry& entry : topic.entries) {
      const auto i = static_cast<std::size_t>((entry.log_time_ns - kStart_ns) / 10'000'000);
      if (i >= messages.size()) {
        ADD_FAILURE() << "a message of time " << entry.log_time_ns << " was never written";
        continue;
      }
      EXPECT_EQ(topic.name, messages[i].topic == 0 ? "/a" : "/b");
      EXPECT_EQ(bag.message(entry), messages[i].bytes);
      EXPECT_EQ(bag.message(entry, 5), messages[i].bytes.substr(0, 5));
      ++count;
    }
  }
  return count;
}

inline std::size_t message_count(const BagFile& bag) {
  std::size_t count = 0;
  for (const BagTopic& topic : bag.topics()) count += topic.entries.size();
  return count;
}

template <class T>
std::string raw(T value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

/// With its length before it, in 32 bits.
inline std::string counted(const std::string& text) { return raw(static_cast<std::uint32_t>(text.size())) + text; }

}  // namespace remount::bags
