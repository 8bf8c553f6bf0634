// Fuzz target: the OBJ reader. Demands: reading a file in pieces, by one thread or by several,
// gives the mesh that reading it whole gives, and finds something wrong exactly where that does; a
// mistake is one line that prints and has a line of the file; every index is that of a vertex. What
// is told of corners beyond that changes no face, and its indices are right too.
#include <cmath>

#include "fuzz.h"
#include "scene/obj_reader.h"

namespace {

bool isSame(const Vec3d& a, const Vec3d& b) {
  return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
}

bool isSame(const MeshGeometry& a, const MeshGeometry& b) {
  if (a.getFaces() != b.getFaces() || a.getVertices().size() != b.getVertices().size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.getVertices().size(); ++i) {
    if (!isSame(a.getVertices()[i], b.getVertices()[i])) return false;
  }
  return isSame(a.getOrigin(), b.getOrigin()) && a.countFlatFaces() == b.countFlatFaces();
}

void checkMesh(MeshGeometry& mesh) {
  for (const MeshGeometry::Face& face : mesh.getFaces()) {
    for (const std::uint32_t corner : face) {
      fuzz::demand(corner < mesh.getVertices().size(), "an index is that of a vertex");
    }
  }
  for (const Vec3f& v : mesh.getVertices()) {
    fuzz::demand(std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z()),
                 "a vertex is finite");
  }
  mesh.findWhetherClosed();
}

void checkReferences(const std::vector<MeshShading::Face>& faces, std::size_t faceCount,
                     std::size_t elements) {
  fuzz::demand(faces.size() == (elements > 0 ? faceCount : 0), "there is one for each face");
  for (const MeshShading::Face& face : faces) {
    for (const std::uint32_t corner : face) {
      fuzz::demand(corner < elements || corner == MeshShading::kNone, "an index is right");
    }
  }
}

void checkMistakes(const MistakeLog& log, const std::string& text) {
  std::size_t lines = 1;
  for (const char c : text) lines += c == '\n';
  for (const InputError& mistake : log.inOrder()) {
    fuzz::demand(fuzz::isPlainLine(mistake.what()), "a mistake is one line that prints");
    fuzz::demand(mistake.getLine() >= 1 && mistake.getLine() <= lines,
                 std::string("a mistake has a line of the file: ") + mistake.what());
  }
}

/// The mesh as the one-part reader sees it; false where it finds a mistake or warns.
bool readWhole(const std::string& text, MeshGeometry& mesh, const ObjDetails& details = {}) {
  MistakeLog log(MistakeLog::Mode::collect);
  std::vector<std::string> warnings;
  try {
    mesh = readObj(SourceText("m.obj", text), log, 0, warnings, details);
  } catch (const MistakeLog::Full&) {
    // Those found are enough.
  }
  checkMistakes(log, text);
  return log.count() == 0 && warnings.empty();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Scratch scratch;
  const std::string text(data, data + size);
  MeshGeometry whole;
  const bool isGood = readWhole(text, whole);
  if (isGood) checkMesh(whole);
  MeshGeometry detailed;
  if (readWhole(text, detailed, {true, true})) {
    fuzz::demand(isGood && isSame(detailed, whole), "details change no face");
    const MeshShading& shading = detailed.getShading();
    checkReferences(shading.coordinateFaces, whole.faceCount(), shading.coordinates.size());
    checkReferences(shading.normalFaces, whole.faceCount(), shading.normals.size());
    makeSmooth(detailed, MeshNormals::equal);
  }
  const std::string path = scratch.write("m.obj", text);
  const std::size_t small = 1 + (size > 0 ? data[size - 1] % 61u : 0u);
  for (const ObjReading& how : {ObjReading{1}, ObjReading{1, small}, ObjReading{2, small + 7}}) {
    MeshGeometry mesh;
    fuzz::demand(readObjFile(path, how, mesh) == isGood, "reading in pieces finds what is wrong");
    fuzz::demand(!isGood || isSame(mesh, whole), "reading in pieces gives the same mesh");
  }
  return 0;
}
