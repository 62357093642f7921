#pragma once

#include "vr/simulator/runtime.h"
#include "vr/simulator/session.h"

namespace simulator
{
/// A call by the client while it is being answered.
class Call
{
public:
    Call(const char* function, Runtime& answering, std::unique_lock<std::mutex>& held)
        : name(function)
        , runtime(answering)
        , lock(held)
    {}

    /// Returns the object of a handle. Fails if the handle is stale or the object is lost.
    template <class T, class Handle> T& get(Handle handle)
    {
        const auto object = runtime.handles.get<T>(handle);
        m_concerned.push_back(object);
        return *object;
    }

    /// Logs that the client broke a rule of the specification.
    void error(const std::string& text) { runtime.log.error(std::string(name) + ": " + text, where()); }
    void warn(const std::string& text) { runtime.log.warning(std::string(name) + ": " + text, where()); }
    /// Warns unless the client's context is current on this thread. It may not be current elsewhere, and some runtimes
    /// rely on it.
    void checkContext(const Session& session);

    nlohmann::json where() const;
    /// Returns whether an object that the call concerns is about to be lost.
    bool isLossPending() const;

    const char* const name;
    Runtime& runtime;
    std::unique_lock<std::mutex>& lock;
    nlohmann::json line = nlohmann::json::object(); ///< fields of the log entry of this call

private:
    std::vector<std::shared_ptr<Object>> m_concerned; ///< objects that the call concerns, kept alive to its end
};
} // namespace simulator
