// Tests mesh files: round trips without a changed bit, kind and place of errors in bad files, and mutations of good
// files.

#include "core/io/mesh_io.h"
#include "core/util/file_error.h"
#include "tests/support/effort.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <bit>
#include <clocale>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <locale>
#include <random>

#ifdef Q_OS_UNIX
#include <csignal>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace
{
using core::FileError;
using core::FilePlace;
using core::MeshFormat;
using core::Rgb;
using core::Slot;
using core::TriangleMesh;
using core::UpAxis;
using core::Vec3f;
using Kind = core::FileErrorKind;

constexpr unsigned seed = 20240812;
#ifdef Q_OS_UNIX
constexpr uid_t nobody = 65534;
#endif

std::string readBytes(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void writeBytes(const std::filesystem::path& path, std::string_view bytes)
{
    std::filesystem::remove(
        path); // some file systems flush a file that is overwritten, but not a new one; thousands are written here
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

bool sameBits(const Vec3f& a, const Vec3f& b)
{
    return std::memcmp(a.data(), b.data(), 3 * sizeof(float)) == 0;
}

bool sameBits(const TriangleMesh& a, const TriangleMesh& b)
{
    return a.triangles == b.triangles && a.colors == b.colors &&
           std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                      [](const Vec3f& p, const Vec3f& q) { return sameBits(p, q); });
}

/// Returns whether the corners of all triangles are equal, in order. STL stores nothing else.
bool sameCorners(const TriangleMesh& a, const TriangleMesh& b)
{
    if (a.triangles.size() != b.triangles.size())
        return false;
    for (std::size_t i = 0; i < a.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (!sameBits(a.points[a.triangles[i][k]], b.points[b.triangles[i][k]]))
                return false;
    return true;
}

std::vector<Rgb> readPalette(const std::filesystem::path& path)
{
    return core::readMetadata(path).palette;
}

bool isSound(const TriangleMesh& mesh)
{
    for (const core::Triangle& t : mesh.triangles)
        for (const Slot corner : t)
            if (corner >= mesh.points.size())
                return false;
    for (const Vec3f& p : mesh.points)
        if (!p.allFinite())
            return false;
    return !mesh.triangles.empty() && (mesh.colors.empty() || mesh.colors.size() == mesh.points.size());
}

/// Returns a mesh with coordinates of every exponent, and with random colours if `colored`.
TriangleMesh wildMesh(bool colored, bool minusZero)
{
    std::mt19937 engine(seed);
    TriangleMesh mesh;
    constexpr Slot count = 3000;
    const auto coordinate = [&] {
        for (;;) {
            const auto x = std::bit_cast<float>(static_cast<std::uint32_t>(engine()));
            if (std::isfinite(x))
                return x;
        }
    };
    for (Slot i = 0; i < count; ++i) {
        mesh.points.emplace_back(coordinate(), coordinate(), coordinate());
        mesh.triangles.push_back({i, (i + 1) % count, Slot((i + 2 + engine() % (count - 2)) % count)});
        if (colored)
            mesh.colors.push_back({std::uint8_t(engine()), std::uint8_t(engine()), std::uint8_t(engine())});
    }
    mesh.points[0] = {0, minusZero ? -0.0f : 0.0f, std::numeric_limits<float>::denorm_min()};
    mesh.points[1] = {std::numeric_limits<float>::max(), std::numeric_limits<float>::min(), 0.1f};
    return mesh;
}

/// Sets a locale with a decimal comma for the lifetime of the object.
class CommaLocale
{
public:
    CommaLocale()
        : m_cLocale(std::setlocale(LC_ALL, nullptr))
        , m_locale(std::locale::global(std::locale(std::locale(), new Commas)))
    {
        for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
            if (std::setlocale(LC_ALL, name))
                break;
    }
    ~CommaLocale()
    {
        std::locale::global(m_locale);
        std::setlocale(LC_ALL, m_cLocale.c_str());
    }

private:
    struct Commas : std::numpunct<char>
    {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    std::string m_cLocale;
    std::locale m_locale;
};

std::string bigEndianPly()
{
    const auto add = [](std::string& out, auto number) {
        auto bytes = std::bit_cast<std::array<char, sizeof number>>(number);
        if (std::endian::native == std::endian::little)
            std::reverse(bytes.begin(), bytes.end());
        out.append(bytes.data(), bytes.size());
    };
    std::string file =
        "ply\r\nformat binary_big_endian 1.0\r\ncomment by hand\\\r\nobj_info nothing\r\n"
        "element material 2\r\nproperty list ushort double weights\r\nproperty short id\r\n"
        "element vertex 4\r\nproperty double x\r\nproperty char flag\r\nproperty float y\r\nproperty short z\r\n"
        "property float red\r\nproperty float green\r\nproperty float blue\r\n"
        "element face 2\r\nproperty uchar what\r\nproperty list uchar uint vertex_index\r\nend_header\r\n";
    for (int i = 0; i < 2; ++i) {
        add(file, std::uint16_t(i));
        for (int k = 0; k < i; ++k)
            add(file, 0.5);
        add(file, std::int16_t(i));
    }
    for (const auto& [x, y, z] :
         {std::array{0, 0, 0}, std::array{2, 0, 0}, std::array{2, 3, 0}, std::array{0, 3, -1}}) {
        add(file, double(x));
        add(file, char(7));
        add(file, float(y));
        add(file, std::int16_t(z));
        for (const float c : {1.0f, 0.5f, float(x) / 2})
            add(file, c);
    }
    add(file, char(1));
    add(file, char(4));
    for (const std::uint32_t corner : {0u, 1u, 2u, 3u})
        add(file, corner);
    add(file, char(1));
    add(file, char(3));
    for (const std::uint32_t corner : {2u, 1u, 0u})
        add(file, corner);
    return file;
}

std::string smallStl()
{
    std::string file(80, ' ');
    file.replace(0, 5, "solid"); // binary files of some programs begin with "solid" like text files
    const auto add = [&file](auto number) {
        // works on little-endian machines only
        const auto bytes = std::bit_cast<std::array<char, sizeof number>>(number);
        file.append(bytes.data(), bytes.size());
    };
    const TriangleMesh mesh = shapes::tetrahedron();
    add(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const core::Triangle& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i)
            add(0.0f);
        for (const Slot corner : t)
            for (int i = 0; i < 3; ++i)
                add(mesh.points[corner][i]);
        add(std::uint16_t(0));
    }
    return file;
}

const char* const textStl =
    "solid a name with facet in it\n facet normal 0 0 nan\n  outer loop\n   vertex 0 0 0\n   VERTEX 1 -0 0\n"
    "   vertex +0 1e0 0.0\n  endloop\n endfacet\nendsolid\nsolid\nendsolid two\n";
const char* const smallObj =
    "# comment\nmtllib a.mtl\no one\nv 0 0 0 1 0 0\nv 1 0 0\\\n 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 1\nvt 0 0\nvn 0 0 1\n"
    "g first\nusemtl red\ns off\nf 1/1/1 2//1 3/1 4\no two\nv 0 0 5\nf -1 -2 -3\nl 1 2\n";
const char* const textPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n"
    "element face 2\nproperty list uchar int vertex_indices\nelement edge 1\nproperty int vertex1\n"
    "property int vertex2\nend_header\n0 0 0 255 0 0 9\n1 0 0 0 255 0 9\n1 1 0 0 0 255 9\n0 1 0 1 2 3 9\n"
    "4 0 1 2 3\n3 2 1 0\n0 1\n";

const char* const smallOff =
    "# before\nCNOFF # with colours and normals\n\n5 3 0 # counts\n0 0 0 0 0 1 255 0 0 255\n1 0 0 0 0 1 0 255 0 255 # "
    "second\n"
    "# between\n1 1 0 0 0 1\n0 1 0 0 0 1 1 2 3\n\n0 0 5 0 0 1 9 9 9 9\n4 0 1 2 3 0.5 0.5 0.5\n2 0 1\n3 4 3 2 7\n";

std::string glbOf(std::string json, std::string binary)
{
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4);
    const auto number = [](std::size_t value) {
        // works on little-endian machines only
        const auto bytes = std::bit_cast<std::array<char, 4>>(static_cast<std::uint32_t>(value));
        return std::string(bytes.data(), bytes.size());
    };
    return "glTF" + number(2) + number(28 + json.size() + binary.size()) + number(json.size()) + "JSON" + json +
           number(binary.size()) + std::string("BIN\0", 4) + binary;
}

std::string bytesOf(std::initializer_list<float> numbers)
{
    std::string bytes;
    for (const float x : numbers) {
        const auto four = std::bit_cast<std::array<char, 4>>(x);
        bytes.append(four.data(), four.size());
    }
    return bytes;
}

/// Returns four points 16 bytes apart, the third one given by a sparse accessor. A strip and a fan of two triangles
/// each are in two nodes.
std::string smallGlb()
{
    const std::string points = bytesOf({0, 0, 0, 9, 1, 0, 0, 9, 7, 7, 7, 9, 0, 1, 0, 9});
    const std::string third = bytesOf({1, 1, 0});
    return glbOf(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"children":[1,2],"scale":[0.001,0.001,0.001]},{"mesh":0,"translation":[0,0,5]},{"mesh":1,"matrix":[-1,0,0,0,
0,1,0,0,0,0,1,0,0,0,0,1]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":2},"indices":1,"mode":5}]},
{"primitives":[{"attributes":{"POSITION":0},"mode":6},{"attributes":{"POSITION":0},"mode":1}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,
"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":2}}},
{"bufferView":1,"byteOffset":1,"componentType":5121,"count":4,"type":"SCALAR"},
{"bufferView":3,"componentType":5121,"normalized":true,"count":4,"type":"VEC3"}],
"bufferViews":[{"buffer":0,"byteLength":64,"byteStride":16},{"buffer":0,"byteOffset":64,"byteLength":8},{"buffer":0,
"byteOffset":72,"byteLength":12},{"buffer":0,"byteOffset":84,"byteLength":12}],
"buffers":[{"byteLength":96}]})",
                 points + std::string("\2\0\1\3\2\0\0\0", 8) + third +
                     std::string("\377\0\0\0\377\0\0\0\377\0\0\0", 12));
}

