#include "tests/support/mesh_asserts.h"
#include "tests/support/test_main.h"

#include "core/io/mesh_io.h"
#include "core/mesh/mesh_builder.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include <QTemporaryDir>
#include <QTest>

#include <bit>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

using core::DocumentMetadata;
using core::Rgb;
using core::Slot;
using core::TriangleMesh;
using core::Vec3f;

namespace
{
using Json = nlohmann::json;

constexpr std::size_t headSize = 12, chunkHeadSize = 8;

/// Returns a ball with a colour at each vertex, off centre, on a lattice.
TriangleMesh painted()
{
    TriangleMesh mesh = core::icosphere(3, 20);
    std::mt19937 engine(7);
    const core::Lattice lattice(14);
    for (Vec3f& p : mesh.points) {
        p = lattice.snap(p.cast<double>() + core::Vec3(5, 1, -2));
        mesh.colors.push_back({static_cast<std::uint8_t>(engine()), static_cast<std::uint8_t>(engine()),
                               static_cast<std::uint8_t>(engine())});
    }
    return mesh;
}

DocumentMetadata someNotes()
{
    DocumentMetadata metadata;
    metadata.palette = {{0, 0, 0}, {255, 254, 253}, {1, 160, 18}};
    metadata.frame = core::MeshFrame{core::Lattice(14), 0.7};
    metadata.view = core::SavedView{{1.0 / 3, -2e-5, 77}, 123.456, -1.25, 0.1, true};
    core::StrokeSettings brush;
    brush.tool = core::Tool::Flatten;
    brush.brush = core::BrushShape::Ray;
    brush.topology = core::Topology::Uniform;
    brush.symmetry = core::Symmetry::Z;
    brush.radius = 1.0 / 7;
    brush.strength = 0.3;
    brush.falloff = 7;
    brush.detail = 1.1;
    brush.spacing = 0.25;
    brush.fusion = false;
    brush.color = {1, 2, 3};
    metadata.brush = brush;
    metadata.work = core::WorkDone{1234, 5678.25};
    metadata.references = {{"front", "/pictures/lion.jpg", 120.5, -3, 50.25, 0.625, true}};
    return metadata;
}

std::string contentsOf(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

std::uint32_t wordAt(const std::string& bytes, std::size_t at)
{
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, 4);
    return word;
}

struct Glb
{
    Json json;
    std::string binary;
};

Glb takenApart(const std::string& bytes)
{
    const std::size_t length = wordAt(bytes, headSize);
    return {Json::parse(bytes.substr(headSize + chunkHeadSize, length)),
            bytes.substr(headSize + 2 * chunkHeadSize + length)};
}

void appendWord(std::string& bytes, std::uint32_t word)
{
    bytes.append(reinterpret_cast<const char*>(&word), 4);
}

std::string putTogether(const Glb& glb)
{
    std::string json = glb.json.dump(), bytes = "glTF";
    json.resize((json.size() + 3) / 4 * 4, ' ');
    appendWord(bytes, 2);
    appendWord(bytes, static_cast<std::uint32_t>(headSize + 2 * chunkHeadSize + json.size() + glb.binary.size()));
    appendWord(bytes, static_cast<std::uint32_t>(json.size()));
    bytes += "JSON" + json;
    appendWord(bytes, static_cast<std::uint32_t>(glb.binary.size()));
    return bytes + std::string("BIN\0", 4) + glb.binary;
}

/// Checks a file against sections 3 and 4 of the glTF 2.0 specification, as far as Fettle's files use them. broken()
/// returns the first violated rule, or an empty text.
class Rules
{
public:
    explicit Rules(const std::string& bytes) : m_bytes(bytes)
    {
        container();
        if (m_broken.empty())
            document();
    }
    const std::string& broken() const { return m_broken; }

private:
    void expect(bool holds, const std::string& rule)
    {
        if (!holds && m_broken.empty())
            m_broken = rule;
    }

