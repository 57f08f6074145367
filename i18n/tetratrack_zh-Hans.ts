<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
  <context>
    <name>tetratrack</name>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Units at the common centre of their cones, with orientation, standard deviations (m, degrees), score and status.</source>
      <translation>位于各圆锥公共中心的块体,含姿态、标准差(米、度)、得分和状态。</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Centre and the four joints of three cones (f123, f124, f134, f234) of every unit, with covariance (m, m²).</source>
      <translation>每个块体的中心和三个圆锥的四个交汇点(f123、f124、f134、f234),含协方差(m、m²)。</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Displacement of every feature point between consecutive epochs (m), with test statistic and class.</source>
      <translation>相邻两期之间每个特征点的位移(米),含检验统计量和类别。</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Residuals at the control points (m), with normalised residual; disturbed points are marked.</source>
      <translation>控制点残差(米)及标准化残差;受扰动的点有标记。</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Feature points less surveyed check points (m).</source>
      <translation>特征点减去实测检查点之差(米)。</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Monitoring</source>
      <translation>监测</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Single steps</source>
      <translation>单个步骤</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Planning and simulation</source>
      <translation>规划与模拟</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Inputs and outputs</source>
      <translation>输入与输出</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Limits</source>
      <translation>限制</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>The engine's result holds no layer {layer}.</source>
      <translation>引擎的结果中没有图层 {layer}。</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Numbers for models</source>
      <translation>供模型使用的数值</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Displacement report</source>
      <translation>位移报告</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Writes the report of a result as reviewed so far: summary, control quality, displacement map and table, worst units, damage figures, method, settings and versions.</source>
      <translation>按目前的审核情况编写结果报告:摘要、控制质量、位移图和表、最严重的块体、损坏指标、方法、设置和版本。</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Rejected units are left out of the statistics and listed apart. PDF needs the library weasyprint in the engine.</source>
      <translation>被否决的块体不计入统计并单独列出。PDF 需要引擎中的 weasyprint 库。</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>report,HTML,PDF,damage,displacement</source>
      <translation>报告,HTML,PDF,损坏,位移</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>GeoPackage written by Monitor a survey.</source>
      <translation>由“监测测量”写出的 GeoPackage。</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>HTML in one file, or PDF; the ending decides.</source>
      <translation>单个 HTML 文件或 PDF;由扩展名决定。</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Result</source>
      <translation>结果</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Report</source>
      <translation>报告</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Extract feature points</source>
      <translation>提取特征点</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Derives the centre and the four points where three cone surfaces meet on the outside of each unit, with the covariance carried over from the fit. These points can be surveyed by total station as well.</source>
      <translation>求出每个块体的中心以及三个圆锥面在外侧相交的四个点,并传播拟合的协方差。这些点也可用全站仪测量。</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>A joint is marked as observed only where points lie next to it; otherwise it follows from the rest of the unit.</source>
      <translation>只有紧邻处有点时交汇点才标为已观测;否则由块体其余部分推得。</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>feature points,cone intersection,centre,covariance propagation</source>
      <translation>特征点,圆锥交点,中心,协方差传播</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Layer of units from Fit tetrapods or Monitor a survey.</source>
      <translation>来自“拟合四脚块体”或“监测测量”的块体图层。</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Fitted units</source>
      <translation>已拟合的块体</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Points</source>
      <translation>点</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Fit tetrapods</source>
      <translation>拟合四脚块体</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Fits four equal cones that share a centre to the points of each unit by an iterated Gauss–Helmert adjustment with robust weights, end discs and removal of the curvature bias; gives pose, radius, taper and their covariance.</source>
      <translation>用迭代高斯-赫尔默特平差把四个共中心的相等圆锥拟合到每个块体的点上,采用稳健权、端面并消除曲率偏差;给出位姿、半径、锥度及其协方差。</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>With one visible leg the twist about its axis is undetermined: the unit says so in its large standard deviation.</source>
      <translation>只看到一条腿时,绕其轴的转角无法确定:块体很大的标准差会说明这一点。</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>adjustment,Gauss-Helmert,least squares,cone,pose,covariance</source>
      <translation>平差,高斯-赫尔默特,最小二乘,圆锥,位姿,协方差</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Layer of units from Segment tetrapods, with the fields qx, qy, qz, qw of their orientation.</source>
      <translation>来自“分割四脚块体”的块体图层,含姿态字段 qx、qy、qz、qw。</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Units found</source>
      <translation>找到的块体</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Units fitted</source>
      <translation>拟合的块体数</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>LAS, LAZ or COPC files, a folder of them, a virtual point cloud (.vpc) or point cloud layers; coordinates in metres.</source>
      <translation>LAS、LAZ 或 COPC 文件、其文件夹、虚拟点云(.vpc)或点云图层;坐标单位为米。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Projected CRS in metres; empty takes that of the tiles, and a local frame if they declare none.</source>
      <translation>以米为单位的投影坐标系;留空则取分块的坐标系,若未声明则用局部坐标系。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Label of this survey in all results, for example its date.</source>
      <translation>此次测量在所有结果中的名称,例如日期。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Drives the temporal controller; empty takes the date of the first tile.</source>
      <translation>驱动时态控制器;留空则取第一个分块的日期。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Estimates both from the best-seen units and holds them: moulds differ by centimetres from the standard proportions.</source>
      <translation>由看得最清楚的块体估计两者并固定:模具与标准比例相差数厘米。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Type of unit</source>
      <translation>块体类型</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Catalogue name with the mass in tonnes, such as tetrapod 8 t; or tetrapod with a height of your own.</source>
      <translation>带质量(吨)的目录名称,如 tetrapod 8 t;或自定高度的 tetrapod。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>From the plane under three legs to the top of the fourth, in metres; overrides the catalogue.</source>
      <translation>从三条腿下的平面到第四条腿顶端,单位米;优先于目录。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Radius of a leg's cone at the unit's centre, in metres; empty takes 0.264 H.</source>
      <translation>块体中心处腿部圆锥的半径,单位米;留空取 0.264 H。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Loss of radius per metre along the leg's axis; empty takes 0.176.</source>
      <translation>沿腿轴每米减小的半径;留空取 0.176。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>From the centre to the end disc, in metres; empty takes 0.644 H.</source>
      <translation>从中心到端面,单位米;留空取 0.644 H。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Built tetrapods are tetrahedral; 120° between leg 1 and the others repeats the published equations.</source>
      <translation>实际的四脚块体为正四面体形;腿1与其余腿之间的 120° 重现论文公式。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Polygon inside which units are looked for; its outer ring is used. Empty means everywhere.</source>
      <translation>在其中寻找块体的多边形;使用其外环。留空表示全部。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Polygons around surfaces that do not move, such as the crown wall: they tie epochs without control to the earliest with control, or to the first.</source>
      <translation>围绕不动表面（如胸墙）的多边形：将没有控制点的期次与最早有控制点的期次（若无则与第一期）连接。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Blocks of the survey worked on at the same time; each takes about 1 GB of memory.</source>
      <translation>同时处理的测区块数;每块约占 1 GB 内存。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Surveyed targets: point layer or CSV with point_id, easting, northing, height, sd_e, sd_n, sd_h (m).</source>
      <translation>实测标靶:含 point_id、easting、northing、height、sd_e、sd_n、sd_h(米)的点图层或 CSV。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The same targets as measured in this epoch's cloud: point layer or CSV with point_id, x, y, z (m).</source>
      <translation>在本期点云中量得的同一标靶:含 point_id、x、y、z(米)的点图层或 CSV。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Surveyed joints of cones, for validation only: CSV or layer with point_id, unit_easting, unit_northing, unit_height and position (m).</source>
      <translation>实测的圆锥交汇点,仅用于验证:含 point_id、unit_easting、unit_northing、unit_height 和位置(米)的 CSV 或图层。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Give the height H of the unit, or choose a catalogue name with its mass, such as tetrapod 8 t.</source>
      <translation>请给出块体高度 H,或选择带质量的目录名称,如 tetrapod 8 t。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The type of unit must be tetrapod, or a catalogue name such as tetrapod 8 t.</source>
      <translation>块体类型必须是 tetrapod,或如 tetrapod 8 t 的目录名称。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Control points and targets in the cloud belong together: give both, or neither.</source>
      <translation>控制点与点云中的标靶是一对:请都给出或都不给。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>CRS of the results</source>
      <translation>结果的坐标系</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Epoch</source>
      <translation>期次</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Time of the survey (UTC)</source>
      <translation>测量时间(UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Calibrate radius and taper</source>
      <translation>标定半径和锥度</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Height H of the unit (m)</source>
      <translation>块体高度 H(米)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Cone radius at the centre (m)</source>
      <translation>中心处圆锥半径(米)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Taper of the leg</source>
      <translation>腿的锥度</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Leg length (m)</source>
      <translation>腿长(米)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Angle between the legs</source>
      <translation>腿间夹角</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Area of interest</source>
      <translation>感兴趣区域</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Stable areas</source>
      <translation>稳定区域</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Worker processes</source>
      <translation>工作进程数</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Control points</source>
      <translation>控制点</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Targets in the cloud</source>
      <translation>点云中的标靶</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Check points</source>
      <translation>检查点</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The cone radius must be smaller than half the height of the unit.</source>
      <translation>圆锥半径必须小于块体高度的一半。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The area of interest holds no polygon.</source>
      <translation>感兴趣区域中没有多边形。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The area of interest has several separate parts; give one polygon.</source>
      <translation>感兴趣区域有多个分离部分;请给出一个多边形。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Point cloud tiles</source>
      <translation>点云分块</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>tetrahedral (109.5°)</source>
      <translation>正四面体形(109.5°)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>as in the paper (120°)</source>
      <translation>按论文(120°)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{crs} is geographic; choose a projected CRS in metres.</source>
      <translation>{crs} 是地理坐标系;请选择以米为单位的投影坐标系。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: no LAS or LAZ file is given.</source>
      <translation>{where}:没有给出 LAS 或 LAZ 文件。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: there is no file or layer {path}.</source>
      <translation>{where}:没有文件或图层 {path}。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{layer} cannot be written: {reason}.</source>
      <translation>无法写入 {layer}：{reason}。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{layer} has no field {fields}; it has {present}.</source>
      <translation>{layer} 没有字段 {fields};它有 {present}。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: the folder {path} holds no LAS or LAZ file.</source>
      <translation>{where}:文件夹 {path} 中没有 LAS 或 LAZ 文件。</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: {path} is not a virtual point cloud.</source>
      <translation>{where}:{path} 不是虚拟点云。</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Inspect tiles</source>
      <translation>检查分块</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Lists point cloud tiles with their extent, CRS, number and density of points and range of heights. Run it first: it shows missing CRS, gaps, overlaps and tiles too thin to find units in.</source>
      <translation>列出点云分块的范围、坐标系、点数与密度以及高程范围。请先运行:它显示缺失的坐标系、空隙、重叠以及点太稀的分块。</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Reads headers and a sample of points; a damaged tile is named and ends the run.</source>
      <translation>读取文件头和部分点;损坏的分块会被指出并结束运行。</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>point cloud,LAS,LAZ,tile index,density,CRS,extent</source>
      <translation>点云,LAS,LAZ,分块索引,密度,坐标系,范围</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>One rectangle per tile with file, CRS, points, density (points/m²) and heights (m).</source>
      <translation>每个分块一个矩形,含文件、坐标系、点数、密度(点/m²)和高程(米)。</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Tile index</source>
      <translation>分块索引</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Tiles</source>
      <translation>分块数</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Median density (points/m²)</source>
      <translation>密度中位数(点/m²)</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>CRS of the tiles</source>
      <translation>分块的坐标系</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Monitor a survey</source>
      <translation>监测测量</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>All steps at once: registers every epoch to survey control, finds the tetrapods, fits four cones that share a centre, derives feature points and tests their displacements. Give a survey.toml, or the epochs and the unit.</source>
      <translation>一次完成所有步骤:把每期配准到测量控制,找出四脚块体,拟合四个共中心的圆锥,求特征点并检验其位移。给出 survey.toml,或各期次与块体。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Units of which less than about 5 % is seen are not found. Without control the cloud's own frame is used, and the result says so.</source>
      <translation>可见部分少于约 5 % 的块体找不到。没有控制时使用点云自身的坐标系,结果会说明。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>tetrapod,armour unit,breakwater,displacement,monitoring,LAS,LAZ,deformation</source>
      <translation>四脚块体,护面块体,防波堤,位移,监测,LAS,LAZ,变形</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>A survey.toml; if given, it states everything, and the fields for epochs, unit, CRS and area are not used.</source>
      <translation>一个 survey.toml;若给出则由它决定一切,期次、块体、坐标系和区域各栏不再使用。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Label</source>
      <translation>名称</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Time (UTC)</source>
      <translation>时间(UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>One row per epoch: label, time such as 2025-03-14T02:30, folder or files of tiles (separated by ;), CSV files or layers.</source>
      <translation>每期一行:名称、如 2025-03-14T02:30 的时间、分块文件夹或文件(以 ; 分隔)、CSV 文件或图层。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Writes a top view of each epoch as GeoTIFF beside the result, as a backdrop.</source>
      <translation>在结果旁为每期写出俯视图 GeoTIFF 作为底图。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Adds all layers to the project as a group with their styles.</source>
      <translation>把所有图层连同样式作为一个组加入工程。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>GeoPackage with units, feature points, displacements, residuals, epochs and reviews, in the survey's CRS, times in UTC.</source>
      <translation>含块体、特征点、位移、残差、期次和审核的 GeoPackage,采用测量坐标系,时间为 UTC。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Survey file</source>
      <translation>测量文件</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Epochs</source>
      <translation>期次</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Shaded relief of each epoch</source>
      <translation>每期的晕渲图</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Load the result</source>
      <translation>加载结果</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Units moved</source>
      <translation>移动的块体</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>RMSE at check points (m)</source>
      <translation>检查点均方根误差(米)</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Give a survey.toml, or at least one epoch with its tiles.</source>
      <translation>请给出 survey.toml,或至少一期及其分块。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Every epoch needs six columns: label, time, tiles, control points, targets, check points.</source>
      <translation>每期需要六列:名称、时间、分块、控制点、标靶、检查点。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Epoch {label}</source>
      <translation>期次 {label}</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{where}: {path} cannot be read as a point layer or CSV file.</source>
      <translation>{where}:{path} 无法作为点图层或 CSV 文件读取。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>The folder {folder} does not exist.</source>
      <translation>文件夹 {folder} 不存在。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Plan a survey: detectable displacement</source>
      <translation>规划测量:可探测位移</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Computes which displacement and rotation of a unit a planned survey will find, from point density, noise, visible share and registration: the Cramér–Rao bound of the adjustment for the unit's geometry, and Baarda's detectability.</source>
      <translation>由点密度、噪声、可见比例和配准计算计划的测量能发现块体多大的位移和转动:针对块体几何的平差的克拉默-拉奥界,以及巴尔达可探测性。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>White noise is averaged over the points of a unit; whatever does not average out must be stated as systematic part.</source>
      <translation>白噪声在块体的点上被平均;不能平均的部分必须作为系统成分给出。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>planning,detectability,point density,noise,Cramér-Rao bound,minimal detectable displacement</source>
      <translation>规划,可探测性,点密度,噪声,克拉默-拉奥界,最小可探测位移</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Point density (points/m²)</source>
      <translation>点密度(点/m²)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>On a surface that faces the instrument, all flight strips or stations together.</source>
      <translation>在朝向仪器的表面上,所有航带或测站合计。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Noise of a point (m)</source>
      <translation>点的噪声(米)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation along the surface normal, in metres.</source>
      <translation>沿表面法线方向的标准差,单位米。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Visible share of a unit</source>
      <translation>块体的可见比例</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share of a unit's surface that holds points, 0 to 1; in a pile 0.05 to 0.5.</source>
      <translation>块体表面有点部分的比例,0 到 1;堆积体中为 0.05 到 0.5。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Registration (m)</source>
      <translation>配准(米)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of an epoch's registration at the unit, per coordinate, in metres.</source>
      <translation>块体处一期配准的标准差,每个坐标,单位米。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Systematic part (m)</source>
      <translation>系统成分(米)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Strip offsets, roughness and growth that do not average out, per coordinate, in metres.</source>
      <translation>不能平均的航带偏差、粗糙度和附着物,每个坐标,单位米。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Line of sight from the vertical (degrees)</source>
      <translation>视线与铅垂线的夹角(度)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>0 from the air; about 70 from the crown wall.</source>
      <translation>从空中为 0;从胸墙约为 70。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Calibrated and held; otherwise they are estimated for every unit, which costs accuracy.</source>
      <translation>已标定并固定;否则逐块估计,精度会降低。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Level of significance</source>
      <translation>显著性水平</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Probability of a false alarm for one unit.</source>
      <translation>单个块体误报的概率。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Power</source>
      <translation>检验功效</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Probability with which the displacement is found.</source>
      <translation>发现位移的概率。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Points on a unit</source>
      <translation>每个块体的点数</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of the centre (m)</source>
      <translation>中心的标准差(米)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of the rotation (degrees)</source>
      <translation>转动的标准差(度)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of a displacement (m)</source>
      <translation>位移的标准差(米)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable displacement, worst direction (m)</source>
      <translation>可探测位移,最差方向(米)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable displacement, mean (m)</source>
      <translation>可探测位移,平均(米)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable rotation (degrees)</source>
      <translation>可探测转动(度)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>The level of significance must be below the power.</source>
      <translation>显著性水平必须小于检验功效。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Radius and taper are known</source>
      <translation>半径和锥度已知</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Register to control</source>
      <translation>配准到控制</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Estimates the rigid transformation from an epoch's cloud to survey control from targets, weighted by their standard deviations, and finds disturbed targets by data snooping on normalised residuals.</source>
      <translation>由按标准差加权的标靶估计一期点云到测量控制的刚体变换,并用标准化残差的数据探测法发现受扰动的标靶。</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Needs three targets that do not lie in one line; an outlier is found from four, and named surely from five.</source>
      <translation>需要三个不共线的标靶;四个起可发现粗差,五个起可确定是哪一个。</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>registration,control points,targets,transformation,data snooping,georeferencing</source>
      <translation>配准,控制点,标靶,坐标变换,数据探测,地理参考</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>GeoPackage whose table epochs holds the seven parameters and their covariance.</source>
      <translation>表 epochs 中含七个参数及其协方差的 GeoPackage。</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Registration</source>
      <translation>配准结果</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>RMSE at control points (m)</source>
      <translation>控制点均方根误差(米)</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Disturbed targets</source>
      <translation>受扰动的标靶</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Register views</source>
      <translation>配准视图</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Brings overlapping views of a depth camera or scanner stations into the frame of the first by multiway ICP with a pose graph, and writes one cloud in which every view keeps its number as point source id.</source>
      <translation>用带位姿图的多向 ICP 把深度相机或扫描站的重叠视图转到第一个视图的坐标系,写出一个点云,其中各视图保留其编号作为点源 ID。</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Views must overlap by a third or more and be roughly aligned; views that do not connect are named.</source>
      <translation>视图须重叠三分之一以上并大致对齐;连不上的视图会被指出。</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>registration,ICP,pose graph,depth camera,multi-view</source>
      <translation>配准,ICP,位姿图,深度相机,多视图</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Resolution at which views are matched, in metres; empty derives it from the point spacing.</source>
      <translation>匹配视图的分辨率,单位米;留空由点间距推定。</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>One LAZ file in the frame of the first view.</source>
      <translation>第一个视图坐标系中的一个 LAZ 文件。</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Views</source>
      <translation>视图</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Voxel size (m)</source>
      <translation>体素大小(米)</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Registered cloud</source>
      <translation>配准后的点云</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>RMSE between views (m)</source>
      <translation>视图间均方根误差(米)</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Segment tetrapods</source>
      <translation>分割四脚块体</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Finds every tetrapod in a pile: cones from pairs of oriented points, legs that agree on a common centre and on the angles between them, and verification against the visible surface and against empty space.</source>
      <translation>找出堆积体中的每个四脚块体:由带法线的点对得到圆锥,腿在公共中心和夹角上相符,并用可见表面和空白空间验证。</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Units of which less than about 5 % is seen are not found; weak evidence has the status uncertain. Poses are approximate: fit them next.</source>
      <translation>可见部分少于约 5 % 的块体找不到;证据弱的状态为不确定。位姿是近似的:接着进行拟合。</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>segmentation,RANSAC,cone,tetrapod,armour unit,detection</source>
      <translation>分割,RANSAC,圆锥,四脚块体,护面块体,检测</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Simulate a survey</source>
      <translation>模拟测量</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Writes a simulated survey of a tetrapod slope with known poses: LAZ tiles, control, check points and survey.toml. Use it to try the chain, to train, or to test a planned density and noise.</source>
      <translation>写出位姿已知的四脚块体斜坡的模拟测量:LAZ 分块、控制、检查点和 survey.toml。用于试跑流程、培训或检验计划的密度与噪声。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Simulated surfaces are cleaner than real ones; judge a plan with some reserve.</source>
      <translation>模拟表面比真实表面干净;判断规划时应留有余地。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>simulation,synthetic,ground truth,test data</source>
      <translation>模拟,合成,真值,测试数据</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>UAV laser scanner</source>
      <translation>无人机激光扫描仪</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>terrestrial laser scanner</source>
      <translation>地面激光扫描仪</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>photogrammetry</source>
      <translation>摄影测量</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>depth camera</source>
      <translation>深度相机</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Decides viewpoints, hidden parts and, unless stated, noise and density.</source>
      <translation>决定视点、遮挡部分,以及未给出时的噪声和密度。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Number of units on the slope.</source>
      <translation>斜坡上的块体数。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Number of surveys; some units move between them.</source>
      <translation>测量次数;其间部分块体移动。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Standard deviation of the range, in metres; empty takes that of the instrument.</source>
      <translation>测距标准差,单位米;留空取仪器的值。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>On the ground; empty takes that of the instrument.</source>
      <translation>地面上;留空取仪器的值。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>The same seed gives the same survey.</source>
      <translation>相同的种子得到相同的测量。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Receives tiles, CSV files, survey.toml and truth.</source>
      <translation>存放分块、CSV 文件、survey.toml 和真值。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Instrument</source>
      <translation>仪器</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Units</source>
      <translation>块体</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Seed</source>
      <translation>种子</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Survey folder</source>
      <translation>测量文件夹</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>survey.toml of the simulated survey</source>
      <translation>模拟测量的 survey.toml</translation>
    </message>
    <message>
      <location filename="../algorithms/survey_algorithm.py" />
      <source>The tiles declare no CRS: results are in a local frame. Choose the CRS of the results to change that.</source>
      <translation>分块未声明坐标系:结果在局部坐标系中。如需更改,请选择结果的坐标系。</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Track displacements</source>
      <translation>跟踪位移</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Recognises each unit in all epochs, finds the stable units by a global congruence test and tests the displacement of every feature point and the rotation of every unit against it, with the covariance of fit and registration.</source>
      <translation>在所有期次中识别每个块体,用整体叠合检验找出稳定块体,并相对它们用拟合与配准的协方差检验每个特征点的位移和每个块体的转动。</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>A rotation near 60° or more is ambiguous by the symmetry of the tetrapod and is reported as such.</source>
      <translation>约 60° 或以上的转动因四脚块体的对称性而有歧义,并会如实报告。</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>displacement,deformation analysis,congruence test,epoch,monitoring</source>
      <translation>位移,变形分析,叠合检验,期次,监测</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Layers of units from Fit tetrapods: one per epoch, each with its own label and time, all in one CRS.</source>
      <translation>“拟合四脚块体”的块体图层:每期一个,各有名称和时间,坐标系相同。</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>GeoPackages from Register to control, one per epoch; without them the clouds' own frames are taken as registered.</source>
      <translation>“配准到控制”的 GeoPackage,每期一个;没有时视点云自身坐标系为已配准。</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Fitted units of all epochs</source>
      <translation>所有期次的已拟合块体</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Registrations</source>
      <translation>配准结果(多个)</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Give the units of at least two epochs.</source>
      <translation>请给出至少两期的块体。</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>The layers of units have different CRS: {crs}.</source>
      <translation>块体图层的坐标系不同:{crs}。</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Validate against check points</source>
      <translation>用检查点验证</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Compares feature points of one epoch with the same points surveyed by total station or GNSS. Check points never take part in the fit: their differences show the accuracy that was reached.</source>
      <translation>把一期的特征点与用全站仪或 GNSS 测得的同一点比较。检查点从不参与拟合:其差值显示所达到的精度。</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>A check point is matched by the approximate centre of its unit; one that matches no unit is named and left out.</source>
      <translation>检查点按其块体的近似中心匹配;匹配不到的会被指出并略去。</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>validation,accuracy,check points,total station,GNSS,RMSE</source>
      <translation>验证,精度,检查点,全站仪,GNSS,均方根误差</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Layer from Extract feature points, of one epoch.</source>
      <translation>来自“提取特征点”的图层,一期。</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Feature points</source>
      <translation>特征点</translation>
    </message>
    <message>
      <location filename="../plugin/engine.py" />
      <source>The tetratrack engine is not installed: open Settings &gt; Options &gt; Tetratrack and create its environment or choose one.</source>
      <translation>未安装 tetratrack 引擎:请打开 设置 &gt; 选项 &gt; Tetratrack,创建其环境或选择一个。</translation>
    </message>
    <message>
      <location filename="../plugin/engine.py" />
      <source>The engine ended unexpectedly (exit code {code}); QGIS and your data are unharmed.</source>
      <translation>引擎意外结束(退出码 {code});QGIS 和您的数据未受影响。</translation>
    </message>
    <message>
      <location filename="../plugin/engine.py" />
      <source>The engine could not be started with {python}: {reason}.</source>
      <translation>无法用 {python} 启动引擎:{reason}。</translation>
    </message>
    <message>
      <location filename="../plugin/engine_task.py" />
      <source>Cancelled.</source>
      <translation>已取消。</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>found</source>
      <translation>已找到</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>uncertain</source>
      <translation>不确定</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>new</source>
      <translation>新增</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>relocated</source>
      <translation>移位</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>lost: the place is empty</source>
      <translation>丢失：该位置为空</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>unseen: known from another epoch</source>
      <translation>未见：其他时期已知</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>unexplained points where a unit fits</source>
      <translation>可容纳块体处的未解释点</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>hole where a unit fits</source>
      <translation>可容纳块体的空洞</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>arrow of 10 mm: 50 mm; ellipse: 95 %</source>
      <translation>箭头 10 mm = 50 mm;椭圆 = 95 %</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>below the detection limit</source>
      <translation>低于探测限</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>significant, up to 50 mm</source>
      <translation>显著,不超过 50 mm</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>50 to 100 mm: watch</source>
      <translation>50 至 100 mm:关注</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>more than 100 mm: alert</source>
      <translation>超过 100 mm:警报</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>relocated unit</source>
      <translation>移位的块体</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>uncertain unit</source>
      <translation>不确定的块体</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>observed</source>
      <translation>已观测</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>derived from the rest of the unit</source>
      <translation>由块体其余部分推得</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>used</source>
      <translation>已使用</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>disturbed, not used</source>
      <translation>受扰动,未使用</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>not used</source>
      <translation>未使用</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>check point</source>
      <translation>检查点</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Gaps</source>
      <translation>缺失位置</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Displacements</source>
      <translation>位移</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Displacements, other pairs and datum</source>
      <translation>位移(其他期对和其他基准)</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Control residuals</source>
      <translation>控制点残差</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Check residuals</source>
      <translation>检查点残差</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Reviews</source>
      <translation>审核</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create a Python environment in {folder} and download about {size} of libraries into it?</source>
      <translation>在 {folder} 中创建 Python 环境并下载约 {size} 的库吗?</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Creating the tetratrack engine</source>
      <translation>正在创建 tetratrack 引擎</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python interpreter of the engine</source>
      <translation>引擎的 Python 解释器</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Empty uses the environment that the plugin creates.</source>
      <translation>留空则使用插件创建的环境。</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create the engine's environment…</source>
      <translation>创建引擎的环境…</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Engine</source>
      <translation>引擎</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>State</source>
      <translation>状态</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>The engine is ready.</source>
      <translation>引擎已就绪。</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python 3.11 or later was not found: install it, or choose an interpreter of the engine above.</source>
      <translation>未找到 Python 3.11 或更高版本:请安装,或在上方选择引擎的解释器。</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>The engine's environment could not be created: {reason}</source>
      <translation>无法创建引擎的环境:{reason}</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Used: {python}</source>
      <translation>正在使用:{python}</translation>
    </message>
    <message>
      <location filename="../plugin/provider.py" />
      <source>Tetratrack: displacements of tetrapods</source>
      <translation>Tetratrack:四脚块体的位移</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Survey description</source>
      <translation>测量说明</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Survey (*.toml)</source>
      <translation>测量 (*.toml)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fit again after a click on the unit (earlier epoch)</source>
      <translation>单击块体后重新拟合(前一期)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fit again after a click on the unit (later epoch)</source>
      <translation>单击块体后重新拟合(后一期)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints of legs (earlier epoch)</source>
      <translation>用三个腿部交汇点固定(前一期)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints of legs (later epoch)</source>
      <translation>用三个腿部交汇点固定(后一期)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pick feature points beside the fit (earlier epoch)</source>
      <translation>在拟合旁点选特征点(前一期)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pick feature points beside the fit (later epoch)</source>
      <translation>在拟合旁点选特征点(后一期)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Placeholder for a unit not found</source>
      <translation>未找到块体的占位</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Merge the two selected units</source>
      <translation>合并选中的两个块体</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Split at the later epoch: two units taken for one</source>
      <translation>在后一期拆分:两个块体被当成一个</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Delete: not a unit</source>
      <translation>删除:不是块体</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Take back the last correction</source>
      <translation>撤回最后一次修正</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Read the points around the units…</source>
      <translation>读取块体周围的点…</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The points around the units are needed: read them from the correction menu.</source>
      <translation>需要块体周围的点:请从修正菜单读取。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>There are no points here; click on the cloud.</source>
      <translation>此处没有点;请单击点云。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The unit has no pose in any epoch to take its size from.</source>
      <translation>该块体在任何一期都没有位姿,无法得知其大小。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>pinned by three joints</source>
      <translation>用三个交汇点固定</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The unit was not found in this epoch: pin it by three joints instead.</source>
      <translation>本期未找到该块体:请改用三个交汇点固定。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Select the two units to merge.</source>
      <translation>请选择要合并的两个块体。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>There is no correction to take back.</source>
      <translation>没有可撤回的修正。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Reading points around units</source>
      <translation>正在读取块体周围的点</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Points read.</source>
      <translation>点已读取。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Select a unit first.</source>
      <translation>请先选择一个块体。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click the middle of the unit on the map or in a view; Escape ends.</source>
      <translation>在地图或视图中单击块体中部;Escape 结束。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click three joints where three legs meet, on the map or in the views; Escape ends.</source>
      <translation>在地图或视图中单击三条腿相交的三个交汇点;Escape 结束。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click a joint where three legs meet; Escape ends.</source>
      <translation>单击三条腿相交的一个交汇点;Escape 结束。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click where the unit lies on the map; Escape ends.</source>
      <translation>在地图上单击块体所在位置;Escape 结束。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fitting {unit} again</source>
      <translation>正在重新拟合 {unit}</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} was fitted again.</source>
      <translation>{unit} 已重新拟合。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} pinned; the picks fit within {length}.</source>
      <translation>{unit} 已固定;点选在 {length} 以内相符。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{feature} picked, {length} from the fit.</source>
      <translation>已点选 {feature},距拟合 {length}。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Placeholder {name} stored; it counts as a unit not found.</source>
      <translation>占位 {name} 已保存;计为未找到的块体。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{count} of 3 joints.</source>
      <translation>3 个交汇点中的 {count} 个。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{other} is now {keep}.</source>
      <translation>{other} 现为 {keep}。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} is called {name} from {epoch} on.</source>
      <translation>{unit} 自 {epoch} 起称为 {name}。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} was deleted; take it back from the correction menu.</source>
      <translation>{unit} 已删除;可从修正菜单撤回。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Taken back: {kind} {unit}.</source>
      <translation>已撤回:{kind} {unit}。</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Check point</source>
      <translation>检查点</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Feature</source>
      <translation>特征点</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Surveyed</source>
      <translation>实测</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Fitted</source>
      <translation>拟合</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Difference</source>
      <translation>差值</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>3D displacement</source>
      <translation>三维位移</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>in heights H, in Dn</source>
      <translation>以高度 H、Dn 表示</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Easting</source>
      <translation>东</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Northing</source>
      <translation>北</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Height</source>
      <translation>高程</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Horizontal</source>
      <translation>水平</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>significant</source>
      <translation>显著</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>not significant</source>
      <translation>不显著</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Detection limit</source>
      <translation>探测限</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Seen</source>
      <translation>可见</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Score</source>
      <translation>得分</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Legs seen</source>
      <translation>可见的腿</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{shown} of {all} units shown</source>
      <translation>显示 {all} 个块体中的 {shown} 个</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} significant</source>
      <translation>{count} 个显著</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} decided</source>
      <translation>{count} 个已决定</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} rejected, excluded from statistics and map</source>
      <translation>{count} 个被否决,不计入统计和地图</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Displacement</source>
      <translation>位移</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>none: one of the two positions is not known</source>
      <translation>无:两个位置之一未知</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Rotation</source>
      <translation>转动</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Test against no motion</source>
      <translation>对无运动的检验</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Check points ({unit})</source>
      <translation>检查点({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Nobody has decided on this unit yet.</source>
      <translation>尚无人对该块体作出决定。</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} lost</source>
      <translation>{count} 个消失</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} new</source>
      <translation>{count} 个新增</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>largest {length}</source>
      <translation>最大 {length}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>taken back</source>
      <translation>已撤回</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Picked by hand</source>
      <translation>手工点选</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{feature}, {epoch}: picked {length} from the fit ({who})</source>
      <translation>{feature},{epoch}:点选距拟合 {length}({who})</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Displacement review</source>
      <translation>位移审核</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Open a result</source>
      <translation>打开结果</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>GeoPackage (*.gpkg)</source>
      <translation>GeoPackage (*.gpkg)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Previous unit (Up, or P for the previous undecided)</source>
      <translation>上一个块体(↑,或 P 跳到上一个未决定的)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Next unit (Down, or N for the next undecided)</source>
      <translation>下一个块体(↓,或 N 跳到下一个未决定的)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Zoom to the unit and flash it (Z)</source>
      <translation>缩放到块体并闪烁(Z)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The map follows the selection</source>
      <translation>地图跟随选择</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Show all units</source>
      <translation>显示所有块体</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Correct a unit</source>
      <translation>修正块体</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Write the report…</source>
      <translation>编写报告…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Export the alarm list…</source>
      <translation>导出警报清单…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>PDF (*.pdf);;Web page (*.html)</source>
      <translation>PDF (*.pdf);;网页 (*.html)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Alarm list</source>
      <translation>警报清单</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Threshold (cm)</source>
      <translation>阈值(厘米)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>CSV (*.csv);;GeoJSON (*.geojson)</source>
      <translation>CSV (*.csv);;GeoJSON (*.geojson)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Decisions of another reviewer were taken in.</source>
      <translation>已采纳另一审核人的决定。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>In polygons</source>
      <translation>在多边形内</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>No unit passes the filter.</source>
      <translation>没有块体通过筛选。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Confirmed.</source>
      <translation>已确认。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Writing the report</source>
      <translation>正在编写报告</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Make a polygon layer active first.</source>
      <translation>请先激活一个多边形图层。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>In the map window</source>
      <translation>在地图窗口内</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Everywhere</source>
      <translation>全部</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{title}…</source>
      <translation>{title}…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{name} is read-only: you can look, but decisions cannot be stored.</source>
      <translation>{name} 为只读:可以查看,但不能保存决定。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{units}: {decision}, stored.</source>
      <translation>{units}:{decision},已保存。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Taken back: {units}.</source>
      <translation>已撤回:{units}。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Report written to {name}.</source>
      <translation>报告已写入 {name}。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{count} units written to {name}.</source>
      <translation>{count} 个块体已写入 {name}。</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Units reviewed</source>
      <translation>已审核的块体</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements reviewed</source>
      <translation>已审核的位移</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements reviewed, other pair or datum</source>
      <translation>已审核的位移,其他期对或基准</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Rejected units (excluded)</source>
      <translation>被否决的块体(排除)</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacement review: {name}</source>
      <translation>位移审核:{name}</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Open the result.gpkg of a survey with two epochs or more to review its displacements.</source>
      <translation>打开两期或以上测量的 result.gpkg 以审核其位移。</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Open result…</source>
      <translation>打开结果…</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Epochs compared</source>
      <translation>比较的期次</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Reference of the displacements</source>
      <translation>位移的基准</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>All classes</source>
      <translation>所有类别</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Classes shown</source>
      <translation>显示的类别</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Least 3D displacement shown; lost, new and relocated units are always shown</source>
      <translation>显示的最小三维位移;消失、新增和移位的块体始终显示</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Area of the units shown</source>
      <translation>显示块体的区域</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Undecided only</source>
      <translation>仅未决定</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Unit…</source>
      <translation>块体…</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Comment, stored with the decision</source>
      <translation>与决定一起保存的备注</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Reviewer</source>
      <translation>审核人</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Your name or initials, stored with every decision</source>
      <translation>您的姓名或缩写,与每个决定一起保存</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>In the active layer's polygons</source>
      <translation>在活动图层的多边形内</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Accept</source>
      <translation>接受</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The displacement is right (A)</source>
      <translation>位移正确(A)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Reject</source>
      <translation>否决</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The displacement is wrong: it leaves statistics, maps and report (R)</source>
      <translation>位移错误:不计入统计、地图和报告(R)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Inspect</source>
      <translation>检查</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Inspect on site (I)</source>
      <translation>现场检查(I)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Confirm</source>
      <translation>确认</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Confirm another reviewer's decision (C)</source>
      <translation>确认另一审核人的决定(C)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Undo</source>
      <translation>撤销</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Take back your last decision (U)</source>
      <translation>撤回您的最后一个决定(U)</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Plan</source>
      <translation>平面</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Select a unit</source>
      <translation>请选择一个块体</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>N</source>
      <translation>N</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>No displacement of this unit</source>
      <translation>该块体没有位移</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>centre</source>
      <translation>中心</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Section {azimuth}°</source>
      <translation>剖面 {azimuth}°</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>3D displacement ({unit})</source>
      <translation>三维位移({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>detection limit</source>
      <translation>探测限</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Series</source>
      <translation>序列</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Section along the displacement</source>
      <translation>沿位移的剖面</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Direction of the section, from grid north; each outline is cut through its own centre</source>
      <translation>剖面方向,自坐标北起;每个轮廓在各自中心处剖切</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Numbers</source>
      <translation>数值</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>History</source>
      <translation>历史</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>points not read yet</source>
      <translation>点尚未读取</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>stable</source>
      <translation>稳定</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>moved</source>
      <translation>移动</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>rotated</source>
      <translation>转动</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>lost</source>
      <translation>消失</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>unseen</source>
      <translation>不可见</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>deleted</source>
      <translation>已删除</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>merged</source>
      <translation>已合并</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>split</source>
      <translation>已拆分</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>new pose</source>
      <translation>新位姿</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>placeholder</source>
      <translation>占位</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Unit</source>
      <translation>块体</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Class</source>
      <translation>类别</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Displ.</source>
      <translation>位移</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Horiz.</source>
      <translation>水平</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Vert.</source>
      <translation>竖直</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Rot.</source>
      <translation>转动</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>p</source>
      <translation>p</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Decision</source>
      <translation>决定</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Name of the unit, the same in all epochs</source>
      <translation>块体名称,各期相同</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Class of the displacement, or the unit's fate</source>
      <translation>位移的类别,或块体的去向</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Rotation between the epochs (degrees)</source>
      <translation>两期之间的转动(度)</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Probability of so large a displacement if the unit stood still; bold where significant</source>
      <translation>块体静止时出现如此大位移的概率;显著时为粗体</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Share of the unit's surface that holds points, in the worse epoch</source>
      <translation>块体表面有点部分的比例,取较差的一期</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Decision of the reviewers</source>
      <translation>审核人的决定</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Who decided, and ✓ who confirmed</source>
      <translation>谁作出决定,✓ 谁确认</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>accepted</source>
      <translation>接受</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>rejected</source>
      <translation>否决</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>inspect</source>
      <translation>检查</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>stable units and control</source>
      <translation>稳定块体与控制</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>control points alone</source>
      <translation>仅控制点</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>decided</source>
      <translation>决定</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>confirmed</source>
      <translation>确认</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>took back</source>
      <translation>撤回</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>3D displacement of the centre ({unit})</source>
      <translation>中心的三维位移({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Horizontal displacement of the centre ({unit})</source>
      <translation>中心的水平位移({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Vertical displacement of the centre, positive up ({unit})</source>
      <translation>中心的竖直位移,向上为正({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Monitor a survey…</source>
      <translation>监测测量…</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Comparison with surveyed check points</source>
      <translation>与实测检查点比较</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Picked by hand (cm)</source>
      <translation>手工点选(厘米)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Fitting (cm)</source>
      <translation>拟合(厘米)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Surveyed (cm)</source>
      <translation>实测(厘米)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Error, picked (cm)</source>
      <translation>误差,点选(厘米)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Error, fitting (cm)</source>
      <translation>误差,拟合(厘米)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>3D displacements of the same feature point, in the control frame (after Chan and Lichti, Table 1).</source>
      <translation>同一特征点的三维位移,控制坐标系(仿 Chan and Lichti 表 1)。</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>The survey has no check points that both epochs share.</source>
      <translation>测量没有两期共有的检查点。</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Survey control</source>
      <translation>测量控制</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Congruence of the stable units</source>
      <translation>稳定块体的叠合性</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Units that stand still together: {stable} of {all}; test of their congruence: p {p}.</source>
      <translation>共同静止的块体:{all} 个中 {stable} 个;叠合检验:p {p}。</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Their common motion against the control points: east {e}, north {n}, up {h} cm; p {p}.</source>
      <translation>它们相对控制点的共同运动:东 {e}、北 {n}、上 {h} 厘米;p {p}。</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Point</source>
      <translation>点</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>East (mm)</source>
      <translation>东(毫米)</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>North (mm)</source>
      <translation>北(毫米)</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Height (mm)</source>
      <translation>高程(毫米)</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Use</source>
      <translation>使用</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>disturbed, left out</source>
      <translation>受扰动,已剔除</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Residuals of the registration; w is the largest normalised residual of the three coordinates.</source>
      <translation>配准残差;w 为三个坐标标准化残差的最大值。</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>There is no survey control: displacements are relative to the frame of the clouds.</source>
      <translation>没有测量控制:位移相对于点云的坐标系。</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Damage</source>
      <translation>损坏</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>H = {height} m, Dn = {diameter} m. Lost and relocated units count as displaced by every threshold.</source>
      <translation>H = {height} m,Dn = {diameter} m。消失和移位的块体在每个阈值下都计为位移。</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Displaced by at least</source>
      <translation>位移至少</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Threshold (m)</source>
      <translation>阈值(米)</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Share</source>
      <translation>比例</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>over {width} m: units displaced by one Dn or more, relocated or lost, per Dn of width (van der Meer, 1988).</source>
      <translation>{width} m 范围内:位移一个 Dn 以上、移位或消失的块体数,每 Dn 宽度(van der Meer, 1988)。</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Sections along the axis</source>
      <translation>沿轴线的区段</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Share of displaced units per section</source>
      <translation>各区段位移块体的比例</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Chainage (m)</source>
      <translation>里程(米)</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>No unit has a displacement to show.</source>
      <translation>没有块体有可显示的位移。</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Decisions and corrections</source>
      <translation>决定与修正</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Confirmed by</source>
      <translation>确认人</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Comment</source>
      <translation>备注</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>inspect on site</source>
      <translation>现场检查</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>No reviewer has decided on this epoch pair.</source>
      <translation>尚无审核人对该期对作出决定。</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Correction</source>
      <translation>修正</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>By</source>
      <translation>执行人</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Map of displacements</source>
      <translation>位移图</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Displacement of the units' centres.</source>
      <translation>块体中心的位移。</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Histogram of displacements</source>
      <translation>位移直方图</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Displacements of all units with the thresholds of the next section.</source>
      <translation>所有块体的位移及下一节的阈值。</translation>
    </message>
    <message>
      <location filename="../core/section_map.html" />
      <source>Map of the units by class</source>
      <translation>按类别的块体图</translation>
    </message>
    <message>
      <location filename="../core/section_map.html" />
      <source>Units by class and control points; coordinates in {crs}.</source>
      <translation>按类别的块体和控制点;坐标系 {crs}。</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Method, settings and versions</source>
      <translation>方法、设置和版本</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Units are found in the point cloud as four cones with a common centre, adjusted to their points (Gauss-Helmert model), and brought into the frame of the survey control; displacements are differences of the feature points that follow from the adjusted model, tested against their covariance (after Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds).</source>
      <translation>在点云中以四个共中心的圆锥找出块体,平差到其点上(高斯-赫尔默特模型),并转到测量控制坐标系;位移是平差模型导出的特征点之差,按其协方差检验(仿 Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds)。</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Time</source>
      <translation>时间</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>σ0 of the registration</source>
      <translation>配准的 σ0</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Software</source>
      <translation>软件</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Settings</source>
      <translation>设置</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Written {moment} by {software}.</source>
      <translation>由 {software} 写于 {moment}。</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Quality of the units</source>
      <translation>块体质量</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Uncertain units</source>
      <translation>不确定的块体</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Points to surface, median (mm)</source>
      <translation>点到表面距离中位数（mm）</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Largest overlap</source>
      <translation>最大重叠</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Pairs too close</source>
      <translation>距离过近的对</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Overlap is the share of a unit's volume inside another one; two solid units cannot overlap, nor can their centres come closer than half a height. A gap is a place where a unit is likely missing in the result; the layer gaps shows them.</source>
      <translation>重叠是块体体积中位于另一块体内部的比例；两个实体块体不可能重叠，其中心距离也不可能小于高度的一半。缺失位置是结果中很可能缺少块体的地方，见图层 gaps。</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>The result was made by a version that did not state the quality of its units.</source>
      <translation>该结果由不记录块体质量的版本生成。</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Summary</source>
      <translation>摘要</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units judged</source>
      <translation>已评定的块体</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Significant displacements</source>
      <translation>显著位移</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Lost</source>
      <translation>消失</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Relocated</source>
      <translation>移位</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>New</source>
      <translation>新增</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Not seen in the later epoch</source>
      <translation>后一期不可见</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Displaced by 5 cm or more</source>
      <translation>位移 5 厘米或以上</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Displaced by 10 cm or more</source>
      <translation>位移 10 厘米或以上</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Decided by reviewers</source>
      <translation>审核人已决定</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Rejected by reviewers</source>
      <translation>审核人已否决</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units known to be missing</source>
      <translation>已知缺失的块体</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Completeness</source>
      <translation>完整性</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units rejected by reviewers and left out of all figures, maps and tables below: {count}.</source>
      <translation>被审核人否决并从以下所有数值、地图和表中排除的块体:{count}。</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units that no reviewer has decided on yet: {count}.</source>
      <translation>尚无审核人决定的块体:{count}。</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>Units with the largest displacements</source>
      <translation>位移最大的块体</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>East {e}, north {n}, up {h} cm; rotation {turn}; p {p}</source>
      <translation>东 {e}、北 {n}、上 {h} 厘米;转动 {turn};p {p}</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>Plan and section of {unit}</source>
      <translation>{unit} 的平面和剖面</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>Series of {unit}</source>
      <translation>{unit} 的序列</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>No displacement is significant.</source>
      <translation>没有显著位移。</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>control used</source>
      <translation>已使用的控制点</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>control not used</source>
      <translation>未使用的控制点</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>arrows: significant horizontal displacements, enlarged {scale} times</source>
      <translation>箭头:显著水平位移,放大 {scale} 倍</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>3D displacement (cm)</source>
      <translation>三维位移(厘米)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>all units</source>
      <translation>所有块体</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>units</source>
      <translation>块体数</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>plan</source>
      <translation>平面</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>section {azimuth}°</source>
      <translation>剖面 {azimuth}°</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>chainage along the axis (m)</source>
      <translation>沿轴线里程(米)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>units ≥ 10 cm (%)</source>
      <translation>≥ 10 厘米的块体(%)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>easting (m)</source>
      <translation>东坐标(米)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>northing (m)</source>
      <translation>北坐标(米)</translation>
    </message>
  </context>
</TS>
