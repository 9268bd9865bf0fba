#include "model/conventions/north_hypotheses.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/core/index.h"
#include "algorithms/geodesy/earth_radius.h"
#include "model/conventions/travel_direction.h"

namespace remount::conventions {
namespace {

constexpr double kConvergence_rad = 1.5 * kPi / 180.0;  // of a place on most national grids, 1 sigma
constexpr double kWideConvergence_rad = 5.0 * kPi / 180.0, kWideShare = 0.05;  // and on oblique ones, as Krovak's
constexpr double kInLine_rad = 0.4 * kPi / 180.0;                              // of most INS in their vehicle
constexpr double kGridScale_sigma = 2e-4;  // with the height, which changes it as well
constexpr double kOtherScale_sigma = 4e-4;

double normal_density(double x, double sigma) {
  return std::exp(-0.5 * x * x / (sigma * sigma)) / (sigma * std::sqrt(2.0 * kPi));
}

double convergence_density(double angle_rad) {
  return (1.0 - kWideShare) * normal_density(angle_rad, kConvergence_rad) +
         kWideShare * normal_density(angle_rad, kWideConvergence_rad);
}

/// How likely numbers are UTM's before the drive is looked at. Its eastings have six digits and stay within three
/// degrees of the middle of a zone; its northings count from the equator, those of nations from near their south.
double likelihood_of_utm(const Eigen::Vector3d& at, std::optional<bool> northern) {
  constexpr double kOften = 0.9, kRarely = 0.3;
  constexpr double kLeastEasting_m = 1e5, kMostEasting_m = 9e5, kMiddle_m = 5e5, kNationalNorthing_m = 1.25e6,
                   kOfEquator_m = 1e7;
  constexpr double kHalfZone_rad = 3.5 * kPi / 180.0;
  if (at.x() < kLeastEasting_m || at.x() > kMostEasting_m || at.y() < 0.0) return 0.0;
  const auto in_zone = [&](bool half) {
    const double latitude_rad = (half ? at.y() : kOfEquator_m - at.y()) / geodesy::kEarthRadius_m;
    return std::abs(at.x() - kMiddle_m) < kHalfZone_rad * geodesy::kEarthRadius_m * std::cos(latitude_rad);
  };
  const bool usual = at.y() > kNationalNorthing_m && (northern ? in_zone(*northern) : in_zone(true) || in_zone(false));
  return usual ? kOften : kRarely;
}

/// Another grid: attitudes to its north, or to the true one by any convergence.
void add_other_grid(double weight, double to_true_north, std::vector<NorthHypothesis>& norths) {
  constexpr double kStep_rad = 0.1 * kPi / 180.0;
  constexpr int kSteps = 120;
  norths.push_back({.world = PoseWorld::OtherGrid, .weight = weight * (1.0 - to_true_north)});
  for (int i = -kSteps; i <= kSteps; ++i)
    norths.push_back({.world = PoseWorld::OtherGrid,
                      .correction_rad = kStep_rad * i,
                      .weight = weight * to_true_north * kStep_rad * convergence_density(kStep_rad * i)});
}

}  // namespace

std::optional<HeadingApart> heading_apart(const drive::Session& session) {
  const std::optional<TravelDirection> travel = travel_direction(MetricPoses(session));
  if (!travel) return std::nullopt;
  return HeadingApart{travel->yaw_rad - 0.5 * kPi * std::round(travel->yaw_rad / (0.5 * kPi)), travel->sigma_rad};
}

double setup_density(double angle_rad, double sigma_rad) {
  constexpr double kTurned_rad = 1.5 * kPi / 180.0, kTurnedShare = 0.1;
  const double in_line = normal_density(angle_rad, std::hypot(kInLine_rad, sigma_rad));
  const double turned = normal_density(angle_rad, kTurned_rad);
  return (1.0 - kTurnedShare) * in_line + kTurnedShare * turned + 1e-6;
}

std::vector<NorthHypothesis> norths_by_numbers(const drive::Session& session, std::optional<bool> on_utm,
                                               std::optional<bool> northern) {
  constexpr double kNorthern = 0.8;
  const double to_true_north = session.attitudes_to_true_north ? 0.98 : 0.5;
  const Eigen::Vector3d at = session.world_from_ins[session.world_from_ins.size() / 2].pose.translation();
  const double utm = on_utm ? (*on_utm ? 1.0 : 0.0) : likelihood_of_utm(at, northern);
  std::vector<NorthHypothesis> norths;
  if (utm > 0.0)
    norths.push_back(
        {.world = PoseWorld::Utm, .northern = northern.value_or(true), .weight = utm * (1.0 - to_true_north)});
  for (const bool half : {true, false}) {
    if (utm == 0.0 || (northern && *northern != half)) continue;
    const std::optional<geodesy::GridFix> here = geodesy::grid_fix_at(at.x(), at.y(), half);
    if (!here) continue;
    const double share = northern ? 1.0 : half ? kNorthern : 1.0 - kNorthern;
    norths.push_back({.world = PoseWorld::Utm,
                      .correction_rad = here->convergence_rad,
                      .northern = half,
                      .weight = utm * to_true_north * share});
  }
  if (utm < 1.0) add_other_grid(1.0 - utm, to_true_north, norths);
  return norths;
}

std::vector<NorthHypothesis> norths_by_fixes(const drive::Session& session, const TurnedByFixes& turned,
                                             const geodesy::GridFix& here, bool not_utm) {
  constexpr double kOther = 0.1;
  const double utm = not_utm ? 0.0 : 0.5;
  const double to_true_north = session.attitudes_to_true_north ? 0.98 : 0.6;
  const bool northern = turned.latitude_rad >= 0.0;
  const double convergence_rad = here.convergence_rad;
  std::vector<NorthHypothesis> norths{{.turned_rad = 0.0, .weight = 0.3}, {.weight = 0.2}};
  for (const bool to_true : {true, false}) {
    const double share = to_true ? to_true_north : 1.0 - to_true_north;
    norths.push_back({.world = PoseWorld::Utm,
                      .correction_rad = to_true ? convergence_rad : 0.0,
                      .turned_rad = convergence_rad,
                      .scale = here.point_scale,
                      .scale_sigma = kGridScale_sigma,
                      .northern = northern,
                      .weight = utm * share});
    // As likely as such a convergence is: what it is, the fixes say.
    norths.push_back({.world = PoseWorld::OtherGrid,
                      .correction_rad = to_true ? turned.angle_rad : 0.0,
                      .scale_sigma = kOtherScale_sigma,
                      .weight = kOther * share * convergence_density(turned.angle_rad) * 2.0 * kPi});
  }
  return norths;
}

void weigh_norths(const std::optional<TurnedByFixes>& turned, const std::optional<HeadingApart>& heading,
                  std::vector<NorthHypothesis>& norths) {
  constexpr double kGrid_rad = 0.05 * kPi / 180.0, kLeastScale_sigma = 1e-5, kAnyScale = 1e-3;
  double sum = 0.0;
  for (NorthHypothesis& north : norths) {
    if (turned) {
      north.weight *= north.turned_rad ? normal_density(wrap_angle_rad(turned->angle_rad - *north.turned_rad),
                                                        std::hypot(turned->sigma, kGrid_rad))
                                       : 0.5 / kPi;
      north.weight *= kAnyScale + normal_density(turned->scale - north.scale,
                                                 std::hypot(turned->sigma, north.scale_sigma, kLeastScale_sigma));
    }
    if (heading) north.weight *= setup_density(heading->apart_rad - north.correction_rad, heading->sigma_rad);
    sum += north.weight;
  }
  for (NorthHypothesis& north : norths) north.weight /= sum;
}

NorthHypothesis likeliest_north(const std::vector<NorthHypothesis>& norths) {
  std::array<double, 3> worlds{};
  for (const NorthHypothesis& north : norths) worlds[index_of(north.world)] += north.weight;
  const auto world = static_cast<PoseWorld>(std::max_element(worlds.begin(), worlds.end()) - worlds.begin());
  const NorthHypothesis* best = nullptr;
  for (const NorthHypothesis& north : norths)
    if (north.world == world && (best == nullptr || north.weight > best->weight)) best = &north;
  return *best;
}

bool fits_travel(const NorthHypothesis& north, const HeadingApart& heading) {
  return std::abs(heading.apart_rad - north.correction_rad) < 3.0 * std::hypot(kInLine_rad, heading.sigma_rad);
}

double north_doubt_rad(const std::vector<NorthHypothesis>& norths, const NorthHypothesis& taken) {
  constexpr double kBeyondThreeSigma = 0.001;
  const auto apart = [&](const NorthHypothesis& north) {
    return std::abs(north.correction_rad - taken.correction_rad);
  };
  std::vector<NorthHypothesis> farthest_first = norths;
  std::sort(farthest_first.begin(), farthest_first.end(),
            [&](const NorthHypothesis& a, const NorthHypothesis& b) { return apart(a) > apart(b); });
  double square = 0.0, beyond = 0.0, edge_rad = 0.0;
  for (const NorthHypothesis& north : farthest_first) {
    square += north.weight * std::pow(apart(north), 2);
    beyond += north.weight;
    if (beyond > kBeyondThreeSigma) edge_rad = std::max(edge_rad, apart(north));
  }
  return std::max(std::sqrt(square), edge_rad / 3.0);
}

}  // namespace remount::conventions
