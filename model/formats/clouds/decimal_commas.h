// Commas for the point of decimals, in text whose numbers may be apart by commas.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace remount::formats {

/// Of a line whose numbers are apart by semicolons or blanks the first with a decimal comma ("-1,5"); empty where none
/// has one.
std::string_view decimal_comma_in(std::string_view line);

/// Rows apart by commas that may have commas for the point of decimals as well: "0,50,-1,25,3,05" reads as six numbers.
/// What tells so: whole numbers alone, every other of them without a sign, and these with zeros in front, or of one
/// width while they differ from row to row, or a blank behind every other comma.
class DecimalCommas {
 public:
  void add(std::string_view line);  ///< which must stay until the next is added
  /// Whole numbers alone, as many in each row.
  bool possible() const { return possible_ && rows_ > 0; }
  bool proved() const;

 private:
  static constexpr std::size_t kMost = 16;  // numbers of a row

  void look_at(std::size_t i);

  std::vector<std::string_view> fields_, before_;
  std::array<bool, kMost / 2> varies_{};
  std::size_t rows_ = 0, width_ = 0;
  bool possible_ = true, zeros_in_front_ = false, one_width_ = true, spaced_ = true;
};

}  // namespace remount::formats
