#pragma once

#include "core/util/thread_cpu_time.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <vector>

namespace vr
{
/// Phases of the headset thread's work in a frame, in this order.
enum class FramePhase {
    Events, ///< handling the runtime's events and a request to stop
    Wait,   ///< waiting until the runtime wants a frame
    Input,  ///< reading the wands, the head and the eyes
    Client, ///< FrameClient::frame(): reacting to the input and taking over changes of the model
    Images, ///< acquiring and releasing the images that are drawn into
    Draw,
    Submit
};
inline constexpr std::size_t framePhaseCount = 7;

struct FrameTiming
{
    std::array<double, framePhaseCount> cpuMs{}; ///< CPU time of this thread by FramePhase, milliseconds
    /// CPU time of draw calls within the Draw phase, milliseconds. Without a graphics card the driver rasterises within
    /// them.
    double drawCallMs = 0;
    double workMs = 0;   ///< wall time from the end of the Wait phase to the end of the frame, milliseconds
    double periodMs = 0; ///< time from this frame to the next as the runtime plans it, milliseconds
    /// Number of frames just before this one that should have been shown and were not.
    std::uint32_t dropped = 0;
    bool isShown = false;

    double of(FramePhase phase) const { return cpuMs[static_cast<std::size_t>(phase)]; }
    /// Returns this thread's CPU time in all phases without draw calls, in milliseconds.
    double ownMs() const { return std::accumulate(cpuMs.begin(), cpuMs.end(), -drawCallMs); }
};

/// Timings of the last frames. The headset's thread writes them and never waits for a reader.
class FrameTimings
{
public:
    static constexpr std::size_t capacity = 512;

    void add(const FrameTiming& timing);

    /// Returns the timings, oldest first. Thread: any.
    std::vector<FrameTiming> recent() const;
    std::uint64_t frames() const;
    std::uint64_t droppedFrames() const;

private:
    mutable std::mutex m_mutex; ///< guards the next three members
    std::array<FrameTiming, capacity> m_ring;
    std::uint64_t m_frames = 0;
    std::uint64_t m_dropped = 0;
    /// Writer's own queue: timings that could not be stored while a reader had the mutex.
    std::vector<FrameTiming> m_pending;
};

/// Counts the frames that a headset should have shown and did not, by the gaps between display times.
class DroppedFrameCounter
{
public:
    /// Returns the number of frames dropped before this one. Returns 0 unless this frame and the last one are both
    /// shown: frames that are not shown have no regular rate.
    std::uint32_t count(std::int64_t displayNs, std::int64_t periodNs, bool isShown);

private:
    std::int64_t m_before = 0; ///< display time of the last frame, nanoseconds; 0: it was not shown
};

/// Measures the CPU time of each phase of a frame. Thread: all calls on one thread, whose time is measured.
class PhaseTimer
{
public:
    /// Adds the CPU time since the last call to `phase` of timing(). A phase may occur more than once in a frame.
    void endPhase(FramePhase phase);
    FrameTiming& timing() { return m_timing; }
    /// Clears timing() and starts the next frame.
    void reset() { *this = {}; }

private:
    FrameTiming m_timing;
    double m_lastMs = core::threadCpuMs();
};
} // namespace vr
