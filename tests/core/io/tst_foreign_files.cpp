// Tests files of other programs that deviate from the standards. Each must give the same model as a plain file. Error
// messages must state what was expected, what was found and where. Random bytes must not crash a reader.

#include "core/io/mesh_io.h"
#include "core/util/file_error.h"
#include "tests/support/effort.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QTest>

#include <zip.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <random>

namespace
{
using core::FileError;
using core::FileFault;
using core::FilePlace;
using core::Slot;
using core::TriangleMesh;
using core::Vec3f;
using Kind = core::FileErrorKind;

/// Corners of the sides of the box of all tests, 10 x 20 x 30, counter-clockwise as seen from outside. Bits 0, 1, 2 of
/// a corner number select the far side in x, y, z.
const std::vector<std::vector<int>> quads{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

Vec3f cornerOf(int i)
{
    return {i & 1 ? 10.0F : 0.0F, i & 2 ? 20.0F : 0.0F, i & 4 ? 30.0F : 0.0F};
}

std::string wordsOf(int corner)
{
    const Vec3f p = cornerOf(corner);
    return std::to_string(int(p.x())) + ' ' + std::to_string(int(p.y())) + ' ' + std::to_string(int(p.z()));
}

std::vector<std::array<int, 3>> boxTriangles()
{
    std::vector<std::array<int, 3>> all;
    for (const auto& q : quads) {
        all.push_back({q[0], q[1], q[2]});
        all.push_back({q[0], q[2], q[3]});
    }
    return all;
}

/// Returns the coordinates of each triangle's corners, the lexicographically smallest corner first. The triangles are
/// sorted.
std::vector<std::array<float, 9>> surfaceOf(const TriangleMesh& mesh)
{
    const auto less = [](const Vec3f& a, const Vec3f& b) {
        return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    };
    std::vector<std::array<float, 9>> surface;
    for (const core::Triangle& t : mesh.triangles) {
        std::array<Vec3f, 3> corners{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), less), corners.end());
        auto& flat = surface.emplace_back();
        for (std::size_t i = 0; i < 9; ++i)
            flat[i] = corners[i / 3][static_cast<Eigen::Index>(i % 3)];
    }
    std::ranges::sort(surface);
    return surface;
}

double volumeOf(const TriangleMesh& mesh)
{
    double six = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        six += mesh.points[a].cast<double>().dot(mesh.points[b].cast<double>().cross(mesh.points[c].cast<double>()));
    return six / 6;
}

/// Returns whether each edge is used exactly once in each direction.
bool isClosed(const TriangleMesh& mesh)
{
    std::vector<std::pair<Slot, Slot>> there, back;
    for (const core::Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            there.emplace_back(t[i], t[(i + 1) % 3]);
            back.emplace_back(t[(i + 1) % 3], t[i]);
        }
    std::ranges::sort(there);
    std::ranges::sort(back);
    return there == back && std::ranges::adjacent_find(there) == there.end();
}

bool isSound(const TriangleMesh& mesh)
{
    for (const core::Triangle& t : mesh.triangles) {
        for (const Slot corner : t)
            if (corner >= mesh.points.size())
                return false;
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
            return false;
    }
    return !mesh.triangles.empty() && (mesh.colors.empty() || mesh.colors.size() == mesh.points.size()) &&
           std::ranges::all_of(mesh.points, [](const Vec3f& p) { return p.allFinite(); });
}

template <typename Number> std::string binary(Number number, std::endian order = std::endian::little)
{
    auto bytes = std::bit_cast<std::array<char, sizeof number>>(number);
    if (order != std::endian::native)
        std::reverse(bytes.begin(), bytes.end());
    return {bytes.data(), bytes.size()};
}

std::string replaced(std::string text, std::string_view old, std::string_view by)
{
    for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size())
        text.replace(at, old.size(), by);
    return text;
}

const std::string zero(1, '\0');

std::string objVertices(const std::string& behind = "")
{
    std::string text;
    for (int i = 0; i < 8; ++i)
        text += "v " + wordsOf(i) + behind + "\n";
    return text;
}

std::string objFaces(const std::string& behind = "")
{
    std::string text;
    for (const auto& q : quads) {
        text += "f";
        for (const int corner : q)
            text += ' ' + std::to_string(corner + 1);
        text += behind + "\n";
    }
    return text;
}

struct TextStl
{
    std::string normal = " normal 0 0 1", behindLoop = {}, behindEnd = {}, behindFacet = {}, between = {},
                head = "solid a box\n", tail = "endsolid a box\n";

    std::string text() const
    {
        std::string all = head;
        for (const auto& t : boxTriangles()) {
            all += between + " facet" + normal + "\n  outer loop" + behindLoop + "\n";
            for (const int corner : t)
                all += "   vertex " + wordsOf(corner) + "\n" + between;
            all += "  endloop" + behindEnd + "\n endfacet" + behindFacet + "\n";
        }
        return all + between + tail;
    }
};

std::string binaryStl(std::uint32_t count, const std::string& behind = "", std::string head = "box")
{
    head.resize(80, ' ');
    head += binary(count);
    for (const auto& t : boxTriangles()) {
        head += std::string(12, '\0');
        for (const int corner : t)
            for (int k = 0; k < 3; ++k)
                head += binary(cornerOf(corner)[k]);
        head += std::string(2, '\0');
    }
    return head + behind;
}

/// A PLY file of the box's points. Members are inserted into its header and its body.
struct Ply
{
    std::string format = "ascii", elements = {}, body = {}, vertexLine = "\n", early = {};

    bool isText() const { return format == "ascii"; }
    std::endian order() const { return format == "binary_big_endian" ? std::endian::big : std::endian::little; }
    std::string whole(std::int32_t x) const { return isText() ? std::to_string(x) + ' ' : binary(x, order()); }

    std::string text(const std::string& properties = "") const
    {
        std::string all = "ply\nformat " + format + " 1.0\n" + early +
                          "element vertex 8\nproperty float x\nproperty float y\nproperty float z\n" + properties +
                          elements + "end_header\n";
        for (int i = 0; i < 8; ++i) {
            if (isText())
                all += wordsOf(i) + vertexLine;
            else
                for (int k = 0; k < 3; ++k)
                    all += binary(cornerOf(i)[k], order());
        }
        return all + body;
    }
    void addList(const std::vector<int>& entries, const std::string& end = "\n")
    {
        body += whole(static_cast<std::int32_t>(entries.size()));
        for (const int entry : entries)
            body += whole(entry);
        body += isText() ? end : "";
    }
};

/// Returns a triangle strip for a quad. Its diagonal is not the one of the plain box.
std::vector<int> stripOf(const std::vector<int>& quad)
{
    return {quad[1], quad[2], quad[0], quad[3]};
}

std::string strips(const std::string& format, bool isUnsigned = false)
{
    Ply ply{.format = format};
    std::vector<int> all;
    for (const auto& quad : quads) {
        for (const int corner : stripOf(quad))
            all.push_back(corner);
        all.push_back(-1);
    }
    ply.elements =
        std::string("element tristrips 1\nproperty list int ") + (isUnsigned ? "uint" : "int") + " vertex_indices\n";
    ply.addList(all);
    return isUnsigned ? replaced(ply.text(), "-1", "4294967295") : ply.text();
}

/// Returns a PLY file in which a single triangle strip contains all quads. Degenerate triangles connect the quads.
std::string sewnStrip(const std::string& format)
{
    Ply ply{.format = format};
    std::vector<int> all;
    const auto& q = quads[0]; // the first quad consists of two strips of one triangle each
    std::vector<std::vector<int>> parts{{q[0], q[1], q[2]}, {q[0], q[2], q[3]}};
    std::transform(quads.begin() + 1, quads.end(), std::back_inserter(parts), stripOf);
    for (const std::vector<int>& strip : parts) {
        if (!all.empty())
            all.insert(all.end(), {all.back(), strip[0]});
        if (all.size() % 2 != 0) // strips must begin at an even position, where triangles are not reversed
            all.push_back(strip[0]);
        all.insert(all.end(), strip.begin(), strip.end());
    }
    ply.elements = "element tristrips 1\nproperty list int int vertex_indices\n";
    ply.addList(all);
    return ply.text();
}

std::string plyFaces(const std::string& format, const std::vector<std::vector<int>>& faces, const Ply& like = {},
                     const std::string& end = "\n")
{
    Ply ply = like;
    ply.format = format;
    ply.elements = "element face " + std::to_string(faces.size()) + "\nproperty list int int vertex_indices\n";
    for (const auto& face : faces)
        ply.addList(face, end);
    return ply.text();
}

/// Returns the quads with defects: repeated corners, an explicitly closed outline, and a slit. A point, an edge and a
/// degenerate triangle are added.
std::vector<std::vector<int>> clumsyFaces()
{
    auto faces = quads;
    faces[0] = {0, 2, 2, 2, 3, 1, 0};
    faces[1] = {4, 5, 7, 6, 4};
    faces[2] = {0, 1, 6, 1, 5, 4}; // the outline runs to corner 6 and back
    faces[3] = {2, 2, 6, 7, 3, 3, 2};
    faces.push_back({1});
    faces.push_back({1, 2});
    faces.push_back({1, 2, 2});
    faces.push_back({5, 4, 5, 4});
    return faces;
}

std::string offOf(const std::string& keyword, const std::string& sizes, const std::string& vertexEnd,
                  const std::string& within, const std::string& faceEnd)
{
    std::string text = keyword + sizes;
    for (int i = 0; i < 8; ++i)
        text += replaced(wordsOf(i), " ", within) + vertexEnd;
    for (const auto& q : quads) {
        text += "4";
        for (const int corner : q)
            text += within + std::to_string(corner);
        text += faceEnd;
    }
    return text;
}

/// An OFF file of a torus in any layout. `vertexWrap` and `faceWrap` are the words per line of the vertices and of the
/// faces; 0: one element per line.
struct OffLayout
{
    std::string keyword = "OFF", vertexMore = {}, faceMore = {};
    std::size_t vertexWrap = 0, faceWrap = 0;
    std::string badVertex = {}, badCorner = {}; ///< invalid word for the middle element; empty: none

    static TriangleMesh mesh() { return shapes::moved(shapes::torus(), {0.3F, 0.4F, 0.6F}); }

    std::string text() const
    {
        const TriangleMesh torus = mesh();
        std::vector<std::vector<std::string>> vertices, faces;
        for (const Vec3f& p : torus.points) {
            auto& words = vertices.emplace_back();
            for (const float x : p) {
                std::array<char, 32> word;
                words.emplace_back(word.data(), std::size_t(std::snprintf(word.data(), word.size(), "%.9g", x)));
            }
            words.push_back(vertexMore);
        }
        for (const core::Triangle& t : torus.triangles)
            faces.push_back({"3", std::to_string(t[0]), std::to_string(t[1]), std::to_string(t[2]), faceMore});
        if (!badVertex.empty())
            vertices[vertices.size() / 2][1] = badVertex;
        if (!badCorner.empty())
            faces[faces.size() / 2][2] = badCorner;
        return keyword + '\n' + std::to_string(vertices.size()) + ' ' + std::to_string(faces.size()) + " 0\n" +
               lines(vertices, vertexWrap) + lines(faces, faceWrap);
    }
    bool linesBeginVertices() const
    {
        const auto blanks = static_cast<std::size_t>(std::ranges::count(vertexMore, ' '));
        return vertexWrap % (vertexMore.empty() ? 3 : 4 + blanks) == 0;
    }
    std::string what() const
    {
        return keyword + ' ' + vertexMore + " by " + std::to_string(vertexWrap) + ", faces " + faceMore + " by " +
               std::to_string(faceWrap);
    }

private:
    static std::string lines(const std::vector<std::vector<std::string>>& elements, std::size_t wrap)
    {
        std::string all;
        for (const auto& element : elements) {
            for (const std::string& word : element)
                all += word.empty() ? word : word + ' ';
            all.back() = wrap == 0 ? '\n' : ' ';
        }
        std::size_t words = 0;
        for (char& c : all)
            if (c == ' ' && wrap != 0 && ++words % wrap == 0)
                c = '\n';
        all.back() = '\n';
        return all;
    }
};

