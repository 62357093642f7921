#pragma once

namespace ui
{
class Actions;
class Viewport;

/// Connects the actions of the View menu that move the view.
void connectView(const Actions& actions, Viewport* viewport);
} // namespace ui
