#include "app/gui/quality_controller.h"

#include <algorithm>

#include "widgets/panels/hold_out_view.h"
#include "widgets/panels/map_view.h"
#include "widgets/panels/quality_view.h"
#include "widgets/panels/sharpness_view.h"

namespace remount {
namespace {

QString in_words(const JobFailure& failure) {
  return failure.where.isEmpty() ? failure.what : failure.where + QStringLiteral(": ") + failure.what;
}

/// Of the sessions that were calibrated; others may be open by now.
QStringList session_names(const PipelineInput& input) {
  QStringList names;
  for (const auto& session : input.sessions) names << QString::fromStdString(session->name);
  return names;
}

}  // namespace

QualityController::QualityController(Workbench& workbench, QualityView& view, QObject* parent)
    : QObject(parent), workbench_(workbench), view_(view) {
  connect(&view_, &QualityView::looked_at, this, &QualityController::refresh);
  connect(&workbench_, &Workbench::state_changed, this, &QualityController::refresh);
  connect(view_.sharpness(), &SharpnessView::map_requested, this, &QualityController::map_requested);
}

void QualityController::refresh() {
  refresh_sharpness();
  refresh_hold_out();
}

void QualityController::refresh_sharpness() {
  const OutputPtr output = workbench_.output();
  SharpnessView& view = *view_.sharpness();
  view.offer_maps(output && is_usable(output->result), output && !output->nominal_known ? tr("start") : QString());
  const bool shown = output && output == sharpness_of_;
  sharpness_of_ = output;
  if (!output) return view.show_message(tr("After a calibration the sharpness of the map is compared here."));
  if (output->sharpness.empty()) return view.show_message(why_no_sharpness(*output));
  if (!shown) view.show_sharpness(output->sharpness);
}

QString QualityController::why_no_sharpness(const PipelineOutput& output) const {
  const PipelineInput& input = workbench_.input_of_output();
  const bool any_scans = std::any_of(input.sessions.begin(), input.sessions.end(),
                                     [](const auto& session) { return session->scans != nullptr; });
  if (!any_scans) return tr("Not compared: the sessions hold LiDAR poses and no scans.");
  if (!is_usable(output.result)) return tr("Not compared: there is no result to use.");
  if (!input.settings.run.map_check) return tr("Not compared: the map check is switched off in the options (run).");
  if (!workbench_.moved_by().isEmpty())
    return tr("Not compared since the last decision, which moved X. Calibrate again (F5).");
  return tr("Not compared: no stretch of eight scans that follow each other turns and overlaps.");
}

void QualityController::refresh_hold_out() {
  const OutputPtr output = workbench_.output();
  HoldOutView& view = *view_.hold_out();
  if (!output || workbench_.input_of_output().sessions.size() < 2) {
    jobs_.cancel(hold_out_job_);
    hold_out_job_ = 0;
    hold_out_of_.reset();
    return view.show_message(output ? tr("Needs a second session: X is solved on one and scored on the other.")
                                    : tr("After a calibration of two or more sessions they are compared here."));
  }
  // A solution under way replaces the output soon.
  const bool settled = !workbench_.calibrating() && !workbench_.solving();
  if (output != hold_out_of_ && settled && view.isVisible() && workbench_.engine().check_hold_out)
    start_hold_out(output);
}

void QualityController::start_hold_out(const OutputPtr& output) {
  jobs_.cancel(hold_out_job_);
  hold_out_of_ = output;
  view_.hold_out()->show_message(tr("Solving every session alone…"));
  auto job = std::make_shared<int>(0);
  hold_out_job_ = jobs_.start(
      [this, job, output, input = workbench_.input_of_output(), names = session_names(workbench_.input_of_output()),
       check = workbench_.engine().check_hold_out](Progress& progress) -> JobRunner::Deliver {
        const auto found = std::make_shared<const HoldOut>(check(input, *output, progress));
        return [this, job, found, names] {
          if (*job == hold_out_job_) view_.hold_out()->show_hold_out(*found, names);
        };
      },
      [this, job](const JobFailure& failure) {
        if (*job == hold_out_job_) view_.hold_out()->show_message(in_words(failure));
      });
  *job = hold_out_job_;
}

}  // namespace remount
