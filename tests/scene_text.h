// Scenes for tests, from text: written to a file of its own, then read by the SceneParser.
#pragma once
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "check.h"
#include "render/ray_tracer.h"

namespace scene_text {

/// Writes `text` to check::temporaryFolder() under a name that no other test uses; `ending` comes
/// with its dot. Returns the path.
inline std::string write(const std::string& text, const std::string& ending) {
  static int count = 0;
  const std::string path = check::temporaryFolder() + "/scene_text_" + std::to_string(getpid()) +
                           "_" + std::to_string(++count) + ending;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

/// The words of a scene that show the mesh that write() has written to `path`. Looked up beside the
/// scene: the whole path may hold white space.
inline std::string mesh(const std::string& path) {
  return " TriangleMesh { obj_file " + path.substr(path.rfind('/') + 1) + " } ";
}

/// Reads a scene of `text`, which is all of it.
inline SceneParser parseWhole(const std::string& text, const SceneRules& rules = {}) {
  struct File {
    std::string path;
    ~File() { std::remove(path.c_str()); }
  } file{write(text, ".txt")};
  return SceneParser(file.path.c_str(), nullptr, rules);
}

/// Reads a scene of `text` with a camera put before it.
inline SceneParser parse(const std::string& text, const SceneRules& rules = {}) {
  return parseWhole("PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 30 }\n" +
                    text, rules);
}

/// The colour along the ray from `origin` towards `target`.
inline Vec3f colorTowards(const SceneParser& scene, const Vec3d& origin, const Vec3d& target,
                          const RenderOptions& options = {}) {
  const RayTracer tracer(scene, *scene.getGroup(), options);
  Ray ray(origin, normalize(target - origin));
  Hit hit;
  return tracer.traceRay(ray, 0, 0, 1, 1, hit);
}

inline RenderOptions bouncing(int maxBounces) {
  RenderOptions options;
  options.maxBounces = maxBounces;
  return options;
}

/// A number as a scene file's word, with all its digits.
inline std::string word(double number) { return " " + check::show(number) + " "; }
inline std::string word(const Vec3d& v) { return word(v.x()) + word(v.y()) + word(v.z()); }

}  // namespace scene_text
