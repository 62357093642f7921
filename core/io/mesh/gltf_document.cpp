// Source: Khronos, glTF 2.0 specification, sections 3.6 (accessors and sparse accessors) and 4 (GLB).
#include "core/io/mesh/gltf_document.h"

#include "core/io/mesh/binary.h"
#include "core/io/mesh/gltf_buffers.h"
#include "core/io/mesh/gltf_draco.h"
#include "core/io/mesh/gltf_extensions.h"
#include "core/io/mesh/gltf_meshopt.h"
#include "core/io/mesh/number_parsing.h"
#include "core/util/parallel.h"

#include <cmath>
#include <limits>

namespace core::io
{
namespace
{
/// Largest size of the JSON in bytes, without its string contents. Parsing nothing but brackets needs eighty times this
/// memory. The numbers of models are not limited by it: they are in buffers or in base64 strings.
constexpr std::size_t maxJson = std::size_t(1) << 23;
/// Largest total size in bytes, equal to the limit for a model file.
constexpr std::size_t maxBytes = std::size_t(1) << 31;
/// Limits of unpacked bytes: a multiple of the file's size, as for a zip, and a size in bytes that is always allowed.
constexpr std::size_t maxUnpackedTimes = 100, alwaysUnpacked = std::size_t(64) << 20;

/// Returns the size of the JSON without the contents of its strings; each string counts as its two quotes.
std::size_t sizeBesideTexts(std::string_view json)
{
    std::size_t size = 0;
    bool isInText = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        if (isInText && json[i] == '\\')
            ++i;
        else if (json[i] == '"')
            isInText = !isInText, ++size;
        else
            size += isInText ? 0 : 1;
    }
    return size;
}

/// Returns the first number in the JSON, outside of strings, that is too large for a double. Returns an empty view at
/// the front if there is none.
std::string_view tooLargeIn(std::string_view json)
{
    std::size_t end = 0;
    for (std::size_t i = 0; i < json.size(); i = end) {
        end = i + 1;
        if (json[i] == '"') {
            while (end < json.size() && json[end] != '"')
                end += json[end] == '\\' ? 2 : 1;
            ++end;
        } else if (json[i] == '-' || (json[i] >= '0' && json[i] <= '9')) {
            end = std::min(json.find_first_not_of("+-.0123456789eE", i), json.size());
            const std::string_view word = json.substr(i, end - i);
            const bool isTiny = word.find('-', 1) != std::string_view::npos;
            if (!isTiny && !parseDouble(word))
                return word;
        }
    }
    return json.substr(0, 0);
}

std::size_t sizeOf(int componentType)
{
    switch (componentType) {
    case 5120:
    case 5121:
        return 1;
    case 5122:
    case 5123:
        return 2;
    case 5125:
    case 5126:
        return 4;
    default:
        return 0;
    }
}

bool isWhole(int componentType)
{
    return componentType == 5121 || componentType == 5123 || componentType == 5125;
}

/// Converts a number. Normalised integers are scaled to a maximum of 1. The result is rounded to the target type.
template <typename Number, typename Source> Number converted(Source x, bool isNormalized)
{
    if constexpr (std::is_floating_point_v<Source> || std::is_same_v<Number, std::uint32_t>)
        return static_cast<Number>(x);
    else
        return static_cast<Number>(isNormalized
                                       ? std::max(-1.0, static_cast<double>(x) / std::numeric_limits<Source>::max())
                                       : static_cast<double>(x));
}

template <typename Source, typename Number>
void convertFrom(const GltfLayout& layout, std::size_t begin, std::size_t end, Number* into)
{
    for (std::size_t i = begin; i < end; ++i)
        for (int k = 0; k < layout.components; ++k)
            *into++ = converted<Number>(
                load<Source>(layout.first + i * layout.stride + static_cast<std::size_t>(k) * sizeof(Source),
                             std::endian::little),
                layout.normalized);
}

/// Converts the numbers of the elements from `begin` to `end`.
template <typename Number> void convert(const GltfLayout& layout, std::size_t begin, std::size_t end, Number* into)
{
    switch (layout.componentType) {
    case 5120:
        return convertFrom<std::int8_t>(layout, begin, end, into);
    case 5121:
        return convertFrom<std::uint8_t>(layout, begin, end, into);
    case 5122:
        return convertFrom<std::int16_t>(layout, begin, end, into);
    case 5123:
        return convertFrom<std::uint16_t>(layout, begin, end, into);
    case 5125:
        return convertFrom<std::uint32_t>(layout, begin, end, into);
    default:
        return convertFrom<float>(layout, begin, end, into);
    }
}

/// Returns the number before the dot of a version such as "2.0"; 2 if it begins with no number.
std::int64_t majorOf(std::string_view version)
{
    return parseInteger(version.substr(0, version.find('.'))).value_or(2);
}

/// Returns whether a binary chunk begins at `at` and ends within the file. Some programs do not pad the chunk before
/// it.
bool isChunkAt(std::string_view bytes, std::size_t at)
{
    if (at > bytes.size() || bytes.size() - at < glbChunkHeadSize)
        return false;
    const auto size = load<std::uint32_t>(bytes.data() + at, std::endian::little),
               type = load<std::uint32_t>(bytes.data() + at + 4, std::endian::little);
    return type == glbBinaryChunk && size <= bytes.size() - at - glbChunkHeadSize;
}
} // namespace

