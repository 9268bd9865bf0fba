#include "model/guesses/table_import.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/guesses.h"
#include "messages/table_import.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"
#include "model/formats/poses/pose_file.h"
#include "model/guesses/clock_guess.h"
#include "model/guesses/column_units.h"
#include "model/guesses/table_guess.h"

namespace remount::guesses {

namespace fs = std::filesystem;

namespace {

/// The first lines with values.
std::vector<std::vector<std::string>> first_rows_of(const SampledTable& table, std::string_view text) {
  constexpr std::size_t kMostRows = 6, kLongestField = 60;
  const std::size_t first_line = table.text.skip_lines + (table.named ? 2 : 1);
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string_view> fields;
  formats::LineReader lines(text);
  for (std::string_view line; rows.size() < kMostRows && lines.next(line);) {
    if (lines.line_number() < first_line || formats::trim(line).empty() || line.starts_with('#')) continue;
    formats::split_declared(line, table.text, fields);
    std::vector<std::string>& row = rows.emplace_back();
    for (std::size_t i = 0; i < std::min(fields.size(), table.columns.size()); ++i)
      row.emplace_back(fields[i].substr(0, kLongestField));
  }
  return rows;
}

/// The columns that are named so, for a comment.
template <std::size_t N>
std::vector<std::string> labels_of(const SampledTable& table, const TableChoices& choices,
                                   const std::array<ColumnRole, N>& roles) {
  std::vector<std::string> labels;
  for (const ColumnRole role : roles)
    if (const auto column = choices.column(role)) labels.push_back(table.label(*column));
  return labels;
}

std::vector<Message> evidence_of(const ImportChecks& checks, std::initializer_list<CheckKind> kinds) {
  std::vector<Message> evidence;
  for (const CheckKind kind : kinds)
    if (const ImportCheck* check = checks.find(kind))
      evidence.insert(evidence.end(), check->evidence.begin(), check->evidence.end());
  return evidence;
}

/// What is said of a table that somebody changed.
class ChosenIns {
 public:
  ChosenIns(const ImportTable& table, const TableChoices& choices, const ImportChecks& checks)
      : table_(table), choices_(choices), checks_(checks) {}

  InsGuess ins(formats::InsTableLayout layout) {
    ins_.file = table_.file;
    ins_.layout = std::move(layout);
    ins_.samples = checks_.samples;
    ins_.span = checks_.span;
    ins_.stretches = checks_.stretches;
    ins_.week_open = checks_.week_open;
    const TableChoices& preset = table_.preset;
    const bool time = same_time(choices_, preset);
    add(GuessKind::Rows, time, kTimeRoles, {CheckKind::Rows, CheckKind::Rate});
    if (!ins_.guesses.empty()) ins_.guesses.back().columns.clear();
    add(GuessKind::Time, time, kTimeRoles, {});
    add(GuessKind::Position, same_position(choices_, preset), kPositionRoles, {CheckKind::Position, CheckKind::Height});
    add(GuessKind::Attitude, same_attitude(choices_, preset), kAttitudeRoles, {CheckKind::Heading, CheckKind::Pitch});
    if (ins_.layout.position_sigma_enu)
      add(GuessKind::PositionSigma, same_columns(choices_, preset, kPositionSigmaRoles), kPositionSigmaRoles, {});
    if (ins_.layout.attitude_sigma_yaw_pitch_roll)
      add(GuessKind::AttitudeSigma, same_columns(choices_, preset, kAttitudeSigmaRoles), kAttitudeSigmaRoles, {});
    if (ins_.layout.quality) add(GuessKind::Quality, same_columns(choices_, preset, kQualityRoles), kQualityRoles, {});
    return std::move(ins_);
  }

 private:
  template <std::size_t N>
  void add(GuessKind kind, bool as_guessed, const std::array<ColumnRole, N>& roles,
           std::initializer_list<CheckKind> kinds) {
    const bool has_layout = table_.guess && !table_.guess->pose_format;
    if (as_guessed && has_layout)
      if (const auto found = std::ranges::find(table_.guess->guesses, kind, &Guess::kind);
          found != table_.guess->guesses.end()) {
        ins_.guesses.push_back(*found);
        return;
      }
    ins_.guesses.push_back({kind,
                            labels_of(table_.table, choices_, roles),
                            "",
                            kind == GuessKind::Rows ? Sureness::Checked : Sureness::Chosen,
                            evidence_of(checks_, kinds),
                            {}});
  }

