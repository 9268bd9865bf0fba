#include "model/drive/bad_items.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "messages/sessions.h"

namespace remount::drive {
namespace {

TEST(bad_items, one_bad_item_is_spoken_of_in_the_singular) {
  std::vector<Finding> findings;
  BadItems bad;
  bad.add(Message::verbatim("a.bin: is missing"));
  bad.report(findings, "missing-scans", "data", say::left_out_scans);
  EXPECT_EQ(english(findings.back().explanation), "1 scan cannot be used and is left out. First: a.bin: is missing");
  bad.add(Message::verbatim("b.bin: is missing"));
  bad.report(findings, "missing-scans", "data", say::left_out_scans);
  EXPECT_EQ(english(findings.back().explanation), "2 scans cannot be used and are left out. First: a.bin: is missing");
}

}  // namespace
}  // namespace remount::drive
