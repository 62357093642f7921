#pragma once

#include <QDateTime>
#include <QToolBar>

class QMainWindow;

namespace ui
{
/// What was not saved when the program ended, and may be had again.
struct Unsaved
{
    QString name;
    QDateTime changed;
    int steps = 0;
};

/// Offers a model that was not saved, under the window's tool bar, while work goes on. It stays until somebody chooses. Gui thread.
class RecoveryBar : public QToolBar
{
    Q_OBJECT

public:
    /// Shows itself in the window.
    RecoveryBar(const Unsaved& unsaved, QMainWindow* window);

    /// It is of no use any more: it hides, and deletes itself.
    void leave();

Q_SIGNALS:
    void recoverRequested();
    /// After a question.
    void discardRequested();

private:
    void addButton(const char* name, const QString& text, const QString& tip, void (RecoveryBar::*what)());
    void askToDiscard();

    QString m_name;
};
} // namespace ui
