// RoboSense's sensors that turn: packets of blocks (port 6699), and those in which a sensor describes itself (7788).
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "algorithms/geometry/rotation.h"
#include "messages/captures.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/packets/beam_rings.h"
#include "model/formats/packets/packet_decoder.h"
#include "model/formats/packets/packet_times.h"
#include "model/formats/packets/robosense_mems.h"
#include "model/formats/packets/robosense_models.h"

namespace remount::formats {

namespace {

constexpr std::size_t kLeastHead = 42, kMsopReturnBytes = 3;
constexpr std::uint32_t kMsopTurn = 36000;  // hundredths of a degree
constexpr std::string_view kFormerMark("\x55\xaa\x05\x0a\x5a\xa5\x50\xa0", 8), kMsopMark("\x55\xaa\x05\x5a", 4);

/// Where a return stands; its block begins four bytes before the first.
std::size_t return_at(const MsopLayout& layout, std::size_t block, std::size_t place) {
  return layout.head + block * layout.block_bytes() + 4 + place * kMsopReturnBytes;
}

std::uint32_t block_azimuth(const MsopLayout& layout, std::string_view payload, std::size_t block) {
  return network_number<std::uint16_t>(payload, return_at(layout, block, 0) - 2);
}

bool has_block(const MsopLayout& layout, std::string_view payload, std::size_t block) {
  const std::size_t begins = return_at(layout, block, 0) - 4;
  const std::uint32_t mark =
      layout.mark_bytes == 1 ? byte_at(payload, begins) : network_number<std::uint16_t>(payload, begins);
  return mark == layout.block_mark && block_azimuth(layout, payload, block) < kMsopTurn;
}

struct MsopTime {
  std::int64_t ns = 0;
  SecondPart part = SecondPart::Known;
};

std::optional<MsopTime> msop_time(const RobosenseModel& model, std::string_view payload) {
  const std::size_t at = model.layout.time_at;
  if (!model.spelt_date) {
    const SecondPart coarse = model.counted_nanoseconds ? SecondPart::Either : SecondPart::Known;
    if (const auto time_ns = seconds_and_part_ns(payload, at)) return MsopTime{*time_ns, coarse};
    const auto fine_ns = model.counted_nanoseconds ? seconds_and_part_ns(payload, at, 1) : std::nullopt;
    return fine_ns ? std::optional(MsopTime{*fine_ns, SecondPart::Nanoseconds}) : std::nullopt;
  }
  const auto part = [&](std::size_t i) { return unsigned{byte_at(payload, at + i)}; };
  // A clock that was never set has no month and no day either.
  const auto second_ns = unix_ns(
      {2000 + static_cast<int>(part(0)), std::max(1U, part(1)), std::max(1U, part(2)), part(3), part(4), part(5)});
  const std::uint32_t milliseconds = network_number<std::uint16_t>(payload, at + 6),
                      microseconds = network_number<std::uint16_t>(payload, at + 8);
  if (!second_ns || milliseconds > 999 || microseconds > 999) return std::nullopt;
  return MsopTime{*second_ns + std::int64_t{1'000'000} * milliseconds + kMicrosecond_ns * microseconds};
}

/// Blocks of one azimuth are the returns of one column.
struct MsopColumn {
  std::size_t block = 0, blocks = 1;
  double azimuth = 0.0;  ///< in hundredths of a degree
  double after_us = 0.0;
};

/// Of blocks of one packet.
struct MsopColumns {
  std::vector<MsopColumn> columns;
  double per_us = 0.0;  ///< hundredths of a degree; 0: not known
};

class RobosenseDecoder final : public PacketDecoder {
 public:
  explicit RobosenseDecoder(const RobosenseModel& model) : model_(&model) {
    for (const double elevation_deg : model.nominal_deg) described_.lasers.push_back({elevation_deg, 0.0});
    settle_lasers();
  }

