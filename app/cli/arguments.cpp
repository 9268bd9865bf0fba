#include "app/cli/arguments.h"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/command_help.h"
#include "messages/command_line.h"
#include "model/formats/documents/document.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/input_file.h"
#include "model/results/exporters/exporter.h"
#include "model/settings/settings_file.h"

namespace remount::cli {
namespace {

[[noreturn]] void wrong_range(const std::string& text) {
  throw Error(ErrorCode::Contract, "--range " + text, say::cli_expected_range());
}

/// The bounds of SearchRange's members in its own order: minimum and maximum of x, y, z, yaw, pitch, roll.
struct BoundsReader {
  std::vector<std::pair<double, double>>& bounds;
  void operator()(const OptionInfo& info, double&) { bounds.emplace_back(info.minimum, info.maximum); }
};

/// In the units that were typed, before anything becomes radians. Throws Error(Contract).
void check_typed(calibration::SearchRange& range, std::size_t parameter, double minimum, double maximum,
                 const std::string& where) {
  std::vector<std::pair<double, double>> bounds;
  calibration::SearchRange::visit(range, BoundsReader{bounds});
  const auto typed = [&](double bound) { return parameter < 3 ? bound : radians_to_degrees(bound); };
  const OptionInfo info{.name = to_string(calibration::kParameters.at(parameter)),
                        .unit = parameter < 3 ? "m" : "deg",
                        .minimum = typed(bounds[2 * parameter].first),
                        .maximum = typed(bounds[2 * parameter].second)};
  for (const double value : {minimum, maximum})
    if (value < info.minimum || value > info.maximum)
      throw Error(ErrorCode::Contract, where, say::cli_outside(std::string(info.name), outside_bounds(info, value)));
  if (minimum > maximum)
    throw Error(ErrorCode::Contract, where,
                parameter < 3 ? say::cli_lengths_reversed(std::string(info.name), Length{minimum}, Length{maximum})
                              : say::cli_angles_reversed(std::string(info.name), Angle{degrees_to_radians(minimum)},
                                                         Angle{degrees_to_radians(maximum)}));
}

void set_range(calibration::SearchRange& range, std::size_t parameter, const std::string& pair,
               const std::string& whole) {
  const std::array<std::pair<double*, double*>, 6> members{{{&range.x_min_m, &range.x_max_m},
                                                            {&range.y_min_m, &range.y_max_m},
                                                            {&range.z_min_m, &range.z_max_m},
                                                            {&range.yaw_min_rad, &range.yaw_max_rad},
                                                            {&range.pitch_min_rad, &range.pitch_max_rad},
                                                            {&range.roll_min_rad, &range.roll_max_rad}}};
  const std::vector<std::string> ends = split(pair, ':');
  if (ends.size() != 2) wrong_range(whole);
  const auto minimum = formats::parse_number(ends[0]), maximum = formats::parse_number(ends[1]);
  if (!minimum || !maximum) wrong_range(whole);
  check_typed(range, parameter, *minimum, *maximum, "--range " + whole);
  *members[parameter].first = parameter < 3 ? *minimum : degrees_to_radians(*minimum);
  *members[parameter].second = parameter < 3 ? *maximum : degrees_to_radians(*maximum);
}

}  // namespace

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

RigidTransform parse_six(const std::string& text) {
  std::vector<double> six;
  for (const std::string& part : split(text, ','))
    if (const auto value = formats::parse_number(formats::trim(part))) six.push_back(*value);
  if (six.size() != 6 || split(text, ',').size() != 6) throw Error(ErrorCode::Contract, text, say::cli_expected_six());
  return results::rigid_from_typed({six[0], six[1], six[2], six[3], six[4], six[5]}, text, ErrorCode::Contract);
}

std::optional<FormatFile> file_of_format(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return {};
  for (const auto& format : results::exporters())
    if (text.substr(0, colon) == format->id()) return FormatFile{*format, text.substr(colon + 1)};
  return {};
}

results::ReadMounting parse_nominal(const std::string& text, std::vector<Message>& doubts) {
  std::error_code none;
  if (formats::is_file(text)) return results::read_any_mounting(text, &doubts);
  if (std::filesystem::exists(text, none)) return results::read_any_mounting(text);  // which says why it cannot
  const std::size_t colon = text.find(':');
  const std::string before = text.substr(0, colon == std::string::npos ? 0 : colon);
  if (const auto frame = calibration::frame_from_string(before);
      frame == calibration::BodyFrame::Vehicle || frame == calibration::BodyFrame::Machine)
    return {parse_six(text.substr(colon + 1)), {}, {*frame, std::nullopt}};
  if (const std::optional<FormatFile> named = file_of_format(text))
    return results::read_mounting_as(named->format, named->file, &doubts);
  if (text.find(',') == std::string::npos) throw Error(ErrorCode::Io, text, say::cli_neither_file_nor_six());
  return {parse_six(text), {}, {}};
}

results::ReadMounting parse_ins_nominal(const std::string& text, std::vector<Message>& doubts) {
  results::ReadMounting mounting = parse_nominal(text, doubts);
  if (const Message problem = results::not_in_ins_frame(mounting.frames); !problem.empty())
    throw Error(ErrorCode::Contract, text, problem);
  return mounting;
}

void apply_range(calibration::SearchRange& range, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  const bool named = text.find('=') != std::string::npos;
  if (!named && parts.size() != 6) wrong_range(text);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!named) {
      set_range(range, i, parts[i], text);
      continue;
    }
    const std::vector<std::string> sides = split(parts[i], '=');
    const std::optional<calibration::Parameter> parameter = calibration::parameter_from_string(formats::trim(sides[0]));
    if (sides.size() != 2 || !parameter) wrong_range(text);
    set_range(range, index_of(*parameter), sides[1], text);
  }
}

