// Tests glTF with buffers in the JSON or in separate files. References outside the model's folder must be refused.

#include "core/io/draco_stream.h"
#include "core/io/mesh_io.h"
#include "core/util/file_error.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <memory>
#include <random>

namespace
{
using core::FileError;
using core::TriangleMesh;
using core::Vec3f;
using Kind = core::FileErrorKind;

/// Returns the points of a tetrahedron, then its corners as 16-bit indices.
QByteArray binary()
{
    const TriangleMesh mesh = shapes::tetrahedron();
    QByteArray bytes;
    const auto add = [&bytes](auto number) {
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }; // works on little-endian machines only
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

/// Returns a glTF of a tetrahedron in a simulated Draco stream of three bytes. Its positions have attribute id 7.
QByteArray packedGltf(const QByteArray& nodes)
{
    return R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_draco_mesh_compression"],)" + nodes +
           R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":2},"indices":1,"extensions":{
"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":7,"NORMAL":3}}}}]}],
"accessors":[{"componentType":5126,"count":4,"type":"VEC3"},{"componentType":5123,"count":12,"type":"SCALAR"},
{"componentType":5126,"count":4,"type":"VEC3"}],
"bufferViews":[{"buffer":0,"byteLength":3}],"buffers":[{"uri":"data:;base64,YWJj","byteLength":3}],
"extras":")" +
           QByteArray(200, ' ') + R"("})";
}

QByteArray bytesOf(const std::vector<float>& numbers)
{
    return {reinterpret_cast<const char*>(numbers.data()), static_cast<qsizetype>(numbers.size() * sizeof(float))};
}

QByteArray inside()
{
    return "data:application/octet-stream;base64," + binary().toBase64();
}

/// Returns a glTF of a tetrahedron in metres at (1, 2, 3), with one instance for each element of the non-empty lists.
QByteArray instanced(const std::vector<float>& places, const std::vector<float>& turns,
                     const std::vector<float>& scales, const QByteArray& more = {})
{
    QByteArray attributes, accessors, views, bytes;
    const auto add = [&](const char* name, const std::vector<float>& numbers, std::size_t each) {
        if (numbers.empty())
            return;
        const QByteArray index = QByteArray::number(2 + accessors.count('{'));
        attributes += QByteArray(attributes.isEmpty() ? "" : ",") + '"' + name + "\":" + index;
        accessors += ",{\"bufferView\":" + index + R"(,"componentType":5126,"count":)" +
                     QByteArray::number(quint64(numbers.size() / each)) + R"(,"type":"VEC)" +
                     QByteArray::number(quint64(each)) + "\"}";
        views += R"(,{"buffer":1,"byteOffset":)" + QByteArray::number(bytes.size()) + R"(,"byteLength":)" +
                 QByteArray::number(bytesOf(numbers).size()) + "}";
        bytes += bytesOf(numbers);
    };
    add("TRANSLATION", places, 3);
    add("ROTATION", turns, 4);
    add("SCALE", scales, 3);
    return gltf(inside(), 72, more)
        .replace(R"("scale":[0.001,0.001,0.001])",
                 R"("translation":[1,2,3],"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{)" + attributes +
                     "}}}")
        .replace(R"("type":"SCALAR"})", R"("type":"SCALAR"})" + accessors)
        .replace(R"("byteLength":24})", R"("byteLength":24})" + views)
        .replace(R"("byteLength":72})", R"("byteLength":72},{"uri":"data:;base64,)" + bytes.toBase64() +
                                            R"(","byteLength":)" + QByteArray::number(bytes.size()) + "}");
}

