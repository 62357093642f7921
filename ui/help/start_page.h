#pragma once

#include <QFrame>

class QHBoxLayout;
class QLabel;
class QScrollArea;

namespace ui
{
class Actions;
class RecentFiles;
class Settings;
struct LessonCard;

/// What to begin with: a starter, a recent file, a lesson. Lies over the middle of a widget until something is chosen,
/// Esc, or a press beside it, which is that widget's as ever. Thread: gui.
class StartPage : public QFrame
{
    Q_OBJECT

public:
    /// The actions and the settings must outlive it.
    StartPage(const Actions& actions, Settings* settings, QWidget* over);

    /// That can be begun with; at first there are none.
    void setLessons(const QList<LessonCard>& lessons);

    void open();
    void close();

Q_SIGNALS:
    void fileChosen(const QString& path);
    void lessonChosen(const QString& name);
    void guideRequested();

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLayout* head();
    QLayout* starters();
    QLayout* recent();
    QLayout* foot();
    void place();

    const Actions& m_actions;
    Settings* m_settings;
    QWidget* m_over;
    QScrollArea* m_area;
    RecentFiles* m_recent;
    QLabel* m_lessonsHead;
    QHBoxLayout* m_lessons;
};
} // namespace ui
