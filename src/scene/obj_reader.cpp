// Reading OBJ files: chunks by many threads, put in a row afterwards; or the whole text as one.
#include "scene/obj_reader.h"

#include <algorithm>
#include <filesystem>

#include "geometry/polygon.h"
#include "scene/obj_words.h"
#include "scene/wording.h"
#include "system/memory.h"
#include "system/worker_threads.h"

namespace {

/// Faces of vertices, and those of what else is told of their corners.
using FaceLists = std::array<std::vector<MeshGeometry::Face>*, 3>;

/// Thrown where a chunk shows that the file must be read as one.
struct IsUnclear {};

/// What one thread reads chunks with: it fills its own in one place, apart from the others, as two
/// that write side by side slow each other down (1.8 times as long), and then copies it, as vectors
/// that grow time and again cost more.
struct FileChunkReader {
  const OpenFile& file;
  std::size_t chunkBytes;
  std::vector<ObjChunk>& chunks;
  std::vector<char> buffer{};
  ObjChunk chunk{};

  /// Throws IsUnclear.
  void operator()(std::size_t number) {
    const auto statements = readStatements(file, number, chunkBytes, buffer);
    if (!statements) throw IsUnclear();
    const ObjReport fail = [](const char*, const std::string&) { throw IsUnclear(); };
    chunk.clear();
    readObjChunk(*statements, {}, fail, chunk);
    if (!chunk.slivers.empty()) throw IsUnclear();
    chunks[number] = chunk;
  }
};

/// Reads the chunks of a file by turns of several threads. The file is neither mapped (one that
/// shrinks meanwhile would end the program) nor kept: the buffer stays in the thread's cache.
/// Measured on 38 MB, two cores: 4 ms; into fresh memory 13 to 30 ms, mapped 2 to 7 ms. Throws
/// IsUnclear.
std::vector<ObjChunk> readChunks(const OpenFile& file, const ObjReading& how) {
  std::vector<ObjChunk> chunks(std::size_t(file.regularSize() / off_t(how.chunkBytes)) + 1);
  const auto makeReader = [&] { return FileChunkReader{file, how.chunkBytes, chunks}; };
  shareOnThreads(how.threads, std::size_t(1) << 20, chunks.size(), makeReader);
  return chunks;
}

/// Checks what the chunks took for granted, and moves their backward indices to the vertices of
/// the whole mesh, and their polygons to its faces. Throws IsUnclear where a guess was wrong.
void resolveIndices(std::vector<ObjChunk>& chunks, std::size_t vertexCount) {
  std::size_t before = 0, facesBefore = 0;
  for (ObjChunk& chunk : chunks) {
    if (chunk.highest > vertexCount || chunk.reachBack > before) throw IsUnclear();
    for (const std::size_t corner : chunk.relativeCorners) {
      chunk.faces[corner / 3][corner % 3] += std::uint32_t(before);
    }
    for (ObjPolygon& polygon : chunk.polygons) polygon.first += std::uint32_t(facesBefore);
    before += chunk.vertices.size();
    facesBefore += chunk.faces.size();
  }
}

/// All elements of one kind, in one piece; the chunks' own are freed on the way.
template <class T>
std::vector<T> inOnePiece(std::vector<ObjChunk>& chunks, std::vector<T> ObjChunk::*elements,
                          std::size_t count) {
  std::vector<T> all;
  all.reserve(count);
  preferLargePages(all.data(), count * sizeof(T));
  for (ObjChunk& chunk : chunks) {
    all.insert(all.end(), (chunk.*elements).begin(), (chunk.*elements).end());
    (chunk.*elements) = {};
  }
  return all;
}

/// The corners of a polygon that stands in `faces` as a fan.
std::vector<std::uint32_t> cornersOf(const ObjPolygon& polygon,
                                     const std::vector<MeshGeometry::Face>& faces) {
  const MeshGeometry::Face* const fan = &faces[polygon.first];
  std::vector<std::uint32_t> corners = {fan[0][0], fan[0][1]};
  for (std::uint32_t k = 0; k < polygon.triangles; ++k) corners.push_back(fan[k][2]);
  return corners;
}

/// Cuts a polygon that stands as a fan in the first of `all`, and perhaps in others: where it is
/// concave, its triangles become others in each.
OutlineShape cutPolygon(const std::vector<Vec3f>& vertices, const ObjPolygon& polygon,
                        const FaceLists& all) {
  std::vector<Vec3f> outline;
  for (const std::uint32_t corner : cornersOf(polygon, *all[0])) {
    outline.push_back(vertices[corner]);
  }
  std::vector<OutlineTriangle> triangles;
  const OutlineShape shape = cutOutline(outline, triangles);
  for (std::vector<MeshGeometry::Face>* const faces : all) {
    if (faces->empty() || triangles.empty()) continue;
    const std::vector<std::uint32_t> corners = cornersOf(polygon, *faces);
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        (*faces)[polygon.first + k][corner] = corners[triangles[k][corner]];
      }
    }
  }
  return shape;
}

