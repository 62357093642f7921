<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>app::BooleanCommand</name>
    <message>
        <source>Unites models, subtracts all others from the first, or keeps what all have in common. The models must be watertight. OUT keeps their place and is in mm. Status 1: nothing is left, or there is no sound result.</source>
        <translation>合并模型，从第一个模型中减去其余模型，或保留所有模型的公共部分。模型必须水密。OUT 保持原来的位置，单位为毫米。状态 1：没有剩余部分，或无法得到完好的结果。</translation>
    </message>
    <message>
        <source>The operation: one of %1.</source>
        <translation>运算：%1 之一。</translation>
    </message>
    <message>
        <source>The first model; or -.</source>
        <translation>第一个模型；或 -。</translation>
    </message>
    <message>
        <source>The other models; or -.</source>
        <translation>其余模型；或 -。</translation>
    </message>
    <message>
        <source>Axis that points up in the files that are read (default: z for STL, 3MF and AMF, y for others).</source>
        <translation>所读文件中朝上的轴（默认 STL、3MF 和 AMF 为 z，其他为 y）。</translation>
    </message>
    <message>
        <source>boolean: &quot;%1&quot; is not an operation: the operations are %2.</source>
        <translation>boolean：“%1”不是运算：可用的运算为 %2。</translation>
    </message>
    <message>
        <source>%1 Did you mean %2?</source>
        <translation>%1您是否想输入 %2？</translation>
    </message>
    <message>
        <source>boolean: the operation is missing: one of %1.</source>
        <translation>boolean：缺少运算：%1 之一。</translation>
    </message>
    <message>
        <source>%1 cannot be combined with others, because its surface does not bound a solid (%2). fettle convert --repair may make it watertight.</source>
        <translation>%1 无法与其他模型运算，因为其表面没有围成实体（%2）。用 fettle convert --repair 或许可以修复。</translation>
    </message>
    <message>
        <source>The models have no space in common. Nothing was written.</source>
        <translation>这些模型没有公共空间。未写入任何文件。</translation>
    </message>
    <message>
        <source>Nothing is left of %1. Nothing was written.</source>
        <translation>%1 没有任何剩余部分。未写入任何文件。</translation>
    </message>
    <message>
        <source>The models cannot be combined soundly: near (%1, %2, %3) mm faces lie so close to each other that they still meet after rounding. Move a model a little. Nothing was written.</source>
        <translation>无法得到完好的运算结果：在 (%1, %2, %3) 毫米附近，面与面过于接近，舍入后仍然相交。请稍微移动其中一个模型。未写入任何文件。</translation>
    </message>
    <message>
        <source>%1: %2 x %3 x %4 mm, triangles: %5, volume: %6.</source>
        <translation>%1：%2 x %3 x %4 毫米，三角形：%5，体积：%6。</translation>
    </message>
    <message numerus="yes">
        <source>boolean: needs two models or more; %n were given.</source>
        <translation>
            <numerusform>boolean：需要两个或更多模型，但指定了 %n 个。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::BrushExport</name>
    <message>
        <source>There is not enough memory to make a brush of this model.</source>
        <translation>内存不足，无法把这个模型做成笔刷。</translation>
    </message>
</context>
<context>
    <name>app::CheckCommand</name>
    <message>
        <source>%1 is watertight.</source>
        <translation>%1 是水密的。</translation>
    </message>
    <message>
        <source>file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>面数</translation>
    </message>
    <message>
        <source>size, mm</source>
        <translation>尺寸，mm</translation>
    </message>
    <message>
        <source>print-ready</source>
        <translation>可打印</translation>
    </message>
    <message>
        <source>One JSON object per file, each on its line.</source>
        <translation>每个文件一个 JSON 对象，各占一行。</translation>
    </message>
    <message>
        <source>wall, mm</source>
        <translation>壁厚，mm</translation>
    </message>
    <message>
        <source>overhang</source>
        <translation>悬垂</translation>
    </message>
    <message>
        <source>base, mm²</source>
        <translation>底面，mm²</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>放得下</translation>
    </message>
    <message>
        <source>it does not fit the bed</source>
        <translation>放不进打印床</translation>
    </message>
    <message>
        <source>%1 of its surface is thinner than %2 mm</source>
        <translation>%1 的表面薄于 %2 毫米</translation>
    </message>
    <message>
        <source>%1 of its surface overhangs by more than %2 degrees</source>
        <translation>%1 的表面悬垂超过 %2 度</translation>
    </message>
    <message>
        <source>it stands on a point or an edge</source>
        <translation>它只立在一个点或一条边上</translation>
    </message>
    <message>
        <source>%1 is watertight, but: %2.</source>
        <translation>%1 是水密的，但是：%2。</translation>
    </message>
    <message>
        <source>check: --bed must be three lengths in mm, as in 250,210,220, not &quot;%1&quot;.</source>
        <translation>check：--bed 必须是三个毫米长度，如 250,210,220，而不是“%1”。</translation>
    </message>
    <message>
        <source>Says whether models are closed, manifold, oriented, free of self-intersections, and bound a solid. Status 0: all are, whatever --print finds; 1: not all.</source>
        <translation>检查模型是否封闭、为流形、朝向一致、无自相交，并围成实体。状态 0：全部符合，不论 --print 的结果；1：并非全部符合。</translation>
    </message>
    <message>
        <source>Models, or folders of models; or -.</source>
        <translation>模型，或存放模型的文件夹；或 -。</translation>
    </message>
    <message>
        <source>CSV with a header row.</source>
        <translation>CSV，带表头。</translation>
    </message>
    <message>
        <source>Also measure wall thickness, overhangs and bed contact.</source>
        <translation>还测量壁厚、悬垂以及与打印床的接触。</translation>
    </message>
    <message>
        <source>Nozzle width in mm; walls should be two lines thick (default: 0.4).</source>
        <translation>喷嘴直径（毫米）；壁厚应为两条线宽（默认 0.4）。</translation>
    </message>
    <message>
        <source>Steepest overhang that prints without support, in degrees from the vertical (default: 45).</source>
        <translation>无需支撑即可打印的最大悬垂角，以偏离竖直方向的度数表示（默认 45）。</translation>
    </message>
    <message>
        <source>Width, depth and height of the printer&apos;s build volume, in mm (default: not checked).</source>
        <translation>打印机成型空间的宽、深、高，单位毫米（默认不检查）。</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>封闭</translation>
    </message>
    <message>
        <source>two faces at each edge</source>
        <translation>每条边有两个面</translation>
    </message>
    <message>
        <source>consistently oriented faces</source>
        <translation>面的朝向一致</translation>
    </message>
    <message>
        <source>bounds a solid</source>
        <translation>围成实体</translation>
    </message>
    <message>
        <source>self-intersections</source>
        <translation>自相交</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>部件</translation>
    </message>
    <message>
        <source>holes through it</source>
        <translation>贯通的孔</translation>
    </message>
    <message>
        <source>volume, mm³</source>
        <translation>体积，mm³</translation>
    </message>
    <message>
        <source>surface, mm²</source>
        <translation>表面积，mm²</translation>
    </message>
    <message>
        <source>shortest edge, mm</source>
        <translation>最短的边，mm</translation>
    </message>
    <message>
        <source>longest edge, mm</source>
        <translation>最长的边，mm</translation>
    </message>
    <message>
        <source>triangles without area</source>
        <translation>没有面积的三角形</translation>
    </message>
    <message>
        <source>still valid when opened</source>
        <translation>打开后仍然完好</translation>
    </message>
    <message>
        <source>strokes</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>working time, s</source>
        <translation>用时，秒</translation>
    </message>
    <message>
        <source>thinnest wall allowed, mm</source>
        <translation>允许的最薄壁厚，mm</translation>
    </message>
    <message>
        <source>thinnest wall, mm</source>
        <translation>最薄壁厚，mm</translation>
    </message>
    <message>
        <source>surface that is too thin</source>
        <translation>过薄的表面</translation>
    </message>
    <message>
        <source>surface that overhangs</source>
        <translation>悬垂的表面</translation>
    </message>
    <message>
        <source>fits the bed</source>
        <translation>放得进打印床</translation>
    </message>
    <message>
        <source>possible unit</source>
        <translation>可能的单位</translation>
    </message>
    <message>
        <source>pupil</source>
        <translation>学生</translation>
    </message>
    <message>
        <source>turn begun</source>
        <translation>本轮开始</translation>
    </message>
    <message>
        <source>time of the turn, s</source>
        <translation>本轮用时，秒</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
</context>
<context>
    <name>app::ClassEnd</name>
    <message>
        <source>End the class? The current pupil&apos;s work will be saved.</source>
        <translation>结束课堂？当前学生的作品会被保存。</translation>
    </message>
    <message>
        <source>End the class? It is nobody&apos;s turn, and all work is saved.</source>
        <translation>结束课堂？现在没有轮到任何人，所有作品都已保存。</translation>
    </message>
    <message numerus="yes">
        <source>%n models are not yet in the class folder.</source>
        <translation>
            <numerusform>%n 个模型尚未存入课堂文件夹。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n models were copied to %1.</source>
        <translation>
            <numerusform>已将 %n 个模型复制到 %1。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::ClassFileController</name>
    <message>
        <source>Saved %1.</source>
        <translation>已保存 %1。</translation>
    </message>
    <message>
        <source>A double click on %1 begins it, on every computer that has Fettle.</source>
        <translation>在任何装有 Fettle 的电脑上双击 %1 即可开始。</translation>
    </message>
    <message>
        <source>Classroom</source>
        <translation>课堂</translation>
    </message>
    <message>
        <source>Begin the class &quot;%1&quot; now?</source>
        <translation>现在开始课堂“%1”吗？</translation>
    </message>
    <message>
        <source>This window closes, and only the class is there. Leaving it asks for your PIN.</source>
        <translation>此窗口将关闭，只显示课堂。离开课堂需要输入您的 PIN。</translation>
    </message>
    <message>
        <source>&amp;Begin the Class Now</source>
        <translation>现在开始课堂(&amp;B)</translation>
    </message>
    <message>
        <source>C&amp;hange…</source>
        <translation>修改(&amp;H)…</translation>
    </message>
    <message>
        <source>&amp;Not Now</source>
        <translation>暂不(&amp;N)</translation>
    </message>
    <message numerus="yes">
        <source>%n models of a class are still on this computer.</source>
        <translation>
            <numerusform>有 %n 个课堂模型仍在本机。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n models are still on this computer and not in %1.</source>
        <translation>
            <numerusform>有 %n 个模型仍在本机，尚未存入 %1。</numerusform>
        </translation>
    </message>
    <message>
        <source>They go to the class folder when the class begins and its folder is there.</source>
        <translation>课堂开始且课堂文件夹可用时，它们会移到那里。</translation>
    </message>
    <message numerus="yes">
        <source>%n models were moved to %1.</source>
        <translation>
            <numerusform>已将 %n 个模型移到 %1。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::TurnAnswers</name>
    <message>
        <source>%1 is a link to a file that is not there.</source>
        <translation>%1 是链接，但它指向的文件不存在。</translation>
    </message>
    <message>
        <source>%1 was made by a newer version of Fettle.</source>
        <translation>%1 由较新版本的 Fettle 创建。</translation>
    </message>
    <message>
        <source>%1 contains no answers that can be read.</source>
        <translation>%1 中没有可读取的回答。</translation>
    </message>
    <message>
        <source>%1: the answer &quot;%2&quot; is left out, because it is not a whole number from %3 to %4.</source>
        <translation>%1：回答“%2”已略过，因为它不是 %3 到 %4 的整数。</translation>
    </message>
</context>
<context>
    <name>app::WorkArchive</name>
    <message>
        <source>%1: there is not enough memory to write this model.</source>
        <translation>%1：内存不足，无法写入此模型。</translation>
    </message>
</context>
<context>
    <name>app::ClassFile</name>
    <message>
        <source>%1 could not be started.</source>
        <translation>无法启动 %1。</translation>
    </message>
    <message>
        <source>%1 cannot be read (%2).</source>
        <translation>无法读取 %1（%2）。</translation>
    </message>
    <message>
        <source>%1 is not a class file: it is not UTF-8 text, or it is too long.</source>
        <translation>%1 不是课堂文件：它不是 UTF-8 文本，或者太长。</translation>
    </message>
    <message>
        <source>each line must be key = value, or begin with #.</source>
        <translation>每一行应为“键 = 值”，或以 # 开头。</translation>
    </message>
    <message>
        <source>%1 appears twice.</source>
        <translation>%1 重复出现。</translation>
    </message>
    <message>
        <source>%1: %2 is missing.</source>
        <translation>%1：缺少 %2。</translation>
    </message>
    <message>
        <source>it is empty.</source>
        <translation>内容为空。</translation>
    </message>
    <message>
        <source>must be a whole number from 0 to %2, not &quot;%1&quot;.</source>
        <translation>必须是 0 到 %2 的整数，而不是“%1”。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none of %2.</source>
        <translation>“%1”不在以下之列：%2。</translation>
    </message>
    <message>
        <source>%1 is not a key of a class file.</source>
        <translation>%1 不是课堂文件的键。</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1，第 %2 行：%3</translation>
    </message>
    <message>
        <source># A class for Fettle. It begins with: fettle --classroom and the name of this file.</source>
        <translation># Fettle 的课堂。启动方式：fettle --classroom 加上此文件的名称。</translation>
    </message>
    <message>
        <source>this is not a PIN as Fettle writes it; set one with Edit › Classroom.</source>
        <translation>这不是 Fettle 生成的 PIN；请在“编辑 › 课堂”中设置。</translation>
    </message>
    <message>
        <source>there are no names to choose from.</source>
        <translation>没有可供选择的名字。</translation>
    </message>
    <message>
        <source>at most %1 names of at most %2 characters.</source>
        <translation>最多 %1 个名字，每个最多 %2 个字符。</translation>
    </message>
    <message>
        <source>%1 is not a lesson: it is neither one of %2 nor a folder or ZIP file.</source>
        <translation>%1 不是课程：既不是 %2 之一，也不是文件夹或 ZIP 文件。</translation>
    </message>
    <message>
        <source>Step %1 of the lesson needs the tool %2 (%3), which is not among the class&apos;s tools.</source>
        <translation>课程的第 %1 步需要工具 %2（%3），但课堂的工具中没有它。</translation>
    </message>
</context>
<context>
    <name>app::ClassLesson</name>
    <message>
        <source>Opening %1</source>
        <translation>正在打开 %1</translation>
    </message>
</context>
<context>
    <name>app::ClassWork</name>
    <message>
        <source>%1 Until then they are in %2.</source>
        <translation>%1 在此之前它们位于 %2。</translation>
    </message>
    <message>
        <source>The class folder cannot be reached. The work is saved on this computer and will be moved there as soon as possible.</source>
        <translation>无法访问课堂文件夹。作品已保存在本机，并会尽快移到那里。</translation>
    </message>
</context>
<context>
    <name>app::ClassroomMode</name>
    <message>
        <source>somebody</source>
        <translation>某人</translation>
    </message>
    <message>
        <source>Saving the work of %1</source>
        <translation>正在保存 %1 的作品</translation>
    </message>
    <message>
        <source>Please wait: another operation on the model is still running.</source>
        <translation>请稍候：模型正在进行其他操作。</translation>
    </message>
    <message>
        <source>%1 The work of %2 stays open; nothing is lost.</source>
        <translation>%1 %2 的作品保持打开，不会丢失任何内容。</translation>
    </message>
    <message>
        <source>Time is up. Please finish: it is the next pupil&apos;s turn.</source>
        <translation>时间到了。请完成手头的操作，接下来轮到下一位同学。</translation>
    </message>
    <message numerus="yes">
        <source>%n minutes left. Please finish soon.</source>
        <translation>
            <numerusform>还剩 %n 分钟：请准备结束。</numerusform>
        </translation>
    </message>
    <message>
        <source>Opening the work of %1</source>
        <translation>正在打开 %1 的作品</translation>
    </message>
</context>
<context>
    <name>app::CommandLine</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>内存不足，无法完成。</translation>
    </message>
    <message numerus="yes">
        <source>One file at a time can be opened, but %n were given; fettle --help says more.</source>
        <translation>
            <numerusform>一次只能打开一个文件，但指定了 %n 个；详见 fettle --help。</numerusform>
        </translation>
    </message>
    <message>
        <source>The answer cannot be written to the standard output (%1).</source>
        <translation>无法将结果写入标准输出（%1）。</translation>
    </message>
    <message>
        <source>--classroom needs the file of a class, which Edit › Classroom writes.</source>
        <translation>--classroom 需要课堂文件，可在“编辑 › 课堂”中生成。</translation>
    </message>
    <message>
        <source>%1 cannot be opened in a class, which begins with its own models.</source>
        <translation>课堂中无法打开 %1：课堂使用自己的起始模型。</translation>
    </message>
    <message>
        <source>write a starting shape: a ball, a cube, a vase and others</source>
        <translation>生成一个起始形状：球、立方体、花瓶等</translation>
    </message>
    <message>
        <source>check whether models are watertight and will print; several files or a folder: a table</source>
        <translation>检查模型是否水密、能否打印；多个文件或文件夹则输出表格</translation>
    </message>
    <message>
        <source>write a model in another format or size, repaired, or with fewer triangles</source>
        <translation>以其他格式或尺寸输出模型，可修复，也可减少三角形</translation>
    </message>
    <message>
        <source>unite models, subtract them from the first, or keep what they share</source>
        <translation>合并模型，从第一个模型中减去其余模型，或保留公共部分</translation>
    </message>
    <message>
        <source>play recorded strokes on a model</source>
        <translation>在模型上回放录制的笔画</translation>
    </message>
    <message>
        <source>write a class report: picture, size, print-ready or why not, strokes and time of each model</source>
        <translation>生成班级报告：每个模型的图片、大小、能否打印或为何不能、笔画数和用时</translation>
    </message>
    <message>
        <source>draw models or folders of models to scale, a page each</source>
        <translation>按比例绘制模型或文件夹中的模型，每个模型一页</translation>
    </message>
    <message>
        <source>check a lesson by playing it to its end, or a pupil&apos;s model by one of its steps</source>
        <translation>把课程播放到底以检查它，或按其中一步评判学生的模型</translation>
    </message>
    <message>
        <source>show what a brush preset contains, or why it is invalid</source>
        <translation>显示笔刷预设的内容，或说明其为何无效</translation>
    </message>
    <message>
        <source>There is no command &quot;%1&quot;: the commands are %2.</source>
        <translation>没有命令“%1”：可用命令为 %2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an option.</source>
        <translation>“%1”不是选项。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a command nor a file.</source>
        <translation>“%1”既不是命令，也不是文件。</translation>
    </message>
    <message>
        <source>%1 See fettle --help.</source>
        <translation>%1请参阅 fettle --help。</translation>
    </message>
    <message>
        <source>%1 Did you mean %2? See fettle --help.</source>
        <translation>%1您是否想输入 %2？请参阅 fettle --help。</translation>
    </message>
    <message>
        <source>%1: cannot tell the format: the ending must be one of %2.</source>
        <translation>%1：无法判断格式：扩展名必须是 %2 之一。</translation>
    </message>
    <message>
        <source>Fettle sculpts closed models that stay ready to print.

  fettle [--vr] [FILE]             open the window, with a model or with a ball of clay; --vr enters VR with it
  fettle --vr-simulator [FILE]     the same without a headset: a window stands in for it; mouse and keyboard move head and controllers
  fettle [--vr] --classroom CLASS.fettleclass
                                   start a class session, as its teacher set it up (Edit &gt; Classroom)
</source>
        <translation>Fettle 用于雕刻封闭模型，并使其始终可以打印。

  fettle [--vr] [FILE]             打开窗口，载入模型或一个黏土球；--vr 同时进入 VR
  fettle --vr-simulator [FILE]     同上，但不需要头显：由一个窗口显示画面，鼠标和键盘充当头部和手柄
  fettle [--vr] --classroom CLASS.fettleclass
                                   按教师的设置开始课堂（编辑 &gt; 课堂）
</translation>
    </message>
    <message>
        <source>  fettle help COMMAND              show the options of one of them
  fettle --version                 show the version, and those of the libraries

Formats: %1. Lengths are in millimetres. The file - is the standard input or output.
Status: 0 done, 1 the answer is no, 2 bad input or usage (with a line on standard error).
</source>
        <translation>  fettle help COMMAND              显示以上某一命令的选项
  fettle --version                 显示版本，包括各个库的版本

格式：%1。长度单位为毫米。文件 - 表示标准输入或标准输出。
状态：0 完成，1 结果为否，2 输入或用法有误（标准错误输出一行说明）。
</translation>
    </message>
    <message>
        <source>MIT License: free to use, change and pass on, without warranty</source>
        <translation>MIT 许可证：可自由使用、修改和分发，不提供担保</translation>
    </message>
</context>
<context>
    <name>app::CommandModels</name>
    <message>
        <source>%1: no file was given.</source>
        <translation>%1：未指定文件。</translation>
    </message>
</context>
<context>
    <name>app::CommandUnit</name>
    <message>
        <source>Unit of the files that are read (default: mm).</source>
        <translation>所读文件的单位（默认 mm）。</translation>
    </message>
</context>
<context>
    <name>app::ConvertCommand</name>
    <message>
        <source>%1 could be reduced to %2 triangles, not to %3: its holes and parts need at least %4. Nothing was written.</source>
        <translation>%1 可以减少到 %2 个三角形，但不能减少到 %3 个：其孔洞和部件至少需要 %4 个。未写入任何内容。</translation>
    </message>
    <message>
        <source>%1 could be reduced to %2 triangles, not to %3: with fewer, no surface was found that keeps its holes open and does not intersect itself. Nothing was written.</source>
        <translation>%1 可以减少到 %2 个三角形，但不能减少到 %3 个：再少就找不到既保持孔洞敞开又不自相交的表面。未写入任何内容。</translation>
    </message>
    <message>
        <source>--repair may make it watertight.</source>
        <translation>用 --repair 或许可以使其水密。</translation>
    </message>
    <message>
        <source>--wrap may make a new surface.</source>
        <translation>用 --wrap 或许可以重新生成表面。</translation>
    </message>
    <message>
        <source>Writes a model in another format, unit or size. OUT is in mm.</source>
        <translation>以其他格式、单位或尺寸输出模型。OUT 以毫米为单位。</translation>
    </message>
    <message>
        <source>The model to read; or -.</source>
        <translation>要读取的模型；或 -。</translation>
    </message>
    <message>
        <source>The file to write, in the format of its ending; or -.</source>
        <translation>要写入的文件，格式由扩展名决定；或 -。</translation>
    </message>
    <message>
        <source>Length of the longest side in mm (default: as it is).</source>
        <translation>最长边的长度，单位毫米（默认保持原样）。</translation>
    </message>
    <message>
        <source>Axis of IN that points up (default: z for STL, 3MF and AMF, y for others).</source>
        <translation>IN 中朝上的轴（默认 STL、3MF 和 AMF 为 z，其他为 y）。</translation>
    </message>
    <message>
        <source>Most triangles of OUT, 4 or more (default: as many as it has). They are removed where shape and colours change least.</source>
        <translation>OUT 的三角形上限，不少于 4 个（默认保持原数）。在形状和颜色变化最小处减少。</translation>
    </message>
    <message>
        <source>Repair a model that is not watertight, and say what changed.</source>
        <translation>修复不水密的模型，并说明改动了什么。</translation>
    </message>
    <message>
        <source>With --repair: make a new surface if the model cannot be kept otherwise; detail is lost.</source>
        <translation>与 --repair 一起使用：别无他法时重新生成表面；会丢失细节。</translation>
    </message>
    <message>
        <source>With --repair: what to do with holes longer than a quarter of the model (default: fill).</source>
        <translation>与 --repair 一起使用：如何处理长于模型四分之一的孔洞（默认 fill）。</translation>
    </message>
    <message>
        <source>With --repair: what to do with parts inside of others that face outwards (default: fill).</source>
        <translation>与 --repair 一起使用：如何处理位于其他部件内部且朝外的部件（默认 fill）。</translation>
    </message>
    <message>
        <source>Move the middle of the model to the origin.</source>
        <translation>将模型的中心移到原点。</translation>
    </message>
    <message>
        <source>--recentre does that.</source>
        <translation>可使用 --recentre。</translation>
    </message>
    <message numerus="yes">
        <source>convert: needs two files, IN and OUT; %n were given.</source>
        <translation>
            <numerusform>convert：需要 IN 和 OUT 两个文件，但指定了 %n 个。</numerusform>
        </translation>
    </message>
    <message>
        <source>Make a part of each object of IN; parts may overlap.</source>
        <translation>使 IN 的每个对象成为一个部件；部件可以重叠。</translation>
    </message>
    <message>
        <source>What to do with parts that overlap if OUT is STL, PLY, OFF or 3MF (default: unite).</source>
        <translation>OUT 为 STL、PLY、OFF 或 3MF 时如何处理重叠的部件（默认：unite）。</translation>
    </message>
    <message>
        <source>--parts keeps its objects apart, which may overlap then; --repair may make it watertight.</source>
        <translation>--parts 使其对象保持分开，此时可以重叠；--repair 可能使其水密。</translation>
    </message>
    <message>
        <source>%1: all its parts are hidden, and only GLB keeps hidden parts. Nothing was written.</source>
        <translation>%1：所有部件都已隐藏，只有 GLB 保留隐藏的部件。未写入任何内容。</translation>
    </message>
    <message>
        <source>%1: its parts overlap and cannot be united. --overlaps keep writes them as they are.</source>
        <translation>%1：其部件重叠且无法合并。--overlaps keep 会按原样写入。</translation>
    </message>
    <message>
        <source>The parts overlap, so they were united.</source>
        <translation>部件重叠，因此已合并。</translation>
    </message>
</context>
<context>
    <name>app::Document</name>
    <message>
        <source>The earlier steps can no longer be undone: their file on disk cannot be read. The model itself is intact.</source>
        <translation>无法再撤销更早的步骤：磁盘上的步骤文件无法读取。模型本身完好。</translation>
    </message>
    <message>
        <source>Sculpting is paused until the model is ready.</source>
        <translation>模型处理完成之前暂停雕刻。</translation>
    </message>
    <message>
        <source>Apply or cancel the preview before you sculpt on.</source>
        <translation>请先应用或取消预览，再继续雕刻。</translation>
    </message>
</context>
<context>
    <name>app::DrawingWorker</name>
    <message>
        <source>Saved %1.</source>
        <translation>已保存 %1。</translation>
    </message>
</context>
<context>
    <name>app::HandoutSaving</name>
    <message>
        <source>Saved %1.</source>
        <translation>已保存 %1。</translation>
    </message>
</context>
<context>
    <name>app::Headset</name>
    <message>
        <source>Leaving VR…</source>
        <translation>正在离开 VR…</translation>
    </message>
    <message>
        <source>Somebody is sculpting in the headset: your turn comes when that stroke has ended.</source>
        <translation>有人正在头显中雕刻：这一笔结束后就轮到您。</translation>
    </message>
</context>
<context>
    <name>app::HeadsetController</name>
    <message>
        <source>%1 You can repair it in the window.</source>
        <translation>%1 您可以在窗口中修复它。</translation>
    </message>
</context>
<context>
    <name>app::RuntimeProbe</name>
    <message>
        <source>The headset&apos;s program does not answer. If it is not just starting, restart it.</source>
        <translation>头显程序没有响应。如果它不是正在启动，请重新启动它。</translation>
    </message>
</context>
<context>
    <name>app::HeadsetRequests</name>
    <message>
        <source>Apply or cancel the preview first.</source>
        <translation>请先应用或取消预览。</translation>
    </message>
    <message>
        <source>The model was not restored: another operation on it is still running.</source>
        <translation>模型未重置：模型正在进行其他操作。</translation>
    </message>
    <message>
        <source>The model was not saved: another operation on it is still running.</source>
        <translation>模型未保存：模型正在进行其他操作。</translation>
    </message>
    <message>
        <source>%1 was not opened: another operation on the model is still running.</source>
        <translation>未打开 %1：模型正在进行其他操作。</translation>
    </message>
    <message>
        <source>%1 was not opened: the current model has unsaved changes.</source>
        <translation>未打开 %1：当前模型有未保存的更改。</translation>
    </message>
    <message>
        <source>This tool is not available in this class.</source>
        <translation>本课堂不提供此工具。</translation>
    </message>
    <message>
        <source>In a class, Next Pupil saves the work, in the window.</source>
        <translation>在课堂中，请在窗口里按“下一位”保存作品。</translation>
    </message>
    <message>
        <source>%1 was not opened: during a class, only its starting models can be used.</source>
        <translation>未打开 %1：上课时只能使用课堂的起始模型。</translation>
    </message>
    <message>
        <source>The mask was not changed: another operation on the model is still running.</source>
        <translation>遮罩未更改：模型正在进行其他操作。</translation>
    </message>
    <message>
        <source>The parts were not changed: another operation on the model is still running.</source>
        <translation>部件未更改：模型正在进行其他操作。</translation>
    </message>
</context>
<context>
    <name>app::RecoveryStore</name>
    <message>
        <source>Fettle was ended from outside. The changes to %1 are kept; the next start offers them.</source>
        <translation>Fettle 被外部终止。对 %1 的更改已保留，下次启动时可以恢复。</translation>
    </message>
    <message>
        <source>Changes are not being recorded, so save often: %1</source>
        <translation>更改未被记录，请经常保存：%1</translation>
    </message>
    <message>
        <source>%1 cannot be recovered: its recording is damaged.</source>
        <translation>无法恢复 %1：其记录已损坏。</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this model.</source>
        <translation>%1：内存不足，无法载入此模型。</translation>
    </message>
    <message>
        <source>The recording of an unsaved model is damaged and cannot be opened. It is in %1.</source>
        <translation>某个未保存模型的记录已损坏，无法打开。它位于 %1。</translation>
    </message>
    <message>
        <source>The recording of %1 is damaged and cannot be opened. It is in %2.</source>
        <translation>%1 的记录已损坏，无法打开。它位于 %2。</translation>
    </message>
    <message>
        <source>Part of the recording of %1 is damaged: its last steps may be missing. It is in %2.</source>
        <translation>%1 的部分记录已损坏，最后几步可能缺失。它位于 %2。</translation>
    </message>
    <message>
        <source>The disk is slow: a power cut could cost the changes of the last %1 seconds.</source>
        <translation>磁盘较慢：断电可能会丢失最近 %1 秒内的更改。</translation>
    </message>
    <message>
        <source>Changes are being recorded again.</source>
        <translation>已恢复记录更改。</translation>
    </message>
</context>
<context>
    <name>app::LessonCommand</name>
    <message>
        <source>Plays a lesson to its end and says whether each step meets its checkpoint. Status 0: all do; 1: not all. Without a lesson: lists those of the program.</source>
        <translation>把课程播放到底，并检查每一步是否达到检查点。状态 0：全部达到；1：未全部达到。不指定课程时：列出自带的课程。</translation>
    </message>
    <message>
        <source>A folder or a zip, or the name of a lesson of the program.</source>
        <translation>文件夹、ZIP 文件，或自带课程的名称。</translation>
    </message>
    <message>
        <source>lesson: %1 does not end in .zip.</source>
        <translation>lesson：%1 不以 .zip 结尾。</translation>
    </message>
    <message>
        <source>lesson: %1 must be a folder, but ends in .zip.</source>
        <translation>lesson：%1 必须是文件夹，但以 .zip 结尾。</translation>
    </message>
    <message>
        <source>lesson: one lesson at a time can be played, not %1 as well.</source>
        <translation>lesson：一次只能播放一个课程，不能再加上 %1。</translation>
    </message>
    <message>
        <source>lesson: no lesson was given.</source>
        <translation>lesson：未指定课程。</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>%1. %2 (strokes: %3; tools: %4)</source>
        <translation>%1. %2（笔画：%3；工具：%4）</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>%1: this picture cannot be written.</source>
        <translation>%1：无法写入这张图片。</translation>
    </message>
    <message>
        <source>lesson: there is no step %1: the last one is %2.</source>
        <translation>lesson：没有第 %1 步：最后一步是第 %2 步。</translation>
    </message>
    <message>
        <source>lesson: step %1 has no checkpoint.</source>
        <translation>lesson：第 %1 步没有检查点。</translation>
    </message>
    <message>
        <source>Language of the lesson and of the answer (default: the system&apos;s).</source>
        <translation>课程和输出的语言（默认为系统语言）。</translation>
    </message>
    <message>
        <source>Print what pupils read, instead of playing.</source>
        <translation>输出学生看到的文字，而不播放。</translation>
    </message>
    <message>
        <source>Judge this model of a pupil instead of playing; or -. A folder, or a class&apos;s work folder: judge each model.</source>
        <translation>评判学生的这个模型，而不播放；或 -。若为文件夹或课堂的作品文件夹：评判每个模型。</translation>
    </message>
    <message>
        <source>Step whose checkpoint judges the model, from 1 (default: the last).</source>
        <translation>按哪一步的检查点评判，从 1 开始（默认最后一步）。</translation>
    </message>
    <message>
        <source>File for the whole lesson, if all is well.</source>
        <translation>一切正常时，保存整个课程的文件。</translation>
    </message>
    <message>
        <source>Folder for the lesson, where it can be changed.</source>
        <translation>保存课程的文件夹，可在其中修改。</translation>
    </message>
    <message>
        <source>Folder for a picture of the result of each step, step-1.png and so on.</source>
        <translation>保存每一步结果图片的文件夹，step-1.png 等。</translation>
    </message>
    <message>
        <source>File for the model that the last step leaves.</source>
        <translation>保存最后一步之后的模型的文件。</translation>
    </message>
    <message>
        <source>JSON: one object; of a folder of models, one for each, on a line of its own; without a lesson, the list of the program&apos;s.</source>
        <translation>JSON：一个对象；若为模型文件夹，则每个模型一个，各占一行；不指定课程时，为自带课程的列表。</translation>
    </message>
    <message>
        <source>CSV with a header row: a row for each goal; of a folder, for each model.</source>
        <translation>CSV，带表头：每个目标一行；若为文件夹，则每个模型一行。</translation>
    </message>
    <message>
        <source>%1 is not a folder.</source>
        <translation>%1 不是文件夹。</translation>
    </message>
    <message>
        <source>lesson: &quot;%1&quot; is not a lesson: it is neither one of %2 nor a folder or ZIP file.</source>
        <translation>lesson：“%1”不是课程：既不是 %2 之一，也不是文件夹或 ZIP 文件。</translation>
    </message>
    <message>
        <source>no goal</source>
        <translation>没有目标</translation>
    </message>
    <message>
        <source>File for a handout: what pupils read, with the pictures; instead of playing.</source>
        <translation>保存讲义的文件：学生阅读的文字和图片；不播放。</translation>
    </message>
    <message>
        <source>lesson: %1 does not end in .pdf.</source>
        <translation>lesson：%1 不以 .pdf 结尾。</translation>
    </message>
</context>
<context>
    <name>app::LessonController</name>
    <message>
        <source>Opening %1</source>
        <translation>正在打开 %1</translation>
    </message>
    <message>
        <source>Step %1 is not done yet. You can go back, or start from the teacher&apos;s model.</source>
        <translation>第 %1 步还没有完成。可以返回，也可以从老师的模型开始。</translation>
    </message>
    <message>
        <source>This is the teacher&apos;s model. Press Try It and make your own.</source>
        <translation>这是老师的模型。请按“试一试”，自己做一个。</translation>
    </message>
</context>
<context>
    <name>app::LessonEditorController</name>
    <message>
        <source>Undone: a lesson cannot contain images or models from other files.</source>
        <translation>已撤销：课程不能包含其他文件中的图片或模型。</translation>
    </message>
    <message>
        <source>The model is too large for a lesson.</source>
        <translation>模型太大，不能用于课程。</translation>
    </message>
    <message>
        <source>Preparing the lesson</source>
        <translation>正在准备课程</translation>
    </message>
    <message>
        <source>Please wait: another operation on the model is still running.</source>
        <translation>请稍候：模型正在进行其他操作。</translation>
    </message>
    <message>
        <source>Playing the lesson to its end</source>
        <translation>正在把课程播放到底</translation>
    </message>
    <message>
        <source>Unsaved lesson</source>
        <translation>未保存的课程</translation>
    </message>
    <message>
        <source>The lesson has unsaved changes.</source>
        <translation>课程有未保存的更改。</translation>
    </message>
    <message>
        <source>An unsaved lesson was kept: Sculpt &gt; Record Lesson lists it.</source>
        <translation>未保存的课程已保留：可在“雕刻 &gt; 录制课程”中找到。</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>未保存：%1</translation>
    </message>
    <message>
        <source>New Lesson</source>
        <translation>新课程</translation>
    </message>
</context>
<context>
    <name>app::LessonProgress</name>
    <message numerus="yes">
        <source>You met %1 of %n goals.</source>
        <translation>
            <numerusform>%n 个目标中你达成了 %1 个。</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep sculpting, export your model, or save the steps as a handout.</source>
        <translation>你可以继续雕刻、导出模型，或把步骤存成讲义。</translation>
    </message>
    <message>
        <source>Keep sculpting, if you like.</source>
        <translation>想的话，可以继续雕刻。</translation>
    </message>
    <message>
        <source>Well done!</source>
        <translation>做得好！</translation>
    </message>
    <message>
        <source>That was the last step</source>
        <translation>这是最后一步了</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <comment>step: goals met of goals</comment>
        <translation>%1：%3 个中的 %2 个</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>two sentences</comment>
        <extracomment>%1: how many of them</extracomment>
        <translation>%1%2</translation>
    </message>
