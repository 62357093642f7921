// Source: the code of PrusaSlicer (Metadata/Slic3r_PE_model.config) and of Bambu Studio (model_settings.config).
#include "core/io/mesh/threemf_slicer_parts.h"

#include "core/io/mesh/xml_reader.h"

namespace core::io
{
namespace
{
/// Returns the name without a namespace: the files have none, but some programs give them one.
std::string_view withoutSpace(std::string_view name)
{
    return name.substr(name.rfind('|') + 1);
}

/// Returns a whole number; nothing if there is none.
std::optional<std::uint32_t> numberIn(const XmlAttributes& attributes, std::string_view name)
{
    try {
        return attributes.wholeIfAny(name);
    } catch (const FileError&) {
        return std::nullopt; // one that is wrong leaves the others right
    }
}

/// Gathers the volumes of PrusaSlicer's file: an element `volume` with the numbers of its triangles, in it metadata.
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
            m_isNegative = false;
        } else if (name == "metadata" && attributes.text("type") == "volume") {
            const std::string_view key = attributes.text("key"), value = attributes.text("value");
            if (key == "volume_type" && value != "ModelPart") {
                m_isMatter = false;
                m_isNegative = value == "NegativeVolume";
            } else if (key == "modifier" && value == "1") { // before PrusaSlicer 1.42
                m_isMatter = false;
            }
        }
    }
    void end(std::string_view name)
    {
        if (name == "volume" && !m_isMatter && m_object && m_first && m_last)
            m_parts.triangles[*m_object].push_back({*m_first, *m_last, m_isNegative});
    }

private:
    ThreeMfSlicerParts& m_parts;
    std::optional<std::uint32_t> m_object, m_first, m_last;
    bool m_isMatter = true, m_isNegative = false;
};

/// Gathers the parts of Bambu Studio's file that are no matter: elements `part` in an `object`. The program goes by
/// their `subtype` alone, whatever the type of the object in the model; a subtype that it does not know is matter.
class PartReader
{
public:
    explicit PartReader(ThreeMfSlicerParts& parts) : m_parts(parts) {}

    void begin(std::string_view name, const XmlAttributes& attributes)
    {
        if (name == "object")
            m_object = numberIn(attributes, "id");
        if (name != "part")
            return;
        const std::string_view type = attributes.text("subtype");
        const bool isNegative = type == "negative_part";
        if (!isNegative && type != "modifier_part" && type != "support_blocker" && type != "support_enforcer")
            return;
        if (const auto part = numberIn(attributes, "id"); part && m_object)
            m_parts.objects.insert_or_assign({*m_object, *part}, isNegative);
    }

private:
    ThreeMfSlicerParts& m_parts;
    std::optional<std::uint32_t> m_object;
};

/// Reads a part, if it is there, up to where it breaks off.
template <class Reader> void readPart(const FileBytes& file, ZipReader& package, const std::string& name, Reader reader)
{
    const std::optional<std::string> part = package.find(name);
    if (!part)
        return;
    const auto end = [&reader](std::string_view element) {
        if constexpr (requires { reader.end(element); })
            reader.end(withoutSpace(element));
    };
    XmlReader xml(
        file,
        [&reader](std::string_view element, const XmlAttributes& attributes) {
            reader.begin(withoutSpace(element), attributes);
        },
        end);
    try {
        package.read(*part, [&xml](std::string_view piece) { xml.take(piece); });
    } catch (const FileError&) { // the model does not need it
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
