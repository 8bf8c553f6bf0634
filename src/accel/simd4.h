// Four floats at once, for the builder: SSE2 where there is one, else the compiler's own vectors.
// Only what every x86-64 has is used, so that all translation units see the same functions.
// smaller and larger return the second argument where the first is a NaN, on every processor.
#pragma once
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace accel {

#if defined(__SSE2__)

struct Float4 {
  __m128 v;

  static Float4 load(const float* p) { return {_mm_loadu_ps(p)}; }
  static Float4 all(float x) { return {_mm_set1_ps(x)}; }
  static Float4 of(float x, float y, float z) { return {_mm_setr_ps(x, y, z, 0)}; }
  void store(float* p) const { _mm_storeu_ps(p, v); }
};

struct Int4 {
  __m128i v;

  static Int4 load(const std::int32_t* p) {
    return {_mm_loadu_si128(reinterpret_cast<const __m128i*>(p))};
  }
  static Int4 all(std::int32_t x) { return {_mm_set1_epi32(x)}; }
  void store(std::int32_t* p) const { _mm_storeu_si128(reinterpret_cast<__m128i*>(p), v); }
};

inline Float4 operator+(Float4 a, Float4 b) { return {_mm_add_ps(a.v, b.v)}; }
inline Float4 operator-(Float4 a, Float4 b) { return {_mm_sub_ps(a.v, b.v)}; }
inline Float4 operator*(Float4 a, Float4 b) { return {_mm_mul_ps(a.v, b.v)}; }
inline Float4 smaller(Float4 a, Float4 b) { return {_mm_min_ps(a.v, b.v)}; }
inline Float4 larger(Float4 a, Float4 b) { return {_mm_max_ps(a.v, b.v)}; }
/// The first three lanes; the fourth becomes 0.
inline Float4 firstThree(Float4 a) {
  return {_mm_and_ps(a.v, _mm_castsi128_ps(_mm_setr_epi32(-1, -1, -1, 0)))};
}
/// `a` where `mask` is 0; a NaN in every lane where it is -1, which smaller and larger pass over.
inline Float4 unlessMasked(Float4 a, std::int32_t mask) {
  return {_mm_or_ps(a.v, _mm_castsi128_ps(_mm_set1_epi32(mask)))};
}
/// Rows become columns.
inline void transpose(Float4& a, Float4& b, Float4& c, Float4& d) {
  _MM_TRANSPOSE4_PS(a.v, b.v, c.v, d.v);
}
/// `a` where x < y, else `b`.
inline Float4 whereLess(Float4 x, Float4 y, Float4 a, Float4 b) {
  const __m128 less = _mm_cmplt_ps(x.v, y.v);
  return {_mm_or_ps(_mm_and_ps(less, a.v), _mm_andnot_ps(less, b.v))};
}
inline Int4 operator+(Int4 a, Int4 b) { return {_mm_add_epi32(a.v, b.v)}; }
inline Int4 shiftedRight(Int4 a, int bits) { return {_mm_srli_epi32(a.v, bits)}; }
/// Rounded towards zero.
inline Int4 toInt(Float4 a) { return {_mm_cvttps_epi32(a.v)}; }
inline Float4 toFloat(Int4 a) { return {_mm_cvtepi32_ps(a.v)}; }

#else

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
  a.v[3] = 0;
  return a;
}
/// `a` where `mask` is 0; a NaN in every lane where it is -1, which smaller and larger pass over.
inline Float4 unlessMasked(Float4 a, std::int32_t mask) {
  Int4::Lanes bits;
  std::memcpy(&bits, &a.v, sizeof bits);
  bits |= mask;
  std::memcpy(&a.v, &bits, sizeof bits);
  return a;
}
/// Rows become columns.
inline void transpose(Float4& a, Float4& b, Float4& c, Float4& d) {
  const Float4 rows[4] = {a, b, c, d};
  for (int i = 0; i < 4; ++i) {
    a.v[i] = rows[i].v[0];
    b.v[i] = rows[i].v[1];
    c.v[i] = rows[i].v[2];
    d.v[i] = rows[i].v[3];
  }
}
/// `a` where x < y, else `b`.
inline Float4 whereLess(Float4 x, Float4 y, Float4 a, Float4 b) { return {x.v < y.v ? a.v : b.v}; }
inline Int4 operator+(Int4 a, Int4 b) { return {a.v + b.v}; }
inline Int4 shiftedRight(Int4 a, int bits) { return {a.v >> bits}; }
/// Rounded towards zero.
inline Int4 toInt(Float4 a) {
  return {Int4::Lanes{std::int32_t(a.v[0]), std::int32_t(a.v[1]), std::int32_t(a.v[2]),
                      std::int32_t(a.v[3])}};
}
inline Float4 toFloat(Int4 a) {
  return {Float4::Lanes{float(a.v[0]), float(a.v[1]), float(a.v[2]), float(a.v[3])}};
}

#endif

/// Starts to bring the cache line of `address` near; any address will do.
inline void prefetch(const void* address) { __builtin_prefetch(address); }

}  // namespace accel
