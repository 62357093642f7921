// Checks the layout of the sources: which folders may include which others, which libraries a folder may use, the
// number of files in a folder, and that the build lists every file.

#include "tests/support/test_main.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QLibraryInfo>
#include <QMap>
#include <QRegularExpression>
#include <QTest>

#include <iterator>

namespace
{
struct FolderRule
{
    const char* folder;
    const char* mayInclude; ///< folders that it may include besides itself
};

/// Every folder of the program with the folders that it may include. A folder comes after those that it includes.
/// Exception: core/io/mesh includes core/io, because both are one module.
const FolderRule folderRules[] = {
    {"core/util", ""},
    {"core/geometry", "core/util"},
    {"core/parts", "core/geometry"},
    {"core/analysis", "core/util core/geometry core/parts"},
    {"core/print", "core/util core/geometry core/analysis"},
    {"core/stroke", "core/geometry"},
    {"core/mesh", "core/util core/geometry core/parts core/analysis"},
    {"core/repair", "core/util core/geometry core/analysis"},
    {"core/boolean", "core/util core/geometry core/analysis core/repair"},
    {"core/drawing", "core/geometry core/mesh"},
    {"core/render", "core/geometry core/mesh core/parts"},
    {"core/sculpt/select", "core/util core/geometry core/stroke core/mesh"},
    {"core/sculpt/edit", "core/util core/stroke core/mesh"},
    {"core/sculpt/verify", "core/util core/geometry core/analysis core/mesh core/sculpt/select"},
    {"core/sculpt/remesh", "core/util core/geometry core/mesh core/sculpt/select core/sculpt/edit"},
    {"core/sculpt/deform", "core/util core/geometry core/analysis core/stroke core/mesh core/sculpt/select "
                           "core/sculpt/edit"},
    {"core/sculpt/fuse", "core/util core/geometry core/mesh core/sculpt/select core/sculpt/edit "
                         "core/sculpt/verify core/sculpt/remesh core/sculpt/deform"},
    {"core/sculpt/copy", "core/util core/geometry core/stroke core/mesh core/sculpt/verify"},
    {"core/sculpt", "core/util core/geometry core/analysis core/repair core/stroke core/mesh core/sculpt/select "
                    "core/sculpt/edit core/sculpt/verify core/sculpt/remesh core/sculpt/deform core/sculpt/fuse "
                    "core/sculpt/copy"},
    {"core/decimation", "core/util core/geometry core/parts core/analysis core/mesh core/sculpt/verify"},
    {"core/primitives", "core/util core/geometry core/analysis core/boolean core/stroke"},
    {"core/area", "core/util core/geometry core/stroke core/mesh"},
    {"core/operations", "core/util core/geometry core/parts core/analysis core/boolean core/stroke core/mesh "
                        "core/sculpt/edit core/sculpt/verify core/sculpt/remesh core/primitives core/area"},
    {"core/io/stroke", "core/util core/geometry core/stroke core/sculpt/deform core/operations"},
    {"core/io/mesh", "core/util core/geometry core/parts core/sculpt/deform core/io/stroke core/io"},
    {"core/io", "core/util core/geometry core/parts core/analysis core/stroke core/mesh core/io/mesh"},
    {"core/journal", "core/util core/mesh core/operations core/io/stroke core/io"},
    {"core/lesson",
     "core/primitives core/util core/geometry core/analysis core/print core/mesh core/sculpt core/operations "
     "core/io/stroke core/io/mesh core/io"},
    {"core/preset",
     "core/primitives core/stroke core/mesh core/drawing core/sculpt/deform core/sculpt core/operations"},
    {"ui/util",
     "core/util core/geometry core/parts core/analysis core/print core/stroke core/repair core/io/stroke core/io"},
    {"ui/settings", "core/geometry core/print core/stroke core/sculpt/deform core/io ui/util"},
    {"ui/widgets", "ui/util ui/settings"},
    {"ui/actions", "ui/settings ui/widgets"},
    {"ui/scene", "core/geometry core/parts core/stroke core/mesh core/render core/io ui/settings"},
    {"ui/input", "core/stroke core/mesh ui/settings ui/scene"},
    {"ui/viewport", "core/parts core/stroke core/mesh core/render ui/util ui/settings ui/widgets ui/actions ui/scene "
                    "ui/input"},
    {"ui/gizmo",
     "core/geometry core/parts core/stroke core/operations ui/util ui/settings ui/widgets ui/actions ui/scene ui/input "
     "ui/viewport"},
    {"ui/model",
     "core/primitives core/analysis core/print core/repair core/operations ui/settings ui/widgets ui/actions "
     "ui/viewport"},
    {"ui/shapes", "core/geometry core/primitives core/mesh core/operations ui/util ui/settings ui/widgets ui/actions "
                  "ui/scene ui/input ui/viewport ui/model"},
    {"ui/files", "core/primitives core/util core/drawing core/operations core/io ui/util ui/settings ui/widgets "
                 "ui/actions ui/scene "
                 "ui/model"},
    {"ui/brush", "core/util core/geometry core/stroke core/drawing core/sculpt/deform core/io/stroke core/io "
                 "core/preset ui/util ui/settings ui/widgets "
                 "ui/actions ui/viewport"},
    {"ui/reference", "core/io ui/util ui/settings ui/widgets ui/actions ui/scene ui/viewport ui/files"},
    {"ui/drawing", "core/util core/drawing ui/util ui/settings ui/widgets ui/actions"},
    {"ui/print", "core/print core/mesh ui/util ui/settings ui/widgets ui/actions ui/viewport"},
    {"ui/history", "ui/settings ui/widgets"},
    {"ui/parts", "core/geometry core/parts core/operations ui/util ui/widgets ui/actions"},
    {"ui/lesson", "core/primitives core/operations core/lesson ui/widgets ui/actions"},
    {"ui/preferences", "ui/settings ui/widgets ui/actions ui/viewport"},
    {"ui/classroom",
     "core/primitives core/util core/analysis core/stroke core/operations core/io ui/util ui/settings ui/widgets "
     "ui/actions ui/lesson ui/preferences"},
    {"ui/headset", "core/geometry core/stroke ui/util ui/settings ui/widgets ui/actions ui/scene ui/viewport "
                   "ui/brush ui/classroom"},
    {"ui/help", "ui/settings ui/widgets ui/actions ui/files ui/lesson"},
    {"ui/window",
     "core/primitives core/operations core/io ui/util ui/settings ui/widgets ui/actions ui/scene ui/viewport "
     "ui/gizmo ui/model ui/shapes ui/files ui/brush ui/reference ui/drawing ui/print ui/history ui/parts ui/lesson "
     "ui/preferences ui/classroom ui/headset ui/help"},
    {"vr/util", "core/util core/geometry"},
    {"vr/gl", ""},
    {"vr/openxr", "vr/util vr/gl"},
    {"vr/input", "core/geometry vr/util vr/openxr"},
    {"vr/frame", "core/util vr/util vr/gl vr/openxr"},
    {"vr/scene", "core/geometry core/stroke core/mesh core/render core/parts core/io/mesh vr/util vr/gl vr/openxr "
                 "vr/input"},
    {"vr/panels",
     "core/stroke core/boolean core/parts core/primitives vr/util vr/gl vr/openxr vr/input vr/frame vr/scene"},
    {"vr/sculpt",
     "core/primitives core/util core/stroke core/mesh core/render core/parts core/operations vr/util vr/input vr/frame "
     "vr/scene vr/panels"},
    {"vr/simulator", "vr/util"},
    {"app/platform", "core/util"},
    {"app/import", "core/util core/geometry core/parts core/io/mesh core/io app/platform"},
    {"app/model",
     "core/primitives core/util core/geometry core/parts core/analysis core/print core/boolean core/mesh core/drawing "
     "core/repair core/sculpt core/decimation core/operations core/io/stroke core/io ui/util ui/settings ui/model "
     "ui/files ui/brush app/import"},
    {"app/worker", "core/util core/stroke core/mesh core/drawing core/sculpt core/io/stroke core/journal ui/util "
                   "ui/drawing"},
    {"app/recovery", "core/sculpt core/journal ui/util app/platform app/model"},
    {"app/document",
     "core/primitives core/util core/stroke core/mesh core/drawing core/sculpt core/operations core/io/stroke "
     "core/io core/journal core/geometry core/parts core/analysis ui/util ui/settings ui/widgets ui/viewport ui/model "
     "ui/brush ui/history ui/window app/model app/worker app/recovery"},
    {"app/analysis",
     "core/util core/geometry core/parts core/analysis core/print core/mesh core/sculpt core/operations ui/util "
     "ui/print app/worker app/document"},
    {"app/lesson",
     "core/primitives core/util core/mesh core/drawing core/sculpt/deform core/sculpt core/operations core/io "
     "core/journal core/lesson ui/util ui/settings ui/widgets ui/viewport ui/lesson ui/help ui/window app/model "
     "app/worker app/document app/analysis"},
    {"app/classroom",
     "core/util core/geometry core/drawing core/io/stroke core/io core/lesson ui/util ui/settings "
     "ui/widgets ui/viewport ui/files ui/lesson ui/classroom ui/window app/model app/worker app/recovery "
     "app/document app/lesson"},
    {"app/commands",
     "core/primitives core/util core/geometry core/parts core/analysis core/print core/mesh core/repair core/boolean "
     "core/sculpt core/decimation core/operations core/io/stroke core/io core/lesson ui/util ui/brush ui/drawing "
     "app/platform app/model app/document app/classroom app/lesson"},
    {"app/headset",
     "core/sculpt core/operations ui/util ui/settings ui/scene ui/viewport ui/files ui/brush "
     "ui/lesson ui/headset ui/window vr/openxr vr/input vr/frame vr/scene vr/panels vr/sculpt vr/simulator app/worker "
     "app/document app/commands"},
    {"app/window",
     "ui/util ui/viewport ui/gizmo ui/model ui/shapes ui/brush ui/reference ui/drawing ui/print ui/history ui/parts "
     "ui/headset ui/window app/worker app/recovery app/document app/analysis app/classroom app/lesson app/headset"},
    {"app",
     "app/classroom app/commands app/document app/headset app/import app/platform app/recovery app/window app/worker"
     " ui/scene ui/settings ui/util ui/viewport ui/widgets ui/window vr/openxr"},
};

const QStringList libraries{"core", "ui", "vr", "app"};
constexpr qsizetype maxFiles = 40;
/// Folders that may exceed maxFiles: one has many formats, the other a file for each part of a specification.
const QStringList largeFolders{"core/io/mesh", "vr/simulator"};

// not a raw string, because moc miscounts the quotes in one
const QRegularExpression includeLine("^[ \\t]*#[ \\t]*include[ \\t]*([<\"])([^>\"]+)[>\"]");
const QRegularExpression platformHeader(
    R"(^(GL/(glx|wgl)\w*\.h|(X11|xcb|EGL|sys|linux|mach|wayland-\w+)/.*|(windows|unistd|fcntl|dlfcn|poll|)"
    R"(pthread|pwd|sched|spawn|termios|io|direct|process|malloc|psapi|shellapi|shlobj|winioctl|unknwn|)"
    R"(execinfo|langinfo|grp|netdb)\.h)$)",
    QRegularExpression::CaseInsensitiveOption);
const QRegularExpression platformFile(R"(_(glx|wgl|egl|x11|linux|posix|windows|macos)\.(cpp|h|mm)$)");

/// A pattern that no source line may match, and the reason.
struct LineRule
{
    QRegularExpression line;
    const char* reason;
    bool isForPlatformFiles = true; ///< false: lines of platform files may match
};
const LineRule lineRules[] = {
    // Only unindented lines match, because namespaces are not indented.
    {QRegularExpression(R"(^using[ \t]+(enum|namespace)\b)"),
     "at namespace scope it reaches the next files of a unity build"},
    {QRegularExpression(R"(\bXR_CURRENT_API_VERSION\b)"),
     "it is the version of the headers, and runtimes of OpenXR 1.0 refuse 1.1"},
    {QRegularExpression(R"(^[ \t]*#[ \t]*(if|ifdef|ifndef|elif)\b.*\b(_?_?(WIN32|WIN64|WINNT|linux|unix|APPLE|MACH|)"
                        R"(MINGW32|MINGW64|FreeBSD|ANDROID)(__)?|_MSC_VER|Q_OS_\w+|Q_CC_(MSVC|MINGW))\b)"),
     "what differs between platforms belongs to a file named after each (_posix, _windows, _glx, _wgl ...)", false},
};

struct Include
{
    QString header;
    bool isQuoted = false;
};

/// Returns the folder of a file, for example "core/mesh" for "core/mesh/mesh.h".
QString folderOf(const QString& path)
{
    return path.section('/', 0, -2);
}

QMap<QString, QStringList> allowedFolders()
{
    QMap<QString, QStringList> allowed;
    for (const FolderRule& rule : folderRules)
        allowed[rule.folder] = QString(rule.mayInclude).split(' ', Qt::SkipEmptyParts) + QStringList(rule.folder);
    return allowed;
}

/// Returns the Qt module of a header, for example "QtWidgets" for QPushButton, qpushbutton.h and QtWidgets/QPushButton.
/// Empty if the header is not Qt's.
QString qtModule(const QString& header)
{
    const QDir headers(QLibraryInfo::path(QLibraryInfo::HeadersPath));
    static const QStringList modules = headers.entryList({"Qt*"}, QDir::Dirs);
    if (header.contains('/'))
        return modules.contains(header.section('/', 0, 0)) ? header.section('/', 0, 0) : QString();
    for (const QString& module : modules) {
        if (headers.exists(module + '/' + header))
            return module;
    }
    return {};
}

/// Returns the error of including a header of this project, or an empty text.
QString ownFault(const QString& path, const QString& header)
{
    static const QMap<QString, QStringList> allowed = allowedFolders();
    const QString from = folderOf(path), to = folderOf(header);
    if (from.startsWith("tests"))
        return {};
    if (!allowed.value(from).contains(to))
        return from + " must not include " + to;
    return {};
}

/// Returns the error of including a header of a library or the system, or an empty text.
QString otherHeaderFault(const QString& path, const QString& header)
{
    const QString library = path.section('/', 0, 0), module = qtModule(header);
    static const QStringList modulesOfVr{"QtCore", "QtGui", "QtOpenGL"};
    if (library == "core" && !module.isEmpty())
        return "core must not include Qt";
    if (library == "vr" && !module.isEmpty() && !modulesOfVr.contains(module))
        return "vr must not include " + module;
    if (library == "tests")
        return {};
    if (library != "core" && header.startsWith("OpenMesh/"))
        return "OpenMesh belongs to core";
    if (library != "vr" && header.startsWith("openxr/"))
        return "OpenXR belongs to vr";
    if (header.startsWith("Qt3D") && !path.startsWith("ui/scene/qt3d_"))
        return "Qt3D belongs to the files of ui/scene that are named after it";
    if (header.startsWith("CGAL/"))
        return "CGAL belongs to the tests";
    if (platformHeader.match(header).hasMatch() && !platformFile.match(path).hasMatch())
        return "a header of one platform belongs to a file named after it (_linux, _posix, _windows, _glx, _wgl ...)";
    return {};
}

/// Returns the error of an include, or an empty text.
QString fault(const QString& path, const Include& include)
{
    if (include.header.endsWith(".moc"))
        return {};
    if (include.header.contains(".."))
        return "includes are written from the project's root";
    const QString library = include.header.section('/', 0, 0);
    if (libraries.contains(library) || library == "tests")
        return include.isQuoted ? ownFault(path, include.header) : QString("files of ours are included with quotes");
    if (include.isQuoted)
        return "includes of ours are written from the project's root, others in angle brackets";
    return otherHeaderFault(path, include.header);
}

QStringList faults(const QString& path, const QString& text)
{
    QStringList found;
    int number = 0;
    for (const QString& line : text.split('\n')) {
        ++number;
        const QRegularExpressionMatch match = includeLine.match(line);
        if (!match.hasMatch())
            continue;
        const Include include{match.captured(2), match.captured(1) == "\""};
        const QString reason = fault(path, include);
        if (!reason.isEmpty())
            found << QString("%1:%2: %3: %4").arg(path).arg(number).arg(include.header, reason);
    }
    return found;
}

QStringList brokenLineRules(const QString& path, const QString& text)
{
    const bool isPlatform = platformFile.match(path).hasMatch();
    QStringList found;
    int number = 0;
    for (const QString& line : text.split('\n')) {
        ++number;
        for (const LineRule& rule : lineRules)
            if ((rule.isForPlatformFiles || !isPlatform) && rule.line.match(line).hasMatch())
                found << QString("%1:%2: %3: %4").arg(path).arg(number).arg(line, QString(rule.reason));
    }
    return found;
}

QString contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Returns all files below a folder with these endings, as paths from the project's root.
QStringList filesBelow(const QString& folder, const QStringList& endings)
{
    const QDir root(FETTLE_SOURCE_DIR);
    QStringList files;
    for (QDirIterator it(root.filePath(folder), endings, QDir::Files, QDirIterator::Subdirectories); it.hasNext();)
        files << root.relativeFilePath(it.next());
    files.sort();
    return files;
}

QStringList sources(const QString& folder)
{
    return filesBelow(folder, {"*.h", "*.cpp", "*.mm"});
}

/// A line of a file, as a test case for includes.
struct Example
{
    const char* name;
    const char* path;
    const char* line;
};

const Example badIncludes[] = {
    {"core to ui", "core/mesh/a.cpp", "#include \"ui/viewport/viewport.h\""},
    {"core to app, relative", "core/mesh/a.cpp", "#include \"../../app/document/document.h\""},
    {"beside it, relative", "core/mesh/a.cpp", "#include \"mesh.h\""},
    {"the folder beside it, relative", "core/mesh/a.cpp", "#include \"../util/slot.h\""},
    {"up the folders", "core/util/a.cpp", "#include \"core/mesh/mesh.h\""},
    {"a later step of the engine", "core/sculpt/select/a.cpp", "#include \"core/sculpt/deform/deform.h\""},
    {"a feature above", "ui/model/a.cpp", "#include \"ui/files/model_files.h\""},
    {"no folder of ours", "core/mesh/a.cpp", "#include \"core/mesh.h\""},
    {"a file in no folder", "core/a.cpp", "#include \"core/util/slot.h\""},
    {"ours in angle brackets", "ui/scene/a.cpp", "#include <core/mesh/mesh_patch.h>"},
    {"a test, relative", "tests/core/mesh/a.cpp", "#include \"../support/shapes.h\""},
    {"core to tests", "core/mesh/a.cpp", "#include \"tests/support/shapes.h\""},
    {"core to Qt", "core/mesh/a.h", "#include <QString>"},
    {"core to Qt, by module", "core/mesh/a.h", "  #  include <QtCore/qglobal.h>"},
    {"core to Qt, old name", "core/mesh/a.h", "#include <qstring.h>"},
    {"ui to vr", "ui/scene/a.cpp", "#include \"vr/openxr/xr_session.h\""},
    {"ui to app", "ui/scene/a.cpp", "#include \"app/document/document.h\""},
    {"ui to Qt3D", "ui/scene/scene.cpp", "#include <Qt3DRender/QMesh>"},
    {"ui to OpenXR", "ui/scene/a.cpp", "#include <openxr/openxr.h>"},
    {"ui to OpenMesh", "ui/scene/a.cpp", "#include <OpenMesh/Core/Mesh/TriConnectivity.hh>"},
    {"vr to ui", "vr/scene/a.cpp", "#include \"ui/viewport/viewport.h\""},
    {"vr to widgets", "vr/scene/a.cpp", "#include <QWidget>"},
    {"vr to Qt3D", "vr/scene/a.cpp", "#include <Qt3DRender/QMesh>"},
    {"vr to Qt3D, short", "vr/scene/a.cpp", "#include <QAspectEngine>"},
    {"app to OpenXR", "app/headset/a.cpp", "#include <openxr/openxr.h>"},
    {"CGAL in core", "core/mesh/a.cpp", "#include <CGAL/Surface_mesh.h>"},
    {"GLX anywhere", "vr/openxr/xr_session.cpp", "#include <GL/glx.h>"},
    {"X11 anywhere", "ui/viewport/viewport.cpp", "#include <X11/Xlib.h>"},
    {"POSIX anywhere", "app/document/document.cpp", "#include <unistd.h>"},
    {"POSIX in core", "core/io/mesh_io.cpp", "#include <sys/mman.h>"},
    {"Windows anywhere", "app/main.cpp", "#include <Windows.h>"},
    {"a part of Windows anywhere", "app/main.cpp", "#include <shellapi.h>"},
};

const Example goodIncludes[] = {
    {"beside it", "core/mesh/a.cpp", "#include \"core/mesh/mesh.h\""},
    {"down the folders", "core/mesh/a.cpp", "#include \"core/util/slot.h\""},
    {"core to OpenMesh", "core/mesh/mesh.h", "#include <OpenMesh/Core/Mesh/TriConnectivity.hh>"},
    {"core to standard", "core/mesh/a.cpp", "#include <vector>"},
    {"ui to core", "ui/scene/a.cpp", "#include \"core/mesh/mesh_patch.h\""},
    {"ui to Qt3D", "ui/scene/qt3d_engine.cpp", "#include <Qt3DRender/QMesh>"},
    {"vr to QtGui", "vr/scene/a.cpp", "#include <QOpenGLContext>"},
    {"vr to QtOpenGL", "vr/gl/a.cpp", "#include <QOpenGLShaderProgram>"},
    {"vr to OpenXR", "vr/openxr/a.cpp", "#include <openxr/openxr.h>"},
    {"app to vr", "app/headset/a.cpp", "#include \"vr/frame/headset_thread.h\""},
    {"a test to anything", "tests/core/mesh/a.cpp", "#include \"core/sculpt/sculptor.h\""},
    {"its moc file", "tests/core/mesh/tst_mesh.cpp", "#include \"tst_mesh.moc\""},
    {"GLX in its file", "vr/gl/gl_binding_glx.cpp", "#include <GL/glx.h>"},
    {"POSIX in its file", "core/util/file_sync_posix.cpp", "#include <unistd.h>"},
    {"text that names an include", "core/mesh/a.cpp", "// see #include <QString>"},
};

/// A line, as a test case for the line rules.
struct LineExample
{
    const char* name;
    const char* line;
    int broken; ///< number of broken rules
};

const LineExample lineExamples[] = {
    {"using enum at namespace scope", "using enum HandMode;", 1},
    {"using namespace at namespace scope", "using  namespace std::chrono_literals;", 1},
    {"using enum in a function", "    using enum HandMode;", 0},
    {"using namespace in a function", "    using namespace std::chrono;", 0},
    {"type alias", "using Clock = std::chrono::steady_clock;", 0},
    {"text that names a directive", "// using enum is for functions", 0},
    {"version of the OpenXR headers", "    info.applicationInfo.apiVersion = XR_CURRENT_API_VERSION;", 1},
    {"version of OpenXR", "    info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 20);", 0},
    {"Windows", "#ifdef _WIN32", 1},
    {"not Windows", "  #  ifndef __MINGW32__", 1},
    {"Linux", "#if defined(__linux__)", 1},
    {"Linux, among others", "#elif defined(Q_OS_UNIX) && !defined(Q_OS_MACOS)", 1},
    {"Apple", "#if __APPLE__", 1},
    {"a compiler", "#if defined(__GNUC__) && !defined(__clang__)", 0},
    {"a feature of the system", "#ifdef MADV_HUGEPAGE", 0},
    {"text that names a platform", "/// Windows has no __linux__, see #ifdef _WIN32", 0},
};

void addExamples(const Example* first, const Example* last)
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("line");
    for (; first != last; ++first)
        QTest::newRow(first->name) << QString(first->path) << QString(first->line);
}
} // namespace

