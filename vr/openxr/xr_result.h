#pragma once

#include <QString>

#include <openxr/openxr.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace vr
{
/// Returns the name of a result, such as "XR_ERROR_INSTANCE_LOST". A result that the headers do not define gets a name
/// like "XrResult -7". No instance has to exist.
QString resultName(XrResult result);

/// An OpenXR call that the runtime refused. It is an exception because every call of a session may fail at any time,
/// each failure ends the session, and one place catches them all. Everyday conditions, such as a missing runtime or
/// headset, are values instead: see HeadsetStatus.
class XrError : public std::runtime_error
{
public:
    XrError(const char* call, XrResult result);

    XrResult result() const { return m_result; }
    /// Returns the call and its result, such as "xrCreateSession: XR_ERROR_RUNTIME_FAILURE".
    QString text() const { return QString::fromUtf8(what()); }

private:
    XrResult m_result;
};

/// Throws XrError if the result is an error; `call` is the function's name.
XrResult check(XrResult result, const char* call);

/// Number of times that a list may grow between the two calls that read it. A runtime that exceeds it is faulty.
inline constexpr int maxGrowths = 8;

/// Returns the list of a function with OpenXR's two-call idiom, called as ask(capacity, count, items). `blank` has type
/// and next filled in. Throws XrError.
template <class Item, class Ask> std::vector<Item> enumerate(const char* call, const Item& blank, Ask ask)
{
    for (int growths = 0;; ++growths) {
        std::uint32_t count = 0;
        check(ask(0U, &count, static_cast<Item*>(nullptr)), call);
        std::vector<Item> items(count, blank);
        if (count == 0)
            return items;
        const XrResult result = ask(count, &count, items.data());
        if (result == XR_ERROR_SIZE_INSUFFICIENT && growths < maxGrowths)
            continue;
        check(result, call);
        items.resize(count);
        return items;
    }
}
} // namespace vr
