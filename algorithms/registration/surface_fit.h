// Surface normals of the points of a block from the points around them; part of kernels_body.h.
#pragma once

namespace remount::registration {
namespace {

// Sums over the neighbours of eight points, relative to each point.
struct Moments {
  Lanes count{};
  Lanes3 sum{};
  Lanes xx{}, xy{}, xz{}, yy{}, yz{}, zz{};
};

inline void add_neighbours(const PointBlock& block, const Lanes3& centre, float radius2_m2, Moments& m) {
  for (int i = 0; i < kBlockSize; ++i) {
    const Lanes3 d{block.x[i] - centre.x, block.y[i] - centre.y, block.z[i] - centre.z};
    const Mask near = dot(d, d) < radius2_m2;
    const Lanes3 k = keep(near, d);
    m.count += keep(near, all(1.0f));
    m.sum = m.sum + k;
    m.xx += k.x * k.x;
    m.xy += k.x * k.y;
    m.xz += k.x * k.z;
    m.yy += k.y * k.y;
    m.yz += k.y * k.z;
    m.zz += k.z * k.z;
  }
}

// One Jacobi rotation that clears the entry pq of a symmetric matrix; r is the third index.
inline void jacobi(Lanes& pp, Lanes& qq, Lanes& pq, Lanes& pr, Lanes& qr, Lanes3& vp, Lanes3& vq) {
  const Lanes difference = qq - pp, twice = 2.0f * pq;
  const Lanes root = square_root(difference * difference + twice * twice);
  const Lanes below = absolute(difference) + root + 1e-30f;
  const Lanes tangent = pick(difference < 0.0f, -twice, twice) / below;
  const Lanes c = 1.0f / square_root(1.0f + tangent * tangent), s = tangent * c;
  pp -= tangent * pq;
  qq += tangent * pq;
  pq = Lanes{};
  const Lanes old_pr = pr;
  pr = c * pr - s * qr;
  qr = s * old_pr + c * qr;
  const Lanes3 old = vp;
  vp = {c * vp.x - s * vq.x, c * vp.y - s * vq.y, c * vp.z - s * vq.z};
  vq = {s * old.x + c * vq.x, s * old.y + c * vq.y, s * old.z + c * vq.z};
}

struct Surface {
  Lanes3 normal;
  Lanes planarity;  // less where the surface is thick
  Mask found;
};

inline void order(Lanes& small, Lanes& large, Lanes3& v_small, Lanes3& v_large) {
  const Mask swap = large < small;
  const Lanes value = small;
  small = pick(swap, large, small);
  large = pick(swap, value, large);
  const Lanes3 v = v_small;
  v_small = pick(swap, v_large, v);
  v_large = pick(swap, v, v_large);
}

Surface surface_of(const Moments& m, const NormalTask& task) {
  const Lanes share = 1.0f / larger(m.count, all(1.0f));
  const Lanes3 mean{m.sum.x * share, m.sum.y * share, m.sum.z * share};
  Lanes xx = m.xx * share - mean.x * mean.x, xy = m.xy * share - mean.x * mean.y, xz = m.xz * share - mean.x * mean.z;
  Lanes yy = m.yy * share - mean.y * mean.y, yz = m.yz * share - mean.y * mean.z, zz = m.zz * share - mean.z * mean.z;
  Lanes3 a{all(1.0f), Lanes{}, Lanes{}}, b{Lanes{}, all(1.0f), Lanes{}}, c{Lanes{}, Lanes{}, all(1.0f)};
  constexpr int kSweeps = 4;  // quadratic convergence: the fourth is below the rounding
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    jacobi(xx, yy, xy, xz, yz, a, b);
    jacobi(xx, zz, xz, xy, yz, a, c);
    jacobi(yy, zz, yz, xy, xz, b, c);
  }
  order(xx, yy, a, b);
  order(yy, zz, b, c);
  order(xx, yy, a, b);
  const Mask found = (m.count >= task.min_points) & (yy > task.min_width_ratio * zz) & (yy > 0.0f);
  // A kerb and the road beside it, or a hedge: far thicker than range noise.
  constexpr float kThick_m = 0.1f;
  const Lanes thickness2_m2 = larger(xx, Lanes{});
  const Lanes thinness = square_root(thickness2_m2 / larger(yy, all(1e-30f)));
  return {a, (1.0f - thinness) / (1.0f + thickness2_m2 * (1.0f / (kThick_m * kThick_m))), found};
}

// Tries one radius for those of eight points that have no surface yet; true where all have one.
bool fit_lanes(const NormalTask& task, const BlockTreeView& tree, int blocks, float radius_m, int lane,
               PointBlock& block) {
  const Lanes3 centre = point_of(block, lane);
  const Mask open = (load(block.planarity + lane) < 0.0f) & (centre.x < kFarAway_m);
  if (bits_of(open) == 0) return true;
  Moments moments;
  const Lanes radius2_m2 = all(radius_m * radius_m);
  for (int b = 0; b < blocks; ++b) {
    const std::int32_t at = task.scratch[b];
    if (bits_of((gap2(tree, at, centre) < radius2_m2) & open) != 0)
      add_neighbours(tree.blocks[at], centre, radius_m * radius_m, moments);
  }
  const Surface surface = surface_of(moments, task);
  const Mask fitted = surface.found & open;
  const Mask towards = dot(surface.normal, centre) > 0.0f;  // normals face the sensor
  const Lanes3 facing = pick(towards, -surface.normal, surface.normal);
  const Lanes3 normal = pick(fitted, facing, normal_of(block, lane));
  store(block.nx + lane, normal.x);
  store(block.ny + lane, normal.y);
  store(block.nz + lane, normal.z);
  store(block.planarity + lane, pick(fitted, surface.planarity, load(block.planarity + lane)));
  return bits_of(open & ~fitted) == 0;
}

void fit_normals(const BlockTreeView& tree, const NormalTask& task) {
  constexpr float kRadii[] = {1.0f, 2.0f, 4.0f};
  for (std::int32_t b = task.first; b < task.last; ++b) {
    PointBlock& block = task.blocks[b];
    for (int i = 0; i < kBlockSize; ++i) {
      block.planarity[i] = -1.0f;
      block.nx[i] = block.ny[i] = 0.0f;
      block.nz[i] = 1.0f;
    }
    const BoxNode& node = tree.nodes[b / 8];
    const int child = b % 8;
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = node.low[axis][child];
      box.high[axis] = node.high[axis][child];
    }
    for (const float factor : kRadii) {
      const float radius_m = factor * task.radius_m;
      const int blocks = blocks_near(tree, box, radius_m * radius_m, task.scratch);
      bool done = true;
      for (int lane = 0; lane < kBlockSize; lane += kLanes)
        done &= fit_lanes(task, tree, blocks, radius_m, lane, block);
      if (done) break;
    }
  }
}

}  // namespace
}  // namespace remount::registration
