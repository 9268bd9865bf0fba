// Charts of a report.
#pragma once

#include "algorithms/messages/catalogue.h"
#include "model/report/drawing.h"
#include "model/results/result_file.h"

namespace remount::report {

/// Where a session's INS drove, in the session's own local frame, thinned to what a page can show.
struct ReportTrack {
  std::string session;
  bool geographic = false;  ///< x is east and y north of the UTM grid; otherwise the axes of the pose file
  std::vector<Eigen::Vector2d> points_m;
};
/// The INS of an opened session; empty where it has none.
ReportTrack track_of(const drive::Session& session);

enum class ChartedResidual { Translation, Rotation };
/// One bar a pair, in the order of the list; rejected ones grey.
Drawing residual_chart(const std::vector<results::PairRecord>& pairs, ChartedResidual kind, Language language);

/// One session, with a scale bar: where sessions lie to each other is not known, so each has a chart of its own.
Drawing track_chart(const ReportTrack& track, Language language);

}  // namespace remount::report
