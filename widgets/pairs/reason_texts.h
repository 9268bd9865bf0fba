// The reasons of many pairs as text, for searching and sorting.
#pragma once

#include <QString>
#include <atomic>
#include <future>
#include <memory>
#include <vector>

#include "algorithms/messages/catalogue.h"
#include "model/pipeline/pipeline.h"

namespace remount::widgets {

/// Those of one output. They are made beside the window, for a hundred thousand take longer than a frame; who asks for
/// them waits until they are there.
class ReasonTexts {
 public:
  ReasonTexts(std::shared_ptr<const pipeline::PipelineOutput> output, Language language);
  ~ReasonTexts();
  ReasonTexts(const ReasonTexts&) = delete;
  ReasonTexts& operator=(const ReasonTexts&) = delete;

  /// Of each pair, as the window shows it and, behind a line feed, in English, which files hold; both without the
  /// difference between upper and lower case. Empty where a pair has no reason.
  const std::vector<QString>& folded() const { return made_.get().folded; }
  /// The place of each among all in the order of their words; -1 where a pair has no reason.
  const std::vector<int>& ranks() const { return made_.get().ranks; }

 private:
  struct Made {
    std::vector<QString> folded;
    std::vector<int> ranks;
  };
  Made make(const pipeline::PipelineOutput& output, Language language) const;

  std::atomic<bool> unwanted_ = false;
  std::shared_future<Made> made_;
};

}  // namespace remount::widgets
