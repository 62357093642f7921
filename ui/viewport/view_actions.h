#pragma once

namespace ui
{
class Actions;
class Viewport;

/// The View menu's actions move the view.
void connectView(const Actions& actions, Viewport* viewport);
} // namespace ui
