// The scene language as data: its words by where they may stand, the fields of each block, and the
// steps of a Transform. FieldReader reads blocks by these tables; a word that is not here is none.
//
// A block's fields are a struct of values, each with its default, and a table that names them:
//     struct SphereFields {
//       Given<Vec3d> center;
//       Given<double> radius;
//       static constexpr Field kFields[] = {{"center", placeIn<&SphereFields::center>}, ...};
//     };
// The type of a value says what is read for it. Blocks that share fields are read by several such
// structs at once, e.g. a material by those of its kind and by MaterialFields.
#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string_view>
#include <variant>

#include "math/matrix.h"
#include "math/vec3.h"
#include "scene/wording.h"

/// A value of a block, at first its default, and where it stands in the file: null unless a good
/// one was given.
template <class T>
struct Given {
  T value{};
  const char* at = nullptr;
};

/// One of several words, as its place in their list.
struct WordChoice {
  WordList words;
  std::size_t index;
};

/// Reads what stands behind a field's name, and returns false after a mistake: for values that no
/// type says all of.
using ReadValue = std::function<bool()>;

/// Where a value goes: what is read follows from the type.
using FieldPlace =
    std::variant<Given<double>*, Given<float>*, Given<int>*, Given<Vec3d>*, Given<Vec3f>*,
                 Given<std::string_view>*, Given<WordChoice>*, Given<ReadValue>*>;

/// What a value must be, or else be reported.
enum class Range {
  any,
  aboveZero,
  atLeastZero,
  angle,        ///< degrees above 0 and below 180
  direction,    ///< a vector that is not zero; it is brought to a length near 1 then
  color,        ///< any, but a component above 1 is noted for a warning
  reflectance,  ///< a colour with components from 0 to 1
};

/// A named value in a block.
struct Field {
  std::string_view name;
  FieldPlace (*in)(void* block);  // in the struct that the field belongs to
  Range range = Range::any;
  bool isRequired = true;
};

template <class Block, class T>
FieldPlace placeOf(Given<T> Block::*member, void* block) {
  return &(static_cast<Block*>(block)->*member);
}
template <auto member>
FieldPlace placeIn(void* block) {
  return placeOf(member, block);
}

// The fields of each block, in the order in which messages list them.

struct FrameFields {  // of a camera
  Given<Vec3d> center, direction, up;
  static constexpr Field kFields[] = {
      {"center", placeIn<&FrameFields::center>},
      {"direction", placeIn<&FrameFields::direction>, Range::direction},
      {"up", placeIn<&FrameFields::up>, Range::direction}};
};
struct OrthographicFields {
  Given<double> size;
  static constexpr Field kFields[] = {
      {"size", placeIn<&OrthographicFields::size>, Range::aboveZero}};
};
struct PerspectiveFields {
  Given<double> angle;
  static constexpr Field kFields[] = {{"angle", placeIn<&PerspectiveFields::angle>, Range::angle}};
};

struct DirectionalLightFields {
  Given<Vec3d> direction;
  Given<Vec3f> color;
  static constexpr Field kFields[] = {
      {"direction", placeIn<&DirectionalLightFields::direction>, Range::direction},
      {"color", placeIn<&DirectionalLightFields::color>}};
};
struct PointLightFields {
  Given<Vec3d> position, attenuation{{1, 0, 0}};
  Given<Vec3f> color;
  static constexpr Field kFields[] = {
      {"position", placeIn<&PointLightFields::position>},
      {"color", placeIn<&PointLightFields::color>},
      {"attenuation", placeIn<&PointLightFields::attenuation>, Range::any, false}};
};

struct BackgroundFields {
  Given<Vec3f> color{{0.5f, 0.5f, 0.5f}}, ambientLight;
  static constexpr Field kFields[] = {
      {"color", placeIn<&BackgroundFields::color>, Range::color, false},
      {"ambientLight", placeIn<&BackgroundFields::ambientLight>, Range::color, false}};
};

