#pragma once

#include "app/headset/headset_controller.h"

#include "vr/frame/headset_thread.h"

#include <functional>
#include <memory>

namespace app
{
/// Enters the headset with the document that is open, and leaves it, any number of times. Gui thread.
class Headset : public QObject
{
    Q_OBJECT

public:
    /// Who shows the document to a person in the headset, and lets them sculpt.
    using MakeClient = std::function<std::shared_ptr<vr::FrameClient>(const std::shared_ptr<vr::DocumentPort>& port,
                                                                      const vr::HeadsetSettings& choice)>;

    /// See HeadsetDesk.
    Headset(const HeadsetDesk::Program& program, MakeClient makeClient, QObject* parent = nullptr);

    /// Both return at once; reported() tells how it goes. Nothing happens where that is so already; that a visit is
    /// stuck is told.
    void enter();
    void leave();
    /// One sentence, to be read in the headset; nowhere if nobody wears it.
    void tell(const QString& sentence) { m_desk.tellNotice(sentence); }
    /// As HeadsetDesk's.
    void point(const std::optional<core::SurfaceHit>& place) { m_desk.point(place); }
    void setTakenOver(bool isTakenOver) { m_desk.setTakenOver(isTakenOver); }
    /// A visit has begun, and was neither ended nor given up.
    bool isIn() const { return m_thread.isActive(); }
    /// One was given up, and hinders others.
    bool isStuck() const { return m_thread.isStuck(); }

Q_SIGNALS:
    void reported(const vr::HeadsetReport& report);
    /// leave() has begun; the end may take its time.
    void leaving();
    /// As HeadsetDesk's.
    void noticed(const QString& sentence);
    void seen(const std::optional<vr::AvatarState>& presence);

private:
    void take(const vr::HeadsetReport& report);

    MakeClient m_makeClient;
    HeadsetDesk m_desk;
    vr::HeadsetThread m_thread; ///< last: its visits use the desk's documents
};
} // namespace app
