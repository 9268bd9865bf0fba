#include "model/formats/ins/sbf_blocks.h"

#include <GeographicLib/Geocentric.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/bags.h"
#include "messages/ins_logs.h"
#include "model/drive/attitude_convention.h"
#include "model/drive/plausible_values.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {
namespace {

constexpr std::size_t kSbfHeaderBytes = 8, kSbfCrcFrom = 4, kSbfTimeBytes = 14;

struct SbfName {
  std::uint16_t id;
  std::string_view name;
};
constexpr SbfName kSbfNames[] = {{4007, "PVTGeodetic"},
                                 {4225, "INSNavCart"},
                                 {4226, "INSNavGeod"},
                                 {5906, "PosCovGeodetic"},
                                 {5938, "AttEuler"},
                                 {5939, "AttCovEuler"},
                                 {4006, "PVTCartesian"},
                                 {5905, "PosCovCartesian"},
                                 {5907, "VelCovCartesian"},
                                 {5908, "VelCovGeodetic"},
                                 {4001, "DOP"},
                                 {4013, "ChannelStatus"},
                                 {4014, "ReceiverStatus"},
                                 {4027, "MeasEpoch"},
                                 {4050, "ExtSensorMeas"},
                                 {4229, "ExtEventINSNavCart"},
                                 {4230, "ExtEventINSNavGeod"},
                                 {4224, "IMUSetup"},
                                 {4244, "VelSensorSetup"},
                                 {5902, "ReceiverSetup"},
                                 {5914, "ReceiverTime"},
                                 {5921, "EndOfPVT"},
                                 {5924, "ExtEvent"},
                                 {5943, "EndOfAtt"}};

bool is_used(std::uint16_t id) {
  constexpr std::array kUsed{SbfId::PvtGeodetic,    SbfId::InsNavCart, SbfId::InsNavGeod,
                             SbfId::PosCovGeodetic, SbfId::AttEuler,   SbfId::AttCovEuler};
  return std::ranges::find(kUsed, static_cast<SbfId>(id)) != kUsed.end();
}

constexpr std::array<std::uint16_t, 256> ccitt_table() {
  std::array<std::uint16_t, 256> table{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    unsigned rest = byte << 8U;
    for (int bit = 0; bit < 8; ++bit) rest = (rest & 0x8000U) != 0 ? rest << 1U ^ 0x1021U : rest << 1U;
    table[byte] = static_cast<std::uint16_t>(rest);
  }
  return table;
}
constexpr std::array<std::uint16_t, 256> kCcitt = ccitt_table();

[[noreturn]] void fail_sbf(const std::string& where, Message what) {
  throw Error(ErrorCode::Format, where, std::move(what));
}

void require_bytes(const SbfBlock& block, std::size_t bytes, const std::string& where) {
  if (block.bytes.size() < bytes) fail_sbf(where, say::novatel_body_bytes(Bytes{block.bytes.size()}, Bytes{bytes}));
}

/// NaN where it is marked as not there.
double sbf_value(double value) { return drive::means_not_known(value) ? std::nan("") : value; }
double float_at(const SbfBlock& block, std::size_t at) {
  return sbf_value(double{little_number<float>(block.bytes, at)});
}
double double_at(const SbfBlock& block, std::size_t at) { return sbf_value(little_number<double>(block.bytes, at)); }
int sbf_byte(const SbfBlock& block, std::size_t at) { return byte_at(block.bytes, at); }

double stated_sigma(double sigma) { return sigma > 0.0 && !drive::means_not_known(sigma) ? sigma : std::nan(""); }

/// Of the earth-centred axes.
struct CartesianPlace {
  Eigen::Vector3d xyz_m;
  Eigen::Matrix3d covariance_xyz_m2;
};

void take_cartesian(const CartesianPlace& place, InsNavValues& values, const std::string& where) {
  constexpr double kFarthest_m = 1e8;
  if (!(place.xyz_m.cwiseAbs().maxCoeff() < kFarthest_m)) fail_sbf(where, say::log_place_impossible());
  double latitude_deg = 0.0, longitude_deg = 0.0;
  std::vector<double> rows(9);
  GeographicLib::Geocentric::WGS84().Reverse(place.xyz_m.x(), place.xyz_m.y(), place.xyz_m.z(), latitude_deg,
                                             longitude_deg, values.height_m, rows);
  values.latitude_rad = degrees_to_radians(latitude_deg);
  values.longitude_rad = degrees_to_radians(longitude_deg);
  const Eigen::Matrix3d xyz_from_enu = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rows.data());
  values.position_sigma_enu_m =
      (xyz_from_enu.transpose() * place.covariance_xyz_m2 * xyz_from_enu).diagonal().cwiseSqrt();
}

