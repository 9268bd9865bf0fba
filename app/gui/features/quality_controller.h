// Between the workbench and the quality page: what takes time is computed in the background when it is looked at.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/gui/workbench/workbench.h"
#include "widgets/quality/clearance_plot.h"

namespace remount::widgets {
class QualityView;
enum class MapX;
}  // namespace remount::widgets

namespace remount::gui {

class QualityController : public QObject {
  Q_OBJECT
 public:
  QualityController(Workbench& workbench, widgets::QualityView& view, QObject* parent = nullptr);
  void refresh();  ///< the output, or what is under way, changed
  bool working() const {
    return jobs_.running(hold_out_job_) || jobs_.running(scan_job_) || jobs_.running(measure_job_);
  }

 signals:
  void map_requested(widgets::MapX x);

 private:
  /// A keyframe's scan under the mountings of a solution.
  struct ScanKey {
    int solution = -1;
    std::optional<motion::KeyframeIndex> keyframe;
    bool operator==(const ScanKey&) const = default;
  };

  void refresh_obstacles();
  void offer_scans(const OutputPtr& output);
  void start_scan(const ScanKey& wanted);
  void take_scan(const QString& name, const std::shared_ptr<const widgets::VehicleScan>& scan,
                 const widgets::MeasuredScanPtr& measured);
  void measure_again();
  void refresh_sharpness();
  void refresh_hold_out();
  void start_hold_out(const OutputPtr& output);
  QString why_no_sharpness(const pipeline::PipelineOutput& output) const;

  Workbench& workbench_;
  widgets::QualityView& view_;
  OutputPtr offered_, sharpness_of_;  // what is shown, or being computed
  int hold_out_of_ = -1;              // solution
  ScanKey scan_of_;
  std::shared_ptr<const widgets::VehicleScan> scan_;
  widgets::MeasuredScanPtr measured_;
  QString scan_name_;
  int hold_out_job_ = 0, scan_job_ = 0, measure_job_ = 0;
  JobRunner jobs_;  // last: its threads end before anything they report to is gone
};

}  // namespace remount::gui
