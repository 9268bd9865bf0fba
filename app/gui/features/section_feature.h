// The section through the selected pair.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/quality/section.h"
#include "app/gui/shell/feature.h"
#include "app/gui/workbench/workbench.h"
#include "widgets/scene/pair_scene_data.h"

class QDockWidget;

namespace remount::widgets {
class SectionPanel;
}  // namespace remount::widgets

namespace remount::gui {

/// Lays the section by itself where both scans see a surface best, and cuts the scans there as they were before, as
/// they were aligned and as the result puts them; in the background.
class SectionFeature : public Feature {
  Q_OBJECT
 public:
  explicit SectionFeature(MainWindow& window);
  std::vector<TurnQueue::Piece> show_output_later() override;
  /// Through a point of the selected pair that the user chose, in the lidar frame of scan b, m.
  void lay_through(const Eigen::Vector3d& point_in_lidar_b);

 private:
  void show_pair(motion::PairIndex pair, const scene::PairSceneDataPtr& data);
  void show_selected(std::optional<motion::PairIndex> pair);
  void find();
  void next_place();
  void cut(const quality::Section& section);
  void start(std::function<JobRunner::Deliver(Progress&)> work);
  bool is_seen() const;

  widgets::SectionPanel* panel_;
  QDockWidget* dock_ = nullptr;
  std::optional<motion::PairIndex> pair_;
  scene::PairSceneDataPtr data_;  // of the pair; null while it is read
  std::vector<quality::Section> places_;
  std::optional<std::size_t> place_;  // which of them is shown
  std::optional<quality::Section> shown_;
  bool behind_ = false;  // the pair is another than the one that is shown: the panel was not seen
  int job_ = 0;
  JobRunner jobs_;  // last: its threads end before anything they report to is gone
};

}  // namespace remount::gui
