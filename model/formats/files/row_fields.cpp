#include "model/formats/files/row_fields.h"

#include <algorithm>

namespace remount::formats {
namespace {

/// Of the first rows: all of a long table say no more.
std::vector<std::size_t> counts_of_rows(LineReader lines, const SplitLine& split) {
  constexpr std::size_t kEnough = 200;
  std::vector<std::string_view> fields;
  std::vector<std::size_t> counts;
  for (std::string_view line; counts.size() < kEnough && lines.next(line);) {
    if (trim(line).empty() || line.starts_with('#')) continue;
    split(line, fields);
    counts.push_back(filled_fields(fields));
  }
  return counts;
}

/// The count that there is most often; of several as often the largest. 0 where there is none.
std::size_t usual_count(std::vector<std::size_t> counts) {
  std::ranges::sort(counts);
  std::size_t usual = 0, most = 0;
  for (std::size_t first = 0; first < counts.size();) {
    const auto end = std::upper_bound(counts.begin(), counts.end(), counts[first]) - counts.begin();
    const std::size_t times = static_cast<std::size_t>(end) - first;
    if (times >= most) usual = counts[first], most = times;
    first += times;
  }
  return usual;
}

}  // namespace

std::size_t most_fields(LineReader lines, std::size_t names, const SplitLine& split) {
  constexpr std::size_t kFewestRows = 3;  // of fewer a single broken one would be most
  const std::vector<std::size_t> counts = counts_of_rows(lines, split);
  if (names == 0) return usual_count(counts);
  const auto with_one_more = static_cast<std::size_t>(std::ranges::count(counts, names + 1));
  return names + (counts.size() >= kFewestRows && 2 * with_one_more > counts.size() ? 1 : 0);
}

}  // namespace remount::formats
