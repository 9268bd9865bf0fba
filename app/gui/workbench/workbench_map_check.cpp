// The map check of a new X, in the background.
#include "app/gui/jobs/error_words.h"
#include "app/gui/workbench/workbench.h"
#include "model/pipeline/sharpness_stage.h"
#include "widgets/text/model_text.h"

namespace remount {
namespace {
constexpr int kPause_ms = 800;  // it reads scans: whoever decides on does not wait for them
}  // namespace

void Workbench::check_map_soon() {
  jobs_.cancel(map_job_);
  map_job_ = 0;
  map_pause_.stop();
  map_failure_.clear();
  if (!output_ || output_ != output_solved_ || !engine_.check_map || !run_input_.settings.run.map_check) return;
  const bool missing = output_->map_check == MapCheck::Moved || output_->map_check == MapCheck::NotReached;
  if (missing && is_usable(output_->result)) map_pause_.start(kPause_ms);
}

void Workbench::check_map_again() {
  if (!output_ || output_ != output_solved_ || solving() || calibrating()) return;
  auto job = std::make_shared<int>(0);
  map_job_ = jobs_.start(
      [this, job, input = run_input_, output = output_,
       check = engine_.check_map](Progress& progress) -> JobRunner::Deliver {
        auto checked = std::make_shared<PipelineOutput>(*output);
        check(input, *checked, progress);
        if (progress.cancelled()) return {};
        return [this, job, output, checked] {
          if (*job != map_job_ || output != output_) return;
          // No edit: a project that was saved before is checked again when it is opened.
          output_ = output_solved_ = checked;
          if (whole_run_ && whole_run_->output == output) whole_run_->output = checked;
          for (const Finding& finding : checked->findings)
            if (finding.code == kMapLessSharp) {
              confirmed_ = false;  // it was, without this
              emit message(finding.severity, model_text(finding.where.words()), model_text(finding.explanation));
            }
          emit output_changed();
          emit state_changed();
        };
      },
      [this, job](const JobFailure& failure) {
        if (*job != map_job_) return;
        map_failure_ = in_words(failure);
        emit message(Severity::Problem, failure.where, failure.what);
        emit state_changed();
      });
  *job = map_job_;
  emit state_changed();
}

}  // namespace remount
