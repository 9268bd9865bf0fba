#include "model/formats/clouds/cloud_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "algorithms/cloud/point_cloud.h"
#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/clouds.h"

namespace remount::formats {

namespace {

template <class T>
double read_as(const char* bytes, bool swap_bytes) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (swap_bytes) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<T>(raw));
}

/// Without what CloudCompare puts before the names of its scalar fields.
std::string_view plain_name(std::string_view name) {
  for (const std::string_view prefix : {"scalar_", "sf_"})
    if (name.starts_with(prefix)) return name.substr(prefix.size());
  return name;
}

template <class List>
int find_field(const std::vector<CloudField>& fields, const List& names) {
  for (const std::string_view name : names)
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (plain_name(fields[i].name) == name && fields[i].count == 1) return static_cast<int>(i);
  return -1;
}

using FieldNames = std::initializer_list<std::string_view>;

bool fits_float(ScalarType type) { return size_of(type) <= 2; }

}  // namespace

std::size_t size_of(ScalarType type) {
  switch (type) {
    case ScalarType::I8:
    case ScalarType::U8:
      return 1;
    case ScalarType::I16:
    case ScalarType::U16:
      return 2;
    case ScalarType::I32:
    case ScalarType::U32:
    case ScalarType::F32:
      return 4;
    default:
      return 8;
  }
}

double read_scalar(const char* bytes, ScalarType type, bool swap_bytes) {
  switch (type) {
    case ScalarType::I8:
      return read_as<std::int8_t>(bytes, swap_bytes);
    case ScalarType::U8:
      return read_as<std::uint8_t>(bytes, swap_bytes);
    case ScalarType::I16:
      return read_as<std::int16_t>(bytes, swap_bytes);
    case ScalarType::U16:
      return read_as<std::uint16_t>(bytes, swap_bytes);
    case ScalarType::I32:
      return read_as<std::int32_t>(bytes, swap_bytes);
    case ScalarType::U32:
      return read_as<std::uint32_t>(bytes, swap_bytes);
    case ScalarType::I64:
      return read_as<std::int64_t>(bytes, swap_bytes);
    case ScalarType::U64:
      return read_as<std::uint64_t>(bytes, swap_bytes);
    case ScalarType::F32:
      return read_as<float>(bytes, swap_bytes);
    case ScalarType::F64:
      return read_as<double>(bytes, swap_bytes);
  }
  return 0.0;
}

CloudColumns find_cloud_columns(const std::vector<CloudField>& fields, const std::string& where) {
  CloudColumns columns;
  columns.x = find_field(fields, FieldNames{"x"});
  columns.y = find_field(fields, FieldNames{"y"});
  columns.z = find_field(fields, FieldNames{"z"});
  columns.intensity = find_field(fields, FieldNames{"intensity", "i", "reflectivity", "reflectance", "remission"});
  columns.ring = find_field(fields, FieldNames{"ring", "channel", "laser_id", "line"});
  columns.time = find_field(fields, kTimeColumns);
  if (columns.x >= 0 && columns.y >= 0 && columns.z >= 0) return columns;
  throw Error(ErrorCode::Format, where, say::cloud_no_coordinates(column_names(fields)));
}

TimeColumn time_column(const std::vector<CloudField>& fields, const CloudColumns& columns) {
  TimeColumn column;
  if (columns.time < 0) return column;
  const CloudField& field = fields[index_at(columns.time)];
  column.type = field.type;
  for (const auto& [ending, unit_s] : {std::pair{"_ns", 1e-9}, {"_us", 1e-6}, {"_ms", 1e-3}})
    if (field.name.ends_with(ending)) column.unit_s = unit_s;
  return column;
}

std::string column_names(const std::vector<CloudField>& fields) {
  std::string names;
  for (std::size_t i = 0; i < std::min<std::size_t>(fields.size(), 16); ++i) names += (i ? " " : "") + fields[i].name;
  return names;
}

void refuse_narrow_coordinates(const std::vector<CloudField>& fields, const CloudColumns& columns,
                               const std::string& where) {
  for (const int column : {columns.x, columns.y, columns.z}) {
    const CloudField& field = fields[index_at(column)];
    if (size_of(field.type) < 2) throw Error(ErrorCode::Format, where, say::cloud_narrow_coordinate(field.name));
  }
}

CloudBuilder::CloudBuilder(const CloudColumns& columns, const TimeColumn& time, std::size_t expected_points)
    : columns_(columns), time_(time) {
  cloud_.points.reserve(expected_points);
  if (columns_.intensity >= 0) cloud_.intensity.reserve(expected_points);
  if (columns_.ring >= 0) cloud_.ring.reserve(expected_points);
  if (columns_.time < 0) return;
  if (fits_float(time_.type))
    cloud_.time_from_stamp_s.reserve(expected_points);
  else
    times_.reserve(expected_points);
}

