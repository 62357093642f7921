// The shapes of files that come in through Assimp: each scene is written out here, and its size, volume or area is
// known beforehand.

#include "app/import/sandboxed_importer.h"
#include "core/io/mesh_io.h"
#include "core/util/file_error.h"
#include "tests/support/test_main.h"

#include <QFile>
#include <QPointF>
#include <QTemporaryDir>
#include <QTest>

#include <optional>

namespace
{
using core::ReadResult;
using core::Vec3;
using core::Vec3f;

/// The lengths, in mm, to which what Assimp computes in 32 bits is right.
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

/// A model of an FBX file, with a cube of 10 from the origin on.
struct FbxModel
{
    QByteArray properties = {}; ///< lines as vector() makes them
    int parent = -1;            ///< another model, before it; -1: none
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

/// An FBX file of version 7.4 as text, by default in millimetres and with Y up.
QByteArray fbx(const QList<FbxModel>& models, const QByteArray& settings = {}, const QByteArray& mesh = cube())
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
           (settings.isEmpty() ? R"(P: "UnitScaleFactor", "double", "Number", "",0.1)" : settings) +
           "\n}\n}\nObjects:  {\n" + objects + "}\nConnections:  {\n" + connections + "}\n";
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
    void fbx_scalesAreInherited_data();
    void fbx_scalesAreInherited();
    void fbx_axesAndUnitAreItsOwn_data();
    void fbx_axesAndUnitAreItsOwn();
    void fbx_polygonsAreFilledExactly();

private:
    std::filesystem::path file(const QString& name) const { return m_dir.filePath(name).toStdU16String(); }
    ReadResult read(const QString& name, const QByteArray& bytes) const
    {
        QFile to(m_dir.filePath(name));
        if (to.open(QIODevice::WriteOnly) && to.write(bytes) == bytes.size())
            to.close();
        return core::readModel(file(name));
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

/// 3ds Max writes one for each pivot that was moved.
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

/// A rotation and its PostRotation cancel each other.
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
    }
}

void TestForeignScenes::fbx_scalesAreInherited_data()
{
    QTest::addColumn<int>("inheritType");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::newRow("as matrices") << 1 << 20.0 << 10.0;
    QTest::newRow("by own axes") << 0 << 10.0 << 20.0; // its x is the world's y
    QTest::newRow("not at all") << 2 << 10.0 << 10.0;
}

/// The parent is twice as wide; the child is turned by 90 degrees, and stands at twice its distance in all cases.
void TestForeignScenes::fbx_scalesAreInherited()
{
    QFETCH(int, inheritType);
    QFETCH(double, x);
    QFETCH(double, y);
    const QByteArray scale = vector("Lcl Scaling", {2, 1, 1}) + vector("GeometricScaling", {0, 0, 0});
    const QByteArray child = R"(P: "InheritType", "enum", "", "",)" + QByteArray::number(inheritType) + "\n" +
                             vector("Lcl Rotation", {0, 0, 90}) + vector("Lcl Translation", {50, 0, 0});
    const ReadResult model = readFbx(fbx({{scale}, {.properties = child, .parent = 0}}));
    core::TriangleMesh mesh = model.mesh;
    std::erase_if(mesh.points, [](const Vec3f& p) { return p.isZero(); }); // the parent's, shrunk to its origin
    const Box box = boxOf(mesh);
    COMPARE_VECTORS(box.size(), x, y, 10);
    COMPARE_VECTORS(Vec3(box.max.x(), box.min.y(), box.min.z()), 100, 0, 0);
}

void TestForeignScenes::fbx_axesAndUnitAreItsOwn_data()
{
    QTest::addColumn<QByteArray>("settings");
    QTest::addColumn<QList<int>>("place"); // of the corner (1, 2, 3) of the file, in cm
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

/// A comb, whose teeth a fan of triangles would cover twice.
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

FETTLE_TEST(TestForeignScenes)
#include "tst_foreign_scenes.moc"
