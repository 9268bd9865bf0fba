#include "model/results/beam_file.h"

#include <algorithm>
#include <cmath>

#include "messages/projects.h"
#include "messages/results.h"
#include "model/formats/documents/notations.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/files/input_file.h"
#include "model/results/beam_document.h"
#include "model/results/deciding_notes.h"
#include "model/results/vehicle_file.h"
#include "remount_version.h"

namespace remount::results {
namespace {

using formats::DocumentNode;

constexpr formats::MapOf kBeamFile{[](auto& beams, auto& fields) {
  fields.only_written("format", DocumentNode::string(kBeamsFormat));
  fields.only_written("version", DocumentNode::string(kVersion));
  fields("beams", beams, BeamNotation());
}};

// Beyond what the options for what is believed allow, something else is meant than was written.
bool is_absurd(const cloud::BeamNodes& nodes, const Eigen::VectorXd& of) {
  constexpr double kAngle_deg = 5.0, kRange_m = 1.0, kScale = 0.1;
  const auto largest = [&](Eigen::Index first) { return of.segment(first, nodes.count()).cwiseAbs().maxCoeff(); };
  const double most_rad = degrees_to_radians(kAngle_deg);
  return largest(nodes.elevation_at(0)) > most_rad || largest(nodes.range_at(0)) > kRange_m ||
         (nodes.by_azimuth() && largest(nodes.azimuth_at(0)) > most_rad) || std::abs(of[nodes.range_scale()]) > kScale;
}

/// Of the LiDAR of the sessions, by its name, where the file has several.
cloud::BeamEstimate load_beams_of(const std::filesystem::path& path,
                                  const std::vector<std::shared_ptr<const drive::Session>>& sessions) {
  if (!is_vehicle_file(path)) return load_beams(path);
  constexpr const char* kUnnamed = "lidar";  // as one without a name is called among several
  const std::string name =
      sessions.empty() || sessions.front()->lidar_name.empty() ? kUnnamed : sessions.front()->lidar_name;
  return told_beams(lidar_of(load_vehicle(path), name, path.string()).file, ErrorCode::Format, path.string());
}

}  // namespace

DocumentNode beams_document(const cloud::BeamEstimate& beams) { return kBeamFile.write(beams); }

cloud::BeamEstimate beams_from_document(const formats::DocumentView& root) {
  const std::string format = root.at("format").string();
  if (format == kVehicleFormat) root.at("format").fail(say::beams_of_several_lidars());
  if (format != kBeamsFormat)
    root.at("format").fail((format.starts_with("remount-beams/")
                                ? say::file_of_later_version
                                : say::file_of_other_format)(format.substr(0, 60), std::string(kBeamsFormat)));
  cloud::BeamEstimate beams;
  kBeamFile.read(root, beams);
  if (beams.sigmas.isZero(0.0)) root.at("beams").fail(say::beams_without_sigma());
  if (is_absurd(beams.nodes, beams.errors) || is_absurd(beams.nodes, beams.sigmas))
    root.at("beams").fail(say::beams_too_large(Angle{degrees_to_radians(5.0)}, Length{1.0}, Share{0.1}));
  return beams;
}

const cloud::BeamEstimate& told_beams(const ResultFile& file, ErrorCode code, const std::string& where) {
  if (file.result.beams.empty()) throw Error(code, where, say::beams_none_in_result());
  if (file.result.status != calibration::Status::Ok) throw Error(code, where, say::beams_not_told());
  return file.result.beams;
}

bool tells_scale(const cloud::BeamEstimate& beams) {
  constexpr double kScaleTold = 5e-4;
  return beams.range_scale_sigma() < kScaleTold;
}

cloud::BeamEstimate beams_of_scans(const ResultFile& file) {
  const auto tells_of_it = [](const drive::Finding& finding) { return finding.code == kMendedBeams; };
  return std::ranges::any_of(file.findings, tells_of_it) ? file.result.beams : cloud::BeamEstimate();
}

cloud::BeamEstimate load_beams(const std::filesystem::path& path) {
  if (!formats::is_file(path)) throw Error(ErrorCode::Io, path.string(), say::beams_file_missing());
  constexpr formats::DocumentLimits kLimits{64U << 20U, 2000000, 32};  // as of results
  const DocumentNode document = formats::read_document(path, kLimits);
  const formats::DocumentView root(document, path.string());
  if (root.is_map() && root.has("format") && root.at("format").string().starts_with("remount-result/"))
    return told_beams(result_from_document(root), ErrorCode::Format, path.string());
  return beams_from_document(root);
}

cloud::BeamEstimate known_beams(const cloud::BeamOptions& options,
                                const std::vector<std::shared_ptr<const drive::Session>>& sessions) {
  if (options.file.empty()) return {};
  cloud::BeamEstimate known = load_beams_of(options.file, sessions);
  if (std::ranges::none_of(sessions, [](const auto& session) { return session->scans != nullptr; }))
    throw Error(ErrorCode::Contract, options.file, say::beams_without_scans());
  return known;
}

}  // namespace remount::results
