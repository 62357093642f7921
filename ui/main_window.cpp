#include "main_window.h"

#include "actions.h"
#include "banner.h"
#include "brush_actions.h"
#include "brush_bar.h"
#include "brush_panels.h"
#include "busy_bar.h"
#include "color_panel.h"
#include "facts_bar.h"
#include "files_panel.h"
#include "hand_actions.h"
#include "help_actions.h"
#include "history_panel.h"
#include "look_actions.h"
#include "messages.h"
#include "model_actions.h"
#include "model_files.h"
#include "model_panel.h"
#include "preferences_actions.h"
#include "preview_panel.h"
#include "print_panel.h"
#include "reference_actions.h"
#include "scene.h"
#include "settings.h"
#include "start_page.h"
#include "view_actions.h"
#include "viewport.h"
#include "window_place.h"

#include <QAction>
#include <QCloseEvent>
#include <QDir>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPointer>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolBar>

#include <utility>

namespace ui
{
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
    Banner* banner = nullptr;
    FactsBar* facts = nullptr;
    HistoryPanel* history = nullptr;
    ModelPanel* modelPanel = nullptr;
    BusyBar* busy = nullptr;
    QPointer<QMessageBox> problem;
    std::function<bool()> mayClose, isSettled;
    bool closesLater = false;
    ModelFacts model;

    void buildView();
    void buildBars();
    void buildPanels(QMenu* toggles);
    void buildStatusBar();
    template <class What> void on(const char* id, What what);
    void connectActions();
    void connectFiles();
    void connectTools();
    void setBusy(bool isBusy);
    void showName();
    void restore();
    void save();
};

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
    banner = new Banner(q->centralWidget());
}

void MainWindow::State::buildBars()
{
    for (const MenuId id : {MenuId::File, MenuId::Edit, MenuId::Sculpt, MenuId::Model, MenuId::View, MenuId::Vr, MenuId::Help}) {
        QMenu* menu = q->menuBar()->addMenu(actions.menuTitle(id));
        actions.fill(menu, id);
        if (id == MenuId::File)
            files.addMenus(menu, actions);
        if (id != MenuId::View)
            continue;
        addLooks(actions, viewport, &settings, menu);
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

    auto* palette = new QToolBar(tr("Tool Palette"));
    palette->setObjectName(QStringLiteral("toolPalette"));
    palette->setIconSize(QSize(26, 26));
    actions.fill(palette, Bar::Palette);
    q->addToolBar(Qt::LeftToolBarArea, palette);
}

void MainWindow::State::buildPanels(QMenu* toggles)
{
    addBrushPanels(q, &brush, toggles, [this] { viewport->setFocus(); });
    connectHand({q, toggles, viewport, [this](const QString& word) { q->showNotice(word); }}, &brush, &settings, actions);
    addColorPanel({q, toggles, viewport}, &brush, &settings, actions, [this](const QString& word) { q->showNotice(word); });
    history = addHistoryPanel(q, &settings, toggles);
    modelPanel = addModelPanel(q, toggles);
    addPrintPanel({q, toggles, viewport}, &settings, actions);
    addFilesPanel({q, toggles, &files}, &settings, actions, [this](const QString& word) { q->showNotice(word); });
    addReferences({q, toggles, viewport, &files}, &settings, actions, [this](const QString& word) { q->showNotice(word); });
    addPreview(q, &settings, actions.get(QStringLiteral("file.exportDrawing")), [this] { return model.name; }, toggles);
}

void MainWindow::State::buildStatusBar()
{
    busy = new BusyBar(actions.get(QStringLiteral("edit.stop")));
    facts = new FactsBar(&brush);
    q->statusBar()->addPermanentWidget(busy);
    q->statusBar()->addPermanentWidget(facts);
}

template <class What> void MainWindow::State::on(const char* id, What what)
{
    connect(actions.get(QLatin1StringView(id)), &QAction::triggered, q, what);
}

void MainWindow::State::connectActions()
{
    connectFiles();
    connectModel(actions, q, [this]() -> const ModelFacts& { return model; }, &brush,
                 [this](const core::ModelCommand& command) { Q_EMIT q->commandRequested(command); });
    connectTools();
    on("edit.stop", [this] { Q_EMIT q->stopRequested(); });
    connectView(actions, viewport);
    connectPreferences({q, &actions, &settings, &brush, viewport});
    StartPage* start = connectHelp(actions, &settings, q);
    connect(start, &StartPage::fileChosen, q, &MainWindow::openRequested);
    connect(q, &MainWindow::openRequested, start, &StartPage::close);
    for (const char* id : {"edit.undo", "edit.redo"})
        actions.get(QLatin1StringView(id))->setEnabled(false);
}

void MainWindow::State::connectFiles()
{
    on("file.exportFor", [this] { files.exportFor(model); });
    on("file.quit", [this] { q->close(); });
    connect(&files, &ModelFiles::openRequested, q, &MainWindow::openRequested);
    connect(&files, &ModelFiles::starterRequested, q, &MainWindow::starterRequested);
    connect(&files, &ModelFiles::saveRequested, q, &MainWindow::saveRequested);
    connect(&files, &ModelFiles::exportRequested, q, &MainWindow::exportRequested);
    connect(&files, &ModelFiles::insertRequested, q, &MainWindow::insertRequested);
    connect(&files, &ModelFiles::renamed, q, &MainWindow::modelRenamed);
    connect(&files, &ModelFiles::gone, q, &MainWindow::modelFileGone);
    connect(&files, &ModelFiles::noticed, q, &MainWindow::showNotice);
}

void MainWindow::State::connectTools()
{
    connectBrush(actions, &brush);
    connect(&brush, &BrushSettings::clamped, q, [this](core::Parameter parameter) {
        q->showNotice(Messages::range(parameter, brush.minOf(parameter), brush.maxOf(parameter)));
    });
}

void MainWindow::State::setBusy(bool isBusy)
{
    for (const ActionInfo& row : actionTable())
        if (row.menu == MenuId::Model)
            actions.get(QLatin1StringView(row.id))->setEnabled(!isBusy);
    for (const char* id : {"file.save", "file.saveAs", "file.saveCopy", "file.exportAs", "file.exportFor", "file.exportDrawing"})
        actions.get(QLatin1StringView(id))->setEnabled(!isBusy);
}

void MainWindow::State::showName()
{
    q->setWindowTitle(tr("%1[*] – Fettle").arg(model.name));
}

void MainWindow::State::restore()
{
    restorePlace(q, settings);
    for (const core::Parameter parameter : storedParameters)
        brush.setValue(parameter, settings.value(parameter));
}

void MainWindow::State::save()
{
    keepPlace(*q, settings);
    for (const core::Parameter parameter : storedParameters)
        settings.setValue(parameter, brush.value(parameter));
    if (model.size.maxCoeff() > 0)
        settings.setRadiusShare(brush.radiusShare());
}

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent), m_state(std::make_unique<State>(this))
{
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(tr("Fettle"));
    setWindowIcon(QIcon(QStringLiteral(":/icons/fettle.svg")));
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    m_state->buildView();
    m_state->buildBars();
    m_state->buildStatusBar();
    m_state->connectActions();
    m_state->restore();
}

