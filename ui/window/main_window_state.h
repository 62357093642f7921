#pragma once

#include "ui/actions/actions.h"
#include "ui/classroom/classroom.h"
#include "ui/settings/brush_settings.h"
#include "ui/settings/settings.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QHash>
#include <QPointer>

#include <optional>

class QLabel;
class QMenu;
class QMessageBox;

namespace ui
{
class NotificationBanner;
class BrushShapes;
class ProgressBar;
class InfoBar;

/// The state that each turn of a class begins with.
struct TurnDefaults
{
    QHash<QString, bool> switches;
    QList<core::Rgb> swatches;
    QByteArray bars;
    core::SavedView view;
};

/// What the window is made of. Gui thread.
struct MainWindow::State
{
    explicit State(MainWindow* window) : brush(window), actions(window), files(&settings, window), q(window) {}

    Settings settings;
    BrushSettings brush;
    Actions actions;
    ModelFiles files;
    MainWindow* q;
    std::unique_ptr<Viewport> spareViewport; ///< where there is no OpenGL, the viewport must stay out of the window
    Viewport* viewport = nullptr;
    BrushShapes* shapes = nullptr;
    NotificationBanner* banner = nullptr;
    InfoBar* infoBar = nullptr;
    HistoryPanel* history = nullptr;
    ModelPanel* modelPanel = nullptr;
    ProgressBar* progressBar = nullptr;
    QLabel* headsetText = nullptr;
    HeadsetActions* headset = nullptr;
    QPointer<QMessageBox> problem;
    std::function<bool()> guard, canClose, isSettled;
    bool closesLater = false;
    ModelInfo model;
    std::optional<Classroom> classroom;
    TurnDefaults turnDefaults; ///< of the class

    void buildView();
    void buildBars();
    void addPalette(const QString& title, const QString& name, Bar which);
    void buildPanels(QMenu* toggles);
    void buildStatusBar();
    template <class What> void on(const char* id, What what);
    void connectActions();
    void connectFiles();
    void connectTools();
    void connectHeadset();
    void setBusy(bool isBusy);
    void showName();
    void restore();
    void save();
};
} // namespace ui
