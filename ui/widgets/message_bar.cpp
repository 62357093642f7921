#include "ui/widgets/message_bar.h"

#include "ui/widgets/named.h"
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

QPushButton* addButton(QToolBar* bar, QPushButton* button)
{
    button->setAutoDefault(true);
    auto* cell = new QWidget;
    auto* row = new QHBoxLayout(cell);
    row->setContentsMargins(0, gap / 2, gap, gap / 2);
    row->addWidget(button);
    bar->addWidget(cell);
    return button;
}

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
    auto* words = named(new QLabel(sentence), name, tip);
    words->setTextFormat(Qt::PlainText);
    words->setContentsMargins(gap, 0, gap, 0);
    words->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(words);
}

QPushButton* MessageBar::addButton(const char* name, const QString& text, const QString& tip)
{
    return ui::addButton(this, named(new QPushButton(text), name, tip, QString(text).remove(QLatin1Char('&'))));
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
