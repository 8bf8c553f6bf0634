// The words of the scene language, by where they may stand.
#pragma once
#include "scene/wording.h"

inline constexpr std::string_view kSectionWords[] = {
    "OrthographicCamera", "PerspectiveCamera", "Lights", "Background", "Materials", "Group"};
inline constexpr std::string_view kLightWords[] = {"DirectionalLight", "PointLight"};
inline constexpr std::string_view kMaterialWords[] = {"PhongMaterial",
                                                      "Material",
                                                      "BlinnPhongMaterial",
                                                      "CookTorranceMaterial",
                                                      "WardMaterial",
                                                      "OrenNayarMaterial",
                                                      "Checkerboard",
                                                      "Noise",
                                                      "Marble",
                                                      "Wood"};
inline constexpr std::string_view kObjectWords[] = {"Group", "Transform", "Sphere",
                                                    "Plane", "Triangle",  "TriangleMesh"};
/// What may stand in a Group after its count.
inline constexpr std::string_view kGroupWords[] = {"Group",
                                                   "Transform",
                                                   "Sphere",
                                                   "Plane",
                                                   "Triangle",
                                                   "TriangleMesh",
                                                   "MaterialIndex",
                                                   "PhongMaterial",
                                                   "Material",
                                                   "BlinnPhongMaterial",
                                                   "CookTorranceMaterial",
                                                   "WardMaterial",
                                                   "OrenNayarMaterial",
                                                   "Checkerboard",
                                                   "Noise",
                                                   "Marble",
                                                   "Wood"};
/// What may stand in the Transform of a texture.
inline constexpr std::string_view kStepWords[] = {"Translate", "Scale",   "UniformScale", "XRotate",
                                                  "YRotate",   "ZRotate", "Rotate",       "Matrix"};
/// What may stand in the Transform of an object.
inline constexpr std::string_view kTransformWords[] = {
    "Translate", "Scale", "UniformScale", "XRotate", "YRotate", "ZRotate",  "Rotate",
    "Matrix",    "Group", "Transform",    "Sphere",  "Plane",   "Triangle", "TriangleMesh"};
/// Names of values inside blocks.
inline constexpr std::string_view kFieldWords[] = {"center",
                                                   "direction",
                                                   "up",
                                                   "size",
                                                   "angle",
                                                   "numLights",
                                                   "color",
                                                   "position",
                                                   "attenuation",
                                                   "ambientLight",
                                                   "numMaterials",
                                                   "diffuseColor",
                                                   "specularColor",
                                                   "exponent",
                                                   "transparentColor",
                                                   "reflectiveColor",
                                                   "indexOfRefraction",
                                                   "priority",
                                                   "numObjects",
                                                   "radius",
                                                   "normal",
                                                   "offset",
                                                   "vertex0",
                                                   "vertex1",
                                                   "vertex2",
                                                   "obj_file",
                                                   "materialIndex",
                                                   "octaves",
                                                   "frequency",
                                                   "amplitude",
                                                   "roughness",
                                                   "roughnessX",
                                                   "roughnessY",
                                                   "tangent",
                                                   "distribution",
                                                   "index"};

/// True when `word` is `name`, or `name` as the course's older scenes write it: num_objects for
/// numObjects. Names that begin with a capital have only one form.
bool isWord(std::string_view word, std::string_view name);

/// True for every word that begins a block or a setting, so that it cannot be part of another one.
bool isBlockWord(std::string_view word);
/// True for every word of the language.
bool isKnownWord(std::string_view word);
