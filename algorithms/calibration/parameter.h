// The six parameters of a mounting by name, and values and sets of them.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/core/index.h"
#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/messages/message.h"

namespace remount::calibration {

/// x, y, z (m), yaw, pitch, roll (rad), in the order of rows of a parameter covariance. A perturbation [dt; phi] has
/// another order: its last three are turns about x, y and z.
enum class Parameter { X, Y, Z, Yaw, Pitch, Roll };
inline constexpr std::array<Parameter, 6> kParameters{Parameter::X,   Parameter::Y,     Parameter::Z,
                                                      Parameter::Yaw, Parameter::Pitch, Parameter::Roll};

/// Its row in a vector or covariance of parameters.
constexpr int row_of(Parameter parameter) { return static_cast<int>(parameter); }
constexpr bool is_angle(Parameter parameter) { return parameter >= Parameter::Yaw; }

/// "x", "y", "z", "yaw", "pitch", "roll": for files and the command line.
std::string_view to_string(Parameter parameter);
std::optional<Parameter> parameter_from_string(std::string_view text);
/// The same for people.
Message parameter_word(Parameter parameter);

/// A value for each parameter.
template <class T>
class PerParameter {
 public:
  constexpr T& operator[](Parameter parameter) { return values_[index_of(parameter)]; }
  constexpr const T& operator[](Parameter parameter) const { return values_[index_of(parameter)]; }
  constexpr void fill(const T& value) { values_.fill(value); }
  friend bool operator==(const PerParameter&, const PerParameter&) = default;

 private:
  std::array<T, 6> values_{};
};

class ParameterSet {
 public:
  constexpr ParameterSet() = default;
  constexpr ParameterSet(std::initializer_list<Parameter> parameters) {
    for (const Parameter parameter : parameters) insert(parameter);
  }
  static constexpr ParameterSet all() { return ~ParameterSet(); }

  constexpr bool contains(Parameter parameter) const { return (bits_ & bit(parameter)) != 0; }
  constexpr void insert(Parameter parameter) { bits_ |= bit(parameter); }
  constexpr void erase(Parameter parameter) { bits_ &= ~bit(parameter); }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr bool is_all() const { return bits_ == kAllBits; }

  friend constexpr ParameterSet operator~(ParameterSet set) { return of_bits(~set.bits_ & kAllBits); }
  friend constexpr ParameterSet operator&(ParameterSet a, ParameterSet b) { return of_bits(a.bits_ & b.bits_); }
  friend constexpr bool operator==(ParameterSet a, ParameterSet b) = default;

 private:
  static constexpr unsigned kAllBits = 0x3f;
  static constexpr unsigned bit(Parameter parameter) { return 1U << static_cast<unsigned>(parameter); }
  static constexpr ParameterSet of_bits(unsigned bits) {
    ParameterSet out;
    out.bits_ = bits;
    return out;
  }

  unsigned bits_ = 0;
};
inline constexpr ParameterSet kPositionParameters{Parameter::X, Parameter::Y, Parameter::Z};
inline constexpr ParameterSet kAttitudeParameters{Parameter::Yaw, Parameter::Pitch, Parameter::Roll};

/// Those of the set in words.
std::vector<Message> parameter_words(ParameterSet set);
/// "x, y, yaw": the same for files; empty for none.
std::string parameter_names(ParameterSet set);

/// The parameters of a transform between any two frames, m and rad; and the transform that has them.
PerParameter<double> parameters_of(const RigidTransform& a_from_b);
RigidTransform rigid_of(const PerParameter<double>& parameters);

/// `found`, but for the parameters of `kept`, which are as `other` has them; the very bits of `found` where none is.
RigidTransform with_kept(const RigidTransform& found, const RigidTransform& other, ParameterSet kept);

}  // namespace remount::calibration
