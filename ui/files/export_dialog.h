#pragma once

#include "ui/settings/export_settings.h"
#include "ui/settings/model_info.h"

#include <functional>

class QWidget;

namespace ui
{
class Settings;

/// Asks for the purpose of an export and the number of triangles; the last choice is stored in the settings. Slicing is
/// offered only for prints, and only if a slicer is installed. Returns at once; `callback` is called only if the user
/// accepts.
void askForExportChoice(QWidget* parent, const ModelInfo& modelInfo, Settings* settings,
                        const std::function<void(const ExportSettings&)>& callback);
} // namespace ui
