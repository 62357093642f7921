// glTF with its buffers in the JSON and in files beside it; and files that name what is not theirs.

#include "core/io/mesh_io.h"
#include "core/util/file_error.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <fstream>
#include <random>

namespace
{
using core::FileError;
using core::TriangleMesh;
using core::Vec3f;
using Kind = core::FileErrorKind;

/// The points of a tetrahedron, and its corners in 16 bits.
QByteArray binary()
{
    const TriangleMesh mesh = shapes::tetrahedron();
    QByteArray bytes;
    const auto add = [&bytes](auto number) {
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }; // little-endian machines only
    for (const Vec3f& p : mesh.points)
        for (int i = 0; i < 3; ++i)
            add(p[i]);
    for (const core::Triangle& t : mesh.triangles)
        for (const core::Slot corner : t)
            add(static_cast<std::uint16_t>(corner));
    return bytes;
}

QByteArray gltf(const QByteArray& uri, int bytes = 72, const QByteArray& more = {})
{
    return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[0.001,0.001,0.001]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},{"bufferView":1,"componentType":5123,
"count":12,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],"buffers":[{"uri":")" +
           uri + R"(","byteLength":)" + QByteArray::number(bytes) + "}]" + more + "}";
}

QByteArray inside()
{
    return "data:application/octet-stream;base64," + binary().toBase64();
}
} // namespace

class TestGltfDocument : public QObject
{
    Q_OBJECT

    static constexpr unsigned seed = 20261122;

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_dir.isValid());
        QVERIFY(QDir(m_dir.path()).mkpath(QStringLiteral("home/parts")));
        for (const char* name : {"outside.bin", "home/a.bin", "home/parts/a b.bin"})
            write(QLatin1StringView(name), binary());
    }

    void buffersInside_areRead() { QVERIFY(isTetrahedron(read(gltf(inside())))); }
    void buffersBeside_areRead_data()
    {
        QTest::addColumn<QByteArray>("uri");
        for (const char* uri : {"a.bin", "./a.bin", "%61.bin", "parts/a%20b.bin", "parts/a b.bin", "parts/../a.bin",
                                "parts/./../parts/a b.bin"})
            QTest::newRow(uri) << QByteArray(uri);
    }
    void buffersBeside_areRead()
    {
        QFETCH(QByteArray, uri);
        QVERIFY(isTetrahedron(read(gltf(uri))));
    }
    void textures_areRemarked();
    void manyTextsAreNoStructure();

    void whatIsElsewhere_isNotRead_data();
    void whatIsElsewhere_isNotRead();
    void links_areFollowedBeforeTheyAreTrusted();
    void badBuffers_areRefused_data();
    void badBuffers_areRefused();
    void mutatedFiles_neverGetThrough();
    void gltf_isNotWritten();