/// Cuts all polygons of chunks, whose triangles stand in `faces`; the second and third list may be
/// empty. Where polygons of many corners would take too long together, the later ones stay fans.
/// Each chunk keeps those of its polygons that stay fans though they are not convex.
void cutPolygons(const std::vector<Vec3f>& vertices, std::vector<ObjChunk>& chunks, int threads,
                 const FaceLists& faces) {
  constexpr double kMostSteps = 0x1p27;  // as cutOutline takes for one of 11,500 corners
  const auto stepsOf = [](const ObjPolygon& polygon) {
    return double(polygon.triangles) * polygon.triangles;
  };
  std::vector<double> stepsBefore;  // each chunk, so that no answer depends on the threads
  double allSteps = 0;
  for (const ObjChunk& chunk : chunks) {
    stepsBefore.push_back(allSteps);
    for (const ObjPolygon& polygon : chunk.polygons) allSteps += stepsOf(polygon);
  }
  shareOnThreads(threads, 0, chunks.size(), [&](std::size_t number) {
    double steps = stepsBefore[number];
    const auto isCut = [&](const ObjPolygon& polygon) {
      steps += stepsOf(polygon);
      const bool isTooLong = polygon.triangles > 64 && steps > kMostSteps;
      return !isTooLong && cutPolygon(vertices, polygon, faces) != OutlineShape::crossing;
    };
    std::vector<ObjPolygon>& all = chunks[number].polygons;
    all.erase(std::remove_if(all.begin(), all.end(), isCut), all.end());
  });
}

/// Puts what the chunks hold in a row, but for their shading: that is of a single one. Where the
/// mesh is far from 0, `readPlaces` appends the places of its vertices in double. Throws IsUnclear
/// where a guess was wrong.
MeshGeometry join(std::vector<ObjChunk>& chunks, int threads,
                  const std::function<void(std::vector<Vec3d>& places)>& readPlaces) {
  std::size_t vertexCount = 0, faceCount = 0;
  for (const ObjChunk& chunk : chunks) {
    vertexCount += chunk.vertices.size();
    faceCount += chunk.faces.size();
  }
  if (std::max(vertexCount, faceCount) > kMostObjElements) throw IsUnclear();
  resolveIndices(chunks, vertexCount);
  std::vector<Vec3f> vertices;
  std::vector<MeshGeometry::Face> faces;
  shareOnThreads(chunks.size() > 1 ? 2 : 1, 0, 2, [&](std::size_t kind) {
    if (kind == 0) vertices = inOnePiece(chunks, &ObjChunk::vertices, vertexCount);
    if (kind == 1) faces = inOnePiece(chunks, &ObjChunk::faces, faceCount);
  });
  Vec3d origin = MeshGeometry::kZero;
  if (isFarMesh(vertices, faces)) {
    std::vector<Vec3d> places;
    readPlaces(places);
    if (places.size() != vertices.size()) throw IsUnclear();  // somebody is writing the file
    origin = measureFromMiddle(places, faces, vertices);
  }
  MeshShading& shading = chunks[0].shading;
  cutPolygons(vertices, chunks, threads, {&faces, &shading.coordinateFaces, &shading.normalFaces});
  return MeshGeometry(std::move(vertices), std::move(faces), origin);
}

/// Where the first statement begins at `from` or behind it: after the first line end from just
/// before it on that is not continued. (In a comment a backslash would not continue the line: such
/// a line end is passed over too.) npos where none does.
std::size_t findStatementStart(std::string_view bytes, std::size_t from) {
  if (from == 0) return 0;
  std::size_t newline = bytes.find('\n', from - 1);
  while (newline != bytes.npos && isContinuedLine(bytes.data(), bytes.data() + newline)) {
    newline = bytes.find('\n', newline + 1);
  }
  return newline == bytes.npos ? newline : newline + 1;
}

}  // namespace

