#include "app/classroom/class_end.h"

#include "app/classroom/class_work.h"

#include "ui/classroom/waiting_works_dialog.h"

#include <QDir>
#include <QPointer>
#include <QTimer>

#include <chrono>
#include <utility>

namespace app
{
QString ClassEnd::question(bool isTurn) const
{
    const QString ends = isTurn ? tr("End the class? The current pupil's work will be saved.")
                                : tr("End the class? It is nobody's turn, and all work is saved.");
    const int waiting = m_work->undelivered();
    return waiting == 0 ? ends : ends + u' ' + tr("%n models are not yet in the class folder.", nullptr, waiting);
}

/// Delivers in the next iteration of the event loop, because delivery is paused until the last work is saved. The
/// window is disabled meanwhile.
void ClassEnd::end(const std::function<void()>& end)
{
    constexpr auto longest = std::chrono::seconds(10);
    if (std::exchange(m_isDelivering, true))
        return;
    m_window->setEnabled(false);
    const auto goOn = [this, end] {
        if (!std::exchange(m_isDelivering, false))
            return;
        m_window->setEnabled(true);
        if (m_work->undelivered() > 0)
            say(end);
        else
            end();
    };
    QTimer::singleShot(longest, this, goOn); // gives up on a folder that does not answer
    QMetaObject::invokeMethod(
        this, [this, goOn] { m_work->deliver(goOn); }, Qt::QueuedConnection);
}

void ClassEnd::say(const std::function<void()>& end)
{
    auto* dialog =
        new ui::WaitingWorksDialog(m_work->undelivered(), m_work->problem(), m_work->archive().outbox(), m_window);
    connect(dialog, &ui::WaitingWorksDialog::copyRequested, this, [this, dialog = QPointer(dialog)](const QString& to) {
        m_work->copyWaiting(to, [dialog, to](const Delivery& copied) {
            if (dialog)
                dialog->showCopied(copied.problem.isEmpty() ? tr("%n models were copied to %1.", nullptr,
                                                                 static_cast<int>(copied.moved.size()))
                                                                  .arg(QDir::toNativeSeparators(to))
                                                            : copied.problem);
        });
    });
    connect(dialog, &QDialog::finished, this, end);
    dialog->open();
}
} // namespace app
