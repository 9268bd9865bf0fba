// How values stand in documents: what a description says of a member where its type alone does not (document_fields.h).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/core/index.h"
#include "algorithms/geometry/rigid_transform.h"
#include "model/formats/documents/document_fields.h"
#include "model/formats/documents/message_document.h"
#include "model/formats/documents/transform_document.h"

namespace remount::formats {

/// null where it is not finite, and `null_is` where it is null.
struct Number {
  double null_is = std::numeric_limits<double>::quiet_NaN();

  DocumentNode write(double value) const { return DocumentNode::number(value); }
  void read(const DocumentView& view, double& value) const { value = view.is_null() ? null_is : view.number(); }
};

/// A number that is never null.
struct Finite {
  DocumentNode write(double value) const { return DocumentNode::number(value); }
  void read(const DocumentView& view, double& value) const { value = view.number(); }
};

/// An angle that is kept in rad; null where it is not finite, and not a number where it is null.
struct Degrees {
  DocumentNode write(double value_rad) const { return DocumentNode::number(radians_to_degrees(value_rad)); }
  void read(const DocumentView& view, double& value_rad) const { value_rad = degrees_to_radians(view.number_or_nan()); }
};

/// A whole number, or an enumeration as one. Only what is read is held to the bounds.
struct Whole {
  std::int64_t minimum = 0, maximum = std::numeric_limits<std::int64_t>::max();

  template <class T>
  DocumentNode write(T value) const {
    return DocumentNode::integer(static_cast<std::int64_t>(value));
  }
  template <class T>
  void read(const DocumentView& view, T& value) const {
    value = static_cast<T>(view.integer(minimum, maximum));
  }
  template <class Counted>
  void read(const DocumentView& view, Index<Counted>& place) const {
    place = index_at<Index<Counted>>(view.integer(minimum, maximum));
  }
};

/// How many there are, or an index: what an int holds.
inline constexpr Whole kCount{0, std::numeric_limits<int>::max()};

/// An index of one of so many.
inline Whole below(std::size_t size) { return {0, signed_of(size) - 1}; }

/// An enumeration by the names of its values, in their order.
struct OneOf {
  std::vector<std::string_view> names;

  template <class T>
  DocumentNode write(T value) const {
    return DocumentNode::string(names.at(index_of(value)));
  }
  template <class T>
  void read(const DocumentView& view, T& value) const {
    value = static_cast<T>(view.choice(names));
  }
};

/// By to_string and its inverse, which has nothing for a text that it does not know; `unknown` says so.
template <class FromString, class Unknown>
struct ByName {
  FromString from_string;
  Unknown unknown;

  template <class T>
  DocumentNode write(const T& value) const {
    return DocumentNode::string(to_string(value));
  }
  template <class T>
  void read(const DocumentView& view, T& value) const {
    const std::string text = view.string();
    const auto known = from_string(text);
    if (!known) view.fail(unknown(text));
    value = *known;
  }
};
template <class FromString, class Unknown>
ByName(FromString, Unknown) -> ByName<FromString, Unknown>;

/// A value of which a function makes a node and another a value again, for what is told in a way of its own.
template <class ToDocument, class FromDocument>
struct Through {
  ToDocument to_document;
  FromDocument from_document;

  template <class T>
  DocumentNode write(const T& value) const {
    return to_document(value);
  }
  template <class T>
  void read(const DocumentView& view, T& value) const {
    value = from_document(view);
  }
};
template <class ToDocument, class FromDocument>
Through(ToDocument, FromDocument) -> Through<ToDocument, FromDocument>;

/// Translation and quaternion alone, without the notations that only people need.
inline constexpr Through kShortTransform{short_transform_document, transform_from_document};

/// null where there is none.
template <class How>
struct OrNull {
  How how;

  template <class T>
  DocumentNode write(const std::optional<T>& value) const {
    return value ? how.write(*value) : DocumentNode::null();
  }
  template <class T>
  void read(const DocumentView& view, std::optional<T>& value) const {
    value.reset();
    if (!view.is_null()) how.read(view, value.emplace());
  }
};
template <class How>
OrNull(How) -> OrNull<How>;

/// A text that is null where it is empty.
struct TextOrNull {
  DocumentNode write(const std::string& text) const {
    return text.empty() ? DocumentNode::null() : DocumentNode::string(text);
  }
  void read(const DocumentView& view, std::string& text) const { text = view.is_null() ? "" : view.string(); }
};

/// Numbers on one line, null where one is not finite.
struct Numbers {
  DocumentNode write(const std::vector<double>& numbers) const { return DocumentNode::numbers(numbers); }
  void read(const DocumentView& view, std::vector<double>& numbers) const {
    numbers.clear();
    for (const DocumentView& item : view.items()) numbers.push_back(item.number_or_nan());
  }
};

/// Values one after another; of more than `most` the first are written.
template <class How>
struct ListOf {
  How how;
  std::size_t most = std::numeric_limits<std::size_t>::max();

  template <class T>
  DocumentNode write(const std::vector<T>& values) const {
    DocumentNode list = DocumentNode::sequence();
    for (const T& value : values) {
      if (list.items.size() == most) break;
      list.add(how.write(value));
    }
    return list;
  }
  template <class T>
  void read(const DocumentView& view, std::vector<T>& values) const {
    values.clear();
    for (const DocumentView& item : view.items()) {
      T value{};
      how.read(item, value);
      values.push_back(std::move(value));
    }
  }
};
template <class How>
ListOf(How) -> ListOf<How>;
template <class How>
ListOf(How, std::size_t) -> ListOf<How>;

template <>
struct Notation<double> : Number {};
template <>
struct Notation<int> : Whole {
  constexpr Notation() : Whole(kCount) {}
};
template <class Counted>
struct Notation<Index<Counted>> : Whole {
  constexpr Notation() : Whole(kCount) {}
};
template <>
struct Notation<std::uint64_t> : Whole {};
/// Of either sign: a stamp.
template <>
struct Notation<std::int64_t> : Whole {
  constexpr Notation() : Whole{-std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::max()} {}
};

template <>
struct Notation<bool> {
  DocumentNode write(bool value) const { return DocumentNode::boolean(value); }
  void read(const DocumentView& view, bool& value) const { value = view.boolean(); }
};

template <>
struct Notation<std::string> {
  DocumentNode write(const std::string& text) const { return DocumentNode::string(text); }
  void read(const DocumentView& view, std::string& text) const { text = view.string(); }
};

template <>
struct Notation<Message> {
  DocumentNode write(const Message& message) const { return message_document(message); }
  void read(const DocumentView& view, Message& message) const { message = message_from_document(view); }
};

template <>
struct Notation<RigidTransform> {
  DocumentNode write(const RigidTransform& a_from_b) const { return transform_document(a_from_b); }
  void read(const DocumentView& view, RigidTransform& a_from_b) const { a_from_b = transform_from_document(view); }
};

/// As many numbers as it has rows, all finite.
template <int rows>
struct Notation<Eigen::Matrix<double, rows, 1>> {
  using Vector = Eigen::Matrix<double, rows, 1>;
  DocumentNode write(const Vector& vector) const { return DocumentNode::numbers({vector.begin(), vector.end()}); }
  void read(const DocumentView& view, Vector& vector) const {
    vector = Eigen::Map<const Vector>(view.numbers(static_cast<std::size_t>(rows)).data());
  }
};

template <class T>
struct Notation<std::optional<T>> : OrNull<Notation<T>> {};

template <class T>
struct Notation<std::vector<T>> : ListOf<Notation<T>> {};
template <>
struct Notation<std::vector<double>> : Numbers {};

}  // namespace remount::formats
