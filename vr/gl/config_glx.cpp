#include "vr/gl/config_glx.h"

namespace vr
{
GLXFBConfig configOf(Display* contextDisplay, GLXContext context, Display* display)
{
    int id = 0, screen = 0, count = 0;
    glXQueryContext(contextDisplay, context, GLX_FBCONFIG_ID, &id);
    glXQueryContext(contextDisplay, context, GLX_SCREEN, &screen);
    const int wanted[] = {GLX_FBCONFIG_ID, id, 0};
    GLXFBConfig* found = glXChooseFBConfig(display, screen, wanted, &count);
    GLXFBConfig config = found && count > 0 ? found[0] : nullptr;
    if (found)
        XFree(found);
    return config;
}
} // namespace vr
