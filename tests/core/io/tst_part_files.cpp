#include "tests/support/mesh_asserts.h"
#include "tests/support/test_main.h"

#include "core/analysis/mesh_check.h"
#include "core/io/export_check.h"
#include "core/io/mesh_io.h"
#include "core/mesh/mesh_builder.h"
#include "core/parts/part_split.h"

#include <nlohmann/json.hpp>

#include <QTemporaryDir>
#include <QTest>

#include <zip.h>

#include <cstring>
#include <fstream>
#include <functional>
#include <sstream>

using core::Part;
using core::PartId;
using core::PartList;
using core::ReadResult;
using core::Rgb;
using core::Slot;
using core::TriangleMesh;
using core::Vec3f;

namespace
{
using Json = nlohmann::json;

/// Returns a ball on a lattice whose vertices belong to the part.
core::PartPiece ballOf(PartId part, const core::Vec3& centre)
{
    core::PartPiece piece{part, core::icosphere(2, 10), {}, {}};
    for (Vec3f& p : piece.mesh.points)
        p = core::Lattice(14).snap(p.cast<double>() + centre);
    return piece;
}

/// Returns a list whose order is not that of the ids.
PartList someParts()
{
    return PartList({{7, "Körper", true, false, Rgb{255, 0, 0}},
                     {2, "", false, true, std::nullopt},
                     {4, "Hat \"big\" <&> \t", true, false, std::nullopt}});
}

/// Returns three balls: one twice at the same place, one that overlaps them. Their vertices and faces are mixed.
TriangleMesh someBalls()
{
    const TriangleMesh one = core::joined({ballOf(7, {1, 2, 3}), ballOf(2, {1, 2, 3}), ballOf(4, {6, 2, 3})});
    TriangleMesh mixed = one;
    constexpr std::size_t factor = 5; // coprime to the number of vertices
    std::vector<Slot> places(one.points.size());
    for (std::size_t v = 0; v < one.points.size(); ++v) {
        const std::size_t to = v * factor % one.points.size();
        places[v] = static_cast<Slot>(to);
        mixed.points[to] = one.points[v];
        mixed.parts[to] = one.parts[v];
    }
    for (std::size_t f = 0; f < one.triangles.size(); ++f) {
        const auto& [a, b, c] = one.triangles[f];
        mixed.triangles[one.triangles.size() - 1 - f] = {places[a], places[b], places[c]};
    }
    return mixed;
}

core::DocumentMetadata metadataWith(const PartList& parts)
{
    core::DocumentMetadata metadata;
    metadata.frame = core::MeshFrame{core::Lattice(14), 0.7, core::Vec3::Zero(), parts};
    return metadata;
}

std::string bytesIn(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

constexpr std::size_t jsonStart = 20;

std::uint32_t glbWordAt(const std::string& bytes, std::size_t at)
{
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

Json jsonOf(const std::string& glb)
{
    return Json::parse(glb.substr(jsonStart, glbWordAt(glb, 12)));
}

/// Returns the GLB with its JSON changed.
std::string withJson(const std::string& glb, const std::function<void(Json&)>& change)
{
    Json json = jsonOf(glb);
    change(json);
    std::string text = json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string changed = glb.substr(0, jsonStart) + text + glb.substr(jsonStart + glbWordAt(glb, 12));
    const auto store = [&changed](std::size_t at, std::size_t number) {
        const auto word = static_cast<std::uint32_t>(number);
        std::memcpy(changed.data() + at, &word, sizeof word);
    };
    store(8, changed.size());
    store(12, text.size());
    return changed;
}

/// Returns whether both meshes have the same parts with the same triangles, in the same order within each part.
bool haveSameParts(const TriangleMesh& a, const TriangleMesh& b)
{
    const auto as = core::splitByPart(a), bs = core::splitByPart(b);
    return std::ranges::equal(as, bs, [](const core::PartPiece& s, const core::PartPiece& t) {
        return s.part == t.part && s.mesh.points == t.mesh.points && s.mesh.triangles == t.mesh.triangles &&
               s.mesh.colors == t.mesh.colors && s.mesh.masks == t.mesh.masks;
    });
}

std::vector<std::string> namesOf(const PartList& parts)
{
    std::vector<std::string> names;
    for (const Part& part : parts.all())
        names.push_back(part.name);
    return names;
}
} // namespace

class TestPartFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void glb_keepsPartsBitForBit();
    void glb_keepsTheDocument();
    void glb_ofOnePart_isAsBefore();
    void glb_ofOneNamedPart_keepsItsName();
    void glb_withOtherParts_isOneModel_data();
    void glb_withOtherParts_isOneModel();
    void gltfOfOthers_becomesPartsIfWanted();
    void manyParts_comeBack();
    void objects_areTheParts_data();
    void objects_areTheParts();
    void onePart_isWrittenAsBefore_data();
    void onePart_isWrittenAsBefore();
    void threeMf_itemsAreObjects();
    void threeMf_ofManyObjects();
    void obj_pointsOfSeveralObjects_areCopied();
    void amf_objectsAreParts();
    void amf_instancesAreParts();
    void formatsWithoutObjects_keepTheOrder();

private:
    std::filesystem::path file(const char* name) const { return m_folder.filePath(name).toStdString(); }
    void write(const char* name, const std::string& bytes) const
    {
        std::ofstream(file(name), std::ios::binary) << bytes;
    }

    void writeThreeMf(const char* name, const std::string& resources, const std::string& build) const;

    QTemporaryDir m_folder;
};

void TestPartFiles::writeThreeMf(const char* name, const std::string& resources, const std::string& build) const
{
    const std::string relationships =
        R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship )"
        R"(Target="/3D/a.model" Id="x" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>)"
        R"(</Relationships>)";
    const std::string model = "<?xml version=\"1.0\"?><model unit=\"millimeter\" "
                              "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>" +
                              resources + "</resources><build>" + build + "</build></model>";
    int error = 0;
    zip_t* const zip = zip_open(file(name).c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
    QVERIFY(zip);
    const auto add = [zip](const char* part, const std::string& text) {
        zip_file_add(zip, part, zip_source_buffer(zip, text.data(), text.size(), 0), ZIP_FL_ENC_UTF_8);
    };
    add("_rels/.rels", relationships);
    add("3D/a.model", model);
    QCOMPARE(zip_close(zip), 0);
}

void TestPartFiles::glb_keepsPartsBitForBit()
{
    TriangleMesh mesh = someBalls();
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        mesh.colors.push_back({static_cast<std::uint8_t>(v), static_cast<std::uint8_t>(v / 3), 9});
        mesh.masks.push_back(static_cast<std::uint8_t>(v * 7));
    }
    core::writeMesh(file("a.glb"), mesh, {.metadata = metadataWith(someParts())});
    const Json json = jsonOf(bytesIn(file("a.glb")));
    QCOMPARE(json["nodes"].size(), 3U);
    QCOMPARE(json["meshes"].size(), 3U);
    QVERIFY(json["scenes"][0]["nodes"] == Json({0, 1, 2}));
    QCOMPARE(json["nodes"][0]["name"].get<std::string>(), "Körper");
    QCOMPARE(json["nodes"][1]["name"].get<std::string>(), "Part 3");
    QCOMPARE(json["extensions"]["FETTLE_document"]["parts"][0]["tag"].get<std::string>(), "ff0000");

