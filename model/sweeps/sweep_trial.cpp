#include "model/sweeps/sweep_trial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "algorithms/odometry/lidar/lidar_odometry.h"
#include "messages/stages.h"
#include "model/conventions/metric_poses.h"
#include "model/drive/stamped_streams.h"
#include "model/pipeline/scan_times.h"

namespace remount::sweeps {
namespace {

constexpr std::size_t kMostTrialScans = 96;
constexpr std::size_t kMostTrialPoints = 30'000;  ///< of a scan
constexpr std::size_t kFirstScans = 2;            ///< have next to no map before them

struct StampedCloud {
  std::int64_t stamp_ns = 0;
  cloud::PointCloud cloud;
};

/// The stretch that turns most, as the INS has it; the middle of the recording where there is none.
std::size_t first_of_stretch(const drive::Session& session) {
  const drive::ScanSource& scans = *session.scans;
  if (scans.size() <= kMostTrialScans) return 0;
  const conventions::MetricPoses poses(session);
  std::vector<double> turned_rad(scans.size(), 0.0);
  std::size_t pose = 0;
  std::optional<std::size_t> before;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    while (pose + 1 < poses.size() && poses[pose + 1].stamp_ns <= scans.stamp_ns(i)) ++pose;
    const bool within = pose + 1 < poses.size() && poses[pose].stamp_ns <= scans.stamp_ns(i);
    turned_rad[i] = i > 0 ? turned_rad[i - 1] : 0.0;
    if (within && before) turned_rad[i] += rotation_angle_between_rad(poses[*before].pose, poses[pose].pose);
    before = within ? std::optional(pose) : std::nullopt;
  }
  std::size_t best = (scans.size() - kMostTrialScans) / 2;
  const auto turned_within = [&](std::size_t first) {
    return turned_rad[first + kMostTrialScans - 1] - turned_rad[first];
  };
  for (std::size_t first = 0; first + kMostTrialScans <= scans.size(); ++first)
    if (turned_within(first) > turned_within(best)) best = first;
  return best;
}

cloud::PointCloud thinned_in_order(const cloud::PointCloud& cloud) {
  if (cloud.size() <= kMostTrialPoints) return cloud;
  const bool timed = cloud.time_from_stamp_s.size() == cloud.size();
  cloud::PointCloud out;
  for (std::size_t k = 0; k < kMostTrialPoints; ++k) {
    const std::size_t from = k * cloud.size() / kMostTrialPoints;
    out.points.push_back(cloud.points[from]);
    if (timed) out.time_from_stamp_s.push_back(cloud.time_from_stamp_s[from]);
  }
  return out;
}

std::vector<StampedCloud> load_stretch(const drive::Session& session, int threads, Progress& progress) {
  const std::size_t first = first_of_stretch(session);
  const std::size_t count = std::min(kMostTrialScans, session.scans->size() - first);
  std::vector<StampedCloud> loaded(count);
  parallel_for(count, threads, [&](std::size_t i) {
    if (progress.cancelled()) return;
    try {
      loaded[i] = {session.scans->stamp_ns(first + i), thinned_in_order(session.scans->load(first + i))};
    } catch (const Error&) {
      // Named where the scans are used.
    }
  });
  std::erase_if(loaded, [](const StampedCloud& scan) { return scan.cloud.points.empty(); });
  return loaded;
}

/// What the odometry leaves between each scan and the map: the logarithm of the distance, larger the fewer points have
/// a counterpart.
std::vector<double> residuals_of(const std::vector<StampedCloud>& scans, const SweepGuess& guess,
                                 const settings::Settings& settings, const Progress& progress) {
  const double lost = std::log(settings.registration.max_rmse_m / std::max(0.1, settings.registration.min_overlap));
  drive::Session timing;  // how the guess tells times, nothing else
  timing.scan_timing = drive::ScanTiming::Unknown;
  odometry::LidarOdometry odometry(settings.lidar_odometry, settings.registration);
  std::vector<double> residuals;
  const auto take = [&](const std::vector<odometry::OdometryPose>& poses) {
    for (const odometry::OdometryPose& pose : poses) {
      const bool judged = pose.aligned && pose.rmse_m > 0.0 && pose.overlap > 0.0;
      residuals.push_back(judged ? std::min(lost, std::log(pose.rmse_m / pose.overlap)) : lost);
    }
  };
  for (const StampedCloud& scan : scans) {
    if (progress.cancelled()) return {};
    take(odometry.push(scan.cloud, pipeline::told_times(timing, scan.cloud, guess), scan.stamp_ns, progress));
  }
  take(odometry.finish(progress));
  return residuals;
}

/// How one guess compares with another over the stretch.
struct Comparison {
  double mean = 0.0;  ///< of the logarithm of the ratio of residuals; below 0: the first is better
  bool clear = false;
};

/// Differences of two guesses over blocks of scans, for neighbours share the map they are compared with: blocks of them
/// are independent. Of a short drive, shorter ones.
void add_blocks(const std::vector<double>& first, const std::vector<double>& second, std::vector<double>& blocks) {
  constexpr std::size_t kLongestBlock = 8, kShortestBlock = 2, kBlocks = 6;
  const std::size_t scans = first.size() - std::min(first.size(), kFirstScans);
  const std::size_t block = std::clamp(scans / kBlocks, kShortestBlock, kLongestBlock);
  for (std::size_t from = kFirstScans; from + block <= first.size(); from += block) {
    double sum = 0.0;
    for (std::size_t i = from; i < from + block; ++i) sum += first[i] - second[i];
    blocks.push_back(sum / static_cast<double>(block));
  }
}

Comparison compare_blocks(const std::vector<double>& blocks) {
  constexpr double kLeast = 0.02;   // share
  constexpr double kClearly = 4.0;  // times its own scatter
  constexpr std::size_t kFewestBlocks = 4;
  Comparison out;
  if (blocks.size() < kFewestBlocks) return out;
  const auto count = static_cast<double>(blocks.size());
  out.mean = std::accumulate(blocks.begin(), blocks.end(), 0.0) / count;
  double squares = 0.0;
  for (const double one : blocks) squares += (one - out.mean) * (one - out.mean);
  const double sigma = std::sqrt(squares / (count - 1.0) / count);
  out.clear = out.mean < -kLeast && out.mean < -kClearly * sigma;
  return out;
}

/// Guesses that differ only in where the sweep begins are of one kind: none, the order of the points or a direction of
/// turning, each over a time.
struct SweepKind {
  enum class Way { None, ByOrder, Clockwise, CounterClockwise, ByTimes, ByTimesBackwards } way = Way::None;
  double period_s = 0.0;
  auto operator<=>(const SweepKind&) const = default;
};

SweepKind kind_of(const SweepGuess& guess) {
  if (!guess) return {};
  if (guess->by_times)
    return {guess->by_times == drive::TimesCount::Backwards ? SweepKind::Way::ByTimesBackwards
                                                            : SweepKind::Way::ByTimes};
  if (guess->by_order) return {SweepKind::Way::ByOrder, guess->period_s};
  return {guess->clockwise ? SweepKind::Way::Clockwise : SweepKind::Way::CounterClockwise, guess->period_s};
}

/// What several sessions say together, of each of which the same ways were tried.
struct Verdict {
  std::size_t best = 0;
  std::vector<std::size_t> others;  ///< not refuted
  bool proved = false;
  double gain = 0.0;
};

Verdict judge_sweeps(const std::vector<const SweepTrial*>& trials) {
  Verdict verdict;
  double least = 0.0;
  const std::size_t ways = trials.front()->tried.size();
  for (std::size_t way = 0; way < ways; ++way) {
    double sum = 0.0;
    for (const SweepTrial* trial : trials)
      sum = std::accumulate(trial->tried[way].residuals.begin(), trial->tried[way].residuals.end(), sum);
    if (way > 0 && sum >= least) continue;
    verdict.best = way;
    least = sum;
  }
  std::vector<double> means;
  for (std::size_t way = 0; way < ways; ++way) {
    if (way == verdict.best) continue;
    std::vector<double> blocks;
    for (const SweepTrial* trial : trials)
      add_blocks(trial->tried[verdict.best].residuals, trial->tried[way].residuals, blocks);
    const Comparison comparison = compare_blocks(blocks);
    means.push_back(comparison.mean);
    if (!comparison.clear) verdict.others.push_back(way);
  }
  // What was compared with nothing is not proved.
  verdict.proved = !means.empty() && verdict.others.empty();
  if (!means.empty()) verdict.gain = 1.0 - std::exp(*std::max_element(means.begin(), means.end()));
  return verdict;
}

void take_verdict(const Verdict& verdict, SweepTrial& trial) {
  trial.best = trial.tried[verdict.best].guess;
  trial.proved = verdict.proved;
  trial.gain = verdict.gain;
  trial.others.clear();
  for (const std::size_t way : verdict.others) trial.others.push_back(trial.tried[way].guess);
}

bool same_ways(const SweepTrial& a, const SweepTrial& b) {
  return std::ranges::equal(
      a.tried, b.tried, {}, [](const TriedSweep& tried) { return kind_of(tried.guess).way; },
      [](const TriedSweep& tried) { return kind_of(tried.guess).way; });
}

/// Half a turn after it begins.
drive::SweepModel sweep_from(double first_azimuth_rad, bool clockwise, double period_s) {
  drive::SweepModel sweep;
  sweep.period_s = period_s;
  sweep.clockwise = clockwise;
  sweep.stamp_azimuth_rad = wrap_angle_rad(first_azimuth_rad + kPi);
  return sweep;
}

drive::SweepModel by_times(drive::TimesCount count) {
  drive::SweepModel sweep;
  sweep.by_times = count;
  return sweep;
}

/// How long a turn takes, as the time between scans has it: of a recording that leaves out every other one, half.
std::vector<double> likely_periods_s(const std::vector<StampedCloud>& scans) {
  constexpr double kShortest_s = 0.04, kLongest_s = 0.26, kThinned_s = 0.15;
  const double step_s = drive::median_period_s(scans);
  if (step_s < kShortest_s) return {0.1};
  if (step_s > kLongest_s) return {0.1, 0.05, 0.2};
  if (step_s > kThinned_s) return {step_s, 0.5 * step_s};
  return {step_s};
}

/// Compares guesses on one stretch of scans, each of them once.
class Trial {
 public:
  Trial(const std::vector<StampedCloud>& scans, const settings::Settings& settings, int threads, Progress& progress)
      : scans_(scans), settings_(settings), threads_(threads), progress_(progress) {}

