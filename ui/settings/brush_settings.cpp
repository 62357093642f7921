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
/// models that differ in size by more than this factor get another brush radius
constexpr double otherModelFactor = 2;
constexpr core::Rgb firstPaint{216, 58, 52}; ///< visible on every material; a model's own colour would not be

core::StrokeSettings firstStroke()
{
    core::StrokeSettings stroke;
    stroke.place = core::Placement::Ray;
    stroke.topology = core::Topology::Refine;
    stroke.spacing = defaultSpacing;
    stroke.color = firstPaint;
    return stroke;
}

/// Returns the legal falloff n nearest to `value`: 0, or 3 to 16. Precondition: `value` is at most 16.
int legalFalloff(double value)
{
    const int n = static_cast<int>(std::lround(value));
    return core::isFalloff(n) ? n : (n < 2 ? 0 : 3);
}

/// Returns the member that contains the parameter; null for Falloff, which is not a double.
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
    , m_tools(new ToolMemory(this))
    , m_maxRadius(core::info(core::Parameter::Radius).max)
{
    connect(m_tools, &ToolMemory::changed, this, &BrushSettings::takeValues);
    connect(m_tools, &ToolMemory::airbrushChanged, this, &BrushSettings::inputChanged);
    connect(m_tools, &ToolMemory::sharesRadiusChanged, this, &BrushSettings::useSharing);
}

/// Switches to a tool and its values. Precondition: the values of the tool before have been stored by remember().
void BrushSettings::changeTool(core::Tool tool)
{
    if (!isOffered(tool))
        return;
    m_stroke.tool = tool;
    putInto(m_stroke, m_tools->of(tool));
    if (const auto share = m_tools->of(tool).radiusShare; share && !m_tools->sharesRadius())
        m_stroke.radius = std::clamp(*share * m_modelSize, minOf(core::Parameter::Radius), m_maxRadius);
    Q_EMIT changed();
}

void BrushSettings::noteChange()
{
    if (m_stroke.symmetry != core::Symmetry::None)
        m_plane = m_stroke.symmetry;
    if (m_stroke.radial > 1)
        m_sectors = m_stroke.radial;
    if (m_stroke.topology != core::Topology::Uniform)
        m_topology = m_stroke.topology;
    remember();
    Q_EMIT changed();
}

void BrushSettings::remember()
{
    ToolValues values = m_tools->of(m_stroke.tool);
    takeFrom(m_stroke, values);
    if (!m_tools->sharesRadius())
        values.radiusShare = radiusShare();
    m_tools->set(m_stroke.tool, values);
}

/// Takes over values that were changed in the tool memory from outside. Changes made by remember() are recognised,
/// because they equal the present values.
void BrushSettings::takeValues(core::Tool tool)
{
    if (tool != m_stroke.tool)
        return;
    const ToolValues& values = m_tools->of(tool);
    ToolValues own = values;
    takeFrom(m_stroke, own);
    const double share = m_tools->sharesRadius() ? radiusShare() : values.radiusShare.value_or(radiusShare());
    if (own == values && share == radiusShare())
        return;
    putInto(m_stroke, values);
    m_stroke.radius = std::clamp(share * m_modelSize, minOf(core::Parameter::Radius), m_maxRadius);
    Q_EMIT changed();
}

/// Handles a change of radius sharing. When sharing ends, the current tool and tools without a radius of their own get
/// the present radius.
void BrushSettings::useSharing(bool shares)
{
    for (std::size_t i = 0; !shares && i < core::toolNames().size(); ++i) {
        const auto tool = static_cast<core::Tool>(i);
        ToolValues values = m_tools->of(tool);
        if (tool != m_stroke.tool && values.radiusShare)
            continue;
        values.radiusShare = radiusShare();
        m_tools->set(tool, values);
    }
    Q_EMIT changed();
}

void BrushSettings::offerTools(const QList<core::Tool>& tools)
{
    m_offered = tools;
    if (!tools.isEmpty())
        setTool(tools.constFirst());
    Q_EMIT changed();
}

void BrushSettings::reset()
{
    const double radius = m_stroke.radius;
    m_tools->reset();
    m_stroke = firstStroke();
    m_stroke.radius = radius;
    m_stroke.tool = m_offered.isEmpty() ? m_stroke.tool : m_offered.constFirst();
    const BrushSettings first;
    m_plane = first.m_plane;
    m_sectors = first.m_sectors;
    m_topology = first.m_topology;
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
    // a finer detail may raise the smallest radius that the lattice allows
    if (parameter == core::Parameter::Detail)
        m_stroke.radius = std::clamp(m_stroke.radius, minOf(core::Parameter::Radius), m_maxRadius);
    if (this->value(parameter) != before) {
        remember();
        Q_EMIT changed();
    }
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
    m_stroke.airbrush = own.airbrush;
    m_stroke.detailLength = own.detailLength;
    if (!isOffered(stroke.tool))
        m_stroke.tool = own.tool;
    const std::shared_ptr<const core::Alpha>& alpha = m_tools->of(m_stroke.tool).alpha;
    if (!stroke.alpha && alpha && !alpha->isBuiltIn())
        m_stroke.alpha = alpha;
    m_stroke.radius = std::clamp(stroke.radius, minOf(core::Parameter::Radius), m_maxRadius);
    noteChange();
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

core::StrokeSettings withModifiers(const BrushSettings& brush, Qt::KeyboardModifiers modifiers,
                                   Qt::KeyboardModifier invert)
{
    core::StrokeSettings stroke = brush.stroke();
    if (modifiers & Qt::ShiftModifier) {
        stroke.tool = core::Tool::Smooth;
        putInto(stroke, brush.tools()->of(stroke.tool));
        stroke.alpha = nullptr; // no alpha: Shift smooths evenly
        return stroke;
    }
    return modifiers & invert ? core::opposite(stroke) : stroke;
}
} // namespace ui
