// The LiDARs that session.yaml declares: one by itself, or several by their names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/drive/session.h"
#include "model/drive/topic_choice.h"
#include "model/formats/documents/document.h"

namespace remount::formats {

/// A LiDAR, and the map that holds its `scans` or `lidar_poses`, `lidar` and `nominal`.
struct DeclaredLidar {
  std::string name;   ///< empty where the manifest declares one by itself
  DocumentView node;  ///< the whole manifest then
};

/// In the order of the file; checked as far as it concerns all of them. Throws Error(Format) with the line of what is
/// wrong.
std::vector<DeclaredLidar> declared_lidars(const DocumentView& root);

/// The LiDAR that `topics` names; without one the first, which is a finding where there are others. Null where LiDARs
/// are left out by name. Throws Error(Contract) for a name that the manifest does not have, and for other roles.
/// @param session gets its name
const DeclaredLidar* choose_lidar(const std::vector<DeclaredLidar>& lidars, const drive::TopicChoice& topics,
                                  drive::Session& session);

/// As one of the topics among which LiDARs are chosen.
drive::SessionTopic lidar_topic(const DeclaredLidar& lidar, std::optional<std::size_t> scans);

}  // namespace remount::formats
