// Tests AMF files of other programs, plain and zipped: units, volumes, objects, constellations, colours. Hostile files
// must be refused.

#include "core/io/mesh_io.h"
#include "core/util/file_error.h"
#include "tests/core/io/text_mutation.h"
#include "tests/support/effort.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QTest>

#include <zip.h>

#include <fstream>
#include <functional>
#include <numbers>
#include <random>

namespace
{
using core::FileError;
using core::FileFault;
using core::ReadResult;
using core::Rgb;
using core::TriangleMesh;
using core::UpAxis;
using core::Vec3f;
using Kind = core::FileErrorKind;
using Entries = std::vector<std::pair<std::string, std::string>>;

struct AmfTetrahedron
{
    std::string ofVertex, ofTriangle; ///< extra content of the first vertex and of the first triangle

    /// Returns the vertices of a right-angled tetrahedron of 1 x 2 x 3, with its right angle at (x, 0, 0).
    std::string vertices(int x = 0) const
    {
        const std::string at = std::to_string(x), beside = std::to_string(x + 1);
        return "<vertex><coordinates><x>" + at + "</x><y>0</y><z>0</z></coordinates>" + ofVertex +
               "</vertex>\n<vertex><coordinates><x>" + beside +
               "</x><y>0</y><z>0</z></coordinates></vertex>\n<vertex><coordinates><x>" + at +
               "</x><y> +2.0 </y><z>0</z></coordinates></vertex>\n<vertex><coordinates><x>" + at +
               "</x><y>0</y><z>\n3e0</z></coordinates></vertex>\n";
    }
    std::string triangles(int first = 0) const
    {
        const auto triangle = [first](int a, int b, int c, const std::string& more) {
            return "<triangle>" + more + "<v1>" + std::to_string(first + a) + "</v1><v2>" + std::to_string(first + b) +
                   "</v2><v3>" + std::to_string(first + c) + "</v3></triangle>";
        };
        return triangle(0, 2, 1, ofTriangle) + triangle(0, 1, 3, {}) + triangle(0, 3, 2, {}) + triangle(1, 2, 3, {});
    }
    std::string mesh(const std::string& ofVolume = {}, const std::string& material = {}) const
    {
        return "<mesh><vertices>" + vertices() + "</vertices><volume materialid=\"" + material + "\">" + ofVolume +
               triangles() + "</volume></mesh>";
    }
};

std::string amfObject(const std::string& id, const std::string& content = AmfTetrahedron().mesh())
{
    return "<object id=\"" + id + "\">" + content + "</object>\n";
}

std::string amfInstance(const std::string& of, const std::string& placed = {})
{
    return "<instance objectid=\"" + of + "\">" + placed + "</instance>\n";
}

std::string amfConstellation(const std::string& id, const std::string& instances)
{
    return "<constellation id=\"" + id + "\">" + instances + "</constellation>\n";
}

std::string amfOf(const std::string& content, const std::string& attributes = {})
{
    return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<amf " + attributes + ">\n" + content + "</amf>\n";
}

std::string amfColor(const std::string& r, const std::string& g, const std::string& b)
{
    return "<color><r>" + r + "</r><g>" + g + "</g><b>" + b + "</b><a>0.5</a></color>";
}

std::string volumeMetadata(const std::string& type, const std::string& value)
{
    return "<metadata type=\"slic3r." + type + "\">" + value + "</metadata>";
}

double enclosedVolume(const TriangleMesh& mesh)
{
    double six = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        six += mesh.points[a].cast<double>().dot(mesh.points[b].cast<double>().cross(mesh.points[c].cast<double>()));
    return six / 6;
}

bool hasPoint(const TriangleMesh& mesh, float x, float y, float z)
{
    return std::ranges::find(mesh.points, Vec3f(x, y, z)) != mesh.points.end();
}

std::string edited(std::string text, std::string_view from, std::string_view to)
{
    const std::size_t at = text.find(from);
    Q_ASSERT(at != std::string::npos);
    return text.replace(at, from.size(), to);
}
} // namespace

class TestAmf : public QObject
{
    Q_OBJECT

    static constexpr unsigned seed = 20261126;

private Q_SLOTS:
    void initTestCase() { QVERIFY(m_dir.isValid()); }

    void units_becomeMillimetres_data();
    void units_becomeMillimetres();
    void zIsUp();
    void volumesAndObjects_areAllRead();
    void meshesOfAnObject_countTheirOwnVertices();
    void verticesBehindTheTriangles_areRead();
    void slicersVolumes_areLeftOutAndTold_data();
    void slicersVolumes_areLeftOutAndTold();
    void instances_arePlaced_data();
    void instances_arePlaced();
    void rightAngles_areExact();
    void constellations_nest();
    void constellations_mayHaveIdsOfObjects();
    void mirroredInstances_stayOutward();
    void slicersAngles_areInRadians();
    void colors_areRead_data();
    void colors_areRead();
    void sharedVertices_haveTheMeanColor();
    void whatIsLeftOut_isTold_data();
    void whatIsLeftOut_isTold();
    void zips_areRead_data();
    void zips_areRead();
    void carelessFiles_areRead_data();
    void carelessFiles_areRead();
    void onlyReading();

