// Values that the parts of a workbench share: what is calibrated, and what the user decided about it.
#pragma once

#include <QMetaType>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "model/pipeline/pair_clouds.h"
#include "model/results/result_file.h"

namespace remount::gui {

using OutputPtr = std::shared_ptr<const pipeline::PipelineOutput>;
using CloudsPtr = std::shared_ptr<const pipeline::PairClouds>;
using SessionPtr = std::shared_ptr<const drive::Session>;

/// What became of the present result outside of the project: what was copied may be pasted nowhere.
enum class Exported { No, Copied, Written };

/// What is known of a pair's fate; enough to take a decision back.
struct PairDecision {
  motion::PairIndex pair;
  motion::PairState state = motion::PairState::Proposed;
  motion::DecidedBy decided_by = motion::DecidedBy::Nobody;
  Message reason;
};

/// By which a pair is found again in another output: session path, stamps of scans a and b.
using DecisionKey = std::tuple<std::string, std::int64_t, std::int64_t>;

/// What the user said of a pair.
struct KeptVerdict {
  motion::PairState state = motion::PairState::Proposed;
  Message reason;
  bool operator==(const KeptVerdict&) const = default;
};
using KeptVerdicts = std::map<DecisionKey, KeptVerdict>;

DecisionKey key_of(const pipeline::PipelineInput& input, const pipeline::PipelineOutput& output,
                   const motion::Pair& pair);

/// The pair of the same scans in another output; the first where there is none, nothing where that has no pairs.
std::optional<motion::PairIndex> same_pair(const pipeline::PipelineInput& input_before,
                                           const pipeline::PipelineOutput* before,
                                           std::optional<motion::PairIndex> selected,
                                           const pipeline::PipelineInput& input,
                                           const pipeline::PipelineOutput& output);

/// The last calibration, before anything was decided or set since.
struct WholeRun {
  pipeline::PipelineInput input;
  OutputPtr output;
  KeptVerdicts decisions;
};

/// What is calibrated and what is known of it.
struct CalibratedResult {
  pipeline::PipelineInput input;  ///< of `output`: what it was made with, solutions since then included
  OutputPtr output;               ///< null before the first calibration
  OutputPtr before;               ///< what it is compared with: the one before the edits `moved_by`, solved alike
  OutputPtr solved;               ///< the last that answers every decision in full
  std::optional<WholeRun> whole_run;
  std::vector<results::InputFile> files;  ///< hashes of what was read; empty until they are made
  QString moved_by;                       ///< "reject pair 12"; empty after a calibration
  Exported exported = Exported::No;
  bool data_changed = false;  ///< the files on disk are not those that `output` was made from
  bool confirmed = false;     ///< the user said that it is good
};

/// What was calibrated, with the decisions of then, to be put back.
struct Calibrated {
  CalibratedResult result;
  KeptVerdicts decisions;
  std::optional<motion::PairIndex> selected;
};
using CalibratedPtr = std::shared_ptr<const Calibrated>;

}  // namespace remount::gui

Q_DECLARE_METATYPE(remount::gui::CloudsPtr)
