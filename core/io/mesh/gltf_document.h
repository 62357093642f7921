#pragma once

#include "core/io/mesh/format.h"

#include "core/util/large_buffer.h"

#include <nlohmann/json.hpp>

#include <deque>
#include <map>
#include <optional>

namespace core::io
{
inline constexpr std::size_t glbHeadSize = 12, glbChunkHeadSize = 8;
inline constexpr std::uint32_t glbMagic = 0x46546c67, glbVersion = 2, glbJsonChunk = 0x4e4f534a,
                               glbBinaryChunk = 0x004e4942;

/// The modes of primitives that make triangles.
enum GltfMode : std::size_t { GltfTriangles = 4, GltfTriangleStrip = 5, GltfTriangleFan = 6 };

/// How the numbers of an accessor lie in a buffer.
struct GltfLayout
{
    const char* first = nullptr; ///< null: all are 0
    std::size_t count = 0, stride = 0;
    int componentType = 0, components = 0;
    bool normalized = false;
};

/// Returns an extension of an object of glTF, whatever its type; null if there is none.
const nlohmann::json* gltfExtension(const nlohmann::json& object, std::string_view name);

/// A glTF's JSON, parsed by a library, and its buffers: in the GLB, in the JSON, or in files beside it. What is asked
/// for is looked at before anything is read by it: wrong types, indices and sizes throw FileError with the JSON's word
/// for what is wrong. Extensions that it requires are passed over where they say nothing of the shape. Buffer views
/// that meshopt compressed are unpacked when they are asked for. A file that requires Draco is refused where there is
/// no decoder (draco_stream.h): NeedsExtension, with the bytes of the file and of its buffers as `expected`. Not
/// thread-safe.
class GltfDocument
{
public:
    using Json = nlohmann::json;

    GltfDocument(const FileBytes& file, bool isBinary);

    const Json& document() const { return m_document; }
    /// Counts the bytes of the file, of its buffers, and of what has been unpacked of them.
    std::size_t bytes() const { return m_bytes + m_unpackedBytes; }

    /// Empty if there is none.
    const Json& arrayIn(const Json& object, const char* key) const;
    std::size_t toIndex(const Json& value, const char* what) const;
    std::optional<std::size_t> indexIn(const Json& object, const char* key) const;
    std::size_t sizeIn(const Json& object, const char* key, std::size_t otherwise) const
    {
        return indexIn(object, key).value_or(otherwise);
    }
    /// Of one of the document's lists: an object.
    const Json& element(const char* list, std::size_t index) const;

    bool isRequired(std::string_view extension) const;

    /// Returns what a buffer view holds, unpacked.
    std::string_view viewBytes(std::size_t index) const;
    /// Adds to the bytes that have been unpacked. Throws UnpacksTooLarge if those are too many for the file.
    void countUnpacked(std::size_t bytes) const;

    /// An accessor with so many components, its sparse part aside. `decoded`: its numbers from elsewhere, which have to
    /// be as many as it says.
    GltfLayout layoutOf(std::size_t accessor, int min, int max, const GltfLayout* decoded = nullptr) const;
    /// The accessor's numbers, element after element; normalised ones from -1 or 0 to 1.
    LargeBuffer<float> valuesOf(std::size_t accessor, const GltfLayout& layout, const std::stop_token& stop) const;
    LargeBuffer<std::uint32_t> wholesOf(std::size_t accessor, const std::stop_token& stop) const;

    [[noreturn]] void refuse(FileFault fault, std::string_view what, std::uint64_t expected = 0) const;

private:
    void readChunks();
    void parse(std::string_view text);
    void refuseOldVersion() const;
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
    std::string_view m_binary; ///< chunk of a GLB
    std::deque<std::string> m_loaded;
    std::vector<std::string_view> m_buffers;    ///< into the chunk, and what was loaded
    std::map<std::size_t, FileError> m_missing; ///< why a buffer was not loaded, which matters where it is used
    std::size_t m_bytes = 0;
    mutable std::map<std::size_t, std::string> m_unpacked; ///< buffer views
    mutable std::size_t m_unpackedBytes = 0;
};
} // namespace core::io
