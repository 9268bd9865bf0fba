#include "model/formats/bags/sqlite_bag.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include "algorithms/messages/render.h"
#include "tests/model/formats/bags/sqlite_fixture.h"
#include "tests/support/temporary_files_in.h"

namespace remount::bags {
namespace {

void write_sqlite_metadata(const fs::path& folder, const std::vector<std::string>& files) {
  std::string text =
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n  relative_file_paths:\n";
  for (const std::string& file : files) text += "    - " + file + "\n";
  std::ofstream(folder / "metadata.yaml") << text << "  compression_format: \"\"\n  compression_mode: \"\"\n";
}

TEST(sqlite_bag, is_read_with_and_without_compressed_messages) {
  const formats::TemporaryFolder folder;
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
  const formats::TemporaryFolder folder;
  const fs::path bag_folder = folder.path() / "my bag?";  // a name that a URI would take apart
  const std::vector<TestMessage> messages = test_messages(60);
  write_database(bag_folder / "bag_0.db3", {messages.begin(), messages.begin() + 25});
  write_database(bag_folder / "bag_1.db3", {messages.begin() + 25, messages.end()});
  write_sqlite_metadata(bag_folder, {"bag_0.db3", "bag_1.db3"});
  const auto bag = open_quietly(bag_folder);
  EXPECT_EQ(count_and_check(*bag, messages), messages.size());
  EXPECT_EQ(bag->topics().size(), 2u);
  EXPECT_EQ(bag->files().size(), 2u);
  EXPECT_EQ(probe_bag(bag_folder), 95);

  fs::remove(bag_folder / "bag_1.db3");
  const auto half = open_quietly(bag_folder);
  EXPECT_EQ(count_and_check(*half, messages), 25u);
  ASSERT_TRUE(find(*half, "bag-part-missing"));
  EXPECT_TRUE(formats::contains(english(find(*half, "bag-part-missing")->explanation), "bag_1.db3"));
  write_sqlite_metadata(bag_folder, {"bag_0.db3.zstd"});  // unpacked by hand
  EXPECT_EQ(count_and_check(*open_quietly(bag_folder), messages), 25u);
  fs::remove(bag_folder / "bag_0.db3");
  EXPECT_ERROR(open_quietly(bag_folder), "are not here");
}

TEST(sqlite_bag, that_is_compressed_as_a_whole_is_unpacked_into_a_temporary_file) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(60);
  write_database(folder.path() / "plain.db3", messages);
  const std::string bytes = formats::bytes_of(folder.path() / "plain.db3");
  const std::string packed = pack_chunk(ChunkCompression::Zstd, bytes);
  const fs::path path = folder.write("bag/drive_0.db3.zstd", packed);
  write_sqlite_metadata(path.parent_path(), {"drive_0.db3.zstd"});
  fs::create_directory(folder.path() / "temporary");
  const testing::TemporaryFilesIn unpacked(folder.path() / "temporary");
  for (const fs::path& input : {path, path.parent_path()}) {
    EXPECT_EQ(probe_bag(input), 95) << input;
    const auto bag = open_quietly(input);
    EXPECT_EQ(count_and_check(*bag, messages), messages.size());
    EXPECT_EQ(bag->files().front(), path) << "the bag is the file that was given";
  }
  EXPECT_ERROR(open_quietly(folder.write("cut.db3.zstd", packed.substr(0, packed.size() - 9))), "cut.db3.zstd");
  std::string damaged = packed;
  damaged.replace(damaged.size() / 2, 60, 60, '\xff');
  EXPECT_ERROR(open_quietly(folder.write("bad.db3.zstd", damaged)), "bad.db3.zstd");
  EXPECT_ERROR(open_quietly(folder.write("text.db3.zstd", pack_chunk(ChunkCompression::Zstd, "no database"))),
               "zstd -d");
  const std::string bomb = pack_chunk(ChunkCompression::Zstd, std::string(std::size_t{80} << 20, '\0'));
  EXPECT_LT(bomb.size(), 100'000u);
  EXPECT_ERROR(open_quietly(folder.write("bomb.db3.zstd", bomb)), "unpacks to more than");
  EXPECT_TRUE(fs::is_empty(folder.path() / "temporary")) << "what was unpacked is gone";
}

TEST(sqlite_bag, that_is_damaged_gives_what_can_be_read_or_an_error_with_its_name) {
  const formats::TemporaryFolder folder;
  const std::vector<TestMessage> messages = test_messages(600);
  const fs::path path = folder.path() / "good.db3";
  write_database(path, messages);
  const std::string bytes = formats::bytes_of(path);
  std::size_t opened = 0, refused = 0, warned = 0;
  for (std::size_t length = 0; length < bytes.size(); length += 1500) {
    const fs::path cut = folder.write("cut.db3", bytes.substr(0, length));
    try {
      const auto bag = open_quietly(cut);
      ++opened;
      warned += find(*bag, "bag-damaged") != nullptr;
      for (const BagTopic& topic : bag->topics())
        for (const BagEntry& entry : topic.entries) formats::error_of([&] { bag->message(entry); });
    } catch (const Error& error) {
      EXPECT_TRUE(formats::contains(error.what(), "cut.db3")) << error.what();
      ++refused;
    }
  }
  std::cout << opened << " cuts gave something, " << warned << " of them warned, " << refused << " were refused\n";
  EXPECT_GT(opened, refused);
  EXPECT_EQ(opened, warned);
}

/// Nobody in particular, who may not write where the folder's owner alone may; with the folder for temporary files in
/// a place of its own.
class AsNobody {
 public:
  explicit AsNobody(const fs::path& temporary) : before_(fs::temp_directory_path()) {
    ::setenv("TMPDIR", temporary.c_str(), 1);
    if (was_root_) changed_ = ::seteuid(65534) == 0;
  }
  ~AsNobody() {
    if (changed_) static_cast<void>(::seteuid(0));
    ::setenv("TMPDIR", before_.c_str(), 1);
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;
  bool may_write_anywhere() const { return was_root_ && !changed_; }

 private:
  fs::path before_;
  bool was_root_ = ::geteuid() == 0, changed_ = false;
};

TEST(sqlite_bag, with_a_log_where_nothing_can_be_written_is_copied_aside) {
  const formats::TemporaryFolder folder, aside;
  const std::vector<TestMessage> messages = test_messages(60);
  const fs::path whole = folder.path() / "whole.db3", bag_folder = folder.path() / "bag",
                 path = bag_folder / "live.db3";
  write_database(whole, messages);
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(whole.c_str(), &database), SQLITE_OK);
  run(database, "PRAGMA journal_mode = WAL; PRAGMA wal_autocheckpoint = 0;");
  run(database, "INSERT INTO messages(topic_id, timestamp, data) SELECT topic_id, timestamp, data FROM messages");
  fs::create_directory(bag_folder);
  fs::copy_file(whole, path);
  fs::copy_file(whole.string() + "-wal", path.string() + "-wal");
  sqlite3_close(database);
  for (const fs::path& file : {path, fs::path(path.string() + "-wal")}) fs::permissions(file, fs::perms(0444));
  fs::permissions(bag_folder, fs::perms(0555));
  fs::permissions(folder.path(), fs::perms(0755));
  fs::permissions(aside.path(), fs::perms(0777));
  {
    const AsNobody nobody(aside.path());
    if (nobody.may_write_anywhere()) GTEST_SKIP() << "root may write everywhere";
    const auto bag = open_quietly(path);
    EXPECT_EQ(message_count(*bag), 2 * messages.size()) << "those of the log, too";
    EXPECT_TRUE(find(*bag, "bag-copied"));
    EXPECT_EQ(bag->files().front(), path);
    EXPECT_EQ(bag->message(bag->topics()[0].entries[0]).substr(0, 7), "message");
    EXPECT_FALSE(fs::is_empty(aside.path()));
    // Another that looks for leftovers takes none of what is in use.
    EXPECT_EQ(message_count(*open_quietly(path)), 2 * messages.size());
    EXPECT_EQ(bag->message(bag->topics()[0].entries[1]).substr(0, 7), "message");
  }
  EXPECT_TRUE(fs::is_empty(aside.path()));
  fs::permissions(bag_folder, fs::perms(0755));
}

TEST(sqlite_bag, of_other_tables_is_refused) {
  const formats::TemporaryFolder folder;
  const fs::path path = folder.path() / "other.db3";
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  run(database, "CREATE TABLE people(name TEXT)");
  sqlite3_close(database);
  EXPECT_ERROR(open_quietly(path), "table 'topics'");
}

TEST(sqlite_bag, with_a_view_that_has_no_end_is_refused) {
  const formats::TemporaryFolder folder;
  const std::string endless = " AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c) SELECT x AS id, ";
  for (const bool topics : {true, false}) {
    const fs::path path = folder.path() / (topics ? "topics.db3" : "messages.db3");
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
    run(database,
        topics ? "CREATE VIEW topics" + endless + "'a' AS name, 't' AS type, 'cdr' AS serialization_format FROM c"
               : "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT)");
    run(database, topics
                      ? "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB)"
                      : "CREATE VIEW messages" + endless + "7 AS topic_id, 0 AS timestamp, x'' AS data FROM c");
    sqlite3_close(database);
    EXPECT_ERROR(open_quietly(path), topics ? "table 'topics'" : "table 'messages'");
  }
}

}  // namespace
}  // namespace remount::bags
