// Tests glTF compressed by Draco. Streams from Draco's own encoder are decoded in the importer's process. Broken or
// inconsistent streams must be refused.

#include "app/import/draco_decoder.h"
#include "app/import/sandboxed_importer.h"
#include "core/io/mesh_io.h"
#include "core/parts/part_split.h"
#include "core/util/file_error.h"
#include "tests/support/effort.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <random>

namespace
{
using core::FileError;
using core::FileFault;
using core::ReadResult;
using core::TriangleMesh;
using core::Vec3f;
using Kind = core::FileErrorKind;

constexpr unsigned streamSeed = 20261127;

/// Settings of Draco's encoder.
struct Packing
{
    int method = draco::MESH_EDGEBREAKER_ENCODING;
    int bits = 0; ///< bits per coordinate of positions; 0: unquantised floats
    int speed = 5;
    bool isCloud = false;
};

template <class Value>
void addAttribute(draco::Mesh& to, draco::GeometryAttribute::Type type, draco::DataType dataType, bool isNormalized,
                  const std::vector<Value>& values, int components)
{
    draco::GeometryAttribute kind;
    const auto count = static_cast<std::uint32_t>(values.size()) / static_cast<std::uint32_t>(components);
    kind.Init(type, nullptr, static_cast<std::uint8_t>(components), dataType, isNormalized,
              static_cast<std::int64_t>(sizeof(Value)) * components, 0);
    const int id = to.AddAttribute(kind, true, count);
    for (std::uint32_t i = 0; i < count; ++i)
        to.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i),
                                            &values[i * static_cast<std::uint32_t>(components)]);
}

/// Returns the mesh as a Draco stream: attribute 0 is the positions, 1 the colours with alpha, 2 the mask. Attributes
/// that the mesh lacks are omitted.
QByteArray packed(const TriangleMesh& mesh, const Packing& packing)
{
    draco::Mesh to;
    to.set_num_points(static_cast<std::uint32_t>(mesh.points.size()));
    to.SetNumFaces(mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const core::Triangle& t = mesh.triangles[i];
        to.SetFace(draco::FaceIndex(i), {draco::PointIndex(t[0]), draco::PointIndex(t[1]), draco::PointIndex(t[2])});
    }
    std::vector<float> positions;
    for (const Vec3f& p : mesh.points)
        positions.insert(positions.end(), {p.x(), p.y(), p.z()});
    addAttribute(to, draco::GeometryAttribute::POSITION, draco::DT_FLOAT32, false, positions, 3);
    std::vector<std::uint8_t> colors;
    for (const core::Rgb& color : mesh.colors)
        colors.insert(colors.end(), {color.r, color.g, color.b, 255});
    if (!colors.empty())
        addAttribute(to, draco::GeometryAttribute::COLOR, draco::DT_UINT8, true, colors, 4);
    std::vector<float> masks;
    for (const std::uint8_t mask : mesh.masks)
        masks.push_back(static_cast<float>(mask) / 255);
    if (!masks.empty())
        addAttribute(to, draco::GeometryAttribute::GENERIC, draco::DT_FLOAT32, false, masks, 1);
    draco::Encoder encoder;
    encoder.SetEncodingMethod(packing.method);
    encoder.SetSpeedOptions(packing.speed, packing.speed);
    if (packing.bits != 0)
        encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, packing.bits);
    draco::EncoderBuffer buffer;
    const draco::Status status =
        packing.isCloud ? encoder.EncodePointCloudToBuffer(to, &buffer) : encoder.EncodeMeshToBuffer(to, &buffer);
    return status.ok() ? QByteArray(buffer.data(), static_cast<qsizetype>(buffer.size())) : QByteArray();
}

/// A glTF that a test modifies before it is written.
struct Model
{
    QJsonObject json;
    QByteArray binary;
};

qsizetype addView(Model& model, const QByteArray& bytes)
{
    while (model.binary.size() % 4 != 0)
        model.binary += '\0';
    QJsonArray views = model.json[QLatin1StringView("bufferViews")].toArray();
    views.append(QJsonObject{{QStringLiteral("buffer"), 0},
                             {QStringLiteral("byteOffset"), model.binary.size()},
                             {QStringLiteral("byteLength"), bytes.size()}});
    model.binary += bytes;
    model.json[QLatin1StringView("bufferViews")] = views;
    return views.size() - 1;
}

