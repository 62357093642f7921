#include "vr/openxr/active_runtime.h"

#include <QSettings>

namespace vr
{
QString systemManifest()
{
    const QSettings registry(QStringLiteral("HKEY_LOCAL_MACHINE\\SOFTWARE\\Khronos\\OpenXR\\1"),
                             QSettings::NativeFormat);
    return registry.value(QStringLiteral("ActiveRuntime")).toString();
}
} // namespace vr
