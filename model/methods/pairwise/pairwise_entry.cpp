// The entry of the method of pairs, whose stages are model/pipeline.
#include "algorithms/calibration/method_details.h"
#include "messages/drives.h"
#include "messages/methods.h"
#include "model/method_registry/calibration_method.h"
#include "model/method_registry/method_needs.h"

namespace remount {

extern const CalibrationMethod kPairwiseMethod;
PipelineOutput run_pipeline(const PipelineInput& input, Progress& progress);  // model/pipeline/pipeline.h

namespace {

Message lack_for_pairs(const Session& session, const GivenSessions&) {
  return !has_lidar(session) ? say::lacks_lidar() : !has_ins(session) ? say::lacks_ins() : Message();
}

}  // namespace

constinit const CalibrationMethod kPairwiseMethod{.id = kPairwise,
                                                  .title = say::method_title_pairwise,
                                                  .needs = say::needs_of_pairwise,
                                                  .lack = lack_for_pairs,
                                                  .from_pairs = true,
                                                  .run = solver(run_pipeline)};

}  // namespace remount
