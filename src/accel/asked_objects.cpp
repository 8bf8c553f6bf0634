// AskedMesh and ObjectTree: what they answer while a tree is walked. A leaf has told that a ray may
// hit one of its primitives, by a lane of its words; here that becomes the primitive itself, in
// double.
#include <cstring>

#include "accel/mesh_tree.h"
#include "accel/object_tree.h"
#include "geometry/sphere.h"
#include "geometry/triangle.h"

namespace accel {

LeafPrimitive AskedMesh::primitiveAt(const std::uint32_t* words, int lane) const {
  return {&mesh_, mesh_.getMaterial(), order_, MeshTree::faceAt(words, lane), false};
}

bool AskedMesh::takesPlace(LeafPrimitive& face) const {
  const FaceCopies* copies = tree_.copiesOf(face.face);
  if (copies) face.face = copies->next;
  return copies != nullptr;
}

void AskedMesh::shade(const RowList& rows, HitTable& hits) const {
  const MeshGeometry& geometry = mesh_.getGeometry();
  if (geometry.getShading().isEmpty()) return;
  for (const int row : rows) {
    Vec3d normal = rowOf(hits.normal, row);
    Vec2d textureCoordinates;
    shadeHit(geometry, hits.face[row], rowOf(hits.point, row), normal, textureCoordinates);
    setRowOf(hits.normal, row, normal);
    hits.setTextureCoordinates(row, textureCoordinates);
  }
}

void AskedMesh::setCrossing(const std::uint32_t* words, int lane, Crossing& crossing) const {
  const FaceCopies* copies = tree_.copiesOf(MeshTree::faceAt(words, lane));
  crossing.object = &mesh_;
  crossing.material = mesh_.getMaterial();
  crossing.closed = mesh_.getGeometry().isClosed();
  crossing.count = copies ? copies->count : 1;
}

const TreeMember& ObjectTree::memberAt(const std::uint32_t* words, int lane) const {
  const int n = countOf(*words);
  return members_[words[1 + rowsOf(kindOf(*words)) * n + lane] & ~kIdBit];
}

LeafPrimitive ObjectTree::primitiveAt(const std::uint32_t* words, int lane) const {
  const TreeMember& member = memberAt(words, lane);
  const auto& shape = static_cast<const Shape&>(*member.object);
  return {&shape, shape.getMaterial(), member.order, 0, kindOf(*words) == LeafKind::spheres};
}

void ObjectTree::getNumbers(const std::uint32_t* words, int lane, double* numbers,
                            int stride) const {
  const Object3D* object = memberAt(words, lane).object;
  if (kindOf(*words) == LeafKind::spheres) {
    const auto& sphere = static_cast<const Sphere&>(*object);
    for (int axis = 0; axis < 3; ++axis) numbers[axis * stride] = sphere.getCenter()[axis];
    numbers[3 * stride] = sphere.getRadius();
    return;
  }
  const auto& triangle = static_cast<const Triangle&>(*object);
  for (int k = 0; k < 9; ++k) numbers[k * stride] = triangle.getVertex(k / 3)[k % 3];
}

void ObjectTree::askObject(const std::uint32_t* words, Question& question,
                           const RowList& rows) const {
  TreeMember member;
  std::memcpy(&member, ++words, sizeof member);
  Matrix inverse;
  if (member.inverse) {
    const void* const copy = words + sizeof member / sizeof *words;
    std::memcpy(static_cast<void*>(&inverse), copy, sizeof inverse);
    member.inverse = &inverse;
  }
  __builtin_prefetch(member.mesh);  // its material is wanted where it is hit: 0.96 of the time
  question.askMember(member, rows);
}

void ObjectTree::ask(Question& question, const RowList& rows) const {
  const Arena::Frame frame(question.arena());
  RowList open = rows;
  if (!shapes_.empty()) {
    question.count({0, shapes_.size() * std::size_t(open.count)});
    question.askShapes(shapes_.data(), int(shapes_.size()), open);
  }
  for (const DirectMember& each : direct_) {
    const TreeMember& member = members_[each.id];
    open = question.openOf(open);
    // To move and to prepare the rays that miss took 1.27 of the instructions of mirror balls on a
    // floor of two meshes.
    const RowList near = question.rowsAt(each.box, open);
    if (member.kind == TreeMember::Kind::plain) question.count({0, std::size_t(near.count)});
    question.askMember(member, near);
  }
  if (!bvh_.isEmpty()) question.askTree(*this, question.openOf(open));
}

}  // namespace accel
