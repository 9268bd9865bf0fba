// Velodyne's HDL-64E, S2 and S3: manual 63-HDL64ES3, with the sensor's own calibration.
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/captures.h"
#include "model/formats/packets/beam_rings.h"
#include "model/formats/packets/files_beside.h"
#include "model/formats/packets/velodyne_blocks.h"
#include "model/formats/packets/velodyne_calibration.h"

namespace remount::formats {

namespace {

constexpr std::size_t kBanks = 2, kHdl64Lasers = kBanks * kReturns;

/// When lasers fire: those of both blocks together, four after each other, eight times.
struct Hdl64Firing {
  double column_us, four_us;
  double after_us[4];
};
constexpr Hdl64Firing kOneReturn{48.0, 6.0, {0.0, 1.26, 2.46, 3.66}}, kTwoReturns{57.6, 7.2, {0.0, 1.3, 2.5, 3.7}};

/// Columns of a packet: of one return an upper and a lower block, of two these twice.
struct Hdl64Layout {
  std::size_t returns = 1, columns = 6;
  const Hdl64Firing* firing = &kOneReturn;

  std::size_t block(std::size_t column, std::size_t bank, std::size_t which) const {
    return (column * returns + which) * kBanks + bank;
  }
  double after_us(std::size_t laser) const {
    const std::size_t place = laser % kReturns;
    return firing->four_us * static_cast<double>(place / 4) + firing->after_us[place % 4];
  }
  /// The stamp is of when the packet is complete.
  double stamp_after_us() const { return firing->column_us * static_cast<double>(columns); }
};

std::optional<Hdl64Layout> hdl64_layout(std::string_view payload) {
  if (!is_hdl64(payload)) return std::nullopt;
  for (std::size_t block = 0; block < kBlocks; ++block)
    if (azimuth_of(payload, block) >= kTurn) return std::nullopt;
  // Its status, which takes the place of the mode, does not say it; what is measured twice has one azimuth.
  bool twice = true;
  for (std::size_t block = 0; block < kBlocks; block += 2 * kBanks)
    twice = twice && azimuth_of(payload, block) == azimuth_of(payload, block + kBanks);
  return twice ? Hdl64Layout{2, 3, &kTwoReturns} : Hdl64Layout{};
}

/// Of one laser, in radians and metres.
struct Hdl64Beam {
  bool used = false;
  double azimuth_rad = 0.0, cos_elevation = 1.0, sin_elevation = 0.0;
  double far_m = 0.0, near_x_m = 0.0, near_y_m = 0.0, height_m = 0.0, aside_m = 0.0;
  bool two_points = false;
  std::uint16_t ring = 0;

