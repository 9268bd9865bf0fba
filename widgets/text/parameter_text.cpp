#include "widgets/text/parameter_text.h"

#include <QStringList>
#include <cmath>

#include "algorithms/calibration/calibration_result.h"
#include "widgets/text/model_text.h"

namespace remount {

QString parameter_name(std::size_t i) { return model_text(kParameterNames.at(i)); }

QString shown_parameter_names(const std::array<bool, 6>& given, bool wanted) {
  QStringList names;
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i] == wanted) names << parameter_name(i);
  return names.join(QStringLiteral(", "));
}

QString unit_suffix(std::size_t i) { return is_angle(i) ? QStringLiteral("°") : QStringLiteral(" m"); }

QString moved_text(std::size_t i, double change) {
  const bool small = std::abs(change) < 1.0, in_mm = small && !is_angle(i);
  const QString unit = in_mm ? QStringLiteral(" mm") : unit_suffix(i);
  const QString number = in_mm ? QString::number(1e3 * change, 'f', 2) : QString::number(change, 'f', small ? 4 : 3);
  const bool nothing = number.toDouble() == 0.0;
  return nothing ? QStringLiteral("0") + unit : (change > 0.0 ? QStringLiteral("+") : QString()) + number + unit;
}

}  // namespace remount
