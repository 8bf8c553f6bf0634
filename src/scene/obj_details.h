// ObjDetailReader: what an OBJ file tells of the corners of faces beyond vertices, for the few
// scenes that want it; and how mistakes in OBJ statements are told.
#pragma once
#include "scene/obj_reader.h"
#include "scene/obj_words.h"

/// Something that statements define and faces refer to by number.
struct ObjElement {
  std::string_view statement;
  const char *one, *many;  // what it is called
  const char* index;       // what the number is called
  int slashes;             // before it in the corner of a face
  const char* numbers;     // what is expected of a statement:
  int fewest, most;        // so many numbers count
};
inline constexpr ObjElement kObjVertex = {"v", "vertex",        "vertices", "face index",
                                          0,   "three numbers", 3,          3};
inline constexpr ObjElement kObjCoordinates = {
    "vt", "texture coordinate", "texture coordinates", "texture index", 1, "one or two numbers", 1,
    2};
inline constexpr ObjElement kObjNormal = {"vn", "normal",        "normals", "normal index",
                                          2,    "three numbers", 3,         3};

/// Says what is wrong at `at` with the statement at `start`, of which `found` numbers are good.
void reportObjNumbers(const ObjWords& words, const ObjReport& report, const ObjElement& element,
                      const char* start, const char* at, int found);
/// Says that `number`, in a face's `word`, is not from 1 to `available`, counted forwards or
/// backwards.
void reportObjRange(const ObjReport& report, const ObjElement& element, std::string_view word,
                    std::uint64_t number, std::size_t available, bool isNegative);

/// Reads vt, vn and the references of faces to them, as far as they are wanted, into `shading`.
class ObjDetailReader {
 public:
  /// `statements` are all of a file, where anything is wanted. `report` and `shading` must outlive
  /// the reader.
  ObjDetailReader(std::string_view statements, const ObjDetails& wanted, const ObjReport& report,
                  MeshShading& shading);

  bool areWanted() const { return wanted_.any(); }
  /// Takes the statement at `start`, where it is a vt or vn that is wanted.
  void readStatement(const char* start);
  /// Takes the references of the face at `start`, whose corners are well formed, into triangles
  /// that are a fan around the first corner.
  void readFace(const char* start);

 private:
  /// How many elements are defined before a face, and by all statements.
  struct Defined {
    std::size_t before, inAll;
  };

  Vec3f readNumbers(const ObjElement& element, const char* start);
  void addReferences(const ObjElement& element, const Defined& defined, const char* start,
                     std::vector<MeshShading::Face>& faces);
  std::uint32_t referenceIn(std::string_view word, const ObjElement& element,
                            const Defined& defined);

  const ObjWords words_;
  const ObjDetails wanted_;
  const ObjReport& report_;
  MeshShading& shading_;
  // In the whole file; 0 where they are not wanted.
  const std::size_t coordinateCount_, normalCount_;
};
