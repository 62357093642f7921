// Tests 3MF packages of other programs: units, components, colours, parts in several files. Hostile packages must be
// refused.

#include "core/io/mesh_io.h"
#include "core/util/file_error.h"
#include "tests/core/io/text_mutation.h"
#include "tests/support/effort.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QTest>

#include <zip.h>

#include <clocale>
#include <fstream>
#include <map>
#include <random>

namespace
{
using core::FileError;
using core::Rgb;
using core::TriangleMesh;
using core::UpAxis;
using core::Vec3f;
using Kind = core::FileErrorKind;
using Parts = std::map<std::string, std::string>;

const std::string relationships =
    R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship )"
    R"(Target="/3D/a.model" Id="x" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>)"
    R"(</Relationships>)";
const std::string modelHead =
    R"(xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" )"
    R"(xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02" )"
    R"(xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06" requiredextensions="p")";

/// Returns a right-angled tetrahedron. `more` is inserted into each of its triangles.
std::string mesh(const std::string& more = {})
{
    std::string text =
        R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y=" +2.0 " z="0"/>)"
        R"(<vertex x="0" y="0" z="3e0"/></vertices><triangles>)";
    for (const char* corners :
         {R"(v1="0" v2="2" v3="1")", R"(v1="0" v2="1" v3="3")", R"(v1="0" v2="3" v3="2")", R"(v1="1" v2="2" v3="3")"})
        text += std::string("<triangle ") + corners + " " + more + "/>";
    return text + "</triangles></mesh>";
}

std::string model(const std::string& resources, const std::string& items, const std::string& attributes = {})
{
    return "<?xml version=\"1.0\"?><model " + modelHead + " " + attributes + "><resources>" + resources +
           "</resources><build>" + items + "</build></model>";
}

std::string object(int id, const std::string& content, const std::string& attributes = {})
{
    return "<object id=\"" + std::to_string(id) + "\" " + attributes + ">" + content + "</object>";
}

std::string item(int id, const std::string& attributes = {})
{
    return "<item objectid=\"" + std::to_string(id) + "\" " + attributes + "/>";
}

double volume(const TriangleMesh& mesh)
{
    double six = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        six += mesh.points[a].cast<double>().dot(mesh.points[b].cast<double>().cross(mesh.points[c].cast<double>()));
    return six / 6;
}

Vec3f largest(const TriangleMesh& mesh)
{
    Vec3f most = mesh.points.front();
    for (const Vec3f& p : mesh.points)
        most = most.cwiseMax(p);
    return most;
}
} // namespace

class TestThreeMf : public QObject
{
    Q_OBJECT

    static constexpr unsigned seed = 20261122;

private Q_SLOTS:
    void initTestCase() { QVERIFY(m_dir.isValid()); }

    void units_becomeMillimetres_data();
    void units_becomeMillimetres();
    void components_areTransformed();
    void mirroredComponents_stayOutward();
    void partsElsewhere_areRead();
    void partsElsewhere_haveTheirUnits();
    void supports_areLeftOut();
    void meshesOfCura_areLeftOut();
    void pointsBesideOthers_areLeftOut();
    void colors_areRead();
    void sameModel_givesSameBytes();
    void insideAnApplication_withCommas_bitsStay();

    void badPackages_areRefused_data();
    void badPackages_areRefused();
    void bombs_areRefused();
    void manyCopies_areRefused();
    void mutatedModels_neverGetThrough();

private:
    std::filesystem::path file(const std::string& name) const
    {
        return std::filesystem::path(m_dir.path().toStdString()) / name;
    }
    std::filesystem::path package(const Parts& parts, int packing = ZIP_CM_DEFLATE) const;
    TriangleMesh read(const std::string& model) const
    {
        return core::readMesh(package({{"_rels/.rels", relationships}, {"3D/a.model", model}}), {.up = UpAxis::Y});
    }
    static std::optional<FileError> errorOf(const std::function<void()>& action);

    QTemporaryDir m_dir;
};

std::filesystem::path TestThreeMf::package(const Parts& parts, int packing) const
{
    const auto path = file("a.3mf");
    std::filesystem::remove(path);
    zip* const archive = zip_open(path.c_str(), ZIP_CREATE, nullptr);
    for (const auto& [name, text] : parts) {
        const auto index =
            zip_file_add(archive, name.c_str(), zip_source_buffer(archive, text.data(), text.size(), 0), 0);
        zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), packing, 0);
    }
    zip_close(archive);
    return path;
}

std::optional<FileError> TestThreeMf::errorOf(const std::function<void()>& action)
{
    try {
        action();
    } catch (const FileError& error) {
        return error;
    }
    return std::nullopt;
}

