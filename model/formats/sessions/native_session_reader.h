// Remount's own session folder, declared by session.yaml: see resources/formats/native-session.md.
#pragma once

#include <optional>

#include "model/formats/sessions/session_reader.h"
#include "model/formats/sessions/session_source.h"

namespace remount::formats {

class NativeSessionReader final : public SessionReader {
 public:
  std::string_view id() const override { return "native"; }
  Message description() const override;
  int probe(const std::filesystem::path& path) const override;
  drive::Session open(const std::filesystem::path& path, Progress& progress) const override;
  /// The role "lidar" names one of several LiDARs.
  drive::Session open_topics(const std::filesystem::path& path, const drive::TopicChoice& topics,
                             Progress& progress) const override;
  std::optional<drive::TopicOffer> offer_topics(const std::filesystem::path& path, Progress& progress) const override;
  std::vector<drive::LidarOffer> offer_lidars(const std::filesystem::path& path, Progress& progress) const override;
  /// What `source` hands out of a session that still grows: items of the streams that trajectory alignment takes, in
  /// the state that their clocks have. Nothing where the session cannot be read in parts. Throws as open.
  std::optional<drive::Session> open_part(const std::filesystem::path& path, SessionSource& source,
                                          Progress& progress) const;
  static std::filesystem::path manifest_of(const std::filesystem::path& path);
};

}  // namespace remount::formats
