#include "ui/window/main_window.h"

#include "ui/actions/actions.h"
#include "ui/brush/brush_actions.h"
#include "ui/brush/brush_bar.h"
#include "ui/brush/brush_palette.h"
#include "ui/brush/brush_panels.h"
#include "ui/brush/brush_shapes.h"
#include "ui/brush/color_panel.h"
#include "ui/brush/preset_list.h"
#include "ui/classroom/classroom.h"
#include "ui/classroom/classroom_lock.h"
#include "ui/drawing/preview_panel.h"
#include "ui/files/file_browser.h"
#include "ui/gizmo/plane_cut_tool.h"
#include "ui/gizmo/transform_tool.h"
#include "ui/headset/partner_bar.h"
#include "ui/help/guide_window.h"
#include "ui/help/help_actions.h"
#include "ui/help/start_page.h"
#include "ui/history/history_panel.h"
#include "ui/lesson/lesson_editor.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/model/area_actions.h"
#include "ui/model/model_actions.h"
#include "ui/model/model_panel.h"
#include "ui/parts/combination_card.h"
#include "ui/parts/parts_panel.h"
#include "ui/preferences/preferences_actions.h"
#include "ui/print/print_panel.h"
#include "ui/reference/reference_actions.h"
#include "ui/scene/scene.h"
#include "ui/settings/settings.h"
#include "ui/settings/stored_brush.h"
#include "ui/shapes/solid_tool.h"
#include "ui/shapes/tube_tool.h"
#include "ui/util/error_messages.h"
#include "ui/viewport/appearance_actions.h"
#include "ui/viewport/curve_drawing.h"
#include "ui/viewport/input_actions.h"
#include "ui/viewport/view_actions.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/named.h"
#include "ui/widgets/notification_banner.h"
#include "ui/widgets/side_column.h"
#include "ui/window/info_bar.h"
#include "ui/window/status_bar.h"
#include "ui/window/tool_palette.h"
#include "ui/window/window_geometry.h"

#include <QAction>
#include <QCloseEvent>
#include <QFileInfo>
#include <QHash>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QStatusBar>
#include <QToolBar>

#include <optional>
#include <utility>

namespace ui
{
/// State that each turn of a class begins with.
struct TurnDefaults
{
    QHash<QString, bool> switches;
    QList<core::Rgb> swatches;
    QByteArray bars;
    QStringList panels;
    core::SavedView view;
};

/// The widgets and settings of the window. Thread: gui.
struct MainWindow::State
{
    explicit State(MainWindow* window) : brush(window), actions(window), files(&settings, window), q(window) {}

    Settings settings;
    BrushSettings brush;
    Actions actions;
    ModelFiles files;
    MainWindow* q;
    /// owns the viewport if there is no OpenGL, because it must not be in the window then
    std::unique_ptr<Viewport> spareViewport;
    Viewport* viewport = nullptr;
    QToolBar* options = nullptr;
    SideColumn* column = nullptr;
    BrushShapes* shapes = nullptr;
    PresetList* presets = nullptr;
    NotificationBanner* banner = nullptr;
    InfoBar* infoBar = nullptr;
    HistoryPanel* history = nullptr;
    ModelPanel* modelPanel = nullptr;
    ProgressBar* progressBar = nullptr;
    QLabel* headsetText = nullptr;
    HeadsetActions* headset = nullptr;
    StartPage* start = nullptr;
    QPointer<QMessageBox> problem;
    std::function<bool()> guard, canClose, isSettled;
    bool closesLater = false;
    ModelInfo model;
    bool hasModel = false; ///< setModel() has been called
    std::optional<Classroom> classroom;
    TurnDefaults turnDefaults; ///< used if a class is set

