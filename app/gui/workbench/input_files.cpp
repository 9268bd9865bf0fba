#include "app/gui/workbench/input_files.h"

namespace remount::gui {

void InputFiles::stop() {
  desk_.jobs.cancel(job_);
  job_ = 0;
}

void InputFiles::hash() {
  stop();
  outcome_.take_files({});
  auto job = std::make_shared<int>(0);
  job_ = desk_.jobs.start(
      [this, job, sessions = outcome_.input().sessions](Progress& progress) -> JobRunner::Deliver {
        std::vector<results::InputFile> files = results::hash_inputs(sessions, 1, progress);
        const bool whole = !progress.cancelled();
        return [this, job, whole, files = std::move(files)] {
          if (!whole || *job != job_) return;
          outcome_.take_files(files);
          emit edited();
        };
      },
      desk_.notices.report_failure());
  *job = job_;
}

void InputFiles::compare() {
  if (outcome_.input_files().empty()) return;  // the calibration was made without hashes, or by another version
  auto job = std::make_shared<int>(0);
  job_ = desk_.jobs.start(
      [this, job, sessions = outcome_.input().sessions,
       then = outcome_.input_files()](Progress& progress) -> JobRunner::Deliver {
        const std::vector<results::InputFile> now = results::hash_inputs(sessions, 1, progress);
        const QString changed =
            progress.cancelled() ? QString() : QString::fromStdString(results::changed_file(then, now));
        return [this, job, changed] {
          if (*job != job_ || changed.isEmpty()) return;
          outcome_.take_data_changed();
          desk_.notices.say(drive::Severity::Warning, changed,
                            tr("is not as it was when the result that is shown was made. Calibrate again (F5)."));
          emit state_changed();
        };
      },
      desk_.notices.report_failure());
  *job = job_;
}

}  // namespace remount::gui
