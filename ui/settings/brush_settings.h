#pragma once

#include "ui/settings/model_info.h"
#include "ui/settings/tool_memory.h"

#include "core/stroke/stroke.h"

#include <QList>
#include <QObject>

#include <type_traits>

namespace ui
{
/// The length of the stabilizer of a steady stroke, in logical pixels.
inline constexpr double minStabilizerLength = 4, maxStabilizerLength = 200, defaultStabilizerLength = 32;

/// The brush in the user's hand: what the next stroke will be. Panels, cursor and viewport are views of it; it is read
/// when a stroke begins and not during one. A change of tool brings the values that the tool had (ToolMemory).
/// Thread: gui.
class BrushSettings : public QObject
{
    Q_OBJECT

public:
    explicit BrushSettings(QObject* parent = nullptr);

    const core::StrokeSettings& stroke() const { return m_stroke; }
    core::Tool tool() const { return m_stroke.tool; }
    double value(core::Parameter parameter) const;

    /// What has no range: tool, shape, topology, fusion, symmetry, colour.
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
    /// From now on these can be chosen and no others; the first is taken. At first it is all.
    void offerTools(const QList<core::Tool>& tools);
    const QList<core::Tool>& offeredTools() const { return m_offered; }
    bool isOffered(core::Tool tool) const { return m_offered.isEmpty() || m_offered.contains(tool); }
    /// About the plane that was chosen last; x = 0 at first.
    void setSymmetric(bool symmetric)
    {
        set(&core::StrokeSettings::symmetry, symmetric ? m_plane : core::Symmetry::None);
    }
    /// In as many sectors as were chosen last; six at first.
    void setRadial(bool radial) { set(&core::StrokeSettings::radial, radial ? m_sectors : 1); }
    /// Makes edges uniform, or goes back to the topology that was chosen before; at first to one that keeps detail.
    void setUniform(bool uniform)
    {
        set(&core::StrokeSettings::topology, uniform ? core::Topology::Uniform : m_topology);
    }
    /// Clamped to the range of the parameter table (the radius also to the model), falloff rounded to a legal n.
    void setValue(core::Parameter parameter, double value);
    void scaleRadius(double factor);
    /// What a person chooses of a stroke; the radius as far as the model takes it. An alpha from a file stays where
    /// that one has none.
    void apply(const core::StrokeSettings& stroke);
    /// Sets all to a new user's, the values of all tools included, but for the radius, which is the model's; of the
    /// tools that are offered the first.
    void reset();

    /// Returns what each tool has of its own, the present one included: both ways, what is set here is set there.
    ToolMemory* tools() const { return m_tools; }
    /// Inverted strokes do the opposite of what their tool does; with the key that inverts they do what it does.
    bool isInverted() const { return m_isInverted; }
    void setInverted(bool inverted);

    /// In a steady stroke the brush follows the pointer at the length of the stabilizer.
    bool isSteady() const { return m_isSteady; }
    void setSteady(bool steady);
    /// Of a steady stroke, in logical pixels.
    double stabilizerLength() const { return m_stabilizerLength; }
    void setStabilizerLength(double pixels);

    /// From now on the radius can be what makes sense for that model, and it is this share of its longest side.
    void fitTo(const ModelInfo& modelInfo, double radiusShare);
    /// The radius, in longest sides of the model that it was fitted to.
    double radiusShare() const;
    void setRadiusShare(double share) { setValue(core::Parameter::Radius, share * m_modelSize); }
    /// Whether the model is still about as large as the one that the radius was fitted to.
    bool fits(const ModelInfo& modelInfo) const;
    double minOf(core::Parameter parameter) const;
    double maxOf(core::Parameter parameter) const;

Q_SIGNALS:
    void changed();
    /// How strokes are drawn, not what they do; after changed().
    void inputChanged();
    /// setValue() or scaleRadius() asked for what it cannot be; it was set to the nearest that it can.
    void clamped(core::Parameter parameter);

private:
    void changeTool(core::Tool tool);
    void noteChange();
    void remember();
    void takeValues(core::Tool tool);
    void useSharing(bool shares);

    core::StrokeSettings m_stroke;
    QList<core::Tool> m_offered; ///< none: all
    ToolMemory* m_tools;
    bool m_isInverted = false;
    bool m_isSteady = false;
    double m_stabilizerLength = defaultStabilizerLength;
    core::Symmetry m_plane = core::Symmetry::X;
    int m_sectors = 6;
    core::Topology m_topology = core::Topology::Refine; ///< when it is not uniform
    double m_minDetail = 0;                             ///< of the model's lattice
    double m_maxRadius;
    double m_modelSize = 100; ///< mm, longest side; to which the radius was fitted: at first the ball of clay's
};

/// Returns what a stroke that begins with these keys held does: Shift smooths, as strongly as the tool Smooth, `invert`
/// does the opposite.
core::StrokeSettings withModifiers(const BrushSettings& brush, Qt::KeyboardModifiers modifiers,
                                   Qt::KeyboardModifier invert = Qt::ControlModifier);
} // namespace ui
