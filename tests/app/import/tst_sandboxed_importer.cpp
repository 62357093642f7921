// Tests formats imported through Assimp with files from Assimp's own exporters. Hostile files and failing readers must
// not affect the program.

#include "app/import/assimp_import.h"
#include "app/import/sandboxed_importer.h"
#include "app/platform/child_process.h"
#include "app/platform/resource_limits.h"
#include "core/io/mesh_io.h"
#include "core/util/file_error.h"
#include "tests/support/effort.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QElapsedTimer>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include <clocale>
#include <random>
#include <thread>

#ifdef Q_OS_UNIX
#include <csignal>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace
{
using core::FileError;
using core::TriangleMesh;
using core::Vec3f;
using Kind = core::FileErrorKind;

constexpr unsigned seed = 20261122;
const core::Rgb color{255, 128, 0};

/// Returns a scene with one node that has the mesh, coloured if requested.
std::unique_ptr<aiScene> sceneOf(const TriangleMesh& mesh, const aiMatrix4x4& transform, bool isColored)
{
    auto scene = std::make_unique<aiScene>();
    auto* to = new aiMesh;
    to->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    to->mNumVertices = static_cast<unsigned>(mesh.points.size());
    to->mVertices = new aiVector3D[mesh.points.size()];
    to->mNormals = new aiVector3D[mesh.points.size()];
    if (isColored)
        to->mColors[0] = new aiColor4D[mesh.points.size()];
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        to->mVertices[i] = {mesh.points[i].x(), mesh.points[i].y(), mesh.points[i].z()};
        to->mNormals[i] = {0, 1, 0};
        if (isColored)
            to->mColors[0][i] = {1, 128 / 255.0F, 0, 1};
    }
    to->mNumFaces = static_cast<unsigned>(mesh.triangles.size());
    to->mFaces = new aiFace[mesh.triangles.size()];
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        to->mFaces[i].mNumIndices = 3;
        to->mFaces[i].mIndices = new unsigned[3]{mesh.triangles[i][0], mesh.triangles[i][1], mesh.triangles[i][2]};
    }
    scene->mNumMeshes = scene->mNumMaterials = 1;
    scene->mMeshes = new aiMesh* [1] { to };
    scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
    scene->mRootNode = new aiNode("root");
    auto* node = new aiNode("model");
    node->mTransformation = transform;
    node->mNumMeshes = 1;
    node->mMeshes = new unsigned[1]{0};
    scene->mRootNode->addChildren(1, &node);
    return scene;
}

double volume(const TriangleMesh& mesh)
{
    double six = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        six += mesh.points[a].cast<double>().dot(mesh.points[b].cast<double>().cross(mesh.points[c].cast<double>()));
    return six / 6;
}
} // namespace

class TestSandboxedImporter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_dir.isValid());
        app::installSandboxedImporter(); // installs the importer's setup in the test, which itself is not an importer
        core::setExternalReader(app::sandboxedImporter(FETTLE_PROGRAM));
    }

    void endings_areAssimps();
    void formats_areRead_data();
    void formats_areRead();
    void mirroredNodes_stayOutward();
    void commas_changeNothing();
    void commands_takeThem();

    void brokenReaders_areOneSentence_data();
    void brokenReaders_areOneSentence();
    void whoStops_waitsForNobody();
    void slowReaders_areEnded();
    void hungryFiles_areRefused();
    void ownLimits_hold();
    void badFiles_areRefused();
    void filesBeyondTheFolder_areNotRead();
    void mutatedFiles_neverGetThrough();

private:
    std::filesystem::path file(const QString& name) const { return m_dir.filePath(name).toStdU16String(); }
    std::filesystem::path written(const char* exporter, const QString& name, const TriangleMesh& mesh, bool isColored,
                                  const aiMatrix4x4& transform = {}) const
    {
        const auto scene = sceneOf(mesh, transform, isColored);
        Assimp::Exporter().Export(scene.get(), exporter, file(name).string());
        return file(name);
    }
    void write(const QString& name, const QByteArray& bytes) const
    {
        QFile to(m_dir.filePath(name));
        QVERIFY(to.open(QIODevice::WriteOnly) && to.write(bytes) == bytes.size());
    }
    std::string script(const QByteArray& lines) const
    {
        write(QStringLiteral("reader.sh"), "#!/bin/sh\n" + lines + "\n");
        QFile::setPermissions(m_dir.filePath(QStringLiteral("reader.sh")), QFile::ReadOwner | QFile::ExeOwner);
        return file(QStringLiteral("reader.sh")).string();
    }
    static std::optional<FileError> errorOf(const std::function<void()>& action)
    {
        try {
            action();
        } catch (const FileError& error) {
            return error;
        }
        return std::nullopt;
    }

    QTemporaryDir m_dir;
};