class TestSourceLayout : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void scan_findsBadInclude_data();
    void scan_findsBadInclude();
    void scan_passesGoodInclude_data();
    void scan_passesGoodInclude();
    void folders_haveNoCycle();
    void folders_areInTheTable();
    void folders_areSmall();
    void includes_followTheTable_data();
    void includes_followTheTable();
    void lineRules_findWhatTheyForbid_data();
    void lineRules_findWhatTheyForbid();
    void platformFiles_mayAskForThePlatform();
    void lines_keepTheRules();
    void sources_areNamedInCMake_data();
    void sources_areNamedInCMake();
    void resources_areNamedInCMake();
};

void TestSourceLayout::scan_findsBadInclude_data()
{
    addExamples(std::begin(badIncludes), std::end(badIncludes));
}

void TestSourceLayout::scan_findsBadInclude()
{
    QFETCH(QString, path);
    QFETCH(QString, line);
    const QStringList found = faults(path, "#pragma once\n" + line + "\n");
    QCOMPARE(found.size(), 1);
    QVERIFY(found.first().startsWith(path + ":2: "));
}

void TestSourceLayout::scan_passesGoodInclude_data()
{
    addExamples(std::begin(goodIncludes), std::end(goodIncludes));
}

void TestSourceLayout::scan_passesGoodInclude()
{
    QFETCH(QString, path);
    QFETCH(QString, line);
    QCOMPARE(faults(path, line), QStringList());
}

