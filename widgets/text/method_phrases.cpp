// What the methods say beside the mounting and about it, and the comparison of results.
#include "widgets/text/method_phrases.h"

#include <QtGlobal>

namespace remount {

const std::vector<const char*>& method_phrases() {
  static const std::vector<const char*> phrases{
      // methods and what they need
      QT_TRANSLATE_NOOP("remount::model", "Trajectory alignment"),
      QT_TRANSLATE_NOOP("remount::model", "Vehicle frame"),
      QT_TRANSLATE_NOOP("remount::model", "Slewing machine"),
      // results, advice, findings, comparisons, stages; words within them
      QT_TRANSLATE_NOOP("remount::model", ", "),
      QT_TRANSLATE_NOOP("remount::model", "x"),
      QT_TRANSLATE_NOOP("remount::model", "y"),
      QT_TRANSLATE_NOOP("remount::model", "z"),
      QT_TRANSLATE_NOOP("remount::model", "yaw"),
      QT_TRANSLATE_NOOP("remount::model", "pitch"),
      QT_TRANSLATE_NOOP("remount::model", "roll"),
      QT_TRANSLATE_NOOP("remount::model", "m"),
      QT_TRANSLATE_NOOP("remount::model", "deg"),
      QT_TRANSLATE_NOOP("remount::model", "ground"),
      QT_TRANSLATE_NOOP("remount::model", "arm"),
      QT_TRANSLATE_NOOP("remount::model", "turn"),
      QT_TRANSLATE_NOOP("remount::model", "only %1 poses"),
      QT_TRANSLATE_NOOP("remount::model", "only %1 points"),
      QT_TRANSLATE_NOOP("remount::model", "Not compared: %1."),
      // errors
      QT_TRANSLATE_NOOP("remount::model", "epochs must ascend in time"),
      QT_TRANSLATE_NOOP("remount::model", "was not opened"),
  };
  return phrases;
}

}  // namespace remount
