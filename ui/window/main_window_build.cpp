// What the main window is made of, and which part hears which.

#include "ui/window/main_window_state.h"

#include "ui/brush/brush_actions.h"
#include "ui/brush/brush_bar.h"
#include "ui/brush/brush_panels.h"
#include "ui/brush/brush_shapes.h"
#include "ui/brush/color_panel.h"
#include "ui/drawing/preview_panel.h"
#include "ui/files/file_browser.h"
#include "ui/headset/partner_bar.h"
#include "ui/help/help_actions.h"
#include "ui/help/start_page.h"
#include "ui/history/history_panel.h"
#include "ui/lesson/lesson_editor.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/model/model_actions.h"
#include "ui/model/model_panel.h"
#include "ui/preferences/preferences_actions.h"
#include "ui/print/print_panel.h"
#include "ui/reference/reference_actions.h"
#include "ui/scene/scene.h"
#include "ui/util/error_messages.h"
#include "ui/viewport/appearance_actions.h"
#include "ui/viewport/input_actions.h"
#include "ui/viewport/view_actions.h"
#include "ui/widgets/notification_banner.h"
#include "ui/window/info_bar.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>

namespace ui
{
/// The viewport, or a sentence in its place.
void MainWindow::State::buildView()
{
    const QString unable = graphicsProblem();
    viewport = new Viewport(&brush);
    if (unable.isEmpty()) {
        q->setCentralWidget(viewport);
    } else {
        spareViewport.reset(viewport);
        auto* sentence = new QLabel(unable);
        sentence->setObjectName(QStringLiteral("graphicsProblem"));
        sentence->setAlignment(Qt::AlignCenter);
        sentence->setWordWrap(true);
        q->setCentralWidget(sentence);
    }
    banner = new NotificationBanner(q->centralWidget());
    if (q->centralWidget() == viewport)
        banner->stayAbove(viewport->scaleBar());
}

void MainWindow::State::buildBars()
{
    for (const MenuId id :
         {MenuId::File, MenuId::Edit, MenuId::Sculpt, MenuId::Model, MenuId::View, MenuId::Vr, MenuId::Help}) {
        QMenu* menu = q->menuBar()->addMenu(actions.menuTitle(id));
        if (id == MenuId::Sculpt) {
            for (const MenuId sub : {MenuId::Tool, MenuId::Mask})
                actions.fill(menu->addMenu(actions.menuTitle(sub)), sub);
        }
        actions.fill(menu, id);
        if (id == MenuId::File)
            files.addMenus(menu, actions);
        if (id != MenuId::View)
            continue;
        actions.fill(menu->addMenu(actions.menuTitle(MenuId::Turn)), MenuId::Turn);
        addAppearanceActions(actions, viewport, &settings, menu);
        buildPanels(menu->addMenu(tr("&Panels")));
    }

    auto* bar = q->addToolBar(tr("Tool Bar"));
    bar->setObjectName(QStringLiteral("toolBar"));
    bar->setIconSize(QSize(22, 22));
    actions.fill(bar, Bar::Top);
    bar->addSeparator();
    auto* brushBar = new BrushBar(&brush);
    bar->addWidget(brushBar);
    connect(brushBar, &BrushBar::entered, viewport, qOverload<>(&Viewport::setFocus));

    addPalette(tr("Tool Palette"), QStringLiteral("toolPalette"), Bar::Tools);
    q->addToolBarBreak(Qt::LeftToolBarArea); // all in one column would not fit a small screen
    addPalette(tr("Tool Options"), QStringLiteral("toolOptions"), Bar::Options);
}

void MainWindow::State::addPalette(const QString& title, const QString& name, Bar which)
{
    auto* palette = new QToolBar(title);
    palette->setObjectName(name);
    palette->setIconSize(QSize(26, 26));
    actions.fill(palette, which);
    q->addToolBar(Qt::LeftToolBarArea, palette);
}

void MainWindow::State::buildPanels(QMenu* toggles)
{
    shapes = new BrushShapes(&brush, &settings, q);
    connect(shapes, &BrushShapes::refused, q, &MainWindow::showNotice);
    addBrushPanels({q, toggles, [this] { viewport->setFocus(); }}, &brush, shapes);
    connectInputActions({q, toggles, viewport, [this](const QString& word) { q->showNotice(word); }}, &brush, &settings,
                        actions);
    addColorPanel({q, toggles, viewport}, &brush, &settings, actions,
                  [this](const QString& word) { q->showNotice(word); });
    history = addHistoryPanel(q, &settings, toggles);
    modelPanel = addModelPanel(q, toggles);
    addPrintPanel({q, toggles, viewport}, &settings, actions);
    addLessonPanel({q, toggles}, actions);
    addLessonEditor({q, toggles}, actions);
    addFileBrowser({q, toggles, &files}, &settings, actions, [this](const QString& word) { q->showNotice(word); });
    addReferences({q, toggles, viewport, &files}, &settings, actions,
                  [this](const QString& word) { q->showNotice(word); });
    addPreview(
        q, &settings, actions.get(QStringLiteral("file.exportDrawing")), [this] { return model.name; }, toggles);
}

void MainWindow::State::buildStatusBar()
{
    progressBar = new ProgressBar(actions.get(QStringLiteral("edit.stop")));
    connect(progressBar, &ProgressBar::activeChanged, q, [this](bool isBusy) { setBusy(isBusy); });
    infoBar = new InfoBar(&brush);
    headsetText = new QLabel;
    headsetText->setObjectName(QStringLiteral("headsetText"));
    headsetText->setTextFormat(Qt::PlainText);
    headsetText->setContentsMargins(8, 0, 8, 0);
    headsetText->hide();
    q->statusBar()->addPermanentWidget(headsetText);
    q->statusBar()->addPermanentWidget(progressBar);
    q->statusBar()->addPermanentWidget(infoBar);
}

template <class What> void MainWindow::State::on(const char* id, What what)
{
    connect(actions.get(QLatin1StringView(id)), &QAction::triggered, q, what);
}

void MainWindow::State::connectActions()
{
    connectFiles();
    connectModel(
        actions, q, [this]() -> const ModelInfo& { return model; }, &brush,
        [this](const core::ModelCommand& command) { Q_EMIT q->commandRequested(command); });
    connectTools();
    connectHeadset();
    connectView(actions, viewport);
    connectPreferences({q, &actions, &settings, &brush, viewport});
    StartPage* start = connectHelp(actions, &settings, q);
    connect(start, &StartPage::fileChosen, &files, &ModelFiles::openRequested);
    connect(&files, &ModelFiles::openRequested, start, &StartPage::close);
    for (const char* id : {"edit.undo", "edit.redo"})
        actions.get(QLatin1StringView(id))->setEnabled(false);
}

void MainWindow::State::connectFiles()
{
    on("file.exportFor", [this] { files.exportFor(model); });
    on("edit.classroom", [this] {
        askForClassroom(q, actions, settings.lastFolder(),
                        [this](const ClassroomDraft& draft) { Q_EMIT q->classroomDrafted(draft); });
    });
    on("file.quit", [this] { q->close(); });
    connect(&files, &ModelFiles::noticed, q, &MainWindow::showNotice);
}

void MainWindow::State::connectTools()
{
    connectBrush(actions, &brush);
    connect(shapes, &BrushShapes::ownModelRequested, actions.get(QStringLiteral("brush.fromModel")), &QAction::trigger);
    connect(&brush, &BrushSettings::clamped, q, [this](core::Parameter parameter) {
        q->showNotice(ErrorMessages::range(parameter, brush.minOf(parameter), brush.maxOf(parameter)));
    });
}

void MainWindow::State::connectHeadset()
{
    headset = new HeadsetActions({&actions, viewport, new PartnerBar({&actions, &brush, viewport}, q)}, q);
}
} // namespace ui
