#pragma once

#include "ui/side_thread.h"

#include <QObject>

namespace app
{
/// Asks for the headset without letting the window wait for a runtime to start. Gui thread.
class HeadsetInquiry : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

public Q_SLOTS:
    /// One inquiry at a time; others are dropped.
    void ask();

Q_SIGNALS:
    void answered(const QString& sentence);

private:
    bool m_isAsking = false;
    ui::SideThread m_aside; ///< last
};
} // namespace app
