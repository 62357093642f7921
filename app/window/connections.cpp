#include "app/window/connections.h"

#include "app/classroom/class_file.h"
#include "app/classroom/class_pin.h"
#include "app/classroom/classroom_mode.h"
#include "app/classroom/report_controller.h"
#include "app/document/document.h"
#include "app/document/history_list.h"
#include "app/document/history_scrubber.h"
#include "app/document/model_analysis.h"
#include "app/document/print_analysis.h"
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
#include "ui/headset/partner_bar.h"
#include "ui/history/history_panel.h"
#include "ui/history/recovery_bar.h"
#include "ui/model/model_panel.h"
#include "ui/model/repair_dialogs.h"
#include "ui/model/unit_bar.h"
#include "ui/print/print_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/window_metadata.h"

#include <QAction>
#include <QDir>

namespace app
{
namespace
{
void wireDocument(ui::MainWindow& window, Document& document)
{
    using ui::MainWindow;
    QObject::connect(&window, &MainWindow::starterRequested, &document, &Document::openStarter);
    QObject::connect(&window, &MainWindow::saveRequested, &document, &Document::save);
    QObject::connect(&window, &MainWindow::exportRequested, &document, &Document::exportTo);
    QObject::connect(&window, &MainWindow::modelRenamed, &document, &Document::setPath);
    QObject::connect(&window, &MainWindow::modelFileDeleted, &document, &Document::loseFile);
    QObject::connect(&document, &Document::opened, &window, &MainWindow::setModel);
    QObject::connect(&document, &Document::factsChanged, &window, &MainWindow::updateModelInfo);
    QObject::connect(&document, &Document::modifiedChanged, &window, &MainWindow::setModified);
    QObject::connect(&document, &Document::refused, &window, &MainWindow::showProblem);
    QObject::connect(&document, &Document::noticed, &window, &MainWindow::showNotice);
    QObject::connect(&document, &Document::mendable, &window,
                     [&window, &document](const QString& path, const QString& problem) {
                         ui::askToRepair(&window, ui::RepairUse::Opening, problem,
                                         [&document, path](const core::RepairOptions& options) {
                                             document.openMended(path, options);
                                         });
                     });
    QObject::connect(&document, &Document::mended, &window, [&window](const QString& name, const QStringList& steps) {
        ui::showRepaired(&window, ui::RepairUse::Opening, name, steps);
    });
    QObject::connect(&document, &Document::insertionMendable, &window,
                     [&window, &document](ui::InsertRequest insertion, const QString& problem) {
                         ui::askToRepair(&window, ui::RepairUse::Insertion, problem,
                                         [&document, insertion](const core::RepairOptions& options) mutable {
                                             insertion.repair = options;
                                             document.insert(insertion);
                                         });
                     });
    QObject::connect(&document, &Document::insertedMended, &window,
                     [&window](const QString& name, const QStringList& steps) {
                         ui::showRepaired(&window, ui::RepairUse::Insertion, name, steps);
                     });
    QObject::connect(&document, &Document::busy, &window, &MainWindow::setBusy);
    QObject::connect(&document, &Document::idle, &window, &MainWindow::setIdle);
    QObject::connect(&document, &Document::progressed, &window, &MainWindow::setProgress);
    QObject::connect(&document, &Document::stoppable, &window, &MainWindow::setStoppable);
    QObject::connect(&window, &MainWindow::stopRequested, &document, &Document::stop);
    QObject::connect(&window, &MainWindow::commandRequested, &document, &Document::apply);
    QObject::connect(&window, &MainWindow::insertRequested, &document, &Document::insert);
    QObject::connect(&document, &Document::saved, &window,
                     [&window, &document] { window.showSaved(document.facts()); });
    QObject::connect(&document, &Document::exported, &window, &MainWindow::showExported);
    QObject::connect(&window, &MainWindow::brushModelRequested, &document, &Document::keepAsBrush);
    QObject::connect(&document, &Document::keptAsBrush, &window, &MainWindow::setBrushModel);
    document.setMayDiscard([&window](const std::function<void()>& goOn) { return window.askToDiscard(goOn); });
    window.setCanClose([&window, &document] { return document.mayDiscard([&window] { window.close(); }); });
}

/// The doubt lasts until the model is another one, by whatever means.
void wireUnits(ui::MainWindow& window, Document& document)
{
    using ui::UnitBar;
    const auto leave = [&window] {
        for (UnitBar* bar : window.findChildren<UnitBar*>())
            bar->dismiss();
    };
    QObject::connect(&document.undoStack(), &QUndoStack::indexChanged, &window, leave);
    QObject::connect(&document, &Document::opened, &window, [&window, &document, leave](const ui::ModelInfo& facts) {
        leave();
        if (facts.unitGuess == core::UnitDoubt::None)
            return;
        auto* bar = new UnitBar({facts.name, facts.size.maxCoeff(), facts.unitGuess}, &window);
        QObject::connect(&document, &Document::busy, bar, [bar] { bar->setEnabled(false); });
        QObject::connect(&document, &Document::idle, bar, [bar] { bar->setEnabled(true); });
        QObject::connect(bar, &UnitBar::unitChosen, &document, [&window, &document](double millimetres) {
            window.viewport()->setFocus();
            document.apply(core::Scale{millimetres});
        });
    });
}

/// What the hand did last counts among the changes, though it may not have come to the document yet. A window that
/// closes leaves VR, which takes until that has ended or is given up.
void wireSettling(ui::MainWindow& window, Document& document, Headset* headset)
{
    using ui::MainWindow;
    using ui::Viewport;
    Viewport& viewport = *window.viewport();
    QObject::connect(&window, &MainWindow::openRequested, &document, [&viewport, &document](const QString& path) {
        viewport.finish();
        if (!viewport.isPressPending())
            return document.open(path);
        const auto open = [&document, path] { document.open(path); };
        const auto how = static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
        QObject::connect(&viewport, &Viewport::pressDecided, &document, open, how);
    });
    window.setIsSettled([&viewport, &document, headset] {
        viewport.finish();
        headset->leave();
        return !viewport.isPressPending() && !headset->isIn() && document.isSettled();
    });
    QObject::connect(headset, &Headset::reported, &window, &MainWindow::continueClosing, Qt::QueuedConnection);
    QObject::connect(&viewport, &Viewport::pressDecided, &window, &MainWindow::continueClosing, Qt::QueuedConnection);
    QObject::connect(&document, &Document::historyChanged, &window, &MainWindow::continueClosing, Qt::QueuedConnection);
}

void wireHistory(ui::MainWindow& window, Document& document)
{
    QAction* undo = window.action(QStringLiteral("edit.undo"));
    QAction* redo = window.action(QStringLiteral("edit.redo"));
    QObject::connect(undo, &QAction::triggered, &document, &Document::undo);
    QObject::connect(redo, &QAction::triggered, &document, &Document::redo);
    QObject::connect(&document, &Document::historyChanged, &window, [&window, &document, undo, redo] {
        window.setUndoText(document.undoText());
        window.setRedoText(document.redoText());
        undo->setEnabled(document.canUndo());
        redo->setEnabled(document.canRedo());
    });
}

void wireHistoryPanel(ui::MainWindow& window, Document& document)
{
    using ui::HistoryPanel;
    HistoryPanel* panel = window.history();
    const auto show = [panel, &document] {
        if (panel->isVisible())
            panel->setHistory(historyOf(document));
    };
    const auto setCap = [&document, show](qint64 bytes) {
        document.history().setCap(static_cast<std::size_t>(bytes));
        show();
    };
    setCap(panel->cap());
    QObject::connect(panel, &HistoryPanel::jumpRequested, &document, &Document::goTo);
    QObject::connect(panel, &HistoryPanel::stateRequested, new HistoryScrubber(&document), &HistoryScrubber::want);
    QObject::connect(panel, &HistoryPanel::capChanged, panel, setCap);
    QObject::connect(panel, &HistoryPanel::shown, panel, show);
    QObject::connect(&document, &Document::historyChanged, panel, show);
    QObject::connect(&document.history(), &HistoryStore::bytesChanged, panel, show);
}

/// The swatches belong to the document where its file has some; else they are the person's.
void wirePalette(ui::MainWindow& window, Document& document)
{
    using ui::ColorPanel;
    auto* panel = window.findChild<ColorPanel*>();
    const auto keep = [panel, &document] { document.setPalette({panel->swatches().begin(), panel->swatches().end()}); };
    QObject::connect(panel, &ColorPanel::swatchesChanged, &document, keep);
    QObject::connect(&document, &Document::opened, panel, [panel, keep](const ui::ModelInfo& facts) {
        if (facts.metadata.palette.empty())
            keep();
        else
            panel->setSwatches({facts.metadata.palette.begin(), facts.metadata.palette.end()});
    });
}

/// View and brush go with the document, too.
void wireNotes(ui::MainWindow& window, Document& document)
{
    document.setCompleteNotes([&window](core::DocumentMetadata& metadata) { ui::addMetadata(window, metadata); });
    QObject::connect(&document, &Document::opened, &window,
                     [&window](const ui::ModelInfo& facts) { ui::applyMetadata(window, facts.metadata); });
}

void wireModelPanel(ui::MainWindow& window, Document& document, SculptWorker& worker)
{
    using ui::ModelPanel;
    ModelPanel* panel = window.modelPanel();
    auto* inquiry = new ModelInquiry(&document, &worker);
    QObject::connect(panel, &ModelPanel::watched, inquiry, &ModelInquiry::setWanted);
    QObject::connect(inquiry, &ModelInquiry::outdated, panel, &ModelPanel::setStale);
    QObject::connect(inquiry, &ModelInquiry::answered, panel, &ModelPanel::setReport);
}

/// The model shows what was measured while the panel can be seen and the answer is of the model as it is.
void wirePrintPanel(ui::MainWindow& window, Document& document, SculptWorker& worker)
{
    using ui::PrintPanel;
    auto* panel = window.findChild<PrintPanel*>();
    ui::Viewport* viewport = window.viewport();
    auto* inquiry = new PrintInquiry(&document, &worker);
    const auto wish = [panel, inquiry] { inquiry->setWishes({panel->limits(), panel->picture()}); };
    wish();
    QObject::connect(panel, &PrintPanel::optionsChanged, inquiry, wish);
    QObject::connect(panel, &PrintPanel::checkRequested, inquiry, &PrintInquiry::askAgain);
    QObject::connect(panel, &PrintPanel::stopRequested, inquiry, &PrintInquiry::stop);
    QObject::connect(panel, &PrintPanel::watched, inquiry, [viewport, inquiry, wish](bool isWatched) {
        inquiry->setWanted(isWatched);
        if (isWatched)
            wish();
        else
            viewport->setShades(nullptr);
    });
    QObject::connect(inquiry, &PrintInquiry::progressed, panel, &PrintPanel::setProgress);
    QObject::connect(inquiry, &PrintInquiry::outdated, panel, [panel, viewport] {
        panel->setStale();
        viewport->setShades(nullptr);
        viewport->clearMark();
    });
    QObject::connect(inquiry, &PrintInquiry::answered, panel,
                     [panel, viewport](const core::MeshReport& mesh, const core::PrintReport& print,
                                       const std::shared_ptr<const core::Footprint>& shades) {
                         panel->setReport(mesh, print);
                         viewport->setShades(panel->isVisible() ? shades : nullptr);
                     });
}

void wireStrokes(ui::Viewport& viewport, Document& document)
{
    using ui::Viewport;
    QObject::connect(&viewport, &Viewport::strokeBegan, &document, &Document::beginStroke);
    QObject::connect(&viewport, &Viewport::strokeSampled, &document, &Document::addSample);
    QObject::connect(&viewport, &Viewport::strokeEnded, &document, &Document::endStroke);
    QObject::connect(&viewport, &Viewport::sphereRequested, &document, &Document::addSphere);
}

void wireWorker(ui::Viewport& viewport, SculptWorker& worker, const std::shared_ptr<PatchInbox>& inbox)
{
    using ui::Viewport;
    viewport.setPatchSource([inbox] { return inbox->take(); });
    QObject::connect(inbox.get(), &PatchInbox::filled, &viewport, &Viewport::patchReady, Qt::QueuedConnection);
    QObject::connect(&viewport, &Viewport::hoverRequested, &worker,
                     [&worker](const core::Ray& ray, const std::optional<core::StrokeSettings>& brush) {
                         worker.ask(Source::Desktop, ray, brush);
                     });
    QObject::connect(&worker, &SculptWorker::answeredDesktop, &viewport, &Viewport::setHover);
    worker.setInbox(Source::Desktop, inbox);
}

void wireDrawings(ui::MainWindow& window, SculptWorker& worker)
{
    auto* drawings = new DrawingWorker(&worker, &window);
    auto* panel = window.findChild<ui::PreviewPanel*>();
    QObject::connect(panel, &ui::PreviewPanel::drawingRequested, drawings, &DrawingWorker::watch);
    QObject::connect(panel, &ui::PreviewPanel::exportRequested, drawings, &DrawingWorker::exportTo);
    QObject::connect(drawings, &DrawingWorker::drawn, panel, &ui::PreviewPanel::setDrawing);
    QObject::connect(drawings, &DrawingWorker::refused, &window, &ui::MainWindow::showProblem);
    QObject::connect(drawings, &DrawingWorker::noticed, &window, &ui::MainWindow::showNotice);
}

void wireReports(ui::MainWindow& window, Document& document)
{
    auto* desk = new ReportDesk(document.longWork(), &window);
    QObject::connect(&window, &ui::MainWindow::reportRequested, desk, &ReportDesk::write);
    QObject::connect(desk, &ReportDesk::noticed, &window, &ui::MainWindow::showNotice);
    QObject::connect(desk, &ReportDesk::refused, &window, &ui::MainWindow::showProblem);
}

void wireClassFiles(ui::MainWindow& window)
{
    QObject::connect(&window, &ui::MainWindow::classroomDrafted, &window, [&window](const ui::ClassroomDraft& draft) {
        ui::Classroom classroom = draft.classroom;
        classroom.pin = pinRecord(draft.pin);
        const QString problem = ClassFile::write(draft.path, classroom);
        if (!problem.isEmpty())
            return window.showProblem(problem);
        window.showNotice(ClassFile::tr("%1 was written. The class begins with: fettle --classroom %1")
                              .arg(QDir::toNativeSeparators(draft.path)));
    });
}
} // namespace

void wire(ui::MainWindow& window, Document& document, SculptWorker& worker, const std::shared_ptr<PatchInbox>& inbox)
{
    wireDocument(window, document);
    wireUnits(window, document);
    wireSettling(window, document, wireHeadset(window, document, worker));
    wireHistory(window, document);
    wireHistoryPanel(window, document);
    wirePalette(window, document);
    wireNotes(window, document);
    wireModelPanel(window, document, worker);
    wirePrintPanel(window, document, worker);
    new LessonDesk(window, document, worker); // before the strokes: the teacher's ends where the hand's begins
    new StrokeEdit(window, document);         // the same: what is wanted of the last stroke comes before the next
    new LessonEditorDesk(window, document, worker);
    wireStrokes(*window.viewport(), document);
    wireWorker(*window.viewport(), worker, inbox);
    wireDrawings(window, worker);
    wireReports(window, document);
    new TimeLapseDesk(window, document);
    wireClassFiles(window);
}

void wireRecovery(ui::MainWindow& window, Document& document, JournalShelf& shelf)
{
    using ui::RecoveryBar;
    document.keepJournals(&shelf);
    const auto show = [&window, &document, &shelf](const RecoveryOffer& offer) {
        for (RecoveryBar* before : window.findChildren<RecoveryBar*>())
            before->leave();
        if (offer.id == 0)
            return;
        auto* bar = new RecoveryBar({offer.name, offer.changed, offer.steps}, &window);
        QObject::connect(bar, &RecoveryBar::recoverRequested, &document,
                         [&document, offer] { document.recover(offer.id, offer.name); });
        QObject::connect(bar, &RecoveryBar::discardRequested, &shelf, [&shelf, offer] { shelf.discard(offer.id); });
    };
    QObject::connect(&shelf, &JournalShelf::offered, &window, show);
    shelf.look();
}

void wireLessonKeeping(Document& document, const std::filesystem::path& root)
{
    document.findChild<LessonEditorDesk*>()->keepLessons(root);
}

void wireClassroom(ui::MainWindow& window, ClassroomMode& mode)
{
    QObject::connect(&mode, &ClassroomMode::noticed, &window, &ui::MainWindow::showNotice);
    QObject::connect(&mode, &ClassroomMode::noticed, window.findChild<Headset*>(), &Headset::tell);
    QObject::connect(window.findChild<ui::ClassBar*>(), &ui::ClassBar::timeShown, window.findChild<ui::PartnerBar*>(),
                     &ui::PartnerBar::setTime);
}
} // namespace app
