#pragma once

#include "vr/simulator/call_failure.h"

#include <bit>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace simulator
{
/// The object that a handle refers to.
class Object
{
public:
    Object() = default;
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;
    virtual ~Object() = default;

    /// Result of all calls, except destroying, that concern the object or its children; none: not lost.
    std::optional<XrResult> lost;
    Object* parent = nullptr;
    std::uint64_t number = 0; ///< number of the object's handle
};

/// All live handles. Their numbers are never used twice, so that a stale handle is detected.
class Handles
{
public:
    template <class Handle> Handle add(const std::shared_ptr<Object>& object, Object* parent)
    {
        static_assert(sizeof(Handle) == sizeof(std::uint64_t));
        object->parent = parent;
        object->number = m_next++;
        m_objects.emplace(object->number, object);
        return std::bit_cast<Handle>(object->number);
    }

    /// Returns the object of a handle, even if it is lost.
    template <class T, class Handle> std::shared_ptr<T> find(Handle handle) const
    {
        const auto found = m_objects.find(std::bit_cast<std::uint64_t>(handle));
        const auto object = found == m_objects.end() ? nullptr : std::dynamic_pointer_cast<T>(found->second);
        require(object != nullptr, XR_ERROR_HANDLE_INVALID, "a handle is null, destroyed, or of another kind");
        return object;
    }

    template <class T, class Handle> std::shared_ptr<T> get(Handle handle) const
    {
        auto object = find<T>(handle);
        for (const Object* it = object.get(); it; it = it->parent)
            require(!it->lost, it->lost.value_or(XR_SUCCESS), "lost");
        return object;
    }

    template <class T> std::vector<std::shared_ptr<T>> childrenOf(const Object& parent) const
    {
        std::vector<std::shared_ptr<T>> found;
        for (const auto& [number, object] : m_objects) {
            if (auto child = std::dynamic_pointer_cast<T>(object); child && child->parent == &parent)
                found.push_back(std::move(child));
        }
        return found;
    }

    /// Destroys an object, and before it all its children.
    void destroy(const Object& object)
    {
        const std::uint64_t number = object.number;
        for (auto it = m_objects.upper_bound(number); it != m_objects.end();) {
            if (it->second->parent == &object) {
                destroy(*it->second);
                it = m_objects.upper_bound(number);
            } else {
                ++it;
            }
        }
        m_objects.erase(number);
    }

private:
    std::map<std::uint64_t, std::shared_ptr<Object>> m_objects; ///< children have greater numbers than their parents
    std::uint64_t m_next = 1000;
};
} // namespace simulator
