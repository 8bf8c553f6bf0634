// Reading OBJ files: chunks by many threads, put in a row afterwards; or the whole text as one.
#include "scene/obj_reader.h"

#include <algorithm>
#include <deque>
#include <filesystem>

#include "system/files.h"
#include "system/memory.h"
#include "system/worker_threads.h"

namespace {

/// Thrown where a chunk shows that the file must be read as one.
struct IsUnclear {};

/// Reads chunks until there are no more. Chunks stay where they are as their row grows. All are
/// filled in one place, apart from the row, as two threads that write side by side slow each other
/// down (1.8 times as long), and then copied, as vectors that grow time and again cost more.
void readChunks(StatementChunks& file, std::deque<ObjChunk>& chunks) {
  const ObjReport report = [&](const char*, const std::string&) {
    file.stop();
    throw IsUnclear();
  };
  std::vector<char> buffer;
  ObjChunk chunk, *place = nullptr;
  for (;;) {
    const std::string_view statements = file.next(buffer, [&](std::size_t number) {
      if (number == chunks.size()) chunks.emplace_back();
      place = &chunks[number];
    });
    if (statements.empty()) return;
    chunk.clear();
    readObjChunk(statements, {}, report, chunk);
    *place = chunk;
  }
}

/// Checks what the chunks took for granted, and moves their backward indices to the vertices of
/// the whole mesh. False where a guess was wrong.
bool resolveIndices(std::deque<ObjChunk>& chunks, std::size_t vertexCount) {
  std::size_t before = 0;
  for (ObjChunk& chunk : chunks) {
    if (chunk.highest > vertexCount || chunk.reachBack > before) return false;
    for (const std::size_t corner : chunk.relativeCorners) {
      chunk.faces[corner / 3][corner % 3] += std::uint32_t(before);
    }
    before += chunk.vertices.size();
  }
  return true;
}

/// All elements of one kind, in one piece; the chunks' own are freed on the way.
template <class T>
std::vector<T> joined(std::deque<ObjChunk>& chunks, std::vector<T> ObjChunk::*elements,
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

bool join(std::deque<ObjChunk>& chunks, MeshGeometry& mesh) {
  std::size_t vertexCount = 0, faceCount = 0;
  for (const ObjChunk& chunk : chunks) {
    vertexCount += chunk.vertices.size();
    faceCount += chunk.faces.size();
  }
  if (std::max(vertexCount, faceCount) > kMostObjElements) return false;
  if (!resolveIndices(chunks, vertexCount)) return false;
  std::vector<Vec3f> vertices;
  std::vector<MeshGeometry::Face> faces;
  shareOnThreads(chunks.size() > 1 ? 2 : 1, 0, 2, [&](std::size_t kind) {
    if (kind == 0) vertices = joined(chunks, &ObjChunk::vertices, vertexCount);
    if (kind == 1) faces = joined(chunks, &ObjChunk::faces, faceCount);
  });
  mesh = MeshGeometry(std::move(vertices), std::move(faces));
  return true;
}

/// Where the last statement that ends in [from, size) of the buffer ends; 0 where none does. Line
/// ends behind a backslash do not count, though one in a comment would end it.
std::size_t lastStatementEnd(const std::vector<char>& buffer, std::size_t from, std::size_t size) {
  for (std::size_t i = size; i > from; --i) {
    const char* const place = buffer.data() + i - 1;
    if (*place == '\n' && !isContinuedLine(buffer.data(), place)) return i;
  }
  return 0;
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
  StatementChunks statements(file.descriptor(), how.chunkBytes);
  std::deque<ObjChunk> chunks;
  try {
    const auto work = [&](int) { readChunks(statements, chunks); };
    constexpr std::size_t kStackBytes = std::size_t(1) << 20;
    threads == 1 ? work(0) : runOnThreads(threads, kStackBytes, work);
  } catch (const IsUnclear&) {
    return false;
  }
  return !statements.hasFailed() && join(chunks, mesh);
}

MeshGeometry readObj(const SourceText& text, MistakeLog& log, std::size_t place) {
  const std::size_t mistakesBefore = log.count();
  const std::string_view statements = withoutByteOrderMark(text.bytes());
  const ObjReport report = [&](const char* at, const std::string& message) {
    log.add(place, InputError(text.name(), text.lineAt(at), message));
  };
  ObjChunk all;
  readObjChunk(statements, {countObjVertices(statements), 0}, report, all);
  if (log.count() > mistakesBefore) return {};
  all.vertices.shrink_to_fit();
  all.faces.shrink_to_fit();
  return MeshGeometry(std::move(all.vertices), std::move(all.faces));
}

std::string_view StatementChunks::next(std::vector<char>& buffer,
                                       const std::function<void(std::size_t)>& take) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::size_t size = hasFailed_ ? 0 : fill(buffer);
  if (size == 0) return {};
  const std::string_view chunk(buffer.data(), size);
  take(count_++);
  return count_ == 1 ? withoutByteOrderMark(chunk) : chunk;
}

void StatementChunks::stop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  hasFailed_ = true;
}

/// Fills the buffer with the rest and with what follows, until a statement ends in it. A statement
/// longer than a chunk makes it grow; only what is new is searched. Returns the chunk's size.
std::size_t StatementChunks::fill(std::vector<char>& buffer) {
  std::size_t size = rest_.size();
  if (buffer.size() < size + chunkBytes_) buffer.resize(size + chunkBytes_);
  std::copy(rest_.begin(), rest_.end(), buffer.begin());
  rest_.clear();
  while (!isAtEnd_) {
    if (buffer.size() < 2 * size) buffer.resize(2 * size);
    const std::size_t before = size;
    size = readInto(buffer, size);
    if (hasFailed_) return 0;
    if (isAtEnd_) break;
    const std::size_t end = lastStatementEnd(buffer, before, size);
    if (end == 0) continue;
    rest_.assign(buffer.begin() + std::ptrdiff_t(end), buffer.begin() + std::ptrdiff_t(size));
    return end;
  }
  return size;
}

/// Reads until the buffer is full or the file ends; returns how much of it is then filled.
std::size_t StatementChunks::readInto(std::vector<char>& buffer, std::size_t size) {
  if (buffer.size() == size) buffer.resize(size + chunkBytes_);
  while (size < buffer.size()) {
    const ssize_t count = readSome(descriptor_, &buffer[size], buffer.size() - size);
    hasFailed_ |= count < 0;
    isAtEnd_ |= count == 0;
    if (count <= 0) break;
    size += std::size_t(count);
  }
  return size;
}
