// How many of the draws of a test are drawn: what many drives say at more length than one is for the long tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <vector>

namespace remount::testing {

/// Whether all of them are drawn: the environment has REMOUNT_EVERY_DRAW, as it has in the long tests.
inline bool draws_all() { return std::getenv("REMOUNT_EVERY_DRAW") != nullptr; }

/// The first `usual` of the draws, or all of them.
template <class Draw>
std::vector<Draw> some_of(std::initializer_list<Draw> draws, std::size_t usual = 1) {
  const std::size_t count = draws_all() ? draws.size() : std::min(usual, draws.size());
  return std::vector<Draw>(draws.begin(), draws.begin() + static_cast<std::ptrdiff_t>(count));
}

/// How many of many draws are drawn.
inline int some_of_many(int all, int usual) { return draws_all() ? all : usual; }

}  // namespace remount::testing

/// First line of a test that says at more length what another of its suite shows: it is one of the long tests.
#define ONLY_IN_LONG_TESTS() \
  if (!::remount::testing::draws_all()) GTEST_SKIP() << "one of the long tests: ctest --preset long -R every_draw"
