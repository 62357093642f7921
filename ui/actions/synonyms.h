#pragma once

#include <QStringList>

namespace ui
{
/// Returns what people call a command who do not know its name, in the language of the window: "mirror" for symmetry.
/// `id`: of the action table; empty if there is no other word for it.
QStringList synonymsOf(QStringView id);
} // namespace ui
