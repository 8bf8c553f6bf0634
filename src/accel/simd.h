// Eight floats at once, in the widest way that this translation unit is compiled for.
//
// Included only by the kernels, inside the namespace of their instruction set: the same names mean
// different instructions in different translation units, and must never be linked together.
// Comparisons give a bit for each lane, lane 0 lowest. min and max return the second argument where
// one is a NaN. multiplyAdd may or may not round in between: only bounds are computed with it.
#if defined(__AVX2__)

struct Float8 {
  __m256 v;

  static Float8 load(const float* p) { return {_mm256_loadu_ps(p)}; }
  static Float8 all(float x) { return {_mm256_set1_ps(x)}; }
  void store(float* p) const { _mm256_storeu_ps(p, v); }
};

inline Float8 operator+(Float8 a, Float8 b) { return {_mm256_add_ps(a.v, b.v)}; }
inline Float8 operator-(Float8 a, Float8 b) { return {_mm256_sub_ps(a.v, b.v)}; }
inline Float8 operator*(Float8 a, Float8 b) { return {_mm256_mul_ps(a.v, b.v)}; }
inline Float8 operator/(Float8 a, Float8 b) { return {_mm256_div_ps(a.v, b.v)}; }
inline Float8 squareRoot(Float8 a) { return {_mm256_sqrt_ps(a.v)}; }
inline Float8 smaller(Float8 a, Float8 b) { return {_mm256_min_ps(a.v, b.v)}; }
inline Float8 larger(Float8 a, Float8 b) { return {_mm256_max_ps(a.v, b.v)}; }
inline Float8 absolute(Float8 a) { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v)}; }
/// a, negated in the lanes where b is negative.
inline Float8 withSignOf(Float8 a, Float8 b) {
  return {_mm256_xor_ps(a.v, _mm256_and_ps(_mm256_set1_ps(-0.0f), b.v))};
}
#if defined(__FMA__)
inline Float8 multiplyAdd(Float8 a, Float8 b, Float8 c) { return {_mm256_fmadd_ps(a.v, b.v, c.v)}; }
inline Float8 multiplySubtract(Float8 a, Float8 b, Float8 c) {
  return {_mm256_fmsub_ps(a.v, b.v, c.v)};
}
#else
inline Float8 multiplyAdd(Float8 a, Float8 b, Float8 c) { return a * b + c; }
inline Float8 multiplySubtract(Float8 a, Float8 b, Float8 c) { return a * b - c; }
#endif
#if defined(__AVX512VL__)
/// a in the lanes of `bits`, b in the others.
inline Float8 selected(unsigned bits, Float8 a, Float8 b) {
  return {_mm256_mask_blend_ps(__mmask8(bits), b.v, a.v)};
}
inline unsigned lessOrEqual(Float8 a, Float8 b) {
  return unsigned(_mm256_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ));
}
inline unsigned less(Float8 a, Float8 b) {
  return unsigned(_mm256_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ));
}
inline Float8 whereLessOrEqual(Float8 a, Float8 b, Float8 x, Float8 y) {
  return {_mm256_mask_blend_ps(_mm256_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ), y.v, x.v)};
}
#else
inline Float8 selected(unsigned bits, Float8 a, Float8 b) {
  const __m256i lanes = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
  const __m256i taken =
      _mm256_cmpeq_epi32(_mm256_and_si256(_mm256_set1_epi32(int(bits)), lanes), lanes);
  return {_mm256_blendv_ps(b.v, a.v, _mm256_castsi256_ps(taken))};
}
inline unsigned lessOrEqual(Float8 a, Float8 b) {
  return unsigned(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)));
}
inline unsigned less(Float8 a, Float8 b) {
  return unsigned(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)));
}
inline Float8 whereLessOrEqual(Float8 a, Float8 b, Float8 x, Float8 y) {
  return {_mm256_blendv_ps(y.v, x.v, _mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ))};
}
#endif

#elif defined(__SSE2__)

struct Float8 {
  __m128 low, high;

