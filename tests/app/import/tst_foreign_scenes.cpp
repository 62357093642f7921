// Tests shapes of files that are imported through Assimp. Each scene is written here, so that its size, volume or area
// is known.

#include "app/import/sandboxed_importer.h"
#include "core/io/mesh/zip_writer.h"
#include "core/io/mesh_io.h"
#include "core/util/file_error.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QFile>
#include <QPointF>
#include <QStringEncoder>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace
{
using core::ReadResult;
using core::Vec3;
using core::Vec3f;

/// Precision of coordinates in mm, because Assimp computes in 32 bits.
constexpr double tolerance = 1e-3;

struct Box
{
    Vec3 min = Vec3::Constant(1e9), max = Vec3::Constant(-1e9);
    Vec3 size() const { return max - min; }
};

Box boxOf(const core::TriangleMesh& mesh)
{
    Box box;
    for (const Vec3f& point : mesh.points) {
        box.min = box.min.cwiseMin(point.cast<double>());
        box.max = box.max.cwiseMax(point.cast<double>());
    }
    return box;
}

double areaOf(const core::TriangleMesh& mesh)
{
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 p = mesh.points[a].cast<double>(), q = mesh.points[b].cast<double>();
        area += (q - p).cross(mesh.points[c].cast<double>() - p).norm() / 2;
    }
    return area;
}

double volumeOf(const core::TriangleMesh& mesh)
{
    double six = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        six += mesh.points[a].cast<double>().dot(mesh.points[b].cast<double>().cross(mesh.points[c].cast<double>()));
    return six / 6;
}

/// Returns FBX definitions with a template of these properties for models.
QByteArray templateOf(const QByteArray& properties)
{
    return "Definitions:  {\nObjectType: \"Model\" {\nPropertyTemplate: \"FbxNode\" {\nProperties70:  {\n" +
           properties + "}\n}\n}\n}\n";
}

/// A model of an FBX file, with a cube of side 10 that starts at the origin.
struct FbxModel
{
    QByteArray properties = {}; ///< property lines as made by vector()
    int parent = -1;            ///< index of an earlier model; -1: none
};

QByteArray vector(const char* name, const Vec3& v)
{
    return QByteArray("P: \"") + name + R"(", "Vector3D", "Vector", "",)" + QByteArray::number(v.x()) + "," +
           QByteArray::number(v.y()) + "," + QByteArray::number(v.z()) + "\n";
}

QByteArray number(const char* name, int value)
{
    return QByteArray("P: \"") + name + R"(", "int", "Integer", "",)" + QByteArray::number(value) + "\n";
}

QByteArray meshOf(const QByteArray& points, int numbers, const QByteArray& corners, int indices)
{
    return "Vertices: *" + QByteArray::number(numbers) + " {\na: " + points + "\n}\nPolygonVertexIndex: *" +
           QByteArray::number(indices) + " {\na: " + corners + "\n}\nGeometryVersion: 124\n";
}

QByteArray cube()
{
    return meshOf("0,0,0,10,0,0,10,10,0,0,10,0,0,0,10,10,0,10,10,10,10,0,10,10", 24,
                  "3,2,1,-1,4,5,6,-8,0,1,5,-5,1,2,6,-6,2,3,7,-7,3,0,4,-8", 24);
}

/// Returns an FBX file of version 7.4 as text, by default in millimetres and with Y up.
QByteArray fbx(const QList<FbxModel>& models, const QByteArray& settings = {}, const QByteArray& mesh = cube(),
               const QByteArray& definitions = {})
{
    QByteArray objects, connections;
    for (qsizetype i = 0; i < models.size(); ++i) {
        const QByteArray geometry = QByteArray::number(1000 + i), model = QByteArray::number(2000 + i);
        objects += "Geometry: " + geometry + ", \"Geometry::g\", \"Mesh\" {\n" + mesh + "}\n";
        objects += "Model: " + model + ", \"Model::m" + QByteArray::number(i) +
                   "\", \"Mesh\" {\nVersion: 232\nProperties70:  {\n" + models[i].properties +
                   "}\nShading: T\nCulling: \"CullingOff\"\n}\n";
        const int parent = models[i].parent;
        connections += "C: \"OO\"," + model + "," + (parent < 0 ? "0" : QByteArray::number(2000 + parent)) + "\n";
        connections += "C: \"OO\"," + geometry + "," + model + "\n";
    }
    return "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\nFBXHeaderVersion: 1003\nFBXVersion: 7400\n}\n"
           "GlobalSettings:  {\nVersion: 1000\nProperties70:  {\n" +
           (settings.isEmpty() ? R"(P: "UnitScaleFactor", "double", "Number", "",0.1)" : settings) + "\n}\n}\n" +
           definitions + "Objects:  {\n" + objects + "}\nConnections:  {\n" + connections + "}\n";
}

/// Returns a triangle of 1 by 2 metres in LightWave's binary chunk format. `last`: index of its third corner.
QByteArray lwo(char last)
{
    const auto chunk = [](const char* name, const QByteArray& content) {
        QByteArray size(4, '\0');
        qToBigEndian(quint32(content.size()), size.data());
        return name + size + content;
    };
    QByteArray points;
    for (const float value : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 2.0F, 0.0F}) {
        QByteArray number(4, '\0');
        qToBigEndian(value, number.data());
        points += number;
    }
    const QByteArray polygon = QByteArray("FACE\0\3\0\0\0\1\0", 11) + last;
    return chunk("FORM", "LWO2" + chunk("TAGS", QByteArray("a\0", 2)) + chunk("LAYR", QByteArray(18, '\0')) +
                             chunk("PNTS", points) + chunk("POLS", polygon) +
                             chunk("PTAG", QByteArray("SURF\0\0\0\0", 8)) + chunk("SURF", QByteArray("a\0\0\0", 4)));
}

/// Returns a COLLADA tetrahedron with some words replaced by others.
QByteArray dae(const QList<std::pair<QByteArray, QByteArray>>& changes = {})
{
    QByteArray text =
        "<?xml version=\"1.0\"?>\n"
        "<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">\n"
        "<asset><unit meter=\"1\" name=\"meter\"/><up_axis>Y_UP</up_axis></asset>\n"
        "<library_geometries><geometry id=\"g\"><mesh>\n"
        "<source id=\"s\"><float_array id=\"a\" count=\"12\">0 0 0 1 0 0 0 1 0 0 0 1</float_array><technique_common>\n"
        "<accessor source=\"#a\" count=\"4\" stride=\"3\"><param name=\"X\"/><param name=\"Y\"/><param "
        "name=\"Z\"/></accessor>\n"
        "</technique_common></source>\n"
        "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#s\"/></vertices>\n"
        "<triangles count=\"4\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>\n"
        "<p>0 2 1 0 1 3 1 2 3 2 0 3</p></triangles>\n"
        "</mesh></geometry></library_geometries>\n"
        "<library_visual_scenes><visual_scene id=\"vs\">\n"
        "<node id=\"n\"><instance_geometry url=\"#g\"/></node>\n"
        "</visual_scene></library_visual_scenes>\n"
        "<scene><instance_visual_scene url=\"#vs\"/></scene>\n"
        "</COLLADA>\n";
    for (const auto& [old, by] : changes) {
        Q_ASSERT(text.contains(old));
        text.replace(old, by);
    }
    return text;
}
} // namespace

class TestForeignScenes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_dir.isValid());
        core::setExternalReader(app::sandboxedImporter(FETTLE_PROGRAM));
    }

    void fbx_geometricTransformsStayWithTheirMesh();
    void fbx_geometricScaleOfNothingSparesChildren();
    void fbx_postRotationIsInverted();
    void fbx_pivotsArePassedAround();
    void fbx_inactiveRotationsAreNot();
    void fbx_ordersAreOfOwnRotationsAlone_data();
    void fbx_ordersAreOfOwnRotationsAlone();
    void fbx_carelessTextIsTurnedRight();
    void fbx_cyclesAndSphericOrdersAreRefused();
    void fbx_whatIsNotInTheSceneIsTold();
    void fbx_scalesAreInherited_data();
    void fbx_scalesAreInherited();
    void fbx_mirrorsAreScales_data();
    void fbx_mirrorsAreScales();
    void fbx_equalNamesAreToldApart();
    void fbx_pairsStandOnce();
    void fbx_idsAreOf64Bits();
    void fbx_hiddenModelsAreLeftOut();
    void fbx_finestLevelsAlone();
    void fbx_axesAndUnitAreItsOwn_data();
    void fbx_axesAndUnitAreItsOwn();
    void fbx_polygonsAreFilledExactly();
    void fbx_brokenMeshesAreTold();
    void fbx_polygonsOfFewerCornersAreCounted();
    void fbx_numbersAreFinite_data();
    void fbx_numbersAreFinite();
    void fbx_wordsAreNumbers();
    void fbx_oldVersionsAreRefusedByName();
    void ifc_otherSchemasAreRefusedByName();
    void fbx_subdivisionsAndNurbsAreTold();

    void x3d_usesAreThere();
    void x3d_solidsAreClosed_data();
    void x3d_solidsAreClosed();
    void x3d_inlinedFilesAreExpandedToo();
    void x3d_manyInlinesAreNoCycle();
    void x3d_inlinesAreFoundByUrl();
    void x3d_brokenFilesAreNamed();
    void x3d_unitsAreEachFilesOwn();
    void x3d_inlinedFilesKeepTheirNames_data();
    void x3d_inlinedFilesKeepTheirNames();
    void x3d_badFilesAreRefused();
    void x3d_otherEncodingsAreRefused();

    void dae_brokenRulesAreTold_data();
    void dae_brokenRulesAreTold();
    void dae_unitsMayHaveACommaOrBeMissing();
    void dae_missingInstancesAreTold();
    void zae_brokenRulesAreTold();
    void dae_harmlessOdditiesAreRead();
    void brokenFiles_areToldWithTheirPlace_data();
    void brokenFiles_areToldWithTheirPlace();
    void dae_isReadInUtf16AndWithBlanks();
    void lws_isAsLargeAsItsLwo();
    void lws_missingObjectsAreTold();
    void lwo_missingCornersAreTold();
    void threeDs_missingCornersAreTold();
    void words_areWholeAndWithoutPath();

