#pragma once

#include "ui/settings/export_settings.h"
#include "ui/settings/model_info.h"

#include <functional>

class QWidget;

namespace ui
{
class Settings;

/// What it is for, and with how many triangles; as last time, which the settings keep. Returns at once; the callback is
/// called when the person agreed, and never else. It slices only where there is a slicer and the file is for print.
void askForExportChoice(QWidget* parent, const ModelInfo& modelInfo, Settings* settings,
                        const std::function<void(const ExportSettings&)>& callback);
} // namespace ui
