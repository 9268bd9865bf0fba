// The user's decisions about pairs, and the new solutions they lead to.
#include "algorithms/calibration/pair_judgement.h"
#include "app/gui/edit_commands.h"
#include "app/gui/wording.h"
#include "app/gui/workbench.h"

namespace remount {
namespace {

void set_decision(Pair& pair, const PairDecision& decision) {
  pair.state = decision.state;
  pair.decided_by = decision.decided_by;
  pair.reason = decision.reason;
}

PairDecision user_decision(int pair, PairState state) {
  return {pair, state, DecidedBy::User, state == PairState::Accepted ? "accepted by the user" : "rejected by the user"};
}

/// What a new solution from the pairs that are there takes over: the search range, and the solution's options but for
/// those that only a whole calibration obeys.
Settings solved_again_with(const Settings& of_pairs, const Settings& now) {
  Settings settings = of_pairs;
  settings.range = now.range;
  settings.solve = now.solve;
  settings.solve.apply_time_offset = of_pairs.solve.apply_time_offset;
  settings.solve.joint_clouds = of_pairs.solve.joint_clouds;
  return settings;
}

}  // namespace

PipelineInput Workbench::input_of_next_solve() const {
  PipelineInput input = run_input_;
  input.settings = solved_again_with(run_input_.settings, settings_);
  return input;
}

Workbench::DecisionKey Workbench::key_of(const PipelineInput& input, const PipelineOutput& output, const Pair& pair) {
  const Keyframe& a = output.keyframes.at(static_cast<std::size_t>(pair.keyframe_a));
  const Keyframe& b = output.keyframes.at(static_cast<std::size_t>(pair.keyframe_b));
  return {input.sessions.at(static_cast<std::size_t>(a.session))->path.string(), a.scan, b.scan};
}

bool Workbench::carry_over(const PipelineInput& input, const Decisions& decisions, PipelineOutput& output) {
  bool any = false;
  for (std::size_t i = 0; i < output.pairs.size(); ++i) {
    const auto found = decisions.find(key_of(input, output, output.pairs[i]));
    if (found == decisions.end()) continue;
    if (found->second == PairState::Accepted && !unusable_reason(output.pairs[i]).empty()) continue;
    set_decision(output.pairs[i], user_decision(static_cast<int>(i), found->second));
    any = true;
  }
  return any;
}

void Workbench::decide(const std::vector<int>& pairs, PairState state) {
  if (!output_ || calibrating()) return;
  std::vector<PairDecision> before, after;
  QStringList refused;
  for (int index : pairs) {
    const Pair& pair = output_->pairs.at(static_cast<std::size_t>(index));
    if (pair.state == state && pair.decided_by == DecidedBy::User) continue;
    if (const std::string why = unusable_reason(pair); state == PairState::Accepted && !why.empty()) {
      refused << tr("pair %1: %2").arg(index).arg(QString::fromStdString(why));
      continue;
    }
    before.push_back({index, pair.state, pair.decided_by, pair.reason});
    after.push_back(user_decision(index, state));
  }
  if (!refused.isEmpty())
    emit message(Severity::Warning, tr("Cannot be accepted, for no solution can use it"),
                 in_short(refused, QStringLiteral("\n")));
  if (after.empty()) return;
  const QString verb = state == PairState::Accepted ? tr("accept") : tr("reject");
  const QString text = after.size() == 1 ? tr("%1 pair %2").arg(verb).arg(after.front().pair)
                                         : tr("%1 %2 pairs").arg(verb).arg(after.size());
  undo_.push(new DecisionCommand(*this, text, std::move(before), std::move(after)));
}

void Workbench::apply_decisions(const std::vector<PairDecision>& decisions) {
  if (!output_) return;
  auto changed = std::make_shared<PipelineOutput>(*output_);
  for (const PairDecision& decision : decisions) {
    Pair& pair = changed->pairs.at(static_cast<std::size_t>(decision.pair));
    set_decision(pair, decision);
    const DecisionKey key = key_of(run_input_, *changed, pair);
    if (decision.decided_by == DecidedBy::User)
      decisions_[key] = decision.state;
    else
      decisions_.erase(key);
  }
  output_ = std::move(changed);
  emit output_changed();
  mark_edited();
  start_solve();
}

void Workbench::start_solve() {
  if (!output_ || calibrating()) return;
  jobs_.cancel(solve_job_);
  auto job = std::make_shared<int>(0);
  solve_job_ = jobs_.start(
      [this, job, input = input_of_next_solve(), output = *output_,
       solve = engine_.solve_again](Progress& progress) mutable -> JobRunner::Deliver {
        auto solved = std::make_shared<PipelineOutput>(std::move(output));
        solve(input, *solved, progress);
        return [this, job, solved, settings = input.settings] {
          if (*job != solve_job_ || solved->result.status == Status::Cancelled)
            return;  // a later decision is on its way
          output_before_ = output_solved_;
          output_ = output_solved_ = solved;
          run_input_.settings = settings;
          exported_ = false;
          emit output_changed();
          mark_edited();
        };
      },
      report_failure());
  *job = solve_job_;
  emit state_changed();
}

}  // namespace remount
