#include "core/io/mesh/zip_writer.h"

#include <zip.h>

#include <array>

namespace core::io
{
namespace
{
/// Deflate level, 1 to 9; level 6 takes three times as long and makes a model a tenth smaller.
constexpr int packing = 3;
constexpr std::uint16_t firstDosDay = 0x21; ///< 1980-01-01
} // namespace

// Everything is done in memory, so that every failure is a lack of memory.
ZipWriter::ZipWriter()
    : m_packed(zip_source_buffer_create(nullptr, 0, 0, nullptr), &zip_source_free)
    , m_zip(nullptr, &zip_discard)
{
    if (!m_packed)
        throw std::bad_alloc();
    zip_source_keep(m_packed.get()); // a second reference, because the archive releases one
    m_zip.reset(zip_open_from_source(m_packed.get(), ZIP_CREATE | ZIP_TRUNCATE, nullptr));
    if (!m_zip) {
        zip_source_free(m_packed.get());
        throw std::bad_alloc();
    }
}

ZipWriter::~ZipWriter() = default;

void ZipWriter::add(const char* name, std::string_view bytes, Packing how)
{
    add(name, zip_source_buffer(m_zip.get(), bytes.data(), bytes.size(), 0), how);
}

void ZipWriter::add(const char* name, zip_source_t* source, Packing how)
{
    const zip_int64_t index = source ? zip_file_add(m_zip.get(), name, source, ZIP_FL_ENC_UTF_8) : -1;
    if (index < 0) {
        zip_source_free(source);
        throw std::bad_alloc();
    }
    const auto part = static_cast<zip_uint64_t>(index);
    zip_set_file_compression(m_zip.get(), part, how == Packing::Stored ? ZIP_CM_STORE : ZIP_CM_DEFLATE, packing);
    zip_file_set_dostime(m_zip.get(), part, 0, firstDosDay, 0);
}

void ZipWriter::writeTo(AtomicFile& out)
{
    if (zip_close(m_zip.get()) != 0)
        throw std::bad_alloc();
    m_zip.release();
    if (zip_source_open(m_packed.get()) != 0)
        throw std::bad_alloc();
    std::array<char, 1 << 16> piece;
    for (;;) {
        const zip_int64_t got = zip_source_read(m_packed.get(), piece.data(), piece.size());
        if (got <= 0)
            break;
        out.write({piece.data(), static_cast<std::size_t>(got)});
    }
    zip_source_close(m_packed.get());
}
} // namespace core::io
