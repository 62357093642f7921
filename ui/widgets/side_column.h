#pragma once

#include "ui/widgets/side_panel.h"

#include <QDockWidget>
#include <QList>
#include <QStringList>

class QVBoxLayout;

namespace ui
{
/// Column of panels beside the model, which scrolls if the panels are higher than the window. Its width is that of its
/// widest panel, open or not, so that the model does not move when panels open. Hidden if all panels are hidden. The
/// mouse wheel changes a control only while the control has the focus, and scrolls otherwise. Thread: gui.
class SideColumn : public QDockWidget
{
    Q_OBJECT

public:
    explicit SideColumn(QWidget* parent = nullptr);

    /// Adds a panel below the others, and takes ownership of its content.
    SidePanel* add(const QString& name, const QString& title, QWidget* content,
                   SidePanel::State first = SidePanel::State::Folded);
    const QList<SidePanel*>& panels() const { return m_panels; }

    /// Returns one entry per panel, "name state", for the settings.
    QStringList panelStates() const;
    /// Restores the states of panels. Panels without an entry keep their state. Unknown names are ignored.
    void setPanelStates(const QStringList& states);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void scrollTo(SidePanel* panel);
    void showWhatIsOpen();

    class Area;
    Area* m_area;
    QVBoxLayout* m_rows;
    QList<SidePanel*> m_panels;
};
} // namespace ui
