// Hesai's sensors: packets of blocks, each with the returns of all channels.
#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/captures.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/packets/beam_rings.h"
#include "model/formats/packets/hesai_angles.h"
#include "model/formats/packets/hesai_models.h"
#include "model/formats/packets/packet_decoder.h"
#include "model/formats/packets/packet_times.h"

namespace remount::formats {

namespace {

constexpr std::uint32_t kHesaiTurn = 36000;  // hundredths of a degree

/// When the first channel fires, from the time of its block.
double first_firing_us(const HesaiModel& model) {
  double first_us = model.times_us.front().front();
  for (const std::vector<double>& set : model.times_us)
    first_us = std::min(first_us, *std::min_element(set.begin(), set.end()));
  return first_us;
}

/// Unix time of a packet's stamp; nothing where it has no date.
std::optional<std::int64_t> hesai_stamp_ns(std::string_view payload, const HesaiLayout& layout) {
  constexpr std::int64_t kMostUs = 2'000'000;
  const std::int64_t us = little_number<std::uint32_t>(payload, layout.stamp_at);
  if (us > kMostUs) return std::nullopt;
  const auto byte = [&](std::size_t i) { return byte_at(payload, layout.date_at + i); };
  if (byte(0) == 0 && !layout.years_from_2000)  // seconds, most significant byte first
    return network_number<std::uint32_t>(payload, layout.date_at + 2) * kSecond_ns + us * 1000;
  // Some firmware counts from 1900 where the manual says 2000.
  const bool from_2000 = byte(0) < 70 || (layout.years_from_2000 && byte(0) < 100);
  const int year = byte(0) + (from_2000 ? 2000 : 1900);
  const std::optional<std::int64_t> second_ns = unix_ns({year, byte(1), byte(2), byte(3), byte(4), byte(5)});
  if (!second_ns || year > 2100) return std::nullopt;
  return *second_ns + us * 1000;
}

class HesaiDecoder final : public PacketDecoder {
 public:
  explicit HesaiDecoder(const HesaiModel& model) : model_(model), first_us_(first_firing_us(model)) {
    take_angles(model.elevations_deg, model.azimuths_deg);
  }

  std::string model() const override { return std::string(model_.name); }
  std::uint32_t places() const override { return kHesaiTurn; }
  void look_beside(const BesidePackets& beside, std::string_view payload, const std::string& where) override;
  std::vector<SourceBeside> sources_beside() const override { return sources_; }
  Message remark() const override { return measured_ ? Message() : say::capture_hesai_nominal(model()); }
  std::optional<PacketGlance> glance(std::string_view payload) const override;
  void decode(std::string_view payload, const PacketColumns& columns, const PacketSurroundings& around,
              cloud::PointCloud& cloud) const override;
  bool decodes_falling() const override { return true; }
  void tune(const PacketSequence& packets, const std::string&) override { falls_ = packets.falls; }

 private:
  struct Channel {
    double cos_elevation = 1.0, sin_elevation = 0.0, azimuth_deg = 0.0;
    std::uint16_t ring = 0;
  };

  /// A beam, as it leaves the sensor.
  struct Direction {
    double cos_elevation = 1.0, sin_elevation = 0.0, azimuth_rad = 0.0;
  };

  void take_angles(const std::vector<double>& elevations_deg, const std::vector<double>& azimuths_deg);
  std::uint32_t place_of(std::string_view payload, const HesaiLayout& layout, std::size_t column) const;
  Direction direction_of(std::size_t channel, double encoder_deg, std::optional<std::size_t> mirror,
                         double turned_deg) const;
  std::optional<HesaiLayout> layout_of(std::string_view payload) const;
  void decode_block(std::string_view payload, const HesaiLayout& layout, std::size_t column, double begins_s,
                    cloud::PointCloud& cloud) const;