double area(const TriangleMesh& mesh)
{
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3f u = mesh.points[b] - mesh.points[a], v = mesh.points[c] - mesh.points[a];
        sum += static_cast<double>(u.x()) * static_cast<double>(v.y()) -
               static_cast<double>(u.y()) * static_cast<double>(v.x());
    }
    return sum / 2;
}
} // namespace

class TestMeshIo : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();

    void roundTrip_isBitIdentical_data();
    void roundTrip_isBitIdentical();
    void palette_isKeptBesideTheModel();
    void palette_thatIsNoneIsNotRead();
    void stl_keepsCornersAndWelds();
    void upAxis_turnsExactlyAndWithoutMinusZero();
    void text_knowsNoLocale();
    void numbers_roundToNearestFloat();

    void stl_binaryMayBeginWithSolid();
    void stl_textIsRead();
    void stl_colorsOfVisCamAndMagicsAreRead();
    void obj_isRead();
    void obj_facesMayComeBeforeVertices();
    void ply_textIsRead();
    void ply_bigEndianIsRead();
    void off_isRead();
    void off_colorsGoToOneOrTo255();
    void glb_isReadInMillimetres();
    void glb_nodesStripsAndSparseAccessorsAreRead();
    void glb_colorsComeBackFromLight();
    void remarks_tellWhatIsLeftOut();
    void equalVertices_areWelded();
    void polygons_areCutInside();

    void badInput_data();
    void badInput();
    void badFiles_areRefused();
    void hugeFiles_areRefusedQuickly();
    void truncatedFiles_areRefused_data();
    void truncatedFiles_areRefused();
    void mutatedFiles_neverGetThrough_data();
    void mutatedFiles_neverGetThrough();

    void writing_failsWithoutTrace();
    void writing_replacesWhatLinksPointTo();
    void writing_makesWhatDanglingLinksPointTo();
    void writing_diskLimitLeavesTheOldFile();

private:
    std::filesystem::path file(const std::string& name) const
    {
        return std::filesystem::path(m_dir.path().toStdString()) / name;
    }
    QStringList filesThere() const
    {
        return QDir(m_dir.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    TriangleMesh parsed(const std::string& name, std::string_view bytes) const;
    std::optional<FileError> errorOf(const std::function<void()>& action) const;

    QTemporaryDir m_dir;
};

void TestMeshIo::initTestCase()
{
    QVERIFY(m_dir.isValid());
}

TriangleMesh TestMeshIo::parsed(const std::string& name, std::string_view bytes) const
{
    writeBytes(file(name), bytes);
    return core::readMesh(file(name), {.up = UpAxis::Y});
}

std::optional<FileError> TestMeshIo::errorOf(const std::function<void()>& action) const
{
    try {
        action();
    } catch (const FileError& error) {
        return error;
    }
    return std::nullopt;
}

void TestMeshIo::roundTrip_isBitIdentical_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("ascii");
    QTest::addColumn<bool>("colored");
    for (const char* name : {"a.obj", "a.ply", "A.PLY", "a.off", "a.glb", "a.3mf"})
        for (const bool ascii : {false, true})
            for (const bool colored : {false, true})
                QTest::newRow(qPrintable(QString("%1 %2 %3").arg(QString(name)).arg(ascii).arg(colored)))
                    << QString(name) << ascii << colored;
}

void TestMeshIo::roundTrip_isBitIdentical()
{
    QFETCH(QString, name);
    QFETCH(bool, ascii);
    QFETCH(bool, colored);
    const TriangleMesh mesh = wildMesh(colored, true);
    const auto path = file(name.toStdString());
    core::writeMesh(path, mesh, {.up = UpAxis::Y, .ascii = ascii});
    QVERIFY(sameBits(core::readMesh(path, {.up = UpAxis::Y}), mesh));
    const TriangleMesh plain = wildMesh(colored, false); // the rotation from Z up to Y up would lose the sign of -0
    core::writeMesh(path, plain, {.up = UpAxis::Z, .ascii = ascii});
    QVERIFY(sameBits(core::readMesh(path, {.up = UpAxis::Z}), plain));
}

