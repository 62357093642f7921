#pragma once

#include "core/geometry/geometry.h"
#include "core/mesh/surface_hit.h"
#include "core/operations/model_command.h"
#include "core/operations/transform_region.h"
#include "core/parts/part_list.h"
#include "ui/util/thread_mailbox.h"

#include <QObject>

#include <functional>

namespace app
{
class Document;
struct ModelChangeRequest;

/// The parts of the document, and the active part: the one that strokes and commands change. The list is that of the
/// last step, undo or redo that was confirmed. Undo and redo activate the part that they change or add. Thread: gui.
class DocumentParts : public QObject
{
    Q_OBJECT

public:
    explicit DocumentParts(Document* document);

    const core::PartList& list() const { return m_list; }
    core::PartId active() const { return m_active; }
    /// Returns the part that the request changes; nothing if there is only one part or the request concerns all.
    std::optional<core::Part> named(const ModelChangeRequest& request) const;
    /// Returns the part that the command shows or hides, as it is before; nothing if it changes none or several.
    std::optional<core::Part> switchedBy(const core::ShowParts& command) const;
    /// Calls `answer` with where the rays first meet a visible part, nullopt for one that meets none, if the document
    /// still exists then.
    void findSurface(const std::vector<core::Ray>& rays,
                     const std::function<void(const std::vector<std::optional<core::SurfaceHit>>& hits)>& answer);

public Q_SLOTS:
    /// Makes a part active. Has no effect if there is no such part.
    void activate(core::PartId part);
    /// Makes the visible part active that the ray meets first.
    void pick(const core::Ray& ray);
    /// Shows only the active part. If it is the only visible one, shows those again that were visible before.
    void isolate();
    /// Shows all hidden parts, and what is hidden of each part.
    void showAll();
    /// Asks the mesh thread what a core::Transform of the active part moves. Emits regionFound().
    void findRegion();
    /// Calls `answer` with whether visible parts overlap (core::doPartsOverlap()), if the document still exists then.
    /// Occupies the mesh thread.
    void findOverlap(const std::function<void(bool doOverlap)>& answer);

Q_SIGNALS:
    /// The list or the active part has changed.
    void changed();
    void regionFound(const core::TransformRegion& region);

private:
    void setList(const core::PartList& list);
    void followHistory();

    Document* m_document;
    core::PartList m_list;
    core::PartId m_active = 0;
    std::vector<core::PartId> m_shownBefore; ///< the parts that isolate() has hidden others of; empty: none
    int m_index = 0;                         ///< undo index at the last step or move
    ui::ThreadMailbox m_mailbox;
};
} // namespace app
