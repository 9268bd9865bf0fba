// What the colours of measured values mean.
#pragma once

#include <QWidget>

class QLabel;

namespace remount::widgets {

class ValueLegend : public QWidget {
  Q_OBJECT
 public:
  explicit ValueLegend(QWidget* parent = nullptr);
  void show_range(const QString& name, double low, double high, const QString& unit);
  void show_message(const QString& text);

 private:
  QLabel *low_, *high_;
  QWidget* bar_;
};

}  // namespace remount::widgets
