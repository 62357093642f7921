#include "core/lesson/lesson.h"

#include <algorithm>

namespace core
{
const std::string& LessonText::in(std::string_view language) const
{
    static const std::string none;
    for (const std::string_view code :
         {language, language.substr(0, language.find_first_of("_-")), std::string_view("en")})
        if (const auto found = words.find(code); found != words.end())
            return found->second;
    return words.empty() ? none : words.begin()->second;
}

std::vector<LessonBrush> brushesOf(const LessonStep& step)
{
    std::vector<LessonBrush> brushes;
    for (const FileEntry& entry : step.strokes)
        if (const auto* const stroke = std::get_if<Stroke>(&entry))
            if (const StrokeSettings& its = stroke->settings;
                std::ranges::find(brushes, its.tool, &LessonBrush::tool) == brushes.end())
                brushes.push_back({its.tool, its.radius, its.strength});
    return brushes;
}
} // namespace core
