#include "widgets/pairs/pair_measure.h"

#include <QCoreApplication>
#include <cmath>

#include "algorithms/motion/pair.h"

namespace remount::widgets {
namespace {
struct MeasureText {
  Q_DECLARE_TR_FUNCTIONS(remount::widgets::pair_measure)
};
}  // namespace

bool is_aligned(const motion::Pair& pair) {
  return pair.registration.attempted && motion::unusable_reason(pair).empty();
}

bool is_from_poses(const motion::Pair& pair) {
  // No alignment of scans leaves nothing at all.
  return pair.registration.attempted && pair.registration.rmse_m == 0.0 && pair.registration.overlap == 1.0;
}

std::optional<double> measured(const motion::Pair& pair, PairMeasure measure) {
  double value = std::numeric_limits<double>::quiet_NaN();
  const bool aligned = is_aligned(pair);
  switch (measure) {
    case PairMeasure::ResidualTranslation:
      if (aligned) value = 100.0 * pair.residual_translation_m;
      break;
    case PairMeasure::ResidualRotation:
      if (aligned) value = radians_to_degrees(pair.residual_rotation_rad);
      break;
    case PairMeasure::Rmse:
      if ((aligned && !is_from_poses(pair)) || pair.registration.rmse_m > 0.0) value = 100.0 * pair.registration.rmse_m;
      break;
    case PairMeasure::Screw:
      if (aligned) value = pair.screw.score;
      break;
  }
  return std::isfinite(value) ? std::optional(std::max(0.0, value)) : std::nullopt;
}

QString measure_name(PairMeasure measure) {
  switch (measure) {
    case PairMeasure::ResidualTranslation:
      return MeasureText::tr("Residual translation");
    case PairMeasure::ResidualRotation:
      return MeasureText::tr("Residual rotation");
    case PairMeasure::Rmse:
      return MeasureText::tr("Alignment RMSE");
    case PairMeasure::Screw:
      return MeasureText::tr("INS against LiDAR");
  }
  return {};
}

QString measure_unit(PairMeasure measure) {
  switch (measure) {
    case PairMeasure::ResidualTranslation:
    case PairMeasure::Rmse:
      return QStringLiteral("cm");
    case PairMeasure::ResidualRotation:
      return QStringLiteral("°");
    case PairMeasure::Screw:
      return QStringLiteral("σ");
  }
  return {};
}

}  // namespace remount::widgets
