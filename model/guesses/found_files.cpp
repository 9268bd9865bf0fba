#include "model/guesses/found_files.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/guesses.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/regular_file.h"
#include "model/formats/packets/capture_records.h"

namespace remount::guesses {

namespace fs = std::filesystem;

namespace {

using formats::CloudFormat;

constexpr std::size_t kMostFiles = 500'000;
constexpr int kDeepest = 2;

void gather(const fs::path& folder, int depth, std::vector<fs::path>& files) {
  for (fs::path& file : formats::files_in(folder))
    if (!file.filename().string().starts_with('.')) files.push_back(std::move(file));
  if (files.size() > kMostFiles)
    throw Error(ErrorCode::Unsupported, folder.string(), say::guess_too_many_files(kMostFiles));
  if (depth == kDeepest) return;
  for (const fs::path& below : formats::directories_in(folder))
    if (formats::may_look_into(below) && !below.filename().string().starts_with('.')) gather(below, depth + 1, files);
}

std::optional<CloudFormat> format_by_name(const fs::path& file) {
  const std::string extension = formats::lower_case(file.extension().string());
  if (extension == ".pcd") return CloudFormat::Pcd;
  if (extension == ".ply") return CloudFormat::Ply;
  if (extension == ".las" || extension == ".laz") return CloudFormat::Las;
  if (extension == ".bin") return CloudFormat::KittiBin;
  return formats::is_text_cloud_name(file) ? std::optional(CloudFormat::Text) : std::nullopt;
}

/// A name with its digits left out: those of scans are alike.
std::string without_digits(const std::string& stem) {
  std::string rest = stem;
  std::erase_if(rest, [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
  return rest;
}

/// Texts are scans where several have names that differ in their numbers alone.
bool may_be_scans(CloudFormat format, const std::vector<fs::path>& files) {
  constexpr std::size_t kFewestTexts = 3;
  if (format != CloudFormat::Text) return true;
  if (files.size() < kFewestTexts) return false;
  const std::string rest = without_digits(files.front().stem().string());
  return std::ranges::all_of(files, [&](const fs::path& file) {
    const std::string stem = file.stem().string();
    return without_digits(stem) == rest && stem.size() > rest.size();
  });
}

/// The first, or another where that is broken: recordings are cut at their ends. Throws Error of the first.
ScanRead read_one_of(const std::vector<fs::path>& files, CloudFormat format) {
  const auto read = [&](const fs::path& file) {
    const formats::ReadCloud cloud = formats::read_cloud_file(file, 0, format, formats::PointTimes::Unused);
    return ScanRead{file, cloud.cloud.size(), cloud.columns_words()};
  };
  try {
    return read(files.front());
  } catch (const Error&) {
    try {
      return read(files[files.size() / 2]);
    } catch (const Error&) {  // no better
    }
    throw;
  }
}

/// Why clouds are no recording; nothing where they may be one.
std::optional<Message> no_recording(const std::vector<fs::path>& files) {
  if (files.size() < 2) return say::guess_single_cloud();
  const bool numbers = std::ranges::all_of(files, [](const fs::path& file) {
    return file.stem().string().find_first_of("0123456789") != std::string::npos;
  });
  return numbers ? std::nullopt : std::optional(say::guess_no_numbers_in_names());
}

}  // namespace

FoundFiles find_files(const std::vector<fs::path>& paths, const Progress& progress) {
  std::vector<fs::path> files;
  for (const fs::path& path : paths) {
    if (formats::is_folder(path)) {
      gather(path, 0, files);
    } else {
      (void)formats::open_regular_file(path);  // says what it is otherwise
      files.push_back(path);
    }
  }
  std::ranges::sort(files);
  files.erase(std::unique(files.begin(), files.end()), files.end());
  FoundFiles found;
  std::map<std::tuple<fs::path, CloudFormat, std::string>, std::vector<fs::path>> groups;
  for (fs::path& file : files) {
    if (const auto format = format_by_name(file))
      groups[{file.parent_path(), *format, file.extension().string()}].push_back(std::move(file));
    else
      found.others.push_back(std::move(file));
  }
  for (auto& [key, group] : groups) {
    if (progress.cancelled()) return found;
    const auto& [directory, format, extension] = key;
    if (!may_be_scans(format, group)) {
      found.others.insert(found.others.end(), group.begin(), group.end());
      continue;
    }
    if (auto why = no_recording(group)) {
      const bool maybe_a_log = format == CloudFormat::Text || format == CloudFormat::KittiBin;
      if (maybe_a_log)
        found.others.insert(found.others.end(), group.begin(), group.end());
      else
        found.not_used.push_back({group.front(), std::move(*why)});
      continue;
    }
    try {
      ScanRead read = read_one_of(group, format);
      found.clouds.push_back({directory, format, std::move(group), std::move(read)});
    } catch (const Error& error) {
      if (format == CloudFormat::Text || format == CloudFormat::KittiBin)
        found.others.insert(found.others.end(), group.begin(), group.end());
      else
        found.not_used.push_back({directory, say::guess_cloud_unreadable(drive::message_of(error))});
    }
  }
  std::erase_if(found.others, [&](const fs::path& file) {
    if (!formats::is_capture(file)) return false;
    found.captures.push_back(file);
    return true;
  });
  return found;
}

}  // namespace remount::guesses