qsizetype addAccessor(Model& model, int componentType, std::size_t count, const char* type, bool isNormalized = false)
{
    QJsonArray accessors = model.json[QLatin1StringView("accessors")].toArray();
    accessors.append(QJsonObject{{QStringLiteral("componentType"), componentType},
                                 {QStringLiteral("count"), static_cast<qint64>(count)},
                                 {QStringLiteral("type"), QLatin1StringView(type)},
                                 {QStringLiteral("normalized"), isNormalized}});
    model.json[QLatin1StringView("accessors")] = accessors;
    return accessors.size() - 1;
}

/// Adds the mesh as a Draco-compressed primitive.
void addPacked(Model& model, const TriangleMesh& mesh, const QByteArray& stream)
{
    QJsonObject attributes{{QStringLiteral("POSITION"), addAccessor(model, 5126, mesh.points.size(), "VEC3")}};
    QJsonObject ids{{QStringLiteral("POSITION"), 0}};
    if (!mesh.colors.empty()) {
        attributes[QLatin1StringView("COLOR_0")] = addAccessor(model, 5121, mesh.points.size(), "VEC4", true);
        ids[QLatin1StringView("COLOR_0")] = 1;
    }
    if (!mesh.masks.empty()) {
        attributes[QLatin1StringView("_MASK")] = addAccessor(model, 5126, mesh.points.size(), "SCALAR");
        ids[QLatin1StringView("_MASK")] = 2;
    }
    const QJsonObject extension{{QStringLiteral("bufferView"), addView(model, stream)},
                                {QStringLiteral("attributes"), ids}};
    const QJsonObject primitive{
        {QStringLiteral("attributes"), attributes},
        {QStringLiteral("indices"), addAccessor(model, 5125, 3 * mesh.triangles.size(), "SCALAR")},
        {QStringLiteral("extensions"), QJsonObject{{QStringLiteral("KHR_draco_mesh_compression"), extension}}}};
    QJsonArray meshes = model.json[QLatin1StringView("meshes")].toArray();
    meshes.append(QJsonObject{{QStringLiteral("primitives"), QJsonArray{primitive}}});
    model.json[QLatin1StringView("meshes")] = meshes;
    model.json[QLatin1StringView("extensionsRequired")] = QJsonArray{QStringLiteral("KHR_draco_mesh_compression")};
}

/// Adds the mesh as a primitive of plain accessors, with positions only.
void addPlain(Model& model, const TriangleMesh& mesh)
{
    QByteArray points, corners;
    for (const Vec3f& p : mesh.points)
        // works on little-endian machines only
        points.append(reinterpret_cast<const char*>(p.data()), 3 * sizeof(float));
    for (const core::Triangle& t : mesh.triangles)
        for (const std::uint32_t corner : t)
            corners.append(reinterpret_cast<const char*>(&corner), sizeof corner);
    const qsizetype positions = addAccessor(model, 5126, mesh.points.size(), "VEC3"),
                    indices = addAccessor(model, 5125, 3 * mesh.triangles.size(), "SCALAR");
    QJsonArray accessors = model.json[QLatin1StringView("accessors")].toArray();
    for (const auto& [accessor, bytes] : {std::pair{positions, points}, {indices, corners}}) {
        QJsonObject object = accessors[accessor].toObject();
        object[QLatin1StringView("bufferView")] = addView(model, bytes);
        accessors[accessor] = object;
    }
    model.json[QLatin1StringView("accessors")] = accessors;
    QJsonArray meshes = model.json[QLatin1StringView("meshes")].toArray();
    meshes.append(QJsonObject{
        {QStringLiteral("primitives"),
         QJsonArray{QJsonObject{{QStringLiteral("attributes"), QJsonObject{{QStringLiteral("POSITION"), positions}}},
                                {QStringLiteral("indices"), indices}}}}});
    model.json[QLatin1StringView("meshes")] = meshes;
}

QByteArray jsonOf(const Model& model, const QString& uri)
{
    QJsonObject json = model.json;
    QJsonObject buffer{{QStringLiteral("byteLength"), model.binary.size()}};
    if (!uri.isEmpty())
        buffer[QLatin1StringView("uri")] = uri;
    json[QLatin1StringView("buffers")] = QJsonArray{buffer};
    json[QLatin1StringView("asset")] = QJsonObject{{QStringLiteral("version"), QStringLiteral("2.0")}};
    return QJsonDocument(json).toJson(QJsonDocument::Compact);
}

