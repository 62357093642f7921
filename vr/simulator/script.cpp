#include "vr/simulator/script.h"

#include "vr/simulator/script_values.h"

namespace simulator
{
namespace
{
using nlohmann::json;

std::int64_t taken(json& step, const char* key, std::int64_t otherwise)
{
    const auto found = step.find(key);
    if (found == step.end())
        return otherwise;
    const std::int64_t value = readCount(*found);
    step.erase(key);
    return value;
}

Script::Moment takenMoment(json& step)
{
    if (!step.is_object() || !step.contains("frame"))
        throw std::runtime_error(step.dump() + " should be an object with a \"frame\"");
    return {taken(step, "session", 0), taken(step, "frame", 0)};
}
} // namespace

Script Script::parse(const std::string& text)
{
    Script script;
    for (auto& [key, value] : members(json::parse(text))) {
        if (key == "start") {
            script.m_start = readStep(value);
        } else if (key == "steps") {
            for (json step : value) {
                const Moment moment = takenMoment(step);
                for (const Change& change : readStep(step))
                    script.m_steps[moment].push_back(change);
            }
        } else {
            notUnderstood(key);
        }
    }
    return script;
}

const ScriptStep* Script::at(const Moment& moment) const
{
    const auto found = m_steps.find(moment);
    return found == m_steps.end() ? nullptr : &found->second;
}
} // namespace simulator
