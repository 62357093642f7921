#include "vr/gl/gl_connection.h"

namespace vr
{
/// Returns null: WGL has no connections to the window system.
std::unique_ptr<GlConnection> separateConnection()
{
    return nullptr;
}
} // namespace vr
