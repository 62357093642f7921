#include "app/document/document_queue.h"

#include "app/worker/sculpt_worker.h"

#include <utility>

namespace app
{
DocumentQueue::DocumentQueue(SculptWorker* worker) : m_worker(worker)
{
    connect(worker, &SculptWorker::confirmed, this, &DocumentQueue::onConfirmed);
}

void DocumentQueue::enqueue(std::function<void()> run)
{
    (m_isStrokeOpen ? m_afterStroke : m_requests).push_back({true, std::move(run)});
    this->run();
}

void DocumentQueue::enqueueStroke(std::function<void()> run)
{
    m_requests.push_back({false, std::move(run)});
    this->run();
}

void DocumentQueue::endStroke()
{
    m_isStrokeOpen = false;
    std::move(m_afterStroke.begin(), m_afterStroke.end(), std::back_inserter(m_requests));
    m_afterStroke.clear();
    run();
}

void DocumentQueue::run()
{
    const auto mustWait = [this](const Request& request) {
        return request.waitsForReports && (hasUnreported() || m_pause != Pause::None);
    };
    while (!m_requests.empty() && !mustWait(m_requests.front())) {
        const auto run = std::move(m_requests.front().run);
        m_requests.pop_front();
        run();
    }
}

bool DocumentQueue::hold(std::function<void()> retry)
{
    if (m_worker->strokes().hold())
        return true;
    enqueue(std::move(retry));
    return false;
}

void DocumentQueue::whenRecorded(std::function<void()> done)
{
    m_unconfirmed.push_back(std::move(done));
    m_worker->confirm();
}

void DocumentQueue::move(const std::function<void()>& move, std::function<void()> done)
{
    ++m_moves;
    move();
    whenRecorded([this, done = std::move(done)] {
        --m_moves;
        done();
    });
}

void DocumentQueue::onConfirmed()
{
    const auto done = std::move(m_unconfirmed.front());
    m_unconfirmed.pop_front();
    done();
}

bool DocumentQueue::hasUnreported() const
{
    return m_reported < m_worker->strokes().begun();
}

bool DocumentQueue::isSettled() const
{
    return !m_isStrokeOpen && m_requests.empty() && !hasUnreported() && m_pause != Pause::Changing && m_moves == 0;
}
} // namespace app
