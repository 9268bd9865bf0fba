// Which pairs were looked at, and what was noted about them.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/workbench/outcome.h"
#include "app/gui/workbench/session_list.h"
#include "model/project/pair_note.h"
#include "widgets/pairs/pair_mark.h"

namespace remount::gui {

/// Holds them also for pairs that the present output does not hold. Flags and comments are edits of the project; that a
/// pair was looked at is saved with it, and is no reason to ask whether to save.
class ReviewNotes : public WorkbenchPart {
  Q_OBJECT
 public:
  ReviewNotes(const Desk& desk, SessionList& sessions, Outcome& outcome);

  /// Of each pair of the output.
  widgets::PairMarksPtr marks() const;
  int seen() const;
  void mark_seen(motion::PairIndex pair);
  /// All of them, or none where all are flagged already.
  void flip_flags(const std::vector<motion::PairIndex>& pairs);
  void comment(const std::vector<motion::PairIndex>& pairs, const QString& text);

  /// Of the sessions that are open, by their numbers.
  std::vector<project::PairNote> saved() const;
  void put_saved(const std::vector<project::PairNote>& notes);

 signals:
  void changed();

 private:
  struct Key {
    std::string session, lidar;
    std::int64_t stamp_a_ns = 0, stamp_b_ns = 0;
    auto operator<=>(const Key&) const = default;
  };
  Key key_of(motion::PairIndex pair) const;
  void find_marks();
  void change(const std::vector<motion::PairIndex>& pairs, const std::function<void(widgets::PairMark&)>& change);

  SessionList& sessions_;
  Outcome& outcome_;
  std::map<Key, widgets::PairMark> notes_;
  OutputPtr marked_;  // of which these are the marks
  std::shared_ptr<std::vector<widgets::PairMark>> marks_;
};

}  // namespace remount::gui
