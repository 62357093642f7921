#pragma once

#include <QDialog>

class QLineEdit;

namespace ui
{
class Actions;
class CommandList;

/// Every action of the window with its key, by menu: a sheet to read (F1) and a box to find one by any of its words and
/// do it (F3). Return or a double click does what is marked; what cannot be done now is grey. Gui thread.
class CommandBox : public QDialog
{
    Q_OBJECT

public:
    /// The actions must outlive it.
    explicit CommandBox(const Actions& actions, QWidget* parent);

protected:
    /// The keys that move through the list do so while words are typed.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void go();
    void step(int by);

    QLineEdit* m_words;
    CommandList* m_list;
};
} // namespace ui