</context>
<context>
    <name>app::LessonResult</name>
    <message>
        <source>Lesson %1: step %2 of %3</source>
        <translation>课程 %1：第 %2 步，共 %3 步</translation>
    </message>
    <message>
        <source>this is the teacher&apos;s model</source>
        <translation>这是老师的模型</translation>
    </message>
</context>
<context>
    <name>app::LessonSaving</name>
    <message>
        <source>The lesson has no title yet.</source>
        <translation>课程还没有标题。</translation>
    </message>
    <message>
        <source>The lesson has no steps yet.</source>
        <translation>课程还没有步骤。</translation>
    </message>
    <message>
        <source>Step %1 has no title yet.</source>
        <translation>第 %1 步还没有标题。</translation>
    </message>
    <message>
        <source>Step %1 has no text yet.</source>
        <translation>第 %1 步还没有文字。</translation>
    </message>
    <message>
        <source>Step %1, stroke %2 (%3) no longer changes anything.</source>
        <translation>第 %1 步的第 %2 笔（%3）不再有任何作用。</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <extracomment>a stroke&apos;s tool and radius</extracomment>
        <translation>%1，%2 mm</translation>
    </message>
    <message>
        <source>When replayed, the lesson does not end with the model in the window.</source>
        <translation>重新播放后，课程的结果与窗口中的模型不同。</translation>
    </message>
    <message>
        <source>%1 already exists. Choose another name for the lesson&apos;s folder.</source>
        <translation>%1 已存在。请为课程文件夹另选名称。</translation>
    </message>
    <message>
        <source>Step %1 is not met: %2.</source>
        <extracomment>a step&apos;s number; what it asks for, and what the teacher&apos;s own model has</extracomment>
        <translation>第 %1 步未达到：%2。</translation>
    </message>
</context>
<context>
    <name>app::LessonMessages</name>
    <message>
        <source>%1: %2</source>
        <comment>file: reason</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2: %3</source>
        <comment>file: place: reason</comment>
        <translation>%1：%2：%3</translation>
    </message>
    <message>
        <source>step %1 (steps[%2])</source>
        <extracomment>counted from 1; in brackets as in the file, counted from 0</extracomment>
        <translation>第 %1 步 (steps[%2])</translation>
    </message>
    <message>
        <source>line %1, byte %2</source>
        <translation>第 %1 行，第 %2 字节</translation>
    </message>
    <message>
        <source>its lesson.json is not a lesson of Fettle</source>
        <translation>其中的 lesson.json 不是 Fettle 课程</translation>
    </message>
    <message>
        <source>this lesson was made for a newer version of the program (format %1; this one reads format 1)</source>
        <translation>该课程是为较新版本的程序制作的（格式 %1；本程序读取格式 1）</translation>
    </message>
    <message>
        <source>its lesson.json is not JSON</source>
        <translation>其中的 lesson.json 不是 JSON</translation>
    </message>
    <message>
        <source>its lesson.json nests deeper than a lesson does</source>
        <translation>其中的 lesson.json 嵌套得比课程更深</translation>
    </message>
    <message>
        <source>&quot;%1&quot; appears twice</source>
        <translation>“%1”重复出现</translation>
    </message>
    <message>
        <source>unknown key %1</source>
        <translation>未知的键 %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing</source>
        <translation>缺少“%1”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must contain texts by language, as in {&quot;en&quot;: &quot;A mug&quot;}</source>
        <translation>“%1”必须按语言给出文字，例如 {&quot;zh&quot;: &quot;杯子&quot;}</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of steps, as in [{…}, {…}]</source>
        <translation>“%1”必须是步骤的列表，例如 [{…}, {…}]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of tools, as in [&quot;pull&quot;, &quot;smooth&quot;]</source>
        <translation>“%1”必须是工具的列表，例如 [&quot;pull&quot;, &quot;smooth&quot;]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must contain goals, as in {&quot;height_mm&quot;: {&quot;least&quot;: 60}}</source>
        <translation>“%1”必须含有目标，例如 {&quot;height_mm&quot;: {&quot;least&quot;: 60}}</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be angles, as in {&quot;yaw_deg&quot;: 75, &quot;pitch_deg&quot;: -25}</source>
        <translation>“%1”必须是角度，例如 {&quot;yaw_deg&quot;: 75, &quot;pitch_deg&quot;: -25}</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must contain a distance, as in {&quot;tolerance_mm&quot;: 2}</source>
        <translation>“%1”必须含有距离，例如 {&quot;tolerance_mm&quot;: 2}</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a name in quotation marks</source>
        <translation>“%1”必须是引号中的名称</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a whole number</source>
        <translation>“%1”必须是整数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a number</source>
        <translation>“%1”必须是一个数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be true</source>
        <translation>“%1”必须是 true</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a whole number or a range, such as {&quot;least&quot;: 1, &quot;most&quot;: 2}</source>
        <translation>“%1”必须是整数，或范围，例如 {&quot;least&quot;: 1, &quot;most&quot;: 2}</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a number or a range, such as {&quot;least&quot;: 1, &quot;most&quot;: 2}</source>
        <translation>“%1”必须是一个数，或范围，例如 {&quot;least&quot;: 1, &quot;most&quot;: 2}</translation>
    </message>
    <message>
        <source>unknown value, %1</source>
        <translation>未知的值 %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range, %2 to %3</source>
        <translation>“%1”超出范围（%2 至 %3）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no text in some language</source>
        <translation>“%1”缺少某种语言的文字</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too long: at most %2 of text are read</source>
        <translation>“%1”太长：最多读取 %2 的文字</translation>
    </message>
    <message>
        <source>it contains too many files: at most %1 are allowed</source>
        <translation>其中的文件太多：最多允许 %1 个</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has too many entries: at most %2 are read</source>
        <translation>“%1”的条目太多：最多读取 %2 个</translation>
    </message>
    <message>
        <source>it refers to a file that is outside of its folder, or whose name is not allowed: %1</source>
        <translation>它引用的文件在其文件夹之外，或文件名不被允许：%1</translation>
    </message>
    <message>
        <source>it has no lesson.json: a lesson is a folder or ZIP file that contains one</source>
        <translation>其中没有 lesson.json：课程是包含该文件的文件夹或 ZIP 文件</translation>
    </message>
    <message>
        <source>this file is missing</source>
        <translation>缺少此文件</translation>
    </message>
    <message>
        <source>this is too large for a lesson: at most %1 are read</source>
        <translation>对课程来说太大：最多读取 %1</translation>
    </message>
    <message>
        <source>this is not a PNG or JPEG picture</source>
        <translation>这不是 PNG 或 JPEG 图片</translation>
    </message>
    <message>
        <source>the strokes of a lesson cannot need other images or models</source>
        <translation>课程的笔画不能使用其他图片或模型</translation>
    </message>
    <message>
        <source>this command would break the model that it is applied to</source>
        <translation>此命令会损坏它所作用的模型</translation>
    </message>
    <message>
        <source>ready to print</source>
        <translation>可以打印</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>from; to</comment>
        <translation>%1 到 %2</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>最多 %1</translation>
    </message>
    <message>
        <source>no holes</source>
        <translation>没有孔洞</translation>
    </message>
    <message>
        <source>one hole</source>
        <translation>一个孔洞</translation>
    </message>
    <message>
        <source>holes: %1</source>
        <translation>孔洞：%1</translation>
    </message>
    <message>
        <source>in one piece</source>
        <translation>连成一整块</translation>
    </message>
    <message>
        <source>pieces: %1</source>
        <translation>块数：%1</translation>
    </message>
    <message>
        <source>%1 tall</source>
        <extracomment>%1 as in &quot;at least 60 mm&quot;, as in all that follow</extracomment>
        <translation>高度%1</translation>
    </message>
    <message>
        <source>%1 wide</source>
        <translation>宽度%1</translation>
    </message>
    <message>
        <source>%1 deep</source>
        <translation>深度%1</translation>
    </message>
    <message>
        <source>%1 long, seen from above</source>
        <translation>从上面看最长处%1</translation>
    </message>
    <message>
        <source>legs on the ground: %1</source>
        <translation>着地的腿：%1</translation>
    </message>
    <message>
        <source>flat base: %1</source>
        <translation>平的底面：%1</translation>
    </message>
    <message>
        <source>narrow places all around: %1</source>
        <translation>四周变窄的地方：%1</translation>
    </message>
    <message>
        <source>%1 of clay</source>
        <translation>黏土%1</translation>
    </message>
    <message>
        <source>triangles: %1</source>
        <translation>三角形：%1</translation>
    </message>
    <message>
        <source>%1 (cannot be said of this model)</source>
        <translation>%1（这个模型无法判断）</translation>
    </message>
    <message>
        <source>%1 (not yet)</source>
        <translation>%1（还没有）</translation>
    </message>
    <message>
        <source>%1 (now %2)</source>
        <translation>%1（现在 %2）</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <extracomment>a tool and its radius</extracomment>
        <translation>%1 %2 毫米</translation>
    </message>
    <message>
        <source>%1 %2 mm (strength %3)</source>
        <translation>%1 %2 毫米（强度 %3）</translation>
    </message>
    <message>
        <source>like the teacher&apos;s to %1 mm</source>
        <translation>与老师的相差不超过 %1 毫米</translation>
    </message>
    <message>
        <source>something sculpted in this step</source>
        <translation>在这一步里做些雕刻</translation>
    </message>
    <message>
        <source>like the teacher&apos;s to %1 mm (now up to %2)</source>
        <translation>与老师的相差不超过 %1 毫米（现在最多 %2）</translation>
    </message>
</context>
<context>
    <name>app::LessonWriter</name>
    <message>
        <source>%1 was not written.</source>
        <translation>未写入 %1。</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>还有 %n 条。</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the lesson</source>
        <translation>保存课程</translation>
    </message>
    <message>
        <source>Not all goals of the lesson are met.</source>
        <translation>课程的目标没有全部达到。</translation>
    </message>
    <message>
        <source>Save All the Same</source>
        <translation>仍然保存</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>正在保存 %1</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>已保存 %1。</translation>
    </message>
    <message>
        <source>Please wait: another operation on the model is still running.</source>
        <translation>请稍候：模型正在进行其他操作。</translation>
    </message>
    <message>
        <source>Playing the lesson to its end</source>
        <translation>正在把课程播放到底</translation>
    </message>
</context>
<context>
    <name>app::ModelExport</name>
    <message>
        <source>Reducing the triangles</source>
        <translation>正在减少三角形</translation>
    </message>
    <message>
        <source>Saved %1. It was not verified.</source>
        <translation>已保存 %1，但未核对。</translation>
    </message>
    <message>
        <source>%1: there is not enough memory to write this model.</source>
        <translation>%1：内存不足，无法写入此模型。</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>正在导出 %1</translation>
    </message>
    <message>
        <source>Reading %1 back</source>
        <translation>正在重新读取 %1</translation>
    </message>
    <message>
        <source>Saved %1, but reading it back gave something else. The disk may be failing, or another program may be changing the file.</source>
        <translation>已保存 %1，但读回的内容不一致。磁盘可能有故障，或有其他程序正在修改该文件。</translation>
    </message>
    <message>
        <source>%1: %2 × %3 × %4 mm, %5 triangles; verified, watertight.</source>
        <translation>%1：%2 × %3 × %4 毫米，%5 个三角形；已核对，水密。</translation>
    </message>
    <message>
        <source>Its format has no colours; GLB and 3MF keep them.</source>
        <translation>该格式没有颜色；GLB 和 3MF 可保留颜色。</translation>
    </message>
    <message>
        <source>%1 triangles were asked for; this could not be reached without losing handles or parts, or flipping faces.</source>
        <translation>要求减少到 %1 个三角形；减到这么少会丢失把手或部件，或使面翻转。</translation>
    </message>
    <message>
        <source>Slicing %1</source>
        <translation>正在切片 %1</translation>
    </message>
    <message>
        <source>Joining the parts</source>
        <translation>正在合并部件</translation>
    </message>
    <message>
        <source>%1 was not written: its parts overlap and cannot be joined. Move one a little, or export them one by one.</source>
        <translation>未写入 %1：各部件相互重叠且无法合并。请稍微移动其中一个，或逐个导出。</translation>
    </message>
    <message>
        <source>%1 was written with parts that overlap, as you wished: their surfaces intersect.</source>
        <translation>%1 已按您的要求写入，其中的部件重叠：它们的表面相交。</translation>
    </message>
</context>
<context>
    <name>app::ModelLoader</name>
    <message>
        <source>Checking %1</source>
        <translation>正在检查 %1</translation>
    </message>
    <message>
        <source>%1 cannot be sculpted where it is: so far from the origin its coordinates are too coarse for its detail.</source>
        <translation>%1 无法在其所在位置雕刻：离原点太远，坐标精度不足以表示其细节。</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this model.</source>
        <translation>%1：内存不足，无法载入此模型。</translation>
    </message>
    <message>
        <source>Ball of clay</source>
        <translation>黏土球</translation>
    </message>
    <message>
        <source>%1: there is not enough memory to write this model.</source>
        <translation>%1：内存不足，无法写入此模型。</translation>
    </message>
    <message>
        <source>Cube</source>
        <translation>立方体</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>圆环</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>厚板</translation>
    </message>
    <message>
        <source>Vase</source>
        <translation>花瓶</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>头像</translation>
    </message>
    <message>
        <source>Tablet</source>
        <translation>浮雕板</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球</translation>
    </message>
    <message>
        <source>%1 is very small in millimetres (%2). If it was made in another unit, undo, and say which when you insert it again.</source>
        <translation>%1 以毫米计非常小（%2）。如果它是用其他单位制作的，请撤销，再次插入时选择单位。</translation>
    </message>
    <message>
        <source>%1 was not written, because all parts are hidden. GLB keeps hidden parts.</source>
        <translation>未写入 %1，因为所有部件都已隐藏。GLB 可保留隐藏的部件。</translation>
    </message>
    <message>
        <source>The objects of %1 overlap or touch, so each is a part.</source>
        <translation>%1 的对象重叠或接触，因此各自成为一个部件。</translation>
    </message>
    <message numerus="yes">
        <source>A repair makes one part of its %Ln objects.</source>
        <translation>
            <numerusform>修复会把它的 %Ln 个对象合为一个部件。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 has more objects than a model may have parts (%Ln), so they are one part.</source>
        <translation>
            <numerusform>%1 的对象多于模型可有的部件数（%Ln），因此合为一个部件。</numerusform>
        </translation>
    </message>
    <message>
        <source>The objects of %1 are not solids of their own, so they are one part.</source>
        <translation>%1 的对象单独不构成实体，因此合为一个部件。</translation>
    </message>
</context>
<context>
    <name>app::ModelOpener</name>
    <message>
        <source>Preparing the clay</source>
        <translation>正在准备黏土</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>正在打开 %1</translation>
    </message>
    <message>
        <source>The model that you chose will open as soon as this is done.</source>
        <translation>完成后将打开您选择的模型。</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>正在恢复 %1</translation>
    </message>
</context>
<context>
    <name>app::ModelSaver</name>
    <message>
        <source>Exporting %1</source>
        <translation>正在导出 %1</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>正在保存 %1</translation>
    </message>
    <message>
        <source>%1 was not written.</source>
        <translation>未写入 %1。</translation>
    </message>
    <message>
        <source>Making a brush of %1</source>
        <translation>正在把 %1 做成笔刷</translation>
    </message>
</context>
<context>
    <name>app::ModelSaving</name>
    <message>
        <source>Saved %1 without colours: its format has none. GLB keeps them.</source>
        <translation>已保存 %1，但不含颜色：该格式没有颜色。GLB 可保留颜色。</translation>
    </message>
    <message>
        <source>%1 and %2 were written.</source>
        <translation>已保存 %1 和 %2。</translation>
    </message>
    <message>
        <source>Only %1 was written. %2</source>
        <translation>只保存了 %1。%2</translation>
    </message>
    <message>
        <source>Saved %1 without the hidden parts: its format cannot keep them hidden. GLB keeps them.</source>
        <translation>已保存 %1，但不含隐藏的部件：该格式无法保留其隐藏状态。GLB 可以保留。</translation>
    </message>
</context>
<context>
    <name>app::ModelChangeJob</name>
    <message>
        <source>There is not enough memory for this; the model stays as it is.</source>
        <translation>内存不足，无法完成；模型保持不变。</translation>
    </message>
</context>
<context>
    <name>app::CommandNames</name>
    <message>
        <source>Move</source>
        <comment>undo step</comment>
        <translation>移动</translation>
    </message>
    <message>
        <source>Moving the model</source>
        <translation>正在移动模型</translation>
    </message>
    <message>
        <source>Rotate</source>
        <comment>undo step</comment>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Rotating the model</source>
        <translation>正在旋转模型</translation>
    </message>
    <message>
        <source>Scale</source>
        <comment>undo step</comment>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Scaling the model</source>
        <translation>正在缩放模型</translation>
    </message>
    <message>
        <source>Mirror</source>
        <comment>undo step</comment>
        <translation>镜像</translation>
    </message>
    <message>
        <source>Mirroring the model</source>
        <translation>正在镜像模型</translation>
    </message>
    <message>
        <source>Recentre</source>
        <comment>undo step</comment>
        <translation>居中</translation>
    </message>
    <message>
        <source>Recentring the model</source>
        <translation>正在将模型居中</translation>
    </message>
    <message>
        <source>Insert</source>
        <comment>undo step</comment>
        <translation>插入</translation>
    </message>
    <message>
        <source>Inserting a model</source>
        <translation>正在插入模型</translation>
    </message>
    <message>
        <source>Fill</source>
        <comment>undo step</comment>
        <translation>填充</translation>
    </message>
    <message>
        <source>Colouring the model</source>
        <translation>正在为模型上色</translation>
    </message>
    <message>
        <source>Remesh</source>
        <comment>undo step</comment>
        <translation>重新划分网格</translation>
    </message>
    <message>
        <source>Remeshing the model</source>
        <translation>正在重新划分网格</translation>
    </message>
    <message>
        <source>Symmetrize</source>
        <comment>undo step</comment>
        <translation>对称化</translation>
    </message>
    <message>
        <source>Making the model symmetric</source>
        <translation>正在使模型对称</translation>
    </message>
    <message>
        <source>The mesh is as uniform as that already.</source>
        <translation>网格已经这样均匀了。</translation>
    </message>
    <message>
        <source>The model is like that already.</source>
        <translation>模型已经是这样了。</translation>
    </message>
    <message>
        <source>The model stays as it is, because some of its faces would intersect after rounding to the program&apos;s grid (faces: %1).</source>
        <translation>模型保持不变：按程序的坐标格点取整后，部分面会相交（面数：%1）。</translation>
    </message>
    <message>
        <source>The model stays as it is: nothing may be farther from the origin than four times its size.</source>
        <translation>模型保持不变：离原点的距离不得超过其尺寸的四倍。</translation>
    </message>
    <message>
        <source>The model stays as it is: its size must be between a millionth of a millimetre and ten kilometres.</source>
        <translation>模型保持不变：其尺寸须在百万分之一毫米到十公里之间。</translation>
    </message>
    <message>
        <source>%1 was not inserted, because one model would be inside the other. It must be outside, or in a hollow.</source>
        <translation>未插入 %1，因为一个模型会位于另一个之内；它必须在外部或空腔中。</translation>
    </message>
    <message>
        <source>%1 was not inserted, because there it would touch the model.</source>
        <translation>未插入 %1，因为它在该处会碰到模型。</translation>
    </message>
    <message>
        <source>The model stays as it is, because no part of it is on the side to keep.</source>
        <translation>模型保持不变：要保留的一侧没有模型的任何部分。</translation>
    </message>
    <message>
        <source>The model stays as it is, because the half and its mirror image would not make one sound surface.</source>
        <translation>模型保持不变：这一半与其镜像不能构成完好的表面。</translation>
    </message>
    <message>
        <source>The mesh stays as it is: with edges this short it would need too many triangles (%1).</source>
        <translation>网格保持不变：边这么短需要过多的三角形（%1）。</translation>
    </message>
    <message>
        <source>Reset</source>
        <comment>undo step</comment>
        <translation>重置</translation>
    </message>
    <message>
        <source>Going back to the start</source>
        <translation>正在回到起点</translation>
    </message>
    <message>
        <source>Place on Bed</source>
        <comment>undo step</comment>
        <translation>放到打印床</translation>
    </message>
    <message>
        <source>Placing the model on the bed</source>
        <translation>正在把模型放到打印床</translation>
    </message>
    <message>
        <source>Flatten Base</source>
        <comment>undo step</comment>
        <translation>压平底部</translation>
    </message>
    <message>
        <source>Flattening the base</source>
        <translation>正在压平底部</translation>
    </message>
    <message>
        <source>The model stays as it is, because a cut at this height would not leave one sound surface; another height may do.</source>
        <translation>模型保持不变：在此高度截断不会得到完好的表面；可换一个高度。</translation>
    </message>
    <message>
        <source>Changing the mask</source>
        <translation>正在更改遮罩</translation>
    </message>
    <message>
        <source>Invert Mask</source>
        <comment>undo step</comment>
        <translation>反转遮罩</translation>
    </message>
    <message>
        <source>Clear Mask</source>
        <comment>undo step</comment>
        <translation>清除遮罩</translation>
    </message>
    <message>
        <source>Blur Mask</source>
        <comment>undo step</comment>
        <translation>模糊遮罩</translation>
    </message>
    <message>
        <source>Sharpen Mask</source>
        <comment>undo step</comment>
        <translation>锐化遮罩</translation>
    </message>
    <message>
        <source>Grow Mask</source>
        <comment>undo step</comment>
        <translation>扩大遮罩</translation>
    </message>
    <message>
        <source>Shrink Mask</source>
        <comment>undo step</comment>
        <translation>缩小遮罩</translation>
    </message>
    <message>
        <source>Mask Cavities</source>
        <comment>undo step</comment>
        <translation>遮罩凹处</translation>
    </message>
    <message>
        <source>Mask by Colour</source>
        <comment>undo step</comment>
        <translation>按颜色遮罩</translation>
    </message>
    <message>
        <source>The mask is like that already.</source>
        <translation>遮罩已经是这样了。</translation>
    </message>
    <message>
        <source>Mask Whole Pieces</source>
        <comment>undo step</comment>
        <translation>遮罩整块</translation>
    </message>
    <message>
        <source>Join</source>
        <comment>undo step</comment>
        <translation>合并</translation>
    </message>
    <message>
        <source>Joining the parts</source>
        <translation>正在合并部件</translation>
    </message>
    <message>
        <source>Subtract</source>
        <comment>undo step</comment>
        <translation>减去</translation>
    </message>
    <message>
        <source>Subtracting the parts</source>
        <translation>正在减去部件</translation>
    </message>
    <message>
        <source>Intersect</source>
        <comment>undo step</comment>
        <translation>相交</translation>
    </message>
    <message>
        <source>Intersecting the parts</source>
        <translation>正在求部件的交集</translation>
    </message>
    <message>
        <source>Edit Part</source>
        <comment>undo step</comment>
        <translation>更改部件</translation>
    </message>
    <message>
        <source>Changing the list of parts</source>
        <translation>正在更改部件列表</translation>
    </message>
    <message>
        <source>Show or Hide Parts</source>
        <comment>undo step</comment>
        <translation>显示或隐藏部件</translation>
    </message>
    <message>
        <source>Show</source>
        <comment>undo step</comment>
        <translation>显示</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <comment>undo step</comment>
        <translation>复制</translation>
    </message>
    <message>
        <source>Duplicating the part</source>
        <translation>正在复制部件</translation>
    </message>
    <message>
        <source>Delete</source>
        <comment>undo step</comment>
        <translation>删除</translation>
    </message>
    <message>
        <source>Deleting the part</source>
        <translation>正在删除部件</translation>
    </message>
    <message>
        <source>Separate</source>
        <comment>undo step</comment>
        <translation>拆分</translation>
    </message>
    <message>
        <source>Separating the part</source>
        <translation>正在拆分部件</translation>
    </message>
    <message>
        <source>The model stays as it is: it has no such part, or the part is empty.</source>
        <translation>模型保持不变：没有这个部件，或者部件是空的。</translation>
    </message>
    <message>
        <source>The model stays as it is, because a part is hidden or locked. Show and unlock it first.</source>
        <translation>模型保持不变，因为有部件被隐藏或锁定。请先显示并解锁它。</translation>
    </message>
    <message>
        <source>The last part cannot be deleted.</source>
        <translation>无法删除最后一个部件。</translation>
    </message>
    <message>
        <source>The part is in one piece already, so nothing was separated.</source>
        <translation>该部件已是一整块，没有拆分任何东西。</translation>
    </message>
    <message numerus="yes">
        <source>The model stays as it is: it may have %Ln parts at most.</source>
        <translation>
            <numerusform>模型保持不变：最多只能有 %Ln 个部件。</numerusform>
        </translation>
    </message>
    <message>
        <source>The parts do not overlap, so nothing was subtracted.</source>
        <translation>部件没有重叠，因此没有减去任何东西。</translation>
    </message>
    <message>
        <source>Show All</source>
        <comment>undo step</comment>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Hide</source>
        <comment>undo step</comment>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Hiding and showing</source>
        <translation>正在隐藏或显示</translation>
    </message>
    <message>
        <source>Trim</source>
        <comment>undo step</comment>
        <translation>裁剪</translation>
    </message>
    <message>
        <source>Trimming the model</source>
        <translation>正在裁剪模型</translation>
    </message>
    <message>
        <source>Nothing is hidden.</source>
        <translation>没有隐藏任何内容。</translation>
    </message>
    <message>
        <source>The name was too long, so its end was cut off.</source>
        <translation>名称太长，末尾已被截去。</translation>
    </message>
    <message>
        <source>Nothing is masked, so nothing was hidden.</source>
        <translation>没有遮罩，因此没有隐藏任何内容。</translation>
    </message>
    <message>
        <source>The model stays as it is, because the curve does not go around an area.</source>
        <translation>模型保持不变：曲线没有围出面积。</translation>
    </message>
    <message>
        <source>There is nothing to subtract: the models do not overlap.</source>
        <translation>没有可减去的部分：两个模型没有重叠。</translation>
    </message>
    <message>
        <source>The shape</source>
        <translation>该形状</translation>
    </message>
    <message>
        <source>The model stays as it is, because nothing of it would be left.</source>
        <translation>模型保持不变，因为否则什么都不会剩下。</translation>
    </message>
    <message>
        <source>The model stays as it is, because the surfaces nearly coincide and no sound cut was found; another place may do.</source>
        <translation>模型保持不变：两个表面几乎重合，没有找到无缺陷的切割；换个位置也许可以。</translation>
    </message>
    <message>
        <source>Unmask Area</source>
        <comment>undo step</comment>
        <translation>移除区域的遮罩</translation>
    </message>
    <message>
        <source>Mask Area</source>
        <comment>undo step</comment>
        <translation>遮罩区域</translation>
    </message>
    <message>
        <source>Hide Area</source>
        <comment>undo step</comment>
        <translation>隐藏区域</translation>
    </message>
    <message>
        <source>Split Off</source>
        <comment>undo step</comment>
        <translation>分离</translation>
    </message>
    <message>
        <source>Splitting the part</source>
        <translation>正在分割部件</translation>
    </message>
    <message>
        <source>The part stays as it is, because all of it is masked or hidden.</source>
        <translation>部件保持不变，因为它全部被遮罩或隐藏。</translation>
    </message>
    <message>
        <source>Nothing is masked in the area.</source>
        <translation>该区域中没有遮罩。</translation>
    </message>
    <message>
        <source>Nothing was masked: none of the model is in the area, or it is masked already.</source>
        <translation>没有遮罩任何部分：该区域中没有模型，或已被遮罩。</translation>
    </message>
    <message>
        <source>Nothing was hidden: none of the model is in the area.</source>
        <translation>没有隐藏任何部分：该区域中没有模型。</translation>
    </message>
    <message>
        <source>A part can only be combined with others. Choose at least one more.</source>
        <translation>部件只能与其他部件组合。请至少再选择一个。</translation>
    </message>
    <message>
        <source>Nothing was split off: all of the part is on one side of the cut.</source>
        <translation>没有分离任何部分：整个部件都在切口的同一侧。</translation>
    </message>
    <message>
        <source>Nothing was cut away: none of the model is on that side of the cut.</source>
        <translation>没有切去任何部分：切口的这一侧没有模型。</translation>
    </message>
    <message>
        <source>The model stays as it is, because its surface would pass through itself (faces: %1). Turn or move it less, or blur the mask.</source>
        <translation>模型保持不变：它的表面会穿过自身（面数：%1）。请少转动或少移动一些，或模糊遮罩。</translation>
    </message>
    <message>
        <source>The model stays as it is, because the cut would not leave one sound surface; a cut elsewhere may do.</source>
        <translation>模型保持不变：这样切割不会得到完好的表面；可换个位置切割。</translation>
    </message>
</context>
<context>
    <name>app::PartnerView</name>
    <message>
        <source>Your partner undid: %1.</source>
        <translation>您的搭档撤销了：%1。</translation>
    </message>
    <message>
        <source>Your partner redid: %1.</source>
        <translation>您的搭档重做了：%1。</translation>
    </message>
    <message>
        <source>Your partner chose %1, %2 mm.</source>
        <extracomment>%1: a tool; %2: a length</extracomment>
        <translation>您的搭档选择了%1，%2 毫米。</translation>
    </message>
    <message>
        <source>Your partner chose a strength of %1 %.</source>
        <translation>您的搭档选择了强度 %1 %。</translation>
    </message>
    <message>
        <source>Your partner is sculpting now.</source>
        <translation>现在由您的搭档雕刻。</translation>
    </message>
    <message>
        <source>It is your turn again.</source>
        <translation>又轮到您了。</translation>
    </message>
</context>
<context>
    <name>app::ReplayCommand</name>
    <message>
        <source>Plays recorded strokes on a model, or on the paper&apos;s sphere.</source>
        <translation>在模型或论文所用的球体上回放录制的笔画。</translation>
    </message>
    <message>
        <source>replay: %1 is not an option; give the model with --in.</source>
        <translation>replay：%1 不是选项；请用 --in 指定模型。</translation>
    </message>
    <message>
        <source>--parts keeps its objects apart, which may overlap then.</source>
        <translation>--parts 使其对象保持分开，此时可以重叠。</translation>
    </message>
    <message>
        <source>replay: --strokes is missing.</source>
        <translation>replay：缺少 --strokes。</translation>
    </message>
    <message>
        <source>replay: %1 and %2 name the same file, %3.</source>
        <translation>replay：%1 与 %2 指的是同一个文件 %3。</translation>
    </message>
    <message>
        <source>replay: the mesh is not valid after dab %1.</source>
        <translation>replay：笔点 %1 之后网格无效。</translation>
    </message>
    <message>
        <source>replay: strokes[%1]: %2</source>
        <translation>replay: strokes[%1]: %2</translation>
    </message>
    <message>
        <source>The strokes, JSON; or -.</source>
        <translation>笔画，JSON 格式；或 -。</translation>
    </message>
    <message>
        <source>The model; or - (default: a sphere of 2562 vertices, radius 1).</source>
        <translation>模型；或 -（默认为半径 1、有 2562 个顶点的球体）。</translation>
    </message>
    <message>
        <source>File for the sculpted model; or -.</source>
        <translation>保存雕刻后模型的文件；或 -。</translation>
    </message>
    <message>
        <source>File for cost and outcome of each dab, JSON; or -.</source>
        <translation>保存每个笔点的开销和结果的文件，JSON 格式；或 -。</translation>
    </message>
    <message>
        <source>Folder for pictures of the model, PNG, at the start and after each stroke.</source>
        <translation>存放模型图片（PNG）的文件夹，开始时和每一笔之后各一张。</translation>
    </message>
    <message>
        <source>Strokes from one picture to the next (default: 1).</source>
        <translation>两张图片之间的笔数（默认 1）。</translation>
    </message>
    <message>
        <source>local: what changed (as in the window, the default); full: the whole mesh after each dab as well; none: for measurements, without --out.</source>
        <translation>local：检查有变化之处（与窗口中相同，默认）；full：每个笔点后还检查整个网格；none：仅供测量，不能与 --out 同用。</translation>
    </message>
    <message>
        <source>replay: --verify none and --out cannot be used together: what is not verified is not kept.</source>
        <translation>replay：--verify none 和 --out 不能同时使用：未经检查的结果不予保存。</translation>
    </message>
    <message>
        <source>%1: %2: %3</source>
        <comment>file: place: reason</comment>
        <translation>%1：%2：%3</translation>
    </message>
    <message>
        <source>Strokes: %1, commands: %2, dabs: %3. Size: %4 x %5 x %6 mm, triangles: %7. Time: %8 s.</source>
        <translation>笔画：%1，命令：%2，笔点：%3。尺寸：%4 x %5 x %6 毫米，三角形：%7。用时：%8 秒。</translation>
    </message>
    <message>
        <source>Make a part of each object of the model; parts may overlap.</source>
        <translation>使模型的每个对象成为一个部件；部件可以重叠。</translation>
    </message>
    <message>
        <source>The parts overlap, so they were united.</source>
        <translation>部件重叠，因此已合并。</translation>
    </message>
    <message>
        <source>%1: the parts overlap and cannot be united. A GLB file keeps them apart.</source>
        <translation>%1：部件重叠且无法合并。GLB 文件可使它们保持分开。</translation>
    </message>
</context>
<context>
    <name>app::ReportCommand</name>
    <message>
        <source>Writes a class report: for each model in a folder its picture, size and volume, whether it is print-ready or why not, and, for GLB files, the number of strokes and the time spent. Pupils&apos; models are listed by pupil, with the time of the turn. Status 1: not all models can be read.</source>
        <translation>生成班级报告：文件夹中每个模型的图片、大小和体积，能否打印或为何不能；GLB 文件还有笔画数和用时。学生的模型按学生列出，并附该轮的用时。状态 1：并非所有模型都能读取。</translation>
    </message>
    <message>
        <source>The models. Subfolders are skipped, except the pupils&apos; models of a class.</source>
        <translation>模型。跳过子文件夹，但课堂的学生模型除外。</translation>
    </message>
    <message numerus="yes">
        <source>report: needs one folder; %n were given.</source>
        <translation>
            <numerusform>report：需要一个文件夹，但指定了 %n 个。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::ReportController</name>
    <message>
        <source>The class report has to wait until this is done; try again then.</source>
        <translation>班级报告要等当前操作完成；请届时再试。</translation>
    </message>
    <message>
        <source>Looking at the models in %1</source>
        <translation>正在查看 %1 中的模型</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>已保存 %1。</translation>
    </message>
    <message>
        <source>%1 was not written.</source>
        <translation>未写入 %1。</translation>
    </message>
</context>
<context>
    <name>app::ReportWriter</name>
    <message>
        <source>%1: there is not enough memory for this model.</source>
        <translation>%1：内存不足，无法载入此模型。</translation>
    </message>
</context>
<context>
    <name>app::SheetCommand</name>
    <message>
        <source>Writes scale drawings of models, one A4 page each, in the order of their names. Pupils&apos; models are named by pupil. Status 1: not all models can be drawn.</source>
        <translation>按比例绘制模型的图纸，每个模型一页 A4，按名称排序。学生的模型以学生命名。状态 1：并非所有模型都能绘制。</translation>
    </message>
    <message>
        <source>%1 has no sheet, because its surface does not enclose anything (%2).</source>
        <translation>%1 没有图纸，因为其表面没有围成任何空间（%2）。</translation>
    </message>
    <message>
        <source>%1 was not written: none of the models can be drawn.</source>
        <translation>未写入 %1：没有任何模型可以绘制。</translation>
    </message>
    <message>
        <source>Models, or folders of models; or -.</source>
        <translation>模型或存放模型的文件夹；或 -。</translation>
    </message>
    <message>
        <source>Draws colours under the lines.</source>
        <translation>在线条下显示颜色。</translation>
    </message>
</context>
<context>
    <name>app::Simulator</name>
    <message>
        <source>The VR simulator cannot be loaded: %1</source>
        <translation>无法加载 VR 模拟器：%1</translation>
    </message>
    <message>
        <source>The VR simulator is not installed with this program: there is no folder %1 beside it with fettle_simulator.json.</source>
        <translation>此程序未安装 VR 模拟器：程序旁边没有包含 fettle_simulator.json 的文件夹 %1。</translation>
    </message>
</context>
<context>
    <name>app::SlicerCheck</name>
    <message>
        <source>PrusaSlicer was stopped.</source>
        <translation>PrusaSlicer 已停止。</translation>
    </message>
    <message>
        <source>PrusaSlicer took longer than three minutes and was stopped.</source>
        <translation>PrusaSlicer 用时超过三分钟，已停止。</translation>
    </message>
    <message>
        <source>PrusaSlicer cannot slice it: %1</source>
        <translation>PrusaSlicer 无法切片：%1</translation>
    </message>
    <message>
        <source>The sliced file cannot be read: %1</source>
        <translation>无法读取切片结果：%1</translation>
    </message>
    <message>
        <source>PrusaSlicer slices it: layers %1, time %2.</source>
        <translation>PrusaSlicer 可以切片：层数 %1，时间 %2。</translation>
    </message>
