// Helpers shared by the exporters.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/results/exporters/exporter.h"

namespace remount::results {

/// What each export says at its head: origin, direction, warnings. One sentence a line, without comment signs.
std::vector<std::string> export_header(const Exporter& exporter, const ResultFile& result);

/// The same of several LiDARs, each warning with the LiDAR that it is about.
std::vector<std::string> export_header(const Exporter& exporter, const VehicleFile& vehicle, const ExportNames& names);

/// The lines, each after `before` and followed by `after` and a line feed.
std::string comment_out(const std::vector<std::string>& lines, std::string_view before, std::string_view after = "");

/// Numbers as their shortest exact texts, with `separator` between.
std::string join(const std::vector<double>& numbers, std::string_view separator = " ");

/// Every number of a text that is separated by blanks or commas; lines that begin with '#' are left out.
/// Throws Error(Format) naming the line of what is no finite number.
std::vector<double> numbers_in(std::string_view text, const std::string& where);

/// A rigid transform from the 12 or 16 numbers of its rows; the checks of matrix_from_document.
RigidTransform rigid_from_rows(const std::vector<double>& rows, const std::string& where);

/// Translation, and a unit quaternion in the order x, y, z, w.
RigidTransform rigid_from_quaternion(const std::vector<double>& translation_m,
                                     const std::vector<double>& quaternion_xyzw, const std::string& where);

/// Yaw, pitch and roll whose product gives the rotation back to machine precision everywhere, the poles included
/// (yaw_pitch_roll_from_rotation gives up roll there, which costs 1e-9).
YawPitchRoll exact_angles(const Eigen::Matrix3d& rotation);

/// The text between the quotes of attribute="..." or attribute='...' in the tag that begins at `from`; nothing where
/// there is none.
std::optional<std::string> find_attribute(std::string_view text, std::string_view name, std::size_t from);
/// The same; throws Error(Format) where it is missing.
std::string attribute(std::string_view text, std::string_view name, std::size_t from, const std::string& where);

/// What stands for the letters that have a meaning in XML, and back.
std::string xml_escaped(std::string_view text);
std::string xml_unescaped(std::string_view text);

/// The texts of the elements of that name, each up to the next element: "<node a="b"/>".
std::vector<std::string_view> xml_elements(std::string_view text, std::string_view name);

/// A text without its <!-- --> comments.
std::string without_xml_comments(std::string_view text);

}  // namespace remount::results
