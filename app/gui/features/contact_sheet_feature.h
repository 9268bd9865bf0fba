// All pairs as small pictures, made in the background.
#pragma once

#include <deque>
#include <map>
#include <set>

#include "app/gui/shell/feature.h"
#include "app/gui/workbench/workbench.h"
#include "widgets/pairs/pair_thumbnail.h"

namespace remount::widgets {
class ContactSheet;
}  // namespace remount::widgets

namespace remount::gui {

class ContactSheetFeature : public Feature {
  Q_OBJECT
 public:
  explicit ContactSheetFeature(MainWindow& window);
  std::vector<TurnQueue::Piece> show_output_later() override;
  void show_palette(const QPalette& palette) override;

 private:
  void show_output_now();
  void forget();
  void start_missing();
  void start(motion::PairIndex pair);
  void take(motion::PairIndex pair, const widgets::PairThumbnail& thumbnail, const scene::PairSceneDataPtr& data);
  void show_legend();

  widgets::ContactSheet* sheet_ = nullptr;  // of the pairs of the table; null where there is none
  widgets::ThumbnailStyle style_;
  std::shared_ptr<const pipeline::PairSource> source_;  // of which the pictures are
  int solution_ = -1;                                   // with which
  std::shared_ptr<scene::ScanScenes> scans_;
  std::deque<scene::PairSceneDataPtr> recent_;  // pairs that follow each other share scans
  std::map<motion::PairIndex, int> running_;    // jobs
  std::set<motion::PairIndex> failed_;          // of which there is no picture
  JobRunner jobs_;                              // last: its threads end before anything they report to is gone
};

}  // namespace remount::gui
