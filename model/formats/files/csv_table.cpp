#include "model/formats/files/csv_table.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/ins_logs.h"
#include "model/formats/files/input_file.h"

namespace remount::formats {

CsvHeader::CsvHeader(std::string_view line, char separator) : separator_(separator) {
  std::vector<std::string_view> fields;
  if (separator == ' ') {
    line = trim(line);
    split_blanks(line.starts_with('#') ? line.substr(1) : line, fields);
  } else {
    split_csv(line, fields, separator);
  }
  for (std::string_view field : fields) {
    if (field.starts_with('#')) field = trim(field.substr(1));
    if (field.starts_with('.')) field.remove_prefix(1);
    names_.emplace_back(field);
  }
}

int CsvHeader::find(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  return found == names_.end() ? -1 : static_cast<int>(found - names_.begin());
}

std::size_t CsvHeader::require(std::string_view name, const std::filesystem::path& path) const {
  if (const int index = find(name); index >= 0) return static_cast<std::size_t>(index);
  for (const auto& [separator, words] : {std::pair{';', &say::csv_semicolons}, {'\t', &say::csv_tabs}})
    if (names_.size() == 1 && separator_ == ',' && names_[0].find(separator) != std::string::npos)
      throw Error(ErrorCode::Format, at_line(path, 1), words());
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min<std::size_t>(names_.size(), 40); ++i) names.push_back(names_[i].substr(0, 40));
  throw Error(ErrorCode::Format, at_line(path, 1), say::csv_no_column(std::string(name), std::move(names)));
}

}  // namespace remount::formats