  /// As the manual and the sensor's ROS driver have it: x ahead, y left. @param azimuth_rad of the head
  Eigen::Vector3d point(double range_m, double head_rad) const {
    // Where ranges were measured to find the corrections.
    constexpr double kFar_m = 25.04, kNearX_m = 2.4, kNearY_m = 1.93;
    const double distance_m = range_m + far_m, turned_rad = head_rad - azimuth_rad;
    const double s = std::sin(turned_rad), c = std::cos(turned_rad);
    const auto flat_m = [&](double its_m) { return its_m * cos_elevation - height_m * sin_elevation; };
    const auto right_m = [&](double its_m) { return flat_m(its_m) * s - aside_m * c; };
    const auto ahead_m = [&](double its_m) { return flat_m(its_m) * c + aside_m * s; };
    double by_x_m = distance_m, by_y_m = distance_m;
    if (two_points) {
      const auto added_m = [&](double near_m, double at_m, double near_at_m) {
        return (near_m - far_m) * (1.0 - (std::abs(at_m) - near_at_m) / (kFar_m - near_at_m));
      };
      by_x_m += added_m(near_x_m, right_m(distance_m), kNearX_m);
      by_y_m += added_m(near_y_m, ahead_m(distance_m), kNearY_m);
    }
    return {ahead_m(by_y_m), -right_m(by_x_m), by_y_m * sin_elevation + height_m * cos_elevation};
  }
};

constexpr const char* kXmlMark = "vertCorrection_";

/// A calibration and where it was.
struct FoundHdl64 {
  std::filesystem::path file;
  VelodyneCalibration calibration;
  bool same_as(const FoundHdl64& other) const { return calibration.text == other.calibration.text; }
};

/// Nothing for a file of something else, or of a sensor with other lasers.
std::optional<FoundHdl64> parse_hdl64(const std::string& bytes, const std::filesystem::path& file, const char* mark) {
  if (bytes.find(mark) == std::string::npos) return std::nullopt;
  FoundHdl64 found{file, read_velodyne_calibration(bytes, file.string())};
  const auto beyond = [](const CalibratedLaser& laser) { return laser.id >= kHdl64Lasers; };
  if (found.calibration.lasers.size() <= kReturns || std::ranges::any_of(found.calibration.lasers, beyond))
    return std::nullopt;
  return found;
}

std::optional<FoundHdl64> find_hdl64(const BesidePackets& beside, const std::string& where) {
  constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 20U;
  FilesBeside<FoundHdl64> all;
  for (const auto& [ending, mark] :
       {std::pair{".xml", kXmlMark}, std::pair{".yaml", "vert_correction"}, std::pair{".yml", "vert_correction"}}) {
    const char* its_mark = mark;
    auto files = read_files_beside(
        beside, ending, kMostBytes, [&beside, its_mark](const std::string& bytes, const std::filesystem::path& file) {
          return names_other_address(file, beside) ? std::nullopt : parse_hdl64(bytes, file, its_mark);
        });
    std::ranges::move(files.found, std::back_inserter(all.found));
    std::ranges::move(files.broken, std::back_inserter(all.broken));
  }
  return choose_beside(std::move(all), beside,
                       [&](const std::filesystem::path& one, const std::filesystem::path& other, std::string name) {
                         return Error(
                             ErrorCode::Unsupported, where,
                             say::capture_hdl64_several(name_beside(one), name_beside(other), std::move(name)));
                       });
}

class Hdl64Decoder final : public PacketDecoder {
 public:
  std::string model() const override { return "HDL-64E"; }
  std::uint32_t places() const override { return kTurn; }
  void look_beside(const BesidePackets& beside, std::string_view payload, const std::string& where) override;
  std::vector<SourceBeside> sources_beside() const override { return sources_; }
  std::optional<PacketGlance> glance(std::string_view payload) const override;
  void decode(std::string_view payload, const PacketColumns& columns, const PacketSurroundings& around,
              cloud::PointCloud& cloud) const override;

 private:
  void take(const VelodyneCalibration& calibration);
  void decode_column(std::string_view payload, const Hdl64Layout& layout, std::size_t column, double per_us,
                     double begins_s, cloud::PointCloud& cloud) const;

