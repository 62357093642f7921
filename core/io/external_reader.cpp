#include "core/io/external_reader.h"

namespace core
{
namespace
{
ExternalReader& theReader()
{
    static ExternalReader reader;
    return reader;
}
} // namespace

void setExternalReader(ExternalReader reader)
{
    theReader() = std::move(reader);
}

const ExternalReader& externalReader()
{
    return theReader();
}
} // namespace core