void TestThreeMf::units_becomeMillimetres_data()
{
    QTest::addColumn<QString>("attribute");
    QTest::addColumn<double>("millimetres");
    QTest::newRow("none") << "" << 1.0;
    for (const auto& [name, millimetres] : std::initializer_list<std::pair<const char*, double>>{{"micron", 0.001},
                                                                                                 {"millimeter", 1},
                                                                                                 {"centimeter", 10},
                                                                                                 {"inch", 25.4},
                                                                                                 {"foot", 304.8},
                                                                                                 {"meter", 1000}})
        QTest::newRow(name) << QStringLiteral("unit=\"%1\"").arg(QLatin1StringView(name)) << millimetres;
}

void TestThreeMf::units_becomeMillimetres()
{
    QFETCH(QString, attribute);
    QFETCH(double, millimetres);
    const TriangleMesh read = this->read(model(object(1, mesh()), item(1), attribute.toStdString()));
    QCOMPARE(read.points.size(), std::size_t(4));
    const Vec3f wanted(static_cast<float>(millimetres), static_cast<float>(2 * millimetres),
                       static_cast<float>(3 * millimetres));
    QVERIFY(largest(read) == wanted);
    const TriangleMesh turned = core::readMesh(file("a.3mf"));
    QVERIFY(turned.points[3] == Vec3f(0, wanted.z(), 0)); // 3MF has Z up, the mesh Y up
}

void TestThreeMf::components_areTransformed()
{
    // The model has a tetrahedron and a copy 10 units away. Both are rotated by 90 degrees about z (x becomes y) and
    // scaled by 2.
    const std::string parts = R"(<components><component objectid="1"/>)"
                              R"(<component objectid="1" transform="1 0 0 0 1 0 0 0 1 10 0 0"/></components>)";
    const std::string turned = item(2, R"(transform="0 2 0 -2 0 0  0 0 2)"
                                       "\t"
                                       R"(5 0 0 ")");
    const TriangleMesh read = this->read(model(object(1, mesh()) + object(2, parts), turned));
    QCOMPARE(read.triangles.size(), std::size_t(8));
    QCOMPARE(volume(read), 16.0);
    QVERIFY(read.points[1] == Vec3f(5, 2, 0));
    QVERIFY(read.points[4] == Vec3f(5, 20, 0));
}

void TestThreeMf::mirroredComponents_stayOutward()
{
    const TriangleMesh read = this->read(model(object(1, mesh()), item(1, R"(transform="-1 0 0 0 1 0 0 0 1 0 0 0")")));
    QCOMPARE(volume(read), 1.0);
}

void TestThreeMf::partsElsewhere_areRead()
{
    const std::string root =
        model(object(1, R"(<components><component p:path="/3D/Objects/b.model" objectid="7"/></components>)"), item(1));
    const auto path = package(
        {{"_rels/.rels", relationships}, {"3D/a.model", root}, {"3D/Objects/b.model", model(object(7, mesh()), "")}});
    QCOMPARE(volume(core::readMesh(path)), 1.0);
}

/// A mesh is in the unit of its own model file, its placement in the unit of the file that contains the component.
void TestThreeMf::partsElsewhere_haveTheirUnits()
{
    const auto other = [](const char* name, int id, const char* at) {
        return std::string("<components><component p:path=\"/3D/") + name + "\" objectid=\"" + std::to_string(id) +
               "\" transform=\"1 0 0 0 1 0 0 0 1 " + at + " 0 0\"/></components>";
    };
    const auto path =
        package({{"_rels/.rels", relationships},
                 {"3D/a.model", model(object(1, other("b.model", 2, "7")), item(1), "unit=\"centimeter\"")},
                 {"3D/b.model", model(object(2, other("c.model", 3, "5")), "", "unit=\"meter\"")},
                 {"3D/c.model", model(object(3, mesh()), "")}}); // without a unit attribute: millimetres
    const TriangleMesh read = core::readMesh(path, {.up = UpAxis::Y});
    QVERIFY(read.points[0] == Vec3f(70 + 5000, 0, 0));
    QVERIFY(largest(read) == Vec3f(70 + 5000 + 1, 2, 3));
}

