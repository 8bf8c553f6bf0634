// The scene language as data: its words by where they may stand, the fields of each block, and the
// steps of a Transform. FieldReader reads blocks by these tables; a word that is not here is none.
#pragma once
#include <array>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>

#include "scene/scene_rules.h"
#include "scene/wording.h"

/// Some of the languages, as bits.
using Languages = unsigned;
constexpr Languages only(Language language) { return Languages(language); }
constexpr Languages but(Languages languages) { return ~languages; }
inline constexpr Languages kEvery = but(0);
inline constexpr Languages kOf2003 = only(Language::of2003), kOf2012 = only(Language::of2012),
                           kOf2016 = only(Language::of2016), kOf2020 = only(Language::of2020),
                           kOfThu = only(Language::ofThu), kNot2003 = but(kOf2003),
                           kNot2020 = but(kOf2020);
/// A course that has the language.
inline constexpr std::pair<Language, std::string_view> kLanguageNames[] = {
    {Language::of2003, "2003"}, {Language::of2012, "2012"}, {Language::of2016, "2016"},
    {Language::of2020, "2020"}, {Language::ofThu, "thu"},
};
constexpr bool isIn(Languages languages, Language language) {
  return (languages & Languages(language)) != 0;
}

/// The form of a value: what stands behind a field's name.
enum class Form {
  number,     ///< one, as a double
  single,     ///< one, as a float
  vector,     ///< three, as doubles
  color,      ///< three, as floats
  whole,      ///< one without point and exponent, as an int
  fileName,   ///< any word but a brace
  choice,     ///< one of kDistributionWords, as its place among them
  ownReader,  ///< what the block's reader reads on its own
};

/// What a value must be, or else be reported.
enum class Range {
  any,
  aboveZero,
  atLeastZero,
  angle,        ///< degrees above 0 and below 180
  direction,    ///< a vector that is not zero
  color,        ///< any, but a component above 1 is noted for a warning
  side,         ///< pixels, from 1 to SceneParser::kMostPixels
  octaves,      ///< from 0 to math::kMaxOctaves
  reflectance,  ///< a colour with components from 0 to 1
};

/// A named value in a block.
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding): in the order in which rows read best
struct Field {
  std::string_view block;  // a word of the language, or what several blocks have in common
  std::string_view name;
  Form form;
  Range range = Range::any;
  bool isOptional = false;
  std::array<double, 3> defaults{};  // where it is optional
  Languages languages = kEvery;      // that have it
  std::string_view meaning = name;   // the name by which the program asks for its value
};
inline constexpr bool kOptional = true;