/// Each folder in the table must come after those that it includes, so that there is no cycle.
void TestSourceLayout::folders_haveNoCycle()
{
    const QMap<QString, QStringList> allowed = allowedFolders();
    QStringList above;
    for (const FolderRule& rule : folderRules) {
        above << rule.folder;
        for (const QString& folder : allowed.value(rule.folder)) {
            if (QString(rule.folder) == "core/io/mesh" && folder == "core/io")
                continue;
            QVERIFY2(above.contains(folder), qPrintable(rule.folder + (" includes " + folder)));
        }
    }
}

/// Every source except main.cpp must be in a folder of the table, and every folder of the table must exist.
void TestSourceLayout::folders_areInTheTable()
{
    QStringList present;
    for (const QString& library : libraries) {
        for (const QString& file : sources(library))
            present << folderOf(file);
    }
    present.removeDuplicates();
    present.sort();
    QStringList listed = allowedFolders().keys();
    listed.sort();
    QCOMPARE(present, listed);
    QCOMPARE(QDir(FETTLE_SOURCE_DIR "/app").entryList({"*.h", "*.cpp"}, QDir::Files), QStringList("main.cpp"));
}

void TestSourceLayout::folders_areSmall()
{
    QMap<QString, qsizetype> count;
    for (const QString& library : libraries + QStringList("tests")) {
        for (const QString& file : sources(library))
            ++count[folderOf(file)];
    }
    QStringList large;
    for (auto [folder, files] : count.asKeyValueRange()) {
        if (files > maxFiles && !largeFolders.contains(folder))
            large << QString("%1: %2 files").arg(folder).arg(files);
    }
    QVERIFY2(large.isEmpty(), qPrintable(large.join('\n')));
}

