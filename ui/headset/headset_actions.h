#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>

class QAction;

namespace ui
{
class Actions;
class PartnerBar;
class Viewport;

/// State of the VR session. Changing: entering or leaving.
enum class HeadsetState { Out, Changing, In };

/// The actions of the VR menu, updated to the session's state. They do not look for a headset. Thread: gui.
class HeadsetActions : public QObject
{
    Q_OBJECT

public:
    struct Parts
    {
        Actions* actions;
        Viewport* viewport;
        PartnerBar* bar;
    };

    /// Precondition: the parts, which are not owned, outlive this object.
    explicit HeadsetActions(const Parts& parts, QObject* parent = nullptr);

    /// Updates the actions to the state. Out and Changing: stops pointing and gives back what was taken over. Out: also
    /// hides the person in VR.
    void show(HeadsetState state);

Q_SIGNALS:
    void enterRequested();
    void leaveRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void connectPointing();
    void connectTakeOver();
    QAction* action(const QString& id) const;

    Parts m_parts;
    QElapsedTimer m_sincePointing;
    QString m_enterText, m_takeOverText;
    HeadsetState m_state = HeadsetState::Out;
};
} // namespace ui
