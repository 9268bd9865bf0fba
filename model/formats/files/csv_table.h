// Columns of a CSV file by name.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace remount::formats {

/// The header line of a CSV. Names are compared exactly after trimming; a leading '.' (rostopic echo -p) is not part.
class CsvHeader {
 public:
  CsvHeader() = default;
  /// @param separator ' ': any blanks; a '#' before the first name is none of them then
  explicit CsvHeader(std::string_view line, char separator = ',');
  std::size_t size() const { return names_.size(); }
  const std::vector<std::string>& names() const { return names_; }
  bool has(std::string_view name) const { return find(name) >= 0; }
  int find(std::string_view name) const;  ///< -1 where there is none
  /// Throws Error(Format) naming the file and the columns that are there.
  std::size_t require(std::string_view name, const std::filesystem::path& path) const;

 private:
  std::vector<std::string> names_;
  char separator_ = ',';
};

}  // namespace remount::formats
