// What findings say.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "algorithms/messages/render.h"
#include "model/drive/session.h"

namespace remount::testing {

/// The first of that code, or null.
inline const drive::Finding* finding_of(const std::vector<drive::Finding>& findings, std::string_view code) {
  for (const drive::Finding& finding : findings)
    if (finding.code == code) return &finding;
  return nullptr;
}

inline bool has_code(const std::vector<drive::Finding>& findings, std::string_view code) {
  return finding_of(findings, code) != nullptr;
}

/// The explanation of the first of that code; "" where there is none.
inline std::string said_of(const std::vector<drive::Finding>& findings, std::string_view code) {
  const drive::Finding* finding = finding_of(findings, code);
  return finding != nullptr ? english(finding->explanation) : "";
}

/// Expects that the first of that code says this among other things.
inline void expect_told(const std::vector<drive::Finding>& findings, std::string_view code, std::string_view part) {
  const std::string said = said_of(findings, code);
  EXPECT_NE(said.find(part), std::string::npos)
      << "expected '" << part << "' of " << code << ", which says '" << said << "'";
}

}  // namespace remount::testing