private:
    std::filesystem::path file(const QString& name) const { return m_dir.filePath(name).toStdU16String(); }
    void write(const QString& name, const QByteArray& bytes) const
    {
        QFile to(m_dir.filePath(name));
        QVERIFY(to.open(QIODevice::WriteOnly) && to.write(bytes) == bytes.size());
    }
    ReadResult read(const QString& name, const QByteArray& bytes) const
    {
        write(name, bytes);
        return core::readModel(file(name));
    }
    /// Returns the error with which the file is refused, or nothing.
    std::optional<core::FileError> errorOf(const QString& name, const QByteArray& bytes) const
    {
        try {
            read(name, bytes);
        } catch (const core::FileError& error) {
            return error;
        }
        return std::nullopt;
    }
    ReadResult readFbx(const QByteArray& bytes) const { return read(QStringLiteral("a.fbx"), bytes); }

    QTemporaryDir m_dir;
};

#define COMPARE_VECTORS(actual, ...)                                                                                   \
    do {                                                                                                               \
        const Vec3 is = (actual), wanted(__VA_ARGS__);                                                                 \
        QVERIFY2((is - wanted).cwiseAbs().maxCoeff() < tolerance,                                                      \
                 qPrintable(QStringLiteral("%1, %2, %3").arg(is.x()).arg(is.y()).arg(is.z())));                        \
    } while (false)

/// 3ds Max writes geometric transforms for moved pivots. They must not affect child models.
void TestForeignScenes::fbx_geometricTransformsStayWithTheirMesh()
{
    const QByteArray geometric = vector("GeometricTranslation", {0, 0, 10}) + vector("GeometricRotation", {0, 90, 0}) +
                                 vector("GeometricScaling", {1, 1, 2});
    const QByteArray lower = vector("Lcl Translation", {0, 0, 20});
    const ReadResult both = readFbx(fbx({{.properties = geometric}, {.properties = lower, .parent = 0}}));
    QCOMPARE(both.remarks.objects, std::size_t(2));
    COMPARE_VECTORS(boxOf(both.mesh).min, 0, 0, 0);
    COMPARE_VECTORS(boxOf(both.mesh).size(), 20, 10, 30);
    const ReadResult grandchild = readFbx(fbx({{.properties = geometric},
                                               {.properties = geometric + lower, .parent = 0},
                                               {.properties = lower, .parent = 1}}));
    COMPARE_VECTORS(boxOf(grandchild.mesh).max, 20, 10, 50);
}

void TestForeignScenes::fbx_geometricScaleOfNothingSparesChildren()
{
    const ReadResult flat =
        readFbx(fbx({{.properties = vector("GeometricScaling", {1, 1, 0})}, {.properties = {}, .parent = 0}}));
    COMPARE_VECTORS(boxOf(flat.mesh).size(), 10, 10, 10);
}

/// A rotation and an equal PostRotation cancel each other.
void TestForeignScenes::fbx_postRotationIsInverted()
{
    const Vec3 angles(20, 30, 40);
    const QByteArray post = vector("PostRotation", angles);
    COMPARE_VECTORS(boxOf(readFbx(fbx({{post + vector("Lcl Rotation", angles)}})).mesh).size(), 10, 10, 10);
    COMPARE_VECTORS(boxOf(readFbx(fbx({{post + vector("PreRotation", angles)}})).mesh).size(), 10, 10, 10);
    const ReadResult child = readFbx(fbx({{post}, {.properties = vector("PreRotation", angles), .parent = 0}}));
    QVERIFY(std::abs(volumeOf(child.mesh) - 2000) < 1);
}

void TestForeignScenes::fbx_pivotsArePassedAround()
{
    const QByteArray turned = vector("Lcl Rotation", {0, 0, 90}) + vector("RotationPivot", {10, 0, 0}) +
                              vector("RotationOffset", {0, 0, 5}) + vector("Lcl Scaling", {1, 1, 3}) +
                              vector("ScalingPivot", {0, 0, 10}) + vector("ScalingOffset", {0, 0, 1});
    const Box box = boxOf(readFbx(fbx({{turned}})).mesh);
    COMPARE_VECTORS(box.min, 0, -10, -14);
    COMPARE_VECTORS(box.max, 10, 0, 16);
}

void TestForeignScenes::fbx_inactiveRotationsAreNot()
{
    for (const char* property : {"PreRotation", "PostRotation"}) {
        const QByteArray turned = vector(property, {0, 0, 45});
        QVERIFY(boxOf(readFbx(fbx({{turned}})).mesh).size().x() > 14);
        const QByteArray off = R"(P: "RotationActive", "bool", "", "",0)"
                               "\n",
                         limits = R"(P: "RotationSpaceForLimitOnly", "bool", "", "",1)"
                                  "\n";
        COMPARE_VECTORS(boxOf(readFbx(fbx({{turned + off}})).mesh).size(), 10, 10, 10);
        COMPARE_VECTORS(boxOf(readFbx(fbx({{turned + limits}})).mesh).size(), 10, 10, 10);
        COMPARE_VECTORS(boxOf(readFbx(fbx({{}}, {}, cube(), templateOf(turned + off))).mesh).size(), 10, 10, 10);
    }
}

void TestForeignScenes::fbx_ordersAreOfOwnRotationsAlone_data()
{
    QTest::addColumn<int>("order");
    int order = 0;
    for (const char* name : {"XYZ", "XZY", "YZX", "YXZ", "ZXY", "ZYX"})
        QTest::newRow(name) << order++;
}

/// Geometric and inactive rotations are about x, then y, then z, whatever the model's rotation order is.
void TestForeignScenes::fbx_ordersAreOfOwnRotationsAlone()
{
    QFETCH(int, order);
    const QByteArray ordered = number("RotationOrder", order), off = number("RotationActive", 0),
                     usual = templateOf(off);
    for (const Vec3& angles : {Vec3(20, 40, 60), Vec3(10, 90, 35)}) {
        const auto pointsOf = [&](const QByteArray& properties, const QByteArray& definitions = {}) {
            return readFbx(fbx({{properties}}, {}, cube(), definitions)).mesh.points;
        };
        const auto areAlike = [](const std::vector<Vec3f>& a, const std::vector<Vec3f>& b) {
            return a.size() == b.size() &&
                   std::equal(a.begin(), a.end(), b.begin(),
                              [](const Vec3f& p, const Vec3f& q) { return (p - q).norm() < 1e-4F; });
        };
        const QByteArray own = vector("Lcl Rotation", angles), geometric = vector("GeometricRotation", angles);
        const std::vector<Vec3f> turned = pointsOf(own);
        QVERIFY(areAlike(pointsOf(geometric + ordered), turned));
        QVERIFY(areAlike(pointsOf(own + ordered + off), turned));
        QVERIFY(areAlike(pointsOf(own + ordered, usual), turned));
        QVERIFY(areAlike(pointsOf(ordered, templateOf(geometric)), turned));
        QVERIFY(areAlike(pointsOf({}, templateOf(own + ordered + off)), turned));
        QVERIFY(areAlike(pointsOf(own + ordered), turned) == (order == 0));
    }
}

/// CR alone ends lines and an extra brace ends the file, as in Assimp. Rotations must be corrected in such files, too.
void TestForeignScenes::fbx_carelessTextIsTurnedRight()
{
    const QByteArray plain = fbx(
        {{number("RotationOrder", 5) + vector("GeometricRotation", {30, 40, 50})},
         {vector("Lcl Rotation", {10, 20, 30}) + vector("PreRotation", {5, 6, 7}) + number("RotationActive", 0), 0}});
    const core::TriangleMesh wanted = read(QStringLiteral("plain.fbx"), plain).mesh;
    QVERIFY(std::abs(volumeOf(wanted) - 2000) < 1e-2);
    for (const QByteArray& careless : {QByteArray(plain).replace('\n', '\r'), plain + "}\n", plain + "} x \" {"}) {
        const core::TriangleMesh mesh = read(QStringLiteral("careless.fbx"), careless).mesh;
        QCOMPARE(mesh.points.size(), wanted.points.size());
        for (std::size_t i = 0; i < mesh.points.size(); ++i)
            QVERIFY((mesh.points[i] - wanted.points[i]).norm() < static_cast<float>(tolerance));
    }
}

void TestForeignScenes::fbx_cyclesAndSphericOrdersAreRefused()
{
    QByteArray cyclic = fbx({{}, {.properties = {}, .parent = 0}});
    cyclic.replace("Connections:  {\n", "Connections:  {\nC: \"OO\",2000,2001\n");
    const auto cycle = errorOf(QStringLiteral("a.fbx"), cyclic);
    QVERIFY(cycle && cycle->kind == core::FileErrorKind::Malformed && cycle->fault == core::FileFault::TooDeep);
    QCOMPARE(cycle->token, std::string("models below m0"));
    const auto spheric =
        errorOf(QStringLiteral("a.fbx"), fbx({{vector("Lcl Rotation", {1, 2, 3}) + number("RotationOrder", 6)}}));
    QVERIFY(spheric && spheric->kind == core::FileErrorKind::ReaderRefused);
    QCOMPARE(spheric->token, std::string("the rotation order SphericXYZ is not read"));
}

