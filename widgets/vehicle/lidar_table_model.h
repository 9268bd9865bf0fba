// The LiDARs of a vehicle as a table: state, and where each sits.
#pragma once

#include <QAbstractTableModel>
#include <QPalette>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "algorithms/motion/pair.h"
#include "model/pipeline/pipeline.h"

namespace remount::widgets {

/// What is known of a LiDAR.
struct LidarEntry {
  /// How its result came about.
  enum class Standing {
    NotCalibrated,
    Alone,        ///< by itself
    Together,     ///< with the others, and nothing has changed since
    LeftOut,      ///< by itself, for the others' solution could not use it
    ChangedSince  ///< with the others; decisions, options or the nominal are others now
  };
  QString name;
  bool ticked = true;
  bool shown = false;  ///< it is the one that the other panels are about
  Standing standing = Standing::NotCalibrated;
  QString problem{};  ///< why the common solution is not to be trusted where this LiDAR is concerned
  std::shared_ptr<const pipeline::PipelineOutput> output;  ///< null: not calibrated
};

/// A row a LiDAR. Its box is ticked where it is calibrated together with the others.
class LidarTableModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { Name, State, X, Y, Z, Yaw, Pitch, Roll, ColumnCount };
  struct Numbers {
    RigidTransform mounting = RigidTransform::Identity();
    calibration::PerParameter<std::optional<double>> sigma;  ///< m, rad; nothing where it is not observed
  };
  /// In the frame of a LiDAR, by the names of the others.
  using Relatives = std::map<QString, Numbers>;

  using QAbstractTableModel::QAbstractTableModel;
  void show_lidars(std::vector<LidarEntry> lidars);
  /// In place of those in the frame of the INS; nothing: these.
  void show_relative(std::optional<Relatives> relatives);
  void set_palette(const QPalette& palette);
  const std::vector<LidarEntry>& lidars() const { return lidars_; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 signals:
  void ticked(motion::LidarIndex lidar, bool on);

 private:
  QString state_words(const LidarEntry& lidar) const;
  QColor state_color(const LidarEntry& lidar) const;
  QString state_reason(const LidarEntry& lidar) const;
  std::optional<Numbers> numbers(const LidarEntry& lidar) const;
  QString number(const LidarEntry& lidar, calibration::Parameter parameter) const;

  std::vector<LidarEntry> lidars_;
  std::optional<Relatives> relatives_;
  QPalette palette_;
};

}  // namespace remount::widgets
