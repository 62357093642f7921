// Tests compressed buffer views of glTF. Data that the test's encoder packs must be unpacked unchanged, and broken data
// refused.

#include "core/io/mesh/binary.h"
#include "core/io/mesh/meshopt.h"
#include "core/io/mesh_io.h"
#include "core/util/file_error.h"
#include "tests/support/effort.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <random>

namespace
{
using core::FileError;
using core::FileFault;
using core::TriangleMesh;
using core::io::MeshoptView;
using Kind = core::FileErrorKind;

/// A generator of 32-bit random numbers.
struct Random
{
    using result_type = std::uint32_t;

    explicit Random(std::uint32_t first) : engine(first) {}
    static constexpr result_type min() { return std::mt19937::min(); }
    static constexpr result_type max() { return std::mt19937::max(); }
    result_type operator()() { return static_cast<result_type>(engine()); }

    std::mt19937 engine;
};

template <class Number> Number zigzagged(Number value)
{
    const auto sign = static_cast<Number>(value >> (8 * sizeof(Number) - 1) ? ~Number(0) : Number(0));
    return static_cast<Number>(static_cast<Number>(value << 1) ^ sign);
}

void appendVarint(std::string& to, std::uint32_t value)
{
    for (; value >= 0x80; value >>= 7)
        to += static_cast<char>(value | 0x80);
    to += static_cast<char>(value);
}

/// Packs attributes with randomly chosen encodings, efficient or not, so that all of them are tested.
class AttributePacker
{
public:
    AttributePacker(const std::string& elements, std::size_t stride, bool isFirstVersion, Random& random)
        : m_elements(elements)
        , m_stride(stride)
        , m_isFirst(isFirstVersion)
        , m_random(random)
    {}

    std::string packed()
    {
        const std::size_t count = m_elements.size() / m_stride;
        const std::size_t largest = std::min(8192 / m_stride / 16 * 16, std::size_t(256));
        std::string channels, out(1, static_cast<char>(m_isFirst ? 0xa0 : 0xa1));
        for (std::size_t i = 0; i < m_stride / 4; ++i)
            channels += static_cast<char>(m_isFirst || m_random() % 2 ? 0
                                          : m_random() % 2            ? 1
                                                                      : 2 | (m_random() % 16) << 4);
        for (std::size_t begin = 0; begin < count; begin += largest)
            out += block(begin, std::min(count, begin + largest), channels);
        const std::size_t tail = m_stride + (m_isFirst ? 0 : channels.size());
        out.append(std::max(tail, std::size_t(m_isFirst ? 32 : 24)) - tail, '\0');
        return out + m_elements.substr(0, m_stride) + (m_isFirst ? std::string() : channels);
    }

private:
    std::string block(std::size_t begin, std::size_t end, const std::string& channels)
    {
        std::vector<std::string> deltas(m_stride);
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t c = 0; c < m_stride / 4; ++c)
                addDeltas(i, c, static_cast<std::uint8_t>(channels[c]), deltas);
        std::string controls(m_isFirst ? 0 : m_stride / 4, '\0'), out;
        for (std::size_t k = 0; k < m_stride; ++k) {
            const bool isZero = deltas[k].find_first_not_of('\0') == std::string::npos;
            const auto control = m_isFirst ? 0 : isZero && m_random() % 2 ? 2 : std::array{0, 1, 3}[m_random() % 3];
            if (!m_isFirst)
                controls[k / 4] = static_cast<char>(controls[k / 4] | control << 2 * (k % 4));
            if (control == 3)
                out += deltas[k];
            else if (control != 2)
                out += groups(deltas[k], m_isFirst      ? std::array{0, 2, 4, 8}
                                         : control == 0 ? std::array{0, 1, 2, 4}
                                                        : std::array{1, 2, 4, 8});
        }
        return controls + out;
    }

    void addDeltas(std::size_t element, std::size_t channel, std::uint8_t how, std::vector<std::string>& deltas) const
    {
        const auto value = [&](std::size_t i) {
            return core::io::load<std::uint32_t>(m_elements.data() + i * m_stride + 4 * channel, std::endian::little);
        };
        const std::uint32_t now = value(element), before = value(element == 0 ? 0 : element - 1);
        std::uint32_t delta = 0;
        if (how == 0) {
            for (unsigned shift = 0; shift < 32; shift += 8)
                delta |= std::uint32_t(zigzagged(static_cast<std::uint8_t>((now >> shift) - (before >> shift))))
                         << shift;
        } else if (how == 1) {
            for (unsigned shift = 0; shift < 32; shift += 16)
                delta |= std::uint32_t(zigzagged(static_cast<std::uint16_t>((now >> shift) - (before >> shift))))
                         << shift;
        } else {
            delta = std::rotl(now ^ before, how >> 4);
        }
        for (std::size_t k = 0; k < 4; ++k)
            deltas[4 * channel + k] += static_cast<char>(delta >> 8 * k);
    }

