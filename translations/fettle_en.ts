<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>app::BooleanCommand</name>
    <message numerus="yes">
        <source>boolean: needs two models or more; %n were given.</source>
        <translation>
            <numerusform>boolean: needs two models or more; %n was given.</numerusform>
            <numerusform>boolean: needs two models or more; %n were given.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::ClassEnd</name>
    <message numerus="yes">
        <source>%n models are not yet in the class folder.</source>
        <translation>
            <numerusform>%n model is not yet in the class folder.</numerusform>
            <numerusform>%n models are not yet in the class folder.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n models were copied to %1.</source>
        <translation>
            <numerusform>%n model was copied to %1.</numerusform>
            <numerusform>%n models were copied to %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::ClassFileController</name>
    <message numerus="yes">
        <source>%n models of a class are still on this computer.</source>
        <translation>
            <numerusform>%n model of a class is still on this computer.</numerusform>
            <numerusform>%n models of a class are still on this computer.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n models are still on this computer and not in %1.</source>
        <translation>
            <numerusform>%n model is still on this computer and not in %1.</numerusform>
            <numerusform>%n models are still on this computer and not in %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n models were moved to %1.</source>
        <translation>
            <numerusform>%n model was moved to %1.</numerusform>
            <numerusform>%n models were moved to %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::ClassroomMode</name>
    <message numerus="yes">
        <source>%n minutes left. Please finish soon.</source>
        <translation>
            <numerusform>%n minute left. Please finish soon.</numerusform>
            <numerusform>%n minutes left. Please finish soon.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::CommandLine</name>
    <message numerus="yes">
        <source>One file at a time can be opened, but %n were given; fettle --help says more.</source>
        <translation>
            <numerusform>One file at a time can be opened, but %n was given; fettle --help says more.</numerusform>
            <numerusform>One file at a time can be opened, but %n were given; fettle --help says more.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::ConvertCommand</name>
    <message numerus="yes">
        <source>convert: needs two files, IN and OUT; %n were given.</source>
        <translation>
            <numerusform>convert: needs two files, IN and OUT; %n was given.</numerusform>
            <numerusform>convert: needs two files, IN and OUT; %n were given.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::LessonProgress</name>
    <message numerus="yes">
        <source>You met %1 of %n goals.</source>
        <translation>
            <numerusform>You met %1 of %n goal.</numerusform>
            <numerusform>You met %1 of %n goals.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::LessonWriter</name>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>And %n more.</numerusform>
            <numerusform>And %n more.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::ReportCommand</name>
    <message numerus="yes">
        <source>report: needs one folder; %n were given.</source>
        <translation>
            <numerusform>report: needs one folder; %n was given.</numerusform>
            <numerusform>report: needs one folder; %n were given.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::TimeLapseController</name>
    <message numerus="yes">
        <source>%1: %Ln pictures were written.</source>
        <translation>
            <numerusform>%1: %Ln picture was written.</numerusform>
            <numerusform>%1: %Ln pictures were written.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ClassBar</name>
    <message numerus="yes">
        <source>%n minutes left</source>
        <translation>
            <numerusform>%n minute left</numerusform>
            <numerusform>%n minutes left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seconds left</source>
        <translation>
            <numerusform>%n second left</numerusform>
            <numerusform>%n seconds left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n models not yet in the class folder</source>
        <translation>
            <numerusform>%n model not yet in the class folder</numerusform>
            <numerusform>%n models not yet in the class folder</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ClassroomDialog</name>
    <message numerus="yes">
        <source>The PIN needs at least %n characters.</source>
        <translation>
            <numerusform>The PIN needs at least %n character.</numerusform>
            <numerusform>The PIN needs at least %n characters.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::InfoBar</name>
    <message numerus="yes">
        <source>%Ln vertices</source>
        <translation>
            <numerusform>%Ln vertex</numerusform>
            <numerusform>%Ln vertices</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::FileJobs</name>
    <message numerus="yes">
        <source>%Ln files are in the trash.</source>
        <translation>
            <numerusform>%Ln file is in the trash.</numerusform>
            <numerusform>%Ln files are in the trash.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::FileListModel</name>
    <message numerus="yes">
        <source>%Ln vertices</source>
        <translation>
            <numerusform>%Ln vertex</numerusform>
            <numerusform>%Ln vertices</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::FileBrowser</name>
    <message numerus="yes">
        <source>%Ln models</source>
        <translation>
            <numerusform>%Ln model</numerusform>
            <numerusform>%Ln models</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::HistoryPanel</name>
    <message numerus="yes">
        <source>%Ln dabs</source>
        <translation>
            <numerusform>%Ln dab</numerusform>
            <numerusform>%Ln dabs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln fusions</source>
        <translation>
            <numerusform>%Ln fusion</numerusform>
            <numerusform>%Ln fusions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ErrorMessages</name>
    <message numerus="yes">
        <source>%n objects are one model now</source>
        <translation>
            <numerusform>%n object is one model now</numerusform>
            <numerusform>%n objects are one model now</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::PinDialog</name>
    <message numerus="yes">
        <source>Too many wrong PINs. Try again in %n seconds.</source>
        <translation>
            <numerusform>Too many wrong PINs. Try again in %n second.</numerusform>
            <numerusform>Too many wrong PINs. Try again in %n seconds.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::PrintFindings</name>
    <message numerus="yes">
        <source>%Ln parts</source>
        <translation>
            <numerusform>%Ln part</numerusform>
            <numerusform>%Ln parts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::RecoveryBar</name>
    <message numerus="yes">
        <source>%Ln steps</source>
        <translation>
            <numerusform>%Ln step</numerusform>
            <numerusform>%Ln steps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::TimeLapseDialog</name>
    <message numerus="yes">
        <source>%Ln pictures</source>
        <translation>
            <numerusform>%Ln picture</numerusform>
            <numerusform>%Ln pictures</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::PresetLibrary</name>
    <message numerus="yes">
        <source>%n brush presets were left out. The first: %1</source>
        <comment>a sentence that says why</comment>
        <translation>
            <numerusform>%n brush preset was left out: %1</numerusform>
            <numerusform>%n brush presets were left out. The first: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::RepairMessages</name>
    <message numerus="yes">
        <source>%n open sheets left out, which enclose no space; the largest is %1 x %2 mm</source>
        <translation>
            <numerusform>%n open sheet left out, which encloses no space; it is %1 x %2 mm</numerusform>
            <numerusform>%n open sheets left out, which enclose no space; the largest is %1 x %2 mm</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cannot be repaired: it has %n open sheets that enclose no space, the largest %2 x %3 mm.</source>
        <translation>
            <numerusform>%1 cannot be repaired: it has only %n open sheet, of %2 x %3 mm, which encloses no space.</numerusform>
            <numerusform>%1 cannot be repaired: it has %n open sheets that enclose no space, the largest %2 x %3 mm.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::WaitingWorksDialog</name>
    <message numerus="yes">
        <source>%n models are not yet in the class folder.</source>
        <translation>
            <numerusform>%n model is not yet in the class folder.</numerusform>
            <numerusform>%n models are not yet in the class folder.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::CommandNames</name>
    <message numerus="yes">
        <source>The model stays as it is: it may have %Ln parts at most.</source>
        <translation>
            <numerusform>The model stays as it is: it may have %Ln part at most.</numerusform>
            <numerusform>The model stays as it is: it may have %Ln parts at most.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::ModelLoader</name>
    <message numerus="yes">
        <source>A repair makes one part of its %Ln objects.</source>
        <translation>
            <numerusform>A repair makes one part of its %Ln object.</numerusform>
            <numerusform>A repair makes one part of its %Ln objects.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 has more objects than a model may have parts (%Ln), so they are one part.</source>
        <translation>
            <numerusform>%1 has more objects than a model may have parts (%Ln), so they are one part.</numerusform>
            <numerusform>%1 has more objects than a model may have parts (%Ln), so they are one part.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ObjectsBar</name>
    <message numerus="yes">
        <source>%1 has %Ln objects. Each is a part now.</source>
        <translation>
            <numerusform>%1 has %Ln object. It is a part now.</numerusform>
            <numerusform>%1 has %Ln objects. Each is a part now.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 has %Ln objects. They are one part now.</source>
        <translation>
            <numerusform>%1 has %Ln object. It is one part now.</numerusform>
            <numerusform>%1 has %Ln objects. They are one part now.</numerusform>
        </translation>
    </message>
</context>
</TS>
