// What an empty window says: how to begin.
#pragma once

#include <QWidget>

class QLabel;
class QMenu;
class QPushButton;
class QVBoxLayout;

namespace remount::widgets {

class WelcomePanel : public QWidget {
  Q_OBJECT
 public:
  explicit WelcomePanel(QWidget* parent = nullptr);
  void set_sample_available(bool available);
  void set_open_menu(QMenu& menu);  ///< of what can be opened
  /// What was opened lately, newest first, and how each is called; a few of them are offered.
  void show_recent(const QStringList& paths, const QStringList& labels);

 signals:
  void recent_requested(const QString& path);
  void sample_requested();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QLabel* text_;
  QPushButton *open_, *sample_;
  QLabel* recent_title_;
  QVBoxLayout* recent_;
};

}  // namespace remount::widgets
