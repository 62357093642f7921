#include "core/lesson/lesson.h"

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
} // namespace core