    const ReadResult read = core::readModel(file("a.glb"));
    QVERIFY(read.parts == someParts());
    QVERIFY(haveSameParts(read.mesh, mesh));
    QVERIFY(std::ranges::equal(read.mesh.points, core::inListOrder(mesh, someParts()).points));
    QCOMPARE(read.remarks.objects, 1U);
    QVERIFY(core::checkMesh(read.mesh).printReady());
    QVERIFY(core::readMetadata(file("a.glb")).frame == metadataWith(someParts()).frame);
    QVERIFY(core::checkExport(file("a.glb"), mesh, {}, someParts()).holds());
}

/// Tests that a document of several parts is the same after it has been saved and opened.
void TestPartFiles::glb_keepsTheDocument()
{
    const core::BuildResult first = core::buildMesh(someBalls(), true, {}, metadataWith(someParts()).frame);
    QVERIFY(first.mesh);
    core::DocumentMetadata metadata;
    metadata.frame = first.mesh->frame();
    core::writeMesh(file("a.glb"), core::extractMesh(*first.mesh), {.metadata = metadata});
    const core::BuildResult again =
        core::buildMesh(core::readMesh(file("a.glb")), true, {}, core::readMetadata(file("a.glb")).frame);
    QVERIFY(again.mesh);
    QVERIFY(again.mesh->frame() == first.mesh->frame());
    QCOMPARE(again.mesh->meshHash(), first.mesh->meshHash());
}

