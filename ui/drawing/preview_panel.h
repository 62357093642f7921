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

/// A dock with the 2D preview: front, side and top drawings of the model, updated while it changes. The panel makes no
/// drawings: drawingRequested() says when it needs them, and setDrawing() shows one. Thread: gui.
class PreviewPanel : public QDockWidget
{
    Q_OBJECT

public:
    /// `exporting`: the action that writes a sheet; its button is beside the choices. Precondition: the settings
    /// outlive the panel.
    PreviewPanel(Settings* settings, QAction* exporting, QWidget* parent = nullptr);

    /// Asks for the file of a sheet and emits exportRequested(). `modelName`: proposed name.
    void exportAs(const QString& modelName);

public Q_SLOTS:
    void setDrawing(ui::SharedDrawing drawing);

Q_SIGNALS:
    /// The panel has become visible or hidden, or needs shaded drawings now or no longer.
    void drawingRequested(bool isSeen, bool shaded);
    /// The user has chosen a file and agreed to overwriting. Its suffix is the format: pdf, svg or png.
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

/// Adds the panel at the window's bottom, hidden at first, and its toggle to the menu `toggles`. The action `exporting`
/// asks for the file of a sheet.
void addPreview(QMainWindow* window, Settings* settings, QAction* exporting, const std::function<QString()>& modelName,
                QMenu* toggles);
} // namespace ui
