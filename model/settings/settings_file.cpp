#include "model/settings/settings_file.h"

#include <algorithm>
#include <type_traits>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "messages/projects.h"
#include "model/formats/documents/parse_document.h"
#include "model/settings/option_reader.h"

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
        OptionReader reader(found->second, problems);
        std::decay_t<decltype(options)>::visit(options, reader);
        reader.report_unknown_keys();
      } catch (const Error& error) {
        problems.push_back(error.message());
      }
    });
    for (const auto& [key, view] : entries) {
      if (std::find(sections.begin(), sections.end(), key) != sections.end()) continue;
      try {
        view.fail(say::settings_unknown_section(sections));
      } catch (const Error& error) {
        problems.push_back(error.message());
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

void apply_setting(Settings& settings, std::string_view assignment) {
  apply_setting(settings, assignment, "--set " + std::string(assignment));
}

void apply_setting(Settings& settings, std::string_view assignment, const std::string& where) {
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