bool readObjFile(const std::string& filename, const ObjReading& how, MeshGeometry& mesh) {
  std::error_code ignored;
  // Not even opened: the writer of a FIFO would take the end of that for the end of its reader.
  if (!std::filesystem::is_regular_file(filename, ignored)) return false;
  const OpenFile file(filename);
  if (!file.isOpen() || file.regularSize() < 0) return false;
  try {
    std::vector<ObjChunk> chunks = readChunks(file, how);
    MeshGeometry joined = join(chunks, how.threads, [&](std::vector<Vec3d>& places) {
      std::vector<char> buffer;
      for (std::size_t number = 0; number < chunks.size(); ++number) {
        const auto statements = readStatements(file, number, how.chunkBytes, buffer);
        if (!statements) throw IsUnclear();
        readObjPlaces(*statements, places);
      }
    });
    const auto isCrossing = [](const ObjChunk& chunk) { return !chunk.polygons.empty(); };
    if (std::any_of(chunks.begin(), chunks.end(), isCrossing)) return false;
    mesh = std::move(joined);
    return true;
  } catch (const IsUnclear&) {
    return false;
  }
}

MeshGeometry readObj(const SourceText& text, MistakeLog& log, std::size_t place,
                     std::vector<std::string>& warnings, const ObjDetails& details) {
  const std::size_t mistakesBefore = log.count();
  const std::string_view statements = withoutByteOrderMark(text.bytes());
  const ObjReport report = [&](const char* at, const std::string& message) {
    log.add(place, InputError(text.name(), text.lineAt(at), message));
  };
  std::vector<ObjChunk> chunks(1);
  ObjChunk& all = chunks[0];
  readObjChunk(statements, {countObjStatements(statements, "v"), 0}, report, all, details);
  if (log.count() > mistakesBefore) return {};
  const auto warn = [&](std::size_t count, const std::string& what, std::size_t first) {
    warnings.push_back("has " + counted(count, "face") + " " + what +
                       (count == 1 ? ", in line " : ", the first in line ") +
                       std::to_string(text.lineAt(statements.data() + first)));
  };
  if (!all.slivers.empty()) {
    warn(all.slivers.size(), "of less than three corners, left out", all.slivers[0]);
  }
  MeshGeometry mesh =
      join(chunks, 1, [&](std::vector<Vec3d>& places) { readObjPlaces(statements, places); });
  if (!all.polygons.empty()) {
    warn(all.polygons.size(),
         "that cannot be cut into triangles rightly, as the outline crosses itself",
         all.polygons[0].at);
  }
  MeshShading& shading = all.shading;
  if (shading.coordinates.empty()) shading.coordinateFaces = {};
  if (shading.normals.empty()) shading.normalFaces = {};
  mesh.setShading(std::move(shading));
  return mesh;
}

/// Reads a little more than the chunk, since its last statement mostly ends soon; where it does
/// not, twice as much, time and again. What stands before the chunk tells whether a statement
/// begins where the chunk does: the line end and the backslash that may continue it.
std::optional<std::string_view> readStatements(const OpenFile& file, std::size_t number,
                                               std::size_t chunkBytes, std::vector<char>& buffer) {
  constexpr std::size_t kMoreBytes = 1000;
  const off_t start = off_t(number) * off_t(chunkBytes);
  const std::size_t before = std::size_t(std::min(start, off_t(3)));
  const std::size_t behind = before + chunkBytes;  // places in the buffer
  std::size_t size = 0;
  for (std::size_t wanted = behind + kMoreBytes;; wanted *= 2) {
    if (buffer.size() < wanted) buffer.resize(wanted);
    const ssize_t count =
        file.readAt(start - off_t(before) + off_t(size), &buffer[size], wanted - size);
    if (count < 0) return std::nullopt;
    size += std::size_t(count);
    const std::string_view bytes(buffer.data(), size);
    const std::size_t first = findStatementStart(bytes, before);
    if (first >= behind) return std::string_view();
    const std::size_t last = findStatementStart(bytes, behind);
    if (last == bytes.npos && size == wanted) continue;
    const std::string_view statements = bytes.substr(first, last - first);
    return number == 0 ? withoutByteOrderMark(statements) : statements;
  }
}
