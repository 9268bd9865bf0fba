#include "app/gui/features/vehicle_map_controller.h"

#include <QLocale>
#include <algorithm>

#include "app/gui/jobs/error_words.h"
#include "messages/stages.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/swatch.h"
#include "widgets/scene/lidar_colors.h"
#include "widgets/text/model_text.h"

namespace remount::gui {

struct VehicleMapController::Scans {
  struct OfLidar {
    std::size_t lidar;  ///< its place in the common solution
    pipeline::SessionScans scans;
  };
  std::vector<OfLidar> lidars;
  std::size_t unreadable = 0;
};

namespace {

/// Under which a LiDAR is put on the map; nothing where there is none.
std::optional<RigidTransform> mounting_of(const SolvedLidar& lidar, widgets::MapX x) {
  if (x == widgets::MapX::Nominal) {
    const auto& nominal = lidar.job.input.nominal_ins_from_lidar;
    return nominal ? *nominal : lidar.output->initial_ins_from_lidar;
  }
  const pipeline::PipelineOutput& output = x == widgets::MapX::Candidate ? *lidar.alone : *lidar.output;
  if (!calibration::is_usable(output.result)) return std::nullopt;
  return output.result.mounting.ins_from_lidar();
}

/// Its session of a recording; nothing where it has none.
std::optional<motion::SessionIndex> session_of(const SolvedLidar& lidar, std::size_t recording) {
  const auto& recordings = lidar.job.recordings;
  const auto found = std::ranges::find(recordings, index_at<motion::SessionIndex>(signed_of(recording)));
  if (found == recordings.end()) return std::nullopt;
  return index_at<motion::SessionIndex>(found - recordings.begin());
}

/// Places in the list of LiDARs of the vehicle, by which they have their colours.
motion::LidarIndex place_of(const Vehicle& vehicle, const std::string& name) {
  const auto& lidars = vehicle.lidars();
  return index_at<motion::LidarIndex>(std::ranges::find(lidars, name, &VehicleLidar::name) - lidars.begin());
}

}  // namespace

VehicleMapController::VehicleMapController(Workbench& workbench, widgets::MapView& view, QObject* parent)
    : QObject(parent), workbench_(workbench), view_(view) {
  connect(&view_, &widgets::MapView::map_wanted, this, [this] {
    cancelled_ = false;
    failed_.reset();
    make_map();
  });
  connect(&view_, &widgets::MapView::cancel_clicked, this, [this] {
    cancelled_ = true;
    jobs_.cancel(job_);
  });
  connect(&jobs_, &JobRunner::progressed, this,
          [this](int job, const Message& stage, qulonglong done, qulonglong total) {
            if (job == job_) view_.show_progress(stage, done, total);
          });
}

VehicleMapController::Subject VehicleMapController::chosen() const {
  return {workbench_.vehicle().common(), static_cast<std::size_t>(signed_of(view_.chosen_session())), view_.chosen_x()};
}

void VehicleMapController::refresh() {
  const CommonSolutionPtr common = workbench_.vehicle().common();
  if (!common) {
    jobs_.cancel(job_);
    shown_.reset();
    making_.reset();
    scans_ = nullptr;
    cancelled_ = false;
    return view_.show_message(
        tr("The scans of all LiDARs are shown here, each in its colour, once they are calibrated together."));
  }
  QStringList recordings;
  for (const VehicleRecording& recording : workbench_.vehicle().recordings())
    recordings << QString::fromStdString(recording.name);
  const bool nominals = std::ranges::all_of(
      common->lidars, [](const SolvedLidar& lidar) { return lidar.job.input.nominal_ins_from_lidar.has_value(); });
  view_.show_choices(recordings, nominals ? tr("Nominal") : tr("Start"), tr("Each alone"));
  if (!making_ || making_->common != common) cancelled_ = false;
  make_map();
}

VehicleMapController::ScansPtr VehicleMapController::read_scans(const Subject& subject, const LoadScans& load,
                                                                Progress& progress) {
  const std::vector<SolvedLidar>& lidars = subject.common->lidars;
  auto read = std::make_shared<Scans>();
  for (std::size_t l = 0; l < lidars.size() && !progress.cancelled(); ++l)
    if (const auto session = session_of(lidars[l], subject.recording))
      read->lidars.push_back(
          {l, load(lidars[l].job.input, *lidars[l].output, *session, kMostPoints / lidars.size(), progress)});
  for (const auto& lidar : read->lidars) read->unreadable += lidar.scans.unreadable;
  return read;
}

std::vector<scene::MapLayer> VehicleMapController::layers_of(const Subject& subject, const Scans& scans,
                                                             const std::vector<scene::SceneColor>& colors) {
  std::vector<scene::MapLayer> layers;
  for (const Scans::OfLidar& of : scans.lidars)
    if (const auto ins_from_lidar = mounting_of(subject.common->lidars[of.lidar], subject.x))
      layers.push_back({&of.scans.scans, *ins_from_lidar, of.scans.origin_m - scans.lidars.front().scans.origin_m,
                        colors[of.lidar]});
  return layers;
}

void VehicleMapController::make_map() {
  if (!view_.isVisible() || !view_.has_gl() || !workbench_.engine().load_map_scans || cancelled_) return;
  const Subject subject = chosen();
  if (!subject.common || failed_ == subject) return;
  if (shown_ == subject && !working()) return;
  if (making_ == subject && working()) return;
  start(subject);
}

void VehicleMapController::start(const Subject& subject) {
  jobs_.cancel(job_);
  making_ = subject;
  const bool same_scans = shown_ && shown_->common == subject.common && shown_->recording == subject.recording;
  std::vector<scene::SceneColor> colors;
  for (const SolvedLidar& lidar : subject.common->lidars)
    colors.push_back(scene::lidar_color(place_of(workbench_.vehicle(), lidar.job.name)));
  auto job = std::make_shared<int>(0);
  job_ = jobs_.start(
      [this, job, subject, colors, load = workbench_.engine().load_map_scans,
       kept = same_scans ? scans_ : nullptr](Progress& progress) -> JobRunner::Deliver {
        const ScansPtr scans = kept ? kept : read_scans(subject, load, progress);
        progress.report(say::stage_putting_the_scans_together, 0, 0);
        const scene::MapSceneDataPtr data = scene::prepare_map_scene(layers_of(subject, *scans, colors), progress);
        return [this, job, subject, scans, data] {
          if (*job == job_) take(subject, scans, data);
        };
      },
      [this, job](const JobFailure& failure) {
        if (*job != job_) return;
        failed_ = making_;
        say(in_words(failure));
      });
  *job = job_;
  view_.show_progress(say::stage_putting_the_scans_together(), 0, 0);
}

void VehicleMapController::say(const QString& text) {
  shown_.reset();
  view_.show_message(text);
  view_.allow_choice();
}

void VehicleMapController::take(const Subject& subject, const ScansPtr& scans, const scene::MapSceneDataPtr& data) {
  if (!data) {
    if (!cancelled_) return;
    say(tr("Cancelled."));
    return view_.offer_again();
  }
  shown_ = subject;
  scans_ = scans;
  if (scene::facts_of(*data).points == 0) {
    return say(tr("No LiDAR has scans of this recording to put together under this mounting."));
  }
  view_.show_map(caption(subject, *scans), data);
}

QString VehicleMapController::caption(const Subject& subject, const Scans& scans) const {
  QStringList lidars;
  for (const Scans::OfLidar& of : scans.lidars) {
    const SolvedLidar& lidar = subject.common->lidars[of.lidar];
    const QString name = QString::fromStdString(lidar.job.name).toHtmlEscaped();
    if (mounting_of(lidar, subject.x))
      lidars << widgets::swatch(scene::lidar_color(place_of(workbench_.vehicle(), lidar.job.name)), name);
  }
  QString text = lidars.join(QStringLiteral("&nbsp; "));
  if (scans.unreadable > 0) text += ' ' + tr("%1 scans cannot be read.").arg(scans.unreadable);
  return text;
}

}  // namespace remount::gui
