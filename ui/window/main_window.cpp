#include "ui/window/main_window_state.h"

#include "ui/brush/brush_shapes.h"
#include "ui/widgets/notification_banner.h"
#include "ui/window/info_bar.h"
#include "ui/window/window_geometry.h"

#include <QAction>
#include <QCloseEvent>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QTabWidget>

#include <utility>

namespace ui
{
void MainWindow::State::setBusy(bool isBusy)
{
    for (const ActionInfo& row : actionTable())
        if (row.menu == MenuId::Model || row.menu == MenuId::Mask)
            actions.get(QLatin1StringView(row.id))->setEnabled(!isBusy);
    for (const char* id : {"file.save", "file.saveAs", "file.saveCopy", "file.exportAs", "file.exportFor",
                           "file.exportDrawing", "file.timeLapse", "file.report", "brush.fromModel"})
        actions.get(QLatin1StringView(id))->setEnabled(!isBusy);
}

void MainWindow::State::showName()
{
    q->setWindowTitle(tr("%1[*] – Fettle").arg(model.name));
}

void MainWindow::State::restore()
{
    restoreWindowGeometry(q, settings);
    for (const core::Parameter parameter : storedParameters)
        brush.setValue(parameter, settings.value(parameter));
    shapes->restore();
}

void MainWindow::State::save()
{
    saveWindowGeometry(*q, settings);
    for (const core::Parameter parameter : storedParameters)
        settings.setValue(parameter, brush.value(parameter));
    if (model.size.maxCoeff() > 0)
        settings.set(&Setting::radiusShare, brush.radiusShare());
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
    showExported(modelInfo.path);
    m_state->files.setSaved(modelInfo);
}

void MainWindow::showExported(const QString& path, const QString& verdict)
{
    showNotice(verdict.isEmpty() ? tr("%1 was written.").arg(QDir::toNativeSeparators(path)) : verdict);
    m_state->files.setExported(path);
}

void MainWindow::setModel(const ModelInfo& modelInfo)
{
    m_state->model = modelInfo;
    m_state->showName();
    setWindowModified(false);
    if (modelInfo.size.maxCoeff() > 0)
        m_state->brush.fitTo(modelInfo, m_state->settings.get(&Setting::radiusShare));
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
    if (!m_state->problem || m_state->problem->isHidden()) { // one that was answered may not be gone yet
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
    m_state->banner->showMessage(sentence);
}

void MainWindow::setBrushModel(const QString& path)
{
    m_state->shapes->chooseModel(path);
    m_state->brush.setTool(core::Tool::Stamp);
    showNotice(tr("Stamp has %1 as it is now.").arg(QFileInfo(path).completeBaseName()));
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
} // namespace ui