  static Float8 load(const float* p) { return {_mm_loadu_ps(p), _mm_loadu_ps(p + 4)}; }
  static Float8 all(float x) { return {_mm_set1_ps(x), _mm_set1_ps(x)}; }
  void store(float* p) const {
    _mm_storeu_ps(p, low);
    _mm_storeu_ps(p + 4, high);
  }
};

inline Float8 operator+(Float8 a, Float8 b) {
  return {_mm_add_ps(a.low, b.low), _mm_add_ps(a.high, b.high)};
}
inline Float8 operator-(Float8 a, Float8 b) {
  return {_mm_sub_ps(a.low, b.low), _mm_sub_ps(a.high, b.high)};
}
inline Float8 operator*(Float8 a, Float8 b) {
  return {_mm_mul_ps(a.low, b.low), _mm_mul_ps(a.high, b.high)};
}
inline Float8 operator/(Float8 a, Float8 b) {
  return {_mm_div_ps(a.low, b.low), _mm_div_ps(a.high, b.high)};
}
inline Float8 squareRoot(Float8 a) { return {_mm_sqrt_ps(a.low), _mm_sqrt_ps(a.high)}; }
inline Float8 smaller(Float8 a, Float8 b) {
  return {_mm_min_ps(a.low, b.low), _mm_min_ps(a.high, b.high)};
}
inline Float8 larger(Float8 a, Float8 b) {
  return {_mm_max_ps(a.low, b.low), _mm_max_ps(a.high, b.high)};
}
inline Float8 absolute(Float8 a) {
  const __m128 sign = _mm_set1_ps(-0.0f);
  return {_mm_andnot_ps(sign, a.low), _mm_andnot_ps(sign, a.high)};
}
inline Float8 withSignOf(Float8 a, Float8 b) {
  const __m128 sign = _mm_set1_ps(-0.0f);
  return {_mm_xor_ps(a.low, _mm_and_ps(sign, b.low)), _mm_xor_ps(a.high, _mm_and_ps(sign, b.high))};
}
inline __m128 selected4(unsigned bits, __m128 a, __m128 b) {
  const __m128i lanes = _mm_setr_epi32(1, 2, 4, 8);
  const __m128i taken = _mm_cmpeq_epi32(_mm_and_si128(_mm_set1_epi32(int(bits)), lanes), lanes);
  const __m128 mask = _mm_castsi128_ps(taken);
  return _mm_or_ps(_mm_and_ps(mask, a), _mm_andnot_ps(mask, b));
}
inline Float8 selected(unsigned bits, Float8 a, Float8 b) {
  return {selected4(bits, a.low, b.low), selected4(bits >> 4, a.high, b.high)};
}
inline Float8 multiplyAdd(Float8 a, Float8 b, Float8 c) { return a * b + c; }
inline Float8 multiplySubtract(Float8 a, Float8 b, Float8 c) { return a * b - c; }
inline unsigned lessOrEqual(Float8 a, Float8 b) {
  return unsigned(_mm_movemask_ps(_mm_cmple_ps(a.low, b.low))) |
         unsigned(_mm_movemask_ps(_mm_cmple_ps(a.high, b.high))) << 4;
}
inline unsigned less(Float8 a, Float8 b) {
  return unsigned(_mm_movemask_ps(_mm_cmplt_ps(a.low, b.low))) |
         unsigned(_mm_movemask_ps(_mm_cmplt_ps(a.high, b.high))) << 4;
}
inline Float8 whereLessOrEqual(Float8 a, Float8 b, Float8 x, Float8 y) {
  const __m128 low = _mm_cmple_ps(a.low, b.low), high = _mm_cmple_ps(a.high, b.high);
  return {_mm_or_ps(_mm_and_ps(low, x.low), _mm_andnot_ps(low, y.low)),
          _mm_or_ps(_mm_and_ps(high, x.high), _mm_andnot_ps(high, y.high))};
}

#else  // any other processor: the compiler's own vectors

typedef float FloatVector __attribute__((vector_size(32), aligned(4)));
typedef int IntVector __attribute__((vector_size(32), aligned(4)));

struct Float8 {
  FloatVector v;