constexpr unsigned kPositionSigmas = 0, kAttitude = 1, kAttitudeSigmas = 2, kPositionCovariances = 5;

/// Where each sub-block of an INSNav block begins: they follow each other in the order of their bits. 0: not there.
std::array<std::size_t, 8> sub_blocks(const SbfBlock& block, std::size_t list_at, const std::string& where) {
  constexpr std::size_t kSubBlockBytes = 12;
  require_bytes(block, list_at + 2, where);
  const unsigned list = little_number<std::uint16_t>(block.bytes, list_at);
  std::array<std::size_t, 8> places{};
  std::size_t next = list_at + 2;
  for (std::size_t bit = 0; bit < places.size(); ++bit) {
    if ((list >> bit & 1U) == 0) continue;
    require_bytes(block, next + kSubBlockBytes, where);
    places[bit] = next;
    next += kSubBlockBytes;
  }
  return places;
}

Eigen::Vector3d three_floats(const SbfBlock& block, std::size_t at) {
  if (at == 0) return Eigen::Vector3d::Constant(std::nan(""));
  return {float_at(block, at), float_at(block, at + 4), float_at(block, at + 8)};
}

}  // namespace

std::uint16_t sbf_crc16(std::string_view bytes) {
  unsigned crc = 0;
  for (const char byte : bytes)
    crc = (crc << 8U & 0xFFFFU) ^ kCcitt[(crc >> 8U ^ static_cast<unsigned char>(byte)) & 0xFFU];
  return static_cast<std::uint16_t>(crc);
}

std::string sbf_name(std::uint16_t id) {
  const auto* found = std::ranges::find(kSbfNames, id, &SbfName::id);
  return found == std::end(kSbfNames) ? "block " + std::to_string(id) : std::string(found->name);
}

bool SbfScanner::next(SbfBlock& block) {
  for (std::size_t at = recording_.find("$@", next_); at != std::string_view::npos; at = recording_.find("$@", at + 1))
    if (block_at(at, block)) return true;
  next_ = recording_.size();
  return false;
}

bool SbfScanner::block_at(std::size_t at, SbfBlock& block) {
  const std::string_view rest = recording_.substr(at);
  if (rest.size() < kSbfHeaderBytes) return false;
  const unsigned number = little_number<std::uint16_t>(rest, 4);
  const std::size_t length = little_number<std::uint16_t>(rest, 6);
  if (length < kSbfHeaderBytes || length % 4 != 0) return false;
  block = {static_cast<std::uint16_t>(number & 0x1FFFU), number >> 13U, {}, at};
  // A length that is made up costs as many bytes of a checksum: blocks that are used are short.
  constexpr std::size_t kLongestUsed = 512;
  const bool used = is_used(block.id);
  if (used ? length > kLongestUsed : in_vain_ > 4 * recording_.size()) return false;
  const bool whole = length <= rest.size();
  if (!whole || little_number<std::uint16_t>(rest, 2) != sbf_crc16(rest.substr(kSbfCrcFrom, length - kSbfCrcFrom))) {
    in_vain_ += whole ? length : 0;
    broken_ += used;
    return false;
  }
  block.bytes = rest.substr(0, length);
  next_ = at + length;
  return true;
}

