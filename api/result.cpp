#include "remount/result.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/calibration/joint/pair_equation.h"
#include "api/bridge.h"
#include "api/result_inside.h"

namespace remount::api {
namespace {

// Statuses and the like are cast: those of the interface have the values of those inside.
template <class Outer, class Inner>
constexpr bool are_alike(std::initializer_list<std::pair<Outer, Inner>> values) {
  return std::ranges::all_of(
      values, [](const auto& two) { return static_cast<int>(two.first) == static_cast<int>(two.second); });
}
using InnerStatus = calibration::Status;
static_assert(are_alike<Status, InnerStatus>({{Status::Ok, InnerStatus::Ok},
                                              {Status::Degenerate, InnerStatus::Degenerate},
                                              {Status::TooFewPairs, InnerStatus::TooFewPairs},
                                              {Status::TooLittleData, InnerStatus::TooLittleData},
                                              {Status::NoUsableData, InnerStatus::NoUsableData},
                                              {Status::NotConverged, InnerStatus::NotConverged},
                                              {Status::OutOfRange, InnerStatus::OutOfRange},
                                              {Status::Inconsistent, InnerStatus::Inconsistent},
                                              {Status::Cancelled, InnerStatus::Cancelled}}));
static_assert(are_alike<PairState, motion::PairState>({{PairState::Proposed, motion::PairState::Proposed},
                                                       {PairState::Accepted, motion::PairState::Accepted},
                                                       {PairState::Rejected, motion::PairState::Rejected}}));
static_assert(are_alike<Parameter, calibration::Parameter>({{Parameter::X, calibration::Parameter::X},
                                                            {Parameter::Y, calibration::Parameter::Y},
                                                            {Parameter::Z, calibration::Parameter::Z},
                                                            {Parameter::Yaw, calibration::Parameter::Yaw},
                                                            {Parameter::Pitch, calibration::Parameter::Pitch},
                                                            {Parameter::Roll, calibration::Parameter::Roll}}));
static_assert(are_alike<Severity, drive::Severity>({{Severity::Note, drive::Severity::Note},
                                                    {Severity::Warning, drive::Severity::Warning},
                                                    {Severity::Problem, drive::Severity::Problem}}));

std::optional<PairMotion> motion_of(const motion::Pair& pair, const calibration::Mounting& mounting) {
  if (!motion::unusable_reason(pair).empty()) return std::nullopt;
  PairMotion out{matrix_of(pair.ins_b_from_ins_a), matrix_of(pair.lidar_b_from_lidar_a), Vector6::Zero()};
  if (mounting.is_of({}))
    out.residual =
        calibration::motion_residual(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, mounting.ins_from_lidar());
  return out;
}

Pair pair_of(const results::PairRecord& record) {
  Pair pair;
  pair.session = record.session;
  pair.stamp_a_ns = record.stamp_a_ns;
  pair.stamp_b_ns = record.stamp_b_ns;
  pair.state = static_cast<PairState>(record.state);
  pair.reason = Text(record.reason);
  pair.rotation_rad = record.rotation_rad;
  pair.baseline_m = record.baseline_m;
  pair.rmse_m = record.rmse_m;
  pair.overlap = record.overlap;
  pair.residual_rotation_rad = record.residual_rotation_rad;
  pair.residual_translation_m = record.residual_translation_m;
  pair.weight = record.weight;
  return pair;
}

}  // namespace

std::string_view to_string(Status status) { return to_string(static_cast<calibration::Status>(status)); }
std::string_view to_string(Parameter parameter) { return to_string(static_cast<calibration::Parameter>(parameter)); }
std::string_view to_string(Severity severity) { return to_string(static_cast<drive::Severity>(severity)); }
std::string_view to_string(PairState state) { return results::to_string(static_cast<motion::PairState>(state)); }

Result::Result(std::shared_ptr<const Inside> inside) : inside_(std::move(inside)) {}

Result Result::load(const std::filesystem::path& path) {
  return guarded([&] {
    const auto inside = std::make_shared<Inside>();
    inside->file = results::load_result(path);
    inside->findings = inside->file.findings;
    return Result(inside);
  });
}

void Result::save(const std::filesystem::path& path) const {
  guarded([&] { results::save_result(inside_->file, path); });
}

const results::ResultFile& Result::file() const { return inside_->file; }
Status Result::status() const { return static_cast<Status>(file().result.status); }
Text Result::message() const { return Text(file().result.message); }
std::vector<Text> Result::advice() const { return texts_of(file().result.advice); }
bool Result::usable() const { return calibration::is_usable(file().result); }
std::string Result::method() const { return file().method; }

Matrix4 Result::ins_from_lidar() const {
  return guarded([&] { return matrix_of(file().result.mounting.ins_from_lidar()); });
}
Matrix4 Result::reference_from_sensor() const { return matrix_of(file().result.mounting.reference_from_sensor); }
std::string Result::reference_frame() const { return std::string(to_string(file().result.mounting.reference)); }
std::string Result::sensor_frame() const { return std::string(to_string(file().result.mounting.sensor)); }
Matrix6 Result::covariance() const { return file().result.covariance; }

Estimate Result::estimate(Parameter parameter) const {
  const calibration::CalibrationResult& result = file().result;
  const calibration::Estimate estimate = result.estimate(static_cast<calibration::Parameter>(parameter));
  return {estimate.value, estimate.sigma, estimate.observed, estimate.measured,
          Text(estimate.observed || !estimate.why_not_observed.empty() ? estimate.why_not_observed : result.message)};
}

std::vector<Pair> Result::pairs() const {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < file().pairs.size(); ++i) {
    pairs.push_back(pair_of(file().pairs[i]));
    if (i < inside_->pairs.size()) pairs.back().motion = motion_of(inside_->pairs[i], file().result.mounting);
  }
  return pairs;
}

std::vector<Keyframe> Result::keyframes() const {
  std::vector<Keyframe> keyframes;
  for (const motion::Keyframe& keyframe : inside_->keyframes)
    keyframes.push_back({keyframe.session, keyframe.scan, keyframe.stamp_ns, keyframe.travelled_m});
  return keyframes;
}

double Result::rotation_rms_rad() const { return file().result.rotation_rms_rad; }
double Result::translation_rms_m() const { return file().result.translation_rms_m; }
TimeOffset Result::time_offset() const {
  const calibration::TimeOffset& offset = file().result.time_offset;
  return {offset.offset_s, offset.sigma_s, offset.applied};
}
std::vector<Finding> Result::findings() const { return findings_of(inside_->findings); }
Settings Result::settings() const { return Settings(file().settings); }

}  // namespace remount::api