void TestMeshIo::palette_isKeptBesideTheModel()
{
    const std::vector<Rgb> palette = {{0, 0, 0}, {255, 254, 253}, {1, 160, 18}};
    const TriangleMesh ball = core::icosphere(2, 10);
    for (const char* name : {"a.ply", "a.obj", "a.off", "a.glb", "a.3mf"})
        for (const bool ascii : {false, true}) {
            core::writeMesh(
                file(name), ball,
                {.ascii = ascii,
                 .metadata = {.palette = palette, .frame = {}, .view = {}, .brush = {}, .work = {}, .references = {}}});
            QVERIFY2(readPalette(file(name)) == palette, name);
            QVERIFY2(core::readMesh(file(name)).points == ball.points, name);
            core::writeMesh(file(name), ball, {.ascii = ascii});
            QVERIFY2(readPalette(file(name)).empty(), name);
        }
    core::writeMesh(
        file("a.stl"), ball,
        {.metadata = {.palette = palette, .frame = {}, .view = {}, .brush = {}, .work = {}, .references = {}}});
    QVERIFY(readPalette(file("a.stl")).empty());
    QVERIFY(readPalette(file("none.ply")).empty());
}

void TestMeshIo::palette_thatIsNoneIsNotRead()
{
    for (const std::string_view line : {"# fettle palette 12345\n", "# fettle palette 123456 zz0000\n",
                                        "# fettle palette 1234567\n", "# fettle palette -12345\n", "# fettle palette",
                                        "# fettle palette 123456  123456\n", "fettle palette 123456\n"}) {
        writeBytes(file("a.obj"), line);
        QVERIFY2(readPalette(file("a.obj")).empty(), line.data());
    }
    writeBytes(file("a.obj"), "# fettle palette 123456\r\nv 0 0 0\n");
    QVERIFY((readPalette(file("a.obj")) == std::vector<Rgb>{{0x12, 0x34, 0x56}}));
}

void TestMeshIo::stl_keepsCornersAndWelds()
{
    for (const bool ascii : {false, true}) {
        const TriangleMesh wild = wildMesh(false, false);
        core::writeMesh(file("a.stl"), wild, {.up = {}, .ascii = ascii});
        const TriangleMesh back = core::readMesh(file("a.stl"));
        QVERIFY(sameCorners(back, wild));
        core::writeMesh(file("b.stl"), back, {.up = {}, .ascii = ascii});
        QCOMPARE(readBytes(file("a.stl")), readBytes(file("b.stl")));

        const TriangleMesh ball = core::icosphere(3, 10);
        core::writeMesh(file("a.stl"), ball, {.up = {}, .ascii = ascii});
        QCOMPARE(core::readMesh(file("a.stl")).points.size(), ball.points.size());
    }
    TriangleMesh zeros{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, 0, -0.0f}}, {}, {{0, 1, 2}, {3, 2, 1}}};
    core::writeMesh(file("a.stl"), zeros, {.up = UpAxis::Y});
    QCOMPARE(core::readMesh(file("a.stl")).points.size(), std::size_t(3));
}

void TestMeshIo::upAxis_turnsExactlyAndWithoutMinusZero()
{
    const TriangleMesh mesh{{{1, 2, 3}, {0, 0, 0}, {4, -0.0f, 5}}, {}, {{0, 1, 2}}};
    core::writeMesh(file("a.stl"), mesh);
    const TriangleMesh printed = core::readMesh(file("a.stl"), {.up = UpAxis::Y});
    QVERIFY(sameBits(printed.points[0], {1, -3, 2}));
    QVERIFY(sameBits(printed.points[1], {0, 0, 0}));
    QVERIFY(sameBits(printed.points[2], {4, -5, 0}));
    QVERIFY(sameBits(core::readMesh(file("a.stl")).points[0], {1, 2, 3}));
    core::writeMesh(file("a.obj"), mesh);
    QVERIFY(sameBits(core::readMesh(file("a.obj")), mesh));
    QVERIFY(sameBits(core::readMesh(file("a.obj"), {.up = UpAxis::Z}).points[0], {1, 3, -2}));
}

void TestMeshIo::text_knowsNoLocale()
{
    const CommaLocale commas;
    TriangleMesh mesh = wildMesh(true, false);
    core::writeMesh(file("a.obj"), mesh);
    QVERIFY(readBytes(file("a.obj")).find(',') == std::string::npos);
    QVERIFY(sameBits(core::readMesh(file("a.obj")), mesh));
    core::writeMesh(file("a.off"), mesh);
    QVERIFY(readBytes(file("a.off")).find(',') == std::string::npos);
    QVERIFY(sameBits(core::readMesh(file("a.off")), mesh));
    core::writeMesh(file("a.3mf"), mesh);
    QVERIFY(sameBits(core::readMesh(file("a.3mf")), mesh));
    core::writeMesh(file("a.ply"), mesh, {.up = {}, .ascii = true});
    QVERIFY(sameBits(core::readMesh(file("a.ply")), mesh));
    core::writeMesh(file("a.stl"), mesh, {.up = {}, .ascii = true});
    QVERIFY(sameCorners(core::readMesh(file("a.stl")), mesh));
}

void TestMeshIo::numbers_roundToNearestFloat()
{
    const TriangleMesh mesh =
        parsed("a.obj", "v 0.1 16777217 1e-50\nv -1e-400 +2.5 3.4028235e38\nv 1e-45 -1e-60 .5\nf 1 2 3");
    QVERIFY(sameBits(mesh.points[0], {0.1f, 16777216.0f, 0.0f}));
    QVERIFY(sameBits(mesh.points[1], {-0.0f, 2.5f, std::numeric_limits<float>::max()}));
    QVERIFY(sameBits(mesh.points[2], {std::numeric_limits<float>::denorm_min(), -0.0f, 0.5f}));
}

void TestMeshIo::stl_binaryMayBeginWithSolid()
{
    const TriangleMesh mesh = parsed("a.stl", smallStl());
    QVERIFY(sameCorners(mesh, shapes::tetrahedron()));
    QCOMPARE(mesh.points.size(), std::size_t(4));
}

void TestMeshIo::stl_textIsRead()
{
    const TriangleMesh mesh = parsed("a.stl", textStl);
    QCOMPARE(mesh.triangles.size(), std::size_t(1));
    QVERIFY(sameBits(mesh.points[1], {1, 0, 0}));
    QVERIFY(sameBits(mesh.points[2], {0, 1, 0}));
}