void TestThreeMf::supports_areLeftOut()
{
    const auto typed = [](int id, const std::string& type) { return object(id, mesh(), "type=\"" + type + "\""); };
    const std::string objects = object(1, mesh()) + typed(2, "support") + typed(3, "other") + typed(4, "solidsupport") +
                                typed(5, "surface") + typed(6, "model");
    std::string items = item(2) + item(4);
    for (const int id : {1, 3, 5, 6})
        items += item(id, "transform=\"1 0 0 0 1 0 0 0 1 " + std::to_string(9 * id) + " 0 0\"");
    const TriangleMesh read = this->read(model(objects, items));
    QCOMPARE(read.triangles.size(), std::size_t(12));
    QVERIFY(largest(read).x() == 9 * 6 + 1);
    QCOMPARE(core::readModel(file("a.3mf")).remarks.otherParts, std::size_t(3));
}

/// Cura keeps supports, and meshes that change the settings around them, as objects of the type model.
void TestThreeMf::meshesOfCura_areLeftOut()
{
    const auto set = [](const std::string& name, const std::string& value) {
        return "<metadatagroup><metadata name=\"cura:" + name + "\" type=\"xs:string\">" + value +
               "</metadata></metadatagroup>";
    };
    const std::string older = "<c:settings xmlns:c=\"http://software.ultimaker.com/xml/cura/3mf/2015/10\"><c:setting "
                              "key=\"infill_mesh\">True</c:setting></c:settings>";
    std::string objects, items;
    int id = 0;
    for (const std::string& settings :
         {set("support_mesh", "True"), set("anti_overhang_mesh", "True"), set("infill_mesh", "True"),
          set("cutting_mesh", "True"), older, set("support_mesh", "False"), set("infill_sparse_density", "True"),
          std::string()}) {
        objects += object(++id, settings + mesh());
        items += item(id, "transform=\"1 0 0 0 1 0 0 0 1 " + std::to_string(9 * id) + " 0 0\"");
    }
    read(model(objects, items));
    const core::ReadResult result = core::readModel(file("a.3mf"));
    QCOMPARE(result.mesh.triangles.size(), std::size_t(12));
    QCOMPARE(result.remarks.otherParts, std::size_t(5));
}

/// Tests that an object scaled to a single point is removed with its faces, while another object is read.
void TestThreeMf::pointsBesideOthers_areLeftOut()
{
    const TriangleMesh read =
        this->read(model(object(1, mesh()), item(1) + item(1, R"(transform="0 0 0 0 0 0 0 0 0 9 0 0")")));
    QCOMPARE(volume(read), 1.0);
    QCOMPARE(read.triangles.size(), std::size_t(4));
}

void TestThreeMf::colors_areRead()
{
    const std::string group =
        R"(<m:colorgroup id="5"><m:color color="#FF0000"/><m:color color="#0080FF80"/></m:colorgroup>)";
    const std::string materials = R"(<basematerials id="6"><base name="a" displaycolor="#010203"/></basematerials>)";
    const auto colorsOf = [&](const std::string& objectAttributes, const std::string& triangleAttributes) {
        return read(model(group + materials + object(1, mesh(triangleAttributes), objectAttributes), item(1))).colors;
    };
    const Rgb red{255, 0, 0}, blue{0, 128, 255}, material{1, 2, 3};
    QVERIFY(colorsOf("", "").empty());
    QVERIFY(colorsOf(R"(pid="5" pindex="1")", "") == std::vector<Rgb>(4, blue));
    QVERIFY(colorsOf(R"(pid="5" pindex="1")", R"(p1="0")") == std::vector<Rgb>(4, red));
    QVERIFY(colorsOf(R"(pid="5" pindex="1")", R"(pid="6" p1="0")") == std::vector<Rgb>(4, material));
    QVERIFY(colorsOf("", R"(pid="6" p1="9")").empty());
    QVERIFY(colorsOf("", R"(pid="9" p1="0")").empty());
    const std::vector<Rgb> mixed = colorsOf("", R"(pid="5" p1="0" p2="1" p3="1")");
    QVERIFY(mixed[0] == red);               // first corner of each of its three triangles
    QVERIFY(mixed[2] == blue);              // never the first corner
    QCOMPARE(mixed[1].r, std::uint8_t(85)); // first corner of one of its three triangles
}

void TestThreeMf::sameModel_givesSameBytes()
{
    const auto bytes = [this](const char* name) {
        core::writeMesh(file(name), core::icosphere(3, 10));
        std::ifstream stream(file(name), std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(stream), {});
    };
    QVERIFY(bytes("one.3mf") == bytes("two.3mf"));
}