    void badFiles_areRefused_data();
    void badFiles_areRefused();
    void badZips_areRefused();
    void cutFiles_areRefused();
    void bombs_areRefused();
    void manyCopies_areRefused();
    void mutatedFiles_neverGetThrough();

private:
    std::filesystem::path file(const std::string& name) const
    {
        return std::filesystem::path(m_dir.path().toStdString()) / name;
    }
    std::string zipped(const Entries& entries, int packing = ZIP_CM_DEFLATE) const;
    static ReadResult readAll(const std::filesystem::path& path, UpAxis up = UpAxis::Y)
    {
        return core::readModel(path, {.up = up});
    }
    ReadResult readAll(const std::string& bytes, UpAxis up = UpAxis::Y) const
    {
        std::ofstream(file("a.amf"), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return readAll(file("a.amf"), up);
    }
    TriangleMesh read(const std::string& bytes) const { return readAll(bytes).mesh; }
    static std::optional<FileError> errorOf(const std::function<void()>& action);

    QTemporaryDir m_dir;
};

std::string TestAmf::zipped(const Entries& entries, int packing) const
{
    const auto path = file("a.zip");
    std::filesystem::remove(path);
    zip* const archive = zip_open(path.c_str(), ZIP_CREATE, nullptr);
    for (const auto& [name, text] : entries) {
        if (name.ends_with('/')) {
            zip_dir_add(archive, name.c_str(), 0);
            continue;
        }
        const auto index =
            zip_file_add(archive, name.c_str(), zip_source_buffer(archive, text.data(), text.size(), 0), 0);
        zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), packing, 0);
    }
    zip_close(archive);
    std::ifstream stream(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

std::optional<FileError> TestAmf::errorOf(const std::function<void()>& action)
{
    try {
        action();
    } catch (const FileError& error) {
        return error;
    }
    return std::nullopt;
}

void TestAmf::units_becomeMillimetres_data()
{
    QTest::addColumn<QString>("attribute");
    QTest::addColumn<double>("millimetres");
    QTest::newRow("none") << "" << 1.0;
    QTest::newRow("empty") << "unit=\"\"" << 1.0;
    for (const auto& [name, millimetres] : std::initializer_list<std::pair<const char*, double>>{{"millimeter", 1},
                                                                                                 {"Millimeter", 1},
                                                                                                 {"inch", 25.4},
                                                                                                 {" INCH ", 25.4},
                                                                                                 {"feet", 304.8},
                                                                                                 {"foot", 304.8},
                                                                                                 {"meter", 1000},
                                                                                                 {"micron", 0.001}})
        QTest::newRow(name) << QStringLiteral("unit=\"%1\"").arg(QLatin1StringView(name)) << millimetres;
}

void TestAmf::units_becomeMillimetres()
{
    QFETCH(QString, attribute);
    QFETCH(double, millimetres);
    const TriangleMesh mesh = read(amfOf(amfObject("1"), attribute.toStdString()));
    QCOMPARE(mesh.points.size(), std::size_t(4));
    QVERIFY(mesh.points[1] == Vec3f(static_cast<float>(millimetres), 0, 0));
    QVERIFY(mesh.points[2] == Vec3f(0, static_cast<float>(2 * millimetres), 0));
    QVERIFY(mesh.points[3] == Vec3f(0, 0, static_cast<float>(3 * millimetres)));
    // Displacements of instances are in the file's unit, too.
    const TriangleMesh moved = read(
        amfOf(amfObject("1") + amfConstellation("2", amfInstance("1", "<deltax>4</deltax>")), attribute.toStdString()));
    QVERIFY(moved.points[0] == Vec3f(static_cast<float>(4 * millimetres), 0, 0));
}

void TestAmf::zIsUp()
{
    readAll(amfOf(amfObject("1")));
    const TriangleMesh mesh = core::readMesh(file("a.amf"));
    QVERIFY(mesh.points[2] == Vec3f(0, 0, -2) && mesh.points[3] == Vec3f(0, 3, 0));
    QCOMPARE(static_cast<int>(core::usualUp(core::MeshFormat::Amf)), static_cast<int>(UpAxis::Z));
}

void TestAmf::volumesAndObjects_areAllRead()
{
    const AmfTetrahedron t;
    const std::string two = "<mesh><vertices>" + t.vertices() + t.vertices(5) + "</vertices><volume>" + t.triangles() +
                            "</volume><volume>" + t.triangles(4) + "</volume><volume/></mesh>";
    const ReadResult both = readAll(amfOf(amfObject("1", two)));
    QCOMPARE(enclosedVolume(both.mesh), 2.0);
    QCOMPARE(both.mesh.points.size(), std::size_t(8));
    QCOMPARE(both.remarks.objects, std::size_t(1)); // volumes of one object
    QVERIFY(both.mesh.colors.empty());
    const ReadResult three =
        readAll(amfOf(amfObject("1", two) + amfObject("2", edited(AmfTetrahedron().mesh(), "<x>0", "<x>9"))));
    QCOMPARE(three.mesh.triangles.size(), std::size_t(12));
    QCOMPARE(three.remarks.objects, std::size_t(2));
    QVERIFY(readAll(amfOf(amfObject("1"))).remarks == core::ReadRemarks());
}

void TestAmf::meshesOfAnObject_countTheirOwnVertices()
{
    const AmfTetrahedron t;
    const std::string second = "<mesh><vertices>" + t.vertices(5) + "</vertices><vertices>" + t.vertices(8) +
                               "</vertices><volume>" + t.triangles() + t.triangles(4) + "</volume></mesh>";
    const TriangleMesh mesh = read(amfOf(amfObject("1", t.mesh() + second)));
    QCOMPARE(enclosedVolume(mesh), 3.0);
    QVERIFY(hasPoint(mesh, 5, 2, 0) && hasPoint(mesh, 8, 2, 0));
}

void TestAmf::verticesBehindTheTriangles_areRead()
{
    const AmfTetrahedron t;
    const TriangleMesh mesh = read(amfOf(amfObject("1", "<mesh><volume>" + t.triangles() + "</volume><vertices>" +
                                                            t.vertices() + "</vertices></mesh>")));
    QCOMPARE(enclosedVolume(mesh), 1.0);
}

void TestAmf::slicersVolumes_areLeftOutAndTold_data()
{
    QTest::addColumn<QString>("metadata");
    QTest::addColumn<QString>("attributes");
    QTest::addColumn<bool>("isMatter");
    QTest::addColumn<bool>("isNegative");
    const auto row = [](const char* name, const std::string& metadata, bool isMatter, bool isNegative = false,
                        const char* attributes = "") {
        QTest::newRow(name) << QString::fromStdString(metadata) << QString(attributes) << isMatter << isNegative;
    };
    row("of AMF 1.2", "", true, false, " type=\"object\"");
    row("support of AMF 1.2", "", false, false, " type=\"support\"");
    row("a name", "<metadata type=\"name\">modifier</metadata>", true);
    row("no modifier", volumeMetadata("modifier", "0"), true);
    row("modifier of Slic3r", volumeMetadata("modifier", "1"), false);
    row("part", volumeMetadata("volume_type", "ModelPart"), true);
    row("part after all", volumeMetadata("modifier", "1") + volumeMetadata("volume_type", "ModelPart"), true);
    row("modifier", volumeMetadata("modifier", "1") + volumeMetadata("volume_type", "ParameterModifier"), false);
    row("support", volumeMetadata("volume_type", "SupportBlocker"), false);
    row("negative", volumeMetadata("volume_type", "\n NegativeVolume "), false, true);
}

void TestAmf::slicersVolumes_areLeftOutAndTold()
{
    QFETCH(QString, metadata);
    QFETCH(QString, attributes);
    QFETCH(bool, isMatter);
    QFETCH(bool, isNegative);
    const AmfTetrahedron t{.ofVertex = {}, .ofTriangle = amfColor("1", "0", "0")}, plain;
    const std::string mesh = "<mesh><vertices>" + t.vertices() + t.vertices(5) + t.vertices(9) + "</vertices><volume>" +
                             plain.triangles() + "</volume><volume" + attributes.toStdString() + ">" +
                             metadata.toStdString() + t.triangles(4) + "</volume><volume>" + plain.triangles(8) +
                             "</volume></mesh>";
    const ReadResult result = readAll(amfOf(amfObject("1", mesh)));
    QCOMPARE(result.mesh.triangles.size(), std::size_t(isMatter ? 12 : 8));
    QCOMPARE(enclosedVolume(result.mesh), isMatter ? 3.0 : 2.0);
    // vertices of excluded volumes are removed, as they would count in the size of the model
    QCOMPARE(result.mesh.points.size(), std::size_t(isMatter ? 12 : 8));
    QCOMPARE(result.mesh.colors.empty(), !isMatter);
    QCOMPARE(result.remarks.negativeParts, std::size_t(isNegative));
    QCOMPARE(result.remarks.otherParts, std::size_t(!isMatter && !isNegative));
}

void TestAmf::instances_arePlaced_data()
{
    QTest::addColumn<QString>("placed");
    QTest::addColumn<QList<double>>("x1"); // x1, y2, z3: images of (1, 0, 0), (0, 2, 0) and (0, 0, 3)
    QTest::addColumn<QList<double>>("y2");
    QTest::addColumn<QList<double>>("z3");
    const auto row = [](const char* placed, QList<double> x1, QList<double> y2, QList<double> z3) {
        QTest::newRow(placed) << QString(placed) << x1 << y2 << z3;
    };
    row("", {1, 0, 0}, {0, 2, 0}, {0, 0, 3});
    row("<deltax>10</deltax><deltay>-20</deltay><deltaz>0.5</deltaz>", {11, -20, 0.5}, {10, -18, 0.5}, {10, -20, 3.5});
    row("<rx>90</rx>", {1, 0, 0}, {0, 0, 2}, {0, -3, 0});
    row("<ry>90</ry>", {0, 0, -1}, {0, 2, 0}, {3, 0, 0});
    row("<rz>90</rz>", {0, 1, 0}, {-2, 0, 0}, {0, 0, 3});
    row("<rz>-450</rz>", {0, -1, 0}, {2, 0, 0}, {0, 0, 3});
    row("<rz>180</rz>", {-1, 0, 0}, {0, -2, 0}, {0, 0, 3});
    // first about x, regardless of the order in the file
    row("<rz>90</rz><rx>90</rx>", {0, 1, 0}, {0, 0, 2}, {3, 0, 0});
    row("<rx>90</rx><ry>90</ry>", {0, 0, -1}, {2, 0, 0}, {0, -3, 0});
    row("<ry>90</ry><rz>90</rz><deltax>1</deltax>", {1, 0, -1}, {-1, 0, 0}, {1, 3, 0});
    row("<scale>2</scale><rz>90</rz><deltay>1</deltay>", {0, 3, 0}, {-4, 1, 0}, {0, 1, 6});
    row("<scalex>3</scalex><scaley>2</scaley><scalez>1</scalez>", {3, 0, 0}, {0, 4, 0}, {0, 0, 3});
}

void TestAmf::instances_arePlaced()
{
    QFETCH(QString, placed);
    const TriangleMesh mesh =
        read(amfOf(amfObject("1") + amfConstellation("2", amfInstance("1", placed.toStdString()))));
    QCOMPARE(mesh.triangles.size(), std::size_t(4)); // a placed object is not added a second time unplaced
    QVERIFY(enclosedVolume(mesh) > 0);
    const char* const names[] = {"x1", "y2", "z3"};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3f& p = mesh.points[i + 1];
        QTEST((QList<double>{p.x(), p.y(), p.z()}), names[i]);
    }
}

