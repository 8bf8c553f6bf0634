// Reading OBJ meshes: many parts at once from a file, joined afterwards; or the whole text in one
// part, which can name every mistake.
#include "scene/obj_reader.h"

#include <algorithm>
#include <deque>
#include <filesystem>

#include "scene/obj_part.h"
#include "scene/statement_chunks.h"
#include "system/files.h"
#include "system/memory.h"
#include "system/worker_threads.h"

namespace {

/// Thrown where a part shows that the file must be read as one.
struct IsUnclear {};

/// The bytes without a byte-order mark at their start.
std::string_view withoutMark(std::string_view bytes) {
  return bytes.substr(bytes.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0);
}

/// Reads chunks until there are no more. Parts stay where they are as their row grows. All are
/// filled in one place, apart from the row, as two threads that write side by side slow each other
/// down (1.8 times as long), and then copied, as vectors that grow time and again cost more.
void readParts(StatementChunks& chunks, std::deque<ObjPart>& parts) {
  const ObjReport report = [&](const char*, const std::string&) {
    chunks.stop();
    throw IsUnclear();
  };
  std::vector<char> buffer;
  ObjPart part, *place = nullptr;
  for (;;) {
    const std::string_view chunk = chunks.next(buffer, [&](std::size_t number) {
      if (number == parts.size()) parts.emplace_back();
      place = &parts[number];
    });
    if (chunk.empty()) return;
    part.clear();
    readObjPart(chunk, {}, report, part);
    *place = part;
  }
}

/// Numbers the corners of parts that counted backwards, and checks what parts took for granted.
bool settle(std::deque<ObjPart>& parts, std::size_t vertexCount) {
  std::size_t before = 0;
  for (ObjPart& part : parts) {
    if (part.highest > vertexCount || part.reachBack > before) return false;
    for (const std::size_t corner : part.relativeCorners) {
      part.faces[corner / 3][corner % 3] += std::uint32_t(before);
    }
    before += part.vertices.size();
  }
  return true;
}

/// All elements of one kind, in one piece; the parts' own are freed on the way.
template <class T>
std::vector<T> joined(std::deque<ObjPart>& parts, std::vector<T> ObjPart::*elements,
                      std::size_t count) {
  std::vector<T> all;
  all.reserve(count);
  preferLargePages(all.data(), count * sizeof(T));
  for (ObjPart& part : parts) {
    all.insert(all.end(), (part.*elements).begin(), (part.*elements).end());
    (part.*elements) = {};
  }
  return all;
}

bool join(std::deque<ObjPart>& parts, MeshGeometry& mesh) {
  std::size_t vertexCount = 0, faceCount = 0;
  for (const ObjPart& part : parts) {
    vertexCount += part.vertices.size();
    faceCount += part.faces.size();
  }
  if (std::max(vertexCount, faceCount) > kMaxObjParts || !settle(parts, vertexCount)) return false;
  if (parts.size() == 1) {
    mesh = MeshGeometry(std::move(parts[0].vertices), std::move(parts[0].faces));
    return true;
  }
  std::vector<Vec3f> vertices;
  std::vector<MeshGeometry::Face> faces;
  runOnThreads(2, 0, [&](int kind) {
    if (kind == 0) vertices = joined(parts, &ObjPart::vertices, vertexCount);
    if (kind == 1) faces = joined(parts, &ObjPart::faces, faceCount);
  });
  mesh = MeshGeometry(std::move(vertices), std::move(faces));
  return true;
}

}  // namespace

bool readObjFile(const std::string& filename, const ObjReading& how, MeshGeometry& mesh) {
  std::error_code ignored;
  // Not even opened: the writer of a FIFO would take the end of that for the end of its reader.
  if (!std::filesystem::is_regular_file(filename, ignored)) return false;
  const OpenFile file(filename);
  if (!file.isOpen() || file.regularSize() < 0) return false;
  const off_t chunkCount = file.regularSize() / off_t(how.chunkBytes) + 1;
  const int threads = int(std::min(off_t(how.threads), chunkCount));
  StatementChunks chunks(file.descriptor(), how.chunkBytes);
  std::deque<ObjPart> parts;
  try {
    const auto work = [&](int) { readParts(chunks, parts); };
    constexpr std::size_t kStackBytes = std::size_t(1) << 20;
    threads == 1 ? work(0) : runOnThreads(threads, kStackBytes, work);
  } catch (const IsUnclear&) {
    return false;
  }
  return !chunks.hasFailed() && join(parts, mesh);
}

MeshGeometry readObj(const SourceText& text, MistakeLog& log, std::size_t place) {
  const std::size_t mistakesBefore = log.count();
  const std::string_view statements = withoutMark(text.bytes());
  const ObjReport report = [&](const char* at, const std::string& message) {
    log.add(place, InputError(text.name(), text.lineAt(at), message));
  };
  ObjPart all;
  readObjPart(statements, {countObjVertices(statements), 0}, report, all);
  if (log.count() > mistakesBefore) return {};
  all.vertices.shrink_to_fit();
  all.faces.shrink_to_fit();
  return MeshGeometry(std::move(all.vertices), std::move(all.faces));
}
