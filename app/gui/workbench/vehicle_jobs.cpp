#include "app/gui/workbench/vehicle_jobs.h"

#include <algorithm>

#include "app/gui/workbench/decisions.h"
#include "app/gui/workbench/project_files.h"
#include "model/project/vehicle_result.h"
#include "model/rig/lidar_field.h"
#include "model/rig/rig_findings.h"

namespace remount::gui {
namespace {

constexpr std::string_view kLidarRole = "lidar";

void take_saved(VehicleLidar& lidar) {
  if (!lidar.saved) return;
  const SavedLidar saved = *lidar.saved;
  lidar.saved = nullptr;
  pipeline::PipelineInput input;
  input.sessions = lidar.sessions;
  auto calibrated = std::make_shared<Calibrated>();
  calibrated->decisions = kept_verdicts(saved.lidar.job.sessions, saved.lidar.job.verdicts);
  calibrated->result = calibrated_in(saved.lidar.job, saved.output, std::move(input));
  if (saved.output && !saved.output->pairs.empty()) calibrated->selected = motion::PairIndex{0};
  if (saved.output || !calibrated->decisions.empty()) lidar.calibrated = calibrated;
}

rig::LidarJob job_of(const LidarToSolve& to_solve, const settings::Settings& settings) {
  const VehicleLidar& lidar = to_solve.lidar;
  rig::LidarJob job;
  job.name = lidar.name();
  if (to_solve.input) {
    job.input = *to_solve.input;
  } else {
    job.input.sessions = lidar.sessions;
    job.input.settings = settings;
    job.input.nominal_ins_from_lidar = lidar.nominal_ins_from_lidar;
  }
  job.input.verdicts.clear();
  if (lidar.calibrated) job.input.verdicts = verdicts_of(job.input.sessions, lidar.calibrated->decisions);
  // An output may be of some of its recordings only, where another was opened since.
  for (const auto& session : job.input.sessions) {
    const auto place = std::ranges::find(to_solve.paths, session->path) - to_solve.paths.begin();
    job.recordings.emplace_back(lidar.recorded.recordings.at(static_cast<std::size_t>(place)).place);
  }
  return job;
}

CommonSolutionPtr common_of(std::vector<rig::LidarJob> jobs, rig::RigOutput output,
                            const std::vector<LidarToSolve>& lidars, const Progress& progress) {
  auto common = std::make_shared<CommonSolution>();
  common->file = project::make_vehicle_file(jobs, output, {});
  common->heights = rig::words_of_heights(output);
  common->surfaces = std::move(output.surfaces);
  common->cross_pairs = std::move(output.cross_pairs);
  for (std::size_t l = 0; l < jobs.size(); ++l) {
    rig::LidarOutput& lidar = output.lidars[l];
    SolvedLidar solved;
    solved.output = std::make_shared<const pipeline::PipelineOutput>(std::move(lidar.output));
    solved.alone = lidar.alone ? std::move(lidar.alone) : solved.output;
    if (lidars[l].lidar.calibrated) solved.decisions = lidars[l].lidar.calibrated->decisions;
    solved.seen_m = rig::LidarField(jobs[l].input.sessions, progress).points_in_lidar();
    solved.job = std::move(jobs[l]);
    common->lidars.push_back(std::move(solved));
  }
  return common;
}

}  // namespace

std::string lidar_of(const drive::Session& session) {
  return session.lidar_name.empty() ? "lidar" : session.lidar_name;
}

bool is_same_nominal(const std::optional<RigidTransform>& one, const std::optional<RigidTransform>& other) {
  return one.has_value() == other.has_value() && (!one || one->isApprox(*other));
}

drive::TopicChoice without_lidar(drive::TopicChoice topics) {
  topics.erase(std::string(kLidarRole));
  return topics;
}

bool keep_read_with(const std::vector<drive::TopicChoice>& topics, std::vector<SessionPtr>& sessions) {
  sessions.resize(topics.size());
  for (std::size_t s = 0; s < topics.size(); ++s)
    if (sessions[s] && without_lidar(sessions[s]->topic_choice) != without_lidar(topics[s])) sessions[s] = nullptr;
  return std::ranges::none_of(sessions, [](const SessionPtr& session) { return session == nullptr; });
}

void open_lidar(const Engine& engine, const std::vector<std::filesystem::path>& paths,
                const std::vector<drive::TopicChoice>& topics, VehicleLidar& lidar, Progress& progress) {
  const bool first = !lidar.saved && std::ranges::all_of(lidar.sessions, [](const auto& one) { return !one; });
  lidar.sessions.resize(paths.size());
  for (std::size_t r = 0; r < paths.size() && !progress.cancelled(); ++r) {
    if (lidar.sessions[r]) continue;
    lidar.sessions[r] = std::make_shared<const drive::Session>(engine.open(paths[r], topics[r], progress));
    if (first && !lidar.nominal_ins_from_lidar)
      lidar.nominal_ins_from_lidar = lidar.sessions[r]->nominal_ins_from_lidar;
  }
  if (!progress.cancelled()) take_saved(lidar);
}

CommonSolutionPtr solve_lidars(const Engine& engine, std::vector<LidarToSolve>& lidars,
                               const settings::Settings& settings, Progress& progress) {
  std::vector<rig::LidarJob> jobs;
  std::vector<OutputPtr> alone;
  for (LidarToSolve& lidar : lidars) {
    if (!lidar.input) open_lidar(engine, lidar.paths, lidar.topics, lidar.lidar, progress);
    if (progress.cancelled()) return nullptr;
    jobs.push_back(job_of(lidar, settings));
    if (lidar.alone) alone.push_back(lidar.alone);
  }
  rig::RigOutput output = alone.size() == jobs.size() ? engine.solve_rig_again(jobs, alone, progress)
                                                      : engine.calibrate_rig(jobs, progress);
  if (progress.cancelled()) return nullptr;
  return common_of(std::move(jobs), std::move(output), lidars, progress);
}

CalibratedPtr calibrated_of(const SolvedLidar& lidar, const CalibratedPtr& before) {
  auto calibrated = std::make_shared<Calibrated>();
  CalibratedResult& result = calibrated->result;
  result.input = lidar.job.input;
  result.input.verdicts.clear();
  result.output = result.solved = lidar.output;
  result.before = before ? before->result.solved : nullptr;
  result.whole_run = WholeRun{result.input, lidar.output, lidar.decisions};
  calibrated->decisions = lidar.decisions;
  calibrated->selected =
      same_pair(before ? before->result.input : result.input, before ? before->result.output.get() : nullptr,
                before ? before->selected : std::nullopt, result.input, *lidar.output);
  return calibrated;
}

CalibratedPtr decided_anew(const Calibrated& calibrated, const KeptVerdicts& decisions) {
  auto anew = std::make_shared<Calibrated>(calibrated);
  auto output = std::make_shared<pipeline::PipelineOutput>(*calibrated.result.output);
  pipeline::withdraw_verdicts(*output);
  pipeline::apply_verdicts(verdicts_of(calibrated.result.input.sessions, decisions), *output);
  anew->result.output = std::move(output);
  anew->result.solved = nullptr;
  anew->result.whole_run.reset();
  anew->decisions = decisions;
  return anew;
}

SavedLidar saved_of(const VehicleLidar& lidar, const std::vector<std::filesystem::path>& paths,
                    std::vector<drive::TopicChoice> topics, const settings::Settings& settings) {
  SavedLidar saved;
  project::Project& job = saved.lidar.job;
  saved.lidar.name = lidar.name();
  job.sessions = paths;
  job.topics = std::move(topics);
  job.settings = settings;
  job.nominal_ins_from_lidar = lidar.nominal_ins_from_lidar;
  if (!lidar.calibrated) return saved;
  const CalibratedResult& result = lidar.calibrated->result;
  job.verdicts = verdicts_of(result.output ? result.input.sessions : lidar.sessions, lidar.calibrated->decisions);
  if (!result.output) return saved;
  job.settings = result.input.settings;
  job.basis = project::basis_of(result.input);
  job.inputs = result.files;
  job.solution_pending = result.output != result.solved;
  job.confirmed = result.confirmed;
  job.exported = result.exported == Exported::Written;
  saved.output = result.output;
  return saved;
}

CommonSolutionPtr common_of_project(const results::VehicleFile& file, const std::vector<KeptVerdicts>& decisions) {
  auto common = std::make_shared<CommonSolution>();
  common->file = file;
  for (std::size_t l = 0; l < file.lidars.size(); ++l) {
    const results::LidarResult& lidar = file.lidars[l];
    SolvedLidar solved;
    solved.job.name = lidar.name;
    solved.job.input.nominal_ins_from_lidar = lidar.file.nominal_ins_from_lidar;
    auto output = std::make_shared<pipeline::PipelineOutput>();
    output->result = lidar.file.result;
    solved.output = solved.alone = output;
    solved.decisions = decisions.at(l);
    common->lidars.push_back(std::move(solved));
  }
  return common;
}

}  // namespace remount::gui
