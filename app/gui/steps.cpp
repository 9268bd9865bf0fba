#include "app/gui/steps.h"

#include <QCoreApplication>
#include <algorithm>

#include "algorithms/calibration/observability.h"
#include "model/pipeline/sharpness_stage.h"
#include "model/pipeline/stages.h"
#include "model/preliminary.h"
#include "model/result_words.h"
#include "widgets/model_text.h"
#include "widgets/pair_counts.h"

namespace remount {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(remount::steps)
};

QString not_needed() { return Words::tr("not needed"); }

/// "0.9000 m" would say more than fits: the status in a few words.
QString short_status(const CalibrationResult& result) {
  if (is_preliminary(result)) return Words::tr("preliminary: F5");
  switch (result.status) {
    case Status::Ok:
      return is_any_measured(result) ? Words::tr("all six known") : Words::tr("all six observed");
    case Status::Degenerate:
      return knows_nothing(result) ? Words::tr("nothing observed") : Words::tr("solved in part");
    case Status::TooFewPairs:
      return Words::tr("too little data");
    case Status::NotConverged:
      return Words::tr("did not converge");
    case Status::OutOfRange:
      return Words::tr("outside the range");
    case Status::Inconsistent:
      return Words::tr("contradictory pairs");
    case Status::Cancelled:
      break;
  }
  return Words::tr("cancelled");
}

/// The step that a stage of the pipeline belongs to; methods without pairs only solve.
Step step_of(const std::string& present, bool pairs) {
  if (!pairs || present == stage::kSolving || present == stage::kAligningAllClouds) return Step::Solve;
  if (present == stage::kRegisteringPairs) return Step::Align;
  return present == stage::kCheckingMap ? Step::Check : Step::Pairs;
}

/// Only one step runs at a time; what comes before it is done, but for the review, which is the user's.
void describe_run(const Workbench& workbench, std::array<StepInfo, kStepCount>& steps) {
  const bool pairs = workbench.settings().run.method == MethodChoice::Pairwise;
  const Step running = step_of(workbench.stage().toStdString(), pairs);
  for (const Step before : {Step::Pairs, Step::Align, Step::Solve})
    if (before < running) steps[static_cast<std::size_t>(before)] = {StepState::Done, pairs ? QString() : not_needed()};
  const QString stage = workbench.stage().isEmpty() ? Words::tr("calibrating…") : model_text(workbench.stage());
  steps[static_cast<std::size_t>(running)] = {StepState::Running, stage};
}

/// What speaks against the result without its residuals, before what the user says of it.
StepInfo describe_check(const PipelineOutput& output, bool confirmed, bool checking_map) {
  const bool less_sharp = std::any_of(output.findings.begin(), output.findings.end(),
                                      [](const Finding& finding) { return finding.code == kMapLessSharp; });
  if (less_sharp) return {StepState::Attention, Words::tr("map less sharp")};
  if (output.result.session_disagreement > kSessionsContradict)
    return {StepState::Attention, Words::tr("sessions contradict")};
  if (confirmed) return {StepState::Done, Words::tr("confirmed by you")};
  if (checking_map) return {StepState::Running, Words::tr("comparing the map…")};
  return {StepState::Next, Words::tr("confirm in Quality")};
}

StepInfo describe_export(Exported exported) {
  switch (exported) {
    case Exported::Written:
      return {StepState::Done, Words::tr("exported")};
    case Exported::Copied:
      return {StepState::Next, Words::tr("copied, in no file")};
    case Exported::No:
      break;
  }
  return {StepState::Next, Words::tr("ready (Ctrl+E)")};
}

/// Of those that the result does not rest on at all.
int unused_sessions(const PipelineOutput& output, std::size_t sessions) {
  if (output.method != kPairwise || output.pairs.empty()) return 0;
  const std::vector<SessionUse> uses = count_by_session(output, sessions);
  return static_cast<int>(std::count_if(uses.begin(), uses.end(), [](const SessionUse& use) { return use.unused(); }));
}

