// Source: Geomview's manual, OFF files. Line ends are blanks like any other, except after a face's colour. A file has a
// header with the counts, then the vertices (with normal or colour, if the keyword says so), then the faces. Usually a
// vertex is one line, and a face begins a line; a face's colour is ignored. If a file cannot be read so, other layouts
// are tried. In those, vertices, faces or both begin right after the preceding one. Comments may be anywhere.
// off_binary.h reads BINARY.

#include "core/io/mesh/number_parsing.h"
#include "core/io/mesh/off_binary.h"
#include "core/io/mesh/palette.h"
#include "core/io/mesh/polygons.h"
#include "core/io/mesh/text_scanner.h"
#include "core/io/mesh/text_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <optional>

namespace core::io
{
namespace
{
constexpr std::size_t minVertex = 6; ///< smallest size in bytes: "0 0 0\n"

using RawColor = std::array<float, 3>;
constexpr RawColor noColor{-1, -1, -1};

/// States whether vertices and faces begin new lines, whose ends may have further words. Otherwise an element begins
/// right after the preceding one.
struct Layout
{
    bool ofVertices, ofFaces;
    std::size_t components = 4; ///< components of a vertex's colour; if vertices begin lines, 3 or 4 are accepted
};

/// The layouts in the order in which they are tried.
constexpr std::array<Layout, 6> layouts{
    {{true, true}, {false, false}, {false, true}, {false, false, 3}, {false, true, 3}, {true, false}}};

/// A measure of how well a layout fits a file that could not be read with it; larger is better.
struct Fit
{
    bool hasItsLines = true;  ///< false: the file has too few lines, and the first one contains several vertices
    std::size_t elements = 0; ///< number of elements that were read
    bool isWhole = true;      ///< false: the file ended before all elements were read

    auto operator<=>(const Fit&) const = default;
};

/// Returns the next word, on this line or a later one. Throws CutOff at the end of the file.
std::string_view nextWord(TextScanner& text)
{
    const std::string_view word = text.wordAnywhere();
    if (word.empty())
        text.fail(FileErrorKind::CutOff, {});
    return word;
}

/// Returns the number of further words on the line.
std::size_t wordsOnLine(TextScanner text)
{
    std::size_t words = 0;
    while (!text.word().empty())
        ++words;
    return words;
}

class OffReader
{
public:
    /// Begins to read at `from`.
    OffReader(const FileBytes& file, const Layout& lines, const char* from)
        : m_file(file)
        , m_text(file, from, '#')
        , m_stopCheck(file.stop)
        , m_lines(lines)
    {}

    ReadResult read()
    {
        readKeyword();
        if (isBinaryOff(m_file.bytes.substr(0, startSize))) {
            m_text.nextLine();
            return BinaryOff{m_file, m_text.position(), m_coordinates > 3, m_hasColors, m_hasTexture}.read();
        }
        m_vertices = readCount("vertices", maxVertices);
        m_announced = readCount("faces", maxFaces);
        m_mesh.points.reserve(std::min(m_vertices, m_file.bytes.size() / minVertex));
        skipEdges();
        try {
            readElements();
        } catch (const FileError& error) {
            if (error.kind != FileErrorKind::CutOff)
                throw;
            const std::size_t vertices = m_mesh.points.size();
            throw vertices < m_vertices ? withElements(error, "vertices", m_vertices, vertices)
                                        : withElements(error, "faces", m_announced, faces());
        }
        refuseFurtherFaces();
        if (m_lines.ofFaces)
            m_text.nextLine();
        if ((!m_lines.ofVertices || !m_lines.ofFaces) && parseDouble(m_text.wordAnywhere()))
            m_text.fail(FileErrorKind::CutOff, {}); // a number is left over: the numbers before it were misinterpreted
        m_mesh.triangles = m_faces.triangles(m_mesh.points, m_stopCheck, m_remarks);
        makeColors();
        return {std::move(m_mesh), m_remarks};
    }

