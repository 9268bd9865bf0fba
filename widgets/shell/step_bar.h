// The way of a calibration, at the top of the window: what is done, what is next.
#pragma once

#include <QWidget>
#include <array>

class QToolButton;

namespace remount::widgets {

enum class Step { Load, Pairs, Align, Review, Solve, Check, Export };
enum class StepState { Waiting, Next, Running, Done, Attention };

struct StepInfo {
  StepState state = StepState::Waiting;
  QString detail;  ///< "2 sessions"
};
inline constexpr std::size_t kStepCount = 7;

class StepBar : public QWidget {
  Q_OBJECT
 public:
  explicit StepBar(QWidget* parent = nullptr);
  void show_steps(const std::array<StepInfo, kStepCount>& steps);

 signals:
  void step_clicked(widgets::Step step);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void restyle();
  std::array<StepInfo, kStepCount> steps_;
  std::array<QToolButton*, kStepCount> buttons_{};
  std::array<QString, kStepCount> helps_;
};

}  // namespace remount::widgets
