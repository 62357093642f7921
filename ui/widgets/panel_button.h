#pragma once

#include <QString>

class QAction;
class QToolButton;

namespace ui
{
/// Returns a small button of a panel: icon only, in the panel's tab order. `tip`: one sentence about its effect.
QToolButton* panelButton(const QString& name, const QString& icon, const QString& text, const QString& tip);
/// Returns a small button that triggers an action of the action table.
QToolButton* panelButton(QAction* action);
} // namespace ui
