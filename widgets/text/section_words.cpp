#include "widgets/text/section_words.h"

#include <QCoreApplication>
#include <array>

namespace remount::widgets {
namespace {

struct Section {
  const char *id, *title;
};

constexpr std::array kSections{
    Section{"run", QT_TRANSLATE_NOOP("remount::widgets::OptionsDialog", "General")},
    Section{"keyframes", QT_TRANSLATE_NOOP("remount::widgets::OptionsDialog", "Keyframes")},
    Section{"pairing", QT_TRANSLATE_NOOP("remount::widgets::OptionsDialog", "Pairing")},
    Section{"objects", QT_TRANSLATE_NOOP("remount::widgets::OptionsDialog", "Objects")},
    Section{"beams", QT_TRANSLATE_NOOP("remount::widgets::OptionsDialog", "LiDAR beams")},
    Section{"registration", QT_TRANSLATE_NOOP("remount::widgets::OptionsDialog", "Alignment")},
    Section{"range", QT_TRANSLATE_NOOP("remount::widgets::OptionsDialog", "Search range")},
    Section{"solve", QT_TRANSLATE_NOOP("remount::widgets::OptionsDialog", "Solution")},
    Section{"measured", QT_TRANSLATE_NOOP("remount::widgets::OptionsDialog", "Measured by hand")},
    Section{"lidar_odometry", QT_TRANSLATE_NOOP("remount::widgets::OptionsDialog", "LiDAR odometry")},
    Section{"trajectory", QT_TRANSLATE_NOOP("remount::widgets::OptionsDialog", "Trajectory alignment")},
    Section{"fusion", QT_TRANSLATE_NOOP("remount::widgets::OptionsDialog", "Fusion odometry")},
    Section{"vehicle_frame", QT_TRANSLATE_NOOP("remount::widgets::OptionsDialog", "Vehicle frame")},
    Section{"slew", QT_TRANSLATE_NOOP("remount::widgets::OptionsDialog", "Slewing machine")},
};

}  // namespace

QString section_title(const QString& section) {
  for (const Section& known : kSections)
    if (section == QLatin1String(known.id))
      return QCoreApplication::translate("remount::widgets::OptionsDialog", known.title);
  return section;
}

}  // namespace remount::widgets