/// Returns a skinned tetrahedron in a scaled node. Its vertices have weights for joint 0, joint 1, both, and none for
/// joint 1. Joint 1 is a child of joint 0.
QByteArray skinned()
{
    const QByteArray joints("\0\0\0\0\1\0\0\0\0\1\0\0\1\0\0\0", 16);
    const QByteArray weights = bytesOf({1, 0, 0, 0, 1, 0, 0, 0, 2, 2, 0, 0, 0, 0, 0, 0}),
                     inverses = bytesOf({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1, //
                                         1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1});
    return gltf(inside(), 72, R"(,"skins":[{"joints":[1,2],"inverseBindMatrices":4}])")
        .replace(R"("nodes":[0])", R"("nodes":[0,1])")
        .replace(R"({"mesh":0,)", R"({"mesh":0,"skin":0,)")
        .replace(R"("scale":[0.001,0.001,0.001]})",
                 R"("scale":[0.001,0.001,0.001]},{"translation":[1,0,0],"children":[2]},{"scale":[2,2,2]})")
        .replace(R"("POSITION":0)", R"("POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3)")
        .replace(R"("type":"SCALAR"})",
                 R"("type":"SCALAR"},{"bufferView":2,"componentType":5121,"count":4,"type":"VEC4"},
{"bufferView":3,"componentType":5126,"count":4,"type":"VEC4"},
{"bufferView":4,"componentType":5126,"count":2,"type":"MAT4"})")
        .replace(R"("byteLength":24})", R"("byteLength":24},{"buffer":1,"byteLength":16},
{"buffer":1,"byteOffset":16,"byteLength":64},{"buffer":1,"byteOffset":80,"byteLength":128})")
        .replace(R"("byteLength":72})", R"("byteLength":72},{"byteLength":208,"uri":"data:;base64,)" +
                                            (joints + weights + inverses).toBase64() + "\"}");
}

core::DracoMesh tetrahedronStream()
{
    const TriangleMesh mesh = shapes::tetrahedron();
    core::DracoMesh decoded{.vertices = mesh.points.size(), .corners = {}, .attributes = {}};
    core::DracoMesh::Attribute positions{.id = 7, .componentType = 5126, .components = 3, .bytes = {}};
    for (const Vec3f& p : mesh.points)
        positions.bytes.append(reinterpret_cast<const char*>(p.data()), 3 * sizeof(float));
    decoded.attributes.push_back(positions);
    for (const core::Triangle& t : mesh.triangles)
        decoded.corners.insert(decoded.corners.end(), t.begin(), t.end());
    return decoded;
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
    void buffersThatNothingUses_mayBeMissing();
    void tooLargeNumbers_areTold();
    void nodes_areCountedAndNested();
    void mutatedFiles_neverGetThrough();
    void gltf_isNotWritten();

    void instances_standWhereListsSay();
    void badInstances_areRefused_data();
    void badInstances_areRefused();
    void manyInstances_areBounded();
    void hiddenNodes_areLeftOut();
    void skinnedMeshes_standWhereJointsDo();
    void jointsWithoutWeight_mayBeNone();
    void furtherSetsOfJoints_areRead();
    void skinOfManyNodes_countsOnce();
    void mirrors_areOfTriangles();
    void badSkins_areRefused_data();
    void badSkins_areRefused();

    void decodedStreams_areReadOnce();
    void decodersResults_areChecked_data();
    void decodersResults_areChecked();

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

/// The JSON limit applies to parsed structures, not to the length of texts.
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

/// Unused buffers, for example those of images, may be missing.
void TestGltfDocument::buffersThatNothingUses_mayBeMissing()
{
    for (const char* uri : {"b.bin", "../outside.bin", "data:;base64,****"}) {
        const QByteArray used = gltf(inside());
        const QByteArray unused = QByteArray(used).replace(
            R"("byteLength":72})", R"("byteLength":72},{"byteLength":9,"uri":")" + QByteArray(uri) + "\"}");
        QVERIFY(isTetrahedron(read(unused)));
        QVERIFY(isTetrahedron(read(QByteArray(unused).replace(
            R"("byteLength":24})", R"("byteLength":24},{"buffer":1,"byteLength":9})")))); // the buffer view of an image
        QVERIFY(errorOf(QByteArray(unused).replace(R"("bufferViews":[{"buffer":0)", R"("bufferViews":[{"buffer":1)")));
    }
}

