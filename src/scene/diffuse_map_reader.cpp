// MaterialReader: what a material may say in place of one diffuse colour: a picture, or noise. Both
// are kept apart from the materials, by the PictureLibrary and the scene, and each material that
// has one is told of it.
#include "scene/scene_reader.h"
#include "scene/wording.h"

/// Reads the block behind `Noise`. The first color is that which a NoiseMap calls so.
bool MaterialReader::readNoise(std::unique_ptr<NoiseMap>& noise) {
  const char* const start = in_.at();
  Fields fields(in_.language(), {"noise of colors"});
  std::vector<Vec3f> colors;
  int octaves = 0;
  const bool isRead = in_.readFields("Noise", fields, [&](std::string_view name) {
    if (name == "octaves") return readOctaves(octaves);
    const char* const at = in_.at();
    double rgb[3];
    if (!in_.readNumbers(name, rgb, 3, true)) return false;
    colors.emplace_back(Vec3d(rgb[0], rgb[1], rgb[2]));
    if (colors.size() > 2) in_.reportFound(at, "two color in Noise");
    return colors.size() <= 2;
  });
  if (!isRead) return false;
  if (colors.size() < 2) in_.report(start, "expected two color in Noise, found only one");
  if (colors.size() < 2) return false;
  noise = std::make_unique<NoiseMap>(colors[0], colors[1], octaves, fields["frequency"].number(),
                                     fields["amplitude"].number());
  return true;
}

/// What of the words of a material takes the place of its diffuse colour; null where nothing does.
const DiffuseMap* MaterialReader::mapOf(const Fields& fields, std::unique_ptr<NoiseMap> noise) {
  const auto placeOf = [&](std::string_view name) {
    return fields.has(name) ? fields[name].at : nullptr;
  };
  if (const char* const bump = placeOf("bump")) {
    notes_.warn(bump,
                "bump is passed over: surfaces are drawn without " + quoted(in_.fileNameAt(bump)));
  }
  const char* const texture = placeOf("texture");
  if (texture && noise) {
    in_.report(texture, "expected texture or Noise in a material, found both");
  }
  if (texture) return pictures_.find(in_.fileNameAt(texture));
  if (!noise) return nullptr;
  noiseMaps_.push_back(std::move(noise));
  return noiseMaps_.back().get();
}