</context>
<context>
    <name>app::StrokeStep</name>
    <message>
        <source>Pull</source>
        <comment>undo step</comment>
        <translation>拉出</translation>
    </message>
    <message>
        <source>Push</source>
        <comment>undo step</comment>
        <translation>推入</translation>
    </message>
    <message>
        <source>Flatten</source>
        <comment>undo step</comment>
        <translation>压平</translation>
    </message>
    <message>
        <source>Smooth</source>
        <comment>undo step</comment>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Paint</source>
        <comment>undo step</comment>
        <translation>上色</translation>
    </message>
    <message>
        <source>Add Ball</source>
        <comment>undo step</comment>
        <translation>添加球</translation>
    </message>
    <message>
        <source>Inflate</source>
        <comment>undo step</comment>
        <translation>膨胀</translation>
    </message>
    <message>
        <source>Clay</source>
        <comment>undo step</comment>
        <translation>铺泥</translation>
    </message>
    <message>
        <source>Layer</source>
        <comment>undo step</comment>
        <translation>加层</translation>
    </message>
    <message>
        <source>Scrape</source>
        <comment>undo step</comment>
        <translation>刮平</translation>
    </message>
    <message>
        <source>Pinch</source>
        <comment>undo step</comment>
        <translation>收拢</translation>
    </message>
    <message>
        <source>Crease</source>
        <comment>undo step</comment>
        <translation>刻痕</translation>
    </message>
    <message>
        <source>Grab</source>
        <comment>undo step</comment>
        <translation>抓取</translation>
    </message>
    <message>
        <source>Snake Hook</source>
        <comment>undo step</comment>
        <translation>蛇形钩</translation>
    </message>
    <message>
        <source>Twist</source>
        <comment>undo step</comment>
        <translation>扭转</translation>
    </message>
    <message>
        <source>Mask</source>
        <comment>undo step</comment>
        <translation>遮罩</translation>
    </message>
    <message>
        <source>Stamp</source>
        <comment>undo step</comment>
        <translation>图章</translation>
    </message>
    <message>
        <source>Add Model</source>
        <comment>undo step</comment>
        <translation>添加模型</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>undo step: name of the part, what was done to it</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>app::StrokeEdit</name>
    <message>
        <source>With this brush it does nothing.</source>
        <translation>用这个笔刷，这一笔没有任何效果。</translation>
    </message>
</context>
<context>
    <name>app::StrokeAssets</name>
    <message>
        <source>%1: %2: %3</source>
        <comment>file: place: reason</comment>
        <translation>%1：%2：%3</translation>
    </message>
    <message>
        <source>%1 has changed since this stroke was recorded.</source>
        <translation>%1 在录制这一笔之后已更改。</translation>
    </message>
    <message>
        <source>alpha: &quot;%1&quot; is none of %2, and no file</source>
        <translation>alpha：“%1”不是 %2 之一，也不是文件</translation>
    </message>
</context>
<context>
    <name>app::TimeLapse</name>
    <message>
        <source>%1 already contains %2, and nothing was overwritten: choose an empty folder.</source>
        <translation>%1 中已有 %2，未覆盖任何文件：请选择空文件夹。</translation>
    </message>
    <message>
        <source>There is not enough memory for a time-lapse of this model.</source>
        <translation>内存不足，无法为这个模型制作延时图片。</translation>
    </message>
    <message>
        <source>The earlier steps of the model can no longer be read, so they are not in the time-lapse.</source>
        <translation>无法再读取模型较早的步骤，因此延时图片中没有它们。</translation>
    </message>
    <message>
        <source>%1 is not a folder.</source>
        <translation>%1 不是文件夹。</translation>
    </message>
</context>
<context>
    <name>app::TimeLapseController</name>
    <message>
        <source>Drawing the time-lapse</source>
        <translation>正在绘制延时图片</translation>
    </message>
    <message>
        <source>The time-lapse has to wait until this is done; try again then.</source>
        <translation>延时图片要等当前操作完成；请届时再试。</translation>
    </message>
    <message>
        <source>The time-lapse was stopped; no picture of it is in %1.</source>
        <translation>延时图片已停止；%1 中没有留下图片。</translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln pictures were written.</source>
        <translation>
            <numerusform>%1：已写入 %Ln 张图片。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::About</name>
    <message>
        <source>About Fettle</source>
        <translation>关于 Fettle</translation>
    </message>
    <message>
        <source>Fettle %1

Sculpt a model with mouse, pen or VR controllers, and export it ready to print.</source>
        <translation>Fettle %1

用鼠标、手写笔或 VR 手柄雕刻模型，并导出为可直接打印的文件。</translation>
    </message>
