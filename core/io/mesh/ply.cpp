// Reads PLY. The header declares elements and their properties. Vertices, faces and triangle strips are read; other
// elements are skipped.

#include "core/io/mesh/palette.h"
#include "core/io/mesh/ply_source.h"
#include "core/io/mesh/polygons.h"
#include "core/io/mesh/record_writer.h"
#include "core/io/mesh/text_writer.h"
#include "core/io/mesh/triangle_strips.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace core::io
{
namespace
{
constexpr std::size_t rowsPerChunk = 1 << 15;

enum class Role { X, Y, Z, Red, Green, Blue, Corners, None };

Role roleOf(const PlyProperty& property, bool ofVertex)
{
    struct Name
    {
        std::string_view name;
        Role role;
    };
    constexpr std::array vertexNames{
        Name{"x", Role::X},
        Name{"y", Role::Y},
        Name{"z", Role::Z},
        Name{"red", Role::Red},
        Name{"green", Role::Green},
        Name{"blue", Role::Blue},
        Name{"r", Role::Red},
        Name{"g", Role::Green},
        Name{"b", Role::Blue},
        Name{"diffuse_red", Role::Red},
        Name{"diffuse_green", Role::Green},
        Name{"diffuse_blue", Role::Blue},
    };
    if (!ofVertex)
        return property.isList() && (property.name == "vertex_indices" || property.name == "vertex_index")
                   ? Role::Corners
                   : Role::None;
    const auto found = std::ranges::find(vertexNames, property.name, &Name::name);
    return property.isList() || found == vertexNames.end() ? Role::None : found->role;
}

std::vector<Role> rolesOf(const PlyElement& element, bool ofVertex)
{
    std::vector<Role> roles;
    for (const PlyProperty& property : element.properties)
        roles.push_back(roleOf(property, ofVertex));
    return roles;
}

bool has(const std::vector<Role>& roles, std::initializer_list<Role> wanted)
{
    return std::ranges::all_of(wanted, [&](Role role) { return std::ranges::find(roles, role) != roles.end(); });
}

void requireFew(const FileBytes& file, const PlyElement& element, std::string_view what, std::size_t max)
{
    if (element.count > max)
        throw tooMany(what, max, errorAtLine({}, file, element.line));
}

template <typename Source> std::uint8_t readColor(Source& source, PlyType type)
{
    constexpr float full = 255.0f;
    constexpr std::int64_t wideToByte = 257; // 65535 / 255
    if (!isWhole(type))
        return static_cast<std::uint8_t>(std::lround(std::clamp(source.number(type) * full, 0.0f, full)));
    const std::int64_t value = source.whole(type) / (type == PlyType::Uint16 ? wideToByte : 1);
    return static_cast<std::uint8_t>(std::clamp<std::int64_t>(value, 0, 255));
}

/// Stores faces of three corners directly at their final places; further corners are ignored.
class TriangleRows
{
public:
    explicit TriangleRows(Triangle* first) : m_at(first) {}
    void addCorner(Slot corner)
    {
        if (m_corners < 3)
            (*m_at)[m_corners++] = corner;
    }
    void endFace()
    {
        ++m_at;
        m_corners = 0;
    }

private:
    Triangle* m_at;
    std::size_t m_corners = 0;
};

template <typename Source> std::int64_t lengthOf(Source& source, const PlyProperty& property)
{
    const std::int64_t count = source.whole(*property.countType);
    if (count < 0)
        source.fail(FileFault::Count);
    return count;
}

template <typename Source> void skip(Source& source, const PlyProperty& property)
{
    const std::int64_t count = property.isList() ? lengthOf(source, property) : 1;
    source.skip(property.type, static_cast<std::uint64_t>(count));
}

template <typename Source> class BodyReader
{
public:
    BodyReader(const FileBytes& file, const PlyHeader& header)
        : m_file(file)
        , m_header(header)
        , m_source(file, header)
        , m_stopCheck(file.stop)
    {
        if (const PlyElement* const vertices = header.find("vertex"))
            m_vertices = vertices->count;
    }

    ReadResult read()
    {
        for (const PlyElement& element : m_header.elements) {
            try {
                readElement(element);
            } catch (const FileError& error) {
                const bool isVertex = element.name == "vertex";
                if (error.kind == FileErrorKind::CutOff && (isVertex || element.name == "face"))
                    throw withElements(error, isVertex ? "vertices" : "faces", element.count, m_done);
                throw;
            }
        }
        refuseFurtherFaces();
        m_remarks.bytesBehind = Source::hasRows ? m_source.bytesLeft() : 0;
        if (m_mesh.triangles.empty())
            m_mesh.triangles = m_faces.triangles(m_mesh.points, m_stopCheck, m_remarks);
        const std::vector<Triangle>& strips = m_strips.triangles();
        m_mesh.triangles.insert(m_mesh.triangles.end(), strips.begin(), strips.end());
        m_remarks.unannounced = m_source.hasMore();
        return {std::move(m_mesh), m_remarks};
    }

private:
    void readElement(const PlyElement& element)
    {
        m_done = 0;
        if (element.name == "vertex")
            return readVertices(element);
        if (element.name == "face")
            return readFaces(element);
        requireRoom(element);
        element.name == "tristrips" ? readStrips(element) : skipAll(element);
    }

    /// Throws CutOff if the file is too short for the declared count, before memory is allocated for it.
    void requireRoom(const PlyElement& element)
    {
        const std::uint64_t min = element.minSize(m_header.encoding), left = m_source.bytesLeft() + 1;
        if (min != 0 && element.count > left / min) { // one byte more, because the last line may have no end
            const bool isCountable = element.count <= ~std::uint64_t(0) / min;
            m_done = (left - 1) / min;
            throw withCounts(errorAtByte(FileErrorKind::CutOff, m_file, m_file.bytes.data() + m_file.bytes.size()),
                             isCountable ? element.count * min : ~std::uint64_t(0), left - 1);
        }
    }

    void readVertices(const PlyElement& element)
    {
        requireRoom(element);
        requireFew(m_file, element, "vertices", maxVertices);
        const std::vector<Role> roles = rolesOf(element, true);
        if (!has(roles, {Role::X, Role::Y, Role::Z}))
            throw malformed(FileFault::Coordinates, errorAtLine({}, m_file, element.line, element.name));
        const bool colored = has(roles, {Role::Red, Role::Green, Role::Blue});
        resizeInLargePages(m_mesh.points, element.count);
        if (colored)
            m_mesh.colors.resize(element.count);
        if constexpr (Source::hasRows) {
            if (std::ranges::none_of(element.properties, &PlyProperty::isList)) {
                const std::uint64_t size = element.minSize(m_header.encoding);
                forEachChunk(element.count, rowsPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
                    Source rows = m_source;
                    rows.skip(PlyType::Uint8, begin * size);
                    StopCheck stopCheck(m_file.stop);
                    for (std::size_t i = begin; i < end; ++i) {
                        stopCheck();
                        readVertex(rows, element, roles, colored, i);
                    }
                });
                m_source.skip(PlyType::Uint8, element.count * size);
                return;
            }
        }
        for (; m_done < element.count; ++m_done) {
            m_stopCheck();
            readVertex(m_source, element, roles, colored, m_done);
        }
    }

    void readVertex(Source& source, const PlyElement& element, const std::vector<Role>& roles, bool colored,
                    std::size_t index)
    {
        std::array<float, 3> point{};
        std::array<std::uint8_t, 3> color{};
        source.beginElement();
        for (std::size_t i = 0; i < roles.size(); ++i) {
            const PlyProperty& property = element.properties[i];
            if (roles[i] <= Role::Z)
                point[static_cast<std::size_t>(roles[i])] = source.number(property.type);
            else if (roles[i] <= Role::Blue && colored)
                color[static_cast<std::size_t>(roles[i]) - 3] = readColor(source, property.type);
            else
                skip(source, property);
        }
        source.endElement();
        m_mesh.points[index] = Vec3f(point[0], point[1], point[2]);
        if (colored)
            m_mesh.colors[index] = {color[0], color[1], color[2]};
    }

    void readFaces(const PlyElement& element)
    {
        if (element.count <= m_source.bytesLeft()) // else the file's end is met first
            requireFew(m_file, element, "faces", maxFaces);
        const std::vector<Role> roles = rolesOf(element, false);
        if (!has(roles, {Role::Corners}))
            return skipAll(element);
        if constexpr (Source::hasRows)
            if (readFacesInRows(element, roles))
                return;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            m_stopCheck();
            m_remarks.facesOfFewer += readFace(m_source, element, roles, m_faces) ? 0 : 1;
            ++m_done;
        }
    }

    /// Throws CountMismatch if faces follow the last element, which are more than the header declares.
    void refuseFurtherFaces()
    {
        if (m_header.elements.empty() || m_header.elements.back().name != "face")
            return;
        const PlyElement& element = m_header.elements.back();
        const std::vector<Role> roles = rolesOf(element, false);
        std::uint64_t further = 0;
        Source source = m_source;
        try {
            for (Polygons faces; readFace(source, element, roles, faces); faces.clear()) {
                m_stopCheck();
                ++further;
            }
        } catch (const FileError&) { // the end of the faces
        }
        if (further > 0)
            throw withElements(m_source.errorAtNext(FileErrorKind::CountMismatch), "faces", element.count,
                               element.count + further);
    }

    /// Reads an element of triangle strips. Each list is a strip; the index -1 ends it and begins another.
    void readStrips(const PlyElement& element)
    {
        requireFew(m_file, element, "triangle strips", maxFaces);
        const std::vector<Role> roles = rolesOf(element, false);
        if (!has(roles, {Role::Corners}))
            return skipAll(element);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            m_source.beginElement();
            for (std::size_t k = 0; k < roles.size(); ++k)
                roles[k] == Role::Corners ? readStrip(element.properties[k]) : skip(m_source, element.properties[k]);
            m_source.endElement();
        }
    }

    void readStrip(const PlyProperty& property)
    {
        constexpr std::int64_t minusOneUnsigned = 0xffffffff;
        m_strips.restart();
        for (std::int64_t left = lengthOf(m_source, property); left > 0; --left) {
            m_stopCheck();
            const std::int64_t index = m_source.listed(property.type);
            if (index == -1 || index == minusOneUnsigned) {
                m_strips.restart();
                continue;
            }
            if (index < 0 || static_cast<std::uint64_t>(index) >= m_vertices)
                m_source.fail(FileErrorKind::IndexOutOfRange, m_vertices, std::to_string(index));
            m_strips.add(static_cast<Slot>(index));
            if (m_strips.triangles().size() > maxFaces)
                m_source.fail(FileErrorKind::TooManyElements, maxFaces, "faces");
        }
    }

    /// Reads faces of fixed size on all cores. Returns false and changes nothing if the faces differ in their number of
    /// corners, or if anything is wrong.
    bool readFacesInRows(const PlyElement& element, const std::vector<Role>& roles)
    {
        if (std::ranges::count_if(element.properties, &PlyProperty::isList) != 1 || element.count == 0 ||
            m_mesh.points.empty())
            return false;
        try {
            Polygons first;
            Source afterFirst = m_source;
            if (!readFace(afterFirst, element, roles, first))
                return false;
            const std::uint64_t size = m_source.bytesLeft() - afterFirst.bytesLeft(),
                                trianglesEach = first.corners() - 2;
            if (element.count > m_source.bytesLeft() / size || element.count * trianglesEach > maxFaces)
                return false;
            std::vector<Triangle> triangles;
            resizeInLargePages(triangles, element.count * trianglesEach);
            std::atomic<bool> areRows = true;
            forEachChunk(element.count, rowsPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
                Source rows = m_source;
                rows.skip(PlyType::Uint8, begin * size);
                const auto readAll = [&](auto& faces) {
                    for (std::size_t i = begin; i < end && areRows; ++i) {
                        const std::uint64_t left = rows.bytesLeft();
                        readFace(rows, element, roles, faces);
                        if (rows.bytesLeft() != left - size)
                            areRows = false;
                    }
                };
                if (trianglesEach == 1) {
                    TriangleRows faces(&triangles[begin]);
                    return readAll(faces);
                }
                Polygons faces;
                faces.reserve(end - begin, trianglesEach + 2);
                readAll(faces);
                if (!areRows)
                    return;
                ReadRemarks remarks;
                const std::vector<Triangle> cut = faces.triangles(m_mesh.points, StopCheck(m_file.stop), remarks);
                if (cut.size() != (end - begin) * trianglesEach)
                    areRows = false; // repeated corners were left out
                else
                    std::ranges::copy(cut, triangles.begin() + static_cast<std::ptrdiff_t>(begin * trianglesEach));
            });
            if (!areRows)
                return false;
            m_mesh.triangles = std::move(triangles);
            m_source.skip(PlyType::Uint8, element.count * size);
            return true;
        } catch (const FileError&) {
            return false; // reading face by face will report the place of the error
        }
    }

    /// Adds a face. Returns false and adds nothing if it is a point or an edge.
    template <typename Faces>
    bool readFace(Source& source, const PlyElement& element, const std::vector<Role>& roles, Faces& faces) const
    {
        bool isFace = false;
        source.beginElement();
        for (std::size_t k = 0; k < roles.size(); ++k)
            if (roles[k] == Role::Corners)
                isFace = readCorners(source, element.properties[k], faces) || isFace;
            else
                skip(source, element.properties[k]);
        source.endElement();
        return isFace;
    }

    template <typename Faces> bool readCorners(Source& source, const PlyProperty& property, Faces& faces) const
    {
        const std::int64_t count = lengthOf(source, property);
        if (count < 3) {
            source.skip(property.type, static_cast<std::uint64_t>(count));
            return false;
        }
        if (count > static_cast<std::int64_t>(maxCorners))
            source.fail(FileErrorKind::TooManyElements, maxCorners, "corners");
        for (std::int64_t i = 0; i < count; ++i) {
            const std::int64_t index = source.listed(property.type);
            if (index < 0 || static_cast<std::uint64_t>(index) >= m_vertices)
                source.fail(FileErrorKind::IndexOutOfRange, m_vertices, std::to_string(index));
            faces.addCorner(static_cast<Slot>(index));
        }
        faces.endFace();
        return true;
    }

    void skipAll(const PlyElement& element)
    {
        if (element.properties.empty())
            return;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            m_stopCheck();
            m_source.beginElement();
            for (const PlyProperty& property : element.properties)
                skip(m_source, property);
            m_source.endElement();
        }
    }

    FileBytes m_file;
    const PlyHeader& m_header;
    std::uint64_t m_vertices = 0; ///< number of vertices that the header declares
    std::uint64_t m_done = 0;     ///< elements read of the present kind
    Source m_source;
    StopCheck m_stopCheck;
    TriangleMesh m_mesh;
    Polygons m_faces;
    TriangleStrips m_strips;
    ReadRemarks m_remarks;
};

