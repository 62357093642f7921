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

/// Returns the sector under a thumb that was in `before`, with hysteresis; none in the dead centre.
std::optional<Sector> sectorAt(const Position& position, const std::optional<Sector>& before)
{
    const double radius = position.norm();
    if (radius < (before ? padCentreHysteresis : padCentre))
        return std::nullopt;
    const double reach = std::cos((45 + sectorOverlap) * std::numbers::pi / 180);
    return before && position.dot(middleOf(*before)) >= radius * reach ? before : sectorOf(position);
}

/// Returns the rate at which a clicked stick slides, radii a second.
double rateOf(const WandState& wand)
{
    const double beyond = std::max(0.0, std::abs(wand.pad.y()) - stickDeadZone) / (1 - stickDeadZone);
    return std::copysign(stickSlide * beyond, wand.pad.y());
}
} // namespace

TrackpadGestures TrackpadReader::read(const WandState& wand, double seconds)
{
    const bool wasDown = m_isDown;
    TrackpadGestures gestures;
    wand.isStick ? readStick(wand, seconds, gestures) : readPad(wand, seconds, gestures);
    if (!m_isDown)
        m_press.reset();
    else if (!wasDown)
        gestures.pressed = m_press = m_over;
    gestures.over = m_over;
    gestures.held = m_press;
    return gestures;
}

void TrackpadReader::ignoreUntilReleased()
{
    m_isIgnored = true;
    m_isDown = m_wasZero = m_mustCentre = false;
    m_press.reset();
    m_over.reset();
    m_slidTo.reset();
    m_stickRate.reset();
}

void TrackpadReader::readPad(const WandState& wand, double seconds, TrackpadGestures& gestures)
{
    m_isIgnored = m_isIgnored && wand.padPressed;
    m_isDown = wand.padPressed && !m_isIgnored;
    const bool isTouched = wand.padTouched || wand.padPressed;
    const bool isSample = isTouched && isValidSample(wand.pad);
    if (!isTouched) {
        m_over.reset();
        m_wasZero = false;
    } else if (isSample) {
        m_over = sectorAt(wand.pad, m_over);
    }
    if (wand.padPressed)
        gestures.slide = undoSlide();
    else if (!isTouched)
        m_slidTo.reset();
    else if (isSample)
        gestures.slide = slideTo(wand.pad, seconds);
}

/// Returns whether the position can be used. Some runtimes report (0, 0) for a frame when the thumb touches down or
/// lifts.
bool TrackpadReader::isValidSample(const Position& position)
{
    const bool isZero = position == Position::Zero();
    const bool wasZero = std::exchange(m_wasZero, isZero);
    return !isZero || wasZero;
}

Position TrackpadReader::slideTo(const Position& position, double seconds)
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

Position TrackpadReader::undoSlide()
{
    const bool wasOnItsWay = m_slidTo && m_slideAxis && m_slideAge <= maxSlideBeforePress;
    m_slidTo.reset();
    return wasOnItsWay ? Position(-m_slid) : Position(Position::Zero());
}

void TrackpadReader::readStick(const WandState& wand, double seconds, TrackpadGestures& gestures)
{
    const double pushed = wand.pad.norm();
    const bool isCentred = !wand.padPressed && pushed < stickRelease;
    m_isIgnored = m_isIgnored && !isCentred;
    m_mustCentre = wand.padPressed || (m_mustCentre && !isCentred);
    m_isDown = !m_isIgnored && !m_mustCentre && pushed >= (m_isDown ? stickRelease : stickPress);
    if (!m_isDown)
        m_over.reset();
    else if (!m_over)
        m_over = sectorOf(wand.pad);
    gestures.slide.y() = stickSlid(wand, seconds);
}

/// Returns the slide of a clicked stick. It uses the mean rate of this frame and the last one, so that the result does
/// not depend on the frame rate.
double TrackpadReader::stickSlid(const WandState& wand, double seconds)
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
