// LAS 1.0 to 1.4 (ASPRS), point formats 0 to 10, plain or compressed (LAZ), as single scans in the sensor's frame.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "algorithms/core/error.h"
#include "algorithms/core/stamps.h"
#include "messages/clouds.h"
#include "model/formats/clouds/cloud_fields.h"
#include "model/formats/files/running_period.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/laz/laz_points.h"

namespace remount::formats {
namespace {

constexpr bool kSwapLas = std::endian::native == std::endian::big;

/// What a point of a format holds at least, and where its time lies; 0: it has none.
struct PointLayout {
  std::size_t bytes = 0, time_at = 0;
};
constexpr std::array<PointLayout, 11> kLayouts{
    {{20, 0}, {28, 20}, {26, 0}, {34, 20}, {57, 20}, {63, 20}, {30, 22}, {36, 22}, {38, 22}, {59, 22}, {67, 22}}};

struct LasHeader {
  std::size_t header_bytes = 0, header_records = 0;
  std::size_t format = 0, record_bytes = 0, points_at = 0, points = 0;
  bool compressed = false;
  bool whole_gps_time = false;  ///< GPS seconds less 1e9; otherwise seconds of the GPS week
  std::array<double, 3> scale{}, offset{};
};

/// Reads the header. Throws Error(Format) at path:byte.
class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::filesystem::path& path) : bytes_(bytes), path_(path) {}

  LasHeader read() const {
    if (!bytes_.starts_with("LASF")) fail(0, say::las_no_mark());
    if (bytes_.size() < 227) fail(bytes_.size(), say::las_short_header(Bytes{227}));
    const int major = static_cast<int>(value(24, ScalarType::U8)), minor = static_cast<int>(value(25, ScalarType::U8));
    if (major != 1 || minor > 4) fail(24, say::las_version(major, minor));
    LasHeader header;
    constexpr unsigned kCompressed = 0x80, kFormat = 0x3f;
    const auto flagged = static_cast<unsigned>(value(104, ScalarType::U8));
    header.compressed = (flagged & kCompressed) != 0;
    header.header_bytes = static_cast<std::size_t>(value(94, ScalarType::U16));
    header.header_records = static_cast<std::size_t>(value(100, ScalarType::U32));
    const std::size_t format = flagged & kFormat;
    if (format >= kLayouts.size()) fail(104, say::las_point_format(format));
    header.format = format;
    header.record_bytes = static_cast<std::size_t>(value(105, ScalarType::U16));
    if (header.record_bytes < kLayouts[format].bytes)
      fail(105, say::las_small_points(Bytes{header.record_bytes}, format, kLayouts[format].bytes));
    // Before 1.2 these bytes were a number of the flight, and all times seconds of a week.
    header.whole_gps_time = minor >= 2 && (static_cast<unsigned>(value(6, ScalarType::U16)) & 1U) != 0;
    header.points_at = static_cast<std::size_t>(value(96, ScalarType::U32));
    header.points = point_count(minor);
    if (header.points_at < 227 || header.points_at > bytes_.size() ||
        (!header.compressed && header.points > (bytes_.size() - header.points_at) / header.record_bytes))
      fail(96, say::las_points_beyond_end(header.points, Bytes{header.record_bytes}, header.points_at,
                                          Bytes{bytes_.size()}));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      header.scale[axis] = value(131 + 8 * axis, ScalarType::F64);
      header.offset[axis] = value(155 + 8 * axis, ScalarType::F64);
      if (!std::isfinite(header.offset[axis]) || !std::isfinite(header.scale[axis]) || header.scale[axis] == 0.0)
        fail(131 + 8 * axis, say::las_scale());
    }
    return header;
  }

 private:
  double value(std::size_t at, ScalarType type) const { return read_scalar(bytes_.data() + at, type, kSwapLas); }

  std::size_t point_count(int minor) const {
    const auto legacy = static_cast<std::size_t>(value(107, ScalarType::U32));
    if (minor < 4) return legacy;
    if (bytes_.size() < 375) fail(bytes_.size(), say::las_short_header_14(Bytes{375}));
    const double count = value(247, ScalarType::U64);
    if (count == 0.0) return legacy;      // a writer that knows the older headers only
    constexpr double kMostOfAByte = 2.0;  // of compressed ones
    if (count > kMostOfAByte * static_cast<double>(bytes_.size())) fail(247, say::las_too_many_points());
    return static_cast<std::size_t>(count);
  }

  [[noreturn]] void fail(std::size_t byte, Message what) const {
    throw Error(ErrorCode::Format, path_.string() + ", byte " + std::to_string(byte), std::move(what));
  }

  std::string_view bytes_;
  const std::filesystem::path& path_;
};

