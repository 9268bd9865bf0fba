// Charts of a report.
#pragma once

#include <functional>

#include "model/report/drawing.h"
#include "model/result_file.h"

namespace remount {

/// phrase(context, English): the words of a report in the reader's language.
using Phrases = std::function<std::string(const char* context, const char* english)>;

/// Where a session's INS drove, in local axes (east, north), thinned to what a page can show.
struct ReportTrack {
  std::string session;
  std::vector<Eigen::Vector2d> east_north_m;
};
/// The INS of an opened session; empty where it has none.
ReportTrack track_of(const Session& session);

enum class ResidualKind { Translation, Rotation };
/// One bar a pair, in the order of the list; rejected ones grey.
Drawing residual_chart(const std::vector<PairRecord>& pairs, ResidualKind kind, const Phrases& phrase);

/// All tracks in one map of equal scales, each in its own axes, with a scale bar.
Drawing track_chart(const std::vector<ReportTrack>& tracks, const Phrases& phrase);

}  // namespace remount
