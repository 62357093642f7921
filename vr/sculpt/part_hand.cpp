#include "vr/sculpt/part_hand.h"

namespace vr
{
void PartHand::step()
{
    if (m_state == State::Changing && m_port->isSettled())
        m_state = State::Free;
    std::optional<MovablePart> movable = m_port->takePart();
    if (!movable || m_movable || !(m_state == State::Held || m_state == State::Waiting))
        return;
    m_movable = std::move(movable);
    if (m_state == State::Waiting)
        change();
}

void PartHand::move(const MovePart& move, core::PartId part, const ModelPlacement& placement)
{
    if (m_state != State::Free && m_state != State::Held)
        return;
    if (m_state == State::Free) {
        m_state = State::Held;
        m_part = part;
        m_movable.reset();
        m_turn = Eigen::Quaterniond::Identity();
        m_shift = core::Vec3::Zero();
        m_port->queryPart();
    }
    // A turn of the hand about its own place, then a move of that place; both as seen from the model.
    const Eigen::AngleAxisd inRoom(move.to.rotation * move.from.rotation.conjugate());
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(inRoom.angle(), placement.directionToModel(inRoom.axis())));
    const core::Vec3 from = placement.toModel(move.from.position), to = placement.toModel(move.to.position);
    m_turn = (turn * m_turn).normalized();
    m_shift = to + turn * (m_shift - from);
}

void PartHand::release()
{
    if (m_state == State::Dropped)
        m_state = State::Free;
    if (m_state != State::Held)
        return;
    if (m_movable)
        change();
    else
        m_state = State::Waiting;
}

void PartHand::drop()
{
    if (m_state == State::Held)
        m_state = State::Dropped;
    else if (m_state == State::Waiting)
        m_state = State::Free;
    m_movable.reset();
}

/// Requests the change. Precondition: the document has said what moves, and about which place.
void PartHand::change()
{
    const core::Transform made = transform();
    m_state = made.isNothing() ? State::Free : State::Changing;
    if (!made.isNothing())
        m_port->request(ChangePart{m_part, made});
}

core::Transform PartHand::transform() const
{
    core::Transform transform;
    transform.centre = m_movable->centre;
    transform.rotation = m_turn;
    transform.by = m_turn * transform.centre + m_shift - transform.centre;
    return transform;
}

std::optional<core::Transform> PartHand::shown() const
{
    return m_state != State::Free && m_movable ? std::optional(transform()) : std::nullopt;
}

std::shared_ptr<const core::Footprint> PartHand::vertices() const
{
    return m_state != State::Free && m_movable ? m_movable->vertices : nullptr;
}
} // namespace vr
