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
/// Builds a stroke from pointer events. In a steady stroke the brush follows the pointer at the length of the
/// stabilizer, and reaches it when the stroke ends. Where the model turns under a resting pointer the stroke goes on,
/// and so it does with an airbrush where the pointer rests. Thread: gui.
class StrokeBuilder : public QObject
{
    Q_OBJECT

public:
    /// A press, with what was set then.
    struct Start
    {
        PointerEvent pointer;
        core::Ray ray; ///< through its pixel
        core::StrokeSettings settings;
        double stabilizerLength = 0; ///< in pixels; 0: the brush is where the pointer is
    };

    /// Neither is owned.
    StrokeBuilder(const BrushSettings* brush, const OrbitCamera* camera, QObject* parent = nullptr);

    void setInputPreferences(const InputPreferences& preferences) { m_preferences = preferences; }

    void begin(const Start& start);
    /// `ray`: through the pointer's pixel, when it was there.
    void moveTo(const PointerEvent& pointer, const core::Ray& ray);
    /// The pointer is released there.
    void setReleasePoint(const OrbitCamera::Pixel& pixel, double time);
    void end(core::StrokeEnd how = core::StrokeEnd::Kept);

    /// The model turned about the Y axis by so many radians in so many seconds, and the camera went with the hand.
    void turnModel(double angle, double seconds);
    void resetTurn() { m_turned = 0; }

    bool isOpen() const { return m_isOpen; }
    /// Of the open stroke, or the last.
    const core::StrokeSettings& settings() const { return m_settings; }
    /// Of the open stroke: where the brush is.
    const OrbitCamera::Pixel& brushAt() const { return m_brushAt; }
    /// Returns where the pointer is if the stroke is steady, else where the brush is.
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
    PointerEvent m_pointer;        ///< its place and pressure now
    OrbitCamera::Pixel m_brushAt{0, 0};
    QTimer m_rest;               ///< goes as long as a stroke with an airbrush is open
    QElapsedTimer m_sinceSample; ///< on the wall
    double m_turned = 0;         ///< of the model in the world, about Y; radians
};
} // namespace ui
