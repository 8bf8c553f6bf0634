// A plain and fast OBJ reader for the rival: v with three numbers, f with three positive indices,
// nothing else, nothing checked. The file is mapped; every thread reads a part of it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace bench {

/// A mapped OBJ file, cut at line ends into two parts.
class PlainObj {
 public:
  /// Maps the file and counts its statements. Throws std::runtime_error.
  explicit PlainObj(const std::string& path);
  ~PlainObj();
  PlainObj(const PlainObj&) = delete;
  PlainObj& operator=(const PlainObj&) = delete;

  std::size_t vertexCount() const { return parts_[0].vertices + parts_[1].vertices; }
  std::size_t faceCount() const { return parts_[0].faces + parts_[1].faces; }
  /// Stores 3 vertexCount() coordinates and 3 faceCount() indices, counted from 0.
  void read(float* coordinates, std::uint32_t* indices) const;

 private:
  struct Part {
    const char* start = nullptr;
    const char* end = nullptr;
    std::size_t vertices = 0, faces = 0;
  };
  static void count(Part& part);
  static void readPart(const Part& part, float* coordinates, std::uint32_t* indices);

  void* data_ = nullptr;
  std::size_t size_ = 0;
  Part parts_[2];
};

}  // namespace bench
