#include "app/gui/workbench/session_edits.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "app/gui/workbench/edit_commands.h"
#include "messages/window.h"
#include "model/pipeline/without_session.h"

namespace remount::gui {
namespace {

/// The topic of a role as the session has it; empty for none.
std::string topic_of(const drive::Session& session, std::string_view role) {
  const drive::TopicChoice used = drive::choice_in_use(session.topics);
  const auto found = used.find(role);
  return found == used.end() ? std::string() : found->second;
}

/// What a recording offers, with what the session makes of it now.
std::vector<drive::OfferedTopic> offered_with_use(drive::TopicOffer offer, const drive::Session& session) {
  for (drive::OfferedTopic& offered : offer.topics) {
    offered.topic.used_as.clear();
    for (const drive::SessionTopic& used : session.topics)
      if (used.name == offered.topic.name && used.type == offered.topic.type) offered.topic.used_as = used.used_as;
  }
  return std::move(offer.topics);
}

}  // namespace

SessionEdits::SessionEdits(const Desk& desk, SessionList& sessions, Setup& setup, Outcome& outcome,
                           Decisions& decisions, Calibrations& calibrations)
    : WorkbenchPart(desk),
      sessions_(sessions),
      setup_(setup),
      outcome_(outcome),
      decisions_(decisions),
      calibrations_(calibrations) {}

bool SessionEdits::may_choose_topics(motion::SessionIndex session) {
  if (!sessions_.holds(session)) return false;
  if (!desk_.activity.opening() && !desk_.activity.calibrating()) return true;
  desk_.notices.say(drive::Severity::Warning, {},
                    tr("Wait until the present work is done, or cancel it, before choosing other topics."));
  return false;
}

void SessionEdits::list_topics(motion::SessionIndex session) {
  if (!desk_.engine.offer_topics || !may_choose_topics(session)) return;
  desk_.activity.start(
      Activity::Kind::Opening,
      [this, asked = sessions_.all()[session],
       offer_topics = desk_.engine.offer_topics](Progress& progress) -> JobRunner::Deliver {
        std::optional<drive::TopicOffer> offer = offer_topics(asked->path, progress);
        if (progress.cancelled()) return {};
        if (!offer) throw Error(ErrorCode::Unsupported, asked->path.string(), say::window_no_topics_any_more());
        return [this, asked, topics = offered_with_use(std::move(*offer), *asked)] {
          if (const auto place = sessions_.place_of(asked)) emit topics_listed(*place, topics);
        };
      },
      desk_.notices.report_failure());
}

void SessionEdits::choose_topics(motion::SessionIndex session, const drive::TopicChoice& choice) {
  if (!may_choose_topics(session)) return;
  const SessionPtr from = sessions_.all()[session];
  if (choice == drive::choice_in_use(from->topics)) return;
  desk_.activity.start(
      Activity::Kind::Opening,
      [this, from, choice, open = desk_.engine.open](Progress& progress) -> JobRunner::Deliver {
        const auto to = std::make_shared<const drive::Session>(open(from->path, choice, progress));
        if (progress.cancelled()) return {};
        return [this, from, to] { take_other_topics(from, to); };
      },
      desk_.notices.report_failure());
}

void SessionEdits::take_other_topics(const SessionPtr& from, const SessionPtr& to) {
  if (!sessions_.place_of(from)) return;
  const bool calibrated = outcome_.output() != nullptr;
  desk_.history.push(new TopicsCommand(*this, setup_, calibrations_, from, to));
  sessions_.tell_findings(*to);
  desk_.notices.say(drive::Severity::Note, QString::fromStdString(to->path.string()),
                    calibrated ? tr("opened with other topics. Its result belonged to the former ones: calibrate "
                                    "(F5), or undo (Ctrl+Z) to have it back.")
                               : tr("opened with other topics"));
}

void SessionEdits::remove(motion::SessionIndex session) {
  if (!sessions_.holds(session)) return;
  const SessionPtr removed = sessions_.all()[session];
  const QString path = QString::fromStdString(removed->path.string());
  if (desk_.activity.calibrating()) {
    desk_.notices.say(drive::Severity::Warning, path, tr("is being calibrated. Cancel that (Esc) before removing it."));
    return;
  }
  const bool calibrated = outcome_.output() != nullptr, part = calibrations_.is_of_output(*removed);
  desk_.history.push(new RemovalCommand(*this, calibrations_, removed, session));
  desk_.notices.say(drive::Severity::Note, path,
                    !calibrated         ? tr("removed")
                    : !part             ? tr("removed. The result was made without it and stays.")
                    : outcome_.output() ? tr("removed. No pair of it was accepted: the result stays.")
                                        : tr("removed. The result belonged to the sessions before: calibrate (F5), or "
                                             "undo (Ctrl+Z) to have it back."));
}

void SessionEdits::apply_exchange(const SessionPtr& from, const SessionPtr& to, const CalibratedPtr& calibrated) {
  const auto place = sessions_.place_of(from);
  if (!place) return;
  sessions_.put_instead(*place, to);
  calibrations_.stop_for_other_sessions();
  if (calibrated) {
    calibrations_.put_back(*calibrated);
  } else {
    if (topic_of(*from, "lidar") != topic_of(*to, "lidar")) decisions_.forget_session(*to);
    setup_.put_nominal_of(*from, *to);
  }
  sessions_.announce();
  setup_.announce_nominal();
  calibrations_.announce(calibrated);
}

CalibratedPtr SessionEdits::calibrated_without(const drive::Session& session) const {
  const CalibratedPtr all = calibrations_.calibrated();
  const CalibratedResult& now = all->result;
  const auto place = std::find_if(now.input.sessions.begin(), now.input.sessions.end(),
                                  [&](const auto& one) { return one.get() == &session; });
  const auto number = index_at<motion::SessionIndex>(place - now.input.sessions.begin());
  const auto without = [number](const pipeline::PipelineInput& input, const OutputPtr& output) -> OutputPtr {
    auto left = output ? pipeline::without_session(input, *output, number) : std::nullopt;
    return left ? std::make_shared<const pipeline::PipelineOutput>(std::move(*left)) : nullptr;
  };
  auto left = std::make_shared<Calibrated>(*all);
  CalibratedResult& result = left->result;
  result.output = without(now.input, now.output);
  if (!result.output) return nullptr;
  result.solved = now.solved == now.output ? result.output : without(now.input, now.solved);
  result.before = without(now.input, now.before);
  result.input = pipeline::input_without_session(now.input, number);
  left->selected = same_pair(now.input, now.output.get(), all->selected, result.input, *result.output);
  result.files.clear();
  result.whole_run.reset();
  if (!now.whole_run) return left;
  const WholeRun& run = *now.whole_run;
  if (const OutputPtr output = run.output == now.output ? result.output : without(run.input, run.output))
    result.whole_run = WholeRun{pipeline::input_without_session(run.input, number), output, run.decisions};
  return left;
}

void SessionEdits::apply_removal(const SessionPtr& session) {
  const bool part = calibrations_.is_of_output(*session);
  const CalibratedPtr left = part ? calibrated_without(*session) : nullptr;
  sessions_.take_away(session);
  if (!part) return sessions_.announce_beside_result();
  calibrations_.stop_for_other_sessions();
  if (left) calibrations_.put_back(*left);
  sessions_.announce();
  calibrations_.announce(left);
}

void SessionEdits::apply_return(const SessionPtr& session, motion::SessionIndex place,
                                const CalibratedPtr& calibrated) {
  sessions_.put_back(session, place);
  if (!calibrated) return sessions_.announce_beside_result();
  calibrations_.stop_for_other_sessions();
  calibrations_.put_back(*calibrated);
  sessions_.announce();
  calibrations_.announce(calibrated);
}

}  // namespace remount::gui
