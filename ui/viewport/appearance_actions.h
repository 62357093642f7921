#pragma once

class QMenu;

namespace ui
{
class Actions;
class Settings;
class Viewport;

/// Connects the actions for material, background, wireframe, ground, scale bar and so on with the view and the
/// settings. Adds the menus of materials, backgrounds and reference images to `viewMenu`. Viewport, settings and menu
/// must outlive the actions.
void addAppearanceActions(const Actions& actions, Viewport* viewport, Settings* settings, QMenu* viewMenu);
} // namespace ui
