#include "api/own_recording.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "api/bridge.h"
#include "messages/programs.h"

namespace remount::api {
namespace {

/// Whatever code of others throws is an error of `where`.
template <class Work>
auto of_others(const std::string& where, const Work& work) {
  try {
    return work();
  } catch (const api::Error& error) {
    throw remount::Error(inner_code(error.code()), error.place(), error.expectation().message());
  } catch (const std::exception& error) {
    throw remount::Error(remount::ErrorCode::Io, where, Message::verbatim(error.what()));
  } catch (...) {
    throw remount::Error(remount::ErrorCode::Io, where, say::api_reader_failed());
  }
}

/// Errors of a scan are the pipeline's, whoever's the source is. How many scans there are, and when, is asked once.
class OwnScans final : public drive::ScanSource {
 public:
  /// @param timed whether each scan must have the times of its points
  OwnScans(std::shared_ptr<const api::ScanSource> scans, bool timed, const std::string& where)
      : scans_(std::move(scans)), timed_(timed) {
    of_others(where, [&] {
      const std::size_t count = scans_->size();
      for (std::size_t scan = 0; scan < count; ++scan) {
        stamps_ns_.push_back(scans_->stamp_ns(scan));
        names_.push_back(scans_->name(scan));
      }
    });
  }

  std::size_t size() const override { return stamps_ns_.size(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return stamps_ns_.at(scan); }
  std::string name(std::size_t scan) const override { return names_.at(scan); }
  cloud::PointCloud load(std::size_t scan) const override {
    const Scan loaded = of_others(name(scan), [&] { return scans_->load(scan); });
    if (timed_ && loaded.time_from_stamp_s.empty() && !loaded.points_in_lidar.empty())
      throw remount::Error(remount::ErrorCode::Format, name(scan), say::api_scan_without_times());
    return cloud_of(loaded, name(scan));
  }

 private:
  std::shared_ptr<const api::ScanSource> scans_;
  bool timed_;
  std::vector<std::int64_t> stamps_ns_;
  std::vector<std::string> names_;
};

/// Throws where the first scan that can be loaded has no times: none of them will have.
void require_times(const drive::ScanSource& scans) {
  for (std::size_t scan = 0; scan < scans.size(); ++scan) {
    try {
      scans.load(scan);
      return;
    } catch (const remount::Error& error) {
      if (error.what_happened().code() == say::api_scan_without_times().code()) throw;
    }
  }
}

template <class StampOf>
void require_ascending(std::size_t count, const StampOf& stamp_ns, const std::string& where) {
  for (std::size_t i = 1; i < count; ++i)
    if (stamp_ns(i) <= stamp_ns(i - 1))
      throw remount::Error(remount::ErrorCode::Contract, where, say::api_stamps_descend(i));
}

std::vector<motion::StampedPose> poses_of(const std::vector<Pose>& poses, const std::string& where) {
  require_ascending(
      poses.size(), [&](std::size_t i) { return poses[i].stamp_ns; }, where);
  std::vector<motion::StampedPose> out;
  for (std::size_t i = 0; i < poses.size(); ++i)
    out.push_back({poses[i].stamp_ns, rigid_of_matrix(poses[i].pose, where + ":" + std::to_string(i))});
  return out;
}

motion::InsSample sample_of(const InsSample& given, const std::string& where) {
  const double norm = given.enu_from_ins_xyzw.norm();
  const bool whole = std::isfinite(given.latitude_rad) && std::isfinite(given.longitude_rad) &&
                     std::isfinite(given.height_m) && std::abs(norm - 1.0) < 1e-3;
  if (!whole || std::abs(given.latitude_rad) > kPi / 2.0 || std::abs(given.longitude_rad) > 2.0 * kPi)
    throw remount::Error(remount::ErrorCode::Format, where, say::api_no_ins_sample());
  motion::InsSample sample;
  sample.stamp_ns = given.stamp_ns;
  sample.latitude_rad = given.latitude_rad;
  sample.longitude_rad = given.longitude_rad;
  sample.height_m = given.height_m;
  const Vector4 xyzw = given.enu_from_ins_xyzw / norm;
  sample.enu_from_ins = Eigen::Quaterniond(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
  sample.sigma.position_enu_m.setConstant(given.position_sigma_m);
  sample.sigma.attitude_rad.setConstant(given.attitude_sigma_rad);
  return sample;
}

std::vector<motion::InsSample> samples_of(const std::vector<InsSample>& samples, const std::string& where) {
  require_ascending(
      samples.size(), [&](std::size_t i) { return samples[i].stamp_ns; }, where);
  std::vector<motion::InsSample> out;
  for (std::size_t i = 0; i < samples.size(); ++i)
    out.push_back(sample_of(samples[i], where + ":" + std::to_string(i)));
  return out;
}

drive::ScanTiming timing_of(ScanTimes times) {
  switch (times) {
    case ScanTimes::PerPoint:
      return drive::ScanTiming::PerPoint;
    case ScanTimes::Unknown:
      return drive::ScanTiming::Unknown;
    case ScanTimes::AtStamp:
      break;
  }
  return drive::ScanTiming::Instant;
}

void require_column(std::size_t size, std::size_t points, const std::string& where) {
  if (size != 0 && size != points)
    throw remount::Error(remount::ErrorCode::Format, where, say::api_scan_columns(points, size));
}

bool is_return(const Eigen::Vector3f& point) {
  return point.allFinite() && !point.isZero(0.0f) && point.cwiseAbs().maxCoeff() <= cloud::kFarthestReturn_m;
}

}  // namespace

cloud::PointCloud cloud_of(const Scan& scan, const std::string& where) {
  const std::size_t count = scan.points_in_lidar.size();
  for (const std::size_t size : {scan.time_from_stamp_s.size(), scan.intensity.size(), scan.ring.size()})
    require_column(size, count, where);
  cloud::PointCloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_return(scan.points_in_lidar[i]) ||
        (!scan.time_from_stamp_s.empty() && !std::isfinite(scan.time_from_stamp_s[i]))) {
      ++cloud.dropped_points;
      continue;
    }
    cloud.points.push_back(scan.points_in_lidar[i]);
    if (!scan.time_from_stamp_s.empty()) cloud.time_from_stamp_s.push_back(scan.time_from_stamp_s[i]);
    if (!scan.intensity.empty()) cloud.intensity.push_back(scan.intensity[i]);
    if (!scan.ring.empty()) cloud.ring.push_back(scan.ring[i]);
  }
  return cloud;
}

drive::Session session_of(const Recording& recording) {
  if (recording.ins.empty() == recording.world_from_ins.empty())
    throw remount::Error(remount::ErrorCode::Contract, recording.name, say::api_one_ins());
  if ((recording.scans != nullptr) != recording.odometry_from_lidar.empty())
    throw remount::Error(remount::ErrorCode::Contract, recording.name, say::api_one_lidar());
  drive::Session session;
  session.name = recording.name.empty() ? "recording" : recording.name;
  session.format = "own";
  session.ins = samples_of(recording.ins, session.name + ": ins");
  session.world_from_ins = poses_of(recording.world_from_ins, session.name + ": world_from_ins");
  session.odometry_from_lidar = poses_of(recording.odometry_from_lidar, session.name + ": odometry_from_lidar");
  if (recording.scans) {
    const bool timed = recording.scan_times == ScanTimes::PerPoint;
    const auto scans = std::make_shared<const OwnScans>(recording.scans, timed, session.name + ": scans");
    require_ascending(
        scans->size(), [&](std::size_t i) { return scans->stamp_ns(i); }, session.name + ": scans");
    if (timed) require_times(*scans);
    session.scans = scans;
  }
  session.scan_timing = timing_of(recording.scan_times);
  if (recording.nominal_ins_from_lidar)
    session.nominal_ins_from_lidar = rigid_of_matrix(*recording.nominal_ins_from_lidar, "nominal_ins_from_lidar");
  session.files = recording.files;
  return session;
}

}  // namespace remount::api
