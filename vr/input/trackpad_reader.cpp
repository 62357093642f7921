#include "vr/input/trackpad_reader.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vr
{
namespace
{
using Position = Eigen::Vector2d;

Sector sectorOf(const Position& position)
{
    if (std::abs(position.x()) > std::abs(position.y()))
        return position.x() < 0 ? Sector::Left : Sector::Right;
    return position.y() < 0 ? Sector::Bottom : Sector::Top;
}

Position middleOf(Sector sector)
{
    switch (sector) {
    case Sector::Left:
        return {-1, 0};
    case Sector::Right:
        return {1, 0};
    case Sector::Top:
        return {0, 1};
    case Sector::Bottom:
        return {0, -1};
    }
    return Position::Zero();
}

/// The sector under a thumb that was in `before`.
std::optional<Sector> sectorAt(const Position& position, const std::optional<Sector>& before)
{
    const double radius = position.norm();
    if (radius < (before ? padCentreKept : padCentre))
        return std::nullopt;
    const double reach = std::cos((45 + sectorOverlap) * std::numbers::pi / 180);
    return before && position.dot(middleOf(*before)) >= radius * reach ? before : sectorOf(position);
}

/// Radii a second.
double rateOf(const WandState& wand)
{
    const double beyond = std::max(0.0, std::abs(wand.pad.y()) - stickRest) / (1 - stickRest);
    return std::copysign(stickSlide * beyond, wand.pad.y());
}
} // namespace

PadGestures PadReader::read(const WandState& wand, double seconds)
{
    const bool wasDown = m_isDown;
    PadGestures gestures;
    wand.isStick ? readStick(wand, seconds, gestures) : readPad(wand, seconds, gestures);
    if (!m_isDown)
        m_press.reset();
    else if (!wasDown)
        gestures.pressed = m_press = m_over;
    gestures.over = m_over;
    gestures.held = m_press;
    return gestures;
}

void PadReader::disregard()
{
    m_isIgnored = true;
    m_isDown = m_wasZero = m_mustRest = false;
    m_press.reset();
    m_over.reset();
    m_slidTo.reset();
    m_stickRate.reset();
}

void PadReader::readPad(const WandState& wand, double seconds, PadGestures& gestures)
{
    m_isIgnored = m_isIgnored && wand.padPressed;
    m_isDown = wand.padPressed && !m_isIgnored;
    const bool isTouched = wand.padTouched || wand.padPressed;
    const bool isRead = isTouched && isReading(wand.pad);
    if (!isTouched) {
        m_over.reset();
        m_wasZero = false;
    } else if (isRead) {
        m_over = sectorAt(wand.pad, m_over);
    }
    if (wand.padPressed)
        gestures.slide = slideBack();
    else if (!isTouched)
        m_slidTo.reset();
    else if (isRead)
        gestures.slide = slideTo(wand.pad, seconds);
}

/// Some runtimes say 0, 0 for a frame when the thumb comes or goes.
bool PadReader::isReading(const Position& position)
{
    const bool isZero = position == Position::Zero();
    const bool wasZero = std::exchange(m_wasZero, isZero);
    return !isZero || wasZero;
}

Position PadReader::slideTo(const Position& position, double seconds)
{
    if (!m_slidTo) {
        m_slidTo = position;
        m_slideAxis.reset();
        return Position::Zero();
    }
    Position by = position - *m_slidTo;
    if (!m_slideAxis) {
        Eigen::Index axis = 0;
        if (by.cwiseAbs().maxCoeff(&axis) <= slideThreshold)
            return Position::Zero();
        m_slideAxis = axis;
        by[axis] -= std::copysign(slideThreshold, by[axis]);
        m_slid = Position::Zero();
        m_slideAge = 0;
    }
    m_slidTo = position;
    Position slid = by[*m_slideAxis] * Position::Unit(*m_slideAxis);
    m_slid += slid;
    m_slideAge += seconds;
    return slid;
}

Position PadReader::slideBack()
{
    const bool wasOnItsWay = m_slidTo && m_slideAxis && m_slideAge <= slideToPress;
    m_slidTo.reset();
    return wasOnItsWay ? Position(-m_slid) : Position(Position::Zero());
}

void PadReader::readStick(const WandState& wand, double seconds, PadGestures& gestures)
{
    const double pushed = wand.pad.norm();
    const bool isResting = !wand.padPressed && pushed < stickRelease;
    m_isIgnored = m_isIgnored && !isResting;
    m_mustRest = wand.padPressed || (m_mustRest && !isResting);
    m_isDown = !m_isIgnored && !m_mustRest && pushed >= (m_isDown ? stickRelease : stickPress);
    if (!m_isDown)
        m_over.reset();
    else if (!m_over)
        m_over = sectorOf(wand.pad);
    gestures.slide.y() = stickSlid(wand, seconds);
}

/// The mean rate of this frame and the one before, so that few frames slide as far as many.
double PadReader::stickSlid(const WandState& wand, double seconds)
{
    if (!wand.padPressed || m_isIgnored) {
        m_stickRate.reset();
        return 0;
    }
    const double rate = rateOf(wand);
    const std::optional<double> before = std::exchange(m_stickRate, rate);
    return before ? (*before + rate) / 2 * seconds : 0;
}
} // namespace vr
