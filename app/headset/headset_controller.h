#pragma once

#include "app/headset/headset_files.h"
#include "app/headset/headset_port.h"
#include "app/headset/headset_requests.h"
#include "app/headset/partner_view.h"

#include <QObject>

#include <memory>
#include <optional>

namespace ui
{
class ColorPanel;
}

namespace app
{
/// The gui thread's part of visits to the headset. Sends the state of document and brush, and receives the user's
/// position. Thread: gui.
class HeadsetController : public QObject
{
    Q_OBJECT

public:
    struct Program
    {
        Document* document;
        SculptWorker* worker;
        ui::MainWindow* window;
    };

    /// Owns none of the arguments. Document and worker must outlive the controller; the window may be closing.
    explicit HeadsetController(const Program& program, QObject* parent = nullptr);
    /// Ends the visit's port. Requests that are not done are dropped.
    ~HeadsetController() override;

    /// Begins a visit and returns its port, with the present model.
    std::shared_ptr<HeadsetPort> open();
    /// Called when the headset's thread has ended or was abandoned. Earlier strokes and requests are still carried out.
    void close();
    PartnerView& partner() { return m_partner; }

public Q_SLOTS:
    /// Shows one sentence in the headset.
    void showNotice(const QString& sentence);

Q_SIGNALS:
    /// Emitted with one sentence about the result of a request, for the desktop user.
    void noticed(const QString& sentence);
    /// Emitted when the headset user has moved; nullopt: the user has left.
    void avatarChanged(const std::optional<vr::AvatarState>& avatar);

private:
    void connectDocument();
    void connectParts();
    void takeMessages();
    void onBrushChanged();
    void updateFolder();
    void onBusyChanged();
    void scheduleUpdate();
    void sendUpdate();

    Document* m_document;
    SculptWorker* m_worker;
    ui::MainWindow* m_window;
    ui::ColorPanel* m_colors;
    std::shared_ptr<HeadsetPort> m_port; ///< port of the present visit; null: no visit
    vr::DocumentUpdate m_update;         ///< members of the next update that only this class stores, such as the notice
    bool m_isUpdateScheduled = false;
    PartnerView m_partner;
    HeadsetRequests m_requests;
    HeadsetFiles m_files; ///< last member: its destructor waits for jobs that use the other members
};
} // namespace app