/// Seconds since 1970 of a time of the file, as far as the format tells; of a GPS week the one nearest to the stamp.
class PointClock {
 public:
  PointClock(bool whole_gps_time, std::int64_t stamp_ns) : whole_(whole_gps_time) {
    if (whole_ || stamp_ns == 0) return;
    const std::int64_t week = (stamp_ns - kGpsEpoch_ns) / kGpsWeek_ns;
    for (std::int64_t near = std::max<std::int64_t>(0, week - 1); near <= week + 1; ++near)
      starts_s_.push_back(seconds(unix_ns_from_gps_ns(near * kGpsWeek_ns)));
    stamp_s_ = seconds(stamp_ns);
  }

  double unix_s(double time) const {
    if (whole_) return seconds(unix_ns_from_gps_ns(std::llround((time + 1e9) * 1e9)));
    double best = time;
    for (const double start : starts_s_)
      if (std::abs(start + time - stamp_s_) < std::abs(best - stamp_s_)) best = start + time;
    return best;
  }

 private:
  bool whole_;
  double stamp_s_ = 0.0;
  std::vector<double> starts_s_;
};

/// Points of a file that is not compressed.
void take_plain(std::string_view bytes, const LasHeader& header, const TakeRecord& take) {
  const std::size_t time_at = kLayouts[header.format].time_at;
  for (std::size_t i = 0; i < header.points; ++i) {
    const char* point = bytes.data() + header.points_at + i * header.record_bytes;
    LasRecord record;
    for (std::size_t axis = 0; axis < 3; ++axis)
      record.xyz[axis] = static_cast<std::int32_t>(read_scalar(point + 4 * axis, ScalarType::I32, kSwapLas));
    record.intensity = static_cast<std::uint16_t>(read_scalar(point + 12, ScalarType::U16, kSwapLas));
    if (time_at > 0) record.time = read_scalar(point + time_at, ScalarType::F64, kSwapLas);
    take(record);
  }
}

void take_records(std::string_view bytes, const std::filesystem::path& path, const LasHeader& header,
                  const TakeRecord& take) {
  if (!header.compressed) return take_plain(bytes, header, take);
  unpack_laz({bytes, path.string(), header.header_bytes, header.header_records, header.points_at, header.points,
              header.record_bytes, header.format},
             take);
}

/// Whether the points carry times at all: many files have the column and leave it at one value.
class TimesSeen {
 public:
  void add(double time) {
    known_ = known_ && std::abs(time) < 5e9;
    low_ = std::min(low_, time);
    high_ = std::max(high_, time);
  }
  bool any() const { return known_ && high_ > low_; }

 private:
  bool known_ = true;
  double low_ = std::numeric_limits<double>::max(), high_ = std::numeric_limits<double>::lowest();
};

}  // namespace

ReadCloud parse_las(std::string_view bytes, const std::filesystem::path& path, std::int64_t stamp_ns,
                    PointTimes times) {
  const LasHeader header = HeaderReader(bytes, path).read();
  const bool has_column = kLayouts[header.format].time_at > 0;
  const CloudColumns columns{0, 1, 2, 3, -1, has_column ? 4 : -1};
  // A byte of compressed points holds one at most of all scans but those that mostly have no return.
  CloudBuilder builder(columns, {ScalarType::F64, 1.0}, std::min(header.points, bytes.size()));
  const PointClock clock(header.whole_gps_time, stamp_ns);
  TimesSeen times_seen;
  take_records(bytes, path, header, [&](const LasRecord& record) {
    const auto coordinate = [&](std::size_t axis) {
      return record.xyz[axis] * header.scale[axis] + header.offset[axis];
    };
    RawPoint point{coordinate(0), coordinate(1), coordinate(2)};
    point.intensity = record.intensity;
    if (has_column) {
      times_seen.add(record.time);
      point.time = clock.unix_s(record.time);
    }
    builder.add(point);
  });
  const bool timed = has_column && times_seen.any();
  if (!timed) builder.leave_out_times();
  ReadCloud read = builder.finish(stamp_ns, path.string(), times);
  read.columns = "x y z intensity";
  if (has_column) read.columns += " gps_time";
  if (has_column && !timed) read.note = say::las_one_time;
  return read;
}

}  // namespace remount::formats
