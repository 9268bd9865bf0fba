#include "app/gui/workbench/outcome.h"

#include <algorithm>

namespace remount::gui {

void Outcome::confirm(bool good) {
  if (now_.confirmed == good) return;
  now_.confirmed = good;
  desk_.notices.log(drive::Severity::Note, {},
                    good ? tr("result confirmed") : tr("confirmation of the result taken back"));
  emit state_changed();
  emit edited();
}

void Outcome::mark_exported(Exported how) {
  const bool written = how == Exported::Written && now_.exported != how;
  now_.exported = std::max(now_.exported, how);
  emit state_changed();
  if (written) emit edited();
}

void Outcome::take_other(OutputPtr output, OutputPtr before, const QString& moved_by) {
  now_.output = std::move(output);
  now_.before = std::move(before);
  now_.moved_by = moved_by;
  now_.exported = Exported::No;
  now_.confirmed = false;
  ++solution_;
}

void Outcome::take_run(const pipeline::PipelineInput& input, OutputPtr output, const KeptVerdicts& decisions) {
  take_other(std::move(output), now_.solved, {});
  now_.input = input;
  now_.solved = now_.output;
  now_.whole_run = WholeRun{input, now_.output, decisions};
  now_.data_changed = false;
}

void Outcome::count_as_unsolved() {
  now_.solved = nullptr;
  now_.whole_run.reset();
}

void Outcome::take_ranking(OutputPtr answer) {
  now_.output = std::move(answer);
  ++solution_;
}

void Outcome::take_first_answer(OutputPtr answer, OutputPtr before, const QString& moved_by) {
  take_other(std::move(answer), std::move(before), moved_by);
}

void Outcome::take_solution(OutputPtr solved, OutputPtr before, const settings::Settings& settings,
                            const QString& moved_by) {
  take_other(std::move(solved), std::move(before), moved_by);
  now_.solved = now_.output;
  now_.input.settings = settings;
}

void Outcome::take_map_check(OutputPtr checked, bool doubtful) {
  if (now_.whole_run && now_.whole_run->output == now_.output) now_.whole_run->output = checked;
  now_.output = now_.solved = std::move(checked);
  if (doubtful) now_.confirmed = false;  // it was, without this
}

void Outcome::forget() {
  now_.whole_run.reset();
  now_.output = now_.before = now_.solved = nullptr;  // pairs refer to sessions by number
  now_.data_changed = now_.confirmed = false;
  now_.exported = Exported::No;
  ++solution_;
}

}  // namespace remount::gui
