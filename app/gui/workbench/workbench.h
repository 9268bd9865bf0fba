// The work of a window, whatever shows it: sessions, settings, decisions, results, and the jobs that change them.
#pragma once

#include <QObject>
#include <memory>

#include "app/gui/workbench/calibrations.h"
#include "app/gui/workbench/drive_overviews.h"
#include "app/gui/workbench/pair_scenes.h"
#include "app/gui/workbench/project_document.h"
#include "app/gui/workbench/review_notes.h"
#include "app/gui/workbench/session_edits.h"
#include "app/gui/workbench/vehicle.h"

namespace remount::gui {

/// Owns the parts, each of which says what it holds, from the lowest to the highest: a part knows those before it.
/// A workbench that is const gives out parts that can be changed, as a pointer would.
class Workbench : public QObject {
  Q_OBJECT
 public:
  explicit Workbench(Engine engine, QObject* parent = nullptr);
  Workbench(Engine engine, std::unique_ptr<LockKeeper> locks, QObject* parent = nullptr);
  ~Workbench() override;

  const Engine& engine() const { return engine_; }
  JobRunner& jobs() const { return *jobs_; }
  Notices& notices() const { return parts_->notices; }
  Activity& activity() const { return parts_->activity; }
  History& history() const { return parts_->history; }
  Setup& setup() const { return parts_->setup; }
  SessionList& sessions() const { return parts_->sessions; }
  DriveOverviews& overviews() const { return parts_->overviews; }
  Outcome& outcome() const { return parts_->outcome; }
  Selection& selection() const { return parts_->selection; }
  PairScenes& pair_scenes() const { return parts_->pair_scenes; }
  InputFiles& input_files() const { return parts_->input_files; }
  MapChecks& map_checks() const { return parts_->map_checks; }
  Decisions& decisions() const { return parts_->decisions; }
  ReviewNotes& review_notes() const { return parts_->review_notes; }
  Solutions& solutions() const { return parts_->solutions; }
  Calibrations& calibrations() const { return parts_->calibrations; }
  SessionEdits& session_edits() const { return parts_->session_edits; }
  Vehicle& vehicle() const { return parts_->vehicle; }
  ProjectDocument& document() const { return parts_->document; }

  void cancel();    ///< what the user waits for
  void announce();  ///< everything once more, for a window that takes the place of another

 signals:
  void state_changed();  ///< jobs started or ended, stage of the calibration, out of date, exported

 private:
  struct Parts {
    Parts(Workbench& workbench, std::unique_ptr<LockKeeper> locks);
    Notices notices;
    Activity activity;
    History history;
    Desk desk;
    Setup setup;
    SessionList sessions;
    DriveOverviews overviews;
    Outcome outcome;
    Selection selection;
    PairScenes pair_scenes;
    InputFiles input_files;
    MapChecks map_checks;
    Decisions decisions;
    ReviewNotes review_notes;
    Solutions solutions;
    Calibrations calibrations;
    SessionEdits session_edits;
    Vehicle vehicle;
    ProjectDocument document;
  };
  void listen(const WorkbenchPart& part);

  Engine engine_;
  std::unique_ptr<JobRunner> jobs_;
  std::unique_ptr<Parts> parts_;
};

}  // namespace remount::gui