  const ImportTable& table_;
  const TableChoices& choices_;
  const ImportChecks& checks_;
  InsGuess ins_;
};

/// Those that are read from the table of the INS, too: they would move with it by definition.
std::set<std::size_t> lidars_of(const Description& description, const fs::path& file) {
  std::set<std::size_t> lidars;
  for (std::size_t i = 0; i < description.lidars.size(); ++i)
    if (description.lidars[i].directory == file) lidars.insert(i);
  return lidars;
}

std::set<std::size_t> all_left_out(const Description& description, const ImportChoice& choice) {
  std::set<std::size_t> left_out = choice.left_out;
  if (choice.table) left_out.merge(lidars_of(description, choice.table->file));
  return left_out;
}

void leave_out_lidars(const std::set<std::size_t>& left_out, Description& description) {
  std::vector<ScansGuess> kept;
  for (std::size_t i = 0; i < description.lidars.size(); ++i) {
    if (left_out.contains(i))
      description.not_used.push_back({description.lidars[i].directory, say::guess_left_out_by_hand()});
    else
      kept.push_back(std::move(description.lidars[i]));
  }
  description.lidars = std::move(kept);
}

bool as_guessed(const Description& description, const ImportChoice& choice) {
  return choice.left_out.empty() && (!choice.table || (description.ins && description.ins->file == choice.table->file &&
                                                       choice.table->guess && choice.choices == choice.table->preset));
}

/// Of files that name no columns; those of the others say what they are.
void show_as_poses(std::string_view format, TableChoices& choices) {
  constexpr std::array kPoses{ColumnRole::Time, ColumnRole::East, ColumnRole::North, ColumnRole::Height,
                              ColumnRole::Qx,   ColumnRole::Qy,   ColumnRole::Qz,    ColumnRole::Qw};
  const bool plain = format == to_string(formats::PoseFormat::Tum) || format == to_string(formats::PoseFormat::EthCsv);
  if (!plain || choices.roles.size() != kPoses.size()) return;
  choices = {};
  choices.roles.assign(kPoses.begin(), kPoses.end());
  choices.attitude = AttitudeStyle::QuaternionEnu;
}

fs::path folder_of(const std::vector<fs::path>& paths) {
  for (const fs::path& path : paths)
    if (formats::is_folder(path)) return path;
  return paths.empty() ? fs::path() : fs::absolute(paths.front()).parent_path();
}

}  // namespace

bool is_of_lidar(const Description& description, const fs::path& file) { return !lidars_of(description, file).empty(); }

ImportTable import_table(const fs::path& file, const Description& description, const Progress& progress) {
  const std::string text = formats::read_text_file(file);
  auto sampled = sample_table(file, text);
  if (!sampled) throw Error(ErrorCode::Format, file.string(), say::import_no_table());
  ImportTable import;
  import.file = file;
  import.first_rows = first_rows_of(*sampled, text);
  const FoundTable found{file, std::move(*sampled)};
  const std::vector<std::int64_t> stamps_ns = stamps_of(description, {});
  if (description.ins && description.ins->file == file && !description.ins->attitude) {
    import.guess = description.ins;
  } else if (import.guess = guess_ins_of(found, stamps_ns, progress, import.lacks); import.guess) {
    place_in_week(*import.guess, stamps_ns);
  } else {
    import.guess = poses_as_ins(file);
  }
  if (import.guess && !import.guess->log && !import.guess->pose_format) {
    import.preset = choices_of(found.table, import.guess->layout);
  } else {
    const auto time = choose_time(found.table, names_of(found.table), stamps_ns);
    import.preset = choices_by_names(found.table, time ? std::optional(time->reading) : std::nullopt);
    if (import.guess && import.guess->pose_format) show_as_poses(*import.guess->pose_format, import.preset);
  }
  import.table = found.table;
  for (SampledColumn& column : import.table.columns) column.values = {};
  return import;
}

ImportData look_for_import(const std::vector<fs::path>& paths, Progress& progress,
                           const std::optional<fs::path>& meant) {
  ImportData data;
  DescribedTables looked_at = look_at_data(paths, progress, KnownFormats::Told);
  if (looked_at.description.known) {
    data.opens_as = looked_at.description.known->what;
    looked_at = look_at_data(paths, progress, KnownFormats::PassedOver);
  }
  data.description = std::move(looked_at.description);
  data.folder = folder_of(paths);
  const Description& found = data.description;
  // Poses of a LiDAR may be meant as those of the INS.
  const auto of_scans = [&](const fs::path& file) {
    return std::ranges::any_of(
        found.lidars, [&](const ScansGuess& lidar) { return lidar.directory != file && is_of_scans(lidar, file); });
  };
  for (const FoundTable& table : looked_at.tables)
    if (table.table.columns.size() >= kFewestColumnsOfMotion && !of_scans(table.file))
      data.tables.push_back(table.file);
  looked_at.tables.clear();
  std::optional<fs::path> first;
  const auto is_lidars = [&](const fs::path& file) { return is_of_lidar(found, file); };
  const auto is_meant = [&](const fs::path& file) {
    std::error_code error;
    return meant && fs::equivalent(file, *meant, error);
  };
  if (const auto chosen = std::ranges::find_if(data.tables, is_meant); chosen != data.tables.end())
    first = *chosen;
  else if (found.ins)
    first = found.ins->log || found.ins->attitude ? std::nullopt : std::optional(found.ins->file);
  else if (const auto other = std::ranges::find_if_not(data.tables, is_lidars); other != data.tables.end())
    first = *other;
  if (first && !progress.cancelled()) data.table = import_table(*first, found, progress);
  return data;
}

std::vector<std::int64_t> stamps_of(const Description& description, const std::set<std::size_t>& left_out) {
  std::vector<std::int64_t> stamps_ns;
  for (std::size_t i = 0; i < description.lidars.size(); ++i)
    if (!left_out.contains(i))
      stamps_ns.insert(stamps_ns.end(), description.lidars[i].stamps_ns.begin(), description.lidars[i].stamps_ns.end());
  std::ranges::sort(stamps_ns);
  return stamps_ns;
}

namespace {

CheckKind check_of(ColumnRole role) {
  if (role == ColumnRole::Time) return CheckKind::Rate;
  if (role == ColumnRole::Height || role == ColumnRole::Down) return CheckKind::Height;
  return is_one_of(role, kAttitudeRoles) || is_one_of(role, kAttitudeSigmaRoles) ? CheckKind::Heading
                                                                                 : CheckKind::Position;
}

/// The check of what a column is about says that its title states another unit.
void doubt_units(const SampledTable& table, const TableChoices& choices, ImportChecks& checks) {
  for (const OtherUnit& other : other_units(table, choices)) {
    const auto check = std::ranges::find(checks.checks, check_of(other.role), &ImportCheck::kind);
    if (check == checks.checks.end()) continue;
    check->verdict = std::max(check->verdict, Verdict::Doubtful);
    check->evidence.push_back(say::import_unit_is_other(table.label(other.column), other.stated, other.read));
  }
}

}  // namespace

ImportChecks check_choice(const Description& description, const ImportChoice& choice, const Progress& progress) {
  const ImportTable& table = *choice.table;
  InsGuess ins{.file = table.file};
  const bool as_poses = table.guess && table.guess->pose_format && choice.choices == table.preset;
  if (as_poses) {
    ins.pose_format = table.guess->pose_format;
  } else {
    std::vector<Message> lacks;
    auto layout = layout_of(table.table, choice.choices, lacks);
    if (!layout) return unreadable(std::move(lacks));
    ins.layout = std::move(*layout);
  }
  ImportChecks checks =
      check_import(ins, table.table.rows, stamps_of(description, all_left_out(description, choice)), progress);
  if (!as_poses) doubt_units(table.table, choice.choices, checks);
  return checks;
}

Description description_of(const Description& description, const ImportChoice& choice, const ImportChecks& checks) {
  Description made = description;
  if (as_guessed(description, choice)) return made;
  leave_out_lidars(all_left_out(description, choice), made);
  if (choice.table) {
    const ImportTable& table = *choice.table;
    if (made.ins && made.ins->file != table.file)
      made.not_used.push_back({made.ins->file, say::guess_other_was_chosen()});
    std::erase_if(made.not_used, [&](const NotUsed& one) { return one.path == table.file; });
    std::vector<Message> lacks;
    auto layout = layout_of(table.table, choice.choices, lacks);
    const bool untouched = table.guess && choice.choices == table.preset;
    made.ins.reset();
    if (untouched)
      made.ins = table.guess;
    else if (layout && checks.samples > 0)
      made.ins = ChosenIns(table, choice.choices, checks).ins(std::move(*layout));
  }
  made.missing = what_is_missing(made);
  made.clock = made.ins ? guess_clock(*made.ins, made.lidars) : std::nullopt;
  return made;
}

std::optional<Description> description_to_save(const Description& description, const ImportChoice& choice,
                                               const Progress& progress) {
  ImportChecks checks;
  if (choice.table) checks = check_choice(description, choice, progress);
  if (progress.cancelled()) return std::nullopt;
  Description made = description_of(description, choice, checks);
  if (choice.table && (!made.ins || checks.samples == 0))
    throw Error(ErrorCode::Format, choice.table->file.string(), say::import_nothing_to_save());
  if (!made.ins)
    throw Error(ErrorCode::Format, made.lidars.empty() ? "" : made.lidars.front().directory.string(),
                say::guess_needs_ins());
  return made;
}

}  // namespace remount::guesses
