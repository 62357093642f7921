#pragma once

#include <QDeadlineTimer>
#include <QObject>
#include <QPointer>

#include <functional>

class QDialog;
class QWidget;

namespace ui
{
/// Asks for the class PIN before an action. After three wrong PINs, further attempts are refused for a time that grows
/// with each error, so that nobody can try all PINs. Thread: gui.
class PinPrompt : public QObject
{
    Q_OBJECT

public:
    using IsPin = std::function<bool(const QString& text)>;
    PinPrompt(IsPin isPin, QWidget* window);

    /// Opens the dialog and returns at once; `proceed` is called after the right PIN. Ignored while the dialog is open.
    void ask(const QString& why, const std::function<void()>& proceed);

    /// Returns true if the PIN is right; always false during a lockout.
    bool isRight(const QString& pin);
    /// Returns the seconds until the lockout ends; 0: no lockout.
    int lockoutSeconds() const;

private:
    IsPin m_isPin;
    QWidget* m_window;
    QPointer<QDialog> m_dialog;
    int m_wrong = 0; ///< consecutive wrong PINs
    QDeadlineTimer m_lockout{0};
};
} // namespace ui