/// Returns all layouts of OFF files that are tested.
std::vector<OffLayout> offLayouts()
{
    constexpr std::size_t allOnOne = 420'000; // more words than a file has, and a multiple of any vertex's words
    std::vector<OffLayout> all;
    for (const auto& [keyword, more] :
         std::vector<std::pair<std::string, std::string>>{{"OFF", ""},
                                                          {"NOFF", "0.5 0.5 0.7"},
                                                          {"COFF", "200 100 50 255"},
                                                          {"COFF", "200 100 50"},
                                                          {"STOFF", "0.25 0.75"},
                                                          {"STCNOFF", "0.5 0.5 0.7 200 100 50 255 0.25 0.75"}})
        for (const std::size_t vertexWrap : std::initializer_list<std::size_t>{0, 2, 3, 4, 5, 6, 7, 8, 9, 16, allOnOne})
            for (const std::size_t faceWrap : std::initializer_list<std::size_t>{0, 3, 7, 8, 9, allOnOne})
                all.push_back({keyword, more, "", vertexWrap, faceWrap});
    for (std::size_t i = 0; i < all.size(); ++i)
        if (OffLayout colored = all[i]; colored.faceWrap == 0 && colored.faceMore.empty()) {
            colored.faceMore = "255 0 0";
            all.push_back(colored);
        }
    return all;
}

struct BinaryOff
{
    std::endian order = std::endian::big;
    std::string keyword = "OFF";
    bool countsComponents = true;
    int normals = 0, components = 0, texture = 0, ofFace = 0;

    std::string bytes(std::uint32_t vertices = 8, std::uint32_t faces = 6) const
    {
        std::string all = keyword + " BINARY\n" + binary(vertices, order) + binary(faces, order) + binary(12U, order);
        for (int i = 0; i < 8; ++i) {
            for (int k = 0; k < 3; ++k)
                all += binary(cornerOf(i)[k], order);
            for (int k = 0; k < normals + components + texture; ++k)
                all += binary(k >= normals ? 1.0F : 0.5F, order);
        }
        for (const auto& q : quads) {
            all += binary(4U, order);
            for (const int corner : q)
                all += binary(corner, order);
            if (countsComponents)
                all += binary(ofFace, order);
            for (int k = 0; k < ofFace; ++k)
                all += binary(0.25F, order);
        }
        return all;
    }
};

std::string glbOf(const std::string& json, const std::string& chunk, bool isPadded)
{
    const auto padded = [isPadded](std::string text, char with) {
        if (isPadded)
            text.resize((text.size() + 3) / 4 * 4, with);
        return text;
    };
    const std::string text = padded(json, ' '), bytes = padded(chunk, '\0');
    const auto number = [](std::size_t x) { return binary(static_cast<std::uint32_t>(x)); };
    return "glTF" + number(2) + number(28 + text.size() + bytes.size()) + number(text.size()) + "JSON" + text +
           number(bytes.size()) + std::string("BIN\0", 4) + bytes;
}

/// Makes a GLB of the box in metres, the unit of glTF. `scene`, `nodes`: JSON members that end with a comma, or empty.
std::string glbBox(const std::string& scene = R"("scene":0,"scenes":[{"nodes":[0]}],)",
                   const std::string& nodes = R"("nodes":[{"mesh":0}],)", const std::string& more = "",
                   bool isPadded = true)
{
    std::string bytes;
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 3; ++k)
            bytes += binary(cornerOf(i)[k] / 1000);
    std::string corners;
    for (const auto& t : boxTriangles())
        for (const int corner : t)
            corners += static_cast<char>(corner);
    return glbOf("{" + more + scene + nodes +
                     R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)"
                     R"({"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"},)"
                     R"({"bufferView":1,"componentType":5121,"count":36,"type":"SCALAR"}],"bufferViews":[)"
                     R"({"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":36}],)"
                     R"("buffers":[{"byteLength":132}]})",
                 bytes + corners, isPadded);
}

using Parts = std::vector<std::pair<std::string, std::string>>;

std::string relationships(const std::string& target)
{
    return R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship )"
           R"(Target=")" +
           target + R"(" Id="x" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)";
}

std::string modelOf(const std::string& space = "core/2015/02", const std::string& more = "",
                    const std::string& prefix = "")
{
    std::string text = "<" + prefix + "model xmlns" +
                       (prefix.empty() ? "" : ":" + prefix.substr(0, prefix.size() - 1)) +
                       "=\"http://schemas.microsoft.com/3dmanufacturing/" + space + "\"><" + prefix + "resources>" +
                       more + "<" + prefix + "object id=\"1\"><" + prefix + "mesh><" + prefix + "vertices>";
    for (int i = 0; i < 8; ++i) {
        const Vec3f p = cornerOf(i);
        text += "<" + prefix + "vertex x=\"" + std::to_string(p.x()) + "\" y=\"" + std::to_string(p.y()) + "\" z=\"" +
                std::to_string(p.z()) + "\"/>";
    }
    text += "</" + prefix + "vertices><" + prefix + "triangles>";
    for (const auto& [a, b, c] : boxTriangles())
        text += "<" + prefix + "triangle v1=\"" + std::to_string(a) + "\" v2=\"" + std::to_string(b) + "\" v3=\"" +
                std::to_string(c) + "\"/>";
    return text + "</" + prefix + "triangles></" + prefix + "mesh></" + prefix + "object></" + prefix + "resources><" +
           prefix + "build><" + prefix + "item objectid=\"1\"/></" + prefix + "build></" + prefix + "model>";
}

std::string packageOf(const std::filesystem::path& path, const Parts& parts, int packing = ZIP_CM_DEFLATE)
{
    std::filesystem::remove(path);
    zip* const archive = zip_open(path.c_str(), ZIP_CREATE, nullptr);
    for (const auto& [name, text] : parts) {
        const auto index =
            zip_file_add(archive, name.c_str(), zip_source_buffer(archive, text.data(), text.size(), 0), 0);
        zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), packing, 0);
    }
    zip_close(archive);
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string utf16(std::string_view text, std::endian order, bool isMarked)
{
    std::string wide = isMarked ? binary(char16_t(0xfeff), order) : std::string();
    for (const char c : text)
        wide += binary(static_cast<char16_t>(c), order);
    return wide;
}

struct Sample
{
    const char* what;
    const char* name;
    std::string bytes;
};

std::vector<Sample> objSamples()
{
    const std::string v = objVertices(), f = objFaces();
    std::string clumsy = v + "v 0 20 0\n";
    for (auto face : clumsyFaces()) {
        clumsy += "f";
        for (const int corner : face)
            clumsy += ' ' + std::to_string(corner == 2 && face.size() == 7 ? 9 : corner + 1);
        clumsy += "\n";
    }
    return {{"obj", "a.obj", v + f},
            {"obj comments behind values", "a.obj", objVertices(" # corner") + objFaces("\t# face 1 2 3")},
            {"obj colours that are not finite", "a.obj", objVertices(" nan -nan inf") + objFaces()},
            {"obj colours of Windows", "a.obj", objVertices(" 1 -nan(ind) 0") + objFaces()},
            {"obj comments that touch values", "a.obj", objVertices("#1") + objFaces("#2")},
            {"obj comment that ends in a backslash", "a.obj", objVertices(" # c\\") + objFaces(" # \\")},
            {"obj comment on a continued line", "a.obj", replaced(v, " 20 ", " \\\n 20 ") + objFaces(" \\\n # 4")},
            {"obj mark", "a.obj", "\xef\xbb\xbf" + v + f},
            {"obj NUL last", "a.obj", v + f + zero},
            {"obj NUL behind the last number", "a.obj", v + f.substr(0, f.size() - 1) + zero},
            {"obj Ctrl+Z behind the last number", "a.obj", v + f.substr(0, f.size() - 1) + "\x1a"},
            {"obj padded", "a.obj", v + f + "\x1a\r\n" + std::string(500, '\0')},
            {"obj NUL in a name", "a.obj", "o a" + zero + "b\n" + v + f},
            {"obj repeated corners, points and edges", "a.obj", clumsy},
            {"obj old faces", "a.obj", v + replaced(f, "f ", "fo ")},
            {"obj points, lines and edges", "a.obj", v + "p 1\nl 1 2 3\nf 1 2\n" + f + "f 3\n"}};
}

std::vector<Sample> stlSamples()
{
    const std::string plain = TextStl().text();
    std::string twoSolids = replaced(plain, "\n", " ");
    twoSolids.insert(twoSolids.find("endfacet") + 8, " endsolid one solid two");
    std::string words = "Made by a program of 1999.\r\n";
    for (int i = 0; words.size() < 100; ++i)
        words += static_cast<char>('A' + i % 26);
    std::vector<Sample> all{
        {"stl", "a.stl", plain},
        {"stl without normals", "a.stl", TextStl{.normal = ""}.text()},
        {"stl normal without numbers", "a.stl", TextStl{.normal = " normal"}.text()},
        {"stl normal of two numbers", "a.stl", TextStl{.normal = " normal 0 1"}.text()},
        {"stl words behind", "a.stl",
         TextStl{.behindLoop = " 1", .behindEnd = " of 3", .behindFacet = " number 7 facets"}.text()},
        {"stl comments", "a.stl",
         TextStl{
             .behindLoop = " # a", .behindEnd = " ; b", .behindFacet = " // c", .between = "# facet vertex 1\n ; x\n"}
             .text()},
        {"stl comments around", "a.stl",
         TextStl{.head = "; by hand\n# twice\nsolid x\n", .tail = "endsolid x\n; the end\n"}.text()},
        {"stl words around and between", "a.stl", plain + "made by hand\n\nsolid two\nendsolid two\n-- end --\n"},
        {"stl mark", "a.stl", "\xef\xbb\xbf" + plain},
        {"stl NUL last", "a.stl", plain + zero},
        {"stl Ctrl+Z last", "a.stl", plain + "\x1a"},
        {"stl Ctrl+Z behind the last word", "a.stl", TextStl{.tail = "endsolid\x1a"}.text()},
        {"stl NUL in its name", "a.stl", replaced(plain, "a box", "a" + zero + "box")},
        {"stl padded name", "a.stl", TextStl{.head = "solid " + std::string(80, '\0') + "\n"}.text()},
        {"stl rubbish behind", "a.stl", plain + "\x01\x02\xff\xfe" + std::string(40, '\0') + "\x80 solid\n"},
        {"stl on a line", "a.stl", replaced(plain, "\n", " ")},
        {"stl on a line, of a facet", "a.stl", replaced(TextStl{.head = "solid facet x\n"}.text(), "\n", " ")},
        {"stl on a line, of a normal that is none", "a.stl",
         replaced(TextStl{.normal = " normal nan nan nan"}.text(), "\n", " ")},
        {"stl on a line, of a facet normal", "a.stl",
         replaced(TextStl{.head = "solid facet normal x\n"}.text(), "\n", " ")},
        {"stl of facets in its name", "a.stl",
         TextStl{.head = "solid facet outer shell of facet normal maps facet normal\n"}.text()},
        {"stl of two solids on a line", "a.stl", twoSolids},
        {"stl capitals and CR", "a.stl", replaced(replaced(plain, "\n", "\r"), "facet", "FACET")},
        {"binary stl", "a.stl", binaryStl(12)},
        {"binary stl of unknown count, 0", "a.stl", binaryStl(0)},
        {"binary stl of unknown count, all bits", "a.stl", binaryStl(0xffffffff)},
        {"binary stl that counts too few", "a.stl", binaryStl(11)},
        {"binary stl that counts too many", "a.stl", binaryStl(13)},
        {"binary stl that counts far too many", "a.stl", binaryStl(0x7fffffff)},
        {"binary stl with text of two triangles' size behind", "a.stl", binaryStl(12, words)},
        {"binary stl with text and zeros behind", "a.stl", binaryStl(12, words.substr(0, 80) + std::string(20, '\0'))},
        {"binary stl of facets and a rest", "a.stl", binaryStl(12, "x", "solid facet normal vertex")}};
    for (const char* const name :
         {"facet normal 2", "facet normal -x side", "facet normal .5 mm", "facet normal 3D print", "facet normal 0 0 1",
          "facet outer loop", "facet outer loop of a ring", "Facet NORMAL"})
        for (const char* const lineEnd : {"\n", " "})
            for (const char* const normal : {" normal 0 0 1", " normal a b c", " normal Infinity 0 0", ""})
                all.push_back({name, "a.stl",
                               replaced(TextStl{.normal = normal, .head = "solid " + std::string(name) + "\n"}.text(),
                                        "\n", lineEnd)});
    for (const char* const head : {"box", "solid box"})
        for (const std::size_t spare : {1, 2, 49, 50, 51, 100, 1000})
            all.push_back({"binary stl with a rest", "a.stl", binaryStl(12, std::string(spare, '\0'), head)});
    all.push_back({"binary stl with words behind", "a.stl", binaryStl(12, std::string(50, 'w'))});
    return all;
}

