// One drive: its streams in figures, its map, and its quality over time.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "model/overview/drive_overview.h"
#include "model/pipeline/pipeline.h"

class QComboBox;
class QLabel;

namespace remount::widgets {

class DriveMap;
class DriveTimeline;

class DrivePanel : public QWidget {
  Q_OBJECT
 public:
  explicit DrivePanel(QWidget* parent = nullptr);
  /// One overview for each session, null where it is not known yet.
  void show_drives(const QStringList& names, std::vector<std::shared_ptr<const overview::DriveOverview>> drives);
  void show_output(std::shared_ptr<const pipeline::PipelineOutput> output);
  void show_selected(std::optional<motion::PairIndex> pair);  ///< and its drive
  DriveMap* map() const { return map_; }
  DriveTimeline* timeline() const { return timeline_; }

 signals:
  void pair_selected(motion::PairIndex pair);

 private:
  void show_drive();
  void select_at(double time_s);
  std::optional<motion::SessionIndex> shown_session() const;  // of those that there are
  std::shared_ptr<const overview::DriveOverview> drive() const;
  motion::SessionIndex session_of(motion::PairIndex pair) const;
  double time_s(motion::KeyframeIndex keyframe) const;

  QComboBox* session_;
  QLabel* figures_;
  DriveMap* map_;
  DriveTimeline* timeline_;
  std::vector<std::shared_ptr<const overview::DriveOverview>> drives_;
  std::shared_ptr<const pipeline::PipelineOutput> output_;
  std::optional<motion::PairIndex> selected_;
};

/// "LiDAR: 120, 10.0 Hz, no gaps\nINS: …", for people.
QString drive_figures(const overview::DriveOverview& drive);

}  // namespace remount::widgets
