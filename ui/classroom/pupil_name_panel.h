#pragma once

#include "core/primitives/starter_models.h"
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

/// Asks before a turn for the pupil's name and for the starter or lesson. Thread: gui.
class PupilNamePanel : public CoverPanel
{
    Q_OBJECT

public:
    /// The starters have the icons of their actions and the class's order.
    PupilNamePanel(const Classroom& classroom, const Actions& actions, QWidget* over);

    /// Shows the panel with an empty name. The lesson is preselected, or the first starter if there is no lesson.
    void open();
    /// Adds a lesson before the starters and preselects it.
    void offerLesson(const LessonCard& lesson);
    /// Marks the pupils who have had a turn today.
    void setHadTurn(const QStringList& pupils);

Q_SIGNALS:
    /// The user has confirmed. `pupil`: not empty, without space at its ends. `starter`: nullopt for the lesson.
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
    QListWidget* m_pupils; ///< visible if the class has names
    TileRows* m_tiles;
    QButtonGroup* m_starters; ///< ids: core::Starter, or the lesson's tile
    QPushButton* m_begin;
};
} // namespace ui