struct MaterialFields {  // of materials of every kind but textures
  Given<Vec3f> diffuseColor{{1, 1, 1}}, transparentColor, reflectiveColor;
  Given<float> indexOfRefraction{1};
  Given<int> priority;
  static constexpr Field kFields[] = {
      {"diffuseColor", placeIn<&MaterialFields::diffuseColor>, Range::color, false},
      {"transparentColor", placeIn<&MaterialFields::transparentColor>, Range::color, false},
      {"reflectiveColor", placeIn<&MaterialFields::reflectiveColor>, Range::color, false},
      {"indexOfRefraction", placeIn<&MaterialFields::indexOfRefraction>, Range::aboveZero, false},
      {"priority", placeIn<&MaterialFields::priority>, Range::any, false}};
};
struct PhongFields {
  Given<Vec3f> specularColor;
  Given<float> exponent{1};
  static constexpr Field kFields[] = {
      {"specularColor", placeIn<&PhongFields::specularColor>, Range::color, false},
      {"exponent", placeIn<&PhongFields::exponent>, Range::atLeastZero, false}};
};
struct CookTorranceFields {
  static constexpr std::string_view kDistributions[] = {"GGX", "Beckmann"};
  Given<float> roughness{0.2f}, index{1.5f};
  Given<Vec3f> specularColor;
  Given<WordChoice> distribution{{kDistributions, 0}};
  static constexpr Field kFields[] = {
      {"roughness", placeIn<&CookTorranceFields::roughness>, Range::aboveZero, false},
      {"index", placeIn<&CookTorranceFields::index>, Range::aboveZero, false},
      {"specularColor", placeIn<&CookTorranceFields::specularColor>, Range::reflectance, false},
      {"distribution", placeIn<&CookTorranceFields::distribution>, Range::any, false}};
};
struct WardFields {
  Given<Vec3f> specularColor;
  Given<float> roughnessX{0.2f}, roughnessY{0.2f};
  Given<Vec3d> tangent{{1, 0, 0}};
  static constexpr Field kFields[] = {
      {"specularColor", placeIn<&WardFields::specularColor>, Range::color, false},
      {"roughnessX", placeIn<&WardFields::roughnessX>, Range::aboveZero, false},
      {"roughnessY", placeIn<&WardFields::roughnessY>, Range::aboveZero, false},
      {"tangent", placeIn<&WardFields::tangent>, Range::direction, false}};
};
struct OrenNayarFields {
  Given<float> roughness{0.5f};
  static constexpr Field kFields[] = {
      {"roughness", placeIn<&OrenNayarFields::roughness>, Range::atLeastZero, false}};
};

struct TextureFields {  // of textures of every kind
  Given<ReadValue> transform, materialIndex;
  static constexpr Field kFields[] = {
      {"Transform", placeIn<&TextureFields::transform>, Range::any, false},
      {"materialIndex", placeIn<&TextureFields::materialIndex>}};
};
struct CheckerboardFields {
  Given<double> size{1};
  static constexpr Field kFields[] = {
      {"size", placeIn<&CheckerboardFields::size>, Range::aboveZero, false}};
};
struct NoiseFields {
  Given<ReadValue> octaves;
  static constexpr Field kFields[] = {{"octaves", placeIn<&NoiseFields::octaves>}};
};
struct WaveFields {  // of Marble and Wood, behind those of Noise
  Given<double> frequency, amplitude;
  static constexpr Field kFields[] = {{"frequency", placeIn<&WaveFields::frequency>},
                                      {"amplitude", placeIn<&WaveFields::amplitude>}};
};

struct SphereFields {
  Given<Vec3d> center;
  Given<double> radius;
  static constexpr Field kFields[] = {{"center", placeIn<&SphereFields::center>},
                                      {"radius", placeIn<&SphereFields::radius>, Range::aboveZero}};
};
struct PlaneFields {
  Given<Vec3d> normal;
  Given<double> offset;
  static constexpr Field kFields[] = {{"normal", placeIn<&PlaneFields::normal>, Range::direction},
                                      {"offset", placeIn<&PlaneFields::offset>}};
};
struct TriangleFields {
  Given<Vec3d> vertex0, vertex1, vertex2;
  static constexpr Field kFields[] = {{"vertex0", placeIn<&TriangleFields::vertex0>},
                                      {"vertex1", placeIn<&TriangleFields::vertex1>},
                                      {"vertex2", placeIn<&TriangleFields::vertex2>}};
};
struct MeshFields {
  Given<std::string_view> file;
  static constexpr Field kFields[] = {{"obj_file", placeIn<&MeshFields::file>}};
};

// The steps of a Transform.

struct Step {
  std::string_view name;
  std::size_t numbers;  // how many follow the name; angles are in degrees
  Matrix (*toMatrix)(const double* numbers);
  bool canBeSingular;  // no translation by finite numbers is, nor a turn about an axis
};
inline constexpr std::size_t kMostStepNumbers = 16;