void TestGltfDocument::tooLargeNumbers_areTold()
{
    const QByteArray good =
        gltf(inside(), 72, R"(,"extras":["1e999 \\\"1e999",1e-999,-0.0,123456789012345678901234567890])");
    QVERIFY(isTetrahedron(read(good)));
    for (const char* number : {"1e400", "-9E+999"}) {
        const QByteArray bytes = good + "  ";
        const qsizetype at = bytes.indexOf("123456");
        const auto error = errorOf(QByteArray(bytes).replace(at, 30, number));
        QVERIFY(error);
        QCOMPARE(static_cast<int>(error->kind), static_cast<int>(Kind::NotANumber));
        QCOMPARE(error->token, std::string(number));
        QCOMPARE(error->place.number, std::uint64_t(at));
    }
    // a coordinate that overflows float32 has no position in the file
    const auto far = errorOf(gltf(inside()).replace(R"("scale":[0.001,0.001,0.001])", R"("translation":[1e300,0,0])"));
    QVERIFY(far);
    QCOMPARE(static_cast<int>(far->kind), static_cast<int>(Kind::NotANumber));
    QVERIFY(far->place == core::FilePlace());
}

/// Each of many sibling nodes is visited once. Nesting depth is limited, and so is the number of visits when a node is
/// referenced twice.
void TestGltfDocument::nodes_areCountedAndNested()
{
    const auto scene = [](const QByteArray& roots, const QByteArray& nodes) {
        return gltf(inside())
            .replace(R"("scenes":[{"nodes":[0]}])", R"("scenes":[{"nodes":[)" + roots + "]}]")
            .replace(R"("scale":[0.001,0.001,0.001]})", R"("scale":[0.001,0.001,0.001]})" + nodes);
    };
    constexpr int many = 70'000;
    QByteArray roots = "0", nodes;
    for (int i = 1; i <= many; ++i) {
        roots += "," + QByteArray::number(i);
        nodes += ",{}";
    }
    QVERIFY(isTetrahedron(read(scene(roots, nodes))));
    const auto chain = [&](int length, bool isTwice) {
        QByteArray links;
        for (int i = 0; i < length; ++i) { // each node contains the previous one
            const QByteArray before = QByteArray::number(i);
            links += R"(,{"children":[)" + before + (isTwice ? "," + before : "") + "]}";
        }
        return errorOf(scene(QByteArray::number(length), links));
    };
    QVERIFY(!chain(200, false));
    const auto deep = chain(300, false);
    QVERIFY(deep && deep->fault == core::FileFault::TooDeep);
    const auto doubled = chain(40, true);
    QVERIFY(doubled && doubled->kind == Kind::TooManyElements && doubled->token == "nodes");
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

/// Tests a node at (1, 2, 3) with three instances of a mesh, which have translations, rotations and scales of their
/// own.
void TestGltfDocument::instances_standWhereListsSay()
{
    const float s = std::sqrt(0.5F);
    const std::vector<float> places{0, 0, 0, 10, 0, 0, 0, 20, 0}, turns{0, 0, 0, 1, 0, 0, s, s, 0, 0, 0, 2},
        scales{1, 1, 1, 1, 2, 3, -1, 1, 1};
    const TriangleMesh alone = shapes::tetrahedron();
    for (const QByteArray& required :
         {QByteArray(), QByteArray(R"(,"extensionsRequired":["EXT_mesh_gpu_instancing"])")})
        for (int parts = 1; parts < 8; ++parts) {
            const core::ReadResult result =
                readAll(instanced(parts & 1 ? places : std::vector<float>(), parts & 2 ? turns : std::vector<float>(),
                                  parts & 4 ? scales : std::vector<float>(), required));
            QCOMPARE(result.remarks.objects, std::size_t(3));
            const TriangleMesh& mesh = result.mesh;
            QCOMPARE(mesh.triangles.size(), 3 * alone.triangles.size());
            for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
                const std::size_t instance = t / alone.triangles.size();
                core::Triangle corners = alone.triangles[t % alone.triangles.size()];
                if (parts & 4 && instance == 2)
                    std::swap(corners[1], corners[2]); // a mirrored instance must still face outwards
                for (std::size_t k = 0; k < 3; ++k) {
                    Vec3f p = alone.points[corners[k]];
                    if (parts & 4)
                        p = p.cwiseProduct(Vec3f(&scales[3 * instance]));
                    if (parts & 2 && instance == 1)
                        p = Vec3f(-p.y(), p.x(), p.z());
                    if (parts & 1)
                        p += Vec3f(&places[3 * instance]);
                    QVERIFY((mesh.points[mesh.triangles[t][k]] - 1000 * (p + Vec3f(1, 2, 3))).norm() < 0.02F);
                }
            }
        }
    QVERIFY(isTetrahedron(read(gltf(inside()).replace(
        "\"mesh\":0,", R"("mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"_ID":1}}},)"))));
}

