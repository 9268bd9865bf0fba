#include "algorithms/registration/voxel_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace remount::registration {
namespace {

constexpr std::uint64_t kNoKey = ~std::uint64_t{0};

std::uint64_t voxel_key(const Eigen::Vector3f& point, float inverse_voxel) {
  // 21 bits an axis: 2^20 voxels to either side, beyond any range limit.
  constexpr float kHalf = 1048576.0f;
  const auto cell = [&](float v) {
    const float inside = std::min(std::max(v * inverse_voxel, -kHalf), kHalf - 1.0f);
    // Truncation of a non-negative number is its floor.
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(static_cast<double>(inside) + 1048576.0));
  };
  return (cell(point.z()) << 42) | (cell(point.y()) << 21) | cell(point.x());
}

// Sums relative to the voxel's first point: rounding does not grow with the distance from the sensor.
struct Voxel {
  Eigen::Vector3f first, sum;
  float count;
};

// Open addressing with linear probing; grows by doubling.
class VoxelTable {
 public:
  VoxelTable() : slots_(kFirstSize, {kNoKey, 0}) { voxels_.reserve(kFirstSize / 2); }

  Voxel& at(std::uint64_t key, const Eigen::Vector3f& point) {
    std::size_t slot = slot_of(key);
    while (slots_[slot].key != key && slots_[slot].key != kNoKey) slot = (slot + 1) & (slots_.size() - 1);
    if (slots_[slot].key == key) return voxels_[slots_[slot].voxel];
    slots_[slot] = {key, static_cast<std::uint32_t>(voxels_.size())};
    voxels_.push_back({point, Eigen::Vector3f::Zero(), 0.0f});
    if (2 * voxels_.size() > slots_.size()) grow();
    return voxels_.back();
  }
  const std::vector<Voxel>& voxels() const { return voxels_; }

 private:
  static constexpr std::size_t kFirstSize = std::size_t{1} << 15;
  struct Slot {
    std::uint64_t key;
    std::uint32_t voxel;
  };

  std::size_t slot_of(std::uint64_t key) const {
    return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ULL) >> 32) & (slots_.size() - 1);
  }
  void grow() {
    std::vector<Slot> old(2 * slots_.size(), {kNoKey, 0});
    old.swap(slots_);
    for (const Slot& entry : old) {
      if (entry.key == kNoKey) continue;
      std::size_t slot = slot_of(entry.key);
      while (slots_[slot].key != kNoKey) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = entry;
    }
  }

  std::vector<Slot> slots_;
  std::vector<Voxel> voxels_;
};

}  // namespace

std::vector<Eigen::Vector3f> voxel_centroids(const std::vector<Eigen::Vector3f>& points, float voxel_m,
                                             const Progress& progress) {
  constexpr std::size_t kPointsPerCheck = 1 << 16;
  VoxelTable table;
  std::uint64_t last_key = kNoKey;
  Voxel* voxel = nullptr;  // neighbours in a scan mostly share a voxel
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % kPointsPerCheck == 0 && progress.cancelled()) return {};
    const std::uint64_t key = voxel_key(points[i], 1.0f / voxel_m);
    if (key != last_key) {
      voxel = &table.at(key, points[i]);
      last_key = key;
    }
    voxel->sum += points[i] - voxel->first;
    voxel->count += 1.0f;
  }
  std::vector<Eigen::Vector3f> centroids;
  centroids.reserve(table.voxels().size());
  for (const Voxel& v : table.voxels()) centroids.emplace_back(v.first + v.sum / v.count);
  return centroids;
}

}  // namespace remount::registration
