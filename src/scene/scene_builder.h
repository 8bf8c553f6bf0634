// SceneBuilder: reads the words of a scene file and fills a SceneParser with what they say, by
// recursive descent: one function for each block of the grammar.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scene/block_reader.h"
#include "scene/mesh_library.h"
#include "scene/object_places.h"
#include "scene/scene_parser.h"
#include "shading/solid_texture.h"

class SceneBuilder {
 public:
  /// How deep Groups and Transforms may stand inside each other.
  static constexpr int kMaxNesting = 1000;

  /// All three must outlive the builder.
  SceneBuilder(const SourceText& text, MistakeLog& log, SceneParser& scene);

  /// Also enters in `places` where each object stands; not owned.
  void note(ObjectPlaces& places) { places_ = &places; }

  /// Reads everything; mistakes go to the log.
  void build();

 private:
  /// A block that begins with the count of what it holds.
  struct CountedBlock {
    std::string_view owner;      // "Group"
    std::string_view countName;  // "numObjects"
    WordList items;              // what is counted
    WordList allowed;            // what may stand in the block
  };

  /// What materials of every kind have, with the values that hold where none are given.
  struct MaterialBase {
    Vec3f diffuseColor{1, 1, 1}, transparentColor, reflectiveColor;
    float indexOfRefraction = 1;
    int priority = 0;
  };

  /// What a solid texture's block says.
  struct TextureWords {
    Matrix toTexture;
    std::vector<SolidTexture::Component> parts;
    int octaves = 1;
    double size = 1, frequency = 0, amplitude = 0;
    bool hasTransform = false, areIndicesGood = true;
  };

  // Sections.
  void readSection();
  void readMisplaced();
  void readCamera(bool isPerspective);
  bool checkFrame(const Vec3d& direction, const Field& directionField, const Vec3d& up,
                  const Field& upField);
  void readLights();
  void readLight();
  void readBackground();
  void reportSecond(std::string_view what, bool& isSeen);
  void finish();

  // Materials: readMaterial reads the one whose name is the current word, one of kMaterialWords, by
  // the reader of its kind, each of which begins with readMaterialFields.
  void readMaterials();
  std::unique_ptr<Material> readMaterial();
  std::unique_ptr<Material> readPhong();
  std::unique_ptr<Material> readBlinnPhong();
  std::unique_ptr<Material> readCookTorrance();
  std::unique_ptr<Material> readWard();
  std::unique_ptr<Material> readOrenNayar();
  std::vector<Field> readMaterialFields(MaterialBase& base, std::vector<Field> fields);
  void readInlineMaterial();
  void readMaterialIndex();
  bool checkMaterial(std::string_view owner, const char* at);

  // Solid textures.
  std::unique_ptr<Material> readTexture();
  std::unique_ptr<Material> makeTexture(std::string_view owner, const TextureWords& words);
  bool readTextureTransform(std::string_view owner, TextureWords& words);
  bool readPart(std::string_view owner, TextureWords& words);
  bool readOctaves(int& octaves);

  // Objects: each returns null where there was a mistake. The scene owns what they return.
  const Object3D* readObject();
  const Object3D* readUnnotedObject();
  const Object3D* readGroup();
  const Object3D* readTransform();
  const Object3D* readSphere();
  const Object3D* readPlane();
  const Object3D* readTriangle();
  const Object3D* readTriangleMesh();
  /// `at` is where a Sphere, Triangle or TriangleMesh begins.
  template <class T>
  const T* keep(std::unique_ptr<T> object, const char* at = nullptr);
  bool isTooDeep();

  // The inside of a Transform. `allowed` is what may stand there.
  bool readSteps(Matrix& product, WordList allowed, bool mustInvert);
  bool readStep(Matrix& product, bool mustInvert);
  bool readStepNumbers(std::string_view name, double* numbers, int count);
  const Object3D* readMovedObject(bool areStepsGood);

  // Lists: `readItem` reads one counted item, whose name is the current word; `readOther` reads
  // something that is not counted and returns true, or returns false where it is unknown.
  void readCounted(const CountedBlock& block, const std::function<void()>& readItem,
                   const std::function<bool()>& readOther);
  bool readCount(const CountedBlock& block, int& count);
  void readCountedItems(const CountedBlock& block, int expected, bool isSure,
                        const std::function<void()>& readItem,
                        const std::function<bool()>& readOther);

  // Checks of values. A field without a good value passes: that mistake is reported already.
  bool checkAbove(double bound, double value, const Field& field);
  bool checkAtLeast(double bound, double value, const Field& field);
  bool checkNotZero(const Vec3d& vector, const Field& field);
  bool checkReflectance(const Vec3f& color, const Field& field);
  void warn(const char* at, const std::string& message);

  // What is legal and probably a mistake. Of one kind only some are named and the rest counted.
  template <class Item, class Warn>
  void warnOfSome(const std::vector<Item>& items, const std::string& what, const Warn& warnOf);
  void warnOfLikelyMistakes();
  void warnOfUnseen(const std::vector<const Object3D*>& objects);
  void warnOfUnusedMaterials();
  void noteColor(const Vec3f& color, const Field& field);
  void noteExponent(const Vec3f& specular, float exponent, const Field& field);
  const char* placeOf(const Object3D& object) const;
  void warnOfMesh(const MeshGeometry& geometry, const char* at);
  void warnOfMoreFlatTriangles();

  BlockReader in_;
  SceneParser& scene_;
  MeshLibrary meshes_;
  std::vector<std::pair<std::size_t, std::string>> warnings_;  // with their place in the file
  const Material* material_ = nullptr;                         // the current one; not owned
  std::size_t materialPlace_ = 0;                              // its place in the scene's list
  ObjectPlaces* places_ = nullptr;                             // null where nobody asks
  /// A material as it stands in the file.
  struct MaterialNote {
    const char* at;
    bool isUsed = false;
    std::vector<std::size_t> parts;  // of a texture: places in the list
  };
  std::vector<MaterialNote> materialNotes_;  // for each material of the scene
  std::vector<const char*> objectStarts_;    // for each object of the scene
  std::vector<const char*> lightStarts_;     // for each light of the scene
  std::vector<std::pair<const char*, std::string>> brightColors_, lowExponents_;
  int listedMaterials_ = 0;
  int depth_ = 0;
  std::size_t flatTriangles_ = 0;
  const char* lightsAt_ = nullptr;
  bool hasCamera_ = false, hasLights_ = false, hasBackground_ = false, hasMaterials_ = false;
  bool hasGroup_ = false;
  bool hasMisplaced_ = false;  // something outside all sections: it may be a section's broken name
  bool areMaterialsSure_ = true;  // false after a mistake among them: an index may be right
  bool isMaterialMissed_ = false;
};

/// Gives the object to the scene.
template <class T>
const T* SceneBuilder::keep(std::unique_ptr<T> object, const char* at) {
  const T* const borrowed = object.get();
  objectStarts_.push_back(at);
  scene_.objects_.push_back(std::move(object));
  return borrowed;
}
