#include "app/gui/workbench/session_list.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <utility>

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "app/gui/jobs/error_words.h"
#include "app/gui/workbench/edit_commands.h"
#include "app/gui/workbench/setup.h"
#include "app/gui/workbench/wording.h"
#include "messages/stages.h"
#include "model/formats/sessions/several_sessions.h"
#include "widgets/text/model_text.h"

namespace remount::gui {

SessionList::SessionList(const Desk& desk, Setup& setup) : WorkbenchPart(desk), setup_(setup) {
  connect(&desk_.activity, &Activity::opening_ended, this, [this] {
    if (!waiting_.empty()) open_all(std::exchange(waiting_, {}));
  });
}

QStringList SessionList::names() const { return names_of(sessions_); }

std::optional<motion::SessionIndex> SessionList::place_of(const SessionPtr& session) const {
  const auto place = std::find(sessions_.begin(), sessions_.end(), session);
  return place == sessions_.end() ? std::nullopt
                                  : std::optional(index_at<motion::SessionIndex>(place - sessions_.begin()));
}

void SessionList::open(const QStringList& paths) {
  std::vector<ToOpen> wanted;
  for (const QString& path : paths)
    wanted.push_back({path.toStdString(), [engine = desk_.engine, path](Progress& progress) {
                        return open_or_ask(engine, path.toStdString(), progress);
                      }});
  open_all(std::move(wanted));
}

SessionList::Opened SessionList::open_or_ask(const Engine& engine, const std::filesystem::path& path,
                                             Progress& progress) {
  std::optional<drive::TopicOffer> offer = engine.offer_topics ? engine.offer_topics(path, progress) : std::nullopt;
  if (offer && drive::is_ambiguous(offer->topics)) return {nullptr, std::move(offer), {}, false, {}, {}};
  return {std::make_shared<const drive::Session>(offer ? offer->open({}, progress) : engine.open(path, {}, progress)),
          {},
          {},
          false,
          {},
          {}};
}

void SessionList::open_chosen(const std::vector<ChosenOffer>& offers) {
  std::vector<ToOpen> wanted;
  for (const ChosenOffer& chosen : offers)
    wanted.push_back({chosen.offer.path, [chosen](Progress& progress) {
                        return Opened{
                            std::make_shared<const drive::Session>(chosen.offer.open(chosen.choice, progress)),
                            {},
                            {},
                            false,
                            {},
                            {}};
                      }});
  open_all(std::move(wanted));
}

void SessionList::open_all(std::vector<ToOpen> wanted) {
  if (desk_.activity.calibrating()) {
    desk_.notices.say(drive::Severity::Warning, {},
                      tr("Wait until the present work is done, or cancel it, before opening sessions."));
    return;
  }
  if (desk_.activity.opening()) {  // answers to several questions come one after the other
    std::move(wanted.begin(), wanted.end(), std::back_inserter(waiting_));
    return;
  }
  desk_.activity.start(
      Activity::Kind::Opening,
      [this, engine = desk_.engine, before = sessions_,
       wanted = std::move(wanted)](Progress& progress) -> JobRunner::Deliver {
        std::vector<Opened> opened(wanted.size());
        std::atomic<std::size_t> done = 0;
        parallel_for(wanted.size(), 0, [&](std::size_t i) {
          if (progress.cancelled()) return;
          // Several readers would count over each other: of several sessions, those that are open are counted.
          Progress quiet = progress.without_reports();
          try {
            opened[i] = wanted[i].open(wanted.size() > 1 ? quiet : progress);
          } catch (const formats::SeveralSessions& several) {
            for (const auto& path : several.sessions()) opened[i].below << QString::fromStdString(path.string());
          } catch (const Error& error) {
            opened[i].failure = failure_of(error);
            opened[i].unknown = error.what_happened().code().starts_with("session-unknown");
            if (opened[i].failure.where.isEmpty())
              opened[i].failure.where = QString::fromStdString(wanted[i].path.string());
          }
          if (progress.cancelled()) opened[i] = {};  // what was read of it is not all
          if (wanted.size() > 1) progress.report(say::stage_opening_sessions, ++done, wanted.size());
        });
        find_copies(engine, before, opened, progress);
        return [this, wanted, opened] {
          take_opened(opened);
          for (std::size_t i = 0; i < opened.size(); ++i)
            if (!opened[i].below.isEmpty())
              emit found_below(QString::fromStdString(wanted[i].path.string()), opened[i].below);
        };
      },
      desk_.notices.report_failure());
}

void SessionList::find_copies(const Engine& engine, const std::vector<SessionPtr>& open, std::vector<Opened>& opened,
                              const Progress& progress) {
  if (!engine.same_recording) return;
  std::vector<SessionPtr> known = open;
  for (Opened& one : opened) {
    if (!one.session || progress.cancelled()) continue;
    const auto same = std::find_if(known.begin(), known.end(), [&](const auto& other) {
      return other->path != one.session->path && engine.same_recording(*other, *one.session);
    });
    if (same == known.end())
      known.push_back(one.session);
    else
      one.copy_of = QString::fromStdString((*same)->path.string());
  }
}

void SessionList::take_opened(std::vector<Opened> opened) {
  std::vector<SessionPtr> sessions;
  std::vector<JobFailure> failures;
  QString unknown;  // the first
  std::vector<drive::TopicOffer> questions;
  for (Opened& one : opened) {
    if (one.session && !one.copy_of.isEmpty())
      desk_.notices.say(
          drive::Severity::Warning, QString::fromStdString(one.session->path.string()),
          tr("is the same recording as %1, which is open: its pairs would count as evidence twice. It was not "
             "opened.")
              .arg(one.copy_of));
    else if (one.session)
      sessions.push_back(std::move(one.session));
    if (one.question && !is_open(one.question->path, sessions)) questions.push_back(std::move(*one.question));
    if (one.unknown && unknown.isEmpty()) unknown = one.failure.where;
    if (!one.failure.what.isEmpty()) failures.push_back(std::move(one.failure));
  }
  add(sessions);
  if (failures.size() == 1) desk_.notices.say(drive::Severity::Problem, failures[0].where, failures[0].what);
  if (failures.size() > 1) say_several_failed(failures);
  if (!unknown.isEmpty()) emit not_recognised(unknown);
  if (!questions.empty()) emit topics_asked(questions);
}

bool SessionList::is_open(const std::filesystem::path& path, const std::vector<SessionPtr>& opened_now) {
  const auto there = [&](const auto& session) { return session->path == path; };
  const bool open = std::any_of(sessions_.begin(), sessions_.end(), there) ||
                    std::any_of(opened_now.begin(), opened_now.end(), there);
  if (open) desk_.notices.say(drive::Severity::Note, QString::fromStdString(path.string()), tr("is open already"));
  return open;
}

void SessionList::say_several_failed(const std::vector<JobFailure>& failures) {
  QStringList lines;
  for (const JobFailure& failure : failures) {
    desk_.notices.log(drive::Severity::Problem, failure.where, failure.what);
    lines << failure.where + QStringLiteral(": ") + failure.what.section('\n', 0, 0);
  }
  desk_.notices.say(drive::Severity::Problem, tr("%1 paths could not be opened (more in the log)").arg(failures.size()),
                    lines.join('\n'));
}

void SessionList::add(const std::vector<SessionPtr>& opened) {
  std::vector<SessionPtr> sessions;
  for (const auto& session : opened)
    if (!is_open(session->path, sessions)) sessions.push_back(session);
  if (sessions.empty()) return emit state_changed();
  const bool nominal_known = setup_.nominal_ins_from_lidar().has_value();
  for (const auto& session : sessions) {
    const QString path = QString::fromStdString(session->path.string());
    desk_.notices.say(drive::Severity::Note, path, tr("opened as %1").arg(QString::fromStdString(session->format)));
    tell_findings(*session);
    emit session_opened(path);
  }
  desk_.history.push(new OpeningCommand(*this, setup_, sessions));
  const auto brings = std::find_if(sessions.begin(), sessions.end(),
                                   [](const auto& session) { return session->nominal_ins_from_lidar.has_value(); });
  if (!nominal_known && brings != sessions.end())
    desk_.notices.say(drive::Severity::Note, QString::fromStdString((*brings)->path.string()),
                      tr("its nominal mounting is used"));
}

void SessionList::tell_findings(const drive::Session& session) {
  for (const drive::Finding& finding : session.findings) {
    const QString where = widgets::model_text(finding.where.words()), what = widgets::model_text(finding.explanation);
    // A problem spoils all that follows: it is shown while it can still be corrected.
    if (finding.severity == drive::Severity::Problem)
      desk_.notices.say(finding.severity, where, what);
    else
      desk_.notices.log(finding.severity, where, what);
    const bool log_alone = !session.scans && (!session.ins.empty() || !session.gnss.empty());
    if (finding.code == "one-stream" && log_alone) emit half_opened(QString::fromStdString(session.path.string()));
  }
}

void SessionList::apply_opening(const std::vector<SessionPtr>& sessions) {
  sessions_.insert(sessions_.end(), sessions.begin(), sessions.end());
  announce_beside_result();
}

void SessionList::apply_closing(const std::vector<SessionPtr>& sessions) {
  for (const auto& session : sessions) std::erase(sessions_, session);
  announce_beside_result();
}

void SessionList::put_back(const SessionPtr& session, motion::SessionIndex place) {
  sessions_.insert(sessions_.begin() + std::min(signed_of(place), std::ssize(sessions_)), session);
}

void SessionList::announce_beside_result() {
  desk_.activity.cancel(Activity::Kind::Calibrating);  // it is of the sessions before
  emit changed();
  emit state_changed();
  emit edited();
}

}  // namespace remount::gui
