#include "app/headset/headset_port.h"

#include "core/operations/transform_region.h"
#include "core/sculpt/sculptor.h"

#include <utility>

namespace app
{
namespace
{
/// Returns whether the shortfall is felt as haptics. TooClose is not, because a pull may begin too close to the surface
/// to add a ball, and then pulls at its first contact.
bool isRefusal(core::Shortfall shortfall)
{
    return shortfall != core::Shortfall::None && shortfall != core::Shortfall::TooClose;
}

template <class... Kinds> bool isOneOf(const vr::DocumentRequest& request)
{
    return (std::holds_alternative<Kinds>(request) || ...);
}
} // namespace

HeadsetPort::HeadsetPort(SculptWorker* worker) : m_worker(worker) {}

// --- functions for the gui thread

/// Connects the worker's signals, which are emitted on the mesh thread. `self` keeps this alive, because signals may
/// arrive while the visit ends.
void HeadsetPort::begin()
{
    const auto self = shared_from_this();
    m_queryConnection = connect(
        m_worker, &SculptWorker::answeredHeadset, m_worker,
        [self](const auto& hit, const auto& footprint) {
            std::optional<vr::SurfaceQueryResult> next = vr::SurfaceQueryResult{hit, footprint};
            const std::lock_guard lock(self->m_mutex);
            std::swap(self->m_queryResult, next);
        },
        Qt::DirectConnection);
    m_sampleConnection = connect(
        m_worker, &SculptWorker::sampledHeadset, m_worker,
        [self](quint64 fusions, core::Shortfall shortfall) {
            const std::lock_guard lock(self->m_mutex);
            self->m_effect.fusions += static_cast<int>(fusions);
            self->m_effect.refusals += isRefusal(shortfall);
        },
        Qt::DirectConnection);
    m_worker->setInbox(Source::Headset, m_inbox);
}

void HeadsetPort::end()
{
    const auto self = shared_from_this(); // the connections may hold the last references to this
    m_worker->setInbox(Source::Headset, nullptr);
    disconnect(m_queryConnection);
    disconnect(m_sampleConnection);
    const std::lock_guard lock(m_mutex);
    m_hasEnded = true;
    endOpenStroke();
    postHeld();
}

void HeadsetPort::setUpdate(vr::DocumentUpdate update)
{
    std::optional<vr::DocumentUpdate> next = std::move(update);
    const std::lock_guard lock(m_mutex);
    std::swap(m_update, next); // an outdated update is freed after the lock is released
}

HeadsetMessages HeadsetPort::takeMessages()
{
    const std::lock_guard lock(m_mutex);
    m_isNotified = false;
    return std::exchange(m_messages, {});
}

void HeadsetPort::requestDone()
{
    const std::lock_guard lock(m_mutex);
    ++m_done;
    postHeld();
}

bool HeadsetPort::holdsStrokes(const vr::DocumentRequest& request)
{
    return !isOneOf<vr::ChooseBrush, vr::HeadsetSettings, vr::LessonRequest, vr::PreviewInstead, vr::EndPreview>(
        request);
}

void HeadsetPort::setRefusing(bool refuses)
{
    const std::lock_guard lock(m_mutex);
    m_isRefusing = refuses;
}

void HeadsetPort::setTakenOver(bool isTakenOver)
{
    const std::lock_guard lock(m_mutex);
    m_isTakenOver = isTakenOver;
    if (!isTakenOver || m_open == Stroke::None)
        return;
    ++m_effect.refusals;
    endOpenStroke();
}

// --- patches, updates, queries and requests

std::optional<core::MeshPatch> HeadsetPort::takePatch()
{
    return m_inbox->take();
}

std::optional<vr::DocumentUpdate> HeadsetPort::takeUpdate()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_update, std::nullopt);
}

void HeadsetPort::querySurface(const vr::SurfaceQuery& query)
{
    const bool isOfRay = query.brush.brush == core::BrushShape::Ray; // a ray hits the same point whatever the brush
    const std::lock_guard lock(m_mutex);
    if (m_hasEnded)
        return;
    m_worker->ask(Source::Headset, query.ray,
                  isOfRay && !query.wantsFootprint ? std::nullopt : std::optional(query.brush));
}

std::optional<vr::SurfaceQueryResult> HeadsetPort::takeQueryResult()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_queryResult, std::nullopt);
}