void TestMeshIo::stl_colorsOfVisCamAndMagicsAreRead()
{
    const auto colorsOf = [this](std::string header, const std::array<std::uint16_t, 4>& words) {
        std::string bytes = smallStl();
        header.resize(80, ' ');
        bytes.replace(0, 80, header);
        for (std::size_t i = 0; i < words.size(); ++i) {
            bytes[84 + 50 * i + 48] = static_cast<char>(words[i] & 0xff);
            bytes[84 + 50 * i + 49] = static_cast<char>(words[i] >> 8);
        }
        const TriangleMesh mesh = parsed("a.stl", bytes);
        std::vector<Rgb> colors = mesh.colors;
        std::sort(colors.begin(), colors.end(),
                  [](Rgb a, Rgb b) { return std::tie(a.r, a.g, a.b) < std::tie(b.r, b.g, b.b); });
        return colors;
    };
    const std::uint16_t red = 31, green = 31 << 5, high = 31 << 10, flag = 1 << 15;
    QVERIFY(colorsOf("plain", {0, 0, 0, 0}).empty());
    QVERIFY(colorsOf("other bits", {7, 9, 0, 0}).empty());
    const auto all = [](Rgb color) { return std::vector<Rgb>(4, color); };
    const std::uint16_t viscamRed = flag | high;
    QCOMPARE(colorsOf("viscam", {viscamRed, viscamRed, viscamRed, viscamRed}), all({255, 0, 0}));
    const std::string magics = "COLOR=\x0a\x14\x1e\xff";
    QCOMPARE(colorsOf(magics, {0, 0, 0, 0}), all({10, 20, 30}));
    QCOMPARE(colorsOf(magics, {flag, flag, flag, flag}), all({10, 20, 30}));
    QCOMPARE(colorsOf(magics, {red, red, red, red}), all({255, 0, 0}));
    // Each vertex of a tetrahedron is at three faces. One vertex is not at the green face.
    QCOMPARE(colorsOf(magics, {red, red, red, green}),
             (std::vector<Rgb>{{170, 85, 0}, {170, 85, 0}, {170, 85, 0}, {255, 0, 0}}));
}

void TestMeshIo::obj_isRead()
{
    const TriangleMesh mesh = parsed("a.obj", smallObj);
    QCOMPARE(mesh.points.size(), std::size_t(5));
    const std::vector<core::Triangle> expected{{0, 1, 2}, {0, 2, 3}, {4, 3, 2}};
    QCOMPARE(mesh.triangles, expected);
    QCOMPARE(mesh.colors.size(), mesh.points.size());
    QCOMPARE(mesh.colors[1], (Rgb{0, 255, 0}));
    QCOMPARE(mesh.colors[4], Rgb());
    std::string oldMac = smallObj;
    std::replace(oldMac.begin(), oldMac.end(), '\n', '\r');
    QVERIFY(sameBits(parsed("a.obj", "\xef\xbb\xbf" + oldMac), mesh));
}

void TestMeshIo::obj_facesMayComeBeforeVertices()
{
    const TriangleMesh mesh = parsed("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
    QCOMPARE(mesh.triangles.size(), std::size_t(1));
}

void TestMeshIo::ply_textIsRead()
{
    const TriangleMesh mesh = parsed("a.ply", textPly);
    const std::vector<core::Triangle> expected{{0, 1, 2}, {0, 2, 3}, {2, 1, 0}};
    QCOMPARE(mesh.triangles, expected);
    QCOMPARE(mesh.colors[3], (Rgb{1, 2, 3}));
}

void TestMeshIo::ply_bigEndianIsRead()
{
    const TriangleMesh mesh = parsed("a.ply", bigEndianPly());
    QCOMPARE(mesh.points.size(), std::size_t(4));
    QVERIFY(sameBits(mesh.points[3], {0, 3, -1}));
    QCOMPARE(mesh.colors[1], (Rgb{255, 128, 255}));
    QCOMPARE(mesh.triangles.size(), std::size_t(3));
    QCOMPARE(mesh.triangles[2], (core::Triangle{2, 1, 0}));
}

void TestMeshIo::off_isRead()
{
    const TriangleMesh mesh = parsed("a.off", smallOff);
    const std::vector<core::Triangle> expected{{0, 1, 2}, {0, 2, 3}, {4, 3, 2}};
    QCOMPARE(mesh.triangles, expected);
    QCOMPARE(mesh.points.size(), std::size_t(5));
    QVERIFY(sameBits(mesh.points[4], {0, 0, 5}));
    QCOMPARE(mesh.colors.size(), mesh.points.size());
    QCOMPARE(mesh.colors[1], (Rgb{0, 255, 0}));
    QCOMPARE(mesh.colors[2], Rgb());
    QCOMPARE(mesh.colors[3], (Rgb{1, 2, 3}));
    QCOMPARE(parsed("a.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2").triangles.size(), std::size_t(1));
}

void TestMeshIo::off_colorsGoToOneOrTo255()
{
    const auto colorOf = [this](const std::string& words) {
        return parsed("a.off", "COFF\n3 1 0\n0 0 0 " + words + "\n1 0 0\n0 1 0\n3 0 1 2\n").colors.at(0);
    };
    QCOMPARE(colorOf("1 0 0.5 1"), (Rgb{255, 0, 128}));
    QCOMPARE(colorOf("1 0 0 1"), (Rgb{255, 0, 0}));
    QCOMPARE(colorOf("1 0 0 255"), (Rgb{1, 0, 0}));
    QCOMPARE(colorOf("200 100 0"), (Rgb{200, 100, 0}));
}

void TestMeshIo::glb_isReadInMillimetres()
{
    core::writeMesh(file("a.glb"), shapes::cube(40));
    QVERIFY(sameBits(core::readMesh(file("a.glb")), shapes::cube(40)));
    const std::string metres = glbOf(
        R"({"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"byteLength":36}],
"buffers":[{"byteLength":36}]})",
        bytesOf({0, 0, 0, 1, 0, 0, 0, 0.5F, 0}));
    const TriangleMesh mesh = parsed("a.glb", metres);
    QVERIFY(sameBits(mesh.points[1], {1000, 0, 0}));
    QVERIFY(sameBits(mesh.points[2], {0, 500, 0}));
    QVERIFY(mesh.colors.empty());
}

void TestMeshIo::glb_nodesStripsAndSparseAccessorsAreRead()
{
    const TriangleMesh mesh = parsed("a.glb", smallGlb());
    const std::vector<core::Triangle> expected{{0, 1, 3}, {1, 2, 3}, {4, 6, 5}, {4, 7, 6}};
    QCOMPARE(mesh.triangles, expected);
    QVERIFY(sameBits(mesh.points[2], {1, 1, 5}));  // from the sparse accessor, translated
    QVERIFY(sameBits(mesh.points[6], {-1, 1, 0})); // mirrored by its node
    QCOMPARE(mesh.colors[0], (Rgb{255, 0, 0}));
    QCOMPARE(mesh.colors[1], (Rgb{0, 255, 0}));
    QCOMPARE(mesh.colors[7], Rgb());
}

void TestMeshIo::glb_colorsComeBackFromLight()
{
    TriangleMesh mesh = core::icosphere(3, 10);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        mesh.colors.push_back(
            {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(255 - i), static_cast<std::uint8_t>(7 * i)});
    QVERIFY(mesh.points.size() >= 256);
    core::writeMesh(file("a.glb"), mesh);
    QVERIFY(sameBits(core::readMesh(file("a.glb")), mesh));
}

