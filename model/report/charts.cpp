#include "model/report/charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "algorithms/geometry/geodesy.h"

namespace remount {
namespace {

constexpr double kWidth = 680.0, kLeft = 46.0, kRight = 10.0, kTop = 22.0, kBottom = 24.0;
constexpr std::size_t kTrackPoints = 1500;
constexpr const char *kAccepted = "#2a6fbb", *kRejected = "#b9bcc2", *kUndecided = "#e0a030", *kAxis = "#8a8f98";
// Told apart by people who do not see colours alike (Okabe and Ito).
constexpr std::array<const char*, 5> kTrackColors{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9"};

std::string number(const char* pattern, double value) {
  char text[48];
  std::snprintf(text, sizeof(text), pattern, value);
  return text;
}

/// 1, 2 or 5 times a power of ten, not below `value`.
double round_number(double value) {
  if (!(value > 0.0)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= value * (1.0 - 1e-9)) return step * power;
  return 10.0 * power;
}

double shown(const PairRecord& pair, ResidualKind kind) {
  return kind == ResidualKind::Translation ? 100.0 * pair.residual_translation_m
                                           : radians_to_degrees(pair.residual_rotation_rad);
}

const char* color_of(PairState state) {
  return state == PairState::Accepted ? kAccepted : state == PairState::Rejected ? kRejected : kUndecided;
}

}  // namespace

ReportTrack track_of(const Session& session) {
  const std::vector<StampedPose> poses = session.ins.empty() ? session.world_from_ins : local_from_ins(session.ins);
  ReportTrack track;
  track.session = session.name;
  const std::size_t stride = poses.size() / kTrackPoints + 1;
  for (std::size_t i = 0; i < poses.size(); i += stride)
    track.east_north_m.push_back(poses[i].pose.translation().head<2>());
  return track;
}

Drawing residual_chart(const std::vector<PairRecord>& pairs, ResidualKind kind, const Phrases& phrase) {
  Drawing drawing;
  drawing.width = kWidth;
  drawing.height = 170.0;
  const std::string title = kind == ResidualKind::Translation
                                ? phrase("report", "Residual of translation per pair (cm)")
                                : phrase("report", "Residual of rotation per pair (degrees)");
  drawing.description = title;
  double most = 0.0;
  for (const PairRecord& pair : pairs)
    if (std::isfinite(shown(pair, kind))) most = std::max(most, shown(pair, kind));
  const double top = round_number(most), plot_height = drawing.height - kTop - kBottom;
  const double base = kTop + plot_height;
  const auto y_of = [&](double value) { return base - plot_height * std::min(1.0, value / top); };
  for (const double share : {0.0, 0.5, 1.0}) {
    const double y = y_of(share * top);
    drawing.shapes.push_back(DrawnLine{{{kLeft, y}, {kWidth - kRight, y}}, share > 0.0 ? "#e2e4e8" : kAxis, 1.0});
    drawing.shapes.push_back(DrawnText{{kLeft - 6.0, y + 4.0}, number("%g", share * top), TextAnchor::End, 10.0});
  }
  const double step = pairs.empty() ? 1.0 : (kWidth - kLeft - kRight) / static_cast<double>(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double value = shown(pairs[i], kind);
    if (!std::isfinite(value) || value <= 0.0) continue;
    const double y = y_of(value);
    drawing.shapes.push_back(DrawnBox{{kLeft + step * static_cast<double>(i), y},
                                      {std::max(0.5, step * (step > 3.0 ? 0.8 : 1.0)), base - y},
                                      color_of(pairs[i].state)});
  }
  drawing.shapes.push_back(DrawnText{{kLeft, 13.0}, title, TextAnchor::Start, 11.0});
  drawing.shapes.push_back(DrawnText{{kWidth - kRight, 13.0},
                                     phrase("report", "blue: accepted, grey: rejected, amber: undecided"),
                                     TextAnchor::End,
                                     10.0});
  drawing.shapes.push_back(DrawnText{{kLeft, base + 15.0}, "0", TextAnchor::Start, 10.0});
  if (!pairs.empty())
    drawing.shapes.push_back(
        DrawnText{{kWidth - kRight, base + 15.0}, std::to_string(pairs.size() - 1), TextAnchor::End, 10.0});
  return drawing;
}

Drawing track_chart(const std::vector<ReportTrack>& tracks, const Phrases& phrase) {
  Drawing drawing;
  drawing.width = kWidth;
  drawing.height = 340.0;
  drawing.description = phrase("report", "Where the INS drove, seen from above, north up");
  Eigen::Vector2d least = Eigen::Vector2d::Constant(1e300), most = -least;
  for (const ReportTrack& track : tracks)
    for (const Eigen::Vector2d& point : track.east_north_m)
      if (point.allFinite()) least = least.cwiseMin(point), most = most.cwiseMax(point);
  if (!(least.x() <= most.x())) return drawing;
  const Eigen::Vector2d span = (most - least).cwiseMax(1.0);
  constexpr double kMargin = 24.0;
  const double scale = std::min((kWidth - 2 * kMargin) / span.x(), (drawing.height - 2 * kMargin - kBottom) / span.y());
  const auto place = [&](const Eigen::Vector2d& point) {
    return Eigen::Vector2d(kMargin + scale * (point.x() - least.x()), kMargin + scale * (most.y() - point.y()));
  };
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const char* color = kTrackColors[i % kTrackColors.size()];
    DrawnLine line{{}, color, 1.5};
    for (const Eigen::Vector2d& point : tracks[i].east_north_m)
      if (point.allFinite()) line.points.push_back(place(point));
    if (line.points.empty()) continue;
    drawing.shapes.push_back(DrawnDot{line.points.front(), 3.5, color});
    drawing.shapes.push_back(line);
    drawing.shapes.push_back(
        DrawnText{{kMargin + 150.0 * static_cast<double>(i % 4), 12.0 + 12.0 * static_cast<double>(i / 4)},
                  tracks[i].session,
                  TextAnchor::Start,
                  10.0,
                  color});
  }
  const double bar_m = round_number(0.1 * kWidth / scale), bar = bar_m * scale, y = drawing.height - 12.0;
  drawing.shapes.push_back(DrawnLine{{{kMargin, y}, {kMargin + bar, y}}, "#333333", 2.0});
  drawing.shapes.push_back(DrawnText{{kMargin + bar + 6.0, y + 4.0}, number("%g m", bar_m), TextAnchor::Start, 10.0});
  return drawing;
}

}  // namespace remount
