// A database of rosbag2 that is larger than what 32 bits address.
#include <sqlite3.h>

#include <cstring>

#include "tests/model/formats/bags/large_fixture.h"
#include "tests/model/formats/bags/sqlite_fixture.h"
#include "tests/support/sanitized.h"

namespace remount::bags {
namespace {

/// SQLite's own files, but that zeros at the end of a page are not written where the file grows. Each page of a long
/// value begins with the number of the next: one block of the file system for each of the largest pages, 64 KB, is as
/// sparse as a database can be, and twenty gigabytes would take more than one.
class WithHoles {
 public:
  static constexpr const char* kName = "with-holes";
  WithHoles() {
    const sqlite3_vfs* usual = sqlite3_vfs_find(nullptr);
    vfs_ = *usual;
    vfs_.zName = kName;
    usual_open() = usual->xOpen;
    vfs_.xOpen = open;
    sqlite3_vfs_register(&vfs_, 0);
  }
  ~WithHoles() { sqlite3_vfs_unregister(&vfs_); }
  WithHoles(const WithHoles&) = delete;
  WithHoles& operator=(const WithHoles&) = delete;

 private:
  using Open = int (*)(sqlite3_vfs*, const char*, sqlite3_file*, int, int*);
  static Open& usual_open() {
    static Open function = nullptr;
    return function;
  }
  static const sqlite3_io_methods*& usual() {
    static const sqlite3_io_methods* methods = nullptr;
    return methods;
  }
  static int open(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* out_flags) {
    static sqlite3_io_methods holey;
    const int code = usual_open()(vfs, name, file, flags, out_flags);
    if (code != SQLITE_OK || !(flags & SQLITE_OPEN_MAIN_DB)) return code;
    usual() = file->pMethods;
    holey = *usual();
    holey.xWrite = write;
    file->pMethods = &holey;
    return code;
  }
  static int write(sqlite3_file* file, const void* data, int bytes, sqlite3_int64 offset) {
    sqlite3_int64 size = 0;
    usual()->xFileSize(file, &size);
    if (offset < size) return usual()->xWrite(file, data, bytes, offset);
    const char* const from = static_cast<const char*>(data);
    int kept = bytes;
    while (kept > 0 && from[kept - 1] == 0) --kept;
    const int code = kept > 0 ? usual()->xWrite(file, data, kept, offset) : SQLITE_OK;
    return code == SQLITE_OK ? usual()->xTruncate(file, offset + bytes) : code;
  }

  sqlite3_vfs vfs_{};
};

void write_large_database(const fs::path& path, int scans, std::uint64_t scan_bytes) {
  const WithHoles holes;
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, WithHoles::kName),
            SQLITE_OK);
  // A scan fits the cache: its pages are written in their order, each where the file ends.
  run(database,
      "PRAGMA page_size = 65536; PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; PRAGMA cache_size = "
      "-60000;" +
          std::string(kRosbag2Tables));
  for (std::size_t id = 0; id < 3; ++id) {
    std::string type = kLargeTypes[id];
    type.insert(type.find('/'), "/msg");
    run(database,
        "INSERT INTO topics VALUES(" + std::to_string(id) + ", '" + kLargeTopics[id] + "', '" + type + "', 'cdr', '')");
  }
  sqlite3_stmt* insert = nullptr;
  ASSERT_EQ(sqlite3_prepare_v2(database, "INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)", -1, &insert,
                               nullptr),
            SQLITE_OK);
  const auto add = [&](int topic, std::int64_t time_ns, const std::string& bytes) {
    sqlite3_bind_int64(insert, 1, topic);
    sqlite3_bind_int64(insert, 2, time_ns);
    sqlite3_bind_blob(insert, 3, bytes.data(), static_cast<int>(bytes.size()), SQLITE_STATIC);
    EXPECT_EQ(sqlite3_step(insert), SQLITE_DONE) << sqlite3_errmsg(database);
    sqlite3_reset(insert);
  };
  std::string bytes;
  for (int i = 0; i < scans; ++i) {
    run(database, "BEGIN");
    for (int k = 0; k < kInsPerScan; ++k) {
      const LargeInsMessages ins = large_ins_messages(kInsPerScan * i + k, kCdr);
      add(1, ins.stamp_ns, ins.imu);
      add(2, ins.stamp_ns, ins.fix);
    }
    const LargeScan scan = large_scan(i, scan_bytes, kCdr);
    bytes.resize(scan.bytes(), '\0');
    bytes.replace(0, scan.begin.size(), scan.begin);
    bytes.replace(bytes.size() - scan.end.size(), scan.end.size(), scan.end);
    add(0, scan.stamp_ns, bytes);
    run(database, "COMMIT");
  }
  sqlite3_finalize(insert);
  EXPECT_EQ(sqlite3_close(database), SQLITE_OK);
}

TEST(large_sqlite, opens_more_than_four_gigabytes_in_seconds_and_takes_memory_for_one_scan_at_a_time) {
  constexpr int kScans = testing::kSanitized ? 40 : 420;
  constexpr std::uint64_t kScanBytes = 10'500'000;
  const formats::TemporaryFolder folder;
  const fs::path path = folder.path() / "drive.db3";
  write_large_database(path, kScans, kScanBytes);
  if (!testing::kSanitized) {
    ASSERT_GT(fs::file_size(path), std::uint64_t{1} << 32);
  }
  expect_opens_in_seconds(path, kScans, kScanBytes);
}

}  // namespace
}  // namespace remount::bags
