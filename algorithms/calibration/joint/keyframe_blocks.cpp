#include "algorithms/calibration/joint/keyframe_blocks.h"

#include <algorithm>

#include "algorithms/core/error.h"

namespace remount::calibration {

KeyframeBlocks::KeyframeBlocks(std::size_t keyframes, int block_size, std::vector<Link> links)
    : size_(block_size), matrix_(signed_of(keyframes) * block_size, signed_of(keyframes) * block_size) {
  for (auto& [column, row] : links)
    if (column > row) std::swap(column, row);
  for (motion::KeyframeIndex keyframe; keyframe < keyframes; ++keyframe) links.emplace_back(keyframe, keyframe);
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  starts_.assign(keyframes + 1, 0);
  for (const auto& [column, row] : links) {
    rows_.push_back(row);
    ++starts_[column + 1];
  }
  for (std::size_t column = 1; column < starts_.size(); ++column) starts_[column] += starts_[column - 1];

  const Eigen::Index entries = std::ssize(rows_) * size_ * size_;
  matrix_.resizeNonZeros(entries);
  std::fill_n(matrix_.valuePtr(), entries, 0.0);
  int* inner = matrix_.innerIndexPtr();
  int* outer = matrix_.outerIndexPtr();
  for (std::size_t column = 0; column + 1 < starts_.size(); ++column)
    for (int scalar = 0; scalar < size_; ++scalar) {
      *outer++ = static_cast<int>(inner - matrix_.innerIndexPtr());
      for (std::size_t block = starts_[column]; block < starts_[column + 1]; ++block)
        for (int r = 0; r < size_; ++r) *inner++ = static_cast<int>(rows_[block]) * size_ + r;
    }
  *outer = static_cast<int>(inner - matrix_.innerIndexPtr());
}

KeyframeBlocks::Block KeyframeBlocks::at(motion::KeyframeIndex row, motion::KeyframeIndex column) {
  const std::ptrdiff_t start = signed_of(starts_[column]), end = signed_of(starts_[column + 1]);
  const auto found = std::lower_bound(rows_.begin() + start, rows_.begin() + end, row);
  if (found == rows_.begin() + end || *found != row)
    throw Error(ErrorCode::Contract, "keyframe blocks", Message::verbatim("unlinked keyframes"));
  const std::ptrdiff_t before = found - rows_.begin() - start;
  double* const first = matrix_.valuePtr() + start * size_ * size_ + before * size_;
  return {first, size_, size_, Eigen::OuterStride<>((end - start) * size_)};
}

}  // namespace remount::calibration