/// The fields of each block stand together, in the order in which messages list them; the blocks
/// that a scene may have a million times come first. A name that languages use in different ways
/// has a row for each, and so have two names of one thing.
inline constexpr Field kFields[] = {
    {"Sphere", "center", Form::vector, Range::any, false, {}, kNot2020},
    {"Sphere", "center", Form::vector, Range::any, kOptional, {}, kOf2020},
    {"Sphere", "radius", Form::number, Range::aboveZero},
    {"Triangle", "vertex0", Form::vector},
    {"Triangle", "vertex1", Form::vector},
    {"Triangle", "vertex2", Form::vector},
    {"TriangleMesh", "obj_file", Form::fileName},
    {"Plane", "normal", Form::vector, Range::direction},
    {"Plane", "offset", Form::number},

    {"any camera", "center", Form::vector},
    {"any camera", "direction", Form::vector, Range::direction},
    {"any camera", "up", Form::vector, Range::direction},
    {"OrthographicCamera", "size", Form::number, Range::aboveZero},
    {"PerspectiveCamera", "angle", Form::number, Range::angle, false, {}, kNot2020},
    {"PerspectiveCamera", "width", Form::whole, Range::side, kOptional, {}, kOfThu},
    {"PerspectiveCamera", "height", Form::whole, Range::side, kOptional, {}, kOfThu},
    {"Camera", "fov", Form::number, Range::angle, false, {}, kOf2020, "angle"},

    {"DirectionalLight", "direction", Form::vector, Range::direction},
    {"DirectionalLight", "color", Form::color},
    {"PointLight", "position", Form::vector, Range::any, false, {}, kNot2020},
    {"PointLight", "color", Form::color},
    {"PointLight", "attenuation", Form::vector, Range::any, kOptional, {1, 0, 0}, kOf2003},
    {"PointLight", "falloff", Form::number, Range::any, kOptional, {}, kOf2012},
    {"PointLight", "falloff", Form::number, Range::any, false, {}, kOf2016},
    {"point light", "color", Form::color, Range::any, false, {}, kOf2020},
    {"point light", "attenuation", Form::number, Range::any, kOptional, {20}, kOf2020, "falloff"},

    {"Background", "color", Form::color, Range::color, kOptional, {0.5, 0.5, 0.5}},
    {"Background", "ambientLight", Form::color, Range::color, kOptional, {}, but(kOfThu)},
    {"Background", "cubeMap", Form::fileName, Range::any, kOptional, {}, but(kOf2003 | kOfThu)},

    {"any material", "diffuseColor", Form::color, Range::color, kOptional, {1, 1, 1}, kNot2020},
    {"any material", "transparentColor", Form::color, Range::color, kOptional, {}, kNot2020},
    {"any material", "reflectiveColor", Form::color, Range::color, kOptional, {}, kNot2020},
    {"any material", "indexOfRefraction", Form::single, Range::aboveZero, kOptional, {1}, kNot2020},
    {"any material", "priority", Form::whole, Range::any, kOptional, {}, kNot2020},
    {"Phong", "specularColor", Form::color, Range::color, kOptional, {}, kNot2020},
    {"Phong", "exponent", Form::single, Range::atLeastZero, kOptional, {1}, kOf2003},
    {"Phong", "shininess", Form::single, Range::atLeastZero, kOptional, {}, kNot2003, "exponent"},
    {"Phong", "refractionIndex", Form::single, Range::atLeastZero, kOptional, {}, kOf2012},
    {"Phong", "texture", Form::fileName, Range::any, kOptional, {}, kOf2012},
    {"Phong", "Noise", Form::ownReader, Range::any, kOptional, {}, kOf2012},
    {"Phong", "bump", Form::fileName, Range::any, kOptional, {}, kOf2012 | kOf2016},
    {"node", "diffuse", Form::color, Range::color, kOptional, {1, 1, 1}, kOf2020, "diffuseColor"},
    {"node", "specular", Form::color, Range::color, kOptional, {}, kOf2020, "specularColor"},
    {"node", "shininess", Form::single, Range::atLeastZero, kOptional, {}, kOf2020, "exponent"},
    {"CookTorranceMaterial", "roughness", Form::single, Range::aboveZero, kOptional, {0.2}},
    {"CookTorranceMaterial", "index", Form::single, Range::aboveZero, kOptional, {1.5}},
    {"CookTorranceMaterial", "specularColor", Form::color, Range::reflectance, kOptional},
    {"CookTorranceMaterial", "distribution", Form::choice, Range::any, kOptional},
    {"WardMaterial", "specularColor", Form::color, Range::color, kOptional},
    {"WardMaterial", "roughnessX", Form::single, Range::aboveZero, kOptional, {0.2}},
    {"WardMaterial", "roughnessY", Form::single, Range::aboveZero, kOptional, {0.2}},
    {"WardMaterial", "tangent", Form::vector, Range::direction, kOptional, {1, 0, 0}},
    {"OrenNayarMaterial", "roughness", Form::single, Range::atLeastZero, kOptional, {0.5}},

    {"any texture", "Transform", Form::ownReader, Range::any, kOptional},
    {"any texture", "materialIndex", Form::ownReader},
    {"Checkerboard", "size", Form::number, Range::aboveZero, kOptional, {1}},
    {"Noise", "octaves", Form::whole, Range::octaves},
    {"noise of colors", "color", Form::ownReader},
    {"noise of colors", "octaves", Form::whole, Range::octaves},
    {"noise of colors", "frequency", Form::number},
    {"noise of colors", "amplitude", Form::number},
    {"any wave", "octaves", Form::whole, Range::octaves},
    {"any wave", "frequency", Form::number},
    {"any wave", "amplitude", Form::number},
};
/// No block, with what it has in common with others, has more fields.
inline constexpr std::size_t kMostFields = 11;

