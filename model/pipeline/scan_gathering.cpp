#include "model/pipeline/scan_gathering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "algorithms/cloud/directions.h"
#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "algorithms/core/stamps.h"
#include "messages/pipeline.h"
#include "model/pipeline/scan_times.h"
#include "model/results/deciding_notes.h"

namespace remount::pipeline {
namespace {

constexpr std::size_t kFirstLook = 3, kLongLook = 10;  // successive scans
constexpr std::array kPlaces{0.3, 0.7};                // of the drive, where they are looked at
constexpr double kRepeated = 0.75;                     // of the directions of the scan before: such scans repeat
constexpr double kNearlyAll = 0.9;                     // of the field: gathering ends here
constexpr double kLongest_s = 0.3;                     // longer, and scans bear out too much of the X they rest on

// Of successive scans, without those that cannot be read: they are named where they are used.
std::vector<cloud::Directions> look_at(const drive::ScanSource& scans, std::size_t first, std::size_t count,
                                       const Progress& progress) {
  std::vector<cloud::Directions> seen;
  for (std::size_t i = first; i < std::min(first + count, scans.size()) && !progress.cancelled(); ++i) {
    try {
      cloud::Directions directions;
      directions.add(scans.load(i).points);
      if (!directions.empty()) seen.push_back(std::move(directions));
    } catch (const Error&) {
      continue;
    }
  }
  return seen;
}

std::size_t first_at(const drive::ScanSource& scans, double place, std::size_t count) {
  return static_cast<std::size_t>(place * static_cast<double>(scans.size() - std::min(count, scans.size())));
}

// How much of its directions a scan has in common with the one before; nothing where too few can be read.
std::optional<double> repeated_share(const drive::ScanSource& scans, const Progress& progress) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const double place : kPlaces) {
    const std::vector<cloud::Directions> seen =
        look_at(scans, first_at(scans, place, kFirstLook), kFirstLook, progress);
    for (std::size_t i = 1; i < seen.size(); ++i, ++count) sum += seen[i - 1].share_of(seen[i]);
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

// What the first of successive scans show of what all of them show: entry n - 1 is that of n scans, the mean over the
// places. Empty where too few can be read.
std::vector<double> shares_shown(const drive::ScanSource& scans, const Progress& progress) {
  std::vector<double> mean(kLongLook, 0.0);
  for (const double place : kPlaces) {
    const std::vector<cloud::Directions> seen = look_at(scans, first_at(scans, place, kLongLook), kLongLook, progress);
    if (seen.size() < kLongLook) return {};
    cloud::Directions whole, first;
    for (const cloud::Directions& scan : seen) whole.add(scan);
    for (std::size_t n = 0; n < kLongLook; ++n) {
      first.add(seen[n]);
      mean[n] += first.share_of(whole) / static_cast<double>(kPlaces.size());
    }
  }
  return mean;
}

// For how long the INS places scans well against each other: until it drifts by a centimetre at twenty metres.
double trusted_s(const drive::Session& session) {
  constexpr double kFar_m = 20.0, kApart_m = 0.01;
  const auto declared = [](double drift) { return std::isfinite(drift) ? drift : 0.0; };
  const double drift = declared(session.ins_position_drift) + kFar_m * declared(session.ins_attitude_drift);
  return drift > 0.0 ? std::min(std::pow(kApart_m / drift, 2), kLongest_s) : kLongest_s;
}

int frames_by_scans(const drive::Session& session, std::vector<drive::Finding>& findings, const Progress& progress) {
  const drive::ScanSource& scans = *session.scans;
  const double step_s = scan_period_s(scans);
  if (!(step_s > 0.0)) return 1;
  const std::optional<double> repeated = repeated_share(scans, progress);
  if (!repeated || *repeated >= kRepeated) return 1;
  const std::vector<double> shares = shares_shown(scans, progress);
  if (shares.empty() || progress.cancelled()) return 1;
  const int most = std::max(1, static_cast<int>(std::floor(trusted_s(session) / step_s + 0.01)));
  int frames = 1;
  while (frames < std::min(most, static_cast<int>(kLongLook)) && shares[index_at(frames - 1)] < kNearlyAll) ++frames;
  if (frames > 1)
    findings.push_back({drive::Severity::Note, results::kScansGathered, session.name,
                        say::pipeline_scans_gathered(Share{shares.front()}, frames, Duration{frames * step_s},
                                                     Share{shares[index_at(frames - 1)]})});
  return frames;
}

}  // namespace

std::vector<int> choose_gathering(const DriveMotion& motion, const motion::KeyframeOptions& options,
                                  std::vector<drive::Finding>& findings, const Progress& progress) {
  std::vector<int> frames(motion.session_count(), 1);
  for (motion::SessionIndex s; s < motion.session_count(); ++s) {
    const drive::Session& session = motion.session(s);
    if (!session.scans || session.scans->size() < 2 || options.gather == motion::Gathering::Off) continue;
    if (options.gather == motion::Gathering::Auto) {
      frames[s] = frames_by_scans(session, findings, progress);
      continue;
    }
    frames[s] = options.gather_frames;
    findings.push_back(
        {drive::Severity::Note, results::kScansGathered, session.name,
         say::pipeline_scans_gathered_as_set(frames[s], Duration{frames[s] * scan_period_s(*session.scans)})});
  }
  return frames;
}

std::vector<motion::ScanIndex> gathered_scans(const drive::ScanSource& scans, const motion::Keyframe& keyframe,
                                              motion::GatheredFrames frames) {
  constexpr double kFarthest_s = 1.0;  // a slow sensor's neighbours, or those behind a pause, are no help
  std::vector<motion::ScanIndex> gathered{keyframe.scan};
  const std::size_t first = keyframe.scan - std::min<std::size_t>(keyframe.scan, frames.before());
  for (motion::ScanIndex scan(first); scan <= keyframe.scan + frames.after() && scan < scans.size(); ++scan)
    if (scan != keyframe.scan && std::abs(seconds(scans.stamp_ns(scan) - keyframe.stamp_ns)) <= kFarthest_s)
      gathered.push_back(scan);
  return gathered;
}

void add_drift_within_gathered(const DriveMotion& motion, const std::vector<motion::Keyframe>& keyframes,
                               const std::vector<int>& session_frames, std::vector<calibration::JointNode>& nodes) {
  // Of a random walk, the variance of its mean over a time about its value in the middle: a twelfth of the time.
  constexpr double kPart = 1.0 / 12.0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const motion::SessionIndex s = keyframes[k].session;
    const drive::Session& session = motion.session(s);
    if (s >= session_frames.size() || session_frames[s] < 2 || !session.scans) continue;
    const double within_s = session_frames[s] * scan_period_s(*session.scans);
    const auto variance = [&](double drift) { return std::isfinite(drift) ? kPart * drift * drift * within_s : 0.0; };
    auto diagonal = nodes[k].between_samples_covariance.diagonal();
    diagonal.head<3>().array() += variance(session.ins_position_drift);
    diagonal.tail<3>().array() += variance(session.ins_attitude_drift);
  }
}

double widening_of_gathered(const DriveMotion& motion, const std::vector<int>& session_frames) {
  constexpr double kSharePerSecond = 0.25 / 0.4, kMost = 0.8;  // a quarter was measured in x with 0.4 s
  double share = 0.0;
  for (motion::SessionIndex s; s < std::min(motion.session_count(), session_frames.size()); ++s)
    if (session_frames[s] > 1 && motion.session(s).scans)
      share = std::max(share, kSharePerSecond * session_frames[s] * scan_period_s(*motion.session(s).scans));
  return 1.0 / (1.0 - std::min(share, kMost));
}

}  // namespace remount::pipeline
