#include "app/gui/features/map_controller.h"

#include <QLocale>

#include "app/gui/jobs/error_words.h"
#include "app/gui/workbench/wording.h"
#include "messages/stages.h"
#include "model/results/result_file.h"
#include "widgets/basics/rows.h"
#include "widgets/text/model_text.h"
#include "widgets/text/sentences.h"

namespace remount::gui {
namespace {

bool same_scans(const std::vector<motion::Keyframe>& first, const std::vector<motion::Keyframe>& second) {
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const motion::Keyframe& a, const motion::Keyframe& b) {
                      return a.session == b.session && a.scan == b.scan && a.stamp_ns == b.stamp_ns;
                    });
}

bool same_x(const std::optional<RigidTransform>& first, const RigidTransform& second) {
  return first && difference(*first, second).norm() < 1e-9;
}

}  // namespace

MapController::MapController(Workbench& workbench, widgets::MapView& view, QObject* parent)
    : QObject(parent), workbench_(workbench), view_(view) {
  connect(&view_, &widgets::MapView::map_wanted, this, [this] {
    cancelled_ = false;
    make_map();
  });
  // At once, and not when the map's turn comes: what the user cancels until then stays cancelled.
  connect(&workbench_.outcome(), &Outcome::changed, this, [this] {
    candidate_.reset();
    cancelled_ = false;
  });
  connect(&view_, &widgets::MapView::cancel_clicked, this, [this] {
    cancelled_ = true;
    jobs_.cancel(job_);
  });
  connect(&jobs_, &JobRunner::progressed, this,
          [this](int job, const Message& stage, qulonglong done, qulonglong total) {
            if (job == job_) view_.show_progress(stage, done, total);
          });
}

void MapController::show_candidate(std::optional<calibration::CandidateIndex> candidate) {
  candidate_ = candidate;
  offer();
}

void MapController::refresh() { offer(); }

void MapController::say(const QString& text) {
  made_.ins_from_lidar.reset();
  view_.show_message(text);
  view_.allow_choice();
}

QStringList MapController::session_names() const {
  // Those of the calibration: sessions that were opened since then have no keyframes in it.
  return names_of(workbench_.outcome().input().sessions);
}

void MapController::give_up() {
  jobs_.cancel(job_);
  job_ = 0;
}

void MapController::offer() {
  const OutputPtr output = workbench_.outcome().output();
  if (!output) {
    give_up();
    made_ = {};
    view_.show_choices({}, tr("Start"), {});
    view_.show_message(
        tr("The scans of a session, put together under one mounting, are shown here after a calibration."));
    return;
  }
  if (candidate_ && *candidate_ >= output->result.candidates.size()) candidate_.reset();
  view_.show_choices(session_names(), output->nominal_known ? tr("Nominal") : tr("Start"),
                     !candidate_ ? QString() : tr("Candidate %1").arg(*candidate_ + 1));
  make_map();
}

std::optional<RigidTransform> MapController::chosen_ins_from_lidar() const {
  const pipeline::PipelineOutput& output = *workbench_.outcome().output();
  if (view_.chosen_x() == widgets::MapX::Nominal) return output.initial_ins_from_lidar;
  if (view_.chosen_x() == widgets::MapX::Candidate && candidate_)
    return output.result.candidates.at(*candidate_).ins_from_lidar;
  if (!calibration::is_usable(output.result) ||
      !output.result.mounting.is_of({calibration::BodyFrame::Ins, calibration::BodyFrame::Lidar}))
    return std::nullopt;
  return output.result.mounting.ins_from_lidar();
}

bool MapController::scans_are_current() const {
  const pipeline::PipelineOutput& output = *workbench_.outcome().output();
  return made_.scans && made_.session == view_.chosen_session() &&
         made_.offset_applied == output.result.time_offset.applied && same_scans(made_.keyframes, output.keyframes);
}

