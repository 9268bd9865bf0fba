// Whether sessions agree: each one's pairs under the X of every other, and what their X differ by.
#pragma once

#include <QWidget>

#include "model/pipeline/hold_out.h"

namespace remount::widgets {

class FigureTable;
class NoteLabel;
class VerdictLabel;

class HoldOutView : public QWidget {
  Q_OBJECT
 public:
  explicit HoldOutView(QWidget* parent = nullptr);
  void show_message(const QString& text);  ///< instead of numbers: what is missing, or under way
  void show_hold_out(const pipeline::HoldOut& found, const QStringList& sessions);

 private:
  VerdictLabel* verdict_;
  NoteLabel* dashes_;  // what they mean
  FigureTable *scores_, *differences_;
};

}  // namespace remount::widgets
