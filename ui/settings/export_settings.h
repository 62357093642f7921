#pragma once

#include "ui/settings/view_appearance.h"

#include <QtGlobal>

namespace ui
{
enum class ExportUse { Print, ColorPrint, Game };

/// The keys are the endings of the formats.
inline constexpr std::array<Named<ExportUse>, 3> exportUses{
    {{ExportUse::Print, "stl"}, {ExportUse::ColorPrint, "3mf"}, {ExportUse::Game, "glb"}}};

inline constexpr int leastExportTriangles = 4, mostExportTriangles = 100'000'000;

/// How a model leaves for another program.
struct ExportChoice
{
    ExportUse use = ExportUse::Print;
    quint64 mostTriangles = 0; ///< 0: all
    bool slices = false;       ///< what is for print is tried by an installed slicer

    bool operator==(const ExportChoice&) const = default;
};
} // namespace ui