</context>
<context>
    <name>ui::Actions</name>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Closes the window and ends the program.</source>
        <translation>关闭窗口并退出程序。</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Undoes the last step.</source>
        <translation>撤销上一步。</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Redoes the last undone step.</source>
        <translation>重做上一个撤销的步骤。</translation>
    </message>
    <message>
        <source>&amp;Pull</source>
        <translation>拉出(&amp;P)</translation>
    </message>
    <message>
        <source>P&amp;ush</source>
        <translation>推入(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>平滑(&amp;S)</translation>
    </message>
    <message>
        <source>Smooths the surface.</source>
        <translation>使表面平滑。</translation>
    </message>
    <message>
        <source>S&amp;maller Brush</source>
        <translation>缩小笔刷(&amp;M)</translation>
    </message>
    <message>
        <source>Makes the brush&apos;s radius a tenth smaller.</source>
        <translation>将笔刷半径缩小十分之一。</translation>
    </message>
    <message>
        <source>&amp;Larger Brush</source>
        <translation>放大笔刷(&amp;L)</translation>
    </message>
    <message>
        <source>Makes the brush&apos;s radius a tenth larger.</source>
        <translation>将笔刷半径放大十分之一。</translation>
    </message>
    <message>
        <source>&amp;Frame Model</source>
        <translation>框显模型(&amp;F)</translation>
    </message>
    <message>
        <source>Shows the whole model.</source>
        <translation>显示整个模型。</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>前视图(&amp;R)</translation>
    </message>
    <message>
        <source>Shows the model from the front: x to the right, y up.</source>
        <translation>从前面显示模型：x 向右，y 向上。</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>后视图(&amp;B)</translation>
    </message>
    <message>
        <source>Shows the model from behind: x to the left, y up.</source>
        <translation>从后面显示模型：x 向左，y 向上。</translation>
    </message>
    <message>
        <source>R&amp;ight</source>
        <translation>右视图(&amp;I)</translation>
    </message>
    <message>
        <source>Shows the model from the right: z to the left, y up.</source>
        <translation>从右面显示模型：z 向左，y 向上。</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>左视图(&amp;L)</translation>
    </message>
    <message>
        <source>Shows the model from the left: z to the right, y up.</source>
        <translation>从左面显示模型：z 向右，y 向上。</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>顶视图(&amp;T)</translation>
    </message>
    <message>
        <source>Shows the model from above: x to the right, z down.</source>
        <translation>从上面显示模型：x 向右，z 向下。</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>底视图(&amp;M)</translation>
    </message>
    <message>
        <source>Shows the model from below: x to the right, z up.</source>
        <translation>从下面显示模型：x 向右，z 向上。</translation>
    </message>
    <message>
        <source>&amp;Orthographic</source>
        <translation>正交投影(&amp;O)</translation>
    </message>
    <message>
        <source>Turns perspective off and on.</source>
        <translation>关闭或打开透视。</translation>
    </message>
    <message>
        <source>&amp;Look for a Headset</source>
        <translation>查找头显(&amp;L)</translation>
    </message>
    <message>
        <source>Checks whether a VR headset is ready.</source>
        <translation>检查 VR 头显是否就绪。</translation>
    </message>
    <message>
        <source>&amp;About Fettle</source>
        <translation>关于 Fettle(&amp;A)</translation>
    </message>
    <message>
        <source>Shows what this program is, and its version.</source>
        <translation>显示程序简介和版本。</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Sculpt</source>
        <translation>雕刻(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>V&amp;R</source>
        <translation>VR(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Stops what is running. The model stays as it is.</source>
        <translation>停止正在进行的操作。模型保持不变。</translation>
    </message>
    <message>
        <source>&amp;Scale…</source>
        <translation>缩放(&amp;S)…</translation>
    </message>
    <message>
        <source>Makes the whole model larger or smaller.</source>
        <translation>放大或缩小整个模型。</translation>
    </message>
    <message>
        <source>M&amp;irror…</source>
        <translation>镜像(&amp;I)…</translation>
    </message>
    <message>
        <source>Turns the active part into its mirror image.</source>
        <translation>将当前部件变为其镜像。</translation>
    </message>
    <message>
        <source>S&amp;ymmetrize…</source>
        <translation>对称化(&amp;Y)…</translation>
    </message>
    <message>
        <source>Replaces one half of the model by the mirror image of the other.</source>
        <translation>用模型一半的镜像替换另一半。</translation>
    </message>
    <message>
        <source>Re&amp;centre</source>
        <translation>居中(&amp;C)</translation>
    </message>
    <message>
        <source>Moves the middle of the model to the origin.</source>
        <translation>将模型的中心移到原点。</translation>
    </message>
    <message>
        <source>I&amp;nsert…</source>
        <translation>插入(&amp;N)…</translation>
    </message>
    <message>
        <source>Remesh &amp;Uniformly…</source>
        <translation>均匀重新划分网格(&amp;U)…</translation>
    </message>
    <message>
        <source>Makes all triangles of the model about the same size.</source>
        <translation>使模型的所有三角形大小相近。</translation>
    </message>
    <message>
        <source>&amp;Flatten</source>
        <translation>压平(&amp;F)</translation>
    </message>
    <message>
        <source>Levels the surface. Shift smooths.</source>
        <translation>压平表面。按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>P&amp;aint</source>
        <translation>上色(&amp;A)</translation>
    </message>
    <message>
        <source>Colours the surface without changing its shape. Shift smooths.</source>
        <translation>给表面上色，不改变形状。按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>&amp;Ray Brush</source>
        <translation>射线笔刷(&amp;R)</translation>
    </message>
    <message>
        <source>Affects only points connected along the surface, not the far side of a fold.</source>
        <translation>只作用于沿表面相连的点，不影响褶皱的另一侧。</translation>
    </message>
    <message>
        <source>Un&amp;iform Topology</source>
        <translation>均匀拓扑(&amp;I)</translation>
    </message>
    <message>
        <source>Keeps one edge length for the whole model instead of one that follows the brush.</source>
        <translation>整个模型保持同一边长，而不随笔刷变化。</translation>
    </message>
    <message>
        <source>&amp;Fusion</source>
        <translation>融合(&amp;F)</translation>
    </message>
    <message>
        <source>Joins surfaces that touch and parts thin necks. When off, surfaces stop where they touch.</source>
        <translation>连接相碰的表面，断开细颈。关闭时，表面在相碰处停止。</translation>
    </message>
    <message>
        <source>S&amp;ymmetry</source>
        <translation>对称(&amp;Y)</translation>
    </message>
    <message>
        <source>Mirrors your strokes across the symmetry plane.</source>
        <translation>将您的笔画镜像到对称平面的另一侧。</translation>
    </message>
    <message>
        <source>&amp;Commands and Keys…</source>
        <translation>命令与快捷键(&amp;C)…</translation>
    </message>
    <message>
        <source>Shows every command with its key, and searches them.</source>
        <translation>列出所有命令及其快捷键，并可搜索。</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>线框(&amp;W)</translation>
    </message>
    <message>
        <source>Draws the edges of the triangles over the model.</source>
        <translation>在模型上画出三角形的边。</translation>
    </message>
    <message>
        <source>Fl&amp;at Shading</source>
        <translation>平面着色(&amp;A)</translation>
    </message>
    <message>
        <source>Shows each triangle in one shade instead of a smooth surface.</source>
        <translation>以单一明暗显示每个三角形，而不是光滑的表面。</translation>
    </message>
    <message>
        <source>Cavit&amp;y Shade</source>
        <translation>凹处变暗(&amp;Y)</translation>
    </message>
    <message>
        <source>Darkens hollows and lightens ridges, so that fine shapes stand out.</source>
        <translation>使凹处变暗、凸脊变亮，突出细小的形状。</translation>
    </message>
    <message>
        <source>Tint &amp;under the Brush</source>
        <translation>笔刷下的着色(&amp;U)</translation>
    </message>
    <message>
        <source>Tints the area that the brush would affect.</source>
        <translation>用淡色标出笔刷将影响的区域。</translation>
    </message>
    <message>
        <source>Symmetry &amp;Plane</source>
        <translation>对称平面(&amp;P)</translation>
    </message>
    <message>
        <source>Shows where the model is mirrored while symmetry is on.</source>
        <translation>对称开启时显示模型在何处镜像。</translation>
    </message>
    <message>
        <source>&amp;Ground Grid</source>
        <translation>地面网格(&amp;G)</translation>
    </message>
    <message>
        <source>Shows a grid in millimetres under the model.</source>
        <translation>在模型下方显示以毫米为单位的网格。</translation>
    </message>
    <message>
        <source>&amp;Scale Bar</source>
        <translation>比例尺(&amp;S)</translation>
    </message>
    <message>
        <source>Shows a length in millimetres in the corner of the view.</source>
        <translation>在视图一角显示以毫米为单位的长度。</translation>
    </message>
    <message>
        <source>View &amp;Cube</source>
        <translation>视图立方体(&amp;C)</translation>
    </message>
    <message>
        <source>Shows a cube in the corner of the view: click a face to look from there.</source>
        <translation>在视图角落显示一个立方体：单击一面即从该方向观看。</translation>
    </message>
    <message>
        <source>Tool &amp;Names</source>
        <translation>工具名称(&amp;N)</translation>
    </message>
    <message>
        <source>Writes the name of each tool below its icon.</source>
        <translation>在每个图标下方显示工具名称。</translation>
    </message>
    <message>
        <source>Panels on the Left Si&amp;de</source>
        <translation>面板在左侧(&amp;D)</translation>
    </message>
    <message>
        <source>Moves the panels to the left of the view, for left-handed use.</source>
        <translation>将面板移到视图左侧，适合左手操作。</translation>
    </message>
    <message>
        <source>Brus&amp;h Palette</source>
        <translation>笔刷选板(&amp;H)</translation>
    </message>
    <message>
        <source>Opens tools, radius and strength at the pointer, as a right click does.</source>
        <translation>在指针处打开工具、半径和强度，与单击右键相同。</translation>
    </message>
    <message>
        <source>Brus&amp;h Presets</source>
        <translation>笔刷预设(&amp;H)</translation>
    </message>
    <message>
        <source>Shows the panel with brush presets.</source>
        <translation>显示笔刷预设面板。</translation>
    </message>
    <message>
        <source>&amp;Clay</source>
        <translation>黏土(&amp;C)</translation>
    </message>
    <message>
        <source>Shows the model as warm, dull clay.</source>
        <translation>将模型显示为暖色的哑光黏土。</translation>
    </message>
    <message>
        <source>&amp;Grey Clay</source>
        <translation>灰黏土(&amp;G)</translation>
    </message>
    <message>
        <source>Shows the model as cool grey clay, which hides no bump.</source>
        <translation>将模型显示为冷灰色黏土，起伏清晰可见。</translation>
    </message>
    <message>
        <source>Red &amp;Wax</source>
        <translation>红蜡(&amp;W)</translation>
    </message>
    <message>
        <source>Shows the model as red wax, soft in the shadows and shiny in the light.</source>
        <translation>将模型显示为红蜡，暗处柔和，亮处有光泽。</translation>
    </message>
    <message>
        <source>&amp;Porcelain</source>
        <translation>瓷器(&amp;P)</translation>
    </message>
    <message>
        <source>Shows the model as white, glazed porcelain.</source>
        <translation>将模型显示为上釉的白瓷。</translation>
    </message>
    <message>
        <source>P&amp;earl</source>
        <translation>珍珠(&amp;E)</translation>
    </message>
    <message>
        <source>Shows the model as pearl, which shimmers where it turns away.</source>
        <translation>将模型显示为珍珠，边缘泛出光彩。</translation>
    </message>
    <message>
        <source>&amp;Skin</source>
        <translation>皮肤(&amp;S)</translation>
    </message>
    <message>
        <source>Shows the model as skin, with light in its shadows.</source>
        <translation>将模型显示为皮肤，阴影中透着光。</translation>
    </message>
    <message>
        <source>Painted C&amp;olours</source>
        <translation>绘制的颜色(&amp;O)</translation>
    </message>
    <message>
        <source>Shows the colours that were painted as they are, shaded.</source>
        <translation>按原样显示绘制的颜色，带明暗。</translation>
    </message>
    <message>
        <source>As the &amp;Window</source>
        <translation>随窗口(&amp;W)</translation>
    </message>
    <message>
        <source>Uses a background that matches the window, light or dark.</source>
        <translation>背景随窗口变亮或变暗。</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>Uses a light grey background.</source>
        <translation>浅灰色背景。</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;D)</translation>
    </message>
    <message>
        <source>Uses a dark grey background.</source>
        <translation>深灰色背景。</translation>
    </message>
    <message>
        <source>&amp;Sky</source>
        <translation>天空(&amp;S)</translation>
    </message>
    <message>
        <source>Uses a pale blue sky as background.</source>
        <translation>淡蓝色天空背景。</translation>
    </message>
    <message>
        <source>W&amp;hite</source>
        <translation>白色(&amp;H)</translation>
    </message>
    <message>
        <source>Uses a plain white background.</source>
        <translation>纯白色背景。</translation>
    </message>
    <message>
        <source>&amp;Black</source>
        <translation>黑色(&amp;B)</translation>
    </message>
    <message>
        <source>Uses a plain black background.</source>
        <translation>纯黑色背景。</translation>
    </message>
    <message>
        <source>Mat&amp;erial</source>
        <translation>材质(&amp;E)</translation>
    </message>
    <message>
        <source>Ba&amp;ckground</source>
        <translation>背景(&amp;C)</translation>
    </message>
    <message>
        <source>Set Radius by &amp;Dragging</source>
        <translation>拖动调整半径(&amp;D)</translation>
    </message>
    <message>
        <source>Changes the radius as the pointer moves. Click or press Return to keep it; Esc or a right click cancels.</source>
        <translation>随指针移动改变半径。单击或按回车确定；Esc 或右键取消。</translation>
    </message>
    <message>
        <source>Set Strength by Draggin&amp;g</source>
        <translation>拖动调整强度(&amp;G)</translation>
    </message>
    <message>
        <source>Changes the strength as the pointer moves. Click or press Return to keep it; Esc or a right click cancels.</source>
        <translation>随指针移动改变强度。单击或按回车确定；Esc 或右键取消。</translation>
    </message>
    <message>
        <source>S&amp;teady Stroke</source>
        <translation>平稳笔画(&amp;T)</translation>
    </message>
    <message>
        <source>Drags the brush on a string behind the pointer, for smooth lines even with a trembling hand.</source>
        <translation>用一根线在指针后面拖动笔刷，手抖也能画出平滑的线条。</translation>
    </message>
    <message>
        <source>Paint &amp;Colour</source>
        <translation>笔刷颜色(&amp;C)</translation>
    </message>
    <message>
        <source>Shows the panel with the paint colour.</source>
        <translation>显示笔刷颜色面板。</translation>
    </message>
    <message>
        <source>Pic&amp;k Colour</source>
        <translation>取色(&amp;K)</translation>
    </message>
    <message>
        <source>Picks the paint colour from the model with the next click.</source>
        <translation>用下一次单击从模型上取笔刷颜色。</translation>
    </message>
    <message>
        <source>S&amp;wap Colours</source>
        <translation>交换颜色(&amp;W)</translation>
    </message>
    <message>
        <source>Paints with the other colour, and keeps this one for the next swap.</source>
        <translation>改用另一种颜色上色，并保留这一种供下次交换。</translation>
    </message>
    <message>
        <source>&amp;Fill with Colour</source>
        <translation>填充颜色(&amp;F)</translation>
    </message>
    <message>
        <source>Fills the active part with the paint colour.</source>
        <translation>用笔刷颜色填充当前部件。</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>首选项(&amp;P)…</translation>
    </message>
    <message>
        <source>Sets colours, language, keys, pen and mouse.</source>
        <translation>设置颜色、语言、快捷键、手写笔和鼠标。</translation>
    </message>
    <message>
        <source>Add &amp;Ball</source>
        <translation>添加球(&amp;B)</translation>
    </message>
    <message>
        <source>Export &amp;Drawing…</source>
        <translation>导出图纸(&amp;D)…</translation>
    </message>
    <message>
        <source>Writes a sheet with front, side and top view to scale: PDF, SVG or PNG.</source>
        <translation>按比例绘制含正视、侧视和俯视图的图纸：PDF、SVG 或 PNG。</translation>
    </message>
    <message>
        <source>Re&amp;vert</source>
        <translation>还原(&amp;V)</translation>
    </message>
    <message>
        <source>Opens the model&apos;s file again, as it was last saved.</source>
        <translation>重新打开模型文件，恢复到上次保存的内容。</translation>
    </message>
    <message>
        <source>&amp;Ball</source>
        <translation>球(&amp;B)</translation>
    </message>
    <message>
        <source>Begins with a ball of clay.</source>
        <translation>从黏土球开始。</translation>
    </message>
    <message>
        <source>&amp;Cube</source>
        <translation>立方体(&amp;C)</translation>
    </message>
    <message>
        <source>Begins with a cube of clay.</source>
        <translation>从黏土立方体开始。</translation>
    </message>
    <message>
        <source>&amp;Torus</source>
        <translation>圆环(&amp;T)</translation>
    </message>
    <message>
        <source>Begins with a ring of clay.</source>
        <translation>从黏土圆环开始。</translation>
    </message>
    <message>
        <source>&amp;Slab</source>
        <translation>厚板(&amp;S)</translation>
    </message>
    <message>
        <source>Begins with a thick square plate.</source>
        <translation>从厚方板开始。</translation>
    </message>
    <message>
        <source>&amp;Vase</source>
        <translation>花瓶(&amp;V)</translation>
    </message>
    <message>
        <source>Begins with a vase.</source>
        <translation>从花瓶开始。</translation>
    </message>
    <message>
        <source>&amp;Head</source>
        <translation>头像(&amp;H)</translation>
    </message>
    <message>
        <source>Begins with a head and neck.</source>
        <translation>从头和颈开始。</translation>
    </message>
    <message>
        <source>T&amp;ablet</source>
        <translation>浮雕板(&amp;A)</translation>
    </message>
    <message>
        <source>Begins with a thin plate for a relief.</source>
        <translation>从一块用于浮雕的薄板开始。</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>新建(&amp;N)</translation>
    </message>
    <message>
        <source>Tur&amp;ntable</source>
        <translation>转盘(&amp;N)</translation>
    </message>
    <message>
        <source>Turns the model under your hand. Hold still to cut a groove all around.</source>
        <translation>在您手下转动模型。手不动即可刻出一圈沟槽。</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Saves the model to its file.</source>
        <translation>将模型保存到其文件。</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Saves the model to another file and continues with that one.</source>
        <translation>将模型保存到另一个文件，之后继续使用该文件。</translation>
    </message>
    <message>
        <source>Reset to S&amp;tart</source>
        <translation>重置到起点(&amp;T)</translation>
    </message>
    <message>
        <source>Gives the model the shape and the colours that it was opened with. You can undo this.</source>
        <translation>让模型恢复打开时的形状和颜色。可以撤销。</translation>
    </message>
    <message>
        <source>Save Nu&amp;mbered Copy</source>
        <translation>保存编号副本(&amp;M)</translation>
    </message>
    <message>
        <source>Writes the model beside its file, with the next free number in the name.</source>
        <translation>将模型保存到其文件旁边，文件名带下一个可用编号。</translation>
    </message>
    <message>
        <source>&amp;Browse Files</source>
        <translation>浏览文件(&amp;B)</translation>
    </message>
    <message>
        <source>Shows the panel with a folder of models as pictures.</source>
        <translation>显示面板，以图片列出文件夹中的模型。</translation>
    </message>
    <message>
        <source>Pulls the surface outwards. %1 pushes instead, Shift smooths.</source>
        <translation>将表面向外拉。按住 %1 推入，按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>Pushes the surface inwards. %1 pulls instead, Shift smooths.</source>
        <translation>将表面向内推。按住 %1 拉出，按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>The right button turns the view.</source>
        <translation>鼠标右键旋转视图。</translation>
    </message>
    <message>
        <source>&amp;User Guide</source>
        <translation>用户指南(&amp;U)</translation>
    </message>
    <message>
        <source>Opens the guide beside the window: first steps, lessons, and a page for everything.</source>
        <translation>在窗口旁打开指南：入门、课程，以及各个主题的页面。</translation>
    </message>
    <message>
        <source>&amp;Start Page</source>
        <translation>起始页(&amp;S)</translation>
    </message>
    <message>
        <source>Shows what to begin with: starters, recent files, and three short lessons.</source>
        <translation>显示可以从何开始：起始形状、最近的文件和三节短课。</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>选择(&amp;C)…</translation>
    </message>
    <message>
        <source>Adds an image behind the model, on the side that you look from.</source>
        <translation>在模型后面添加图片，用于当前观看的一侧。</translation>
    </message>
    <message>
        <source>&amp;Show Reference Images</source>
        <translation>显示参考图(&amp;S)</translation>
    </message>
    <message>
        <source>Shows the image of a side while the view looks from there.</source>
        <translation>从某一侧观看时，显示该侧的图片。</translation>
    </message>
    <message>
        <source>&amp;Remove Reference Image</source>
        <translation>移除参考图(&amp;R)</translation>
    </message>
    <message>
        <source>Removes the image of the side that you look from.</source>
        <translation>移除当前观看一侧的图片。</translation>
    </message>
    <message>
        <source>Refere&amp;nce Image</source>
        <translation>参考图(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>打开(&amp;O)</translation>
    </message>
    <message>
        <source>Opens the selected model of the Files panel, or enters the folder.</source>
        <translation>打开“文件”面板中选中的模型，或进入文件夹。</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>重命名(&amp;R)</translation>
    </message>
    <message>
        <source>Renames the selected file of the Files panel; its ending stays.</source>
        <translation>重命名“文件”面板中选中的文件；扩展名不变。</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>复制一份(&amp;D)</translation>
    </message>
    <message>
        <source>Makes a copy of the selected file of the Files panel beside it.</source>
        <translation>为“文件”面板中选中的文件创建副本。</translation>
    </message>
    <message>
        <source>Move to &amp;Trash</source>
        <translation>移到回收站(&amp;T)</translation>
    </message>
    <message>
        <source>Moves the selected file of the Files panel to the trash.</source>
        <translation>把“文件”面板中选中的文件移到回收站。</translation>
    </message>
    <message>
        <source>&amp;Show in Folder</source>
        <translation>在文件夹中显示(&amp;S)</translation>
    </message>
    <message>
        <source>Shows the selected file of the Files panel in the desktop&apos;s file manager.</source>
        <translation>在系统的文件管理器中显示“文件”面板中选中的文件。</translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <translation>上一级(&amp;U)</translation>
    </message>
    <message>
        <source>Goes up one folder in the Files panel.</source>
        <translation>在“文件”面板中进入上一级文件夹。</translation>
    </message>
    <message>
        <source>&amp;Choose Folder…</source>
        <translation>选择文件夹(&amp;C)…</translation>
    </message>
    <message>
        <source>Asks for the folder that the Files panel shows.</source>
        <translation>选择“文件”面板显示的文件夹。</translation>
    </message>
    <message>
        <source>Files &amp;Panel</source>
        <translation>文件面板(&amp;P)</translation>
    </message>
    <message>
        <source>Opens a model from a file.</source>
        <translation>从文件打开模型。</translation>
    </message>
    <message>
        <source>Writes the model to an STL, OBJ, PLY, OFF, GLB or 3MF file. Its own file stays as it is.</source>
        <translation>把模型写入 STL、OBJ、PLY、OFF、GLB 或 3MF 文件。模型自己的文件不变。</translation>
    </message>
    <message>
        <source>Export for &amp;Print or Game…</source>
        <translation>导出用于打印或游戏(&amp;P)…</translation>
    </message>
    <message>
        <source>Writes STL, 3MF or GLB with as many triangles as you like, and verifies the file.</source>
        <translation>导出 STL、3MF 或 GLB，三角形数量由您决定，并核对文件。</translation>
    </message>
    <message>
        <source>P&amp;lace on Bed</source>
        <translation>放到打印床(&amp;L)</translation>
    </message>
    <message>
        <source>Moves the model&apos;s lowest point to height 0, onto the printer&apos;s bed.</source>
        <translation>把模型的最低点移到高度 0，即打印床上。</translation>
    </message>
    <message>
        <source>Flatten &amp;Base…</source>
        <translation>压平底部(&amp;B)…</translation>
    </message>
    <message>
        <source>Cuts the bottom off level, so that the model stands flat.</source>
        <translation>水平切去底部，使模型平稳站立。</translation>
    </message>
    <message>
        <source>&amp;Print Check</source>
        <translation>打印检查(&amp;P)</translation>
    </message>
    <message>
        <source>Shows whether the model prints: walls, overhangs, base, and the printer&apos;s bed.</source>
        <translation>显示模型能否打印：壁厚、悬垂、底面和打印床。</translation>
    </message>
    <message>
        <source>&amp;Enter VR</source>
        <translation>进入 VR(&amp;E)</translation>
    </message>
    <message>
        <source>Sculpts in VR with a headset. Choose it again to leave VR.</source>
        <translation>用头显在 VR 中雕刻。再次选择即离开 VR。</translation>
    </message>
    <message>
        <source>&amp;Follow the Head</source>
        <translation>跟随头部(&amp;F)</translation>
    </message>
    <message>
        <source>Shows in this window what the headset sees, for a class to watch.</source>
        <translation>在此窗口显示头显中的画面，供全班观看。</translation>
    </message>
    <message>
        <source>&amp;Inflate</source>
        <translation>膨胀(&amp;I)</translation>
    </message>
    <message>
        <source>Swells the surface in all directions. %1 shrinks it instead, Shift smooths.</source>
        <translation>使表面向四面膨胀。按住 %1 收缩，按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>Adds a flat layer and fills hollows first. %1 digs instead, Shift smooths.</source>
        <translation>铺上一层平整的黏土，先填满凹处。按住 %1 挖去，按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>Raises the surface to one height per stroke, however often you go over it. %1 sinks it instead, Shift smooths.</source>
        <translation>一笔之内把表面升到同一高度，反复经过也不再升高。按住 %1 下沉，按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>Sc&amp;rape</source>
        <translation>刮平(&amp;R)</translation>
    </message>
    <message>
        <source>Removes what is above the average plane. %1 fills what is below instead, Shift smooths.</source>
        <translation>刮去高出平均平面的部分。按住 %1 填补低于它的部分，按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>Pi&amp;nch</source>
        <translation>收拢(&amp;N)</translation>
    </message>
    <message>
        <source>Pulls the surface together towards the stroke. %1 spreads it instead, Shift smooths.</source>
        <translation>把表面向笔画收拢。按住 %1 撑开，按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>Cr&amp;ease</source>
        <translation>刻痕(&amp;E)</translation>
    </message>
    <message>
        <source>Cuts a sharp groove. %1 raises a sharp ridge instead, Shift smooths.</source>
        <translation>刻出锐利的沟。按住 %1 隆起锐利的脊，按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>&amp;Grab</source>
        <translation>抓取(&amp;G)</translation>
    </message>
    <message>
        <source>Moves the surface under the brush along with the pointer. Shift smooths.</source>
        <translation>使笔刷下的表面随指针移动。按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>Snake &amp;Hook</source>
        <translation>蛇形钩(&amp;H)</translation>
    </message>
    <message>
        <source>Pulls out a tentacle, and the brush follows its tip. Shift smooths.</source>
        <translation>拉出一条触手，笔刷跟随它的尖端。按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>&amp;Twist</source>
        <translation>扭转(&amp;T)</translation>
    </message>
    <message>
        <source>Twists the surface under the brush as you drag away from it. %1 twists it the other way, Shift smooths.</source>
        <translation>从笔刷处向外拖动，扭转笔刷下的表面。按住 %1 反向扭转，按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>Hold %1 on the model to invert the tool, %2 to smooth.</source>
        <translation>在模型上按住 %1 反向使用工具，按住 %2 平滑。</translation>
    </message>
    <message>
        <source>Tool&amp;s</source>
        <translation>工具(&amp;S)</translation>
    </message>
    <message>
        <source>C&amp;lay</source>
        <translation>铺泥(&amp;C)</translation>
    </message>
    <message>
        <source>La&amp;yer</source>
        <translation>加层(&amp;Y)</translation>
    </message>
    <message>
        <source>Protects the surface from other tools. %1 erases the mask instead, Shift smooths.</source>
        <translation>保护表面不受其他工具影响。按住 %1 擦去遮罩，按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>&amp;Invert Mask</source>
        <translation>反转遮罩(&amp;I)</translation>
    </message>
    <message>
        <source>Swaps protected and unprotected areas.</source>
        <translation>交换受保护和未受保护的区域。</translation>
    </message>
    <message>
        <source>&amp;Clear Mask</source>
        <translation>清除遮罩(&amp;C)</translation>
    </message>
    <message>
        <source>Removes the mask from the active part.</source>
        <translation>移除当前部件的遮罩。</translation>
    </message>
    <message>
        <source>&amp;Blur Mask</source>
        <translation>模糊遮罩(&amp;B)</translation>
    </message>
    <message>
        <source>Makes the mask&apos;s edge softer.</source>
        <translation>让遮罩的边缘更柔和。</translation>
    </message>
    <message>
        <source>&amp;Sharpen Mask</source>
        <translation>锐化遮罩(&amp;S)</translation>
    </message>
    <message>
        <source>Makes the mask&apos;s edge harder.</source>
        <translation>让遮罩的边缘更锐利。</translation>
    </message>
    <message>
        <source>&amp;Grow Mask</source>
        <translation>扩大遮罩(&amp;G)</translation>
    </message>
    <message>
        <source>Widens the mask by one triangle.</source>
        <translation>把遮罩扩大一圈三角形。</translation>
    </message>
    <message>
        <source>S&amp;hrink Mask</source>
        <translation>缩小遮罩(&amp;H)</translation>
    </message>
    <message>
        <source>Narrows the mask by one triangle.</source>
        <translation>把遮罩缩小一圈三角形。</translation>
    </message>
    <message>
        <source>Mask C&amp;avities</source>
        <translation>遮罩凹处(&amp;A)</translation>
    </message>
    <message>
        <source>Also protects hollows.</source>
        <translation>同时保护凹陷处。</translation>
    </message>
    <message>
        <source>Mask by Co&amp;lour</source>
        <translation>按颜色遮罩(&amp;L)</translation>
    </message>
    <message>
        <source>Also protects areas close to the paint colour.</source>
        <translation>同时保护与笔刷颜色相近的区域。</translation>
    </message>
    <message>
        <source>M&amp;ask</source>
        <translation>遮罩(&amp;A)</translation>
    </message>
    <message>
        <source>Sta&amp;mp</source>
        <translation>图章(&amp;M)</translation>
    </message>
    <message>
        <source>Presses a ball or a model of yours into the surface. %1 raises it instead, Shift smooths.</source>
        <translation>把球或您的模型压入表面。按住 %1 隆起，按住 Shift 平滑。</translation>
    </message>
    <message>
        <source>Repeats strokes around the vertical axis. Set the count in the Symmetry panel.</source>
        <translation>绕竖直轴重复笔画。数量在“对称”面板中设定。</translation>
    </message>
    <message>
        <source>Mas&amp;k</source>
        <translation>遮罩(&amp;K)</translation>
    </message>
    <message>
        <source>Adds a ball of the brush&apos;s radius, or the stamp&apos;s model, where you click next.</source>
        <translation>在下一次单击处添加半径与笔刷相同的球，或图章的模型。</translation>
    </message>
    <message>
        <source>Radial Symm&amp;etry</source>
        <translation>径向对称(&amp;E)</translation>
    </message>
    <message>
        <source>Mo&amp;del</source>
        <translation>模型(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>课程(&amp;L)</translation>
    </message>
    <message>
        <source>Shows how something is made, stroke by stroke, and lets you try it.</source>
        <translation>一笔一笔地演示怎么做，然后由您来试。</translation>
    </message>
    <message>
        <source>&amp;Classroom…</source>
        <translation>课堂(&amp;C)…</translation>
    </message>
    <message>
        <source>Makes a class file: what pupils may do, how long their turns are, and the PIN that ends the class.</source>
        <translation>创建课堂文件：学生可以做什么、每轮多长时间，以及结束课堂的 PIN。</translation>
    </message>
    <message>
        <source>&amp;Class Report…</source>
        <translation>班级报告(&amp;C)…</translation>
    </message>
    <message>
        <source>Writes a report on the models in a folder: picture, size, print-ready or why not, strokes and time. HTML or PDF.</source>
        <translation>为文件夹中的模型生成报告：图片、大小、能否打印或为何不能、笔画数和用时。HTML 或 PDF。</translation>
    </message>
    <message>
        <source>&amp;Use Model as Brush</source>
        <translation>把模型用作笔刷(&amp;U)</translation>
    </message>
    <message>
        <source>Uses this model, as it is now, as the stamp.</source>
        <translation>把现在的模型用作图章。</translation>
    </message>
    <message>
        <source>Caption in &amp;VR</source>
        <translation>VR 大字说明(&amp;V)</translation>
    </message>
    <message>
        <source>Shows tool, radius and the time left in large letters while somebody is in VR.</source>
        <translation>有人在 VR 中时，用大字显示工具、半径和剩余时间。</translation>
    </message>
    <message>
        <source>&amp;Point</source>
        <translation>指点(&amp;P)</translation>
    </message>
    <message>
        <source>Shows the person in VR a light where the pointer is on the model. Hold the key to point only for that time.</source>
        <translation>在模型上指针所在处给 VR 中的人显示一个光点。按住该键则只在按住时指点。</translation>
    </message>
    <message>
        <source>&amp;Take Over</source>
        <translation>接手(&amp;T)</translation>
    </message>
    <message>
        <source>Lets only this window sculpt until you give it back; the person in VR watches.</source>
        <translation>只允许此窗口雕刻，直到您交还；VR 中的人观看。</translation>
    </message>
    <message>
        <source>Rec&amp;ord Lesson…</source>
        <translation>录制课程(&amp;O)…</translation>
    </message>
    <message>
        <source>Makes a lesson from what you sculpt, step by step, or changes an existing one.</source>
        <translation>把您的雕刻一步一步做成课程，或修改已有的课程。</translation>
    </message>
    <message>
        <source>Edit &amp;Last Stroke…</source>
        <translation>修改最后一笔(&amp;L)…</translation>
    </message>
    <message>
        <source>Changes tool, radius or strength of the last stroke.</source>
        <translation>更改最后一笔的工具、半径或强度。</translation>
    </message>
    <message>
        <source>Export Time-&amp;Lapse…</source>
        <translation>导出延时图片(&amp;L)…</translation>
    </message>
    <message>
        <source>Draws the model after each of its steps, as numbered PNG pictures for a film.</source>
        <translation>画出模型每一步之后的样子，存为带编号的 PNG 图片，可用于制作影片。</translation>
    </message>
    <message>
        <source>In&amp;vert</source>
        <translation>反转(&amp;V)</translation>
    </message>
    <message>
        <source>Inverts the tools without holding %1: Pull pushes, Clay digs.</source>
        <translation>无需按住 %1 即可反转工具：拉出变为推入，铺泥变为挖去。</translation>
    </message>
    <message>
        <source>Shows a cross that the arrow keys move: on the model Space or Return uses the tool, beside it the view turns.</source>
        <translation>显示一个用方向键移动的十字：在模型上按空格或回车使用工具，在模型之外转动视图。</translation>
    </message>
    <message>
        <source>Turn &amp;Left</source>
        <translation>向左转(&amp;L)</translation>
    </message>
    <message>
        <source>Turns the model&apos;s near side to the left by 15 degrees.</source>
        <translation>把模型朝向您的一侧向左转 15 度。</translation>
    </message>
    <message>
        <source>Turn &amp;Right</source>
        <translation>向右转(&amp;R)</translation>
    </message>
    <message>
        <source>Turns the model&apos;s near side to the right by 15 degrees.</source>
        <translation>把模型朝向您的一侧向右转 15 度。</translation>
    </message>
    <message>
        <source>Turn &amp;Up</source>
        <translation>向上转(&amp;U)</translation>
    </message>
    <message>
        <source>Turns the model&apos;s near side upwards by 15 degrees.</source>
        <translation>把模型朝向您的一侧向上转 15 度。</translation>
    </message>
    <message>
        <source>Turn &amp;Down</source>
        <translation>向下转(&amp;D)</translation>
    </message>
    <message>
        <source>Turns the model&apos;s near side downwards by 15 degrees.</source>
        <translation>把模型朝向您的一侧向下转 15 度。</translation>
    </message>
    <message>
        <source>&amp;Nearer</source>
        <translation>靠近(&amp;N)</translation>
    </message>
    <message>
        <source>Shows the model larger.</source>
        <translation>把模型显示得更大。</translation>
    </message>
    <message>
        <source>&amp;Farther</source>
        <translation>远离(&amp;F)</translation>
    </message>
    <message>
        <source>Shows the model smaller.</source>
        <translation>把模型显示得更小。</translation>
    </message>
    <message>
        <source>&amp;One Hand</source>
        <translation>单手(&amp;O)</translation>
    </message>
    <message>
        <source>Uses one controller, with the panels in front of you, from the next time you enter VR.</source>
        <translation>从下次进入 VR 起只用一只手柄，面板位于您面前。</translation>
    </message>
    <message>
        <source>Sculpts with the left hand, from the next time you enter VR.</source>
        <translation>从下次进入 VR 起，用左手雕刻。</translation>
    </message>
    <message>
        <source>T&amp;urn and Zoom</source>
        <translation>转动与缩放(&amp;U)</translation>
    </message>
    <message>
        <source>Scul&amp;pt by Keys</source>
        <translation>用按键雕刻(&amp;P)</translation>
    </message>
    <message>
        <source>Left-&amp;Handed</source>
        <translation>左手(&amp;H)</translation>
    </message>
    <message>
        <source>Mask Whole &amp;Pieces</source>
        <translation>遮罩整块(&amp;P)</translation>
    </message>
    <message>
        <source>Extends the mask to the whole of each connected piece that it touches.</source>
        <translation>把遮罩扩展到它碰到的每个连通块的整体。</translation>
    </message>
    <message>
        <source>Adds a copy of the active part at the same place. The copy becomes active.</source>
        <translation>在同一位置添加当前部件的副本。副本成为当前部件。</translation>
    </message>
    <message>
        <source>Selec&amp;t a Part</source>
        <translation>选择部件(&amp;T)</translation>
    </message>
    <message>
        <source>Makes the part active that you click next. Alt and a click do the same, where the desktop leaves Alt to the program.</source>
        <translation>使您接下来点击的部件成为当前部件。如果桌面没有占用 Alt，按住 Alt 点击也一样。</translation>
    </message>
    <message>
        <source>&amp;Separate</source>
        <translation>拆分(&amp;S)</translation>
    </message>
    <message>
        <source>Makes each connected piece of the active part a part of its own.</source>
        <translation>将当前部件的每个连通块变成独立的部件。</translation>
    </message>
    <message>
        <source>D&amp;elete</source>
        <translation>删除(&amp;E)</translation>
    </message>
    <message>
        <source>Deletes the active part.</source>
        <translation>删除当前部件。</translation>
    </message>
    <message>
        <source>&amp;Join</source>
        <translation>合并(&amp;J)</translation>
    </message>
    <message>
        <source>Joins the active part with the other selected parts into one solid.</source>
        <translation>将当前部件与其他选中的部件合并为一个实体。</translation>
    </message>
    <message>
        <source>S&amp;ubtract</source>
        <translation>减去(&amp;U)</translation>
    </message>
    <message>
        <source>Takes the other selected parts away from the active part.</source>
        <translation>从当前部件中减去其他选中的部件。</translation>
    </message>
    <message>
        <source>&amp;Intersect</source>
        <translation>相交(&amp;I)</translation>
    </message>
    <message>
        <source>Keeps what the active part has in common with the other selected parts.</source>
        <translation>保留当前部件与其他选中部件的公共部分。</translation>
    </message>
    <message>
        <source>Is&amp;olate</source>
        <translation>单独显示(&amp;O)</translation>
    </message>
    <message>
        <source>Shows only the active part. Again: shows the others as before.</source>
        <translation>只显示当前部件。再次使用：恢复其他部件的显示。</translation>
    </message>
    <message>
        <source>&amp;Hide or Show</source>
        <translation>隐藏或显示(&amp;H)</translation>
    </message>
    <message>
        <source>Hides the active part, or shows it again.</source>
        <translation>隐藏当前部件，或重新显示它。</translation>
    </message>
    <message>
        <source>Show &amp;All</source>
        <translation>全部显示(&amp;A)</translation>
    </message>
    <message>
        <source>Shows everything that is hidden: parts and areas.</source>
        <translation>显示所有隐藏的内容：部件和区域。</translation>
    </message>
    <message>
        <source>&amp;Lock or Unlock</source>
        <translation>锁定或解锁(&amp;L)</translation>
    </message>
    <message>
        <source>Protects the active part from all changes, or unlocks it again.</source>
        <translation>保护当前部件不被更改，或解除锁定。</translation>
    </message>
    <message>
        <source>Changes the name of the active part.</source>
        <translation>更改当前部件的名称。</translation>
    </message>
    <message>
        <source>&amp;Colour in the List…</source>
        <translation>列表中的颜色(&amp;C)…</translation>
    </message>
    <message>
        <source>Marks the active part with a colour in the list.</source>
        <translation>在列表中用颜色标记当前部件。</translation>
    </message>
    <message>
        <source>Move U&amp;p</source>
        <translation>上移(&amp;P)</translation>
    </message>
    <message>
        <source>Moves the active part up in the list.</source>
        <translation>在列表中将当前部件上移。</translation>
    </message>
    <message>
        <source>Move Do&amp;wn</source>
        <translation>下移(&amp;W)</translation>
    </message>
    <message>
        <source>Moves the active part down in the list.</source>
        <translation>在列表中将当前部件下移。</translation>
    </message>
    <message>
        <source>Pa&amp;rts</source>
        <translation>部件(&amp;R)</translation>
    </message>
    <message>
        <source>Hide &amp;Masked</source>
        <translation>隐藏被遮罩的部分(&amp;M)</translation>
    </message>
    <message>
        <source>Hides what is masked. Hidden clay is neither seen nor changed.</source>
        <translation>隐藏被遮罩的部分。隐藏的粘土既不显示也不会被更改。</translation>
    </message>
    <message>
        <source>Hide &amp;Unmasked</source>
        <translation>隐藏未遮罩的部分(&amp;U)</translation>
    </message>
    <message>
        <source>Hides what is not masked.</source>
        <translation>隐藏未被遮罩的部分。</translation>
    </message>
    <message>
        <source>Sho&amp;w Hidden</source>
        <translation>显示隐藏的部分(&amp;W)</translation>
    </message>
    <message>
        <source>Shows all clay that was hidden by its mask.</source>
        <translation>显示所有按遮罩隐藏的粘土。</translation>
    </message>
    <message>
        <source>Adds another model from a file to this one, or subtracts it.</source>
        <translation>从文件向此模型添加另一个模型，或从中减去。</translation>
    </message>
    <message>
        <source>Insert Primiti&amp;ve…</source>
        <translation>插入基本体(&amp;V)…</translation>
    </message>
    <message>
        <source>Adds a box, ball, cylinder or other solid with given measures, or subtracts it.</source>
        <translation>按给定尺寸添加长方体、球体、圆柱体或其他实体，或从中减去。</translation>
    </message>
    <message>
        <source>&amp;Move, Rotate, Scale</source>
        <translation>移动、旋转、缩放(&amp;M)</translation>
    </message>
    <message>
        <source>Shows handles and numbers to move, rotate and scale the active part, or the part of it that is not masked.</source>
        <translation>显示手柄和数值，用来移动、旋转和缩放当前部件，或其中未遮罩的部分。</translation>
    </message>
    <message>
        <source>&amp;Mask Area</source>
        <translation>遮罩区域(&amp;M)</translation>
    </message>
    <message>
        <source>Protects what you draw around: with a lasso, box, line or polygon.</source>
        <translation>保护您圈出的部分：用套索、方框、直线或多边形。</translation>
    </message>
    <message>
        <source>&amp;Unmask Area</source>
        <translation>移除区域的遮罩(&amp;U)</translation>
    </message>
    <message>
        <source>Removes the mask in an area that you draw.</source>
        <translation>移除您所画区域中的遮罩。</translation>
    </message>
    <message>
        <source>&amp;Hide Area</source>
        <translation>隐藏区域(&amp;H)</translation>
    </message>
    <message>
        <source>Hides an area that you draw. Hidden clay is neither seen nor changed.</source>
        <translation>隐藏您所画的区域。隐藏的粘土既不显示也不会被更改。</translation>
    </message>
    <message>
        <source>&amp;Trim Away</source>
        <translation>裁剪(&amp;T)</translation>
    </message>
    <message>
        <source>Cuts away what you draw around, through the whole depth or only in front.</source>
        <translation>切去您圈出的部分，可贯穿整个深度，也可只切前面。</translation>
    </message>
    <message>
        <source>&amp;Split Off</source>
        <translation>分离(&amp;S)</translation>
    </message>
    <message>
        <source>Makes what you draw around a part of its own.</source>
        <translation>把您圈出的部分变成独立的部件。</translation>
    </message>
    <message>
        <source>Cut by &amp;Plane</source>
        <translation>用平面切割(&amp;P)</translation>
    </message>
    <message>
        <source>Cuts along a plane that you place with handles: removes one side, or makes two parts.</source>
        <translation>沿用手柄放置的平面切割：去掉一侧，或分成两个部件。</translation>
    </message>
    <message>
        <source>&amp;Area in the View</source>
        <translation>视图中的区域(&amp;A)</translation>
    </message>
    <message>
        <source>Puts a box, ball, cylinder or other solid on the model or the ground, by a press and a drag.</source>
        <translation>按下并拖动，把长方体、球、圆柱或其他实体放到模型或地面上。</translation>
    </message>
    <message>
        <source>Makes a tube along a curve that you draw over the view; each of its points gets a radius.</source>
        <translation>沿着在视图上绘制的曲线生成管子；曲线的每个点都有自己的半径。</translation>
    </message>
    <message>
        <source>&amp;Draw a Tube</source>
        <translation>绘制管子(&amp;D)</translation>
    </message>
    <message>
        <source>Plac&amp;e a Primitive</source>
        <translation>放置基本体(&amp;E)</translation>
    </message>
</context>
<context>
    <name>ui::AnswerScale</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1，共 %2</translation>
    </message>
</context>
<context>
    <name>ui::BrushDrag</name>
    <message>
        <source>%1: %2 mm</source>
        <translation>%1：%2 mm</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>ui::BrushFiles</name>
    <message>
        <source>%1 is too flat for a brush shape.</source>
        <translation>%1 太扁，不能用作笔刷形状。</translation>
    </message>
    <message>
        <source>%1 is too small for a brush shape.</source>
        <translation>%1 太小，不能用作笔刷形状。</translation>
    </message>
    <message>
        <source>%1 has too many triangles for a brush shape: at most %2 are allowed. Export it with fewer triangles first.</source>
        <translation>%1 的三角形太多，不能用作笔刷形状：最多允许 %2 个。请先以较少的三角形导出。</translation>
    </message>
    <message>
        <source>%1: there is no such file.</source>
        <translation>%1：没有这个文件。</translation>
    </message>
    <message>
        <source>%1 is not an image that can be read.</source>
        <translation>%1 不是可读取的图像。</translation>
    </message>
    <message>
        <source>%1 has %2 × %3 pixels: an alpha may have %4 on a side at most.</source>
        <translation>%1 有 %2 × %3 像素：Alpha 每边最多 %4 像素。</translation>
    </message>
    <message>
        <source>%1: this image is damaged.</source>
        <translation>%1：此图像已损坏。</translation>
    </message>
    <message>
        <source>%1 is all black: the brush would do nothing.</source>
        <translation>%1 全是黑色：笔刷不会有任何作用。</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this model.</source>
        <translation>%1：内存不足，无法载入此模型。</translation>
    </message>
</context>
<context>
    <name>ui::BrushPalette</name>
    <message>
        <source>Palette</source>
        <translation>选板</translation>
    </message>
    <message>
        <source>Brush presets</source>
        <translation>笔刷预设</translation>
    </message>
</context>
<context>
    <name>ui::BrushPanels</name>
    <message>
        <source>Brush</source>
        <translation>笔刷</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>作用范围</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>球</translation>
    </message>
    <message>
        <source>Along the surface</source>
        <translation>沿表面</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>拓扑</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>边长</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>细化</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>自适应</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>均匀</translation>
    </message>
    <message>
        <source>Fuse touching surfaces</source>
        <translation>融合相碰的表面</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>对称</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>镜像</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Left and right (x = 0)</source>
        <translation>左右 (x = 0)</translation>
    </message>
    <message>
        <source>Top and bottom (y = 0)</source>
        <translation>上下 (y = 0)</translation>
    </message>
    <message>
        <source>Front and back (z = 0)</source>
        <translation>前后 (z = 0)</translation>
    </message>
    <message>
        <source>Length of the string between pointer and brush. A longer one makes smoother lines.</source>
        <translation>指针与笔刷之间的线长。线越长，线条越平滑。</translation>
    </message>
    <message>
        <source>Airbrush</source>
        <translation>喷枪</translation>
    </message>
    <message>
        <source>The tool continues for as long as you hold it in one place.</source>
        <translation>按住不动时，工具持续作用。</translation>
    </message>
    <message>
        <source>Drag out size and direction</source>
        <translation>拖出大小和方向</translation>
    </message>
    <message>
        <source>Press where the alpha or the stamp should go, and drag: the distance sets its radius, and it points up where you drag. A click makes it as large as the brush.</source>
        <translation>在放置 Alpha 或图章处按下并拖动：距离决定半径，拖动方向为上方。单击则与笔刷一样大。</translation>
    </message>
    <message>
        <source>Steady stroke</source>
        <translation>平稳笔画</translation>
    </message>
    <message>
        <source>Length of the string</source>
        <translation>线的长度</translation>
    </message>
    <message>
        <source> px</source>
        <translation> 像素</translation>
    </message>
    <message>
        <source>Sectors of the radial symmetry</source>
        <translation>径向对称的扇区数</translation>
    </message>
    <message>
        <source>Repeats your strokes in this number of sectors around the vertical axis (y), mirrored in each if Mirror is on.</source>
        <translation>在绕竖直轴（y）的这么多个扇区中重复您的笔画；打开镜像时，各扇区内也会镜像。</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>With this count the sectors look alike; with 2 and 4 they are exactly alike.</source>
        <translation>扇区数为此值时，各扇区看起来相同；为 2 和 4 时完全相同。</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>径向</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>Follows the stroke</source>
        <translation>跟随笔画</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>图章</translation>
    </message>
    <message>
        <source>Same radius for all tools</source>
        <translation>所有工具共用半径</translation>
    </message>
    <message>
        <source>Keeps the radius when you change the tool. When off, each tool has its own radius, just as it has its own strength.</source>
        <translation>切换工具时半径不变。关闭后，每个工具有各自的半径，正如有各自的强度。</translation>
    </message>
</context>
<context>
    <name>ui::BrushShapes</name>
    <message>
        <source>The brush is without its alpha: %1</source>
        <comment>a sentence that says why</comment>
        <translation>笔刷已没有 Alpha：%1</translation>
    </message>
    <message>
        <source>Stamp has a ball again: %1</source>
        <comment>a sentence that says why</comment>
        <translation>图章恢复为球：%1</translation>
    </message>
</context>
<context>
    <name>ui::ClassBar</name>
    <message>
        <source>Class</source>
        <translation>课堂</translation>
    </message>
    <message>
        <source>Undoes Next Pupil: reopens the pupil&apos;s work and continues the turn. Possible until somebody sculpts.</source>
        <translation>撤销“下一位”：重新打开该学生的作品，继续这一轮。有人开始雕刻之前可用。</translation>
    </message>
    <message>
        <source>&amp;Next Pupil</source>
        <translation>下一位(&amp;N)</translation>
    </message>
    <message>
        <source>Saves the work in the class folder, and begins the next turn with fresh clay.</source>
        <translation>将作品保存到课堂文件夹，并以新的黏土开始下一轮。</translation>
    </message>
    <message>
        <source>&amp;Leave…</source>
        <translation>离开(&amp;L)…</translation>
    </message>
    <message>
        <source>Asks for the teacher&apos;s PIN, saves the work, and ends the class.</source>
        <translation>询问教师 PIN，保存作品，并结束课堂。</translation>
    </message>
    <message>
        <source>Time is up</source>
        <translation>时间到</translation>
    </message>
    <message numerus="yes">
        <source>%n minutes left</source>
        <translation>
            <numerusform>还剩 %n 分钟</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seconds left</source>
        <translation>
            <numerusform>还剩 %n 秒</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Resume %1&apos;s Turn</source>
        <translation>继续 %1 的作品(&amp;R)</translation>
    </message>
    <message numerus="yes">
        <source>%n models not yet in the class folder</source>
        <translation>
            <numerusform>%n 个模型尚未存入课堂文件夹</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Clock</source>
        <translation>时钟(&amp;C)</translation>
    </message>
    <message>
        <source>Shows a large clock in a window of its own, for the projector.</source>
        <translation>在单独的窗口中显示大时钟，供投影仪使用。</translation>
    </message>
</context>
<context>
    <name>ui::ClassClock</name>
    <message>
        <source>Next: %1</source>
        <translation>下一位：%1</translation>
    </message>
</context>
<context>
    <name>ui::ClassReport</name>
    <message>
        <source>Print-ready</source>
        <translation>可打印</translation>
    </message>
    <message>
        <source>Not print-ready</source>
        <translation>不可打印</translation>
    </message>
    <message>
        <source>Cannot be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Size, mm</source>
        <translation>大小，毫米</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>用时</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>笔画数</translation>
    </message>
    <message>
        <source>Class report: %1</source>
        <translation>班级报告：%1</translation>
    </message>
    <message>
        <source>%1 · models: %2 · print-ready: %3 · not print-ready: %4 · cannot be read: %5</source>
        <translation>%1 · 模型：%2 · 可打印：%3 · 不可打印：%4 · 无法读取：%5</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>回答数</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>What the pupils answered</source>
        <translation>学生的回答</translation>
    </message>
</context>
<context>
    <name>ui::ClassroomDialog</name>
    <message>
        <source>Classroom</source>
        <translation>课堂</translation>
    </message>
    <message>
        <source>Pupils take turns: each begins with fresh clay, and Next Pupil saves the work in the class folder. Pupils cannot reach other files; leaving asks for your PIN.</source>
        <translation>学生轮流进行：每人从新的黏土开始，“下一位”把作品保存到课堂文件夹。学生无法接触其他文件；离开需要您的 PIN。</translation>
    </message>
    <message>
        <source>Starting shapes</source>
        <translation>起始形状</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Saves the class to another file.</source>
        <translation>将课堂保存到另一个文件。</translation>
    </message>
    <message>
        <source>Shown in the top bar, such as the name of the class.</source>
        <translation>显示在最上方的栏中，例如班级名称。</translation>
    </message>
    <message>
        <source>&amp;Title:</source>
        <translation>标题(&amp;T)：</translation>
    </message>
    <message>
        <source>Each turn gets a folder there, with model, picture and recording.</source>
        <translation>每一轮在其中有一个文件夹，含模型、图片和记录。</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>选择(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Folder for pupils&apos; work:</source>
        <translation>作品文件夹(&amp;F)：</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分钟</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>不限</translation>
    </message>
    <message>
        <source>The length of a turn. Nothing is lost when it is over.</source>
        <translation>每轮的时长。时间到了也不会丢失任何内容。</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>How long before the end a notice appears, also in the headset.</source>
        <translation>结束前多久显示提示，头显中也会显示。</translation>
    </message>
    <message>
        <source>Full s&amp;creen</source>
        <translation>全屏(&amp;R)</translation>
    </message>
    <message>
        <source>Hides everything else on the screen.</source>
        <translation>隐藏屏幕上的其他内容。</translation>
    </message>
    <message>
        <source>The language of the window in this class.</source>
        <translation>课堂窗口所用的语言。</translation>
    </message>
    <message>
        <source>T&amp;urn:</source>
        <translation>每轮(&amp;U)：</translation>
    </message>
    <message>
        <source>&amp;Warning before the end:</source>
        <translation>结束前提醒(&amp;W)：</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>语言(&amp;L)：</translation>
    </message>
    <message>
        <source>Needed to leave the class. Stored as a hash, not as plain text.</source>
        <translation>离开课堂时需要。保存的是哈希值，而不是您输入的 PIN。</translation>
    </message>
    <message>
        <source>P&amp;IN:</source>
        <translation>&amp;PIN：</translation>
    </message>
    <message>
        <source>&amp;Repeat PIN:</source>
        <translation>再次输入 PIN(&amp;M)：</translation>
    </message>
    <message>
        <source>The class has no title yet.</source>
        <translation>课堂还没有标题。</translation>
    </message>
    <message>
        <source>This folder does not exist.</source>
        <translation>该文件夹不存在。</translation>
    </message>
    <message>
        <source>Choose at least one starting shape.</source>
        <translation>请至少选择一个起始形状。</translation>
    </message>
    <message>
        <source>Choose at least one tool.</source>
        <translation>请至少选择一个工具。</translation>
    </message>
    <message numerus="yes">
        <source>The PIN needs at least %n characters.</source>
        <translation>
            <numerusform>PIN 至少需要 %n 个字符。</numerusform>
        </translation>
    </message>
    <message>
        <source>The two PINs are not the same.</source>
        <translation>两次输入的 PIN 不一致。</translation>
    </message>
    <message>
        <source>Six &amp;questions after each turn</source>
        <translation>每轮之后的六个问题(&amp;Q)</translation>
    </message>
    <message>
        <source>Next Pupil shows a form about the program first. Its answers are saved with the work and summed up in the class report; each may be left out.</source>
        <translation>“下一位”会先显示关于程序的问卷。回答与作品一起保存，并在班级报告中汇总；每题都可以不答。</translation>
    </message>
    <message>
        <source>&amp;Open a Class…</source>
        <translation>打开课堂(&amp;O)…</translation>
    </message>
    <message>
        <source>Opens a class file to change it.</source>
        <translation>打开课堂文件以便修改。</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>不变</translation>
    </message>
    <message>
        <source>&amp;Make This Folder</source>
        <translation>新建此文件夹(&amp;K)</translation>
    </message>
    <message>
        <source>This folder cannot be created.</source>
        <translation>无法创建此文件夹。</translation>
    </message>
    <message>
        <source>Allow other &amp;names</source>
        <translation>允许其他名字(&amp;N)</translation>
    </message>
    <message>
        <source>For guests, and for names that are not on the list.</source>
        <translation>用于来访者，以及名单中没有的名字。</translation>
    </message>
    <message>
        <source>&amp;Pupils&apos; names:</source>
        <translation>学生名单(&amp;H)：</translation>
    </message>
    <message>
        <source>L&amp;esson:</source>
        <translation>课程(&amp;E)：</translation>
    </message>
</context>
<context>
    <name>ui::ColorPanel</name>
    <message>
        <source>Colour as #rrggbb</source>
        <translation>颜色（#rrggbb）</translation>
    </message>
    <message>
        <source>The paint colour as in web pages: # and two digits, 0 to f, for each of red, green and blue.</source>
        <translation>笔刷颜色的网页写法：# 后接红、绿、蓝各两位数字（0 到 f）。</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>红</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>绿</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>蓝</translation>
    </message>
    <message>
        <source>%1 of the paint colour, 0 to 255.</source>
        <translation>笔刷颜色的%1，0 到 255。</translation>
    </message>
    <message>
        <source>%1 is not a colour: write # and six digits from 0 to f.</source>
        <translation>%1 不是颜色：请输入 # 和六位数字（0 到 f）。</translation>
    </message>
    <message>
        <source>Paint colour %1, the other %2</source>
        <translation>笔刷颜色 %1，另一色 %2</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>No colour was picked: you did not click on the model.</source>
        <translation>未取到颜色：您没有单击模型。</translation>
    </message>
</context>
<context>
    <name>ui::ColorSwatches</name>
    <message>
        <source>Keep this colour</source>
        <translation>保留此颜色</translation>
    </message>
    <message>
        <source>Keeps the paint colour among the swatches.</source>
        <translation>把笔刷颜色保留到色板中。</translation>
    </message>
    <message>
        <source>%1: click to use it, press Delete to remove it.</source>
        <translation>%1：单击使用，按 Delete 删除。</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
</context>
<context>
    <name>ui::ColorWheel</name>
    <message>
        <source>Hue, saturation and value</source>
        <translation>色相、饱和度和明度</translation>
    </message>
    <message>
        <source>The ring is the hue, the square its saturation and value. Drag, or use the arrow keys and Page Up and Down.</source>
        <translation>圆环是色相，方块是饱和度和明度。可拖动，或用方向键和上下翻页键。</translation>
    </message>
</context>
<context>
    <name>ui::CommandPalette</name>
    <message>
        <source>Commands and Keys</source>
        <translation>命令与快捷键</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>您想做什么？</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>命令中的词</translation>
    </message>
</context>
<context>
    <name>ui::CommandList</name>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>作用</translation>
    </message>
</context>
<context>
    <name>ui::DrawingLayout</name>
    <message>
        <source>Front</source>
        <translation>正视</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右视</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>ui::DrawingSheet</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Width × height × depth</source>
        <translation>宽 × 高 × 深</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>True to scale when printed at 100 % on A4</source>
        <translation>以 100 % 在 A4 纸上打印时比例准确</translation>
    </message>
</context>
<context>
    <name>ui::ExportDialog</name>
    <message>
        <source>&amp;Print: STL</source>
        <translation>打印：STL(&amp;P)</translation>
    </message>
    <message>
        <source>The shape alone, in millimetres, Z up. Every slicer reads it.</source>
        <translation>只有形状，以毫米计，Z 轴向上。所有切片软件都能读取。</translation>
    </message>
    <message>
        <source>Print with &amp;colour: 3MF</source>
        <translation>彩色打印：3MF(&amp;C)</translation>
    </message>
    <message>
        <source>Shape and colours, always in millimetres, Z up. Newer slicers read it.</source>
        <translation>形状和颜色，始终以毫米为单位，Z 轴向上。较新的切片软件可以读取。</translation>
    </message>
    <message>
        <source>&amp;Game: GLB</source>
        <translation>游戏：GLB(&amp;G)</translation>
    </message>
    <message>
        <source>Shape and colours, in metres, Y up. Game engines, web pages and Blender read it.</source>
        <translation>形状和颜色，以米计，Y 轴向上。游戏引擎、网页和 Blender 都能读取。</translation>
    </message>
    <message>
        <source>Export for Print or Game</source>
        <translation>导出用于打印或游戏</translation>
    </message>
    <message>
        <source>What is the file for?</source>
        <translation>文件的用途是什么？</translation>
    </message>
    <message>
        <source>&amp;Limit triangles to:</source>
        <translation>三角形最多(&amp;M)：</translation>
    </message>
    <message>
        <source>Removes triangles where shape and colours change least. The model in the window stays as it is.</source>
        <translation>在形状和颜色变化最小处减少三角形。窗口中的模型保持不变。</translation>
    </message>
    <message>
        <source>Most triangles</source>
        <translation>三角形上限</translation>
    </message>
    <message>
        <source>Maximum number of triangles in the file. A notice appears if the model&apos;s holes and parts require more.</source>
        <translation>文件中三角形的最大数量。如果孔洞和部件需要更多，会有提示。</translation>
    </message>
    <message>
        <source>The model has %1 triangles. The file is verified after saving.</source>
        <translation>模型有 %1 个三角形。文件保存后会进行核对。</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Test in PrusaSlicer</source>
        <translation>用 PrusaSlicer 测试(&amp;T)</translation>
    </message>
    <message>
        <source>Slices the file with PrusaSlicer&apos;s own settings and reports layers and time, or its error. Esc stops it.</source>
        <translation>用 PrusaSlicer 自己的设置切片，并报告层数和时间，或其错误。按 Esc 停止。</translation>
    </message>
    <message>
        <source>&amp;Unite overlapping parts</source>
        <translation>合并重叠的部件(&amp;U)</translation>
    </message>
    <message>
        <source>Writes the exact union of the visible parts. The model in the window keeps its parts.</source>
        <translation>写入可见部件的精确并集。窗口中的模型保留其部件。</translation>
    </message>
    <message>
        <source>Parts of the model overlap. Slicers expect surfaces that do not intersect; GLB files keep parts.</source>
        <translation>模型的部件重叠。切片软件要求表面互不相交；GLB 文件保留部件。</translation>
    </message>
</context>
<context>
    <name>ui::InfoBar</name>
    <message numerus="yes">
        <source>%Ln vertices</source>
        <translation>
            <numerusform>%Ln 个顶点</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Radius %1 mm</source>
        <translation>半径 %1 mm</translation>
    </message>
</context>
<context>
    <name>ui::FalloffCurve</name>
    <message>
        <source>How the brush fades from its centre to its rim. Drag to change the curve.</source>
        <translation>笔刷从中心到边缘的衰减。拖动可弯曲曲线。</translation>
    </message>
</context>
<context>
    <name>ui::FileDialogs</name>
    <message>
        <source>Open a Model</source>
        <translation>打开模型</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <translation>模型 (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Export the Model</source>
        <translation>导出模型</translation>
    </message>
    <message>
        <source>Insert a Model</source>
        <translation>插入模型</translation>
    </message>
    <message>
        <source>Export the Drawing</source>
        <translation>导出图纸</translation>
    </message>
    <message>
        <source>Save the Model</source>
        <translation>保存模型</translation>
    </message>
    <message>
        <source>Choose a Reference Image</source>
        <translation>选择参考图</translation>
    </message>
    <message>
        <source>Images (%1)</source>
        <translation>图片 (%1)</translation>
    </message>
    <message>
        <source>Choose the Brush&apos;s Shape</source>
        <translation>选择笔刷形状</translation>
    </message>
    <message>
        <source>Choose an Alpha</source>
        <translation>选择 Alpha</translation>
    </message>
    <message>
        <source>Open a Lesson</source>
        <translation>打开课程</translation>
    </message>
    <message>
        <source>Lessons (%1)</source>
        <translation>课程 (%1)</translation>
    </message>
    <message>
        <source>Choose a Folder</source>
        <translation>选择文件夹</translation>
    </message>
    <message>
        <source>Save the Class</source>
        <translation>保存课堂</translation>
    </message>
    <message>
        <source>Open a Class</source>
        <translation>打开课堂</translation>
    </message>
    <message>
        <source>Classes (%1)</source>
        <translation>课堂 (%1)</translation>
    </message>
    <message>
        <source>Write the Class Report</source>
        <translation>生成班级报告</translation>
    </message>
    <message>
        <source>Class report</source>
        <translation>班级报告</translation>
    </message>
    <message>
        <source>One file (%1)</source>
        <translation>一个文件 (%1)</translation>
    </message>
    <message>
        <source>A folder (*)</source>
        <translation>文件夹 (*)</translation>
    </message>
    <message>
        <source>Save the Lesson</source>
        <translation>保存课程</translation>
    </message>
    <message>
        <source>Write the Handout</source>
        <translation>保存讲义</translation>
    </message>
    <message>
        <source>Import a Brush Preset</source>
        <translation>导入笔刷预设</translation>
    </message>
    <message>
        <source>Brush presets (%1)</source>
        <translation>笔刷预设 (%1)</translation>
    </message>
    <message>
        <source>Export the Brush Preset</source>
        <translation>导出笔刷预设</translation>
    </message>
</context>
<context>
    <name>ui::FileItemDelegate</name>
    <message>
        <source>New name</source>
        <translation>新名称</translation>
    </message>
</context>
<context>
    <name>ui::FileJobs</name>
    <message>
        <source>%1 is not a folder.</source>
        <translation>%1 不是文件夹。</translation>
    </message>
    <message>
        <source>%1 cannot be opened: permission denied.</source>
        <translation>无法打开 %1：没有权限。</translation>
    </message>
    <message>
        <source>There is a file named %1 already; %2 keeps its name.</source>
        <translation>已有名为 %1 的文件；%2 保留原名。</translation>
    </message>
    <message>
        <source>%1 could not be renamed (%2).</source>
        <translation>无法重命名 %1（%2）。</translation>
    </message>
    <message>
        <source>A file needs a name.</source>
        <translation>文件需要一个名称。</translation>
    </message>
    <message>
        <source>A file name may not contain %1.</source>
        <translation>文件名不能包含 %1。</translation>
    </message>
    <message>
        <source>A file name may not contain control characters.</source>
        <translation>文件名不能包含控制字符。</translation>
    </message>
    <message>
        <source>%1 cannot be a file&apos;s name.</source>
        <translation>%1 不能作为文件名。</translation>
    </message>
    <message>
        <source>%1 could not be duplicated (%2).</source>
        <translation>无法复制 %1（%2）。</translation>
    </message>
    <message>
        <source> copy</source>
        <comment>behind the name of a file that was duplicated</comment>
        <translation> 副本</translation>
    </message>
    <message>
        <source>%1 was not deleted: it could not be moved to the trash, and Fettle deletes nothing permanently.</source>
        <translation>%1 未删除：无法移到回收站，而 Fettle 不会永久删除任何文件。</translation>
    </message>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 已移到回收站。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln files are in the trash.</source>
        <translation>
            <numerusform>%Ln 个文件已移到回收站。</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing in %1 can be changed: permission denied.</source>
        <translation>无法更改 %1 中的任何内容：没有权限。</translation>
    </message>
</context>
<context>
    <name>ui::FileListModel</name>
    <message>
        <source>folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>尚未读取</translation>
    </message>
    <message numerus="yes">
        <source>%Ln vertices</source>
        <translation>
            <numerusform>%Ln 个顶点</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>size, date</comment>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>ui::FileBrowser</name>
    <message>
        <source>Models in this folder</source>
        <translation>此文件夹中的模型</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>The folder that is shown; type another and press Return.</source>
        <translation>当前显示的文件夹；可输入其他路径并按回车。</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Shows only files whose names contain these letters.</source>
        <translation>只显示名称包含这些文字的文件。</translation>
    </message>
    <message>
        <source>Sorted by</source>
        <translation>排序方式</translation>
    </message>
    <message>
        <source>How the files are sorted; folders come first.</source>
        <translation>文件的排序方式；文件夹排在最前。</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>Descending</source>
        <translation>降序</translation>
    </message>
    <message>
        <source>Turns the order round.</source>
        <translation>反转排序。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stops making pictures of this folder.</source>
        <translation>停止为此文件夹生成图片。</translation>
    </message>
    <message>
        <source>Size of the pictures</source>
        <translation>图片大小</translation>
    </message>
    <message>
        <source>Size of the pictures.</source>
        <translation>图片的大小。</translation>
    </message>
    <message>
        <source>%L1 of %L2 read</source>
        <translation>已读取 %L1 / %L2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln models</source>
        <translation>
            <numerusform>%Ln 个模型</numerusform>
        </translation>
    </message>
    <message>
        <source>No file name contains %1.</source>
        <translation>没有文件名包含“%1”。</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>No models in this folder (%1).</source>
        <translation>此文件夹中没有模型（%1）。</translation>
    </message>
</context>
<context>
    <name>ui::GuideWindow</name>
    <message>
        <source>User Guide</source>
        <translation>用户指南</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>搜索指南</translation>
    </message>
    <message>
        <source>Words to search for</source>
        <translation>要搜索的词</translation>
    </message>
    <message>
        <source>Shows only pages with these words. Return jumps to the next match.</source>
        <translation>只显示含有这些词的页面。按回车转到下一处。</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>No page has all of these words.</source>
        <translation>没有页面含有所有这些词。</translation>
    </message>
    <message>
        <source>Page of the guide</source>
        <translation>指南页面</translation>
    </message>
    <message>
        <source>Lesson: %1</source>
        <translation>课程：%1</translation>
    </message>
    <message>
        <source>The pages of the guide.</source>
        <translation>指南的各页。</translation>
    </message>
</context>
<context>
    <name>ui::InputActions</name>
    <message>
        <source>Click to place the ball. Esc cancels.</source>
        <translation>单击放置球。Esc 取消。</translation>
    </message>
    <message>
        <source>Click the part that is to be active. Esc cancels.</source>
        <translation>点击要成为当前部件的部件。Esc 取消。</translation>
    </message>
    <message>
        <source>Arrow keys move the cross. Space presses while it is held, Return until the next Return.</source>
        <translation>方向键移动十字。按住空格使用工具；按回车开始，再按一次结束。</translation>
    </message>
</context>
<context>
    <name>ui::HeadsetActions</name>
    <message>
        <source>L&amp;eave VR</source>
        <translation>离开 VR(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Give Back</source>
        <translation>交还(&amp;G)</translation>
    </message>
</context>
<context>
    <name>ui::HelpText</name>
    <message>
        <source>(no key)</source>
        <translation>（无快捷键）</translation>
    </message>
    <message>
        <source> or </source>
        <comment>one key or the other</comment>
        <translation> 或 </translation>
    </message>
</context>
<context>
    <name>ui::HistoryPanel</name>
    <message>
        <source>%1: %2</source>
        <comment>step: what it took</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>expired</source>
        <translation>已过期</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>已撤销</translation>
    </message>
    <message numerus="yes">
        <source>%Ln dabs</source>
        <translation>
            <numerusform>%Ln 个笔点</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>dabs, fusions</comment>
        <translation>%1，%2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln fusions</source>
        <translation>
            <numerusform>%Ln 次融合</numerusform>
        </translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Every step since the model was opened. Click one, or press Return, to go there.</source>
        <translation>打开模型以来的每一步。单击或按回车即可转到那里。</translation>
    </message>
    <message>
        <source>Memory for the history</source>
        <translation>历史占用的内存</translation>
    </message>
    <message>
        <source>The memory that the history may use. Older steps are moved to disk; if the disk is full, they expire.</source>
        <translation>历史可占用的内存。更早的步骤会移到磁盘；磁盘已满时过期。</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>%1 MB of</source>
        <translation>%1 MB，上限</translation>
    </message>
</context>
<context>
    <name>ui::NamesField</name>
    <message>
        <source>One name per line; you can paste a list. Pupils choose their name; those who had a turn today are marked.</source>
        <translation>每行一个名字，可以粘贴名单。学生选择自己的名字；今天已轮到的会有标记。</translation>
    </message>
    <message>
        <source>One name per line. Without names, pupils type theirs.</source>
        <translation>每行一个名字。没有名单时由学生输入。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is longer than %2 characters.</source>
        <translation>“%1”超过 %2 个字符。</translation>
    </message>
    <message>
        <source>A class has at most %1 names; these are %2.</source>
        <translation>一个课堂最多有 %1 个名字；这里有 %2 个。</translation>
    </message>
    <message>
        <source>In the list more than once, and counted once: %1.</source>
        <translation>名单中重复出现，只计一次：%1。</translation>
    </message>
</context>
<context>
    <name>ui::NavigationCube</name>
    <message>
        <source>Front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>View cube</source>
        <translation>视图立方体</translation>
    </message>
    <message>
        <source>Click a face to look from there. Drag to turn the view.</source>
        <translation>单击一面即从该方向观看。拖动可转动视图。</translation>
    </message>
</context>
<context>
    <name>ui::RecentFiles</name>
    <message>
        <source>None yet</source>
        <translation>暂无</translation>
    </message>
</context>
<context>
    <name>ui::ShortcutEdit</name>
    <message>
        <source>no key</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>ui::ShortcutsPage</name>
    <message>
        <source>Fettle</source>
        <translation>Fettle</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>ZBrush</source>
        <translation>ZBrush</translation>
    </message>
    <message>
        <source>Search for a command or a key</source>
        <translation>搜索命令或快捷键</translation>
    </message>
    <message>
        <source>Words of a command</source>
        <translation>命令中的词</translation>
    </message>
    <message>
        <source>Shows only commands with these words or this key.</source>
        <translation>只显示含有这些词或此快捷键的命令。</translation>
    </message>
    <message>
        <source>Commands and Keys</source>
        <translation>命令与快捷键</translation>
    </message>
    <message>
        <source>Every command with its keys. Change the keys of the selected one below.</source>
        <translation>所有命令及其快捷键；在下方更改所选命令的快捷键。</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>Chooses a set of keys. Keys that you changed yourself stay.</source>
        <translation>选择一套快捷键。您自己更改的快捷键保持不变。</translation>
    </message>
    <message>
        <source>Reset A&amp;ll Keys</source>
        <translation>重置所有快捷键(&amp;L)</translation>
    </message>
    <message>
        <source>Resets all commands to the keys of the preset.</source>
        <translation>将所有命令重置为方案的快捷键。</translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation>方案(&amp;P)</translation>
    </message>
    <message>
        <source>First key</source>
        <translation>第一个快捷键</translation>
    </message>
    <message>
        <source>Second key</source>
        <translation>第二个快捷键</translation>
    </message>
    <message>
        <source>Press the new key for the command, or Backspace to remove it.</source>
        <translation>按下该命令的新快捷键，或按退格键清除。</translation>
    </message>
    <message>
        <source>R&amp;eset</source>
        <translation>重置(&amp;E)</translation>
    </message>
    <message>
        <source>Resets the command to the keys of the preset.</source>
        <translation>将该命令重置为方案的快捷键。</translation>
    </message>
    <message>
        <source>&amp;Go There</source>
        <translation>转到(&amp;G)</translation>
    </message>
    <message>
        <source>Selects the command that uses the key.</source>
        <translation>选中使用该快捷键的命令。</translation>
    </message>
    <message>
        <source>This key cannot be changed.</source>
        <translation>此快捷键不能更改。</translation>
    </message>
    <message>
        <source>%1 is already used by %2.</source>
        <translation>%1 已被“%2”占用。</translation>
    </message>
    <message>
        <source>%1 stays with %2.</source>
        <translation>%1 仍属于“%2”。</translation>
    </message>
    <message>
        <source>A modifier key cannot be a shortcut on its own.</source>
        <translation>修饰键不能单独作为快捷键。</translation>
    </message>
    <message>
        <source>%1 is needed to move and type in panels and dialogs.</source>
        <translation>%1 用于在面板和对话框中移动和输入。</translation>
    </message>
    <message>
        <source>Alt with a letter opens menus and reaches controls.</source>
        <translation>Alt 加字母用于打开菜单和选中控件。</translation>
    </message>
</context>
<context>
    <name>ui::LessonChoice</name>
    <message>
        <source>Pupils can begin with it: it is shown stroke by stroke, and the report says how far they got.</source>
        <translation>学生可以从它开始：课程会逐笔演示，报告会说明做到了哪一步。</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>From a File…</source>
        <translation>从文件…</translation>
    </message>
</context>
<context>
    <name>ui::LessonEditor</name>
    <message>
        <source>A lesson records what you sculpt, step by step, here or in the headset. It begins with:</source>
        <translation>课程一步一步地录制您在这里或头显中的雕刻。起始模型：</translation>
    </message>
    <message>
        <source>Begins with</source>
        <translation>起始模型</translation>
    </message>
    <message>
        <source>The model as it is now</source>
        <translation>现在的模型</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Begins a lesson of one step. Earlier strokes can no longer be undone.</source>
        <translation>开始一个只有一步的课程。之前的笔画将无法再撤销。</translation>
    </message>
    <message>
        <source>Or change an existing lesson:</source>
        <translation>或修改已有的课程：</translation>
    </message>
    <message>
        <source>Built-in lessons</source>
        <translation>程序自带的课程</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>Opens it here; you save it under a name of your own.</source>
        <translation>在这里打开；保存时用您自己的名称。</translation>
    </message>
    <message>
        <source>Open a Lesson…</source>
        <translation>打开课程…</translation>
    </message>
    <message>
        <source>Opens a lesson from a zip or a folder, to change it.</source>
        <translation>从 ZIP 文件或文件夹打开课程进行修改。</translation>
    </message>
    <message>
        <source>Language of the texts</source>
        <translation>文字的语言</translation>
    </message>
    <message>
        <source>The language that you write in. Where a text is missing, pupils read it in another language.</source>
        <translation>您书写所用的语言。缺少文字时，学生会看到另一种语言。</translation>
    </message>
    <message>
        <source>Title of the lesson</source>
        <translation>课程标题</translation>
    </message>
    <message>
        <source>Title of the lesson.</source>
        <translation>课程的标题。</translation>
    </message>
    <message>
        <source>In one sentence</source>
        <translation>一句话介绍</translation>
    </message>
    <message>
        <source>Subject of the lesson, in one sentence.</source>
        <translation>用一句话说明课程的主题。</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>New Step</source>
        <translation>新步骤</translation>
    </message>
    <message>
        <source>Starts a new step at the end; strokes belong to it from here on.</source>
        <translation>在末尾开始新的步骤；此后的笔画属于它。</translation>
    </message>
    <message>
        <source>Moves the step up</source>
        <translation>把这一步上移</translation>
    </message>
    <message>
        <source>Moves the step down</source>
        <translation>把这一步下移</translation>
    </message>
    <message>
        <source>Removes the step with its strokes</source>
        <translation>删除这一步及其笔画</translation>
    </message>
    <message>
        <source>Plays the lesson to its end and records from there. Press again to stop.</source>
        <translation>把课程播放到底，并从那里开始录制。再按一次停止。</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Plays the lesson to its end, checks each step, and saves it as a file or a folder.</source>
        <translation>把课程播放到底，检查每一步，然后保存为一个文件或文件夹。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Closes this lesson. The model stays as it is.</source>
        <translation>关闭这个课程。模型保持不变。</translation>
    </message>
    <message>
        <source>%1. %2 (%3)</source>
        <extracomment>number of a step, its title, how many strokes it has</extracomment>
        <translation>%1. %2（%3）</translation>
    </message>
    <message>
        <source>Step %1</source>
        <translation>第 %1 步</translation>
    </message>
    <message>
        <source>Stop Recording</source>
        <translation>停止录制</translation>
    </message>
    <message>
        <source>Record On</source>
        <translation>继续录制</translation>
    </message>
    <message>
        <source>Lesson Editor</source>
        <translation>课程编辑器</translation>
    </message>
    <message>
        <source>● Recording into step %1</source>
        <translation>● 正在录制到第 %1 步</translation>
    </message>
    <message>
        <source>○ Not recording</source>
        <translation>○ 没有录制</translation>
    </message>
</context>
<context>
    <name>ui::LessonPanel</name>
    <message>
        <source>Choose a lesson. It starts with its own model.</source>
        <translation>选择一堂课。它用自己的模型开始。</translation>
    </message>
    <message>
        <source>Open a Lesson…</source>
        <translation>打开课程…</translation>
    </message>
    <message>
        <source>Opens a lesson from a zip or a folder.</source>
        <translation>从 ZIP 文件或文件夹打开课程。</translation>
    </message>
    <message>
        <source>How far the teacher is</source>
        <translation>老师做到了哪里</translation>
    </message>
    <message>
        <source>Show Me</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>One Stroke</source>
        <translation>单笔</translation>
    </message>
    <message>
        <source>Shows the teacher&apos;s next stroke alone.</source>
        <translation>只演示老师的下一笔。</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Speed of the demonstration.</source>
        <translation>演示的速度。</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <comment>speed</comment>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Try It</source>
        <translation>试一试</translation>
    </message>
    <message>
        <source>Undoes the strokes of this step. Now it is your turn.</source>
        <translation>撤销这一步的笔画。现在轮到你了。</translation>
    </message>
    <message>
        <source>Show the difference</source>
        <translation>显示差别</translation>
    </message>
    <message>
        <source>Colours the model by how far it is from the teacher&apos;s.</source>
        <translation>按与老师模型的距离给模型上色。</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>离开</translation>
    </message>
    <message>
        <source>Ends the lesson. The model stays as it is.</source>
        <translation>结束这堂课。模型保持不变。</translation>
    </message>
    <message>
        <source>%1: step %2 of %3</source>
        <translation>%1：第 %2 步，共 %3 步</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>Start from the Teacher&apos;s Model</source>
        <translation>从老师的模型开始</translation>
    </message>
    <message>
        <source>Begins this step with the teacher&apos;s model. Undo brings yours back.</source>
        <translation>用老师的模型开始这一步。撤销可以恢复你的模型。</translation>
    </message>
    <message>
        <source>Handout as PDF…</source>
        <translation>讲义 PDF…</translation>
    </message>
    <message>
        <source>Writes the texts and pictures of all steps to a PDF for pupils.</source>
        <translation>把所有步骤的文字和图片做成给学生的 PDF。</translation>
    </message>
    <message>
        <source>Brush: %1</source>
        <comment>tools and sizes</comment>
        <translation>笔刷：%1</translation>
    </message>
    <message>
        <source>This turn has no lesson.</source>
        <translation>这一轮没有课程。</translation>
    </message>
</context>
<context>
    <name>ui::LessonStepEditor</name>
    <message>
        <source>Title of the step</source>
        <translation>步骤标题</translation>
    </message>
    <message>
        <source>What the step is called.</source>
        <translation>步骤的名称。</translation>
    </message>
    <message>
        <source>Text of the step</source>
        <translation>步骤文字</translation>
    </message>
    <message>
        <source>Text that the pupil reads beside the model.</source>
        <translation>学生在模型旁边看到的文字。</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Strokes of the step</source>
        <translation>这一步的笔画</translation>
    </message>
    <message>
        <source>Cut Stroke</source>
        <translation>去掉这一笔</translation>
    </message>
    <message>
        <source>Removes this stroke from the lesson. Later ones are played without it when the lesson is saved.</source>
        <translation>把这一笔从课程中去掉。保存课程时，后面的笔画会在没有它的情况下播放。</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>Tools that the pupil has; if none is chosen, all of them.</source>
        <translation>学生可用的工具；一个都不选则为全部。</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>%1, at least</source>
        <translation>%1，至少</translation>
    </message>
    <message>
        <source>%1, at most</source>
        <translation>%1，至多</translation>
    </message>
    <message>
        <source>The step is done when the pupil&apos;s model is so:</source>
        <translation>学生的模型达到以下要求，这一步就完成：</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>至少</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>至多</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>孔洞</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部件</translation>
    </message>
    <message>
        <source>Height, mm</source>
        <translation>高度，mm</translation>
    </message>
    <message>
        <source>Width, mm</source>
        <translation>宽度，mm</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>深度，mm</translation>
    </message>
    <message>
        <source>Volume, mm³</source>
        <translation>体积，mm³</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>How close the pupil&apos;s shape must be to the teacher&apos;s.</source>
        <translation>学生的形状与老师的形状须有多接近。</translation>
    </message>
    <message>
        <source>Near the teacher&apos;s, mm</source>
        <translation>与老师的相差，mm</translation>
    </message>
    <message>
        <source>Ready to print</source>
        <translation>可以打印</translation>
    </message>
    <message>
        <source>Take from the Model</source>
        <translation>取自模型</translation>
    </message>
    <message>
        <source>Asks for the holes and parts that the model in the window has, for its height at least, and that it can be printed.</source>
        <translation>要求孔洞数和部件数与窗口中的模型相同，至少同样高，并且可以打印。</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>What the pupil reads</source>
        <translation>学生看到的文字</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>number of a stroke; what it is</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Length from above, mm</source>
        <translation>俯视最长，mm</translation>
    </message>
    <message>
        <source>Legs on the ground</source>
        <translation>着地的腿</translation>
    </message>
    <message>
        <source>Flat base, mm²</source>
        <translation>平的底面，mm²</translation>
    </message>
    <message>
        <source>Narrow places all around</source>
        <translation>四周变窄的地方</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>Fettle</source>
        <translation>Fettle</translation>
    </message>
    <message>
        <source>&amp;Choose Another Place…</source>
        <translation>选择其他位置(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>撤销 %1(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>重做 %1(&amp;R)</translation>
    </message>
    <message>
        <source>%1[*] – Fettle</source>
        <translation>%1[*] – Fettle</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>已保存 %1。</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>面板(&amp;P)</translation>
    </message>
    <message>
        <source>Tool Bar</source>
        <translation>工具栏</translation>
    </message>
    <message>
        <source>Tool Options</source>
        <translation>工具选项</translation>
    </message>
    <message>
        <source>Stamp now uses the current shape of %1.</source>
        <translation>图章现在使用 %1 当前的样子。</translation>
    </message>
</context>
<context>
    <name>ui::NumberFormat</name>
    <message>
        <source>%1 mm³</source>
        <translation>%1 mm³</translation>
    </message>
    <message>
        <source>%1 cm³</source>
        <translation>%1 cm³</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 小时 %2 分</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
</context>
<context>
    <name>ui::RepairDialogs</name>
    <message>
        <source>Repair the Model</source>
        <translation>修复模型</translation>
    </message>
    <message>
        <source>Also fill large holes (over a quarter of the model&apos;s size)</source>
        <translation>也填补大孔（超过模型大小的四分之一）</translation>
    </message>
    <message>
        <source>Treat enclosed parts as cavities</source>
        <translation>把内部的部件当作空腔</translation>
    </message>
    <message>
        <source>Repair and Open</source>
        <translation>修复并打开</translation>
    </message>
    <message>
        <source>Fettle can repair it: it fills holes, turns faces outwards and joins parts that intersect. You will see what changed. The file stays as it is.</source>
        <translation>Fettle 可以修复它：填补孔洞，将面翻转朝外，并连接相交的部件。您会看到改动了什么。文件保持不变。</translation>
    </message>
    <message>
        <source>Fettle</source>
        <translation>Fettle</translation>
    </message>
    <message>
        <source>%1 was repaired. Save to keep the repaired model; the original file stays as it is.</source>
        <translation>%1 已修复。保存即可保留修复后的模型；原文件不变。</translation>
    </message>
    <message>
        <source>Repair and Insert</source>
        <translation>修复并插入</translation>
    </message>
    <message>
        <source>%1 was repaired and inserted. Undo reverts both.</source>
        <translation>%1 已修复并插入。“撤销”会同时取消这两步。</translation>
    </message>
    <message>
        <source>Repaired, but Changed</source>
        <translation>已修复，但有变化</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>文件中</translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation>修复后</translation>
    </message>
    <message>
        <source>Open This</source>
        <translation>打开此模型</translation>
    </message>
    <message>
        <source>Insert This</source>
        <translation>插入此模型</translation>
    </message>
</context>
<context>
    <name>ui::RepairMessages</name>
    <message>
        <source>Points welded: %1</source>
        <translation>合并的点：%1</translation>
    </message>
    <message>
        <source>Faces without area removed: %1</source>
        <translation>移除的无面积面：%1</translation>
    </message>
    <message>
        <source>Duplicate faces removed: %1</source>
        <translation>移除的重复面：%1</translation>
    </message>
    <message>
        <source>Faces or parts turned outwards: %1</source>
        <translation>翻转朝外的面或部件：%1</translation>
    </message>
    <message>
        <source>Faces of inner sheets removed: %1</source>
        <translation>移除的内层薄片的面：%1</translation>
    </message>
    <message>
        <source>Holes filled: %1</source>
        <translation>填补的孔洞：%1</translation>
    </message>
    <message>
        <source>of these, longer than a quarter of the model: %1</source>
        <translation>其中长于模型四分之一的：%1</translation>
    </message>
    <message>
        <source>Parts inside of others: %1</source>
        <translation>位于其他部件内部的部件：%1</translation>
    </message>
    <message>
        <source>Intersections resolved: %1</source>
        <translation>已消除的相交：%1</translation>
    </message>
    <message>
        <source>Touching edges and points separated: %1</source>
        <translation>已分开的接触边和点：%1</translation>
    </message>
    <message>
        <source>Tangles that could not be resolved, covered by small solids: %1, the widest %2 mm</source>
        <translation>无法消除的缠结处，已用小实体覆盖：%1，最宽 %2 mm</translation>
    </message>
    <message>
        <source>Walls on each other within rounding, joined or removed: %1</source>
        <translation>在舍入误差内贴合的壁面，已合并或移除：%1</translation>
    </message>
    <message>
        <source>Tiny thin parts left out: %1</source>
        <translation>已略去的细小薄片：%1</translation>
    </message>
    <message>
        <source>The surface was rebuilt, with edges of about %1 mm.</source>
        <translation>表面已重新生成，边长约 %1 mm。</translation>
    </message>
    <message>
        <source>The new surface is at most %1 mm (mean %2 mm) from the old one; the old one at most %3 mm (mean %4 mm) from the new.</source>
        <translation>新表面距旧表面最多 %1 mm（平均 %2 mm）；旧表面距新表面最多 %3 mm（平均 %4 mm）。</translation>
    </message>
    <message>
        <source>%1 was not repaired: it has holes longer than a quarter of its size (%2), the largest near %3.</source>
        <translation>未修复 %1：它有长于自身四分之一的孔洞（%2 个），最大的在 %3 附近。</translation>
    </message>
    <message>
        <source>%1 cannot be repaired: its faces enclose no space.</source>
        <translation>无法修复 %1：它的面没有围成任何空间。</translation>
    </message>
    <message>
        <source>Open points joined at cracks: %1, within %2 mm</source>
        <translation>裂缝处连接的开放点：%1，相距不超过 %2 毫米</translation>
    </message>
    <message>
        <source>Repairing %1: points and faces</source>
        <translation>正在修复 %1：点和面</translation>
    </message>
    <message>
        <source>Repairing %1: cracks</source>
        <translation>正在修复 %1：裂缝</translation>
    </message>
    <message>
        <source>Repairing %1: face directions</source>
        <translation>正在修复 %1：面的朝向</translation>
    </message>
    <message>
        <source>Repairing %1: holes</source>
        <translation>正在修复 %1：孔洞</translation>
    </message>
    <message>
        <source>Repairing %1: intersections</source>
        <translation>正在修复 %1：自相交</translation>
    </message>
    <message>
        <source>Repairing %1: new surface</source>
        <translation>正在修复 %1：新表面</translation>
    </message>
    <message>
        <source>Repairing %1: check</source>
        <translation>正在修复 %1：检查</translation>
    </message>
    <message>
        <source>Repairing %1: measuring the changes</source>
        <translation>正在修复 %1：测量变化</translation>
    </message>
    <message>
        <source>Masked points lost in the repair: %1</source>
        <translation>移除的带遮罩的点，连同其遮罩：%1</translation>
    </message>
    <message>
        <source>Volume: %1, before %2</source>
        <translation>体积：%1，此前 %2</translation>
    </message>
    <message>
        <source>Surface: %1, before %2</source>
        <translation>表面积：%1，此前 %2</translation>
    </message>
    <message>
        <source>Parts: %1, before %2</source>
        <translation>部件：%1，此前 %2</translation>
    </message>
    <message>
        <source>%1 could only be rebuilt, with edges of about %2 mm: its shape is close to the old one, but detail is lost.</source>
        <translation>%1 只能重新生成表面，边长约 %2 毫米：形状接近原来的，但细节已丢失。</translation>
    </message>
    <message>
        <source>%1 was repaired, but lost surface inside: on average, the old one is %2 mm (%3 %) away.</source>
        <translation>%1 已修复，但其内部的表面已移除：旧表面与新表面平均相距 %2 毫米（尺寸的 %3 %）。</translation>
    </message>
    <message>
        <source>%1 was repaired, but now has %2 % of its volume.</source>
        <translation>%1 已修复，但现在的体积为原来的 %2 %。</translation>
    </message>
    <message>
        <source>%1 was repaired, but parts that could be holes were treated as parts that face the wrong way: %2 % of the space.</source>
        <translation>%1 已修复，但可能是孔洞的部件被当作朝向错误的部件，占空间的 %2 %。</translation>
    </message>
    <message>
        <source>%1 was repaired, but the space that it encloses differs by %2 % from what its faces enclosed before.</source>
        <translation>%1 已修复，但它现在所包围的空间与其面原先所围的空间相差 %2 %。</translation>
    </message>
    <message>
        <source>%1 was repaired, but part of its surface was lost: it is %2 mm from the new one on average, %3 % of the size.</source>
        <translation>%1 已修复，但部分表面已丢失：原表面与新表面平均相距 %2 毫米，为尺寸的 %3 %。</translation>
    </message>
    <message>
        <source>%1 cannot be repaired as it is: its faces could not be separated near %2.</source>
        <translation>%1 无法照原样修复：在 %2 附近无法分开各面。</translation>
    </message>
    <message>
        <source>%1 cannot be repaired as it is: its faces could not be separated.</source>
        <translation>%1 无法照原样修复：无法分开各面。</translation>
    </message>
    <message>
        <source>%1 cannot be repaired as it is: its faces are too badly connected, and most of it would be lost.</source>
        <translation>%1 无法照原样修复：各面连接太差，大部分会丢失。</translation>
    </message>
    <message>
        <source>%1 cannot be repaired as it is: its faces are too badly connected, and most of it would be lost. Openings: %2, the widest near %3.</source>
        <translation>%1 无法照原样修复：各面连接太差，大部分会丢失。开口：%2 处，最宽的在 %3 附近。</translation>
    </message>
    <message numerus="yes">
        <source>%n open sheets left out, which enclose no space; the largest is %1 x %2 mm</source>
        <translation>
            <numerusform>已略去 %n 片不围成空间的开放曲面；最大的为 %1 x %2 毫米</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 cannot be repaired: it has %n open sheets that enclose no space, the largest %2 x %3 mm.</source>
        <translation>
            <numerusform>无法修复 %1：它有 %n 片不围成空间的开放曲面，最大的为 %2 x %3 毫米。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ErrorMessages</name>
    <message>
        <source>%1 cannot be used.</source>
        <translation>无法使用 %1。</translation>
    </message>
    <message>
        <source>open edges: %1</source>
        <translation>开放边：%1</translation>
    </message>
    <message>
        <source>edges of more than two faces: %1</source>
        <translation>连接两个以上面的边：%1</translation>
    </message>
    <message>
        <source>points at which parts merely touch: %1</source>
        <translation>部件仅在一点相接的顶点：%1</translation>
    </message>
    <message>
        <source>edges between faces that face different ways: %1</source>
        <translation>两侧的面朝向不一致的边：%1</translation>
    </message>
    <message>
        <source>faces without area: %1</source>
        <translation>面积为零的面：%1</translation>
    </message>
    <message>
        <source>pairs of faces that intersect: %1</source>
        <translation>相交的面对：%1</translation>
    </message>
    <message>
        <source>it is inside out, or its shells are wrongly nested</source>
        <translation>内外翻转，或壳体嵌套有误</translation>
    </message>
    <message>
        <source>%1 cannot be sculpted yet, because its surface does not bound a solid (%2).</source>
        <translation>尚无法雕刻 %1，因为其表面未围成实体（%2）。</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between the faults of a model</comment>
        <translation>；</translation>
    </message>
    <message>
        <source>%1 cannot be sculpted yet, because some of its faces would intersect after rounding to the program&apos;s grid (faces: %2).</source>
        <translation>尚无法雕刻 %1，因为按程序的坐标格点取整后，部分面会相交（面数：%2）。</translation>
    </message>
    <message>
        <source>%1: there is no such file or folder.</source>
        <translation>%1：没有此文件或文件夹。</translation>
    </message>
    <message>
        <source>%1 cannot be read%2.</source>
        <translation>无法读取 %1%2。</translation>
    </message>
    <message>
        <source>%1 is not a file but a folder or a device.</source>
        <translation>%1 不是文件，而是文件夹或设备。</translation>
    </message>
    <message>
        <source>%1 is empty.</source>
        <translation>%1 是空文件。</translation>
    </message>
    <message>
        <source>%1 is too large: it has %2, and at most %3 are read.</source>
        <translation>%1 过大：文件大小为 %2，最多可读取 %3。</translation>
    </message>
    <message>
        <source>%1 is not a valid %2 file.</source>
        <translation>%1 不是有效的 %2 文件。</translation>
    </message>
    <message>
        <source>%1 is not a valid %2 file; it looks like %3.</source>
        <translation>%1 不是有效的 %2 文件；看起来像 %3。</translation>
    </message>
    <message>
        <source>plain text</source>
        <translation>纯文本</translation>
    </message>
    <message>
        <source>%1: the file is incomplete; it ends here.</source>
        <translation>%1：文件不完整，在此处结束。</translation>
    </message>
    <message>
        <source>%1: the file is incomplete; %2 are expected, but it has %3.</source>
        <translation>%1：文件不完整；应有 %2，实有 %3。</translation>
    </message>
    <message>
        <source>%1: %2 elements are announced, but the file has room for %3.</source>
        <translation>%1：声明了 %2 个元素，但文件只能容纳 %3 个。</translation>
    </message>
    <message>
        <source>%1: the file is incomplete; %2 vertices are announced, but it has room for %3.</source>
        <translation>%1：文件不完整；声明了 %2 个顶点，但只有 %3 个的空间。</translation>
    </message>
    <message>
        <source>%1: the file is incomplete; %2 faces are announced, but it has room for %3.</source>
        <translation>%1：文件不完整；声明了 %2 个面，但只有 %3 个的空间。</translation>
    </message>
    <message>
        <source>%1: %2 faces are announced, but the file has %3.</source>
        <translation>%1：声明了 %2 个面，但文件中有 %3 个。</translation>
    </message>
    <message>
        <source>%1: a coordinate is not a finite number.</source>
        <translation>%1：有坐标不是有限数。</translation>
    </message>
    <message>
        <source>%1: a number is missing here, or is not finite.</source>
        <translation>%1：此处缺少数字，或数字不是有限数。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a whole number that is valid here.</source>
        <translation>%1：“%2”不是此处有效的整数。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a finite number.</source>
        <translation>%1：“%2”不是有限数。</translation>
    </message>
    <message>
        <source>%1: a face refers to vertex %2, but there are only %3 vertices.</source>
        <translation>%1：有面引用了顶点 %2，但只有 %3 个顶点。</translation>
    </message>
    <message>
        <source>%1: too many %2; at most %3 are allowed.</source>
        <translation>%1：元素（%2）过多；最多允许 %3 个。</translation>
    </message>
    <message>
        <source>%1 contains no faces.</source>
        <translation>%1 不含任何面。</translation>
    </message>
    <message>
        <source>%1 contains no faces, except those of slicer parts that are not printed (%2): negative volumes, modifiers and supports, which are left out.</source>
        <translation>%1 不含任何面，只有切片软件中不打印的部件（%2）：负体积、修改器和支撑，均已略去。</translation>
    </message>
    <message>
        <source>%1 cannot be written: it is not allowed%2.</source>
        <translation>无法写入 %1：没有权限%2。</translation>
    </message>
    <message>
        <source>%1 was not written: the disk is full.</source>
        <translation>未写入 %1：磁盘已满。</translation>
    </message>
    <message>
        <source>%1 was not written%2.</source>
        <translation>未写入 %1%2。</translation>
    </message>
    <message>
        <source>, line %1</source>
        <translation>，第 %1 行</translation>
    </message>
    <message>
        <source>, byte %1</source>
        <translation>，第 %1 字节</translation>
    </message>
    <message>
        <source>%1 was not written: so far from the origin its coordinates are too coarse for the model&apos;s detail. Recentre the model.</source>
        <translation>未写入 %1：离原点太远，坐标精度不足以表示模型的细节。请将模型居中。</translation>
    </message>
    <message>
        <source>%1 cannot be written: the folder %2 does not exist.</source>
        <translation>无法写入 %1：文件夹 %2 不存在。</translation>
    </message>
    <message>
        <source>Nothing happened here: the surface would have intersected itself.</source>
        <translation>此处没有变化：表面会与自身相交。</translation>
    </message>
    <message>
        <source>The brush stopped: surfaces touch, and they may not join here.</source>
        <translation>笔刷已停止：表面相碰，而此处不允许连接。</translation>
    </message>
    <message>
        <source>The brush stopped at the edge of the workspace.</source>
        <translation>笔刷停在了工作空间的边缘。</translation>
    </message>
    <message>
        <source>The brush is too large for this much detail. Continue with another stroke.</source>
        <translation>对这么多细节来说笔刷太大。请再画一笔继续。</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Falloff</source>
        <translation>衰减</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>细节</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>%1: from %2 to %3 mm with this model.</source>
        <translation>%1：对此模型为 %2 至 %3 mm。</translation>
    </message>
    <message>
        <source>%1: from %2 to %3.</source>
        <translation>%1：%2 至 %3。</translation>
    </message>
    <message>
        <source>The model is not symmetric here: both sides were changed, but they are not exact mirror images.</source>
        <translation>模型在此处并不对称：两侧都已更改，但并非精确的镜像。</translation>
    </message>
    <message>
        <source>%1: drawings are written as PDF, SVG or PNG; the file extension decides which.</source>
        <translation>%1：图纸可写为 PDF、SVG 或 PNG，由扩展名决定。</translation>
    </message>
    <message>
        <source>%1 contains no image that can be read.</source>
        <translation>%1 中没有可读取的图片。</translation>
    </message>
    <message>
        <source>The reference image %1 no longer exists.</source>
        <translation>参考图 %1 已不存在。</translation>
    </message>
    <message>
        <source>%1 has no known file extension: use one of %2.</source>
        <translation>%1 没有已知的扩展名：请使用 %2 之一。</translation>
    </message>
    <message>
        <source>%1: the format &quot;%2&quot; is not known; %3 can be used.</source>
        <translation>%1：未知格式“%2”；可使用 %3。</translation>
    </message>
    <message>
        <source>%1 is Blender&apos;s own file, which only Blender reads as it is: save it as GLB there.</source>
        <translation>%1 是 Blender 自己的文件，只有 Blender 能正确读取：请在那里另存为 GLB。</translation>
    </message>
    <message>
        <source>%1 is OpenGEX, which is not read: save it as GLB.</source>
        <translation>%1 是 OpenGEX 文件，不能读取：请另存为 GLB。</translation>
    </message>
    <message>
        <source>%1 is X3D in its binary, packed or VRML encoding, which is not read: save it as XML (.x3d) or GLB.</source>
        <translation>%1 是采用二进制、压缩或 VRML 编码的 X3D，无法读取：请保存为 XML (.x3d) 或 GLB。</translation>
    </message>
    <message>
        <source>%1 was not read: unpacked it is larger than %2, which is too much for a file of its size.</source>
        <translation>未读取 %1：解压后超过 %2，对这样大小的文件来说太大。</translation>
    </message>
    <message>
        <source>The model has only %1 mm³: slicers may read it as inches.</source>
        <translation>模型只有 %1 mm³：切片软件可能把单位当作英寸。</translation>
    </message>
    <message>
        <source>The model has only %1 mm³: slicers may read it as metres.</source>
        <translation>模型只有 %1 mm³：切片软件可能把单位当作米。</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>textures</source>
        <translation>纹理</translation>
    </message>
    <message>
        <source>poses</source>
        <translation>姿态</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <comment>materials, textures</comment>
        <translation>已略去：%1</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between the parts of a model that are left out</comment>
        <translation>、</translation>
    </message>
    <message numerus="yes">
        <source>%n objects are one model now</source>
        <translation>
            <numerusform>%n 个对象已合为一个模型</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 refers to &quot;%2&quot;, which is not in its folder; files elsewhere are not read.</source>
        <translation>%1 引用了“%2”，它不在该文件所在的文件夹中；不会读取其他位置的文件。</translation>
    </message>
    <message>
        <source>%1 was not written: %2 is only read; %3 can be written.</source>
        <translation>未写入 %1：%2 只能读取；可写入 %3。</translation>
    </message>
    <message>
        <source>%1 breaks the rules of the format %2; the importer does not say where.</source>
        <translation>%1 不符合 %2 格式的规则；导入程序没有说明位置。</translation>
    </message>
    <message>
        <source>%1 cannot be read; the importer says: &quot;%2&quot;.</source>
        <translation>无法读取 %1；导入程序报告：“%2”。</translation>
    </message>
    <message>
        <source>%1 was not read: the process that reads it ended unexpectedly.</source>
        <translation>未读取 %1：读取它的进程意外终止。</translation>
    </message>
    <message>
        <source>%1 was not read: it took longer than the limit of %2 seconds for a file of its size.</source>
        <translation>未读取 %1：读取时间超过了这样大小的文件的上限（%2 秒）。</translation>
    </message>
    <message>
        <source>%1 was not read: it needs more memory than the limit of %2 for a file of its size.</source>
        <translation>未读取 %1：所需内存超过了这样大小的文件的上限（%2）。</translation>
    </message>
    <message>
        <source>%1: at that size the coordinates overflow.</source>
        <translation>%1：在此尺寸下坐标会溢出。</translation>
    </message>
    <message>
        <source>%1 cannot be a brush&apos;s shape, because its surface does not bound a solid (%2).</source>
        <translation>%1 不能用作笔刷形状，因为它的表面没有围成实体（%2）。</translation>
    </message>
    <message>
        <source>Nothing was added, because it would be inside the model.</source>
        <translation>没有添加任何东西，因为它会位于模型内部。</translation>
    </message>
    <message>
        <source>Nothing was added, because it would be too close to the surface.</source>
        <translation>没有添加任何东西，因为它会离表面太近。</translation>
    </message>
    <message>
        <source>Nothing was added, because it would reach beyond the workspace.</source>
        <translation>没有添加任何东西，因为它会超出工作空间。</translation>
    </message>
    <message>
        <source>Nothing was added, because the brush&apos;s shape would intersect itself at that size.</source>
        <translation>没有添加任何东西，因为笔刷形状在该尺寸下会自相交。</translation>
    </message>
    <message>
        <source>Nothing was added, because the mask protects the surface there.</source>
        <translation>没有添加任何东西，因为该处的表面受遮罩保护。</translation>
    </message>
    <message>
        <source>The sectors meet here, or the model differs between them: they were changed one after the other and are not exact copies.</source>
        <translation>各扇区在这里相接，或模型的各扇区不同：它们已依次更改，并非精确的副本。</translation>
    </message>
    <message>
        <source>%1: class reports are written as HTML or PDF; the file extension decides which.</source>
        <translation>%1：班级报告写为 HTML 或 PDF，由扩展名决定。</translation>
    </message>
    <message>
        <source>%1: sheets are written as one PDF; the name has to end in .pdf.</source>
        <translation>%1：图纸写入一个 PDF，文件名须以 .pdf 结尾。</translation>
    </message>
    <message>
        <source>%1: this folder cannot be read%2.</source>
        <translation>%1：无法读取此文件夹%2。</translation>
    </message>
    <message>
        <source>%1: this folder contains no models (%2).</source>
        <translation>%1：此文件夹中没有模型（%2）。</translation>
    </message>
    <message>
        <source>%1 is text in UTF-16, which is not read: save it as UTF-8.</source>
        <translation>%1 是 UTF-16 文本，无法读取：请保存为 UTF-8。</translation>
    </message>
    <message>
        <source>corners that faces name twice (%1)</source>
        <translation>面重复列出的角点（%1）</translation>
    </message>
    <message>
        <source>faces without three different corners (%1)</source>
        <translation>没有三个不同角点的面（%1）</translation>
    </message>
    <message>
        <source>values that its header does not announce</source>
        <translation>文件头未声明的值</translation>
    </message>
    <message>
        <source>data after the end of the model (%1)</source>
        <translation>模型结尾之后的数据（%1）</translation>
    </message>
    <message>
        <source>it announces %1 triangles and contains %2</source>
        <translation>文件头声明了 %1 个三角形，实际包含 %2 个</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <comment>the name of a part</comment>
        <translation>“%1”</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <comment>names of parts</comment>
        <translation>%1，另有 %2 个</translation>
    </message>
    <message>
        <source>parts that a slicer would cut out of the model (%1)</source>
        <translation>切片软件会从模型中切除的部件（%1）</translation>
    </message>
    <message>
        <source>modifiers and supports of a slicer (%1)</source>
        <translation>切片软件的修改器和支撑（%1）</translation>
    </message>
    <message>
        <source>further models in its package (%1)</source>
        <translation>同一压缩包中的其他模型（%1）</translation>
    </message>
    <message>
        <source>the curvature of edges and triangles</source>
        <translation>边和三角形的弯曲</translation>
    </message>
    <message>
        <source>beams of a lattice (%1)</source>
        <translation>晶格的梁（%1）</translation>
    </message>
    <message>
        <source>animations (%1)</source>
        <translation>动画（%1）</translation>
    </message>
    <message>
        <source>the subdivision of surfaces (%1)</source>
        <translation>曲面细分（%1）</translation>
    </message>
    <message>
        <source>unsupported surfaces (%1)</source>
        <translation>未读取的曲面（%1）</translation>
    </message>
    <message>
        <source>objects that are hidden or not in the scene (%1)</source>
        <translation>隐藏或不在场景中的对象（%1）</translation>
    </message>
</context>
<context>
    <name>ui::FileFaultMessages</name>
    <message>
        <source>a number above 0</source>
        <translation>大于 0 的数</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; changes the shape, but is not read: save the model without it.</source>
        <translation>%1：“%2”会改变形状，但不会被读取：请去掉它后再保存模型。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; has faces, but no object with faces is connected to the scene.</source>
        <translation>%1：“%2”有面，但没有任何带面的对象连接到场景。</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <comment>a word of the format</comment>
        <translation>“%1”</translation>
    </message>
    <message>
        <source>%1: expected %2, found nothing.</source>
        <translation>%1：此处应为%2，但什么也没有。</translation>
    </message>
    <message>
        <source>%1: expected %2, found &quot;%3&quot;.</source>
        <translation>%1：此处应为%2，却是“%3”。</translation>
    </message>
    <message>
        <source>%1: the file breaks the rules of its format.</source>
        <translation>%1：文件不符合其格式的规则。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; breaks the rules of the file&apos;s format.</source>
        <translation>%1：“%2”不符合文件格式的规则。</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>一个数</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>一个整数</translation>
    </message>
    <message>
        <source>a count that is not negative and fits here</source>
        <translation>一个非负且合适的个数</translation>
    </message>
    <message>
        <source>a vertex of 3 or 4 numbers, with 3 more for a colour or none</source>
        <translation>由 3 或 4 个数组成的顶点（可另加 3 个颜色值）</translation>
    </message>
    <message>
        <source>the number of a vertex</source>
        <translation>顶点的编号</translation>
    </message>
    <message>
        <source>ascii, binary_little_endian or binary_big_endian</source>
        <translation>ascii、binary_little_endian 或 binary_big_endian</translation>
    </message>
    <message>
        <source>a type such as float or int</source>
        <translation>类型，例如 float 或 int</translation>
    </message>
    <message>
        <source>a type of whole numbers, such as uchar or int</source>
        <translation>整数类型，例如 uchar 或 int</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>an element before its first property</source>
        <translation>位于首个属性之前的元素</translation>
    </message>
    <message>
        <source>one of the units millimeter, micron, centimeter, inch, foot and meter</source>
        <translation>以下单位之一：millimeter、micron、centimeter、inch、foot、meter</translation>
    </message>
    <message>
        <source>%1: the element &quot;%2&quot; has no properties x, y and z.</source>
        <translation>%1：元素“%2”没有属性 x、y 和 z。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is needed here, but is missing.</source>
        <translation>%1：此处需要“%2”，但它不存在。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; appears twice.</source>
        <translation>%1：“%2”重复出现。</translation>
    </message>
    <message>
        <source>%1: the JSON of the file is broken here.</source>
        <translation>%1：文件的 JSON 在此处有误。</translation>
    </message>
    <message>
        <source>%1: a chunk with a JSON object is expected first, but another is there.</source>
        <translation>%1：首先应为含 JSON 对象的数据块，却是另一种数据块。</translation>
    </message>
    <message>
        <source>%1: the data in &quot;%2&quot; is not packed as base64, which is expected there.</source>
        <translation>%1：“%2”中的数据应为 base64 编码，但并非如此。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; should be a list, but is something else.</source>
        <translation>%1：“%2”应为列表，却是别的内容。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; should be a JSON object, but is something else or missing.</source>
        <translation>%1：“%2”应为 JSON 对象，却是别的内容或不存在。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; should be a whole number that is not negative, but is something else.</source>
        <translation>%1：“%2”应为非负整数，却是别的内容。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; should be a list of as many numbers as the format requires, but is something else.</source>
        <translation>%1：“%2”应为格式所规定个数的数字列表，却是别的内容。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; contains less data than should be read from it.</source>
        <translation>%1：“%2”所含的数据少于应从中读取的数据。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; has a type or a count that does not fit its use.</source>
        <translation>%1：“%2”的类型或个数与其用途不符。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; contain themselves, or are nested too deeply.</source>
        <translation>%1：“%2”包含自身，或嵌套过深。</translation>
    </message>
    <message>
        <source>%1 needs the extension %2, which Fettle cannot read: save it without, in the program that made it.</source>
        <translation>%1 需要 Fettle 无法读取的扩展 %2：请在创建它的程序中不用该扩展另行保存。</translation>
    </message>
    <message>
        <source>%1 is glTF of version %2; version 2.0 is read: save it as that.</source>
        <translation>%1 是 glTF %2 版；可读取的是 2.0 版：请保存为该版本。</translation>
    </message>
    <message>
        <source>%1: the compressed data of &quot;%2&quot; ends too early.</source>
        <translation>%1：“%2”的压缩数据过早结束。</translation>
    </message>
    <message>
        <source>%1: the compressed data of &quot;%2&quot; is not packed as its extension says.</source>
        <translation>%1：“%2”的压缩数据未按其扩展的规定打包。</translation>
    </message>
    <message>
        <source>%1 is FBX of version %2; versions from 7.1 on are read: save it as FBX 7 or GLB.</source>
        <translation>%1 是 FBX %2 版；可读取 7.1 及以上版本：请保存为 FBX 7 或 GLB。</translation>
    </message>
    <message>
        <source>%1 is IFC of the schema %2; IFC2X3 is read: save it as that or as GLB.</source>
        <translation>%1 是 %2 模式的 IFC；可读取的是 IFC2X3：请保存为该模式或 GLB。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; leads out of the package; nothing from elsewhere is read.</source>
        <translation>%1：“%2”指向包外；不会读取别处的内容。</translation>
    </message>
    <message>
        <source>%1: the part &quot;%2&quot; is not in the package.</source>
        <translation>%1：包中没有部件“%2”。</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; should say where in the package the model is, but does not.</source>
        <translation>%1：“%2”应说明模型在包中的位置，但没有说明。</translation>
    </message>
    <message>
        <source>%1: the part &quot;%2&quot; is encrypted, or packed in a way that is not read.</source>
        <translation>%1：部件“%2”已加密，或其压缩方式无法读取。</translation>
    </message>
    <message>
        <source>%1: the XML of the file is broken here: &quot;%2&quot;.</source>
        <translation>%1：文件的 XML 在此处有误：“%2”。</translation>
    </message>
    <message>
        <source>%1: a document type is declared here, which models may not have.</source>
        <translation>%1：此处声明了文档类型，而模型不得含有。</translation>
    </message>
    <message>
        <source>%1: XML elements are nested too deeply here.</source>
        <translation>%1：此处 XML 元素嵌套过深。</translation>
    </message>
    <message>
        <source>%1: an XML tag is longer here than 1 MiB.</source>
        <translation>%1：此处的 XML 标签超过 1 MiB。</translation>
    </message>
</context>
<context>
    <name>ui::ModelDialogs</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>X, to the right</source>
        <translation>X，向右</translation>
    </message>
    <message>
        <source>Y, upwards</source>
        <translation>Y，向上</translation>
    </message>
    <message>
        <source>Z, to the front</source>
        <translation>Z，向前</translation>
    </message>
    <message>
        <source>Scale the Model</source>
        <translation>缩放模型</translation>
    </message>
    <message>
        <source>New size of the model:</source>
        <translation>模型的新尺寸：</translation>
    </message>
    <message>
        <source>Longest side</source>
        <translation>最长边</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>倍数</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Mirror the Model</source>
        <translation>镜像模型</translation>
    </message>
    <message>
        <source>Mirror across a plane through the origin:</source>
        <translation>以过原点的平面镜像：</translation>
    </message>
    <message>
        <source>Left and right (X)</source>
        <translation>左与右 (X)</translation>
    </message>
    <message>
        <source>Top and bottom (Y)</source>
        <translation>上与下 (Y)</translation>
    </message>
    <message>
        <source>Front and back (Z)</source>
        <translation>前与后 (Z)</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>镜像</translation>
    </message>
    <message>
        <source>Symmetrize the Model</source>
        <translation>使模型对称</translation>
    </message>
    <message>
        <source>Mirror across a plane through the origin. Which half is kept?</source>
        <translation>以过原点的平面镜像。保留哪一半？</translation>
    </message>
    <message>
        <source>Right (X above 0)</source>
        <translation>右（X 大于 0）</translation>
    </message>
    <message>
        <source>Left (X below 0)</source>
        <translation>左（X 小于 0）</translation>
    </message>
    <message>
        <source>Top (Y above 0)</source>
        <translation>上（Y 大于 0）</translation>
    </message>
    <message>
        <source>Bottom (Y below 0)</source>
        <translation>下（Y 小于 0）</translation>
    </message>
    <message>
        <source>Front (Z above 0)</source>
        <translation>前（Z 大于 0）</translation>
    </message>
    <message>
        <source>Back (Z below 0)</source>
        <translation>后（Z 小于 0）</translation>
    </message>
    <message>
        <source>Symmetrize</source>
        <translation>对称化</translation>
    </message>
    <message>
        <source>Remesh Uniformly</source>
        <translation>均匀重新划分网格</translation>
    </message>
    <message>
        <source>Rebuild the mesh with triangles of about the same size. Maximum edge length:</source>
        <translation>用大小相近的三角形重建网格。最大边长：</translation>
    </message>
    <message>
        <source>Longest edge</source>
        <translation>最长边</translation>
    </message>
    <message>
        <source>Edges from %1 to %2 mm; about %3 triangles, currently %4.</source>
        <translation>边长 %1 至 %2 mm；约 %3 个三角形，现有 %4 个。</translation>
    </message>
    <message>
        <source>Remesh</source>
        <translation>重新划分网格</translation>
    </message>
    <message>
        <source>Insert a Model</source>
        <translation>插入模型</translation>
    </message>
    <message>
        <source>Beside the present model</source>
        <translation>现有模型旁边</translation>
    </message>
    <message>
        <source>Where its file has it</source>
        <translation>文件中的位置</translation>
    </message>
    <message>
        <source>With its middle at</source>
        <translation>中心位于</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>插入</translation>
    </message>
    <message>
        <source>Flatten the Base</source>
        <translation>压平底部</translation>
    </message>
    <message>
        <source>Cuts the bottom off level, so that the model stands. Height of the cut above the lowest point:</source>
        <translation>水平切去底部，使模型能够站立。切口距最低点的高度：</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Flatten</source>
        <translation>压平</translation>
    </message>
    <message>
        <source>Original unit</source>
        <translation>原单位</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>厘米</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>米</translation>
    </message>
    <message>
        <source>Its unit</source>
        <translation>它的单位</translation>
    </message>
    <message>
        <source>As stated in the file, otherwise mm</source>
        <translation>按文件所述，否则为毫米</translation>
    </message>
    <message>
        <source>Combine</source>
        <translation>组合</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>合并</translation>
    </message>
    <message>
        <source>Subtract</source>
        <translation>减去</translation>
    </message>
    <message>
        <source>Intersect</source>
        <translation>相交</translation>
    </message>
    <message>
        <source>%1: where does it go, and how is it combined with the present model?</source>
        <translation>%1：放在哪里，如何与现有模型组合？</translation>
    </message>
    <message>
        <source>As a part of its own</source>
        <translation>作为独立的部件</translation>
    </message>
    <message>
        <source>In the same part, without touching</source>
        <translation>在同一部件中，互不接触</translation>
    </message>
</context>
<context>
    <name>ui::ModelFiles</name>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>最近打开(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Clear This List</source>
        <translation>清空此列表(&amp;C)</translation>
    </message>
    <message>
        <source>The file was changed</source>
        <translation>文件已被更改</translation>
    </message>
    <message>
        <source>Another program has changed %1 since it was read or written here.</source>
        <translation>自上次在此读取或写入以来，%1 已被其他程序更改。</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>覆盖(&amp;O)</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>%1 was deleted or moved. Save to write it again.</source>
        <translation>%1 已被删除或移动。“保存”会重新写入。</translation>
    </message>
    <message>
        <source>%1 had been deleted or moved and was written again.</source>
        <translation>%1 已被删除或移动，现已重新写入。</translation>
    </message>
    <message>
        <source>Saved %1. Only GLB files keep view, brush, symmetry and reference images: use Save As.</source>
        <translation>已保存 %1。只有 GLB 文件保留视图、笔刷、对称和参考图：请使用“另存为”。</translation>
    </message>
    <message>
        <source>Save changes to %1?</source>
        <translation>保存对 %1 的更改？</translation>
    </message>
</context>
<context>
    <name>ui::FormatFilters</name>
    <message>
        <source>%1 and others</source>
        <translation>%1 等</translation>
    </message>
</context>
<context>
    <name>ui::ModelPanel</name>
    <message>
        <source>Vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>Corners of the triangles.</source>
        <translation>三角形的角点。</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>Triangles of the surface.</source>
        <translation>表面的三角形。</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>部件</translation>
    </message>
    <message>
        <source>Parts of the surface that are not connected, including hollows.</source>
        <translation>互不相连的表面部件，包括空腔。</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>亏格</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Width, height and depth of the box around the model.</source>
        <translation>模型外框的宽、高、深。</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>Volume inside the surface.</source>
        <translation>表面所包围的体积。</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Area of the whole surface.</source>
        <translation>整个表面的面积。</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>边长</translation>
    </message>
    <message>
        <source>The shortest and the longest edge of a triangle.</source>
        <translation>三角形最短和最长的边。</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>%1 cm³</source>
        <translation>%1 cm³</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 至 %2 mm</translation>
    </message>
    <message>
        <source>Watertight</source>
        <translation>水密</translation>
    </message>
    <message>
        <source>Closed and free of self-intersections. Checked exactly.</source>
        <translation>封闭且无自相交。已精确检查。</translation>
    </message>
    <message>
        <source>Needs repair</source>
        <translation>需要修复</translation>
    </message>
    <message>
        <source>The surface is open, intersects itself or encloses no space.</source>
        <translation>表面不封闭、自相交或未围成空间。</translation>
    </message>
    <message>
        <source>Not checked since the last change</source>
        <translation>上次改动后尚未检查</translation>
    </message>
    <message>
        <source>These values are from before the last change. They are updated when the model is idle.</source>
        <translation>这些数值是上次改动之前的；模型静止后会更新。</translation>
    </message>
    <message>
        <source>Model</source>
        <comment>panel</comment>
        <translation>模型</translation>
    </message>
    <message>
        <source>The number of handles or through holes: 0 for a ball, 1 for a ring or a cup.</source>
        <translation>把手或贯通孔的数量：球为 0，圆环或带把手的杯子为 1。</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>部件</translation>
    </message>
    <message>
        <source>The active part, whose values these are.</source>
        <translation>当前部件，以下为其数值。</translation>
    </message>
</context>
<context>
    <name>ui::PupilNamePanel</name>
    <message>
        <source>&amp;Begin</source>
        <translation>开始(&amp;B)</translation>
    </message>
    <message>
        <source>The next turn</source>
        <translation>下一轮</translation>
    </message>
    <message>
        <source>Who is next?</source>
        <translation>轮到谁了？</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名字</translation>
    </message>
    <message>
        <source>Name or nickname</source>
        <translation>名字或昵称</translation>
    </message>
    <message>
        <source>Starts the turn. (Return)</source>
        <translation>开始这一轮。（回车）</translation>
    </message>
    <message>
        <source>Pupils</source>
        <translation>学生</translation>
    </message>
    <message>
        <source>%1 ✓ has had a turn</source>
        <translation>%1 ✓ 已轮到</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>课程</translation>
    </message>
</context>
<context>
    <name>ui::ParameterControl</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
</context>
<context>
    <name>ui::PartnerBar</name>
    <message>
        <source>Partner</source>
        <translation>搭档</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 毫米</translation>
    </message>
    <message>
        <source>Time is up</source>
        <translation>时间到</translation>
    </message>
</context>
<context>
    <name>ui::PressureCurve</name>
    <message>
        <source>Pressure curve</source>
        <translation>笔压曲线</translation>
    </message>
    <message>
        <source>Effect of pen pressure: above the diagonal a light touch does much, below it little. Drag to bend the curve.</source>
        <translation>笔压的作用：曲线在对角线之上时，轻触作用大，在其下则小。拖动可弯曲曲线。</translation>
    </message>
</context>
<context>
    <name>ui::PressureTest</name>
    <message>
        <source>Pen test</source>
        <translation>手写笔测试</translation>
    </message>
    <message>
        <source>Draw here: the line shows the effect of your pen&apos;s pressure.</source>
        <translation>在此处画：线条显示笔压的作用。</translation>
    </message>
    <message>
        <source>Draw here with the pen or the mouse.</source>
        <translation>用手写笔或鼠标在此处画。</translation>
    </message>
    <message>
        <source>Mouse: no pressure</source>
        <translation>鼠标：无笔压</translation>
    </message>
    <message>
        <source>Eraser: %1</source>
        <translation>橡皮擦：%1</translation>
    </message>
    <message>
        <source>Pen: %1</source>
        <translation>手写笔：%1</translation>
    </message>
</context>
<context>
    <name>ui::PinDialog</name>
    <message>
        <source>Teacher&apos;s PIN</source>
        <translation>教师 PIN</translation>
    </message>
    <message>
        <source>End &amp;Class</source>
        <translation>结束课堂(&amp;C)</translation>
    </message>
    <message>
        <source>This is not the PIN.</source>
        <translation>PIN 不正确。</translation>
    </message>
    <message numerus="yes">
        <source>Too many wrong PINs. Try again in %n seconds.</source>
        <translation>
            <numerusform>错误次数过多：%n 秒后可再试。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>外观(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Reset to Defaults</source>
        <translation>恢复默认值(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>颜色(&amp;C)</translation>
    </message>
    <message>
        <source>Chooses a light or a dark window, or follows the desktop.</source>
        <translation>选择浅色或深色的窗口，或跟随桌面。</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>Chooses the language of the window&apos;s texts.</source>
        <translation>选择窗口文字的语言。</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>&amp;Input</source>
        <translation>输入(&amp;I)</translation>
    </message>
    <message>
        <source>Pen pressure controls &amp;strength</source>
        <translation>笔压控制强度(&amp;S)</translation>
    </message>
    <message>
        <source>A light touch changes little, a firm touch much.</source>
        <translation>轻触变化小，重压变化大。</translation>
    </message>
    <message>
        <source>Pen pressure controls ra&amp;dius</source>
        <translation>笔压控制半径(&amp;U)</translation>
    </message>
    <message>
        <source>A light touch makes a narrow stroke, a firm touch a wide one.</source>
        <translation>轻触笔画窄，重压笔画宽。</translation>
    </message>
    <message>
        <source>Alt and &amp;mouse navigate</source>
        <translation>Alt 加鼠标移动视图(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>快捷键(&amp;K)</translation>
    </message>
    <message>
        <source>Resets all settings of the program to their defaults, after a question.</source>
        <translation>询问后，将程序的所有设置恢复为默认值。</translation>
    </message>
    <message>
        <source>Reset all settings to defaults?</source>
        <translation>将所有设置恢复为默认值？</translation>
    </message>
    <message>
        <source>This resets colours, language, keys, pen and mouse, brush, view and the layout of panels. Models, recent files and swatches stay. The language changes at the next start.</source>
        <translation>将重置颜色、语言、快捷键、手写笔与鼠标、笔刷、视图和面板布局。模型、最近的文件和色板保持不变。语言在下次启动时更改。</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>重置(&amp;R)</translation>
    </message>
    <message>
        <source>Hold Alt: left orbits, middle pans and right zooms, on the model too. The keys of ZBrush differ.</source>
        <translation>按住 Alt 时，左键旋转、中键平移、右键缩放，在模型上也是如此；使用 ZBrush 快捷键时则不同。</translation>
    </message>
    <message>
        <source>Pressure &amp;curve</source>
        <translation>笔压曲线(&amp;C)</translation>
    </message>
    <message>
        <source>Pen test</source>
        <translation>手写笔测试</translation>
    </message>
    <message>
        <source>&amp;Files</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>Keep the last three &amp;versions of each saved file</source>
        <translation>保存时保留文件的最近三个版本(&amp;V)</translation>
    </message>
    <message>
        <source>Older versions stay beside the file, as vase.glb~1, vase.glb~2 and so on. Open them like any other file.</source>
        <translation>旧版本保留在文件旁边，名为 vase.glb~1、vase.glb~2 等；可以像其他文件一样打开。</translation>
    </message>
    <message>
        <source>Unsaved changes are always kept if Fettle ends unexpectedly. The next start offers to recover them.</source>
        <translation>若 Fettle 意外结束，未保存的更改总会保留；下次启动时可以恢复。</translation>
    </message>
    <message>
        <source>&amp;Text size</source>
        <translation>文字大小(&amp;T)</translation>
    </message>
    <message>
        <source>Makes the window&apos;s text larger than the desktop&apos;s.</source>
        <translation>使窗口文字大于桌面文字。</translation>
    </message>
    <message>
        <source>Restart Fettle to apply language and text size.</source>
        <translation>语言和文字大小在重新启动 Fettle 后生效。</translation>
    </message>
    <message>
        <source>Reduced moti&amp;on</source>
        <translation>减少动态效果(&amp;D)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>The view jumps to its place instead of flying there, and the ring around a place that is pointed at stands still.</source>
        <translation>视图直接跳到目标，不再飞过去；指示位置的光圈保持静止。</translation>
    </message>
    <message>
        <source>Open the &amp;objects of a file as parts</source>
        <translation>把文件中的对象作为部件打开(&amp;O)</translation>
    </message>
    <message>
        <source>Makes a part of each object of a 3MF, OBJ, glTF or AMF file. Otherwise all objects become one part.</source>
        <translation>使 3MF、OBJ、glTF 或 AMF 文件中的每个对象成为一个部件。否则所有对象合为一个部件。</translation>
    </message>
</context>
<context>
    <name>ui::PreviewPanel</name>
    <message>
        <source>2D Preview</source>
        <translation>二维预览</translation>
    </message>
    <message>
        <source>Drawing of the model</source>
        <translation>模型的图纸</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Shows all three drawings, or one of them larger.</source>
        <translation>显示全部三个视图，或放大其中一个。</translation>
    </message>
    <message>
        <source>All sides</source>
        <translation>全部视图</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正视</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右视</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>Drawn as</source>
        <translation>绘制方式</translation>
    </message>
    <message>
        <source>Shows the lines only, or colours under them.</source>
        <translation>只显示线条，或在线条下显示颜色。</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>线条</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>着色</translation>
    </message>
    <message>
        <source>Dimensions</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Shows the model&apos;s dimensions beside it.</source>
        <translation>在旁边标注模型的尺寸。</translation>
    </message>
    <message>
        <source>Fit (0)</source>
        <translation>适合窗口 (0)</translation>
    </message>
    <message>
        <source>Shows the whole drawing; the wheel zooms, a drag moves it.</source>
        <translation>显示整个图纸；滚轮缩放，拖动平移。</translation>
    </message>
    <message>
        <source>Coarser while you sculpt; the fine drawing follows.</source>
        <translation>雕刻时较粗略；随后显示精细图。</translation>
    </message>
    <message>
        <source>Creases are left out: the surface has too many.</source>
        <translation>已省略折痕：表面折痕过多。</translation>
    </message>
</context>
<context>
    <name>ui::PrintFindings</name>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Watertight surface</source>
        <translation>表面水密</translation>
    </message>
    <message>
        <source>Closed, all faces outwards, no self-intersections. Checked exactly.</source>
        <translation>封闭，所有面朝外，没有自相交。已精确检查。</translation>
    </message>
    <message>
        <source>The surface needs repair</source>
        <translation>表面需要修复</translation>
    </message>
    <message>
        <source>It is open, intersects itself or encloses no space; walls were not measured.</source>
        <translation>表面不封闭、自相交或未围成空间；未测量壁厚。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln parts</source>
        <translation>
            <numerusform>%Ln 个部件</numerusform>
        </translation>
    </message>
    <message>
        <source>Separate parts of the surface; closed hollows count as parts.</source>
        <translation>表面的独立部件；封闭的空腔也算部件。</translation>
    </message>
    <message>
        <source>%1 mm wide, %2 mm deep, %3 mm high.</source>
        <translation>宽、深、高 %1 × %2 × %3 mm。</translation>
    </message>
    <message>
        <source>Fits %1</source>
        <translation>适合 %1</translation>
    </message>
    <message>
        <source>Fits %1, turned by 90°</source>
        <translation>旋转 90° 后适合 %1</translation>
    </message>
    <message>
        <source>Too large for %1</source>
        <translation>对 %1 太大</translation>
    </message>
    <message>
        <source>Shares are of the surface. The thinnest place: %1 mm.</source>
        <translation>比例相对于整个表面。最薄处：%1 mm。</translation>
    </message>
    <message>
        <source>Walls from %1 mm on</source>
        <translation>壁厚 %1 mm 起</translation>
    </message>
    <message>
        <source>No thin walls</source>
        <translation>没有薄壁</translation>
    </message>
    <message>
        <source>%1 thinner than %2 mm</source>
        <translation>%1 薄于 %2 mm</translation>
    </message>
    <message>
        <source>Only specks thinner than %1 mm</source>
        <translation>仅有微小处薄于 %1 mm</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>%1 mm, %2</source>
        <comment>thickness, area</comment>
        <translation>%1 mm，%2</translation>
    </message>
    <message>
        <source>Faces that lean out more than %1 from the vertical print on supports only; those on the bed do not count.</source>
        <translation>偏离垂直方向超过 %1 的面需要支撑才能打印；打印床上的面不计。</translation>
    </message>
    <message>
        <source>No overhangs beyond %1</source>
        <translation>没有超过 %1 的悬垂</translation>
    </message>
    <message>
        <source>%1 overhangs beyond %2</source>
        <translation>%1 悬垂超过 %2</translation>
    </message>
    <message>
        <source>up to %1, %2</source>
        <translation>最大 %1，%2</translation>
    </message>
    <message>
        <source>Area of the surface that is flat on the bed.</source>
        <translation>平放在打印床上的面积。</translation>
    </message>
    <message>
        <source>Stands on %1</source>
        <translation>底面 %1</translation>
    </message>
    <message>
        <source>Rests on a point or an edge</source>
        <translation>只立在一个点或一条边上</translation>
    </message>
    <message>
        <source>Scale the model, or choose millimetres in the slicer.</source>
        <translation>请缩放模型，或在切片软件中选择毫米。</translation>
    </message>
    <message>
        <source>Overlapping parts checked as one</source>
        <translation>重叠的部件已合并检查</translation>
    </message>
    <message>
        <source>The visible parts overlap. They were united for the check, as exporting for print unites them.</source>
        <translation>可见部件重叠。检查时已将其合并，与导出打印文件时相同。</translation>
    </message>
    <message>
        <source>Overlapping parts cannot be united</source>
        <translation>重叠的部件无法合并</translation>
    </message>
    <message>
        <source>Each part was checked alone. Move one a little; otherwise the export will not unite them, either.</source>
        <translation>各部件已单独检查。请稍微移动其中一个，否则导出时也无法合并。</translation>
    </message>
</context>
<context>
    <name>ui::PrintLegend</name>
    <message>
        <source>Colours on the model</source>
        <translation>模型上的颜色</translation>
    </message>
    <message>
        <source>The meaning of the colours on the model. Hatched places are beyond the limit.</source>
        <translation>模型上颜色的含义。带斜线处超出限度。</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>thick</source>
        <translation>厚</translation>
    </message>
</context>
<context>
    <name>ui::PrintPanel</name>
    <message>
        <source>Printers…</source>
        <translation>打印机…</translation>
    </message>
    <message>
        <source>Edits the list of printers.</source>
        <translation>编辑打印机列表。</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>悬垂</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>打印机</translation>
    </message>
    <message>
        <source>The printer to check against.</source>
        <translation>要对照检查的打印机。</translation>
    </message>
    <message>
        <source>Minimum wall</source>
        <translation>最小壁厚</translation>
    </message>
    <message>
        <source>Finds thinner walls. Two lines of the nozzle are usual.</source>
        <translation>找出更薄的壁。通常为喷嘴的两条线宽。</translation>
    </message>
    <message>
        <source>Steepest overhang that prints without support, from the vertical.</source>
        <translation>无需支撑即可打印的最大悬垂角，从竖直方向量起。</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Colours the model by wall thickness or by overhang.</source>
        <translation>按厚度或悬垂给模型上色。</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>检查结果</translation>
    </message>
    <message>
        <source>The findings. Click a place, or press Return, to see it on the model.</source>
        <translation>检查结果。单击某处或按回车，即可在模型上查看。</translation>
    </message>
    <message>
        <source>good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>注意</translation>
    </message>
    <message>
        <source>to fix</source>
        <translation>需修改</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Check Now</source>
        <translation>立即检查</translation>
    </message>
    <message>
        <source>Ends the check.</source>
        <translation>结束检查。</translation>
    </message>
    <message>
        <source>Checks the model as it is now.</source>
        <translation>检查当前的模型。</translation>
    </message>
    <message>
        <source>Ready to print</source>
        <translation>可直接打印</translation>
    </message>
    <message>
        <source>Printable, with warnings</source>
        <translation>可打印，但有警告</translation>
    </message>
    <message>
        <source>Fix before printing</source>
        <translation>打印前应修改</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>Not checked since the last change</source>
        <translation>上次更改后未检查</translation>
    </message>
    <message>
        <source>Print Check</source>
        <translation>打印检查</translation>
    </message>
</context>
<context>
    <name>ui::PrintersDialog</name>
    <message>
        <source>Printers</source>
        <translation>打印机</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>添加(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>Another printer</source>
        <translation>另一台打印机</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
</context>
<context>
    <name>ui::Questionnaire</name>
    <message>
        <source>How easy was it to learn to use the program?</source>
        <translation>学会使用这个程序有多容易？</translation>
    </message>
    <message>
        <source>extremely difficult</source>
        <translation>非常困难</translation>
    </message>
    <message>
        <source>extremely easy</source>
        <translation>非常容易</translation>
    </message>
    <message>
        <source>Was everything there that you needed?</source>
        <translation>你需要的功能都有吗？</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>不完整</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>完整</translation>
    </message>
    <message>
        <source>How often did something go wrong while you sculpted?</source>
        <translation>雕刻时出错有多频繁？</translation>
    </message>
    <message>
        <source>extremely often</source>
        <translation>非常频繁</translation>
    </message>
    <message>
        <source>extremely rarely</source>
        <translation>非常少</translation>
    </message>
    <message>
        <source>How convenient was it to make details?</source>
        <translation>制作细节有多方便？</translation>
    </message>
    <message>
        <source>very inconvenient</source>
        <translation>非常不便</translation>
    </message>
    <message>
        <source>very convenient</source>
        <translation>非常方便</translation>
    </message>
    <message>
        <source>How freely could you make holes and handles, and join parts?</source>
        <translation>做孔洞和把手、连接各部件有多自由？</translation>
    </message>
    <message>
        <source>not freely at all</source>
        <translation>完全不自由</translation>
    </message>
    <message>
        <source>completely freely</source>
        <translation>完全自由</translation>
    </message>
    <message>
        <source>How do you find the program as a whole?</source>
        <translation>你觉得这个程序总体如何？</translation>
    </message>
    <message>
        <source>poor</source>
        <translation>差</translation>
    </message>
    <message>
        <source>good</source>
        <translation>好</translation>
    </message>
</context>
<context>
    <name>ui::QuestionnairePanel</name>
    <message>
        <source>D&amp;one</source>
        <translation>完成(&amp;O)</translation>
    </message>
    <message>
        <source>Questions after the turn</source>
        <translation>这一轮之后的问题</translation>
    </message>
    <message>
        <source>Six questions about the program. Answer what you like: press a number; press it again to clear it.</source>
        <translation>关于程序的六个问题。想答哪个就答哪个：按一个数字作答，再按一次清除。</translation>
    </message>
    <message>
        <source>S&amp;kip</source>
        <translation>跳过(&amp;K)</translation>
    </message>
    <message>
        <source>Continues without answers; nothing is saved.</source>
        <translation>不作回答并继续；不保存任何内容。</translation>
    </message>
    <message>
        <source>Saves the answers with the work, and continues.</source>
        <translation>将回答与作品一起保存，并继续。</translation>
    </message>
    <message>
        <source>How was it, %1?</source>
        <translation>%1，感觉怎么样？</translation>
    </message>
</context>
<context>
    <name>ui::RecoveryBar</name>
    <message>
        <source>Unsaved Model</source>
        <translation>未保存的模型</translation>
    </message>
    <message>
        <source>Unsaved changes to %1 can be recovered: %2, %3.</source>
        <translation>可以恢复对 %1 未保存的更改：%2，%3。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln steps</source>
        <translation>
            <numerusform>%Ln 步</numerusform>
        </translation>
    </message>
    <message>
        <source>Rec&amp;over</source>
        <translation>恢复(&amp;O)</translation>
    </message>
    <message>
        <source>Opens the model as it was, with its history.</source>
        <translation>按原样打开模型，并保留历史。</translation>
    </message>
    <message>
        <source>&amp;Discard…</source>
        <translation>放弃(&amp;D)…</translation>
    </message>
    <message>
        <source>Deletes these changes, after a question.</source>
        <translation>询问后删除这些更改。</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>以后(&amp;L)</translation>
    </message>
    <message>
        <source>Hides this bar; the next start offers it again.</source>
        <translation>隐藏此提示条；下次启动时会再次提供。</translation>
    </message>
    <message>
        <source>Fettle</source>
        <translation>Fettle</translation>
    </message>
    <message>
        <source>Permanently delete the unsaved changes to %1?</source>
        <translation>要永久删除 %1 未保存的更改吗？</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>删除(&amp;R)</translation>
    </message>
</context>
<context>
    <name>ui::ReferencePanel</name>
    <message>
        <source>Image</source>
        <translation>参考图</translation>
    </message>
    <message>
        <source>In front of the model</source>
        <translation>显示在模型前面</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>The side that shows the image. Choosing another side turns the view to it.</source>
        <translation>显示图片的一侧。选择另一侧会把视图转到那里。</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>How wide the image is, measured beside the model.</source>
        <translation>图片的宽度，与模型使用同一尺度。</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>向右</translation>
    </message>
    <message>
        <source>How far the image&apos;s middle is to the right of the origin.</source>
        <translation>图片中心在原点右侧的距离。</translation>
    </message>
    <message>
        <source>Upwards</source>
        <translation>向上</translation>
    </message>
    <message>
        <source>How far the image&apos;s middle is above the origin in this view.</source>
        <translation>在此视图中，图片中心在原点上方的距离。</translation>
    </message>
    <message>
        <source>Draws the image over the model instead of behind it, so that both can be compared.</source>
        <translation>把图片画在模型之上而不是之后，以便两者对照。</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Opacity of the image.</source>
        <translation>图片的不透明度。</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>%1, with an image</source>
        <translation>%1（有图片）</translation>
    </message>
    <message>
        <source>No image</source>
        <translation>没有图片</translation>
    </message>
    <message>
        <source>Choose an image, or drop its file on the window.</source>
        <translation>选择一张图片，或把图片文件拖到窗口上。</translation>
    </message>
</context>
<context>
    <name>ui::RevealFile</name>
    <message>
        <source>No file manager was found; the file is in %1.</source>
        <translation>未找到文件管理器；文件位于 %1。</translation>
    </message>
</context>
<context>
    <name>ui::ScaleBar</name>
    <message>
        <source>Scale: %L1 mm</source>
        <translation>比例尺：%L1 mm</translation>
    </message>
    <message>
        <source>%L1 mm</source>
        <translation>%L1 mm</translation>
    </message>
</context>
<context>
    <name>ui::Scene</name>
    <message>
        <source>The model cannot be shown: this display offers no OpenGL.</source>
        <translation>无法显示模型：此显示环境不提供 OpenGL。</translation>
    </message>
    <message>
        <source>The model cannot be shown: OpenGL does not start on this display.</source>
        <translation>无法显示模型：OpenGL 无法在此显示环境中启动。</translation>
    </message>
    <message>
        <source>The model cannot be shown: OpenGL 3.3 is needed, and this display offers %1.%2 (%3). Update the graphics driver, or install Mesa&apos;s software driver, llvmpipe.</source>
        <extracomment>%1.%2: a version; %3: the name of the OpenGL driver</extracomment>
        <translation>无法显示模型：需要 OpenGL 3.3，而此显示环境仅提供 %1.%2（%3）。请更新显卡驱动程序，或安装 Mesa 的软件驱动 llvmpipe。</translation>
    </message>
</context>
<context>
    <name>ui::ShapeChoosers</name>
    <message>
        <source>Pores</source>
        <translation>毛孔</translation>
    </message>
    <message>
        <source>Scales</source>
        <translation>鳞片</translation>
    </message>
    <message>
        <source>Cracks</source>
        <translation>裂纹</translation>
    </message>
    <message>
        <source>Weave</source>
        <translation>编织</translation>
    </message>
    <message>
        <source>Stripes</source>
        <translation>条纹</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>噪点</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>圆环</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>星形</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>An image that weights the brush: white is full strength, black is none. A spacing of 2 places prints side by side.</source>
        <translation>给笔刷加权的图像：白色为全强度，黑色为零。间距设为 2 时印记并排。</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Load Image…</source>
        <translation>载入图像…</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>图章</translation>
    </message>
    <message>
        <source>The model that Stamp presses in or raises, with its top outwards, and that Add Ball adds.</source>
        <translation>图章压入或隆起的模型，顶部朝外；“添加球”也使用它。</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球</translation>
    </message>
    <message>
        <source>Load Model…</source>
        <translation>载入模型…</translation>
    </message>
    <message>
        <source>This Model</source>
        <translation>当前模型</translation>
    </message>
    <message>
        <source>The model that you sculpt, as it is now.</source>
        <translation>您正在雕刻的模型，按它现在的样子。</translation>
    </message>
</context>
<context>
    <name>ui::SideColumn</name>
    <message>
        <source>Panels</source>
        <translation>面板</translation>
    </message>
</context>
<context>
    <name>ui::SidePanel</name>
    <message>
        <source>Folds or unfolds this panel. With Ctrl it stays open alone.</source>
        <translation>折叠或展开此面板。按住 Ctrl 则只展开这一个。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Hides this panel. View › Panels brings it back.</source>
        <translation>隐藏此面板。可用“视图 › 面板”重新显示。</translation>
    </message>
    <message>
        <source>open</source>
        <translation>已展开</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>已折叠</translation>
    </message>
</context>
<context>
    <name>ui::SimulatorView</name>
    <message>
        <source>VR starts…</source>
        <translation>VR 正在启动…</translation>
    </message>
    <message>
        <source>%1 cm before the surface</source>
        <extracomment>%1: a number</extracomment>
        <translation>在表面前 %1 厘米</translation>
    </message>
    <message>
        <source>%1 cm behind the surface</source>
        <translation>在表面后 %1 厘米</translation>
    </message>
</context>
<context>
    <name>ui::SimulatorWindow</name>
    <message>
        <source>Mouse</source>
        <translation>鼠标</translation>
    </message>
    <message>
        <source>moves the controller on the surface</source>
        <translation>在表面上移动手柄</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>滚轮</translation>
    </message>
    <message>
        <source>farther and nearer</source>
        <translation>远近</translation>
    </message>
    <message>
        <source>Shift and wheel</source>
        <translation>Shift 和滚轮</translation>
    </message>
    <message>
        <source>turns the controller about its own axis</source>
        <translation>让手柄绕自身旋转</translation>
    </message>
    <message>
        <source>Left button, Space</source>
        <translation>左键、空格</translation>
    </message>
    <message>
        <source>trigger; with Shift half as strong</source>
        <translation>扳机；按住 Shift 时力度减半</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>the other controller</source>
        <translation>另一只手柄</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>方向键</translation>
    </message>
    <message>
        <source>press the pad at that side</source>
        <translation>按下触摸板的那一侧</translation>
    </message>
    <message>
        <source>Ctrl and mouse</source>
        <translation>Ctrl 和鼠标</translation>
    </message>
    <message>
        <source>the thumb slides on the pad</source>
        <translation>拇指在触摸板上滑动</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>menu button</source>
        <translation>菜单键</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>squeezes the controller</source>
        <translation>握紧手柄</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>squeezes both controllers</source>
        <translation>握紧两只手柄</translation>
    </message>
    <message>
        <source>Right button</source>
        <translation>右键</translation>
    </message>
    <message>
        <source>looks around</source>
        <translation>环顾</translation>
    </message>
    <message>
        <source>W A S D</source>
        <translation>W A S D</translation>
    </message>
    <message>
        <source>walk</source>
        <translation>行走</translation>
    </message>
    <message>
        <source>E, Q</source>
        <translation>E、Q</translation>
    </message>
    <message>
        <source>up and down</source>
        <translation>上下</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>leaves VR</source>
        <translation>离开 VR</translation>
    </message>
    <message>
        <source>VR Simulator</source>
        <translation>VR 模拟器</translation>
    </message>
    <message>
        <source>What the headset shows</source>
        <translation>头显显示的画面</translation>
    </message>
    <message>
        <source>The mouse moves the left controller.</source>
        <translation>鼠标移动左手柄。</translation>
    </message>
    <message>
        <source>The mouse moves the right controller.</source>
        <translation>鼠标移动右手柄。</translation>
    </message>
</context>
<context>
    <name>ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>起始页</translation>
    </message>
    <message>
        <source>Begin with</source>
        <translation>从这里开始</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>最近的文件</translation>
    </message>
    <message>
        <source>Three short lessons</source>
        <translation>三节短课</translation>
    </message>
    <message>
        <source>What will you make?</source>
        <translation>您想做什么？</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Starts with the ball of clay. (Esc)</source>
        <translation>从黏土球开始。（Esc）</translation>
    </message>
    <message>
        <source>Opens a model that was open before.</source>
        <translation>打开以前打开过的模型。</translation>
    </message>
    <message>
        <source>&amp;Show this page at start</source>
        <translation>启动时显示此页(&amp;S)</translation>
    </message>
    <message>
        <source>Otherwise Fettle starts with a ball of clay; Help › Start Page brings this page back.</source>
        <translation>否则 Fettle 从黏土球开始；“帮助 › 起始页”可重新显示此页。</translation>
    </message>
</context>
<context>
    <name>ui::StrokeEditBar</name>
    <message>
        <source>Edit Last Stroke</source>
        <translation>修改最后一笔</translation>
    </message>
    <message>
        <source>Last stroke:</source>
        <translation>最后一笔：</translation>
    </message>
    <message>
        <source>Tool of the last stroke</source>
        <translation>最后一笔的工具</translation>
    </message>
    <message>
        <source>Changes the tool of the stroke.</source>
        <translation>更改这一笔的工具。</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>保留(&amp;K)</translation>
    </message>
    <message>
        <source>Leaves the stroke as it is now, and hides this bar.</source>
        <translation>保留现在这一笔，并隐藏此栏。</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>Restores the stroke as it was, and hides this bar.</source>
        <translation>恢复原来的那一笔，并隐藏此栏。</translation>
    </message>
</context>
<context>
    <name>ui::Synonyms</name>
    <message>
        <source>add, raise, build, extrude, bump</source>
        <translation>凸起, 增加, 拉高</translation>
    </message>
    <message>
        <source>carve, dig, dent, hole, sink</source>
        <translation>雕刻, 挖, 凹陷, 洞</translation>
    </message>
    <message>
        <source>swell, blow up, fatten</source>
        <translation>膨胀, 变胖</translation>
    </message>
    <message>
        <source>build up, fill, strips</source>
        <translation>堆积, 填充</translation>
    </message>
    <message>
        <source>plane, level</source>
        <translation>压平, 平面</translation>
    </message>
    <message>
        <source>plane, polish, shave</source>
        <translation>刮平, 抛光</translation>
    </message>
    <message>
        <source>blur, relax, soften, even</source>
        <translation>柔化, 磨平, 模糊</translation>
    </message>
    <message>
        <source>squeeze, sharpen, gather</source>
        <translation>收缩, 锐化</translation>
    </message>
    <message>
        <source>move, drag, pull out</source>
        <translation>移动, 拖动</translation>
    </message>
    <message>
        <source>horn, tail, tentacle, handle</source>
        <translation>角, 尾巴, 触手, 把手</translation>
    </message>
    <message>
        <source>rotate, turn, screw</source>
        <translation>旋转, 扭曲</translation>
    </message>
    <message>
        <source>imprint, pattern, hollow</source>
        <translation>压印, 图案, 掏空</translation>
    </message>
    <message>
        <source>color, colour, draw</source>
        <translation>颜色, 上色</translation>
    </message>
    <message>
        <source>protect, freeze, lock</source>
        <translation>保护, 冻结, 锁定</translation>
    </message>
    <message>
        <source>eraser, unfreeze, unlock</source>
        <translation>橡皮擦, 解冻, 解锁</translation>
    </message>
    <message>
        <source>size, bigger, wider, thicker</source>
        <translation>大小, 放大, 加粗</translation>
    </message>
    <message>
        <source>size, thinner, finer</source>
        <translation>大小, 缩小, 变细</translation>
    </message>
    <message>
        <source>size, bigger, diameter</source>
        <translation>大小, 直径</translation>
    </message>
    <message>
        <source>power, intensity, pressure</source>
        <translation>力度, 强度, 压力</translation>
    </message>
    <message>
        <source>opposite, subtract, eraser</source>
        <translation>反转, 减去, 橡皮擦</translation>
    </message>
    <message>
        <source>sphere, primitive, eye</source>
        <translation>球体, 添加, 眼睛</translation>
    </message>
    <message>
        <source>brushes, library</source>
        <translation>笔刷库</translation>
    </message>
    <message>
        <source>lazy, stabilizer, tremor</source>
        <translation>稳定, 防抖</translation>
    </message>
    <message>
        <source>pottery, lathe, wheel, spin</source>
        <translation>陶轮, 车床, 旋转</translation>
    </message>
    <message>
        <source>mirror, both sides, half</source>
        <translation>镜像, 两侧, 一半</translation>
    </message>
    <message>
        <source>join, merge, union, boolean</source>
        <translation>合并, 连接, 布尔</translation>
    </message>
    <message>
        <source>remesh, voxel, even</source>
        <translation>重新布线, 均匀</translation>
    </message>
    <message>
        <source>back, mistake, eraser</source>
        <translation>撤回, 返回, 橡皮擦</translation>
    </message>
    <message>
        <source>adjust, change, correct</source>
        <translation>调整, 修改</translation>
    </message>
    <message>
        <source>settings, options, language, dark, pen, pressure, tablet</source>
        <translation>设置, 选项, 语言, 深色, 压感, 手写笔</translation>
    </message>
    <message>
        <source>size, bigger, smaller, resize, unit</source>
        <translation>大小, 放大, 缩小, 单位</translation>
    </message>
    <message>
        <source>flip, reflect</source>
        <translation>翻转, 反射</translation>
    </message>
    <message>
        <source>voxel, resolution, subdivide, triangles</source>
        <translation>分辨率, 细分, 三角形</translation>
    </message>
    <message>
        <source>cut, bottom, stand, trim</source>
        <translation>切割, 底部, 站立</translation>
    </message>
    <message>
        <source>watertight, thickness, overhang, hollow, support</source>
        <translation>水密, 厚度, 悬垂, 中空, 支撑</translation>
    </message>
    <message>
        <source>stl, slicer, reduce, decimate</source>
        <translation>切片, 减面, 简化</translation>
    </message>
    <message>
        <source>video, film, animation</source>
        <translation>视频, 动画</translation>
    </message>
    <message>
        <source>zoom, fit, center, lost</source>
        <translation>缩放, 居中, 找不到</translation>
    </message>
    <message>
        <source>mesh, polygons, edges</source>
        <translation>网格, 多边形, 边</translation>
    </message>
    <message>
        <source>parallel, isometric</source>
        <translation>平行, 等轴</translation>
    </message>
    <message>
        <source>VR, headset, goggles, vive</source>
        <translation>VR, 头显, 眼镜</translation>
    </message>
    <message>
        <source>manual, documentation</source>
        <translation>手册, 帮助, 文档</translation>
    </message>
    <message>
        <source>tutorial, course, learn</source>
        <translation>教程, 课程, 学习</translation>
    </message>
    <message>
        <source>recover, restore, reload</source>
        <translation>恢复, 重新打开</translation>
    </message>
    <message>
        <source>shadow, contrast, relief</source>
        <translation>阴影, 对比</translation>
    </message>
    <message>
        <source>bright, daylight</source>
        <translation>明亮, 日光</translation>
    </message>
    <message>
        <source>line, groove, wrinkle</source>
        <translation>刻线, 皱纹</translation>
    </message>
    <message>
        <source>cut, slice, crop, scissors, knife, trim</source>
        <translation>切, 裁切, 剪刀, 刀, 修剪</translation>
    </message>
    <message>
        <source>boolean, union, difference, merge, combine</source>
        <translation>布尔, 并集, 差集, 合并, 组合</translation>
    </message>
    <message>
        <source>cut, slice, divide, knife, lasso</source>
        <translation>切, 分割, 分开, 刀, 套索</translation>
    </message>
    <message>
        <source>lasso, select, box, polygon</source>
        <translation>套索, 选择, 方框, 多边形</translation>
    </message>
    <message>
        <source>boolean, hole, drill, cube, sphere, lathe</source>
        <translation>布尔, 孔, 钻, 立方体, 球, 车削</translation>
    </message>
    <message>
        <source>primitive, cube, sphere, cylinder, drag out</source>
        <translation>基本体, 立方体, 球, 圆柱, 拖出</translation>
    </message>
    <message>
        <source>pipe, rope, tail, arm, horn, spline</source>
        <translation>管道, 绳子, 尾巴, 手臂, 角, 样条</translation>
    </message>
</context>
<context>
    <name>ui::ThumbnailMaker</name>
    <message>
        <source>%1: there is not enough memory for its picture.</source>
        <translation>%1：内存不足，无法生成图片。</translation>
    </message>
</context>
<context>
    <name>ui::TimeLapseDialog</name>
    <message>
        <source>Export Time-Lapse</source>
        <translation>导出延时图片</translation>
    </message>
    <message>
        <source>Draws the model after each step, from the current view, as numbered PNG files in a folder that you choose. Sculpting is paused while it runs.</source>
        <translation>从当前视图画出每一步之后的模型，以带编号的 PNG 文件存入您选择的文件夹。其间雕刻暂停。</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 像素</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>大小(&amp;S)：</translation>
    </message>
    <message>
        <source>Steps per &amp;picture:</source>
        <translation>每张图片的步数(&amp;P)：</translation>
    </message>
    <message>
        <source>&amp;Choose Folder…</source>
        <translation>选择文件夹(&amp;C)…</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pictures</source>
        <translation>
            <numerusform>%Ln 张图片</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::Timeline</name>
    <message>
        <source>Timeline</source>
        <translation>时间线</translation>
    </message>
    <message>
        <source>Drag to see the model after each step; Left and Right move by one. Sculpting there removes the later steps.</source>
        <translation>拖动可查看每一步之后的模型；左右方向键逐步移动。在那里雕刻会移除之后的步骤。</translation>
    </message>
    <message>
        <source>Play the steps</source>
        <translation>播放步骤</translation>
    </message>
    <message>
        <source>Plays the steps in order, from here or from the first.</source>
        <translation>从这里或从第一步开始，依次播放各步骤。</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <comment>step, steps, its name</comment>
        <translation>第 %1 步，共 %2 步：%3</translation>
    </message>
</context>
<context>
    <name>ui::ToolPalette</name>
    <message>
        <source>Tool Palette</source>
        <translation>工具选板</translation>
    </message>
</context>
<context>
    <name>ui::TurnCountdown</name>
    <message>
        <source>Time is up</source>
        <translation>时间到</translation>
    </message>
</context>
<context>
    <name>ui::TurntablePanel</name>
    <message>
        <source>The model turns</source>
        <translation>模型转动</translation>
    </message>
    <message>
        <source>Turns the model under your hand. Hold still to cut a groove all around (T).</source>
        <translation>在您手下转动模型。手不动即可刻出一圈沟槽 (T)。</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Direction of the turn, seen from above.</source>
        <translation>转动的方向，从上方看。</translation>
    </message>
    <message>
        <source>Anticlockwise</source>
        <translation>逆时针</translation>
    </message>
    <message>
        <source>Clockwise</source>
        <translation>顺时针</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Speed in degrees per second; 360 are one turn.</source>
        <translation>转动速度，单位为度每秒；360 为一整圈。</translation>
    </message>
    <message>
        <source> °/s</source>
        <translation> °/秒</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>转盘</translation>
    </message>
</context>
<context>
    <name>ui::UnitBar</name>
    <message>
        <source>%1 is %2 units long. Is it in metres (%3 mm)?</source>
        <translation>%1 长 %2 个单位。是米吗（%3 mm）？</translation>
    </message>
    <message>
        <source>As Me&amp;tres</source>
        <translation>按米(&amp;T)</translation>
    </message>
    <message>
        <source>Makes the model 1000 times as large, as one step.</source>
        <translation>一步把模型放大到 1000 倍。</translation>
    </message>
    <message>
        <source>%1 is %2 units long. Is it in inches (%3 mm)?</source>
        <translation>%1 长 %2 个单位。是英寸吗（%3 mm）？</translation>
    </message>
    <message>
        <source>As I&amp;nches</source>
        <translation>按英寸(&amp;N)</translation>
    </message>
    <message>
        <source>Makes the model 25.4 times as large, as one step.</source>
        <translation>一步把模型放大到 25.4 倍。</translation>
    </message>
    <message>
        <source>As &amp;Centimetres</source>
        <translation>按厘米(&amp;C)</translation>
    </message>
    <message>
        <source>Makes the model 10 times as large, as one step.</source>
        <translation>一步把模型放大到 10 倍。</translation>
    </message>
    <message>
        <source>Unit of the Model</source>
        <translation>模型的单位</translation>
    </message>
    <message>
        <source>Le&amp;ave as mm</source>
        <translation>保持毫米(&amp;A)</translation>
    </message>
    <message>
        <source>Leaves the model as it is, and hides this bar.</source>
        <translation>模型保持不变，并隐藏此栏。</translation>
    </message>
</context>
<context>
    <name>ui::Viewport</name>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>The model cannot be shown: the graphics driver lacks a feature that it claims to have.</source>
        <translation>无法显示模型：显卡驱动缺少它声称具备的功能。</translation>
    </message>
</context>
<context>
    <name>ui::WaitingWorksDialog</name>
    <message>
        <source>Models on This Computer</source>
        <translation>本机上的作品</translation>
    </message>
    <message numerus="yes">
        <source>%n models are not yet in the class folder.</source>
        <translation>
            <numerusform>%n 个模型尚未存入课堂文件夹。</numerusform>
        </translation>
    </message>
    <message>
        <source>They are safe in %1 and go to the class folder when this class begins on this computer again. You can copy them now, to a USB drive for example.</source>
        <translation>它们安全地保存在 %1 中，此课堂下次在本机开始时会移到课堂文件夹。您现在也可以复制它们，例如复制到 U 盘。</translation>
    </message>
    <message>
        <source>&amp;Copy to a Folder…</source>
        <translation>复制到文件夹(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;End Class</source>
        <translation>结束课堂(&amp;E)</translation>
    </message>
</context>
<context>
    <name>ui::WaitingWorksNote</name>
    <message>
        <source>Mo&amp;ve to a Folder…</source>
        <translation>移到文件夹(&amp;V)…</translation>
    </message>
    <message>
        <source>Moves each waiting model, in its own folder, to the folder that you choose.</source>
        <translation>把每个等待的模型连同其文件夹移到您选择的文件夹。</translation>
    </message>
</context>
<context>
    <name>vr::Actions</name>
    <message>
        <source>Hand</source>
        <translation>手</translation>
    </message>
    <message>
        <source>Pointing</source>
        <translation>指向</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>扳机</translation>
    </message>
    <message>
        <source>Pad</source>
        <translation>触摸板</translation>
    </message>
    <message>
        <source>Pad touched</source>
        <translation>触摸触摸板</translation>
    </message>
    <message>
        <source>Pad pressed</source>
        <translation>按下触摸板</translation>
    </message>
    <message>
        <source>Side button</source>
        <translation>侧键</translation>
    </message>
    <message>
        <source>Menu button</source>
        <translation>菜单键</translation>
    </message>
    <message>
        <source>Buzz</source>
        <translation>振动</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>捏合</translation>
    </message>
    <message>
        <source>Sculpting</source>
        <translation>雕刻</translation>
    </message>
</context>
<context>
    <name>vr::ColorPanel</name>
    <message>
        <source>Red</source>
        <translation>红</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>绿</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>蓝</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
</context>
<context>
    <name>vr::FilesPanel</name>
    <message>
        <source>One moment…</source>
        <translation>请稍候…</translation>
    </message>
    <message>
        <source>The model has unsaved changes: save it first, or hold to open.</source>
        <translation>模型有未保存的更改：请先保存，或按住以打开。</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <extracomment>%1: names of files</extracomment>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>There are no models here yet. Save adds the first one.</source>
        <translation>这里还没有模型。保存即可添加第一个。</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Hold to open</source>
        <translation>按住以打开</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
</context>
<context>
    <name>vr::HeadsetReport</name>
    <message>
        <source>VR starts. Put on the headset.</source>
        <translation>VR 正在启动。请戴上头显。</translation>
    </message>
    <message>
        <source>VR is on, but the headset shows another program.</source>
        <translation>VR 已开启，但头显正在显示其他程序。</translation>
    </message>
    <message>
        <source>The headset&apos;s own menu is open: the controllers are paused here.</source>
        <translation>头显自己的菜单已打开：手柄在此暂停。</translation>
    </message>
    <message>
        <source>In VR with %1.</source>
        <extracomment>%1: a headset&apos;s name</extracomment>
        <translation>正在使用 %1 进行 VR。</translation>
    </message>
    <message>
        <source>The headset is not worn. Put it on to continue.</source>
        <translation>头显未佩戴。戴上即可继续。</translation>
    </message>
    <message>
        <source>Left VR.</source>
        <translation>已离开 VR。</translation>
    </message>
    <message>
        <source>VR was ended in the headset&apos;s own program.</source>
        <translation>VR 已在头显程序中结束。</translation>
    </message>
    <message>
        <source>The headset&apos;s program does not support the window system “%1”. Start Fettle with QT_QPA_PLATFORM=xcb and QT_XCB_GL_INTEGRATION=xcb_glx, then enter VR again.</source>
        <extracomment>%1: a window system, such as wayland</extracomment>
        <translation>头显程序不支持“%1”类型的窗口。请用 QT_QPA_PLATFORM=xcb 和 QT_XCB_GL_INTEGRATION=xcb_glx 启动 Fettle，然后重新进入 VR。</translation>
    </message>
    <message>
        <source>VR cannot be drawn with this OpenGL.</source>
        <translation>此 OpenGL 无法绘制 VR。</translation>
    </message>
    <message>
        <source>The headset&apos;s program has stopped. The model is as it was; when the program runs again, enter VR again.</source>
        <translation>头显程序已停止。模型保持原样；该程序重新运行后，请再次进入 VR。</translation>
    </message>
    <message>
        <source>The headset is gone. The model is as it was; plug the headset in, then enter VR again.</source>
        <translation>头显已断开。模型保持原样；请接上头显，然后再次进入 VR。</translation>
    </message>
    <message>
        <source>The headset&apos;s program does not answer. The model is as it was; restart that program, then enter VR again.</source>
        <translation>头显程序没有响应。模型保持原样；请重新启动该程序，再进入 VR。</translation>
    </message>
    <message>
        <source>The headset&apos;s program still does not answer, and VR cannot be entered. Restart that program; if that does not help, save the model and restart Fettle.</source>
        <translation>头显程序仍然没有响应，无法进入 VR。请重新启动该程序；如果仍然不行，请保存模型并重新启动 Fettle。</translation>
    </message>
    <message>
        <source>VR ended: the headset&apos;s program reports a fault (%1). The model is as it was; try to enter VR again.</source>
        <extracomment>%1: a call of OpenXR and its result, such as xrCreateSession: XR_ERROR_RUNTIME_FAILURE</extracomment>
        <translation>VR 已结束：头显程序报告错误（%1）。模型保持原样；请尝试再次进入 VR。</translation>
    </message>
</context>
<context>
    <name>vr::LessonPanel</name>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Show Me</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>Try It</source>
        <translation>试一试</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>%1: step %2 of %3</source>
        <extracomment>%1: a lesson&apos;s name; %2 of %3: its step</extracomment>
        <translation>%1：第 %2 步，共 %3 步</translation>
    </message>
</context>
<context>
    <name>vr::ActiveRuntime</name>
    <message>
        <source>No OpenXR runtime is set up on this computer (%1). Install SteamVR, Monado or the headset&apos;s own program, make it the active OpenXR runtime there, then ask again.</source>
        <extracomment>%1: a name from OpenXR, such as XR_ERROR_RUNTIME_UNAVAILABLE</extracomment>
        <translation>这台电脑没有设置 OpenXR 运行时（%1）。请安装 SteamVR、Monado 或头显自带的程序，在其中将它设为活动的 OpenXR 运行时，然后再查找。</translation>
    </message>
    <message>
        <source>Make SteamVR, Monado or the headset&apos;s own program the active OpenXR runtime again, then ask again.</source>
        <translation>请将 SteamVR、Monado 或头显自带的程序重新设为活动的 OpenXR 运行时，然后再查找。</translation>
    </message>
    <message>
        <source>The file of the active OpenXR runtime, %1, is missing or cannot be read (%2).</source>
        <extracomment>%1: a file&apos;s path; %2: a name from OpenXR</extracomment>
        <translation>活动 OpenXR 运行时的文件 %1 不存在或无法读取（%2）。</translation>
    </message>
    <message>
        <source>The file of the active OpenXR runtime, %1, names no runtime (%2).</source>
        <extracomment>%1: a file&apos;s path; %2: a name from OpenXR</extracomment>
        <translation>活动 OpenXR 运行时的文件 %1 没有指明运行时（%2）。</translation>
    </message>
    <message>
        <source>The active OpenXR runtime is not where its file %1 says: there is no %3 (%2).</source>
        <extracomment>%1: a file&apos;s path; %2: a name from OpenXR; %3: the path of a program library</extracomment>
        <translation>活动的 OpenXR 运行时不在其文件 %1 所说的位置：%3 不存在（%2）。</translation>
    </message>
</context>
<context>
    <name>vr::OpenXrRuntime</name>
    <message>
        <source>The OpenXR runtime needs OpenXR 1.1, which this computer&apos;s OpenXR loader does not know (%1). Install a newer loader, or choose another runtime.</source>
        <extracomment>%1: a name from OpenXR, such as XR_ERROR_API_VERSION_UNSUPPORTED</extracomment>
        <translation>该 OpenXR 运行时需要 OpenXR 1.1，而这台电脑的 OpenXR 加载器不支持（%1）。请安装更新的加载器，或选择其他运行时。</translation>
    </message>
    <message>
        <source>No OpenXR runtime answers (%1). Start SteamVR, Monado or the headset&apos;s own program, then ask again.</source>
        <extracomment>%1: a name from OpenXR, such as XR_ERROR_RUNTIME_UNAVAILABLE</extracomment>
        <translation>没有 OpenXR 运行时响应 (%1)。请启动 SteamVR、Monado 或头显自带的程序，然后再次查找。</translation>
    </message>
    <message>
        <source>%1 is running, but no headset is ready (%2). Plug it in and switch it on, then ask again.</source>
        <translation>%1 正在运行，但没有就绪的头显 (%2)。请接好并打开头显，然后再次查找。</translation>
    </message>
    <message>
        <source>%1 supports %2, but it does not support OpenGL.</source>
        <translation>%1 支持 %2，但不支持 OpenGL。</translation>
    </message>
    <message>
        <source>%1 is ready, through %2.</source>
        <translation>%1 已就绪（通过 %2）。</translation>
    </message>
    <message>
        <source>The headset is in use here.</source>
        <translation>头显正在本程序中使用。</translation>
    </message>
    <message>
        <source>%1 asks for OpenGL %2 and refuses OpenGL %3, which Fettle uses. Another OpenXR runtime may accept it.</source>
        <extracomment>%1: the headset&apos;s program; %2, %3: versions, such as 4.5</extracomment>
        <translation>%1 要求 OpenGL %2，不接受 Fettle 使用的 OpenGL %3。其他 OpenXR 运行时也许可以接受。</translation>
    </message>
</context>
<context>
    <name>vr::PerformancePanel</name>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>Handing over</source>
        <translation>提交</translation>
    </message>
    <message>
        <source>Without draw calls</source>
        <translation>不含绘制调用</translation>
    </message>
    <message>
        <source>Draw calls</source>
        <translation>绘制调用</translation>
    </message>
    <message>
        <source>Dropped frames</source>
        <translation>丢帧</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <extracomment>%1: how many frames a second</extracomment>
        <translation>%1 帧/秒</translation>
    </message>
    <message>
        <source>CPU, ms</source>
        <translation>CPU，毫秒</translation>
    </message>
</context>
<context>
    <name>vr::Presets</name>
    <message>
        <source>Turn clockwise</source>
        <translation>顺时针旋转</translation>
    </message>
    <message>
        <source>Turn anticlockwise</source>
        <translation>逆时针旋转</translation>
    </message>
    <message>
        <source>Uniform or not</source>
        <translation>均匀与否</translation>
    </message>
    <message>
        <source>Slide: scale</source>
        <translation>滑动：缩放</translation>
    </message>
    <message>
        <source>Press, push: scale</source>
        <translation>按住推动：缩放</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Previous tool</source>
        <translation>上一个工具</translation>
    </message>
    <message>
        <source>Next tool</source>
        <translation>下一个工具</translation>
    </message>
    <message>
        <source>Move model</source>
        <translation>移动模型</translation>
    </message>
    <message>
        <source>Hold: save</source>
        <translation>按住：保存</translation>
    </message>
    <message>
        <source>Sphere or ray</source>
        <translation>球形或射线</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>对称</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Slide: radius</source>
        <translation>滑动：半径</translation>
    </message>
    <message>
        <source>Press, push: radius</source>
        <translation>按住推动：半径</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Previous channel</source>
        <translation>上一个通道</translation>
    </message>
    <message>
        <source>Next channel</source>
        <translation>下一个通道</translation>
    </message>
    <message>
        <source>Slide: value</source>
        <translation>滑动：数值</translation>
    </message>
    <message>
        <source>Press, push: value</source>
        <translation>按住推动：数值</translation>
    </message>
    <message>
        <source>Sculpt</source>
        <translation>雕刻</translation>
    </message>
    <message>
        <source>Hold: restore</source>
        <translation>按住：重置</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Hold: invert</source>
        <translation>按住：反转</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>反转</translation>
    </message>
    <message>
        <source>Hold: colour</source>
        <translation>按住：颜色</translation>
    </message>
    <message>
        <source>Choose part</source>
        <translation>选择部件</translation>
    </message>
    <message>
        <source>Move part</source>
        <translation>移动部件</translation>
    </message>
    <message>
        <source>Pinch: smooth</source>
        <translation>捏合：平滑</translation>
    </message>
    <message>
        <source>Fist: move model</source>
        <translation>握拳：移动模型</translation>
    </message>
    <message>
        <source>Palm: tools</source>
        <translation>掌心：工具</translation>
    </message>
    <message>
        <source>Pinch: sculpt</source>
        <translation>捏合：雕刻</translation>
    </message>
    <message>
        <source>Palm: colour</source>
        <translation>掌心：颜色</translation>
    </message>
    <message>
        <source>Place shape</source>
        <translation>放置形状</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切割</translation>
    </message>
    <message>
        <source>Draw tube</source>
        <translation>画管子</translation>
    </message>
</context>
<context>
    <name>vr::SettingsPanel</name>
    <message>
        <source>First contact</source>
        <translation>首次接触</translation>
    </message>
    <message>
        <source>Sculpting</source>
        <translation>雕刻</translation>
    </message>
    <message>
        <source>Surfaces join</source>
        <translation>表面融合</translation>
    </message>
    <message>
        <source>Refusal</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>Menus</source>
        <translation>菜单</translation>
    </message>
    <message>
        <source>Holding a button</source>
        <translation>按住按钮</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>论文</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>工作室</translation>
    </message>
    <message>
        <source>Sculpting hand</source>
        <translation>雕刻手</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>On</source>
        <translation>开</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Floor grid</source>
        <translation>地面网格</translation>
    </message>
    <message>
        <source>Real room</source>
        <translation>真实房间</translation>
    </message>
    <message>
        <source>Not on this headset</source>
        <translation>此头显不支持</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>性能</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <extracomment>%1: a number, perhaps with a sign</extracomment>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>Raise model</source>
        <translation>抬高模型</translation>
    </message>
    <message>
        <source>%1°/s</source>
        <extracomment>%1: degrees a second</extracomment>
        <translation>%1°/秒</translation>
    </message>
    <message>
        <source>Turning speed</source>
        <translation>旋转速度</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>General</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>振动</translation>
    </message>
    <message>
        <source>One hand</source>
        <translation>单手</translation>
    </message>
</context>
<context>
    <name>vr::ToolPanel</name>
    <message>
        <source>Pull</source>
        <translation>拉出</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>推入</translation>
    </message>
    <message>
        <source>Flatten</source>
        <translation>压平</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>上色</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Recentre</source>
        <translation>居中</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>扶正</translation>
    </message>
    <message>
        <source>Add ball</source>
        <translation>添加球</translation>
    </message>
    <message>
        <source>Hold to restore</source>
        <translation>按住以重置</translation>
    </message>
    <message>
        <source>Leave VR</source>
        <translation>离开 VR</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>笔刷</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>球形</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>射线</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <extracomment>%1: a radius in the room</extracomment>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>拓扑</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>细化</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>自适应</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>均匀</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>对称</translation>
    </message>
    <message>
        <source>On</source>
        <translation>开</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Inflate</source>
        <translation>膨胀</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>铺泥</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>加层</translation>
    </message>
    <message>
        <source>Scrape</source>
        <translation>刮平</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>收拢</translation>
    </message>
    <message>
        <source>Crease</source>
        <translation>刻痕</translation>
    </message>
    <message>
        <source>Grab</source>
        <translation>抓取</translation>
    </message>
    <message>
        <source>Snake Hook</source>
        <translation>蛇形钩</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>扭转</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>遮罩</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>图章</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>径向</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>反转</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部件</translation>
    </message>
</context>
<context>
    <name>app::BrushCommand</name>
    <message>
        <source>%1: tool %2, strength %3, falloff %4, spacing %5</source>
        <translation>%1：工具 %2，强度 %3，衰减 %4，间距 %5</translation>
    </message>
    <message>
        <source>, alpha %1</source>
        <translation>，Alpha %1</translation>
    </message>
    <message>
        <source>%1: this picture cannot be written.</source>
        <translation>%1：无法写入此图片。</translation>
    </message>
    <message>
        <source>Shows what a brush preset contains, or why it is invalid (status 2). Without a preset: lists the program&apos;s presets.</source>
        <translation>显示笔刷预设的内容，或说明其为何无效（状态 2）。不指定预设时：列出自带的预设。</translation>
    </message>
    <message>
        <source>A preset file, or the name of a preset of the program.</source>
        <translation>预设文件，或自带预设的名称。</translation>
    </message>
    <message>
        <source>File for a picture of one stroke of the brush, PNG.</source>
        <translation>保存该笔刷一笔效果图的文件，PNG。</translation>
    </message>
    <message>
        <source>brush: one preset at a time can be read, not %1 as well.</source>
        <translation>brush：一次只能读取一个预设，不能再加上 %1。</translation>
    </message>
    <message>
        <source>brush: no preset was given.</source>
        <translation>brush：未指定预设。</translation>
    </message>
</context>
<context>
    <name>ui::PresetFiles</name>
    <message>
        <source>%1: there is not enough memory for this preset.</source>
        <translation>%1：内存不足，无法读取此预设。</translation>
    </message>
    <message>
        <source>%1: the alpha in this preset cannot be used: %2</source>
        <comment>a sentence that says why</comment>
        <translation>%1：此预设中的 Alpha 无法使用：%2</translation>
    </message>
</context>
<context>
    <name>ui::PresetLibrary</name>
    <message>
        <source>A brush preset was left out: %1</source>
        <comment>a sentence that says why</comment>
        <translation>略过了一个笔刷预设：%1</translation>
    </message>
    <message numerus="yes">
        <source>%n brush presets were left out. The first: %1</source>
        <comment>a sentence that says why</comment>
        <translation>
            <numerusform>略过了 %n 个笔刷预设。第一个：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was not deleted: it cannot be moved to the trash.</source>
        <translation>%1 未删除：无法移到回收站。</translation>
    </message>
</context>
<context>
    <name>ui::PresetList</name>
    <message>
        <source>Brush presets</source>
        <translation>笔刷预设</translation>
    </message>
    <message>
        <source>New Preset</source>
        <translation>新建预设</translation>
    </message>
    <message>
        <source>Saves the current brush as a preset, and asks for its name.</source>
        <translation>把当前的笔刷保存为预设，并询问其名称。</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Renames this preset (F2).</source>
        <translation>重命名此预设（F2）。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Moves this preset to the trash.</source>
        <translation>把此预设移到回收站。</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Imports a preset from a file.</source>
        <translation>从文件导入预设。</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Writes this preset to a file that others can import.</source>
        <translation>把此预设写成可供他人导入的文件。</translation>
    </message>
    <message>
        <source>My brush</source>
        <translation>我的笔刷</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>预设</translation>
    </message>
</context>
<context>
    <name>ui::PresetTexts</name>
    <message>
        <source>Clay Buildup</source>
        <translation>堆泥</translation>
    </message>
    <message>
        <source>Adds clay in thick rolls, more where you pause.</source>
        <translation>铺上粗粗的黏土条，停留处更多。</translation>
    </message>
    <message>
        <source>Raked Clay</source>
        <translation>耙纹泥</translation>
    </message>
    <message>
        <source>Adds clay in strips, as a rake does.</source>
        <translation>铺上一条条黏土，如耙过一般。</translation>
    </message>
    <message>
        <source>Carve</source>
        <translation>雕刻</translation>
    </message>
    <message>
        <source>Cuts a groove with soft edges.</source>
        <translation>刻出边缘柔和的凹槽。</translation>
    </message>
    <message>
        <source>Swell</source>
        <translation>鼓起</translation>
    </message>
    <message>
        <source>Inflates the surface under it, with a soft edge.</source>
        <translation>使笔下的表面鼓起，边缘柔和。</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>平板</translation>
    </message>
    <message>
        <source>Raises a plate of one height, with steep sides.</source>
        <translation>隆起一块高度一致、边缘陡直的板。</translation>
    </message>
    <message>
        <source>Fine Line</source>
        <translation>细线</translation>
    </message>
    <message>
        <source>Scores a sharp line: wrinkles, eyelids, seams.</source>
        <translation>划出锐利的线：皱纹、眼睑、接缝。</translation>
    </message>
    <message>
        <source>Ridge</source>
        <translation>棱脊</translation>
    </message>
    <message>
        <source>Raises a sharp edge.</source>
        <translation>隆起锐利的棱。</translation>
    </message>
    <message>
        <source>Polish</source>
        <translation>抛光</translation>
    </message>
    <message>
        <source>Removes bumps and keeps hollows.</source>
        <translation>磨去凸起，保留凹处。</translation>
    </message>
    <message>
        <source>Plane Off</source>
        <translation>刨平</translation>
    </message>
    <message>
        <source>Cuts flat faces, like a knife.</source>
        <translation>像刀一样切出平面。</translation>
    </message>
    <message>
        <source>Big Move</source>
        <translation>大幅移动</translation>
    </message>
    <message>
        <source>Moves large parts of the model, softly.</source>
        <translation>柔和地移动模型的大块部分。</translation>
    </message>
    <message>
        <source>Horn</source>
        <translation>犄角</translation>
    </message>
    <message>
        <source>Pulls out horns, tails and roots.</source>
        <translation>拉出角、尾巴和根须。</translation>
    </message>
    <message>
        <source>Pores</source>
        <translation>毛孔</translation>
    </message>
    <message>
        <source>Stamps skin pores.</source>
        <translation>印出皮肤的毛孔。</translation>
    </message>
    <message>
        <source>Scales</source>
        <translation>鳞片</translation>
    </message>
    <message>
        <source>Stamps scales along the stroke.</source>
        <translation>沿笔画印出鳞片。</translation>
    </message>
    <message>
        <source>Cracks</source>
        <translation>裂纹</translation>
    </message>
    <message>
        <source>Stamps the cracks of dry earth.</source>
        <translation>印出干土的裂纹。</translation>
    </message>
    <message>
        <source>Weave</source>
        <translation>编织</translation>
    </message>
    <message>
        <source>Stamps woven cloth along the stroke.</source>
        <translation>沿笔画印出织物纹理。</translation>
    </message>
    <message>
        <source>Rough Stone</source>
        <translation>粗石</translation>
    </message>
    <message>
        <source>Makes the surface rough, like broken stone.</source>
        <translation>使表面粗糙，如碎石一般。</translation>
    </message>
</context>
<context>
    <name>ui::StrokeFileMessages</name>
    <message>
        <source>%1: %2</source>
        <comment>file: reason</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2: %3</source>
        <comment>file: place: reason</comment>
        <translation>%1：%2：%3</translation>
    </message>
    <message>
        <source>line %1, byte %2</source>
        <translation>第 %1 行，第 %2 字节</translation>
    </message>
    <message>
        <source>stroke %1, sample %2 (strokes[%3].samples[%4])</source>
        <extracomment>counted from 1; in brackets as in the file, counted from 0</extracomment>
        <translation>笔画 %1，采样点 %2 (strokes[%3].samples[%4])</translation>
    </message>
    <message>
        <source>stroke %1 (strokes[%2])</source>
        <translation>笔画 %1 (strokes[%2])</translation>
    </message>
    <message>
        <source>this file cannot be read</source>
        <translation>无法读取此文件</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>没有此文件</translation>
    </message>
    <message>
        <source>this file cannot be read (%1)</source>
        <translation>无法读取此文件 (%1)</translation>
    </message>
    <message>
        <source>this is not JSON</source>
        <translation>不是有效的 JSON</translation>
    </message>
    <message>
        <source>this is not a stroke file of version 1 (%1)</source>
        <translation>不是版本 1 的笔画文件（%1）</translation>
    </message>
    <message>
        <source>no object</source>
        <translation>不是对象</translation>
    </message>
    <message>
        <source>unknown key %1</source>
        <translation>未知的键 %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing</source>
        <translation>缺少“%1”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a number</source>
        <translation>“%1”必须是一个数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a whole number</source>
        <translation>“%1”必须是整数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be three numbers, as in [0, 1, 0]</source>
        <translation>“%1”必须是三个数，例如 [0, 1, 0]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be four numbers, as in [0, 0, 0, 1]</source>
        <translation>“%1”必须是四个数，例如 [0, 0, 0, 1]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be three whole numbers from 0 to 255, as in [200, 120, 80]</source>
        <translation>“%1”必须是三个 0 到 255 的整数，例如 [200, 120, 80]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be true or false</source>
        <translation>“%1”必须是 true 或 false</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a word in quotation marks</source>
        <translation>“%1”必须是引号中的词</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a word in quotation marks, true or false</source>
        <translation>“%1”必须是引号中的词、true 或 false</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be an object in braces</source>
        <translation>“%1”必须是花括号中的对象</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of objects, as in [{…}, {…}]</source>
        <translation>“%1”必须是对象的列表，例如 [{…}, {…}]</translation>
    </message>
    <message>
        <source>unknown value, %1</source>
        <translation>未知的值 %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a finite number</source>
        <translation>“%1”不是有限数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range, %2 to %3</source>
        <translation>“%1”超出范围（%2 至 %3）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range</source>
        <translation>“%1”超出范围</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range, 0 or %2 to %3</source>
        <translation>“%1”超出范围（0，或 %2 至 %3）</translation>
    </message>
    <message>
        <source>this file is too large: at most %1 are read</source>
        <translation>此文件过大：最多读取 %1</translation>
    </message>
    <message>
        <source>this is not a brush preset of version 1 (%1)</source>
        <translation>这不是版本 1 的笔刷预设（%1）</translation>
    </message>
    <message>
        <source>this brush preset was made by a newer version of Fettle</source>
        <translation>此笔刷预设由更新版本的 Fettle 制作</translation>
    </message>
    <message>
        <source>&quot;%1&quot; appears twice</source>
        <translation>“%1”重复出现</translation>
    </message>
    <message>
        <source>it has version %1; this program reads version 1</source>
        <translation>其版本为 %1；本程序读取版本 1</translation>
    </message>
    <message>
        <source>%1 is none of %2</source>
        <extracomment>key and value, as in place: &quot;there&quot;</extracomment>
        <translation>%1 不是 %2 之一</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of whole numbers, as in [0, 2]</source>
        <translation>“%1”必须是整数列表，例如 [0, 2]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of pairs of numbers, as in [[10, 0], [8, 20]]</source>
        <translation>“%1”必须是数对的列表，例如 [[10, 0], [8, 20]]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of points of three numbers, as in [[0, 0, 5], [9, 0, 5], [0, 9, 5]]</source>
        <translation>&quot;%1&quot; 必须是由三个数组成的点的列表，如 [[0, 0, 5], [9, 0, 5], [0, 9, 5]]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of points of four numbers, as in [[0, 0, 0, 2], [9, 0, 0, 1]]</source>
        <translation>&quot;%1&quot; 必须是由四个数组成的点的列表，如 [[0, 0, 0, 2], [9, 0, 0, 1]]</translation>
    </message>
</context>
<context>
    <name>app::CommandOptions</name>
    <message>
        <source>Show this help.</source>
        <translation>显示此帮助。</translation>
    </message>
    <message>
        <source>%1: --%2 must be %3, not &quot;%4&quot;.</source>
        <translation>%1：--%2 必须是 %3，而不是“%4”。</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>%1 之一</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>%1 到 %2 的数</translation>
    </message>
    <message>
        <source>a whole number, %1 or more</source>
        <translation>不小于 %1 的整数</translation>
    </message>
    <message>
        <source>%1: --%2 and --%3 cannot be used together.</source>
        <translation>%1：--%2 和 --%3 不能同时使用。</translation>
    </message>
    <message>
        <source>%1: %2 can only be used with --%3.</source>
        <translation>%1：%2 只能与 --%3 一起使用。</translation>
    </message>
    <message>
        <source>Overwrite no existing file; end with status 2 instead.</source>
        <translation>不覆盖已有的文件；改以状态 2 结束。</translation>
    </message>
    <message>
        <source>%1: %2 already exists and is not overwritten, because of --no-clobber.</source>
        <translation>%1：%2 已存在，因 --no-clobber 未被覆盖。</translation>
    </message>
    <message>
        <source>The file to write, in the format of its ending; or -.</source>
        <translation>要写入的文件，格式由扩展名决定；或 -。</translation>
    </message>
    <message>
        <source>%1: the output file is missing; name it with -o.</source>
        <translation>%1：缺少输出文件；请用 -o 指定。</translation>
    </message>
</context>
<context>
    <name>app::NewCommand</name>
    <message>
        <source>The shape.</source>
        <translation>形状。</translation>
    </message>
    <message>
        <source>The file to write, in the format of its ending; or -.</source>
        <translation>要写入的文件，格式由扩展名决定；或 -。</translation>
    </message>
    <message>
        <source>Length of its longest side in mm (default: 100).</source>
        <translation>最长边的长度，单位毫米（默认 100）。</translation>
    </message>
    <message>
        <source>new: needs a shape and a file, as in new ball ball.glb; the shapes are %1.</source>
        <translation>new：需要一个形状和一个文件，如 new ball ball.glb；形状有 %1。</translation>
    </message>
    <message>
        <source>Width of a box, along x, in mm.</source>
        <translation>长方体沿 x 的宽度，毫米。</translation>
    </message>
    <message>
        <source>Height along y in mm; a capsule&apos;s with its round ends.</source>
        <translation>沿 y 的高度，毫米；胶囊体包括其圆端。</translation>
    </message>
    <message>
        <source>Depth of a box, along z, in mm.</source>
        <translation>长方体沿 z 的深度，毫米。</translation>
    </message>
    <message>
        <source>Radius in mm; a cone&apos;s at the bottom, a torus&apos;s to the middle of its tube.</source>
        <translation>半径，毫米；圆锥体为底部半径，圆环为到管中心的半径。</translation>
    </message>
    <message>
        <source>Radius of a cone at the top, in mm (default: 0).</source>
        <translation>圆锥体顶部的半径，毫米（默认：0）。</translation>
    </message>
    <message>
        <source>Radius of a torus&apos;s tube, in mm.</source>
        <translation>圆环的管半径，毫米。</translation>
    </message>
    <message>
        <source>Profile of a lathe: points of radius and height in mm.</source>
        <translation>旋转体的轮廓：由半径和高度组成的点，毫米。</translation>
    </message>
    <message>
        <source>Length of a primitive&apos;s edges in mm (default: automatic).</source>
        <translation>基本体的边长，毫米（默认：自动）。</translation>
    </message>
    <message>
        <source>new: --profile must be points of radius and height, as in &quot;10,0 8,20&quot;, not &quot;%1&quot;.</source>
        <translation>new：--profile 必须是由半径和高度组成的点，例如 &quot;10,0 8,20&quot;，而不是 &quot;%1&quot;。</translation>
    </message>
    <message>
        <source>Writes one of the program&apos;s starting shapes: %1. Or a solid of the given measures: %2.</source>
        <translation>写出程序的一个起始形状：%1。或具有给定尺寸的实体：%2。</translation>
    </message>
    <message>
        <source>new: %1 needs --%2.</source>
        <translation>new：%1 需要 --%2。</translation>
    </message>
    <message>
        <source>new: %1 has no --%2.</source>
        <translation>new：%1 没有 --%2。</translation>
    </message>
    <message>
        <source>new: %1 with measures has no --%2.</source>
        <translation>new：带尺寸的 %1 没有 --%2。</translation>
    </message>
    <message>
        <source>new: the shape must be one of %1, or with measures %2, not &quot;%3&quot;.</source>
        <translation>new：形状必须是 %1 之一，或带尺寸的 %2，而不是 &quot;%3&quot;。</translation>
    </message>
    <message>
        <source>new: %1 has no measures but --%2.</source>
        <translation>new：%1 除 --%2 外没有其他尺寸。</translation>
    </message>
    <message>
        <source>Path of a tube: points of x, y, z and radius in mm.</source>
        <translation>管子的路径：由 x、y、z 和半径组成的点，单位毫米。</translation>
    </message>
    <message>
        <source>new: --path must be points of x, y, z and radius, as in &quot;0,0,0,2 9,5,0,1&quot;, not &quot;%1&quot;.</source>
        <translation>new：--path 必须是由 x、y、z 和半径组成的点，如 &quot;0,0,0,2 9,5,0,1&quot;，而不是 &quot;%1&quot;。</translation>
    </message>
</context>
<context>
    <name>app::StandardFiles</name>
    <message>
        <source>Format of a model that is read from the standard input, -.</source>
        <translation>从标准输入（-）读取的模型的格式。</translation>
    </message>
    <message>
        <source>Format of the standard output, -.</source>
        <translation>标准输出（-）的格式。</translation>
    </message>
    <message>
        <source>%1: --%2 must say the format of -: one of %3.</source>
        <translation>%1：--%2 必须说明 - 的格式：%3 之一。</translation>
    </message>
    <message>
        <source>The standard input cannot be read (%1).</source>
        <translation>无法读取标准输入（%1）。</translation>
    </message>
    <message>
        <source>%1: %2 is binary and is not printed to a terminal: redirect the standard output to a file or a program.</source>
        <translation>%1：%2 是二进制内容，不会显示在终端上：请将标准输出重定向到文件或程序。</translation>
    </message>
    <message>
        <source>The standard output cannot be written (%1).</source>
        <translation>无法写入标准输出（%1）。</translation>
    </message>
    <message>
        <source>(standard input)</source>
        <translation>（标准输入）</translation>
    </message>
    <message>
        <source>(standard output)</source>
        <translation>（标准输出）</translation>
    </message>
</context>
<context>
    <name>app::DocumentStrokes</name>
    <message>
        <source>%1 is hidden. Show it, or choose another part.</source>
        <translation>%1 已隐藏。请显示它，或选择其他部件。</translation>
    </message>
    <message>
        <source>%1 is locked. Unlock it, or choose another part.</source>
        <translation>%1 已锁定。请解锁它，或选择其他部件。</translation>
    </message>
</context>
<context>
    <name>ui::CurveDrawing</name>
    <message>
        <source>Draw around an area.</source>
        <translation>圈出一个区域。</translation>
    </message>
    <message>
        <source>Drag a box over an area.</source>
        <translation>在一个区域上拖出方框。</translation>
    </message>
    <message>
        <source>Drag a line; the area is on its right.</source>
        <translation>拖出一条直线；区域在其右侧。</translation>
    </message>
    <message>
        <source>Click the corners of an area; a double click ends.</source>
        <translation>单击区域的各个角点；双击结束。</translation>
    </message>
    <message>
        <source>The box is too small: drag from one corner to the opposite one.</source>
        <translation>方框太小：请从一个角拖到对角。</translation>
    </message>
    <message>
        <source>The line is too short: drag it across the model.</source>
        <translation>直线太短：请把它拖过模型。</translation>
    </message>
    <message>
        <source>A polygon needs at least three corners that are not in one line.</source>
        <translation>多边形至少需要三个不在一条直线上的角点。</translation>
    </message>
    <message>
        <source>The lasso is too small: drag it around something.</source>
        <translation>套索太小：请拖动鼠标圈出一个区域。</translation>
    </message>
    <message>
        <source>What is inside is masked.</source>
        <translation>里面的部分被遮罩。</translation>
    </message>
    <message>
        <source>The mask inside is removed.</source>
        <translation>里面的遮罩被移除。</translation>
    </message>
    <message>
        <source>What is inside is hidden.</source>
        <translation>里面的部分被隐藏。</translation>
    </message>
    <message>
        <source>What is inside is cut away.</source>
        <translation>里面的部分被切去。</translation>
    </message>
    <message>
        <source>What is inside becomes a part of its own.</source>
        <translation>里面的部分成为独立的部件。</translation>
    </message>
    <message>
        <source>What is outside is masked.</source>
        <translation>外面的部分被遮罩。</translation>
    </message>
    <message>
        <source>The mask outside is removed.</source>
        <translation>外面的遮罩被移除。</translation>
    </message>
    <message>
        <source>What is outside is hidden.</source>
        <translation>外面的部分被隐藏。</translation>
    </message>
    <message>
        <source>What is outside is cut away.</source>
        <translation>外面的部分被切去。</translation>
    </message>
    <message>
        <source>What is outside becomes a part of its own.</source>
        <translation>外面的部分成为独立的部件。</translation>
    </message>
    <message>
        <source>Only what is in front counts.</source>
        <translation>只计前面的部分。</translation>
    </message>
    <message>
        <source>Shift: the other side. Esc cancels.</source>
        <translation>Shift：另一侧。Esc 取消。</translation>
    </message>
</context>
<context>
    <name>ui::PartName</name>
    <message>
        <source>Part %1</source>
        <translation>部件 %1</translation>
    </message>
</context>
<context>
    <name>ui::PartsPanel</name>
    <message>
        <source>Shown. Click to hide.</source>
        <translation>已显示。点击隐藏。</translation>
    </message>
    <message>
        <source>Hidden. Click to show.</source>
        <translation>已隐藏。点击显示。</translation>
    </message>
    <message>
        <source>Locked. Click to unlock.</source>
        <translation>已锁定。点击解锁。</translation>
    </message>
    <message>
        <source>Unlocked. Click to lock.</source>
        <translation>未锁定。点击锁定。</translation>
    </message>
    <message>
        <source>%1, locked</source>
        <translation>%1，已锁定</translation>
    </message>
    <message>
        <source>%1, active</source>
        <translation>%1，当前部件</translation>
    </message>
    <message>
        <source>%1, hidden</source>
        <translation>%1，已隐藏</translation>
    </message>
    <message>
        <source>The parts of the model. Click one to sculpt it, and its name becomes bold; with Ctrl choose others to combine it with. Double-click a name to change it.</source>
        <translation>模型的部件。点击一个进行雕刻，其名称变为粗体；按住 Ctrl 选择要与它组合的其他部件。双击名称可更改。</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部件</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <comment>name of a copied part</comment>
        <translation>%1 副本</translation>
    </message>
    <message>
        <source>Colour of %1 in the List</source>
        <translation>%1 在列表中的颜色</translation>
    </message>
</context>
<context>
    <name>ui::PrimitiveDialog</name>
    <message>
        <source>Insert a Primitive</source>
        <translation>插入基本体</translation>
    </message>
    <message>
        <source>Measures, place, and how it is combined with the present model:</source>
        <translation>尺寸、位置，以及如何与现有模型组合：</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Its axis</source>
        <translation>它的轴</translation>
    </message>
    <message>
        <source>Edge length</source>
        <translation>边长</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>One point a line: its distance from the axis and its height, in millimetres.</source>
        <translation>每行一个点：到轴的距离和高度，单位毫米。</translation>
    </message>
    <message>
        <source>Profile: radius, height</source>
        <translation>轮廓：半径、高度</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>With the middle of its bottom at</source>
        <translation>底面中心位于</translation>
    </message>
    <message>
        <source>Path: X, Y, Z, radius</source>
        <translation>路径：X、Y、Z、半径</translation>
    </message>
    <message>
        <source>One point a line: its place, and the radius of the tube there, in millimetres.</source>
        <translation>每行一个点：它的位置，以及管子在那里的半径，以毫米为单位。</translation>
    </message>
</context>
<context>
    <name>ui::PrimitiveMessages</name>
    <message>
        <source>Box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球体</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>圆柱体</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>圆锥体</translation>
    </message>
    <message>
        <source>Capsule</source>
        <translation>胶囊体</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>圆环</translation>
    </message>
    <message>
        <source>Turned profile</source>
        <translation>旋转轮廓</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Radius at the top</source>
        <translation>顶部半径</translation>
    </message>
    <message>
        <source>Radius of the tube</source>
        <translation>管半径</translation>
    </message>
    <message>
        <source>%1: it must be between a millionth of a millimetre and ten kilometres.</source>
        <extracomment>%1: a measure, for example Height</extracomment>
        <translation>%1：必须在百万分之一毫米到十千米之间。</translation>
    </message>
    <message>
        <source>The radius of a torus must be larger than the radius of its tube.</source>
        <translation>圆环的半径必须大于其管半径。</translation>
    </message>
    <message>
        <source>The height of a capsule must be more than twice its radius.</source>
        <translation>胶囊体的高度必须大于其半径的两倍。</translation>
    </message>
    <message>
        <source>A profile needs 2 to 1000 different points, none with a radius below 0; only its ends may be on the axis.</source>
        <translation>轮廓需要 2 到 1000 个不同的点，半径不得小于 0；只有两端可以在轴上。</translation>
    </message>
    <message>
        <source>The profile crosses or touches itself, or its walls are too thin for edges this long.</source>
        <translation>轮廓自相交或自相接触，或者对于这样长的边，壁太薄。</translation>
    </message>
    <message>
        <source>For this shape, the edges may be %1 mm long at most.</source>
        <translation>对于此形状，边长最多为 %1 毫米。</translation>
    </message>
    <message>
        <source>This shape would need too many triangles (%1, at most 2 million): its edges would be too short for its size.</source>
        <translation>此形状需要的三角形太多（%1，最多 200 万）：相对于其大小，边太短。</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>管子</translation>
    </message>
    <message>
        <source>A tube needs 2 to 1000 points, each at another place than the one before it, with radii that are not tiny beside their distance from the origin.</source>
        <translation>管子需要 2 到 1000 个点，每个点都与前一个点位置不同，且半径与到原点的距离相比不能过小。</translation>
    </message>
    <message>
        <source>The tube crosses itself too often. Make it thinner, or its curve smoother.</source>
        <translation>管子与自身相交过多。请把它变细，或使曲线更平滑。</translation>
    </message>
</context>
<context>
    <name>ui::AreaBar</name>
    <message>
        <source>Lasso</source>
        <translation>套索</translation>
    </message>
    <message>
        <source>Draw freely around the area (1).</source>
        <translation>自由圈出区域 (1)。</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>方框</translation>
    </message>
    <message>
        <source>Drag a box over the area (2).</source>
        <translation>在区域上拖出方框 (2)。</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>Drag a line; the area is on its right (3).</source>
        <translation>拖出一条直线；区域在其右侧 (3)。</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>Click the corners of the area (4).</source>
        <translation>单击区域的各个角点 (4)。</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>外面</translation>
    </message>
    <message>
        <source>Takes what is beside the curve instead (O, or hold Shift).</source>
        <translation>改为取曲线外面的部分（O，或按住 Shift）。</translation>
    </message>
    <message>
        <source>Only in Front</source>
        <translation>仅前面</translation>
    </message>
    <message>
        <source>Takes only what is seen first, not what is behind it (F).</source>
        <translation>只取最先看到的部分，不取其后面的部分 (F)。</translation>
    </message>
    <message>
        <source>Coloured</source>
        <translation>上色</translation>
    </message>
    <message>
        <source>Gives the faces of the cut the paint colour (P).</source>
        <translation>给切面涂上笔刷颜色 (P)。</translation>
    </message>
</context>
<context>
    <name>ui::ObjectsBar</name>
    <message>
        <source>Objects of the File</source>
        <translation>文件中的对象</translation>
    </message>
    <message numerus="yes">
        <source>%1 has %Ln objects. Each is a part now.</source>
        <translation>
            <numerusform>%1 有 %Ln 个对象，各自成为一个部件。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 has %Ln objects. They are one part now.</source>
        <translation>
            <numerusform>%1 有 %Ln 个对象，已合为一个部件。</numerusform>
        </translation>
    </message>
    <message>
        <source>Open as &amp;One Part</source>
        <translation>作为一个部件打开(&amp;O)</translation>
    </message>
    <message>
        <source>Opens the file again and makes one part of all objects, also of files opened later.</source>
        <translation>重新打开文件，把所有对象合为一个部件；以后打开的文件也是如此。</translation>
    </message>
    <message>
        <source>Open as &amp;Parts</source>
        <translation>作为部件打开(&amp;P)</translation>
    </message>
    <message>
        <source>Opens the file again and makes a part of each object, also of files opened later.</source>
        <translation>重新打开文件，使每个对象成为一个部件；以后打开的文件也是如此。</translation>
    </message>
    <message>
        <source>&amp;Keep as It Is</source>
        <translation>保持原样(&amp;K)</translation>
    </message>
    <message>
        <source>Leaves the model as it is, and hides this bar.</source>
        <translation>模型保持不变，并隐藏此栏。</translation>
    </message>
</context>
<context>
    <name>ui::PlaneCutTool</name>
    <message>
        <source>Colour the cu&amp;t</source>
        <translation>切面上色(&amp;T)</translation>
    </message>
    <message>
        <source>Cut Away gives the flat face the paint colour.</source>
        <translation>“切除”给切出的平面涂上笔刷颜色。</translation>
    </message>
    <message>
        <source>&amp;Cut Away</source>
        <translation>切除(&amp;C)</translation>
    </message>
    <message>
        <source>Removes what is tinted, and closes the cut with a flat face.</source>
        <translation>去掉着色的部分，并用平面封闭切口。</translation>
    </message>
    <message>
        <source>&amp;Split</source>
        <translation>分割(&amp;S)</translation>
    </message>
    <message>
        <source>Makes what is tinted a part of its own.</source>
        <translation>把着色的部分变成单独的部件。</translation>
    </message>
    <message>
        <source>S&amp;wap Sides</source>
        <translation>交换两侧(&amp;W)</translation>
    </message>
    <message>
        <source>Turns the plane over, so that the other side is tinted.</source>
        <translation>翻转平面，使另一侧着色。</translation>
    </message>
    <message>
        <source>D&amp;one</source>
        <translation>完成(&amp;O)</translation>
    </message>
    <message>
        <source>Hides the plane (Esc).</source>
        <translation>隐藏平面（Esc）。</translation>
    </message>
    <message>
        <source>Symmetry: the mirror image of the plane cuts, too.</source>
        <translation>对称：平面的镜像也会切割。</translation>
    </message>
    <message>
        <source>Symmetry: the plane is its own mirror image, so it cuts once.</source>
        <translation>对称：平面与自身的镜像重合，只切一次。</translation>
    </message>
    <message>
        <source>This is the plane of symmetry, so one half goes.</source>
        <translation>这是对称平面，因此会去掉一半。</translation>
    </message>
</context>
<context>
    <name>ui::TransformFields</name>
    <message>
        <source>Move, mm</source>
        <translation>移动，毫米</translation>
    </message>
    <message>
        <source>Rotate, °</source>
        <translation>旋转，°</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Axes of the handles and of these numbers: the document&apos;s, or those that turn with the part.</source>
        <translation>手柄和这些数值所用的轴：文档的轴，或随部件转动的轴。</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Document&apos;s axes</source>
        <translation>文档的轴</translation>
    </message>
    <message>
        <source>Part&apos;s own axes</source>
        <translation>部件自己的轴</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>应用(&amp;A)</translation>
    </message>
    <message>
        <source>Applies these numbers (Return).</source>
        <translation>按这些数值执行更改（回车键）。</translation>
    </message>
    <message>
        <source>D&amp;one</source>
        <translation>完成(&amp;O)</translation>
    </message>
    <message>
        <source>Hides the handles (Esc).</source>
        <translation>隐藏手柄（Esc）。</translation>
    </message>
    <message>
        <source>Move along %1</source>
        <translation>沿 %1 移动</translation>
    </message>
    <message>
        <source>Rotate about %1</source>
        <translation>绕 %1 旋转</translation>
    </message>
    <message>
        <source>Scale along %1</source>
        <translation>沿 %1 缩放</translation>
    </message>
</context>
<context>
    <name>vr::PartsPanel</name>
    <message>
        <source>%1 copy</source>
        <comment>name of a copied part</comment>
        <translation>%1 副本</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>单独显示</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>复制一份</translation>
    </message>
    <message>
        <source>Hold to delete</source>
        <translation>按住以删除</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>合并</translation>
    </message>
    <message>
        <source>Subtract</source>
        <translation>减去</translation>
    </message>
    <message>
        <source>Intersect</source>
        <translation>相交</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球体</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>圆柱体</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>圆锥体</translation>
    </message>
    <message>
        <source>Capsule</source>
        <translation>胶囊体</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>圆环</translation>
    </message>
    <message>
        <source>Trigger: chooses the part that you point at. Side button: moves the chosen part. Mark others to combine them with it.</source>
        <translation>扳机：选择所指的部件。侧键：移动所选的部件。标记其他部件，可与它组合。</translation>
    </message>
    <message>
        <source>Join with the part</source>
        <translation>与部件合并</translation>
    </message>
    <message>
        <source>Part of its own</source>
        <translation>单独的部件</translation>
    </message>
    <message>
        <source>Trigger: puts the shape at the tip, as large as the brush. Side button: moves the chosen part.</source>
        <translation>扳机：把形状放在尖端，与笔刷一样大。侧键：移动所选部件。</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>切除</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>两边都保留</translation>
    </message>
    <message>
        <source>Trigger: cuts the chosen part at the disc. What lies beyond the disc, away from your hand, becomes a part of its own. Side button: moves the part.</source>
        <translation>扳机：在圆盘处切割所选部件，圆盘另一侧、远离手的部分成为单独的部件。侧键：移动部件。</translation>
    </message>
    <message>
        <source>Trigger: cuts the chosen part at the disc. What lies beyond the disc, away from your hand, is removed. Side button: moves the part.</source>
        <translation>扳机：在圆盘处切割所选部件，切去圆盘另一侧、远离手的部分。侧键：移动部件。</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部件</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切割</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>管子</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>身体</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>头</translation>
    </message>
    <message>
        <source>Hair</source>
        <translation>头发</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>眼睛</translation>
    </message>
    <message>
        <source>Ear</source>
        <translation>耳朵</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>手臂</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>手</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>腿</translation>
    </message>
    <message>
        <source>Wing</source>
        <translation>翅膀</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>尾巴</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>轮子</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>底座</translation>
    </message>
    <message>
        <source>No colour</source>
        <translation>无颜色</translation>
    </message>
    <message>
        <source>Name and colour go to the chosen part. Trigger: chooses the part that you point at. Side button: moves it.</source>
        <translation>名称和颜色用于所选部件。扳机：选择所指的部件。侧键：移动它。</translation>
    </message>
    <message>
        <source>Trigger: hold it and move your hand to draw a tube, as thick as the brush. Side button: moves the chosen part.</source>
        <translation>扳机：按住并移动手，画出一根管子，与笔刷一样粗。侧键：移动所选部件。</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
</context>
<context>
    <name>app::ModelChanger</name>
    <message>
        <source>Preview: %1</source>
        <translation>预览：%1</translation>
    </message>
</context>
<context>
    <name>ui::CombinationCard</name>
    <message>
        <source>Join</source>
        <translation>合并</translation>
    </message>
    <message>
        <source>Subtract</source>
        <translation>减去</translation>
    </message>
    <message>
        <source>Intersect</source>
        <translation>相交</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>应用(&amp;A)</translation>
    </message>
    <message>
        <source>Keeps what is shown, as one step (Return).</source>
        <translation>保留所显示的结果，作为一步（回车）。</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>Leaves the parts as they were (Esc).</source>
        <translation>部件保持原样（Esc）。</translation>
    </message>
</context>
<context>
    <name>ui::SolidCard</name>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>A&amp;pply</source>
        <translation>应用(&amp;P)</translation>
    </message>
    <message>
        <source>Makes the solid (Return).</source>
        <translation>生成实体（回车）。</translation>
    </message>
    <message>
        <source>Middle, %1</source>
        <translation>中心 %1</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>Makes no solid (Esc).</source>
        <translation>不生成实体（Esc）。</translation>
    </message>
    <message>
        <source>&amp;Turn to the surface</source>
        <translation>垂直于表面(&amp;T)</translation>
    </message>
    <message>
        <source>The solid stands at a right angle to the surface. Off: along the nearest axis.</source>
        <translation>实体垂直立在表面上。关闭时：沿最近的坐标轴。</translation>
    </message>
</context>
<context>
    <name>ui::SolidTool</name>
    <message>
        <source>Change the numbers, then apply (Return). Esc cancels.</source>
        <translation>更改数值，然后应用（回车）。按 Esc 取消。</translation>
    </message>
    <message>
        <source>Press on the model or the ground, and drag to the size. Esc cancels.</source>
        <translation>在模型或地面上按下，并拖出大小。按 Esc 取消。</translation>
    </message>
</context>
<context>
    <name>ui::TubeCard</name>
    <message>
        <source>Radius of the tube at the chosen point.</source>
        <translation>管子在所选点处的半径。</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>of &amp;all points</source>
        <translation>所有点(&amp;A)</translation>
    </message>
    <message>
        <source>Gives every point this radius.</source>
        <translation>使每个点都用这个半径。</translation>
    </message>
    <message>
        <source>A&amp;pply</source>
        <translation>应用(&amp;P)</translation>
    </message>
    <message>
        <source>Makes the tube (Return).</source>
        <translation>生成管子（回车）。</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>Makes no tube (Esc).</source>
        <translation>不生成管子（Esc）。</translation>
    </message>
</context>
<context>
    <name>ui::TubeTool</name>
    <message>
        <source>Draw the middle of a tube, on the model or beside it. Esc cancels.</source>
        <translation>在模型上或旁边画出管子的中线。按 Esc 取消。</translation>
    </message>
    <message>
        <source>Drag a point or its circle; with Shift all circles. A double click on the line adds a point, Delete removes one.</source>
        <translation>拖动点或它的圆；按住 Shift 同时改变所有圆。双击连线添加点，按 Delete 移除点。</translation>
    </message>
</context>
</TS>