std::vector<Sample> plySamples()
{
    const std::string plain = plyFaces("ascii", quads);
    std::vector<Sample> all{
        {"ply", "a.ply", plain},
        {"ply stray lines in the header", "a.ply",
         replaced(plain, "1.0\n", "1.0\nCreated by some program\n\n; element vertex 9\n")},
        {"ply more columns", "a.ply", plyFaces("ascii", quads, {.vertexLine = " 0.5 red\n"}, " 255 0 0\n")},
        {"ply lists over lines", "a.ply", replaced(plyFaces("ascii", quads, {}, "@"), " @", "\n")},
        {"ply mark", "a.ply", "\xef\xbb\xbf" + plain},
        {"ply mark and CR LF", "a.ply", "\xef\xbb\xbf" + replaced(plain, "\n", "\r\n")},
        {"ply NUL last", "a.ply", plain.substr(0, plain.size() - 1) + zero},
        {"ply Ctrl+Z last", "a.ply", plain + "\x1a"},
        {"ply rubbish behind", "a.ply", plain + "made by hand \xff" + zero + "\n"},
        {"ply blank behind its first word", "a.ply", "ply \n" + plain.substr(4)},
        {"ply unsigned strips", "a.ply", strips("ascii", true)},
        {"ply lists in the middle of lines", "a.ply", replaced(plain, "4 0 2 3 1", "4 0\n2 3\n\n1")}};
    for (const char* const format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        all.push_back({"ply repeated corners, points and edges", "a.ply", plyFaces(format, clumsyFaces())});
        all.push_back({"ply strips", "a.ply", strips(format)});
        all.push_back({"ply sewn strip", "a.ply", sewnStrip(format)});
        Ply mixed{.format = format}; // faces, and then one strip per list
        mixed.elements = "element face 3\nproperty list int int vertex_index\nelement tristrips 3\n"
                         "property int what\nproperty list int int vertex_index\n";
        for (std::size_t i = 0; i < 3; ++i)
            mixed.addList(quads[i]);
        for (std::size_t i = 3; i < 6; ++i) {
            mixed.body += mixed.whole(7);
            mixed.addList(stripOf(quads[i]));
        }
        all.push_back({"ply faces and strips", "a.ply", mixed.text()});
    }
    const std::string bytes = plyFaces("binary_little_endian", quads);
    const std::size_t end = bytes.find("end_header\n") + 11;
    all.push_back({"ply binary, LF CR", "a.ply", replaced(bytes.substr(0, end), "\n", "\n\r") + bytes.substr(end)});
    all.push_back({"ply binary, zeros behind", "a.ply", bytes + std::string(100, '\0')});
    return all;
}

std::vector<Sample> offSamples()
{
    std::vector<Sample> all{
        {"off", "a.off", offOf("OFF\n", "8 6 0\n", "\n", " ", "\n")},
        {"off faces over lines", "a.off", replaced(offOf("OFF\n", "8 6 0\n", "\n", " ", "\n"), " 3 ", "\n3 \n\n")},
        {"off all over lines", "a.off", offOf("OFF\n", "8\n6\n0\n", "\n", "\n", "\n")},
        {"off comments", "a.off", offOf("# a\nOFF # b\n#c\n", "8 6 # 0\n", " # d\n# e\n", " ", "# f\n")},
        {"off comments within", "a.off", offOf("OFF\n", "8 6 0\n", "\n", " # 1\n", "\n")},
        {"off more columns", "a.off", offOf("OFF\n", "8 6 0\n", " 0.5 0.5\n", " ", " 255 0 0\n")},
        {"off mark", "a.off", "\xef\xbb\xbf" + offOf("OFF\n", "8 6 0\n", "\n", " ", "\n")},
        {"off NUL last", "a.off", offOf("OFF\n", "8 6 0\n", "\n", " ", "\n") + zero},
        {"off Ctrl+Z last", "a.off", offOf("OFF\n", "8 6 0\r\n", "\r\n", " ", "\r\n") + "\x1a"},
        {"off vertices on a line", "a.off", offOf("OFF\n", "8 6 0\n", " ", " ", "\n")},
        {"off faces on a line", "a.off", offOf("OFF\n", "8 6 0\n", "\n", " ", " ")},
        {"off all on a line", "a.off", offOf("OFF ", "8 6 0 ", " ", " ", " ")},
        {"off all on a line, with more", "a.off", offOf("STCNOFF ", "8 6 0 ", " 0 0 1 1 0 0 1 0.5 0.5 ", " ", " ")},
        {"off vertices on a line, faces with colours", "a.off",
         replaced(offOf("OFF\n", "8 6 0\n", " ", " ", " 255 0 0\n"), " 4 0 2 3 1", "\n4 0 2 3 1")},
        {"off vertices with colours on a line", "a.off", offOf("COFF\n", "8 6 0\n", " 255 0 0 255 ", " ", "\n")},
        {"off vertices with colours of three on a line", "a.off", offOf("COFF\n", "8 6 0\n", " 255 0 0 ", " ", "\n")},
        {"off vertices on a line, all with colours", "a.off",
         replaced(offOf("COFF\n", "8 6 0\n", " 255 0 0 ", " ", " 0\n"), " 4 0 2 3 1", "\n4 0 2 3 1")},
        {"off of three dimensions", "a.off", offOf("nOFF 3\n", "8 6 0\n", "\n", " ", "\n")},
        {"off of three dimensions, with colours", "a.off", offOf("CnOFF\n3\n", "8 6 0\n", " 1 0 0 1\n", " ", "\n")},
        {"off rubbish behind", "a.off", offOf("OFF\n", "8 6 0\n", "\n", " ", "\n") + "the end\xff\x01\n"},
        {"off repeated corners", "a.off",
         replaced(replaced(replaced(offOf("OFF\n", "8 9 0\n", "\n", " ", "\n"), "4 0 2 3 1", "6 0 2 2 3 1 0"),
                           "4 4 5 7 6", "3 1 2 2\n2 0 1\n1 0\n5 4 5 7 6 4"),
                  "4 0 1 5 4", "6 0 1 6 1 5 4")}};
    for (const std::endian order : {std::endian::big, std::endian::little})
        for (const bool counts : {true, false}) {
            all.push_back({"binary off", "a.off", BinaryOff{.order = order, .countsComponents = counts}.bytes()});
            all.push_back({"binary off with a rest", "a.off",
                           BinaryOff{.order = order, .countsComponents = counts}.bytes() + "\n\n"});
            all.push_back(
                {"binary off with normals", "a.off",
                 BinaryOff{.order = order, .keyword = "NOFF", .countsComponents = counts, .normals = 3}.bytes()});
            all.push_back(
                {"binary off with texture", "a.off",
                 BinaryOff{.order = order, .keyword = "STOFF", .countsComponents = counts, .texture = 2}.bytes()});
            for (const int components : {3, 4})
                all.push_back({"binary off with colours", "a.off",
                               BinaryOff{.order = order,
                                         .keyword = "STCNOFF",
                                         .countsComponents = counts,
                                         .normals = 3,
                                         .components = components,
                                         .texture = 2}
                                   .bytes()});
        }
    for (const int ofFace : {1, 3, 4})
        all.push_back({"binary off with coloured faces", "a.off", BinaryOff{.ofFace = ofFace}.bytes()});
    return all;
}

std::vector<Sample> gltfSamples()
{
    std::vector<Sample> all{
        {"glb", "a.glb", glbBox()},
        {"glb not padded", "a.glb",
         glbBox(R"("scenes":[{"nodes":[0]}],)", R"("nodes":[{"mesh":0}],)", R"("asset":{"version":"2.0"}, )", false)},
        {"glb not padded, a byte more", "a.glb",
         glbBox(R"("scenes":[{"nodes":[0]}],)", R"("nodes":[{"mesh":0}],)", R"("asset":{"version":"2.0"},  )", false)},
        {"glb not padded, two bytes more", "a.glb",
         glbBox(R"("scenes":[{"nodes":[0]}],)", R"("nodes":[{"mesh":0}],)", R"("asset":{"version":"2.0"},   )", false)},
        {"glb of numbers with a fraction of 0", "a.glb",
         glbBox(R"("scene":0.0,"scenes":[{"nodes":[0.0]}],)", R"("nodes":[{"mesh":0.0}],)")},
        {"glb without a scene", "a.glb", glbBox("")},
        {"glb without a scene, tree", "a.glb",
         glbBox("", R"("nodes":[{"mesh":0,"translation":[0,1,0]},{"children":[0],"translation":[0,-1,0]}],)")},
        {"glb without a scene, empty list", "a.glb", glbBox(R"("scenes":[],)")},
        {"glb without nodes", "a.glb", glbBox("", "")}};
    for (const std::string extension :
         {"EXT_texture_webp", "EXT_texture_avif", "KHR_texture_basisu", "KHR_texture_transform", "MSFT_texture_dds",
          "KHR_materials_unlit", "KHR_materials_clearcoat", "KHR_materials_variants", "KHR_lights_punctual",
          "EXT_lights_image_based", "KHR_mesh_quantization", "KHR_xmp_json_ld", "KHR_animation_pointer", "VRM",
          "VRMC_materials_mtoon", "ADOBE_materials_thin_transparency", "FB_ngon_encoding"})
        all.push_back({"glb that requires an extension without shape", "a.glb",
                       glbBox(R"("scenes":[{"nodes":[0]}],)", R"("nodes":[{"mesh":0}],)",
                              R"("extensionsRequired":[")" + extension + "\"],")});
    return all;
}

std::vector<Sample> packageSamples(const std::filesystem::path& path)
{
    const auto package = [&path](const std::string& target, const std::string& part, const std::string& model,
                                 const char* list = "_rels/.rels") {
        return packageOf(path, {{list, relationships(target)}, {part, model}});
    };
    const std::string stray = R"(<m:colorgroup id="5"><m:color color="#FF0000" m:what="1"/></m:colorgroup>)";
    return {
        {"3mf", "a.3mf", package("/3D/a.model", "3D/a.model", modelOf())},
        {"3mf of 2013", "a.3mf", package("/3D/a.model", "3D/a.model", modelOf("2013/01"))},
        {"3mf with prefixes", "a.3mf", package("/3D/a.model", "3D/a.model", modelOf("core/2015/02", "", "c:"))},
        {"3mf with undeclared prefixes", "a.3mf", package("/3D/a.model", "3D/a.model", modelOf("core/2015/02", stray))},
        {"3mf target with a percent sign", "a.3mf", package("/3D/my%20box.model", "3D/my box.model", modelOf())},
        {"3mf part with a percent sign", "a.3mf", package("/3D/my box.model", "3D/my%20box.model", modelOf())},
        {"3mf backslashes in the package", "a.3mf", package("/3D/a.model", "3D\\a.model", modelOf(), "_rels\\.rels")},
        {"3mf backslashes in the target", "a.3mf", package("\\3D\\a.model", "3D/a.model", modelOf())},
        {"3mf other case", "a.3mf", package("/3d/A.MODEL", "3D/a.model", modelOf(), "_RELS/.rels")}};
}
} // namespace

