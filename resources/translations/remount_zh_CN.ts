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
    <name>plot</name>
    <message>
        <source>No values.</source>
        <translation>没有数值。</translation>
    </message>
</context>
<context>
    <name>remount::Autosave</name>
    <message>
        <source>the disk does not answer</source>
        <translation>磁盘没有响应</translation>
    </message>
</context>
<context>
    <name>remount::Calibrations</name>
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
    <name>remount::CandidatePlot</name>
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
    <name>remount::CandidateTableModel</name>
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
    <name>remount::CandidatesFeature</name>
    <message>
        <source>Candidates</source>
        <translation>候选</translation>
    </message>
</context>
<context>
    <name>remount::CandidatesPanel</name>
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
    <name>remount::ClearancePlot</name>
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
    <name>remount::ClearanceView</name>
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
    <name>remount::ComparisonView</name>
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
    <name>remount::CorrelationChart</name>
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
    <name>remount::Decisions</name>
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
</context>
<context>
    <name>remount::DistanceLegend</name>
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
</context>
<context>
    <name>remount::DriveFeature</name>
    <message>
        <source>Drive</source>
        <translation>行驶</translation>
    </message>
</context>
<context>
    <name>remount::DriveMap</name>
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
    <name>remount::DrivePanel</name>
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
        <translation>惯导</translation>
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
    <name>remount::DriveTimeline</name>
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
        <translation>惯导</translation>
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
    <name>remount::ErrorBarChart</name>
    <message>
        <source>Error of each pair</source>
        <translation>每个帧对的误差</translation>
    </message>
    <message>
        <source>One bar per pair. Left and right arrow keys select the neighbouring pair; up and down move the line above which Return rejects, Escape puts it back.</source>
        <translation>每个帧对一根柱。左右方向键选择相邻帧对；上下方向键移动阈值线，回车拒绝线以上的帧对，Esc 复位。</translation>
    </message>
    <message>
        <source>Drag: what is above the line is rejected when you let go.
In the chart: Up and Down move it, Return rejects, Escape puts it back.</source>
        <translation>拖动：松开时拒绝线以上的帧对。
在图中：上下方向键移动阈值线，回车拒绝，Esc 复位。</translation>
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
        <source>pair %1: %2</source>
        <translation>帧对 %1：%2</translation>
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
</context>
<context>
    <name>remount::ErrorChartPanel</name>
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
</context>
<context>
    <name>remount::ExportDialog</name>
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
</context>
<context>
    <name>remount::HelpFeature</name>
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
    <name>remount::HelpWindow</name>
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
    <name>remount::HoldOutView</name>
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
    <name>remount::InputFiles</name>
    <message>
        <source>is not as it was when the result that is shown was made. Calibrate again (F5).</source>
        <translation>与得到所示结果时不同。请重新标定 (F5)。</translation>
    </message>
</context>
<context>
    <name>remount::JobRunner</name>
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
    <name>remount::KeyBindings</name>
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
    <name>remount::KeysDialog</name>
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
    <name>remount::LogFeature</name>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
</context>
<context>
    <name>remount::LogPanel</name>
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
    <name>remount::MainWindow</name>
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
</context>
<context>
    <name>remount::MapController</name>
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
    <name>remount::MapFeature</name>
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
    <name>remount::MapView</name>
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
    <name>remount::Menus</name>
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
    <name>remount::MessageBanner</name>
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
    <name>remount::MethodChooser</name>
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
    <name>remount::MethodController</name>
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
    <name>remount::MethodView</name>
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
    <name>remount::MethodsFeature</name>
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
    <name>remount::MissingSessionsDialog</name>
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
    <name>remount::NominalPanel</name>
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
    <name>remount::ObstacleDialog</name>
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
    <name>remount::OptionForm</name>
    <message>
        <source>In files: %1</source>
        <translation>文件中：%1</translation>
    </message>
</context>
<context>
    <name>remount::OptionsDialog</name>
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
</context>
<context>
    <name>remount::Outcome</name>
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
    <name>remount::PairTableModel</name>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>What was decided about the pair, and by whom</source>
        <translation>对该帧对作出的决定，以及由谁作出</translation>
    </message>
    <message>
        <source>Δt [cm]</source>
        <translation>Δt [cm]</translation>
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
</context>
<context>
    <name>remount::PairView</name>
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
        <source>Scan a:</source>
        <translation>扫描 a：</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>橙色</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>蓝色</translation>
    </message>
    <message>
        <source>By distance</source>
        <translation>按距离</translation>
    </message>
    <message>
        <source>Colour of scan a</source>
        <translation>扫描 a 的颜色</translation>
    </message>
    <message>
        <source>One colour, or the distance of each point to the surfaces of scan b, in m</source>
        <translation>单一颜色，或每个点到扫描 b 表面的距离（米）</translation>
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
</context>
<context>
    <name>remount::PairViewFeature</name>
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
</context>
<context>
    <name>remount::PairsFeature</name>
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
</context>
<context>
    <name>remount::PairsPanel</name>
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
        <source>Shows pairs of this number, or with this text in state, session or reason</source>
        <translation>显示此编号的帧对，或状态、数据、理由中含有此文字的帧对</translation>
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
</context>
<context>
    <name>remount::PathView</name>
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
    <name>remount::PlotView</name>
    <message>
        <source>Plots of the method</source>
        <translation>该方法的曲线</translation>
    </message>
</context>
<context>
    <name>remount::ProgressStrip</name>
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
    <name>remount::ProjectDocument</name>
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
    <name>remount::ProjectFeature</name>
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
    <name>remount::ProjectKeeper</name>
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
    <name>remount::QualityController</name>
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
    <name>remount::QualityFeature</name>
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
    <name>remount::QualityView</name>
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
</context>
<context>
    <name>remount::RangePanel</name>
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
    <name>remount::RecoveryDialog</name>
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
    <name>remount::ReportMaker</name>
    <message>
        <source>No pictures of pairs: %1.</source>
        <translation>没有帧对图片：%1。</translation>
    </message>
    <message>
        <source>Report: picture of pair %1…</source>
        <translation>报告：帧对 %1 的图片…</translation>
    </message>
    <message>
        <source>Pair %1 cannot be pictured: %2</source>
        <translation>无法绘制帧对 %1：%2</translation>
    </message>
    <message>
        <source>No pictures of pairs: they come from LiDAR poses, without scans.</source>
        <translation>没有帧对图片：帧对来自激光雷达位姿，没有扫描。</translation>
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
        <source>could not be made</source>
        <translation>无法生成</translation>
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
</context>
<context>
    <name>remount::ResultFeature</name>
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
        <source>Replace files</source>
        <translation>替换文件</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) exist already. Replace?</source>
        <translation>
            <numerusform>已存在 %n 个文件。要替换吗？</numerusform>
        </translation>
    </message>
    <message>
        <source>Nominal mounting</source>
        <translation>名义安装</translation>
    </message>
</context>
<context>
    <name>remount::ResultPanel</name>
    <message>
        <source>Solved</source>
        <translation>已求解</translation>
    </message>
    <message>
        <source>Solved, but not every direction</source>
        <translation>已求解，但不是每个方向</translation>
    </message>
    <message>
        <source>Not solved: too little data</source>
        <translation>未求解：数据太少</translation>
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
        <source>Bootstrap over blocks of time: ± %1</source>
        <translation>按时间块重采样：± %1</translation>
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
        <translation>X 即安装：激光雷达在惯导坐标系中的位置（x、y、z）及其朝向（yaw、pitch、roll）。不涉及惯导的方法在此说明 X 所在的坐标系。</translation>
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
</context>
<context>
    <name>remount::RunFeature</name>
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
    <name>remount::SceneController</name>
    <message>
        <source>candidate %1</source>
        <translation>候选 %1</translation>
    </message>
</context>
<context>
    <name>remount::SceneView</name>
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
</context>
<context>
    <name>remount::SessionEdits</name>
    <message>
        <source>Wait until the present work is done, or cancel it, before choosing other topics.</source>
        <translation>请等待当前工作完成，或先取消，再选择其他话题。</translation>
    </message>
    <message>
        <source>offers no topics any more</source>
        <translation>不再提供话题</translation>
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
    <name>remount::SessionList</name>
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
    <name>remount::SessionListModel</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 INS samples</source>
        <translation>%1 个 INS 采样</translation>
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
    <name>remount::SessionsBelowDialog</name>
    <message>
        <source>Which sessions?</source>
        <translation>要打开哪些数据？</translation>
    </message>
    <message numerus="yes">
        <source>%1 is no session itself, but %n session(s) lie in it. Open together those of one vehicle between which the LiDAR was not moved.</source>
        <translation>
            <numerusform>%1 本身不是数据，但其中有 %n 个数据。请只一起打开同一辆车、期间激光雷达未被移动过的数据。</numerusform>
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
    <name>remount::SessionsPanel</name>
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
    <name>remount::Setup</name>
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
    <name>remount::SetupFeature</name>
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
    <name>remount::SharpnessView</name>
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
    <name>remount::StepBar</name>
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
    <name>remount::TopicController</name>
    <message>
        <source>was not opened</source>
        <translation>未打开</translation>
    </message>
</context>
<context>
    <name>remount::TopicsDialog</name>
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
</context>
<context>
    <name>remount::WelcomePanel</name>
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
    <name>remount::WindowHost</name>
    <message>
        <source>The language changes as soon as the report is written.</source>
        <translation>报告写完后即切换语言。</translation>
    </message>
</context>
<context>
    <name>remount::axes_picture</name>
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
    <name>remount::choices</name>
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
</context>
<context>
    <name>remount::edit_commands</name>
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
    <name>remount::error_words</name>
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
    <name>remount::flag_mentions</name>
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
</context>
<context>
    <name>remount::gl_support</name>
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
    <name>remount::model</name>
    <message>
        <source>observed</source>
        <translation>可观测</translation>
    </message>
    <message>
        <source>not observed</source>
        <translation>不可观测</translation>
    </message>
    <message>
        <source>x (forward)</source>
        <translation>x（向前）</translation>
    </message>
    <message>
        <source>y (left)</source>
        <translation>y（向左）</translation>
    </message>
    <message>
        <source>z (height)</source>
        <translation>z（高度）</translation>
    </message>
    <message>
        <source>rotation about x (roll)</source>
        <translation>绕 x 旋转（横滚）</translation>
    </message>
    <message>
        <source>rotation about y (pitch)</source>
        <translation>绕 y 旋转（俯仰）</translation>
    </message>
    <message>
        <source>rotation about z (yaw)</source>
        <translation>绕 z 旋转（偏航）</translation>
    </message>
    <message>
        <source>%1: observed</source>
        <translation>%1：可观测</translation>
    </message>
    <message>
        <source>%1: not observable, %2</source>
        <translation>%1：不可观测，%2</translation>
    </message>
    <message>
        <source>%1: not known, %2</source>
        <translation>%1：未知，%2</translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <translation>%1 与 %2</translation>
    </message>
    <message>
        <source>the drive hardly turned</source>
        <translation>行驶几乎没有转弯</translation>
    </message>
    <message>
        <source>flat driving</source>
        <translation>路面平坦</translation>
    </message>
    <message>
        <source>too little motion for it</source>
        <translation>相应的运动太少</translation>
    </message>
    <message>
        <source>the clocks of lidar and INS differ</source>
        <translation>激光雷达与 INS 的时钟不一致</translation>
    </message>
    <message>
        <source>contradicts the INS motion by %1 m, %2 deg (%3 sigma)</source>
        <translation>与 INS 运动相差 %1 m、%2 度（%3 sigma）</translation>
    </message>
    <message>
        <source>does not determine %1</source>
        <translation>不能确定 %1</translation>
    </message>
    <message>
        <source>its scans determine nothing</source>
        <translation>它的扫描不能确定任何方向</translation>
    </message>
    <message>
        <source>its scans were not aligned</source>
        <translation>它的扫描没有配准</translation>
    </message>
    <message>
        <source>registration did not converge</source>
        <translation>配准没有收敛</translation>
    </message>
    <message>
        <source>the surfaces in common determine nothing</source>
        <translation>共有的表面不能确定任何方向</translation>
    </message>
    <message>
        <source>overlap too small: %1</source>
        <translation>重叠太小：%1</translation>
    </message>
    <message>
        <source>residual too large: %1</source>
        <translation>残差太大：%1</translation>
    </message>
    <message>
        <source>too few points with a surface: %1</source>
        <translation>带有表面的点太少：%1</translation>
    </message>
    <message>
        <source>accepted by the user</source>
        <translation>由用户接受</translation>
    </message>
    <message>
        <source>rejected by the user</source>
        <translation>由用户拒绝</translation>
    </message>
    <message>
        <source>Solved; all six parameters are observed.</source>
        <translation>已求解；六个参数全部可观测。</translation>
    </message>
    <message>
        <source>Solved; all six parameters are known, with what was measured.</source>
        <translation>已求解；连同测量值，六个参数全部已知。</translation>
    </message>
    <message>
        <source>The solution lies outside the search range: %1.</source>
        <translation>解超出搜索范围：%1。</translation>
    </message>
    <message>
        <source>The joint solution did not converge.</source>
        <translation>联合求解没有收敛。</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>已取消。</translation>
    </message>
    <message>
        <source>Only %1 usable pair; at least %2 are needed.</source>
        <translation>只有 %1 个可用帧对；至少需要 %2 个。</translation>
    </message>
    <message>
        <source>Only %1 usable pairs; at least %2 are needed.</source>
        <translation>只有 %1 个可用的帧对；至少需要 %2 个。</translation>
    </message>
    <message>
        <source>Nothing is known: the clocks of lidar and INS differ by more than X can bear.</source>
        <translation>一无所知：激光雷达与 INS 的时钟差超出了 X 的承受范围。</translation>
    </message>
    <message>
        <source>Nothing is observed: the motion of this drive does not determine any component of X.</source>
        <translation>不可观测：此次行驶的运动不能确定 X 的任何分量。</translation>
    </message>
    <message>
        <source>No first estimate of the mounting: %1.</source>
        <translation>没有安装的初始估计：%1。</translation>
    </message>
    <message>
        <source>Drive longer, take keyframes closer together, or relax the limits of pairing and registration.</source>
        <translation>请行驶更久，关键帧取得更密，或放宽配对和配准的限制。</translation>
    </message>
    <message>
        <source>Drive turns within sight of buildings and poles, or give a nominal mounting.</source>
        <translation>请在能看到建筑物和杆状物的地方转弯行驶，或给出名义安装。</translation>
    </message>
    <message>
        <source>Give scans and INS data of the same time, on one clock.</source>
        <translation>请给出同一时间、同一时钟的扫描和 INS 数据。</translation>
    </message>
    <message>
        <source>x and y need turns: drive a figure of eight or two tight turns in each direction.</source>
        <translation>x 和 y 需要转弯：走一个 8 字，或向每个方向各做两次急转弯。</translation>
    </message>
    <message>
        <source>x and y need more rotation: drive tighter turns, in both directions.</source>
        <translation>x 和 y 需要更大的转动：向两个方向走更急的弯。</translation>
    </message>
    <message>
        <source>Yaw and pitch need travel: drive at least a few tens of metres with good INS quality.</source>
        <translation>偏航和俯仰需要行驶距离：在 INS 质量良好时至少行驶几十米。</translation>
    </message>
    <message>
        <source>Roll needs turns or slopes: a straight drive does not show it.</source>
        <translation>横滚需要转弯或坡道：直线行驶看不出来。</translation>
    </message>
    <message>
        <source>Widen the search range where it is too narrow. Where it is right, the data contradict it: check axes and units of the INS, and whether the LiDAR is the one that the range is for.</source>
        <translation>搜索范围太窄时请放宽。若范围正确，则数据与它矛盾：请检查 INS 的坐标轴和单位，以及激光雷达是否为该范围所指的那一个。</translation>
    </message>
    <message>
        <source>checking the map</source>
        <translation>检查地图</translation>
    </message>
    <message>
        <source>finding the mounting</source>
        <translation>寻找安装位置</translation>
    </message>
    <message>
        <source>hashing inputs</source>
        <translation>计算输入的校验值</translation>
    </message>
    <message>
        <source>listing scans</source>
        <translation>列出扫描</translation>
    </message>
    <message>
        <source>reading INS</source>
        <translation>读取 INS</translation>
    </message>
    <message>
        <source>reading poses</source>
        <translation>读取位姿</translation>
    </message>
    <message>
        <source>reading scans</source>
        <translation>读取扫描</translation>
    </message>
    <message>
        <source>result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>名义值</translation>
    </message>
    <message>
        <source>refined</source>
        <translation>精化</translation>
    </message>
    <message>
        <source>joint clouds</source>
        <translation>联合点云</translation>
    </message>
    <message>
        <source>pair %1</source>
        <translation>帧对 %1</translation>
    </message>
    <message>
        <source>pairs %1 + %2</source>
        <translation>帧对 %1 + %2</translation>
    </message>
    <message>
        <source>aligning all clouds</source>
        <translation>配准所有点云</translation>
    </message>
    <message>
        <source>finding objects</source>
        <translation>寻找物体</translation>
    </message>
    <message>
        <source>findings</source>
        <translation>发现</translation>
    </message>
    <message>
        <source>registering pairs</source>
        <translation>配准帧对</translation>
    </message>
    <message>
        <source>writing scans</source>
        <translation>写扫描</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X 值</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y 值</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z 值</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>偏航</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>俯仰</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>横滚</translation>
    </message>
    <message>
        <source>INS height</source>
        <translation>INS 高度</translation>
    </message>
    <message>
        <source>INS height sigma</source>
        <translation>INS 高度标准差</translation>
    </message>
    <message>
        <source>INS tilt sigma</source>
        <translation>INS 倾斜标准差</translation>
    </message>
    <message>
        <source>X min</source>
        <translation>X 最小</translation>
    </message>
    <message>
        <source>X max</source>
        <translation>X 最大</translation>
    </message>
    <message>
        <source>Y min</source>
        <translation>Y 最小</translation>
    </message>
    <message>
        <source>Y max</source>
        <translation>Y 最大</translation>
    </message>
    <message>
        <source>Z min</source>
        <translation>Z 最小</translation>
    </message>
    <message>
        <source>Z max</source>
        <translation>Z 最大</translation>
    </message>
    <message>
        <source>Yaw min</source>
        <translation>偏航最小</translation>
    </message>
    <message>
        <source>Yaw max</source>
        <translation>偏航最大</translation>
    </message>
    <message>
        <source>Pitch min</source>
        <translation>俯仰最小</translation>
    </message>
    <message>
        <source>Pitch max</source>
        <translation>俯仰最大</translation>
    </message>
    <message>
        <source>Roll min</source>
        <translation>横滚最小</translation>
    </message>
    <message>
        <source>Roll max</source>
        <translation>横滚最大</translation>
    </message>
    <message>
        <source>Characteristic length</source>
        <translation>特征长度</translation>
    </message>
    <message>
        <source>INS position sigma</source>
        <translation>INS 位置标准差</translation>
    </message>
    <message>
        <source>INS attitude sigma</source>
        <translation>INS 姿态标准差</translation>
    </message>
    <message>
        <source>INS attitude bias sigma</source>
        <translation>INS 姿态偏差标准差</translation>
    </message>
    <message>
        <source>INS position drift</source>
        <translation>INS 位置漂移</translation>
    </message>
    <message>
        <source>INS attitude drift</source>
        <translation>INS 姿态漂移</translation>
    </message>
    <message>
        <source>Max translation sigma</source>
        <translation>平移标准差上限</translation>
    </message>
    <message>
        <source>Max rotation sigma</source>
        <translation>旋转标准差上限</translation>
    </message>
    <message>
        <source>Outlier threshold</source>
        <translation>离群阈值</translation>
    </message>
    <message>
        <source>Max listed candidates</source>
        <translation>候选列出上限</translation>
    </message>
    <message>
        <source>Bootstrap samples</source>
        <translation>重采样次数</translation>
    </message>
    <message>
        <source>Bootstrap block</source>
        <translation>重采样时间块</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Joint clouds</source>
        <translation>联合点云配准</translation>
    </message>
    <message>
        <source>Apply time offset</source>
        <translation>应用时钟偏差</translation>
    </message>
    <message>
        <source>Ground cell</source>
        <translation>地面网格</translation>
    </message>
    <message>
        <source>Ground height</source>
        <translation>地面高度</translation>
    </message>
    <message>
        <source>Cluster distance</source>
        <translation>聚类距离</translation>
    </message>
    <message>
        <source>Min points</source>
        <translation>最少点数</translation>
    </message>
    <message>
        <source>Max points</source>
        <translation>最多点数</translation>
    </message>
    <message>
        <source>Max range</source>
        <translation>最远距离</translation>
    </message>
    <message>
        <source>Association distance</source>
        <translation>关联距离</translation>
    </message>
    <message>
        <source>Moving distance</source>
        <translation>运动距离</translation>
    </message>
    <message>
        <source>Outline x min</source>
        <translation>轮廓 x 最小</translation>
    </message>
    <message>
        <source>Outline x max</source>
        <translation>轮廓 x 最大</translation>
    </message>
    <message>
        <source>Outline y min</source>
        <translation>轮廓 y 最小</translation>
    </message>
    <message>
        <source>Outline y max</source>
        <translation>轮廓 y 最大</translation>
    </message>
    <message>
        <source>Clearance above</source>
        <translation>上方净空</translation>
    </message>
    <message>
        <source>Stop distance</source>
        <translation>停车距离</translation>
    </message>
    <message>
        <source>Ignore inside</source>
        <translation>忽略轮廓内部</translation>
    </message>
    <message>
        <source>Algorithm</source>
        <translation>算法</translation>
    </message>
    <message>
        <source>Voxel</source>
        <translation>体素</translation>
    </message>
    <message>
        <source>Min range</source>
        <translation>最近距离</translation>
    </message>
    <message>
        <source>Max correspondence</source>
        <translation>最大对应距离</translation>
    </message>
    <message>
        <source>Max iterations</source>
        <translation>最多迭代</translation>
    </message>
    <message>
        <source>Min overlap</source>
        <translation>最小重叠</translation>
    </message>
    <message>
        <source>Max RMSE</source>
        <translation>最大 RMSE</translation>
    </message>
    <message>
        <source>Search when doubtful</source>
        <translation>可疑时搜索</translation>
    </message>
    <message>
        <source>Search reach</source>
        <translation>搜索半径</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>方式</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>转角</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>间隔</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>最少</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最多</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>限制</translation>
    </message>
    <message>
        <source>Max gap</source>
        <translation>最长间隔</translation>
    </message>
    <message>
        <source>Max distance</source>
        <translation>最大距离</translation>
    </message>
    <message>
        <source>Min distance</source>
        <translation>最小距离</translation>
    </message>
    <message>
        <source>Min rotation</source>
        <translation>最小转角</translation>
    </message>
    <message>
        <source>Max partners</source>
        <translation>最多伙伴</translation>
    </message>
    <message>
        <source>Min shared objects</source>
        <translation>最少共有物体</translation>
    </message>
    <message>
        <source>Deskew</source>
        <translation>运动补偿</translation>
    </message>
    <message>
        <source>Map check</source>
        <translation>地图检查</translation>
    </message>
    <message>
        <source>x of X (forward in the INS frame) as measured, for example by tape.</source>
        <translation>测得的 X 的 x（INS 坐标系向前），例如用卷尺。</translation>
    </message>
    <message>
        <source>y of X (left in the INS frame) as measured.</source>
        <translation>测得的 X 的 y（INS 坐标系向左）。</translation>
    </message>
    <message>
        <source>z of X (up in the INS frame) as measured.</source>
        <translation>测得的 X 的 z（INS 坐标系向上）。</translation>
    </message>
    <message>
        <source>Yaw of X as measured.</source>
        <translation>测得的 X 的偏航。</translation>
    </message>
    <message>
        <source>Pitch of X as measured.</source>
        <translation>测得的 X 的俯仰。</translation>
    </message>
    <message>
        <source>Roll of X as measured.</source>
        <translation>测得的 X 的横滚。</translation>
    </message>
    <message>
        <source>Height of the INS above the ground; with the ground in the scans it gives z.</source>
        <translation>INS 离地面的高度；结合扫描中的地面可得到 z。</translation>
    </message>
    <message>
        <source>Sigma of that height; 0: not known, the ground is not used.</source>
        <translation>该高度的标准差；0：未知，不使用地面。</translation>
    </message>
    <message>
        <source>How far the INS may lean against the ground on which the vehicle stands; where the ground is used it gives pitch and roll this well.</source>
        <translation>INS 相对车辆所在地面可能倾斜多少；使用地面时，它决定俯仰和横滚的精度。</translation>
    </message>
    <message>
        <source>Search range of x, forward in the INS frame.</source>
        <translation>x 的搜索范围，INS 坐标系向前。</translation>
    </message>
    <message>
        <source>Search range of y, left in the INS frame.</source>
        <translation>y 的搜索范围，INS 坐标系向左。</translation>
    </message>
    <message>
        <source>Search range of z, up in the INS frame.</source>
        <translation>z 的搜索范围，INS 坐标系向上。</translation>
    </message>
    <message>
        <source>Search range of yaw; half a turn to each side is every angle.</source>
        <translation>偏航的搜索范围；两侧各半圈即任何角度。</translation>
    </message>
    <message>
        <source>Search range of pitch, which is stated within a quarter turn.</source>
        <translation>俯仰的搜索范围，以四分之一圈以内表示。</translation>
    </message>
    <message>
        <source>Search range of roll; half a turn to each side is every angle.</source>
        <translation>横滚的搜索范围；两侧各半圈即任何角度。</translation>
    </message>
    <message>
        <source>Scales the translation block in the ranking error; 1 m is the plain Frobenius norm.</source>
        <translation>排序误差中平移部分的尺度；1 米即普通的 Frobenius 范数。</translation>
    </message>
    <message>
        <source>INS position noise from sample to sample, where the log does not state it.</source>
        <translation>采样之间的 INS 位置噪声，用于记录未说明时。</translation>
    </message>
    <message>
        <source>INS attitude noise from sample to sample, where the log does not state it.</source>
        <translation>采样之间的 INS 姿态噪声，用于记录未说明时。</translation>
    </message>
    <message>
        <source>INS attitude error that stays the same over a drive, where the log does not state it.</source>
        <translation>一次行驶中保持不变的 INS 姿态误差，用于记录未说明时。</translation>
    </message>
    <message>
        <source>INS position error that builds up in one second, growing with the root of time, where the log does not state its errors.</source>
        <translation>一秒内累积的 INS 位置误差，随时间的平方根增长，用于记录未说明误差时。</translation>
    </message>
    <message>
        <source>INS attitude error that builds up in one second, growing with the root of time, where the log does not state its errors.</source>
        <translation>一秒内累积的 INS 姿态误差，随时间的平方根增长，用于记录未说明误差时。</translation>
    </message>
    <message>
        <source>A translation with a larger sigma counts as not observed.</source>
        <translation>标准差更大的平移视为不可观测。</translation>
    </message>
    <message>
        <source>A rotation with a larger sigma counts as not observed.</source>
        <translation>标准差更大的旋转视为不可观测。</translation>
    </message>
    <message>
        <source>Pairs whose residual exceeds this many sigma are rejected.</source>
        <translation>残差超过这么多 sigma 的帧对被拒绝。</translation>
    </message>
    <message>
        <source>Candidates kept in the result, best first.</source>
        <translation>结果中保留的候选数，最好的在前。</translation>
    </message>
    <message>
        <source>Longest block of time whose errors count as one for the bootstrap sigma.</source>
        <translation>自助法标准差中误差视为一体的最长时间块。</translation>
    </message>
    <message>
        <source>Align the clouds of all accepted pairs together as the last step.</source>
        <translation>最后一步把所有接受帧对的点云一起配准。</translation>
    </message>
    <message>
        <source>Edge of the cells in which the ground&apos;s height is found.</source>
        <translation>求地面高度所用网格的边长。</translation>
    </message>
    <message>
        <source>Points within this height above the ground belong to it.</source>
        <translation>离地面在此高度以内的点属于地面。</translation>
    </message>
    <message>
        <source>Points closer than this belong to one object.</source>
        <translation>比这更近的点属于同一物体。</translation>
    </message>
    <message>
        <source>Smaller clusters are not objects.</source>
        <translation>更小的聚类不算物体。</translation>
    </message>
    <message>
        <source>Larger clusters are cut into pieces of cell size.</source>
        <translation>更大的聚类按网格大小切开。</translation>
    </message>
    <message>
        <source>Objects farther than this are not used.</source>
        <translation>比这更远的物体不使用。</translation>
    </message>
    <message>
        <source>Farthest an object may be from where it is predicted in the other scan.</source>
        <translation>物体离它在另一次扫描中的预测位置最远多少。</translation>
    </message>
    <message>
        <source>An object displaced by more than this against the rest of the pair is moving.</source>
        <translation>相对帧对其余部分位移超过此值的物体是运动的。</translation>
    </message>
    <message>
        <source>What is higher than this above the INS is no obstacle: bridges, branches.</source>
        <translation>高出 INS 超过此值的不算障碍物：桥梁、树枝。</translation>
    </message>
    <message>
        <source>Decision: stop where an obstacle is closer than this to the outline.</source>
        <translation>判定：障碍物离轮廓比这更近时停车。</translation>
    </message>
    <message>
        <source>What lies wholly within the outline is the vehicle itself, not an obstacle.</source>
        <translation>完全在轮廓内的是车辆自身，不是障碍物。</translation>
    </message>
    <message>
        <source>Edge of the voxels that thin a scan before alignment.</source>
        <translation>配准前用于抽稀扫描的体素边长。</translation>
    </message>
    <message>
        <source>Points farther than this from the sensor are left out.</source>
        <translation>离传感器比这更远的点被略去。</translation>
    </message>
    <message>
        <source>Points nearer than this to the sensor (the vehicle itself) are left out.</source>
        <translation>离传感器比这更近的点（车辆自身）被略去。</translation>
    </message>
    <message>
        <source>Neighbours farther apart than this do not count in the last iterations.</source>
        <translation>相距超过此值的邻点在最后几次迭代中不计。</translation>
    </message>
    <message>
        <source>Iterations before an alignment is given up.</source>
        <translation>放弃配准之前的迭代次数。</translation>
    </message>
    <message>
        <source>An alignment with a smaller share of inliers is rejected.</source>
        <translation>内点比例更小的配准被拒绝。</translation>
    </message>
    <message>
        <source>An alignment with larger inlier residuals is rejected.</source>
        <translation>内点残差更大的配准被拒绝。</translation>
    </message>
    <message>
        <source>Where an alignment fails, fits upright surfaces badly or moved far, others around its start are tried.</source>
        <translation>配准失败、与竖直表面不符或移动很远时，尝试起点周围的其他位置。</translation>
    </message>
    <message>
        <source>How far around the start other positions are tried.</source>
        <translation>在起点周围多远的范围内尝试其他位置。</translation>
    </message>
    <message>
        <source>How far around the start other yaws are tried.</source>
        <translation>在起点周围多大的范围内尝试其他偏航。</translation>
    </message>
    <message>
        <source>Take a keyframe after a travelled distance or after a time.</source>
        <translation>按行驶距离或按时间取关键帧。</translation>
    </message>
    <message>
        <source>Travelled distance between keyframes (mode distance).</source>
        <translation>关键帧之间的行驶距离（距离方式）。</translation>
    </message>
    <message>
        <source>Turn after which a keyframe is taken even without distance (mode distance).</source>
        <translation>即使没有行驶也取关键帧的转角（距离方式）。</translation>
    </message>
    <message>
        <source>Time between keyframes (mode time).</source>
        <translation>关键帧之间的时间（时间方式）。</translation>
    </message>
    <message>
        <source>A short drive takes keyframes closer together until it has this many, or all its scans.</source>
        <translation>短途行驶把关键帧取得更密，直到达到此数或用完所有扫描。</translation>
    </message>
    <message>
        <source>At most this many keyframes a session; beyond it they are spread evenly.</source>
        <translation>每个数据最多这么多关键帧；超过时均匀分布。</translation>
    </message>
    <message>
        <source>Pair keyframes that are close in time, in distance, or in either.</source>
        <translation>把时间上、距离上或任一方面接近的关键帧配成对。</translation>
    </message>
    <message>
        <source>Longest time between the two scans of a pair (limit time).</source>
        <translation>帧对两次扫描之间的最长时间（时间限制）。</translation>
    </message>
    <message>
        <source>Longest distance between the two scans of a pair (limit distance).</source>
        <translation>帧对两次扫描之间的最长距离（距离限制）。</translation>
    </message>
    <message>
        <source>A pair must have moved at least this far, or turned (min_rotation_deg).</source>
        <translation>帧对至少移动这么远，或转过 min_rotation_deg。</translation>
    </message>
    <message>
        <source>A pair must have turned at least this much, or moved (min_distance_m).</source>
        <translation>帧对至少转过这么多，或移动过 min_distance_m。</translation>
    </message>
    <message>
        <source>At most this many later partners for each keyframe, spread over the allowed gaps.</source>
        <translation>每个关键帧最多这么多后续伙伴，分布在允许的间隔内。</translation>
    </message>
    <message>
        <source>Static objects that both scans must contain.</source>
        <translation>两次扫描都必须含有的静止物体数。</translation>
    </message>
    <message>
        <source>Compensate motion within a scan: where the data call for it (auto), always, never.</source>
        <translation>补偿扫描内的运动：数据需要时 (auto)、总是、从不。</translation>
    </message>
    <message>
        <source>Memory for scans and what is prepared from them; independent of the length of a drive.</source>
        <translation>扫描及其预处理所用的内存；与行驶长度无关。</translation>
    </message>
    <message>
        <source>Compare how sharp the accumulated scans are under the nominal, the candidates and the result.</source>
        <translation>比较累积扫描在名义值、候选和结果下的清晰程度。</translation>
    </message>
    <message>
        <source>X sigma</source>
        <translation>X 标准差</translation>
    </message>
    <message>
        <source>Y sigma</source>
        <translation>Y 标准差</translation>
    </message>
    <message>
        <source>Z sigma</source>
        <translation>Z 标准差</translation>
    </message>
    <message>
        <source>Yaw sigma</source>
        <translation>偏航标准差</translation>
    </message>
    <message>
        <source>Pitch sigma</source>
        <translation>俯仰标准差</translation>
    </message>
    <message>
        <source>Roll sigma</source>
        <translation>横滚标准差</translation>
    </message>
    <message>
        <source>Sigma of the measured value; 0: not measured.</source>
        <translation>测量值的标准差；0：没有测量。</translation>
    </message>
    <message>
        <source>Cache</source>
        <translation>缓存</translation>
    </message>
    <message>
        <source>reading scans for the map</source>
        <translation>正在读取地图的扫描</translation>
    </message>
    <message>
        <source>putting the scans together</source>
        <translation>正在拼合扫描</translation>
    </message>
    <message>
        <source>not aligned: the calibration was cancelled</source>
        <translation>未配准：标定已被取消</translation>
    </message>
    <message>
        <source>was cancelled when %1 of %2 pairs were aligned: the result is from these, without the last steps (aligning all clouds). Calibrate again for the rest.</source>
        <translation>在 %2 个帧对中有 %1 个完成配准时被取消：结果仅来自这些帧对，未执行最后的步骤（对齐全部点云）。要处理其余帧对，请重新标定。</translation>
    </message>
    <message>
        <source>%1 gaps, the longest %2 s; nothing is interpolated across them.</source>
        <translation>%1 处间断，最长 %2 秒；间断处不做插值。</translation>
    </message>
    <message>
        <source>The INS moves at up to %1 m/s: its position jumps, or its stamps are wrong.</source>
        <translation>INS 速度高达 %1 m/s：位置有跳变，或时间戳有误。</translation>
    </message>
    <message>
        <source>The vehicle tilts by %1 degrees only: the height of the LiDAR will hardly be observable. Drive over a ramp.</source>
        <translation>车辆只倾斜了 %1 度：激光雷达的高度几乎不可观测。请驶过坡道。</translation>
    </message>
    <message>
        <source>The INS repeats one solution for %1 s; was it still aligning, or did the log stall?</source>
        <translation>INS 在 %1 秒内重复同一结果；是仍在对准，还是记录停顿了？</translation>
    </message>
    <message>
        <source>The heading of the INS does not follow the direction of travel, but it would as %1: correct the convention of the attitude. No mounting can be right with this one.</source>
        <translation>INS 的航向与行驶方向不一致，但若按 %1 理解则一致：请改正姿态的约定。按现在的约定，任何安装都不可能正确。</translation>
    </message>
    <message>
        <source>The heading of the INS does not follow the direction of travel: check the convention of the attitude, and whether what is taken for yaw is it. A vehicle that moves sideways at will may look so too.</source>
        <translation>INS 的航向与行驶方向不一致：请检查姿态的约定，以及被当作航向角的是否确是航向角。能任意横移的车辆也会这样。</translation>
    </message>
    <message>
        <source>The z axis of the INS points down, where its axes are declared with z up: is it mounted so? Otherwise check the convention of the attitude (ENU or NED, roll by 180 degrees).</source>
        <translation>INS 的 z 轴朝下，而其坐标系声明为 z 朝上：它确实这样安装吗？否则请检查姿态的约定（ENU 或 NED，横滚相差 180 度）。</translation>
    </message>
    <message>
        <source>%1 of %2 scans lie outside the INS data or in a gap of it and are not used.</source>
        <translation>%2 帧扫描中有 %1 帧在 INS 数据之外或处于其间断处，未使用。</translation>
    </message>
    <message>
        <source>%1 of %2 scans lie outside the INS data or in a gap of it and are not used: %3</source>
        <translation>%2 帧扫描中有 %1 帧在 INS 数据之外或处于其间断处，未使用：%3</translation>
    </message>
    <message>
        <source>Too few scans show the ground near the vehicle; the height of the INS is not used.</source>
        <translation>能看到车辆附近地面的扫描太少；不使用 INS 的高度。</translation>
    </message>
    <message>
        <source>%1 The scan is skipped.</source>
        <translation>%1 该帧扫描已跳过。</translation>
    </message>
    <message>
        <source>Surfaces in the accumulated scans are %1 mm thick under the result and %2 mm under the nominal: the map contradicts the result. Look at the pairs and at the clock offset before using it.</source>
        <translation>累积扫描中的表面，按结果厚 %1 mm，按名义安装厚 %2 mm：地图与结果矛盾。使用前请查看帧对和时钟偏差。</translation>
    </message>
    <message>
        <source>The result lies %1 deg and %2 m from the nominal mounting. The LiDAR sits otherwise than assumed, or the nominal has other axes or signs.</source>
        <translation>结果与名义安装相差 %1° 和 %2 m。激光雷达的安装与假设不同，或名义值的坐标轴或符号不同。</translation>
    </message>
    <message>
        <source>The result lies %1 deg and %2 m from the nominal mounting. The inverse of the nominal is near: was lidar_from_ins given for ins_from_lidar?</source>
        <translation>结果与名义安装相差 %1° 和 %2 m。名义值的逆与结果接近：是否把 lidar_from_ins 当作 ins_from_lidar 给出了？</translation>
    </message>
    <message>
        <source>The column &apos;time&apos; was rounded, as a spreadsheet does; GPS time is used, nothing is lost.</source>
        <translation>“time” 列被舍入了（电子表格会这样）；改用 GPS 时间，没有损失。</translation>
    </message>
    <message>
        <source>The column &apos;time&apos; (clock of the host, or of a replay) is %1 s off UTC by GPS; GPS time is used.</source>
        <translation>“time” 列（主机或回放的时钟）与 GPS 给出的 UTC 相差 %1 秒；使用 GPS 时间。</translation>
    </message>
    <message>
        <source>The LiDAR poses cannot be brought to INS time: %1. Their stamps stay as they are; record a drive with several turns.</source>
        <translation>无法把激光雷达位姿换算到 INS 时间：%1。其时间戳保持原样；请录制含多次转弯的数据。</translation>
    </message>
    <message>
        <source>The two clocks agree; by the rates of rotation, %1. Nothing was moved.</source>
        <translation>两个时钟一致；按角速度，%1。未做移动。</translation>
    </message>
    <message>
        <source>The LiDAR poses were moved to INS time by the rates of rotation: %1.</source>
        <translation>已按角速度把激光雷达位姿移到 INS 时间：%1。</translation>
    </message>
    <message>
        <source>%1 cannot be used and is left out. First: %2</source>
        <translation>%1 无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 cannot be used and are left out. First: %2</source>
        <translation>%1 无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 entries repeat the stamp before them; the first of each is used.</source>
        <translation>%1 条与前一条时间戳相同；只用每组的第一条。</translation>
    </message>
    <message>
        <source>%1 files have no time stamp and are left out.</source>
        <translation>%1 个文件没有时间戳，已略去。</translation>
    </message>
    <message>
        <source>Scans and INS samples of one number are taken together; their own stamps differ by %1 ms (median).</source>
        <translation>同一编号的扫描与 INS 样本配在一起；它们自身的时间戳相差 %1 毫秒（中位数）。</translation>
    </message>
    <message>
        <source>A mounting is given beside the drive; it serves as the nominal.</source>
        <translation>数据旁给出了一个安装；用作名义安装。</translation>
    </message>
    <message>
        <source>There are scans and LiDAR poses; the scans are used.</source>
        <translation>既有扫描也有激光雷达位姿；使用扫描。</translation>
    </message>
    <message>
        <source>One pose file is half a session: put it into a folder with the poses of the other sensor.</source>
        <translation>单个位姿文件只是半份数据：请把它与另一传感器的位姿放入同一文件夹。</translation>
    </message>
    <message>
        <source>Rotations were off by up to %1 in an entry; the nearest rotation is used.</source>
        <translation>旋转矩阵的元素误差最大达 %1；使用最接近的旋转。</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>不存在</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>是空的</translation>
    </message>
    <message>
        <source>is empty (0 bytes), expected the log or manifest of a session</source>
        <translation>是空的（0 字节），应为数据的日志或清单</translation>
    </message>
    <message>
        <source>is no session that Remount knows. It looks for:%1</source>
        <translation>不是 Remount 认识的数据。它寻找：%1</translation>
    </message>
    <message>
        <source>lies outside the search range: %1. Correct it, or widen the search range.</source>
        <translation>在搜索范围之外：%1。请改正它，或放宽搜索范围。</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>无法打开：%1</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>无法读取：%1</translation>
    </message>
    <message>
        <source>cannot be examined: %1</source>
        <translation>无法检查：%1</translation>
    </message>
    <message>
        <source>cannot be made: %1</source>
        <translation>无法创建：%1</translation>
    </message>
    <message>
        <source>cannot be saved: %1; nothing was replaced</source>
        <translation>无法保存：%1；未替换任何内容</translation>
    </message>
    <message>
        <source>cannot be saved, no temporary file can be made beside it: %1; nothing was replaced</source>
        <translation>无法保存，不能在其旁边创建临时文件：%1；未替换任何内容</translation>
    </message>
    <message>
        <source>cannot be saved, there is no folder %1</source>
        <translation>无法保存，没有文件夹 %1</translation>
    </message>
    <message>
        <source>cannot be saved, the link leads nowhere: %1</source>
        <translation>无法保存，链接没有指向任何位置：%1</translation>
    </message>
    <message>
        <source>is no PCD, PLY, KITTI .bin or .txt scan</source>
        <translation>不是 PCD、PLY、KITTI .bin 或 .txt 扫描</translation>
    </message>
    <message>
        <source>holds no points</source>
        <translation>不含任何点</translation>
    </message>
    <message>
        <source>holds no scan with a time stamp</source>
        <translation>不含带时间戳的扫描</translation>
    </message>
    <message>
        <source>holds no INSPVAX log</source>
        <translation>不含 INSPVAX 记录</translation>
    </message>
    <message>
        <source>is no pose file</source>
        <translation>不是位姿文件</translation>
    </message>
    <message>
        <source>latitude, longitude or height is not possible</source>
        <translation>纬度、经度或高度不合理</translation>
    </message>
    <message>
        <source>the checksum does not agree with the line</source>
        <translation>校验和与该行不符</translation>
    </message>
    <message>
        <source>the positions lie all over the Earth: is that one drive?</source>
        <translation>位置遍布全球：这是一段数据吗？</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>没有这个文件或文件夹</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>没有权限</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>磁盘空间已满</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>读写错误</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>文件系统只读</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>是一个文件夹</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>degenerate</source>
        <translation>部分不可观测</translation>
    </message>
    <message>
        <source>too_few_pairs</source>
        <translation>帧对太少</translation>
    </message>
    <message>
        <source>not_converged</source>
        <translation>未收敛</translation>
    </message>
    <message>
        <source>out_of_range</source>
        <translation>超出范围</translation>
    </message>
    <message>
        <source>inconsistent</source>
        <translation>互相矛盾</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>State interval</source>
        <translation>状态间隔</translation>
    </message>
    <message>
        <source>Odometry translation sigma</source>
        <translation>里程计平移标准差</translation>
    </message>
    <message>
        <source>Odometry rotation sigma</source>
        <translation>里程计旋转标准差</translation>
    </message>
    <message>
        <source>Odometry drift percent</source>
        <translation>里程计漂移百分比</translation>
    </message>
    <message>
        <source>Odometry drift</source>
        <translation>里程计航向漂移</translation>
    </message>
    <message>
        <source>Odometry scale percent</source>
        <translation>里程计尺度误差百分比</translation>
    </message>
    <message>
        <source>Antenna reach</source>
        <translation>天线距离范围</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>更新间隔</translation>
    </message>
    <message>
        <source>Converged translation</source>
        <translation>平移收敛标准差</translation>
    </message>
    <message>
        <source>Converged rotation</source>
        <translation>旋转收敛标准差</translation>
    </message>
    <message>
        <source>Keyframe distance</source>
        <translation>关键帧距离</translation>
    </message>
    <message>
        <source>Keyframe angle</source>
        <translation>关键帧转角</translation>
    </message>
    <message>
        <source>Map keyframes</source>
        <translation>地图关键帧数</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>线特征</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>面特征</translation>
    </message>
    <message>
        <source>Ackermann</source>
        <translation>阿克曼航位推算</translation>
    </message>
    <message>
        <source>Accelerometer</source>
        <translation>加速度计</translation>
    </message>
    <message>
        <source>Barometer</source>
        <translation>气压计</translation>
    </message>
    <message>
        <source>Line sigma</source>
        <translation>线特征标准差</translation>
    </message>
    <message>
        <source>Plane sigma</source>
        <translation>面特征标准差</translation>
    </message>
    <message>
        <source>Independent features</source>
        <translation>独立特征数</translation>
    </message>
    <message>
        <source>Wheel sigma</source>
        <translation>轮速相对标准差</translation>
    </message>
    <message>
        <source>Wheel sigma mps</source>
        <translation>轮速标准差</translation>
    </message>
    <message>
        <source>Sideslip sigma mps</source>
        <translation>侧滑标准差</translation>
    </message>
    <message>
        <source>Gyro sigma dps</source>
        <translation>陀螺标准差</translation>
    </message>
    <message>
        <source>Gyro bias sigma dps</source>
        <translation>陀螺零偏标准差</translation>
    </message>
    <message>
        <source>Gyro bias walk dps</source>
        <translation>陀螺零偏游走</translation>
    </message>
    <message>
        <source>Wheel scale sigma</source>
        <translation>轮速尺度标准差</translation>
    </message>
    <message>
        <source>Accelerometer sigma</source>
        <translation>加速度计标准差</translation>
    </message>
    <message>
        <source>Accelerometer discount</source>
        <translation>加速度计降权</translation>
    </message>
    <message>
        <source>Barometer sigma</source>
        <translation>气压计标准差</translation>
    </message>
    <message>
        <source>Map frames</source>
        <translation>地图帧数</translation>
    </message>
    <message>
        <source>Map step</source>
        <translation>地图步长</translation>
    </message>
    <message>
        <source>Line voxel</source>
        <translation>线特征体素</translation>
    </message>
    <message>
        <source>Plane voxel</source>
        <translation>面特征体素</translation>
    </message>
    <message>
        <source>Most lines</source>
        <translation>线特征上限</translation>
    </message>
    <message>
        <source>Most planes</source>
        <translation>面特征上限</translation>
    </message>
    <message>
        <source>Match distance</source>
        <translation>匹配距离</translation>
    </message>
    <message>
        <source>Range noise</source>
        <translation>测距噪声</translation>
    </message>
    <message>
        <source>Track width</source>
        <translation>轮距</translation>
    </message>
    <message>
        <source>INS x</source>
        <translation>INS x</translation>
    </message>
    <message>
        <source>INS y</source>
        <translation>INS y</translation>
    </message>
    <message>
        <source>INS z</source>
        <translation>INS z</translation>
    </message>
    <message>
        <source>INS yaw</source>
        <translation>INS 偏航</translation>
    </message>
    <message>
        <source>INS pitch</source>
        <translation>INS 俯仰</translation>
    </message>
    <message>
        <source>INS roll</source>
        <translation>INS 横滚</translation>
    </message>
    <message>
        <source>IMU x</source>
        <translation>IMU x</translation>
    </message>
    <message>
        <source>IMU y</source>
        <translation>IMU y</translation>
    </message>
    <message>
        <source>IMU z</source>
        <translation>IMU z</translation>
    </message>
    <message>
        <source>IMU yaw</source>
        <translation>IMU 偏航</translation>
    </message>
    <message>
        <source>IMU pitch</source>
        <translation>IMU 俯仰</translation>
    </message>
    <message>
        <source>IMU roll</source>
        <translation>IMU 横滚</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>尺度</translation>
    </message>
    <message>
        <source>Estimate wheel scale</source>
        <translation>估计轮速尺度</translation>
    </message>
    <message>
        <source>Interval turn</source>
        <translation>间隔转角</translation>
    </message>
    <message>
        <source>IMU mounting sigma</source>
        <translation>IMU 安装标准差</translation>
    </message>
    <message>
        <source>INS alignment sigma</source>
        <translation>INS 对准标准差</translation>
    </message>
    <message>
        <source>Level turns</source>
        <translation>水平转弯</translation>
    </message>
    <message>
        <source>First plane</source>
        <translation>第一平面</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>Min arc</source>
        <translation>最小弧度范围</translation>
    </message>
    <message>
        <source>Max plane angle</source>
        <translation>平面夹角上限</translation>
    </message>
    <message>
        <source>Max square error</source>
        <translation>垂直误差上限</translation>
    </message>
    <message>
        <source>Ground radius</source>
        <translation>地面半径</translation>
    </message>
    <message>
        <source>Arm reach</source>
        <translation>臂的范围</translation>
    </message>
    <message>
        <source>Plane inlier</source>
        <translation>平面内点距离</translation>
    </message>
    <message>
        <source>Surface sigma</source>
        <translation>表面标准差</translation>
    </message>
    <message>
        <source>Ground session</source>
        <translation>地面数据</translation>
    </message>
    <message>
        <source>Arm session</source>
        <translation>摆臂数据</translation>
    </message>
    <message>
        <source>Turn session</source>
        <translation>回转数据</translation>
    </message>
    <message>
        <source>How the mounting is found. Pairwise: pairs of keyframes; the others serve vehicles where that alone does not do.</source>
        <translation>求安装位姿的方法。默认的成对法使用关键帧对；其余方法用于仅靠帧对不够的车辆。</translation>
    </message>
    <message>
        <source>Use line features of the scans.</source>
        <translation>使用扫描的线特征。</translation>
    </message>
    <message>
        <source>Use plane features of the scans.</source>
        <translation>使用扫描的面特征。</translation>
    </message>
    <message>
        <source>Use dead reckoning from the rear wheels and the gyroscope.</source>
        <translation>使用后轮和陀螺的航位推算。</translation>
    </message>
    <message>
        <source>Use roll and pitch from the accelerometer.</source>
        <translation>使用加速度计给出的横滚和俯仰。</translation>
    </message>
    <message>
        <source>Use the height of the barometer, relative to the start.</source>
        <translation>使用气压计相对起点的高度。</translation>
    </message>
    <message>
        <source>1-sigma of a line feature&apos;s distance from its line.</source>
        <translation>线特征到其直线距离的标准差。</translation>
    </message>
    <message>
        <source>1-sigma of a plane feature&apos;s distance from its plane.</source>
        <translation>面特征到其平面距离的标准差。</translation>
    </message>
    <message>
        <source>Features of a scan count for at most as many independent ones: neighbours share the errors of the map.</source>
        <translation>一次扫描的特征最多按这么多个独立特征计：相邻特征带有地图的共同误差。</translation>
    </message>
    <message>
        <source>1-sigma of a step by the wheels, as a share of the distance.</source>
        <translation>轮速给出的一步位移的标准差，按距离的比例。</translation>
    </message>
    <message>
        <source>1-sigma of the wheels&apos; speed that does not grow with it.</source>
        <translation>轮速标准差中不随速度增大的部分。</translation>
    </message>
    <message>
        <source>1-sigma of the rear axle&apos;s motion to the side and up.</source>
        <translation>后轴侧向和向上运动的标准差。</translation>
    </message>
    <message>
        <source>1-sigma of a step&apos;s mean angular rate, each axis.</source>
        <translation>一步内平均角速度的标准差，每轴。</translation>
    </message>
    <message>
        <source>1-sigma of the gyroscope&apos;s bias at the start, each axis.</source>
        <translation>起始时陀螺零偏的标准差，每轴。</translation>
    </message>
    <message>
        <source>How fast that bias walks, each axis.</source>
        <translation>该零偏游走的快慢，每轴。</translation>
    </message>
    <message>
        <source>1-sigma of the scale of the wheels&apos; speed.</source>
        <translation>轮速尺度的标准差。</translation>
    </message>
    <message>
        <source>1-sigma of roll and pitch from the accelerometer.</source>
        <translation>加速度计给出的横滚和俯仰的标准差。</translation>
    </message>
    <message>
        <source>Added to that for each m/s2 by which the vehicle accelerates, what is known of that taken off.</source>
        <translation>扣除已知加速度后，车辆每 m/s2 的加速度在此标准差上增加的量。</translation>
    </message>
    <message>
        <source>1-sigma of the height of the barometer.</source>
        <translation>气压计高度的标准差。</translation>
    </message>
    <message>
        <source>Compensate the motion within a scan by the predicted motion.</source>
        <translation>用预测的运动补偿扫描内的运动。</translation>
    </message>
    <message>
        <source>A scan enters the map that moved this far since the last one, or turned.</source>
        <translation>自上一次加入后移动了这么远或有转动的扫描加入地图。</translation>
    </message>
    <message>
        <source>A scan enters the map that turned this much since the last one, or moved.</source>
        <translation>自上一次加入后转动了这么多或有移动的扫描加入地图。</translation>
    </message>
    <message>
        <source>Line features are thinned to one in a cube of this size.</source>
        <translation>线特征抽稀到每个此边长的立方体一个。</translation>
    </message>
    <message>
        <source>Plane features are thinned to one in a cube of this size.</source>
        <translation>面特征抽稀到每个此边长的立方体一个。</translation>
    </message>
    <message>
        <source>Line features of a scan that are matched, at most.</source>
        <translation>一次扫描最多参与匹配的线特征数。</translation>
    </message>
    <message>
        <source>Plane features of a scan that are matched, at most.</source>
        <translation>一次扫描最多参与匹配的面特征数。</translation>
    </message>
    <message>
        <source>Neighbours in the map are looked for within this distance.</source>
        <translation>在地图中这一距离内寻找近邻。</translation>
    </message>
    <message>
        <source>Nearer points are left out.</source>
        <translation>更近的点不使用。</translation>
    </message>
    <message>
        <source>Farther points are left out.</source>
        <translation>更远的点不使用。</translation>
    </message>
    <message>
        <source>1-sigma of the range that the LiDAR measures.</source>
        <translation>激光雷达测距的标准差。</translation>
    </message>
    <message>
        <source>Between the rear wheels; gives the turn where there is no gyroscope.</source>
        <translation>两后轮之间的距离；没有陀螺时由它给出转角。</translation>
    </message>
    <message>
        <source>INS ahead of the rear axle.</source>
        <translation>INS 在后轴前方的距离。</translation>
    </message>
    <message>
        <source>INS to the left of the rear axle&apos;s centre.</source>
        <translation>INS 在后轴中心左侧的距离。</translation>
    </message>
    <message>
        <source>INS above the ground under the rear axle.</source>
        <translation>INS 高于后轴下方地面的高度。</translation>
    </message>
    <message>
        <source>Yaw of the INS in the vehicle.</source>
        <translation>INS 在车体中的偏航。</translation>
    </message>
    <message>
        <source>Pitch of the INS in the vehicle.</source>
        <translation>INS 在车体中的俯仰。</translation>
    </message>
    <message>
        <source>Roll of the INS in the vehicle.</source>
        <translation>INS 在车体中的横滚。</translation>
    </message>
    <message>
        <source>IMU ahead of the INS, in its axes.</source>
        <translation>IMU 在 INS 前方的距离，按 INS 的轴。</translation>
    </message>
    <message>
        <source>IMU to the left of the INS, in its axes.</source>
        <translation>IMU 在 INS 左侧的距离，按 INS 的轴。</translation>
    </message>
    <message>
        <source>IMU above the INS, in its axes.</source>
        <translation>IMU 在 INS 上方的距离，按 INS 的轴。</translation>
    </message>
    <message>
        <source>Yaw of the IMU in the INS frame.</source>
        <translation>IMU 在 INS 坐标系中的偏航。</translation>
    </message>
    <message>
        <source>Pitch of the IMU in the INS frame.</source>
        <translation>IMU 在 INS 坐标系中的俯仰。</translation>
    </message>
    <message>
        <source>Roll of the IMU in the INS frame.</source>
        <translation>IMU 在 INS 坐标系中的横滚。</translation>
    </message>
    <message>
        <source>Scale of the sensor&apos;s poses: known where they are in metres (LiDAR), estimated where it is free (one camera).</source>
        <translation>传感器位姿的尺度：以米计时为已知（激光雷达），不定时需估计（单目相机）。</translation>
    </message>
    <message>
        <source>Estimate the scale of the wheel speeds (tyre radius) too; needs sensor poses in metres.</source>
        <translation>同时估计轮速的尺度（轮胎半径）；需要以米计的传感器位姿。</translation>
    </message>
    <message>
        <source>Way between two poses of the sensor that are compared with the wheels.</source>
        <translation>与轮速比较的两个传感器位姿之间的路程。</translation>
    </message>
    <message>
        <source>Turn after which two poses are compared even on a shorter way.</source>
        <translation>转角达到此值时，路程较短也比较两个位姿。</translation>
    </message>
    <message>
        <source>Yaw of the IMU in the vehicle as far as it is known.</source>
        <translation>IMU 在车体中的偏航（已知的程度）。</translation>
    </message>
    <message>
        <source>Pitch of the IMU in the vehicle as far as it is known.</source>
        <translation>IMU 在车体中的俯仰（已知的程度）。</translation>
    </message>
    <message>
        <source>Roll of the IMU in the vehicle as far as it is known.</source>
        <translation>IMU 在车体中的横滚（已知的程度）。</translation>
    </message>
    <message>
        <source>How well these angles of the IMU are known; 180: not at all.</source>
        <translation>IMU 这些角度的已知精度；180：完全未知。</translation>
    </message>
    <message>
        <source>How well the axes of an INS, where the drive has one, are those of the vehicle.</source>
        <translation>有 INS 时，其轴与车体轴的一致程度。</translation>
    </message>
    <message>
        <source>How large the constant error of the IMU&apos;s rates may be.</source>
        <translation>IMU 角速度的常值误差可能有多大。</translation>
    </message>
    <message>
        <source>Where no INS says it: on the whole the vehicle turns about its own z, leaning and turning are not linked.</source>
        <translation>没有 INS 说明时：总体上车辆绕自身 z 轴转动，倾斜与转弯无关。</translation>
    </message>
    <message>
        <source>Which plane is square to the slew axis: the ground (A), or that of the LiDAR&apos;s circle (B).</source>
        <translation>哪个平面垂直于回转轴：地面（A），或激光雷达圆周所在的平面（B）。</translation>
    </message>
    <message>
        <source>Height of the machine&apos;s origin on the slew axis: that of the LiDAR&apos;s circle, or the ground.</source>
        <translation>机体原点在回转轴上的高度：激光雷达圆周的高度，或地面。</translation>
    </message>
    <message>
        <source>A turn over a shorter arc is refused.</source>
        <translation>弧度范围更小的回转不予采用。</translation>
    </message>
    <message>
        <source>Where ground and turn are farther from parallel, the ground is tilted against the machine.</source>
        <translation>地面与回转平面的夹角更大时，说明地面相对机体倾斜。</translation>
    </message>
    <message>
        <source>Where the plane of the arm is farther from square to the first plane, it is not the arm&apos;s.</source>
        <translation>该平面与第一平面偏离垂直更多时，它不是臂的平面。</translation>
    </message>
    <message>
        <source>Ground is taken from so far around the LiDAR.</source>
        <translation>在激光雷达周围这一距离内取地面。</translation>
    </message>
    <message>
        <source>What moves farther away from the LiDAR is not the arm.</source>
        <translation>离激光雷达更远的运动物体不是臂。</translation>
    </message>
    <message>
        <source>Points farther from a fitted plane do not belong to it.</source>
        <translation>离拟合平面更远的点不属于该平面。</translation>
    </message>
    <message>
        <source>How far ground and arm may lean against what they stand for, by their make; part of every sigma.</source>
        <translation>地面和臂因制造等原因可能偏离其所代表平面的程度；计入每个标准差。</translation>
    </message>
    <message>
        <source>Which session shows the ground, counted from 1; 0: by name or order.</source>
        <translation>哪一份数据是地面，从 1 起计；0：按名称或顺序。</translation>
    </message>
    <message>
        <source>Which session shows the arm swept up and down, counted from 1; 0: by name or order.</source>
        <translation>哪一份数据是臂上下摆动，从 1 起计；0：按名称或顺序。</translation>
    </message>
    <message>
        <source>Which session is the full turn, counted from 1; 0: by name or order.</source>
        <translation>哪一份数据是整圈回转，从 1 起计；0：按名称或顺序。</translation>
    </message>
    <message>
        <source>Pairs of keyframes</source>
        <translation>关键帧对</translation>
    </message>
    <message>
        <source>Trajectory alignment</source>
        <translation>轨迹对齐</translation>
    </message>
    <message>
        <source>Vehicle frame</source>
        <translation>车体坐标系</translation>
    </message>
    <message>
        <source>Multi-sensor odometry</source>
        <translation>多传感器里程计</translation>
    </message>
    <message>
        <source>Slewing machine</source>
        <translation>回转机械</translation>
    </message>
    <message>
        <source>scans or LiDAR poses, and an INS with attitude</source>
        <translation>扫描或激光雷达位姿，以及带姿态的 INS</translation>
    </message>
    <message>
        <source>scans or LiDAR poses, and an INS or GNSS fixes</source>
        <translation>扫描或激光雷达位姿，以及 INS 或 GNSS 定位</translation>
    </message>
    <message>
        <source>wheel speeds, an IMU or INS, and scans or poses of the sensor</source>
        <translation>轮速、IMU 或 INS，以及扫描或传感器位姿</translation>
    </message>
    <message>
        <source>scans, and an INS with attitude</source>
        <translation>扫描，以及带姿态的 INS</translation>
    </message>
    <message>
        <source>three recordings of a LiDAR: ground, swept arm, full turn</source>
        <translation>激光雷达的三段记录：地面、摆臂、整圈回转</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>偏航</translation>
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
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>度</translation>
    </message>
    <message>
        <source>Too little data: at least %1 poses of the LiDAR with INS poses or GNSS fixes over a few metres are needed.</source>
        <translation>数据太少：至少需要 %1 个有 INS 位姿或 GNSS 定位的激光雷达位姿，且移动数米。</translation>
    </message>
    <message>
        <source>Look at the odometry: is it of this drive, and do its stamps agree with those of the INS or the GNSS?</source>
        <translation>请检查里程计：它是否属于这次行驶，时间戳是否与 INS 或 GNSS 一致？</translation>
    </message>
    <message>
        <source>The trajectory could not be aligned: its equations have no solution.</source>
        <translation>轨迹无法对齐：其方程无解。</translation>
    </message>
    <message>
        <source>rotation: not observable, the positions of an antenna have no axes</source>
        <translation>旋转：不可观测，天线的位置没有坐标轴</translation>
    </message>
    <message>
        <source>The lever arm&apos;s x and y need turns: drive a figure of eight.</source>
        <translation>杆臂的 x 和 y 需要转弯：请行驶 8 字形。</translation>
    </message>
    <message>
        <source>The lever arm&apos;s z needs pitch or roll: drive over a ramp or a bumpy road, or measure it by tape.</source>
        <translation>杆臂的 z 需要俯仰或横滚：请驶过坡道或颠簸路面，或用卷尺测量。</translation>
    </message>
    <message>
        <source>GNSS positions show where the antenna is from the LiDAR and nothing about attitude: for all six parameters record an INS with attitude or a GNSS with two antennas.</source>
        <translation>GNSS 位置只反映天线相对激光雷达的位置，不反映姿态：要得到全部六个参数，请记录带姿态的 INS 或双天线 GNSS。</translation>
    </message>
    <message>
        <source>%1 of %2 scans cannot be read and are left out. First: %3</source>
        <translation>%2 次扫描中有 %1 次无法读取，已略去。第一个：%3</translation>
    </message>
    <message>
        <source>%1 of %2 scans could not be aligned with the local map; their poses are predicted from the motion before. First: %3: %4.</source>
        <translation>%2 次扫描中有 %1 次无法与局部地图配准；其位姿由先前的运动预测。第一个：%3：%4。</translation>
    </message>
    <message>
        <source>%1 of %2 scans do not determine every direction of motion; what they leave open counts as hardly known.</source>
        <translation>%2 次扫描中有 %1 次不能确定运动的每个方向；未确定的部分按几乎未知计。</translation>
    </message>
    <message>
        <source>No pose of the LiDAR lies within the data of the INS or between GNSS fixes. Give data of the same time, on one clock.</source>
        <translation>没有激光雷达位姿落在 INS 数据之内或 GNSS 定位之间。请给出同一时间、同一时钟的数据。</translation>
    </message>
    <message>
        <source>%1 of %2 positions and attitudes contradict the motion of the LiDAR and have no weight.</source>
        <translation>%2 个位置和姿态中有 %1 个与激光雷达的运动矛盾，不计权重。</translation>
    </message>
    <message>
        <source>X had converged after %1 s of data.</source>
        <translation>经过 %1 秒的数据，X 已收敛。</translation>
    </message>
    <message>
        <source>X has not converged to the sigmas that trajectory.converged_translation_m and trajectory.converged_rotation_deg ask for.</source>
        <translation>X 没有收敛到 trajectory.converged_translation_m 和 trajectory.converged_rotation_deg 要求的标准差。</translation>
    </message>
    <message>
        <source>The odometry is complete, but no session has an INS with attitude to calibrate against.</source>
        <translation>里程计已完成，但没有一份数据有带姿态的 INS 可供标定。</translation>
    </message>
    <message>
        <source>Write the poses with &quot;remount-cli odometry&quot;, or add a session with an INS.</source>
        <translation>请用 “remount-cli odometry” 写出位姿，或添加带 INS 的数据。</translation>
    </message>
    <message>
        <source>The format does not say whether its scans are compensated for motion: the odometry uses them as they are. Set run.deskew=on to compensate them.</source>
        <translation>该格式未说明扫描是否已作运动补偿：里程计按原样使用。要补偿请设置 run.deskew=on。</translation>
    </message>
    <message>
        <source>%1 of %2 scans have points whose times are not finite or more than 5 s from the stamp: they are used without compensation of motion.</source>
        <translation>%2 帧扫描中有 %1 帧的点时间不是有限值或距时间戳超过 5 秒：这些扫描不作运动补偿。</translation>
    </message>
    <message>
        <source>The session has %1, but no scan could use them. Check that their stamps are on the scans&apos; clock and their samples less than 0.25 s apart.</source>
        <translation>会话有%1，但没有扫描能使用。请检查其时间戳与扫描同属一个时钟，且采样间隔小于 0.25 秒。</translation>
    </message>
    <message>
        <source>fusion.ins_x_m to fusion.ins_roll_deg are all zero: the INS is taken to sit on the ground under the rear axle. Set where it sits, or the wheels pull the odometry the wrong way in turns.</source>
        <translation>fusion.ins_x_m 至 fusion.ins_roll_deg 全为零：INS 被视为位于后轴下方的地面。请设置其实际位置，否则转弯时轮速会使里程计偏离。</translation>
    </message>
    <message>
        <source>The scans did not fit the map any more, as after a gap: %1 times it was begun anew at the predicted pose, and poses before and after do not fit together.</source>
        <translation>扫描已与地图不符，如在间断之后：地图有 %1 次在预测位姿处重新开始，前后位姿互不衔接。</translation>
    </message>
    <message>
        <source>The session has no INS with attitude: its odometry takes no part in the calibration.</source>
        <translation>该会话没有带姿态的 INS：其里程计不参与标定。</translation>
    </message>
    <message>
        <source>1-sigma of the part of their error that stays over the drive.</source>
        <translation>其误差中在整个行驶过程中保持不变部分的标准差。</translation>
    </message>
    <message>
        <source>1-sigma of the part of its error that stays: weather, and the start&apos;s.</source>
        <translation>其误差中保持不变部分的标准差：天气，以及起点的误差。</translation>
    </message>
    <message>
        <source>%1 Its pose is the prediction of the odometry.</source>
        <translation>%1 其位姿取里程计的预测。</translation>
    </message>
    <message>
        <source>The session has no %1: the odometry does without.</source>
        <translation>数据中没有%1：里程计不使用它。</translation>
    </message>
    <message>
        <source>wheel speeds</source>
        <translation>轮速</translation>
    </message>
    <message>
        <source>angular rates</source>
        <translation>角速度</translation>
    </message>
    <message>
        <source>accelerations</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>a barometer</source>
        <translation>气压计</translation>
    </message>
    <message>
        <source>%1 of %2 scans do not tell of every direction of the motion; there it rests on wheels and gyroscope.</source>
        <translation>%2 次扫描中有 %1 次不能反映运动的每个方向；此处依靠轮速和陀螺。</translation>
    </message>
    <message>
        <source>%1 of %2 scans do not tell of every direction of the motion, nor do wheels: there a steady motion was assumed, and poses may be far off. Record wheel speeds, or drive where there is more to see.</source>
        <translation>%2 次扫描中有 %1 次不能反映运动的每个方向，轮速也不能：此处按匀速运动处理，位姿可能偏差很大。请记录轮速，或在特征更多的地方行驶。</translation>
    </message>
    <message>
        <source>Without a nominal mounting the odometry uses the scans alone. Give --nominal to use wheels, IMU and barometer as well.</source>
        <translation>没有名义安装时里程计只使用扫描。要同时使用轮速、IMU 和气压计，请给出 --nominal。</translation>
    </message>
    <message>
        <source>The solution did not converge: wheels, IMU and the sensor&apos;s poses do not fit together. Check their time stamps and units.</source>
        <translation>求解未收敛：轮速、IMU 和传感器位姿互不相符。请检查它们的时间戳和单位。</translation>
    </message>
    <message>
        <source>the solution did not converge</source>
        <translation>求解未收敛</translation>
    </message>
    <message>
        <source>the solution was cancelled</source>
        <translation>求解已取消</translation>
    </message>
    <message>
        <source>Vehicle from sensor by %1 intervals of wheels and IMU; %2.</source>
        <translation>由 %1 段轮速和 IMU 间隔求得传感器在车体中的位姿；%2。</translation>
    </message>
    <message>
        <source>all six parameters are observed</source>
        <translation>六个参数全部可观测</translation>
    </message>
    <message>
        <source>some parameters are not observed</source>
        <translation>部分参数不可观测</translation>
    </message>
    <message>
        <source>Only %1 intervals of the drive have poses of the sensor, wheel speeds and IMU rates at the same time; at least %2 are needed.</source>
        <translation>行驶中只有 %1 段间隔同时有传感器位姿、轮速和 IMU 角速度；至少需要 %2 段。</translation>
    </message>
    <message>
        <source>Check that the streams overlap in time (one clock) and that the vehicle moves; drive at least 100 m with turns.</source>
        <translation>请检查各数据流在时间上重叠（同一时钟）且车辆在运动；至少行驶 100 米并有转弯。</translation>
    </message>
    <message>
        <source>%1 of %2 scans could not be aligned: %3: %4.</source>
        <translation>%2 次扫描中有 %1 次无法配准：%3：%4。</translation>
    </message>
    <message>
        <source>There is no IMU: turns are taken from the attitude of the INS.</source>
        <translation>没有 IMU：转角取自 INS 的姿态。</translation>
    </message>
    <message>
        <source>The height of the sensor is not observed: the ground was too flat. Drive over ramps or slopes, or measure it.</source>
        <translation>传感器的高度不可观测：路面太平。请驶过坡道或斜坡，或直接测量。</translation>
    </message>
    <message>
        <source>There is no turn to compare.</source>
        <translation>没有可比较的转动。</translation>
    </message>
    <message>
        <source>The turns are too small to show the rotation between the two sensors.</source>
        <translation>转动太小，不能反映两个传感器之间的旋转。</translation>
    </message>
    <message>
        <source>All turns are about %1: the rotation about it is not observed, the other two angles are.</source>
        <translation>所有转动都绕%1：绕该轴的旋转不可观测，另外两个角可观测。</translation>
    </message>
    <message>
        <source>a slanted axis</source>
        <translation>一条斜轴</translation>
    </message>
    <message>
        <source>the vertical (yaw)</source>
        <translation>竖直轴（偏航）</translation>
    </message>
    <message>
        <source>the transverse axis (pitch)</source>
        <translation>横轴（俯仰）</translation>
    </message>
    <message>
        <source>the long axis (roll)</source>
        <translation>纵轴（横滚）</translation>
    </message>
    <message>
        <source>All three angles are observed: %1 deg of turn across the main axis.</source>
        <translation>三个角全部可观测：主轴以外的转动有 %1 度。</translation>
    </message>
    <message>
        <source>Positions of an antenna show no attitude; of its place %1 observed. End error of wheels and yaw rate: %2 m in %3 m (%4%).</source>
        <translation>天线的位置不反映姿态；其坐标中%1观测到。轮速和偏航角速度的终点误差：%3 m 内 %2 m（%4%）。</translation>
    </message>
    <message>
        <source>x and y are</source>
        <translation>有 x 和 y 被</translation>
    </message>
    <message>
        <source>x is</source>
        <translation>只有 x 被</translation>
    </message>
    <message>
        <source>y is</source>
        <translation>只有 y 被</translation>
    </message>
    <message>
        <source>nothing is</source>
        <translation>没有一个被</translation>
    </message>
    <message>
        <source>Give poses of a sensor (odometry of a LiDAR or a camera) to calibrate all six parameters.</source>
        <translation>要标定全部六个参数，请给出传感器的位姿（激光雷达或相机的里程计）。</translation>
    </message>
    <message>
        <source>x and y of the antenna need turns: drive tight turns in both directions.</source>
        <translation>天线的 x 和 y 需要转弯：请向两个方向急转弯行驶。</translation>
    </message>
    <message>
        <source>Without poses of a sensor only the first session is used.</source>
        <translation>没有传感器位姿时只使用第一份数据。</translation>
    </message>
    <message>
        <source>The drive cannot be integrated: %1.</source>
        <translation>无法对行驶积分：%1。</translation>
    </message>
    <message>
        <source>only %1 positions lie within the wheel speeds and yaw rates</source>
        <translation>只有 %1 个位置落在轮速和偏航角速度的时间内</translation>
    </message>
    <message>
        <source>the recordings were refused</source>
        <translation>记录未被采用</translation>
    </message>
    <message>
        <source>Taken for the recording: %1.</source>
        <translation>用作记录：%1。</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>arm</source>
        <translation>臂</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>回转</translation>
    </message>
    <message>
        <source>%1 of %2 scans of the turn could not be aligned: %3.</source>
        <translation>回转的 %2 次扫描中有 %1 次无法配准：%3。</translation>
    </message>
    <message>
        <source>it moved far from where the scan before it leads</source>
        <translation>它远离前一次扫描所预示的位置</translation>
    </message>
    <message>
        <source>The ground is not square to the slew axis; the plane of the turn was used instead.</source>
        <translation>地面不垂直于回转轴；已改用回转平面。</translation>
    </message>
    <message>
        <source>Machine from LiDAR by %1, the arm&apos;s plane and a turn of %2 deg.</source>
        <translation>由%1、臂的平面和 %2 度的回转求得激光雷达在机体中的位姿。</translation>
    </message>
    <message>
        <source>the ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>the plane of the turn</source>
        <translation>回转平面</translation>
    </message>
    <message>
        <source>The plane of the arm is missing: %1. Without it the machine&apos;s yaw is unknown.</source>
        <translation>缺少臂的平面：%1。没有它，机体的偏航未知。</translation>
    </message>
    <message>
        <source>Record the arm while it is swept up and down over its whole range with the slew angle held, in view of the LiDAR.</source>
        <translation>请保持回转角不变，让臂在激光雷达视野内全程上下摆动并记录。</translation>
    </message>
    <message>
        <source>only %1 moving points lie in one upright plane</source>
        <translation>只有 %1 个运动点位于同一个竖直平面内</translation>
    </message>
    <message>
        <source>what moved spans only %1 by %2 m (root mean square)</source>
        <translation>运动部分的范围只有 %1 × %2 m（均方根）</translation>
    </message>
    <message>
        <source>The turn gives no circle: %1.</source>
        <translation>回转不构成圆：%1。</translation>
    </message>
    <message>
        <source>only %1 poses</source>
        <translation>只有 %1 个位姿</translation>
    </message>
    <message>
        <source>the positions lie on a line or in one place</source>
        <translation>各位置在一条直线上或在同一处</translation>
    </message>
    <message>
        <source>Record one full turn of the machine at an even, slow rate, and stay clear of it.</source>
        <translation>请以均匀的慢速记录机体的一整圈回转，并远离机体。</translation>
    </message>
    <message>
        <source>The turn covers an arc of %1 deg and at least %2 deg are needed: centre and plane of a short arc hang on its noise.</source>
        <translation>回转只覆盖 %1 度的弧，至少需要 %2 度：短弧的圆心和平面取决于噪声。</translation>
    </message>
    <message>
        <source>The LiDAR runs on a circle of %1 m radius with residuals of %2 m: it sits too near the slew axis for its circle to have a plane.</source>
        <translation>激光雷达沿半径 %1 m 的圆运动，残差 %2 m：它离回转轴太近，其圆无法确定平面。</translation>
    </message>
    <message>
        <source>Mount the LiDAR farther from the slew axis, or use a registration with smaller errors (finer voxels).</source>
        <translation>请把激光雷达装得离回转轴更远，或使用误差更小的配准（更细的体素）。</translation>
    </message>
    <message>
        <source>The ground is tilted by %1 deg (sigma %2) against the plane in which the LiDAR turned, and %3 deg are allowed: it is not square to the slew axis.</source>
        <translation>地面相对激光雷达的回转平面倾斜 %1 度（标准差 %2），允许 %3 度：它不垂直于回转轴。</translation>
    </message>
    <message>
        <source>Repeat on level, even ground, or take the plane of the turn (slew.first_plane = turn).</source>
        <translation>请在水平平整的地面上重做，或采用回转平面（slew.first_plane = turn）。</translation>
    </message>
    <message>
        <source>The plane of the arm leans by %1 deg from square to the first plane, and %2 deg are allowed: the slew angle moved, or what moved is not the arm.</source>
        <translation>臂的平面与第一平面偏离垂直 %1 度，允许 %2 度：回转角有变化，或运动的不是臂。</translation>
    </message>
    <message>
        <source>Record the arm again with the slew angle held, and nobody moving near the machine.</source>
        <translation>请保持回转角不变重新记录臂，且机体附近无人走动。</translation>
    </message>
    <message>
        <source>The plane of the ground is missing: %1.</source>
        <translation>缺少地面的平面：%1。</translation>
    </message>
    <message>
        <source>the ground that is seen is a strip: its tilt is a guess</source>
        <translation>看到的地面只是一条带：其倾斜只是猜测</translation>
    </message>
    <message>
        <source>only %1 points</source>
        <translation>只有 %1 个点</translation>
    </message>
    <message>
        <source>no plane of the expected direction</source>
        <translation>没有预期方向的平面</translation>
    </message>
    <message>
        <source>only %1 points lie in one plane</source>
        <translation>只有 %1 个点位于同一平面内</translation>
    </message>
    <message>
        <source>Record the ground around the machine, or take the plane of the turn (slew.first_plane = turn).</source>
        <translation>请记录机体周围的地面，或采用回转平面（slew.first_plane = turn）。</translation>
    </message>
    <message>
        <source>%1 is not known well enough: record longer, and move the LiDAR away from the slew axis.</source>
        <translation>%1的精度不够：请记录更长时间，并让激光雷达离回转轴更远。</translation>
    </message>
    <message>
        <source>Start again.</source>
        <translation>请重新开始。</translation>
    </message>
    <message>
        <source>Not compared: %1.</source>
        <translation>未比较：%1。</translation>
    </message>
    <message>
        <source>%1 has nothing to use</source>
        <translation>%1没有可用的结果</translation>
    </message>
    <message>
        <source>%1 is in the frame &quot;%2&quot; and %3 in &quot;%4&quot;</source>
        <translation>%1在坐标系“%2”中，而%3在“%4”中</translation>
    </message>
    <message>
        <source>%1 and %2 have other INS axes</source>
        <translation>%1与%2的 INS 轴不同</translation>
    </message>
    <message>
        <source>%1 and %2 agree within what they claim: at most, %3 differs by %4 %5, %6 times the sigma of both together.</source>
        <translation>%1与%2在标称精度内一致：差别最大的%3相差 %4 %5，为两者合成标准差的 %6 倍。</translation>
    </message>
    <message>
        <source>%1 and %2 observe no component in common.</source>
        <translation>%1与%2没有共同可观测的分量。</translation>
    </message>
    <message>
        <source>LiDAR odometry</source>
        <translation>激光雷达里程计</translation>
    </message>
    <message>
        <source>odometry</source>
        <translation>里程计</translation>
    </message>
    <message>
        <source>aligning trajectories</source>
        <translation>对齐轨迹</translation>
    </message>
    <message>
        <source>solving every session alone</source>
        <translation>逐份数据单独求解</translation>
    </message>
    <message>
        <source>integrating wheels and IMU</source>
        <translation>对轮速和 IMU 积分</translation>
    </message>
    <message>
        <source>integrating wheels and yaw rate</source>
        <translation>对轮速和偏航角速度积分</translation>
    </message>
    <message>
        <source>solving vehicle frame</source>
        <translation>求解车体坐标系</translation>
    </message>
    <message>
        <source>comparing integrations</source>
        <translation>比较各种积分</translation>
    </message>
    <message>
        <source>reading the ground</source>
        <translation>读取地面</translation>
    </message>
    <message>
        <source>reading the arm</source>
        <translation>读取臂</translation>
    </message>
    <message>
        <source>aligning the turn</source>
        <translation>配准回转</translation>
    </message>
    <message>
        <source>fitting planes and circle</source>
        <translation>拟合平面和圆</translation>
    </message>
    <message>
        <source>lever arm x</source>
        <translation>杆臂 x</translation>
    </message>
    <message>
        <source>lever arm y</source>
        <translation>杆臂 y</translation>
    </message>
    <message>
        <source>lever arm z</source>
        <translation>杆臂 z</translation>
    </message>
    <message>
        <source>odometry yaw</source>
        <translation>里程计偏航</translation>
    </message>
    <message>
        <source>odometry pitch</source>
        <translation>里程计俯仰</translation>
    </message>
    <message>
        <source>odometry roll</source>
        <translation>里程计横滚</translation>
    </message>
    <message>
        <source>odometry scale</source>
        <translation>里程计尺度</translation>
    </message>
    <message>
        <source>odometry scale %1</source>
        <translation>里程计尺度 %1</translation>
    </message>
    <message>
        <source>distance driven</source>
        <translation>行驶距离</translation>
    </message>
    <message>
        <source>distance driven, %1</source>
        <translation>行驶距离，%1</translation>
    </message>
    <message>
        <source>gyroscope bias per s, roll</source>
        <translation>陀螺零偏（每秒），横滚</translation>
    </message>
    <message>
        <source>gyroscope bias per s, pitch</source>
        <translation>陀螺零偏（每秒），俯仰</translation>
    </message>
    <message>
        <source>gyroscope bias per s, yaw</source>
        <translation>陀螺零偏（每秒），偏航</translation>
    </message>
    <message>
        <source>gyroscope bias per s, roll, %1</source>
        <translation>陀螺零偏（每秒），横滚，%1</translation>
    </message>
    <message>
        <source>gyroscope bias per s, pitch, %1</source>
        <translation>陀螺零偏（每秒），俯仰，%1</translation>
    </message>
    <message>
        <source>gyroscope bias per s, yaw, %1</source>
        <translation>陀螺零偏（每秒），偏航，%1</translation>
    </message>
    <message>
        <source>wheel speed scale</source>
        <translation>轮速尺度</translation>
    </message>
    <message>
        <source>wheel speed scale, %1</source>
        <translation>轮速尺度，%1</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>尺度</translation>
    </message>
    <message>
        <source>wheel scale</source>
        <translation>轮速尺度</translation>
    </message>
    <message>
        <source>imu yaw</source>
        <translation>IMU 偏航</translation>
    </message>
    <message>
        <source>imu pitch</source>
        <translation>IMU 俯仰</translation>
    </message>
    <message>
        <source>imu roll</source>
        <translation>IMU 横滚</translation>
    </message>
    <message>
        <source>gyro bias x</source>
        <translation>陀螺零偏 x</translation>
    </message>
    <message>
        <source>gyro bias y</source>
        <translation>陀螺零偏 y</translation>
    </message>
    <message>
        <source>gyro bias z</source>
        <translation>陀螺零偏 z</translation>
    </message>
    <message>
        <source>track width</source>
        <translation>轮距</translation>
    </message>
    <message>
        <source>rotation equation singular value %1</source>
        <translation>旋转方程的奇异值 %1</translation>
    </message>
    <message>
        <source>yaw rate bias</source>
        <translation>偏航角速度零偏</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>end error</source>
        <translation>终点误差</translation>
    </message>
    <message>
        <source>end error as measured</source>
        <translation>未修正的终点误差</translation>
    </message>
    <message>
        <source>slew centre x</source>
        <translation>回转中心 x</translation>
    </message>
    <message>
        <source>slew centre y</source>
        <translation>回转中心 y</translation>
    </message>
    <message>
        <source>slew centre z</source>
        <translation>回转中心 z</translation>
    </message>
    <message>
        <source>slew radius</source>
        <translation>回转半径</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>弧度范围</translation>
    </message>
    <message>
        <source>circle residual</source>
        <translation>圆的残差</translation>
    </message>
    <message>
        <source>turn plane residual</source>
        <translation>回转平面的残差</translation>
    </message>
    <message>
        <source>ground residual</source>
        <translation>地面的残差</translation>
    </message>
    <message>
        <source>angle between ground and turn</source>
        <translation>地面与回转平面的夹角</translation>
    </message>
    <message>
        <source>arm residual</source>
        <translation>臂的残差</translation>
    </message>
    <message>
        <source>angle between arm and first plane</source>
        <translation>臂与第一平面的夹角</translation>
    </message>
    <message>
        <source>Angles of X while data arrived</source>
        <translation>数据到达过程中 X 的角度</translation>
    </message>
    <message>
        <source>Translation of X while data arrived</source>
        <translation>数据到达过程中 X 的平移</translation>
    </message>
    <message>
        <source>Trajectory before and after</source>
        <translation>对齐前后的轨迹</translation>
    </message>
    <message>
        <source>Trajectory before and after, session %1</source>
        <translation>对齐前后的轨迹，数据 %1</translation>
    </message>
    <message>
        <source>GNSS fixes</source>
        <translation>GNSS 定位</translation>
    </message>
    <message>
        <source>INS</source>
        <translation>INS</translation>
    </message>
    <message>
        <source>3 sigma of fixes</source>
        <translation>定位的 3 倍标准差</translation>
    </message>
    <message>
        <source>LiDAR odometry, laid at the start</source>
        <translation>激光雷达里程计，置于起点</translation>
    </message>
    <message>
        <source>aligned</source>
        <translation>已对齐</translation>
    </message>
    <message>
        <source>east (m)</source>
        <translation>东（米）</translation>
    </message>
    <message>
        <source>north (m)</source>
        <translation>北（米）</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>时间（秒）</translation>
    </message>
    <message>
        <source>Odometry from above</source>
        <translation>里程计俯视图</translation>
    </message>
    <message>
        <source>Odometry from above: %1</source>
        <translation>里程计俯视图：%1</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Height: %1</source>
        <translation>高度：%1</translation>
    </message>
    <message>
        <source>Pitch and roll</source>
        <translation>俯仰和横滚</translation>
    </message>
    <message>
        <source>Pitch and roll: %1</source>
        <translation>俯仰和横滚：%1</translation>
    </message>
    <message>
        <source>Scan to map</source>
        <translation>扫描到地图</translation>
    </message>
    <message>
        <source>Scan to map: %1</source>
        <translation>扫描到地图：%1</translation>
    </message>
    <message>
        <source>x of the lidar at the start [m]</source>
        <translation>起点处激光雷达 x 轴 [m]</translation>
    </message>
    <message>
        <source>y of the lidar at the start [m]</source>
        <translation>起点处激光雷达 y 轴 [m]</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>时间 [秒]</translation>
    </message>
    <message>
        <source>z of the lidar at the start [m]</source>
        <translation>起点处激光雷达 z 轴 [m]</translation>
    </message>
    <message>
        <source>angle [deg]</source>
        <translation>角度 [度]</translation>
    </message>
    <message>
        <source>rms distance of features [m]</source>
        <translation>特征距离的均方根 [m]</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Trajectory of the vehicle by three integrations</source>
        <translation>三种积分得到的车辆轨迹</translation>
    </message>
    <message>
        <source>Height along the way</source>
        <translation>沿途高度</translation>
    </message>
    <message>
        <source>Distance from the sensor&apos;s trajectory</source>
        <translation>与传感器轨迹的距离</translation>
    </message>
    <message>
        <source>x (m)</source>
        <translation>x（米）</translation>
    </message>
    <message>
        <source>y (m)</source>
        <translation>y（米）</translation>
    </message>
    <message>
        <source>z (m)</source>
        <translation>z（米）</translation>
    </message>
    <message>
        <source>way (m)</source>
        <translation>路程（米）</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>闭式</translation>
    </message>
    <message>
        <source>Euler</source>
        <translation>欧拉</translation>
    </message>
    <message>
        <source>planar</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>sensor, brought to the vehicle</source>
        <translation>传感器，换算到车体</translation>
    </message>
    <message>
        <source>Trajectory by wheels and yaw rate</source>
        <translation>轮速和偏航角速度得到的轨迹</translation>
    </message>
    <message>
        <source>bias and scale taken out</source>
        <translation>扣除零偏和尺度误差</translation>
    </message>
    <message>
        <source>as measured</source>
        <translation>未修正</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Turn of the LiDAR about the slew axis</source>
        <translation>激光雷达绕回转轴的转动</translation>
    </message>
    <message>
        <source>Distance from the fitted circle</source>
        <translation>与拟合圆的距离</translation>
    </message>
    <message>
        <source>slew angle (deg)</source>
        <translation>回转角（度）</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>LiDAR</source>
        <translation>激光雷达</translation>
    </message>
    <message>
        <source>fitted circle</source>
        <translation>拟合圆</translation>
    </message>
    <message>
        <source>slew axis</source>
        <translation>回转轴</translation>
    </message>
    <message>
        <source>from the circle</source>
        <translation>离圆的距离</translation>
    </message>
    <message>
        <source>from its plane</source>
        <translation>离圆平面的距离</translation>
    </message>
    <message>
        <source>there is no session to calibrate</source>
        <translation>没有可标定的数据</translation>
    </message>
    <message>
        <source>has no scans; the multi-sensor odometry needs them</source>
        <translation>没有扫描；多传感器里程计需要扫描</translation>
    </message>
    <message>
        <source>has neither scans nor poses of the sensor</source>
        <translation>既没有扫描也没有传感器位姿</translation>
    </message>
    <message>
        <source>has neither an IMU nor an INS: nothing tells how it turns</source>
        <translation>既没有 IMU 也没有 INS：无从得知如何转动</translation>
    </message>
    <message>
        <source>there is no recording of the turn with scans or LiDAR poses</source>
        <translation>没有带扫描或激光雷达位姿的回转记录</translation>
    </message>
    <message>
        <source>is %1, but there are %2 sessions</source>
        <translation>为 %1，但共有 %2 份数据</translation>
    </message>
    <message>
        <source>is not one of: %1</source>
        <translation>不属于：%1</translation>
    </message>
    <message>
        <source>the scale of the sensor and that of the wheels cannot both be estimated: one of them says what a metre is</source>
        <translation>传感器的尺度和车轮的尺度不能同时估计：其中之一须给出米的长度</translation>
    </message>
    <message>
        <source>the stamps of scans must ascend</source>
        <translation>扫描的时间戳必须递增</translation>
    </message>
    <message>
        <source>a scan is not later than the one before</source>
        <translation>有一次扫描不晚于前一次</translation>
    </message>
    <message>
        <source>epochs must ascend in time</source>
        <translation>各时刻必须递增</translation>
    </message>
    <message>
        <source>was not opened</source>
        <translation>未能打开</translation>
    </message>
    <message>
        <source>Edge of the voxels that thin scans and map.</source>
        <translation>抽稀扫描和地图的体素边长。</translation>
    </message>
    <message>
        <source>A scan joins the local map this far from the last one that did.</source>
        <translation>与上一次加入的扫描相距这么远时，扫描加入局部地图。</translation>
    </message>
    <message>
        <source>A scan joins the local map where the LiDAR has turned this far.</source>
        <translation>激光雷达转过这一角度时，扫描加入局部地图。</translation>
    </message>
    <message>
        <source>Scans in the local map.</source>
        <translation>局部地图中的扫描数。</translation>
    </message>
    <message>
        <source>Time between two poses of the trajectory that is aligned with the INS.</source>
        <translation>与 INS 对齐的轨迹上两个位姿的时间间隔。</translation>
    </message>
    <message>
        <source>Error of one step of LiDAR poses that do not state theirs.</source>
        <translation>激光雷达位姿未说明误差时，每一步的误差。</translation>
    </message>
    <message>
        <source>Error of the LiDAR&apos;s motion that grows with the distance of a step.</source>
        <translation>激光雷达运动中随步长距离增大的误差。</translation>
    </message>
    <message>
        <source>Error of the LiDAR&apos;s heading that grows with the distance of a step.</source>
        <translation>激光雷达航向中随步长距离增大的误差。</translation>
    </message>
    <message>
        <source>By how much all distances of the LiDAR&apos;s motion may be wrong alike.</source>
        <translation>激光雷达运动的全部距离可能有的共同比例误差。</translation>
    </message>
    <message>
        <source>How far the GNSS antenna may be from the LiDAR where nothing else is known.</source>
        <translation>没有其他信息时，GNSS 天线可能离激光雷达多远。</translation>
    </message>
    <message>
        <source>Measurements farther off than this lose their weight.</source>
        <translation>偏离更多的测量值失去权重。</translation>
    </message>
    <message>
        <source>Time between two answers while data arrive.</source>
        <translation>数据到达期间两次结果之间的时间。</translation>
    </message>
    <message>
        <source>Sigma below which a translation counts as converged.</source>
        <translation>标准差低于此值时平移视为已收敛。</translation>
    </message>
    <message>
        <source>Sigma below which an angle counts as converged.</source>
        <translation>标准差低于此值时角度视为已收敛。</translation>
    </message>
    <message>
        <source>Solved for the lever arm of the antenna; positions alone do not show the LiDAR&apos;s attitude.</source>
        <translation>已求出天线的杆臂；仅有位置不能反映激光雷达的姿态。</translation>
    </message>
    <message>
        <source>Solved for the lever arm of the antenna, of which is not observed: %1; positions alone do not show the LiDAR&apos;s attitude.</source>
        <translation>已求出天线的杆臂，其中不可观测：%1；仅有位置不能反映激光雷达的姿态。</translation>
    </message>
    <message>
        <source>The trajectories could not be aligned.</source>
        <translation>轨迹无法对齐。</translation>
    </message>
    <message>
        <source>Accelerometer bias</source>
        <translation>加速度计零偏</translation>
    </message>
    <message>
        <source>Barometer drift</source>
        <translation>气压计漂移</translation>
    </message>
    <message>
        <source>The position jumps %1 times, the farthest by %2 m at %3.</source>
        <translation>位置跳变 %1 次，最大一次在 %3，为 %2 m。</translation>
    </message>
    <message>
        <source>The drive would lie in the sea at latitude %1, longitude %2 degrees: these are radians that are taken for degrees.</source>
        <translation>行程将位于海上纬度 %1 度、经度 %2 度处：这些是被当作度的弧度。</translation>
    </message>
    <message>
        <source>The IMU turns %1 times as fast as the INS: degrees and radians are mixed up.</source>
        <translation>IMU 的转动速度是 INS 的 %1 倍：度与弧度混淆了。</translation>
    </message>
    <message>
        <source>The IMU reads a specific force of %1, where gravity alone is 9.8 m/s^2: these are units of g, or gravity was taken out.</source>
        <translation>IMU 测得的比力为 %1，而仅重力就有 9.8 m/s^2：单位是 g，或者重力已被扣除。</translation>
    </message>
    <message>
        <source>its times do not meet those of the INS or the LiDAR: %1</source>
        <translation>其时间与 INS 或 LiDAR 的时间没有重叠：%1</translation>
    </message>
    <message>
        <source>The scan has %1 points only; the usual one has %2.</source>
        <translation>该扫描只有 %1 个点；通常的扫描有 %2 个点。</translation>
    </message>
    <message>
        <source>%1 % of the points have no place (NaN, or no range) and are left out.</source>
        <translation>%1 % 的点没有位置（NaN 或没有距离），已被舍去。</translation>
    </message>
    <message>
        <source>In all %1 pairs that were looked at, the scans turn the other way round than the INS, with the ground below: the points are mirrored, one of their axes has the wrong sign.</source>
        <translation>在检查过的全部 %1 个扫描对中，扫描的转向与 INS 相反，而地面在下方：点云是镜像的，其中一个轴的符号错误。</translation>
    </message>
    <message>
        <source>NED instead of ENU (or the other way round), or a heading from north instead of a yaw from east (this looks like a compass heading)</source>
        <translation>以 NED 代替 ENU（或相反），或以从北起算的航向代替从东起算的偏航角（这看起来像罗盘航向）</translation>
    </message>
    <message>
        <source>Every relative motion of the INS is wrong; no result stands on it.</source>
        <translation>INS 的每一个相对运动都是错误的；没有结果能以此为据。</translation>
    </message>
    <message>
        <source>Declare the convention that the finding names (CSV: ins.columns.attitude.convention), or set it in the INS.</source>
        <translation>请声明该条发现所指出的约定（CSV 用 ins.columns.attitude.convention），或在 INS 中设置。</translation>
    </message>
    <message>
        <source>Heading and direction of travel have nothing to do with each other.</source>
        <translation>航向与行驶方向毫无关系。</translation>
    </message>
    <message>
        <source>Look what the log has for a heading, and how it counts; set the mounting of the INS in the INS itself.</source>
        <translation>请查看日志以什么作为航向、它如何计数；在 INS 内部设置其安装方式。</translation>
    </message>
    <message>
        <source>Roll of the INS is off by half a turn, and that of the result with it.</source>
        <translation>INS 的横滚角相差半圈，结果的横滚角也随之相差半圈。</translation>
    </message>
    <message>
        <source>Declare the convention of the attitude (ENU or NED) as the INS has it.</source>
        <translation>请按 INS 的实际情况声明姿态约定（ENU 或 NED）。</translation>
    </message>
    <message>
        <source>Scans and INS have no instant in common: there is nothing to compare.</source>
        <translation>扫描与 INS 没有共同的时刻：无从比较。</translation>
    </message>
    <message>
        <source>Give data of the same drive, on one clock; declare the time scale (UTC, GPS) of each.</source>
        <translation>请提供同一行程、同一时钟的数据；声明各自的时间系统（UTC、GPS）。</translation>
    </message>
    <message>
        <source>The stream cannot be used: no sample of it belongs to the drive.</source>
        <translation>该数据流无法使用：没有一个样本属于这次行程。</translation>
    </message>
    <message>
        <source>Declare its time scale (UTC, GPS) and unit, or leave it out.</source>
        <translation>请声明其时间系统（UTC、GPS）和单位，或者不使用它。</translation>
    </message>
    <message>
        <source>Whatever else is stamped by the host&apos;s clock is off by as much against the INS.</source>
        <translation>凡是由主机时钟打时间戳的其他数据，与 INS 也相差同样多。</translation>
    </message>
    <message>
        <source>Synchronise the host with GPS (PTP, NTP, chrony); stamp scans by GPS time (PPS) where the LiDAR can.</source>
        <translation>请使主机与 GPS 同步（PTP、NTP、chrony）；在 LiDAR 支持时用 GPS 时间（PPS）给扫描打时间戳。</translation>
    </message>
    <message>
        <source>The host&apos;s clock cannot be judged.</source>
        <translation>无法判断主机的时钟。</translation>
    </message>
    <message>
        <source>Export the log again with all digits.</source>
        <translation>请以全部位数重新导出日志。</translation>
    </message>
    <message>
        <source>Poses and INS may belong to different instants.</source>
        <translation>位姿与 INS 可能属于不同的时刻。</translation>
    </message>
    <message>
        <source>Record a drive with several turns, on one clock.</source>
        <translation>请在同一时钟上记录带有多次转弯的行程。</translation>
    </message>
    <message>
        <source>The clocks were brought together by the turns of the drive, to some milliseconds.</source>
        <translation>两个时钟是依据行程中的转弯对齐的，精度为若干毫秒。</translation>
    </message>
    <message>
        <source>Synchronise the clocks before the next drive.</source>
        <translation>下次行驶前请同步时钟。</translation>
    </message>
    <message>
        <source>Only turns tell where the LiDAR sits: straight driving tells how it is turned, no more.</source>
        <translation>只有转弯才能说明 LiDAR 的位置：直线行驶只能说明它的朝向。</translation>
    </message>
    <message>
        <source>Only tilting tells the height: on level ground it keeps the nominal value.</source>
        <translation>只有倾斜才能说明高度：在平地上高度保持标称值。</translation>
    </message>
    <message>
        <source>Drive over a ramp, a kerb with one wheel or a bumpy road while turning; where it matters, measure it by tape and give it with --measured.</source>
        <translation>请在转弯时驶过坡道、单轮压上路沿或颠簸路面；若高度重要，请用卷尺测量并用 --measured 给出。</translation>
    </message>
    <message>
        <source>No mounting turns a mirrored cloud into the world: no result can be right.</source>
        <translation>没有任何安装方式能把镜像点云转到世界中：不可能有正确的结果。</translation>
    </message>
    <message>
        <source>Give x forward, y left, z up or any other right-handed axes: turn the sign of y where the driver has y to the right.</source>
        <translation>请给出 x 向前、y 向左、z 向上或其他右手坐标轴：若驱动程序的 y 向右，请改变 y 的符号。</translation>
    </message>
    <message>
        <source>A pair across a jump tells of a motion that never was; it is rejected where that shows.</source>
        <translation>跨越跳变的扫描对所说明的运动从未发生；在能看出时它会被拒绝。</translation>
    </message>
    <message>
        <source>See whether RTK was lost there or the filter was reset; reject the pairs across it, or use a log that was processed afterwards (PPK).</source>
        <translation>请查看该处是否丢失 RTK 或滤波器被重置；拒绝跨越它的扫描对，或使用事后处理（PPK）的日志。</translation>
    </message>
    <message>
        <source>Scans that fall into a gap of the INS have no motion to be compared with, and are not used.</source>
        <translation>落在 INS 缺口中的扫描没有可比较的运动，因此不被使用。</translation>
    </message>
    <message>
        <source>Look for messages that the recorder drops (disk, network, buffers); record again where much is missing.</source>
        <translation>请检查记录程序丢失的消息（磁盘、网络、缓冲区）；缺失较多时请重新记录。</translation>
    </message>
    <message>
        <source>The INS doubts its own solution there: it may be off by more than it claims.</source>
        <translation>INS 对其自身的解有怀疑：实际误差可能大于它所声称的。</translation>
    </message>
    <message>
        <source>Record under open sky after the INS has finished aligning, or leave that part of the drive out.</source>
        <translation>请在 INS 完成对准之后在开阔天空下记录，或舍去该段行程。</translation>
    </message>
    <message>
        <source>A solution that stands still while the vehicle moves makes pairs that contradict all others.</source>
        <translation>车辆行驶而解保持不动时，得到的扫描对与所有其他扫描对矛盾。</translation>
    </message>
    <message>
        <source>Wait until the INS has aligned before you drive, and see whether the log or its driver stalled.</source>
        <translation>请在 INS 对准之后再行驶，并检查日志或其驱动程序是否停滞。</translation>
    </message>
    <message>
        <source>Scans that are listed are not there, and take no part.</source>
        <translation>列出的扫描不存在，因此不参与计算。</translation>
    </message>
    <message>
        <source>Copy the recording again, whole.</source>
        <translation>请重新完整地复制记录。</translation>
    </message>
    <message>
        <source>Scans without a time cannot be used.</source>
        <translation>没有时间的扫描无法使用。</translation>
    </message>
    <message>
        <source>Copy the file of stamps again, as it was recorded.</source>
        <translation>请按记录时的原样重新复制时间戳文件。</translation>
    </message>
    <message>
        <source>Positions far from all others are glitches of the receiver, and left out.</source>
        <translation>远离所有其他位置的位置是接收机的偶发错误，已被舍去。</translation>
    </message>
    <message>
        <source>Nothing, where they are few; otherwise the log holds more than one drive.</source>
        <translation>数量很少时无须处理；否则该日志包含不止一次行程。</translation>
    </message>
    <message>
        <source>Files whose names are no stamps are left out.</source>
        <translation>名称不是时间戳的文件已被舍去。</translation>
    </message>
    <message>
        <source>Name scans by their time, or give a table of stamps.</source>
        <translation>请用时间给扫描命名，或提供时间戳表。</translation>
    </message>
    <message>
        <source>Lines that are damaged are left out.</source>
        <translation>损坏的行已被舍去。</translation>
    </message>
    <message>
        <source>Export the log again where they are many.</source>
        <translation>损坏的行较多时请重新导出日志。</translation>
    </message>
    <message>
        <source>Positions drift while corrections are missing, and jump when they come back.</source>
        <translation>缺少差分改正时位置会漂移，恢复时会跳变。</translation>
    </message>
    <message>
        <source>Check the link to the corrections; record under open sky, or process the log afterwards (PPK).</source>
        <translation>请检查差分改正的链路；在开阔天空下记录，或事后处理日志（PPK）。</translation>
    </message>
    <message>
        <source>Few points do not hold a scan in place: its pairs are rejected or loose.</source>
        <translation>点数太少无法固定扫描的位置：它的扫描对会被拒绝或不牢固。</translation>
    </message>
    <message>
        <source>See whether the sensor was blocked, or packets were lost; record sweeps whole.</source>
        <translation>请检查传感器是否被遮挡或是否丢包；请完整记录每一圈扫描。</translation>
    </message>
    <message>
        <source>Points without a place are left out, nothing else is.</source>
        <translation>只舍去没有位置的点，其余不受影响。</translation>
    </message>
    <message>
        <source>Nothing, where they are beams without a return; otherwise check the driver of the sensor.</source>
        <translation>若是没有回波的光束则无须处理；否则请检查传感器的驱动程序。</translation>
    </message>
    <message>
        <source>A scan that cannot be read takes no part.</source>
        <translation>无法读取的扫描不参与计算。</translation>
    </message>
    <message>
        <source>Copy or export the scan again.</source>
        <translation>请重新复制或导出该扫描。</translation>
    </message>
    <message>
        <source>See whether two recorders write into one log, or whether stamps are rounded.</source>
        <translation>请检查是否有两个记录程序写入同一日志，或时间戳是否被舍入。</translation>
    </message>
    <message>
        <source>Entries that go back in time are left out; where they belong is not known.</source>
        <translation>时间倒退的条目已被舍去；无法知道它们属于何处。</translation>
    </message>
    <message>
        <source>Check the clock of the recorder: it was set while it recorded, or messages were put in order of arrival.</source>
        <translation>请检查记录程序的时钟：记录期间时钟被调整过，或消息按到达顺序排列。</translation>
    </message>
    <message>
        <source>Entries without a possible time are left out.</source>
        <translation>没有可能时间的条目已被舍去。</translation>
    </message>
    <message>
        <source>Declare the unit of the stamps (s, ms, us, ns) as the log has it.</source>
        <translation>请按日志的实际情况声明时间戳的单位（s、ms、us、ns）。</translation>
    </message>
    <message>
        <source>Angles in the wrong unit make every attitude wrong.</source>
        <translation>角度单位错误会使每个姿态都错误。</translation>
    </message>
    <message>
        <source>Declare attitude: {unit: deg} or {unit: rad} as the log has it.</source>
        <translation>请按日志的实际情况声明 attitude: {unit: deg} 或 {unit: rad}。</translation>
    </message>
    <message>
        <source>The whole drive shrinks to centimetres, and nothing agrees with the LiDAR.</source>
        <translation>整个行程缩小到厘米级，与 LiDAR 毫不相符。</translation>
    </message>
    <message>
        <source>Declare the unit of latitude and longitude as the log has it.</source>
        <translation>请按日志的实际情况声明纬度和经度的单位。</translation>
    </message>
    <message>
        <source>Odometry that lives on the IMU turns dozens of times too far, or hardly.</source>
        <translation>依赖 IMU 的里程计会转过头几十倍，或几乎不转。</translation>
    </message>
    <message>
        <source>Declare the unit of the angular rate as the log has it.</source>
        <translation>请按日志的实际情况声明角速度的单位。</translation>
    </message>
    <message>
        <source>The direction of gravity is found, but forces are taken for a tenth of what they are.</source>
        <translation>重力方向可以找到，但比力被当作实际的十分之一。</translation>
    </message>
    <message>
        <source>Declare the unit of the specific force; record raw values, with gravity in them.</source>
        <translation>请声明比力的单位；记录包含重力的原始值。</translation>
    </message>
    <message>
        <source>Roll and pitch are guesses: of the mounting only yaw, and x and y, can be relied on.</source>
        <translation>横滚角和俯仰角是猜测的：安装参数中只有偏航角以及 x 和 y 可以信赖。</translation>
    </message>
    <message>
        <source>The bag has no usable index (%1). It was read from the beginning: %2 messages in %3 chunks were found. %4</source>
        <translation>bag 没有可用的索引（%1）。已从头读取：在 %3 个块中找到 %2 条消息。%4</translation>
    </message>
    <message>
        <source>The bag has no usable index (%1). It was read from the beginning: %2 messages were found; %3 bytes at the end are not readable.%4</source>
        <translation>bag 没有可用的索引（%1）。已从头读取：找到 %2 条消息；末尾 %3 字节无法读取。%4</translation>
    </message>
    <message>
        <source>Parts of the bag are missing: %1.</source>
        <translation>bag 缺少部分文件：%1。</translation>
    </message>
    <message>
        <source>The messages have no stamps; the times at which they were recorded are used. They are late by the delay of the recorder.</source>
        <translation>消息没有时间戳；使用记录时刻，它们因记录器的延迟而偏晚。</translation>
    </message>
    <message>
        <source>The static transforms lead from %1 to %2; that serves as the nominal.</source>
        <translation>静态变换由 %1 通到 %2；用作名义安装。</translation>
    </message>
    <message>
        <source>The static transforms do not lead from %1 to %2.</source>
        <translation>静态变换不能由 %1 通到 %2。</translation>
    </message>
    <message>
        <source>Of several topics this one serves as %1; not used: %2. --topic %3=TOPIC takes another.</source>
        <translation>在多个话题中，此话题用作 %1；未使用：%2。--topic %3=TOPIC 可改用其他话题。</translation>
    </message>
    <message>
        <source>pole</source>
        <translation>杆状物</translation>
    </message>
    <message>
        <source>facade</source>
        <translation>立面</translation>
    </message>
    <message>
        <source>vehicle-sized</source>
        <translation>车辆大小</translation>
    </message>
    <message>
        <source>small</source>
        <translation>小</translation>
    </message>
    <message>
        <source>large</source>
        <translation>大</translation>
    </message>
    <message>
        <source>The sessions say different mountings: session %1 against the rest.</source>
        <translation>各数据给出不同的安装：数据 %1 与其余相矛盾。</translation>
    </message>
    <message>
        <source>Session %1 was left out: the others agree with each other and contradict it. Look at its INS, its clock, and whether the lidar was moved.</source>
        <translation>数据 %1 未采用：其余数据彼此一致并与它矛盾。请检查它的惯导、时钟，以及激光雷达是否被移动过。</translation>
    </message>
    <message>
        <source>Session %1 agrees with itself on another mounting than the rest and was left out: was the lidar moved, or is it another vehicle? Calibrate it on its own.</source>
        <translation>数据 %1 自身一致，但安装与其余不同，未采用：激光雷达是否被移动过，或者是另一辆车？请单独标定它。</translation>
    </message>
    <message>
        <source>Session %1 was left out: its INS motion and its registrations contradict each other.</source>
        <translation>数据 %1 未采用：其惯导运动与配准相互矛盾。</translation>
    </message>
    <message>
        <source>is no session itself; open those of one vehicle below it:%1</source>
        <translation>本身不是数据；请打开其下属于同一辆车的数据：%1</translation>
    </message>
    <message>
        <source>gnss-log: an NMEA log (GGA, with PASHR or HDT for attitude) or a GPX track, and a file of LiDAR poses</source>
        <translation>gnss-log：NMEA 日志（GGA，姿态用 PASHR 或 HDT）或 GPX 轨迹，以及一个激光雷达位姿文件</translation>
    </message>
    <message>
        <source>KITTI raw drive: a folder &lt;date&gt;_drive_XXXX_sync or _extract with oxts/ and velodyne_points/</source>
        <translation>KITTI raw：含 oxts/ 和 velodyne_points/ 的文件夹 &lt;date&gt;_drive_XXXX_sync 或 _extract</translation>
    </message>
    <message>
        <source>Remount session: a folder with session.yaml (or that file) that declares scans or LiDAR poses and an INS table</source>
        <translation>Remount 数据：含 session.yaml 的文件夹（或该文件），其中声明扫描或激光雷达位姿以及 INS 表</translation>
    </message>
    <message>
        <source>NovAtel INSPVAX: an ASCII log (#INSPVAXA) or a CSV exported from a bag, in a folder with LiDAR poses (A-LOAM CSV, TUM, ETH CSV)</source>
        <translation>NovAtel INSPVAX：ASCII 日志 (#INSPVAXA) 或从 bag 导出的 CSV，与激光雷达位姿（A-LOAM CSV、TUM、ETH CSV）在同一文件夹</translation>
    </message>
    <message>
        <source>OpenCalib: a folder with pose lines (stamp and 12 numbers) of the INS, and PCD files named by their stamps or LiDAR poses</source>
        <translation>OpenCalib：含 INS 位姿行（时间戳和 12 个数）以及按时间戳命名的 PCD 文件或激光雷达位姿的文件夹</translation>
    </message>
    <message>
        <source>Pose files: a folder with two (TUM, ETH CSV, A-LOAM CSV, pose lines), one named ins/imu/hand/vicon/body, one lidar/camera/cam/odom/laser; or a single one to inspect</source>
        <translation>位姿文件：含两个文件的文件夹（TUM、ETH CSV、A-LOAM CSV、位姿行），一个名为 ins/imu/hand/vicon/body，一个名为 lidar/camera/cam/odom/laser；或单个文件供查看</translation>
    </message>
    <message>
        <source>smartLoc: NAME_Input.txt with odom3 lines (wheel speed, turn rate), or a folder with one, and NAME_GT.txt beside it</source>
        <translation>smartLoc：含 odom3 行（轮速、转动角速度）的 NAME_Input.txt，或含它的文件夹，旁边有 NAME_GT.txt</translation>
    </message>
    <message>
        <source>ROS bag: .bag (ROS 1), .mcap or .db3 (ROS 2), or a folder that holds one; PointCloud2 or Livox scans, and INSPVAX, Odometry, poses, or NavSatFix with Imu</source>
        <translation>ROS bag：.bag (ROS 1)、.mcap 或 .db3 (ROS 2)，或含它的文件夹；PointCloud2 或 Livox 扫描，以及 INSPVAX、Odometry、位姿，或 NavSatFix 加 Imu</translation>
    </message>
    <message>
        <source>all pairs: Park-Martin</source>
        <translation>所有帧对：Park-Martin</translation>
    </message>
    <message>
        <source>all pairs: dual quaternion</source>
        <translation>所有帧对：对偶四元数</translation>
    </message>
    <message>
        <source>all pairs: joint quadratic</source>
        <translation>所有帧对：联合二次型</translation>
    </message>
    <message>
        <source>all pairs: certified optimum</source>
        <translation>所有帧对：经证明的最优解</translation>
    </message>
    <message>
        <source>all pairs: best found in range</source>
        <translation>所有帧对：范围内找到的最优解</translation>
    </message>
    <message>
        <source>Remount result as YAML, with sigma, pairs and provenance</source>
        <translation>Remount 结果（YAML），含 sigma、帧对和来源</translation>
    </message>
    <message>
        <source>Remount result as JSON, with sigma, pairs and provenance</source>
        <translation>Remount 结果（JSON），含 sigma、帧对和来源</translation>
    </message>
    <message>
        <source>4x4 matrix as text</source>
        <translation>4x4 矩阵（文本）</translation>
    </message>
    <message>
        <source>ROS 1 launch file with a static_transform_publisher</source>
        <translation>ROS 1 启动文件（static_transform_publisher）</translation>
    </message>
    <message>
        <source>ROS 2 launch file (XML) with a static_transform_publisher</source>
        <translation>ROS 2 启动文件（XML，static_transform_publisher）</translation>
    </message>
    <message>
        <source>Autoware sensor_kit_calibration.yaml (kit base = the INS frame)</source>
        <translation>Autoware sensor_kit_calibration.yaml（套件基座 = INS 坐标系）</translation>
    </message>
    <message>
        <source>Apollo *_novatel_extrinsics.yaml, INS axes as in the result</source>
        <translation>Apollo *_novatel_extrinsics.yaml，INS 轴与结果相同</translation>
    </message>
    <message>
        <source>Apollo *_novatel_extrinsics.yaml, INS axes right-forward-up</source>
        <translation>Apollo *_novatel_extrinsics.yaml，INS 轴为右-前-上</translation>
    </message>
    <message>
        <source>KITTI calib_imu_to_velo.txt</source>
        <translation>KITTI calib_imu_to_velo.txt</translation>
    </message>
    <message>
        <source>OpenCalib extrinsic JSON</source>
        <translation>OpenCalib 外参（JSON）</translation>
    </message>
    <message>
        <source>URDF fixed joint</source>
        <translation>URDF 固定关节</translation>
    </message>
    <message>
        <source>lidar to ins: point_in_ins = ins_from_lidar * point_in_lidar</source>
        <translation>激光雷达到 INS：point_in_ins = ins_from_lidar * point_in_lidar</translation>
    </message>
    <message>
        <source>lidar to ins: point_in_ins = matrix * point_in_lidar</source>
        <translation>激光雷达到 INS：point_in_ins = matrix * point_in_lidar</translation>
    </message>
    <message>
        <source>lidar to ins (pose of the lidar frame in the ins frame)</source>
        <translation>激光雷达到 INS（激光雷达坐标系在 INS 坐标系中的位姿）</translation>
    </message>
    <message>
        <source>lidar to ins (pose of the lidar frame in the kit&apos;s base, in radians)</source>
        <translation>激光雷达到 INS（激光雷达坐标系在套件基座中的位姿，角度为弧度）</translation>
    </message>
    <message>
        <source>lidar to ins (header.frame_id from child_frame_id)</source>
        <translation>激光雷达到 INS（由 child_frame_id 到 header.frame_id）</translation>
    </message>
    <message>
        <source>lidar to ins, the INS axes turned from x forward, y left to x right, y forward</source>
        <translation>激光雷达到 INS，INS 轴由 x 向前、y 向左转为 x 向右、y 向前</translation>
    </message>
    <message>
        <source>ins to lidar, the inverse of X: point_in_lidar = R point_in_ins + T</source>
        <translation>INS 到激光雷达，即 X 的逆：point_in_lidar = R point_in_ins + T</translation>
    </message>
    <message>
        <source>ins to lidar, the inverse of X: point_in_lidar = matrix * point_in_ins</source>
        <translation>INS 到激光雷达，即 X 的逆：point_in_lidar = matrix * point_in_ins</translation>
    </message>
    <message>
        <source>the INS axes of this result are x right, y forward, z up already and must not be turned again: export it as apollo</source>
        <translation>此结果的 INS 轴已是 x 向右、y 向前、z 向上，不得再转：请以 apollo 格式导出</translation>
    </message>
    <message>
        <source>the result does not say which axes its INS has, so that they cannot be turned: export it as apollo, which leaves them as they are</source>
        <translation>结果没有说明其 INS 的轴向，因此无法转换：请以 apollo 格式导出，它保持原样</translation>
    </message>
    <message>
        <source>the mounting is given in INS axes %1; it is turned to those of the log, %2</source>
        <translation>给出的安装采用 INS 轴 %1；已转到日志的轴 %2</translation>
    </message>
    <message>
        <source>%1 session, now %2</source>
        <translation>%1 份数据，现为 %2 份</translation>
    </message>
    <message>
        <source>%1 sessions, now %2</source>
        <translation>%1 份数据，现为 %2 份</translation>
    </message>
    <message>
        <source>nominal mounting unknown, now given</source>
        <translation>当时没有名义安装，现已给出</translation>
    </message>
    <message>
        <source>nominal mounting given, now unknown</source>
        <translation>当时给出了名义安装，现为未知</translation>
    </message>
    <message>
        <source>another nominal mounting</source>
        <translation>名义安装已不同</translation>
    </message>
    <message>
        <source>%1, now %2</source>
        <translation>%1，现为 %2</translation>
    </message>
    <message>
        <source>range.%1: the minimum %2 exceeds the maximum %3</source>
        <translation>range.%1：最小值 %2 大于最大值 %3</translation>
    </message>
    <message>
        <source>%1 = %2 exceeds %3 = %4</source>
        <translation>%1 = %2 大于 %3 = %4</translation>
    </message>
    <message>
        <source>vehicle_frame.scale and vehicle_frame.estimate_wheel_scale: one of the two must be known</source>
        <translation>vehicle_frame.scale 与 vehicle_frame.estimate_wheel_scale：两者必须已知其一</translation>
    </message>
    <message>
        <source>the outline&apos;s rear end is not behind its front end</source>
        <translation>轮廓的后端不在前端之后</translation>
    </message>
    <message>
        <source>the outline&apos;s right side is not right of its left side</source>
        <translation>轮廓的右侧不在左侧之右</translation>
    </message>
    <message>
        <source>cannot be saved, its folder cannot be opened: %1; nothing was replaced</source>
        <translation>无法保存，无法打开其所在文件夹：%1；未替换任何内容</translation>
    </message>
    <message>
        <source>cannot be saved, the link cannot be read: %1; nothing was replaced</source>
        <translation>无法保存，无法读取该链接：%1；未替换任何内容</translation>
    </message>
    <message>
        <source>is saved, but the disk does not confirm it: %1; save it again, or elsewhere</source>
        <translation>已保存，但磁盘未确认写入：%1；请再次保存，或保存到其他位置</translation>
    </message>
    <message>
        <source>cannot be listed: %1</source>
        <translation>无法列出其内容：%1</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>文件名过长</translation>
    </message>
    <message>
        <source>Stale file handle</source>
        <translation>文件句柄已失效</translation>
    </message>
    <message>
        <source>What lies in the damaged part of the bag takes no part.</source>
        <translation>bag 损坏部分中的数据不参与计算。</translation>
    </message>
    <message>
        <source>Copy the bag again, whole; close the recorder before copying. rosbag reindex (.bag) or mcap recover (.mcap) restore an index, sqlite3&apos;s .recover what is whole of a .db3.</source>
        <translation>请重新完整复制 bag；复制前先关闭录制程序。可用 rosbag reindex（.bag）或 mcap recover（.mcap）恢复索引，用 sqlite3 的 .recover 取回 .db3 中完好的部分。</translation>
    </message>
    <message>
        <source>The clocks were brought together by the recorder&apos;s, as well as it took messages down.</source>
        <translation>各时钟已按录制程序的时钟对齐，精度取决于其记录消息的及时程度。</translation>
    </message>
    <message>
        <source>Synchronise the clocks before the next drive; look at the clock offset of the result.</source>
        <translation>下次行驶前请同步时钟；请查看结果中的时钟偏差。</translation>
    </message>
    <message>
        <source>Within a scan, points may be compensated for the motion of another instant.</source>
        <translation>扫描内的点可能按另一时刻的运动做了补偿。</translation>
    </message>
    <message>
        <source>Have the driver stamp scans and points by one clock.</source>
        <translation>请让驱动程序用同一时钟为扫描和点打时间戳。</translation>
    </message>
    <message>
        <source>Either the LiDAR sits otherwise than assumed, or the nominal is given in other terms.</source>
        <translation>激光雷达的实际安装与假定不同，或名义值采用了其他约定。</translation>
    </message>
    <message>
        <source>Look at the vehicle; check axes, signs, order of angles and direction of the nominal.</source>
        <translation>请查看车辆；检查名义值的坐标轴、符号、角度顺序和变换方向。</translation>
    </message>
    <message>
        <source>The accumulated scans contradict the result, whatever its residuals say.</source>
        <translation>无论残差如何，累积的扫描与结果相矛盾。</translation>
    </message>
    <message>
        <source>Look at the pairs that were accepted and at the clock offset; do not use the result before that.</source>
        <translation>请检查已接受的帧对和时钟偏差；在此之前不要使用该结果。</translation>
    </message>
    <message>
        <source>scans of %1 points that have times</source>
        <translation>每帧 %1 点的扫描，点带时间</translation>
    </message>
    <message>
        <source>scans of %1 points without times</source>
        <translation>每帧 %1 点的扫描，点不带时间</translation>
    </message>
    <message>
        <source>scans; the first cannot be read</source>
        <translation>扫描；第一帧无法读取</translation>
    </message>
    <message>
        <source>rare, as maps are: %1 points</source>
        <translation>发布稀少，像是地图：%1 点</translation>
    </message>
    <message>
        <source>poses: they stand for the LiDAR where they are asked for</source>
        <translation>位姿：指定时可代表激光雷达</translation>
    </message>
    <message>
        <source>position and attitude of the INS itself</source>
        <translation>INS 自身的位置和姿态</translation>
    </message>
    <message>
        <source>poses; the name speaks of an INS</source>
        <translation>位姿；名称表明来自 INS</translation>
    </message>
    <message>
        <source>poses; the name does not say of what</source>
        <translation>位姿；名称未说明来源</translation>
    </message>
    <message>
        <source>its name speaks of another sensor than an INS</source>
        <translation>名称表明来自 INS 以外的传感器</translation>
    </message>
    <message>
        <source>it stands for the LiDAR</source>
        <translation>它代表激光雷达</translation>
    </message>
    <message>
        <source>an orientation, to which fixes give the position</source>
        <translation>姿态，由定位消息给出位置</translation>
    </message>
    <message>
        <source>an orientation, but no fixes are there to give the position</source>
        <translation>姿态，但没有定位消息给出位置</translation>
    </message>
    <message>
        <source>fixes; by its name of the device of the orientation</source>
        <translation>定位；名称表明与姿态来自同一设备</translation>
    </message>
    <message>
        <source>fixes of a receiver</source>
        <translation>接收机的定位</translation>
    </message>
    <message>
        <source>fixes that place the INS already</source>
        <translation>已用作 INS 位置的定位</translation>
    </message>
    <message>
        <source>turn rates and accelerations</source>
        <translation>角速度和加速度</translation>
    </message>
    <message>
        <source>where the transforms lead from the LiDAR to the INS</source>
        <translation>若变换从激光雷达通向 INS</translation>
    </message>
    <message>
        <source>it has no messages</source>
        <translation>没有消息</translation>
    </message>
    <message>
        <source>its messages are serialised in a way that is not read</source>
        <translation>其消息的序列化方式无法读取</translation>
    </message>
    <message>
        <source>transforms that change with time are not read</source>
        <translation>不读取随时间变化的变换</translation>
    </message>
    <message>
        <source>neither its orientation nor its rates are measured</source>
        <translation>既没有测量姿态，也没有测量角速度</translation>
    </message>
    <message>
        <source>messages of this type are not read</source>
        <translation>不读取此类型的消息</translation>
    </message>
    <message>
        <source>was chosen for lidar and for ins: a motion that is compared with itself tells nothing</source>
        <translation>同时被选作 lidar 和 ins：运动与自身比较说明不了任何问题</translation>
    </message>
    <message>
        <source>a heading from north instead of a yaw from east (this looks like a compass heading)</source>
        <translation>以北为零的航向角，而非以东为零的偏航角（看起来像罗盘航向）</translation>
    </message>
    <message>
        <source>was there when it was opened and is gone now: nothing is made of the part that could be read</source>
        <translation>打开时存在，现已消失：不使用只读到的部分</translation>
    </message>
    <message>
        <source>contradicts the INS motion by %1 m, %2 deg (%3 sigma); turn or advance of INS and LiDAR differ</source>
        <translation>与 INS 运动相差 %1 m、%2 度（%3 sigma）；INS 与激光雷达的转角或前进量不同</translation>
    </message>
    <message>
        <source>solving</source>
        <translation>正在求解</translation>
    </message>
    <message>
        <source>Rear end of the vehicle, forward from the INS.</source>
        <translation>车尾，自 INS 沿前向计。</translation>
    </message>
    <message>
        <source>Front end of the vehicle, forward from the INS.</source>
        <translation>车头，自 INS 沿前向计。</translation>
    </message>
    <message>
        <source>Right side of the vehicle, leftward from the INS.</source>
        <translation>车右侧，自 INS 沿左向计。</translation>
    </message>
    <message>
        <source>Left side of the vehicle, leftward from the INS.</source>
        <translation>车左侧，自 INS 沿左向计。</translation>
    </message>
    <message>
        <source>Solved, but for what is not observed: %1.</source>
        <translation>已求解，但以下不可观测：%1。</translation>
    </message>
    <message>
        <source>Preliminary: the calibration was cancelled before its end, and its sigmas do not hold.</source>
        <translation>初步结果：标定未完成就被取消，其标准差不成立。</translation>
    </message>
    <message>
        <source>Calibrate again, to the end.</source>
        <translation>请重新标定，直到完成。</translation>
    </message>
    <message>
        <source>%1 needs turns: drive a figure of eight or two tight turns in each direction.</source>
        <translation>%1 需要转弯：请行驶 8 字形，或向两个方向各急转两次。</translation>
    </message>
    <message>
        <source>%1 needs more rotation: drive tighter turns, in both directions.</source>
        <translation>%1 需要更多转动：请向两个方向更急地转弯。</translation>
    </message>
    <message>
        <source>%1 needs travel: drive at least a few tens of metres with good INS quality.</source>
        <translation>%1 需要行程：请在 INS 质量良好时至少行驶几十米。</translation>
    </message>
    <message>
        <source>Nothing is known: without a nominal mounting yaw is open, and everything else depends on it.</source>
        <translation>一无所知：没有名义安装时偏航角不定，其余各量都取决于它。</translation>
    </message>
    <message>
        <source>its session contradicts all others, which agree (with it they scatter %1 times their errors)</source>
        <translation>其所属数据与彼此一致的其他数据都矛盾（计入它时离散程度为误差的 %1 倍）</translation>
    </message>
    <message>
        <source>%1 contradicts the drive by %2 sigma (%3 %4 are left): check the measurement and its sigma.</source>
        <translation>%1与行驶数据相差 %2 sigma（还差 %3 %4）：请检查测量值及其 sigma。</translation>
    </message>
    <message>
        <source>The ground in the scans with the height of the INS</source>
        <translation>扫描中的地面连同 INS 高度</translation>
    </message>
    <message>
        <source>The tilt of the ground in the scans</source>
        <translation>扫描中地面的倾斜</translation>
    </message>
    <message>
        <source>The measured %1</source>
        <translation>测得的 %1 </translation>
    </message>
    <message>
        <source>Whether the ground is square to the slew axis cannot be told: the angle between ground and turn has a sigma of %1 deg, and %2 deg are allowed.</source>
        <translation>无法判断地面是否与回转轴垂直：地面与转动之间夹角的 sigma 为 %1 度，允许 %2 度。</translation>
    </message>
    <message>
        <source>the LiDAR moves, but its attitude does not turn</source>
        <translation>激光雷达在移动，但姿态没有转动</translation>
    </message>
    <message>
        <source>what was measured contradicts the drive</source>
        <translation>测量值与行驶数据矛盾</translation>
    </message>
    <message>
        <source>The sessions contradict one another %1 times as much as their errors explain; what the pairs say counts the less. Look for one whose INS or clock is worse, and calibrate without it.</source>
        <translation>各份数据之间的矛盾是其误差所能解释的 %1 倍；帧对的结论相应降低权重。请找出 INS 或时钟较差的一份，去掉它再标定。</translation>
    </message>
    <message>
        <source>ambiguous: another alignment %1 m, %2 deg away fits as well (%3 and %4)</source>
        <translation>不唯一：相距 %1 m、%2 度的另一种配准同样吻合（%3 与 %4）</translation>
    </message>
    <message>
        <source>%1 (gap %2 of %3, %4 regions).</source>
        <translation>%1（差距 %2，总值 %3，%4 个区域）。</translation>
    </message>
    <message>
        <source>%1 (gap %2 of %3, %4 regions); others score the same.</source>
        <translation>%1（差距 %2，总值 %3，%4 个区域）；另有得分相同者。</translation>
    </message>
    <message>
        <source>Nothing in the search range scores better than this</source>
        <translation>搜索范围内没有比它得分更好的</translation>
    </message>
    <message>
        <source>Not proved to be the best of the search range: too many regions</source>
        <translation>未能证明它是搜索范围内最好的：区域太多</translation>
    </message>
    <message>
        <source>Cancelled before the search range was covered</source>
        <translation>在覆盖整个搜索范围之前被取消</translation>
    </message>
    <message>
        <source>The pairs or the search range hold numbers that are not finite.</source>
        <translation>帧对或搜索范围中有非有限的数值。</translation>
    </message>
    <message>
        <source>The search range is empty: a lower limit lies above its upper limit.</source>
        <translation>搜索范围为空：某个下限大于其上限。</translation>
    </message>
    <message>
        <source>the inverse rotation</source>
        <translation>逆旋转</translation>
    </message>
    <message>
        <source>a quaternion whose scalar part stands at the other end</source>
        <translation>标量部分位于另一端的四元数</translation>
    </message>
    <message>
        <source>The INS contradicts itself: its heading follows its travel only under another convention.</source>
        <translation>INS 自相矛盾：只有在另一种约定下，其航向才与行进方向一致。</translation>
    </message>
    <message>
        <source>Before anything else correct the convention of the INS attitude: its heading does not follow the direction of travel, and would under another one (see the findings).</source>
        <translation>请首先更正 INS 姿态的约定：其航向与行进方向不一致，而在另一种约定下则一致（见检查结果）。</translation>
    </message>
    <message>
        <source>the INS data do not cover the scans&apos; times: %1</source>
        <translation>INS 数据不覆盖扫描的时间：%1</translation>
    </message>
    <message>
        <source>the LiDAR&apos;s times end %1 before the INS data begin, and %2</source>
        <translation>激光雷达的时间在 INS 数据开始前 %1 就结束了；%2</translation>
    </message>
    <message>
        <source>the LiDAR&apos;s times begin %1 after the INS data end, and %2</source>
        <translation>激光雷达的时间在 INS 数据结束后 %1 才开始；%2</translation>
    </message>
    <message>
        <source>the beginnings are %1 apart. %2</source>
        <translation>两者的开始相差 %1。%2</translation>
    </message>
    <message>
        <source>%1 hours</source>
        <translation>%1 小时</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 天</translation>
    </message>
    <message>
        <source>That is the time between the epochs of Unix and GPS: one of them counts from 1980; declare its time scale.</source>
        <translation>这正是 Unix 与 GPS 起算点之间的时间：其中一个从 1980 年起算；请声明其时间系统。</translation>
    </message>
    <message>
        <source>GPS time is 18 s ahead of UTC since 2017 (17 s before): likely leap seconds; declare the time scale.</source>
        <translation>自 2017 年起 GPS 时间比 UTC 快 18 秒（此前为 17 秒）：很可能是闰秒；请声明时间系统。</translation>
    </message>
    <message>
        <source>GPS time is 18 s ahead of UTC since 2017 (17 s before), and TAI 19 s ahead of GPS time: likely leap seconds, or a clock that PTP sets to TAI; declare the time scale.</source>
        <translation>自 2017 年起 GPS 时间比 UTC 快 18 秒（此前为 17 秒），TAI 比 GPS 时间快 19 秒：很可能是闰秒，或是由 PTP 设为 TAI 的时钟；请声明时间系统。</translation>
    </message>
    <message>
        <source>That is about %1 hours: likely a time zone; both must be in UTC.</source>
        <translation>这约为 %1 小时：很可能是时区；两者都必须用 UTC。</translation>
    </message>
    <message>
        <source>They belong to different drives, or a clock or its unit is wrong.</source>
        <translation>它们属于不同的行驶，或者某个时钟或其单位有误。</translation>
    </message>
    <message>
        <source>They belong to different drives, or one clock is not synchronised.</source>
        <translation>它们属于不同的行驶，或者某个时钟没有同步。</translation>
    </message>
    <message>
        <source>Wheel speeds or yaw rates have a gap after %1 s: the end error is that of the %2 m before it, of %3 m driven.</source>
        <translation>轮速或偏航角速度在 %1 秒后有间断：终点误差只是此前 %2 m 的，共行驶 %3 m。</translation>
    </message>
    <message>
        <source>values measured by hand are of the LiDAR in the INS frame, and the method &apos;%1&apos; finds it in that of the %2; leave them out</source>
        <translation>手工测量值是激光雷达在 INS 坐标系中的，而方法“%1”求的是它在 %2 坐标系中的位置；请去掉测量值</translation>
    </message>
    <message>
        <source>is used with the ground in the scans, which the method &apos;trajectory&apos; does not look for; measure z, pitch and roll, or choose the method &apos;pairwise&apos;</source>
        <translation>要与扫描中的地面一起使用，而方法“trajectory”不寻找地面；请测量 z、俯仰和横滚，或选择方法“pairwise”</translation>
    </message>
    <message>
        <source>the session began with scans and has none any more</source>
        <translation>数据开始时有扫描，现在没有了</translation>
    </message>
    <message>
        <source>The values measured by hand are of the LiDAR in the INS frame; there is no INS, and they are not used.</source>
        <translation>手工测量值是激光雷达在 INS 坐标系中的；这里没有 INS，因此未使用。</translation>
    </message>
    <message>
        <source>neighbouring scans could not be registered (%1 of %2 failed), or the vehicle hardly moved</source>
        <translation>相邻扫描无法配准（%2 次中 %1 次失败），或车辆几乎没有移动</translation>
    </message>
    <message>
        <source>the session has no INS poses: X needs the motion of the INS</source>
        <translation>数据没有 INS 位姿：求 X 需要 INS 的运动</translation>
    </message>
    <message>
        <source>has INS axes %1, but %2 has %3: they have no common X. Calibrate them one by one, or declare the same attitude convention.</source>
        <translation>的 INS 坐标轴为 %1，而 %2 的为 %3：它们没有共同的 X。请逐一标定，或声明相同的姿态约定。</translation>
    </message>
    <message>
        <source>is the same recording as %1: its pairs would count as evidence twice. Give it once.</source>
        <translation>与 %1 是同一份记录：其帧对会被当作证据计算两次。只给出一次即可。</translation>
    </message>
    <message>
        <source>they lie in gaps of the INS data.</source>
        <translation>它们落在 INS 数据的间断中。</translation>
    </message>
    <message>
        <source>No scan lies within the INS data: %1</source>
        <translation>没有扫描落在 INS 数据的时间内：%1</translation>
    </message>
    <message>
        <source>Of %1 keyframes no pair is within %2 and has moved by %3 or turned by %4.</source>
        <translation>%1 个关键帧中，没有一对相隔不超过 %2，且移动了 %3 或转动了 %4。</translation>
    </message>
    <message>
        <source>One keyframe only: lower keyframes.interval_s, or give a longer drive.</source>
        <translation>只有一个关键帧：请减小 keyframes.interval_s，或给出更长的行驶。</translation>
    </message>
    <message>
        <source>One keyframe only: lower keyframes.distance_m and keyframes.rotation_deg, or give a longer drive.</source>
        <translation>只有一个关键帧：请减小 keyframes.distance_m 和 keyframes.rotation_deg，或给出更长的行驶。</translation>
    </message>
    <message>
        <source>The vehicle stands still while the LiDAR records: drive turns within sight of buildings and poles.</source>
        <translation>激光雷达记录时车辆静止不动：请在看得见建筑物和杆状物的地方转弯行驶。</translation>
    </message>
    <message>
        <source>Widen these settings of pairing, or take keyframes closer together.</source>
        <translation>请放宽这些配对设置，或把关键帧取得更密。</translation>
    </message>
    <message>
        <source>None of the %1 scans that are needed can be read. First: %2</source>
        <translation>所需的 %1 帧扫描都无法读取。第一帧：%2</translation>
    </message>
    <message>
        <source>Copy or export the scans again: they are incomplete, or of another type than declared.</source>
        <translation>请重新复制或导出扫描：它们不完整，或类型与声明的不同。</translation>
    </message>
    <message>
        <source>was cancelled when %1 of %2 pairs were aligned: the result is from these, without the last steps (aligning all clouds, the given height of the INS). Calibrate again for the rest.</source>
        <translation>在 %2 个帧对中配准了 %1 个时被取消：结果由这些得出，没有最后的步骤（全部点云联合配准、给定的 INS 高度）。要得到其余部分请重新标定。</translation>
    </message>
    <message>
        <source>motion pairs have no scans that show the ground; give z instead</source>
        <translation>运动对没有能显示地面的扫描；请改为给出 z</translation>
    </message>
    <message>
        <source>scan cannot be read: %1</source>
        <translation>扫描无法读取：%1</translation>
    </message>
    <message>
        <source>no scan can be read: %1</source>
        <translation>没有扫描可以读取：%1</translation>
    </message>
    <message>
        <source>only %1 shared static objects, %2 needed</source>
        <translation>只有 %1 个共同的静止物体，需要 %2 个</translation>
    </message>
    <message>
        <source>the session has lidar poses and no scans</source>
        <translation>数据有激光雷达位姿，没有扫描</translation>
    </message>
    <message>
        <source>decisions about pairs that the solution does not answer in full</source>
        <translation>求解尚未完全反映的帧对判定</translation>
    </message>
    <message>
        <source>a stream hardly turns, so its rate of rotation says nothing about time</source>
        <translation>某个数据流几乎没有转动，其角速度无法说明时间</translation>
    </message>
    <message>
        <source>a stream is shorter than %1 s</source>
        <translation>某个数据流短于 %1 秒</translation>
    </message>
    <message>
        <source>the rates of rotation do not resemble each other under any offset</source>
        <translation>在任何时间偏移下，角速度都互不相似</translation>
    </message>
    <message>
        <source>the rates of rotation hardly resemble each other</source>
        <translation>角速度几乎互不相似</translation>
    </message>
    <message>
        <source>another offset fits nearly as well</source>
        <translation>另一个偏移也几乎同样吻合</translation>
    </message>
    <message>
        <source>Of %1 keyframes no pair is within %2 or %3 and has moved by %4 or turned by %5.</source>
        <translation>%1 个关键帧中，没有一对相隔不超过 %2 或 %3，且移动了 %4 或转动了 %5。</translation>
    </message>
    <message>
        <source>%1 (axes of the lidar)</source>
        <translation>%1（激光雷达坐标轴）</translation>
    </message>
    <message>
        <source>the shift along [%1]</source>
        <translation>沿 [%1] 的平移</translation>
    </message>
    <message>
        <source>the turn about [%1]</source>
        <translation>绕 [%1] 的转动</translation>
    </message>
    <message>
        <source>the shift along [%1], the turn about [%2]</source>
        <translation>沿 [%1] 的平移、绕 [%2] 的转动</translation>
    </message>
    <message>
        <source>a turn about an axis beside the sensor</source>
        <translation>绕传感器旁一轴的转动</translation>
    </message>
    <message>
        <source>the time of a point is not finite</source>
        <translation>某个点的时间不是有限值</translation>
    </message>
    <message>
        <source>the times of the points spread over %1 s</source>
        <translation>各点的时间跨度达 %1 秒</translation>
    </message>
    <message>
        <source>holds LiDAR poses and no scans: no obstacles can be found</source>
        <translation>有激光雷达位姿，没有扫描：无法寻找障碍物</translation>
    </message>
    <message>
        <source>the origin is not on the globe</source>
        <translation>原点不在地球上</translation>
    </message>
    <message>
        <source>holds no bag</source>
        <translation>不含 bag</translation>
    </message>
    <message>
        <source>holds %1 bags and no metadata.yaml; open them one by one:%2</source>
        <translation>含有 %1 个 bag，没有 metadata.yaml；请逐一打开：%2</translation>
    </message>
    <message>
        <source>the index names more than %1 messages, too many for a file of %2 bytes</source>
        <translation>索引列出超过 %1 条消息，对于 %2 字节的文件过多</translation>
    </message>
    <message>
        <source>is no bag that is known: expected one of ROS 1, an MCAP or an SQLite database of ROS 2</source>
        <translation>不是已知的 bag：应为 ROS 1 的 bag、MCAP，或 ROS 2 的 SQLite 数据库</translation>
    </message>
    <message>
        <source>the files that metadata.yaml names are not here: %1</source>
        <translation>metadata.yaml 所列的文件不在此处：%1</translation>
    </message>
    <message>
        <source>goes with an IMU whose orientation serves as ins; give --topic ins=TOPIC of that IMU</source>
        <translation>须与以其姿态用作 ins 的 IMU 配合；请用 --topic ins=TOPIC 给出该 IMU</translation>
    </message>
    <message>
        <source>is no topic of this bag. It has:%1</source>
        <translation>不是此 bag 的话题。它含有：%1</translation>
    </message>
    <message>
        <source>no scan of this topic can be read</source>
        <translation>此话题没有可读取的扫描</translation>
    </message>
    <message>
        <source>The times of the points are of another clock than the scan&apos;s stamp (more than a second apart): the first point is taken to be of the stamp. A time offset of up to one turn may remain.</source>
        <translation>点的时间与扫描的时间戳不是同一时钟（相差超过一秒）：取第一个点的时间为该时间戳。可能残留最多一圈的时间偏移。</translation>
    </message>
    <message>
        <source>%1 fixes do not state their covariance; a sigma of 1 m is assumed.</source>
        <translation>%1 个定位未说明协方差；假定标准差为 1 m。</translation>
    </message>
    <message>
        <source>no usable INS is in this topic</source>
        <translation>此话题中没有可用的 INS</translation>
    </message>
    <message>
        <source>no usable INS is in this topic%1</source>
        <translation>此话题中没有可用的 INS%1</translation>
    </message>
    <message>
        <source>no usable INS is in this topic: its orientations have no NavSatFix with them</source>
        <translation>此话题中没有可用的 INS：其姿态没有相应的 NavSatFix</translation>
    </message>
    <message>
        <source>no usable INS is in this topic: its orientations have no NavSatFix with them%1</source>
        <translation>此话题中没有可用的 INS：其姿态没有相应的 NavSatFix%1</translation>
    </message>
    <message>
        <source>messages of this topic are neither of ROS 1 nor in CDR</source>
        <translation>此话题的消息既不是 ROS 1 的，也不是 CDR 编码</translation>
    </message>
    <message>
        <source>the message is serialised with representation %1, expected plain CDR: 0 or 1</source>
        <translation>消息的序列化表示为 %1，应为普通 CDR：0 或 1</translation>
    </message>
    <message>
        <source>the message has %1 bytes, expected %2 more than it has after byte %3</source>
        <translation>消息有 %1 字节，在字节 %3 之后应有的 %2 字节不足</translation>
    </message>
    <message>
        <source>a sequence promises %1 items, the message has only %2 bytes left</source>
        <translation>有序列声明有 %1 项，而消息只剩 %2 字节</translation>
    </message>
    <message>
        <source>a field of the cloud has type %1, expected 1 to 8</source>
        <translation>点云有字段的类型为 %1，应为 1 到 8</translation>
    </message>
    <message>
        <source>the cloud has %1 fields, at most 512 are read</source>
        <translation>点云有 %1 个字段，最多读取 512 个</translation>
    </message>
    <message>
        <source>field %1 lies at byte %2 of a point of %3 bytes</source>
        <translation>字段 %1 位于字节 %2，而每点只有 %3 字节</translation>
    </message>
    <message>
        <source>a row has %1 bytes, expected %2 for %3 points</source>
        <translation>一行有 %1 字节，%3 个点应为 %2 字节</translation>
    </message>
    <message>
        <source>the cloud promises %1 rows of %2 bytes, %3 bytes are there</source>
        <translation>点云声明有 %1 行、每行 %2 字节，实际有 %3 字节</translation>
    </message>
    <message>
        <source>the orientation is no quaternion of length 1</source>
        <translation>姿态不是长度为 1 的四元数</translation>
    </message>
    <message>
        <source>the position is not finite</source>
        <translation>位置不是有限的数</translation>
    </message>
    <message>
        <source>the GPS time of week is not possible</source>
        <translation>GPS 周内时间不合理</translation>
    </message>
    <message>
        <source>GPS week and time of week are no GPS time</source>
        <translation>GPS 周数和周内时间不是 GPS 时间</translation>
    </message>
    <message>
        <source>%1 bytes are promised, %2 are there</source>
        <translation>声明有 %1 字节，实际有 %2 字节</translation>
    </message>
    <message>
        <source>%1: byte %2: %3 bytes are promised, %4 are there</source>
        <translation>%1：字节 %2：声明有 %3 字节，实际有 %4 字节</translation>
    </message>
    <message>
        <source>%1, field &apos;%2&apos;: %3 bytes are promised, %4 are there</source>
        <translation>%1，字段“%2”：声明有 %3 字节，实际有 %4 字节</translation>
    </message>
    <message>
        <source>%1 (unpacked chunk: byte %2): %3 bytes are promised, %4 are there</source>
        <translation>%1（解压后的块：字节 %2）：声明有 %3 字节，实际有 %4 字节</translation>
    </message>
    <message>
        <source>a chunk is compressed with &apos;%1&apos;, expected none, bz2, lz4 or zstd</source>
        <translation>有块以“%1”压缩，应为 none、bz2、lz4 或 zstd</translation>
    </message>
    <message>
        <source>the compressed chunk is damaged: %1 of %2 bytes can be unpacked</source>
        <translation>压缩的块已损坏：%2 字节中只能解压 %1 字节</translation>
    </message>
    <message>
        <source>%1 bytes are expected here, the part of the file that holds them has %2 bytes in all</source>
        <translation>此处应有 %1 字节，而文件的相应部分总共只有 %2 字节</translation>
    </message>
    <message>
        <source>%1: byte %2: %3 bytes are expected here, the part of the file that holds them has %4 bytes in all</source>
        <translation>%1：字节 %2：此处应有 %3 字节，而文件的相应部分总共只有 %4 字节</translation>
    </message>
    <message>
        <source>%1 (unpacked chunk: byte %2): %3 bytes are expected here, the chunk holds %4 bytes in all</source>
        <translation>%1（解压后的块：字节 %2）：此处应有 %3 字节，而该块总共只有 %4 字节</translation>
    </message>
    <message>
        <source>%1 bytes are expected here, the chunk holds %2 bytes in all</source>
        <translation>此处应有 %1 字节，而该块总共只有 %2 字节</translation>
    </message>
    <message>
        <source>the checksum of the chunk does not agree with its bytes: it is damaged</source>
        <translation>块的校验和与其内容不符：它已损坏</translation>
    </message>
    <message>
        <source>a chunk of %1 bytes does not fit a file of %2</source>
        <translation>%1 字节的块超出 %2 字节的文件</translation>
    </message>
    <message>
        <source>a chunk that is not compressed promises %1 bytes and has %2</source>
        <translation>未压缩的块声明有 %1 字节，实际有 %2 字节</translation>
    </message>
    <message>
        <source>a chunk promises %1 bytes, at most %2 are taken from a file of this size</source>
        <translation>块声明有 %1 字节，对于这样大小的文件最多读取 %2 字节</translation>
    </message>
    <message>
        <source>the bag has too many chunks</source>
        <translation>bag 的块过多</translation>
    </message>
    <message>
        <source>a record promises %1 bytes, at most %2 are read of its kind</source>
        <translation>记录声明有 %1 字节，此类记录最多读取 %2 字节</translation>
    </message>
    <message>
        <source>a record promises %1 bytes, %2 are there</source>
        <translation>记录声明有 %1 字节，实际有 %2 字节</translation>
    </message>
    <message>
        <source>a record header promises %1 bytes, at most %2 are read</source>
        <translation>记录头声明有 %1 字节，最多读取 %2 字节</translation>
    </message>
    <message>
        <source>no record begins with 0</source>
        <translation>记录不能以 0 开头</translation>
    </message>
    <message>
        <source>a record is too short</source>
        <translation>有记录太短</translation>
    </message>
    <message>
        <source>a field of a record header has no &apos;=&apos;, expected NAME=VALUE</source>
        <translation>记录头的字段没有“=”，应为 NAME=VALUE</translation>
    </message>
    <message>
        <source>the record has no field &apos;%1&apos;</source>
        <translation>记录没有字段“%1”</translation>
    </message>
    <message>
        <source>a record is expected behind the end</source>
        <translation>在文件结尾之后应有记录</translation>
    </message>
    <message>
        <source>the index says a chunk begins here</source>
        <translation>索引指出此处是块的开头</translation>
    </message>
    <message>
        <source>the index says a message begins here</source>
        <translation>索引指出此处是消息的开头</translation>
    </message>
    <message>
        <source>the index names a chunk twice</source>
        <translation>索引两次列出同一个块</translation>
    </message>
    <message>
        <source>the index names %1 of %2 chunks</source>
        <translation>%2 个块中，索引只列出 %1 个</translation>
    </message>
    <message>
        <source>the index has another version than 1</source>
        <translation>索引的版本不是 1</translation>
    </message>
    <message>
        <source>is an MCAP of another version than 0</source>
        <translation>是版本不为 0 的 MCAP</translation>
    </message>
    <message>
        <source>is no MCAP</source>
        <translation>不是 MCAP</translation>
    </message>
    <message>
        <source>it has no summary</source>
        <translation>没有摘要</translation>
    </message>
    <message>
        <source>channel %1 is not described</source>
        <translation>通道 %1 没有说明</translation>
    </message>
    <message>
        <source>a chunk is longer than its record</source>
        <translation>块比其记录长</translation>
    </message>
    <message>
        <source>the file was not closed</source>
        <translation>文件没有正常关闭</translation>
    </message>
    <message>
        <source>expected the footer of the file</source>
        <translation>应为文件的尾部记录</translation>
    </message>
    <message>
        <source>the checksum of the summary does not agree with its bytes</source>
        <translation>摘要的校验和与其内容不符</translation>
    </message>
    <message>
        <source>The checksum of the data does not agree with the file. What is read of it may be wrong where it has no checksum of its own.</source>
        <translation>数据的校验和与文件不符。其中没有自身校验和的部分，读出的内容可能有误。</translation>
    </message>
    <message>
        <source>Attachments that do not agree with their checksums: %1. They are not used. First: %2.</source>
        <translation>与校验和不符的附件：%1 个。它们未被使用。首个：%2。</translation>
    </message>
    <message>
        <source>a chunk reaches behind the end of the file</source>
        <translation>块超出文件的结尾</translation>
    </message>
    <message>
        <source>the indexes of a chunk lie behind the end of the file</source>
        <translation>块的索引超出文件的结尾</translation>
    </message>
    <message>
        <source>The bag has no usable index (%1). It was read from the beginning: %2 messages were found; %3 bytes at the end are not readable.</source>
        <translation>bag 没有可用的索引（%1）。已从头读取：找到 %2 条消息；末尾 %3 字节无法读取。</translation>
    </message>
    <message>
        <source>The bag has no usable index (%1). It was read from the beginning: %2 messages were found; %3 bytes at the end are not readable. First that cannot be read: %4.</source>
        <translation>bag 没有可用的索引（%1）。已从头读取：找到 %2 条消息；末尾 %3 字节无法读取。首个无法读取的：%4。</translation>
    </message>
    <message>
        <source>the bag holds no readable message (%1).</source>
        <translation>bag 不含可读取的消息（%1）。</translation>
    </message>
    <message>
        <source>the bag holds no readable message (%1). First that cannot be read: %2.</source>
        <translation>bag 不含可读取的消息（%1）。首个无法读取的：%2。</translation>
    </message>
    <message>
        <source>is a bag of an older version; &apos;rosbag fix&apos; makes one of version 2.0</source>
        <translation>是旧版本的 bag；可用“rosbag fix”转换为 2.0 版本</translation>
    </message>
    <message>
        <source>is no bag of ROS 1</source>
        <translation>不是 ROS 1 的 bag</translation>
    </message>
    <message>
        <source>expected the header of the bag</source>
        <translation>应为 bag 的头部</translation>
    </message>
    <message>
        <source>the bag is encrypted</source>
        <translation>bag 已加密</translation>
    </message>
    <message>
        <source>it was not closed</source>
        <translation>没有正常关闭</translation>
    </message>
    <message>
        <source>its index is damaged: %1</source>
        <translation>其索引已损坏：%1</translation>
    </message>
    <message>
        <source>a connection has no type</source>
        <translation>有连接没有类型</translation>
    </message>
    <message>
        <source>connection %1 is not described</source>
        <translation>连接 %1 没有说明</translation>
    </message>
    <message>
        <source>It is readable to its end.</source>
        <translation>直到结尾均可读取。</translation>
    </message>
    <message>
        <source>It is readable to its end. %1 chunks are damaged. First: %2</source>
        <translation>直到结尾均可读取。有 %1 个块已损坏。首个：%2</translation>
    </message>
    <message>
        <source>It ends in the middle of a record.</source>
        <translation>它在一条记录的中间结束。</translation>
    </message>
    <message>
        <source>It ends in the middle of a record. %1 chunks are damaged. First: %2</source>
        <translation>它在一条记录的中间结束。有 %1 个块已损坏。首个：%2</translation>
    </message>
    <message>
        <source>The last %1 bytes are not readable: %2.</source>
        <translation>最后 %1 字节无法读取：%2。</translation>
    </message>
    <message>
        <source>The last %1 bytes are not readable: %2: byte %3: %4 bytes are expected here, but the file ends at byte %5.</source>
        <translation>最后 %1 字节无法读取：%2：字节 %3：此处应有 %4 字节，但文件止于字节 %5。</translation>
    </message>
    <message>
        <source>The last %1 bytes are not readable: %2: byte %3: %4 bytes are expected here, but the file ends at byte %5. %6 chunks are damaged. First: %7</source>
        <translation>最后 %1 字节无法读取：%2：字节 %3：此处应有 %4 字节，但文件止于字节 %5。有 %6 个块已损坏。首个：%7</translation>
    </message>
    <message>
        <source>The last %1 bytes are not readable: %2. %3 chunks are damaged. First: %4</source>
        <translation>最后 %1 字节无法读取：%2。有 %3 个块已损坏。首个：%4</translation>
    </message>
    <message>
        <source>the bag holds no readable message (%1). %2</source>
        <translation>bag 不含可读取的消息（%1）。%2</translation>
    </message>
    <message>
        <source>the database cannot be opened: %1</source>
        <translation>无法打开数据库：%1</translation>
    </message>
    <message>
        <source>is no bag of ROS 2: expected a table &apos;topics&apos;: %1</source>
        <translation>不是 ROS 2 的 bag：应有表“topics”：%1</translation>
    </message>
    <message>
        <source>is no bag of ROS 2: expected a table &apos;messages&apos;: %1</source>
        <translation>不是 ROS 2 的 bag：应有表“messages”：%1</translation>
    </message>
    <message>
        <source>database disk image is malformed</source>
        <translation>数据库文件已损坏</translation>
    </message>
    <message>
        <source>file is not a database</source>
        <translation>文件不是数据库</translation>
    </message>
    <message>
        <source>database is locked</source>
        <translation>数据库已被锁定</translation>
    </message>
    <message>
        <source>unable to open database file</source>
        <translation>无法打开数据库文件</translation>
    </message>
    <message>
        <source>disk I/O error</source>
        <translation>磁盘读写错误</translation>
    </message>
    <message>
        <source>no such table: %1</source>
        <translation>没有表 %1</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>the file is shorter than the database</source>
        <translation>文件比数据库短</translation>
    </message>
    <message>
        <source>the bag holds no readable message</source>
        <translation>bag 不含可读取的消息</translation>
    </message>
    <message>
        <source>the bag holds no readable message: %1</source>
        <translation>bag 不含可读取的消息：%1</translation>
    </message>
    <message>
        <source>promises %1 bytes, more than the file has</source>
        <translation>声明有 %1 字节，超出文件的大小</translation>
    </message>
    <message>
        <source>the compressed file is damaged here</source>
        <translation>压缩文件在此处已损坏</translation>
    </message>
    <message>
        <source>unpacks to more than %1, which no bag of this size does</source>
        <translation>解压后超过 %1，这样大小的 bag 不会如此</translation>
    </message>
    <message>
        <source>the compressed file was cut: its end is missing</source>
        <translation>压缩文件不完整：缺少结尾</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: byte %2 (unpacked chunk: byte %3): %4</source>
        <translation>%1：字节 %2（解压后的块：字节 %3）：%4</translation>
    </message>
    <message>
        <source>byte %1 (unpacked chunk: byte %2): %3</source>
        <translation>字节 %1（解压后的块：字节 %2）：%3</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>空值</translation>
    </message>
    <message>
        <source>a map</source>
        <translation>映射</translation>
    </message>
    <message>
        <source>a list of %1</source>
        <translation>含 %1 项的列表</translation>
    </message>
    <message>
        <source>expected a map with the key &quot;%1&quot;, found %2</source>
        <translation>应为含键“%1”的映射，实际为：%2</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is missing</source>
        <translation>缺少键“%1”</translation>
    </message>
    <message>
        <source>expected a list, found %1</source>
        <translation>应为列表，实际为：%1</translation>
    </message>
    <message>
        <source>expected a map, found %1</source>
        <translation>应为映射，实际为：%1</translation>
    </message>
    <message>
        <source>expected a finite number, found %1</source>
        <translation>应为有限的数，实际为：%1</translation>
    </message>
    <message>
        <source>expected a number from %1 to %2, found %3</source>
        <translation>应为 %1 至 %2 之间的数，实为 %3</translation>
    </message>
    <message>
        <source>expected a list of %1 numbers, found %2</source>
        <translation>应为含 %1 个数的列表，实际为：%2</translation>
    </message>
    <message>
        <source>expected a whole number from %1 to %2, found %3</source>
        <translation>应为 %1 到 %2 之间的整数，实际为：%3</translation>
    </message>
    <message>
        <source>expected true or false, found %1</source>
        <translation>应为 true 或 false，实际为：%1</translation>
    </message>
    <message>
        <source>expected a text, found %1</source>
        <translation>应为文本，实际为：%1</translation>
    </message>
    <message>
        <source>expected one of %1; found %2</source>
        <translation>应为以下之一：%1；实际为：%2</translation>
    </message>
    <message>
        <source>is not a key that is known here; known are %1</source>
        <translation>不是此处已知的键；已知的有 %1</translation>
    </message>
    <message>
        <source>a key of a map is missing</source>
        <translation>映射缺少一个键</translation>
    </message>
    <message>
        <source>a list or a map cannot be the key of a map here</source>
        <translation>此处列表或映射不能作为映射的键</translation>
    </message>
    <message>
        <source>lists and maps are nested deeper than %1</source>
        <translation>列表和映射的嵌套深度超过 %1</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; appears twice in one map</source>
        <translation>键“%1”在同一映射中出现两次</translation>
    </message>
    <message>
        <source>holds more than %1 values</source>
        <translation>含有超过 %1 个值</translation>
    </message>
    <message>
        <source>aliases (*name) are not accepted; write the value out</source>
        <translation>不接受别名（*name）；请直接写出值</translation>
    </message>
    <message>
        <source>anchors (&amp;name) are not accepted; write the value out</source>
        <translation>不接受锚点（&amp;name）；请直接写出值</translation>
    </message>
    <message>
        <source>tags (%1) are not accepted</source>
        <translation>不接受标签（%1）</translation>
    </message>
    <message>
        <source>is not JSON here (byte %1)</source>
        <translation>此处不是 JSON（字节 %1）</translation>
    </message>
    <message>
        <source>is %1 bytes long, at most %2 are expected here</source>
        <translation>长 %1 字节，此处最多应为 %2 字节</translation>
    </message>
    <message>
        <source>is empty, expected keys and values</source>
        <translation>是空的，应为键和值</translation>
    </message>
    <message>
        <source>a second YAML document begins, only one is expected</source>
        <translation>出现第二个 YAML 文档，应只有一个</translation>
    </message>
    <message>
        <source>is not YAML here: %1</source>
        <translation>此处不是 YAML：%1</translation>
    </message>
    <message>
        <source>illegal map value</source>
        <translation>映射的值不合法</translation>
    </message>
    <message>
        <source>illegal map key</source>
        <translation>映射的键不合法</translation>
    </message>
    <message>
        <source>end of map not found</source>
        <translation>找不到映射的结尾</translation>
    </message>
    <message>
        <source>end of map flow not found</source>
        <translation>找不到流式映射的结尾</translation>
    </message>
    <message>
        <source>end of sequence not found</source>
        <translation>找不到列表的结尾</translation>
    </message>
    <message>
        <source>end of sequence flow not found</source>
        <translation>找不到流式列表的结尾</translation>
    </message>
    <message>
        <source>illegal flow end</source>
        <translation>流式结构的结尾不合法</translation>
    </message>
    <message>
        <source>illegal block entry</source>
        <translation>列表项的位置不合法</translation>
    </message>
    <message>
        <source>illegal EOF in scalar</source>
        <translation>文件在一个值的中间结束</translation>
    </message>
    <message>
        <source>illegal tab when looking for indentation</source>
        <translation>缩进中不允许使用制表符</translation>
    </message>
    <message>
        <source>unknown token</source>
        <translation>无法识别的符号</translation>
    </message>
    <message>
        <source>expected as many numbers as in x</source>
        <translation>数的个数应与 x 中相同</translation>
    </message>
    <message>
        <source>is negative</source>
        <translation>为负数</translation>
    </message>
    <message>
        <source>%1 differs from the matrix by %2; the file contradicts itself</source>
        <translation>%1与矩阵相差 %2；文件自相矛盾</translation>
    </message>
    <message>
        <source>the translation</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>the quaternion</source>
        <translation>四元数</translation>
    </message>
    <message>
        <source>the yaw-pitch-roll</source>
        <translation>偏航-俯仰-横滚</translation>
    </message>
    <message>
        <source>expected four rows of four numbers</source>
        <translation>应为四行，每行四个数</translation>
    </message>
    <message>
        <source>the last row must be 0, 0, 0, 1</source>
        <translation>最后一行必须是 0, 0, 0, 1</translation>
    </message>
    <message>
        <source>the rotation is not orthonormal (off by %1)</source>
        <translation>旋转不是正交的（偏差 %1）</translation>
    </message>
    <message>
        <source>the rotation is a reflection (its determinant is -1)</source>
        <translation>旋转是反射（其行列式为 -1）</translation>
    </message>
    <message>
        <source>expected a unit quaternion in the order x, y, z, w; its length is %1</source>
        <translation>应为按 x、y、z、w 顺序的单位四元数；其长度为 %1</translation>
    </message>
    <message>
        <source>is not a setting; known here are %1</source>
        <translation>不是设置项；此处已知的有 %1</translation>
    </message>
    <message>
        <source>is not a section of settings; known are %1</source>
        <translation>不是设置的分组；已知的有 %1</translation>
    </message>
    <message>
        <source>expected section.key=value; &quot;remount-cli settings&quot; prints all of them with what they take</source>
        <translation>应为“节.键=值”；“remount-cli settings”会列出全部设置及其取值</translation>
    </message>
    <message>
        <source>expected three entries: x, y, z</source>
        <translation>应为三项：x、y、z</translation>
    </message>
    <message>
        <source>expected three entries: roll, pitch, yaw</source>
        <translation>应为三项：roll、pitch、yaw</translation>
    </message>
    <message>
        <source>a sigma is negative</source>
        <translation>有标准差为负</translation>
    </message>
    <message>
        <source>expected six rows</source>
        <translation>应为六行</translation>
    </message>
    <message>
        <source>expected six entries</source>
        <translation>应为六项</translation>
    </message>
    <message>
        <source>gives a number for %1, which is not observed</source>
        <translation>给出了 %1 的数值，而它不可观测</translation>
    </message>
    <message>
        <source>expected &quot;remount-result/1&quot;, found &quot;%1&quot;</source>
        <translation>应为“remount-result/1”，实际为“%1”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a status that is known here</source>
        <translation>“%1”不是此处已知的状态</translation>
    </message>
    <message>
        <source>expected a unit vector</source>
        <translation>应为单位向量</translation>
    </message>
    <message>
        <source>%1 rad (%2 deg) is outside %3 to %4 rad (%5 to %6 deg)</source>
        <translation>%1 rad（%2 度）超出 %3 到 %4 rad（%5 到 %6 度）</translation>
    </message>
    <message>
        <source>%1 is outside %2 to %3</source>
        <translation>%1 超出 %2 到 %3</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, expected &quot;%2&quot;</source>
        <translation>为“%1”，应为“%2”</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, expected &quot;%2&quot;; a later version of Remount wrote it</source>
        <translation>为“%1”，应为“%2”；由更新版本的 Remount 写入</translation>
    </message>
    <message>
        <source>expected ROLE=TOPIC with a role of %1; the topic none leaves a role out</source>
        <translation>应为 ROLE=TOPIC，ROLE 取自 %1；TOPIC 为 none 时不使用该角色</translation>
    </message>
    <message>
        <source>%1 has a topic already</source>
        <translation>%1 已有话题</translation>
    </message>
    <message>
        <source>expected the 12 or 16 numbers of a matrix, found %1</source>
        <translation>应为矩阵的 12 或 16 个数，实际为 %1 个</translation>
    </message>
    <message>
        <source>expected an attribute %1=&quot;...&quot;</source>
        <translation>应有属性 %1=&quot;...&quot;</translation>
    </message>
    <message>
        <source>is KITTI&apos;s calibration of a camera (it has a line &quot;delta_f:&quot;), expected calib_imu_to_velo.txt</source>
        <translation>是 KITTI 的相机标定（含有“delta_f:”一行），应为 calib_imu_to_velo.txt</translation>
    </message>
    <message>
        <source>expected a line &quot;R:&quot; with nine numbers and a line &quot;T:&quot; with three</source>
        <translation>应有含九个数的“R:”一行和含三个数的“T:”一行</translation>
    </message>
    <message>
        <source>expected an entry &quot;&lt;a&gt;-to-&lt;b&gt;-extrinsic&quot;</source>
        <translation>应有条目“&lt;a&gt;-to-&lt;b&gt;-extrinsic”</translation>
    </message>
    <message>
        <source>names a LiDAR; expected an extrinsic from the GNSS/INS to the LiDAR</source>
        <translation>是激光雷达；应为从 GNSS/INS 到激光雷达的外参</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>无法写入：%1</translation>
    </message>
    <message>
        <source>is being written by another process</source>
        <translation>正由另一进程写入</translation>
    </message>
    <message>
        <source>is no name of a file to save to</source>
        <translation>不是可以保存的文件名</translation>
    </message>
    <message>
        <source>cannot be saved, it is a folder</source>
        <translation>无法保存，它是文件夹</translation>
    </message>
    <message>
        <source>cannot be saved, it is no regular file</source>
        <translation>无法保存，它不是普通文件</translation>
    </message>
    <message>
        <source>cannot be saved, its permissions cannot be set: %1; nothing was replaced</source>
        <translation>无法保存，不能设置其权限：%1；未替换任何内容</translation>
    </message>
    <message>
        <source>is there and is nothing that this would replace (no &quot;%1&quot; in it): name another file, or remove it first</source>
        <translation>已存在，且不是可以替换的文件（其中没有“%1”）：请另取文件名，或先将其删除</translation>
    </message>
    <message>
        <source>%1; replaced already: %2</source>
        <translation>%1；此前已替换：%2</translation>
    </message>
    <message>
        <source>cannot be locked: %1</source>
        <translation>无法锁定：%1</translation>
    </message>
    <message>
        <source>cannot be locked, it is no regular file</source>
        <translation>无法锁定，它不是普通文件</translation>
    </message>
    <message>
        <source>cannot be locked: it is made and removed again and again</source>
        <translation>无法锁定：它不断被创建和删除</translation>
    </message>
    <message>
        <source>cannot be locked: the file system knows no locks</source>
        <translation>无法锁定：文件系统不支持锁</translation>
    </message>
    <message>
        <source>cannot be made: a file is in the way</source>
        <translation>无法创建：已有同名文件</translation>
    </message>
    <message>
        <source>is %1, expected a regular file</source>
        <translation>是%1，应为普通文件</translation>
    </message>
    <message>
        <source>a directory</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>a FIFO</source>
        <translation>命名管道</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>a socket</source>
        <translation>套接字</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>其他类型</translation>
    </message>
    <message>
        <source>holds %1 bytes, at most %2 are read</source>
        <translation>含 %1 字节，最多读取 %2 字节</translation>
    </message>
    <message>
        <source>%1 bytes are expected here, but the file ends at byte %2</source>
        <translation>此处应有 %1 字节，但文件止于字节 %2</translation>
    </message>
    <message>
        <source>%1: byte %2: %3 bytes are expected here, but the file ends at byte %4</source>
        <translation>%1：字节 %2：此处应有 %3 字节，但文件止于字节 %4</translation>
    </message>
    <message>
        <source>the file became shorter while it was read</source>
        <translation>文件在读取时变短了</translation>
    </message>
    <message>
        <source>has become shorter: it was written anew</source>
        <translation>变短了：它被重新写过</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>打开的文件过多</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>不是文件夹</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>不允许该操作</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>超出磁盘配额</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>设备或资源忙</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>符号链接层数过多</translation>
    </message>
    <message>
        <source>has no column &apos;%1&apos;; its columns are %2</source>
        <translation>没有列“%1”；现有的列为 %2</translation>
    </message>
    <message>
        <source>%1 is &apos;%2&apos;, expected a finite number</source>
        <translation>%1：“%2”不是有限的数</translation>
    </message>
    <message>
        <source>velocity is &apos;%1&apos;, expected a finite number</source>
        <translation>速度：“%1”不是有限的数</translation>
    </message>
    <message>
        <source>turn rate is &apos;%1&apos;, expected a finite number</source>
        <translation>转动角速度：“%1”不是有限的数</translation>
    </message>
    <message>
        <source>position is &apos;%1&apos;, expected a finite number</source>
        <translation>位置：“%1”不是有限的数</translation>
    </message>
    <message>
        <source>%1 is &apos;&apos;, expected a finite number</source>
        <translation>%1：空白，应为有限的数</translation>
    </message>
    <message>
        <source>%1 is &apos;%2&apos;, expected a number</source>
        <translation>%1：“%2”不是数</translation>
    </message>
    <message>
        <source>%1 is &apos;&apos;, expected a number</source>
        <translation>%1：空白，应为数</translation>
    </message>
    <message>
        <source>field %1</source>
        <translation>第 %1 个字段</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>第 %1 列</translation>
    </message>
    <message>
        <source>an entry</source>
        <translation>某一项</translation>
    </message>
    <message>
        <source>has %1 fields, column %2 is needed</source>
        <translation>有 %1 个字段，需要第 %2 列</translation>
    </message>
    <message>
        <source>has %1 fields, expected %2</source>
        <translation>有 %1 个字段，应为 %2 个</translation>
    </message>
    <message>
        <source>has %1 fields, expected more than %2</source>
        <translation>有 %1 个字段，应多于 %2 个</translation>
    </message>
    <message>
        <source>has %1 fields, expected a time stamp and 12 numbers</source>
        <translation>有 %1 个字段，应为一个时间戳和 12 个数</translation>
    </message>
    <message>
        <source>has %1 fields, the header has %2</source>
        <translation>有 %1 个字段，而表头有 %2 个</translation>
    </message>
    <message>
        <source>has %1 data fields, expected %2</source>
        <translation>有 %1 个数据字段，应为 %2 个</translation>
    </message>
    <message>
        <source>has %1 numbers, expected %2</source>
        <translation>有 %1 个数，应为 %2 个</translation>
    </message>
    <message>
        <source>has %1 values, expected %2</source>
        <translation>有 %1 个值，应为 %2 个</translation>
    </message>
    <message>
        <source>has %1 columns, expected at least %2</source>
        <translation>有 %1 列，至少应为 %2 列</translation>
    </message>
    <message>
        <source>%1 line cannot be used and is left out. First: %2</source>
        <translation>%1 行无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 lines cannot be used and are left out. First: %2</source>
        <translation>%1 行无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 file cannot be used and is left out. First: %2</source>
        <translation>%1 个文件无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 files cannot be used and are left out. First: %2</source>
        <translation>%1 个文件无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 INS file cannot be used and is left out. First: %2</source>
        <translation>%1 个 INS 文件无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 INS files cannot be used and are left out. First: %2</source>
        <translation>%1 个 INS 文件无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 scan cannot be used and is left out. First: %2</source>
        <translation>%1 次扫描无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 scans cannot be used and are left out. First: %2</source>
        <translation>%1 次扫描无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 time stamp cannot be used and is left out. First: %2</source>
        <translation>%1 个时间戳无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 time stamps cannot be used and are left out. First: %2</source>
        <translation>%1 个时间戳无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 track point cannot be used and is left out. First: %2</source>
        <translation>%1 个轨迹点无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 track points cannot be used and are left out. First: %2</source>
        <translation>%1 个轨迹点无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 message cannot be used and is left out. First: %2</source>
        <translation>%1 条消息无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>%1 messages cannot be used and are left out. First: %2</source>
        <translation>%1 条消息无法使用，已略去。首个：%2</translation>
    </message>
    <message>
        <source>no entry has a possible time, expected nanoseconds since 1970</source>
        <translation>没有一条的时间合理，应为自 1970 年起的纳秒数</translation>
    </message>
    <message>
        <source>the rotation holds numbers that are not finite</source>
        <translation>旋转中含有非有限的数</translation>
    </message>
    <message>
        <source>the nine numbers are no rotation: an entry is off by %1</source>
        <translation>这九个数不是旋转：有一项偏差 %1</translation>
    </message>
    <message>
        <source>%1 is &apos;%2&apos;, expected a time in unit: %3</source>
        <translation>%1：“%2”不是以 unit: %3 计的时间</translation>
    </message>
    <message>
        <source>%1 is &apos;&apos;, expected a time in unit: %2</source>
        <translation>%1：空白，应为以 unit: %2 计的时间</translation>
    </message>
    <message>
        <source>%1 is &apos;%2&apos;, too large for unit: %3; declare unit: %4 where that is what it counts</source>
        <translation>%1：“%2”对 unit: %3 而言过大；请按它实际的计数单位声明 unit: %4</translation>
    </message>
    <message>
        <source>GPS week and time of week are out of range</source>
        <translation>GPS 周数和周内时间超出范围</translation>
    </message>
    <message>
        <source>the quaternion has length %1, expected 1</source>
        <translation>四元数的长度为 %1，应为 1</translation>
    </message>
    <message>
        <source>%1 is &apos;%2&apos;, expected unknown, good, degraded or invalid</source>
        <translation>%1：“%2”应为 unknown、good、degraded 或 invalid</translation>
    </message>
    <message>
        <source>%1 is &apos;&apos;, expected unknown, good, degraded or invalid</source>
        <translation>%1：空白，应为 unknown、good、degraded 或 invalid</translation>
    </message>
    <message>
        <source>holds no usable INS sample.</source>
        <translation>不含可用的 INS 样本。</translation>
    </message>
    <message>
        <source>holds no usable INS sample. First problem: %1</source>
        <translation>不含可用的 INS 样本。首个问题：%1</translation>
    </message>
    <message>
        <source>no time stamps</source>
        <translation>没有时间戳</translation>
    </message>
    <message>
        <source>the angles are declared in radians, but roll or pitch reaches %1, more than radians allow (3.14). Declare attitude: {unit: deg} in session.yaml</source>
        <translation>角度声明为弧度，但横滚或俯仰达到 %1，超出弧度的范围（3.14）。请在 session.yaml 中声明 attitude: {unit: deg}</translation>
    </message>
    <message>
        <source>the angles are declared as unit: deg, but the heading then goes against the direction of travel; it follows it as rad. Declare attitude: {unit: rad} in session.yaml</source>
        <translation>角度声明为 unit: deg，但这样航向与行驶方向不符；按 rad 则相符。请在 session.yaml 中声明 attitude: {unit: rad}</translation>
    </message>
    <message>
        <source>As unit: deg, the heading is %1 degrees off the direction of travel; as rad, %2. Declare attitude: {unit: rad} in session.yaml, unless the INS is mounted like that.</source>
        <translation>按 unit: deg，航向与行驶方向相差 %1 度；按 rad 则相差 %2 度。请在 session.yaml 中声明 attitude: {unit: rad}，除非 INS 确实这样安装。</translation>
    </message>
    <message>
        <source>the angles are declared as unit: rad, but the heading then goes against the direction of travel; it follows it as deg. Declare attitude: {unit: deg} in session.yaml</source>
        <translation>角度声明为 unit: rad，但这样航向与行驶方向不符；按 deg 则相符。请在 session.yaml 中声明 attitude: {unit: deg}</translation>
    </message>
    <message>
        <source>As unit: rad, the heading is %1 degrees off the direction of travel; as deg, %2. Declare attitude: {unit: deg} in session.yaml, unless the INS is mounted like that.</source>
        <translation>按 unit: rad，航向与行驶方向相差 %1 度；按 deg 则相差 %2 度。请在 session.yaml 中声明 attitude: {unit: deg}，除非 INS 确实这样安装。</translation>
    </message>
    <message>
        <source>GPS week &apos;&apos; and time &apos;&apos; are no GPS time</source>
        <translation>GPS 周数和时间空白，不是 GPS 时间</translation>
    </message>
    <message>
        <source>GPS week &apos;%1&apos; and time &apos;%2&apos; are no GPS time</source>
        <translation>GPS 周数“%1”和时间“%2”不是 GPS 时间</translation>
    </message>
    <message>
        <source>the header has too few fields</source>
        <translation>头部的字段太少</translation>
    </message>
    <message>
        <source>roll, pitch or azimuth is no angle in degrees</source>
        <translation>横滚、俯仰或方位角不是以度计的角度</translation>
    </message>
    <message>
        <source>holds no usable INSPVAX line.</source>
        <translation>不含可用的 INSPVAX 行。</translation>
    </message>
    <message>
        <source>holds no usable INSPVAX line. First problem: %1</source>
        <translation>不含可用的 INSPVAX 行。首个问题：%1</translation>
    </message>
    <message>
        <source>Of several INSPVAX files this one has intact stamps and most samples; not used: %1.</source>
        <translation>在多个 INSPVAX 文件中，此文件的时间戳完好且样本最多；未使用：%1。</translation>
    </message>
    <message>
        <source>holds several files of LiDAR poses: %1 and %2</source>
        <translation>含有多个激光雷达位姿文件：%1 和 %2</translation>
    </message>
    <message>
        <source>holds several pose files, none named after lidar, laser, odom, loam or mapped</source>
        <translation>含有多个位姿文件，但名称中都没有 lidar、laser、odom、loam 或 mapped</translation>
    </message>
    <message>
        <source>An INSPVAX log is half a session: put it into a folder with LiDAR poses, or declare it with the scans in a session.yaml.</source>
        <translation>INSPVAX 记录只是半份数据：请把它与激光雷达位姿放入同一文件夹，或在 session.yaml 中与扫描一起声明。</translation>
    </message>
    <message>
        <source>%1 without usable values</source>
        <translation>%1 没有可用的值</translation>
    </message>
    <message>
        <source>the checksum is wrong</source>
        <translation>校验和错误</translation>
    </message>
    <message>
        <source>holds no GGA sentence with a fix.</source>
        <translation>不含带定位的 GGA 语句。</translation>
    </message>
    <message>
        <source>holds no GGA sentence with a fix. First problem: %1</source>
        <translation>不含带定位的 GGA 语句。首个问题：%1</translation>
    </message>
    <message>
        <source>holds no date: GGA tells the time of day alone. Log RMC or ZDA as well</source>
        <translation>没有日期：GGA 只含一天内的时刻。请同时记录 RMC 或 ZDA</translation>
    </message>
    <message>
        <source>The log does not state errors (GST): what the quality of a fix usually means is assumed.</source>
        <translation>日志未说明误差（GST）：按定位质量的通常含义假定误差。</translation>
    </message>
    <message>
        <source>Heights are above sea level, for the log does not give the geoid&apos;s.</source>
        <translation>高度为海拔，因为日志未给出大地水准面的高度。</translation>
    </message>
    <message>
        <source>the tag &lt;trkpt does not end</source>
        <translation>标签 &lt;trkpt 没有结束</translation>
    </message>
    <message>
        <source>a track point needs lat, lon and a time like 2026-11-22T10:00:00Z</source>
        <translation>轨迹点需要 lat、lon 以及形如 2026-11-22T10:00:00Z 的时间</translation>
    </message>
    <message>
        <source>the position is not on the Earth</source>
        <translation>位置不在地球上</translation>
    </message>
    <message>
        <source>holds no track point with a time.</source>
        <translation>不含带时间的轨迹点。</translation>
    </message>
    <message>
        <source>holds no track point with a time. First problem: %1</source>
        <translation>不含带时间的轨迹点。首个问题：%1</translation>
    </message>
    <message>
        <source>GPX does not state errors: 3 m, and 5 m in height, are assumed.</source>
        <translation>GPX 不说明误差：假定为 3 m，高度为 5 m。</translation>
    </message>
    <message>
        <source>%1 track points have no height; it is taken to be zero.</source>
        <translation>%1 个轨迹点没有高度；按零处理。</translation>
    </message>
    <message>
        <source>holds neither an NMEA log nor a GPX track</source>
        <translation>既不含 NMEA 日志，也不含 GPX 轨迹</translation>
    </message>
    <message>
        <source>holds several %1: %2 and %3; put each drive into a folder of its own, or name the files in a session.yaml</source>
        <translation>含有多个 %1：%2 和 %3；请把每段行程放入各自的文件夹，或在 session.yaml 中指明文件</translation>
    </message>
    <message>
        <source>NMEA logs</source>
        <translation>NMEA 日志</translation>
    </message>
    <message>
        <source>GPX tracks</source>
        <translation>GPX 轨迹</translation>
    </message>
    <message>
        <source>files of LiDAR poses</source>
        <translation>激光雷达位姿文件</translation>
    </message>
    <message>
        <source>A GNSS log is half a session: put it into a folder with LiDAR poses, or declare it with the scans in a session.yaml.</source>
        <translation>GNSS 日志只是半份数据：请把它与激光雷达位姿放入同一文件夹，或在 session.yaml 中与扫描一起声明。</translation>
    </message>
    <message>
        <source>field %1 is beyond 1e9</source>
        <translation>第 %1 个字段超过 1e9</translation>
    </message>
    <message>
        <source>&apos;&apos; is no time in seconds</source>
        <translation>空白，应为以秒计的时间</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no time in seconds</source>
        <translation>“%1”不是以秒计的时间</translation>
    </message>
    <message>
        <source>header.stamp holds no seconds and nanoseconds</source>
        <translation>header.stamp 中没有秒和纳秒</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no position type, expected a whole number</source>
        <translation>“%1”不是定位类型，应为整数</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no time like 2021-10-26-16-21-29-468</source>
        <translation>“%1”不是形如 2021-10-26-16-21-29-468 的时间</translation>
    </message>
    <message>
        <source>%1 of %2 positions are not fixed by their position type.</source>
        <translation>%2 个位置中，有 %1 个按其定位类型不是固定解。</translation>
    </message>
    <message>
        <source>holds no usable pose (%1).</source>
        <translation>不含可用的位姿（%1）。</translation>
    </message>
    <message>
        <source>holds no usable pose (%1). First problem: %2</source>
        <translation>不含可用的位姿（%1）。首个问题：%2</translation>
    </message>
    <message>
        <source>INS time = LiDAR time %1 s (sigma %2 s, correlation %3, next best %4)</source>
        <translation>INS 时间 = 激光雷达时间 %1 s（标准差 %2 s，相关系数 %3，次优 %4）</translation>
    </message>
    <message>
        <source>holds several pose files named after %1; put each pair into a folder of its own:%2</source>
        <translation>含有多个名称带 %1 的位姿文件；请把每一对放入各自的文件夹：%2</translation>
    </message>
    <message>
        <source>holds no pose file named after %1, found:%2</source>
        <translation>没有名称带 %1 的位姿文件，找到的有：%2</translation>
    </message>
    <message>
        <source>ins, imu, gnss, hand, vicon or body</source>
        <translation>ins、imu、gnss、hand、vicon 或 body</translation>
    </message>
    <message>
        <source>lidar, camera, cam, odom or laser</source>
        <translation>lidar、camera、cam、odom 或 laser</translation>
    </message>
    <message>
        <source>the index is &apos;%1&apos;, expected a whole number from 0</source>
        <translation>序号为“%1”，应为从 0 起的整数</translation>
    </message>
    <message>
        <source>more than %1 pairs, too many for a file of this size</source>
        <translation>超过 %1 对，对于这样大小的文件过多</translation>
    </message>
    <message>
        <source>%1 holds no rotation</source>
        <translation>%1 不是旋转</translation>
    </message>
    <message>
        <source>is empty, expected a header with P00..P23 and Q00..Q23</source>
        <translation>是空的，应有含 P00..P23 和 Q00..Q23 的表头</translation>
    </message>
    <message>
        <source>holds no pair below its header</source>
        <translation>表头之下没有数据对</translation>
    </message>
    <message>
        <source>&apos;&apos; is not one of: %1</source>
        <translation>空白，应为以下之一：%1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not one of: %2</source>
        <translation>“%1”不是以下之一：%2</translation>
    </message>
    <message>
        <source>expected a number above 0</source>
        <translation>应为大于 0 的数</translation>
    </message>
    <message>
        <source>a column&apos;s index must be 0 to 10000</source>
        <translation>列的序号必须为 0 到 10000</translation>
    </message>
    <message>
        <source>expected either &apos;%1&apos; or &apos;%2&apos;</source>
        <translation>应为“%1”或“%2”之一</translation>
    </message>
    <message>
        <source>a week belongs to scale: gps</source>
        <translation>week 只用于 scale: gps</translation>
    </message>
    <message>
        <source>latitude and longitude must have the same unit</source>
        <translation>纬度和经度的单位必须相同</translation>
    </message>
    <message>
        <source>&apos;sweep&apos; stands with timing: sweep and only there</source>
        <translation>“sweep”须与 timing: sweep 一同使用，且只能如此</translation>
    </message>
    <message>
        <source>there is no folder %1</source>
        <translation>没有文件夹 %1</translation>
    </message>
    <message>
        <source>no scan with a stamp is found in %1</source>
        <translation>在 %1 中没有找到带时间戳的扫描</translation>
    </message>
    <message>
        <source>has no attitude (PASHR or HDT): declare it as gnss</source>
        <translation>没有姿态（PASHR 或 HDT）：请将其声明为 gnss</translation>
    </message>
    <message>
        <source>a sigma is not negative</source>
        <translation>标准差不能为负</translation>
    </message>
    <message>
        <source>%1 deg is outside -360 to 360 deg</source>
        <translation>%1 度超出 -360 到 360 度</translation>
    </message>
    <message>
        <source>is no map of keys and values; expected &quot;format: %1&quot; and the rest of a session</source>
        <translation>不是键和值的映射；应有“format: %1”及数据的其余声明</translation>
    </message>
    <message>
        <source>the key &quot;format&quot; is missing; expected &quot;format: %1&quot;</source>
        <translation>缺少键“format”；应有“format: %1”</translation>
    </message>
    <message>
        <source>is &apos;%1&apos;, expected %2</source>
        <translation>为“%1”，应为 %2</translation>
    </message>
    <message>
        <source>clocks can be aligned only where lidar_poses are given</source>
        <translation>只有给出 lidar_poses 时才能对齐时钟</translation>
    </message>
    <message>
        <source>%1: the name is no time stamp (nanoseconds, seconds or 2021-10-26-16-21-29-468)</source>
        <translation>%1：名称不是时间戳（纳秒、秒或 2021-10-26-16-21-29-468）</translation>
    </message>
    <message>
        <source>expected a file&apos;s name and its stamp in nanoseconds</source>
        <translation>应为文件名及以纳秒计的时间戳</translation>
    </message>
    <message>
        <source>is missing or no regular file</source>
        <translation>缺失或不是普通文件</translation>
    </message>
    <message>
        <source>time_ns is &apos;&apos;, expected nanoseconds since 1970</source>
        <translation>time_ns 空白，应为自 1970 年起的纳秒数</translation>
    </message>
    <message>
        <source>time_ns is &apos;%1&apos;, expected nanoseconds since 1970</source>
        <translation>time_ns 为“%1”，应为自 1970 年起的纳秒数</translation>
    </message>
    <message>
        <source>is empty, expected a line of column names</source>
        <translation>是空的，应有一行列名</translation>
    </message>
    <message>
        <source>holds no usable line.</source>
        <translation>不含可用的行。</translation>
    </message>
    <message>
        <source>holds no usable line. First problem: %1</source>
        <translation>不含可用的行。首个问题：%1</translation>
    </message>
    <message>
        <source>the covariance is not positive definite; state the receiver&apos;s own</source>
        <translation>协方差不是正定的；请给出接收机自己的协方差</translation>
    </message>
    <message>
        <source>cov_east_north_m2, cov_east_up_m2 and cov_north_up_m2 stand together or not at all</source>
        <translation>cov_east_north_m2、cov_east_up_m2 和 cov_north_up_m2 须同时给出或都不给出</translation>
    </message>
    <message>
        <source>expected a time like 2011-09-26 13:02:25.964389445</source>
        <translation>应为形如 2011-09-26 13:02:25.964389445 的时间</translation>
    </message>
    <message>
        <source>has no time stamp</source>
        <translation>没有时间戳</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>expected R: with 9 and T: with 3 numbers</source>
        <translation>应有含 9 个数的 R: 和含 3 个数的 T:</translation>
    </message>
    <message>
        <source>holds no KITTI drive: a folder with oxts/timestamps.txt, oxts/data and velodyne_points/data</source>
        <translation>不含 KITTI 行程：即含 oxts/timestamps.txt、oxts/data 和 velodyne_points/data 的文件夹</translation>
    </message>
    <message>
        <source>Of several files this one is used for the INS; not used: %1.</source>
        <translation>在多个文件中，此文件用于 INS；未使用：%1。</translation>
    </message>
    <message>
        <source>Of several files this one is used for the LiDAR; not used: %1.</source>
        <translation>在多个文件中，此文件用于激光雷达；未使用：%1。</translation>
    </message>
    <message>
        <source>holds no INS poses: lines of a stamp like 2021-10-26-16-21-29-468 and 12 numbers</source>
        <translation>不含 INS 位姿：即由形如 2021-10-26-16-21-29-468 的时间戳和 12 个数组成的行</translation>
    </message>
    <message>
        <source>holds INS poses, but neither PCD files named by their stamps nor LiDAR poses (*lidar*-pose*)</source>
        <translation>含有 INS 位姿，但既没有以时间戳命名的 PCD 文件，也没有激光雷达位姿（*lidar*-pose*）</translation>
    </message>
    <message>
        <source>There are %1 LiDAR poses and only %2 scans; the poses are used. To use the scans, move the LiDAR poses away.</source>
        <translation>有 %1 个激光雷达位姿，而扫描只有 %2 次；使用位姿。若要使用扫描，请移走激光雷达位姿。</translation>
    </message>
    <message>
        <source>expected a time in seconds after the keyword</source>
        <translation>关键字之后应为以秒计的时间</translation>
    </message>
    <message>
        <source>holds no usable odom3 line.</source>
        <translation>不含可用的 odom3 行。</translation>
    </message>
    <message>
        <source>holds no usable odom3 line. First problem: %1</source>
        <translation>不含可用的 odom3 行。首个问题：%1</translation>
    </message>
    <message>
        <source>the position is not near the Earth&apos;s surface</source>
        <translation>位置不在地球表面附近</translation>
    </message>
    <message>
        <source>holds no usable point3 line.</source>
        <translation>不含可用的 point3 行。</translation>
    </message>
    <message>
        <source>holds no usable point3 line. First problem: %1</source>
        <translation>不含可用的 point3 行。首个问题：%1</translation>
    </message>
    <message>
        <source>holds %1 drives; name one of them, as %2</source>
        <translation>含有 %1 段行程；请指明其中之一，例如 %2</translation>
    </message>
    <message>
        <source>There is one speed of the vehicle and none of its wheels: both wheels have it, and their difference tells nothing about turning.</source>
        <translation>只有车辆的速度，没有各车轮的速度：两轮都采用此速度，其差值不能说明转弯。</translation>
    </message>
    <message>
        <source>The positions are the data set&apos;s ground truth, not a receiver&apos;s; their covariance is not stated, a sigma of 0.1 m is assumed.</source>
        <translation>这些位置是数据集的真值，而非接收机的定位；其协方差未说明，假定标准差为 0.1 m。</translation>
    </message>
    <message>
        <source>is a session of format %1, which has no topics to choose from</source>
        <translation>是 %1 格式的数据，没有可供选择的话题</translation>
    </message>
    <message>
        <source>has no scan %1; its scans are 0 to %2</source>
        <translation>没有扫描 %1；其扫描为 0 到 %2</translation>
    </message>
    <message>
        <source>has no INS motion to write</source>
        <translation>没有可写入的 INS 运动</translation>
    </message>
    <message>
        <source>has neither scans nor LiDAR poses to write</source>
        <translation>既没有可写入的扫描，也没有可写入的激光雷达位姿</translation>
    </message>
    <message>
        <source>KITTI raw needs geodetic INS samples and scans</source>
        <translation>KITTI raw 需要含经纬度的 INS 样本以及扫描</translation>
    </message>
    <message>
        <source>reading GNSS</source>
        <translation>读取 GNSS</translation>
    </message>
    <message>
        <source>reading ground truth</source>
        <translation>读取真值</translation>
    </message>
    <message>
        <source>reading odometry</source>
        <translation>读取里程计</translation>
    </message>
    <message>
        <source>reading what is new</source>
        <translation>读取新增内容</translation>
    </message>
    <message>
        <source>reading messages</source>
        <translation>读取消息</translation>
    </message>
    <message>
        <source>reading the index</source>
        <translation>读取索引</translation>
    </message>
    <message>
        <source>reading a bag without an index, MB</source>
        <translation>读取没有索引的 bag，MB</translation>
    </message>
    <message>
        <source>unpacking the bag, MB</source>
        <translation>解压 bag，MB</translation>
    </message>
    <message>
        <source>%1. The scan is skipped.</source>
        <translation>%1。该帧扫描已跳过。</translation>
    </message>
    <message>
        <source>%1, byte %2: %3 points of %4 bytes from byte %5 on, but the file has %6 bytes</source>
        <translation>%1，字节 %2：自字节 %5 起有 %3 个点，每点 %4 字节，但文件只有 %6 字节</translation>
    </message>
    <message>
        <source>fields are &apos;%1&apos;, expected x, y and z with one value each</source>
        <translation>字段为“%1”，应有 x、y 和 z，各一个值</translation>
    </message>
    <message>
        <source>is no PCD, PLY, LAS, KITTI .bin or .txt scan</source>
        <translation>不是 PCD、PLY、LAS、KITTI .bin 或 .txt 扫描</translation>
    </message>
    <message>
        <source>holds %1 bytes, expected a multiple of 16 (x, y, z, reflectance as floats)</source>
        <translation>含 %1 字节，应为 16 的倍数（x、y、z、反射率，均为 float）</translation>
    </message>
    <message>
        <source>expected x y z and reflectance</source>
        <translation>应为 x y z 和反射率</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>“%1”不是数</translation>
    </message>
    <message>
        <source>expected &quot;LASF&quot;</source>
        <translation>应为“LASF”</translation>
    </message>
    <message>
        <source>ends within the header, expected at least 227 bytes</source>
        <translation>在头部中结束，至少应有 227 字节</translation>
    </message>
    <message>
        <source>ends within the header, LAS 1.4 has 375 bytes</source>
        <translation>在头部中结束，LAS 1.4 的头部为 375 字节</translation>
    </message>
    <message>
        <source>is compressed (LAZ): unpack it to LAS first</source>
        <translation>是压缩的（LAZ）：请先解压为 LAS</translation>
    </message>
    <message>
        <source>point format %1, expected 0 to 10</source>
        <translation>点格式为 %1，应为 0 到 10</translation>
    </message>
    <message>
        <source>points of %1 bytes, format %2 has at least %3</source>
        <translation>每点 %1 字节，而格式 %2 至少为 %3 字节</translation>
    </message>
    <message>
        <source>%1 points of %2 bytes from byte %3 on, but the file has %4 bytes</source>
        <translation>自字节 %3 起有 %1 个点，每点 %2 字节，但文件只有 %4 字节</translation>
    </message>
    <message>
        <source>scale or offset is no finite number, or the scale is 0</source>
        <translation>比例或偏移不是有限的数，或比例为 0</translation>
    </message>
    <message>
        <source>more points than the file has bytes</source>
        <translation>点数多于文件的字节数</translation>
    </message>
    <message>
        <source>holds coordinates of a map (up to %1 m), expected metres in the frame of the sensor, one scan a file</source>
        <translation>含有地图坐标（达 %1 m），应为传感器坐标系中以米计的坐标，每个文件一次扫描</translation>
    </message>
    <message>
        <source>a point is farther away than LAS of this scale holds</source>
        <translation>有点的距离超出此比例的 LAS 所能表示的范围</translation>
    </message>
    <message>
        <source>%1 holds &apos;%2&apos;, expected an integer from %3 to %4</source>
        <translation>%1 为“%2”，应为整数，范围 %3 到 %4</translation>
    </message>
    <message>
        <source>has %1 columns, at most %2 are read</source>
        <translation>有 %1 列，最多读取 %2 列</translation>
    </message>
    <message>
        <source>%1 expects one number</source>
        <translation>%1 应有一个数</translation>
    </message>
    <message>
        <source>TYPE holds &apos;%1&apos;, expected I, U or F</source>
        <translation>TYPE 为“%1”，应为 I、U 或 F</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a line of a PCD header</source>
        <translation>“%1”不是 PCD 头部的行</translation>
    </message>
    <message>
        <source>TYPE %1 with SIZE %2 is not a number type</source>
        <translation>TYPE %1 与 SIZE %2 不构成数的类型</translation>
    </message>
    <message>
        <source>FIELDS is missing before DATA</source>
        <translation>DATA 之前缺少 FIELDS</translation>
    </message>
    <message>
        <source>FIELDS names %1 columns, but SIZE has %2, TYPE %3 and COUNT %4</source>
        <translation>FIELDS 列出 %1 列，但 SIZE 有 %2 项，TYPE 有 %3 项，COUNT 有 %4 项</translation>
    </message>
    <message>
        <source>neither POINTS nor WIDTH stands before DATA</source>
        <translation>DATA 之前既没有 POINTS 也没有 WIDTH</translation>
    </message>
    <message>
        <source>WIDTH times HEIGHT does not fit 64 bits</source>
        <translation>WIDTH 乘以 HEIGHT 超出 64 位</translation>
    </message>
    <message>
        <source>POINTS is %1, but WIDTH times HEIGHT is %2</source>
        <translation>POINTS 为 %1，但 WIDTH 乘以 HEIGHT 为 %2</translation>
    </message>
    <message>
        <source>is empty, expected a PCD header</source>
        <translation>是空的，应有 PCD 头部</translation>
    </message>
    <message>
        <source>DATA is &apos;&apos;, expected ascii, binary or binary_compressed</source>
        <translation>DATA 应有 ascii、binary 或 binary_compressed 之一</translation>
    </message>
    <message>
        <source>DATA is &apos;%1&apos;, expected ascii, binary or binary_compressed</source>
        <translation>DATA 为“%1”，应为 ascii、binary 或 binary_compressed</translation>
    </message>
    <message>
        <source>no DATA line within the first %1 bytes</source>
        <translation>前 %1 字节内没有 DATA 行</translation>
    </message>
    <message>
        <source>ends after %1 of %2 points</source>
        <translation>共 %2 点，在第 %1 点之后结束</translation>
    </message>
    <message>
        <source>ends before the two sizes of the compressed data</source>
        <translation>在压缩数据的两个长度之前结束</translation>
    </message>
    <message>
        <source>promises %1 compressed bytes, %2 are there</source>
        <translation>声明有 %1 个压缩字节，实际有 %2 个</translation>
    </message>
    <message>
        <source>promises %1 bytes, expected %2 points of %3 bytes</source>
        <translation>声明有 %1 字节，应为 %2 个点、每点 %3 字节</translation>
    </message>
    <message>
        <source>the LZF stream is broken or has another length than promised</source>
        <translation>LZF 数据流已损坏，或长度与声明不符</translation>
    </message>
    <message>
        <source>promises %1 points, the %2 bytes that follow hold at most %3</source>
        <translation>声明有 %1 个点，其后的 %2 字节最多容纳 %3 个</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a PLY number type</source>
        <translation>“%1”不是 PLY 的数类型</translation>
    </message>
    <message>
        <source>more than %1 properties in one element</source>
        <translation>一个元素中超过 %1 个属性</translation>
    </message>
    <message>
        <source>expected &apos;property &lt;type&gt; &lt;name&gt;&apos; or &apos;property list &lt;type&gt; &lt;type&gt; &lt;name&gt;&apos;</source>
        <translation>应为“property &lt;type&gt; &lt;name&gt;”或“property list &lt;type&gt; &lt;type&gt; &lt;name&gt;”</translation>
    </message>
    <message>
        <source>format is &apos;&apos;, expected ascii, binary_little_endian or binary_big_endian</source>
        <translation>format 应有 ascii、binary_little_endian 或 binary_big_endian 之一</translation>
    </message>
    <message>
        <source>format is &apos;%1&apos;, expected ascii, binary_little_endian or binary_big_endian</source>
        <translation>format 为“%1”，应为 ascii、binary_little_endian 或 binary_big_endian</translation>
    </message>
    <message>
        <source>expected &apos;element &lt;name&gt; &lt;count&gt;&apos;</source>
        <translation>应为“element &lt;name&gt; &lt;count&gt;”</translation>
    </message>
    <message>
        <source>a property stands before the first element</source>
        <translation>第一个元素之前出现属性</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a line of a PLY header</source>
        <translation>“%1”不是 PLY 头部的行</translation>
    </message>
    <message>
        <source>does not begin with &apos;ply&apos;</source>
        <translation>不以“ply”开头</translation>
    </message>
    <message>
        <source>the header has no &apos;format&apos; line</source>
        <translation>头部没有“format”行</translation>
    </message>
    <message>
        <source>no &apos;end_header&apos; within the first %1 bytes</source>
        <translation>前 %1 字节内没有“end_header”</translation>
    </message>
    <message>
        <source>ends within element &apos;%1&apos;</source>
        <translation>在元素“%1”中结束</translation>
    </message>
    <message>
        <source>value %1 of the line is missing or no number</source>
        <translation>该行的第 %1 个值缺失或不是数</translation>
    </message>
    <message>
        <source>a list promises more values than the file holds</source>
        <translation>有列表声明的值多于文件所含的</translation>
    </message>
    <message>
        <source>element &apos;%1&apos; promises %2 rows, the file holds at most %3</source>
        <translation>元素“%1”声明有 %2 行，文件最多容纳 %3 行</translation>
    </message>
    <message>
        <source>has no element &apos;vertex&apos;</source>
        <translation>没有元素“vertex”</translation>
    </message>
    <message>
        <source>%1: known by what was measured</source>
        <translation>%1：由测量值得知</translation>
    </message>
    <message>
        <source>The sessions scatter %1 times as much as their errors explain; the sigmas include it.</source>
        <translation>各份数据的离散程度是其误差所能解释的 %1 倍；sigma 已将其计入。</translation>
    </message>
    <message>
        <source>%1 was given as measured, %2, without a sigma and is not used: give its sigma, too.</source>
        <translation>给出了测量值 %1 = %2，但没有 sigma，因此未使用：请同时给出其 sigma。</translation>
    </message>
    <message>
        <source>the shift along [%1], the shift along [%2]</source>
        <translation>沿 [%1] 和 [%2] 的平移</translation>
    </message>
    <message>
        <source>the turn about [%1], the turn about [%2]</source>
        <translation>绕 [%1] 和 [%2] 的转动</translation>
    </message>
    <message>
        <source>the shift along [%1], the turn about [%2], the turn about [%3]</source>
        <translation>沿 [%1] 的平移、绕 [%2] 和 [%3] 的转动</translation>
    </message>
    <message>
        <source>the shift along [%1], the shift along [%2], the turn about [%3]</source>
        <translation>沿 [%1] 和 [%2] 的平移、绕 [%3] 的转动</translation>
    </message>
    <message>
        <source>the shift along [%1], the shift along [%2], the turn about [%3], the turn about [%4]</source>
        <translation>沿 [%1] 和 [%2] 的平移、绕 [%3] 和 [%4] 的转动</translation>
    </message>
    <message>
        <source>the shift along [%1], %2</source>
        <translation>沿 [%1] 的平移、%2</translation>
    </message>
    <message>
        <source>the shift along [%1], the shift along [%2], %3</source>
        <translation>沿 [%1] 和 [%2] 的平移、%3</translation>
    </message>
    <message>
        <source>%1, the turn about [%2]</source>
        <translation>%1、绕 [%2] 的转动</translation>
    </message>
    <message>
        <source>%1, the turn about [%2], the turn about [%3]</source>
        <translation>%1、绕 [%2] 和 [%3] 的转动</translation>
    </message>
    <message>
        <source>The vehicle turns by %1 degrees in all: the position of the LiDAR will hardly be observable from this drive alone. Drive a figure of eight.</source>
        <translation>车辆总共只转了 %1 度：仅凭这段数据几乎无法观测激光雷达的位置。请绕 8 字行驶。</translation>
    </message>
    <message>
        <source>holds %1 drives; name their folders, several of one vehicle where they belong together:%2</source>
        <translation>含有 %1 段行程；请指明其文件夹，同一辆车的几段可以一起给出：%2</translation>
    </message>
    <message>
        <source>Height z needs pitch or roll: drive over a ramp, a kerb with one wheel or a bumpy road while turning. Until then files hold the nominal z, or 0 where none was given; where it matters, measure it by tape and give it with --measured.</source>
        <translation>高度 z 需要俯仰或横滚：转弯时驶过坡道、单轮压上路沿或颠簸路面。在此之前文件中的 z 为名义值，未给出名义值时为 0；若高度重要，请用卷尺测量并用 --measured 给出。</translation>
    </message>
    <message>
        <source>The result does not contain the value that was measured by hand.</source>
        <translation>结果中不含该手工测量值。</translation>
    </message>
    <message>
        <source>%1 was given as measured, %2, and is not used: this method takes no height of the INS. Leave it out.</source>
        <translation>给出了测量值 %1（%2），但未使用：此方法不使用惯导高度。请不要给出该值。</translation>
    </message>
    <message>
        <source>Give its sigma, or leave it out.</source>
        <translation>请给出其 sigma，或不要给出该值。</translation>
    </message>
    <message>
        <source>Leave it out, or record an INS with attitude.</source>
        <translation>请不要给出该值，或录制带姿态的惯导数据。</translation>
    </message>
    <message>
        <source>Messages without a fix or an orientation are no poses of the INS.</source>
        <translation>没有定位解或没有姿态的消息不能作为惯导位姿。</translation>
    </message>
    <message>
        <source>Let the INS get its fix and align before you drive; record position and orientation at one rate.</source>
        <translation>行驶前请等待惯导定位并完成对准；位置与姿态应以相同频率录制。</translation>
    </message>
    <message>
        <source>Where the vehicle turns, an interpolated motion is not the one that was driven.</source>
        <translation>车辆转弯时，插值得到的运动并不是实际的运动。</translation>
    </message>
    <message>
        <source>Log the INS at 50 Hz or faster, or drive slowly and steadily.</source>
        <translation>请以 50 Hz 或更高的频率记录惯导，或缓慢而平稳地行驶。</translation>
    </message>
    <message>
        <source>What the recorder is late by is a clock offset: X is off by it where the vehicle turns.</source>
        <translation>录制程序的延迟就是时钟偏差：车辆转弯时 X 会因此产生偏差。</translation>
    </message>
    <message>
        <source>Have the driver stamp its messages; look at the clock offset of the result.</source>
        <translation>请让驱动程序为消息打上时间戳；并查看结果中的时钟偏差。</translation>
    </message>
    <message>
        <source>A height that falls to zero is taken for motion.</source>
        <translation>高度突变为零会被当作运动。</translation>
    </message>
    <message>
        <source>Export the track with its heights, or take out the points that have none.</source>
        <translation>请导出带高度的轨迹，或去掉没有高度的点。</translation>
    </message>
    <message>
        <source>The search begins without the mounting that lies beside the drive.</source>
        <translation>搜索开始时未使用与数据放在一起的安装参数。</translation>
    </message>
    <message>
        <source>Digits were lost, or the numbers are in another order than was taken.</source>
        <translation>数字的位数有丢失，或数值的顺序与所假定的不同。</translation>
    </message>
    <message>
        <source>Export the poses again with all digits, and check their layout.</source>
        <translation>请以完整位数重新导出位姿，并检查其排列格式。</translation>
    </message>
    <message>
        <source>Scans without a motion of the INS cannot be compared with anything.</source>
        <translation>没有惯导运动的扫描无从比较。</translation>
    </message>
    <message>
        <source>Record the INS from before the first scan until after the last, on one clock.</source>
        <translation>惯导的录制应早于第一帧扫描开始、晚于最后一帧结束，并使用同一时钟。</translation>
    </message>
    <message>
        <source>There is nothing that could be registered.</source>
        <translation>没有可以配准的数据。</translation>
    </message>
    <message>
        <source>A motion lies between two scans.</source>
        <translation>两帧扫描之间才有运动。</translation>
    </message>
    <message>
        <source>Record a drive, and see whether the folder holds all of its scans.</source>
        <translation>请录制一段行驶数据，并检查文件夹中是否包含全部扫描。</translation>
    </message>
    <message>
        <source>Only motion tells where the LiDAR sits.</source>
        <translation>只有运动才能确定激光雷达的位置。</translation>
    </message>
    <message>
        <source>Poses that are predicted come from no scan: what the LiDAR did there is not known.</source>
        <translation>预测的位姿不来自任何扫描：该处激光雷达的运动是未知的。</translation>
    </message>
    <message>
        <source>Drive more slowly, or where there is more to see; see whether the scans are whole and in order.</source>
        <translation>请更慢地行驶，或选择特征更丰富的地方；并检查扫描是否完整、顺序是否正确。</translation>
    </message>
    <message>
        <source>A scan that is not aligned has no pose, and takes no part.</source>
        <translation>未能配准的扫描没有位姿，不参与计算。</translation>
    </message>
    <message>
        <source>What spans such a place rests on a prediction.</source>
        <translation>跨越该处的结果依赖于预测。</translation>
    </message>
    <message>
        <source>Look for gaps of the scans there; drive more slowly, or where there is more to see.</source>
        <translation>请检查该处扫描是否有中断；更慢地行驶，或选择特征更丰富的地方。</translation>
    </message>
    <message>
        <source>Scans that are taken while the vehicle moves stay bent, and align the worse for it.</source>
        <translation>车辆运动时采集的扫描仍有畸变，配准也因此变差。</translation>
    </message>
    <message>
        <source>Have the driver write the times of points from the stamp of the scan, in one unit.</source>
        <translation>请让驱动程序以扫描的时间戳为起点、用同一单位写入各点的时间。</translation>
    </message>
    <message>
        <source>There is nothing to compare its odometry with.</source>
        <translation>其里程计没有可供比较的对象。</translation>
    </message>
    <message>
        <source>Record an INS with attitude, or leave the session out.</source>
        <translation>请录制带姿态的惯导数据，或去掉该会话。</translation>
    </message>
    <message>
        <source>Either these positions and attitudes are wrong, or their clock is.</source>
        <translation>要么这些位置和姿态有误，要么其时钟有误。</translation>
    </message>
    <message>
        <source>Look for lost corrections and reflected signals there; where they are many, look at clocks and conventions.</source>
        <translation>请检查该处是否丢失差分改正或存在信号反射；若数量较多，请检查时钟和坐标约定。</translation>
    </message>
    <message>
        <source>Dead reckoning does not reach across a gap.</source>
        <translation>航位推算无法跨越数据中断。</translation>
    </message>
    <message>
        <source>The other sessions take no part.</source>
        <translation>其他会话不参与计算。</translation>
    </message>
    <message>
        <source>Give one session, or poses of a sensor.</source>
        <translation>请只给出一个会话，或给出某个传感器的位姿。</translation>
    </message>
    <message>
        <source>The machine stood on a slope, or what was taken for the ground is none.</source>
        <translation>机器停在斜坡上，或被当作地面的并不是地面。</translation>
    </message>
    <message>
        <source>Record the ground where it is level and free around the machine.</source>
        <translation>请在机器周围平坦而空旷的地方录制地面。</translation>
    </message>
    <message>
        <source>z, pitch and roll rest on the motion of the drive alone.</source>
        <translation>z、俯仰和横滚仅由行驶中的运动确定。</translation>
    </message>
    <message>
        <source>Drive where the road around the vehicle is free, or measure z by hand.</source>
        <translation>请在车辆周围路面空旷的地方行驶，或手工测量 z。</translation>
    </message>
    <message>
        <source>holds neither an MCAP nor an SQLite database when it is unpacked; unpack it with &apos;zstd -d&apos; and open what comes out</source>
        <translation>解压后既不是 MCAP 也不是 SQLite 数据库；请用“zstd -d”自行解压，再打开所得文件</translation>
    </message>
    <message>
        <source>a compressed message becomes larger than %1 bytes, the most that is taken from a file of this size</source>
        <translation>压缩的消息解压后大于 %1 字节，对于这样大小的文件最多读取这么多</translation>
    </message>
    <message>
        <source>the compressed message is damaged after %1 bytes</source>
        <translation>压缩的消息在 %1 字节之后已损坏</translation>
    </message>
    <message>
        <source>the bag was not opened</source>
        <translation>bag 未打开</translation>
    </message>
    <message>
        <source>By the recorder&apos;s clock the stamps are %1 s apart from the LiDAR&apos;s, more than the delays of a recording: one of the two seems to be stamped by a clock that is off, as a host&apos;s is. They are not moved; it shows as time offset.</source>
        <translation>按记录器的时钟，这些时间戳与激光雷达的相差 %1 秒，超出记录的延迟：其中之一的时钟似乎不准，例如主机的时钟。未作移动；表现为时间偏移。</translation>
    </message>
    <message>
        <source>fields %1 and %2 lie on the same bytes of a point</source>
        <translation>字段 %1 和 %2 占用点的同一些字节</translation>
    </message>
    <message>
        <source>the coordinate %1 has one byte, expected two or more</source>
        <translation>坐标 %1 只有一个字节，应为两个或更多</translation>
    </message>
    <message>
        <source>Begin the log with a heading (HDT) and end it with a position, or log PASHR, which has a time.</source>
        <translation>请让日志以航向（HDT）开始并以位置结束，或记录带有时间的 PASHR。</translation>
    </message>
    <message>
        <source>Between attitudes that are far apart in time the motion is not known.</source>
        <translation>时间上相隔很远的姿态之间，运动是未知的。</translation>
    </message>
    <message>
        <source>Log attitude (PASHR or HDT) at the rate of the positions, at 5 Hz or more.</source>
        <translation>请以位置的频率记录姿态（PASHR 或 HDT），不低于 5 Hz。</translation>
    </message>
    <message>
        <source>%1 of %2 positions have no attitude near them and are left out of the INS: the log has %3 attitudes, up to %4 s apart, and none is interpolated over more than 0.25 s.</source>
        <translation>%2 个位置中有 %1 个附近没有姿态，不计入 INS：日志有 %3 个姿态，最多相隔 %4 s，而插值的间隔不超过 0.25 s。</translation>
    </message>
    <message>
        <source>In turns, headings may be those of the next position.</source>
        <translation>转弯时，航向可能属于下一个位置。</translation>
    </message>
    <message>
        <source>The log does not show whether a heading (HDT) stands before or behind the position of its time: it is taken to stand behind. Otherwise headings come one position too early.</source>
        <translation>日志没有表明航向（HDT）写在同一时刻的位置之前还是之后：按写在之后处理。若不是，航向会早一个位置。</translation>
    </message>
    <message>
        <source>The INS repeats one attitude for %1 s, while its positions run through a turn.</source>
        <translation>INS 在 %1 秒内重复同一姿态，而其位置正在转弯。</translation>
    </message>
    <message>
        <source>The INS repeats one position for %1 s, while its attitude changes and the vehicle drives on.</source>
        <translation>INS 在 %1 秒内重复同一位置，而其姿态在变化，车辆仍在行驶。</translation>
    </message>
    <message>
        <source>Pairs take the vehicle to have moved without turning; those in turns contradict all others.</source>
        <translation>帧对会认为车辆移动而没有转动；转弯处的帧对与其他所有帧对矛盾。</translation>
    </message>
    <message>
        <source>See whether the attitude had aligned and whether its log or driver stalled; leave that part of the drive out, or record it again.</source>
        <translation>请查看姿态是否已对准，其记录或驱动是否停顿；略去该段行程，或重新记录。</translation>
    </message>
    <message>
        <source>Pairs take the vehicle to have turned in its place, and what is found for its position is wrong.</source>
        <translation>帧对会认为车辆在原地转动，求得的位置因而有误。</translation>
    </message>
    <message>
        <source>See whether GNSS or its driver stalled; leave that part of the drive out, or use a log that was processed afterwards (PPK).</source>
        <translation>请查看 GNSS 或其驱动是否停顿；略去该段行程，或使用事后处理（PPK）的日志。</translation>
    </message>
    <message>
        <source>The INS has a position every %1 s only; between them the motion is interpolated. No other topic has it much more often: set its output to 10 Hz or more.</source>
        <translation>INS 每 %1 秒才有一个位置；其间的运动为内插所得。没有其他话题比它频繁得多：请把其输出设为 10 Hz 或更高。</translation>
    </message>
    <message>
        <source>The INS has a position every %1 s only; between them the motion is interpolated. %2 has %3 Hz: --topic %4=%5 takes it, where it is of the same INS.</source>
        <translation>INS 每 %1 秒才有一个位置；其间的运动为内插所得。%2 为 %3 Hz：如属同一 INS，用 --topic %4=%5 选用。</translation>
    </message>
    <message>
        <source>no message of this topic has turn rates</source>
        <translation>此话题没有任何消息含有角速度</translation>
    </message>
    <message>
        <source>The static transforms are not used: the messages of the INS name no frame of their own.</source>
        <translation>未使用静态变换：INS 的消息没有指明自己的坐标系。</translation>
    </message>
    <message>
        <source>The static transforms are not used: the scans name no frame.</source>
        <translation>未使用静态变换：扫描没有指明坐标系。</translation>
    </message>
    <message>
        <source>The static transforms are not used: LiDAR and INS name one and the same frame, %1.</source>
        <translation>未使用静态变换：激光雷达和 INS 指明的是同一坐标系 %1。</translation>
    </message>
    <message>
        <source>no usable INS is in this topic: none of its messages has an orientation</source>
        <translation>此话题中没有可用的 INS：其消息都没有姿态</translation>
    </message>
    <message>
        <source>no usable INS is in this topic: none of its messages has an orientation%1</source>
        <translation>此话题中没有可用的 INS：其消息都没有姿态%1</translation>
    </message>
    <message>
        <source>no usable INS is in this topic: its orientation is never filled in, it is the identity throughout</source>
        <translation>此话题中没有可用的 INS：其姿态从未填写，始终是单位四元数</translation>
    </message>
    <message>
        <source>no usable INS is in this topic: its orientation is never filled in, it is the identity throughout%1</source>
        <translation>此话题中没有可用的 INS：其姿态从未填写，始终是单位四元数%1</translation>
    </message>
    <message>
        <source>Where the INS has no orientation there is no motion to be compared with.</source>
        <translation>INS 没有姿态之处，没有可供比较的运动。</translation>
    </message>
    <message>
        <source>Nothing, where they are at the beginning: the INS was aligning; otherwise see what the driver reports.</source>
        <translation>若在开头则无需处理：INS 正在对准；否则请查看驱动报告的内容。</translation>
    </message>
    <message>
        <source>The rates are used, though the driver says that there are none.</source>
        <translation>驱动声明没有角速度，仍予使用。</translation>
    </message>
    <message>
        <source>Compare them with the turns of the drive; where they mean nothing leave them out: --topic imu=none.</source>
        <translation>请与行程中的转弯比较；若无意义，用 --topic imu=none 略去。</translation>
    </message>
    <message>
        <source>Methods that need turn rates have none there.</source>
        <translation>需要角速度的方法在该处没有数据。</translation>
    </message>
    <message>
        <source>See whether the driver of the IMU stalled, or say with --topic which topic is the IMU.</source>
        <translation>请查看 IMU 的驱动是否停顿，或用 --topic 指明哪个话题是 IMU。</translation>
    </message>
    <message>
        <source>The receiver has no position there.</source>
        <translation>接收机在该处没有位置。</translation>
    </message>
    <message>
        <source>Record under open sky; wait for a fix before you drive.</source>
        <translation>请在开阔天空下记录；有定位后再行驶。</translation>
    </message>
    <message>
        <source>Good fixes count as little as bad ones.</source>
        <translation>好的定位与差的定位权重同样低。</translation>
    </message>
    <message>
        <source>Have the driver state the covariance of its fixes.</source>
        <translation>请让驱动给出其定位的协方差。</translation>
    </message>
    <message>
        <source>an orientation without its error, to which fixes give the position</source>
        <translation>未标明误差的姿态，由定位消息给出位置</translation>
    </message>
    <message>
        <source>slow: %1 Hz, where %2 has %3 Hz</source>
        <translation>慢：%1 Hz，而 %2 为 %3 Hz</translation>
    </message>
    <message>
        <source>is empty, expected a topic of a bag, or &quot;none&quot; to leave the role out</source>
        <translation>为空，应为 bag 中的一个话题，或以“none”表示不使用该角色</translation>
    </message>
    <message>
        <source>The positions are of another device than the orientation by its topic: they may be those of an antenna.</source>
        <translation>按话题看，位置与姿态来自不同的设备：这些位置可能是天线的位置。</translation>
    </message>
    <message>
        <source>X is of the antenna then, turned as the IMU is: off by the lever arm between the two, and no sigma says so.</source>
        <translation>此时 X 是相对于天线的，而朝向与 IMU 一致：偏差为两者之间的杆臂，任何 sigma 都不会反映这一点。</translation>
    </message>
    <message>
        <source>Take the positions of the INS itself (--topic ins-position=TOPIC), or let the driver subtract the lever arm.</source>
        <translation>请采用 INS 自身的位置（--topic ins-position=TOPIC），或让驱动程序扣除杆臂。</translation>
    </message>
    <message>
        <source>The attitude stands still for %1 s at a time (%2 samples) and then jumps, by %3 degrees where the vehicle turns: it is logged more often than it is computed.</source>
        <translation>姿态每次静止 %1 s（%2 个样本）后突然跳变，车辆转弯时跳变 %3 度：它的记录频率高于计算频率。</translation>
    </message>
    <message>
        <source>The position stands still for %1 s at a time (%2 samples) and then jumps, by %3 m where the vehicle drives: it is logged more often than it is computed.</source>
        <translation>位置每次静止 %1 s（%2 个样本）后突然跳变，车辆行驶时跳变 %3 m：它的记录频率高于计算频率。</translation>
    </message>
    <message>
        <source>Pitch and roll of the INS contradict %1; with %2 they would agree: look which columns they are, and which way they count.</source>
        <translation>INS 的俯仰和横滚与%1矛盾；若%2则一致：请检查它们是哪些列，以及正方向如何规定。</translation>
    </message>
    <message>
        <source>the slope of its path</source>
        <translation>其路径的坡度</translation>
    </message>
    <message>
        <source>the forces that the IMU feels</source>
        <translation>IMU 感受到的力</translation>
    </message>
    <message>
        <source>the turns of the LiDAR</source>
        <translation>激光雷达的转动</translation>
    </message>
    <message>
        <source>pitch counted the other way</source>
        <translation>俯仰的正方向相反</translation>
    </message>
    <message>
        <source>roll counted the other way</source>
        <translation>横滚的正方向相反</translation>
    </message>
    <message>
        <source>one of them counted the other way, or both exchanged</source>
        <translation>其中之一的正方向相反，或二者互换</translation>
    </message>
    <message>
        <source>pitch and roll exchanged</source>
        <translation>俯仰与横滚互换</translation>
    </message>
    <message>
        <source>pitch and roll both counted the other way</source>
        <translation>俯仰和横滚的正方向都相反</translation>
    </message>
    <message>
        <source>pitch and roll exchanged, and one of them counted the other way</source>
        <translation>俯仰与横滚互换且其中之一的正方向相反</translation>
    </message>
    <message>
        <source>The heading of the INS does not follow the direction of travel, but it would with %1: correct the columns of the attitude. No mounting can be right with these.</source>
        <translation>INS 的航向与行驶方向不符，但若%1则相符：请更正姿态的列。按现有的列，任何安装位姿都不可能正确。</translation>
    </message>
    <message>
        <source>yaw and pitch exchanged</source>
        <translation>偏航与俯仰互换</translation>
    </message>
    <message>
        <source>yaw and roll exchanged</source>
        <translation>偏航与横滚互换</translation>
    </message>
    <message>
        <source>The heading of the INS does not follow the direction of travel, but it would if its angles were 57.3 times larger: these are radians that were taken for degrees.</source>
        <translation>INS 的航向与行驶方向不符，但若其角度放大 57.3 倍则相符：这些是被当作度的弧度。</translation>
    </message>
    <message>
        <source>The direction of travel does not follow the heading of the INS, but it would with latitude and longitude exchanged.</source>
        <translation>行驶方向与 INS 的航向不符，但若纬度与经度互换则相符。</translation>
    </message>
    <message>
        <source>The scans turn as the INS did about %1 s later (correlation %2): the LiDAR&apos;s stamps are early by as much.</source>
        <translation>扫描的转动与 INS 在约晚 %1 s 时的转动一致（相关系数 %2）：激光雷达的时间戳偏早同样多。</translation>
    </message>
    <message>
        <source>The scans turn as the INS did about %1 s later (correlation %2): the LiDAR&apos;s stamps are early by as much. %3</source>
        <translation>扫描的转动与 INS 在约晚 %1 s 时的转动一致（相关系数 %2）：激光雷达的时间戳偏早同样多。%3</translation>
    </message>
    <message>
        <source>The scans turn as the INS did about %1 s earlier (correlation %2): the LiDAR&apos;s stamps are late by as much.</source>
        <translation>扫描的转动与 INS 在约早 %1 s 时的转动一致（相关系数 %2）：激光雷达的时间戳偏晚同样多。</translation>
    </message>
    <message>
        <source>The scans turn as the INS did about %1 s earlier (correlation %2): the LiDAR&apos;s stamps are late by as much. %3</source>
        <translation>扫描的转动与 INS 在约早 %1 s 时的转动一致（相关系数 %2）：激光雷达的时间戳偏晚同样多。%3</translation>
    </message>
    <message>
        <source>The LiDAR&apos;s times begin %1 s after those of the INS, and end %2 s after them. %3</source>
        <translation>激光雷达的时间在 INS 的时间开始之后 %1 s 开始，在其结束之后 %2 s 结束。%3</translation>
    </message>
    <message>
        <source>The LiDAR&apos;s times begin %1 s before those of the INS, and end %2 s before them. %3</source>
        <translation>激光雷达的时间在 INS 的时间开始之前 %1 s 开始，在其结束之前 %2 s 结束。%3</translation>
    </message>
    <message>
        <source>TAI is 37 s ahead of UTC since 2017: likely a clock that PTP sets to TAI; declare the time scale.</source>
        <translation>自 2017 年起 TAI 比 UTC 快 37 s：很可能是 PTP 把时钟设成了 TAI；请声明时间尺度。</translation>
    </message>
    <message>
        <source>TAI is 19 s ahead of GPS time: likely a clock that PTP sets to TAI; declare the time scale.</source>
        <translation>TAI 比 GPS 时间快 19 s：很可能是 PTP 把时钟设成了 TAI；请声明时间尺度。</translation>
    </message>
    <message>
        <source>Attitudes are late by half such a step on average, and jump: X is off by as much where the vehicle turns, and no sigma says so.</source>
        <translation>姿态平均滞后半个这样的步长，并且跳变：车辆转弯时 X 随之偏差，而任何 sigma 都不会反映出来。</translation>
    </message>
    <message>
        <source>Log the attitude as it is computed, with all digits; or keep only the first sample of each that repeats: between those the motion is interpolated.</source>
        <translation>按姿态的计算频率记录，保留全部位数；或者在重复的样本中只保留第一个：其间的运动会被插值。</translation>
    </message>
    <message>
        <source>Positions are late by half such a step on average, and jump: X is off by the way that is driven meanwhile, and no sigma says so.</source>
        <translation>位置平均滞后半个这样的步长，并且跳变：X 的偏差相当于其间驶过的路程，而任何 sigma 都不会反映出来。</translation>
    </message>
    <message>
        <source>Log the position as it is computed, with all digits; or keep only the first sample of each that repeats: between those the motion is interpolated.</source>
        <translation>按位置的计算频率记录，保留全部位数；或者在重复的样本中只保留第一个：其间的运动会被插值。</translation>
    </message>
    <message>
        <source>Relative motions of the INS turn about the wrong axes; no result stands on them.</source>
        <translation>INS 的相对运动绕错误的轴转动；在此基础上任何结果都不成立。</translation>
    </message>
    <message>
        <source>Correct the columns or the signs that the finding names; of the path&apos;s slope only pitch can be told, look at the sign of roll as well.</source>
        <translation>请更正该发现所指出的列或符号；路径的坡度只能说明俯仰，也请检查横滚的符号。</translation>
    </message>
    <message>
        <source>To the calibration the vehicle hardly turns; no result stands on that.</source>
        <translation>在标定看来车辆几乎不转弯；在此基础上任何结果都不成立。</translation>
    </message>
    <message>
        <source>Give the unit of the angles as the log has it, or have the driver convert them to radians once.</source>
        <translation>请按日志实际情况给出角度的单位，或让驱动程序只把它们换算成弧度一次。</translation>
    </message>
    <message>
        <source>The path is mirrored, and goes its own way; no result stands on it.</source>
        <translation>路径成了镜像，与实际不符；在此基础上任何结果都不成立。</translation>
    </message>
    <message>
        <source>Exchange the columns of latitude and longitude.</source>
        <translation>请互换纬度和经度的列。</translation>
    </message>
    <message>
        <source>Scans are compared with the motion of another instant: no pair fits.</source>
        <translation>扫描与另一时刻的运动相比较：没有一对相符。</translation>
    </message>
    <message>
        <source>Declare the time scale (UTC, GPS, TAI) of each log, or subtract the difference from the stamps of one.</source>
        <translation>请声明每个日志的时间尺度（UTC、GPS、TAI），或从其中之一的时间戳中减去该差值。</translation>
    </message>
    <message>
        <source>Scans are compared with the motion of another instant: no pair fits, or X is off.</source>
        <translation>扫描与另一时刻的运动相比较：没有一对相符，或者 X 有偏差。</translation>
    </message>
    <message>
        <source>Move the stamps of the LiDAR by that much, and see why the clocks differ: one that is not synchronised, another time scale, stamps of arrival. The next calibration estimates what is left.</source>
        <translation>请把激光雷达的时间戳移动同样多，并查明时钟为何不同：未同步、时间尺度不同，或使用了到达时间。剩余的偏移由下一次标定估计。</translation>
    </message>
    <message>
        <source>Before anything else bring the clocks of LiDAR and INS together: their rates of rotation meet at another offset (see the findings).</source>
        <translation>请首先把激光雷达和 INS 的时钟对齐：二者的转动速率在另一个偏移下才相符（见各项发现）。</translation>
    </message>
    <message>
        <source>Before anything else correct columns, signs and units of the INS log (see the findings).</source>
        <translation>请首先更正 INS 日志的列、符号和单位（见各项发现）。</translation>
    </message>
    <message>
        <source>The INS contradicts itself: a column of its log is not what it is taken for.</source>
        <translation>INS 自相矛盾：其日志中有一列的含义与所认为的不同。</translation>
    </message>
    <message>
        <source>the angles are declared as unit: %1, but the heading then goes against the direction of travel; it follows it where they are %2 times larger: they were converted once too often. Write them in the unit that is declared</source>
        <translation>角度声明的单位为 unit: %1，但这样航向与行驶方向不符；若放大 %2 倍则相符：它们被多换算了一次。请按所声明的单位写出</translation>
    </message>
    <message>
        <source>the angles are declared as unit: %1, but the heading then goes against the direction of travel; it follows it where they are %2 times smaller: they were converted once too often. Write them in the unit that is declared</source>
        <translation>角度声明的单位为 unit: %1，但这样航向与行驶方向不符；若缩小为 %2 分之一则相符：它们被多换算了一次。请按所声明的单位写出</translation>
    </message>
    <message>
        <source>a latitude beyond 90 degrees is not possible: are latitude and longitude exchanged?</source>
        <translation>纬度不可能超过 90 度：纬度与经度是否互换了？</translation>
    </message>
    <message>
        <source>The clocks of LiDAR and INS are apart: scans were compared with the motion of another instant.</source>
        <translation>激光雷达与 INS 的时钟不一致：扫描与另一时刻的运动相比较。</translation>
    </message>
    <message>
        <source>cannot serve as %1; what it can be: %2</source>
        <translation>不能用作 %1；可用作：%2</translation>
    </message>
    <message>
        <source>cannot serve as %1, nor as anything else</source>
        <translation>不能用作 %1，也不能作其他用途</translation>
    </message>
    <message>
        <source>The recording is cut or damaged behind its data, where its index stands (%1). All data before that are whole; messages that were found by reading them: %2.</source>
        <translation>记录在数据之后、索引所在处被截断或损坏（%1）。此前的数据完整；通读后找到的消息数：%2。</translation>
    </message>
    <message>
        <source>%1 message has no fix: left out.</source>
        <translation>%1 条消息没有定位，已略去。</translation>
    </message>
    <message>
        <source>%1 messages have no fix: left out.</source>
        <translation>%1 条消息没有定位，已略去。</translation>
    </message>
    <message>
        <source>%1 fix does not state its covariance; a sigma of 1 m is assumed.</source>
        <translation>%1 个定位未说明协方差；假定标准差为 1 m。</translation>
    </message>
    <message>
        <source>%1 message has no orientation, %2 of them before the first that has one: left out.</source>
        <translation>%1 条消息没有姿态，其中 %2 条在首条有姿态的消息之前；已略去。</translation>
    </message>
    <message>
        <source>%1 messages have no orientation, %2 of them before the first that has one: left out.</source>
        <translation>%1 条消息没有姿态，其中 %2 条在首条有姿态的消息之前；已略去。</translation>
    </message>
    <message>
        <source>%1 message says that turn rates or accelerations are not measured (covariance -1), all the same they are there; they are taken.</source>
        <translation>%1 条消息声明未测量角速度或加速度（协方差为 -1），却含有其值；已采用。</translation>
    </message>
    <message>
        <source>%1 messages say that turn rates or accelerations are not measured (covariance -1), all the same they are there; they are taken.</source>
        <translation>%1 条消息声明未测量角速度或加速度（协方差为 -1），却含有其值；已采用。</translation>
    </message>
    <message>
        <source>%1 message has no turn rates: left out.</source>
        <translation>%1 条消息没有角速度，已略去。</translation>
    </message>
    <message>
        <source>%1 messages have no turn rates: left out.</source>
        <translation>%1 条消息没有角速度，已略去。</translation>
    </message>
    <message>
        <source>The status of the position falls from %1 to %2 in %3, %4 % of the drive: corrections (RTK) were lost.</source>
        <translation>位置的状态从 %1 降到 %2，共%3，占行程的 %4 %：差分改正（RTK）丢失。</translation>
    </message>
    <message>
        <source>holds no motion of an INS with attitude</source>
        <translation>不含带姿态的 INS 运动</translation>
    </message>
    <message>
        <source>holds neither scans nor LiDAR poses</source>
        <translation>既没有扫描也没有激光雷达位姿</translation>
    </message>
    <message>
        <source>%1; it can be calibrated with --method %2</source>
        <translation>%1；可用 --method %2 标定</translation>
    </message>
    <message>
        <source>%1; name a folder or a session.yaml that has it, too</source>
        <translation>%1；请指定也含有它的文件夹或 session.yaml</translation>
    </message>
    <message>
        <source>%1; name a folder or a session.yaml that has it, too, or choose --method slew for an excavator</source>
        <translation>%1；请指定也含有它的文件夹或 session.yaml；若为挖掘机，请选择 --method slew</translation>
    </message>
    <message>
        <source>%1 of %2 samples are degraded and %3 invalid by the INS&apos;s own status, in %4, the longest of %5 s.</source>
        <translation>%2 个样本中有 %1 个按 INS 自身的状态为降级，%3 个为无效，共%4，最长 %5 秒。</translation>
    </message>
    <message>
        <source>%1 stretch</source>
        <translation> %1 段</translation>
    </message>
    <message>
        <source>%1 stretches</source>
        <translation> %1 段</translation>
    </message>
    <message>
        <source>The position jumps once, by %1 m at %2.</source>
        <translation>位置跳变一次，在 %2 跳变 %1 m。</translation>
    </message>
    <message>
        <source>Nothing is missing but the index; yet a file that lacks its end was not copied whole.</source>
        <translation>缺的只是索引；但缺少结尾的文件没有完整复制。</translation>
    </message>
    <message>
        <source>Copy the bag again, whole; close the recorder before copying. mcap recover writes a new index.</source>
        <translation>请重新完整复制该 bag；复制前先关闭记录程序。mcap recover 可写出新的索引。</translation>
    </message>
    <message>
        <source>The stated error of the position grows from %1 m to %2 m in %3, %4 % of the drive: corrections (RTK) were lost.</source>
        <translation>位置的标称误差从 %1 m 增大到 %2 m，共%3，占行程的 %4 %：差分改正（RTK）丢失。</translation>
    </message>
    <message>
        <source>%1 gap, the longest %2 s; nothing is interpolated across them.</source>
        <translation>%1 处间断，最长 %2 秒；间断处不做插值。</translation>
    </message>
    <message>
        <source>%1 message has no fix and %2 no orientation beside: left out.</source>
        <translation>%1 条消息没有定位，%2 条旁边没有姿态；均已略去。</translation>
    </message>
    <message>
        <source>%1 messages have no fix and %2 no orientation beside: left out.</source>
        <translation>%1 条消息没有定位，%2 条旁边没有姿态；均已略去。</translation>
    </message>
    <message>
        <source>%1 sample lies more than 2 degrees of latitude or longitude from the rest: left out.</source>
        <translation>%1 个样本的经纬度与其余相差 2 度以上，已略去。</translation>
    </message>
    <message>
        <source>%1 samples lie more than 2 degrees of latitude or longitude from the rest: left out.</source>
        <translation>%1 个样本的经纬度与其余相差 2 度以上，已略去。</translation>
    </message>
    <message>
        <source>%1 entry has no possible time (expected nanoseconds since 1970): left out.</source>
        <translation>%1 条的时间不合理（应为自 1970 年起的纳秒数），已略去。</translation>
    </message>
    <message>
        <source>%1 entries have no possible time (expected nanoseconds since 1970): left out.</source>
        <translation>%1 条的时间不合理（应为自 1970 年起的纳秒数），已略去。</translation>
    </message>
    <message>
        <source>%1 entry repeats the stamp before it; the first of each is used.</source>
        <translation>%1 条与前一条时间戳相同；只用每组的第一条。</translation>
    </message>
    <message>
        <source>%1 entry goes back in time: left out. Check the clock of the recorder.</source>
        <translation>%1 条时间倒退，已略去。请检查记录设备的时钟。</translation>
    </message>
    <message>
        <source>%1 entries go back in time: left out. Check the clock of the recorder.</source>
        <translation>%1 条时间倒退，已略去。请检查记录设备的时钟。</translation>
    </message>
    <message>
        <source>holds neither an INS nor GNSS fixes to align the trajectory of the LiDAR with</source>
        <translation>既没有 INS 也没有 GNSS 定位，无法对齐激光雷达的轨迹</translation>
    </message>
    <message>
        <source>has no wheel speeds, by which the vehicle&apos;s frame is found</source>
        <translation>没有轮速，而车体坐标系由车轮确定</translation>
    </message>
    <message>
        <source>%1 track point has no height; it is taken to be zero.</source>
        <translation>%1 个轨迹点没有高度；按零处理。</translation>
    </message>
    <message>
        <source>Log PASHR as well, or use an INS; or give what you measured, or the height of the INS above ground.</source>
        <translation>请同时记录 PASHR，或使用 INS；或者给出测量值，或 INS 离地高度。</translation>
    </message>
    <message>
        <source>The recording was stopped, or copied, before it was complete.</source>
        <translation>录制在完成之前被停止，或在完成之前被复制。</translation>
    </message>
    <message>
        <source>Copy the log again, whole. What lies before the cut is used.</source>
        <translation>请重新完整复制日志。截断处之前的内容会被使用。</translation>
    </message>
    <message>
        <source>roll and pitch of the INS are assumed, not measured</source>
        <translation>INS 的横滚角和俯仰角是假定的，未经测量</translation>
    </message>
    <message>
        <source>The log has a heading and neither roll nor pitch: how the INS leans is assumed, and height, pitch and roll of the mounting hardly follow from it, if at all. Log roll and pitch as well, or give what you measured with --measured: z, pitch and roll, or the height of the INS above the ground.</source>
        <translation>日志有航向，但没有横滚和俯仰：INS 的倾斜是假定的，由此几乎或完全无法得知安装的高度、俯仰角和横滚角。请同时记录横滚和俯仰，或用 --measured 给出测量值：z、俯仰角和横滚角，或 INS 的离地高度。</translation>
    </message>
    <message>
        <source>the checksum of a %1 is missing, which the others have</source>
        <translation>一条 %1 语句缺少校验和，而其他同类语句都有</translation>
    </message>
    <message>
        <source>The log ends within a sentence, which is left out.</source>
        <translation>日志在一条语句中间结束，该语句未被采用。</translation>
    </message>
    <message>
        <source>holds no date that can be used: the sentences that tell it (RMC, ZDA) are damaged. First problem: %1</source>
        <translation>不含可用的日期：给出日期的语句（RMC、ZDA）已损坏。首个问题：%1</translation>
    </message>
    <message>
        <source>The log has a heading (HDT) and no roll and pitch: they are taken to be zero, with an error of 3 degrees (1 sigma) that lasts over the drive.</source>
        <translation>日志有航向（HDT），没有横滚和俯仰：二者按零处理，误差为 3 度（1 sigma），并在整个行驶过程中持续存在。</translation>
    </message>
    <message>
        <source>roll, pitch or yaw reaches %1, more than a turn in radians, which KITTI has. Convert the angles from degrees</source>
        <translation>横滚、俯仰或偏航达到 %1，超过以弧度计的一整圈，而 KITTI 使用弧度。请把角度从度换算为弧度</translation>
    </message>
    <message>
        <source>the antenna&apos;s lever arm alone</source>
        <translation>仅天线的杆臂</translation>
    </message>
    <message>
        <source>the antenna&apos;s place alone</source>
        <translation>仅天线的位置</translation>
    </message>
    <message>
        <source>if it is a recording of an excavator</source>
        <translation>若它是挖掘机的记录</translation>
    </message>
    <message>
        <source>The bag has no usable index (%1). It was read from the beginning: %2 messages were found; the last record is cut, %3 of its %4 bytes are there.</source>
        <translation>bag 没有可用的索引（%1）。已从头读取：找到 %2 条消息；最后一条记录被截断，其 %4 字节中只有 %3 字节。</translation>
    </message>
    <message>
        <source>The bag has no usable index (%1). It was read from the beginning: %2 messages were found; the last record is cut, %3 of its %4 bytes are there. First that cannot be read: %5.</source>
        <translation>bag 没有可用的索引（%1）。已从头读取：找到 %2 条消息；最后一条记录被截断，其 %4 字节中只有 %3 字节。首个无法读取的：%5。</translation>
    </message>
    <message>
        <source>The database is damaged: %1 messages were found, %2 belong to no topic. What lies behind the damage may be saved by the database&apos;s own tool: sqlite3 FILE .recover</source>
        <translation>数据库已损坏：找到 %1 条消息，%2 条不属于任何话题。损坏处之后的内容也许可以用数据库自带的工具挽救：sqlite3 FILE .recover</translation>
    </message>
    <message>
        <source>The database is damaged (%1): %2 messages were found, %3 belong to no topic. What lies behind the damage may be saved by the database&apos;s own tool: sqlite3 FILE .recover</source>
        <translation>数据库已损坏（%1）：找到 %2 条消息，%3 条不属于任何话题。损坏处之后的内容也许可以用数据库自带的工具挽救：sqlite3 FILE .recover</translation>
    </message>
    <message>
        <source>Nothing is known: hardly any pairs go together.</source>
        <translation>一无所知：几乎没有相互一致的点云对。</translation>
    </message>
    <message>
        <source>too few of the pairs go together</source>
        <translation>相互一致的点云对太少</translation>
    </message>
    <message>
        <source>the clocks are apart</source>
        <translation>时钟相差太远</translation>
    </message>
    <message>
        <source>the INS contradicts itself</source>
        <translation>INS 自相矛盾</translation>
    </message>
    <message>
        <source>Without a nominal mounting, what so few pairs agree on may be chance: give one (some 10 degrees are enough).</source>
        <translation>没有标称安装位姿时，这么少的点云对所一致之处可能只是巧合：请给出一个（精确到约 10 度即可）。</translation>
    </message>
    <message>
        <source>x, y and z count from where the positions are: that may be an antenna, and not the INS (see the findings).</source>
        <translation>x、y 和 z 从位置所在之处算起：那可能是天线，而不是 INS（见检查结果）。</translation>
    </message>
    <message>
        <source>Between the pairs of scans that were registered the LiDAR turned as the INS did %1 s later. %2</source>
        <translation>在已配准的点云对之间，激光雷达的转动与 INS 晚 %1 s 的转动一致。%2</translation>
    </message>
    <message>
        <source>Between the pairs of scans that were registered the LiDAR turned as the INS did %1 s earlier. %2</source>
        <translation>在已配准的点云对之间，激光雷达的转动与 INS 早 %1 s 的转动一致。%2</translation>
    </message>
    <message>
        <source>without a nominal yaw is open</source>
        <translation>没有名义安装，偏航未定</translation>
    </message>
    <message>
        <source>the sessions say different mountings</source>
        <translation>各次会话给出的安装不同</translation>
    </message>
    <message>
        <source>Without a nominal mounting nothing can be said while yaw is not observed (where roll is open, yaw turns with it): give one (some 10 degrees are enough), or drive longer, with turns to both sides.</source>
        <translation>没有名义安装，且偏航不可观测时（横滚未定时偏航随之转动），什么也不能断定：请给出名义安装（精度 10 度左右即可），或行驶更久并向两侧转弯。</translation>
    </message>
    <message>
        <source>aligned %1 m, %2 deg from where the INS was; does not determine %3</source>
        <translation>对齐位置偏离 INS 所示 %1 m、%2 度；不能确定 %3</translation>
    </message>
    <message>
        <source>LiDAR and INS contradict each other under every mounting: their motions differ by %1 m on ways of %2 m.</source>
        <translation>在任何安装下激光雷达与 INS 都互相矛盾：在 %2 m 的路程上，二者的运动相差 %1 m。</translation>
    </message>
    <message>
        <source>the motions of LiDAR and INS contradict each other</source>
        <translation>激光雷达与 INS 的运动互相矛盾</translation>
    </message>
    <message>
        <source>the distances of LiDAR and INS differ</source>
        <translation>激光雷达与 INS 的距离不一致</translation>
    </message>
    <message>
        <source>The LiDAR moves %1 times as far as the INS: one of them measures distances wrongly, which biases X; the sigmas include it. Correct the scale, or use the method trajectory, which estimates it.</source>
        <translation>激光雷达移动的距离是 INS 的 %1 倍：二者之一的距离测量有误，使 X 产生偏差；sigma 已计入。请修正尺度，或使用会估计尺度的 trajectory 方法。</translation>
    </message>
    <message>
        <source>The attitude jumps %1 times, the farthest by %2 degrees at %3.</source>
        <translation>姿态跳变 %1 次，最大的一次在 %3，跳变 %2 度。</translation>
    </message>
    <message>
        <source>The attitude jumps once, by %1 degrees at %2.</source>
        <translation>姿态跳变一次，在 %2 跳变 %1 度。</translation>
    </message>
    <message>
        <source>A pair across a jump tells of a turn that never was; it is rejected where that shows.</source>
        <translation>跨越跳变的扫描对所说明的转动从未发生；在能看出时它会被拒绝。</translation>
    </message>
    <message>
        <source>See whether the heading was aligned anew there or a sample is damaged; reject the pairs across it, or use a log that was processed afterwards (PPK).</source>
        <translation>请查看该处航向是否重新对准，或有样本损坏；拒绝跨越它的扫描对，或使用事后处理（PPK）的日志。</translation>
    </message>
    <message>
        <source>The heading alone stands still for %1 s at a time (%2 samples) and then jumps, by %3 degrees where the vehicle turns: it is logged more often than it is computed.</source>
        <translation>仅航向每次静止 %1 s（%2 个样本）后突然跳变，车辆转弯时跳变 %3 度：它的记录频率高于计算频率。</translation>
    </message>
    <message>
        <source>One number of the position, %1, stands still for %2 s at a time (%3 samples) and then jumps, by %4 m where the vehicle drives: it is logged more often than it is computed.</source>
        <translation>位置的一个分量（%1）每次静止 %2 s（%3 个样本）后突然跳变，车辆行驶时跳变 %4 m：它的记录频率高于计算频率。</translation>
    </message>
    <message>
        <source>latitude</source>
        <translation>纬度</translation>
    </message>
    <message>
        <source>longitude</source>
        <translation>经度</translation>
    </message>
    <message>
        <source>is a symbolic link that leads nowhere</source>
        <translation>是一个不指向任何文件的符号链接</translation>
    </message>
    <message>
        <source>%1 and %2 contradict each other: %3 differs by %4 %5, %6 times the sigma of both together. Either the LiDAR was moved in between, or one of them claims too much: look at its residuals, its clock and its nominal mounting.</source>
        <translation>%1与%2互相矛盾：%3相差 %4 %5，为两者合成标准差的 %6 倍。要么激光雷达在此期间被移动过，要么其中一个标称精度过高：请检查它的残差、时钟和名义安装。</translation>
    </message>
    <message>
        <source>Look at the clocks of LiDAR and INS, at the pairs and at the nominal mounting: they do not fit together.</source>
        <translation>请检查激光雷达与 INS 的时钟、扫描对和名义安装：它们彼此不相符。</translation>
    </message>
    <message>
        <source>The log ends within a line, which is left out.</source>
        <translation>日志在一行中间结束，该行未被采用。</translation>
    </message>
    <message>
        <source>%1 and %2 contradict each other: %3 differs by %4 %5, %6 times the sigma of both together. At least one of them claims too much; look at its residuals, its clock and its nominal mounting.</source>
        <translation>%1与%2互相矛盾：%3相差 %4 %5，为两者合成标准差的 %6 倍。其中至少有一个标称精度过高；请检查它的残差、时钟和名义安装。</translation>
    </message>
    <message>
        <source>Look at the clocks of LiDAR and INS and at the pairs: they do not fit together.</source>
        <translation>请检查激光雷达与 INS 的时钟以及扫描对：它们彼此不相符。</translation>
    </message>
    <message>
        <source>The static transforms are not used: INSPVAX has axes of its own (x right, y forward, z up), which no frame of ROS stands for. Give the nominal mounting yourself.</source>
        <translation>未使用静态变换：INSPVAX 有自己的坐标轴（x 向右、y 向前、z 向上），没有任何 ROS 坐标系与之对应。请自行给出标称安装。</translation>
    </message>
    <message>
        <source>At the spacing that is set, %1, the drive has %2 keyframes, fewer than keyframes.minimum: they were taken closer together, %3 in all. Lower keyframes.minimum to keep the spacing.</source>
        <translation>按所设的间隔 %1，该行程只有 %2 个关键帧，少于 keyframes.minimum：已加密选取，共 %3 个。若要保持间隔，请减小 keyframes.minimum。</translation>
    </message>
    <message>
        <source>Scans of a moving sensor are bent by the motion within a sweep, unless somebody has compensated them.</source>
        <translation>运动中的传感器，其扫描会因一圈之内的运动而变形，除非已经过补偿。</translation>
    </message>
    <message>
        <source>Record points with their times: set the driver to write them (in a field called time, t or timestamp). A calibration tries sweeps in both directions and takes what the scans prove; without proof the sigmas include the others, and no clock offset is estimated.</source>
        <translation>记录带时间的点：请设置驱动写出点时间（名为 time、t 或 timestamp 的字段）。标定会尝试两个旋转方向，采用扫描能证明的方式；不能证明时，标准差包含其他方式，且不估计时钟偏差。</translation>
    </message>
    <message>
        <source>How the scans are bent by motion is a guess.</source>
        <translation>扫描如何因运动而变形只是猜测。</translation>
    </message>
    <message>
        <source>Record points with their times, or declare in a native session how the sensor turns (timing: sweep).</source>
        <translation>请记录带时间的点，或在本软件格式的会话中声明传感器如何旋转（timing: sweep）。</translation>
    </message>
    <message>
        <source>The sensor turns the other way than those that the format was made for.</source>
        <translation>传感器的旋转方向与该格式原本所用的传感器相反。</translation>
    </message>
    <message>
        <source>Nothing, where the LiDAR is another one; otherwise check that axes of the points are right-handed.</source>
        <translation>若激光雷达是另一种型号，则无需处理；否则请检查点的坐标轴是否为右手系。</translation>
    </message>
    <message>
        <source>Scans and INS samples were taken out or renumbered apart from each other.</source>
        <translation>扫描与 INS 样本曾被分别删除或重新编号。</translation>
    </message>
    <message>
        <source>Nothing, where the stamps of both are right; otherwise copy the drive again, whole.</source>
        <translation>若二者的时间戳都正确，则无需处理；否则请重新完整复制该次行驶的数据。</translation>
    </message>
    <message>
        <source>Mend the file, or give the nominal mounting yourself.</source>
        <translation>请修复该文件，或自行给出标称安装。</translation>
    </message>
    <message>
        <source>A place on the vehicle is another number in another frame.</source>
        <translation>车上的同一位置在不同坐标系中数值不同。</translation>
    </message>
    <message>
        <source>Give the nominal mounting in the frame in which the method finds the sensor, or none.</source>
        <translation>请给出该方法所求坐标系中的名义安装位姿，或不给。</translation>
    </message>
    <message>
        <source>Points that are matched with points, or with cells, are off by more than their number says, the same way in every pair.</source>
        <translation>点对点或点对栅格配准的误差比点数所示的大，而且在每个帧对中方向相同。</translation>
    </message>
    <message>
        <source>Choose plane-to-plane or pcl-gicp where the sigma is to hold.</source>
        <translation>需要标准差可信时，请选择 plane-to-plane 或 pcl-gicp。</translation>
    </message>
    <message>
        <source>A tyre differs by a per cent or two: one of the two is not in metres.</source>
        <translation>轮胎只会相差百分之一二：两者之一的单位不是米。</translation>
    </message>
    <message>
        <source>Look at the wheel radius or the units of the wheel speeds, and at the units of the sensor&apos;s poses.</source>
        <translation>请检查车轮半径或轮速单位，以及传感器位姿的单位。</translation>
    </message>
    <message>
        <source>The format does not say how its scans are bent by motion; told by the scans themselves they are %1. That leaves %2 % less between scans than the next of what was tried.</source>
        <translation>该格式没有说明扫描如何因运动而变形；由扫描本身判断，它们按如下方式处理：%1。与试过的次优方式相比，扫描之间的残差少 %2 %。</translation>
    </message>
    <message>
        <source>The sensor turns clockwise, not as is usual in this format: the scans are %1. That leaves %2 % less between scans than the next of what was tried.</source>
        <translation>传感器顺时针旋转，与该格式的惯例不同：扫描按如下方式处理：%1。与试过的次优方式相比，扫描之间的残差少 %2 %。</translation>
    </message>
    <message>
        <source>The sensor turns counter-clockwise, not as is usual in this format: the scans are %1. That leaves %2 % less between scans than the next of what was tried.</source>
        <translation>传感器逆时针旋转，与该格式的惯例不同：扫描按如下方式处理：%1。与试过的次优方式相比，扫描之间的残差少 %2 %。</translation>
    </message>
    <message>
        <source>How the scans are bent by motion is not known, and they do not tell clearly: they are %1. The sigmas include what another way would make of the mounting; no clock offset is estimated.</source>
        <translation>扫描如何因运动而变形未知，扫描本身也不能明确说明：它们按如下方式处理：%1。标准差已包含其他方式对安装位姿的影响；不估计时钟偏差。</translation>
    </message>
    <message>
        <source>used as they are</source>
        <translation>按原样使用</translation>
    </message>
    <message>
        <source>compensated by the order of their points, over %1 s</source>
        <translation>按点的先后顺序补偿，一次扫描为 %1 s</translation>
    </message>
    <message>
        <source>compensated as turns of %1 s, clockwise</source>
        <translation>按顺时针旋转补偿，每圈 %1 s</translation>
    </message>
    <message>
        <source>compensated as turns of %1 s, counter-clockwise</source>
        <translation>按逆时针旋转补偿，每圈 %1 s</translation>
    </message>
    <message>
        <source>When the points were measured is not known: %1.</source>
        <translation>点的测量时刻未知：%1。</translation>
    </message>
    <message>
        <source>the points have no times (columns: %1)</source>
        <translation>点没有时间（列：%1）</translation>
    </message>
    <message>
        <source>the times of the points are all the same, or few for all points (columns: %1)</source>
        <translation>点的时间全都相同，或所有点只有少数几个时间（列：%1）</translation>
    </message>
    <message>
        <source>There are %1 stamps of scans and %2 of the INS: scans and INS samples of one number do not belong together, and go by their own stamps.</source>
        <translation>扫描有 %1 个时间戳，INS 有 %2 个：同一编号的扫描与 INS 样本并不对应，各按自己的时间戳使用。</translation>
    </message>
    <message>
        <source>The stamps of %1 of %2 scans are further than half a scan from those of the INS of their number: scans and INS samples of one number do not belong together, and go by their own stamps.</source>
        <translation>%2 个扫描中有 %1 个的时间戳与同编号 INS 的时间戳相差超过半个扫描周期：同一编号的扫描与 INS 样本并不对应，各按自己的时间戳使用。</translation>
    </message>
    <message>
        <source>How the scans are bent by motion is not known, which biases X; the sigmas include it. Record scans with the times of their points, or declare how they were swept.</source>
        <translation>扫描如何因运动而变形未知，这会使 X 产生偏差；标准差已包含这一点。请记录带有点时间的扫描，或声明扫描方式。</translation>
    </message>
    <message>
        <source>Nothing is known: how the scans are bent by motion makes more of a difference than X can bear.</source>
        <translation>什么都无法确定：扫描如何因运动而变形，对 X 的影响超出了可接受的范围。</translation>
    </message>
    <message>
        <source>%1: not known, how the scans are bent by motion is not known</source>
        <translation>%1：未知，扫描如何因运动而变形未知</translation>
    </message>
    <message>
        <source>trying how scans were swept</source>
        <translation>正在尝试扫描的旋转方式</translation>
    </message>
    <message>
        <source>The stamps are of another clock than the LiDAR&apos;s; by the recorder&apos;s clock they are %1 s apart, beside what a scan lasts. They are moved by that; what is left, the delays of the recording, shows as time offset.</source>
        <translation>这些时间戳来自与激光雷达不同的时钟；按录制端时钟，除一次扫描的时长外二者相差 %1 秒。已按此平移；剩余部分（录制延迟）表现为时钟偏差。</translation>
    </message>
    <message>
        <source>The stamps are of another clock than the LiDAR&apos;s; by the recorder&apos;s clock they are %1 s apart, beside what a scan lasts. They are moved by that; what is left, the delays of the recording, shows as time offset. %2</source>
        <translation>这些时间戳来自与激光雷达不同的时钟；按录制端时钟，除一次扫描的时长外二者相差 %1 秒。已按此平移；剩余部分（录制延迟）表现为时钟偏差。%2</translation>
    </message>
    <message>
        <source>The LiDAR&apos;s clock counts from when it was switched on, not from 1970.</source>
        <translation>激光雷达的时钟从上电开始计数，而不是从 1970 年。</translation>
    </message>
    <message>
        <source>That clock counts from when it was switched on, not from 1970.</source>
        <translation>该时钟从上电开始计数，而不是从 1970 年。</translation>
    </message>
    <message>
        <source>%1 entry repeats the stamp before it; the best of each is used.</source>
        <translation>%1 条记录重复了前一条的时间戳；每个时间戳取最好的一条。</translation>
    </message>
    <message>
        <source>%1 entries repeat the stamp before them; the best of each is used.</source>
        <translation>%1 条记录重复了前一条的时间戳；每个时间戳取最好的一条。</translation>
    </message>
    <message>
        <source>%1 fix lies more than 2 degrees of latitude or longitude from the rest: left out.</source>
        <translation>%1 个定位与其余相差超过 2 度的经度或纬度：已剔除。</translation>
    </message>
    <message>
        <source>%1 fixes lie more than 2 degrees of latitude or longitude from the rest: left out.</source>
        <translation>%1 个定位与其余相差超过 2 度的经度或纬度：已剔除。</translation>
    </message>
    <message>
        <source>%1 is &apos;%2&apos;, which stands for a value that was not known</source>
        <translation>%1 为“%2”，该数值表示当时没有有效值</translation>
    </message>
    <message>
        <source>roll, pitch or azimuth is a number that stands for a value that was not known</source>
        <translation>横滚、俯仰或方位角是一个表示“没有有效值”的数</translation>
    </message>
    <message>
        <source>roll, pitch or yaw is a number that stands for a value that was not known</source>
        <translation>横滚、俯仰或航向是一个表示“没有有效值”的数</translation>
    </message>
    <message>
        <source>%1 is a number that stands for a value that was not known</source>
        <translation>%1 是一个表示“没有有效值”的数</translation>
    </message>
    <message>
        <source>the receiver had no fix</source>
        <translation>接收机没有定位</translation>
    </message>
    <message>
        <source>The attitude is taken from %1, and the position with it; %2 other positions are not used.</source>
        <translation>姿态取自 %1，位置也随之取用；另有 %2 个位置未使用。</translation>
    </message>
    <message>
        <source>The attitude is taken from %1, and the position with it; %2 other positions are not used, nor the attitudes of %3.</source>
        <translation>姿态取自 %1，位置也随之取用；另有 %2 个位置以及 %3 的姿态未使用。</translation>
    </message>
    <message>
        <source>The log has the heading and pitch of two antennas (%1) and no roll: it is taken to be zero, with an error of 3 degrees (1 sigma) that lasts over the drive.</source>
        <translation>日志有双天线的航向和俯仰（%1），没有横滚：横滚按零处理，误差为 3 度（1 sigma），在整个行程中保持不变。</translation>
    </message>
    <message>
        <source>%1 status of the INS has the name of a status of a position (SINGULARITY for INS_SOLUTION_GOOD): ROS&apos; novatel_gps_driver took them from the wrong table before September 2026. They are read as what was meant.</source>
        <translation>%1 个 INS 状态用了定位状态的名称（以 SINGULARITY 代替 INS_SOLUTION_GOOD）：2026 年 9 月之前 ROS 的 novatel_gps_driver 查错了表。按其本意读取。</translation>
    </message>
    <message>
        <source>%1 statuses of the INS have the name of a status of a position (SINGULARITY for INS_SOLUTION_GOOD): ROS&apos; novatel_gps_driver took them from the wrong table before September 2026. They are read as what was meant.</source>
        <translation>%1 个 INS 状态用了定位状态的名称（以 SINGULARITY 代替 INS_SOLUTION_GOOD）：2026 年 9 月之前 ROS 的 novatel_gps_driver 查错了表。按其本意读取。</translation>
    </message>
    <message>
        <source>expected &apos;%1&lt;header&gt;;&lt;data&gt;*&lt;crc&gt;&apos;</source>
        <translation>应为“%1&lt;报头&gt;;&lt;数据&gt;*&lt;crc&gt;”</translation>
    </message>
    <message>
        <source>position and attitude of the INS itself, without errors</source>
        <translation>INS 自身的位置和姿态，不含误差</translation>
    </message>
    <message>
        <source>nobody fills in its orientation: it is all zero, or no number</source>
        <translation>没有填写姿态：全为零，或不是数</translation>
    </message>
    <message>
        <source>packets of the sensor, which its driver makes points of</source>
        <translation>传感器的数据包，由其驱动程序转换为点</translation>
    </message>
    <message>
        <source>holds the packets of a sensor as they came over the wire (%1), %2 messages. They are not read: the driver of the sensor makes points of them.</source>
        <translation>保存的是传感器经网络发来的数据包（%1），共 %2 条消息。不读取数据包：应由传感器的驱动程序转换为点。</translation>
    </message>
    <message>
        <source>Nobody fills in the orientation of this topic: it is all zero, or no number. It can be neither the INS nor the LiDAR.</source>
        <translation>该话题没有填写姿态：全为零，或不是数。它既不能作 INS，也不能作激光雷达。</translation>
    </message>
    <message>
        <source>The recording was interrupted, and its folder cannot be written, which the database needs to read what is in its log: a temporary copy is read.</source>
        <translation>录制曾被中断，而其文件夹不可写；数据库要读取日志中的内容必须能写入该文件夹：因此读取一份临时副本。</translation>
    </message>
    <message>
        <source>cannot be unpacked in %1: %2; set TMPDIR to a folder with more room, or %3</source>
        <translation>无法在 %1 中解包：%2；请将 TMPDIR 设为空间更大的文件夹，或%3</translation>
    </message>
    <message>
        <source>unpack it with &apos;zstd -d&apos;</source>
        <translation>用“zstd -d”解压</translation>
    </message>
    <message>
        <source>copy the bag to a folder that can be written</source>
        <translation>将数据包复制到可写的文件夹</translation>
    </message>
    <message>
        <source>only %1 are free</source>
        <translation>只剩 %1 可用</translation>
    </message>
    <message>
        <source>cannot be unpacked, there is no folder for temporary files: %1; set TMPDIR to one, or %2</source>
        <translation>无法解包，没有存放临时文件的文件夹：%1；请设置 TMPDIR，或%2</translation>
    </message>
    <message>
        <source>copying the bag, MB</source>
        <translation>正在复制数据包，MB</translation>
    </message>
    <message>
        <source>The orientation of this IMU is not measured. With one it would be the INS, to which fixes give the position.</source>
        <translation>该 IMU 没有测量姿态。如果有姿态，它就可以作 INS，由定位提供位置。</translation>
    </message>
    <message>
        <source>is no session that Remount knows: it is %1. %2 Remount looks for:%3</source>
        <translation>不是 Remount 认识的会话：这是%1。%2 Remount 寻找：%3</translation>
    </message>
    <message>
        <source>is no session that Remount knows. It holds %1 (%2). %3 Remount looks for:%4</source>
        <translation>不是 Remount 认识的会话。其中有%1（%2）。%3 Remount 寻找：%4</translation>
    </message>
    <message>
        <source>Fixes far from all others are glitches of the receiver, and left out.</source>
        <translation>与其余相距很远的定位是接收机的异常值，已剔除。</translation>
    </message>
    <message>
        <source>Of several sentences with an attitude one kind serves: mixed, they would be of different sensors.</source>
        <translation>多种语句都有姿态时只用一种：混用会把不同传感器的数据混在一起。</translation>
    </message>
    <message>
        <source>Nothing, where it is the right one; otherwise log that one alone.</source>
        <translation>如果选对了则无需处理；否则只记录所需的那一种。</translation>
    </message>
    <message>
        <source>Roll is a guess: of the mounting only yaw, and x and y, can be relied on.</source>
        <translation>横滚是假定的：安装参数中只有航向以及 x 和 y 可信。</translation>
    </message>
    <message>
        <source>Use an INS that measures roll; or give what you measured, or the height of the INS above ground.</source>
        <translation>使用能测量横滚的 INS；或给出实测值，或 INS 离地高度。</translation>
    </message>
    <message>
        <source>Were the names taken by their words, the INS would seem to be invalid throughout.</source>
        <translation>如果按字面理解这些名称，INS 会显得自始至终无效。</translation>
    </message>
    <message>
        <source>Update the driver before you record again; this recording is read as it was meant.</source>
        <translation>再次录制之前请更新驱动程序；本次录制按其本意读取。</translation>
    </message>
    <message>
        <source>Packets have no points that could be registered.</source>
        <translation>数据包中没有可用于配准的点。</translation>
    </message>
    <message>
        <source>Play the bag with the sensor&apos;s driver running, and record the points that it publishes.</source>
        <translation>在运行传感器驱动程序的同时回放数据包，并录制它发布的点。</translation>
    </message>
    <message>
        <source>Nothing of the topic that would be the INS can be used.</source>
        <translation>本应作为 INS 的话题没有任何可用内容。</translation>
    </message>
    <message>
        <source>See what the driver of the INS reports, or choose another topic as the INS.</source>
        <translation>查看 INS 驱动程序的输出，或选择另一个话题作为 INS。</translation>
    </message>
    <message>
        <source>What was recorded last lies in the database&apos;s log.</source>
        <translation>最后录制的内容在数据库的日志中。</translation>
    </message>
    <message>
        <source>Nothing, where there is room for the copy; closing the recorder properly saves it.</source>
        <translation>如果有足够空间存放副本则无需处理；正常关闭录制程序即可避免。</translation>
    </message>
    <message>
        <source>Of entries with one stamp only one is used: the best where they say how good they are, otherwise the first.</source>
        <translation>时间戳相同的记录只用一条：如果记录给出了质量，则取最好的一条，否则取第一条。</translation>
    </message>
    <message>
        <source>Turn fully to each side at least once: in a figure of eight with a vehicle, on the spot with a machine that slews.</source>
        <translation>向两侧各至少完整转一圈：车辆走 8 字形，回转机械原地回转。</translation>
    </message>
    <message>
        <source>Look at clock and attitude of the INS. Where the LiDAR gave poses instead of scans, look whether they are what they are taken for: of this drive, in metres, and from the LiDAR to the world.</source>
        <translation>请检查 INS 的时钟和姿态。如果激光雷达提供的是位姿而不是扫描，请检查位姿是否符合假定：属于本次行程，以米为单位，并且是从激光雷达到世界坐标系。</translation>
    </message>
    <message>
        <source>a capture of network packets (pcap)</source>
        <translation>网络数据包捕获文件（pcap）</translation>
    </message>
    <message>
        <source>Play it through the driver of the sensor, and record the points that it makes as a bag.</source>
        <translation>用传感器的驱动程序回放它，并把生成的点录制为数据包。</translation>
    </message>
    <message>
        <source>u-blox&apos;s binary log (UBX)</source>
        <translation>u-blox 的二进制日志（UBX）</translation>
    </message>
    <message>
        <source>Convert it to NMEA with sentences GGA, GST and RMC, as u-center does, or to GPX.</source>
        <translation>将其转换为含 GGA、GST 和 RMC 语句的 NMEA（u-center 可以转换），或转换为 GPX。</translation>
    </message>
    <message>
        <source>NovAtel&apos;s binary log</source>
        <translation>NovAtel 的二进制日志</translation>
    </message>
    <message>
        <source>Convert it to ASCII with NovAtel Convert: INSPVAXA at 10 Hz or more is read.</source>
        <translation>用 NovAtel Convert 转换为 ASCII：可读取 10 Hz 或更快的 INSPVAXA。</translation>
    </message>
    <message>
        <source>NovAtel&apos;s ASCII log without INSPVAXA or INSPVAA</source>
        <translation>没有 INSPVAXA 或 INSPVAA 的 NovAtel ASCII 日志</translation>
    </message>
    <message>
        <source>Log one of the two: they have position and attitude of the INS.</source>
        <translation>请记录两者之一：其中有 INS 的位置和姿态。</translation>
    </message>
    <message>
        <source>Septentrio&apos;s binary log (SBF)</source>
        <translation>Septentrio 的二进制日志（SBF）</translation>
    </message>
    <message>
        <source>Convert it to NMEA with sentences GGA, GST, RMC and PSSN,HRP, or its INS solution to a CSV, and name the columns in a session.yaml.</source>
        <translation>将其转换为含 GGA、GST、RMC 和 PSSN,HRP 语句的 NMEA，或将其 INS 解转换为 CSV，并在 session.yaml 中指明各列。</translation>
    </message>
    <message>
        <source>a trajectory of Applanix (SBET)</source>
        <translation>Applanix 的轨迹（SBET）</translation>
    </message>
    <message>
        <source>Export it as a CSV with time, latitude, longitude, height, roll, pitch and heading, and name the columns in a session.yaml.</source>
        <translation>将其导出为含时间、纬度、经度、高度、横滚、俯仰和航向的 CSV，并在 session.yaml 中指明各列。</translation>
    </message>
    <message>
        <source>the binary log of an OxTS INS (NCOM)</source>
        <translation>OxTS INS 的二进制日志（NCOM）</translation>
    </message>
    <message>
        <source>Export it as a CSV with NAVsolve, and name the columns in a session.yaml.</source>
        <translation>用 NAVsolve 导出为 CSV，并在 session.yaml 中指明各列。</translation>
    </message>
    <message>
        <source>the raw log of an Applanix POS</source>
        <translation>Applanix POS 的原始日志</translation>
    </message>
    <message>
        <source>Process it, export the trajectory as a CSV, and name the columns in a session.yaml.</source>
        <translation>请先解算，将轨迹导出为 CSV，并在 session.yaml 中指明各列。</translation>
    </message>
    <message>
        <source>GNSS observations (RINEX)</source>
        <translation>GNSS 观测数据（RINEX）</translation>
    </message>
    <message>
        <source>Process them to positions first: NMEA or GPX is read, or a CSV that a session.yaml names.</source>
        <translation>请先解算为位置：可读取 NMEA、GPX 或 session.yaml 指定的 CSV。</translation>
    </message>
    <message>
        <source>GNSS corrections (RTCM 3)</source>
        <translation>GNSS 改正数（RTCM 3）</translation>
    </message>
    <message>
        <source>Positions are needed: log NMEA of the receiver.</source>
        <translation>需要的是位置：请记录接收机的 NMEA。</translation>
    </message>
    <message>
        <source>poses of 12 numbers a line without times, as KITTI&apos;s odometry has them</source>
        <translation>每行 12 个数、没有时间的位姿（KITTI 里程计的格式）</translation>
    </message>
    <message>
        <source>Put the time of each scan before its pose, as in TUM&apos;s format: seconds, x y z, quaternion x y z w.</source>
        <translation>请在每个位姿前加上对应扫描的时间，例如 TUM 格式：秒、x y z、四元数 x y z w。</translation>
    </message>
    <message>
        <source>a compressed point cloud (LAZ)</source>
        <translation>压缩点云（LAZ）</translation>
    </message>
    <message>
        <source>Unpack it to LAS, as laszip does; scans belong into a folder, each with its time, which a session.yaml describes.</source>
        <translation>请解压为 LAS（laszip 可以解压）；扫描应放在一个文件夹中，各有其时间，由 session.yaml 描述。</translation>
    </message>
    <message>
        <source>a point cloud</source>
        <translation>点云</translation>
    </message>
    <message>
        <source>One cloud is no drive: scans belong into a folder, each with its time, which a session.yaml describes.</source>
        <translation>单个点云不是行程：扫描应放在一个文件夹中，各有其时间，由 session.yaml 描述。</translation>
    </message>
    <message>
        <source>point clouds of a scanner (E57)</source>
        <translation>扫描仪的点云（E57）</translation>
    </message>
    <message>
        <source>Export each scan as PCD, PLY or LAS, and give them their times in a session.yaml.</source>
        <translation>将每个扫描导出为 PCD、PLY 或 LAS，并在 session.yaml 中给出时间。</translation>
    </message>
    <message>
        <source>a recording of Livox Viewer (LVX)</source>
        <translation>Livox Viewer 的录制文件（LVX）</translation>
    </message>
    <message>
        <source>Convert it to a bag with Livox&apos;s ROS driver, which keeps the times of the points.</source>
        <translation>用 Livox 的 ROS 驱动程序转换为数据包，这样会保留点的时间。</translation>
    </message>
    <message>
        <source>a bag by its name that does not begin as one</source>
        <translation>按名称是数据包、开头却不是数据包的文件</translation>
    </message>
    <message>
        <source>It is damaged, or was not copied whole: copy it again from where it was recorded.</source>
        <translation>文件已损坏或未完整复制：请从录制处重新复制。</translation>
    </message>
    <message>
        <source>an SQLite database that is no bag by its name</source>
        <translation>按名称不是数据包的 SQLite 数据库</translation>
    </message>
    <message>
        <source>Where it is a bag of ROS 2, call it .db3.</source>
        <translation>如果它是 ROS 2 的数据包，请将扩展名改为 .db3。</translation>
    </message>
    <message>
        <source>an archive</source>
        <translation>压缩包</translation>
    </message>
    <message>
        <source>Unpack it, and open the folder that comes out.</source>
        <translation>请解压，然后打开得到的文件夹。</translation>
    </message>
    <message>
        <source>an HDF5 file</source>
        <translation>HDF5 文件</translation>
    </message>
    <message>
        <source>Export scans and poses from it to formats that are read.</source>
        <translation>请将其中的扫描和位姿导出为可读取的格式。</translation>
    </message>
    <message>
        <source>a drawing for maps (KML)</source>
        <translation>地图标绘文件（KML）</translation>
    </message>
    <message>
        <source>Export the track as GPX, with the times of its points.</source>
        <translation>请将轨迹导出为 GPX，并包含各点的时间。</translation>
    </message>
    <message>
        <source>%1 of %2 scans do not tell of every direction of the motion, nor does another sensor carry the odometry on; no pair spans them. Drive where there is more to see.</source>
        <translation>%2 帧扫描中有 %1 帧不能确定运动的所有方向，也没有其他传感器接续里程计；没有帧对跨越这些扫描。请在特征更多的地方行驶。</translation>
    </message>
    <message>
        <source>%1 of %2 scans do not tell of every direction of the motion: hardly any pair is left to compare with the INS.</source>
        <translation>%2 帧扫描中有 %1 帧不能确定运动的所有方向：几乎没有可与 INS 比较的帧对。</translation>
    </message>
    <message>
        <source>Nor do wheel speeds and gyroscope cover these scans: look at their stamps, or drive where there is more to see.</source>
        <translation>轮速和陀螺也没有覆盖这些扫描：请检查它们的时间戳，或在特征更多的地方行驶。</translation>
    </message>
    <message>
        <source>Give a nominal mounting and record wheel speeds and an IMU, which carry the odometry through such places; or drive where there is more to see.</source>
        <translation>请给出标称安装位姿，并记录轮速和 IMU，它们能使里程计通过这些路段；或在特征更多的地方行驶。</translation>
    </message>
    <message>
        <source>%1 of %2 scans do not tell of every direction of the motion; there it rests on wheels and gyroscope, and says nothing of the mounting.</source>
        <translation>%2 帧扫描中有 %1 帧不能确定运动的所有方向；这些方向由轮速和陀螺给出，不提供安装位姿的信息。</translation>
    </message>
    <message>
        <source>The way of the wheels is %1 times as long as that by the sensor&apos;s poses: one of the two is not in metres.</source>
        <translation>车轮走过的路程是传感器位姿所示路程的 %1 倍：两者之一的单位不是米。</translation>
    </message>
    <message>
        <source>The way by the sensor&apos;s poses is %1 times as long as that of the wheels: one of the two is not in metres.</source>
        <translation>传感器位姿所示路程是车轮走过的路程的 %1 倍：两者之一的单位不是米。</translation>
    </message>
    <message>
        <source>Look at the units of the wheel speeds and of the sensor&apos;s poses. Where the poses have no scale, as those of one camera, let it be estimated (vehicle_frame.scale).</source>
        <translation>请检查轮速和传感器位姿的单位。位姿没有尺度时（如单目相机），请选择估计尺度（vehicle_frame.scale）。</translation>
    </message>
    <message>
        <source>The way of the wheels and that of the sensor differ by %1%; the sensor&apos;s is taken for metres.</source>
        <translation>车轮与传感器的路程相差 %1%；以传感器的路程为米。</translation>
    </message>
    <message>
        <source>The way of the %1 is %2 times as long as that of the %3: poses of the LiDAR are not in metres, or are of another drive.</source>
        <translation>%1 的路程是 %3 的 %2 倍：激光雷达位姿的单位不是米，或来自另一次行驶。</translation>
    </message>
    <message>
        <source>Look at the units of the LiDAR&apos;s poses, and at how points of scans are scaled.</source>
        <translation>请检查激光雷达位姿的单位，以及扫描点坐标的缩放。</translation>
    </message>
    <message>
        <source>places %1 in %2, and the method &apos;%3&apos; finds %4 in %5: the numbers of one are wrong in the other. Give a nominal mounting in that frame, or none.</source>
        <translation>给出的是 %1 在 %2 中的位姿，而方法“%3”求的是 %4 在 %5 中的位姿：一个坐标系中的数值在另一个中是错的。请给出该坐标系中的名义安装位姿，或不给。</translation>
    </message>
    <message>
        <source>The nominal mounting of the session places %1 in %2, and the method &apos;%3&apos; finds %4 in %5: it is not used. Give a nominal mounting in that frame, or none.</source>
        <translation>数据中的名义安装位姿是 %1 在 %2 中的位姿，而方法“%3”求的是 %4 在 %5 中的位姿：未采用。请给出该坐标系中的名义安装位姿，或不给。</translation>
    </message>
    <message>
        <source>places %1 in %2, and %3 in %4 is asked for: the numbers of one are wrong in the other.</source>
        <translation>给出的是 %1 在 %2 中的位姿，而需要的是 %3 在 %4 中的位姿：一个坐标系中的数值在另一个中是错的。</translation>
    </message>
    <message>
        <source>the LiDAR</source>
        <translation>激光雷达</translation>
    </message>
    <message>
        <source>the antenna</source>
        <translation>天线</translation>
    </message>
    <message>
        <source>the sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>the INS frame</source>
        <translation>INS 坐标系</translation>
    </message>
    <message>
        <source>the vehicle&apos;s frame (middle of the rear axle, on the ground)</source>
        <translation>车体坐标系（后轴中点的地面投影）</translation>
    </message>
    <message>
        <source>the machine&apos;s frame (on the slew axis)</source>
        <translation>机体坐标系（回转轴上）</translation>
    </message>
    <message>
        <source>the LiDAR&apos;s own axes about the antenna</source>
        <translation>以天线为原点的激光雷达自身坐标轴</translation>
    </message>
    <message>
        <source>%1 is for comparison: errors may be several times the sigma that is stated.</source>
        <translation>%1 仅供比较：误差可能是所给标准差的数倍。</translation>
    </message>
    <message>
        <source>pitch centre ahead of the rear axle</source>
        <translation>俯仰中心在后轴之前的距离</translation>
    </message>
    <message>
        <source>How two scans are aligned: own plane-to-plane engine, or PCL&apos;s. With pcl-icp and pcl-ndt errors may be several times the sigma that is stated: for comparison only.</source>
        <translation>两帧扫描的配准方法：自有的面对面配准，或 PCL 的方法。用 pcl-icp 和 pcl-ndt 时误差可能是所给标准差的数倍：仅供比较。</translation>
    </message>
    <message>
        <source>x backward, y right, z up</source>
        <translation>x 向后，y 向右，z 向上</translation>
    </message>
    <message>
        <source>x left, y backward, z up</source>
        <translation>x 向左，y 向后，z 向上</translation>
    </message>
    <message>
        <source>By the direction of travel the axes of the INS are %1, not %2. The result is in the axes of the log, and is called by these.</source>
        <translation>由行驶方向判断，INS 的坐标轴为 %1，而非 %2。结果仍采用日志的坐标轴，并以前者命名。</translation>
    </message>
    <message>
        <source>By the direction of travel the axes of the INS are %1.</source>
        <translation>由行驶方向判断，INS 的坐标轴为 %1。</translation>
    </message>
    <message>
        <source>Exports that turn axes, and the obstacle check, go by what looks forward.</source>
        <translation>需要旋转坐标轴的导出以及障碍物检查，均以朝前的轴为准。</translation>
    </message>
    <message>
        <source>Nothing; where a robot moves sideways at will, mind that its axes are called otherwise.</source>
        <translation>无需处理；若机器人可任意横向移动，请注意其坐标轴的名称会不同。</translation>
    </message>
    <message>
        <source>Positions are of the UTM grid and attitudes relative to true north, which are %1 degrees apart there: attitudes were turned to the grid by that, and distances divided by the grid&apos;s scale.</source>
        <translation>位置为 UTM 网格坐标，姿态相对真北，两者在当地相差 %1 度：姿态已据此转到网格北，距离已除以网格比例。</translation>
    </message>
    <message>
        <source>Positions are of the UTM grid, and attitudes are taken to be relative to its north, too; distances were divided by the grid&apos;s scale.</source>
        <translation>位置为 UTM 网格坐标，姿态也视为相对网格北；距离已除以网格比例。</translation>
    </message>
    <message>
        <source>Which north the attitudes count from was judged by the direction of travel, and may be another: yaw is uncertain by %1 degrees, which its sigma includes.</source>
        <translation>姿态所参照的北向由行驶方向判断，也可能是另一个：偏航角因此有 %1 度的不确定度，已计入其 sigma。</translation>
    </message>
    <message>
        <source>Which north the attitudes count from, that of the grid or the true one, is not known: yaw is uncertain by %1 degrees, which its sigma includes.</source>
        <translation>姿态参照的是网格北还是真北，无从得知：偏航角因此有 %1 度的不确定度，已计入其 sigma。</translation>
    </message>
    <message>
        <source>The heading of the INS keeps %1 degrees from the direction of travel. Either the INS is turned so in the vehicle, or positions are of a grid (UTM) and attitudes relative to true north, which the data do not tell: yaw is uncertain by %2 degrees, which its sigma includes.</source>
        <translation>INS 的航向与行驶方向始终相差 %1 度。或者 INS 在车上就是这样转着安装的，或者位置为网格坐标（UTM）而姿态相对真北，数据无法区分：偏航角因此有 %2 度的不确定度，已计入其 sigma。</translation>
    </message>
    <message>
        <source>positions and attitudes of the INS may count from different norths</source>
        <translation>INS 的位置与姿态可能参照不同的北向</translation>
    </message>
    <message>
        <source>Without that, yaw of X would be off by the grid&apos;s convergence without a sign of it.</source>
        <translation>否则 X 的偏航角会偏差一个网格收敛角，且毫无迹象。</translation>
    </message>
    <message>
        <source>Give latitude and longitude where you have them, as a NavSatFix or in a session.yaml.</source>
        <translation>如有经纬度，请以 NavSatFix 或在 session.yaml 中给出。</translation>
    </message>
    <message>
        <source>Distances of the grid are up to a thousandth too long or too short.</source>
        <translation>网格距离会偏长或偏短达千分之一。</translation>
    </message>
    <message>
        <source>Give latitude and longitude where you have them.</source>
        <translation>如有经纬度，请给出。</translation>
    </message>
    <message>
        <source>Positions and attitudes that count from different norths turn X about the vertical.</source>
        <translation>位置与姿态参照不同的北向，会使 X 绕竖直轴旋转。</translation>
    </message>
    <message>
        <source>Record the fixes of the same drive, too, or give latitude and longitude with attitudes to true north.</source>
        <translation>同时记录同一次行驶的定位点，或给出经纬度与相对真北的姿态。</translation>
    </message>
    <message>
        <source>%1 sample is beyond anything that a vehicle reaches (positions beyond 1e9 m, or 250 km from the rest): left out.</source>
        <translation>%1 个样本超出车辆所能到达的范围（位置超过 1e9 m，或距其余样本 250 km 以上）：已略去。</translation>
    </message>
    <message>
        <source>%1 samples are beyond anything that a vehicle reaches (positions beyond 1e9 m, or 250 km from the rest): left out.</source>
        <translation>%1 个样本超出车辆所能到达的范围（位置超过 1e9 m，或距其余样本 250 km 以上）：已略去。</translation>
    </message>
    <message>
        <source>Glitches of a filter or of its log; what lies between them is used.</source>
        <translation>滤波器或其日志的毛刺；其间的数据照常使用。</translation>
    </message>
    <message>
        <source>Look at the source of the stream where they are many.</source>
        <translation>若数量较多，请检查该数据流的来源。</translation>
    </message>
    <message>
        <source>no position of the %1 lies on the earth (all are beyond 1e9 m, or hundreds of kilometres apart): look what is logged for a position, and in which unit</source>
        <translation>%1 没有任何位置在地球上（全部超过 1e9 m，或彼此相距数百公里）：请检查日志中作为位置的是什么、采用何种单位</translation>
    </message>
    <message>
        <source>no position of the INS lies on the earth</source>
        <translation>INS 没有任何位置在地球上</translation>
    </message>
    <message>
        <source>the position is beyond 1e9 m</source>
        <translation>位置超过 1e9 m</translation>
    </message>
    <message>
        <source>%1 moves by more than 1e9 m: is it in metres?</source>
        <translation>%1 的移动超过 1e9 m：其单位是米吗？</translation>
    </message>
    <message>
        <source>the two scans are expected to lie farther apart than any LiDAR sees</source>
        <translation>预计两帧扫描的距离超出任何激光雷达的视野</translation>
    </message>
    <message>
        <source>no vehicle moves so far</source>
        <translation>没有车辆会移动这么远</translation>
    </message>
    <message>
        <source>the positions of the INS look like earth-centred coordinates (ECEF), x, y and z from the middle of the earth: convert them to metres east, north and up of the start, or give latitude and longitude in a session.yaml</source>
        <translation>INS 的位置看起来是地心坐标（ECEF），即以地心为原点的 x、y、z：请换算为相对起点的东、北、天方向的米数，或在 session.yaml 中给出经纬度</translation>
    </message>
    <message>
        <source>the positions of the INS look like degrees, latitude and longitude where x and y in metres are expected: convert them to metres, or declare them as latitude and longitude in a session.yaml</source>
        <translation>INS 的位置看起来是度，即经纬度，而此处应为以米计的 x 和 y：请换算为米，或在 session.yaml 中声明为纬度和经度</translation>
    </message>
    <message>
        <source>the positions of the INS look like radians, latitude and longitude where x and y in metres are expected: convert them to metres, or declare them as latitude and longitude in a session.yaml</source>
        <translation>INS 的位置看起来是弧度，即经纬度，而此处应为以米计的 x 和 y：请换算为米，或在 session.yaml 中声明为纬度和经度</translation>
    </message>
    <message>
        <source>By their size the times are taken to be milliseconds.</source>
        <translation>按其大小，时间视为毫秒。</translation>
    </message>
    <message>
        <source>By their size the times are taken to be microseconds.</source>
        <translation>按其大小，时间视为微秒。</translation>
    </message>
    <message>
        <source>By their size the times are taken to be nanoseconds.</source>
        <translation>按其大小，时间视为纳秒。</translation>
    </message>
    <message>
        <source>Stamps in another unit would be none at all.</source>
        <translation>若按其他单位，时间戳将毫无意义。</translation>
    </message>
    <message>
        <source>Name the unit in the first line, as in &quot;# timestamp [ns] tx ty tz qx qy qz qw&quot;.</source>
        <translation>请在首行注明单位，例如 &quot;# timestamp [ns] tx ty tz qx qy qz qw&quot;。</translation>
    </message>
    <message>
        <source>the unit of its times cannot be told by their size: name it in a first line, as in &apos;# timestamp [ns] tx ty tz qx qy qz qw&apos;</source>
        <translation>无法由大小判断其时间的单位：请在首行注明，例如 &apos;# timestamp [ns] tx ty tz qx qy qz qw&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no time in milliseconds</source>
        <translation>“%1”不是以毫秒计的时间</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no time in microseconds</source>
        <translation>“%1”不是以微秒计的时间</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no time in nanoseconds</source>
        <translation>“%1”不是以纳秒计的时间</translation>
    </message>
    <message>
        <source>The stamps are %1 weeks before those they belong to: the week number of GPS begins anew every 1024 weeks, and a receiver with old firmware takes one turn for another. They were moved by that.</source>
        <translation>时间戳比其应属的时间早 %1 周：GPS 周数每 1024 周重新计数，固件过旧的接收机会把一轮当作另一轮。已按此移动。</translation>
    </message>
    <message>
        <source>The stamps are %1 weeks after those they belong to: the week number of GPS begins anew every 1024 weeks, and a receiver with old firmware takes one turn for another. They were moved by that.</source>
        <translation>时间戳比其应属的时间晚 %1 周：GPS 周数每 1024 周重新计数，固件过旧的接收机会把一轮当作另一轮。已按此移动。</translation>
    </message>
    <message>
        <source>The receiver counts a wrong number of weeks; that is mended, and nothing is lost by it.</source>
        <translation>接收机的周数有误；已修正，没有损失。</translation>
    </message>
    <message>
        <source>Update the firmware of the receiver: other programs take its stamps as they are.</source>
        <translation>请更新接收机固件：其他程序会原样采用其时间戳。</translation>
    </message>
    <message>
        <source>per-point is declared, but %1 in %2. Columns of times that are known: %3, also behind scalar_. Or declare timing: sweep for a sensor that spins, instant for scans that are compensated, unknown otherwise</source>
        <translation>声明了 per-point，但 %2 中%1。可识别的时间列：%3，带 scalar_ 前缀者亦可。或改为声明 timing：旋转式传感器用 sweep，已补偿的扫描用 instant，其他情况用 unknown</translation>
    </message>
    <message>
        <source>its points have no times, or all the same, while those of other scans have: it would be used as if it had been measured at once</source>
        <translation>其各点没有时间或时间全部相同，而其他扫描有：它会被当作在同一时刻测得</translation>
    </message>
    <message>
        <source>%1 gps_time (one value for all points)</source>
        <translation>%1 gps_time（所有点取同一值）</translation>
    </message>
    <message>
        <source>x y z reflectance and one more</source>
        <translation>x y z reflectance 及另一列</translation>
    </message>
    <message>
        <source>x y z reflectance and two more</source>
        <translation>x y z reflectance 及另两列</translation>
    </message>
    <message>
        <source>is LAS %1, expected 1.0 to 1.4</source>
        <translation>是 LAS %1，应为 1.0 至 1.4</translation>
    </message>
    <message>
        <source>expected 32-bit floats, 3 to 6 a point: x, y, z, then reflectance (KITTI), ring (nuScenes) and one more</source>
        <translation>应为 32 位浮点数，每点 3 至 6 个：x、y、z，然后是反射率（KITTI）、线号（nuScenes）及另一个</translation>
    </message>
    <message>
        <source>looks like NCLT&apos;s records of 8 bytes (16-bit coordinates, intensity, laser), %1. Convert the scans, to PCD for instance</source>
        <translation>看起来是 NCLT 的 8 字节记录（16 位坐标、强度、激光号），%1。请转换扫描，例如转为 PCD</translation>
    </message>
    <message>
        <source>holds %1 bytes that are no points, %2. Convert the scans to one of these, or to PCD, whose header says what is in it</source>
        <translation>含有 %1 字节，不成整数个点，%2。请将扫描转换为其中之一，或转换为 PCD，其文件头会说明内容</translation>
    </message>
    <message>
        <source>The mounting still changed when the odometry was repeated with it; its sigmas contain the last change.</source>
        <translation>用求得的安装位姿重算里程计后，安装位姿仍有变化；标准差已包含最后一次变化。</translation>
    </message>
    <message>
        <source>the sensor&apos;s poses and the wheels are of different scales</source>
        <translation>传感器位姿与车轮的尺度不同</translation>
    </message>
    <message>
        <source>The odometry was made with another mounting than the one it leads to.</source>
        <translation>里程计所用的安装位姿与由它求得的不同。</translation>
    </message>
    <message>
        <source>Give a better nominal, or drive where there is more to see.</source>
        <translation>请给出更好的标称值，或在特征更多的地方行驶。</translation>
    </message>
    <message>
        <source>The lidar&apos;s stamps are early by %1 ms (sigma %2 ms) against the INS. X is solved with that taken out.</source>
        <translation>激光雷达的时间戳比 INS 早 %1 毫秒（标准差 %2 毫秒）。求解 X 时已扣除该偏差。</translation>
    </message>
    <message>
        <source>The lidar&apos;s stamps are late by %1 ms (sigma %2 ms) against the INS. X is solved with that taken out.</source>
        <translation>激光雷达的时间戳比 INS 晚 %1 毫秒（标准差 %2 毫秒）。求解 X 时已扣除该偏差。</translation>
    </message>
    <message>
        <source>Solve X with the clock offset between lidar and INS that the drive shows: where it is clear (auto), always (yes), never (no).</source>
        <translation>按行驶数据显示的激光雷达与 INS 时钟偏差求解 X：明确时才用（auto）、总是（yes）、从不（no）。</translation>
    </message>
    <message>
        <source>%1: not known, it still changes when the odometry is repeated with it</source>
        <translation>%1：未知，用它重新推算里程计时它仍在变化</translation>
    </message>
    <message>
        <source>Nothing is known: the mounting changes whenever the odometry is repeated with it.</source>
        <translation>一无所知：每次用它重新推算里程计，安装位置都会变化。</translation>
    </message>
    <message>
        <source>The attitude is taken from %1, and the position with it; %2 other position is not used.</source>
        <translation>姿态取自 %1，位置也随之取用；另有 %2 个位置未使用。</translation>
    </message>
    <message>
        <source>The attitude is taken from %1, and the position with it; %2 other position is not used, nor the attitudes of %3.</source>
        <translation>姿态取自 %1，位置也随之取用；另有 %2 个位置以及 %3 的姿态未使用。</translation>
    </message>
    <message>
        <source>The attitude is taken from %1; the attitudes of %2 are not used.</source>
        <translation>姿态取自 %1；%2 的姿态未使用。</translation>
    </message>
    <message>
        <source>By the fixes, positions are of a grid whose north is %1 degrees from the true one, to which attitudes are relative: they were turned to the grid by that.</source>
        <translation>由定位点判断，位置为网格坐标，其网格北与真北相差 %1 度，而姿态相对真北：姿态已按此转到网格。</translation>
    </message>
    <message>
        <source>Positions have the numbers of a grid that need not be UTM, and are left as they are. Which north the attitudes count from, that of the grid or the true one, is not known: yaw is uncertain by %1 degrees, which its sigma includes.</source>
        <translation>位置的数值属于某种网格坐标，但未必是 UTM，因此保持不变。姿态参照的是网格北还是真北，无从得知：偏航角因此有 %1 度的不确定度，已计入其 sigma。</translation>
    </message>
    <message>
        <source>%1 sample is beyond anything that a vehicle reaches (no latitude, longitude and height on the earth): left out.</source>
        <translation>%1 个样本超出车辆所能到达的范围（纬度、经度和高度不在地球上）：已略去。</translation>
    </message>
    <message>
        <source>%1 samples are beyond anything that a vehicle reaches (no latitude, longitude and height on the earth): left out.</source>
        <translation>%1 个样本超出车辆所能到达的范围（纬度、经度和高度不在地球上）：已略去。</translation>
    </message>
    <message>
        <source>%1 sample is beyond anything that a vehicle reaches (values beyond a million, or none at all): left out.</source>
        <translation>%1 个样本超出车辆所能达到的范围（数值超过一百万，或根本不是数值）：已略去。</translation>
    </message>
    <message>
        <source>%1 samples are beyond anything that a vehicle reaches (values beyond a million, or none at all): left out.</source>
        <translation>%1 个样本超出车辆所能达到的范围（数值超过一百万，或根本不是数值）：已略去。</translation>
    </message>
    <message>
        <source>per-point is declared, but %1 in %2. Columns of times that are known: %3, also behind scalar_. Or declare timing: sweep for a sensor that spins, instant for scans that are compensated, unknown otherwise. Besides, the stamps of %4 are turns of the GPS week (1024 weeks each) off, which is mended once the session can be read</source>
        <translation>声明了 per-point，但 %2 中%1。可识别的时间列：%3，带 scalar_ 前缀者亦可。或改为声明 timing：旋转式传感器用 sweep，已补偿的扫描用 instant，其他情况用 unknown。此外，%4 的时间戳相差整数个 GPS 周轮回（每个 1024 周），会话可以读取后会自动修正</translation>
    </message>
    <message>
        <source>The poses contradict the travel of the vehicle: their inverses follow it.</source>
        <translation>位姿与车辆的行驶相矛盾：取逆后才与之相符。</translation>
    </message>
    <message>
        <source>the poses are inverted</source>
        <translation>位姿是反的</translation>
    </message>
    <message>
        <source>Before anything else invert the poses that the findings name: they are from the world to the body, expected from the body to the world.</source>
        <translation>首先请将检查结果所指的位姿取逆：它们是由世界到本体，应为由本体到世界。</translation>
    </message>
    <message>
        <source>Times that are of another unit, or shares of a turn, bend the scans instead of mending them; they count as scans whose times are not known.</source>
        <translation>单位不对或只是一圈的占比的时间会使扫描变形而非校正；这些扫描按时间未知处理。</translation>
    </message>
    <message>
        <source>Have the driver write the times of points in seconds, or name the unit in the column (time_ms, time_us, time_ns).</source>
        <translation>让驱动以秒写入点的时间，或在列名中注明单位（time_ms、time_us、time_ns）。</translation>
    </message>
    <message>
        <source>Taken forwards, such times bend the scans twice.</source>
        <translation>若按正向使用，这样的时间会使扫描加倍变形。</translation>
    </message>
    <message>
        <source>Have the driver write the times of points from the stamp on.</source>
        <translation>让驱动写入从时间戳起算的点时间。</translation>
    </message>
    <message>
        <source>The poses of the INS seem to be inverted, from the world to the body: as they are they keep to no axis of a vehicle that travels, their inverses do. Invert each of them (rotation R transposed, position -R transposed times p).</source>
        <translation>INS 的位姿似乎是反的（由世界到本体）：按现状，行驶的车辆不沿其任何一个轴运动，而取逆后则沿一个轴运动。请逐个取逆（旋转 R 转置，位置 -R 转置乘 p）。</translation>
    </message>
    <message>
        <source>The poses of the LiDAR seem to be inverted, from the world to the body: as they are they keep to no axis of a vehicle that travels, their inverses do. Invert each of them (rotation R transposed, position -R transposed times p).</source>
        <translation>激光雷达的位姿似乎是反的（由世界到本体）：按现状，行驶的车辆不沿其任何一个轴运动，而取逆后则沿一个轴运动。请逐个取逆（旋转 R 转置，位置 -R 转置乘 p）。</translation>
    </message>
    <message>
        <source>The inverse of a motion is another motion, about another place; no result stands on it.</source>
        <translation>运动的逆是绕另一处的另一种运动；任何结果都不成立。</translation>
    </message>
    <message>
        <source>Export the poses as those of the body in the world, or invert each of them; check those of the other sensor as well.</source>
        <translation>请导出本体在世界中的位姿，或逐个取逆；另一传感器的位姿也请检查。</translation>
    </message>
    <message>
        <source>Exports that turn axes cannot know what the axes of the INS are.</source>
        <translation>需要转换坐标轴的导出无法得知 INS 的轴向。</translation>
    </message>
    <message>
        <source>Nothing, where the INS has z down; otherwise check the convention of the attitude (ENU or NED).</source>
        <translation>若 INS 的 z 轴本来朝下则无需处理；否则请检查姿态约定（ENU 或 NED）。</translation>
    </message>
    <message>
        <source>Look at the clock offset of the result; where it has none, record a drive with several turns, on one clock.</source>
        <translation>请查看结果中的时钟偏移；若没有，请在同一时钟下录制包含多次转弯的行程。</translation>
    </message>
    <message>
        <source>The z axis of the INS points down, as in axes x forward, y right, z down. The result is in the axes of the log; they are not called by a name, and an export that would turn them is refused.</source>
        <translation>INS 的 z 轴朝下，如 x 前、y 右、z 下。结果采用日志自身的轴；这些轴不予命名，需要转换它们的导出会被拒绝。</translation>
    </message>
    <message>
        <source>The times of the points are of no sweep and are not used: %1.</source>
        <translation>点的时间不可能属于一次扫描，未予使用：%1。</translation>
    </message>
    <message>
        <source>column %1 spans %2 s in a scan, while scans are %3 s apart</source>
        <translation>列 %1 在一帧内跨度为 %2 s，而相邻帧间隔为 %3 s</translation>
    </message>
    <message>
        <source>column %1 comes in steps of %2 s: 32-bit floats cannot hold seconds of the day or the week</source>
        <translation>列 %1 的步长为 %2 s：32 位浮点数无法表示当日秒或周内秒</translation>
    </message>
    <message>
        <source>compensated by the times of their points, counted backwards</source>
        <translation>按点的时间（倒计）补偿</translation>
    </message>
    <message>
        <source>compensated by the times of their points as they are</source>
        <translation>按点的时间原样补偿</translation>
    </message>
    <message>
        <source>The times of the points count backwards, as the time since a point was measured does; told by the scans themselves. They are taken so. That leaves %1 % less between scans than the next of what was tried.</source>
        <translation>点的时间是倒计的（即点测得后经过的时间）；由扫描本身判定，并按此使用。与所尝试的次优方式相比，帧间残差减少 %1 %。</translation>
    </message>
    <message>
        <source>Rates of rotation alone do not tell by how much the clocks of the LiDAR poses and the INS differ: %1. The stamps stay as they are; a small offset is estimated with the mounting.</source>
        <translation>仅凭转动速率无法判定激光雷达位姿与 INS 的时钟相差多少：%1。时间戳保持不变；较小的偏移将与安装参数一同估计。</translation>
    </message>
    <message>
        <source>its columns are separated by semicolons, expected commas</source>
        <translation>各列以分号分隔，应为逗号</translation>
    </message>
    <message>
        <source>its columns are separated by tabs, expected commas</source>
        <translation>各列以制表符分隔，应为逗号</translation>
    </message>
    <message>
        <source>The way of the %1 is %2 times as long as that of the %3: the odometry over the scans slipped, or one of the two is not in metres.</source>
        <translation>%1 走过的路程是 %3 的 %2 倍：由扫描推算的里程计打滑了，或者两者之一的单位不是米。</translation>
    </message>
    <message>
        <source>Look at the units of the positions and of the points of the scans. Where these are metres, the surroundings hold no scan along the way: record where there is structure, or use another method.</source>
        <translation>请检查位置和扫描点的单位。如果都是米，则周围环境沿行进方向无法固定扫描：请在有结构物的地方采集，或改用其他方法。</translation>
    </message>
    <message>
        <source>The lidar&apos;s stamps are early by %1 ms (sigma %2 ms) against the INS. X is biased by it while the vehicle turns: set solve.apply_time_offset to auto or yes to correct it.</source>
        <translation>激光雷达的时间戳比 INS 早 %1 毫秒（标准差 %2 毫秒）。车辆转弯时 X 因此有偏：将 solve.apply_time_offset 设为 auto 或 yes 即可修正。</translation>
    </message>
    <message>
        <source>The lidar&apos;s stamps are late by %1 ms (sigma %2 ms) against the INS. X is biased by it while the vehicle turns: set solve.apply_time_offset to auto or yes to correct it.</source>
        <translation>激光雷达的时间戳比 INS 晚 %1 毫秒（标准差 %2 毫秒）。车辆转弯时 X 因此有偏：将 solve.apply_time_offset 设为 auto 或 yes 即可修正。</translation>
    </message>
    <message>
        <source>The clocks of lidar and INS differ, which biases X; the sigmas include it. Set solve.apply_time_offset to auto or yes: X is then no longer biased.</source>
        <translation>激光雷达与 INS 的时钟不一致，X 因此有偏，标准差已包含该影响。将 solve.apply_time_offset 设为 auto 或 yes，X 便不再有偏。</translation>
    </message>
    <message>
        <source>clock offset INS - LiDAR: %1 ms (sigma %2 ms), %3</source>
        <translation>时钟偏差 INS − 激光雷达：%1 毫秒（标准差 %2 毫秒），%3</translation>
    </message>
    <message>
        <source>clock offset INS - LiDAR, mean of the sessions: %1 ms (sigma %2 ms), %3</source>
        <translation>时钟偏差 INS − 激光雷达，各会话平均：%1 毫秒（标准差 %2 毫秒），%3</translation>
    </message>
    <message>
        <source>clock offset of session %1: %2 ms (sigma %3 ms)</source>
        <translation>会话 %1 的时钟偏差：%2 毫秒（标准差 %3 毫秒）</translation>
    </message>
    <message>
        <source>applied</source>
        <translation>已应用</translation>
    </message>
    <message>
        <source>an unknown of X, in its sigmas</source>
        <translation>作为未知量一并求解，已计入标准差</translation>
    </message>
    <message>
        <source>not applied</source>
        <translation>未应用</translation>
    </message>
    <message>
        <source>The motions of the LiDAR are %1 times as long as those of the INS: one of the two is not in metres.</source>
        <translation>LiDAR 的运动长度是 INS 的 %1 倍：两者之一的单位不是米。</translation>
    </message>
    <message>
        <source>The motions of the INS are %1 times as long as those of the LiDAR: one of the two is not in metres.</source>
        <translation>INS 的运动长度是 LiDAR 的 %1 倍：两者之一的单位不是米。</translation>
    </message>
    <message>
        <source>LiDAR and INS are of different scales</source>
        <translation>LiDAR 与 INS 的尺度不同</translation>
    </message>
    <message>
        <source>Look at the units of the LiDAR&apos;s poses, or of the points of its scans, and of the INS&apos;s positions: centimetres for metres are 100 times as long, millimetres 1000 times, feet 3.28 times.</source>
        <translation>请检查 LiDAR 位姿（或其点云中的点）和 INS 位置的单位：把厘米当作米会长 100 倍，毫米长 1000 倍，英尺长 3.28 倍。</translation>
    </message>
    <message>
        <source>%1 pairs hardly show how large their own errors are: sigma is %2 times as large for that. More pairs make it smaller.</source>
        <translation>%1 个帧对几乎显示不出自身误差有多大：sigma 因此放大为 %2 倍。帧对越多，sigma 越小。</translation>
    </message>
    <message>
        <source>The position stands still for %1 s at a time (%2 samples) and then jumps, by %3 m where the vehicle drives. Only the first of each is used; positions between these are interpolated.</source>
        <translation>位置每次静止 %1 s（%2 个样本）后突然跳变，车辆行驶时跳变 %3 m。只采用每个位置的第一个样本；其间的位置由插值得到。</translation>
    </message>
    <message>
        <source>Position and attitude stand still for %1 s at a time (%2 samples) and then jump, by %3 m where the vehicle drives. Only the first sample of each is used; the motion between these is interpolated.</source>
        <translation>位置和姿态每次静止 %1 s（%2 个样本）后突然跳变，车辆行驶时跳变 %3 m。只采用每次的第一个样本；其间的运动由插值得到。</translation>
    </message>
    <message>
        <source>Repeats of a position are no measurements. Between those that were measured the way is interpolated, which is right where each is logged as soon as it is computed.</source>
        <translation>重复的位置不是测量值。在测得的位置之间对路径进行插值；只要每个位置一经计算就被记录，这样做就是正确的。</translation>
    </message>
    <message>
        <source>Log the position as it is computed, with all digits. Where each comes later than its stamp says, take the delay out of the stamps.</source>
        <translation>请按计算频率记录位置，并保留全部位数。如果位置晚于其时间戳，请从时间戳中扣除该延迟。</translation>
    </message>
    <message>
        <source>%1 of %2 scans of the turn could not be aligned with the first one: what is left covers an arc of %3 deg, and at least %4 deg are needed.</source>
        <translation>回转段的 %2 帧扫描中有 %1 帧无法与第一帧配准：剩余部分只覆盖 %3 度的弧，而至少需要 %4 度。</translation>
    </message>
    <message>
        <source>Turn more slowly, where the LiDAR sees walls or objects all around, so that every scan overlaps the first one.</source>
        <translation>请放慢回转，并选择激光雷达四周都能看到墙面或物体的地点，使每帧扫描都与第一帧有重叠。</translation>
    </message>
    <message>
        <source>The ground leans by %1 deg (sigma %2) against the plane in which the LiDAR turned. Pitch, roll and z may be off by that much, and their sigma allows for it. Repeat on level, even ground, or take the plane of the turn (slew.first_plane = turn).</source>
        <translation>地面相对激光雷达回转所在平面倾斜 %1 度（标准差 %2）。俯仰、横滚和 z 可能有同样大小的误差，其标准差已计入此误差。请在水平、平整的地面上重新采集，或采用回转平面（slew.first_plane = turn）。</translation>
    </message>
    <message>
        <source>The IMU turns %1 times as far as the sensor by its poses: its rates mix up degrees and radians.</source>
        <translation>IMU 的转角是传感器位姿所示转角的 %1 倍：其角速度混淆了度与弧度。</translation>
    </message>
    <message>
        <source>the rates of the IMU are of another unit</source>
        <translation>IMU 角速度的单位不同</translation>
    </message>
    <message>
        <source>Declare the unit of the angular rate as the log of the IMU has it.</source>
        <translation>请按 IMU 日志中的实际情况声明角速度的单位。</translation>
    </message>
    <message>
        <source>wheels and the other sensors contradict each other</source>
        <translation>车轮与其他传感器相互矛盾</translation>
    </message>
    <message>
        <source>The wheels turn backwards where the vehicle goes forwards by its INS: the yaw of the sensor may be half a turn off.</source>
        <translation>按 INS 车辆在前进，车轮却在倒转：传感器的偏航可能相差半圈。</translation>
    </message>
    <message>
        <source>Check the sign of the wheel speeds (forwards is positive), and which axis of the INS looks forward.</source>
        <translation>请检查轮速的符号（前进为正），以及 INS 的哪个轴朝前。</translation>
    </message>
    <message>
        <source>In turns the IMU is pressed to the other side than the speed of the wheels says: the yaw of the sensor may be half a turn off.</source>
        <translation>转弯时 IMU 所受的侧向力与轮速所示方向相反：传感器的偏航可能相差半圈。</translation>
    </message>
    <message>
        <source>Check the sign of the wheel speeds (forwards is positive), and whether the IMU is built in facing backwards (vehicle_frame.imu_yaw_deg).</source>
        <translation>请检查轮速的符号（前进为正），以及 IMU 是否朝后安装（vehicle_frame.imu_yaw_deg）。</translation>
    </message>
    <message>
        <source>The rates of the IMU about its %1 axis are %2% (sigma %3) too large by the turns of the sensor&apos;s poses. The result allows for it.</source>
        <translation>按传感器位姿的转角，IMU 绕其 %1 轴的角速度偏大 %2%（标准差 %3）。结果已计入。</translation>
    </message>
    <message>
        <source>The rates of the IMU about its %1 axis are %2% (sigma %3) too small by the turns of the sensor&apos;s poses. The result allows for it.</source>
        <translation>按传感器位姿的转角，IMU 绕其 %1 轴的角速度偏小 %2%（标准差 %3）。结果已计入。</translation>
    </message>
    <message>
        <source>The right rear wheel is %1% (sigma %2) faster than the left one where the vehicle goes straight. The result allows for it; check the tyres and their stated sizes.</source>
        <translation>车辆直行时，右后轮比左后轮快 %1%（标准差 %2）。结果已计入；请检查轮胎及其标称尺寸。</translation>
    </message>
    <message>
        <source>The right rear wheel is %1% (sigma %2) slower than the left one where the vehicle goes straight. The result allows for it; check the tyres and their stated sizes.</source>
        <translation>车辆直行时，右后轮比左后轮慢 %1%（标准差 %2）。结果已计入；请检查轮胎及其标称尺寸。</translation>
    </message>
    <message>
        <source>%1 of %2 scans do not tell of every direction of the motion; no pair spans them. Wheels and IMU could carry the odometry on, but reach the LiDAR through its mounting, of which no nominal is given. Give one, or drive where there is more to see.</source>
        <translation>%2 帧扫描中有 %1 帧不能反映运动的每个方向；没有点云对跨越它们。车轮和 IMU 本可接续里程计，但须经由激光雷达的安装位姿，而未给出其标称值。请给出标称值，或在可见物更多的地方行驶。</translation>
    </message>
    <message>
        <source>gyro scale x</source>
        <translation>陀螺尺度 x</translation>
    </message>
    <message>
        <source>gyro scale y</source>
        <translation>陀螺尺度 y</translation>
    </message>
    <message>
        <source>gyro scale z</source>
        <translation>陀螺尺度 z</translation>
    </message>
    <message>
        <source>right wheel scale over left</source>
        <translation>右轮与左轮的尺度比</translation>
    </message>
    <message>
        <source>Give a nominal mounting: wheel speeds and IMU carry the odometry through such places, but reach the LiDAR through its mounting, and were not used; or drive where there is more to see.</source>
        <translation>请给出安装位姿的标称值：轮速和 IMU 可使里程计通过这类地段，但须经由激光雷达的安装位姿，因此未被使用；或在可见物更多的地方行驶。</translation>
    </message>
    <message>
        <source>The rates of the IMU are %1% (sigma %2) too large by the turns of the sensor&apos;s poses. The result allows for it.</source>
        <translation>按传感器位姿的转角，IMU 的角速度偏大 %1%（标准差 %2）。结果已计入。</translation>
    </message>
    <message>
        <source>The rates of the IMU are %1% (sigma %2) too small by the turns of the sensor&apos;s poses. The result allows for it.</source>
        <translation>按传感器位姿的转角，IMU 的角速度偏小 %1%（标准差 %2）。结果已计入。</translation>
    </message>
    <message>
        <source>gyro scale</source>
        <translation>陀螺尺度</translation>
    </message>
    <message>
        <source>The positions of the INS are %1 ms older than its attitudes (sigma %2 ms). X is solved with that taken out.</source>
        <translation>INS 的位置比其姿态旧 %1 ms（标准差 %2 ms）。求解 X 时已将其消除。</translation>
    </message>
    <message>
        <source>The positions of the INS are %1 ms younger than its attitudes (sigma %2 ms). X is solved with that taken out.</source>
        <translation>INS 的位置比其姿态新 %1 ms（标准差 %2 ms）。求解 X 时已将其消除。</translation>
    </message>
    <message>
        <source>The positions of the INS are %1 ms older than its attitudes (sigma %2 ms). X is off by the way that is driven meanwhile, which is in the sigmas: set solve.apply_time_offset to auto or yes to take it out.</source>
        <translation>INS 的位置比其姿态旧 %1 ms（标准差 %2 ms）。X 的偏差为此期间行驶的路程，已计入标准差：将 solve.apply_time_offset 设为 auto 或 yes 可将其消除。</translation>
    </message>
    <message>
        <source>The positions of the INS are %1 ms younger than its attitudes (sigma %2 ms). X is off by the way that is driven meanwhile, which is in the sigmas: set solve.apply_time_offset to auto or yes to take it out.</source>
        <translation>INS 的位置比其姿态新 %1 ms（标准差 %2 ms）。X 的偏差为此期间行驶的路程，已计入标准差：将 solve.apply_time_offset 设为 auto 或 yes 可将其消除。</translation>
    </message>
    <message>
        <source>Positions and attitudes of the INS come in messages of different times, and the drive does not show how well they go together: that one is %1 ms older than the other (1 sigma) is in the sigmas.</source>
        <translation>INS 的位置和姿态来自不同时刻的消息，而此次行驶无法表明二者对应得如何：二者相差 %1 ms（1 倍标准差）的可能性已计入标准差。</translation>
    </message>
    <message>
        <source>The motion of the LiDAR leaves its way to one side, by %1 % of it: it rises, sinks or drifts where INS and GNSS do not. X is solved with that taken out.</source>
        <translation>激光雷达的运动偏离其路程，偏离量为路程的 %1 %：它在 INS 和 GNSS 并未如此之处上升、下沉或侧移。求解 X 时已将其消除。</translation>
    </message>
    <message>
        <source>Positions alone hardly show how far the clocks of LiDAR and GNSS are apart: %1 ms (1 sigma) are in the sigmas.</source>
        <translation>仅凭位置几乎无法看出激光雷达与 GNSS 的时钟相差多少：%1 ms（1 倍标准差）已计入标准差。</translation>
    </message>
    <message>
        <source>%1 of %2 rows repeat the motions of an earlier one to the last digit and do not count: what is given twice is no second measurement.</source>
        <translation>%2 行中有 %1 行与前面某行的运动逐位相同，不予计入：重复给出的并不是第二次测量。</translation>
    </message>
    <message>
        <source>the same motions as in row %1</source>
        <translation>与第 %1 行的运动相同</translation>
    </message>
    <message>
        <source>Unless it is taken out, X is off by the way that is driven in that time, along the direction of travel mostly: 20 ms at 36 km/h are 0.2 m.</source>
        <translation>若不消除，X 的偏差即为该时间内行驶的路程，主要沿行驶方向：36 km/h 时 20 ms 即为 0.2 m。</translation>
    </message>
    <message>
        <source>Log position and attitude of one moment, in one message of one device; look which of the two is filtered, sent later, or stamped when it arrives.</source>
        <translation>请将同一时刻的位置和姿态记录在同一设备的同一条消息中；检查二者中哪一个经过滤波、发送较晚，或在到达时才打上时间戳。</translation>
    </message>
    <message>
        <source>X is uncertain by the way that is driven in that time, along the direction of travel mostly.</source>
        <translation>X 的不确定度为该时间内行驶的路程，主要沿行驶方向。</translation>
    </message>
    <message>
        <source>Log position and attitude in one message, or with stamps that agree; or brake and accelerate while recording, which shows how well they go together.</source>
        <translation>请将位置和姿态记录在同一条消息中，或使其时间戳一致；也可在录制时制动和加速，这样可看出二者对应得如何。</translation>
    </message>
    <message>
        <source>An odometry that leans adds to the way what the vehicle did not drive; pitch or yaw takes it.</source>
        <translation>倾斜的里程计会在路程上加入车辆并未行驶的部分；俯仰角或航向角会因此出错。</translation>
    </message>
    <message>
        <source>See whether the poses are of one frame throughout and in metres; make them with an odometry that closes loops, or calibrate from the scans.</source>
        <translation>请检查位姿是否始终属于同一坐标系且以米为单位；请使用带回环的里程计生成位姿，或直接用扫描进行标定。</translation>
    </message>
    <message>
        <source>X is uncertain by the way that is driven in that time.</source>
        <translation>X 的不确定度为该时间内行驶的路程。</translation>
    </message>
    <message>
        <source>Synchronise the clocks, or record an INS with attitude, whose turns show the offset.</source>
        <translation>请同步时钟，或录制带姿态的 INS，其转动可显示时钟偏差。</translation>
    </message>
</context>
<context>
    <name>remount::option_changes</name>
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
    <name>remount::option_mentions</name>
    <message>
        <source>“%1” (%2)</source>
        <translation>“%1”（%2）</translation>
    </message>
</context>
<context>
    <name>remount::pair_measure</name>
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
    <name>remount::project_files</name>
    <message>
        <source>%1
The project is opened without this session and without its pairs. Its file is left as it is: saving asks for another name.</source>
        <translation>%1
项目在没有此数据及其帧对的情况下打开。文件保持不变：保存时会询问另一个名称。</translation>
    </message>
    <message>
        <source>is open in another window: %1.
Save under another name, or close it there first.</source>
        <translation>已在另一个窗口中打开：%1。
请以其他名称保存，或先在那里关闭它。</translation>
    </message>
</context>
<context>
    <name>remount::reasons</name>
    <message>
        <source>moving objects</source>
        <translation>有运动物体</translation>
    </message>
    <message>
        <source>aligned wrongly</source>
        <translation>配准错误</translation>
    </message>
    <message>
        <source>too little in common</source>
        <translation>共同部分太少</translation>
    </message>
    <message>
        <source>INS doubtful here</source>
        <translation>此处 INS 可疑</translation>
    </message>
    <message>
        <source>view blocked or dirty</source>
        <translation>视野被挡或脏污</translation>
    </message>
</context>
<context>
    <name>remount::recovery</name>
    <message>
        <source>cannot be made: work is not saved until you save it</source>
        <translation>无法建立：在您保存之前工作不会被保存</translation>
    </message>
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
    <message>
        <source>cannot be locked: work is not saved until you save it</source>
        <translation>无法锁定：在您保存之前，工作不会被保存</translation>
    </message>
</context>
<context>
    <name>remount::report_pdf</name>
    <message>
        <source>There is no PDF: no font with the letter &quot;%1&quot; is installed. For Chinese, install fonts-noto-cjk.</source>
        <translation>未生成 PDF：没有安装含“%1”字的字体。中文请安装 fonts-noto-cjk。</translation>
    </message>
</context>
<context>
    <name>remount::steps</name>
    <message>
        <source>all six observed</source>
        <translation>六个全部可观测</translation>
    </message>
    <message>
        <source>solved in part</source>
        <translation>部分求解</translation>
    </message>
    <message>
        <source>too little data</source>
        <translation>数据太少</translation>
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
        <translation>1 个数据</translation>
    </message>
    <message>
        <source>%1 sessions</source>
        <translation>%1 个数据</translation>
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
</context>
<context>
    <name>remount::theme</name>
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
<context>
    <name>remount::wording</name>
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
    <name>report</name>
    <message>
        <source>Residual of translation per pair (cm)</source>
        <translation>各帧对的平移残差（厘米）</translation>
    </message>
    <message>
        <source>Residual of rotation per pair (degrees)</source>
        <translation>各帧对的旋转残差（度）</translation>
    </message>
    <message>
        <source>Calibration of a LiDAR: report</source>
        <translation>激光雷达标定报告</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>LiDAR in the INS frame (ins_from_lidar)</source>
        <translation>激光雷达在 INS 坐标系中 (ins_from_lidar)</translation>
    </message>
    <message>
        <source>value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>1 sigma</source>
        <translation>1 倍标准差</translation>
    </message>
    <message>
        <source>by resampling</source>
        <translation>重采样</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>名义值</translation>
    </message>
    <message>
        <source>new − nominal</source>
        <translation>新值 − 名义值</translation>
    </message>
    <message>
        <source>not observed</source>
        <translation>不可观测</translation>
    </message>
    <message>
        <source>R = Rz(yaw) Ry(pitch) Rx(roll); point_in_ins = ins_from_lidar * point_in_lidar.</source>
        <translation>R = Rz(yaw) Ry(pitch) Rx(roll)；point_in_ins = ins_from_lidar * point_in_lidar。</translation>
    </message>
    <message>
        <source>* with a value measured by hand.</source>
        <translation>* 含有手工测量值。</translation>
    </message>
    <message>
        <source>quaternion x, y, z, w</source>
        <translation>四元数 x, y, z, w</translation>
    </message>
    <message>
        <source>Correlation of the parameters</source>
        <translation>参数的相关性</translation>
    </message>
    <message>
        <source>What the drive can tell</source>
        <translation>此次行驶能说明什么</translation>
    </message>
    <message>
        <source>All six parameters are observed.</source>
        <translation>六个参数全部可观测。</translation>
    </message>
    <message>
        <source>Not observed</source>
        <translation>不可观测</translation>
    </message>
    <message>
        <source>Check by the accumulated map</source>
        <translation>用累积地图检查</translation>
    </message>
    <message>
        <source>No map check was made.</source>
        <translation>没有做地图检查。</translation>
    </message>
    <message>
        <source>Lower is sharper. This check does not use the residual.</source>
        <translation>数值越低越清晰。此检查不使用残差。</translation>
    </message>
    <message>
        <source>under</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>mean map entropy</source>
        <translation>平均地图熵</translation>
    </message>
    <message>
        <source>thickness of planes</source>
        <translation>平面厚度</translation>
    </message>
    <message>
        <source>neighbourhoods</source>
        <translation>邻域数</translation>
    </message>
    <message>
        <source>Worst and best pairs</source>
        <translation>最差和最好的帧对</translation>
    </message>
    <message>
        <source>Residuals of the pairs</source>
        <translation>各帧对的残差</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>行驶</translation>
    </message>
    <message>
        <source>The sessions were not opened for this report.</source>
        <translation>此报告没有打开数据。</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>帧对</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>待定</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>接受</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>rms of residuals</source>
        <translation>残差均方根</translation>
    </message>
    <message>
        <source>pair</source>
        <translation>帧对</translation>
    </message>
    <message>
        <source>session</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>scan a (UTC)</source>
        <translation>扫描 a (UTC)</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>间隔</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>基线</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>转角</translation>
    </message>
    <message>
        <source>RMSE</source>
        <translation>均方根误差</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>重叠</translation>
    </message>
    <message>
        <source>screw test</source>
        <translation>螺旋检验</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>数据文件</translation>
    </message>
    <message>
        <source>The files&apos; hashes are not known.</source>
        <translation>文件的校验值未知。</translation>
    </message>
    <message>
        <source>file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>字节</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>All settings have their defaults.</source>
        <translation>所有设置均为默认值。</translation>
    </message>
    <message>
        <source>Changed from the defaults (in brackets):</source>
        <translation>与默认值不同的设置（括号内为默认值）：</translation>
    </message>
    <message>
        <source>Track of the INS from above: east to the right, north up (UTM grid)</source>
        <translation>INS 轨迹，俯视：东向右，北向上（UTM 格网）</translation>
    </message>
    <message>
        <source>Track of the INS as its poses state it: x to the right, y up</source>
        <translation>INS 轨迹，按其位姿的坐标轴：x 向右，y 向上</translation>
    </message>
    <message>
        <source>No positions are known.</source>
        <translation>没有已知的位置。</translation>
    </message>
    <message>
        <source>dot: start</source>
        <translation>圆点：起点</translation>
    </message>
    <message>
        <source>Antenna in the reference frame</source>
        <translation>天线在参考坐标系中</translation>
    </message>
    <message>
        <source>LiDAR from the antenna, in its own axes</source>
        <translation>激光雷达相对天线的位置（激光雷达自身坐标轴）</translation>
    </message>
    <message>
        <source>LiDAR in the reference frame</source>
        <translation>激光雷达在参考坐标系中</translation>
    </message>
    <message>
        <source>Positions of an antenna give its lever arm, m, and no attitude.</source>
        <translation>天线的位置只给出其杆臂（米），不给出姿态。</translation>
    </message>
    <message>
        <source>R = Rz(yaw) Ry(pitch) Rx(roll); X takes points of the LiDAR to the reference frame.</source>
        <translation>R = Rz(yaw) Ry(pitch) Rx(roll)；X 把激光雷达的点变换到参考坐标系。</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>where</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>what was found</source>
        <translation>发现</translation>
    </message>
    <message>
        <source>what it means, and what to do</source>
        <translation>含义与处理办法</translation>
    </message>
    <message>
        <source>higher bars are cut</source>
        <translation>更高的柱已截断</translation>
    </message>
    <message>
        <source>green: accepted, grey: rejected, amber: undecided</source>
        <translation>绿：已接受，灰：已拒绝，琥珀：未决定</translation>
    </message>
    <message>
        <source>All six parameters are known, with what was measured.</source>
        <translation>六个参数全部已知（含测量值）。</translation>
    </message>
</context>
</TS>