    void container()
    {
        expect(m_bytes.size() >= headSize + chunkHeadSize && m_bytes.starts_with("glTF") && wordAt(m_bytes, 4) == 2,
               "head");
        expect(wordAt(m_bytes, 8) == m_bytes.size(), "length");
        const std::size_t json = wordAt(m_bytes, headSize), second = headSize + chunkHeadSize + json;
        expect(json % 4 == 0 && m_bytes.substr(headSize + 4, 4) == "JSON", "the first chunk is JSON, whole words");
        expect(second + chunkHeadSize <= m_bytes.size() && m_bytes.substr(second + 4, 4) == std::string("BIN\0", 4),
               "the second is binary");
        expect(wordAt(m_bytes, second) % 4 == 0 && second + chunkHeadSize + wordAt(m_bytes, second) == m_bytes.size(),
               "and the last");
    }

    void document()
    {
        m_glb = takenApart(m_bytes);
        const Json& json = m_glb.json;
        expect(json.at("asset").at("version") == "2.0", "version");
        expect(json.at("buffers").size() == 1 && json["buffers"][0].at("byteLength") <= m_glb.binary.size() &&
                   m_glb.binary.size() - json["buffers"][0]["byteLength"].get<std::size_t>() < 4,
               "buffer");
        expect(!json.contains("extensionsRequired"), "nothing is required");
        const Json extensions = json.value("extensions", Json::object());
        for (const auto& [name, extension] : extensions.items())
            expect(std::ranges::count(json.at("extensionsUsed"), Json(name)) == 1, name + " is listed");
        for (const Json& accessor : json.at("accessors"))
            accessorHolds(accessor);
        for (const Json& mesh : json.at("meshes"))
            for (const Json& primitive : mesh.at("primitives"))
                primitiveHolds(primitive);
        expect(json.at("scenes").at(json.at("scene").get<std::size_t>()).at("nodes").size() == 1, "scene");
    }

    static std::size_t sizeOf(const Json& accessor)
    {
        const std::size_t each = accessor.at("componentType") == 5126 || accessor.at("componentType") == 5125 ? 4
                                 : accessor.at("componentType") == 5123                                       ? 2
                                                                                                              : 1;
        const std::size_t count = accessor.at("type") == "SCALAR" ? 1 : accessor.at("type") == "VEC3" ? 3 : 4;
        return each * count;
    }

    const Json& viewOf(const Json& accessor) const
    {
        return m_glb.json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    }

    void accessorHolds(const Json& accessor)
    {
        const Json& view = viewOf(accessor);
        const std::size_t begin =
            view.value("byteOffset", std::size_t(0)) + accessor.value("byteOffset", std::size_t(0));
        const std::size_t size = sizeOf(accessor), count = accessor.at("count");
        expect(count > 0, "count");
        expect(begin % 4 == 0 && size % 4 == 0, "whole words");
        expect(accessor.value("byteOffset", std::size_t(0)) + count * size <= view.at("byteLength").get<std::size_t>(),
               "within its view");
        expect(view.value("byteOffset", std::size_t(0)) + view.at("byteLength").get<std::size_t>() <=
                   m_glb.binary.size(),
               "within the buffer");
        if (accessor.at("componentType") == 5126)
            for (std::size_t i = 0; i < count * size / 4; ++i)
                expect(std::isfinite(std::bit_cast<float>(wordAt(m_glb.binary, begin + 4 * i))), "a number");
    }

    void primitiveHolds(const Json& primitive)
    {
        const Json& accessors = m_glb.json.at("accessors");
        const Json& positions = accessors.at(primitive.at("attributes").at("POSITION").get<std::size_t>());
        for (const auto& [name, index] : primitive["attributes"].items()) {
            expect(accessors.at(index.get<std::size_t>()).at("count") == positions.at("count"),
                   name + " for each vertex");
            expect(viewOf(accessors[index.get<std::size_t>()]).value("target", 0) == 34962, name + " is of vertices");
        }
        boundsHold(positions);
        normalsHold(accessors.at(primitive["attributes"].at("NORMAL").get<std::size_t>()));
        const Json& indices = accessors.at(primitive.at("indices").get<std::size_t>());
        expect(viewOf(indices).value("target", 0) == 34963 && indices.at("type") == "SCALAR", "indices");
        for (std::size_t i = 0; i < indices.at("count"); ++i)
            expect(wordAt(m_glb.binary, viewOf(indices).at("byteOffset").get<std::size_t>() + 4 * i) <
                       positions.at("count"),
                   "an index in range");
        expect(primitive.at("material") < m_glb.json.at("materials").size(), "material");
    }

