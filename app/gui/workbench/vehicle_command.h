// The undo command of a vehicle.
#pragma once

#include "app/gui/workbench/edit_commands.h"
#include "app/gui/workbench/vehicle.h"

namespace remount::gui {

/// The LiDARs of a vehicle before and after an edit, and what is worked on.
class VehicleCommand : public NamedEdit {
 public:
  VehicleCommand(Vehicle& vehicle, VehicleStep step, VehicleState before, VehicleState after)
      : vehicle_(vehicle), step_(std::move(step)), before_(std::move(before)), after_(std::move(after)) {
    setText(VehicleCommand::name());
  }
  QString name() const override { return in_words(step_); }
  void undo() override {
    after_ = vehicle_.state();  // what was done since on the LiDAR that is shown comes back by redo
    vehicle_.apply(before_, undone(text()));
  }
  void redo() override { vehicle_.apply(after_, text()); }

 private:
  Vehicle& vehicle_;
  VehicleStep step_;
  VehicleState before_, after_;
};

}  // namespace remount::gui
