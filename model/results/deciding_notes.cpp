#include "model/results/deciding_notes.h"

#include <algorithm>

namespace remount::results {

bool is_deciding(const drive::Finding& finding) {
  return finding.severity == drive::Severity::Note &&
         std::find(kDecidingNotes.begin(), kDecidingNotes.end(), finding.code) != kDecidingNotes.end();
}

}  // namespace remount::results
