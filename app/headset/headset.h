#pragma once

#include "app/headset/headset_controller.h"

#include "vr/frame/headset_thread.h"

#include <functional>
#include <memory>

namespace app
{
/// Lets the user enter the headset with the open document and leave it, any number of times. Thread: gui.
class Headset : public QObject
{
    Q_OBJECT

public:
    /// A callback that makes the client which shows the document in the headset.
    using MakeClient = std::function<std::shared_ptr<vr::FrameClient>(const std::shared_ptr<vr::DocumentPort>& port,
                                                                      const vr::HeadsetSettings& settings)>;

    /// `program`: see HeadsetController.
    Headset(const HeadsetController::Program& program, MakeClient makeClient, QObject* parent = nullptr);

    /// Begins or ends a visit to the headset. Returns at once; reported() gives the result. Has no effect if the visit
    /// is already in that state. If an earlier visit does not respond, that is reported.
    void enter();
    void leave();
    /// Shows one sentence in the headset, if it is in use.
    void showNotice(const QString& sentence) { m_controller.showNotice(sentence); }
    PartnerView& partner() { return m_controller.partner(); }
    /// Returns whether a visit has begun and has neither ended nor been abandoned.
    bool isActive() const { return m_thread.isActive(); }
    /// Returns whether an abandoned visit prevents new ones.
    bool isStuck() const { return m_thread.isStuck(); }

Q_SIGNALS:
    void reported(const vr::HeadsetReport& report);
    /// Emitted when leave() has begun; the visit may take a while to end.
    void leaving();
    /// Same signals as HeadsetController's.
    void noticed(const QString& sentence);
    void avatarChanged(const std::optional<vr::AvatarState>& avatar);

private:
    void onReport(const vr::HeadsetReport& report);

    MakeClient m_makeClient;
    HeadsetController m_controller;
    vr::HeadsetThread m_thread; ///< last member: its destructor ends the visit, which uses the controller's port
};
} // namespace app
