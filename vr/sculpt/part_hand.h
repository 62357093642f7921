#pragma once

#include "vr/input/model_placement.h"
#include "vr/input/wand_commands.h"
#include "vr/sculpt/document_port.h"

#include "core/parts/part_transform.h"

namespace vr
{
/// Holds the active part in a hand: it moves and turns as the hand does. Only a preview moves until the hand lets go;
/// then the part is changed as one step, as soon as the document has said what moves. What is masked or hidden stays
/// (core::Transform). Thread: the headset's.
class PartHand
{
public:
    /// Precondition: `port` outlives this object.
    explicit PartHand(DocumentPort* port) : m_port(port) {}

    /// Takes the port's answers. To be called once a frame, before DocumentPort::takePatch(): the preview ends in the
    /// frame in which the changed mesh arrives.
    void step();
    /// Moves the part; the first move takes hold of it. Has no effect while an earlier change of it is being made.
    void move(const MovePart& move, core::PartId part, const ModelPlacement& placement);
    /// Ends the hold, and requests the change of the part: now, or in the step() that takes the document's answer.
    void release();
    /// Ends the hold without a change, because the part is not what it was. The hand has to let go before it can hold a
    /// part again.
    void drop();

    /// Returns the transform to be shown; none if nothing is held, or if it is not known yet what moves.
    std::optional<core::Transform> shown() const;
    /// Returns the vertices that follow the transform; null if shown() is none.
    std::shared_ptr<const core::Footprint> vertices() const;

private:
    enum class State {
        Free,
        Held,
        Dropped,  ///< until the hand lets go
        Waiting,  ///< for the answer of a hold that has ended
        Changing, ///< until the document has changed the part
    };

    core::Transform transform() const;
    void change();

    DocumentPort* m_port;
    State m_state = State::Free;
    core::PartId m_part = 0;
    std::optional<MovablePart> m_movable; ///< the port's answer for this hold
    Eigen::Quaterniond m_turn = Eigen::Quaterniond::Identity();
    core::Vec3 m_shift = core::Vec3::Zero(); ///< the hold moves p to m_turn p + m_shift; document space, mm
};
} // namespace vr