QByteArray glbOf(const Model& model)
{
    QByteArray json = jsonOf(model, {}), binary = model.binary;
    json.append((4 - json.size() % 4) % 4, ' ');
    binary.append((4 - binary.size() % 4) % 4, '\0');
    const auto number = [](qsizetype value) {
        const auto four = static_cast<std::uint32_t>(value);
        return QByteArray(reinterpret_cast<const char*>(&four), sizeof four);
    };
    return "glTF" + number(2) + number(28 + json.size() + binary.size()) + number(json.size()) + "JSON" + json +
           number(binary.size()) + QByteArray("BIN\0", 4) + binary;
}

/// Returns the object with `change` applied to the part at `path`, which consists of keys and list indices.
QJsonValue changed(const QJsonValue& value, const QStringList& path,
                   const std::function<QJsonValue(QJsonValue)>& change)
{
    if (path.isEmpty())
        return change(value);
    const QStringList rest = path.mid(1);
    if (value.isArray()) {
        QJsonArray array = value.toArray();
        array[path.front().toInt()] = changed(array[path.front().toInt()], rest, change);
        return array;
    }
    QJsonObject object = value.toObject();
    const QJsonValue part = changed(object[path.front()], rest, change);
    if (part.isUndefined())
        object.remove(path.front());
    else
        object[path.front()] = part;
    return object;
}

void change(Model& model, const char* path, const QJsonValue& to)
{
    model.json =
        changed(model.json, QString::fromLatin1(path).split(u'/'), [&to](const QJsonValue&) { return to; }).toObject();
}

constexpr const char* extensionPath = "meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";

double volumeIn(const TriangleMesh& mesh)
{
    double six = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        six += mesh.points[a].cast<double>().dot(mesh.points[b].cast<double>().cross(mesh.points[c].cast<double>()));
    return six / 6;
}

/// Returns the distance from a point to the nearest of `points`, mm.
float distanceTo(const std::vector<Vec3f>& points, const Vec3f& point)
{
    float least = INFINITY;
    for (const Vec3f& other : points)
        least = std::min(least, (other - point).norm());
    return least;
}

/// Returns a ball 20 mm in diameter, with coordinates in metres, the unit of glTF.
TriangleMesh ball()
{
    return core::icosphere(2, 0.01);
}
} // namespace

class TestDracoFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_dir.isValid());
        core::setExternalReader(app::sandboxedImporter(FETTLE_PROGRAM));
    }

    void streams_areDecoded_data();
    void streams_areDecoded();
    void colorsAndMasks_areRead();
    void scenes_mixPackedAndPlain();
    void objects_becomePartsIfWanted();
    void documents_keepTheirParts();
    void sharedStreams_areInstanced();
    void sparseNumbers_replaceDecoded();
    void stripsAreDecodedToTriangles();
    void fallbacks_needNoDecoder();
    void unannouncedStreams_areDecoded();
    void degenerateTriangles_areCounted();
    void largeModels_areRead();

    void withoutDecoder_extensionIsNamed();
    void lies_areOneSentence_data();
    void lies_areOneSentence();
    void brokenStreams_areOneSentence();
    void bombs_areRefused();
    void decoder_neverReadsBeyondItsStream();

private:
    std::filesystem::path file(const QString& name) const { return m_dir.filePath(name).toStdU16String(); }
    void write(const QString& name, const QByteArray& bytes) const
    {
        QFile to(m_dir.filePath(name));
        QVERIFY(to.open(QIODevice::WriteOnly) && to.write(bytes) == bytes.size());
    }
    ReadResult read(const Model& model, bool keepsObjects = false) const
    {
        write(QStringLiteral("model.glb"), glbOf(model));
        return core::readModel(file(QStringLiteral("model.glb")), {.keepsObjects = keepsObjects});
    }
    std::optional<FileError> errorOf(const Model& model) const
    {
        try {
            read(model);
        } catch (const FileError& error) {
            return error;
        }
        return std::nullopt;
    }

    QTemporaryDir m_dir;
};