/// Rotations by multiples of 90 degrees must be exact. The standard's order is about x, then y, then z.
void TestAmf::rightAngles_areExact()
{
    const auto turned = [this](const std::string& placed) {
        return read(amfOf(amfObject("1") + amfConstellation("2", amfInstance("1", placed))));
    };
    for (const char* quarter : {"0", "90", "180", "270", "360", "-90", "-180", "810"})
        for (const Vec3f& p : turned("<rx>" + std::string(quarter) + "</rx><ry>90</ry><rz>-270</rz>").points)
            QVERIFY(p == Vec3f(p.array().round()));
    std::mt19937 engine(seed);
    for (int round = 0; round < 20; ++round) {
        std::string placed;
        Eigen::Matrix3d wanted = Eigen::Matrix3d::Identity();
        for (int axis = 0; axis < 3; ++axis) {
            const double degrees = static_cast<double>(engine() % 72'000) / 100 - 360;
            const std::string name = std::string("r") + "xyz"[axis];
            placed += "<" + name + ">" + std::to_string(degrees) + "</" + name + ">";
            wanted = Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Eigen::Vector3d::Unit(axis)) * wanted;
        }
        const TriangleMesh mesh = turned(placed);
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY((mesh.points[static_cast<std::size_t>(axis) + 1].cast<double>() - (axis + 1) * wanted.col(axis))
                        .norm() < 1e-6);
    }
}

