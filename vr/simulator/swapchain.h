#pragma once

#include "vr/simulator/gl_share.h"
#include "vr/simulator/handles.h"

#include <deque>

namespace simulator
{
/// Textures that the client draws into in turn. Each is acquired, then waited for, then released, in that order.
class Swapchain : public Object
{
public:
    Swapchain(std::shared_ptr<ShareContext> gl, const TextureForm& form, bool isStatic);
    ~Swapchain() override;

    const TextureForm& form() const { return m_form; }
    const std::vector<unsigned int>& textures() const { return m_textures; }
    unsigned int texture(std::size_t image) const { return m_textures[image]; }
    /// Returns the image that was released last, which is what a frame shows.
    const std::optional<std::size_t>& shown() const { return m_shown; }

    /// Steps of the use of an image. They fail if they are called out of order.
    std::size_t acquire();
    void wait();
    void release();

    /// markDrawing() marks what the client has drawn so far; isDrawn() returns whether that is complete. Precondition:
    /// the client's context is current.
    void markDrawing();
    bool isDrawn();

private:
    std::shared_ptr<ShareContext> m_gl;
    TextureForm m_form;
    bool m_isStatic;
    std::vector<unsigned int> m_textures;
    std::size_t m_next = 0;
    std::size_t m_acquiredEver = 0;
    std::deque<std::size_t> m_acquired; ///< images acquired and not yet released, the oldest first
    bool m_isWaited = false;            ///< the oldest acquired image was waited for
    std::optional<std::size_t> m_shown;
    __GLsync* m_drawing = nullptr;
};
} // namespace simulator