/// Tests the locale of a QCoreApplication, which adopts the one of the environment.
void TestThreeMf::insideAnApplication_withCommas_bitsStay()
{
    QVERIFY(QCoreApplication::instance());
    const std::string before = std::setlocale(LC_ALL, nullptr);
    const bool hasCommas = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
    std::mt19937 engine(seed);
    TriangleMesh wanted = core::icosphere(3, 10);
    for (Vec3f& p : wanted.points) {
        p += 0.001F * Vec3f(static_cast<float>(engine() % 997), static_cast<float>(engine() % 991),
                            static_cast<float>(engine() % 983));
        wanted.colors.push_back({std::uint8_t(engine()), std::uint8_t(engine()), std::uint8_t(engine())});
    }
    core::writeMesh(file("commas.3mf"), wanted);
    const TriangleMesh read = core::readMesh(file("commas.3mf"));
    std::setlocale(LC_ALL, before.c_str());
    QVERIFY(read.points == wanted.points && read.triangles == wanted.triangles && read.colors == wanted.colors);
    if (!hasCommas)
        qInfo("de_DE.UTF-8 is not installed: tried without commas");
}

void TestThreeMf::badPackages_areRefused_data()
{
    QTest::addColumn<QByteArray>("relations");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<QString>("token");
    const auto row = [](const char* name, Kind kind, const QString& token, const std::string& text,
                        const std::string& relations = relationships) {
        QTest::newRow(name) << QByteArray::fromStdString(relations) << QByteArray::fromStdString(text) << kind << token;
    };
    const std::string good = model(object(1, mesh()), item(1));
    const auto pointing = [](const std::string& to) {
        return std::string(relationships).replace(relationships.find("/3D/a.model"), 11, to);
    };
    row("out of the package", Kind::Malformed, "/../../etc/passwd", good, pointing("/../../etc/passwd"));
    row("to a part that is not there", Kind::Malformed, "etc/passwd", good, pointing("/etc/passwd"));
    row("to nothing", Kind::Malformed, "_rels/.rels", good, R"(<Relationships xmlns="x"/>)");
    row("to another machine", Kind::Malformed, "_rels/.rels", good, pointing("/3D/a.model\" TargetMode=\"External"));
    row("components out of the package", Kind::Malformed, "../b.model",
        model(object(1, R"(<components><component p:path="../b.model" objectid="1"/></components>)"), item(1)));
    row("laughs", Kind::Malformed, "",
        R"(<!DOCTYPE model [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]>)" + good.substr(21));
    row("a file from outside", Kind::Malformed, "",
        R"(<!DOCTYPE model [<!ENTITY a SYSTEM "file:///etc/passwd">]>)" + good.substr(21));
    row("no end", Kind::Malformed, "unclosed token", good.substr(0, good.size() - 9));
    row("not XML", Kind::Malformed, "syntax error", "solid");
    row("unknown unit", Kind::Malformed, "furlong", model(object(1, mesh()), item(1), R"(unit="furlong")"));
    row("unknown type", Kind::Malformed, "type banana", model(object(1, mesh(), R"(type="banana")"), item(1)));
    row("no such object", Kind::Malformed, "objectid 3", model(object(1, mesh()), item(3)));
    row("the same object twice", Kind::Malformed, "id", model(object(1, mesh()) + object(1, mesh()), item(1)));
    row("in itself", Kind::Malformed, "components",
        model(object(1, R"(<components><component objectid="1"/></components>)"), item(1)));
    row("each in the other", Kind::Malformed, "components",
        model(object(1, R"(<components><component objectid="2"/><component objectid="2"/></components>)") +
                  object(2, R"(<components><component objectid="1"/><component objectid="1"/></components>)"),
              item(1)));
    row("nothing to build", Kind::Malformed, "build item", model(object(1, mesh()), ""));
    row("nothing at all", Kind::NoFaces, "", model("", ""));
    row("made a point", Kind::Malformed, "transform",
        model(object(1, mesh()), item(1, R"(transform="0 0 0 0 0 0 0 0 0 9 0 0")")));
    row("made a line", Kind::Malformed, "transform",
        model(object(1, mesh()), item(1, R"(transform="1 2 3 2 4 6 0 0 0 9 0 0")")));
    row("no coordinate", Kind::Malformed, "z",
        model(object(1, R"(<mesh><vertices><vertex x="0" y="0"/></vertices></mesh>)"), item(1)));
    row("nan", Kind::NotANumber, "nan",
        model(object(1, R"(<mesh><vertices><vertex x="nan" y="0" z="0"/></vertices></mesh>)"), item(1)));
    row("commas", Kind::NotANumber, "0,5",
        model(object(1, R"(<mesh><vertices><vertex x="0,5" y="0" z="0"/></vertices></mesh>)"), item(1)));
    row("index", Kind::IndexOutOfRange, "4",
        model(object(1, R"(<mesh><triangles><triangle v1="4" v2="1" v3="0"/></triangles></mesh>)"), item(1)));
    row("negative index", Kind::NotANumber, "-1",
        model(object(1, R"(<mesh><triangles><triangle v1="-1" v2="1" v3="0"/></triangles></mesh>)"), item(1)));
    row("transform of eleven", Kind::NotANumber, "",
        model(object(1, mesh()), item(1, R"(transform="1 0 0 0 1 0 0 0 1 0 0")")));
    row("transform too far", Kind::NotANumber, "",
        model(object(1, mesh()), item(1, R"(transform="1e300 0 0 0 1 0 0 0 1 0 0 0")")));
    std::string deep;
    for (int i = 0; i < 100'000; ++i)
        deep += "<a>";
    row("deep", Kind::Malformed, "", deep);
    row("a long tag", Kind::Malformed, "", "<model " + std::string(3'000'000, ' ') + "/>");
}

void TestThreeMf::badPackages_areRefused()
{
    QFETCH(QByteArray, relations);
    QFETCH(QByteArray, text);
    QFETCH(Kind, kind);
    QFETCH(QString, token);
    const auto path = package({{"_rels/.rels", relations.toStdString()}, {"3D/a.model", text.toStdString()}});
    const auto error = errorOf([&] { core::readMesh(path); });
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->kind), static_cast<int>(kind));
    QCOMPARE(QString::fromStdString(error->token), token);
}

