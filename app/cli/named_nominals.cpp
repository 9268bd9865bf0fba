#include "app/cli/named_nominals.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "messages/command_line.h"
#include "messages/rig.h"
#include "model/formats/files/input_file.h"

namespace remount::cli {
namespace {

void add_nominal(NamedNominals& nominals, const std::string& name, NamedNominals::Nominal nominal) {
  if (!nominals.of.emplace(name, std::move(nominal)).second)
    throw Error(ErrorCode::Contract, "--nominal", say::cli_given_twice(name));
}

void add_named(NamedNominals& nominals, const std::string& name, const std::string& text, Console& console) {
  std::vector<Message> doubts;
  add_nominal(nominals, name, {parse_ins_nominal(text, doubts), text});
  for (const Message& doubt : doubts) console.warn(doubt);
}

}  // namespace

NamedNominals named_nominals(const std::vector<std::string>& texts, const std::vector<std::string>& names,
                             Console& console) {
  NamedNominals nominals;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::string before = text.substr(0, equals == std::string::npos ? 0 : equals);
    if (text == "none")
      nominals.ignore_declared = true;
    else if (std::ranges::find(names, before) != names.end())
      add_named(nominals, before, text.substr(equals + 1), console);
    else
      throw Error(ErrorCode::Contract, "--nominal " + text, say::rig_nominal_expected(names));
  }
  return nominals;
}

}  // namespace remount::cli
