// Where objects stand: the table is filled in file order, so that lines are counted once; the way
// to an object is found from inside, from each to what holds it.
#include "scene/object_places.h"

#include <algorithm>

#include "scene/scene_grammar.h"

void ObjectPlaces::begin(std::string_view kind, const char* place) {
  line_ += std::size_t(std::count(counted_, place, '\n'));
  counted_ = place;
  const auto word = std::find(kPlaceWords.begin(), kPlaceWords.end(), kind);
  places_.push_back({*word, line_, open_, ++places_[open_].members});
  open_ = places_.size() - 1;
}

void ObjectPlaces::end(const Object3D* object) {
  byObject_[object] = open_;
  open_ = places_[open_].parent;
}

std::size_t ObjectPlaces::lineOf(const Object3D* object) const {
  const auto found = byObject_.find(object);
  return found == byObject_.end() ? 0 : places_[found->second].line;
}

std::string ObjectPlaces::nameOf(const Place& place) const {
  const bool isAlone = places_[place.parent].kind == "Transform";
  return std::string(place.kind) + (isAlone ? "" : " " + std::to_string(place.number));
}

std::string ObjectPlaces::pathOf(const Object3D* object) const {
  const auto found = byObject_.find(object);
  if (found == byObject_.end()) return "";
  const Place* place = &places_[found->second];
  std::string path = nameOf(*place);
  while (place->parent != 0) {
    place = &places_[place->parent];
    path.insert(0, nameOf(*place) + " > ");
  }
  return path;
}
