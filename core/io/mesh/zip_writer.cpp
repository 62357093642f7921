#include "core/io/mesh/zip_writer.h"

#include <zip.h>

#include <array>

namespace core::io
{
namespace
{
constexpr int packing = 3; ///< of deflate's 1 to 9: at 6 a model takes three times as long, and is a tenth smaller
constexpr std::uint16_t firstDosDay = 0x21; ///< 1980-01-01
} // namespace

// All goes on in memory: what fails, fails for want of it.
ZipWriter::ZipWriter()
    : m_packed(zip_source_buffer_create(nullptr, 0, 0, nullptr), &zip_source_free)
    , m_zip(nullptr, &zip_discard)
{
    if (!m_packed)
        throw std::bad_alloc();
    zip_source_keep(m_packed.get()); // the archive frees it once
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
