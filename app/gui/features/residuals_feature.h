// How far each pair is off, over speed, turn rate, time…: why pairs are bad.
#pragma once

#include "app/gui/shell/feature.h"
#include "model/pipeline/pipeline.h"

namespace remount::widgets {
class ResidualsPanel;
}  // namespace remount::widgets

namespace remount::gui {

class ResidualsFeature : public Feature {
  Q_OBJECT
 public:
  explicit ResidualsFeature(MainWindow& window);
  std::vector<TurnQueue::Piece> show_output_later() override;

 private:
  void reject(const std::vector<motion::PairIndex>& pairs, const QString& reason);

  widgets::ResidualsPanel* residuals_;
};

}  // namespace remount::gui
