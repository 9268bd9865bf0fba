#include "algorithms/calibration/joint/keyframe_blocks.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"

namespace remount::calibration {

BlockPattern::BlockPattern(std::size_t size, std::vector<Link> links) {
  for (auto& [column, row] : links)
    if (column > row) std::swap(column, row);
  for (std::size_t block = 0; block < size; ++block) links.emplace_back(block, block);
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  starts_.assign(size + 1, 0);
  for (const auto& [column, row] : links) {
    rows_.push_back(row);
    ++starts_[column + 1];
  }
  for (std::size_t column = 1; column < starts_.size(); ++column) starts_[column] += starts_[column - 1];
}

std::size_t BlockPattern::place(std::size_t row, std::size_t column) const {
  const auto start = rows_.begin() + signed_of(starts_[column]), end = rows_.begin() + signed_of(starts_[column + 1]);
  const auto found = std::lower_bound(start, end, row);
  if (found == end || *found != row)
    throw Error(ErrorCode::Contract, "keyframe blocks", Message::verbatim("unlinked keyframes"));
  return static_cast<std::size_t>(found - rows_.begin());
}

}  // namespace remount::calibration
