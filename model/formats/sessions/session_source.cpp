#include "model/formats/sessions/session_source.h"

#include <algorithm>
#include <system_error>

#include "algorithms/core/error.h"
#include "messages/files.h"
#include "model/formats/files/random_access_file.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

/// How much of a text its head is: comments, and the first line that is none, of which any may name columns.
std::size_t head_bytes(const std::string& text) {
  std::size_t end = 0;
  while (end < text.size()) {
    const bool comment = text[end] == '#';
    end = std::min(text.find('\n', end), text.size() - 1) + 1;
    if (!comment) break;
  }
  return end;
}

}  // namespace

std::string GrowingSource::table(const fs::path& path) {
  const RandomAccessFile file(path);
  if (file.size() > kMaxDataFileBytes)
    throw Error(ErrorCode::Unsupported, path.string(),
                say::file_too_large(Bytes{file.size()}, Bytes{kMaxDataFileBytes}));
  Table table = tables_[path];
  shrunk_ = file.size() < table.used;
  if (shrunk_) throw Error(ErrorCode::Io, path.string(), say::file_written_anew());
  std::string added = file.read(table.used, file.size() - table.used);
  bytes_read_ += added.size();
  const std::size_t end = added.rfind('\n');
  if (end == std::string::npos) return "";
  added.resize(end + 1);
  table.used += added.size();
  std::string text = table.head + added;
  table.head = text.substr(0, head_bytes(text));
  new_tables_[path] = std::move(table);
  return text;
}

std::vector<fs::path> GrowingSource::files(const fs::path& folder) {
  const std::set<std::string>& had = files_[folder];
  std::set<std::string>& names = new_files_[folder];
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::string name = entry->path().filename().string();
    if (had.contains(name)) continue;
    ++files_examined_;
    if (is_file(entry->path())) names.insert(std::move(name));
  }
  check_listed(error, folder);
  std::vector<fs::path> found;
  for (const std::string& name : names) found.push_back(folder / name);
  return found;
}

void GrowingSource::keep() {
  for (auto& [path, table] : new_tables_) tables_[path] = std::move(table);
  for (auto& [folder, names] : new_files_) files_[folder].merge(names);
  give_back();
}

void GrowingSource::give_back() {
  new_tables_.clear();
  new_files_.clear();
}

}  // namespace remount::formats
