#pragma once

#include "core/operations/starter_models.h"
#include "ui/classroom/cover_panel.h"

#include <QList>
#include <QStringList>

#include <optional>

class QButtonGroup;
class QLineEdit;
class QListWidget;
class QPushButton;
class QToolButton;

namespace ui
{
class Actions;
class TileRows;
struct Classroom;
struct LessonCard;

/// Asks who sculpts next, and with what to begin, before a turn. Thread: gui.
class PupilNamePanel : public CoverPanel
{
    Q_OBJECT

public:
    /// The starters look as their actions do, in the class's order.
    PupilNamePanel(const Classroom& classroom, const Actions& actions, QWidget* over);

    /// Shows the panel with no name entered, and with the lesson, or else the first starter, chosen.
    void open();
    /// Offers a lesson, too: before the starters, and chosen at first.
    void offerLesson(const LessonCard& lesson);
    /// Marks the pupils who have had a turn today.
    void setHadTurn(const QStringList& pupils);

Q_SIGNALS:
    /// The name has no space at its ends, and is not empty. No starter: the lesson.
    void begun(const QString& pupil, const std::optional<core::Starter>& starter);

protected:
    bool event(QEvent* event) override;

private:
    QWidget* content(const Classroom& classroom, const Actions& actions);
    void addPupils(const QStringList& names);
    void addTiles(const QList<core::Starter>& starters, const Actions& actions);
    QToolButton* addTile(int id, const QString& text, const QIcon& icon);
    void begin();

    QLineEdit* m_name;
    QListWidget* m_pupils; ///< shown if the class has names
    TileRows* m_tiles;
    QButtonGroup* m_starters; ///< by core::Starter, and the lesson
    QPushButton* m_begin;
};
} // namespace ui
