#include "model/formats/growing_session.h"

#include "algorithms/core/error.h"
#include "model/drive/bad_items.h"
#include "model/formats/session_readers.h"
#include "model/formats/sessions/native_session_reader.h"

namespace remount::formats {
namespace {

template <class Item>
void append_later(std::vector<Item>& items, std::vector<Item>&& more) {
  for (Item& item : more)
    if (items.empty() || item.stamp_ns > items.back().stamp_ns) items.push_back(std::move(item));
}

}  // namespace

/// Scans of several sources, one after the other.
class AppendedScans final : public drive::ScanSource {
 public:
  void append(const std::shared_ptr<const ScanSource>& later) {
    for (std::size_t i = 0; i < later->size(); ++i)
      if (scans_.empty() || later->stamp_ns(i) > stamp_ns(scans_.size() - 1)) scans_.emplace_back(later, i);
  }
  std::size_t size() const override { return scans_.size(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return at(scan).first->stamp_ns(at(scan).second); }
  std::string name(std::size_t scan) const override { return at(scan).first->name(at(scan).second); }
  cloud::PointCloud load(std::size_t scan) const override { return at(scan).first->load(at(scan).second); }

 private:
  using Part = std::pair<std::shared_ptr<const ScanSource>, std::size_t>;
  const Part& at(std::size_t scan) const { return scans_.at(scan); }
  std::vector<Part> scans_;
};

const drive::Session* GrowingSession::look() {
  const NativeSessionReader native;
  try {
    if (!opened_) as_whole_ = !topics_.empty() || native.probe(path_) == 0;
    if (!as_whole_) look_at_parts();
    if (as_whole_) look_at_whole();
    opened_ = true;
    problem_ = {};
    return &session_;
  } catch (const Error& error) {
    problem_ = drive::message_of(error);
    source_.give_back();
    if (source_.shrunk()) begin_anew();
    return nullptr;
  }
}

void GrowingSession::begin_anew() {
  bytes_before_ += source_.bytes_read();
  source_ = GrowingSource();
  session_ = drive::Session();
  scans_.reset();
  opened_ = false;
}

void GrowingSession::look_at_parts() {
  const NativeSessionReader native;
  std::string manifest = read_regular_file(NativeSessionReader::manifest_of(path_), kMaxManifestBytes);
  bytes_before_ += manifest.size();
  if (manifest != manifest_) begin_anew();
  Progress quiet;
  std::optional<drive::Session> part = native.open_part(path_, source_, quiet);
  as_whole_ = !part.has_value();
  if (as_whole_) return;
  const std::shared_ptr<const drive::ScanSource> scans = part->scans;
  if (!opened_) {
    session_ = std::move(*part);
  } else {
    append_later(session_.ins, std::move(part->ins));
    append_later(session_.world_from_ins, std::move(part->world_from_ins));
    append_later(session_.odometry_from_lidar, std::move(part->odometry_from_lidar));
    append_later(session_.gnss, std::move(part->gnss));
    if (!session_.scans && scans) {
      session_.scan_timing = part->scan_timing, session_.sweep = part->sweep;
      session_.times_count = part->times_count;
    }
  }
  if (scans && !scans_) scans_ = std::make_shared<AppendedScans>();
  if (scans) scans_->append(scans);
  session_.scans = scans_;
  manifest_ = std::move(manifest);
  source_.keep();
}

void GrowingSession::look_at_whole() {
  constexpr int kShare = 4;  // rests so many times as long as the last look took
  const Clock::time_point start = Clock::now();
  if (opened_ && start < next_whole_) return;
  Progress quiet;
  session_ = open_session(path_, topics_, quiet, checks::LookAt::Streams);
  const Clock::time_point end = Clock::now();
  next_whole_ = end + kShare * (end - start);
}

}  // namespace remount::formats
