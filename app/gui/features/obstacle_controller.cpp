#include "app/gui/features/obstacle_controller.h"

#include <QPointer>
#include <utility>

#include "app/gui/jobs/error_words.h"
#include "widgets/quality/obstacle_dialog.h"

namespace remount::gui {

ObstacleController::ObstacleController(JobRunner& jobs, widgets::ObstacleDialog& dialog, CloudsPtr clouds,
                                       const RigidTransform& before_vehicle_from_lidar,
                                       const RigidTransform& result_vehicle_from_lidar)
    : QObject(&dialog),
      jobs_(jobs),
      dialog_(dialog),
      clouds_(std::move(clouds)),
      before_vehicle_from_lidar_(before_vehicle_from_lidar),
      result_vehicle_from_lidar_(result_vehicle_from_lidar) {
  connect(&dialog_, &widgets::ObstacleDialog::options_edited, this, &ObstacleController::check);
  check();
}

void ObstacleController::check() {
  if (running_) {
    edited_ = true;
    return;
  }
  running_ = true;
  jobs_.start(
      // The dialog may be closed before the job ends.
      [self = QPointer(this), clouds = clouds_, before = before_vehicle_from_lidar_,
       result = result_vehicle_from_lidar_, options = dialog_.options()](Progress&) -> JobRunner::Deliver {
        const quality::ObstacleComparison found =
            quality::compare_obstacles(clouds->cloud_b(), clouds->scan_b->objects, before, result, options);
        return [self, found, options] {
          if (!self) return;
          self->dialog_.show_comparison(found, options);
          self->done();
        };
      },
      [self = QPointer(this)](const JobFailure& failure) {
        if (!self) return;
        self->dialog_.show_problem(failure.what);
        self->done();
      });
}

void ObstacleController::done() {
  running_ = false;
  if (std::exchange(edited_, false)) check();
}

}  // namespace remount::gui
