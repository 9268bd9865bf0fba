#include "app/gui/features/vehicle_feature.h"

#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QPointer>
#include <algorithm>

#include "app/gui/basics/ask_to_replace.h"
#include "app/gui/document/report_maker.h"
#include "app/gui/document/vehicle_report.h"
#include "app/gui/features/pair_view_feature.h"
#include "app/gui/features/vehicle_export_dialog.h"
#include "app/gui/features/vehicle_map_controller.h"
#include "app/gui/shell/main_window.h"
#include "messages/rig.h"
#include "model/drive/session_frames.h"
#include "model/project/vehicle_result.h"
#include "widgets/basics/file_dialogs.h"
#include "widgets/basics/rows.h"
#include "widgets/map/map_view.h"
#include "widgets/text/model_text.h"

namespace remount::gui {

VehicleFeature::VehicleFeature(MainWindow& window)
    : Feature(window), panel_(new widgets::LidarsPanel), map_(new widgets::MapView(&window)) {
  dock_ = window.add_dock({.title = tr("LiDARs"),
                           .name = "lidars",
                           .content = panel_,
                           .area = Qt::BottomDockWidgetArea,
                           .help_page = "vehicle"});
  Menus& menus = window.menus();
  Vehicle& vehicle = workbench_.vehicle();
  calibrate_ = menus.add(MenuPlace::CalibrateRun, tr("Calibrate all ticked &LiDARs"), tr("Shift+F5"),
                         [&vehicle] { vehicle.calibrate(); });
  solve_ = menus.add(MenuPlace::CalibrateRun, tr("&Solve all LiDARs together again"), {},
                     [&vehicle] { vehicle.solve_again(); });
  export_ = menus.add(MenuPlace::FileResult, tr("Export all L&iDARs…"), {}, [this] { show_export(); });
  report_ = menus.add(MenuPlace::FileResult, tr("Make report of all LiDARs…"), {}, [this] { ask_for_report(); });
  save_ = menus.add(MenuPlace::FileResult, tr("Save results of all LiDARs…"), {}, [this] { save_results(); });
  window.add_view({map_, tr("All LiDARs"), "vehicle", "show-vehicle-map", tr("The map of all &LiDARs"), {}});
  map_->setObjectName(QStringLiteral("vehicle-map"));
  maps_ = new VehicleMapController(workbench_, *map_, &window);
  connect_panel();
  connect(&vehicle, &Vehicle::changed, this, &VehicleFeature::show_vehicle);
  show_vehicle();
}

void VehicleFeature::connect_panel() {
  Vehicle& vehicle = workbench_.vehicle();
  connect(panel_, &widgets::LidarsPanel::ticked, &vehicle, &Vehicle::tick);
  connect(panel_, &widgets::LidarsPanel::lidar_chosen, &vehicle, &Vehicle::show);
  connect(panel_, &widgets::LidarsPanel::calibrate_clicked, &vehicle, &Vehicle::calibrate);
  connect(panel_, &widgets::LidarsPanel::solve_clicked, &vehicle, &Vehicle::solve_again);
  connect(panel_, &widgets::LidarsPanel::export_clicked, this, &VehicleFeature::show_export);
  connect(panel_, &widgets::LidarsPanel::save_clicked, this, &VehicleFeature::save_results);
  connect(panel_, &widgets::LidarsPanel::cross_pair_chosen, this, &VehicleFeature::show_cross_pair);
}

namespace {

/// Whether two contradict each other, of which either may be wrong, and this is the other one.
bool is_the_other(const drive::Finding& finding, const std::string& lidar) {
  static const std::string kEachOther = say::rig_contradict_each_other({}, {}, {}, 0.0).code();
  const Argument* other = finding.explanation.code() == kEachOther ? finding.explanation.argument("other") : nullptr;
  const auto* name = other ? std::get_if<std::string>(&other->value) : nullptr;
  return name && *name == lidar;
}

/// What the LiDARs have against each other, where that names this one; empty: nothing.
QString problem_of(const results::VehicleFile& vehicle, const std::string& lidar) {
  for (const drive::Finding& finding : vehicle.findings) {
    if (finding.severity != drive::Severity::Problem) continue;
    if (finding.where == drive::Place(lidar)) return widgets::model_text(finding.explanation);
    if (is_the_other(finding, lidar))
      return widgets::LidarsPanel::tr("%1: %2").arg(widgets::model_text(finding.where.words()),
                                                    widgets::model_text(finding.explanation));
  }
  return {};
}

}  // namespace

widgets::LidarEntry VehicleFeature::entry_of(motion::LidarIndex lidar) const {
  using Standing = widgets::LidarEntry::Standing;
  const Vehicle& vehicle = workbench_.vehicle();
  const VehicleLidar& of = vehicle.lidars().at(lidar);
  widgets::LidarEntry entry;
  entry.name = QString::fromStdString(of.name());
  entry.ticked = of.ticked;
  entry.shown = vehicle.shown() == lidar;
  entry.output = vehicle.output_of(lidar);
  if (!entry.output) return entry;
  const results::LidarResult* solved =
      vehicle.common() ? results::find_lidar(vehicle.common()->file, of.name()) : nullptr;
  entry.standing = !solved                        ? Standing::Alone
                   : !vehicle.is_as_solved(lidar) ? Standing::ChangedSince
                   : solved->joined               ? Standing::Together
                                                  : Standing::LeftOut;
  if (solved && entry.standing == Standing::Together) entry.problem = problem_of(vehicle.common()->file, of.name());
  return entry;
}

void VehicleFeature::show_vehicle() {
  const Vehicle& vehicle = workbench_.vehicle();
  std::vector<widgets::LidarEntry> entries;
  for (motion::LidarIndex l; l < vehicle.lidars().size(); ++l) entries.push_back(entry_of(l));
  const bool several = entries.size() > 1;
  panel_->show_lidars(std::move(entries));
  const CommonSolutionPtr& common = vehicle.common();
  widgets::VehicleVerdict verdict;
  if (common) {
    verdict.file = {common, &common->file};
    verdict.heights = common->heights;
    const auto name = [&](motion::LidarIndex l) { return QString::fromStdString(common->lidars[l].job.name); };
    for (const rig::SharedSurfaces& two : common->surfaces)
      verdict.surfaces.push_back({name(two.lidar_a), name(two.lidar_b), two.separate_m, two.together_m});
    verdict.up_to_date = vehicle.up_to_date();
  }
  panel_->show_verdict(verdict);
  if (shown_common_ != common.get()) {
    shown_common_ = common.get();
    QStringList names;
    if (common)
      for (const SolvedLidar& lidar : common->lidars) names << QString::fromStdString(lidar.job.name);
    panel_->show_cross_pairs(common ? common->cross_pairs : std::vector<calibration::CrossPair>(), names);
  }
  show_picture();
  window_.offer_view(*map_, several);
  maps_->refresh();
  if (several && !was_vehicle_) {
    dock_->show();
    dock_->raise();
  }
  was_vehicle_ = several;
  show_state();
}

void VehicleFeature::show_picture() {
  const Vehicle& vehicle = workbench_.vehicle();
  std::vector<widgets::VehiclePicture::Lidar> drawn;
  RigidTransform vehicle_from_ins = RigidTransform::Identity();
  if (const CommonSolutionPtr& common = vehicle.common()) {
    for (motion::LidarIndex l; l < vehicle.lidars().size(); ++l) {
      const OutputPtr output = vehicle.output_of(l);
      const auto solved = std::ranges::find(common->lidars, vehicle.lidars()[l].name(),
                                            [](const SolvedLidar& of) { return of.job.name; });
      if (!output || solved == common->lidars.end() || !results::has_mounting(output->result) ||
          !output->result.mounting.is_of({calibration::BodyFrame::Ins, calibration::BodyFrame::Lidar}))
        continue;
      const calibration::CalibrationResult& result = output->result;
      drawn.push_back({QString::fromStdString(solved->job.name), l,
                       result.estimate(calibration::Parameter::Z).sigma.has_value(), result.mounting.ins_from_lidar(),
                       solved->job.input.nominal_ins_from_lidar, solved->seen_m});
      if (const results::LidarResult* of = results::find_lidar(common->file, solved->job.name))
        vehicle_from_ins = drive::forward_left_up_from(of->file.ins_axes);
    }
  }
  panel_->picture()->show_lidars(std::move(drawn), vehicle_from_ins);
}

bool VehicleFeature::may_write() const {
  const CommonSolutionPtr& common = workbench_.vehicle().common();
  const bool any = common && std::ranges::any_of(common->file.lidars, [](const results::LidarResult& lidar) {
                     return calibration::is_usable(lidar.file.result);
                   });
  return any && workbench_.vehicle().up_to_date() && !workbench_.activity().solving() &&
         !workbench_.activity().calibrating();
}

void VehicleFeature::show_state() {
  const Vehicle& vehicle = workbench_.vehicle();
  const bool busy = workbench_.activity().opening() || workbench_.activity().calibrating();
  const bool several = vehicle.lidars().size() > 1;
  const bool solve = several && !busy && !workbench_.activity().solving() && vehicle.common() && !vehicle.up_to_date();
  panel_->allow(several && !busy, solve, may_write());
  calibrate_->setEnabled(several && !busy);
  solve_->setEnabled(solve);
  export_->setEnabled(may_write());
  save_->setEnabled(may_write());
  report_->setEnabled(may_write());
}

void VehicleFeature::show_cross_pair(widgets::CrossPairIndex index) {
  const CommonSolutionPtr common = workbench_.vehicle().common();
  const auto& load = workbench_.engine().load_cross_clouds;
  if (!load || !common || index >= common->cross_pairs.size()) return;
  workbench_.selection().select(std::nullopt);
  const calibration::CrossPair& cross = common->cross_pairs[index];
  const SolvedLidar &a = common->lidars[cross.lidar_a], &b = common->lidars[cross.lidar_b];
  const QString caption = tr("Pair across: scan of %1 (a) and of %2 (b), %3 s apart")
                              .arg(QString::fromStdString(a.job.name), QString::fromStdString(b.job.name))
                              .arg(cross.pair.gap_s, 0, 'f', 2);
  window_.tell(tr("Reading the scans of the pair across LiDARs…"));
  workbench_.jobs().cancel(clouds_);
  auto job = std::make_shared<int>(0);
  clouds_ = workbench_.jobs().start(
      // The window may be another, in another language, before the scans are read.
      [self = QPointer(this), job, common, index, load, caption](Progress&) -> JobRunner::Deliver {
        const calibration::CrossPair& pair = common->cross_pairs[index];
        const SolvedLidar &of_a = common->lidars[pair.lidar_a], &of_b = common->lidars[pair.lidar_b];
        const auto clouds = std::make_shared<const pipeline::PairClouds>(
            load(of_a.job, *of_a.output, of_b.job, *of_b.output, pair.pair));
        return [self, job, common, pair = pair.pair, clouds, caption, &of_a, &of_b] {
          if (!self || *job != self->clouds_ || self->workbench_.selection().pair()) return;
          if (auto* views = self->window_.feature<PairViewFeature>())
            views->show_cross_pair(
                caption, clouds,
                scene::cross_pair_transforms(pair, *of_a.output, *of_b.output, *of_a.alone, *of_b.alone));
        };
      },
      workbench_.notices().report_failure());
  *job = clouds_;
}

void VehicleFeature::save_results() {
  if (!may_write()) return;
  const QString path =
      widgets::ask_where_to_save(&window_, tr("Save the results of all LiDARs"), widgets::FileKind::Results,
                                 tr("vehicle.yaml"), tr("Results (*.yaml *.json)"));
  if (path.isEmpty()) return;
  const CommonSolutionPtr common = workbench_.vehicle().common();
  window_.tell(tr("Saving the results of all LiDARs…"));
  workbench_.jobs().start(
      [&workbench = workbench_, common, path](Progress& progress) -> JobRunner::Deliver {
        results::check_replaces_vehicle(path.toStdString());
        results::VehicleFile file = common->file;
        std::vector<rig::LidarJob> jobs;
        for (const SolvedLidar& lidar : common->lidars) jobs.push_back(lidar.job);
        std::vector<std::vector<results::InputFile>> inputs = project::hash_lidars(jobs, 0, progress);
        for (std::size_t l = 0; l < file.lidars.size(); ++l)
          if (!inputs[l].empty()) file.lidars[l].file.inputs = std::move(inputs[l]);
        if (progress.cancelled()) return {};
        results::save_vehicle(file, path.toStdString());
        return [&workbench, names = results::lidar_names(file), path] {
          workbench.vehicle().mark_written(names);
          workbench.notices().say(drive::Severity::Note, path, tr("results of all LiDARs saved"));
        };
      },
      workbench_.notices().report_failure());
}

void VehicleFeature::ask_for_report() {
  if (!may_write()) return;
  const QString typed =
      widgets::ask_where_to_save(&window_, tr("Save the report of all LiDARs"), widgets::FileKind::Reports,
                                 tr("vehicle.html"), tr("Web pages (*.html)"), QFileDialog::DontConfirmOverwrite);
  if (typed.isEmpty()) return;
  const QString path = html_beside(typed);
  if (ask_to_replace({path}, window_)) make_vehicle_report(workbench_, path);
}

void VehicleFeature::show_export() {
  if (may_write()) export_vehicle_from(workbench_, workbench_.vehicle().common()->file, window_);
}

}  // namespace remount::gui
