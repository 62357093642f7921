#include "vr/gl/gl_binding.h"

#include <unknwn.h> // declares IUnknown, which openxr_platform.h uses
#include <windows.h>

#define XR_USE_PLATFORM_WIN32
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

namespace vr
{
namespace
{
class WglBinding : public GlBinding
{
public:
    explicit WglBinding(const XrGraphicsBindingOpenGLWin32KHR& binding) : m_binding(binding) {}

    const char* extension() const override { return XR_KHR_OPENGL_ENABLE_EXTENSION_NAME; }
    const void* next() const override { return &m_binding; }

private:
    XrGraphicsBindingOpenGLWin32KHR m_binding;
};
} // namespace

std::unique_ptr<GlBinding> currentGlBinding()
{
    const HGLRC context = wglGetCurrentContext();
    if (!context)
        return nullptr;
    return std::make_unique<WglBinding>(XrGraphicsBindingOpenGLWin32KHR{XR_TYPE_GRAPHICS_BINDING_OPENGL_WIN32_KHR,
                                                                        nullptr, wglGetCurrentDC(), context});
}

/// Returns null: runtimes on Windows take OpenGL by WGL only.
std::unique_ptr<GlBinding> currentEglBinding()
{
    return nullptr;
}
} // namespace vr
