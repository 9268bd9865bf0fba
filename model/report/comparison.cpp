#include "model/report/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algorithms/messages/render.h"
#include "model/display_units.h"

namespace remount {
namespace {

/// Why the two cannot be set against each other; empty where they can.
std::string not_comparable(const NamedResult& a, const NamedResult& b) {
  for (const NamedResult* result : {&a, &b})
    if (!is_usable(result->file.result)) return result->name + " has nothing to use";
  const std::string &frame_a = a.file.result.reference_frame, &frame_b = b.file.result.reference_frame;
  if (frame_a != frame_b)
    return a.name + " is in the frame \"" + frame_a + "\" and " + b.name + " in \"" + frame_b + "\"";
  const std::string &sensor_a = a.file.result.calibrated, &sensor_b = b.file.result.calibrated;
  if (sensor_a != sensor_b) return a.name + " places the " + sensor_a + " and " + b.name + " the " + sensor_b;
  if (a.file.ins_axes && b.file.ins_axes && *a.file.ins_axes != *b.file.ins_axes)
    return a.name + " and " + b.name + " have other INS axes";
  return {};
}

/// Two methods, or settings, on the same files: in which nothing can have been moved.
bool of_one_recording(const ResultFile& a, const ResultFile& b) {
  return !a.inputs.empty() && std::equal(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end(),
                                         [](const InputFile& one, const InputFile& other) {
                                           return one.file == other.file && one.sha256 == other.sha256;
                                         });
}

std::string in_words(const NamedResult& a, const NamedResult& b, const ResultDifference& difference,
                     const LargestDifference& largest) {
  const std::size_t i = largest.parameter;
  char text[160];
  std::snprintf(text, sizeof(text), "%s differs by %.*f %s, %.1f times the sigma of both together",
                std::string(kParameterNames[i]).c_str(), justified_decimals(on_screen(i, difference.sigma[i])),
                std::abs(on_screen(i, difference.difference[i])), is_angle(i) ? "deg" : "m", largest.sigmas);
  if (largest.sigmas > kDiffer_sigma)
    return a.name + " and " + b.name + " contradict each other: " + text +
           (of_one_recording(a.file, b.file)
                ? ". At least one of them claims too much; look at its residuals, its clock and its nominal mounting."
                : ". Either the LiDAR was moved in between, or one of them claims too much: look at its residuals, its "
                  "clock and its nominal mounting.");
  return a.name + " and " + b.name + " agree within what they claim: at most, " + text + ".";
}

}  // namespace

std::vector<ComparedResults> compare_results(const std::vector<NamedResult>& results) {
  std::vector<ComparedResults> compared;
  for (std::size_t a = 0; a < results.size(); ++a)
    for (std::size_t b = a + 1; b < results.size(); ++b) {
      ComparedResults pair{a, b, {}, false, not_comparable(results[a], results[b])};
      pair.difference.difference.fill(std::nan(""));
      pair.difference.sigma.fill(std::nan(""));
      if (pair.words.empty()) {
        pair.difference = difference_of(results[a].file.result, results[b].file.result);
        const auto largest = largest_difference(pair.difference);
        pair.contradict = largest && largest->sigmas > kDiffer_sigma;
        pair.words = largest ? in_words(results[a], results[b], pair.difference, *largest)
                             : results[a].name + " and " + results[b].name + " observe no component in common.";
      } else {
        pair.words = "Not compared: " + english(pair.words) + ".";
      }
      compared.push_back(std::move(pair));
    }
  return compared;
}

}  // namespace remount
