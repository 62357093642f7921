#pragma once

#include <QToolBar>

class QLabel;
class QMainWindow;
class QPushButton;

namespace ui
{
/// Gives it room in the bar. Return presses it, as Space does.
QPushButton* addButton(QToolBar* bar, QPushButton* button);

/// A sentence and a few buttons over the top of the view, which does not move for it, while work goes on: a question
/// that waits. It stays until somebody chooses, or whoever made it takes it away. Thread: gui.
class MessageBar : public QToolBar
{
    Q_OBJECT

public:
    /// Hides the bar and deletes it.
    void dismiss();

    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    /// Shows itself in the window.
    MessageBar(const char* name, const QString& title, QMainWindow* window);

    /// `tip`: what the sentence had no room for.
    void setMessage(const char* name, const QString& sentence, const QString& tip);
    QPushButton* addButton(const char* name, const QString& text, const QString& tip);
    /// As much of it as there is room for.
    QString shortened(const QString& fileName) const;

private:
    QWidget* view() const;
    void place();
};
} // namespace ui
