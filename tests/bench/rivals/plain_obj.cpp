// The rival's OBJ reader: a pass that counts and a pass that reads, on two threads each.
#include "rivals/plain_obj.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <stdexcept>
#include <thread>

namespace bench {
namespace {

constexpr double kTenths[] = {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};

/// Reads [-]digits[.digits] and goes behind it; right to a float's last bit or so.
float readNumber(const char*& p) {
  while (*p == ' ') ++p;
  const bool isNegative = *p == '-';
  p += isNegative;
  std::uint64_t digits = 0;
  for (; unsigned(*p - '0') < 10; ++p) digits = digits * 10 + std::uint64_t(*p - '0');
  int decimals = 0;
  if (*p == '.') {
    for (++p; unsigned(*p - '0') < 10 && decimals < 9; ++p, ++decimals) {
      digits = digits * 10 + std::uint64_t(*p - '0');
    }
  }
  const double value = double(digits) * kTenths[decimals];
  return float(isNegative ? -value : value);
}

std::uint32_t readIndex(const char*& p) {
  while (*p == ' ') ++p;
  std::uint32_t index = 0;
  for (; unsigned(*p - '0') < 10; ++p) index = index * 10 + std::uint32_t(*p - '0');
  return index - 1;
}

const char* nextLine(const char* p, const char* end) {
  const void* found = std::memchr(p, '\n', std::size_t(end - p));
  return found ? static_cast<const char*>(found) + 1 : end;
}

}  // namespace

PlainObj::PlainObj(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY);
  struct stat status {};
  if (file < 0 || fstat(file, &status) != 0) throw std::runtime_error(path + ": cannot be read");
  size_ = std::size_t(status.st_size);
  data_ = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0);
  close(file);
  if (data_ == MAP_FAILED) throw std::runtime_error(path + ": cannot be mapped");
  const char* const start = static_cast<const char*>(data_);
  const char* const middle = nextLine(start + size_ / 2, start + size_);
  parts_[0].start = start;
  parts_[0].end = parts_[1].start = middle;
  parts_[1].end = start + size_;
  std::thread other([this] { count(parts_[1]); });
  count(parts_[0]);
  other.join();
}

PlainObj::~PlainObj() { munmap(data_, size_); }

void PlainObj::count(Part& part) {
  for (const char* p = part.start; p != part.end; p = nextLine(p, part.end)) {
    part.vertices += *p == 'v';
    part.faces += *p == 'f';
  }
}

void PlainObj::readPart(const Part& part, float* coordinates, std::uint32_t* indices) {
  for (const char* p = part.start; p != part.end;) {
    const char kind = *p++;
    if (kind == 'v') {
      for (int axis = 0; axis < 3; ++axis) *coordinates++ = readNumber(p);
    } else if (kind == 'f') {
      for (int corner = 0; corner < 3; ++corner) *indices++ = readIndex(p);
    }
    while (p != part.end && *p++ != '\n') {
    }
  }
}

void PlainObj::read(float* coordinates, std::uint32_t* indices) const {
  std::thread other([&] {
    readPart(parts_[1], coordinates + 3 * parts_[0].vertices, indices + 3 * parts_[0].faces);
  });
  readPart(parts_[0], coordinates, indices);
  other.join();
}

}  // namespace bench