motion::InsSample ins_nav_sample(const InsNavValues& values, const std::string& where) {
  if (drive::angle_means_not_known(values.heading_deg) || !std::isfinite(values.heading_deg))
    fail_sbf(where, say::ncom_no_attitude());
  if (!drive::plausible_geodetic(values.latitude_rad, values.longitude_rad, values.height_m))
    fail_sbf(where, say::log_place_impossible());
  const drive::AttitudeAngles angles{degrees_to_radians(values.heading_deg), degrees_to_radians(values.pitch_deg),
                                     degrees_to_radians(values.roll_deg)};
  if (!(std::abs(angles.yaw_rad) <= 4.0 * kPi && std::abs(angles.pitch_rad) <= kPi &&
        std::abs(angles.roll_rad) <= 4.0 * kPi))
    fail_sbf(where, say::log_angles_impossible());
  motion::InsSample sample;
  sample.latitude_rad = values.latitude_rad;
  sample.longitude_rad = values.longitude_rad;
  sample.height_m = values.height_m;
  sample.enu_from_ins = drive::enu_from_ins(angles, drive::AttitudeConvention::Heading);
  sample.sigma.position_enu_m = values.position_sigma_enu_m.unaryExpr(&stated_sigma);
  sample.sigma.attitude_rad = drive::axis_sigma_rad({degrees_to_radians(stated_sigma(values.heading_sigma_deg)),
                                                     degrees_to_radians(stated_sigma(values.pitch_sigma_deg)),
                                                     degrees_to_radians(stated_sigma(values.roll_sigma_deg))},
                                                    drive::AttitudeConvention::Heading);
  sample.quality = values.error != 0  ? motion::InsQuality::Invalid
                   : values.mode == 0 ? motion::InsQuality::Degraded  // of the IMU alone
                                      : motion::InsQuality::Good;
  return sample;
}

std::int64_t sbf_stamp_ns(const SbfBlock& block, const std::string& where) {
  require_bytes(block, kSbfTimeBytes, where);
  const auto stamp = unix_ns_from_gps_week(little_number<std::uint16_t>(block.bytes, 12),
                                           std::int64_t{little_number<std::uint32_t>(block.bytes, 8)} * 1'000'000);
  if (!stamp) fail_sbf(where, say::bag_gps_time());
  return *stamp;
}

InsNavValues ins_nav_values(const SbfBlock& block, const std::string& where) {
  const bool cartesian = block.id == static_cast<std::uint16_t>(SbfId::InsNavCart);
  const std::array<std::size_t, 8> there = sub_blocks(block, cartesian ? 50 : 54, where);
  InsNavValues values;
  values.mode = sbf_byte(block, 14) & 0xF;
  values.error = sbf_byte(block, 15);
  const Eigen::Vector3d position{double_at(block, 20), double_at(block, 28), double_at(block, 36)},
      sigmas = three_floats(block, there[kPositionSigmas]),
      covariances = three_floats(block, there[kPositionCovariances]), angles = three_floats(block, there[kAttitude]),
      angle_sigmas = three_floats(block, there[kAttitudeSigmas]);
  values.heading_deg = angles.x(), values.pitch_deg = angles.y(), values.roll_deg = angles.z();
  values.heading_sigma_deg = angle_sigmas.x(), values.pitch_sigma_deg = angle_sigmas.y();
  values.roll_sigma_deg = angle_sigmas.z();
  if (!cartesian) {
    values.latitude_rad = position.x(), values.longitude_rad = position.y(), values.height_m = position.z();
    values.position_sigma_enu_m = {sigmas.y(), sigmas.x(), sigmas.z()};
    return values;
  }
  if (!position.allFinite()) {
    values.latitude_rad = values.longitude_rad = values.height_m = std::nan("");
    return values;
  }
  // Errors of positions along the axes of the earth have much in common: without it nothing is known of the height's.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Constant(std::nan(""));
  if (covariances.allFinite()) {
    covariance.diagonal() = sigmas.cwiseAbs2();
    covariance(0, 1) = covariance(1, 0) = covariances.x();
    covariance(0, 2) = covariance(2, 0) = covariances.y();
    covariance(1, 2) = covariance(2, 1) = covariances.z();
  }
  take_cartesian({position, covariance}, values, where);
  return values;
}

