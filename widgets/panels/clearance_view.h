// The obstacle check of one scan: the vehicle among the points, and what is free around it before and after.
#pragma once

#include <QWidget>
#include <array>

#include "widgets/charts/clearance_plot.h"

class QComboBox;
class QDoubleSpinBox;
class QSpinBox;

namespace remount {

class FigureTable;

class ClearanceView : public QWidget {
  Q_OBJECT
 public:
  explicit ClearanceView(QWidget* parent = nullptr);

  /// The sessions and how many keyframes each has; what was chosen stays chosen where it can.
  void show_choices(const QStringList& sessions, const std::vector<int>& keyframes);
  int chosen_session() const;
  int chosen_keyframe() const;  ///< of that session, from 0

  void show_message(const QString& text);  ///< instead of a scan
  void show_scan(const QString& name, std::shared_ptr<const VehicleScan> scan);

  bool shows_scan() const { return scan_ != nullptr; }

  VehicleBox box() const;
  void set_box(const VehicleBox& box);  ///< without box_edited
  ClearancePlot* plot() const { return plot_; }

 signals:
  void scan_chosen();
  void box_edited(const remount::VehicleBox& box);

 private:
  QDoubleSpinBox* make_length(const QString& name, const QString& tool_tip, double low_m, double high_m);
  QWidget* make_controls();
  void limit_keyframe();
  void measure();

  std::vector<int> keyframes_;
  QString name_;
  std::shared_ptr<const VehicleScan> scan_;
  ClearancePlot* plot_;
  FigureTable* table_;
  QComboBox* session_;
  QSpinBox* keyframe_;
  QDoubleSpinBox *front_, *rear_, *half_width_, *height_min_, *height_max_;
};

}  // namespace remount
