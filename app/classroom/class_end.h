#pragma once

#include <QObject>

#include <functional>

class QWidget;

namespace app
{
class ClassWork;

/// The end of a class: what waits is delivered once more, and the teacher hears of what cannot be. Thread: gui.
class ClassEnd : public QObject
{
    Q_OBJECT

public:
    /// Owns neither; both must outlive this, except that the window may be in its destructor by then.
    ClassEnd(ClassWork* work, QWidget* window) : m_work(work), m_window(window) {}

    /// Returns the question before, with what waits by now. `isTurn`: somebody's work is open.
    QString question(bool isTurn) const;
    /// Calls `end` when all works are in the class's folder, or the teacher knows of those that are not; of a folder
    /// that does not answer after 10 s. After the PIN.
    void end(const std::function<void()>& end);

private:
    void say(const std::function<void()>& end);

    ClassWork* m_work;
    QWidget* m_window;
    bool m_isDelivering = false;
};
} // namespace app
