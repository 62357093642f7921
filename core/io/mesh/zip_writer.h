#pragma once

#include "core/util/atomic_file.h"

#include <memory>
#include <string_view>

struct zip;
struct zip_source;

namespace core::io
{
/// A zip file that is made in memory by a library (libzip). The same parts give the same bytes: all are of the first
/// day that zip knows.
class ZipWriter
{
public:
    enum class Packing { Stored, Deflated };

    ZipWriter();
    ~ZipWriter();
    ZipWriter(const ZipWriter&) = delete;
    ZipWriter& operator=(const ZipWriter&) = delete;

    /// The bytes must stay until writeTo().
    void add(const char* name, std::string_view bytes, Packing packing);
    /// Takes the source, which must be one of this archive's.
    void add(const char* name, zip_source* source, Packing packing);
    zip* archive() { return m_zip.get(); }

    /// Ends it. Throws FileError.
    void writeTo(AtomicFile& out);

private:
    std::unique_ptr<zip_source, void (*)(zip_source*)> m_packed;
    std::unique_ptr<zip, void (*)(zip*)> m_zip;
};
} // namespace core::io
