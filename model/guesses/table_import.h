// Data without a manifest, for somebody who looks at what they are taken for, changes it, and keeps it as a manifest.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/messages/catalogue.h"
#include "model/guesses/import_checks.h"
#include "model/guesses/table_choices.h"

namespace remount::guesses {

/// A table, and what is said of its columns before anybody changes it.
struct ImportTable {
  std::filesystem::path file;
  SampledTable table;                                ///< without the values of its columns
  std::vector<std::vector<std::string>> first_rows;  ///< as they stand there
  std::optional<InsGuess> guess;                     ///< nothing where it lacks something
  std::vector<Message> lacks;
  TableChoices preset;
};

/// What lies there.
struct ImportData {
  std::filesystem::path folder;  ///< of the manifest
  Description description;
  std::vector<std::filesystem::path> tables;  ///< with columns enough for a motion
  std::optional<ImportTable> table;           ///< of the motion that was found, else the first that may be one
  Message opens_as;                           ///< what reads it without any manifest; empty for nothing
};

/// Whether a table is the poses of a LiDAR: as the motion of the INS it is shown where somebody asks for it alone, and
/// the LiDAR is left out then.
bool is_of_lidar(const Description& description, const std::filesystem::path& file);

/// Looks at files and folders. @param meant the table that is asked for, if any
/// Throws as describe_data.
ImportData look_for_import(const std::vector<std::filesystem::path>& paths, Progress& progress,
                           const std::optional<std::filesystem::path>& meant = std::nullopt);

/// Another of the tables. Throws Error where it cannot be read.
ImportTable import_table(const std::filesystem::path& file, const Description& description, const Progress& progress);

/// What somebody made of it.
struct ImportChoice {
  std::optional<ImportTable> table;  ///< nothing: what the description has
  TableChoices choices;
  std::set<std::size_t> left_out;  ///< of the LiDARs of the description
};

std::vector<std::int64_t> stamps_of(const Description& description, const std::set<std::size_t>& left_out);

/// Of a choice with a table.
ImportChecks check_choice(const Description& description, const ImportChoice& choice, const Progress& progress);

/// What was left as it was guessed stays as the description has it, with its reasons; the rest was chosen, and what
/// the checks say is its reason.
Description description_of(const Description& description, const ImportChoice& choice, const ImportChecks& checks);

/// The same of the table as it is now; nothing where that is cancelled. Throws Error where the manifest would have no
/// INS: none was found, or no row of the table is read.
std::optional<Description> description_to_save(const Description& description, const ImportChoice& choice,
                                               const Progress& progress);

}  // namespace remount::guesses
