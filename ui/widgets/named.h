#pragma once

#include <QString>

namespace ui
{
/// Gives a new widget its object name, its tool tip, and an accessible name where it has no text. Returns the
/// widget.
template <class W> W* named(W* widget, QAnyStringView name, const QString& tip = {}, const QString& accessibleName = {})
{
    widget->setObjectName(name);
    widget->setToolTip(tip);
    widget->setAccessibleName(accessibleName);
    return widget;
}
} // namespace ui