void TestDracoFiles::streams_areDecoded_data()
{
    QTest::addColumn<int>("method");
    QTest::addColumn<int>("bits");
    QTest::addColumn<int>("speed");
    QTest::addColumn<QString>("ending");
    for (const QString& ending : {QStringLiteral("glb"), QStringLiteral("gltf"), QStringLiteral("gltf and bin")})
        for (const int speed : {0, 5, 10})
            for (const int bits : {0, 11, 16}) {
                QTest::addRow("edgebreaker %d %d %s", speed, bits, qPrintable(ending))
                    << int(draco::MESH_EDGEBREAKER_ENCODING) << bits << speed << ending;
                QTest::addRow("sequential %d %d %s", speed, bits, qPrintable(ending))
                    << int(draco::MESH_SEQUENTIAL_ENCODING) << bits << speed << ending;
            }
}

/// Positions must be exact up to the quantisation step, or bit for bit without quantisation. The triangles must be the
/// same.
void TestDracoFiles::streams_areDecoded()
{
    QFETCH(int, method);
    QFETCH(int, bits);
    QFETCH(int, speed);
    QFETCH(QString, ending);
    const TriangleMesh mesh = ball();
    Model model;
    addPacked(model, mesh, packed(mesh, {.method = method, .bits = bits, .speed = speed}));
    std::filesystem::path path = file(QStringLiteral("a.glb"));
    if (ending == QLatin1StringView("glb")) {
        write(QStringLiteral("a.glb"), glbOf(model));
    } else {
        const bool isBeside = ending != QLatin1StringView("gltf");
        path = file(QStringLiteral("a.gltf"));
        write(QStringLiteral("a.bin"), model.binary);
        write(QStringLiteral("a.gltf"),
              jsonOf(model, isBeside ? QStringLiteral("a.bin")
                                     : QStringLiteral("data:;base64,") + QString::fromLatin1(model.binary.toBase64())));
    }
    const TriangleMesh result = core::readMesh(path);
    QCOMPARE(result.triangles.size(), mesh.triangles.size());
    QCOMPARE(result.points.size(), mesh.points.size());
    const float step = bits == 0 ? 0 : 20.0F / static_cast<float>((1 << bits) - 1);
    for (const Vec3f& point : mesh.points)
        QVERIFY(distanceTo(result.points, 1000 * point) <= step + 2e-6F);
    const double volume = volumeIn(mesh) * 1e9;
    QVERIFY(std::abs(volumeIn(result) - volume) <= volume * (1e-5 + static_cast<double>(step) * 0.3));
}

void TestDracoFiles::colorsAndMasks_areRead()
{
    TriangleMesh mesh = ball();
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        mesh.colors.push_back(i % 2 == 0 ? core::Rgb{255, 0, 0} : core::Rgb{0, 0, 255});
        mesh.masks.push_back(i % 2 == 0 ? 255 : 51);
    }
    for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING}) {
        Model model;
        addPacked(model, mesh, packed(mesh, {.method = method}));
        const TriangleMesh result = read(model).mesh;
        QCOMPARE(result.points.size(), mesh.points.size());
        QCOMPARE(result.colors.size(), mesh.points.size());
        QCOMPARE(result.masks.size(), mesh.points.size());
        for (std::size_t i = 0; i < mesh.points.size(); ++i) {
            std::size_t at = 0;
            while (at < result.points.size() && (result.points[at] - 1000 * mesh.points[i]).norm() > 1e-5F)
                ++at;
            QVERIFY(at < result.points.size());
            QVERIFY(result.colors[at] == mesh.colors[i]);
            QCOMPARE(result.masks[at], mesh.masks[i]);
        }
    }
}

