#include "app/gui/features/section_feature.h"

#include <QDockWidget>

#include "app/gui/shell/main_window.h"
#include "widgets/pairs/section_panel.h"

namespace remount::gui {
namespace {

constexpr std::size_t kPlaces = 12;

quality::SectionScans scans_of(const pipeline::PairClouds& clouds, const RigidTransform& lidar_b_from_lidar_a) {
  return {clouds.cloud_a().points, clouds.cloud_b().points, lidar_b_from_lidar_a};
}

std::vector<widgets::ShownCut> cuts_of(const pipeline::PairClouds& clouds, const scene::PairTransforms& transforms,
                                       const quality::Section& section) {
  const auto shown = [&](const QString& title, const RigidTransform& lidar_b_from_lidar_a) {
    return widgets::ShownCut{title, quality::cut_section(scans_of(clouds, lidar_b_from_lidar_a), section)};
  };
  std::vector<widgets::ShownCut> cuts{shown(SectionFeature::tr("Before"), transforms.before_lidar_b_from_lidar_a),
                                      shown(SectionFeature::tr("Aligned"), transforms.registered_lidar_b_from_lidar_a)};
  if (transforms.current_known)
    cuts.push_back(shown(SectionFeature::tr("With result"), transforms.current_lidar_b_from_lidar_a));
  return cuts;
}

}  // namespace

SectionFeature::SectionFeature(MainWindow& window) : Feature(window), panel_(new widgets::SectionPanel) {
  dock_ = window.add_dock({.title = tr("Section"),
                           .name = "section",
                           .content = panel_,
                           .help_page = "section",
                           .arrangement = DockSpec::Arrangement::BehindLast,
                           .for_review = true});
  connect(dock_, &QDockWidget::visibilityChanged, this, [this](bool seen) {
    if (seen && behind_) find();
  });
  connect(&workbench_.selection(), &Selection::changed, this, &SectionFeature::show_selected);
  connect(&workbench_.pair_scenes(), &PairScenes::ready, this, &SectionFeature::show_pair);
  connect(panel_, &widgets::SectionPanel::kind_chosen, this, &SectionFeature::find);
  connect(panel_, &widgets::SectionPanel::next_clicked, this, &SectionFeature::next_place);
  connect(panel_, &widgets::SectionPanel::moved, this, [this](const Eigen::Vector3d& by_m) {
    if (!shown_) return;
    place_.reset();
    cut(shown_->moved(by_m));
  });
}

bool SectionFeature::is_seen() const { return panel_->isVisible(); }

void SectionFeature::show_selected(std::optional<motion::PairIndex> pair) {
  pair_ = pair;
  data_ = nullptr;
  shown_.reset();
  jobs_.cancel(job_);
  job_ = 0;
  if (!pair) panel_->show_message(tr("Select a pair to see a section through its two scans."));
}

void SectionFeature::show_pair(motion::PairIndex pair, const scene::PairSceneDataPtr& data) {
  pair_ = pair;
  data_ = data;
  find();
}

/// Only what is seen is worth the work; the rest is found when the panel comes to the front.
void SectionFeature::find() {
  behind_ = !is_seen();
  const OutputPtr output = workbench_.outcome().output();
  if (behind_ || !data_ || !output || !pair_) return;
  const auto clouds = scene::clouds_of(*data_);
  if (!clouds->has_points()) return panel_->show_message(tr("The pair comes from LiDAR poses: there are no scans."));
  start([this, clouds, kind = panel_->kind(),
         transforms = scene::pair_transforms(*output, *pair_)](Progress& progress) -> JobRunner::Deliver {
    auto places = quality::find_sections(scans_of(*clouds, transforms.registered_lidar_b_from_lidar_a), kind,
                                         clouds->scan_b->up_in_lidar.cast<double>(), kPlaces, progress);
    std::vector<widgets::ShownCut> cuts;
    if (!places.empty()) cuts = cuts_of(*clouds, transforms, places.front());
    return [this, places = std::move(places), cuts = std::move(cuts)] {
      places_ = places;
      place_.reset();
      shown_.reset();
      if (places_.empty()) return panel_->show_message(tr("Both scans together show no such surface clearly enough."));
      place_ = 0;
      shown_ = places_.front();
      panel_->show_section(*shown_, cuts, place_, places_.size());
    };
  });
}

void SectionFeature::next_place() {
  if (places_.empty()) return;
  place_ = place_ ? (*place_ + 1) % places_.size() : 0;
  cut(places_[*place_]);
}

void SectionFeature::lay_through(const Eigen::Vector3d& point_in_lidar_b) {
  const OutputPtr output = workbench_.outcome().output();
  if (!data_ || !output || !pair_) return;
  const auto clouds = scene::clouds_of(*data_);
  const scene::PairTransforms transforms = scene::pair_transforms(*output, *pair_);
  place_.reset();
  dock_->show();
  dock_->raise();
  start([this, clouds, transforms, point_in_lidar_b, kind = panel_->kind()](Progress&) -> JobRunner::Deliver {
    const quality::Section section =
        quality::section_at(scans_of(*clouds, transforms.registered_lidar_b_from_lidar_a), kind, point_in_lidar_b,
                            clouds->scan_b->up_in_lidar.cast<double>());
    return [this, section] { cut(section); };
  });
}

void SectionFeature::cut(const quality::Section& section) {
  const OutputPtr output = workbench_.outcome().output();
  if (!data_ || !output || !pair_) return;
  shown_ = section;
  start([this, section, clouds = scene::clouds_of(*data_),
         transforms = scene::pair_transforms(*output, *pair_)](Progress&) -> JobRunner::Deliver {
    return [this, section, cuts = cuts_of(*clouds, transforms, section)] {
      panel_->show_section(section, cuts, place_, places_.size());
    };
  });
}

/// What was asked for before is no longer wanted.
void SectionFeature::start(std::function<JobRunner::Deliver(Progress&)> work) {
  jobs_.cancel(job_);
  auto job = std::make_shared<int>(0);
  job_ = jobs_.start(
      [this, job, work = std::move(work)](Progress& progress) -> JobRunner::Deliver {
        JobRunner::Deliver deliver = work(progress);
        return [this, job, deliver = std::move(deliver)] {
          if (*job == job_) deliver();
        };
      },
      workbench_.notices().report_failure());
  *job = job_;
}

std::vector<TurnQueue::Piece> SectionFeature::show_output_later() {
  return {[this] {
    if (shown_ && is_seen()) cut(*shown_);
  }};
}

}  // namespace remount::gui
