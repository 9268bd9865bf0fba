// Where the stated error of positions grows: corrections were lost.
#include <algorithm>
#include <cmath>

#include "model/checks/builtin.h"
#include "model/checks/check_text.h"
#include "model/count_words.h"

namespace remount {
namespace {

constexpr double kTimesBest = 10.0;     ///< from fixed to float, or to none
constexpr double kLeastSigma_m = 0.15;  ///< what is still as good as fixed is no loss

/// Stamp and horizontal sigma of each position that states one.
struct StatedError {
  std::int64_t stamp_ns = 0;
  double sigma_m = 0.0;
};

void report(std::vector<StatedError> stated, const char* where, std::vector<Finding>& findings) {
  if (stated.size() < 10) return;
  std::vector<double> sorted;
  for (const StatedError& error : stated) sorted.push_back(error.sigma_m);
  const auto tenth = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 10);
  std::nth_element(sorted.begin(), tenth, sorted.end());
  const double best_m = *tenth, limit_m = std::max(kLeastSigma_m, kTimesBest * best_m);
  std::size_t lost = 0, stretches = 0;
  double worst_m = 0.0;
  bool within = false;
  for (const StatedError& error : stated) {
    const bool bad = error.sigma_m > limit_m;
    stretches += bad && !within;
    lost += bad;
    within = bad;
    worst_m = std::max(worst_m, error.sigma_m);
  }
  if (lost == 0) return;
  findings.push_back(
      {Severity::Warning, "rtk-lost", where,
       check_text("The stated error of the position grows from %.3f m to %.2f m in %s, %.0f %% of the drive: "
                  "corrections (RTK) were lost.",
                  best_m, worst_m, number_of(stretches, "stretch", "stretches").c_str(),
                  100.0 * static_cast<double>(lost) / static_cast<double>(stated.size()))});
}

void look(const CheckedSession& checked, std::vector<Finding>& findings, const Progress&) {
  // Where positions say how they were found, their reader has told it.
  const std::vector<Finding>& told = checked.session.findings;
  if (std::any_of(told.begin(), told.end(), [](const Finding& finding) { return finding.code == "rtk-lost"; })) return;
  std::vector<StatedError> ins, gnss;
  for (const InsSample& sample : checked.session.ins)
    if (const double sigma_m = sample.sigma.position_enu_m.head<2>().norm(); std::isfinite(sigma_m) && sigma_m > 0.0)
      ins.push_back({sample.stamp_ns, sigma_m});
  for (const GnssFix& fix : checked.session.gnss)
    if (const double sigma_m = std::sqrt(fix.covariance_enu_m2(0, 0) + fix.covariance_enu_m2(1, 1));
        std::isfinite(sigma_m) && sigma_m > 0.0)
      gnss.push_back({fix.stamp_ns, sigma_m});
  report(std::move(ins), "INS", findings);
  report(std::move(gnss), "GNSS", findings);
}

}  // namespace

DataCheck rtk_check() {
  return {.kinds = {{"rtk-lost", "Positions drift while corrections are missing, and jump when they come back.",
                     "Check the link to the corrections; record under open sky, or process the log afterwards (PPK)."}},
          .look = look};
}

}  // namespace remount