/// The corners of a polygon.
using Ring = std::vector<std::array<int, 2>>;
Q_DECLARE_METATYPE(Ring)

namespace
{
/// Returns an OBJ of one polygon. `isShared`: corners at one point are one vertex.
std::string objOf(const Ring& ring, bool isShared)
{
    std::string vertices = "# ring\n", face = "f";
    std::map<std::array<int, 2>, std::size_t> known;
    std::size_t count = 0;
    for (const auto& corner : ring) {
        const auto at = known.find(corner);
        if (!isShared || at == known.end())
            vertices += "v " + std::to_string(corner[0]) + ' ' + std::to_string(corner[1]) + " 0\n",
                known[corner] = ++count;
        face += ' ' + std::to_string(known[corner]);
    }
    return vertices + face + '\n';
}

/// Returns whether the triangles fill the polygon exactly: each turns as the polygon does, none is without area except
/// in a slit, and the border of all of them is the polygon.
bool fills(const TriangleMesh& mesh, const Ring& ring)
{
    std::map<std::pair<std::array<int, 2>, std::array<int, 2>>, int> edges;
    const auto add = [&edges](const std::array<int, 2>& from, const std::array<int, 2>& to, int times) {
        if (from != to)
            edges[std::minmax(from, to)] += from < to ? times : -times;
    };
    const auto cross = [](const auto& a, const auto& b) { return a[0] * b[1] - a[1] * b[0]; };
    int area = 0, sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto& next = ring[(i + 1) % ring.size()];
        area += cross(ring[i], next);
        add(ring[i], next, 1);
    }
    for (const core::Triangle& t : mesh.triangles) {
        std::array<std::array<int, 2>, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = {static_cast<int>(mesh.points[t[i]].x()), static_cast<int>(mesh.points[t[i]].y())};
        int twice = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            add(corners[i], corners[(i + 1) % 3], -1);
            twice += cross(corners[i], corners[(i + 1) % 3]);
        }
        if ((twice < 0) != (area < 0) && twice != 0)
            return false;
        sum += twice;
    }
    return sum == area && std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; });
}
} // namespace

class TestForeignFiles : public QObject
{
    Q_OBJECT

    static constexpr unsigned seed = 20261126;

private Q_SLOTS:
    void initTestCase() { QVERIFY(m_dir.isValid()); }

    void samples_areThePlainModel();
    void cutSamples_neverGetThrough();
    void mutatedSamples_neverGetThrough();
    void whatIsLeftOut_isTold_data();
    void whatIsLeftOut_isTold();
    void wrongNumberOfTriangles_isTold();
    void off_isReadInAnyLayout();
    void off_faultsAreToldInAnyLayout();
    void binaryOff_keepsColors();
    void strips_faceAsTheirFirstTriangle();
    void largePolygons_areFilled_data();
    void largePolygons_areFilled();
    void polygonsThatTouchThemselves_areFilled_data();
    void polygonsThatTouchThemselves_areFilled();
    void polygonsWithManyHoles_areFilled();
    void polygonsThatCrossThemselves_end();
    void manyCopiesInASmallPackage_areRead();
    void slicersParts_areLeftOutAndTold_data();
    void slicersParts_areLeftOutAndTold();
    void slicersParts_areNamed();
    void slicersNumbers_areOfTheirObject();
    void slicersParts_areCountedWhereTheyAreAll();
    void hiddenObjects_areCounted_data();
    void hiddenObjects_areCounted();
    void threeMfOtherShapes_areCounted();
    void threeMfExtensions_areRefusedByName_data();
    void threeMfExtensions_areRefusedByName();
    void threeMfBeams_areCounted();
    void wrongNumbersOfElements_areTold_data();
    void wrongNumbersOfElements_areTold();
    void faults_areTold_data();
    void faults_areTold();
    void packageFaults_areTold_data();
    void packageFaults_areTold();
    void packageFaults_areOfTheirPart();
    void utf16_isTold_data();
    void utf16_isTold();

private:
    std::filesystem::path file(const std::string& name) const
    {
        return std::filesystem::path(m_dir.path().toStdString()) / name;
    }
    std::vector<Sample> allSamples() const
    {
        std::vector<Sample> all;
        for (const auto& some : {objSamples(), stlSamples(), plySamples(), offSamples(), gltfSamples(),
                                 packageSamples(file("package.3mf"))})
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }
    core::ReadResult read(const std::string& name, std::string_view bytes) const
    {
        std::filesystem::remove(file(name));
        std::ofstream(file(name), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return core::readModel(file(name), {.up = core::UpAxis::Y});
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
};

/// Each sample has the box's points and its volume and is closed. Its faces are the box's, except for the diagonals of
/// strips.
void TestForeignFiles::samples_areThePlainModel()
{
    const TriangleMesh plain = read("plain.obj", objVertices() + objFaces()).mesh;
    QCOMPARE(volumeOf(plain), 6000.0);
    QVERIFY(isClosed(plain));
    for (const Sample& sample : allSamples()) {
        std::optional<TriangleMesh> mesh;
        const auto error = errorOf([&] { mesh = read(sample.name, sample.bytes).mesh; });
        const QByteArray what =
            QByteArray(sample.what) + (error ? ", refused: " + error->token : std::string()).c_str();
        QVERIFY2(mesh, what.constData());
        QVERIFY2(isSound(*mesh) && isClosed(*mesh), what.constData());
        QVERIFY2(std::abs(volumeOf(*mesh) - 6000) < 1e-3, what.constData());
        const bool isStrip = std::string_view(sample.what).find("strip") != std::string_view::npos;
        QVERIFY2(isStrip ? mesh->triangles.size() == 12 : surfaceOf(*mesh) == surfaceOf(plain), what.constData());
    }
}

void TestForeignFiles::cutSamples_neverGetThrough()
{
    const std::size_t step = byEffort(7, 1, 1);
    for (const Sample& sample : allSamples())
        for (std::size_t size = 0; size < sample.bytes.size(); size += step) {
            std::optional<TriangleMesh> mesh;
            const auto error =
                errorOf([&] { mesh = core::parseMesh(sample.name, std::string_view(sample.bytes).substr(0, size)); });
            QVERIFY2(error || isSound(*mesh), sample.what);
        }
}

void TestForeignFiles::mutatedSamples_neverGetThrough()
{
    const int rounds = byEffort(100, 1'000, 50'000);
    const std::vector<std::string> words{"-1",
                                         "0",
                                         "4294967295",
                                         "99999999999",
                                         "1e99",
                                         "nan",
                                         "#",
                                         "\n",
                                         "\r",
                                         "\\\n",
                                         " ",
                                         "3",
                                         "tristrips",
                                         "list",
                                         zero,
                                         "\x1a",
                                         "solid",
                                         "facet",
                                         "\xef\xbb\xbf",
                                         "BINARY",
                                         "\xff\xff\xff\xff",
                                         "endsolid",
                                         "OFF",
                                         "scenes"};
    std::mt19937 engine(seed);
    for (const Sample& sample : allSamples())
        for (int round = 0; round < rounds; ++round) {
            std::string bytes = sample.bytes;
            for (auto edits = 1 + engine() % 3; edits != 0; --edits) {
                const std::size_t at = engine() % bytes.size();
                if (engine() % 2 == 0)
                    bytes[at] = static_cast<char>(engine());
                else
                    bytes.replace(at, engine() % 6, words[engine() % words.size()]);
            }
            std::optional<TriangleMesh> mesh;
            const auto error = errorOf([&] { mesh = core::parseMesh(sample.name, bytes); });
            QVERIFY2(error || isSound(*mesh), qPrintable(QStringLiteral("%1, round %2").arg(sample.what).arg(round)));
        }
}

void TestForeignFiles::whatIsLeftOut_isTold_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<quint64>("repeated");
    QTest::addColumn<quint64>("fewer");
    QTest::addColumn<bool>("unannounced");
    QTest::addColumn<quint64>("behind");
    const auto row = [](const char* what, const char* name, const std::string& bytes, quint64 repeated, quint64 fewer,
                        bool unannounced, quint64 behind) {
        QTest::newRow(what) << QString(name) << QByteArray::fromStdString(bytes) << repeated << fewer << unannounced
                            << behind;
    };
    const std::string v = objVertices(), f = objFaces();
    row("nothing", "a.obj", v + f, 0, 0, false, 0);
    row("comments", "a.obj", objVertices(" # a") + objFaces(" # b"), 0, 0, false, 0);
    row("a corner twice", "a.obj", v + replaced(f, "f 1 3 4 2", "f 1 3 3 4 2"), 1, 0, false, 0);
    row("an outline that is closed", "a.obj", v + replaced(f, "f 1 3 4 2", "f 1 3 4 2 1"), 1, 0, false, 0);
    row("an edge and a point", "a.obj", v + f + "f 1 2\nf 3\n", 0, 2, false, 0);
    row("a triangle of two", "a.obj", v + f + "f 1 2 2\n", 0, 1, false, 0);
    row("more columns", "a.ply", plyFaces("ascii", quads, {.vertexLine = " 1\n"}), 0, 0, true, 0);
    row("sewn strips", "a.ply", sewnStrip("ascii"), 0, 0, false, 0);
    row("a rest", "a.stl", binaryStl(12, std::string(50, '\0')), 0, 0, false, 50);
    row("no rest", "a.stl", binaryStl(11), 0, 0, false, 0);
    row("text", "a.stl", binaryStl(12, "Made by a program of 1999. All rights are reserved"), 0, 0, false, 50);
    row("text in UTF-8", "a.stl", binaryStl(12, "Gemessen mit Prüfgerät Nr. 7, 20 °C, ±0,1 mm, Köln"), 0, 0, false, 55);
    row("text, no count", "a.stl", binaryStl(0, "Made by a program of 1999. All rights are reserved"), 0, 0, false, 50);
    row("a rest, no count", "a.stl", binaryStl(0, std::string(100, '\0')), 0, 0, false, 100);
    row("a rest of OFF", "a.off", BinaryOff().bytes() + "xyz", 0, 0, false, 3);
}

void TestForeignFiles::whatIsLeftOut_isTold()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    const core::ReadRemarks remarks = read(name.toStdString(), bytes.toStdString()).remarks;
    QTEST(quint64(remarks.repeatedCorners), "repeated");
    QTEST(quint64(remarks.facesOfFewer), "fewer");
    QTEST(remarks.unannounced, "unannounced");
    QTEST(quint64(remarks.bytesBehind), "behind");
}

/// The triangles in the file are read, whatever number of them it announces, if they are closed. A wrong number is told
/// with the true one.
void TestForeignFiles::wrongNumberOfTriangles_isTold()
{
    for (const std::uint32_t count : {0U, 1U, 11U, 12U, 13U, 1000U, 0x7fffffffU, 0xffffffffU})
        for (const char* const head : {"box", "solid box"}) {
            const core::ReadRemarks remarks = read("a.stl", binaryStl(count, "", head)).remarks;
            const bool isWrong = count != 12;
            QCOMPARE(remarks.announcedTriangles.has_value(), isWrong);
            QCOMPARE(remarks.announcedTriangles.value_or(12), std::uint64_t(count));
            QCOMPARE(remarks.containedTriangles, std::uint64_t(isWrong ? 12 : 0));
        }
    const auto isCutOff = [](const std::string& bytes, std::uint64_t triangles) {
        const auto error = errorOf([&] { core::parseMesh("a.stl", bytes); });
        return error && error->kind == Kind::CutOff && error->place.number == bytes.size() &&
               error->expected == 84 + triangles * 50 && error->found == bytes.size();
    };
    for (const std::uint32_t count : {13U, 0xffffffffU})
        QVERIFY(isCutOff(binaryStl(count, std::string(20, 'x')), 13)); // cut off within a triangle
    for (std::size_t left = 1; left < 12; ++left)                      // cut off between two
        QVERIFY(isCutOff(binaryStl(12).substr(0, 84 + left * 50), 12));
}

