// Places in lists, a type for each kind of list: the place of a keyframe is none of a session.
#pragma once

#include <cassert>
#include <compare>
#include <concepts>
#include <cstddef>
#include <type_traits>

namespace remount {

/// Where something of the kind `Counted` stands in the list of all of them. It is used as it is where a list is asked
/// (`keyframes[pair.keyframe_a]`), but made of a number only where that is written, and never of a place in another
/// list. There is no place for "none": what may be absent is a std::optional.
template <class Counted>
class Index {
 public:
  constexpr Index() = default;
  constexpr explicit Index(std::size_t place) : place_(place) {}
  /// Of a number of which is known that it is none before the first.
  constexpr explicit Index(int place) : place_(static_cast<std::size_t>(place)) { assert(place >= 0); }

  template <class Other>
  requires(!std::same_as<Other, Counted>) explicit Index(Index<Other>) = delete;

  constexpr operator std::size_t() const { return place_; }
  explicit operator bool() const = delete;  // the first is a place like any other

  constexpr Index& operator++() { return ++place_, *this; }
  constexpr Index operator++(int) { return Index(place_++); }

  friend constexpr bool operator==(Index, Index) = default;
  friend constexpr std::strong_ordering operator<=>(Index, Index) = default;

 private:
  std::size_t place_ = 0;
};

/// Places in different lists have nothing to do with each other.
template <class A, class B>
requires(!std::same_as<A, B>) bool operator==(Index<A>, Index<B>) = delete;
template <class A, class B>
requires(!std::same_as<A, B>) std::strong_ordering operator<=>(Index<A>, Index<B>) = delete;

/// How far apart places are may be negative: signed_of() of both. A sum of two places is none.
template <class A, class B>
std::size_t operator-(Index<A>, Index<B>) = delete;
template <class A, class B>
std::size_t operator+(Index<A>, Index<B>) = delete;

/// Where what is told of each value of an enumeration stands in an array: in the order in which they are declared.
template <class Enum>
requires std::is_enum_v<Enum>
constexpr std::size_t index_of(Enum value) { return static_cast<std::size_t>(value); }

/// Where a cell of a grid stands in the list of all, which are listed row by row. None of the numbers is negative.
constexpr std::size_t cell_at(int row, int column, int columns) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
}

/// How many cells a grid has.
constexpr std::size_t cell_count(int rows, int columns) { return cell_at(rows, 0, columns); }

/// A place or a size as a signed number: for rows of matrices, for files and for differences.
constexpr std::ptrdiff_t signed_of(std::size_t place) { return static_cast<std::ptrdiff_t>(place); }

/// The place that a row of a table, a number in a file or an Eigen::Index tells, of which is known that it is none
/// before the first.
template <class Place = std::size_t>
constexpr Place index_at(std::ptrdiff_t number) {
  assert(number >= 0);
  return Place(static_cast<std::size_t>(number));
}

}  // namespace remount