/// FreeCAD and slicers number objects and constellations apart. An instance means the object.
void TestAmf::constellations_mayHaveIdsOfObjects()
{
    const std::string objects = amfObject("0") + amfObject("1", edited(AmfTetrahedron().mesh(), "<x>0", "<x>7"));
    const std::string both = amfConstellation("1", amfInstance("0", "<deltay>9</deltay>") + amfInstance("1"));
    for (const std::string& content : {objects + both, both + objects}) {
        const ReadResult result = readAll(amfOf(content));
        QCOMPARE(result.mesh.triangles.size(), std::size_t(8));
        QVERIFY(hasPoint(result.mesh, 0, 9, 0) && hasPoint(result.mesh, 7, 0, 0));
    }
    QCOMPARE(read(amfOf(amfObject("0") + amfConstellation("0", amfInstance("0")))).triangles.size(), std::size_t(4));
}

void TestAmf::constellations_nest()
{
    const std::string two = amfInstance("1") + amfInstance("1", "<deltax>10</deltax>");
    const std::string inner = amfConstellation("2", two);
    const std::string outer =
        amfConstellation("3", amfInstance("2", "<rz>90</rz>") + amfInstance("2", "<deltaz>100</deltaz>") +
                                  amfInstance("1", "<deltaz>200</deltaz>"));
    for (const std::string& content : {amfObject("1") + inner + outer, outer + inner + amfObject("1")}) {
        const ReadResult result =
            readAll(amfOf(content + amfObject("4", edited(AmfTetrahedron().mesh(), "<x>0", "<x>7"))));
        QCOMPARE(result.mesh.triangles.size(), std::size_t(24));
        QCOMPARE(result.remarks.objects, std::size_t(4)); // three in the outer constellation, and object 4
        QVERIFY(hasPoint(result.mesh, 0, 11, 0) && hasPoint(result.mesh, -2, 10, 0) &&
                hasPoint(result.mesh, 11, 0, 100));
        QVERIFY(hasPoint(result.mesh, 0, 2, 200));
        QVERIFY(hasPoint(result.mesh, 7, 0, 0)); // object 4 is in no constellation and is added unplaced
    }
    // Constellations that no other one refers to are all added.
    QCOMPARE(read(amfOf(amfObject("1") + amfConstellation("2", two) +
                        amfConstellation("3", amfInstance("1", "<deltay>9</deltay>"))))
                 .triangles.size(),
             std::size_t(12));
}

void TestAmf::mirroredInstances_stayOutward()
{
    const TriangleMesh mesh = read(
        amfOf(amfObject("1") + amfConstellation("2", amfInstance("1", "<mirrorx>-1</mirrorx><scalex>2</scalex>"))));
    QCOMPARE(enclosedVolume(mesh), 2.0);
    QVERIFY(hasPoint(mesh, -2, 0, 0));
}

/// Slic3r and its derivatives write radians, although the standard specifies degrees.
void TestAmf::slicersAngles_areInRadians()
{
    const std::string placed = amfObject("1") + amfConstellation("2", amfInstance("1", "<rz>1.5707963267948966</rz>"));
    for (const char* metadata :
         {"<metadata type=\"cad\">Slic3r 1.3.1-dev</metadata>", "<metadata type=\"cad\"> PrusaSlicer 2.5.0 </metadata>",
          "<metadata type=\"slic3rpe_amf_version\">2</metadata>"}) {
        const TriangleMesh mesh = read(amfOf(metadata + placed));
        QVERIFY((mesh.points[1] - Vec3f(0, 1, 0)).norm() < 1e-6F);
        QVERIFY(read(amfOf(placed + metadata)).points == mesh.points);
    }
    const TriangleMesh others = read(amfOf("<metadata type=\"cad\">Prusa</metadata>" + placed));
    QVERIFY((others.points[1] - Vec3f(1, 0.0274F, 0)).norm() < 1e-3F);
}

