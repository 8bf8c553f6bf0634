// More samples where colours differ.
#include <cstdlib>

#include "render/sampling.h"

using sampling::adaptive;
using sampling::grey;
using sampling::isSame;
using sampling::leftOf;
using sampling::Pattern;
using sampling::PlainSampling;
using sampling::renderColor;
using sampling::renderSamples;
using sampling::sampled;
using sampling::samplerOf;
using sampling::variedScene;
using sampling::whiteShapes;

TEST("adaptive samples with a tolerance that nothing exceeds are the first ones alone") {
  const SceneParser scene = variedScene();
  CHECK(isSame(renderColor(scene, 60, 50, adaptive(4, 64, 1)),
               renderColor(scene, 60, 50, sampled(Pattern::jittered, 4))));
  const SceneParser edge = whiteShapes(4, 1, leftOf(0.3, 0.5));  // 1 is no more than 1
  CHECK(isSame(renderColor(edge, 20, 20, adaptive(4, 64, 1)),
               renderColor(edge, 20, 20, sampled(Pattern::jittered, 4))));
}

TEST("adaptive samples of a picture of one colour are the first ones, even with tolerance 0") {
  const SceneParser scene = whiteShapes(4, 1, leftOf(50));
  CHECK(isSame(renderSamples(scene, 6, 6, 50, adaptive(9, 144, 0)),
               renderSamples(scene, 6, 6, 50, sampled(Pattern::jittered, 9))));
}

TEST("adaptive samples with a tolerance that all exceed are all of them") {
  const SceneParser scene = variedScene();
  const Image all = renderSamples(scene, 9, 9, 64, adaptive(4, 64, -1));
  const Sampler sampler = samplerOf(Pattern::adaptive, 4, 64);
  int wrong = 0;
  for (int j = 0; j < 9; ++j) {
    for (int i = 0; i < 9; ++i) {
      for (int n = 0; n < 64; ++n) {
        const Vec2d p = sampler.getSamplePosition(i, j, n);
        const Rgb8 dot = all.getPixel(int((i + p.x()) * 64), int((j + p.y()) * 64));
        wrong += dot == grey(0) || dot == grey(0.2f);
      }
    }
  }
  CHECK_EQUAL(wrong, 0);
}

TEST("adaptive samples are many along an edge and few elsewhere") {
  // The edge runs through the pixels of column 4 of 9; those beside it differ from it.
  const SceneParser scene = whiteShapes(9, 1, leftOf(0.1));
  const RenderOptions options = adaptive(4, 256, 0.1);
  const PlainSampling plain(scene, options, 9, 9);
  const Image dots = renderSamples(scene, 9, 9, 512, options);
  for (int j = 2; j < 7; ++j) {
    for (int i = 0; i < 9; ++i) {
      const int expected = i == 4 ? 256 : i == 3 || i == 5 ? 16 : 4;
      CHECK_EQUAL(plain.sampleCount(i, j), expected);
      int found = 0;
      const Rgb8 ground = (i + j) % 2 == 0 ? grey(0.2f) : grey(0);
      const bool isBlack = ground == grey(0);
      if (i >= 4 && isBlack) continue;  // black dots on black
      for (int y = j * 512; y < (j + 1) * 512; ++y)
        for (int x = i * 512; x < (i + 1) * 512; ++x) found += dots.getPixel(x, y) != ground;
      CHECK_NEAR(found, expected, expected / 50);  // two in 256 may fall on the same dot
    }
  }
}

TEST("adaptive colours are close to those of as many samples everywhere") {
  const SceneParser scene = variedScene();
  const Image few = renderColor(scene, 60, 50, adaptive(4, 256, 0.02));
  const Image many = renderColor(scene, 60, 50, sampled(Pattern::jittered, 1024));
  double sum = 0;
  for (int j = 0; j < 50; ++j)
    for (int i = 0; i < 60; ++i) sum += std::abs(few.getPixel(i, j).g - many.getPixel(i, j).g);
  CHECK(sum / 3000 < 0.6);  // bytes; truncation alone makes a third of one
}
