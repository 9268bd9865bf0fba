// Stamps that repeat, run backwards or are no time: readers take them out as they read.
#include "model/checks/builtin.h"

namespace remount {

DataCheck stamp_check() {
  return {
      .kinds = {
          {"*-duplicate-stamps",
           "Of entries with one stamp only one is used: the best where they say how good they are, otherwise the "
           "first.",
           "See whether two recorders write into one log, or whether stamps are rounded."},
          {"*-reversed-stamps", "Entries that go back in time are left out; where they belong is not known.",
           "Check the clock of the recorder: it was set while it recorded, or messages were put in order of arrival."},
          {"*-impossible-stamps", "Entries without a possible time are left out.",
           "Declare the unit of the stamps (s, ms, us, ns) as the log has it."},
          {"bad-stamps", "Scans without a time cannot be used.",
           "Copy the file of stamps again, as it was recorded."}}};
}

}  // namespace remount
