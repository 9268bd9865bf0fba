// The undo command of a vehicle.
#pragma once

#include "app/gui/workbench/edit_commands.h"
#include "app/gui/workbench/vehicle.h"

namespace remount::gui {

/// The LiDARs of a vehicle before and after an edit, and what is worked on.
class VehicleCommand : public QUndoCommand {
 public:
  VehicleCommand(Vehicle& vehicle, const QString& text, VehicleState before, VehicleState after)
      : QUndoCommand(text), vehicle_(vehicle), before_(std::move(before)), after_(std::move(after)) {}
  void undo() override {
    after_ = vehicle_.state();  // what was done since on the LiDAR that is shown comes back by redo
    vehicle_.apply(before_, undone(text()));
  }
  void redo() override { vehicle_.apply(after_, text()); }

 private:
  Vehicle& vehicle_;
  VehicleState before_, after_;
};

}  // namespace remount::gui