void TestForeignFiles::off_isReadInAnyLayout()
{
    const auto expected = surfaceOf(OffLayout::mesh());
    for (const OffLayout& layout : offLayouts())
        for (const char* const behind : {"", "the end 1 2\n"}) {
            std::optional<TriangleMesh> mesh;
            errorOf([&] { mesh = core::parseMesh("a.off", layout.text() + behind); });
            QVERIFY2(mesh, layout.what().c_str());
            QVERIFY2(surfaceOf(*mesh) == expected, layout.what().c_str());
        }
}

/// The reported error must be the file's own defect, not a consequence of parsing another layout.
void TestForeignFiles::off_faultsAreToldInAnyLayout()
{
    const auto isTold = [](const std::string& bytes, Kind kind, std::string_view token) {
        const auto error = errorOf([&] { core::parseMesh("a.off", bytes); });
        return error && error->kind == kind && error->token == token;
    };
    for (OffLayout layout : offLayouts()) {
        const std::string whole = layout.text();
        QVERIFY2(isTold(whole.substr(0, whole.size() - 30), Kind::CutOff, "faces"), layout.what().c_str());
        layout.badCorner = "99999";
        QVERIFY2(isTold(layout.text(), Kind::IndexOutOfRange, "99999"), layout.what().c_str());
        layout.badCorner.clear();
        layout.badVertex = "abc";
        // in other layouts the word may be an extra one at the end of a line, which is ignored
        if (layout.linesBeginVertices())
            QVERIFY2(isTold(layout.text(), Kind::NotANumber, "abc"), layout.what().c_str());
        layout.badVertex = "1 1"; // lines that begin with a vertex may have extra words at their end
        if (!layout.linesBeginVertices())
            QVERIFY2(errorOf([&] { core::parseMesh("a.off", layout.text()); }), layout.what().c_str());
    }
}

void TestForeignFiles::binaryOff_keepsColors()
{
    for (const int components : {3, 4}) {
        const TriangleMesh mesh =
            read("a.off", BinaryOff{.keyword = "COFF", .components = components, .ofFace = 3}.bytes()).mesh;
        QVERIFY((mesh.colors == std::vector<core::Rgb>(8, core::Rgb{255, 255, 255})));
    }
}

/// Tests that the triangles of a strip around a cylinder face outwards, for any strip length and any restarts.
void TestForeignFiles::strips_faceAsTheirFirstTriangle()
{
    for (const int restartEach : {0, 6, 8}) {
        constexpr int around = 50;
        std::string vertices, entries;
        int count = 0;
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * std::numbers::pi * i / around;
            for (int z = 0; z < 2; ++z)
                vertices += std::to_string(std::cos(angle)) + ' ' + std::to_string(std::sin(angle)) + ' ' +
                            std::to_string(z) + '\n';
        }
        const auto add = [&](int entry) {
            entries += std::to_string(entry) + ' ';
            ++count;
        };
        for (int i = 0, since = 0; i <= around; ++i) {
            const int first = 2 * (i % around);
            add(first + 1);
            add(first);
            since += 2;
            if (restartEach != 0 && since >= restartEach && i < around) {
                add(-1);
                add(first + 1);
                add(first);
                since = 2;
            }
        }
        const TriangleMesh mesh = read("a.ply", "ply\nformat ascii 1.0\nelement vertex " + std::to_string(2 * around) +
                                                    "\nproperty float x\nproperty float y\nproperty float z\n"
                                                    "element tristrips 1\nproperty list int int vertex_indices\n"
                                                    "end_header\n" +
                                                    vertices + std::to_string(count) + ' ' + entries + '\n')
                                      .mesh;
        QCOMPARE(mesh.triangles.size(), std::size_t(2 * around));
        for (const auto& [a, b, c] : mesh.triangles) {
            const Vec3f normal = (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
            QVERIFY(normal.head<2>().dot(mesh.points[a].head<2>()) > 0);
        }
    }
}

void TestForeignFiles::largePolygons_areFilled_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("corners");
    for (const int corners : {1000, 4097, 20'000, 100'000}) {
        QTest::addRow("circle %d", corners) << 0 << corners;
        QTest::addRow("star %d", corners) << 1 << corners;
        QTest::addRow("comb %d", corners) << 2 << corners;
        QTest::addRow("spiral %d", corners) << 3 << corners;
    }
}

/// Checks that the triangles face as the polygon does, and that their areas sum to its area.
void TestForeignFiles::largePolygons_areFilled()
{
    QFETCH(int, kind);
    QFETCH(int, corners);
    std::mt19937 engine(seed);
    std::vector<std::array<double, 2>> ring;
    const auto polar = [&ring](double angle, double r) { ring.push_back({r * std::cos(angle), r * std::sin(angle)}); };
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        const int half = corners / 2, arm = i < half ? i : corners - 1 - i;
        if (kind == 0)
            polar(angle, 1000);
        else if (kind == 1)
            polar(angle, std::uniform_real_distribution(500.0, 1000.0)(engine));
        else if (kind == 2)
            ring.push_back(i == 0             ? std::array{0.0, -1.0}
                           : i == corners - 1 ? std::array{0.0, 1000.0}
                           : i == 1           ? std::array{double(corners), -1.0}
                                              : std::array{double(corners - i), i % 2 == 0 ? 0.0 : 1000.0});
        else
            polar(40.0 * std::numbers::pi * arm / half, (i < half ? 12.0 : 10.0) + 1000.0 * arm / half);
    }
    std::string obj = "# ring\n", face = "f";
    std::vector<Vec3f> points;
    for (int i = 0; i < corners; ++i) {
        const auto& [x, y] = ring[std::size_t(i)];
        points.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0F);
        std::array<char, 64> line;
        obj.append(line.data(), std::size_t(std::snprintf(line.data(), line.size(), "v %.9g %.9g 0\n",
                                                          double(points.back().x()), double(points.back().y()))));
        face += ' ' + std::to_string(i + 1);
    }
    const TriangleMesh mesh = read("a.obj", obj + face + "\n").mesh;
    double expected = 0, sum = 0;
    const auto crossOf = [](const Vec3f& p, const Vec3f& q) {
        return double(p.x()) * double(q.y()) - double(q.x()) * double(p.y());
    };
    for (std::size_t i = 0; i < points.size(); ++i)
        expected += crossOf(points[i], points[(i + 1) % points.size()]) / 2;
    const double sense = expected < 0 ? -1 : 1;
    QCOMPARE(mesh.triangles.size(), points.size() - 2);
    for (const auto& [a, b, c] : mesh.triangles) {
        const double area = (crossOf(mesh.points[a], mesh.points[b]) + crossOf(mesh.points[b], mesh.points[c]) +
                             crossOf(mesh.points[c], mesh.points[a])) /
                            2;
        QVERIFY(sense * area > -1e-6 * std::abs(expected));
        sum += area;
    }
    QVERIFY2(std::abs(sum - expected) < 1e-6 * std::abs(expected),
             qPrintable(QString::number(sum / expected, 'g', 12)));
}

void TestForeignFiles::polygonsThatTouchThemselves_areFilled_data()
{
    QTest::addColumn<Ring>("ring");
    QTest::newRow("a hole joined to a corner")
        << Ring{{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 2}, {2, 2}};
    QTest::newRow("a bridge of several edges")
        << Ring{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {1, 2}, {2, 2}, {4, 4}, {4, 6}, {6, 4}, {4, 4}, {2, 2}, {1, 2}};
    QTest::newRow("a bridge with a corner on one side only")
        << Ring{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {1, 1}, {3, 3}, {4, 6}, {6, 4}, {3, 3}};
    QTest::newRow("a hole that touches a corner")
        << Ring{{0, 0}, {4, 2}, {2, 4}, {0, 0}, {0, 6}, {-6, 6}, {-6, -6}, {6, -6}};
    QTest::newRow("two holes at one corner")
        << Ring{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {1, 4}, {2, 4}, {0, 0}, {4, 2}, {4, 1}};
    QTest::newRow("two pieces") << Ring{{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}};
    QTest::newRow("a hole between two corners") << Ring{{3, 2}, {3, 1}, {2, 1}, {1, 1}, {1, 0}, {4, 0}, {4, 2}, {3, 2},
                                                        {3, 3}, {0, 3}, {0, 1}, {1, 1}, {2, 1}, {3, 1}, {2, 2}};
    QTest::newRow("corners in line") << Ring{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 3},
                                             {2, 3}, {1, 3}, {0, 3}, {0, 2}, {0, 1}};
    QTest::newRow("corners in line on one side") << Ring{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {0, 3}};
    QTest::newRow("doubled corners in line")
        << Ring{{0, 0}, {1, 0}, {1, 0}, {2, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 2}, {0, 1}, {0, 0}};
}

/// Tests polygons that touch themselves at corners and along edges, from each of their corners on, in both directions,
/// and with a vertex for each corner or for each point.
void TestForeignFiles::polygonsThatTouchThemselves_areFilled()
{
    QFETCH(Ring, ring);
    for (std::size_t first = 0; first < ring.size(); ++first)
        for (const bool isBackward : {false, true})
            for (const bool isShared : {false, true}) {
                Ring turned = ring;
                std::ranges::rotate(turned, turned.begin() + static_cast<std::ptrdiff_t>(first));
                if (isBackward)
                    std::ranges::reverse(turned);
                QVERIFY2(fills(read("a.obj", objOf(turned, isShared)).mesh, turned),
                         qPrintable(QStringLiteral("from corner %1").arg(first)));
            }
}

/// Tests plates with rows of holes of random size. Each hole is joined to the one before it, the first one to the
/// outline; some of them touch there.
void TestForeignFiles::polygonsWithManyHoles_areFilled()
{
    std::mt19937 engine(seed);
    constexpr int pitch = 10, side = 60;
    const int rounds = byEffort(20, 200, 2000);
    for (int round = 0; round < rounds; ++round) {
        Ring ring{{0, 0}, {side, 0}, {side, side}, {0, side}};
        for (int y = side - pitch / 2; y > 0; y -= pitch) {
            Ring back;
            ring.push_back({0, y});
            for (int x = pitch / 2; x < side; x += pitch) {
                const auto size = [&] { return std::uniform_int_distribution(1, pitch / 2)(engine); };
                const int left = x - size(), right = std::min(x + size(), side - 1);
                for (const auto& corner :
                     {std::array{left, y}, std::array{x, y + std::min(size(), 4)}, std::array{right, y}})
                    ring.push_back(corner);
                back.push_back({left, y});
                back.push_back({x, y - std::min(size(), 4)});
                if (x + pitch < side)
                    back.push_back({right, y});
            }
            ring.insert(ring.end(), back.rbegin() + (back.size() % 3 == 2 ? 0 : 1), back.rend());
            ring.push_back({0, y});
        }
        QVERIFY2(fills(read("a.obj", objOf(ring, round % 2 == 0)).mesh, ring), qPrintable(QString::number(round)));
    }
}

void TestForeignFiles::polygonsThatCrossThemselves_end()
{
    std::mt19937 engine(seed);
    std::string obj, face = "f";
    constexpr int corners = 6000;
    for (int i = 0; i < corners; ++i) {
        obj += "v " + std::to_string(engine() % 1000) + ' ' + std::to_string(engine() % 1000) + " 0\n";
        face += ' ' + std::to_string(i + 1);
    }
    QVERIFY(isSound(read("a.obj", obj + face + "\n").mesh));
}

