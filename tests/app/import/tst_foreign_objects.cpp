// Tests that the objects of formats that Assimp reads become parts, with their names, and that a damaged result of the
// import process becomes none.

#include "app/import/import_parts.h"
#include "app/import/import_protocol.h"
#include "app/import/sandboxed_importer.h"
#include "app/model/model_loader.h"
#include "core/analysis/mesh_check.h"
#include "core/geometry/face_geometry.h"
#include "core/io/mesh_io.h"
#include "core/parts/part_split.h"
#include "core/util/file_error.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <assimp/Exporter.hpp>
#include <assimp/scene.h>

namespace
{
using core::Part;
using core::PartId;
using core::PartList;
using core::ReadResult;
using core::TriangleMesh;
using core::Vec3f;

struct Object
{
    std::string name;
    float x = 0; ///< position of the object, which is a cube of side 2
};

aiMesh* meshOf(const TriangleMesh& mesh)
{
    auto* to = new aiMesh; // owned by its scene
    to->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    to->mNumVertices = static_cast<unsigned>(mesh.points.size());
    to->mVertices = new aiVector3D[mesh.points.size()];
    to->mNormals = new aiVector3D[mesh.points.size()];
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        to->mVertices[i] = {mesh.points[i].x(), mesh.points[i].y(), mesh.points[i].z()};
        to->mNormals[i] = {0, 1, 0};
    }
    to->mNumFaces = static_cast<unsigned>(mesh.triangles.size());
    to->mFaces = new aiFace[mesh.triangles.size()];
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        to->mFaces[i].mNumIndices = 3;
        to->mFaces[i].mIndices = new unsigned[3]{mesh.triangles[i][0], mesh.triangles[i][1], mesh.triangles[i][2]};
    }
    return to;
}

/// Returns a scene with a node and a mesh for each object.
std::unique_ptr<aiScene> sceneOf(const std::vector<Object>& objects)
{
    auto scene = std::make_unique<aiScene>();
    const auto count = static_cast<unsigned>(objects.size());
    scene->mNumMeshes = count;
    scene->mMeshes = new aiMesh*[count];
    scene->mNumMaterials = 1;
    scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
    scene->mRootNode = new aiNode("root");
    for (unsigned i = 0; i < count; ++i) {
        scene->mMeshes[i] = meshOf(shapes::moved(shapes::cube(2), Vec3f(objects[i].x, 0, 0)));
        auto* node = new aiNode(objects[i].name);
        node->mNumMeshes = 1;
        node->mMeshes = new unsigned[1]{i};
        scene->mRootNode->addChildren(1, &node);
    }
    return scene;
}

/// Returns a text FBX of version 7.4 in millimetres. It has models with these names and a mesh each; the mesh of a
/// model is a cube, or of no faces if its name is "nothing".
QByteArray fbxOf(const std::vector<std::string>& names)
{
    const QByteArray cube = "Vertices: *24 {\na: 0,0,0,10,0,0,10,10,0,0,10,0,0,0,10,10,0,10,10,10,10,0,10,10\n}\n"
                            "PolygonVertexIndex: *24 {\na: 3,2,1,-1,4,5,6,-8,0,1,5,-5,1,2,6,-6,2,3,7,-7,3,0,4,-8\n}\n"
                            "GeometryVersion: 124\n",
                     none = "Vertices: *0 {\na: \n}\nPolygonVertexIndex: *0 {\na: \n}\nGeometryVersion: 124\n";
    QByteArray objects, connections;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const QByteArray geometry = QByteArray::number(qulonglong(1'000'000 + i)),
                         model = QByteArray::number(qulonglong(2'000'000 + i));
        objects += "Geometry: " + geometry + ", \"Geometry::g\", \"Mesh\" {\n" + (names[i] == "nothing" ? none : cube) +
                   "}\nModel: " + model + ", \"Model::" + QByteArray::fromStdString(names[i]) +
                   "\", \"Mesh\" {\nVersion: 232\nProperties70:  {\nP: \"Lcl Translation\", \"Vector3D\", \"Vector\", "
                   "\"\"," +
                   QByteArray::number(qulonglong(5 * i)) + ",0,0\n}\nShading: T\nCulling: \"CullingOff\"\n}\n";
        connections += "C: \"OO\"," + model + ",0\nC: \"OO\"," + geometry + "," + model + "\n";
    }
    return "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\nFBXHeaderVersion: 1003\nFBXVersion: 7400\n}\n"
           "GlobalSettings:  {\nVersion: 1000\nProperties70:  {\n"
           "P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",0.1\n}\n}\nObjects:  {\n" +
           objects + "}\nConnections:  {\n" + connections + "}\n";
}

std::vector<std::string> namesOf(const ReadResult& read)
{
    std::vector<std::string> names;
    for (const Part& part : read.parts.all())
        names.push_back(part.name);
    return names;
}

