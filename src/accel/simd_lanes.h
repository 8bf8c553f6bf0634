// Lanes: as many rays of a packet as one instruction takes; sixteen with AVX-512, else eight.
// Included by the kernels only, after simd.h and under the same rules.
#if defined(__AVX512F__) && defined(__AVX512DQ__)

struct Float16 {
  __m512 v;

  static Float16 load(const float* p) { return {_mm512_loadu_ps(p)}; }
  static Float16 all(float x) { return {_mm512_set1_ps(x)}; }
  void store(float* p) const { _mm512_storeu_ps(p, v); }
};

inline Float16 operator+(Float16 a, Float16 b) { return {_mm512_add_ps(a.v, b.v)}; }
inline Float16 operator-(Float16 a, Float16 b) { return {_mm512_sub_ps(a.v, b.v)}; }
inline Float16 operator*(Float16 a, Float16 b) { return {_mm512_mul_ps(a.v, b.v)}; }
inline Float16 operator/(Float16 a, Float16 b) { return {_mm512_div_ps(a.v, b.v)}; }
inline Float16 smaller(Float16 a, Float16 b) { return {_mm512_min_ps(a.v, b.v)}; }
inline Float16 larger(Float16 a, Float16 b) { return {_mm512_max_ps(a.v, b.v)}; }
inline Float16 absolute(Float16 a) { return {_mm512_abs_ps(a.v)}; }
inline Float16 withSignOf(Float16 a, Float16 b) {
  return {_mm512_xor_ps(a.v, _mm512_and_ps(_mm512_set1_ps(-0.0f), b.v))};
}
inline Float16 multiplyAdd(Float16 a, Float16 b, Float16 c) {
  return {_mm512_fmadd_ps(a.v, b.v, c.v)};
}
inline Float16 selected(unsigned bits, Float16 a, Float16 b) {
  return {_mm512_mask_blend_ps(__mmask16(bits), b.v, a.v)};
}
inline unsigned lessOrEqual(Float16 a, Float16 b) {
  return unsigned(_mm512_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ));
}
inline unsigned less(Float16 a, Float16 b) {
  return unsigned(_mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ));
}
using Lanes = Float16;
constexpr int kLanes = 16;

#else

using Lanes = Float8;
constexpr int kLanes = 8;

#endif

inline float greatestLane(Lanes a) {
  float lanes[kLanes];
  a.store(lanes);
  float most = lanes[0];
  for (int lane = 1; lane < kLanes; ++lane) most = lanes[lane] > most ? lanes[lane] : most;
  return most;
}
