#include "view_drag.h"

namespace ui
{
Drag viewDrag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const HandHabits& habits)
{
    struct Row
    {
        Qt::MouseButton button;
        Qt::KeyboardModifier held;
        Drag drag;
    };
    static constexpr Row table[] = {
        {Qt::LeftButton, Qt::AltModifier, Drag::Orbit},      {Qt::MiddleButton, Qt::AltModifier, Drag::Pan},
        {Qt::RightButton, Qt::AltModifier, Drag::Zoom},      {Qt::MiddleButton, Qt::ShiftModifier, Drag::Pan},
        {Qt::MiddleButton, Qt::ControlModifier, Drag::Zoom}, {Qt::MiddleButton, Qt::NoModifier, Drag::Orbit},
        {Qt::RightButton, Qt::NoModifier, Drag::Pan},
    };
    if (!habits.altMovesView)
        modifiers &= ~Qt::KeyboardModifiers(Qt::AltModifier);
    for (const Row& row : table)
        if (row.button == button && (row.held == Qt::NoModifier || (modifiers & row.held)))
            return row.drag;
    return Drag::None;
}
} // namespace ui
