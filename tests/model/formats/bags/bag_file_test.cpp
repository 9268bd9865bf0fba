// Bags of several files, and of files that are compressed as a whole.
#include "model/formats/bags/bag_file.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "tests/model/formats/bags/bag_fixtures.h"
#include "tests/support/temporary_files_in.h"

namespace remount::bags {
namespace {

void write_metadata(const fs::path& folder, const std::vector<std::string>& files) {
  fs::create_directories(folder);
  std::ofstream text(folder / "metadata.yaml");
  text << "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: mcap\n  relative_file_paths:\n";
  for (const std::string& file : files) text << "    - " << file << "\n";
}

void write_mcap(const fs::path& path, const std::vector<TestMessage>& messages,
                ChunkCompression compression = ChunkCompression::Zstd) {
  fs::create_directories(path.parent_path());
  write_messages(*make_mcap_writer(path, MessageEncoding::Cdr, compression, 300), messages);
}

std::string mcap_bytes(const formats::TemporaryFolder& folder, const std::vector<TestMessage>& messages,
                       ChunkCompression compression = ChunkCompression::None) {
  write_mcap(folder.path() / "whole.mcap", messages, compression);
  const std::string bytes = formats::bytes_of(folder.path() / "whole.mcap");
  fs::remove(folder.path() / "whole.mcap");
  return bytes;
}

TEST(bag_file, that_is_an_mcap_compressed_as_a_whole_is_unpacked_and_read_under_its_own_name) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(60);
  const std::string whole = packed(mcap_bytes(folder, messages));
  const fs::path path = folder.write("alone/drive_0.mcap.zstd", whole);
  const fs::path with_metadata = folder.write("bag/drive_0.mcap.zstd", whole).parent_path();
  write_metadata(with_metadata, {"drive_0.mcap.zstd"});
  fs::create_directory(folder.path() / "temporary");
  const testing::TemporaryFilesIn unpacked(folder.path() / "temporary");
  const std::pair<fs::path, int> inputs[] = {{path, 95}, {path.parent_path(), 65}, {with_metadata, 95}};
  for (const auto& [input, sure] : inputs) {
    EXPECT_EQ(probe_bag(input), sure) << input;
    const auto bag = open_quietly(input);
    EXPECT_EQ(count_and_check(*bag, messages), messages.size());
    EXPECT_TRUE(formats::contains(bag->files().front().string(), "drive_0.mcap.zstd"))
        << "the bag is the file that was given";
    BagEntry beyond = bag->topics()[0].entries[0];
    beyond.offset = 1 << 20;
    EXPECT_ERROR(bag->message(beyond), "drive_0.mcap.zstd");
  }
  EXPECT_TRUE(fs::is_empty(folder.path() / "temporary")) << "what was unpacked is gone";
}

TEST(bag_file, compressed_as_a_whole_and_damaged_is_refused_or_gives_its_beginning) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(60);
  const std::string bytes = mcap_bytes(folder, messages), whole = packed(bytes);
  EXPECT_ERROR(open_quietly(folder.write("cut.mcap.zstd", whole.substr(0, whole.size() - 9))), "cut.mcap.zstd");
  std::string damaged = whole;
  damaged.replace(damaged.size() / 2, 60, 60, '\xff');
  EXPECT_ERROR(open_quietly(folder.write("bad.mcap.zstd", damaged)), "bad.mcap.zstd");
  EXPECT_ERROR(open_quietly(folder.write("text.mcap.zstd", packed("no bag"))), "neither an MCAP nor");
  const std::string bomb = packed(std::string(std::size_t{80} << 20, '\0'));
  EXPECT_ERROR(open_quietly(folder.write("bomb.mcap.zstd", bomb)), "unpacks to more than");
  // A recording that was cut before it was compressed.
  const auto half = open_quietly(folder.write("half.mcap.zstd", packed(bytes.substr(0, bytes.size() / 2))));
  const std::size_t count = count_and_check(*half, messages);
  ASSERT_TRUE(find(*half, "bag-unindexed"));
  EXPECT_TRUE(formats::contains(drive::english(find(*half, "bag-unindexed")->where), "half.mcap.zstd"));
  EXPECT_GT(count, 10u);
  EXPECT_LT(count, messages.size());
  EXPECT_EQ(probe_bag(folder.write("notes.txt.zstd", packed("no bag"))), 0) << "other things are compressed, too";
}

