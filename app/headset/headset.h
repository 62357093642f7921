#pragma once

#include "app/headset/headset_controller.h"

#include "vr/frame/headset_thread.h"

#include <functional>
#include <memory>

namespace app
{
/// Enters the headset with the document that is open, and leaves it, any number of times. Thread: gui.
class Headset : public QObject
{
    Q_OBJECT

public:
    /// Makes the client that shows the document to the user in the headset.
    using MakeClient = std::function<std::shared_ptr<vr::FrameClient>(const std::shared_ptr<vr::DocumentPort>& port,
                                                                      const vr::HeadsetSettings& settings)>;

    /// See HeadsetController.
    Headset(const HeadsetController::Program& program, MakeClient makeClient, QObject* parent = nullptr);

    /// Both return at once; reported() says how it goes. No effect if that is the state already; a visit that does not
    /// respond is reported.
    void enter();
    void leave();
    /// Shows one sentence in the headset, if it is in use.
    void showNotice(const QString& sentence) { m_controller.showNotice(sentence); }
    PartnerView& partner() { return m_controller.partner(); }
    /// A visit has begun, and was neither ended nor given up.
    bool isActive() const { return m_thread.isActive(); }
    /// One was given up, and hinders others.
    bool isStuck() const { return m_thread.isStuck(); }

Q_SIGNALS:
    void reported(const vr::HeadsetReport& report);
    /// leave() has begun; the end may take its time.
    void leaving();
    /// As HeadsetController's.
    void noticed(const QString& sentence);
    void avatarChanged(const std::optional<vr::AvatarState>& avatar);

private:
    void onReport(const vr::HeadsetReport& report);

    MakeClient m_makeClient;
    HeadsetController m_controller;
    vr::HeadsetThread m_thread; ///< last: its visits use the controller's documents
};
} // namespace app