const nlohmann::json* gltfExtension(const nlohmann::json& object, std::string_view name)
{
    const auto extensions = object.find("extensions");
    if (extensions == object.end() || !extensions->is_object())
        return nullptr;
    const auto extension = extensions->find(name);
    return extension == extensions->end() ? nullptr : &*extension;
}

GltfDocument::GltfDocument(const FileBytes& file, bool isBinary) : m_file(file), m_bytes(file.bytes.size())
{
    if (isBinary)
        readChunks();
    else
        parse(file.bytes);
    if (!m_document.is_object())
        throw malformed(isBinary ? FileFault::JsonChunk : FileFault::Json,
                        errorAtByte({}, m_file, file.bytes.data() + (isBinary ? glbHeadSize : 0)));
    refuseOtherVersions();
    refuseExtensions();
    loadBuffers();
    if (isRequired(dracoExtension) && !dracoDecoder())
        refuse(FileFault::NeedsExtension, dracoExtension, m_bytes);
}

void GltfDocument::refuse(FileFault fault, std::string_view what, std::uint64_t expected) const
{
    throw malformed(fault, withCounts(errorWithToken({}, m_file, what), expected));
}

void GltfDocument::refuseCutOff() const
{
    throw errorAtByte(FileErrorKind::CutOff, m_file, m_file.bytes.data() + m_file.bytes.size());
}

void GltfDocument::readChunks()
{
    const std::string_view bytes = m_file.bytes;
    if (bytes.size() < glbHeadSize + glbChunkHeadSize)
        refuseCutOff();
    const auto numberAtByte = [&](std::size_t at) {
        return load<std::uint32_t>(bytes.data() + at, std::endian::little);
    };
    if (numberAtByte(4) != 2)
        throw malformed(FileFault::OldGltf, errorAtByte({}, m_file, bytes.data() + 4, std::to_string(numberAtByte(4))));
    if (numberAtByte(8) > bytes.size())
        refuseCutOff();
    for (std::size_t at = glbHeadSize; at + glbChunkHeadSize <= numberAtByte(8);) {
        const std::size_t size = numberAtByte(at);
        const std::uint32_t type = numberAtByte(at + 4);
        const std::string_view chunk = bytes.substr(at + glbChunkHeadSize, size);
        if (chunk.size() < size)
            refuseCutOff();
        if (type == glbJsonChunk && at == glbHeadSize)
            parse(chunk);
        else if (type == glbBinaryChunk && m_binary.empty())
            m_binary = chunk;
        at += glbChunkHeadSize + size;
        if (!isChunkAt(bytes.substr(0, numberAtByte(8)), at))
            at += (4 - size % 4) % 4;
    }
}