  const HesaiModel& model_;
  double first_us_;
  std::vector<Channel> channels_;
  std::optional<HesaiMirrors> mirrors_;
  bool measured_ = false;  ///< the angles are of a sensor, not of its data sheet
  std::vector<SourceBeside> sources_;
  bool falls_ = false;  ///< it turns counter-clockwise, which packets of one column do not show
};

void HesaiDecoder::take_angles(const std::vector<double>& elevations_deg, const std::vector<double>& azimuths_deg) {
  const std::vector<std::uint16_t> rings = rings_of(elevations_deg);
  channels_.resize(elevations_deg.size());
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    const double elevation_rad = degrees_to_radians(elevations_deg[c]);
    channels_[c] = {std::cos(elevation_rad), std::sin(elevation_rad), azimuths_deg[c], rings[c]};
  }
}

void HesaiDecoder::look_beside(const BesidePackets& beside, std::string_view, const std::string& where) {
  const std::string ending = model_.mirrored ? ".dat" : ".csv", wanted = beside.recording.stem().string() + ending;
  const auto take = [&](const auto& angles) {
    measured_ = true;
    sources_ = {{angles.file, beside.said_on(angles.file) != nullptr, ending}};
    take_angles(angles.elevations_deg, angles.azimuths_deg);
  };
  if (model_.mirrored) {
    mirrors_ = find_hesai_mirrors(beside, where);
    if (!mirrors_) throw Error(ErrorCode::Unsupported, where, say::capture_hesai_no_angles(model(), wanted));
    take(*mirrors_);
    return;
  }
  const std::optional<HesaiAngles> angles = find_hesai_angles(beside, model_.channels, where);
  if (!angles && model_.elevations_deg.empty())
    throw Error(ErrorCode::Unsupported, where, say::capture_hesai_no_angles(model(), wanted));
  if (angles) take(*angles);
}

std::optional<HesaiLayout> HesaiDecoder::layout_of(std::string_view payload) const {
  const std::optional<HesaiLayout> layout = hesai_layout(payload);
  if (!layout || layout->model != &model_) return std::nullopt;
  for (std::size_t column = 0; column < layout->columns(); ++column)
    if (layout->azimuth_deg(payload, column) > 360.0) return std::nullopt;
  return layout;
}

/// In the part of the turn that belongs to a mirror, where there are any: scans are cut from one to the next.
std::uint32_t HesaiDecoder::place_of(std::string_view payload, const HesaiLayout& layout, std::size_t column) const {
  double place_deg = layout.azimuth_deg(payload, column);
  if (mirrors_)
    if (const auto mirror = mirrors_->mirror_at(place_deg)) place_deg += 360.0 - mirrors_->begins_deg[*mirror];
  return static_cast<std::uint32_t>(std::lround(100.0 * place_deg)) % kHesaiTurn;
}

std::optional<PacketGlance> HesaiDecoder::glance(std::string_view payload) const {
  const std::optional<HesaiLayout> layout = layout_of(payload);
  const std::optional<std::int64_t> time_ns = layout ? hesai_stamp_ns(payload, *layout) : std::nullopt;
  if (!time_ns) return std::nullopt;
  const bool falls = layout->falls(payload);
  const auto place = [&](std::size_t column) {
    const std::uint32_t its = place_of(payload, *layout, column);
    return falls ? kHesaiTurn - 1 - its : its;
  };
  PacketGlance glance;
  glance.sensor_time_ns = *time_ns + std::llround(1e3 * (layout->column_us(0) + first_us_));
  glance.first_place = glance.last_place = place(0);
  for (std::size_t column = 1; column < layout->columns(); ++column) {
    if (place(column) + kHesaiTurn / 36 < glance.last_place && glance.cut_column == 0) {
      glance.cut_column = static_cast<std::uint32_t>(column);
      glance.cut_after_ns =
          static_cast<std::uint32_t>(std::lround(1e3 * (layout->column_us(column) - layout->column_us(0))));
    }
    glance.last_place = place(column);
  }
  return glance;
}

HesaiDecoder::Direction HesaiDecoder::direction_of(std::size_t c, double encoder_deg, std::optional<std::size_t> mirror,
                                                   double turned_deg) const {
  const Channel& channel = channels_[c];
  if (!mirror)
    return {channel.cos_elevation, channel.sin_elevation,
            degrees_to_radians(encoder_deg + channel.azimuth_deg + turned_deg)};
  const auto [azimuth_deg, elevation_deg] = mirrors_->angles_deg(*mirror, c, encoder_deg);
  const double elevation_rad = degrees_to_radians(elevation_deg);
  return {std::cos(elevation_rad), std::sin(elevation_rad), degrees_to_radians(azimuth_deg)};
}

void HesaiDecoder::decode_block(std::string_view payload, const HesaiLayout& layout, std::size_t column,
                                double begins_s, cloud::PointCloud& cloud) const {
  constexpr double kNearest_m = 0.05;  // nearer ones are marks, not ranges
  constexpr double kDegPerUsAtRpm = 6e-6;
  const double deg_per_us = (layout.falls(payload) || falls_ ? -kDegPerUsAtRpm : kDegPerUsAtRpm) *
                            little_number<std::uint16_t>(payload, layout.speed_at);
  const double encoder_deg = layout.azimuth_deg(payload, column);
  const auto mirror = mirrors_ ? mirrors_->mirror_at(encoder_deg) : std::nullopt;
  if (mirrors_ && !mirror) return;
  const std::size_t far_times = layout.times_set(payload, column);
  std::array<std::uint16_t, 3> others{};
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    others.fill(0);
    for (std::size_t which = 0; which < layout.returns; ++which) {
      const std::size_t at = layout.block_at(column, which) + layout.units_at + c * layout.unit_bytes;
      const auto range = little_number<std::uint16_t>(payload, at);
      const double range_m = range * layout.unit_m;
      if (range_m < kNearest_m || std::find(others.begin(), others.end(), range) != others.end()) continue;
      others.at(which) = range;
      const double after_us = model_.times_us[far_times + (range_m <= model_.near_m ? 1 : 0)][c];
      const Direction beam = direction_of(c, encoder_deg, mirror, after_us * deg_per_us);
      const double flat_m = range_m * beam.cos_elevation;
      cloud.points.emplace_back(static_cast<float>(flat_m * std::sin(beam.azimuth_rad)),
                                static_cast<float>(flat_m * std::cos(beam.azimuth_rad)),
                                static_cast<float>(range_m * beam.sin_elevation));
      cloud.intensity.push_back(byte_at(payload, at + 2));
      cloud.ring.push_back(channels_[c].ring);
      cloud.time_from_stamp_s.push_back(static_cast<float>(begins_s + 1e-6 * (after_us - first_us_)));
    }
  }
}

