// Source: WGL_ARB_create_context.
#include "vr/simulator/gl_client.h"

#include <unknwn.h> // declares IUnknown, which openxr_platform.h uses
#include <windows.h>

#include <GL/gl.h>

#define XR_USE_PLATFORM_WIN32
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <stdexcept>

namespace simulator
{
namespace
{
HDC displayOf(const GlClient& client)
{
    return static_cast<HDC>(client.display);
}
} // namespace

std::optional<GlClient> glClientIn(const void* chain)
{
    for (auto* it = static_cast<const XrBaseInStructure*>(chain); it; it = it->next) {
        if (it->type != XR_TYPE_GRAPHICS_BINDING_OPENGL_WIN32_KHR)
            continue;
        const auto& binding = *reinterpret_cast<const XrGraphicsBindingOpenGLWin32KHR*>(it);
        return GlClient{binding.hDC, nullptr, binding.hGLRC};
    }
    return {};
}

bool isCurrent(const GlClient& client)
{
    return wglGetCurrentContext() == client.context;
}

void* createSharingContext(const GlClient& client)
{
    if (!client.display || !client.context)
        throw std::runtime_error("the client's binding is not complete");
    using Create = HGLRC(WINAPI*)(HDC, HGLRC, const int*);
    const auto create = reinterpret_cast<Create>(glFunctionAddress("wglCreateContextAttribsARB"));
    const HGLRC context = create ? create(displayOf(client), static_cast<HGLRC>(client.context), nullptr) : nullptr;
    if (!context)
        throw std::runtime_error("no OpenGL context shares with the client's");
    return context;
}

void destroyContext(const GlClient&, void* context)
{
    wglDeleteContext(static_cast<HGLRC>(context));
}

void* glFunctionAddress(const char* name)
{
    return reinterpret_cast<void*>(wglGetProcAddress(name));
}

struct CurrentContext::Former
{
    HDC display = wglGetCurrentDC();
    HGLRC context = wglGetCurrentContext();
};

CurrentContext::CurrentContext(const GlClient& client, void* context) : m_former(std::make_unique<Former>())
{
    if (m_former->context)
        glFinish();
    if (!wglMakeCurrent(displayOf(client), static_cast<HGLRC>(context))) {
        wglMakeCurrent(m_former->display, m_former->context); // a failed call leaves nothing current
        throw std::runtime_error("the runtime's own OpenGL context cannot be made current");
    }
}

CurrentContext::~CurrentContext()
{
    wglMakeCurrent(m_former->display, m_former->context);
}
} // namespace simulator
