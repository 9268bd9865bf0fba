#include "app/cli/shown_path.h"

#include <algorithm>
#include <array>

namespace remount::cli {
namespace {

constexpr std::array<const char*, 4> kSystemFolders{"usr", "opt", "tmp", "var"};

/// The path behind the folder; nothing where it does not lie in it.
std::filesystem::path below_folder(const std::filesystem::path& path, const std::filesystem::path& folder) {
  if (!folder.has_relative_path()) return {};  // "/" is nobody's home
  const std::filesystem::path below = path.lexically_relative(folder);
  return below.empty() || *below.begin() == ".." ? std::filesystem::path() : below;
}

std::filesystem::path hide_names(const std::filesystem::path& shown, const std::filesystem::path& rest,
                                 const std::set<std::string>& names) {
  std::filesystem::path path = shown;
  bool is_home = false;
  for (const std::filesystem::path& part : rest) {
    if (part == ".") continue;
    path /= is_home || names.contains(part.string()) ? std::filesystem::path("…") : part;
    is_home = part == "home" || part == "Users";
  }
  return path;
}

}  // namespace

std::string shown_path(const std::filesystem::path& path, const std::filesystem::path& home,
                       const std::set<std::string>& names) {
  if (path.empty()) return {};
  const std::filesystem::path whole = path.lexically_normal(), below_root = whole.relative_path();
  if (const std::filesystem::path below = below_folder(whole, home.lexically_normal()); !below.empty())
    return hide_names("~", below, names).string();
  if (below_root.empty()) return whole.string();
  const std::filesystem::path first = *below_root.begin();
  if (std::find(kSystemFolders.begin(), kSystemFolders.end(), first) != kSystemFolders.end())
    return hide_names("/", below_root, names).string();
  const std::filesystem::path shown = hide_names("/", first, names);
  return (below_root == first || shown.filename() == "…" ? shown : shown / "…").string();
}

std::set<std::string> names_of_host(const std::string& host) {
  std::set<std::string> names{host, host.substr(0, host.find('.'))};
  names.erase("");
  return names;
}

}  // namespace remount::cli