    std::string groups(std::string deltas, const std::array<int, 4>& widths)
    {
        deltas.resize((deltas.size() + 15) / 16 * 16);
        std::string header((deltas.size() / 16 + 3) / 4, '\0'), out;
        for (std::size_t i = 0; i < deltas.size() / 16; ++i) {
            const std::string_view group = std::string_view(deltas).substr(16 * i, 16);
            std::size_t how = m_random() % 4;
            if (widths[how] == 0 && group.find_first_not_of('\0') != std::string::npos)
                how = 1 + m_random() % 3;
            header[i / 4] = static_cast<char>(header[i / 4] | how << 2 * (i % 4));
            out += packedGroup(group, static_cast<unsigned>(widths[how]));
        }
        return header + out;
    }

    static std::string packedGroup(std::string_view group, unsigned width)
    {
        if (width == 0 || width == 8)
            return std::string(width == 0 ? std::string_view() : group);
        const unsigned all = (1U << width) - 1, perByte = 8 / width;
        std::string bits(2 * width, '\0'), rest;
        for (unsigned i = 0; i < 16; ++i) {
            const auto delta = static_cast<std::uint8_t>(group[i]);
            const unsigned place = width == 1 ? i % perByte : perByte - 1 - i % perByte;
            bits[i / perByte] = static_cast<char>(bits[i / perByte] | std::min<unsigned>(delta, all) << place * width);
            if (delta >= all)
                rest += static_cast<char>(delta);
        }
        return bits + rest;
    }

    const std::string& m_elements;
    std::size_t m_stride;
    bool m_isFirst;
    Random& m_random;
};

/// Packs triangles with randomly chosen codes among those that the latest edges and corners allow.
class TrianglePacker
{
public:
    explicit TrianglePacker(Random& random) : m_random(random) {}

    std::string packed(const std::vector<core::Triangle>& triangles)
    {
        for (const core::Triangle& t : triangles)
            if (!packAtEdge(t))
                packAlone(t);
        return "\xe1" + m_codes + m_data + pairs();
    }

private:
    /// Returns the age of an entry among the latest `reach` ones, or `reach` if it is not among them.
    template <class Entry>
    static std::size_t age(const std::vector<Entry>& latest, const Entry& entry, std::size_t first, std::size_t reach)
    {
        for (std::size_t i = first; i < std::min(reach, latest.size()); ++i)
            if (latest[latest.size() - 1 - i] == entry)
                return i;
        return reach;
    }

    bool packAtEdge(const core::Triangle& t)
    {
        const auto [a, b, c] = t;
        const std::size_t edge = age<std::pair<std::uint32_t, std::uint32_t>>(m_edges, {a, b}, 0, 15);
        if (edge == 15 || m_random() % 8 == 0)
            return false;
        const std::size_t vertex = age(m_vertices, c, 1, 13);
        unsigned how = 15;
        if (c == m_next)
            how = 0, ++m_next;
        else if (vertex < 13 && m_random() % 4)
            how = static_cast<unsigned>(vertex);
        else if (c == m_last - 1)
            how = 13, m_last = c;
        else if (c == m_last + 1)
            how = 14, m_last = c;
        else
            appendIndex(c);
        m_codes += static_cast<char>(edge << 4 | how);
        m_edges.emplace_back(c, b);
        m_edges.emplace_back(a, c);
        if (how == 0 || how >= 13)
            m_vertices.push_back(c);
        return true;
    }

    void packAlone(const core::Triangle& t)
    {
        const bool restarts = t == core::Triangle{0, 1, 2} && m_next > 2;
        const std::size_t code = m_codes.size();
        const std::string data = std::exchange(m_data, {});
        if (restarts)
            m_next = 0;
        const bool isNext = t[0] == m_next && (restarts || m_random() % 4);
        isNext ? void(++m_next) : appendIndex(t[0]);
        const unsigned second = corner(t[1]), third = corner(t[2]);
        const auto pair = static_cast<char>(second << 4 | third);
        const std::size_t known = pairs().find(pair);
        m_codes += static_cast<char>(isNext ? 0xfe : 0xff);
        if (isNext && known < 14 && !restarts && m_random() % 4)
            m_codes[code] = static_cast<char>(0xf0 | known);
        else if (pair == 0 && !restarts)
            return packAloneExplicitly(t, code, data); // an all-zero pair would mean a restart
        else
            m_data.insert(0, 1, pair);
        m_data = data + m_data;
        push(t, second == 0 || second == 15, third == 0 || third == 15);
    }