/// A file whose meshes are all outside of the scene is refused with the reason, not as one without faces.
void TestForeignScenes::fbx_whatIsNotInTheSceneIsTold()
{
    const QByteArray two = fbx({{}, {.properties = {}, .parent = 0}}), inScene = "C: \"OO\",2000,0\n";
    QByteArray loose = two, cyclic = two,
               below = fbx({{}, {.properties = {}, .parent = 0}, {.properties = {}, .parent = 1}});
    loose.replace(inScene, "");
    cyclic.replace(inScene, "C: \"OO\",2000,2001\n");
    below.replace(inScene, "C: \"OO\",2000,2001\n")
        .replace("C: \"OO\",1000,2000\n", "")
        .replace("C: \"OO\",1001,2001\n", "");
    const auto isTold = [&](const QByteArray& bytes, core::FileFault fault, const char* token) {
        const auto error = errorOf(QStringLiteral("a.fbx"), bytes);
        return error && error->kind == core::FileErrorKind::Malformed && error->fault == fault && error->token == token;
    };
    QVERIFY(isTold(loose, core::FileFault::NotInScene, "m0"));
    QVERIFY(isTold(cyclic, core::FileFault::TooDeep, "models below m0"));
    QVERIFY(isTold(below, core::FileFault::TooDeep, "models below m0")); // the only mesh is below the cycle
    QByteArray alone = two;                                              // no model has the meshes
    alone.replace("C: \"OO\",1000,2000\n", "").replace("C: \"OO\",1001,2001\n", "");
    QVERIFY(isTold(alone, core::FileFault::NotInScene, "Geometry::g"));
    const QByteArray meshless = fbx({{}}, {}, "Vertices: *0 {\na: \n}\nPolygonVertexIndex: *0 {\na: \n}\n");
    QCOMPARE(errorOf(QStringLiteral("a.fbx"), meshless)->kind, core::FileErrorKind::NoFaces);
    QByteArray beside = fbx({{}, {}, {}}); // a cycle beside what the scene shows
    beside.replace("C: \"OO\",2001,0\n", "C: \"OO\",2001,2002\n")
        .replace("C: \"OO\",2002,0\n", "C: \"OO\",2002,2001\n");
    QCOMPARE(readFbx(beside).mesh.triangles.size(), std::size_t(12));
    QCOMPARE(readFbx(beside).remarks.hiddenObjects, std::size_t(2));
}

void TestForeignScenes::fbx_scalesAreInherited_data()
{
    QTest::addColumn<int>("inheritType");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::newRow("as matrices") << 1 << 20.0 << 10.0;
    QTest::newRow("by own axes") << 0 << 10.0 << 20.0; // the child's x is the world's y
    QTest::newRow("not at all") << 2 << 10.0 << 10.0;
}

/// The parent is scaled by 2 in x. The child is rotated by 90 degrees, and its position is scaled in every case.
void TestForeignScenes::fbx_scalesAreInherited()
{
    QFETCH(int, inheritType);
    QFETCH(double, x);
    QFETCH(double, y);
    const QByteArray scale = vector("Lcl Scaling", {2, 1, 1}) + vector("GeometricScaling", {0, 0, 0});
    const QByteArray inherit = R"(P: "InheritType", "enum", "", "",)" + QByteArray::number(inheritType) + "\n",
                     child = vector("Lcl Rotation", {0, 0, 90}) + vector("Lcl Translation", {50, 0, 0});
    for (const QByteArray& bytes :
         {fbx({{scale}, {.properties = inherit + child, .parent = 0}}),
          fbx({{scale}, {.properties = child, .parent = 0}}, {}, cube(), templateOf(inherit))}) {
        core::TriangleMesh mesh = readFbx(bytes).mesh;
        // removes the parent's points: GeometricScaling 0 moves them to the origin
        std::erase_if(mesh.points, [](const Vec3f& p) { return p.isZero(); });
        const Box box = boxOf(mesh);
        COMPARE_VECTORS(box.size(), x, y, 10);
        COMPARE_VECTORS(Vec3(box.max.x(), box.min.y(), box.min.z()), 100, 0, 0);
    }
}

void TestForeignScenes::fbx_mirrorsAreScales_data()
{
    QTest::addColumn<int>("inheritType");
    QTest::addColumn<QList<int>>("ends"); // far ends of the child's axes
    QTest::newRow("as matrices") << 1 << QList<int>{20, 10, 10};
    QTest::newRow("by own axes") << 0 << QList<int>{-10, -20, 10}; // the child's x is the world's y
    QTest::newRow("not at all") << 2 << QList<int>{-10, 10, 10};
}

/// The parent is mirrored and scaled by 2 in x. The child is rotated by 90 degrees.
void TestForeignScenes::fbx_mirrorsAreScales()
{
    QFETCH(int, inheritType);
    QFETCH(QList<int>, ends);
    const QByteArray mirror = vector("Lcl Scaling", {-2, 1, 1}) + vector("GeometricScaling", {0, 0, 0}),
                     child = number("InheritType", inheritType) + vector("Lcl Rotation", {0, 0, 90});
    const core::TriangleMesh mesh = readFbx(fbx({{mirror}, {.properties = child, .parent = 0}})).mesh;
    QVERIFY(volumeOf(mesh) > 999);
    const Box box = boxOf(mesh);
    for (int axis = 0; axis < 3; ++axis) {
        QVERIFY(std::abs((ends[axis] < 0 ? box.min : box.max)[axis] - ends[axis]) < tolerance);
        QVERIFY(std::abs((ends[axis] < 0 ? box.max : box.min)[axis]) < tolerance);
    }
}

/// Assimp numbers equal names and omits unreadable models. Each model must still get its own scale.
void TestForeignScenes::fbx_equalNamesAreToldApart()
{
    const auto inherits = [](int type, double x) {
        return number("InheritType", type) + vector("Lcl Translation", {x, 0, 0});
    };
    QByteArray bytes =
        fbx({{vector("Lcl Scaling", {2, 1, 1})}, {inherits(2, 100), 0}, {inherits(1, 200), 0}, {inherits(2, 300), 0}});
    for (const char* name : {"m2", "m3"})
        bytes.replace(QByteArray("Model::") + name, "Model::m1");
    std::map<int, double> ends; // key: start of a cube in x; value: its end
    for (const Vec3f& point : readFbx(bytes).mesh.points) {
        double& end = ends[static_cast<int>(point.x()) / 100];
        end = std::max(end, static_cast<double>(point.x()));
    }
    QVERIFY(ends == (std::map<int, double>{{0, 20}, {2, 210}, {4, 420}, {6, 610}}));
}

/// A repeated connection, even one of a property without a name, must not duplicate the model.
void TestForeignScenes::fbx_pairsStandOnce()
{
    for (const char* again : {"C: \"OO\",%\n", "C: \"OP\",%, \"\"\n", "C: \"PO\",%, \"x\"\n"})
        for (const char* pair : {"2000,0", "2001,2000", "1000,2000", "1001,2001"}) {
            const QByteArray line = QByteArray(again).replace('%', pair);
            for (const QByteArray& place : {QByteArray("Connections:  {\n"), QByteArray("C: \"OO\",1001,2001\n")}) {
                const ReadResult result = readFbx(fbx({{}, {{}, 0}}).replace(place, place + line));
                QCOMPARE(result.remarks.objects, std::size_t(2));
                QCOMPARE(result.mesh.triangles.size(), std::size_t(24));
            }
        }
}

void TestForeignScenes::fbx_idsAreOf64Bits()
{
    for (const char* id :
         {"9223372036854775807", "9223372036854775808", "18446744073709551615", "-1", "-5", "-9223372036854775808"}) {
        const QByteArray mirrored = vector("Lcl Scaling", {-2, 1, 1}), child = number("InheritType", 2);
        QByteArray bytes = fbx({{mirrored}, {.properties = child, .parent = 0}});
        bytes.replace("2000", id).replace("1001", "-77"); // ids of a model and of a mesh
        COMPARE_VECTORS(boxOf(readFbx(bytes).mesh).size(), 30, 10, 10);
    }
}

/// Show hides only the model itself. Visibility also hides child models that inherit it. The child cubes are 20 apart.
void TestForeignScenes::fbx_hiddenModelsAreLeftOut()
{
    const auto sizeOf = [this](const QByteArray& top, const QByteArray& below, const QByteArray& usual = {}) {
        const QByteArray aside = vector("Lcl Translation", {20, 0, 0});
        const Box box = boxOf(
            readFbx(fbx({{}, {top + aside}, {.properties = below + aside, .parent = 1}}, {}, cube(), templateOf(usual)))
                .mesh);
        return Vec3(box.min.x(), box.max.x(), 0);
    };
    const QByteArray unseen = number("Show", 0), invisible = number("Visibility", 0), visible = number("Visibility", 1),
                     own = number("Visibility Inheritance", 0);
    COMPARE_VECTORS(sizeOf({}, {}), 0, 50, 0);
    COMPARE_VECTORS(sizeOf({}, unseen), 0, 30, 0);
    COMPARE_VECTORS(sizeOf({}, invisible), 0, 30, 0);
    COMPARE_VECTORS(sizeOf(unseen, {}), 0, 50, 0);
    QCOMPARE(readFbx(fbx({{}, {unseen}, {.properties = {}, .parent = 1}})).remarks.objects, std::size_t(2));
    COMPARE_VECTORS(sizeOf(invisible, {}), 0, 10, 0);
    COMPARE_VECTORS(sizeOf(invisible, visible), 0, 10, 0);
    COMPARE_VECTORS(sizeOf(invisible, own), 0, 50, 0);
    COMPARE_VECTORS(sizeOf(visible, {}, own), 0, 50, 0);
    COMPARE_VECTORS(sizeOf(visible, {}, invisible), 20, 30, 0);
    QVERIFY(errorOf(QStringLiteral("a.fbx"), fbx({{unseen}}))->kind == core::FileErrorKind::NoFaces);
    QByteArray bytes = fbx({{}, {unseen}}); // unreadable meshes of hidden models are not reported
    bytes.replace(bytes.lastIndexOf("3,2,1,-1,4"), 10, "3,2,99,-1,4");
    QCOMPARE(readFbx(bytes).remarks.unreadNodes, std::size_t(0));
    QCOMPARE(readFbx(bytes).remarks.hiddenObjects, std::size_t(1));
    QCOMPARE(readFbx(fbx({{}, {}})).remarks.hiddenObjects, std::size_t(0));
    QCOMPARE(readFbx(fbx({{}, {invisible}, {{}, 1}})).remarks.hiddenObjects, std::size_t(2));
}