void HesaiDecoder::decode(std::string_view payload, const PacketColumns& columns, const PacketSurroundings& around,
                          cloud::PointCloud& cloud) const {
  const std::optional<HesaiLayout> layout = layout_of(payload);
  if (!layout) return;
  for (std::size_t column = columns.first; column < std::min<std::size_t>(columns.end, layout->columns()); ++column) {
    const double after_s = 1e-6 * (layout->column_us(column) - layout->column_us(0));
    decode_block(payload, *layout, column, around.time_from_stamp_s + after_s, cloud);
  }
}

std::unique_ptr<PacketDecoder> recognise_hesai(std::string_view payload, const std::string& where) {
  if (const std::optional<HesaiLayout> layout = hesai_layout(payload))
    return std::make_unique<HesaiDecoder>(*layout->model);
  if (const std::string_view unread = unread_hesai(payload); !unread.empty())
    throw Error(ErrorCode::Unsupported, where, say::capture_hesai_unread(std::string(unread)));
  if (Message unknown = unknown_hesai(payload); !unknown.empty())
    throw Error(ErrorCode::Unsupported, where, std::move(unknown));
  return nullptr;
}

}  // namespace

PacketFormat hesai_packets() { return {"hesai", recognise_hesai, nullptr}; }

}  // namespace remount::formats
