<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja_JP" sourcelanguage="en">
  <context>
    <name>tetratrack</name>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Units at the common centre of their cones, with orientation, standard deviations (m, degrees), score and status.</source>
      <translation>円錐の共通中心に置かれたブロック。姿勢、標準偏差(m、度)、スコア、状態を含む。</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Centre and the four joints of three cones (f123, f124, f134, f234) of every unit, with covariance (m, m²).</source>
      <translation>各ブロックの中心と3つの円錐の接合点4点(f123、f124、f134、f234)。共分散(m、m²)付き。</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Displacement of every feature point between consecutive epochs (m), with test statistic and class.</source>
      <translation>連続する時期間の各特徴点の変位(m)。検定統計量と区分付き。</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Residuals at the control points (m), with normalised residual; disturbed points are marked.</source>
      <translation>基準点の残差(m)と標準化残差。乱れた点には印を付ける。</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Feature points less surveyed check points (m).</source>
      <translation>特徴点から検証点の測量値を引いた差(m)。</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Monitoring</source>
      <translation>モニタリング</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Single steps</source>
      <translation>個別ステップ</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Planning and simulation</source>
      <translation>計画とシミュレーション</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Inputs and outputs</source>
      <translation>入力と出力</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Limits</source>
      <translation>限界</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>The engine's result holds no layer {layer}.</source>
      <translation>エンジンの結果にレイヤ {layer} がありません。</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Numbers for models</source>
      <translation>モデル用の数値</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Compare with design</source>
      <translation>設計との比較</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Compares the units of one epoch with a placement plan and with a design profile: deviation and turn of every unit, places without a unit, distance from the design surface, and whether that is within the tolerance.</source>
      <translation>ある時期のブロックを据付計画および設計断面と比較します: 各ブロックの偏差と回転、ブロックのない位置、設計面からの距離、および許容差内かどうか。</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>A unit stands at the place of its own name, or at the nearest free one within one height H. Within or outside is said where the standard deviations leave no doubt of 5 % or more, open where they do.</source>
      <translation>ブロックは同じ名前の位置、または高さ H 以内で最も近い空き位置に対応させます。標準偏差により 5 % 以上の疑いが残らない場合に内または外と判定し、残る場合は未定とします。</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>design,plan,placement,profile,tolerance,as-built,DXF</source>
      <translation>設計,計画,据付,断面,許容差,出来形,DXF</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>GeoPackage with the layers plan_deviations, plan_unmatched and profile_deviations, those that were asked for.</source>
      <translation>レイヤ plan_deviations、plan_unmatched、profile_deviations のうち求めたものを含む GeoPackage。</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Deviations</source>
      <translation>偏差</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Units outside the tolerance of the plan</source>
      <translation>計画の許容差を超えるブロック</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Planned places without a unit</source>
      <translation>ブロックのない計画位置</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Units outside the tolerance of the profile</source>
      <translation>断面の許容差を超えるブロック</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Cross-sections and crest</source>
      <translation>横断面と天端</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Cuts the structure across its axis: outlines of the blocks of every epoch, surface of the points and design in each section, height and width of the crest of each reach, and settlement along the structure.</source>
      <translation>構造物を軸に直交して切断します: 各断面での全時期のブロック輪郭、点群の表面と設計、区間ごとの天端の高さと幅、構造物に沿う沈下。</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Points are those read around the units for the review (unit-points); without them sections show blocks alone.</source>
      <translation>点は確認のためにブロック周辺から読んだもの(unit-points)です。なければ断面はブロックのみを示します。</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>profile,section,crest,settlement,chainage</source>
      <translation>縦断,断面,天端,沈下,測点</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>GeoPackage with the layers sections, crest and settlement.</source>
      <translation>レイヤ sections、crest、settlement を含む GeoPackage。</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Sections</source>
      <translation>断面</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Label of an epoch; empty for both takes the latest pair.</source>
      <translation>エポックのラベル。両方とも空なら最新の組を使います。</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Displacement report</source>
      <translation>変位報告書</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Writes the report of a result as reviewed so far: summary, control quality, displacement map and table, worst units, damage figures, method, settings and versions.</source>
      <translation>現時点の照査結果に基づく報告書を作成する:要約、基準点の品質、変位図と表、変位の大きいブロック、被災指標、手法、設定、バージョン。</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Rejected units are left out of the statistics and listed apart. PDF needs the library weasyprint in the engine.</source>
      <translation>棄却したブロックは統計から除き、別に一覧する。PDFにはエンジンのライブラリ weasyprint が必要。</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>report,HTML,PDF,damage,displacement</source>
      <translation>報告書,HTML,PDF,被災,変位</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>that of the result</source>
      <translation>結果のもの</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>stable units and control</source>
      <translation>安定ブロックと基準点</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>control points alone</source>
      <translation>基準点のみ</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>What the displacements are stated against, in all of the report.</source>
      <translation>報告書全体で変位の基準とするもの。</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Places easting,northing along it, separated by blanks; damage is then stated by sections.</source>
      <translation>構造物に沿った「東距,北距」の点を空白で区切って並べます。被害は区間ごとに示されます。</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>0.09, 0.30 and 0.61 m (US Army Corps of Engineers)</source>
      <translation>0.09、0.30、0.61 m(米国陸軍工兵隊)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>5 and 10 cm</source>
      <translation>5 cm と 10 cm</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>0.5 and 1 Dn (nominal diameter)</source>
      <translation>0.5 Dn と 1 Dn(公称径)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Limits by which the units are counted that moved.</source>
      <translation>移動したブロックを数える区分の境界。</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>So many of those that moved most get views, series and decisions of their own.</source>
      <translation>最も動いたもののうちこの数だけ、個別の図、時系列、判定を示します。</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>HTML in one file, or PDF; the ending decides.</source>
      <translation>1ファイルの HTML または PDF。拡張子で決まる。</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Earlier epoch</source>
      <translation>前のエポック</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Later epoch</source>
      <translation>後のエポック</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Reference of the displacements</source>
      <translation>変位の基準</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Axis of the structure</source>
      <translation>構造物の軸線</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length looked at (m)</source>
      <translation>対象とする長さ (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of the structure in metres, for the damage number N_od.</source>
      <translation>被害数 N_od のための構造物の長さ（メートル）。</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of a section (m)</source>
      <translation>区間の長さ (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of the sections along the axis, in metres.</source>
      <translation>軸線に沿った区間の長さ（メートル）。</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Movement bands</source>
      <translation>変位の階級</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Units shown one by one</source>
      <translation>個別に示すブロック数</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Report</source>
      <translation>報告書</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Give both epochs, or neither for the latest pair.</source>
      <translation>エポックを両方指定するか、両方とも空にして最新の組を使ってください。</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Export as-built model</source>
      <translation>出来形モデルの書き出し</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Writes the units of one epoch as bodies at their fitted poses, coloured by class, with uncertainty and movement as properties, for CAD, BIM and 3D viewers. The ending of the file chooses the format: glTF (.glb), Wavefront (.obj), DXF, IFC4x3 or the poses alone (.json).</source>
      <translation>1 時期のブロックを推定した姿勢の立体として書き出します。区分ごとに色分けし、不確かさと変位を属性に持ち、CAD、BIM、3D ビューアで使えます。形式はファイルの拡張子で決まります: glTF (.glb)、Wavefront (.obj)、DXF、IFC4x3、または姿勢のみ (.json)。</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Bodies have 24 plane faces a leg. glTF, OBJ, IFC and JSON hold coordinates less a reduction point that stands in the file; DXF holds coordinates of the survey CRS and needs the library ezdxf in the engine.</source>
      <translation>立体は脚ごとに 24 の平面を持ちます。glTF、OBJ、IFC、JSON の座標はファイル内に記した基準点からの差です。DXF は測量の CRS の座標を持ち、エンジンにライブラリ ezdxf が必要です。</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>model,3D,glTF,GLB,OBJ,DXF,IFC,BIM,CAD,as-built</source>
      <translation>モデル,3D,glTF,GLB,OBJ,DXF,IFC,BIM,CAD,出来形</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Label of the epoch whose units are written; the latest one with units unless given.</source>
      <translation>ブロックを書き出す時期のラベル。指定しなければブロックのある最新の時期。</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>File to write; its ending decides the format.</source>
      <translation>書き出すファイル。拡張子が形式を決めます。</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Model</source>
      <translation>モデル</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Extract feature points</source>
      <translation>特徴点の抽出</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Derives the centre and the four points where three cone surfaces meet on the outside of each unit, with the covariance carried over from the fit. These points can be surveyed by total station as well.</source>
      <translation>各ブロックの中心と、外側で3つの円錐面が交わる4点を求め、当てはめの共分散を伝播する。これらの点はトータルステーションでも測量できる。</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>A joint is marked as observed only where points lie next to it; otherwise it follows from the rest of the unit.</source>
      <translation>接合点は、すぐ近くに点がある場合だけ「観測」とし、それ以外はブロックの残りの部分から導く。</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>feature points,cone intersection,centre,covariance propagation</source>
      <translation>特徴点,円錐の交点,中心,共分散伝播</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Layer of units from Fit tetrapods or Monitor a survey.</source>
      <translation>「テトラポッドの当てはめ」または「測量のモニタリング」のブロックレイヤ。</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Points d1 to d4, which crews can measure and paint.</source>
      <translation>点 d1~d4。現場で測定や塗装ができます。</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>From the centre to the end disc, in metres; empty takes 0.644 H.</source>
      <translation>中心から端面まで(メートル)。空なら 0.644 H。</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Fitted units</source>
      <translation>当てはめたブロック</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Centres of the end discs as well</source>
      <translation>端面円の中心も</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Leg length (m)</source>
      <translation>脚の長さ(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Points</source>
      <translation>点</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Fit tetrapods</source>
      <translation>テトラポッドの当てはめ</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Fits four equal cones that share a centre to the points of each unit by an iterated Gauss–Helmert adjustment with robust weights, end discs and removal of the curvature bias; gives pose, radius, taper and their covariance.</source>
      <translation>中心を共有する4つの等しい円錐を、各ブロックの点に反復ガウス・ヘルマート調整で当てはめる。ロバスト重み、端面、曲率による偏りの除去を含み、姿勢、半径、テーパーとその共分散を与える。</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>With one visible leg the twist about its axis is undetermined: the unit says so in its large standard deviation.</source>
      <translation>見える脚が1本だけの場合、軸まわりの回転は決まらない。大きな標準偏差がそれを示す。</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>adjustment,Gauss-Helmert,least squares,cone,pose,covariance</source>
      <translation>調整計算,ガウス・ヘルマート,最小二乗法,円錐,姿勢,共分散</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Layer of units from Segment tetrapods, with the fields qx, qy, qz, qw of their orientation.</source>
      <translation>「テトラポッドの分割」のブロックレイヤ。姿勢のフィールド qx、qy、qz、qw を含む。</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Units found</source>
      <translation>検出したブロック</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Units fitted</source>
      <translation>当てはめたブロック数</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Inspect tiles</source>
      <translation>タイルの点検</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Lists point cloud tiles with their extent, CRS, number and density of points and range of heights. Run it first: it shows missing CRS, gaps, overlaps and tiles too thin to find units in.</source>
      <translation>点群タイルの範囲、座標系、点数、密度、高さの範囲を一覧する。最初に実行すると、座標系の欠落、隙間、重複、点が少なすぎるタイルが分かる。</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Reads headers and a sample of points; a damaged tile is named and ends the run.</source>
      <translation>ヘッダと点の一部を読む。壊れたタイルがあれば名前を示して終了する。</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>point cloud,LAS,LAZ,tile index,density,CRS,extent</source>
      <translation>点群,LAS,LAZ,タイル索引,密度,座標系,範囲</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>One rectangle per tile with file, CRS, points, density (points/m²) and heights (m).</source>
      <translation>タイルごとに1つの矩形。ファイル、座標系、点数、密度(点/m²)、高さ(m)を持つ。</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Tile index</source>
      <translation>タイル索引</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Tiles</source>
      <translation>タイル数</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Median density (points/m²)</source>
      <translation>密度の中央値(点/m²)</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>CRS of the tiles</source>
      <translation>タイルの座標系</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Monitor a survey</source>
      <translation>測量のモニタリング</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>All steps at once: registers every epoch to survey control, finds the tetrapods, fits four cones that share a centre, derives feature points and tests their displacements. Give a survey.toml, or the epochs and the unit.</source>
      <translation>全ステップを一度に行う:各時期を基準点に登録し、テトラポッドを見つけ、中心を共有する4つの円錐を当てはめ、特徴点を導いて変位を検定する。survey.toml、または時期とブロックを指定する。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Units of which less than about 5 % is seen are not found. Without control the cloud's own frame is used, and the result says so.</source>
      <translation>見えている部分が約5 %未満のブロックは見つからない。基準点がなければ点群自身の座標系を使い、結果にその旨を示す。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>tetrapod,armour unit,breakwater,displacement,monitoring,LAS,LAZ,deformation</source>
      <translation>テトラポッド,消波ブロック,防波堤,変位,モニタリング,LAS,LAZ,変形</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>A survey.toml; if given, it states everything, and the fields for epochs, unit, CRS and area are not used.</source>
      <translation>survey.toml。指定するとこれがすべてを決め、時期、ブロック、座標系、範囲の欄は使わない。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Label</source>
      <translation>名前</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Time (UTC)</source>
      <translation>時刻(UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Control points</source>
      <translation>基準点</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Targets in the cloud</source>
      <translation>点群中のターゲット</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Check points</source>
      <translation>検証点</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Epochs</source>
      <translation>時期</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>One row per epoch: label, time such as 2025-03-14T02:30, folder or files of tiles (separated by ;), CSV files or layers.</source>
      <translation>時期ごとに1行:名前、2025-03-14T02:30 のような時刻、タイルのフォルダまたはファイル(; で区切る)、CSV ファイルまたはレイヤ。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Writes a top view of each epoch as GeoTIFF beside the result, as a backdrop.</source>
      <translation>各時期の平面図を背景用の GeoTIFF として結果の隣に書き出す。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Adds all layers to the project as a group with their styles.</source>
      <translation>全レイヤをスタイル付きのグループとしてプロジェクトに追加する。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>GeoPackage with units, feature points, displacements, residuals, epochs and reviews, in the survey's CRS, times in UTC.</source>
      <translation>ブロック、特徴点、変位、残差、時期、照査を含む GeoPackage。測量の座標系、時刻は UTC。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Survey file</source>
      <translation>測量ファイル</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Shaded relief of each epoch</source>
      <translation>各時期の陰影図</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Load the result</source>
      <translation>結果を読み込む</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Result</source>
      <translation>結果</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Units moved</source>
      <translation>動いたブロック</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>RMSE at check points (m)</source>
      <translation>検証点の RMSE(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Give a survey.toml, or at least one epoch with its tiles.</source>
      <translation>survey.toml、または少なくとも1つの時期とそのタイルを指定してください。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Every epoch needs six columns: label, time, tiles, control points, targets, check points.</source>
      <translation>各時期には6列が必要です:名前、時刻、タイル、基準点、ターゲット、検証点。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{place}: {time} is no time; write it as 2025-03-14, 2025-03-14T02:30 (UTC) or 2025-03-14T11:30+09:00.</source>
      <translation>{place}: {time} は時刻ではありません。2025-03-14、2025-03-14T02:30 (UTC) または 2025-03-14T11:30+09:00 のように書いてください。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{where}: there is no file or layer {path}.</source>
      <translation>{where}:ファイルまたはレイヤ {path} がありません。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{where}: {path} cannot be read as a point layer or CSV file.</source>
      <translation>{where}:{path} は点レイヤまたは CSV ファイルとして読めません。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>The folder {folder} does not exist.</source>
      <translation>フォルダ {folder} がありません。</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Relief {epoch}</source>
      <translation>陰影起伏 {epoch}</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>New survey from a folder</source>
      <translation>フォルダーから新しい測量</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Writes a survey.toml from what the files in a folder say: epochs and times, CRS, control, targets and check points, and the size of the units from the cloud itself.</source>
      <translation>フォルダー内のファイルから survey.toml を書き出します:時期と時刻、CRS、基準点、ターゲット、検証点、そして点群そのものから推定したブロックの大きさ。</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Every value stands with its reason; what the files leave open is asked for in the log.</source>
      <translation>すべての値に根拠を添えます。ファイルから分からないことはログで尋ねます。</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>new survey,folder,tiles,epochs,size of units,survey.toml</source>
      <translation>新しい測量,フォルダー,タイル,時期,ブロックの大きさ,survey.toml</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Folder with the tiles of all epochs; tables of control lie in it or beside it.</source>
      <translation>全時期のタイルを含むフォルダー。基準点の表はその中か隣に置きます。</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Point cloud tiles</source>
      <translation>点群タイル</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Instead of a folder: point cloud layers, or files, of all epochs.</source>
      <translation>フォルダの代わりに、全エポックの点群レイヤまたはファイル。</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Projected CRS in metres; needed only where the tiles declare none.</source>
      <translation>メートル単位の投影 CRS。タイルに CRS がない場合だけ必要です。</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Empty estimates it from the cloud.</source>
      <translation>空の場合は点群から推定します。</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Text file to look through, correct and run.</source>
      <translation>確認し、直して、実行するためのテキストファイル。</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Folder of tiles</source>
      <translation>タイルのフォルダー</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>CRS of the results</source>
      <translation>結果の座標系</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Height of the units (m)</source>
      <translation>ブロックの高さ (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Survey</source>
      <translation>測量</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Give a folder of tiles, or tiles.</source>
      <translation>タイルのフォルダ、またはタイルを指定してください。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Plan a survey: detectable displacement</source>
      <translation>測量計画:検出可能な変位</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Computes which displacement and rotation of a unit a planned survey will find, from point density, noise, visible share and registration: the Cramér–Rao bound of the adjustment for the unit's geometry, and Baarda's detectability.</source>
      <translation>点密度、ノイズ、可視率、登録精度から、計画した測量で検出できるブロックの変位と回転を求める。ブロック形状に対する調整計算のクラメール・ラオ限界と、バールダの検出力による。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>White noise is averaged over the points of a unit; whatever does not average out must be stated as systematic part. The shares of units found are those measured on simulated piles of that density and noise, seen from above.</source>
      <translation>白色ノイズはブロックの点で平均される。平均されないものは系統成分として指定する。検出されるブロックの割合は、その密度とノイズで上から見た模擬の堆積体で測定した値。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>planning,detectability,point density,noise,Cramér-Rao bound,minimal detectable displacement</source>
      <translation>計画,検出可能性,点密度,ノイズ,クラメール・ラオ限界,最小検出変位</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Point density (points/m²)</source>
      <translation>点密度(点/m²)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>On a surface that faces the instrument, all flight strips or stations together.</source>
      <translation>機器に向いた面で、全コースまたは全測点の合計。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Noise of a point (m)</source>
      <translation>点のノイズ(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation along the surface normal, in metres.</source>
      <translation>面の法線方向の標準偏差(メートル)。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Visible share of a unit</source>
      <translation>ブロックの可視率</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share of a unit's surface that holds points, 0 to 1; in a pile 0.05 to 0.5.</source>
      <translation>点のある表面の割合(0〜1)。積み重なった状態では 0.05〜0.5。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Registration (m)</source>
      <translation>登録(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of an epoch's registration at the unit, per coordinate, in metres.</source>
      <translation>ブロック位置における1時期の登録の標準偏差。座標ごと、メートル。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Systematic part (m)</source>
      <translation>系統成分(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Strip offsets, roughness and growth that do not average out, per coordinate, in metres.</source>
      <translation>平均されないコース間のずれ、粗さ、付着生物。座標ごと、メートル。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Line of sight from the vertical (degrees)</source>
      <translation>視線の鉛直からの角度(度)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>0 from the air; about 70 from the crown wall.</source>
      <translation>上空からは 0、天端壁からは約 70。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Calibrated and held; otherwise they are estimated for every unit, which costs accuracy.</source>
      <translation>校正して固定する。そうでなければブロックごとに推定し、精度が下がる。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Level of significance</source>
      <translation>有意水準</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Probability of a false alarm for one unit.</source>
      <translation>1つのブロックで誤警報が出る確率。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Power</source>
      <translation>検出力</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Probability with which the displacement is found.</source>
      <translation>変位が検出される確率。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>What the survey detects over point density and visible share, beside the plan.</source>
      <translation>計画に加え、点密度と可視率ごとに検出できる変位。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Points on a unit</source>
      <translation>ブロックあたりの点数</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of the centre (m)</source>
      <translation>中心の標準偏差(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of the rotation (degrees)</source>
      <translation>回転の標準偏差(度)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of a displacement (m)</source>
      <translation>変位の標準偏差(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable displacement, worst direction (m)</source>
      <translation>検出可能な変位、最悪の方向(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable displacement, mean (m)</source>
      <translation>検出可能な変位、平均(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable rotation (degrees)</source>
      <translation>検出可能な回転(度)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Points per square of a unit's height</source>
      <translation>ブロックの高さの2乗あたりの点数</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 30 % or more</source>
      <translation>30 % 以上見えるブロックの検出割合</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 15–30 %</source>
      <translation>15〜30 % 見えるブロックの検出割合</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 5–15 %</source>
      <translation>5〜15 % 見えるブロックの検出割合</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>The level of significance must be below the power.</source>
      <translation>有意水準は検出力より小さくしてください。</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Radius and taper are known</source>
      <translation>半径とテーパーは既知</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Chart</source>
      <translation>図</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Web page (*.html)</source>
      <translation>ウェブページ (*.html)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>{file} cannot be written: {reason}.</source>
      <translation>{file} に書き込めません：{reason}。</translation>
    </message>
    <message>
      <location filename="../algorithms/provider.py" />
      <source>Tetratrack: displacements of tetrapods</source>
      <translation>Tetratrack:テトラポッドの変位</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Register to control</source>
      <translation>基準点への登録</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Estimates the rigid transformation from an epoch's cloud to survey control from targets, weighted by their standard deviations, and finds disturbed targets by data snooping on normalised residuals.</source>
      <translation>1時期の点群から基準点系への剛体変換を、標準偏差で重み付けしたターゲットから推定し、標準化残差のデータスヌーピングで乱れたターゲットを見つける。</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Needs three targets that do not lie in one line; an outlier is found from four, and named surely from five.</source>
      <translation>一直線上にない3点のターゲットが必要。異常値は4点から見つかり、5点から確実に特定できる。</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>registration,control points,targets,transformation,data snooping,georeferencing</source>
      <translation>登録,基準点,ターゲット,座標変換,データスヌーピング,ジオリファレンス</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>GeoPackage whose table epochs holds the seven parameters and their covariance.</source>
      <translation>表 epochs に7パラメータとその共分散を持つ GeoPackage。</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Registration</source>
      <translation>登録結果</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>RMSE at control points (m)</source>
      <translation>基準点の RMSE(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Disturbed targets</source>
      <translation>乱れたターゲット</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Register views</source>
      <translation>ビューの登録</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Brings overlapping views of a depth camera or scanner stations into the frame of the first by multiway ICP with a pose graph, and writes one cloud in which every view keeps its number as point source id.</source>
      <translation>深度カメラまたはスキャナ測点の重なり合うビューを、ポーズグラフを用いた多方向 ICP で最初のビューの座標系に合わせ、各ビューの番号を点源 ID とする1つの点群を書き出す。</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Views must overlap by a third or more and be roughly aligned; views that do not connect are named.</source>
      <translation>ビューは3分の1以上重なり、おおよそ位置が合っていること。つながらないビューは名前を示す。</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>registration,ICP,pose graph,depth camera,multi-view</source>
      <translation>登録,ICP,ポーズグラフ,深度カメラ,多視点</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Resolution at which views are matched, in metres; empty derives it from the point spacing.</source>
      <translation>ビューを照合する解像度(メートル)。空なら点間隔から決める。</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>One LAZ file in the frame of the first view.</source>
      <translation>最初のビューの座標系の LAZ ファイル1つ。</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Views</source>
      <translation>ビュー</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Voxel size (m)</source>
      <translation>ボクセルの大きさ(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Registered cloud</source>
      <translation>登録した点群</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>RMSE between views (m)</source>
      <translation>ビュー間の RMSE(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Points less blocks</source>
      <translation>点群とブロックの差</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Writes the points around the units of one epoch with their distance to the nearest fitted unit, coloured from blue (10 cm or more within a body) through white to red (10 cm or more outside): what is red is debris, a unit that was missed, or one that is broken.</source>
      <translation>ある時期のブロック周辺の点を、最も近い当てはめブロックまでの距離とともに書き出します。色は青(内部へ 10 cm 以上)から白を経て赤(外側へ 10 cm 以上)。赤い点は破片、見落とされたブロック、または破損したブロックです。</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Points are those read around the units for the review (unit-points), in the control frame. For units lower than 2 m, and models of a tank, colours end at 5 % of the height H instead of 10 cm; points near no unit have the distance 10 m.</source>
      <translation>点は確認のためにブロック周辺から読んだもの(unit-points)で、基準点の座標系にあります。高さ 2 m 未満のブロックや水槽の模型では、色は 10 cm の代わりに高さ H の 5 % で終わります。近くにブロックのない点の距離は 10 m です。</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>residuals,LAZ,LAS,point cloud,distance</source>
      <translation>残差,LAZ,LAS,点群,距離</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Point cloud with the dimensions distance (m) and unit.</source>
      <translation>次元 distance (m) と unit を持つ点群。</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Label of the epoch whose units are looked at; the latest one with units unless given.</source>
      <translation>対象とする時期の名前。指定しなければブロックのある最新の時期。</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Degrees a unit may be turned from its planned orientation.</source>
      <translation>計画方向からの許容回転(度)。</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>GeoPackage written by Monitor a survey.</source>
      <translation>「測量のモニタリング」が書き出した GeoPackage。</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Path of a CSV unit_id,easting,northing,height with the planned centres, optionally qx,qy,qz,qw, or of a layer of points with heights (FILE|layername=NAME).</source>
      <translation>計画中心の CSV unit_id,easting,northing,height(任意で qx,qy,qz,qw)、または高さを持つ点レイヤ(FILE|layername=NAME)のパス。</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of places (m)</source>
      <translation>位置の許容差 (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres a unit may be from its planned place.</source>
      <translation>計画位置からの許容距離(メートル)。</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of turns (°)</source>
      <translation>回転の許容差 (°)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Path of a DXF or of a layer of lines with heights: a single line is a cross-section along the whole structure, several are its edges.</source>
      <translation>DXF または高さを持つ線レイヤのパス。1 本の線は構造物全体に沿う横断面、複数の線はその稜線。</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres a unit may be off the design profile.</source>
      <translation>設計断面からの許容距離(メートル)。</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Places easting,northing along it, separated by blanks; the centreline of the units unless given.</source>
      <translation>軸に沿う位置 easting,northing を空白区切りで。指定しなければブロックの中心線。</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Distance of the sections (m)</source>
      <translation>断面の間隔 (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres along the axis; four heights of a unit unless given.</source>
      <translation>軸に沿うメートル。指定しなければブロック高さの 4 倍。</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Epoch</source>
      <translation>時期</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Placement plan</source>
      <translation>据付計画</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Design profile</source>
      <translation>設計断面</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of the profile (m)</source>
      <translation>断面の許容差 (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>outermost point of a unit</source>
      <translation>ブロックの最外点</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>centre of a unit</source>
      <translation>ブロックの中心</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>What is judged against the design profile; both distances are written.</source>
      <translation>設計断面に対して判定するもの。両方の距離が書き出されます。</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>All files (*.*)</source>
      <translation>すべてのファイル (*.*)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Judged against the profile</source>
      <translation>断面に対する判定対象</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Segment tetrapods</source>
      <translation>テトラポッドの分割</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Finds every tetrapod in a pile: cones from pairs of oriented points, legs that agree on a common centre and on the angles between them, and verification against the visible surface and against empty space.</source>
      <translation>山の中のテトラポッドをすべて見つける:法線付きの点の対から円錐、中心と脚の角度が一致する脚、見える面と空いた空間による検証。</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Units of which less than about 5 % is seen are not found; weak evidence has the status uncertain. Poses are approximate: fit them next.</source>
      <translation>見えている部分が約5 %未満のブロックは見つからない。証拠が弱いものは「不確か」とする。姿勢は概略なので、次に当てはめを行う。</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>segmentation,RANSAC,cone,tetrapod,armour unit,detection</source>
      <translation>分割,RANSAC,円錐,テトラポッド,消波ブロック,検出</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Simulate a survey</source>
      <translation>測量のシミュレーション</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Writes a simulated survey of a tetrapod slope with known poses: LAZ tiles, control, check points and survey.toml. Use it to try the chain, to train, or to test a planned density and noise.</source>
      <translation>姿勢が既知のテトラポッド斜面の模擬測量を書き出す:LAZ タイル、基準点、検証点、survey.toml。手順の試行、練習、計画した密度とノイズの確認に使う。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Simulated surfaces are cleaner than real ones; judge a plan with some reserve.</source>
      <translation>模擬の表面は実物よりきれいなので、計画は余裕をもって判断する。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>simulation,synthetic,ground truth,test data</source>
      <translation>シミュレーション,合成,真値,試験データ</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>UAV laser scanner</source>
      <translation>UAV レーザスキャナ</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>terrestrial laser scanner</source>
      <translation>地上レーザスキャナ</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>photogrammetry</source>
      <translation>写真測量</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>depth camera</source>
      <translation>深度カメラ</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Decides viewpoints, hidden parts and, unless stated, noise and density.</source>
      <translation>視点、隠れる部分、指定がなければノイズと密度を決める。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Number of units on the slope.</source>
      <translation>斜面上のブロックの数。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Number of surveys; some units move between them.</source>
      <translation>測量の回数。その間に一部のブロックが動く。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Standard deviation of the range, in metres; empty takes that of the instrument.</source>
      <translation>距離の標準偏差(メートル)。空なら機器の値を使う。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>On the ground; empty takes that of the instrument.</source>
      <translation>地面上の密度。空なら機器の値を使う。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>A coast of this length, of stretches that hold the number of units each; empty gives one site.</source>
      <translation>この長さの海岸を、それぞれ指定個数のブロックを持つ区間から作ります。空欄なら一つの現場です。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Error of the trajectory along the site in metres, root mean square of each coordinate; empty for none.</source>
      <translation>現場に沿った軌跡の誤差(メートル、各座標の二乗平均平方根)。空欄ならなし。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>The same seed gives the same survey.</source>
      <translation>同じシードからは同じ測量ができる。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Receives tiles, CSV files, survey.toml and truth.</source>
      <translation>タイル、CSV ファイル、survey.toml、真値を受け取る。</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Instrument</source>
      <translation>機器</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Units</source>
      <translation>ブロック</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Length of a coast (m)</source>
      <translation>海岸の長さ (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Bend of every epoch (m)</source>
      <translation>各時期のたわみ (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Seed</source>
      <translation>シード</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Survey folder</source>
      <translation>測量フォルダ</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>survey.toml of the simulated survey</source>
      <translation>模擬測量の survey.toml</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>The tetratrack engine is not installed: open Settings &gt; Options &gt; Tetratrack and create its environment or choose one.</source>
      <translation>tetratrack エンジンがインストールされていません。設定 &gt; オプション &gt; Tetratrack を開き、環境を作成するか選択してください。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>Create or choose the engine…</source>
      <translation>エンジンを作成または選択…</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>Make the environment again…</source>
      <translation>環境を作り直す…</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>The engine ended unexpectedly (exit code {code}); QGIS and your data are unharmed.</source>
      <translation>エンジンが予期せず終了しました(終了コード {code})。QGIS とデータは無事です。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>QGIS runs version {plugin} of the plugin, but its files are of version {engine}: restart QGIS.</source>
      <translation>QGIS ではプラグインのバージョン {plugin} が動いていますが、ファイルはバージョン {engine} です。QGIS を再起動してください。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>The engine could not be started with {python}: {reason}.</source>
      <translation>{python} でエンジンを起動できませんでした:{reason}。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/environment.py" />
      <source>The tetratrack engine was made for another version of the plugin: let it be brought up to date in Settings &gt; Options.</source>
      <translation>tetratrack エンジンは別のバージョンのプラグイン用に作られています。設定 &gt; オプション で更新してください。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/environment.py" />
      <source>The Python that the tetratrack engine was made with is gone: let its environment be made again in Settings &gt; Options.</source>
      <translation>tetratrack エンジンの作成に使われた Python がなくなっています。設定 &gt; オプション で環境を作り直してください。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Unit</source>
      <translation>ブロック</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Point</source>
      <translation>点</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Unit in the plan</source>
      <translation>計画上のブロック</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Section</source>
      <translation>断面</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Time</source>
      <translation>時刻</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Until</source>
      <translation>まで</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>From epoch</source>
      <translation>前のエポック</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>To epoch</source>
      <translation>後のエポック</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>From</source>
      <translation>開始</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>To</source>
      <translation>終了</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Feature point</source>
      <translation>特徴点</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Type of unit</source>
      <translation>ブロックの種類</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Status</source>
      <translation>状態</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Class</source>
      <translation>区分</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Kind</source>
      <translation>種類</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Grade</source>
      <translation>段階</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Datum</source>
      <translation>基準</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reference epoch</source>
      <translation>基準エポック</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>May be</source>
      <translation>候補</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest units</source>
      <translation>最も近いブロック</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Decision</source>
      <translation>判定</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Comment</source>
      <translation>コメント</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reviewer</source>
      <translation>照査者</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reviewed</source>
      <translation>確認日時</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Confirmed by</source>
      <translation>確認者</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Confirmed</source>
      <translation>確定日時</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Editor</source>
      <translation>編集者</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Edited</source>
      <translation>編集日時</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Taken back</source>
      <translation>取り消し済み</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Picked by</source>
      <translation>指定者</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Picked</source>
      <translation>指定日時</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reason</source>
      <translation>理由</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Known by</source>
      <translation>根拠</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Software</source>
      <translation>ソフトウェア</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>File</source>
      <translation>ファイル</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>CRS</source>
      <translation>座標参照系</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Measured</source>
      <translation>測定日</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Verdict</source>
      <translation>判定</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Remark</source>
      <translation>備考</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>LAS version</source>
      <translation>LAS の版</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Point format</source>
      <translation>点の形式</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>COPC</source>
      <translation>COPC</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height H</source>
      <translation>高さ H</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Area</source>
      <translation>面積</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Radius</source>
      <translation>半径</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Easting component</source>
      <translation>東方向成分</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Northing component</source>
      <translation>北方向成分</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height component</source>
      <translation>高さ成分</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Horizontal displacement</source>
      <translation>水平変位</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement</source>
      <translation>変位</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Azimuth</source>
      <translation>方位角</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. easting</source>
      <translation>標準偏差 東</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. northing</source>
      <translation>標準偏差 北</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. height</source>
      <translation>標準偏差 高さ</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Rotation</source>
      <translation>回転</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. rotation</source>
      <translation>標準偏差 回転</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Detectable</source>
      <translation>検出可能量</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement / H</source>
      <translation>変位 / H</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement / Dn</source>
      <translation>変位 / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Missing of a leg</source>
      <translation>脚の欠損長</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Distance of the points</source>
      <translation>点の距離</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest centre</source>
      <translation>最近の中心</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along the structure</source>
      <translation>構造物沿い</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along, from</source>
      <translation>沿い、始点</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along, to</source>
      <translation>沿い、終点</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Correlation length</source>
      <translation>相関距離</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Lowest height</source>
      <translation>最低高さ</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Greatest height</source>
      <translation>最高高さ</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev.</source>
      <translation>標準偏差</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. displacement</source>
      <translation>標準偏差 変位</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest of the other side</source>
      <translation>相手側の最も近いもの</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height of the design</source>
      <translation>設計の高さ</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Centre off the design</source>
      <translation>中心の設計からの離れ</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Outermost point off the design</source>
      <translation>最外点の設計からの離れ</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height of the crest</source>
      <translation>天端の高さ</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Highest top</source>
      <translation>最も高い頂部</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Width of the crest</source>
      <translation>天端の幅</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Change</source>
      <translation>変化</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. change</source>
      <translation>標準偏差 変化</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>95 % band, from</source>
      <translation>95 % 帯、下端</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>95 % band, to</source>
      <translation>95 % 帯、上端</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>p-value</source>
      <translation>p 値</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>p-value, adjusted</source>
      <translation>p 値（調整後）</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Significant</source>
      <translation>有意</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Sigma 0</source>
      <translation>シグマ 0</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Used</source>
      <translation>使用</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Points/m²</source>
      <translation>点/m²</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Legs seen</source>
      <translation>見える脚</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Probability of a broken leg</source>
      <translation>脚の折損確率</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Share seen</source>
      <translation>可視率</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Probability</source>
      <translation>確率</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Share supported</source>
      <translation>支持率</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Overlap</source>
      <translation>重なり</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Observed</source>
      <translation>観測</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Normalised residual</source>
      <translation>正規化残差</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Disturbed</source>
      <translation>異常</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Strip</source>
      <translation>ストリップ</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Layer of the armour</source>
      <translation>被覆層の段</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Packing</source>
      <translation>充填密度</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Spacing / Dn</source>
      <translation>間隔 / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Turn against the neighbour</source>
      <translation>隣に対する回転</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Off the surface</source>
      <translation>面からの離れ</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Off the surface / Dn</source>
      <translation>面からの離れ / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Contacts</source>
      <translation>接触数</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Free gap</source>
      <translation>すき間</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>In a column</source>
      <translation>縦列</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}</source>
      <translation>脚 {number}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}: missing</source>
      <translation>脚 {number}：欠損長</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}: probability of a break</source>
      <translation>脚 {number}：折損確率</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>LAS, LAZ, COPC, E57 or PLY files, a folder of them, a virtual point cloud (.vpc) or point cloud layers; coordinates in metres.</source>
      <translation>LAS、LAZ、COPC、E57、PLY ファイル、そのフォルダ、仮想点群(.vpc)または点群レイヤ。座標はメートル。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Projected CRS in metres; empty takes that of the tiles, and a local frame if they declare none.</source>
      <translation>メートル単位の投影座標系。空ならタイルの座標系、宣言がなければ局所座標系を使う。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Label of this survey in all results, for example its date.</source>
      <translation>すべての結果に付く、この測量の名前。例:日付。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Drives the temporal controller; empty takes the date of the first tile.</source>
      <translation>時系列コントローラを動かす。空なら最初のタイルの日付を使う。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Estimates both from the best-seen units and holds them: moulds differ by centimetres from the standard proportions.</source>
      <translation>最もよく見えるブロックから両方を推定して固定する。型枠は標準比率から数センチメートル異なる。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Catalogue name with the mass in tonnes, such as tetrapod 8 t; or tetrapod with a height of your own.</source>
      <translation>質量(トン)付きのカタログ名(例:tetrapod 8 t)、または高さを指定した tetrapod。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>From the plane under three legs to the top of the fourth, in metres; overrides the catalogue.</source>
      <translation>3本の脚の下の平面から4本目の先端まで(メートル)。カタログの値に優先する。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Radius of a leg's cone at the unit's centre, in metres; empty takes 0.264 H.</source>
      <translation>ブロック中心における脚の円錐の半径(メートル)。空なら 0.264 H。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Loss of radius per metre along the leg's axis; empty takes 0.176.</source>
      <translation>脚の軸方向1メートルあたりの半径の減少。空なら 0.176。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Built tetrapods are tetrahedral; 120° between leg 1 and the others repeats the published equations.</source>
      <translation>実物のテトラポッドは正四面体形。脚1と他の脚の間の120°は論文の式を再現する。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Polygon inside which units are looked for; its outer ring is used. Empty means everywhere.</source>
      <translation>ブロックを探す範囲のポリゴン。外周を使う。空なら全域。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Polygons around surfaces that do not move, such as the crown wall: they tie epochs without control to the earliest with control, or to the first.</source>
      <translation>上部工などの動かない面を囲むポリゴン。基準点のない時期を、基準点のある最も早い時期、なければ最初の時期に結び付けます。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>the survey itself tells</source>
      <translation>測量データ自身から判断</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>rigid</source>
      <translation>剛体</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>elastic</source>
      <translation>弾性</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Long flights bend by centimetres over tens to hundreds of metres. The survey itself tells by its units and targets whether an epoch's cloud is bent; rigid holds it stiff (short sites, one set-up), elastic lets it bend on any evidence.</source>
      <translation>長い飛行は数十から数百メートルにわたって数センチたわみます。各時期の点群がたわんでいるかは、測量自身がブロックと標的から判断します。剛体はたわみを許さず(短い現場、器械点一つ)、弾性はわずかな証拠でもたわみを許します。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Blocks of the survey worked on at the same time; each takes about 1 GB of memory.</source>
      <translation>同時に処理する測量の区画数。1つにつき約1 GBのメモリを使う。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Surveyed targets: point layer or CSV with point_id, easting, northing, height, sd_e, sd_n, sd_h (m).</source>
      <translation>測量済みターゲット:point_id、easting、northing、height、sd_e、sd_n、sd_h(m)を持つ点レイヤまたは CSV。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The same targets as measured in this epoch's cloud: point layer or CSV with point_id, x, y, z (m).</source>
      <translation>この時期の点群で測った同じターゲット:point_id、x、y、z(m)を持つ点レイヤまたは CSV。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Surveyed joints of cones, for validation only: CSV or layer with point_id, unit_easting, unit_northing, unit_height and position (m).</source>
      <translation>測量した円錐の接合点(検証専用):point_id、unit_easting、unit_northing、unit_height と位置(m)を持つ CSV またはレイヤ。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Give the height H of the unit, or choose a catalogue name with its mass, such as tetrapod 8 t.</source>
      <translation>ブロックの高さ H を指定するか、tetrapod 8 t のような質量付きカタログ名を選んでください。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The type of unit must be tetrapod, or a catalogue name such as tetrapod 8 t.</source>
      <translation>ブロックの種類は tetrapod、または tetrapod 8 t のようなカタログ名にしてください。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Control points and targets in the cloud belong together: give both, or neither.</source>
      <translation>基準点と点群中のターゲットは対です。両方指定するか、どちらも指定しないでください。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Time of the survey (UTC)</source>
      <translation>測量の時刻(UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Epoch {label} (row {row})</source>
      <translation>エポック {label}（{row} 行目）</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Calibrate radius and taper</source>
      <translation>半径とテーパーを校正する</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Height H of the unit (m)</source>
      <translation>ブロックの高さ H(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Cone radius at the centre (m)</source>
      <translation>中心における円錐の半径(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Taper of the leg</source>
      <translation>脚のテーパー</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Angle between the legs</source>
      <translation>脚の間の角度</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Area of interest</source>
      <translation>対象範囲</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Stable areas</source>
      <translation>安定領域</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Frames of the epochs</source>
      <translation>各時期の座標枠</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Worker processes</source>
      <translation>ワーカープロセス数</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The cone radius must be smaller than half the height of the unit.</source>
      <translation>円錐の半径はブロックの高さの半分より小さくしてください。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The area of interest holds no polygon.</source>
      <translation>対象範囲にポリゴンがありません。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The area of interest has several separate parts; give one polygon.</source>
      <translation>対象範囲が複数に分かれています。1つのポリゴンにしてください。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Virtual point clouds (*.vpc)</source>
      <translation>仮想点群 (*.vpc)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Epoch in row {row}</source>
      <translation>{row} 行目のエポック</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>tetrahedral (109.5°)</source>
      <translation>正四面体形(109.5°)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>as in the paper (120°)</source>
      <translation>論文どおり(120°)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{crs} is geographic; choose a projected CRS in metres.</source>
      <translation>{crs} は地理座標系です。メートル単位の投影座標系を選んでください。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{where}: no point cloud is given.</source>
      <translation>{where}:点群が指定されていません。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The layers {one} and {other} have different CRS, and that of {one} is set by hand. Set the same one for both.</source>
      <translation>レイヤ {one} と {other} の CRS が異なり、{one} の CRS は手動で設定されています。両方に同じ CRS を設定してください。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} cannot be written: {reason}.</source>
      <translation>{layer} を書き込めません：{reason}。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} has no field {fields}; it has {present}.</source>
      <translation>{layer} にフィールド {fields} がありません。あるのは {present} です。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Point clouds ({endings})</source>
      <translation>点群 ({endings})</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{where}: the folder {path} holds no point cloud (LAS, LAZ, COPC, E57, PLY).</source>
      <translation>{where}:フォルダ {path} に点群 (LAS, LAZ, COPC, E57, PLY) がありません。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} cannot be transformed to the CRS of the results: {reason}.</source>
      <translation>{layer} を結果の座標系に変換できません: {reason}。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>error as targets see it</source>
      <translation>ターゲットから見た誤差</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>difference of two epochs as units see it</source>
      <translation>ブロックから見た2時期の差</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>strip against its epoch</source>
      <translation>時期平均に対するコースの偏差</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>moved as one</source>
      <translation>一体で移動</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>no common motion that could be told</source>
      <translation>判別できる共通の動きなし</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>found</source>
      <translation>検出</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>uncertain</source>
      <translation>不確か</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>new</source>
      <translation>新規</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>relocated</source>
      <translation>移設</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>stable</source>
      <translation>安定</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>moved</source>
      <translation>移動</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>rotated</source>
      <translation>回転</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>lost: the place is empty</source>
      <translation>消失：その場所は空</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>unseen: known from another epoch</source>
      <translation>未確認：他の時期に存在</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>unexplained points where a unit fits</source>
      <translation>ブロックが収まる場所の未説明の点</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>hole where a unit fits</source>
      <translation>ブロックが収まる空隙</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>below the detection limit</source>
      <translation>検出限界未満</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>significant</source>
      <translation>有意</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>watch</source>
      <translation>注意</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>alert or more</source>
      <translation>警報以上</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>relocated unit</source>
      <translation>移設されたブロック</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>uncertain unit</source>
      <translation>不確かなブロック</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>missing end of a broken leg</source>
      <translation>折損した脚の欠けた先端</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>observed</source>
      <translation>観測</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>derived from the rest of the unit</source>
      <translation>ブロックの残りから導出</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>used</source>
      <translation>使用</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>disturbed, not used</source>
      <translation>乱れあり、不使用</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>not used</source>
      <translation>不使用</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>check point</source>
      <translation>検証点</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>placeholder for a unit not found</source>
      <translation>見つからないブロックの仮置き</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>place of a correction</source>
      <translation>修正の位置</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>picked by hand</source>
      <translation>手動指定</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Outlines of the units</source>
      <translation>ブロックの輪郭</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Surfaces of the units (3D)</source>
      <translation>ブロックの表面(3D)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Placement of the units</source>
      <translation>ブロックの据付状態</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Gaps</source>
      <translation>欠落箇所</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Feature points</source>
      <translation>特徴点</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Displacements</source>
      <translation>変位</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Displacements, other pairs and datum</source>
      <translation>変位(他の時期対・基準系)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Errors of bent frames</source>
      <translation>曲がった座標系の誤差</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Stretches that moved as one</source>
      <translation>一体で動いた区間</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Control residuals</source>
      <translation>基準点残差</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Check residuals</source>
      <translation>検証点残差</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Reviews</source>
      <translation>照査</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Corrections and placeholders</source>
      <translation>修正と仮置き</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Points picked by hand</source>
      <translation>手動で指定した点</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>watch: over {length}</source>
      <translation>注意：{length} 超</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>alert or more: over {length}</source>
      <translation>警報以上：{length} 超</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>arrow of 10 mm: {length}, at most 30 mm long; ellipse: 95 %</source>
      <translation>10 mm の矢印：{length}、最長 30 mm、楕円：95 %</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>Which displacement a planned survey detects</source>
      <translation>計画した測量が検出する変位</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>A unit that moves by {length} in its worst direction is found with the chosen power; the mark in the chart.</source>
      <translation>最も不利な方向に {length} 動いたブロックが、選んだ検出力で見つかります（図の印）。</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>{share} % of a unit seen</source>
      <translation>ブロックの {share} % が可視</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>Detectable displacement ({unit})</source>
      <translation>検出可能な変位 ({unit})</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>The epochs and the unit given</source>
      <translation>指定されたエポックとブロック</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>{table}, row {row}</source>
      <translation>{table}、{row} 行目</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>{table}, field names</source>
      <translation>{table}、フィールド名</translation>
    </message>
    <message>
      <location filename="../algorithms/survey_algorithm.py" />
      <source>The tiles declare no CRS: results are in a local frame. Choose the CRS of the results to change that.</source>
      <translation>タイルに座標系の宣言がないため、結果は局所座標系です。変えるには結果の座標系を選んでください。</translation>
    </message>
    <message>
      <location filename="../algorithms/survey_algorithm.py" />
      <source>Epoch {label}</source>
      <translation>時期 {label}</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Track displacements</source>
      <translation>変位の追跡</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Recognises each unit in all epochs, finds the stable units by a global congruence test and tests the displacement of every feature point and the rotation of every unit against it, with the covariance of fit and registration.</source>
      <translation>各ブロックを全時期で同定し、全体の合同検定で安定なブロックを見つけ、それに対して各特徴点の変位と各ブロックの回転を、当てはめと登録の共分散を用いて検定する。</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>A rotation near 60° or more is ambiguous by the symmetry of the tetrapod and is reported as such.</source>
      <translation>60°前後以上の回転は、テトラポッドの対称性のため曖昧であり、その旨を報告する。</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>displacement,deformation analysis,congruence test,epoch,monitoring</source>
      <translation>変位,変形解析,合同検定,時期,モニタリング</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Layers of units from Fit tetrapods: one per epoch, each with its own label and time, all in one CRS.</source>
      <translation>「テトラポッドの当てはめ」のブロックレイヤ:時期ごとに1つ、それぞれ名前と時刻を持ち、すべて同じ座標系。</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>GeoPackages from Register to control, one per epoch; without them the clouds' own frames are taken as registered.</source>
      <translation>「基準点への登録」の GeoPackage、時期ごとに1つ。なければ点群自身の座標系を登録済みとみなす。</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Fitted units of all epochs</source>
      <translation>全時期の当てはめたブロック</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Registrations</source>
      <translation>登録結果(複数)</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Give the units of at least two epochs.</source>
      <translation>少なくとも2時期のブロックを指定してください。</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>The layers of units have different CRS: {crs}.</source>
      <translation>ブロックのレイヤの座標系が異なります:{crs}。</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>no CRS</source>
      <translation>座標系なし</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Validate against check points</source>
      <translation>検証点との比較</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Compares feature points of one epoch with the same points surveyed by total station or GNSS. Check points never take part in the fit: their differences show the accuracy that was reached.</source>
      <translation>1時期の特徴点を、トータルステーションまたは GNSS で測量した同じ点と比べる。検証点は当てはめに使わないので、差は得られた精度を示す。</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>A check point is matched by the approximate centre of its unit; one that matches no unit is named and left out.</source>
      <translation>検証点はブロックの概略中心で対応付ける。対応するブロックのないものは名前を示して除く。</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>validation,accuracy,check points,total station,GNSS,RMSE</source>
      <translation>検証,精度,検証点,トータルステーション,GNSS,RMSE</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Layer from Extract feature points, of one epoch.</source>
      <translation>「特徴点の抽出」のレイヤ(1時期分)。</translation>
    </message>
    <message>
      <location filename="../plugin/engine_task.py" />
      <source>Cancelled.</source>
      <translation>中止しました。</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Creating the tetratrack engine</source>
      <translation>tetratrack エンジンの作成</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Another window of QGIS is creating the engine at this moment.</source>
      <translation>別の QGIS ウィンドウが現在エンジンを作成しています。</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Making an empty environment</source>
      <translation>空の環境を作成中</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Trying the libraries</source>
      <translation>ライブラリを確認中</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine's environment could not be created: {reason} (everything that was said: {log})</source>
      <translation>エンジンの環境を作成できませんでした: {reason}（すべての出力: {log}）</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Compiling, so that the first run need not wait</source>
      <translation>コンパイル中（初回の実行を待たせないため）</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Looking for the libraries</source>
      <translation>ライブラリを探しています</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Fetching {name}: {done} of about {all} MB</source>
      <translation>{name} を取得中: 約 {all} MB のうち {done} MB</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Unpacking libraries: {count} of {all}</source>
      <translation>ライブラリを展開中: {all} 個のうち {count} 個</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine needs {needed} GB on the disk of {folder}, and {free} GB are free.</source>
      <translation>エンジンには {folder} のディスクに {needed} GB 必要ですが、空きは {free} GB です。</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>{wheels} holds no wheels.</source>
      <translation>{wheels} には wheel がありません。</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>{wheels} lacks {count} of the wheels that this version of the plugin needs: {names}.</source>
      <translation>{wheels} には、このバージョンのプラグインに必要な wheel のうち {count} 個がありません: {names}。</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine in use cannot be replaced now: wait until its runs have ended.</source>
      <translation>使用中のエンジンは今は置き換えられません。実行が終わるまでお待ちください。</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Unpacking {file}</source>
      <translation>{file} を展開中</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Choose a file…</source>
      <translation>ファイルを選択…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Add an epoch</source>
      <translation>エポックを追加</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Remove the selected epochs</source>
      <translation>選択したエポックを削除</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>user-defined</source>
      <translation>ユーザー定義</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Choose…</source>
      <translation>選択…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Table of points</source>
      <translation>点の表</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Tables (*.csv *.txt *.gpkg);;All files (*)</source>
      <translation>表 (*.csv *.txt *.gpkg);;すべてのファイル (*)</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Files…</source>
      <translation>ファイル…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Folder…</source>
      <translation>フォルダ…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Layer {name}</source>
      <translation>レイヤ {name}</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_wrapper.py" />
      <source>{count} epochs…</source>
      <translation>{count} エポック…</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Arrows move, + and - zoom, Home resets; Enter picks the point in the middle</source>
      <translation>矢印キーで移動、+ と - で拡大縮小、Home で元に戻す。Enter で中央の点を選びます</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Plan of the unit</source>
      <translation>ユニットの平面図</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Section of the unit</source>
      <translation>ユニットの断面図</translation>
    </message>
    <message>
      <location filename="../plugin/length_widget.py" />
      <source>Length in the project's unit</source>
      <translation>プロジェクトの単位での長さ</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python 3.11 to 3.13 was not found: install it, or choose an interpreter of the engine above.</source>
      <translation>Python 3.11 から 3.13 が見つかりません。インストールするか、上でエンジンのインタープリターを選んでください。</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create a Python environment in {folder} and download libraries into it? It takes about {size} of disk.</source>
      <translation>{folder} に Python 環境を作成し、ライブラリをダウンロードしますか？ディスクを約 {size} 使います。</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create a Python environment in {folder} from the wheels in {wheels}? It takes about {size} of disk.</source>
      <translation>{wheels} の wheel から {folder} に Python 環境を作成しますか？ディスクを約 {size} 使います。</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Try again…</source>
      <translation>再試行…</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python interpreter of the engine</source>
      <translation>エンジンの Python インタプリタ</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Empty uses the environment that the plugin creates; a folder of an environment will do.</source>
      <translation>空ならプラグインが作成する環境を使います。環境のフォルダでもかまいません。</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Folder or ZIP of wheels</source>
      <translation>wheel のフォルダーまたは ZIP</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>For computers without a network: what was fetched on another one. Empty fetches the libraries.</source>
      <translation>ネットワークのないコンピューター用: 別のコンピューターで取得したもの。空欄ならライブラリを取得します。</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create the engine's environment…</source>
      <translation>エンジンの環境を作成…</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Cancel</source>
      <translation>中止</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Show the log</source>
      <translation>ログを表示</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Engine</source>
      <translation>エンジン</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>State</source>
      <translation>状態</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>The engine is ready.</source>
      <translation>エンジンの準備ができました。</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} is no file.</source>
      <translation>{python} はファイルではありません。</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} is no Python interpreter.</source>
      <translation>{python} は Python インタープリターではありません。</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} is Python {version}; the engine needs 3.11 or later.</source>
      <translation>{python} は Python {version} です。エンジンには 3.11 以降が必要です。</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} lacks the engine's libraries: {modules}.</source>
      <translation>{python} にはエンジンのライブラリがありません: {modules}。</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Used: {python}</source>
      <translation>使用中:{python}</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Can be used: {python}</source>
      <translation>使用できます: {python}</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the disk is full</source>
      <translation>ディスクがいっぱいです</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>this Python cannot make environments; on Debian and Ubuntu install python3-venv first</source>
      <translation>この Python では環境を作成できません。Debian と Ubuntu では先に python3-venv をインストールしてください</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy wants a user name and password: state them in Settings &gt; Options &gt; Network</source>
      <translation>プロキシにユーザー名とパスワードが必要です。設定 &gt; オプション &gt; ネットワーク で指定してください</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy is of the kind SOCKS, which the installer does not know; choose a folder of wheels</source>
      <translation>プロキシが SOCKS 型で、インストーラーが対応していません。wheel のフォルダーを選んでください</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the registry's certificate is not trusted: import your network's authority in Settings &gt; Options &gt; Authentication</source>
      <translation>レジストリの証明書が信頼されていません。設定 &gt; オプション &gt; 認証 でネットワークの認証局を取り込んでください</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy cannot be reached: see Settings &gt; Options &gt; Network</source>
      <translation>プロキシに接続できません。設定 &gt; オプション &gt; ネットワーク を確認してください</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>a file is not the one that this version of the plugin needs: it was damaged or changed on its way; try again</source>
      <translation>ファイルがこのバージョンのプラグインに必要なものと違います。途中で壊れたか変わりました。もう一度お試しください</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the connection broke while a file was fetched; try again, what is complete is not fetched twice</source>
      <translation>ファイルの取得中に接続が切れました。もう一度お試しください。取得済みのものは再取得されません</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>no package registry can be reached from this computer; without a network choose a folder of wheels</source>
      <translation>このコンピューターからはどのパッケージレジストリにも接続できません。ネットワークがない場合は wheel のフォルダーを選んでください</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>a library of the system is missing; on Debian and Ubuntu install libegl1 libgl1 libgomp1</source>
      <translation>システムのライブラリがありません。Debian と Ubuntu では libegl1 libgl1 libgomp1 をインストールしてください</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>Displacements of armour units</source>
      <translation>消波ブロックの変位</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>Legend</source>
      <translation>凡例</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>{pair}, datum: {datum}</source>
      <translation>{pair}、基準：{datum}</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Ended: nothing was stored.</source>
      <translation>終了しました。何も保存していません。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints</source>
      <translation>3 つの接合点で固定</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fit again after a click on the unit (earlier epoch)</source>
      <translation>ブロックをクリックして再当てはめ(前の時期)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fit again after a click on the unit (later epoch)</source>
      <translation>ブロックをクリックして再当てはめ(後の時期)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints of legs (earlier epoch)</source>
      <translation>脚の接合点3点で固定(前の時期)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints of legs (later epoch)</source>
      <translation>脚の接合点3点で固定(後の時期)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pick feature points beside the fit (earlier epoch)</source>
      <translation>当てはめと並べて特徴点を読み取る(前の時期)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pick feature points beside the fit (later epoch)</source>
      <translation>当てはめと並べて特徴点を読み取る(後の時期)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Placeholder for a unit not found</source>
      <translation>見つからなかったブロックの仮置き</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Merge the two selected units</source>
      <translation>選択した2つのブロックを統合</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Split at the later epoch: two units taken for one</source>
      <translation>後の時期で分割:2つのブロックを1つとみなしていた</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Delete: not a unit</source>
      <translation>削除:ブロックではない</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Take back your last correction</source>
      <translation>自分の最後の修正を取り消す</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Read the points around the units…</source>
      <translation>ブロック周辺の点を読む…</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The points around the units are needed: read them from the correction menu.</source>
      <translation>ブロック周辺の点が必要です。修正メニューから読み込んでください。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>There are no points here; click on the cloud.</source>
      <translation>ここには点がありません。点群の上をクリックしてください。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The unit has no pose in any epoch to take its size from.</source>
      <translation>このブロックはどの時期にも姿勢がなく、大きさを決められません。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Nothing was stored: pick the three joints again.</source>
      <translation>何も保存していません。3 つの接合点をもう一度選んでください。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>pinned by three joints</source>
      <translation>接合点3点で固定</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The three points do not fit the shape of {unit}: they are {misfit} off, where {worst} would be usual. Were they joints of this unit? Store the pose all the same?</source>
      <translation>3 点は {unit} の形に合いません。ずれは {misfit} で、通常は {worst} までです。このブロックの接合点でしたか？それでも姿勢を保存しますか？</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The unit was not found in this epoch: pin it by three joints instead.</source>
      <translation>この時期にはブロックが見つかっていません。代わりに接合点3点で固定してください。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Select the two units to merge.</source>
      <translation>統合する2つのブロックを選択してください。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>There is no correction of yours to take back.</source>
      <translation>取り消せる自分の修正はありません。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Survey description</source>
      <translation>測量の記述</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Survey (*.toml)</source>
      <translation>測量 (*.toml)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Reading points around units</source>
      <translation>ブロック周辺の点を読み込み中</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Points read.</source>
      <translation>点を読み込みました。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Select a unit first.</source>
      <translation>先にブロックを選択してください。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click the middle of the unit on the map or in a view; Escape ends.</source>
      <translation>地図またはビューでブロックの中央をクリック。Escape で終了。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click three joints where three legs meet, on the map or in the views; Escape ends.</source>
      <translation>地図またはビューで、3本の脚が出会う接合点を3つクリック。Escape で終了。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click a joint where three legs meet; Escape ends.</source>
      <translation>3本の脚が出会う接合点をクリック。Escape で終了。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click where the unit lies on the map; Escape ends.</source>
      <translation>地図上でブロックの位置をクリック。Escape で終了。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fitting {unit} again</source>
      <translation>{unit} を再当てはめ中</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} was fitted again.</source>
      <translation>{unit} を再当てはめしました。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} pinned; the picks fit within {length}.</source>
      <translation>{unit} を固定しました。読み取り点は {length} 以内で一致します。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{feature} picked, {length} from the fit.</source>
      <translation>{feature} を読み取りました。当てはめとの差は {length}。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Placeholder {name} stored; it counts as a unit not found.</source>
      <translation>仮置き {name} を保存しました。見つからなかったブロックとして数えます。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{count} of 3 joints.</source>
      <translation>接合点 3点中 {count} 点。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{other} is now {keep}.</source>
      <translation>{other} は {keep} になりました。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} is called {name} from {epoch} on.</source>
      <translation>{unit} は {epoch} から {name} と呼びます。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} was deleted; take it back from the correction menu.</source>
      <translation>{unit} を削除しました。修正メニューから取り消せます。</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Taken back: {kind} {unit}.</source>
      <translation>取り消しました:{kind} {unit}。</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n significant</source>
      <translation>
        <numerusform>有意 %n</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n decided</source>
      <translation>
        <numerusform>判定済み %n</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n rejected, excluded from statistics and map</source>
      <translation>
        <numerusform>棄却 %n(統計と地図から除外)</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Leg</source>
      <translation>脚</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Its end</source>
      <translation>先端</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Probability of a break</source>
      <translation>折損確率</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Points to</source>
      <translation>向き</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Check point</source>
      <translation>検証点</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Feature</source>
      <translation>特徴点</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Surveyed</source>
      <translation>測量値</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Fitted</source>
      <translation>当てはめ値</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Difference</source>
      <translation>差</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n lost</source>
      <translation>
        <numerusform>消失 %n</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n new</source>
      <translation>
        <numerusform>新規 %n</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n with a broken leg</source>
      <translation>
        <numerusform>折損した脚のあるもの %n</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>3D displacement</source>
      <translation>3D変位</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>in heights H, in nominal diameters Dn</source>
      <translation>高さ H、公称径 Dn に対する比</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Easting</source>
      <translation>東</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Northing</source>
      <translation>北</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Height</source>
      <translation>高さ</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Horizontal</source>
      <translation>水平</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>not significant</source>
      <translation>有意でない</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Detection limit</source>
      <translation>検出限界</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{length}, towards {azimuth}° from grid north</source>
      <translation>{length}、方眼北から {azimuth}° の方向</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Score of the fit, 0 to 1</source>
      <translation>当てはめのスコア(0~1)</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Legs seen, of four</source>
      <translation>見える脚(4 本中)</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Broken legs</source>
      <translation>折損した脚</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Ends not seen, of legs</source>
      <translation>先端が見えない脚</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n of {all} units shown</source>
      <translation>
        <numerusform>{all} 個中 %n 個を表示</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>none: one of the two positions is not known</source>
      <translation>なし:2つの位置の一方が不明</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Test against no motion</source>
      <translation>不動に対する検定</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Missing ({unit})</source>
      <translation>欠損 ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Check points ({unit})</source>
      <translation>検証点({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Nobody has decided on this unit yet.</source>
      <translation>このブロックはまだ判定されていません。</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>largest {length}</source>
      <translation>最大 {length}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Seen in {epoch}</source>
      <translation>可視率({epoch})</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Legs</source>
      <translation>脚</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Points to: degrees from grid north, and above the horizon</source>
      <translation>向き：方眼北からの角度と水平からの仰角</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>± one standard deviation</source>
      <translation>± は標準偏差 1 倍</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Picked by hand</source>
      <translation>手動読み取り</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>taken back by {who}</source>
      <translation>{who} が取り消し</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{feature}, {epoch}: picked {length} from the fit ({who})</source>
      <translation>{feature}、{epoch}:当てはめから {length} で読み取り({who})</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_dock.py" />
      <source>%n units</source>
      <translation>
        <numerusform>ブロック %n 個</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Displacement review</source>
      <translation>変位の照査</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Open a result</source>
      <translation>結果を開く</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>GeoPackage (*.gpkg)</source>
      <translation>GeoPackage (*.gpkg)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Previous unit (Up, or P for the previous undecided)</source>
      <translation>前のブロック(↑、未判定の前へは P)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Next unit (Down, or N for the next undecided)</source>
      <translation>次のブロック(↓、未判定の次へは N)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Zoom to the unit and flash it (Z)</source>
      <translation>ブロックへズームして点滅(Z)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The map follows the selection</source>
      <translation>地図が選択に追従する</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Show all units</source>
      <translation>全ブロックを表示</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>A click on the map picks the unit or arrow there</source>
      <translation>地図のクリックで、そこのブロックまたは矢印を選ぶ</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Correct a unit</source>
      <translation>ブロックを修正</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Write the report…</source>
      <translation>報告書を書き出す…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Report with more choices…</source>
      <translation>詳細を選んで報告書を作成…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>A page to print, with the map as it stands</source>
      <translation>現在の地図を載せた印刷ページ</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Export the alarm list…</source>
      <translation>警報一覧を書き出す…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Web page (*.html);;PDF (*.pdf)</source>
      <translation>ウェブページ (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Alarm list</source>
      <translation>警報一覧</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>CSV (*.csv);;GeoJSON (*.geojson)</source>
      <translation>CSV (*.csv);;GeoJSON (*.geojson)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Decisions of another reviewer were taken in.</source>
      <translation>他の照査者の判定を取り込みました。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Corrections of another reviewer were taken in.</source>
      <translation>他の査読者の修正を取り込みました。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>A run replaced the result: its numbers are shown now.</source>
      <translation>計算により結果が置き換えられました。新しい値を表示しています。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>In polygons</source>
      <translation>ポリゴン内</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>No unit passes the filter.</source>
      <translation>条件に合うブロックがありません。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Enter your name or initials first: they stand beside every decision.</source>
      <translation>先に氏名またはイニシャルを入力してください。すべての判定に付記されます。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Confirmed.</source>
      <translation>確認しました。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Writing the report</source>
      <translation>報告書を作成中</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Threshold ({unit})</source>
      <translation>しきい値 ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{name} was closed with its layers. Every decision is stored: open it again to go on.</source>
      <translation>{name} はレイヤとともに閉じられました。判定はすべて保存済みです。続けるには再度開いてください。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Make a polygon layer active first.</source>
      <translation>先にポリゴンレイヤをアクティブにしてください。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The active layer holds no polygon.</source>
      <translation>アクティブなレイヤにポリゴンがありません。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>In the map window</source>
      <translation>地図ウィンドウ内</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Everywhere</source>
      <translation>全域</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The page {name} is in the project's layouts.</source>
      <translation>ページ {name} はプロジェクトのレイアウトにあります。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{title}…</source>
      <translation>{title}…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{name} is read-only: you can look, but decisions cannot be stored.</source>
      <translation>{name} は読み取り専用です。閲覧できますが判定は保存できません。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{units}: {decision}, stored.</source>
      <translation>{units}:{decision}、保存しました。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Taken back: {units}.</source>
      <translation>取り消しました:{units}。</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Report written to {name}.</source>
      <translation>報告書を {name} に書き出しました。</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_dock.py" />
      <source>Units written to {name}: %n.</source>
      <translation>
        <numerusform>%n 個のブロックを {name} に書き出しました。</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Open 3D view</source>
      <translation>3D ビューを開く</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Model, sections and design</source>
      <translation>モデル・断面・設計</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Export as-built model…</source>
      <translation>出来形モデルを書き出す…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Compare with design…</source>
      <translation>設計との比較…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Cross-sections and crest…</source>
      <translation>横断面と天端…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Points less blocks…</source>
      <translation>点群とブロックの差…</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Units reviewed</source>
      <translation>照査済みブロック</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements reviewed</source>
      <translation>照査済み変位</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements reviewed, other pair or datum</source>
      <translation>照査済み変位(他の時期対・基準系)</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Rejected units (excluded)</source>
      <translation>棄却したブロック(除外)</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Placeholders and corrections</source>
      <translation>仮置きと修正</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacement review: {name}</source>
      <translation>変位の照査:{name}</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements: {datum}</source>
      <translation>変位: {datum}</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Epochs compared</source>
      <translation>比較する時期</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>All classes</source>
      <translation>全区分</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Classes shown</source>
      <translation>表示する区分</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Least 3D displacement shown; lost, new and relocated units are always shown</source>
      <translation>表示する最小の3D変位。消失・新規・移設のブロックは常に表示</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Area of the units shown</source>
      <translation>表示するブロックの範囲</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Undecided only</source>
      <translation>未判定のみ</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>On the map too</source>
      <translation>地図にも適用</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The map shows only the units that the list shows</source>
      <translation>一覧に表示されるブロックだけを地図に表示します</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Unit…</source>
      <translation>ブロック…</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Comment, stored with the decision</source>
      <translation>判定とともに保存されるコメント</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Your name or initials, stored with every decision</source>
      <translation>氏名またはイニシャル。すべての判定とともに保存</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>In the active layer's polygons</source>
      <translation>アクティブレイヤのポリゴン内</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Accept</source>
      <translation>採用</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The displacement is right (A)</source>
      <translation>変位は正しい(A)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Reject</source>
      <translation>棄却</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The displacement is wrong: it leaves statistics, maps and report (R)</source>
      <translation>変位は誤り:統計、地図、報告書から除く(R)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Inspect</source>
      <translation>点検</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Inspect on site (I)</source>
      <translation>現地で点検(I)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Confirm</source>
      <translation>確認</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Confirm another reviewer's decision (C)</source>
      <translation>他の照査者の判定を確認する(C)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Undo</source>
      <translation>元に戻す</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Take back your last decision (U)</source>
      <translation>自分の最後の判定を取り消す(U)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Open</source>
      <translation>開く</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Plan</source>
      <translation>平面</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Select a unit</source>
      <translation>ブロックを選択してください</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>N</source>
      <translation>N</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Section {azimuth}°</source>
      <translation>断面 {azimuth}°</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Series</source>
      <translation>時系列</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Section along the displacement</source>
      <translation>変位に沿う断面</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Direction of the section, from grid north; each outline is cut through its own centre</source>
      <translation>断面の方向(方眼北から)。各輪郭はそれぞれの中心で切る</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Read the points…</source>
      <translation>点を読み込む…</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Reads the points around the units from the tiles of the survey, for the views and for picking</source>
      <translation>図と選点のために、測量のタイルからブロック周辺の点を読み込みます</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Numbers</source>
      <translation>数値</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>History</source>
      <translation>履歴</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>points not read yet</source>
      <translation>点は未読み込み</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>lost</source>
      <translation>消失</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>unseen</source>
      <translation>不可視</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>deleted</source>
      <translation>削除</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>merged</source>
      <translation>統合</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>split</source>
      <translation>分割</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>new pose</source>
      <translation>新しい姿勢</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>points picked</source>
      <translation>手動指定点</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>placeholder</source>
      <translation>仮置き</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Displ.</source>
      <translation>変位</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Horiz.</source>
      <translation>水平</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Vert.</source>
      <translation>鉛直</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Rot.</source>
      <translation>回転</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>p</source>
      <translation>p</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Seen</source>
      <translation>可視率</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Broken</source>
      <translation>折損</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Name of the unit, the same in all epochs</source>
      <translation>ブロックの名前。全時期で同じ</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Class of the displacement, or the unit's fate</source>
      <translation>変位の区分、またはブロックの状態</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Rotation between the epochs (degrees)</source>
      <translation>時期間の回転(度)</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Probability of so large a displacement if the unit stood still; bold where significant</source>
      <translation>ブロックが静止している場合にこれほど大きな変位となる確率。有意なら太字</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Share of the unit's surface that holds points, in the worse epoch</source>
      <translation>点のある表面の割合(悪いほうの時期)</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Numbers of the legs that are broken; the page Numbers says how sure that is, and which ends are not seen</source>
      <translation>折損した脚の番号。確からしさと見えない先端は「数値」のページにあります</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Decision of the reviewers</source>
      <translation>照査者の判定</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Who decided, and ✓ who confirmed</source>
      <translation>判定した人、✓ は確認した人</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>whole</source>
      <translation>完全</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>broken</source>
      <translation>折損</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>not seen</source>
      <translation>見えない</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>accepted</source>
      <translation>採用</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>rejected</source>
      <translation>棄却</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>inspect</source>
      <translation>点検</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>decided</source>
      <translation>判定</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>confirmed</source>
      <translation>確認</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>took back</source>
      <translation>取り消し</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>changed the numbers, which ended</source>
      <translation>数値を変更し、次の判定が失効:</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>brought back the numbers of</source>
      <translation>数値を元に戻し、次の判定が復活:</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>3D displacement of the centre ({unit})</source>
      <translation>中心の3D変位({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Horizontal displacement of the centre ({unit})</source>
      <translation>中心の水平変位({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Vertical displacement of the centre, positive up ({unit})</source>
      <translation>中心の鉛直変位、上向き正({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>3D displacement since {epoch} ({unit}), bands of 95 %</source>
      <translation>{epoch} からの3D変位({unit})、帯は95 %</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>No displacement of this unit</source>
      <translation>このブロックの変位はありません</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>centre</source>
      <translation>中心</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>detection limit</source>
      <translation>検出限界</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Open result…</source>
      <translation>結果を開く…</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Take the point cloud layers</source>
      <translation>点群レイヤを使う</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>The files of the project's point cloud layers, in place of a folder</source>
      <translation>フォルダの代わりに、プロジェクトの点群レイヤのファイルを使います</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>estimated from the cloud</source>
      <translation>点群から推定</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>as the tiles declare</source>
      <translation>タイルの宣言どおり</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Run</source>
      <translation>実行</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Open the result.gpkg of a survey with two epochs or more to review its displacements.</source>
      <translation>2時期以上の測量の result.gpkg を開いて変位を照査します。</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Or make one: choose the folder that holds the tiles of all epochs, look through the table, press Run.</source>
      <translation>または作成します：全エポックのタイルがあるフォルダを選び、表を確かめて「実行」を押します。</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Height H of the unit</source>
      <translation>ブロックの高さ H</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Looking at the tiles</source>
      <translation>タイルを確認中</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Writing the survey</source>
      <translation>測量ファイルを書き込み中</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>The project has no point cloud layer that lies in a file: choose a folder instead.</source>
      <translation>プロジェクトにファイルの点群レイヤがありません。フォルダを選んでください。</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Choose where the result is to be written.</source>
      <translation>結果の書き込み先を選んでください。</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Answer first what is asked above.</source>
      <translation>先に上の質問に答えてください。</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Units of {heights} m height.</source>
      <translation>高さ {heights} m のブロック。</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Monitor a survey…</source>
      <translation>測量のモニタリング…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Try the sample…</source>
      <translation>サンプルを試す…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Engine…</source>
      <translation>エンジン…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>An engine is needed before anything can be computed.</source>
      <translation>計算を行うにはまずエンジンが必要です。</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>The sample cannot be copied to {folder}: {reason}.</source>
      <translation>サンプルを {folder} にコピーできません: {reason}。</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>Tetrapods in 3D</source>
      <translation>3D テトラポッド</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>Displacements in 3D</source>
      <translation>3D 変位</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>significant displacement, enlarged {scale} times</source>
      <translation>有意な変位、{scale} 倍に拡大</translation>
    </message>
    <message>
      <location filename="../core/report/templates/report.html" />
      <source>a local frame</source>
      <translation>局所座標系</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>Blocks</source>
      <translation>ブロック</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>View of the blocks by class</source>
      <translation>区分別のブロックの図</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>Fitted units of {epoch} by class, seen from the low side.</source>
      <translation>{epoch} に推定したブロック(区分別)、低い側から見た図。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Castings</source>
      <translation>製作ブロック</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Mould {name} of an earlier survey, of {units} units, is held.</source>
      <translation>以前の調査の型枠{name}（{units}個から）を固定しています。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>The mould was learned from {units} units of this survey.</source>
      <translation>型枠はこの調査の{units}個のブロックから求めました。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>H = {height} m: radius {radius} m, taper {taper}. Size of single castings ± {size}, radius of single legs ± {leg} mm (one standard deviation).</source>
      <translation>H = {height} m：半径{radius} m、テーパー{taper}。個々のブロックの大きさ ± {size}、個々の脚の半径 ± {leg} mm（標準偏差）。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Departure of the mould from its cones: along a leg, and unrolled around it. What is alike on all units is held; how single castings differ widens the standard deviations where two epochs see other surfaces.</source>
      <translation>型枠の円錐からのずれ：脚に沿った断面と周方向の展開図。全ブロックに共通の部分は固定し、個々の差は、二つの時期に異なる面が見える場合に標準偏差を広げます。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Too few units show enough of themselves for a mould: cones are held, and castings vary as the literature says.</source>
      <translation>型枠を求めるには、よく見えるブロックが少なすぎます：円錐を固定し、個体差は文献値によります。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs seen whole: {whole}, broken: {broken}; the ends of {unseen} are not seen, and nothing is said of them.</source>
      <translation>完全な脚：{whole}、折損：{broken}。{unseen}本は先端が見えず、判定しません。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Broken leg</source>
      <translation>折損した脚</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Missing (m)</source>
      <translation>欠損 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Break: easting (m)</source>
      <translation>破断面：東距 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Northing (m)</source>
      <translation>北距 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Height (m)</source>
      <translation>高さ (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs whose ends are not seen</source>
      <translation>先端が見えない脚</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Whither a leg points: degrees from grid north clockwise, and above the horizon. The place is that of the face of fracture, or of the leg's whole end where the result does not say how much of it is missing.</source>
      <translation>脚の向き：方眼北から時計回りの角度と水平からの仰角。位置は破断面のもので、欠損長が結果にない場合は完全な脚の先端のものです。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs by section along the axis</source>
      <translation>軸に沿う区間ごとの脚</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Chainage (m)</source>
      <translation>測点距離(m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Units with a broken leg</source>
      <translation>折損した脚のあるブロック</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs seen whole</source>
      <translation>完全と見える脚</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Ends not seen</source>
      <translation>見えない先端</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>The result was made by a version that said nothing of legs.</source>
      <translation>この結果は、脚について述べない版で作られました。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Comparison with surveyed check points</source>
      <translation>測量した検証点との比較</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Picked by hand (cm)</source>
      <translation>手動読み取り(cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Fitting (cm)</source>
      <translation>当てはめ(cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Surveyed (cm)</source>
      <translation>測量値(cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Error, picked (cm)</source>
      <translation>誤差、手動(cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Error, fitting (cm)</source>
      <translation>誤差、当てはめ(cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>3D displacements of the same feature point, in the control frame (after Chan and Lichti, Table 1).</source>
      <translation>同じ特徴点の3D変位、基準点系(Chan and Lichti の表1による)。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>The survey has no check points that both epochs share.</source>
      <translation>両時期に共通する検証点がありません。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Survey control</source>
      <translation>測量の基準点</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Congruence of the stable units</source>
      <translation>安定ブロックの合同性</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Units that stand still together: {stable} of {all}; test of their congruence: p {p}.</source>
      <translation>共に静止しているブロック:{all} 個中 {stable} 個。合同検定:p {p}。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Their common motion against the control points: east {e}, north {n}, up {h} cm; p {p}.</source>
      <translation>基準点に対する共通の動き:東 {e}、北 {n}、上 {h} cm、p {p}。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>East (mm)</source>
      <translation>東(mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>North (mm)</source>
      <translation>北(mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Height (mm)</source>
      <translation>高さ(mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Use</source>
      <translation>使用</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>disturbed, left out</source>
      <translation>乱れあり、除外</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Residuals of the registration; w is the largest normalised residual of the three coordinates.</source>
      <translation>登録の残差。w は3座標の標準化残差の最大値。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>There is no survey control: displacements are relative to the frame of the clouds.</source>
      <translation>基準点がないため、変位は点群の座標系に対するものです。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Damage</source>
      <translation>被災</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>H = {height} m, Dn = {diameter} m. Lost and relocated units count as displaced by every threshold.</source>
      <translation>H = {height} m、Dn = {diameter} m。消失・移設のブロックはすべてのしきい値で変位とみなす。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Displaced by at least</source>
      <translation>次以上変位</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Threshold (m)</source>
      <translation>しきい値(m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Share</source>
      <translation>割合</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>State of the armour in the words of Campos et al. (2020):</source>
      <translation>Campos ら (2020) の用語による被覆層の状態:</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>No damage: no unit moved by one Dn or is lost. Initiation of damage: some did. Iribarren's damage: neighbours of the outer layer did. Initiation of destruction: a unit of the layer below did. Destruction cannot be told from units.</source>
      <translation>無被害: 1 Dn 以上動いた、または失われたブロックがない。被害開始: ある。Iribarren 被害: 外層の隣り合うブロック。破壊開始: 下層のブロック。破壊はブロックからは判らない。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>over {width} m: units displaced by one Dn or more, relocated or lost, per Dn of width (van der Meer, 1988).</source>
      <translation>{width} m あたり:1 Dn 以上の変位、移設、消失のブロック数、幅 Dn あたり(van der Meer, 1988)。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Sections along the axis</source>
      <translation>軸に沿った区間</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Share of displaced units per section</source>
      <translation>区間ごとの変位ブロックの割合</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>No unit has a displacement to show.</source>
      <translation>変位を示せるブロックがありません。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>Decisions and corrections</source>
      <translation>判定と修正</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>inspect on site</source>
      <translation>現地で点検</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>No reviewer has decided on this epoch pair.</source>
      <translation>この時期対を判定した照査者はいません。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>Correction</source>
      <translation>修正</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>By</source>
      <translation>実施者</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>As-built against design</source>
      <translation>出来形と設計</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Map of the units against the design</source>
      <translation>設計に対するブロックの地図</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units of {epoch} against the design; coordinates in {crs}.</source>
      <translation>設計に対する {epoch} のブロック。座標は {crs}。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units at a planned place</source>
      <translation>計画位置にあるブロック</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Within the tolerance</source>
      <translation>許容差内</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Outside the tolerance</source>
      <translation>許容差外</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Cannot be told</source>
      <translation>判定できない</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Deviation, median and largest (cm)</source>
      <translation>偏差、中央値と最大 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Planned</source>
      <translation>計画</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>East (cm)</source>
      <translation>東 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>North (cm)</source>
      <translation>北 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Up (cm)</source>
      <translation>上 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Deviation (cm)</source>
      <translation>偏差 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Rotation (°)</source>
      <translation>回転 (°)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>The {count} units farthest from their place; all stand in the file of tetratrack design.</source>
      <translation>位置から最も離れた {count} 個のブロック。すべては tetratrack design のファイルにあります。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units under the profile's lines</source>
      <translation>断面線の範囲内のブロック</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Centre off the design, mean and RMS (m)</source>
      <translation>中心の設計からの距離、平均と RMS (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Outermost point, mean and RMS (m)</source>
      <translation>最外点、平均と RMS (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>A unit is within or outside the tolerance where its standard deviation leaves no doubt of 5 % or more.</source>
      <translation>標準偏差により 5 % 以上の疑いが残らない場合に、許容差の内または外とします。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Map of displacements</source>
      <translation>変位図</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Displacement of the units' centres.</source>
      <translation>ブロック中心の変位。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Histogram of displacements</source>
      <translation>変位のヒストグラム</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Displacements of all units with the thresholds of the next section.</source>
      <translation>全ブロックの変位と次節のしきい値。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Units, one by one</source>
      <translation>ブロックごとの結果</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Zoom in</source>
      <translation>拡大</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Zoom out</source>
      <translation>縮小</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Whole map</source>
      <translation>地図全体</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Arrows</source>
      <translation>矢印</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Map of the units by class</source>
      <translation>区分別ブロック図</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Search</source>
      <translation>検索</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>all</source>
      <translation>すべて</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Displacement from (cm)</source>
      <translation>変位の下限 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>significant only</source>
      <translation>有意なもののみ</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Displacement (cm)</source>
      <translation>変位 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Blocks of both epochs</source>
      <translation>両時期のブロック</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>transparent</source>
      <translation>半透明</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Whole scene</source>
      <translation>全体を表示</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Drag turns, shift and drag moves, the wheel or two fingers zoom.</source>
      <translation>ドラッグで回転、Shift とドラッグで移動、ホイールまたは 2 本指で拡大縮小。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>This browser shows no 3D (WebGL): the picture of the blocks below stands for it.</source>
      <translation>このブラウザは 3D (WebGL) を表示できません。下のブロックの図で代えます。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>East</source>
      <translation>東</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>North</source>
      <translation>北</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Up</source>
      <translation>上</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>{shown} of {all} units</source>
      <translation>{all} 個中 {shown} 個</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>enlarged {times} times</source>
      <translation>{times} 倍に拡大</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>dashed: cut short</source>
      <translation>破線:短縮して表示</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Control point</source>
      <translation>基準点</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Control point, not used</source>
      <translation>基準点(不使用)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Frames and common motion</source>
      <translation>座標系と共通の動き</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The clouds of these epochs are bent. What targets say of the bend is removed from positions and from displacements in datum control; what resting units say besides, from displacements in datum stable.</source>
      <translation>これらの時期の点群は曲がっています。ターゲットから分かる曲がりは位置と基準 control の変位から、静止ブロックから分かる分はさらに基準 stable の変位から除かれています。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Bend, mean (mm)</source>
      <translation>曲がり、平均 (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Bend, largest (mm)</source>
      <translation>曲がり、最大 (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Left unknown, mean (mm)</source>
      <translation>残る不確かさ、平均 (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Correlation length (m)</source>
      <translation>相関長 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Targets used</source>
      <translation>使用ターゲット</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Error of the clouds along the structure with its 95 % band.</source>
      <translation>構造物に沿った点群の誤差と95 %帯。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>No bend of the clouds could be told from the noise of units and targets: frames are held stiff.</source>
      <translation>ブロックとターゲットの雑音から区別できる点群の曲がりはありません。座標系は剛体として扱われます。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Flight strips or stations drift against each other along the structure; this is removed.</source>
      <translation>飛行コースまたは測点が構造物に沿って互いにずれており、これは除かれています。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The cloud of {epoch} was aligned by its units alone: a motion of the whole structure cannot be seen.</source>
      <translation>{epoch} の点群はブロックだけで位置合わせされています。構造物全体の動きは見えません。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Common motion of stretches</source>
      <translation>区間の共通の動き</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Both epochs show too few units to tell a common motion of stretches.</source>
      <translation>両時期に写るブロックが少なく、区間の共通の動きは判別できません。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Mean displacement of the units of each stretch against the targets; the band holds what is not known of the frames.</source>
      <translation>ターゲットに対する各区間のブロックの平均変位。帯には座標系の未知分が含まれます。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Not both epochs have survey control: stretches are compared with each other, and a motion of all of them cannot be told.</source>
      <translation>両時期に基準点がそろっていないため区間同士を比べています。全体の動きは判別できません。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Height change and horizontal motion of stretches with their 95 % bands.</source>
      <translation>区間の高さ変化と水平の動き、95 %帯。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>From (m)</source>
      <translation>始点 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>To (m)</source>
      <translation>終点 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>No stretch moved as a whole by more than its band.</source>
      <translation>帯を超えて全体として動いた区間はありません。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Of {untold} of {all} stretches a common motion of one hundredth of the unit height cannot be told from the bend of the clouds: targets stand too far away.</source>
      <translation>{all} 区間のうち {untold} 区間では、ブロック高さの100分の1の共通の動きを点群の曲がりと区別できません。ターゲットが遠すぎます。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The result says nothing of its frames.</source>
      <translation>この結果には座標系についての記録がありません。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Units by class and control points; coordinates in {crs}.</source>
      <translation>区分別のブロックと基準点。座標系は {crs}。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Map of a part with the units' names</source>
      <translation>ブロック名入りの部分図</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Part {number} of {all} along the structure.</source>
      <translation>構造物に沿った部分 {number} / {all}。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Method, settings and versions</source>
      <translation>手法、設定、バージョン</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Units are found in the point cloud as four cones with a common centre, adjusted to their points (Gauss-Helmert model), and brought into the frame of the survey control; displacements are differences of the feature points that follow from the adjusted model, tested against their covariance (after Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds).</source>
      <translation>ブロックは共通の中心を持つ4つの円錐として点群から見つけ、その点に調整(ガウス・ヘルマートモデル)し、基準点系に移す。変位は調整したモデルから導く特徴点の差であり、共分散に対して検定する(Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds による)。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>σ0 of the registration</source>
      <translation>登録の σ0</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Settings</source>
      <translation>設定</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Written {moment} by {software}.</source>
      <translation>{moment} に {software} が作成。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Placement</source>
      <translation>配置</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units with neighbours on all sides</source>
      <translation>四方に隣接ブロックがあるもの</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Nearest centre, median and 5 % (Dn)</source>
      <translation>最近接中心間距離、中央値と 5 % (Dn)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Turn between neighbours, and expected at random</source>
      <translation>隣同士の回転、ランダムな場合の期待値</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Difference from turns at random, p</source>
      <translation>ランダムな回転との差、p</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Contacts of a unit, mean</source>
      <translation>ブロックの接触数、平均</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Free gap to the nearest unit, median (cm)</source>
      <translation>最も近いブロックとの隙間、中央値 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units in a column, of those with one below</source>
      <translation>列状のブロック/下にブロックを持つもの</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Off the surface of their neighbours, RMS and largest (m)</source>
      <translation>隣接面からの距離、RMS と最大 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Layer from outside</source>
      <translation>外側からの層</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units per 100 m²</source>
      <translation>100 m² あたりの個数</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Packing density, units per Dn²</source>
      <translation>充填密度 (Dn² あたり個数)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Share of the design number</source>
      <translation>設計値に対する割合</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units of {epoch}, each in the plane through its neighbours; those at the edge do not count for density. Only units that were found are counted: hidden ones of a lower layer are not. The design number is {packing} units per Dn² and layer (Shore Protection Manual, 1984).</source>
      <translation>{epoch} のブロック。それぞれ隣接ブロックを通る平面で見ます。端のブロックは密度に数えません。見つかったブロックだけを数え、下層の隠れたものは数えません。設計値は層あたり Dn² につき {packing} 個 (Shore Protection Manual, 1984)。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest and cross-sections</source>
      <translation>天端と横断面</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest height along the structure</source>
      <translation>構造物に沿う天端高</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Mean height of the tops of the crest's units in each reach, with its 95 % band.</source>
      <translation>各区間の天端ブロック頂部の平均高さと 95 % 帯。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest height (m)</source>
      <translation>天端高 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Highest (m)</source>
      <translation>最高 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest width (m)</source>
      <translation>天端幅 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Change (mm)</source>
      <translation>変化 (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>The crest of a reach are the units whose top lies less than 0.5 Dn below the highest one; its width is that of their outlines across the axis; the change is that of units that are the crest's in both epochs. Settlement of whole stretches stands under frames and common motion.</source>
      <translation>区間の天端とは、頂部が最高のものから 0.5 Dn 未満下にあるブロックです。幅は軸直交方向の輪郭の幅、変化は両時期とも天端にあるブロックのものです。区間全体の沈下は座標系と共通運動の節にあります。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Cross-sections</source>
      <translation>横断面</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Quality of the units</source>
      <translation>ブロックの品質</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Uncertain units</source>
      <translation>不確かなブロック</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Points to surface, median (mm)</source>
      <translation>点から表面までの距離の中央値（mm）</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Largest overlap</source>
      <translation>最大の重なり</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Pairs too close</source>
      <translation>近すぎる組</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Overlap is the share of a unit's volume inside another one; two solid units cannot overlap, nor can their centres come closer than half a height. A gap is a place where a unit is likely missing in the result; the layer gaps shows them.</source>
      <translation>重なりは、ブロックの体積のうち他のブロックの内部にある割合です。固体のブロック同士は重ならず、中心同士が高さの半分より近づくこともありません。欠落箇所は、結果にブロックが欠けている可能性が高い場所で、レイヤ gaps に示されます。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>The result does not state the quality of its units.</source>
      <translation>この結果にはブロックの品質の記録がありません。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Summary</source>
      <translation>要約</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units judged</source>
      <translation>評価したブロック</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Significant displacements</source>
      <translation>有意な変位</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Lost</source>
      <translation>消失</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Relocated</source>
      <translation>移設</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>New</source>
      <translation>新規</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Not seen in the later epoch</source>
      <translation>後の時期に見えない</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Uncertain, not counted</source>
      <translation>不確実（集計外）</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Displaced by 5 cm or more</source>
      <translation>5 cm 以上の変位</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Displaced by 10 cm or more</source>
      <translation>10 cm 以上の変位</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Decided by reviewers</source>
      <translation>照査者が判定</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Rejected by reviewers</source>
      <translation>照査者が棄却</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units known to be missing</source>
      <translation>欠けていると分かっているブロック</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Completeness</source>
      <translation>完全性</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units rejected by reviewers and left out of all figures, maps and tables below: {count}.</source>
      <translation>照査者が棄却し、以下の数値・地図・表から除いたブロック:{count}。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units that no reviewer has decided on yet: {count}.</source>
      <translation>まだ判定されていないブロック:{count}。</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Units with the largest displacements</source>
      <translation>変位の最も大きいブロック</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>East {e}, north {n}, up {h} cm; rotation {turn}; p {p}</source>
      <translation>東 {e}、北 {n}、上 {h} cm、回転 {turn}、p {p}</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Plan and section of {unit}</source>
      <translation>{unit} の平面と断面</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Series of {unit}</source>
      <translation>{unit} の時系列</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>No displacement is significant.</source>
      <translation>有意な変位はありません。</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>control used</source>
      <translation>使用した基準点</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>control not used</source>
      <translation>使用しない基準点</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>arrows: significant horizontal displacements, enlarged {scale} times</source>
      <translation>矢印:有意な水平変位、{scale} 倍に拡大</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>3D displacement (cm)</source>
      <translation>3D変位(cm)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>all units</source>
      <translation>全ブロック</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>units</source>
      <translation>ブロック数</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>plan</source>
      <translation>平面</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>section {azimuth}°</source>
      <translation>断面 {azimuth}°</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>chainage along the axis (m)</source>
      <translation>軸に沿った測点距離(m)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>Height change</source>
      <translation>高さ変化</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>Horizontal motion</source>
      <translation>水平の動き</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>units ≥ 10 cm (%)</source>
      <translation>10 cm 以上のブロック(%)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>easting (m)</source>
      <translation>東座標(m)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>northing (m)</source>
      <translation>北座標(m)</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>least and most around the leg</source>
      <translation>脚の周りの最小と最大</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>mean around the leg</source>
      <translation>脚の周りの平均</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>end disc</source>
      <translation>端面</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>share of the leg, from the unit's centre</source>
      <translation>脚の割合（中心から）</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>outside the cone (mm)</source>
      <translation>円錐の外側 (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>around the leg (degrees)</source>
      <translation>脚の周り（度）</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>no damage</source>
      <translation>無被害</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>initiation of damage</source>
      <translation>被害開始</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>Iribarren's damage</source>
      <translation>Iribarren 被害</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>initiation of destruction</source>
      <translation>破壊開始</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>within</source>
      <translation>内</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>outside</source>
      <translation>外</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>cannot be told</source>
      <translation>判定できない</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>chainage {along} m, axis at {east} / {north}</source>
      <translation>測点 {along} m、軸 {east} / {north}</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>height (m)</source>
      <translation>高さ (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>offset from the axis, left positive (m)</source>
      <translation>軸からの距離、左が正 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>crest height (m)</source>
      <translation>天端高 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>within the tolerance</source>
      <translation>許容差内</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>outside the tolerance</source>
      <translation>許容差外</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>not judged</source>
      <translation>判定なし</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>planned place without a unit</source>
      <translation>ブロックのない計画位置</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>unit without a planned place</source>
      <translation>計画位置のないブロック</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>surface of the points</source>
      <translation>点群の表面</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>design</source>
      <translation>設計</translation>
    </message>
  </context>
</TS>
