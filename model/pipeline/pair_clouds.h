// The scans of pairs as they were registered, for whoever looks at them.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "algorithms/cloud/objects.h"
#include "algorithms/core/progress.h"
#include "model/pipeline/pipeline.h"

namespace remount::pipeline {

/// The scan of a keyframe in its lidar frame, mended and compensated, and what stands in it.
struct KeyframeScan {
  cloud::PointCloud cloud;
  std::vector<cloud::SceneObject> objects;                 ///< their points are places in `cloud`
  Eigen::Vector3f up_in_lidar = Eigen::Vector3f::UnitZ();  ///< away from the ground, unit length
};
using KeyframeScanPtr = std::shared_ptr<const KeyframeScan>;

/// The scans of a pair, never null, and which of their objects are the same. Pairs of one keyframe share its scan.
struct PairClouds {
  KeyframeScanPtr scan_a = std::make_shared<const KeyframeScan>(), scan_b = std::make_shared<const KeyframeScan>();
  std::vector<cloud::ObjectMatch> matches;

  const cloud::PointCloud& cloud_a() const { return scan_a->cloud; }
  const cloud::PointCloud& cloud_b() const { return scan_b->cloud; }
  /// False for pairs of poses.
  bool has_points() const { return cloud_a().size() > 0 || cloud_b().size() > 0; }
};

/// Where the scans of the pairs of one output come from. Thread-safe.
class PairSource {
 public:
  virtual ~PairSource() = default;
  /// Empty where the session has poses and no scans, or where cancelled. Throws Error where a scan cannot be read.
  virtual PairClouds load(motion::PairIndex pair, const Progress& progress) const = 0;
  /// Whether it would give the same scans for the same pairs of this output: decisions change none.
  virtual bool serves(const PipelineInput& input, const PipelineOutput& output) const = 0;
};

/// As the calibration registered them. What it keeps is found once for all pairs; a scan is read again only when nobody
/// holds it any more.
class SolvedPairs : public PairSource {
 public:
  SolvedPairs(PipelineInput input, std::shared_ptr<const PipelineOutput> output);
  ~SolvedPairs() override;
  PairClouds load(motion::PairIndex pair, const Progress& progress) const override;
  bool serves(const PipelineInput& input, const PipelineOutput& output) const override;

 private:
  struct Reading;  // what all scans have in common; made when the first is read
  const Reading& reading() const;
  KeyframeScanPtr scan_of(motion::KeyframeIndex keyframe, const Progress& progress) const;

  PipelineInput input_;
  std::shared_ptr<const PipelineOutput> output_;
  mutable std::mutex mutex_;
  mutable std::unique_ptr<const Reading> reading_;
  mutable std::map<motion::KeyframeIndex, std::weak_ptr<const KeyframeScan>> read_;
};

}  // namespace remount::pipeline