  std::vector<SourceBeside> sources_;
  double unit_m_ = 0.002;
  std::array<Hdl64Beam, kHdl64Lasers> beams_{};
};

void Hdl64Decoder::look_beside(const BesidePackets& beside, std::string_view, const std::string& where) {
  const std::optional<FoundHdl64> found = find_hdl64(beside, where);
  if (!found) throw Error(ErrorCode::Unsupported, where, say::capture_hdl64(beside.recording.stem().string() + ".xml"));
  const bool is_xml = found->calibration.text.find(kXmlMark) != std::string::npos;
  sources_ = {{found->file, beside.said_on(found->file) != nullptr, is_xml ? ".xml" : ".yaml"}};
  take(found->calibration);
}

void Hdl64Decoder::take(const VelodyneCalibration& calibration) {
  unit_m_ = calibration.range_unit_m;
  const double angle_rad = calibration.elevation_unit_rad, length_m = calibration.distance_unit_m;
  std::vector<double> elevations;
  for (const CalibratedLaser& laser : calibration.lasers) elevations.push_back(laser.elevation.value);
  const std::vector<std::uint16_t> rings = rings_of(elevations);
  for (std::size_t i = 0; i < calibration.lasers.size(); ++i) {
    const CalibratedLaser& laser = calibration.lasers[i];
    const double elevation_rad = angle_rad * laser.elevation.value;
    beams_[laser.id] = {.used = true,
                        .azimuth_rad = angle_rad * laser.azimuth,
                        .cos_elevation = std::cos(elevation_rad),
                        .sin_elevation = std::sin(elevation_rad),
                        .far_m = length_m * laser.distances.front().value,
                        .near_x_m = length_m * laser.near_x,
                        .near_y_m = length_m * laser.near_y,
                        .height_m = length_m * laser.height,
                        .aside_m = length_m * laser.aside,
                        .two_points = laser.two_points,
                        .ring = rings[i]};
  }
}

/// Hundredths of a degree in a microsecond.
double hdl64_rate(std::string_view payload, const Hdl64Layout& layout, double otherwise) {
  std::vector<std::uint16_t> azimuths;
  for (std::size_t column = 0; column < layout.columns; ++column)
    azimuths.push_back(azimuth_of(payload, layout.block(column, 0, 0)));
  const std::optional<double> step = mean_step(azimuths);
  return step ? *step / layout.firing->column_us : otherwise;
}

std::optional<PacketGlance> Hdl64Decoder::glance(std::string_view payload) const {
  const std::optional<Hdl64Layout> layout = hdl64_layout(payload);
  if (!layout) return std::nullopt;
  PacketGlance glance;
  glance.clock_period_s = kHour_s;
  glance.sensor_time_ns = little_number<std::uint32_t>(payload, kStampAt) * std::int64_t{1000} -
                          std::llround(1e3 * layout->stamp_after_us());
  std::uint32_t before = glance.first_place = azimuth_of(payload, 0);
  for (std::size_t column = 1; column < layout->columns; ++column) {
    const std::uint32_t azimuth = azimuth_of(payload, layout->block(column, 0, 0));
    if (azimuth + kTurn / 36 < before && glance.cut_column == 0) {
      glance.cut_column = static_cast<std::uint32_t>(column);
      glance.cut_after_ns =
          static_cast<std::uint32_t>(std::lround(1e3 * layout->firing->column_us * static_cast<double>(column)));
    }
    before = azimuth;
  }
  glance.last_place = before;
  return glance;
}

void Hdl64Decoder::decode(std::string_view payload, const PacketColumns& columns, const PacketSurroundings& around,
                          cloud::PointCloud& cloud) const {
  const std::optional<Hdl64Layout> layout = hdl64_layout(payload);
  if (!layout) return;
  const double per_us = hdl64_rate(payload, *layout, 1e-6 * around.places_per_s);
  for (std::size_t column = columns.first; column < std::min<std::size_t>(columns.end, layout->columns); ++column)
    decode_column(payload, *layout, column, per_us,
                  around.time_from_stamp_s + 1e-6 * layout->firing->column_us * static_cast<double>(column), cloud);
}

void Hdl64Decoder::decode_column(std::string_view payload, const Hdl64Layout& layout, std::size_t column, double per_us,
                                 double begins_s, cloud::PointCloud& cloud) const {
  for (std::size_t laser = 0; laser < kHdl64Lasers; ++laser) {
    const std::size_t bank = laser / kReturns;
    const Hdl64Beam& beam = beams_[laser];
    if (!beam.used) continue;
    const double after_us = layout.after_us(laser);
    std::uint16_t other = 0;
    for (std::size_t which = 0; which < layout.returns; ++which) {
      const std::size_t block = layout.block(column, bank, which);
      const std::size_t at = block * kBlockBytes + 4 + laser % kReturns * kReturnBytes;
      const auto range = little_number<std::uint16_t>(payload, at);
      if (range == 0 || range == other) continue;  // no return, or the last is the strongest
      other = range;
      const double head_rad = degrees_to_radians(0.01 * (azimuth_of(payload, block) + after_us * per_us));
      cloud.points.push_back(beam.point(range * unit_m_, head_rad).cast<float>());
      cloud.intensity.push_back(byte_at(payload, at + 2));
      cloud.ring.push_back(beam.ring);
      cloud.time_from_stamp_s.push_back(static_cast<float>(begins_s + 1e-6 * after_us));
    }
  }
}

}  // namespace

bool is_hdl64(std::string_view payload) {
  if (payload.size() != kDataBytes) return false;
  for (std::size_t block = 0; block < kBlocks; ++block)
    if (flag_of(payload, block) != flag_of_bank(block % kBanks)) return false;
  return true;
}

std::unique_ptr<PacketDecoder> make_hdl64_decoder() { return std::make_unique<Hdl64Decoder>(); }

}  // namespace remount::formats
