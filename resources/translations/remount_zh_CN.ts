<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>main</name>
    <message>
        <source>Finds where a LiDAR sits on a vehicle, relative to its GNSS/INS.</source>
        <translation>求出激光雷达在车辆上相对于 GNSS/INS 的安装位置。</translation>
    </message>
    <message>
        <source>Open the bundled sample session.</source>
        <translation>打开随附的示例数据。</translation>
    </message>
    <message>
        <source>Sessions (folders or files) or a project to open.</source>
        <translation>要打开的数据（文件夹或文件）或项目。</translation>
    </message>
</context>
<context>
    <name>remount::gui::Autosave</name>
    <message>
        <source>the disk does not answer</source>
        <translation>磁盘没有响应</translation>
    </message>
</context>
<context>
    <name>remount::gui::Calibrations</name>
    <message>
        <source>other files in the sessions</source>
        <translation>数据中的文件变了</translation>
    </message>
    <message>
        <source>decisions about pairs that the solution does not answer in full</source>
        <translation>求解尚未完整反映的帧对决定</translation>
    </message>
    <message>
        <source>There is nothing to calibrate yet: open a recorded session first.</source>
        <translation>还没有可标定的内容：请先打开一次行驶记录。</translation>
    </message>
    <message>
        <source>Nominal mounting</source>
        <translation>名义安装</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>Calibration started</source>
        <translation>标定开始</translation>
    </message>
    <message>
        <source>decisions during the calibration</source>
        <translation>标定期间的决定</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>The result that was there before is kept. %1 of %2 pairs were aligned anew by then; they are left out.</source>
        <translation>保留之前的结果。此时 %2 个帧对中有 %1 个已重新配准，未予采用。</translation>
    </message>
    <message>
        <source>Cancelled before there was anything that could be kept.</source>
        <translation>已取消，当时还没有可以保留的内容。</translation>
    </message>
    <message>
        <source>cancelled calibration</source>
        <translation>已取消的标定</translation>
    </message>
    <message>
        <source>%1 of %2 pairs were aligned by then; they are kept, and solved.</source>
        <translation>取消时 %2 个帧对中已有 %1 个完成配准；它们已保留并正在求解。</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>This method has no pairs. Those of the calibration before come back by undo (Ctrl+Z), and decisions on them hold for the next calibration from pairs.</source>
        <translation>此方法没有帧对。撤销 (Ctrl+Z) 可恢复上一次标定的帧对；对它们的决定在下一次帧对标定时仍然有效。</translation>
    </message>
    <message>
        <source>The calibration was of other sessions or topics than there are now: it is left out. Calibrate (F5) for these.</source>
        <translation>该标定所用的数据或话题与现在的不同：未予采用。请为现在的数据标定 (F5)。</translation>
    </message>
    <message>
        <source>decisions before</source>
        <translation>此前的决定</translation>
    </message>
    <message>
        <source>calibration (%1)</source>
        <translation>标定（%1）</translation>
    </message>
</context>
<context>
    <name>remount::gui::CandidatesFeature</name>
    <message>
        <source>Candidates</source>
        <translation>候选</translation>
    </message>
</context>
<context>
    <name>remount::gui::ContactSheetFeature</name>
    <message>
        <source>All pairs</source>
        <translation>所有帧对</translation>
    </message>
    <message>
        <source>&amp;All pairs</source>
        <translation>所有帧对(&amp;A)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>From above: %1, scan a by its distance to scan b: %2, %3, %4. Below: the best wall, cut, ± %5 mm</source>
        <translation>上部俯视：%1，扫描 a 按到扫描 b 的距离：%2、%3、%4。下部：最清楚的墙的剖面，± %5 mm</translation>
    </message>
    <message>
        <source>scan b</source>
        <translation>扫描 b</translation>
    </message>
    <message>
        <source>%1 mm behind</source>
        <translation>后方 %1 mm</translation>
    </message>
    <message>
        <source>on it</source>
        <translation>在表面上</translation>
    </message>
    <message>
        <source>%1 mm before</source>
        <translation>前方 %1 mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>wall %1 mm</source>
        <translation>墙 %1 mm</translation>
    </message>
</context>
<context>
    <name>remount::gui::Decisions</name>
    <message>
        <source>accept pair %1</source>
        <translation>接受帧对 %1</translation>
    </message>
    <message>
        <source>accept %1 pairs</source>
        <translation>接受 %1 个帧对</translation>
    </message>
    <message>
        <source>reject pair %1</source>
        <translation>拒绝帧对 %1</translation>
    </message>
    <message>
        <source>reject %1 pairs</source>
        <translation>拒绝 %1 个帧对</translation>
    </message>
    <message>
        <source>pair %1: %2</source>
        <translation>帧对 %1：%2</translation>
    </message>
    <message>
        <source>Cannot be accepted, for no solution can use it</source>
        <translation>不能接受，因为任何解都用不上</translation>
    </message>
    <message>
        <source>take back the decision on pair %1</source>
        <translation>撤回对帧对 %1 的决定</translation>
    </message>
    <message>
        <source>take back the decisions on %1 pairs</source>
        <translation>撤回对 %1 个帧对的决定</translation>
    </message>
</context>
<context>
    <name>remount::gui::DriveFeature</name>
    <message>
        <source>Drive</source>
        <translation>行驶</translation>
    </message>
</context>
<context>
    <name>remount::gui::FramesForm</name>
    <message>
        <source>Frames:</source>
        <translation>坐标系：</translation>
    </message>
    <message>
        <source>In whose frame all are</source>
        <translation>全部位于哪个坐标系</translation>
    </message>
    <message>
        <source>in the frame of the INS</source>
        <translation>在 INS 坐标系中</translation>
    </message>
    <message>
        <source>in the frame of %1</source>
        <translation>在 %1 坐标系中</translation>
    </message>
    <message>
        <source>INS</source>
        <translation>INS</translation>
    </message>
    <message>
        <source>Name of the frame of %1</source>
        <translation>%1 的坐标系名称</translation>
    </message>
    <message>
        <source>Name of the frame of %1; empty: the usual one</source>
        <translation>%1 的坐标系名称；留空则用惯用名称</translation>
    </message>
