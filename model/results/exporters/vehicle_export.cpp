#include "model/results/exporters/vehicle_export.h"

#include "messages/rig.h"
#include "model/formats/files/input_file.h"
#include "model/results/exporters/several_exporter.h"

namespace remount::results {
namespace {

/// The name of a format's file with that of the LiDAR in it.
std::string file_name_of(const std::string& of_lidar, const Exporter& format) {
  constexpr std::string_view kAnyLidar = "lidar";
  std::string name(format.file_name());
  const std::size_t at = name.find(kAnyLidar);
  return at == std::string::npos ? of_lidar + "_" + name : name.replace(at, kAnyLidar.size(), of_lidar);
}

/// Throws Error(Contract) where two would be one file, on systems as well that know no capital letters in names.
std::vector<std::string> file_names(const VehicleFile& vehicle, const ExportNames& names, const Exporter& format) {
  std::vector<std::string> files, in_small_letters;
  for (const LidarResult& lidar : vehicle.lidars) {
    files.push_back(file_name_of(called_after(lidar, names), format));
    in_small_letters.push_back(formats::lower_case(files.back()));
  }
  require_different(vehicle, in_small_letters);
  return files;
}

}  // namespace

std::vector<ExportedFile> export_vehicle(const VehicleFile& vehicle, const Exporter& format, const ExportNames& names,
                                         std::vector<LeftOut>& left_out) {
  if (format.holds_several()) return {{std::string(format.file_name()), format.write_all(vehicle, names)}};
  const FrameNames frames = frame_names(vehicle, names, "", "");
  const std::vector<std::string> file_of = file_names(vehicle, names, format);
  std::vector<ExportedFile> files;
  for (std::size_t l = 0; l < vehicle.lidars.size(); ++l) {
    const LidarResult& lidar = vehicle.lidars[l];
    try {
      files.push_back({file_of[l], format.write(lidar.file, {names.ins_frame, frames.lidars[l]})});
    } catch (const Error& error) {
      left_out.push_back({lidar.name, error.what_happened()});
      if (left_out.size() == vehicle.lidars.size()) throw Error(error.code(), lidar.name, error.what_happened());
    }
  }
  return files;
}

void require_frames(const Exporter& format, const std::string& where) {
  if (format.names_frames()) return;
  std::vector<std::string> fit;
  for (const auto& one : exporters())
    if (one->names_frames()) fit.emplace_back(one->id());
  throw Error(ErrorCode::Contract, where, say::export_relative_unfit(std::string(format.id()), std::move(fit)));
}

}  // namespace remount::results
