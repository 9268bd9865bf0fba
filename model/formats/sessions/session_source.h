// Where a reader's texts and file names come from: whole files, or what has been added since they were read last.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"

namespace remount::formats {

/// Whole files.
class SessionSource {
 public:
  virtual ~SessionSource() = default;
  /// Whether only what is new is handed out: a stream may then have nothing.
  virtual bool only_new() const { return false; }
  /// Text of a table. Throws as read_text_file.
  virtual std::string table(const std::filesystem::path& file) { return read_text_file(file); }
  /// Files of a folder, in the order of their names.
  virtual std::vector<std::filesystem::path> files(const std::filesystem::path& folder) { return files_in(folder); }
};

/// Text that is in UTF-8 without a mark (is_plain_text).
/// What has been added to tables and folders since it was handed out last: costs in proportion to that. A line that is
/// not complete waits for the rest.
class GrowingSource final : public SessionSource {
 public:
  bool only_new() const override { return true; }
  /// The first line that is no comment and those before it, which may name columns, and the complete lines that are
  /// new; empty where there are none. Throws Error(Io) where the file has become shorter, see shrunk().
  std::string table(const std::filesystem::path& file) override;
  /// Files that were not there. Throws Error(Io) where the folder cannot be listed.
  std::vector<std::filesystem::path> files(const std::filesystem::path& folder) override;

  /// What was handed out since the last call has been used.
  void keep();
  /// It has not: it is handed out again.
  void give_back();
  /// A table has been written anew: all that was handed out of it is void.
  bool shrunk() const { return shrunk_; }

  std::uint64_t bytes_read() const { return bytes_read_; }        ///< of tables, so far
  std::size_t files_examined() const { return files_examined_; }  ///< of folders, so far

 private:
  struct Table {
    std::string head;        // comments and the first line that is none, with their ends
    std::uint64_t used = 0;  // bytes
  };
  std::map<std::filesystem::path, Table> tables_, new_tables_;
  std::map<std::filesystem::path, std::set<std::string>> files_, new_files_;
  bool shrunk_ = false;
  std::uint64_t bytes_read_ = 0;
  std::size_t files_examined_ = 0;
};

}  // namespace remount::formats
