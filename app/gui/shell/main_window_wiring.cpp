#include <QAction>
#include <QDockWidget>
#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableView>

#include "app/gui/basics/remembering.h"
#include "app/gui/basics/turn_queue.h"
#include "app/gui/document/project_keeper.h"
#include "app/gui/document/report_maker.h"
#include "app/gui/features/map_controller.h"
#include "app/gui/features/method_controller.h"
#include "app/gui/features/quality_controller.h"
#include "app/gui/features/scene_controller.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/workbench/steps.h"
#include "app/gui/workbench/wording.h"
#include "model/results/result_words.h"
#include "widgets/basics/theme.h"
#include "widgets/map/map_view.h"
#include "widgets/map/path_view.h"
#include "widgets/pairs/error_chart_panel.h"
#include "widgets/pairs/pair_table_model.h"
#include "widgets/pairs/pair_view.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/quality/quality_view.h"
#include "widgets/result/candidate_table_model.h"
#include "widgets/result/candidates_panel.h"
#include "widgets/result/comparison_view.h"
#include "widgets/result/nominal_panel.h"
#include "widgets/result/range_panel.h"
#include "widgets/result/result_panel.h"
#include "widgets/sessions/drive_panel.h"
#include "widgets/sessions/session_list_model.h"
#include "widgets/sessions/sessions_panel.h"
#include "widgets/shell/log_panel.h"
#include "widgets/shell/message_banner.h"
#include "widgets/shell/progress_strip.h"
#include "widgets/shell/welcome_panel.h"
#include "widgets/text/pair_reasons.h"

