// How what was chosen goes with what stands in a table: a line for each check, with its sign.
#pragma once

#include <QWidget>

#include "model/guesses/import_checks.h"

class QGridLayout;

namespace remount::widgets {

class CheckList : public QWidget {
  Q_OBJECT
 public:
  explicit CheckList(QWidget* parent = nullptr);
  void show_checks(const guesses::ImportChecks& checks);
  void show_text(const QString& text);
  QString text() const;  ///< of all lines, for tests and for reading aloud

 signals:
  void offset_requested(qint64 added_ns);  ///< what a check advises to add to the times

 private:
  QWidget* make_advice(qint64 added_ns);
  void empty();
  void add_line(int row, const guesses::ImportCheck& check);
  QGridLayout* grid_;
};

}  // namespace remount::widgets
