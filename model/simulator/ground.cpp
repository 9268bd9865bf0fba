#include "model/simulator/ground.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "algorithms/core/index.h"
#include "algorithms/geometry/rotation.h"

namespace remount::simulator {

Ground::Ground(std::vector<GroundWave> waves) : waves_(std::move(waves)) {
  if (flat()) return;
  tile_m_.resize(cell_count(kTile, kTile));
  for (int iy = 0; iy < kTile; ++iy)
    for (int ix = 0; ix < kTile; ++ix)
      tile_m_[cell_at(iy, ix, kTile)] = static_cast<float>(height_m(ix / kSamplesPerMetre, iy / kSamplesPerMetre));
  highest_m_ = *std::max_element(tile_m_.begin(), tile_m_.end());
  // Of the bilinear surface, whose slope along x and along y is that of its edges.
  double steepest_x = 0.0, steepest_y = 0.0;
  for (int iy = 0; iy < kTile; ++iy)
    for (int ix = 0; ix < kTile; ++ix) {
      const auto at = [&](int x, int y) {
        return static_cast<double>(tile_m_[cell_at(y & (kTile - 1), x & (kTile - 1), kTile)]);
      };
      steepest_x = std::max(steepest_x, std::abs(at(ix + 1, iy) - at(ix, iy)) * kSamplesPerMetre);
      steepest_y = std::max(steepest_y, std::abs(at(ix, iy + 1) - at(ix, iy)) * kSamplesPerMetre);
    }
  steepest_ = std::hypot(steepest_x, steepest_y);
}

double Ground::height_m(double x, double y) const {
  double height = 0.0;
  for (const GroundWave& wave : waves_)
    height +=
        wave.amplitude_m * std::sin(2.0 * kPi / kPeriod_m * (wave.waves_x * x + wave.waves_y * y) + wave.phase_rad);
  return height;
}

double Ground::surface_height_m(double x, double y) const {
  if (flat()) return 0.0;
  const double u = x * kSamplesPerMetre, v = y * kSamplesPerMetre;
  const double floor_u = std::floor(u), floor_v = std::floor(v);
  const auto ix = static_cast<std::int64_t>(floor_u), iy = static_cast<std::int64_t>(floor_v);
  const double a = u - floor_u, b = v - floor_v;
  constexpr std::int64_t mask = kTile - 1;
  const auto row0 = static_cast<std::size_t>((iy & mask) * kTile),
             row1 = static_cast<std::size_t>(((iy + 1) & mask) * kTile);
  const auto x0 = static_cast<std::size_t>(ix & mask), x1 = static_cast<std::size_t>((ix + 1) & mask);
  const double low = tile_m_[row0 + x0] + a * (tile_m_[row0 + x1] - tile_m_[row0 + x0]);
  const double high = tile_m_[row1 + x0] + a * (tile_m_[row1 + x1] - tile_m_[row1 + x0]);
  return low + b * (high - low);
}

double Ground::gap_m(const Ray& ray, double distance) const {
  const Eigen::Vector3d p = ray.origin + distance * ray.direction;
  return p.z() - surface_height_m(p.x(), p.y());
}

double Ground::cast(const Ray& ray, double max_range_m) const {
  const double dz = ray.direction.z();
  if (flat()) {
    const double distance = dz < 0.0 ? -ray.origin.z() / dz : kNoHit;
    return distance <= max_range_m ? distance : kNoHit;
  }
  // The gap cannot close faster than this along the ray, so a step of gap / rate never passes through the ground.
  const double rate = steepest_ * std::hypot(ray.direction.x(), ray.direction.y()) - dz;
  double distance = 0.0;
  if (ray.origin.z() > highest_m_) {
    if (dz >= 0.0) return kNoHit;
    distance = (ray.origin.z() - highest_m_) / -dz;
  }
  if (rate <= 0.0 || distance > max_range_m) return kNoHit;
  double before = distance, gap_before = gap_m(ray, distance);
  constexpr double kNear_m = 0.004;
  if (gap_before <= kNear_m) return distance;
  while (distance <= max_range_m) {
    distance = before + gap_before / rate;
    const double gap = gap_m(ray, distance);
    if (gap < kNear_m) {
      const double hit = refine(ray, before, gap_before, distance, gap);
      if (hit <= max_range_m) return hit;
      return kNoHit;
    }
    // A ray that skims a crest must not creep.
    before = distance;
    gap_before = std::max(gap, 0.02 * rate);
  }
  return kNoHit;
}

double Ground::refine(const Ray& ray, double before, double gap_before, double at, double gap_at) const {
  for (int i = 0; i < 4 && std::abs(gap_at) > 1e-7 && gap_before != gap_at; ++i) {
    const double step = gap_at * (at - before) / (gap_before - gap_at);
    const double next = at + std::clamp(step, -0.5, 0.5);
    const double gap_next = gap_m(ray, next);
    // A ray that touches a crest and rises again: stay where it came nearest.
    if (std::abs(gap_next) > std::abs(gap_at)) break;
    before = at;
    gap_before = gap_at;
    at = next;
    gap_at = gap_next;
  }
  return at;
}

}  // namespace remount::simulator