/// Pairs, alignment and review; methods without pairs need none of them.
void describe_pairs(const PipelineOutput& output, bool stale, bool confirmed, std::array<StepInfo, kStepCount>& steps) {
  const auto step = [&](Step which) -> StepInfo& { return steps[static_cast<std::size_t>(which)]; };
  const int pairs = static_cast<int>(output.pairs.size());
  const bool needed = pairs > 0 || output.method == kPairwise;
  const PairCounts counts = count_pairs(output);
  step(Step::Pairs) = {pairs > 0 || !needed ? StepState::Done : StepState::Attention,
                       needed ? Words::tr("%n pairs", nullptr, pairs) : not_needed()};
  step(Step::Align) = {(counts.aligned > 0 || !needed) && !stale && !is_preliminary(output.result)
                           ? StepState::Done
                           : StepState::Attention,
                       needed ? Words::tr("%1 of %2 aligned").arg(counts.aligned).arg(pairs) : not_needed()};
  // The user's is done when nothing is left to look at, or they say that the result is good.
  const bool reviewed = !needed || confirmed || (pairs > 0 && counts.by_user == pairs);
  step(Step::Review) = {
      counts.accepted <= counts.rejected && needed ? StepState::Attention
      : reviewed                                   ? StepState::Done
                                                   : StepState::Next,
      needed ? Words::tr("%1 accepted, %2 rejected").arg(counts.accepted).arg(counts.rejected) : not_needed()};
  if (stale) step(Step::Pairs) = {StepState::Attention, Words::tr("changed: F5 again")};
}

}  // namespace

std::array<StepInfo, kStepCount> describe_steps(const Workbench& workbench) {
  std::array<StepInfo, kStepCount> steps;
  const auto step = [&](Step which) -> StepInfo& { return steps[static_cast<std::size_t>(which)]; };
  const int sessions = static_cast<int>(workbench.sessions().size());
  if (workbench.opening()) {
    step(Step::Load) = {StepState::Running, Words::tr("opening…")};
  } else if (sessions == 0) {
    step(Step::Load) = {StepState::Next, Words::tr("open a session")};
    return steps;
  } else {
    step(Step::Load) = {StepState::Done,
                        sessions == 1 ? Words::tr("1 session") : Words::tr("%1 sessions").arg(sessions)};
  }
  if (workbench.calibrating()) {
    describe_run(workbench, steps);
    return steps;
  }
  const OutputPtr output = workbench.output();
  if (!output) {
    if (sessions > 0 && !workbench.opening()) step(Step::Pairs) = {StepState::Next, Words::tr("calibrate (F5)")};
    return steps;
  }
  const bool stale = workbench.out_of_date();
  if (const int unused = stale ? 0 : unused_sessions(*output, workbench.input_of_output().sessions.size()); unused > 0)
    step(Step::Load) = {StepState::Attention, Words::tr("%1 of %2 sessions unused").arg(unused).arg(sessions)};
  describe_pairs(*output, stale, workbench.confirmed(), steps);
  const Status status = output->result.status;
  if (workbench.solving())
    step(Step::Solve) = {StepState::Running, Words::tr("solving again…")};
  else if (stale)
    step(Step::Solve) = {StepState::Attention, Words::tr("out of date")};
  else
    step(Step::Solve) = {status == Status::Ok ? StepState::Done : StepState::Attention, short_status(output->result)};
  if (!is_usable(output->result)) return steps;
  if (stale) {
    for (const Step which : {Step::Check, Step::Export}) step(which) = {StepState::Attention, Words::tr("out of date")};
    return steps;
  }
  step(Step::Check) = describe_check(*output, workbench.confirmed(), workbench.checking_map());
  step(Step::Export) = workbench.solving()              ? StepInfo{StepState::Waiting, Words::tr("after the solution")}
                       : is_preliminary(output->result) ? StepInfo{StepState::Attention, Words::tr("preliminary")}
                                                        : describe_export(workbench.exported());
  return steps;
}

}  // namespace remount
