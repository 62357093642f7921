#pragma once

#include <QDeadlineTimer>
#include <QObject>
#include <QPointer>

#include <functional>

class QDialog;
class QWidget;

namespace ui
{
/// Asks for a PIN before something is done, in a dialog of our own. After three wrong ones it rests, longer each time,
/// so that nobody tries all. Gui thread.
class PinGate : public QObject
{
    Q_OBJECT

public:
    using IsPin = std::function<bool(const QString& text)>;
    PinGate(IsPin isPin, QWidget* window);

    /// Returns at once; `goOn` is called when the right one was typed. While it asks already, nothing new begins.
    void ask(const QString& why, const std::function<void()>& goOn);

    /// Judges a try. While it rests, none is right.
    bool isRight(const QString& pin);
    /// 0: it takes tries.
    int restSeconds() const;

private:
    IsPin m_isPin;
    QWidget* m_window;
    QPointer<QDialog> m_dialog;
    int m_wrong = 0; ///< in a row
    QDeadlineTimer m_rest{0};
};
} // namespace ui