void TestMeshIo::remarks_tellWhatIsLeftOut()
{
    const auto remarksOf = [this](const char* name, std::string_view bytes) {
        writeBytes(file(name), bytes);
        return core::readModel(file(name)).remarks;
    };
    const core::ReadRemarks obj = remarksOf("a.obj", smallObj);
    QVERIFY(obj.materials && !obj.textures && !obj.poses);
    QCOMPARE(obj.objects, std::size_t(2));
    QVERIFY(remarksOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n") == core::ReadRemarks());
    QCOMPARE(remarksOf("a.glb", smallGlb()).objects, std::size_t(2));
    const std::string surfaces = "cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 3\nparm u 0 1\nparm v 0 1\nend\n"
                                 "cstype bezier\ndeg 1\ncurv 0 1 1 2\nparm u 0 1\nend\nbzp 1 2 3\n";
    core::ReadRemarks two;
    two.unreadNodes = 2;
    QVERIFY(remarksOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + surfaces) == two);
    QVERIFY(remarksOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\ncall a.obj\nf 1 2 3\ncall b.obj 7\n") == two);
    core::WriteOptions options;
    options.metadata.palette = {{1, 2, 3}};
    for (const std::string_view ending : core::writtenEndings()) { // Fettle's own files have nothing to remark on
        const auto path = file("own." + std::string(ending));
        core::writeMesh(path, shapes::cube(1), options);
        QVERIFY(core::readModel(path).remarks == core::ReadRemarks());
    }
}

void TestMeshIo::equalVertices_areWelded()
{
    const TriangleMesh mesh =
        parsed("a.obj",
               "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 0 0 0 0 1\nv 0 1 0\nv -0 0 0\nv 1 1 0\nf 1 2 4\nf 4 3 6\nf 5 4 6\n");
    QCOMPARE(mesh.points.size(), std::size_t(4));
    const std::vector<core::Triangle> expected{{0, 1, 2}, {2, 1, 3}, {0, 2, 3}};
    QCOMPARE(mesh.triangles, expected);
    QCOMPARE(mesh.colors[1], (Rgb{0, 255, 0}));
    QCOMPARE(mesh.colors.size(), mesh.points.size());
}

/// Tests star-shaped, mostly concave polygons. Their triangles must face as the polygon does and cover its area.
void TestMeshIo::polygons_areCutInside()
{
    std::mt19937 engine(seed);
    for (int n = 3; n < 40; ++n) {
        for (int repeat = 0; repeat < 50; ++repeat) {
            std::string obj;
            double expected = 0;
            std::vector<Vec3f> ring;
            for (int i = 0; i < n; ++i) {
                const double angle = 6.283185307179586 * i / n;
                const double r = std::uniform_real_distribution(0.2, 3.0)(engine);
                ring.push_back(core::Vec3(r * std::cos(angle), r * std::sin(angle), 0).cast<float>());
                obj += "v " + std::to_string(ring.back().x()) + " " + std::to_string(ring.back().y()) + " 0\n";
            }
            obj += "f";
            for (int i = 1; i <= n; ++i)
                obj += " " + std::to_string(i);
            const TriangleMesh mesh = parsed("a.obj", obj + "\n");
            for (int i = 0; i < n; ++i) {
                const Vec3f &p = mesh.points[std::size_t(i)], &q = mesh.points[std::size_t((i + 1) % n)];
                expected += (static_cast<double>(p.x()) * static_cast<double>(q.y()) -
                             static_cast<double>(q.x()) * static_cast<double>(p.y())) /
                            2;
            }
            QCOMPARE(mesh.triangles.size(), std::size_t(n - 2));
            QVERIFY(std::abs(area(mesh) - expected) < 1e-4);
            for (const core::Triangle& t : mesh.triangles)
                QVERIFY(area({mesh.points, {}, {t}}) > 0);
        }
    }
}

void TestMeshIo::badInput_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<QString>("place");
    QTest::addColumn<QString>("token");
    const auto row = [](const char* what, const char* name, const QByteArray& bytes, Kind kind, const char* place,
                        const char* token = "") {
        QTest::newRow(what) << QString(name) << bytes << kind << QString(place) << QString(token);
    };
    const QByteArray stl = QByteArray::fromStdString(smallStl());
    const auto stlWith = [&stl](int at, const QByteArray& bytes) {
        return QByteArray(stl).replace(at, bytes.size(), bytes);
    };
    const QByteArray ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

    row("empty", "a.stl", "", Kind::Empty, "");
    row("unknown ending", "a.xyz", "v 0 0 0", Kind::UnknownFormat, "", "xyz");
    row("no ending", "a", "v 0 0 0", Kind::UnknownFormat, "");
    row("obj as stl", "a.stl", smallObj, Kind::NotWhatItsEndingSays, "byte 0", "obj");
    row("ply as stl", "a.stl", textPly, Kind::NotWhatItsEndingSays, "byte 0", "ply");
    row("stl as obj", "a.obj", stl, Kind::NotWhatItsEndingSays, "byte 0", "stl");
    row("text stl as obj", "a.obj", textStl, Kind::NotWhatItsEndingSays, "byte 0", "stl");
    row("stl as ply", "a.ply", stl, Kind::NotWhatItsEndingSays, "byte 0", "stl");
    row("png as stl", "a.stl", "\x89PNG\r\n\x1a\n0000", Kind::NotWhatItsEndingSays, "byte 0", "png");
    row("html as obj", "a.obj", "<!DOCTYPE html><html>not found</html>", Kind::NotWhatItsEndingSays, "byte 0", "html");
    row("prose as obj", "a.obj", "Dear reader,\nhere is no model.\n", Kind::NotWhatItsEndingSays, "", "");
    row("prose as stl", "a.stl", "Dear reader,\nhere is no model.\n", Kind::NotWhatItsEndingSays, "byte 0", "text");
    row("zeros as obj", "a.obj", QByteArray(500, '\0'), Kind::NotWhatItsEndingSays, "byte 0");

    row("stl cut off", "a.stl", stl.left(200), Kind::CutOff, "byte 200");
    row("stl cut off in the header", "a.stl", QByteArray(40, '\0'), Kind::CutOff, "byte 40");
    row("stl lying high", "a.stl", stlWith(80, "\xff\xff\xff\x7f").chopped(50), Kind::CutOff, "byte 234");
    row("stl cut off by one", "a.stl", stlWith(80, QByteArray("\4\0\0\0", 4)).chopped(50), Kind::CutOff, "byte 234");
    row("stl of unknown count cut off", "a.stl", stlWith(80, "\xff\xff\xff\xff").chopped(1), Kind::CutOff, "byte 283");
    row("stl lying low", "a.stl", stlWith(80, QByteArray(4, '\0')) + 'x', Kind::CountMismatch, "byte 80");
    row("stl with nan", "a.stl", stlWith(84 + 50 + 12 + 4, QByteArray("\0\0\xc0\x7f", 4)), Kind::NotANumber,
        "byte 150");
    row("stl with infinity", "a.stl", stlWith(96, QByteArray("\0\0\x80\xff", 4)), Kind::NotANumber, "byte 96");
    row("stl without faces", "a.stl", QByteArray(84, '\0'), Kind::NoFaces, "");
    row("text stl cut off", "a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0", Kind::CutOff, "line 4");
    row("text stl with nan", "a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 nan 0\n", Kind::NotANumber,
        "line 4", "nan");
    row("text stl with comma", "a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 1,5 0\n", Kind::NotANumber,
        "line 4", "1,5");
    row("text stl garbled", "a.stl", "solid\nfacet normal 0 0 1\nouter lop\n", Kind::Malformed, "line 3", "lop");
    row("text stl without faces", "a.stl", "solid nothing\nendsolid nothing\n", Kind::NoFaces, "");

    row("obj with nan", "a.obj", "v 0 0 0\nv 0 nan 0\nv 1 1 1\nf 1 2 3\n", Kind::NotANumber, "line 2", "nan");
    row("obj beyond float", "a.obj", "v 0 0 0\nv 0 1e39 0\nv 1 1 1\nf 1 2 3\n", Kind::NotANumber, "line 2", "1e39");
    row("obj beyond double", "a.obj", "v 0 0 0\n\nv 0 1e3900 0\nv 1 1 1\nf 1 2 3\n", Kind::NotANumber, "line 3",
        "1e3900");
    row("obj with word", "a.obj", "v 0 zero 0\n", Kind::NotANumber, "line 1", "zero");
    row("obj with two coordinates", "a.obj", "v 0 0\nf 1 1 1\n", Kind::Malformed, "line 1");
    row("obj with eight numbers", "a.obj", "v 0 0 0 1 1 1 1 1\n", Kind::Malformed, "line 1", "1");
    row("obj index too large", "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\nf 1 2 4/1\nf 1 2 3\n", Kind::IndexOutOfRange,
        "line 4", "4");
    row("obj index 0", "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\nf 0 1 2\n", Kind::IndexOutOfRange, "line 4", "0");
    row("obj index too far back", "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\nf -4 1 2\n", Kind::IndexOutOfRange, "line 4",
        "-4");
    row("obj index of a word", "a.obj", "v 0 0 0\nf a 1 1\n", Kind::Malformed, "line 2", "a");
    row("off counts with commas", "a.off", "OFF\n8,12,0\n0 0 0\n", Kind::Malformed, "line 2", "8,12,0");
    row("obj index beyond 64 bits", "a.obj", "v 0 0 0\nf 99999999999999999999 1 1\n", Kind::NotANumber, "line 2",
        "99999999999999999999");
    row("obj face of two", "a.obj", "v 0 0 0\nv 1 0 0\nf 1 2\nv 0 0 1\n", Kind::NoFaces, "");
    row("obj cut off", "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2", Kind::CutOff, "line 4");
    row("obj without faces", "a.obj", "v 0 0 0\nv 1 0 0\n", Kind::NoFaces, "");

    row("obj as off", "a.off", smallObj, Kind::NotWhatItsEndingSays, "byte 0", "obj");
    row("off in four dimensions", "a.off", "4OFF\n1 1 0\n0 0 0 0\n", Kind::Malformed, "line 1", "4OFF");
    row("binary off", "a.off", "OFF BINARY\n0000", Kind::TooManyElements, "byte 11", "vertices");
    row("off lying", "a.off", "OFF\n4000 1 0\n0 0 0\n", Kind::CutOff, "line 4", "vertices");
    row("off with too many", "a.off", "OFF\n4000000000 1 0\n0 0 0\n", Kind::TooManyElements, "line 2", "vertices");
    row("off with nan", "a.off", "OFF\n3 1 0\n0 0 0\n0 nan 0\n1 1 1\n3 0 1 2\n", Kind::NotANumber, "line 4", "nan");
    row("off index too large", "a.off", "OFF\n3 1 0\n0 0 0\n0 1 0\n1 1 1\n3 0 1 3 \n", Kind::IndexOutOfRange, "line 6",
        "3");
    row("off face of none", "a.off", "OFF\n3 1 0\n0 0 0\n0 1 0\n1 1 1\n0 0 1 3\n", Kind::Malformed, "line 6", "0");
    row("off cut off", "a.off", "OFF\n3 1 0\n0 0 0\n0 1 0\n1 1 1\n3 0 1", Kind::CutOff, "line 6", "faces");
    row("off without faces", "a.off", "OFF\n3 0 0\n0 0 0\n0 1 0\n1 1 1\n", Kind::NoFaces, "");

    const QByteArray glb = QByteArray::fromStdString(smallGlb());
    const auto glbWith = [&glb](const char* old, const QByteArray& text) {
        return QByteArray(glb).replace(old, text.leftJustified(qsizetype(strlen(old))));
    };
    row("glb cut off", "a.glb", glb.left(glb.size() - 8), Kind::CutOff, "end");
    row("glb of version 1", "a.glb", QByteArray(glb).replace(4, 1, "\1"), Kind::Malformed, "byte 4", "1");
    row("glb without JSON", "a.glb", QByteArray(glb).replace(16, 4, "MORE"), Kind::Malformed, "byte 12");
    row("glb with broken JSON", "a.glb", glbWith("\"asset\"", "\"asset"), Kind::Malformed, "byte 32");
    row("glb index too large", "a.glb", QByteArray(glb).replace(glb.size() - 31, 1, "\4"), Kind::IndexOutOfRange, "",
        "4");
    row("glb accessor beyond its view", "a.glb",
        glbWith("\"count\":4,\"type\":\"SCALAR\"", "\"count\":9,\"type\":\"SCALAR\""), Kind::Malformed, "",
        "bufferViews/1");
    row("glb node of itself", "a.glb", glbWith("\"children\":[1,2]", "\"children\":[0,2]"), Kind::Malformed, "",
        "nodes");
    row("glb with far data", "a.glb", glbWith("\"byteLength\":96", "\"uri\":\"../a.b\""), Kind::OutsideFolder, "",
        "../a.b");
    row("glb that needs what we lack", "a.glb",
        QByteArray::fromStdString(glbOf(R"({"extensionsRequired":["KHR_draco_mesh_compression"]})", "")),
        Kind::Malformed, "", "KHR_draco_mesh_compression");

    row("ply without end of header", "a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", Kind::Malformed, "line 4");
    row("ply of unknown encoding", "a.ply", "ply\nformat utf8 1.0\nend_header\n", Kind::Malformed, "line 2", "utf8");
    row("ply of unknown type", "a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty half x\nend_header\n",
        Kind::Malformed, "line 4", "half");
    row("ply without z", "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
        Kind::Malformed, "line 3", "vertex");
    row("ply lying", "a.ply", QByteArray(ply).replace("vertex 3", "vertex 4000000000") + "0 0 0\n", Kind::CutOff, "end",
        "vertices");
    row("ply lying beyond 64 bits", "a.ply", QByteArray(ply).replace("vertex 3", "vertex 99999999999999999999"),
        Kind::NotANumber, "line 3", "99999999999999999999");
    row("ply binary lying", "a.ply",
        QByteArray(ply).replace("ascii", "binary_little_endian").replace("face 1", "face 1000000000") +
            QByteArray(100, '\0'),
        Kind::CutOff, "end", "faces");
    row("ply cut off", "a.ply", ply + "0 0 0\n1 0 0\n1 1", Kind::CutOff, "end", "vertices");
    row("ply one line short", "a.ply", ply + "0 0 0\n1 0 0\n1 1 0\n", Kind::CutOff, "line 13", "faces");
    row("ply with nan", "a.ply", ply + "0 0 0\n1 0 NaN\n1 1 0\n3 0 1 2\n", Kind::NotANumber, "line 11", "NaN");
    row("ply index too large", "a.ply", ply + "0 0 0\n1 0 0\n1 1 0\n3 0 1 3\n", Kind::IndexOutOfRange, "line 13", "3");
    row("ply index negative", "a.ply", ply + "0 0 0\n1 0 0\n1 1 0\n3 0 -1 2\n", Kind::IndexOutOfRange, "line 13", "-1");
    row("ply face of two", "a.ply", ply + "0 0 0\n1 0 0\n1 1 0\n2 0 1\n", Kind::NoFaces, "");
    row("ply face of less than none", "a.ply", ply + "0 0 0\n1 0 0\n1 1 0\n-3 0 1 2\n", Kind::Malformed, "line 13",
        "-3");
    row("ply face too large", "a.ply", ply + "0 0 0\n1 0 0\n1 1 0\n100000000 0 1\n", Kind::TooManyElements, "line 13",
        "corners");
    row("ply face lying", "a.ply", ply + "0 0 0\n1 0 0\n1 1 0\n100000 0 1\n", Kind::CutOff, "line 14", "faces");
    row("ply without faces", "a.ply", QByteArray(ply).replace("face 1", "face 0") + "0 0 0\n1 0 0\n1 1 0\n",
        Kind::NoFaces, "");
}

