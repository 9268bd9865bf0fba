// What the new mounting means: obstacles of one scan, how far from the vehicle under the nominal and the new X.
#pragma once

#include <QDialog>

#include "algorithms/quality/obstacle_check.h"

class QLabel;
class QTableWidget;

namespace remount::widgets {

class ObstacleDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param nominal_known false: the mounting before is the program's own start, and is named so
  /// @param caution what the distances rest on that nobody measured; empty for nothing
  ObstacleDialog(const QString& scan, bool nominal_known, const QString& caution, QWidget* parent = nullptr);
  const quality::ObstacleOptions& options() const { return options_; }
  /// Of the options that it was made with, which may be others by now.
  void show_comparison(quality::ObstacleComparison found, const quality::ObstacleOptions& options);
  void show_problem(const QString& text);  ///< instead of distances

 signals:
  void options_edited();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QWidget* make_form();
  void show_verdict(const quality::ObstacleComparison& found);
  void recolor();
  void fit_columns();

  quality::ObstacleOptions options_;
  QString before_;  // the name of that mounting
  QLabel* verdict_;
  QTableWidget* table_;
};

}  // namespace remount::widgets
