#include "model/pipeline/beam_report.h"

#include <algorithm>
#include <utility>

#include "messages/pipeline.h"
#include "messages/places.h"
#include "messages/plots.h"
#include "messages/quantities.h"
#include "model/pipeline/as_solved_scans.h"
#include "model/pipeline/sharpness_stage.h"
#include "model/results/beam_file.h"
#include "model/results/deciding_notes.h"

namespace remount::pipeline {
namespace {

using calibration::Curve;

// Of those beams that the drive tells: over the elevation, or, of a field with azimuths, a curve over these for each
// elevation.
std::vector<Curve> curves_of(const cloud::BeamEstimate& beams, Eigen::Index first, double unit, double told_below) {
  const cloud::BeamNodes& nodes = beams.nodes;
  std::vector<Curve> curves(nodes.by_azimuth() ? nodes.elevations_rad().size() : 1);
  for (Eigen::Index node = 0; node < nodes.count(); ++node) {
    if (beams.sigmas[first + node] > told_below) continue;
    Curve& curve = curves[static_cast<std::size_t>(node) % curves.size()];
    if (nodes.by_azimuth()) curve.name = say::plot_at_elevation(Angle{nodes.elevation_rad(node)});
    curve.x.push_back(radians_to_degrees(nodes.by_azimuth() ? nodes.azimuth_rad(node) : nodes.elevation_rad(node)));
    curve.y.push_back(unit * beams.errors[first + node]);
    curve.sigma.push_back(unit * beams.sigmas[first + node]);
  }
  std::erase_if(curves, [](const Curve& curve) { return curve.x.empty(); });
  return curves;
}

// Empty where the drive, as its pairs are decided now, tells none of them.
Message words_of(const cloud::BeamEstimate& beams) {
  std::vector<Message> parts;
  if (beams.empty()) return {};
  if (beams.elevation.told)
    parts.push_back(say::pipeline_beams_elevation(Angle{beams.elevation.error}, Angle{beams.elevation.sigma}));
  if (beams.range.told)
    parts.push_back(say::pipeline_beams_range(Length{beams.range.error}, Length{beams.range.sigma}));
  if (results::tells_scale(beams))
    parts.push_back(say::pipeline_beams_scale(Share{beams.range_scale()}, Share{beams.range_scale_sigma()}));
  if (parts.empty()) return {};
  return say::pipeline_beams_found(std::move(parts));
}

// Of the solution before; what a method tells beside them stays.
void forget_beams(PipelineOutput& output) {
  std::erase_if(output.quantities, [](const calibration::NamedQuantity& quantity) {
    return quantity.id == "beam elevation" || quantity.id == "beam range" || quantity.id == "range scale";
  });
  std::erase_if(output.plots, [](const calibration::Plot& plot) {
    return plot.title == say::plot_beam_elevations() || plot.title == say::plot_beam_ranges() ||
           plot.title == say::plot_beam_azimuths();
  });
}

void add_plots(const cloud::BeamEstimate& beams, std::vector<calibration::Plot>& plots) {
  constexpr double kAngleTold_rad = 9e-4, kRangeTold_m = 0.015;
  const cloud::BeamNodes& nodes = beams.nodes;
  const auto add = [&](const Message& title, const Message& unit, std::vector<Curve> curves) {
    if (curves.empty()) return;
    const Message over = nodes.by_azimuth() ? say::plot_azimuth_deg() : say::plot_elevation_deg();
    plots.push_back({title, over, unit, false, std::move(curves)});
  };
  const double to_deg = radians_to_degrees(1.0);
  add(say::plot_beam_elevations(), say::plot_beam_elevation_deg(),
      curves_of(beams, nodes.elevation_at(0), to_deg, kAngleTold_rad));
  add(say::plot_beam_ranges(), say::plot_beam_range_mm(), curves_of(beams, nodes.range_at(0), 1e3, kRangeTold_m));
  if (!nodes.by_azimuth()) return;
  add(say::plot_beam_azimuths(), say::plot_beam_elevation_deg(),
      curves_of(beams, nodes.azimuth_at(0), to_deg, kAngleTold_rad));
}

}  // namespace

void tell_beams(PipelineOutput& output) {
  cloud::BeamEstimate& beams = output.result.beams;
  forget_beams(output);
  if (!calibration::is_solved(output.result.status)) return;
  if (beams.empty()) {
    beams = output.known_beams;  // what was taken out of the scans is a part of the result, whoever found it
    return;
  }
  const double scale = beams.range_scale(), scale_sigma = beams.range_scale_sigma();
  const bool known = output.result.status == calibration::Status::Ok;  // else errors of the INS pass for theirs
  output.quantities.push_back({"beam elevation", say::quantity_beam_elevation(), beams.elevation.error,
                               beams.elevation.sigma, "rad", known && beams.elevation.told});
  output.quantities.push_back(
      {"beam range", say::quantity_beam_range(), beams.range.error, beams.range.sigma, "m", known && beams.range.told});
  output.quantities.push_back(
      {"range scale", say::quantity_range_scale(), scale, scale_sigma, "", known && results::tells_scale(beams)});
  if (!known) return;
  add_plots(beams, output.plots);
}

std::optional<BeamThickness> thickness_of_beams(const StageContext& context, const PipelineInput& input,
                                                const PipelineOutput& output, Progress& progress) {
  if (output.mended_beams.none() || output.sharpness.empty() || progress.cancelled()) return std::nullopt;
  ScanStore as_recorded(context.motion, input.settings.registration, 0);
  compensate_as_solved(input, output, as_recorded);
  as_recorded.mend_beams(cloud::BeamErrors());
  const std::vector<quality::NamedSharpness> before =
      check_sharpness(context, as_recorded, output.result, input.nominal_ins_from_lidar, progress);
  if (before.empty()) return std::nullopt;
  return BeamThickness{before.front().sharpness.plane_thickness_m,
                       output.sharpness.front().sharpness.plane_thickness_m};
}

void report_mended_beams(const std::optional<BeamThickness>& thickness, PipelineOutput& output) {
  std::erase_if(output.findings, [](const drive::Finding& finding) { return finding.code == results::kMendedBeams; });
  if (output.mended_beams.none()) return;
  const Message mended =
      thickness ? say::pipeline_beams_mended_thickness(Length{thickness->mended_m}, Length{thickness->as_recorded_m})
                : say::pipeline_beams_mended();
  std::vector<Message> sentences;
  if (Message found = words_of(output.result.beams); !found.empty()) sentences.push_back(std::move(found));
  if (!output.known_beams.empty()) sentences.push_back(say::pipeline_beams_known());
  sentences.push_back(mended);
  output.findings.push_back(
      {drive::Severity::Note, results::kMendedBeams, say::place_lidar(), Message::sequence(std::move(sentences))});
}

void add_known_beams(const cloud::BeamEstimate& known, PipelineOutput& output) {
  if (known.empty() || !calibration::is_solved(output.result.status)) return;
  output.known_beams = known;
  output.beam_nodes = known.nodes;
  if (output.mended_beams.none()) output.mended_beams = known.beam_errors();
  if (output.result.beams.empty()) output.result.beams = known;
  const auto is_told = [](const drive::Finding& finding) { return finding.code == results::kMendedBeams; };
  if (std::ranges::none_of(output.findings, is_told)) report_mended_beams(std::nullopt, output);
}

}  // namespace remount::pipeline
