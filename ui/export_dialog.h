#pragma once

#include "model_facts.h"

#include <functional>

class QWidget;

namespace ui
{
/// How a model leaves for another program.
struct ExportChoice
{
    QString ending;            ///< of the format
    quint64 mostTriangles = 0; ///< 0: all
    bool slices = false;       ///< and then an installed slicer slices it to try
};

/// What it is for, and with how many triangles. Returns at once; the answer is called when the person agreed, and never else.
void askForExportChoice(QWidget* parent, const ModelFacts& facts, const std::function<void(const ExportChoice&)>& answer);
} // namespace ui
