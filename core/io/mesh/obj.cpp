// OBJ: reads the lines v (with colour, if any) and f, which is fo in old files. All other lines are ignored; materials,
// free-form surfaces and calls of other files are recorded in the remarks. Faces may use vertices that are defined
// later.

#include "core/io/mesh/palette.h"
#include "core/io/mesh/polygons.h"
#include "core/io/mesh/text_scanner.h"
#include "core/io/mesh/text_writer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace core::io
{
namespace
{
using RawColor = std::array<float, 3>;

class ObjReader
{
public:
    explicit ObjReader(const FileBytes& file)
        : m_file(file)
        , m_text(file, file.bytes.data(), '#')
        , m_stopCheck(file.stop)
    {}

    ReadResult read()
    {
        do
            readLine();
        while (m_text.nextLine());
        if (m_mesh.points.empty() && m_faces.faces() == 0)
            throw FileError(FileErrorKind::NotWhatItsEndingSays, m_file.path);
        checkLargestIndex();
        m_mesh.triangles = m_faces.triangles(m_mesh.points, m_stopCheck, m_remarks);
        makeColors();
        m_remarks.objects = std::max<std::size_t>(m_remarks.objects, 1);
        return {std::move(m_mesh), m_remarks};
    }

private:
    void readLine()
    {
        m_stopCheck();
        const std::string_view keyword = m_text.word();
        if (keyword == "v")
            readVertex();
        else if (keyword == "f" || keyword == "fo")
            readFace();
        else if (keyword == "mtllib" || keyword == "usemtl")
            m_remarks.materials = true;
        else if (keyword == "call" || keyword == "surf" || keyword == "bsp" || keyword == "bzp" ||
                 keyword == "cdp") // the last three occur in old files
            ++m_remarks.unreadNodes;
        else if (keyword == "o")
            ++m_remarks.objects;
    }

    /// Reads v x y z, with or without a weight and with or without r g b.
    void readVertex()
    {
        std::array<float, 7> numbers;
        std::size_t count = 0;
        while (count < numbers.size() && !m_text.atLineEnd())
            numbers[count++] = m_text.number();
        if (count < 3 || count == 5 || !m_text.atLineEnd())
            m_text.fail(FileFault::VertexNumbers, m_text.word());
        if (m_mesh.points.size() == maxVertices)
            throw tooMany("vertices", maxVertices, errorAtLine({}, m_file, m_text.position()));
        if (count >= 6) {
            m_colors.resize(m_mesh.points.size(), noColor);
            m_colors.push_back({numbers[count - 3], numbers[count - 2], numbers[count - 1]});
        }
        m_mesh.points.emplace_back(numbers[0], numbers[1], numbers[2]);
    }

    void readFace()
    {
        while (!m_text.atLineEnd())
            m_faces.addCorner(readCorner());
        if (m_faces.cornersOfOpenFace() < 3) {
            if (m_text.atFileEnd())
                m_text.fail(FileErrorKind::CutOff, {});
            m_faces.dropOpenFace(); // only a point or an edge
            ++m_remarks.facesOfFewer;
            return;
        }
        if (m_faces.cornersOfOpenFace() > maxCorners)
            throw tooMany("corners", maxCorners, errorAtLine({}, m_file, m_text.position()));
        if (m_faces.corners() > 3 * maxFaces)
            throw tooMany("faces", maxFaces, errorAtLine({}, m_file, m_text.position()));
        m_faces.endFace();
    }

    /// Reads v, v/vt, v//vn or v/vt/vn. Indices start at 1; negative ones count back from the latest vertex.
    Slot readCorner()
    {
        const std::string_view word = m_text.word();
        const std::string_view vertex = word.substr(0, word.find('/'));
        if (vertex.empty())
            m_text.fail(FileFault::VertexIndex, word);
        const std::int64_t number = m_text.toInteger(vertex);
        const std::int64_t index = number < 0 ? static_cast<std::int64_t>(m_mesh.points.size()) + number : number - 1;
        if (index < 0 || index >= static_cast<std::int64_t>(maxVertices))
            refuseIndex(vertex);
        if (index > m_largest) {
            m_largest = index;
            m_largestWord = vertex;
        }
        return static_cast<Slot>(index);
    }

    [[noreturn]] void refuseIndex(std::string_view word) const
    {
        throw withCounts(errorAtLine(FileErrorKind::IndexOutOfRange, m_file, word.data(), word), m_mesh.points.size());
    }

    void checkLargestIndex() const
    {
        if (m_largest >= static_cast<std::int64_t>(m_mesh.points.size()))
            refuseIndex(m_largestWord);
    }

    /// Converts the colours to bytes. They are from 0 to 1; some programs write them from 0 to 255.
    void makeColors()
    {
        if (m_colors.empty())
            return;
        m_colors.resize(m_mesh.points.size(), noColor);
        const bool bytes = std::any_of(m_colors.begin(), m_colors.end(), [](const RawColor& c) {
            return std::max({c[0], c[1], c[2]}) > 1;
        });
        const auto component = [scale = bytes ? 1.0f : 255.0f](float x) {
            return static_cast<std::uint8_t>(std::lround(std::clamp(x * scale, 0.0f, 255.0f)));
        };
        m_mesh.colors.reserve(m_colors.size());
        for (const RawColor& c : m_colors) {
            m_stopCheck();
            m_mesh.colors.push_back(c == noColor ? Rgb() : Rgb{component(c[0]), component(c[1]), component(c[2])});
        }
    }

    static constexpr RawColor noColor{-1, -1, -1};

    const FileBytes& m_file;
    TextScanner m_text;
    StopCheck m_stopCheck;
    TriangleMesh m_mesh;
    std::vector<RawColor> m_colors; ///< values as in the file; uncoloured vertices at the end are missing
    Polygons m_faces;
    ReadRemarks m_remarks{.objects = 0};
    std::int64_t m_largest = -1;
    std::string_view m_largestWord;
};
} // namespace

ReadResult readObj(const FileBytes& file)
{
    return ObjReader(file).read();
}

void writeObj(AtomicFile& out, const TriangleMesh& mesh, std::span<const Rgb> palette)
{
    constexpr float fullColor = 255.0f;
    TextWriter text(out);
    if (!palette.empty())
        text << "# " << paletteWords(palette) << '\n';
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const Vec3f& p = mesh.points[i];
        text << "v " << p.x() << ' ' << p.y() << ' ' << p.z();
        if (!mesh.colors.empty()) {
            const Rgb c = mesh.colors[i];
            text << ' ' << c.r / fullColor << ' ' << c.g / fullColor << ' ' << c.b / fullColor;
        }
        text << '\n';
    }
    for (const Triangle& t : mesh.triangles)
        text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
}
} // namespace core::io