    float componentAt(const Json& accessor, std::size_t i) const
    {
        return std::bit_cast<float>(wordAt(m_glb.binary, viewOf(accessor).value("byteOffset", std::size_t(0)) + 4 * i));
    }

    void boundsHold(const Json& positions)
    {
        for (std::size_t k = 0; k < 3; ++k) {
            float least = componentAt(positions, k), most = least;
            for (std::size_t i = k; i < 3 * positions.at("count").get<std::size_t>(); i += 3) {
                least = std::min(least, componentAt(positions, i));
                most = std::max(most, componentAt(positions, i));
            }
            expect(positions.at("min").at(k).get<float>() == least && positions.at("max").at(k).get<float>() == most,
                   "min and max");
        }
    }

    void normalsHold(const Json& normals)
    {
        for (std::size_t i = 0; i < 3 * normals.at("count").get<std::size_t>(); i += 3) {
            const Vec3f n(componentAt(normals, i), componentAt(normals, i + 1), componentAt(normals, i + 2));
            expect(std::abs(n.norm() - 1) < 1e-3F, "normals of unit length");
        }
    }

    const std::string& m_bytes;
    Glb m_glb;
    std::string m_broken;
};
} // namespace

class TestGlbFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void notes_comeBackUnchanged();
    void references_moveWithTheModel();
    void notes_thatAreNotAsWeWriteThemAreLeftOut_data();
    void notes_thatAreNotAsWeWriteThemAreLeftOut();
    void latticeAndBits_comeBackUnchanged();
    void latticeThatDoesNotFit_isNotTaken();
    void structure_keepsTheSpecification_data();
    void structure_keepsTheSpecification();
    void tinygltf_readsTheSame();
    void assimp_readsTheSame();

private:
    std::filesystem::path file(const char* name) const
    {
        return m_folder.filePath(QString::fromLatin1(name)).toStdString();
    }
    DocumentMetadata notesAfter(const std::function<void(Json& metadata)>& change) const;

    QTemporaryDir m_folder;
};

void TestGlbFile::notes_comeBackUnchanged()
{
    const DocumentMetadata metadata = someNotes();
    core::writeMesh(file("a.glb"), painted(), {.metadata = metadata});
    const DocumentMetadata read = core::readMetadata(file("a.glb"));
    QVERIFY(read.palette == metadata.palette);
    QVERIFY(read.frame == metadata.frame);
    QVERIFY(read.view && read.view->target == metadata.view->target && read.view->distance == metadata.view->distance);
    QVERIFY(read.view->yaw == metadata.view->yaw && read.view->pitch == metadata.view->pitch &&
            read.view->orthographic);
    QVERIFY(read.brush && read.brush->tool == metadata.brush->tool && read.brush->brush == metadata.brush->brush);
    QVERIFY(read.brush->topology == metadata.brush->topology && read.brush->symmetry == metadata.brush->symmetry);
    QVERIFY(read.brush->radius == metadata.brush->radius && read.brush->strength == metadata.brush->strength);
    QVERIFY(read.brush->falloff == metadata.brush->falloff && read.brush->detail == metadata.brush->detail);
    QVERIFY(read.brush->spacing == metadata.brush->spacing && read.brush->fusion == metadata.brush->fusion &&
            read.brush->color == metadata.brush->color);
    QVERIFY(read.work == metadata.work);
    QVERIFY(read.references == metadata.references);

    core::writeMesh(file("a.glb"), painted());
    const DocumentMetadata none = core::readMetadata(file("a.glb"));
    QVERIFY(none.palette.empty() && !none.frame && !none.view && !none.brush && !none.work);
}

