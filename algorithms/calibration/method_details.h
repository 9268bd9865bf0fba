// What a calibration method tells beside X: other quantities that it determined, and plots. Values only.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/messages/message.h"

namespace remount::calibration {

/// Id of the method that every session starts with.
inline constexpr std::string_view kPairwise = "pairwise";

/// A quantity beside X. Angles are in rad and their unit is then "rad"; they are shown in degrees.
struct NamedQuantity {
  std::string id;  ///< "scale", "slew centre x", "imu yaw": what files hold and programs go by; it stays
  Message name;    ///< for people
  double value = std::numeric_limits<double>::quiet_NaN();
  double sigma = std::numeric_limits<double>::quiet_NaN();  ///< NaN where it is not known
  std::string unit;                                         ///< "m", "rad", "" for a ratio
  bool observed = true;  ///< false: `value` is what was assumed, not what the data say
};

/// One curve of a plot; `sigma` is empty or as long as `y`, and is drawn as a band of three sigma.
struct Curve {
  Message name;
  std::vector<double> x, y, sigma;
  bool dots = false;  ///< single points instead of a line
  /// m; empty, or as long as `y`: the heights of a way whose x and y are metres. The window shows it in space as well.
  std::vector<double> z;
};

struct Plot {
  Message title;
  Message x_label, y_label;  ///< with their units
  bool equal_axes = false;   ///< a map: a metre is as long on both axes
  std::vector<Curve> curves;
};

/// Keeps at most `most` points of each curve, evenly taken, the last one always.
void thin(std::vector<Plot>& plots, std::size_t most);

}  // namespace remount::calibration
