// The table is filled in file order, so that lines are counted once.
#include "scene/object_places.h"

#include <algorithm>
#include <functional>
#include <iterator>

#include "scene/scene_grammar.h"

void ObjectPlaces::begin(std::string_view kind, const char* place) {
  line_ += std::size_t(std::count(counted_, place, '\n'));
  counted_ = place;
  const std::string_view* const word = std::find(kObjectWords.begin(), kObjectWords.end(), kind);
  std::size_t& members = open_ == kNone ? topMembers_ : entries_[open_].members;
  const Entry entry = {nullptr, *word, line_, open_, ++members, 0};
  open_ = entries_.size();
  entries_.push_back(entry);
}

void ObjectPlaces::end(const Object3D* object) {
  entries_[open_].object = object;
  open_ = entries_[open_].parent;
}

void ObjectPlaces::finish() {
  byObject_.clear();
  byObject_.reserve(entries_.size());
  for (std::size_t i = 0; i < entries_.size(); ++i) byObject_.push_back(i);
  std::sort(byObject_.begin(), byObject_.end(), [&](std::size_t a, std::size_t b) {
    return std::less<>()(entries_[a].object, entries_[b].object);
  });
}

const ObjectPlaces::Entry* ObjectPlaces::find(const Object3D* object) const {
  const auto place = std::lower_bound(byObject_.begin(), byObject_.end(), object,
                                      [&](std::size_t i, const Object3D* wanted) {
                                        return std::less<>()(entries_[i].object, wanted);
                                      });
  if (place == byObject_.end() || entries_[*place].object != object) return nullptr;
  return &entries_[*place];
}

std::size_t ObjectPlaces::lineOf(const Object3D* object) const {
  const Entry* const entry = find(object);
  return entry ? entry->line : 0;
}

std::string ObjectPlaces::nameOf(const Entry& entry) const {
  const bool isAlone = entry.parent != kNone && entries_[entry.parent].kind == "Transform";
  return std::string(entry.kind) + (isAlone ? "" : " " + std::to_string(entry.number));
}

std::string ObjectPlaces::pathOf(const Object3D* object) const {
  const Entry* entry = find(object);
  if (!entry) return "";
  std::vector<const Entry*> chain = {entry};
  while (chain.back()->parent != kNone) chain.push_back(&entries_[chain.back()->parent]);
  std::string path;
  for (auto each = chain.rbegin(); each != chain.rend(); ++each) {
    path += (path.empty() ? "" : " > ") + nameOf(**each);
  }
  return path;
}