    /// Packs three consecutive corners with explicit indices, which avoids the pair that means a restart.
    void packAloneExplicitly(const core::Triangle& t, std::size_t code, const std::string& data)
    {
        m_codes[code] = static_cast<char>(0xff);
        const std::string first = m_data; // index of the first corner, if it was packed explicitly
        m_data = "\xff" + first;
        m_next = first.empty() ? t[0] : t[1];
        if (first.empty())
            appendIndex(t[0]);
        appendIndex(t[1]);
        appendIndex(t[2]);
        m_data = data + m_data;
        push(t, true, true);
    }

    unsigned corner(std::uint32_t index)
    {
        const std::size_t vertex = age(m_vertices, index, 0, 14);
        if (index == m_next)
            return ++m_next, 0;
        if (vertex < 14)
            return static_cast<unsigned>(vertex) + 1;
        appendIndex(index);
        return 15;
    }

    void push(const core::Triangle& t, bool isSecondNew, bool isThirdNew)
    {
        m_edges.emplace_back(t[1], t[0]);
        m_edges.emplace_back(t[2], t[1]);
        m_edges.emplace_back(t[0], t[2]);
        m_vertices.push_back(t[0]);
        if (isSecondNew)
            m_vertices.push_back(t[1]);
        if (isThirdNew)
            m_vertices.push_back(t[2]);
    }

    void appendIndex(std::uint32_t index)
    {
        appendVarint(m_data, zigzagged(index - m_last));
        m_last = index;
    }

    static std::string pairs()
    {
        return std::string("\x00\x76\x87\x56\x67\x78\xa9\x86\x65\x89\x68\x98\x01\x69\0\0", 16);
    }

    Random& m_random;
    std::string m_codes, m_data;
    std::uint32_t m_next = 0, m_last = 0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> m_edges;
    std::vector<std::uint32_t> m_vertices;
};

std::string packedIndices(const std::vector<std::uint32_t>& indices, Random& random)
{
    std::string out = "\xd1";
    std::array<std::uint32_t, 2> last{};
    for (const std::uint32_t index : indices) {
        const unsigned base = random() % 2;
        appendVarint(out, zigzagged(index - last[base]) << 1 | base);
        last[base] = index;
    }
    return out.append(4, '\0');
}

template <class Number> std::string bytesOf(const std::vector<Number>& numbers)
{
    std::string bytes;
    for (const Number number : numbers)
        core::io::append(bytes, number);
    return bytes;
}

std::vector<std::uint32_t> cornersIn(const std::vector<core::Triangle>& triangles)
{
    std::vector<std::uint32_t> corners;
    for (const core::Triangle& t : triangles)
        corners.insert(corners.end(), t.begin(), t.end());
    return corners;
}

struct PackedGltf
{
    std::string points, corners; ///< packed bytes of the points and of the corners
    QByteArray extension = "EXT_meshopt_compression", filter = "NONE", mode = "TRIANGLES";
    QByteArray fallback = R"({"byteLength":72,"uri":"nowhere.bin","extensions":{"%1":{"fallback":true}}})";

    /// Returns a glTF of a tetrahedron with float32 points and 16-bit corners.
    QByteArray text() const
    {
        const auto view = [this](int offset, std::size_t length, const QByteArray& content, const QByteArray& own) {
            return R"({"buffer":1,"byteLength":)" + own + R"(,"extensions":{")" + extension +
                   R"(":{"buffer":0,"byteOffset":)" + QByteArray::number(offset) + R"(,"byteLength":)" +
                   QByteArray::number(qsizetype(length)) + "," + content + "}}}";
        };
        const QByteArray data = QByteArray::fromStdString(points + corners);
        return R"({"asset":{"version":"2.0"},"extensionsRequired":[")" + extension +
               R"("],"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[0.001,0.001,0.001]}],)"
               R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
               R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
               R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],"bufferViews":[)" +
               view(0, points.size(), R"("byteStride":12,"count":4,"mode":"ATTRIBUTES","filter":")" + filter + "\"",
                    "48") +
               "," +
               view(int(points.size()), corners.size(), R"("byteStride":2,"count":12,"mode":")" + mode + "\"", "24") +
               R"(],"buffers":[{"byteLength":)" + QByteArray::number(data.size()) +
               R"(,"uri":"data:application/octet-stream;base64,)" + data.toBase64() + R"("},)" +
               QByteArray(fallback).replace("%1", extension) + "]}";
    }
};
} // namespace

class TestMeshopt : public QObject
{
    Q_OBJECT

    static constexpr unsigned seed = 20261127;

private Q_SLOTS:
    void initTestCase() { QVERIFY(m_dir.isValid()); }

    void attributes_comeBack_data();
    void attributes_comeBack();
    void specifiedExample_isUnpacked();
    void triangles_comeBack();
    void indices_comeBack();
    void octahedralVectors_haveLengthOne();
    void quaternions_haveLengthOne();
    void exponentials_areExact();
    void colors_areExact();

