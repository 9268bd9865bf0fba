#include "model/rig/rig_calibration.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "messages/rig.h"
#include "messages/stages.h"
#include "model/methods/calibrate.h"
#include "model/pipeline/first_answer.h"
#include "model/pipeline/offset_search.h"
#include "model/pipeline/solve_stage.h"
#include "model/rig/cross_pairs.h"
#include "model/rig/rig_findings.h"
#include "model/rig/swept_time.h"

namespace remount::rig {
namespace {

// Scans of two LiDARs that are no further apart than a tenth of the steps of the INS have its errors in common.
double at_once_s(const drive::Session& session) {
  constexpr double kShare = 0.1;
  std::vector<double> steps_s;
  const auto step = [&](std::int64_t before_ns, std::int64_t now_ns) {
    steps_s.push_back(seconds(now_ns - before_ns));
  };
  for (std::size_t i = 1; i < session.ins.size(); ++i) step(session.ins[i - 1].stamp_ns, session.ins[i].stamp_ns);
  for (std::size_t i = 1; i < session.world_from_ins.size(); ++i)
    step(session.world_from_ins[i - 1].stamp_ns, session.world_from_ins[i].stamp_ns);
  return steps_s.empty() ? 0.0 : kShare * median_of(steps_s);
}

// All LiDARs of a recording have one INS: a lag of its positions that some took out is taken out for all, by the mean
// of what these found.
void share_lags(CalibratedLidars& lidars) {
  struct Found {
    double weight = 0.0, weighted_s = 0.0;
  };
  std::map<motion::SessionIndex, Found> of_recordings;
  const auto each_session = [&](auto&& visit) {
    for (auto& lidar : lidars)
      for (motion::SessionIndex s; s < lidar->job.recordings.size(); ++s) visit(*lidar, s, lidar->job.recordings[s]);
  };
  each_session([&](CalibratedLidar& lidar, motion::SessionIndex session, motion::SessionIndex recording) {
    const calibration::CalibrationResult& result = lidar.output.result;
    if (!result.position_lag_applied || session >= result.session_position_lag_s.size()) return;
    const double sigma_s = result.session_position_lag_sigma_s.at(session);
    if (!(sigma_s > 0.0)) return;
    of_recordings[recording].weight += 1.0 / (sigma_s * sigma_s);
    of_recordings[recording].weighted_s += result.session_position_lag_s[session] / (sigma_s * sigma_s);
  });
  each_session([&](CalibratedLidar& lidar, motion::SessionIndex session, motion::SessionIndex recording) {
    const auto found = of_recordings.find(recording);
    if (found != of_recordings.end())
      lidar.motion.set_position_lag_s(session, found->second.weighted_s / found->second.weight);
  });
}

calibration::RigLidar rig_lidar(const CalibratedLidar& lidar) {
  calibration::RigLidar out;
  out.name = lidar.job.name;
  out.input = pipeline::solver_input(lidar.job.input, lidar.motion, lidar.output);
  out.pairs = lidar.output.pairs;
  pipeline::set_ins_motion(out.input.nodes, out.pairs);
  out.alone = lidar.output.result;
  out.details = *lidar.output.details;
  out.recordings = lidar.job.recordings;
  for (const motion::Keyframe& keyframe : lidar.output.keyframes)
    out.keyframe_stamps_ns.push_back(lidar.ins_stamp_ns(keyframe));
  for (const auto& session : lidar.job.input.sessions) out.at_once_s = std::max(out.at_once_s, at_once_s(*session));
  out.sweeps = averaged_times(lidar.motion, lidar.output);
  return out;
}

// Before any of them is calibrated, which may take long.
void check_nominal_of(const LidarJob& job) {
  try {
    methods::check_nominal(job.input);
  } catch (const Error& error) {
    throw Error(error.code(), error.where() + " of " + job.name, error.what_happened());
  }
}

void check_jobs(const std::vector<LidarJob>& jobs) {
  if (jobs.empty()) throw Error(ErrorCode::Contract, "", say::rig_no_lidar());
  for (const LidarJob& job : jobs) {
    if (job.recordings.size() != job.input.sessions.size())
      throw Error(ErrorCode::Contract, job.name, say::rig_recordings_of_sessions());
    if (job.input.settings.run.method->id != calibration::kPairwise)
      throw Error(ErrorCode::Contract, job.name, say::rig_needs_pairwise());
    for (const LidarJob& other : jobs)
      if (&other != &job && other.name == job.name) throw Error(ErrorCode::Contract, job.name, say::rig_lidar_twice());
    check_nominal_of(job);
  }
}

bool takes_part(const pipeline::PipelineOutput& output) {
  return calibration::is_usable(output.result) && output.details != nullptr;
}

// A LiDAR whose drives contradict each other, where those of another agree: not the INS changed, but the LiDAR. Where
// those of all do, it was rather the INS.
void find_moved(RigOutput& output) {
  const auto differs = [](const LidarOutput& lidar) {
    return lidar.output.result.session_disagreement > calibration::kSessionsContradict;
  };
  // One that has a single drive bears no witness: its number is none.
  const bool others_agree = std::ranges::any_of(output.lidars, [&](const LidarOutput& lidar) {
    return takes_part(lidar.output) && lidar.output.result.session_disagreement <= calibration::kSessionsContradict;
  });
  const auto differ = std::ranges::count_if(
      output.lidars, [&](const LidarOutput& lidar) { return takes_part(lidar.output) && differs(lidar); });
  output.all_drives_differ = !others_agree && differ > 1;
  for (LidarOutput& lidar : output.lidars)
    if (others_agree && differs(lidar)) lidar.drives_differ = lidar.output.result.session_disagreement;
}

// The places of LiDARs that took part become their places among all.
void name_among_all(const std::vector<motion::LidarIndex>& places, RigOutput& output) {
  const auto rename = [&](auto& of) {
    of.lidar_a = places[of.lidar_a];
    of.lidar_b = places[of.lidar_b];
  };
  for (auto& one : output.cross_pairs) rename(one);
  for (auto& one : output.relatives) rename(one);
  for (auto& one : output.agreements) rename(one);
  for (auto& one : output.surfaces) rename(one);
  for (auto& group : output.groups)
    for (motion::LidarIndex& lidar : group) lidar = places[lidar];
}

void solve_together(const std::vector<LidarJob>& jobs, RigOutput& output, Progress& progress) {
  std::vector<motion::LidarIndex> places;
  for (motion::LidarIndex l; l < jobs.size(); ++l)
    if (takes_part(output.lidars[l].output) && !output.lidars[l].drives_differ) places.push_back(l);
  if (places.size() < 2) return;
  CalibratedLidars lidars;
  std::vector<calibration::RigLidar> of_solver;
  const std::size_t cache_bytes = static_cast<std::size_t>(jobs.front().input.settings.run.cache_mb) << 20;
  for (const motion::LidarIndex place : places) {
    lidars.push_back(std::make_unique<CalibratedLidar>(jobs[place], output.lidars[place].output,
                                                       cache_bytes / places.size(), progress));
  }
  share_lags(lidars);
  for (const auto& lidar : lidars) of_solver.push_back(rig_lidar(*lidar));
  const int threads = jobs.front().input.threads;
  std::vector<calibration::CrossPair> cross_pairs = propose_cross_pairs(lidars);
  register_cross_pairs(lidars, cross_pairs, threads, progress);
  progress.report(say::stage_solving_all_lidars, 0, 0);
  calibration::RigSolution solution = solve_rig(of_solver, cross_pairs, progress);
  if (solution.solved && jobs.front().input.settings.solve.joint_clouds) {
    std::vector<calibration::CrossPair> anew = cross_pairs;
    relinearise_cross_pairs(lidars, solution.cross_motions, anew, threads, progress);
    calibration::RigSolution again = solve_rig(of_solver, anew, progress);
    if (again.solved) {  // a good solution is not given up for none
      solution = std::move(again);
      cross_pairs = std::move(anew);
    }
  }
  if (progress.cancelled()) solution = {};
  if (solution.solved)
    output.surfaces = compare_surfaces(lidars, cross_pairs, solution.ins_from_lidars, threads, progress);
  output.cross_pairs = std::move(cross_pairs);
  output.solved = solution.solved;
  for (std::size_t l = 0; solution.solved && l < places.size(); ++l) {
    pipeline::PipelineOutput& lidar = output.lidars[places[l]].output;
    output.lidars[places[l]].alone = std::make_shared<const pipeline::PipelineOutput>(lidar);
    lidar.result = std::move(solution.results[l]);
    pipeline::answer_with(lidar.result.mounting.ins_from_lidar(), lidar);
    output.lidars[places[l]].joined = true;
  }
  output.relatives = std::move(solution.relatives);
  output.agreements = std::move(solution.agreements);
  output.groups = std::move(solution.groups);
  output.covariance = std::move(solution.covariance);
  name_among_all(places, output);
}

void join(const std::vector<LidarJob>& jobs, RigOutput& output, Progress& progress) {
  if (jobs.size() < 2 || progress.cancelled()) return;
  find_moved(output);
  solve_together(jobs, output, progress);
  if (!progress.cancelled()) report_rig(output);
}

}  // namespace

bool measures_one_lidar(const settings::Settings& settings) {
  const calibration::MeasuredOptions& measured = settings.measured;
  return measured.x_sigma_m > 0.0 || measured.y_sigma_m > 0.0 || measured.z_sigma_m > 0.0 ||
         measured.yaw_sigma_deg > 0.0 || measured.pitch_sigma_deg > 0.0 || measured.roll_sigma_deg > 0.0;
}

RigOutput calibrate_rig(const std::vector<LidarJob>& jobs, Progress& progress) {
  check_jobs(jobs);
  RigOutput output;
  for (const LidarJob& job : jobs) output.lidars.push_back({job.name, methods::calibrate(job.input, progress)});
  join(jobs, output, progress);
  return output;
}

RigOutput solve_rig_again(const std::vector<LidarJob>& jobs,
                          const std::vector<std::shared_ptr<const pipeline::PipelineOutput>>& alone,
                          Progress& progress) {
  check_jobs(jobs);
  RigOutput output;
  for (std::size_t l = 0; l < jobs.size(); ++l) output.lidars.push_back({jobs[l].name, *alone.at(l)});
  join(jobs, output, progress);
  return output;
}

}  // namespace remount::rig
