#pragma once

#include <nlohmann/json.hpp>

#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace simulator
{
/// A log of what the client did. It is kept in memory, and written to a file if there is one, one JSON object per line.
class CallLog
{
public:
    /// Clears the log and opens its file; null: no file.
    void open(const char* path);

    void call(const char* name, nlohmann::json line);
    /// Logs that the client broke a rule of the specification.
    void error(const std::string& text, const nlohmann::json& where);
    /// Logs that the client broke no rule, but that a headset would show a flaw or another runtime would refuse.
    void warning(const std::string& text, const nlohmann::json& where);
    void haptic(const nlohmann::json& pulse);
    void frame(const nlohmann::json& frame);
    void flush();

    /// Returns {"client_errors": [], "client_warnings": [], "haptics": [], "calls": {name: count}, "last_frame": {}}.
    nlohmann::json report() const;

private:
    void write(const nlohmann::json& line);

    std::ofstream m_file;
    std::vector<std::string> m_errors, m_warnings;
    nlohmann::json m_haptics = nlohmann::json::array();
    nlohmann::json m_lastFrame;
    std::map<std::string, long> m_calls;
};
} // namespace simulator
