#include "core/io/external_reader.h"

namespace core
{
namespace
{
ForeignReader& theReader()
{
    static ForeignReader reader;
    return reader;
}
} // namespace

void setForeignReader(ForeignReader reader)
{
    theReader() = std::move(reader);
}

const ForeignReader& foreignReader()
{
    return theReader();
}
} // namespace core
