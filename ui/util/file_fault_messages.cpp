#include "ui/util/file_fault_messages.h"

namespace ui
{
using core::FileFault;

QString FileFaultMessages::sentence(const core::FileError& error, const QString& where)
{
    if (const QString thing = expected(error); !thing.isEmpty())
        return error.token.empty()
                   ? tr("%1: expected %2, found nothing.").arg(where, thing)
                   : tr("%1: expected %2, found \"%3\".").arg(where, thing, QString::fromLatin1(error.token));
    for (const QString& words : {ofModel(error, where), ofGltf(error, where), ofPackage(error, where)})
        if (!words.isEmpty())
            return words;
    return error.token.empty()
               ? tr("%1: the file breaks the rules of its format.").arg(where)
               : tr("%1: \"%2\" breaks the rules of the file's format.").arg(where, QString::fromLatin1(error.token));
}

QString FileFaultMessages::expected(const core::FileError& error)
{
    switch (error.fault) {
    case FileFault::Keyword:
        return tr("\"%1\"", "a word of the format").arg(QString::fromLatin1(error.wanted));
    case FileFault::Number:
        return tr("a number");
    case FileFault::WholeNumber:
        return tr("a whole number");
    case FileFault::Count:
        return tr("a count that is not negative and fits here");
    case FileFault::VertexNumbers:
        return tr("a vertex of 3 or 4 numbers, with 3 more for a colour or none");
    case FileFault::VertexIndex:
        return tr("the number of a vertex");
    case FileFault::PlyEncoding:
        return tr("ascii, binary_little_endian or binary_big_endian");
    case FileFault::NumberType:
        return tr("a type such as float or int");
    case FileFault::WholeNumberType:
        return tr("a type of whole numbers, such as uchar or int");
    case FileFault::Name:
        return tr("a name");
    case FileFault::ElementFirst:
        return tr("an element before its first property");
    case FileFault::LengthUnit:
        return tr("one of the units millimeter, micron, centimeter, inch, foot and meter");
    case FileFault::PositiveNumber:
        return tr("a number above 0");
    default:
        return {};
    }
}

QString FileFaultMessages::ofModel(const core::FileError& error, const QString& where)
{
    const QString token = QString::fromLatin1(error.token);
    switch (error.fault) {
    case FileFault::Coordinates:
        return tr("%1: the element \"%2\" has no properties x, y and z.").arg(where, token);
    case FileFault::Missing:
        return tr("%1: \"%2\" is needed here, but is missing.").arg(where, token);
    case FileFault::Repeated:
        return tr("%1: \"%2\" appears twice.").arg(where, token);
    case FileFault::NotRead:
        return tr("%1: \"%2\" changes the shape, but is not read: save the model without it.").arg(where, token);
    case FileFault::NotInScene:
        return tr("%1: \"%2\" has faces, but no object with faces is connected to the scene.").arg(where, token);
    default:
        return {};
    }
}

QString FileFaultMessages::ofGltf(const core::FileError& error, const QString& where)
{
    const QString token = QString::fromLatin1(error.token);
    switch (error.fault) {
    case FileFault::Json:
        return tr("%1: the JSON of the file is broken here.").arg(where);
    case FileFault::JsonChunk:
        return tr("%1: a chunk with a JSON object is expected first, but another is there.").arg(where);
    case FileFault::Base64:
        return tr("%1: the data in \"%2\" is not packed as base64, which is expected there.").arg(where, token);
    case FileFault::NotAList:
        return tr("%1: \"%2\" should be a list, but is something else.").arg(where, token);
    case FileFault::NotAnObject:
        return tr("%1: \"%2\" should be a JSON object, but is something else or missing.").arg(where, token);
    case FileFault::NotAnIndex:
        return tr("%1: \"%2\" should be a whole number that is not negative, but is something else.").arg(where, token);
    case FileFault::NotNumbers:
        return tr("%1: \"%2\" should be a list of as many numbers as the format requires, but is something else.")
            .arg(where, token);
    case FileFault::BeyondItsData:
        return tr("%1: \"%2\" contains less data than should be read from it.").arg(where, token);
    case FileFault::WrongAccessor:
        return tr("%1: \"%2\" has a type or a count that does not fit its use.").arg(where, token);
    case FileFault::TooDeep:
        return tr("%1: \"%2\" contain themselves, or are nested too deeply.").arg(where, token);
    case FileFault::NeedsExtension:
        return tr("%1 needs the extension %2, which Fettle cannot read: save it without, in the program that made it.")
            .arg(where, token);
    case FileFault::OldGltf:
        return tr("%1 is glTF of version %2; version 2.0 is read: save it as that.").arg(where, token);
    case FileFault::CompressedCut:
        return tr("%1: the compressed data of \"%2\" ends too early.").arg(where, token);
    case FileFault::CompressedWrong:
        return tr("%1: the compressed data of \"%2\" is not packed as its extension says.").arg(where, token);
    case FileFault::OldFbx:
        return tr("%1 is FBX of version %2; versions from 7.1 on are read: save it as FBX 7 or GLB.").arg(where, token);
    case FileFault::OtherIfc:
        return tr("%1 is IFC of the schema %2; IFC2X3 is read: save it as that or as GLB.").arg(where, token);
    default:
        return {};
    }
}

QString FileFaultMessages::ofPackage(const core::FileError& error, const QString& where)
{
    const QString token = QString::fromLatin1(error.token);
    switch (error.fault) {
    case FileFault::OutsidePackage:
        return tr("%1: \"%2\" leads out of the package; nothing from elsewhere is read.").arg(where, token);
    case FileFault::NotInPackage:
        return tr("%1: the part \"%2\" is not in the package.").arg(where, token);
    case FileFault::NoModelPart:
        return tr("%1: \"%2\" should say where in the package the model is, but does not.").arg(where, token);
    case FileFault::PackedOtherwise:
        return tr("%1: the part \"%2\" is encrypted, or packed in a way that is not read.").arg(where, token);
    case FileFault::XmlSyntax:
        return tr("%1: the XML of the file is broken here: \"%2\".").arg(where, token);
    case FileFault::XmlDocumentType:
        return tr("%1: a document type is declared here, which models may not have.").arg(where);
    case FileFault::XmlTooDeep:
        return tr("%1: XML elements are nested too deeply here.").arg(where);
    case FileFault::XmlLongTag:
        return tr("%1: an XML tag is longer here than 1 MiB.").arg(where);
    default:
        return {};
    }
}
} // namespace ui
