// SceneParser: reads a scene file and owns everything in it: the one owner of the program.
// Every other pointer to a camera, light, material, object or mesh is borrowed from here.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "camera/camera.h"
#include "geometry/group.h"
#include "geometry/mesh_geometry.h"
#include "scene/input_error.h"
#include "scene/scene_rules.h"
#include "scene/solid_objects.h"
#include "shading/background.h"
#include "shading/light.h"
#include "shading/material.h"

class ObjectPlaces;
class SourceText;

class SceneParser {
 public:
  /// Reads `filename` ("-" is standard input) and the meshes it names. Throws InputError at the
  /// first mistake. Where `places` is given, also enters there where each object stands. `rules`
  /// say what words mean.
  explicit SceneParser(const char* filename, ObjectPlaces* places = nullptr,
                       const SceneRules& rules = {});
  /// The same of a scene file that has been read already.
  explicit SceneParser(const SourceText& text, ObjectPlaces* places = nullptr,
                       const SceneRules& rules = {});
  ~SceneParser();
  SceneParser(const SceneParser&) = delete;
  SceneParser& operator=(const SceneParser&) = delete;

  /// Reads everything and returns all mistakes that can be told apart, in file order; none if the
  /// scene is good. Never throws for a mistake in the input. Of a good scene `warnings`, where not
  /// null, becomes what getWarnings() would be.
  static std::vector<InputError> check(const char* filename,
                                       std::vector<std::string>* warnings = nullptr,
                                       const SceneRules& rules = {});

  /// Whether the text of a scene of 2012 has a refractionIndex other than 0.
  static bool hasGlass(const SourceText& text);

  // What the getters return is owned by this parser and lives as long as it does. Colours are as
  // the file gives them, mostly 0..1, but any finite number is legal.

  /// Never null once the constructor has returned; there is exactly one.
  const Camera* getCamera() const { return camera_.get(); }
  /// 0.5 0.5 0.5 where the file does not say.
  Vec3f getBackgroundColor() const { return background_.getColor(); }
  /// That colour, or a cube map, as seen in each direction.
  const Background& getBackground() const { return background_; }
  /// Black where the file does not say; white where the scene has no lights at all.
  Vec3f getAmbientLight() const { return ambientLight_; }
  /// 0 or more.
  int getNumLights() const { return int(lights_.size()); }
  /// 0 <= i < getNumLights(), in file order. Never null.
  const Light* getLight(int i) const { return lights_[std::size_t(i)].get(); }
  /// 0 or more.
  int getNumMaterials() const { return int(materials_.size()); }
  /// 0 <= i < getNumMaterials(), in file order; materials written inside a Group come after the
  /// listed ones. Never null.
  const Material* getMaterial(int i) const { return materials_[std::size_t(i)].get(); }
  /// All objects of the scene: one Group that holds the file's top-level Groups in order.
  /// Never null; empty where the file has no Group.
  const Group* getGroup() const { return &group_; }

  /// The files of the meshes and, behind them, of the pictures, as absolute paths without links:
  /// one for each name that the scene calls a mesh or a picture by, in the alphabetical order of
  /// these names. Two names may have one file.
  const std::vector<std::string>& getInputFiles() const { return inputFiles_; }

  /// The memory of the pictures of textures and cube maps.
  std::size_t getPictureBytes() const;

  /// What is legal but probably a mistake: "FILE:LINE: text" each, in file order.
  const std::vector<std::string>& getWarnings() const { return warnings_; }

  /// The size that the scene gives its picture, in pixels, 1..kMostPixels; 0, 0 where it does not.
  struct PictureSize {
    int width = 0, height = 0;
  };
  static constexpr int kMostPixels = 65535;
  const PictureSize& getPictureSize() const { return pictureSize_; }
  /// Whether a surface of the scene shows the highlights of lights that are behind it.
  bool hasHighlightsBehind() const { return hasHighlightsBehind_; }

  /// The longest side of the world box of all spheres and triangles; 0 where there are none.
  double getSpan() const;

  /// The thinnest closed object of transparent material that is thinner than kThinSolid, a hundred
  /// times the assignment's epsilon: rays that start an epsilon off its front may miss its back.
  static constexpr double kThinSolid = 0.1;
  const ThinSolid& getThinnestSolid() const { return thinnest_; }

  /// Finds out which meshes of transparent material enclose a volume, and lists all such solids.
  /// Needed once, before rendering with RenderOptions::transparentShadows, nestedDielectrics or
  /// fresnel: the one change after reading.
  void findSolids();
  /// What findSolids has listed; null before.
  const SolidObjects* getSolids() const { return solids_ ? &*solids_ : nullptr; }

 private:
  friend class SceneReader;     // fills all below while reading,
  friend class MaterialReader;  // with the materials and what belongs to them
  SceneParser() = default;      // empty, for check()

  std::unique_ptr<Camera> camera_;
  Background background_;
  Vec3f ambientLight_;
  std::vector<std::unique_ptr<Light>> lights_;
  std::vector<std::unique_ptr<ImageTexture>> pictures_;
  std::vector<std::unique_ptr<NoiseMap>> noiseMaps_;
  std::vector<std::unique_ptr<Material>> materials_;
  std::vector<std::unique_ptr<Object3D>> objects_;
  std::vector<std::unique_ptr<MeshGeometry>> meshes_;
  Group group_;
  std::optional<SolidObjects> solids_;
  PictureSize pictureSize_;
  bool hasHighlightsBehind_ = false;
  ThinSolid thinnest_;
  std::vector<std::string> inputFiles_;
  std::vector<std::string> warnings_;
};
