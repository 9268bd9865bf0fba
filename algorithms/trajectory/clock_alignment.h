// The constant offset between the clocks of two sensors on one rigid body, from their rotation alone.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "algorithms/trajectory/ins_sample.h"

namespace remount {

struct ClockAlignmentOptions {
  double step_s = 0.02;           ///< of the fine search; offsets are interpolated below it
  double window_s = 0.3;          ///< over which a rate of rotation is taken; the same for both streams
  double max_gap_s = 1.0;         ///< no rate is taken across a longer gap
  double min_overlap_s = 5.0;     ///< of the streams under an offset, and at least half of the shorter stream
  double max_template_s = 300.0;  ///< at most so much of the second stream is used: where it turns most
  double max_offset_s = std::numeric_limits<double>::infinity();  ///< farther ones are neither answers nor rivals
};

struct ClockAlignment {
  bool found = false;        ///< false: the streams are too short or do not turn; `why` says which
  bool ambiguous = true;     ///< another offset fits nearly as well, or none fits
  double offset_s = 0.0;     ///< t_reference = t_other + offset
  double sigma_s = 0.0;      ///< 1-sigma of the offset from the misfit of the two rates
  double correlation = 0.0;  ///< normalised, at the offset
  double runner_up = 0.0;    ///< best correlation farther than a second from it
  double overlap_s = 0.0;
  std::string why;  ///< in words, where there is no clear answer
};

/// Two sensors on one rigid body turn at the same rate |omega| whatever their mounting. Correlates the two rates over
/// every offset that lets the streams overlap (coarse), then near the best one (fine, parabola through the peak).
/// Only rotations and stamps of the poses are used; they map from the sensor to any fixed frame. Stamps ascend.
/// (Rate correlation as in Furrer et al. 2017, "Evaluation of combined time-offset estimation and hand-eye
/// calibration".)
ClockAlignment align_clocks(const std::vector<StampedPose>& reference, const std::vector<StampedPose>& other,
                            const ClockAlignmentOptions& options = {});

}  // namespace remount
