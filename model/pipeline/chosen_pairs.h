// Which of the pairs of a long drive are registered: as many as X needs. docs/maths/pairwise.md (P23) to (P26)
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/calibration/pairwise/pair_choice.h"
#include "model/pipeline/drive_motion.h"
#include "model/pipeline/pipeline.h"
#include "model/pipeline/register_stage.h"

namespace remount::pipeline {

/// What pairs that are taken tell beside what all would tell.
struct ToldByTaken {
  calibration::Parameter parameter = calibration::Parameter::X;  ///< whose sigma all pairs would lessen most
  double share = 1.0;                                            ///< of the information on it
  double wider = 1.0;                                            ///< its sigma, over what it would be with all
};

/// A solution by so many pairs.
struct SolvedByPairs {
  std::size_t pairs = 0;
  Vector6d variances = Vector6d::Zero();  ///< of the parameters; NaN where not observed
};
/// What the next ones would make of it, as the last two solutions go on: for what a pair tells of errors of beams is
/// known once it is registered. docs/maths/pairwise.md (P26)
/// @param all pairs that there are
ToldByTaken told_by_trend(const SolvedByPairs& before, const SolvedByPairs& now, std::size_t count, std::size_t all);

/// All proposed pairs of a calibration. Its output holds those that were taken, in the same order, and their keyframes.
class ChosenPairs {
 public:
  /// Leaves in `output` the pairs to begin with: all where there are few of them or the settings want all.
  ChosenPairs(const PipelineInput& input, const DriveMotion& motion, PipelineOutput& output);

  /// After a solution: takes as many more as are needed until all others together would make no sigma much smaller.
  /// @param objects of the keyframes, which go with them
  /// @return where the new ones are in `output.pairs`; empty: there are enough
  std::vector<motion::PairIndex> take_more(const PipelineInput& input, const DriveMotion& motion,
                                           const calibration::PairwiseDetails& details, PipelineOutput& output,
                                           std::vector<KeyframeObjects>& objects, const Progress& progress);

  /// Whether pairs are left that were not taken.
  bool any_left() const { return taken_count_ < pairs_.size(); }

  /// X by those that are taken.
  Message so_far(const calibration::CalibrationResult& result) const;

  /// Notes what the pairs that were left would have added.
  void report(std::vector<drive::Finding>& findings) const;

 private:
  void store(const PipelineOutput& output);
  void hand_over(PipelineOutput& output, std::vector<KeyframeObjects>& objects);
  void take_for_sigma(const calibration::PairwiseInput& solver, const calibration::PairwiseDetails& details,
                      const calibration::CalibrationResult& result, calibration::PairChooser& chooser,
                      const Progress& progress);
  void take_by_trend(const calibration::CalibrationResult& result, calibration::PairChooser& chooser);

  std::vector<motion::Keyframe> keyframes_;
  std::vector<motion::Pair> pairs_;  ///< with the registrations of those that are taken, as they were when stored
  std::vector<bool> taken_;
  std::size_t taken_count_ = 0;
  std::vector<motion::KeyframeIndex> kept_;  ///< keyframes of the taken ones
  ToldByTaken told_;
  std::optional<SolvedByPairs> solved_before_;  ///< where errors of beams are unknowns
  int doublings_ = 0;                           ///< for something was in doubt
};

}  // namespace remount::pipeline
