// New solutions from the pairs that are there.
#pragma once

#include <functional>

#include "app/gui/workbench/decisions.h"
#include "app/gui/workbench/map_checks.h"
#include "app/gui/workbench/setup.h"

namespace remount::gui {

/// What a new solution from the pairs that are there takes over: the search range, and the solution's options but for
/// those that only a whole calibration obeys.
settings::Settings solved_again_with(const settings::Settings& of_pairs, const settings::Settings& now);

/// Answers every decision and every setting that needs no whole calibration: what can be said at once first, the whole
/// solution after it. The last edit counts: an answer to an earlier one is dropped.
class Solutions : public WorkbenchPart {
  Q_OBJECT
 public:
  Solutions(const Desk& desk, Setup& setup, Outcome& outcome, Decisions& decisions, MapChecks& map_checks);

  /// X of the output answers the last decision already; sigmas, candidates and the judgement of other pairs follow.
  bool refining() const { return desk_.activity.solving() && refining_; }
  /// The result does not answer every decision in full, and nothing under way will: the solution was cancelled or
  /// failed.
  bool incomplete() const { return !outcome_.whole() && !desk_.activity.solving(); }
  /// The pairs as they are, with the present search range and solution options.
  pipeline::PipelineInput input_of_next() const;

  void solve(const QString& step) { start(step, FirstAnswer::None); }
  /// What a calibration that came to nothing had stopped: the solution of the last decisions, or the map check.
  void resume();

 private:
  /// What is shown before the whole solution: how X moved by a decision, or the ranking in another search range.
  enum class FirstAnswer { None, Moved, Ranking };
  void answer_decisions(const QString& step, bool counts);
  void answer_settings(const QString& step);
  void start(const QString& step, FirstAnswer first);
  void name_step(const QString& step);
  /// On a worker.
  JobRunner::Deliver work(const struct SolveTask& task, const Engine& engine, FirstAnswer first, int turn,
                          Progress& progress);
  JobRunner::Deliver if_last(int turn, const std::function<void()>& take) const;
  /// Where all is decided and set as it was for the last whole calibration, its result is there again, the last steps
  /// included. False where it is not so.
  bool return_to_run(const QString& step);
  void take_ranking(OutputPtr answer);
  void take_first_answer(OutputPtr answer, OutputPtr before);
  void take_solution(OutputPtr solved, OutputPtr before, const settings::Settings& settings);

  Setup& setup_;
  Outcome& outcome_;
  Decisions& decisions_;
  MapChecks& map_checks_;
  QString solving_for_;  // the edits of the last solution or of the one under way
  bool refining_ = false;
};

}  // namespace remount::gui
