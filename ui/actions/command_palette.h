#pragma once

#include <QDialog>

class QLineEdit;

namespace ui
{
class Actions;
class CommandList;

/// A dialog that lists every action with its keys, grouped by menu (F1). Typed words filter the list (F3). Return or a
/// double click runs the selected action; disabled actions are grey. Thread: gui.
class CommandPalette : public QDialog
{
    Q_OBJECT

public:
    /// Precondition: `actions` outlives the dialog.
    explicit CommandPalette(const Actions& actions, QWidget* parent);

protected:
    /// Lets Up, Down and Return act on the list while the text field has the focus.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void run();
    void step(int by);

    QLineEdit* m_words;
    CommandList* m_list;
};
} // namespace ui