    void buildView();
    void buildBars();
    void breakBars();
    void buildPanels(QMenu* toggles);
    void buildStatusBar();
    template <class What> void on(const char* id, What what);
    void connectActions();
    void connectFiles();
    void connectTools();
    void setBusy(bool isBusy);
    void showName();
    double firstRadiusShare() const;
    void restore();
    void save();
};

// --- building and connecting the window

/// Creates the viewport, or a label with the reason why it cannot be shown.
void MainWindow::State::buildView()
{
    const QString unable = graphicsProblem();
    viewport = new Viewport(&brush);
    if (unable.isEmpty()) {
        q->setCentralWidget(viewport);
    } else {
        spareViewport.reset(viewport);
        auto* sentence = named(new QLabel(unable), "graphicsProblem");
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
        if (id == MenuId::Model) {
            for (const MenuId sub : {MenuId::Parts, MenuId::Area})
                actions.fill(menu->addMenu(actions.menuTitle(sub)), sub);
        }
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

    options = named(q->addToolBar(tr("Tool Options")), "toolOptions");
    options->setIconSize(bar->iconSize());
    actions.fill(options, Bar::Options);
    addToolPalette(q, &settings, actions);
}

/// Moves the tool options below the other tool bar if the window is too narrow for both.
void MainWindow::State::breakBars()
{
    if (q->toolBarArea(options) != Qt::TopToolBarArea)
        return;
    const auto* bar = q->findChild<QToolBar*>(QStringLiteral("toolBar"));
    const bool fits = bar->sizeHint().width() + options->sizeHint().width() <= q->width();
    if (q->toolBarBreak(options) != fits)
        return;
    if (fits)
        q->removeToolBarBreak(options);
    else
        q->insertToolBarBreak(options);
}

void MainWindow::State::buildPanels(QMenu* toggles)
{
    shapes = new BrushShapes(&brush, &settings, q);
    connect(shapes, &BrushShapes::refused, q, &MainWindow::showNotice);
    const auto notice = [this](const QString& sentence) { q->showNotice(sentence); };
    const auto focusModel = [this] { viewport->setFocus(); };
    column = new SideColumn(q);
    q->addDockWidget(Qt::RightDockWidgetArea, column);
    QAction* onLeft = actions.get(QStringLiteral("view.panelsLeft"));
    connect(onLeft, &QAction::toggled, q, [this](bool isLeft) {
        q->addDockWidget(isLeft ? Qt::LeftDockWidgetArea : Qt::RightDockWidgetArea, column);
    });
    connect(column, &QDockWidget::dockLocationChanged, onLeft,
            [onLeft](Qt::DockWidgetArea area) { onLeft->setChecked(area == Qt::LeftDockWidgetArea); });
    addLessonPanel(column, actions);
    addLessonEditor(column, actions);
    addBrushPanels({column, focusModel}, &brush, shapes);
    addColorPanel({column, viewport}, &brush, &settings, actions, notice);
    presets = addPresetList({column, &actions, focusModel, notice}, &brush, shapes);
    connectInputActions({column, viewport, notice}, &brush, &settings, actions);
    addPrintPanel({column, viewport}, &settings, actions);
    addPartsPanel(column, actions);
    history = addHistoryPanel(column, &settings);
    modelPanel = addModelPanel(column);
    addReferences({q, column, viewport, &files}, &settings, actions, notice);
    for (const SidePanel* panel : column->panels())
        toggles->addAction(panel->toggleViewAction());
    toggles->addSeparator();
    addFileBrowser({q, toggles, &files}, &settings, actions, notice);
    addPreview(
        q, &settings, actions.get(QStringLiteral("file.exportDrawing")), [this] { return model.name; }, toggles);
}

void MainWindow::State::buildStatusBar()
{
    progressBar = new ProgressBar(actions.get(QStringLiteral("edit.stop")));
    connect(progressBar, &ProgressBar::activeChanged, q, [this](bool isBusy) { setBusy(isBusy); });
    infoBar = new InfoBar(&brush);
    headsetText = named(new QLabel, "headsetText");
    headsetText->setTextFormat(Qt::PlainText);
    headsetText->setContentsMargins(8, 0, 8, 0);
    headsetText->hide();
    q->setStatusBar(new StatusBar);
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
    const auto request = [this](const core::ModelCommand& command) { Q_EMIT q->commandRequested(command); };
    connectModel(
        actions, q, [this]() -> const ModelInfo& { return model; }, &brush, request);
    connect(connectAreas(actions, viewport, &brush, request), &CurveDrawing::refused, q, &MainWindow::showNotice);
    connect(new TransformTool(actions, viewport), &TransformTool::requested, q, request);
    connect(new PlaneCutTool(actions, &brush, viewport), &PlaneCutTool::requested, q, request);
    connect(new TubeTool(actions, &brush, viewport), &TubeTool::requested, q, request);
    connect(new SolidTool(actions, &brush, viewport), &SolidTool::requested, q, request);
    new CombinationCard(viewport);
    connectTools();
    headset = new HeadsetActions({&actions, viewport, new PartnerBar({&actions, &brush, viewport}, q)}, q);
    connectView(actions, viewport);
    connectPreferences({q, column, &actions, &settings, &brush, viewport});
    start = connectHelp(actions, &settings, q);
    connect(start, &StartPage::fileChosen, &files, &ModelFiles::openRequested);
    connect(&files, &ModelFiles::openRequested, start, &StartPage::close);
    for (const char* id : {"edit.undo", "edit.redo"})
        actions.get(QLatin1StringView(id))->setEnabled(false);
}

void MainWindow::State::connectFiles()
{
    on("file.exportFor", [this] { files.exportFor(model); });
    on("file.quit", [this] { q->close(); });
    connect(&files, &ModelFiles::noticed, q, &MainWindow::showNotice);
}

void MainWindow::State::connectTools()
{
    connectBrush(actions, &brush);
    connect(shapes, &BrushShapes::ownModelRequested, actions.get(QStringLiteral("brush.fromModel")), &QAction::trigger);
    connectBrushPalette(q, viewport, &brush, presets, actions);
    connect(&brush, &BrushSettings::clamped, q, [this](core::Parameter parameter) {
        q->showNotice(ErrorMessages::range(parameter, brush.minOf(parameter), brush.maxOf(parameter)));
    });
}

void MainWindow::State::setBusy(bool isBusy)
{
    for (const ActionInfo& row : actionTable())
        if (row.menu == MenuId::Model || row.menu == MenuId::Parts || row.menu == MenuId::Area ||
            row.menu == MenuId::Mask)
            actions.get(QLatin1StringView(row.id))->setEnabled(!isBusy);
    for (const char* id : {"file.save", "file.saveAs", "file.saveCopy", "file.exportAs", "file.exportFor",
                           "file.exportDrawing", "file.timeLapse", "file.report", "brush.fromModel"})
        actions.get(QLatin1StringView(id))->setEnabled(!isBusy);
}

void MainWindow::State::showName()
{
    q->setWindowTitle(tr("%1[*] – Fettle").arg(model.name));
}

/// Returns the radius for a new model, as a fraction of its longest side.
double MainWindow::State::firstRadiusShare() const
{
    const ToolMemory& tools = *brush.tools();
    const double shared = settings.get(&Setting::radiusShare);
    return tools.sharesRadius() ? shared : tools.of(brush.tool()).radiusShare.value_or(shared);
}

void MainWindow::State::restore()
{
    restoreWindowGeometry(q, column, settings);
    restoreBrush(settings, &brush);
    shapes->restore();
}

void MainWindow::State::save()
{
    saveWindowGeometry(*q, *column, settings);
    storeBrush(brush, &settings);
    if (model.size.maxCoeff() > 0)
        settings.set(&Setting::radiusShare, brush.radiusShare());
}

// --- the window

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent), m_state(std::make_unique<State>(this))
{
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(tr("Fettle"));
    setWindowIcon(QIcon(QStringLiteral(":/icons/fettle.svg")));
    setDockOptions(AnimatedDocks);
    m_state->buildView();
    m_state->buildBars();
    m_state->buildStatusBar();
    m_state->connectActions();
    m_state->restore();
}

/// Hides the panels while their actions exist, and deletes the viewport while its brush exists.
MainWindow::~MainWindow()
{
    hide();
    delete takeCentralWidget();
}

Viewport* MainWindow::viewport() const
{
    return m_state->viewport;
}

BrushSettings* MainWindow::brush() const
{
    return &m_state->brush;
}

HistoryPanel* MainWindow::history() const
{
    return m_state->history;
}

ModelPanel* MainWindow::modelPanel() const
{
    return m_state->modelPanel;
}

ModelFiles* MainWindow::files() const
{
    return &m_state->files;
}

HeadsetActions* MainWindow::headset() const
{
    return m_state->headset;
}

ProgressBar* MainWindow::progress() const
{
    return m_state->progressBar;
}

QAction* MainWindow::action(const QString& id) const
{
    return m_state->actions.get(id);
}

void MainWindow::setUndoText(const QString& what)
{
    action(QStringLiteral("edit.undo"))->setText(what.isEmpty() ? tr("&Undo") : tr("&Undo %1").arg(what));
}

void MainWindow::setRedoText(const QString& what)
{
    action(QStringLiteral("edit.redo"))->setText(what.isEmpty() ? tr("&Redo") : tr("&Redo %1").arg(what));
}

void MainWindow::setCanClose(std::function<bool()> canClose)
{
    m_state->canClose = std::move(canClose);
}

void MainWindow::setIsSettled(std::function<bool()> isSettled)
{
    m_state->isSettled = std::move(isSettled);
}

void MainWindow::setGuard(std::function<bool()> guard)
{
    m_state->guard = std::move(guard);
}

const Classroom* MainWindow::classroom() const
{
    return m_state->classroom ? &*m_state->classroom : nullptr;
}

const Actions& MainWindow::commands() const
{
    return m_state->actions;
}

void MainWindow::showSaved(const ModelInfo& modelInfo)
{
    m_state->model = modelInfo;
    m_state->showName();
    m_state->infoBar->setModelInfo(modelInfo);
    showExported(modelInfo.path);
    m_state->files.setSaved(modelInfo);
}

void MainWindow::showExported(const QString& path, const QString& verdict)
{
    showNotice(verdict.isEmpty() ? tr("Saved %1.").arg(QFileInfo(path).fileName()) : verdict);
    m_state->files.setExported(path);
}

void MainWindow::setModel(const ModelInfo& modelInfo)
{
    if (std::exchange(m_state->hasModel, true)) // the first model is loaded behind the start page
        m_state->start->close();
    m_state->model = modelInfo;
    m_state->showName();
    setWindowModified(false);
    if (modelInfo.size.maxCoeff() > 0)
        m_state->brush.fitTo(modelInfo, m_state->firstRadiusShare());
    m_state->files.setOpened(modelInfo);
    m_state->infoBar->setModelInfo(modelInfo);
    m_state->viewport->showModel(modelInfo.box);
}

void MainWindow::updateModelInfo(const ModelInfo& modelInfo)
{
    m_state->model = modelInfo;
    m_state->showName();
    m_state->infoBar->setModelInfo(modelInfo);
    m_state->viewport->setBox(modelInfo.box);
    if (!m_state->brush.fits(modelInfo)) {
        m_state->brush.fitTo(modelInfo, m_state->brush.radiusShare());
        if (!m_state->viewport->navigation()->isFollowing())
            m_state->viewport->navigation()->frame();
    }
}

void MainWindow::showProblem(const QString& sentence)
{
    if (!m_state->problem || m_state->problem->isHidden()) { // an answered dialog may not have been deleted yet
        m_state->problem = new QMessageBox(QMessageBox::Warning, tr("Fettle"), {}, QMessageBox::Ok, this);
        m_state->problem->setObjectName(QStringLiteral("problem"));
        m_state->problem->setTextFormat(Qt::PlainText);
        m_state->problem->setAttribute(Qt::WA_DeleteOnClose);
        m_state->problem->open();
    }
    m_state->problem->setText(sentence);
    for (QAbstractButton* button : m_state->problem->buttons()) // removes remedies offered for the previous sentence
        if (m_state->problem->buttonRole(button) != QMessageBox::RejectRole &&
            m_state->problem->standardButton(button) == QMessageBox::NoButton)
            m_state->problem->removeButton(button);
}

void MainWindow::offerRemedy(const QString& text, const std::function<void()>& callback)
{
    if (m_state->problem)
        connect(m_state->problem->addButton(text, QMessageBox::AcceptRole), &QAbstractButton::clicked, this, callback);
}

void MainWindow::showNotice(const QString& sentence)
{
    m_state->banner->showMessage(sentence);
}

void MainWindow::setBrushModel(const QString& path)
{
    m_state->shapes->chooseModel(path);
    m_state->brush.setTool(core::Tool::Stamp);
    showNotice(tr("Stamp now uses the current shape of %1.").arg(QFileInfo(path).completeBaseName()));
}

void MainWindow::setHeadset(HeadsetState state, const QString& sentence)
{
    m_state->headset->show(state);
    m_state->headsetText->setText(sentence);
    m_state->headsetText->setVisible(state != HeadsetState::Out);
}

void MainWindow::continueClosing()
{
    if (std::exchange(m_state->closesLater, false))
        close();
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
    QMainWindow::resizeEvent(event);
    m_state->breakBars();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (m_state->guard && !m_state->guard()) {
        event->ignore();
        return;
    }
    m_state->closesLater = m_state->isSettled && !m_state->isSettled();
    if (m_state->closesLater || (m_state->canClose && !m_state->canClose())) {
        event->ignore();
        return;
    }
    m_state->save();
    event->accept();
}

// --- classes

void MainWindow::setClassroom(const Classroom& classroom)
{
    m_state->classroom = classroom;
    m_state->files.refuseDrops();
    m_state->shapes->setMayLoad(false);
    m_state->brush.offerTools(classroom.tools);
    lockWindow(this, m_state->actions, classroom);
    m_state->turnDefaults = {switchesOf(m_state->actions), findChild<ColorPanel*>()->swatches(), saveState(),
                             m_state->column->panelStates(), m_state->viewport->camera().saved()};
}

/// Resets the settings before bars and switches, because a reset shows panels and switches that a class does not have.
void MainWindow::beginTurn()
{
    const TurnDefaults& turnDefaults = m_state->turnDefaults;
    m_state->viewport->input()->finish();
    if (auto* guide = findChild<GuideWindow*>())
        guide->hide();
    m_state->settings.reset();
    restoreState(turnDefaults.bars);
    m_state->breakBars(); // the window's width may have changed since the class began
    m_state->column->setPanelStates(turnDefaults.panels);
    m_state->brush.reset();
    m_state->brush.setRadiusShare(m_state->settings.get(&Setting::radiusShare));
    findChild<ColorPanel*>()->reset(turnDefaults.swatches);
    setSwitches(m_state->actions, turnDefaults.switches);
    m_state->viewport->navigation()->setView(turnDefaults.view);
    m_state->viewport->navigation()->frame();
}
} // namespace ui