/// A package of less than 4 kB that places a box 6000 times is valid.
void TestForeignFiles::manyCopiesInASmallPackage_areRead()
{
    const auto assembly = [](int id, int of, int times) {
        std::string text = "<object id=\"" + std::to_string(id) + "\"><components>";
        for (int i = 0; i < times; ++i)
            text += "<component objectid=\"" + std::to_string(of) + "\" transform=\"1 0 0 0 1 0 0 0 1 " +
                    std::to_string((id == 2 ? 20 : 2000) * i) + " 0 0\"/>";
        return text + "</components></object>";
    };
    std::string model = replaced(modelOf(), "</object>", "</object>" + assembly(2, 1, 80) + assembly(3, 2, 75));
    model = replaced(model, "item objectid=\"1\"", "item objectid=\"3\"");
    const std::string bytes =
        packageOf(file("many.3mf"), {{"_rels/.rels", relationships("/3D/a.model")}, {"3D/a.model", model}});
    QVERIFY(bytes.size() < 4000);
    QCOMPARE(core::readMesh(file("many.3mf")).triangles.size(), std::size_t(72'000));
}

void TestForeignFiles::slicersParts_areLeftOutAndTold_data()
{
    QTest::addColumn<QString>("config");
    QTest::addColumn<bool>("isMatter");
    QTest::addColumn<bool>("isNegative");
    const auto volumes = [](const char* key, const char* value) {
        return QStringLiteral(R"(<config><object id="1"><volume firstid="0" lastid="11"><metadata type="volume" )"
                              R"(key="volume_type" value="ModelPart"/></volume><volume firstid="12" lastid="15">)"
                              R"(<metadata type="object" key="volume_type" value="NegativeVolume"/>)"
                              R"(<metadata type="volume" key="%1" value="%2"/></volume></object></config>)")
            .arg(QLatin1StringView(key), QLatin1StringView(value));
    };
    QTest::newRow("no file") << QString() << true << false;
    QTest::newRow("broken file") << QStringLiteral("<config><object id='1'><volume firstid=") << true << false;
    QTest::newRow("part of the model") << volumes("volume_type", "ModelPart") << true << false;
    QTest::newRow("named like a modifier") << volumes("name", "ParameterModifier") << true << false;
    QTest::newRow("negative") << volumes("volume_type", "NegativeVolume") << false << true;
    for (const char* type : {"ParameterModifier", "SupportBlocker", "SupportEnforcer"})
        QTest::newRow(type) << volumes("volume_type", type) << false << false;
    QTest::newRow("nowhere") << QStringLiteral(R"(<config><object id="1"><volume firstid="16" lastid="99"><metadata )"
                                               R"(type="volume" key="volume_type" value="NegativeVolume"/></volume>)"
                                               R"(</object><object id="7"/></config>)")
                             << true << false;
    QTest::newRow("old modifier") << volumes("modifier", "1") << false << false;
    const QString negative = volumes("volume_type", "NegativeVolume");
    QTest::newRow("a wrong number beside it")
        << QString(negative).replace(QStringLiteral("<object id=\"1\">"),
                                     QStringLiteral("<object id=\"x\"><volume firstid=\"0\" lastid=\"1\"><metadata "
                                                    "type=\"volume\" key=\"modifier\" value=\"1\"/></volume>"
                                                    "</object><object id=\"1\"><volume firstid=\"0\" lastid=\"-5\">"
                                                    "<metadata type=\"volume\" key=\"modifier\" value=\"1\"/>"
                                                    "</volume>"))
        << false << true;
    QTest::newRow("broken behind it") << QString(negative).replace(QStringLiteral("</config>"), QStringLiteral("<"))
                                      << false << true;
    QTest::newRow("with a name space") << QString(negative).replace(QStringLiteral("<config>"),
                                                                    QStringLiteral("<config xmlns=\"http://a.b/c\">"))
                                       << false << true;
}

/// PrusaSlicer identifies parts by ranges of an object's triangles. Here one range is a tetrahedron in the box.
void TestForeignFiles::slicersParts_areLeftOutAndTold()
{
    QFETCH(QString, config);
    QFETCH(bool, isMatter);
    QFETCH(bool, isNegative);
    std::string model = replaced(modelOf(), "</vertices>",
                                 "<vertex x=\"1\" y=\"1\" z=\"1\"/><vertex x=\"2\" y=\"1\" z=\"1\"/>"
                                 "<vertex x=\"1\" y=\"2\" z=\"1\"/><vertex x=\"1\" y=\"1\" z=\"2\"/></vertices>");
    model = replaced(model, "</triangles>",
                     "<triangle v1=\"8\" v2=\"10\" v3=\"9\"/><triangle v1=\"8\" v2=\"9\" v3=\"11\"/>"
                     "<triangle v1=\"9\" v2=\"10\" v3=\"11\"/><triangle v1=\"10\" v2=\"8\" v3=\"11\"/></triangles>");
    Parts parts{{"_rels/.rels", relationships("/3D/a.model")}, {"3D/a.model", model}};
    if (!config.isEmpty())
        parts.emplace_back("Metadata/Slic3r_PE_model.config", config.toStdString());
    packageOf(file("prusa.3mf"), parts);
    const core::ReadResult prusa = core::readModel(file("prusa.3mf"));
    QCOMPARE(prusa.mesh.triangles.size(), std::size_t(isMatter ? 16 : 12));
    // vertices of excluded parts are removed, as they would count in the size of the model
    QCOMPARE(prusa.mesh.points.size(), std::size_t(isMatter ? 12 : 8));
    QCOMPARE(prusa.remarks.negativeParts, std::size_t(isNegative));
    QCOMPARE(prusa.remarks.otherParts, std::size_t(!isMatter && !isNegative));

    // Bambu Studio's parts are objects, usually with another type. Its settings file states their kind.
    for (const std::string type : {"other", "model", ""})
        for (const std::string subtype : {"negative_part", "modifier_part", "support_blocker", "support_enforcer"}) {
            std::string objects = replaced(
                modelOf(), "</object>",
                "</object><object id=\"2\" type=\"" + type +
                    "\"><components><component objectid=\"1\"/></components></object><object id=\"3\">"
                    "<components><component objectid=\"1\"/><component objectid=\"2\"/></components></object>");
            objects = replaced(objects, "item objectid=\"1\"", "item objectid=\"3\"");
            packageOf(file("bambu.3mf"),
                      {{"_rels/.rels", relationships("/3D/a.model")},
                       {"3D/a.model", objects},
                       {"Metadata/model_settings.config",
                        R"(<config><object id="3"><part id="1" subtype="normal_part"/><part id="2" subtype=")" +
                            subtype + R"("/></object></config>)"}});
            const core::ReadResult bambu = core::readModel(file("bambu.3mf"));
            const bool isCut = subtype == "negative_part";
            QCOMPARE(bambu.mesh.triangles.size(), std::size_t(12));
            QCOMPARE(bambu.remarks.negativeParts, std::size_t(isCut));
            QCOMPARE(bambu.remarks.otherParts, std::size_t(!isCut));
        }
}

/// The first three different names of each kind are kept, clean and short.
void TestForeignFiles::slicersParts_areNamed()
{
    const std::vector<std::string> names{" Hole&#10;1 ", "", "Hole 1", std::string(39, 'x') + "\u00fc", "b", "c"};
    const std::vector<std::string> kept{"Hole 1", std::string(39, 'x'), "b"};
    const auto named = [](const std::string& name) {
        return "<metadata type=\"volume\" key=\"name\" value=\"" + name + "\"/>";
    };
    std::string volumes, parts, objects, components, volumesOfAmf;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string id = std::to_string(i + 2);
        volumes += R"(<volume firstid="0" lastid="0"><metadata type="volume" key="volume_type" )"
                   R"(value="NegativeVolume"/>)" +
                   named(names[i]) + "</volume>";
        parts += "<part id=\"" + id + "\" subtype=\"modifier_part\">" + named(names[i]) + "</part>";
        objects += "<object id=\"" + id + "\"><components><component objectid=\"1\"/></components></object>";
        components += "<component objectid=\"" + id + "\"/>";
        volumesOfAmf += "<volume><metadata type=\"slic3r.modifier\">1</metadata><metadata type=\"name\">" + names[i] +
                        "</metadata></volume>";
    }
    packageOf(file("prusa.3mf"),
              {{"_rels/.rels", relationships("/3D/a.model")},
               {"3D/a.model", modelOf()},
               {"Metadata/Slic3r_PE_model.config", "<config><object id=\"1\">" + volumes + "</object></config>"}});
    const core::ReadRemarks prusa = core::readModel(file("prusa.3mf")).remarks;
    QCOMPARE(prusa.negativeParts, names.size());
    QCOMPARE(prusa.negativeNames, kept);

    const std::string assembly =
        "<object id=\"99\"><components><component objectid=\"1\"/>" + components + "</components></object>";
    packageOf(file("bambu.3mf"),
              {{"_rels/.rels", relationships("/3D/a.model")},
               {"3D/a.model", replaced(replaced(modelOf(), "</object>", "</object>" + objects + assembly),
                                       "item objectid=\"1\"", "item objectid=\"99\"")},
               {"Metadata/model_settings.config",
                "<config><object id=\"99\">" + named("all") + parts + named("all") + "</object></config>"}});
    const core::ReadRemarks bambu = core::readModel(file("bambu.3mf")).remarks;
    QCOMPARE(bambu.otherParts, names.size());
    QCOMPARE(bambu.otherNames, kept);

    packageOf(file("support.3mf"),
              {{"_rels/.rels", relationships("/3D/a.model")},
               {"3D/a.model",
                replaced(replaced(modelOf(), "</object>", "</object><object id=\"2\" type=\"support\" name=\"Tree\"/>"),
                         "<item objectid=\"1\"", "<item objectid=\"2\"/><item objectid=\"1\"")}});
    QCOMPARE(core::readModel(file("support.3mf")).remarks.otherNames, std::vector<std::string>{"Tree"});

    const std::string box =
        "<object id=\"1\"><mesh><vertices><vertex><coordinates><x>0</x><y>0</y><z>0</z></coordinates>"
        "</vertex><vertex><coordinates><x>1</x><y>0</y><z>0</z></coordinates></vertex><vertex>"
        "<coordinates><x>0</x><y>1</y><z>0</z></coordinates></vertex></vertices><volume><triangle>"
        "<v1>0</v1><v2>1</v2><v3>2</v3></triangle></volume>";
    const core::ReadRemarks amf = read("a.amf", "<amf>" + box + volumesOfAmf + "</mesh></object></amf>").remarks;
    QCOMPARE(amf.otherParts, names.size());
    QCOMPARE(amf.otherNames, kept);
}

/// Bambu Studio's part numbers are object ids, which are unique only within one model file of the package.
void TestForeignFiles::slicersNumbers_areOfTheirObject()
{
    const std::string space = "<model xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" ";
    const auto partOf = [](const char* type) {
        return replaced(modelOf(), "</object>",
                        std::string("</object><object id=\"2\" type=\"") + type +
                            "\"><components><component objectid=\"1\"/></components></object>");
    };
    const auto built = [](int id, const char* part) {
        const std::string path = std::string("<component p:path=\"/3D/") + part + ".model\" objectid=";
        return "<object id=\"" + std::to_string(id) + "\"><components>" + path + "\"1\"/>" + path +
               "\"2\"/></components></object>";
    };
    std::string root =
        replaced(replaced(modelOf(), "<model ", space), "</object>", "</object>" + built(8, "b") + built(9, "c"));
    root = replaced(root, "<item objectid=\"1\"", "<item objectid=\"9\"/><item objectid=\"8\"");
    packageOf(file("two.3mf"), {{"_rels/.rels", relationships("/3D/a.model")},
                                {"3D/a.model", root},
                                {"3D/b.model", partOf("other")},
                                {"3D/c.model", partOf("other")},
                                {"Metadata/model_settings.config",
                                 R"(<config xmlns="http://a.b"><object id="8"><part id="2" subtype="negative_part"/>)"
                                 R"(<part id="z" subtype="negative_part"/></object><object id="9"><part id="2" )"
                                 R"(subtype="modifier_part"/></object></config>)"}});
    const core::ReadResult read = core::readModel(file("two.3mf"));
    QCOMPARE(read.mesh.triangles.size(), std::size_t(24));
    QCOMPARE(read.remarks.negativeParts, std::size_t(1));
    QCOMPARE(read.remarks.otherParts, std::size_t(1));
}

/// A model that consists only of parts that a slicer excludes or subtracts is refused with the number of these parts.
void TestForeignFiles::slicersParts_areCountedWhereTheyAreAll()
{
    packageOf(file("all.3mf"), {{"_rels/.rels", relationships("/3D/a.model")},
                                {"3D/a.model", replaced(modelOf(), "<object ", "<object type=\"support\" ")}});
    std::ofstream(file("all.amf")) << "<amf><object><mesh><vertices/><volume><metadata type=\"slic3r.modifier\">1"
                                      "</metadata></volume><volume><metadata type=\"slic3r.volume_type\">"
                                      "NegativeVolume</metadata></volume></mesh></object></amf>";
    for (const auto& [name, count] : {std::pair{"all.3mf", 1U}, {"all.amf", 2U}}) {
        const auto error = errorOf([&, path = file(name)] { core::readModel(path); });
        QVERIFY(error && error->kind == Kind::NoFaces);
        QCOMPARE(error->expected, std::uint64_t(count));
    }
}

void TestForeignFiles::hiddenObjects_areCounted_data()
{
    QTest::addColumn<std::string>("name");
    QTest::addColumn<std::string>("bytes");
    QTest::addColumn<quint64>("hidden");
    const std::string scene = R"("scenes":[{"nodes":[0]}],)";
    const auto glb = [&scene](const char* what, const std::string& nodes, quint64 hidden) {
        QTest::addRow("glb %s", what) << std::string("a.glb") << glbBox(scene, "\"nodes\":[" + nodes + "],") << hidden;
    };
    glb("all shown", R"({"mesh":0})", 0);
    glb("beside the scene", R"({"mesh":0},{"mesh":0},{"children":[3]},{"mesh":0},{"name":"camera"})", 2);
    glb("not visible",
        R"({"mesh":0,"children":[1]},{"extensions":{"KHR_node_visibility":{"visible":false}},)"
        R"("children":[2]},{"mesh":0})",
        1);
    glb("level of detail", R"({"mesh":0,"extensions":{"MSFT_lod":{"ids":[1]}}},{"mesh":0})", 0);
    const std::string room = "a mesh needs room ", two = R"("indices":1}]},{"primitives":[]}])"; // of equal length
    const std::string padded = glbBox(scene, R"("nodes":[{"mesh":0}],)", R"("extras":")" + room + "\",");
    QTest::newRow("glb mesh without node")
        << std::string("a.glb") << replaced(replaced(padded, room, ""), R"("indices":1}]}])", two) << quint64(1);
    const auto threeMf = [this](const char* what, const std::string& model, quint64 hidden) {
        QTest::addRow("3mf %s", what) << std::string("a.3mf")
                                      << packageOf(file("hidden.3mf"), {{"_rels/.rels", relationships("/3D/a.model")},
                                                                        {"3D/a.model", model}})
                                      << hidden;
    };
    const std::string mesh = "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
                             "<vertex x=\"0\" y=\"1\" z=\"0\"/></vertices><triangles><triangle v1=\"0\" v2=\"1\" "
                             "v3=\"2\"/></triangles></mesh></object>";
    threeMf("all built", modelOf(), 0);
    threeMf("not built", replaced(modelOf(), "</object>", "</object><object id=\"2\">" + mesh), 1);
    threeMf("a support not built",
            replaced(modelOf(), "</object>", "</object><object type=\"support\" id=\"2\">" + mesh), 0);
}

/// Objects that are hidden, in no scene, or not in the build are counted.
void TestForeignFiles::hiddenObjects_areCounted()
{
    QFETCH(std::string, name);
    QFETCH(std::string, bytes);
    QFETCH(quint64, hidden);
    const core::ReadResult result = read(name, bytes);
    QCOMPARE(result.remarks.hiddenObjects, hidden);
    QCOMPARE(result.mesh.triangles.size(), std::size_t(12));
}

/// Objects whose shape an extension defines are counted as unread. If there is nothing else, the error names the
/// extension.
void TestForeignFiles::threeMfOtherShapes_areCounted()
{
    const std::string space = "<model xmlns:b=\"http://schemas.3mf.io/3dmanufacturing/booleanoperations/2023/07\" ";
    const std::string boolean = "</object><object id=\"2\"><b:booleanshape objectid=\"1\"><b:boolean objectid=\"1\"/>"
                                "</b:booleanshape></object>";
    const std::string unbuilt = replaced(replaced(modelOf(), "<model ", space), "</object>", boolean);
    const auto write = [this](const std::string& model) {
        packageOf(file("boolean.3mf"), {{"_rels/.rels", relationships("/3D/a.model")}, {"3D/a.model", model}});
        return file("boolean.3mf");
    };
    QCOMPARE(core::readModel(write(unbuilt)).remarks.unreadNodes, std::size_t(0));
    const std::string both = replaced(unbuilt, "<item objectid=\"1\"", "<item objectid=\"2\"/><item objectid=\"1\"");
    QCOMPARE(core::readModel(write(both)).remarks.unreadNodes, std::size_t(1));
    const auto path = write(replaced(unbuilt, "<item objectid=\"1\"", "<item objectid=\"2\""));
    const auto error = errorOf([&] { core::readModel(path); });
    QVERIFY(error && error->fault == FileFault::NeedsExtension);
    QCOMPARE(error->token, std::string("booleanoperations/2023/07"));
}

/// A required extension that changes shapes is refused by name. Extensions that change no shape may be required.
void TestForeignFiles::threeMfExtensions_areRefusedByName_data()
{
    QTest::addColumn<QString>("space");
    QTest::addColumn<QString>("token"); // name of the refused extension; empty: the file is read
    const QString microsoft = QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/");
    for (const char* known : {"material/2015/02", "production/2015/06", "slice/2015/07", "core/2015/02"})
        QTest::newRow(known) << microsoft + QLatin1StringView(known) << QString();
    for (const char* slicers : {"http://schemas.slic3r.org/3mf/2017/06", "http://schemas.bambulab.com/package/2021"})
        QTest::newRow(slicers) << QString::fromLatin1(slicers) << QString();
    for (const char* other : {"beamlattice/2017/02", "securecontent/2019/04"})
        QTest::newRow(other) << microsoft + QLatin1StringView(other) << QString::fromLatin1(other);
    QTest::newRow("volumetric") << "http://schemas.3mf.io/3dmanufacturing/volumetric/2022/01"
                                << "volumetric/2022/01";
    QTest::newRow("a stranger's") << "http://example.com/3mf"
                                  << "example.com/3mf";
}

void TestForeignFiles::threeMfExtensions_areRefusedByName()
{
    QFETCH(QString, space);
    QFETCH(QString, token);
    const auto with = [&](const char* required) {
        const std::string model =
            replaced(modelOf(), "<model ", "<model xmlns:e=\"" + space.toStdString() + "\" " + required + " ");
        packageOf(file("required.3mf"), {{"_rels/.rels", relationships("/3D/a.model")}, {"3D/a.model", model}});
        return errorOf([this] { core::readModel(file("required.3mf")); });
    };
    QVERIFY(!with(""));
    const auto error = with("requiredextensions=\"e\"");
    QCOMPARE(error.has_value(), !token.isEmpty());
    if (error) {
        QCOMPARE(error->fault, FileFault::NeedsExtension);
        QCOMPARE(QString::fromStdString(error->token), token);
        QVERIFY(error->place.number > 0);
    }
    const auto undeclared = with("requiredextensions=\" e  nothing \"");
    QVERIFY(undeclared && undeclared->token == (token.isEmpty() ? "nothing" : token.toStdString()));
    const auto byUri = with(qPrintable(QStringLiteral("requiredextensions=\"%1\"").arg(space)));
    QCOMPARE(byUri ? QString::fromStdString(byUri->token) : QString(), token);
}

void TestForeignFiles::threeMfBeams_areCounted()
{
    const std::string space = "<model xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\" ";
    const std::string beams = "<b:beamlattice radius=\"1\"><b:beams><b:beam v1=\"0\" v2=\"1\"/><b:beam v1=\"1\" "
                              "v2=\"2\"/></b:beams></b:beamlattice></mesh>";
    const std::string model = replaced(replaced(modelOf(), "<model ", space), "</mesh>", beams);
    packageOf(file("beams.3mf"), {{"_rels/.rels", relationships("/3D/a.model")}, {"3D/a.model", model}});
    QCOMPARE(core::readModel(file("beams.3mf")).remarks.beams, std::size_t(2));
    const std::size_t first = model.find("<triangles>"), last = model.find("</triangles>");
    const std::string bare = model.substr(0, first) + model.substr(last + 12);
    packageOf(file("beams.3mf"), {{"_rels/.rels", relationships("/3D/a.model")}, {"3D/a.model", bare}});
    const auto error = errorOf([this] { core::readModel(file("beams.3mf")); });
    QVERIFY(error && error->fault == FileFault::NeedsExtension && error->token == "beamlattice");
}

void TestForeignFiles::wrongNumbersOfElements_areTold_data()
{
    QTest::addColumn<std::string>("name");
    QTest::addColumn<std::string>("bytes");
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<std::string>("elements");
    QTest::addColumn<quint64>("announced");
    QTest::addColumn<quint64>("found");
    const auto rows = [](const std::string& name, const auto& bytesOf) {
        const auto row = [&](const char* what, quint64 vertices, quint64 faces, Kind kind, const char* elements,
                             quint64 announced, quint64 found) {
            QTest::addRow("%s, %s", name.c_str(), what) << name.substr(0, name.find(' ')) << bytesOf(vertices, faces)
                                                        << kind << std::string(elements) << announced << found;
        };
        row("a face too many", 8, 7, Kind::CutOff, "faces", 7, 6);
        row("double the faces", 8, 12, Kind::CutOff, "faces", 12, 6);
        row("many faces", 8, 200'000'000, Kind::CutOff, "faces", 200'000'000, 6);
        row("a face too few", 8, 5, Kind::CountMismatch, "faces", 5, 6);
        row("half the faces", 8, 3, Kind::CountMismatch, "faces", 3, 6);
        if (name != "a.off binary, little-endian") // its byte order is guessed from such numbers
            row("many vertices", 100'000'000, 6, Kind::CutOff, "vertices", 100'000'000, 0);
    };
    for (const char* const format : {"ascii", "binary_little_endian", "binary_big_endian"})
        rows("a.ply " + std::string(format), [format](quint64 vertices, quint64 faces) {
            const std::string bytes = plyFaces(format, quads);
            return replaced(replaced(bytes, "vertex 8\n", "vertex " + std::to_string(vertices) + "\n"), "face 6\n",
                            "face " + std::to_string(faces) + "\n");
        });
    for (const char* const faceEnd : {"\n", " "})
        rows("a.off " + std::string(*faceEnd == ' ' ? "on one line" : "on lines"),
             [faceEnd](quint64 vertices, quint64 faces) {
                 return offOf("OFF\n", std::to_string(vertices) + " " + std::to_string(faces) + " 0\n", "\n", faceEnd,
                              faceEnd);
             });
    for (const std::endian order : {std::endian::big, std::endian::little})
        rows(order == std::endian::big ? "a.off binary, big-endian" : "a.off binary, little-endian",
             [order](quint64 vertices, quint64 faces) {
                 return BinaryOff{.order = order}.bytes(std::uint32_t(vertices), std::uint32_t(faces));
             });
}

/// A header that announces more or fewer elements than the file has is told with both numbers.
void TestForeignFiles::wrongNumbersOfElements_areTold()
{
    QFETCH(std::string, name);
    QFETCH(std::string, bytes);
    QFETCH(Kind, kind);
    QFETCH(std::string, elements);
    QFETCH(quint64, announced);
    QFETCH(quint64, found);
    const auto error = errorOf([&] { core::parseMesh(name, bytes); });
    QVERIFY(error);
    QCOMPARE(error->kind, kind);
    QCOMPARE(error->token, elements);
    QCOMPARE(error->expected, announced);
    if (found > 0)
        QCOMPARE(error->found, found);
    QVERIFY(error->place.number > 0);
}

void TestForeignFiles::faults_areTold_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<FileFault>("fault");
    QTest::addColumn<QString>("place");
    QTest::addColumn<QString>("token");
    QTest::addColumn<QString>("wanted");
    const auto row = [](const char* what, const char* name, const std::string& bytes, Kind kind, FileFault fault,
                        const char* place, const char* token = "", const char* wanted = "") {
        QTest::newRow(what) << QString(name) << QByteArray::fromStdString(bytes) << kind << fault << QString(place)
                            << QString(token) << QString(wanted);
    };
    const std::string v = objVertices(), f = objFaces();
    row("obj vertex of two", "a.obj", "v 1 2 # 3\n" + v + f, Kind::Malformed, FileFault::VertexNumbers, "line 1");
    row("obj corner without vertex", "a.obj", v + "f 1 /2 3\n" + f, Kind::Malformed, FileFault::VertexIndex, "line 9",
        "/2");
    row("stl other word", "a.stl", replaced(TextStl().text(), "endloop", "endlop"), Kind::Malformed, FileFault::Keyword,
        "line 7", "endlop", "endloop");
    row("stl of four numbers", "a.stl", replaced(TextStl().text(), "vertex 0 20 0", "vertex 0 2 0 0"), Kind::Malformed,
        FileFault::Keyword, "line 5", "0", "vertex");
    row("stl facets outside", "a.stl", TextStl().text() + TextStl{.head = "", .tail = ""}.text(), Kind::Malformed,
        FileFault::Keyword, "line 87", "facet", "solid");
    row("stl quads", "a.stl", replaced(TextStl().text(), "  endloop", "   vertex 1 1 1\n  endloop"), Kind::Malformed,
        FileFault::Keyword, "line 7", "vertex", "endloop");
    row("off other keyword", "a.off", "4OFF\n3\n", Kind::Malformed, FileFault::Keyword, "line 1", "4OFF", "OFF");
    row("off of four dimensions", "a.off", "nOFF\n4\n8 6 0\n", Kind::Malformed, FileFault::Keyword, "line 1", "nOFF",
        "OFF");
    row("off words on a line that are too few", "a.off", offOf("OFF ", "8 7 0 ", " ", " ", " "), Kind::CutOff,
        FileFault::None, "line 1", "faces");
    row("off words on a line that are too many", "a.off", offOf("OFF ", "8 5 0 ", " ", " ", " "), Kind::CountMismatch,
        FileFault::None, "line 1", "faces");
    row("off count below none", "a.off", "OFF\n-8 6 0\n", Kind::Malformed, FileFault::Count, "line 2", "-8");
    row("off vertices that lie", "a.off", offOf("OFF\n", "9 6 0\n", "\n", " ", "\n"), Kind::CutOff, FileFault::None,
        "line 17", "faces");
    row("binary off cut off", "a.off", BinaryOff().bytes().substr(0, 150), Kind::CutOff, FileFault::None, "byte 150",
        "faces");
    row("binary off vertices that lie", "a.off", BinaryOff().bytes(0x7fff), Kind::CutOff, FileFault::None, "end",
        "vertices");
    row("binary off with an index too large", "a.off",
        replaced(BinaryOff().bytes(), binary(7, std::endian::big), binary(9, std::endian::big)), Kind::IndexOutOfRange,
        FileFault::None, "byte 155", "9");
    row("ply without format", "a.ply", "ply\nelement vertex 1\nend_header\n0\n", Kind::Malformed, FileFault::Keyword,
        "line 3", "", "format");
    row("ply of unknown encoding", "a.ply", "ply\nformat utf8 1.0\nend_header\n", Kind::Malformed,
        FileFault::PlyEncoding, "line 2", "utf8");
    row("ply element twice", "a.ply", "ply\nformat ascii 1.0\nelement face 1\nelement face 1\n", Kind::Malformed,
        FileFault::Repeated, "line 4", "face");
    row("ply property of nothing", "a.ply", "ply\nformat ascii 1.0\nproperty float x\n", Kind::Malformed,
        FileFault::ElementFirst, "line 3", "property");
    row("ply list of float count", "a.ply", "ply\nformat ascii 1.0\nelement face 1\nproperty list float int a\n",
        Kind::Malformed, FileFault::WholeNumberType, "line 4", "list");
    row("ply strip beyond the points", "a.ply", replaced(strips("ascii"), " 7 ", " 8 "), Kind::IndexOutOfRange,
        FileFault::None, "line 18", "8");
    row("ply strip of another negative number", "a.ply", replaced(strips("ascii"), "-1", "-2"), Kind::IndexOutOfRange,
        FileFault::None, "line 18", "-2");
    row("ply strips that lie", "a.ply", replaced(strips("ascii"), "\n30 ", "\n31 "), Kind::CutOff, FileFault::None,
        "line 19");
    row("ply strips below none", "a.ply", replaced(strips("ascii"), "\n30 ", "\n-30 "), Kind::Malformed,
        FileFault::Count, "line 18", "-30");
    row("glb of an extension with shape", "a.glb", glbBox("", "", R"("extensionsRequired":["MPEG_mesh_linking"],)"),
        Kind::Malformed, FileFault::NeedsExtension, "", "MPEG_mesh_linking");
    row("glb of an extension unknown", "a.glb", glbBox("", "", R"("extensionsRequired":["ACME_shapes"],)"),
        Kind::Malformed, FileFault::NeedsExtension, "", "ACME_shapes");
    row("glb of a scene that is not there", "a.glb", glbBox(R"("scene":3,"scenes":[{}],)"), Kind::Malformed,
        FileFault::Missing, "", "scenes/3");
    row("glb of version 1", "a.glb", glbBox("", "", R"("asset":{"version":"1.0"},)"), Kind::Malformed,
        FileFault::OldGltf, "", "1.0");
    for (const char* const version : {"3.0", "10.1"})
        row("glb of a later version", "a.glb",
            glbBox("", "", R"("asset":{"version":")" + std::string(version) + "\"},"), Kind::Malformed,
            FileFault::OldGltf, "", version);
    for (const char* const version : {"2.1", "3.0"})
        row("glb that needs a later version", "a.glb",
            glbBox("", "", R"("asset":{"version":"3.1","minVersion":")" + std::string(version) + "\"},"),
            Kind::Malformed, FileFault::OldGltf, "", version);
    row("glb of version 1 that does not say so", "a.glb", glbOf(R"({"meshes":{},"buffers":{}})", "", true),
        Kind::Malformed, FileFault::OldGltf, "", "1.0");
    row("glb without points", "a.glb", replaced(glbBox(), "\"count\":8", "\"count\":9"), Kind::Malformed,
        FileFault::BeyondItsData, "", "bufferViews/0");
    row("glb without anything", "a.glb", glbOf("{}", "", true), Kind::NoFaces, FileFault::None, "");
    row("glb nodes of themselves", "a.glb", glbBox("", R"("nodes":[{"children":[0],"mesh":0}],"x":0,)"), Kind::NoFaces,
        FileFault::None, "");
}

