#include "model/pipeline/keep_finished.h"

#include <algorithm>

#include "algorithms/motion/pair.h"
#include "messages/pairs.h"
#include "messages/pipeline.h"
#include "messages/places.h"
#include "model/results/preliminary.h"
#include "model/results/result_file.h"

namespace remount::pipeline {
namespace {

constexpr const char* kCancelled = "cancelled";  // code of the finding

bool is_aligned(const motion::Pair& pair) {
  return pair.registration.attempted && motion::unusable_reason(pair).empty();
}

// A registration that was interrupted, or never begun.
bool not_reached(const motion::Pair& pair) {
  return !pair.registration.attempted || motion::is_cancelled(pair.registration);
}

// What a whole calibration would have done besides.
std::vector<Message> missing_steps(const PipelineInput& input, const PipelineOutput& output) {
  std::vector<Message> steps{say::pipeline_aligning_all_clouds()};
  if (input.settings.measured.ins_height_sigma_m > 0.0 && !output.ground)
    steps.push_back(say::pipeline_given_ins_height());
  return steps;
}

}  // namespace

std::size_t keep_finished(const PipelineInput& input, PipelineOutput& output) {
  const auto finished = static_cast<std::size_t>(std::count_if(output.pairs.begin(), output.pairs.end(), is_aligned));
  if (finished == 0 || input.settings.solve.apply_time_offset == calibration::ClockOffsetUse::Yes) return 0;
  for (motion::Pair& pair : output.pairs) {
    if (pair.decided_by == motion::DecidedBy::User) continue;
    if (is_aligned(pair)) {
      pair.state = motion::PairState::Proposed;
      pair.decided_by = motion::DecidedBy::Nobody;
      pair.reason = {};
    } else if (not_reached(pair) && (pair.state != motion::PairState::Rejected || pair.registration.attempted)) {
      pair.state = motion::PairState::Rejected;
      pair.decided_by = motion::DecidedBy::Program;
      pair.reason = say::pair_not_reached();
      if (pair.registration.attempted) pair.registration.failure = pair.reason;
    }
  }
  output.findings.push_back({drive::Severity::Warning, kCancelled, say::place_calibration(),
                             say::pipeline_cut_short(finished, output.pairs.size(), missing_steps(input, output))});
  return finished;
}

void mark_if_cut_short(PipelineOutput& output) {
  const bool cut_short = std::any_of(output.findings.begin(), output.findings.end(),
                                     [](const drive::Finding& finding) { return finding.code == kCancelled; });
  if (cut_short && calibration::is_usable(output.result)) results::mark_preliminary(output.result);
}

}  // namespace remount::pipeline