void CloudBuilder::add(const RawPoint& point) {
  const Eigen::Vector3f p(static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z));
  const bool finite = p.allFinite();
  const float largest_m = finite ? p.cwiseAbs().maxCoeff() : 0.0f;
  const bool beyond = largest_m > cloud::kFarthestReturn_m;
  farthest_m_ = std::max(farthest_m_, static_cast<double>(largest_m));
  if (largest_m == 0.0f || beyond) {
    beyond_ += beyond ? 1 : 0;
    ++cloud_.dropped_points;
    return;
  }
  nearest2_m2_ = std::min(nearest2_m2_, static_cast<double>(p.squaredNorm()));
  cloud_.points.push_back(p);
  if (columns_.intensity >= 0) cloud_.intensity.push_back(static_cast<float>(point.intensity));
  if (columns_.ring >= 0) {
    const double ring = std::isfinite(point.ring) ? std::clamp(point.ring, 0.0, 65535.0) : 0.0;
    cloud_.ring.push_back(static_cast<std::uint16_t>(ring));
  }
  if (columns_.time < 0) return;
  if (fits_float(time_.type))
    cloud_.time_from_stamp_s.push_back(static_cast<float>(point.time));
  else
    times_.push_back(point.time);
}

void CloudBuilder::leave_out_times() {
  columns_.time = -1;
  times_.clear();
  cloud_.time_from_stamp_s.clear();
}

/// All columns but that of times. @return the place after `to`
std::size_t CloudBuilder::move_point(std::size_t from, std::size_t to) {
  cloud_.points[to] = cloud_.points[from];
  if (columns_.intensity >= 0) cloud_.intensity[to] = cloud_.intensity[from];
  if (columns_.ring >= 0) cloud_.ring[to] = cloud_.ring[from];
  return to + 1;
}

void CloudBuilder::cut_to(std::size_t points) {
  cloud_.dropped_points += cloud_.points.size() - points;
  cloud_.points.resize(points);
  if (columns_.intensity >= 0) cloud_.intensity.resize(points);
  if (columns_.ring >= 0) cloud_.ring.resize(points);
  cloud_.time_from_stamp_s.resize(points);
}

void CloudBuilder::refuse_map_coordinates(const std::string& where) const {
  constexpr double kNearest_m = 1000.0;
  constexpr std::size_t kFewest = 10;       // of fewer points anything may be true
  constexpr double kFarthestOfMap_m = 1e8;  // no map has more, in whatever projection: such numbers are no coordinates
  if (farthest_m_ > kFarthestOfMap_m) return;
  const bool all_beyond = cloud_.points.empty() && beyond_ > 0;
  if (!all_beyond && (cloud_.points.size() < kFewest || nearest2_m2_ < kNearest_m * kNearest_m)) return;
  throw Error(ErrorCode::Unsupported, where, say::cloud_of_map(Length{farthest_m_}));
}

ReadCloud CloudBuilder::finish(std::int64_t stamp_ns, const std::string& where, PointTimes times) {
  refuse_map_coordinates(where);
  const std::size_t points = cloud_.points.size();
  if (columns_.time < 0 || points == 0) return {std::move(cloud_)};
  constexpr std::size_t kSample = 4096;
  std::vector<double> sample;
  for (std::size_t i = 0; i < points; i += 1 + points / kSample)
    if (std::isfinite(time_at(i))) sample.push_back(time_at(i));
  if (sample.empty()) return without_times();
  const PointTimeScale scale = find_time_scale(std::move(sample), points, time_, stamp_ns);
  const auto belongs = [&](double time) { return time >= scale.low && time <= scale.high; };
  for (std::size_t i = 0; times == PointTimes::Unused && i < points; ++i)
    if (!belongs(time_at(i))) return without_times();
  double zero = scale.zero.value_or(scale.high);
  for (std::size_t i = 0; !scale.zero && i < points; ++i)
    if (belongs(time_at(i))) zero = std::min(zero, time_at(i));
  cloud_.time_from_stamp_s.resize(points);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points; ++i) {
    const double time = time_at(i);
    if (!belongs(time)) continue;
    cloud_.time_from_stamp_s[kept] = static_cast<float>((time - zero) * scale.unit_s);
    kept = move_point(i, kept);
  }
  cut_to(kept);
  ReadCloud read{std::move(cloud_), scale.another_clock};
  // 32-bit floats hold dates to a minute.
  if (stamp_ns == 0 && scale.dates && time_.type != ScalarType::F32)
    read.first_point_ns = std::llround(zero * scale.unit_s * 1e9);
  return read;
}

ReadCloud CloudBuilder::without_times() {
  cloud_.time_from_stamp_s.clear();
  return {std::move(cloud_)};
}

}  // namespace remount::formats
