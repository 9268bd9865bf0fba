// All LiDARs of the vehicle: which are calibrated together, where each sits, and whether they agree.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "model/results/vehicle_file.h"
#include "widgets/vehicle/cross_pair_table_model.h"
#include "widgets/vehicle/lidar_table_model.h"
#include "widgets/vehicle/vehicle_picture.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;
class QTabWidget;
class QTextBrowser;

namespace remount::widgets {

/// How far surfaces that two LiDARs see lie apart.
struct SurfacesOfTwo {
  QString lidar_a, lidar_b;
  double alone_m = 0.0, together_m = 0.0;
};

/// What LiDARs say together.
struct VehicleVerdict {
  std::shared_ptr<const results::VehicleFile> file;  ///< null: not calibrated together yet
  std::vector<Message> heights;
  std::vector<SurfacesOfTwo> surfaces;
  bool up_to_date = true;
};

class LidarsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit LidarsPanel(QWidget* parent = nullptr);
  void show_lidars(std::vector<LidarEntry> lidars);
  void show_verdict(const VehicleVerdict& verdict);
  void show_cross_pairs(std::vector<calibration::CrossPair> pairs, const QStringList& names);
  /// What can be asked for now.
  void allow(bool calibrate, bool solve, bool write);
  VehiclePicture* picture() const { return picture_; }
  QTableView* table() const { return table_; }
  QTableView* cross_table() const { return cross_table_; }
  LidarTableModel* model() const { return model_; }
  QTabWidget* pages() const { return pages_; }
  /// The LiDAR in whose frame numbers are; empty: the INS.
  QString reference() const;

 signals:
  void ticked(motion::LidarIndex lidar, bool on);
  void lidar_chosen(motion::LidarIndex lidar);
  void calibrate_clicked();
  void solve_clicked();
  void export_clicked();
  void save_clicked();
  void cross_pair_chosen(widgets::CrossPairIndex pair);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QHBoxLayout* make_buttons();
  QWidget* make_table();
  QWidget* make_cross_pairs();
  void offer_references();
  void show_reference();
  void filter_cross_pairs();
  void show_words(const VehicleVerdict& verdict);
  QString words_of(const VehicleVerdict& verdict) const;
  QString findings_of(const results::VehicleFile& vehicle) const;

  LidarTableModel* model_;
  CrossPairTableModel* cross_model_;
  QSortFilterProxyModel* cross_order_;
  QTableView *table_, *cross_table_;
  QTabWidget* pages_;
  VehiclePicture* picture_;
  QTextBrowser* words_;
  QLabel* hint_;  // in place of a table without LiDARs
  QComboBox *reference_ = nullptr, *cross_of_ = nullptr;
  QPushButton *calibrate_ = nullptr, *solve_ = nullptr, *export_ = nullptr, *save_ = nullptr;
  std::shared_ptr<const results::VehicleFile> file_;
  VehicleVerdict verdict_;
};

}  // namespace remount::widgets
