// A plain scene as the words of a scene file and of OBJ files, every number with all its digits.
#pragma once
#include "plain_scene.h"
#include "scene_text.h"

namespace numbers {

/// Files that are removed again when this goes.
class SceneFiles {
 public:
  explicit SceneFiles(const PlainScene& scene) {
    for (const PlainMesh& mesh : scene.meshes)
      paths_.push_back(scene_text::write(obj(mesh), ".obj"));
    paths_.push_back(scene_text::write(text(scene), ".txt"));
  }
  ~SceneFiles() {
    if (isKept_) return;
    for (const std::string& path : paths_) std::remove(path.c_str());
  }
  SceneFiles(const SceneFiles&) = delete;
  SceneFiles& operator=(const SceneFiles&) = delete;

  const std::string& scene() const { return paths_.back(); }
  /// Leaves the files where they are, for a look at what failed.
  void keep() { isKept_ = true; }

 private:
  static std::string number(double x) { return scene_text::word(x); }
  static std::string vector(const Vec3d& v) { return scene_text::word(v); }

  /// Corners are written in all forms by turns, counted from the start or, as negative numbers,
  /// from the end.
  static std::string obj(const PlainMesh& mesh) {
    std::string text = "# written by a test\n";
    for (const Vec3f& v : mesh.vertices) text += "v" + vector(v) + "\n";
    const char* const endings[] = {"", "/1", "//2", "/1/2"};
    int row = 0;
    for (const std::vector<int>& face : mesh.faces) {
      text += "f";
      for (const int corner : face) {
        const int index = row % 5 == 4 ? corner - int(mesh.vertices.size()) : corner + 1;
        text += " " + std::to_string(index) + endings[row % 4];
      }
      text += "\n";
      ++row;
    }
    return text;
  }

  std::string text(const PlainScene& scene) {
    return camera(scene.camera) + lights(scene.lights) + "Background { color" +
           vector(scene.background) + "ambientLight" + vector(scene.ambient) + "}\n" +
           materials(scene.materials) + group(scene.objects) + "\n";
  }
  static std::string camera(const PlainCamera& camera) {
    return std::string(camera.isPerspective ? "Perspective" : "Orthographic") + "Camera { center" +
           vector(camera.center) + "direction" + vector(camera.direction) + "up" +
           vector(camera.up) + (camera.isPerspective ? "angle" : "size") +
           number(double(camera.extent)) + "}\n";
  }
  static std::string lights(const std::vector<PlainLight>& lights) {
    std::string text = "Lights { numLights " + std::to_string(lights.size()) + "\n";
    for (const PlainLight& light : lights) {
      text += light.isPoint ? "PointLight { position" : "DirectionalLight { direction";
      text += vector(light.place) + "color" + vector(light.color);
      if (light.isPoint) text += "attenuation" + vector(light.attenuation);
      text += "}\n";
    }
    return text + "}\n";
  }
  static std::string materials(const std::vector<PlainMaterial>& materials) {
    std::string text = "Materials { numMaterials " + std::to_string(materials.size()) + "\n";
    for (const PlainMaterial& m : materials) {
      text += "PhongMaterial { diffuseColor" + vector(m.diffuse) + "specularColor" +
              vector(m.specular) + "exponent" + number(double(m.exponent)) + "transparentColor" +
              vector(m.transparent) + "reflectiveColor" + vector(m.reflective) +
              "indexOfRefraction" + number(double(m.index)) + "}\n";
    }
    return text + "}\n";
  }

  /// MaterialIndex only where the one before does not hold any more.
  std::string group(const std::vector<PlainObject>& objects) {
    std::string text = "Group { numObjects " + std::to_string(objects.size()) + "\n";
    for (const PlainObject& o : objects) {
      if (o.kind != PlainObject::Kind::group && o.material != materialNow_) {
        text += "MaterialIndex " + std::to_string(o.material) + "\n";
        materialNow_ = o.material;
      }
      text += object(o) + "\n";
    }
    return text + "}";
  }
  std::string object(const PlainObject& o) {
    switch (o.kind) {
      case PlainObject::Kind::sphere:
        return "Sphere { center" + vector(o.a) + "radius" + number(o.f) + "}";
      case PlainObject::Kind::plane:
        return "Plane { normal" + vector(o.a) + "offset" + number(o.f) + "}";
      case PlainObject::Kind::triangle:
        return "Triangle { vertex0" + vector(o.a) + "vertex1" + vector(o.b) + "vertex2" +
               vector(o.c) + "}";
      case PlainObject::Kind::mesh:
        return scene_text::mesh(paths_[std::size_t(o.mesh)]);
      case PlainObject::Kind::transform: {
        std::string text = "Transform {";
        for (const PlainStep& s : o.steps) text += step(s);
        return text + object(o.children[0]) + "}";
      }
      case PlainObject::Kind::group:
        break;
    }
    return group(o.children);
  }
  static std::string step(const PlainStep& s) {
    switch (s.kind) {
      case PlainStep::Kind::translate:
        return " Translate" + vector(s.v);
      case PlainStep::Kind::scale:
        return " Scale {" + vector(s.v) + "}";
      case PlainStep::Kind::uniformScale:
        return " UniformScale" + number(s.f);
      case PlainStep::Kind::xRotate:
        return " XRotate" + number(s.f);
      case PlainStep::Kind::yRotate:
        return " YRotate {" + number(s.f) + "}";
      case PlainStep::Kind::zRotate:
        return " ZRotate" + number(s.f);
      case PlainStep::Kind::rotate:
        return " Rotate {" + vector(s.v) + number(s.f) + "}";
      case PlainStep::Kind::matrix:
        break;
    }
    std::string text = " Matrix {";
    for (const double x : s.rows) text += number(x);
    return text + "0 0 0 1 }";
  }

  std::vector<std::string> paths_;  // the meshes, then the scene
  int materialNow_ = -1;
  bool isKept_ = false;
};

}  // namespace numbers
