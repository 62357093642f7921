#pragma once

class QMenu;

namespace ui
{
class Actions;
class Settings;
class Viewport;

/// What the clay is made of, what stands behind it, edges, ground and scale: actions that change how the view shows the
/// model, two menus of choices in `viewMenu` with that of the reference images below them, and the settings that store
/// the appearance. All three must outlive the actions.
void addAppearanceActions(const Actions& actions, Viewport* viewport, Settings* settings, QMenu* viewMenu);
} // namespace ui
