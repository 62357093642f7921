#pragma once

#include <QList>
#include <QWidget>

class QAction;
class QMainWindow;
class QToolButton;

namespace ui
{
class Actions;
class Settings;

/// The tools as buttons, in groups with a line between them: one column where the window is high enough, else as many
/// as it takes to show each of them. Actions that are not visible have no button. Thread: gui.
class ToolPalette : public QWidget
{
    Q_OBJECT

public:
    explicit ToolPalette(const QList<QList<QAction*>>& groups, QWidget* parent = nullptr);

    /// Writes the tools' names below their icons.
    void setShowsNames(bool showsNames);

    /// Returns the width of the present columns, and the height of the most columns that there can be.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    using Group = QList<QToolButton*>;

    QToolButton* makeButton(QAction* action);
    QSize cell() const;
    int heightOf(int columns) const;
    void arrange();

    QList<Group> m_groups;
    QList<int> m_lines; ///< y of the lines between groups
    int m_columns = 1;
    bool m_showsNames = false;
};

/// Adds it at the window's left. view.toolNames writes the names, and the settings remember that.
void addToolPalette(QMainWindow* window, Settings* settings, const Actions& actions);
} // namespace ui
