// Whole calibrations, and what they take the place of.
#pragma once

#include <QStringList>

#include "app/gui/workbench/input_files.h"
#include "app/gui/workbench/selection.h"
#include "app/gui/workbench/solutions.h"

namespace remount::gui {

/// Runs the chosen method on all sessions. A result that takes the place of another can be put back with the decisions
/// of then; what is calibrated is dropped where the sessions are no longer those that it was begun with.
class Calibrations : public WorkbenchPart {
  Q_OBJECT
 public:
  /// The parts that a calibration reads and changes.
  struct Parts {
    SessionList& sessions;
    Setup& setup;
    Outcome& outcome;
    Decisions& decisions;
    Selection& selection;
    InputFiles& input_files;
    MapChecks& map_checks;
    Solutions& solutions;
  };
  Calibrations(const Desk& desk, const Parts& parts) : WorkbenchPart(desk), parts_(parts) {}

  void calibrate();
  pipeline::PipelineInput input_of_next() const;
  /// What is set now and was not so for the result that is shown, in words, one for each: calibrate again. What a
  /// solution under way will take up is not among them.
  QStringList changes_since_output() const;
  bool out_of_date() const { return !changes_since_output().isEmpty(); }
  bool is_of_output(const drive::Session& session) const;  ///< whether what is calibrated was made with it

  CalibratedPtr calibrated() const;
  /// Step of an undo command; not undoable by itself.
  void apply(const CalibratedPtr& calibrated, const QString& step);
  void stop_for_other_sessions();  ///< a run under way, and what is calibrated
  void put_back(const Calibrated& calibrated);
  /// What was put back; null where nothing was.
  void announce(const CalibratedPtr& calibrated);

 private:
  bool may_calibrate();  ///< says why not
  /// @param turn of the calibration, for Activity::is_last
  JobRunner::Deliver work(const pipeline::PipelineInput& input, int turn, const Engine& engine,
                          const KeptVerdicts& decisions, Progress& progress);
  void take_whole_run(const pipeline::PipelineInput& input, const std::shared_ptr<pipeline::PipelineOutput>& output,
                      const KeptVerdicts& decisions);
  void take_cancelled_run(const pipeline::PipelineInput& input,
                          const std::shared_ptr<pipeline::PipelineOutput>& output);
  void take_run(const pipeline::PipelineInput& input, OutputPtr output);
  /// A run of sessions that are no longer those that are open.
  void drop_run();
  void keep_what_was(const CalibratedPtr& before);
  void forget();

  Parts parts_;
};

}  // namespace remount::gui