TEST(bag_file, whose_unpacking_was_cancelled_has_no_topics) {
  const formats::TemporaryFolder folder;
  const fs::path path = folder.write("a.mcap.zstd", packed(mcap_bytes(folder, test_messages(60))));
  std::stop_source stop;
  stop.request_stop();
  Progress progress(stop.get_token());
  EXPECT_TRUE(open_bag(path, progress)->topics().empty());
}

TEST(bag_file, that_was_split_into_mcaps_is_one_bag) {
  const formats::TemporaryFolder folder;
  const fs::path bag_folder = folder.path() / "drive";
  const std::vector<TestMessage> messages = test_messages(90);
  write_mcap(bag_folder / "drive_0.mcap", {messages.begin(), messages.begin() + 25});
  write_mcap(bag_folder / "drive_1.mcap", {messages.begin() + 25, messages.begin() + 60}, ChunkCompression::None);
  write_mcap(bag_folder / "drive_2.mcap", {messages.begin() + 60, messages.end()}, ChunkCompression::Lz4);
  write_metadata(bag_folder, {"drive_0.mcap", "drive_1.mcap", "drive_2.mcap"});
  const auto bag = open_quietly(bag_folder);
  EXPECT_EQ(count_and_check(*bag, messages), messages.size());
  EXPECT_EQ(bag->topics().size(), 2u) << "a topic of several files is one";
  EXPECT_EQ(bag->files().size(), 3u);
  for (const BagTopic& topic : bag->topics())
    EXPECT_TRUE(std::is_sorted(topic.entries.begin(), topic.entries.end(), [](const BagEntry& a, const BagEntry& b) {
      return a.log_time_ns < b.log_time_ns;
    })) << topic.name;
  EXPECT_TRUE(bag->findings().empty());
}

TEST(bag_file, of_which_a_part_cannot_be_read_gives_the_others_and_names_it) {
  const formats::TemporaryFolder folder;
  const fs::path bag_folder = folder.path() / "drive";
  const std::vector<TestMessage> messages = test_messages(60);
  write_mcap(bag_folder / "drive_0.mcap", {messages.begin(), messages.begin() + 25});
  folder.write("drive/drive_1.mcap", "this is no bag");
  write_metadata(bag_folder, {"drive_0.mcap", "drive_1.mcap"});
  const auto bag = open_quietly(bag_folder);
  EXPECT_EQ(count_and_check(*bag, messages), 25u);
  const drive::Finding* finding = find(*bag, "bag-part-unreadable");
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->severity, drive::Severity::Warning);
  EXPECT_TRUE(formats::contains(drive::english(finding->where), "drive_1.mcap"));
  EXPECT_TRUE(formats::contains(english(finding->explanation), "is no bag that is known"))
      << english(finding->explanation);
  folder.write("drive/drive_0.mcap", "nor is this");
  EXPECT_ERROR(open_quietly(bag_folder), "drive_0.mcap");
}

TEST(bag_file, beside_which_one_is_damaged_names_it) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(25);
  write_mcap(folder.path() / "drive_0.mcap", messages);
  folder.write("notes.txt", "x");
  EXPECT_TRUE(open_quietly(folder.path())->findings().empty());
  folder.write("drive_1.mcap", "");
  const auto bag = open_quietly(folder.path());
  EXPECT_EQ(count_and_check(*bag, messages), 25u);
  const drive::Finding* finding = find(*bag, "bag-part-unreadable");
  ASSERT_TRUE(finding);
  EXPECT_TRUE(formats::contains(drive::english(finding->where), "drive_1.mcap"));
}

}  // namespace
}  // namespace remount::bags
