#pragma once

#include <QObject>

#include <functional>

class QWidget;

namespace app
{
class ClassWork;

/// Ends a class: tries once more to deliver undelivered works to the class's folder, and tells the teacher which ones
/// failed. Thread: gui.
class ClassEnd : public QObject
{
    Q_OBJECT

public:
    /// Owns neither object; both must outlive this, but the window may already be in its destructor.
    ClassEnd(ClassWork* work, QWidget* window) : m_work(work), m_window(window) {}

    /// Returns the question whether to end the class, with the number of undelivered works. `isTurn`: a pupil's work is
    /// open.
    QString question(bool isTurn) const;
    /// Calls `end` when all works are in the class's folder, or the teacher has seen which are not. A folder that does
    /// not answer within 10 s counts as unreachable. Precondition: the PIN was entered.
    void end(const std::function<void()>& end);

private:
    void say(const std::function<void()>& end);

    ClassWork* m_work;
    QWidget* m_window;
    bool m_isDelivering = false;
};
} // namespace app
