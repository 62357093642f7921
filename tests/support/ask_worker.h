#pragma once

#include "app/worker/sculpt_worker.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/waiting.h"
#include "ui/util/thread_mailbox.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QTimer>

#include <cstdint>
#include <optional>
#include <utility>

namespace app
{
/// Returns the answer of `question`, which runs on the mesh thread after all earlier jobs. Processes events while it
/// waits.
template <class Question> auto ask(SculptWorker& worker, const Question& question)
{
    using Answer = decltype(question(std::declval<core::Sculptor&>()));
    std::optional<Answer> answer;
    QEventLoop waiting; // QTRY_VERIFY looks only every 50 ms
    QTimer::singleShot(longestWait, &waiting, &QEventLoop::quit);
    ui::ThreadMailbox mail;
    worker.post([&](core::Sculptor& sculptor) {
        mail.post([&, value = question(sculptor)]() mutable {
            answer = std::move(value);
            waiting.quit();
        });
    });
    waiting.exec();
    [&] { QVERIFY2(answer, "the mesh thread does not answer"); }();
    return answer ? std::move(*answer) : Answer();
}

/// Returns the hash of the surface.
inline std::uint64_t meshHash(SculptWorker& worker)
{
    return ask(worker, [](core::Sculptor& sculptor) { return sculptor.mesh().meshHash(); });
}

/// Returns the hash of the surface, including slot numbers and free lists.
inline std::uint64_t stateHash(SculptWorker& worker)
{
    return ask(worker, [](core::Sculptor& sculptor) { return sculptor.mesh().stateHash(); });
}

/// Waits until neither the mesh thread nor the document has queued work.
inline void settle(SculptWorker& worker)
{
    for (int i = 0; i < 3; ++i) {
        ask(worker, [](core::Sculptor&) { return true; });
        QCoreApplication::processEvents();
    }
}
} // namespace app
