// The inner loops themselves; see kernels.h. Included once by each file that compiles them for its processors.
#pragma once

#include "algorithms/registration/kernels.h"
#include "algorithms/registration/lanes.h"

namespace remount::registration {
namespace {

// Neighbours pull in the plane as well, which helps from afar, and towards no motion at all, for a sensor's rings look
// alike from everywhere: no more of it than convergence needs.
constexpr float kInPlane = 0.1f;
// A new search looks this much farther than the neighbour that is known, so that the next one is often seen as well.
constexpr float kMargin_m = 0.3f;
constexpr float kFarther = 1.15f;     // than the largest distance that counts, to know when it may be passed
constexpr float kRounding_m = 2e-5f;  // of distances between points at a hundred metres

struct Box {
  float low[3], high[3];
};

// Squared distances from a box to eight others (zero where they overlap).
inline Lanes distances2(const BoxNode& node, const Box& box) {
  Lanes sum{};
  for (int axis = 0; axis < 3; ++axis) {
    const Lanes outside = larger(load(node.low[axis]) - box.high[axis], box.low[axis] - load(node.high[axis]));
    const Lanes gap = larger(outside, Lanes{});
    sum += gap * gap;
  }
  return sum;
}

// Indices of all blocks within a radius of the box; the one nearest to it comes first.
int blocks_near(const BlockTreeView& tree, const Box& box, float radius2_m2, std::int32_t* found) {
  struct Entry {
    std::int32_t level, node;
  };
  Entry stack[8 * BlockTreeView::kMostLevels];
  int depth = 0, count = 0, nearest = 0;
  float nearest2 = kFarAway_m;
  if (tree.levels > 0) stack[depth++] = {tree.levels - 1, 0};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    const Lanes gaps2 = distances2(tree.nodes[tree.level_begin[entry.level] + entry.node], box);
    for (unsigned bits = bits_of(gaps2 <= radius2_m2); bits != 0; bits &= bits - 1) {
      const int child = __builtin_ctz(bits);
      if (entry.level > 0) {
        stack[depth++] = {entry.level - 1, 8 * entry.node + child};
        continue;
      }
      if (gaps2[child] < nearest2) {
        nearest2 = gaps2[child];
        nearest = count;
      }
      found[count++] = 8 * entry.node + child;
    }
  }
  if (count > 0) {
    const std::int32_t first = found[0];
    found[0] = found[nearest];
    found[nearest] = first;
  }
  return count;
}

inline Lanes3 rotate(const FloatTransform& t, const Lanes3& v) {
  const float* r = t.rotation;
  return {v.x * r[0] + v.y * r[1] + v.z * r[2], v.x * r[3] + v.y * r[4] + v.z * r[5],
          v.x * r[6] + v.y * r[7] + v.z * r[8]};
}

inline Lanes3 point_of(const PointBlock& block, int lane) {
  return {load(block.x + lane), load(block.y + lane), load(block.z + lane)};
}

inline Lanes3 normal_of(const PointBlock& block, int lane) {
  return {load(block.nx + lane), load(block.ny + lane), load(block.nz + lane)};
}

inline Lanes3 translated(const FloatTransform& t, const Lanes3& v) {
  return {v.x + t.translation[0], v.y + t.translation[1], v.z + t.translation[2]};
}

// The two nearest of eight queries each.
struct TwoNearest {
  Lanes first2, second2;
  Mask index;
};

inline Lanes gap2(const BlockTreeView& tree, std::int32_t block, const Lanes3& query) {
  const BoxNode& node = tree.nodes[block / 8];
  const int i = block % 8;
  const Lanes zero{};
  const Lanes x = larger(larger(node.low[0][i] - query.x, query.x - node.high[0][i]), zero);
  const Lanes y = larger(larger(node.low[1][i] - query.y, query.y - node.high[1][i]), zero);
  const Lanes z = larger(larger(node.low[2][i] - query.z, query.z - node.high[2][i]), zero);
  return x * x + y * y + z * z;
}

inline void look_at(const BlockTreeView& tree, std::int32_t block, const Lanes3& query, TwoNearest& found) {
  if (bits_of(gap2(tree, block, query) < found.second2) == 0) return;
  const PointBlock& points = tree.blocks[block];
  for (int i = 0; i < kBlockSize; ++i) {
    const Lanes dx = query.x - points.x[i], dy = query.y - points.y[i], dz = query.z - points.z[i];
    const Lanes d2 = dx * dx + dy * dy + dz * dz;
    const Mask closer = d2 < found.first2;
    found.second2 = smaller(found.second2, larger(found.first2, d2));
    found.first2 = smaller(found.first2, d2);
    found.index = pick(closer, all(kBlockSize * block + i), found.index);
  }
}

// The queries of a block that must be searched, moved together.
struct Searches {
  alignas(32) float x[kBlockSize], y[kBlockSize], z[kBlockSize];
  int lane[kBlockSize];
  int count = 0;
  float radius_m = 0.0f;  // of the widest
};

Searches searches_of(const MatchTask& task, const PointBlock& source, const MatchBlock& match) {
  Searches out;
  for (int lane = 0; lane < kBlockSize; lane += kLanes) {
    const Lanes3 point = point_of(source, lane);
    const Lanes3 query = translated(task.target_from_source, rotate(task.target_from_source, point));
    const Lanes3 moved = query - Lanes3{load(match.at_x + lane), load(match.at_y + lane), load(match.at_z + lane)};
    const Mask stale = (dot(moved, moved) >= load(match.reach2_m2 + lane)) & (point.x < kFarAway_m);
    unsigned bits = bits_of(stale);
    if (bits == 0) continue;
    const Lanes3 error = query - point_of(match.target, lane);
    const Lanes known_m = square_root(dot(error, error)) + kMargin_m;
    const Lanes widest_m = all(kFarther * task.radius_m);
    const Lanes radius_m = pick(load(match.index + lane) >= 0, smaller(known_m, widest_m), widest_m);
    for (; bits != 0; bits &= bits - 1) {
      const int i = __builtin_ctz(bits);
      out.x[out.count] = query.x[i];
      out.y[out.count] = query.y[i];
      out.z[out.count] = query.z[i];
      out.radius_m = radius_m[i] > out.radius_m ? radius_m[i] : out.radius_m;
      out.lane[out.count++] = lane + i;
    }
  }
  return out;
}

Box box_of(const Searches& searches) {
  Box box{{kFarAway_m, kFarAway_m, kFarAway_m}, {-kFarAway_m, -kFarAway_m, -kFarAway_m}};
  const float* coordinates[3] = {searches.x, searches.y, searches.z};
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < searches.count; ++i) {
      const float v = coordinates[axis][i];
      box.low[axis] = v < box.low[axis] ? v : box.low[axis];
      box.high[axis] = v > box.high[axis] ? v : box.high[axis];
    }
  return box;
}

