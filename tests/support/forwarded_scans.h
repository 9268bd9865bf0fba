// Scans of another source, for tests that change some of it.
#pragma once

#include <memory>
#include <utility>

#include "model/drive/session.h"

namespace remount::testing {

/// All as the other source has it.
class ForwardedScans : public drive::ScanSource {
 public:
  explicit ForwardedScans(std::shared_ptr<const ScanSource> scans) : scans_(std::move(scans)) {}
  std::size_t size() const override { return scans_->size(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return scans_->stamp_ns(scan); }
  std::string name(std::size_t scan) const override { return scans_->name(scan); }
  cloud::PointCloud load(std::size_t scan) const override { return scans_->load(scan); }

 private:
  std::shared_ptr<const ScanSource> scans_;
};

}  // namespace remount::testing