void TestSourceLayout::includes_followTheTable_data()
{
    QTest::addColumn<QString>("folder");
    for (const QString& folder : libraries + QStringList("tests"))
        QTest::newRow(qPrintable(folder)) << folder;
}

void TestSourceLayout::includes_followTheTable()
{
    QFETCH(QString, folder);
    const QStringList files = sources(folder);
    QVERIFY(!files.isEmpty());
    QStringList found;
    for (const QString& file : files)
        found << faults(file, contents(FETTLE_SOURCE_DIR "/" + file));
    QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
}

void TestSourceLayout::lineRules_findWhatTheyForbid_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<int>("broken");
    for (const LineExample& example : lineExamples)
        QTest::newRow(example.name) << QString(example.line) << example.broken;
}

void TestSourceLayout::lineRules_findWhatTheyForbid()
{
    QFETCH(QString, line);
    QFETCH(int, broken);
    const QStringList found = brokenLineRules("vr/input/a.cpp", "#pragma once\n" + line + "\n");
    QCOMPARE(found.size(), broken);
    for (const QString& sentence : found)
        QVERIFY(sentence.startsWith("vr/input/a.cpp:2: "));
}

/// Only files of a platform may ask which system they are compiled for.
void TestSourceLayout::platformFiles_mayAskForThePlatform()
{
    const QString text = "#ifdef __linux__\n";
    QCOMPARE(brokenLineRules("vr/gl/a.cpp", text).size(), 1);
    QCOMPARE(brokenLineRules("vr/gl/a_posix.h", text), QStringList());
    QCOMPARE(brokenLineRules("vr/gl/a_windows.cpp", text), QStringList());
}

