#pragma once

#include "core/io/mesh/format.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

struct zip;

namespace core::io
{
/// A zip file in memory, unpacked by the library libzip. Parts are found by name in upper or lower case. The total of
/// unpacked bytes is limited to a hundred times the file's size, but at least 16 MiB and at most 4 GiB. A part that
/// declares or contains more throws FileError::UnpacksTooLarge. Memory: 64 KiB while a part is read, and about six
/// times the size of the directory.
class ZipReader
{
public:
    explicit ZipReader(const FileBytes& file);
    ~ZipReader();
    ZipReader(const ZipReader&) = delete;
    ZipReader& operator=(const ZipReader&) = delete;

    /// Returns the number of parts. Their names are unchecked and must not be used as paths.
    std::size_t count() const;
    std::vector<std::string> names() const;
    bool has(const std::string& part) const;
    /// Returns the name that `part` has in the package: it may differ in case, slashes and percent encoding.
    std::optional<std::string> find(const std::string& part) const;

    /// Passes the part to `take` piece by piece; the last piece is empty. Throws ReadingCancelled, and FileError:
    /// UnpacksTooLarge; Malformed with the part's name if it does not exist, is encrypted, or is packed in an
    /// unsupported way; CutOff if its data are damaged.
    using Take = std::function<void(std::string_view piece)>;
    void read(const std::string& part, const Take& take);

private:
    const FileBytes& m_file;
    std::unique_ptr<zip, void (*)(zip*)> m_zip;
    std::uint64_t m_left; ///< bytes that may still be unpacked
};
} // namespace core::io
