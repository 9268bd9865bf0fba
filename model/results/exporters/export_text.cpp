#include "model/results/exporters/export_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "messages/drives.h"
#include "messages/exports.h"
#include "messages/rig.h"
#include "model/formats/documents/transform_document.h"
#include "model/formats/files/input_file.h"
#include "remount_version.h"

namespace remount::results {
namespace {

// By these words readers of exports find the frame: files have them whatever the warning is called elsewhere.
constexpr std::string_view kOtherFrame = "the reference frame is the ";
constexpr std::string_view kNotIns = "'s, not the INS's";
constexpr std::string_view kOfLidar = "LiDAR ";

std::string in_file(const Message& warning) {
  static const std::string kFrameCode = say::export_other_frame({}).code();
  if (warning.code() != kFrameCode) return english(warning);
  const std::string frame = std::get<std::string>(warning.argument("frame")->value);
  return std::string(kOtherFrame) + frame + std::string(kNotIns) + ": what is called ins here is " + frame;
}

std::string axes_line(const ResultFile& result) {
  return "Axes of the INS frame in the result: " +
         (result.ins_axes ? std::string(to_string(*result.ins_axes)) : "those of the log, which does not say") +
         ". Metres.";
}

std::vector<std::string> origin_lines(const Message& direction, const std::string& axes) {
  return {"Written by Remount " + std::string(kVersion) + ".", "Direction: " + english(direction) + ".", axes};
}

}  // namespace

calibration::MountingFrames frames_told_in(const std::string& text, const std::string& where) {
  const std::size_t told = text.find(kOtherFrame), end = text.find(kNotIns);
  if (told == std::string::npos || end == std::string::npos || end < told) return {};
  const std::size_t begin = told + kOtherFrame.size();
  const std::string name = text.substr(begin, end - begin);
  const std::optional<calibration::BodyFrame> frame = calibration::frame_from_string(name);
  if (!frame && name.starts_with(kOfLidar))
    throw Error(ErrorCode::Format, where, say::mounting_relative_to_lidar(name.substr(kOfLidar.size())));
  if (!frame) throw Error(ErrorCode::Format, where, say::frame_unknown(name));
  return {*frame, std::nullopt};
}

std::vector<std::string> export_header(const Exporter& exporter, const ResultFile& result) {
  std::vector<std::string> lines = origin_lines(exporter.direction(), axes_line(result));
  for (const Message& warning : export_warnings(result.result)) lines.push_back("WARNING: " + in_file(warning));
  return lines;
}

std::vector<std::string> export_header(const Exporter& exporter, const VehicleFile& vehicle, const ExportNames& names) {
  const bool in_lidar = !names.relative_to.empty();
  const ResultFile none;
  const ResultFile& first = vehicle.lidars.empty() ? none : vehicle.lidars.front().file;
  std::vector<std::string> lines = in_lidar ? origin_lines(say::export_direction_relative(names.relative_to), "Metres.")
                                            : origin_lines(exporter.direction(), axes_line(first));
  if (in_lidar)
    lines.push_back("WARNING: " + std::string(kOtherFrame) + std::string(kOfLidar) + names.relative_to +
                    std::string(kNotIns));
  for (const LidarResult& lidar : vehicle.lidars)
    for (const Message& warning : export_warnings(lidar.file.result))
      lines.push_back("WARNING: " + (lidar.name.empty() ? "" : lidar.name + ": ") + in_file(warning));
  return lines;
}

std::string comment_out(const std::vector<std::string>& lines, std::string_view before, std::string_view after) {
  std::string text;
  for (std::string line : lines) {
    for (char& c : line)
      if (c == '\n' || c == '\r') c = ' ';
    text.append(before).append(line).append(after).append("\n");
  }
  return text;
}

std::string join(const std::vector<double>& numbers, std::string_view separator) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text += (i == 0 ? "" : std::string(separator)) + formats::shortest(numbers[i]);
  return text;
}

std::vector<double> numbers_in(std::string_view text, const std::string& where) {
  std::vector<double> numbers;
  formats::LineReader lines(text);
  std::vector<std::string_view> tokens;
  for (std::string_view line; lines.next(line);) {
    if (formats::trim(line).starts_with("#")) continue;
    std::string blanks(line);
    for (char& c : blanks)
      if (c == ',') c = ' ';
    formats::split_blanks(blanks, tokens);
    for (const std::string_view token : tokens)
      numbers.push_back(formats::require_number(token, say::mounting_value, where, lines.line_number()));
  }
  return numbers;
}

