// The picture of a filter's weights.
#pragma once
#include "image/image.h"
#include "render/filter.h"

/// Draws, in a picture of `width` x `height` pixels enlarged `zoom` times, the weight that each
/// place has for the pixel in the middle: grey from 0 to 1 in the pixels that the filter reaches,
/// dark blue beyond, and a blue grid of one-pixel lines between the pixels. The result has
/// width * zoom + 1 by height * zoom + 1 pixels.
Image drawFilter(const Filter& filter, int width, int height, int zoom);