void TestSourceLayout::lines_keepTheRules()
{
    QStringList found;
    for (const QString& library : libraries) {
        for (const QString& file : sources(library))
            found << brokenLineRules(file, contents(FETTLE_SOURCE_DIR "/" + file));
    }
    QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
}

void TestSourceLayout::sources_areNamedInCMake_data()
{
    QTest::addColumn<QString>("library");
    for (const QString& library : libraries)
        QTest::newRow(qPrintable(library)) << library;
}

void TestSourceLayout::sources_areNamedInCMake()
{
    QFETCH(QString, library);
    QStringList forgotten;
    for (const QString& file : sources(library)) {
        const QString list = contents(FETTLE_SOURCE_DIR "/" + folderOf(file) + "/CMakeLists.txt");
        QVERIFY2(!list.contains("GLOB"), qPrintable(file));
        const QString name = file.section('/', -1);
        const QRegularExpression word("(^|\\s)" + QRegularExpression::escape(name) + "(\\s|\\)|$)");
        if (!word.match(list).hasMatch())
            forgotten << file;
    }
    QVERIFY2(forgotten.isEmpty(), qPrintable("not in CMakeLists.txt: " + forgotten.join(", ")));
}

void TestSourceLayout::resources_areNamedInCMake()
{
    const QString list = contents(FETTLE_SOURCE_DIR "/resources/resources.cmake");
    QStringList forgotten;
    for (const QString& folder : QStringList{"icons", "shaders"}) {
        for (const QString& file : filesBelow("resources/" + folder, {"*"})) {
            if (!list.contains(' ' + file.section('/', 1)))
                forgotten << file;
        }
    }
    QVERIFY2(forgotten.isEmpty(), qPrintable("not in resources.cmake: " + forgotten.join(", ")));
}

FETTLE_TEST(TestSourceLayout, QCoreApplication)
#include "tst_source_layout.moc"
