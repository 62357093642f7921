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

/// The tools as buttons, in groups with lines between them. Uses one column if the window is high enough, else as few
/// columns as show all tools. Invisible actions have no button. Thread: gui.
class ToolPalette : public QWidget
{
    Q_OBJECT

public:
    explicit ToolPalette(const QList<QList<QAction*>>& groups, QWidget* parent = nullptr);

    /// Shows or hides the tools' names below their icons.
    void setShowsNames(bool showsNames);

    /// Returns the width of the present columns, and the height with the largest number of columns.
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
    QList<int> m_lines; ///< y of the lines between groups, pixels
    int m_columns = 1;
    bool m_showsNames = false;
};

/// Adds the tool palette at the window's left. The action view.toolNames shows the names, and the settings store its
/// state.
void addToolPalette(QMainWindow* window, Settings* settings, const Actions& actions);
} // namespace ui