/// Only the first model below a group of levels of detail is read, which is the finest one.
void TestForeignScenes::fbx_finestLevelsAlone()
{
    const auto at = [](double x) { return vector("Lcl Translation", {x, 0, 0}); };
    QByteArray bytes = fbx({{at(100)}, {at(0), 0}, {at(5), 1}, {at(2), 0}, {at(3), 0}});
    bytes.replace("\"Model::m0\", \"Mesh\"", "\"Model::m0\", \"LodGroup\"");
    const core::ReadResult finest = readFbx(bytes);
    QCOMPARE(finest.remarks.hiddenObjects, std::size_t(0));
    QCOMPARE(finest.remarks.objects, std::size_t(3)); // the group's own mesh, the finest level, and its child
    COMPARE_VECTORS(boxOf(finest.mesh).min, 100, 0, 0);
    COMPARE_VECTORS(boxOf(finest.mesh).max, 115, 10, 10);
    // If a level shows nothing, the next level is used.
    QByteArray levels = fbx({{at(100)}, {at(0), 0}, {at(5), 0}, {at(30), 0}});
    levels.replace("\"Model::m0\", \"Mesh\"", "\"Model::m0\", \"LodGroup\"").replace("C: \"OO\",1000,2000\n", "");
    COMPARE_VECTORS(boxOf(readFbx(levels).mesh).min, 100, 0, 0);
    const QByteArray empty = QByteArray(levels).replace("C: \"OO\",1001,2001\n", "");
    QByteArray broken = levels;
    broken.replace(broken.indexOf("3,2,1,-1,4", broken.indexOf("Geometry: 1001")), 10, "3,2,99,-1,4");
    QByteArray hidden = levels;
    hidden.replace(hidden.indexOf("Properties70:  {\n", hidden.indexOf("Model: 2001")), 17,
                   "Properties70:  {\n" + number("Show", 0));
    for (const QByteArray& next : {empty, broken, hidden}) {
        const ReadResult result = readFbx(next);
        COMPARE_VECTORS(boxOf(result.mesh).min, 105, 0, 0);
        COMPARE_VECTORS(boxOf(result.mesh).max, 115, 10, 10);
        QCOMPARE(result.remarks.unreadNodes, std::size_t(next == broken ? 1 : 0));
    }
}

void TestForeignScenes::fbx_axesAndUnitAreItsOwn_data()
{
    QTest::addColumn<QByteArray>("settings");
    QTest::addColumn<QList<int>>("place"); // image in cm of the file's corner (1, 2, 3)
    const auto axes = [](int right, int up, int front, int frontSign) {
        return number("CoordAxis", right) + number("UpAxis", up) + number("FrontAxis", front) +
               number("FrontAxisSign", frontSign);
    };
    QTest::newRow("Y up") << axes(0, 1, 2, 1) << QList<int>{1, 2, 3};
    QTest::newRow("Z up") << axes(0, 2, 1, -1) << QList<int>{1, 3, -2};
    QTest::newRow("Z up, front not told") << number("UpAxis", 2) << QList<int>{1, 3, -2};
    QTest::newRow("X up") << axes(1, 0, 2, -1) << QList<int>{2, 1, -3};
    QTest::newRow("left-handed") << axes(0, 1, 2, -1) << QList<int>{1, 2, -3};
    QTest::newRow("no axes") << axes(7, -3, 7, 1) << QList<int>{1, 2, 3};
}

void TestForeignScenes::fbx_axesAndUnitAreItsOwn()
{
    QFETCH(QByteArray, settings);
    QFETCH(QList<int>, place);
    const QByteArray far = vector("Lcl Scaling", {0.1, 0.2, 0.3});
    const core::TriangleMesh mesh = readFbx(fbx({{far}}, settings)).mesh;
    QVERIFY(std::abs(volumeOf(mesh) - 6000) < 1);
    const Box box = boxOf(mesh);
    for (int axis = 0; axis < 3; ++axis)
        QVERIFY(std::abs((place[axis] < 0 ? box.min : box.max)[axis] - 10 * place[axis]) < tolerance);
}

/// Tests a comb, whose teeth a fan of triangles would cover twice.
void TestForeignScenes::fbx_polygonsAreFilledExactly()
{
    constexpr int teeth = 16;
    QList<QPointF> outline{{0, 0}, {2.0 * teeth, 0}};
    for (int i = teeth - 1; i >= 0; --i)
        outline << QPointF(2 * i + 1.5, 3) << QPointF(2 * i + 0.5, 3) << QPointF(2 * i + 0.5, 1) << QPointF(2 * i, 1);
    QByteArrayList points, corners;
    double twice = 0;
    for (qsizetype i = 0; i < outline.size(); ++i) {
        const QPointF p = outline[i], next = outline[(i + 1) % outline.size()];
        twice += p.x() * next.y() - p.y() * next.x();
        points << QByteArray::number(p.x()) + "," + QByteArray::number(p.y()) + ",0";
        corners << QByteArray::number(i + 1 < outline.size() ? i : -i - 1);
    }
    const int count = static_cast<int>(outline.size());
    const ReadResult comb = readFbx(fbx({{}}, {}, meshOf(points.join(','), 3 * count, corners.join(','), count)));
    QCOMPARE(comb.mesh.triangles.size(), std::size_t(count - 2));
    QVERIFY(std::abs(areaOf(comb.mesh) - twice / 2) < tolerance);
}

/// An unreadable mesh is omitted. It is the reason of the error if it is the only one, and is counted otherwise.
void TestForeignScenes::fbx_brokenMeshesAreTold()
{
    const auto layer = [](const char* values) {
        return QByteArray("GeometryVersion: 124\nLayerElementNormal: 0 {\nMappingInformationType: \"ByVertice\"\n"
                          "ReferenceInformationType: \"Direct\"\nNormals: *24 {\na: ") +
               values + QByteArray(",0").repeated(23) +
               "\n}\n}\nLayer: 0 {\nLayerElement: {\nType: \"LayerElementNormal\"\nTypedIndex: 0\n}\n}\n";
    };
    struct Fault
    {
        QByteArray sound, broken;
        const char* words;
    };
    for (const Fault& fault : {Fault{"3,2,1,-1,4", "3,2,99,-1,4", "polygon vertex index out of range"},
                               {"3,2,1,-1,4", "3,2,1.5,-1,4", "failed to parse"},
                               {"GeometryVersion: 124\n", layer("snan"), "Cannot parse string"},
                               {"GeometryVersion: 124\n", layer("1e"), "cannot be converted into a value"},
                               {"Vertices: *24", "Points: *24", "broken"}}) {
        const auto alone = errorOf(QStringLiteral("a.fbx"), fbx({{}}, {}, cube().replace(fault.sound, fault.broken)));
        QVERIFY2(alone && alone->kind == core::FileErrorKind::ReaderRefused, fault.words);
        QVERIFY2(QByteArray::fromStdString(alone->token).contains(fault.words), alone->token.c_str());
        QByteArray two = fbx({{}, {}});
        two.replace(two.indexOf(fault.sound), fault.sound.size(), fault.broken);
        const ReadResult rest = read(QStringLiteral("a.fbx"), two);
        QCOMPARE(rest.mesh.triangles.size(), std::size_t(12));
        QCOMPARE(rest.remarks.unreadNodes, std::size_t(1));
    }
    QByteArray shared = fbx({{}, {vector("Lcl Translation", {20, 0, 0})}}); // one model has both meshes
    shared.replace("C: \"OO\",1001,2001", "C: \"OO\",1001,2000");
    QCOMPARE(readFbx(shared).mesh.triangles.size(), std::size_t(24));
    QCOMPARE(readFbx(shared).remarks.unreadNodes, std::size_t(0));
    for (const qsizetype at : {shared.indexOf("3,2,1,-1,4"), shared.lastIndexOf("3,2,1,-1,4")}) {
        const ReadResult rest = readFbx(QByteArray(shared).replace(at, 10, "3,2,99,-1,4"));
        QCOMPARE(rest.mesh.triangles.size(), std::size_t(12));
        QCOMPARE(rest.remarks.unreadNodes, std::size_t(1));
    }
    const QByteArray none = meshOf("0,0,0", 3, "", 0);
    QVERIFY(errorOf(QStringLiteral("a.fbx"), fbx({{}}, {}, none))->kind == core::FileErrorKind::NoFaces);
    QCOMPARE(read(QStringLiteral("a.fbx"), fbx({{}, {}})).remarks.unreadNodes, std::size_t(0));
    // A blend shape without normals is not a missing surface.
    const QByteArray shape = "Geometry: 3000, \"Geometry::s\", \"Shape\" {\nIndexes: *1 {\na: 0\n}\nVertices: *3 {\n"
                             "a: 1,1,1\n}\n}\n}\nConnections:  {\nC: \"OO\",3000,2000\n";
    QCOMPARE(read(QStringLiteral("a.fbx"), fbx({{}, {}}).replace("}\nConnections:  {\n", shape)).remarks.unreadNodes,
             std::size_t(0));
    const auto huge = errorOf(QStringLiteral("a.fbx"), fbx({{}}, {}, cube().replace("*24", "*4000000000")));
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    // sanitizers end the process, because they allow no memory limit
    QVERIFY(huge && huge->kind == core::FileErrorKind::ReaderDied);
#else
    QVERIFY(huge && huge->kind == core::FileErrorKind::ReaderOutOfMemory);
#endif
}

/// Polygons of one or two corners are counted and omitted, whether the mesh has other polygons or not. Curves are not
/// counted.
void TestForeignScenes::fbx_polygonsOfFewerCornersAreCounted()
{
    const ReadResult within = readFbx(fbx({{}}, {}, cube().replace("*24 {\na: 3,2,1", "*27 {\na: -1,0,-2,3,2,1")));
    QCOMPARE(within.mesh.triangles.size(), std::size_t(12));
    QCOMPARE(within.remarks.facesOfFewer, std::size_t(2));
    for (const auto& [corners, count] : {std::pair("-1,-2,-3", 3), {"0,-2,1,-3", 2}}) {
        QByteArray beside = fbx({{}, {}});
        const qsizetype at = beside.lastIndexOf("PolygonVertexIndex: *24 {\na: ");
        const qsizetype end = beside.indexOf("\n}", at);
        beside.replace(at, end - at,
                       QByteArray("PolygonVertexIndex: *") + QByteArray::number(1 + QByteArray(corners).count(',')) +
                           " {\na: " + corners);
        const ReadResult result = readFbx(beside);
        QCOMPARE(result.mesh.triangles.size(), std::size_t(12));
        QCOMPARE(result.remarks.facesOfFewer, std::size_t(count));
        QCOMPARE(result.remarks.unreadNodes, std::size_t(0));
    }
    QByteArray line = fbx({{}, {}});
    const qsizetype at = line.lastIndexOf("Geometry: 1001");
    line.replace(at, line.indexOf("Model: 2001") - at,
                 "Geometry: 1001, \"Geometry::l\", \"Line\" {\nPoints: *6 {\na: 0,0,0,9,9,9\n}\nPointsIndex: *2 {\na: "
                 "0,-2\n}\n}\n");
    QVERIFY(readFbx(line).remarks == core::ReadRemarks());
}

