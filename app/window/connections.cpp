#include "app/window/connections.h"

#include "app/analysis/model_analysis.h"
#include "app/analysis/print_analysis.h"
#include "app/classroom/class_file_controller.h"
#include "app/classroom/classroom_mode.h"
#include "app/classroom/report_controller.h"
#include "app/document/document.h"
#include "app/document/history_list.h"
#include "app/document/history_scrubber.h"
#include "app/document/stroke_edit.h"
#include "app/document/time_lapse_controller.h"
#include "app/headset/headset.h"
#include "app/headset/headset_connections.h"
#include "app/lesson/lesson_controller.h"
#include "app/lesson/lesson_editor_controller.h"
#include "app/recovery/recovery_store.h"
#include "app/worker/drawing_worker.h"
#include "app/worker/patch_inbox.h"
#include "app/worker/sculpt_worker.h"

#include "ui/brush/color_panel.h"
#include "ui/drawing/preview_panel.h"
#include "ui/gizmo/plane_cut_tool.h"
#include "ui/gizmo/transform_tool.h"
#include "ui/headset/partner_bar.h"
#include "ui/history/history_panel.h"
#include "ui/history/recovery_bar.h"
#include "ui/model/model_panel.h"
#include "ui/model/objects_bar.h"
#include "ui/model/repair_dialogs.h"
#include "ui/model/unit_bar.h"
#include "ui/parts/combination_card.h"
#include "ui/parts/parts_panel.h"
#include "ui/print/print_panel.h"
#include "ui/reference/reference_images.h"
#include "ui/shapes/view_tool.h"
#include "ui/util/format_filters.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/window_metadata.h"

#include <QAction>
#include <QDir>