/// Tests that a reference image inside the model's folder is found after the folder has moved.
void TestGlbFile::references_moveWithTheModel()
{
    namespace fs = std::filesystem;
    const fs::path home = file("home"), other = file("other");
    fs::create_directories(home / "pictures");
    DocumentMetadata metadata;
    metadata.references = {{"front", home / "pictures" / "lion.jpg", 100, 0, 0, 1, false},
                           {"left", home / "side.png", 100, 0, 0, 1, false},
                           {"top", file("elsewhere.png"), 100, 0, 0, 1, false}};
    core::writeMesh(home / "lion.glb", painted(), {.metadata = metadata});
    QVERIFY(core::readMetadata(home / "lion.glb").references == metadata.references);
    fs::rename(home, other);
    const auto moved = core::readMetadata(other / "lion.glb").references;
    QCOMPARE(moved.size(), 3U);
    QCOMPARE(moved[0].path, other / "pictures" / "lion.jpg");
    QCOMPARE(moved[1].path, other / "side.png");
    QCOMPARE(moved[2].path, metadata.references[2].path);
}

DocumentMetadata TestGlbFile::notesAfter(const std::function<void(Json&)>& change) const
{
    core::writeMesh(file("a.glb"), painted(), {.metadata = someNotes()});
    Glb glb = takenApart(contentsOf(file("a.glb")));
    change(glb.json["extensions"]["FETTLE_document"]);
    std::ofstream(file("b.glb"), std::ios::binary) << putTogether(glb);
    return core::readMetadata(file("b.glb"));
}

void TestGlbFile::notes_thatAreNotAsWeWriteThemAreLeftOut_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("value");
    /// initials of the metadata that is still read: palette, frame, view, brush, work, reference
    QTest::addColumn<QString>("left");
    const auto row = [](const char* path, const char* value, const char* left) {
        QTest::addRow("%s: %s", path, value)
            << QString::fromLatin1(path) << QString::fromLatin1(value) << QString::fromLatin1(left);
    };
    row("/new", "[1,{}]", "pfvbwr"); // unknown keys are ignored
    row("/version", "2", "");
    row("/version", "\"1\"", "");
    row("/unit", "\"m\"", "");
    row("/palette", "[\"12345\"]", "fvbwr");
    row("/palette", "7", "fvbwr");
    row("/palette", "[[[1]]]", "fvbwr");
    row("/lattice", "1.5", "pvbwr");
    row("/lattice", "1e300", "pvbwr");
    row("/lattice", "-2000000000", "pvbwr");
    row("/uniformDetail", "0", "pvbwr");
    row("/uniformDetail", "\"long\"", "pvbwr");
    row("/view", "[]", "pfbwr");
    row("/view/distance", "0", "pfbwr");
    row("/view/yaw", "1e300", "pfbwr");
    row("/view/target", "[0,0]", "pfbwr");
    row("/view/target", "[0,0,null]", "pfbwr");
    row("/view/target", "[0,0,1e40]", "pfbwr");
    row("/brush/tool", "\"melt\"", "pfvwr");
    row("/brush/radius", "-1", "pfvwr");
    row("/brush/symmetry", "[[[[]]]]", "pfvwr");
    row("/brush/color", "[1,2,300]", "pfvwr");
    row("/brush/command", "\"recentre\"", "pfvwr");
    row("/brush", "\"big\"", "pfvwr");
    row("/work", "[]", "pfvbr");
    row("/work/strokes", "-1", "pfvbr");
    row("/work/strokes", "1.5", "pfvbr");
    row("/work/strokes", "1e300", "pfvbr");
    row("/work/seconds", "\"long\"", "pfvbr");
    row("/work/seconds", "1e300", "pfvbr");
    row("/references", "{}", "pfvbw");
    row("/references", "[7, null]", "pfvbw");
    row("/references/0/side", "\"inside\"", "pfvbw");
    row("/references/0/side", "[]", "pfvbw");
    row("/references/0/path", "\"\"", "pfvbw");
    row("/references/0/path", "\"a\\u0000b\"", "pfvbw");
    row("/references/0/path", "\"//server/share/lion.jpg\"", "pfvbw");
    row("/references/0/path", "\"\\\\\\\\server\\\\share\"", "pfvbw");
    row("/references/0/width", "0", "pfvbw");
    row("/references/0/x", "1e300", "pfvbw");
    row("/references/0/opacity", "1.5", "pfvbw");
    row("/references/0/inFront", "\"yes\"", "pfvbwr");
    row("/references/1", "{\"side\": \"front\", \"path\": \"b.png\", \"width\": 1, \"x\": 0, \"y\": 0, \"opacity\": 1}",
        "pfvbwr"); // each side has at most one reference image
}