    /// Returns how well the layout fits, after read() failed with this error.
    Fit fit(const FileError& error) const
    {
        const bool isCut = error.kind == FileErrorKind::CutOff;
        return {!isCut || !m_linesAreShared, m_mesh.points.size() + m_faces.faces() + m_remarks.facesOfFewer, !isCut};
    }

private:
    /// Reads the keyword: ST, C and N in this order, each optional, then OFF. nOFF is followed by the number of
    /// coordinates, which must be three. 4OFF is refused.
    void readKeyword()
    {
        const std::string_view keyword = nextWord(m_text);
        std::string_view rest = keyword;
        const auto takes = [&rest](std::string_view part) {
            const bool has = rest.starts_with(part);
            rest.remove_prefix(has ? part.size() : 0);
            return has;
        };
        m_hasTexture = takes("ST");
        m_hasColors = takes("C");
        m_coordinates = takes("N") ? 6 : 3;
        const bool isOfSpace = !takes("n") || nextWord(m_text) == "3";
        if (rest != "OFF" || !isOfSpace)
            m_text.fail(FileFault::Keyword, keyword, "OFF");
    }

    void readElements()
    {
        while (m_mesh.points.size() < m_vertices) {
            begin(m_lines.ofVertices);
            readVertex();
        }
        if (!m_lines.ofVertices && m_lines.ofFaces && m_vertices > 0 && !m_text.atLineEnd())
            m_text.fail(FileErrorKind::CutOff, {}); // the last vertex ends within a line
        while (faces() < m_announced) {
            begin(m_lines.ofFaces || (m_lines.ofVertices && faces() == 0));
            readFace();
        }
    }

    std::size_t faces() const { return m_faces.faces() + m_remarks.facesOfFewer; }

    /// Throws CountMismatch if faces follow the last one, which are more than the header announces.
    void refuseFurtherFaces() const
    {
        OffReader ahead(m_file, m_lines, m_text.position());
        ahead.m_vertices = m_vertices;
        const char* at = nullptr;
        try {
            while (true) {
                ahead.begin(m_lines.ofFaces);
                const char* const face = ahead.m_text.position();
                ahead.readFace();
                at = at ? at : face;
            }
        } catch (const FileError&) { // the end of the faces
        }
        if (at)
            throw withElements(errorAtLine(FileErrorKind::CountMismatch, m_file, at), "faces", m_announced,
                               m_announced + ahead.faces());
    }

    std::size_t readCount(std::string_view what, std::size_t max)
    {
        const std::string_view word = nextWord(m_text);
        const std::int64_t count = m_text.toInteger(word);
        if (count < 0)
            m_text.fail(FileFault::Count, word);
        if (static_cast<std::uint64_t>(count) > max)
            throw tooMany(what, max, errorAtLine({}, m_file, word.data()));
        return static_cast<std::size_t>(count);
    }

    /// Skips the number of edges, which is on this line or alone on the next. Many programs omit it.
    void skipEdges()
    {
        TextScanner ahead = m_text;
        if (!m_text.atLineEnd()) {
            m_text.word();
            return;
        }
        ahead.wordAnywhere();
        if (ahead.atLineEnd())
            m_text.wordAnywhere();
    }

    /// Begins an element. If `line` is true, moves to the next line that has words.
    void begin(bool line)
    {
        m_stopCheck();
        if (!line)
            return;
        do
            if (!m_text.nextLine())
                m_text.fail(FileErrorKind::CutOff, {});
        while (m_text.atLineEnd());
    }

    void readVertex()
    {
        std::array<float, 3> point;
        for (float& x : point)
            x = m_text.toNumber(nextWord(m_text));
        for (std::size_t i = point.size(); i < m_coordinates; ++i)
            nextWord(m_text); // a coordinate of the normal, ignored
        if (m_hasColors && (!m_lines.ofVertices || !m_text.atLineEnd()))
            readColor();
        for (int i = 0; i < 2 && m_hasTexture && !m_lines.ofVertices; ++i)
            nextWord(m_text);
        m_mesh.points.emplace_back(point[0], point[1], point[2]);
        if (m_lines.ofVertices && m_mesh.points.size() == 1)
            m_linesAreShared = wordsOnLine(m_text) >= m_coordinates + (m_hasColors ? 3 : 0) + (m_hasTexture ? 2 : 0);
    }

