#pragma once

#include <memory>

namespace vr
{
/// A context on a connection of its own to the window system, which Qt cannot make. Of what comes over one connection
/// Mesa's software driver (llvmpipe, 22.3) searches the scenes of all contexts whenever one of them copies a picture,
/// while their threads change them: two threads that draw over one connection crash sooner or later. One file per
/// platform makes it. Used and destroyed on one thread.
class GlConnection
{
public:
    virtual ~GlConnection() = default;

    /// False if the driver refuses. Costs next to nothing where it is current.
    virtual bool makeCurrent() = 0;
};

/// Like the context that is current on this thread, sharing nothing with it; null where the window system has no such
/// connections, or gives none.
std::unique_ptr<GlConnection> separateConnection();
} // namespace vr
