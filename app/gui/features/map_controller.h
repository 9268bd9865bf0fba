// Between the workbench and the accumulated map: scans are read and put together in the background.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/gui/workbench/workbench.h"
#include "widgets/map/map_view.h"

namespace remount::gui {

class MapController : public QObject {
  Q_OBJECT
 public:
  static constexpr std::size_t kMostPoints = 10'000'000;  ///< 0.5 GB

  MapController(Workbench& workbench, widgets::MapView& view, QObject* parent = nullptr);

  void show_candidate(std::optional<calibration::CandidateIndex> candidate);
  void refresh();  ///< the output changed; its candidates are others
  bool working() const { return jobs_.running(job_); }

 private:
  /// What the scans that were read belong to, and the X of the map that is shown.
  struct Made {
    std::vector<motion::Keyframe> keyframes;
    bool offset_applied = false;
    motion::SessionIndex session;
    std::shared_ptr<const pipeline::SessionScans> scans;
    std::optional<RigidTransform> ins_from_lidar;
  };

  void offer();
  void give_up();  ///< what is under way is no longer wanted
  QStringList session_names() const;
  void say(const QString& text);
  std::optional<RigidTransform> chosen_ins_from_lidar() const;
  bool scans_are_current() const;
  void make_map();
  void start(const RigidTransform& ins_from_lidar);
  void take(const std::shared_ptr<const pipeline::SessionScans>& scans, const scene::MapSceneDataPtr& data,
            const RigidTransform& ins_from_lidar);
  QString caption() const;

  Workbench& workbench_;
  widgets::MapView& view_;
  std::optional<calibration::CandidateIndex> candidate_;
  int job_ = 0;
  bool cancelled_ = false;
  Made made_, making_;
  JobRunner jobs_;  // last: its threads end before anything they report to is gone
};

}  // namespace remount::gui
