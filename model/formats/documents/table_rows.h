// Large tables in JSON: an array of flat objects, read row by row.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/formats/files/random_access_file.h"

namespace remount::formats {

/// Walks the rows of `[{"key": value, …}, …]`. Whatever the size of the file, no more than a piece of it and one row
/// are in memory. Errors are Error(Format) with file and byte, and what was expected.
class TableRows {
 public:
  /// Throws Error(Io) as RandomAccessFile.
  explicit TableRows(const std::filesystem::path& path) : file_(path) {}

  /// Goes to the next row; false behind the last. Throws Error(Format), also for a row longer than 64 kB.
  bool next();

  // Of the row that next() went to; each throws Error(Format) where the key is missing or its value is of another kind.
  std::string text(std::string_view key) const;  ///< with \/, \" and \\ resolved
  std::int64_t integer(std::string_view key) const;
  std::vector<double> numbers(std::string_view key, std::size_t count) const;  ///< of a list of so many, finite
  std::string place() const { return file_.place(row_begin_); }                ///< for messages

 private:
  struct Value {
    std::string_view key, raw;
    bool is_text = false;
  };

  bool has_more();  ///< reads on where the piece is used up
  char skip_to_sign();
  [[noreturn]] void fail(Message what) const;
  void cut_row();
  void take_apart();
  const Value& value(std::string_view key) const;

  RandomAccessFile file_;
  std::string piece_;
  std::uint64_t read_to_ = 0;  ///< bytes of the file that were read
  std::size_t at_ = 0;         ///< in the piece
  bool begun_ = false, ended_ = false;
  std::uint64_t row_begin_ = 0;
  std::string row_;
  std::vector<Value> values_;
};

}  // namespace remount::formats