/// The scene has a compressed ball, a plain cube, and a compressed tetrahedron that its node mirrors and moves.
void TestDracoFiles::scenes_mixPackedAndPlain()
{
    const TriangleMesh cube = shapes::scaled(shapes::cube(1), 0.01F),
                       tetrahedron = shapes::scaled(shapes::tetrahedron(), 0.01F);
    Model model;
    addPacked(model, ball(), packed(ball(), {.bits = 14}));
    addPlain(model, cube);
    addPacked(model, tetrahedron, packed(tetrahedron, {.method = draco::MESH_SEQUENTIAL_ENCODING}));
    QJsonArray nodes{QJsonObject{{QStringLiteral("mesh"), 0}}, QJsonObject{{QStringLiteral("mesh"), 1}}};
    nodes.append(QJsonObject{{QStringLiteral("mesh"), 2},
                             {QStringLiteral("scale"), QJsonArray{-2, 1, 1}},
                             {QStringLiteral("translation"), QJsonArray{1, 0, 0}}});
    model.json[QLatin1StringView("nodes")] = nodes;
    model.json[QLatin1StringView("textures")] = QJsonArray{QJsonObject()};
    const ReadResult result = read(model);
    QCOMPARE(result.remarks.objects, std::size_t(3));
    QVERIFY(result.remarks.textures);
    QCOMPARE(result.mesh.triangles.size(),
             ball().triangles.size() + cube.triangles.size() + tetrahedron.triangles.size());
    const double volume = 1e9 * (volumeIn(ball()) + volumeIn(cube) + 2 * volumeIn(tetrahedron));
    QVERIFY(std::abs(volumeIn(result.mesh) / volume - 1) < 1e-3);
}

