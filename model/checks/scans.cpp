// Scans with few points, with points that are none, or that cannot be read: judged by a sample of them.
#include <set>

#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "messages/checks.h"
#include "messages/places.h"
#include "model/checks/builtin.h"

namespace remount::checks {
namespace {

constexpr std::size_t kFewPoints = 500;
constexpr double kFewOfUsual = 0.1;   ///< a scan with less than this share of the others' points is a torn one
constexpr double kMostDropped = 0.7;  ///< drivers write a point for every beam that has no return: many are usual

struct Sample {
  std::string name;
  std::size_t points = 0, dropped = 0;
};

std::vector<Sample> sample(const drive::ScanSource& scans, std::vector<drive::Finding>& findings,
                           const Progress& progress) {
  std::vector<Sample> samples;
  const std::size_t last = scans.size() - 1;
  for (const std::size_t scan : std::set<std::size_t>{0, last / 4, last / 2, last - last / 4, last}) {
    if (progress.cancelled()) break;
    try {
      const cloud::PointCloud cloud = scans.load(scan);
      samples.push_back({scans.name(scan), cloud.size(), cloud.dropped_points});
    } catch (const Error& error) {
      findings.push_back({drive::Severity::Warning, "bad-scan", error.where(), error.what_happened()});
    }
  }
  return samples;
}

void report_few(const std::vector<Sample>& samples, std::vector<drive::Finding>& findings) {
  std::vector<double> sizes;
  for (const Sample& sample : samples) sizes.push_back(static_cast<double>(sample.points));
  const double usual = median_of(sizes), least = std::max(static_cast<double>(kFewPoints), kFewOfUsual * usual);
  for (const Sample& sample : samples)
    if (static_cast<double>(sample.points) < least) {
      findings.push_back({usual > 0.0 ? drive::Severity::Warning : drive::Severity::Problem, "scan-few-points",
                          sample.name, say::scan_few_points(sample.points, usual)});
      return;  // one stands for all
    }
}

void report_dropped(const std::vector<Sample>& samples, std::vector<drive::Finding>& findings) {
  std::size_t points = 0, dropped = 0;
  for (const Sample& sample : samples) points += sample.points + sample.dropped, dropped += sample.dropped;
  if (dropped == 0) return;
  const double share = static_cast<double>(dropped) / static_cast<double>(points);
  findings.push_back({share > kMostDropped ? drive::Severity::Warning : drive::Severity::Note, "scan-nan",
                      say::place_scans(), say::scan_nan(Share{share})});
}

void look_at_scans(const CheckedSession& checked, std::vector<drive::Finding>& findings, const Progress& progress) {
  if (!checked.session.scans || checked.session.scans->size() == 0) return;
  const std::vector<Sample> samples = sample(*checked.session.scans, findings, progress);
  if (samples.empty()) return;
  report_few(samples, findings);
  report_dropped(samples, findings);
}

}  // namespace

DataCheck scan_check() {
  return {.kinds = {{"scan-few-points", say::scan_few_points_meaning, say::scan_few_points_remedy},
                    {"scan-nan", say::scan_nan_meaning, say::scan_nan_remedy},
                    {"bad-scan", say::bad_scan_meaning, say::bad_scan_remedy},
                    {"scan-unreadable", say::bad_scan_meaning, say::bad_scan_remedy}},
          .look = look_at_scans,
          .reads_scans = true};
}

}  // namespace remount::checks