void TestForeignFiles::faults_areTold()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(Kind, kind);
    QFETCH(QString, place);
    const auto error = errorOf([&] { read(name.toStdString(), bytes.toStdString()); });
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->kind), static_cast<int>(kind));
    QTEST(error->fault, "fault");
    QTEST(QString::fromStdString(error->token), "token");
    QTEST(QString::fromStdString(error->wanted), "wanted");
    if (place == "end")
        place = QStringLiteral("byte %1").arg(bytes.size());
    const QString unit = error->place.unit == FilePlace::Unit::Line ? QStringLiteral("line ") : QStringLiteral("byte ");
    QCOMPARE(error->place.unit == FilePlace::Unit::None ? QString() : unit + QString::number(error->place.number),
             place);
}

void TestForeignFiles::packageFaults_areTold_data()
{
    QTest::addColumn<QString>("target");
    QTest::addColumn<QByteArray>("model");
    QTest::addColumn<int>("packing");
    QTest::addColumn<FileFault>("fault");
    QTest::addColumn<QString>("token");
    const auto row = [](const char* what, FileFault fault, const char* token, const std::string& model,
                        const char* target = "/3D/a.model", int packing = ZIP_CM_DEFLATE) {
        QTest::newRow(what) << QString(target) << QByteArray::fromStdString(model) << packing << fault
                            << QString(token);
    };
    row("part that is not there", FileFault::NotInPackage, "3D/b.model", modelOf(), "/3D/b.model");
    row("out of the package", FileFault::OutsidePackage, "/../a.model", modelOf(), "/../a.model");
    row("out of the package by backslashes", FileFault::OutsidePackage, "..\\a.model", modelOf(), "..\\a.model");
    row("unit", FileFault::LengthUnit, "mile", replaced(modelOf(), "><resources>", " unit=\"mile\"><resources>"));
    row("no third corner", FileFault::Missing, "v3", replaced(modelOf(), "v3", "v4"));
    row("no such object", FileFault::Missing, "objectid 2", replaced(modelOf(), "objectid=\"1\"", "objectid=\"2\""));
    row("document type", FileFault::XmlDocumentType, "", "<!DOCTYPE model>" + modelOf());
    row("attribute twice", FileFault::XmlSyntax, "duplicate attribute",
        replaced(modelOf(), "<item ", "<item objectid=\"1\" "));
    row("not closed", FileFault::XmlSyntax, "mismatched tag", replaced(modelOf(), "</build>", ""));
    if (zip_compression_method_supported(ZIP_CM_BZIP2, 1) != 0)
        row("packed otherwise", FileFault::PackedOtherwise, "_rels/.rels", modelOf(), "/3D/a.model", ZIP_CM_BZIP2);
}

