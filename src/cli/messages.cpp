// Messages go out without a copy: there may be no memory for one.
#include "cli/messages.h"

#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>

#include "image/output_file.h"

namespace {

/// Takes what has been written, `size` bytes, off the front of the pieces.
void drop(std::size_t size, iovec* first, iovec* last) {
  for (; first != last; ++first) {
    const std::size_t part = std::min(size, first->iov_len);
    first->iov_base = static_cast<char*>(first->iov_base) + part;
    first->iov_len -= part;
    size -= part;
  }
}

iovec piece(std::string_view text) { return {const_cast<char*>(text.data()), text.size()}; }

}  // namespace

void complain(std::string_view message) {
  constexpr int kPieces = 3;
  const std::string_view start = isLineOpen() ? "\nraytracer: " : "raytracer: ";
  setLineOpen(false);
  iovec pieces[kPieces] = {piece(start), piece(message), piece("\n")};
  while (pieces[kPieces - 1].iov_len > 0) {
    const ssize_t written = writev(STDERR_FILENO, pieces, kPieces);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;  // nobody to tell
    drop(std::size_t(written), pieces, pieces + kPieces);
  }
}

int print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0 && !std::ferror(stdout)) return kDone;
  complain("cannot write to standard output");
  return kOutputFailed;
}
