#pragma once

#include <QString>

#include <functional>

class QMainWindow;
class QMenu;

namespace ui
{
class Actions;
class ModelFiles;
class Settings;
class Viewport;

struct ReferenceContext
{
    QMainWindow* window;
    QMenu* toggles; ///< where the docks' entries are
    Viewport* viewport;
    ModelFiles* files; ///< says what is dropped
};

/// Reference images behind the model: the commands, the panel, a dock that is hidden until an image is chosen, and what
/// the settings remember, which is read now. None is owned. `notice` says a small word.
void addReferences(const ReferenceContext& context, Settings* settings, const Actions& actions,
                   const std::function<void(const QString&)>& notice);
} // namespace ui
