// Runs the chosen calibration method, and does what all methods leave to others.
#pragma once

#include <string_view>

#include "model/method_registry/calibration_method.h"
#include "model/pipeline/pipeline.h"

namespace remount::methods {

/// Whether any value is given that was measured by hand.
bool is_measured(const calibration::MeasuredOptions& measured);
/// Throws Error(Contract) where one is, for a method whose result is in the frame of something else than the INS.
void refuse_measured(const calibration::MeasuredOptions& measured, std::string_view method, const Message& frame);

/// Throws Error(Contract) for a nominal in another frame than that in which the method of the settings finds the LiDAR,
/// or outside the search range.
void check_nominal(const pipeline::PipelineInput& input);
/// Status out_of_range for a result that could be used and lies outside the search range. What is not observed and has
/// no nominal is taken to the nearest bound first: nothing says that it lies where it was put.
void keep_in_range(const calibration::SearchRange& range, bool nominal_known, calibration::CalibrationResult& result);

/// What every method leaves to others, whoever ran it: the result is kept in range, and what was given and not used is
/// told.
void complete_output(const pipeline::PipelineInput& input, pipeline::PipelineOutput& output);

/// The method that the settings choose. Throws as it does, as check_nominal does, and Error(Io) where recordings are
/// gone at the end. No result lies outside the search range.
pipeline::PipelineOutput calibrate(const pipeline::PipelineInput& input, Progress& progress);

}  // namespace remount::methods
