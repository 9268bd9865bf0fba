// What lies beside packets (files; in a bag topics, too) to tell what packets do not say of their sensors.
#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "algorithms/core/error.h"
#include "model/formats/files/input_file.h"
#include "model/formats/packets/packet_decoder.h"

namespace remount::formats {

/// Whether a file's name says the address of a sensor: "angles_192.168.1.201.csv". Where it is but a part of another
/// address it does not.
bool names_address(const std::filesystem::path& file, const DatagramRoute& route);

/// How well a file's name says that it is of a sensor: 2 where it is the sensor's address, 1 where it has it among
/// others. What the sensor says itself in the recording, by its topic: more, the more of the topic's name is the same;
/// 1 where it may be of another. A file that somebody called as the topic goes before.
int rank_of_address(const std::filesystem::path& file, const BesidePackets& beside);

/// Whether it says the address of another sensor, and not that of this one. A file that is called as the recording may
/// have the address that is in the recording's name. Of topics of a bag, which have no address: whether it was said on
/// one of another sensor.
bool names_other_address(const std::filesystem::path& file, const BesidePackets& beside);

/// A file as messages call it; of what was said on a topic the topic.
std::string name_beside(const std::filesystem::path& file);

/// What was read of them, and which are broken.
template <class Parsed>
struct FilesBeside {
  struct Broken {
    std::filesystem::path file;
    Error error;
  };
  std::vector<Parsed> found;
  std::vector<Broken> broken;
};

/// Of the files in the recording's folder whose names end so, in their order, and behind them of what is said in the
/// recording, what `parse(bytes, path or topic)` makes of each: nothing for one of something else. Larger ones, and
/// those beyond the thousandth, are not looked at.
template <class Parse>
auto read_files_beside(const BesidePackets& beside, std::string_view ending, std::uint64_t most_bytes,
                       const Parse& parse) {
  constexpr std::size_t kMostFiles = 1000;
  using Parsed = typename std::invoke_result_t<Parse, const std::string&, const std::filesystem::path&>::value_type;
  FilesBeside<Parsed> files;
  std::size_t looked_at = 0;
  const std::filesystem::path& recording = beside.recording;
  const std::filesystem::path folder = recording.has_parent_path() ? recording.parent_path() : ".";
  for (const std::filesystem::path& file : files_in(folder)) try {
      if (lower_case(file.extension().string()) != ending || ++looked_at > kMostFiles) continue;
      if (std::filesystem::file_size(file) > most_bytes) continue;
      if (auto parsed = parse(read_regular_file(file, most_bytes), file)) files.found.push_back(std::move(*parsed));
    } catch (const Error& error) {
      files.broken.push_back({file, error});
    } catch (const std::filesystem::filesystem_error&) {
      // is gone
    }
  for (const SaidOfSensors& said : beside.said) try {
      if (said.bytes.size() > most_bytes) continue;
      if (auto parsed = parse(said.bytes, said.topic)) files.found.push_back(std::move(*parsed));
    } catch (const Error& error) {
      files.broken.push_back({said.topic, error});
    }
  return files;
}

/// How well a file's name says that it is of this sensor: by its address, or else as that of the recording.
inline int rank_of_name(const std::filesystem::path& file, const BesidePackets& beside) {
  return 2 * rank_of_address(file, beside) + (file.stem() == beside.recording.stem() ? 1 : 0);
}

/// What the file for this sensor is to be called, but for its ending, where one of such a rank was found.
inline std::string wanted_name(const BesidePackets& beside, int rank) {
  return rank > 1 ? address_text(beside.route) : beside.recording.stem().string();
}

/// Of those whose names say it best; they have to say the same (`same_as`). Throws what a broken one threw whose name
/// says it better, and `differ(one, other, name to be given)` where they do not.
template <class Found, class Differ>
std::optional<Found> choose_beside(FilesBeside<Found> files, const BesidePackets& beside, const Differ& differ) {
  int best = -1;
  for (const Found& found : files.found) best = std::max(best, rank_of_name(found.file, beside));
  for (const auto& broken : files.broken)
    if (rank_of_name(broken.file, beside) > best) throw broken.error;
  if (files.found.empty()) return std::nullopt;
  std::erase_if(files.found, [&](const Found& found) { return rank_of_name(found.file, beside) < best; });
  const Found& first = files.found.front();
  for (const Found& found : files.found)
    if (!found.same_as(first))
      throw differ(first.file, found.file, wanted_name(beside, best) + first.file.extension().string());
  return first;
}

}  // namespace remount::formats
