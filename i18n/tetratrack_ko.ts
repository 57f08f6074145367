<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko_KR" sourcelanguage="en">
  <context>
    <name>tetratrack</name>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Units at the common centre of their cones, with orientation, standard deviations (m, degrees), score and status.</source>
      <translation>원뿔들의 공통 중심에 놓인 블록. 자세, 표준편차(m, 도), 점수, 상태를 포함한다.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Centre and the four joints of three cones (f123, f124, f134, f234) of every unit, with covariance (m, m²).</source>
      <translation>각 블록의 중심과 세 원뿔의 접합점 네 개(f123, f124, f134, f234). 공분산(m, m²) 포함.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Displacement of every feature point between consecutive epochs (m), with test statistic and class.</source>
      <translation>연속한 시기 사이 각 특징점의 변위(m). 검정통계량과 등급 포함.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Residuals at the control points (m), with normalised residual; disturbed points are marked.</source>
      <translation>기준점 잔차(m)와 표준화 잔차. 교란된 점은 표시된다.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Feature points less surveyed check points (m).</source>
      <translation>특징점에서 측량한 검사점을 뺀 값(m).</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Monitoring</source>
      <translation>모니터링</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Single steps</source>
      <translation>개별 단계</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Planning and simulation</source>
      <translation>계획과 시뮬레이션</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Inputs and outputs</source>
      <translation>입력과 출력</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Limits</source>
      <translation>한계</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>The engine's result holds no layer {layer}.</source>
      <translation>엔진 결과에 레이어 {layer}이(가) 없습니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Numbers for models</source>
      <translation>모델용 수치</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Compare with design</source>
      <translation>설계와 비교</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Compares the units of one epoch with a placement plan and with a design profile: deviation and turn of every unit, places without a unit, distance from the design surface, and whether that is within the tolerance.</source>
      <translation>한 시기의 블록을 거치 계획 및 설계 단면과 비교합니다: 각 블록의 편차와 회전, 블록이 없는 위치, 설계면과의 거리, 허용오차 이내 여부.</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>A unit stands at the place of its own name, or at the nearest free one within one height H. Within or outside is said where the standard deviations leave no doubt of 5 % or more, open where they do.</source>
      <translation>블록은 같은 이름의 위치 또는 높이 H 이내의 가장 가까운 빈 위치에 대응합니다. 표준편차로 5 % 이상의 의심이 남지 않으면 이내 또는 초과로, 남으면 미정으로 판정합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>design,plan,placement,profile,tolerance,as-built,DXF</source>
      <translation>설계,계획,거치,단면,허용오차,준공,DXF</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>GeoPackage with the layers plan_deviations, plan_unmatched and profile_deviations, those that were asked for.</source>
      <translation>요청한 레이어 plan_deviations, plan_unmatched, profile_deviations가 담긴 GeoPackage.</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Deviations</source>
      <translation>편차</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Units outside the tolerance of the plan</source>
      <translation>계획 허용오차를 벗어난 블록</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Planned places without a unit</source>
      <translation>블록이 없는 계획 위치</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Units outside the tolerance of the profile</source>
      <translation>단면 허용오차를 벗어난 블록</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Cross-sections and crest</source>
      <translation>횡단면과 마루</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Cuts the structure across its axis: outlines of the blocks of every epoch, surface of the points and design in each section, height and width of the crest of each reach, and settlement along the structure.</source>
      <translation>구조물을 축에 직각으로 절단합니다: 각 단면에서 모든 시기의 블록 윤곽, 점군 표면과 설계, 구간별 마루 높이와 폭, 구조물을 따른 침하.</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Points are those read around the units for the review (unit-points); without them sections show blocks alone.</source>
      <translation>점은 검토를 위해 블록 주변에서 읽은 것(unit-points)입니다. 없으면 단면에 블록만 표시됩니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>profile,section,crest,settlement,chainage</source>
      <translation>종단,단면,마루,침하,측점</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>GeoPackage with the layers sections, crest and settlement.</source>
      <translation>레이어 sections, crest, settlement가 담긴 GeoPackage.</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Sections</source>
      <translation>단면</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Label of an epoch; empty for both takes the latest pair.</source>
      <translation>에포크의 이름. 둘 다 비우면 최신 쌍을 씁니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Displacement report</source>
      <translation>변위 보고서</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Writes the report of a result as reviewed so far: summary, control quality, displacement map and table, worst units, damage figures, method, settings and versions.</source>
      <translation>현재까지 검토된 결과의 보고서를 작성한다: 요약, 기준점 품질, 변위 지도와 표, 가장 나쁜 블록, 피해 지표, 방법, 설정, 버전.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Rejected units are left out of the statistics and listed apart. PDF needs the library weasyprint in the engine.</source>
      <translation>기각된 블록은 통계에서 빼고 따로 나열한다. PDF에는 엔진의 weasyprint 라이브러리가 필요하다.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>report,HTML,PDF,damage,displacement</source>
      <translation>보고서,HTML,PDF,피해,변위</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>that of the result</source>
      <translation>결과의 것</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>stable units and control</source>
      <translation>안정 블록과 기준점</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>control points alone</source>
      <translation>기준점만</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>What the displacements are stated against, in all of the report.</source>
      <translation>보고서 전체에서 변위의 기준이 되는 것.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Places easting,northing along it, separated by blanks; damage is then stated by sections.</source>
      <translation>구조물을 따라 동거,북거를 공백으로 구분해 적습니다. 그러면 피해가 구간별로 제시됩니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>0.09, 0.30 and 0.61 m (US Army Corps of Engineers)</source>
      <translation>0.09, 0.30, 0.61 m (미국 육군 공병단)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>5 and 10 cm</source>
      <translation>5 cm와 10 cm</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>0.5 and 1 Dn (nominal diameter)</source>
      <translation>0.5 Dn과 1 Dn (공칭 지름)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Limits by which the units are counted that moved.</source>
      <translation>움직인 블록을 세는 구간의 경계.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>So many of those that moved most get views, series and decisions of their own.</source>
      <translation>가장 많이 움직인 것 중 이만큼은 개별 그림, 시계열, 판정을 싣습니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>HTML in one file, or PDF; the ending decides.</source>
      <translation>한 파일의 HTML 또는 PDF. 확장자로 결정된다.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Earlier epoch</source>
      <translation>이전 에포크</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Later epoch</source>
      <translation>이후 에포크</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Reference of the displacements</source>
      <translation>변위의 기준</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Axis of the structure</source>
      <translation>구조물의 축</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length looked at (m)</source>
      <translation>대상 길이 (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of the structure in metres, for the damage number N_od.</source>
      <translation>피해수 N_od를 위한 구조물 길이(미터).</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of a section (m)</source>
      <translation>구간 길이 (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of the sections along the axis, in metres.</source>
      <translation>축을 따른 구간의 길이(미터).</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Movement bands</source>
      <translation>변위 구간</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Units shown one by one</source>
      <translation>하나씩 보이는 블록 수</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Report</source>
      <translation>보고서</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Give both epochs, or neither for the latest pair.</source>
      <translation>에포크를 둘 다 지정하거나, 최신 쌍을 쓰려면 둘 다 비우십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Export as-built model</source>
      <translation>준공 모델 내보내기</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Writes the units of one epoch as bodies at their fitted poses, coloured by class, with uncertainty and movement as properties, for CAD, BIM and 3D viewers. The ending of the file chooses the format: glTF (.glb), Wavefront (.obj), DXF, IFC4x3 or the poses alone (.json).</source>
      <translation>한 시기의 블록을 추정된 자세의 입체로 기록합니다. 분류별로 색을 입히고 불확도와 변위를 속성으로 담아 CAD, BIM, 3D 뷰어에서 쓸 수 있습니다. 형식은 파일 확장자가 정합니다: glTF(.glb), Wavefront(.obj), DXF, IFC4x3 또는 자세만(.json).</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Bodies have 24 plane faces a leg. glTF, OBJ, IFC and JSON hold coordinates less a reduction point that stands in the file; DXF holds coordinates of the survey CRS and needs the library ezdxf in the engine.</source>
      <translation>입체는 다리마다 24개의 평면을 가집니다. glTF, OBJ, IFC, JSON의 좌표는 파일에 적힌 기준점을 뺀 값입니다. DXF는 측량 CRS의 좌표를 담으며 엔진에 ezdxf 라이브러리가 필요합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>model,3D,glTF,GLB,OBJ,DXF,IFC,BIM,CAD,as-built</source>
      <translation>모델,3D,glTF,GLB,OBJ,DXF,IFC,BIM,CAD,준공</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Label of the epoch whose units are written; the latest one with units unless given.</source>
      <translation>블록을 기록할 시기의 라벨. 지정하지 않으면 블록이 있는 최신 시기.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>File to write; its ending decides the format.</source>
      <translation>기록할 파일. 확장자가 형식을 정합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Model</source>
      <translation>모델</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Extract feature points</source>
      <translation>특징점 추출</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Derives the centre and the four points where three cone surfaces meet on the outside of each unit, with the covariance carried over from the fit. These points can be surveyed by total station as well.</source>
      <translation>각 블록의 중심과 바깥쪽에서 세 원뿔면이 만나는 네 점을 구하고, 맞춤의 공분산을 전파한다. 이 점들은 토털스테이션으로도 측량할 수 있다.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>A joint is marked as observed only where points lie next to it; otherwise it follows from the rest of the unit.</source>
      <translation>접합점은 바로 옆에 점이 있을 때만 관측으로 표시하고, 아니면 블록의 나머지에서 유도한다.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>feature points,cone intersection,centre,covariance propagation</source>
      <translation>특징점,원뿔 교점,중심,공분산 전파</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Layer of units from Fit tetrapods or Monitor a survey.</source>
      <translation>'테트라포드 맞춤' 또는 '측량 모니터링'의 블록 레이어.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Points d1 to d4, which crews can measure and paint.</source>
      <translation>점 d1~d4. 현장에서 측정하고 칠할 수 있습니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>From the centre to the end disc, in metres; empty takes 0.644 H.</source>
      <translation>중심에서 끝면까지(미터). 비우면 0.644 H.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Fitted units</source>
      <translation>맞춘 블록</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Centres of the end discs as well</source>
      <translation>끝 원판의 중심도</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Leg length (m)</source>
      <translation>다리 길이(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Points</source>
      <translation>점</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Fit tetrapods</source>
      <translation>테트라포드 맞춤</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Fits four equal cones that share a centre to the points of each unit by an iterated Gauss–Helmert adjustment with robust weights, end discs and removal of the curvature bias; gives pose, radius, taper and their covariance.</source>
      <translation>중심을 공유하는 같은 원뿔 네 개를 각 블록의 점에 반복 가우스-헬머트 조정으로 맞춘다. 강건 가중치, 끝면, 곡률 편향 제거를 포함하며 자세, 반지름, 테이퍼와 공분산을 준다.</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>With one visible leg the twist about its axis is undetermined: the unit says so in its large standard deviation.</source>
      <translation>다리가 하나만 보이면 그 축 둘레의 회전은 정해지지 않으며, 큰 표준편차가 이를 알려 준다.</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>adjustment,Gauss-Helmert,least squares,cone,pose,covariance</source>
      <translation>조정,가우스-헬머트,최소제곱법,원뿔,자세,공분산</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Layer of units from Segment tetrapods, with the fields qx, qy, qz, qw of their orientation.</source>
      <translation>'테트라포드 분할'의 블록 레이어. 자세 필드 qx, qy, qz, qw 포함.</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Units found</source>
      <translation>찾은 블록</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Units fitted</source>
      <translation>맞춘 블록 수</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Inspect tiles</source>
      <translation>타일 점검</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Lists point cloud tiles with their extent, CRS, number and density of points and range of heights. Run it first: it shows missing CRS, gaps, overlaps and tiles too thin to find units in.</source>
      <translation>점군 타일의 범위, 좌표계, 점 수와 밀도, 높이 범위를 나열한다. 먼저 실행하면 좌표계 누락, 틈, 중복, 점이 너무 적은 타일을 알 수 있다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Reads headers and a sample of points; a damaged tile is named and ends the run.</source>
      <translation>헤더와 점 일부를 읽는다. 손상된 타일은 이름을 알리고 끝낸다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>point cloud,LAS,LAZ,tile index,density,CRS,extent</source>
      <translation>점군,LAS,LAZ,타일 색인,밀도,좌표계,범위</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>One rectangle per tile with file, CRS, points, density (points/m²) and heights (m).</source>
      <translation>타일마다 사각형 하나. 파일, 좌표계, 점 수, 밀도(점/m²), 높이(m) 포함.</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Tile index</source>
      <translation>타일 색인</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Tiles</source>
      <translation>타일 수</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Median density (points/m²)</source>
      <translation>밀도 중앙값(점/m²)</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>CRS of the tiles</source>
      <translation>타일 좌표계</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Monitor a survey</source>
      <translation>측량 모니터링</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>All steps at once: registers every epoch to survey control, finds the tetrapods, fits four cones that share a centre, derives feature points and tests their displacements. Give a survey.toml, or the epochs and the unit.</source>
      <translation>모든 단계를 한 번에: 각 시기를 기준점에 정합하고, 테트라포드를 찾고, 중심을 공유하는 원뿔 네 개를 맞추고, 특징점을 구해 변위를 검정한다. survey.toml 또는 시기와 블록을 준다.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Units of which less than about 5 % is seen are not found. Without control the cloud's own frame is used, and the result says so.</source>
      <translation>약 5 % 미만만 보이는 블록은 찾지 못한다. 기준점이 없으면 점군 자체 좌표계를 쓰고 결과에 그렇게 밝힌다.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>tetrapod,armour unit,breakwater,displacement,monitoring,LAS,LAZ,deformation</source>
      <translation>테트라포드,소파블록,방파제,변위,모니터링,LAS,LAZ,변형</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>A survey.toml; if given, it states everything, and the fields for epochs, unit, CRS and area are not used.</source>
      <translation>survey.toml. 주면 이것이 모두 정하며 시기, 블록, 좌표계, 영역 칸은 쓰지 않는다.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Label</source>
      <translation>이름</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Time (UTC)</source>
      <translation>시각(UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Control points</source>
      <translation>기준점</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Targets in the cloud</source>
      <translation>점군의 타깃</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Check points</source>
      <translation>검사점</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Epochs</source>
      <translation>시기</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>One row per epoch: label, time such as 2025-03-14T02:30, folder or files of tiles (separated by ;), CSV files or layers.</source>
      <translation>시기마다 한 행: 이름, 2025-03-14T02:30 같은 시각, 타일 폴더나 파일(;로 구분), CSV 파일이나 레이어.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Writes a top view of each epoch as GeoTIFF beside the result, as a backdrop.</source>
      <translation>각 시기의 평면도를 배경용 GeoTIFF로 결과 옆에 쓴다.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Adds all layers to the project as a group with their styles.</source>
      <translation>모든 레이어를 스타일과 함께 그룹으로 프로젝트에 더한다.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>GeoPackage with units, feature points, displacements, residuals, epochs and reviews, in the survey's CRS, times in UTC.</source>
      <translation>블록, 특징점, 변위, 잔차, 시기, 검토를 담은 GeoPackage. 측량 좌표계, 시각은 UTC.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Survey file</source>
      <translation>측량 파일</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Shaded relief of each epoch</source>
      <translation>각 시기의 음영기복도</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Load the result</source>
      <translation>결과 불러오기</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Result</source>
      <translation>결과</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Units moved</source>
      <translation>움직인 블록</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>RMSE at check points (m)</source>
      <translation>검사점 RMSE(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Give a survey.toml, or at least one epoch with its tiles.</source>
      <translation>survey.toml 또는 적어도 한 시기와 그 타일을 주십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Every epoch needs six columns: label, time, tiles, control points, targets, check points.</source>
      <translation>각 시기에는 여섯 열이 필요합니다: 이름, 시각, 타일, 기준점, 타깃, 검사점.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{place}: {time} is no time; write it as 2025-03-14, 2025-03-14T02:30 (UTC) or 2025-03-14T11:30+09:00.</source>
      <translation>{place}: {time}은(는) 시각이 아닙니다. 2025-03-14, 2025-03-14T02:30 (UTC) 또는 2025-03-14T11:30+09:00처럼 쓰십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{where}: there is no file or layer {path}.</source>
      <translation>{where}: 파일 또는 레이어 {path}이(가) 없습니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{where}: {path} cannot be read as a point layer or CSV file.</source>
      <translation>{where}: {path}을(를) 점 레이어나 CSV 파일로 읽을 수 없습니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>The folder {folder} does not exist.</source>
      <translation>폴더 {folder}이(가) 없습니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Relief {epoch}</source>
      <translation>음영기복 {epoch}</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>New survey from a folder</source>
      <translation>폴더에서 새 측량</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Writes a survey.toml from what the files in a folder say: epochs and times, CRS, control, targets and check points, and the size of the units from the cloud itself.</source>
      <translation>폴더의 파일에서 survey.toml을 작성합니다: 시기와 시각, 좌표계, 기준점, 표적, 검사점, 그리고 점군 자체에서 추정한 블록 크기.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Every value stands with its reason; what the files leave open is asked for in the log.</source>
      <translation>모든 값에 근거를 함께 적고, 파일로 알 수 없는 것은 로그에서 묻습니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>new survey,folder,tiles,epochs,size of units,survey.toml</source>
      <translation>새 측량,폴더,타일,시기,블록 크기,survey.toml</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Folder with the tiles of all epochs; tables of control lie in it or beside it.</source>
      <translation>모든 시기의 타일이 있는 폴더. 기준점 표는 그 안이나 옆에 둡니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Point cloud tiles</source>
      <translation>점군 타일</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Instead of a folder: point cloud layers, or files, of all epochs.</source>
      <translation>폴더 대신 모든 에포크의 점군 레이어 또는 파일.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Projected CRS in metres; needed only where the tiles declare none.</source>
      <translation>미터 단위 투영 좌표계. 타일에 좌표계가 없을 때만 필요합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Empty estimates it from the cloud.</source>
      <translation>비워 두면 점군에서 추정합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Text file to look through, correct and run.</source>
      <translation>살펴보고 고쳐서 실행할 텍스트 파일.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Folder of tiles</source>
      <translation>타일 폴더</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>CRS of the results</source>
      <translation>결과 좌표계</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Height of the units (m)</source>
      <translation>블록 높이 (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Survey</source>
      <translation>측량</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Give a folder of tiles, or tiles.</source>
      <translation>타일 폴더 또는 타일을 지정하십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Plan a survey: detectable displacement</source>
      <translation>측량 계획: 검출 가능한 변위</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Computes which displacement and rotation of a unit a planned survey will find, from point density, noise, visible share and registration: the Cramér–Rao bound of the adjustment for the unit's geometry, and Baarda's detectability.</source>
      <translation>점 밀도, 잡음, 보이는 비율, 정합으로부터 계획한 측량이 찾을 블록의 변위와 회전을 계산한다. 블록 형상에 대한 조정의 크라메르-라오 한계와 바르다의 검출력에 따른다.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>White noise is averaged over the points of a unit; whatever does not average out must be stated as systematic part. The shares of units found are those measured on simulated piles of that density and noise, seen from above.</source>
      <translation>백색 잡음은 블록의 점에서 평균된다. 평균되지 않는 것은 계통 성분으로 주어야 한다. 검출되는 블록의 비율은 그 밀도와 잡음으로 위에서 본 모의 더미에서 측정한 값이다.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>planning,detectability,point density,noise,Cramér-Rao bound,minimal detectable displacement</source>
      <translation>계획,검출 가능성,점 밀도,잡음,크라메르-라오 한계,최소 검출 변위</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Point density (points/m²)</source>
      <translation>점 밀도(점/m²)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>On a surface that faces the instrument, all flight strips or stations together.</source>
      <translation>기기를 향한 면에서, 모든 비행 코스나 측점을 합한 값.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Noise of a point (m)</source>
      <translation>점 잡음(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation along the surface normal, in metres.</source>
      <translation>면 법선 방향 표준편차(미터).</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Visible share of a unit</source>
      <translation>블록의 보이는 비율</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share of a unit's surface that holds points, 0 to 1; in a pile 0.05 to 0.5.</source>
      <translation>점이 있는 표면의 비율(0~1). 쌓인 상태에서는 0.05~0.5.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Registration (m)</source>
      <translation>정합(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of an epoch's registration at the unit, per coordinate, in metres.</source>
      <translation>블록 위치에서 한 시기 정합의 표준편차. 좌표마다, 미터.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Systematic part (m)</source>
      <translation>계통 성분(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Strip offsets, roughness and growth that do not average out, per coordinate, in metres.</source>
      <translation>평균되지 않는 코스 간 편차, 거칠기, 부착 생물. 좌표마다, 미터.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Line of sight from the vertical (degrees)</source>
      <translation>연직에서 잰 시선각(도)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>0 from the air; about 70 from the crown wall.</source>
      <translation>공중에서는 0, 상치벽에서는 약 70.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Calibrated and held; otherwise they are estimated for every unit, which costs accuracy.</source>
      <translation>검정하여 고정한다. 아니면 블록마다 추정하며 정확도가 떨어진다.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Level of significance</source>
      <translation>유의수준</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Probability of a false alarm for one unit.</source>
      <translation>블록 하나에서 오경보가 날 확률.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Power</source>
      <translation>검정력</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Probability with which the displacement is found.</source>
      <translation>변위를 찾을 확률.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>What the survey detects over point density and visible share, beside the plan.</source>
      <translation>계획과 함께, 점밀도와 보이는 비율에 따라 측량이 검출하는 변위.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Points on a unit</source>
      <translation>블록당 점 수</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of the centre (m)</source>
      <translation>중심의 표준편차(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of the rotation (degrees)</source>
      <translation>회전의 표준편차(도)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of a displacement (m)</source>
      <translation>변위의 표준편차(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable displacement, worst direction (m)</source>
      <translation>검출 가능한 변위, 가장 나쁜 방향(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable displacement, mean (m)</source>
      <translation>검출 가능한 변위, 평균(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable rotation (degrees)</source>
      <translation>검출 가능한 회전(도)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Points per square of a unit's height</source>
      <translation>블록 높이의 제곱당 점 수</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 30 % or more</source>
      <translation>30 % 이상 보이는 블록의 검출 비율</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 15–30 %</source>
      <translation>15~30 % 보이는 블록의 검출 비율</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 5–15 %</source>
      <translation>5~15 % 보이는 블록의 검출 비율</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>The level of significance must be below the power.</source>
      <translation>유의수준은 검정력보다 작아야 합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Radius and taper are known</source>
      <translation>반지름과 테이퍼를 앎</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Chart</source>
      <translation>도표</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Web page (*.html)</source>
      <translation>웹 페이지 (*.html)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>{file} cannot be written: {reason}.</source>
      <translation>{file}에 쓸 수 없습니다: {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/provider.py" />
      <source>Tetratrack: displacements of tetrapods</source>
      <translation>Tetratrack: 테트라포드 변위</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Register to control</source>
      <translation>기준점에 정합</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Estimates the rigid transformation from an epoch's cloud to survey control from targets, weighted by their standard deviations, and finds disturbed targets by data snooping on normalised residuals.</source>
      <translation>표준편차로 가중한 타깃에서 한 시기 점군을 기준점계로 옮기는 강체변환을 추정하고, 표준화 잔차의 데이터 스누핑으로 교란된 타깃을 찾는다.</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Needs three targets that do not lie in one line; an outlier is found from four, and named surely from five.</source>
      <translation>한 직선 위에 있지 않은 타깃 셋이 필요하다. 이상값은 넷부터 찾고 다섯부터 확실히 지목한다.</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>registration,control points,targets,transformation,data snooping,georeferencing</source>
      <translation>정합,기준점,타깃,변환,데이터 스누핑,지오레퍼런싱</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>GeoPackage whose table epochs holds the seven parameters and their covariance.</source>
      <translation>epochs 표에 7개 매개변수와 공분산을 담은 GeoPackage.</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Registration</source>
      <translation>정합 결과</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>RMSE at control points (m)</source>
      <translation>기준점 RMSE(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Disturbed targets</source>
      <translation>교란된 타깃</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Register views</source>
      <translation>뷰 정합</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Brings overlapping views of a depth camera or scanner stations into the frame of the first by multiway ICP with a pose graph, and writes one cloud in which every view keeps its number as point source id.</source>
      <translation>겹치는 깊이 카메라 뷰나 스캐너 측점을 포즈 그래프 다방향 ICP로 첫 뷰의 좌표계로 옮기고, 각 뷰의 번호를 점 출처 ID로 갖는 점군 하나를 쓴다.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Views must overlap by a third or more and be roughly aligned; views that do not connect are named.</source>
      <translation>뷰는 3분의 1 이상 겹치고 대략 정렬되어 있어야 한다. 이어지지 않는 뷰는 이름을 알린다.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>registration,ICP,pose graph,depth camera,multi-view</source>
      <translation>정합,ICP,포즈 그래프,깊이 카메라,다시점</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Resolution at which views are matched, in metres; empty derives it from the point spacing.</source>
      <translation>뷰를 맞대는 해상도(미터). 비우면 점 간격에서 정한다.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>One LAZ file in the frame of the first view.</source>
      <translation>첫 뷰 좌표계의 LAZ 파일 하나.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Views</source>
      <translation>뷰</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Voxel size (m)</source>
      <translation>복셀 크기(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Registered cloud</source>
      <translation>정합된 점군</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>RMSE between views (m)</source>
      <translation>뷰 사이 RMSE(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Points less blocks</source>
      <translation>점군과 블록의 차이</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Writes the points around the units of one epoch with their distance to the nearest fitted unit, coloured from blue (10 cm or more within a body) through white to red (10 cm or more outside): what is red is debris, a unit that was missed, or one that is broken.</source>
      <translation>한 시기의 블록 주변 점을 가장 가까운 적합 블록까지의 거리와 함께 기록합니다. 색은 파랑(안쪽 10 cm 이상)에서 흰색을 거쳐 빨강(바깥 10 cm 이상). 빨간 점은 파편, 놓친 블록 또는 부서진 블록입니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Points are those read around the units for the review (unit-points), in the control frame. For units lower than 2 m, and models of a tank, colours end at 5 % of the height H instead of 10 cm; points near no unit have the distance 10 m.</source>
      <translation>점은 검토를 위해 블록 주변에서 읽은 것(unit-points)이며 기준점 좌표계에 있습니다. 높이 2 m 미만의 블록과 수조 모형에서는 색이 10 cm 대신 높이 H의 5 %에서 끝납니다. 가까이에 블록이 없는 점의 거리는 10 m입니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>residuals,LAZ,LAS,point cloud,distance</source>
      <translation>잔차,LAZ,LAS,점군,거리</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Point cloud with the dimensions distance (m) and unit.</source>
      <translation>차원 distance (m)와 unit이 있는 점군.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Label of the epoch whose units are looked at; the latest one with units unless given.</source>
      <translation>대상 시기의 이름. 지정하지 않으면 블록이 있는 최신 시기.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Degrees a unit may be turned from its planned orientation.</source>
      <translation>계획 방향으로부터의 허용 회전(도).</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>GeoPackage written by Monitor a survey.</source>
      <translation>'측량 모니터링'이 쓴 GeoPackage.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Path of a CSV unit_id,easting,northing,height with the planned centres, optionally qx,qy,qz,qw, or of a layer of points with heights (FILE|layername=NAME).</source>
      <translation>계획 중심의 CSV unit_id,easting,northing,height(선택적으로 qx,qy,qz,qw) 또는 높이가 있는 점 레이어(FILE|layername=NAME)의 경로.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of places (m)</source>
      <translation>위치 허용오차 (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres a unit may be from its planned place.</source>
      <translation>계획 위치로부터의 허용 거리(미터).</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of turns (°)</source>
      <translation>회전 허용오차 (°)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Path of a DXF or of a layer of lines with heights: a single line is a cross-section along the whole structure, several are its edges.</source>
      <translation>DXF 또는 높이가 있는 선 레이어의 경로. 선 하나는 구조물 전체의 횡단면, 여러 선은 그 모서리.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres a unit may be off the design profile.</source>
      <translation>설계 단면으로부터의 허용 거리(미터).</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Places easting,northing along it, separated by blanks; the centreline of the units unless given.</source>
      <translation>축을 따라 easting,northing 위치를 공백으로 구분. 지정하지 않으면 블록의 중심선.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Distance of the sections (m)</source>
      <translation>단면 간격 (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres along the axis; four heights of a unit unless given.</source>
      <translation>축을 따른 미터. 지정하지 않으면 블록 높이의 4배.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Epoch</source>
      <translation>시기</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Placement plan</source>
      <translation>거치 계획</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Design profile</source>
      <translation>설계 단면</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of the profile (m)</source>
      <translation>단면 허용오차 (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>outermost point of a unit</source>
      <translation>블록의 가장 바깥 점</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>centre of a unit</source>
      <translation>블록의 중심</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>What is judged against the design profile; both distances are written.</source>
      <translation>설계 단면에 대해 판정할 대상. 두 거리 모두 기록됩니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>All files (*.*)</source>
      <translation>모든 파일 (*.*)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Judged against the profile</source>
      <translation>단면에 대한 판정 대상</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Segment tetrapods</source>
      <translation>테트라포드 분할</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Finds every tetrapod in a pile: cones from pairs of oriented points, legs that agree on a common centre and on the angles between them, and verification against the visible surface and against empty space.</source>
      <translation>더미의 모든 테트라포드를 찾는다: 법선이 있는 점 쌍에서 원뿔, 중심과 다리 각이 일치하는 다리, 보이는 면과 빈 공간에 의한 검증.</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Units of which less than about 5 % is seen are not found; weak evidence has the status uncertain. Poses are approximate: fit them next.</source>
      <translation>약 5 % 미만만 보이는 블록은 찾지 못한다. 증거가 약하면 상태가 불확실이다. 자세는 근사이므로 다음에 맞춘다.</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>segmentation,RANSAC,cone,tetrapod,armour unit,detection</source>
      <translation>분할,RANSAC,원뿔,테트라포드,소파블록,탐지</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Simulate a survey</source>
      <translation>측량 시뮬레이션</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Writes a simulated survey of a tetrapod slope with known poses: LAZ tiles, control, check points and survey.toml. Use it to try the chain, to train, or to test a planned density and noise.</source>
      <translation>자세를 아는 테트라포드 비탈의 모의 측량을 쓴다: LAZ 타일, 기준점, 검사점, survey.toml. 절차 시험, 연습, 계획한 밀도와 잡음의 시험에 쓴다.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Simulated surfaces are cleaner than real ones; judge a plan with some reserve.</source>
      <translation>모의 표면은 실제보다 깨끗하니 계획을 여유 있게 판단한다.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>simulation,synthetic,ground truth,test data</source>
      <translation>시뮬레이션,합성,참값,시험 데이터</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>UAV laser scanner</source>
      <translation>UAV 레이저 스캐너</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>terrestrial laser scanner</source>
      <translation>지상 레이저 스캐너</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>photogrammetry</source>
      <translation>사진측량</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>depth camera</source>
      <translation>깊이 카메라</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Decides viewpoints, hidden parts and, unless stated, noise and density.</source>
      <translation>시점, 가려진 부분, 그리고 따로 주지 않으면 잡음과 밀도를 정한다.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Number of units on the slope.</source>
      <translation>비탈 위 블록 수.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Number of surveys; some units move between them.</source>
      <translation>측량 횟수. 그 사이 일부 블록이 움직인다.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Standard deviation of the range, in metres; empty takes that of the instrument.</source>
      <translation>거리의 표준편차(미터). 비우면 기기의 값을 쓴다.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>On the ground; empty takes that of the instrument.</source>
      <translation>지면 기준. 비우면 기기의 값을 쓴다.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>A coast of this length, of stretches that hold the number of units each; empty gives one site.</source>
      <translation>이 길이의 해안을 각각 지정한 개수의 블록을 가진 구간들로 만듭니다. 비워 두면 한 현장입니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Error of the trajectory along the site in metres, root mean square of each coordinate; empty for none.</source>
      <translation>현장을 따른 궤적 오차(미터, 좌표별 제곱평균제곱근). 비워 두면 없음.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>The same seed gives the same survey.</source>
      <translation>같은 시드는 같은 측량을 만든다.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Receives tiles, CSV files, survey.toml and truth.</source>
      <translation>타일, CSV 파일, survey.toml, 참값을 받는다.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Instrument</source>
      <translation>기기</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Units</source>
      <translation>블록</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Length of a coast (m)</source>
      <translation>해안 길이 (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Bend of every epoch (m)</source>
      <translation>각 시기의 휨 (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Seed</source>
      <translation>시드</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Survey folder</source>
      <translation>측량 폴더</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>survey.toml of the simulated survey</source>
      <translation>모의 측량의 survey.toml</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>The tetratrack engine is not installed: open Settings &gt; Options &gt; Tetratrack and create its environment or choose one.</source>
      <translation>tetratrack 엔진이 설치되어 있지 않습니다. 설정 &gt; 옵션 &gt; Tetratrack을 열어 환경을 만들거나 고르십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>Create or choose the engine…</source>
      <translation>엔진 만들기 또는 선택…</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>Make the environment again…</source>
      <translation>환경 다시 만들기…</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>The engine ended unexpectedly (exit code {code}); QGIS and your data are unharmed.</source>
      <translation>엔진이 예기치 않게 끝났습니다(종료 코드 {code}). QGIS와 데이터는 무사합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>QGIS runs version {plugin} of the plugin, but its files are of version {engine}: restart QGIS.</source>
      <translation>QGIS에서는 플러그인 버전 {plugin}이 실행 중이지만 파일은 버전 {engine}입니다. QGIS를 다시 시작하십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>The engine could not be started with {python}: {reason}.</source>
      <translation>{python}(으)로 엔진을 시작할 수 없습니다: {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/environment.py" />
      <source>The tetratrack engine was made for another version of the plugin: let it be brought up to date in Settings &gt; Options.</source>
      <translation>tetratrack 엔진이 다른 버전의 플러그인용으로 만들어졌습니다. 설정 &gt; 옵션에서 갱신하십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/environment.py" />
      <source>The Python that the tetratrack engine was made with is gone: let its environment be made again in Settings &gt; Options.</source>
      <translation>tetratrack 엔진을 만들 때 쓴 Python이 없어졌습니다. 설정 &gt; 옵션에서 환경을 다시 만드십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Unit</source>
      <translation>블록</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Point</source>
      <translation>점</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Unit in the plan</source>
      <translation>계획상의 블록</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Section</source>
      <translation>단면</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Time</source>
      <translation>시각</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Until</source>
      <translation>까지</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>From epoch</source>
      <translation>이전 에포크</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>To epoch</source>
      <translation>이후 에포크</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>From</source>
      <translation>시작</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>To</source>
      <translation>끝</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Feature point</source>
      <translation>특징점</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Type of unit</source>
      <translation>블록 종류</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Status</source>
      <translation>상태</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Class</source>
      <translation>등급</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Kind</source>
      <translation>종류</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Grade</source>
      <translation>등급</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Datum</source>
      <translation>기준</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reference epoch</source>
      <translation>기준 에포크</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>May be</source>
      <translation>후보</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest units</source>
      <translation>가장 가까운 블록</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Decision</source>
      <translation>결정</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Comment</source>
      <translation>의견</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reviewer</source>
      <translation>검토자</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reviewed</source>
      <translation>검토 시각</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Confirmed by</source>
      <translation>확인자</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Confirmed</source>
      <translation>확인 시각</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Editor</source>
      <translation>편집자</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Edited</source>
      <translation>편집 시각</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Taken back</source>
      <translation>취소됨</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Picked by</source>
      <translation>선택한 사람</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Picked</source>
      <translation>선택 시각</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reason</source>
      <translation>이유</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Known by</source>
      <translation>근거</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Software</source>
      <translation>소프트웨어</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>File</source>
      <translation>파일</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>CRS</source>
      <translation>좌표계</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Measured</source>
      <translation>측정일</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Verdict</source>
      <translation>판정</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Remark</source>
      <translation>비고</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>LAS version</source>
      <translation>LAS 버전</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Point format</source>
      <translation>점 형식</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>COPC</source>
      <translation>COPC</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height H</source>
      <translation>높이 H</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Area</source>
      <translation>면적</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Radius</source>
      <translation>반지름</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Easting component</source>
      <translation>동쪽 성분</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Northing component</source>
      <translation>북쪽 성분</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height component</source>
      <translation>높이 성분</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Horizontal displacement</source>
      <translation>수평 변위</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement</source>
      <translation>변위</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Azimuth</source>
      <translation>방위각</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. easting</source>
      <translation>표준편차 동</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. northing</source>
      <translation>표준편차 북</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. height</source>
      <translation>표준편차 높이</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Rotation</source>
      <translation>회전</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. rotation</source>
      <translation>표준편차 회전</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Detectable</source>
      <translation>검출 가능량</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement / H</source>
      <translation>변위 / H</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement / Dn</source>
      <translation>변위 / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Missing of a leg</source>
      <translation>다리 결손 길이</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Distance of the points</source>
      <translation>점의 거리</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest centre</source>
      <translation>가장 가까운 중심</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along the structure</source>
      <translation>구조물을 따라</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along, from</source>
      <translation>따라, 시작</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along, to</source>
      <translation>따라, 끝</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Correlation length</source>
      <translation>상관 거리</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Lowest height</source>
      <translation>최저 높이</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Greatest height</source>
      <translation>최고 높이</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev.</source>
      <translation>표준편차</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. displacement</source>
      <translation>표준편차 변위</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest of the other side</source>
      <translation>상대 쪽의 가장 가까운 것</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height of the design</source>
      <translation>설계 높이</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Centre off the design</source>
      <translation>중심의 설계로부터의 거리</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Outermost point off the design</source>
      <translation>최외곽점의 설계로부터의 거리</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height of the crest</source>
      <translation>마루 높이</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Highest top</source>
      <translation>가장 높은 꼭대기</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Width of the crest</source>
      <translation>마루 폭</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Change</source>
      <translation>변화</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. change</source>
      <translation>표준편차 변화</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>95 % band, from</source>
      <translation>95 % 대역, 하한</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>95 % band, to</source>
      <translation>95 % 대역, 상한</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>p-value</source>
      <translation>p값</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>p-value, adjusted</source>
      <translation>p값(보정)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Significant</source>
      <translation>유의</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Sigma 0</source>
      <translation>시그마 0</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Used</source>
      <translation>사용</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Points/m²</source>
      <translation>점/m²</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Legs seen</source>
      <translation>보이는 다리</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Probability of a broken leg</source>
      <translation>다리 파손 확률</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Share seen</source>
      <translation>보이는 비율</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Probability</source>
      <translation>확률</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Share supported</source>
      <translation>지지 비율</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Overlap</source>
      <translation>겹침</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Observed</source>
      <translation>관측</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Normalised residual</source>
      <translation>정규화 잔차</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Disturbed</source>
      <translation>이상</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Strip</source>
      <translation>스트립</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Layer of the armour</source>
      <translation>피복층</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Packing</source>
      <translation>충전 밀도</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Spacing / Dn</source>
      <translation>간격 / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Turn against the neighbour</source>
      <translation>이웃에 대한 회전</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Off the surface</source>
      <translation>면에서의 거리</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Off the surface / Dn</source>
      <translation>면에서의 거리 / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Contacts</source>
      <translation>접촉 수</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Free gap</source>
      <translation>틈</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>In a column</source>
      <translation>세로열</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}</source>
      <translation>다리 {number}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}: missing</source>
      <translation>다리 {number}: 결손 길이</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}: probability of a break</source>
      <translation>다리 {number}: 파손 확률</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>LAS, LAZ, COPC, E57 or PLY files, a folder of them, a virtual point cloud (.vpc) or point cloud layers; coordinates in metres.</source>
      <translation>LAS, LAZ, COPC, E57, PLY 파일, 그 폴더, 가상 점군(.vpc) 또는 점군 레이어. 좌표는 미터.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Projected CRS in metres; empty takes that of the tiles, and a local frame if they declare none.</source>
      <translation>미터 단위 투영 좌표계. 비우면 타일의 좌표계를, 선언이 없으면 지역 좌표계를 쓴다.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Label of this survey in all results, for example its date.</source>
      <translation>모든 결과에 쓰이는 이 측량의 이름. 예: 날짜.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Drives the temporal controller; empty takes the date of the first tile.</source>
      <translation>시간 컨트롤러를 움직인다. 비우면 첫 타일의 날짜를 쓴다.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Estimates both from the best-seen units and holds them: moulds differ by centimetres from the standard proportions.</source>
      <translation>가장 잘 보이는 블록에서 둘 다 추정해 고정한다. 거푸집은 표준 비율과 수 센티미터 다르다.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Catalogue name with the mass in tonnes, such as tetrapod 8 t; or tetrapod with a height of your own.</source>
      <translation>질량(톤)이 붙은 목록 이름(예: tetrapod 8 t), 또는 높이를 직접 준 tetrapod.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>From the plane under three legs to the top of the fourth, in metres; overrides the catalogue.</source>
      <translation>세 다리 아래 평면에서 네 번째 다리 끝까지(미터). 목록 값보다 우선한다.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Radius of a leg's cone at the unit's centre, in metres; empty takes 0.264 H.</source>
      <translation>블록 중심에서 다리 원뿔의 반지름(미터). 비우면 0.264 H.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Loss of radius per metre along the leg's axis; empty takes 0.176.</source>
      <translation>다리 축을 따라 1미터당 줄어드는 반지름. 비우면 0.176.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Built tetrapods are tetrahedral; 120° between leg 1 and the others repeats the published equations.</source>
      <translation>실물 테트라포드는 정사면체형이다. 다리 1과 나머지 사이 120°는 논문 식을 재현한다.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Polygon inside which units are looked for; its outer ring is used. Empty means everywhere.</source>
      <translation>블록을 찾을 폴리곤. 바깥 고리를 쓴다. 비우면 전체.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Polygons around surfaces that do not move, such as the crown wall: they tie epochs without control to the earliest with control, or to the first.</source>
      <translation>상치콘크리트처럼 움직이지 않는 면을 둘러싼 폴리곤: 기준점이 없는 시기를 기준점이 있는 가장 이른 시기, 없으면 첫 시기에 연결합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>the survey itself tells</source>
      <translation>측량 자료가 스스로 판단</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>rigid</source>
      <translation>강체</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>elastic</source>
      <translation>탄성</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Long flights bend by centimetres over tens to hundreds of metres. The survey itself tells by its units and targets whether an epoch's cloud is bent; rigid holds it stiff (short sites, one set-up), elastic lets it bend on any evidence.</source>
      <translation>긴 비행은 수십에서 수백 미터에 걸쳐 수 센티미터 휩니다. 각 시기의 점군이 휘었는지는 측량 자료가 블록과 표적으로 스스로 판단합니다. 강체는 휨을 허용하지 않고(짧은 현장, 한 번의 설치), 탄성은 작은 증거만 있어도 휨을 허용합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Blocks of the survey worked on at the same time; each takes about 1 GB of memory.</source>
      <translation>동시에 처리하는 측량 구획 수. 하나에 메모리 약 1 GB가 든다.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Surveyed targets: point layer or CSV with point_id, easting, northing, height, sd_e, sd_n, sd_h (m).</source>
      <translation>측량한 타깃: point_id, easting, northing, height, sd_e, sd_n, sd_h(m)를 가진 점 레이어나 CSV.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The same targets as measured in this epoch's cloud: point layer or CSV with point_id, x, y, z (m).</source>
      <translation>이 시기 점군에서 잰 같은 타깃: point_id, x, y, z(m)를 가진 점 레이어나 CSV.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Surveyed joints of cones, for validation only: CSV or layer with point_id, unit_easting, unit_northing, unit_height and position (m).</source>
      <translation>측량한 원뿔 접합점(검증 전용): point_id, unit_easting, unit_northing, unit_height와 위치(m)를 가진 CSV나 레이어.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Give the height H of the unit, or choose a catalogue name with its mass, such as tetrapod 8 t.</source>
      <translation>블록 높이 H를 주거나 tetrapod 8 t처럼 질량이 붙은 목록 이름을 고르십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The type of unit must be tetrapod, or a catalogue name such as tetrapod 8 t.</source>
      <translation>블록 종류는 tetrapod 또는 tetrapod 8 t 같은 목록 이름이어야 합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Control points and targets in the cloud belong together: give both, or neither.</source>
      <translation>기준점과 점군의 타깃은 한 쌍입니다. 둘 다 주거나 모두 비우십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Time of the survey (UTC)</source>
      <translation>측량 시각(UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Epoch {label} (row {row})</source>
      <translation>에포크 {label} ({row}행)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Calibrate radius and taper</source>
      <translation>반지름과 테이퍼 검정</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Height H of the unit (m)</source>
      <translation>블록 높이 H(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Cone radius at the centre (m)</source>
      <translation>중심에서 원뿔 반지름(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Taper of the leg</source>
      <translation>다리 테이퍼</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Angle between the legs</source>
      <translation>다리 사이 각</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Area of interest</source>
      <translation>관심 영역</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Stable areas</source>
      <translation>안정 영역</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Frames of the epochs</source>
      <translation>시기별 좌표틀</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Worker processes</source>
      <translation>작업 프로세스</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The cone radius must be smaller than half the height of the unit.</source>
      <translation>원뿔 반지름은 블록 높이의 절반보다 작아야 합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The area of interest holds no polygon.</source>
      <translation>관심 영역에 폴리곤이 없습니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The area of interest has several separate parts; give one polygon.</source>
      <translation>관심 영역이 여러 조각입니다. 폴리곤 하나를 주십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Virtual point clouds (*.vpc)</source>
      <translation>가상 점군 (*.vpc)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Epoch in row {row}</source>
      <translation>{row}행의 에포크</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>tetrahedral (109.5°)</source>
      <translation>정사면체형(109.5°)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>as in the paper (120°)</source>
      <translation>논문대로(120°)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{crs} is geographic; choose a projected CRS in metres.</source>
      <translation>{crs}은(는) 지리 좌표계입니다. 미터 단위 투영 좌표계를 고르십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{where}: no point cloud is given.</source>
      <translation>{where}: 점군이 없습니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The layers {one} and {other} have different CRS, and that of {one} is set by hand. Set the same one for both.</source>
      <translation>레이어 {one}과(와) {other}의 CRS가 서로 다르며, {one}의 CRS는 수동으로 지정되었습니다. 두 레이어에 같은 CRS를 지정하십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} cannot be written: {reason}.</source>
      <translation>{layer}을(를) 쓸 수 없습니다: {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} has no field {fields}; it has {present}.</source>
      <translation>{layer}에 필드 {fields}이(가) 없습니다. 있는 것: {present}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Point clouds ({endings})</source>
      <translation>점군 ({endings})</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{where}: the folder {path} holds no point cloud (LAS, LAZ, COPC, E57, PLY).</source>
      <translation>{where}: 폴더 {path}에 점군 (LAS, LAZ, COPC, E57, PLY)이 없습니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} cannot be transformed to the CRS of the results: {reason}.</source>
      <translation>{layer}을(를) 결과의 좌표계로 변환할 수 없습니다: {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>error as targets see it</source>
      <translation>타깃으로 본 오차</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>difference of two epochs as units see it</source>
      <translation>블록으로 본 두 시기의 차이</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>strip against its epoch</source>
      <translation>시기 평균에 대한 스트립 편차</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>moved as one</source>
      <translation>함께 이동</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>no common motion that could be told</source>
      <translation>구별되는 공통 이동 없음</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>found</source>
      <translation>찾음</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>uncertain</source>
      <translation>불확실</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>new</source>
      <translation>신규</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>relocated</source>
      <translation>이탈</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>stable</source>
      <translation>안정</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>moved</source>
      <translation>이동</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>rotated</source>
      <translation>회전</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>lost: the place is empty</source>
      <translation>유실: 자리가 비어 있음</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>unseen: known from another epoch</source>
      <translation>보이지 않음: 다른 시기에 알려짐</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>unexplained points where a unit fits</source>
      <translation>블록이 들어맞는 자리의 설명되지 않은 점</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>hole where a unit fits</source>
      <translation>블록이 들어맞는 빈 곳</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>below the detection limit</source>
      <translation>검출 한계 미만</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>significant</source>
      <translation>유의</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>watch</source>
      <translation>주의</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>alert or more</source>
      <translation>경보 이상</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>relocated unit</source>
      <translation>이탈한 블록</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>uncertain unit</source>
      <translation>불확실한 블록</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>missing end of a broken leg</source>
      <translation>파손된 다리의 없어진 끝</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>observed</source>
      <translation>관측</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>derived from the rest of the unit</source>
      <translation>블록의 나머지에서 유도</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>used</source>
      <translation>사용</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>disturbed, not used</source>
      <translation>교란됨, 사용 안 함</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>not used</source>
      <translation>사용 안 함</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>check point</source>
      <translation>검사점</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>placeholder for a unit not found</source>
      <translation>찾지 못한 블록의 자리 표시</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>place of a correction</source>
      <translation>수정 위치</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>picked by hand</source>
      <translation>수동 선택</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Outlines of the units</source>
      <translation>블록 윤곽</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Surfaces of the units (3D)</source>
      <translation>블록 표면(3D)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Placement of the units</source>
      <translation>블록의 거치 상태</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Gaps</source>
      <translation>결손 위치</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Feature points</source>
      <translation>특징점</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Displacements</source>
      <translation>변위</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Displacements, other pairs and datum</source>
      <translation>변위(다른 시기 쌍과 다른 기준)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Errors of bent frames</source>
      <translation>휘어진 좌표계의 오차</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Stretches that moved as one</source>
      <translation>함께 움직인 구간</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Control residuals</source>
      <translation>기준점 잔차</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Check residuals</source>
      <translation>검사점 잔차</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Reviews</source>
      <translation>검토</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Corrections and placeholders</source>
      <translation>수정과 자리 표시</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Points picked by hand</source>
      <translation>수동으로 선택한 점</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>watch: over {length}</source>
      <translation>주의: {length} 초과</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>alert or more: over {length}</source>
      <translation>경보 이상: {length} 초과</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>arrow of 10 mm: {length}, at most 30 mm long; ellipse: 95 %</source>
      <translation>10 mm 화살표: {length}, 최대 30 mm; 타원: 95 %</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>Which displacement a planned survey detects</source>
      <translation>계획한 측량이 검출하는 변위</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>A unit that moves by {length} in its worst direction is found with the chosen power; the mark in the chart.</source>
      <translation>가장 불리한 방향으로 {length} 움직인 블록이 선택한 검정력으로 발견됩니다(도표의 표시).</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>{share} % of a unit seen</source>
      <translation>블록의 {share} % 보임</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>Detectable displacement ({unit})</source>
      <translation>검출 가능한 변위 ({unit})</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>The epochs and the unit given</source>
      <translation>지정한 에포크와 블록</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>{table}, row {row}</source>
      <translation>{table}, {row}행</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>{table}, field names</source>
      <translation>{table}, 필드 이름</translation>
    </message>
    <message>
      <location filename="../algorithms/survey_algorithm.py" />
      <source>The tiles declare no CRS: results are in a local frame. Choose the CRS of the results to change that.</source>
      <translation>타일에 좌표계 선언이 없어 결과는 지역 좌표계입니다. 바꾸려면 결과 좌표계를 고르십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/survey_algorithm.py" />
      <source>Epoch {label}</source>
      <translation>시기 {label}</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Track displacements</source>
      <translation>변위 추적</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Recognises each unit in all epochs, finds the stable units by a global congruence test and tests the displacement of every feature point and the rotation of every unit against it, with the covariance of fit and registration.</source>
      <translation>모든 시기에서 각 블록을 알아보고, 전체 합동 검정으로 안정한 블록을 찾아, 그에 대해 각 특징점의 변위와 각 블록의 회전을 맞춤과 정합의 공분산으로 검정한다.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>A rotation near 60° or more is ambiguous by the symmetry of the tetrapod and is reported as such.</source>
      <translation>60° 안팎 이상의 회전은 테트라포드의 대칭 때문에 모호하며 그렇게 보고한다.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>displacement,deformation analysis,congruence test,epoch,monitoring</source>
      <translation>변위,변형 해석,합동 검정,시기,모니터링</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Layers of units from Fit tetrapods: one per epoch, each with its own label and time, all in one CRS.</source>
      <translation>'테트라포드 맞춤'의 블록 레이어: 시기마다 하나, 각각 이름과 시각을 갖고 모두 같은 좌표계.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>GeoPackages from Register to control, one per epoch; without them the clouds' own frames are taken as registered.</source>
      <translation>'기준점에 정합'의 GeoPackage, 시기마다 하나. 없으면 점군 자체 좌표계를 정합된 것으로 본다.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Fitted units of all epochs</source>
      <translation>모든 시기의 맞춘 블록</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Registrations</source>
      <translation>정합 결과들</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Give the units of at least two epochs.</source>
      <translation>적어도 두 시기의 블록을 주십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>The layers of units have different CRS: {crs}.</source>
      <translation>블록 레이어의 좌표계가 다릅니다: {crs}.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>no CRS</source>
      <translation>좌표계 없음</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Validate against check points</source>
      <translation>검사점으로 검증</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Compares feature points of one epoch with the same points surveyed by total station or GNSS. Check points never take part in the fit: their differences show the accuracy that was reached.</source>
      <translation>한 시기의 특징점을 토털스테이션이나 GNSS로 측량한 같은 점과 비교한다. 검사점은 맞춤에 쓰이지 않으므로 차이가 얻은 정확도를 보여 준다.</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>A check point is matched by the approximate centre of its unit; one that matches no unit is named and left out.</source>
      <translation>검사점은 블록의 대략 중심으로 짝짓는다. 짝이 없는 것은 이름을 알리고 뺀다.</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>validation,accuracy,check points,total station,GNSS,RMSE</source>
      <translation>검증,정확도,검사점,토털스테이션,GNSS,RMSE</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Layer from Extract feature points, of one epoch.</source>
      <translation>'특징점 추출'의 레이어(한 시기).</translation>
    </message>
    <message>
      <location filename="../plugin/engine_task.py" />
      <source>Cancelled.</source>
      <translation>취소되었습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Creating the tetratrack engine</source>
      <translation>tetratrack 엔진 만드는 중</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Another window of QGIS is creating the engine at this moment.</source>
      <translation>다른 QGIS 창에서 지금 엔진을 만들고 있습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Making an empty environment</source>
      <translation>빈 환경 만드는 중</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Trying the libraries</source>
      <translation>라이브러리 확인 중</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine's environment could not be created: {reason} (everything that was said: {log})</source>
      <translation>엔진의 환경을 만들 수 없었습니다: {reason} (전체 출력: {log})</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Compiling, so that the first run need not wait</source>
      <translation>컴파일 중 (첫 실행을 기다리지 않도록)</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Looking for the libraries</source>
      <translation>라이브러리 찾는 중</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Fetching {name}: {done} of about {all} MB</source>
      <translation>{name} 가져오는 중: 약 {all} MB 중 {done} MB</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Unpacking libraries: {count} of {all}</source>
      <translation>라이브러리 푸는 중: {all}개 중 {count}개</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine needs {needed} GB on the disk of {folder}, and {free} GB are free.</source>
      <translation>엔진에는 {folder}의 디스크에 {needed} GB가 필요하지만 {free} GB만 비어 있습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>{wheels} holds no wheels.</source>
      <translation>{wheels}에 wheel이 없습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>{wheels} lacks {count} of the wheels that this version of the plugin needs: {names}.</source>
      <translation>{wheels}에는 이 버전의 플러그인에 필요한 wheel 중 {count}개가 없습니다: {names}.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine in use cannot be replaced now: wait until its runs have ended.</source>
      <translation>사용 중인 엔진은 지금 바꿀 수 없습니다. 실행이 끝날 때까지 기다리십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Unpacking {file}</source>
      <translation>{file} 푸는 중</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Choose a file…</source>
      <translation>파일 선택…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Add an epoch</source>
      <translation>에포크 추가</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Remove the selected epochs</source>
      <translation>선택한 에포크 제거</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>user-defined</source>
      <translation>사용자 정의</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Choose…</source>
      <translation>선택…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Table of points</source>
      <translation>점 표</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Tables (*.csv *.txt *.gpkg);;All files (*)</source>
      <translation>표 (*.csv *.txt *.gpkg);;모든 파일 (*)</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Files…</source>
      <translation>파일…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Folder…</source>
      <translation>폴더…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Layer {name}</source>
      <translation>레이어 {name}</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_wrapper.py" />
      <source>{count} epochs…</source>
      <translation>에포크 {count}개…</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Arrows move, + and - zoom, Home resets; Enter picks the point in the middle</source>
      <translation>화살표로 이동, + 와 - 로 확대·축소, Home으로 원래대로. Enter로 가운데 점을 고릅니다</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Plan of the unit</source>
      <translation>유닛의 평면도</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Section of the unit</source>
      <translation>유닛의 단면도</translation>
    </message>
    <message>
      <location filename="../plugin/length_widget.py" />
      <source>Length in the project's unit</source>
      <translation>프로젝트 단위의 길이</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python 3.11 to 3.13 was not found: install it, or choose an interpreter of the engine above.</source>
      <translation>Python 3.11~3.13을 찾지 못했습니다. 설치하거나 위에서 엔진의 인터프리터를 고르십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create a Python environment in {folder} and download libraries into it? It takes about {size} of disk.</source>
      <translation>{folder}에 Python 환경을 만들고 라이브러리를 내려받을까요? 디스크를 약 {size} 차지합니다.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create a Python environment in {folder} from the wheels in {wheels}? It takes about {size} of disk.</source>
      <translation>{wheels}의 wheel로 {folder}에 Python 환경을 만들까요? 디스크를 약 {size} 차지합니다.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Try again…</source>
      <translation>다시 시도…</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python interpreter of the engine</source>
      <translation>엔진의 Python 인터프리터</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Empty uses the environment that the plugin creates; a folder of an environment will do.</source>
      <translation>비우면 플러그인이 만드는 환경을 씁니다. 환경의 폴더를 골라도 됩니다.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Folder or ZIP of wheels</source>
      <translation>wheel 폴더 또는 ZIP</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>For computers without a network: what was fetched on another one. Empty fetches the libraries.</source>
      <translation>네트워크가 없는 컴퓨터용: 다른 컴퓨터에서 가져온 것. 비워 두면 라이브러리를 가져옵니다.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create the engine's environment…</source>
      <translation>엔진 환경 만들기…</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Cancel</source>
      <translation>취소</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Show the log</source>
      <translation>로그 보기</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Engine</source>
      <translation>엔진</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>State</source>
      <translation>상태</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>The engine is ready.</source>
      <translation>엔진이 준비되었습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} is no file.</source>
      <translation>{python}은(는) 파일이 아닙니다.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} is no Python interpreter.</source>
      <translation>{python}은(는) Python 인터프리터가 아닙니다.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} is Python {version}; the engine needs 3.11 or later.</source>
      <translation>{python}은(는) Python {version}입니다. 엔진에는 3.11 이상이 필요합니다.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} lacks the engine's libraries: {modules}.</source>
      <translation>{python}에 엔진의 라이브러리가 없습니다: {modules}.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Used: {python}</source>
      <translation>사용 중: {python}</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Can be used: {python}</source>
      <translation>사용할 수 있음: {python}</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the disk is full</source>
      <translation>디스크가 가득 찼습니다</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>this Python cannot make environments; on Debian and Ubuntu install python3-venv first</source>
      <translation>이 Python으로는 환경을 만들 수 없습니다. Debian과 Ubuntu에서는 먼저 python3-venv를 설치하십시오</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy wants a user name and password: state them in Settings &gt; Options &gt; Network</source>
      <translation>프록시에 사용자 이름과 암호가 필요합니다. 설정 &gt; 옵션 &gt; 네트워크에 적으십시오</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy is of the kind SOCKS, which the installer does not know; choose a folder of wheels</source>
      <translation>프록시가 설치 프로그램이 모르는 SOCKS 방식입니다. wheel 폴더를 고르십시오</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the registry's certificate is not trusted: import your network's authority in Settings &gt; Options &gt; Authentication</source>
      <translation>저장소의 인증서를 신뢰할 수 없습니다. 설정 &gt; 옵션 &gt; 인증에서 네트워크의 인증 기관을 가져오십시오</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy cannot be reached: see Settings &gt; Options &gt; Network</source>
      <translation>프록시에 연결할 수 없습니다. 설정 &gt; 옵션 &gt; 네트워크를 확인하십시오</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>a file is not the one that this version of the plugin needs: it was damaged or changed on its way; try again</source>
      <translation>파일이 이 버전의 플러그인에 필요한 것이 아닙니다. 전송 중에 손상되거나 바뀌었습니다. 다시 시도하십시오</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the connection broke while a file was fetched; try again, what is complete is not fetched twice</source>
      <translation>파일을 가져오는 중에 연결이 끊겼습니다. 다시 시도하십시오. 다 받은 것은 다시 가져오지 않습니다</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>no package registry can be reached from this computer; without a network choose a folder of wheels</source>
      <translation>이 컴퓨터에서는 어떤 패키지 저장소에도 연결할 수 없습니다. 네트워크가 없으면 wheel 폴더를 고르십시오</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>a library of the system is missing; on Debian and Ubuntu install libegl1 libgl1 libgomp1</source>
      <translation>시스템 라이브러리가 없습니다. Debian과 Ubuntu에서는 libegl1 libgl1 libgomp1을 설치하십시오</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>Displacements of armour units</source>
      <translation>소파블록의 변위</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>Legend</source>
      <translation>범례</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>{pair}, datum: {datum}</source>
      <translation>{pair}, 기준: {datum}</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Ended: nothing was stored.</source>
      <translation>끝냈습니다. 저장하지 않았습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints</source>
      <translation>세 접합점으로 고정</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fit again after a click on the unit (earlier epoch)</source>
      <translation>블록을 클릭해 다시 맞춤(앞 시기)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fit again after a click on the unit (later epoch)</source>
      <translation>블록을 클릭해 다시 맞춤(뒤 시기)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints of legs (earlier epoch)</source>
      <translation>다리 접합점 셋으로 고정(앞 시기)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints of legs (later epoch)</source>
      <translation>다리 접합점 셋으로 고정(뒤 시기)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pick feature points beside the fit (earlier epoch)</source>
      <translation>맞춤 옆에 특징점 찍기(앞 시기)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pick feature points beside the fit (later epoch)</source>
      <translation>맞춤 옆에 특징점 찍기(뒤 시기)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Placeholder for a unit not found</source>
      <translation>찾지 못한 블록의 자리표시</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Merge the two selected units</source>
      <translation>선택한 두 블록 병합</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Split at the later epoch: two units taken for one</source>
      <translation>뒤 시기에서 분리: 두 블록을 하나로 봄</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Delete: not a unit</source>
      <translation>삭제: 블록이 아님</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Take back your last correction</source>
      <translation>자신의 마지막 수정 되돌리기</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Read the points around the units…</source>
      <translation>블록 둘레의 점 읽기…</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The points around the units are needed: read them from the correction menu.</source>
      <translation>블록 둘레의 점이 필요합니다. 수정 메뉴에서 읽으십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>There are no points here; click on the cloud.</source>
      <translation>여기에는 점이 없습니다. 점군 위를 클릭하십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The unit has no pose in any epoch to take its size from.</source>
      <translation>어느 시기에도 자세가 없어 크기를 알 수 없는 블록입니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Nothing was stored: pick the three joints again.</source>
      <translation>저장하지 않았습니다. 세 접합점을 다시 고르십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>pinned by three joints</source>
      <translation>접합점 셋으로 고정</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The three points do not fit the shape of {unit}: they are {misfit} off, where {worst} would be usual. Were they joints of this unit? Store the pose all the same?</source>
      <translation>세 점이 {unit}의 형상에 맞지 않습니다. {misfit} 어긋나며 보통은 {worst} 이내입니다. 이 블록의 접합점이었습니까? 그래도 자세를 저장할까요?</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The unit was not found in this epoch: pin it by three joints instead.</source>
      <translation>이 시기에 블록을 찾지 못했습니다. 대신 접합점 셋으로 고정하십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Select the two units to merge.</source>
      <translation>병합할 두 블록을 고르십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>There is no correction of yours to take back.</source>
      <translation>되돌릴 자신의 수정이 없습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Survey description</source>
      <translation>측량 설명</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Survey (*.toml)</source>
      <translation>측량 (*.toml)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Reading points around units</source>
      <translation>블록 둘레의 점 읽는 중</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Points read.</source>
      <translation>점을 읽었습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Select a unit first.</source>
      <translation>먼저 블록을 고르십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click the middle of the unit on the map or in a view; Escape ends.</source>
      <translation>지도나 뷰에서 블록 가운데를 클릭하십시오. Escape로 끝냅니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click three joints where three legs meet, on the map or in the views; Escape ends.</source>
      <translation>지도나 뷰에서 세 다리가 만나는 접합점 셋을 클릭하십시오. Escape로 끝냅니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click a joint where three legs meet; Escape ends.</source>
      <translation>세 다리가 만나는 접합점을 클릭하십시오. Escape로 끝냅니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click where the unit lies on the map; Escape ends.</source>
      <translation>지도에서 블록 위치를 클릭하십시오. Escape로 끝냅니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fitting {unit} again</source>
      <translation>{unit} 다시 맞추는 중</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} was fitted again.</source>
      <translation>{unit}을(를) 다시 맞췄습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} pinned; the picks fit within {length}.</source>
      <translation>{unit} 고정됨. 찍은 점이 {length} 안에서 맞습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{feature} picked, {length} from the fit.</source>
      <translation>{feature} 찍음, 맞춤에서 {length}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Placeholder {name} stored; it counts as a unit not found.</source>
      <translation>자리표시 {name} 저장됨. 찾지 못한 블록으로 셉니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{count} of 3 joints.</source>
      <translation>접합점 3개 중 {count}개.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{other} is now {keep}.</source>
      <translation>{other}은(는) 이제 {keep}입니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} is called {name} from {epoch} on.</source>
      <translation>{unit}은(는) {epoch}부터 {name}(으)로 부릅니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} was deleted; take it back from the correction menu.</source>
      <translation>{unit} 삭제됨. 수정 메뉴에서 되돌릴 수 있습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Taken back: {kind} {unit}.</source>
      <translation>되돌림: {kind} {unit}.</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n significant</source>
      <translation>
        <numerusform>유의 %n</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n decided</source>
      <translation>
        <numerusform>결정 %n</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n rejected, excluded from statistics and map</source>
      <translation>
        <numerusform>기각 %n, 통계와 지도에서 제외</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Leg</source>
      <translation>다리</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Its end</source>
      <translation>끝</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Probability of a break</source>
      <translation>파손 확률</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Points to</source>
      <translation>방향</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Check point</source>
      <translation>검사점</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Feature</source>
      <translation>특징점</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Surveyed</source>
      <translation>측량값</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Fitted</source>
      <translation>맞춤값</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Difference</source>
      <translation>차이</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n lost</source>
      <translation>
        <numerusform>소실 %n</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n new</source>
      <translation>
        <numerusform>신규 %n</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n with a broken leg</source>
      <translation>
        <numerusform>파손된 다리 있음 %n</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>3D displacement</source>
      <translation>3D 변위</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>in heights H, in nominal diameters Dn</source>
      <translation>높이 H, 공칭 지름 Dn 단위</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Easting</source>
      <translation>동</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Northing</source>
      <translation>북</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Height</source>
      <translation>높이</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Horizontal</source>
      <translation>수평</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>not significant</source>
      <translation>유의하지 않음</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Detection limit</source>
      <translation>검출 한계</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{length}, towards {azimuth}° from grid north</source>
      <translation>{length}, 도북에서 {azimuth}° 방향</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Score of the fit, 0 to 1</source>
      <translation>적합 점수 (0~1)</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Legs seen, of four</source>
      <translation>보이는 다리 (4개 중)</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Broken legs</source>
      <translation>파손된 다리</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Ends not seen, of legs</source>
      <translation>끝이 보이지 않는 다리</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n of {all} units shown</source>
      <translation>
        <numerusform>블록 {all}개 중 %n개 표시</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>none: one of the two positions is not known</source>
      <translation>없음: 두 위치 가운데 하나를 모름</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Test against no motion</source>
      <translation>움직임 없음에 대한 검정</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Missing ({unit})</source>
      <translation>결손 ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Check points ({unit})</source>
      <translation>검사점({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Nobody has decided on this unit yet.</source>
      <translation>이 블록은 아직 아무도 결정하지 않았습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>largest {length}</source>
      <translation>최대 {length}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Seen in {epoch}</source>
      <translation>{epoch}에 보임</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Legs</source>
      <translation>다리</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Points to: degrees from grid north, and above the horizon</source>
      <translation>방향: 도북에서의 각도와 수평 위 각도</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>± one standard deviation</source>
      <translation>± 는 표준편차 1배</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Picked by hand</source>
      <translation>손으로 찍음</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>taken back by {who}</source>
      <translation>{who}이(가) 되돌림</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{feature}, {epoch}: picked {length} from the fit ({who})</source>
      <translation>{feature}, {epoch}: 맞춤에서 {length} 찍음({who})</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_dock.py" />
      <source>%n units</source>
      <translation>
        <numerusform>블록 %n개</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Displacement review</source>
      <translation>변위 검토</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Open a result</source>
      <translation>결과 열기</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>GeoPackage (*.gpkg)</source>
      <translation>GeoPackage (*.gpkg)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Previous unit (Up, or P for the previous undecided)</source>
      <translation>이전 블록(위쪽 화살표, 미결정 이전은 P)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Next unit (Down, or N for the next undecided)</source>
      <translation>다음 블록(아래쪽 화살표, 미결정 다음은 N)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Zoom to the unit and flash it (Z)</source>
      <translation>블록으로 확대하고 깜박이기(Z)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The map follows the selection</source>
      <translation>지도가 선택을 따라감</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Show all units</source>
      <translation>모든 블록 보기</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>A click on the map picks the unit or arrow there</source>
      <translation>지도를 클릭하면 그곳의 블록이나 화살표를 선택</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Correct a unit</source>
      <translation>블록 고치기</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Write the report…</source>
      <translation>보고서 쓰기…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Report with more choices…</source>
      <translation>선택 항목이 더 있는 보고서…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>A page to print, with the map as it stands</source>
      <translation>현재 지도를 담은 인쇄 페이지</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Export the alarm list…</source>
      <translation>경보 목록 내보내기…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Web page (*.html);;PDF (*.pdf)</source>
      <translation>웹 페이지 (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Alarm list</source>
      <translation>경보 목록</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>CSV (*.csv);;GeoJSON (*.geojson)</source>
      <translation>CSV (*.csv);;GeoJSON (*.geojson)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Decisions of another reviewer were taken in.</source>
      <translation>다른 검토자의 결정을 받아들였습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Corrections of another reviewer were taken in.</source>
      <translation>다른 검토자의 수정을 반영했습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>A run replaced the result: its numbers are shown now.</source>
      <translation>새 계산이 결과를 대체했습니다. 이제 그 값을 표시합니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>In polygons</source>
      <translation>폴리곤 안</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>No unit passes the filter.</source>
      <translation>필터를 통과한 블록이 없습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Enter your name or initials first: they stand beside every decision.</source>
      <translation>먼저 이름이나 머리글자를 입력하십시오. 모든 결정 옆에 기록됩니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Confirmed.</source>
      <translation>확인했습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Writing the report</source>
      <translation>보고서 쓰는 중</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Threshold ({unit})</source>
      <translation>임계값 ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{name} was closed with its layers. Every decision is stored: open it again to go on.</source>
      <translation>{name}이(가) 레이어와 함께 닫혔습니다. 모든 판정은 저장되어 있습니다. 계속하려면 다시 여십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Make a polygon layer active first.</source>
      <translation>먼저 폴리곤 레이어를 활성화하십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The active layer holds no polygon.</source>
      <translation>활성 레이어에 폴리곤이 없습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>In the map window</source>
      <translation>지도 창 안</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Everywhere</source>
      <translation>전체</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The page {name} is in the project's layouts.</source>
      <translation>페이지 {name}이(가) 프로젝트의 레이아웃에 있습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{title}…</source>
      <translation>{title}…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{name} is read-only: you can look, but decisions cannot be stored.</source>
      <translation>{name}은(는) 읽기 전용입니다. 볼 수는 있으나 결정을 저장할 수 없습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{units}: {decision}, stored.</source>
      <translation>{units}: {decision}, 저장됨.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Taken back: {units}.</source>
      <translation>되돌림: {units}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Report written to {name}.</source>
      <translation>보고서를 {name}에 썼습니다.</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_dock.py" />
      <source>Units written to {name}: %n.</source>
      <translation>
        <numerusform>블록 %n개를 {name}에 썼습니다.</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Open 3D view</source>
      <translation>3D 보기 열기</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Model, sections and design</source>
      <translation>모델, 단면, 설계</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Export as-built model…</source>
      <translation>준공 모델 내보내기…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Compare with design…</source>
      <translation>설계와 비교…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Cross-sections and crest…</source>
      <translation>횡단면과 마루…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Points less blocks…</source>
      <translation>점군과 블록의 차이…</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Units reviewed</source>
      <translation>검토한 블록</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements reviewed</source>
      <translation>검토한 변위</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements reviewed, other pair or datum</source>
      <translation>검토한 변위(다른 시기 쌍이나 기준)</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Rejected units (excluded)</source>
      <translation>기각한 블록(제외)</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Placeholders and corrections</source>
      <translation>자리 표시와 수정</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacement review: {name}</source>
      <translation>변위 검토: {name}</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements: {datum}</source>
      <translation>변위: {datum}</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Epochs compared</source>
      <translation>비교하는 시기</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>All classes</source>
      <translation>모든 등급</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Classes shown</source>
      <translation>보이는 등급</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Least 3D displacement shown; lost, new and relocated units are always shown</source>
      <translation>보이는 최소 3D 변위. 소실, 신규, 이탈 블록은 항상 보임</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Area of the units shown</source>
      <translation>보이는 블록의 영역</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Undecided only</source>
      <translation>미결정만</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>On the map too</source>
      <translation>지도에도 적용</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The map shows only the units that the list shows</source>
      <translation>목록에 보이는 블록만 지도에 표시합니다</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Unit…</source>
      <translation>블록…</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Comment, stored with the decision</source>
      <translation>결정과 함께 저장되는 의견</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Your name or initials, stored with every decision</source>
      <translation>이름 또는 머리글자. 모든 결정과 함께 저장</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>In the active layer's polygons</source>
      <translation>활성 레이어의 폴리곤 안</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Accept</source>
      <translation>채택</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The displacement is right (A)</source>
      <translation>변위가 맞음(A)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Reject</source>
      <translation>기각</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The displacement is wrong: it leaves statistics, maps and report (R)</source>
      <translation>변위가 틀림: 통계, 지도, 보고서에서 뺌(R)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Inspect</source>
      <translation>점검</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Inspect on site (I)</source>
      <translation>현장 점검(I)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Confirm</source>
      <translation>확인</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Confirm another reviewer's decision (C)</source>
      <translation>다른 검토자의 결정 확인(C)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Undo</source>
      <translation>실행 취소</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Take back your last decision (U)</source>
      <translation>자신의 마지막 결정 되돌리기(U)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Open</source>
      <translation>열기</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Plan</source>
      <translation>평면</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Select a unit</source>
      <translation>블록을 고르십시오</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>N</source>
      <translation>N</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Section {azimuth}°</source>
      <translation>단면 {azimuth}°</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Series</source>
      <translation>시계열</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Section along the displacement</source>
      <translation>변위를 따른 단면</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Direction of the section, from grid north; each outline is cut through its own centre</source>
      <translation>단면 방향(도북 기준). 각 윤곽은 자기 중심에서 자름</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Read the points…</source>
      <translation>점 읽기…</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Reads the points around the units from the tiles of the survey, for the views and for picking</source>
      <translation>그림과 점 선택을 위해 측량 타일에서 블록 주위의 점을 읽습니다</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Numbers</source>
      <translation>수치</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>History</source>
      <translation>이력</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>points not read yet</source>
      <translation>점을 아직 읽지 않음</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>lost</source>
      <translation>소실</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>unseen</source>
      <translation>안 보임</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>deleted</source>
      <translation>삭제됨</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>merged</source>
      <translation>병합됨</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>split</source>
      <translation>분리됨</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>new pose</source>
      <translation>새 자세</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>points picked</source>
      <translation>수동 선택점</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>placeholder</source>
      <translation>자리표시</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Displ.</source>
      <translation>변위</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Horiz.</source>
      <translation>수평</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Vert.</source>
      <translation>연직</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Rot.</source>
      <translation>회전</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>p</source>
      <translation>p</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Seen</source>
      <translation>보임</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Broken</source>
      <translation>파손</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Name of the unit, the same in all epochs</source>
      <translation>블록 이름. 모든 시기에서 같음</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Class of the displacement, or the unit's fate</source>
      <translation>변위 등급 또는 블록의 상태</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Rotation between the epochs (degrees)</source>
      <translation>시기 사이 회전(도)</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Probability of so large a displacement if the unit stood still; bold where significant</source>
      <translation>블록이 가만히 있을 때 이만큼 큰 변위가 날 확률. 유의하면 굵게</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Share of the unit's surface that holds points, in the worse epoch</source>
      <translation>점이 있는 표면의 비율(더 나쁜 시기)</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Numbers of the legs that are broken; the page Numbers says how sure that is, and which ends are not seen</source>
      <translation>파손된 다리의 번호. 확실한 정도와 보이지 않는 끝은 「수치」 쪽에 있습니다</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Decision of the reviewers</source>
      <translation>검토자의 결정</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Who decided, and ✓ who confirmed</source>
      <translation>결정한 사람, ✓ 확인한 사람</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>whole</source>
      <translation>온전함</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>broken</source>
      <translation>파손</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>not seen</source>
      <translation>안 보임</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>accepted</source>
      <translation>채택</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>rejected</source>
      <translation>기각</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>inspect</source>
      <translation>점검</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>decided</source>
      <translation>결정</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>confirmed</source>
      <translation>확인</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>took back</source>
      <translation>되돌림</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>changed the numbers, which ended</source>
      <translation>수치를 바꾸어 다음 판정이 실효됨:</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>brought back the numbers of</source>
      <translation>수치를 되돌려 다음 판정이 회복됨:</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>3D displacement of the centre ({unit})</source>
      <translation>중심의 3D 변위({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Horizontal displacement of the centre ({unit})</source>
      <translation>중심의 수평 변위({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Vertical displacement of the centre, positive up ({unit})</source>
      <translation>중심의 연직 변위, 위쪽이 양({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>3D displacement since {epoch} ({unit}), bands of 95 %</source>
      <translation>{epoch} 이후 3D 변위({unit}), 띠는 95 %</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>No displacement of this unit</source>
      <translation>이 블록의 변위 없음</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>centre</source>
      <translation>중심</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>detection limit</source>
      <translation>검출 한계</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Open result…</source>
      <translation>결과 열기…</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Take the point cloud layers</source>
      <translation>점군 레이어 사용</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>The files of the project's point cloud layers, in place of a folder</source>
      <translation>폴더 대신 프로젝트의 점군 레이어 파일을 사용합니다</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>estimated from the cloud</source>
      <translation>점군에서 추정</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>as the tiles declare</source>
      <translation>타일에 선언된 대로</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Run</source>
      <translation>실행</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Open the result.gpkg of a survey with two epochs or more to review its displacements.</source>
      <translation>두 시기 이상인 측량의 result.gpkg를 열어 변위를 검토하십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Or make one: choose the folder that holds the tiles of all epochs, look through the table, press Run.</source>
      <translation>또는 새로 만듭니다: 모든 에포크의 타일이 있는 폴더를 선택하고 표를 살펴본 뒤 실행을 누르십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Height H of the unit</source>
      <translation>블록 높이 H</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Looking at the tiles</source>
      <translation>타일 확인 중</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Writing the survey</source>
      <translation>측량 파일 쓰는 중</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>The project has no point cloud layer that lies in a file: choose a folder instead.</source>
      <translation>프로젝트에 파일로 된 점군 레이어가 없습니다: 폴더를 선택하십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Choose where the result is to be written.</source>
      <translation>결과를 쓸 위치를 선택하십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Answer first what is asked above.</source>
      <translation>먼저 위의 질문에 답하십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Units of {heights} m height.</source>
      <translation>높이 {heights} m 블록.</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Monitor a survey…</source>
      <translation>측량 모니터링…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Try the sample…</source>
      <translation>예제 실행…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Engine…</source>
      <translation>엔진…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>An engine is needed before anything can be computed.</source>
      <translation>무엇을 계산하려면 먼저 엔진이 필요합니다.</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>The sample cannot be copied to {folder}: {reason}.</source>
      <translation>예제를 {folder}에 복사할 수 없습니다: {reason}.</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>Tetrapods in 3D</source>
      <translation>3D 테트라포드</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>Displacements in 3D</source>
      <translation>3D 변위</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>significant displacement, enlarged {scale} times</source>
      <translation>유의한 변위, {scale}배 확대</translation>
    </message>
    <message>
      <location filename="../core/report/templates/report.html" />
      <source>a local frame</source>
      <translation>지역 좌표계</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>Blocks</source>
      <translation>블록</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>View of the blocks by class</source>
      <translation>분류별 블록 보기</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>Fitted units of {epoch} by class, seen from the low side.</source>
      <translation>{epoch}에 추정한 블록(분류별), 낮은 쪽에서 본 모습.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Castings</source>
      <translation>주조체</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Mould {name} of an earlier survey, of {units} units, is held.</source>
      <translation>이전 조사의 거푸집 {name}({units}개에서)을 고정합니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>The mould was learned from {units} units of this survey.</source>
      <translation>거푸집은 이 조사의 블록 {units}개에서 구했습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>H = {height} m: radius {radius} m, taper {taper}. Size of single castings ± {size}, radius of single legs ± {leg} mm (one standard deviation).</source>
      <translation>H = {height} m: 반지름 {radius} m, 테이퍼 {taper}. 개별 블록의 크기 ± {size}, 개별 다리의 반지름 ± {leg} mm(표준편차).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Departure of the mould from its cones: along a leg, and unrolled around it. What is alike on all units is held; how single castings differ widens the standard deviations where two epochs see other surfaces.</source>
      <translation>원뿔에 대한 거푸집의 편차: 다리를 따라, 그리고 둘레로 펼친 그림. 모든 블록에 공통인 부분은 고정하고, 개별 차이는 두 시기에 다른 면이 보일 때 표준편차를 넓힙니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Too few units show enough of themselves for a mould: cones are held, and castings vary as the literature says.</source>
      <translation>거푸집을 구하기에는 잘 보이는 블록이 너무 적습니다: 원뿔을 고정하고, 개별 차이는 문헌값을 따릅니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs seen whole: {whole}, broken: {broken}; the ends of {unseen} are not seen, and nothing is said of them.</source>
      <translation>온전한 다리: {whole}, 파손: {broken}. {unseen}개는 끝이 보이지 않아 판정하지 않습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Broken leg</source>
      <translation>파손된 다리</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Missing (m)</source>
      <translation>결손 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Break: easting (m)</source>
      <translation>파단면: 동거 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Northing (m)</source>
      <translation>북거 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Height (m)</source>
      <translation>높이 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs whose ends are not seen</source>
      <translation>끝이 보이지 않는 다리</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Whither a leg points: degrees from grid north clockwise, and above the horizon. The place is that of the face of fracture, or of the leg's whole end where the result does not say how much of it is missing.</source>
      <translation>다리의 방향: 도북에서 시계 방향 각도와 수평 위 각도. 위치는 파단면의 것이며, 결과가 결손 길이를 말하지 않으면 온전한 다리 끝의 것입니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs by section along the axis</source>
      <translation>축을 따른 구간별 다리</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Chainage (m)</source>
      <translation>측점 거리(m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Units with a broken leg</source>
      <translation>파손된 다리가 있는 블록</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs seen whole</source>
      <translation>온전하게 보이는 다리</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Ends not seen</source>
      <translation>보이지 않는 끝</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>The result was made by a version that said nothing of legs.</source>
      <translation>이 결과는 다리에 대해 말하지 않는 버전으로 만들어졌습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Comparison with surveyed check points</source>
      <translation>측량한 검사점과 비교</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Picked by hand (cm)</source>
      <translation>손으로 찍음(cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Fitting (cm)</source>
      <translation>맞춤(cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Surveyed (cm)</source>
      <translation>측량값(cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Error, picked (cm)</source>
      <translation>오차, 손(cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Error, fitting (cm)</source>
      <translation>오차, 맞춤(cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>3D displacements of the same feature point, in the control frame (after Chan and Lichti, Table 1).</source>
      <translation>같은 특징점의 3D 변위, 기준점계(Chan and Lichti 표 1에 따름).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>The survey has no check points that both epochs share.</source>
      <translation>두 시기에 공통된 검사점이 없습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Survey control</source>
      <translation>측량 기준점</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Congruence of the stable units</source>
      <translation>안정 블록의 합동성</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Units that stand still together: {stable} of {all}; test of their congruence: p {p}.</source>
      <translation>함께 정지한 블록: {all}개 중 {stable}개. 합동 검정: p {p}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Their common motion against the control points: east {e}, north {n}, up {h} cm; p {p}.</source>
      <translation>기준점에 대한 공통 움직임: 동 {e}, 북 {n}, 위 {h} cm; p {p}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>East (mm)</source>
      <translation>동(mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>North (mm)</source>
      <translation>북(mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Height (mm)</source>
      <translation>높이(mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Use</source>
      <translation>사용</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>disturbed, left out</source>
      <translation>교란되어 제외</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Residuals of the registration; w is the largest normalised residual of the three coordinates.</source>
      <translation>정합 잔차. w는 세 좌표 표준화 잔차의 최대값.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>There is no survey control: displacements are relative to the frame of the clouds.</source>
      <translation>측량 기준점이 없어 변위는 점군 좌표계에 대한 값입니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Damage</source>
      <translation>피해</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>H = {height} m, Dn = {diameter} m. Lost and relocated units count as displaced by every threshold.</source>
      <translation>H = {height} m, Dn = {diameter} m. 소실·이탈 블록은 모든 문턱값에서 변위로 센다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Displaced by at least</source>
      <translation>다음 이상 변위</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Threshold (m)</source>
      <translation>문턱값(m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Share</source>
      <translation>비율</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>State of the armour in the words of Campos et al. (2020):</source>
      <translation>Campos 등(2020)의 용어로 본 피복층의 상태:</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>No damage: no unit moved by one Dn or is lost. Initiation of damage: some did. Iribarren's damage: neighbours of the outer layer did. Initiation of destruction: a unit of the layer below did. Destruction cannot be told from units.</source>
      <translation>무피해: 1 Dn 이상 움직이거나 유실된 블록이 없음. 피해 시작: 있음. Iribarren 피해: 외층의 이웃 블록. 파괴 시작: 아래층의 블록. 파괴는 블록만으로 알 수 없음.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>over {width} m: units displaced by one Dn or more, relocated or lost, per Dn of width (van der Meer, 1988).</source>
      <translation>{width} m 구간: 1 Dn 이상 변위, 이탈, 소실 블록 수, 너비 Dn당(van der Meer, 1988).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Sections along the axis</source>
      <translation>축을 따른 구간</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Share of displaced units per section</source>
      <translation>구간별 변위 블록 비율</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>No unit has a displacement to show.</source>
      <translation>변위를 보일 블록이 없습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>Decisions and corrections</source>
      <translation>결정과 수정</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>inspect on site</source>
      <translation>현장 점검</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>No reviewer has decided on this epoch pair.</source>
      <translation>이 시기 쌍을 결정한 검토자가 없습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>Correction</source>
      <translation>수정</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>By</source>
      <translation>수행자</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>As-built against design</source>
      <translation>준공과 설계</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Map of the units against the design</source>
      <translation>설계 대비 블록 지도</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units of {epoch} against the design; coordinates in {crs}.</source>
      <translation>설계 대비 {epoch}의 블록. 좌표는 {crs}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units at a planned place</source>
      <translation>계획 위치에 있는 블록</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Within the tolerance</source>
      <translation>허용오차 이내</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Outside the tolerance</source>
      <translation>허용오차 초과</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Cannot be told</source>
      <translation>판정 불가</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Deviation, median and largest (cm)</source>
      <translation>편차, 중앙값과 최대 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Planned</source>
      <translation>계획</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>East (cm)</source>
      <translation>동 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>North (cm)</source>
      <translation>북 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Up (cm)</source>
      <translation>위 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Deviation (cm)</source>
      <translation>편차 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Rotation (°)</source>
      <translation>회전 (°)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>The {count} units farthest from their place; all stand in the file of tetratrack design.</source>
      <translation>위치에서 가장 먼 블록 {count}개. 전체는 tetratrack design 파일에 있습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units under the profile's lines</source>
      <translation>단면선 범위 내 블록</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Centre off the design, mean and RMS (m)</source>
      <translation>중심의 설계 이격, 평균과 RMS (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Outermost point, mean and RMS (m)</source>
      <translation>가장 바깥 점, 평균과 RMS (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>A unit is within or outside the tolerance where its standard deviation leaves no doubt of 5 % or more.</source>
      <translation>표준편차로 5 % 이상의 의심이 남지 않을 때 허용오차 이내 또는 초과로 봅니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Map of displacements</source>
      <translation>변위 지도</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Displacement of the units' centres.</source>
      <translation>블록 중심의 변위.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Histogram of displacements</source>
      <translation>변위 히스토그램</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Displacements of all units with the thresholds of the next section.</source>
      <translation>모든 블록의 변위와 다음 절의 문턱값.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Units, one by one</source>
      <translation>블록별 결과</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Zoom in</source>
      <translation>확대</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Zoom out</source>
      <translation>축소</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Whole map</source>
      <translation>전체 지도</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Arrows</source>
      <translation>화살표</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Map of the units by class</source>
      <translation>등급별 블록 지도</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Search</source>
      <translation>검색</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>all</source>
      <translation>전체</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Displacement from (cm)</source>
      <translation>최소 변위 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>significant only</source>
      <translation>유의한 것만</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Displacement (cm)</source>
      <translation>변위 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Blocks of both epochs</source>
      <translation>두 시기의 블록</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>transparent</source>
      <translation>반투명</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Whole scene</source>
      <translation>전체 보기</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Drag turns, shift and drag moves, the wheel or two fingers zoom.</source>
      <translation>드래그로 회전, Shift+드래그로 이동, 휠 또는 두 손가락으로 확대·축소.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>This browser shows no 3D (WebGL): the picture of the blocks below stands for it.</source>
      <translation>이 브라우저는 3D(WebGL)를 표시하지 못합니다. 아래의 블록 그림이 대신합니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>East</source>
      <translation>동</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>North</source>
      <translation>북</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Up</source>
      <translation>위</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>{shown} of {all} units</source>
      <translation>{all}개 중 {shown}개</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>enlarged {times} times</source>
      <translation>{times}배 확대</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>dashed: cut short</source>
      <translation>파선: 줄여서 표시</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Control point</source>
      <translation>기준점</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Control point, not used</source>
      <translation>기준점(미사용)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Frames and common motion</source>
      <translation>좌표계와 공통 이동</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The clouds of these epochs are bent. What targets say of the bend is removed from positions and from displacements in datum control; what resting units say besides, from displacements in datum stable.</source>
      <translation>이 시기들의 점군은 휘어 있습니다. 타깃으로 알 수 있는 휨은 위치와 control 기준 변위에서, 정지한 블록으로 알 수 있는 부분은 stable 기준 변위에서도 제거됩니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Bend, mean (mm)</source>
      <translation>휨, 평균 (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Bend, largest (mm)</source>
      <translation>휨, 최대 (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Left unknown, mean (mm)</source>
      <translation>남은 불확실성, 평균 (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Correlation length (m)</source>
      <translation>상관 길이 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Targets used</source>
      <translation>사용한 타깃</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Error of the clouds along the structure with its 95 % band.</source>
      <translation>구조물을 따른 점군 오차와 95 % 구간.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>No bend of the clouds could be told from the noise of units and targets: frames are held stiff.</source>
      <translation>블록과 타깃의 잡음과 구별되는 점군의 휨이 없어 좌표계를 강체로 둡니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Flight strips or stations drift against each other along the structure; this is removed.</source>
      <translation>비행 스트립 또는 측점이 구조물을 따라 서로 어긋나며, 이는 제거됩니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The cloud of {epoch} was aligned by its units alone: a motion of the whole structure cannot be seen.</source>
      <translation>{epoch} 점군은 블록만으로 정렬되어 구조물 전체의 이동은 볼 수 없습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Common motion of stretches</source>
      <translation>구간의 공통 이동</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Both epochs show too few units to tell a common motion of stretches.</source>
      <translation>두 시기에 보이는 블록이 너무 적어 구간의 공통 이동을 알 수 없습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Mean displacement of the units of each stretch against the targets; the band holds what is not known of the frames.</source>
      <translation>타깃에 대한 각 구간 블록의 평균 변위. 구간 폭에는 좌표계의 미지분이 포함됩니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Not both epochs have survey control: stretches are compared with each other, and a motion of all of them cannot be told.</source>
      <translation>두 시기 모두에 기준점이 있지 않아 구간끼리 비교하며, 전체의 이동은 알 수 없습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Height change and horizontal motion of stretches with their 95 % bands.</source>
      <translation>구간의 높이 변화와 수평 이동, 95 % 구간.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>From (m)</source>
      <translation>시작 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>To (m)</source>
      <translation>끝 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>No stretch moved as a whole by more than its band.</source>
      <translation>구간 폭을 넘어 전체로 움직인 구간이 없습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Of {untold} of {all} stretches a common motion of one hundredth of the unit height cannot be told from the bend of the clouds: targets stand too far away.</source>
      <translation>{all}개 구간 중 {untold}개에서 블록 높이의 1/100 크기의 공통 이동을 점군의 휨과 구별할 수 없습니다. 타깃이 너무 멀리 있습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The result says nothing of its frames.</source>
      <translation>이 결과에는 좌표계에 대한 기록이 없습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Units by class and control points; coordinates in {crs}.</source>
      <translation>등급별 블록과 기준점. 좌표계 {crs}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Map of a part with the units' names</source>
      <translation>블록 이름이 있는 부분 지도</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Part {number} of {all} along the structure.</source>
      <translation>구조물을 따라 {all}개 부분 중 {number}번째.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Method, settings and versions</source>
      <translation>방법, 설정, 버전</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Units are found in the point cloud as four cones with a common centre, adjusted to their points (Gauss-Helmert model), and brought into the frame of the survey control; displacements are differences of the feature points that follow from the adjusted model, tested against their covariance (after Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds).</source>
      <translation>블록은 공통 중심을 가진 네 원뿔로 점군에서 찾아 그 점에 조정(가우스-헬머트 모델)하고 기준점계로 옮긴다. 변위는 조정된 모델에서 나온 특징점의 차이이며 공분산에 대해 검정한다(Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds에 따름).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>σ0 of the registration</source>
      <translation>정합의 σ0</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Settings</source>
      <translation>설정</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Written {moment} by {software}.</source>
      <translation>{moment}에 {software}(으)로 작성.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Placement</source>
      <translation>배치</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units with neighbours on all sides</source>
      <translation>사방에 이웃이 있는 블록</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Nearest centre, median and 5 % (Dn)</source>
      <translation>최근접 중심 거리, 중앙값과 5 %(Dn)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Turn between neighbours, and expected at random</source>
      <translation>이웃 간 회전, 무작위일 때의 기대값</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Difference from turns at random, p</source>
      <translation>무작위 회전과의 차이, p</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Contacts of a unit, mean</source>
      <translation>블록의 접촉 수, 평균</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Free gap to the nearest unit, median (cm)</source>
      <translation>가장 가까운 블록과의 틈, 중앙값 (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units in a column, of those with one below</source>
      <translation>기둥 배열 블록 / 아래에 블록이 있는 것</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Off the surface of their neighbours, RMS and largest (m)</source>
      <translation>이웃 면에서의 이격, RMS와 최대 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Layer from outside</source>
      <translation>바깥쪽부터의 층</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units per 100 m²</source>
      <translation>100 m²당 개수</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Packing density, units per Dn²</source>
      <translation>충전 밀도(Dn²당 개수)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Share of the design number</source>
      <translation>설계값 대비 비율</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units of {epoch}, each in the plane through its neighbours; those at the edge do not count for density. Only units that were found are counted: hidden ones of a lower layer are not. The design number is {packing} units per Dn² and layer (Shore Protection Manual, 1984).</source>
      <translation>{epoch}의 블록. 각각 이웃을 지나는 평면에서 봅니다. 가장자리 블록은 밀도에 포함하지 않습니다. 발견된 블록만 세며 아래층의 숨은 것은 세지 않습니다. 설계값은 층당 Dn²에 {packing}개(Shore Protection Manual, 1984).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest and cross-sections</source>
      <translation>마루와 횡단면</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest height along the structure</source>
      <translation>구조물을 따른 마루 높이</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Mean height of the tops of the crest's units in each reach, with its 95 % band.</source>
      <translation>각 구간 마루 블록 꼭대기의 평균 높이와 95 % 구간.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest height (m)</source>
      <translation>마루 높이 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Highest (m)</source>
      <translation>최고 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest width (m)</source>
      <translation>마루 폭 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Change (mm)</source>
      <translation>변화 (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>The crest of a reach are the units whose top lies less than 0.5 Dn below the highest one; its width is that of their outlines across the axis; the change is that of units that are the crest's in both epochs. Settlement of whole stretches stands under frames and common motion.</source>
      <translation>구간의 마루는 꼭대기가 가장 높은 것보다 0.5 Dn 미만 낮은 블록입니다. 폭은 축 직각 방향 윤곽의 폭, 변화는 두 시기 모두 마루인 블록의 것입니다. 구간 전체의 침하는 좌표계와 공통 운동 절에 있습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Cross-sections</source>
      <translation>횡단면</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Quality of the units</source>
      <translation>블록의 품질</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Uncertain units</source>
      <translation>불확실한 블록</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Points to surface, median (mm)</source>
      <translation>점에서 표면까지 거리, 중앙값(mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Largest overlap</source>
      <translation>최대 겹침</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Pairs too close</source>
      <translation>너무 가까운 쌍</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Overlap is the share of a unit's volume inside another one; two solid units cannot overlap, nor can their centres come closer than half a height. A gap is a place where a unit is likely missing in the result; the layer gaps shows them.</source>
      <translation>겹침은 한 블록의 부피 중 다른 블록 안에 있는 비율입니다. 단단한 두 블록은 겹칠 수 없고 중심이 높이의 절반보다 가까워질 수도 없습니다. 결손 위치는 결과에 블록이 빠졌을 가능성이 큰 곳이며 레이어 gaps에 표시됩니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>The result does not state the quality of its units.</source>
      <translation>이 결과에는 블록의 품질 기록이 없습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Summary</source>
      <translation>요약</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units judged</source>
      <translation>평가한 블록</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Significant displacements</source>
      <translation>유의한 변위</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Lost</source>
      <translation>소실</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Relocated</source>
      <translation>이탈</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>New</source>
      <translation>신규</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Not seen in the later epoch</source>
      <translation>뒤 시기에 안 보임</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Uncertain, not counted</source>
      <translation>불확실(집계 제외)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Displaced by 5 cm or more</source>
      <translation>5 cm 이상 변위</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Displaced by 10 cm or more</source>
      <translation>10 cm 이상 변위</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Decided by reviewers</source>
      <translation>검토자가 결정</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Rejected by reviewers</source>
      <translation>검토자가 기각</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units known to be missing</source>
      <translation>없는 것으로 알려진 블록</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Completeness</source>
      <translation>완전성</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units rejected by reviewers and left out of all figures, maps and tables below: {count}.</source>
      <translation>검토자가 기각해 아래 모든 수치, 지도, 표에서 뺀 블록: {count}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units that no reviewer has decided on yet: {count}.</source>
      <translation>아직 결정되지 않은 블록: {count}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Units with the largest displacements</source>
      <translation>변위가 가장 큰 블록</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>East {e}, north {n}, up {h} cm; rotation {turn}; p {p}</source>
      <translation>동 {e}, 북 {n}, 위 {h} cm; 회전 {turn}; p {p}</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Plan and section of {unit}</source>
      <translation>{unit}의 평면과 단면</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Series of {unit}</source>
      <translation>{unit}의 시계열</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>No displacement is significant.</source>
      <translation>유의한 변위가 없습니다.</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>control used</source>
      <translation>사용한 기준점</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>control not used</source>
      <translation>사용하지 않은 기준점</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>arrows: significant horizontal displacements, enlarged {scale} times</source>
      <translation>화살표: 유의한 수평 변위, {scale}배 확대</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>3D displacement (cm)</source>
      <translation>3D 변위(cm)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>all units</source>
      <translation>모든 블록</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>units</source>
      <translation>블록 수</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>plan</source>
      <translation>평면</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>section {azimuth}°</source>
      <translation>단면 {azimuth}°</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>chainage along the axis (m)</source>
      <translation>축을 따른 측점 거리(m)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>Height change</source>
      <translation>높이 변화</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>Horizontal motion</source>
      <translation>수평 이동</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>units ≥ 10 cm (%)</source>
      <translation>10 cm 이상 블록(%)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>easting (m)</source>
      <translation>동 좌표(m)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>northing (m)</source>
      <translation>북 좌표(m)</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>least and most around the leg</source>
      <translation>다리 둘레의 최소와 최대</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>mean around the leg</source>
      <translation>다리 둘레의 평균</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>end disc</source>
      <translation>끝면</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>share of the leg, from the unit's centre</source>
      <translation>다리의 비율(중심에서)</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>outside the cone (mm)</source>
      <translation>원뿔 바깥 (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>around the leg (degrees)</source>
      <translation>다리 둘레(도)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>no damage</source>
      <translation>무피해</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>initiation of damage</source>
      <translation>피해 시작</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>Iribarren's damage</source>
      <translation>Iribarren 피해</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>initiation of destruction</source>
      <translation>파괴 시작</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>within</source>
      <translation>이내</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>outside</source>
      <translation>초과</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>cannot be told</source>
      <translation>판정 불가</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>chainage {along} m, axis at {east} / {north}</source>
      <translation>측점 {along} m, 축 {east} / {north}</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>height (m)</source>
      <translation>높이 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>offset from the axis, left positive (m)</source>
      <translation>축에서의 거리, 왼쪽이 양 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>crest height (m)</source>
      <translation>마루 높이 (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>within the tolerance</source>
      <translation>허용오차 이내</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>outside the tolerance</source>
      <translation>허용오차 초과</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>not judged</source>
      <translation>판정 안 함</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>planned place without a unit</source>
      <translation>블록이 없는 계획 위치</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>unit without a planned place</source>
      <translation>계획 위치가 없는 블록</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>surface of the points</source>
      <translation>점군 표면</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>design</source>
      <translation>설계</translation>
    </message>
  </context>
</TS>