void TestGlbFile::notes_thatAreNotAsWeWriteThemAreLeftOut()
{
    QFETCH(QString, path);
    QFETCH(QString, value);
    QFETCH(QString, left);
    const DocumentMetadata metadata = notesAfter(
        [&](Json& json) { json[Json::json_pointer(path.toStdString())] = Json::parse(value.toStdString()); });
    QCOMPARE(!metadata.palette.empty(), left.contains(u'p'));
    QCOMPARE(metadata.frame.has_value(), left.contains(u'f'));
    QCOMPARE(metadata.view.has_value(), left.contains(u'v'));
    QCOMPARE(metadata.brush.has_value(), left.contains(u'b'));
    QCOMPARE(metadata.work.has_value(), left.contains(u'w'));
    QCOMPARE(!metadata.references.empty(), left.contains(u'r'));
}

/// Tests the surface of a document that importing would change: it is off centre, and its lattice does not fit its
/// size.
void TestGlbFile::latticeAndBits_comeBackUnchanged()
{
    const core::MeshFrame frame = *someNotes().frame;
    const core::BuildResult first = core::buildMesh(painted(), false, {}, frame);
    QVERIFY(first.mesh && first.mesh->frame() == frame);
    core::writeMesh(
        file("a.glb"), core::extractMesh(*first.mesh),
        {.metadata = {
             .palette = {}, .frame = first.mesh->frame(), .view = {}, .brush = {}, .work = {}, .references = {}}});
    const core::BuildResult again =
        core::buildMesh(core::readMesh(file("a.glb")), true, {}, core::readMetadata(file("a.glb")).frame);
    QVERIFY(again.mesh);
    QVERIFY(again.mesh->frame() == frame);
    QCOMPARE(again.mesh->meshHash(), first.mesh->meshHash());
    // slot numbers are equal, too, because buildMesh() sorts them along the Morton curve
    QCOMPARE(again.mesh->stateHash(), first.mesh->stateHash());
    const core::BuildResult stranger = core::buildMesh(core::readMesh(file("a.glb")), true);
    QVERIFY(!stranger.mesh->frame().place.isZero() && stranger.mesh->lattice() != frame.lattice);
}

/// Simulates another program that moved a vertex but left Fettle's metadata in the file.
void TestGlbFile::latticeThatDoesNotFit_isNotTaken()
{
    TriangleMesh mesh = painted();
    mesh.points[3].x() += 1e-4F;
    const core::MeshFrame frame = *someNotes().frame;
    QVERIFY(!frame.lattice.isOnLattice(mesh.points[3]));
    const core::BuildResult built = core::buildMesh(mesh, true, {}, frame);
    QVERIFY(built.mesh && built.mesh->lattice() != frame.lattice && !built.mesh->frame().place.isZero());
    const core::BuildResult tooSmall = core::buildMesh(painted(), true, {}, core::MeshFrame{core::Lattice(19), 1});
    // lattice 19 ends at 16 mm, which is too small for the model
    QVERIFY(tooSmall.mesh && tooSmall.mesh->lattice() != core::Lattice(19));
}

