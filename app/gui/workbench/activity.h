// Which long work is under way.
#pragma once

#include <QObject>
#include <array>

#include "algorithms/core/index.h"
#include "app/gui/jobs/job_runner.h"

namespace remount::gui {

/// Holds the last job of each kind that the whole window waits for or shows. A later one takes the place of the one
/// before, which is asked to stop by whoever starts it and whose answer is to be dropped (is_last).
class Activity : public QObject {
  Q_OBJECT
 public:
  enum class Kind { Opening, Calibrating, Solving, CheckingMap };
  static constexpr std::size_t kKinds = 4;

  explicit Activity(JobRunner& jobs);

  bool running(Kind kind) const { return jobs_.running(entry(kind).job); }
  bool opening() const { return running(Kind::Opening); }
  bool calibrating() const { return running(Kind::Calibrating); }
  bool solving() const { return running(Kind::Solving); }
  const Message& stage() const { return stage_; }  ///< of the running calibration
  /// What the running calibration says of X before its end; empty where it has said nothing yet.
  const Message& so_far() const { return so_far_; }
  void take_so_far(const Message& x);

  void start(Kind kind, JobRunner::Work work, JobRunner::Failed failed);
  void cancel(Kind kind);  ///< asks: it runs until it notices
  void drop(Kind kind);    ///< asks, and does not count it as running any more; its answer is not wanted
  /// The turn that the next of a kind has; for is_last.
  int next_turn(Kind kind) const { return entry(kind).turn + 1; }
  bool is_last(Kind kind, int turn) const { return entry(kind).turn == turn; }

 signals:
  void changed();  ///< a job of any kind started or ended, or the calibration is at another stage
  void opening_ended();
  void progressed(const Message& stage, qulonglong done, qulonglong total);  ///< of opening and calibrating

 private:
  struct Entry {
    int job = 0, turn = 0;
  };
  Entry& entry(Kind kind) { return entries_[index_of(kind)]; }
  const Entry& entry(Kind kind) const { return entries_[index_of(kind)]; }
  void take_progress(int job, const Message& stage, qulonglong done, qulonglong total);
  void take_end(int job);

  JobRunner& jobs_;
  std::array<Entry, kKinds> entries_;
  Message stage_, so_far_;
};

}  // namespace remount::gui
