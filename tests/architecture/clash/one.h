// For the law about names of types: never compiled.
#pragma once

namespace remount {

struct Candidate {
  int topic = 0;
};

}  // namespace remount
