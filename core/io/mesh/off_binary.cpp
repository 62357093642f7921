// Source: Geomview manual, OFF files (big-endian, colour components counted); what other programs write was learnt from
// their files.
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
    std::size_t components; ///< the components of a vertex's colour
};

class BodyReader
{
public:
    BodyReader(const BinaryOff& off, const Dialect& dialect)
        : m_off(off)
        , m_dialect(dialect)
        , m_at(off.body)
        , m_end(off.file.bytes.data() + off.file.bytes.size())
        , m_stopCheck(off.file.stop)
    {}

    void read()
    {
        const std::size_t vertices = count("vertices", maxVertices, 4 * numbersEach()),
                          faces = count("faces", maxFaces, 4);
        next<std::uint32_t>(); // edges
        m_mesh.points.reserve(vertices);
        for (std::size_t i = 0; i < vertices; ++i)
            readVertex();
        for (std::size_t i = 0; i < faces; ++i)
            readFace(vertices);
        m_remarks.bytesBehind = static_cast<std::uint64_t>(m_end - m_at);
    }

    /// Returns the mesh. Precondition: read() has returned.
    ReadResult result()
    {
        m_mesh.triangles = m_faces.triangles(m_mesh.points, m_stopCheck, m_remarks);
        return {std::move(m_mesh), m_remarks};
    }

    bool isWhole() const { return m_at == m_end; }
    const char* position() const { return m_at; }

private:
    std::size_t numbersEach() const
    {
        return 3 + (m_off.hasNormals ? 3U : 0U) + (m_off.hasColors ? m_dialect.components : 0U) +
               (m_off.hasTexture ? 2U : 0U);
    }

    void requireRoom(std::uint64_t elements, std::size_t size) const
    {
        if (elements * size > static_cast<std::uint64_t>(m_end - m_at))
            throw withCounts(errorAtByte(FileErrorKind::CutOff, m_off.file, m_end),
                             static_cast<std::uint64_t>(m_at - m_off.file.bytes.data()) + elements * size,
                             m_off.file.bytes.size());
    }

    template <typename Number> Number next()
    {
        requireRoom(1, sizeof(Number));
        m_at += sizeof(Number);
        return load<Number>(m_at - sizeof(Number), m_dialect.order);
    }

    const char* lastAt() const { return m_at - 4; }

    std::size_t count(std::string_view what, std::size_t max, std::size_t sizeEach)
    {
        const auto number = next<std::uint32_t>();
        if (number > max)
            throw tooMany(what, max, errorAtByte({}, m_off.file, lastAt()));
        requireRoom(number, sizeEach);
        return number;
    }

    float finite()
    {
        const auto number = next<float>();
        if (!std::isfinite(number))
            throw errorAtByte(FileErrorKind::NotANumber, m_off.file, lastAt());
        return number;
    }

    void readVertex()
    {
        m_stopCheck();
        Vec3f& point = m_mesh.points.emplace_back();
        for (int k = 0; k < 3; ++k)
            point[k] = finite();
        for (int k = 0; m_off.hasNormals && k < 3; ++k)
            next<float>(); // skips the normal, whatever it is
        if (m_off.hasColors)
            readColor();
        for (int k = 0; m_off.hasTexture && k < 2; ++k)
            next<float>();
    }

    void readColor()
    {
        constexpr float full = 255.0F;
        std::array<std::uint8_t, 4> color{};
        for (std::size_t k = 0; k < m_dialect.components; ++k)
            color[k] = static_cast<std::uint8_t>(std::lround(std::clamp(finite() * full, 0.0F, full)));
        m_mesh.colors.push_back({color[0], color[1], color[2]});
    }

    void readFace(std::size_t vertices)
    {
        m_stopCheck();
        const auto corners = next<std::uint32_t>();
        if (corners > maxCorners)
            throw tooMany("corners", maxCorners, errorAtByte({}, m_off.file, lastAt()));
        if (corners == 0)
            throw malformed(FileFault::Count, errorAtByte({}, m_off.file, lastAt(), "0"));
        requireRoom(corners, 4);
        for (std::uint32_t i = 0; i < corners; ++i) {
            const auto index = next<std::uint32_t>();
            if (index >= vertices)
                throw withCounts(
                    errorAtByte(FileErrorKind::IndexOutOfRange, m_off.file, lastAt(), std::to_string(index)), vertices);
            if (corners >= 3)
                m_faces.addCorner(index);
        }
        if (corners >= 3)
            m_faces.endFace();
        if (m_dialect.countsComponents)
            skipComponents();
    }

    void skipComponents()
    {
        constexpr std::uint32_t most = 4;
        const auto components = next<std::uint32_t>();
        if (components > most)
            throw tooMany("colour components", most, errorAtByte({}, m_off.file, lastAt()));
        requireRoom(components, sizeof(float));
        m_at += components * sizeof(float);
    }

    const BinaryOff& m_off;
    Dialect m_dialect;
    const char* m_at;
    const char* m_end;
    StopCheck m_stopCheck;
    TriangleMesh m_mesh;
    Polygons m_faces;
    ReadRemarks m_remarks;
};
} // namespace

ReadResult BinaryOff::read() const
{
    std::optional<BodyReader> withRest; // the first that leaves only some bytes behind the model
    std::optional<FileError> problem;   // the problem of the reading that came furthest
    const char* furthest = nullptr;
    for (const std::endian order : {std::endian::big, std::endian::little})
        for (const bool countsComponents : {true, false})
            for (const std::size_t components : {std::size_t(4), std::size_t(3)}) {
                if (components == 3 && !hasColors)
                    continue;
                BodyReader reader(*this, {order, countsComponents, components});
                try {
                    reader.read();
                    if (reader.isWhole())
                        return reader.result();
                    if (!withRest)
                        withRest.emplace(std::move(reader));
                } catch (const FileError& error) {
                    if (problem && reader.position() <= furthest)
                        continue;
                    problem.emplace(error);
                    furthest = reader.position();
                }
            }
    if (!withRest)
        throw FileError(*problem);
    return withRest->result();
}
} // namespace core::io
