// What a calibration method is to everybody else: one entry a method, and the list of them.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "algorithms/calibration/mounting.h"
#include "algorithms/core/progress.h"
#include "algorithms/messages/message.h"
#include "model/drive/session.h"

namespace remount::pipeline {
struct PipelineInput;
struct PipelineOutput;
}  // namespace remount::pipeline

namespace remount::method_registry {

using GivenSessions = std::vector<std::shared_ptr<const drive::Session>>;  ///< to one calibration
using RunMethod = pipeline::PipelineOutput (*)(const pipeline::PipelineInput& input, Progress& progress);

/// What is said where a method is for another machine than a vehicle, which no stream shows. All or none.
struct ForOtherMachine {
  Message (*proviso)() = nullptr;                ///< "if it is a recording of an excavator"
  Message (*or_else)() = nullptr;                ///< of a session that serves no other method, as `inspect` ends
  Message (*or_choose)(Message lack) = nullptr;  ///< of sessions that lack something for another method
};

/// A way to find where the LiDAR sits. All take sessions and settings and leave a PipelineOutput behind, so that
/// report, export, project and window need not know them; a method without pairs leaves those empty.
///
/// The entry of a method is a constant in its folder below model/methods: texts are functions, so that it is there
/// before anything runs.
struct CalibrationMethod {
  std::string_view id;  ///< as on the command line and in files, where it stays: "pairwise"
  Message (*title)();   ///< for people: "Pairs of keyframes"
  Message (*needs)();   ///< the streams, for people: "scans or LiDAR poses, and an INS with attitude"
  /// What a session lacks, in words that follow its name: "has no wheel speeds". Empty where its streams serve. What
  /// serves alone may not serve beside others: `given` are all, or none where one session is looked at.
  Message (*lack)(const drive::Session& session, const GivenSessions& given);
  /// What of the mounting the streams of a session that serves leave out: "the antenna's lever arm alone". May be null.
  Message (*limit)(const drive::Session& session) = nullptr;
  ForOtherMachine other_machine = {};
  /// Between which frames the mounting is that it finds in these sessions, and starts from. Null: of the LiDAR in the
  /// INS frame, as sessions declare it.
  calibration::MountingFrames (*frames)(const GivenSessions& given) = nullptr;
  std::string_view settings_section = {};  ///< of Settings::visit_sections; empty where it has none of its own
  bool from_pairs = false;                 ///< of keyframes, which are there to be reviewed
  /// Throws Error(Unsupported) where the sessions lack a stream, Error(Contract) for settings out of range. What the
  /// numbers do not allow is part of the result. Cancellable; the same for any number of threads.
  RunMethod run;

  bool for_other_machine() const { return other_machine.proviso != nullptr; }
};

/// What an entry calls `run`: nothing in the build that only reads files (REMOUNT_ONLY_READERS), which has no solvers.
constexpr RunMethod solver([[maybe_unused]] RunMethod run) {
#ifdef REMOUNT_ONLY_READERS
  return nullptr;
#else
  return run;
#endif
}

/// The methods that are built in, in the order in which they are shown. Adding one: a folder with its entry, and a line
/// in methods.cpp.
std::span<const CalibrationMethod* const> calibration_methods();

/// The first of them, which is taken when none is asked for.
const CalibrationMethod& default_method();

/// Throws Error(Contract) that names the methods where `id` is none of them.
const CalibrationMethod& calibration_method(std::string_view id);

/// Null for a name that is none of theirs, as a file of a later version may have.
const CalibrationMethod* find_method(std::string_view id);

/// False for a name that is none of theirs.
bool is_from_pairs(std::string_view id);

}  // namespace remount::method_registry
