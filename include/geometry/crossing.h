// Crossing: one place where a ray passes through a surface, and who wants to know of it.
// Light that shines through transparent objects is counted from all crossings along its way.
#pragma once
#include <cstdint>

class Material;
class Object3D;

struct Crossing {
  double t;                  ///< ray parameter
  const Object3D* object;    ///< the sphere, plane, triangle or mesh; not owned
  const Material* material;  ///< its material; not owned
  bool closed;               ///< the object encloses a volume
  bool leaving;              ///< the ray goes out along the normal here
};

class CrossingVisitor {
 public:
  virtual ~CrossingVisitor() = default;
  /// Called once for every crossing, in no particular order.
  virtual void visit(const Crossing& crossing) = 0;
};
