#pragma once

#include "vr/simulator/runtime.h"
#include "vr/simulator/session.h"

namespace simulator
{
/// One call of the client's while it is being answered.
class Call
{
public:
    Call(const char* function, Runtime& answering, std::unique_lock<std::mutex>& held)
        : name(function)
        , runtime(answering)
        , lock(held)
    {}

    /// Of a handle that is neither stale nor lost.
    template <class T, class Handle> T& get(Handle handle)
    {
        const auto object = runtime.handles.get<T>(handle);
        m_concerned.push_back(object);
        return *object;
    }

    /// The client broke a rule that no result tells of.
    void error(const std::string& text) { runtime.log.error(std::string(name) + ": " + text, where()); }
    void warn(const std::string& text) { runtime.log.warning(std::string(name) + ": " + text, where()); }
    /// Warns unless the client's context is current here: it may not be elsewhere, and some runtimes rely on it.
    void checkContext(const Session& session);

    nlohmann::json where() const;
    /// One that the call concerns and that is about to be lost.
    bool isLossPending() const;

    const char* const name;
    Runtime& runtime;
    std::unique_lock<std::mutex>& lock;
    nlohmann::json line = nlohmann::json::object(); ///< for the log

private:
    std::vector<std::shared_ptr<Object>> m_concerned; ///< kept alive to the end of the call
};
} // namespace simulator
