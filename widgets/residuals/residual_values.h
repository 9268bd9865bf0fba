// What the residuals plot shows of each pair: how far it is off, and under which circumstances it was taken.
#pragma once

#include <QString>
#include <array>
#include <vector>

#include "model/pipeline/pipeline.h"

namespace remount::widgets {

/// X to Yaw: components of P X = X Q under the present result, in the axes of the LiDAR at the later scan.
enum class ResidualMeasure { Translation, Rotation, X, Y, Z, Roll, Pitch, Yaw, Rmse, Overlap };
inline constexpr std::array kResidualMeasures{
    ResidualMeasure::Translation, ResidualMeasure::Rotation, ResidualMeasure::X,     ResidualMeasure::Y,
    ResidualMeasure::Z,           ResidualMeasure::Roll,     ResidualMeasure::Pitch, ResidualMeasure::Yaw,
    ResidualMeasure::Rmse,        ResidualMeasure::Overlap};

/// Speed and turn rate are means from the first scan of the pair to the second.
enum class PairCircumstance { Time, Speed, TurnRate, Gap, Baseline, Rotation, Session };
inline constexpr std::array kPairCircumstances{
    PairCircumstance::Time,     PairCircumstance::Speed,    PairCircumstance::TurnRate, PairCircumstance::Gap,
    PairCircumstance::Baseline, PairCircumstance::Rotation, PairCircumstance::Session};

/// Of each pair in the unit of the screen (cm, degrees, percent); NaN where its scans were never aligned, and of the
/// components where there is no result to compare with.
std::vector<double> values_of(const pipeline::PipelineOutput& output, ResidualMeasure measure);

/// Of each pair in the unit of the screen (s, m/s, degrees per second, m, degrees); NaN where it is not known. Time
/// counts from the first keyframe of the pair's session to the middle of the pair. A session is a strip about its
/// number, counted as users do, in which its pairs lie in the order of the list.
std::vector<double> values_of(const pipeline::PipelineOutput& output, PairCircumstance circumstance);

QString name_of(ResidualMeasure measure);        ///< "Residual x"
QString name_of(PairCircumstance circumstance);  ///< "Speed"
QString unit_of(ResidualMeasure measure);        ///< "cm", "°", "%"
QString unit_of(PairCircumstance circumstance);  ///< "m/s"; empty for a session
bool has_sign(ResidualMeasure measure);          ///< values lie on both sides of zero

}  // namespace remount::widgets
