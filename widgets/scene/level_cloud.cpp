#include "widgets/scene/level_cloud.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "algorithms/cloud/point_cloud.h"
#include "widgets/scene/framing.h"

namespace remount::scene {
namespace {

constexpr int kMostLevels = 20;
constexpr std::size_t kDrawnPerCheck = 1U << 20U;

bool is_measured(const Eigen::Vector3f& point) {
  return point.allFinite() && point.cwiseAbs().maxCoeff() <= cloud::kFarthestReturn_m;
}

/// A cube that is halved `levels` times along each axis. What lies outside belongs to the voxels at its faces.
struct VoxelCube {
  Eigen::Vector3f low_m = Eigen::Vector3f::Zero();
  float edge_m = 1.0F;
  int levels = 1;

  /// Interleaved bits of the finest voxel, the coarsest first.
  std::uint64_t code(const Eigen::Vector3f& point) const {
    const auto most = static_cast<float>((1U << static_cast<unsigned>(levels)) - 1U);
    const Eigen::Vector3f scaled = ((point - low_m) * ((most + 1.0F) / edge_m)).cwiseMax(0.0F).cwiseMin(most);
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const auto voxel = static_cast<std::uint32_t>(scaled[axis]);
      for (int bit = 0; bit < levels; ++bit)
        code |= static_cast<std::uint64_t>((voxel >> static_cast<unsigned>(bit)) & 1U)
                << static_cast<unsigned>(3 * bit + axis);
    }
    return code;
  }
  /// Level of the coarsest voxels that two codes do not share; `levels` where they share all.
  int first_difference(std::uint64_t a, std::uint64_t b) const {
    return a == b ? levels : levels - 1 - (static_cast<int>(std::bit_width(a ^ b)) - 1) / 3;
  }
};

VoxelCube cube_of(const std::vector<Eigen::Vector3f>& points, unsigned index_bits) {
  const Framing framing = robust_framing(points, RigidTransform::Identity());
  VoxelCube cube;
  // Twice the ball that holds most: what is farther out is sparse and hardly thinned.
  cube.edge_m = static_cast<float>(4.0 * framing.radius_m);
  cube.low_m = framing.centre_m.cast<float>() - Eigen::Vector3f::Constant(0.5F * cube.edge_m);
  cube.levels = std::min(kMostLevels, (64 - static_cast<int>(index_bits)) / 3);
  return cube;
}

/// Code and index in one number, sorted by code: neighbours in space are neighbours in the list.
std::vector<std::uint64_t> sorted_codes(const std::vector<Eigen::Vector3f>& points, const VoxelCube& cube,
                                        unsigned index_bits, const Progress& progress) {
  std::vector<std::uint64_t> codes;
  codes.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % kDrawnPerCheck == 0 && progress.cancelled()) return {};
    if (is_measured(points[i])) codes.push_back(cube.code(points[i]) << index_bits | i);
  }
  std::sort(codes.begin(), codes.end());
  return codes;
}

/// A step through n places that visits all, neighbouring visits far apart: the golden section of them.
std::size_t golden_step(std::size_t n) {
  auto step = std::max<std::size_t>(1, static_cast<std::size_t>(0.6180339887 * static_cast<double>(n)));
  while (std::gcd(step, n) != 1) ++step;
  return step;
}

}  // namespace

LevelCloud order_by_levels(const std::vector<Eigen::Vector3f>& points, const Progress& progress) {
  LevelCloud out;
  if (points.empty()) return out;
  const auto index_bits = static_cast<unsigned>(std::bit_width(points.size() - 1));
  const VoxelCube cube = cube_of(points, index_bits);
  const std::vector<std::uint64_t> codes = sorted_codes(points, cube, index_bits, progress);
  if (codes.empty()) {
    out.left_out = progress.cancelled() ? 0 : points.size();
    return out;
  }
  out.left_out = points.size() - codes.size();
  const std::size_t n = codes.size();
  const auto level_of = [&](std::size_t i) {
    return i == 0 ? std::size_t{0}
                  : static_cast<std::size_t>(cube.first_difference(codes[i] >> index_bits, codes[i - 1] >> index_bits));
  };
  std::vector<std::size_t> next(static_cast<std::size_t>(cube.levels) + 2, 0);
  for (std::size_t i = 0; i < n; ++i) ++next[level_of(i) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  out.level_end.assign(next.begin() + 1, next.end());
  for (int level = 0; level < cube.levels; ++level)
    out.level_edge_m.push_back(cube.edge_m / static_cast<float>(2U << static_cast<unsigned>(level)));
  out.level_edge_m.push_back(0.0F);
  out.points.resize(n);
  out.original.resize(n);
  const std::uint64_t index_mask = (std::uint64_t{1} << index_bits) - 1;
  // Within a level, too, each beginning is to show the whole: the list is walked in steps of its golden section.
  const std::size_t step = golden_step(n);
  for (std::size_t k = 0, i = 0; k < n; ++k, i = (i + step) % n) {
    if (k % kDrawnPerCheck == 0 && progress.cancelled()) return {};
    const std::size_t at = next[level_of(i)]++;
    const std::size_t index = codes[i] & index_mask;
    out.points[at] = points[index];
    out.original[at] = static_cast<std::uint32_t>(index);
  }
  return out;
}

}  // namespace remount::scene
