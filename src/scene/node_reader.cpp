// The scene language of 2020: nodes in place of Groups and Transforms.
//
// A Node holds, in any order but for its Transform, which comes first: a material, objects, lights,
// and other nodes. It becomes a Group, within a Transform where it has one. The material holds for
// all in the node, before it too: so the first one of each node is looked up in advance, in one
// pass over all words; of several, another one holds for what follows it. A point light stands at
// the origin of its node; directions of lights are turned as the node is.
#include "geometry/transform.h"
#include "scene/number_reader.h"
#include "scene/scene_reader.h"

NodeReader::NodeReader(FieldReader& in, MaterialReader& materials, ObjectReader& objects,
                       SceneReader& scene)
    : in_(in), materials_(materials), objects_(objects), scene_(scene) {
  findMaterials();
}

/// What the node changes for those in it, its Transform and material, is undone behind it.
const Object3D* NodeReader::read() {
  const std::string_view owner = in_.word();
  if (depth_ > ObjectReader::kMaxNesting) {  // the Scene itself is one more
    in_.report(in_.at(), "expected Nodes at most " + std::to_string(ObjectReader::kMaxNesting) +
                             " deep inside each other, found another");
    in_.skipWordAndBlock();
    return nullptr;
  }
  ++depth_;
  if (objects_.places()) objects_.places()->begin(owner, in_.at());
  const Material* const outerMaterial = materials_.selected();
  const Matrix outer = toWorld_;
  auto group = std::make_unique<Group>();
  Contents contents{*group, std::nullopt};
  const auto ahead = materialsAhead_.find(in_.at());
  if (ahead != materialsAhead_.end()) materials_.selectListed(ahead->second);
  in_.advance();
  if (in_.openBlock(owner)) {
    while (!in_.atEnd() && !in_.isAt('}') && !isOneOf(in_.word(), kNodeSectionWords)) {
      readItem(contents);
    }
    in_.closeBlock(owner);
  }
  toWorld_ = outer;
  materials_.select(outerMaterial);
  const Object3D* object = objects_.keep(std::move(group));
  if (contents.steps) {
    object = objects_.keep(std::make_unique<Transform>(*contents.steps, object));
  }
  if (objects_.places()) objects_.places()->end(object);
  --depth_;
  return object;
}

/// Notes the first material of each node. What is wrong with any is told when it is read.
void NodeReader::findMaterials() {
  Tokenizer words(in_.text().bytes());
  std::vector<std::string_view> blocks;  // the names of those that are open
  std::string_view before;
  for (std::string_view word = words.next(); !word.empty(); before = word, word = words.next()) {
    if (word == "{") blocks.push_back(before);
    if (word == "}" && !blocks.empty()) blocks.pop_back();
    if (before != "index" || blocks.size() < 2 || blocks.back() != "Component<Material>") continue;
    int index = 0;
    if (readInt(word, index)) materialsAhead_.try_emplace(blocks[blocks.size() - 2].data(), index);
  }
}

/// One thing in a node; each ends behind its own braces.
void NodeReader::readItem(Contents& contents) {
  const std::string_view word = in_.word();
  const Object3D* object = nullptr;
  if (word == "Node") {
    object = read();
  } else if (word == "Transform") {
    readTransform(contents);
  } else if (word == "Component<Material>") {
    readMaterial();
  } else if (word == "Component<Object>") {
    object = readObject();
  } else if (word == "Component<Light>") {
    readLight();
  } else {
    in_.skipUnknown("Node", kNodeWords);
  }
  if (object) contents.group.addObject(object);
  contents.isEmpty = false;
}

/// Its product takes what is in the node to the space around it.
void NodeReader::readTransform(Contents& contents) {
  const char* const at = in_.at();
  if (!contents.isEmpty) in_.report(at, "Transform must come first in its Node");
  in_.advance();
  if (!in_.openBlock("Transform")) return;
  Matrix product;
  const bool isGood = readSteps(in_, kNodeStepWords, true, product);
  in_.closeBlock("Transform");
  if (!isGood || !checkInverse(in_, at, product)) return;
  contents.steps = product;
  toWorld_ = toWorld_ * product;
}

void NodeReader::readMaterial() {
  in_.advance();
  if (!in_.openBlock("Component<Material>")) return;
  in_.word() == "index" ? materials_.readIndex("index") : in_.reportExpected("index");
  in_.closeBlock("Component<Material>");
}

/// Takes `{ type T`, from the component's name on; false after a mistake, which is passed over.
bool NodeReader::openComponent(WordList types, std::size_t& type) {
  const std::string_view owner = in_.word();
  in_.advance();
  if (!in_.openBlock(owner)) return false;
  const bool isTyped = in_.word() == "type";
  isTyped ? in_.advance() : in_.reportExpected("type");
  if (isTyped && in_.readChoice("type", types, type)) return true;
  in_.closeBlock(owner);
  return false;
}

/// The fields of a type are those of the block that 2003 has for such a shape.
const Object3D* NodeReader::readObject() {
  const char* const at = in_.at();
  const Material* const material = materials_.materialFor("Component<Object>", at);
  std::size_t type = 0;
  if (!openComponent(kShapeTypes, type)) return nullptr;
  const std::string_view block = kShapeBlocks[type];
  if (objects_.places()) objects_.places()->begin(block, at);
  const Fields fields = in_.readFields(kShapeTypes[type], {block}, {}, at);
  const Object3D* const object =
      fields.areGood ? objects_.addShape(block, at, fields, material) : nullptr;
  if (objects_.places()) objects_.places()->end(object);
  return object;
}

void NodeReader::readLight() {
  const char* const at = in_.at();
  std::size_t type = 0;
  if (!openComponent(kLightTypes, type)) return;
  const Fields fields = in_.readFields("Component<Light>", {kLightBlocks[type]}, {}, at);
  if (fields.areGood) scene_.addLight(at, fields, &toWorld_);
}
