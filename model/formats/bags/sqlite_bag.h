// Bags of ROS 2 in SQLite databases (.db3).
#pragma once

#include <map>
#include <memory>
#include <mutex>

#include "model/formats/bags/bag_file.h"
#include "model/formats/bags/unpacked_file.h"

struct sqlite3;

namespace remount::bags {

/// True where the file begins as an SQLite database does.
bool is_sqlite(std::string_view head);
/// Reads the tables `topics` and `messages`; messages by their rows. Messages that are compressed one by one
/// (Zstandard) are unpacked. A database that is damaged gives what can be read, with a finding "bag-damaged".
class SqliteBag final : public BagFile {
 public:
  /// Throws Error where the file is no such database, or nothing of it can be read.
  SqliteBag(const BagInput& input, Progress& progress);
  ~SqliteBag() override;
  std::string message(const BagEntry& entry, std::size_t at_most) const override;

 private:
  [[noreturn]] void fail(Message what) const;
  void open_database(const std::filesystem::path& path, bool cut);
  bool can_be_read() const;
  void copy_aside(bool cut, Progress& progress);
  void read_topics();
  std::map<std::string, std::string, std::less<>> read_definitions();
  void read_rows(bool cut, Progress& progress);

  BagInput input_;
  std::unique_ptr<sqlite3, int (*)(sqlite3*)> database_;
  mutable std::mutex mutex_;      // one connection, which is not to be used by two at once
  std::uint64_t file_bytes_ = 0;  // with the log beside it
  bool has_log_ = false;
  std::vector<std::pair<std::int64_t, std::size_t>> topic_of_id_;
};

}  // namespace remount::bags
