#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "messages/exports.h"
#include "messages/general.h"
#include "messages/rig.h"
#include "model/drive/session_frames.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"
#include "model/results/exporters/export_text.h"
#include "model/results/exporters/exporter.h"
#include "model/results/preliminary.h"

namespace remount::results {

// Each is made by a file of this folder.
std::unique_ptr<Exporter> make_yaml_exporter();
std::unique_ptr<Exporter> make_json_exporter();
std::unique_ptr<Exporter> make_matrix_exporter();
std::unique_ptr<Exporter> make_ros1_exporter();
std::unique_ptr<Exporter> make_ros2_exporter();
std::unique_ptr<Exporter> make_autoware_exporter();
std::unique_ptr<Exporter> make_apollo_exporter();
std::unique_ptr<Exporter> make_apollo_rfu_exporter();
std::unique_ptr<Exporter> make_kitti_exporter();
std::unique_ptr<Exporter> make_opencalib_exporter();
std::unique_ptr<Exporter> make_urdf_exporter();
std::unique_ptr<Exporter> make_beams_exporter();

namespace {

// In the order in which they are shown.
constexpr std::unique_ptr<Exporter> (*kMakers[])() = {
    make_yaml_exporter,  make_json_exporter,      make_matrix_exporter, make_ros1_exporter,
    make_ros2_exporter,  make_autoware_exporter,  make_apollo_exporter, make_apollo_rfu_exporter,
    make_kitti_exporter, make_opencalib_exporter, make_urdf_exporter,   make_beams_exporter,
};

}  // namespace

const std::vector<std::unique_ptr<Exporter>>& exporters() {
  static const std::vector<std::unique_ptr<Exporter>> list = [] {
    std::vector<std::unique_ptr<Exporter>> all;
    for (const auto make : kMakers) all.push_back(make());
    return all;
  }();
  return list;
}

namespace {

// The strictest first; of those that are alike, as they are shown.
std::vector<const Exporter*> readers_of_foreign_files() {
  std::vector<const Exporter*> readers;
  for (const auto& format : exporters())
    if (format->strictness() > 0) readers.push_back(format.get());
  std::stable_sort(readers.begin(), readers.end(),
                   [](const Exporter* a, const Exporter* b) { return a->strictness() > b->strictness(); });
  return readers;
}

}  // namespace

const Exporter& exporter(std::string_view id) {
  std::vector<std::string> known;
  for (const auto& candidate : exporters()) {
    if (candidate->id() == id) return *candidate;
    known.emplace_back(candidate->id());
  }
  throw Error(ErrorCode::Contract, "", say::export_no_such_format(std::string(id), std::move(known)));
}

std::string Exporter::write_all(const VehicleFile&, const ExportNames&) const {
  throw Error(ErrorCode::Contract, std::string(id()), say::export_one_lidar());
}

void check_replaces_export(const std::filesystem::path& path, const Exporter& format) {
  constexpr std::size_t kLongest = std::size_t{1} << 20;  // longer, it is no export
  if (!formats::is_file(path)) return;
  const std::string text = formats::read_text_head(path, kLongest);
  if (text.empty()) return;
  try {
    format.require_own(text, path.string());
    if (text.find("Written by Remount") != std::string::npos) return;
    // A result that a calibration wrote has no such line, and may be the only one. Nor has a file of the user's with
    // the mountings of a whole vehicle, of which an export would keep the LiDARs alone.
    const bool several = format.holds_several() && format.read_all(text, path.string()).size() > 1;
    if (!several && text.find("remount-result/") == std::string::npos) return;
  } catch (const Error&) {
    // No file of this format: refused below.
  }
  throw Error(ErrorCode::Contract, path.string(), say::export_would_replace(std::string(format.id())));
}

std::vector<Message> export_warnings(const calibration::CalibrationResult& result) {
  std::vector<Message> warnings;
  if (!calibration::is_usable(result))
    warnings.push_back(say::export_not_usable(std::string(to_string(result.status))));
  if (is_preliminary(result)) warnings.push_back(result.message);
  if (result.mounting.reference != calibration::BodyFrame::Ins)
    warnings.push_back(say::export_other_frame(std::string(to_string(result.mounting.reference))));
  if (result.mounting.sensor != calibration::BodyFrame::Lidar)
    warnings.push_back(say::export_other_sensor(std::string(to_string(result.mounting.sensor))));
  if (std::vector<Message> missing = calibration::parameter_words(~result.observed()); !missing.empty())
    warnings.push_back(say::export_not_observed(std::move(missing)));
  return warnings;
}

RigidTransform rigid_from_typed(const std::array<double, 6>& six, const std::string& where, ErrorCode code) {
  for (std::size_t i = 3; i < 6; ++i)
    if (std::abs(six[i]) > 360.0)
      throw Error(code, where,
                  say::mounting_angle_outside(calibration::parameter_word(calibration::kParameters[i]),
                                              {degrees_to_radians(six[i])}, {-2.0 * kPi}, {2.0 * kPi}));
  return rigid_from_six(
      {six[0], six[1], six[2], degrees_to_radians(six[3]), degrees_to_radians(six[4]), degrees_to_radians(six[5])});
}

namespace {

constexpr std::uint64_t kLongestMounting = std::uint64_t{256} << 20U;

NamedMounting of_result(const ResultFile& result, const std::string& where) {
  if (!calibration::is_usable(result.result))
    throw Error(ErrorCode::Format, where, say::mounting_not_usable(std::string(to_string(result.result.status))));
  return {"", {result.result.mounting.reference_from_sensor, result.ins_axes, result.result.mounting.frames()}};
}

std::vector<NamedMounting> of_vehicle(const VehicleFile& vehicle, const std::string& where) {
  std::vector<NamedMounting> mountings;
  for (const LidarResult& lidar : vehicle.lidars) {
    if (!calibration::is_usable(lidar.file.result)) continue;
    mountings.push_back(of_result(lidar.file, where));
    mountings.back().name = lidar.name;
  }
  return mountings;
}

/// All that the text holds, or the first where one is wanted and the format says which that is.
std::vector<NamedMounting> read_as(const Exporter& format, const std::string& text, const std::string& where,
                                   bool only_one) {
  const calibration::MountingFrames frames = frames_told_in(text, where);
  std::vector<NamedMounting> mountings;
  if (only_one) return {{"", {format.read(text, where), format.axes(text), frames}}};
  for (const NamedTransform& one : format.read_all(text, where))
    mountings.push_back({one.name, {one.ins_from_lidar, format.axes(text), frames}});
  return mountings;
}

/// Of several that a text holds, the first was taken: which there are.
Message taken_first(const Exporter& format, const std::string& text, const std::string& where) {
  std::vector<std::string> names;
  try {
    for (const NamedTransform& one : format.read_all(text, where)) names.push_back(one.name);
  } catch (const Error&) {
    return {};  // the others are none that could be taken
  }
  return names.size() < 2 ? Message() : say::mounting_first_of(std::move(names));
}

std::vector<NamedMounting> read_foreign(const std::string& text, const std::string& where, bool only_one,
                                        std::vector<Message>* doubts) {
  (void)frames_told_in(text, where);  // what no reader takes is told once, not by each of them
  std::vector<Message> tried;
  const auto add_tried = [&](Message format, const Error& error) {
    tried.push_back(say::mounting_tried("  ", std::move(format), error.message()));
  };
  const auto add_doubt = [&](Message doubt) {
    if (doubts && !doubt.empty()) doubts->push_back(say::of_file(where, std::move(doubt)));
  };
  for (const Exporter* format : readers_of_foreign_files()) {
    try {
      std::vector<NamedMounting> mountings = read_as(*format, text, where, only_one);
      add_doubt(format->doubt(text));
      if (only_one) add_doubt(taken_first(*format, text, where));
      return mountings;
    } catch (const Error& error) {
      add_tried(Message::verbatim(std::string(format->id())), error);
    }
  }
  try {
    const std::vector<double> six = numbers_in(text, where);
    if (six.size() == 6)
      return {
          {"", {rigid_from_typed({six[0], six[1], six[2], six[3], six[4], six[5]}, where, ErrorCode::Format), {}, {}}}};
  } catch (const Error& error) {
    add_tried(say::mounting_six_numbers(), error);
  }
  throw Error(ErrorCode::Format, where, say::mounting_of_no_format(std::move(tried)));
}

std::vector<NamedMounting> read_any(const std::filesystem::path& path, bool only_one, std::vector<Message>* doubts) {
  const std::string text = formats::read_text_file(path, kLongestMounting);
  const std::string where = path.string();
  // A damaged or useless result must not pass as something else.
  if (is_vehicle_text(text) && !only_one) return of_vehicle(load_vehicle(path), where);
  if (text.find("remount-result/") != std::string::npos) return {of_result(load_result(path), where)};
  if (text.find("remount-beams/") != std::string::npos) throw Error(ErrorCode::Format, where, say::mounting_of_beams());
  return read_foreign(text, where, only_one, doubts);
}

std::vector<NamedMounting> read_mountings_as(const Exporter& format, const std::filesystem::path& path, bool only_one,
                                             std::vector<Message>* doubts) {
  const std::string text = formats::read_text_file(path, kLongestMounting), where = path.string();
  std::vector<NamedMounting> mountings = read_as(format, text, where, only_one);
  if (Message doubt = only_one && doubts ? taken_first(format, text, where) : Message(); !doubt.empty())
    doubts->push_back(say::of_file(where, std::move(doubt)));
  return mountings;
}

}  // namespace

ReadMounting read_mounting_as(const Exporter& format, const std::filesystem::path& path, std::vector<Message>* doubts) {
  return read_mountings_as(format, path, true, doubts).front().mounting;
}

std::vector<NamedMounting> read_mountings_as(const Exporter& format, const std::filesystem::path& path) {
  return read_mountings_as(format, path, false, nullptr);
}

ReadMounting read_any_mounting(const std::filesystem::path& path, std::vector<Message>* doubts) {
  return read_any(path, true, doubts).front().mounting;
}

std::vector<NamedMounting> read_any_mountings(const std::filesystem::path& path, std::vector<Message>* doubts) {
  return read_any(path, false, doubts);
}

RigidTransform in_axes_of(const ReadMounting& mounting, const std::optional<drive::InsAxes>& axes,
                          std::vector<Message>& doubts) {
  if (mounting.frames.reference != calibration::BodyFrame::Ins || !mounting.axes || !axes || *mounting.axes == *axes)
    return mounting.ins_from_lidar;
  doubts.push_back(say::mounting_turned(std::string(to_string(*mounting.axes)), std::string(to_string(*axes))));
  return drive::forward_left_up_from(axes).inverse() * drive::forward_left_up_from(mounting.axes) *
         mounting.ins_from_lidar;
}

}  // namespace remount::results
