#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "messages/exports.h"
#include "messages/general.h"
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

void check_replaces_export(const std::filesystem::path& path, const Exporter& format) {
  constexpr std::size_t kLongest = std::size_t{1} << 20;  // longer, it is no export
  if (!formats::is_file(path)) return;
  const std::string text = formats::read_text_head(path, kLongest);
  if (text.empty()) return;
  try {
    format.require_own(text, path.string());
    // A result that a calibration wrote has no such line, and may be the only one.
    if (text.find("remount-result/") == std::string::npos || text.find("Written by Remount") != std::string::npos)
      return;
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

ReadMounting read_any_mounting(const std::filesystem::path& path, std::vector<Message>* doubts) {
  const std::string text = formats::read_text_file(path, std::uint64_t{64} << 20U);
  const std::string where = path.string();
  if (text.find("remount-result/") != std::string::npos) {
    // A damaged or useless result must not pass as something else.
    const ResultFile result = load_result(path);
    if (!calibration::is_usable(result.result))
      throw Error(ErrorCode::Format, where, say::mounting_not_usable(std::string(to_string(result.result.status))));
    return {result.result.mounting.reference_from_sensor, result.ins_axes, result.result.mounting.frames()};
  }
  if (text.find("remount-beams/") != std::string::npos) throw Error(ErrorCode::Format, where, say::mounting_of_beams());
  std::vector<Message> tried;
  const auto add_tried = [&](Message format, const Error& error) {
    tried.push_back(say::mounting_tried("  ", std::move(format), error.message()));
  };
  for (const Exporter* format : readers_of_foreign_files()) {
    try {
      const ReadMounting mounting{format->read(text, where), format->axes(text), frames_told_in(text, where)};
      Message doubt = format->doubt(text);
      if (doubts && !doubt.empty()) doubts->push_back(say::of_file(where, std::move(doubt)));
      return mounting;
    } catch (const Error& error) {
      add_tried(Message::verbatim(std::string(format->id())), error);
    }
  }
  try {
    const std::vector<double> six = numbers_in(text, where);
    if (six.size() == 6)
      return {rigid_from_typed({six[0], six[1], six[2], six[3], six[4], six[5]}, where, ErrorCode::Format), {}, {}};
  } catch (const Error& error) {
    add_tried(say::mounting_six_numbers(), error);
  }
  throw Error(ErrorCode::Format, where, say::mounting_of_no_format(std::move(tried)));
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
