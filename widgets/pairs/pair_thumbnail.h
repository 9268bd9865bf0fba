// A small picture of a pair: what an eye needs to tell a bad alignment from a good one.
#pragma once

#include <QImage>
#include <QSize>

#include "algorithms/quality/section.h"
#include "widgets/scene/pair_scene_data.h"

namespace remount::widgets {

/// How thumbnails are drawn, the same for all.
struct ThumbnailStyle {
  QSize size{220, 168};
  double reach_m = 30.0;  ///< of the view from above, to each side of the LiDAR
  double limit_m = 0.1;   ///< where the scale of distances ends
  bool dark = false;
};

struct PairThumbnail {
  QImage picture;
  double median_m = 0.0;     ///< of the distances of scan a to the surfaces of scan b; NaN: nothing near
  double thickness_m = 0.0;  ///< of the wall that is cut, both scans together; NaN: no wall was found
};

/// Scan b grey and scan a coloured by its distance to the surfaces of scan b, blue before and red behind them: above
/// seen from above, forward to the right, below cut through the wall that both see best. Safe on any thread. Null
/// picture where cancelled.
/// @param vehicle_from_ins forward, left, up
PairThumbnail paint_thumbnail(const scene::PairSceneData& data, const scene::PairTransforms& transforms,
                              scene::PairAlignment alignment, const RigidTransform& vehicle_from_ins,
                              const ThumbnailStyle& style, const Progress& progress);

/// Where distances of these pairs end well within: the scale of all their thumbnails.
double thumbnail_limit_m(const std::vector<motion::Pair>& pairs);

}  // namespace remount::widgets
