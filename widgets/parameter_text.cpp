#include "widgets/parameter_text.h"

#include "algorithms/calibration/calibration_result.h"

namespace remount {

QString parameter_name(std::size_t i) { return QString::fromUtf8(kParameterNames.at(i)); }

QString unit_suffix(std::size_t i) { return is_angle(i) ? QStringLiteral("°") : QStringLiteral(" m"); }

}  // namespace remount
