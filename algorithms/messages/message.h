// What is said to users, as a value: which sentence of the catalogue it is, and what stands in its places. Words are
// made of it where they are shown or written, in the language of whoever reads them (render.h); nothing compares or
// cuts them. Messages are made by the typed functions of namespace remount::say that the build writes from
// resources/messages/.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "algorithms/messages/quantity.h"

namespace remount {

struct Argument;

class Message {
 public:
  /// Says nothing.
  Message();
  // Defined where an argument is known whole, for each of the two holds the other.
  Message(const Message& other);
  Message(Message&& other) noexcept;
  Message& operator=(const Message& other);
  Message& operator=(Message&& other) noexcept;
  ~Message();
  /// For the generated makers and for readers of files. @param code of the catalogue, or of a later version's
  Message(std::string_view code, std::vector<Argument> arguments);

  /// Words that somebody typed, or that another program gave: shown as they are, in every language. Of ours only those
  /// of a contract that no input breaks.
  static Message verbatim(std::string words);
  /// Several that follow each other, as sentences do.
  static Message sequence(std::vector<Message> messages);

  bool empty() const { return code_.empty(); }
  const std::string& code() const { return code_; }
  const std::vector<Argument>& arguments() const { return arguments_; }
  /// @return null where no place has that name
  const Argument* argument(std::string_view name) const;

  friend bool operator==(const Message& a, const Message& b);

 private:
  std::string code_;
  std::vector<Argument> arguments_;
};

/// A number with the unit that it is kept in: metres, radians, seconds and what is made of them.
enum class Dimension { Number, Length, Angle, Duration, Speed, TurnRate, Acceleration, Frequency, Share, Bytes };
struct Quantity {
  Dimension dimension = Dimension::Number;
  double value = 0.0;

  /// Not a number is like itself here: what is not known is the same in both.
  friend bool operator==(const Quantity& a, const Quantity& b) {
    return a.dimension == b.dimension && (a.value == b.value || (a.value != a.value && b.value != b.value));
  }
};

/// What stands in a place: a quantity, a count, a name as it is, names, a message, or several.
struct Argument {
  using Value =
      std::variant<Quantity, std::int64_t, std::string, std::vector<std::string>, Message, std::vector<Message>>;

  std::string name;
  Value value;

  friend bool operator==(const Argument& a, const Argument& b) = default;
};

inline Argument::Value value_of(Length length) { return Quantity{Dimension::Length, length.m}; }
inline Argument::Value value_of(Angle angle) { return Quantity{Dimension::Angle, angle.rad}; }
inline Argument::Value value_of(Duration time) { return Quantity{Dimension::Duration, time.s}; }
inline Argument::Value value_of(Speed speed) { return Quantity{Dimension::Speed, speed.mps}; }
inline Argument::Value value_of(TurnRate rate) { return Quantity{Dimension::TurnRate, rate.radps}; }
inline Argument::Value value_of(Acceleration change) { return Quantity{Dimension::Acceleration, change.mps2}; }
inline Argument::Value value_of(Frequency rate) { return Quantity{Dimension::Frequency, rate.hz}; }
inline Argument::Value value_of(Share part) { return Quantity{Dimension::Share, part.of_one}; }
inline Argument::Value value_of(Bytes size) { return Quantity{Dimension::Bytes, static_cast<double>(size.bytes)}; }
inline Argument::Value value_of(double number) { return Quantity{Dimension::Number, number}; }
inline Argument::Value value_of(Count count) { return count.number; }
inline Argument::Value value_of(std::string words) { return words; }
inline Argument::Value value_of(std::vector<std::string> names) { return names; }
inline Argument::Value value_of(Message message) { return message; }
inline Argument::Value value_of(std::vector<Message> messages) { return messages; }

}  // namespace remount
