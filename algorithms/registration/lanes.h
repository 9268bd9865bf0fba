// Eight floats at a time: one AVX register, or two of four floats where there is no AVX.
// Everything has internal linkage (see kernels_avx2.cpp).
#pragma once

#include <cstdint>

namespace remount::registration {
namespace {

constexpr int kLanes = 8;

#ifdef __AVX2__
typedef float Lanes __attribute__((vector_size(32)));
typedef std::int32_t Mask __attribute__((vector_size(32)));  // -1 where true

inline Lanes pick(Mask mask, Lanes yes, Lanes no) { return mask ? yes : no; }
inline Mask pick(Mask mask, Mask yes, Mask no) { return mask ? yes : no; }
inline Lanes smaller(Lanes a, Lanes b) { return a < b ? a : b; }
inline Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }
inline Lanes keep(Mask mask, Lanes value) { return reinterpret_cast<Lanes>(reinterpret_cast<Mask>(value) & mask); }
inline Lanes absolute(Lanes value) { return reinterpret_cast<Lanes>(reinterpret_cast<Mask>(value) & 0x7fffffff); }
inline Lanes square_root(Lanes value) { return __builtin_ia32_sqrtps256(value); }
/// Bit i is set where lane i is true.
inline unsigned bits_of(Mask mask) {
  return static_cast<unsigned>(__builtin_ia32_movmskps256(reinterpret_cast<Lanes>(mask)));
}
#else
typedef float HalfLanes __attribute__((vector_size(16)));
typedef std::int32_t HalfMask __attribute__((vector_size(16)));

struct alignas(32) Mask {
  HalfMask a, b;
  std::int32_t operator[](int i) const { return i < 4 ? a[i] : b[i - 4]; }
};

struct alignas(32) Lanes {
  HalfLanes a, b;
  float operator[](int i) const { return i < 4 ? a[i] : b[i - 4]; }
};

inline Mask operator&(const Mask& x, const Mask& y) { return {x.a & y.a, x.b & y.b}; }
inline Mask operator~(const Mask& x) { return {~x.a, ~x.b}; }
inline Mask operator+(const Mask& x, std::int32_t y) { return {x.a + y, x.b + y}; }
inline Mask operator-(const Mask& x, std::int32_t y) { return {x.a - y, x.b - y}; }
inline Mask operator>=(const Mask& x, std::int32_t y) { return {x.a >= y, x.b >= y}; }

// The four operations and the comparisons, between lanes and with one number for all.
#define REMOUNT_LANES_OPERATOR(result, op)                                                             \
  inline result operator op(const Lanes& x, const Lanes& y) { return {x.a op y.a, x.b op y.b}; }       \
  [[maybe_unused]] inline result operator op(const Lanes& x, float y) { return {x.a op y, x.b op y}; } \
  [[maybe_unused]] inline result operator op(float x, const Lanes& y) { return {x op y.a, x op y.b}; }
REMOUNT_LANES_OPERATOR(Lanes, +)
REMOUNT_LANES_OPERATOR(Lanes, -)
REMOUNT_LANES_OPERATOR(Lanes, *)
REMOUNT_LANES_OPERATOR(Lanes, /)
REMOUNT_LANES_OPERATOR(Mask, <)
REMOUNT_LANES_OPERATOR(Mask, <=)
REMOUNT_LANES_OPERATOR(Mask, >)
REMOUNT_LANES_OPERATOR(Mask, >=)
#undef REMOUNT_LANES_OPERATOR

inline Lanes operator-(const Lanes& x) { return {-x.a, -x.b}; }
inline Lanes& operator+=(Lanes& x, const Lanes& y) { return x = x + y; }
inline Lanes& operator-=(Lanes& x, const Lanes& y) { return x = x - y; }

inline HalfLanes bitwise_and(HalfLanes x, HalfMask y) {
  return reinterpret_cast<HalfLanes>(reinterpret_cast<HalfMask>(x) & y);
}
inline Lanes pick(const Mask& m, const Lanes& yes, const Lanes& no) { return {m.a ? yes.a : no.a, m.b ? yes.b : no.b}; }
inline Mask pick(const Mask& m, const Mask& yes, const Mask& no) { return {m.a ? yes.a : no.a, m.b ? yes.b : no.b}; }
inline Lanes smaller(const Lanes& x, const Lanes& y) { return {x.a < y.a ? x.a : y.a, x.b < y.b ? x.b : y.b}; }
inline Lanes larger(const Lanes& x, const Lanes& y) { return {x.a > y.a ? x.a : y.a, x.b > y.b ? x.b : y.b}; }
inline Lanes keep(const Mask& m, const Lanes& x) { return {bitwise_and(x.a, m.a), bitwise_and(x.b, m.b)}; }
inline Lanes absolute(const Lanes& x) {
  const HalfMask magnitude = HalfMask{} + 0x7fffffff;
  return {bitwise_and(x.a, magnitude), bitwise_and(x.b, magnitude)};
}
#ifdef __SSE__
inline Lanes square_root(const Lanes& x) { return {__builtin_ia32_sqrtps(x.a), __builtin_ia32_sqrtps(x.b)}; }
inline unsigned bits_of(const Mask& m) {
  return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<HalfLanes>(m.a)) |
                               (__builtin_ia32_movmskps(reinterpret_cast<HalfLanes>(m.b)) << 4));
}
#else
inline Lanes square_root(Lanes x) {
  for (int i = 0; i < 4; ++i) {
    x.a[i] = __builtin_sqrtf(x.a[i]);
    x.b[i] = __builtin_sqrtf(x.b[i]);
  }
  return x;
}
inline unsigned bits_of(const Mask& m) {
  unsigned bits = 0;
  for (int i = 0; i < kLanes; ++i) bits |= m[i] ? 1U << i : 0U;
  return bits;
}
#endif
#endif

inline Lanes load(const float* from) {
  Lanes out;
  __builtin_memcpy(&out, from, sizeof out);
  return out;
}
inline Mask load(const std::int32_t* from) {
  Mask out;
  __builtin_memcpy(&out, from, sizeof out);
  return out;
}
inline void store(float* to, const Lanes& value) { __builtin_memcpy(to, &value, sizeof value); }
inline Lanes all(float value) { return Lanes{} + value; }
inline Mask all(std::int32_t value) { return Mask{} + value; }

struct Lanes3 {
  Lanes x, y, z;
};

inline Lanes dot(const Lanes3& a, const Lanes3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Lanes3 operator+(const Lanes3& a, const Lanes3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Lanes3 operator-(const Lanes3& a, const Lanes3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Lanes3 operator-(const Lanes3& a) { return {-a.x, -a.y, -a.z}; }
inline Lanes3 keep(const Mask& mask, const Lanes3& a) { return {keep(mask, a.x), keep(mask, a.y), keep(mask, a.z)}; }
inline Lanes3 pick(const Mask& m, const Lanes3& yes, const Lanes3& no) {
  return {pick(m, yes.x, no.x), pick(m, yes.y, no.y), pick(m, yes.z, no.z)};
}

}  // namespace
}  // namespace remount::registration
