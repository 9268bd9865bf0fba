#include "widgets/parameter_text.h"

#include <QStringList>

#include "algorithms/calibration/calibration_result.h"
#include "widgets/model_text.h"

namespace remount {

QString parameter_name(std::size_t i) { return model_text(kParameterNames.at(i)); }

QString shown_parameter_names(const std::array<bool, 6>& given, bool wanted) {
  QStringList names;
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i] == wanted) names << parameter_name(i);
  return names.join(QStringLiteral(", "));
}

QString unit_suffix(std::size_t i) { return is_angle(i) ? QStringLiteral("°") : QStringLiteral(" m"); }

}  // namespace remount
