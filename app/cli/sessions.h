// What every verb that calibrates begins with: sessions that are opened, and the mounting to start from.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "model/drive/session.h"
#include "model/drive/topic_choice.h"
#include "model/results/exporters/exporter.h"

namespace remount::cli {

using Sessions = std::vector<std::shared_ptr<const drive::Session>>;

/// Throws Error for the first that cannot be opened.
/// @param topics of bags, for as many of the sessions as chose some
Sessions open_sessions(const std::vector<std::filesystem::path>& paths, const std::vector<drive::TopicChoice>& topics,
                       Console& console);

/// A mounting that was given as `text`, in the axes of the sessions. Warns of what its file leaves open.
RigidTransform nominal_in_axes(const results::ReadMounting& mounting, const std::string& text, const Sessions& sessions,
                               Console& console);

}  // namespace remount::cli
