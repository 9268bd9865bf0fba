#include <algorithm>
#include <memory>

#include "algorithms/core/error.h"
#include "app/cli/arguments.h"
#include "app/cli/finish.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "model/formats/poses/motion_pairs_file.h"
#include "model/pipeline/pipeline.h"
#include "model/project/project.h"
#include "model/results/disagreement.h"

namespace remount::cli {
namespace {

struct PairsArguments {
  std::string pairs;
  std::vector<std::string> sets;
  SolveArguments solve;
};

/// Leaves only the pairs of the named sets. Throws Error(Contract) for a set that is not there.
void keep_sets(formats::MotionPairs& motions, const std::vector<std::string>& wanted) {
  if (wanted.empty()) return;
  for (const std::string& name : wanted) {
    if (std::find(motions.sets.begin(), motions.sets.end(), name) != motions.sets.end()) continue;
    std::vector<std::string> known;
    for (const std::string& set : motions.sets) known.push_back("\"" + set + "\"");
    throw Error(ErrorCode::Contract, "--only-set " + name, say::cli_no_such_set(known));
  }
  std::erase_if(motions.pairs, [&](const motion::Pair& pair) {
    const motion::SessionIndex set = motions.keyframes[pair.keyframe_a].session;
    return std::find(wanted.begin(), wanted.end(), motions.sets[set]) == wanted.end();
  });
}

int solve(const PairsArguments& arguments, Console& console) {
  arguments.solve.check_output();
  pipeline::PipelineInput input;
  input.settings = arguments.solve.settings();
  if (const auto nominal = arguments.solve.nominal_mounting(console)) {
    if (const Message problem = results::not_in_ins_frame(nominal->frames); !problem.empty())
      throw Error(ErrorCode::Contract, arguments.solve.nominals.front(), problem);
    input.nominal_ins_from_lidar = nominal->ins_from_lidar;
  }
  formats::MotionPairs motions = formats::read_motion_pairs(arguments.pairs);
  keep_sets(motions, arguments.sets);

  pipeline::PipelineOutput output;
  output.keyframes = motions.keyframes;
  output.pairs = motions.pairs;
  output.result = pipeline::solve_motion_pairs(output.keyframes, output.pairs, input.settings,
                                               input.nominal_ins_from_lidar, console.progress());
  results::report_disagreement(output.result, output.findings);
  return finish(project::make_result_file(input, output, {results::hash_input(arguments.pairs)}),
                arguments.solve.output, console);
}

}  // namespace

void add_solve(CLI::App& app, Console& console, Run& run) {
  const auto arguments = std::make_shared<PairsArguments>();
  CLI::App* verb = app.add_subcommand("solve", console.words(say::help_solve()));
  verb->add_option("pairs", arguments->pairs, console.words(say::help_pairs()))->type_name("PAIRS.csv")->required();
  verb->add_option("--only-set", arguments->sets, console.words(say::help_only_set()))
      ->type_name("NAME")
      ->allow_extra_args(false);
  arguments->solve.add_to(*verb, console);
  verb->callback([arguments, &console, &run] { run = [arguments, &console] { return solve(*arguments, console); }; });
}

}  // namespace remount::cli
