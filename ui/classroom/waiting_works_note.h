#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace ui
{
/// A note that works of classes are still on this computer only, with a button that moves them. Hidden if there are
/// none. Thread: gui.
class WaitingWorksNote : public QWidget
{
    Q_OBJECT

public:
    /// `width`: width at which the sentences wrap, pixels.
    explicit WaitingWorksNote(int width);

    /// Shows the waiting works, one sentence on each line, and below them `outcome`, the result of the last move. No
    /// sentences: hides the button.
    void setWaiting(const QString& sentences, const QString& outcome = {});

Q_SIGNALS:
    void moveRequested(const QString& folder);

private:
    void chooseFolder();

    QLabel *m_waiting, *m_outcome;
    QPushButton* m_move;
};
} // namespace ui
