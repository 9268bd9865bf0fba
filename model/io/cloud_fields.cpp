#include "model/io/cloud_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "algorithms/core/error.h"

namespace remount {

namespace {

template <class T>
double read_as(const char* bytes, bool swap_bytes) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (swap_bytes) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<T>(raw));
}

int find_field(const std::vector<CloudField>& fields, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names)
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (fields[i].name == name && fields[i].count == 1) return static_cast<int>(i);
  return -1;
}

/// Seconds in one unit of a duration or of a Unix time of this size.
double seconds_per_unit(double size, double milli_from, double micro_from, double nano_from) {
  if (size > nano_from) return 1e-9;
  if (size > micro_from) return 1e-6;
  return size > milli_from ? 1e-3 : 1.0;
}

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
  columns.x = find_field(fields, {"x"});
  columns.y = find_field(fields, {"y"});
  columns.z = find_field(fields, {"z"});
  columns.intensity = find_field(fields, {"intensity", "i", "reflectivity", "reflectance", "remission"});
  columns.ring = find_field(fields, {"ring", "channel", "laser_id", "line"});
  columns.time = find_field(fields, {"time", "t", "timestamp", "time_stamp", "offset_time"});
  if (columns.x >= 0 && columns.y >= 0 && columns.z >= 0) return columns;
  std::string names;
  for (std::size_t i = 0; i < std::min<std::size_t>(fields.size(), 16); ++i) names += (i ? " " : "") + fields[i].name;
  throw Error(ErrorCode::Format, where, "fields are '" + names + "', expected x, y and z with one value each");
}

CloudBuilder::CloudBuilder(const CloudColumns& columns, ScalarType time_type, std::size_t expected_points)
    : columns_(columns), time_type_(time_type) {
  cloud_.points.reserve(expected_points);
  if (columns_.intensity >= 0) cloud_.intensity.reserve(expected_points);
  if (columns_.ring >= 0) cloud_.ring.reserve(expected_points);
  if (columns_.time >= 0) times_.reserve(expected_points);
}

void CloudBuilder::add(const RawPoint& point) {
  const Eigen::Vector3f p(static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z));
  const bool timed = columns_.time < 0 || std::isfinite(point.time);
  // Beyond 1e5 m nothing is a return; its square would not fit a float either.
  if (!p.allFinite() || p.isZero(0.0f) || p.cwiseAbs().maxCoeff() > 1e5f || !timed) {
    ++cloud_.dropped_points;
    return;
  }
  cloud_.points.push_back(p);
  if (columns_.intensity >= 0) cloud_.intensity.push_back(static_cast<float>(point.intensity));
  if (columns_.ring >= 0) {
    const double ring = std::isfinite(point.ring) ? std::clamp(point.ring, 0.0, 65535.0) : 0.0;
    cloud_.ring.push_back(static_cast<std::uint16_t>(ring));
  }
  if (columns_.time >= 0) times_.push_back(point.time);
}

PointCloud CloudBuilder::finish(std::int64_t stamp_ns) {
  if (times_.empty()) return std::move(cloud_);
  const auto [lowest, highest] = std::minmax_element(times_.begin(), times_.end());
  const double low = *lowest, high = *highest, span = high - low;
  const bool absolute = low > 1e6 && span < 1e-3 * low;
  double unit_s = 1.0, zero = 0.0;
  if (absolute) {
    unit_s = seconds_per_unit(low, 1e11, 1e14, 1e17);
    // In the column's unit and in two parts: a nanosecond stamp does not fit a double.
    const double scale = 1.0 / unit_s;
    const double stamp = std::floor(static_cast<double>(stamp_ns / 1'000'000'000)) * scale +
                         static_cast<double>(stamp_ns % 1'000'000'000) * 1e-9 * scale;
    // File names are often local time: a whole number of half hours apart is a time zone, not another clock.
    const double apart_s = (low - stamp) * unit_s, zone_s = std::round(apart_s / 1800.0) * 1800.0;
    const bool same_clock = stamp_ns != 0 && std::abs(zone_s) <= 14.0 * 3600.0 && std::abs(apart_s - zone_s) < 60.0;
    zero = same_clock ? stamp + zone_s * scale : low;
  } else if (time_type_ == ScalarType::U32) {
    unit_s = 1e-9;
  } else {
    unit_s = seconds_per_unit(std::max(std::abs(low), std::abs(high)), 2.0, 2e3, 2e6);
  }
  cloud_.time_from_stamp_s.reserve(times_.size());
  for (const double time : times_) cloud_.time_from_stamp_s.push_back(static_cast<float>((time - zero) * unit_s));
  return std::move(cloud_);
}

}  // namespace remount
