#include "vr/simulator/call_log.h"

namespace simulator
{
using nlohmann::json;

void CallLog::open(const char* path)
{
    *this = CallLog();
    if (path && *path)
        m_file.open(path, std::ios::trunc);
}

void CallLog::call(const char* name, json line)
{
    ++m_calls[name];
    if (!m_file.is_open())
        return;
    line["call"] = name;
    write(line);
}

void CallLog::error(const std::string& text, const json& where)
{
    m_errors.push_back(text);
    write({{"client_error", text}, {"at", where}});
    flush();
}

void CallLog::warning(const std::string& text, const json& where)
{
    m_warnings.push_back(text);
    write({{"client_warning", text}, {"at", where}});
}

void CallLog::haptic(const json& pulse)
{
    m_haptics.push_back(pulse);
    write({{"haptic", pulse}});
}

void CallLog::frame(const json& frame)
{
    m_lastFrame = frame;
    write({{"ended_frame", frame}});
    flush();
}

void CallLog::flush()
{
    if (m_file.is_open())
        m_file.flush();
}

json CallLog::report() const
{
    return {{"client_errors", m_errors},
            {"client_warnings", m_warnings},
            {"haptics", m_haptics},
            {"calls", m_calls},
            {"last_frame", m_lastFrame}};
}

void CallLog::write(const json& line)
{
    if (m_file.is_open())
        m_file << line.dump() << '\n';
}
} // namespace simulator
