#pragma once

#include <GL/glx.h>

namespace vr
{
/// Returns the framebuffer configuration that `context` was made with, as `display` knows it; null if `display` has no
/// such configuration. `display` is `contextDisplay` or another connection to the same X server.
GLXFBConfig configOf(Display* contextDisplay, GLXContext context, Display* display);
} // namespace vr