void TestAmf::colors_areRead_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QList<int>>("first"); // colours of the first and the last vertex; empty: no colours
    QTest::addColumn<QList<int>>("last");
    const QList<int> none, red{255, 0, 0}, green{0, 128, 0}, blue{0, 0, 255}, yellow{255, 255, 0}, grey{200, 200, 200};
    const std::string r = amfColor("1", "0", "0"), g = amfColor("0", "0.5", "0"), b = amfColor(" 0 ", "-0.1", "1.5"),
                      y = amfColor("1", "1e0", "0");
    const auto row = [](const char* name, const std::string& content, const QList<int>& first, const QList<int>& last) {
        QTest::newRow(name) << QByteArray::fromStdString(content) << first << last;
    };
    const std::string material = "<material id=\"7\">" + y + "</material>";
    const AmfTetrahedron plain, ofVertex{.ofVertex = r, .ofTriangle = {}};
    row("none", amfObject("1"), none, none);
    row("object", amfObject("1", r + plain.mesh()), red, red);
    row("object, behind", amfObject("1", plain.mesh() + r), red, red);
    row("volume over object", amfObject("1", r + plain.mesh(g)), green, green);
    row("vertex over volume", amfObject("1", ofVertex.mesh(g)), red, green);
    row("vertex alone", amfObject("1", ofVertex.mesh()), red, grey);
    row("material", material + amfObject("1", plain.mesh({}, "7")), yellow, yellow);
    row("material, behind", amfObject("1", plain.mesh({}, "7")) + material, yellow, yellow);
    row("object over material", material + amfObject("1", g + plain.mesh({}, "7")), green, green);
    row("material that is not there", amfObject("1", plain.mesh({}, "8")), none, none);
    row("beyond the range", amfObject("1", plain.mesh(b)), blue, blue);
    row("formula", amfObject("1", plain.mesh(amfColor("x*2", "0", "0"))), none, none);
    row("without blue", amfObject("1", plain.mesh("<color><r>1</r><g>1</g></color>")), none, none);
    row("in another object", amfObject("1") + amfObject("2", r + edited(plain.mesh(), "<x>0", "<x>9")), grey, red);
}

void TestAmf::colors_areRead()
{
    QFETCH(QByteArray, content);
    const std::vector<Rgb> colors = read(amfOf(content.toStdString())).colors;
    const auto listOf = [&colors](std::size_t i) {
        return colors.empty() ? QList<int>() : QList<int>{colors[i].r, colors[i].g, colors[i].b};
    };
    QTEST(listOf(0), "first");
    QTEST(listOf(colors.size() - 1), "last");
}

void TestAmf::sharedVertices_haveTheMeanColor()
{
    const AmfTetrahedron t{.ofVertex = amfColor("0", "1", "0"), .ofTriangle = amfColor("1", "0", "0")};
    const std::vector<Rgb> colors = read(amfOf(amfObject("1", t.mesh(amfColor("0", "0", "1"))))).colors;
    QVERIFY((colors[0] == Rgb{85, 170, 0})); // mean of the triangle's colour and twice the vertex's own
    QVERIFY((colors[1] == Rgb{85, 0, 170})); // mean of the triangle's colour and twice the volume's
    QVERIFY((colors[3] == Rgb{0, 0, 255}));
}

