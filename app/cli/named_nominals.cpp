#include "app/cli/named_nominals.h"

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "messages/command_line.h"
#include "messages/rig.h"
#include "model/formats/files/input_file.h"
#include "model/results/exporters/named_mountings.h"
#include "model/results/lidar_names.h"

namespace remount::cli {
namespace {

void add_nominal(NamedNominals& nominals, const std::string& name, NamedNominals::Nominal nominal) {
  if (!nominals.of.emplace(name, std::move(nominal)).second)
    throw Error(ErrorCode::Contract, "--nominal", say::cli_given_twice(name));
}

/// Of the mountings of a file, that of a LiDAR; the only one, whatever it is called, where `any_name`.
const results::NamedMounting* mounting_of(const std::string& lidar, const std::vector<std::string>& lidars,
                                          const std::vector<results::NamedMounting>& mountings, bool any_name) {
  if (const results::NamedMounting* own = results::find_mounting(mountings, lidar, lidars)) return own;
  return any_name && mountings.size() == 1 ? &mountings.front() : nullptr;
}

/// Of a file, with or without "FORMAT:" before it; none of another text.
std::vector<results::NamedMounting> mountings_in(const std::string& text, std::vector<Message>& doubts) {
  if (formats::is_file(text)) return results::read_any_mountings(text, &doubts);
  if (const std::optional<FormatFile> named = file_of_format(text))
    return results::read_mountings_as(named->format, named->file);
  return {};
}

void add_named(NamedNominals& nominals, const std::string& name, const std::vector<std::string>& names,
               const std::string& text) {
  const std::vector<results::NamedMounting> mountings = mountings_in(text, nominals.doubts);
  const results::NamedMounting* own = mounting_of(name, names, mountings, true);
  if (!own && formats::is_file(text)) results::no_lidar_is_named(mountings, {name}, text);
  // Of a file whose format is named the first is taken where no name fits, with a warning.
  const results::ReadMounting mounting = own ? own->mounting : parse_nominal(text, nominals.doubts);
  if (names.size() > 1) results::require_ins_frame(mounting, text);  // of one LiDAR its method says which
  add_nominal(nominals, name, {mounting, text});
}

/// A file with mountings by names: those of the LiDARs are taken, of others is told.
void add_file(NamedNominals& nominals, const std::string& file, const std::vector<std::string>& names) {
  const std::vector<results::NamedMounting> mountings = results::read_any_mountings(file, &nominals.doubts);
  results::MountingsOfLidars found = results::mountings_of_lidars(mountings, names, file);
  if (found.of.empty()) results::no_lidar_is_named(mountings, names, file);
  for (const auto& [name, mounting] : found.of) add_nominal(nominals, name, {mounting, file});
  if (!found.others.empty()) nominals.notes.push_back(say::rig_nominal_of_others(file, std::move(found.others)));
}

void tell_without(const std::vector<std::string>& names, NamedNominals& nominals) {
  std::vector<std::string> without;
  for (const std::string& name : names)
    if (!nominals.of.contains(name)) without.push_back(name);
  if (!without.empty() && !nominals.of.empty())
    nominals.notes.push_back(say::rig_nominal_not_of_all(std::move(without)));
}

}  // namespace

NamedNominals named_nominals(const std::vector<std::string>& texts, const std::vector<std::string>& names) {
  NamedNominals nominals;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::string before = text.substr(0, equals == std::string::npos ? 0 : equals);
    if (text == "none")
      nominals.ignore_declared = true;
    else if (const std::string lidar = results::lidar_meant_by(before, names); !lidar.empty())
      add_named(nominals, lidar, names, text.substr(equals + 1));
    else if (names.size() == 1)
      add_named(nominals, names.front(), names, text);
    else if (formats::is_file(text))
      add_file(nominals, text, names);
    else
      throw Error(ErrorCode::Contract, "--nominal " + text, say::rig_nominal_expected(names));
  }
  tell_without(names, nominals);
  return nominals;
}

NamedNominals named_nominals(const std::vector<std::string>& texts, const std::vector<std::string>& names,
                             Console& console) {
  NamedNominals nominals = named_nominals(texts, names);
  for (const Message& doubt : nominals.doubts) console.warn(doubt);
  for (const Message& note : nominals.notes) console.print(say::cli_note(note));
  return nominals;
}

}  // namespace remount::cli
