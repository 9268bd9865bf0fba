// The only place that knows the order of the stages; window and command line both call it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/calibration/method_details.h"
#include "algorithms/calibration/pairwise/pairwise.h"
#include "algorithms/cloud/objects.h"
#include "algorithms/core/progress.h"
#include "algorithms/motion/sweep.h"
#include "algorithms/quality/map_sharpness.h"
#include "model/drive/session.h"
#include "model/pipeline/verdicts.h"
#include "model/results/mounting_frames.h"
#include "model/settings/settings.h"

namespace remount::pipeline {

/// What a calibration starts from.
struct PipelineInput {
  std::vector<std::shared_ptr<const drive::Session>> sessions;  ///< of one vehicle
  settings::Settings settings;
  /// Nothing: unknown mounting. In another frame than the INS's for a method that finds the LiDAR in that.
  std::optional<RigidTransform> nominal_ins_from_lidar;
  calibration::MountingFrames nominal_frames;
  cloud::BeamEstimate known_beams;    ///< taken out of the scans of `sessions` already; empty: nothing is known
  std::vector<PairVerdict> verdicts;  ///< obeyed as soon as the pairs are registered
  int threads = 0;                    ///< 0: one per core; the result does not depend on it
  /// Hears, on the calling thread, what X is so far while more pairs are registered; may be empty.
  std::function<void(const Message&)> tell_so_far;
  /// By session: of each of its LiDAR poses, how the motion since the pose before may err where it rests on an assumed
  /// mounting, for the LiDAR did not tell it (untold_motions in algorithms/odometry/fusion/fused_poses.h). Empty: it
  /// told all.
  std::vector<std::vector<Matrix6d>> odometry_untold;
};

/// Whether the accumulated map was compared under the result and others, and why not.
enum class MapCheck {
  NotReached,  ///< no usable result, or cancelled before
  Made,
  SwitchedOff,
  NoScans,    ///< the sessions hold LiDAR poses, or the method has no keyframes
  NoOverlap,  ///< no stretch of scans turns and overlaps
  Moved,      ///< it was made, and X has moved since
};

/// What a calibration rests on: pairs for review, and how their scans were taken.
struct PairEvidence {
  std::vector<motion::Keyframe> keyframes;
  std::vector<motion::Pair> pairs;
  /// Away from the ground, unit length, as the first scans show it; where there was no nominal and they do.
  std::optional<Eigen::Vector3d> up_in_lidar;
  /// Whether motion within the scans of each session was compensated by the sweep's azimuth; empty before that is
  /// decided.
  std::vector<bool> session_uses_sweep;
  /// The sweeps by which they were, which may have been found from the scans; empty: the sessions' own.
  std::vector<drive::SweepModel> session_sweeps;
  /// When the points of a scan of each session were measured, where its motion is compensated; empty: at their stamps.
  std::vector<motion::Sweep> session_swept;
  /// How many scans around its stamp a keyframe of each session is made of; empty: one.
  std::vector<int> session_frames;
  /// How far X is off, under `perturb`, where the scans were swept otherwise than was taken: one of each way that
  /// they do not refute.
  std::vector<Vector6d> sweep_doubts;
  /// Scans that may be bent by their motion, in a way that is not known, tell no clock offset.
  bool clock_told = true;
  /// The largest offset between the clocks of a session that turning found and registered pairs confirm.
  double farthest_clock_s = 0.0;
  /// The ground in the scans; where the settings give the height of the INS above it.
  std::optional<calibration::ObservedGround> ground;
};

/// What it found.
struct CalibrationOutcome {
  std::string method{calibration::kPairwise};  ///< id of the CalibrationMethod
  calibration::CalibrationResult result;
  /// X is solved with the offset of each session's clocks as an unknown: the drive determines it well.
  bool clock_is_unknown = false;
  /// How far X is off, under `perturb`, by a clock offset that was found and not applied.
  std::optional<Vector6d> clock_bias;
  std::vector<calibration::NamedQuantity> quantities;  ///< what the method determined beside X
  std::vector<calibration::Plot> plots;                ///< of the method
  std::vector<quality::NamedSharpness> sharpness;      ///< the result's first; empty unless map_check is Made
  MapCheck map_check = MapCheck::NotReached;
};

/// How it came to it.
struct RunRecord {
  std::vector<drive::Finding> findings;  ///< of every stage, the readers' included
  /// The X under which objects and starts of registrations were predicted: the nominal, or the coarse X found without
  /// one.
  RigidTransform initial_ins_from_lidar = RigidTransform::Identity();
  /// The X through which motion within scans was compensated in the end.
  RigidTransform compensation_ins_from_lidar = RigidTransform::Identity();
  cloud::BeamNodes beam_nodes;      ///< where errors of the LiDAR's beams are unknowns; none: no scan was compared
  cloud::BeamErrors mended_beams;   ///< taken out of every scan as it was read
  cloud::BeamEstimate known_beams;  ///< of these, what was known before the drive; empty: nothing
  bool nominal_known = false;
  bool initial_known = false;  ///< false: only odometry was given and no nominal
};

/// What a calibration leaves behind.
struct PipelineOutput : PairEvidence, CalibrationOutcome, RunRecord {
  /// What the solver found out on the way to `result`, for a solution together with other LiDARs; not kept in files.
  /// Null where it did not run.
  std::shared_ptr<const calibration::PairwiseDetails> details = {};
};

/// load -> keyframes -> pairs -> objects -> register -> motions -> candidates -> rank -> refine -> joint clouds ->
/// report. Scans that cannot be read are skipped and become findings. Throws Error(Contract) for no
/// session, one given twice, other INS axes, or settings or a nominal out of range; Error(Unsupported) for one without
/// LiDAR or INS.
PipelineOutput run_pipeline(const PipelineInput& input, Progress& progress);

/// Solves again from pairs that are already registered, with their present states and the present search range:
/// what the window does after a decision. Pairs decided by the user keep their state; residuals, weights and the
/// program's own decisions are updated in `output`. No scan is read; joint alignment of clouds is left out, and the map
/// check with it. False where cancelled; `output` is then as it was.
bool solve_again(const PipelineInput& input, PipelineOutput& output, Progress& progress);

/// The first answer of solve_again, in a fraction of its time: X, residuals and counts under the present states, from
/// one joint solution with the noise that `output` has. Sigmas, what is observed (parameters that are not keep their
/// values), candidates and the other pairs' states stay as they were: solve_again says them. False where `output` has
/// no numbers to start from, or the solution failed; `output` is then as it was.
bool solve_at_once(const PipelineInput& input, PipelineOutput& output, const Progress& progress);

/// Compares the accumulated map under the X of `output` as a whole calibration does at its end: after solve_again.
/// Reads up to 32 scans. Does nothing where there is no usable result or the settings switch it off.
void check_map(const PipelineInput& input, PipelineOutput& output, Progress& progress);

/// The scan of one keyframe in its lidar frame, deskewed as for registration. Empty where the session has LiDAR poses
/// and no scans, or where cancelled; throws Error where it cannot be read.
cloud::PointCloud load_keyframe_scan(const PipelineInput& input, const PipelineOutput& output,
                                     motion::KeyframeIndex keyframe, const Progress& progress);

/// The keyframes' scans of one session for its accumulated map, deskewed as for registration.
struct SessionScans {
  quality::MapScans scans;  ///< local: level axes of the INS data, the origin at the first keyframe's INS
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();  ///< of local, in the session's own level axes
  std::size_t points_recorded = 0;                     ///< before they were thinned
  std::size_t unreadable = 0;                          ///< scans
  Message first_failure;                               ///< where and why; empty where all were read
};
/// Holds at most about `most_points`, thinned alike in every scan. Empty where the session has LiDAR poses and no
/// scans, or where cancelled. Throws Error where no scan can be read.
SessionScans load_map_scans(const PipelineInput& input, const PipelineOutput& output, motion::SessionIndex session,
                            std::size_t most_points, Progress& progress);

/// Solves P X = X Q from motion pairs alone (no scans): the `solve` verb. `pairs` carry P and Q; where
/// `registration.information` is zero all pairs weigh alike. Where the keyframes' numbers name poses (P of the loops
/// that they form close), pairs share their errors; otherwise each stands for itself, its neighbours in the list
/// counting as neighbours in time. Throws Error(Contract) for a nominal outside the search range.
calibration::CalibrationResult solve_motion_pairs(const std::vector<motion::Keyframe>& keyframes,
                                                  std::vector<motion::Pair>& pairs, const settings::Settings& settings,
                                                  const std::optional<RigidTransform>& nominal_ins_from_lidar,
                                                  Progress& progress);

}  // namespace remount::pipeline