QByteArray bytesOf(const void* data, std::size_t size)
{
    return {static_cast<const char*>(data), static_cast<qsizetype>(size)};
}
} // namespace

class TestForeignObjects : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_dir.isValid());
        core::setExternalReader(app::sandboxedImporter(FETTLE_PROGRAM));
    }

    void objects_becomePartsIfWanted_data();
    void objects_becomePartsIfWanted();
    void oneObject_hasNoLabels();
    void theWindow_offersTheChoice();
    void fbx_namesOfAnyLength();
    void fbx_manyObjects_data();
    void fbx_manyObjects();
    void x3d_groupsAreObjects();
    void x3d_manyObjectsAreOnePart();
    void packedLists_comeBack();
    void damagedResults_areRefused_data();
    void damagedResults_areRefused();

private:
    std::filesystem::path file(const char* name) const
    {
        return m_dir.filePath(QString::fromLatin1(name)).toStdU16String();
    }
    void write(const char* name, const QByteArray& bytes) const
    {
        QFile to(m_dir.filePath(QString::fromLatin1(name)));
        QVERIFY(to.open(QIODevice::WriteOnly) && to.write(bytes) == bytes.size());
    }
    ReadResult readParts(const char* name, const QByteArray& bytes) const
    {
        write(name, bytes);
        return core::readModel(file(name), {.keepsObjects = true});
    }

    QTemporaryDir m_dir;
};

void TestForeignObjects::objects_becomePartsIfWanted_data()
{
    QTest::addColumn<QByteArray>("exporter");
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArrayList>("names"); // of the parts; Assimp's exporters change some, or write none
    const QByteArrayList own{"Body", "Lid", "Foot"};
    QTest::newRow("collada") << QByteArray("collada") << QByteArray("a.dae") << own;
    QTest::newRow("fbx") << QByteArray("fbxa") << QByteArray("a.fbx") << own;
    QTest::newRow("x") << QByteArray("x") << QByteArray("a.x") << own;
    QTest::newRow("3ds") << QByteArray("3ds") << QByteArray("a.3ds") << QByteArrayList{"Body_0", "Lid_1", "Foot_2"};
    QTest::newRow("x3d") << QByteArray("x3d") << QByteArray("a.x3d") << QByteArrayList{"", "", ""};
}

/// The first two cubes share a face, so their points must not be merged.
void TestForeignObjects::objects_becomePartsIfWanted()
{
    QFETCH(QByteArray, exporter);
    QFETCH(QByteArray, name);
    QFETCH(QByteArrayList, names);
    const auto scene = sceneOf({{"Body"}, {"Lid", 2}, {"Foot", 50}});
    const auto path = file(name.constData());
    QCOMPARE(int(Assimp::Exporter().Export(scene.get(), exporter.constData(), path.string())), int(aiReturn_SUCCESS));
    const ReadResult one = core::readModel(path);
    QVERIFY(one.mesh.parts.empty() && one.parts == PartList());
    QCOMPARE(one.remarks.objects, std::size_t(3));
    QCOMPARE(one.mesh.points.size(), std::size_t(20));

    const ReadResult read = core::readModel(path, {.keepsObjects = true});
    QCOMPARE(read.remarks.objects, std::size_t(1));
    QVERIFY(std::ranges::equal(namesOf(read), names, {}, {}, &QByteArray::toStdString));
    QCOMPARE(read.mesh.points.size(), std::size_t(24));
    QVERIFY(core::checkMesh(read.mesh).printReady());
    const auto pieces = core::splitByPart(read.mesh);
    QCOMPARE(pieces.size(), std::size_t(3));
    for (const core::PartPiece& piece : pieces) {
        QCOMPARE(piece.mesh.points.size(), std::size_t(8));
        QCOMPARE(piece.mesh.triangles.size(), std::size_t(12));
    }
    QVERIFY(core::boxOf(pieces[0].mesh).max().x() <= core::boxOf(pieces[1].mesh).min().x());
    QVERIFY(core::boxOf(pieces[1].mesh).max().x() < core::boxOf(pieces[2].mesh).min().x());
}

void TestForeignObjects::oneObject_hasNoLabels()
{
    const auto scene = sceneOf({{"Body"}});
    Assimp::Exporter().Export(scene.get(), "collada", file("one.dae").string());
    const ReadResult read = core::readModel(file("one.dae"), {.keepsObjects = true});
    QVERIFY(read.mesh.parts.empty() && read.parts == PartList());
    QCOMPARE(read.mesh.triangles.size(), std::size_t(12));
}

