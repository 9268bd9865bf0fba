#include "model/io/bag/sqlite_bag.h"

#include <gtest/gtest.h>

#include "tests/model/io/bag/sqlite_fixture.h"

namespace remount {
namespace {

using namespace bags;

void write_metadata(const fs::path& folder, const std::vector<std::string>& files) {
  std::string text =
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n  relative_file_paths:\n";
  for (const std::string& file : files) text += "    - " + file + "\n";
  std::ofstream(folder / "metadata.yaml") << text << "  compression_format: \"\"\n  compression_mode: \"\"\n";
}

TEST(sqlite_bag, is_read_with_and_without_compressed_messages) {
  const TemporaryFolder folder;
  // Some messages fill several pages of the database.
  std::vector<TestMessage> messages = test_messages(60);
  messages[7].bytes += std::string(50'000, 'y');
  for (const bool packed : {false, true}) {
    const fs::path path = folder.path() / (packed ? "packed.db3" : "plain.db3");
    write_database(path, messages, packed);
    const auto bag = open_quietly(path);
    EXPECT_EQ(count_and_check(*bag, messages), messages.size());
    EXPECT_EQ(bag->topics()[0].encoding, MessageEncoding::Cdr);
    EXPECT_TRUE(bag->findings().empty());
  }
}

TEST(sqlite_bag, in_a_folder_with_metadata_is_read_with_all_its_parts) {
  const TemporaryFolder folder;
  const fs::path bag_folder = folder.path() / "my bag?";  // a name that a URI would take apart
  const std::vector<TestMessage> messages = test_messages(60);
  write_database(bag_folder / "bag_0.db3", {messages.begin(), messages.begin() + 25});
  write_database(bag_folder / "bag_1.db3", {messages.begin() + 25, messages.end()});
  write_metadata(bag_folder, {"bag_0.db3", "bag_1.db3"});
  const auto bag = open_quietly(bag_folder);
  EXPECT_EQ(count_and_check(*bag, messages), messages.size());
  EXPECT_EQ(bag->topics().size(), 2u);
  EXPECT_EQ(bag->files().size(), 2u);
  EXPECT_EQ(probe_bag(bag_folder), 95);

  fs::remove(bag_folder / "bag_1.db3");
  const auto half = open_quietly(bag_folder);
  EXPECT_EQ(count_and_check(*half, messages), 25u);
  ASSERT_TRUE(find(*half, "bag-part-missing"));
  EXPECT_TRUE(contains(find(*half, "bag-part-missing")->explanation, "bag_1.db3"));
  write_metadata(bag_folder, {"bag_0.db3.zstd"});
  EXPECT_ERROR(open_quietly(bag_folder), "zstd -d");
}

TEST(sqlite_bag, that_is_damaged_gives_what_can_be_read_or_an_error_with_its_name) {
  const TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(600);
  const fs::path path = folder.path() / "good.db3";
  write_database(path, messages);
  const std::string bytes = bytes_of(path);
  std::size_t opened = 0, refused = 0, warned = 0;
  for (std::size_t length = 0; length < bytes.size(); length += 1500) {
    const fs::path cut = folder.write("cut.db3", bytes.substr(0, length));
    try {
      const auto bag = open_quietly(cut);
      ++opened;
      warned += find(*bag, "bag-damaged") != nullptr;
      for (const BagTopic& topic : bag->topics())
        for (const BagEntry& entry : topic.entries) error_of([&] { bag->message(entry); });
    } catch (const Error& error) {
      EXPECT_TRUE(contains(error.what(), "cut.db3")) << error.what();
      ++refused;
    }
  }
  std::cout << opened << " cuts gave something, " << warned << " of them warned, " << refused << " were refused\n";
  EXPECT_GT(opened, refused);
  EXPECT_EQ(opened, warned);
}

TEST(sqlite_bag, of_other_tables_is_refused) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "other.db3";
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  run(database, "CREATE TABLE people(name TEXT)");
  sqlite3_close(database);
  EXPECT_ERROR(open_quietly(path), "table 'topics'");
}

}  // namespace
}  // namespace remount
