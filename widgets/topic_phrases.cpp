#include "widgets/topic_phrases.h"

#include <QtGlobal>

namespace remount {

const std::vector<const char*>& topic_phrases() {
  static const std::vector<const char*> phrases{
      QT_TRANSLATE_NOOP("remount::model", "scans of %1 points that have times"),
      QT_TRANSLATE_NOOP("remount::model", "scans of %1 points without times"),
      QT_TRANSLATE_NOOP("remount::model", "scans; the first cannot be read"),
      QT_TRANSLATE_NOOP("remount::model", "rare, as maps are: %1 points"),
      QT_TRANSLATE_NOOP("remount::model", "poses: they stand for the LiDAR where they are asked for"),
      QT_TRANSLATE_NOOP("remount::model", "position and attitude of the INS itself"),
      QT_TRANSLATE_NOOP("remount::model", "poses; the name speaks of an INS"),
      QT_TRANSLATE_NOOP("remount::model", "poses; the name does not say of what"),
      QT_TRANSLATE_NOOP("remount::model", "its name speaks of another sensor than an INS"),
      QT_TRANSLATE_NOOP("remount::model", "it stands for the LiDAR"),
      QT_TRANSLATE_NOOP("remount::model", "an orientation, to which fixes give the position"),
      QT_TRANSLATE_NOOP("remount::model", "an orientation without its error, to which fixes give the position"),
      QT_TRANSLATE_NOOP("remount::model", "slow: %1 Hz, where %2 has %3 Hz"),
      QT_TRANSLATE_NOOP("remount::model", "an orientation, but no fixes are there to give the position"),
      QT_TRANSLATE_NOOP("remount::model", "fixes; by its name of the device of the orientation"),
      QT_TRANSLATE_NOOP("remount::model", "fixes of a receiver"),
      QT_TRANSLATE_NOOP("remount::model", "fixes that place the INS already"),
      QT_TRANSLATE_NOOP("remount::model", "turn rates and accelerations"),
      QT_TRANSLATE_NOOP("remount::model", "where the transforms lead from the LiDAR to the INS"),
      QT_TRANSLATE_NOOP("remount::model", "it has no messages"),
      QT_TRANSLATE_NOOP("remount::model", "its messages are serialised in a way that is not read"),
      QT_TRANSLATE_NOOP("remount::model", "transforms that change with time are not read"),
      QT_TRANSLATE_NOOP("remount::model", "neither its orientation nor its rates are measured"),
      QT_TRANSLATE_NOOP("remount::model", "messages of this type are not read"),
      QT_TRANSLATE_NOOP("remount::model",
                        "was chosen for lidar and for ins: a motion that is compared with itself tells nothing"),
  };
  return phrases;
}

}  // namespace remount
