#include "app/classroom/class_file.h"
#include "app/classroom/class_file_controller.h"
#include "app/classroom/classroom_mode.h"
#include "app/commands/command_line.h"
#include "app/commit.h"
#include "app/document/document.h"
#include "app/headset/simulator_controller.h"
#include "app/import/assimp_import.h"
#include "app/import/sandboxed_importer.h"
#include "app/platform/desktop.h"
#include "app/platform/process_signals.h"
#include "app/platform/terminal.h"
#include "app/recovery/recovery_store.h"
#include "app/window/connections.h"
#include "app/worker/sculpt_worker.h"

#include "ui/scene/scene.h"
#include "ui/settings/settings.h"
#include "ui/util/format_filters.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/theme.h"
#include "ui/window/main_window.h"
#include "vr/openxr/runtime_thread.h"

#include <QAction>
#include <QApplication>
#include <QLibraryInfo>
#include <QProcess>
#include <QSettings>
#include <QTranslator>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>

namespace
{
constexpr const char* noDisplay =
    "fettle: there is no display to open a window on (the commands work without one; see fettle --help)\n";

void nameProgram()
{
    QCoreApplication::setOrganizationName(QStringLiteral("Fettle"));
    QCoreApplication::setApplicationName(QStringLiteral("Fettle"));
    const QString commit = QStringLiteral(FETTLE_COMMIT);
    QCoreApplication::setApplicationVersion(QStringLiteral(FETTLE_VERSION) +
                                            (commit.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(commit)));
}

/// Sets the language chosen in the settings for texts and numbers of the window. The command line uses the system's
/// language.
void chooseLanguage(ui::Language language)
{
    for (const ui::Named<ui::Language>& row : ui::languages)
        if (row.value == language && language != ui::Language::System)
            QLocale::setDefault(QLocale(QLatin1StringView(row.key)));
}

/// Scales the application's font. Precondition: no widget has been shown.
void chooseTextSize(ui::TextSize size)
{
    QApplication::setFont(ui::scaled(QApplication::font(), ui::factorOf(size)));
}

/// Replaces the loaded translations by Fettle's own texts and Qt's texts for its dialogs. The application owns the
/// translators, because they must outlive all texts.
void loadTranslations(QCoreApplication& application)
{
    qDeleteAll(application.findChildren<QTranslator*>());
    const auto load = [&](const QLocale& locale, const QString& name, const QString& folder) {
        auto* translator = new QTranslator(&application);
        if (translator->load(locale, name, QStringLiteral("_"), folder))
            QCoreApplication::installTranslator(translator);
        return QLocale(translator->language());
    };
    const QString ours = QStringLiteral("fettle"), folder = QStringLiteral(":/i18n");
    QLocale found = load(QLocale(), ours, folder);
    if (found.language() == QLocale::C)
        // English has a translation file, too, for its plural forms
        found = load(QLocale(QLocale::English), ours, folder);
    // Qt's translation determines whether windows are mirrored, so it must be in the language that was found.
    load(found, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
}

bool hasWord(int argc, char* argv[], const char* word)
{
    return std::any_of(argv + std::min(1, argc), argv + argc,
                       [word](const char* argument) { return qstrcmp(argument, word) == 0; });
}

/// Returns whether a window can be opened. Checked in advance, because Qt calls abort() without a display, and Fettle
/// prints its own message instead.
bool canHaveWindow(int argc, char* argv[])
{
    return hasWord(argc, argv, "-platform") || hasWord(argc, argv, "--platform") || app::hasDisplay();
}

/// Message handler while QApplication is constructed. If the configured display does not answer, Qt logs warnings and a
/// fatal message; this prints one sentence instead and exits.
void onlyTellOfMissingDisplay(QtMsgType type, const QMessageLogContext&, const QString&)
{
    if (type != QtFatalMsg)
        return;
    std::fputs(noDisplay, stderr);
    std::_Exit(app::BadInput);
}

/// Makes an application that can draw text but never opens a display. Qt's warnings about missing desktop services are
/// suppressed; only a missing "offscreen" platform is reported.
std::unique_ptr<QCoreApplication> applicationWithFonts(int& argc, char* argv[])
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QtMessageHandler usual =
        qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString&) {
            if (type != QtFatalMsg)
                return;
            std::fputs("fettle: pages cannot be drawn, because Qt's platform \"offscreen\" is not installed\n", stderr);
            std::_Exit(app::BadInput);
        });
    auto application = std::make_unique<QGuiApplication>(argc, argv);
    qInstallMessageHandler(usual);
    return application;
}

int runCommand(int argc, char* argv[], bool needsFonts)
{
    const auto application =
        needsFonts ? applicationWithFonts(argc, argv) : std::make_unique<QCoreApplication>(argc, argv);
    loadTranslations(*application);
    return app::CommandLine::run(QCoreApplication::arguments().mid(1), QStringLiteral(FETTLE_OPENXR_VERSION));
}

/// Enters VR as soon as the first model is open.
void enterVrOnce(const app::Document& document, ui::MainWindow& window)
{
    const auto how = static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
    QObject::connect(&document, &app::Document::opened, window.action(QStringLiteral("vr.enter")), &QAction::trigger,
                     how);
}

/// Asks, as soon as the first model is open, whether to begin the class of the given file.
void offerOnce(const app::Document& document, ui::MainWindow& window, const QString& classFile)
{
    const auto how = static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
    QObject::connect(
        &document, &app::Document::opened, &window,
        [&window, classFile] { window.findChild<app::ClassFileController*>()->offer(classFile); }, how);
}

