// Scans of bare 32-bit floats. Nothing in such a file says how many make a point: KITTI has 4, NCLT's converters 3,
// nuScenes 5, Waymo's 6. The numbers tell: in the right layout each column holds one kind of number, heights that
// differ by little and reflectances beside coordinates that differ by much; in a wrong one they take turns.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "algorithms/core/error.h"
#include "messages/clouds.h"
#include "model/formats/clouds/cloud_fields.h"

namespace remount::formats {
namespace {

constexpr bool kSwapBin = std::endian::native == std::endian::big;
constexpr std::size_t kFloatBytes = 4, kValueParts = 16;
/// Of files that may be either, the first is taken. Of 6 and 3, both fit wherever 3 does: the smaller comes before.
constexpr std::array<std::size_t, 4> kFloatsAPoint{4, 3, 5, 6};

/// The floats of a file, as many as are needed to tell their layout.
class Floats {
 public:
  explicit Floats(std::string_view bytes) : bytes_(bytes) {}
  std::size_t size() const { return bytes_.size() / kFloatBytes; }
  double operator[](std::size_t i) const {
    return read_scalar(bytes_.data() + kFloatBytes * i, ScalarType::F32, kSwapBin);
  }

 private:
  std::string_view bytes_;
};

/// Numbers that sensors and converters write; bytes of other types rarely make such floats.
bool is_measured_number(double value) {
  const double size = std::abs(value);
  return std::isnan(value) || size == 0.0 || (size > 1e-12 && size < 1e8);
}

/// Values from the middle of a file, each with the sixteenth of all values that it is in; empty where they are no
/// numbers that were measured.
std::vector<std::size_t> sixteenths(const Floats& floats, std::size_t first, std::size_t count) {
  constexpr double kFew = 0.02;  // share of what is damaged
  std::vector<double> values;
  std::size_t odd = 0;
  for (std::size_t i = 0; i < count; ++i) {
    odd += is_measured_number(floats[first + i]) ? 0 : 1;
    values.push_back(std::isnan(floats[first + i]) ? 0.0 : floats[first + i]);
  }
  if (static_cast<double>(odd) > kFew * static_cast<double>(count)) return {};
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::size_t> parts;
  for (const double value : values) {
    const auto below = std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin();
    parts.push_back(static_cast<std::size_t>(below) * kValueParts / count);
  }
  return parts;
}

/// How much the place of a value among `width` tells of the value: their mutual information, nats. Of a layout that is
/// not the file's every column holds everything, and it tells nothing; the same where all values of one coordinate
/// stand before those of the next. Nothing where the bytes are no numbers that were measured.
std::optional<double> told_by_column(const Floats& floats, std::size_t width) {
  constexpr std::size_t kMost = 4000;  // points
  const std::size_t all = floats.size() / width, points = std::min(all, kMost);
  const std::size_t first = (all - points) / 2 * width;
  const std::vector<std::size_t> parts = sixteenths(floats, first, points * width);
  if (parts.empty()) return std::nullopt;
  std::vector<double> of_all(kValueParts), of_column(kValueParts * width);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    of_all[parts[i]] += 1.0;
    of_column[i % width * kValueParts + parts[i]] += 1.0;
  }
  const auto count = static_cast<double>(parts.size());
  double told = 0.0;
  for (std::size_t i = 0; i < of_column.size(); ++i)
    if (of_column[i] > 0.0)
      told += of_column[i] / count * std::log(of_column[i] * static_cast<double>(width) / of_all[i % kValueParts]);
  // Few values tell as much by chance.
  return told - static_cast<double>((width - 1) * (kValueParts - 1)) / (2.0 * count);
}

/// NCLT's own files: three coordinates of 16 bits, intensity and laser (of 32) of 8.
bool looks_like_nclt(std::string_view bytes) {
  constexpr std::size_t kRecord = 8, kLasers = 32;
  if (bytes.empty() || bytes.size() % kRecord != 0) return false;
  for (std::size_t at = kRecord - 1; at < bytes.size(); at += kRecord)
    if (static_cast<unsigned char>(bytes[at]) >= kLasers) return false;
  return true;
}

[[noreturn]] void refuse_bin(std::string_view bytes, const std::filesystem::path& path) {
  if (looks_like_nclt(bytes)) throw Error(ErrorCode::Unsupported, path.string(), say::bin_of_nclt(say::bin_expected()));
  throw Error(ErrorCode::Format, path.string(), say::bin_no_points(Bytes{bytes.size()}, say::bin_expected()));
}

/// Throws Error where no layout makes points of the bytes.
std::size_t floats_a_point(std::string_view bytes, const std::filesystem::path& path) {
  constexpr std::size_t kFewest = 64;  // points: fewer do not tell
  constexpr double kLeast = 0.02, kClearly = 0.05;
  const Floats floats(bytes);
  std::optional<std::size_t> best;
  double most = 0.0;
  for (const std::size_t width : kFloatsAPoint) {
    if (bytes.empty() || bytes.size() % (width * kFloatBytes) != 0) continue;
    if (floats.size() < kFewest * width) {
      if (!best) best = width;
      continue;
    }
    const std::optional<double> told = told_by_column(floats, width);
    if (!told || *told < (best ? most + kClearly : kLeast)) continue;
    best = width;
    most = *told;
  }
  if (!best) refuse_bin(bytes, path);
  return *best;
}

/// Whether the fifth of the floats is the number of a beam.
bool has_rings(const Floats& floats, std::size_t width) {
  constexpr double kMostBeams = 256.0;
  if (width < 5) return false;
  for (std::size_t at = 4; at < floats.size(); at += width)
    if (!(floats[at] >= 0.0 && floats[at] < kMostBeams && floats[at] == std::floor(floats[at]))) return false;
  return true;
}

}  // namespace

ReadCloud parse_bin(std::string_view bytes, const std::filesystem::path& path, std::size_t known_width) {
  const bool is_known = known_width > 0 && !bytes.empty() && bytes.size() % (known_width * kFloatBytes) == 0;
  if (known_width > 0 && !is_known) refuse_bin(bytes, path);
  const std::size_t width = is_known ? known_width : floats_a_point(bytes, path);
  const Floats floats(bytes);
  CloudColumns columns;
  if (width > 3) columns.intensity = 3;
  const bool ringed = has_rings(floats, width);
  if (ringed) columns.ring = 4;
  CloudBuilder builder(columns, {}, floats.size() / width);
  for (std::size_t at = 0; at + width <= floats.size(); at += width) {
    RawPoint point{floats[at], floats[at + 1], floats[at + 2]};
    if (width > 3) point.intensity = floats[at + 3];
    if (ringed) point.ring = floats[at + 4];
    builder.add(point);
  }
  ReadCloud read = builder.finish(0, path.string());
  read.columns = width == 3 ? "x y z" : "x y z reflectance";
  if (ringed && width == 5)
    read.columns += " ring";
  else if (width > 4)
    read.note = width == 5 ? say::bin_and_one_more : say::bin_and_two_more;
  return read;
}

}  // namespace remount::formats
