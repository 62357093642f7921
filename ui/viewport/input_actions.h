#pragma once

#include <QString>

#include <functional>

namespace ui
{
class Actions;
class BrushSettings;
class Settings;
class SideColumn;
class Viewport;

struct InputActionsContext
{
    SideColumn* column;
    Viewport* viewport;
    std::function<void(const QString&)> notice; ///< shows a short notice
};

/// Connects the actions for pointer input in the view: brush values by moving the pointer, the steady stroke, adding a
/// ball, the keyboard cursor, and the turntable with its panel. Loads stored values from the settings now, and stores
/// changes there. No argument is owned.
void connectInputActions(const InputActionsContext& context, BrushSettings* brush, Settings* settings,
                         const Actions& actions);
} // namespace ui
