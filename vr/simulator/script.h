#pragma once

#include "vr/simulator/script_step.h"

#include <cstdint>
#include <map>
#include <string>

namespace simulator
{
/// What happens by itself: {"start": step, "steps": [step with "frame" and perhaps "session", ...]}. Sessions are
/// counted from 0, a session's frames from 0 at its first xrWaitFrame; a step without "session" is of the first.
class Script
{
public:
    struct Moment
    {
        std::int64_t session = 0;
        std::int64_t frame = 0;
        friend auto operator<=>(const Moment&, const Moment&) = default;
    };

    /// Throws std::exception that says what is not understood.
    static Script parse(const std::string& json);

    const ScriptStep& start() const { return m_start; }
    /// Null: nothing happens then.
    const ScriptStep* at(const Moment& moment) const;

private:
    ScriptStep m_start;
    std::map<Moment, ScriptStep> m_steps;
};
} // namespace simulator
