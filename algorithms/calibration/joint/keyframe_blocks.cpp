#include "algorithms/calibration/joint/keyframe_blocks.h"

#include <algorithm>

#include "algorithms/core/error.h"

namespace remount {

KeyframeBlocks::KeyframeBlocks(int keyframes, int block_size, std::vector<std::pair<int, int>> links)
    : size_(block_size), matrix_(keyframes * block_size, keyframes * block_size) {
  for (auto& [column, row] : links)
    if (column > row) std::swap(column, row);
  for (int keyframe = 0; keyframe < keyframes; ++keyframe) links.emplace_back(keyframe, keyframe);
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  starts_.assign(static_cast<std::size_t>(keyframes) + 1, 0);
  for (const auto& [column, row] : links) {
    rows_.push_back(row);
    ++starts_[static_cast<std::size_t>(column) + 1];
  }
  for (std::size_t column = 1; column < starts_.size(); ++column) starts_[column] += starts_[column - 1];

  const Eigen::Index entries = static_cast<Eigen::Index>(rows_.size()) * size_ * size_;
  matrix_.resizeNonZeros(entries);
  std::fill_n(matrix_.valuePtr(), entries, 0.0);
  int* inner = matrix_.innerIndexPtr();
  int* outer = matrix_.outerIndexPtr();
  for (std::size_t column = 0; column + 1 < starts_.size(); ++column)
    for (int scalar = 0; scalar < size_; ++scalar) {
      *outer++ = static_cast<int>(inner - matrix_.innerIndexPtr());
      for (int block = starts_[column]; block < starts_[column + 1]; ++block)
        for (int r = 0; r < size_; ++r) *inner++ = rows_[static_cast<std::size_t>(block)] * size_ + r;
    }
  *outer = static_cast<int>(inner - matrix_.innerIndexPtr());
}

KeyframeBlocks::Block KeyframeBlocks::at(int row, int column) {
  const int start = starts_[static_cast<std::size_t>(column)], end = starts_[static_cast<std::size_t>(column) + 1];
  const auto found = std::lower_bound(rows_.begin() + start, rows_.begin() + end, row);
  if (found == rows_.begin() + end || *found != row)
    throw Error(ErrorCode::Contract, "keyframe blocks", Message::verbatim("unlinked keyframes"));
  const int before = static_cast<int>(found - rows_.begin()) - start;
  double* const first = matrix_.valuePtr() + static_cast<Eigen::Index>(start) * size_ * size_ + before * size_;
  return {first, size_, size_, Eigen::OuterStride<>((end - start) * size_)};
}

}  // namespace remount
