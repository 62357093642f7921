#include "vr/simulator/script_values.h"

#include <cmath>

namespace simulator
{
using nlohmann::json;

namespace
{
void expect(bool holds, const json& value, const char* wanted)
{
    if (!holds)
        throw std::runtime_error(value.dump() + " should be " + wanted);
}
} // namespace

void notUnderstood(const std::string& key)
{
    throw std::runtime_error("\"" + key + "\" is not understood");
}

std::vector<std::pair<std::string, json>> members(const json& object)
{
    expect(object.is_object(), object, "an object");
    std::vector<std::pair<std::string, json>> found;
    for (const auto& [key, value] : object.items())
        found.emplace_back(key, value);
    return found;
}

bool readBool(const json& value)
{
    expect(value.is_boolean(), value, "true or false");
    return value.get<bool>();
}

std::string readText(const json& value)
{
    expect(value.is_string(), value, "a text");
    return value.get<std::string>();
}

std::int64_t readCount(const json& value)
{
    expect(value.is_number_unsigned(), value, "a number of frames");
    return value.get<std::int64_t>();
}

double readPositive(const json& value)
{
    expect(value.is_number() && value.get<double>() > 0, value, "a number above 0");
    return value.get<double>();
}

double readAmount(const json& value)
{
    if (value.is_boolean())
        return value.get<bool>() ? 1 : 0;
    expect(value.is_number(), value, "a number");
    return value.get<double>();
}

std::vector<double> readNumbers(const json& value, std::size_t count)
{
    const bool fits = value.is_array() && value.size() == count &&
                      std::all_of(value.begin(), value.end(), [](const json& it) { return it.is_number(); });
    expect(fits, value, "an array of so many numbers");
    return value.get<std::vector<double>>();
}

core::Vec3 readVector(const json& value)
{
    const std::vector<double> numbers = readNumbers(value, 3);
    return {numbers[0], numbers[1], numbers[2]};
}

Eigen::Quaterniond readRotation(const std::string& key, const json& value)
{
    if (key == "yaw_pitch_roll") {
        const core::Vec3 angles = readVector(value) * radiansPerDegree;
        return Eigen::AngleAxisd(angles[0], core::Vec3::UnitY()) * Eigen::AngleAxisd(angles[1], core::Vec3::UnitX()) *
               Eigen::AngleAxisd(angles[2], core::Vec3::UnitZ());
    }
    if (key != "rotation")
        notUnderstood(key);
    const std::vector<double> numbers = readNumbers(value, 4);
    const Eigen::Quaterniond rotation(numbers[3], numbers[0], numbers[1], numbers[2]);
    expect(std::abs(rotation.norm() - 1) < 1e-3, value, "a unit quaternion");
    return rotation.normalized();
}

vr::Pose readPose(const json& value)
{
    vr::Pose pose;
    for (const auto& [key, part] : members(value)) {
        if (key == "position")
            pose.position = readVector(part);
        else
            pose.rotation = readRotation(key, part);
    }
    return pose;
}

Tracking readTracking(const json& value)
{
    if (value.is_string())
        return readOneOf<Tracking>(value,
                                   {{"rotation", Tracking::RotationOnly}, {"no_position", Tracking::NoPosition}});
    return readBool(value) ? Tracking::Full : Tracking::None;
}
} // namespace simulator
