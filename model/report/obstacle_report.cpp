#include "model/report/obstacle_report.h"

#include "algorithms/core/error.h"
#include "messages/drives.h"
#include "model/drive/session_frames.h"
#include "model/pipeline/scan_store.h"

namespace remount::report {
namespace {

cloud::PointCloud load_compensated(const std::shared_ptr<const drive::Session>& session, std::size_t scan,
                                   const RigidTransform& ins_from_lidar, const settings::Settings& settings) {
  const bool has_motion = !session->ins.empty() || !session->world_from_ins.empty();
  if (!has_motion || settings.run.deskew == settings::DeskewMode::Off) return session->scans->load(scan);
  const pipeline::DriveMotion motion({session});
  pipeline::ScanStore store(motion, settings.registration, 0);
  const bool use_sweep =
      settings.run.deskew == settings::DeskewMode::On || (session->sweep.certain && session->sweep.direction_known);
  store.compensate_motion(ins_from_lidar, {use_sweep});
  return store.load({motion::SessionIndex{0}, motion::ScanIndex(scan), session->scans->stamp_ns(scan), 0.0});
}

}  // namespace

quality::ObstacleComparison compare_obstacles_of_scan(const std::shared_ptr<const drive::Session>& session,
                                                      std::size_t scan, const RigidTransform& nominal_ins_from_lidar,
                                                      const RigidTransform& calibrated_ins_from_lidar,
                                                      const settings::Settings& settings,
                                                      const quality::ObstacleOptions& options) {
  if (!session->scans) throw Error(ErrorCode::Unsupported, session->name, say::obstacles_without_scans());
  if (scan >= session->scans->size())
    throw Error(ErrorCode::Contract, session->name, say::no_such_scan(scan, session->scans->size() - 1));
  const cloud::PointCloud cloud = load_compensated(session, scan, calibrated_ins_from_lidar, settings);
  const Eigen::Vector3f hint =
      (calibrated_ins_from_lidar.linear().transpose() * Eigen::Vector3d::UnitZ()).cast<float>();
  const std::vector<cloud::SceneObject> objects =
      cloud::find_objects(cloud, cloud::estimate_up(cloud, hint), settings.objects);
  const RigidTransform vehicle_from_ins = drive::forward_left_up_from(session->ins_axes);
  return quality::compare_obstacles(cloud, objects, vehicle_from_ins * nominal_ins_from_lidar,
                                    vehicle_from_ins * calibrated_ins_from_lidar, options);
}

}  // namespace remount::report