/// The viewport goes while the brush that it looks at is there, and panels hide while their commands are.
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

core::StrokeSettings MainWindow::strokeSettings() const
{
    return m_state->brush.stroke();
}

void MainWindow::setMayClose(std::function<bool()> mayClose)
{
    m_state->mayClose = std::move(mayClose);
}

void MainWindow::setIsSettled(std::function<bool()> isSettled)
{
    m_state->isSettled = std::move(isSettled);
}

bool MainWindow::askToDiscard(const std::function<void()>& goOn)
{
    return m_state->files.askToDiscard(goOn);
}

void MainWindow::showSaved(const ModelFacts& facts)
{
    m_state->model = facts;
    m_state->showName();
    showExported(facts.path);
    m_state->files.setSaved(facts);
}

void MainWindow::showExported(const QString& path, const QString& verdict)
{
    showNotice(verdict.isEmpty() ? tr("%1 was written.").arg(QDir::toNativeSeparators(path)) : verdict);
    m_state->files.setExported(path);
}

void MainWindow::setModel(const ModelFacts& facts)
{
    m_state->model = facts;
    m_state->showName();
    setModified(false);
    if (facts.size.maxCoeff() > 0)
        m_state->brush.fitTo(facts, m_state->settings.radiusShare());
    m_state->files.setOpened(facts);
    m_state->facts->setFacts(facts);
    m_state->viewport->showModel(facts.box);
}

void MainWindow::updateFacts(const ModelFacts& facts)
{
    m_state->model = facts;
    m_state->showName();
    m_state->facts->setFacts(facts);
    m_state->viewport->setBox(facts.box);
    if (!m_state->brush.fits(facts)) {
        m_state->brush.fitTo(facts, m_state->brush.radiusShare());
        m_state->viewport->frame();
    }
}

void MainWindow::setModified(bool modified)
{
    setWindowModified(modified);
}

void MainWindow::showProblem(const QString& sentence)
{
    if (!m_state->problem) {
        m_state->problem = new QMessageBox(QMessageBox::Warning, tr("Fettle"), {}, QMessageBox::Ok, this);
        m_state->problem->setObjectName(QStringLiteral("problem"));
        m_state->problem->setTextFormat(Qt::PlainText);
        m_state->problem->setAttribute(Qt::WA_DeleteOnClose);
        m_state->problem->open();
    }
    m_state->problem->setText(sentence);
}

void MainWindow::showNotice(const QString& sentence)
{
    m_state->banner->say(sentence);
}

void MainWindow::setBusy(const QString& what)
{
    m_state->busy->begin(what);
    m_state->setBusy(true);
}

void MainWindow::setProgress(double share)
{
    m_state->busy->setProgress(share);
}

void MainWindow::setStoppable(bool canStop)
{
    m_state->busy->setStoppable(canStop);
}

void MainWindow::setIdle()
{
    m_state->busy->end();
    m_state->setBusy(false);
}

void MainWindow::settle()
{
    if (std::exchange(m_state->closesLater, false))
        close();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    m_state->closesLater = m_state->isSettled && !m_state->isSettled();
    if (m_state->closesLater || (m_state->mayClose && !m_state->mayClose())) {
        event->ignore();
        return;
    }
    m_state->save();
    event->accept();
}
} // namespace ui