void TestForeignScenes::fbx_numbersAreFinite_data()
{
    QTest::addColumn<QByteArray>("properties");
    QTest::addColumn<QByteArray>("word");
    const auto row = [](const QByteArray& property, const char* word) {
        QTest::newRow(property.trimmed().constData()) << property << QByteArray(word);
    };
    for (const char* word : {"nan", "-inf", "1.#QNAN", "abc", "\"1\""}) {
        row(QByteArray(R"(P: "Lcl Translation", "Lcl Translation", "", "A",1,%,0)").replace('%', word) + "\n", word);
        row(QByteArray(R"(P: "GeometricRotation", "Vector3D", "", "A",0,0,%)").replace('%', word) + "\n", word);
        row(QByteArray(R"(P: "RotationOrder", "enum", "", "A",%)").replace('%', word) + "\n", word);
    }
}

void TestForeignScenes::fbx_numbersAreFinite()
{
    QFETCH(QByteArray, properties);
    QFETCH(QByteArray, word);
    const QByteArray bytes = fbx({{properties}});
    const auto error = errorOf(QStringLiteral("a.fbx"), bytes);
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->kind), static_cast<int>(core::FileErrorKind::NotANumber));
    QCOMPARE(error->token, word.replace("\"", "").toStdString());
    QCOMPARE(error->place.number, std::uint64_t(1 + bytes.first(bytes.indexOf(properties)).count('\n')));
    for (const char* unit : {"-1", "-0.5"}) {
        const auto none = errorOf(QStringLiteral("a.fbx"),
                                  fbx({{}}, R"(P: "UnitScaleFactor", "double", "Number", "",)" + QByteArray(unit)));
        QVERIFY(none && none->kind == core::FileErrorKind::ReaderRefused);
        QCOMPARE(none->token, std::string("UnitScaleFactor is no positive number"));
    }
}

/// Numbers of points, corners and settings must be valid. Normals are ignored.
void TestForeignScenes::fbx_wordsAreNumbers()
{
    const auto wordOf = [this](const QByteArray& bytes) {
        const auto error = errorOf(QStringLiteral("a.fbx"), bytes);
        return error && error->kind == core::FileErrorKind::NotANumber ? error->token : std::string();
    };
    for (const char* word :
         {"1.#INF", "-1.#IND", "1.#QNAN", "1.2.3", "0x10", "1d5", "12abc", "1e", "1e400", "nan", "snan", "-", "--5"}) {
        const QByteArray points =
            fbx({{}, {}}, {}, cube().replace("0,0,0,10,0,0", "0,0," + QByteArray(word) + ",10,0,0"));
        QCOMPARE(wordOf(points), std::string(word));
        QCOMPARE(errorOf(QStringLiteral("a.fbx"), points)->place.number,
                 std::uint64_t(1 + points.first(points.indexOf("a: ")).count('\n')));
        QCOMPARE(wordOf(fbx({{}}, {}, cube().replace("3,2,1,-1,4", "3,2," + QByteArray(word) + ",-1,4"))),
                 std::string(word));
        for (const char* setting : {"UnitScaleFactor", "UpAxis"}) {
            const QByteArray start = QByteArray("P: \"") + setting + R"(", "double", "Number", "",)";
            QCOMPARE(wordOf(fbx({{}}, start + word)), std::string(word));
        }
    }
    for (const char* word : {"+0", "0.", ".0", "-0.0E+00", "1e-400"})
        COMPARE_VECTORS(
            boxOf(readFbx(fbx({{}}, {}, cube().replace("0,0,0,10,0,0", "0,0," + QByteArray(word) + ",10,0,0"))).mesh)
                .size(),
            10, 10, 10);
    const QByteArray normals = cube() + "Normals: *3 {\na: 0,0,-1.#IND\n}\n";
    COMPARE_VECTORS(boxOf(readFbx(fbx({{}}, {}, normals)).mesh).size(), 10, 10, 10);
}

void TestForeignScenes::fbx_oldVersionsAreRefusedByName()
{
    QByteArray old = fbx({{}});
    old.replace("FBXVersion: 7400", "FBXVersion: 6100");
    const auto text = errorOf(QStringLiteral("old.fbx"), old);
    QVERIFY(text && text->fault == core::FileFault::OldFbx && text->token == "6.1");
    const QByteArray header("Kaydara FBX Binary  \0\x1a\0\x88\x13\0\0", 27); // header of a binary file of version 5000
    const auto binary = errorOf(QStringLiteral("old.fbx"), header + QByteArray(100, '\0'));
    QVERIFY(binary && binary->fault == core::FileFault::OldFbx && binary->token == "5.0");
}

/// A project of IFC 4 may have no history, which Assimp requires.
void TestForeignScenes::ifc_otherSchemasAreRefusedByName()
{
    const auto error = [&](const char* schema) {
        const QByteArray text =
            QByteArray("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),"
                       "(''),'','','');\nFILE_SCHEMA(('") +
            schema +
            "'));\nENDSEC;\nDATA;\n#1=IFCPROJECT('x',$,'p',$,$,$,$,$,$);\nENDSEC;\n"
            "END-ISO-10303-21;\n";
        return errorOf(QStringLiteral("a.ifc"), text);
    };
    const auto other = error("IFC4");
    QVERIFY(other && other->fault == core::FileFault::OtherIfc && other->token == "IFC4");
    const auto same = error("IFC2X3");
    QVERIFY(same && same->kind == core::FileErrorKind::ReaderRefused);
}

void TestForeignScenes::fbx_subdivisionsAndNurbsAreTold()
{
    QCOMPARE(readFbx(fbx({{}, {}}, {}, cube() + "Smoothness: 3\nPreviewDivisionLevels: 1\n")).remarks.subdivisions,
             std::size_t(2));
    const QByteArray nurbs = "}\nGeometry: 1, \"Geometry::n\", \"NurbsSurface\" {\nNurbsSurfaceOrder: 4,4\n";
    QCOMPARE(readFbx(fbx({{}}, {}, cube() + nurbs)).remarks.unreadNodes, std::size_t(1));
    const core::ReadRemarks plain = readFbx(fbx({{}}, {}, cube() + "Smoothness: 0\n")).remarks;
    QVERIFY(plain == core::ReadRemarks());
}

void TestForeignScenes::x3d_usesAreThere()
{
    const ReadResult row =
        read(QStringLiteral("use.x3d"),
             "<X3D><Scene><Transform/><Transform DEF='Key'><Shape><Box size='1 2 3'/></Shape></Transform>"
             "<Transform translation='3 0 0'><Transform USE='Key'/></Transform>"
             "<Transform translation='6 0 0'><Transform USE='Key'/></Transform></Scene></X3D>");
    COMPARE_VECTORS(boxOf(row.mesh).size(), 7000, 2000, 3000);
    QCOMPARE(row.remarks.objects, std::size_t(3));
    QCOMPARE(row.mesh.triangles.size(), std::size_t(36));
    QVERIFY(std::abs(volumeOf(row.mesh) / 18e9 - 1) < 1e-6);
}

void TestForeignScenes::x3d_solidsAreClosed_data()
{
    QTest::addColumn<QByteArray>("node");
    QTest::addColumn<double>("volume"); // volume in cubic metres
    // half the perimeter of a polygon of 32 sides inscribed in a circle of radius 1
    const double ring = 16 * std::sin(std::numbers::pi / 16);
    QTest::newRow("cone") << QByteArray("<Cone height='3'/>") << ring;
    QTest::newRow("cylinder") << QByteArray("<Cylinder radius='2' height='0.5'/>") << 2 * ring;
    QTest::newRow("box") << QByteArray("<Box/>") << 8.0;
    const QByteArray square = " crossSection='1 1 1 -1 -1 -1 -1 1 1 1' ";
    QTest::newRow("extrusion") << "<Extrusion" + square + "/>" << 4.0;
    QTest::newRow("tapered") << "<Extrusion" + square + "spine='0 0 0 0 3 0' scale='1 1 0 0'/>" << 4.0;
    QTest::newRow("turned") << "<Extrusion" + square + "orientation='0 1 0 1'/>" << 4.0;
    QTest::newRow("lying") << "<Extrusion" + square + "spine='0 0 0 -5 0 0'/>" << 20.0;
    QTest::newRow("bent") << "<Extrusion" + square + "spine='0 0 0 0 5 0 5 5 0'/>" << 20 * (1 + std::sqrt(0.5));
    QTest::newRow("ring") << "<Extrusion" + square + "spine='5 0 5 5 0 -5 -5 0 -5 -5 0 5 5 0 5'/>"
                          << 4 * 40 * std::sqrt(0.5);
    const QByteArray clockwise = " crossSection='1 1 -1 1 -1 -1 1 -1 1 1' ";
    QTest::newRow("clockwise") << "<Extrusion ccw='false'" + clockwise + "/>" << 4.0;
    QTest::newRow("clockwise faces") << QByteArray(
                                            "<IndexedFaceSet ccw='false' coordIndex='0 1 2 -1 0 3 1 -1 1 3 2 -1 2 3 0'>"
                                            "<Coordinate point='0 0 0, 1 0 0, 0 1 0, 0 0 1'/></IndexedFaceSet>")
                                     << 1 / 6.0;
}

