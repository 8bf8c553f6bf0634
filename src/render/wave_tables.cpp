// The tables of a wave. Surfaces are sorted by counting: each material gets a number when it is
// first seen, found again by hashing its address; then its surfaces' places follow from how many
// come before. The order is that of the rays alone, not of the addresses.
#include "render/wave_tables.h"

#include <algorithm>

namespace {

/// Numbers materials from 0 in the order in which they are first seen.
class MaterialNumbers {
 public:
  /// For up to `most` materials.
  MaterialNumbers(int most, Arena& arena) {
    while (1 << bits_ < 2 * most) ++bits_;
    const auto size = std::size_t(1) << bits_;
    numbers_ = arena.take<std::uint16_t>(size);
    materials_ = arena.take<const Material*>(size);
    std::fill(numbers_, numbers_ + size, kFree);
  }
  int numberOf(const Material* material) {
    const auto address = reinterpret_cast<std::uintptr_t>(material);
    // Source: Knuth, "The Art of Computer Programming", volume 3, 6.4 (multiplicative hashing).
    std::size_t slot = std::size_t((address * 0x9e3779b97f4a7c15u) >> (64 - bits_));
    while (numbers_[slot] != kFree && materials_[slot] != material) {
      slot = (slot + 1) & ((std::size_t(1) << bits_) - 1);
    }
    if (numbers_[slot] == kFree) {
      numbers_[slot] = std::uint16_t(count_++);
      materials_[slot] = material;
    }
    return numbers_[slot];
  }

 private:
  static constexpr std::uint16_t kFree = 0xffff;
  int bits_ = 1, count_ = 0;
  std::uint16_t* numbers_;
  const Material** materials_;
};

template <std::size_t kTables>
void takeColumns(Arena& arena, int rows, double* (*const (&tables)[kTables])[3]) {
  for (auto* table : tables) {
    for (double*& column : *table) column = arena.take<double>(std::size_t(rows));
  }
}

}  // namespace

WaveRays::WaveRays(Arena& arena, int rows, bool hasSources, bool hasIndices)
    : RayTable(arena, rows, hasSources) {
  count = 0;
  weight = arena.take<float>(std::size_t(rows));
  factor = arena.take<Vec3f>(std::size_t(rows));
  parent = arena.take<std::uint16_t>(std::size_t(rows));
  if (hasIndices) index = arena.take<float>(std::size_t(rows));
}

WaveLight::WaveLight(Arena& arena, int rows, bool hasSources) : RayTable(arena, rows, hasSources) {
  count = 0;
  surface = arena.take<std::uint16_t>(std::size_t(rows));
  takeColumns(arena, rows, {&color});
}

ColorFilterTable::ColorFilterTable(Arena& arena, int rows) {
  row = arena.take<std::uint16_t>(std::size_t(rows));
  exponent = arena.take<double>(std::size_t(rows));
  takeColumns(arena, rows, {&color});
}

void ColorFilterTable::add(const ColorFilter& filter, int ofRow) {
  row[count] = std::uint16_t(ofRow);
  setRowOf(color, count, Vec3d(filter.color));
  exponent[count++] = filter.exponent;
}

WaveSurfaces::WaveSurfaces(const WaveRays& rays, const HitTable& hits, WaveHit* met, int rows,
                           Arena& arena)
    : count(rows) {
  const auto size = std::size_t(rows);
  groups = arena.take<MaterialGroup>(size);
  ray = arena.take<std::uint16_t>(size);
  tmin = arena.take<double>(size);
  weight = arena.take<float>(size);
  takeColumns(arena, rows, {&view, &point, &normal, &sum});
  std::copy(normal, normal + 3, lit);
  sort(met, arena);
  for (int k = 0; k < rows; ++k) {
    const int row = met[k].ray, place = met[k].place;
    ray[place] = met[k].ray;
    weight[place] = met[k].isComponent ? rays.weight[row] * float(met[k].share) : rays.weight[row];
    for (int axis = 0; axis < 3; ++axis) {
      view[axis][place] = rays.direction[axis][row];
      point[axis][place] = hits.point[axis][row];
      normal[axis][place] = hits.normal[axis][row];
    }
  }
  for (double* column : sum) std::fill(column, column + rows, 0.0);
}

void WaveSurfaces::sort(WaveHit* met, Arena& arena) {
  const Arena::Frame frame(arena);
  MaterialNumbers numbers(count, arena);
  auto* group = arena.take<std::uint16_t>(std::size_t(count));
  for (int k = 0; k < count; ++k) {
    const int number = numbers.numberOf(met[k].material);
    if (number == groupCount) groups[groupCount++] = {met[k].material, 0, 0};
    group[k] = std::uint16_t(number);
    ++groups[number].last;  // so many, for now
  }
  int first = 0;
  for (int number = 0; number < groupCount; ++number) {
    const int size = groups[number].last;
    groups[number].first = groups[number].last = first;
    first += size;
  }
  for (int k = 0; k < count; ++k) met[k].place = std::uint16_t(groups[group[k]].last++);
}