void TestMeshIo::badInput()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(Kind, kind);
    QFETCH(QString, place);
    QFETCH(QString, token);
    if (place == "end")
        place = QString("byte %1").arg(bytes.size());
    const auto error = errorOf([&] { parsed(name.toStdString(), {bytes.constData(), std::size_t(bytes.size())}); });
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->kind), static_cast<int>(kind));
    const QString unit = error->place.unit == FilePlace::Unit::Line ? "line " : "byte ";
    QCOMPARE(error->place.unit == FilePlace::Unit::None ? QString() : unit + QString::number(error->place.number),
             place);
    QCOMPARE(QString::fromStdString(error->token), token);
    QVERIFY(error->path == file(name.toStdString()));
}

void TestMeshIo::badFiles_areRefused()
{
    const auto kindOf = [this](const std::string& name) {
        const auto error = errorOf([&] { core::readMesh(file(name)); });
        return error ? static_cast<int>(error->kind) : -1;
    };
    QCOMPARE(kindOf("nowhere.stl"), static_cast<int>(Kind::NotFound));
    QCOMPARE(kindOf("nowhere/a.stl"), static_cast<int>(Kind::NotFound));
    std::filesystem::create_directory(file("folder.stl"));
    QCOMPARE(kindOf("folder.stl"), static_cast<int>(Kind::NotAFile));
    writeBytes(file("closed.stl"), smallStl());
    std::filesystem::permissions(file("closed.stl"), std::filesystem::perms::none);
#ifdef Q_OS_UNIX
    const bool mayReadAll = geteuid() == 0; // root may read any file, so another user tries
    if (mayReadAll) {
        std::filesystem::permissions(m_dir.path().toStdString(), std::filesystem::perms(0755));
        QCOMPARE(seteuid(nobody), 0);
    }
    const int kind = kindOf("closed.stl");
    if (mayReadAll)
        QCOMPARE(seteuid(0), 0);
    QCOMPARE(kind, static_cast<int>(Kind::NotReadable));
#endif
}

