// The calibration methods: one interface, one result type, one list.
#pragma once

#include <string_view>
#include <vector>

#include "model/pipeline/pipeline.h"

namespace remount {

/// A way to find where the LiDAR sits. All take sessions and settings and leave a PipelineOutput behind, so that
/// report, export, project and window need not know them; a method without pairs leaves those empty.
struct CalibrationMethod {
  std::string_view id;  ///< as on the command line and in files: "pairwise"
  Message title;        ///< for people: "Pairs of keyframes"
  Message needs;        ///< the streams a session must have, in words: those of model/settings/method_needs.h
  std::string_view settings_section;  ///< of Settings::visit_sections; empty where it has none of its own
  bool from_pairs = false;            ///< of keyframes, which are there to be reviewed
  /// Throws Error(Unsupported) where the sessions lack a stream, Error(Contract) for settings out of range. What the
  /// numbers do not allow is part of the result. Cancellable; the same for any number of threads.
  PipelineOutput (*run)(const PipelineInput& input, Progress& progress);
};

/// The methods built in, in the order of MethodChoice. Adding one: a file in this folder, a declaration in builtin.h, a
/// line in calibration_methods.cpp, what it needs in model/settings/method_needs.cpp, and its name in
/// model/settings/settings.h.
const std::vector<CalibrationMethod>& calibration_methods();

/// Throws Error(Contract) that names the methods where `id` is none of them.
const CalibrationMethod& calibration_method(std::string_view id);

/// False for a name that is none of theirs.
bool is_from_pairs(std::string_view id);

/// Whether any value is given that was measured by hand.
bool is_measured(const MeasuredOptions& measured);
/// Throws Error(Contract) where one is, for a method whose result is in the frame of something else than the INS.
void refuse_measured(const MeasuredOptions& measured, std::string_view method, const Message& frame);

/// Throws Error(Contract) for a nominal in another frame than that in which the method of the settings finds the LiDAR,
/// or outside the search range.
void check_nominal(const PipelineInput& input);
/// Status out_of_range for a result that could be used and lies outside the search range. What is not observed and has
/// no nominal is taken to the nearest bound first: nothing says that it lies where it was put.
void keep_in_range(const SearchRange& range, bool nominal_known, CalibrationResult& result);

/// What every method leaves to others, whoever ran it: the result is kept in range, and what was given and not used is
/// told.
void complete_output(const PipelineInput& input, PipelineOutput& output);

/// The method that the settings choose. Throws as it does, as check_nominal does, and Error(Io) where recordings are
/// gone at the end. No result lies outside the search range.
PipelineOutput calibrate(const PipelineInput& input, Progress& progress);

}  // namespace remount
