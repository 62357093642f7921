#include "vr/gl/gl_binding.h"

#include "vr/gl/config_glx.h"

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
} // namespace

std::unique_ptr<GlBinding> currentGlBinding()
{
    Display* display = glXGetCurrentDisplay();
    GLXContext context = glXGetCurrentContext();
    if (!display || !context)
        return currentEglBinding();
    GLXFBConfig config = configOf(display, context, display);
    int visual = 0;
    if (!config || glXGetFBConfigAttrib(display, config, GLX_VISUAL_ID, &visual) != 0)
        return nullptr;
    return std::make_unique<GlxBinding>(
        XrGraphicsBindingOpenGLXlibKHR{XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR, nullptr, display,
                                       static_cast<std::uint32_t>(visual), config, glXGetCurrentDrawable(), context});
}
} // namespace vr
