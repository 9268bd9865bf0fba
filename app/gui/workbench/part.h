// What every part of a workbench is.
#pragma once

#include <QObject>

#include "app/gui/jobs/engine.h"
#include "app/gui/workbench/activity.h"
#include "app/gui/workbench/history.h"
#include "app/gui/workbench/notices.h"

namespace remount::gui {

/// What all parts work with; a workbench owns it and outlives them.
struct Desk {
  const Engine& engine;
  JobRunner& jobs;
  Activity& activity;
  Notices& notices;
  History& history;
};

/// A part knows those below it, which its constructor is given, and tells those above by signals. What it is told to
/// take without a word (`put`, `take_…`) it shows when it is asked to (`announce`): several parts change before any of
/// them is looked at.
class WorkbenchPart : public QObject {
  Q_OBJECT
 public:
  explicit WorkbenchPart(const Desk& desk) : desk_(desk) {}

 signals:
  void state_changed();  ///< how things stand: what the whole window shows of it may be other
  void edited();         ///< what a project holds is other than before

 protected:
  const Desk desk_;
};

}  // namespace remount::gui
