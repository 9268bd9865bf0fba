#include "algorithms/geodesy/local_level.h"

#include <GeographicLib/LocalCartesian.hpp>
#include <cmath>
#include <vector>

#include "algorithms/core/error.h"
#include "messages/motion.h"

namespace remount::geodesy {

struct LocalLevel::Cartesian {
  GeographicLib::LocalCartesian local;
};

LocalLevel::LocalLevel(double latitude_rad, double longitude_rad, double height_m) {
  const double latitude_deg = radians_to_degrees(latitude_rad), longitude_deg = radians_to_degrees(longitude_rad);
  if (!(std::abs(latitude_deg) <= 90.0) || !std::isfinite(longitude_deg) || !std::isfinite(height_m))
    throw Error(ErrorCode::Contract, "local level", say::origin_off_globe());
  cartesian_ = std::make_unique<Cartesian>(Cartesian{{latitude_deg, longitude_deg, height_m}});
}

LocalLevel::~LocalLevel() = default;
LocalLevel::LocalLevel(LocalLevel&&) noexcept = default;
LocalLevel& LocalLevel::operator=(LocalLevel&&) noexcept = default;

RigidTransform LocalLevel::enu_from_level(double latitude_rad, double longitude_rad, double height_m) const {
  Eigen::Vector3d position;
  std::vector<double> axes(9);  // by rows
  cartesian_->local.Forward(radians_to_degrees(latitude_rad), radians_to_degrees(longitude_rad), height_m, position.x(),
                            position.y(), position.z(), axes);
  return make_rigid(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(axes.data()), position);
}

RigidTransform LocalLevel::enu_from_ins(const motion::InsSample& sample) const {
  const RigidTransform level = enu_from_level(sample.latitude_rad, sample.longitude_rad, sample.height_m);
  return make_rigid(level.linear() * sample.enu_from_ins.toRotationMatrix(), level.translation());
}

Eigen::Vector3d LocalLevel::position_enu_m(const motion::GnssFix& fix) const {
  return enu_from_level(fix.latitude_rad, fix.longitude_rad, fix.height_m).translation();
}

Eigen::Matrix3d LocalLevel::covariance_enu_m2(const motion::GnssFix& fix) const {
  const Eigen::Matrix3d axes = enu_from_level(fix.latitude_rad, fix.longitude_rad, fix.height_m).linear();
  return axes * fix.covariance_enu_m2 * axes.transpose();
}

}  // namespace remount::geodesy
