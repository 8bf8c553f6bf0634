// The arguments about parts of pictures: -region, -tile and -merge.
#pragma once
#include <vector>

#include "cli/option_table.h"
#include "render/image_plane.h"

std::vector<OptionRow> partRows();

/// Throws UsageError where the part that `options` want does not lie in the picture, or something
/// is wanted that has no parts.
void checkPart(const Options& options);

/// The pixels that are rendered: the part that `options` want, else the whole picture. The part
/// passed checkPart. Counted from the lower left corner of the whole picture.
PixelRectangle renderedArea(const Options& options);