bool is_without_solution(const InsNavValues& values) {
  return values.error != 0 && !std::isfinite(values.latitude_rad + values.longitude_rad + values.height_m);
}

SbfFix sbf_fix(const SbfBlock& block, const std::string& where) {
  constexpr std::size_t kBytes = 85, kWithAccuracy = 95;
  constexpr int kStandAlone = 1, kFixed = 4;
  constexpr std::uint16_t kNoAccuracy = 65'535;
  require_bytes(block, kBytes, where);
  SbfFix out;
  const int mode = sbf_byte(block, 14) & 0xF;
  out.solved = mode != 0 && sbf_byte(block, 15) == 0;
  out.quality = mode == kFixed        ? motion::InsQuality::Good
                : mode >= kStandAlone ? motion::InsQuality::Degraded
                                      : motion::InsQuality::Invalid;
  out.fix.stamp_ns = sbf_stamp_ns(block, where);
  out.fix.latitude_rad = double_at(block, 16);
  out.fix.longitude_rad = double_at(block, 24);
  out.fix.height_m = double_at(block, 32);
  if (out.solved && !drive::plausible_geodetic(out.fix.latitude_rad, out.fix.longitude_rad, out.fix.height_m))
    fail_sbf(where, say::log_place_impossible());
  out.fix.covariance_enu_m2.setConstant(std::nan(""));
  if (block.revision < 2 || block.bytes.size() < kWithAccuracy) return out;
  const auto horizontal = little_number<std::uint16_t>(block.bytes, 90),
             vertical = little_number<std::uint16_t>(block.bytes, 92);
  if (horizontal == kNoAccuracy || vertical == kNoAccuracy || horizontal == 0 || vertical == 0) return out;
  // Centimetres, twice the root mean square of both horizontal errors, and of the vertical one.
  const double each_m = 0.005 * horizontal / std::sqrt(2.0), up_m = 0.005 * vertical;
  out.fix.covariance_enu_m2 = Eigen::Vector3d(each_m, each_m, up_m).cwiseAbs2().asDiagonal();
  return out;
}

SbfCovariance sbf_covariance(const SbfBlock& block, const std::string& where) {
  constexpr std::size_t kBytes = 56;
  require_bytes(block, kBytes, where);
  SbfCovariance out;
  out.stamp_ns = sbf_stamp_ns(block, where);
  const double north = float_at(block, 16), east = float_at(block, 20), up = float_at(block, 24),
               north_east = float_at(block, 32), north_up = float_at(block, 36), east_up = float_at(block, 44);
  out.enu_m2 << east, north_east, east_up, north_east, north, north_up, east_up, north_up, up;
  if (sbf_byte(block, 15) != 0) out.enu_m2.setConstant(std::nan(""));
  return out;
}

SbfAttitude sbf_attitude(const SbfBlock& block, const std::string& where) {
  const bool angles = block.id == static_cast<std::uint16_t>(SbfId::AttEuler);
  const std::size_t at = angles ? 20 : 16;
  require_bytes(block, at + 12, where);
  SbfAttitude out{sbf_stamp_ns(block, where), float_at(block, at), float_at(block, at + 4), float_at(block, at + 8)};
  if (angles) {
    constexpr int kFloatWithRoll = 3;
    const int mode = little_number<std::uint16_t>(block.bytes, 16);
    if (mode < kFloatWithRoll) out.roll_deg = std::nan("");  // it is 0 there, and not measured
    out.fixed = mode % 2 == 0;
    return out;
  }
  for (double* sigma_deg : {&out.heading_deg, &out.pitch_deg, &out.roll_deg})
    *sigma_deg = *sigma_deg > 0.0 ? std::sqrt(*sigma_deg) : std::nan("");
  return out;
}

}  // namespace remount::formats
