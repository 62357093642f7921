#pragma once

#include "ui/settings/view_appearance.h"

#include <QtGlobal>

namespace ui
{
enum class ExportUse { Print, ColorPrint, Game };

/// The keys are the endings of the formats.
inline constexpr std::array<Named<ExportUse>, 3> exportUses{
    {{ExportUse::Print, "stl"}, {ExportUse::ColorPrint, "3mf"}, {ExportUse::Game, "glb"}}};

inline constexpr int minExportTriangles = 4, maxExportTriangles = 100'000'000;

/// How a model is exported for another program.
struct ExportSettings
{
    ExportUse use = ExportUse::Print;
    quint64 maxTriangles = 0; ///< 0: all
    bool slices = false;      ///< what is for print is tried by an installed slicer

    bool operator==(const ExportSettings&) const = default;
};
} // namespace ui
