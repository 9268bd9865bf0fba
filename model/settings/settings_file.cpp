#include "model/settings/settings_file.h"

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "messages/general.h"
#include "messages/projects.h"
#include "model/formats/documents/parse_document.h"

namespace remount::settings {

using formats::DocumentNode;

namespace {

/// Writes an option struct into a map.
struct OptionWriter {
  DocumentNode& section;
  bool comments;
  Language language;

  template <class T>
  void operator()(const OptionInfo& info, const T& value) {
    Message range;
    DocumentNode node;
    if constexpr (std::is_same_v<T, bool>) {
      node = DocumentNode::boolean(value);
      range = say::settings_switch();
    } else if constexpr (std::is_integral_v<T>) {
      node = DocumentNode::integer(value);
      range = say::settings_between(formats::shortest(info.minimum), formats::shortest(info.maximum));
    } else if constexpr (std::is_floating_point_v<T>) {
      node = DocumentNode::number(value);
      range = say::settings_between(formats::shortest(info.minimum), formats::shortest(info.maximum));
    } else {
      node = DocumentNode::string(value);
    }
    add(info, std::move(node), range);
  }

  template <class T>
  void choice(const OptionInfo& info, const T& value, const std::vector<std::string_view>& names) {
    add(info, DocumentNode::string(names.at(static_cast<std::size_t>(value))),
        say::settings_one_of({names.begin(), names.end()}));
  }

  void add(const OptionInfo& info, DocumentNode node, const Message& range) const {
    if (comments) {
      node.comment = render(info.help(), language);
      if (!range.empty())
        node.comment += " [" + render(range, language) + (info.unit.empty() ? "" : " " + std::string(info.unit)) + "]";
    }
    section.add(std::string(info.name), std::move(node));
  }
};

/// Throws Error(Format) that says what would have been a number here.
double signed_of(const formats::DocumentView& view, const OptionInfo& info) {
  try {
    return view.number();
  } catch (const Error&) {
    const std::string unit = (info.unit.empty() ? "" : " ") + std::string(info.unit);
    view.fail(say::expected_number_from_to(info.minimum, info.maximum, unit, view.described()));
  }
}

/// Half a turn is typed as 3.1416 or 3.15 rad, which is beyond it by less than half a degree: the bound is meant.
double snapped_to_bounds(const OptionInfo& info, double value) {
  constexpr double kSlack_rad = 0.5 / 57.295779513082323;
  if (info.unit != "rad") return value;
  if (value > info.maximum && value <= info.maximum + kSlack_rad) return info.maximum;
  if (value < info.minimum && value >= info.minimum - kSlack_rad) return info.minimum;
  return value;
}

std::size_t place_of(std::string_view name, const std::vector<std::string_view>& names) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// Choices that have yes and no among them were switches in former versions, whose files have true and false.
std::optional<bool> switch_of_before(const formats::DocumentView& view, const std::vector<std::string_view>& names) {
  if (place_of("yes", names) == names.size() || place_of("no", names) == names.size()) return std::nullopt;
  const std::string text = view.string();
  if (text != "true" && text != "false") return std::nullopt;
  return text == "true";
}

Message with_place(const Error& error) {
  return error.where().empty() ? error.what_happened() : say::of_file(error.where(), error.what_happened());
}

/// Reads those members of an option struct that a map mentions.
struct OptionReader {
  formats::DocumentView section;
  std::vector<Message>& problems;
  std::vector<std::string_view> known{};

  template <class T>
  void operator()(const OptionInfo& info, T& value) {
    read(info, [&](const formats::DocumentView& view) {
      if constexpr (std::is_same_v<T, bool>) {
        value = view.boolean();
      } else if constexpr (std::is_integral_v<T>) {
        value = static_cast<T>(
            view.integer(static_cast<std::int64_t>(info.minimum), static_cast<std::int64_t>(info.maximum)));
      } else if constexpr (std::is_floating_point_v<T>) {
        const double number = snapped_to_bounds(info, signed_of(view, info));
        if (number < info.minimum || number > info.maximum) view.fail(outside_bounds(info, number));
        value = number;
      } else {
        value = view.string();
      }
    });
  }

  template <class T>
  void choice(const OptionInfo& info, T& value, const std::vector<std::string_view>& names) {
    read(info, [&](const formats::DocumentView& view) {
      const std::optional<bool> was_switch = switch_of_before(view, names);
      value = static_cast<T>(was_switch ? place_of(*was_switch ? "yes" : "no", names) : view.choice(names));
    });
  }

  template <class Assign>
  void read(const OptionInfo& info, Assign&& assign) {
    known.push_back(info.name);
    if (!section.has(info.name)) return;
    try {
      assign(section.at(info.name));
    } catch (const Error& error) {
      problems.push_back(with_place(error));
    }
  }

