#include "algorithms/calibration/mounting_source.h"

#include <array>
#include <cstdio>

#include "messages/sources.h"

namespace remount::calibration {
namespace {

struct Named {
  MountingSource::Kind kind;
  std::string_view in_files;
  Message (*words)();
};

// Those that are of no pair in particular.
constexpr std::array<Named, 9> kNamed{{
    {MountingSource::Result, "result", say::source_result},
    {MountingSource::Nominal, "nominal", say::source_nominal},
    {MountingSource::Refined, "refined", say::source_refined},
    {MountingSource::JointClouds, "joint clouds", say::source_joint_clouds},
    {MountingSource::ParkMartin, "all pairs: Park-Martin", say::source_park_martin},
    {MountingSource::DualQuaternion, "all pairs: dual quaternion", say::source_dual_quaternion},
    {MountingSource::JointQuadratic, "all pairs: joint quadratic", say::source_joint_quadratic},
    {MountingSource::CertifiedOptimum, "all pairs: certified optimum", say::source_certified_optimum},
    {MountingSource::BestInRange, "all pairs: best found in range", say::source_best_in_range},
}};

}  // namespace

MountingSource MountingSource::pair(motion::PairIndex number) {
  MountingSource source(OnePair);
  source.first = number;
  return source;
}

MountingSource MountingSource::pairs(motion::PairIndex first, motion::PairIndex second) {
  MountingSource source(TwoPairs);
  source.first = first;
  source.second = second;
  return source;
}

std::string to_string(const MountingSource& source) {
  if (source.kind == MountingSource::OnePair) return "pair " + std::to_string(source.first);
  if (source.kind == MountingSource::TwoPairs)
    return "pairs " + std::to_string(source.first) + " + " + std::to_string(source.second);
  for (const Named& named : kNamed)
    if (named.kind == source.kind) return std::string(named.in_files);
  return source.unknown;
}

MountingSource mounting_source_from_string(std::string_view text) {
  for (const Named& named : kNamed)
    if (named.in_files == text) return named.kind;
  const std::string whole(text);
  const auto numbered = [](unsigned number) { return motion::PairIndex(std::size_t{number}); };
  unsigned first = 0, second = 0;
  // Only what is written back alike is one: neither "pair 1 of 2" nor "pair 99999999999".
  for (const MountingSource& source :
       {std::sscanf(whole.c_str(), "pair %9u", &first) == 1 ? MountingSource::pair(numbered(first)) : MountingSource(),
        std::sscanf(whole.c_str(), "pairs %9u + %9u", &first, &second) == 2
            ? MountingSource::pairs(numbered(first), numbered(second))
            : MountingSource()})
    if (source.kind != MountingSource::Unknown && to_string(source) == whole) return source;
  MountingSource source;
  source.unknown = whole;
  return source;
}

Message in_words(const MountingSource& source) {
  if (source.kind == MountingSource::OnePair) return say::source_pair(signed_of(source.first));
  if (source.kind == MountingSource::TwoPairs)
    return say::source_pairs(signed_of(source.first), signed_of(source.second));
  for (const Named& named : kNamed)
    if (named.kind == source.kind) return named.words();
  return Message::verbatim(source.unknown);
}

}  // namespace remount::calibration