  void add(const std::vector<SweepGuess>& guesses) {
    const std::size_t from = guesses_.size();
    guesses_.insert(guesses_.end(), guesses.begin(), guesses.end());
    residuals_.resize(guesses_.size());
    progress_.report(say::stage_trying_how_scans_were_swept, from, guesses_.size());
    parallel_for(guesses.size(), threads_, [&](std::size_t i) {
      residuals_[from + i] = residuals_of(scans_, guesses_[from + i], settings_, progress_);
    });
  }

  /// Of all, or of a kind.
  std::optional<std::size_t> best(std::optional<SweepKind> kind = std::nullopt) const {
    std::optional<std::size_t> found;
    double least = 0.0;
    for (std::size_t i = 0; i < guesses_.size(); ++i) {
      if (residuals_[i].empty() || (kind && kind_of(guesses_[i]) != *kind)) continue;
      const double sum = std::accumulate(residuals_[i].begin(), residuals_[i].end(), 0.0);
      if (found && sum >= least) continue;
      found = i;
      least = sum;
    }
    return found;
  }

  /// The best of each kind.
  std::vector<TriedSweep> tried() const {
    std::vector<TriedSweep> out;
    for (const SweepKind& kind : kinds())
      if (const auto found = best(kind)) out.push_back({guesses_[*found], residuals_[*found]});
    return out;
  }

