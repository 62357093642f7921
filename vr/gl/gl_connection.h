#pragma once

#include <memory>

namespace vr
{
/// An OpenGL context on its own connection to the window system, which Qt cannot make. Mesa's software driver
/// (llvmpipe, 22.3) needs separate connections. When a context copies a picture, the driver searches the scenes of all
/// contexts on its connection while their threads change them. Two threads that draw over one connection therefore
/// crash sooner or later.
///
/// Each platform has an implementation in a file of its own.
///
/// Thread: used and destroyed on one thread.
class GlConnection
{
public:
    virtual ~GlConnection() = default;

    /// Makes the context current. Returns false if the driver refuses. Cost: negligible if the context is current
    /// already.
    virtual bool makeCurrent() = 0;
};

/// Returns a context like the one that is current on this thread, sharing no objects with it. Returns null if the
/// window system has no separate connections, or refuses one.
std::unique_ptr<GlConnection> separateConnection();
} // namespace vr