    void compressedModels_areRead_data();
    void compressedModels_areRead();
    void brokenStreams_areRefused_data();
    void brokenStreams_areRefused();
    void brokenViews_areRefused_data();
    void brokenViews_areRefused();
    void cutStreams_areRefused();
    void bombs_areRefused();
    void mutatedStreams_neverGetThrough();

private:
    static std::string unpacked(const MeshoptView& view)
    {
        static const std::filesystem::path path("a.glb");
        return core::io::meshoptUnpacked({path, {}}, view);
    }
    static MeshoptView viewOf(const std::string& data, std::size_t count, std::size_t stride,
                              MeshoptView::Mode mode = MeshoptView::Mode::Attributes,
                              MeshoptView::Filter filter = MeshoptView::Filter::None)
    {
        return {
            .data = data, .mode = mode, .filter = filter, .count = count, .stride = stride, .name = "bufferViews/7"};
    }
    /// Packs the elements, and returns the result of unpacking them with the filter.
    std::string filtered(const std::string& elements, std::size_t stride, MeshoptView::Filter filter)
    {
        const std::string data = AttributePacker(elements, stride, m_random() % 2 == 0, m_random).packed();
        return unpacked(viewOf(data, elements.size() / stride, stride, MeshoptView::Mode::Attributes, filter));
    }
    PackedGltf tetrahedron()
    {
        const TriangleMesh mesh = shapes::tetrahedron();
        std::vector<float> numbers;
        for (const core::Vec3f& p : mesh.points)
            numbers.insert(numbers.end(), p.begin(), p.end());
        return {.points = AttributePacker(bytesOf(numbers), 12, true, m_random).packed(),
                .corners = TrianglePacker(m_random).packed(mesh.triangles)};
    }
    core::ReadResult read(const QByteArray& text) const
    {
        QFile file(m_dir.filePath(QStringLiteral("a.gltf")));
        file.open(QIODevice::WriteOnly);
        file.write(text);
        file.close();
        return core::readModel(file.fileName().toStdString());
    }
    static std::optional<FileError> errorOf(const std::function<void()>& action)
    {
        try {
            action();
        } catch (const FileError& error) {
            return error;
        }
        return std::nullopt;
    }

    QTemporaryDir m_dir;
    Random m_random{seed};
};

void TestMeshopt::attributes_comeBack_data()
{
    QTest::addColumn<std::size_t>("stride");
    for (const std::size_t stride : {4, 8, 12, 16, 24, 32, 48, 100, 256})
        QTest::newRow(qPrintable(QString::number(stride))) << stride;
}

void TestMeshopt::attributes_comeBack()
{
    QFETCH(std::size_t, stride);
    for (const std::size_t count : {1, 3, 15, 16, 17, 31, 32, 33, 64, 80, 255, 256, 257, 600})
        for (const unsigned range : {1U, 2U, 4U, 20U, 256U})
            for (const bool isFirst : {true, false}) {
                std::string elements(stride * count, '\0');
                for (std::size_t i = 0; i < elements.size(); ++i)
                    elements[i] = static_cast<char>((i < stride ? m_random() : unsigned(elements[i - stride])) +
                                                    m_random() % range);
                const std::string data = AttributePacker(elements, stride, isFirst, m_random).packed();
                QVERIFY(unpacked(viewOf(data, count, stride)) == elements);
            }
}

/// Tests the group of 4-bit deltas that the extension's specification gives as an example.
void TestMeshopt::specifiedExample_isUnpacked()
{
    const std::string group("\x17\x5f\xf0\xbc\x77\xa9\x21\x00\x34\xb5", 10);
    const std::string data = std::string("\xa0\x02", 2) + group + std::string(3, '\0') + std::string(32, '\0');
    const std::string elements = unpacked(viewOf(data, 16, 4));
    std::int8_t sum = 0;
    std::size_t i = 0;
    for (const int delta : {-1, -4, -3, 26, -91, 0, -6, 6, -4, -4, 5, -5, 1, -1, 0, 0}) {
        sum = static_cast<std::int8_t>(sum + delta);
        QCOMPARE(static_cast<std::int8_t>(elements[4 * i++]), sum);
    }
}

void TestMeshopt::triangles_comeBack()
{
    for (int round = 0; round < 300; ++round) {
        std::vector<core::Triangle> triangles;
        const unsigned width = 2 + m_random() % 20, height = 2 + m_random() % 20;
        for (unsigned y = 0; y + 1 < height; ++y)
            for (unsigned x = 0; x + 1 < width; ++x) {
                const unsigned a = y * width + x;
                triangles.push_back({a, a + 1, a + width});
                triangles.push_back({a + width, a + 1, a + width + 1});
            }
        for (unsigned swaps = m_random() % 20; swaps != 0; --swaps)
            std::swap(triangles[m_random() % triangles.size()], triangles[m_random() % triangles.size()]);
        for (unsigned more = m_random() % 20; more != 0; --more)
            triangles.push_back({m_random() % 65536, m_random() % 300, m_random() % 65536});
        if (round % 3 == 0)
            triangles.insert(triangles.end(), {{0, 1, 2}, {2, 1, 3}, {0, 1, 2}});
        const std::string data = TrianglePacker(m_random).packed(triangles);
        const std::vector<std::uint32_t> corners = cornersIn(triangles);
        QVERIFY(unpacked(viewOf(data, corners.size(), 4, MeshoptView::Mode::Triangles)) == bytesOf(corners));
        const std::vector<std::uint16_t> halves(corners.begin(), corners.end());
        QVERIFY(unpacked(viewOf(data, corners.size(), 2, MeshoptView::Mode::Triangles)) == bytesOf(halves));
    }
}

