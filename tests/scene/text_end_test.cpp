// Nothing behind a text is looked at, though much of it is read eight bytes at a time.
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <string>

#include "check.h"
#include "random.h"
#include "scene/number_reader.h"
#include "scene/obj_reader.h"
#include "scene/source_text.h"

namespace {

/// A page of text with a page behind it that ends the program when touched.
class GuardedPage {
 public:
  GuardedPage() : size_(std::size_t(sysconf(_SC_PAGESIZE))) {
    void* const pages =
        mmap(nullptr, 2 * size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    start_ = pages == MAP_FAILED ? nullptr : static_cast<char*>(pages);
    isGuarded_ = start_ && mprotect(start_ + size_, size_, PROT_NONE) == 0;
  }
  ~GuardedPage() {
    if (start_) munmap(start_, 2 * size_);
  }
  GuardedPage(const GuardedPage&) = delete;
  GuardedPage& operator=(const GuardedPage&) = delete;

  bool isGuarded() const { return isGuarded_; }
  /// A copy of `text`, shorter than a page, that ends where the page does.
  std::string_view atEnd(const std::string& text) {
    char* const place = start_ + size_ - text.size();
    std::memcpy(place, text.data(), text.size());
    return {place, text.size()};
  }

 private:
  std::size_t size_;
  char* start_ = nullptr;
  bool isGuarded_ = false;
};

}  // namespace

TEST("texts of all lengths are read without a look behind their end") {
  static const char* const kPieces[] = {
      "v 1.5 -2.25 3.125\n",
      "v -1234567.12345678901234 +1234567.12345678901234 1.123456789012345\n",
      "f 1 2 3\n",
      "f 1/2/3 4/5/6 7/8/9\n",
      "f -1 -2 1\r\n",
      "f 1234567/1234567/1234567 1234567//1234567 1/1\r\n",
      "v 1e5 2 3\n",
      "f 12345678/12345678/12345678 12345678/12345678/12345678 1\n",
      "  {",
      "99999999999999999999.99999999999999999",
      "-",
      "# x\n"};
  GuardedPage page;
  CHECK(page.isGuarded());
  Random random(61);
  std::size_t found = 0;
  const ObjReport ignore = [](const char*, const std::string&) {};
  for (int i = 0; i < 20'000 && page.isGuarded(); ++i) {
    std::string text;
    for (int pieces = random.index(8); pieces > 0; --pieces) text += kPieces[random.index(12)];
    text.resize(std::size_t(random.index(int(text.size()) + 1)));
    const std::string_view bytes = page.atEnd(text);
    ObjChunk chunk;
    readObjChunk(bytes, {}, ignore, chunk);
    Tokenizer tokenizer(bytes);
    while (!tokenizer.next().empty()) ++found;
    const char* const end = bytes.data() + bytes.size();
    for (const char* p = bytes.data(); p != end; ++p) {
      double value = 0;
      float single = 0;
      found += scanNumber(p, end, value) != nullptr;
      found += scanNumber(p, end, single) != nullptr;
    }
    found += chunk.vertices.size() + chunk.faces.size();
  }
  CHECK(found > 1'000'000);
}
