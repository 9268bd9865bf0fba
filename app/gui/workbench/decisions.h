// What the user decided about pairs.
#pragma once

#include "app/gui/workbench/outcome.h"
#include "app/gui/workbench/session_list.h"
#include "model/pipeline/verdicts.h"
#include "widgets/basics/rows.h"

namespace remount::gui {

/// Of the sessions, by their numbers.
std::vector<pipeline::PairVerdict> verdicts_of(const std::vector<SessionPtr>& sessions, const KeptVerdicts& made);

/// The same, by which pairs are found again. @param paths of the sessions
KeptVerdicts kept_verdicts(const std::vector<std::filesystem::path>& paths,
                           const std::vector<pipeline::PairVerdict>& verdicts);

/// Holds the decisions, also those on pairs that the present output does not hold: another method has none. A decision
/// is an edit that can be undone; what it changes in the result is answered by whoever hears `applied`.
class Decisions : public WorkbenchPart {
  Q_OBJECT
 public:
  Decisions(const Desk& desk, SessionList& sessions, Outcome& outcome);

  /// `reason`: why, as the pair's own words; empty: by whom. `step`: the name of the edit; empty: which pairs.
  void decide(const std::vector<motion::PairIndex>& pairs, motion::PairState state, const Message& reason = {},
              const QString& step = {});
  /// The program judges these pairs again; an edit like a decision. Those that the user did not decide stay.
  void take_back(const std::vector<motion::PairIndex>& pairs);
  bool empty() const { return made_.empty(); }
  int count() const { return widgets::qt_count(verdicts().size()); }
  /// Of the sessions that are open, by their numbers.
  std::vector<pipeline::PairVerdict> verdicts() const;
  const KeptVerdicts& made() const { return made_; }
  /// Makes an output whose run began with other decisions obey those of now.
  void impose_on(pipeline::PipelineOutput& output) const;

  /// Step of an undo command; not undoable by itself.
  void apply(const std::vector<PairDecision>& decisions, const QString& step);

  void put(const KeptVerdicts& made) { made_ = made; }
  /// Those of a project, and those that its output holds.
  void put_saved(const std::vector<pipeline::PairVerdict>& verdicts);
  /// Scans are known by their stamps, which those of another topic may have as well.
  void forget_session(const drive::Session& session);

 signals:
  /// The output obeys, but for its result; `counts`: for that, too, not only for its words.
  void applied(const QString& step, bool counts);

 private:
  SessionList& sessions_;
  Outcome& outcome_;
  KeptVerdicts made_;
};

}  // namespace remount::gui