void MapController::make_map() {
  if (!view_.isVisible() || !view_.has_gl() || !workbench_.outcome().output() || workbench_.activity().calibrating() ||
      cancelled_)
    return;
  if (!workbench_.engine().load_map_scans) return;
  const auto ins_from_lidar = chosen_ins_from_lidar();
  if (!ins_from_lidar) {
    give_up();
    return say(tr("There is no result to put the scans together with. Choose another mounting above."));
  }
  if (working()) {
    if (same_x(making_.ins_from_lidar, *ins_from_lidar) && making_.session == view_.chosen_session() &&
        same_scans(making_.keyframes, workbench_.outcome().output()->keyframes))
      return;
    jobs_.cancel(job_);
  } else if (scans_are_current() && same_x(made_.ins_from_lidar, *ins_from_lidar)) {
    return;
  }
  start(*ins_from_lidar);
}

void MapController::start(const RigidTransform& ins_from_lidar) {
  const OutputPtr output = workbench_.outcome().output();
  const auto scans = scans_are_current() ? made_.scans : nullptr;
  making_ = {output->keyframes, output->result.time_offset.applied, view_.chosen_session(), scans, ins_from_lidar};
  auto job = std::make_shared<int>(0);
  job_ = jobs_.start(
      [this, job, scans, ins_from_lidar, output, input = workbench_.outcome().input(), session = making_.session,
       load = workbench_.engine().load_map_scans](Progress& progress) -> JobRunner::Deliver {
        auto loaded = scans;
        if (!loaded)
          loaded = std::make_shared<const pipeline::SessionScans>(load(input, *output, session, kMostPoints, progress));
        progress.report(say::stage_putting_the_scans_together, 0, 0);
        scene::MapSceneDataPtr data = scene::prepare_map_scene(loaded->scans, ins_from_lidar, progress);
        return [this, job, loaded, data, ins_from_lidar] {
          if (*job == job_) take(loaded, data, ins_from_lidar);
        };
      },
      [this, job](const JobFailure& failure) {
        if (*job == job_) say(in_words(failure));
      });
  *job = job_;
  view_.show_progress(say::stage_putting_the_scans_together(), 0, 0);
}

void MapController::take(const std::shared_ptr<const pipeline::SessionScans>& scans, const scene::MapSceneDataPtr& data,
                         const RigidTransform& ins_from_lidar) {
  if (!data) {
    if (!cancelled_) return;
    say(tr("Cancelled."));
    return view_.offer_again();
  }
  made_ = making_;
  made_.scans = scans;
  made_.ins_from_lidar = ins_from_lidar;
  if (scene::facts_of(*data).points == 0) return say(tr("This session has no scans to put together."));
  view_.show_map(caption(), data);
}

QString MapController::caption() const {
  const QLocale locale;
  const QStringList names = session_names();
  const QString x =
      view_.chosen_x() == widgets::MapX::Nominal
          ? (workbench_.outcome().output()->nominal_known ? tr("the nominal mounting")
                                                          : tr("the mounting that the calibration started from"))
      : view_.chosen_x() == widgets::MapX::Candidate ? tr("candidate %1").arg(widgets::qt_row(candidate_) + 1)
                                                     : tr("the result");
  const std::size_t scans = made_.scans->scans.points_in_lidar.size();
  QStringList text{tr("%1: %2 scans under %3.").arg(names.value(widgets::qt_row(made_.session))).arg(scans).arg(x)};
  if (made_.scans->unreadable > 0)
    text << tr("%1 cannot be read (%2).")
                .arg(made_.scans->unreadable)
                .arg(widgets::model_text(made_.scans->first_failure));
  std::size_t kept = 0;
  for (const auto& points : made_.scans->scans.points_in_lidar) kept += points.size();
  if (kept < made_.scans->points_recorded)
    text << tr("Thinned from %1 points.").arg(locale.toString(static_cast<qulonglong>(made_.scans->points_recorded)));
  return widgets::one_text(text);
}

}  // namespace remount::gui
