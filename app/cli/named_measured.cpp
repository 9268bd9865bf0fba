#include "app/cli/named_measured.h"

#include <algorithm>
#include <set>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "messages/command_line.h"
#include "messages/rig.h"
#include "model/formats/files/input_file.h"
#include "model/results/lidar_names.h"

namespace remount::cli {
namespace {

/// "z" of "z = 1.73,0.01".
std::string measured_name(const std::string& text) {
  return std::string(formats::trim(std::string_view(text).substr(0, text.find('='))));
}

}  // namespace

NamedMeasured take_named_measured(std::vector<std::string>& measured, const std::vector<std::string>& lidars) {
  NamedMeasured of_lidars;
  std::set<std::string> given;
  std::erase_if(measured, [&](const std::string& text) {
    const std::size_t equals = text.find('='), colon = text.rfind(':', equals);
    if (equals == std::string::npos || colon == std::string::npos) return false;
    const std::string where = "--measured " + text, name(formats::trim(text.substr(0, colon))),
                      lidar = results::lidar_meant_by(name, lidars), value = text.substr(colon + 1),
                      key = lidar + ":" + measured_name(value);
    if (lidar.empty()) throw Error(ErrorCode::Contract, where, say::cli_rig_measured_of_none(name, lidars));
    if (measured_name(value) == kMeasuredInsHeight)
      throw Error(ErrorCode::Contract, where, say::cli_rig_ins_height_of_all());
    if (!given.insert(key).second) throw Error(ErrorCode::Contract, where, say::cli_given_twice(key));
    of_lidars[lidar].push_back(value);
    return true;
  });
  return of_lidars;
}

void give_measured_to_only(std::vector<std::string>& measured, const std::string& lidar) {
  for (const auto& [name, values] : take_named_measured(measured, {lidar}))
    for (const std::string& value : values) {
      const auto is_same = [&](const std::string& other) { return measured_name(other) == measured_name(value); };
      if (std::ranges::any_of(measured, is_same))
        throw Error(ErrorCode::Contract, "--measured " + name + ":" + value,
                    say::cli_given_twice(measured_name(value)));
      measured.push_back(value);
    }
}

}  // namespace remount::cli
