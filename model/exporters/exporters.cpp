#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/exporters/builtin.h"
#include "model/exporters/export_text.h"
#include "model/exporters/exporter.h"
#include "model/io/input_file.h"
#include "model/io/text_file.h"
#include "model/preliminary.h"
#include "model/session_frames.h"

namespace remount {
namespace {

constexpr const char kOtherFrame[] = "the reference frame is the ";
constexpr const char kNotIns[] = "'s, not the INS's: what is called ins here is ";

}  // namespace

MountingFrames frames_told_in(const std::string& text) {
  const std::size_t told = text.find(kOtherFrame), end = text.find(kNotIns);
  if (told == std::string::npos || end == std::string::npos || end < told) return {};
  const std::size_t begin = told + std::string(kOtherFrame).size();
  return {text.substr(begin, end - begin), ""};
}

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
  std::string known;
  for (const auto& candidate : exporters()) {
    if (candidate->id() == id) return *candidate;
    known += (known.empty() ? "" : ", ") + std::string(candidate->id());
  }
  throw Error(ErrorCode::Contract, "", "there is no export format \"" + std::string(id) + "\"; known are " + known);
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
  throw Error(ErrorCode::Contract, path.string(),
              "is there and is no export in the format " + std::string(format.id()) +
                  ": name another file, or remove it first");
}

std::vector<std::string> export_warnings(const CalibrationResult& result) {
  std::vector<std::string> warnings;
  if (!is_usable(result))
    warnings.push_back("the calibration found no usable result (status " + std::string(to_string(result.status)) +
                       "); do not use these numbers");
  if (is_preliminary(result)) warnings.push_back(english(result.message));
  if (result.reference_frame != "ins")
    warnings.push_back(std::string(kOtherFrame) + result.reference_frame + kNotIns + result.reference_frame);
  const std::string missing = parameter_names(result.observed, false);
  if (!missing.empty()) warnings.push_back("not observed, and therefore nominal or in doubt, not measured: " + missing);
  return warnings;
}

RigidTransform rigid_from_typed(const std::array<double, 6>& six, const std::string& where, ErrorCode code) {
  for (std::size_t i = 3; i < 6; ++i)
    if (std::abs(six[i]) > 360.0)
      throw Error(code, where,
                  std::string(kParameterNames[i]) + " " + shortest(six[i]) +
                      " deg is outside -360 to 360 deg; the order is x,y,z,yaw,pitch,roll");
  return rigid_from_six(
      {six[0], six[1], six[2], degrees_to_radians(six[3]), degrees_to_radians(six[4]), degrees_to_radians(six[5])});
}

ReadMounting read_any_mounting(const std::filesystem::path& path, std::vector<std::string>* doubts) {
  const std::string text = read_text_file(path, std::uint64_t{64} << 20U);
  const std::string where = path.string();
  if (text.find("remount-result/") != std::string::npos) {
    // A damaged or useless result must not pass as something else.
    const ResultFile result = load_result(path);
    if (!is_usable(result.result))
      throw Error(
          ErrorCode::Format, where,
          "is a result without a usable transform (status " + std::string(to_string(result.result.status)) + ")");
    return {result.result.ins_from_lidar, result.ins_axes, frames_of(result.result)};
  }
  // Formats whose readers accept what others mean differently come after those that recognise themselves. Exports say
  // which axes they have; those of Apollo's own files cannot be recognised and are taken as the result's.
  std::string tried;
  for (const char* id : {"opencalib", "ros2", "ros1", "urdf", "apollo", "kitti", "matrix", "autoware"}) {
    try {
      const ReadMounting mounting{exporter(id).read(text, where), exporter(id).axes(text), frames_told_in(text)};
      const std::string doubt = exporter(id).doubt(text);
      if (doubts && !doubt.empty()) doubts->push_back(where + ": " + doubt);
      return mounting;
    } catch (const Error& error) {
      tried += "\n  " + std::string(id) + ": " + error.what();
    }
  }
  try {
    const std::vector<double> six = numbers_in(text, where);
    if (six.size() == 6)
      return {rigid_from_typed({six[0], six[1], six[2], six[3], six[4], six[5]}, where, ErrorCode::Format), {}, {}};
  } catch (const Error& error) {
    tried += "\n  six numbers: " + std::string(error.what());
  }
  throw Error(ErrorCode::Format, where, "holds no transform in a format that is known here:" + tried);
}

RigidTransform in_axes_of(const ReadMounting& mounting, const std::optional<InsAxes>& axes,
                          std::vector<std::string>& doubts) {
  if (mounting.frames.reference != "ins" || !mounting.axes || !axes || *mounting.axes == *axes)
    return mounting.ins_from_lidar;
  doubts.push_back("the mounting is given in INS axes " + std::string(to_string(*mounting.axes)) +
                   "; it is turned to those of the log, " + std::string(to_string(*axes)));
  return forward_left_up_from(axes).inverse() * forward_left_up_from(mounting.axes) * mounting.ins_from_lidar;
}

}  // namespace remount
