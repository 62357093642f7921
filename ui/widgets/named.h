#pragma once

#include <QString>

namespace ui
{
/// Sets a new widget's object name, tool tip, and accessible name (needed if the widget has no text). Returns the
/// widget.
template <class W> W* named(W* widget, QAnyStringView name, const QString& tip = {}, const QString& accessibleName = {})
{
    widget->setObjectName(name);
    widget->setToolTip(tip);
    widget->setAccessibleName(accessibleName);
    return widget;
}
} // namespace ui