/// A step of a Transform.
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding): in the order in which rows read best
struct Step {
  std::string_view name;
  std::size_t numbers;    // how many follow the name; angles are in degrees
  bool canBeSingular;     // no translation by finite numbers is, nor a turn about an axis
  std::string_view kind;  // the name that it has in 2003
  Languages languages;
};
inline constexpr std::size_t kMostStepNumbers = 16;
inline constexpr Step kSteps[] = {
    {"Translate", 3, false, "Translate", kNot2020},
    {"Scale", 3, true, "Scale", kNot2020},
    {"UniformScale", 1, true, "UniformScale", kNot2020},
    {"XRotate", 1, false, "XRotate", kNot2020},
    {"YRotate", 1, false, "YRotate", kNot2020},
    {"ZRotate", 1, false, "ZRotate", kNot2020},
    {"Rotate", 4, true, "Rotate", kNot2020},
    {"Matrix", kMostStepNumbers, true, "Matrix", kNot2020},
    {"Matrix4f", kMostStepNumbers, true, "Matrix", kOf2012 | kOf2016 | kOfThu},
    {"translate", 3, false, "Translate", kOf2020},
    {"scale", 3, true, "Scale", kOf2020},
    {"x_rotate", 1, false, "XRotate", kOf2020},
    {"y_rotate", 1, false, "YRotate", kOf2020},
    {"z_rotate", 1, false, "ZRotate", kOf2020},
};

// The words, by where they may stand, in the order in which messages list them.

template <std::size_t count>
using WordArray = std::array<std::string_view, count>;

/// One list behind the other.
template <std::size_t n, std::size_t m>
constexpr WordArray<n + m> bothOf(const WordArray<n>& first, const WordArray<m>& second) {
  WordArray<n + m> words{};
  for (std::size_t i = 0; i < n + m; ++i) words[i] = i < n ? first[i] : second[i - n];
  return words;
}

inline constexpr WordArray<6> kSectionWords = {"OrthographicCamera", "PerspectiveCamera", "Lights",
                                               "Background",         "Materials",         "Group"};
inline constexpr WordArray<2> kLightWords = {"DirectionalLight", "PointLight"};
inline constexpr WordArray<4> kTextureWords = {"Checkerboard", "Noise", "Marble", "Wood"};
inline constexpr auto kMaterialWords =
    bothOf(WordArray<6>{"PhongMaterial", "Material", "BlinnPhongMaterial", "CookTorranceMaterial",
                        "WardMaterial", "OrenNayarMaterial"},
           kTextureWords);
inline constexpr WordArray<6> kObjectWords = {"Group", "Transform", "Sphere",
                                              "Plane", "Triangle",  "TriangleMesh"};
/// What may stand in a Group after its count.
inline constexpr auto kGroupWords =
    bothOf(kObjectWords, bothOf(WordArray<1>{"MaterialIndex"}, kMaterialWords));
/// All that may stand in the Transform of a texture, and what may in that of an object.
inline constexpr WordArray<8> kStepWords = {"Translate", "Scale",   "UniformScale", "XRotate",
                                            "YRotate",   "ZRotate", "Rotate",       "Matrix"};
inline constexpr auto kTransformWords = bothOf(kStepWords, kObjectWords);
/// In 2020: the sections, the steps of a Transform, and what may stand in a Node.
inline constexpr WordArray<4> kNodeSectionWords = {"Background", "Camera", "Materials", "Scene"};
inline constexpr WordArray<5> kNodeStepWords = {"translate", "scale", "x_rotate", "y_rotate",
                                                "z_rotate"};
inline constexpr WordArray<5> kNodeWords = {"Transform", "Component<Material>", "Component<Object>",
                                            "Component<Light>", "Node"};
/// What places on the way to an object are called.
inline constexpr auto kPlaceWords = bothOf(kObjectWords, WordArray<2>{"Scene", "Node"});
inline constexpr WordArray<1> kNodeMaterialWords = {"Material"};
/// The types of objects and lights there; and the blocks that have the fields of each.
inline constexpr WordArray<4> kShapeTypes = {"sphere", "plane", "triangle", "mesh"};
inline constexpr WordArray<4> kShapeBlocks = {"Sphere", "Plane", "Triangle", "TriangleMesh"};
inline constexpr WordArray<2> kLightTypes = {"point", "directional"};
inline constexpr WordArray<2> kLightBlocks = {"point light", "DirectionalLight"};
/// The counts with which blocks of several items begin.
inline constexpr WordArray<3> kCountWords = {"numLights", "numMaterials", "numObjects"};
/// What a CookTorranceMaterial's distribution may be, the default first.
inline constexpr WordArray<2> kDistributionWords = {"GGX", "Beckmann"};
/// The words that begin a block or a setting, but for steps, and the languages that have them.
inline constexpr std::pair<WordList, Languages> kBlockWords[] = {
    {kGroupWords, kNot2020},      {kSectionWords, kNot2020}, {kLightWords, kNot2020},
    {kNodeSectionWords, kOf2020}, {kNodeWords, kOf2020},     {kNodeMaterialWords, kOf2020},
};