</context>
<context>
    <name>remount::gui::HelpFeature</name>
    <message>
        <source>Open &amp;sample session</source>
        <translation>打开示例数据(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Help on this panel</source>
        <translation>本面板的帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>按键(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About Remount</source>
        <translation>关于 Remount(&amp;A)</translation>
    </message>
    <message>
        <source>About Remount</source>
        <translation>关于 Remount</translation>
    </message>
    <message>
        <source>&lt;b&gt;Remount %1&lt;/b&gt;&lt;p&gt;Finds where a LiDAR sits on a vehicle, relative to its GNSS/INS, from recorded drives.&lt;/p&gt;</source>
        <translation>&lt;b&gt;Remount %1&lt;/b&gt;&lt;p&gt;根据行驶记录求出激光雷达在车辆上相对于 GNSS/INS 的安装位置。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>remount::gui::ImportController</name>
    <message>
        <source>Folder with scans or tables</source>
        <translation>扫描或表格所在的文件夹</translation>
    </message>
    <message>
        <source>Tables, captures or other files</source>
        <translation>表格、捕获文件或其他文件</translation>
    </message>
    <message>
        <source>Save the manifest</source>
        <translation>保存清单</translation>
    </message>
    <message>
        <source>Manifests (*.yaml)</source>
        <translation>清单 (*.yaml)</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
    <message>
        <source>%1 is open. Close that session first, or save the manifest elsewhere. Nothing was written.</source>
        <translation>%1 已打开。请先关闭该数据，或将清单保存到别处。未写入任何内容。</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>正在保存 %1…</translation>
    </message>
</context>
<context>
    <name>remount::gui::ImportFeature</name>
    <message>
        <source>&amp;Import a table…</source>
        <translation>导入表格(&amp;I)…</translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation>Ctrl+I</translation>
    </message>
    <message>
        <source>Import a table…</source>
        <translation>导入表格…</translation>
    </message>
    <message>
        <source>The table with the motion of the INS</source>
        <translation>含 INS 运动的表格</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt *.tsv *.dat *.asc *.log *.pos);;All files (*)</source>
        <translation>表格 (*.csv *.txt *.tsv *.dat *.asc *.log *.pos);;所有文件 (*)</translation>
    </message>
    <message>
        <source>It cannot be opened: %1</source>
        <translation>无法打开：%1</translation>
    </message>
</context>
<context>
    <name>remount::gui::InputFiles</name>
    <message>
        <source>is not as it was when the result that is shown was made. Calibrate again (F5).</source>
        <translation>与得到所示结果时不同。请重新标定 (F5)。</translation>
    </message>
</context>
<context>
    <name>remount::gui::JobRunner</name>
    <message>
        <source>There is not enough memory. Lower cache_mb in the options, or use fewer keyframes.</source>
        <translation>内存不足。请在选项中减小 cache_mb，或使用更少的关键帧。</translation>
    </message>
    <message>
        <source>Unexpected failure: %1. What was there is kept.</source>
        <translation>意外失败：%1。原有内容已保留。</translation>
    </message>
</context>
<context>
    <name>remount::gui::KeyBindings</name>
    <message>
        <source>Reject: %1</source>
        <translation>拒绝：%1</translation>
    </message>
    <message>
        <source>3-D view: %1</source>
        <translation>三维视图：%1</translation>
    </message>
</context>
<context>
    <name>remount::gui::LogFeature</name>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
</context>
<context>
    <name>remount::gui::MainWindow</name>
    <message>
        <source>Remount</source>
        <translation>Remount 标定</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>适合窗口(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>俯视(&amp;T)</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>前视(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>恢复布局(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>按键(&amp;K)…</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>左视(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>轴测(&amp;I)</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>全屏(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Everything</source>
        <translation>全部面板(&amp;E)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Re&amp;view of pairs</source>
        <translation>帧对审查(&amp;V)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R</source>
        <translation>Ctrl+Shift+R</translation>
    </message>
</context>
<context>
    <name>remount::gui::MapController</name>
    <message>
        <source>The scans of a session, put together under one mounting, are shown here after a calibration.</source>
        <translation>标定之后，这里显示一份数据的全部扫描按同一安装拼合成的地图。</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>名义</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>Candidate %1</source>
        <translation>候选 %1</translation>
    </message>
    <message>
        <source>There is no result to put the scans together with. Choose another mounting above.</source>
        <translation>没有可用来拼合扫描的结果。请在上方选择其他安装。</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>已取消。</translation>
    </message>
    <message>
        <source>This session has no scans to put together.</source>
        <translation>此数据没有可拼合的扫描。</translation>
    </message>
    <message>
        <source>the nominal mounting</source>
        <translation>名义安装</translation>
    </message>
    <message>
        <source>the mounting that the calibration started from</source>
        <translation>标定的起始安装</translation>
    </message>
    <message>
        <source>candidate %1</source>
        <translation>候选 %1</translation>
    </message>
    <message>
        <source>the result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>%1: %2 scans under %3.</source>
        <translation>%1：%2 帧扫描，按%3拼合。</translation>
    </message>
    <message>
        <source>%1 cannot be read (%2).</source>
        <translation>%1 帧无法读取（%2）。</translation>
    </message>
    <message>
        <source>Thinned from %1 points.</source>
        <translation>由 %1 个点抽稀而来。</translation>
    </message>
</context>
<context>
    <name>remount::gui::MapFeature</name>
    <message>
        <source>Map</source>
        <translation>地图</translation>
    </message>
    <message>
        <source>The accumulated &amp;map</source>
        <translation>累积地图(&amp;M)</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
</context>
<context>
    <name>remount::gui::Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>打开(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Calibrate</source>
        <translation>标定(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Review</source>
        <translation>审查(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
</context>
<context>
    <name>remount::gui::MethodChooser</name>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Needs: %1</source>
        <translation>需要：%1</translation>
    </message>
</context>
<context>
    <name>remount::gui::MethodController</name>
    <message>
        <source>After a calibration the figures and plots of its method are shown here.</source>
        <translation>标定后，该方法的数值与曲线显示在这里。</translation>
    </message>
    <message>
        <source>Method: %1</source>
        <translation>方法：%1</translation>
    </message>
    <message>
        <source>After a calibration the ways that its method found are shown here in space.</source>
        <translation>标定之后，这里在空间中显示所用方法求得的轨迹。</translation>
    </message>
    <message>
        <source>The method drew nothing in space.</source>
        <translation>该方法没有可在空间中显示的内容。</translation>
    </message>
    <message>
        <source>The method drew no way of its own: its scans are in the views &quot;Pair&quot; and &quot;Map&quot;.</source>
        <translation>该方法没有自己的轨迹：它的扫描在“帧对”和“地图”视图中。</translation>
    </message>
    <message>
        <source>Method: %1. Its figures are in the other panels.</source>
        <translation>方法：%1。其数值在其他面板中。</translation>
    </message>
</context>
<context>
    <name>remount::gui::MethodsFeature</name>
    <message>
        <source>Figures and plots</source>
        <translation>数值与曲线</translation>
    </message>
    <message>
        <source>In three dimensions</source>
        <translation>三维视图</translation>
    </message>
    <message>
        <source>Results compared</source>
        <translation>结果比较</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Figures of the &amp;method, results compared</source>
        <translation>方法的数值与结果比较(&amp;M)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>Results to compare</source>
        <translation>要比较的结果</translation>
    </message>
    <message>
        <source>Results (*.yaml *.yml *.json);;All files (*)</source>
        <translation>结果 (*.yaml *.yml *.json);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>remount::gui::Outcome</name>
    <message>
        <source>result confirmed</source>
        <translation>结果已确认</translation>
    </message>
    <message>
        <source>confirmation of the result taken back</source>
        <translation>已收回对结果的确认</translation>
    </message>
</context>
<context>
    <name>remount::gui::PairViewFeature</name>
    <message>
        <source>Pair</source>
        <translation>帧对</translation>
    </message>
    <message>
        <source>The &amp;pair</source>
        <translation>帧对(&amp;P)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation>Ctrl+Shift+P</translation>
    </message>
    <message>
        <source>Check &amp;obstacles…</source>
        <translation>检查障碍物(&amp;O)…</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>&amp;Flip before and after</source>
        <translation>切换之前与之后(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Blink</source>
        <translation>闪烁(&amp;B)</translation>
    </message>
    <message>
        <source>Reading the scans of pair %1…</source>
        <translation>正在读取帧对 %1 的扫描…</translation>
    </message>
    <message>
        <source>The scans of pair %1 cannot be shown.
%2</source>
        <translation>无法显示帧对 %1 的扫描。
%2</translation>
    </message>
    <message>
        <source>Pair %1: %2 → %3, %4 m, %5°. %6</source>
        <translation>帧对 %1：%2 → %3，%4 m，%5°。%6</translation>
    </message>
    <message>
        <source>Pair %1 comes from LiDAR poses: there are no scans to show.</source>
        <translation>帧对 %1 来自激光雷达位姿：没有扫描可显示。</translation>
    </message>
    <message>
        <source>scan b of pair %1, %2</source>
        <translation>帧对 %1 的扫描 b，%2</translation>
    </message>
    <message>
        <source>%1, of the LiDAR %2</source>
        <translation>%1，激光雷达 %2</translation>
    </message>
    <message>
        <source>Show or hide the &amp;ground</source>
        <translation>显示或隐藏地面(&amp;G)</translation>
    </message>
</context>
<context>
    <name>remount::gui::PairsFeature</name>
    <message>
        <source>Pairs</source>
        <translation>帧对</translation>
    </message>
    <message>
        <source>Error chart</source>
        <translation>误差图</translation>
    </message>
    <message>
        <source>&amp;Accept pair</source>
        <translation>接受帧对(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Reject pair</source>
        <translation>拒绝帧对(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Next pair</source>
        <translation>下一帧对(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Previous pair</source>
        <translation>上一帧对(&amp;P)</translation>
    </message>
    <message>
        <source>Next pair that yo&amp;u have not decided</source>
        <translation>下一个您尚未判定的帧对(&amp;U)</translation>
    </message>
    <message>
        <source>Reject &amp;because</source>
        <translation>拒绝的理由(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Other reason…</source>
        <translation>其他理由(&amp;O)…</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>Why is pair %1 rejected?</source>
        <translation>为什么拒绝帧对 %1？</translation>
    </message>
    <message>
        <source>Why are %1 pairs rejected?</source>
        <translation>为什么拒绝 %1 个帧对？</translation>
    </message>
    <message>
        <source>You have decided every pair that is shown.</source>
        <translation>显示的帧对您都已作出决定。</translation>
    </message>
    <message>
        <source>&amp;Flag pair</source>
        <translation>标记帧对(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Comment on pair…</source>
        <translation>给帧对写备注(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Go on to the next pair after a decision</source>
        <translation>决定后转到下一个帧对(&amp;G)</translation>
    </message>
    <message>
        <source>P&amp;lay pairs</source>
        <translation>连续播放帧对(&amp;L)</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs a second</source>
        <translation>
            <numerusform>每秒 %n 个帧对</numerusform>
        </translation>
    </message>
    <message>
        <source>Shows pairs one after the other (L); the arrow sets how fast</source>
        <translation>逐个显示帧对（L）；箭头处设置速度</translation>
    </message>
    <message>
        <source>Play pairs</source>
        <translation>连续播放帧对</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Comment on pair %1:</source>
        <translation>帧对 %1 的备注：</translation>
    </message>
    <message>
        <source>Comment on %1 pairs:</source>
        <translation>%1 个帧对的备注：</translation>
    </message>
</context>
<context>
    <name>remount::gui::ProjectDocument</name>
    <message>
        <source>project saved</source>
        <translation>项目已保存</translation>
    </message>
    <message>
        <source>Wait until the present work is done, or cancel it, before opening a project.</source>
        <translation>请等当前工作完成，或取消它，再打开项目。</translation>
    </message>
    <message>
        <source>Wait until the present work is done, or cancel it, before beginning a project.</source>
        <translation>请等当前工作完成或将其取消，再新建项目。</translation>
    </message>
    <message>
        <source>another window could open it at the same time, no lock can be made: %1</source>
        <translation>另一个窗口可能同时打开它，无法创建锁：%1</translation>
    </message>
    <message>
        <source>holds a result that was made with other settings than it holds now: %1.
Calibrate again (F5).</source>
        <translation>其中的结果是用不同于现在的设置得到的：%1。
请重新标定 (F5)。</translation>
    </message>
    <message>
        <source>decisions before it was saved</source>
        <translation>保存之前的决定</translation>
    </message>
</context>
<context>
    <name>remount::gui::ProjectFeature</name>
    <message>
        <source>&amp;New project</source>
        <translation>新建项目(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Folder of a drive…</source>
        <translation>行驶数据文件夹(&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Log or bag file…</source>
        <translation>日志或 bag 文件(&amp;L)…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>&amp;Project…</source>
        <translation>项目(&amp;P)…</translation>
    </message>
    <message>
        <source>Ctrl+P</source>
        <translation>Ctrl+P</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近打开(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Save project</source>
        <translation>保存项目(&amp;S)</translation>
    </message>
    <message>
        <source>Save project &amp;as…</source>
        <translation>项目另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>The sample session is not installed. Install the package again, or open a recorded drive of yours (Ctrl+O).</source>
        <translation>示例数据未安装。请重新安装软件包，或打开您自己录制的数据（Ctrl+O）。</translation>
    </message>
    <message>
        <source>Open the folder of a recorded drive</source>
        <translation>打开一次行驶记录的文件夹</translation>
    </message>
    <message>
        <source>Open files of recorded drives</source>
        <translation>打开行驶记录的文件</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>打开项目</translation>
    </message>
    <message>
        <source>Remount projects (*%1)</source>
        <translation>Remount 项目 (*%1)</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>保存项目</translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation>尚未保存</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1（只读）</translation>
    </message>
    <message>
        <source>Remount</source>
        <translation>Remount 标定</translation>
    </message>
    <message>
        <source>the result of the calibration</source>
        <translation>标定结果</translation>
    </message>
    <message numerus="yes">
        <source>%n decision(s) about pairs</source>
        <translation>
            <numerusform>%n 个关于帧对的决定</numerusform>
        </translation>
    </message>
    <message>
        <source>Work is not saved</source>
        <translation>有未保存的工作</translation>
    </message>
    <message>
        <source>Save your changes to %1 first?</source>
        <translation>先将更改保存到 %1 吗？</translation>
    </message>
    <message>
        <source>Save your work as a project first?</source>
        <translation>先将工作保存为项目吗？</translation>
    </message>
    <message>
        <source>Save your work as a project first? Not saved: %1.</source>
        <translation>先将工作保存为项目吗？未保存：%1。</translation>
    </message>
</context>
<context>
    <name>remount::gui::ProjectKeeper</name>
    <message>
        <source>Never saved as a project</source>
        <translation>从未保存为项目</translation>
    </message>
    <message>
        <source>no sessions</source>
        <translation>没有数据</translation>
    </message>
    <message>
        <source>Sessions: %1</source>
        <translation>数据：%1</translation>
    </message>
    <message numerus="yes">
        <source>a calibration with %n pair(s)</source>
        <translation>
            <numerusform>含 %n 个帧对的标定</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n decision(s) of yours</source>
        <translation>
            <numerusform>您的 %n 个决定</numerusform>
        </translation>
    </message>
    <message>
        <source>saved %1 (%2)</source>
        <translation>保存于 %1（%2）</translation>
    </message>
    <message>
        <source>Where is %1 now?</source>
        <translation>%1 现在在哪里？</translation>
    </message>
    <message>
        <source>Nothing opened yet</source>
        <translation>还没有打开过</translation>
    </message>
    <message>
        <source>Forget these</source>
        <translation>忘记这些</translation>
    </message>
    <message>
        <source>Unsaved work cannot be kept safe automatically: %1
Save the project (Ctrl+S) where there is room.</source>
        <translation>无法自动保护未保存的工作：%1
请把项目保存到有空间的地方（Ctrl+S）。</translation>
    </message>
    <message>
        <source>The project&apos;s folder cannot be written: %1
Your work is kept safe in %2 instead. Bring the disk back, or save the project elsewhere (File, Save project as).</source>
        <translation>无法写入项目所在的文件夹：%1
您的工作改存于 %2。请重新连接磁盘，或把项目另存到别处（文件，项目另存为）。</translation>
    </message>
    <message>
        <source>was taken over by another window: %1.
Here it is read-only from now on. Save your work under another name (File, Save project as).</source>
        <translation>已被另一个窗口接管：%1。
从现在起此处为只读。请以其他名称保存您的工作（文件，项目另存为）。</translation>
    </message>
    <message>
        <source>The project is open in another window</source>
        <translation>项目已在另一个窗口中打开</translation>
    </message>
    <message>
        <source>%1 is open in another window:
%2.</source>
        <translation>%1 已在另一个窗口中打开：
%2。</translation>
    </message>
    <message>
        <source>Read-only shows the file as it was saved last; what you change is saved under another name. A copy is work of your own that has no file yet.</source>
        <translation>只读方式显示文件上次保存的内容；您的更改将以其他名称保存。副本是您自己的工作，尚无文件。</translation>
    </message>
    <message>
        <source>If that computer was switched off or lost its connection, take the project over: the window there can save it under another name only.</source>
        <translation>如果那台计算机已关机或失去连接，可接管该项目：那里的窗口之后只能以其他名称保存。</translation>
    </message>
    <message>
        <source>Open &amp;read-only</source>
        <translation>以只读方式打开(&amp;R)</translation>
    </message>
    <message>
        <source>Open a &amp;copy</source>
        <translation>打开副本(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Take over</source>
        <translation>接管(&amp;T)</translation>
    </message>
</context>
<context>
    <name>remount::gui::QualityController</name>
    <message>
        <source>start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>After a calibration the sharpness of the map is compared here.</source>
        <translation>标定之后，这里比较地图的清晰度。</translation>
    </message>
    <message>
        <source>Not compared: there is no result to use.</source>
        <translation>未比较：没有可用的结果。</translation>
    </message>
    <message>
        <source>Not compared: the map check is switched off in the options (run).</source>
        <translation>未比较：选项（运行）中关闭了地图检查。</translation>
    </message>
    <message>
        <source>Not compared: no stretch of eight scans that follow each other turns and overlaps.</source>
        <translation>未比较：没有转弯且相互重叠的连续八帧扫描。</translation>
    </message>
    <message>
        <source>After a calibration of two or more sessions they are compared here.</source>
        <translation>标定两份或更多数据之后，在此互相检验。</translation>
    </message>
    <message>
        <source>Solving every session alone…</source>
        <translation>正在单独求解每份数据…</translation>
    </message>
    <message>
        <source>After a calibration the vehicle is shown here among the points of a scan.</source>
        <translation>标定之后，这里在一帧扫描的点中显示车辆。</translation>
    </message>
    <message>
        <source>There is no result under which to look at obstacles.</source>
        <translation>没有可用来查看障碍物的结果。</translation>
    </message>
    <message>
        <source>No scan of this session was used.</source>
        <translation>这份数据没有扫描被使用。</translation>
    </message>
    <message>
        <source>This session has no points: it may hold LiDAR poses instead of scans.</source>
        <translation>这份数据没有点：它可能只有激光雷达位姿而没有扫描。</translation>
    </message>
    <message>
        <source>Reading the scan…</source>
        <translation>正在读取扫描…</translation>
    </message>
    <message>
        <source>The scan is shown when the new solution is complete.</source>
        <translation>新的解完成后将显示扫描。</translation>
    </message>
    <message>
        <source>Not compared: the sessions hold no scans, or the method has no keyframes.</source>
        <translation>未比较：数据中没有扫描，或该方法没有关键帧。</translation>
    </message>
    <message>
        <source>Not compared: the calibration was cancelled before. Calibrate again (F5).</source>
        <translation>未比较：标定在此之前已取消。请重新标定（F5）。</translation>
    </message>
    <message>
        <source>The method has no pairs: compare its result with those of others instead.</source>
        <translation>该方法没有帧对：请改为与其他方法的结果比较。</translation>
    </message>
    <message>
        <source>The result has moved: the map is being compared again…</source>
        <translation>结果已变动：正在重新比较地图…</translation>
    </message>
    <message>
        <source>Not compared since the last decision, which moved the result. Calibrate again (F5).</source>
        <translation>上一次决定使结果变动，此后没有再比较。请重新标定 (F5)。</translation>
    </message>
    <message>
        <source>Needs a second session: the mounting X is solved on one and scored on the other.</source>
        <translation>需要第二份数据：在一份上求解安装 X，在另一份上评分。</translation>
    </message>
    <message>
        <source>The map is being compared…</source>
        <translation>正在比较地图……</translation>
    </message>
    <message>
        <source>Not compared: %1</source>
        <translation>未比较：%1</translation>
    </message>
    <message>
        <source>The map is compared when the result is solved.</source>
        <translation>求解完成后比较地图。</translation>
    </message>
</context>
<context>
    <name>remount::gui::QualityFeature</name>
    <message>
        <source>Quality</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Check &amp;quality</source>
        <translation>检查质量(&amp;Q)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
</context>
<context>
    <name>remount::gui::ReportMaker</name>
    <message>
        <source>Report: picture of pair %1…</source>
        <translation>报告：帧对 %1 的图片…</translation>
    </message>
    <message>
        <source>Report: writing pages…</source>
        <translation>报告：正在写页面…</translation>
    </message>
    <message>
        <source>Calibration of a LiDAR</source>
        <translation>激光雷达标定</translation>
    </message>
    <message>
        <source>Pair %1, from above, under the result. Residual %2 cm, %3°, RMSE %4 cm.</source>
        <translation>帧对 %1，俯视，按结果。残差 %2 cm、%3°，RMSE %4 cm。</translation>
    </message>
    <message>
        <source>Pair %1, from above, under the nominal mounting.</source>
        <translation>帧对 %1，俯视，按名义安装。</translation>
    </message>
    <message>
        <source>Pair %1, from above, under the mounting that the calibration started from; no nominal was given.</source>
        <translation>帧对 %1，俯视，按标定起始时的安装；没有给出名义安装。</translation>
    </message>
    <message>
        <source>The report is written as soon as the map is compared.</source>
        <translation>地图比较完成后即写出报告。</translation>
    </message>
    <message>
        <source>The report is not written: the result changed while it waited for the comparison of the map. Ask for it again.</source>
        <translation>未写出报告：等待地图比较期间结果已改变。请重新生成。</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>打开报告</translation>
    </message>
</context>
<context>
    <name>remount::gui::ResidualsFeature</name>
    <message>
        <source>Residuals</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Residuals p&amp;lot</source>
        <translation>残差图(&amp;L)</translation>
    </message>
</context>
<context>
    <name>remount::gui::ResultFeature</name>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>&amp;Export result…</source>
        <translation>导出结果(&amp;E)…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Make &amp;report…</source>
        <translation>生成报告(&amp;R)…</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>&amp;Copy result</source>
        <translation>复制结果(&amp;C)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Use the result as &amp;nominal mounting</source>
        <translation>把结果用作名义安装(&amp;N)</translation>
    </message>
    <message>
        <source>report saved, and as %1</source>
        <translation>报告已保存，同时保存为 %1</translation>
    </message>
    <message>
        <source>There is no result to export yet. Open a session (Ctrl+O) and calibrate (F5).</source>
        <translation>还没有可导出的结果。请打开数据（Ctrl+O）并标定（F5）。</translation>
    </message>
    <message>
        <source>Cannot be written in this format: %1</source>
        <translation>无法写成此格式：%1</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>A report is being written already. Wait until the status line says that it is saved.</source>
        <translation>正在写一份报告。请等到状态栏显示已保存。</translation>
    </message>
    <message>
        <source>report.html</source>
        <translation>报告.html</translation>
    </message>
    <message>
        <source>Save the report (HTML, and PDF beside it)</source>
        <translation>保存报告（HTML，PDF 存在旁边）</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
    <message>
        <source>Nominal mounting</source>
        <translation>名义安装</translation>
    </message>
</context>
<context>
    <name>remount::gui::RunFeature</name>
    <message>
        <source>&amp;Calibrate</source>
        <translation>标定(&amp;C)</translation>
    </message>
    <message>
        <source>F5</source>
        <translation>F5</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>取消(&amp;A)</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Opening sessions…</source>
        <translation>正在打开数据…</translation>
    </message>
    <message>
        <source>Calibrating…</source>
        <translation>正在标定…</translation>
    </message>
</context>
<context>
    <name>remount::gui::SceneController</name>
    <message>
        <source>candidate %1</source>
        <translation>候选 %1</translation>
    </message>
</context>
<context>
    <name>remount::gui::SectionFeature</name>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>配准后</translation>
    </message>
    <message>
        <source>With result</source>
        <translation>按结果</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>剖面</translation>
    </message>
    <message>
        <source>Select a pair to see a section through its two scans.</source>
        <translation>选择一个帧对，查看穿过其两次扫描的剖面。</translation>
    </message>
    <message>
        <source>The pair comes from LiDAR poses: there are no scans.</source>
        <translation>该帧对来自激光雷达位姿：没有扫描。</translation>
    </message>
    <message>
        <source>Both scans together show no such surface clearly enough.</source>
        <translation>两次扫描都没有足够清楚地看到这样的表面。</translation>
    </message>
</context>
<context>
    <name>remount::gui::SessionEdits</name>
    <message>
        <source>Wait until the present work is done, or cancel it, before choosing other topics.</source>
        <translation>请等待当前工作完成，或先取消，再选择其他话题。</translation>
    </message>
    <message>
        <source>opened with other topics. Its result belonged to the former ones: calibrate (F5), or undo (Ctrl+Z) to have it back.</source>
        <translation>已用其他话题打开。原结果属于先前的话题：请重新标定（F5），或撤销（Ctrl+Z）以恢复。</translation>
    </message>
    <message>
        <source>opened with other topics</source>
        <translation>已用其他话题打开</translation>
    </message>
    <message>
        <source>is being calibrated. Cancel that (Esc) before removing it.</source>
        <translation>正在标定。请先取消（Esc）再移除。</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>已移除</translation>
    </message>
    <message>
        <source>removed. The result was made without it and stays.</source>
        <translation>已移除。结果并未使用它，予以保留。</translation>
    </message>
    <message>
        <source>removed. No pair of it was accepted: the result stays.</source>
        <translation>已移除。它没有被接受的帧对：结果保留。</translation>
    </message>
    <message>
        <source>removed. The result belonged to the sessions before: calibrate (F5), or undo (Ctrl+Z) to have it back.</source>
        <translation>已移除。结果属于此前的数据：请标定 (F5)，或撤销 (Ctrl+Z) 以恢复它。</translation>
    </message>
</context>
<context>
    <name>remount::gui::SessionList</name>
    <message>
        <source>Wait until the present work is done, or cancel it, before opening sessions.</source>
        <translation>请等当前工作完成，或取消它，再打开数据。</translation>
    </message>
    <message>
        <source>is the same recording as %1, which is open: its pairs would count as evidence twice. It was not opened.</source>
        <translation>与已打开的 %1 是同一次记录：其帧对会被当作两份依据。未打开。</translation>
    </message>
    <message>
        <source>is open already</source>
        <translation>已经打开</translation>
    </message>
    <message>
        <source>%1 paths could not be opened (more in the log)</source>
        <translation>有 %1 个路径无法打开（详见日志）</translation>
    </message>
    <message>
        <source>opened as %1</source>
        <translation>按 %1 格式打开</translation>
    </message>
    <message>
        <source>its nominal mounting is used</source>
        <translation>使用其中的名义安装</translation>
    </message>
</context>
<context>
    <name>remount::gui::Setup</name>
    <message>
        <source>change %1</source>
        <translation>更改 %1</translation>
    </message>
    <message>
        <source>reset the search range</source>
        <translation>重置搜索范围</translation>
    </message>
    <message>
        <source>restore default options</source>
        <translation>恢复默认选项</translation>
    </message>
    <message>
        <source>change the nominal mounting</source>
        <translation>更改名义安装</translation>
    </message>
</context>
<context>
    <name>remount::gui::SetupFeature</name>
    <message>
        <source>Set-up</source>
        <translation>设置区</translation>
    </message>
    <message>
        <source>&amp;Options…</source>
        <translation>选项(&amp;O)…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Nominal mounting (LiDAR in the INS frame)</source>
        <translation>名义安装（激光雷达在 INS 坐标系中）</translation>
    </message>
    <message>
        <source>Search range</source>
        <translation>搜索范围</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>方法(&amp;M)</translation>
    </message>
    <message>
        <source>Calibrate (F5)</source>
        <translation>标定 (F5)</translation>
    </message>
    <message>
        <source>Calibrating…</source>
        <translation>正在标定…</translation>
    </message>
    <message>
        <source>Calibrate again (F5)</source>
        <translation>重新标定 (F5)</translation>
    </message>
    <message>
        <source>Nominal mounting from a result or an exported file</source>
        <translation>从结果或导出文件读取名义安装</translation>
    </message>
    <message>
        <source>Restore default options</source>
        <translation>恢复默认选项</translation>
    </message>
    <message>
        <source>Set every option back to its default, the search range as well?</source>
        <translation>将所有选项（包括搜索范围）恢复为默认值？</translation>
    </message>
    <message>
        <source>Defaults that are changed: %1.</source>
        <translation>已更改的默认值：%1。</translation>
    </message>
    <message>
        <source>Restore defaults</source>
        <translation>恢复默认值</translation>
    </message>
</context>
<context>
    <name>remount::gui::TopicController</name>
    <message>
        <source>was not opened</source>
        <translation>未打开</translation>
    </message>
</context>
<context>
    <name>remount::gui::Vehicle</name>
    <message>
        <source>saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>%1 LiDARs are in these recordings. They can be calibrated together: see LiDARs.</source>
        <translation>这些记录中有 %1 台激光雷达，可以联合标定：见“激光雷达”面板。</translation>
    </message>
    <message>
        <source>LiDARs</source>
        <translation>激光雷达</translation>
    </message>
    <message>
        <source>Tick two LiDARs or more: one is calibrated by F5.</source>
        <translation>请勾选两台或更多激光雷达：只标定一台请按 F5。</translation>
    </message>
    <message>
        <source>calibration of all LiDARs</source>
        <translation>全部激光雷达的标定</translation>
    </message>
    <message>
        <source>common solution of all LiDARs</source>
        <translation>全部激光雷达的联合求解</translation>
    </message>
    <message>
        <source>Calibration of %1 LiDARs started</source>
        <translation>开始标定 %1 台激光雷达</translation>
    </message>
    <message>
        <source>%1 of %2 LiDARs were solved together.</source>
        <translation>%2 台激光雷达中有 %1 台参与联合求解。</translation>
    </message>
    <message>
        <source>Wait until the present work is done, or cancel it, before showing another LiDAR.</source>
        <translation>请等待当前工作完成或将其取消，再显示另一台激光雷达。</translation>
    </message>
    <message>
        <source>show LiDAR %1</source>
        <translation>显示激光雷达 %1</translation>
    </message>
    <message>
        <source>The sessions that are open are of different LiDARs, which no calibration of one may mix. Double click one of them in LiDARs.</source>
        <translation>已打开的数据属于不同的激光雷达，单台标定不可混用。请在“激光雷达”面板中双击其中一台。</translation>
    </message>
    <message>
        <source>has no whole solution with these recordings and this nominal mounting that could be solved again. Calibrate all LiDARs again.</source>
        <translation>没有可用这些记录和当前名义安装位姿重新求解的完整解。请重新标定全部激光雷达。</translation>
    </message>
    <message>
        <source>Common solution of %1 LiDARs started</source>
        <translation>开始联合求解 %1 台激光雷达</translation>
    </message>
    <message>
        <source>The calibration was of other sessions than there are now: it is left out.</source>
        <translation>该标定针对的数据与现在的不同：不予采用。</translation>
    </message>
    <message>
        <source>Cancelled. The results that were there are kept.</source>
        <translation>已取消。保留原有结果。</translation>
    </message>
    <message>
        <source>Nominal mountings</source>
        <translation>名义安装</translation>
    </message>
    <message>
        <source>Wait until the present work is done, or cancel it, before giving others.</source>
        <translation>请等待当前工作完成或将其取消，再给出其他值。</translation>
    </message>
    <message>
        <source>%1 LiDARs have theirs from the file, by their names.</source>
        <translation>已按名称从文件中取得 %1 台激光雷达的名义安装。</translation>
    </message>
    <message>
        <source>nominal mountings of all LiDARs</source>
        <translation>全部激光雷达的名义安装</translation>
    </message>
    <message>
        <source>report of all LiDARs saved</source>
        <translation>已保存全部激光雷达的报告</translation>
    </message>
</context>
<context>
    <name>remount::gui::VehicleFeature</name>
    <message>
        <source>LiDARs</source>
        <translation>激光雷达</translation>
    </message>
    <message>
        <source>Calibrate all ticked &amp;LiDARs</source>
        <translation>标定所选激光雷达(&amp;L)</translation>
    </message>
    <message>
        <source>Shift+F5</source>
        <translation>Shift+F5</translation>
    </message>
    <message>
        <source>&amp;Solve all LiDARs together again</source>
        <translation>重新联合求解全部激光雷达(&amp;S)</translation>
    </message>
    <message>
        <source>Export all L&amp;iDARs…</source>
        <translation>导出全部激光雷达(&amp;I)…</translation>
    </message>
    <message>
        <source>Save results of all LiDARs…</source>
        <translation>保存全部激光雷达的结果…</translation>
    </message>
    <message>
        <source>All LiDARs</source>
        <translation>全部激光雷达</translation>
    </message>
    <message>
        <source>The map of all &amp;LiDARs</source>
        <translation>全部激光雷达的地图(&amp;L)</translation>
    </message>
    <message>
        <source>Pair across: scan of %1 (a) and of %2 (b), %3 s apart</source>
        <translation>跨激光雷达帧对：%1 的扫描（a）与 %2 的扫描（b），相隔 %3 s</translation>
    </message>
    <message>
        <source>Reading the scans of the pair across LiDARs…</source>
        <translation>正在读取跨激光雷达帧对的扫描…</translation>
    </message>
    <message>
        <source>Save the results of all LiDARs</source>
        <translation>保存全部激光雷达的结果</translation>
    </message>
    <message>
        <source>vehicle.yaml</source>
        <translation>vehicle.yaml</translation>
    </message>
    <message>
        <source>Results (*.yaml *.json)</source>
        <translation>结果 (*.yaml *.json)</translation>
    </message>
    <message>
        <source>results of all LiDARs saved</source>
        <translation>已保存全部激光雷达的结果</translation>
    </message>
    <message>
        <source>Saving the results of all LiDARs…</source>
        <translation>正在保存全部激光雷达的结果…</translation>
    </message>
    <message>
        <source>Make report of all LiDARs…</source>
        <translation>生成全部激光雷达的报告…</translation>
    </message>
    <message>
        <source>Save the report of all LiDARs</source>
        <translation>保存全部激光雷达的报告</translation>
    </message>
    <message>
        <source>vehicle.html</source>
        <translation>vehicle.html</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
</context>
<context>
    <name>remount::gui::VehicleMapController</name>
    <message>
        <source>The scans of all LiDARs are shown here, each in its colour, once they are calibrated together.</source>
        <translation>联合标定之后，此处显示全部激光雷达的扫描，每台一种颜色。</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>名义</translation>
    </message>
    <message>
        <source>Each alone</source>
        <translation>各自单独</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>已取消。</translation>
    </message>
    <message>
        <source>No LiDAR has scans of this recording to put together under this mounting.</source>
        <translation>没有激光雷达在此记录中有可在该安装位姿下拼接的扫描。</translation>
    </message>
    <message>
        <source>%1 scans cannot be read.</source>
        <translation>有 %1 帧扫描无法读取。</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起始</translation>
    </message>
</context>
<context>
    <name>remount::gui::WindowHost</name>
    <message>
        <source>The language changes as soon as the report is written.</source>
        <translation>报告写完后即切换语言。</translation>
    </message>
</context>
<context>
    <name>remount::gui::ask_to_replace</name>
    <message>
        <source>Replace files</source>
        <translation>替换文件</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) exist already. Replace?</source>
        <translation>
            <numerusform>%n 个文件已存在，是否替换？</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>remount::gui::edit_commands</name>
    <message>
        <source>undo: %1</source>
        <translation>撤销：%1</translation>
    </message>
    <message>
        <source>other topics of %1</source>
        <translation>更改 %1 的话题</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>open %1</source>
        <translation>打开 %1</translation>
    </message>
    <message>
        <source>open %1 sessions</source>
        <translation>打开 %1 份数据</translation>
    </message>
</context>
<context>
    <name>remount::gui::error_words</name>
    <message>
        <source>Is the disk connected, is there room on it, and may you read and write there?</source>
        <translation>磁盘是否已连接、是否有空间、您是否有读写权限？</translation>
    </message>
    <message>
        <source>Was the recording cut off, or the file edited? Copy it from its source again, or leave it out.</source>
        <translation>记录是否中断过，文件是否被改动过？请从来源重新复制，或不使用它。</translation>
    </message>
    <message>
        <source>F1 in the empty window lists what can be opened.</source>
        <translation>在空窗口中按 F1 可查看能打开的内容。</translation>
    </message>
</context>
<context>
    <name>remount::gui::project_files</name>
    <message>
        <source>%1
The project is opened without this session and without its pairs. Its file is left as it is: saving asks for another name.</source>
        <translation>%1
项目在没有此数据及其帧对的情况下打开。文件保持不变：保存时会询问另一个名称。</translation>
    </message>
</context>
<context>
    <name>remount::gui::recovery</name>
    <message>
        <source>less than a minute ago</source>
        <translation>不到一分钟前</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>%n 分钟前</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>%n 小时前</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>remount::gui::steps</name>
    <message>
        <source>all six observed</source>
        <translation>六个全部可观测</translation>
    </message>
    <message>
        <source>solved in part</source>
        <translation>部分求解</translation>
    </message>
    <message>
        <source>too few pairs</source>
        <translation>帧对太少</translation>
    </message>
    <message>
        <source>too little data</source>
        <translation>数据太少</translation>
    </message>
    <message>
        <source>nothing to use</source>
        <translation>没有可用数据</translation>
    </message>
    <message>
        <source>did not converge</source>
        <translation>没有收敛</translation>
    </message>
    <message>
        <source>outside the range</source>
        <translation>在范围之外</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>opening…</source>
        <translation>正在打开…</translation>
    </message>
    <message>
        <source>open a session</source>
        <translation>打开数据</translation>
    </message>
    <message>
        <source>1 session</source>
        <translation>1 份数据</translation>
    </message>
    <message>
        <source>%1 sessions</source>
        <translation>%1 份数据</translation>
    </message>
    <message>
        <source>calibrating…</source>
        <translation>正在标定…</translation>
    </message>
    <message>
        <source>calibrate (F5)</source>
        <translation>标定 (F5)</translation>
    </message>
    <message>
        <source>changed: F5 again</source>
        <translation>有更改：再按 F5</translation>
    </message>
    <message>
        <source>%1 of %2 aligned</source>
        <translation>%2 个中 %1 个已配准</translation>
    </message>
    <message>
        <source>%1 accepted, %2 rejected</source>
        <translation>%1 个接受，%2 个拒绝</translation>
    </message>
    <message>
        <source>solving again…</source>
        <translation>正在重新求解…</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>已过期</translation>
    </message>
    <message>
        <source>exported</source>
        <translation>已导出</translation>
    </message>
    <message>
        <source>ready (Ctrl+E)</source>
        <translation>就绪 (Ctrl+E)</translation>
    </message>
    <message>
        <source>map less sharp</source>
        <translation>地图变模糊</translation>
    </message>
    <message>
        <source>sessions contradict</source>
        <translation>数据互相矛盾</translation>
    </message>
    <message>
        <source>not needed</source>
        <translation>不需要</translation>
    </message>
    <message>
        <source>confirmed by you</source>
        <translation>您已确认</translation>
    </message>
    <message>
        <source>confirm in Quality</source>
        <translation>请在“质量”中确认</translation>
    </message>
    <message>
        <source>copied, in no file</source>
        <translation>已复制，未存文件</translation>
    </message>
    <message>
        <source>nothing observed</source>
        <translation>均不可观测</translation>
    </message>
    <message>
        <source>comparing the map…</source>
        <translation>正在比较地图…</translation>
    </message>
    <message>
        <source>%1 of %2 sessions unused</source>
        <translation>%2 份数据中 %1 份未用</translation>
    </message>
    <message>
        <source>preliminary: F5</source>
        <translation>初步：F5</translation>
    </message>
    <message>
        <source>after the solution</source>
        <translation>求解之后</translation>
    </message>
    <message>
        <source>preliminary</source>
        <translation>初步结果</translation>
    </message>
    <message>
        <source>all six known</source>
        <translation>六个参数全部已知</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs</source>
        <translation>
            <numerusform>%n 个帧对</numerusform>
        </translation>
    </message>
    <message>
        <source>contradictory data</source>
        <translation>数据互相矛盾</translation>
    </message>
    <message>
        <source>LiDARs contradict</source>
        <translation>激光雷达互相矛盾</translation>
    </message>
    <message>
        <source>drives contradict</source>
        <translation>行驶互相矛盾</translation>
    </message>
</context>
<context>
    <name>remount::gui::wording</name>
    <message>
        <source>and %1 more</source>
        <translation>以及另外 %1 个</translation>
    </message>
    <message>
        <source>Solving again…</source>
        <translation>正在重新求解…</translation>
    </message>
    <message>
        <source>The result is out of date: calibrate again (F5)</source>
        <translation>结果已过期：请重新标定 (F5)</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>The sessions are being opened.</source>
        <translation>正在打开数据。</translation>
    </message>
    <message>
        <source>The calibration is running.</source>
        <translation>标定正在进行。</translation>
    </message>
    <message>
        <source>Open the sessions of a vehicle first.</source>
        <translation>请先打开一辆车的数据。</translation>
    </message>
    <message>
        <source>Calibrate (F5).</source>
        <translation>标定 (F5)。</translation>
    </message>
    <message>
        <source>Opening sessions…</source>
        <translation>正在打开数据…</translation>
    </message>
    <message>
        <source>Say on the left roughly where the LiDAR sits, or leave it unknown.
Then calibrate: F5.</source>
        <translation>请在左侧说出激光雷达大致装在哪里，或留作未知。
然后标定：F5。</translation>
    </message>
    <message>
        <source>Calibrating; this is the result before.</source>
        <translation>正在标定；这是之前的结果。</translation>
    </message>
    <message>
        <source>This result was made with other settings or files: %1. Calibrate again (F5).</source>
        <translation>此结果是用其他设置或文件得到的：%1。请重新标定 (F5)。</translation>
    </message>
    <message>
        <source>Not observed: %1. What a file holds for these is not measured: for a translation the nominal value or 0, for a rotation the best guess.</source>
        <translation>不可观测：%1。文件中这些值不是测量所得：平移为名义值或 0，旋转为最佳猜测。</translation>
    </message>
    <message>
        <source>No nominal mounting was given: &quot;start&quot; is the program&apos;s own first estimate, not where the LiDAR was before.</source>
        <translation>没有给出名义安装：“起始”是程序自己的初始估计，并不是激光雷达原来的位置。</translation>
    </message>
    <message>
        <source>Not observed: %1. Distances and heights rest on values there that nobody measured.</source>
        <translation>不可观测：%1。距离和高度在这些方向上依据的不是测量值。</translation>
    </message>
    <message>
        <source>pose %1</source>
        <translation>位姿 %1</translation>
    </message>
    <message>
        <source>it does not say whose</source>
        <translation>未注明使用者</translation>
    </message>
    <message>
        <source>%1 on %2 (process %3), since %4</source>
        <translation>%2 上的 %1（进程 %3），自 %4 起</translation>
    </message>
    <message>
        <source>The mounting is solved again; its sigmas, the candidates and the judgement of other pairs follow…</source>
        <translation>正在重新求解安装；其 sigma、候选和对其他帧对的判断随后给出…</translation>
    </message>
    <message>
        <source>Calibrating: choosing scans, aligning pairs, solving.
Pairs and result appear together when all of it is done. Esc stops, and keeps the pairs that are aligned by then.</source>
        <translation>正在标定：选取扫描、配准帧对、求解。
全部完成后帧对和结果一起出现。按 Esc 停止，保留届时已配准的帧对。</translation>
    </message>
    <message>
        <source>Calibrating.
The result appears when all of it is done. Esc stops.</source>
        <translation>正在标定。
全部完成后出现结果。按 Esc 停止。</translation>
    </message>
    <message>
        <source>The mounting is solved again; its sigmas, the candidates and the judgement of other pairs follow.</source>
        <translation>正在重新求解安装；其 sigma、候选和对其他帧对的判断随后给出。</translation>
    </message>
    <message>
        <source>This method works without pairs. What it found is on the page Method (Ctrl+Shift+D).</source>
        <translation>该方法不使用帧对。其结果在“方法”页（Ctrl+Shift+D）。</translation>
    </message>
    <message>
        <source>Select a pair to see its two scans.</source>
        <translation>选择一个帧对以查看其两帧扫描。</translation>
    </message>
    <message>
        <source>The map is still being compared under this result: what it says is not known yet.</source>
        <translation>正在比较该结果下的地图：其结论尚不可知。</translation>
    </message>
</context>
<context>
    <name>remount::widgets::CandidatePlot</name>
    <message>
        <source>Candidates: x, y, z</source>
        <translation>候选：x、y、z</translation>
    </message>
    <message>
        <source>Candidates: yaw, pitch, roll</source>
        <translation>候选：偏航、俯仰、横滚</translation>
    </message>
    <message>
        <source>Left and right arrow keys select the candidate before or after in rank.</source>
        <translation>左右方向键选择名次在前或在后的候选。</translation>
    </message>
    <message>
        <source>Candidates appear here: x, y, z.</source>
        <translation>候选显示在这里：x、y、z。</translation>
    </message>
    <message>
        <source>Candidates appear here: yaw, pitch, roll.</source>
        <translation>候选显示在这里：偏航、俯仰、横滚。</translation>
    </message>
    <message>
        <source>%1 over %2 [%3]</source>
        <extracomment>axes of a plot: the vertical one over the horizontal one, and their unit</extracomment>
        <translation>%1 对 %2 [%3]</translation>
    </message>
</context>
<context>
    <name>remount::widgets::CandidateTableModel</name>
    <message>
        <source>✓ %1 (the result)</source>
        <translation>✓ %1（结果）</translation>
    </message>
    <message>
        <source>in range</source>
        <translation>在范围内</translation>
    </message>
    <message>
        <source>out of range: %1</source>
        <translation>超出范围：%1</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>名次</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>x [m]</source>
        <translation>x [m]</translation>
    </message>
    <message>
        <source>y [m]</source>
        <translation>y [m]</translation>
    </message>
    <message>
        <source>z [m]</source>
        <translation>z [m]</translation>
    </message>
    <message>
        <source>yaw [°]</source>
        <translation>偏航 [°]</translation>
    </message>
    <message>
        <source>pitch [°]</source>
        <translation>俯仰 [°]</translation>
    </message>
    <message>
        <source>roll [°]</source>
        <translation>横滚 [°]</translation>
    </message>
    <message>
        <source>Search range</source>
        <translation>搜索范围</translation>
    </message>
    <message>
        <source>This is the result. It weighs every pair by its noise; another candidate may have a smaller error sum, which counts all pairs alike.</source>
        <translation>这就是结果。它按噪声给每个帧对加权；别的候选的误差总和可能更小，因为总和对所有帧对一视同仁。</translation>
    </message>
    <message>
        <source>Error sum</source>
        <translation>误差总和</translation>
    </message>
    <message>
        <source>How far the accepted pairs are from this mounting X, all together. E(X): sum of ‖P X − X Q‖ (Frobenius norm, translation over the characteristic length)</source>
        <translation>所有已接受的帧对合起来与此安装 X 相差多少。E(X)：‖P X − X Q‖ 之和（Frobenius 范数，平移除以特征长度）</translation>
    </message>
</context>
<context>
    <name>remount::widgets::CandidatesPanel</name>
    <message>
        <source>Candidates</source>
        <translation>候选</translation>
    </message>
    <message>
        <source>● in range  ○ out of it  ✚ nominal  ◯ result  ▭ range</source>
        <translation>● 在范围内  ○ 超出  ✚ 名义值  ◯ 结果  ▭ 范围</translation>
    </message>
    <message>
        <source>The result has rank %1: ranks count every pair alike, the result weighs each pair by its noise.</source>
        <translation>结果排第 %1：名次对每个帧对一视同仁，结果则按噪声给每个帧对加权。</translation>
    </message>
</context>
<context>
    <name>remount::widgets::CheckList</name>
    <message>
        <source>Checks against the data</source>
        <translation>与数据的核对</translation>
    </message>
    <message>
        <source>Add %1 s</source>
        <translation>加上 %1 s</translation>
    </message>
    <message>
        <source>Adds it to the times of the table, as under Time above</source>
        <translation>加到表中的时间上，同上方“时间”一栏</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ClearancePlot</name>
    <message>
        <source>The scan around the vehicle, seen from above</source>
        <translation>车辆周围的扫描（俯视）</translation>
    </message>
    <message>
        <source>Plus and minus zoom, Home shows what is near.</source>
        <translation>加号和减号缩放，Home 显示近处。</translation>
    </message>
    <message>
        <source>Seen from above, forward is right; metres from the INS. The wheel zooms, Home shows what is near.</source>
        <translation>俯视，前方朝右；以 INS 为原点，单位米。滚轮缩放，Home 显示近处。</translation>
    </message>
    <message>
        <source>● with the result</source>
        <translation>● 按结果</translation>
    </message>
    <message>
        <source>x forward → [m]</source>
        <translation>x 前向 → [m]</translation>
    </message>
    <message>
        <source>No points within the heights.</source>
        <translation>该高度范围内没有点。</translation>
    </message>
    <message>
        <source>The lowest height lies above the highest: no point counts.</source>
        <translation>最低高度高于最高高度：没有点计入。</translation>
    </message>
    <message>
        <source>y left ↑ [m]</source>
        <translation>y 向左 ↑ [m]</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ClearanceView</name>
    <message>
        <source>Nothing is there within the heights.</source>
        <translation>该高度范围内那里没有点。</translation>
    </message>
    <message>
        <source>There is no point under one of the two.</source>
        <translation>两者之一没有点。</translation>
    </message>
    <message>
        <source>Distance of the nearest point on each side of the vehicle, metres</source>
        <translation>车辆各侧最近点的距离，单位米</translation>
    </message>
    <message>
        <source>From the outline to the nearest point straight ahead, behind, left and right, in metres; nearest: in any direction. Points inside the outline are the vehicle.</source>
        <translation>从车辆轮廓到正前、正后、左、右最近点的距离，单位米；最近：任意方向。轮廓内的点属于车辆自身。</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Session of the scan</source>
        <translation>扫描所属的数据</translation>
    </message>
    <message>
        <source>Number of the scan</source>
        <translation>扫描编号</translation>
    </message>
    <message>
        <source>Which of the scans that the calibration used</source>
        <translation>标定所用扫描中的哪一帧</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>From the INS to the front end of the vehicle, m</source>
        <translation>从 INS 到车头，单位米</translation>
    </message>
    <message>
        <source>Rear</source>
        <translation>后</translation>
    </message>
    <message>
        <source>From the INS to the rear end of the vehicle, m</source>
        <translation>从 INS 到车尾，单位米</translation>
    </message>
    <message>
        <source>Half width</source>
        <translation>半宽</translation>
    </message>
    <message>
        <source>From the INS to either side of the vehicle, m</source>
        <translation>从 INS 到车辆任一侧，单位米</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>最低</translation>
    </message>
    <message>
        <source>Lower points are the ground: height against the INS, m</source>
        <translation>更低的点是地面：相对 INS 的高度，单位米</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>最高</translation>
    </message>
    <message>
        <source>Higher points are bridges and branches: height against the INS, m</source>
        <translation>更高的点是桥梁和树枝：相对 INS 的高度，单位米</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> / %1</translation>
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
        <source>Nearest</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>Free [m]</source>
        <translation>净距 [m]</translation>
    </message>
    <message>
        <source>With result</source>
        <translation>按结果</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>名义</translation>
    </message>
    <message>
        <source>start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>名义</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>–: no point of the scan lies on that side within the heights. Nothing was seen there, which is less than knowing that it is free.</source>
        <translation>–：这一侧在高度范围内没有扫描点。那里什么都没看到，这不等于知道那里是空的。</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ColumnTable</name>
    <message>
        <source>Columns of the table</source>
        <translation>表格的列</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>第 %1 列</translation>
    </message>
    <message>
        <source>What column %1 is</source>
        <translation>列 %1 的含义</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ComparisonView</name>
    <message>
        <source>not observed</source>
        <translation>不可观测</translation>
    </message>
    <message>
        <source>± 1 sigma</source>
        <translation>± 1 倍标准差</translation>
    </message>
    <message>
        <source>Method: %1</source>
        <translation>方法：%1</translation>
    </message>
    <message>
        <source>Whether the results agree</source>
        <translation>各结果是否一致</translation>
    </message>
    <message>
        <source>Results side by side</source>
        <translation>结果并列</translation>
    </message>
    <message>
        <source>Every two results</source>
        <translation>结果两两比较</translation>
    </message>
    <message>
        <source>Leave files out</source>
        <translation>移除文件</translation>
    </message>
    <message>
        <source>Add result files…</source>
        <translation>添加结果文件…</translation>
    </message>
    <message>
        <source>Results of other methods or drives of the same vehicle, as the command line or the export writes them</source>
        <translation>同一车辆用其他方法或其他行驶得到的结果，由命令行或导出写成</translation>
    </message>
    <message>
        <source>Calibrate with another method, or add result files: they are set against each other here, with a warning where they differ by more than they claim.</source>
        <translation>请用另一种方法标定，或添加结果文件：它们在这里相互对照，差别超出各自标称精度时给出警告。</translation>
    </message>
    <message>
        <source>Results differ by more than they claim: do not use them before you know why.</source>
        <translation>结果之间的差别超出各自的标称精度：查明原因之前不要使用。</translation>
    </message>
    <message>
        <source>The results agree within what they claim.</source>
        <translation>各结果在标称精度内一致。</translation>
    </message>
    <message>
        <source>The results have nothing in common that could be compared.</source>
        <translation>各结果没有可以比较的共同分量。</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>In words</source>
        <translation>文字说明</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ContactSheet</name>
    <message>
        <source>Pictures of all pairs</source>
        <translation>所有帧对的小图</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>配准后</translation>
    </message>
    <message>
        <source>With result</source>
        <translation>按结果</translation>
    </message>
    <message>
        <source>Alignment in the pictures</source>
        <translation>小图中的对齐方式</translation>
    </message>
    <message>
        <source>As the scans were aligned with each other, or as INS and the present result put them</source>
        <translation>按两次扫描的配准，或按 INS 与当前结果放置</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ConventionForm</name>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Attitude</source>
        <translation>姿态</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>弧度</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>单位(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Clock</source>
        <translation>时钟(&amp;C)</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>U&amp;nit</source>
        <translation>单位(&amp;N)</translation>
    </message>
    <message>
        <source>Of latitude and longitude. East, north, x, y, z and heights are metres.</source>
        <translation>纬度和经度的单位。东、北、x、y、z 和高度均为米。</translation>
    </message>
    <message>
        <source>Un&amp;it</source>
        <translation>单位(&amp;I)</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>航向</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>俯仰</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>横滚</translation>
    </message>
    <message>
        <source>The table counts this angle the other way than the convention above does</source>
        <translation>表中该角度的正负与上述约定相反</translation>
    </message>
    <message>
        <source>%1 counts the other way</source>
        <translation>%1 反向计</translation>
    </message>
    <message>
        <source>Turned round</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>Other readings that fit</source>
        <translation>其他吻合的解释</translation>
    </message>
    <message>
        <source>Readings that fit</source>
        <translation>吻合的解释</translation>
    </message>
    <message>
        <source>as guessed</source>
        <translation>按推测</translation>
    </message>
    <message>
        <source>Counts &amp;as</source>
        <translation>计法(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Dates are</source>
        <translation>日期顺序(&amp;D)</translation>
    </message>
    <message>
        <source>Is added to the times of the table, not to those of the scans. A minus makes them earlier.</source>
        <translation>加到表中的时间上，而不是扫描的时间上。负数使其提前。</translation>
    </message>
    <message>
        <source>Add to its ti&amp;mes</source>
        <translation>时间加上(&amp;M)</translation>
    </message>
    <message>
        <source>a column is missing: please choose</source>
        <translation>缺少列：请选择</translation>
    </message>
    <message>
        <source>not compared with the data: please check</source>
        <translation>未与数据比较：请检查</translation>
    </message>
</context>
<context>
    <name>remount::widgets::CorrelationChart</name>
    <message>
        <source>Correlations of the six parameters</source>
        <translation>六个参数的相关性</translation>
    </message>
    <message>
        <source>no two parameters are correlated</source>
        <translation>没有两个参数相关</translation>
    </message>
    <message>
        <source>strongest: %1 with %2, %3</source>
        <translation>最强：%1 与 %2，%3</translation>
    </message>
    <message>
        <source>%1: %2. Near 1 or -1 the drive tells the two apart only together.</source>
        <translation>%1：%2。接近 1 或 -1 时，此次行驶只能把两者一起确定。</translation>
    </message>
    <message>
        <source>%1: one of them is not observed</source>
        <translation>%1：其中之一不可观测</translation>
    </message>
</context>
<context>
    <name>remount::widgets::CrossPairTableModel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>LiDAR a</source>
        <translation>激光雷达 a</translation>
    </message>
    <message>
        <source>LiDAR b</source>
        <translation>激光雷达 b</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Δpos [cm]</source>
        <translation>Δpos [cm]</translation>
    </message>
    <message>
        <source>Δrot [°]</source>
        <translation>Δ旋转 [°]</translation>
    </message>
    <message>
        <source>RMSE [cm]</source>
        <translation>RMSE [cm]</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>重叠</translation>
    </message>
    <message>
        <source>Gap [s]</source>
        <translation>间隔 [秒]</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>理由</translation>
    </message>
</context>
<context>
    <name>remount::widgets::DistanceLegend</name>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>End of the distance scale</source>
        <translation>距离色标的上限</translation>
    </message>
    <message>
        <source>End of the scale in m. It is the same for every pair.</source>
        <translation>色标的上限，单位米。对所有帧对相同。</translation>
    </message>
    <message>
        <source>more</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>nothing within %1 m</source>
        <translation>%1 m 以内没有</translation>
    </message>
    <message>
        <source>Median distance of the points of scan a that have a surface of scan b within %1 m, as shown</source>
        <translation>所示状态下，扫描 a 中在 %1 m 内有扫描 b 表面的点的距离中位数</translation>
    </message>
    <message>
        <source>Distance to scan b: 0</source>
        <translation>到扫描 b 的距离：0</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>median …</source>
        <translation>中位数 …</translation>
    </message>
    <message>
        <source>median %1</source>
        <translation>中位数 %1</translation>
    </message>
    <message>
        <source>Behind and before scan b: ±</source>
        <translation>扫描 b 的后方与前方：±</translation>
    </message>
</context>
<context>
    <name>remount::widgets::DriveMap</name>
    <message>
        <source>Map of the drive</source>
        <translation>行驶地图</translation>
    </message>
    <message>
        <source>Trajectory with keyframes and pairs. Plus and minus zoom, the arrow keys pan, Home shows all.</source>
        <translation>轨迹及关键帧和帧对。加减键缩放，方向键平移，Home 显示全部。</translation>
    </message>
    <message>
        <source>pair %1: %2</source>
        <translation>帧对 %1：%2</translation>
    </message>
    <message>
        <source>This drive has no INS positions.</source>
        <translation>此次行驶没有 INS 位置。</translation>
    </message>
    <message>
        <source>The drive appears here once it is open.</source>
        <translation>打开数据后，行驶轨迹显示在这里。</translation>
    </message>
    <message>
        <source>start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>%1 km</source>
        <translation>%1 千米</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>N</source>
        <translation>北</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
</context>
<context>
    <name>remount::widgets::DrivePanel</name>
    <message>
        <source>%1: none</source>
        <translation>%1：无</translation>
    </message>
    <message>
        <source>no gaps</source>
        <translation>没有间断</translation>
    </message>
    <message>
        <source>%1: %2 at %3 Hz, %4</source>
        <translation>%1：%2，%3 赫兹，%4</translation>
    </message>
    <message>
        <source>LiDAR</source>
        <translation>激光雷达</translation>
    </message>
    <message>
        <source>INS</source>
        <translation>INS</translation>
    </message>
    <message>
        <source>%1 s, %2 m travelled</source>
        <translation>%1 秒，行驶 %2 m</translation>
    </message>
    <message>
        <source>Drive that is shown</source>
        <translation>显示的行驶</translation>
    </message>
    <message>
        <source>Streams of the drive</source>
        <translation>此次行驶的数据流</translation>
    </message>
    <message>
        <source>Click selects a pair, the wheel zooms, dragging pans, Home shows all</source>
        <translation>点击选择帧对，滚轮缩放，拖动平移，Home 显示全部</translation>
    </message>
    <message>
        <source>Its motion can tell all of X</source>
        <translation>其运动能确定 X 的全部参数</translation>
    </message>
    <message>
        <source>Its motion can tell nothing of X</source>
        <translation>其运动不能确定 X 的任何参数</translation>
    </message>
    <message>
        <source>Its motion can tell %1; not %2</source>
        <translation>其运动能确定 %1；不能确定 %2</translation>
    </message>
    <message>
        <source>Given a nominal mounting, its motion can tell %1; not %2. Without one, nothing</source>
        <translation>给出名义安装后，其运动能确定 %1；不能确定 %2。没有名义安装则什么也不能确定</translation>
    </message>
    <message numerus="yes">
        <source>%n gaps, the longest %1 s</source>
        <translation>
            <numerusform>%n 处间断，最长 %1 秒</numerusform>
        </translation>
    </message>
    <message>
        <source>Close to the limit, the calibration may find otherwise: %1</source>
        <translation>接近可观测的界限，标定的结论可能不同：%1</translation>
    </message>
</context>
<context>
    <name>remount::widgets::DriveTimeline</name>
    <message>
        <source>good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>degraded</source>
        <translation>下降</translation>
    </message>
    <message>
        <source>not valid</source>
        <translation>无效</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>未说明</translation>
    </message>
    <message>
        <source>Streams and INS quality over time</source>
        <translation>数据流和 INS 质量随时间的变化</translation>
    </message>
    <message>
        <source>Left and right arrow keys select the pair that was recorded before or after.</source>
        <translation>左右方向键选择记录在前或在后的帧对。</translation>
    </message>
    <message>
        <source>LiDAR</source>
        <translation>激光雷达</translation>
    </message>
    <message>
        <source>INS</source>
        <translation>INS</translation>
    </message>
    <message>
        <source>fix</source>
        <translation>定位</translation>
    </message>
    <message>
        <source>position sigma of the INS [m]</source>
        <translation>INS 位置标准差 [m]</translation>
    </message>
    <message>
        <source>speed [m/s] (the log states no sigma)</source>
        <translation>速度 [m/s]（记录未说明标准差）</translation>
    </message>
    <message>
        <source>0 s</source>
        <translation>0 秒</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>
sigma: position %1 m, attitude %2°</source>
        <translation>
标准差：位置 %1 m，姿态 %2°</translation>
    </message>
    <message>
        <source>GNSS fix: %1</source>
        <translation>GNSS 定位：%1</translation>
    </message>
    <message>
        <source>%1 s: GNSS fix %2, %3 m/s</source>
        <translation>%1 秒：GNSS 定位%2，%3 m/s</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ErrorBarChart</name>
    <message>
        <source>Error of each pair</source>
        <translation>每个帧对的误差</translation>
    </message>
    <message>
        <source>pair %1: %2, %3</source>
        <translation>帧对 %1：%2，%3</translation>
    </message>
    <message>
        <source>not aligned</source>
        <translation>未配准</translation>
    </message>
    <message>
        <source>No pair is shown: the filter of the table hides them.</source>
        <translation>没有显示帧对：表格的筛选把它们隐藏了。</translation>
    </message>
    <message>
        <source>No pairs yet: the error of each pair appears here.</source>
        <translation>还没有帧对：每个帧对的误差将显示在这里。</translation>
    </message>
    <message>
        <source>pair %1</source>
        <translation>帧对 %1</translation>
    </message>
    <message>
        <source>This method works without pairs.</source>
        <translation>该方法不使用帧对。</translation>
    </message>
    <message>
        <source>There are no pairs.</source>
        <translation>没有帧对。</translation>
    </message>
    <message>
        <source>rejects %1 of %2 above %3</source>
        <translation>拒绝高于 %3 的 %1 个（共 %2 个）</translation>
    </message>
    <message>
        <source>none of the %1 kept is above %2</source>
        <translation>保留的 %1 个中没有高于 %2 的</translation>
    </message>
    <message>
        <source>One bar per pair. Left and right arrow keys select the neighbouring pair; up and down move the line above which Return rejects, Escape puts it back; plus and minus zoom.</source>
        <translation>每个帧对一根柱。左右方向键选择相邻帧对；上下方向键移动阈值线，回车拒绝线以上的帧对，Esc 复位；加号和减号缩放。</translation>
    </message>
    <message>
        <source>Drag: what is above the line is rejected when you let go. The line stays: pulled back, it gives back what it rejected.
In the chart: Up and Down move it, Return applies it, Escape puts it away.</source>
        <translation>拖动：松开时拒绝线以上的帧对。线停留在那里：向上拉回则还回它所拒绝的帧对。
在图中：上下方向键移动阈值线，回车执行，Esc 收起。</translation>
    </message>
    <message>
        <source>%1 of %2 kept are above %3</source>
        <translation>保留的 %2 个中有 %1 个高于 %3</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ErrorChartPanel</name>
    <message>
        <source>What the bars show</source>
        <translation>柱表示什么</translation>
    </message>
    <message>
        <source>What the line would reject</source>
        <translation>阈值线会拒绝什么</translation>
    </message>
    <message>
        <source>%1 above %2 %3</source>
        <translation>%1 高于 %2 %3</translation>
    </message>
    <message>
        <source>rejects %1 of %2</source>
        <translation>拒绝 %2 个中的 %1 个</translation>
    </message>
    <message>
        <source>drag ◀ to reject</source>
        <translation>拖动 ◀ 以拒绝</translation>
    </message>
    <message>
        <source>none of the %1 kept is above</source>
        <translation>保留的 %1 个中没有更高的</translation>
    </message>
    <message>
        <source>Return rejects %1 of %2</source>
        <translation>按回车拒绝 %2 个中的 %1 个</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ExportDialog</name>
    <message>
        <source>Export the result</source>
        <translation>导出结果</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Direction of the transform</source>
        <translation>变换的方向</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Direction:</source>
        <translation>方向：</translation>
    </message>
    <message>
        <source>Save %1</source>
        <translation>保存 %1</translation>
    </message>
    <message>
        <source>Copied.</source>
        <translation>已复制。</translation>
    </message>
    <message>
        <source>What became of it</source>
        <translation>结果如何</translation>
    </message>
    <message>
        <source>Cannot be written in this format: %1</source>
        <translation>无法写成此格式：%1</translation>
    </message>
    <message>
        <source>Export all LiDARs</source>
        <translation>导出全部激光雷达</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
</context>
<context>
    <name>remount::widgets::FoundFilesTree</name>
    <message>
        <source>Files that were found</source>
        <translation>找到的文件</translation>
    </message>
    <message>
        <source>Motion of the INS</source>
        <translation>INS 的运动</translation>
    </message>
    <message>
        <source>poses of a LiDAR</source>
        <translation>激光雷达的位姿</translation>
    </message>
    <message>
        <source>none was found</source>
        <translation>未找到</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>none were found: add the folder that holds them</source>
        <translation>未找到：请添加其所在的文件夹</translation>
    </message>
    <message>
        <source>Not used</source>
        <translation>未使用</translation>
    </message>
</context>
<context>
    <name>remount::widgets::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Search in the help</source>
        <translation>在帮助中搜索</translation>
    </message>
    <message>
        <source>Contents of the help</source>
        <translation>帮助目录</translation>
    </message>
    <message>
        <source>Page of the help</source>
        <translation>帮助页面</translation>
    </message>
</context>
<context>
    <name>remount::widgets::HoldOutView</name>
    <message>
        <source>%1°, %2 mm</source>
        <translation>%1°，%2 mm</translation>
    </message>
    <message>
        <source>%1 alone gives no result: %2</source>
        <translation>%1 单独求解没有结果：%2</translation>
    </message>
    <message>
        <source>There are no pairs to score.</source>
        <translation>没有可供检验的帧对。</translation>
    </message>
    <message>
        <source>%1 does not observe %2: taken from %3&apos;s own X</source>
        <translation>%1 观测不到 %2：取自 %3 自己的 X</translation>
    </message>
    <message>
        <source>There is no common result.</source>
        <translation>没有共同的结果。</translation>
    </message>
    <message>
        <source>nothing is observed by both</source>
        <translation>没有双方都可观测的分量</translation>
    </message>
    <message>
        <source>differ by %1 sigma in %2</source>
        <translation>不一致：%2 相差 %1 倍标准差</translation>
    </message>
    <message>
        <source>%1 times the sigma of both together</source>
        <translation>为两者合成标准差的 %1 倍</translation>
    </message>
    <message>
        <source>%1 does not observe %2</source>
        <translation>%1 观测不到 %2</translation>
    </message>
    <message>
        <source>Whether the sessions agree</source>
        <translation>各份数据是否一致</translation>
    </message>
    <message>
        <source>Residuals of each session under the X of another</source>
        <translation>每份数据在另一份数据的 X 下的残差</translation>
    </message>
    <message>
        <source>Differences between the X of two sessions</source>
        <translation>两份数据的 X 之差</translation>
    </message>
    <message>
        <source>Needs a second session.</source>
        <translation>需要第二份数据。</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 与 %2</translation>
    </message>
    <message>
        <source>Each session solved alone. %1: %2.</source>
        <translation>各份数据单独求解。%1：%2。</translation>
    </message>
    <message>
        <source>Solved on</source>
        <translation>求解于</translation>
    </message>
    <message>
        <source>Scored on</source>
        <translation>检验于</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>帧对</translation>
    </message>
    <message>
        <source>Under that X</source>
        <translation>用该 X</translation>
    </message>
    <message>
        <source>Under its own X</source>
        <translation>用自己的 X</translation>
    </message>
    <message>
        <source>Under the common X</source>
        <translation>用共同的 X</translation>
    </message>
    <message>
        <source>Difference of X</source>
        <translation>X 之差</translation>
    </message>
    <message>
        <source>In words</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>What P X = X Q leaves over the pairs of the session it is scored on, root mean square, in degrees and mm. Where all clouds were aligned together as the last step, residuals are slightly too small.</source>
        <translation>P X = X Q 在受检数据的帧对上的残差，均方根，单位度和毫米。若最后一步把所有点云一起配准，残差略微偏小。</translation>
    </message>
    <message>
        <source>agree in %1 of 6 parameters (at most %2 sigma, in %3)</source>
        <translation>6 个参数中有 %1 个一致（最多相差 %2 倍标准差，为 %3）</translation>
    </message>
    <message>
        <source>%1 alone does not observe %2.</source>
        <translation>单独用 %1 观测不到 %2。</translation>
    </message>
    <message>
        <source>–: no number, because a session alone says nothing about it.</source>
        <translation>–：没有数值，因为单独一份数据对它没有任何说明。</translation>
    </message>
    <message>
        <source>Each session solved alone. No two of them observe the same parameter: whether they agree cannot be said.</source>
        <translation>各份数据单独求解。没有任何两份观测到同一个参数：无法说明它们是否一致。</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ImportDialog</name>
    <message>
        <source>Import a table</source>
        <translation>导入表格</translation>
    </message>
    <message>
        <source>Add &amp;folder…</source>
        <translation>添加文件夹(&amp;F)…</translation>
    </message>
    <message>
        <source>Scans or tables that lie elsewhere</source>
        <translation>位于别处的扫描或表格</translation>
    </message>
    <message>
        <source>Add fi&amp;les…</source>
        <translation>添加文件(&amp;L)…</translation>
    </message>
    <message>
        <source>As guessed</source>
        <translation>恢复推测</translation>
    </message>
    <message>
        <source>Takes back what was changed here</source>
        <translation>撤销此处的更改</translation>
    </message>
    <message>
        <source>&amp;Save manifest…</source>
        <translation>保存清单(&amp;S)…</translation>
    </message>
    <message>
        <source>Writes what stands here as session.yaml: the folder then opens as any other session</source>
        <translation>将此处内容写为 session.yaml：此后该文件夹可像其他数据一样打开</translation>
    </message>
    <message>
        <source>Save and &amp;open</source>
        <translation>保存并打开(&amp;O)</translation>
    </message>
    <message>
        <source>Looking at %1…</source>
        <translation>正在查看 %1…</translation>
    </message>
    <message>
        <source>It opens without an import, too: %1</source>
        <translation>无需导入也可打开：%1</translation>
    </message>
    <message>
        <source>Say above each column what it is; the checks below compare it with the drive at every change.</source>
        <translation>在每列上方选择其含义；每次更改后，下方的核对会将其与行驶比较。</translation>
    </message>
    <message>
        <source>%1 says itself what it holds: there are no columns to choose.</source>
        <translation>%1 自带说明：无需选择列。</translation>
    </message>
    <message>
        <source>No table with columns enough for time, position and attitude was found.</source>
        <translation>没有找到列数足以包含时间、位置和姿态的表格。</translation>
    </message>
    <message>
        <source>It cannot be opened yet: %1</source>
        <translation>尚不能打开：%1</translation>
    </message>
    <message>
        <source>%1 was taken for the poses of a LiDAR, and cannot be both: as the motion of the INS it needs scans or poses of another LiDAR beside it.</source>
        <translation>%1 原被视为激光雷达的位姿，不能同时作为两者：作为 INS 的运动时，还需要另一激光雷达的扫描或位姿。</translation>
    </message>
    <message>
        <source>No motion of the INS was found. Add it; or choose the poses on the left, if they are those of the INS.</source>
        <translation>未找到 INS 的运动。请添加；若左侧的位姿属于 INS，请选择它们。</translation>
    </message>
    <message>
        <source>The drive appears here as soon as it is read.</source>
        <translation>读取后在此显示行驶路线。</translation>
    </message>
    <message>
        <source>Positions from %1 and attitudes from %2 are joined by their times. There are no columns to choose: what was found, and how sure it is, stands as comments in the session.yaml that is saved.</source>
        <translation>%1 中的位置与 %2 中的姿态按时间合并。没有需要选择的列：识别结果及其可信程度以注释形式写在所保存的 session.yaml 中。</translation>
    </message>
</context>
<context>
    <name>remount::widgets::KeysDialog</name>
    <message>
        <source>%1: %2 and %3</source>
        <translation>%1：%2 和 %3</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Key of %1</source>
        <translation>%1 的按键</translation>
    </message>
    <message>
        <source>Click and press the key. Standard: %1</source>
        <translation>点击后按下按键。默认：%1</translation>
    </message>
    <message>
        <source>Several pairs can be marked with Ctrl or Shift and decided together.</source>
        <translation>可用 Ctrl 或 Shift 选中多个帧对，一起作出决定。</translation>
    </message>
    <message>
        <source>Keys with two meanings:
%1</source>
        <translation>有两种含义的按键：
%1</translation>
    </message>
</context>
<context>
    <name>remount::widgets::LidarTableModel</name>
    <message>
        <source>not calibrated</source>
        <translation>未标定</translation>
    </message>
    <message>
        <source>%1, with the others</source>
        <translation>%1，与其他各台联合</translation>
    </message>
    <message>
        <source>✕ left out: %1</source>
        <translation>✕ 未参与：%1</translation>
    </message>
    <message>
        <source>▲ changed since: %1</source>
        <translation>▲ 此后有变化：%1</translation>
    </message>
    <message>
        <source>%1, alone</source>
        <translation>%1，单独</translation>
    </message>
    <message>
        <source>▶ %1</source>
        <translation>▶ %1</translation>
    </message>
    <message>
        <source>The other panels are about this LiDAR</source>
        <translation>其他面板针对这台激光雷达</translation>
    </message>
    <message>
        <source>Double click: the other panels are about this LiDAR then</source>
        <translation>双击：其他面板改为针对这台激光雷达</translation>
    </message>
    <message>
        <source>LiDAR</source>
        <translation>激光雷达</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>x [m]</source>
        <translation>x [m]</translation>
    </message>
    <message>
        <source>y [m]</source>
        <translation>y [m]</translation>
    </message>
    <message>
        <source>z [m]</source>
        <translation>z [m]</translation>
    </message>
    <message>
        <source>yaw [°]</source>
        <translation>偏航 [°]</translation>
    </message>
    <message>
        <source>pitch [°]</source>
        <translation>俯仰 [°]</translation>
    </message>
    <message>
        <source>roll [°]</source>
        <translation>横滚 [°]</translation>
    </message>
    <message>
        <source>Value ± one sigma</source>
        <translation>数值 ± 一倍标准差</translation>
    </message>
    <message>
        <source>✕ contradicts: %1</source>
        <translation>✕ 互相矛盾：%1</translation>
    </message>
    <message>
        <source>By itself: it has not been solved together with the others yet.</source>
        <translation>单独标定：尚未与其他激光雷达联合求解。</translation>
    </message>
    <message>
        <source>Decisions, options or the nominal are others than when it was solved with the others.</source>
        <translation>判定、选项或名义安装与联合求解时不同。</translation>
    </message>
    <message>
        <source>–
not observed</source>
        <translation>–
不可观测</translation>
    </message>
</context>
<context>
    <name>remount::widgets::LidarsPanel</name>
    <message>
        <source>These recordings have one LiDAR. Where they have several, all of them are calibrated together here.</source>
        <translation>这些记录中只有一台激光雷达。有多台时在此联合标定。</translation>
    </message>
    <message>
        <source>What the LiDARs say together</source>
        <translation>各激光雷达共同得出的结论</translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation>车辆</translation>
    </message>
    <message>
        <source>Against each other</source>
        <translation>相互关系</translation>
    </message>
    <message>
        <source>Pairs across</source>
        <translation>跨激光雷达帧对</translation>
    </message>
    <message>
        <source>Calibrate ticked</source>
        <translation>标定所选</translation>
    </message>
    <message>
        <source>Calibrates each of the ticked LiDARs, then all of them together</source>
        <translation>先逐台标定所选激光雷达，再联合求解</translation>
    </message>
    <message>
        <source>Solve together again</source>
        <translation>重新联合求解</translation>
    </message>
    <message>
        <source>From the pairs as they are now: after decisions on the pairs of one of them</source>
        <translation>用现有帧对求解：适用于对其中一台的帧对作出决定之后</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>The mountings of all of them, for other programs</source>
        <translation>全部安装位姿，供其他程序使用</translation>
    </message>
    <message>
        <source>Save results…</source>
        <translation>保存结果…</translation>
    </message>
    <message>
        <source>Everything that is known of all of them, as a file that can be compared</source>
        <translation>全部已知内容，存为可供比较的文件</translation>
    </message>
    <message>
        <source>In whose frame the numbers are</source>
        <translation>数值所在的坐标系</translation>
    </message>
    <message>
        <source>In whose frame the numbers are: of the INS, or of a LiDAR</source>
        <translation>数值所在的坐标系：INS 或某台激光雷达</translation>
    </message>
    <message>
        <source>in the frame of</source>
        <translation>坐标系：</translation>
    </message>
    <message>
        <source>LiDARs of the vehicle</source>
        <translation>车辆上的激光雷达</translation>
    </message>
    <message>
        <source>Pairs of which LiDARs are shown</source>
        <translation>显示哪些激光雷达的帧对</translation>
    </message>
    <message>
        <source>Pairs across LiDARs</source>
        <translation>跨激光雷达帧对</translation>
    </message>
    <message>
        <source>Scans of two LiDARs that see the same. A click shows them in the 3-D view.</source>
        <translation>两台激光雷达看到同一景物的扫描。单击即在三维视图中显示。</translation>
    </message>
    <message>
        <source>the INS</source>
        <translation>INS</translation>
    </message>
    <message>
        <source>Tick the LiDARs and calibrate: each is calibrated alone, then all of them together.</source>
        <translation>勾选激光雷达并标定：先逐台标定，再联合求解。</translation>
    </message>
    <message>
        <source>▲ Something has changed since they were solved together. Solve them together again.</source>
        <translation>▲ 联合求解之后有变化。请重新联合求解。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 and %2: within %3 sigma</source>
        <translation>%1 与 %2：相差不超过 %3 倍标准差</translation>
    </message>
    <message>
        <source>%1 and %2: %3 mm together, %4 mm alone</source>
        <translation>%1 与 %2：联合时 %3 mm，单独时 %4 mm</translation>
    </message>
    <message>
        <source>To look at</source>
        <translation>需要查看</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Distance of surfaces that two of them see (noise of the ranges is in it)</source>
        <translation>两台所见同一表面的间距（含测距噪声）</translation>
    </message>
    <message>
        <source>What they see of each other against what the INS says</source>
        <translation>互相观测与 INS 所得的比较</translation>
    </message>
    <message>
        <source>All pairs across LiDARs</source>
        <translation>全部跨激光雷达帧对</translation>
    </message>
    <message>
        <source>Of %1</source>
        <translation>%1 的</translation>
    </message>
    <message>
        <source>Of %1 and %2</source>
        <translation>%1 与 %2 的</translation>
    </message>
    <message>
        <source>Mountings</source>
        <translation>安装位姿</translation>
    </message>
</context>
<context>
    <name>remount::widgets::LogPanel</name>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>What the program does and finds appears here.</source>
        <translation>程序做了什么、发现了什么，显示在这里。</translation>
    </message>
</context>
<context>
    <name>remount::widgets::MapView</name>
    <message>
        <source>3-D view of the accumulated map</source>
        <translation>累积地图的三维视图</translation>
    </message>
    <message>
        <source>Make the map</source>
        <translation>生成地图</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Progress of the map</source>
        <translation>地图的进度</translation>
    </message>
    <message>
        <source>The scans of a session, put together under one mounting, are shown here after a calibration.</source>
        <translation>标定之后，这里显示一份数据的全部扫描按同一安装拼合成的地图。</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>名义</translation>
    </message>
    <message>
        <source>The scans put together under the mounting that the calibration started from</source>
        <translation>按标定的起始安装拼合的扫描</translation>
    </message>
    <message>
        <source>Candidate</source>
        <translation>候选</translation>
    </message>
    <message>
        <source>… under the candidate that is selected in the table of candidates</source>
        <translation>……按候选表中选中的候选</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>… under the present result</source>
        <translation>……按当前结果</translation>
    </message>
    <message>
        <source>Session of the map</source>
        <translation>地图的数据</translation>
    </message>
    <message>
        <source>The session whose scans are put together</source>
        <translation>其扫描被拼合的数据</translation>
    </message>
    <message>
        <source>The map is being made…</source>
        <translation>正在生成地图……</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1：%2 / %3</translation>
    </message>
    <message>
        <source>Height: %1 m</source>
        <translation>高度：%1 m</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 个点</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 / %2 个点</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3 m in %4.</source>
        <translation>x %1，y %2，z %3 m（%4）。</translation>
    </message>
    <message>
        <source>axes of the INS data, origin at the first keyframe</source>
        <translation>INS 数据的坐标轴，原点在首个关键帧</translation>
    </message>
</context>
<context>
    <name>remount::widgets::MessageBanner</name>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Dismiss the message</source>
        <translation>关闭这条消息</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>remount::widgets::MethodView</name>
    <message>
        <source>What the method determined beside the mounting</source>
        <translation>该方法在安装位姿之外求得的量</translation>
    </message>
    <message>
        <source>Method of the result</source>
        <translation>结果所用的方法</translation>
    </message>
    <message>
        <source>Plots of the method</source>
        <translation>该方法的曲线</translation>
    </message>
    <message>
        <source>± 1 sigma</source>
        <translation>± 1 倍标准差</translation>
    </message>
    <message>
        <source>Also determined</source>
        <translation>另外求得</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
</context>
<context>
    <name>remount::widgets::MissingSessionsDialog</name>
    <message>
        <source>Where do the sessions lie now?</source>
        <translation>数据现在在哪里？</translation>
    </message>
    <message>
        <source>%1 names sessions that are not there. Show where one of them lies now; the others that were moved with it are then found by themselves. The project remembers it when it is saved.</source>
        <translation>%1 提到的数据不在原处。请指出其中一个现在的位置；与它一起移动的其他数据会自动找到。项目保存后会记住。</translation>
    </message>
    <message>
        <source>Was at</source>
        <translation>原来位于</translation>
    </message>
    <message>
        <source>Lies now at</source>
        <translation>现在位于</translation>
    </message>
    <message>
        <source>Sessions that are missing</source>
        <translation>缺少的数据</translation>
    </message>
    <message>
        <source>not found yet</source>
        <translation>尚未找到</translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>定位…</translation>
    </message>
    <message>
        <source>Open without them</source>
        <translation>不带它们打开</translation>
    </message>
    <message>
        <source>Their pairs and the result that rests on them are left out. The project&apos;s file is left as it is.</source>
        <translation>它们的帧对以及依赖它们的结果将被略去。项目文件保持不变。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
</context>
<context>
    <name>remount::widgets::NominalPanel</name>
    <message>
        <source>Unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>About here:</source>
        <translation>大约在这里：</translation>
    </message>
    <message>
        <source>The mounting is found from nothing, however the sensor is turned</source>
        <translation>从零开始求安装位置，无论传感器怎样转动</translation>
    </message>
    <message>
        <source>Pose of the LiDAR in the INS frame (x forward, y left, z up); R = Rz(yaw) Ry(pitch) Rx(roll)</source>
        <translation>激光雷达在 INS 坐标系中的位姿（x 向前，y 向左，z 向上）；R = Rz(yaw) Ry(pitch) Rx(roll)</translation>
    </message>
    <message>
        <source>From file…</source>
        <translation>从文件…</translation>
    </message>
    <message>
        <source>A result of an earlier calibration, or any format that can be exported</source>
        <translation>以前的标定结果，或任何可导出的格式</translation>
    </message>
    <message>
        <source>Nominal %1</source>
        <translation>名义值 %1</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ObstacleDialog</name>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Obstacles in %1</source>
        <translation>%1 中的障碍物</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>With result</source>
        <translation>按结果</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差</translation>
    </message>
    <message>
        <source>Distance of each object from the outline of the vehicle</source>
        <translation>每个物体到车辆轮廓的距离</translation>
    </message>
    <message>
        <source>nearest at %1</source>
        <translation>最近 %1</translation>
    </message>
    <message>
        <source>nothing near</source>
        <translation>附近没有</translation>
    </message>
    <message>
        <source>stop (%1)</source>
        <translation>停车（%1）</translation>
    </message>
    <message>
        <source>clear (%1)</source>
        <translation>畅通（%1）</translation>
    </message>
    <message>
        <source>The mounting changes the decision.</source>
        <translation>安装改变了判定。</translation>
    </message>
    <message>
        <source>Closer than the stop distance</source>
        <translation>比停车距离更近</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>名义</translation>
    </message>
    <message>
        <source>%1: %2. With result: %3.</source>
        <translation>%1：%2。按结果：%3。</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>Measuring the distances…</source>
        <translation>正在测量距离…</translation>
    </message>
    <message>
        <source>no obstacle</source>
        <translation>不是障碍物</translation>
    </message>
</context>
<context>
    <name>remount::widgets::OptionForm</name>
    <message>
        <source>In files: %1</source>
        <translation>文件中：%1</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>选择文件</translation>
    </message>
</context>
<context>
    <name>remount::widgets::OptionsDialog</name>
    <message>
        <source>General</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Keyframes</source>
        <translation>关键帧</translation>
    </message>
    <message>
        <source>Pairing</source>
        <translation>配对</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>Search range</source>
        <translation>搜索范围</translation>
    </message>
    <message>
        <source>Solution</source>
        <translation>求解</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>分组</translation>
    </message>
    <message>
        <source>Measured by hand</source>
        <translation>手工测量值</translation>
    </message>
    <message>
        <source>LiDAR odometry</source>
        <translation>激光雷达里程计</translation>
    </message>
    <message>
        <source>Trajectory alignment</source>
        <translation>轨迹对齐</translation>
    </message>
    <message>
        <source>Fusion odometry</source>
        <translation>融合里程计</translation>
    </message>
    <message>
        <source>Vehicle frame</source>
        <translation>车体坐标系</translation>
    </message>
    <message>
        <source>Slewing machine</source>
        <translation>回转机械</translation>
    </message>
    <message>
        <source>Search range and solution apply at once; the other options apply to the next calibration. Every change can be undone (Ctrl+Z).</source>
        <translation>搜索范围和求解立即生效；其他选项在下次标定时生效。每次更改都可以撤销 (Ctrl+Z)。</translation>
    </message>
    <message>
        <source>LiDAR beams</source>
        <translation>激光雷达光束</translation>
    </message>
</context>
<context>
    <name>remount::widgets::PairTableModel</name>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>What was decided about the pair, and by whom</source>
        <translation>对该帧对作出的决定，以及由谁作出</translation>
    </message>
    <message>
        <source>Δpos [cm]</source>
        <translation>Δpos [cm]</translation>
    </message>
    <message>
        <source>Translation residual of P X = X Q under the present result</source>
        <translation>当前结果下 P X = X Q 的平移残差</translation>
    </message>
    <message>
        <source>Δrot [°]</source>
        <translation>Δ旋转 [°]</translation>
    </message>
    <message>
        <source>Rotation residual of P X = X Q under the present result</source>
        <translation>当前结果下 P X = X Q 的旋转残差</translation>
    </message>
    <message>
        <source>RMSE [cm]</source>
        <translation>RMSE [cm]</translation>
    </message>
    <message>
        <source>Of the inlier residuals of the alignment</source>
        <translation>配准内点残差的均方根</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>重叠</translation>
    </message>
    <message>
        <source>Share of points of scan a with a neighbour in scan b after alignment</source>
        <translation>配准后扫描 a 的点在扫描 b 中有邻点的比例</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>权重</translation>
    </message>
    <message>
        <source>Robust weight of the pair in the solution, 0 to 1</source>
        <translation>该帧对在解中的稳健权重，0 到 1</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Static objects that both scans contain; moving ones after the plus sign</source>
        <translation>两次扫描共有的静止物体；加号后是运动物体</translation>
    </message>
    <message>
        <source>Base [m]</source>
        <translation>基线 [m]</translation>
    </message>
    <message>
        <source>Distance between the two INS positions</source>
        <translation>两个 INS 位置之间的距离</translation>
    </message>
    <message>
        <source>Turn [°]</source>
        <translation>转角 [°]</translation>
    </message>
    <message>
        <source>Angle between the two INS attitudes</source>
        <translation>两个 INS 姿态之间的夹角</translation>
    </message>
    <message>
        <source>Gap [s]</source>
        <translation>间隔 [秒]</translation>
    </message>
    <message>
        <source>Time between the two scans</source>
        <translation>两次扫描之间的时间</translation>
    </message>
    <message>
        <source>a [s]</source>
        <translation>a [秒]</translation>
    </message>
    <message>
        <source>Time of scan a since the session&apos;s first keyframe</source>
        <translation>扫描 a 距数据首个关键帧的时间</translation>
    </message>
    <message>
        <source>b [s]</source>
        <translation>b [秒]</translation>
    </message>
    <message>
        <source>Time of scan b since the session&apos;s first keyframe</source>
        <translation>扫描 b 距数据首个关键帧的时间</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Drive the pair is from</source>
        <translation>帧对来自哪次行驶</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>Why the pair was rejected or accepted</source>
        <translation>为什么拒绝或接受该帧对</translation>
    </message>
    <message>
        <source>Number of the pair</source>
        <translation>帧对编号</translation>
    </message>
    <message>
        <source>%1 + %2 moving</source>
        <translation>%1 + %2 运动</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>The two scans were not aligned: %1</source>
        <translation>两次扫描没有配准：%1</translation>
    </message>
    <message>
        <source>INS–LiDAR [σ]</source>
        <translation>INS–LiDAR [σ]</translation>
    </message>
    <message>
        <source>How much INS and LiDAR motion differ in turn and advance, whatever the mounting (screw test); in sigma</source>
        <translation>无论怎样安装，INS 与激光雷达的运动在转角和前进量上相差多少（螺旋检验）；以 sigma 计</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Your flag and your comment</source>
        <translation>您的标记和备注</translation>
    </message>
</context>
<context>
    <name>remount::widgets::PairView</name>
    <message>
        <source>3-D view of the pair</source>
        <translation>帧对的三维视图</translation>
    </message>
    <message>
        <source>Select a pair to see its two scans.</source>
        <translation>选择一个帧对以查看它的两次扫描。</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>闪烁</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>As predicted by the INS and the mounting the calibration started from</source>
        <translation>按 INS 和标定起始安装的预测</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>配准后</translation>
    </message>
    <message>
        <source>As the two scans were aligned with each other</source>
        <translation>两次扫描相互配准的结果</translation>
    </message>
    <message>
        <source>With result</source>
        <translation>按结果</translation>
    </message>
    <message>
        <source>As predicted by the INS and the present result</source>
        <translation>按 INS 和当前结果的预测</translation>
    </message>
    <message>
        <source>scan a</source>
        <translation>扫描 a</translation>
    </message>
    <message>
        <source>scan b</source>
        <translation>扫描 b</translation>
    </message>
    <message>
        <source>From before to after</source>
        <translation>从之前到之后</translation>
    </message>
    <message>
        <source>Moves scan a from where it was before (left) to where the chosen alignment puts it (right)</source>
        <translation>把扫描 a 从之前的位置（左）移到所选配准的位置（右）</translation>
    </message>
    <message>
        <source>Shows before and after in turn (B); Space flips once</source>
        <translation>轮流显示之前与之后 (B)；空格切换一次</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>并排</translation>
    </message>
    <message>
        <source>Before on the left, after on the right; both are turned together</source>
        <translation>左为之前，右为之后；两者一起转动</translation>
    </message>
    <message>
        <source>Boxes of the objects that both scans contain, joined by lines; moving ones are red and crossed out</source>
        <translation>两次扫描共有物体的方框，用线相连；运动物体为红色并打叉</translation>
    </message>
    <message>
        <source>With %1</source>
        <translation>按 %1</translation>
    </message>
    <message>
        <source>As predicted by the INS and this candidate: %1</source>
        <translation>按 INS 和此候选的预测：%1</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3 m</source>
        <translation>x %1，y %2，z %3 m</translation>
    </message>
    <message>
        <source>Point of %1: %2 in LiDAR axes of %1; %3 in %4. </source>
        <translation>%1 的点：在 %1 的激光雷达轴中 %2；在%4中 %3。</translation>
    </message>
    <message>
        <source>Nothing of %1 within %2 m as shown.</source>
        <translation>所示状态下 %2 m 以内没有 %1 的任何点。</translation>
    </message>
    <message>
        <source>%1 m from the surfaces of %2 as shown.</source>
        <translation>所示状态下离 %2 的表面 %1 m。</translation>
    </message>
    <message>
        <source>INS axes at scan b</source>
        <translation>扫描 b 处的 INS 轴</translation>
    </message>
    <message>
        <source>left: before, right: %1</source>
        <translation>左：之前，右：%1</translation>
    </message>
    <message>
        <source>%1 % of the way</source>
        <translation>%1 % 的位置</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>运动物体</translation>
    </message>
    <message>
        <source>objects a</source>
        <translation>物体 a</translation>
    </message>
    <message>
        <source>b</source>
        <translation>b</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Shows the points of the ground (G)</source>
        <translation>显示地面点（G）</translation>
    </message>
    <message>
        <source>Colour:</source>
        <translation>颜色：</translation>
    </message>
    <message>
        <source>Scan a orange</source>
        <translation>扫描 a 橙色</translation>
    </message>
    <message>
        <source>Scan a blue</source>
        <translation>扫描 a 蓝色</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Distance, with side</source>
        <translation>距离（分前后）</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>线号</translation>
    </message>
    <message>
        <source>Time in the scan</source>
        <translation>扫描内时间</translation>
    </message>
    <message>
        <source>Colour of the points</source>
        <translation>点的颜色</translation>
    </message>
    <message>
        <source>Scan a in one colour, or by the distance of each point to the surfaces of scan b; or both scans by what was measured of each point</source>
        <translation>扫描 a 用一种颜色，或按每个点到扫描 b 表面的距离着色；或两次扫描都按每个点的测量值着色</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>These scans have no such values.</source>
        <translation>这些扫描没有这样的数值。</translation>
    </message>
    <message>
        <source>Section through this point</source>
        <translation>穿过该点的剖面</translation>
    </message>
</context>
<context>
    <name>remount::widgets::PairsPanel</name>
    <message>
        <source>✓ Accept</source>
        <translation>✓ 接受</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>帧对</translation>
    </message>
    <message>
        <source>All states</source>
        <translation>所有状态</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>待定</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>已接受</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>Show pairs of this state</source>
        <translation>显示此状态的帧对</translation>
    </message>
    <message>
        <source>All pairs</source>
        <translation>所有帧对</translation>
    </message>
    <message>
        <source>Not decided by you</source>
        <translation>您尚未决定的</translation>
    </message>
    <message>
        <source>Worst %1</source>
        <translation>最差 %1 个</translation>
    </message>
    <message>
        <source>Few shared objects (&lt; %1)</source>
        <translation>共有物体少（&lt; %1）</translation>
    </message>
    <message>
        <source>Not aligned</source>
        <translation>未配准</translation>
    </message>
    <message>
        <source>By what the bars show, among those of the state</source>
        <translation>按柱所表示的量，在该状态的帧对之中</translation>
    </message>
    <message>
        <source>Show pairs of this kind</source>
        <translation>显示这类帧对</translation>
    </message>
    <message>
        <source>Number or text</source>
        <translation>编号或文字</translation>
    </message>
    <message>
        <source>Show pairs that contain this text</source>
        <translation>显示含有此文字的帧对</translation>
    </message>
    <message>
        <source>Accept the marked pairs</source>
        <translation>接受选中的帧对</translation>
    </message>
    <message>
        <source>✕ Reject</source>
        <translation>✕ 拒绝</translation>
    </message>
    <message>
        <source>Reject the marked pairs; the arrow gives reasons</source>
        <translation>拒绝选中的帧对；箭头给出理由</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>no pairs yet</source>
        <translation>还没有帧对</translation>
    </message>
    <message>
        <source>%1 of %2 pairs</source>
        <translation>%2 个帧对中的 %1 个</translation>
    </message>
    <message>
        <source>INS and LiDAR disagree</source>
        <translation>INS 与激光雷达不一致</translation>
    </message>
    <message>
        <source>Turn and advance of INS and LiDAR differ, whatever the mounting (screw test)</source>
        <translation>无论怎样安装，INS 与激光雷达的转角和前进量都不同（螺旋检验）</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs</source>
        <translation>
            <numerusform>%n 个帧对</numerusform>
        </translation>
    </message>
    <message>
        <source>Not looked at</source>
        <translation>尚未看过</translation>
    </message>
    <message>
        <source>Flagged or commented</source>
        <translation>有标记或备注</translation>
    </message>
    <message>
        <source>Shows pairs of this number, or with this text in state, session, reason or comment</source>
        <translation>显示该编号的帧对，或在状态、行程、原因或备注中含有该文字的帧对</translation>
    </message>
    <message>
        <source>Sort again</source>
        <translation>重新排序</translation>
    </message>
    <message>
        <source>Pairs stay where they were while you decide about them. This puts them where they belong now.</source>
        <translation>作决定时帧对留在原处。按此把它们放到现在应在的位置。</translation>
    </message>
    <message>
        <source>%1 looked at</source>
        <translation>已看 %1 个</translation>
    </message>
    <message>
        <source>%1 of %2 pairs were looked at; the numbers of the others are bold</source>
        <translation>%2 个帧对中已看过 %1 个；其余的编号为粗体</translation>
    </message>
    <message>
        <source>none of %1 pairs matches</source>
        <translation>%1 个帧对中没有符合的</translation>
    </message>
    <message>
        <source>✓ Accept %1</source>
        <translation>✓ 接受 %1 个</translation>
    </message>
    <message>
        <source>✕ Reject %1</source>
        <translation>✕ 拒绝 %1 个</translation>
    </message>
</context>
<context>
    <name>remount::widgets::PathView</name>
    <message>
        <source>3-D view of the method</source>
        <translation>方法的三维视图</translation>
    </message>
    <message>
        <source>Colours of the ways</source>
        <translation>各轨迹的颜色</translation>
    </message>
    <message>
        <source>Plot in three dimensions</source>
        <translation>三维显示的曲线图</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适合窗口</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>轴测</translation>
    </message>
    <message>
        <source>%1: x %2, y %3, z %4 m in %5.</source>
        <translation>%1：x %2，y %3，z %4 m（%5）。</translation>
    </message>
    <message>
        <source>the axes of the plot (%1; %2; up)</source>
        <translation>曲线图的坐标轴（%1；%2；向上）</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>沿 y</translation>
    </message>
    <message>
        <source>Along x</source>
        <translation>沿 x</translation>
    </message>
</context>
<context>
    <name>remount::widgets::PlotView</name>
    <message>
        <source>Plots of the method</source>
        <translation>该方法的曲线</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ProgressStrip</name>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop (Esc); what was there before is kept</source>
        <translation>停止 (Esc)；原有内容保留</translation>
    </message>
    <message>
        <source>Present work</source>
        <translation>当前工作</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1：%2 / %3</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>正在取消…</translation>
    </message>
    <message>
        <source>about %1 s left in this step</source>
        <translation>此步骤约剩 %1 秒</translation>
    </message>
    <message>
        <source>about %1 min %2 s left in this step</source>
        <translation>此步骤约剩 %1 分 %2 秒</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 分 %2 秒</translation>
    </message>
    <message>
        <source>Time that the present step has taken</source>
        <translation>当前步骤已用的时间</translation>
    </message>
</context>
<context>
    <name>remount::widgets::QualityView</name>
    <message>
        <source>Map sharpness</source>
        <translation>地图清晰度</translation>
    </message>
    <message>
        <source>Session against session</source>
        <translation>数据互检</translation>
    </message>
    <message>
        <source>Obstacles</source>
        <translation>障碍物</translation>
    </message>
    <message>
        <source>Result confirmed</source>
        <translation>结果已确认</translation>
    </message>
    <message>
        <source>For you to tick when these pages have convinced you. The step &quot;Check&quot; is done then; another result is unconfirmed again.</source>
        <translation>看过这些页面并已信服时请勾选。步骤“检查”随即完成；结果一变，又回到未确认。</translation>
    </message>
    <message>
        <source>What sigma is made of</source>
        <translation>sigma 的构成</translation>
    </message>
</context>
<context>
    <name>remount::widgets::RangePanel</name>
    <message>
        <source>from</source>
        <translation>从</translation>
    </message>
    <message>
        <source>to</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Smallest %1</source>
        <translation>最小 %1</translation>
    </message>
    <message>
        <source>Largest %1</source>
        <translation>最大 %1</translation>
    </message>
    <message>
        <source>x, y, z within 5 m and every angle</source>
        <translation>x、y、z 在 5 米以内，任何角度</translation>
    </message>
    <message>
        <source>The largest %1 is below the smallest: nothing can be found there.</source>
        <translation>%1 的最大值小于最小值：那里什么也找不到。</translation>
    </message>
    <message>
        <source>Widest range</source>
        <translation>最宽范围</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>弧度</translation>
    </message>
    <message>
        <source>Unit of angles</source>
        <translation>角度单位</translation>
    </message>
    <message>
        <source>In which unit angles of range and options are shown and typed</source>
        <translation>范围和选项中的角度以哪种单位显示和输入</translation>
    </message>
    <message>
        <source>Range of %1</source>
        <translation>%1 的范围</translation>
    </message>
    <message>
        <source>Drag the ends. ▼ above: the nominal mounting; ▲ below: the result.</source>
        <translation>拖动两端。上方 ▼：名义安装；下方 ▲：结果。</translation>
    </message>
</context>
<context>
    <name>remount::widgets::RecoveryDialog</name>
    <message>
        <source>Unsaved work was found</source>
        <translation>发现未保存的工作</translation>
    </message>
    <message>
        <source>Remount ended without closing the last time. This was kept; nothing is changed until you choose.</source>
        <translation>Remount 上次没有正常关闭。以下内容已保留；在您选择之前不会有任何改变。</translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation>以后决定</translation>
    </message>
    <message>
        <source>Keeps it; the next start asks again</source>
        <translation>保留；下次启动再问</translation>
    </message>
    <message>
        <source>Which state</source>
        <translation>哪个状态</translation>
    </message>
    <message>
        <source>The newest state is usually the right one; older ones are kept for the case that it is not</source>
        <translation>通常最新的状态就是所要的；较旧的状态留作备用</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Removes what was kept for good</source>
        <translation>永久删除所保留的内容</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ResidualPlot</name>
    <message>
        <source>Residuals of the pairs</source>
        <translation>帧对的残差</translation>
    </message>
    <message>
        <source>Each pair is a point. Left and right arrow keys select the neighbouring pair, plus and minus zoom, Home shows the usual part, Space marks the selected pair, Escape takes the marks away.</source>
        <translation>每个帧对一个点。左右方向键选择相邻帧对，加号和减号缩放，Home 显示常用范围，空格标记所选帧对，Esc 取消标记。</translation>
    </message>
    <message>
        <source>not aligned</source>
        <translation>未配准</translation>
    </message>
    <message>
        <source>pair %1: %2, %3, %4</source>
        <translation>帧对 %1：%2，%3，%4</translation>
    </message>
    <message>
        <source>pair %1: %2, %3</source>
        <translation>帧对 %1：%2，%3</translation>
    </message>
    <message>
        <source>pair %1: %2 at %3, %4</source>
        <translation>帧对 %1：%2（横轴 %3），%4</translation>
    </message>
    <message>
        <source>No pairs yet: each pair becomes a point here.</source>
        <translation>还没有帧对：每个帧对将成为这里的一个点。</translation>
    </message>
    <message>
        <source>This method works without pairs.</source>
        <translation>该方法不使用帧对。</translation>
    </message>
    <message>
        <source>There are no pairs.</source>
        <translation>没有帧对。</translation>
    </message>
    <message>
        <source>Of no pair both values are known: choose others.</source>
        <translation>没有一个帧对的两个量都已知：请选择其他量。</translation>
    </message>
    <message>
        <source>No pair is shown: tick a state at the left.</source>
        <translation>没有显示帧对：请在左侧勾选一种状态。</translation>
    </message>
    <message>
        <source>≤ %1 pairs</source>
        <translation>≤ %1 个帧对</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ResidualsPanel</name>
    <message>
        <source>Reject marked</source>
        <translation>拒绝已标记</translation>
    </message>
    <message>
        <source>Draw a line around points with the left button: they are marked. With Shift they are marked beside those before.</source>
        <translation>按住左键围着点画一圈即可标记。按住 Shift 则在已有标记上追加。</translation>
    </message>
    <message>
        <source>What the plot holds</source>
        <translation>图中的内容</translation>
    </message>
    <message>
        <source>What the height of a point shows</source>
        <translation>点的高度表示什么</translation>
    </message>
    <message>
        <source>Over what it is drawn</source>
        <translation>横轴表示什么</translation>
    </message>
    <message>
        <source>x, y, z, roll, pitch and yaw are in the axes of the LiDAR at the later scan.</source>
        <translation>x、y、z、横滚、俯仰和偏航取较晚一次扫描时激光雷达的坐标轴。</translation>
    </message>
    <message>
        <source>over</source>
        <extracomment>between two lists: residual x over speed</extracomment>
        <translation>横轴</translation>
    </message>
    <message>
        <source>● accepted</source>
        <translation>● 已接受</translation>
    </message>
    <message>
        <source>✕ rejected</source>
        <translation>✕ 已拒绝</translation>
    </message>
    <message>
        <source>○ proposed</source>
        <translation>○ 待定</translation>
    </message>
    <message numerus="yes">
        <source>Reject %n marked</source>
        <translation>
            <numerusform>拒绝已标记的 %n 个</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n outside: double click</source>
        <translation>
            <numerusform>%n 个在范围外：双击</numerusform>
        </translation>
    </message>
    <message>
        <source>accepted: mean %1, std. dev. %2</source>
        <translation>已接受：均值 %1，标准差 %2</translation>
    </message>
    <message numerus="yes">
        <source>%n without a value</source>
        <translation>
            <numerusform>%n 个没有数值</numerusform>
        </translation>
    </message>
    <message>
        <source>marked in the plot: %1 over %2</source>
        <extracomment>why pairs were rejected: &quot;marked in the plot: residual x over speed&quot;</extracomment>
        <translation>在图中标记：%1（横轴：%2）</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ResultPanel</name>
    <message>
        <source>Solved</source>
        <translation>已求解</translation>
    </message>
    <message>
        <source>Solved, but not every direction</source>
        <translation>已求解，但不是每个方向</translation>
    </message>
    <message>
        <source>Not solved: too few pairs</source>
        <translation>未求解：帧对太少</translation>
    </message>
    <message>
        <source>Not solved: too little data</source>
        <translation>未求解：数据太少</translation>
    </message>
    <message>
        <source>Not solved: nothing of the data can be used</source>
        <translation>未求解：数据都不可用</translation>
    </message>
    <message>
        <source>Not solved: did not converge</source>
        <translation>未求解：没有收敛</translation>
    </message>
    <message>
        <source>Not solved: the solution lies outside the search range</source>
        <translation>未求解：解在搜索范围之外</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>ins_from_lidar (LiDAR to INS), R = Rz(yaw) Ry(pitch) Rx(roll)</source>
        <translation>ins_from_lidar（激光雷达到 INS），R = Rz(yaw) Ry(pitch) Rx(roll)</translation>
    </message>
    <message>
        <source>(not observed: do not rely on it)</source>
        <translation>（不可观测：不要依赖）</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Status of the result</source>
        <translation>结果的状态</translation>
    </message>
    <message>
        <source>Explanation of the result</source>
        <translation>结果的说明</translation>
    </message>
    <message>
        <source>What the result is compared with</source>
        <translation>结果与什么比较</translation>
    </message>
    <message>
        <source>1 sigma</source>
        <translation>1 倍标准差</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>变动</translation>
    </message>
    <message>
        <source>Value of %1</source>
        <translation>%1 的值</translation>
    </message>
    <message>
        <source>Sigma of %1</source>
        <translation>%1 的标准差</translation>
    </message>
    <message>
        <source>No result yet</source>
        <translation>还没有结果</translation>
    </message>
    <message>
        <source>▲ Out of date. It was: %1</source>
        <translation>▲ 已过期。原为：%1</translation>
    </message>
    <message>
        <source>… Result before: %1</source>
        <translation>… 之前的结果：%1</translation>
    </message>
    <message>
        <source>moved: since the calibration before</source>
        <translation>变动：自上次标定以来</translation>
    </message>
    <message>
        <source>moved: by “%1”</source>
        <translation>变动：由于“%1”</translation>
    </message>
    <message>
        <source>Not observed, and no nominal mounting is given: files hold 0</source>
        <translation>不可观测，且没有给出名义安装：文件中写 0</translation>
    </message>
    <message>
        <source>not observed</source>
        <translation>不可观测</translation>
    </message>
    <message>
        <source>From the information of the solution</source>
        <translation>来自解的信息矩阵</translation>
    </message>
    <message>
        <source>This drive says nothing about it: do not rely on the value shown</source>
        <translation>此次行驶对它没有任何信息：不要依赖显示的值</translation>
    </message>
    <message>
        <source>residuals: %1 cm, %2° (rms)</source>
        <translation>残差：%1 cm，%2°（均方根）</translation>
    </message>
    <message>
        <source>the clouds of all accepted pairs were aligned together as the last step</source>
        <translation>最后一步已把所有接受帧对的点云一起配准</translation>
    </message>
    <message>
        <source>solved from the aligned pairs; calibrate again (F5) to align their clouds together, too</source>
        <translation>由已配准的帧对求解；重新标定 (F5) 可把点云也一起配准</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>该怎么做</translation>
    </message>
    <message>
        <source>Not observed</source>
        <translation>不可观测</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>数据指标</translation>
    </message>
    <message>
        <source>Nominal and new</source>
        <translation>名义值与新值</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>名义值</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新值</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>after: result</source>
        <translation>之后：结果</translation>
    </message>
    <message>
        <source>before: nominal</source>
        <translation>之前：名义值</translation>
    </message>
    <message>
        <source>Map sharpness (lower is sharper)</source>
        <translation>地图清晰度（越低越清晰）</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>entropy</source>
        <translation>熵</translation>
    </message>
    <message>
        <source>&lt;b&gt;Correlations&lt;/b&gt;</source>
        <translation>&lt;b&gt;相关性&lt;/b&gt;</translation>
    </message>
    <message>
        <source>… Being completed: %1</source>
        <translation>… 正在补全：%1</translation>
    </message>
    <message>
        <source>Errors summed: E(X), the sum of ‖P X − X Q‖ over the accepted pairs (Frobenius norm), with P the motion of the INS and Q that of the LiDAR.</source>
        <translation>误差总和：E(X)，即已接受帧对的 ‖P X − X Q‖ 之和（Frobenius 范数），P 是 INS 的运动，Q 是激光雷达的运动。</translation>
    </message>
    <message>
        <source>X: LiDAR in INS</source>
        <translation>X：激光雷达在 INS 中</translation>
    </message>
    <message>
        <source>How far the value may be off: in two of three cases it is closer than this</source>
        <translation>数值可能偏差多少：三次中有两次比这更接近</translation>
    </message>
    <message>
        <source>errors of all accepted pairs, summed: %1</source>
        <translation>所有已接受帧对的误差总和：%1</translation>
    </message>
    <message>
        <source>Map sharpness: the result has moved since it was measured; see Quality.</source>
        <translation>地图清晰度：测量之后结果已变动；见“质量”。</translation>
    </message>
    <message>
        <source>X is the mounting: where the LiDAR sits in the frame of the INS (x, y, z) and how it is turned there (yaw, pitch, roll). Methods that know no INS say here in which frame X is instead.</source>
        <translation>X 即安装：激光雷达在 INS 坐标系中的位置（x、y、z）及其朝向（yaw、pitch、roll）。不涉及 INS 的方法在此说明 X 所在的坐标系。</translation>
    </message>
    <message>
        <source>X: LiDAR from antenna</source>
        <translation>X：激光雷达相对天线</translation>
    </message>
    <message>
        <source>X: LiDAR in machine</source>
        <translation>X：激光雷达在机器中</translation>
    </message>
    <message>
        <source>X: antenna in vehicle</source>
        <translation>X：天线在车辆中</translation>
    </message>
    <message>
        <source>X: sensor in vehicle</source>
        <translation>X：传感器在车辆中</translation>
    </message>
    <message>
        <source>Change since the result before; what made it is said below the numbers</source>
        <translation>相对于之前结果的变化；原因见数值下方</translation>
    </message>
    <message>
        <source>Not solved: nothing is observed</source>
        <translation>未求解：没有可观测的量</translation>
    </message>
    <message>
        <source>Preliminary: the calibration was cancelled</source>
        <translation>初步结果：标定已取消</translation>
    </message>
    <message>
        <source>(not observed)</source>
        <translation>（不可观测）</translation>
    </message>
    <message>
        <source>* with a value measured by hand</source>
        <translation>* 含手工测量值</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs: %1 accepted, %2 rejected</source>
        <translation>
            <numerusform>%n 个帧对：%1 个接受，%2 个拒绝</numerusform>
        </translation>
    </message>
    <message>
        <source>Do not trust this result</source>
        <translation>不要相信此结果</translation>
    </message>
    <message>
        <source>Without clock offset</source>
        <translation>不计时钟偏差</translation>
    </message>
    <message>
        <source>With clock offset</source>
        <translation>计入时钟偏差</translation>
    </message>
    <message>
        <source>X is solved with the offset that was found between the clocks of LiDAR and INS; solve it as if the clocks agreed</source>
        <translation>X 已按所发现的激光雷达与 INS 时钟偏差求解；点击则按时钟一致求解</translation>
    </message>
    <message>
        <source>The clocks of LiDAR and INS differ, and X is biased by it; solve X with the offset that was found</source>
        <translation>激光雷达与 INS 的时钟不一致，X 因此有偏；点击则按所发现的偏差求解 X</translation>
    </message>
    <message>
        <source>Bootstrap over blocks of time: %1</source>
        <translation>按时间块重采样：%1</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ScaleBar</name>
    <message>
        <source>Scale</source>
        <translation>比例尺</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 in the middle</source>
        <translation>中心处 %1</translation>
    </message>
</context>
<context>
    <name>remount::widgets::SceneView</name>
    <message>
        <source>Picked point</source>
        <translation>选取的点</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>明暗</translation>
    </message>
    <message>
        <source>Eye-dome lighting: darkens edges of depth, which makes shapes easier to see</source>
        <translation>眼穹光照：使深度的边缘变暗，形状更易看清</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Click two points for the distance between them, in m. Esc ends it. Without it a click tells the coordinates of a point.</source>
        <translation>点击两个点，得到它们之间的距离（米）。Esc 结束。不测量时，点击给出一个点的坐标。</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Standard views. Drag orbits, Shift drag pans, the wheel zooms.</source>
        <translation>标准视图。拖动旋转，Shift 拖动平移，滚轮缩放。</translation>
    </message>
    <message>
        <source>The 3-D view is not available: %1.
Everything else works.</source>
        <translation>三维视图不可用：%1。
其他功能都正常。</translation>
    </message>
    <message>
        <source>Click the first of two points. Esc ends measuring.</source>
        <translation>点击两个点中的第一个。Esc 结束测量。</translation>
    </message>
    <message>
        <source>There is no point here.</source>
        <translation>这里没有点。</translation>
    </message>
    <message>
        <source>Click the second point.</source>
        <translation>点击第二个点。</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Distance %1 (x %2, y %3, z %4 m in %5). Esc ends measuring.</source>
        <translation>距离 %1（在%5中 x %2，y %3，z %4 m）。Esc 结束测量。</translation>
    </message>
    <message>
        <source>Turn about this point</source>
        <translation>绕该点旋转</translation>
    </message>
    <message>
        <source>Parallel, without perspective</source>
        <translation>平行投影（无透视）</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>view.png</source>
        <translation>view.png</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>图片 (*.png)</translation>
    </message>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>无法写入图片：%1</translation>
    </message>
</context>
<context>
    <name>remount::widgets::SectionPanel</name>
    <message>
        <source>Wall</source>
        <translation>墙</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Pole</source>
        <translation>杆</translation>
    </message>
    <message>
        <source>Surface that is cut</source>
        <translation>剖切的表面</translation>
    </message>
    <message>
        <source>Walls show sideways errors and yaw, the ground height, roll and pitch, poles both level axes</source>
        <translation>墙显示侧向误差和偏航角，地面显示高度、横滚和俯仰，杆显示两个水平方向</translation>
    </message>
    <message>
        <source>Next place</source>
        <translation>下一处</translation>
    </message>
    <message>
        <source>The next of the surfaces that both scans see well</source>
        <translation>两次扫描都看得清楚的下一个表面</translation>
    </message>
    <message>
        <source>Select a pair to see a section through its two scans.</source>
        <translation>选择一个帧对，查看穿过其两次扫描的剖面。</translation>
    </message>
    <message>
        <source>place %1 of %2, %3 m from the LiDAR</source>
        <translation>第 %1 处，共 %2 处，距激光雷达 %3 m</translation>
    </message>
    <message>
        <source>chosen place, %1 m from the LiDAR</source>
        <translation>所选位置，距激光雷达 %1 m</translation>
    </message>
</context>
<context>
    <name>remount::widgets::SectionPlot</name>
    <message>
        <source>too few points</source>
        <translation>点太少</translation>
    </message>
    <message>
        <source>axes %1 mm apart; radius %2 mm together (a %3, b %4)</source>
        <translation>轴线相距 %1 mm；合在一起半径 %2 mm（a %3，b %4）</translation>
    </message>
    <message>
        <source>%1 mm thick together (a %2, b %3), %4</source>
        <translation>合在一起厚 %1 mm（a %2，b %3），%4</translation>
    </message>
    <message>
        <source>a on b</source>
        <translation>a 与 b 重合</translation>
    </message>
    <message>
        <source>a %1 mm before b</source>
        <translation>a 在 b 前方 %1 mm</translation>
    </message>
    <message>
        <source>a %1 mm behind b</source>
        <translation>a 在 b 后方 %1 mm</translation>
    </message>
    <message>
        <source>Section through the pair</source>
        <translation>穿过该帧对的剖面</translation>
    </message>
    <message>
        <source>A slab through a surface that both scans see. The thinner it is, the better the scans lie on each other.
Dragging to the side, Left and Right move it along the surface, Up and Down to the side of the slab.</source>
        <translation>穿过两次扫描都看到的表面的薄片。越薄，两次扫描重合得越好。
左右拖动或按左右键沿表面移动，上下键横向移动。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 m along the surface, mm across it</source>
        <translation>沿表面 %1 m，垂直方向为 mm</translation>
    </message>
    <message>
        <source>%1 mm, a %2</source>
        <translation>%1 mm，a %2</translation>
    </message>
</context>
<context>
    <name>remount::widgets::SessionListModel</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 INS samples</source>
        <translation>%1 个 INS 样本</translation>
    </message>
    <message>
        <source>%1 INS poses</source>
        <translation>%1 个 INS 位姿</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>What to do: %1</source>
        <translation>处理办法：%1</translation>
    </message>
    <message>
        <source>%1 LiDAR poses in %2, no scans</source>
        <translation>%2 内 %1 个激光雷达位姿，没有扫描</translation>
    </message>
    <message>
        <source>%1 of %2 pairs accepted</source>
        <translation>%2 个帧对中接受 %1 个</translation>
    </message>
    <message>
        <source>not in the result: it has no pairs</source>
        <translation>未用于结果：没有帧对</translation>
    </message>
    <message>
        <source>not in the result: none of its %1 pairs is accepted</source>
        <translation>未用于结果：其 %1 个帧对无一被接受</translation>
    </message>
    <message numerus="yes">
        <source>%n scans in %1</source>
        <translation>
            <numerusform>%1 内 %n 帧扫描</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>remount::widgets::SessionsBelowDialog</name>
    <message>
        <source>Which sessions?</source>
        <translation>要打开哪些数据？</translation>
    </message>
    <message numerus="yes">
        <source>%1 is no session itself, but %n session(s) lie in it. Open together those of one vehicle between which the LiDAR was not moved.</source>
        <translation>
            <numerusform>%1 本身不是数据，但其中有 %n 份数据。请只一起打开同一辆车、期间激光雷达未被移动过的数据。</numerusform>
        </translation>
    </message>
    <message>
        <source>Sessions in the folder</source>
        <translation>文件夹中的数据</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
</context>
<context>
    <name>remount::widgets::SessionsPanel</name>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Open sessions and findings</source>
        <translation>打开的数据和发现的问题</translation>
    </message>
    <message>
        <source>A folder or file with a recorded drive; several drives of one vehicle are calibrated together</source>
        <translation>含有行驶记录的文件夹或文件；同一车辆的多次行驶一起标定</translation>
    </message>
    <message>
        <source>Topics…</source>
        <translation>话题…</translation>
    </message>
    <message>
        <source>Which topics of a bag the session is made of</source>
        <translation>数据由 bag 中的哪些话题组成</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
</context>
<context>
    <name>remount::widgets::SharpnessView</name>
    <message>
        <source>result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>名义值</translation>
    </message>
    <message>
        <source>candidate: %1</source>
        <translation>候选：%1</translation>
    </message>
    <message>
        <source>The scans do not overlap enough.</source>
        <translation>扫描重叠不够。</translation>
    </message>
    <message>
        <source>Under which mounting the map is sharper</source>
        <translation>哪种安装下地图更清晰</translation>
    </message>
    <message>
        <source>Sharpness of the accumulated map</source>
        <translation>累积地图的清晰度</translation>
    </message>
    <message>
        <source>Map under the result</source>
        <translation>结果下的地图</translation>
    </message>
    <message>
        <source>Lower is sharper. Thickness: how thick flat surfaces are, in mm. Entropy: mean map entropy, no unit.</source>
        <translation>越低越清晰。厚度：平坦表面的厚度，单位毫米。熵：平均地图熵，无单位。</translation>
    </message>
    <message>
        <source>Shows the accumulated map as it was with the mounting before</source>
        <translation>显示先前安装下的累积地图</translation>
    </message>
    <message>
        <source>Shows the accumulated map as it is with the new mounting</source>
        <translation>显示新安装下的累积地图</translation>
    </message>
    <message>
        <source>Map under the nominal</source>
        <translation>名义下的地图</translation>
    </message>
    <message>
        <source>Map under the %1</source>
        <translation>%1下的地图</translation>
    </message>
    <message>
        <source>surfaces are %1 mm thick under the result, %2 mm under the nominal</source>
        <translation>表面厚度在结果下为 %1 mm，在名义下为 %2 mm</translation>
    </message>
    <message>
        <source>The map became sharper: %1.</source>
        <translation>地图变清晰了：%1。</translation>
    </message>
    <message>
        <source>The map became blunter: %1.</source>
        <translation>地图变模糊了：%1。</translation>
    </message>
    <message>
        <source>No clear difference: %1.</source>
        <translation>没有明显差别：%1。</translation>
    </message>
    <message>
        <source>No nominal mounting was given: there is nothing before to compare with.</source>
        <translation>没有给出名义安装：没有可比较的先前状态。</translation>
    </message>
    <message>
        <source>The same places are compared under every mounting</source>
        <translation>在每种安装下比较相同的位置</translation>
    </message>
    <message>
        <source>Mounting</source>
        <translation>安装</translation>
    </message>
    <message>
        <source>Thickness [mm]</source>
        <translation>厚度 [mm]</translation>
    </message>
    <message>
        <source>Entropy</source>
        <translation>熵</translation>
    </message>
    <message>
        <source>Places compared</source>
        <translation>比较的位置数</translation>
    </message>
    <message>
        <source>Too few places to tell: %1.</source>
        <translation>可比较的位置太少，无法判断：%1。</translation>
    </message>
    <message>
        <source>Fewer than %1 places could be compared: the order of the rows says nothing.</source>
        <translation>可比较的地点不到 %1 处：各行的顺序说明不了什么。</translation>
    </message>
    <message>
        <source>Clearly sharper than the result: %1. Look at its map and at the pairs before you use the result.</source>
        <translation>明显比结果更清晰：%1。使用结果之前请查看它的地图和各帧对。</translation>
    </message>
    <message>
        <source>No row is clearly sharper than the result. Differences below %1 % (here %2 mm) are less than this measure can tell: the order of such rows is chance.</source>
        <translation>没有哪一行明显比结果更清晰。小于 %1 %（此处 %2 mm）的差别是这一指标分辨不了的：这些行的顺序出于偶然。</translation>
    </message>
</context>
<context>
    <name>remount::widgets::SigmaBars</name>
    <message>
        <source>What the sigma of each parameter is made of</source>
        <translation>每个参数的 sigma 由什么构成</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>俯仰</translation>
    </message>
    <message>
        <source>%1: %2
%3, %4 % of the variance</source>
        <translation>%1：%2
%3，占方差的 %4 %</translation>
    </message>
    <message>
        <source>not observed</source>
        <translation>未观测</translation>
    </message>
</context>
<context>
    <name>remount::widgets::SigmaBudgetView</name>
    <message>
        <source>Parts of the sigmas</source>
        <translation>sigma 的各组成部分</translation>
    </message>
    <message>
        <source>After a calibration: where the sigma of each parameter comes from.</source>
        <translation>标定之后：每个参数的 sigma 从何而来。</translation>
    </message>
    <message>
        <source>Each bar is the variance (sigma squared) of a parameter, parted by where it comes from; the table has the root of each part. The widest part is what to make better first.</source>
        <translation>每根条是一个参数的方差（sigma 的平方），按来源划分；表中为各部分的平方根。最宽的部分最值得先改进。</translation>
    </message>
    <message>
        <source>This result does not tell what its sigmas are made of: it is of another method, of several LiDARs together, of a former version, or has no usable X.</source>
        <translation>此结果没有说明其 sigma 的构成：它来自其他方法、多个激光雷达的共同解或旧版本，或没有可用的 X。</translation>
    </message>
</context>
<context>
    <name>remount::widgets::StepBar</name>
    <message>
        <source>Open the recorded sessions of one vehicle</source>
        <translation>打开一辆车的行驶记录</translation>
    </message>
    <message>
        <source>Choose scans and pair those that see the same objects</source>
        <translation>选择扫描，并把看到相同物体的扫描配成对</translation>
    </message>
    <message>
        <source>Align the two scans of every pair</source>
        <translation>配准每个帧对的两次扫描</translation>
    </message>
    <message>
        <source>Look at the pairs and decide on doubtful ones</source>
        <translation>查看帧对，对可疑的作出决定</translation>
    </message>
    <message>
        <source>The mounting that explains the pairs</source>
        <translation>能解释各帧对的安装位置</translation>
    </message>
    <message>
        <source>Write the result for other software</source>
        <translation>为其他软件写出结果</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>载入</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>帧对</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>审查</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>求解</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>running</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>needs attention</source>
        <translation>需要注意</translation>
    </message>
    <message>
        <source>Step %1: %2, %3</source>
        <translation>第 %1 步：%2，%3</translation>
    </message>
    <message>
        <source>See by other means than residuals that it is right</source>
        <translation>用残差以外的方法确认结果正确</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
</context>
<context>
    <name>remount::widgets::TopicsDialog</name>
    <message>
        <source>&amp;LiDAR</source>
        <translation>激光雷达(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;INS</source>
        <translation>INS(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Position of the INS</source>
        <translation>INS 的位置(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;GNSS</source>
        <translation>GNSS(&amp;G)</translation>
    </message>
    <message>
        <source>I&amp;MU</source>
        <translation>IMU(&amp;M)</translation>
    </message>
    <message>
        <source>nominal mounting</source>
        <translation>名义安装</translation>
    </message>
    <message>
        <source>Topics of %1</source>
        <translation>%1 的话题</translation>
    </message>
    <message>
        <source>Which topics is the session made of? The most likely ones are selected; the table says what speaks for each. A project keeps the choice.</source>
        <translation>数据由哪些话题组成？已选中最可能的话题；表中说明各话题的依据。项目会保存所做的选择。</translation>
    </message>
    <message>
        <source>What prevents it</source>
        <translation>阻碍原因</translation>
    </message>
    <message>
        <source>As it was</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>Selects again what was selected when this was opened</source>
        <translation>重新选中打开此窗口时所选的话题</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Topic that serves as %1</source>
        <translation>用作%1的话题</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>话题</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>消息数</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>Can serve as</source>
        <translation>可用作</translation>
    </message>
    <message>
        <source>Serves as</source>
        <translation>用作</translation>
    </message>
    <message>
        <source>What speaks for or against it</source>
        <translation>依据</translation>
    </message>
    <message>
        <source>All topics of the recording</source>
        <translation>记录中的全部话题</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>cannot be used: %1</source>
        <translation>不能使用：%1</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>One topic cannot be LiDAR and INS: a motion that is compared with itself tells nothing.</source>
        <translation>同一话题不能既作激光雷达又作 INS：运动与自身比较说明不了任何问题。</translation>
    </message>
    <message>
        <source>An orientation alone is no INS: choose the topic that gives its position.</source>
        <translation>仅有姿态不足以作为 INS：请选择给出其位置的话题。</translation>
    </message>
    <message>
        <source>An orientation alone is no INS, and no topic here gives its position: choose another INS, or none.</source>
        <translation>仅有姿态不足以作为 INS，而此处没有话题给出其位置：请选择其他 INS，或选“无”。</translation>
    </message>
    <message>
        <source>the INS gives its position itself</source>
        <translation>INS 自身给出位置</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>不使用</translation>
    </message>
    <message>
        <source>Of several LiDARs choose the one that is shown first: the panel “LiDARs” calibrates all of them together.</source>
        <translation>有多台激光雷达时，请选择先显示的一台：“激光雷达”面板可将它们全部联合标定。</translation>
    </message>
</context>
<context>
    <name>remount::widgets::ValueLegend</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>remount::widgets::VehiclePicture</name>
    <message>
        <source>The vehicle with its LiDARs</source>
        <translation>车辆及其激光雷达</translation>
    </message>
    <message>
        <source>Axes: x red, y green, z blue; of the INS and of each LiDAR. Coloured sectors: where a LiDAR looks. Thin dashed axes: the nominal mounting.</source>
        <translation>坐标轴：x 红、y 绿、z 蓝，分别属于 INS 和各激光雷达。彩色扇形：激光雷达的视场。细虚线轴：名义安装。</translation>
    </message>
    <message>
        <source>INS</source>
        <translation>INS</translation>
    </message>
    <message>
        <source>The vehicle is drawn here when its LiDARs are calibrated together.</source>
        <translation>联合标定激光雷达之后，此处画出车辆。</translation>
    </message>
    <message>
        <source>From above, forward to the right</source>
        <translation>俯视，前方朝右</translation>
    </message>
    <message>
        <source>From its right side</source>
        <translation>右侧视图</translation>
    </message>
    <message>
        <source>From its right side; heights are known against each other alone, or not at all</source>
        <translation>右侧视图；高度只知相对值，或完全未知</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
<context>
    <name>remount::widgets::WelcomePanel</name>
    <message>
        <source>Open the sample session</source>
        <translation>打开示例数据</translation>
    </message>
    <message>
        <source>&lt;b&gt;Opened lately&lt;/b&gt;</source>
        <translation>&lt;b&gt;最近打开&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>打开 %1</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>&lt;h2&gt;Where does the LiDAR sit now?&lt;/h2&gt;&lt;p&gt;Drop the folder or the file of a recorded drive here, or open one. A drive holds LiDAR scans (or LiDAR poses) and the log of the GNSS/INS. Several drives of one vehicle are calibrated together.&lt;/p&gt;&lt;ol&gt;&lt;li&gt;Open the sessions.&lt;/li&gt;&lt;li&gt;Say roughly where the LiDAR sits, or leave it unknown.&lt;/li&gt;&lt;li&gt;Calibrate (F5).&lt;/li&gt;&lt;li&gt;Look at the pairs; accept or reject the doubtful ones.&lt;/li&gt;&lt;li&gt;Export the result.&lt;/li&gt;&lt;/ol&gt;</source>
        <translation>&lt;h2&gt;激光雷达现在装在哪里？&lt;/h2&gt;&lt;p&gt;把行驶记录的文件夹或文件拖到这里，或打开一个。一次行驶包含激光雷达扫描（或激光雷达位姿）和 GNSS/INS 的记录。同一车辆的多次行驶一起标定。&lt;/p&gt;&lt;ol&gt;&lt;li&gt;打开数据。&lt;/li&gt;&lt;li&gt;说出激光雷达大致装在哪里，或者留作未知。&lt;/li&gt;&lt;li&gt;标定 (F5)。&lt;/li&gt;&lt;li&gt;查看帧对；接受或拒绝可疑的帧对。&lt;/li&gt;&lt;li&gt;导出结果。&lt;/li&gt;&lt;/ol&gt;</translation>
    </message>
</context>
<context>
    <name>remount::widgets::axes_picture</name>
    <message>
        <source>seen from above</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>seen from the right</source>
        <translation>从右侧看</translation>
    </message>
</context>
<context>
    <name>remount::widgets::choices</name>
    <message>
        <source>where the data call for it</source>
        <translation>数据需要时</translation>
    </message>
    <message>
        <source>always</source>
        <translation>总是</translation>
    </message>
    <message>
        <source>never</source>
        <translation>从不</translation>
    </message>
    <message>
        <source>after a distance</source>
        <translation>按距离</translation>
    </message>
    <message>
        <source>after a time</source>
        <translation>按时间</translation>
    </message>
    <message>
        <source>where one shows too little</source>
        <translation>单次覆盖太少时</translation>
    </message>
    <message>
        <source>so many scans</source>
        <translation>按设定的次数</translation>
    </message>
    <message>
        <source>close in time</source>
        <translation>时间相近</translation>
    </message>
    <message>
        <source>close in distance</source>
        <translation>距离相近</translation>
    </message>
    <message>
        <source>close in either</source>
        <translation>时间或距离相近</translation>
    </message>
    <message>
        <source>plane to plane (own engine)</source>
        <translation>面对面（自有引擎）</translation>
    </message>
    <message>
        <source>ICP (PCL)</source>
        <translation>ICP (PCL)</translation>
    </message>
    <message>
        <source>GICP (PCL)</source>
        <translation>GICP (PCL)</translation>
    </message>
    <message>
        <source>NDT (PCL)</source>
        <translation>NDT (PCL)</translation>
    </message>
    <message>
        <source>the ground (A)</source>
        <translation>地面 (A)</translation>
    </message>
    <message>
        <source>the LiDAR&apos;s circle (B)</source>
        <translation>激光雷达的圆 (B)</translation>
    </message>
    <message>
        <source>height of the LiDAR&apos;s circle</source>
        <translation>激光雷达圆的高度</translation>
    </message>
    <message>
        <source>height of the ground</source>
        <translation>地面的高度</translation>
    </message>
    <message>
        <source>known (metres)</source>
        <translation>已知（米）</translation>
    </message>
    <message>
        <source>to be estimated</source>
        <translation>待估计</translation>
    </message>
    <message>
        <source>where it is clear</source>
        <translation>明确时才用</translation>
    </message>
    <message>
        <source>without errors (simulated)</source>
        <translation>无误差（仿真）</translation>
    </message>
    <message>
        <source>spinning, with rings</source>
        <translation>旋转式，有线环</translation>
    </message>
    <message>
        <source>solid-state, without rings</source>
        <translation>固态，无线环</translation>
    </message>
    <message>
        <source>any of these</source>
        <translation>以上任一种</translation>
    </message>
    <message>
        <source>as the session says</source>
        <translation>按会话所述</translation>
    </message>
    <message>
        <source>by the numbers below</source>
        <translation>按下面的数值</translation>
    </message>
    <message>
        <source>as many as X needs</source>
        <translation>足以确定 X 的部分</translation>
    </message>
    <message>
        <source>every one</source>
        <translation>全部</translation>
    </message>
</context>
<context>
    <name>remount::widgets::flag_mentions</name>
    <message>
        <source>“%1”</source>
        <translation>“%1”</translation>
    </message>
    <message>
        <source>“%1: %2”</source>
        <translation>“%1：%2”</translation>
    </message>
    <message>
        <source>“%1: %2 – %3”</source>
        <translation>“%1：%2 – %3”</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Nominal mounting</source>
        <translation>名义安装</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>在%1中</translation>
    </message>
    <message>
        <source>the method %1</source>
        <translation>方法 %1</translation>
    </message>
    <message>
        <source>the panel “%1”</source>
        <translation>“%1”面板</translation>
    </message>
</context>
<context>
    <name>remount::widgets::gl_support</name>
    <message>
        <source>the display platform &quot;%1&quot; has no OpenGL</source>
        <translation>显示平台“%1”没有 OpenGL</translation>
    </message>
    <message>
        <source>no OpenGL context could be made; over a remote connection, allow GLX or use a local display</source>
        <translation>无法建立 OpenGL 上下文；远程连接时请允许 GLX 或使用本地显示</translation>
    </message>
    <message>
        <source>the OpenGL context cannot be used</source>
        <translation>OpenGL 上下文无法使用</translation>
    </message>
    <message>
        <source>OpenGL 3.2 is needed, this display offers %1.%2</source>
        <translation>需要 OpenGL 3.2，此显示只有 %1.%2</translation>
    </message>
</context>
<context>
    <name>remount::widgets::import_words</name>
    <message>
        <source>Heading from north, clockwise; nose up positive</source>
        <translation>航向自北顺时针；抬头为正</translation>
    </message>
    <message>
        <source>Yaw from east, counter-clockwise; nose down positive</source>
        <translation>偏航自东逆时针；低头为正</translation>
    </message>
    <message>
        <source>NovAtel: azimuth from north, axes right-forward-up</source>
        <translation>NovAtel：方位角自北，轴为右-前-上</translation>
    </message>
    <message>
        <source>Quaternion, vehicle to east-north-up (ROS)</source>
        <translation>四元数，车体到东-北-天（ROS）</translation>
    </message>
    <message>
        <source>Quaternion, forward-right-down to north-east-down</source>
        <translation>四元数，前-右-下到北-东-地</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>milliseconds</source>
        <translation>毫秒</translation>
    </message>
    <message>
        <source>microseconds</source>
        <translation>微秒</translation>
    </message>
    <message>
        <source>nanoseconds</source>
        <translation>纳秒</translation>
    </message>
    <message>
        <source>date or time of day</source>
        <translation>日期或时刻文本</translation>
    </message>
    <message>
        <source>UTC, since 1970 (Unix)</source>
        <translation>UTC，自 1970 年（Unix）</translation>
    </message>
    <message>
        <source>GPS, since 1980 or of a week</source>
        <translation>GPS，自 1980 年或按周</translation>
    </message>
    <message>
        <source>GPS, of a week that is not given</source>
        <translation>GPS 周内秒，未给出周数</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>angles in degrees</source>
        <translation>角度以度计</translation>
    </message>
    <message>
        <source>angles in radians</source>
        <translation>角度以弧度计</translation>
    </message>
    <message>
        <source>heading turned round</source>
        <translation>航向反向</translation>
    </message>
    <message>
        <source>pitch turned round</source>
        <translation>俯仰反向</translation>
    </message>
    <message>
        <source>roll turned round</source>
        <translation>横滚反向</translation>
    </message>
    <message>
        <source>heading as usual</source>
        <translation>航向不反向</translation>
    </message>
    <message>
        <source>pitch as usual</source>
        <translation>俯仰不反向</translation>
    </message>
    <message>
        <source>roll as usual</source>
        <translation>横滚不反向</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>弧度</translation>
    </message>
    <message>
        <source>degrees and minutes (ddmm.mmmm)</source>
        <translation>度与分连写（ddmm.mmmm）</translation>
    </message>
    <message>
        <source>ten-millionths of a degree</source>
        <translation>千万分之一度</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>position in %1</source>
        <translation>位置单位为%1</translation>
    </message>
</context>
<context>
    <name>remount::widgets::option_changes</name>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>%1 (%2): %3, now %4</source>
        <translation>%1（%2）：%3，现在为 %4</translation>
    </message>
</context>
<context>
    <name>remount::widgets::option_mentions</name>
    <message>
        <source>“%1” (%2)</source>
        <translation>“%1”（%2）</translation>
    </message>
</context>
<context>
    <name>remount::widgets::pair_measure</name>
    <message>
        <source>Residual translation</source>
        <translation>平移残差</translation>
    </message>
    <message>
        <source>Residual rotation</source>
        <translation>旋转残差</translation>
    </message>
    <message>
        <source>Alignment RMSE</source>
        <translation>配准 RMSE</translation>
    </message>
    <message>
        <source>INS against LiDAR</source>
        <translation>INS 对激光雷达</translation>
    </message>
</context>
<context>
    <name>remount::widgets::residual_values</name>
    <message>
        <source>Residual x</source>
        <translation>残差 x</translation>
    </message>
    <message>
        <source>Residual y</source>
        <translation>残差 y</translation>
    </message>
    <message>
        <source>Residual z</source>
        <translation>残差 z</translation>
    </message>
    <message>
        <source>Residual roll</source>
        <translation>横滚残差</translation>
    </message>
    <message>
        <source>Residual pitch</source>
        <translation>俯仰残差</translation>
    </message>
    <message>
        <source>Residual yaw</source>
        <translation>偏航残差</translation>
    </message>
    <message>
        <source>Overlap of the scans</source>
        <translation>扫描重叠率</translation>
    </message>
    <message>
        <source>Time in the session</source>
        <translation>数据内的时间</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>转动角速度</translation>
    </message>
    <message>
        <source>Time between the scans</source>
        <translation>两次扫描的时间差</translation>
    </message>
    <message>
        <source>Distance between the scans</source>
        <translation>两次扫描的距离</translation>
    </message>
    <message>
        <source>Rotation between the scans</source>
        <translation>两次扫描的转角</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>数据</translation>
    </message>
</context>
<context>
    <name>remount::widgets::theme</name>
    <message>
        <source>✓ accepted by you</source>
        <translation>✓ 由您接受</translation>
    </message>
    <message>
        <source>✓ accepted</source>
        <translation>✓ 已接受</translation>
    </message>
    <message>
        <source>✕ rejected by you</source>
        <translation>✕ 由您拒绝</translation>
    </message>
    <message>
        <source>✕ rejected</source>
        <translation>✕ 已拒绝</translation>
    </message>
    <message>
        <source>• proposed</source>
        <translation>• 待定</translation>
    </message>
</context>
</TS>
