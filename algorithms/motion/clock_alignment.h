// The constant offset between the clocks of two sensors on one rigid body, from their rotation alone.
// docs/maths/clocks.md (K2) to (K4)
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "algorithms/messages/message.h"
#include "algorithms/motion/ins_sample.h"

namespace remount::motion {

struct ClockAlignmentOptions {
  double step_s = 0.02;           ///< of the fine search; offsets are interpolated below it
  double window_s = 0.3;          ///< over which a rate of rotation is taken; the same for both streams
  double max_gap_s = 1.0;         ///< no rate is taken across a longer gap
  double min_overlap_s = 5.0;     ///< of the streams under an offset, and at least half of the shorter stream
  double max_template_s = 300.0;  ///< at most so much of the second stream is used: where it turns most
  double max_offset_s = std::numeric_limits<double>::infinity();  ///< farther ones are neither answers nor rivals
};

/// Rotations with their stamps, of poses or of an INS, without a copy: what they lie in must outlive this.
class RotationStream {
 public:
  RotationStream() = default;
  RotationStream(const std::vector<StampedPose>& poses) : poses_(poses) {}      // NOLINT: a view of either
  RotationStream(const std::vector<InsSample>& samples) : samples_(samples) {}  // NOLINT
  std::size_t size() const { return poses_.size() + samples_.size(); }          // one of them is empty
  bool empty() const { return size() == 0; }
  std::int64_t stamp_ns(std::size_t i) const { return samples_.empty() ? poses_[i].stamp_ns : samples_[i].stamp_ns; }
  Eigen::Quaterniond rotation(std::size_t i) const {
    return samples_.empty() ? Eigen::Quaterniond(poses_[i].pose.linear()) : samples_[i].enu_from_ins;
  }
  /// From the first stamp that is not before `from_ns` to the last that is not behind `to_ns`.
  RotationStream between(std::int64_t from_ns, std::int64_t to_ns) const;

 private:
  std::span<const StampedPose> poses_;
  std::span<const InsSample> samples_;
};

struct ClockAlignment {
  bool found = false;        ///< false: the streams are too short or do not turn; `why` says which
  bool ambiguous = true;     ///< another offset fits nearly as well, or none fits
  double offset_s = 0.0;     ///< t_reference = t_other + offset
  double sigma_s = 0.0;      ///< 1-sigma of the offset from the misfit of the two rates
  double correlation = 0.0;  ///< normalised, at the offset
  double runner_up = 0.0;    ///< best correlation farther than a second from it
  double overlap_s = 0.0;
  Message why;  ///< where there is no clear answer
};

/// Two sensors on one rigid body turn at the same rate |omega| whatever their mounting. Correlates the two rates over
/// every offset that lets the streams overlap (coarse), then near the best one (fine, parabola through the peak).
/// Only rotations and stamps of the poses are used; they map from the sensor to any fixed frame. Stamps ascend.
/// (Rate correlation as in Furrer et al. 2017, "Evaluation of combined time-offset estimation and hand-eye
/// calibration".)
ClockAlignment align_clocks(const RotationStream& reference, const RotationStream& other,
                            const ClockAlignmentOptions& options = {});

}  // namespace remount::motion
