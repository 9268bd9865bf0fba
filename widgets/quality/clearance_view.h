// The obstacle check of one scan: the vehicle among the points, and what is free around it before and after.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "algorithms/motion/pair.h"
#include "widgets/quality/clearance_plot.h"

class QComboBox;
class QDoubleSpinBox;
class QSpinBox;

namespace remount::widgets {

class FigureTable;
class NoteLabel;

class ClearanceView : public QWidget {
  Q_OBJECT
 public:
  explicit ClearanceView(QWidget* parent = nullptr);

  /// The sessions and how many keyframes each has; what was chosen stays chosen where it can.
  void show_choices(const QStringList& sessions, const std::vector<int>& keyframes);
  std::optional<motion::SessionIndex> chosen_session() const;
  int chosen_keyframe() const;  ///< of that session, from 0

  void show_message(const QString& text);  ///< instead of a scan
  /// Its figures follow the scan's box, whatever is in the editors by now.
  void show_scan(const QString& name, const MeasuredScanPtr& scan);
  /// What the result is compared with: a nominal that was given, or where the program itself started from; and what the
  /// distances rest on that nobody measured.
  void show_nominal_known(bool known, const QString& caution);

  bool shows_scan() const { return shows_scan_; }

  quality::VehicleBox box() const;
  void set_box(const quality::VehicleBox& box);  ///< without box_edited
  ClearancePlot* plot() const { return plot_; }

 signals:
  void scan_chosen();
  void box_edited(const quality::VehicleBox& box);  ///< what is shown is to be measured again

 private:
  QDoubleSpinBox* make_length(const QString& name, const QString& tool_tip, double low_m, double high_m);
  QWidget* make_controls();
  void limit_keyframe();
  void show_figures(const quality::Clearances& before, const quality::Clearances& after);

  std::vector<int> keyframes_;
  bool shows_scan_ = false, nominal_known_ = true;
  ClearancePlot* plot_;
  FigureTable* table_;
  NoteLabel *dashes_, *caution_;  // what the dashes mean, what the numbers rest on
  QComboBox* session_;
  QSpinBox* keyframe_;
  QDoubleSpinBox *front_, *rear_, *half_width_, *height_min_, *height_max_;
};

}  // namespace remount::widgets