RigidTransform rigid_from_rows(const std::vector<double>& rows, const std::string& where) {
  if (rows.size() != 12 && rows.size() != 16)
    throw Error(ErrorCode::Format, where, say::mounting_matrix_numbers(rows.size()));
  formats::DocumentNode matrix = formats::DocumentNode::sequence();
  for (std::size_t row = 0; row < 4; ++row) {
    const auto begin = rows.begin() + static_cast<long>(4 * row);
    matrix.add(formats::DocumentNode::numbers(4 * row < rows.size() ? std::vector<double>(begin, begin + 4)
                                                                    : std::vector<double>{0, 0, 0, 1}));
  }
  return formats::matrix_from_document(formats::DocumentView(matrix, where));
}

RigidTransform rigid_from_quaternion(const std::vector<double>& translation_m,
                                     const std::vector<double>& quaternion_xyzw, const std::string& where) {
  const formats::DocumentNode quaternion = formats::DocumentNode::numbers(quaternion_xyzw);
  return make_rigid(formats::rotation_from_quaternion_xyzw(formats::DocumentView(quaternion, where)),
                    {translation_m.at(0), translation_m.at(1), translation_m.at(2)});
}

YawPitchRoll exact_angles(const Eigen::Matrix3d& rotation) {
  YawPitchRoll angles;
  angles.yaw_rad = std::atan2(rotation(1, 0), rotation(0, 0));
  const double c = std::cos(angles.yaw_rad), s = std::sin(angles.yaw_rad);
  angles.pitch_rad = std::atan2(-rotation(2, 0), c * rotation(0, 0) + s * rotation(1, 0));
  // Roll of what is left once this very yaw is taken out: near the poles yaw is noise, but the two then cancel.
  angles.roll_rad = std::atan2(s * rotation(0, 2) - c * rotation(1, 2), c * rotation(1, 1) - s * rotation(0, 1));
  return angles;
}

std::optional<std::string> find_attribute(std::string_view text, std::string_view name, std::size_t from) {
  if (from >= text.size()) return std::nullopt;
  std::string_view tag = text.substr(from);
  tag.remove_prefix(std::min(tag.find_first_of(" \t\r\n>"), tag.size()));  // what the element is called
  while (true) {
    const std::size_t equals = tag.find_first_of("=>");
    if (equals == std::string_view::npos || tag[equals] == '>') return std::nullopt;  // the tag ends
    const std::string_view key = formats::trim(tag.substr(0, equals));
    tag.remove_prefix(equals + 1);
    tag.remove_prefix(std::min(tag.find_first_not_of(" \t\r\n"), tag.size()));
    const char quote = tag.empty() ? '\0' : tag.front();
    const std::size_t end = quote == '"' || quote == '\'' ? tag.find(quote, 1) : std::string_view::npos;
    if (end == std::string_view::npos) return std::nullopt;
    if (key == name) return std::string(tag.substr(1, end - 1));
    tag.remove_prefix(end + 1);
  }
}

std::string attribute(std::string_view text, std::string_view name, std::size_t from, const std::string& where) {
  auto found = find_attribute(text, name, from);
  if (!found) throw Error(ErrorCode::Format, where, say::mounting_attribute(std::string(name)));
  return *std::move(found);
}

namespace {

/// The first have to be written so between the quotes that we write; others write the last two so.
constexpr std::array<std::pair<char, std::string_view>, 5> kXmlLetters{
    {{'&', "&amp;"}, {'<', "&lt;"}, {'"', "&quot;"}, {'\'', "&apos;"}, {'>', "&gt;"}}};
constexpr std::ptrdiff_t kEscapedLetters = 3;

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto last = kXmlLetters.begin() + kEscapedLetters;
    const auto letter = std::find_if(kXmlLetters.begin(), last, [c](const auto& one) { return one.first == c; });
    if (letter == last)
      out += c;
    else
      out += letter->second;
  }
  return out;
}

std::string xml_unescaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const auto letter = std::find_if(kXmlLetters.begin(), kXmlLetters.end(),
                                     [&](const auto& one) { return text.starts_with(one.second); });
    out += letter == kXmlLetters.end() ? text.front() : letter->first;
    text.remove_prefix(letter == kXmlLetters.end() ? 1 : letter->second.size());
  }
  return out;
}

std::vector<std::string_view> xml_elements(std::string_view text, std::string_view name) {
  const std::string opening = "<" + std::string(name);
  std::vector<std::string_view> elements;
  for (std::size_t at = text.find(opening); at != std::string_view::npos; at = text.find(opening, at + 1)) {
    const char next = at + opening.size() < text.size() ? text[at + opening.size()] : '\0';
    if (next == ' ' || next == '\t' || next == '\n' || next == '\r')
      elements.push_back(text.substr(at, text.find('<', at + 1) - at));
  }
  return elements;
}

std::string without_xml_comments(std::string_view text) {
  std::string kept;
  while (!text.empty()) {
    const std::size_t begin = text.find("<!--");
    kept += text.substr(0, begin);
    if (begin == std::string_view::npos) break;
    const std::size_t end = text.find("-->", begin);
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 3);
  }
  return kept;
}

}  // namespace remount::results
