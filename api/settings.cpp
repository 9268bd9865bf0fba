#include "remount/settings.h"

#include <algorithm>

#include "api/bridge.h"
#include "api/option_list.h"
#include "messages/programs.h"
#include "model/formats/documents/document.h"
#include "model/settings/settings_file.h"

namespace remount::api {

std::string text_of(const OptionValue& value) {
  if (const bool* choice = std::get_if<bool>(&value)) return *choice ? "true" : "false";
  if (const std::int64_t* number = std::get_if<std::int64_t>(&value)) return std::to_string(*number);
  if (const double* number = std::get_if<double>(&value)) return formats::shortest(*number);
  return std::get<std::string>(value);
}

Settings::Settings() : settings_(std::make_shared<const settings::Settings>()) {}
Settings::Settings(const settings::Settings& settings)
    : settings_(std::make_shared<const settings::Settings>(settings)) {}

Settings Settings::load(const std::filesystem::path& path) {
  return guarded([&] {
    const settings::Settings settings = settings::load_settings(path);
    settings::require_valid(settings);
    return Settings(settings);
  });
}

void Settings::set(std::string_view name, const OptionValue& value) {
  guarded([&] {
    settings::Settings changed = *settings_;
    try {
      settings::apply_setting(changed, std::string(name) + "=" + text_of(value), "");
    } catch (const remount::Error& error) {
      throw remount::Error(remount::ErrorCode::Contract, "settings", error.message());
    }
    settings_ = std::make_shared<const settings::Settings>(std::move(changed));
  });
}

OptionValue Settings::get(std::string_view name) const {
  std::vector<Option> options = all();
  const auto option = std::find_if(options.begin(), options.end(), [&](const Option& one) { return one.name == name; });
  if (option == options.end()) throw Error(ErrorCode::Contract, std::string(name), Text(say::api_no_such_setting()));
  return option->value;
}

std::vector<Option> Settings::all() const {
  std::vector<Option> options;
  settings::Settings::visit_sections(*settings_, [&](std::string_view section, const auto& members) {
    std::decay_t<decltype(members)>::visit(members, OptionLister{std::string(section) + ".", options});
  });
  return options;
}

std::string Settings::text(Language language) const {
  return settings::settings_text(
      *settings_, true, language == Language::Chinese ? remount::Language::Chinese : remount::Language::English);
}

}  // namespace remount::api
