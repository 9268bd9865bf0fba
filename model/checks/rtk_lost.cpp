// Where the stated error of positions grows: corrections were lost.
#include <algorithm>
#include <cmath>

#include "messages/checks.h"
#include "messages/places.h"
#include "model/checks/builtin.h"

namespace remount::checks {
namespace {

constexpr double kTimesBest = 10.0;     ///< from fixed to float, or to none
constexpr double kLeastSigma_m = 0.15;  ///< what is still as good as fixed is no loss

/// Horizontal sigma of each position that states one, in the order of the drive; there may be millions.
template <class Item, class Sigma>
std::vector<float> stated_sigmas_m(const std::vector<Item>& items, Sigma&& sigma_m) {
  std::vector<float> stated;
  stated.reserve(items.size());
  for (const Item& item : items)
    if (const double value_m = sigma_m(item); std::isfinite(value_m) && value_m > 0.0)
      stated.push_back(static_cast<float>(value_m));
  return stated;
}

void report(const std::vector<float>& stated, const Message& where, std::vector<drive::Finding>& findings) {
  if (stated.size() < 10) return;
  std::vector<float> sorted = stated;
  const auto tenth = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 10);
  std::nth_element(sorted.begin(), tenth, sorted.end());
  const double best_m = *tenth, limit_m = std::max(kLeastSigma_m, kTimesBest * best_m);
  std::size_t lost = 0, stretches = 0;
  double worst_m = 0.0;
  bool within = false;
  for (const double sigma_m : stated) {
    const bool bad = sigma_m > limit_m;
    stretches += bad && !within;
    lost += bad;
    within = bad;
    worst_m = std::max(worst_m, sigma_m);
  }
  if (lost == 0) return;
  findings.push_back({drive::Severity::Warning, "rtk-lost", where,
                      say::rtk_lost(Length{best_m}, Length{worst_m}, stretches,
                                    Share{static_cast<double>(lost) / static_cast<double>(stated.size())})});
}

void look_for_lost_rtk(const CheckedSession& checked, std::vector<drive::Finding>& findings, const Progress&) {
  // Where positions say how they were found, their reader has told it.
  const std::vector<drive::Finding>& told = checked.session.findings;
  if (std::any_of(told.begin(), told.end(), [](const drive::Finding& finding) { return finding.code == "rtk-lost"; }))
    return;
  const auto of_ins = [](const motion::InsSample& sample) { return sample.sigma.position_enu_m.head<2>().norm(); };
  const auto of_gnss = [](const motion::GnssFix& fix) {
    return std::sqrt(fix.covariance_enu_m2(0, 0) + fix.covariance_enu_m2(1, 1));
  };
  report(stated_sigmas_m(checked.session.ins, of_ins), say::place_ins(), findings);
  report(stated_sigmas_m(checked.session.gnss, of_gnss), say::place_gnss(), findings);
}

}  // namespace

DataCheck rtk_check() {
  return {.kinds = {{"rtk-lost", say::rtk_lost_meaning, say::rtk_lost_remedy}}, .look = look_for_lost_rtk};
}

}  // namespace remount::checks
