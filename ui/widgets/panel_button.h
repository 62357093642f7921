#pragma once

#include <QString>

class QAction;
class QToolButton;

namespace ui
{
/// A small button of a panel: icon only, in the panel's tab order. `tip`: what it does, one sentence.
QToolButton* panelButton(const QString& name, const QString& icon, const QString& text, const QString& tip);
/// The same for a command of the table.
QToolButton* panelButton(QAction* action);
} // namespace ui