void GltfDocument::parse(std::string_view text)
{
    if (sizeBesideTexts(text) > maxJson)
        throw tooMany("JSON", maxJson, errorAtByte({}, m_file, text.data()));
    try {
        m_document = Json::parse(withoutPadding(text));
    } catch (const Json::parse_error& error) {
        throw malformed(FileFault::Json, errorAtByte({}, m_file, text.data() + std::min(error.byte, text.size())));
    } catch (const Json::exception&) { // a number too large for a double
        const std::string_view number = tooLargeIn(text);
        throw errorAtByte(FileErrorKind::NotANumber, m_file, number.data(), number);
    }
}

/// Throws OldGltf for files of version 1, and for those that need a later version than 2.0. The specification (3.2)
/// says that files of a later version 2 without minVersion are valid for a reader of 2.0.
void GltfDocument::refuseOtherVersions() const
{
    const auto asset = m_document.find("asset");
    const auto version = asset != m_document.end() && asset->is_object() ? asset->find("version") : m_document.end();
    if (asset == m_document.end() || !asset->is_object() || version == asset->end() || !version->is_string()) {
        // The version is optional here: many files omit it
        if (const auto meshes = m_document.find("meshes"); meshes != m_document.end() && meshes->is_object())
            refuse(FileFault::OldGltf, "1.0"); // version 2 has a list of meshes
        return;
    }
    const auto minVersion = asset->find("minVersion");
    const bool hasMin = minVersion != asset->end() && minVersion->is_string();
    const std::string &text = version->get_ref<const std::string&>(),
                      &min = hasMin ? minVersion->get_ref<const std::string&>() : text;
    if (majorOf(text) < 2)
        refuse(FileFault::OldGltf, text);
    if (majorOf(min) > 2 || (hasMin && majorOf(min) == 2 && min != "2.0"))
        refuse(FileFault::OldGltf, min);
}

bool GltfDocument::isRequired(std::string_view extension) const
{
    const Json& required = arrayIn(m_document, "extensionsRequired");
    return std::any_of(required.begin(), required.end(), [extension](const Json& name) { return name == extension; });
}

/// Throws NeedsExtension if the file requires an extension that cannot be ignored.
void GltfDocument::refuseExtensions() const
{
    for (const Json& extension : arrayIn(m_document, "extensionsRequired")) {
        if (!extension.is_string())
            refuse(FileFault::NotAList, "extensionsRequired");
        if (const auto& name = extension.get_ref<const std::string&>(); !isWithoutShape(name))
            refuse(FileFault::NeedsExtension, name);
    }
}

void GltfDocument::loadBuffers()
{
    for (const Json& buffer : arrayIn(m_document, "buffers")) {
        const auto uri = buffer.is_object() ? buffer.find("uri") : buffer.end();
        if (!buffer.is_object() || (uri != buffer.end() && !uri->is_string()))
            refuse(FileFault::NotAnObject, "buffers/" + std::to_string(m_buffers.size()));
        if (isGltfFallback(buffer)) {
            m_buffers.emplace_back();
            continue;
        }
        if (uri == buffer.end()) { // the GLB's binary chunk belongs to the first buffer
            m_buffers.push_back(m_buffers.empty() ? m_binary : std::string_view());
            continue;
        }
        const std::size_t length = sizeIn(buffer, "byteLength", 0);
        if (length > maxBytes - std::min(m_bytes, maxBytes))
            throw tooMany("bytes", maxBytes, errorWithToken({}, m_file, {}));
        try {
            m_loaded.push_back(gltfBuffer(m_file, uri->get_ref<const std::string&>(), length));
        } catch (const FileError& error) {
            m_missing.emplace(m_buffers.size(), error);
            m_buffers.emplace_back();
            continue;
        }
        m_buffers.emplace_back(m_loaded.back());
        m_bytes += m_loaded.back().size();
    }
}

const GltfDocument::Json& GltfDocument::arrayIn(const Json& object, const char* key) const
{
    static const Json none = Json::array();
    const auto found = object.find(key);
    if (found == object.end())
        return none;
    if (!found->is_array())
        refuse(FileFault::NotAList, key);
    return *found;
}

std::size_t GltfDocument::toIndex(const Json& value, const char* what) const
{
    constexpr double most = 1ULL << 53; // whole doubles are exact up to here
    if (value.is_number_float())        // some programs write 3.0
        if (const double number = value.get<double>(); number >= 0 && number <= most && number == std::floor(number))
            return static_cast<std::size_t>(number);
    if (!value.is_number_integer() || value < 0)
        refuse(FileFault::NotAnIndex, what);
    return value.get<std::size_t>();
}

