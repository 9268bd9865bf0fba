// Velodyne: data packets of 1206 bytes, position packets of 512 (554 with the headers of the network).
#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/captures.h"
#include "model/formats/packets/beam_rings.h"
#include "model/formats/packets/packet_decoder.h"
#include "model/formats/packets/velodyne_blocks.h"
#include "model/formats/packets/velodyne_models.h"

namespace remount::formats {

namespace {

constexpr std::size_t kModeAt = 1204, kProductAt = 1205;

/// How the returns of one packet are laid out. Of two returns the blocks follow each other: the last, the strongest.
struct Layout {
  std::size_t returns = 1;
  std::size_t banks = 1;             ///< blocks that one column takes
  std::size_t columns_in_block = 1;  ///< of 16 lasers: 2
  std::size_t columns = 0;

  std::size_t block(std::size_t column, std::size_t bank, std::size_t which) const {
    return (column / columns_in_block * banks + bank) * returns + which;
  }
};

class VelodyneDecoder final : public PacketDecoder {
 public:
  explicit VelodyneDecoder(const VelodyneModel& model) : model_(model), column_us_(model.column_us) {
    std::vector<double> elevations_deg;
    for (const VelodyneLaser& laser : model.lasers) elevations_deg.push_back(laser.elevation_deg);
    const std::vector<std::uint16_t> rings = rings_of(elevations_deg);
    for (const VelodyneLaser& laser : model.lasers) {
      const double elevation_rad = degrees_to_radians(laser.elevation_deg);
      lasers_.push_back({std::cos(elevation_rad), std::sin(elevation_rad), 1e-3 * laser.height_mm,
                         degrees_to_radians(laser.azimuth_offset_deg), rings[lasers_.size()]});
    }
  }

  std::string model() const override { return std::string(model_.name); }
  std::uint32_t places() const override { return kTurn; }
  std::optional<PacketGlance> glance(std::string_view payload) const override;
  void decode(std::string_view payload, const PacketColumns& columns, const PacketSurroundings& around,
              cloud::PointCloud& cloud) const override;
  /// Alpha Primes of later firmware fire more slowly, all of it stretched alike: 2.89 us from group to group.
  void tune(const PacketSequence& packets, const std::string& where) override;

 private:
  struct Laser {
    double cos_elevation = 1.0, sin_elevation = 0.0, height_m = 0.0, azimuth_offset_rad = 0.0;
    std::uint16_t ring = 0;
  };

  std::optional<Layout> layout_of(std::string_view payload) const;
  double column_azimuth(std::string_view payload, const Layout& layout, std::size_t column, double per_us) const;
  double azimuth_per_us(std::string_view payload, const Layout& layout, double otherwise) const;
  double after_column_us(std::size_t laser) const {
    const std::size_t group = laser / static_cast<std::size_t>(model_.lasers_at_once);
    const auto pause = static_cast<std::size_t>(model_.pause_after);
    return stretch_ * model_.step_us * static_cast<double>(group + (pause > 0 && group >= pause ? 1 : 0));
  }

