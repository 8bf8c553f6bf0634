// Eight floats at once, in the widest way that this translation unit is compiled for.
//
// Included only by the kernels, inside the namespace of their instruction set: the same names mean
// different instructions in different translation units, and must never be linked together.
// Comparisons give a bit for each lane, lane 0 lowest. min and max return the second argument where
// one is a NaN. multiplyAdd may or may not round in between: only bounds are computed with it.
// The compiler's own vectors, one of eight or two of four; intrinsics where these have no good
// words.
#if defined(__AVX2__)
constexpr int kParts = 1;
#else
constexpr int kParts = 2;
#endif
typedef float Part __attribute__((vector_size(32 / kParts)));
/// Copied whole: as bytes it is copied half by half (1.015 of the time of the walk for hits).
typedef float PartInMemory
    __attribute__((vector_size(32 / kParts), aligned(sizeof(float)), may_alias));
typedef int IntPart __attribute__((vector_size(32 / kParts)));

struct Float8 {
  Part v[kParts];

  static Float8 load(const float* p) {
    Float8 result;
    __builtin_memcpy(result.v, p, sizeof result.v);
    return result;
  }
  static Float8 all(float x) {
    Float8 result;
    for (Part& part : result.v) part = x - Part{};
    return result;
  }
  void store(float* p) const {
    for (int i = 0; i < kParts; ++i) reinterpret_cast<PartInMemory*>(p)[i] = v[i];
  }
};

/// Of each lane all bits, or none.
struct Truths {
  IntPart v[kParts];

  unsigned bits() const {
#if defined(__AVX2__)
    return unsigned(_mm256_movemask_ps(__m256(v[0])));
#elif defined(__SSE2__)
    return unsigned(_mm_movemask_ps(__m128(v[0])) | _mm_movemask_ps(__m128(v[1])) << 4);
#else
    unsigned bits = 0;
    for (int lane = 0; lane < 8; ++lane) bits |= unsigned(v[lane / 4][lane % 4] & 1) << lane;
    return bits;
#endif
  }
};

/// f(a, b), part by part.
template <class Result = Float8, class F>
inline Result byParts(const Float8& a, const Float8& b, const F& f) {
  Result result;
  for (int i = 0; i < kParts; ++i) result.v[i] = f(a.v[i], b.v[i]);
  return result;
}
inline Float8 operator+(const Float8& a, const Float8& b) {
  return byParts(a, b, [](Part x, Part y) { return x + y; });
}
inline Float8 operator-(const Float8& a, const Float8& b) {
  return byParts(a, b, [](Part x, Part y) { return x - y; });
}
inline Float8 operator-(const Float8& a) { return Float8::all(0) - a; }
inline Float8 operator*(const Float8& a, const Float8& b) {
  return byParts(a, b, [](Part x, Part y) { return x * y; });
}
inline Float8 operator/(const Float8& a, const Float8& b) {
  return byParts(a, b, [](Part x, Part y) { return x / y; });
}
inline Float8 smaller(const Float8& a, const Float8& b) {
  return byParts(a, b, [](Part x, Part y) { return x < y ? x : y; });
}
inline Float8 larger(const Float8& a, const Float8& b) {
  return byParts(a, b, [](Part x, Part y) { return x > y ? x : y; });
}
inline Float8 absolute(const Float8& a) {
  return byParts(a, -a, [](Part x, Part y) { return x > y ? x : y; });
}
/// a, negated in the lanes where b is negative.
inline Float8 withSignOf(const Float8& a, const Float8& b) {
  return byParts(a, b, [](Part x, Part y) {
    return Part(IntPart(x) ^ (IntPart(y) & IntPart(-0.0f - Part{})));
  });
}
inline Float8 squareRoot(const Float8& a) {
#if defined(__AVX2__)
  return {{_mm256_sqrt_ps(a.v[0])}};
#else
  Float8 root;
  for (int i = 0; i < 8; ++i) root.v[i / 4][i % 4] = __builtin_sqrtf(a.v[i / 4][i % 4]);
  return root;
#endif
}
#if defined(__FMA__)
inline Float8 multiplyAdd(const Float8& a, const Float8& b, const Float8& c) {
  return {{_mm256_fmadd_ps(a.v[0], b.v[0], c.v[0])}};
}
inline Float8 multiplySubtract(const Float8& a, const Float8& b, const Float8& c) {
  return {{_mm256_fmsub_ps(a.v[0], b.v[0], c.v[0])}};
}
#else
inline Float8 multiplyAdd(const Float8& a, const Float8& b, const Float8& c) { return a * b + c; }
inline Float8 multiplySubtract(const Float8& a, const Float8& b, const Float8& c) {
  return a * b - c;
}
#endif
inline Float8 whereLessOrEqual(const Float8& a, const Float8& b, const Float8& x, const Float8& y) {
  Float8 result;
  for (int i = 0; i < kParts; ++i) result.v[i] = a.v[i] <= b.v[i] ? x.v[i] : y.v[i];
  return result;
}
#if defined(__AVX512VL__)
inline unsigned lessOrEqual(const Float8& a, const Float8& b) {
  return unsigned(_mm256_cmp_ps_mask(a.v[0], b.v[0], _CMP_LE_OQ));
}
inline unsigned less(const Float8& a, const Float8& b) {
  return unsigned(_mm256_cmp_ps_mask(a.v[0], b.v[0], _CMP_LT_OQ));
}
/// a in the lanes of `bits`, b in the others.
inline Float8 selected(unsigned bits, const Float8& a, const Float8& b) {
  return {{_mm256_mask_blend_ps(__mmask8(bits), b.v[0], a.v[0])}};
}
#else
inline unsigned lessOrEqual(const Float8& a, const Float8& b) {
  return byParts<Truths>(a, b, [](Part x, Part y) { return x <= y; }).bits();
}
inline unsigned less(const Float8& a, const Float8& b) {
  return byParts<Truths>(a, b, [](Part x, Part y) { return x < y; }).bits();
}
inline Float8 selected(unsigned bits, const Float8& a, const Float8& b) {
  Truths lane = {};
  for (int i = 0; i < 8; ++i) lane.v[i / (8 / kParts)][i % (8 / kParts)] = 1 << i;
  Float8 result;
  for (int i = 0; i < kParts; ++i) result.v[i] = (lane.v[i] & int(bits)) != 0 ? a.v[i] : b.v[i];
  return result;
}
#endif

