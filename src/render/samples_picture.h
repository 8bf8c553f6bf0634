// The picture of the samples: where they lie, and their colours.
// Colours and places as in the course's own pictures: MIT 6.837, "Supersampling and Antialiasing",
// 2004.
#pragma once
#include "image/image.h"
#include "render/sample_batch.h"

/// The part of the picture that belongs to the pixels of `area`, without samples: each pixel is a
/// square of `zoom` x `zoom`, dark grey or black as on a chessboard.
void drawPixels(Image& picture, int zoom, const PixelRectangle& area);

/// One pixel of the sample's colour at its place; of samples at the same place the last one shows.
void drawSample(Image& picture, int zoom, const Sample& sample, const Vec3f& color);
