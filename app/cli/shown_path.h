// Paths as a report of a fault shows them: what tells where a program or its files are, not whose they are.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace remount::cli {

/// Below the home folder from "~" on; below /usr, /opt, /tmp and /var as it is; of any other path the first part and …,
/// since folders that people make are called after vehicles and customers. Parts that are one of `names`, and a home of
/// somebody else, are … wherever they stand. Paths are absolute; empty stays empty.
std::string shown_path(const std::filesystem::path& path, const std::filesystem::path& home,
                       const std::set<std::string>& names);

/// A host is called "a" where it calls itself "a.example.org".
std::set<std::string> names_of_host(const std::string& host);

}  // namespace remount::cli
