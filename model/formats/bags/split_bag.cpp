#include "model/formats/bags/split_bag.h"

#include "algorithms/core/error.h"
#include "messages/bags.h"
#include "model/drive/bad_items.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"

namespace remount::bags {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kInformation = "rosbag2_bagfile_information";

}  // namespace

SplitBag::SplitBag(std::vector<std::shared_ptr<const BagFile>> parts) : parts_(std::move(parts)) {
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const BagFile& file = *parts_[part];
    files_.insert(files_.end(), file.files().begin(), file.files().end());
    findings_.insert(findings_.end(), file.findings().begin(), file.findings().end());
    for (const BagTopic& topic : file.topics()) {
      std::vector<BagEntry>& entries =
          topics_[this->topic(topic.name, topic.type, topic.encoding, topic.definition)].entries;
      for (BagEntry entry : topic.entries) {
        entry.file = static_cast<std::uint32_t>(part);
        entries.push_back(entry);
      }
    }
  }
  sort_topics();
}

std::string SplitBag::message(const BagEntry& entry, std::size_t at_most) const {
  return parts_.at(entry.file)->message(entry, at_most);
}

std::string SplitBag::message_end(const BagEntry& entry, std::size_t at_most) const {
  return parts_.at(entry.file)->message_end(entry, at_most);
}

bool is_rosbag2_folder(const fs::path& folder) {
  try {
    return formats::read_text_head(folder / "metadata.yaml", 4096).find(kInformation) != std::string::npos;
  } catch (const Error&) {
    return false;
  }
}

std::vector<fs::path> rosbag2_files(const fs::path& folder, std::vector<drive::Finding>& findings) {
  const fs::path metadata = folder / "metadata.yaml";
  const formats::DocumentNode document = formats::read_document(metadata);
  const formats::DocumentView information = formats::DocumentView(document, metadata.string()).at(kInformation);
  std::vector<fs::path> files;
  std::vector<std::string> missing;
  for (const formats::DocumentView& item : information.at("relative_file_paths").items()) {
    // Names only: a bag does not reach out of its folder. Early versions wrote the folder before the name.
    fs::path file = folder / fs::path(item.string()).filename();
    // Somebody may have unpacked it by hand.
    if (!formats::is_file(file) && file.extension() == ".zstd") file.replace_extension();
    if (formats::is_file(file))
      files.push_back(file);
    else
      missing.push_back(file.filename().string());
  }
  if (files.empty()) throw Error(ErrorCode::Io, folder.string(), say::bag_parts_not_here(std::move(missing)));
  if (!missing.empty())
    findings.push_back(drive::make_finding(drive::Severity::Warning, "bag-part-missing", folder.string(),
                                           say::bag_parts_missing(std::move(missing))));
  return files;
}

}  // namespace remount::bags
