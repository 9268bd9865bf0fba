#include "model/report/comparison.h"

#include <algorithm>
#include <cmath>

#include "messages/report.h"
#include "model/results/display_units.h"

namespace remount::report {
namespace {

Message sensor_word(calibration::BodyFrame sensor) {
  return sensor == calibration::BodyFrame::Antenna ? say::compared_antenna() : say::compared_lidar();
}

/// Why the two cannot be set against each other; empty where they can.
Message not_comparable(const NamedResult& a, const NamedResult& b) {
  for (const NamedResult* result : {&a, &b})
    if (!calibration::is_usable(result->file.result)) return say::compared_not_usable(result->name);
  const calibration::Mounting &one = a.file.result.mounting, &other = b.file.result.mounting;
  if (one.reference != other.reference)
    return say::compared_other_frames(a.name, std::string(to_string(one.reference)), b.name,
                                      std::string(to_string(other.reference)));
  if (one.sensor != other.sensor)
    return say::compared_other_sensors(a.name, sensor_word(one.sensor), b.name, sensor_word(other.sensor));
  if (a.file.ins_axes && b.file.ins_axes && *a.file.ins_axes != *b.file.ins_axes)
    return say::compared_other_axes(a.name, b.name);
  return {};
}

/// Two methods, or settings, on the same files: in which nothing can have been moved.
bool of_one_recording(const results::ResultFile& a, const results::ResultFile& b) {
  return !a.inputs.empty() && std::equal(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end(),
                                         [](const results::InputFile& one, const results::InputFile& other) {
                                           return one.file == other.file && one.sha256 == other.sha256;
                                         });
}

Message in_words(const NamedResult& a, const NamedResult& b, const calibration::ResultDifference& difference,
                 const calibration::LargestDifference& largest) {
  const Message most = words_of_largest(difference, largest);
  if (!(largest.sigmas > calibration::kDiffer_sigma)) return say::compared_agree(a.name, b.name, most);
  return of_one_recording(a.file, b.file) ? say::compared_contradict_on_one_recording(a.name, b.name, most)
                                          : say::compared_contradict(a.name, b.name, most);
}

}  // namespace

Message words_of_largest(const calibration::ResultDifference& difference,
                         const calibration::LargestDifference& largest) {
  const calibration::Parameter parameter = largest.parameter;
  const double apart = std::abs(difference.difference[parameter]);
  return calibration::is_angle(parameter)
             ? say::compared_angle(calibration::parameter_word(parameter), Angle{apart}, largest.sigmas)
             : say::compared_length(calibration::parameter_word(parameter), Length{apart}, largest.sigmas);
}

std::vector<ComparedResults> compare_results(const std::vector<NamedResult>& results) {
  std::vector<ComparedResults> compared;
  for (std::size_t a = 0; a < results.size(); ++a)
    for (std::size_t b = a + 1; b < results.size(); ++b) {
      ComparedResults pair{a, b, {}, false, not_comparable(results[a], results[b])};
      pair.difference.difference.fill(std::nan(""));
      pair.difference.sigma.fill(std::nan(""));
      if (pair.words.empty()) {
        pair.difference = calibration::difference_of(results[a].file.result, results[b].file.result);
        const auto largest = calibration::largest_difference(pair.difference);
        pair.contradict = largest && largest->sigmas > calibration::kDiffer_sigma;
        pair.words = largest ? in_words(results[a], results[b], pair.difference, *largest)
                             : say::compared_nothing_in_common(results[a].name, results[b].name);
      } else {
        pair.words = say::compared_not(pair.words);
      }
      compared.push_back(std::move(pair));
    }
  return compared;
}

}  // namespace remount::report