void TestMeshopt::indices_comeBack()
{
    for (const std::uint32_t range : {1U, 10U, 1'000U, 65'536U, 1U << 29})
        for (const std::size_t count : {1, 2, 3, 100, 1'000}) {
            std::vector<std::uint32_t> indices(count);
            for (std::uint32_t& index : indices)
                index = m_random() % range;
            const std::string data = packedIndices(indices, m_random);
            QVERIFY(unpacked(viewOf(data, count, 4, MeshoptView::Mode::Indices)) == bytesOf(indices));
            const std::vector<std::uint16_t> halves(indices.begin(), indices.end());
            const auto error = errorOf(
                [&] { QVERIFY(unpacked(viewOf(data, count, 2, MeshoptView::Mode::Indices)) == bytesOf(halves)); });
            QCOMPARE(error.has_value(), *std::ranges::max_element(indices) > 65'535);
        }
}

void TestMeshopt::octahedralVectors_haveLengthOne()
{
    const auto check = [this](auto number, int bits) {
        using Number = decltype(number);
        constexpr double one = std::numeric_limits<Number>::max();
        const int max = (1 << (bits - 1)) - 1;
        std::vector<Number> elements;
        std::vector<std::array<double, 3>> wanted;
        for (int i = 0; i < 200; ++i) {
            const int x = static_cast<int>(m_random() % (2U * unsigned(max) + 1)) - max,
                      y = static_cast<int>(m_random() % (2U * unsigned(max) + 1)) - max;
            for (const int part : {x, y, max, i % 100})
                elements.push_back(static_cast<Number>(part));
            // the corners of the square are folded to the lower hemisphere
            const double u = double(x) / max, v = double(y) / max, z = 1 - std::abs(u) - std::abs(v);
            const double px = z >= 0 ? u : std::copysign(1 - std::abs(v), u),
                         py = z >= 0 ? v : std::copysign(1 - std::abs(u), v);
            const double length = std::sqrt(px * px + py * py + z * z);
            wanted.push_back({px / length, py / length, z / length});
        }
        const std::string result = filtered(bytesOf(elements), 4 * sizeof(Number), MeshoptView::Filter::Octahedral);
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            const auto part = [&](std::size_t k) {
                return core::io::load<Number>(result.data() + (4 * i + k) * sizeof(Number), std::endian::little);
            };
            for (std::size_t k = 0; k < 3; ++k)
                QVERIFY(std::abs(part(k) - wanted[i][k] * one) <= 1);
            QCOMPARE(part(3), static_cast<Number>(i % 100));
        }
    };
    for (const int bits : {4, 6, 8})
        check(std::int8_t(), bits);
    for (const int bits : {4, 8, 10, 12, 16})
        check(std::int16_t(), bits);
}

void TestMeshopt::quaternions_haveLengthOne()
{
    for (const int bits : {8, 10, 12, 16}) {
        std::vector<std::int16_t> elements;
        std::vector<std::array<double, 4>> wanted;
        std::normal_distribution<double> normal;
        const double max = (1 << (bits - 1)) - 1;
        for (int i = 0; i < 200; ++i) {
            Eigen::Vector4d q(normal(m_random), normal(m_random), normal(m_random), normal(m_random));
            q.normalize();
            Eigen::Index largest = 0;
            q.cwiseAbs().maxCoeff(&largest);
            if (q[largest] < 0)
                q = -q;
            for (Eigen::Index k = 1; k < 4; ++k)
                elements.push_back(static_cast<std::int16_t>(std::lround(q[(largest + k) % 4] * std::sqrt(2.0) * max)));
            elements.push_back(static_cast<std::int16_t>((static_cast<int>(max) & ~3) | static_cast<int>(largest)));
            wanted.push_back({q[0], q[1], q[2], q[3]});
        }
        const std::string result = filtered(bytesOf(elements), 8, MeshoptView::Filter::Quaternion);
        for (std::size_t i = 0; i < wanted.size(); ++i)
            for (std::size_t k = 0; k < 4; ++k)
                QVERIFY(std::abs(core::io::load<std::int16_t>(result.data() + 8 * i + 2 * k, std::endian::little) /
                                     32767.0 -
                                 wanted[i][k]) < 2 / max);
    }
}

void TestMeshopt::exponentials_areExact()
{
    std::vector<std::uint32_t> elements;
    std::vector<float> wanted;
    for (int i = 0; i < 600; ++i) {
        const int exponent = static_cast<int>(m_random() % 201) - 100,
                  mantissa = static_cast<int>(m_random() % (1U << 24)) - (1 << 23);
        elements.push_back(std::uint32_t(exponent) << 24 | (std::uint32_t(mantissa) & 0xffffff));
        wanted.push_back(std::ldexp(static_cast<float>(mantissa), exponent));
    }
    QVERIFY(filtered(bytesOf(elements), 12, MeshoptView::Filter::Exponential) == bytesOf(wanted));
}

/// Tests that luma and chroma of whole numbers give the exact colour.
void TestMeshopt::colors_areExact()
{
    const auto check = [this](auto number) {
        using Number = decltype(number);
        constexpr int max = std::numeric_limits<Number>::max(), bits = std::numeric_limits<Number>::digits;
        std::vector<Number> elements, wanted;
        for (int i = 0; i < 300; ++i) {
            const int y = max / 2, cg = static_cast<int>(m_random() % (unsigned(max) / 4)) - max / 8,
                      co = static_cast<int>(m_random() % (unsigned(max) / 4)) - max / 8,
                      alpha = static_cast<int>(m_random() % (1U << (bits - 1)));
            for (const int part : {y, co, cg, alpha | 1 << (bits - 1)})
                elements.push_back(static_cast<Number>(part));
            for (const int part : {y + co - cg, y + cg, y - co - cg, alpha << 1 | (alpha & 1)})
                wanted.push_back(static_cast<Number>(part));
        }
        QVERIFY(filtered(bytesOf(elements), 4 * sizeof(Number), MeshoptView::Filter::Color) == bytesOf(wanted));
    };
    check(std::uint8_t());
    check(std::uint16_t());
    const std::vector<std::uint8_t> three{7, 0, 0, 12}; // 4-bit components: a grey of 7/15, with alpha 8/15
    QVERIFY(filtered(bytesOf(three), 4, MeshoptView::Filter::Color) ==
            bytesOf(std::vector<std::uint8_t>{119, 119, 119, 136}));
}

void TestMeshopt::compressedModels_areRead_data()
{
    QTest::addColumn<QByteArray>("extension");
    QTest::addColumn<bool>("isFirstVersion");
    QTest::addColumn<QByteArray>("fallback");
    QTest::newRow("EXT") << QByteArray("EXT_meshopt_compression") << true << QByteArray(R"({"byteLength":72})");
    QTest::newRow("KHR") << QByteArray("KHR_meshopt_compression") << false << QByteArray(R"({"byteLength":72})");
    QTest::newRow("a fallback that is not there")
        << QByteArray("EXT_meshopt_compression") << false << PackedGltf().fallback;
}

void TestMeshopt::compressedModels_areRead()
{
    QFETCH(QByteArray, extension);
    QFETCH(bool, isFirstVersion);
    QFETCH(QByteArray, fallback);
    const TriangleMesh mesh = shapes::tetrahedron();
    PackedGltf gltf = tetrahedron();
    gltf.extension = extension;
    gltf.fallback = fallback;
    std::vector<std::uint32_t> fixed; // fixed-point numbers in units of 1/16
    std::vector<float> numbers;
    for (const core::Vec3f& p : mesh.points)
        for (const float x : p) {
            fixed.push_back(std::uint32_t(-4) << 24 | (std::uint32_t(std::lround(16 * x)) & 0xffffff));
            numbers.push_back(x);
        }
    for (const bool isFiltered : {false, true})
        for (const bool isOfTriangles : {false, true}) {
            gltf.filter = isFiltered ? "EXPONENTIAL" : "NONE";
            gltf.points =
                AttributePacker(isFiltered ? bytesOf(fixed) : bytesOf(numbers), 12, isFirstVersion, m_random).packed();
            gltf.mode = isOfTriangles ? "TRIANGLES" : "INDICES";
            gltf.corners = isOfTriangles ? TrianglePacker(m_random).packed(mesh.triangles)
                                         : packedIndices(cornersIn(mesh.triangles), m_random);
            const core::ReadResult result = read(gltf.text());
            QVERIFY(result.mesh.points == mesh.points && result.mesh.triangles == mesh.triangles);
            QVERIFY(result.remarks == core::ReadRemarks());
        }
}

void TestMeshopt::brokenStreams_areRefused_data()
{
    QTest::addColumn<QByteArray>("data");
    QTest::addColumn<int>("mode");
    QTest::addColumn<FileFault>("fault");
    const auto row = [](const char* name, const std::string& data, MeshoptView::Mode mode, FileFault fault) {
        QTest::newRow(name) << QByteArray::fromStdString(data) << static_cast<int>(mode) << fault;
    };
    using enum MeshoptView::Mode;
    constexpr FileFault wrong = FileFault::CompressedWrong, cut = FileFault::CompressedCut;
    const std::string zeros(64, '\0'), table(16, '\0');
    row("nothing", {}, Attributes, cut);
    row("unknown version", "\xa2" + zeros, Attributes, wrong);
    row("triangles as attributes", "\xe1" + zeros, Attributes, wrong);
    row("too much", std::string("\xa0\0\0\0\0\0", 6) + std::string(32, '\0'), Attributes, wrong);
    row("no tail", std::string("\xa0\0\0\0\0", 5), Attributes, cut);
    row("deltas cut off", "\xa0\x03" + std::string(32 + 15, '\0'), Attributes, cut);
    row("unknown channel", "\xa1\xaa" + std::string(24, '\3'), Attributes, wrong);
    row("turned channel", "\xa1\xaa" + std::string(24, '\x11'), Attributes, wrong);
    row("attributes as triangles", "\xa0" + zeros, Triangles, wrong);
    row("an edge before there is one", std::string("\xe1\0", 2) + table, Triangles, wrong);
    row("a corner before there is one", "\xe1\xf1" + std::string("\0\1", 2) + std::string(14, '\0'), Triangles, wrong);
    row("a pair that says nothing", "\xe1\xf0" + std::string("\0\x0f", 2) + std::string(14, '\0'), Triangles, wrong);
    row("pairs beyond the table", "\xe1\xf0" + std::string(15, '\0') + "\1", Triangles, wrong);
    row("too much behind", "\xe1\xf0" + std::string(17, '\0'), Triangles, wrong);
    row("no table", "\xe1\xf0" + std::string(15, '\0'), Triangles, cut);
    row("no triangles", "\xe1", Triangles, cut);
    row("an index cut off", "\xe1\xff" + table, Triangles, cut);
    row("an index without end", "\xe1\xff\x01" + std::string(8, '\x80') + table, Triangles, wrong);
    row("triangles as indices", "\xe1" + zeros, Indices, wrong);
    row("indices cut off", "\xd1\2\2" + std::string(4, '\0'), Indices, cut);
    row("too many indices", "\xd1\2\2\2\2" + std::string(4, '\0'), Indices, wrong);
}

void TestMeshopt::brokenStreams_areRefused()
{
    QFETCH(QByteArray, data);
    QFETCH(int, mode);
    const std::string bytes = data.toStdString();
    const auto error = errorOf([&] { unpacked(viewOf(bytes, 3, 4, static_cast<MeshoptView::Mode>(mode))); });
    QVERIFY(error && error->kind == Kind::Malformed && error->token == "bufferViews/7");
    QTEST(error->fault, "fault");
}

void TestMeshopt::brokenViews_areRefused_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<FileFault>("fault");
    QTest::addColumn<QString>("token");
    const auto row = [](const char* name, const char* before, const char* after, const char* token,
                        FileFault fault = FileFault::CompressedWrong, Kind kind = Kind::Malformed) {
        QTest::newRow(name) << QByteArray(before) << QByteArray(after) << kind << fault << QString(token);
    };
    row("mode", "\"ATTRIBUTES\"", "\"POINTS\"", "bufferViews/0");
    row("no mode", "\"mode\":\"ATTRIBUTES\"", "\"x\":1", "bufferViews/0");
    row("filter", "\"NONE\"", "\"SHARP\"", "bufferViews/0");
    row("filter of another stride", "\"NONE\"", "\"OCTAHEDRAL\"", "bufferViews/0");
    row("stride", "\"byteStride\":12", "\"byteStride\":10", "bufferViews/0");
    row("stride of indices", "\"byteStride\":2", "\"byteStride\":3", "bufferViews/1");
    row("stride of nothing", "\"byteStride\":12", "\"byteStride\":0", "bufferViews/0");
    row("no thirds", "\"byteStride\":2,\"count\":12", "\"byteStride\":2,\"count\":11", "bufferViews/1");
    row("beyond 64 bits", "\"count\":4,\"mode\"", "\"count\":9223372036854775807,\"mode\"", "bufferViews/0");
    row("other count", "\"count\":4,\"mode\"", "\"count\":4000,\"mode\"", "bufferViews/0", FileFault::CompressedCut);
    row("fewer than the accessor's", "\"count\":4,\"type\"", "\"count\":5,\"type\"", "bufferViews/0",
        FileFault::BeyondItsData);
    row("no count", "\"count\":4,\"mode\"", "\"mode\"", "count", FileFault::Missing);
    row("no length", "\"byteOffset\":0,\"byteLength\"", "\"byteOffset\":0,\"x\"", "byteLength", FileFault::Missing);
    row("no such buffer", "\"buffer\":0", "\"buffer\":9", "buffers/9", FileFault::Missing);
    row("in the fallback", "\"buffer\":0", "\"buffer\":1", "", FileFault::None, Kind::CutOff);
    row("behind the data", "\"byteOffset\":0", "\"byteOffset\":9999", "", FileFault::None, Kind::CutOff);
    row("no object", ":{\"buffer\":0", ":7,\"x\":{\"buffer\":0", "bufferViews/0", FileFault::NotAnObject);
}

