// How much stack a thread needs that traces rays.
#pragma once
#include <cstddef>

#include "render/render_options.h"

/// Enough for the deepest scene, and for each bounce that the options allow (measured: below 1 kB a
/// bounce, 1.6 kB between solid textures, 3 kB with sanitizers). In bytes.
inline std::size_t tracingStack(const RenderOptions& options) {
  constexpr std::size_t kBase = 2 << 20, kPerBounce = 8192;
  return kBase + std::size_t(options.maxBounces) * kPerBounce;
}
