#include "algorithms/calibration/rig/rig_problem.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algorithms/calibration/pairwise/joint_problem.h"

namespace remount::calibration {
namespace {

// A keyframe of a LiDAR, to be sorted in among those of the others: drifts walk from one to the next.
struct Placed {
  motion::SessionIndex recording;
  std::int64_t stamp_ns;
  motion::LidarIndex lidar;
  motion::KeyframeIndex keyframe;

  auto operator<=>(const Placed&) const = default;
};

std::vector<Placed> placed_keyframes(const std::vector<RigLidar>& lidars) {
  std::vector<Placed> placed;
  for (motion::LidarIndex l; l < lidars.size(); ++l)
    for (motion::KeyframeIndex k; k < lidars[l].input.nodes.size(); ++k)
      placed.push_back({lidars[l].recordings[lidars[l].input.nodes[k].session], lidars[l].keyframe_stamps_ns[k], l, k});
  std::sort(placed.begin(), placed.end());
  return placed;
}

// What a session was solved with may differ between LiDARs by what their clocks made of its samples: the worse counts.
void take_worse(const std::vector<double>& of_sessions, const std::vector<motion::SessionIndex>& recordings,
                std::vector<double>& of_recordings) {
  for (std::size_t s = 0; s < std::min(of_sessions.size(), recordings.size()); ++s) {
    const std::size_t place = recordings[s];
    if (of_recordings.size() <= place) of_recordings.resize(place + 1, 0.0);
    of_recordings[place] = std::max(of_recordings[place], of_sessions[s]);
  }
}

// All LiDARs were recorded with the same INS: the mean of what each found out about its errors, by how many pairs.
NoiseModel common_noise(const std::vector<RigLidar>& lidars, const std::vector<double>& weights) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  const auto mean = [&](double NoiseModel::*component) {
    double sum = 0.0;
    for (std::size_t l = 0; l < lidars.size(); ++l) {
      const double value = lidars[l].details.noise.*component;
      if (!(value > 0.0)) return 0.0;
      sum += weights[l] * std::log(value);
    }
    return std::exp(sum / total);
  };
  NoiseModel noise;
  noise.ins_position_sigma_m = mean(&NoiseModel::ins_position_sigma_m);
  noise.ins_attitude_sigma_rad = mean(&NoiseModel::ins_attitude_sigma_rad);
  noise.ins_position_drift = mean(&NoiseModel::ins_position_drift);
  noise.ins_attitude_drift = mean(&NoiseModel::ins_attitude_drift);
  noise.registration_scale = 1.0;
  return noise;
}

Eigen::Index beam_errors(const RigLidar& lidar) {
  return lidar.input.beams.empty() ? 0 : lidar.input.beams.nodes.errors();
}

// Of a cross pair to the errors of one of its LiDARs; without columns where it was not asked for.
Eigen::MatrixXd response_across(const std::vector<RigLidar>& lidars, const CrossPair& cross, motion::LidarIndex lidar) {
  const Eigen::Index of_a = beam_errors(lidars[cross.lidar_a]), of_b = beam_errors(lidars[cross.lidar_b]);
  const motion::BeamResponse& response = cross.pair.registration.beam_response;
  if (response.cols() != of_a + of_b) return Eigen::MatrixXd(6, 0);
  return (lidar == cross.lidar_a ? response.leftCols(of_a) : response.rightCols(of_b)).cast<double>();
}

// What pairs across tell of the errors of a LiDAR's beams: those that are alike in two scans of its own cancel there.
Eigen::MatrixXd beam_information_across(const std::vector<RigLidar>& lidars, const std::vector<CrossPair>& cross_pairs,
                                        motion::LidarIndex lidar) {
  const Eigen::Index errors = beam_errors(lidars[lidar]);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(errors, errors);
  for (const CrossPair& cross : cross_pairs) {
    if (cross.lidar_a != lidar && cross.lidar_b != lidar) continue;
    const Eigen::MatrixXd response = response_across(lidars, cross, lidar);
    if (response.cols() > 0 && cross.pair.state != motion::PairState::Rejected)
      information.noalias() += response.transpose() * (cross.pair.registration.information * response);
  }
  return information;
}

// The noise of its registrations goes into a LiDAR's own nodes and terms.
void settle_noise(const NoiseModel& noise, JointProblem& problem) {
  for (JointTerm& term : problem.terms) {
    const bool shared = !problem.nodes[term.node_a].scan_covariance.isZero(0.0);
    term.information = noise.registration_information(term.information, shared ? 1.0 - NoiseModel::kScanShare : 1.0);
    term.whole = true;
  }
  for (JointNode& node : problem.nodes) node.scan_covariance *= noise.registration_scale * noise.registration_scale;
}

}  // namespace

