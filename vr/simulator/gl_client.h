#pragma once

#include <memory>
#include <optional>

namespace simulator
{
/// The OpenGL context of a client, as its graphics binding names it. The types are those of GLX or of WGL, which bring
/// many macros.
struct GlClient
{
    void* display = nullptr; ///< Display*; HDC
    void* config = nullptr;  ///< GLXFBConfig; null
    void* context = nullptr; ///< GLXContext; HGLRC
};

/// Returns the client's OpenGL binding in a structure's next chain; none if there is no such binding.
std::optional<GlClient> glClientIn(const void* chain);

/// Returns whether the client's context is current on this thread.
bool isCurrent(const GlClient& client);

/// Returns a new context that shares textures with the client's. Throws std::runtime_error if there can be none.
/// Precondition: the client's context is current, as OpenXR wants it when a session is created.
void* createSharingContext(const GlClient& client);
void destroyContext(const GlClient& client, void* context);

/// Returns the address of an OpenGL function. Precondition: a context is current on this thread.
void* glFunctionAddress(const char* name);

/// Makes a context current on the calling thread, when the client's drawing is complete, and then restores what was
/// current there.
class CurrentContext
{
public:
    /// Throws std::runtime_error if the context cannot be made current.
    CurrentContext(const GlClient& client, void* context);
    ~CurrentContext();
    CurrentContext(const CurrentContext&) = delete;
    CurrentContext& operator=(const CurrentContext&) = delete;

private:
    struct Former;
    std::unique_ptr<Former> m_former;
};
} // namespace simulator
