// What the chosen method tells, and how results of several compare.
#pragma once

#include "app/gui/shell/feature.h"

class QDockWidget;
class QTabWidget;

namespace remount {

class ComparisonView;
class MethodController;
class MethodView;
class PathView;

class MethodsFeature : public Feature {
  Q_OBJECT
 public:
  explicit MethodsFeature(MainWindow& window);
  std::unique_ptr<Kept> hand_over() override;
  void take_over(Kept* kept) override;

 private:
  void show_methods();
  void ask_for_results();  ///< to be compared

  MethodView* method_;
  PathView* paths_;
  ComparisonView* comparison_;
  QTabWidget* pages_;  // of the method, in space, and results compared
  QDockWidget* dock_;
  MethodController* control_;
};

}  // namespace remount