namespace app
{
namespace
{
void connectDocument(ui::MainWindow& window, Document& document)
{
    using ui::MainWindow;
    QObject::connect(window.files(), &ui::ModelFiles::starterRequested, &document.opener(), &ModelOpener::openStarter);
    QObject::connect(window.files(), &ui::ModelFiles::saveRequested, &document.saver(), &ModelSaver::save);
    QObject::connect(window.files(), &ui::ModelFiles::exportRequested, &document.saver(), &ModelSaver::exportTo);
    QObject::connect(window.files(), &ui::ModelFiles::overlapAsked, &document.parts(), &DocumentParts::findOverlap);
    QObject::connect(window.files(), &ui::ModelFiles::renamed, &document, &Document::setPath);
    QObject::connect(window.files(), &ui::ModelFiles::fileDeleted, &document.savedState(), &SavedState::onFileDeleted);
    QObject::connect(&document, &Document::opened, &window, &MainWindow::setModel);
    QObject::connect(&document, &Document::modelInfoChanged, &window, &MainWindow::updateModelInfo);
    QObject::connect(&document.savedState(), &SavedState::modifiedChanged, &window, &MainWindow::setWindowModified);
    QObject::connect(&document, &Document::refused, &window, &MainWindow::showProblem);
    QObject::connect(&document, &Document::noticed, &window, &MainWindow::showNotice);
    QObject::connect(&document.job(), &BackgroundJob::busy, window.progress(), &ui::ProgressBar::begin);
    QObject::connect(&document.job(), &BackgroundJob::idle, window.progress(), &ui::ProgressBar::end);
    QObject::connect(&document.job(), &BackgroundJob::progressed, window.progress(), &ui::ProgressBar::setProgress);
    QObject::connect(&document.job(), &BackgroundJob::cancellable, window.progress(), &ui::ProgressBar::setStoppable);
    QObject::connect(window.action(QStringLiteral("edit.stop")), &QAction::triggered, &document, &Document::cancelJob);
    QObject::connect(&window, &MainWindow::commandRequested, &document.changer(), &ModelChanger::apply);
    QObject::connect(window.files(), &ui::ModelFiles::insertRequested, &document.changer(), &ModelChanger::insert);
    QObject::connect(&document.saver(), &ModelSaver::saved, &window,
                     [&window, &document] { window.showSaved(document.modelInfo()); });
    QObject::connect(&document.saver(), &ModelSaver::exported, &window, &MainWindow::showExported);
    QObject::connect(&document.saver(), &ModelSaver::saveFailed, &window, [&window](const QString& path) {
        window.offerRemedy(MainWindow::tr("&Choose Another Place…"),
                           [&window, path] { window.files()->saveElsewhere(path); });
    });
    QObject::connect(&document.saver(), &ModelSaver::exportFailed, &window, [&window](const QString& path) {
        window.offerRemedy(MainWindow::tr("&Choose Another Place…"),
                           [&window, path] { window.files()->exportElsewhere(path); });
    });
    QObject::connect(window.action(QStringLiteral("brush.fromModel")), &QAction::triggered, &document.saver(),
                     &ModelSaver::exportBrush);
    QObject::connect(&document.saver(), &ModelSaver::brushExported, &window, &MainWindow::setBrushModel);
    document.opener().setDiscardPrompt(
        [&window](const std::function<void()>& proceed) { return window.files()->askToDiscard(proceed); });
}

void connectRepairs(ui::MainWindow& window, Document& document)
{
    QObject::connect(&document.opener(), &ModelOpener::repairable, &window,
                     [&window, &document](const QString& path, const QString& problem) {
                         ui::askToRepair(&window, ui::RepairUse::Opening, problem,
                                         [&document, path](const core::RepairOptions& options) {
                                             document.opener().openRepaired(path, options);
                                         });
                     });
    QObject::connect(&document.opener(), &ModelOpener::repaired, &window,
                     [&window](const QString& name, const QStringList& steps) {
                         ui::showRepaired(&window, ui::RepairUse::Opening, name, steps);
                     });
    QObject::connect(&document.changer(), &ModelChanger::insertionRepairable, &window,
                     [&window, &document](ui::InsertRequest insertion, const QString& problem) {
                         ui::askToRepair(&window, ui::RepairUse::Insertion, problem,
                                         [&document, insertion](const core::RepairOptions& options) mutable {
                                             insertion.repair = options;
                                             document.changer().insert(insertion);
                                         });
                     });
    QObject::connect(&document.changer(), &ModelChanger::insertedRepaired, &window,
                     [&window](const QString& name, const QStringList& steps) {
                         ui::showRepaired(&window, ui::RepairUse::Insertion, name, steps);
                     });
    QObject::connect(&document, &Document::repairDoubted, &window,
                     [&window](const ui::RepairDoubt& doubt, const std::function<void()>& accept) {
                         ui::askToAccept(&window, doubt, accept);
                     });
}

/// Shows a bar that asks for the unit of a model whose file has none. The bar is dismissed when the model changes in
/// any way.
void connectUnits(ui::MainWindow& window, Document& document)
{
    using ui::UnitBar;
    const auto leave = [&window] {
        for (UnitBar* bar : window.findChildren<UnitBar*>())
            bar->dismiss();
    };
    QObject::connect(&document.history().stack(), &QUndoStack::indexChanged, &window, leave);
    QObject::connect(&document, &Document::opened, &window, [&window, &document, leave](const ui::ModelInfo& info) {
        leave();
        if (info.unitGuess == core::UnitDoubt::None)
            return;
        auto* bar = new UnitBar({info.name, info.size.maxCoeff(), info.unitGuess}, &window);
        QObject::connect(&document.job(), &BackgroundJob::busy, bar, [bar] { bar->setEnabled(false); });
        QObject::connect(&document.job(), &BackgroundJob::idle, bar, [bar] { bar->setEnabled(true); });
        QObject::connect(bar, &UnitBar::unitChosen, &document, [&window, &document](double millimetres) {
            window.viewport()->setFocus();
            document.changer().apply(core::Scale{millimetres});
        });
    });
}

/// Shows a bar that tells what became of the objects of a file. The bar is dismissed when the model changes in any way.
void connectObjects(ui::MainWindow& window, Document& document)
{
    using ui::ObjectsBar;
    const auto leave = [&window] {
        for (ObjectsBar* bar : window.findChildren<ObjectsBar*>())
            bar->dismiss();
    };
    QObject::connect(&document.history().stack(), &QUndoStack::indexChanged, &window, leave);
    QObject::connect(&document, &Document::opened, &window, [&window, &document, leave](const ui::ModelInfo& info) {
        leave();
        if (info.objects.count == 1)
            return;
        auto* bar = new ObjectsBar(info.name, info.objects, &window);
        QObject::connect(&document.job(), &BackgroundJob::busy, bar, [bar] { bar->setEnabled(false); });
        QObject::connect(&document.job(), &BackgroundJob::idle, bar, [bar] { bar->setEnabled(true); });
        QObject::connect(bar, &ObjectsBar::reopenRequested, &document, [&window, &document, path = info.source] {
            window.viewport()->setFocus();
            document.opener().open(path);
        });
    });
}

/// Finishes pending input before a file is opened or the window closes, so that a stroke not yet sent to the document
/// counts as a change. Closing also leaves VR first, and continues when VR has ended or was given up.
void connectClosing(ui::MainWindow& window, Document& document, Headset* headset)
{
    using ui::MainWindow;
    using ui::PointerInput;
    PointerInput* input = window.viewport()->input();
    QObject::connect(
        window.files(), &ui::ModelFiles::openRequested, &document, [input, &document, &window](const QString& path) {
            if (ui::isClassFile(path))
                return window.findChild<ClassFileController*>()->offer(path);
            input->finish();
            if (!input->isPressPending())
                return document.opener().open(path);
            const auto open = [&document, path] { document.opener().open(path); };
            const auto how = static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
            QObject::connect(input, &PointerInput::pressDecided, &document, open, how);
        });
    window.setIsSettled([input, &document, headset] {
        input->finish();
        headset->leave();
        document.changer().dropPreview();
        return !input->isPressPending() && !headset->isActive() && document.queue().isSettled();
    });
    QObject::connect(headset, &Headset::reported, &window, &MainWindow::continueClosing, Qt::QueuedConnection);
    QObject::connect(input, &PointerInput::pressDecided, &window, &MainWindow::continueClosing, Qt::QueuedConnection);
    QObject::connect(&document, &Document::historyChanged, &window, &MainWindow::continueClosing, Qt::QueuedConnection);
}

void connectHistory(ui::MainWindow& window, Document& document)
{
    QAction* undo = window.action(QStringLiteral("edit.undo"));
    QAction* redo = window.action(QStringLiteral("edit.redo"));
    QObject::connect(undo, &QAction::triggered, &document, [&document] {
        if (document.changer().isPreviewing())
            document.cancelJob();
        else
            document.history().undo();
    });
    QObject::connect(redo, &QAction::triggered, &document, [&document] {
        if (!document.changer().isPreviewing())
            document.history().redo();
    });
    QObject::connect(&document, &Document::historyChanged, &window, [&window, &document, undo, redo] {
        window.setUndoText(document.history().undoText());
        window.setRedoText(document.history().redoText());
        undo->setEnabled(document.history().canUndo());
        redo->setEnabled(document.history().canRedo());
    });
}

void connectParts(ui::MainWindow& window, Document& document)
{
    using ui::PartsPanel;
    auto* panel = window.findChild<PartsPanel*>();
    DocumentParts* parts = &document.parts();
    QObject::connect(parts, &DocumentParts::changed, panel,
                     [panel, parts] { panel->setParts(parts->list(), parts->active()); });
    QObject::connect(panel, &PartsPanel::activated, parts, &DocumentParts::activate);
    QObject::connect(panel, &PartsPanel::requested, &document.changer(), &ModelChanger::applyTo);
    QObject::connect(window.action(QStringLiteral("parts.isolate")), &QAction::triggered, parts,
                     &DocumentParts::isolate);
    QObject::connect(window.action(QStringLiteral("parts.showAll")), &QAction::triggered, parts,
                     &DocumentParts::showAll);
    QObject::connect(window.viewport()->input(), &ui::PointerInput::partPicked, parts, &DocumentParts::pick);
}

/// Shows the result of combining parts before it becomes a step.
void connectCombinations(ui::MainWindow& window, Document& document, Headset* headset)
{
    using ui::CombinationCard;
    ModelChanger* changer = &document.changer();
    ui::Viewport* view = window.viewport();
    auto* card = view->findChild<CombinationCard*>();
    QObject::connect(window.findChild<ui::PartsPanel*>(), &ui::PartsPanel::combinationRequested, changer,
                     [changer, view](core::PartId part, const core::CombineParts& command) {
                         view->input()->setMode(ui::PointerMode::Sculpt); // ends tools that show something in the view
                         changer->preview(part, command);
                     });
    QObject::connect(changer, &ModelChanger::previewed, card,
                     [card, view, headset](core::SetOperation operation, const auto& translucent) {
                         view->showTranslucent(translucent);
                         card->open(operation);
                         if (!headset->isActive()) // otherwise somebody in VR may have asked for it
                             card->setFocus();
                     });
    QObject::connect(changer, &ModelChanger::previewTakenBack, card, [card, view] {
        view->showTranslucent({});
        card->setEnabled(false);
    });
    QObject::connect(changer, &ModelChanger::previewEnded, card, [card, view] {
        view->showTranslucent({});
        card->close();
    });
    QObject::connect(card, &CombinationCard::operationChosen, changer, &ModelChanger::previewInstead);
    QObject::connect(card, &CombinationCard::applied, changer, &ModelChanger::applyPreview);
    QObject::connect(card, &CombinationCard::cancelled, &document, &Document::cancelJob);
}

/// Tells a tool in the view what a change of the active part moves, whenever that may have changed.
template <class Tool> void connectRegion(Tool* tool, Document& document)
{
    DocumentParts* parts = &document.parts();
    QObject::connect(tool, &Tool::regionWanted, parts, &DocumentParts::findRegion);
    QObject::connect(parts, &DocumentParts::regionFound, tool, &Tool::setRegion);
    QObject::connect(parts, &DocumentParts::changed, tool, &Tool::refresh);
    QObject::connect(&document, &Document::historyChanged, tool, &Tool::refresh);
    QObject::connect(&document, &Document::opened, tool, &Tool::refresh);
    QObject::connect(&document.job(), &BackgroundJob::busy, tool, [tool] { tool->setBusy(true); });
    QObject::connect(&document.job(), &BackgroundJob::idle, tool, [tool] { tool->setBusy(false); });
}

/// Tells a tool that draws in the view where the model is, and what has become of its request. While a long job runs,
/// it can request nothing.
void connectViewTool(ui::ViewTool* tool, Document& document)
{
    QObject::connect(tool, &ui::ViewTool::surfaceWanted, &document.parts(), &DocumentParts::findSurface);
    QObject::connect(&document.changer(), &ModelChanger::ended, tool, &ui::ViewTool::endRequest);
    QObject::connect(&document.job(), &BackgroundJob::busy, tool, [tool] { tool->setEnabled(false); });
    QObject::connect(&document.job(), &BackgroundJob::idle, tool, [tool] { tool->setEnabled(true); });
}

void connectTransform(ui::MainWindow& window, Document& document)
{
    using ui::TransformTool;
    auto* tool = window.viewport()->findChild<TransformTool*>();
    connectRegion(tool, document);
    QObject::connect(&document.changer(), &ModelChanger::ended, tool, [tool](bool isMade) {
        if (!isMade)
            tool->dropRequest();
    });
    // A part that the window has inserted gets the handles, so that it can be put into its place.
    const auto isAwaited = std::make_shared<bool>(false);
    QObject::connect(&window, &ui::MainWindow::commandRequested, tool, [=] { *isAwaited = true; });
    QObject::connect(window.files(), &ui::ModelFiles::insertRequested, tool, [=] { *isAwaited = true; });
    QObject::connect(&document, &Document::stepped, tool, [=, &window](const core::FileEntry& entry) {
        const auto* const command = std::get_if<core::FileCommand>(&entry);
        const auto* const insert = command ? std::get_if<core::Insert>(&command->command) : nullptr;
        if (std::exchange(*isAwaited, false) && insert && insert->combination == core::Insert::Combination::Part)
            window.action(QStringLiteral("model.transform"))->setChecked(true);
    });
}

void connectHistoryPanel(ui::MainWindow& window, Document& document)
{
    using ui::HistoryPanel;
    HistoryPanel* panel = window.history();
    const auto show = [panel, &document] {
        if (panel->isVisible())
            panel->setHistory(historyOf(document));
    };
    const auto setCap = [&document, show](qint64 bytes) {
        document.history().store().setCap(static_cast<std::size_t>(bytes));
        show();
    };
    setCap(panel->cap());
    QObject::connect(panel, &HistoryPanel::jumpRequested, &document, [&document](int index) {
        document.changer().dropPreview();
        document.history().goTo(index);
    });
    QObject::connect(panel, &HistoryPanel::stateRequested, new HistoryScrubber(&document), &HistoryScrubber::scrubTo);
    QObject::connect(panel, &HistoryPanel::capChanged, panel, setCap);
    QObject::connect(panel, &HistoryPanel::shown, panel, show);
    QObject::connect(&document, &Document::historyChanged, panel, show);
    QObject::connect(&document.history().store(), &HistoryStore::bytesChanged, panel, show);
}

/// Uses the swatches of an opened file; if it has none, the document gets the user's present swatches.
void connectPalette(ui::MainWindow& window, Document& document)
{
    using ui::ColorPanel;
    auto* panel = window.findChild<ColorPanel*>();
    const auto store = [panel, &document] {
        document.setPalette({panel->swatches().begin(), panel->swatches().end()});
    };
    QObject::connect(panel, &ColorPanel::swatchesChanged, &document, store);
    QObject::connect(&document, &Document::opened, panel, [panel, store](const ui::ModelInfo& info) {
        if (info.metadata.palette.empty())
            store();
        else
            panel->setSwatches({info.metadata.palette.begin(), info.metadata.palette.end()});
    });
}

/// Stores view, brush and reference images in the document's metadata, and applies them when a file is opened.
void connectMetadata(ui::MainWindow& window, Document& document)
{
    document.setCompleteMetadata([&window](core::DocumentMetadata& metadata) { ui::addMetadata(window, metadata); });
    QObject::connect(&document, &Document::opened, &window,
                     [&window](const ui::ModelInfo& info) { ui::applyMetadata(window, info.metadata); });
    const auto* references = window.findChild<ui::ReferenceImages*>();
    if (!references) // there is no OpenGL to draw them
        return;
    QObject::connect(references, &ui::ReferenceImages::changed, &document.journaling(), &DocumentJournal::describe);
    QObject::connect(references, &ui::ReferenceImages::edited, &window, [&document] {
        document.savedState().setModifiedBeyondHistory(true);
        document.savedState().emitIfChanged();
    });
}

void connectModelPanel(ui::MainWindow& window, Document& document, SculptWorker& worker)
{
    using ui::ModelPanel;
    ModelPanel* panel = window.modelPanel();
    auto* analysis = new ModelAnalysis(&document, &worker);
    QObject::connect(panel, &ModelPanel::watched, analysis, &ModelAnalysis::setActive);
    QObject::connect(analysis, &ModelAnalysis::outdated, panel, &ModelPanel::setStale);
    QObject::connect(analysis, &ModelAnalysis::finished, panel, &ModelPanel::setReport);
}

ui::PrintedParts printedParts(core::PartUnion parts)
{
    switch (parts) {
    case core::PartUnion::NotNeeded:
        break;
    case core::PartUnion::Done:
        return ui::PrintedParts::United;
    case core::PartUnion::Failed:
        return ui::PrintedParts::EachAlone;
    }
    return ui::PrintedParts::Apart;
}

/// Shows the measured values as colours on the model while the panel is visible and the result describes the present
/// model.
void connectPrintPanel(ui::MainWindow& window, Document& document, SculptWorker& worker)
{
    using ui::PrintPanel;
    auto* panel = window.findChild<PrintPanel*>();
    ui::Viewport* viewport = window.viewport();
    auto* analysis = new PrintAnalysis(&document, &worker);
    const auto applyOptions = [panel, analysis] { analysis->setOptions({panel->limits(), panel->picture()}); };
    applyOptions();
    QObject::connect(panel, &PrintPanel::optionsChanged, analysis, applyOptions);
    QObject::connect(panel, &PrintPanel::checkRequested, analysis, &PrintAnalysis::runNow);
    QObject::connect(panel, &PrintPanel::stopRequested, analysis, &PrintAnalysis::stop);
    QObject::connect(panel, &PrintPanel::watched, analysis, [viewport, analysis, applyOptions](bool isWatched) {
        analysis->setActive(isWatched);
        if (isWatched)
            applyOptions();
        else
            viewport->setShades(nullptr);
    });
    QObject::connect(analysis, &PrintAnalysis::progressed, panel, &PrintPanel::setProgress);
    QObject::connect(analysis, &PrintAnalysis::outdated, panel, [panel, viewport] {
        panel->setStale();
        viewport->setShades(nullptr);
        viewport->navigation()->clearMark();
    });
    QObject::connect(analysis, &PrintAnalysis::finished, panel,
                     [panel, viewport](const core::MeshReport& mesh, const core::PrintReport& print,
                                       core::PartUnion parts, const std::shared_ptr<const core::Footprint>& shades) {
                         panel->setReport(mesh, print, printedParts(parts));
                         viewport->setShades(panel->isVisible() ? shades : nullptr);
                     });
}

void connectStrokes(const ui::PointerInput* input, Document& document)
{
    using ui::PointerInput;
    QObject::connect(input, &PointerInput::strokeBegan, &document.strokes(), &DocumentStrokes::beginStroke);
    QObject::connect(input, &PointerInput::strokeSampled, &document.strokes(), &DocumentStrokes::addSample);
    QObject::connect(input, &PointerInput::strokeEnded, &document.strokes(), &DocumentStrokes::endStroke);
    QObject::connect(input, &PointerInput::sphereRequested, &document.strokes(), &DocumentStrokes::addSphere);
}

void connectWorker(ui::Viewport& viewport, SculptWorker& worker, const std::shared_ptr<PatchInbox>& inbox)
{
    using ui::Viewport;
    viewport.setPatchSource([inbox] { return inbox->take(); });
    QObject::connect(inbox.get(), &PatchInbox::filled, &viewport, &Viewport::patchReady, Qt::QueuedConnection);
    QObject::connect(viewport.input(), &ui::PointerInput::hoverRequested, &worker,
                     [&worker](const core::Ray& ray, const std::optional<core::StrokeSettings>& brush) {
                         worker.ask(Source::Desktop, ray, brush);
                     });
    QObject::connect(&worker, &SculptWorker::answeredDesktop, viewport.input(), &ui::PointerInput::setHover);
    worker.setInbox(Source::Desktop, inbox);
}

void connectDrawings(ui::MainWindow& window, SculptWorker& worker)
{
    auto* drawings = new DrawingWorker(&worker, &window);
    auto* panel = window.findChild<ui::PreviewPanel*>();
    QObject::connect(panel, &ui::PreviewPanel::drawingRequested, drawings, &DrawingWorker::watch);
    QObject::connect(panel, &ui::PreviewPanel::exportRequested, drawings, &DrawingWorker::exportTo);
    QObject::connect(drawings, &DrawingWorker::drawn, panel, &ui::PreviewPanel::setDrawing);
    QObject::connect(drawings, &DrawingWorker::refused, &window, &ui::MainWindow::showProblem);
    QObject::connect(drawings, &DrawingWorker::noticed, &window, &ui::MainWindow::showNotice);
}

void connectReports(ui::MainWindow& window, Document& document)
{
    auto* controller = new ReportController(&document.job(), &window);
    QObject::connect(window.files(), &ui::ModelFiles::reportRequested, controller, &ReportController::write);
    QObject::connect(controller, &ReportController::noticed, &window, &ui::MainWindow::showNotice);
    QObject::connect(controller, &ReportController::refused, &window, &ui::MainWindow::showProblem);
}

/// Connects lessons. On closing, the lesson is left before the window stores its brush, so that the pupil's own brush
/// is stored.
void connectLessons(ui::MainWindow& window, Document& document)
{
    auto* const lessons = new LessonController(window, document);
    window.setCanClose([&window, &document, lessons] {
        const bool canClose = document.opener().canDiscard([&window] { window.close(); });
        if (canClose)
            lessons->leave();
        return canClose;
    });
}
} // namespace

void connectAll(ui::MainWindow& window, Document& document, SculptWorker& worker,
                const std::shared_ptr<PatchInbox>& inbox)
{
    connectDocument(window, document);
    connectRepairs(window, document);
    connectUnits(window, document);
    connectObjects(window, document);
    Headset* headset = connectHeadset(window, document, worker);
    connectClosing(window, document, headset);
    connectHistory(window, document);
    connectHistoryPanel(window, document);
    connectParts(window, document);
    connectCombinations(window, document, headset);
    connectTransform(window, document);
    for (ui::ViewTool* tool : window.viewport()->findChildren<ui::ViewTool*>())
        connectViewTool(tool, document);
    connectRegion(window.viewport()->findChild<ui::PlaneCutTool*>(), document);
    connectPalette(window, document);
    connectMetadata(window, document);
    connectModelPanel(window, document, worker);
    connectPrintPanel(window, document, worker);
    // before connectStrokes(): the user's stroke first ends the lesson's demonstration
    connectLessons(window, document);
    // before connectStrokes(): pending changes of the last stroke are applied before the next stroke
    new StrokeEdit(window, document);
    new LessonEditorController(window, document);
    connectStrokes(window.viewport()->input(), document);
    connectWorker(*window.viewport(), worker, inbox);
    connectDrawings(window, worker);
    connectReports(window, document);
    new TimeLapseController(window, document);
    new ClassFileController(window, document);
}

void connectRecovery(ui::MainWindow& window, Document& document, RecoveryStore& recoveryStore)
{
    using ui::RecoveryBar;
    document.journaling().setRecoveryStore(&recoveryStore);
    const auto show = [&window, &document, &recoveryStore](const RecoveryOffer& offer) {
        for (RecoveryBar* before : window.findChildren<RecoveryBar*>())
            before->dismiss();
        if (offer.id == 0)
            return;
        auto* bar = new RecoveryBar({offer.name, offer.changed, offer.steps}, &window);
        QObject::connect(bar, &RecoveryBar::recoverRequested, &document,
                         [&document, offer] { document.opener().recover(offer.id, offer.name); });
        QObject::connect(bar, &RecoveryBar::discardRequested, &recoveryStore,
                         [&recoveryStore, offer] { recoveryStore.discard(offer.id); });
    };
    QObject::connect(&recoveryStore, &RecoveryStore::offered, &window, show);
    recoveryStore.findAbandoned();
}

void connectLessonAutosave(Document& document, const std::filesystem::path& root)
{
    document.findChild<LessonEditorController*>()->enableAutosave(root);
}

void connectClassroom(ui::MainWindow& window, ClassroomMode& mode)
{
    QObject::connect(&mode, &ClassroomMode::noticed, &window, &ui::MainWindow::showNotice);
    QObject::connect(&mode, &ClassroomMode::noticed, window.findChild<Headset*>(), &Headset::showNotice);
    QObject::connect(window.findChild<ui::ClassBar*>(), &ui::ClassBar::timeShown, window.findChild<ui::PartnerBar*>(),
                     &ui::PartnerBar::setTime);
}
} // namespace app
