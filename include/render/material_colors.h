// MaterialColors: a colour for each material of a scene, for pictures that tell them apart.
#pragma once
#include <cstddef>
#include <string>
#include <unordered_map>

#include "image/image.h"
#include "scene/scene_parser.h"

class MaterialColors {
 public:
  /// The scene is not owned and must outlive this.
  explicit MaterialColors(const SceneParser& scene);

  /// The colour of material number `index`, counted from 0: red, green, yellow, blue, magenta,
  /// cyan, white, then darker and mixed ones. The first 2^24 - 1 are all different, and none is
  /// black; then they begin again.
  static Rgb8 colorOf(std::size_t index);

  /// The colour of a material of the scene; grey, (128, 128, 128), where it is another's.
  Rgb8 of(const Material* material) const;

  /// What `picture` shows: a line for each material whose colour is in it, by number:
  /// "material 2: 255 255 0, PhongMaterial, 1234 pixels".
  std::string legend(const Image& picture) const;

 private:
  const SceneParser& scene_;
  std::unordered_map<const Material*, std::size_t> numbers_;  // only looked up
};