void TestMeshopt::brokenViews_areRefused()
{
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    QFETCH(Kind, kind);
    QByteArray text = tetrahedron().text();
    const qsizetype at = text.indexOf(before);
    QVERIFY(at >= 0);
    const auto error = errorOf([&] { read(text.replace(at, before.size(), after)); });
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->kind), static_cast<int>(kind));
    QTEST(error->fault, "fault");
    QTEST(QString::fromStdString(error->token), "token");
}

void TestMeshopt::cutStreams_areRefused()
{
    const PackedGltf whole = tetrahedron();
    read(whole.text());
    for (std::size_t length = 0; length < whole.points.size(); ++length) {
        PackedGltf cut = whole;
        cut.points.resize(length);
        QVERIFY(errorOf([&] { read(cut.text()); }));
    }
    for (std::size_t length = 0; length < whole.corners.size(); ++length) {
        PackedGltf cut = whole;
        cut.corners.resize(length);
        QVERIFY(errorOf([&] { read(cut.text()); }));
    }
}

/// One byte can expand to a thousand, so the total unpacked size of many small views must be limited.
void TestMeshopt::bombs_areRefused()
{
    constexpr int count = 1 << 18;
    std::string zeros("\xa1", 1);
    zeros.append(std::size_t(count) / 256 * 3, '\xaa').append(24, '\0');
    QCOMPARE(unpacked(viewOf(zeros, count, 12)), std::string(std::size_t(count) * 12, '\0'));
    PackedGltf gltf = tetrahedron();
    gltf.points = zeros;
    QByteArray views, primitives, accessors;
    for (int i = 0; i < 40; ++i) {
        views +=
            R"({"buffer":1,"byteLength":3145728,"extensions":{"EXT_meshopt_compression":{"buffer":0,"byteLength":)" +
            QByteArray::number(qsizetype(zeros.size())) + R"(,"byteStride":12,"count":262144,"mode":"ATTRIBUTES"}}},)";
        accessors +=
            R"({"bufferView":)" + QByteArray::number(i) + R"(,"componentType":5126,"count":262144,"type":"VEC3"},)";
        primitives += R"({"attributes":{"POSITION":)" + QByteArray::number(i) + "}},";
    }
    QByteArray text = gltf.text();
    text.replace("\"bufferViews\":[", "\"bufferViews\":[" + views);
    text.replace("\"accessors\":[", "\"accessors\":[" + accessors);
    text.replace("\"primitives\":[", "\"primitives\":[" + primitives);
    const auto error = errorOf([&] { read(text); });
    QVERIFY(error && (error->kind == Kind::UnpacksTooLarge || error->kind == Kind::TooManyElements));
}

