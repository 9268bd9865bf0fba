#include "app/gui/workbench/map_checks.h"

#include <algorithm>

#include "app/gui/jobs/error_words.h"
#include "model/pipeline/sharpness_stage.h"
#include "widgets/text/model_text.h"

namespace remount::gui {
namespace {
constexpr int kPause_ms = 800;  // it reads scans: whoever decides on does not wait for them
}  // namespace

MapChecks::MapChecks(const Desk& desk, Outcome& outcome) : WorkbenchPart(desk), outcome_(outcome) {
  connect(&pause_, &QTimer::timeout, this, &MapChecks::begin);
  pause_.setSingleShot(true);
}

void MapChecks::stop() {
  desk_.activity.cancel(Activity::Kind::CheckingMap);
  pause_.stop();
}

void MapChecks::begin_soon() {
  desk_.activity.drop(Activity::Kind::CheckingMap);
  pause_.stop();
  failure_.clear();
  const OutputPtr output = outcome_.output();
  if (!output || !outcome_.whole() || !desk_.engine.check_map || !outcome_.input().settings.run.map_check) return;
  const bool missing =
      output->map_check == pipeline::MapCheck::Moved || output->map_check == pipeline::MapCheck::NotReached;
  if (missing && calibration::is_usable(output->result)) pause_.start(kPause_ms);
}

void MapChecks::begin() {
  if (!outcome_.output() || !outcome_.whole() || desk_.activity.solving() || desk_.activity.calibrating()) return;
  const int turn = desk_.activity.next_turn(Activity::Kind::CheckingMap);
  const auto is_last = [this, turn] { return desk_.activity.is_last(Activity::Kind::CheckingMap, turn); };
  desk_.activity.start(
      Activity::Kind::CheckingMap,
      [this, is_last, input = outcome_.input(), output = outcome_.output(),
       check = desk_.engine.check_map](Progress& progress) -> JobRunner::Deliver {
        auto checked = std::make_shared<pipeline::PipelineOutput>(*output);
        check(input, *checked, progress);
        if (progress.cancelled()) return {};
        return [this, is_last, output, checked] {
          if (is_last() && output == outcome_.output()) take(checked);
        };
      },
      [this, is_last](const JobFailure& failure) {
        if (!is_last()) return;
        failure_ = in_words(failure);
        desk_.notices.say(drive::Severity::Problem, failure.where, failure.what);
        emit state_changed();
      });
}

void MapChecks::take(const OutputPtr& checked) {
  const auto doubts = [](const drive::Finding& finding) { return finding.code == pipeline::kMapLessSharp; };
  // No edit: a project that was saved before is checked again when it is opened.
  outcome_.take_map_check(checked, std::any_of(checked->findings.begin(), checked->findings.end(), doubts));
  for (const drive::Finding& finding : checked->findings)
    if (doubts(finding))
      desk_.notices.say(finding.severity, widgets::model_text(finding.where.words()),
                        widgets::model_text(finding.explanation));
  outcome_.announce();
  emit state_changed();
}

}  // namespace remount::gui
