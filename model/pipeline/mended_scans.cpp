#include "model/pipeline/mended_scans.h"

#include <utility>

namespace remount::pipeline {
namespace {

class MendedSource : public drive::ScanSource {
 public:
  MendedSource(std::shared_ptr<const ScanSource> recorded, const cloud::BeamErrors& errors)
      : recorded_(std::move(recorded)), errors_(errors) {}

  std::size_t size() const override { return recorded_->size(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return recorded_->stamp_ns(scan); }
  std::string name(std::size_t scan) const override { return recorded_->name(scan); }
  cloud::PointCloud load(std::size_t scan) const override {
    cloud::PointCloud cloud = recorded_->load(scan);
    cloud::mend_beams(errors_, cloud);
    return cloud;
  }

 private:
  std::shared_ptr<const ScanSource> recorded_;
  cloud::BeamErrors errors_;
};

}  // namespace

std::shared_ptr<const drive::Session> mended_session(const std::shared_ptr<const drive::Session>& session,
                                                     const cloud::BeamEstimate& known) {
  if (known.empty() || !session->scans) return session;
  auto mended = std::make_shared<drive::Session>(*session);
  mended->scans_as_recorded = session->scans;
  mended->scans = std::make_shared<const MendedSource>(session->scans, known.beam_errors());
  return mended;
}

}  // namespace remount::pipeline
