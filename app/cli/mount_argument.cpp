#include "app/cli/mount_argument.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "messages/command_line.h"
#include "messages/sessions.h"
#include "model/formats/files/input_file.h"

namespace remount::cli {
namespace {

using Contents = std::map<std::string, std::string, std::less<>>;

double mounted_number(std::string_view key, const std::string& value, const std::string& where) {
  if (const auto number = formats::parse_number(value)) return *number;
  throw Error(ErrorCode::Contract, where, say::cli_mount_number(std::string(key), value));
}

/// Takes what is typed out of the contents and puts it into the option of that name.
struct MountedOptions {
  Contents& contents;
  const std::string& where;
  std::vector<std::string> keys{};  ///< all that there are, as they may be typed

  template <class T>
  void operator()(const OptionInfo& info, T& option) {
    take(info, [&](const std::string& key, const std::string& value) {
      if constexpr (std::is_same_v<T, bool>) {
        if (value != "true" && value != "false")
          throw Error(ErrorCode::Contract, where, say::cli_mount_switch(key, value));
        option = value == "true";
      } else {
        const double number = mounted_number(key, value, where);
        if (!(number >= info.minimum && number <= info.maximum) ||
            (std::is_integral_v<T> && number != std::round(number)))
          throw Error(ErrorCode::Contract, where, say::cli_outside(key, outside_bounds(info, number)));
        option = static_cast<T>(number);
      }
    });
  }
  template <class T>
  void choice(const OptionInfo& info, T& option, const std::vector<std::string_view>& names) {
    take(info, [&](const std::string&, const std::string& value) {
      const auto found = std::find(names.begin(), names.end(), value);
      if (found == names.end())
        throw Error(ErrorCode::Contract, where, say::native_not_one_of(value, {names.begin(), names.end()}));
      option = static_cast<T>(static_cast<int>(found - names.begin()));
    });
  }

  template <class Assign>
  void take(const OptionInfo& info, Assign&& assign) {
    if (!simulator::is_lidar_option(info.name)) return;
    constexpr std::string_view kPrefix = "lidar_";
    const std::string_view brief = info.name.starts_with(kPrefix) ? info.name.substr(kPrefix.size()) : info.name;
    keys.push_back(typed(brief));
    for (const std::string& key : {std::string(brief), std::string(info.name)}) {
      const auto given = contents.find(key);
      if (given == contents.end()) continue;
      assign(typed(key), given->second);
      contents.erase(given);
      return;
    }
  }
  static std::string typed(std::string_view name) {
    std::string key(name);
    std::replace(key.begin(), key.end(), '_', '-');
    return key;
  }
};

/// Keys with underscores, short ones as the options that they stand for.
Contents contents_of(const std::string& text, const std::string& where) {
  static const std::map<std::string, std::string, std::less<>> kShort{
      {"rate", "scan_rate_hz"}, {"points", "points_per_scan"}, {"field", "field_deg"}};
  Contents contents;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t end = std::min(text.find(',', from), text.size());
    const std::string part = text.substr(from, end - from);
    const std::size_t colon = part.find(':');
    if (colon == std::string::npos) throw Error(ErrorCode::Contract, where, say::cli_mount_expected());
    std::string key = part.substr(0, colon);
    std::replace(key.begin(), key.end(), '-', '_');
    if (const auto known = kShort.find(key); known != kShort.end()) key = known->second;
    if (!contents.emplace(key, part.substr(colon + 1)).second)
      throw Error(ErrorCode::Contract, where, say::cli_mount_twice(part.substr(0, colon)));
    from = end + 1;
  }
  return contents;
}

}  // namespace

simulator::LidarMount parse_mount(const std::string& text, const simulator::SimulationOptions& options) {
  const std::string where = "--mount " + text.substr(0, 200);
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) throw Error(ErrorCode::Contract, where, say::cli_mount_expected());
  simulator::LidarMount mount{text.substr(0, equals), options};
  Contents contents = contents_of(text.substr(equals + 1), where);
  if (auto at = contents.extract("at")) {
    std::replace(at.mapped().begin(), at.mapped().end(), '/', ',');
    mount.options.ins_from_lidar = parse_six(at.mapped());
  }
  if (const auto phase = contents.extract("phase"))
    mount.options.scan_phase_s = mounted_number("phase", phase.mapped(), where);
  MountedOptions taken{contents, where};
  simulator::SimulationOptions::visit(mount.options, taken);
  if (contents.empty()) return mount;
  std::vector<std::string> keys{"at", "phase", "rate", "points", "field"};
  keys.insert(keys.end(), taken.keys.begin(), taken.keys.end());
  throw Error(ErrorCode::Contract, where,
              say::cli_mount_key(MountedOptions::typed(contents.begin()->first), std::move(keys)));
}

}  // namespace remount::cli
