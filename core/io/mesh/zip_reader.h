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
/// A zip file in memory, unpacked by a library (libzip): its parts by name, in either case. All that is read of it may
/// have a hundred times the file's size, at least 16 MiB and at most 4 GiB; what announces or has more throws
/// FileError::UnpacksTooLarge. Each part takes 64 KiB of memory at a time, the directory some six times its own size.
class ZipReader
{
public:
    explicit ZipReader(const FileBytes& file);
    ~ZipReader();
    ZipReader(const ZipReader&) = delete;
    ZipReader& operator=(const ZipReader&) = delete;

    /// Of its parts. Names are not checked: nobody may take them for paths.
    std::size_t count() const;
    std::vector<std::string> names() const;
    bool has(const std::string& part) const;
    /// Returns the name that `part` has in the package: in another case, with backslashes, or with percent signs.
    std::optional<std::string> find(const std::string& part) const;

    /// `take` gets a piece after the other; the last one is empty. Throws FileError: Malformed with the part's name if
    /// it is not there, or is encrypted or packed in a way that we do not take; CutOff if its bytes are not what they
    /// were.
    using Take = std::function<void(std::string_view piece)>;
    void read(const std::string& part, const Take& take);

private:
    const FileBytes& m_file;
    std::unique_ptr<zip, void (*)(zip*)> m_zip;
    std::uint64_t m_left; ///< bytes that may still be unpacked
};
} // namespace core::io
