#include "algorithms/registration/search_around.h"

#include <algorithm>
#include <cstdio>

#include "algorithms/registration/coarse_alignment.h"
#include "messages/pairs.h"

namespace remount::registration {
namespace {

constexpr std::size_t kModes = 8;
constexpr double kSame_m = 0.3, kSame_rad = 0.02;
constexpr double kFar_m = 1.0, kFar_rad = 0.1;
// Right alignments of neighbouring scans agree by 0.48 and more (simulated and KITTI), wrong ones by up to 0.32; scans
// twenty metres apart have little in common and agree by 0.29 where they are right.
constexpr double kSurelyRight = 0.45, kSurelyWrong = 0.25;
constexpr double kAlike = 0.96;  // of the best agreement

bool same_place(const RigidTransform& first, const RigidTransform& second) {
  const Vector6d apart = difference(first, second);
  return apart.head<3>().norm() < kSame_m && apart.tail<3>().norm() < kSame_rad;
}

struct Place {
  RigidTransform target_from_source = RigidTransform::Identity();
  double agreement;
};

// Of several that end in one place the best counts.
void add_place(const Place& place, std::vector<Place>& places) {
  for (Place& known : places)
    if (same_place(known.target_from_source, place.target_from_source)) {
      if (place.agreement > known.agreement) known = place;
      return;
    }
  places.push_back(place);
}

// Widely first, then as the pair is aligned in the end.
RigidTransform refine(const PreparedCloud& source, const PreparedCloud& target, const RigidTransform& start,
                      const RegistrationOptions& options, const Progress& progress) {
  RegistrationOptions wide = options;
  wide.max_correspondence_m = std::max(2.0, options.max_correspondence_m);
  wide.max_iterations = 30;
  const RigidTransform near = align_plane_to_plane(source, target, start, wide, progress).target_from_source;
  return align_plane_to_plane(source, target, near, options, progress).target_from_source;
}

Message ambiguity_of(const Place& best, const Place& other) {
  const Vector6d apart = difference(best.target_from_source, other.target_from_source);
  return say::registration_ambiguous({apart.head<3>().norm()}, {apart.tail<3>().norm()}, other.agreement,
                                     best.agreement);
}

}  // namespace

bool moved_far(const RigidTransform& from, const RigidTransform& to) {
  const Vector6d moved = difference(from, to);
  return !(moved.head<3>().norm() < kFar_m && moved.tail<3>().norm() < kFar_rad);
}

bool is_doubtful(const JudgedAlignment& alignment, const RigidTransform& start, const RegistrationOptions& options) {
  const bool stayed = options.near_is_a_sign && alignment.result.quality.converged &&
                      !moved_far(start, alignment.result.target_from_source);
  return alignment.agreement < (stayed ? kSurelyWrong : kSurelyRight);
}

AroundSearch search_around(const PreparedCloud& source, const PreparedCloud& target, const RigidTransform& start,
                           const JudgedAlignment& doubtful, const RegistrationOptions& options,
                           const Progress& progress) {
  const Place first{doubtful.result.target_from_source, doubtful.agreement};
  std::vector<Place> places{first};
  for (const CoarseMode& mode : coarse_modes(source, target, start, options, kModes, progress)) {
    const RigidTransform found = refine(source, target, mode.target_from_source, options, progress);
    if (progress.cancelled()) return {};
    if (!found.matrix().allFinite()) continue;
    const double radius_m = 0.5 * options.max_correspondence_m;
    add_place({found, alignment_equations(source, target, found, radius_m, progress).agreement}, places);
    if (progress.cancelled()) return {};
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.agreement > b.agreement; });
  const Place& best = places.front();
  AroundSearch out{first.target_from_source, false, {}};
  // Of two that fit alike, the one that a near start led to is the answer.
  if (!moved_far(start, first.target_from_source) && first.agreement >= kAlike * best.agreement) return out;
  if (places.size() > 1 && places[1].agreement > kAlike * best.agreement) out.ambiguity = ambiguity_of(best, places[1]);
  out.target_from_source = best.target_from_source;
  out.better = best.agreement > first.agreement;
  return out;
}

}  // namespace remount::registration