  void report_unknown_keys() {
    // Settings of former versions that changed nothing but the sample of a bootstrap: files that hold them stay
    // readable.
    constexpr std::array<std::string_view, 2> kRetired{"bootstrap_samples", "seed"};
    const std::vector<std::string> names(known.begin(), known.end());
    for (const auto& [key, view] : section.entries()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      if (std::find(kRetired.begin(), kRetired.end(), key) != kRetired.end()) continue;
      try {
        view.fail(say::settings_unknown_key(names));
      } catch (const Error& error) {
        problems.push_back(with_place(error));
      }
    }
  }
};

/// Each value for itself; whether they go together is asked once all of them are known.
Settings read_values(const formats::DocumentView& document, const Settings& base) {
  Settings settings = base;
  std::vector<Message> problems;
  std::vector<std::string> sections;
  if (!document.is_null()) {
    const auto entries = document.entries();
    Settings::visit_sections(settings, [&](std::string_view name, auto& options) {
      sections.emplace_back(name);
      const auto found =
          std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return entry.first == name; });
      if (found == entries.end() || found->second.is_null()) return;
      try {
        OptionReader reader{found->second, problems};
        std::decay_t<decltype(options)>::visit(options, reader);
        reader.report_unknown_keys();
      } catch (const Error& error) {
        problems.push_back(with_place(error));
      }
    });
    for (const auto& [key, view] : entries) {
      if (std::find(sections.begin(), sections.end(), key) != sections.end()) continue;
      try {
        view.fail(say::settings_unknown_section(sections));
      } catch (const Error& error) {
        problems.push_back(with_place(error));
      }
    }
  }
  if (!problems.empty()) throw Error(ErrorCode::Format, "", say::settings_problems(std::move(problems)));
  return settings;
}

}  // namespace

void resolve_paths(const std::filesystem::path& folder, Settings& settings) {
  std::string& file = settings.beams.file;
  if (!file.empty()) file = std::filesystem::absolute(folder / file).lexically_normal().string();
}

DocumentNode settings_document(const Settings& settings, bool comments, Language language) {
  DocumentNode document = DocumentNode::map();
  Settings::visit_sections(settings, [&](std::string_view name, const auto& options) {
    DocumentNode section = DocumentNode::map();
    std::decay_t<decltype(options)>::visit(options, OptionWriter{section, comments, language});
    document.add(std::string(name), std::move(section));
  });
  return document;
}

Settings settings_from_document(const formats::DocumentView& document, const Settings& base) {
  const Settings settings = read_values(document, base);
  const std::vector<Message> contradictions = settings.check();
  if (!contradictions.empty()) document.fail(in_one(contradictions));
  return settings;
}

Settings load_settings(const std::filesystem::path& path, const Settings& base) {
  const DocumentNode document = formats::read_document(path);
  Settings settings = read_values(formats::DocumentView(document, path.string()), base);
  resolve_paths(std::filesystem::absolute(path).parent_path(), settings);
  return settings;
}

std::string settings_text(const Settings& settings, bool comments, Language language) {
  DocumentNode document = settings_document(settings, comments, language);
  if (comments) document.comment = render(say::settings_heading(), language);
  return formats::to_yaml(document);
}

namespace {

/// What was typed behind the equals sign, read as files are, so that both accept the same. No setting is a list or a
/// map: what is no YAML, or nothing, is a text that the setting refuses, saying what it takes.
DocumentNode typed_value(std::string_view text, const std::string& where) {
  DocumentNode value = DocumentNode::string(std::string(text));
  try {
    if (!text.empty()) value = formats::parse_yaml(text, where);
  } catch (const Error&) {
  }
  value.line = 0;
  return value;
}

}  // namespace

void apply_setting(Settings& settings, std::string_view assignment) {
  const std::string where = "--set " + std::string(assignment);
  const std::size_t equals = assignment.find('=');
  const std::size_t dot = assignment.substr(0, equals).find('.');
  if (equals == std::string_view::npos || dot == std::string_view::npos)
    throw Error(ErrorCode::Contract, where, say::settings_expected_assignment());
  DocumentNode document = DocumentNode::map();
  document.add(std::string(assignment.substr(0, dot)), DocumentNode::map())
      .add(std::string(assignment.substr(dot + 1, equals - dot - 1)),
           typed_value(assignment.substr(equals + 1), where));
  try {
    settings = read_values(formats::DocumentView(document, where), settings);
    resolve_paths({}, settings);
  } catch (const Error& error) {
    throw Error(ErrorCode::Contract, error.where(), error.what_happened());
  }
}

}  // namespace remount::settings
