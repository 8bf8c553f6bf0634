// The scene of the whole-program rows, written as a scene file.
#include "program_scene.h"

#include <sstream>

namespace bench {
namespace {

std::string text(const Vec3f& v) {
  std::ostringstream out;
  out << v.x() << ' ' << v.y() << ' ' << v.z();
  return out.str();
}

std::string text(const Surface& s) {
  std::ostringstream out;
  out << "PhongMaterial { diffuseColor " << text(s.diffuse) << " specularColor " << text(s.specular)
      << " exponent " << s.exponent << " transparentColor " << text(s.transparent)
      << " reflectiveColor " << text(s.reflective) << " indexOfRefraction " << s.index << " }\n";
  return out.str();
}

}  // namespace

std::string programScene(const std::string& objName) {
  std::ostringstream out;
  out << "PerspectiveCamera { center " << text(kEye) << " direction " << text(kView)
      << " up 0 1 0 angle " << kViewAngle << " }\n"
      << "Lights { numLights 1 PointLight { position " << text(kLightPlace) << " color "
      << text(kLightColor) << " } }\n"
      << "Background { color " << text(kBackground) << " ambientLight " << text(kAmbient) << " }\n"
      << "Materials { numMaterials 3\n"
      << text(kMeshSurface) << text(kFloorSurface) << text(kGlassSurface) << "}\n"
      << "Group { numObjects 3\n"
      << "MaterialIndex 0 TriangleMesh { obj_file " << objName << " }\n"
      << "MaterialIndex 1 Plane { normal 0 1 0 offset " << kFloorHeight << " }\n"
      << "MaterialIndex 2 Sphere { center " << text(kBallCenter) << " radius " << kBallRadius
      << " }\n}\n";
  return out.str();
}

}  // namespace bench
