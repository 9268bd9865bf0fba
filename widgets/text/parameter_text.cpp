#include "widgets/text/parameter_text.h"

#include <QStringList>
#include <cmath>

#include "widgets/text/model_text.h"

namespace remount {

QString parameter_name(Parameter parameter) { return model_text(parameter_word(parameter)); }

QString shown_parameter_names(ParameterSet given) {
  QStringList names;
  for (const Parameter parameter : kParameters)
    if (given.contains(parameter)) names << parameter_name(parameter);
  return names.join(QStringLiteral(", "));
}

QString unit_suffix(Parameter parameter) { return is_angle(parameter) ? QStringLiteral("°") : QStringLiteral(" m"); }

QString moved_text(Parameter parameter, double change) {
  const bool small = std::abs(change) < 1.0, in_mm = small && !is_angle(parameter);
  const QString unit = in_mm ? QStringLiteral(" mm") : unit_suffix(parameter);
  const QString number = in_mm ? QString::number(1e3 * change, 'f', 2) : QString::number(change, 'f', small ? 4 : 3);
  const bool nothing = number.toDouble() == 0.0;
  return nothing ? QStringLiteral("0") + unit : (change > 0.0 ? QStringLiteral("+") : QString()) + number + unit;
}

}  // namespace remount
