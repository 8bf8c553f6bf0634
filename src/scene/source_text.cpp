// Reading a whole file, whatever kind of file it is; counting its lines; and cutting it into words.
#include "scene/source_text.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <new>
#include <stdexcept>

#include "scene/input_error.h"
#include "system/files.h"

namespace {

/// What the system says of the last call that failed.
std::string systemReason() {
  return errno == EISDIR ? "it is a folder, expected a file" : std::strerror(errno);
}

/// Reads to the end. Where it cannot, returns false and says why.
bool readOrExplain(int descriptor, std::string& bytes, std::string& reason) {
  bytes.clear();
  try {
    const ReadOutcome outcome = readToEnd(descriptor, bytes, bytes.max_size());
    if (outcome == ReadOutcome::failed) reason = systemReason();
    if (outcome == ReadOutcome::longDevice) {
      reason = "the device gives more than 64 MB, expected a file";
    }
    return outcome == ReadOutcome::whole;
  } catch (const std::length_error&) {  // more than any memory holds
    throw std::bad_alloc();
  }
}

bool isSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
/// By byte: white space and braces. (A table takes half the instructions of comparisons.)
constexpr auto kEndsWord = [] {
  std::array<bool, 256> ends{};
  for (const char c : std::string_view(" \t\n\v\f\r{}")) ends[static_cast<unsigned char>(c)] = true;
  return ends;
}();
/// Of a word that would begin at `p`.
bool isComment(const char* p, const char* end) {
  return *p == '#' || (*p == '/' && p + 1 != end && p[1] == '/');
}

}  // namespace

bool readWholeFile(const std::string& filename, std::string& bytes, std::string& reason) {
  const OpenFile file(filename);
  if (file.isOpen()) return readOrExplain(file.descriptor(), bytes, reason);
  reason = systemReason();
  return false;
}

SourceText SourceText::read(const std::string& filename) {
  std::string bytes, reason;
  const bool isStandardInput = filename == "-";
  const std::string name = isStandardInput ? "<stdin>" : filename;
  const bool isRead = isStandardInput ? readOrExplain(STDIN_FILENO, bytes, reason)
                                      : readWholeFile(filename, bytes, reason);
  if (!isRead) throw InputError(name, 0, "cannot be read: " + reason);
  return SourceText(name, std::move(bytes));
}

std::size_t SourceText::lineAt(const char* place) const {
  return 1 + std::size_t(std::count(bytes_.data(), place, '\n'));
}

Tokenizer::Tokenizer(std::string_view bytes)
    : place_(withoutByteOrderMark(bytes).data()), end_(bytes.data() + bytes.size()) {}

std::string_view Tokenizer::next() {
  const char* p = place_;
  while (p != end_ && (isSpace(*p) || isComment(p, end_))) {
    const void* const newline = isSpace(*p) ? p + 1 : std::memchr(p, '\n', std::size_t(end_ - p));
    p = newline ? static_cast<const char*>(newline) : end_;
  }
  const char* const start = p;
  while (p != end_ && !kEndsWord[static_cast<unsigned char>(*p)]) ++p;
  if (p == start && p != end_) ++p;  // a brace
  place_ = p;
  return {start, std::size_t(p - start)};
}

std::string_view withoutByteOrderMark(std::string_view bytes) {
  return bytes.substr(bytes.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0);
}

/// Without its mark it has a NUL in every other byte of what is ASCII.
bool isWideText(std::string_view bytes) {
  if (bytes.substr(0, 2) == "\xff\xfe" || bytes.substr(0, 2) == "\xfe\xff") return true;
  std::size_t nuls[2] = {0, 0};
  const std::string_view head = bytes.substr(0, 1000);
  for (std::size_t k = 0; k < head.size(); ++k) nuls[k % 2] += head[k] == '\0';
  const std::size_t all = nuls[0] + nuls[1];
  return head.size() >= 4 && nuls[0] * nuls[1] == 0 && 3 * all >= head.size();
}

std::string otherKindOf(std::string_view bytes) {
  struct Kind {
    std::string_view start;
    const char* name;
  };
  static constexpr Kind kKinds[] = {
      {"version https://git-lfs", "a Git LFS pointer: fetch the file itself (git lfs pull)"},
      {"<", "an HTML page or XML: get the file itself"},
      {"\x1f\x8b", "a gzip file: unpack it first"},
      {"PK\x03\x04", "a zip archive: unpack it first"},
      {"ply\n", "a PLY file: convert it to OBJ first"},
      {"ply\r", "a PLY file: convert it to OBJ first"},
      {"solid ", "an STL file: convert it to OBJ first"},
      {"glTF", "a glTF file: convert it to OBJ first"},
      {"Kaydara FBX", "an FBX file: convert it to OBJ first"},
  };
  std::string_view text = withoutByteOrderMark(bytes);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  for (const Kind& kind : kKinds) {
    if (text.substr(0, kind.start.size()) == kind.start) return kind.name;
  }
  return isWideText(bytes) ? "text in UTF-16: save it as UTF-8" : "";
}
