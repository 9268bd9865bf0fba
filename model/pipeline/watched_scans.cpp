#include "model/pipeline/watched_scans.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/pipeline.h"

namespace remount::pipeline {

class WatchedSource : public drive::ScanSource {
 public:
  explicit WatchedSource(std::shared_ptr<const ScanSource> scans) : scans_(std::move(scans)) {}

  std::size_t size() const override { return scans_->size(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return scans_->stamp_ns(scan); }
  std::string name(std::size_t scan) const override { return scans_->name(scan); }
  cloud::PointCloud load(std::size_t scan) const override {
    try {
      return scans_->load(scan);
    } catch (const Error& error) {
      const std::scoped_lock lock(mutex_);
      failures_.try_emplace(scan, error.message());
      throw;
    }
  }

  /// By the number of the scan, so that they come in the same order for any number of threads.
  std::map<std::size_t, Message> failures() const {
    const std::scoped_lock lock(mutex_);
    return failures_;
  }

 private:
  std::shared_ptr<const ScanSource> scans_;
  mutable std::mutex mutex_;
  mutable std::map<std::size_t, Message> failures_;
};

drive::Finding skipped_scan(const drive::Session& session, const Message& failure) {
  return {drive::Severity::Warning, "scan-unreadable", session.name, say::pipeline_scan_skipped(failure)};
}

bool is_named(const drive::Finding& skipped, const std::vector<drive::Finding>& findings) {
  return std::ranges::any_of(findings, [&](const drive::Finding& finding) {
    return finding.where == skipped.where && finding.explanation == skipped.explanation;
  });
}

WatchedScans::WatchedScans(const std::vector<std::shared_ptr<const drive::Session>>& sessions) : sessions_(sessions) {
  for (auto& session : sessions_) {
    sources_.push_back(session->scans ? std::make_shared<const WatchedSource>(session->scans) : nullptr);
    if (!session->scans) continue;
    auto watched = std::make_shared<drive::Session>(*session);
    watched->scans = sources_.back();
    session = std::move(watched);
  }
}

void WatchedScans::report(std::vector<drive::Finding>& findings) const {
  for (std::size_t s = 0; s < sessions_.size(); ++s) {
    if (!sources_[s]) continue;
    for (const auto& [scan, failure] : sources_[s]->failures()) {
      drive::Finding skipped = skipped_scan(*sessions_[s], failure);
      if (!is_named(skipped, findings)) findings.push_back(std::move(skipped));
    }
  }
}

}  // namespace remount::pipeline
