#include "panel_button.h"

#include "themed_icon.h"

#include <QToolButton>

namespace ui
{
QToolButton* panelButton(const QString& name, const QString& icon, const QString& text, const QString& tip)
{
    auto* result = new QToolButton;
    result->setObjectName(name);
    result->setIcon(themedIcon(icon));
    result->setIconSize({18, 18});
    result->setAutoRaise(true);
    result->setFocusPolicy(Qt::StrongFocus);
    result->setAccessibleName(text);
    result->setToolTip(QStringLiteral("%1\n%2").arg(text, tip));
    return result;
}
} // namespace ui
