#include "stroke_file.h"

#include <array>
#include <charconv>
#include <ostream>

namespace core
{
namespace
{
std::string shortest(double value)
{
    std::array<char, 32> digits;
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return std::string(digits.data(), end);
}

std::string list(std::initializer_list<double> values)
{
    std::string text;
    for (const double value : values)
        text += (text.empty() ? "[" : ",") + shortest(value);
    return text + "]";
}

void writeSample(std::ostream& out, const StrokeSample& sample)
{
    const auto& [x, y, z] = std::array{sample.position.x(), sample.position.y(), sample.position.z()};
    const Eigen::Quaterniond& turn = sample.rotation;
    out << "{\"t\":" << shortest(sample.time) << ",\"position\":" << list({x, y, z}) << ",\"direction\":"
        << list({sample.direction.x(), sample.direction.y(), sample.direction.z()})
        << ",\"pressure\":" << shortest(sample.pressure)
        << ",\"rotation\":" << list({turn.x(), turn.y(), turn.z(), turn.w()});
    if (sample.radius)
        out << ",\"radius\":" << shortest(*sample.radius);
    if (sample.strength)
        out << ",\"strength\":" << shortest(*sample.strength);
    out << '}';
}

void writeStroke(std::ostream& out, const Stroke& stroke)
{
    const StrokeSettings& settings = stroke.settings;
    out << "{\"tool\":\"" << name(settings.tool) << "\",\"brush\":\"" << name(settings.brush)
        << "\",\"radius\":" << shortest(settings.radius)
        << ",\"strength\":" << shortest(settings.strength) << ",\"falloff\":" << settings.falloff
        << ",\"detail\":" << shortest(settings.detail) << ",\"topology\":\"" << name(settings.topology) << "\",\"fusion\":"
        << (settings.fusion ? "true" : "false") << ",\"symmetry\":\"" << name(settings.symmetry)
        << "\",\"spacing\":" << shortest(settings.spacing) << ",\"place\":\""
        << name(settings.place) << "\",\"add\":" << (settings.add ? "true" : "false") << ",\"color\":"
        << list({double(settings.color.r), double(settings.color.g), double(settings.color.b)});
    if (settings.detailLength > 0)
        out << ",\"detail_length\":" << shortest(settings.detailLength);
    out << ",\"samples\":[";
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
        out << (i == 0 ? "\n" : ",\n");
        writeSample(out, stroke.samples[i]);
    }
    out << "]}";
}
} // namespace

void writeStrokes(std::ostream& out, const std::vector<Stroke>& strokes)
{
    out << R"({"format":"fettle-strokes","version":1,"strokes":[)";
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        out << (i == 0 ? "\n" : ",\n");
        writeStroke(out, strokes[i]);
    }
    out << "]}\n";
}
} // namespace core