void TestForeignScenes::x3d_solidsAreClosed()
{
    QFETCH(QByteArray, node);
    QFETCH(double, volume);
    const core::TriangleMesh mesh =
        read(QStringLiteral("solid.x3d"), "<X3D><Scene><Shape>" + node + "</Shape></Scene></X3D>").mesh;
    std::map<std::pair<core::Slot, core::Slot>, int> edges;
    for (const core::Triangle& t : mesh.triangles)
        for (int i = 0; i < 3; ++i)
            ++edges[{t[i], t[(i + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
        QCOMPARE(count, 1);
        QVERIFY(edges.contains({edge.second, edge.first}));
    }
    QVERIFY2(std::abs(volumeOf(mesh) / 1e9 / volume - 1) < 1e-5, qPrintable(QString::number(volumeOf(mesh) / 1e9)));
}

void TestForeignScenes::x3d_inlinedFilesAreExpandedToo()
{
    write(QStringLiteral("part.x3d"), "<X3D><Scene><Transform DEF='T' translation='5 0 0'><Shape><Box/></Shape>"
                                      "</Transform><Group><Transform USE='T'/></Group></Scene></X3D>");
    const ReadResult whole =
        read(QStringLiteral("whole.x3d"), "<X3D><Scene><Inline url='\"part.x3d\"'/></Scene></X3D>");
    QCOMPARE(whole.mesh.triangles.size(), std::size_t(24));
    const ReadResult second =
        read(QStringLiteral("whole.x3d"), "<X3D><Scene><Inline url='\"none.x3d\" \"part.x3d\"'/></Scene></X3D>");
    QCOMPARE(second.mesh.triangles.size(), std::size_t(24));
    QCOMPARE(second.remarks.unreadNodes, std::size_t(0));
    const ReadResult missing =
        read(QStringLiteral("whole.x3d"),
             "<X3D><Scene><Shape><Box/></Shape><Inline url='\"none.x3d\" \"http://a.b/part.x3d\"'/></Scene></X3D>");
    QCOMPARE(missing.mesh.triangles.size(), std::size_t(12));
    QCOMPARE(missing.remarks.unreadNodes, std::size_t(1));
    QVERIFY(QDir(m_dir.path()).mkpath(QStringLiteral("scene")));
    const auto outside =
        errorOf(QStringLiteral("scene/a.x3d"), "<X3D><Scene><Inline url='\"../part.x3d\"'/></Scene></X3D>");
    QVERIFY(outside && outside->kind == core::FileErrorKind::OutsideFolder && outside->token == "part.x3d");
    const auto endless = errorOf(QStringLiteral("self.x3d"), "<X3D><Scene><Inline url='\"self.x3d\"'/></Scene></X3D>");
    QVERIFY(endless && endless->fault == core::FileFault::TooDeep && endless->token == "Inline nodes");
    write(QStringLiteral("back.x3d"), "<X3D><Scene><Shape><Box/></Shape><Inline url='./there.x3d'/></Scene></X3D>");
    const auto round =
        errorOf(QStringLiteral("there.x3d"), "<X3D><Scene><Inline url='scene/../back.x3d'/></Scene></X3D>");
    QVERIFY(round && round->fault == core::FileFault::TooDeep && round->token == "Inline nodes");
    QCOMPARE(round->path, file(QStringLiteral("back.x3d")));
}

/// A chain of files makes 2^9 boxes without any cycle.
void TestForeignScenes::x3d_manyInlinesAreNoCycle()
{
    const auto chain = [this](int length) {
        write(QStringLiteral("chain0.x3d"), "<X3D><Scene><Shape><Box/></Shape></Scene></X3D>");
        QByteArray text;
        for (int i = 1; i <= length; ++i) {
            const QByteArray one = "<Inline url='chain" + QByteArray::number(i - 1) + ".x3d'/>";
            text = "<X3D><Scene>" + one + "<Transform translation='1 1 1'>" + one + "</Transform></Scene></X3D>";
            write(QStringLiteral("chain%1.x3d").arg(i), text);
        }
        return errorOf(QStringLiteral("outermost.x3d"), text);
    };
    QVERIFY(!chain(6));
    const auto many = chain(9);
    QVERIFY(many);
    QCOMPARE(static_cast<int>(many->kind), static_cast<int>(core::FileErrorKind::TooManyElements));
    QCOMPARE(many->token, std::string("Inline nodes"));
    QCOMPARE(many->expected, std::uint64_t(256));
    QCOMPARE(many->path, file(QStringLiteral("outermost.x3d")));
}

void TestForeignScenes::x3d_inlinesAreFoundByUrl()
{
    QVERIFY(QDir(m_dir.path()).mkpath(QStringLiteral("a b")));
    const QByteArray box = "<X3D><Scene><Shape><Box/></Shape></Scene></X3D>";
    for (const char* name : {"a b/ü c.x3d", "a b/50%.x3d", "a b/#1.x3d"})
        write(QString::fromUtf8(name), box);
    for (const char* url : {"a b/ü c.x3d", "a%20b/%C3%BC%20c.x3d", "a b/ü c.x3d#view", "a%20b/%c3%bc c.x3d#a#b",
                            "a b/50%.x3d", "a b/50%25.x3d", "a b/#1.x3d", "a b/%231.x3d#top"}) {
        const ReadResult result = read(QStringLiteral("whole.x3d"), "<X3D><Scene><Shape><Box/></Shape><Inline url='\"" +
                                                                        QByteArray(url) + "\"'/></Scene></X3D>");
        QVERIFY2(result.mesh.triangles.size() == 24 && result.remarks.unreadNodes == 0, url);
    }
    for (const char* url : {"a%20b", "a%20b/none.x3d", "%00.x3d", "a%0Ab.x3d", "#", "%", ""})
        QCOMPARE(read(QStringLiteral("whole.x3d"), "<X3D><Scene><Shape><Box/></Shape><Inline url='\"" +
                                                       QByteArray(url) + "\" \"no.x3d\"'/></Scene></X3D>")
                     .remarks.unreadNodes,
                 std::size_t(1));
    const auto outside =
        errorOf(QStringLiteral("a b/a.x3d"), "<X3D><Scene><Inline url='%2e%2e/whole.x3d'/></Scene></X3D>");
    QVERIFY(outside && outside->kind == core::FileErrorKind::OutsideFolder && outside->token == "whole.x3d");
}

/// An error names the file that contains it.
void TestForeignScenes::x3d_brokenFilesAreNamed()
{
    QVERIFY(QDir(m_dir.path()).mkpath(QStringLiteral("parts")));
    write(QStringLiteral("parts/broken.x3d"), "<X3D>\n<Scene>\n<Shape></Scene></X3D>");
    const auto inner = errorOf(QStringLiteral("whole.x3d"),
                               "<X3D><Scene><Shape><Box/></Shape><Inline url='parts/broken.x3d'/></Scene></X3D>");
    QVERIFY(inner && inner->fault == core::FileFault::XmlSyntax);
    QCOMPARE(inner->path, file(QStringLiteral("parts/broken.x3d")));
    QCOMPARE(inner->place.number, std::uint64_t(3));
    const auto own = errorOf(QStringLiteral("whole.x3d"), "<X3D><Scene><Shape></Scene></X3D>");
    QVERIFY(own);
    QCOMPARE(own->path, file(QStringLiteral("whole.x3d")));
}

/// A box of 10 mm is 2 inches from the origin, rotated by 90 degrees. A box of one inch is rotated by an angle in
/// radians.
void TestForeignScenes::x3d_unitsAreEachFilesOwn()
{
    write(QStringLiteral("mm.x3d"),
          "<X3D><head><unit category='length' name='mm' conversionFactor='0.001'/></head>"
          "<Scene><Transform rotation='0 0 1 1.5707963267948966'><Shape><Box size='10 20 30'/>"
          "</Shape></Transform></Scene></X3D>");
    const ReadResult whole =
        read(QStringLiteral("whole.x3d"),
             "<X3D><head><unit category='length' name='inch' conversionFactor='0.0254'/>"
             "<unit category='angle' name='degree' conversionFactor='0.017453292519943295'/></head><Scene>"
             "<Transform rotation='0 0 2 90'><Transform translation='2 0 0'><Inline url='mm.x3d'/></Transform>"
             "<Shape><Box size='1 2 3'/></Shape></Transform></Scene></X3D>");
    COMPARE_VECTORS(boxOf(whole.mesh).min, -25.4, -12.7, -38.1);
    COMPARE_VECTORS(boxOf(whole.mesh).max, 25.4, 50.8 + 10, 38.1);
    QVERIFY(std::abs(volumeOf(whole.mesh) - 6000 - 6 * std::pow(25.4, 3)) < 0.1);
}

void TestForeignScenes::x3d_inlinedFilesKeepTheirNames_data()
{
    QTest::addColumn<QByteArray>("scene");
    const QByteArray part = "<Transform translation='10 0 0'><Inline url='part.x3d'/></Transform>",
                     nested = "<Transform translation='10 0 0'><Inline url='around.x3d'/></Transform>",
                     own = "<Shape DEF='A'>%</Shape><Transform translation='20 0 0'><Shape USE='A'/></Transform>";
    for (const auto& [name, inlined] : {std::pair("", part), std::pair("nested, ", nested)}) {
        QTest::addRow("%sbefore", name) << inlined + own;
        QTest::addRow("%sbehind", name) << own + inlined;
        QTest::addRow("%sbetween", name) << QByteArray(own).replace("</Shape>", "</Shape>" + inlined);
    }
}

/// The inlined file has two boxes of side 1, the main file two of side 2. Each USE must refer to its own file.
void TestForeignScenes::x3d_inlinedFilesKeepTheirNames()
{
    QFETCH(QByteArray, scene);
    const QByteArray partScene =
        "<X3D><Scene><Shape DEF='A'>%</Shape><Transform translation='0 5 0'><Shape USE='A'/></Transform></Scene></X3D>";
    const auto tetrahedron = [](double size) {
        const QByteArray s = " " + QByteArray::number(size) + " ";
        return "<IndexedFaceSet coordIndex='0 2 1 -1 0 1 3 -1 1 2 3 -1 0 3 2 -1'><Coordinate point='0 0 0" + s +
               "0 0 0" + s + "0 0 0" + s + "'/></IndexedFaceSet>";
    };
    const QByteArray box[] = {"<Box size='1 1 1'/>", "<Box size='2 2 2'/>"};
    const QByteArray solid[] = {tetrahedron(1), tetrahedron(2)};
    for (const auto& [shapes, cube] : {std::pair(box, 1.0), std::pair(solid, 1 / 6.0)}) {
        write(QStringLiteral("part.x3d"), QByteArray(partScene).replace("%", shapes[0]));
        write(QStringLiteral("around.x3d"), "<X3D><Scene><Inline url='part.x3d'/></Scene></X3D>");
        const ReadResult whole = read(QStringLiteral("whole.x3d"),
                                      "<X3D><Scene>" + QByteArray(scene).replace("%", shapes[1]) + "</Scene></X3D>");
        QVERIFY(std::abs(volumeOf(whole.mesh) / (18e9 * cube) - 1) < 1e-5);
        QCOMPARE(whole.remarks.objects, std::size_t(4));
        const double end = shapes == box ? 21000 : 22000;
        QVERIFY(std::abs(boxOf(whole.mesh).max.x() - end) < tolerance);
    }
    // Shared points are named per file, too.
    write(QStringLiteral("part.x3d"), QByteArray(partScene).replace("%", tetrahedron(1)));
    const QByteArray faces = "<Shape><IndexedFaceSet coordIndex='0 2 1 -1 0 1 3 -1 1 2 3 -1 0 3 2 -1'>";
    const ReadResult shared =
        read(QStringLiteral("whole.x3d"),
             "<X3D><Scene><Inline url='part.x3d'/>" + faces +
                 "<Coordinate DEF='C' point='0 0 0 2 0 0 0 2 0 0 0 2'/></IndexedFaceSet></Shape>" + faces +
                 "<Coordinate USE='C'/></IndexedFaceSet></Shape></Scene></X3D>");
    QVERIFY(std::abs(volumeOf(shared.mesh) * 6 / 18e9 - 1) < 1e-5);
}

void TestForeignScenes::x3d_badFilesAreRefused()
{
    const auto cycle =
        errorOf(QStringLiteral("cycle.x3d"), "<X3D><Scene>\n<Group DEF='G'><Group USE='G'/></Group></Scene></X3D>");
    QVERIFY(cycle && cycle->fault == core::FileFault::TooDeep && cycle->token == "nodes of USE=G");
    QCOMPARE(cycle->place.number, std::uint64_t(2));
    const auto none = errorOf(QStringLiteral("none.x3d"), "<X3D><Scene><Group/></Scene></X3D>");
    QVERIFY(none && none->kind == core::FileErrorKind::NoFaces);
    QCOMPARE(read(QStringLiteral("text.x3d"),
                  "<X3D><Scene><Shape><Box/></Shape><Shape><Text string='a'/></Shape></Scene></X3D>")
                 .remarks.unreadNodes,
             std::size_t(1));
}

void TestForeignScenes::x3d_otherEncodingsAreRefused()
{
    for (const char* name : {"a.x3db", "a.x3dv", "a.wrl"}) {
        const auto error = errorOf(QString::fromLatin1(name), "#X3D V3.0 utf8\nShape { geometry Box { } }\n");
        QVERIFY2(error && error->kind == core::FileErrorKind::UnknownFormat && error->token == name + 2, name);
    }
}

void TestForeignScenes::dae_brokenRulesAreTold_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<core::FileErrorKind>("kind");
    QTest::addColumn<core::FileFault>("fault");
    QTest::addColumn<quint64>("line");
    QTest::addColumn<QByteArray>("token");
    using Kind = core::FileErrorKind;
    using Fault = core::FileFault;
    const QByteArray values = "0 0 0 1 0 0 0 1 0 0 0 1", indices = "<p>0 2 1 0 1 3 1 2 3 2 0 3</p>";
    const auto row = [](const char* name, const QByteArray& bytes, Fault fault, quint64 line, const QByteArray& token,
                        Kind kind = Kind::Malformed) {
        QTest::newRow(name) << bytes << kind << fault << line << token;
    };
    row("skew", dae({{"<node id=\"n\">", "<node id=\"n\"><skew>45 0 1 0 1 0 0</skew>"}}), Fault::NotRead, 13, "skew");
    for (const char* metres : {"0", "-1", "nan", "one"})
        row(metres, dae({{"meter=\"1\"", "meter=\"" + QByteArray(metres) + "\""}}), Fault::PositiveNumber, 3, metres);
    row("a mesh of another file", dae({{"url=\"#g\"", "url=\"b.dae#g\""}}), Fault::NotRead, 13, "b.dae#g");
    row("a node of another file", dae({{"<node id=\"n\">", "<node id=\"n\"><instance_node url=\"b.dae#g\"/>"}}),
        Fault::NotRead, 13, "b.dae#g");
    row("no values", dae({{values, ""}}), Fault::BeyondItsData, 6, "float_array a");
    row("a value too few", dae({{values, "0 0 0 1 0 0 0 1 0 0 0"}}), Fault::BeyondItsData, 6, "float_array a");
    row("a huge stride", dae({{"stride=\"3\"", "stride=\"4000000000\""}}), Fault::BeyondItsData, 6, "float_array a");
    row("a stride too large for 32 bits", dae({{"stride=\"3\"", "stride=\"9999999999\""}}), Fault::None, 6,
        "9999999999", Kind::NotANumber);
    row("no stride", dae({{" stride=\"3\"", ""}}), Fault::Missing, 6, "stride");
    row("a huge offset", dae({{"stride=", "offset=\"4000000000\" stride="}}), Fault::BeyondItsData, 6, "float_array a");
    row("a huge count", dae({{"count=\"4\" stride", "count=\"4000000000\" stride"}}), Fault::BeyondItsData, 6,
        "float_array a");
    row("no indices", dae({{indices, ""}}), Fault::Missing, 10, "p");
    row("no count", dae({{"<triangles count=\"4\">", "<triangles>"}}), Fault::Missing, 9, "count");
    row("a negative index", dae({{"2 0 3</p>", "2 0 -1</p>"}}), Fault::VertexIndex, 10, "-1");
    const QByteArray many = "<vcount>3 3 3 3</vcount>";
    row("polygons without their sizes", dae({{"triangles", "polylist"}}), Fault::Missing, 10, "vcount");
    row("polygons before their sizes", dae({{"triangles", "polylist"}, {indices, indices + many}}), Fault::Missing, 10,
        "vcount");
    row("fewer polygons than announced", dae({{"triangles", "polygons"}, {indices, "<p>0 2 1</p><p>0 1 3</p>"}}),
        Fault::None, 10, "", Kind::CountMismatch);
    row("fewer triangles than announced", dae({{"2 0 3</p>", "2 0</p>"}}), Fault::None, 10, "", Kind::CountMismatch);
    row("far fewer", dae({{"triangles count=\"4\"", "triangles count=\"4294967295\""}}), Fault::None, 10, "",
        Kind::CountMismatch);
    row("a huge place of an index", dae({{"offset=\"0\"", "offset=\"4294967295\""}}), Fault::None, 10, "",
        Kind::CountMismatch);
    row("no triangles announced", dae({{"triangles count=\"4\"", "triangles count=\"0\""}}), Fault::None, 10, "",
        Kind::CountMismatch);
    row("a word among the indices", dae({{"2 0 3</p>", "2 zero 3</p>"}}), Fault::WholeNumber, 10, "zero");
    row("a fraction among the indices", dae({{"2 0 3</p>", "2 0.5 3</p>"}}), Fault::WholeNumber, 10, "0.5");
    row("a word among the sizes", dae({{"triangles", "polylist"}, {"<p>", "<vcount>3 3 x 3</vcount><p>"}}),
        Fault::WholeNumber, 10, "x");
    row("a node in itself", dae({{"<node id=\"n\">", "<node id=\"n\"><instance_node url=\"#n\"/>"}}), Fault::TooDeep,
        13, "nodes below n");
    row("a word among the values", dae({{values, "0 0 0 1 x 0 0 1 0 0 0 1"}}), Fault::None, 5, "x", Kind::NotANumber);
    row("broken XML", dae({{"</mesh>", ""}}), Fault::XmlSyntax, 11, "mismatched tag");
    row("cut off", dae().left(600), Fault::XmlSyntax, 10, "no element found");
}

/// Refuses COLLADA at which Assimp's process would end, or whose surface would be another one.
void TestForeignScenes::dae_brokenRulesAreTold()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QByteArray, token);
    const auto error = errorOf(QStringLiteral("a.dae"), bytes);
    QVERIFY(error);
    QTEST(error->kind, "kind");
    QTEST(error->fault, "fault");
    QTEST(quint64(error->place.number), "line");
    QCOMPARE(error->token, token.toStdString());
}

