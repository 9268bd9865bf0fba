// The inner loops of registration, compiled once for AVX2 and once for any processor. Both do the same operations in
// the same order without fused multiply-add, so that their results are the same bit for bit.
#pragma once

#include <cstdint>

#include "algorithms/registration/instruction_set.h"

namespace remount::registration {

inline constexpr int kBlockSize = 16;
inline constexpr float kFarAway_m = 1e18f;  ///< coordinates of missing points: finite, and near nothing

inline constexpr float kMinCosine = 0.7f;  ///< of the normals of a match: surfaces that face apart are not the same
/// 1 - variance along a normal against that in the plane: two normals that differ by 3.6 degrees count half as much
/// along the surface's normal as two that agree.
inline constexpr float kKeep = 0.999f;

/// Sixteen neighbouring points with their surface. Missing ones at the end of a cloud are far away.
struct alignas(64) PointBlock {
  float x[kBlockSize], y[kBlockSize], z[kBlockSize];     ///< m
  float nx[kBlockSize], ny[kBlockSize], nz[kBlockSize];  ///< unit length
  float planarity[kBlockSize];                           ///< 0 (scattered, or no surface) to 1 (a thin plane)
};

/// Bounding boxes of up to eight children (blocks, or nodes one level down); missing ones are inside out.
struct alignas(64) BoxNode {
  float low[3][8], high[3][8];
};

/// A search tree over blocks in spatial order: level 0 holds the boxes of blocks, eight to a node, each further level
/// those of eight nodes, up to a single one.
struct BlockTreeView {
  static constexpr int kMostLevels = 10;  // 8^10 blocks
  const PointBlock* blocks = nullptr;
  const BoxNode* nodes = nullptr;
  std::int32_t level_begin[kMostLevels] = {};  ///< first node of each level
  std::int32_t levels = 0;                     ///< 0: no points
  std::int32_t block_count = 0;
};

/// The neighbours of a block of source points in the target, and how far each query may move before they can change.
struct alignas(64) MatchBlock {
  PointBlock target;
  float at_x[kBlockSize], at_y[kBlockSize], at_z[kBlockSize];  ///< queries as last searched
  float reach2_m2[kBlockSize];     ///< squared distance that the query may move; negative: must be searched
  std::int32_t index[kBlockSize];  ///< of the neighbour, -1 for none within the search radius
};

/// Rotation (row by row) and translation of target_from_source.
struct FloatTransform {
  float rotation[9];
  float translation[3];
};

struct MatchTask {
  const PointBlock* source = nullptr;
  MatchBlock* matches = nullptr;
  std::int32_t first = 0, last = 0, step = 1;  ///< blocks
  FloatTransform target_from_source;
  float radius_m = 1.0f;            ///< neighbours farther away than this need not be known
  std::int32_t* scratch = nullptr;  ///< room for as many numbers as the target has blocks
};

/// Squared residuals along the normals, m2; negative where there is no match.
struct alignas(64) ResidualBlock {
  float squared_m2[kBlockSize];
};

struct SumsTask {
  const PointBlock* source = nullptr;
  const MatchBlock* matches = nullptr;
  std::int32_t first = 0, last = 0, step = 1;  ///< blocks
  FloatTransform target_from_source;
  float radius_m = 1.0f;
  float kernel_m = 0.5f;               ///< residuals much larger than this hardly count (Geman-McClure)
  ResidualBlock* residuals = nullptr;  ///< out, one a block
};

/// Normal equations of plane-to-plane alignment, upper triangle by rows, translation first.
struct AlignmentSums {
  double hessian[21] = {};
  double gradient[6] = {};
  double inliers = 0.0;
};

/// The surface through the points around each point: the smallest of the radii r, 2 r, 4 r whose sphere holds at least
/// `min_points` points that are not on a line. One ring alone is as wide as its range noise, and its plane tilts with
/// the rays instead of lying on the ground.
struct NormalTask {
  PointBlock* blocks = nullptr;  ///< normals and planarity are written; planarity -1: no surface
  std::int32_t first = 0, last = 0;
  float radius_m = 0.6f;
  float min_points = 8.0f;
  float min_width_ratio = 0.2f;  ///< second variance against the first
  std::int32_t* scratch = nullptr;
};

struct Kernels {
  void (*match)(const BlockTreeView& target, const MatchTask&);
  void (*accumulate)(const SumsTask&, AlignmentSums&);
  void (*fit_normals)(const BlockTreeView&, const NormalTask&);
};

const Kernels& kernels(InstructionSet instructions);
/// Whether this processor runs the AVX2 kernels.
bool has_fast_kernels();

extern const Kernels kPortableKernels;
#ifdef __x86_64__
extern const Kernels kAvx2Kernels;
#endif

}  // namespace remount::registration
