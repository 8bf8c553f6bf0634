// Four floats at once, for the builder, by the compiler's own vectors: SSE2 or NEON where there is
// one. Only what every processor of its kind has is used, so that all translation units see the
// same functions. smaller and larger return the second argument where the first is a NaN, on every
// processor; where they are one instruction, compilers know.
#pragma once
#include <cstdint>
#include <cstring>

namespace accel {

struct Float4 {
  typedef float Lanes __attribute__((vector_size(16)));
  Lanes v;

  static Float4 load(const float* p) {
    Float4 result;
    std::memcpy(&result.v, p, sizeof result.v);
    return result;
  }
  static Float4 all(float x) { return {Lanes{x, x, x, x}}; }
  static Float4 of(float x, float y, float z) { return {Lanes{x, y, z, 0}}; }
  void store(float* p) const { std::memcpy(p, &v, sizeof v); }
};

struct Int4 {
  typedef std::int32_t Lanes __attribute__((vector_size(16)));
  Lanes v;

  static Int4 load(const std::int32_t* p) {
    Int4 result;
    std::memcpy(&result.v, p, sizeof result.v);
    return result;
  }
  static Int4 all(std::int32_t x) { return {Lanes{x, x, x, x}}; }
  void store(std::int32_t* p) const { std::memcpy(p, &v, sizeof v); }
};

inline Float4 operator+(Float4 a, Float4 b) { return {a.v + b.v}; }
inline Float4 operator-(Float4 a, Float4 b) { return {a.v - b.v}; }
inline Float4 operator*(Float4 a, Float4 b) { return {a.v * b.v}; }
inline Float4 smaller(Float4 a, Float4 b) { return {a.v < b.v ? a.v : b.v}; }
inline Float4 larger(Float4 a, Float4 b) { return {a.v > b.v ? a.v : b.v}; }
/// The first three lanes; the fourth becomes 0.
inline Float4 firstThree(Float4 a) {
  return {Float4::Lanes(Int4::Lanes(a.v) & Int4::Lanes{-1, -1, -1, 0})};
}
/// `a` where `mask` is 0; a NaN in every lane where it is -1, which smaller and larger pass over.
inline Float4 unlessMasked(Float4 a, std::int32_t mask) {
  return {Float4::Lanes(Int4::Lanes(a.v) | mask)};
}
/// `a` where x < y, else `b`.
inline Float4 whereLess(Float4 x, Float4 y, Float4 a, Float4 b) { return {x.v < y.v ? a.v : b.v}; }
inline Int4 operator+(Int4 a, Int4 b) { return {a.v + b.v}; }
inline Int4 shiftedRight(Int4 a, int bits) { return {a.v >> bits}; }
/// Rounded towards zero.
inline Int4 toInt(Float4 a) { return {__builtin_convertvector(a.v, Int4::Lanes)}; }
inline Float4 toFloat(Int4 a) { return {__builtin_convertvector(a.v, Float4::Lanes)}; }

/// Starts to bring the cache line of `address` near; any address will do.
inline void prefetch(const void* address) { __builtin_prefetch(address); }

}  // namespace accel