void TestMeshIo::hugeFiles_areRefusedQuickly()
{
    const auto sparse = [this](const std::string& name, const std::string& start, std::uintmax_t size) {
        writeBytes(file(name), start);
        std::filesystem::resize_file(file(name), size);
        QElapsedTimer timer;
        timer.start();
        const auto error = errorOf([&] { core::readMesh(file(name)); });
        const bool quick = timer.elapsed() < 500;
        std::filesystem::remove(file(name));
        return error && quick ? static_cast<int>(error->kind) : -1;
    };
    constexpr std::uintmax_t gigabyte = 1'000'000'000;
    for (const char* name : {"huge.stl", "huge.obj", "huge.ply", "huge.off", "huge.glb", "huge.3mf", "huge.amf"})
        QCOMPARE(sparse(name, "", 3 * gigabyte), static_cast<int>(Kind::TooLarge));
    QCOMPARE(sparse("zeros.stl", "", 2 * gigabyte), static_cast<int>(Kind::CountMismatch));
    QCOMPARE(sparse("zeros.obj", "", 2 * gigabyte), static_cast<int>(Kind::NotWhatItsEndingSays));
    QCOMPARE(sparse("zeros.ply", "", 2 * gigabyte), static_cast<int>(Kind::NotWhatItsEndingSays));
}

void TestMeshIo::truncatedFiles_areRefused_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    // whether the file is refused at every length, except when only the final line break is missing
    QTest::addColumn<bool>("always");
    const TriangleMesh small = shapes::tetrahedron();
    const auto written = [&](const char* name, bool ascii) {
        core::writeMesh(file(name), small, {.up = {}, .ascii = ascii});
        return QByteArray::fromStdString(readBytes(file(name)));
    };
    QTest::newRow("binary stl") << "a.stl" << written("w.stl", false) << true;
    QTest::newRow("text stl") << "a.stl" << written("w.stl", true) << true;
    QTest::newRow("binary ply") << "a.ply" << written("w.ply", false) << true;
    QTest::newRow("text ply") << "a.ply" << written("w.ply", true) << true;
    QTest::newRow("big-endian ply") << "a.ply" << QByteArray::fromStdString(bigEndianPly()) << true;
    QTest::newRow("glb") << "a.glb" << written("w.glb", false) << true;
    QTest::newRow("3mf") << "a.3mf" << written("w.3mf", false) << true;
    QTest::newRow("off") << "a.off" << written("w.off", false) << true;
    // a truncated colour can still be valid
    QTest::newRow("off of all kinds") << "a.off" << QByteArray(smallOff) << false;
    QTest::newRow("obj") << "a.obj" << written("w.obj", false) << false; // OBJ has no end marker
    QTest::newRow("obj of all kinds") << "a.obj" << QByteArray(smallObj) << false;
}

void TestMeshIo::truncatedFiles_areRefused()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(bool, always);
    for (qsizetype length = 0; length < bytes.size() - 1; ++length) {
        const auto error = errorOf([&] {
            const TriangleMesh mesh = parsed(name.toStdString(), {bytes.constData(), std::size_t(length)});
            QVERIFY(isSound(mesh));
        });
        QVERIFY2(error || !always, qPrintable(QString::number(length)));
    }
}

