// Other mountings that the search found, to be looked at.
#pragma once

#include "algorithms/calibration/calibration_result.h"
#include "app/gui/shell/feature.h"

namespace remount::widgets {
class CandidateTableModel;
class CandidatesPanel;
}  // namespace remount::widgets

namespace remount::gui {

class CandidatesFeature : public Feature {
  Q_OBJECT
 public:
  explicit CandidatesFeature(MainWindow& window);
  std::vector<TurnQueue::Piece> show_output_later() override;
  void show_palette(const QPalette& palette) override;

 private:
  void look_at(calibration::CandidateIndex candidate);
  widgets::CandidateTableModel* model_;
  widgets::CandidatesPanel* candidates_;
};

}  // namespace remount::gui
