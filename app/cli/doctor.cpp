// What a report of a fault needs to know of this machine, as plain text.
#include "messages/doctor.h"

#include <vector>

#include "algorithms/core/parallel.h"
#include "algorithms/registration/kernels.h"
#include "app/cli/system_facts.h"
#include "app/cli/verbs.h"
#include "messages/command_help.h"
#include "model/formats/packets/index_store.h"
#include "remount_built_with.h"
#include "remount_version.h"

namespace remount::cli {
namespace {

namespace fs = std::filesystem;

Message bytes_or(const std::optional<std::uint64_t>& bytes, Message (*otherwise)()) {
  return bytes ? say::doctor_bytes(Bytes{*bytes}) : otherwise();
}

Message bytes_of(const Limit& limit) {
  return limit.known ? bytes_or(limit.most, say::doctor_no_limit) : say::doctor_unknown();
}

Message folder_of(const fs::path& folder, Message (*otherwise)()) {
  if (folder.empty()) return otherwise();
  const std::string shown = without_names(folder);
  return say::doctor_folder(shown, bytes_or(free_bytes_at(folder), say::doctor_unknown));
}

Message processor_line() {
  const std::vector<std::string> sets = instruction_sets();
  const std::string name = processor_name();
  return say::doctor_processor(name.empty() ? say::doctor_unknown() : Message::verbatim(name),
                               sets.empty() ? say::doctor_none() : say::doctor_list(sets));
}

Message threads_line(int threads) {
  const ProcessorShare share = processor_share();
  const Message line = say::doctor_threads(worker_count(threads), share.usable, share.present);
  return share.of_group ? say::doctor_threads_of_group(line, *share.of_group) : line;
}

Message memory_line() {
  const MemoryFacts memory = memory_facts();
  return say::doctor_memory(bytes_or(memory.total, say::doctor_unknown),
                            bytes_or(memory.available, say::doctor_unknown), bytes_of(memory.of_group),
                            bytes_of(memory.of_process));
}

Message files_line() {
  const Limit files = most_open_files();
  if (!files.known) return say::doctor_files_unknown();
  return files.most ? say::doctor_files(*files.most) : say::doctor_files_unlimited();
}

Message locale_line() {
  const std::string variables = locale_variables();
  return say::doctor_locale(variables.empty() ? say::doctor_none() : Message::verbatim(variables));
}

int examine(Console& console) {
  const fs::path sample = sample_folder();
  std::error_code unknown;
  const std::vector<Message> lines{
      say::doctor_program(kVersion, kBuild),
      say::doctor_place(without_names(program_file())),
      say::doctor_libraries(kLibraries),
      say::doctor_window(),
      say::doctor_system(system_name()),
      processor_line(),
      registration::has_fast_kernels() ? say::doctor_kernels_avx2() : say::doctor_kernels_portable(),
      threads_line(console.options().threads),
      memory_line(),
      files_line(),
      locale_line(),
      say::doctor_cache(folder_of(formats::users_index_store().folder, say::doctor_no_folder)),
      say::doctor_temporary(folder_of(fs::temp_directory_path(unknown), say::doctor_no_temporary)),
      sample.empty() ? say::doctor_no_sample() : say::doctor_sample(without_names(sample))};
  std::string text;
  for (const Message& line : lines) text += console.words(line) + "\n";
  console.deliver(text);
  return kSolved;
}

}  // namespace

void add_doctor(CLI::App& app, Console& console, Run& run) {
  CLI::App* verb = app.add_subcommand("doctor", console.words(say::help_doctor()));
  verb->footer(console.words(say::help_doctor_privacy()));
  verb->callback([&console, &run] { run = [&console] { return examine(console); }; });
}

}  // namespace remount::cli
