#include "app/classroom/class_file.h"
#include "app/classroom/class_file_controller.h"
#include "app/classroom/classroom_mode.h"
#include "app/commands/command_line.h"
#include "app/commit.h"
#include "app/document/document.h"
#include "app/headset/simulator_controller.h"
#include "app/import/assimp_import.h"
#include "app/import/sandboxed_importer.h"
#include "app/platform/process_signals.h"
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

/// The window's words and numbers, as chosen; the command line goes by the system.
void chooseLanguage(ui::Language language)
{
    for (const ui::Named<ui::Language>& row : ui::languages)
        if (row.value == language && language != ui::Language::System)
            QLocale::setDefault(QLocale(QLatin1StringView(row.key)));
}

/// Once, before anything is shown.
void chooseTextSize(ui::TextSize size)
{
    QApplication::setFont(ui::scaled(QApplication::font(), ui::factorOf(size)));
}

/// Our own words, and Qt's for its dialogs, in the place of those before. They must outlive the texts: they belong to
/// the application.
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
        found = load(QLocale(QLocale::English), ours, folder); // for its plurals
    // Qt's words say whether windows are mirrored, so they are those of our language.
    load(found, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
}

bool hasWord(int argc, char* argv[], const char* word)
{
    return std::any_of(argv + std::min(1, argc), argv + argc,
                       [word](const char* argument) { return qstrcmp(argument, word) == 0; });
}

/// The simulator takes its pictures by GLX, which is X11's.
void preferX11()
{
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") && !qEnvironmentVariableIsEmpty("DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "xcb");
}

/// Qt ends a program without a display by abort(). Where X11 or Wayland would be used, we look first and say it in
/// words.
bool canHaveWindow(int argc, char* argv[])
{
#if defined(Q_OS_UNIX) && !defined(Q_OS_MACOS)
    if (hasWord(argc, argv, "-platform") || hasWord(argc, argv, "--platform"))
        return true;
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") ||
           !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
#else
    Q_UNUSED(argc)
    Q_UNUSED(argv)
    return true;
#endif
}

/// While QApplication is made: a display that is named but does not answer is a fatal message, after a few warnings.
void onlyTellOfMissingDisplay(QtMsgType type, const QMessageLogContext&, const QString&)
{
    if (type != QtFatalMsg)
        return;
    std::fputs(noDisplay, stderr);
    std::_Exit(app::BadInput);
}

/// With fonts, though never on a display. What Qt misses of a desktop meanwhile is nobody's business, but for the
/// platform itself.
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

/// When the model is there.
void enterVrOnce(const app::Document& document, ui::MainWindow& window)
{
    const auto how = static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
    QObject::connect(&document, &app::Document::opened, window.action(QStringLiteral("vr.enter")), &QAction::trigger,
                     how);
}

/// Asks whether the class of a file is to begin, when the first model is there.
void offerOnce(const app::Document& document, ui::MainWindow& window, const QString& classFile)
{
    const auto how = static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
    QObject::connect(
        &document, &app::Document::opened, &window,
        [&window, classFile] { window.findChild<app::ClassFileController*>()->offer(classFile); }, how);
}

/// If that is wanted, before anything asks for VR. Throws CommandFailure.
std::unique_ptr<app::Simulator> simulatorFor(const app::WindowStart& start)
{
    if (!start.simulatesVr)
        return nullptr;
    if (const QString unable = ui::graphicsProblem(); !unable.isEmpty())
        throw app::CommandFailure{unable};
    return app::Simulator::open();
}

/// All goes in the order from below: the window, then the mesh thread with the document, then what it worked for and
/// what kept it. `nextClass` becomes the file of the class that is to begin after that, or empty.
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

/// A class has a program of its own.
int beginClass(const QString& classFile)
{
    if (QProcess::startDetached(QCoreApplication::applicationFilePath(), {QStringLiteral("--classroom"), classFile}))
        return app::Done;
    app::CommandLine::printError(
        app::ClassFile::tr("%1 could not be started.").arg(QCoreApplication::applicationFilePath()));
    return app::BadInput;
}

/// Journals, settings and words are the class's own: what pupils change is not the teacher's. Each start begins as a
/// new user's.
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
        preferX11();
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
    if (vr::RuntimeThread::hasAbandonedWork()) { // it still draws with what Qt and OpenXR keep, should the headset's
                                                 // program wake just now
        std::fflush(nullptr);
        std::_Exit(status);
    }
    return status;
}
} // namespace

int main(int argc, char* argv[])
{
    if (argc == 4 && qstrcmp(argv[1], app::importWord) == 0)
        return app::runImport(argv[2], argv[3]);
    nameProgram();
    app::surviveFileSizeLimit();
    app::installSandboxedImporter();
    QStringList arguments;
    for (int i = 1; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    return app::CommandLine::opensWindow(arguments) ? runWindow(argc, argv)
                                                    : runCommand(argc, argv, app::CommandLine::needsFonts(arguments));
}
