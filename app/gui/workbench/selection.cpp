#include "app/gui/workbench/selection.h"

#include "app/gui/jobs/error_words.h"

namespace remount::gui {

Selection::Selection(const Desk& desk, Outcome& outcome) : WorkbenchPart(desk), outcome_(outcome) {
  qRegisterMetaType<CloudsPtr>();
}

void Selection::select(std::optional<motion::PairIndex> pair) {
  const OutputPtr output = outcome_.output();
  if (!output || (pair && *pair >= output->pairs.size())) pair.reset();
  if (pair == pair_ && pair) return;
  pair_ = pair;
  emit changed(pair);
  load_clouds();
}

void Selection::select_anew(std::optional<motion::PairIndex> pair) {
  pair_.reset();
  select(pair);
}

void Selection::load_clouds() {
  desk_.jobs.cancel(job_);
  job_ = 0;
  if (!pair_) return;
  const motion::PairIndex pair = *pair_;
  emit clouds_loading(pair);
  // What the output was made with, not the present settings: the clouds are to look as they were when they were
  // aligned.
  auto job = std::make_shared<int>(0);
  job_ = desk_.jobs.start(
      [this, job, pair, input = outcome_.input(), output = outcome_.output(),
       load = desk_.engine.load_pair_clouds](Progress&) -> JobRunner::Deliver {
        auto clouds = std::make_shared<const pipeline::PairClouds>(load(input, *output, pair));
        return [this, job, pair, clouds] {
          if (*job == job_) emit clouds_loaded(pair, clouds);
        };
      },
      [this, job, pair](const JobFailure& failure) {
        if (*job == job_) emit clouds_failed(pair, in_words(failure));
      });
  *job = job_;
}

}  // namespace remount::gui
