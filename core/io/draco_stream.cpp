#include "core/io/draco_stream.h"

namespace core
{
namespace
{
DracoDecoder& theDecoder()
{
    static DracoDecoder decoder;
    return decoder;
}
} // namespace

void setDracoDecoder(DracoDecoder decoder)
{
    theDecoder() = std::move(decoder);
}

const DracoDecoder& dracoDecoder()
{
    return theDecoder();
}
} // namespace core
