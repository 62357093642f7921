#include "command_line.h"
#include "document.h"
#include "foreign_import.h"
#include "foreign_reader.h"
#include "journal_shelf.h"
#include "process_signals.h"
#include "wiring.h"

#include "ui/main_window.h"
#include "ui/settings.h"
#include "ui/viewport.h"
#include "vr/runtime_thread.h"

#include <QAction>
#include <QApplication>
#include <QLibraryInfo>
#include <QTranslator>

#include <cstdio>
#include <cstdlib>

namespace
{
constexpr const char* noDisplay =
    "fettle: there is no display to open a window on (check, convert, lesson and replay work without one; see fettle --help)\n";

void nameProgram()
{
    QCoreApplication::setOrganizationName(QStringLiteral("Fettle"));
    QCoreApplication::setApplicationName(QStringLiteral("Fettle"));
    QCoreApplication::setApplicationVersion(QStringLiteral(FETTLE_VERSION));
}

/// The window's words and numbers, as chosen; the command line goes by the system.
void chooseLanguage()
{
    const ui::Language language = ui::Settings().preferences().language;
    for (const ui::Named<ui::Language>& row : ui::languages)
        if (row.value == language && language != ui::Language::System)
            QLocale::setDefault(QLocale(QLatin1StringView(row.key)));
}

/// Our own words, and Qt's for its dialogs. They must outlive the texts: they belong to the application.
void loadTranslations(QCoreApplication& application)
{
    const std::pair<QString, QString> catalogues[] = {
        {QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath)},
        {QStringLiteral("fettle"), QStringLiteral(":/i18n")}};
    for (const auto& [name, folder] : catalogues) {
        auto* translator = new QTranslator(&application);
        if (translator->load(QLocale(), name, QStringLiteral("_"), folder))
            QCoreApplication::installTranslator(translator);
    }
}

/// Qt ends a program without a display by abort(). Where X11 or Wayland would be used, we look first and say it in words.
bool canHaveWindow(int argc, char* argv[])
{
#if defined(Q_OS_UNIX) && !defined(Q_OS_MACOS)
    for (int i = 1; i < argc; ++i)
        if (qstrcmp(argv[i], "-platform") == 0 || qstrcmp(argv[i], "--platform") == 0)
            return true;
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY")
           || !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
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

int runCommand(int argc, char* argv[])
{
    const QCoreApplication application(argc, argv);
    loadTranslations(const_cast<QCoreApplication&>(application));
    return app::CommandLine::run(QCoreApplication::arguments().mid(1));
}

/// When the model is there.
void enterVrOnce(const app::Document& document, ui::MainWindow& window)
{
    const auto how = static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
    QObject::connect(&document, &app::Document::opened, window.action(QStringLiteral("vr.enter")), &QAction::trigger, how);
}

/// All goes in the order from below: the window, then the mesh thread with the document, then what it worked for and what kept it.
int showWindow(const app::WindowStart& start)
{
    app::JournalShelf shelf;
    app::SculptWorker worker;
    const auto inbox = std::make_shared<app::PatchInbox>();
    app::Document document(&worker);
    ui::MainWindow window;
    app::wire(window, document, worker, inbox);
    app::wireRecovery(window, document, shelf);
    window.show();
    if (start.entersVr)
        enterVrOnce(document, window);
    if (start.file.isEmpty())
        document.openSphere();
    else
        document.open(start.file);
    if (start.file.isEmpty() && !start.entersVr && ui::Settings().showsStartPage())
        window.action(QStringLiteral("help.start"))->trigger();
    return QApplication::exec();
}

int runWindow(int argc, char* argv[])
{
    if (!canHaveWindow(argc, argv)) {
        std::fputs(noDisplay, stderr);
        return app::BadInput;
    }
    ui::prepareGraphics();
    const QtMessageHandler usual = qInstallMessageHandler(onlyTellOfMissingDisplay);
    QApplication application(argc, argv);
    qInstallMessageHandler(usual);
    chooseLanguage();
    loadTranslations(application);

    app::WindowStart start;
    try {
        start = app::CommandLine::windowStart(QCoreApplication::arguments().mid(1));
    } catch (const app::CommandFailure& failure) {
        app::CommandLine::printError(failure.sentence);
        return failure.status;
    }

    const int status = showWindow(start);
    if (vr::RuntimeThread::hasLeftWork()) { // it still draws with what Qt and OpenXR keep, should the headset's program wake just now
        std::fflush(nullptr);
        std::_Exit(status);
    }
    return status;
}
} // namespace

int main(int argc, char* argv[])
{
    if (argc == 3 && qstrcmp(argv[1], app::foreignWord) == 0)
        return app::importForeign(argv[2]);
    nameProgram();
    app::surviveFileSizeLimit();
    app::installForeignReader();
    QStringList arguments;
    for (int i = 1; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    return app::CommandLine::isCommand(arguments) ? runCommand(argc, argv) : runWindow(argc, argv);
}
