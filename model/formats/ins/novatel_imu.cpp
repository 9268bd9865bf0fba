#include "model/formats/ins/novatel_imu.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/median.h"
#include "algorithms/geometry/rotation.h"
#include "messages/ins_logs.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/input_file.h"

namespace remount::formats {
namespace {

constexpr double kFoot_m = 0.3048, kMilliG_mps2 = 9.80665e-3, kDegree_rad = kPi / 180.0,
                 kArcSecond_rad = kDegree_rad / 3600.0;
constexpr double power_of_two(int exponent) {
  double value = 1.0;
  for (; exponent < 0; ++exponent) value /= 2.0;
  return value;
}

/// What one count is.
struct RawImuScale {
  int type;
  std::string_view name;  ///< as logs in ASCII have it
  double turn_rad, speed_mps;
  /// Counts are of rates, not of changes: `turn_rad` and `speed_mps` are then rad/s and m/s^2.
  bool of_rates = false;
};

// OEM7 Commands and Logs Reference Manual, "Raw IMU Scale Factors" and CONNECTIMU; with oem7_imu.cpp of
// novatel_oem7_driver where the manual has products in the place of types.
constexpr double kHoneywell_rad = power_of_two(-33), kHoneywell_mps = power_of_two(-27) * kFoot_m;
constexpr double kKvh_rad = 0.1 / (3600.0 * 256.0), kKvh_mps = 0.05 * power_of_two(-15);
constexpr double kG320_radps = 0.008 * power_of_two(-16) * kDegree_rad,
                 kG320_mps2 = 0.2 * power_of_two(-16) * kMilliG_mps2;
constexpr RawImuScale kRawImuScales[] = {
    {1, "HG1700_AG11", kHoneywell_rad, kHoneywell_mps},
    {4, "HG1700_AG17", kHoneywell_rad, 2.0 * kHoneywell_mps},
    {5, "HG1900_CA29", kHoneywell_rad, kHoneywell_mps},
    {8, "LN200", power_of_two(-19), power_of_two(-14)},
    {11, "HG1700_AG58", kHoneywell_rad, kHoneywell_mps},
    {12, "HG1700_AG62", kHoneywell_rad, 2.0 * kHoneywell_mps},
    {13, "IMAR_FSAS", 0.1 * power_of_two(-8) * kArcSecond_rad, kKvh_mps},
    {16, "KVH_COTS", kKvh_rad, kKvh_mps},
    {20, "HG1930_AA99", kHoneywell_rad, kHoneywell_mps},
    {26, "ISA100C", 1e-9, 2e-8},
    {27, "HG1900_CA50", kHoneywell_rad, kHoneywell_mps},
    {28, "HG1930_CA50", kHoneywell_rad, kHoneywell_mps},
    {31, "ADIS16488", 720.0 * power_of_two(-31) * kDegree_rad, 200.0 * power_of_two(-31)},
    {32, "STIM300", power_of_two(-21) * kDegree_rad, power_of_two(-22)},
    {33, "KVH_1750", kKvh_rad, kKvh_mps},
    {41, "EPSON_G320", kG320_radps, kG320_mps2, true},
    {52, "LITEF_MICROIMU", 1e-9, 2e-8},
    {56, "STIM300D", power_of_two(-21) * kDegree_rad, power_of_two(-22)},
    {58, "HG4930_AN01", kHoneywell_rad, power_of_two(-29)},
    {61, "EPSON_G370", 0.0151515 * power_of_two(-16) * kDegree_rad, 0.4 * power_of_two(-16) * kMilliG_mps2, true},
    {62, "EPSON_G320_200HZ", kG320_radps, kG320_mps2, true},
    {68, "HG4930_AN04", kHoneywell_rad, power_of_two(-29)},
    {69, "HG4930_AN04_400HZ", kHoneywell_rad, power_of_two(-29)}};

const RawImuScale* raw_imu_scale(int type) {
  const auto* found = std::ranges::find(kRawImuScales, type, &RawImuScale::type);
  return found == std::end(kRawImuScales) ? nullptr : found;
}

double median_force_mps2(const std::vector<motion::ImuSample>& samples) {
  std::vector<double> forces;
  forces.reserve(samples.size());
  for (const motion::ImuSample& sample : samples) forces.push_back(sample.specific_force_mps2.norm());
  return median_of(std::move(forces));
}

/// A vehicle feels gravity most of the time, and little else.
constexpr double kFelt_mps2 = 9.81, kOffGravity = 0.15;

}  // namespace

void NovatelImuTypes::add(int type) {
  if (type > 0 && std::ranges::find(types_, type) == types_.end()) types_.push_back(type);
}

void NovatelImuTypes::add(std::string_view type) {
  constexpr std::string_view kPrefix = "IMU_";
  if (type.starts_with(kPrefix)) type.remove_prefix(kPrefix.size());
  if (const auto number = parse_integer(type); number && *number < 256) return add(static_cast<int>(*number));
  const auto* found = std::ranges::find(kRawImuScales, type, &RawImuScale::name);
  if (found != std::end(kRawImuScales)) add(found->type);
}

std::optional<int> NovatelImuTypes::only() const {
  return types_.size() == 1 ? std::optional(types_.front()) : std::nullopt;
}

std::vector<std::string> NovatelImuTypes::names() const {
  std::vector<std::string> names;
  for (const int type : types_) {
    const RawImuScale* scale = raw_imu_scale(type);
    names.push_back(scale == nullptr ? std::to_string(type) : std::string(scale->name));
  }
  return names;
}

Message scale_raw_imu(const NovatelImuTypes& types, const std::string& log, std::vector<motion::ImuSample>& samples) {
  const auto pass_over = [&](Message why) {
    samples.clear();
    return why;
  };
  const std::optional<int> type = types.only();
  if (!type) return pass_over(types.none() ? say::novatel_imu_untyped(log) : say::novatel_imu_several(types.names()));
  const RawImuScale* scale = raw_imu_scale(*type);
  if (scale == nullptr) return pass_over(say::novatel_imu_no_scale(log, types.names().front()));
  // Raw measurements are logged one by one: what lies between two is the time in which counts were gathered.
  const double step_s = drive::median_period_s(samples);
  if (!(step_s > 0.0)) return pass_over(say::novatel_imu_too_few(log));
  const double per_second = scale->of_rates ? 1.0 : 1.0 / step_s;
  for (motion::ImuSample& sample : samples) {
    sample.angular_rate_radps *= scale->turn_rad * per_second;
    sample.specific_force_mps2 *= scale->speed_mps * per_second;
  }
  const double felt_mps2 = median_force_mps2(samples);
  if (std::abs(felt_mps2 / kFelt_mps2 - 1.0) > kOffGravity)
    return pass_over(
        say::novatel_imu_no_gravity(log, std::string(scale->name), Acceleration{felt_mps2}, Acceleration{kFelt_mps2}));
  return {};
}

}  // namespace remount::formats