void TestGlbFile::structure_keepsTheSpecification_data()
{
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::addColumn<bool>("noted");
    TriangleMesh plain = painted();
    plain.colors.clear();
    TriangleMesh unused = painted(), huge = core::icosphere(1, 1e30), tiny = core::icosphere(1, 1e-30);
    unused.points.push_back({1, 2, 3});
    unused.colors.push_back({});
    for (const bool noted : {false, true}) {
        const char* with = noted ? "with notes" : "bare";
        QTest::addRow("colours, %s", with) << painted() << noted;
        QTest::addRow("no colours, %s", with) << plain << noted;
        QTest::addRow("unused vertex, %s", with) << unused << noted;
        QTest::addRow("huge, %s", with) << huge << noted;
        QTest::addRow("tiny, %s", with) << tiny << noted;
    }
}

void TestGlbFile::structure_keepsTheSpecification()
{
    QFETCH(TriangleMesh, mesh);
    QFETCH(bool, noted);
    core::writeMesh(file("a.glb"), mesh, {.metadata = noted ? someNotes() : DocumentMetadata()});
    const std::string bytes = contentsOf(file("a.glb"));
    const Rules rules(bytes);
    QVERIFY2(rules.broken().empty(), rules.broken().c_str());
    Glb spoilt = takenApart(bytes); // a damaged file proves that the rules can fail
    spoilt.json["accessors"][0]["max"][0] = 1e31;
    const std::string other = putTogether(spoilt);
    QCOMPARE(Rules(other).broken(), "min and max");
}

void TestGlbFile::tinygltf_readsTheSame()
{
    const TriangleMesh mesh = painted();
    core::writeMesh(file("a.glb"), mesh, {.metadata = someNotes()});
    tinygltf::Model model;
    std::string error, warning;
    QVERIFY(tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &error, &warning, file("a.glb").string()));
    QCOMPARE(error, "");
    QCOMPARE(warning, "");
    QVERIFY(model.extensionsUsed == std::vector<std::string>{"FETTLE_document"} && model.extensionsRequired.empty());
    QCOMPARE(model.extensions.at("FETTLE_document").Get("lattice").GetNumberAsInt(), 14);
    const tinygltf::Primitive& primitive = model.meshes.at(0).primitives.at(0);
    const auto bytesOfAccessor = [&](int index) {
        const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(index));
        const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
        return model.buffers.at(0).data.data() + view.byteOffset + accessor.byteOffset;
    };
    QVERIFY(std::memcmp(bytesOfAccessor(primitive.attributes.at("POSITION")), mesh.points.data(),
                        12 * mesh.points.size()) == 0);
    QVERIFY(std::memcmp(bytesOfAccessor(primitive.indices), mesh.triangles.data(), 12 * mesh.triangles.size()) == 0);
    QCOMPARE(model.nodes.at(0).scale, std::vector<double>(3, 0.001));
}

void TestGlbFile::assimp_readsTheSame()
{
    const TriangleMesh mesh = painted();
    core::writeMesh(file("a.glb"), mesh, {.metadata = someNotes()});
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(file("a.glb").string(), aiProcess_PreTransformVertices);
    QVERIFY2(scene, importer.GetErrorString());
    QCOMPARE(scene->mNumMeshes, 1U);
    const aiMesh& read = *scene->mMeshes[0];
    QCOMPARE(std::size_t(read.mNumFaces), mesh.triangles.size());
    QVERIFY(read.HasVertexColors(0));
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        for (unsigned k = 0; k < 3; ++k) {
            const aiVector3D& p = read.mVertices[read.mFaces[f].mIndices[k]]; // coordinates in metres
            const Vec3f& q = mesh.points[mesh.triangles[f][k]];
            QVERIFY((1000 * Vec3f(p.x, p.y, p.z) - q).norm() < 1e-4F);
        }
}

FETTLE_TEST(TestGlbFile)
#include "tst_glb_file.moc"