void TestPartFiles::glb_ofOnePart_isAsBefore()
{
    const TriangleMesh mesh = ballOf(0, {1, 2, 3}).mesh;
    core::writeMesh(file("a.glb"), mesh);
    const std::string plain = bytesIn(file("a.glb"));
    const Json json = jsonOf(plain);
    QVERIFY(!json.contains("extensions") && !json["nodes"][0].contains("name"));
    core::writeMesh(file("a.glb"), mesh, {.parts = PartList()});
    QVERIFY(bytesIn(file("a.glb")) == plain);
    TriangleMesh labelled = mesh;
    labelled.parts.resize(mesh.points.size(), 0);
    core::writeMesh(file("a.glb"), labelled);
    QVERIFY(bytesIn(file("a.glb")) == plain);
    core::writeMesh(file("a.glb"), mesh, {.metadata = metadataWith(PartList())});
    QVERIFY(!jsonOf(bytesIn(file("a.glb")))["extensions"]["FETTLE_document"].contains("parts"));
}

void TestPartFiles::glb_ofOneNamedPart_keepsItsName()
{
    for (const PartId id : {PartId(0), PartId(12)}) {
        const PartList parts({{id, "Head", false, true, Rgb{1, 2, 3}}});
        const TriangleMesh mesh = core::joined({ballOf(id, {0, 0, 0})});
        core::writeMesh(file("a.glb"), mesh, {.parts = parts});
        const ReadResult read = core::readModel(file("a.glb"));
        QVERIFY(read.parts == parts);
        QVERIFY(haveSameParts(read.mesh, mesh));
    }
}

void TestPartFiles::glb_withOtherParts_isOneModel_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("value");
    const std::string parts = "/extensions/FETTLE_document/parts";
    const auto row = [](const char* name, const std::string& path, const char* value) {
        QTest::newRow(name) << QString::fromStdString(path) << QString::fromLatin1(value);
    };
    row("no list", parts, "3");
    row("empty list", parts, "[]");
    row("fewer parts", parts, "[{\"id\": 0, \"name\": \"\", \"visible\": true, \"locked\": false}]");
    row("same id twice", parts + "/1/id", "7");
    row("negative id", parts + "/1/id", "-1");
    row("large id", parts + "/1/id", "65536");
    row("broken id", parts + "/1/id", "1.5");
    row("no id", parts + "/1/id", "null");
    row("no name", parts + "/1/name", "[]");
    row("no visibility", parts + "/1/visible", "1");
    row("no lock", parts + "/1/locked", "\"false\"");
    row("no colour", parts + "/1/tag", "\"red\"");
    row("other version", "/extensions/FETTLE_document/version", "2");
    row("invisible node", "/scenes/0/nodes", "[0, 1]");
    row("node more", "/nodes/3", "{\"mesh\": 0}");
}

/// Tests damaged lists of parts, and lists that do not fit the model because another program has changed it.
void TestPartFiles::glb_withOtherParts_isOneModel()
{
    QFETCH(QString, path);
    QFETCH(QString, value);
    TriangleMesh mesh = someBalls();
    core::writeMesh(file("a.glb"), mesh, {.metadata = metadataWith(someParts())});
    write("b.glb", withJson(bytesIn(file("a.glb")), [&](Json& json) {
              const Json::json_pointer place(path.toStdString());
              if (path == QStringLiteral("/nodes/3"))
                  json["nodes"].push_back(Json::parse(value.toStdString()));
              else
                  json[place] = Json::parse(value.toStdString());
          }));
    const ReadResult read = core::readModel(file("b.glb"));
    QVERIFY(read.parts == PartList());
    QVERIFY(read.mesh.parts.empty());
    QVERIFY(read.remarks.objects > 1);
}

