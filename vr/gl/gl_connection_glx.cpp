#include "vr/gl/gl_connection.h"

#include "vr/gl/config_glx.h"

#include <GL/glxext.h>

namespace vr
{
namespace
{
struct CloseDisplay
{
    void operator()(Display* display) const { XCloseDisplay(display); }
};
using OwnDisplay = std::unique_ptr<Display, CloseDisplay>;

class GlxConnection : public GlConnection
{
public:
    GlxConnection(OwnDisplay display, GLXFBConfig config, GLXContext context)
        : m_display(std::move(display))
        , m_context(context)
    {
        const int smallest[] = {GLX_PBUFFER_WIDTH, 1, GLX_PBUFFER_HEIGHT, 1, 0};
        m_surface = glXCreatePbuffer(m_display.get(), config, smallest);
    }
    ~GlxConnection() override
    {
        if (glXGetCurrentContext() == m_context)
            glXMakeContextCurrent(m_display.get(), None, None, nullptr);
        glXDestroyContext(m_display.get(), m_context);
        glXDestroyPbuffer(m_display.get(), m_surface);
    }

    bool makeCurrent() override
    {
        return (glXGetCurrentContext() == m_context && glXGetCurrentDrawable() == m_surface) ||
               glXMakeContextCurrent(m_display.get(), m_surface, m_surface, m_context);
    }

private:
    OwnDisplay m_display;
    GLXContext m_context;
    GLXPbuffer m_surface;
};

GLXContext coreContext(Display* display, GLXFBConfig config)
{
    const auto create = reinterpret_cast<PFNGLXCREATECONTEXTATTRIBSARBPROC>(
        glXGetProcAddressARB(reinterpret_cast<const GLubyte*>("glXCreateContextAttribsARB")));
    const int wanted[] = {
        GLX_CONTEXT_MAJOR_VERSION_ARB,    3, GLX_CONTEXT_MINOR_VERSION_ARB, 3, GLX_CONTEXT_PROFILE_MASK_ARB,
        GLX_CONTEXT_CORE_PROFILE_BIT_ARB, 0};
    return create ? create(display, config, nullptr, True, wanted) : nullptr;
}
} // namespace

std::unique_ptr<GlConnection> separateConnection()
{
    Display* theirs = glXGetCurrentDisplay();
    if (!theirs)
        return nullptr;
    OwnDisplay display(XOpenDisplay(DisplayString(theirs)));
    if (!display)
        return nullptr;
    GLXFBConfig config = configOf(theirs, glXGetCurrentContext(), display.get());
    int drawables = 0;
    if (!config || glXGetFBConfigAttrib(display.get(), config, GLX_DRAWABLE_TYPE, &drawables) != 0 ||
        !(drawables & GLX_PBUFFER_BIT))
        return nullptr;
    GLXContext context = coreContext(display.get(), config);
    if (!context)
        return nullptr;
    return std::make_unique<GlxConnection>(std::move(display), config, context);
}
} // namespace vr
