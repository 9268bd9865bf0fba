// Which scans a calibration opened and could not read, whatever it opened them for.
#pragma once

#include <memory>
#include <vector>

#include "model/drive/session.h"

namespace remount::pipeline {

class WatchedSource;

/// A scan that cannot be read and is left out.
drive::Finding skipped_scan(const drive::Session& session, const Message& failure);
/// Whether such a finding is there already.
bool is_named(const drive::Finding& skipped, const std::vector<drive::Finding>& findings);

/// Sessions whose scans remember which of them could not be read. Stages that only sample the scans (the first estimate
/// of the mounting, the ground, how scans were swept) pass over those without a word: they are named once, here.
class WatchedScans {
 public:
  explicit WatchedScans(const std::vector<std::shared_ptr<const drive::Session>>& sessions);

  const std::vector<std::shared_ptr<const drive::Session>>& sessions() const { return sessions_; }

  /// Adds those that no finding names yet, in the order of the sessions and their scans.
  void report(std::vector<drive::Finding>& findings) const;

 private:
  std::vector<std::shared_ptr<const drive::Session>> sessions_;
  std::vector<std::shared_ptr<const WatchedSource>> sources_;  // of each session; null where it has no scans
};

}  // namespace remount::pipeline
