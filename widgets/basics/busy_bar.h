// A progress bar whose waiting costs little: beside a 3-D view, every movement in the window makes all of it anew,
// which takes a core where the graphics card is simulated.
#pragma once

#include <QElapsedTimer>
#include <QProgressBar>
#include <QTimer>

namespace remount::widgets {

/// Where its range is empty, a chunk moves in a few steps a second; otherwise as any progress bar.
class BusyBar : public QProgressBar {
 public:
  explicit BusyBar(QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  bool is_busy() const { return minimum() == maximum(); }
  QTimer step_;
  QElapsedTimer since_;
};

}  // namespace remount::widgets