void TestGltfDocument::badInstances_areRefused_data()
{
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::newRow("no such list") << QByteArray(R"("TRANSLATION":2)") << QByteArray(R"("TRANSLATION":9)");
    QTest::newRow("a list of others") << QByteArray(R"("TRANSLATION":2)") << QByteArray(R"("TRANSLATION":3)");
    QTest::newRow("no number") << QByteArray(R"("TRANSLATION":2)") << QByteArray(R"("TRANSLATION":-2)");
    QTest::newRow("no lists") << QByteArray(R"("attributes":{"TRANSLATION")")
                              << QByteArray(R"("lists":{"TRANSLATION")");
    QTest::newRow("no object") << QByteArray(R"({"attributes":{"TRANSLATION":2,"ROTATION":3}})") << QByteArray("[]");
    QTest::newRow("fewer turns") << QByteArray(R"("count":2,"type":"VEC4")")
                                 << QByteArray(R"("count":1,"type":"VEC4")");
    QTest::newRow("more turns") << QByteArray(R"("count":2,"type":"VEC4")") << QByteArray(R"("count":3,"type":"VEC4")");
    QTest::newRow("beyond") << QByteArray(R"("count":2,"type":"VEC3")") << QByteArray(R"("count":9999,"type":"VEC3")");
}

void TestGltfDocument::badInstances_areRefused()
{
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    const QByteArray good = instanced({0, 0, 0, 5, 0, 0}, {0, 0, 0, 1, 0, 0, 0, 1}, {});
    QCOMPARE(read(good).triangles.size(), std::size_t(8));
    QVERIFY(good.contains(from));
    const auto error = errorOf(QByteArray(good).replace(from, to));
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->kind), static_cast<int>(Kind::Malformed));
    const auto infinite = errorOf(instanced({0, 0, 0, std::numeric_limits<float>::infinity(), 0, 0}, {}, {}));
    QVERIFY(infinite && infinite->kind == Kind::NotANumber);
}

/// Accessors without data contain only zeros and take no space, so the number of instances must be limited.
void TestGltfDocument::manyInstances_areBounded()
{
    const auto many = [](int count, int nodes) {
        QByteArray list;
        for (int i = 0; i < nodes; ++i)
            list += QByteArray(i > 0 ? "," : "") +
                    R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0}}}})";
        return R"({"asset":{"version":"2.0"},"nodes":[)" + list +
               R"(],"meshes":[{"primitives":[]}],"accessors":[{"componentType":5126,"type":"VEC3","count":)" +
               QByteArray::number(count) + R"(}],"extras":")" + QByteArray(300'000, 'x') + "\"}";
    };
    for (const auto& [count, nodes] : {std::pair(300'000, 1), std::pair(200'000, 2)}) {
        const auto error = errorOf(many(count, nodes));
        QVERIFY(error);
        QCOMPARE(static_cast<int>(error->kind), static_cast<int>(Kind::TooManyElements));
        QCOMPARE(error->token, std::string("instances"));
    }
    const auto few = errorOf(many(1000, 2));
    QVERIFY(few && few->kind == Kind::NoFaces);
}

