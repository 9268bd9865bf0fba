// Ouster's OS0, OS1, OS2: packets of columns, whose angles stand in metadata beside the capture.
#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/captures.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/packets/beam_rings.h"
#include "model/formats/packets/files_beside.h"
#include "model/formats/packets/ouster_metadata.h"
#include "model/formats/packets/packet_decoder.h"
#include "model/formats/packets/packet_times.h"

namespace remount::formats {

namespace {

/// The sensors' clocks count for centuries; beyond 2100 something else stands there.
constexpr std::uint64_t kLatestColumn_ns = 4'102'444'800'000'000'000;

/// Whether a payload can be what a layout says, by the places and times of its columns: they rise.
bool columns_follow(std::string_view payload, const OusterLayout& layout) {
  constexpr std::uint16_t kMostPlaces = 8192;
  std::uint64_t before_ns = 0;
  std::uint16_t before = 0;
  std::size_t valid = 0;
  for (std::size_t column = 0; column < layout.columns; ++column) {
    if (!layout.column_valid(payload, column)) continue;
    const std::uint64_t time_ns = layout.column_time_ns(payload, column);
    const std::uint16_t place = layout.column_place(payload, column);
    if (place >= kMostPlaces || time_ns == 0 || time_ns > kLatestColumn_ns) return false;
    if (valid > 0 && (place <= before || time_ns <= before_ns)) return false;
    before = place, before_ns = time_ns, ++valid;
  }
  return valid > 1;
}

/// Something as a packet of these sensors is, whatever its profile.
bool is_ouster_packet(std::string_view payload) {
  constexpr std::size_t kColumns[] = {16, 8, 4}, kPixels[] = {16, 32, 64, 128}, kPixelBytes[] = {4, 8, 12, 16, 20};
  const auto follows = [&](const OusterLayout& layout) {
    return payload.size() == layout.packet_bytes() && layout.of_points(payload) && columns_follow(payload, layout);
  };
  for (const std::size_t columns : kColumns)
    for (const std::size_t pixels : kPixels) {
      if (follows({.header = OusterHeader::None, .columns = columns, .pixels = pixels, .pixel_bytes = 12})) return true;
      for (const std::size_t bytes : kPixelBytes)
        if (follows({.header = OusterHeader::Fusa, .columns = columns, .pixels = pixels, .pixel_bytes = bytes}))
          return true;
    }
  return false;
}

class OusterDecoder final : public PacketDecoder {
 public:
  std::string model() const override {
    return metadata_ && !metadata_->product.empty() ? "Ouster " + metadata_->product : "Ouster";
  }
  Message remark() const override {
    const bool other_start =
        metadata_ && metadata_->initialization && initialization_ != 0 && *metadata_->initialization != initialization_;
    return other_start ? say::capture_ouster_other_start(name_beside(metadata_->file)) : Message();
  }
  std::uint32_t places() const override { return metadata_ ? metadata_->columns_per_turn : 1; }
  void look_beside(const BesidePackets& beside, std::string_view payload, const std::string& where) override;
  std::vector<SourceBeside> sources_beside() const override {
    if (!metadata_) return {};
    return {{metadata_->file, said_, ".json", own_metadata_}};
  }
  std::optional<PacketGlance> glance(std::string_view payload) const override;
  void decode(std::string_view payload, const PacketColumns& columns, const PacketSurroundings& around,
              cloud::PointCloud& cloud) const override;
  void tune(const PacketSequence& packets, const std::string& where) override;

 private:
  struct Beam {
    double cos_elevation = 1.0, sin_elevation = 0.0, cos_azimuth = 1.0, sin_azimuth = 0.0;
    std::uint16_t ring = 0;
  };

  bool is_whole(std::string_view payload) const;
  bool has_place(std::string_view payload, std::size_t column) const;
  std::size_t first_column(std::string_view payload) const;
  void decode_column(std::string_view payload, std::size_t column, double time_s, cloud::PointCloud& cloud) const;
  std::uint32_t range_mm(std::string_view payload, std::size_t pixel_at, const OusterReturn& of) const;

