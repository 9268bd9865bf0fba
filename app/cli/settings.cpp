#include <memory>

#include "app/cli/arguments.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "model/formats/files/atomic_save.h"
#include "model/settings/settings_file.h"

namespace remount::cli {

void add_settings(CLI::App& app, Console& console, Run& run) {
  const auto output = std::make_shared<std::string>();
  const auto config = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("settings", console.words(say::help_settings()));
  verb->add_option("--config", *config, console.words(say::help_config_to_check()))->type_name("FILE");
  verb->add_option("-o,--output", *output, console.words(say::help_output_or_standard()))->type_name("FILE");
  verb->callback([output, config, &console, &run] {
    run = [output, config, &console]() -> int {
      const settings::Settings settings = config->empty() ? settings::Settings{} : settings::load_settings(*config);
      settings::require_valid(settings);
      const std::string text = settings::settings_text(settings, true, console.options().language);
      if (output->empty()) {
        console.deliver(text);
        return kSolved;
      }
      formats::check_replaces_its_like(*output, "# Settings of Remount");
      formats::save_atomically(*output, text);
      console.print(say::cli_settings_written(*output));
      return kSolved;
    };
  });
}

}  // namespace remount::cli
