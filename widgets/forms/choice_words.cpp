#include "widgets/forms/choice_words.h"

#include <QCoreApplication>
#include <array>

#include "model/method_registry/calibration_method.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {
namespace {

constexpr const char* kContext = "remount::widgets::choices";

struct Choice {
  const char *option, *key, *words;
};

constexpr std::array kChoices{
    Choice{"run.deskew", "auto", QT_TRANSLATE_NOOP("remount::widgets::choices", "where the data call for it")},
    Choice{"run.deskew", "on", QT_TRANSLATE_NOOP("remount::widgets::choices", "always")},
    Choice{"run.deskew", "off", QT_TRANSLATE_NOOP("remount::widgets::choices", "never")},
    Choice{"solve.apply_time_offset", "auto", QT_TRANSLATE_NOOP("remount::widgets::choices", "where it is clear")},
    Choice{"solve.apply_time_offset", "yes", QT_TRANSLATE_NOOP("remount::widgets::choices", "always")},
    Choice{"solve.apply_time_offset", "no", QT_TRANSLATE_NOOP("remount::widgets::choices", "never")},
    Choice{"keyframes.mode", "distance", QT_TRANSLATE_NOOP("remount::widgets::choices", "after a distance")},
    Choice{"keyframes.mode", "time", QT_TRANSLATE_NOOP("remount::widgets::choices", "after a time")},
    Choice{"keyframes.gather", "auto", QT_TRANSLATE_NOOP("remount::widgets::choices", "where one shows too little")},
    Choice{"keyframes.gather", "off", QT_TRANSLATE_NOOP("remount::widgets::choices", "never")},
    Choice{"keyframes.gather", "frames", QT_TRANSLATE_NOOP("remount::widgets::choices", "so many scans")},
    Choice{"pairing.limit", "time", QT_TRANSLATE_NOOP("remount::widgets::choices", "close in time")},
    Choice{"pairing.limit", "distance", QT_TRANSLATE_NOOP("remount::widgets::choices", "close in distance")},
    Choice{"pairing.limit", "either", QT_TRANSLATE_NOOP("remount::widgets::choices", "close in either")},
    Choice{"pairing.choice", "auto", QT_TRANSLATE_NOOP("remount::widgets::choices", "as many as X needs")},
    Choice{"pairing.choice", "all", QT_TRANSLATE_NOOP("remount::widgets::choices", "every one")},
    Choice{"beams.lidar", "perfect", QT_TRANSLATE_NOOP("remount::widgets::choices", "without errors (simulated)")},
    Choice{"beams.lidar", "spinning", QT_TRANSLATE_NOOP("remount::widgets::choices", "spinning, with rings")},
    Choice{"beams.lidar", "solid-state", QT_TRANSLATE_NOOP("remount::widgets::choices", "solid-state, without rings")},
    Choice{"beams.lidar", "unknown", QT_TRANSLATE_NOOP("remount::widgets::choices", "any of these")},
    Choice{"beams.lidar", "auto", QT_TRANSLATE_NOOP("remount::widgets::choices", "as the session says")},
    Choice{"beams.lidar", "own", QT_TRANSLATE_NOOP("remount::widgets::choices", "by the numbers below")},
    Choice{"registration.algorithm", "plane-to-plane",
           QT_TRANSLATE_NOOP("remount::widgets::choices", "plane to plane (own engine)")},
    Choice{"registration.algorithm", "pcl-icp", QT_TRANSLATE_NOOP("remount::widgets::choices", "ICP (PCL)")},
    Choice{"registration.algorithm", "pcl-gicp", QT_TRANSLATE_NOOP("remount::widgets::choices", "GICP (PCL)")},
    Choice{"registration.algorithm", "pcl-ndt", QT_TRANSLATE_NOOP("remount::widgets::choices", "NDT (PCL)")},
    Choice{"slew.first_plane", "ground", QT_TRANSLATE_NOOP("remount::widgets::choices", "the ground (A)")},
    Choice{"slew.first_plane", "turn", QT_TRANSLATE_NOOP("remount::widgets::choices", "the LiDAR's circle (B)")},
    Choice{"slew.origin", "turn", QT_TRANSLATE_NOOP("remount::widgets::choices", "height of the LiDAR's circle")},
    Choice{"slew.origin", "ground", QT_TRANSLATE_NOOP("remount::widgets::choices", "height of the ground")},
    Choice{"vehicle_frame.scale", "known", QT_TRANSLATE_NOOP("remount::widgets::choices", "known (metres)")},
    Choice{"vehicle_frame.scale", "estimated", QT_TRANSLATE_NOOP("remount::widgets::choices", "to be estimated")},
};

}  // namespace

QString choice_words(const OptionField& field, const QString& key) {
  const QString option = field.section + QLatin1Char('.') + field.name;
  if (option == QLatin1String("run.method"))
    if (const method_registry::CalibrationMethod* method = method_registry::find_method(key.toStdString()))
      return model_text(method->title());
  for (const Choice& choice : kChoices)
    if (option == QLatin1String(choice.option) && key == QLatin1String(choice.key))
      return QCoreApplication::translate(kContext, choice.words);
  return key;
}

}  // namespace remount::widgets
