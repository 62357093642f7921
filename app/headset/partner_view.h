#pragma once

#include "vr/sculpt/document_port.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <optional>

namespace ui
{
class LessonPanel;
class MainWindow;
} // namespace ui

namespace app
{
class Document;

/// The actions of the desktop user for the headset user: points, chooses brushes, undoes, takes over and gives lessons.
/// Thread: gui.
class PartnerView : public QObject
{
    Q_OBJECT

public:
    /// Owns none of the arguments. The window may be closing.
    PartnerView(Document* document, ui::MainWindow* window);

    /// Begins a visit. `model`: number of the present model (vr::DocumentUpdate::model).
    void begin(quint64 model);
    void end();
    /// Adds the partner's state to an update for the headset.
    void addTo(vr::DocumentUpdate& update);

    /// Starts, or starts again, the delay after which the window's brush is announced in the headset.
    void startChoiceTimer() { m_choiceTimer.start(); }
    /// Records a brush that the headset user has chosen, so that it is not announced. The headset keeps its own radius,
    /// even if the window has another radius for that tool.
    void setKnownBrush(const core::StrokeSettings& brush);
    void setAvatarRadius(double mm) { m_avatarRadius = mm; }
    bool isTakenOver() const { return m_isTakenOver; }
    /// Tells the headset user that only the window may change model and brush at present.
    void refuse();
    void press(vr::LessonRequest button);

public Q_SLOTS:
    /// Sets the place at which the desktop user points; nullopt: the user points at nothing.
    void point(const std::optional<core::SurfaceHit>& place);
    /// Sets whether only the window may change the model. Has no effect outside a visit; each visit begins with false.
    void setTakenOver(bool isTakenOver);

Q_SIGNALS:
    /// Emitted when addTo() would add something different.
    void changed();
    /// Emitted with one sentence to be shown in the headset.
    void noticed(const QString& sentence);
    void takenOver(bool isTakenOver);
    /// Emitted by refuse(): the headset must return to the window's brush.
    void brushRefused();

private:
    void checkRadius(quint64 model);
    void onLessonChanged();
    void announceChoice();
    void announceHistory(const QString& sentence);

    Document* m_document;
    ui::MainWindow* m_window;
    QPointer<ui::LessonPanel> m_lessons;
    bool m_isVisited = false;
    bool m_isTakenOver = false;
    std::optional<vr::PointedPlace> m_pointed;
    std::optional<core::Sphere> m_teacher;
    std::optional<vr::LessonPanel> m_lesson;
    core::StrokeSettings m_knownBrush; ///< the window's brush as last announced to the headset, or as last chosen there
    /// Names of the steps to undo and to redo at the last addTo(). When an undo or redo is announced, the history may
    /// have changed already.
    QString m_undoText, m_redoText;
    quint64 m_radiusModel = 0; ///< model to which m_radiusShare belongs
    double m_radiusShare = 0;  ///< BrushSettings::radiusShare() of the window at the last update
    quint64 m_radiusChanges = 0;
    bool m_isRadiusNew = false;
    bool m_isStepNew = false;  ///< whether a lesson has entered a new step, which selects tools
    double m_avatarRadius = 0; ///< radius of the headset's brush, mm; 0: unknown
    QTimer m_choiceTimer;      ///< runs until the window's brush has not changed for a while
};
} // namespace app