void HeadsetPort::queryPart()
{
    const std::lock_guard lock(m_mutex);
    if (m_hasEnded)
        return;
    m_worker->post([self = shared_from_this()](core::Sculptor& sculptor) {
        core::TransformRegion region = core::transformRegionOf(sculptor.mesh(), sculptor.activePart());
        std::optional<vr::MovablePart> next = vr::MovablePart{region.centre, std::move(region.vertices)};
        const std::lock_guard own(self->m_mutex);
        std::swap(self->m_movablePart, next);
    });
}

std::optional<vr::MovablePart> HeadsetPort::takePart()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_movablePart, std::nullopt);
}

bool HeadsetPort::isSettled()
{
    const std::lock_guard lock(m_mutex);
    return m_done >= m_requested;
}

void HeadsetPort::request(const vr::DocumentRequest& request)
{
    send([&] {
        m_messages.requests.push_back(request);
        m_requested += holdsStrokes(request);
    });
}

void HeadsetPort::show(const vr::AvatarState& avatar)
{
    send([&] { m_messages.avatar = avatar; });
}

/// Calls `write` to add to the messages, and notifies the gui thread once.
void HeadsetPort::send(const std::function<void()>& write)
{
    bool isNew = false;
    {
        const std::lock_guard lock(m_mutex);
        if (m_hasEnded)
            return;
        write();
        isNew = !std::exchange(m_isNotified, true);
    }
    if (isNew)
        Q_EMIT messagesArrived();
}

// --- strokes

bool HeadsetPort::beginStroke(const core::StrokeSettings& settings)
{
    const std::lock_guard lock(m_mutex);
    if (m_isRefusing || m_isTakenOver || m_hasEnded) {
        ++m_effect.refusals;
        m_messages.wasRefused |= m_isTakenOver; // the gui thread takes it together with the next avatar message
        return false;
    }
    if (m_done < m_requested) {
        m_held.push_back({m_requested, settings, {}});
        m_open = Stroke::Held;
        return true;
    }
    const bool isMine = m_worker->strokes().beginStroke(Source::Headset, settings);
    m_effect.refusals += !isMine;
    m_open = isMine ? Stroke::Posted : Stroke::None;
    return isMine;
}

void HeadsetPort::addSample(const core::StrokeSample& sample)
{
    const std::lock_guard lock(m_mutex);
    if (m_open == Stroke::Posted)
        m_worker->strokes().addSample(Source::Headset, sample);
    else if (m_open == Stroke::Held) {
        m_held.back().samples.push_back(sample);
        thin(m_held.back().samples);
    }
}

void HeadsetPort::endStroke()
{
    const std::lock_guard lock(m_mutex);
    endOpenStroke();
}

vr::StrokeEffect HeadsetPort::takeEffect()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_effect, {});
}

void HeadsetPort::endOpenStroke()
{
    if (m_open == Stroke::Posted)
        m_worker->strokes().endStroke(Source::Headset);
    else if (m_open == Stroke::Held)
        m_held.back().hasEnded = true;
    m_open = Stroke::None;
}

/// Posts the strokes whose requests are done. The last one may still be open; its next samples are then posted
/// directly.
void HeadsetPort::postHeld()
{
    for (; !m_held.empty() && m_held.front().after <= m_done; m_held.pop_front())
        post(m_held.front());
}

void HeadsetPort::post(const HeldStroke& stroke)
{
    const bool isMine = !m_isRefusing && m_worker->strokes().beginStroke(Source::Headset, stroke.settings);
    m_effect.refusals += !isMine;
    if (isMine)
        for (const core::StrokeSample& sample : stroke.samples)
            m_worker->strokes().addSample(Source::Headset, sample);
    if (isMine && stroke.hasEnded)
        m_worker->strokes().endStroke(Source::Headset);
    if (!stroke.hasEnded)
        m_open = isMine ? Stroke::Posted : Stroke::None;
}

void HeadsetPort::thin(std::vector<core::StrokeSample>& samples)
{
    const std::size_t count = samples.size();
    if (count <= JobQueue::maxWaitingSamples)
        return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (!isThinnedOut(i, count, i == 0))
            samples[kept++] = samples[i];
    samples.resize(kept);
}
} // namespace app