  std::string model() const override { return std::string(model_->name); }
  std::uint32_t places() const override { return kMsopTurn; }
  bool needs_description() const override { return lasers_.empty(); }
  void describe(const std::vector<std::string>& descriptions, const std::string& where) override;
  Message remark() const override {
    return several_      ? say::capture_robosense_several(model())
           : calibrated_ ? Message()
                         : say::capture_robosense_nominal(model());
  }
  std::optional<PacketGlance> glance(std::string_view payload) const override;
  void decode(std::string_view payload, const PacketColumns& columns, const PacketSurroundings& around,
              cloud::PointCloud& cloud) const override;
  void tune(const PacketSequence& packets, const std::string& where) override;

 private:
  struct Laser {
    double cos_elevation = 1.0, sin_elevation = 0.0, offset_rad = 0.0;
    std::uint16_t ring = 0;
  };
  struct Shot {
    std::size_t laser = 0;
    double azimuth_rad = 0.0, time_s = 0.0;
  };

  bool halves() const { return model_->lasers < model_->layout.returns; }  ///< a block is two rounds, or two returns
  double block_us() const { return halves() && !described_.two_returns ? 2 * model_->round_us : model_->round_us; }
  MsopColumns columns_of(std::string_view payload, double otherwise_per_us) const;
  void settle_lasers();
  std::string_view other_half(std::string_view before, const MsopColumns& made) const;
  bool add_return(std::string_view payload, std::size_t at, const Shot& shot, std::uint16_t other,
                  cloud::PointCloud& cloud) const;