std::optional<std::size_t> GltfDocument::indexIn(const Json& object, const char* key) const
{
    const auto found = object.find(key);
    if (found == object.end())
        return std::nullopt;
    return toIndex(*found, key);
}

const GltfDocument::Json& GltfDocument::element(const char* list, std::size_t index) const
{
    const Json& elements = arrayIn(m_document, list);
    if (index >= elements.size() || !elements[index].is_object())
        refuse(index >= elements.size() ? FileFault::Missing : FileFault::NotAnObject,
               std::string(list) + '/' + std::to_string(index));
    return elements[index];
}

std::string_view GltfDocument::partOf(std::size_t buffer, std::size_t offset, std::size_t length) const
{
    if (buffer >= m_buffers.size())
        refuse(FileFault::Missing, "buffers/" + std::to_string(buffer));
    if (const auto missing = m_missing.find(buffer); missing != m_missing.end())
        throw missing->second;
    if (const std::size_t size = m_buffers[buffer].size(); offset > size || length > size - offset)
        refuseCutOff();
    return m_buffers[buffer].substr(offset, length);
}

void GltfDocument::countUnpacked(std::size_t bytes) const
{
    const std::size_t max = std::clamp(maxUnpackedTimes * m_bytes, alwaysUnpacked, maxBytes);
    if (bytes > max - m_unpackedBytes)
        throw withCounts({FileErrorKind::UnpacksTooLarge, m_file.path}, max);
    m_unpackedBytes += bytes;
}

std::string_view GltfDocument::viewBytes(std::size_t index) const
{
    const Json& view = element("bufferViews", index);
    const std::optional<GltfMeshopt> packed = gltfMeshoptIn(*this, view, "bufferViews/" + std::to_string(index));
    if (!packed)
        return partOf(sizeIn(view, "buffer", 0), sizeIn(view, "byteOffset", 0), sizeIn(view, "byteLength", 0));
    if (const auto found = m_unpacked.find(index); found != m_unpacked.end())
        return found->second;
    MeshoptView what = packed->view;
    what.data = partOf(packed->buffer, packed->offset, packed->length);
    countUnpacked(what.count * what.stride);
    return m_unpacked[index] = meshoptUnpacked(m_file, what);
}

/// Returns the layout of `count` elements of `size` bytes in a buffer view. Throws if they exceed the view.
GltfLayout GltfDocument::elementsIn(const Json& at, std::size_t count, std::size_t size, std::size_t ownStride) const
{
    const auto index = indexIn(at, "bufferView");
    if (!index)
        refuse(FileFault::Missing, "bufferView");
    const Json& view = element("bufferViews", *index);
    const std::string_view bytes = viewBytes(*index);
    const std::size_t length = bytes.size(), offset = sizeIn(at, "byteOffset", 0);
    const std::size_t stride = std::max(size, ownStride != 0 ? ownStride : sizeIn(view, "byteStride", size));
    if (offset > length || count == 0 || size > length - offset || (length - offset - size) / stride < count - 1)
        refuse(FileFault::BeyondItsData, "bufferViews/" + std::to_string(*index));
    return {.first = bytes.data() + offset, .count = count, .stride = stride};
}

