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

    /// Takes the content, which gets the height that it asks for. A content without a fixed or a largest height (by its
    /// size policy) shares what the column has left, and is never lower than a few lines.
    SidePanel(const QString& name, const QString& title, QWidget* content);

    /// Returns whether the content shares what the column has left.
    bool grows() const { return m_grows; }
    State state() const;
    void setState(State state);
    /// Shows or hides the panel: the entry of a menu.
    QAction* toggleViewAction() const { return m_toggle; }
    /// Hides the panel until the action opens it.
    void openBy(const QAction* action);
    /// Opens the panel and asks for a place in sight.
    void bringForward();

Q_SIGNALS:
    /// The panel was opened and wants to be scrolled to.
    void broughtForward();
    /// The header was clicked with Ctrl: all others are to be folded.
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
    bool m_grows; ///< takes what the column has left
    QAction* m_toggle;
};
} // namespace ui
