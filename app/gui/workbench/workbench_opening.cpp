// Sessions are opened: several at once, in the background, and not the same recording twice.
#include <algorithm>
#include <atomic>
#include <iterator>
#include <utility>

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "app/gui/jobs/error_words.h"
#include "app/gui/workbench/edit_commands.h"
#include "app/gui/workbench/workbench.h"
#include "messages/stages.h"
#include "model/formats/sessions/several_sessions.h"
#include "widgets/text/model_text.h"

namespace remount {

void Workbench::open(const QStringList& paths) {
  std::vector<ToOpen> wanted;
  for (const QString& path : paths)
    wanted.push_back({path.toStdString(), [engine = engine_, path](Progress& progress) {
                        return open_or_ask(engine, path.toStdString(), progress);
                      }});
  open_all(std::move(wanted));
}

void Workbench::open_all(std::vector<ToOpen> wanted) {
  if (calibrating()) {
    emit message(Severity::Warning, {},
                 tr("Wait until the present work is done, or cancel it, before opening sessions."));
    return;
  }
  if (opening()) {  // answers to several questions come one after the other
    std::move(wanted.begin(), wanted.end(), std::back_inserter(waiting_));
    return;
  }
  open_job_ = jobs_.start(
      [this, engine = engine_, before = sessions_,
       wanted = std::move(wanted)](Progress& progress) -> JobRunner::Deliver {
        std::vector<Opened> opened(wanted.size());
        std::atomic<std::size_t> done = 0;
        parallel_for(wanted.size(), 0, [&](std::size_t i) {
          if (progress.cancelled()) return;
          // Several readers would count over each other: of several sessions, those that are open are counted.
          Progress quiet = progress.without_reports();
          try {
            opened[i] = wanted[i].open(wanted.size() > 1 ? quiet : progress);
          } catch (const SeveralSessions& several) {
            for (const auto& path : several.sessions()) opened[i].below << QString::fromStdString(path.string());
          } catch (const Error& error) {
            opened[i].failure = failure_of(error);
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
              emit sessions_found(QString::fromStdString(wanted[i].path.string()), opened[i].below);
        };
      },
      report_failure());
  emit state_changed();
}

void Workbench::find_copies(const Engine& engine, const std::vector<std::shared_ptr<const Session>>& open,
                            std::vector<Opened>& opened, const Progress& progress) {
  if (!engine.same_recording) return;
  std::vector<std::shared_ptr<const Session>> known = open;
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

void Workbench::take_opened(std::vector<Opened> opened) {
  std::vector<std::shared_ptr<const Session>> sessions;
  std::vector<JobFailure> failures;
  std::vector<TopicOffer> questions;
  for (Opened& one : opened) {
    if (one.session && !one.copy_of.isEmpty())
      emit message(Severity::Warning, QString::fromStdString(one.session->path.string()),
                   tr("is the same recording as %1, which is open: its pairs would count as evidence twice. It was not "
                      "opened.")
                       .arg(one.copy_of));
    else if (one.session)
      sessions.push_back(std::move(one.session));
    if (one.question && !is_open(one.question->path, sessions)) questions.push_back(std::move(*one.question));
    if (!one.failure.what.isEmpty()) failures.push_back(std::move(one.failure));
  }
  add_sessions(sessions);
  if (failures.size() == 1) emit message(Severity::Problem, failures[0].where, failures[0].what);
  if (failures.size() > 1) say_several_failed(failures);
  if (!questions.empty()) emit topics_asked(questions);
}

bool Workbench::is_open(const std::filesystem::path& path,
                        const std::vector<std::shared_ptr<const Session>>& opened_now) {
  const auto there = [&](const auto& session) { return session->path == path; };
  const bool open = std::any_of(sessions_.begin(), sessions_.end(), there) ||
                    std::any_of(opened_now.begin(), opened_now.end(), there);
  if (open) emit message(Severity::Note, QString::fromStdString(path.string()), tr("is open already"));
  return open;
}

void Workbench::say_several_failed(const std::vector<JobFailure>& failures) {
  QStringList lines;
  for (const JobFailure& failure : failures) {
    emit logged(Severity::Problem, failure.where, failure.what);
    lines << failure.where + QStringLiteral(": ") + failure.what.section('\n', 0, 0);
  }
  emit message(Severity::Problem, tr("%1 paths could not be opened (more in the log)").arg(failures.size()),
               lines.join('\n'));
}

void Workbench::add_sessions(const std::vector<std::shared_ptr<const Session>>& opened) {
  std::vector<std::shared_ptr<const Session>> sessions;
  for (const auto& session : opened)
    if (!is_open(session->path, sessions)) sessions.push_back(session);
  if (sessions.empty()) return emit state_changed();
  const bool nominal_known = nominal_ins_from_lidar_.has_value();
  for (const auto& session : sessions) {
    const QString path = QString::fromStdString(session->path.string());
    emit message(Severity::Note, path, tr("opened as %1").arg(QString::fromStdString(session->format)));
    tell_findings(*session);
    emit session_opened(path);
  }
  undo_.push(new OpeningCommand(*this, sessions));
  const auto brings = std::find_if(sessions.begin(), sessions.end(),
                                   [](const auto& session) { return session->nominal_ins_from_lidar.has_value(); });
  if (!nominal_known && brings != sessions.end())
    emit message(Severity::Note, QString::fromStdString((*brings)->path.string()), tr("its nominal mounting is used"));
}

void Workbench::tell_findings(const Session& session) {
  for (const Finding& finding : session.findings) {
    const QString where = model_text(finding.where.words()), what = model_text(finding.explanation);
    // A problem spoils all that follows: it is shown while it can still be corrected.
    if (finding.severity == Severity::Problem)
      emit message(finding.severity, where, what);
    else
      emit logged(finding.severity, where, what);
  }
}

}  // namespace remount
