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

/// A page of starters, recent files and lessons, over the middle of a widget. It closes when something is chosen, on
/// Esc, or on a press outside, which the widget below handles as usual. Thread: gui.
class StartPage : public QFrame
{
    Q_OBJECT

public:
    /// Precondition: `actions` and `settings` outlive the page.
    StartPage(const Actions& actions, Settings* settings, QWidget* over);

    /// Adds lessons to those offered; initially there are none.
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