    /// Reads r g b, with or without a. Values are kept as written until it is known whether their maximum is 1 or 255.
    void readColor()
    {
        m_colors.resize(m_mesh.points.size(), noColor);
        RawColor& color = m_colors.emplace_back();
        const auto read = [this] {
            const std::string_view word = m_lines.ofVertices ? m_text.word() : nextWord(m_text);
            const float component = m_text.toNumber(word);
            m_hasFractions = m_hasFractions || word.find('.') != std::string_view::npos;
            m_largest = std::max(m_largest, component);
            return component;
        };
        for (float& c : color)
            c = read();
        if (m_lines.ofVertices ? !m_text.atLineEnd() : m_lines.components > color.size())
            read();
    }

    void makeColors()
    {
        if (m_colors.empty())
            return;
        m_colors.resize(m_mesh.points.size(), noColor);
        const float scale = m_hasFractions || m_largest <= 1 ? 255.0F : 1.0F;
        const auto byte = [scale](float x) {
            return static_cast<std::uint8_t>(std::lround(std::clamp(x * scale, 0.0F, 255.0F)));
        };
        m_mesh.colors.reserve(m_colors.size());
        for (const RawColor& c : m_colors) {
            m_stopCheck();
            m_mesh.colors.push_back(c == noColor ? Rgb() : Rgb{byte(c[0]), byte(c[1]), byte(c[2])});
        }
    }

    void readFace()
    {
        const std::string_view word = nextWord(m_text);
        const std::int64_t corners = m_text.toInteger(word);
        if (corners < 1)
            m_text.fail(FileFault::Count, word);
        if (corners < 3) { // a point or an edge
            for (std::int64_t i = 0; i < corners; ++i)
                readCorner();
            ++m_remarks.facesOfFewer;
            return;
        }
        if (corners > static_cast<std::int64_t>(maxCorners))
            throw tooMany("corners", maxCorners, errorAtLine({}, m_file, word.data()));
        for (std::int64_t i = 0; i < corners; ++i)
            m_faces.addCorner(readCorner());
        m_faces.endFace();
    }

    Slot readCorner()
    {
        const std::string_view word = nextWord(m_text);
        const std::int64_t index = m_text.toInteger(word);
        if (index < 0 || index >= static_cast<std::int64_t>(m_vertices))
            throw withCounts(errorAtLine(FileErrorKind::IndexOutOfRange, m_file, word.data(), word), m_vertices);
        return static_cast<Slot>(index);
    }

    const FileBytes& m_file;
    TextScanner m_text;
    StopCheck m_stopCheck;
    Layout m_lines;
    bool m_hasColors = false, m_hasTexture = false;
    bool m_linesAreShared = false;               ///< the line of the first vertex contains a further vertex
    std::size_t m_coordinates = 3;               ///< count of numbers before a vertex's colour: 3, or 6 with a normal
    std::size_t m_vertices = 0, m_announced = 0; ///< vertices and faces that the header announces
    TriangleMesh m_mesh;
    std::vector<RawColor> m_colors; ///< values as in the file; uncoloured vertices at the end are missing
    bool m_hasFractions = false;
    float m_largest = 0;
    Polygons m_faces;
    ReadRemarks m_remarks;
};
} // namespace

ReadResult readOff(const FileBytes& file)
{
    std::optional<FileError> error;
    Fit best;
    for (const Layout& lines : layouts) {
        OffReader reader(file, lines, file.bytes.data());
        try {
            return reader.read();
        } catch (const FileError& met) {
            if (const Fit fit = reader.fit(met); !error || fit > best) {
                error = met;
                best = fit;
            }
        }
    }
    throw FileError(*error);
}

void writeOff(AtomicFile& out, const TriangleMesh& mesh, std::span<const Rgb> palette)
{
    TextWriter text(out);
    text << (mesh.colors.empty() ? "OFF\n" : "COFF\n");
    if (!palette.empty())
        text << "# " << paletteWords(palette) << '\n';
    text << mesh.points.size() << ' ' << mesh.triangles.size() << " 0\n";
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const Vec3f& p = mesh.points[i];
        text << p.x() << ' ' << p.y() << ' ' << p.z();
        if (!mesh.colors.empty())
            text << ' ' << mesh.colors[i].r << ' ' << mesh.colors[i].g << ' ' << mesh.colors[i].b << " 255";
        text << '\n';
    }
    for (const Triangle& t : mesh.triangles)
        text << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
}
} // namespace core::io