  std::set<SweepKind> kinds() const {
    std::set<SweepKind> all;
    for (const SweepGuess& guess : guesses_) all.insert(kind_of(guess));
    return all;
  }

  const SweepGuess& guess(std::size_t i) const { return guesses_[i]; }

 private:
  const std::vector<StampedCloud>& scans_;
  const settings::Settings& settings_;
  int threads_;
  Progress& progress_;
  std::vector<SweepGuess> guesses_;
  std::vector<std::vector<double>> residuals_;
};

/// Where a sweep begins, for points in another order than that of their times: first by quarters of a turn, then around
/// the best of them.
void find_first_azimuth(Trial& trial, const std::vector<double>& periods_s) {
  std::vector<SweepGuess> quarters;
  for (const double period_s : periods_s)
    for (const bool clockwise : {true, false})
      for (int quarter = 0; quarter < 4; ++quarter)
        quarters.emplace_back(sweep_from(0.5 * kPi * quarter, clockwise, period_s));
  trial.add(quarters);
  for (const double step_rad : {kPi / 4.0, kPi / 8.0, kPi / 16.0}) {
    std::vector<SweepGuess> nearer;
    for (const SweepKind& kind : trial.kinds()) {
      const auto best = kind.way == SweepKind::Way::None ? std::nullopt : trial.best(kind);
      if (!best) continue;
      for (const double side : {-1.0, 1.0}) {
        drive::SweepModel moved = *trial.guess(*best);
        moved.stamp_azimuth_rad = wrap_angle_rad(moved.stamp_azimuth_rad + side * step_rad);
        nearer.emplace_back(moved);
      }
    }
    trial.add(nearer);
  }
}

void try_unknown(Trial& trial, const std::vector<StampedCloud>& scans) {
  const std::vector<double> periods_s = likely_periods_s(scans);
  const cloud::PointCloud& example = scans[scans.size() / 2].cloud;
  const std::optional<cloud::SweepOrder> order = cloud::sweep_order(example);
  if (!cloud::looks_around(example)) {
    for (const double period_s : periods_s) {
      drive::SweepModel by_order;
      by_order.period_s = period_s;
      by_order.by_order = true;
      trial.add({by_order});
    }
  } else if (order) {
    for (const double period_s : periods_s)
      trial.add({sweep_from(order->first_azimuth_rad, order->clockwise, period_s),
                 sweep_from(order->first_azimuth_rad, !order->clockwise, period_s)});
  } else {
    find_first_azimuth(trial, periods_s);
  }
}

}  // namespace