void TestForeignFiles::packageFaults_areTold()
{
    QFETCH(QString, target);
    QFETCH(QByteArray, model);
    QFETCH(int, packing);
    const auto path = file("faulty.3mf");
    packageOf(path, {{"_rels/.rels", relationships(target.toStdString())}, {"3D/a.model", model.toStdString()}},
              packing);
    const auto error = errorOf([&] { core::readMesh(path); });
    QVERIFY(error);
    QCOMPARE(static_cast<int>(error->kind), static_cast<int>(Kind::Malformed));
    QTEST(error->fault, "fault");
    QTEST(QString::fromStdString(error->token), "token");
}

void TestForeignFiles::packageFaults_areOfTheirPart()
{
    const std::string root =
        replaced(replaced(modelOf(), "<model ",
                          "<model xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "),
                 "<item ", "<item p:path=\"/3D/b.model\" ");
    const std::string whole = modelOf(), broken = replaced(modelOf(), "v3", "v4");
    const auto faulty = [&](const std::string& a, const std::string& b) {
        packageOf(file("parts.3mf"),
                  {{"_rels/.rels", relationships("/3D/a.model")}, {"3D/a.model", a}, {"3D/b.model", b}});
        const auto error = errorOf([this] { core::readMesh(file("parts.3mf")); });
        return error ? error->path : std::filesystem::path();
    };
    QCOMPARE(faulty(root, whole), std::filesystem::path());
    QCOMPARE(faulty(root, broken), file("parts.3mf") / "3D/b.model");
    QCOMPARE(faulty(replaced(root, "v3", "v4"), whole), file("parts.3mf"));
}

void TestForeignFiles::utf16_isTold_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("obj") << "a.obj" << QByteArray::fromStdString(objVertices() + objFaces());
    QTest::newRow("stl") << "a.stl" << QByteArray::fromStdString(TextStl().text());
    QTest::newRow("ply") << "a.ply" << QByteArray::fromStdString(plyFaces("ascii", quads));
    QTest::newRow("off") << "a.off" << QByteArray::fromStdString(offOf("OFF\n", "8 6 0\n", "\n", " ", "\n"));
    QTest::newRow("gltf") << "a.gltf" << QByteArray(R"({"asset":{"version":"2.0"},"nodes":[]})");
    QTest::newRow("amf") << "a.amf" << QByteArray("<?xml version=\"1.0\"?><amf><object id=\"1\"/></amf>");
}

void TestForeignFiles::utf16_isTold()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, text);
    for (const std::endian order : {std::endian::little, std::endian::big})
        for (const bool isMarked : {true, false}) {
            const auto error = errorOf([&] { read(name.toStdString(), utf16(text.toStdString(), order, isMarked)); });
            QVERIFY(error);
            QCOMPARE(static_cast<int>(error->kind), static_cast<int>(Kind::Utf16));
        }
}

FETTLE_TEST(TestForeignFiles)
#include "tst_foreign_files.moc"
