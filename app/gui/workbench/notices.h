// What the parts of a workbench tell the user.
#pragma once

#include <QObject>
#include <functional>

#include "app/gui/jobs/job_runner.h"
#include "model/drive/finding.h"

namespace remount::gui {

/// Holds nothing: whoever shows messages and the log listens here.
class Notices : public QObject {
  Q_OBJECT
 public:
  void say(drive::Severity severity, const QString& where, const QString& what) { emit message(severity, where, what); }
  void log(drive::Severity severity, const QString& where, const QString& what) { emit logged(severity, where, what); }
  /// Behind a message: what the user can do about it.
  void offer(const QString& label, const std::function<void()>& act) { emit offered(label, act); }
  /// For a job: its failure becomes a message.
  JobRunner::Failed report_failure() {
    return [this](const JobFailure& failure) { say(drive::Severity::Problem, failure.where, failure.what); };
  }

 signals:
  /// For the user to read now: what they asked for failed, cannot be done, or is done.
  void message(drive::Severity severity, const QString& where, const QString& what);
  /// Goes with the message before it.
  void offered(const QString& label, const std::function<void()>& act);
  /// What was found in the data; shown where the data are listed.
  void logged(drive::Severity severity, const QString& where, const QString& what);
};

}  // namespace remount::gui
