#include "ui/settings/brush_settings.h"

#include "ui/settings/settings.h"

#include "core/sculpt/deform/alpha.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui
{
namespace
{
constexpr double otherModelFactor = 2;       ///< so many times larger or smaller a model is of quite another size
constexpr core::Rgb firstPaint{216, 58, 52}; ///< is seen on every material; a model's own colour would not be

core::StrokeSettings firstStroke()
{
    core::StrokeSettings stroke;
    stroke.place = core::Placement::Ray;
    stroke.topology = core::Topology::Refine;
    stroke.spacing = defaultSpacing;
    stroke.color = firstPaint;
    return stroke;
}

/// The nearest legal n: 0, or 3 to 16.
int legalFalloff(double value)
{
    const int n = static_cast<int>(std::lround(value));
    return core::isFalloff(n) ? n : (n < 2 ? 0 : 3);
}

/// Returns the member that holds the parameter; null for Falloff, which is no double.
double core::StrokeSettings::*numberOf(core::Parameter parameter)
{
    using Settings = core::StrokeSettings;
    constexpr double Settings::*numbers[] = {&Settings::radius, &Settings::strength, nullptr, &Settings::detail,
                                             &Settings::spacing};
    static_assert(std::size(numbers) == static_cast<std::size_t>(core::Parameter::Spacing) + 1);
    return numbers[static_cast<std::size_t>(parameter)];
}
} // namespace

BrushSettings::BrushSettings(QObject* parent)
    : QObject(parent)
    , m_stroke(firstStroke())
    , m_maxRadius(core::info(core::Parameter::Radius).max)
{}

void BrushSettings::offerTools(const QList<core::Tool>& tools)
{
    m_tools = tools;
    if (!tools.isEmpty())
        setTool(tools.constFirst());
    Q_EMIT changed();
}

void BrushSettings::reset()
{
    const double radius = m_stroke.radius;
    m_stroke = firstStroke();
    m_stroke.radius = radius;
    m_stroke.tool = m_tools.isEmpty() ? m_stroke.tool : m_tools.constFirst();
    const BrushSettings first;
    m_plane = first.m_plane;
    m_sectors = first.m_sectors;
    m_topology = first.m_topology;
    m_withoutAirbrush.clear();
    m_isInverted = first.m_isInverted;
    m_isSteady = first.m_isSteady;
    m_stabilizerLength = first.m_stabilizerLength;
    Q_EMIT changed();
    Q_EMIT inputChanged();
}

double BrushSettings::value(core::Parameter parameter) const
{
    return parameter == core::Parameter::Falloff ? m_stroke.falloff : m_stroke.*numberOf(parameter);
}

void BrushSettings::setValue(core::Parameter parameter, double value)
{
    const double before = this->value(parameter);
    const double legal = std::clamp(value, minOf(parameter), maxOf(parameter));
    if (parameter == core::Parameter::Falloff)
        m_stroke.falloff = legalFalloff(legal);
    else
        m_stroke.*numberOf(parameter) = legal;
    if (parameter == core::Parameter::Detail) // finer edges under a small brush may be finer than the lattice
        m_stroke.radius = std::clamp(m_stroke.radius, minOf(core::Parameter::Radius), m_maxRadius);
    if (this->value(parameter) != before)
        Q_EMIT changed();
    if (legal != value)
        Q_EMIT clamped(parameter);
}

void BrushSettings::scaleRadius(double factor)
{
    setValue(core::Parameter::Radius, m_stroke.radius * factor);
}

void BrushSettings::apply(const core::StrokeSettings& stroke)
{
    const core::StrokeSettings own = std::exchange(m_stroke, stroke);
    m_stroke.place = own.place;
    m_stroke.add = own.add;
    m_stroke.model = own.model;
    if (!stroke.alpha && own.alpha && !own.alpha->isBuiltIn())
        m_stroke.alpha = own.alpha;
    m_stroke.detailLength = own.detailLength;
    if (!isOffered(stroke.tool))
        m_stroke.tool = own.tool;
    m_stroke.radius = std::clamp(stroke.radius, minOf(core::Parameter::Radius), m_maxRadius);
    if (stroke.symmetry != core::Symmetry::None)
        m_plane = stroke.symmetry;
    if (stroke.radial > 1)
        m_sectors = stroke.radial;
    if (stroke.topology != core::Topology::Uniform)
        m_topology = stroke.topology;
    Q_EMIT changed();
}

void BrushSettings::setAirbrush(core::Tool tool, bool on)
{
    if (isAirbrush(tool) == on || !core::canAirbrush(tool))
        return;
    if (on)
        m_withoutAirbrush.removeAll(tool);
    else
        m_withoutAirbrush.append(tool);
    Q_EMIT inputChanged();
}

void BrushSettings::setInverted(bool inverted)
{
    if (std::exchange(m_isInverted, inverted) != inverted)
        Q_EMIT changed();
}

void BrushSettings::setSteady(bool steady)
{
    if (std::exchange(m_isSteady, steady) == steady)
        return;
    Q_EMIT changed();
    Q_EMIT inputChanged();
}

void BrushSettings::setStabilizerLength(double pixels)
{
    const double legal = std::clamp(pixels, minStabilizerLength, maxStabilizerLength);
    if (std::exchange(m_stabilizerLength, legal) == legal)
        return;
    Q_EMIT changed();
    Q_EMIT inputChanged();
}

void BrushSettings::fitTo(const ModelInfo& modelInfo, double radiusShare)
{
    const core::ParameterInfo& row = core::info(core::Parameter::Radius);
    m_modelSize = modelInfo.size.maxCoeff();
    m_minDetail = modelInfo.minDetail;
    m_maxRadius = std::clamp(maxRadiusShare * m_modelSize, row.min, row.max);
    m_stroke.radius = std::clamp(radiusShare * m_modelSize, minOf(core::Parameter::Radius), m_maxRadius);
    Q_EMIT changed();
}

double BrushSettings::radiusShare() const
{
    return m_stroke.radius / m_modelSize;
}

bool BrushSettings::fits(const ModelInfo& modelInfo) const
{
    const double size = modelInfo.size.maxCoeff();
    return size == 0 || (size <= otherModelFactor * m_modelSize && otherModelFactor * size >= m_modelSize);
}

double BrushSettings::minOf(core::Parameter parameter) const
{
    const double min = core::info(parameter).min;
    return parameter == core::Parameter::Radius
               ? std::clamp(core::radiusFor(m_minDetail, m_stroke.detail), min, m_maxRadius)
               : min;
}

double BrushSettings::maxOf(core::Parameter parameter) const
{
    return parameter == core::Parameter::Radius ? m_maxRadius : core::info(parameter).max;
}

core::StrokeSettings withModifiers(core::StrokeSettings stroke, Qt::KeyboardModifiers modifiers,
                                   Qt::KeyboardModifier invert)
{
    if (modifiers & Qt::ShiftModifier) {
        stroke.tool = core::Tool::Smooth;
        stroke.alpha = nullptr; // evenly
        return stroke;
    }
    return modifiers & invert ? core::opposite(stroke) : stroke;
}
} // namespace ui