  static Float8 load(const float* p) {
    Float8 result;
    __builtin_memcpy(&result.v, p, sizeof result.v);
    return result;
  }
  static Float8 all(float x) { return {FloatVector{x, x, x, x, x, x, x, x}}; }
  void store(float* p) const { __builtin_memcpy(p, &v, sizeof v); }
};

inline unsigned bitsOf(IntVector lanes) {
  unsigned bits = 0;
  for (int lane = 0; lane < 8; ++lane) bits |= unsigned(lanes[lane] & 1) << lane;
  return bits;
}
inline Float8 operator+(Float8 a, Float8 b) { return {a.v + b.v}; }
inline Float8 operator-(Float8 a, Float8 b) { return {a.v - b.v}; }
inline Float8 operator*(Float8 a, Float8 b) { return {a.v * b.v}; }
inline Float8 operator/(Float8 a, Float8 b) { return {a.v / b.v}; }
inline Float8 squareRoot(Float8 a) {
  for (int lane = 0; lane < 8; ++lane) a.v[lane] = __builtin_sqrtf(a.v[lane]);
  return a;
}
inline Float8 smaller(Float8 a, Float8 b) { return {a.v < b.v ? a.v : b.v}; }
inline Float8 larger(Float8 a, Float8 b) { return {a.v > b.v ? a.v : b.v}; }
inline Float8 absolute(Float8 a) { return {FloatVector(IntVector(a.v) & 0x7fffffff)}; }
inline Float8 withSignOf(Float8 a, Float8 b) {
  const IntVector sign = IntVector(b.v) & ~0x7fffffff;
  return {FloatVector(IntVector(a.v) ^ sign)};
}
inline Float8 selected(unsigned bits, Float8 a, Float8 b) {
  const IntVector lanes = {1, 2, 4, 8, 16, 32, 64, 128};
  const IntVector taken = (lanes & int(bits)) != 0;
  return {taken ? a.v : b.v};
}
inline Float8 multiplyAdd(Float8 a, Float8 b, Float8 c) { return a * b + c; }
inline Float8 multiplySubtract(Float8 a, Float8 b, Float8 c) { return a * b - c; }
inline unsigned lessOrEqual(Float8 a, Float8 b) { return bitsOf(a.v <= b.v); }
inline unsigned less(Float8 a, Float8 b) { return bitsOf(a.v < b.v); }
inline Float8 whereLessOrEqual(Float8 a, Float8 b, Float8 x, Float8 y) {
  return {a.v <= b.v ? x.v : y.v};
}

#endif

inline Float8 operator-(Float8 a) { return Float8::all(0) - a; }

inline float floatOfBits(std::uint32_t bits) {
  float x;
  __builtin_memcpy(&x, &bits, sizeof x);
  return x;
}

inline int lowestBit(unsigned bits) { return __builtin_ctz(bits); }
inline int leafCount(std::uint32_t head) { return int(head & 15); }
inline LeafKind leafKind(std::uint32_t head) { return LeafKind(head >> 4 & 3); }
inline int leafVertices(std::uint32_t head) { return int(head >> 8 & 31); }

// Places8: eight numbers of up to five bits, and what is at these places of a row.
#if defined(__AVX2__)

struct Places8 {
  __m256i v;

  /// From half words. What is above their lowest five bits is passed over.
  static Places8 load(const std::uint32_t* words) {
    return {_mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(words)))};
  }
  Places8 next(int bits) const { return {_mm256_srli_epi32(v, bits)}; }
  /// Reads kEights times eight of the row; the places are below.
  template <int kEights>
  Float8 in(const float* row) const {
    __m256 found = eight(row);
    if (kEights > 1) found = _mm256_blendv_ps(found, eight(row + 8), bitAsSign(3));
    if (kEights > 2) found = _mm256_blendv_ps(found, eight(row + 16), bitAsSign(4));
    return {found};
  }

 private:
  __m256 eight(const float* row) const { return _mm256_permutevar8x32_ps(_mm256_loadu_ps(row), v); }
  __m256 bitAsSign(int bit) const { return _mm256_castsi256_ps(_mm256_slli_epi32(v, 31 - bit)); }
};

#else

struct Places8 {
  std::uint16_t v[8];
  int shift = 0;

