#pragma once

#include "vr/simulator/script_step.h"

#include <cstdint>
#include <map>
#include <string>

namespace simulator
{
/// Changes at given frames: {"start": step, "steps": [step with "frame" and perhaps "session", ...]}. Sessions count
/// from 0, and a session's frames from 0 at its first xrWaitFrame. A step without "session" belongs to the first
/// session.
class Script
{
public:
    struct Moment
    {
        std::int64_t session = 0;
        std::int64_t frame = 0;
        friend auto operator<=>(const Moment&, const Moment&) = default;
    };

    /// Throws std::exception that names the part that is not understood.
    static Script parse(const std::string& json);

    const ScriptStep& start() const { return m_start; }
    /// Returns the step of a moment; null: none.
    const ScriptStep* at(const Moment& moment) const;

private:
    ScriptStep m_start;
    std::map<Moment, ScriptStep> m_steps;
};
} // namespace simulator
