// How all LiDARs of a vehicle are solved together.
#include <algorithm>

#include "app/gui/workbench/vehicle.h"
#include "app/gui/workbench/vehicle_command.h"
#include "messages/rig.h"
#include "widgets/text/model_text.h"

namespace remount::gui {

QString in_words(const VehicleStep& step) {
  switch (step.kind) {
    case VehicleStep::Kind::Calibrated:
      return Vehicle::tr("calibration of all LiDARs");
    case VehicleStep::Kind::SolvedAgain:
      return Vehicle::tr("common solution of all LiDARs");
    case VehicleStep::Kind::Nominals:
      return Vehicle::tr("nominal mountings of all LiDARs");
    default:
      return Vehicle::tr("show LiDAR %1").arg(QString::fromStdString(step.lidar));
  }
}

bool Vehicle::may_solve(std::size_t lidars) {
  if (desk_.activity.opening() || desk_.activity.calibrating()) return false;
  Message problem;
  if (const std::vector<Message> problems = parts_.setup.settings().check(); !problems.empty())
    problem = problems.front();
  else if (parts_.setup.settings().run.method->id != calibration::kPairwise)
    problem = say::rig_needs_pairwise();
  else if (rig::measures_one_lidar(parts_.setup.settings()))
    problem = say::rig_measured_of_one();
  if (lidars >= 2 && problem.empty()) return true;
  desk_.notices.say(
      drive::Severity::Warning, tr("LiDARs"),
      problem.empty() ? tr("Tick two LiDARs or more: one is calibrated by F5.") : widgets::model_text(problem));
  return false;
}

void Vehicle::calibrate() {
  std::vector<LidarToSolve> ticked;
  for (VehicleLidar& lidar : state().lidars)
    if (lidar.ticked) {
      LidarToSolve& one = ticked.emplace_back(LidarToSolve{std::move(lidar), {}, {}, {}, nullptr});
      one.paths = paths_of(one.lidar);
      one.topics = topics_of(one.lidar);
      (void)keep_read_with(one.topics, one.lidar.sessions);
    }
  if (!may_solve(ticked.size())) return;
  desk_.notices.say(drive::Severity::Note, {}, tr("Calibration of %1 LiDARs started").arg(ticked.size()));
  start(std::move(ticked), {VehicleStep::Kind::Calibrated});
}

std::optional<LidarToSolve> Vehicle::to_solve_again(const SolvedLidar& solved, const VehicleState& now) {
  const auto lidar = std::ranges::find(now.lidars, solved.job.name, &VehicleLidar::name);
  if (lidar == now.lidars.end()) return {};
  const auto place = index_at<motion::LidarIndex>(lidar - now.lidars.begin());
  if (!is_same_nominal(nominal_of(place), solved.job.input.nominal_ins_from_lidar)) return {};
  LidarToSolve one{*lidar, paths_of(*lidar), topics_of(*lidar), {}, nullptr};
  one.alone = is_as_solved(place) ? solved.alone : output_of(place);
  if (!one.alone || !one.alone->details || !lidar->calibrated ||
      lidar->calibrated->result.solved != lidar->calibrated->result.output)
    return {};
  one.input = lidar->calibrated->result.input;
  one.input->settings = solved_again_with(one.input->settings, parts_.setup.settings());
  const std::vector<drive::TopicChoice> topics = topics_of(*lidar);
  std::vector<drive::TopicChoice> of_input;
  for (const auto& session : one.input->sessions)
    if (const auto at = std::ranges::find(one.paths, session->path); at != one.paths.end())
      of_input.push_back(topics[static_cast<std::size_t>(at - one.paths.begin())]);
  std::vector<SessionPtr> sessions = one.input->sessions;
  if (of_input.size() != sessions.size() || !keep_read_with(of_input, sessions)) return {};
  return one;
}

void Vehicle::solve_again() {
  const VehicleState now = state();
  if (!now.common || !may_solve(now.common->lidars.size())) return;
  std::vector<LidarToSolve> lidars;
  for (const SolvedLidar& solved : now.common->lidars) {
    const std::optional<LidarToSolve> one = to_solve_again(solved, now);
    if (!one)
      return desk_.notices.say(
          drive::Severity::Warning, QString::fromStdString(solved.job.name),
          tr("has no whole solution with these recordings and this nominal mounting that could be solved again. "
             "Calibrate all LiDARs again."));
    lidars.push_back(*one);
  }
  desk_.notices.say(drive::Severity::Note, {}, tr("Common solution of %1 LiDARs started").arg(lidars.size()));
  start(std::move(lidars), {VehicleStep::Kind::SolvedAgain});
}

void Vehicle::start(std::vector<LidarToSolve> lidars, const VehicleStep& step) {
  desk_.activity.start(
      Activity::Kind::Calibrating,
      [this, lidars = std::move(lidars), settings = parts_.setup.settings(), step, engine = desk_.engine,
       begun_with = bench(), known = known_](Progress& progress) mutable -> JobRunner::Deliver {
        const CommonSolutionPtr common = solve_lidars(engine, lidars, settings, progress);
        return [this, lidars, common, step, begun_with, known] {
          if (common && known == known_) return take(lidars, common, begun_with, step);
          desk_.notices.say(drive::Severity::Warning, tr("LiDARs"),
                            common ? tr("The calibration was of other sessions than there are now: it is left out.")
                                   : tr("Cancelled. The results that were there are kept."));
          parts_.solutions.resume();
        };
      },
      [this](const JobFailure& failure) {
        desk_.notices.say(drive::Severity::Problem, failure.where, failure.what);
        parts_.solutions.resume();
      });
}

void Vehicle::take(const std::vector<LidarToSolve>& solved, const CommonSolutionPtr& common, const Bench& begun_with,
                   const VehicleStep& step) {
  const VehicleState before = state();
  VehicleState after = before;
  after.common = common;
  const std::optional<motion::LidarIndex> on_bench = shown();
  for (std::size_t l = 0; l < solved.size(); ++l) {
    const auto lidar = std::ranges::find(after.lidars, solved[l].lidar.name(), &VehicleLidar::name);
    if (lidar == after.lidars.end()) continue;
    const bool is_shown = on_bench && after.lidars[*on_bench].name() == lidar->name();
    const CalibratedPtr was = lidar->calibrated;
    lidar->saved = nullptr;
    lidar->calibrated = calibrated_of(common->lidars[l], was);
    if (!is_shown) {
      lidar->sessions = solved[l].lidar.sessions;
      lidar->nominal_ins_from_lidar = solved[l].lidar.nominal_ins_from_lidar;
      continue;
    }
    // They may have been undone, or made, while it ran.
    const KeptVerdicts decisions = was ? was->decisions : KeptVerdicts();
    if (decisions != (begun_with.calibrated ? begun_with.calibrated->decisions : KeptVerdicts()))
      lidar->calibrated = decided_anew(*lidar->calibrated, decisions);
    after.bench.calibrated = lidar->calibrated;
  }
  desk_.history.push(new VehicleCommand(*this, step, before, after));
  tell(*common);
}

void Vehicle::tell(const CommonSolution& common) {
  const auto log = [&](const drive::Finding& finding) {
    desk_.notices.log(finding.severity, widgets::model_text(finding.where.words()),
                      widgets::model_text(finding.explanation));
  };
  std::size_t joined = 0;
  for (const SolvedLidar& lidar : common.lidars)
    for (const drive::Finding& finding : lidar.output->findings) log(finding);
  for (const drive::Finding& finding : common.file.findings) log(finding);
  for (const results::LidarResult& lidar : common.file.lidars) joined += lidar.joined ? 1 : 0;
  desk_.notices.say(joined == common.lidars.size() ? drive::Severity::Note : drive::Severity::Warning, tr("LiDARs"),
                    tr("%1 of %2 LiDARs were solved together.").arg(joined).arg(common.lidars.size()));
}

}  // namespace remount::gui
