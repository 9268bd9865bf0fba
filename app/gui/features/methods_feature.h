// What the chosen method tells, and how results of several compare.
#pragma once

#include "app/gui/shell/feature.h"

class QDockWidget;
class QTabWidget;

namespace remount::widgets {
class ComparisonView;
class MethodView;
class PathView;
}  // namespace remount::widgets

namespace remount::gui {

class MethodController;

class MethodsFeature : public Feature {
  Q_OBJECT
 public:
  explicit MethodsFeature(MainWindow& window);
  std::unique_ptr<Kept> hand_over() override;
  void take_over(Kept* kept) override;

 private:
  void show_methods();
  void ask_for_results();  ///< to be compared

  widgets::MethodView* method_;
  widgets::PathView* paths_;
  widgets::ComparisonView* comparison_;
  QTabWidget* pages_;  // of the method, in space, and results compared
  QDockWidget* dock_;
  MethodController* control_;
};

}  // namespace remount::gui