void TestThreeMf::bombs_areRefused()
{
    // Whitespace between elements takes time but no memory.
    const std::string blanks(std::size_t(64) << 20, ' ');
    const std::string bomb = model(object(1, mesh()) + blanks, item(1));
    const auto path = package({{"_rels/.rels", relationships}, {"3D/a.model", bomb}});
    QVERIFY(std::filesystem::file_size(path) < 100'000);
    const auto error = errorOf([&] { core::readMesh(path); });
    QVERIFY(error && error->kind == Kind::UnpacksTooLarge);
    QCOMPARE(error->expected, std::uint64_t(16) << 20);
    // An uncompressed file of the same size is just a large file.
    const auto plain = package({{"_rels/.rels", relationships}, {"3D/a.model", bomb}}, ZIP_CM_STORE);
    QCOMPARE(volume(core::readMesh(plain)), 1.0);
    // Many parts of moderate size must be refused in total.
    Parts parts{{"_rels/.rels", relationships}};
    std::string components;
    for (int i = 0; i < 20; ++i) {
        const std::string name = "3D/" + std::to_string(i) + ".model";
        parts[name] = model(object(1, mesh()) + std::string(4'000'000, ' '), "");
        components += "<component p:path=\"/" + name + "\" objectid=\"1\"/>";
    }
    parts["3D/a.model"] = model(object(1, "<components>" + components + "</components>"), item(1));
    const auto together = errorOf([&] { core::readMesh(package(parts)); });
    QVERIFY(together && together->kind == Kind::UnpacksTooLarge);
}

void TestThreeMf::manyCopies_areRefused()
{
    std::string objects = object(1, mesh());
    for (int i = 2; i < 40; ++i) { // each object contains the previous one twice
        const std::string before = "<component objectid=\"" + std::to_string(i - 1) + "\"/>";
        objects += object(i, "<components>" + before + before + "</components>");
    }
    const auto error = errorOf([&] { read(model(objects, item(39))); });
    QVERIFY(error && error->kind == Kind::TooManyElements);
}

/// Mutates the XML inside an intact package.
void TestThreeMf::mutatedModels_neverGetThrough()
{
    const int rounds = byEffort(300, 1'500, 200'000);
    const std::string group = R"(<m:colorgroup id="5"><m:color color="#FF0000"/></m:colorgroup>)";
    const std::string good = model(group + object(1, mesh(R"(pid="5" p1="0")")) +
                                       object(2, R"(<components><component objectid="1"/></components>)"),
                                   item(2, R"(transform="1 0 0 0 1 0 0 0 1 0 0 0")"));
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
                                         "<mesh>",
                                         "<object id=\"1\">",
                                         "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>",
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
            const TriangleMesh read = this->read(text);
            for (const core::Triangle& t : read.triangles)
                for (const core::Slot corner : t)
                    QVERIFY2(corner < read.points.size(), qPrintable(QStringLiteral("round %1").arg(round)));
            QVERIFY(read.colors.empty() || read.colors.size() == read.points.size());
        });
        refused += error.has_value();
    }
    qInfo("%d of %d refused, seed %u", refused, rounds, seed);
}

FETTLE_TEST(TestThreeMf, QCoreApplication)
#include "tst_threemf.moc"
