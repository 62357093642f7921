#include "vr/simulator/swapchain.h"

#include <utility>

namespace simulator
{
namespace
{
constexpr std::size_t imageCount = 3;
}

Swapchain::Swapchain(std::shared_ptr<ShareContext> gl, const TextureForm& form, bool isStatic)
    : m_gl(std::move(gl))
    , m_form(form)
    , m_isStatic(isStatic)
    , m_textures(m_gl->createTextures(form, isStatic ? 1 : imageCount))
{}

Swapchain::~Swapchain()
{
    m_gl->destroyTextures(m_textures);
}

std::size_t Swapchain::acquire()
{
    const bool isFree = m_acquired.size() < m_textures.size() && !(m_isStatic && m_acquiredEver > 0);
    require(isFree, XR_ERROR_CALL_ORDER_INVALID, "there is no image left to acquire");
    const std::size_t image = m_next;
    m_next = (m_next + 1) % m_textures.size();
    ++m_acquiredEver;
    m_acquired.push_back(image);
    return image;
}

void Swapchain::wait()
{
    require(!m_acquired.empty(), XR_ERROR_CALL_ORDER_INVALID, "no image is acquired");
    require(!m_isWaited, XR_ERROR_CALL_ORDER_INVALID, "the image that was waited for is not released");
    m_isWaited = true;
}

void Swapchain::release()
{
    require(!m_acquired.empty() && m_isWaited, XR_ERROR_CALL_ORDER_INVALID, "no image was acquired and waited for");
    m_shown = m_acquired.front();
    m_acquired.pop_front();
    m_isWaited = false;
}

void Swapchain::markDrawing()
{
    isDrawn();
    m_drawing = ShareContext::markDrawing();
}

bool Swapchain::isDrawn()
{
    __GLsync* mark = std::exchange(m_drawing, nullptr);
    return !mark || ShareContext::isDone(mark);
}
} // namespace simulator