void TestGltfDocument::hiddenNodes_areLeftOut()
{
    const auto withNodes = [](const QByteArray& nodes) {
        return gltf(inside())
            .replace(R"([{"mesh":0,"scale":[0.001,0.001,0.001]}])", "[" + nodes + "]")
            .replace(R"([{"nodes":[0]}])", R"([{"nodes":[0,1]}])");
    };
    const auto facesWith = [&](const QByteArray& visibility) {
        return read(withNodes(R"({"children":[2],"extensions":{"KHR_node_visibility":)" + visibility +
                              R"(}},{"mesh":0},{"mesh":0})"))
            .triangles.size();
    };
    QCOMPARE(facesWith(R"({"visible":false})"), std::size_t(4));
    QCOMPARE(facesWith(R"({"visible":true})"), std::size_t(8));
    QCOMPARE(facesWith("{}"), std::size_t(8));
    const auto hidden = errorOf(
        gltf(inside()).replace("\"mesh\":0,", R"("mesh":0,"extensions":{"KHR_node_visibility":{"visible":false}},)"));
    QVERIFY(hidden && hidden->kind == Kind::NoFaces);
    const auto bad =
        errorOf(gltf(inside()).replace("\"mesh\":0,", R"("mesh":0,"extensions":{"KHR_node_visibility":1},)"));
    QVERIFY(bad && bad->fault == core::FileFault::NotAnObject);
}

