// The file "remount-vehicle/1": what a calibration of several LiDARs of one vehicle found, of each and of where they
// sit against each other.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/calibration/parameter.h"
#include "model/formats/documents/parse_document.h"
#include "model/results/result_file.h"

namespace remount::results {

inline constexpr std::string_view kVehicleFormat = "remount-vehicle/1";
/// Codes of findings: one LiDAR takes no part in the common solution, or there is none.
inline constexpr std::string_view kLidarLeftOut = "lidar-left-out", kLidarsNotJoined = "lidars-not-joined",
                                  kLidarsContradict = "lidars-contradict";
/// Results of many LiDARs with long lists of pairs.
inline constexpr formats::DocumentLimits kVehicleLimits{256U << 20U, 16000000, 40};

/// One LiDAR of a vehicle, with all that is known of its own result.
struct LidarResult {
  std::string name;
  bool joined = false;  ///< took part in the common solution
  ResultFile file;
};

/// Where one LiDAR sits as another sees it.
struct RelativeRecord {
  std::string lidar_a, lidar_b;
  RigidTransform lidar_a_from_lidar_b = RigidTransform::Identity();
  calibration::PerParameter<std::optional<double>> sigma;  ///< m, rad; nothing where it is not observed
  double height_m = 0.0;                                   ///< of b above a, along z of the INS
  double height_sigma_m = 0.0;
};

/// Whether what two LiDARs see of each other's surroundings goes with what the INS says of them.
struct AgreementRecord {
  std::string lidar_a, lidar_b;
  Vector6d difference = Vector6d::Zero();  ///< by pairs less by the INS: of lidar_a_from_lidar_b, under `perturb`
  Vector6d sigma = Vector6d::Zero();       ///< infinite: the INS or the pairs do not say
  double most_sigmas = 0.0;
};

struct VehicleFile {
  std::vector<LidarResult> lidars;
  std::vector<RelativeRecord> relatives;
  std::vector<AgreementRecord> agreements;
  std::vector<std::vector<std::string>> groups;  ///< of LiDARs that pairs join
  std::vector<drive::Finding> findings;          ///< of what the LiDARs have to do with each other
  std::string version;                           ///< of the program that wrote it
};

/// Nothing where there is none of that name.
const LidarResult* find_lidar(const VehicleFile& vehicle, std::string_view name);
/// Throws Error(Contract) at `where` that lists the names.
const LidarResult& lidar_of(const VehicleFile& vehicle, std::string_view name, const std::string& where);
std::vector<std::string> lidar_names(const VehicleFile& vehicle);
/// Why a LiDAR took no part in the common solution, as a finding has it; empty where none says so.
Message why_not_joined(const VehicleFile& vehicle, const LidarResult& lidar);
/// Takes out the other LiDARs, and what is said of them and those that stay.
void keep_lidars(VehicleFile& vehicle, const std::function<bool(const LidarResult&)>& keep);

formats::DocumentNode vehicle_document(const VehicleFile& vehicle);
/// Throws Error(Format) as result_from_document does, and where names of LiDARs are missing, twice or unknown.
VehicleFile vehicle_from_document(const formats::DocumentView& view);

/// Whether a text, or the beginning of one, is of this format: what it names first of the formats of results.
bool is_vehicle_text(std::string_view text);
/// The same of a file that can be read; false where it cannot.
bool is_vehicle_file(const std::filesystem::path& path);

/// JSON where the name ends in ".json", YAML otherwise. Saved atomically; throws Error(Io).
void save_vehicle(const VehicleFile& vehicle, const std::filesystem::path& path);
/// Throws Error(Io) where it cannot be read, Error(Format) as above.
VehicleFile load_vehicle(const std::filesystem::path& path);
/// The same of a file of several LiDARs or of one: that is the one of a vehicle, and has no name.
VehicleFile load_any_result(const std::filesystem::path& path);

/// A slip of the hand must not cost a calibration: throws Error(Contract) where `path` is a file that holds something
/// else than a result of one LiDAR, or of several.
void check_replaces_result(const std::filesystem::path& path);
void check_replaces_vehicle(const std::filesystem::path& path);

}  // namespace remount::results
