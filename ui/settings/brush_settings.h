#pragma once

#include "ui/settings/model_info.h"
#include "ui/settings/tool_memory.h"

#include "core/stroke/stroke.h"

#include <QList>
#include <QObject>

#include <type_traits>

namespace ui
{
/// Lengths of the stabilizer of a steady stroke, logical pixels.
inline constexpr double minStabilizerLength = 4, maxStabilizerLength = 200, defaultStabilizerLength = 32;

/// The settings of the next stroke. Panels, cursor and viewport show them; they are read when a stroke begins and
/// ignored during it. Changing the tool restores the tool's own values (ToolMemory). Thread: gui.
class BrushSettings : public QObject
{
    Q_OBJECT

public:
    explicit BrushSettings(QObject* parent = nullptr);

    const core::StrokeSettings& stroke() const { return m_stroke; }
    core::Tool tool() const { return m_stroke.tool; }
    double value(core::Parameter parameter) const;

    /// Sets a member that has no numeric range: tool, shape, topology, fusion, symmetry or colour.
    template <class T> void set(T core::StrokeSettings::*what, const T& value)
    {
        if (m_stroke.*what == value)
            return;
        if constexpr (std::is_same_v<T, core::Tool>) {
            changeTool(value);
        } else {
            m_stroke.*what = value;
            noteChange();
        }
    }
    void setTool(core::Tool tool) { set(&core::StrokeSettings::tool, tool); }
    /// Restricts the choice of tools to these and selects the first. An empty list, as initially, offers all
    /// tools and keeps the selection.
    void offerTools(const QList<core::Tool>& tools);
    const QList<core::Tool>& offeredTools() const { return m_offered; }
    bool isOffered(core::Tool tool) const { return m_offered.isEmpty() || m_offered.contains(tool); }
    /// Turns symmetry on or off. Its plane is the last one chosen; initially x = 0.
    void setSymmetric(bool symmetric)
    {
        set(&core::StrokeSettings::symmetry, symmetric ? m_plane : core::Symmetry::None);
    }
    /// Turns radial symmetry on or off. Its number of sectors is the last one chosen; initially six.
    void setRadial(bool radial) { set(&core::StrokeSettings::radial, radial ? m_sectors : 1); }
    /// Chooses the uniform topology, or returns to the topology chosen before; initially Topology::Refine, which keeps
    /// detail.
    void setUniform(bool uniform)
    {
        set(&core::StrokeSettings::topology, uniform ? core::Topology::Uniform : m_topology);
    }
    /// Sets a parameter. The value is clamped to the range of the parameter table, and the radius also to the model's
    /// range. Falloff is rounded to a legal n.
    void setValue(core::Parameter parameter, double value);
    void scaleRadius(double factor);
    /// Sets everything in a stroke that the user can choose, except the airbrush, the brush model and a tool that is
    /// not offered; the radius is clamped to the model's range. If `stroke` has no alpha, an alpha from a file is kept.
    void apply(const core::StrokeSettings& stroke);
    /// Resets all settings, including the values of all tools, to those of a new user. Keeps the radius, which depends
    /// on the model. Selects the first offered tool, unless all tools are offered.
    void reset();

    /// Returns the own values of every tool. The current tool's values are kept equal to stroke() in both directions.
    ToolMemory* tools() const { return m_tools; }
    /// Returns true if strokes do the opposite of what the tool does. Holding the inverting key then restores the
    /// normal effect.
    bool isInverted() const { return m_isInverted; }
    void setInverted(bool inverted);

    /// Returns true for steady strokes: the brush follows the pointer at the length of the stabilizer.
    bool isSteady() const { return m_isSteady; }
    void setSteady(bool steady);
    /// Returns the length of the stabilizer, logical pixels.
    double stabilizerLength() const { return m_stabilizerLength; }
    void setStabilizerLength(double pixels);

    /// Sets the range of the radius to what makes sense for the model, and the radius to `radiusShare` times its
    /// longest side.
    void fitTo(const ModelInfo& modelInfo, double radiusShare);
    /// Returns the radius as a fraction of the longest side of the model given to fitTo().
    double radiusShare() const;
    void setRadiusShare(double share) { setValue(core::Parameter::Radius, share * m_modelSize); }
    /// Returns true if the model is about as large as the one given to fitTo(): within a factor of 2. True for a size
    /// of 0, too.
    bool fits(const ModelInfo& modelInfo) const;
    double minOf(core::Parameter parameter) const;
    double maxOf(core::Parameter parameter) const;

Q_SIGNALS:
    void changed();
    /// The input settings changed: steadiness, stabilizer or airbrush. They affect how strokes are drawn, not what they
    /// do. Emitted after changed().
    void inputChanged();
    /// setValue() or scaleRadius() was given a value out of range, which was clamped.
    void clamped(core::Parameter parameter);

private:
    void changeTool(core::Tool tool);
    void noteChange();
    void remember();
    void takeValues(core::Tool tool);
    void useSharing(bool shares);

    core::StrokeSettings m_stroke;
    QList<core::Tool> m_offered; ///< empty: all tools are offered
    ToolMemory* m_tools;
    bool m_isInverted = false;
    bool m_isSteady = false;
    double m_stabilizerLength = defaultStabilizerLength;
    core::Symmetry m_plane = core::Symmetry::X;
    int m_sectors = 6;
    core::Topology m_topology = core::Topology::Refine; ///< topology to return to when uniform topology is turned off
    double m_minDetail = 0;                             ///< finest d_detail of the model's lattice, mm
    double m_maxRadius;
    double m_modelSize = 100; ///< longest side of the model given to fitTo(), mm; initially that of the starter ball
};

/// Returns the settings of a stroke that begins with these modifier keys. Shift smooths, with the strength of the tool
/// Smooth; `invert` inverts the effect.
core::StrokeSettings withModifiers(const BrushSettings& brush, Qt::KeyboardModifiers modifiers,
                                   Qt::KeyboardModifier invert = Qt::ControlModifier);
} // namespace ui
