// OBJ: reads the lines v (with colour, if any), f, which is fo in old files, and o. All other lines are ignored;
// materials, free-form surfaces and calls of other files are recorded in the remarks. Faces may use vertices that are
// defined later.

#include "core/io/mesh/file_parts.h"
#include "core/io/mesh/object_labels.h"
#include "core/io/mesh/palette.h"
#include "core/io/mesh/polygons.h"
#include "core/io/mesh/text_scanner.h"
#include "core/io/mesh/text_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace core::io
{
namespace
{
using RawColor = std::array<float, 3>;

/// Returns the next word as a number, which may be NaN or infinite, such as nan, -nan(ind) or inf.
float anyNumber(TextScanner& text)
{
    const std::string_view word = text.word();
    const char* const last = word.data() + word.size();
    float value = 0;
    const char* const end = std::from_chars(word.data(), last, value).ptr;
    return std::isfinite(value) || (end != last && *end != '(') ? text.toNumber(word) : value;
}

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
        if (m_mesh.points.empty() && corners() == 0)
            throw FileError(FileErrorKind::NotWhatItsEndingSays, m_file.path);
        checkLargestIndex();
        makeColors();
        ObjectLabels labels(m_objects.size() > 1 && m_objects.size() <= std::numeric_limits<PartId>::max());
        makeTriangles(labels);
        PartList parts = labels.finish(m_mesh);
        m_remarks.objects = std::max<std::size_t>(m_remarks.objects, 1);
        return {std::move(m_mesh), m_remarks, std::move(parts)};
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
            beginObject();
    }

    void beginObject()
    {
        ++m_remarks.objects;
        if (!m_file.keepsObjects)
            return;
        const std::string_view rest =
            m_file.bytes.substr(static_cast<std::size_t>(m_text.position() - m_file.bytes.data()));
        m_cornersBefore += faces().corners();
        m_objects.push_back({cleanName(rest.substr(0, rest.find_first_of("\r\n"))), {}});
    }

    /// Reads v x y z, with or without a weight and with or without r g b. A weight or colour may be NaN or infinite;
    /// such a colour is missing.
    void readVertex()
    {
        std::array<float, 7> numbers;
        std::size_t count = 0;
        while (count < numbers.size() && !m_text.atLineEnd()) {
            numbers[count] = count < 3 ? m_text.number() : anyNumber(m_text);
            ++count;
        }
        if (count < 3 || count == 5 || !m_text.atLineEnd())
            m_text.fail(FileFault::VertexNumbers, m_text.word());
        if (m_mesh.points.size() == maxVertices)
            throw tooMany("vertices", maxVertices, errorAtLine({}, m_file, m_text.position()));
        const RawColor color{numbers[count - 3], numbers[count - 2], numbers[count - 1]};
        if (count >= 6 && std::ranges::all_of(color, [](float c) { return std::isfinite(c); })) {
            m_colors.resize(m_mesh.points.size(), noColor);
            m_colors.push_back(color);
        }
        m_mesh.points.emplace_back(numbers[0], numbers[1], numbers[2]);
    }

    void readFace()
    {
        while (!m_text.atLineEnd())
            faces().addCorner(readCorner());
        if (faces().cornersOfOpenFace() < 3) {
            if (m_text.atFileEnd())
                m_text.fail(FileErrorKind::CutOff, {});
            faces().dropOpenFace(); // only a point or an edge
            ++m_remarks.facesOfFewer;
            return;
        }
        if (faces().cornersOfOpenFace() > maxCorners)
            throw tooMany("corners", maxCorners, errorAtLine({}, m_file, m_text.position()));
        if (corners() > 3 * maxFaces)
            throw tooMany("faces", maxFaces, errorAtLine({}, m_file, m_text.position()));
        faces().endFace();
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

    Polygons& faces() { return m_objects.back().faces; }
    std::size_t corners() { return m_cornersBefore + faces().corners(); }

    /// Makes the triangles of all objects. If labels are on, labels the points; a point that several objects use is
    /// copied, so that each has its own.
    void makeTriangles(ObjectLabels& labels)
    {
        std::vector<Slot> owners(labels.isOn() ? m_mesh.points.size() : 0, noSlot);
        for (Slot object = 0; object < m_objects.size(); ++object) {
            labels.begin(m_objects[object].name);
            std::vector<Triangle> triangles = m_objects[object].faces.triangles(m_mesh.points, m_stopCheck, m_remarks);
            std::unordered_map<Slot, Slot> copies;
            for (Triangle& t : triangles)
                for (Slot& corner : t)
                    if (labels.isOn())
                        corner = ownCorner(corner, object, owners, copies);
            if (m_mesh.triangles.empty())
                m_mesh.triangles = std::move(triangles);
            else
                m_mesh.triangles.insert(m_mesh.triangles.end(), triangles.begin(), triangles.end());
        }
        for (const Slot owner : owners)
            m_mesh.parts.push_back(owner == noSlot ? PartId(0) : static_cast<PartId>(owner));
    }

    /// Returns the object's own point at a corner.
    Slot ownCorner(Slot corner, Slot object, std::vector<Slot>& owners, std::unordered_map<Slot, Slot>& copies)
    {
        if (owners[corner] == noSlot)
            owners[corner] = object;
        if (owners[corner] == object)
            return corner;
        const auto [copy, isNew] = copies.try_emplace(corner, static_cast<Slot>(m_mesh.points.size()));
        if (isNew) {
            owners.push_back(object);
            m_mesh.points.push_back(Vec3f(m_mesh.points[corner]));
            if (!m_mesh.colors.empty())
                m_mesh.colors.push_back(Rgb(m_mesh.colors[corner]));
        }
        return copy->second;
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
    struct Object
    {
        std::string name;
        Polygons faces;
    };
    std::vector<Object> m_objects = std::vector<Object>(1); ///< the first has the faces before the first line "o"
    std::size_t m_cornersBefore = 0;                        ///< corners of all objects but the last
    ReadRemarks m_remarks{.objects = 0};
    std::int64_t m_largest = -1;
    std::string_view m_largestWord;
};
} // namespace

ReadResult readObj(const FileBytes& file)
{
    return ObjReader(file).read();
}

void writeObj(AtomicFile& out, const TriangleMesh& mesh, std::span<const Rgb> palette, const PartList& parts)
{
    constexpr float fullColor = 255.0f;
    TextWriter text(out);
    if (!palette.empty())
        text << "# " << paletteWords(palette) << '\n';
    const FileParts pieces(mesh, parts);
    std::size_t first = 1; // indices start at 1 and go on from part to part
    for (const auto& [part, name] : pieces.all()) {
        if (!name.empty())
            text << "o " << cleanName(name) << '\n';
        for (std::size_t i = 0; i < part.points.size(); ++i) {
            const Vec3f& p = part.points[i];
            text << "v " << p.x() << ' ' << p.y() << ' ' << p.z();
            if (!part.colors.empty()) {
                const Rgb c = part.colors[i];
                text << ' ' << c.r / fullColor << ' ' << c.g / fullColor << ' ' << c.b / fullColor;
            }
            text << '\n';
        }
        for (const Triangle& t : part.triangles)
            text << "f " << t[0] + first << ' ' << t[1] + first << ' ' << t[2] + first << '\n';
        first += part.points.size();
    }
}
} // namespace core::io