// A neighbour stays the nearest until its query has moved by half of the gap to the next one.
void keep_match(const BlockTreeView& tree, std::int32_t index, float reach_m, const Searches& searches, int i,
                MatchBlock& match) {
  const int lane = searches.lane[i];
  match.at_x[lane] = searches.x[i];
  match.at_y[lane] = searches.y[i];
  match.at_z[lane] = searches.z[i];
  match.index[lane] = index;
  reach_m -= kRounding_m;
  match.reach2_m2[lane] = reach_m > 0.0f ? reach_m * reach_m : -1.0f;
  if (index < 0) return;
  const PointBlock& block = tree.blocks[index / kBlockSize];
  const int j = index % kBlockSize;
  match.target.x[lane] = block.x[j];
  match.target.y[lane] = block.y[j];
  match.target.z[lane] = block.z[j];
  match.target.nx[lane] = block.nx[j];
  match.target.ny[lane] = block.ny[j];
  match.target.nz[lane] = block.nz[j];
  match.target.planarity[lane] = block.planarity[j];
}

void match_block(const BlockTreeView& tree, const MatchTask& task, const PointBlock& source, MatchBlock& match) {
  Searches searches = searches_of(task, source, match);
  if (searches.count == 0) return;
  for (int i = searches.count; i % kLanes != 0; ++i) {
    searches.x[i] = searches.x[0];
    searches.y[i] = searches.y[0];
    searches.z[i] = searches.z[0];
  }
  const float radius2_m2 = searches.radius_m * searches.radius_m;
  const int blocks = blocks_near(tree, box_of(searches), radius2_m2, task.scratch);
  for (int begin = 0; begin < searches.count; begin += kLanes) {
    const Lanes3 query{load(searches.x + begin), load(searches.y + begin), load(searches.z + begin)};
    TwoNearest found{all(radius2_m2), all(radius2_m2), all(-1)};
    for (int b = 0; b < blocks; ++b) look_at(tree, task.scratch[b], query, found);
    const Lanes gap_m = 0.5f * (square_root(found.second2) - square_root(found.first2));
    const Lanes reach_m = pick(found.index >= 0, gap_m, all(searches.radius_m - task.radius_m));
    for (int i = begin; i < searches.count && i < begin + kLanes; ++i)
      keep_match(tree, found.index[i - begin], reach_m[i - begin], searches, i, match);
  }
}

void match(const BlockTreeView& target, const MatchTask& task) {
  for (std::int32_t b = task.first; b < task.last; b += task.step)
    match_block(target, task, task.source[b], task.matches[b]);
}

struct LaneSums {
  Lanes hessian[21];
  Lanes gradient[6];
  Lanes inliers;
};

