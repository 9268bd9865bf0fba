// What recorded data are suspected of: every code with what it means and what to do, in one list.
#pragma once

#include <string_view>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/conventions/metric_poses.h"
#include "model/drive/session.h"

namespace remount::checks {

/// What findings of one code have in common.
struct FindingKind {
  std::string_view code;  ///< "ins-gaps"; with '*' at one end where streams have their own: "*-reversed-stamps"
  Message (*meaning)() = nullptr;  ///< what it does to a calibration
  Message (*remedy)() = nullptr;   ///< what to do about it
};

/// A session, and what most checks need of it.
struct CheckedSession {
  const drive::Session& session;
  conventions::MetricPoses poses;  ///< of the INS

  /// As it was logged: the axes of the metric frame turn with the place, so that what repeats does not there.
  Eigen::Quaterniond logged_attitude(std::size_t i) const {
    return session.ins.size() == poses.size() ? session.ins[i].enu_from_ins
                                              : Eigen::Quaterniond(poses[i].pose.linear());
  }
};

/// Looks for one suspicion, or for several that are seen together.
struct DataCheck {
  std::vector<FindingKind> kinds;
  /// Adds what it finds. Null where readers and stages find it while they read.
  void (*look)(const CheckedSession& checked, std::vector<drive::Finding>& findings,
               const Progress& progress) = nullptr;
  bool reads_scans = false;
  /// What the drive is good for rather than what is wrong with the data: `inspect` says it, a calibration advises.
  bool of_the_drive = false;
};

/// The list. Adding one: a file in this folder, a declaration in builtin.h, a line in data_checks.cpp.
const std::vector<DataCheck>& data_checks();

/// Nothing where the code is in no list: the finding's explanation says all there is to say.
const FindingKind* finding_kind(std::string_view code);

enum class LookAt { Streams, StreamsAndScans };

/// What the checks of the drive find.
std::vector<drive::Finding> drive_findings(const drive::Session& session);

/// What all other checks find. With scans, up to some fifteen of them are read. Stops where `progress` is cancelled.
std::vector<drive::Finding> data_findings(const drive::Session& session, LookAt look_at, const Progress& progress);

}  // namespace remount::checks