void TestSandboxedImporter::endings_areAssimps()
{
    const Assimp::Importer importer;
    for (const std::string_view ending : core::externalReader().endings) {
        QVERIFY2(importer.IsExtensionSupported("." + std::string(ending)), ending.data());
        QVERIFY2(!core::meshFormatOf("a." + std::string(ending)), ending.data());
        QVERIFY(!core::isWritten("a." + std::string(ending)));
    }
    QCOMPARE(core::readEndings().size(), core::meshEndings().size() + core::externalReader().endings.size());
}

void TestSandboxedImporter::formats_areRead_data()
{
    QTest::addColumn<QString>("exporter");
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("millimetres");
    QTest::addColumn<bool>("isTurned"); // whether the file's Z axis points up
    QTest::addColumn<bool>("isColored");
    QTest::newRow("dae") << "collada"
                         << "a.dae" << 1000.0 << false << true;
    QTest::newRow("upper case") << "collada"
                                << "A.DAE" << 1000.0 << false << true;
    QTest::newRow("x") << "x"
                       << "a.x" << 1.0 << false << false;
    QTest::newRow("x3d") << "x3d"
                         << "a.x3d" << 1000.0 << false << false;
    QTest::newRow("3ds") << "3ds"
                         << "a.3ds" << 1.0 << true << false;
    QTest::newRow("fbx") << "fbxa"
                         << "a.fbx" << 10.0 << false << true;
}

void TestSandboxedImporter::formats_areRead()
{
    QFETCH(QString, exporter);
    QFETCH(QString, name);
    QFETCH(double, millimetres);
    QFETCH(bool, isTurned);
    QFETCH(bool, isColored);
    const TriangleMesh mesh = shapes::cube(2); // its coordinates are exact in every format
    const TriangleMesh read = core::readMesh(written(qPrintable(exporter), name, mesh, isColored));
    QCOMPARE(app::assimpHoldsUnit(file(name)), millimetres != 1);
    QCOMPARE(read.triangles.size(), mesh.triangles.size());
    QCOMPARE(read.points.size(), mesh.points.size());
    QCOMPARE(volume(read), volume(mesh) * millimetres * millimetres * millimetres);
    for (Vec3f p : mesh.points) {
        p = isTurned ? Vec3f(p.x(), p.z(), p.y() == 0 ? 0 : -p.y()) : p;
        QVERIFY(std::ranges::find(read.points, Vec3f(p * static_cast<float>(millimetres))) != read.points.end());
    }
    if (isColored)
        QVERIFY(read.colors == std::vector<core::Rgb>(read.points.size(), color));
}

void TestSandboxedImporter::mirroredNodes_stayOutward()
{
    aiMatrix4x4 mirror;
    mirror.a1 = -2;
    mirror.b4 = 5;
    const TriangleMesh read =
        core::readMesh(written("collada", QStringLiteral("m.dae"), shapes::cube(1), false, mirror));
    QCOMPARE(volume(read), volume(shapes::cube(1)) * 2e9);
}

void TestSandboxedImporter::commas_changeNothing()
{
    const auto path = written("collada", QStringLiteral("c.dae"), core::icosphere(2, 1.23), true);
    const TriangleMesh before = core::readMesh(path);
    qputenv("LC_ALL", "de_DE.UTF-8");
    const TriangleMesh after = core::readMesh(path);
    qunsetenv("LC_ALL");
    QVERIFY(before.points == after.points && before.triangles == after.triangles);
}

void TestSandboxedImporter::commands_takeThem()
{
    const auto path =
        QString::fromStdString(written("collada", QStringLiteral("d.dae"), core::icosphere(2, 1.5), false).string());
    const auto fettle = [this](const QStringList& arguments) {
        QProcess process;
        process.setWorkingDirectory(m_dir.path());
        process.start(QStringLiteral(FETTLE_PROGRAM), arguments);
        process.waitForFinished();
        return process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    };
    QCOMPARE(fettle({QStringLiteral("check"), path}), 0);
    QCOMPARE(fettle({QStringLiteral("convert"), path, QStringLiteral("d.ply")}), 0);
    QCOMPARE(core::readMesh(file(QStringLiteral("d.ply"))).points.size(), std::size_t(162));
    write(QStringLiteral("s.json"), R"({"format":"fettle-strokes","version":1,"strokes":[]})");
    QCOMPARE(fettle({QStringLiteral("replay"), QStringLiteral("--strokes"), QStringLiteral("s.json"),
                     QStringLiteral("--in"), path, QStringLiteral("--out"), QStringLiteral("r.ply")}),
             0);
    QCOMPARE(fettle({QStringLiteral("convert"), path, QStringLiteral("d.fbx")}), 2); // FBX can be read, but not written
}