/// The balls share all their points, which must not be merged.
void TestDracoFiles::objects_becomePartsIfWanted()
{
    const QString longName(10'000, QLatin1Char('x'));
    Model model;
    addPacked(model, ball(), packed(ball(), {}));
    QJsonArray nodes;
    for (const QString& name : {QStringLiteral("Körper"), longName, QStringLiteral("a\nb")})
        nodes.append(QJsonObject{{QStringLiteral("mesh"), 0}, {QStringLiteral("name"), name}});
    model.json[QLatin1StringView("nodes")] = nodes;
    const ReadResult one = read(model);
    QVERIFY(one.mesh.parts.empty() && one.parts == core::PartList());
    QCOMPARE(one.remarks.objects, std::size_t(3));
    QCOMPARE(one.mesh.points.size(), ball().points.size());
    const ReadResult parts = read(model, true);
    QCOMPARE(parts.mesh.points.size(), 3 * ball().points.size());
    QCOMPARE(parts.mesh.parts.size(), parts.mesh.points.size());
    QCOMPARE(parts.parts.size(), std::size_t(3));
    QCOMPARE(parts.parts.all()[0].name, std::string("Körper"));
    QCOMPARE(parts.parts.all()[1].name, std::string(core::PartList::maxNameBytes, 'x'));
    QCOMPARE(parts.parts.all()[2].name, std::string("a b"));
}

/// Another program may pack a document of Fettle and keep the extension with its list of parts.
void TestDracoFiles::documents_keepTheirParts()
{
    const core::PartList list({{7, "Body", true, true, core::Rgb{1, 2, 3}}, {2, "Hat", false, false, std::nullopt}});
    core::DocumentMetadata metadata;
    metadata.frame.emplace().parts = list;
    core::writeMesh(file(QStringLiteral("plain.glb")), core::joined({{7, ball(), {}, {}}, {2, ball(), {}, {}}}),
                    {.metadata = metadata});
    QFile plain(m_dir.filePath(QStringLiteral("plain.glb")));
    QVERIFY(plain.open(QIODevice::ReadOnly));
    constexpr qsizetype headerSize = 20, sizeAt = 12;
    const QByteArray bytes = plain.readAll();
    std::uint32_t size = 0;
    std::copy_n(bytes.constData() + sizeAt, sizeof size, reinterpret_cast<char*>(&size));
    const QJsonObject json = QJsonDocument::fromJson(bytes.mid(headerSize, size)).object();
    Model model;
    addPacked(model, ball(), packed(ball(), {}));
    const QJsonObject node{{QStringLiteral("mesh"), 0}};
    model.json[QLatin1StringView("nodes")] = QJsonArray{node, node};
    model.json[QLatin1StringView("extensions")] = json[QLatin1StringView("extensions")];
    for (const bool keepsObjects : {false, true}) {
        const ReadResult result = read(model, keepsObjects);
        QVERIFY(result.parts == list);
        QCOMPARE(std::ranges::count(result.mesh.parts, core::PartId(7)), qsizetype(ball().points.size()));
        QCOMPARE(std::ranges::count(result.mesh.parts, core::PartId(2)), qsizetype(ball().points.size()));
    }
}

/// Nodes can share a mesh, and primitives can share a stream.
void TestDracoFiles::sharedStreams_areInstanced()
{
    Model model;
    addPacked(model, ball(), packed(ball(), {}));
    const QJsonValue primitive = model.json[QLatin1StringView("meshes")][0][QLatin1StringView("primitives")][0];
    change(model, "meshes/0/primitives", QJsonArray{primitive, primitive});
    QJsonArray nodes;
    for (int i = 0; i < 10; ++i)
        nodes.append(QJsonObject{{QStringLiteral("mesh"), 0}, {QStringLiteral("translation"), QJsonArray{i, 0, 0}}});
    model.json[QLatin1StringView("nodes")] = nodes;
    QCOMPARE(read(model).mesh.triangles.size(), 20 * ball().triangles.size());
}

void TestDracoFiles::sparseNumbers_replaceDecoded()
{
    const TriangleMesh mesh = shapes::scaled(shapes::tetrahedron(), 0.01F);
    Model model;
    addPacked(model, mesh, packed(mesh, {.method = draco::MESH_SEQUENTIAL_ENCODING}));
    const float moved[3]{5, 6, 7};
    const auto placesView = addView(model, QByteArray(1, '\2')),
               valuesView = addView(model, QByteArray(reinterpret_cast<const char*>(moved), sizeof moved));
    change(model, "accessors/0/sparse",
           QJsonObject{{QStringLiteral("count"), 1},
                       {QStringLiteral("indices"), QJsonObject{{QStringLiteral("bufferView"), placesView},
                                                               {QStringLiteral("componentType"), 5121}}},
                       {QStringLiteral("values"), QJsonObject{{QStringLiteral("bufferView"), valuesView}}}});
    const TriangleMesh result = read(model).mesh;
    QCOMPARE(result.points.size(), mesh.points.size());
    QVERIFY(distanceTo(result.points, Vec3f(5000, 6000, 7000)) < 1e-3F);
    int kept = 0;
    for (const Vec3f& point : mesh.points)
        kept += distanceTo(result.points, 1000 * point) < 1e-5F ? 1 : 0;
    QCOMPARE(kept, 3);
}

/// A stream contains triangles, whatever mode the primitive states.
void TestDracoFiles::stripsAreDecodedToTriangles()
{
    Model model;
    addPacked(model, ball(), packed(ball(), {}));
    change(model, "meshes/0/primitives/0/mode", 5);
    change(model, "accessors/1/count", 700); // number of indices of a strip
    QCOMPARE(read(model).mesh.triangles.size(), ball().triangles.size());
}

/// A file that does not require Draco and contains all uncompressed data is read without a decoder.
void TestDracoFiles::fallbacks_needNoDecoder()
{
    Model model;
    addPlain(model, ball());
    change(model, "meshes/0/primitives/0/extensions",
           QJsonObject{{QStringLiteral("KHR_draco_mesh_compression"), QJsonObject()}});
    const auto bytes = glbOf(model);
    QCOMPARE(core::parseMesh("a.glb", {bytes.data(), static_cast<std::size_t>(bytes.size())}).triangles.size(),
             ball().triangles.size());
    QCOMPARE(read(model).mesh.triangles.size(), ball().triangles.size());
}

void TestDracoFiles::unannouncedStreams_areDecoded()
{
    Model model;
    addPacked(model, ball(), packed(ball(), {}));
    model.json.remove(QLatin1StringView("extensionsRequired"));
    QCOMPARE(read(model).mesh.triangles.size(), ball().triangles.size());
    QFile::rename(m_dir.filePath(QStringLiteral("model.glb")), m_dir.filePath(QStringLiteral("a.glb~1")));
    QCOMPARE(core::readMesh(file(QStringLiteral("a.glb~1"))).triangles.size(), ball().triangles.size());
}

void TestDracoFiles::degenerateTriangles_areCounted()
{
    TriangleMesh mesh = ball();
    mesh.triangles.push_back({0, 1, 1});
    Model model;
    addPacked(model, mesh, packed(mesh, {.method = draco::MESH_SEQUENTIAL_ENCODING}));
    const ReadResult result = read(model);
    QCOMPARE(result.mesh.triangles.size(), ball().triangles.size());
    QCOMPARE(result.remarks.facesOfFewer, std::size_t(1));
}

/// The process's memory limit must suffice for well-compressed models: half a million triangles in about 300 kB.
void TestDracoFiles::largeModels_areRead()
{
    const TriangleMesh mesh = core::icosphere(byEffort(7, 8, 8), 0.1);
    Model model;
    addPacked(model, mesh, packed(mesh, {.bits = 11, .speed = 0}));
    write(QStringLiteral("large.bin"), model.binary);
    write(QStringLiteral("large.gltf"), jsonOf(model, QStringLiteral("large.bin")));
    const TriangleMesh result = core::readMesh(file(QStringLiteral("large.gltf")));
    QVERIFY(result.triangles.size() > mesh.triangles.size() * 99 / 100); // quantisation makes some triangles degenerate
    qInfo("%zu triangles in %lld bytes", mesh.triangles.size(), static_cast<long long>(model.binary.size()));
}

void TestDracoFiles::withoutDecoder_extensionIsNamed()
{
    Model model;
    addPacked(model, ball(), packed(ball(), {}));
    for (const bool isAnnounced : {true, false}) {
        if (!isAnnounced)
            model.json.remove(QLatin1StringView("extensionsRequired"));
        const QByteArray bytes = glbOf(model);
        try {
            core::parseMesh("a.glb", {bytes.data(), static_cast<std::size_t>(bytes.size())});
            QFAIL("nobody decodes it");
        } catch (const FileError& error) {
            QVERIFY(error.kind == Kind::Malformed && error.fault == FileFault::NeedsExtension);
            QCOMPARE(error.token, std::string("KHR_draco_mesh_compression"));
        }
    }
}

void TestDracoFiles::lies_areOneSentence_data()
{
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<QJsonValue>("value");
    QTest::addColumn<int>("fault");
    QTest::addColumn<QByteArray>("token");
    const auto row = [](const char* name, const QByteArray& path, const QJsonValue& value, FileFault fault,
                        const char* token) {
        QTest::newRow(name) << path << value << static_cast<int>(fault) << QByteArray(token);
    };
    const QByteArray extension = extensionPath;
    row("fewer vertices", "accessors/0/count", 161, FileFault::WrongAccessor, "accessors/0");
    row("more vertices", "accessors/0/count", 1000000000, FileFault::WrongAccessor, "accessors/0");
    row("other type", "accessors/0/type", QStringLiteral("VEC4"), FileFault::WrongAccessor, "accessors/0");
    row("fewer corners", "accessors/1/count", 3, FileFault::WrongAccessor, "accessors/1");
    row("more corners", "accessors/1/count", 1000000000, FileFault::WrongAccessor, "accessors/1");
    row("no such attribute", extension + "/attributes/POSITION", 7, FileFault::Missing, "POSITION");
    row("no number", extension + "/attributes/POSITION", -1, FileFault::NotAnIndex, "POSITION");
    row("beyond all numbers", extension + "/attributes/POSITION", 5000000000.0, FileFault::NotAnIndex, "POSITION");
    row("no attributes", extension + "/attributes", QJsonValue::Undefined, FileFault::NotAnObject, "attributes");
    row("no positions", extension + "/attributes", QJsonObject(), FileFault::Missing, "POSITION");
    row("no view", extension + "/bufferView", QJsonValue::Undefined, FileFault::Missing, "bufferView");
    row("no such view", extension + "/bufferView", 9, FileFault::Missing, "bufferViews/9");
    row("empty view", "bufferViews/0/byteLength", 0, FileFault::CompressedWrong, "bufferViews/0");
    row("shorter view", "bufferViews/0/byteLength", 40, FileFault::CompressedWrong, "bufferViews/0");
    row("moved view", "bufferViews/0/byteOffset", 1, FileFault::None, "");
    row("no object", extension, 3, FileFault::NotAnObject, "KHR_draco_mesh_compression");
}

void TestDracoFiles::lies_areOneSentence()
{
    QFETCH(QByteArray, path);
    QFETCH(QJsonValue, value);
    QFETCH(int, fault);
    QFETCH(QByteArray, token);
    Model model;
    addPacked(model, ball(), packed(ball(), {.bits = 12}));
    change(model, path.constData(), value);
    const auto error = errorOf(model);
    QVERIFY(error);
    if (fault == static_cast<int>(FileFault::None)) { // the view extends beyond the file
        QVERIFY(error->kind == Kind::CutOff);
        return;
    }
    QVERIFY(error->kind == Kind::Malformed);
    QCOMPARE(static_cast<int>(error->fault), fault);
    QCOMPARE(error->token, token.toStdString());
}

void TestDracoFiles::brokenStreams_areOneSentence()
{
    const int rounds = byEffort(60, 500, 20000);
    std::mt19937 engine(streamSeed);
    int refused = 0;
    for (int round = 0; round < rounds; ++round) {
        const bool isSequential = engine() % 2 == 0;
        QByteArray stream =
            packed(ball(), {.method = isSequential ? draco::MESH_SEQUENTIAL_ENCODING : draco::MESH_EDGEBREAKER_ENCODING,
                            .bits = engine() % 2 == 0 ? 0 : 12,
                            .speed = static_cast<int>(engine() % 11)});
        if (engine() % 3 == 0)
            stream.truncate(static_cast<qsizetype>(engine() % std::size_t(stream.size())));
        for (auto edits = engine() % 4; edits != 0 && !stream.isEmpty(); --edits) {
            const std::size_t room =
                engine() % 2 == 0 ? std::size_t(stream.size()) : std::min<std::size_t>(60, std::size_t(stream.size()));
            stream[static_cast<qsizetype>(engine() % room)] = static_cast<char>(engine());
        }
        Model model;
        addPacked(model, ball(), stream);
        const auto error = errorOf(model);
        refused += error ? 1 : 0;
        const bool isExpected = !error || error->kind == Kind::Malformed || error->kind == Kind::ReaderOutOfMemory ||
                                error->kind == Kind::ReaderDied || error->kind == Kind::ReaderTooSlow ||
                                error->kind == Kind::NotANumber || error->kind == Kind::IndexOutOfRange ||
                                error->kind == Kind::UnpacksTooLarge || error->kind == Kind::NoFaces;
        QVERIFY2(isExpected, qPrintable(QString::number(error ? static_cast<int>(error->kind) : -1)));
    }
    qInfo("%d of %d refused, seed %u", refused, rounds, streamSeed);
    Model cloud;
    addPacked(cloud, ball(), packed(ball(), {.method = draco::POINT_CLOUD_SEQUENTIAL_ENCODING, .isCloud = true}));
    const auto error = errorOf(cloud);
    QVERIFY(error && error->fault == FileFault::CompressedWrong);
}

/// A plane of equal squares compresses to almost nothing.
void TestDracoFiles::bombs_areRefused()
{
    constexpr core::Slot side = 1700;
    TriangleMesh plane;
    for (core::Slot y = 0; y < side; ++y)
        for (core::Slot x = 0; x < side; ++x)
            plane.points.push_back(Vec3f(static_cast<float>(x), static_cast<float>(y), 0));
    for (core::Slot y = 0; y + 1 < side; ++y)
        for (core::Slot x = 0; x + 1 < side; ++x) {
            const core::Slot at = y * side + x;
            plane.triangles.push_back({at, at + 1, at + side});
            plane.triangles.push_back({at + 1, at + side + 1, at + side});
        }
    Model model;
    addPacked(model, plane, packed(plane, {.bits = 11, .speed = 0}));
    QVERIFY(model.binary.size() < 700'000);
    const auto error = errorOf(model);
    QVERIFY(error);
    QVERIFY(error->kind == Kind::UnpacksTooLarge || error->kind == Kind::ReaderOutOfMemory);
    qInfo("%zu triangles in %lld bytes", plane.triangles.size(), static_cast<long long>(model.binary.size()));
}

/// A stream has neither a length nor an end mark. The decoder must not read beyond any truncated stream.
void TestDracoFiles::decoder_neverReadsBeyondItsStream()
{
    const std::uint32_t ids[]{0, 5};
    const QByteArray whole = packed(shapes::tetrahedron(), {.bits = 8});
    for (qsizetype size = 0; size < whole.size(); ++size) {
        const std::vector<char> bytes(whole.begin(), whole.begin() + size);
        const auto mesh = app::decodedDraco({bytes.data(), bytes.size()}, ids);
        QVERIFY(!mesh || mesh->corners.size() % 3 == 0);
    }
    const auto mesh = app::decodedDraco({whole.data(), static_cast<std::size_t>(whole.size())}, ids);
    QVERIFY(mesh && mesh->vertices == 4 && mesh->corners.size() == 12 && mesh->attributes.size() == 1);
}

FETTLE_TEST(TestDracoFiles)
#include "tst_draco_files.moc"
