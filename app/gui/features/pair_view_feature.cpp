#include "app/gui/features/pair_view_feature.h"

#include <QAction>
#include <QSettings>

#include "app/gui/features/obstacle_controller.h"
#include "app/gui/features/pairs_feature.h"
#include "app/gui/features/scene_controller.h"
#include "app/gui/features/section_feature.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/workbench/wording.h"
#include "model/drive/session_frames.h"
#include "widgets/basics/remembering.h"
#include "widgets/basics/theme.h"
#include "widgets/pairs/pair_view.h"
#include "widgets/quality/obstacle_dialog.h"
#include "widgets/text/pair_reasons.h"

namespace remount::gui {
namespace {
const QString kScale = QStringLiteral("view/distance-scale-m");
}  // namespace

PairViewFeature::PairViewFeature(MainWindow& window) : Feature(window), view_(new widgets::PairView(&window)) {
  window.add_view({view_, tr("Pair"), "view", "show-pair", tr("The &pair"), tr("Ctrl+Shift+P")});
  obstacles_ = window.menus().add(MenuPlace::CalibrateResult, tr("Check &obstacles…"), tr("Ctrl+B"),
                                  [this] { show_obstacles(); });
  make_review();
  make_scene();
  connect_selection();
}

void PairViewFeature::make_review() {
  auto* pairs = window_.feature<PairsFeature>();
  if (!pairs) return;
  QAction* flip = pairs->add_review(MenuPlace::ReviewView, "flip", tr("&Flip before and after"), QKeySequence("Space"),
                                    [this] { view_->flip(); });
  // In the whole window Space would no longer press the button that has the focus.
  flip->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  const QList<QWidget*> widgets = pairs->key_widgets() + QList<QWidget*>{view_->canvas()};
  for (QWidget* widget : widgets)
    if (widget) widget->addAction(flip);
  pairs->add_review(MenuPlace::ReviewView, "ground", tr("Show or hide the &ground"), QKeySequence("G"),
                    [this] { view_->show_ground(!view_->shows_ground()); });
  pairs->add_review(MenuPlace::ReviewView, "blink", tr("&Blink"), QKeySequence("B"),
                    [this] { view_->set_blinking(!view_->blinking()); });
}

void PairViewFeature::make_scene() {
  scenes_ = new SceneController(
      workbench_, *view_, [this](motion::PairIndex pair) { return caption(pair); }, &window_);
  if (const QVariant scale = widgets::remembers() ? QSettings().value(kScale) : QVariant(); scale.isValid())
    view_->set_scale(scale.toDouble());
  connect(view_, &widgets::PairView::ground_shown, this,
          [this](bool visible) { workbench_.pair_scenes().tell_ground_apart(!visible); });
  connect(view_, &widgets::PairView::section_wanted, this, [this](const Eigen::Vector3d& point_in_lidar_b) {
    if (auto* sections = window_.feature<SectionFeature>()) sections->lay_through(point_in_lidar_b);
  });
  connect(view_, &widgets::PairView::scale_changed, this, [](double limit_m) {
    if (widgets::remembers()) QSettings().setValue(kScale, limit_m);
  });
}

void PairViewFeature::connect_selection() {
  const Selection& selection = workbench_.selection();
  connect(&selection, &Selection::changed, this, &PairViewFeature::show_selected);
  const PairScenes& scenes = workbench_.pair_scenes();
  connect(&scenes, &PairScenes::reading, this, [this](motion::PairIndex pair) {
    const QString reading = tr("Reading the scans of pair %1…").arg(pair);
    window_.tell(reading);
    if (!view_->shows_scene()) view_->show_message(reading);  // a scene stays until the next is there
  });
  connect(&scenes, &PairScenes::ready, this, &PairViewFeature::show_scans);
  connect(&scenes, &PairScenes::failed, this, [this](motion::PairIndex pair, const QString& why) {
    view_->show_message(tr("The scans of pair %1 cannot be shown.\n%2").arg(pair).arg(why));
    window_.tell(idle_text(workbench_));
  });
}

void PairViewFeature::show_selected(std::optional<motion::PairIndex> pair) {
  shown_clouds_ = nullptr;
  scenes_->forget_clouds();
  obstacles_->setEnabled(false);
  if (!pair) view_->show_message(no_pair_text(workbench_));
}

std::vector<TurnQueue::Piece> PairViewFeature::show_output_later() {
  return {[this] { scenes_->refresh(); }};
}

void PairViewFeature::show_state() {
  const OutputPtr output = workbench_.outcome().output();
  if (!output) view_->show_message(next_hint(workbench_));
  obstacles_->setEnabled(output && calibration::is_usable(output->result) && shown_clouds_);
}

std::optional<calibration::CandidateIndex> PairViewFeature::show_candidate(calibration::CandidateIndex candidate) {
  scenes_->show_candidate(candidate);
  return scenes_->candidate();
}

QString PairViewFeature::scan_name_of(motion::KeyframeIndex keyframe) const {
  return scan_name(workbench_.outcome().input().sessions, workbench_.outcome().output()->keyframes.at(keyframe));
}

QString PairViewFeature::caption(motion::PairIndex pair) const {
  const OutputPtr output = workbench_.outcome().output();
  const motion::Pair& chosen = output->pairs.at(pair);
  QString verdict = widgets::state_text(chosen);
  if (!chosen.reason.empty() && !widgets::tells_who_only(chosen.reason))
    verdict += QStringLiteral(": ") + widgets::reason_words(chosen.reason);
  return tr("Pair %1: %2 → %3, %4 m, %5°. %6")
      .arg(pair)
      .arg(scan_name_of(chosen.keyframe_a), scan_name_of(chosen.keyframe_b))
      .arg(chosen.baseline_m, 0, 'f', 2)
      .arg(radians_to_degrees(chosen.rotation_rad), 0, 'f', 2)
      .arg(verdict);
}

void PairViewFeature::show_cross_pair(const QString& caption, const CloudsPtr& clouds,
                                      const scene::PairTransforms& transforms) {
  scenes_->show_clouds(caption, clouds, transforms);
  window_.show_view(*view_);
  window_.tell(idle_text(workbench_));
}

void PairViewFeature::show_scans(motion::PairIndex pair, const scene::PairSceneDataPtr& data) {
  const OutputPtr output = workbench_.outcome().output();
  if (!output) return;
  shown_clouds_ = scene::clouds_of(*data);
  const bool of_ins_and_lidar =
      output->result.mounting.is_of({calibration::BodyFrame::Ins, calibration::BodyFrame::Lidar});
  obstacles_->setEnabled(calibration::is_usable(output->result) && of_ins_and_lidar &&
                         !shown_clouds_->scan_b->objects.empty());
  if (shown_clouds_->has_points())
    scenes_->show_pair(pair, data);
  else
    view_->show_message(tr("Pair %1 comes from LiDAR poses: there are no scans to show.").arg(pair));
  window_.tell(idle_text(workbench_));
}

void PairViewFeature::show_obstacles() {
  const OutputPtr output = workbench_.outcome().output();
  const std::optional<motion::PairIndex> selected = workbench_.selection().pair();
  if (!output || !shown_clouds_ || !selected) return;
  const motion::Pair& pair = output->pairs.at(*selected);
  const RigidTransform vehicle_from_ins = drive::vehicle_from_ins(workbench_.outcome().input().sessions);
  QString scan = tr("scan b of pair %1, %2").arg(*selected).arg(scan_name_of(pair.keyframe_b));
  const Vehicle& vehicle = workbench_.vehicle();
  if (const std::optional<motion::LidarIndex> lidar = vehicle.shown(); lidar && vehicle.lidars().size() > 1)
    scan = tr("%1, of the LiDAR %2").arg(scan, QString::fromStdString(vehicle.lidars()[*lidar].name()));
  auto* dialog = new widgets::ObstacleDialog(scan, output->nominal_known, distance_caution(workbench_), &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  new ObstacleController(workbench_.jobs(), *dialog, shown_clouds_, vehicle_from_ins * output->initial_ins_from_lidar,
                         vehicle_from_ins * output->result.mounting.ins_from_lidar());
  dialog->show();
}

}  // namespace remount::gui
