#pragma once

#include "ui/input/pointer_event.h"
#include "ui/settings/brush_settings.h"
#include "ui/settings/preferences.h"

#include "core/stroke/stroke.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace ui
{
/// Builds a stroke from pointer events. In a steady stroke the brush trails the pointer by the stabilizer's length,
/// and reaches the pointer at the end. A pointer that does not move adds samples if the model turns under it or the
/// brush is an airbrush. Thread: gui.
class StrokeBuilder : public QObject
{
    Q_OBJECT

public:
    /// The press that begins a stroke, with the settings at that time.
    struct Start
    {
        PointerEvent pointer;
        core::Ray ray; ///< through the pointer's pixel
        core::StrokeSettings settings;
        double stabilizerLength = 0; ///< pixels; 0: the brush is at the pointer
    };

    /// `brush` and `camera` are not owned.
    StrokeBuilder(const BrushSettings* brush, const OrbitCamera* camera, QObject* parent = nullptr);

    void setInputPreferences(const InputPreferences& preferences) { m_preferences = preferences; }

    void begin(const Start& start);
    /// `ray`: through the pointer's pixel, computed when the event arrived.
    void moveTo(const PointerEvent& pointer, const core::Ray& ray);
    /// Sets the pixel and time (seconds) of the release.
    void setReleasePoint(const OrbitCamera::Pixel& pixel, double time);
    void end(core::StrokeEnd how = core::StrokeEnd::Kept);

    /// Turns the model by `angle` radians about the Y axis in `seconds`. The camera has been turned already.
    void turnModel(double angle, double seconds);
    void resetTurn() { m_turned = 0; }

    bool isOpen() const { return m_isOpen; }
    /// Returns the settings of the open stroke, or of the last one.
    const core::StrokeSettings& settings() const { return m_settings; }
    /// Returns the pixel of the brush in the open stroke.
    const OrbitCamera::Pixel& brushAt() const { return m_brushAt; }
    /// Returns the pixel of the pointer in a steady stroke, else the pixel of the brush.
    const OrbitCamera::Pixel& pointerAt() const { return m_stabilizerLength > 0 ? m_pointer.pixel : m_brushAt; }

Q_SIGNALS:
    void began(const core::StrokeSettings& settings);
    void sampled(const core::StrokeSample& sample);
    void ended(core::StrokeEnd how);

private:
    void sample(const core::Ray& ray);
    void rest();

    const BrushSettings* m_brush;
    const OrbitCamera* m_camera;
    InputPreferences m_preferences;
    bool m_isOpen = false;
    core::StrokeSettings m_settings;
    double m_stabilizerLength = 0; ///< pixels
    PointerEvent m_pointer;        ///< latest position and pressure
    OrbitCamera::Pixel m_brushAt{0, 0};
    QTimer m_rest;               ///< runs while an airbrush stroke is open
    QElapsedTimer m_sinceSample; ///< wall-clock time since the last sample
    double m_turned = 0;         ///< angle of the model in the world about Y, radians
};
} // namespace ui
