#pragma once

#include "core/io/mesh/amf_colors.h"
#include "core/io/mesh/xml_reader.h"

#include <Eigen/Core>

#include <array>
#include <set>

namespace core::io
{
/// An object or a constellation with its placement.
struct AmfInstance
{
    std::string object; ///< id of the object or, if no object has it, of the constellation
    std::uint64_t line = 0;
    Eigen::Vector3d move = Eigen::Vector3d::Zero(); ///< translation in the document's unit
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();
    Eigen::Vector3d scale = Eigen::Vector3d::Ones(); ///< an extension of slicers; negative values mirror
};

/// An AMF object, which has a mesh, or a constellation, which has instances.
struct AmfNode
{
    std::string id; ///< empty: no instance can refer to it; slicers give a constellation that of an object
    bool isConstellation = false;
    std::string name;    ///< as in the file; empty: none
    TriangleMesh mesh;   ///< mesh in the document's unit; indices are in range
    bool isWhole = true; ///< false: a volume was left out
    std::vector<AmfInstance> instances;
    AmfColors colors;
};

/// The content of an AMF's XML.
struct AmfDocument
{
    double millimetres = 1; ///< length of the document's unit in mm
    bool isInRadians = false;
    std::vector<AmfNode> nodes;
    AmfColors::Materials materials;
    ReadRemarks remarks{.objects = 0};
};

/// Parses the XML of an AMF, which is passed piece by piece. Elements may be in the namespace of the first element, or
/// in none. Ignores edges and normals that curve triangles, composite materials and textures, but records them in the
/// remarks. Leaves out volumes that a slicer does not print. Throws FileError with lines of the XML.
class AmfDocumentReader
{
public:
    explicit AmfDocumentReader(const FileBytes& file);

    void take(std::string_view piece) { m_xml.take(piece); }
    AmfDocument document() { return std::move(m_document); }

private:
    enum class Element : std::uint8_t;
    struct Rule;
    enum class Matter { Model, Negative, Other };

    Element elementOf(std::string_view name);
    void begin(Element element, const XmlAttributes& attributes);
    void beginNode(bool isConstellation, const XmlAttributes& attributes);
    void beginInstance(const XmlAttributes& attributes);
    void end();
    void takeNumber(Element element);
    void takeColor();
    void takeMetadata();
    void addVertex();
    void addTriangle();
    void endVolume();
    void endMesh();

    const FileBytes& m_file;
    StopCheck m_stopCheck;
    AmfDocument m_document;
    std::set<std::string, std::less<>> m_objectIds, m_constellationIds;
    std::size_t m_instances = 0;
    std::string m_prefix; ///< prefix of element names: a namespace and a bar, or empty
    std::vector<Element> m_open;
    std::string m_text; ///< text of the innermost element, if it is needed
    std::string m_key;  ///< type of the open metadata element
    std::string m_material;

    std::array<std::optional<float>, 3> m_point;
    std::array<std::optional<std::uint32_t>, 3> m_corners;
    std::array<std::optional<double>, 3> m_color; ///< red, green and blue from 0 to 1
    std::size_t m_firstVertex = 0;                ///< index of the mesh's first vertex among the object's vertices
    struct
    {
        std::uint32_t corner = 0;
        std::uint64_t line = 0;
    } m_farthest; ///< the highest vertex number in the mesh's triangles, and its line
    struct
    {
        std::size_t firstTriangle = 0;
        std::string material;
        std::optional<Rgb> color;
        Matter matter = Matter::Model;
        std::string name;
    } m_volume;
    XmlReader m_xml; ///< declared last, because its callbacks use the other members
};
} // namespace core::io
