#pragma once

#include "vr/simulator/gl_client.h"
#include "vr/simulator/picture.h"

#include <cstddef>
#include <cstdint>
#include <vector>

struct __GLsync;

namespace simulator
{
/// Format and size of one image of a swapchain.
struct TextureForm
{
    std::int64_t format = 0; ///< sized internal format of OpenGL
    int width = 0, height = 0;
    int layers = 1; ///< above 1: a texture array
    int levels = 1;
};

/// A rectangle in one layer of a texture; y counts rows from the bottom.
struct TexturePart
{
    unsigned int texture = 0;
    TextureForm form;
    int x = 0, y = 0, width = 0, height = 0;
    int layer = 0;
};

/// An OpenGL context of the simulator that shares textures with the client's context. Its functions make it current on
/// the calling thread, and then restore what was current there.
class ShareContext
{
public:
    /// Throws std::runtime_error if no context can share textures with the client's.
    explicit ShareContext(const GlClient& client);
    ~ShareContext();
    ShareContext(const ShareContext&) = delete;
    ShareContext& operator=(const ShareContext&) = delete;

    bool isClientCurrent() const { return isCurrent(m_client); } ///< on this thread

    static const std::vector<std::int64_t>& formats(); ///< supported formats of images, the preferred first
    static bool isDepth(std::int64_t format);

    std::vector<unsigned int> createTextures(const TextureForm& form, std::size_t count) const;
    void destroyTextures(const std::vector<unsigned int>& textures) const;

    /// markDrawing() marks what the client has drawn so far. isDone() returns whether all of that is complete, and
    /// deletes the mark. Precondition: the client's context is current.
    static __GLsync* markDrawing();
    static bool isDone(__GLsync* mark);

    /// Reads what a viewer would see. Values of a linear format are encoded as sRGB. Depth is a number of 24 bits, with
    /// its highest byte in red.
    Picture read(const TexturePart& part) const;

private:
    GlClient m_client;
    void* m_context; ///< the simulator's own
};
} // namespace simulator
