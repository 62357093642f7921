#include "ui/widgets/message_bar.h"

#include "ui/widgets/spacing.h"

#include <QAction>
#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>

namespace ui
{
namespace
{
constexpr int maxNameWidth = 240;
} // namespace

MessageBar::MessageBar(const char* name, const QString& title, QMainWindow* window) : QToolBar(title, window)
{
    setObjectName(QLatin1StringView(name));
    setMovable(false);
    toggleViewAction()->setVisible(false); // it is not one of those that a person hides and shows
    setContextMenuPolicy(Qt::PreventContextMenu);
    window->addToolBarBreak();
    window->addToolBar(this);
}

void MessageBar::setMessage(const char* name, const QString& sentence, const QString& tip)
{
    auto* words = new QLabel(sentence);
    words->setObjectName(QLatin1StringView(name));
    words->setTextFormat(Qt::PlainText);
    words->setToolTip(tip);
    words->setContentsMargins(gap, 0, gap, 0);
    words->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(words);
}

/// Return presses it, as Space does.
QPushButton* MessageBar::addButton(const char* name, const QString& text, const QString& tip)
{
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1StringView(name));
    button->setAccessibleName(QString(text).remove(QLatin1Char('&')));
    button->setToolTip(tip);
    button->setAutoDefault(true);
    auto* cell = new QWidget;
    auto* row = new QHBoxLayout(cell);
    row->setContentsMargins(0, gap / 2, gap, gap / 2);
    row->addWidget(button);
    addWidget(cell);
    return button;
}

QString MessageBar::shortened(const QString& fileName) const
{
    return fontMetrics().elidedText(fileName, Qt::ElideMiddle, maxNameWidth);
}

void MessageBar::dismiss()
{
    const auto* window = qobject_cast<QMainWindow*>(parentWidget());
    if (isAncestorOf(QApplication::focusWidget()) && window->centralWidget())
        window->centralWidget()->setFocus();
    hide();
    deleteLater();
}
} // namespace ui
