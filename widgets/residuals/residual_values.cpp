#include "widgets/residuals/residual_values.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/core/stamps.h"
#include "model/method_registry/calibration_method.h"
#include "widgets/pairs/pair_measure.h"

namespace remount::widgets {
namespace {

struct ResidualText {
  Q_DECLARE_TR_FUNCTIONS(remount::widgets::residual_values)
};

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Which of the six numbers of a residual it is; -1: none.
int component_of(ResidualMeasure measure) {
  const bool is_one = measure >= ResidualMeasure::X && measure <= ResidualMeasure::Yaw;
  return is_one ? static_cast<int>(measure) - static_cast<int>(ResidualMeasure::X) : -1;
}

std::vector<double> components_of(const pipeline::PipelineOutput& output, int component) {
  std::vector<double> values(output.pairs.size(), kUnknown);
  const calibration::Mounting& mounting = output.result.mounting;
  if (!calibration::is_usable(output.result) || !mounting.is_of({}) || !method_registry::is_from_pairs(output.method))
    return values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const motion::Pair& pair = output.pairs[i];
    if (!is_aligned(pair)) continue;
    const double value = calibration::motion_residual(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a,
                                                      mounting.reference_from_sensor)[component];
    values[i] = component < 3 ? 100.0 * value : radians_to_degrees(value);
  }
  return values;
}

double norm_of(const motion::Pair& pair, ResidualMeasure measure) {
  switch (measure) {
    case ResidualMeasure::Translation:
      return measured(pair, PairMeasure::ResidualTranslation).value_or(kUnknown);
    case ResidualMeasure::Rotation:
      return measured(pair, PairMeasure::ResidualRotation).value_or(kUnknown);
    case ResidualMeasure::Rmse:
      return measured(pair, PairMeasure::Rmse).value_or(kUnknown);
    default:
      return is_aligned(pair) || pair.registration.overlap > 0.0 ? 100.0 * pair.registration.overlap : kUnknown;
  }
}

/// Of each session, the stamp of its first keyframe.
std::vector<std::int64_t> first_stamps_ns(const std::vector<motion::Keyframe>& keyframes) {
  std::vector<std::int64_t> starts;
  for (const motion::Keyframe& keyframe : keyframes) {
    if (starts.size() <= keyframe.session)
      starts.resize(keyframe.session + 1, std::numeric_limits<std::int64_t>::max());
    starts[keyframe.session] = std::min(starts[keyframe.session], keyframe.stamp_ns);
  }
  return starts;
}

std::vector<double> strips_of_sessions(const pipeline::PipelineOutput& output) {
  constexpr double kWidth = 0.6;  // the rest parts the strips
  std::vector<std::size_t> counts;
  const auto session_of = [&](std::size_t pair) -> std::size_t {
    return output.keyframes[output.pairs[pair].keyframe_a].session;
  };
  for (std::size_t i = 0; i < output.pairs.size(); ++i) {
    if (counts.size() <= session_of(i)) counts.resize(session_of(i) + 1, 0);
    ++counts[session_of(i)];
  }
  std::vector<std::size_t> seen(counts.size(), 0);
  std::vector<double> values;
  for (std::size_t i = 0; i < output.pairs.size(); ++i) {
    const std::size_t session = session_of(i);
    const double share = (static_cast<double>(seen[session]++) + 0.5) / static_cast<double>(counts[session]);
    values.push_back(static_cast<double>(session) + 1.0 + kWidth * (share - 0.5));
  }
  return values;
}

/// Of one pair, but for its session.
double circumstance_of(const motion::Pair& pair, const motion::Keyframe& a, const motion::Keyframe& b,
                       PairCircumstance circumstance, const std::vector<std::int64_t>& starts_ns) {
  const double gap_s = std::abs(pair.gap_s);
  switch (circumstance) {
    case PairCircumstance::Time:
      return 0.5 * (seconds(a.stamp_ns - starts_ns[a.session]) + seconds(b.stamp_ns - starts_ns[b.session]));
    case PairCircumstance::Speed:
      return gap_s > 0.0 ? std::abs(b.travelled_m - a.travelled_m) / gap_s : kUnknown;
    case PairCircumstance::TurnRate:
      return gap_s > 0.0 ? radians_to_degrees(pair.rotation_rad) / gap_s : kUnknown;
    case PairCircumstance::Gap:
      return gap_s;
    case PairCircumstance::Baseline:
      return pair.baseline_m;
    case PairCircumstance::Rotation:
      return radians_to_degrees(pair.rotation_rad);
    case PairCircumstance::Session:
      break;
  }
  return kUnknown;
}

}  // namespace

