// What every session format offers.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/drive/lidar_offer.h"
#include "model/drive/session.h"
#include "model/drive/topic_offer.h"

namespace remount::formats {

class SessionReader {
 public:
  virtual ~SessionReader() = default;
  virtual std::string_view id() const = 0;  ///< "kitti-raw"
  virtual Message description() const = 0;  ///< one line for help and file dialogs
  /// How sure, from the content and not only from names: 0 (no) to 100 (certain). Reads little. Throws Error(Io) where
  /// it cannot be seen what lies there; what cannot be read is not recognised.
  virtual int probe(const std::filesystem::path& path) const = 0;
  /// Throws Error (file, place, expectation) where nothing usable is there; a bad scan or line inside a usable
  /// session becomes a Finding.
  virtual drive::Session open(const std::filesystem::path& path, Progress& progress) const = 0;
  /// As open, with topics that were chosen. Throws Error(Contract) where some were and the format has none.
  virtual drive::Session open_topics(const std::filesystem::path& path, const drive::TopicChoice& topics,
                                     Progress& progress) const;
  /// What there is to choose from before it is opened; nothing where the format has no topics. Throws Error as open
  /// does.
  virtual std::optional<drive::TopicOffer> offer_topics(const std::filesystem::path& path, Progress& progress) const;
  /// The LiDARs that it has, at least one; a recording without any offers the one that is missing. By itself one
  /// without a name. Throws Error as open does.
  virtual std::vector<drive::LidarOffer> offer_lidars(const std::filesystem::path& path, Progress& progress) const;
};

}  // namespace remount::formats
