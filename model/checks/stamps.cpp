// Stamps that repeat, run backwards or are no time: readers take them out as they read.
#include "messages/checks.h"
#include "model/checks/builtin.h"

namespace remount::checks {

DataCheck stamp_check() {
  return {.kinds = {{"*-duplicate-stamps", say::any_duplicate_stamps_meaning, say::any_duplicate_stamps_remedy},
                    {"*-reversed-stamps", say::any_reversed_stamps_meaning, say::any_reversed_stamps_remedy},
                    {"*-impossible-stamps", say::any_impossible_stamps_meaning, say::any_impossible_stamps_remedy},
                    {"bad-stamps", say::bad_stamps_meaning, say::bad_stamps_remedy}}};
}

}  // namespace remount::checks
