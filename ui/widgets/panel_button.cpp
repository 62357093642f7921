#include "ui/widgets/panel_button.h"

#include "ui/widgets/themed_icon.h"

#include <QAction>
#include <QToolButton>

namespace ui
{
namespace
{
QToolButton* smallButton(const QString& name, const QString& text)
{
    auto* result = new QToolButton;
    result->setObjectName(name);
    result->setIconSize({18, 18});
    result->setAutoRaise(true);
    result->setFocusPolicy(Qt::StrongFocus);
    result->setAccessibleName(text);
    return result;
}
} // namespace

QToolButton* panelButton(const QString& name, const QString& icon, const QString& text, const QString& tip)
{
    QToolButton* result = smallButton(name, text);
    result->setIcon(themedIcon(icon));
    result->setToolTip(QStringLiteral("%1\n%2").arg(text, tip));
    return result;
}

QToolButton* panelButton(QAction* action)
{
    QToolButton* result = smallButton(action->objectName() + QStringLiteral("Button"), action->iconText());
    result->setDefaultAction(action);
    return result;
}
} // namespace ui
