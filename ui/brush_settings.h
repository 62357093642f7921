#pragma once

#include "core/stroke.h"

#include <QObject>

namespace ui
{
/// The brush in the user's hand: what the next stroke will be. Panels, cursor and viewport are views of it; it is read
/// when a stroke begins and not during one. Gui thread.
class BrushSettings : public QObject
{
    Q_OBJECT

public:
    explicit BrushSettings(QObject* parent = nullptr);

    const core::StrokeSettings& stroke() const { return m_stroke; }
    core::Tool tool() const { return m_stroke.tool; }
    double value(core::Parameter parameter) const;

    void setTool(core::Tool tool);
    /// Clamped to the range of the parameter table (the radius also to setRadiusRange), falloff rounded to a legal n.
    void setValue(core::Parameter parameter, double value);
    void scaleRadius(double factor);

    /// The radii, in mm, that make sense for the model at hand; the radius is moved into them.
    void setRadiusRange(double min, double max);
    double minOf(core::Parameter parameter) const;
    double maxOf(core::Parameter parameter) const;

Q_SIGNALS:
    void changed();

private:
    core::StrokeSettings m_stroke;
    double m_minRadius, m_maxRadius;
};

/// What a stroke that begins with these keys held does: Shift smooths, Ctrl turns Pull into Push and Push into Pull.
core::Tool toolWith(core::Tool tool, Qt::KeyboardModifiers modifiers);
} // namespace ui
