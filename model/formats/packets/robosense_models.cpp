#include "model/formats/packets/robosense_models.h"

#include <algorithm>
#include <cmath>

#include "model/formats/files/number_bytes.h"

namespace remount::formats {

namespace {

constexpr double kRs16_us[] = {0.0,  2.8,  5.6,  8.4,  11.2, 14.0, 16.8, 19.6,
                               22.4, 25.2, 28.0, 30.8, 33.6, 36.4, 39.2, 42.0};
constexpr double kRs32_us[] = {0.0,   2.88,  5.76,  8.64,  11.52, 14.4,  17.28, 20.16, 23.04, 25.92, 28.8,
                               31.68, 34.56, 37.44, 40.32, 44.64, 1.44,  4.32,  7.2,   10.08, 12.96, 15.84,
                               18.72, 21.6,  24.48, 27.36, 30.24, 33.12, 36.0,  38.88, 41.76, 46.08};
constexpr double kBpearl_us[] = {0.0,   2.56,  5.12,  7.68,  10.24, 12.8,  15.36, 17.92, 25.68, 28.24, 30.8,
                                 33.36, 35.92, 38.48, 41.04, 43.6,  1.28,  3.84,  6.4,   8.96,  11.52, 14.08,
                                 16.64, 19.2,  26.96, 29.52, 32.08, 34.64, 37.2,  39.76, 42.32, 44.88};
constexpr double kBpearl4_us[] = {0.0,   1.67,  3.34,  5.0,   6.67,  8.34,  10.01, 11.68, 13.34, 15.01, 16.68,
                                  18.35, 20.02, 21.68, 23.35, 25.02, 26.69, 28.36, 30.02, 31.69, 33.36, 35.03,
                                  36.7,  38.36, 40.03, 41.7,  43.37, 45.04, 46.7,  48.37, 50.04, 51.71};
constexpr double kHelios_us[] = {0.0,   1.73,  3.46,  5.19,  6.92,  8.65,  10.38, 12.11, 13.84, 15.57, 17.3,
                                 19.03, 20.76, 22.49, 24.22, 25.95, 27.68, 29.41, 31.14, 32.87, 34.6,  36.33,
                                 38.06, 39.79, 41.52, 43.25, 44.98, 46.71, 48.44, 50.17, 51.9,  53.63};
constexpr double kRs16_deg[] = {-15, -13, -11, -9, -7, -5, -3, -1, 15, 13, 11, 9, 7, 5, 3, 1};

constexpr RobosenseModel kRs16{.name = "RS-LiDAR-16",
                               .lasers = 16,
                               .round_us = 55.5,
                               .firing_us = kRs16_us,
                               .lens_x_m = 0.03825,
                               .spelt_date = true,
                               .nominal_deg = kRs16_deg};
constexpr RobosenseModel kRs32{.name = "RS-LiDAR-32",
                               .round_us = 55.52,
                               .firing_us = kRs32_us,
                               .lens_x_m = 0.03997,
                               .spelt_date = true,
                               .angle_unit_deg = 0.001};
constexpr RobosenseModel kBpearl{.name = "RS-Bpearl",
                                 .round_us = 55.52,
                                 .firing_us = kBpearl_us,
                                 .lens_x_m = 0.01473,
                                 .lens_z_m = 0.09427,
                                 .spelt_date = true};
constexpr RobosenseModel kBpearl4{.name = "RS-Bpearl V4",
                                  .unit_m = 0.0025,
                                  .round_us = 55.56,
                                  .firing_us = kBpearl4_us,
                                  .lens_x_m = 0.01619,
                                  .lens_z_m = 0.09571};
constexpr RobosenseModel kHelios{
    .name = "RS-Helios", .unit_m = 0.0025, .round_us = 55.56, .firing_us = kHelios_us, .lens_x_m = 0.03498};
constexpr RobosenseModel kHelios16{.name = "RS-Helios-16P",
                                   .lasers = 16,
                                   .unit_m = 0.0025,
                                   .round_us = 55.56,
                                   .firing_us = std::span(kHelios_us).first(16),
                                   .lens_x_m = 0.03498};

constexpr std::size_t kDescriptionBytes = 1248, kReturnModeAt = 300, kUpsideDownAt = 337, kElevationsAt = 468,
                      kRs16AnglesAt = 1165, kAngleBytes = 3;

/// A sign and a number, of three bytes. Nothing where it is not set.
std::optional<double> described_deg(std::string_view payload, std::size_t at, double unit_deg) {
  constexpr std::uint8_t kNotSet = 0xff;
  constexpr double kMost_deg = 180.0;
  const std::uint8_t sign = byte_at(payload, at);
  const double angle_deg = unit_deg * network_number<std::uint16_t>(payload, at + 1);
  if (sign == kNotSet || angle_deg > kMost_deg) return std::nullopt;
  return sign == 0 ? angle_deg : -angle_deg;
}

/// The first half of them looks down; in ten thousandths of a degree, without offsets of azimuth.
std::vector<RobosenseLaser> rs16_lasers(std::string_view payload) {
  constexpr double kUnit_deg = 1e-4, kMost_deg = 45.0;
  std::vector<RobosenseLaser> lasers;
  for (std::size_t i = 0; i < kRs16.lasers; ++i) {
    const std::size_t at = kRs16AnglesAt + i * kAngleBytes;
    const double angle_deg =
        kUnit_deg * (65536.0 * byte_at(payload, at) + 256.0 * byte_at(payload, at + 1) + byte_at(payload, at + 2));
    if (angle_deg == 0.0 || angle_deg > kMost_deg) return {};
    lasers.push_back({i < kRs16.lasers / 2 ? -angle_deg : angle_deg, 0.0});
  }
  return lasers;
}

std::vector<RobosenseLaser> described_lasers(const RobosenseModel& model, std::string_view payload) {
  if (&model == &kRs16) return rs16_lasers(payload);
  const std::size_t offsets_at = kElevationsAt + model.layout.described * kAngleBytes;
  std::vector<RobosenseLaser> lasers;
  for (std::size_t i = 0; i < model.lasers; ++i) {
    const auto elevation_deg = described_deg(payload, kElevationsAt + i * kAngleBytes, model.angle_unit_deg);
    const auto offset_deg = described_deg(payload, offsets_at + i * kAngleBytes, model.angle_unit_deg);
    if (!elevation_deg || !offset_deg || std::abs(*elevation_deg) > 90.0) return {};
    lasers.push_back({*elevation_deg, *offset_deg});
  }
  const auto same = [&](const RobosenseLaser& laser) { return laser.elevation_deg == lasers[0].elevation_deg; };
  return std::all_of(lasers.begin(), lasers.end(), same) ? std::vector<RobosenseLaser>() : lasers;
}

}  // namespace

const RobosenseModel* robosense_model(std::string_view payload) {
  if (const RobosenseModel* ruby = robosense_ruby(payload)) return ruby;
  constexpr std::size_t kTypeAt = 31, kModelAt = 32;
  // Older firmware has the type a byte earlier, and says no more.
  const std::uint8_t former = byte_at(payload, kTypeAt - 1);
  const std::uint8_t type = byte_at(payload, kTypeAt) != 0 ? byte_at(payload, kTypeAt) : former;
  const std::uint8_t variant = byte_at(payload, kModelAt);
  switch (type) {
    case 1:
      return &kRs16;
    case 2:
      return &kRs32;
    case 3:
      return variant == 4 ? &kBpearl4 : &kBpearl;
    case 6:
    case 7:
      return variant == 3 ? &kHelios16 : &kHelios;
    default:
      return nullptr;
  }
}

const RobosenseModel* robosense_with_16_lasers(const RobosenseModel& model) {
  return &model == &kHelios ? &kHelios16 : nullptr;
}

bool is_robosense_description(std::string_view payload) {
  constexpr std::string_view kMark("\xa5\xff\x00\x5a\x11\x11\x55\x55", 8);
  return payload.size() == kDescriptionBytes && payload.starts_with(kMark);
}

std::string lasting_robosense_description(std::string_view payload) {
  const std::size_t angles_end = kRs16AnglesAt + kRs16.lasers * kAngleBytes;
  return std::string{payload[kReturnModeAt], payload[kUpsideDownAt]} +
         std::string(payload.substr(kElevationsAt, angles_end - kElevationsAt));
}

bool describes_16_lasers(std::string_view payload) {
  const std::string_view behind = payload.substr(kElevationsAt + 16 * kAngleBytes, 16 * kAngleBytes);
  return behind.find_first_not_of('\0') == std::string_view::npos ||
         behind.find_first_not_of('\xff') == std::string_view::npos;
}

RobosenseDescription read_robosense_description(const RobosenseModel& model, std::string_view payload) {
  RobosenseDescription description;
  description.lasers = described_lasers(model, payload);
  description.two_returns = byte_at(payload, kReturnModeAt) == 0;
  description.backwards = model.lens_z_m > 0.0 && byte_at(payload, kUpsideDownAt) != 0;
  return description;
}

}  // namespace remount::formats
