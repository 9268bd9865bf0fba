#include <cmath>

#include "algorithms/core/error.h"
#include "messages/exports.h"
#include "messages/general.h"
#include "model/drive/session_frames.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"
#include "model/results/exporters/builtin.h"
#include "model/results/exporters/export_text.h"
#include "model/results/exporters/exporter.h"
#include "model/results/preliminary.h"

namespace remount {

const std::vector<std::unique_ptr<Exporter>>& exporters() {
  static const std::vector<std::unique_ptr<Exporter>> list = [] {
    std::vector<std::unique_ptr<Exporter>> all;
    all.push_back(make_yaml_exporter());
    all.push_back(make_json_exporter());
    all.push_back(make_matrix_exporter());
    all.push_back(make_ros1_exporter());
    all.push_back(make_ros2_exporter());
    all.push_back(make_autoware_exporter());
    all.push_back(make_apollo_exporter());
    all.push_back(make_apollo_rfu_exporter());
    all.push_back(make_kitti_exporter());
    all.push_back(make_opencalib_exporter());
    all.push_back(make_urdf_exporter());
    return all;
  }();
  return list;
}

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
  if (!is_file(path)) return;
  const std::string text = read_text_head(path, kLongest);
  if (text.empty()) return;
  try {
    format.read(text, path.string());
    // A result that a calibration wrote has no such line, and may be the only one.
    if (text.find("remount-result/") == std::string::npos || text.find("Written by Remount") != std::string::npos)
      return;
  } catch (const Error&) {
    // No file of this format: refused below.
  }
  throw Error(ErrorCode::Contract, path.string(), say::export_would_replace(std::string(format.id())));
}

std::vector<Message> export_warnings(const CalibrationResult& result) {
  std::vector<Message> warnings;
  if (!is_usable(result)) warnings.push_back(say::export_not_usable(std::string(to_string(result.status))));
  if (is_preliminary(result)) warnings.push_back(result.message);
  if (result.reference_frame != "ins") warnings.push_back(say::export_other_frame(result.reference_frame));
  if (std::vector<Message> missing = parameter_words(result.observed, false); !missing.empty())
    warnings.push_back(say::export_not_observed(std::move(missing)));
  return warnings;
}

RigidTransform rigid_from_typed(const std::array<double, 6>& six, const std::string& where, ErrorCode code) {
  for (std::size_t i = 3; i < 6; ++i)
    if (std::abs(six[i]) > 360.0)
      throw Error(
          code, where,
          say::mounting_angle_outside(parameter_word(i), {degrees_to_radians(six[i])}, {-2.0 * kPi}, {2.0 * kPi}));
  return rigid_from_six(
      {six[0], six[1], six[2], degrees_to_radians(six[3]), degrees_to_radians(six[4]), degrees_to_radians(six[5])});
}

ReadMounting read_any_mounting(const std::filesystem::path& path, std::vector<Message>* doubts) {
  const std::string text = read_text_file(path, std::uint64_t{64} << 20U);
  const std::string where = path.string();
  if (text.find("remount-result/") != std::string::npos) {
    // A damaged or useless result must not pass as something else.
    const ResultFile result = load_result(path);
    if (!is_usable(result.result))
      throw Error(ErrorCode::Format, where, say::mounting_not_usable(std::string(to_string(result.result.status))));
    return {result.result.ins_from_lidar, result.ins_axes, frames_of(result.result)};
  }
  // Formats whose readers accept what others mean differently come after those that recognise themselves. Exports say
  // which axes they have; those of Apollo's own files cannot be recognised and are taken as the result's.
  std::vector<Message> tried;
  const auto add_tried = [&](Message format, const Error& error) {
    tried.push_back(say::mounting_tried("  ", std::move(format), error.message()));
  };
  for (const char* id : {"opencalib", "ros2", "ros1", "urdf", "apollo", "kitti", "matrix", "autoware"}) {
    try {
      const ReadMounting mounting{exporter(id).read(text, where), exporter(id).axes(text), frames_told_in(text)};
      Message doubt = exporter(id).doubt(text);
      if (doubts && !doubt.empty()) doubts->push_back(say::of_file(where, std::move(doubt)));
      return mounting;
    } catch (const Error& error) {
      add_tried(Message::verbatim(id), error);
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

RigidTransform in_axes_of(const ReadMounting& mounting, const std::optional<InsAxes>& axes,
                          std::vector<Message>& doubts) {
  if (mounting.frames.reference != "ins" || !mounting.axes || !axes || *mounting.axes == *axes)
    return mounting.ins_from_lidar;
  doubts.push_back(say::mounting_turned(std::string(to_string(*mounting.axes)), std::string(to_string(*axes))));
  return forward_left_up_from(axes).inverse() * forward_left_up_from(mounting.axes) * mounting.ins_from_lidar;
}

}  // namespace remount