void TestAmf::whatIsLeftOut_isTold_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<bool>("curves");
    QTest::addColumn<bool>("materials");
    QTest::addColumn<bool>("textures");
    const auto row = [](const char* name, const std::string& content, bool curves, bool materials, bool textures) {
        QTest::newRow(name) << QByteArray::fromStdString(content) << curves << materials << textures;
    };
    row("nothing", amfObject("1"), false, false, false);
    const std::string normal = "<normal><nx>0</nx><ny>0</ny><nz>1</nz></normal>";
    row("normals", amfObject("1", AmfTetrahedron{.ofVertex = normal, .ofTriangle = {}}.mesh()), true, false, false);
    row("edges",
        amfObject("1", edited(AmfTetrahedron().mesh(), "</vertices>",
                              "<edge><v1>0</v1><dx1>1</dx1><v2>1</v2><dx2>x</dx2></edge></vertices>")),
        true, false, false);
    row("composite", amfObject("1") + "<material id=\"2\"><composite materialid=\"3\">sin(x)</composite></material>",
        false, true, false);
    row("formula", amfObject("1", AmfTetrahedron().mesh(amfColor("x", "0", "0"))), false, true, false);
    row("texture", amfObject("1") + "<texture id=\"1\" width=\"4\">" + std::string(100'000, 'A') + "</texture>", false,
        false, true);
    row("map", amfObject("1", AmfTetrahedron{.ofVertex = {}, .ofTriangle = "<texmap><utex1>0</utex1></texmap>"}.mesh()),
        false, false, true);
    row("other elements", "<metadata type=\"name\">" + std::string(100'000, 'A') + "</metadata><x/>" + amfObject("1"),
        false, false, false);
}

void TestAmf::whatIsLeftOut_isTold()
{
    QFETCH(QByteArray, content);
    const ReadResult result = readAll(amfOf(content.toStdString()));
    QCOMPARE(enclosedVolume(result.mesh), 1.0);
    QTEST(result.remarks.curves, "curves");
    QTEST(result.remarks.materials, "materials");
    QTEST(result.remarks.textures, "textures");
}

void TestAmf::zips_areRead_data()
{
    QTest::addColumn<QStringList>("names");
    QTest::addColumn<QStringList>("texts");
    QTest::addColumn<int>("others");
    const QString good = QString::fromStdString(amfOf(amfObject("1"))),
                  other =
                      QString::fromStdString(amfOf(amfObject("1", edited(AmfTetrahedron().mesh(), "<x>0", "<x>-9")))),
                  icon = QStringLiteral("PNG <amf>");
    QTest::newRow("one") << QStringList{"a.amf"} << QStringList{good} << 0;
    QTest::newRow("another name") << QStringList{"vase.AMF"} << QStringList{good} << 0;
    QTest::newRow("in a folder") << QStringList{"x/", "x/a.amf"} << QStringList{"", good} << 0;
    QTest::newRow("another ending") << QStringList{"model.xml"} << QStringList{good} << 0;
    QTest::newRow("no ending") << QStringList{"icon", "model"} << QStringList{icon, good} << 0;
    QTest::newRow("with a mark") << QStringList{"a.amf"} << QStringList{QChar(0xfeff) + good} << 0;
    QTest::newRow("beside the Finder's") << QStringList{"__MACOSX/._a.amf", "a.amf"} << QStringList{icon, good} << 0;
    QTest::newRow("behind the Finder's") << QStringList{"__MACOSX/a.amf", "a.amf"} << QStringList{other, good} << 0;
    QStringList many;
    for (int i = 0; i < 2000; ++i)
        many << QStringLiteral("%1.txt").arg(i);
    QTest::newRow("behind many others") << (many + QStringList{"a.amf"})
                                        << (QStringList(2000, QStringLiteral("text")) + QStringList{good}) << 0;
    QTest::newRow("beside other XML") << QStringList{"a.xml", "b.xml"} << QStringList{"<x/>", good} << 0;
    QTest::newRow("beside another") << QStringList{"b.amf", "a.amf"} << QStringList{good, other} << 1;
    QTest::newRow("the name decides") << QStringList{"a.xml", "b.amf"} << QStringList{other, good} << 0;
}

void TestAmf::zips_areRead()
{
    QFETCH(QStringList, names);
    QFETCH(QStringList, texts);
    Entries entries;
    for (qsizetype i = 0; i < names.size(); ++i)
        entries.emplace_back(names[i].toStdString(), texts[i].toStdString());
    for (const int packing : {ZIP_CM_DEFLATE, ZIP_CM_STORE}) {
        const ReadResult result = readAll(zipped(entries, packing));
        QCOMPARE(enclosedVolume(result.mesh), 1.0);
        QVERIFY(hasPoint(result.mesh, 0, 0, 0));
        QTEST(static_cast<int>(result.remarks.otherModels), "others");
    }
}

void TestAmf::carelessFiles_areRead_data()
{
    QTest::addColumn<QByteArray>("text");
    const auto row = [](const char* name, const std::string& text) {
        QTest::newRow(name) << QByteArray::fromStdString(text);
    };
    const std::string good = amfOf(amfObject("1"));
    row("byte order mark", "\xef\xbb\xbf" + good);
    row("padding", good + std::string(3, '\0') + "\x1a");
    row("no declaration", good.substr(good.find("<amf")));
    row("Latin-1", edited(edited(good, "utf-8", "ISO-8859-1"), "<amf", "<!-- \xe4 --><amf"));
    row("no id", edited(good, "id=\"1\"", ""));
    row("namespace", edited(good, "<amf ", "<amf xmlns=\"http://www.astm.org/F42/F2915\" "));
    std::string prefixed = good;
    for (std::size_t at = prefixed.find('<', prefixed.find("<amf")); at != std::string::npos;
         at = prefixed.find('<', at + 1))
        prefixed.insert(at + (prefixed[at + 1] == '/' ? 2 : 1), "a:");
    row("undeclared prefix", prefixed);
    row("prefix", edited(prefixed, "<a:amf ", "<a:amf xmlns:a=\"http://www.astm.org/F42/F2915\" "));
    row("another's elements",
        edited(edited(good, "<amf ", "<amf xmlns:o=\"other\" "), "<vertices>", "<vertices><o:vertex>x</o:vertex>"));
    row("comments", edited(edited(good, "<x>0</x>", "<x><!-- one -->0<!-- two --></x>"), "<v1>", "<v1>\t"));
    row("CDATA and references", edited(edited(good, "<x>0</x>", "<x><![CDATA[0]]></x>"), "<y>0", "<y>&#48;"));
}

void TestAmf::carelessFiles_areRead()
{
    QFETCH(QByteArray, text);
    QCOMPARE(enclosedVolume(read(text.toStdString())), 1.0);
}

void TestAmf::onlyReading()
{
    QVERIFY(core::meshFormatOf("a.AMF") == core::MeshFormat::Amf);
    QVERIFY(!core::isWritten("a.amf"));
    const TriangleMesh mesh = read(amfOf(amfObject("1")));
    const auto error = errorOf([&] { core::writeMesh(file("w.amf"), mesh); });
    QVERIFY(error && error->kind == Kind::NotWritten && error->token == "amf");
    QVERIFY(!std::filesystem::exists(file("w.amf")));
    QVERIFY(core::readMetadata(file("a.amf")).palette.empty());
    QVERIFY(core::parseMesh("a.amf", amfOf(amfObject("1"))).triangles.size() == 4);
}

void TestAmf::badFiles_areRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<FileFault>("fault");
    QTest::addColumn<QString>("token");
    QTest::addColumn<int>("line");
    const auto row = [](const char* name, const std::string& text, Kind kind, FileFault fault, const char* token,
                        int line) {
        QTest::newRow(name) << QByteArray::fromStdString(text) << kind << fault << QString(token) << line;
    };
    const std::string good = amfOf(amfObject("1"));
    const auto wrong = [&good](std::string_view from, std::string_view to) { return edited(good, from, to); };
    row("unit", amfOf(amfObject("1"), "unit=\"furlong\""), Kind::Malformed, FileFault::LengthUnit, "furlong", 2);
    row("other XML", wrong("<amf", "<x3d"), Kind::Malformed, FileFault::Keyword, "x3d", 2);
    row("laughs", wrong("<amf", "<!DOCTYPE amf [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]><amf"),
        Kind::Malformed, FileFault::XmlDocumentType, "", 2);
    row("a file from outside", wrong("<amf", "<!DOCTYPE amf [<!ENTITY a SYSTEM \"file:///etc/passwd\">]><amf"),
        Kind::Malformed, FileFault::XmlDocumentType, "", 2);
    row("tags crossed", wrong("</x>", "</y>"), Kind::Malformed, FileFault::XmlSyntax, "mismatched tag", 3);
    row("comma", wrong("<y> +2.0", "<y>2,0"), Kind::NotANumber, FileFault::None, "2,0", 5);
    row("nan", wrong("<x>0", "<x>nan"), Kind::NotANumber, FileFault::None, "nan", 3);
    row("too large", wrong("<x>0", "<x>1e39"), Kind::NotANumber, FileFault::None, "1e39", 3);
    row("two numbers", wrong("<x>0", "<x>0 1"), Kind::NotANumber, FileFault::None, "0 1", 3);
    row("no number", wrong("<x>0", "<x>"), Kind::NotANumber, FileFault::None, "", 3);
    row("an element in a number", wrong("<x>0", "<x>0<a/>"), Kind::NotANumber, FileFault::None, "", 3);
    row("a long number", wrong("<x>0", "<x>" + std::string(5'000'000, '0')), Kind::NotANumber, FileFault::None,
        std::string(40, '0').c_str(), 3);
    row("no z", wrong("<z>0</z>", ""), Kind::Malformed, FileFault::Missing, "z", 3);
    row("no coordinates", wrong("<vertex>", "<vertex/><vertex>"), Kind::Malformed, FileFault::Missing, "x", 3);
    row("no third corner", wrong("<v3>1</v3>", ""), Kind::Malformed, FileFault::Missing, "v3", 8);
    row("index too large", wrong("<v2>2", "<v2>4"), Kind::IndexOutOfRange, FileFault::None, "4", 8);
    row("index much too large", wrong("<v2>2", "<v2>4294967295"), Kind::IndexOutOfRange, FileFault::None, "4294967295",
        8);
    row("index of 33 bits", wrong("<v2>2", "<v2>4294967296"), Kind::NotANumber, FileFault::None, "4294967296", 8);
    row("negative index", wrong("<v2>2", "<v2>-1"), Kind::NotANumber, FileFault::None, "-1", 8);
    row("broken index", wrong("<v2>2", "<v2>1.5"), Kind::NotANumber, FileFault::None, "1.5", 8);
    row("no vertices", amfOf(amfObject("1", "<mesh><volume>" + AmfTetrahedron().triangles() + "</volume></mesh>")),
        Kind::IndexOutOfRange, FileFault::None, "3", 3);
    row("the same id", amfOf(amfObject("1") + amfObject("1")), Kind::Malformed, FileFault::Repeated, "id", 9);
    row("the same id, constellations", amfOf(amfConstellation("1", {}) + amfConstellation("1", {})), Kind::Malformed,
        FileFault::Repeated, "id", 4);
    const auto placed = [](const std::string& instances) {
        return amfOf(amfObject("1") + amfConstellation("2", instances));
    };
    row("no such object", placed(amfInstance("1") + amfInstance("3")), Kind::Malformed, FileFault::Missing,
        "objectid 3", 10);
    row("no object", placed(edited(amfInstance("1"), "objectid", "id")), Kind::Malformed, FileFault::Missing,
        "objectid", 9);
    row("turned by nothing", placed(amfInstance("1", "<rx>a</rx>")), Kind::NotANumber, FileFault::None, "a", 9);
    row("too far", placed(amfInstance("1", "<deltax>1e39</deltax>")), Kind::NotANumber, FileFault::None, "", 0);
    row("in itself", placed(amfInstance("1") + amfInstance("2")), Kind::Malformed, FileFault::TooDeep, "constellations",
        10);
    row("in each other", placed(amfInstance("3")) + "", Kind::Malformed, FileFault::Missing, "objectid 3", 9);
    row("in a circle",
        amfOf(amfObject("1") + amfConstellation("2", amfInstance("3")) +
              amfConstellation("3", amfInstance("1") + amfInstance("4")) + amfConstellation("4", amfInstance("2"))),
        Kind::Malformed, FileFault::TooDeep, "constellations", 14);
    std::string chain = amfObject("0"), reversed;
    for (int i = 1; i < 100; ++i) {
        const std::string link = amfConstellation(std::to_string(i), amfInstance(std::to_string(i - 1)));
        chain += link;
        reversed.insert(0, link);
    }
    row("a long chain", amfOf(chain), Kind::Malformed, FileFault::TooDeep, "constellations", 77);
    row("a long chain, backwards", amfOf(reversed + amfObject("0")), Kind::Malformed, FileFault::TooDeep,
        "constellations", 131);
    row("nothing", amfOf({}), Kind::NoFaces, FileFault::None, "", 0);
    row("no volume", amfOf(amfObject("1", "<mesh><vertices>" + AmfTetrahedron().vertices() + "</vertices></mesh>")),
        Kind::NoFaces, FileFault::None, "", 0);
    std::string deep = "<amf>";
    for (int i = 0; i < 100'000; ++i)
        deep += "<a>";
    row("deep", deep, Kind::Malformed, FileFault::XmlTooDeep, "", 1);
    row("a long tag", wrong("<mesh>", "<mesh" + std::string(3'000'000, ' ') + ">"), Kind::Malformed,
        FileFault::XmlLongTag, "", 3);
    std::string instances;
    for (int i = 0; i < 70'000; ++i)
        instances += amfInstance("1");
    row("very many instances", placed(instances), Kind::TooManyElements, FileFault::None, "instances", 65'545);
}

void TestAmf::badFiles_areRefused()
{
    QFETCH(QByteArray, text);
    QFETCH(Kind, kind);
    const auto error = errorOf([&] { read(text.toStdString()); });
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->kind), static_cast<int>(kind));
    QTEST(error->fault, "fault");
    QTEST(QString::fromStdString(error->token), "token");
    QTEST(error->place.unit == core::FilePlace::Unit::Line ? static_cast<int>(error->place.number) : 0, "line");
    const auto again = errorOf([&] { read(zipped({{"a.amf", text.toStdString()}})); });
    QVERIFY(again && again->kind == error->kind && again->token == error->token && again->place == error->place);
}

void TestAmf::badZips_areRefused()
{
    const auto refused = [this](const Entries& entries) { return errorOf([&] { read(zipped(entries)); }); };
    const auto none = refused({{"a.stl", "solid"}, {"b.xml", "<x/>"}});
    QVERIFY(none && none->fault == FileFault::NotInPackage && none->token == "*.amf");
    const auto picture = refused({{"a.amf", "PNG"}});
    QVERIFY(picture && picture->fault == FileFault::XmlSyntax);
    const auto empty = refused({{"a.amf", ""}});
    QVERIFY(empty && empty->fault == FileFault::XmlSyntax);
    const auto other = errorOf([&] { read("\x89PNG\r\n"); });
    QVERIFY(other && other->kind == Kind::NotWhatItsEndingSays && other->token == "png");
    const auto text = errorOf([&] { read("solid x\nendsolid\n"); });
    QVERIFY(text && text->kind == Kind::NotWhatItsEndingSays);
}

void TestAmf::cutFiles_areRefused()
{
    const std::string plain =
        amfOf(amfObject("1", AmfTetrahedron{.ofVertex = amfColor("1", "0", "0"), .ofTriangle = {}}.mesh()) +
              amfConstellation("2", amfInstance("1", "<rz>90</rz>")));
    for (const std::string& whole : {plain, zipped({{"a.amf", plain}})}) {
        QCOMPARE(enclosedVolume(core::parseMesh("a.amf", whole)), 1.0);
        for (std::size_t length = 0; length + 1 < whole.size(); ++length) // only the final line break may be missing
            QVERIFY2(errorOf([&] { core::parseMesh("a.amf", std::string_view(whole).substr(0, length)); }),
                     qPrintable(QString::number(length)));
    }
}

void TestAmf::bombs_areRefused()
{
    const std::string bomb = amfOf(amfObject("1") + std::string(std::size_t(64) << 20, ' '));
    const auto error = errorOf([&] { read(zipped({{"a.amf", bomb}})); });
    QVERIFY(error && error->kind == Kind::UnpacksTooLarge);
    QCOMPARE(error->expected, std::uint64_t(16) << 20);
    // a large file that is not compressed is no bomb
    QCOMPARE(enclosedVolume(read(zipped({{"a.amf", bomb}}, ZIP_CM_STORE))), 1.0);
    Entries many;
    for (int i = 0; i < 300; ++i)
        many.emplace_back(std::to_string(i) + ".xml", "<x/>" + std::string(1 << 20, ' '));
    const auto none = errorOf([&] { read(zipped(many)); });
    QVERIFY(none && none->kind == Kind::Malformed);
}

void TestAmf::manyCopies_areRefused()
{
    for (const bool isEmpty : {false, true}) {
        std::string content = isEmpty ? amfObject("1", {}) : amfObject("1");
        for (int i = 2; i < 40; ++i) { // each constellation contains the previous one twice
            const std::string before = amfInstance(std::to_string(i - 1));
            content += amfConstellation(std::to_string(i), before + before);
        }
        const auto error = errorOf([&] { read(amfOf(content)); });
        QVERIFY(error && error->kind == Kind::TooManyElements && error->token == "instances");
    }
    // Few instances of a large mesh are refused as well.
    std::string triangles;
    for (int i = 0; i < 500; ++i)
        triangles += AmfTetrahedron().triangles();
    std::string instances;
    for (int i = 0; i < 60'000; ++i)
        instances += "<instance objectid=\"1\"/>";
    const auto error = errorOf([&] {
        read(zipped({{"a.amf", amfOf(amfObject("1", "<mesh><vertices>" + AmfTetrahedron().vertices() +
                                                        "</vertices><volume>" + triangles + "</volume></mesh>") +
                                     amfConstellation("2", instances))}}));
    });
    QVERIFY(error && error->kind == Kind::TooManyElements && error->token == "faces");
}

void TestAmf::mutatedFiles_neverGetThrough()
{
    const int rounds = byEffort(500, 3'000, 200'000);
    const std::string good = amfOf(
        "<material id=\"7\">" + amfColor("1", "1", "0") + "</material>" +
        amfObject("1", AmfTetrahedron{.ofVertex = amfColor("1", "0", "0"), .ofTriangle = amfColor("0", "1", "0")}.mesh(
                           volumeMetadata("volume_type", "ModelPart"), "7")) +
        amfObject("2", AmfTetrahedron().mesh(volumeMetadata("modifier", "1"))) +
        amfConstellation("3", amfInstance("1", "<deltax>1</deltax><rz>90</rz>") + amfInstance("2")));
    const std::vector<std::string> words{"-1",
                                         "0",
                                         "4294967295",
                                         "1e99",
                                         "nan",
                                         "\"",
                                         "<",
                                         ">",
                                         "/>",
                                         "<!--",
                                         "</object>",
                                         "</mesh>",
                                         "<mesh>",
                                         "<vertices>",
                                         "</volume><volume>",
                                         "<object id=\"1\">",
                                         "<instance objectid=\"3\"/>",
                                         "<triangle><v1>0</v1><v2>1</v2><v3>2</v3></triangle>",
                                         "&lt;",
                                         "&#0;",
                                         std::string(1, '\0'),
                                         "\xff\xfe",
                                         "]]>",
                                         "<?x?>"};
    std::mt19937 engine(seed);
    int refused = 0;
    for (int round = 0; round < rounds; ++round) {
        const std::string text = mutated(good, words, engine);
        const auto error = errorOf([&] {
            const TriangleMesh mesh = core::parseMesh("a.amf", text);
            for (const core::Triangle& t : mesh.triangles)
                for (const core::Slot corner : t)
                    QVERIFY2(corner < mesh.points.size(), qPrintable(QStringLiteral("round %1").arg(round)));
            for (const Vec3f& p : mesh.points)
                QVERIFY(p.allFinite());
            QVERIFY(mesh.colors.empty() || mesh.colors.size() == mesh.points.size());
        });
        refused += error.has_value();
    }
    qInfo("%d of %d refused, seed %u", refused, rounds, seed);
}

FETTLE_TEST(TestAmf, QCoreApplication)
#include "tst_amf.moc"
