#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QProgressBar;
class QToolButton;

namespace ui
{
/// Something long that is going on: what, how far it is, and a button that ends it. Hidden while nothing is.
class ProgressBar : public QWidget
{
    Q_OBJECT

public:
    /// `stop` ends it; enabled while it can be ended. Not owned.
    explicit ProgressBar(QAction* stop, QWidget* parent = nullptr);

    /// How far it is, is not known at first, nor whether it can be ended. While it goes on: it is called otherwise now.
    void begin(const QString& what);
    /// 0 to 1.
    void setProgress(double share);
    void setStoppable(bool canStop);
    void end();

Q_SIGNALS:
    /// Each begin() and end().
    void activeChanged(bool isActive);

private:
    QLabel* m_what;
    QProgressBar* m_progress;
    QToolButton* m_stop;
};
} // namespace ui
