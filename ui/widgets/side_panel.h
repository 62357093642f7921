#pragma once

#include <QWidget>

class QAction;
class QToolButton;

namespace ui
{
/// A section of the side column: a header that folds it, and its content below. Thread: gui.
class SidePanel : public QWidget
{
    Q_OBJECT

public:
    enum class State { Open, Folded, Hidden };

    /// Takes ownership of the content, which gets its preferred height. Content whose vertical size policy is neither
    /// Fixed nor Maximum shares the column's remaining height, but gets at least 12 lines or its full height.
    SidePanel(const QString& name, const QString& title, QWidget* content);

    /// Returns true if the content shares the column's remaining height.
    bool grows() const { return m_grows; }
    State state() const;
    void setState(State state);
    /// Returns the menu action that shows or hides the panel.
    QAction* toggleViewAction() const { return m_toggle; }
    /// Hides the panel until the action is triggered, which opens it.
    void openBy(const QAction* action);
    /// Opens the panel and requests scrolling to it.
    void bringForward();

Q_SIGNALS:
    /// The panel was opened and should be scrolled to.
    void broughtForward();
    /// The header was clicked with Ctrl: all other panels should be folded.
    void soloRequested();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QWidget* makeHeader(const QString& title);
    void clickHeader();
    void showFold();

    QToolButton* m_header;
    QWidget *m_headerRow, *m_body;
    bool m_grows; ///< shares the column's remaining height
    QAction* m_toggle;
};
} // namespace ui
