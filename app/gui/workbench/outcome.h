// What is calibrated.
#pragma once

#include "app/gui/workbench/calibrated.h"
#include "app/gui/workbench/part.h"

namespace remount::gui {

/// Holds the output, what it was made from, what it is compared with and what became of it. Only this changes them, so
/// that a result that is another is neither confirmed nor exported, and has another number.
class Outcome : public WorkbenchPart {
  Q_OBJECT
 public:
  using WorkbenchPart::WorkbenchPart;

  OutputPtr output() const { return now_.output; }  ///< null before the first calibration
  /// What the present result is compared with: the one before the edits `moved_by`, solved from pairs as it is itself.
  OutputPtr output_before() const { return now_.before; }
  const QString& moved_by() const { return now_.moved_by; }  ///< "reject pair 12"; empty after a calibration
  /// What the output was made from, whatever is set now.
  const pipeline::PipelineInput& input() const { return now_.input; }
  OutputPtr solved() const { return now_.solved; }  ///< the last that answers every decision in full
  bool whole() const { return now_.output == now_.solved; }
  const std::optional<WholeRun>& whole_run() const { return now_.whole_run; }
  /// Hashes of what was read, for provenance; made in the background after a calibration, empty until then.
  const std::vector<results::InputFile>& input_files() const { return now_.files; }
  bool data_changed() const { return now_.data_changed; }
  Exported exported() const { return now_.exported; }
  bool confirmed() const { return now_.confirmed; }
  /// Goes up with every other X; what only another map check or other words change keeps it.
  int solution() const { return solution_; }
  const CalibratedResult& now() const { return now_; }

  void mark_exported(Exported how);
  void confirm(bool good);

  // Without a word, by the parts that know why.
  void take_run(const pipeline::PipelineInput& input, OutputPtr output, const KeptVerdicts& decisions);
  /// It does not answer every decision; nothing of the last calibration is left to return to.
  void count_as_unsolved();
  void take_decided(OutputPtr output) { now_.output = std::move(output); }
  void count_as_solved() { now_.solved = now_.output; }  ///< its reasons are other words for the same
  void take_ranking(OutputPtr answer);
  void take_first_answer(OutputPtr answer, OutputPtr before, const QString& moved_by);
  void take_solution(OutputPtr solved, OutputPtr before, const settings::Settings& settings, const QString& moved_by);
  void take_whole_run(const KeptVerdicts& decisions) { now_.whole_run = WholeRun{now_.input, now_.output, decisions}; }
  void take_map_check(OutputPtr checked, bool doubtful);
  void take_files(std::vector<results::InputFile> files) { now_.files = std::move(files); }
  void take_data_changed() { now_.data_changed = true; }
  void put(const CalibratedResult& result) { now_ = result; }
  void forget();
  void count_as_other() { ++solution_; }
  void announce() { emit changed(); }

 signals:
  void changed();

 private:
  void take_other(OutputPtr output, OutputPtr before, const QString& moved_by);
  CalibratedResult now_;
  int solution_ = 0;
};

}  // namespace remount::gui
