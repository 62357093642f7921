#pragma once

#include "ui/widgets/side_panel.h"

#include <QDockWidget>
#include <QList>
#include <QStringList>

class QVBoxLayout;

namespace ui
{
/// Column of panels beside the model, which scrolls if they are higher than the window. As wide as its widest
/// panel, open or not, so that the model does not move when panels come and go; gone when all are hidden. The wheel
/// turns a control only while that has the keys' focus, and scrolls otherwise. Thread: gui.
class SideColumn : public QDockWidget
{
    Q_OBJECT

public:
    explicit SideColumn(QWidget* parent = nullptr);

    /// Adds a panel below the others, and takes its content.
    SidePanel* add(const QString& name, const QString& title, QWidget* content,
                   SidePanel::State first = SidePanel::State::Folded);
    const QList<SidePanel*>& panels() const { return m_panels; }

    /// Returns one entry a panel, "name state", to be remembered.
    QStringList panelStates() const;
    /// Panels that it does not name keep their state. Unknown names are ignored.
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
