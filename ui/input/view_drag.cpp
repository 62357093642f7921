#include "ui/input/view_drag.h"

#include <span>

namespace ui
{
Drag viewDrag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const InputPreferences& preferences)
{
    struct Row
    {
        Qt::MouseButton button;
        Qt::KeyboardModifier held;
        Drag drag;
    };
    static constexpr Row usual[] = {
        {Qt::LeftButton, Qt::AltModifier, Drag::Orbit},      {Qt::MiddleButton, Qt::AltModifier, Drag::Pan},
        {Qt::RightButton, Qt::AltModifier, Drag::Zoom},      {Qt::MiddleButton, Qt::ShiftModifier, Drag::Pan},
        {Qt::MiddleButton, Qt::ControlModifier, Drag::Zoom}, {Qt::MiddleButton, Qt::NoModifier, Drag::Orbit},
        {Qt::RightButton, Qt::NoModifier, Drag::Pan},
    };
    static constexpr Row rightOrbits[] = {
        {Qt::RightButton, Qt::AltModifier, Drag::Pan},    {Qt::RightButton, Qt::ControlModifier, Drag::Zoom},
        {Qt::RightButton, Qt::NoModifier, Drag::Orbit},   {Qt::MiddleButton, Qt::AltModifier, Drag::Pan},
        {Qt::MiddleButton, Qt::ShiftModifier, Drag::Pan}, {Qt::MiddleButton, Qt::ControlModifier, Drag::Zoom},
        {Qt::MiddleButton, Qt::NoModifier, Drag::Orbit},
    };
    if (!preferences.altMovesView)
        modifiers &= ~Qt::KeyboardModifiers(Qt::AltModifier);
    for (const Row& row :
         preferences.modifiers.rightOrbits ? std::span<const Row>(rightOrbits) : std::span<const Row>(usual))
        if (row.button == button && (row.held == Qt::NoModifier || (modifiers & row.held)))
            return row.drag;
    return Drag::None;
}

Drag dragBesideModel(Qt::KeyboardModifiers modifiers, const InputPreferences& preferences)
{
    const bool pans = preferences.modifiers.rightOrbits && preferences.altMovesView && (modifiers & Qt::AltModifier);
    return pans ? Drag::Pan : Drag::Orbit;
}
} // namespace ui
