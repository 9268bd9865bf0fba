// Scans that have stamps and no points: for stages that must not read any.
#pragma once

#include <gtest/gtest.h>

#include "model/drive/session.h"

namespace remount::testing {

/// Stamped every `step_s` from one second on. Reading one fails the test.
class NoScans : public drive::ScanSource {
 public:
  NoScans(std::size_t count, double step_s) : count_(count), step_s_(step_s) {}
  std::size_t size() const override { return count_; }
  std::int64_t stamp_ns(std::size_t scan) const override {
    return 1'000'000'000 + static_cast<std::int64_t>(1e9 * step_s_ * static_cast<double>(scan));
  }
  std::string name(std::size_t scan) const override { return std::to_string(scan); }
  cloud::PointCloud load(std::size_t) const override {
    ADD_FAILURE() << "no scan is read";
    return {};
  }

 private:
  std::size_t count_;
  double step_s_;
};

}  // namespace remount::testing