  const VelodyneModel& model_;
  std::vector<Laser> lasers_;
  double column_us_, stretch_ = 1.0;
};

std::optional<Layout> VelodyneDecoder::layout_of(std::string_view payload) const {
  constexpr std::uint8_t kStrongest = 0x37, kLast = 0x38, kDual = 0x39;
  if (payload.size() != kDataBytes || velodyne_model(byte_at(payload, kProductAt)) != &model_) return std::nullopt;
  const std::uint8_t mode = byte_at(payload, kModeAt);
  if (mode != kStrongest && mode != kLast && mode != kDual) return std::nullopt;
  Layout layout;
  layout.returns = mode == kDual ? 2 : 1;
  layout.banks = std::max<std::size_t>(1, lasers_.size() / kReturns);
  layout.columns_in_block = std::max<std::size_t>(1, kReturns / lasers_.size());
  layout.columns = kBlocks / (layout.banks * layout.returns) * layout.columns_in_block;
  for (std::size_t column = 0; column < layout.columns; ++column)
    for (std::size_t bank = 0; bank < layout.banks; ++bank)
      for (std::size_t which = 0; which < layout.returns; ++which) {
        const std::size_t block = layout.block(column, bank, which);
        if (flag_of(payload, block) != flag_of_bank(bank)) return std::nullopt;
        if (little_number<std::uint16_t>(payload, block * kBlockBytes + 2) >= kTurn) return std::nullopt;
      }
  return layout;
}

/// Hundredths of a degree in a microsecond.
double VelodyneDecoder::azimuth_per_us(std::string_view payload, const Layout& layout, double otherwise) const {
  std::vector<std::uint16_t> azimuths;
  for (std::size_t column = 0; column < layout.columns; column += layout.columns_in_block)
    azimuths.push_back(azimuth_of(payload, layout.block(column, 0, 0)));
  const std::optional<double> step = mean_step(azimuths);
  return step ? *step / (static_cast<double>(layout.columns_in_block) * column_us_) : otherwise;
}

/// In hundredths of a degree, [0, kTurn).
double VelodyneDecoder::column_azimuth(std::string_view payload, const Layout& layout, std::size_t column,
                                       double per_us) const {
  const auto begins = little_number<std::uint16_t>(payload, layout.block(column, 0, 0) * kBlockBytes + 2);
  return std::fmod(begins + static_cast<double>(column % layout.columns_in_block) * column_us_ * per_us, kTurn);
}

std::optional<PacketGlance> VelodyneDecoder::glance(std::string_view payload) const {
  const std::optional<Layout> layout = layout_of(payload);
  if (!layout) return std::nullopt;
  const double per_us = azimuth_per_us(payload, *layout, 0.0);
  PacketGlance glance;
  glance.clock_period_s = kHour_s;
  glance.sensor_time_ns = little_number<std::uint32_t>(payload, kStampAt) * std::int64_t{1000} -
                          std::llround(1e3 * stretch_ * model_.stamp_after_us);
  double before = column_azimuth(payload, *layout, 0, per_us);
  glance.first_place = static_cast<std::uint32_t>(before);
  for (std::size_t column = 1; column < layout->columns; ++column) {
    const double azimuth = column_azimuth(payload, *layout, column, per_us);
    if (azimuth < before - kTurn / 36 && glance.cut_column == 0) {
      glance.cut_column = static_cast<std::uint32_t>(column);
      glance.cut_after_ns = static_cast<std::uint32_t>(std::lround(1e3 * column_us_ * static_cast<double>(column)));
    }
    before = azimuth;
  }
  glance.last_place = static_cast<std::uint32_t>(before);
  return glance;
}

void VelodyneDecoder::decode(std::string_view payload, const PacketColumns& columns, const PacketSurroundings& around,
                             cloud::PointCloud& cloud) const {
  const std::optional<Layout> layout = layout_of(payload);
  if (!layout) return;
  const double per_us = azimuth_per_us(payload, *layout, 1e-6 * around.places_per_s);
  for (std::size_t column = columns.first; column < std::min<std::size_t>(columns.end, layout->columns); ++column) {
    const double column_us = static_cast<double>(column) * column_us_;
    const double begins = column_azimuth(payload, *layout, column, per_us);
    for (std::size_t l = 0; l < lasers_.size(); ++l) {
      const Laser& laser = lasers_[l];
      const std::size_t within = (column % layout->columns_in_block * lasers_.size() + l) % kReturns;
      const double after_us = after_column_us(l);
      const double azimuth_rad = degrees_to_radians(0.01 * (begins + after_us * per_us)) + laser.azimuth_offset_rad;
      std::uint16_t other = 0;
      for (std::size_t which = 0; which < layout->returns; ++which) {
        const std::size_t at = layout->block(column, l / kReturns, which) * kBlockBytes + 4 + within * kReturnBytes;
        const auto range = little_number<std::uint16_t>(payload, at);
        if (range == 0 || range == other) continue;  // no return, or the last is the strongest
        other = range;
        const double range_m = range * model_.unit_m, flat_m = range_m * laser.cos_elevation;
        cloud.points.emplace_back(static_cast<float>(flat_m * std::cos(azimuth_rad)),
                                  static_cast<float>(-flat_m * std::sin(azimuth_rad)),
                                  static_cast<float>(range_m * laser.sin_elevation + laser.height_m));
        cloud.intensity.push_back(byte_at(payload, at + 2));
        cloud.ring.push_back(laser.ring);
        cloud.time_from_stamp_s.push_back(static_cast<float>(around.time_from_stamp_s + 1e-6 * (column_us + after_us)));
      }
    }
  }
}

void VelodyneDecoder::tune(const PacketSequence& packets, const std::string&) {
  constexpr double kSlowStep_us = 2.89;
  if (model_.pause_after == 0) return;
  // One column or three, as there are one or two returns.
  for (const double columns : {1.0, 3.0}) {
    const double ratio = 1e-3 * static_cast<double>(packets.interval_ns) / (columns * model_.column_us);
    if (ratio < 1.04 || ratio > 1.13) continue;
    stretch_ = kSlowStep_us / model_.step_us;
    column_us_ = model_.column_us * stretch_;
  }
}

std::unique_ptr<PacketDecoder> recognise_velodyne(std::string_view payload, const std::string& where) {
  if (payload.size() != kDataBytes || flag_of(payload, 0) != flag_of_bank(0)) return nullptr;
  if (is_hdl64(payload)) return make_hdl64_decoder();
  const std::uint8_t product = byte_at(payload, kProductAt);
  const VelodyneModel* model = velodyne_model(product);
  if (model == nullptr) throw Error(ErrorCode::Unsupported, where, say::capture_velodyne_product(product));
  return std::make_unique<VelodyneDecoder>(*model);
}

std::optional<PositionPacket> velodyne_position(std::string_view payload) {
  constexpr std::size_t kPositionBytes = 512, kPpsAt = 0xca, kSentenceAt = 0xce;
  constexpr std::uint8_t kLocked = 2, kMostStatus = 3;
  if (payload.size() != kPositionBytes || byte_at(payload, kPpsAt) > kMostStatus) return std::nullopt;
  // Nothing else of these 512 bytes tells them apart from others: they are zero in all firmware, but for where an
  // HDL-32E has its gyros, thermometers and accelerometers.
  constexpr std::size_t kImuAt = 14, kBehindImu = 38, kZerosEnd = 0xbb;
  if (payload.find_first_not_of('\0') < kImuAt || payload.find_first_not_of('\0', kBehindImu) < kZerosEnd)
    return std::nullopt;
  PositionPacket position;
  position.clock_locked = byte_at(payload, kPpsAt) == kLocked;
  position.sentences = position_sentence(payload.substr(kSentenceAt));
  return position;
}

}  // namespace

PacketFormat velodyne_packets() { return {"velodyne", recognise_velodyne, velodyne_position}; }

}  // namespace remount::formats
