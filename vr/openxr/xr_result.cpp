#include "vr/openxr/xr_result.h"

#include <openxr/openxr_reflection.h>

namespace vr
{
QString resultName(XrResult result)
{
#define FETTLE_RESULT_NAME(name, value)                                                                                \
    case name:                                                                                                         \
        return QStringLiteral(#name);
    switch (result) {
        XR_LIST_ENUM_XrResult(FETTLE_RESULT_NAME) default : return QStringLiteral("XrResult %1")
                                                                .arg(static_cast<int>(result));
    }
#undef FETTLE_RESULT_NAME
}

XrError::XrError(const char* call, XrResult result)
    : std::runtime_error(std::string(call) + ": " + resultName(result).toStdString())
    , m_result(result)
{}

XrResult check(XrResult result, const char* call)
{
    if (XR_FAILED(result))
        throw XrError(call, result);
    return result;
}
} // namespace vr
