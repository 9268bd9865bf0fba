// Between the workbench and the map of all LiDARs, each in its colour.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/gui/workbench/workbench.h"
#include "widgets/map/map_view.h"

namespace remount::gui {

/// Puts together the scans of all LiDARs that were calibrated together: under the nominals, as each was found alone, or
/// as all together are.
class VehicleMapController : public QObject {
  Q_OBJECT
 public:
  static constexpr std::size_t kMostPoints = 10'000'000;  ///< of all LiDARs

  VehicleMapController(Workbench& workbench, widgets::MapView& view, QObject* parent = nullptr);
  void refresh();  ///< the vehicle's LiDARs or their common solution are others
  bool working() const { return jobs_.running(job_); }

 private:
  /// What a map is of.
  struct Subject {
    CommonSolutionPtr common;
    std::size_t recording = 0;
    widgets::MapX x = widgets::MapX::Result;
    bool operator==(const Subject&) const = default;
  };
  struct Scans;  ///< of one recording, that are put together
  using ScansPtr = std::shared_ptr<const Scans>;
  using LoadScans = decltype(Engine::load_map_scans);
  static ScansPtr read_scans(const Subject& subject, const LoadScans& load, Progress& progress);
  static std::vector<scene::MapLayer> layers_of(const Subject& subject, const Scans& scans,
                                                const std::vector<scene::SceneColor>& colors);
  Subject chosen() const;
  void make_map();
  void start(const Subject& subject);
  void say(const QString& text);
  void take(const Subject& subject, const ScansPtr& scans, const scene::MapSceneDataPtr& data);
  QString caption(const Subject& subject, const Scans& scans) const;

  Workbench& workbench_;
  widgets::MapView& view_;
  std::optional<Subject> shown_, making_, failed_;
  ScansPtr scans_;  // of `shown_`
  bool cancelled_ = false;
  int job_ = 0;
  JobRunner jobs_;  // last: its threads end before anything they report to is gone
};

}  // namespace remount::gui
