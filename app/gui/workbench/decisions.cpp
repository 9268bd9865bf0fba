#include "app/gui/workbench/decisions.h"

#include <algorithm>

#include "algorithms/motion/pair.h"
#include "app/gui/workbench/edit_commands.h"
#include "app/gui/workbench/wording.h"
#include "messages/decisions.h"
#include "widgets/text/model_text.h"
#include "widgets/text/pair_reasons.h"

namespace remount::gui {
namespace {

void set_decision(motion::Pair& pair, const PairDecision& decision) {
  pair.state = decision.state;
  pair.decided_by = decision.decided_by;
  pair.reason = decision.reason;
}

PairDecision user_decision(motion::PairIndex pair, motion::PairState state, Message reason) {
  if (reason.empty())
    reason = state == motion::PairState::Accepted ? say::accepted_by_the_user() : say::rejected_by_the_user();
  return {pair, state, motion::DecidedBy::User, std::move(reason)};
}

/// As if nobody had decided: the next solution judges it, unless none can use it.
PairDecision decision_of_program(const motion::Pair& pair, motion::PairIndex index) {
  const Message unusable = motion::unusable_reason(pair);
  return unusable.empty() ? PairDecision{index, motion::PairState::Proposed, motion::DecidedBy::Nobody, {}}
                          : PairDecision{index, motion::PairState::Rejected, motion::DecidedBy::Program, unusable};
}

/// "reject pair 12: moving objects".
QString step_name(const std::vector<PairDecision>& decisions, motion::PairState state, const Message& reason) {
  const std::size_t count = decisions.size();
  const motion::PairIndex pair = decisions.front().pair;
  const QString step =
      state == motion::PairState::Accepted
          ? (count == 1 ? Decisions::tr("accept pair %1").arg(pair) : Decisions::tr("accept %1 pairs").arg(count))
          : (count == 1 ? Decisions::tr("reject pair %1").arg(pair) : Decisions::tr("reject %1 pairs").arg(count));
  return reason.empty() ? step : step + QStringLiteral(": ") + widgets::reason_words(reason);
}

}  // namespace

Decisions::Decisions(const Desk& desk, SessionList& sessions, Outcome& outcome)
    : WorkbenchPart(desk), sessions_(sessions), outcome_(outcome) {}

void Decisions::decide(const std::vector<motion::PairIndex>& pairs, motion::PairState state, const Message& reason,
                       const QString& step) {
  const OutputPtr output = outcome_.output();
  if (!output || desk_.activity.calibrating()) return;
  std::vector<PairDecision> before, after;
  QStringList refused;
  for (const motion::PairIndex index : pairs) {
    if (index >= output->pairs.size()) continue;  // of a chart that shows the pairs before still
    const motion::Pair& pair = output->pairs[index];
    const PairDecision decision = user_decision(index, state, reason);
    if (pair.state == state && pair.decided_by == motion::DecidedBy::User &&
        (reason.empty() || pair.reason == decision.reason))
      continue;
    if (const Message why = motion::unusable_reason(pair); state == motion::PairState::Accepted && !why.empty()) {
      refused << tr("pair %1: %2").arg(index).arg(widgets::model_text(why));
      continue;
    }
    before.push_back({index, pair.state, pair.decided_by, pair.reason});
    after.push_back(decision);
  }
  if (!refused.isEmpty())
    desk_.notices.say(drive::Severity::Warning, tr("Cannot be accepted, for no solution can use it"),
                      in_short(refused, QStringLiteral("\n")));
  if (after.empty()) return;
  const QString text = step.isEmpty() ? step_name(after, state, reason) : step;
  desk_.history.push(new DecisionCommand(*this, text, std::move(before), std::move(after)));
}

void Decisions::take_back(const std::vector<motion::PairIndex>& pairs) {
  const OutputPtr output = outcome_.output();
  if (!output || desk_.activity.calibrating()) return;
  std::vector<PairDecision> before, after;
  for (const motion::PairIndex index : pairs) {
    if (index >= output->pairs.size()) continue;
    const motion::Pair& pair = output->pairs[index];
    if (pair.decided_by != motion::DecidedBy::User) continue;
    before.push_back({index, pair.state, pair.decided_by, pair.reason});
    after.push_back(decision_of_program(pair, index));
  }
  if (after.empty()) return;
  const QString step = after.size() == 1 ? tr("take back the decision on pair %1").arg(after.front().pair)
                                         : tr("take back the decisions on %1 pairs").arg(after.size());
  desk_.history.push(new DecisionCommand(*this, step, std::move(before), std::move(after)));
}

void Decisions::apply(const std::vector<PairDecision>& decisions, const QString& step) {
  if (!outcome_.output()) return;
  auto changed = std::make_shared<pipeline::PipelineOutput>(*outcome_.output());
  // A solution under way holds the reasons of before.
  bool counts = desk_.activity.solving() || !outcome_.whole();
  for (const PairDecision& decision : decisions) {
    motion::Pair& pair = changed->pairs.at(decision.pair);
    counts |= pair.state != decision.state || pair.decided_by != decision.decided_by;
    set_decision(pair, decision);
    const DecisionKey key = key_of(outcome_.input(), *changed, pair);
    if (decision.decided_by == motion::DecidedBy::User)
      made_[key] = {decision.state, decision.reason};
    else
      made_.erase(key);
  }
  outcome_.take_decided(std::move(changed));
  desk_.notices.log(drive::Severity::Note, {}, step);
  emit applied(step, counts);
  outcome_.announce();
  emit edited();
}

void Decisions::impose_on(pipeline::PipelineOutput& output) const {
  pipeline::withdraw_verdicts(output);
  pipeline::apply_verdicts(verdicts(), output);
}

std::vector<pipeline::PairVerdict> Decisions::verdicts() const { return verdicts_of(sessions_.all(), made_); }

std::vector<pipeline::PairVerdict> verdicts_of(const std::vector<SessionPtr>& sessions, const KeptVerdicts& made) {
  std::vector<pipeline::PairVerdict> verdicts;
  for (const auto& [key, verdict] : made) {
    const auto& [path, stamp_a_ns, stamp_b_ns] = key;
    const auto of = std::find_if(sessions.begin(), sessions.end(),
                                 [&, &path = path](const auto& session) { return session->path.string() == path; });
    if (of != sessions.end())
      verdicts.push_back({index_at<motion::SessionIndex>(of - sessions.begin()), stamp_a_ns, stamp_b_ns, verdict.state,
                          verdict.reason});
  }
  return verdicts;
}

KeptVerdicts kept_verdicts(const std::vector<std::filesystem::path>& paths,
                           const std::vector<pipeline::PairVerdict>& verdicts) {
  KeptVerdicts made;
  for (const pipeline::PairVerdict& verdict : verdicts)
    if (verdict.session < paths.size())
      made[{paths[verdict.session].string(), verdict.stamp_a_ns, verdict.stamp_b_ns}] = {verdict.state, verdict.reason};
  return made;
}

void Decisions::put_saved(const std::vector<pipeline::PairVerdict>& verdicts) {
  std::vector<std::filesystem::path> paths;
  for (const SessionPtr& session : sessions_.all()) paths.push_back(session->path);
  made_ = kept_verdicts(paths, verdicts);
  const OutputPtr output = outcome_.output();
  for (std::size_t i = 0; output && i < output->pairs.size(); ++i)
    if (output->pairs[i].decided_by == motion::DecidedBy::User)
      made_[key_of(outcome_.input(), *output, output->pairs[i])] = {output->pairs[i].state, output->pairs[i].reason};
}

void Decisions::forget_session(const drive::Session& session) {
  std::erase_if(made_, [&](const auto& made) { return std::get<0>(made.first) == session.path.string(); });
}

}  // namespace remount::gui
