// Sources: the code of PrusaSlicer (Metadata/Slic3r_PE_model.config) and of Bambu Studio (model_settings.config).
#include "core/io/mesh/threemf_slicer_parts.h"

#include "core/io/mesh/xml_reader.h"

namespace core::io
{
namespace
{
/// Returns the name without its namespace. The files normally have no namespace, but some programs add one.
std::string_view withoutSpace(std::string_view name)
{
    return name.substr(name.rfind('|') + 1);
}

/// Returns the attribute's whole number; nothing if there is none or it is not valid.
std::optional<std::uint32_t> numberIn(const XmlAttributes& attributes, std::string_view name)
{
    try {
        return attributes.wholeIfAny(name);
    } catch (const FileError&) {
        return std::nullopt; // an invalid number must not discard the valid ones
    }
}

/// Reads the volumes in PrusaSlicer's file: elements `volume` with a range of triangles, which contain metadata.
class VolumeReader
{
public:
    explicit VolumeReader(ThreeMfSlicerParts& parts) : m_parts(parts) {}

    void begin(std::string_view name, const XmlAttributes& attributes)
    {
        if (name == "object") {
            m_object = numberIn(attributes, "id");
        } else if (name == "volume") {
            m_first = numberIn(attributes, "firstid");
            m_last = numberIn(attributes, "lastid");
            m_isMatter = true;
            m_part = {};
        } else if (name == "metadata" && attributes.text("type") == "volume") {
            const std::string_view key = attributes.text("key"), value = attributes.text("value");
            if (key == "volume_type" && value != "ModelPart") {
                m_isMatter = false;
                m_part.isNegative = value == "NegativeVolume";
            } else if (key == "name") {
                m_part.name = value;
            } else if (key == "modifier" && value == "1") { // before PrusaSlicer 1.42
                m_isMatter = false;
            }
        }
    }
    void end(std::string_view name)
    {
        if (name == "volume" && !m_isMatter && m_object && m_first && m_last)
            m_parts.triangles[*m_object].push_back({*m_first, *m_last, m_part});
    }

private:
    ThreeMfSlicerParts& m_parts;
    std::optional<std::uint32_t> m_object, m_first, m_last;
    bool m_isMatter = true;
    ThreeMfSlicerParts::Part m_part;
};

/// Reads the parts in Bambu Studio's file that are not solid: elements `part` in an `object`. As in that program only
/// `subtype` matters, whatever the object's type in the model is; a part with an unknown subtype is solid.
class PartReader
{
public:
    explicit PartReader(ThreeMfSlicerParts& parts) : m_parts(parts) {}

    void begin(std::string_view name, const XmlAttributes& attributes)
    {
        if (name == "object")
            m_object = numberIn(attributes, "id");
        else if (name == "part")
            beginPart(attributes);
        else if (name == "metadata" && m_part && attributes.text("key") == "name")
            m_part->name = attributes.text("value");
    }
    void end(std::string_view name)
    {
        if (name == "part")
            m_part = nullptr;
    }

private:
    void beginPart(const XmlAttributes& attributes)
    {
        m_part = nullptr;
        const std::string_view type = attributes.text("subtype");
        const bool isNegative = type == "negative_part";
        if (!isNegative && type != "modifier_part" && type != "support_blocker" && type != "support_enforcer")
            return;
        if (const auto part = numberIn(attributes, "id"); part && m_object) {
            m_part = &m_parts.objects[{*m_object, *part}];
            *m_part = {isNegative, {}};
        }
    }

    ThreeMfSlicerParts& m_parts;
    std::optional<std::uint32_t> m_object;
    ThreeMfSlicerParts::Part* m_part = nullptr; ///< the part that is being read, if it is not solid
};

/// Reads a part, if it exists, up to the first error.
template <class Reader> void readPart(const FileBytes& file, ZipReader& package, const std::string& name, Reader reader)
{
    const std::optional<std::string> part = package.find(name);
    if (!part)
        return;
    XmlReader xml(
        file,
        [&reader](std::string_view element, const XmlAttributes& attributes) {
            reader.begin(withoutSpace(element), attributes);
        },
        [&reader](std::string_view element) { reader.end(withoutSpace(element)); });
    try {
        package.read(*part, [&xml](std::string_view piece) { xml.take(piece); });
    } catch (const FileError&) { // the file is optional
    }
}
} // namespace

ThreeMfSlicerParts ThreeMfSlicerParts::in(const FileBytes& file, ZipReader& package)
{
    ThreeMfSlicerParts parts;
    readPart(file, package, "Metadata/Slic3r_PE_model.config", VolumeReader(parts));
    readPart(file, package, "Metadata/model_settings.config", PartReader(parts));
    return parts;
}
} // namespace core::io
