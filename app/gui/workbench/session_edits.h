// Sessions that a result may rest on come and go.
#pragma once

#include "app/gui/workbench/calibrations.h"

namespace remount::gui {

/// Removes sessions, and reads them with other topics. What was calibrated goes with a session that it rests on, and
/// comes back with it; where it does not rest on it, it stays or becomes smaller.
class SessionEdits : public WorkbenchPart {
  Q_OBJECT
 public:
  SessionEdits(const Desk& desk, SessionList& sessions, Setup& setup, Outcome& outcome, Decisions& decisions,
               Calibrations& calibrations);

  /// An edit that can be undone. What was calibrated goes with it where it rests on a pair of the session.
  void remove(motion::SessionIndex session);
  /// Reads what a session's recording offers; topics_listed follows.
  void list_topics(motion::SessionIndex session);
  /// Reads a session anew with other topics; an edit that can be undone. The result of its former topics goes with it.
  void choose_topics(motion::SessionIndex session, const drive::TopicChoice& choice);

  // Steps of undo commands; not undoable by themselves.
  /// Puts one session in the place of another; without `calibrated`, nothing is calibrated yet.
  void apply_exchange(const SessionPtr& from, const SessionPtr& to, const CalibratedPtr& calibrated);
  void apply_removal(const SessionPtr& session);
  /// `calibrated`: what apply_removal took away or made smaller; null where it did not.
  void apply_return(const SessionPtr& session, motion::SessionIndex place, const CalibratedPtr& calibrated);

 signals:
  /// What list_topics was asked for; `used_as` as the session has it.
  void topics_listed(motion::SessionIndex session, const std::vector<drive::OfferedTopic>& topics);

 private:
  bool may_choose_topics(motion::SessionIndex session);  ///< says why not
  void take_other_topics(const SessionPtr& from, const SessionPtr& to);
  CalibratedPtr calibrated_without(const drive::Session& session) const;  ///< null where the result rests on it

  SessionList& sessions_;
  Setup& setup_;
  Outcome& outcome_;
  Decisions& decisions_;
  Calibrations& calibrations_;
};

}  // namespace remount::gui
