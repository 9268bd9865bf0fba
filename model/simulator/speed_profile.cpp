#include "model/simulator/speed_profile.h"

#include <cmath>

namespace remount::simulator {

namespace {

constexpr double kSpeedUp_s = 4.0, kSwing_s = 20.0;

/// Time spent driving at full speed that leads as far as driving for `time_s` from a standstill. The speed follows
/// 35 u^4 - 84 u^5 + 70 u^6 - 20 u^7, so that acceleration and its first derivatives are continuous.
double at_full_speed_s(double time_s) {
  if (time_s <= 0.0) return 0.0;
  if (time_s >= kSpeedUp_s) return time_s - 0.5 * kSpeedUp_s;
  const double u = time_s / kSpeedUp_s, u2 = u * u, u4 = u2 * u2;
  return kSpeedUp_s * u4 * u * (7.0 + u * (-14.0 + u * (10.0 - 2.5 * u)));
}

}  // namespace

double along_road_m(const SimulationOptions& options, double time_s) {
  if (options.standstill_s > 0.0) time_s = at_full_speed_s(time_s - options.standstill_s);
  if (options.speed_swing == 0.0) return options.speed_mps * time_s;
  const double rate = 2.0 * kPi / kSwing_s;
  return options.speed_mps * (time_s - options.speed_swing * std::sin(rate * time_s) / rate);
}

}  // namespace remount::simulator
