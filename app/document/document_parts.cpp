#include "app/document/document_parts.h"

#include "app/document/document.h"
#include "app/document/stroke_command.h"
#include "app/model/model_change_job.h"
#include "app/worker/sculpt_worker.h"

#include "core/analysis/part_overlap.h"
#include "core/mesh/mesh_builder.h"
#include "core/parts/part_split.h"
#include "core/sculpt/sculptor.h"

#include <algorithm>
#include <utility>

namespace app
{
namespace
{
std::vector<core::PartId> visibleIn(const core::PartList& list)
{
    std::vector<core::PartId> visible;
    for (const core::Part& part : list.all()) {
        if (part.isVisible)
            visible.push_back(part.id);
    }
    return visible;
}

core::ShowParts everyPart(const core::PartList& list)
{
    core::ShowParts show;
    for (const core::Part& part : list.all())
        show.visible.push_back(part.id);
    return show;
}

core::PartId partOf(const core::FileEntry& entry)
{
    if (const auto* const stroke = std::get_if<core::Stroke>(&entry))
        return stroke->settings.part;
    return std::get<core::FileCommand>(entry).part;
}

/// Returns the part that the step has just added to the list again; nothing if it adds none.
std::optional<core::PartId> addedBy(const core::FileEntry& entry, const core::PartList& list)
{
    const auto* const command = std::get_if<core::FileCommand>(&entry);
    if (!command)
        return std::nullopt;
    if (const auto* const insert = std::get_if<core::Insert>(&command->command);
        insert && insert->combination == core::Insert::Combination::Part)
        return list.all().back().id;
    const auto original = std::ranges::find(list.all(), command->part, &core::Part::id);
    if (std::holds_alternative<core::DuplicatePart>(command->command) && list.all().end() - original > 1)
        return std::next(original)->id;
    return std::nullopt;
}
} // namespace

DocumentParts::DocumentParts(Document* document) : m_document(document)
{
    connect(&document->worker(), &SculptWorker::partsChanged, this, &DocumentParts::setList);
    connect(&document->history(), &DocumentHistory::moved, this, &DocumentParts::followHistory);
    connect(document, &Document::stepped, this, [this] { m_index = m_document->history().stack().index(); });
    connect(document, &Document::opened, this, [this] {
        m_index = m_document->history().stack().index();
        m_shownBefore.clear();
        m_active = m_list.all().front().id; // as SculptWorker::setModel() chooses
        Q_EMIT changed();
    });
}

std::optional<core::Part> DocumentParts::named(const ModelChangeRequest& request) const
{
    const core::Part* part = m_list.find(request.part);
    return part && m_list.size() > 1 && !core::isOnAllParts(request.command) ? std::optional(*part) : std::nullopt;
}

std::optional<core::Part> DocumentParts::switchedBy(const core::ShowParts& command) const
{
    const auto isSwitched = [&](const core::Part& part) {
        return part.isVisible != (std::ranges::count(command.visible, part.id) > 0);
    };
    const auto found = std::ranges::find_if(m_list.all(), isSwitched);
    return std::ranges::count_if(m_list.all(), isSwitched) == 1 ? std::optional(*found) : std::nullopt;
}

void DocumentParts::activate(core::PartId part)
{
    if (part == m_active || !m_list.find(part))
        return;
    m_active = part;
    m_document->worker().activate(part);
    Q_EMIT changed();
}

void DocumentParts::pick(const core::Ray& ray)
{
    m_document->worker().post([this, ray](core::Sculptor& sculptor) {
        if (const auto met = sculptor.visibleHit(ray))
            m_mailbox.post([this, part = met->part] { activate(part); });
    });
}

void DocumentParts::findSurface(
    const std::vector<core::Ray>& rays,
    const std::function<void(const std::vector<std::optional<core::SurfaceHit>>& hits)>& answer)
{
    m_document->worker().post([this, rays, answer](core::Sculptor& sculptor) {
        std::vector<std::optional<core::SurfaceHit>> hits;
        for (const core::Ray& ray : rays) {
            const auto met = sculptor.visibleHit(ray);
            hits.push_back(met ? std::optional(met->hit) : std::nullopt);
        }
        m_mailbox.post([answer, hits = std::move(hits)] { answer(hits); });
    });
}

void DocumentParts::isolate()
{
    const std::vector<core::PartId> visible = visibleIn(m_list);
    if (visible == std::vector{m_active})
        return m_document->changer().apply(m_shownBefore.empty() ? everyPart(m_list)
                                                                 : core::ShowParts{std::exchange(m_shownBefore, {})});
    m_shownBefore = visible;
    m_document->changer().apply(core::ShowParts{{m_active}});
}

void DocumentParts::showAll()
{
    m_document->changer().apply(core::Hide{core::Hide::What::NoPart});
}

void DocumentParts::findRegion()
{
    m_document->worker().post([this, part = m_active](core::Sculptor& sculptor) {
        m_mailbox.post([this, region = core::transformRegionOf(sculptor.mesh(), part)] { Q_EMIT regionFound(region); });
    });
}

void DocumentParts::findOverlap(const std::function<void(bool doOverlap)>& answer)
{
    m_document->worker().post([this, answer](core::Sculptor& sculptor) {
        const core::PartList& list = sculptor.mesh().frame().parts;
        const bool doOverlap =
            list.size() > 1 && core::doPartsOverlap(core::visibleParts(core::extractMesh(sculptor.mesh()), list));
        m_mailbox.post([answer, doOverlap] { answer(doOverlap); });
    });
}

void DocumentParts::setList(const core::PartList& list)
{
    m_list = list;
    if (!list.find(m_active)) {
        m_active = list.all().front().id;
        m_document->worker().activate(m_active);
    }
    Q_EMIT changed();
}

/// Activates the part of the step that was undone or redone last.
void DocumentParts::followHistory()
{
    const QUndoStack& stack = m_document->history().stack();
    const int before = std::exchange(m_index, stack.index());
    const int step = stack.index() < before ? stack.index() : stack.index() - 1;
    if (step < 0 || step >= stack.count() || before == stack.index())
        return;
    const auto& entry = static_cast<const StrokeCommand*>(stack.command(step))->marks().recordedStep;
    if (!entry)
        return;
    const auto added = stack.index() == before + 1 ? addedBy(*entry, m_list) : std::nullopt;
    activate(added.value_or(partOf(*entry)));
}
} // namespace app