void TestForeignScenes::dae_unitsMayHaveACommaOrBeMissing()
{
    for (const auto& [unit, side] : {std::pair(" meter=\"0.01\"", 10), {" meter=\"0,01\"", 10}, {"", 1000}})
        COMPARE_VECTORS(boxOf(read(QStringLiteral("a.dae"), dae({{" meter=\"1\"", unit}})).mesh).size(), side, side,
                        side);
}

/// Instances of what is missing are counted.
void TestForeignScenes::dae_missingInstancesAreTold()
{
    QCOMPARE(read(QStringLiteral("a.dae"), dae()).remarks.unreadNodes, std::size_t(0));
    for (const char* const kind : {"geometry", "controller", "node"}) {
        const QByteArray gone = "<node><instance_" + QByteArray(kind) + " url=\"#gone\"/></node>";
        const ReadResult result = read(QStringLiteral("a.dae"), dae({{"</visual_scene>", gone + "</visual_scene>"}}));
        QVERIFY2(result.remarks.unreadNodes == 1 && result.mesh.triangles.size() == 4, kind);
    }
}

/// The faults of a COLLADA file in a package are told with its name; a damaged package is incomplete.
void TestForeignScenes::zae_brokenRulesAreTold()
{
    const auto package = [this](const QByteArray& text) {
        core::AtomicFile out(file(QStringLiteral("p.zae")));
        core::io::ZipWriter zip;
        zip.add("in/a.dae", std::string_view(text.constData(), static_cast<std::size_t>(text.size())),
                core::io::ZipWriter::Packing::Deflated);
        zip.writeTo(out);
        out.commit();
        QFile made(m_dir.filePath(QStringLiteral("p.zae")));
        return made.open(QIODevice::ReadOnly) ? made.readAll() : QByteArray();
    };
    const auto error = errorOf(QStringLiteral("a.zae"), package(dae({{"<node id=\"n\">", "<node id=\"n\"><skew/>"}})));
    QVERIFY(error && error->fault == core::FileFault::NotRead);
    QCOMPARE(error->place.number, std::uint64_t(13));
    QCOMPARE(error->path.filename().string(), std::string("a.dae"));
    const QByteArray whole = package(dae());
    const auto cut = errorOf(QStringLiteral("a.zae"), whole.chopped(30));
    QVERIFY(cut && cut->kind == core::FileErrorKind::CutOff);
}

