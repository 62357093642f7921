// The house keeps its layout: every #include in core, ui, vr and app goes in the allowed direction, and every source is
// named in its room's CMakeLists.txt.
//
//     core <- ui, core <- vr, {core, ui, vr} <- app
//     Qt: none in core, QtCore and QtGui in vr; OpenMesh in core only; OpenXR in vr only; CGAL in none of them
//     headers of one platform: only in files named after it (gl_context_glx.cpp, file_sync_posix.cpp)

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
const QStringList rooms{"core", "ui", "vr", "app"};

const QMap<QString, QStringList> knownRooms{
    {"core", {"core"}},
    {"ui", {"ui", "core"}},
    {"vr", {"vr", "core"}},
    {"app", {"app", "ui", "vr", "core"}},
};

const QRegularExpression includeLine(R"(^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"])");
const QRegularExpression platformHeader(
    R"(^(GL/(glx|wgl)\w*\.h|(X11|xcb|EGL|sys|linux|mach|wayland-\w+)/.*|(windows|unistd|fcntl|dlfcn|poll|pthread|pwd|sched|spawn|termios|io|direct|process|malloc)\.h)$)",
    QRegularExpression::CaseInsensitiveOption);
const QRegularExpression platformFile(R"(_(glx|wgl|egl|x11|linux|posix|windows|macos)\.(cpp|h|mm)$)");

struct Include
{
    QString header;
    bool quoted = false;
};

/// A quoted include as a path from the project's root.
QString fromFile(const QString& room, const QString& file, const Include& include)
{
    return QDir::cleanPath(room + '/' + file + "/../" + include.header);
}

/// The room an include of ours leads to, seen from room/file; empty when it is not ours.
QString roomOf(const QString& room, const QString& file, const Include& include)
{
    const QString first = include.header.section('/', 0, 0);
    if (rooms.contains(first))
        return first;
    if (!include.quoted)
        return {};
    const QString fromRoot = fromFile(room, file, include).section('/', 0, 0);
    return rooms.contains(fromRoot) ? fromRoot : QString();
}

/// "QtWidgets" for QPushButton, qpushbutton.h and QtWidgets/QPushButton; empty when it is no header of Qt.
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

/// What is wrong with an include in a file of this room; empty when nothing is.
QString fault(const QString& room, const QString& file, const Include& include)
{
    const QString target = roomOf(room, file, include);
    if (!target.isEmpty() && !knownRooms[room].contains(target))
        return room + " must not know " + target;
    if (include.quoted && QFile::exists(FETTLE_SOURCE_DIR "/" + fromFile(room, file, include)))
        return {};
    const QString module = qtModule(include.header);
    if (room == "core" && !module.isEmpty())
        return "core must not know Qt";
    if (room == "vr" && !module.isEmpty() && module != "QtCore" && module != "QtGui")
        return "vr must not know " + module;
    if (room != "core" && include.header.startsWith("OpenMesh/"))
        return "OpenMesh belongs to core";
    if (room != "vr" && include.header.startsWith("openxr/"))
        return "OpenXR belongs to vr";
    if (include.header.startsWith("CGAL/"))
        return "CGAL belongs to the tests";
    if (platformHeader.match(include.header).hasMatch() && !platformFile.match(file).hasMatch())
        return "a header of one platform belongs to a file named after it (_linux, _posix, _windows, _glx, _wgl ...)";
    return {};
}

QStringList faults(const QString& room, const QString& file, const QString& text)
{
    QStringList found;
    int number = 0;
    for (const QString& line : text.split('\n')) {
        ++number;
        const QRegularExpressionMatch match = includeLine.match(line);
        if (!match.hasMatch())
            continue;
        const Include include{match.captured(2), match.captured(1) == "\""};
        const QString reason = fault(room, file, include);
        if (!reason.isEmpty())
            found << QString("%1/%2:%3: %4: %5").arg(room, file).arg(number).arg(include.header, reason);
    }
    return found;
}

QString contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// All files of a room with these endings, relative to it.
QStringList filesOf(const QString& room, const QStringList& endings)
{
    const QDir folder(QString(FETTLE_SOURCE_DIR "/") + room);
    QStringList files;
    for (QDirIterator it(folder.path(), endings, QDir::Files, QDirIterator::Subdirectories); it.hasNext();)
        files << folder.relativeFilePath(it.next());
    files.sort();
    return files;
}

/// One line of a file, to try the scan on.
struct Example
{
    const char* name;
    const char* room;
    const char* file;
    const char* line;
};

const Example badIncludes[] = {
    {"core to ui", "core", "a.cpp", "#include \"ui/viewport.h\""},
    {"core to app, by the back door", "core", "a.cpp", "#include \"../app/document.h\""},
    {"core to vr, from a folder below", "core", "mesh_io/a.cpp", "#include \"../../vr/xr_session.h\""},
    {"core to Qt", "core", "a.h", "#include <QString>"},
    {"core to Qt, by module", "core", "a.h", "  #  include <QtCore/qglobal.h>"},
    {"core to Qt, old name", "core", "a.h", "#include <qstring.h>"},
    {"ui to vr", "ui", "a.cpp", "#include \"vr/xr_session.h\""},
    {"ui to app", "ui", "a.cpp", "#include <app/document.h>"},
    {"ui to OpenXR", "ui", "a.cpp", "#include <openxr/openxr.h>"},
    {"ui to OpenMesh", "ui", "a.cpp", "#include <OpenMesh/Core/Mesh/TriConnectivity.hh>"},
    {"vr to ui", "vr", "a.cpp", "#include \"ui/viewport.h\""},
    {"vr to widgets", "vr", "a.cpp", "#include <QWidget>"},
    {"vr to Qt3D", "vr", "a.cpp", "#include <Qt3DRender/QMesh>"},
    {"vr to Qt3D, short", "vr", "a.cpp", "#include <QAspectEngine>"},
    {"app to OpenXR", "app", "a.cpp", "#include <openxr/openxr.h>"},
    {"CGAL in core", "core", "a.cpp", "#include <CGAL/Surface_mesh.h>"},
    {"GLX anywhere", "vr", "xr_session.cpp", "#include <GL/glx.h>"},
    {"X11 anywhere", "ui", "viewport.cpp", "#include <X11/Xlib.h>"},
    {"POSIX anywhere", "app", "document.cpp", "#include <unistd.h>"},
    {"POSIX in core", "core", "mesh_io.cpp", "#include <sys/mman.h>"},
    {"Windows anywhere", "app", "main.cpp", "#include <Windows.h>"},
};