void TestPartFiles::gltfOfOthers_becomesPartsIfWanted()
{
    const TriangleMesh mesh = someBalls();
    core::writeMesh(file("a.glb"), mesh, {.metadata = metadataWith(someParts())});
    std::string longName(10'000, 'x');
    write("b.glb", withJson(bytesIn(file("a.glb")), [&](Json& json) {
              json.erase("extensions");
              json.erase("extensionsUsed");
              json["nodes"][0]["name"] = longName;
              json["nodes"][1]["name"] = "\x01 a\nb\xef\xbf\xbf";
              json["nodes"][2].erase("name");
          }));
    const ReadResult one = core::readModel(file("b.glb"));
    QVERIFY(one.mesh.parts.empty() && one.parts == PartList());
    QCOMPARE(one.remarks.objects, 3U);
    QVERIFY(one.mesh.points.size() < mesh.points.size()); // the points of the duplicate were merged

    const ReadResult read = core::readModel(file("b.glb"), {.keepsObjects = true});
    longName.resize(PartList::maxNameBytes);
    QVERIFY(namesOf(read.parts) == std::vector<std::string>({longName, "a b", ""}));
    QCOMPARE(read.mesh.points.size(), mesh.points.size());
    TriangleMesh expected = mesh;
    for (PartId& part : expected.parts)
        part = part == 7 ? 0 : part == 2 ? 1 : 2;
    QVERIFY(haveSameParts(read.mesh, expected));
}

void TestPartFiles::manyParts_comeBack()
{
    std::vector<core::PartPiece> pieces;
    std::vector<Part> parts;
    for (std::size_t i = 0; i < PartList::maxParts; ++i) {
        const auto id = static_cast<PartId>(core::maxPartId - i);
        pieces.push_back({id, core::icosphere(0, 1), {}, {}});
        parts.push_back({id, std::string(PartList::maxNameBytes, '\x02'), i % 2 == 0, false, Rgb{1, 2, 3}});
    }
    const TriangleMesh mesh = core::joined(pieces);
    core::writeMesh(file("a.glb"), mesh, {.metadata = metadataWith(PartList(parts))});
    const ReadResult read = core::readModel(file("a.glb"));
    QVERIFY(read.parts == PartList(parts));
    QVERIFY(haveSameParts(read.mesh, mesh));
    QVERIFY(core::readMetadata(file("a.glb")).frame->parts == PartList(parts));
}

void TestPartFiles::objects_areTheParts_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("isColored");
    for (const char* name : {"a.3mf", "a.obj"})
        for (const bool isColored : {false, true})
            QTest::addRow("%s%s", name, isColored ? ", colours" : "") << QString::fromLatin1(name) << isColored;
}

/// Tests that each part is an object with its name, where it was, in the order of the list.
void TestPartFiles::objects_areTheParts()
{
    QFETCH(QString, name);
    QFETCH(bool, isColored);
    const QByteArray path = name.toLatin1();
    TriangleMesh mesh = someBalls();
    for (std::size_t v = 0; isColored && v < mesh.points.size(); ++v)
        mesh.colors.push_back({static_cast<std::uint8_t>(v), static_cast<std::uint8_t>(v / 3), 9});
    core::writeMesh(file(path.constData()), mesh, {.metadata = metadataWith(someParts())});

    const ReadResult one = core::readModel(file(path.constData()));
    QVERIFY(one.mesh.parts.empty() && one.parts == PartList());
    QCOMPARE(one.remarks.objects, 3U);

    const ReadResult read = core::readModel(file(path.constData()), {.keepsObjects = true});
    QVERIFY(namesOf(read.parts) == std::vector<std::string>({"Körper", "Part 3", "Hat \"big\" <&>"}));
    QCOMPARE(read.remarks.objects, 1U);
    TriangleMesh expected = mesh;
    for (PartId& part : expected.parts)
        part = part == 7 ? 0 : part == 2 ? 1 : 2;
    QVERIFY(haveSameParts(read.mesh, expected));
    QVERIFY(core::checkMesh(read.mesh).printReady());
    QVERIFY(core::checkExport(file(path.constData()), mesh, {}, someParts()).holds());
}

void TestPartFiles::onePart_isWrittenAsBefore_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"a.stl", "a.obj", "a.ply", "a.off", "a.glb", "a.3mf"})
        QTest::addRow("%s", name) << QString::fromLatin1(name);
}

void TestPartFiles::onePart_isWrittenAsBefore()
{
    QFETCH(QString, name);
    const QByteArray path = name.toLatin1();
    const TriangleMesh mesh = ballOf(0, {1, 2, 3}).mesh;
    core::writeMesh(file(path.constData()), mesh);
    const std::string plain = bytesIn(file(path.constData()));
    TriangleMesh labelled = mesh;
    labelled.parts.resize(mesh.points.size(), 0);
    core::writeMesh(file(path.constData()), labelled, {.parts = someParts()});
    QVERIFY(bytesIn(file(path.constData())) == plain);
    const ReadResult read = core::readModel(file(path.constData()), {.keepsObjects = true});
    QVERIFY(read.mesh.parts.empty() && read.parts == PartList());
}

