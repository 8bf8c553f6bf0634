// The readers of a scene file, one for each kind of section, by recursive descent: what a function
// reads is the block whose name is the current word. They share a FieldReader, which holds the
// place in the text, and fill vectors that the SceneParser owns.
//
// While they read they note what the scene itself does not keep, for warnings at the end: where
// things stand and which materials are used (SceneNotes; see scene_review.cpp).
#pragma once
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/field_reader.h"
#include "scene/named_files.h"
#include "scene/object_places.h"
#include "scene/scene_parser.h"
#include "shading/optics.h"
#include "shading/phong_material.h"
#include "shading/solid_texture.h"

/// A material as it stands in the file.
struct MaterialNote {
  const char* at;
  bool isUsed = false;
  std::vector<std::size_t> components;  // of a texture: their numbers
};

/// Warnings, and what is noted for them while a scene is read.
class SceneNotes {
 public:
  using Note = FieldReader::Note;

  /// The text must outlive the notes.
  explicit SceneNotes(const SourceText& text) : text_(text) {}

  std::vector<MaterialNote> materials;   // for each material of the scene
  std::size_t listedMaterials = 0;       // so many of these stand in Materials
  std::vector<const char*> lightStarts;  // for each light of the scene
  std::vector<std::pair<const Object3D*, const char*>> objectStarts;  // of shapes
  std::vector<Note> lowExponents;
  std::size_t flatTriangles = 0;

  /// The line where the shape's name stands.
  std::size_t lineOf(const Object3D* object) const {
    return text_.lineAt(fromStartOf(object).data());
  }
  void warn(const char* at, const std::string& message);
  /// Gives the first items to `warnOf`, which returns their Note, and counts the rest at the place
  /// of the first of them.
  template <class Item, class Warn>
  void warnOfSome(const std::vector<Item>& items, const std::string& what, const Warn& warnOf) {
    constexpr std::size_t kMostNamed = 5;
    for (std::size_t i = 0; i < items.size() && i <= kMostNamed; ++i) {
      const Note warning = warnOf(items[i]);
      const bool isNamed = i < kMostNamed;
      warn(warning.first,
           isNamed ? warning.second : "and " + std::to_string(items.size() - i) + " more " + what);
    }
  }
  /// Warns of what is legal in a scene without mistakes and probably a mistake.
  void review(const SceneParser& scene, const std::vector<Note>& brightColors);
  /// All warnings, "FILE:LINE: text" each, in file order.
  std::vector<std::string> inOrder() const;

 private:
  void warnOfUnusedMaterials();
  void warnOfDarkLights(const SceneParser& scene);
  std::string_view fromStartOf(const Object3D* object) const;

  const SourceText& text_;
  std::multimap<const char*, std::string> warnings_;  // by place
};

/// Reads materials, and keeps which one holds for the objects that follow.
class MaterialReader {
 public:
  /// All must outlive the reader. Materials and their noise maps are added to `scene`.
  MaterialReader(FieldReader& in, SceneNotes& notes, SceneParser& scene, PictureLibrary& pictures,
                 const SceneRules& rules)
      : in_(in), notes_(notes), scene_(scene), pictures_(pictures), rules_(rules) {}

  /// The section Materials, from behind its name.
  void readSection();
  /// A material written inside a Group, as in the course's older scenes.
  void readInline();
  /// The setting of that name, from there on: the material that holds for the objects that follow.
  void readIndex(std::string_view name = "MaterialIndex");
  /// The material that holds now, not owned; null where there is none yet.
  const Material* selected() const { return selected_; }
  void select(const Material* material) { selected_ = material; }
  /// The listed material of that index, from there on; that there is none is told by readIndex.
  void selectListed(int index);
  /// The material that holds for the object at `at`, not owned; null where there is none, which is
  /// said once.
  const Material* materialFor(std::string_view owner, const char* at);

 private:
  /// What a solid texture's block says.
  struct TextureWords {
    Matrix toTexture;
    std::vector<const Material*> components;  // null: one that a mistake may have cost
    bool hasTransform = false;
  };

  void add();
  std::unique_ptr<Material> read();
  std::unique_ptr<Material> make(std::string_view owner, const Fields& fields);
  std::unique_ptr<Material> makePhong(std::string_view owner, const Fields& fields,
                                      const DiffuseMap* noise);
  void setHighlight(PhongMaterial& material, std::string_view owner);
  Fresnel fresnelOf(const Fields& fields);
  const DiffuseMap* readNoise();
  const DiffuseMap* mapOf(const Fields& fields, const DiffuseMap* noise);
  std::unique_ptr<Material> readTexture(std::string_view owner);
  std::unique_ptr<Material> makeTexture(std::string_view owner, const Fields& fields,
                                        const TextureWords& words);
  bool readTextureTransform(std::string_view owner, TextureWords& words);
  bool readTextureIndex(std::string_view owner, TextureWords& words);
  const Material* listedMaterial(int index, const char* at, const std::string& name,
                                 const std::string& listedWhere);
  static math::NoisyWaves wavesOf(const Fields& fields);

