// What pairs are judged by: table, filter and bar chart show the same numbers.
#pragma once

#include <QString>
#include <array>
#include <optional>

#include "algorithms/motion/pair.h"

namespace remount::widgets {

enum class PairMeasure { ResidualTranslation, ResidualRotation, Rmse, Screw };
inline constexpr std::array kPairMeasures{PairMeasure::ResidualTranslation, PairMeasure::ResidualRotation,
                                          PairMeasure::Rmse, PairMeasure::Screw};

/// In the unit of the screen (cm, degrees, sigma); nothing where the pair was never aligned: 0 would look perfect.
std::optional<double> measured(const motion::Pair& pair, PairMeasure measure);
/// "Residual translation", for lists.
QString measure_name(PairMeasure measure);
/// "cm", "°", "σ".
QString measure_unit(PairMeasure measure);

/// Whether its scans were aligned well enough to say anything: screw test and residuals mean something.
bool is_aligned(const motion::Pair& pair);

/// Whether its motion comes from poses of somebody's odometry: there are no scans to have an RMSE, overlap or objects.
bool is_from_poses(const motion::Pair& pair);

}  // namespace remount::widgets