/// Tests that the components of an item of the build belong to one object, and that each item is an object of its own.
void TestPartFiles::threeMf_itemsAreObjects()
{
    const std::string solid =
        R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="2" z="0"/>)"
        R"(<vertex x="0" y="0" z="3"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/>)"
        R"(<triangle v1="0" v2="1" v3="3"/><triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/>)"
        R"(</triangles></mesh>)";
    const std::string longName(10'000, 'n');
    writeThreeMf("a.3mf",
                 "<object id=\"1\" name=\"" + longName + "\">" + solid +
                     "</object><object id=\"2\" name=\"Pair&#9;\"><components><component objectid=\"1\"/>"
                     "<component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/></components></object>",
                 "<item objectid=\"2\"/><item objectid=\"1\"/>"
                 "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 9 0\"/>");
    const ReadResult read = core::readModel(file("a.3mf"), {.keepsObjects = true});
    const std::string cut(PartList::maxNameBytes, 'n');
    QVERIFY(namesOf(read.parts) == std::vector<std::string>({"Pair", cut, cut}));
    const auto pieces = core::splitByPart(read.mesh);
    QCOMPARE(pieces.size(), 3U);
    QCOMPARE(pieces[0].mesh.triangles.size(), 8U);
    QCOMPARE(pieces[1].mesh.triangles.size(), 4U);
    QCOMPARE(pieces[2].mesh.triangles.size(), 4U);
}

void TestPartFiles::threeMf_ofManyObjects()
{
    for (const std::size_t count : {std::size_t(500), PartList::maxParts + 1}) {
        std::vector<core::PartPiece> pieces;
        for (std::size_t i = 0; i < count; ++i) {
            pieces.push_back({static_cast<PartId>(i), core::icosphere(0, 1), {}, {}});
            for (Vec3f& p : pieces.back().mesh.points)
                p.x() += static_cast<float>(3 * i);
        }
        const bool fits = count <= PartList::maxParts;
        std::string objects, items;
        for (std::size_t i = 0; i < count; ++i) {
            const std::string id = std::to_string(i + 1);
            objects += i > 0 ? ""
                             : "<object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/>"
                               "<vertex x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"1\" z=\"0\"/></vertices>"
                               "<triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh></object>";
            items += "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 " + id + " 0 0\"/>";
        }
        writeThreeMf("b.3mf", objects, items);
        const ReadResult read = core::readModel(file("b.3mf"), {.keepsObjects = true});
        QCOMPARE(read.mesh.triangles.size(), count);
        QCOMPARE(read.parts.size(), fits ? count : 1U);
        QCOMPARE(read.mesh.parts.empty(), !fits);
        if (!fits)
            continue;
        const TriangleMesh mesh = core::joined(pieces);
        core::writeMesh(file("c.3mf"), mesh);
        QVERIFY(haveSameParts(core::readModel(file("c.3mf"), {.keepsObjects = true}).mesh, mesh));
    }
}

void TestPartFiles::obj_pointsOfSeveralObjects_areCopied()
{
    write("a.obj",
          "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1 0 1 0\no  First one \nf 1 2 3\no Second\nf 4 3 2\nf 4 2 1\n"
          "g no object\nf 1 3 4\no\n");
    const ReadResult one = core::readModel(file("a.obj"));
    QCOMPARE(one.mesh.points.size(), 4U);
    const ReadResult read = core::readModel(file("a.obj"), {.keepsObjects = true});
    QVERIFY(namesOf(read.parts) == std::vector<std::string>({"First one", "Second"}));
    const auto pieces = core::splitByPart(read.mesh);
    QCOMPARE(pieces.size(), 2U);
    QCOMPARE(pieces[0].mesh.points.size(), 3U);
    QCOMPARE(pieces[1].mesh.points.size(), 4U);
    QCOMPARE(pieces[1].mesh.triangles.size(), 3U);
    QVERIFY(pieces[0].mesh.colors[0] == Rgb({255, 0, 0}));
}

