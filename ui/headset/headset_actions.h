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

/// Changing: on the way in or out.
enum class HeadsetState { Out, Changing, In };

/// The VR menu's commands, as far as they fit the state; the headset is looked for elsewhere. Thread: gui.
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

    /// None is owned; all must outlive it.
    explicit HeadsetActions(const Parts& parts, QObject* parent = nullptr);

    /// Out: the viewport shows nobody, nobody points, and what was taken over is given back.
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
