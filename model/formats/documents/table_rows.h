// Large tables in JSON: an array of flat objects, read row by row.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/messages/message.h"
#include "model/formats/files/random_access_file.h"

namespace remount::formats {

/// Walks the rows of `[{"key": value, …}, …]`. Whatever the size of the file, no more than a piece of it and one row
/// are in memory. Errors are Error(Format) with file and byte, and what was expected.
class TableRows {
 public:
  /// Throws Error(Io) as RandomAccessFile.
  explicit TableRows(const std::filesystem::path& path) : path_(path), file_(path) {}

  /// Goes to the next row; false behind the last. Throws Error(Format) for what is no row, also for one longer than
  /// 64 kB. Where the rows behind it can be found, the next call goes on there; otherwise it returns false.
  bool next();
  /// What is wrong is wrong with the table: there is no list of rows.
  bool is_no_table() const { return !begun_list_; }

  // Of the row that next() went to; each throws Error(Format) where the key is missing or its value is of another kind.
  std::string text(std::string_view key) const;  ///< with \/, \" and \\ resolved
  std::int64_t integer(std::string_view key) const;
  std::vector<double> numbers(std::string_view key, std::size_t count) const;  ///< of a list of so many, finite
  /// Where the row begins, for messages: by its line, where lines tell rows apart, else by its byte.
  std::string place() const;

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

  std::filesystem::path path_;
  RandomAccessFile file_;
  std::string piece_;
  std::uint64_t read_to_ = 0;  ///< bytes of the file that were read
  std::size_t at_ = 0;         ///< in the piece
  bool begun_ = false, begun_list_ = false, ended_ = false;
  std::uint64_t row_begin_ = 0;
  std::size_t line_ = 1, row_line_ = 1;
  std::string row_;
  std::vector<Value> values_;
};

}  // namespace remount::formats
