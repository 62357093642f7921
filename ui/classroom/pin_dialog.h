#pragma once

#include <QDeadlineTimer>
#include <QObject>
#include <QPointer>

#include <functional>

class QDialog;
class QWidget;

namespace ui
{
/// Asks for a PIN before something is done, in a dialog of our own. After three wrong ones it refuses more for a while,
/// longer each time, so that nobody can try all. Thread: gui.
class PinPrompt : public QObject
{
    Q_OBJECT

public:
    using IsPin = std::function<bool(const QString& text)>;
    PinPrompt(IsPin isPin, QWidget* window);

    /// Returns at once; `proceed` is called when the right one was typed. While it asks already, nothing new begins.
    void ask(const QString& why, const std::function<void()>& proceed);

    /// Whether that is the PIN. False during a lockout.
    bool isRight(const QString& pin);
    /// Seconds until the lockout ends; 0: there is none.
    int lockoutSeconds() const;

private:
    IsPin m_isPin;
    QWidget* m_window;
    QPointer<QDialog> m_dialog;
    int m_wrong = 0; ///< in a row
    QDeadlineTimer m_lockout{0};
};
} // namespace ui
