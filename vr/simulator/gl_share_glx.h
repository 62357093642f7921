#pragma once

#include "vr/simulator/picture.h"

#include <openxr/openxr.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

struct _XDisplay; // what Display, GLXFBConfig and GLXContext stand for, without X's many macros
struct __GLXFBConfigRec;
struct __GLXcontextRec;
struct __GLsync;

namespace simulator
{
/// One image of a swapchain, in OpenGL's terms.
struct TextureForm
{
    std::int64_t format = 0; ///< sized, internal
    int width = 0, height = 0;
    int layers = 1; ///< above 1: a texture array
    int levels = 1;
};

/// A part of a texture; rows from below.
struct TexturePart
{
    unsigned int texture = 0;
    TextureForm form;
    int x = 0, y = 0, width = 0, height = 0;
    int layer = 0;
};

/// An OpenGL context of our own that shares textures with the client's. Its functions make it current on the calling
/// thread and then give the thread back what it had.
class ShareContext
{
public:
    struct Client
    {
        _XDisplay* display = nullptr;
        __GLXFBConfigRec* config = nullptr;
        __GLXcontextRec* context = nullptr;
    };

    /// From a structure's next chain.
    static std::optional<Client> find(const void* chain);

    /// Throws std::runtime_error if the client's cannot be shared with.
    explicit ShareContext(const Client& client);
    ~ShareContext();
    ShareContext(const ShareContext&) = delete;
    ShareContext& operator=(const ShareContext&) = delete;

    /// On this thread.
    bool isClientCurrent() const;

    static const std::vector<std::int64_t>& formats(); ///< the preferred first
    static bool isDepth(std::int64_t format);

    std::vector<unsigned int> createTextures(const TextureForm& form, std::size_t count) const;
    void destroyTextures(const std::vector<unsigned int>& textures) const;

    /// Both in the client's context, which is current: what it has drawn so far, and whether all of that is done. The
    /// mark is used up.
    static __GLsync* markDrawing();
    static bool isDone(__GLsync* mark);

    /// Reads what a viewer would see: a linear format's values encoded as sRGB; depth as a number of 24 bits, red the
    /// highest.
    Picture read(const TexturePart& part) const;

private:
    class Scope;

    Client m_client;
    __GLXcontextRec* m_context = nullptr;
};
} // namespace simulator
