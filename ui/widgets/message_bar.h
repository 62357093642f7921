#pragma once

#include <QFrame>

class QBoxLayout;
class QLabel;
class QMainWindow;
class QPushButton;

namespace ui
{
/// A sentence and a few buttons over the top of the view, which does not move for it, while work goes on: a question
/// that waits. Where the view is too narrow for one line, the buttons stand below the sentence, which wraps. It stays
/// until somebody chooses, or whoever made it takes it away. Thread: gui.
class MessageBar : public QFrame
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
    /// Adds a control left of the buttons, right of those that came before.
    void addControl(QWidget* control);
    /// Return presses the button, as Space does.
    QPushButton* addButton(const char* name, const QString& text, const QString& tip);
    /// As much of it as there is room for.
    QString shortened(const QString& fileName) const;

private:
    QWidget* view() const;
    int lineWidth() const;
    void place();

    QBoxLayout *m_rows, *m_controls, *m_buttons;
    QLabel* m_words = nullptr;
};
} // namespace ui
