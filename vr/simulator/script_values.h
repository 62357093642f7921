#pragma once

#include "vr/simulator/simulated_world.h"

#include <nlohmann/json.hpp>

#include <stdexcept>
#include <utility>

/// Readers of the values in a script. All throw std::runtime_error that says what is wrong.
namespace simulator
{
inline constexpr double radiansPerDegree = 3.14159265358979323846 / 180;

[[noreturn]] void notUnderstood(const std::string& key);

std::vector<std::pair<std::string, nlohmann::json>> members(const nlohmann::json& object);

bool readBool(const nlohmann::json& value);
std::string readText(const nlohmann::json& value);
std::int64_t readCount(const nlohmann::json& value);
double readPositive(const nlohmann::json& value);
/// Reads a number; false and true count as 0 and 1.
double readAmount(const nlohmann::json& value);
std::vector<double> readNumbers(const nlohmann::json& value, std::size_t count);
core::Vec3 readVector(const nlohmann::json& value);
/// Reads a rotation. Key "rotation": quaternion [x, y, z, w]. Key "yaw_pitch_roll": degrees about Y (left is positive),
/// then X (up), then Z.
Eigen::Quaterniond readRotation(const std::string& key, const nlohmann::json& value);
vr::Pose readPose(const nlohmann::json& value);
/// Reads the quality of tracking: true, false, "rotation" (the position is a guess) or "no_position" (only the rotation
/// is known).
Tracking readTracking(const nlohmann::json& value);

template <class Choice> Choice readOneOf(const nlohmann::json& value, const std::map<std::string, Choice>& choices)
{
    const auto found = choices.find(readText(value));
    if (found == choices.end())
        throw std::runtime_error(readText(value) + " is not among the choices");
    return found->second;
}
} // namespace simulator
