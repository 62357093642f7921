#pragma once

#include "ui/settings/view_appearance.h"

#include <QtGlobal>

namespace ui
{
enum class ExportUse { Print, ColorPrint, Game };

/// Uses of an exported model. The keys are file name extensions of the formats.
inline constexpr std::array<Named<ExportUse>, 3> exportUses{
    {{ExportUse::Print, "stl"}, {ExportUse::ColorPrint, "3mf"}, {ExportUse::Game, "glb"}}};

inline constexpr int minExportTriangles = 4, maxExportTriangles = 100'000'000;

/// How a model is exported for another program.
struct ExportSettings
{
    ExportUse use = ExportUse::Print;
    quint64 maxTriangles = 0; ///< largest number of triangles; 0: no limit
    bool slices = false;      ///< tries slicing models for print with an installed slicer
    bool joinsParts = true;   ///< unites overlapping parts in files for print

    bool operator==(const ExportSettings&) const = default;
};
} // namespace ui
