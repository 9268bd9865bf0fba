#include "model/formats/bags/bag_file.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "algorithms/core/error.h"
#include "messages/bags.h"
#include "model/drive/bad_items.h"
#include "model/formats/bags/mcap_file.h"
#include "model/formats/bags/packet_messages.h"
#include "model/formats/bags/rosbag1_file.h"
#include "model/formats/bags/split_bag.h"
#include "model/formats/bags/sqlite_bag.h"
#include "model/formats/bags/unpacked_file.h"
#include "model/formats/files/input_file.h"
#include "model/formats/sessions/several_sessions.h"

namespace remount::bags {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kSniffedBytes = 64;

std::string head_of(const fs::path& path) {
  try {
    return formats::read_file_head(path, kSniffedBytes);
  } catch (const Error&) {
    return {};  // not readable: not recognised
  }
}

/// SQLite keeps many other things, and many things are compressed: the name must say that this is a bag.
bool is_bag(const fs::path& path) {
  const std::string head = head_of(path), name = formats::lower_case(path.filename().string());
  if (is_sqlite(head)) return name.ends_with(".db3");
  if (is_zstd(head)) return name.ends_with(".db3.zstd") || name.ends_with(".mcap.zstd");
  return is_rosbag1(head) || is_mcap(head);
}

/// What is there of a bag whose unpacking was cancelled.
class NothingYet final : public BagFile {
 public:
  explicit NothingYet(const fs::path& path) { files_ = {path}; }
  std::string message(const BagEntry&, std::size_t) const override {
    throw Error(ErrorCode::Contract, files_[0].string(), say::bag_not_opened());
  }
};

/// A bag that was compressed as a whole.
std::shared_ptr<const BagFile> open_packed(const fs::path& path, Progress& progress) {
  const BagInput input{path, std::make_shared<const UnpackedFile>(path, progress)};
  if (progress.cancelled()) return std::make_shared<NothingYet>(path);
  const std::string head = formats::read_file_head(input.path(), kSniffedBytes);
  if (is_mcap(head)) return std::make_shared<McapFile>(input, progress);
  if (is_sqlite(head)) return std::make_shared<SqliteBag>(input, progress);
  throw Error(ErrorCode::Format, path.string(), say::bag_unpacks_to_no_bag());
}

/// The bags of a folder.
std::vector<fs::path> bags_in(const fs::path& folder) {
  std::vector<fs::path> bags;
  for (const fs::path& file : formats::files_in(folder))
    if (is_bag(file)) bags.push_back(file);
  return bags;
}

/// A recording in several files lacks a part where one was not copied whole.
std::shared_ptr<const BagFile> with_damaged_beside(std::shared_ptr<const BagFile> bag, const fs::path& folder) {
  std::vector<drive::Finding> findings;
  for (const fs::path& file : formats::files_in(folder)) {
    const std::string extension = formats::lower_case(file.extension().string());
    if ((extension == ".bag" || extension == ".mcap" || extension == ".db3") && !is_bag(file))
      findings.push_back(drive::make_finding(drive::Severity::Warning, "bag-part-unreadable", file.string(),
                                             say::bag_by_name_alone()));
  }
  if (findings.empty()) return bag;
  const auto told = std::make_shared<SplitBag>(std::vector{std::move(bag)});
  for (drive::Finding& finding : findings) told->add_finding(std::move(finding));
  return told;
}

std::shared_ptr<const BagFile> open_only_bag(const fs::path& folder, Progress& progress) {
  const std::vector<fs::path> bags = bags_in(folder);
  if (bags.empty()) throw Error(ErrorCode::Format, folder.string(), say::bag_folder_without_bag());
  if (bags.size() == 1) return with_damaged_beside(open_bag(bags[0], progress), folder);
  throw formats::SeveralSessions(folder, say::bag_folder_of_several(bags.size(), formats::lines_of(bags)), bags);
}

std::shared_ptr<const BagFile> open_parts(const fs::path& folder, Progress& progress) {
  std::vector<drive::Finding> findings;
  std::vector<std::shared_ptr<const BagFile>> parts;
  std::optional<Error> first;
  for (const fs::path& file : rosbag2_files(folder, findings)) try {
      parts.push_back(open_bag(file, progress));
    } catch (const Error& error) {
      if (!first) first = error;
      findings.push_back(
          drive::make_finding(drive::Severity::Warning, "bag-part-unreadable", file.string(), error.what_happened()));
    }
  if (parts.empty() && first) throw *first;
  const auto bag = std::make_shared<SplitBag>(std::move(parts));
  for (drive::Finding& finding : findings) bag->add_finding(std::move(finding));
  return bag;
}

}  // namespace