void TestPartFiles::amf_objectsAreParts()
{
    const auto vertex = [](int x, int y, int z) {
        const auto of = [](const std::string& axis, int value) {
            return '<' + axis + '>' + std::to_string(value) + "</" + axis + '>';
        };
        return "<vertex><coordinates>" + of("x", x) + of("y", y) + of("z", z) + "</coordinates></vertex>";
    };
    std::string text = "<amf unit=\"millimeter\">";
    for (const int x : {0, 1}) // the second one begins in a vertex of the first one
        text += "<object id=\"" + std::to_string(x) + "\"><mesh><vertices>" + vertex(x, 0, 0) + vertex(x + 1, 0, 0) +
                vertex(x, 1, 0) + vertex(x, 0, 1) +
                "</vertices><volume><triangle><v1>0</v1><v2>2</v2><v3>1</v3></triangle><triangle><v1>0</v1><v2>1</v2>"
                "<v3>3</v3></triangle><triangle><v1>0</v1><v2>3</v2><v3>2</v3></triangle><triangle><v1>1</v1>"
                "<v2>2</v2><v3>3</v3></triangle></volume></mesh></object>";
    write("a.amf", text + "</amf>");
    QCOMPARE(core::readMesh(file("a.amf")).points.size(), 7U);
    const ReadResult read = core::readModel(file("a.amf"), {.keepsObjects = true});
    QCOMPARE(read.mesh.points.size(), 8U);
    QCOMPARE(read.parts.size(), 2U);
    QVERIFY(core::checkMesh(read.mesh).printReady());
}

/// Tests that each instance of an outermost constellation is a part, which has the name of its object, or of what is
/// placed.
void TestPartFiles::amf_instancesAreParts()
{
    const auto named = [](const std::string& name) { return "<metadata type=\"name\">" + name + "</metadata>"; };
    const auto instance = [](int of, int x) {
        return "<instance objectid=\"" + std::to_string(of) + "\"><deltax>" + std::to_string(x) +
               "</deltax></instance>";
    };
    const std::string solid =
        "<mesh><vertices><vertex><coordinates><x>0</x><y>0</y><z>0</z></coordinates></vertex><vertex><coordinates>"
        "<x>1</x><y>0</y><z>0</z></coordinates></vertex><vertex><coordinates><x>0</x><y>1</y><z>0</z></coordinates>"
        "</vertex><vertex><coordinates><x>0</x><y>0</y><z>1</z></coordinates></vertex></vertices><volume>"
        "<triangle><v1>0</v1><v2>2</v2><v3>1</v3></triangle><triangle><v1>0</v1><v2>1</v2><v3>3</v3></triangle>"
        "<triangle><v1>0</v1><v2>3</v2><v3>2</v3></triangle><triangle><v1>1</v1><v2>2</v2><v3>3</v3></triangle>"
        "</volume></mesh>";
    const std::string longName(10'000, 'n');
    write("a.amf", "<amf unit=\"millimeter\"><metadata type=\"name\">file</metadata><object id=\"1\">" +
                       named(longName) + solid + "</object><object id=\"2\">" + named(" Körper &amp; co ") + solid +
                       "</object><object id=\"5\">" + named("empty") + "</object><constellation id=\"3\">" +
                       named("pair") + instance(1, 0) + instance(1, 5) + "</constellation><constellation id=\"4\">" +
                       instance(2, 0) + instance(3, 9) + instance(1, 90) + instance(5, 0) + "</constellation></amf>");
    const ReadResult one = core::readModel(file("a.amf"));
    QCOMPARE(one.remarks.objects, 3U);
    QVERIFY(one.mesh.parts.empty());
    const ReadResult read = core::readModel(file("a.amf"), {.keepsObjects = true});
    const std::string cut(PartList::maxNameBytes, 'n');
    QVERIFY(namesOf(read.parts) == std::vector<std::string>({"Körper & co", "pair", cut}));
    const auto pieces = core::splitByPart(read.mesh);
    QCOMPARE(pieces[0].mesh.triangles.size(), 4U);
    QCOMPARE(pieces[1].mesh.triangles.size(), 8U);
    QCOMPARE(pieces[2].mesh.triangles.size(), 4U);
}

void TestPartFiles::formatsWithoutObjects_keepTheOrder()
{
    const TriangleMesh mesh = core::joined({ballOf(7, {0, 0, 0}), ballOf(2, {40, 0, 0})});
    for (const char* name : {"a.stl", "a.ply", "a.off"}) {
        core::writeMesh(file(name), mesh, {.metadata = metadataWith(someParts())});
        QVERIFY(core::readMesh(file(name)).parts.empty());
        QVERIFY(core::checkExport(file(name), mesh, {}, someParts()).holds());
    }
}

FETTLE_TEST(TestPartFiles)
#include "tst_part_files.moc"
