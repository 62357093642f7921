#include "app/worker/job_queue.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace app
{
std::int64_t steadyNs()
{
    using namespace std::chrono;
    return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

void JobQueue::push(Job job)
{
    {
        const std::lock_guard lock(m_mutex);
        auto* sample = std::get_if<Sample>(&job);
        if (sample)
            sample->first = std::exchange(m_strokeBegan, false);
        else if (std::holds_alternative<BeginStroke>(job))
            m_strokeBegan = true;
        m_waitingSamples = sample ? m_waitingSamples + 1 : 0;
        m_jobs.push_back(std::move(job));
        if (m_waitingSamples > maxWaitingSamples)
            thinSamples();
    }
    m_wake.notify_one();
}

void JobQueue::thinSamples()
{
    const std::size_t begin = m_jobs.size() - m_waitingSamples;
    std::size_t kept = begin;
    // the sample kept as the last one may be dropped next time, when more have followed
    for (std::size_t i = begin; i < m_jobs.size(); ++i)
        if (!isThinnedOut(i - begin, m_waitingSamples, std::get<Sample>(m_jobs[i]).first))
            std::swap(m_jobs[kept++], m_jobs[i]);
    m_dropped += m_jobs.size() - kept;
    m_jobs.resize(kept);
    m_waitingSamples = kept - begin;
}

void JobQueue::ask(const Question& question)
{
    {
        const std::lock_guard lock(m_mutex);
        m_questions[static_cast<std::size_t>(question.source)] = question;
    }
    m_wake.notify_one();
}

void JobQueue::stop()
{
    {
        const std::lock_guard lock(m_mutex);
        m_stopped = true;
        m_jobs.clear();
        m_waitingSamples = 0;
    }
    m_wake.notify_one();
}

std::optional<Question> JobQueue::popQuestion()
{
    if (m_jobs.empty())
        m_hasAsked = {};
    for (std::size_t i = 0; i < sourceCount; ++i)
        if (m_questions[i] && !std::exchange(m_hasAsked[i], true))
            return std::exchange(m_questions[i], std::nullopt);
    return std::nullopt;
}

std::optional<std::variant<Question, Job>> JobQueue::next()
{
    std::unique_lock lock(m_mutex);
    for (;;) {
        if (m_stopped)
            return std::nullopt;
        if (const auto question = popQuestion())
            return *question;
        if (!m_jobs.empty())
            break;
        m_wake.wait(lock);
    }
    Job job = std::move(m_jobs.front());
    m_jobs.pop_front();
    m_hasAsked = {};
    m_waitingSamples = std::min(m_waitingSamples, m_jobs.size());
    return job;
}

std::array<std::optional<Question>, sourceCount> JobQueue::takeQuestions()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_questions, {});
}

bool JobQueue::hasSample() const
{
    const std::lock_guard lock(m_mutex);
    return !m_jobs.empty() && std::holds_alternative<Sample>(m_jobs.front());
}

std::uint64_t JobQueue::droppedSamples() const
{
    const std::lock_guard lock(m_mutex);
    return m_dropped;
}
} // namespace app
