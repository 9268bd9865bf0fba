#include "model/results/deciding_notes.h"

#include <algorithm>

namespace remount {

bool is_deciding(const Finding& finding) {
  return finding.severity == Severity::Note &&
         std::find(kDecidingNotes.begin(), kDecidingNotes.end(), finding.code) != kDecidingNotes.end();
}

}  // namespace remount
