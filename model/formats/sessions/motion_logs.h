// Logs of motion that lie in one folder: which of them serves, and which are passed over.
#pragma once

#include <filesystem>
#include <vector>

#include "model/drive/session.h"

namespace remount::formats {

/// Whether a file is a log of an INS or of a GNSS receiver of any kind; poses are none. Never throws.
bool is_motion_log(const std::filesystem::path& file);

/// The one log of a solution that says it was post-processed (ins_log.h): better than what the INS wrote while it
/// drove. Null where this is another log, or there are several.
const std::filesystem::path* only_post_processed(const std::vector<std::filesystem::path>& whole);

/// Names the logs of motion beside the one that the session was read from, where there are such ("ins-log-chosen"): a
/// warning where NovAtel's own log, which was passed over, would have given X in other axes.
void tell_passed_over(const std::filesystem::path& taken, const std::vector<std::filesystem::path>& others,
                      drive::Session& session);

}  // namespace remount::formats
