// Bags of several files: of ROS 2 as they lie on the disk, a folder with metadata.yaml and one file or several.
#pragma once

#include <vector>

#include "model/formats/bags/bag_file.h"

namespace remount::bags {

/// Several files as one bag. Topics of one name and type are one topic.
class SplitBag final : public BagFile {
 public:
  explicit SplitBag(std::vector<std::shared_ptr<const BagFile>> parts);
  std::string message(const BagEntry& entry, std::size_t at_most) const override;
  std::string message_end(const BagEntry& entry, std::size_t at_most) const override;
  void add_finding(drive::Finding finding) { findings_.push_back(std::move(finding)); }

 private:
  std::vector<std::shared_ptr<const BagFile>> parts_;
};

/// True where a folder has the metadata.yaml of such a bag.
bool is_rosbag2_folder(const std::filesystem::path& folder);

/// The files that the folder's metadata.yaml names; those that are missing become findings "bag-part-missing". Throws
/// Error where metadata.yaml cannot be read or all are missing.
std::vector<std::filesystem::path> rosbag2_files(const std::filesystem::path& folder,
                                                 std::vector<drive::Finding>& findings);

}  // namespace remount::bags
