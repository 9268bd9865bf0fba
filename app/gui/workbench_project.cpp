// Projects: everything at once, from and to a file.
#include <algorithm>

#include "algorithms/core/error.h"
#include "app/gui/workbench.h"
#include "model/project.h"

namespace remount {

void Workbench::set_project(const QString& path, bool unsaved) {
  project_path_ = path;
  unsaved_ = unsaved;
  emit project_changed();
}

void Workbench::save_project(const QString& path, std::function<void()> done) {
  Project project;
  for (const auto& session : sessions_) project.sessions.push_back(session->path);
  project.settings = settings_;
  project.nominal_ins_from_lidar = nominal_ins_from_lidar_;
  if (output_) {
    project.verdicts = verdicts_of(*output_);
    project.output = *output_;
    project.basis = basis_of(run_input_);
  }
  project.inputs = input_files_;
  const OutputPtr saved = output_;
  jobs_.start(
      [this, path, saved, done, project = std::move(project)](Progress&) -> JobRunner::Deliver {
        remount::save_project(project, path.toStdString());
        return [this, path, saved, done] {
          set_project(path, saved != output_);
          emit message(Severity::Note, path, tr("project saved"));
          if (done && !unsaved_) done();
        };
      },
      report_failure());
}

void Workbench::open_project(const QString& path) {
  if (opening() || calibrating()) {
    emit message(Severity::Warning, {},
                 tr("Wait until the present work is done, or cancel it, before opening a project."));
    return;
  }
  open_job_ = jobs_.start(
      [this, path, open = engine_.open](Progress& progress) -> JobRunner::Deliver {
        Project project = load_project(path.toStdString());
        std::vector<std::shared_ptr<const Session>> sessions;
        std::vector<JobFailure> failures;
        for (const auto& session : project.sessions) {
          try {
            sessions.push_back(std::make_shared<const Session>(open(session, progress)));
          } catch (const Error& error) {
            failures.push_back({QString::fromStdString(error.where().empty() ? session.string() : error.where()),
                                tr("%1\nThe project is opened without this session and without its pairs.")
                                    .arg(QString::fromStdString(error.what_happened()))});
          }
        }
        if (progress.cancelled()) return {};
        OutputPtr output;
        if (project.output && failures.empty())
          output = std::make_shared<const PipelineOutput>(std::move(*project.output));
        project.output.reset();
        return [this, path, sessions, failures, output, project = std::move(project)] {
          restore(sessions, project, output);
          set_project(path, false);
          if (const QStringList changes = changes_since_output(); !changes.isEmpty())
            emit message(Severity::Warning, path,
                         tr("holds a result that was made with other settings than it holds now: %1.\n"
                            "Calibrate again (F5).")
                             .arg(changes.join(QStringLiteral("; "))));
          for (const JobFailure& failure : failures) emit message(Severity::Problem, failure.where, failure.what);
        };
      },
      report_failure());
  emit state_changed();
}

void Workbench::restore(std::vector<std::shared_ptr<const Session>> sessions, const Project& project,
                        OutputPtr output) {
  for (int job : {solve_job_, cloud_job_, hash_job_}) jobs_.cancel(job);
  solve_job_ = cloud_job_ = hash_job_ = 0;
  sessions_ = std::move(sessions);
  settings_ = project.settings;
  nominal_ins_from_lidar_ = project.nominal_ins_from_lidar;
  output_before_ = nullptr;
  output_ = output_solved_ = std::move(output);
  run_input_ = input_of_next_run();
  if (output_) {
    run_input_.settings = project.basis.settings;
    run_input_.nominal_ins_from_lidar = project.basis.nominal_ins_from_lidar;
    run_input_.sessions.resize(std::min(sessions_.size(), project.basis.session_count));
  }
  input_files_ = project.inputs;
  decisions_.clear();
  for (std::size_t i = 0; output_ && i < output_->pairs.size(); ++i)
    if (output_->pairs[i].decided_by == DecidedBy::User)
      decisions_[key_of(run_input_, *output_, output_->pairs[i])] = output_->pairs[i].state;
  data_changed_ = exported_ = false;
  undo_.clear();
  emit sessions_changed();
  emit settings_changed();
  emit nominal_changed();
  emit output_changed();
  emit state_changed();
  selected_ = -1;
  select_pair(output_ && !output_->pairs.empty() ? 0 : -1);
  if (output_) compare_input_files();
}

void Workbench::compare_input_files() {
  if (input_files_.empty()) return;  // the calibration was made without hashes, or by another version
  auto job = std::make_shared<int>(0);
  hash_job_ = jobs_.start(
      [this, job, sessions = run_input_.sessions, then = input_files_](Progress& progress) -> JobRunner::Deliver {
        const std::vector<InputFile> now = hash_inputs(sessions, 1, progress);
        const QString changed = progress.cancelled() ? QString() : QString::fromStdString(changed_file(then, now));
        return [this, job, changed] {
          if (*job != hash_job_ || changed.isEmpty()) return;
          data_changed_ = true;
          emit message(Severity::Warning, changed,
                       tr("is not as it was when the result that is shown was made. Calibrate again (F5)."));
          emit state_changed();
        };
      },
      report_failure());
  *job = hash_job_;
}

}  // namespace remount
