#include "app/gui/features/quality_controller.h"

#include <QSettings>
#include <algorithm>

#include "app/gui/jobs/error_words.h"
#include "app/gui/workbench/wording.h"
#include "model/drive/session_frames.h"
#include "model/method_registry/calibration_method.h"
#include "widgets/basics/remembering.h"
#include "widgets/map/map_view.h"
#include "widgets/quality/clearance_view.h"
#include "widgets/quality/quality_view.h"
#include "widgets/quality/sharpness_view.h"
#include "widgets/result/hold_out_view.h"

namespace remount::gui {
namespace {

constexpr std::array<std::pair<const char*, double quality::VehicleBox::*>, 5> kBoxKeys{
    {{"quality/front_m", &quality::VehicleBox::front_m},
     {"quality/rear_m", &quality::VehicleBox::rear_m},
     {"quality/half_width_m", &quality::VehicleBox::half_width_m},
     {"quality/height_min_m", &quality::VehicleBox::height_min_m},
     {"quality/height_max_m", &quality::VehicleBox::height_max_m}}};

quality::VehicleBox remembered_box() {
  quality::VehicleBox box;
  const QSettings settings;
  for (const auto& [key, member] : kBoxKeys) box.*member = settings.value(key, box.*member).toDouble();
  return box;
}

void remember_box(const quality::VehicleBox& box) {
  if (!widgets::remembers()) return;
  QSettings settings;
  for (const auto& [key, member] : kBoxKeys) settings.setValue(key, box.*member);
}

/// Index of the keyframe at a place among those of a session; nothing where it has fewer.
std::optional<motion::KeyframeIndex> keyframe_at(const pipeline::PipelineOutput& output,
                                                 std::optional<motion::SessionIndex> session, int place) {
  for (motion::KeyframeIndex k; k < output.keyframes.size(); ++k)
    if (output.keyframes[k].session == session && place-- == 0) return k;
  return std::nullopt;
}

std::vector<Eigen::Vector3f> move_points(const std::vector<Eigen::Vector3f>& points_in_lidar,
                                         const RigidTransform& vehicle_from_lidar) {
  const Eigen::Isometry3f single = vehicle_from_lidar.cast<float>();
  std::vector<Eigen::Vector3f> points_in_vehicle;
  points_in_vehicle.reserve(points_in_lidar.size());
  for (const Eigen::Vector3f& point : points_in_lidar) points_in_vehicle.push_back(single * point);
  return points_in_vehicle;
}

std::shared_ptr<const widgets::VehicleScan> scan_of_vehicle(const cloud::PointCloud& cloud,
                                                            const pipeline::PipelineInput& input,
                                                            const pipeline::PipelineOutput& output) {
  const RigidTransform vehicle_from_ins = drive::vehicle_from_ins(input.sessions);
  return std::make_shared<const widgets::VehicleScan>(
      widgets::VehicleScan{move_points(cloud.points, vehicle_from_ins * output.initial_ins_from_lidar),
                           move_points(cloud.points, vehicle_from_ins * output.result.mounting.ins_from_lidar())});
}

}  // namespace

QualityController::QualityController(Workbench& workbench, widgets::QualityView& view, QObject* parent)
    : QObject(parent), workbench_(workbench), view_(view) {
  connect(&view_, &widgets::QualityView::looked_at, this, &QualityController::refresh);
  connect(&workbench_, &Workbench::state_changed, this, &QualityController::refresh);
  connect(view_.obstacles(), &widgets::ClearanceView::scan_chosen, this, &QualityController::refresh_obstacles);
  connect(view_.obstacles(), &widgets::ClearanceView::box_edited, this, [this](const quality::VehicleBox& box) {
    remember_box(box);
    measure_again();
  });
  if (widgets::remembers()) view_.obstacles()->set_box(remembered_box());
  connect(view_.sharpness(), &widgets::SharpnessView::map_requested, this, &QualityController::map_requested);
}

void QualityController::refresh() {
  refresh_obstacles();
  refresh_sharpness();
  refresh_hold_out();
}

void QualityController::offer_scans(const OutputPtr& output) {
  if (output == offered_) return;
  offered_ = output;
  const pipeline::PipelineInput& input = workbench_.outcome().input();
  std::vector<int> counts(output ? input.sessions.size() : 0, 0);
  for (std::size_t k = 0; output && k < output->keyframes.size(); ++k) ++counts.at(output->keyframes[k].session);
  view_.obstacles()->show_choices(output ? names_of(input.sessions) : QStringList(), counts);
  view_.obstacles()->show_nominal_known(!output || output->nominal_known, distance_caution(workbench_));
}

void QualityController::refresh_obstacles() {
  const OutputPtr output = workbench_.outcome().output();
  widgets::ClearanceView& view = *view_.obstacles();
  offer_scans(output);
  const auto say = [&](const QString& text) {
    jobs_.cancel(scan_job_);
    scan_of_ = {};
    scan_ = nullptr;
    view.show_message(text);
  };
  if (!output) return say(tr("After a calibration the vehicle is shown here among the points of a scan."));
  if (!calibration::is_usable(output->result)) return say(tr("There is no result under which to look at obstacles."));
  const ScanKey wanted{workbench_.outcome().solution(),
                       keyframe_at(*output, view.chosen_session(), view.chosen_keyframe())};
  if (!wanted.keyframe) return say(tr("No scan of this session was used."));
  const bool settled = !workbench_.activity().calibrating() && !workbench_.activity().solving();
  if (!settled && !view.shows_scan()) view.show_message(tr("The scan is shown when the new solution is complete."));
  // One at a time: whoever steps through scans waits for one of them, not for all.
  if (wanted == scan_of_ || !settled || !view_.seen() || !view.isVisible() || jobs_.running(scan_job_)) return;
  if (workbench_.engine().load_keyframe_scan) start_scan(wanted);
}

void QualityController::start_scan(const ScanKey& wanted) {
  scan_of_ = wanted;
  if (!view_.obstacles()->shows_scan()) view_.obstacles()->show_message(tr("Reading the scan…"));
  scan_job_ = jobs_.start(
      [this, wanted, output = workbench_.outcome().output(), input = workbench_.outcome().input(),
       box = view_.obstacles()->box(),
       load = workbench_.engine().load_keyframe_scan](Progress& progress) -> JobRunner::Deliver {
        const cloud::PointCloud cloud = load(input, *output, *wanted.keyframe, progress);
        if (progress.cancelled()) return [this] { refresh_obstacles(); };
        const auto scan = scan_of_vehicle(cloud, input, *output);
        const auto measured = std::make_shared<const widgets::MeasuredScan>(widgets::measure_scan(*scan, box));
        const motion::Keyframe& keyframe = output->keyframes[*wanted.keyframe];
        return [this, wanted, scan, measured, name = scan_name(input.sessions, keyframe)] {
          if (wanted == scan_of_) take_scan(name, scan, measured);
          refresh_obstacles();
        };
      },
      [this, wanted](const JobFailure& failure) {
        if (wanted == scan_of_) {
          scan_ = nullptr;
          view_.obstacles()->show_message(in_words(failure));
        }
        refresh_obstacles();
      });
}

void QualityController::take_scan(const QString& name, const std::shared_ptr<const widgets::VehicleScan>& scan,
                                  const widgets::MeasuredScanPtr& measured) {
  scan_ = scan->after.empty() ? nullptr : scan;
  if (!scan_) {
    view_.obstacles()->show_message(tr("This session has no points: it may hold LiDAR poses instead of scans."));
    return;
  }
  scan_name_ = name;
  measured_ = measured;
  view_.obstacles()->show_scan(scan_name_, measured_);
  measure_again();
}

void QualityController::measure_again() {
  // One at a time, and always the last box that was typed.
  if (!scan_ || measured_->box == view_.obstacles()->box() || jobs_.running(measure_job_)) return;
  measure_job_ = jobs_.start(
      [this, scan = scan_, box = view_.obstacles()->box()](Progress&) -> JobRunner::Deliver {
        const auto measured = std::make_shared<const widgets::MeasuredScan>(widgets::measure_scan(*scan, box));
        return [this, scan, measured] {
          if (scan == scan_) {
            measured_ = measured;
            view_.obstacles()->show_scan(scan_name_, measured_);
          }
          measure_again();
        };
      },
      [this](const JobFailure& failure) { view_.obstacles()->show_message(in_words(failure)); });
}

void QualityController::refresh_sharpness() {
  const OutputPtr output = workbench_.outcome().output();
  widgets::SharpnessView& view = *view_.sharpness();
  view.offer_maps(output && calibration::is_usable(output->result),
                  output && !output->nominal_known ? tr("start") : QString());
  const bool shown = output && output == sharpness_of_;
  sharpness_of_ = output;
  if (!output) return view.show_message(tr("After a calibration the sharpness of the map is compared here."));
  if (output->sharpness.empty()) return view.show_message(why_no_sharpness(*output));
  if (!shown) view.show_sharpness(output->sharpness);
}

QString QualityController::why_no_sharpness(const pipeline::PipelineOutput& output) const {
  if (!workbench_.map_checks().failure().isEmpty())
    return tr("Not compared: %1").arg(workbench_.map_checks().failure());
  switch (output.map_check) {
    case pipeline::MapCheck::NoScans:
      return tr("Not compared: the sessions hold no scans, or the method has no keyframes.");
    case pipeline::MapCheck::SwitchedOff:
      return tr("Not compared: the map check is switched off in the options (run).");
    case pipeline::MapCheck::Moved:
      if (workbench_.map_checks().checking()) return tr("The result has moved: the map is being compared again…");
      if (workbench_.activity().solving()) return tr("The map is compared when the result is solved.");
      return tr("Not compared since the last decision, which moved the result. Calibrate again (F5).");
    case pipeline::MapCheck::NoOverlap:
      return tr("Not compared: no stretch of eight scans that follow each other turns and overlaps.");
    case pipeline::MapCheck::NotReached:
      if (workbench_.map_checks().checking()) return tr("The map is being compared…");
      if (workbench_.activity().solving()) return tr("The map is compared when the result is solved.");
      break;
    case pipeline::MapCheck::Made:
      break;
  }
  return calibration::is_usable(output.result)
             ? tr("Not compared: the calibration was cancelled before. Calibrate again (F5).")
             : tr("Not compared: there is no result to use.");
}

void QualityController::refresh_hold_out() {
  const OutputPtr output = workbench_.outcome().output();
  widgets::HoldOutView& view = *view_.hold_out();
  if (!output || output->pairs.empty() || workbench_.outcome().input().sessions.size() < 2) {
    jobs_.cancel(hold_out_job_);
    hold_out_job_ = 0;
    hold_out_of_ = -1;
    const bool pairs = output && (!output->pairs.empty() || method_registry::is_from_pairs(output->method));
    return view.show_message(
        output && !pairs ? tr("The method has no pairs: compare its result with those of others instead.")
        : output         ? tr("Needs a second session: the mounting X is solved on one and scored on the other.")
                         : tr("After a calibration of two or more sessions they are compared here."));
  }
  // A solution under way replaces the output soon.
  const bool settled = !workbench_.activity().calibrating() && !workbench_.activity().solving();
  if (workbench_.outcome().solution() != hold_out_of_ && settled && view_.seen() && view.isVisible() &&
      workbench_.engine().check_hold_out)
    start_hold_out(output);
}

void QualityController::start_hold_out(const OutputPtr& output) {
  jobs_.cancel(hold_out_job_);
  hold_out_of_ = workbench_.outcome().solution();
  view_.hold_out()->show_message(tr("Solving every session alone…"));
  auto job = std::make_shared<int>(0);
  hold_out_job_ = jobs_.start(
      [this, job, output, input = workbench_.outcome().input(), names = names_of(workbench_.outcome().input().sessions),
       check = workbench_.engine().check_hold_out](Progress& progress) -> JobRunner::Deliver {
        const auto found = std::make_shared<const pipeline::HoldOut>(check(input, *output, progress));
        return [this, job, found, names] {
          if (*job == hold_out_job_) view_.hold_out()->show_hold_out(*found, names);
        };
      },
      [this, job](const JobFailure& failure) {
        if (*job == hold_out_job_) view_.hold_out()->show_message(in_words(failure));
      });
  *job = hold_out_job_;
}

}  // namespace remount::gui