  FieldReader& in_;
  SceneNotes& notes_;
  SceneParser& scene_;
  PictureLibrary& pictures_;
  const SceneRules rules_;
  const Material* selected_ = nullptr;
  bool isMissed_ = false;
  bool areIndicesSure_ = true;  // false after a mistake among materials: an index may be right
};

/// Reads objects: primitives, meshes, Groups and Transforms. Each function returns null where there
/// was a mistake; the scene owns what they return.
class ObjectReader {
 public:
  /// How deep Groups and Transforms may stand inside each other.
  static constexpr int kMaxNesting = 1000;
  /// After so many warnings of triangles without area the rest are only counted.
  static constexpr std::size_t kFlatTrianglesNamed = 10;

  /// All must outlive the reader; `places` may be null.
  ObjectReader(FieldReader& in, SceneNotes& notes, MaterialReader& materials, MeshLibrary& meshes,
               std::vector<std::unique_ptr<Object3D>>& objects, ObjectPlaces* places)
      : in_(in),
        notes_(notes),
        materials_(materials),
        meshes_(meshes),
        objects_(objects),
        places_(places) {}

  /// The object whose name is the current word, one of kObjectWords.
  const Object3D* read();
  /// A shape of that kind with the fields and material that were read; null where they are wrong.
  const Object3D* addShape(std::string_view owner, const char* at, const Fields& fields,
                           const Material* material);
  const Object3D* keep(std::unique_ptr<Object3D> object);
  /// What is told where objects stand; may be null.
  ObjectPlaces* places() const { return places_; }

 private:
  const Object3D* readShape();
  std::unique_ptr<Object3D> makeShape(std::string_view owner, const char* at, const Fields& fields,
                                      const Material* material);
  const Object3D* readGroup();
  const Object3D* readTransform();
  const Object3D* readMovedObject(bool areStepsGood);
  void warnOfMesh(const MeshGeometry& mesh, const char* at);

  FieldReader& in_;
  SceneNotes& notes_;
  MaterialReader& materials_;
  MeshLibrary& meshes_;
  std::vector<std::unique_ptr<Object3D>>& objects_;
  ObjectPlaces* const places_;
  int depth_ = 0;
};

/// Multiplies the steps of a Transform onto `product`, the first one leftmost, up to the first word
/// that is none of them. `allowed` is what may stand there; where `mustInvert`, a step without an
/// inverse is a mistake. False after a mistake.
bool readSteps(FieldReader& in, WordList allowed, bool mustInvert, Matrix& product);

/// Whether the product of a Transform's steps has an inverse; else reports at `at` that it has
/// none.
bool checkInverse(FieldReader& in, const char* at, const Matrix& product);

class SceneReader;

/// Reads the Scene of 2020: nodes that hold components and other nodes. A Node's Transform and
/// material hold for all in it; the objects of a Node are a Group.
class NodeReader {
 public:
  /// All must outlive the reader. Lights are added to `scene`.
  NodeReader(FieldReader& in, MaterialReader& materials, ObjectReader& objects, SceneReader& scene);

  /// The Scene or Node whose name is the current word; null where it is nested too deep. The scene
  /// owns the result.
  const Object3D* read();

 private:
  /// What has been read of one node.
  struct Contents {
    Group& group;
    std::optional<Matrix> steps;
    bool isEmpty = true;
  };

  void findMaterials();
  void readItem(Contents& contents);
  void readTransform(Contents& contents);
  void readMaterial();
  const Object3D* readObject();
  void readLight();
  bool openComponent(WordList types, std::size_t& type);

  FieldReader& in_;
  MaterialReader& materials_;
  ObjectReader& objects_;
  SceneReader& scene_;
  std::map<const char*, int> materialsAhead_;  // the first index in each node, by its name's place
  Matrix toWorld_;                             // of the node that is being read
  int depth_ = 0;
};

/// Reads a whole scene file.
class SceneReader {
 public:
  /// All must outlive the reader. `places`, where not null, is told where each object stands.
  SceneReader(const SourceText& text, MistakeLog& log, SceneParser& scene, ObjectPlaces* places,
              const SceneRules& rules);

  /// Reads everything; mistakes go to the log.
  void read();

  /// Adds the light at `at`, which has these fields, to the scene. Lights keep their places in the
  /// world: `toWorld` is null where a light's place is there.
  void addLight(const char* at, const Fields& fields, const Matrix* toWorld);

 private:
  void readSection();
  void readMisplaced();
  void readCamera();
  CameraFrame frameOf(const Value& direction, const Value& up) const;
  void readLights();
  void readBackground();
  void readMaterials();
  void readGroup();
  void readNodes();
  void finish();
  void warnOfEmptiness();
  void tellRepeats();
  void review();

  FieldReader in_;
  const SceneRules rules_;
  SceneNotes notes_;
  SceneParser& scene_;
  MeshLibrary meshes_;
  PictureLibrary pictures_;
  MaterialReader materials_;
  ObjectReader objects_;
  const char* lightsAt_ = nullptr;
  std::set<std::string_view> seen_;  // of what may stand once
  bool hasGroup_ = false;
  bool hasMisplaced_ = false;  // something outside all sections: it may be a section's broken name
};
