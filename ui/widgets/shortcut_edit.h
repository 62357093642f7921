#pragma once

#include <QKeySequenceEdit>

namespace ui
{
/// Takes one key with what is held, those of the number pad as such, and tells; nothing is shown before setKey().
/// Backspace and Delete take the key away. Tab and Escape move on and close, as everywhere. Thread: gui.
class ShortcutEdit : public QKeySequenceEdit
{
    Q_OBJECT

public:
    explicit ShortcutEdit(QWidget* parent = nullptr);

    void setKey(const QKeySequence& key);

Q_SIGNALS:
    /// Whatever it is, modifiers alone too. Empty: it is to go.
    void entered(const QKeySequence& key);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
};
} // namespace ui
