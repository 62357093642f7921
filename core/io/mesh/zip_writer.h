#pragma once

#include "core/util/atomic_file.h"

#include <memory>
#include <string_view>

struct zip;
struct zip_source;

namespace core::io
{
/// Makes a zip file in memory with the library libzip. Equal parts give equal bytes: all have the date 1980-01-01.
class ZipWriter
{
public:
    enum class Packing { Stored, Deflated };

    ZipWriter();
    ~ZipWriter();
    ZipWriter(const ZipWriter&) = delete;
    ZipWriter& operator=(const ZipWriter&) = delete;

    /// Adds a part. Precondition: the bytes stay valid until writeTo().
    void add(const char* name, std::string_view bytes, Packing packing);
    /// Adds a part and takes ownership of the source. Precondition: the source belongs to archive().
    void add(const char* name, zip_source* source, Packing packing);
    zip* archive() { return m_zip.get(); }

    /// Finishes the zip and writes it. Throws FileError.
    void writeTo(AtomicFile& out);

private:
    std::unique_ptr<zip_source, void (*)(zip_source*)> m_packed;
    std::unique_ptr<zip, void (*)(zip*)> m_zip;
};
} // namespace core::io