inline constexpr Step kSteps[] = {{"Translate", 3,
                                   [](const double* n) {
                                     return Matrix::translation({n[0], n[1], n[2]});
                                   },
                                   false},
                                  {"Scale", 3,
                                   [](const double* n) {
                                     return Matrix::scale({n[0], n[1], n[2]});
                                   },
                                   true},
                                  {"UniformScale", 1,
                                   [](const double* n) {
                                     return Matrix::scale({n[0], n[0], n[0]});
                                   },
                                   true},
                                  {"XRotate", 1,
                                   [](const double* n) {
                                     return Matrix::rotation({1, 0, 0}, n[0]);
                                   },
                                   false},
                                  {"YRotate", 1,
                                   [](const double* n) {
                                     return Matrix::rotation({0, 1, 0}, n[0]);
                                   },
                                   false},
                                  {"ZRotate", 1,
                                   [](const double* n) {
                                     return Matrix::rotation({0, 0, 1}, n[0]);
                                   },
                                   false},
                                  {"Rotate", 4,
                                   [](const double* n) {
                                     return Matrix::rotation({n[0], n[1], n[2]}, n[3]);
                                   },
                                   true},
                                  {"Matrix", kMostStepNumbers,
                                   [](const double* n) {
                                     double rows[3][4];
                                     for (int i = 0; i < 12; ++i) rows[i / 4][i % 4] = n[i];
                                     return Matrix(rows);
                                   },
                                   true}};

// The words, by where they may stand.

/// All words of some lists.
template <std::size_t... sizes>
constexpr auto joined(const std::array<std::string_view, sizes>&... lists) {
  std::array<std::string_view, (sizes + ...)> all{};
  std::size_t count = 0;
  const auto append = [&](const auto& list) {
    for (const std::string_view word : list) all[count++] = word;
  };
  (append(lists), ...);
  return all;
}
template <class Row, std::size_t size>
constexpr auto namesOf(const Row (&rows)[size]) {
  std::array<std::string_view, size> names{};
  for (std::size_t i = 0; i < size; ++i) names[i] = rows[i].name;
  return names;
}

inline constexpr std::array<std::string_view, 6> kSectionWords = {
    "OrthographicCamera", "PerspectiveCamera", "Lights", "Background", "Materials", "Group"};
inline constexpr std::array<std::string_view, 2> kLightWords = {"DirectionalLight", "PointLight"};
inline constexpr std::array<std::string_view, 10> kMaterialWords = {"PhongMaterial",
                                                                    "Material",
                                                                    "BlinnPhongMaterial",
                                                                    "CookTorranceMaterial",
                                                                    "WardMaterial",
                                                                    "OrenNayarMaterial",
                                                                    "Checkerboard",
                                                                    "Noise",
                                                                    "Marble",
                                                                    "Wood"};
inline constexpr std::array<std::string_view, 6> kObjectWords = {
    "Group", "Transform", "Sphere", "Plane", "Triangle", "TriangleMesh"};
inline constexpr std::array<std::string_view, 1> kMaterialIndexWord = {"MaterialIndex"};
/// What may stand in a Group after its count.
inline constexpr auto kGroupWords = joined(kObjectWords, kMaterialIndexWord, kMaterialWords);
/// What may stand in the Transform of a texture, and in that of an object.
inline constexpr auto kStepWords = namesOf(kSteps);
inline constexpr auto kTransformWords = joined(kStepWords, kObjectWords);
/// Names of values inside blocks.
inline constexpr std::array<std::string_view, 3> kCountWords = {"numLights", "numMaterials",
                                                                "numObjects"};
inline constexpr auto kFieldWords = joined(
    kCountWords, namesOf(FrameFields::kFields), namesOf(OrthographicFields::kFields),
    namesOf(PerspectiveFields::kFields), namesOf(DirectionalLightFields::kFields),
    namesOf(PointLightFields::kFields), namesOf(BackgroundFields::kFields),
    namesOf(MaterialFields::kFields), namesOf(PhongFields::kFields),
    namesOf(CookTorranceFields::kFields), namesOf(WardFields::kFields),
    namesOf(OrenNayarFields::kFields), namesOf(TextureFields::kFields),
    namesOf(CheckerboardFields::kFields), namesOf(NoiseFields::kFields),
    namesOf(WaveFields::kFields), namesOf(SphereFields::kFields), namesOf(PlaneFields::kFields),
    namesOf(TriangleFields::kFields), namesOf(MeshFields::kFields));