void TestMeshIo::mutatedFiles_neverGetThrough_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("binary stl") << "a.stl" << QByteArray::fromStdString(smallStl());
    QTest::newRow("text stl") << "a.stl" << QByteArray(textStl);
    QTest::newRow("obj") << "a.obj" << QByteArray(smallObj);
    QTest::newRow("off") << "a.off" << QByteArray(smallOff);
    QTest::newRow("glb") << "a.glb" << QByteArray::fromStdString(smallGlb());
    QTest::newRow("text ply") << "a.ply" << QByteArray(textPly);
    QTest::newRow("big-endian ply") << "a.ply" << QByteArray::fromStdString(bigEndianPly());
    core::writeMesh(file("w.ply"), shapes::cube(1));
    QTest::newRow("binary ply") << "a.ply" << QByteArray::fromStdString(readBytes(file("w.ply")));
    core::writeMesh(file("w.3mf"), shapes::cube(1));
    QTest::newRow("3mf") << "a.3mf" << QByteArray::fromStdString(readBytes(file("w.3mf")));
}

/// Any bytes must give an error or a mesh that meets the reader's guarantees, without a crash and in bounded time.
void TestMeshIo::mutatedFiles_neverGetThrough()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    const int rounds = byEffort(300, 1'500, 200'000);
    const QList<QByteArray> words{"-1",
                                  "0",
                                  "4294967295",
                                  "99999999999",
                                  "1e99",
                                  "nan",
                                  "-",
                                  "f",
                                  "v",
                                  "\n",
                                  "\r",
                                  "\\\n",
                                  " ",
                                  "/",
                                  "list",
                                  "vertex",
                                  QByteArray(1, '\0'),
                                  "\xff\xff\xff\xff",
                                  "2147483647",
                                  "3",
                                  "inf",
                                  "+",
                                  "element face 7\n"};
    std::mt19937 engine(seed);
    int refused = 0;
    for (int round = 0; round < rounds; ++round) {
        QByteArray mutated = bytes;
        for (auto edits = 1 + engine() % 3; edits != 0; --edits) {
            const auto at = static_cast<qsizetype>(engine() % std::size_t(mutated.size()));
            switch (engine() % 4) {
            case 0:
                mutated[at] = static_cast<char>(engine());
                break;
            case 1:
                mutated.remove(at, 1 + engine() % 8);
                break;
            case 2:
                mutated.insert(at, words[qsizetype(engine() % std::size_t(words.size()))]);
                break;
            default:
                mutated[at] = static_cast<char>(mutated[at] ^ (1 << engine() % 8));
                break;
            }
            if (mutated.isEmpty())
                mutated = "x";
        }
        const auto error = errorOf([&] {
            const TriangleMesh mesh = parsed(name.toStdString(), {mutated.constData(), std::size_t(mutated.size())});
            QVERIFY2(isSound(mesh), qPrintable(QString("seed %1 round %2").arg(seed).arg(round)));
        });
        refused += error.has_value();
    }
    qInfo("%d of %d refused, seed %u", refused, rounds, seed);
}

void TestMeshIo::writing_failsWithoutTrace()
{
    const TriangleMesh mesh = shapes::tetrahedron();
    const auto kindOf = [&](const std::filesystem::path& path) {
        const auto error = errorOf([&] { core::writeMesh(path, mesh); });
        return error ? static_cast<int>(error->kind) : -1;
    };
    const QStringList before = filesThere();
    QCOMPARE(kindOf(file("nowhere/a.stl")), static_cast<int>(Kind::NoFolder));
    QCOMPARE(kindOf(file("a.what")), static_cast<int>(Kind::UnknownFormat));
    std::filesystem::create_directories(file("folder.stl"));
    QCOMPARE(kindOf(file("folder.stl")), static_cast<int>(Kind::NotAFile));
    std::filesystem::remove(file("folder.stl"));
    QStringList after = filesThere();
    QStringList expected = before;
    expected.removeAll("folder.stl");
    QCOMPARE(after, expected);
}

void TestMeshIo::writing_replacesWhatLinksPointTo()
{
    std::filesystem::create_directories(file("elsewhere"));
    const auto target = file("elsewhere/target.obj");
    writeBytes(target, "old");
    std::filesystem::permissions(target, std::filesystem::perms(0640));
    std::filesystem::create_symlink(target, file("link.obj"));
    core::writeMesh(file("link.obj"), shapes::tetrahedron());
    QVERIFY(std::filesystem::is_symlink(file("link.obj")));
    QVERIFY(sameBits(core::readMesh(target), shapes::tetrahedron()));
    QCOMPARE(static_cast<int>(std::filesystem::status(target).permissions()), 0640);
    std::filesystem::remove(file("link.obj"));
}

void TestMeshIo::writing_makesWhatDanglingLinksPointTo()
{
    std::filesystem::create_directories(file("real"));
    std::filesystem::create_symlink("real/new.obj", file("first.obj")); // relative to the folder of the link
    std::filesystem::create_symlink("first.obj", file("second.obj"));
    core::writeMesh(file("second.obj"), shapes::tetrahedron());
    QVERIFY(std::filesystem::is_symlink(file("first.obj")) && std::filesystem::is_symlink(file("second.obj")));
    QVERIFY(!std::filesystem::is_symlink(file("real/new.obj")));
    QVERIFY(sameBits(core::readMesh(file("real/new.obj")), shapes::tetrahedron()));

    std::filesystem::create_symlink("nowhere/new.obj", file("lost.obj"));
    const auto lost = errorOf([&] { core::writeMesh(file("lost.obj"), shapes::tetrahedron()); });
    QVERIFY(lost && lost->kind == Kind::NoFolder && std::filesystem::is_symlink(file("lost.obj")));
    QCOMPARE(lost->path, std::filesystem::path(file("nowhere/new.obj"))); // the folder that is missing is named by it
    std::filesystem::create_symlink("round.obj", file("round.obj"));
    QVERIFY(errorOf([&] { core::writeMesh(file("round.obj"), shapes::tetrahedron()); }));
    QVERIFY(std::filesystem::is_symlink(file("round.obj")));
    for (const char* const name : {"first.obj", "second.obj", "lost.obj", "round.obj"})
        std::filesystem::remove(file(name));
}

void TestMeshIo::writing_diskLimitLeavesTheOldFile()
{
#ifdef Q_OS_UNIX
    const TriangleMesh ball = core::icosphere(6, 10);
    core::writeMesh(file("kept.ply"), shapes::tetrahedron());
    const std::string kept = readBytes(file("kept.ply"));
    const QStringList before = filesThere();

    rlimit old{};
    getrlimit(RLIMIT_FSIZE, &old);
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{100'000, old.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const auto replacing = errorOf([&] { core::writeMesh(file("kept.ply"), ball); });
    const auto creating = errorOf([&] { core::writeMesh(file("new.ply"), ball); });
    setrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, oldHandler);

    QVERIFY(replacing && creating);
    QCOMPARE(static_cast<int>(replacing->kind), static_cast<int>(Kind::WriteFailed));
    QVERIFY(replacing->systemError != 0);
    QCOMPARE(readBytes(file("kept.ply")), kept);
    QCOMPARE(filesThere(), before);
#else
    QSKIP("needs a limit on file sizes");
#endif
}

FETTLE_TEST(TestMeshIo)
#include "tst_mesh_io.moc"
