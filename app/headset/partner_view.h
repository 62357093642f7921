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

/// What the user at the window does for the one in the headset: points, chooses, undoes, takes over, gives a lesson.
/// Thread: gui.
class PartnerView : public QObject
{
    Q_OBJECT

public:
    /// None is owned. The window may be about to close.
    PartnerView(Document* document, ui::MainWindow* window);

    /// A visit to the headset begins with the model of that number (vr::DocumentUpdate::model).
    void begin(quint64 model);
    void end();
    /// Adds what the headset shows of the partner.
    void addTo(vr::DocumentUpdate& update);

    /// The brush was changed at the window.
    void startChoiceTimer() { m_choiceTimer.start(); }
    /// The user in the headset chose the window's brush: knows it, and keeps the radius in the headset, whatever radius
    /// the window has for that tool.
    void setKnownBrush(const core::StrokeSettings& brush);
    void setAvatarRadius(double mm) { m_avatarRadius = mm; }
    bool isTakenOver() const { return m_isTakenOver; }
    /// Tells the user in the headset that only the window changes model and brush now.
    void refuse();
    void press(vr::LessonRequest button);

public Q_SLOTS:
    /// The place where the user at the window points; nothing if at none.
    void point(const std::optional<core::SurfaceHit>& place);
    /// Only the window changes the model, until this is false again or the visit ends.
    void setTakenOver(bool isTakenOver);

Q_SIGNALS:
    /// addTo() adds something else now.
    void changed();
    /// One sentence to be read in the headset.
    void noticed(const QString& sentence);
    void takenOver(bool isTakenOver);
    /// The headset has to take the window's brush again.
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
    core::StrokeSettings m_knownBrush; ///< the user in the headset knows it
    QString m_undoText, m_redoText;    ///< as they were told: the step that was undone just now is still among them
    quint64 m_radiusModel = 0;         ///< the model of the next
    double m_radiusShare = 0;          ///< of the window's brush, as it was told
    quint64 m_radiusChanges = 0;
    bool m_isRadiusNew = false;
    bool m_isStepNew = false;  ///< of a lesson, which has tools of its own
    double m_avatarRadius = 0; ///< mm; 0: not known
    QTimer m_choiceTimer;      ///< runs while the window's choice may still go on
};
} // namespace app
