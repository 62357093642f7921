#include "app/import/foreign_unit.h"

#include "app/import/import_folder.h"

#include <algorithm>

namespace app
{
namespace
{
/// Extensions of formats that are in metres by specification. LWS counts because it refers to LWO files.
constexpr std::string_view endingsInMetres[] = {".dae", ".zae", ".x3d", ".lwo", ".lws", ".ifc"};
constexpr double millimetresInMetre = 1000;

bool isInMetres(const std::string& ending)
{
    return std::ranges::find(endingsInMetres, ending) != std::end(endingsInMetres);
}
} // namespace

double unitOf(const std::filesystem::path& file)
{
    return isInMetres(lowerEnding(file)) ? millimetresInMetre : 1;
}

bool holdsUnit(const std::filesystem::path& file)
{
    const std::string ending = lowerEnding(file);
    return ending == ".fbx" || isInMetres(ending);
}
} // namespace app
