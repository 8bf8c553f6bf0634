// A scene as plain numbers: what the tests of numbers make up, write as text for the program, and
// hand to the tracer in long double. What is single precision in the program is float here.
#pragma once
#include <string>
#include <vector>

#include "math/vec3.h"

namespace numbers {

struct PlainMaterial {
  Vec3f diffuse{1, 1, 1}, specular, transparent, reflective;
  float exponent = 1, index = 1;
};

struct PlainLight {
  bool isPoint = false;
  Vec3d place;  ///< the position of a point light, else the direction in which the light shines
  Vec3f color;
  Vec3f attenuation{1, 0, 0};
};

struct PlainCamera {
  bool isPerspective = true;
  Vec3d center, direction, up;
  float extent = 30;  ///< the angle in degrees, or the size
};

/// A mesh as its OBJ file describes it: faces of any number of corners, counted from 0.
struct PlainMesh {
  std::vector<Vec3f> vertices;
  std::vector<std::vector<int>> faces;
  bool closed = true;
};

/// One step of a Transform. `v` is the vector or axis, `f` the factor or the angle in degrees.
struct PlainStep {
  enum class Kind { translate, scale, uniformScale, xRotate, yRotate, zRotate, rotate, matrix };
  Kind kind = Kind::translate;
  Vec3d v;
  double f = 0;
  double rows[12] = {};  ///< of a matrix; the last row is 0 0 0 1
};

struct PlainObject {
  enum class Kind { sphere, plane, triangle, mesh, transform, group };
  Kind kind = Kind::sphere;
  int material = 0;  ///< the same for all of a transform's contents
  Vec3d a, b, c;     ///< centre; or normal; or the three vertices
  double f = 0;      ///< radius or offset
  int mesh = 0;      ///< its number in the scene
  std::vector<PlainStep> steps;
  std::vector<PlainObject> children;  ///< one for a transform
};

struct PlainScene {
  PlainCamera camera;
  std::vector<PlainLight> lights;
  Vec3f background{0.5f, 0.5f, 0.5f}, ambient;
  std::vector<PlainMaterial> materials;
  std::vector<PlainMesh> meshes;
  std::vector<PlainObject> objects;
};

}  // namespace numbers