  const RobosenseModel* model_;
  RobosenseDescription described_;
  bool calibrated_ = false;  ///< the sensor has said where its lasers look
  bool several_ = false;     ///< and another one of its address something else
  std::vector<Laser> lasers_;
};

void RobosenseDecoder::settle_lasers() {
  const std::vector<RobosenseLaser>& described = described_.lasers;
  std::vector<double> elevations_deg;
  for (const RobosenseLaser& laser : described) elevations_deg.push_back(laser.elevation_deg);
  const std::vector<std::uint16_t> rings = rings_of(elevations_deg);
  lasers_.assign(described.size(), {});
  for (std::size_t i = 0; i < described.size(); ++i) {
    const double elevation_rad = degrees_to_radians(described[i].elevation_deg);
    lasers_[i] = {std::cos(elevation_rad), std::sin(elevation_rad), degrees_to_radians(described[i].azimuth_offset_deg),
                  rings[i]};
  }
}

/// By the first that says where lasers look: a sensor that has just started may not know yet.
void RobosenseDecoder::describe(const std::vector<std::string>& descriptions, const std::string& where) {
  const RobosenseModel *whole = model_, *half = robosense_with_16_lasers(*model_);
  for (const std::string& description : descriptions) {
    const RobosenseModel* model = half != nullptr && describes_16_lasers(description) ? half : whole;
    RobosenseDescription described = read_robosense_description(*model, description);
    several_ = several_ || (calibrated_ && !described.lasers.empty() &&
                            (model != model_ || !described.same_directions(described_)));
    if (calibrated_) continue;
    model_ = model;
    calibrated_ = !described.lasers.empty();
    if (!calibrated_) described.lasers = described_.lasers;
    described_ = std::move(described);
  }
  settle_lasers();
  if (lasers_.empty()) throw Error(ErrorCode::Unsupported, where, say::capture_robosense_angles(model()));
}

MsopColumns RobosenseDecoder::columns_of(std::string_view payload, double otherwise_per_us) const {
  constexpr std::uint32_t kGap = 100;  // a degree: the sensor looks at a part of the turn
  MsopColumns made;
  std::vector<std::uint32_t> steps;
  for (std::size_t block = 0; block < model_->layout.blocks; ++block) {
    const std::uint32_t azimuth = block_azimuth(model_->layout, payload, block);
    const std::uint32_t step =
        block == 0 ? 0 : (azimuth + kMsopTurn - block_azimuth(model_->layout, payload, block - 1)) % kMsopTurn;
    if (block > 0 && step == 0) {
      ++made.columns.back().blocks;
      continue;
    }
    if (block > 0 && step <= kGap) steps.push_back(step);
    made.columns.push_back({block, 1, static_cast<double>(azimuth), static_cast<double>(step)});
  }
  const double turned = std::accumulate(steps.begin(), steps.end(), 0.0);
  made.per_us = steps.empty() ? otherwise_per_us : turned / (static_cast<double>(steps.size()) * block_us());
  double after_us = 0.0;
  for (MsopColumn& column : made.columns) {
    const double step = column.after_us;
    if (step > kGap && made.per_us > 0.0)
      after_us += step / made.per_us;
    else if (column.block > 0)
      after_us += block_us();
    column.after_us = after_us;
  }
  return made;
}

std::optional<PacketGlance> RobosenseDecoder::glance(std::string_view payload) const {
  const MsopLayout& layout = model_->layout;
  if (payload.size() != layout.bytes || !(payload.starts_with(kMsopMark) || payload.starts_with(kFormerMark)))
    return std::nullopt;
  const RobosenseModel* model = robosense_model(payload);
  if (model == nullptr || (model != model_ && robosense_with_16_lasers(*model) != model_)) return std::nullopt;
  for (std::size_t block = 0; block < layout.blocks; ++block)
    if (!has_block(layout, payload, block)) return std::nullopt;
  const auto time = msop_time(*model_, payload);
  if (!time) return std::nullopt;
  PacketGlance glance;
  glance.sensor_time_ns = time->ns;
  glance.second_part = time->part;
  glance.first_place = glance.last_place = block_azimuth(layout, payload, 0);
  // How long a block takes where it has two rounds is known of all packets together: turns then end between packets.
  if (halves() || robosense_with_16_lasers(*model_) != nullptr) return glance;
  const MsopColumns columns = columns_of(payload, 0.0);
  for (std::size_t i = 1; i < columns.columns.size() && glance.cut_column == 0; ++i) {
    if (columns.columns[i].azimuth > columns.columns[i - 1].azimuth - kMsopTurn / 36) continue;
    glance.cut_column = static_cast<std::uint32_t>(i);
    glance.cut_after_ns = static_cast<std::uint32_t>(std::lround(1e3 * columns.columns[i].after_us));
  }
  glance.last_place = static_cast<std::uint32_t>(columns.columns.back().azimuth);
  return glance;
}

/// False where there is none, or the other one again.
bool RobosenseDecoder::add_return(std::string_view payload, std::size_t at, const Shot& shot, std::uint16_t other,
                                  cloud::PointCloud& cloud) const {
  const auto range = network_number<std::uint16_t>(payload, at);
  if (range == 0 || range == other) return false;
  const Laser& laser = lasers_[shot.laser];
  const double sense = described_.backwards ? 1.0 : -1.0;
  const double range_m = range * model_->unit_m, flat_m = range_m * laser.cos_elevation;
  const double aside_rad = shot.azimuth_rad + laser.offset_rad;
  cloud.points.emplace_back(
      static_cast<float>(flat_m * std::cos(aside_rad) + model_->lens_x_m * std::cos(shot.azimuth_rad)),
      static_cast<float>(sense * (flat_m * std::sin(aside_rad) + model_->lens_x_m * std::sin(shot.azimuth_rad))),
      static_cast<float>(range_m * laser.sin_elevation + model_->lens_z_m));
  cloud.intensity.push_back(byte_at(payload, at + 2));
  cloud.ring.push_back(laser.ring);
  cloud.time_from_stamp_s.push_back(static_cast<float>(shot.time_s));
  return true;
}

/// The packet before where its last block has the other returns of the first column here; else empty.
std::string_view RobosenseDecoder::other_half(std::string_view before, const MsopColumns& made) const {
  const MsopLayout& layout = model_->layout;
  if (halves() || before.size() != layout.bytes || layout.blocks % 2 == 0 || made.columns.front().blocks != 1)
    return {};
  const std::uint32_t azimuth = block_azimuth(layout, before, layout.blocks - 1);
  const bool alone = azimuth != block_azimuth(layout, before, layout.blocks - 2);
  return alone && azimuth == static_cast<std::uint32_t>(made.columns.front().azimuth) ? before : std::string_view();
}

void RobosenseDecoder::decode(std::string_view payload, const PacketColumns& range, const PacketSurroundings& around,
                              cloud::PointCloud& cloud) const {
  const MsopLayout& layout = model_->layout;
  if (payload.size() != layout.bytes || lasers_.empty()) return;
  const MsopColumns made = columns_of(payload, 1e-6 * around.places_per_s);
  const std::string_view half = other_half(around.before, made);
  for (std::size_t c = range.first; c < std::min<std::size_t>(range.end, made.columns.size()); ++c) {
    const MsopColumn& column = made.columns[c];
    for (std::size_t place = 0; place < layout.returns; ++place) {
      const bool second_round = place >= model_->lasers && !described_.two_returns;
      const std::size_t laser = place % model_->lasers;
      const double after_us = model_->firing_us[laser] + (second_round ? model_->round_us : 0.0);
      const Shot shot{laser, degrees_to_radians(0.01 * (column.azimuth + after_us * made.per_us)),
                      around.time_from_stamp_s + 1e-6 * (column.after_us + after_us)};
      std::uint16_t other = 0;
      if (c == 0 && !half.empty())
        other = network_number<std::uint16_t>(half, return_at(layout, layout.blocks - 1, place));
      if (place >= model_->lasers && described_.two_returns)
        other = network_number<std::uint16_t>(payload, return_at(layout, column.block, laser));
      for (std::size_t block = column.block; block < column.block + column.blocks; ++block) {
        const std::size_t at = return_at(layout, block, place);
        if (add_return(payload, at, shot, other, cloud)) other = network_number<std::uint16_t>(payload, at);
      }
    }
  }
}

/// Of 16 lasers: how long a block takes tells what its second half is.
void RobosenseDecoder::tune(const PacketSequence& packets, const std::string&) {
  if (!halves() || packets.interval_ns == 0) return;
  const double block_us = 1e-3 * static_cast<double>(packets.interval_ns) / static_cast<double>(model_->layout.blocks);
  described_.two_returns = block_us < 1.5 * model_->round_us;
}

std::unique_ptr<PacketDecoder> recognise_robosense(std::string_view payload, const std::string& where) {
  if (auto decoder = recognise_robosense_mems(payload, where)) return decoder;
  constexpr std::size_t kTypeAt = 30;
  const bool former = payload.starts_with(kFormerMark);
  if (payload.size() < kLeastHead || !(former || payload.starts_with(kMsopMark))) return nullptr;
  const RobosenseModel* model = robosense_model(payload);
  if (payload.size() != (model == nullptr ? MsopLayout().bytes : model->layout.bytes)) return nullptr;
  if (model == nullptr)
    throw Error(ErrorCode::Unsupported, where,
                say::capture_robosense_type(byte_at(payload, kTypeAt), byte_at(payload, kTypeAt + 1)));
  return std::make_unique<RobosenseDecoder>(*model);
}

/// The state of the clock, the receiver's sentence, and the description as a whole.
std::optional<PositionPacket> robosense_position(std::string_view payload) {
  constexpr std::size_t kSyncAt = 302, kTimeAt = 303, kStatusAt = 357, kSentenceAt = 382, kSentenceBytes = 86;
  constexpr std::uint8_t kPulseAndSentence = 3, kSynchronised = 1;
  if (!is_robosense_description(payload)) return std::nullopt;
  PositionPacket position;
  // Seconds since 1970 begin with zeros, where former sensors have the year; these have a status of pulse and
  // sentences.
  const bool spelt_date = network_number<std::uint16_t>(payload, kTimeAt) != 0;
  position.clock_locked = spelt_date ? (byte_at(payload, kStatusAt) & kPulseAndSentence) == kPulseAndSentence
                                     : byte_at(payload, kSyncAt) == kSynchronised;
  position.sentences = position_sentence(payload.substr(kSentenceAt, kSentenceBytes));
  position.description = std::string(payload);
  position.lasting = lasting_robosense_description(payload);
  return position;
}

}  // namespace

PacketFormat robosense_packets() { return {"robosense", recognise_robosense, robosense_position}; }

}  // namespace remount::formats
