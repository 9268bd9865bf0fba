// Words of session.yaml of which one is chosen.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "messages/sessions.h"
#include "model/formats/documents/document.h"

namespace remount::formats {

[[noreturn]] inline void fail_choice(const DocumentView& node, std::vector<std::string> choices) {
  node.fail(say::native_not_one_of(node.string().substr(0, 60), std::move(choices)));
}

/// The value of `node` among named choices.
template <class Value>
Value choice(const DocumentView& node, std::initializer_list<std::pair<std::string_view, Value>> choices) {
  const std::string text = node.string();
  std::vector<std::string> names;
  for (const auto& [name, value] : choices) {
    if (name == text) return value;
    names.emplace_back(name);
  }
  fail_choice(node, std::move(names));
}

}  // namespace remount::formats
