#include "widgets/text/parameter_text.h"

#include <QStringList>
#include <cmath>

#include "model/formats/files/number_text.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {

QString parameter_name(calibration::Parameter parameter) { return model_text(calibration::parameter_word(parameter)); }

QString shown_parameter_names(calibration::ParameterSet given) {
  QStringList names;
  for (const calibration::Parameter parameter : calibration::kParameters)
    if (given.contains(parameter)) names << parameter_name(parameter);
  return names.join(QStringLiteral(", "));
}

QString rounded_text(double value, int decimals) {
  return QString::fromStdString(formats::rounded_text(value, decimals));
}

QString unit_suffix(calibration::Parameter parameter) {
  return calibration::is_angle(parameter) ? QStringLiteral("°") : QStringLiteral(" m");
}

QString spread_text(double spread, int decimals) {
  return QStringLiteral("± ") + QString::fromStdString(formats::spread_text(spread, decimals));
}

QString moved_text(calibration::Parameter parameter, double change) {
  const bool small = std::abs(change) < 1.0, in_mm = small && !calibration::is_angle(parameter);
  const QString unit = in_mm ? QStringLiteral(" mm") : unit_suffix(parameter);
  const QString number = in_mm ? QString::number(1e3 * change, 'f', 2) : QString::number(change, 'f', small ? 4 : 3);
  const bool nothing = number.toDouble() == 0.0;
  return nothing ? QStringLiteral("0") + unit : (change > 0.0 ? QStringLiteral("+") : QString()) + number + unit;
}

}  // namespace remount::widgets