std::string short_type(std::string_view type) {
  std::string name(type);
  if (const std::size_t middle = name.find("/msg/"); middle != std::string::npos) name.erase(middle, 4);
  return name;
}

std::string BagFile::kept_definition(std::string_view type, std::string_view definition) {
  constexpr std::size_t kLongest = std::size_t{64} << 10, kAll = std::size_t{8} << 20;
  if (!holds_lidar_packets(short_type(type))) return {};
  if (definition.size() > kLongest || definition_bytes_ + definition.size() > kAll) return {};
  definition_bytes_ += definition.size();
  return std::string(definition);
}

std::string BagFile::message_end(const BagEntry& entry, std::size_t at_most) const {
  std::string whole = message(entry);
  return whole.substr(whole.size() - std::min(whole.size(), at_most));
}

std::size_t BagFile::topic(std::string name, std::string type, MessageEncoding encoding, std::string_view definition) {
  type = short_type(type);
  for (std::size_t i = 0; i < topics_.size(); ++i)
    if (topics_[i].name == name && topics_[i].type == type && topics_[i].encoding == encoding) return i;
  std::string kept = kept_definition(type, definition);
  topics_.push_back({std::move(name), std::move(type), encoding, {}, std::move(kept)});
  return topics_.size() - 1;
}

void BagFile::add_entry(std::size_t topic, const BagEntry& entry, std::uint64_t file_bytes, const std::string& where) {
  // Small messages that are packed well may be more than the file has room for; not without end. As many take, while
  // the list grows, three times the file.
  constexpr std::uint64_t kAlways = 1'000'000;
  if (entry_count_ > kAlways + file_bytes / sizeof(BagEntry))
    throw Error(ErrorCode::Format, where, say::bag_too_many_messages(entry_count_, Bytes{file_bytes}));
  topics_[topic].entries.push_back(entry);
  // Before 1843 and after 2096 is no time; differences of what is left fit 64 bits.
  constexpr std::int64_t kLatest_ns = 4'000'000'000'000'000'000;
  std::int64_t& log_time_ns = topics_[topic].entries.back().log_time_ns;
  log_time_ns = std::clamp(log_time_ns, -kLatest_ns, kLatest_ns);
  ++entry_count_;
}

void BagFile::forget_topics() {
  topics_.clear();
  entry_count_ = definition_bytes_ = 0;
}

void BagFile::sort_topics() {
  std::sort(topics_.begin(), topics_.end(),
            [](const BagTopic& a, const BagTopic& b) { return std::tie(a.name, a.type) < std::tie(b.name, b.type); });
  for (BagTopic& topic : topics_)
    std::stable_sort(topic.entries.begin(), topic.entries.end(),
                     [](const BagEntry& a, const BagEntry& b) { return a.log_time_ns < b.log_time_ns; });
}

std::shared_ptr<const BagFile> open_bag(const fs::path& path, Progress& progress) {
  if (formats::is_folder(path))
    return is_rosbag2_folder(path) ? open_parts(path, progress) : open_only_bag(path, progress);
  const std::string head = formats::read_file_head(path, kSniffedBytes);
  if (is_rosbag1(head)) return std::make_shared<Rosbag1File>(path, progress);
  if (is_mcap(head)) return std::make_shared<McapFile>(BagInput{path, nullptr}, progress);
  if (is_sqlite(head)) return std::make_shared<SqliteBag>(BagInput{path, nullptr}, progress);
  if (is_zstd(head)) return open_packed(path, progress);
  throw Error(ErrorCode::Format, path.string(), say::bag_of_no_known_kind());
}

int probe_bag(const fs::path& path) {
  if (formats::is_file(path)) return is_bag(path) ? 95 : 0;
  if (!formats::is_folder(path)) return 0;
  if (is_rosbag2_folder(path)) return 95;
  const std::size_t bags = bags_in(path).size();
  return bags == 0 ? 0 : bags == 1 ? 65 : 25;
}

}  // namespace remount::bags