/// Vertices follow their joints. The transform of the mesh's own node is ignored, unless the mesh has no joints.
void TestGltfDocument::skinnedMeshes_standWhereJointsDo()
{
    const core::ReadResult result = readAll(skinned());
    const std::vector<Vec3f> points = shapes::tetrahedron().points;
    const Vec3f one(1, 0, 0);
    const auto first = [one](Vec3f p) -> Vec3f { return 1000 * (p + one); };
    const auto second = [one](Vec3f p) -> Vec3f { return 1000 * (2 * (p - one) + one); };
    const std::vector<Vec3f> wanted{first(points[0]), second(points[1]), (first(points[2]) + second(points[2])) / 2,
                                    second(points[3])};
    QCOMPARE(result.mesh.points.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
        QVERIFY((result.mesh.points[i] - wanted[i]).norm() < 1e-3F);
    QVERIFY(result.mesh.triangles == shapes::tetrahedron().triangles);
    QVERIFY(result.remarks.poses);
    QVERIFY(isTetrahedron(read(skinned().replace("JOINTS_0", "_JOINTS"))));
    const QByteArray mirrored = skinned().replace(R"("translation":[1,0,0])", R"("scale":[-1,1,1])");
    QVERIFY(read(mirrored).triangles.front() != shapes::tetrahedron().triangles.front());
    const QByteArray plain = skinned().replace(R"(,"inverseBindMatrices":4)", "");
    QVERIFY((read(plain).points[1] - 1000 * (2 * points[1] + one)).norm() < 1e-3F);
}

/// Joints with weight 0 may have any index: some programs write 255 there.
void TestGltfDocument::jointsWithoutWeight_mayBeNone()
{
    const QByteArray joints("\0\0\0\0\1\0\0\0\0\1\0\0\1\0\0\0", 16),
        filled("\0\xff\xff\xff\1\xff\xff\xff\0\1\xff\xff\xff\xff\xff\xff", 16);
    // the first 15 bytes, whose base64 does not depend on the bytes after them
    const QByteArray plain = skinned(), start = joints.first(15).toBase64();
    QVERIFY(plain.contains(start));
    const std::vector<Vec3f> points = read(QByteArray(plain).replace(start, filled.first(15).toBase64())).points;
    std::vector<Vec3f> wanted = read(plain).points;
    // a vertex without weights follows the skin's first joint
    wanted[3] = 1000 * (shapes::tetrahedron().points[3] + Vec3f(1, 0, 0));
    QCOMPARE(points.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
        QVERIFY((points[i] - wanted[i]).norm() < 1e-3F);
}

/// Tests that further sets of joints with equal weights do not change the result. Up to eight sets are read.
void TestGltfDocument::furtherSetsOfJoints_areRead()
{
    const auto sets = [](int count) {
        QByteArray names;
        for (int i = 0; i < count; ++i) {
            const QByteArray set = QByteArray::number(i), accessors = i + 1 < count ? "5" : "3";
            names += (i == 0 ? "" : ",") + ("\"JOINTS_" + set) + R"(":2,"WEIGHTS_)" + set + "\":" + accessors;
        }
        return skinned()
            .replace(R"("JOINTS_0":2,"WEIGHTS_0":3)", names)
            .replace(R"("type":"MAT4"})", R"("type":"MAT4"},{"componentType":5126,"count":4,"type":"VEC4"})");
    };
    const std::vector<Vec3f> wanted = read(skinned()).points;
    for (const int count : {1, 2, 3, 8})
        QVERIFY(read(sets(count)).points == wanted);
    const auto error = errorOf(sets(9));
    QVERIFY(error && error->kind == Kind::TooManyElements && error->token == "sets of joints");
    QCOMPARE(error->expected, std::uint64_t(8));
}

/// A triangle is mirrored if the joints with most of its weight mirror it, regardless of its first vertex.
void TestGltfDocument::mirrors_areOfTriangles()
{
    const QByteArray joints("\0\0\0\0\1\0\0\0\0\1\0\0\1\0\0\0", 16), firstAlone("\0\0\0\0\1\0\0\0\1\1\0\0\1\0\0\0", 16);
    const auto volumeOf = [&](const char* first, const char* second) {
        const TriangleMesh mesh = read(skinned()
                                           .replace(joints.first(15).toBase64(), firstAlone.first(15).toBase64())
                                           .replace(R"({"translation":[1,0,0],"children":[2]})", first)
                                           .replace(R"({"scale":[2,2,2]})", second)
                                           .replace(R"(,"inverseBindMatrices":4)", ""));
        double six = 0;
        for (const auto& [a, b, c] : mesh.triangles)
            six +=
                mesh.points[a].cast<double>().dot(mesh.points[b].cast<double>().cross(mesh.points[c].cast<double>()));
        return six / 6e9;
    };
    constexpr double whole = 8.0 / 3, wanted = whole / 2; // one vertex is mirrored to the other side
    QVERIFY(std::abs(volumeOf("{}", "{}") - whole) < 1e-3);
    for (const auto& [first, second] : {std::pair("{}", R"({"scale":[-1,1,1]})"), {R"({"scale":[1,-1,1]})", "{}"}})
        QVERIFY(std::abs(volumeOf(first, second) - wanted) < 1e-3);
}

void TestGltfDocument::skinOfManyNodes_countsOnce()
{
    QByteArray roots = R"("nodes":[0,1)", joints = R"("joints":[1,2)", nodes;
    for (int i = 3; i < 1000; ++i) {
        roots += ',' + QByteArray::number(i);
        nodes += R"(,{"mesh":0,"skin":0})";
        joints += ",1";
    }
    const QByteArray many = skinned()
                                .replace(R"("nodes":[0,1)", roots)
                                .replace(R"({"scale":[2,2,2]})", R"({"scale":[2,2,2]})" + nodes)
                                .replace(R"("joints":[1,2)", joints)
                                .replace(R"(,"inverseBindMatrices":4)", "");
    QCOMPARE(read(many).triangles.size(), std::size_t(4 * 998));
}

void TestGltfDocument::badSkins_areRefused_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("token");
    const auto row = [](const char* name, const char* from, const char* to, const char* token) {
        QTest::newRow(name) << skinned().replace(from, to) << QString(token);
    };
    row("no such joint", R"("joints":[1,2])", R"("joints":[1])", "joints/1");
    row("no such node", R"("joints":[1,2])", R"("joints":[1,9])", "nodes/9");
    row("no such skin", R"("skin":0)", R"("skin":1)", "skins/1");
    row("too few matrices", R"("count":2,"type":"MAT4")", R"("count":1,"type":"MAT4")", "inverseBindMatrices");
    row("no matrices", R"("inverseBindMatrices":4)", R"("inverseBindMatrices":3)", "accessors/3");
    row("too few weights", R"("componentType":5126,"count":4,"type":"VEC4")",
        R"("componentType":5126,"count":3,"type":"VEC4")", "JOINTS_0");
    row("joints in themselves", R"({"scale":[2,2,2]})", R"({"children":[1]})", "nodes");
}

void TestGltfDocument::badSkins_areRefused()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, token);
    const auto error = errorOf(bytes);
    QVERIFY(error);
    QCOMPARE(QString::fromStdString(error->token), token);
    QCOMPARE(static_cast<int>(error->kind), static_cast<int>(Kind::Malformed));
}