/// Opens the simulator if requested, null otherwise. Precondition: nothing has called OpenXR yet. Throws
/// CommandFailure.
std::unique_ptr<app::Simulator> simulatorFor(const app::WindowStart& start)
{
    if (!start.simulatesVr)
        return nullptr;
    if (const QString unable = ui::graphicsProblem(); !unable.isEmpty())
        throw app::CommandFailure{unable};
    return app::Simulator::open();
}

/// Shows the window and returns the exit status. The objects are destroyed in reverse order: window, document (which
/// stops the mesh thread), recovery store, simulator. `nextClass` becomes the file of the class to begin afterwards;
/// empty: none.
int showWindow(const app::WindowStart& start, QString& nextClass)
{
    std::unique_ptr<app::Simulator> simulator = simulatorFor(start);
    app::RecoveryStore recoveryStore;
    app::SculptWorker worker;
    const auto inbox = std::make_shared<app::PatchInbox>();
    app::Document document(&worker);
    ui::MainWindow window;
    app::connectAll(window, document, worker, inbox);
    app::connectRecovery(window, document, recoveryStore);
    app::connectLessonAutosave(document, app::RecoveryStore::defaultRoot().parent_path() / "lessons");
    if (simulator)
        new app::SimulatorController(&window, &worker, std::move(simulator));
    window.show();
    if (start.entersVr)
        enterVrOnce(document, window);
    const auto* classFiles = window.findChild<app::ClassFileController*>();
    if (start.file.isEmpty() || ui::isClassFile(start.file))
        document.opener().openBall();
    else
        document.opener().open(start.file);
    if (ui::isClassFile(start.file))
        offerOnce(document, window, start.file);
    if (start.file.isEmpty() && !start.entersVr && ui::Settings().get(&ui::Setting::showsStartPage))
        window.action(QStringLiteral("help.start"))->trigger();
    const int status = QApplication::exec();
    nextClass = classFiles->next();
    return status;
}

/// Starts a class as a separate process.
int beginClass(const QString& classFile)
{
    if (QProcess::startDetached(QCoreApplication::applicationFilePath(), {QStringLiteral("--classroom"), classFile}))
        return app::Done;
    app::CommandLine::printError(
        app::ClassFile::tr("%1 could not be started.").arg(QCoreApplication::applicationFilePath()));
    return app::BadInput;
}

/// Runs a class. Its journals, settings and language are separate from the teacher's, so pupils cannot change the
/// teacher's. Settings are cleared at each start.
int showClass(QApplication& application, const app::WindowStart& start)
{
    const ui::Classroom classroom = app::ClassFile::read(start.classFile);
    const app::ClassPaths paths = app::ClassPaths::prepare(start.classFile, classroom.folder);
    QCoreApplication::setApplicationName(QStringLiteral("FettleClass"));
    QSettings().clear();
    if (classroom.language != ui::Language::System) {
        chooseLanguage(classroom.language);
        loadTranslations(application);
    }
    std::unique_ptr<app::Simulator> simulator = simulatorFor(start);
    app::RecoveryStore recoveryStore(paths.journals);
    app::SculptWorker worker;
    const auto inbox = std::make_shared<app::PatchInbox>();
    app::Document document(&worker);
    ui::MainWindow window;
    app::connectAll(window, document, worker, inbox);
    document.journaling().setRecoveryStore(&recoveryStore);
    app::ClassroomMode mode({&window, &document, &recoveryStore}, classroom, paths);
    app::connectClassroom(window, mode);
    if (simulator)
        new app::SimulatorController(&window, &worker, std::move(simulator));
    if (classroom.fullScreen)
        window.showFullScreen();
    else
        window.show();
    if (start.entersVr)
        enterVrOnce(document, window);
    mode.begin();
    return QApplication::exec();
}

int runWindow(int argc, char* argv[])
{
    if (!canHaveWindow(argc, argv)) {
        std::fputs(noDisplay, stderr);
        return app::BadInput;
    }
    app::surviveBrokenPipes();
    if (hasWord(argc, argv, app::simulatorOption))
        app::preferX11();
    ui::prepareGraphics();
    const QtMessageHandler usual = qInstallMessageHandler(onlyTellOfMissingDisplay);
    QApplication application(argc, argv);
    qInstallMessageHandler(usual);
    chooseLanguage(ui::Settings().get<ui::Preferences>().language);
    chooseTextSize(ui::Settings().get<ui::Preferences>().textSize);
    loadTranslations(application);

    int status = app::Done;
    try {
        const app::WindowStart start = app::CommandLine::windowStart(QCoreApplication::arguments().mid(1));
        QString nextClass;
        status = start.classFile.isEmpty() ? showWindow(start, nextClass) : showClass(application, start);
        if (!nextClass.isEmpty())
            status = beginClass(nextClass);
    } catch (const app::CommandFailure& failure) {
        app::CommandLine::printError(failure.sentence);
        return failure.status;
    } catch (const app::ClassFileError& error) {
        app::CommandLine::printError(error.sentence);
        return app::BadInput;
    }
    // the abandoned thread may still use Qt and OpenXR, so their static objects must not be destroyed
    if (vr::RuntimeThread::hasAbandonedWork()) {
        std::fflush(nullptr);
        std::_Exit(status);
    }
    return status;
}
} // namespace

int main(int argc, char* argv[])
{
    app::useBinaryStreams();
    if (argc == 5 && qstrcmp(argv[1], app::importWord) == 0)
        return app::runImport(app::argumentPath(argv, 2), argv[3], argv[4]);
    app::endOnInterrupt();
    app::useUtf8();
    nameProgram();
    app::surviveFileSizeLimit();
    app::installSandboxedImporter();
    const QStringList arguments = app::programArguments(argc, argv);
    return app::CommandLine::opensWindow(arguments) ? runWindow(argc, argv)
                                                    : runCommand(argc, argv, app::CommandLine::needsFonts(arguments));
}
