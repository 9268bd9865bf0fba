// The entry of the method of pairs, whose stages are model/pipeline.
#include "algorithms/calibration/method_details.h"
#include "messages/drives.h"
#include "messages/methods.h"
#include "model/method_registry/calibration_method.h"
#include "model/method_registry/method_needs.h"

namespace remount::pipeline {
PipelineOutput run_pipeline(const PipelineInput& input, Progress& progress);  // model/pipeline/pipeline.h
}  // namespace remount::pipeline

namespace remount::methods {

extern const method_registry::CalibrationMethod kPairwiseMethod;

namespace {

Message lack_for_pairs(const drive::Session& session, const method_registry::GivenSessions&) {
  return !method_registry::has_lidar(session) ? say::lacks_lidar()
         : !method_registry::has_ins(session) ? say::lacks_ins()
                                              : Message();
}

}  // namespace

constinit const method_registry::CalibrationMethod kPairwiseMethod{
    .id = calibration::kPairwise,
    .title = say::method_title_pairwise,
    .needs = say::needs_of_pairwise,
    .lack = lack_for_pairs,
    .from_pairs = true,
    .run = method_registry::solver(pipeline::run_pipeline)};

}  // namespace remount::methods
