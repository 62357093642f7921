#pragma once

#include <QKeySequenceEdit>

namespace ui
{
/// Field for entering one key with modifiers, where keys of the number pad count as such. Emits entered() but does not
/// show the key before setKey(). Backspace and Delete mean no key. Tab and Escape work as usual: next field, close.
/// Thread: gui.
class ShortcutEdit : public QKeySequenceEdit
{
    Q_OBJECT

public:
    explicit ShortcutEdit(QWidget* parent = nullptr);

    void setKey(const QKeySequence& key);

Q_SIGNALS:
    /// The user pressed a key, possibly a modifier alone. Empty: the shortcut is to be removed.
    void entered(const QKeySequence& key);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
};
} // namespace ui