void apply_measured(calibration::MeasuredOptions& options, const std::string& text) {
  const std::array<std::tuple<std::string_view, double*, double*>, 7> members{
      {{"x", &options.x_m, &options.x_sigma_m},
       {"y", &options.y_m, &options.y_sigma_m},
       {"z", &options.z_m, &options.z_sigma_m},
       {"yaw", &options.yaw_deg, &options.yaw_sigma_deg},
       {"pitch", &options.pitch_deg, &options.pitch_sigma_deg},
       {"roll", &options.roll_deg, &options.roll_sigma_deg},
       {kMeasuredInsHeight, &options.ins_height_m, &options.ins_height_sigma_m}}};
  const std::vector<std::string> sides = split(text, '=');
  const std::vector<std::string> numbers = split(sides.back(), ',');
  const auto value = formats::parse_number(formats::trim(numbers.front())),
             sigma = formats::parse_number(formats::trim(numbers.back()));
  const auto member = std::find_if(members.begin(), members.end(), [&](const auto& named) {
    return std::get<0>(named) == formats::trim(sides.front());
  });
  if (sides.size() != 2 || numbers.size() != 2 || !value || !sigma || !(*sigma > 0.0) || member == members.end())
    throw Error(ErrorCode::Contract, "--measured " + text, say::cli_expected_measured());
  *std::get<1>(*member) = *value;
  *std::get<2>(*member) = *sigma;
}

void TopicArguments::add_to(CLI::App& verb, const Console& console) {
  verb.add_option("--topic", topics,
                  console.words(say::help_topic({drive::kTopicRoles.begin(), drive::kTopicRoles.end()})))
      ->type_name("ROLE=TOPIC")
      ->allow_extra_args(false);
}

drive::TopicChoice TopicArguments::choice() const {
  drive::TopicChoice choice;
  for (const std::string& text : topics) drive::add_topic_choice(choice, text);
  return choice;
}

void SolveArguments::add_to(CLI::App& verb, const Console& console) {
  verb.add_option("--nominal", nominals, console.words(say::help_nominal()))
      ->type_name("SIX|FILE")
      ->allow_extra_args(false);
  verb.add_option("--range", ranges, console.words(say::help_range()))->type_name("RANGE")->allow_extra_args(false);
  verb.add_option("--measured", measured, console.words(say::help_measured()))
      ->type_name("NAME=VALUE,SIGMA")
      ->allow_extra_args(false);
  verb.add_option("--config", config, console.words(say::help_config()))->type_name("FILE");
  verb.add_option("--set", assignments, console.words(say::help_set()))->type_name("SETTING")->allow_extra_args(false);
  verb.add_option("-o,--output", output, console.words(say::help_result_to_write()))->type_name("RESULT");
}

settings::Settings SolveArguments::settings(const settings::Settings& base) const {
  settings::Settings settings = config.empty() ? base : settings::load_settings(config, base);
  for (const std::string& assignment : assignments) settings::apply_setting(settings, assignment);
  for (const std::string& range : ranges) apply_range(settings.range, range);
  std::set<std::string> names;
  for (const std::string& text : measured) {
    apply_measured(settings.measured, text);
    const std::string name(formats::trim(split(text, '=').front()));
    if (!names.insert(name).second) throw Error(ErrorCode::Contract, "--measured " + text, say::cli_given_twice(name));
  }
  settings::require_valid(settings);
  return settings;
}

std::optional<results::ReadMounting> SolveArguments::nominal_mounting(Console& console) const {
  if (nominals.size() > 1) throw Error(ErrorCode::Contract, nominals.back(), say::cli_given_twice("--nominal"));
  if (nominals.empty() || nominals.front() == "none") return std::nullopt;
  std::vector<Message> doubts;
  const results::ReadMounting mounting = parse_nominal(nominals.front(), doubts);
  for (const Message& doubt : doubts) console.warn(doubt);
  return mounting;
}

void SolveArguments::check_output(void (*check_replaces)(const std::filesystem::path&)) const {
  if (output.empty()) return;
  const std::filesystem::path path(output);
  const auto ending = path.extension();
  if (ending != ".yaml" && ending != ".yml" && ending != ".json")
    throw Error(ErrorCode::Contract, "--output " + output, say::cli_expected_result_name());
  check_replaces(path);
  formats::check_can_save(path);
}

}  // namespace remount::cli
