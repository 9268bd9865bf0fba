// Settings as YAML: configuration files, the settings part of projects and results, and single "section.key=value".
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/messages/catalogue.h"
#include "model/formats/documents/document.h"
#include "model/settings/settings.h"

namespace remount::settings {

/// Every setting with its present value, in a fixed order; with `comments`, each with its unit, range and meaning
/// in that language.
formats::DocumentNode settings_document(const Settings& settings, bool comments = false,
                                        Language language = Language::English);

/// Makes paths that are relative to the folder, empty: the current one, absolute: they stay what they mean when the
/// settings go elsewhere, into a project, a result or another program.
void resolve_paths(const std::filesystem::path& folder, Settings& settings);

/// Sets what the document mentions and keeps the rest of `base`. Throws Error(Format) that lists every problem with
/// its line: an unknown section or key, a wrong type, a value out of range, a minimum above its maximum.
Settings settings_from_document(const formats::DocumentView& document, const Settings& base = {});

/// A configuration file (YAML or JSON). Throws Error(Io) where it cannot be read, otherwise as above, except that
/// values that contradict each other are left to require_valid(): what else is set may yet resolve that. Paths in it
/// are relative to its folder, and absolute in what is returned.
Settings load_settings(const std::filesystem::path& path, const Settings& base = {});

/// The text of a configuration file that load_settings reads back to the same settings.
std::string settings_text(const Settings& settings, bool comments = true, Language language = Language::English);

/// Sets one value from "section.key=value". Throws Error(Contract) where that names nothing or does not fit;
/// contradictions are left to require_valid(). A path is relative to the current folder, and becomes absolute.
void apply_setting(Settings& settings, std::string_view assignment);
/// The same; errors are at `where`.
void apply_setting(Settings& settings, std::string_view assignment, const std::string& where);

}  // namespace remount::settings
