// Sources: Geomview manual, OFF files (big-endian, with counts of colour components); the variants of other programs
// were derived from their files.
#include "core/io/mesh/off_binary.h"

#include "core/io/mesh/binary.h"
#include "core/io/mesh/polygons.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

namespace core::io
{
namespace
{
struct Dialect
{
    std::endian order;
    bool countsComponents;  ///< a number of colour components follows each face
    std::size_t components; ///< number of components of a vertex's colour
};

/// Reads 32-bit numbers one after the other. Throws FileError.
class NumberInput
{
public:
    NumberInput(const FileBytes& file, const char* at, std::endian order)
        : m_file(file)
        , m_at(at)
        , m_end(file.bytes.data() + file.bytes.size())
        , m_order(order)
    {}

    std::uint32_t whole() { return next<std::uint32_t>(); }
    float real() { return next<float>(); }
    float finite()
    {
        const float number = real();
        if (!std::isfinite(number))
            throw errorAtLast(FileErrorKind::NotANumber);
        return number;
    }

    /// Reads the number of elements, each of which has at least `bytesEach` bytes. `what`: name of the elements, for
    /// errors.
    std::size_t count(std::string_view what, std::size_t max, std::size_t bytesEach)
    {
        const std::uint32_t number = whole();
        if (number > max)
            throw tooMany(what, max, errorAtLast({}));
        requireBytes(std::uint64_t(number) * bytesEach);
        return number;
    }

    void skip(std::size_t numbers)
    {
        requireBytes(numbers * size);
        m_at += numbers * size;
    }

    FileError errorAtLast(FileErrorKind kind, std::string_view token = {}) const
    {
        return errorAtByte(kind, m_file, m_at - size, token);
    }

    FileError errorAtNext(FileErrorKind kind) const { return errorAtByte(kind, m_file, m_at); }
    FileError errorAtEnd(FileErrorKind kind) const { return errorAtByte(kind, m_file, m_end); }

    std::size_t bytesLeft() const { return static_cast<std::size_t>(m_end - m_at); }

private:
    static constexpr std::size_t size = 4;

    template <typename Number> Number next()
    {
        requireBytes(size);
        m_at += size;
        return load<Number>(m_at - size, m_order);
    }

    void requireBytes(std::uint64_t count) const
    {
        if (count > bytesLeft())
            throw withCounts(errorAtEnd(FileErrorKind::CutOff), m_file.bytes.size() - bytesLeft() + count,
                             m_file.bytes.size());
    }

    const FileBytes& m_file;
    const char* m_at;
    const char* m_end;
    std::endian m_order;
};

class BodyReader
{
public:
    BodyReader(const BinaryOff& off, const Dialect& dialect)
        : m_off(off)
        , m_dialect(dialect)
        , m_input(off.file, off.body, dialect.order)
        , m_stopCheck(off.file.stop)
    {}

    void read()
    {
        m_vertices = m_input.count("vertices", maxVertices, 0);
        m_announced = m_input.count("faces", maxFaces, 0);
        m_input.skip(1); // the number of edges
        if (const std::size_t room = m_input.bytesLeft() / (4 * numbersEach()); m_vertices > room)
            throw withElements(m_input.errorAtEnd(FileErrorKind::CutOff), "vertices", m_vertices, room);
        m_mesh.points.reserve(m_vertices);
        try {
            while (m_mesh.points.size() < m_vertices)
                readVertex();
            while (faces() < m_announced)
                readFace();
        } catch (const FileError& error) {
            throw error.kind == FileErrorKind::CutOff ? withElements(error, "faces", m_announced, faces()) : error;
        }
        m_remarks.bytesBehind = m_input.bytesLeft();
    }

    /// Throws CountMismatch if faces follow the last one, which are more than the header announces. Precondition:
    /// read() has returned.
    void refuseFurtherFaces() const
    {
        BodyReader ahead = *this;
        try {
            for (;; ++ahead.m_announced)
                ahead.readFace();
        } catch (const FileError&) { // the end of the faces
        }
        if (ahead.m_announced > m_announced)
            throw withElements(m_input.errorAtNext(FileErrorKind::CountMismatch), "faces", m_announced,
                               ahead.m_announced);
    }