std::vector<double> values_of(const pipeline::PipelineOutput& output, ResidualMeasure measure) {
  if (const int component = component_of(measure); component >= 0) return components_of(output, component);
  std::vector<double> values;
  values.reserve(output.pairs.size());
  for (const motion::Pair& pair : output.pairs) values.push_back(norm_of(pair, measure));
  return values;
}

std::vector<double> values_of(const pipeline::PipelineOutput& output, PairCircumstance circumstance) {
  if (circumstance == PairCircumstance::Session) return strips_of_sessions(output);
  const std::vector<std::int64_t> starts_ns = first_stamps_ns(output.keyframes);
  std::vector<double> values;
  values.reserve(output.pairs.size());
  for (const motion::Pair& pair : output.pairs)
    values.push_back(circumstance_of(pair, output.keyframes[pair.keyframe_a], output.keyframes[pair.keyframe_b],
                                     circumstance, starts_ns));
  return values;
}

QString name_of(ResidualMeasure measure) {
  switch (measure) {
    case ResidualMeasure::Translation:
      return measure_name(PairMeasure::ResidualTranslation);
    case ResidualMeasure::Rotation:
      return measure_name(PairMeasure::ResidualRotation);
    case ResidualMeasure::X:
      return ResidualText::tr("Residual x");
    case ResidualMeasure::Y:
      return ResidualText::tr("Residual y");
    case ResidualMeasure::Z:
      return ResidualText::tr("Residual z");
    case ResidualMeasure::Roll:
      return ResidualText::tr("Residual roll");
    case ResidualMeasure::Pitch:
      return ResidualText::tr("Residual pitch");
    case ResidualMeasure::Yaw:
      return ResidualText::tr("Residual yaw");
    case ResidualMeasure::Rmse:
      return measure_name(PairMeasure::Rmse);
    case ResidualMeasure::Overlap:
      return ResidualText::tr("Overlap of the scans");
  }
  return {};
}

QString name_of(PairCircumstance circumstance) {
  switch (circumstance) {
    case PairCircumstance::Time:
      return ResidualText::tr("Time in the session");
    case PairCircumstance::Speed:
      return ResidualText::tr("Speed");
    case PairCircumstance::TurnRate:
      return ResidualText::tr("Turn rate");
    case PairCircumstance::Gap:
      return ResidualText::tr("Time between the scans");
    case PairCircumstance::Baseline:
      return ResidualText::tr("Distance between the scans");
    case PairCircumstance::Rotation:
      return ResidualText::tr("Rotation between the scans");
    case PairCircumstance::Session:
      return ResidualText::tr("Session");
  }
  return {};
}

QString unit_of(ResidualMeasure measure) {
  const int component = component_of(measure);
  if (component >= 0) return component < 3 ? QStringLiteral("cm") : QStringLiteral("°");
  if (measure == ResidualMeasure::Overlap) return QStringLiteral("%");
  return measure == ResidualMeasure::Rotation ? QStringLiteral("°") : QStringLiteral("cm");
}

QString unit_of(PairCircumstance circumstance) {
  switch (circumstance) {
    case PairCircumstance::Time:
    case PairCircumstance::Gap:
      return QStringLiteral("s");
    case PairCircumstance::Speed:
      return QStringLiteral("m/s");
    case PairCircumstance::TurnRate:
      return QStringLiteral("°/s");
    case PairCircumstance::Baseline:
      return QStringLiteral("m");
    case PairCircumstance::Rotation:
      return QStringLiteral("°");
    case PairCircumstance::Session:
      break;
  }
  return {};
}

bool has_sign(ResidualMeasure measure) { return component_of(measure) >= 0; }

}  // namespace remount::widgets