  static Places8 load(const std::uint32_t* words) {
    Places8 places;
    __builtin_memcpy(places.v, words, sizeof places.v);
    return places;
  }
  Places8 next(int bits) const {
    Places8 places = *this;
    places.shift = bits;
    return places;
  }
  template <int kEights>
  Float8 in(const float* row) const {
    float found[8];
    for (int lane = 0; lane < 8; ++lane) found[lane] = row[v[lane] >> shift & 31];
    return Float8::load(found);
  }
};

#endif

// Compaction: of list[0 .. count) those whose mask has bit `bit`, in order, go to `out`; returns
// how many. Reads and writes up to a multiple of 16 entries.
#if defined(__AVX2__)

/// For each mask of eight entries of two bytes, which bytes are taken.
struct CompressTable {
  alignas(64) std::uint8_t places[256][16];
};
constexpr CompressTable makeCompressTable() {
  CompressTable table{};
  for (int mask = 0; mask < 256; ++mask) {
    int n = 0;
    for (int entry = 0; entry < 8; ++entry) {
      if ((mask >> entry & 1) == 0) continue;
      table.places[mask][n++] = std::uint8_t(2 * entry);
      table.places[mask][n++] = std::uint8_t(2 * entry + 1);
    }
    for (; n < 16; ++n) table.places[mask][n] = 0x80;
  }
  return table;
}
inline constexpr CompressTable kCompress = makeCompressTable();

inline std::uint16_t* compressEight(const std::uint16_t* list, unsigned taken, std::uint16_t* out) {
  const __m128i entries = _mm_loadu_si128(reinterpret_cast<const __m128i*>(list));
  const __m128i places = _mm_load_si128(reinterpret_cast<const __m128i*>(kCompress.places[taken]));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(out), _mm_shuffle_epi8(entries, places));
  return out + __builtin_popcount(taken);
}
inline std::uint32_t compress(const std::uint16_t* list, const std::uint8_t* masks,
                              std::uint32_t count, int bit, std::uint16_t* out) {
  const std::uint16_t* const begin = out;
  const __m128i toSign = _mm_cvtsi32_si128(7 - bit);
  for (std::uint32_t k = 0; k < count; k += 16) {
    const __m128i sixteen = _mm_loadu_si128(reinterpret_cast<const __m128i*>(masks + k));
    unsigned taken = unsigned(_mm_movemask_epi8(_mm_sll_epi16(sixteen, toSign)));
    if (count - k < 16) taken &= (1u << (count - k)) - 1;
    out = compressEight(list + k, taken & 255, out);
    if (taken >> 8 != 0) out = compressEight(list + k + 8, taken >> 8, out);
  }
  return std::uint32_t(out - begin);
}

#else

inline std::uint32_t compress(const std::uint16_t* list, const std::uint8_t* masks,
                              std::uint32_t count, int bit, std::uint16_t* out) {
  std::uint32_t size = 0;
  for (std::uint32_t k = 0; k < count; ++k) {
    out[size] = list[k];
    size += masks[k] >> bit & 1u;
  }
  return size;
}

#endif

/// Four columns of kCount numbers, one behind the other, become kCount rows of four: row i stands
/// at rows + i * stride.
template <int kCount>
inline void transpose(const float* columns, float* rows, int stride) {
#if defined(__SSE2__)
  if (kCount % 4 == 0) {
    for (int i = 0; i < kCount; i += 4) {
      __m128 a = _mm_loadu_ps(columns + i), b = _mm_loadu_ps(columns + kCount + i),
             c = _mm_loadu_ps(columns + 2 * kCount + i), d = _mm_loadu_ps(columns + 3 * kCount + i);
      _MM_TRANSPOSE4_PS(a, b, c, d);
      _mm_storeu_ps(rows + i * stride, a);
      _mm_storeu_ps(rows + (i + 1) * stride, b);
      _mm_storeu_ps(rows + (i + 2) * stride, c);
      _mm_storeu_ps(rows + (i + 3) * stride, d);
    }
    return;
  }
#endif
  for (int i = 0; i < kCount; ++i) {
    for (int k = 0; k < 4; ++k) rows[i * stride + k] = columns[k * kCount + i];
  }
}
