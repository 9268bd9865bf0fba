// Poses of an INS in a metric frame, in less than half of the memory of StampedPose.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "model/drive/session.h"

namespace remount::conventions {

/// What metric_poses gives, one at a time: for looking at a whole session while it is in memory. Of poses from a file
/// nothing is copied. The session must outlive this.
class MetricPoses {
 public:
  explicit MetricPoses(const drive::Session& session);

  std::size_t size() const { return poses_.empty() ? from_file_->size() : poses_.size(); }
  bool empty() const { return size() == 0; }
  motion::StampedPose operator[](std::size_t i) const {
    return poses_.empty() ? (*from_file_)[i]
                          : motion::StampedPose{(*ins_)[i].stamp_ns, make_rigid(poses_[i].rotation.toRotationMatrix(),
                                                                                poses_[i].position_m)};
  }
  motion::StampedPose front() const { return (*this)[0]; }
  motion::StampedPose back() const { return (*this)[size() - 1]; }

  struct Iterator {
    const MetricPoses* poses;
    std::size_t at;
    motion::StampedPose operator*() const { return (*poses)[at]; }
    Iterator& operator++() { return ++at, *this; }
    bool operator!=(const Iterator& other) const { return at != other.at; }
  };
  Iterator begin() const { return {this, 0}; }
  Iterator end() const { return {this, size()}; }

 private:
  // Without padding, for they are millions beside samples that are larger than their lines in a log.
  struct Compact {
    Eigen::Vector3d position_m;
    Eigen::Quaternion<double, Eigen::DontAlign> rotation;
  };
  std::vector<Compact> poses_;  // of ins_
  const std::vector<motion::InsSample>* ins_;
  const std::vector<motion::StampedPose>* from_file_;
};

}  // namespace remount::conventions
