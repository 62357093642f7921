#pragma once

#include <GL/glx.h>

namespace vr
{
/// The one that the context was made with, as that display has it: the context's own, or another connection to the same
/// server. Null if it has none such.
GLXFBConfig configOf(Display* contextDisplay, GLXContext context, Display* display);
} // namespace vr
