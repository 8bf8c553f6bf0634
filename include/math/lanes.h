// Lanes: several doubles at once, as many as one instruction of this translation unit takes.
//
// A lane does what a double does: + - * / and the functions of number.h are the same IEEE
// operations, so that a formula that is a template over its number type gives the same bits for
// Doubles as for double. Comparisons give a Mask, one truth a lane; where a lane is a NaN all but
// != are false, as for a double.
//
// The same names mean different instructions in different translation units, and must never be
// linked together: so they stand in an inline namespace of the instruction set, and a template
// over Doubles is another one for each. A translation unit that is compiled for one may not use any
// other inline function that computes, not of the standard library either.
//
// Here are the intrinsics for doubles (those for the floats of trees: src/accel/simd.h): first the
// few operations that the compiler's own vectors have no good words for, once for each instruction
// set, then the classes, which are the same for all.
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace lanes {
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define RAYTRACER_LANES_AVX512
inline namespace avx512 {
constexpr int kDoubles = 8;
#elif defined(__AVX2__)
#define RAYTRACER_LANES_AVX2
inline namespace avx2 {
constexpr int kDoubles = 4;
#else
inline namespace baseline {
constexpr int kDoubles = 2;
#endif

typedef double Vector __attribute__((vector_size(kDoubles * 8)));
typedef std::int64_t Signed __attribute__((vector_size(kDoubles * 8)));
typedef std::uint64_t Wholes __attribute__((vector_size(kDoubles * 8)));
typedef float Floats __attribute__((vector_size(kDoubles * 4)));

inline Vector withoutSign(Vector a) { return Vector(Signed(a) & INT64_MAX); }

// For each instruction set:
//   Truths               what a comparison gives, one for each lane
//   mixed(where, a, b)   a where `where` holds, else b
//   leastOf, mostOf      b where b < a, or a < b; else a
//   rootOf, floorOf      the square root; the largest whole number that is not above it
//   bitsOfTruths         a bit for each lane that holds, lane 0 lowest; truthsOfBits: the way back
//   packed(a, bits)      the lanes whose bits are set, side by side; behind them stands anything
//   packRows(rows, bits, out)      the same of half words in memory
#if defined(RAYTRACER_LANES_AVX512)

// The forms without a mask begin from an undefined vector, of which g++ 12 warns.
constexpr __mmask8 kAll = 0xff;
using Truths = __mmask8;
inline Truths isLess(Vector a, Vector b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
inline Truths isLessOrEqual(Vector a, Vector b) { return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ); }
inline Truths isEqual(Vector a, Vector b) { return _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ); }
inline Vector mixed(Truths where, Vector a, Vector b) { return _mm512_mask_blend_pd(where, b, a); }
inline Vector leastOf(Vector a, Vector b) { return _mm512_maskz_min_pd(kAll, b, a); }
inline Vector mostOf(Vector a, Vector b) { return _mm512_maskz_max_pd(kAll, b, a); }
inline Vector rootOf(Vector a) { return _mm512_maskz_sqrt_pd(kAll, a); }
inline Vector floorOf(Vector a) {
  return _mm512_maskz_roundscale_pd(kAll, a, _MM_FROUND_TO_NEG_INF);
}
inline unsigned bitsOfTruths(Truths where) { return where; }
inline Truths truthsOfBits(unsigned bits) { return Truths(bits); }
inline Vector packed(Vector a, unsigned bits) { return _mm512_maskz_compress_pd(Truths(bits), a); }
inline void packRows(const std::uint16_t* rows, unsigned bits, std::uint16_t* out) {
  const __m256i wide = _mm256_cvtepu16_epi32(_mm_loadu_si128((const __m128i*)rows));
  const __m256i taken = _mm256_maskz_compress_epi32(__mmask8(bits), wide);
  _mm_storeu_si128((__m128i*)out, _mm256_cvtepi32_epi16(taken));
}

#else

using Truths = Signed;  // all bits of a lane, or none
inline Truths isLess(Vector a, Vector b) { return a < b; }
inline Truths isLessOrEqual(Vector a, Vector b) { return a <= b; }
inline Truths isEqual(Vector a, Vector b) { return a == b; }

#if defined(RAYTRACER_LANES_AVX2)

inline Vector mixed(Truths where, Vector a, Vector b) {
  return _mm256_blendv_pd(b, a, __m256d(where));
}
inline Vector leastOf(Vector a, Vector b) { return _mm256_min_pd(b, a); }
inline Vector mostOf(Vector a, Vector b) { return _mm256_max_pd(b, a); }
inline Vector rootOf(Vector a) { return _mm256_sqrt_pd(a); }
inline Vector floorOf(Vector a) { return _mm256_floor_pd(a); }
inline unsigned bitsOfTruths(Truths where) { return unsigned(_mm256_movemask_pd(__m256d(where))); }
inline Truths truthsOfBits(unsigned bits) { return (Truths{1, 2, 4, 8} & std::int64_t(bits)) != 0; }
inline Vector packed(Vector a, unsigned bits) {
  // For each set of bits the halves of doubles that are taken, a digit each, the first one lowest.
  static constexpr std::uint32_t kHalves[16] = {0x00000000, 0x00000010, 0x00000032, 0x00003210,
                                                0x00000054, 0x00005410, 0x00005432, 0x00543210,
                                                0x00000076, 0x00007610, 0x00007632, 0x00763210,
                                                0x00007654, 0x00765410, 0x00765432, 0x76543210};
  const __m256i digits = _mm256_srlv_epi32(_mm256_set1_epi32(int(kHalves[bits])),
                                           _mm256_setr_epi32(0, 4, 8, 12, 16, 20, 24, 28));
  return Vector(_mm256_permutevar8x32_ps(__m256(a), digits));
}
inline void packRows(const std::uint16_t* rows, unsigned bits, std::uint16_t* out) {
  // For each set of bits the bytes that are taken, the first one lowest.
  static constexpr std::uint64_t kBytes[16] = {
      0x0000000000000000, 0x0000000000000100, 0x0000000000000302, 0x0000000003020100,
      0x0000000000000504, 0x0000000005040100, 0x0000000005040302, 0x0000050403020100,
      0x0000000000000706, 0x0000000007060100, 0x0000000007060302, 0x0000070603020100,
      0x0000000007060504, 0x0000070605040100, 0x0000070605040302, 0x0706050403020100};
  const __m128i bytes = _mm_loadl_epi64((const __m128i*)(kBytes + bits));
  const __m128i taken = _mm_shuffle_epi8(_mm_loadl_epi64((const __m128i*)rows), bytes);
  _mm_storel_epi64((__m128i*)out, taken);
}

#else

inline Vector mixed(Truths where, Vector a, Vector b) {
  return Vector((where & Signed(a)) | (~where & Signed(b)));
}
#if defined(__SSE2__)
inline Vector leastOf(Vector a, Vector b) { return _mm_min_pd(b, a); }
inline Vector mostOf(Vector a, Vector b) { return _mm_max_pd(b, a); }
inline Vector rootOf(Vector a) { return _mm_sqrt_pd(a); }
inline unsigned bitsOfTruths(Truths where) { return unsigned(_mm_movemask_pd(__m128d(where))); }
#else
inline Vector leastOf(Vector a, Vector b) { return mixed(b < a, b, a); }
inline Vector mostOf(Vector a, Vector b) { return mixed(a < b, b, a); }
inline Vector rootOf(Vector a) { return Vector{__builtin_sqrt(a[0]), __builtin_sqrt(a[1])}; }
inline unsigned bitsOfTruths(Truths where) {
  return unsigned(where[0] & 1) | unsigned(where[1] & 2);
}
#endif
inline Vector floorOf(Vector a) {
  // From 2^52 on all doubles are whole; below, adding 2^52 rounds to the nearest whole number.
  const Vector size = withoutSign(a), nearestSize = (size + 0x1p52) - 0x1p52;
  const Vector nearest = Vector(Signed(nearestSize) | (Signed(a) & INT64_MIN));
  return mixed(size < 0x1p52, mixed(a < nearest, nearest - 1, nearest), a);
}
inline Truths truthsOfBits(unsigned bits) { return (Truths{1, 2} & std::int64_t(bits)) != 0; }
inline Vector packed(Vector a, unsigned bits) { return Vector{bits == 2 ? a[1] : a[0], a[1]}; }
inline void packRows(const std::uint16_t* rows, unsigned bits, std::uint16_t* out) {
  out[0] = rows[bits == 2 ? 1 : 0];
  out[1] = rows[1];
}

#endif
#endif

/// Lane by lane true or false.
class Mask {
 public:
  Mask() = default;
  explicit Mask(bool all) : Mask(ofBits(all ? (1u << kDoubles) - 1 : 0)) {}
  explicit Mask(Truths truths) : truths_(truths) {}
  /// Of one bit a lane, lane 0 lowest.
  static Mask ofBits(unsigned bits) { return Mask(truthsOfBits(bits)); }

  unsigned bits() const { return bitsOfTruths(truths_); }
  Truths truths() const { return truths_; }

  friend Mask operator&(Mask a, Mask b) { return Mask(Truths(a.truths_ & b.truths_)); }
  friend Mask operator|(Mask a, Mask b) { return Mask(Truths(a.truths_ | b.truths_)); }
  friend Mask operator!(Mask a) { return Mask(Truths(~a.truths_)); }

 private:
  Truths truths_;
};

inline bool any(const Mask& where) { return where.bits() != 0; }

/// kDoubles doubles. Not initialised by default, as a double is not.
class Doubles {
 public:
  using Mask = lanes::Mask;
  using Wholes = lanes::Wholes;

  Doubles() = default;
  /// The same in every lane.
  Doubles(double x) : v_(x - Vector{}) {}  // x + 0 is not x where that is -0
  Doubles(const Vector& v) : v_(v) {}
  static Doubles fromBits(const Wholes& bits) { return Vector(bits); }

  /// As many numbers as there are lanes, from any address.
  static Doubles load(const double* from) {
    Doubles a;
    __builtin_memcpy(&a.v_, from, sizeof a.v_);
    return a;
  }
  /// column[rows[0]], column[rows[1]] ...
  static Doubles gather(const double* column, const std::uint16_t* rows) {
    return gathered(column, rows, std::make_index_sequence<kDoubles>());
  }
  void store(double* to) const { __builtin_memcpy(to, &v_, sizeof v_); }

  double operator[](int lane) const { return v_[lane]; }
  const Vector& vector() const { return v_; }

  friend Doubles operator+(const Doubles& a, const Doubles& b) { return a.v_ + b.v_; }
  friend Doubles operator-(const Doubles& a, const Doubles& b) { return a.v_ - b.v_; }
  friend Doubles operator*(const Doubles& a, const Doubles& b) { return a.v_ * b.v_; }
  friend Doubles operator/(const Doubles& a, const Doubles& b) { return a.v_ / b.v_; }
  friend Doubles operator-(const Doubles& a) { return -a.v_; }
  friend Mask operator<(const Doubles& a, const Doubles& b) { return Mask(isLess(a.v_, b.v_)); }
  friend Mask operator>(const Doubles& a, const Doubles& b) { return Mask(isLess(b.v_, a.v_)); }
  friend Mask operator<=(const Doubles& a, const Doubles& b) {
    return Mask(isLessOrEqual(a.v_, b.v_));
  }
  friend Mask operator>=(const Doubles& a, const Doubles& b) {
    return Mask(isLessOrEqual(b.v_, a.v_));
  }
  friend Mask operator==(const Doubles& a, const Doubles& b) { return Mask(isEqual(a.v_, b.v_)); }
  friend Mask operator!=(const Doubles& a, const Doubles& b) { return !(a == b); }
  friend Doubles smaller(const Doubles& a, const Doubles& b) { return leastOf(a.v_, b.v_); }
  friend Doubles larger(const Doubles& a, const Doubles& b) { return mostOf(a.v_, b.v_); }

 private:
  /// All lanes at once: in a loop each waited for the one before it (0.95 of the time of tracing,
  /// with AVX-512).
  template <std::size_t... kLanes>
  static Doubles gathered(const double* column, const std::uint16_t* rows,
                          std::index_sequence<kLanes...>) {
    return Vector{column[rows[kLanes]]...};
  }

  Vector v_;
};

// The other functions of number.h.
inline Doubles choose(const Mask& where, const Doubles& a, const Doubles& b) {
  return mixed(where.truths(), a.vector(), b.vector());
}
inline Doubles absolute(const Doubles& a) { return withoutSign(a.vector()); }
inline Doubles squareRoot(const Doubles& a) { return rootOf(a.vector()); }
inline Doubles roundedDown(const Doubles& a) { return floorOf(a.vector()); }
inline Wholes bitsOf(const Doubles& a) { return Wholes(a.vector()); }

inline Floats toFloats(const Doubles& a) { return __builtin_convertvector(a.vector(), Floats); }
inline Doubles toDoubles(const Floats& a) { return __builtin_convertvector(a, Vector); }
inline Doubles roundedToFloat(const Doubles& a) { return toDoubles(toFloats(a)); }

/// Stores the lanes whose bits are set one after the other and returns where they end. Writes as
/// many numbers as there are lanes.
inline double* compress(const Doubles& a, unsigned bits, double* out) {
  Doubles(packed(a.vector(), bits)).store(out);
  return out + __builtin_popcount(bits);
}

/// The same of rows[0 .. kDoubles).
inline std::uint16_t* compressRows(const std::uint16_t* rows, unsigned bits, std::uint16_t* out) {
  packRows(rows, bits, out);
  return out + __builtin_popcount(bits);
}

#undef RAYTRACER_LANES_AVX512
#undef RAYTRACER_LANES_AVX2
}  // namespace
}  // namespace lanes
