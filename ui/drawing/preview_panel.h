#pragma once

#include "ui/drawing/drawing_canvas.h"

#include <QDockWidget>

#include <functional>

class QAction;
class QBoxLayout;
class QComboBox;
class QLabel;
class QMainWindow;
class QMenu;
class QToolButton;

namespace ui
{
class Settings;

/// The 2D preview: the model as front, side and top drawings while it changes. Makes no drawing: it says by
/// drawingRequested() when it can be seen, and shows what it is given. Thread: gui.
class PreviewPanel : public QDockWidget
{
    Q_OBJECT

public:
    /// `exporting`: the command that writes a sheet; it stands beside the choices. The settings must outlive the panel.
    PreviewPanel(Settings* settings, QAction* exporting, QWidget* parent = nullptr);

    /// Asks where a sheet of the model named so shall be written.
    void exportAs(const QString& modelName);

public Q_SLOTS:
    void setDrawing(ui::SharedDrawing drawing);

Q_SIGNALS:
    /// The panel came into sight or left it, or needs colours now, or no more.
    void drawingRequested(bool isSeen, bool shaded);
    /// The dialog has asked about overwriting. The ending says the format: pdf, svg or png.
    void exportRequested(const QString& path, const QString& modelName, bool shaded);

private:
    QWidget* content(QAction* exporting);
    QBoxLayout* controls(QAction* exporting);
    QComboBox* choiceBox(const QString& name, const QString& text, const QString& tip, const QStringList& words,
                         int index);
    void show(const DrawingSettings& options);
    void choose();

    Settings* m_settings;
    DrawingSettings m_options;
    bool m_isSeen = false;
    QComboBox *m_sides = nullptr, *m_style = nullptr;
    QToolButton* m_dimensions = nullptr;
    QLabel* m_note = nullptr;
    DrawingCanvas* m_canvas = nullptr;
};

/// The panel at the window's bottom, hidden at first, with an entry in `toggles`. `exporting` asks where the model is
/// to be drawn to.
void addPreview(QMainWindow* window, Settings* settings, QAction* exporting, const std::function<QString()>& modelName,
                QMenu* toggles);
} // namespace ui