    /// Returns the mesh. Precondition: read() has returned.
    ReadResult result()
    {
        m_mesh.triangles = m_faces.triangles(m_mesh.points, m_stopCheck, m_remarks);
        return {std::move(m_mesh), m_remarks};
    }

    std::size_t bytesLeft() const { return m_input.bytesLeft(); }

private:
    std::size_t faces() const { return m_faces.faces() + m_remarks.facesOfFewer; }

    std::size_t numbersEach() const
    {
        return 3 + (m_off.hasNormals ? 3U : 0U) + (m_off.hasColors ? m_dialect.components : 0U) +
               (m_off.hasTexture ? 2U : 0U);
    }

    void readVertex()
    {
        m_stopCheck();
        Vec3f& point = m_mesh.points.emplace_back();
        for (int k = 0; k < 3; ++k)
            point[k] = m_input.finite();
        if (m_off.hasNormals)
            m_input.skip(3);
        if (m_off.hasColors)
            readColor();
        if (m_off.hasTexture)
            m_input.skip(2);
    }

    void readColor()
    {
        constexpr float full = 255.0F;
        std::array<std::uint8_t, 4> color{};
        for (std::size_t k = 0; k < m_dialect.components; ++k)
            color[k] = static_cast<std::uint8_t>(std::lround(std::clamp(m_input.finite() * full, 0.0F, full)));
        m_mesh.colors.push_back({color[0], color[1], color[2]});
    }

    void readFace()
    {
        m_stopCheck();
        const std::size_t corners = m_input.count("corners", maxCorners, 4);
        if (corners == 0)
            throw malformed(FileFault::Count, m_input.errorAtLast({}, "0"));
        for (std::size_t i = 0; i < corners; ++i) {
            const std::uint32_t index = m_input.whole();
            if (index >= m_vertices)
                throw withCounts(m_input.errorAtLast(FileErrorKind::IndexOutOfRange, std::to_string(index)),
                                 m_vertices);
            if (corners >= 3)
                m_faces.addCorner(index);
        }
        if (corners >= 3)
            m_faces.endFace();
        else
            ++m_remarks.facesOfFewer;
        if (m_dialect.countsComponents)
            m_input.skip(m_input.count("colour components", maxComponents, 4));
    }

    static constexpr std::size_t maxComponents = 4;

    const BinaryOff& m_off;
    Dialect m_dialect;
    NumberInput m_input;
    StopCheck m_stopCheck;
    std::size_t m_vertices = 0, m_announced = 0; ///< vertices and faces that the header announces
    TriangleMesh m_mesh;
    Polygons m_faces;
    ReadRemarks m_remarks;
};
} // namespace

ReadResult BinaryOff::read() const
{
    std::optional<BodyReader> withRest; // the first dialect that leaves only some bytes after the model
    std::optional<FileError> problem;   // the error of the dialect that read furthest
    std::size_t minLeft = 0;
    for (const std::endian order : {std::endian::big, std::endian::little})
        for (const bool countsComponents : {true, false})
            for (const std::size_t components : {std::size_t(4), std::size_t(3)}) {
                if (components == 3 && !hasColors)
                    continue;
                BodyReader reader(*this, {order, countsComponents, components});
                try {
                    reader.read();
                    if (reader.bytesLeft() == 0)
                        return reader.result();
                    if (!withRest)
                        withRest.emplace(std::move(reader));
                } catch (const FileError& error) {
                    if (problem && reader.bytesLeft() >= minLeft)
                        continue;
                    problem.emplace(error);
                    minLeft = reader.bytesLeft();
                }
            }
    if (!withRest)
        throw FileError(*problem);
    withRest->refuseFurtherFaces();
    return withRest->result();
}
} // namespace core::io
