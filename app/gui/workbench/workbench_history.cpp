// What was calibrated goes and comes back: with the sessions it was calibrated from, and with another calibration.
#include <algorithm>

#include "app/gui/workbench/edit_commands.h"
#include "app/gui/workbench/workbench.h"
#include "model/pipeline/without_session.h"

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
  undo_.push(new CalibrationCommand(*this, output_->method, before));
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
  const bool calibrated = output_ != nullptr, part = is_of_output(*removed);
  undo_.push(new RemovalCommand(*this, removed, session));
  emit message(Severity::Note, QString::fromStdString(removed->path.string()),
               !calibrated ? tr("removed")
               : !part     ? tr("removed. The result was made without it and stays.")
               : output_   ? tr("removed. No pair of it was accepted: the result stays.")
                           : tr("removed. The result belonged to the sessions before: calibrate (F5), or undo (Ctrl+Z) "
                                  "to have it back."));
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

void Workbench::show_other_sessions() {
  jobs_.cancel(run_job_);  // it is of the sessions before
  emit sessions_changed();
  emit state_changed();
  mark_edited();
}

void Workbench::apply_opening(const std::vector<std::shared_ptr<const Session>>& sessions) {
  sessions_.insert(sessions_.end(), sessions.begin(), sessions.end());
  show_other_sessions();
}

void Workbench::apply_closing(const std::vector<std::shared_ptr<const Session>>& sessions) {
  for (const auto& session : sessions) std::erase(sessions_, session);
  show_other_sessions();
}

bool Workbench::is_of_output(const Session& session) const {
  return output_ && std::any_of(run_input_.sessions.begin(), run_input_.sessions.end(),
                                [&](const auto& one) { return one.get() == &session; });
}

Workbench::CalibratedPtr Workbench::calibrated_without(const Session& session) const {
  const auto place = std::find_if(run_input_.sessions.begin(), run_input_.sessions.end(),
                                  [&](const auto& one) { return one.get() == &session; });
  const auto number = static_cast<int>(place - run_input_.sessions.begin());
  const auto without = [number](const PipelineInput& input, const OutputPtr& output) -> OutputPtr {
    auto left = output ? without_session(input, *output, number) : std::nullopt;
    return left ? std::make_shared<const PipelineOutput>(std::move(*left)) : nullptr;
  };
  auto left = std::make_shared<Calibrated>(*calibrated());
  left->output = without(run_input_, output_);
  if (!left->output) return nullptr;
  left->solved = output_solved_ == output_ ? left->output : without(run_input_, output_solved_);
  left->before = without(run_input_, output_before_);
  left->input = input_without_session(run_input_, number);
  left->selected = same_pair(run_input_, output_.get(), selected_, left->input, *left->output);
  left->files.clear();
  left->whole_run.reset();
  if (!whole_run_) return left;
  if (const OutputPtr run =
          whole_run_->output == output_ ? left->output : without(whole_run_->input, whole_run_->output))
    left->whole_run = WholeRun{input_without_session(whole_run_->input, number), run, whole_run_->decisions};
  return left;
}

void Workbench::apply_removal(const std::shared_ptr<const Session>& session) {
  const bool part = is_of_output(*session);
  const CalibratedPtr left = part ? calibrated_without(*session) : nullptr;
  std::erase(sessions_, session);
  if (!part) return show_other_sessions();
  stop_for_other_sessions();
  if (left) put_back(*left);
  emit sessions_changed();
  show_put_back(left);
}

void Workbench::apply_return(const std::shared_ptr<const Session>& session, std::ptrdiff_t place,
                             const CalibratedPtr& calibrated) {
  sessions_.insert(sessions_.begin() + std::min(place, std::ssize(sessions_)), session);
  if (!calibrated) return show_other_sessions();
  stop_for_other_sessions();
  put_back(*calibrated);
  emit sessions_changed();
  show_put_back(calibrated);
}

void Workbench::name_edits_anew() {
  for (int i = 0; i < undo_.count(); ++i)
    if (const auto* edit = dynamic_cast<const NamedEdit*>(undo_.command(i)))
      const_cast<NamedEdit*>(edit)->setText(edit->name());  // the stack gives out what it holds as const alone
}

bool Workbench::has_edits() const {
  for (int i = 0; i < undo_.index(); ++i)
    if (undo_.command(i)->id() != OpeningCommand::kId) return true;
  return false;
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
