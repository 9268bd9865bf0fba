// What stands in "remount-vehicle/1".
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "messages/results.h"
#include "messages/rig.h"
#include "model/formats/documents/finding_document.h"
#include "model/formats/documents/notations.h"
#include "model/results/sigma_document.h"
#include "model/results/vehicle_file.h"
#include "model/results/version_name.h"

namespace remount::results {

using formats::DocumentNode;

namespace {

/// Six numbers under `perturb`, in m and degrees; null where one is not finite, and `null_is` where it is null.
struct MotionNumbers {
  double null_is;

  DocumentNode write(const Vector6d& motion) const {
    const Eigen::Vector3d turn_deg = motion.tail<3>().unaryExpr([](double rad) { return radians_to_degrees(rad); });
    DocumentNode map = DocumentNode::map();
    map.on_one_line = true;
    map.add("translation_m", DocumentNode::numbers({motion[0], motion[1], motion[2]}));
    map.add("rotation_deg", DocumentNode::numbers({turn_deg[0], turn_deg[1], turn_deg[2]}));
    return map;
  }
  void read(const formats::DocumentView& view, Vector6d& motion) const {
    motion.head<3>() = three(view.at("translation_m"));
    motion.tail<3>() = three(view.at("rotation_deg")).unaryExpr([](double deg) { return degrees_to_radians(deg); });
  }

 private:
  Eigen::Vector3d three(const formats::DocumentView& view) const {
    const std::vector<formats::DocumentView> items = view.items();
    if (items.size() != 3) view.fail(say::vehicle_expected_three());
    Eigen::Vector3d numbers;
    for (int i = 0; i < 3; ++i) {
      const formats::DocumentView& item = items[static_cast<std::size_t>(i)];
      numbers[i] = item.is_null() ? null_is : item.number();
    }
    return numbers;
  }
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool names_are_unique(const VehicleFile& vehicle) {
  std::set<std::string> names;
  for (const LidarResult& lidar : vehicle.lidars) names.insert(lidar.name);
  return !names.empty() && !names.contains("") && names.size() == vehicle.lidars.size();
}

bool names_are_known(const VehicleFile& vehicle) {
  const auto knows = [&](const std::string& name) { return find_lidar(vehicle, name) != nullptr; };
  const auto knows_both = [&](const auto& two) { return knows(two.lidar_a) && knows(two.lidar_b); };
  return std::ranges::all_of(vehicle.relatives, knows_both) && std::ranges::all_of(vehicle.agreements, knows_both) &&
         std::ranges::all_of(vehicle.groups, [&](const auto& group) { return std::ranges::all_of(group, knows); });
}

constexpr formats::Through kResult{result_document,
                                   [](const formats::DocumentView& view) { return result_from_document(view); }};

}  // namespace

void describe(formats::RecordOf<LidarResult> auto& lidar, auto& fields) {
  fields("name", lidar.name);
  fields("joined", lidar.joined);
  fields("result", lidar.file, kResult);
}

void describe(formats::RecordOf<RelativeRecord> auto& two, auto& fields) {
  fields("lidar_a", two.lidar_a);
  fields("lidar_b", two.lidar_b);
  fields("lidar_a_from_lidar_b", two.lidar_a_from_lidar_b);
  fields("sigma", two.sigma, kSigmas);
  fields("height_m", two.height_m);
  fields("height_sigma_m", two.height_sigma_m, formats::Number{kInfinity});
}

void describe(formats::RecordOf<AgreementRecord> auto& two, auto& fields) {
  fields("lidar_a", two.lidar_a);
  fields("lidar_b", two.lidar_b);
  fields("difference", two.difference, MotionNumbers{std::nan("")});
  fields("sigma", two.sigma, MotionNumbers{kInfinity});
  fields("most_sigmas", two.most_sigmas);
}

void describe(formats::RecordOf<VehicleFile> auto& vehicle, auto& fields) {
  fields.only_written("format", DocumentNode::string(kVehicleFormat));
  fields("version", vehicle.version, kVersionName);
  fields("groups", vehicle.groups);
  fields("relatives", vehicle.relatives);
  fields("agreements", vehicle.agreements);
  fields("findings", vehicle.findings, formats::Through{formats::findings_document, formats::findings_from_document});
  fields("lidars", vehicle.lidars);
  fields.require(names_are_unique(vehicle), "lidars", say::vehicle_names_not_unique);
  fields.require(names_are_known(vehicle), say::vehicle_names_not_known);
}

DocumentNode vehicle_document(const VehicleFile& vehicle) { return formats::document_of(vehicle); }

VehicleFile vehicle_from_document(const formats::DocumentView& root) {
  const std::string format = root.at("format").string();
  if (format != kVehicleFormat)
    root.at("format").fail(say::result_of_other_format(std::string(kVehicleFormat), format));
  VehicleFile vehicle;
  formats::read_fields(root, vehicle);
  return vehicle;
}

}  // namespace remount::results
