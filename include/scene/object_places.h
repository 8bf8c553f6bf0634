// ObjectPlaces: where each object of a scene stands: on which line, and inside which others.
// A table beside the scene, made only where it is asked for: objects know nothing of it.
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

class Object3D;

class ObjectPlaces {
 public:
  /// Knows no object.
  ObjectPlaces() = default;
  /// For a file of that name, whose text begins at `text`.
  ObjectPlaces(std::string file, const char* text) : file_(std::move(file)), counted_(text) {}

  // While the scene is read: each object begins, its members begin and end, it ends.

  /// `kind` is the object's name in the file, one of kPlaceWords, at `place` of the text, which is
  /// behind all places before.
  void begin(std::string_view kind, const char* place);
  /// The object that began last and has not ended; each begin() has its end(). Null where there was
  /// a mistake. Not owned: it is only asked for by its address. After the last end() the text is
  /// not needed any more.
  void end(const Object3D* object);

  // Afterwards, in a time that grows with the logarithm of the number of objects.

  /// The line of the object's name, counted from 1; 0 where the object is none of the scene's.
  std::size_t lineOf(const Object3D* object) const;
  /// The object and what it is in, outermost first: "Group 1 > Transform 3 > Sphere". The numbers
  /// count the members of a Group, and the Groups of the file, from 1; what is in a Transform is
  /// alone there. Empty where the object is none of the scene's.
  std::string pathOf(const Object3D* object) const;
  /// The name of the file; empty where no object is known.
  const std::string& file() const { return file_; }

 private:
  struct Place {
    std::string_view kind;             // a literal of kPlaceWords; empty for the file
    std::size_t line = 0, parent = 0;  // `parent` is an index
    std::size_t number = 0;            // among the members of the parent, from 1
    std::size_t members = 0;           // so far
  };

  std::string nameOf(const Place& place) const;

  std::string file_;
  const char* counted_ = nullptr;  // lines before this have been counted
  std::size_t line_ = 1, open_ = 0;
  std::vector<Place> places_{Place{}};               // the file, then the objects in their order
  std::map<const Object3D*, std::size_t> byObject_;  // indices
};
