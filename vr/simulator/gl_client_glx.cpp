#include "vr/simulator/gl_client.h"

#include <GL/gl.h>
#include <GL/glx.h>

#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <stdexcept>

namespace simulator
{
namespace
{
Display* displayOf(const GlClient& client)
{
    return static_cast<Display*>(client.display);
}
} // namespace

std::optional<GlClient> glClientIn(const void* chain)
{
    for (auto* it = static_cast<const XrBaseInStructure*>(chain); it; it = it->next) {
        if (it->type != XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR)
            continue;
        const auto& binding = *reinterpret_cast<const XrGraphicsBindingOpenGLXlibKHR*>(it);
        return GlClient{binding.xDisplay, binding.glxFBConfig, binding.glxContext};
    }
    return {};
}

bool isCurrent(const GlClient& client)
{
    return glXGetCurrentContext() == client.context;
}

void* createSharingContext(const GlClient& client)
{
    if (!client.display || !client.config || !client.context)
        throw std::runtime_error("the client's binding is not complete");
    const GLXContext context = glXCreateNewContext(displayOf(client), static_cast<GLXFBConfig>(client.config),
                                                   GLX_RGBA_TYPE, static_cast<GLXContext>(client.context), True);
    if (!context)
        throw std::runtime_error("no OpenGL context shares with the client's");
    return context;
}

void destroyContext(const GlClient& client, void* context)
{
    glXDestroyContext(displayOf(client), static_cast<GLXContext>(context));
}

void* glFunctionAddress(const char* name)
{
    return reinterpret_cast<void*>(glXGetProcAddressARB(reinterpret_cast<const GLubyte*>(name)));
}

struct CurrentContext::Former
{
    Display* display = glXGetCurrentDisplay(); ///< if nothing was current: the client's
    GLXContext context = glXGetCurrentContext();
    GLXDrawable draw = glXGetCurrentDrawable(), read = glXGetCurrentReadDrawable();
};

CurrentContext::CurrentContext(const GlClient& client, void* context) : m_former(std::make_unique<Former>())
{
    if (m_former->context)
        glFinish();
    else
        m_former->display = displayOf(client);
    if (!glXMakeContextCurrent(displayOf(client), None, None, static_cast<GLXContext>(context)))
        throw std::runtime_error("the runtime's own OpenGL context cannot be made current");
}

CurrentContext::~CurrentContext()
{
    glXMakeContextCurrent(m_former->display, m_former->draw, m_former->read, m_former->context);
}
} // namespace simulator
