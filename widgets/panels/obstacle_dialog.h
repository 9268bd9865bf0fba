// What the new mounting means: obstacles of one scan, how far from the vehicle under the nominal and the new X.
#pragma once

#include <QDialog>
#include <memory>

#include "algorithms/quality/obstacle_check.h"
#include "model/pipeline.h"

class QLabel;
class QTableWidget;

namespace remount {

class ObstacleDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param nominal_known false: `nominal_ins_from_lidar` is the program's own start, and is named so
  /// @param caution what the distances rest on that nobody measured; empty for nothing
  ObstacleDialog(const QString& scan, std::shared_ptr<const PairClouds> clouds,
                 const RigidTransform& nominal_ins_from_lidar, const RigidTransform& calibrated_ins_from_lidar,
                 bool nominal_known, const QString& caution, QWidget* parent = nullptr);

 private:
  QWidget* make_form();
  void check();

  std::shared_ptr<const PairClouds> clouds_;  // scan b is checked
  RigidTransform nominal_ins_from_lidar_, calibrated_ins_from_lidar_;
  ObstacleOptions options_;
  QString before_;  // the name of that mounting
  QLabel* verdict_;
  QTableWidget* table_;
};

}  // namespace remount
