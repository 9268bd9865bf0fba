// What was calibrated goes and comes back: with the sessions it was calibrated from, and with another calibration.
#include <algorithm>

#include "app/gui/edit_commands.h"
#include "app/gui/workbench.h"
#include "model/methods/calibration_method.h"
#include "widgets/model_text.h"

namespace remount {

struct Workbench::Calibrated {
  PipelineInput input;
  OutputPtr output, before, solved;
  Decisions decisions;
  std::optional<WholeRun> whole_run;
  std::vector<InputFile> files;
  QString moved_by;
  Exported exported = Exported::No;
  bool data_changed = false, confirmed = false;
  int selected = -1;
};

Workbench::CalibratedPtr Workbench::calibrated() const {
  return std::make_shared<const Calibrated>(Calibrated{run_input_, output_, output_before_, output_solved_, decisions_,
                                                       whole_run_, input_files_, moved_by_, exported_, data_changed_,
                                                       confirmed_, selected_});
}

void Workbench::put_back(const Calibrated& calibrated) {
  run_input_ = calibrated.input;
  output_ = calibrated.output;
  output_before_ = calibrated.before;
  output_solved_ = calibrated.solved;
  decisions_ = calibrated.decisions;
  whole_run_ = calibrated.whole_run;
  input_files_ = calibrated.files;
  moved_by_ = calibrated.moved_by;
  data_changed_ = calibrated.data_changed;
  exported_ = calibrated.exported;
  confirmed_ = calibrated.confirmed;
}

void Workbench::show_put_back(const CalibratedPtr& calibrated) {
  check_map_soon();
  emit output_changed();
  emit state_changed();
  if (output_ && calibrated) {
    select_pair(calibrated->selected);
    if (input_files_.empty()) hash_input_files();
    if (output_ != output_solved_) start_solve(tr("decisions before"), FirstAnswer::None);
  }
  mark_edited();
}

void Workbench::forget_calibration() {
  for (const int job : {solve_job_, cloud_job_, hash_job_}) jobs_.cancel(job);
  solve_job_ = cloud_job_ = hash_job_ = 0;
  whole_run_.reset();
  output_ = output_before_ = output_solved_ = nullptr;  // pairs refer to sessions by number
  data_changed_ = confirmed_ = false;
  exported_ = Exported::No;
  ++solution_;
  check_map_soon();
  select_pair(-1);
}

void Workbench::apply_calibration(const CalibratedPtr& calibrated, const QString& step) {
  forget_calibration();
  put_back(*calibrated);
  emit message(Severity::Note, {}, step);
  show_put_back(calibrated);
}

void Workbench::keep_what_was(const CalibratedPtr& before) {
  if (!before) return undo_.clear();  // or redo would put an older calibration in the place of this one
  const auto& methods = calibration_methods();
  const auto method = std::find_if(methods.begin(), methods.end(),
                                   [&](const CalibrationMethod& one) { return one.id == output_->method; });
  const QString title = method == methods.end() ? QString::fromStdString(output_->method) : model_text(method->title);
  undo_.push(new CalibrationCommand(*this, tr("calibration (%1)").arg(title), before));
  if (before->output && !before->output->pairs.empty() && output_->pairs.empty())
    emit message(Severity::Note, {},
                 tr("This method has no pairs. Those of the calibration before come back by undo (Ctrl+Z), and "
                    "decisions on them hold for the next calibration from pairs."));
}

void Workbench::remove_session(int session) {
  if (session < 0 || static_cast<std::size_t>(session) >= sessions_.size()) return;
  if (calibrating()) {
    emit message(Severity::Warning, QString::fromStdString(sessions_[static_cast<std::size_t>(session)]->path.string()),
                 tr("is being calibrated. Cancel that (Esc) before removing it."));
    return;
  }
  const std::shared_ptr<const Session> removed = sessions_[static_cast<std::size_t>(session)];
  const bool calibrated = output_ != nullptr;
  undo_.push(new RemovalCommand(*this, removed, session));
  emit message(Severity::Note, QString::fromStdString(removed->path.string()),
               calibrated ? tr("removed. The result belonged to the sessions before: calibrate (F5), or undo (Ctrl+Z) "
                               "to have it back.")
                          : tr("removed"));
}

void Workbench::stop_for_other_sessions() {
  jobs_.cancel(run_job_);  // what it is about is no longer there
  forget_calibration();
}

void Workbench::drop_run() {
  emit message(Severity::Note, {},
               tr("The calibration was of other sessions or topics than there are now: it is left out. Calibrate (F5) "
                  "for these."));
  resume_solving();
}

void Workbench::apply_session(const std::shared_ptr<const Session>& from, const std::shared_ptr<const Session>& to,
                              const CalibratedPtr& calibrated) {
  const auto place = std::find(sessions_.begin(), sessions_.end(), from);
  if (place == sessions_.end()) return;
  *place = to;
  stop_for_other_sessions();
  if (calibrated)
    put_back(*calibrated);
  else
    leave_topics_of(*from, *to);
  emit sessions_changed();
  emit nominal_changed();
  show_put_back(calibrated);
}

void Workbench::apply_removal(const std::shared_ptr<const Session>& session, const Placed& opened_since) {
  std::erase(sessions_, session);
  if (opened_since.session) insert_session(opened_since);
  stop_for_other_sessions();
  emit sessions_changed();
  show_put_back(nullptr);
}

void Workbench::insert_session(const Placed& placed) {
  sessions_.insert(sessions_.begin() + std::min(placed.place, std::ssize(sessions_)), placed.session);
}

Workbench::Placed Workbench::apply_return(const std::shared_ptr<const Session>& session, std::ptrdiff_t place,
                                          const CalibratedPtr& calibrated) {
  const auto again =
      std::find_if(sessions_.begin(), sessions_.end(), [&](const auto& open) { return open->path == session->path; });
  Placed opened_since;
  if (again != sessions_.end()) {
    opened_since = {*again, again - sessions_.begin()};
    sessions_.erase(again);
  }
  insert_session({session, place});
  stop_for_other_sessions();
  put_back(*calibrated);
  emit sessions_changed();
  show_put_back(calibrated);
  return opened_since;
}

std::vector<PairVerdict> Workbench::verdicts() const {
  std::vector<PairVerdict> verdicts;
  for (const auto& [key, verdict] : decisions_) {
    const auto& [path, stamp_a_ns, stamp_b_ns] = key;
    const auto of = std::find_if(sessions_.begin(), sessions_.end(),
                                 [&, &path = path](const auto& session) { return session->path.string() == path; });
    if (of != sessions_.end())
      verdicts.push_back(
          {static_cast<int>(of - sessions_.begin()), stamp_a_ns, stamp_b_ns, verdict.state, verdict.reason});
  }
  return verdicts;
}

}  // namespace remount
