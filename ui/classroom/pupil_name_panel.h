#pragma once

#include "core/operations/starter_models.h"
#include "ui/classroom/cover_panel.h"

#include <QList>

class QButtonGroup;
class QLineEdit;
class QPushButton;

namespace ui
{
class Actions;

/// Asks who sculpts next, and with what to begin, before a turn. Thread: gui.
class PupilNamePanel : public CoverPanel
{
    Q_OBJECT

public:
    static constexpr int maxNameLength = 40; ///< characters

    /// The starters look as their actions do, in that order.
    PupilNamePanel(const QList<core::Starter>& starters, const Actions& actions, QWidget* over);

    /// Without a name, and with the first starter.
    void open();

Q_SIGNALS:
    /// The name has no space at its ends, and is not empty.
    void begun(const QString& pupil, core::Starter starter);

protected:
    bool event(QEvent* event) override;

private:
    QWidget* content(const QList<core::Starter>& starters, const Actions& actions);
    QWidget* tiles(const QList<core::Starter>& starters, const Actions& actions);
    void begin();

    QLineEdit* m_name;
    QButtonGroup* m_starters; ///< by core::Starter
    QPushButton* m_begin;
};
} // namespace ui
