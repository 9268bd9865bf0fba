// The linearised joint problem: its unknowns, its normal equations, and their solution. For the solver, the
// estimate of noise and what measurements pull.
#pragma once

#include <vector>

#include "algorithms/calibration/joint/block_cholesky.h"
#include "algorithms/calibration/joint/joint_solver.h"

namespace remount::calibration {

// The normal equations at one point, with the keyframes' block kept apart: [A B; B' C] [e; g] = [p; q].
struct NormalEquations {
  KeyframeBlocks keyframes;  // A
  Eigen::MatrixXd coupling;  // B
  Eigen::MatrixXd shared;    // C: X, attitude biases, clock offsets, lags, beams
  Eigen::VectorXd keyframe_side, shared_side;
  Eigen::VectorXd single_beams;  // where those of single beams stand; they are the last of what is shared
  Eigen::MatrixXd measured;      // of C and q, what was measured of the mountings by hand
  Eigen::VectorXd measured_side;
  double cost = 0.0;             // sum of squared residuals and priors
  double log_information = 0.0;  // sum of log |information| of all terms and priors
};

// Where the unknowns lie: of each keyframe its whole error and, where the INS drifts, how much of it is drift; then
// what is shared: the mountings first, single beams last. Terms then know the errors alone: with the white error in
// place of the whole one, every pair would couple the drifts of its keyframes as well.
struct Layout {
  // Errors of a LiDAR's beams: those that go with many at once, and those of single ones.
  struct Beams {
    Eigen::Index common_at = 0, common = 0, single_at = 0, single = 0;
    Eigen::Index count() const { return common + single; }
  };
  Eigen::Index lidars = 1;
  Eigen::Index sessions = 0;
  std::vector<Beams> beams_of;  // of each LiDAR
  Eigen::Index beams = 0;       // of all of them
  bool bias = false, clock = false, lag = false, drift = false;
  int node_size() const { return drift ? 12 : 6; }
  Eigen::Index node_at(motion::KeyframeIndex node) const { return nodes_size(node); }
  Eigen::Index drift_at(motion::KeyframeIndex node) const { return node_at(node) + 6; }
  Eigen::Index nodes_size(std::size_t nodes) const { return node_size() * signed_of(nodes); }
  Eigen::Index size() const { return beams_at() + beams; }
  Eigen::Index mountings_size() const { return 6 * lidars; }
  Eigen::Index mounting_at(motion::LidarIndex lidar) const { return 6 * signed_of(lidar); }
  Eigen::Index bias_at(motion::SessionIndex session) const { return mountings_size() + 3 * signed_of(session); }
  // Each LiDAR has a clock of its own, the INS is one.
  Eigen::Index clock_at(motion::SessionIndex session, motion::LidarIndex lidar = {}) const {
    return mountings_size() + (bias ? 3 * sessions : 0) + sessions * signed_of(lidar) + signed_of(session);
  }
  Eigen::Index lag_at(motion::SessionIndex session) const {
    return clock_at(motion::SessionIndex{0}) + (clock ? sessions * lidars : 0) + signed_of(session);
  }
  Eigen::Index beams_at() const { return lag_at(motion::SessionIndex{0}) + (lag ? sessions : 0); }
};

Layout layout_of(const JointProblem& problem, const NoiseModel& noise);

struct State {
  std::vector<RigidTransform> ins_from_lidars;
  std::vector<Vector6d> errors;  // of each node, its drift included; body axes
  std::vector<Vector6d> drifts;  // of each node, local axes for position, body axes for attitude; empty without drift
  Eigen::VectorXd shared;        // biases and offsets; those of the mountings are not used
};

/// Of a keyframe's error or drift in the keyframes' block.
inline std::size_t block_of(Eigen::Index unknown) { return static_cast<std::size_t>(unknown / 6); }

/// Everything zero but the mountings.
State start_state(const JointProblem& problem, const Layout& layout, std::vector<RigidTransform> ins_from_lidars);

/// A drift in body axes: its position part is kept in the axes of the trajectory, where it accumulates.
Matrix6d drift_in_body(const JointNode& node);

// One keyframe's part in a pair: where its error is among the unknowns, and the Jacobian of that.
struct NodePart {
  Eigen::Index at;
  Matrix6d jacobian;
};

// A term at one state: what does not depend on the noise model, so that many models are compared at one linearisation.
struct LinearTerm {
  const JointTerm* term;
  Vector6d residual;
  NodePart a, b;
  Eigen::MatrixXd shared;
  double share;  // of the registration's variance that is its own
};

std::vector<LinearTerm> linearise(const JointProblem& problem, const State& state, const Layout& layout);

/// What a second of lag of the positions does to a keyframe's pose, as an error of it [nu; omega].
Vector6d moved_by_lag(const JointNode& node);

/// Of roll and pitch that are assumed in a session; 0: they were measured.
double tilt_sigma_rad(const JointProblem& problem, motion::SessionIndex session);

/// The part of a keyframe's error that is no drift.
Vector6d white_error(const JointProblem& problem, const State& state, const Layout& layout, motion::KeyframeIndex node);

/// Covariance of the error of a keyframe's INS pose and scan, independent from keyframe to keyframe.
Matrix6d node_covariance(const JointProblem& problem, const NoiseModel& noise, motion::KeyframeIndex node);

/// Of several nodes that were taken at once, one behind the other: the INS's part is the same in all of them, the
/// scans' is not. docs/maths/rig.md (G2)
Eigen::MatrixXd covariance_at_once(const JointProblem& problem, const NoiseModel& noise, motion::KeyframeIndex first,
                                   std::size_t count);

/// How many nodes from this on were taken at once.
std::size_t taken_at_once(const JointProblem& problem, motion::KeyframeIndex node);

bool is_first_of_session(const JointProblem& problem, motion::KeyframeIndex node);

/// Inverse variances of a keyframe's drift from that of the keyframe before; of a session's first, which is zero.
Vector6d drift_step_information(const JointProblem& problem, const NoiseModel& noise, motion::KeyframeIndex node);

/// Inverse covariance of the term's residual, keyframes' errors apart.
Matrix6d term_information(const LinearTerm& linear, const NoiseModel& noise);

/// The part of the terms alone, in which of the noise model only the registrations' components are.
NormalEquations sum_terms(const JointProblem& problem, const std::vector<LinearTerm>& terms, const NoiseModel& noise,
                          const Layout& layout);
/// Whether two noise models have the same sum of terms.
bool same_terms(const NoiseModel& one, const NoiseModel& other);
void add_priors(const JointProblem& problem, const NoiseModel& noise, const State& state, const Layout& layout,
                NormalEquations& equations);
/// Both.
NormalEquations build(const JointProblem& problem, const std::vector<LinearTerm>& terms, const NoiseModel& noise,
                      const State& state, const Layout& layout);

struct Eliminated {
  bool valid = false;
  BlockCholesky factors;
  Eigen::MatrixXd reduced;  // of the shared unknowns, single beams discounted
  Eigen::MatrixXd whole;    // the same without the discount
  Eigen::MatrixXd counted;  // what of a gradient of the shared unknowns counts, once keyframes have moved along
  Eigen::VectorXd keyframe_step, shared_step;
  Eigen::VectorXd whole_keyframe_step, whole_shared_step;  // without the discount
  double minus_two_log_likelihood = 0.0;
};

/// Solves by eliminating the keyframes. `out` may be of other equations before: of the same terms and layout the order
/// of elimination is kept.
void eliminate(const NormalEquations& equations, Eliminated& out);

/// Gauss-Newton; true where it converged. `step` is the last one taken, invalid where a linearisation was singular.
bool solve_by_gauss_newton(const JointProblem& problem, const NoiseModel& noise, const Layout& layout,
                           int max_iterations, const Progress& progress, State& state, Eliminated& step);

}  // namespace remount::calibration
