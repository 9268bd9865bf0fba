// The vehicle from above and from its right side: every LiDAR with its axes and where it looks.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/motion/pair.h"

namespace remount::widgets {

class VehiclePicture : public QWidget {
  Q_OBJECT
 public:
  struct Lidar {
    QString name;
    motion::LidarIndex place;  ///< whose colour it has
    bool height_known = true;
    RigidTransform ins_from_lidar = RigidTransform::Identity();
    std::optional<RigidTransform> nominal_ins_from_lidar;
    std::vector<Eigen::Vector3f> seen_m;  ///< some of what it sees, in its own frame
  };

  explicit VehiclePicture(QWidget* parent = nullptr);
  /// @param vehicle_from_ins turns the axes of the INS to x forward, y left, z up
  void show_lidars(std::vector<Lidar> lidars, const RigidTransform& vehicle_from_ins);

  QSize minimumSizeHint() const override { return {180, 120}; }
  QSize sizeHint() const override { return {380, 220}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// A projection of the vehicle on a part of the widget.
  struct View {
    Eigen::Vector3d right, up;  // of the picture, in the vehicle's axes
    QRectF area;
    QPointF centre;
    double pixels_per_m = 100.0;
    QPointF at(const Eigen::Vector3d& place_m) const;
  };
  View fitted(const Eigen::Vector3d& right, const Eigen::Vector3d& up, const QRectF& area) const;
  void paint_view(QPainter& painter, const View& view, const QString& title) const;
  void paint_names(QPainter& painter, const View& view) const;
  void paint_scale(QPainter& painter, const View& view) const;
  void paint_field(QPainter& painter, const View& view, const Lidar& lidar) const;
  void paint_axes(QPainter& painter, const View& view, const RigidTransform& vehicle_from_sensor, double length,
                  bool solid) const;

  std::vector<Lidar> lidars_;
  RigidTransform vehicle_from_ins_ = RigidTransform::Identity();
};

}  // namespace remount::widgets