void writeHeader(TextWriter& text, const TriangleMesh& mesh, const WriteOptions& options)
{
    text << "ply\nformat " << (options.ascii ? "ascii" : "binary_little_endian") << " 1.0\n";
    if (!options.metadata.palette.empty())
        text << "comment " << paletteWords(options.metadata.palette) << '\n';
    text << "element vertex " << mesh.points.size() << "\nproperty float x\nproperty float y\nproperty float z\n";
    if (!mesh.colors.empty())
        text << "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    text << "element face " << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
}

void writeText(TextWriter& text, const TriangleMesh& mesh)
{
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const Vec3f& p = mesh.points[i];
        text << p.x() << ' ' << p.y() << ' ' << p.z();
        if (!mesh.colors.empty()) {
            const Rgb c = mesh.colors[i];
            text << ' ' << unsigned(c.r) << ' ' << unsigned(c.g) << ' ' << unsigned(c.b);
        }
        text << '\n';
    }
    for (const Triangle& t : mesh.triangles)
        text << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
}

void writeBinary(AtomicFile& out, const TriangleMesh& mesh)
{
    const bool colored = !mesh.colors.empty();
    writeRecords(out, mesh.points.size(), colored ? 15 : 12, [&](std::size_t i, char* into) {
        for (int k = 0; k < 3; ++k)
            store(into, mesh.points[i][k]);
        if (colored)
            for (const std::uint8_t part : {mesh.colors[i].r, mesh.colors[i].g, mesh.colors[i].b})
                store(into, part);
    });
    writeRecords(out, mesh.triangles.size(), 13, [&mesh](std::size_t i, char* into) {
        store(into, std::uint8_t(3));
        for (const Slot corner : mesh.triangles[i])
            store(into, static_cast<std::int32_t>(corner));
    });
}
} // namespace

ReadResult readPly(const FileBytes& file)
{
    const PlyHeader header = readPlyHeader(file);
    if (header.encoding == PlyEncoding::Ascii)
        return BodyReader<PlyTextSource>(file, header).read();
    return BodyReader<PlyBinarySource>(file, header).read();
}

void writePly(AtomicFile& out, const TriangleMesh& mesh, const WriteOptions& options)
{
    TextWriter text(out);
    writeHeader(text, mesh, options);
    options.ascii ? writeText(text, mesh) : writeBinary(out, mesh);
}
} // namespace core::io