private:
    void write(const QString& name, const QByteArray& bytes) const
    {
        QFile file(m_dir.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    std::filesystem::path model() const { return m_dir.filePath(QStringLiteral("home/model.gltf")).toStdU16String(); }
    core::ReadResult readAll(const QByteArray& bytes) const
    {
        write(QStringLiteral("home/model.gltf"), bytes);
        return core::readModel(model());
    }
    TriangleMesh read(const QByteArray& bytes) const { return readAll(bytes).mesh; }
    std::optional<FileError> errorOf(const QByteArray& bytes) const
    {
        try {
            read(bytes);
        } catch (const FileError& error) {
            return error;
        }
        return std::nullopt;
    }
    static bool isTetrahedron(const TriangleMesh& mesh)
    {
        return mesh.points == shapes::tetrahedron().points && mesh.triangles == shapes::tetrahedron().triangles;
    }

    QTemporaryDir m_dir;
};

void TestGltfDocument::textures_areRemarked()
{
    QVERIFY(!readAll(gltf(inside())).remarks.textures);
    QVERIFY(readAll(gltf(inside(), 72, R"(,"textures":[{"source":0}],"images":[{"uri":"../../nothing.png"}])"))
                .remarks.textures);
    QVERIFY(readAll(gltf(inside(), 72, R"(,"skins":[{}])")).remarks.poses);
}

/// The limit on JSON is for what is parsed to more than itself.
void TestGltfDocument::manyTextsAreNoStructure()
{
    QVERIFY(isTetrahedron(read(gltf(inside(), 72, R"(,"extras":")" + QByteArray(20'000'000, 'x') + '"'))));
    const auto error =
        errorOf(gltf(inside(), 72, R"(,"extras":)" + QByteArray(5'000'000, '[') + QByteArray(5'000'000, ']')));
    QVERIFY(error && error->kind == Kind::TooManyElements);
}

void TestGltfDocument::whatIsElsewhere_isNotRead_data()
{
    QTest::addColumn<QByteArray>("uri");
    for (const char* uri : {"../outside.bin", "%2e%2e/outside.bin", "..%2Foutside.bin", "parts/../../outside.bin",
                            "/etc/passwd", "%2Fetc%2Fpasswd", "file:///etc/passwd", "http://127.0.0.1/a.bin",
                            "C:/a.bin", "..\\\\outside.bin", "a.bin%00.png", "a%2", "//etc/passwd", ""})
        QTest::newRow(uri) << QByteArray(uri);
}

void TestGltfDocument::whatIsElsewhere_isNotRead()
{
    QFETCH(QByteArray, uri);
    const auto error = errorOf(gltf(uri));
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->kind), static_cast<int>(Kind::OutsideFolder));
    QVERIFY(error->path == model());
}

void TestGltfDocument::links_areFollowedBeforeTheyAreTrusted()
{
    const auto home = model().parent_path();
    std::filesystem::create_symlink("a.bin", home / "within.bin");
    QVERIFY(isTetrahedron(read(gltf("within.bin"))));
    std::filesystem::create_symlink("../outside.bin", home / "out.bin");
    std::filesystem::create_directory_symlink("..", home / "up");
    for (const char* uri : {"out.bin", "up/outside.bin"}) {
        const auto error = errorOf(gltf(uri));
        QVERIFY(error && error->kind == Kind::OutsideFolder);
    }
}

void TestGltfDocument::badBuffers_areRefused_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<Kind>("kind");
    QTest::newRow("not there") << gltf("b.bin") << Kind::NotFound;
    QTest::newRow("a folder") << gltf("parts") << Kind::NotAFile;
    QTest::newRow("too short") << gltf("a.bin", 73) << Kind::CutOff;
    QTest::newRow("too short inside") << gltf(inside(), 73) << Kind::CutOff;
    QTest::newRow("too short for its views") << gltf(inside().chopped(8), 66) << Kind::CutOff;
    QTest::newRow("beyond all bounds") << gltf("a.bin", std::numeric_limits<int>::max()) << Kind::TooManyElements;
    QTest::newRow("not base64") << gltf("data:;base64,****") << Kind::Malformed;
    QTest::newRow("not packed") << gltf("data:,abc") << Kind::Malformed;
    QTest::newRow("no uri") << gltf("a.bin").replace("uri", "url") << Kind::CutOff;
    QTest::newRow("no JSON") << QByteArray("# nothing\n") << Kind::Malformed;
    QTest::newRow("a list") << QByteArray("[]") << Kind::Malformed;
    QTest::newRow("another format") << QByteArray("ply\nformat ascii 1.0\n") << Kind::NotWhatItsEndingSays;
}

void TestGltfDocument::badBuffers_areRefused()
{
    QFETCH(QByteArray, bytes);
    QFETCH(Kind, kind);
    const auto error = errorOf(bytes);
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->kind), static_cast<int>(kind));
}

void TestGltfDocument::mutatedFiles_neverGetThrough()
{
    const QByteArray good = gltf(inside());
    const QList<QByteArray> words{"-1", "0",    "4294967295", "1e99", "\"",    "{",   "}", "[",      "]",
                                  ",",  "null", "true",       "uri",  "a.bin", "../", "%", "\\u0000"};
    std::mt19937 engine(seed);
    int refused = 0;
    for (int round = 0; round < 3000; ++round) {
        QByteArray mutated = good;
        for (auto edits = 1 + engine() % 3; edits != 0; --edits) {
            const auto at = static_cast<qsizetype>(engine() % std::size_t(mutated.size()));
            if (engine() % 2 == 0)
                mutated.replace(at, 1 + engine() % 8, words[qsizetype(engine() % std::size_t(words.size()))]);
            else
                mutated[at] = static_cast<char>(engine());
        }
        try {
            const TriangleMesh mesh = read(mutated);
            for (const core::Triangle& t : mesh.triangles)
                for (const core::Slot corner : t)
                    QVERIFY2(corner < mesh.points.size(), qPrintable(QString::number(round)));
        } catch (const FileError&) {
            ++refused;
        }
    }
    qInfo("%d of 3000 refused, seed %u", refused, seed);
}

void TestGltfDocument::gltf_isNotWritten()
{
    QVERIFY(!core::isWritten(model()));
    try {
        core::writeMesh(model(), shapes::tetrahedron());
        QFAIL("written");
    } catch (const FileError& error) {
        QCOMPARE(static_cast<int>(error.kind), static_cast<int>(Kind::NotWritten));
    }
}

FETTLE_TEST(TestGltfDocument)
#include "tst_gltf_document.moc"
