// Scans with few points, with points that are none, or that cannot be read: judged by a sample of them.
#include <set>

#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "model/checks/builtin.h"
#include "model/checks/check_text.h"

namespace remount {
namespace {

constexpr std::size_t kFewPoints = 500;
constexpr double kFewOfUsual = 0.1;   ///< a scan with less than this share of the others' points is a torn one
constexpr double kMostDropped = 0.7;  ///< drivers write a point for every beam that has no return: many are usual

struct Sample {
  std::string name;
  std::size_t points = 0, dropped = 0;
};

std::vector<Sample> sampled(const ScanSource& scans, std::vector<Finding>& findings, const Progress& progress) {
  std::vector<Sample> samples;
  const std::size_t last = scans.size() - 1;
  for (const std::size_t scan : std::set<std::size_t>{0, last / 4, last / 2, last - last / 4, last}) {
    if (progress.cancelled()) break;
    try {
      const PointCloud cloud = scans.load(scan);
      samples.push_back({scans.name(scan), cloud.size(), cloud.dropped_points});
    } catch (const Error& error) {
      findings.push_back({Severity::Warning, "bad-scan", error.where(), error.what_happened()});
    }
  }
  return samples;
}

void report_few(const std::vector<Sample>& samples, std::vector<Finding>& findings) {
  std::vector<double> sizes;
  for (const Sample& sample : samples) sizes.push_back(static_cast<double>(sample.points));
  const double least = std::max(static_cast<double>(kFewPoints), kFewOfUsual * median_of(sizes));
  for (const Sample& sample : samples)
    if (static_cast<double>(sample.points) < least) {
      findings.push_back(
          {Severity::Warning, "scan-few-points", sample.name,
           check_text("The scan has %zu points only; the usual one has %.0f.", sample.points, median_of(sizes))});
      return;  // one stands for all
    }
}

void report_dropped(const std::vector<Sample>& samples, std::vector<Finding>& findings) {
  std::size_t points = 0, dropped = 0;
  for (const Sample& sample : samples) points += sample.points + sample.dropped, dropped += sample.dropped;
  if (dropped == 0) return;
  const double share = static_cast<double>(dropped) / static_cast<double>(points);
  findings.push_back(
      {share > kMostDropped ? Severity::Warning : Severity::Note, "scan-nan", "scans",
       check_text("%.1f %% of the points have no place (NaN, or no range) and are left out.", 100.0 * share)});
}

void look_at_scans(const CheckedSession& checked, std::vector<Finding>& findings, const Progress& progress) {
  if (!checked.session.scans || checked.session.scans->size() == 0) return;
  const std::vector<Sample> samples = sampled(*checked.session.scans, findings, progress);
  if (samples.empty()) return;
  report_few(samples, findings);
  report_dropped(samples, findings);
}

}  // namespace

DataCheck scan_check() {
  return {.kinds = {{"scan-few-points", "Few points do not hold a scan in place: its pairs are rejected or loose.",
                     "See whether the sensor was blocked, or packets were lost; record sweeps whole."},
                    {"scan-nan", "Points without a place are left out, nothing else is.",
                     "Nothing, where they are beams without a return; otherwise check the driver of the sensor."},
                    {"bad-scan", "A scan that cannot be read takes no part.", "Copy or export the scan again."},
                    {"scan-unreadable", "A scan that cannot be read takes no part.", "Copy or export the scan again."}},
          .look = look_at_scans,
          .reads_scans = true};
}

}  // namespace remount
