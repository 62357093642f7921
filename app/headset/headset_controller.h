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
/// The gui thread's side of visits to the headset: sends the state of document and brush, and receives where the user
/// is. Thread: gui.
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

    /// None is owned. Document and worker must outlive the controller; the window may be about to close.
    explicit HeadsetController(const Program& program, QObject* parent = nullptr);
    /// As close().
    ~HeadsetController() override;

    /// A visit begins: its document, with the model as it is.
    std::shared_ptr<HeadsetPort> open();
    /// The headset's thread has ended, or is abandoned. Strokes and requests made before are still done.
    void close();
    PartnerView& partner() { return m_partner; }

public Q_SLOTS:
    /// Shows one sentence in the headset.
    void showNotice(const QString& sentence);

Q_SIGNALS:
    /// One sentence about what a request came to, for those at the window.
    void noticed(const QString& sentence);
    /// The user in the headset moved; none: gone.
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
    std::shared_ptr<HeadsetPort> m_port; ///< of the visit; null: there is none
    vr::DocumentUpdate m_update;         ///< the part that is not found elsewhere
    bool m_isUpdateScheduled = false;
    PartnerView m_partner;
    HeadsetRequests m_requests;
    HeadsetFiles m_files; ///< last
};
} // namespace app
