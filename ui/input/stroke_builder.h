#pragma once

#include "ui/input/pointer_event.h"
#include "ui/settings/brush_settings.h"
#include "ui/settings/preferences.h"

#include "core/stroke/stroke.h"

#include <QObject>

namespace ui
{
/// Makes a stroke of what the hand does. A steady stroke hangs on a string behind the hand and comes to where the hand
/// is when it ends. Where the model turns under the hand, a resting hand goes on. Gui thread.
class StrokeMaker : public QObject
{
    Q_OBJECT

public:
    /// A press, with what was set then.
    struct Start
    {
        PointerEvent hand;
        core::Ray ray; ///< through its pixel
        core::StrokeSettings settings;
        double string = 0; ///< in pixels; 0: the brush is where the hand is
    };

    /// Neither is owned.
    StrokeMaker(const BrushSettings* brush, const OrbitCamera* camera, QObject* parent = nullptr);

    void setHabits(const HandHabits& habits) { m_habits = habits; }

    void begin(const Start& start);
    /// `ray`: through the hand's pixel, when it was there.
    void follow(const PointerEvent& hand, const core::Ray& ray);
    /// The hand lets go there.
    void comeTo(const OrbitCamera::Pixel& pixel, double time);
    void end();

    /// The model turned about the Y axis by so many radians in so many seconds, and the camera went with the hand.
    void turnModel(double angle, double seconds);
    /// By how much the model stands turned in the world, about Y; radians.
    double turned() const { return m_turned; }
    void forgetTurn() { m_turned = 0; }

    bool isOpen() const { return m_isOpen; }
    /// Of the open stroke, or the last.
    const core::StrokeSettings& settings() const { return m_settings; }
    /// Of the open stroke: where the brush is.
    const OrbitCamera::Pixel& brushAt() const { return m_brushAt; }
    /// And where the hand is, if the brush hangs on a string; else where the brush is.
    const OrbitCamera::Pixel& handAt() const { return m_string > 0 ? m_hand.pixel : m_brushAt; }

Q_SIGNALS:
    void began(const core::StrokeSettings& settings);
    void sampled(const core::StrokeSample& sample);
    void ended();

private:
    void sample(const core::Ray& ray);

    const BrushSettings* m_brush;
    const OrbitCamera* m_camera;
    HandHabits m_habits;
    bool m_isOpen = false;
    core::StrokeSettings m_settings;
    double m_string = 0; ///< pixels
    PointerEvent m_hand; ///< where it is now and how hard it presses
    OrbitCamera::Pixel m_brushAt{0, 0};
    double m_turned = 0;
};

/// Of a dab that is to add a ball and do nothing else.
core::StrokeSettings addingDab(core::StrokeSettings settings);
} // namespace ui