void TestSandboxedImporter::brokenReaders_areOneSentence_data()
{
    QTest::addColumn<QByteArray>("lines");
    for (const char* lines :
         {"exit 0", "exit 1", "kill -SEGV $$", "kill -ABRT $$", "echo garbage", "head -c 100000 /dev/zero",
          "head -c 300000000 /dev/zero", "printf 1ROF; head -c 100000 /dev/zero",
          "printf '1ROF\\0\\0\\0\\0'; head -c 100 /dev/zero | tr '\\0' '\\377'",
          "printf '1ROF\\2\\0\\0\\0'; head -c 1000 /dev/zero | tr '\\0' '\\377'"})
        QTest::newRow(lines) << QByteArray(lines);
}

void TestSandboxedImporter::brokenReaders_areOneSentence()
{
    QFETCH(QByteArray, lines);
    write(QStringLiteral("a.fbx"), "x");
    const auto reader = app::sandboxedImporter(script(lines));
    const auto error = errorOf([&] { reader.read(file(QStringLiteral("a.fbx")), {}); });
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->kind), static_cast<int>(Kind::ReaderDied));
    const auto none =
        errorOf([&] { app::sandboxedImporter("/nowhere/fettle").read(file(QStringLiteral("a.fbx")), {}); });
    QVERIFY(none && none->kind == Kind::ReaderDied);
}

void TestSandboxedImporter::whoStops_waitsForNobody()
{
    write(QStringLiteral("a.fbx"), "x");
    std::stop_source source;
    const auto reader = app::sandboxedImporter(script("sleep 3600"));
    std::jthread stopper([&source] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        source.request_stop();
    });
    QVERIFY_THROWS_EXCEPTION(core::ReadingCancelled,
                             reader.read(file(QStringLiteral("a.fbx")), {.stop = source.get_token()}));
}

void TestSandboxedImporter::slowReaders_areEnded()
{
    const app::ChildResult answer = app::runChild(
        {.command = {script("echo begun; exec sleep 3600")}, .time = std::chrono::seconds(1), .maxBytes = 100});
    QCOMPARE(static_cast<int>(answer.end), static_cast<int>(app::ChildResult::End::TooSlow));
    QCOMPARE(answer.bytes, std::string("begun\n"));
    const app::ChildResult silent = app::runChild(
        {.command = {script("exec >&-; exec sleep 3600")}, .time = std::chrono::seconds(60), .maxBytes = 1});
    QVERIFY(silent.end != app::ChildResult::End::Exited); // the child closed its output but keeps running
}

/// A few bytes request a ball of 4^30 triangles, or a many-sided section along a long spine.
void TestSandboxedImporter::hungryFiles_areRefused()
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    QSKIP("sanitizers need address space without limits");
#endif
    write(QStringLiteral("a.nff"), "tess 30\ns 0 0 0 1\n");
    QByteArray spine, section;
    for (int i = 0; i < 2000; ++i) {
        const QByteArray number = QByteArray::number(i) + ' ', odd = QByteArray::number(i % 3) + ' ';
        spine += number + odd + "0 ";
        section += number + odd;
    }
    write(QStringLiteral("a.x3d"),
          "<X3D><Scene><Shape><Extrusion spine='" + spine + "' crossSection='" + section + "'/></Shape></Scene></X3D>");
    for (const char* name : {"a.nff", "a.x3d"}) {
        const auto error = errorOf([&] { core::readMesh(file(QLatin1StringView(name))); });
        QVERIFY2(error, name);
        QCOMPARE(static_cast<int>(error->kind), static_cast<int>(Kind::ReaderOutOfMemory));
    }
}

void TestSandboxedImporter::ownLimits_hold()
{
#ifndef Q_OS_LINUX
    QSKIP("uses what Linux has");
#else
    const std::string target = file(QStringLiteral("written")).string();
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        app::limitOwnProcess(std::uint64_t(1) << 30, 60);
        const int to = open(target.c_str(), O_CREAT | O_WRONLY, 0600);
        char* const nothing[] = {nullptr};
        _exit((socket(AF_INET, SOCK_STREAM, 0) == -1 ? 0 : 1) | (execve("/bin/true", nothing, nothing) == -1 ? 0 : 2) |
              (::write(to, "x", 1) == -1 ? 0 : 4) | (unlink(target.c_str()) == -1 ? 0 : 8) |
              (to == STDERR_FILENO + 1 ? 0 : 16));
    }
    int status = 0;
    QVERIFY(waitpid(child, &status, 0) == child && WIFEXITED(status));
    QCOMPARE(WEXITSTATUS(status), 0);