namespace remount {
namespace {
const QString kScale = QStringLiteral("view/distance-scale-m");
}  // namespace

void MainWindow::connect_intents() {
  connect(steps_, &StepBar::step_clicked, this, &MainWindow::go_to_step);
  welcome_->set_open_menu(*open_menu_);
  connect(welcome_, &WelcomePanel::sample_requested, this, &MainWindow::open_sample);
  connect(welcome_, &WelcomePanel::recent_requested, this, [this](const QString& path) { open_paths({path}); });
  const auto show_recent = [this] { welcome_->show_recent(keeper_->recent().paths(), keeper_->recent().labels()); };
  connect(keeper_, &ProjectKeeper::recent_changed, this, show_recent);
  show_recent();
  sessions_->set_open_menu(*open_menu_);
  connect(sessions_, &SessionsPanel::remove_requested, &workbench_.session_edits(), &SessionEdits::remove);
  connect(sessions_, &SessionsPanel::topics_requested, &workbench_.session_edits(), &SessionEdits::list_topics);
  connect(nominal_, &NominalPanel::nominal_edited, &workbench_.setup(), &Setup::edit_nominal);
  connect(nominal_, &NominalPanel::file_requested, this, &MainWindow::ask_for_nominal);
  connect(range_, &RangePanel::edited, &workbench_.setup(), &Setup::edit_option);
  connect(range_, &RangePanel::angle_unit_chosen, this, &MainWindow::set_angle_unit);
  connect(range_, &RangePanel::reset_requested, &workbench_.setup(), &Setup::reset_range);
  connect(pairs_, &PairsPanel::pair_selected, &workbench_.selection(), &Selection::select);
  connect(pairs_, &PairsPanel::accept_clicked, this, [this] { decide(PairState::Accepted); });
  connect(pairs_, &PairsPanel::reject_clicked, this, [this] { decide(PairState::Rejected); });
  connect(pairs_, &PairsPanel::shown_changed, errors_,
          [this] { errors_->chart()->show_pairs(pairs_->filter()->pairs()); });
  connect(errors_, &ErrorChartPanel::measure_changed, pairs_, &PairsPanel::set_measure);
  connect(errors_, &ErrorChartPanel::reject_requested, this, &MainWindow::reject_above);
  connect(drive_, &DrivePanel::pair_selected, &workbench_.selection(), &Selection::select);
  connect(errors_->chart(), &ErrorBarChart::pair_clicked, &workbench_.selection(), &Selection::select);
  connect(result_, &ResultPanel::copy_requested, this, &MainWindow::copy_result);
  connect(result_, &ResultPanel::export_requested, this, &MainWindow::show_export);
  connect(result_, &ResultPanel::clock_offset_asked, &workbench_.setup(), &Setup::use_clock_offset);
  connect(progress_, &ProgressStrip::cancel_clicked, &workbench_, &Workbench::cancel);
  connect(run_, &QPushButton::clicked, &workbench_.calibrations(), &Calibrations::calibrate);
  connect(cancel_, &QAction::triggered, progress_, [this] {
    if (was_busy_) progress_->show_cancelling();
  });
  connect(progress_, &ProgressStrip::cancel_clicked, progress_, &ProgressStrip::show_cancelling);
}

void MainWindow::connect_state() {
  make_controllers();
  connect(&workbench_.sessions(), &SessionList::changed, this, &MainWindow::show_sessions);
  connect(&workbench_.overviews(), &DriveOverviews::changed, this, [this] {
    drive_->show_drives(workbench_.sessions().names(), workbench_.overviews().all());
    session_model_->show_drives(workbench_.overviews().all());
  });
  connect(&workbench_.document(), &ProjectDocument::changed, this, &MainWindow::show_project);
  connect(&workbench_.document(), &ProjectDocument::replaced, nominal_, &NominalPanel::forget_numbers);
  connect(&workbench_.document(), &ProjectDocument::replaced, this, [this] {
    banner_->hide();
    note_at_end_.clear();
    idle_.clear();  // the strip speaks of the project before
  });
  connect(&workbench_.document(), &ProjectDocument::replaced, method_control_, &MethodController::clear_files);
  connect(&workbench_.setup(), &Setup::settings_changed, this, [this] {
    range_->show_settings(workbench_.setup().settings());
    candidates_->show_range(workbench_.setup().settings().range);
  });
  connect(&workbench_.setup(), &Setup::nominal_changed, this, [this] {
    const auto& nominal = workbench_.setup().nominal_ins_from_lidar();
    nominal_->show_nominal(nominal);
    range_->show_nominal(nominal);
    candidates_->show_nominal(nominal);
  });
  connect(&workbench_.outcome(), &Outcome::changed, this, &MainWindow::show_output);
  connect(&workbench_, &Workbench::state_changed, this, &MainWindow::show_state);
  connect(&workbench_.sessions(), &SessionList::found_below, this, &MainWindow::ask_for_sessions_below);
  connect(&workbench_.notices(), &Notices::message, this, &MainWindow::show_message);
  connect(&workbench_.notices(), &Notices::logged, log_, &LogPanel::add);
  connect(&workbench_.activity(), &Activity::progressed, progress_, &ProgressStrip::show_progress);
  connect_selection();
}

void MainWindow::make_controllers() {
  scenes_ = new SceneController(
      workbench_, *pair_view_, [this](int pair) { return pair_caption(pair); }, this);
  if (const QVariant scale = remembers() ? QSettings().value(kScale) : QVariant(); scale.isValid())
    pair_view_->set_scale(scale.toDouble());
  connect(pair_view_, &PairView::scale_changed, this, [](double limit_m) {
    if (remembers()) QSettings().setValue(kScale, limit_m);
  });
  maps_ = new MapController(workbench_, *map_view_, this);
  checks_ = new QualityController(workbench_, *quality_, this);
  method_control_ = new MethodController(workbench_, *method_chooser_, *method_, *paths_, *comparison_, this);
  connect(comparison_, &ComparisonView::add_requested, this, &MainWindow::ask_for_results);
  quality_->set_on_top(false);
  connect(quality_dock_, &QDockWidget::visibilityChanged, quality_, &QualityView::set_on_top);
  connect(quality_, &QualityView::confirmed, &workbench_.outcome(), &Outcome::confirm);
  connect(checks_, &QualityController::map_requested, this, [this](MapX x) {
    map_view_->choose(x);
    views_->setCurrentWidget(map_view_);
  });
  connect(candidates_, &CandidatesPanel::candidate_selected, this, [this](int candidate) {
    scenes_->show_candidate(candidate);
    maps_->show_candidate(scenes_->candidate());
  });
  connect(report_, &ReportMaker::progressed, this, &MainWindow::progress_text);
  connect(report_, &ReportMaker::finished, this, [this](const QString& html, const QString& pdf) {
    show_message(Severity::Note, html, tr("report saved, and as %1").arg(pdf));
  });
  connect(report_, &ReportMaker::failed, this,
          [this](const QString& where, const QString& what) { show_message(Severity::Problem, where, what); });
}

void MainWindow::connect_selection() {
  connect(&workbench_.selection(), &Selection::changed, this, [this](int pair) {
    pairs_->show_selected(pair);
    errors_->chart()->show_selected(pair);
    drive_->show_selected(pair);
    shown_clouds_ = nullptr;
    scenes_->forget_pair();
    obstacles_->setEnabled(false);
    if (pair < 0) pair_view_->show_message(no_pair_text(workbench_));
  });
  connect(&workbench_.selection(), &Selection::clouds_loading, this, [this](int pair) {
    const QString reading = tr("Reading the scans of pair %1…").arg(pair);
    progress_text(reading);
    if (!pair_view_->shows_scene()) pair_view_->show_message(reading);  // a scene stays until the next is there
  });
  connect(&workbench_.selection(), &Selection::clouds_loaded, this, &MainWindow::show_clouds);
  connect(&workbench_.selection(), &Selection::clouds_failed, this, [this](int pair, const QString& why) {
    pair_view_->show_message(tr("The scans of pair %1 cannot be shown.\n%2").arg(pair).arg(why));
    progress_text(idle_text(workbench_));
  });
}

void MainWindow::progress_text(const QString& text) {
  if (was_busy_) return;
  if (solving_since_.isValid() && text == idle_text(workbench_))
    progress_->wait(text, solving_since_);
  else
    progress_->stop(text);
}

void MainWindow::show_sessions() {
  session_model_->show_sessions(workbench_.sessions().all());
  session_model_->show_drives(workbench_.overviews().all());
  session_model_->show_use(workbench_.outcome().output(), workbench_.outcome().input().sessions.size());
}

void MainWindow::show_output() {
  const OutputPtr output = workbench_.outcome().output();
  // What the user asks and decides by is right at once; pictures and what lies behind follow in turns of their own, or
  // filling and painting everything in one would stall the window.
  pair_model_->show_output(output, workbench_.sessions().names());
  result_->show_output(output, workbench_.outcome().output_before(), workbench_.outcome().moved_by());
  show_state();
  turns_->start({[this] { pairs_->show_output(workbench_.outcome().output()); }, [this] { show_errors(); },
                 [this] {
                   session_model_->show_use(workbench_.outcome().output(),
                                            workbench_.outcome().input().sessions.size());
                   pairs_->show_selected(workbench_.selection().pair());
                   scenes_->refresh();
                 },
                 [this] {
                   drive_->show_output(workbench_.outcome().output());
                   drive_->show_selected(workbench_.selection().pair());
                 },
                 [this] { show_candidates(); }, [this] { maps_->refresh(); }, [this] { checks_->refresh(); }});
  if (!output) turns_->finish();  // its pairs and sessions may be gone
}

void MainWindow::show_everything() { turns_->finish(); }

void MainWindow::show_errors() {
  errors_->chart()->show_output(workbench_.outcome().output());
  errors_->chart()->show_pairs(pairs_->filter()->pairs());
  errors_->chart()->show_selected(workbench_.selection().pair());
}

void MainWindow::show_candidates() {
  const OutputPtr output = workbench_.outcome().output();
  candidate_model_->show_output(output);
  candidates_->show_output(output);
  range_->show_result(output && is_usable(output->result) ? std::optional(output->result.ins_from_lidar)
                                                          : std::nullopt);
}

void MainWindow::show_state() {
  const bool busy = workbench_.activity().opening() || workbench_.activity().calibrating();
  if (!workbench_.activity().solving())
    solving_since_.invalidate();
  else if (!solving_since_.isValid())
    solving_since_.start();
  if (busy && !was_busy_) {
    note_at_end_.clear();
    banner_->hide();  // what it says is answered by what was started
    progress_->start(workbench_.activity().opening() ? tr("Opening sessions…") : tr("Calibrating…"));
  }
  if (!busy && was_busy_) {
    was_busy_ = false;
    progress_text(note_at_end_.isEmpty() || workbench_.calibrations().out_of_date() ? idle_text(workbench_)
                                                                                    : note_at_end_);
    idle_ = idle_text(workbench_);
    if (workbench_.outcome().output()) pairs_->table()->setFocus();
  }
  was_busy_ = busy;
  if (const QString idle = idle_text(workbench_); !busy && idle != idle_) {
    idle_ = idle;
    progress_text(idle);
  }
  quality_->show_confirmed(workbench_.outcome().confirmed(),
                           workbench_.outcome().output() && is_usable(workbench_.outcome().output()->result) && !busy &&
                               !workbench_.activity().solving() && !workbench_.map_checks().checking() &&
                               !workbench_.calibrations().out_of_date());
  steps_->show_steps(describe_steps(workbench_));
  calibrate_->setEnabled(!busy);
  run_->setEnabled(!busy && !workbench_.sessions().all().empty());
  run_->setText(workbench_.activity().calibrating() ? tr("Calibrating…")
                : workbench_.outcome().output()     ? tr("Calibrate again (F5)")
                                                    : tr("Calibrate (F5)"));
  const bool nothing_yet = workbench_.sessions().all().empty() && !workbench_.activity().opening();
  centre_->setCurrentIndex(nothing_yet ? kWelcomePage : kPairPage);
  if (!workbench_.outcome().output()) pair_view_->show_message(next_hint(workbench_));
  cancel_->setEnabled(busy);
  const OutputPtr output = workbench_.outcome().output();
  export_->setEnabled(output && is_usable(output->result));
  make_report_->setEnabled(output != nullptr);
  copy_->setEnabled(output && has_mounting(output->result));
  use_as_nominal_->setEnabled(output && is_usable(output->result));
  obstacles_->setEnabled(output && is_usable(output->result) && shown_clouds_);
  for (QAction* review : review_actions_) review->setEnabled(output != nullptr);
  result_->show_standing(standing_of(workbench_), standing_note(workbench_), next_text(workbench_));
}

QString MainWindow::scan_name(int index) const {
  return remount::scan_name(workbench_.outcome().input().sessions,
                            workbench_.outcome().output()->keyframes.at(static_cast<std::size_t>(index)));
}

QString MainWindow::pair_caption(int pair) const {
  const OutputPtr output = workbench_.outcome().output();
  const Pair& chosen = output->pairs.at(static_cast<std::size_t>(pair));
  QString verdict = state_text(chosen);
  if (!chosen.reason.empty() && !tells_who_only(chosen.reason))
    verdict += QStringLiteral(": ") + reason_words(chosen.reason);
  return tr("Pair %1: %2 → %3, %4 m, %5°. %6")
      .arg(pair)
      .arg(scan_name(chosen.keyframe_a), scan_name(chosen.keyframe_b))
      .arg(chosen.baseline_m, 0, 'f', 2)
      .arg(radians_to_degrees(chosen.rotation_rad), 0, 'f', 2)
      .arg(verdict);
}

void MainWindow::show_clouds(int pair, const CloudsPtr& clouds) {
  const OutputPtr output = workbench_.outcome().output();
  if (!output || pair != workbench_.selection().pair()) return;
  shown_clouds_ = clouds;
  obstacles_->setEnabled(is_usable(output->result) && !clouds->objects_b.empty());
  if (clouds->cloud_a.size() == 0 && clouds->cloud_b.size() == 0) {
    pair_view_->show_message(tr("Pair %1 comes from LiDAR poses: there are no scans to show.").arg(pair));
  } else {
    scenes_->show_pair(pair, clouds);
  }
  progress_text(idle_text(workbench_));
}

void MainWindow::show_message(Severity severity, const QString& where, const QString& what) {
  if (what.isEmpty()) return;
  log_->add(severity, where, what);
  if (severity != Severity::Note) {
    banner_->show_message(severity, where, what);
    return;
  }
  note_at_end_ = where.isEmpty() ? what : where + QStringLiteral(": ") + what;
  progress_text(note_at_end_);
}

void MainWindow::set_palettes() {
  session_model_->set_palette(palette());
  pair_model_->set_palette(palette());
  candidate_model_->set_palette(palette());
}

}  // namespace remount
