#pragma once

#include "core/io/mesh/format.h"

#include "core/io/large_buffer.h"

#include <nlohmann/json.hpp>

#include <deque>
#include <map>
#include <optional>

namespace core::io
{
inline constexpr std::size_t glbHeadSize = 12, glbChunkHeadSize = 8;
inline constexpr std::uint32_t glbMagic = 0x46546c67, glbVersion = 2, glbJsonChunk = 0x4e4f534a,
                               glbBinaryChunk = 0x004e4942;

/// The primitive modes that make triangles.
enum GltfMode : std::size_t { GltfTriangles = 4, GltfTriangleStrip = 5, GltfTriangleFan = 6 };

/// The layout of an accessor's numbers in a buffer.
struct GltfLayout
{
    const char* first = nullptr; ///< null: all numbers are 0
    std::size_t count = 0, stride = 0;
    int componentType = 0, components = 0;
    bool normalized = false;
};

/// Returns an extension of a glTF object, of any JSON type; null if there is none.
const nlohmann::json* gltfExtension(const nlohmann::json& object, std::string_view name);

/// The JSON of a glTF, and its buffers, which are in the GLB, in the JSON or in files beside it. Each getter validates
/// what it reads. Wrong types, indices and sizes throw FileError with the JSON name of the faulty entry. Ignores
/// required extensions that do not affect the shape. Buffer views compressed by meshopt are unpacked on first use. A
/// file that requires Draco is refused if there is no decoder (draco_stream.h): NeedsExtension, with the bytes of the
/// file and its buffers as `expected`. Thread: one at a time.
class GltfDocument
{
public:
    using Json = nlohmann::json;

    GltfDocument(const FileBytes& file, bool isBinary);

    const Json& document() const { return m_document; }
    /// Returns the total bytes of the file, its buffers, and the data unpacked from them.
    std::size_t bytes() const { return m_bytes + m_unpackedBytes; }

    /// Returns the array at the key; an empty array if there is none.
    const Json& arrayIn(const Json& object, const char* key) const;
    std::size_t toIndex(const Json& value, const char* what) const;
    std::optional<std::size_t> indexIn(const Json& object, const char* key) const;
    std::size_t sizeIn(const Json& object, const char* key, std::size_t otherwise) const
    {
        return indexIn(object, key).value_or(otherwise);
    }
    /// Returns an element of one of the document's lists; it must be an object.
    const Json& element(const char* list, std::size_t index) const;

    bool isRequired(std::string_view extension) const;

    /// Returns the bytes of a buffer view, unpacked if it is compressed.
    std::string_view viewBytes(std::size_t index) const;
    /// Adds to the number of unpacked bytes. Throws UnpacksTooLarge if the total is too large for the file's size.
    void countUnpacked(std::size_t bytes) const;

    /// Returns the layout of an accessor with `min` to `max` components, without its sparse part. `decoded`: numbers
    /// from another source that replace the accessor's own; their count must match.
    GltfLayout layoutOf(std::size_t accessor, int min, int max, const GltfLayout* decoded = nullptr) const;
    /// Returns the accessor's numbers, element by element. Normalised numbers are from -1 or 0 to 1.
    LargeBuffer<float> valuesOf(std::size_t accessor, const GltfLayout& layout, const std::stop_token& stop) const;
    LargeBuffer<std::uint32_t> wholesOf(std::size_t accessor, const std::stop_token& stop) const;

    [[noreturn]] void refuse(FileFault fault, std::string_view what, std::uint64_t expected = 0) const;

private:
    void readChunks();
    void parse(std::string_view text);
    void refuseOtherVersions() const;
    void refuseExtensions() const;
    void loadBuffers();
    [[noreturn]] void refuseCutOff() const;
    std::string_view partOf(std::size_t buffer, std::size_t offset, std::size_t length) const;
    GltfLayout elementsIn(const Json& at, std::size_t count, std::size_t size, std::size_t ownStride) const;
    struct Sparse
    {
        GltfLayout places, values;
    };
    Sparse sparseOf(std::size_t accessor, const GltfLayout& layout) const;
    template <typename Number>
    LargeBuffer<Number> numbersOf(std::size_t accessor, const GltfLayout& layout, const std::stop_token& stop) const;

    const FileBytes& m_file;
    Json m_document;
    std::string_view m_binary; ///< the binary chunk of a GLB
    std::deque<std::string> m_loaded;
    std::vector<std::string_view> m_buffers; ///< views into m_binary and m_loaded
    /// Errors of buffers that were not loaded, thrown when the buffer is used.
    std::map<std::size_t, FileError> m_missing;
    std::size_t m_bytes = 0;
    mutable std::map<std::size_t, std::string> m_unpacked; ///< unpacked data, by index of the buffer view
    mutable std::size_t m_unpackedBytes = 0;
};
} // namespace core::io
