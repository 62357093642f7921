#pragma once

#include "vr/util/thread_cpu_time.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <vector>

namespace vr
{
/// What the headset's thread does in a frame, in this order.
enum class FramePhase {
    Events, ///< what the runtime and the window have told
    Wait,   ///< for the runtime to want a frame
    Input,  ///< wands, head and eyes
    Client, ///< what follows from them, and what is new of the model
    Images, ///< that are drawn into are taken and given back
    Draw,
    Submit
};
inline constexpr std::size_t framePhaseCount = 7;

struct FrameTiming
{
    std::array<double, framePhaseCount> cpuMs{}; ///< of this thread, by FramePhase
    /// Of Draw, within calls that draw: without a graphics card those make the picture themselves.
    double drawCallMs = 0;
    double workMs = 0;   ///< wall time from the wait's end to the frame's
    double periodMs = 0; ///< from this frame to the next, as the runtime plans it
    /// Frames that should have been shown before this one, and were not.
    std::uint32_t dropped = 0;
    bool isShown = false;

    double of(FramePhase phase) const { return cpuMs[static_cast<std::size_t>(phase)]; }
    /// All that this thread had of a core, outside calls that draw.
    double ownMs() const { return std::accumulate(cpuMs.begin(), cpuMs.end(), -drawCallMs); }
};

/// What the last frames cost. Written by the headset's thread, which never waits for those that read.
class FrameTimings
{
public:
    static constexpr std::size_t capacity = 512;

    void add(const FrameTiming& timing);

    /// The oldest first. Any thread.
    std::vector<FrameTiming> recent() const;
    std::uint64_t frames() const;
    std::uint64_t droppedFrames() const;

private:
    mutable std::mutex m_mutex; ///< of the next three
    std::array<FrameTiming, capacity> m_ring;
    std::uint64_t m_frames = 0;
    std::uint64_t m_dropped = 0;
    std::vector<FrameTiming> m_pending; ///< the writer's own: what it could not put in while somebody read
};

/// Counts the frames that a headset should have shown and did not: the times at which frames are seen skip periods.
class DroppedFrameCounter
{
public:
    /// Returns the frames dropped before this one. Only between two frames that are both shown: others may come as they
    /// like.
    std::uint32_t count(std::int64_t displayNs, std::int64_t periodNs, bool isShown);

private:
    std::int64_t m_before = 0; ///< 0: the frame before was not shown
};

/// What each phase of a frame has of the processor. To be used on one thread.
class PhaseTimer
{
public:
    /// All since the last call was this phase; into timing(). A phase may come more than once.
    void endPhase(FramePhase phase);
    FrameTiming& timing() { return m_timing; }
    /// The next frame begins here.
    void reset() { *this = {}; }

private:
    FrameTiming m_timing;
    double m_lastMs = threadCpuMilliseconds();
};
} // namespace vr