/// Reads COLLADA that breaks rules, as other programs do.
void TestForeignScenes::dae_harmlessOdditiesAreRead()
{
    const auto triangles = [this](const QByteArray& bytes) {
        return read(QStringLiteral("a.dae"), bytes).mesh.triangles.size();
    };
    QCOMPARE(triangles(dae()), std::size_t(4));
    QCOMPARE(triangles(dae({{"</mesh>", "<triangles count=\"0\"/></mesh>"}})), std::size_t(4));
    QCOMPARE(triangles(dae({{"0 0 1</float_array>", "0 0 1 7 7</float_array>"}})), std::size_t(4));
    QCOMPARE(triangles("<?xml version=\"1.0\"?><!DOCTYPE COLLADA>" + dae().mid(21)), std::size_t(4));
    QCOMPARE(triangles(dae({{"</visual_scene>", "<extra><param/><param/></extra></visual_scene>"}})), std::size_t(4));
    const QByteArray deep = QByteArray("<node>").repeated(200) + "<node id=\"n\">";
    QCOMPARE(triangles(dae({{"<node id=\"n\">", deep}, {"</node>", QByteArray("</node>").repeated(201)}})),
             std::size_t(4));
    // Assimp shows a scene without meshes as a skeleton, which is no model.
    QCOMPARE(errorOf(QStringLiteral("a.dae"), dae({{"url=\"#g\"", "url=\"#h\""}}))->kind, core::FileErrorKind::NoFaces);
}

void TestForeignScenes::brokenFiles_areToldWithTheirPlace_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<quint64>("line");
    QTest::addColumn<QByteArray>("token");
    QTest::newRow("AC3D") << QStringLiteral("a.ac") << QByteArray("AC3Db\nOBJECT poly\nnumvert 2\n0 0 0\n0 abc 0\n")
                          << quint64(5) << QByteArray("abc");
    QTest::newRow("NFF") << QStringLiteral("a.nff") << QByteArray("p 3\n0 0 0\n1 zero 0\n0 1 0\n") << quint64(3)
                         << QByteArray("zero");
    QTest::newRow("CR LF") << QStringLiteral("a.nff") << QByteArray("p 3\r\n0 0 0\r\n1 zero 0\r\n0 1 0\r\n")
                           << quint64(3) << QByteArray("zero");
    QTest::newRow("one of two places") << QStringLiteral("a.nff") << QByteArray("# zero 0\np 3\n1 zero 0\n")
                                       << quint64(0) << QByteArray("zero");
    QTest::newRow("XGL") << QStringLiteral("a.xgl") << QByteArray("<WORLD>\n<MESH>\n</WORLD>\n") << quint64(3)
                         << QByteArray("mismatched tag");
    QTest::newRow("IRRMESH") << QStringLiteral("a.irrmesh") << QByteArray("<mesh>\n<buffer") << quint64(2)
                             << QByteArray("unclosed token");
}

void TestForeignScenes::brokenFiles_areToldWithTheirPlace()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(QByteArray, token);
    const auto error = errorOf(name, bytes);
    QVERIFY(error);
    QCOMPARE(error->token, token.toStdString());
    QTEST(quint64(error->place.number), "line");
    QVERIFY(error->kind == core::FileErrorKind::NotANumber || error->fault == core::FileFault::XmlSyntax);
}

/// A COLLADA tetrahedron with a wrong or missing count, with leading spaces in values, and with images that name no
/// file.
void TestForeignScenes::dae_isReadInUtf16AndWithBlanks()
{
    const QString text = QStringLiteral(
        "<?xml version=\"1.0\" encoding=\"%1\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
        "version=\"1.4.1\"><asset><unit meter=\"1\"/><up_axis>Y_UP</up_axis></asset><library_images>"
        "<image id=\"i\"><init_from/></image><image "
        "id=\"k\"><init_from>\n</init_from></image></library_images>"
        "<library_materials><material id=\"m\"><instance_effect url=\"#e\"/></material></library_materials>"
        "<library_effects><effect id=\"e\"><profile_COMMON><technique sid=\"t\"><phong><diffuse><texture "
        "texture=\"i\" texcoord=\"u\"/></diffuse></phong></technique></profile_COMMON></effect></library_effects>"
        "<library_geometries>"
        "<geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"a\"%2>\n  0 0 0 1 0 0 0 1 0 0 0 1\n"
        "</float_array><technique_common><accessor source=\"#a\" count=\"4\" stride=\"3\"><param name=\"X\" "
        "type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor>"
        "</technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
        "<triangles count=\"4\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p> 0 2 1 0 1 3 1 2 3 2 0 3</p>"
        "</triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\">"
        "<node id=\"n\"><matrix>  1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 </matrix><instance_geometry url=\"#g\"/></node>"
        "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>");
    for (const char* count : {" count=\"12\"", " count=\"3\"", " count = '99'", ""}) {
        const QString utf8 = text.arg(QStringLiteral("utf-8"), QLatin1StringView(count)),
                      utf16 = text.arg(QStringLiteral("utf-16"), QLatin1StringView(count));
        QStringEncoder little(QStringEncoder::Utf16LE, QStringConverter::Flag::WriteBom),
            big(QStringEncoder::Utf16BE, QStringConverter::Flag::WriteBom), bare(QStringEncoder::Utf16LE);
        const QByteArray encoded[] = {
            utf8.toUtf8(), "\xef\xbb\xbf" + utf8.toUtf8(), " \r\n\t" + utf8.toUtf8(), little(utf16), big(utf16),
            bare(utf16)};
        for (const QByteArray& bytes : encoded) {
            const ReadResult model = read(QStringLiteral("a.dae"), bytes);
            QCOMPARE(model.mesh.triangles.size(), std::size_t(4));
            QVERIFY(std::abs(volumeOf(model.mesh) * 6e-9 - 1) < 1e-6);
        }
    }
}

void TestForeignScenes::lws_isAsLargeAsItsLwo()
{
    const Box alone = boxOf(read(QStringLiteral("part.lwo"), lwo(2)).mesh);
    COMPARE_VECTORS(alone.size(), 1000, 2000, 0);
    const ReadResult scene = read(QStringLiteral("a.lws"), "LWSC\n3\n\nLoadObjectLayer 1 part.lwo\n\n");
    COMPARE_VECTORS(boxOf(scene.mesh).size(), 1000, 2000, 0);
}

/// A scene tells how many of its objects are missing; one without any object is refused.
void TestForeignScenes::lws_missingObjectsAreTold()
{
    write(QStringLiteral("here.lwo"), lwo(2));
    const QByteArray start = "LWSC\n3\n\n", here = "LoadObjectLayer 1 here.lwo\n\n",
                     gone = "LoadObjectLayer 1 gone.lwo\n\n";
    QCOMPARE(read(QStringLiteral("a.lws"), start + here + gone + gone).remarks.unreadNodes, std::size_t(1));
    QCOMPARE(read(QStringLiteral("a.lws"), start + here + here).remarks.unreadNodes, std::size_t(0));
    const auto error = errorOf(QStringLiteral("a.lws"), start + gone);
    QVERIFY(error && error->fault == core::FileFault::Missing);
    QCOMPARE(error->token, std::string("gone.lwo"));
}

/// Assimp would put another corner in the place of one that does not exist.
void TestForeignScenes::lwo_missingCornersAreTold()
{
    const auto error = errorOf(QStringLiteral("a.lwo"), lwo(99));
    QVERIFY(error && error->kind == core::FileErrorKind::ReaderRefused);
    QVERIFY(error->token.find("out of range") != std::string::npos);
}

void TestForeignScenes::threeDs_missingCornersAreTold()
{
    const auto fileOf = [](quint16 last) {
        const auto number = [](auto value) {
            QByteArray bytes(sizeof value, '\0');
            qToLittleEndian(value, bytes.data());
            return bytes;
        };
        const auto chunk = [&number](quint16 id, const QByteArray& content) {
            return number(id) + number(quint32(6 + content.size())) + content;
        };
        QByteArray points = number(quint16(3)), faces = number(quint16(1));
        for (const float value : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 2.0F, 0.0F})
            points += number(value);
        for (const quint16 value : {quint16(0), quint16(1), last, quint16(0)})
            faces += number(value);
        const QByteArray mesh = chunk(0x4100, chunk(0x4110, points) + chunk(0x4120, faces));
        return chunk(0x4d4d, chunk(0x3d3d, chunk(0x4000, QByteArray("box\0", 4) + mesh)));
    };
    QCOMPARE(read(QStringLiteral("a.3ds"), fileOf(2)).mesh.triangles.size(), std::size_t(1));
    const auto error = errorOf(QStringLiteral("a.3ds"), fileOf(99));
    QVERIFY(error && error->kind == core::FileErrorKind::ReaderRefused);
    QVERIFY(error->token.find("Vertex index overflow") != std::string::npos);
}

void TestForeignScenes::words_areWholeAndWithoutPath()
{
    for (const char* name : {"bad.fbx", "bad.dae", "bad.3ds", "bad.x", "bad.lwo", "bad.nff"}) {
        const auto error = errorOf(QString::fromLatin1(name), "this is nothing of the kind");
        if (!error || error->kind != core::FileErrorKind::ReaderRefused)
            continue;
        QVERIFY2(!(error->token.find(m_dir.path().toStdString()) != std::string::npos), name);
        QVERIFY2(error->token.size() <= 200, name);
    }
    const auto known = errorOf(QStringLiteral("bad.3ds"), "this is nothing of the kind");
    QVERIFY(known && !known->token.empty());
    const auto named = errorOf(QStringLiteral("b\u00e4d.3ds"), "abc"); // the ä takes two bytes in UTF-8
    QVERIFY(named);
    QVERIFY2(named->token.find("b??d.3ds") != std::string::npos, named->token.c_str());
    const auto longWords =
        errorOf(QStringLiteral("a.lws"), "LWSC\n3\n\nLoadObjectLayer 1 " + QByteArray(300, 'x') + "\n");
    QVERIFY(longWords && longWords->token.size() <= 200);
    const auto quotation =
        errorOf(QStringLiteral("a.fbx"), fbx({{}}).replace("C: \"OO\",2000", "C: \"OO\",abc" + QByteArray(300, ' ')));
    QVERIFY(quotation && quotation->kind == core::FileErrorKind::ReaderRefused);
    QCOMPARE(quotation->token, std::string()); // too long to be quoted whole
}

FETTLE_TEST(TestForeignScenes)
#include "tst_foreign_scenes.moc"