  std::optional<OusterMetadata> metadata_;
  bool said_ = false;          ///< they are no file beside the packets, but come with them
  bool own_metadata_ = false;  ///< the serial number in it is that in the packets
  std::vector<Beam> beams_;
  std::uint32_t initialization_ = 0;  ///< of the sensor's start that the packets are of; 0: they do not say
  double origin_m_ = 0.0;             ///< from the middle of the head to where beams begin
};

void OusterDecoder::look_beside(const BesidePackets& beside, std::string_view payload, const std::string& where) {
  const OusterLayout standard{.header = OusterHeader::Standard}, fusa{.header = OusterHeader::Fusa};
  metadata_ = find_ouster_metadata(beside,
                                   {.packet_bytes = payload.size(),
                                    .serial = standard.serial(payload),
                                    .fusa_serial = fusa.serial(payload),
                                    .initialization = standard.initialization(payload),
                                    .fusa_initialization = fusa.initialization(payload)},
                                   where);
  said_ = beside.said_on(metadata_->file) != nullptr;
  const std::uint64_t serial = metadata_->layout.serial(payload);
  own_metadata_ = serial != 0 && metadata_->serial == serial;
  initialization_ = metadata_->layout.header == OusterHeader::None ? 0 : metadata_->layout.initialization(payload);
  const std::vector<double>& elevations = metadata_->elevations_rad;
  const std::vector<std::uint16_t> rings = rings_of(elevations);
  beams_.resize(elevations.size());
  for (std::size_t pixel = 0; pixel < beams_.size(); ++pixel) {
    const double elevation_rad = elevations[pixel], azimuth_rad = metadata_->azimuths_rad[pixel];
    beams_[pixel] = {std::cos(elevation_rad), std::sin(elevation_rad), std::cos(azimuth_rad), std::sin(azimuth_rad),
                     rings[pixel]};
  }
  origin_m_ = metadata_->beams_above_m == 0.0 ? metadata_->beams_ahead_m
                                              : std::hypot(metadata_->beams_ahead_m, metadata_->beams_above_m);
}

bool OusterDecoder::is_whole(std::string_view payload) const {
  if (!metadata_ || payload.size() != metadata_->layout.packet_bytes() || !metadata_->layout.of_points(payload))
    return false;
  const std::uint64_t serial = metadata_->layout.serial(payload);
  return serial == 0 || !metadata_->serial || serial == *metadata_->serial;
}

bool OusterDecoder::has_place(std::string_view payload, std::size_t column) const {
  const std::uint64_t time_ns = metadata_->layout.column_time_ns(payload, column);
  return metadata_->layout.column_place(payload, column) < metadata_->columns_per_turn && time_ns != 0 &&
         time_ns <= kLatestColumn_ns;
}

/// The first that was measured; where none was (beside the window), the first that says where it stands. As many as
/// there are columns: none.
std::size_t OusterDecoder::first_column(std::string_view payload) const {
  const OusterLayout& layout = metadata_->layout;
  std::size_t placed = layout.columns;
  for (std::size_t column = 0; column < layout.columns; ++column) {
    if (!has_place(payload, column)) continue;
    if (layout.column_valid(payload, column)) return column;
    placed = std::min(placed, column);
  }
  return placed;
}

std::optional<PacketGlance> OusterDecoder::glance(std::string_view payload) const {
  if (!is_whole(payload)) return std::nullopt;
  const OusterLayout& layout = metadata_->layout;
  const std::size_t first = first_column(payload);
  if (first == layout.columns) return std::nullopt;
  constexpr std::uint32_t kMostFrames = 0x7fffffff;
  PacketGlance glance;
  glance.sensor_time_ns = static_cast<std::int64_t>(layout.column_time_ns(payload, first));
  glance.first_place = glance.last_place = layout.column_place(payload, first);
  for (std::size_t column = first + 1; column < layout.columns; ++column)
    if (layout.column_valid(payload, column) && has_place(payload, column))
      glance.last_place = layout.column_place(payload, column);
  glance.frame = 1 + (layout.frame(payload) & kMostFrames);
  glance.clock_follows = metadata_->clock_follows && has_date(glance.sensor_time_ns);
  return glance;
}

std::uint32_t OusterDecoder::range_mm(std::string_view payload, std::size_t pixel_at, const OusterReturn& of) const {
  const std::size_t at = pixel_at + of.range_at;
  // Ranges of 15 bits stand in two bytes, which are the last of the packet where it has no footer.
  const std::uint32_t bits =
      of.range_bits <= 16 ? little_number<std::uint16_t>(payload, at) : little_number<std::uint32_t>(payload, at);
  return (bits & ((std::uint32_t{1} << of.range_bits) - 1U)) * of.unit_mm;
}

void OusterDecoder::decode_column(std::string_view payload, std::size_t column, double time_s,
                                  cloud::PointCloud& cloud) const {
  const OusterLayout& layout = metadata_->layout;
  const OusterProfile& profile = *metadata_->profile;
  // The encoder counts clockwise, and so do the azimuths of beams.
  const double encoder_rad = -2.0 * kPi * layout.column_place(payload, column) / metadata_->columns_per_turn;
  const double cos_encoder = std::cos(encoder_rad), sin_encoder = std::sin(encoder_rad);
  const Eigen::Vector3d begin(metadata_->beams_ahead_m * cos_encoder, metadata_->beams_ahead_m * sin_encoder,
                              metadata_->beams_above_m);
  for (std::size_t pixel = 0; pixel < beams_.size(); ++pixel) {
    const Beam& beam = beams_[pixel];
    const Eigen::Vector3d direction(
        beam.cos_elevation * (cos_encoder * beam.cos_azimuth + sin_encoder * beam.sin_azimuth),
        beam.cos_elevation * (sin_encoder * beam.cos_azimuth - cos_encoder * beam.sin_azimuth), beam.sin_elevation);
    const std::size_t at = layout.pixel_at(column, pixel);
    std::uint32_t other_mm = 0;
    for (int which = 0; which < profile.returns; ++which) {
      const OusterReturn& of = which == 0 ? profile.first : profile.second;
      const std::uint32_t range = range_mm(payload, at, of);
      if (range == 0 || range == other_mm) continue;
      other_mm = range;
      // Ranges count from the middle of the head, as if beams began there.
      const Eigen::Vector3d point_in_lidar = (1e-3 * range - origin_m_) * direction + begin;
      cloud.points.push_back((metadata_->sensor_from_lidar * point_in_lidar).cast<float>());
      cloud.intensity.push_back(byte_at(payload, at + of.reflectivity_at));
      cloud.ring.push_back(beam.ring);
      cloud.time_from_stamp_s.push_back(static_cast<float>(time_s));
    }
  }
}

void OusterDecoder::decode(std::string_view payload, const PacketColumns& columns, const PacketSurroundings& around,
                           cloud::PointCloud& cloud) const {
  constexpr double kLongestPacket_s = 0.1;  // a column that lies farther from the first has no time
  if (!is_whole(payload)) return;
  const OusterLayout& layout = metadata_->layout;
  const std::size_t first = first_column(payload);
  if (first == layout.columns) return;
  const auto begins_ns = static_cast<std::int64_t>(layout.column_time_ns(payload, first));
  for (std::size_t column = columns.first; column < std::min<std::size_t>(columns.end, layout.columns); ++column) {
    if (!layout.column_valid(payload, column) || !has_place(payload, column)) continue;
    const double after_s =
        1e-9 * static_cast<double>(static_cast<std::int64_t>(layout.column_time_ns(payload, column)) - begins_ns);
    if (std::abs(after_s) < kLongestPacket_s) decode_column(payload, column, around.time_from_stamp_s + after_s, cloud);
  }
}

/// Metadata of another mode give every column a direction of its own, only a wrong one.
void OusterDecoder::tune(const PacketSequence& packets, const std::string& where) {
  constexpr double kMostOff = 0.2;  // no two modes are nearer, and the head turns more evenly
  if (!metadata_ || packets.places_in_turn <= 0.0) return;
  if (std::abs(packets.places_in_turn / metadata_->columns_per_turn - 1.0) > kMostOff)
    throw Error(ErrorCode::Unsupported, where,
                say::capture_ouster_columns(name_beside(metadata_->file), metadata_->columns_per_turn,
                                            std::llround(packets.places_in_turn)));
}

std::unique_ptr<PacketDecoder> recognise_ouster(std::string_view payload, const std::string&) {
  return is_ouster_packet(payload) ? std::make_unique<OusterDecoder>() : nullptr;
}

}  // namespace

PacketFormat ouster_packets() { return {"ouster", recognise_ouster, nullptr}; }

}  // namespace remount::formats
