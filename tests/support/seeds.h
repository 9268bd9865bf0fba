// How many of the draws of a test are drawn: what many drives say at more length than one is for the long tests.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <vector>

namespace remount::testing {

/// Whether all of them are drawn: the environment has REMOUNT_EVERY_SEED, as it has in the long tests.
inline bool draws_all() { return std::getenv("REMOUNT_EVERY_SEED") != nullptr; }

/// The first `usual` of the draws, or all of them.
template <class Draw>
std::vector<Draw> some_of(std::initializer_list<Draw> draws, std::size_t usual = 1) {
  const std::size_t count = draws_all() ? draws.size() : std::min(usual, draws.size());
  return std::vector<Draw>(draws.begin(), draws.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace remount::testing
