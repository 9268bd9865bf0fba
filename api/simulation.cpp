#include "remount/simulation.h"

#include <utility>

#include "api/bridge.h"
#include "api/option_list.h"
#include "model/formats/documents/document.h"
#include "model/settings/option_reader.h"
#include "model/simulator/simulator.h"

namespace remount::api {
namespace {

simulator::SimulationOptions options_of(const std::map<std::string, OptionValue>& values) {
  const std::string where = "simulate";
  formats::DocumentNode document = formats::DocumentNode::map();
  for (const auto& [name, value] : values) document.add(name, settings::typed_value(text_of(value), where));
  simulator::SimulationOptions options;
  std::vector<Message> problems;
  settings::OptionReader reader(formats::DocumentView(document, where), problems);
  simulator::SimulationOptions::visit(options, reader);
  reader.report_unknown_keys();
  if (!problems.empty()) throw remount::Error(remount::ErrorCode::Contract, "options", in_one(std::move(problems)));
  return options;
}

}  // namespace

std::vector<Option> simulation_options() {
  std::vector<Option> options;
  const simulator::SimulationOptions defaults;
  simulator::SimulationOptions::visit(defaults, OptionLister{"", options});
  return options;
}

SimulatedDrive::SimulatedDrive(std::shared_ptr<const simulator::SimulatedDrive> drive) : drive_(std::move(drive)) {}

Session SimulatedDrive::session() const {
  return Session(std::shared_ptr<const drive::Session>(drive_, &drive_->session));
}
Matrix4 SimulatedDrive::ins_from_lidar() const { return matrix_of(drive_->ins_from_lidar); }
std::vector<Pose> SimulatedDrive::enu_from_ins() const {
  std::vector<Pose> poses;
  for (const motion::StampedPose& pose : drive_->enu_from_ins) poses.push_back({pose.stamp_ns, matrix_of(pose.pose)});
  return poses;
}

SimulatedDrive simulate(const std::map<std::string, OptionValue>& options,
                        const std::optional<Matrix4>& ins_from_lidar) {
  return guarded([&] {
    simulator::SimulationOptions chosen = options_of(options);
    if (ins_from_lidar) chosen.ins_from_lidar = rigid_of_matrix(*ins_from_lidar, "ins_from_lidar");
    return SimulatedDrive(std::make_shared<const simulator::SimulatedDrive>(simulator::simulate_drive(chosen)));
  });
}

std::vector<std::string> drive_formats() { return simulator::drive_formats(); }

void write_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, const std::string& format,
                 const Progress& progress) {
  to_the_end(progress, folder.string(), [&](remount::Progress& inner) {
    simulator::write_drive(drive.inside(), folder, format, 0, inner);
    return true;
  });
}

}  // namespace remount::api
