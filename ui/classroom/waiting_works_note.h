#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace ui
{
/// Says that works of classes wait on this computer, and offers to move them. Hidden while there are none. Thread: gui.
class WaitingWorksNote : public QWidget
{
    Q_OBJECT

public:
    /// `width`: of its sentences.
    explicit WaitingWorksNote(int width);

    /// Shows what waits, a sentence a line; nothing waits: hides the button. Below it stands what came of the moving.
    void setWaiting(const QString& sentences, const QString& outcome = {});

Q_SIGNALS:
    void moveRequested(const QString& folder);

private:
    void chooseFolder();

    QLabel *m_waiting, *m_outcome;
    QPushButton* m_move;
};
} // namespace ui