#endif
}

void TestSandboxedImporter::badFiles_areRefused()
{
    for (const char* name : {"bad.fbx", "bad.ac", "bad.3ds", "bad.x"}) {
        write(QLatin1StringView(name), "this is nothing of the kind");
        const auto error = errorOf([&] { core::readMesh(file(QLatin1StringView(name))); });
        QVERIFY2(error && error->kind == Kind::ReaderRefused && !error->token.empty(), name);
    }
    write(QStringLiteral("empty.fbx"), "");
    const auto empty = errorOf([&] { core::readMesh(file(QStringLiteral("empty.fbx"))); });
    QVERIFY(empty && empty->kind == Kind::Empty);
    const auto none = errorOf([&] { core::readMesh(file(QStringLiteral("none.fbx"))); });
    QVERIFY(none && none->kind == Kind::NotFound);
    write(QStringLiteral("own.blend"), "BLENDER-v300");
    const auto blend = errorOf([&] { core::readMesh(file(QStringLiteral("own.blend"))); });
    QVERIFY(blend && blend->kind == Kind::UnknownFormat && blend->token == "blend");
    write(QStringLiteral("scene.ogex"), "GeometryNode {}");
    const auto openGex = errorOf([&] { core::readMesh(file(QStringLiteral("scene.ogex"))); });
    QVERIFY(openGex && openGex->kind == Kind::UnknownFormat && openGex->token == "ogex");
}

/// A LightWave scene consists of the files that it names.
void TestSandboxedImporter::filesBeyondTheFolder_areNotRead()
{
    QVERIFY(QDir(m_dir.path()).mkpath(QStringLiteral("scene")));
    const QByteArray part = "p 3\n0.5 0 0\n1.25 0 0\n0 1.75 0\n";
    write(QStringLiteral("scene/part.nff"), part);
    write(QStringLiteral("outside.nff"), part);
    QVERIFY(
        QFile::link(m_dir.filePath(QStringLiteral("outside.nff")), m_dir.filePath(QStringLiteral("scene/link.nff"))));
    const auto errorWith = [this](const QByteArray& named) {
        write(QStringLiteral("scene/a.lws"), "LWSC\n1\n\nLoadObject " + named + "\nShowObject 7\n\n");
        return errorOf([this] { core::readMesh(file(QStringLiteral("scene/a.lws"))); });
    };
    QVERIFY(!errorWith("part.nff"));
    for (const QByteArray& named : {QByteArray("../outside.nff"),
                                    m_dir.filePath(QStringLiteral("outside.nff")).toUtf8(), QByteArray("link.nff")}) {
        const auto error = errorWith(named);
        const std::string name = std::filesystem::path(named.toStdString()).filename().string();
        QVERIFY2(error && error->kind == Kind::OutsideFolder && error->token == name, named.constData());
    }
}

void TestSandboxedImporter::mutatedFiles_neverGetThrough()
{
    const int rounds = byEffort(5, 20, 5000);
    std::mt19937 engine(seed);
    int refused = 0;
    for (const auto& [exporter, name] :
         {std::pair{"3ds", "a.3ds"}, {"collada", "b.dae"}, {"fbx", "c.fbx"}, {"x", "d.x"}}) {
        QFile source(
            QString::fromStdString(written(exporter, QLatin1StringView(name), shapes::cube(2), true).string()));
        QVERIFY(source.open(QIODevice::ReadOnly));
        const QByteArray good = source.readAll();
        for (int round = 0; round < rounds; ++round) {
            QByteArray mutated = good;
            if (engine() % 4 == 0)
                mutated.truncate(static_cast<qsizetype>(engine() % std::size_t(good.size())));
            for (auto edits = 1 + engine() % 4; edits != 0 && !mutated.isEmpty(); --edits)
                mutated[static_cast<qsizetype>(engine() % std::size_t(mutated.size()))] = static_cast<char>(engine());
            write(QLatin1StringView(name), mutated);
            refused += errorOf([&] { core::readMesh(file(QLatin1StringView(name))); }).has_value();
        }
    }
    qInfo("%d of %d refused, seed %u", refused, 4 * rounds, seed);
}

FETTLE_TEST(TestSandboxedImporter, QCoreApplication)
#include "tst_sandboxed_importer.moc"