/// Tests that two cubes can be one part or two, but only two if they share a face.
void TestForeignObjects::theWindow_offersTheChoice()
{
    using Objects = app::ModelLoader::Objects;
    const QString path = m_dir.filePath(QStringLiteral("choice.dae"));
    Assimp::Exporter().Export(sceneOf({{"Body"}, {"Lid", 3}}).get(), "collada", path.toStdString());
    const app::LoadedModel one = app::ModelLoader::load(path),
                           two = app::ModelLoader::load(path, {}, {}, Objects::AsParts);
    QVERIFY(one.sculptor && two.sculptor);
    QVERIFY(one.objects.count == 2 && !one.objects.areParts && two.objects.count == 2 && two.objects.areParts);
    QCOMPARE(one.parts.size(), std::size_t(1));
    QCOMPARE(two.parts.all()[1].name, std::string("Lid"));
    Assimp::Exporter().Export(sceneOf({{"Body"}, {"Lid", 2}}).get(), "collada", path.toStdString());
    const app::LoadedModel touching = app::ModelLoader::load(path);
    QVERIFY2(touching.sculptor && !touching.notice.isEmpty(), qPrintable(touching.problem));
    QCOMPARE(touching.parts.size(), std::size_t(2));
}

/// Tests that long names are cut, that equal ones stay equal, and that an object without faces is no part.
void TestForeignObjects::fbx_namesOfAnyLength()
{
    const std::string longName(10'000, 'n');
    const ReadResult read =
        readParts("names.fbx", fbxOf({longName, "nothing", "Same", "Same", " \x01 a\xff ", longName}));
    const std::string cut(PartList::maxNameBytes, 'n');
    QVERIFY(namesOf(read) == std::vector<std::string>({cut, "Same", "Same", "a?", cut}));
    const auto pieces = core::splitByPart(read.mesh);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        QCOMPARE(core::boxOf(pieces[i].mesh).min().x(), static_cast<double>(5 * (i == 0 ? 0 : i + 1)));
}

void TestForeignObjects::fbx_manyObjects_data()
{
    QTest::addColumn<int>("count");
    QTest::newRow("500") << 500;
    QTest::newRow("one too many") << int(PartList::maxParts) + 1;
}

void TestForeignObjects::fbx_manyObjects()
{
    QFETCH(int, count);
    const bool fits = count <= int(PartList::maxParts);
    const auto objects = static_cast<std::size_t>(count);
    const ReadResult read = readParts("many.fbx", fbxOf(std::vector<std::string>(objects, "Cube")));
    QCOMPARE(read.parts.size(), fits ? objects : 1U);
    QCOMPARE(read.mesh.parts.empty(), !fits);
    QCOMPARE(read.remarks.objects, fits ? 1U : objects);
    QCOMPARE(read.mesh.triangles.size(), 12 * objects);
}

/// Tests that a group is an object with its name (DEF), or with that of a group around it, at each use.
void TestForeignObjects::x3d_groupsAreObjects()
{
    const QByteArray box = "<Shape><Box size='1 1 1'/></Shape>", longName(10'000, 'n');
    const ReadResult read = readParts(
        "groups.x3d", "<X3D><Scene><Transform DEF='Fuß_1 &amp; &quot;co&quot;'>" + box + box +
                          "</Transform><Transform DEF='Outer' translation='5 0 0'><Group>" + box +
                          "</Group></Transform><Group DEF='Empty'/><Transform translation='9 0 0'><Transform DEF='" +
                          longName + "'>" + box +
                          "</Transform></Transform><Transform translation='12 0 0'><Transform USE='Outer'/></Transform>"
                          "<Transform translation='30 0 0'>" +
                          box + "</Transform></Scene></X3D>");
    const std::string cut(PartList::maxNameBytes, 'n');
    const auto names = namesOf(read);
    QCOMPARE(names.size(), std::size_t(5));
    QVERIFY(std::vector(names.begin(), names.end() - 1) ==
            std::vector<std::string>({"Fuß_1 & \"co\"", "Outer", cut, "Outer"}));
    QCOMPARE(core::splitByPart(read.mesh)[0].mesh.triangles.size(), std::size_t(24));
}

void TestForeignObjects::x3d_manyObjectsAreOnePart()
{
    constexpr std::size_t count = 100'000;
    QByteArray text = "<X3D><Scene><Shape DEF='b'><Box size='1 1 1'/></Shape>";
    for (std::size_t i = 1; i < count; ++i)
        text += "<Transform DEF='t" + QByteArray::number(qulonglong(i)) + "'><Shape USE='b'/></Transform>";
    const ReadResult read = readParts("many.x3d", text + "</Scene></X3D>");
    QVERIFY(read.mesh.parts.empty() && read.parts == PartList());
    QCOMPARE(read.remarks.objects, count);
}

void TestForeignObjects::packedLists_comeBack()
{
    const std::string name(PartList::maxNameBytes, 'x');
    std::vector<Part> parts{{7, "Körper", true, false, core::Rgb{1, 2, 3}}, {core::maxPartId, "", false, true, {}}};
    parts[0].axes = Eigen::AngleAxisd(0.3, core::Vec3(1, 2, 3).normalized());
    QVERIFY(app::unpackedParts(app::packedParts(PartList(parts))) == PartList(parts));
    parts.clear();
    for (std::size_t i = 0; i < PartList::maxParts; ++i)
        parts.push_back({static_cast<PartId>(i), name, true, false, {}});
    const std::string packed = app::packedParts(PartList(parts));
    QVERIFY(packed.size() <= app::maxPackedParts);
    QVERIFY(app::unpackedParts(packed) == PartList(parts));
    for (std::size_t size : {std::size_t(0), std::size_t(1), packed.size() / 2 + 1, packed.size() - 1})
        QVERIFY(!app::unpackedParts(std::string_view(packed).substr(0, size)));
    QVERIFY(!app::unpackedParts(packed + packed)); // ids would be repeated
    parts.resize(1);
    parts[0].axes.coeffs() *= 2;
    QVERIFY(!app::unpackedParts(app::packedParts(PartList(parts))));
    parts[0].axes.coeffs().setConstant(std::numeric_limits<double>::quiet_NaN());
    QVERIFY(!app::unpackedParts(app::packedParts(PartList(parts))));
}

void TestForeignObjects::damagedResults_areRefused_data()
{
    QTest::addColumn<int>("label");   // of the second cube
    QTest::addColumn<int>("missing"); // labels that are not sent
    QTest::addColumn<int>("cut");     // bytes of the list that are not sent
    QTest::addColumn<bool>("isSound");
    QTest::newRow("sound") << 5 << 0 << 0 << true;
    QTest::newRow("label without part") << 6 << 0 << 0 << false;
    QTest::newRow("label beyond all parts") << 0x8005 << 0 << 0 << false;
    QTest::newRow("points without label") << 5 << 1 << 0 << false;
    QTest::newRow("list without labels") << 5 << 16 << 0 << false;
    QTest::newRow("list cut off") << 5 << 0 << 1 << false;
    QTest::newRow("no list") << 5 << 0 << 1'000 << false;
}

void TestForeignObjects::damagedResults_areRefused()
{
    QFETCH(int, label);
    QFETCH(int, missing);
    QFETCH(int, cut);
    QFETCH(bool, isSound);
    const TriangleMesh mesh =
        core::joined({{4, shapes::cube(2), {}, {}}, {5, shapes::moved(shapes::cube(2), Vec3f(9, 0, 0)), {}, {}}});
    std::vector<PartId> labels = mesh.parts;
    std::ranges::replace(labels, PartId(5), static_cast<PartId>(label));
    labels.resize(labels.size() - static_cast<std::size_t>(missing));
    std::string packed = app::packedParts(PartList({{4, "One", true, false, {}}, {5, "Two", true, false, {}}}));
    packed.resize(packed.size() - std::min(packed.size(), static_cast<std::size_t>(cut)));
    app::ImportHeader header;
    header.outcome = app::ImportHeader::Outcome::Read;
    header.points = mesh.points.size();
    header.labels = labels.size();
    header.triangles = mesh.triangles.size();
    header.partBytes = packed.size();
    write("result", bytesOf(&header, sizeof header) + bytesOf(mesh.points.data(), mesh.points.size() * sizeof(Vec3f)) +
                        bytesOf(labels.data(), labels.size() * sizeof(PartId)) +
                        bytesOf(mesh.triangles.data(), mesh.triangles.size() * sizeof(core::Triangle)) +
                        bytesOf(packed.data(), packed.size()) + bytesOf(&app::importEnd, sizeof app::importEnd));
    write("a.fbx", "x");
    write("reader.sh", "#!/bin/sh\nexec cat '" + QFile::encodeName(m_dir.filePath(QStringLiteral("result"))) + "'\n");
    QFile::setPermissions(m_dir.filePath(QStringLiteral("reader.sh")), QFile::ReadOwner | QFile::ExeOwner);
    const auto reader = app::sandboxedImporter(file("reader.sh").string());
    try {
        const ReadResult read = reader.read(file("a.fbx"), {.keepsObjects = true});
        QVERIFY(isSound);
        QVERIFY(namesOf(read) == std::vector<std::string>({"One", "Two"}));
        QVERIFY(read.mesh.parts == mesh.parts && read.mesh.triangles == mesh.triangles);
    } catch (const core::FileError& error) {
        QVERIFY(!isSound);
        QCOMPARE(int(error.kind), int(core::FileErrorKind::ReaderDied));
    }
}

FETTLE_TEST(TestForeignObjects, QCoreApplication)
#include "tst_foreign_objects.moc"
