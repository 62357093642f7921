#pragma once

#include "vr/openxr/runtime_thread.h"

#include <QTimer>

namespace app
{
/// Asks for the headset without letting the window wait for a runtime to start, or the program for one that does not
/// answer. Gui thread.
class HeadsetInquiry : public QObject
{
    Q_OBJECT

public:
    explicit HeadsetInquiry(QObject* parent = nullptr);

public Q_SLOTS:
    /// One inquiry at a time; others are dropped, but for a word if it takes long.
    void ask();

Q_SIGNALS:
    /// Once or twice: it takes long, and the answer.
    void answered(const QString& sentence);

private:
    void tellOfSilence();

    std::shared_ptr<QString> m_answer; ///< the thread's until it has ended
    QTimer m_patience;
    vr::RuntimeThread m_aside; ///< last
};
} // namespace app
