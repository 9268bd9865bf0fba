#include "widgets/text/section_words.h"

#include <QCoreApplication>
#include <array>

namespace remount {
namespace {

struct Section {
  const char *id, *title;
};

constexpr std::array kSections{
    Section{"run", QT_TRANSLATE_NOOP("remount::OptionsDialog", "General")},
    Section{"keyframes", QT_TRANSLATE_NOOP("remount::OptionsDialog", "Keyframes")},
    Section{"pairing", QT_TRANSLATE_NOOP("remount::OptionsDialog", "Pairing")},
    Section{"objects", QT_TRANSLATE_NOOP("remount::OptionsDialog", "Objects")},
    Section{"registration", QT_TRANSLATE_NOOP("remount::OptionsDialog", "Alignment")},
    Section{"range", QT_TRANSLATE_NOOP("remount::OptionsDialog", "Search range")},
    Section{"solve", QT_TRANSLATE_NOOP("remount::OptionsDialog", "Solution")},
    Section{"measured", QT_TRANSLATE_NOOP("remount::OptionsDialog", "Measured by hand")},
    Section{"lidar_odometry", QT_TRANSLATE_NOOP("remount::OptionsDialog", "LiDAR odometry")},
    Section{"trajectory", QT_TRANSLATE_NOOP("remount::OptionsDialog", "Trajectory alignment")},
    Section{"fusion", QT_TRANSLATE_NOOP("remount::OptionsDialog", "Fusion odometry")},
    Section{"vehicle_frame", QT_TRANSLATE_NOOP("remount::OptionsDialog", "Vehicle frame")},
    Section{"slew", QT_TRANSLATE_NOOP("remount::OptionsDialog", "Slewing machine")},
};

}  // namespace

QString section_title(const QString& section) {
  for (const Section& known : kSections)
    if (section == QLatin1String(known.id)) return QCoreApplication::translate("remount::OptionsDialog", known.title);
  return section;
}

}  // namespace remount
