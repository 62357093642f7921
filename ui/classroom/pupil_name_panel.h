#pragma once

#include "core/operations/starter_models.h"
#include "ui/classroom/cover_panel.h"

#include <QList>
#include <QStringList>

class QButtonGroup;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace ui
{
class Actions;
struct Classroom;

/// Asks who sculpts next, and with what to begin, before a turn. Thread: gui.
class PupilNamePanel : public CoverPanel
{
    Q_OBJECT

public:
    /// The starters look as their actions do, in the class's order.
    PupilNamePanel(const Classroom& classroom, const Actions& actions, QWidget* over);

    /// Without a name, and with the first starter.
    void open();
    /// Marks the pupils who have had a turn today.
    void setHadTurn(const QStringList& pupils);

Q_SIGNALS:
    /// The name has no space at its ends, and is not empty.
    void begun(const QString& pupil, core::Starter starter);

protected:
    bool event(QEvent* event) override;

private:
    QWidget* content(const Classroom& classroom, const Actions& actions);
    void addPupils(const QStringList& names);
    QWidget* tiles(const QList<core::Starter>& starters, const Actions& actions);
    void begin();

    QLineEdit* m_name;
    QListWidget* m_pupils;    ///< shown if the class has names
    QButtonGroup* m_starters; ///< by core::Starter
    QPushButton* m_begin;
};
} // namespace ui
