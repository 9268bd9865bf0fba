// Charts of a report.
#pragma once

#include <functional>

#include "model/report/drawing.h"
#include "model/result_file.h"

namespace remount {

/// phrase(context, English): the words of a report in the reader's language.
using Phrases = std::function<std::string(const char* context, const char* english)>;

/// Where a session's INS drove, in the session's own local frame, thinned to what a page can show.
struct ReportTrack {
  std::string session;
  bool geographic = false;  ///< x is east and y north of the UTM grid; otherwise the axes of the pose file
  std::vector<Eigen::Vector2d> points_m;
};
/// The INS of an opened session; empty where it has none.
ReportTrack track_of(const Session& session);

enum class ChartedResidual { Translation, Rotation };
/// One bar a pair, in the order of the list; rejected ones grey.
Drawing residual_chart(const std::vector<PairRecord>& pairs, ChartedResidual kind, const Phrases& phrase);

/// One session, with a scale bar: where sessions lie to each other is not known, so each has a chart of its own.
Drawing track_chart(const ReportTrack& track, const Phrases& phrase);

}  // namespace remount
