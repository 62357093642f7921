#pragma once

#include <QString>

#include <openxr/openxr.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace vr
{
/// "XR_ERROR_INSTANCE_LOST"; needs no instance. "XrResult -7" for those that the headers do not know.
QString resultName(XrResult result);

/// A call that OpenXR refused. An exception, because each call of a session may be refused at each moment, all of that
/// ends the session, and one place catches it. What people meet every day, no runtime and no headset, is a value:
/// HeadsetStatus.
class XrError : public std::runtime_error
{
public:
    XrError(const char* call, XrResult result);

    XrResult result() const { return m_result; }
    /// "xrCreateSession: XR_ERROR_RUNTIME_FAILURE"
    QString text() const { return QString::fromUtf8(what()); }

private:
    XrResult m_result;
};

/// Throws XrError if the result is an error; `call` is the function's name.
XrResult check(XrResult result, const char* call);

/// Limit of how often a list may grow between the two calls that read it: a runtime that refuses more is at fault.
inline constexpr int maxGrowths = 8;

/// What a function of the two-call idiom lists; ask(capacity, count, items). `blank` has type and next filled in.
/// Throws XrError.
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
