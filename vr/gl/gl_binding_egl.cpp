#include "vr/gl/gl_binding.h"

#include <EGL/egl.h>

#define XR_USE_PLATFORM_EGL
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

namespace vr
{
namespace
{
class EglBinding : public GlBinding
{
public:
    explicit EglBinding(const XrGraphicsBindingEGLMNDX& binding) : m_binding(binding) {}

    const char* extension() const override { return XR_MNDX_EGL_ENABLE_EXTENSION_NAME; }
    const void* next() const override { return &m_binding; }

private:
    XrGraphicsBindingEGLMNDX m_binding;
};
} // namespace

std::unique_ptr<GlBinding> currentEglBinding()
{
    EGLDisplay display = eglGetCurrentDisplay();
    EGLContext context = eglGetCurrentContext();
    EGLint api = EGL_OPENGL_ES_API, id = 0, count = 0;
    if (!context || !eglQueryContext(display, context, EGL_CONTEXT_CLIENT_TYPE, &api) || api != EGL_OPENGL_API)
        return nullptr;
    eglQueryContext(display, context, EGL_CONFIG_ID, &id);
    const EGLint wanted[] = {EGL_CONFIG_ID, id, EGL_NONE};
    EGLConfig config = nullptr;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1)
        return nullptr;
    return std::make_unique<EglBinding>(XrGraphicsBindingEGLMNDX{XR_TYPE_GRAPHICS_BINDING_EGL_MNDX, nullptr,
                                                                 eglGetProcAddress, display, config, context});
}
} // namespace vr
