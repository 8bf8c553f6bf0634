// Objects of a scene file: groups and primitives.
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/triangle.h"
#include "geometry/triangle_mesh.h"
#include "scene/directions.h"
#include "scene/scene_builder.h"
#include "scene/scene_words.h"

namespace {

/// After so many warnings of triangles without area the rest are only counted.
constexpr std::size_t kFlatTrianglesNamed = 10;

}  // namespace

/// Reads the object whose name is the current word, one of kObjectWords.
const Object3D* SceneBuilder::readObject() {
  if (!places_) return readUnnotedObject();
  places_->begin(in_.word(), in_.at());
  const Object3D* const object = readUnnotedObject();
  places_->end(object);
  return object;
}

const Object3D* SceneBuilder::readUnnotedObject() {
  const std::string_view word = in_.word();
  if (word == "Sphere") return readSphere();
  if (word == "Triangle") return readTriangle();
  if (word == "Transform") return readTransform();
  if (word == "TriangleMesh") return readTriangleMesh();
  if (word == "Plane") return readPlane();
  return readGroup();
}

/// Reports, and passes over the block, where a Group or Transform stands too deep.
bool SceneBuilder::isTooDeep() {
  if (depth_ < kMaxNesting) return false;
  in_.report(in_.at(), "expected Groups and Transforms at most " + std::to_string(kMaxNesting) +
                           " deep inside each other, found another " + quoted(in_.word()));
  in_.advance();
  if (in_.word() == "{") in_.skipBlock();
  return true;
}

const Object3D* SceneBuilder::readGroup() {
  if (isTooDeep()) return nullptr;
  ++depth_;
  in_.advance();
  auto group = std::make_unique<Group>();
  const CountedBlock block{"Group", "numObjects", kObjectWords, kGroupWords};
  const auto readItem = [&] {
    if (const Object3D* object = readObject()) group->addObject(object);
  };
  const auto readOther = [this] {
    const bool isIndex = in_.word() == "MaterialIndex";
    if (!isIndex && !WordList(kMaterialWords).contains(in_.word())) return false;
    isIndex ? readMaterialIndex() : readInlineMaterial();
    return true;
  };
  readCounted(block, readItem, readOther);
  --depth_;
  return keep(std::move(group));
}

const Object3D* SceneBuilder::readSphere() {
  const char* const at = in_.at();
  const bool hasMaterial = checkMaterial("Sphere", at);
  in_.advance();
  Vec3d center;
  double radius = 0;
  Field fields[] = {{"center", &center}, {"radius", &radius}};
  const bool isGood = in_.readFields("Sphere", fields);
  if (!checkAbove(0, radius, fields[1]) || !isGood || !hasMaterial) return nullptr;
  return keep(std::make_unique<Sphere>(center, radius, material_), at);
}

const Object3D* SceneBuilder::readPlane() {
  const bool hasMaterial = checkMaterial("Plane", in_.at());
  in_.advance();
  Vec3d normal;
  double offset = 0;
  Field fields[] = {{"normal", &normal}, {"offset", &offset}};
  const bool isGood = in_.readFields("Plane", fields);
  if (!checkNotZero(normal, fields[0]) || !isGood || !hasMaterial) return nullptr;
  return keep(std::make_unique<Plane>(rescaled(normal), offset, material_));
}

const Object3D* SceneBuilder::readTriangle() {
  const char* const at = in_.at();
  const bool hasMaterial = checkMaterial("Triangle", at);
  in_.advance();
  Vec3d vertices[3];
  Field fields[] = {
      {"vertex0", &vertices[0]}, {"vertex1", &vertices[1]}, {"vertex2", &vertices[2]}};
  if (!in_.readFields("Triangle", fields) || !hasMaterial) return nullptr;
  auto triangle = std::make_unique<Triangle>(vertices[0], vertices[1], vertices[2], material_);
  if (!triangle->hasArea() && ++flatTriangles_ <= kFlatTrianglesNamed) {
    warn(at, "the triangle has no area: it will not be seen");
  }
  return keep(std::move(triangle), at);
}

const Object3D* SceneBuilder::readTriangleMesh() {
  const char* const at = in_.at();
  const bool hasMaterial = checkMaterial("TriangleMesh", at);
  in_.advance();
  std::string_view name;
  Field fields[] = {{"obj_file", &name}};
  if (!in_.readFields("TriangleMesh", fields)) return nullptr;
  bool isNew = false;
  const MeshGeometry* const geometry = meshes_.find(name, isNew);
  if (!geometry || !hasMaterial) return nullptr;
  if (isNew) warnOfMesh(*geometry, fields[0].at);
  return keep(std::make_unique<TriangleMesh>(geometry, material_), at);
}

void SceneBuilder::warnOfMesh(const MeshGeometry& geometry, const char* at) {
  const std::string mesh = "the mesh " + in_.quotedAt(at);
  if (geometry.faceCount() == 0) {
    warn(at, mesh + " has no faces: it will not be seen");
  } else if (const std::uint32_t count = geometry.countFlatFaces()) {
    warn(at, mesh + " has " + std::to_string(count) +
                 (count == 1 ? " triangle without area: it" : " triangles without area: they") +
                 " will not be seen");
  }
}

void SceneBuilder::warnOfMoreFlatTriangles() {
  if (flatTriangles_ <= kFlatTrianglesNamed) return;
  warn(in_.at(), std::to_string(flatTriangles_ - kFlatTrianglesNamed) +
                     " more triangles have no area: they will not be seen");
}
