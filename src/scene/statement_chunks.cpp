// Cutting a file where statements end.
#include "scene/statement_chunks.h"

#include <algorithm>
#include <cstring>

#include "scene/obj_cursor.h"
#include "system/files.h"

namespace {

/// Where the last statement that ends in [from, size) of the buffer ends; 0 where none does. Line
/// ends behind a backslash do not count, though one in a comment would end it.
std::size_t lastStatementEnd(const std::vector<char>& buffer, std::size_t from, std::size_t size) {
  for (std::size_t i = size; i > from; --i) {
    const char* const place = buffer.data() + i - 1;
    if (*place == '\n' && !ObjCursor::isContinued(buffer.data(), place)) return i;
  }
  return 0;
}

}  // namespace

std::string_view StatementChunks::next(std::vector<char>& buffer,
                                       const std::function<void(std::size_t)>& take) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::size_t size = hasFailed_ ? 0 : fill(buffer);
  if (size == 0) return {};
  const std::string_view chunk(buffer.data(), size);
  const bool isMarked = count_ == 0 && chunk.substr(0, 3) == "\xEF\xBB\xBF";
  take(count_++);
  return chunk.substr(isMarked ? 3 : 0);
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
