#pragma once

#include <QStringList>

namespace ui
{
/// Returns other names that users may search for instead of the command's own, such as "mirror" for symmetry, in the
/// language of the window.
/// `id`: action id. The list is empty if the action has no synonyms.
QStringList synonymsOf(QStringView id);
} // namespace ui
