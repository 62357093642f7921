#include "gl_binding.h"

#include <GL/glx.h>

#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

namespace vr
{
namespace
{
class GlxBinding : public GlBinding
{
public:
    explicit GlxBinding(const XrGraphicsBindingOpenGLXlibKHR& binding) : m_binding(binding) {}

    const char* extension() const override { return XR_KHR_OPENGL_ENABLE_EXTENSION_NAME; }
    const void* next() const override { return &m_binding; }

private:
    XrGraphicsBindingOpenGLXlibKHR m_binding;
};

/// The one that the context was made with; null if it is none.
GLXFBConfig configOf(Display* display, GLXContext context)
{
    int id = 0, screen = 0, count = 0;
    glXQueryContext(display, context, GLX_FBCONFIG_ID, &id);
    glXQueryContext(display, context, GLX_SCREEN, &screen);
    const int wanted[] = {GLX_FBCONFIG_ID, id, 0};
    GLXFBConfig* found = glXChooseFBConfig(display, screen, wanted, &count);
    GLXFBConfig config = found && count > 0 ? found[0] : nullptr;
    if (found)
        XFree(found);
    return config;
}
} // namespace

std::unique_ptr<GlBinding> currentGlBinding()
{
    Display* display = glXGetCurrentDisplay();
    GLXContext context = glXGetCurrentContext();
    if (!display || !context)
        return currentEglBinding();
    GLXFBConfig config = configOf(display, context);
    int visual = 0;
    if (!config || glXGetFBConfigAttrib(display, config, GLX_VISUAL_ID, &visual) != 0)
        return nullptr;
    return std::make_unique<GlxBinding>(XrGraphicsBindingOpenGLXlibKHR{XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR, nullptr, display,
                                                                       static_cast<std::uint32_t>(visual), config,
                                                                       glXGetCurrentDrawable(), context});
}
} // namespace vr
