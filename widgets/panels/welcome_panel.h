// What an empty window says: how to begin.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace remount {

class WelcomePanel : public QWidget {
  Q_OBJECT
 public:
  explicit WelcomePanel(QWidget* parent = nullptr);
  void set_sample_available(bool available);

 signals:
  void open_requested();
  void sample_requested();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QLabel* text_;
  QPushButton* sample_;
};

}  // namespace remount