void TestMeshopt::mutatedStreams_neverGetThrough()
{
    const int rounds = byEffort(3'000, 30'000, 2'000'000);
    int refused = 0;
    for (int round = 0; round < rounds; ++round) {
        const auto mode = static_cast<MeshoptView::Mode>(round % 3);
        const std::vector<core::Triangle> triangles = shapes::cube(1).triangles;
        std::string elements(16 * 36, '\0');
        for (char& c : elements)
            c = static_cast<char>(m_random() % 8);
        std::string data = mode == MeshoptView::Mode::Attributes
                               ? AttributePacker(elements, 16, round % 2, m_random).packed()
                           : mode == MeshoptView::Mode::Triangles ? TrianglePacker(m_random).packed(triangles)
                                                                  : packedIndices(cornersIn(triangles), m_random);
        for (auto edits = 1 + m_random() % 4; edits != 0; --edits)
            data[m_random() % data.size()] = static_cast<char>(m_random());
        const bool areAttributes = mode == MeshoptView::Mode::Attributes;
        const auto filter = static_cast<MeshoptView::Filter>(m_random() % 2 * 3);
        const MeshoptView view =
            viewOf(data, 36, areAttributes ? 16 : 4, mode, areAttributes ? filter : MeshoptView::Filter::None);
        const auto error = errorOf([&] { QCOMPARE(unpacked(view).size(), view.count * view.stride); });
        refused += error.has_value();
    }
    qInfo("%d of %d refused, seed %u", refused, rounds, seed);
}

FETTLE_TEST(TestMeshopt, QCoreApplication)
#include "tst_meshopt.moc"