namespace {

// In the order of time; those of several LiDARs that were taken at once follow each other. Gives the sweep of each.
std::vector<motion::Sweep> place_nodes(const std::vector<RigLidar>& lidars, const std::vector<JointProblem>& own,
                                       RigProblem& rig) {
  const std::vector<Placed> placed = placed_keyframes(lidars);
  std::vector<motion::Sweep> sweeps;
  const Placed* first_at_once = nullptr;
  for (const Placed& here : placed) {
    JointNode node = own[here.lidar].nodes[here.keyframe];
    sweeps.push_back(sweep_of(lidars[here.lidar], node.session));
    node.session = here.recording;
    node.lidar = here.lidar;
    node.time_s = 1e-9 * static_cast<double>(here.stamp_ns - placed.front().stamp_ns);
    const auto is_with = [&](const Placed& first) {
      return first.recording == here.recording && first.lidar != here.lidar &&
             is_at_once(lidars[first.lidar], sweeps[index_at(&first - placed.data())], lidars[here.lidar],
                        sweeps.back(), 1e-9 * static_cast<double>(here.stamp_ns - first.stamp_ns));
    };
    node.at_once_with_before = first_at_once && is_with(*first_at_once);
    if (!node.at_once_with_before) first_at_once = &here;
    rig.nodes_of[here.lidar][here.keyframe] = motion::KeyframeIndex(rig.joint.nodes.size());
    rig.joint.nodes.push_back(node);
  }
  return sweeps;
}

std::vector<OverlappingSweeps> find_overlaps(const JointProblem& problem, const std::vector<motion::Sweep>& sweeps) {
  double longest_s = 0.0;
  for (const motion::Sweep& sweep : sweeps)
    longest_s = std::max({longest_s, std::abs(sweep.from_s), std::abs(sweep.until_s)});
  std::vector<OverlappingSweeps> overlaps;
  for (motion::KeyframeIndex a; a < problem.nodes.size(); ++a) {
    if (problem.nodes[a].at_once_with_before) continue;
    for (motion::KeyframeIndex b(a + 1); b < problem.nodes.size(); ++b) {
      const JointNode &of_a = problem.nodes[a], &of_b = problem.nodes[b];
      const double apart_s = of_b.time_s - of_a.time_s;
      if (of_b.session != of_a.session || apart_s > 2.0 * longest_s) break;
      if (of_b.at_once_with_before || of_a.lidar == of_b.lidar) continue;
      if (const double share = common_share(sweeps[a], sweeps[b], apart_s); share > 0.0)
        overlaps.push_back({a, b, share});
    }
  }
  return overlaps;
}

}  // namespace

double common_share(const motion::Sweep& a, const motion::Sweep& b, double b_after_a_s) {
  const double overlap_s = std::min(a.until_s, b_after_a_s + b.until_s) - std::max(a.from_s, b_after_a_s + b.from_s);
  return overlap_s > 0.0 ? overlap_s / std::sqrt(a.length_s() * b.length_s()) : 0.0;
}

Vector6d common_variance(double share, const Matrix6d& ins_at_a, const Matrix6d& ins_at_b) {
  return share * ins_at_a.diagonal().cwiseMin(ins_at_b.diagonal());
}

bool is_at_once(const RigLidar& a, const motion::Sweep& of_a, const RigLidar& b, const motion::Sweep& of_b,
                double b_after_a_s) {
  constexpr double kOneSweep = 0.9;
  const bool both_at_once = !(of_a.length_s() > 0.0) && !(of_b.length_s() > 0.0);
  return std::abs(b_after_a_s) <= std::max(a.at_once_s, b.at_once_s) &&
         (both_at_once || common_share(of_a, of_b, b_after_a_s) >= kOneSweep);
}

motion::Sweep sweep_of(const RigLidar& lidar, motion::SessionIndex session) {
  return session < lidar.sweeps.size() ? lidar.sweeps[session] : motion::Sweep();
}

