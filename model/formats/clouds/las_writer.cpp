// LAS 1.2 (ASPRS) of a single scan in the sensor's frame.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "algorithms/core/error.h"
#include "algorithms/core/stamps.h"
#include "messages/clouds.h"
#include "model/formats/clouds/cloud_file.h"
#include "model/formats/files/output_file.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {
namespace {

constexpr std::size_t kHeaderBytes = 227;
constexpr double kScale_m = 1e-4;

/// Little-endian, as LAS is; `at` lies within `bytes`.
template <class T>
void put(std::string& bytes, std::size_t at, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw, raw + sizeof(T));
  std::memcpy(bytes.data() + at, raw, sizeof(T));
}

/// Seconds of GPS time less 1e9, as LAS calls its standard time.
double las_time_s(std::int64_t stamp_ns, float from_stamp_s) {
  const std::int64_t since_ns = gps_ns_from_unix_ns(stamp_ns) - std::int64_t{1'000'000'000} * 1'000'000'000;
  return seconds(since_ns) + static_cast<double>(from_stamp_s);
}

std::string header_of(const cloud::PointCloud& cloud, std::uint8_t format, std::uint16_t record_bytes) {
  std::string bytes(kHeaderBytes, '\0');
  std::memcpy(bytes.data(), "LASF", 4);
  put(bytes, 6, std::uint16_t{1});  // times are not those of a week
  put(bytes, 24, std::uint8_t{1});
  put(bytes, 25, std::uint8_t{2});
  std::memcpy(bytes.data() + 58, "Remount", 7);
  put(bytes, 94, static_cast<std::uint16_t>(kHeaderBytes));
  put(bytes, 96, static_cast<std::uint32_t>(kHeaderBytes));
  put(bytes, 104, format);
  put(bytes, 105, record_bytes);
  put(bytes, 107, static_cast<std::uint32_t>(cloud.size()));
  put(bytes, 111, static_cast<std::uint32_t>(cloud.size()));  // all are first returns
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = cloud.points.empty() ? 0.0 : std::numeric_limits<double>::max(), high = -low;
    for (const Eigen::Vector3f& point : cloud.points) {
      const double value = point[static_cast<Eigen::Index>(axis)];
      low = std::min(low, value);
      high = std::max(high, value);
    }
    put(bytes, 131 + 8 * axis, kScale_m);
    put(bytes, 179 + 16 * axis, high);
    put(bytes, 187 + 16 * axis, low);
  }
  return bytes;
}

}  // namespace

void write_las(const std::filesystem::path& path, const cloud::PointCloud& cloud, std::int64_t stamp_ns) {
  const bool timed = !cloud.time_from_stamp_s.empty();
  if ((timed && cloud.time_from_stamp_s.size() != cloud.size()) ||
      (!cloud.intensity.empty() && cloud.intensity.size() != cloud.size()))
    throw Error(ErrorCode::Contract, path.string(), say::cloud_columns_differ());
  const std::size_t record_bytes = timed ? 28 : 20;
  std::string bytes = header_of(cloud, timed ? 1 : 0, static_cast<std::uint16_t>(record_bytes));
  bytes.resize(kHeaderBytes + cloud.size() * record_bytes, '\0');
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::size_t at = kHeaderBytes + i * record_bytes;
    for (int axis = 0; axis < 3; ++axis) {
      const double units = std::round(static_cast<double>(cloud.points[i][axis]) / kScale_m);
      if (!(std::abs(units) < static_cast<double>(std::numeric_limits<std::int32_t>::max())))
        throw Error(ErrorCode::Contract, path.string(), say::las_too_far());
      put(bytes, at + 4 * static_cast<std::size_t>(axis), static_cast<std::int32_t>(units));
    }
    if (!cloud.intensity.empty())
      put(bytes, at + 12,
          static_cast<std::uint16_t>(std::lround(65535.0f * std::clamp(cloud.intensity[i], 0.0f, 1.0f))));
    constexpr std::uint8_t kFirstOfOne = 0b001'001;
    put(bytes, at + 14, kFirstOfOne);
    if (timed) put(bytes, at + 20, las_time_s(stamp_ns, cloud.time_from_stamp_s[i]));
  }
  write_file(path, bytes);
}

}  // namespace remount::formats
