#pragma once

#include <QObject>
#include <QString>

namespace ui
{
class Actions;
class Viewport;

/// Changing: on the way in or out.
enum class HeadsetState { Out, Changing, In };

/// The VR menu's commands, as far as they fit the state; the look for a headset is somebody else's. Gui thread.
class HeadsetActions : public QObject
{
    Q_OBJECT

public:
    /// None is owned; actions and viewport must outlive it.
    HeadsetActions(Actions& actions, Viewport* viewport, QObject* parent = nullptr);

    /// Out: the viewport shows nobody.
    void show(HeadsetState state);

Q_SIGNALS:
    void enterRequested();
    void leaveRequested();

private:
    Actions& m_actions;
    Viewport* m_viewport;
    QString m_enterText;
    HeadsetState m_state = HeadsetState::Out;
};
} // namespace ui
