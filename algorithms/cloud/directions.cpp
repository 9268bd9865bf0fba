#include "algorithms/cloud/directions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/core/index.h"
#include "algorithms/geometry/rotation.h"

namespace remount::cloud {

namespace {

constexpr int kRows = 180;  // of one degree, from straight down to straight up

/// The grid: how many cells each row has, and where they begin in the list of all; behind the last row the count of
/// all.
struct Grid {
  std::array<int, kRows> columns{};
  std::array<int, kRows + 1> first{};

  Grid() {
    for (int row = 0; row < kRows; ++row) {
      const double elevation_rad = degrees_to_radians(row + 0.5 - kRows / 2.0);
      columns[index_at(row)] = std::max(1, static_cast<int>(std::lround(2.0 * kRows * std::cos(elevation_rad))));
      first[index_at(row + 1)] = first[index_at(row)] + columns[index_at(row)];
    }
  }
};

const Grid& grid() {
  static const Grid of_all;
  return of_all;
}

int columns_of(int row) { return grid().columns[index_at(row)]; }

struct Cell {
  int row = 0, column = 0;
};

Cell cell_of(const Eigen::Vector3f& direction) {
  const double flat = std::hypot(direction.x(), direction.y());
  const double elevation_deg = radians_to_degrees(std::atan2(static_cast<double>(direction.z()), flat));
  const int row = std::clamp(static_cast<int>(std::floor(elevation_deg + kRows / 2.0)), 0, kRows - 1);
  const int columns = columns_of(row);
  const double turns = std::atan2(direction.y(), direction.x()) / (2.0 * kPi) + 0.5;
  return {row, std::clamp(static_cast<int>(std::floor(turns * columns)), 0, columns - 1)};
}

std::size_t place_of(int row, int column) { return index_at(grid().first[index_at(row)] + column); }

}  // namespace

Directions::Directions() : seen_(index_at(grid().first.back()), false) {}

void Directions::add(const std::vector<Eigen::Vector3f>& points_in_lidar) {
  for (const Eigen::Vector3f& point : points_in_lidar) {
    if (!(point.squaredNorm() > 0.0f)) continue;
    const Cell cell = cell_of(point);
    seen_[place_of(cell.row, cell.column)] = true;
  }
}

void Directions::add(const Directions& other) {
  for (std::size_t i = 0; i < seen_.size(); ++i)
    if (other.seen_[i]) seen_[i] = true;
}

std::size_t Directions::count() const { return static_cast<std::size_t>(std::ranges::count(seen_, true)); }

bool Directions::has_near(int row, int column) const {
  const double middle = (column + 0.5) / columns_of(row);  // of a turn
  for (int near = std::max(0, row - 1); near <= std::min(kRows - 1, row + 1); ++near) {
    const int columns = columns_of(near), at = static_cast<int>(middle * columns);
    for (int c = at - 1; c <= at + 1; ++c)
      if (seen_[place_of(near, (c + columns) % columns)]) return true;
  }
  return false;
}

bool Directions::has_near(const Eigen::Vector3f& direction_in_lidar) const {
  const Cell cell = cell_of(direction_in_lidar);
  return has_near(cell.row, cell.column);
}

double Directions::turn_shown() const {
  constexpr int kSectors = 36;
  std::array<bool, kSectors> shown{};
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < columns_of(row); ++column)
      if (seen_[place_of(row, column)]) shown[index_at(column * kSectors / columns_of(row))] = true;
  return static_cast<double>(std::ranges::count(shown, true)) / kSectors;
}

FieldBox Directions::box() const {
  constexpr int kBins = 2 * kRows;
  std::array<bool, kBins> seen_at{};
  int lowest = kRows, highest = -1;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < columns_of(row); ++column) {
      if (!seen_[place_of(row, column)]) continue;
      seen_at[index_at(static_cast<int>((column + 0.5) / columns_of(row) * kBins))] = true;
      lowest = std::min(lowest, row);
      highest = row;
    }
  // The field is what the widest gap leaves.
  int widest = 0, begins = 0;
  for (int from = 0; from < kBins; ++from) {
    int gap = 0;
    while (gap < kBins && !seen_at[index_at((from + gap) % kBins)]) ++gap;
    if (gap > widest) widest = gap, begins = (from + gap) % kBins;
  }
  const auto azimuth_rad = [](int bin) { return degrees_to_radians(bin - kBins / 2.0); };
  const auto elevation_rad = [](int row) { return degrees_to_radians(row - kRows / 2.0); };
  return {azimuth_rad(begins), azimuth_rad(begins + kBins - widest), elevation_rad(lowest), elevation_rad(highest + 1)};
}

double Directions::share_of(const Directions& whole) const {
  std::size_t all = 0, here = 0;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    all += whole.seen_[i];
    here += whole.seen_[i] && seen_[i];
  }
  return all == 0 ? 0.0 : static_cast<double>(here) / static_cast<double>(all);
}

}  // namespace remount::cloud
