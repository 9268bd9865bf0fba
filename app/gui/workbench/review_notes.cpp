#include "app/gui/workbench/review_notes.h"

#include <algorithm>

#include "app/gui/workbench/vehicle_jobs.h"
#include "widgets/basics/rows.h"

namespace remount::gui {
ReviewNotes::ReviewNotes(const Desk& desk, SessionList& sessions, Outcome& outcome)
    : WorkbenchPart(desk), sessions_(sessions), outcome_(outcome) {
  connect(&outcome_, &Outcome::changed, this, &ReviewNotes::find_marks);
}

ReviewNotes::Key ReviewNotes::key_of(motion::PairIndex pair) const {
  const pipeline::PipelineOutput& output = *outcome_.output();
  const motion::Keyframe& a = output.keyframes.at(output.pairs.at(pair).keyframe_a);
  const motion::Keyframe& b = output.keyframes.at(output.pairs.at(pair).keyframe_b);
  const drive::Session& session = *outcome_.input().sessions.at(a.session);
  return {session.path.string(), lidar_of(session), a.stamp_ns, b.stamp_ns};
}

/// Looked up once for an output: a pair is asked for whenever a row is drawn.
void ReviewNotes::find_marks() {
  const OutputPtr output = outcome_.output();
  if (output == marked_) return;
  marked_ = output;
  marks_ = std::make_shared<std::vector<widgets::PairMark>>(output ? output->pairs.size() : 0);
  for (motion::PairIndex pair; output && !notes_.empty() && pair < output->pairs.size(); ++pair)
    if (const auto found = notes_.find(key_of(pair)); found != notes_.end()) (*marks_)[pair] = found->second;
  emit changed();
}

widgets::PairMarksPtr ReviewNotes::marks() const { return marks_; }

int ReviewNotes::seen() const {
  return !marks_ ? 0
                 : static_cast<int>(std::count_if(marks_->begin(), marks_->end(),
                                                  [](const widgets::PairMark& mark) { return mark.seen; }));
}

void ReviewNotes::change(const std::vector<motion::PairIndex>& pairs,
                         const std::function<void(widgets::PairMark&)>& change) {
  find_marks();
  for (const motion::PairIndex pair : pairs) {
    if (!marks_ || pair >= marks_->size()) continue;
    widgets::PairMark& mark = notes_[key_of(pair)];
    change(mark);
    (*marks_)[pair] = mark;
  }
  emit changed();
}

void ReviewNotes::mark_seen(motion::PairIndex pair) {
  find_marks();
  if (!marks_ || pair >= marks_->size() || (*marks_)[pair].seen) return;
  change({pair}, [](widgets::PairMark& mark) { mark.seen = true; });
}

void ReviewNotes::flip_flags(const std::vector<motion::PairIndex>& pairs) {
  find_marks();
  const bool all = std::all_of(pairs.begin(), pairs.end(), [&](motion::PairIndex pair) {
    return marks_ && pair < marks_->size() && (*marks_)[pair].flagged;
  });
  change(pairs, [all](widgets::PairMark& mark) { mark.flagged = !all; });
  emit edited();
}

void ReviewNotes::comment(const std::vector<motion::PairIndex>& pairs, const QString& text) {
  change(pairs, [&](widgets::PairMark& mark) { mark.comment = text.trimmed(); });
  emit edited();
}

std::vector<project::PairNote> ReviewNotes::saved() const {
  std::vector<project::PairNote> saved;
  const std::vector<SessionPtr>& sessions = sessions_.all();
  for (const auto& one : notes_) {
    const Key& key = one.first;
    const widgets::PairMark& mark = one.second;
    const auto of = std::find_if(sessions.begin(), sessions.end(),
                                 [&](const SessionPtr& session) { return session->path.string() == key.session; });
    if (of == sessions.end() || mark.empty()) continue;
    saved.push_back({index_at<motion::SessionIndex>(of - sessions.begin()), key.lidar, key.stamp_a_ns, key.stamp_b_ns,
                     mark.seen, mark.flagged, mark.comment.toStdString()});
  }
  return saved;
}

void ReviewNotes::put_saved(const std::vector<project::PairNote>& notes) {
  notes_.clear();
  const std::vector<SessionPtr>& sessions = sessions_.all();
  for (const project::PairNote& note : notes)
    if (note.session < sessions.size())
      notes_[{sessions[note.session]->path.string(), note.lidar, note.stamp_a_ns, note.stamp_b_ns}] = {
          note.seen, note.flagged, QString::fromStdString(note.comment)};
  marked_ = nullptr;
  find_marks();
}

}  // namespace remount::gui
