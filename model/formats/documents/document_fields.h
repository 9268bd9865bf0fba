// Records that are written and read by one description, which names each key with its member once:
//
//   void describe(RecordOf<Wheel> auto& wheel, auto& fields) {
//     fields("name", wheel.name);
//     fields("radius_m", wheel.radius_m, Finite{});
//     fields("steers_by_deg", wheel.steers_by_rad, Degrees{});
//     fields.later("spare", wheel.spare);
//   }
//
// document_of(wheel) is then a map of these keys in this order, and read_fields(view, wheel) reads one. How a value
// stands in a document says a notation (notations.h); most follow from its type.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "model/formats/documents/document.h"

namespace remount::formats {

/// Record, or const Record where it is written.
template <class T, class Record>
concept RecordOf = std::same_as<std::remove_const_t<T>, Record>;

/// How a value of a type stands where a description says nothing else: `DocumentNode write(const T&) const`, and
/// `void read(const DocumentView&, T&) const`, which throws Error(Format). A map by describe() unless it is
/// specialised.
template <class T>
struct Notation;

/// What a description is given where a record is written.
class FieldWriter {
 public:
  explicit FieldWriter(DocumentNode& map) : map_(map) {}

  /// The map is written on one line.
  void on_one_line() { map_.on_one_line = true; }

  /// A key that every file has.
  template <class T, class How = Notation<T>>
  void operator()(std::string_view key, const T& value, const How& how = {}) {
    map_.add(std::string(key), how.write(value));
  }

  /// A key that files of former versions lack: the value is then left as it is.
  template <class T, class How = Notation<T>>
  void later(std::string_view key, const T& value, const How& how = {}) {
    (*this)(key, value, how);
  }

  /// The same where the value is then what `otherwise()` says.
  template <class T, class Otherwise>
  void later_or(std::string_view key, const T& value, const Otherwise&) {
    (*this)(key, value);
  }

  /// A key that is written only where `worth_it`; the value is left as it is where it is not there.
  template <class T, class How = Notation<T>>
  void where(bool worth_it, std::string_view key, const T& value, const How& how = {}) {
    if (worth_it) (*this)(key, value, how);
  }

  /// A key that is there where the value is.
  template <class T, class How = Notation<T>>
  void optional(std::string_view key, const std::optional<T>& value, const How& how = {}) {
    if (value) (*this)(key, *value, how);
  }

  /// Keys of a notation that is a map, among those of the record.
  template <class T, class How>
  void spread(const T& value, const How& how) {
    DocumentNode keys = how.write(value);
    for (std::size_t i = 0; i < keys.items.size(); ++i) map_.add(std::move(keys.keys[i]), std::move(keys.items[i]));
  }

  /// What people and other programs are told and nothing reads back.
  void only_written(std::string_view key, DocumentNode value) { map_.add(std::string(key), std::move(value)); }

  /// Refuses what was read into the record unless `holds`: at the key, or at the map itself.
  void require(bool, std::string_view, Message (*)()) {}
  void require(bool, Message (*)()) {}

 private:
  DocumentNode& map_;
};

/// What a description is given where a record is read. Throws Error(Format) with the place.
class FieldReader {
 public:
  explicit FieldReader(const DocumentView& map) : map_(map) {}

  void on_one_line() {}

  template <class T, class How = Notation<T>>
  void operator()(std::string_view key, T& value, const How& how = {}) {
    how.read(map_.at(key), value);
  }

  template <class T, class How = Notation<T>>
  void later(std::string_view key, T& value, const How& how = {}) {
    if (map_.has(key)) (*this)(key, value, how);
  }

  template <class T, class Otherwise>
  void later_or(std::string_view key, T& value, const Otherwise& otherwise) {
    if (map_.has(key))
      (*this)(key, value);
    else
      value = otherwise();
  }

  template <class T, class How = Notation<T>>
  void where(bool, std::string_view key, T& value, const How& how = {}) {
    later(key, value, how);
  }

  template <class T, class How = Notation<T>>
  void optional(std::string_view key, std::optional<T>& value, const How& how = {}) {
    if (map_.has(key)) (*this)(key, value.emplace(), how);
  }

  template <class T, class How>
  void spread(T& value, const How& how) {
    how.read(map_, value);
  }

  void only_written(std::string_view, const DocumentNode&) {}

  void require(bool holds, std::string_view key, Message (*problem)()) {
    if (!holds) map_.at(key).fail(problem());
  }
  void require(bool holds, Message (*problem)()) {
    if (!holds) map_.fail(problem());
  }

 private:
  const DocumentView& map_;
};

/// What a description is given where it is asked which keys it has: all that a file can have, in their order.
struct FieldKeys {
  std::vector<std::string> keys;

  void on_one_line() {}
  void operator()(std::string_view key, const auto&...) { keys.emplace_back(key); }
  void later(std::string_view key, const auto&...) { keys.emplace_back(key); }
  void later_or(std::string_view key, const auto&...) { keys.emplace_back(key); }
  void where(bool, std::string_view key, const auto&...) { keys.emplace_back(key); }
  void optional(std::string_view key, const auto&...) { keys.emplace_back(key); }
  void spread(const auto& value, const auto& how) {
    for (const std::string& key : how.write(value).keys) keys.push_back(key);
  }
  void only_written(std::string_view key, const DocumentNode&) { keys.emplace_back(key); }
  void require(bool, const auto&...) {}
};

/// A map of what a description says: `description(value, fields)`.
template <class Description>
struct MapOf {
  Description description;

  template <class T>
  DocumentNode write(const T& value) const {
    DocumentNode map = DocumentNode::map();
    FieldWriter fields(map);
    description(value, fields);
    return map;
  }

  template <class T>
  void read(const DocumentView& view, T& value) const {
    FieldReader fields(view);
    description(value, fields);
  }

  /// Throws Error(Format) where there is a key that the description does not have.
  template <class T>
  void allow_no_others(const DocumentView& view, const T& value) const {
    FieldKeys fields;
    description(value, fields);
    view.allow_only({fields.keys.begin(), fields.keys.end()});
  }
};
template <class Description>
MapOf(Description) -> MapOf<Description>;

/// The description that describe() is of its record.
struct Described {
  void operator()(auto& record, auto& fields) const { describe(record, fields); }
};

template <class T>
struct Notation : MapOf<Described> {};

/// A record, or a list of them.
template <class Record>
DocumentNode document_of(const Record& record) {
  return Notation<Record>().write(record);
}

/// Throws Error(Format) with the place; the record is then read in part.
template <class Record>
void read_fields(const DocumentView& view, Record& record) {
  Notation<Record>().read(view, record);
}

}  // namespace remount::formats
