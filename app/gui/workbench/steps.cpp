#include "app/gui/workbench/steps.h"

#include <QCoreApplication>
#include <algorithm>

#include "algorithms/calibration/observability.h"
#include "algorithms/core/index.h"
#include "messages/stages.h"
#include "model/method_registry/calibration_method.h"
#include "model/pipeline/sharpness_stage.h"
#include "model/results/preliminary.h"
#include "model/results/result_words.h"
#include "model/results/vehicle_file.h"
#include "widgets/basics/rows.h"
#include "widgets/text/model_text.h"
#include "widgets/text/pair_counts.h"

namespace remount::gui {

using widgets::Step;
// Without its namespace below: lupdate takes that of a returned type for a part of the function's name.
using widgets::StepInfo;
using widgets::StepState;

namespace {

struct StepText {
  Q_DECLARE_TR_FUNCTIONS(remount::gui::steps)
};

QString not_needed() { return StepText::tr("not needed"); }

/// "0.9000 m" would say more than fits: the status in a few words.
QString short_status(const calibration::CalibrationResult& result) {
  if (results::is_preliminary(result)) return StepText::tr("preliminary: F5");
  switch (result.status) {
    case calibration::Status::Ok:
      return calibration::is_any_measured(result) ? StepText::tr("all six known") : StepText::tr("all six observed");
    case calibration::Status::Degenerate:
      return results::knows_nothing(result) ? StepText::tr("nothing observed") : StepText::tr("solved in part");
    case calibration::Status::TooFewPairs:
      return StepText::tr("too few pairs");
    case calibration::Status::TooLittleData:
      return StepText::tr("too little data");
    case calibration::Status::NoUsableData:
      return StepText::tr("nothing to use");
    case calibration::Status::NotConverged:
      return StepText::tr("did not converge");
    case calibration::Status::OutOfRange:
      return StepText::tr("outside the range");
    case calibration::Status::Inconsistent:
      return StepText::tr("contradictory data");
    case calibration::Status::Cancelled:
      break;
  }
  return StepText::tr("cancelled");
}

/// The step that a stage of the pipeline belongs to; methods without pairs only solve.
Step step_of(const Message& present, bool pairs) {
  if (!pairs || present == say::stage_solving() || present == say::stage_aligning_all_clouds()) return Step::Solve;
  if (present == say::stage_registering_pairs()) return Step::Align;
  return present == say::stage_checking_the_map() ? Step::Check : Step::Pairs;
}

/// Only one step runs at a time; what comes before it is done, but for the review, which is the user's.
void describe_run(const Workbench& workbench, std::array<StepInfo, widgets::kStepCount>& steps) {
  const bool pairs = workbench.setup().settings().run.method->id == calibration::kPairwise;
  const Step running = step_of(workbench.activity().stage(), pairs);
  for (const Step before : {Step::Pairs, Step::Align, Step::Solve})
    if (before < running) steps[index_of(before)] = {StepState::Done, pairs ? QString() : not_needed()};
  const QString stage = workbench.activity().stage().empty() ? StepText::tr("calibrating…")
                                                             : widgets::model_text(workbench.activity().stage());
  steps[index_of(running)] = {StepState::Running, stage};
}

/// The problem that LiDARs have with each other or with their drives; null: none.
const drive::Finding* problem_of_vehicle(const Vehicle& vehicle) {
  const CommonSolutionPtr& common = vehicle.common();
  if (!common || !vehicle.up_to_date()) return nullptr;
  const std::vector<drive::Finding>& findings = common->file.findings;
  const auto problem = std::ranges::find(findings, drive::Severity::Problem, &drive::Finding::severity);
  return problem == findings.end() ? nullptr : &*problem;
}

/// What speaks against the result without its residuals, before what the user says of it.
StepInfo describe_check(const pipeline::PipelineOutput& output, const Vehicle& vehicle, bool confirmed,
                        bool checking_map) {
  if (const drive::Finding* problem = problem_of_vehicle(vehicle))
    return {StepState::Attention, problem->code == results::kLidarsContradict ? StepText::tr("LiDARs contradict")
                                                                              : StepText::tr("drives contradict")};
  const bool less_sharp =
      std::any_of(output.findings.begin(), output.findings.end(),
                  [](const drive::Finding& finding) { return finding.code == pipeline::kMapLessSharp; });
  if (less_sharp) return {StepState::Attention, StepText::tr("map less sharp")};
  if (output.result.session_disagreement > calibration::kSessionsContradict)
    return {StepState::Attention, StepText::tr("sessions contradict")};
  if (confirmed) return {StepState::Done, StepText::tr("confirmed by you")};
  if (checking_map) return {StepState::Running, StepText::tr("comparing the map…")};
  return {StepState::Next, StepText::tr("confirm in Quality")};
}

StepInfo describe_export(Exported exported) {
  switch (exported) {
    case Exported::Written:
      return {StepState::Done, StepText::tr("exported")};
    case Exported::Copied:
      return {StepState::Next, StepText::tr("copied, in no file")};
    case Exported::No:
      break;
  }
  return {StepState::Next, StepText::tr("ready (Ctrl+E)")};
}

/// Of those that the result does not rest on at all.
int unused_sessions(const pipeline::PipelineOutput& output, std::size_t sessions) {
  if (!method_registry::is_from_pairs(output.method) || output.pairs.empty()) return 0;
  const std::vector<widgets::SessionUse> uses = widgets::count_by_session(output, sessions);
  return static_cast<int>(
      std::count_if(uses.begin(), uses.end(), [](const widgets::SessionUse& use) { return use.unused(); }));
}

/// Pairs, alignment and review; methods without pairs need none of them.
void describe_pairs(const pipeline::PipelineOutput& output, bool stale, bool confirmed,
                    std::array<StepInfo, widgets::kStepCount>& steps) {
  const auto step = [&](Step which) -> widgets::StepInfo& { return steps[index_of(which)]; };
  const int pairs = widgets::qt_count(output.pairs.size());
  const bool needed = pairs > 0 || method_registry::is_from_pairs(output.method);
  const widgets::PairCounts counts = widgets::count_pairs(output);
  step(Step::Pairs) = {pairs > 0 || !needed ? StepState::Done : StepState::Attention,
                       needed ? StepText::tr("%n pairs", nullptr, pairs) : not_needed()};
  step(Step::Align) = {(counts.aligned > 0 || !needed) && !stale && !results::is_preliminary(output.result)
                           ? StepState::Done
                           : StepState::Attention,
                       needed ? StepText::tr("%1 of %2 aligned").arg(counts.aligned).arg(pairs) : not_needed()};
  // The user's is done when nothing is left to look at, or they say that the result is good.
  const bool reviewed = !needed || confirmed || (pairs > 0 && counts.by_user == pairs);
  step(Step::Review) = {
      counts.accepted <= counts.rejected && needed ? StepState::Attention
      : reviewed                                   ? StepState::Done
                                                   : StepState::Next,
      needed ? StepText::tr("%1 accepted, %2 rejected").arg(counts.accepted).arg(counts.rejected) : not_needed()};
  if (stale) step(Step::Pairs) = {StepState::Attention, StepText::tr("changed: F5 again")};
}

}  // namespace

std::array<StepInfo, widgets::kStepCount> describe_steps(const Workbench& workbench) {
  std::array<StepInfo, widgets::kStepCount> steps;
  const auto step = [&](Step which) -> widgets::StepInfo& { return steps[index_of(which)]; };
  const int sessions = widgets::qt_count(workbench.sessions().all().size());
  if (workbench.activity().opening()) {
    step(Step::Load) = {StepState::Running, StepText::tr("opening…")};
  } else if (sessions == 0) {
    step(Step::Load) = {StepState::Next, StepText::tr("open a session")};
    return steps;
  } else {
    step(Step::Load) = {StepState::Done,
                        sessions == 1 ? StepText::tr("1 session") : StepText::tr("%1 sessions").arg(sessions)};
  }
  if (workbench.activity().calibrating()) {
    describe_run(workbench, steps);
    return steps;
  }
  const OutputPtr output = workbench.outcome().output();
  if (!output) {
    if (sessions > 0 && !workbench.activity().opening())
      step(Step::Pairs) = {StepState::Next, StepText::tr("calibrate (F5)")};
    return steps;
  }
  const bool stale = workbench.calibrations().out_of_date();
  if (const int unused = stale ? 0 : unused_sessions(*output, workbench.outcome().input().sessions.size()); unused > 0)
    step(Step::Load) = {StepState::Attention, StepText::tr("%1 of %2 sessions unused").arg(unused).arg(sessions)};
  describe_pairs(*output, stale, workbench.outcome().confirmed(), steps);
  const calibration::Status status = output->result.status;
  if (workbench.activity().solving())
    step(Step::Solve) = {StepState::Running, StepText::tr("solving again…")};
  else if (stale)
    step(Step::Solve) = {StepState::Attention, StepText::tr("out of date")};
  else
    step(Step::Solve) = {status == calibration::Status::Ok ? StepState::Done : StepState::Attention,
                         short_status(output->result)};
  if (!calibration::is_usable(output->result)) return steps;
  if (stale) {
    for (const Step which : {Step::Check, Step::Export})
      step(which) = {StepState::Attention, StepText::tr("out of date")};
    return steps;
  }
  step(Step::Check) =
      describe_check(*output, workbench.vehicle(), workbench.outcome().confirmed(), workbench.map_checks().checking());
  step(Step::Export) =
      workbench.activity().solving() ? widgets::StepInfo{StepState::Waiting, StepText::tr("after the solution")}
      : results::is_preliminary(output->result) ? widgets::StepInfo{StepState::Attention, StepText::tr("preliminary")}
                                                : describe_export(workbench.outcome().exported());
  return steps;
}

}  // namespace remount::gui
