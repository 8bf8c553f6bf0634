// What lies in the way of light: how much comes through transparent objects, and what blocks it.
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/ray_table.h"
#include "math/vec3.h"

/// The factor by which the light of a source at parameter `distance` (perhaps infinity) of the unit
/// shadow ray is tinted and dimmed. Black where an opaque surface lies at epsilon < t < distance.
/// Each closed transparent object multiplies on its own by transparentColor^length, length being
/// what the light travels inside it in world units; an open transparent surface multiplies by its
/// colour once for each crossing at epsilon < t < distance. Light does not bend.
/// Of a solid texture the colour is the mean of its components' at the point where the light enters
/// the object (or leaves it, if it is an open surface, or the lamp is inside); where that is black
/// the surface is opaque.
Vec3f transmittance(const Object3D& geometry, const Ray& ray, double epsilon, double distance);

/// The same for all rays of a table, `epsilon` being tmin and `distance` tmax; stores each answer
/// in visible[row].
void transmittances(const BatchGeometry& geometry, const RayTable& rays, Arena& arena,
                    Vec3f* visible);

/// transparentColor at a point of the world; of a texture the mean of its components' colours
/// there.
Vec3f transparencyAt(const Material& material, const Vec3d& point);

/// One object's share in what comes through: its colour to the power `exponent`, which is the
/// length inside a closed object, or the number of crossings of an open one.
struct ColorFilter {
  Vec3f color;
  double exponent;  ///< >= 0

  /// The factor in each component, as ::absorption gives it.
  Vec3f tint() const;
};

/// What stands in the way of a light.
struct Blocker {
  const Object3D* object;             ///< not owned
  std::optional<std::uint32_t> face;  ///< of a mesh, where that is known
  double t;                           ///< along the shadow ray
};

/// The nearest surface on the way to the light that lets nothing of it through, where there is one:
/// any surface, or with `transparentShadows` only one that is opaque where it is crossed.
std::optional<Blocker> findBlocker(const Object3D& geometry, const ShadowQuery& query,
                                   bool transparentShadows);

/// The crossings of all rays of a table, to be gone through row by row.
class CrossingTable : public RowCrossingVisitor {
 public:
  explicit CrossingTable(int rows) : last_(std::size_t(rows), -1) {
    crossings_.reserve(4 * std::size_t(rows));  // few rays meet more
  }
  void visit(int row, const Crossing& crossing) override {
    crossings_.push_back({crossing, last_[std::size_t(row)]});
    last_[std::size_t(row)] = int(crossings_.size()) - 1;
  }
  int size() const { return int(crossings_.size()); }
  /// Tells `visitor`, a CrossingVisitor, of those of a row, in no particular order.
  template <class Visitor>
  void tell(int row, Visitor& visitor) const {
    for (int k = last_[std::size_t(row)]; k >= 0; k = crossings_[std::size_t(k)].before) {
      visitor.visit(crossings_[std::size_t(k)].crossing);
    }
  }

 private:
  struct Link {
    Crossing crossing;
    int before;  // the place of another one of the same row; -1: none
  };
  std::vector<Link> crossings_;
  std::vector<int> last_;  // of each row
};

/// Brings crossings in an order that does not depend on that of the visits: those of an object
/// together, by t, and those at the same t that enter it first.
void sortByObject(std::vector<Crossing>& crossings);

using CrossingPlace = std::vector<Crossing>::const_iterator;

/// Calls visit(first, last) for the crossings first <= c < last of each object, which are together.
template <class Visit>
void forEachObject(const std::vector<Crossing>& crossings, const Visit& visit) {
  for (CrossingPlace first = crossings.begin(); first != crossings.end();) {
    const CrossingPlace last = std::find_if(first, crossings.end(), [&](const Crossing& crossing) {
      return crossing.object != first->object;
    });
    visit(first, last);
    first = last;
  }
}