void TestGltfDocument::decodedStreams_areReadOnce()
{
    int calls = 0;
    std::vector<std::uint32_t> asked;
    std::string got;
    core::setDracoDecoder([&](std::string_view stream, std::span<const std::uint32_t> ids) {
        ++calls;
        asked.assign(ids.begin(), ids.end());
        got = stream;
        return std::optional(tetrahedronStream());
    });
    QVERIFY(isTetrahedron(read(packedGltf(R"("nodes":[{"mesh":0,"scale":[0.001,0.001,0.001]}])"))));
    QCOMPARE(calls, 1);
    QVERIFY(asked == std::vector<std::uint32_t>{7});
    QCOMPARE(got, std::string("abc"));
    QCOMPARE(read(packedGltf(R"("nodes":[{"mesh":0},{"mesh":0,"translation":[0,0,9]}])")).triangles.size(),
             std::size_t(8));
    QCOMPARE(calls, 2);
    core::setDracoDecoder({});
    const auto error = errorOf(packedGltf(R"("nodes":[{"mesh":0}])"));
    QVERIFY(error && error->fault == core::FileFault::NeedsExtension);
    QVERIFY(error->expected > 700); // size of the file plus the three bytes of its stream
}

void TestGltfDocument::decodersResults_areChecked_data()
{
    QTest::addColumn<std::shared_ptr<core::DracoMesh>>("mesh"); // null: the decoder reports a broken stream
    QTest::addColumn<int>("kind");
    const auto row = [](const char* name, Kind kind, const std::function<void(core::DracoMesh&)>& change) {
        auto mesh = std::make_shared<core::DracoMesh>(tetrahedronStream());
        change(*mesh);
        QTest::newRow(name) << mesh << static_cast<int>(kind);
    };
    QTest::newRow("nothing") << std::shared_ptr<core::DracoMesh>() << static_cast<int>(Kind::Malformed);
    row("no vertices", Kind::Malformed, [](auto& mesh) { mesh.vertices = 0; });
    row("fewer bytes", Kind::Malformed, [](auto& mesh) { mesh.attributes[0].bytes.pop_back(); });
    row("no bytes", Kind::Malformed, [](auto& mesh) { mesh.attributes[0].bytes.clear(); });
    row("other type", Kind::Malformed, [](auto& mesh) { mesh.attributes[0].componentType = 5123; });
    row("no type", Kind::Malformed, [](auto& mesh) { mesh.attributes[0].componentType = 0; });
    row("two numbers", Kind::Malformed, [](auto& mesh) { mesh.attributes[0].components = 2; });
    row("other id", Kind::Malformed, [](auto& mesh) { mesh.attributes[0].id = 6; });
    row("no attribute", Kind::Malformed, [](auto& mesh) { mesh.attributes.clear(); });
    row("two corners", Kind::Malformed, [](auto& mesh) { mesh.corners.resize(11); });
    row("fewer triangles", Kind::Malformed, [](auto& mesh) { mesh.corners.resize(9); });
    row("no such vertex", Kind::IndexOutOfRange, [](auto& mesh) { mesh.corners[5] = 4; });
    row("no number", Kind::NotANumber, [](auto& mesh) { mesh.attributes[0].bytes.replace(4, 4, 4, '\xff'); });
    row("too much", Kind::UnpacksTooLarge, [](auto& mesh) { mesh.corners.resize(30'000'000); });
}

void TestGltfDocument::decodersResults_areChecked()
{
    QFETCH(std::shared_ptr<core::DracoMesh>, mesh);
    QFETCH(int, kind);
    core::setDracoDecoder(
        [&](std::string_view, std::span<const std::uint32_t>) { return mesh ? std::optional(*mesh) : std::nullopt; });
    const auto error = errorOf(packedGltf(R"("nodes":[{"mesh":0}])"));
    core::setDracoDecoder({});
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->kind), kind);
}

FETTLE_TEST(TestGltfDocument)
#include "tst_gltf_document.moc"