// Adds J' M J and J' M e for J = [I, -arm x].
inline void add_equations(const Lanes (&m)[6], const Lanes3& arm, const Lanes3& error, LaneSums& sums) {
  const Lanes3 row[3] = {{m[0], m[1], m[2]}, {m[1], m[3], m[4]}, {m[2], m[4], m[5]}};
  Lanes3 b[3];
  for (int i = 0; i < 3; ++i)
    b[i] = {row[i].z * arm.y - row[i].y * arm.z, row[i].x * arm.z - row[i].z * arm.x,
            row[i].y * arm.x - row[i].x * arm.y};
  Lanes* h = sums.hessian;
  h[0] += m[0], h[1] += m[1], h[2] += m[2], h[3] += b[0].x, h[4] += b[0].y, h[5] += b[0].z;
  h[6] += m[3], h[7] += m[4], h[8] += b[1].x, h[9] += b[1].y, h[10] += b[1].z;
  h[11] += m[5], h[12] += b[2].x, h[13] += b[2].y, h[14] += b[2].z;
  h[15] += b[2].x * arm.y - b[1].x * arm.z;
  h[16] += b[2].y * arm.y - b[1].y * arm.z;
  h[17] += b[2].z * arm.y - b[1].z * arm.z;
  h[18] += b[0].y * arm.z - b[2].y * arm.x;
  h[19] += b[0].z * arm.z - b[2].z * arm.x;
  h[20] += b[1].z * arm.x - b[0].z * arm.y;
  const Lanes3 force{dot(row[0], error), dot(row[1], error), dot(row[2], error)};
  Lanes* g = sums.gradient;
  g[0] += force.x, g[1] += force.y, g[2] += force.z;
  g[3] += force.z * arm.y - force.y * arm.z;
  g[4] += force.x * arm.z - force.z * arm.x;
  g[5] += force.y * arm.x - force.x * arm.y;
}

// Eight points of a block. The weight matrix is the inverse of 2 I - keep (n n' + m m'), whose eigenvectors are n + m,
// n - m and their normal; all but the first lie in the plane and count less.
inline void accumulate_lanes(const SumsTask& task, const PointBlock& source, const MatchBlock& match, int lane,
                             ResidualBlock& residuals, LaneSums& sums) {
  const Lanes3 turned = rotate(task.target_from_source, point_of(source, lane));
  const Lanes3 offset = translated(task.target_from_source, turned) - point_of(match.target, lane);
  const Lanes3 n = normal_of(match.target, lane);
  Lanes3 m = rotate(task.target_from_source, normal_of(source, lane));
  const Mask away = dot(n, m) < 0.0f;
  m = pick(away, -m, m);
  const Lanes cosine = dot(n, m);
  const Mask valid =
      (load(match.index + lane) >= 0) & (dot(offset, offset) <= task.radius_m * task.radius_m) & (cosine >= kMinCosine);
  const Lanes3 error = keep(valid, offset), arm = keep(valid, turned);
  const Lanes3 sum = n + m, difference = n - m;
  const Lanes together = 1.0f + cosine, apart = 1.0f - cosine;
  const Lanes along = dot(sum, error);
  const Lanes along2 = along * along / (2.0f * together);
  const Lanes soft = 1.0f / (1.0f + along2 * (1.0f / (task.kernel_m * task.kernel_m)));
  const Lanes weight = keep(valid, soft * soft * load(source.planarity + lane) * load(match.target.planarity + lane));
  const Lanes plain = (0.5f * kInPlane) * weight;
  const Lanes p = (0.25f * kKeep) * weight / (2.0f - kKeep * together);
  const Lanes q = (0.25f * kInPlane * kKeep) * weight / (2.0f - kKeep * apart);
  const Lanes information[6] = {plain + p * sum.x * sum.x + q * difference.x * difference.x,
                                p * sum.x * sum.y + q * difference.x * difference.y,
                                p * sum.x * sum.z + q * difference.x * difference.z,
                                plain + p * sum.y * sum.y + q * difference.y * difference.y,
                                p * sum.y * sum.z + q * difference.y * difference.z,
                                plain + p * sum.z * sum.z + q * difference.z * difference.z};
  add_equations(information, arm, error, sums);
  sums.inliers += keep(valid, all(1.0f));
  store(residuals.squared_m2 + lane, pick(valid, along2, all(-1.0f)));
}

double total(Lanes lanes) {
  double sum = 0.0;
  for (int i = 0; i < kLanes; ++i) sum += static_cast<double>(lanes[i]);
  return sum;
}

void accumulate(const SumsTask& task, AlignmentSums& sums) {
  LaneSums lanes{};
  for (std::int32_t b = task.first; b < task.last; b += task.step)
    for (int lane = 0; lane < kBlockSize; lane += kLanes)
      accumulate_lanes(task, task.source[b], task.matches[b], lane, task.residuals[b], lanes);
  for (int i = 0; i < 21; ++i) sums.hessian[i] += total(lanes.hessian[i]);
  for (int i = 0; i < 6; ++i) sums.gradient[i] += total(lanes.gradient[i]);
  sums.inliers += total(lanes.inliers);
}

}  // namespace
}  // namespace remount::registration

#include "algorithms/registration/surface_fit.h"
