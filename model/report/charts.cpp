#include "model/report/charts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "algorithms/geodesy/geodesy.h"
#include "algorithms/messages/render.h"
#include "messages/report.h"
#include "model/formats/files/number_text.h"

namespace remount::report {
namespace {

constexpr double kBarWidth = 680.0, kBarLeft = 46.0, kBarRight = 10.0, kBarTop = 22.0, kBarBottom = 24.0;
constexpr std::size_t kTrackPoints = 1500;
constexpr const char *kAccepted = "#1b7f45", *kRejected = "#80858d", *kUndecided = "#e0a030", *kAxis = "#8a8f98";

/// 1, 2 or 5 times a power of ten, not below `value`.
double round_number(double value) {
  if (!(value > 0.0)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= value * (1.0 - 1e-9)) return step * power;
  return 10.0 * power;
}

double shown(const results::PairRecord& pair, ChartedResidual kind) {
  return kind == ChartedResidual::Translation ? 100.0 * pair.residual_translation_m
                                              : radians_to_degrees(pair.residual_rotation_rad);
}

double highest(const std::vector<results::PairRecord>& pairs, ChartedResidual kind, bool accepted_only) {
  double most = 0.0;
  for (const results::PairRecord& pair : pairs)
    if (std::isfinite(shown(pair, kind)) && (!accepted_only || pair.state == motion::PairState::Accepted))
      most = std::max(most, shown(pair, kind));
  return most;
}

const char* color_of(motion::PairState state) {
  return state == motion::PairState::Accepted   ? kAccepted
         : state == motion::PairState::Rejected ? kRejected
                                                : kUndecided;
}

}  // namespace

ReportTrack track_of(const drive::Session& session) {
  ReportTrack track{session.name, !session.ins.empty(), {}};
  const std::vector<motion::StampedPose> poses =
      track.geographic ? geodesy::local_from_ins(session.ins) : session.world_from_ins;
  const std::size_t stride = poses.size() / kTrackPoints + 1;
  for (std::size_t i = 0; i < poses.size(); i += stride)
    track.points_m.push_back(poses[i].pose.translation().head<2>());
  return track;
}

Drawing residual_chart(const std::vector<results::PairRecord>& pairs, ChartedResidual kind, Language language) {
  Drawing drawing;
  drawing.width = kBarWidth;
  drawing.height = 170.0;
  const Message title =
      kind == ChartedResidual::Translation ? say::chart_residual_translation() : say::chart_residual_rotation();
  drawing.description = render(title, language);
  const double most = highest(pairs, kind, false), kept = highest(pairs, kind, true);
  // A few wild ones would make all that are used flat; what is higher is cut.
  const double top = round_number(kept > 0.0 ? std::min(most, 2.0 * kept) : most),
               plot_height = drawing.height - kBarTop - kBarBottom;
  const double base = kBarTop + plot_height;
  const auto y_of = [&](double value) { return base - plot_height * std::min(1.0, value / top); };
  for (const double share : {0.0, 0.5, 1.0}) {
    const double y = y_of(share * top);
    drawing.shapes.push_back(
        DrawnLine{{{kBarLeft, y}, {kBarWidth - kBarRight, y}}, share > 0.0 ? "#e2e4e8" : kAxis, 1.0});
    drawing.shapes.push_back(
        DrawnText{{kBarLeft - 6.0, y + 4.0}, formats::format_numbers("%g", share * top), TextAnchor::End, 10.0});
  }
  const double step = pairs.empty() ? 1.0 : (kBarWidth - kBarLeft - kBarRight) / static_cast<double>(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double value = shown(pairs[i], kind);
    if (!std::isfinite(value) || value <= 0.0) continue;
    const double y = y_of(value);
    drawing.shapes.push_back(DrawnBox{{kBarLeft + step * static_cast<double>(i), y},
                                      {std::max(0.5, step * (step > 3.0 ? 0.8 : 1.0)), base - y},
                                      color_of(pairs[i].state)});
  }
  const Message head = most > top ? say::chart_bars_are_cut(title) : title;
  drawing.shapes.push_back(DrawnText{{kBarLeft, 13.0}, render(head, language), TextAnchor::Start, 11.0});
  drawing.shapes.push_back(
      DrawnText{{kBarWidth - kBarRight, 13.0}, render(say::chart_colours(), language), TextAnchor::End, 10.0});
  drawing.shapes.push_back(DrawnText{{kBarLeft, base + 15.0}, "0", TextAnchor::Start, 10.0});
  if (!pairs.empty())
    drawing.shapes.push_back(
        DrawnText{{kBarWidth - kBarRight, base + 15.0}, std::to_string(pairs.size() - 1), TextAnchor::End, 10.0});
  return drawing;
}

Drawing track_chart(const ReportTrack& track, Language language) {
  constexpr double kMargin = 24.0, kHead = 44.0, kTallest = 270.0;
  const std::string axes =
      render(track.geographic ? say::chart_track_geographic() : say::chart_track_posed(), language);
  Drawing drawing;
  drawing.width = kBarWidth;
  drawing.height = kHead;
  drawing.description = track.session + ": " + axes;
  drawing.shapes.push_back(DrawnText{{kMargin, 13.0}, track.session, TextAnchor::Start, 11.0});
  drawing.shapes.push_back(DrawnText{{kMargin, 27.0}, axes, TextAnchor::Start, 10.0});
  Eigen::AlignedBox2d bounds;
  for (const Eigen::Vector2d& point : track.points_m)
    if (point.allFinite()) bounds.extend(point);
  if (bounds.isEmpty()) {
    drawing.shapes.push_back(
        DrawnText{{kMargin, 41.0}, render(say::chart_no_positions(), language), TextAnchor::Start, 10.0});
    return drawing;
  }
  const Eigen::Vector2d span = bounds.sizes().cwiseMax(1.0);
  const double scale = std::min((kBarWidth - 2 * kMargin) / span.x(), kTallest / span.y());
  DrawnLine line{{}, kAccepted, 1.5};
  for (const Eigen::Vector2d& point : track.points_m)
    if (point.allFinite())
      line.points.emplace_back(kMargin + scale * (point.x() - bounds.min().x()),
                               kHead + scale * (bounds.max().y() - point.y()));
  drawing.shapes.push_back(DrawnDot{line.points.front(), 3.5, kAccepted});
  drawing.shapes.push_back(line);
  const double bar_m = round_number(0.1 * kBarWidth / scale), bar = bar_m * scale,
               y = kHead + scale * span.y() + kBarBottom;
  drawing.height = y + 12.0;
  drawing.shapes.push_back(DrawnLine{{{kMargin, y}, {kMargin + bar, y}}, "#333333", 2.0});
  drawing.shapes.push_back(DrawnText{
      {kMargin + bar + 6.0, y + 4.0}, render(say::chart_scale_bar(Length{bar_m}), language), TextAnchor::Start, 10.0});
  return drawing;
}

}  // namespace remount::report
