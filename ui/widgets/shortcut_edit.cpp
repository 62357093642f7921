#include "ui/widgets/shortcut_edit.h"

#include <QKeyEvent>
#include <QLineEdit>

namespace ui
{
namespace
{
bool endsEditing(const QKeyEvent& event)
{
    return event.key() == Qt::Key_Tab || event.key() == Qt::Key_Backtab || event.key() == Qt::Key_Escape;
}

/// Returns the key with its modifiers, but without Shift if Shift only selects the character, as for "?".
QKeySequence keyOf(const QKeyEvent& event)
{
    Qt::KeyboardModifiers held = event.modifiers() & ~Qt::KeyboardModifiers(Qt::GroupSwitchModifier);
    const QString text = event.text();
    const bool isSign = !text.isEmpty() && text[0].isPrint() && !text[0].isLetterOrNumber() && !text[0].isSpace();
    if (isSign)
        held &= ~Qt::KeyboardModifiers(Qt::ShiftModifier);
    return QKeySequence(QKeyCombination(held, static_cast<Qt::Key>(event.key())));
}
} // namespace

ShortcutEdit::ShortcutEdit(QWidget* parent) : QKeySequenceEdit(parent)
{
    setKey({});
}

/// Shows a key. Sets the placeholder text each time, because Qt restores its own, which is too long in some languages.
void ShortcutEdit::setKey(const QKeySequence& key)
{
    const QSignalBlocker quiet(this);
    setKeySequence(key);
    findChild<QLineEdit*>()->setPlaceholderText(tr("no key"));
}

/// Handles Tab and Escape as an ordinary widget, because QKeySequenceEdit would record them as keys.
bool ShortcutEdit::event(QEvent* event)
{
    if ((event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) &&
        endsEditing(*static_cast<QKeyEvent*>(event)))
        return QWidget::event(event);
    return QKeySequenceEdit::event(event);
}

void ShortcutEdit::keyPressEvent(QKeyEvent* event)
{
    if (endsEditing(*event))
        return QWidget::keyPressEvent(event);
    const bool clears =
        event->modifiers() == Qt::NoModifier && (event->key() == Qt::Key_Backspace || event->key() == Qt::Key_Delete);
    Q_EMIT entered(clears ? QKeySequence() : keyOf(*event));
}

void ShortcutEdit::keyReleaseEvent(QKeyEvent* event)
{
    event->accept();
}
} // namespace ui