GltfLayout GltfDocument::layoutOf(std::size_t accessor, int min, int max, const GltfLayout* decoded) const
{
    const Json& from = element("accessors", accessor);
    const std::string name = "accessors/" + std::to_string(accessor);
    const auto type = from.find("type");
    const int components = type == from.end()  ? 0
                           : *type == "SCALAR" ? 1
                           : *type == "VEC3"   ? 3
                           : *type == "VEC4"   ? 4
                           : *type == "MAT4"   ? 16
                                               : 0;
    const auto componentType = static_cast<int>(std::min<std::size_t>(sizeIn(from, "componentType", 0), 65535));
    const std::size_t count = sizeIn(from, "count", 0);
    const std::size_t maxCount = decoded                       ? decoded->count
                                 : from.contains("bufferView") ? maxMeshoptRatio * m_bytes
                                                               : m_bytes;
    if (components < min || components > max || sizeOf(componentType) == 0 || count == 0 || count > maxCount)
        refuse(FileFault::WrongAccessor, name);
    GltfLayout layout;
    if (decoded) {
        const bool isAlike = decoded->count == count && decoded->components == components &&
                             (!from.contains("sparse") || decoded->componentType == componentType);
        if (!isAlike || decoded->stride != sizeOf(decoded->componentType) * static_cast<std::size_t>(components))
            refuse(FileFault::WrongAccessor, name);
        layout = *decoded;
        layout.normalized = from.value("normalized", Json(false)) == true;
        return layout;
    }
    if (from.contains("bufferView"))
        layout = elementsIn(from, count, sizeOf(componentType) * static_cast<std::size_t>(components), 0);
    layout.count = count;
    layout.componentType = componentType;
    layout.components = components;
    layout.normalized = from.value("normalized", Json(false)) == true;
    return layout;
}

/// Returns the sparse part of an accessor: indices of elements and the values that replace them.
GltfDocument::Sparse GltfDocument::sparseOf(std::size_t accessor, const GltfLayout& layout) const
{
    const Json& from = element("accessors", accessor);
    const auto sparse = from.find("sparse");
    if (sparse == from.end())
        return {};
    const auto part = [&](const char* key) -> const Json& {
        const auto found = sparse->is_object() ? sparse->find(key) : sparse->end();
        if (!sparse->is_object() || found == sparse->end() || !found->is_object())
            refuse(FileFault::NotAnObject, "sparse");
        return *found;
    };
    const auto type = static_cast<int>(std::min<std::size_t>(sizeIn(part("indices"), "componentType", 0), 65535));
    const std::size_t count = sizeIn(*sparse, "count", 0);
    const std::size_t size = sizeOf(layout.componentType) * static_cast<std::size_t>(layout.components);
    if (!isWhole(type) || count > layout.count)
        refuse(FileFault::WrongAccessor, "sparse");
    Sparse result{elementsIn(part("indices"), count, sizeOf(type), sizeOf(type)),
                  elementsIn(part("values"), count, size, size)};
    result.places.componentType = type;
    result.places.components = 1;
    result.values.componentType = layout.componentType;
    result.values.components = layout.components;
    result.values.normalized = layout.normalized;
    return result;
}

/// Converts the accessor's numbers on all cores and applies its sparse part.
template <typename Number>
LargeBuffer<Number> GltfDocument::numbersOf(std::size_t accessor, const GltfLayout& layout,
                                            const std::stop_token& stop) const
{
    constexpr std::size_t chunkSize = 1 << 15;
    const auto components = static_cast<std::size_t>(layout.components);
    LargeBuffer<Number> numbers(layout.count * components);
    forEachChunk(layout.count, chunkSize, [&](std::size_t, std::size_t begin, std::size_t end) {
        if (stop.stop_requested())
            throw ReadingCancelled();
        if (layout.first)
            convert(layout, begin, end, &numbers[begin * components]);
        else
            std::ranges::fill(numbers.part(begin * components, end * components), Number(0));
    });
    const auto [places, values] = sparseOf(accessor, layout);
    for (std::size_t i = 0; i < places.count; ++i) {
        std::uint32_t place = 0;
        convert(places, i, i + 1, &place);
        if (place >= layout.count)
            refuse(FileFault::WrongAccessor, "sparse");
        convert(values, i, i + 1, &numbers[place * components]);
    }
    return numbers;
}

LargeBuffer<float> GltfDocument::valuesOf(std::size_t accessor, const GltfLayout& layout,
                                          const std::stop_token& stop) const
{
    return numbersOf<float>(accessor, layout, stop);
}

LargeBuffer<std::uint32_t> GltfDocument::wholesOf(std::size_t accessor, const std::stop_token& stop) const
{
    const GltfLayout layout = layoutOf(accessor, 1, 1);
    if (!isWhole(layout.componentType))
        refuse(FileFault::WrongAccessor, "accessors/" + std::to_string(accessor));
    return numbersOf<std::uint32_t>(accessor, layout, stop);
}
} // namespace core::io
