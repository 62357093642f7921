#include "vr/simulator/call.h"

namespace simulator
{
void Call::checkContext(const Session& session)
{
    if (!session.gl()->isClientCurrent())
        warn("the session's OpenGL context is not current on the calling thread");
}

nlohmann::json Call::where() const
{
    const auto& session = runtime.session;
    if (!session)
        return nlohmann::json::object();
    return {{"session", session->index}, {"frame", session->nextFrame - 1}};
}

bool Call::isLossPending() const
{
    return std::any_of(m_concerned.begin(), m_concerned.end(), [](const std::shared_ptr<Object>& object) {
        for (const Object* it = object.get(); it; it = it->parent) {
            const auto* session = dynamic_cast<const Session*>(it);
            if (session && session->state() == XR_SESSION_STATE_LOSS_PENDING)
                return true;
        }
        return false;
    });
}
} // namespace simulator
