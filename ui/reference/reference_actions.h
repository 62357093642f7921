#pragma once

#include <QString>

#include <functional>

class QMainWindow;

namespace ui
{
class Actions;
class ModelFiles;
class Settings;
class SideColumn;
class Viewport;

struct ReferenceContext
{
    QMainWindow* window;
    SideColumn* column;
    Viewport* viewport;
    ModelFiles* files; ///< says what is dropped
};

/// Reference images behind the model: the commands, the panel, which is hidden until an image is chosen, and what
/// the settings remember, which is read now. None is owned. `notice` says a small word.
void addReferences(const ReferenceContext& context, Settings* settings, const Actions& actions,
                   const std::function<void(const QString&)>& notice);
} // namespace ui
