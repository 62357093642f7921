#include "vr/gl/gl_connection.h"

namespace vr
{
/// WGL has no connections.
std::unique_ptr<GlConnection> separateConnection()
{
    return nullptr;
}
} // namespace vr
