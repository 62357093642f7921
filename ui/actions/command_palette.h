#pragma once

#include <QDialog>

class QLineEdit;

namespace ui
{
class Actions;
class CommandList;

/// Every action of the window with its key, by menu: a list to read (F1), and a command palette to find and run one by
/// any of its words (F3). Return or a double click does what is marked; what cannot be done now is grey. Thread: gui.
class CommandPalette : public QDialog
{
    Q_OBJECT

public:
    /// The actions must outlive it.
    explicit CommandPalette(const Actions& actions, QWidget* parent);

protected:
    /// The keys that move through the list do so while words are typed.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void run();
    void step(int by);

    QLineEdit* m_words;
    CommandList* m_list;
};
} // namespace ui