RigProblem make_rig_problem(const std::vector<RigLidar>& lidars, const std::vector<CrossPair>& cross_pairs,
                            const std::vector<RigidTransform>& ins_from_lidars) {
  RigProblem rig;
  std::vector<JointProblem> own;
  std::vector<double> weights;
  rig.joint.lidars.clear();
  for (motion::LidarIndex l; l < lidars.size(); ++l) {
    const RigLidar& lidar = lidars[l];
    own.push_back(make_joint_problem(lidar.input, lidar.pairs, usable_pairs(lidar.pairs), ins_from_lidars[l],
                                     ins_from_lidars[l], beam_information_across(lidars, cross_pairs, l)));
    weights.push_back(1.0 + static_cast<double>(own.back().terms.size()));
    settle_noise(lidar.details.noise, own.back());
    rig.joint.lidars.push_back(own.back().lidar());
    rig.joint.lidars.back().clock_known = !lidar.input.clock_is_unknown;
    rig.joint.estimate_time_offset = rig.joint.estimate_time_offset || lidar.input.clock_is_unknown;
    rig.nodes_of.emplace_back(own.back().nodes.size());
    take_worse(own.back().session_attitude_bias_sigma_rad, lidar.recordings, rig.joint.session_attitude_bias_sigma_rad);
    take_worse(own.back().session_tilt_sigma_rad, lidar.recordings, rig.joint.session_tilt_sigma_rad);
    take_worse(own.back().session_position_lag_sigma_s, lidar.recordings, rig.joint.session_position_lag_sigma_s);
  }
  rig.noise = common_noise(lidars, weights);
  const std::vector<motion::Sweep> sweeps = place_nodes(lidars, own, rig);
  rig.overlaps = find_overlaps(rig.joint, sweeps);
  for (std::size_t l = 0; l < own.size(); ++l)
    for (JointTerm term : own[l].terms) {
      term.node_a = rig.nodes_of[l][term.node_a];
      term.node_b = rig.nodes_of[l][term.node_b];
      rig.joint.terms.push_back(std::move(term));
    }
  rig.pairs_within = rig.joint.terms.size();
  return rig;
}

NoiseModel noise_across(const NoiseModel& a, const NoiseModel& b) {
  NoiseModel noise = a;
  noise.registration_scale = std::max(a.registration_scale, b.registration_scale);
  noise.registration_floor_m = std::max(a.registration_floor_m, b.registration_floor_m);
  noise.registration_floor_rad = std::max(a.registration_floor_rad, b.registration_floor_rad);
  return noise;
}

namespace {

// What errors of both LiDARs' beams do to a cross pair.
void take_beams(const std::vector<RigLidar>& lidars, const RigProblem& problem, const CrossPair& cross,
                JointTerm& term) {
  const auto take = [&](motion::LidarIndex lidar, Eigen::Matrix<double, 6, Eigen::Dynamic>& out) {
    const BeamUnknowns& beams = problem.joint.lidars[lidar].beams;
    const Eigen::MatrixXd whole = response_across(lidars, cross, lidar);
    if (beams.basis.cols() == 0 || whole.cols() == 0) return;
    out = whole * beams.basis;
    term.lidar_b_from_lidar_a = perturb(term.lidar_b_from_lidar_a, whole * beams.mean);
  };
  take(cross.lidar_a, term.beam_response);
  take(cross.lidar_b, term.beam_response_b);
}

}  // namespace

void put_cross_terms(const std::vector<RigLidar>& lidars, const std::vector<CrossPair>& cross_pairs,
                     const std::vector<double>& scale2, RigProblem& problem) {
  problem.joint.terms.resize(problem.pairs_within);
  problem.cross_of_term.clear();
  for (std::size_t i = 0; i < cross_pairs.size(); ++i) {
    const auto& [lidar_a, lidar_b, pair] = cross_pairs[i];
    if (!(pair.weight > 0.0)) continue;
    JointTerm term;
    term.node_a = problem.nodes_of[lidar_a][pair.keyframe_a];
    term.node_b = problem.nodes_of[lidar_b][pair.keyframe_b];
    term.lidar_b_from_lidar_a = pair.lidar_b_from_lidar_a;
    term.weight = pair.weight;
    term.whole = true;
    const bool shared = !problem.joint.nodes[term.node_a].scan_covariance.isZero(0.0);
    term.information =
        noise_across(lidars[lidar_a].details.noise, lidars[lidar_b].details.noise)
            .registration_information(pair.registration.information, shared ? 1.0 - NoiseModel::kScanShare : 1.0) /
        scale2[i];
    take_beams(lidars, problem, cross_pairs[i], term);
    problem.joint.terms.push_back(std::move(term));
    problem.cross_of_term.push_back(i);
  }
}

}  // namespace remount::calibration