inline float floatOfBits(std::uint32_t bits) {
  float x;
  __builtin_memcpy(&x, &bits, sizeof x);
  return x;
}

// As countOf, kindOf and verticesOf of wide_bvh.h, which may not be called here: see kernels.cpp.
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

// compress: of list[0 .. count) those whose mask has bit `bit`, in order, go to `out`; returns how
// many. Reads and writes up to a multiple of eight.
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
  for (std::uint32_t k = 0; k < count; k += 8) {
    const __m128i eight = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(masks + k));
    unsigned taken = unsigned(_mm_movemask_epi8(_mm_sll_epi16(eight, toSign))) & 255;
    if (count - k < 8) taken &= (1u << (count - k)) - 1;
    out = compressEight(list + k, taken, out);
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

/// kColumns columns of kCount numbers, one behind the other, become rows: number i of each goes to
/// rows[i], where these are the same the last of them.
template <int kCount, int kColumns>
inline void transpose(const float* columns, void* const* rows) {
  static_assert(kColumns % 4 == 0);
  for (int k = 0; k < kColumns; k += 4) {
    const float* const four = columns + k * kCount;
#if defined(__SSE2__)
    if (kCount % 4 == 0) {
      for (int i = 0; i < kCount; i += 4) {
        __m128 a = _mm_loadu_ps(four + i), b = _mm_loadu_ps(four + kCount + i),
               c = _mm_loadu_ps(four + 2 * kCount + i), d = _mm_loadu_ps(four + 3 * kCount + i);
        _MM_TRANSPOSE4_PS(a, b, c, d);
        _mm_storeu_ps(static_cast<float*>(rows[i]) + k, a);
        _mm_storeu_ps(static_cast<float*>(rows[i + 1]) + k, b);
        _mm_storeu_ps(static_cast<float*>(rows[i + 2]) + k, c);
        _mm_storeu_ps(static_cast<float*>(rows[i + 3]) + k, d);
      }
      continue;
    }
#endif
    for (int i = 0; i < kCount; ++i) {
      const float row[4] = {four[i], four[kCount + i], four[2 * kCount + i], four[3 * kCount + i]};
      __builtin_memcpy(static_cast<float*>(rows[i]) + k, row, sizeof row);
    }
  }
}
