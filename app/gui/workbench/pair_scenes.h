// The scans of pairs, prepared to be looked at.
#pragma once

#include <list>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/workbench/outcome.h"
#include "app/gui/workbench/selection.h"
#include "model/pipeline/pair_clouds.h"
#include "widgets/scene/pair_scene_data.h"

namespace remount::gui {

/// Reads and prepares the scans of the selected pair, then those of the pairs that come next, and keeps what was seen
/// within a budget of memory. A decision changes no scan, so that all stays through it.
class PairScenes : public WorkbenchPart {
  Q_OBJECT
 public:
  PairScenes(const Desk& desk, Outcome& outcome, Selection& selection);
  ~PairScenes() override;

  /// To be ready when they are selected, the most probable first.
  void prepare_next(std::vector<motion::PairIndex> pairs);
  /// Null where it is not ready.
  scene::PairSceneDataPtr find(motion::PairIndex pair);
  /// Of the output's pairs; null where there is none.
  const std::shared_ptr<const pipeline::PairSource>& source();
  /// Whether the picture of the selected pair is still to come.
  bool awaited() const { return awaited_; }
  /// Whether the ground of the scans is told apart before they are shown: the view hides it.
  void tell_ground_apart(bool on) { scene::tell_ground_apart(*scans_, on); }
  void set_budget(std::size_t bytes) { budget_bytes_ = bytes; }

 signals:
  /// Of the selected pair, in turns of their own.
  void reading(motion::PairIndex pair);
  void ready(motion::PairIndex pair, scene::PairSceneDataPtr data);
  void failed(motion::PairIndex pair, const QString& why);

 private:
  struct Kept {
    motion::PairIndex pair;
    scene::PairSceneDataPtr data;
  };
  void show_selected(std::optional<motion::PairIndex> pair);
  void keep_what_serves();
  void start_wanted();
  void start(motion::PairIndex pair);
  void take(motion::PairIndex pair, scene::PairSceneDataPtr data);
  void forget_oldest();
  void tell(motion::PairIndex pair);

  Outcome& outcome_;
  Selection& selection_;
  std::shared_ptr<const pipeline::PairSource> source_;
  OutputPtr served_;  // by the source
  std::shared_ptr<scene::ScanScenes> scans_;
  std::list<Kept> kept_;                      // the last that was used first
  std::vector<motion::PairIndex> wanted_;     // the selected pair, and those that come next
  std::map<motion::PairIndex, int> running_;  // jobs
  bool awaited_ = false;
  std::size_t budget_bytes_;
};

}  // namespace remount::gui