const Example goodIncludes[] = {
    {"core to core", "core", "a.cpp", "#include \"geometry.h\""},
    {"core to core, from a folder below", "core", "mesh_io/a.cpp", "#include \"../geometry.h\""},
    {"core to OpenMesh", "core", "mesh.h", "#include <OpenMesh/Core/Mesh/TriConnectivity.hh>"},
    {"core to standard", "core", "a.cpp", "#include <vector>"},
    {"ui to core", "ui", "a.cpp", "#include \"core/mesh_patch.h\""},
    {"ui to Qt3D", "ui", "a.cpp", "#include <Qt3DRender/QMesh>"},
    {"vr to QtGui", "vr", "a.cpp", "#include <QOpenGLContext>"},
    {"vr to OpenXR", "vr", "a.cpp", "#include <openxr/openxr.h>"},
    {"app to vr", "app", "a.cpp", "#include \"vr/xr_session.h\""},
    {"GLX in its file", "vr", "gl_binding_glx.cpp", "#include <GL/glx.h>"},
    {"POSIX in its file", "core", "file_sync_posix.cpp", "#include <unistd.h>"},
    {"text that names an include", "core", "a.cpp", "// see #include <QString>"},
};

void addExamples(const Example* first, const Example* last)
{
    QTest::addColumn<QString>("room");
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("line");
    for (; first != last; ++first)
        QTest::newRow(first->name) << QString(first->room) << QString(first->file) << QString(first->line);
}
} // namespace

class TestLayout : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void scan_findsBadInclude_data();
    void scan_findsBadInclude();
    void scan_passesGoodInclude_data();
    void scan_passesGoodInclude();
    void includes_goInTheAllowedDirection_data();
    void includes_goInTheAllowedDirection();
    void sources_areNamedInCMake_data();
    void sources_areNamedInCMake();
    void resources_areNamedInCMake();

private:
    void addRooms();
};

void TestLayout::addRooms()
{
    QTest::addColumn<QString>("room");
    for (const QString& room : rooms)
        QTest::newRow(qPrintable(room)) << room;
}

void TestLayout::scan_findsBadInclude_data()
{
    addExamples(std::begin(badIncludes), std::end(badIncludes));
}

void TestLayout::scan_findsBadInclude()
{
    QFETCH(QString, room);
    QFETCH(QString, file);
    QFETCH(QString, line);
    const QStringList found = faults(room, file, "#pragma once\n" + line + "\n");
    QCOMPARE(found.size(), 1);
    QVERIFY(found.first().startsWith(room + '/' + file + ":2: "));
}

void TestLayout::scan_passesGoodInclude_data()
{
    addExamples(std::begin(goodIncludes), std::end(goodIncludes));
}

void TestLayout::scan_passesGoodInclude()
{
    QFETCH(QString, room);
    QFETCH(QString, file);
    QFETCH(QString, line);
    QCOMPARE(faults(room, file, line), QStringList());
}

void TestLayout::includes_goInTheAllowedDirection_data()
{
    addRooms();
}

void TestLayout::includes_goInTheAllowedDirection()
{
    QFETCH(QString, room);
    const QStringList files = filesOf(room, {"*.h", "*.cpp", "*.mm"});
    QVERIFY(!files.isEmpty());
    QStringList found;
    for (const QString& file : files)
        found << faults(room, file, contents(QString(FETTLE_SOURCE_DIR "/%1/%2").arg(room, file)));
    QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
}

void TestLayout::sources_areNamedInCMake_data()
{
    addRooms();
}

void TestLayout::sources_areNamedInCMake()
{
    QFETCH(QString, room);
    const QString list = contents(QString(FETTLE_SOURCE_DIR "/%1/CMakeLists.txt").arg(room));
    QVERIFY(!list.contains("GLOB"));
    QStringList forgotten;
    for (const QString& file : filesOf(room, {"*.cpp", "*.mm"})) {
        const QRegularExpression word("(^|\\s)" + QRegularExpression::escape(file) + "(\\s|\\)|$)");
        if (!word.match(list).hasMatch())
            forgotten << room + '/' + file;
    }
    QVERIFY2(forgotten.isEmpty(), qPrintable("not in CMakeLists.txt: " + forgotten.join(", ")));
}

void TestLayout::resources_areNamedInCMake()
{
    const QString list = contents(FETTLE_SOURCE_DIR "/resources/resources.cmake");
    QStringList forgotten;
    for (const QString& folder : QStringList{"icons/", "shaders/"}) {
        for (const QString& file : filesOf("resources/" + folder, {"*"})) {
            if (!list.contains(' ' + folder + file))
                forgotten << "resources/" + folder + file;
        }
    }
    QVERIFY2(forgotten.isEmpty(), qPrintable("not in resources.cmake: " + forgotten.join(", ")));
}

QTEST_GUILESS_MAIN(TestLayout)
#include "tst_layout.moc"