bool needs_sweep_trial(const drive::Session& session, settings::DeskewMode mode) {
  if (!session.scans || session.scans->size() == 0 || mode == settings::DeskewMode::Off) return false;
  if (session.scan_timing == drive::ScanTiming::Unknown) return true;
  if (session.scan_timing == drive::ScanTiming::PerPoint) return session.times_count == drive::TimesCount::Open;
  if (session.scan_timing != drive::ScanTiming::SweepAzimuth) return false;
  return !session.sweep.direction_known || (!session.sweep.certain && mode == settings::DeskewMode::Auto);
}

SweepTrial try_sweeps(const drive::Session& session, const settings::Settings& settings, int threads,
                      Progress& progress) {
  const std::vector<StampedCloud> scans = load_stretch(session, threads, progress);
  if (scans.size() < 2) return {};
  Trial trial(scans, settings, threads, progress);
  const bool surely_swept = settings.run.deskew == settings::DeskewMode::On ||
                            session.scan_timing == drive::ScanTiming::PerPoint ||
                            (session.scan_timing == drive::ScanTiming::SweepAzimuth && session.sweep.certain);
  if (!surely_swept) trial.add({std::nullopt});
  if (session.scan_timing == drive::ScanTiming::Unknown) {
    try_unknown(trial, scans);
  } else if (session.scan_timing == drive::ScanTiming::PerPoint) {
    trial.add({by_times(drive::TimesCount::Forwards), by_times(drive::TimesCount::Backwards)});
  } else {
    drive::SweepModel reversed = session.sweep;
    reversed.clockwise = !reversed.clockwise;
    trial.add({session.sweep});
    if (!session.sweep.direction_known) trial.add({reversed});
  }
  SweepTrial out;
  out.tried = trial.tried();
  if (!out.tried.empty() && !progress.cancelled()) take_verdict(judge_sweeps({&out}), out);
  return out;
}

void prove_together(const std::vector<SweepTrial*>& trials) {
  std::vector<SweepTrial*> open;
  for (SweepTrial* trial : trials)
    if (!trial->proved && trial->tried.size() > 1) open.push_back(trial);
  while (open.size() > 1) {
    SweepTrial* const first = open.front();
    const auto others = std::stable_partition(open.begin(), open.end(),
                                              [&](const SweepTrial* trial) { return same_ways(*trial, *first); });
    const Verdict verdict = judge_sweeps({open.begin(), others});
    for (auto trial = open.begin(); trial != others; ++trial) take_verdict(verdict, **trial);
    open.erase(open.begin(), others);
  }
}

}  // namespace remount::sweeps
