// Logs of motion that lie in one folder: which of them serves, and which are passed over.
#pragma once

#include <filesystem>
#include <vector>

#include "model/drive/session.h"

namespace remount::formats {

/// Whether a file is a log of an INS or of a GNSS receiver of any kind; poses are none. Never throws.
bool is_motion_log(const std::filesystem::path& file);

/// The one log of a solution that was post-processed (ins_log.h): better than what the INS wrote while it drove. Null
/// where these are other logs, or several.
const std::filesystem::path* only_post_processed(const std::vector<std::filesystem::path>& whole);

/// Names the logs of motion beside the one that was taken, where there are such ("ins-log-chosen").
void tell_passed_over(const std::filesystem::path& taken, const std::vector<std::filesystem::path>& others,
                      std::vector<drive::Finding>& findings);

}  // namespace remount::formats
