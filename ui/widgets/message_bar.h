#pragma once

#include <QFrame>

class QBoxLayout;
class QLabel;
class QMainWindow;
class QPushButton;

namespace ui
{
/// A sentence and buttons over the top of the view, which does not move. Asks a question while work goes on. If the
/// view is too narrow for one line, the sentence wraps and the buttons are below it. Stays until a button is pressed or
/// dismiss() is called. Thread: gui.
class MessageBar : public QFrame
{
    Q_OBJECT

public:
    /// Hides the bar and deletes it.
    void dismiss();

    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    /// Creates the bar and shows it in the window.
    MessageBar(const char* name, const QString& title, QMainWindow* window);

    /// Sets the sentence. `tip`: tool tip with further details.
    void setMessage(const char* name, const QString& sentence, const QString& tip);
    /// Adds a control to the left of the buttons and to the right of earlier controls.
    void addControl(QWidget* control);
    /// Adds a button, which Return presses as Space does.
    QPushButton* addButton(const char* name, const QString& text, const QString& tip);
    /// Returns the file name, shortened in the middle if it is too long for the bar.
    QString shortened(const QString& fileName) const;

private:
    QWidget* view() const;
    int lineWidth() const;
    void place();

    QBoxLayout *m_rows, *m_controls, *m_buttons;
    QLabel* m_words = nullptr;
};
} // namespace ui
