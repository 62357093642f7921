#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QProgressBar;
class QToolButton;

namespace ui
{
/// Display of a long operation: its name, its progress, and a stop button. Hidden while there is none.
class ProgressBar : public QWidget
{
    Q_OBJECT

public:
    /// `stop`: action that stops the operation, enabled while that is possible. Not owned.
    explicit ProgressBar(QAction* stop, QWidget* parent = nullptr);

    /// Starts displaying an operation; at first without progress and stop button. During an operation, only changes its
    /// name.
    void begin(const QString& what);
    /// Sets the progress, 0 to 1.
    void setProgress(double share);
    void setStoppable(bool canStop);
    void end();

Q_SIGNALS:
    /// begin() or end() was called.
    void activeChanged(bool isActive);

private:
    QLabel* m_what;
    QProgressBar* m_progress;
    QToolButton* m_stop;
};
} // namespace ui
