#include "app/gui/workbench/workbench.h"

#include <utility>

namespace remount::gui {

Workbench::Parts::Parts(Workbench& workbench, std::unique_ptr<LockKeeper> locks)
    : activity(workbench.jobs()),
      desk{workbench.engine(), workbench.jobs(), activity, notices, history},
      setup(desk),
      sessions(desk, setup),
      overviews(desk, sessions),
      outcome(desk),
      selection(desk, outcome),
      pair_scenes(desk, outcome, selection),
      input_files(desk, outcome),
      map_checks(desk, outcome),
      decisions(desk, sessions, outcome),
      review_notes(desk, sessions, outcome),
      solutions(desk, setup, outcome, decisions, map_checks),
      calibrations(desk, {sessions, setup, outcome, decisions, selection, input_files, map_checks, solutions}),
      session_edits(desk, sessions, setup, outcome, decisions, calibrations),
      vehicle(desk, {sessions, setup, outcome, decisions, solutions, calibrations}),
      document(desk, workbench, std::move(locks)) {}

Workbench::Workbench(Engine engine, QObject* parent)
    : Workbench(std::move(engine), std::make_unique<LockKeeper>(), parent) {}

Workbench::Workbench(Engine engine, std::unique_ptr<LockKeeper> locks, QObject* parent)
    : QObject(parent),
      engine_(std::move(engine)),
      jobs_(std::make_unique<JobRunner>()),
      parts_(std::make_unique<Parts>(*this, std::move(locks))) {
  connect(&activity(), &Activity::changed, this, &Workbench::state_changed);
  for (const WorkbenchPart* part : std::initializer_list<const WorkbenchPart*>{
           &setup(), &sessions(), &overviews(), &outcome(), &selection(), &pair_scenes(), &input_files(), &map_checks(),
           &decisions(), &review_notes(), &solutions(), &calibrations(), &session_edits(), &vehicle(), &document()})
    listen(*part);
}

Workbench::~Workbench() { jobs_.reset(); }  // its threads end before anything they report to is gone

void Workbench::listen(const WorkbenchPart& part) {
  connect(&part, &WorkbenchPart::state_changed, this, &Workbench::state_changed);
  connect(&part, &WorkbenchPart::edited, &document(), &ProjectDocument::mark_edited);
}

void Workbench::cancel() {
  sessions().forget_waiting();
  for (const auto kind : {Activity::Kind::Opening, Activity::Kind::Calibrating, Activity::Kind::Solving})
    activity().cancel(kind);
}

void Workbench::announce() {
  sessions().announce();
  setup().announce();
  outcome().announce();
  vehicle().announce();
  document().announce();
  emit state_changed();
  selection().select_anew(selection().pair());
}

}  // namespace remount::gui
