#pragma once

#include "ui/settings/export_settings.h"
#include "ui/settings/model_info.h"

#include <functional>

class QWidget;

namespace ui
{
class Settings;

/// Facts about the document that the export dialog depends on.
struct ExportContext
{
    const ModelInfo& modelInfo;
    Settings* settings;
    /// Calls `answer`, now or later, with whether visible parts of the model overlap.
    std::function<void(const std::function<void(bool doOverlap)>& answer)> askOverlap;
};

/// Asks for the purpose of an export and the number of triangles; the last choice is stored in the settings. Slicing is
/// offered only for prints, and only if a slicer is installed; uniting parts only for prints, and only if parts
/// overlap. Returns at once; `callback` is called only if the user accepts.
void askForExportChoice(QWidget* parent, const ExportContext& context,
                        const std::function<void(const ExportSettings&)>& callback);
} // namespace ui
