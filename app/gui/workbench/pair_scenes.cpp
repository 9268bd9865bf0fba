#include "app/gui/workbench/pair_scenes.h"

#include <algorithm>

#include "app/gui/jobs/error_words.h"

namespace remount::gui {
namespace {
// One reads while the other prepares; more would take the cores from the drawing.
constexpr std::size_t kTogether = 2;
constexpr std::size_t kBudget_bytes = 512U << 20U;
}  // namespace

PairScenes::PairScenes(const Desk& desk, Outcome& outcome, Selection& selection)
    : WorkbenchPart(desk),
      outcome_(outcome),
      selection_(selection),
      scans_(scene::make_scan_scenes()),
      budget_bytes_(kBudget_bytes) {
  qRegisterMetaType<scene::PairSceneDataPtr>();
  connect(&selection_, &Selection::changed, this, &PairScenes::show_selected);
}

PairScenes::~PairScenes() = default;

void PairScenes::show_selected(std::optional<motion::PairIndex> pair) {
  keep_what_serves();
  wanted_.clear();
  awaited_ = pair.has_value();
  if (pair) wanted_.push_back(*pair);
  if (pair && find(*pair))
    desk_.jobs.post([this, pair = *pair] { tell(pair); });
  else if (pair)
    emit reading(*pair);
  start_wanted();
}

void PairScenes::prepare_next(std::vector<motion::PairIndex> pairs) {
  keep_what_serves();  // the output may be another before a pair of it is selected
  wanted_.clear();
  if (selection_.pair()) wanted_.push_back(*selection_.pair());
  wanted_.insert(wanted_.end(), pairs.begin(), pairs.end());
  start_wanted();
}

scene::PairSceneDataPtr PairScenes::find(motion::PairIndex pair) {
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& one) { return one.pair == pair; });
  if (found == kept_.end()) return nullptr;
  kept_.splice(kept_.begin(), kept_, found);
  return kept_.front().data;
}

const std::shared_ptr<const pipeline::PairSource>& PairScenes::source() {
  keep_what_serves();
  return source_;
}

void PairScenes::keep_what_serves() {
  const OutputPtr output = outcome_.output();
  if (output == served_) return;
  served_ = output;
  if (output && source_ && source_->serves(outcome_.input(), *output)) return;
  // What the output was made with, not the present settings: the clouds are to look as they were when they were
  // aligned.
  source_ = output ? desk_.engine.open_pairs(outcome_.input(), output) : nullptr;
  kept_.clear();
  for (const auto& [pair, job] : running_) desk_.jobs.cancel(job);
  running_.clear();
}

void PairScenes::start_wanted() {
  if (!source_) return;
  for (auto one = running_.begin(); one != running_.end();)
    if (std::find(wanted_.begin(), wanted_.end(), one->first) == wanted_.end()) {
      desk_.jobs.cancel(one->second);
      one = running_.erase(one);
    } else {
      ++one;
    }
  // The picture that is to be seen now is not slowed down by those that may be wanted later.
  const bool drawn_next = awaited_ && selection_.pair() && find(*selection_.pair());
  for (const motion::PairIndex pair : wanted_) {
    if (running_.size() >= kTogether || drawn_next) return;
    if (!running_.contains(pair) && !find(pair)) start(pair);
  }
}

void PairScenes::start(motion::PairIndex pair) {
  auto job = std::make_shared<int>(0);
  const auto is_wanted = [this, job, pair] {
    const auto found = running_.find(pair);
    return found != running_.end() && found->second == *job;
  };
  *job = desk_.jobs.start(
      [this, pair, is_wanted, source = source_, scans = scans_](Progress& progress) -> JobRunner::Deliver {
        const auto clouds = std::make_shared<const pipeline::PairClouds>(source->load(pair, progress));
        scene::PairSceneDataPtr data =
            progress.cancelled() ? nullptr : scene::prepare_pair_scene(clouds, *scans, progress);
        return [this, pair, is_wanted, data] {
          if (is_wanted() && data) take(pair, data);
        };
      },
      [this, pair, is_wanted](const JobFailure& failure) {
        if (!is_wanted()) return;
        running_.erase(pair);
        std::erase(wanted_, pair);
        if (pair == selection_.pair()) {
          awaited_ = false;
          emit failed(pair, in_words(failure));
        }
        start_wanted();
      });
  running_[pair] = *job;
}

void PairScenes::take(motion::PairIndex pair, scene::PairSceneDataPtr data) {
  running_.erase(pair);
  kept_.push_front({pair, std::move(data)});
  forget_oldest();
  tell(pair);
  start_wanted();
}

void PairScenes::tell(motion::PairIndex pair) {
  if (pair != selection_.pair()) return;
  const scene::PairSceneDataPtr data = find(pair);
  if (!data) return;
  emit ready(pair, data);
  awaited_ = false;
  start_wanted();
}

void PairScenes::forget_oldest() {
  scene::SceneMemory memory;
  std::size_t place = 0;
  for (auto one = kept_.begin(); one != kept_.end(); ++place) {
    const bool needed = std::find(wanted_.begin(), wanted_.end(), one->pair) != wanted_.end();
    const bool fits = memory.add(*one->data) <= budget_bytes_;
    one = fits || needed || place == 0 ? std::next(one) : kept_.erase(one);
  }
}

}  // namespace remount::gui
