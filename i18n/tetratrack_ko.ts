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
      <source>GeoPackage written by Monitor a survey.</source>
      <translation>'측량 모니터링'이 쓴 GeoPackage.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>HTML in one file, or PDF; the ending decides.</source>
      <translation>한 파일의 HTML 또는 PDF. 확장자로 결정된다.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Result</source>
      <translation>결과</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Report</source>
      <translation>보고서</translation>
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
      <source>Fitted units</source>
      <translation>맞춘 블록</translation>
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
      <location filename="../algorithms/inputs.py" />
      <source>LAS, LAZ or COPC files, a folder of them, a virtual point cloud (.vpc) or point cloud layers; coordinates in metres.</source>
      <translation>LAS, LAZ, COPC 파일, 그 폴더, 가상 점군(.vpc) 또는 점군 레이어. 좌표는 미터.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Projected CRS in metres; empty takes that of the tiles, and a local frame if they declare none.</source>
      <translation>미터 단위 투영 좌표계. 비우면 타일의 좌표계를, 선언이 없으면 지역 좌표계를 쓴다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Label of this survey in all results, for example its date.</source>
      <translation>모든 결과에 쓰이는 이 측량의 이름. 예: 날짜.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Drives the temporal controller; empty takes the date of the first tile.</source>
      <translation>시간 컨트롤러를 움직인다. 비우면 첫 타일의 날짜를 쓴다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Estimates both from the best-seen units and holds them: moulds differ by centimetres from the standard proportions.</source>
      <translation>가장 잘 보이는 블록에서 둘 다 추정해 고정한다. 거푸집은 표준 비율과 수 센티미터 다르다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Type of unit</source>
      <translation>블록 종류</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Catalogue name with the mass in tonnes, such as tetrapod 8 t; or tetrapod with a height of your own.</source>
      <translation>질량(톤)이 붙은 목록 이름(예: tetrapod 8 t), 또는 높이를 직접 준 tetrapod.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>From the plane under three legs to the top of the fourth, in metres; overrides the catalogue.</source>
      <translation>세 다리 아래 평면에서 네 번째 다리 끝까지(미터). 목록 값보다 우선한다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Radius of a leg's cone at the unit's centre, in metres; empty takes 0.264 H.</source>
      <translation>블록 중심에서 다리 원뿔의 반지름(미터). 비우면 0.264 H.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Loss of radius per metre along the leg's axis; empty takes 0.176.</source>
      <translation>다리 축을 따라 1미터당 줄어드는 반지름. 비우면 0.176.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>From the centre to the end disc, in metres; empty takes 0.644 H.</source>
      <translation>중심에서 끝면까지(미터). 비우면 0.644 H.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Built tetrapods are tetrahedral; 120° between leg 1 and the others repeats the published equations.</source>
      <translation>실물 테트라포드는 정사면체형이다. 다리 1과 나머지 사이 120°는 논문 식을 재현한다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Polygon inside which units are looked for; its outer ring is used. Empty means everywhere.</source>
      <translation>블록을 찾을 폴리곤. 바깥 고리를 쓴다. 비우면 전체.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Polygons around surfaces that do not move, such as the crown wall: they tie epochs without control to the earliest with control, or to the first.</source>
      <translation>상치콘크리트처럼 움직이지 않는 면을 둘러싼 폴리곤: 기준점이 없는 시기를 기준점이 있는 가장 이른 시기, 없으면 첫 시기에 연결합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Blocks of the survey worked on at the same time; each takes about 1 GB of memory.</source>
      <translation>동시에 처리하는 측량 구획 수. 하나에 메모리 약 1 GB가 든다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Surveyed targets: point layer or CSV with point_id, easting, northing, height, sd_e, sd_n, sd_h (m).</source>
      <translation>측량한 타깃: point_id, easting, northing, height, sd_e, sd_n, sd_h(m)를 가진 점 레이어나 CSV.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The same targets as measured in this epoch's cloud: point layer or CSV with point_id, x, y, z (m).</source>
      <translation>이 시기 점군에서 잰 같은 타깃: point_id, x, y, z(m)를 가진 점 레이어나 CSV.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Surveyed joints of cones, for validation only: CSV or layer with point_id, unit_easting, unit_northing, unit_height and position (m).</source>
      <translation>측량한 원뿔 접합점(검증 전용): point_id, unit_easting, unit_northing, unit_height와 위치(m)를 가진 CSV나 레이어.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Give the height H of the unit, or choose a catalogue name with its mass, such as tetrapod 8 t.</source>
      <translation>블록 높이 H를 주거나 tetrapod 8 t처럼 질량이 붙은 목록 이름을 고르십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The type of unit must be tetrapod, or a catalogue name such as tetrapod 8 t.</source>
      <translation>블록 종류는 tetrapod 또는 tetrapod 8 t 같은 목록 이름이어야 합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Control points and targets in the cloud belong together: give both, or neither.</source>
      <translation>기준점과 점군의 타깃은 한 쌍입니다. 둘 다 주거나 모두 비우십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>CRS of the results</source>
      <translation>결과 좌표계</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Epoch</source>
      <translation>시기</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Time of the survey (UTC)</source>
      <translation>측량 시각(UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Calibrate radius and taper</source>
      <translation>반지름과 테이퍼 검정</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Height H of the unit (m)</source>
      <translation>블록 높이 H(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Cone radius at the centre (m)</source>
      <translation>중심에서 원뿔 반지름(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Taper of the leg</source>
      <translation>다리 테이퍼</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Leg length (m)</source>
      <translation>다리 길이(m)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Angle between the legs</source>
      <translation>다리 사이 각</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Area of interest</source>
      <translation>관심 영역</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Stable areas</source>
      <translation>안정 영역</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Worker processes</source>
      <translation>작업 프로세스</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Control points</source>
      <translation>기준점</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Targets in the cloud</source>
      <translation>점군의 타깃</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Check points</source>
      <translation>검사점</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The cone radius must be smaller than half the height of the unit.</source>
      <translation>원뿔 반지름은 블록 높이의 절반보다 작아야 합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The area of interest holds no polygon.</source>
      <translation>관심 영역에 폴리곤이 없습니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The area of interest has several separate parts; give one polygon.</source>
      <translation>관심 영역이 여러 조각입니다. 폴리곤 하나를 주십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Point cloud tiles</source>
      <translation>점군 타일</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>tetrahedral (109.5°)</source>
      <translation>정사면체형(109.5°)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>as in the paper (120°)</source>
      <translation>논문대로(120°)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{crs} is geographic; choose a projected CRS in metres.</source>
      <translation>{crs}은(는) 지리 좌표계입니다. 미터 단위 투영 좌표계를 고르십시오.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: no LAS or LAZ file is given.</source>
      <translation>{where}: LAS 또는 LAZ 파일이 없습니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: there is no file or layer {path}.</source>
      <translation>{where}: 파일 또는 레이어 {path}이(가) 없습니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{layer} cannot be written: {reason}.</source>
      <translation>{layer}을(를) 쓸 수 없습니다: {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{layer} has no field {fields}; it has {present}.</source>
      <translation>{layer}에 필드 {fields}이(가) 없습니다. 있는 것: {present}.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: the folder {path} holds no LAS or LAZ file.</source>
      <translation>{where}: 폴더 {path}에 LAS 또는 LAZ 파일이 없습니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: {path} is not a virtual point cloud.</source>
      <translation>{where}: {path}은(는) 가상 점군이 아닙니다.</translation>
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
      <source>Epochs</source>
      <translation>시기</translation>
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
      <source>Epoch {label}</source>
      <translation>시기 {label}</translation>
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
      <source>White noise is averaged over the points of a unit; whatever does not average out must be stated as systematic part.</source>
      <translation>백색 잡음은 블록의 점에서 평균된다. 평균되지 않는 것은 계통 성분으로 주어야 한다.</translation>
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
      <source>The level of significance must be below the power.</source>
      <translation>유의수준은 검정력보다 작아야 합니다.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Radius and taper are known</source>
      <translation>반지름과 테이퍼를 앎</translation>
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
      <location filename="../algorithms/survey_algorithm.py" />
      <source>The tiles declare no CRS: results are in a local frame. Choose the CRS of the results to change that.</source>
      <translation>타일에 좌표계 선언이 없어 결과는 지역 좌표계입니다. 바꾸려면 결과 좌표계를 고르십시오.</translation>
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
      <location filename="../algorithms/validatesurvey.py" />
      <source>Feature points</source>
      <translation>특징점</translation>
    </message>
    <message>
      <location filename="../plugin/engine.py" />
      <source>The tetratrack engine is not installed: open Settings &gt; Options &gt; Tetratrack and create its environment or choose one.</source>
      <translation>tetratrack 엔진이 설치되어 있지 않습니다. 설정 &gt; 옵션 &gt; Tetratrack을 열어 환경을 만들거나 고르십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/engine.py" />
      <source>The engine ended unexpectedly (exit code {code}); QGIS and your data are unharmed.</source>
      <translation>엔진이 예기치 않게 끝났습니다(종료 코드 {code}). QGIS와 데이터는 무사합니다.</translation>
    </message>
    <message>
      <location filename="../plugin/engine.py" />
      <source>The engine could not be started with {python}: {reason}.</source>
      <translation>{python}(으)로 엔진을 시작할 수 없습니다: {reason}.</translation>
    </message>
    <message>
      <location filename="../plugin/engine_task.py" />
      <source>Cancelled.</source>
      <translation>취소되었습니다.</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>found</source>
      <translation>찾음</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>uncertain</source>
      <translation>불확실</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>new</source>
      <translation>신규</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>relocated</source>
      <translation>이탈</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>lost: the place is empty</source>
      <translation>유실: 자리가 비어 있음</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>unseen: known from another epoch</source>
      <translation>보이지 않음: 다른 시기에 알려짐</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>unexplained points where a unit fits</source>
      <translation>블록이 들어맞는 자리의 설명되지 않은 점</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>hole where a unit fits</source>
      <translation>블록이 들어맞는 빈 곳</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>arrow of 10 mm: 50 mm; ellipse: 95 %</source>
      <translation>화살표 10 mm = 50 mm, 타원 = 95 %</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>below the detection limit</source>
      <translation>검출 한계 미만</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>significant, up to 50 mm</source>
      <translation>유의, 50 mm 이하</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>50 to 100 mm: watch</source>
      <translation>50~100 mm: 주의</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>more than 100 mm: alert</source>
      <translation>100 mm 초과: 경보</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>relocated unit</source>
      <translation>이탈한 블록</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>uncertain unit</source>
      <translation>불확실한 블록</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>observed</source>
      <translation>관측</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>derived from the rest of the unit</source>
      <translation>블록의 나머지에서 유도</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>used</source>
      <translation>사용</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>disturbed, not used</source>
      <translation>교란됨, 사용 안 함</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>not used</source>
      <translation>사용 안 함</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>check point</source>
      <translation>검사점</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Gaps</source>
      <translation>결손 위치</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Displacements</source>
      <translation>변위</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Displacements, other pairs and datum</source>
      <translation>변위(다른 시기 쌍과 다른 기준)</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Control residuals</source>
      <translation>기준점 잔차</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Check residuals</source>
      <translation>검사점 잔차</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Reviews</source>
      <translation>검토</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create a Python environment in {folder} and download about {size} of libraries into it?</source>
      <translation>{folder}에 Python 환경을 만들고 라이브러리 약 {size}를 내려받을까요?</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Creating the tetratrack engine</source>
      <translation>tetratrack 엔진 만드는 중</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python interpreter of the engine</source>
      <translation>엔진의 Python 인터프리터</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Empty uses the environment that the plugin creates.</source>
      <translation>비우면 플러그인이 만드는 환경을 쓴다.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create the engine's environment…</source>
      <translation>엔진 환경 만들기…</translation>
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
      <source>Python 3.11 or later was not found: install it, or choose an interpreter of the engine above.</source>
      <translation>Python 3.11 이상을 찾지 못했습니다. 설치하거나 위에서 엔진 인터프리터를 고르십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>The engine's environment could not be created: {reason}</source>
      <translation>엔진 환경을 만들 수 없습니다: {reason}</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Used: {python}</source>
      <translation>사용 중: {python}</translation>
    </message>
    <message>
      <location filename="../plugin/provider.py" />
      <source>Tetratrack: displacements of tetrapods</source>
      <translation>Tetratrack: 테트라포드 변위</translation>
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
      <source>Take back the last correction</source>
      <translation>마지막 수정 되돌리기</translation>
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
      <source>pinned by three joints</source>
      <translation>접합점 셋으로 고정</translation>
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
      <source>There is no correction to take back.</source>
      <translation>되돌릴 수정이 없습니다.</translation>
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
    <message>
      <location filename="../plugin/review_details.py" />
      <source>3D displacement</source>
      <translation>3D 변위</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>in heights H, in Dn</source>
      <translation>높이 H, Dn 단위</translation>
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
      <source>significant</source>
      <translation>유의</translation>
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
      <source>Seen</source>
      <translation>보임</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Score</source>
      <translation>점수</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Legs seen</source>
      <translation>보이는 다리</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{shown} of {all} units shown</source>
      <translation>블록 {all}개 중 {shown}개 표시</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} significant</source>
      <translation>유의 {count}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} decided</source>
      <translation>결정 {count}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} rejected, excluded from statistics and map</source>
      <translation>기각 {count}, 통계와 지도에서 제외</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Displacement</source>
      <translation>변위</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>none: one of the two positions is not known</source>
      <translation>없음: 두 위치 가운데 하나를 모름</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Rotation</source>
      <translation>회전</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Test against no motion</source>
      <translation>움직임 없음에 대한 검정</translation>
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
      <source>{count} lost</source>
      <translation>소실 {count}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} new</source>
      <translation>신규 {count}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>largest {length}</source>
      <translation>최대 {length}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>taken back</source>
      <translation>되돌림</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Picked by hand</source>
      <translation>손으로 찍음</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{feature}, {epoch}: picked {length} from the fit ({who})</source>
      <translation>{feature}, {epoch}: 맞춤에서 {length} 찍음({who})</translation>
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
      <source>Export the alarm list…</source>
      <translation>경보 목록 내보내기…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>PDF (*.pdf);;Web page (*.html)</source>
      <translation>PDF (*.pdf);;웹 페이지 (*.html)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Alarm list</source>
      <translation>경보 목록</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Threshold (cm)</source>
      <translation>문턱값(cm)</translation>
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
      <source>Make a polygon layer active first.</source>
      <translation>먼저 폴리곤 레이어를 활성화하십시오.</translation>
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
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{count} units written to {name}.</source>
      <translation>블록 {count}개를 {name}에 썼습니다.</translation>
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
      <source>Displacement review: {name}</source>
      <translation>변위 검토: {name}</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Open the result.gpkg of a survey with two epochs or more to review its displacements.</source>
      <translation>두 시기 이상인 측량의 result.gpkg를 열어 변위를 검토하십시오.</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Open result…</source>
      <translation>결과 열기…</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Epochs compared</source>
      <translation>비교하는 시기</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Reference of the displacements</source>
      <translation>변위의 기준</translation>
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
      <source>Reviewer</source>
      <translation>검토자</translation>
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
      <source>No displacement of this unit</source>
      <translation>이 블록의 변위 없음</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>centre</source>
      <translation>중심</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Section {azimuth}°</source>
      <translation>단면 {azimuth}°</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>3D displacement ({unit})</source>
      <translation>3D 변위({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>detection limit</source>
      <translation>검출 한계</translation>
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
      <source>stable</source>
      <translation>안정</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>moved</source>
      <translation>이동</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>rotated</source>
      <translation>회전</translation>
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
      <source>placeholder</source>
      <translation>자리표시</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Unit</source>
      <translation>블록</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Class</source>
      <translation>등급</translation>
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
      <source>Decision</source>
      <translation>결정</translation>
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
      <source>stable units and control</source>
      <translation>안정 블록과 기준점</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>control points alone</source>
      <translation>기준점만</translation>
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
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Monitor a survey…</source>
      <translation>측량 모니터링…</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Comparison with surveyed check points</source>
      <translation>측량한 검사점과 비교</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Picked by hand (cm)</source>
      <translation>손으로 찍음(cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Fitting (cm)</source>
      <translation>맞춤(cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Surveyed (cm)</source>
      <translation>측량값(cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Error, picked (cm)</source>
      <translation>오차, 손(cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Error, fitting (cm)</source>
      <translation>오차, 맞춤(cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>3D displacements of the same feature point, in the control frame (after Chan and Lichti, Table 1).</source>
      <translation>같은 특징점의 3D 변위, 기준점계(Chan and Lichti 표 1에 따름).</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>The survey has no check points that both epochs share.</source>
      <translation>두 시기에 공통된 검사점이 없습니다.</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Survey control</source>
      <translation>측량 기준점</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Congruence of the stable units</source>
      <translation>안정 블록의 합동성</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Units that stand still together: {stable} of {all}; test of their congruence: p {p}.</source>
      <translation>함께 정지한 블록: {all}개 중 {stable}개. 합동 검정: p {p}.</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Their common motion against the control points: east {e}, north {n}, up {h} cm; p {p}.</source>
      <translation>기준점에 대한 공통 움직임: 동 {e}, 북 {n}, 위 {h} cm; p {p}.</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Point</source>
      <translation>점</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>East (mm)</source>
      <translation>동(mm)</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>North (mm)</source>
      <translation>북(mm)</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Height (mm)</source>
      <translation>높이(mm)</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Use</source>
      <translation>사용</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>disturbed, left out</source>
      <translation>교란되어 제외</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Residuals of the registration; w is the largest normalised residual of the three coordinates.</source>
      <translation>정합 잔차. w는 세 좌표 표준화 잔차의 최대값.</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>There is no survey control: displacements are relative to the frame of the clouds.</source>
      <translation>측량 기준점이 없어 변위는 점군 좌표계에 대한 값입니다.</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Damage</source>
      <translation>피해</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>H = {height} m, Dn = {diameter} m. Lost and relocated units count as displaced by every threshold.</source>
      <translation>H = {height} m, Dn = {diameter} m. 소실·이탈 블록은 모든 문턱값에서 변위로 센다.</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Displaced by at least</source>
      <translation>다음 이상 변위</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Threshold (m)</source>
      <translation>문턱값(m)</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Share</source>
      <translation>비율</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>over {width} m: units displaced by one Dn or more, relocated or lost, per Dn of width (van der Meer, 1988).</source>
      <translation>{width} m 구간: 1 Dn 이상 변위, 이탈, 소실 블록 수, 너비 Dn당(van der Meer, 1988).</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Sections along the axis</source>
      <translation>축을 따른 구간</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Share of displaced units per section</source>
      <translation>구간별 변위 블록 비율</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Chainage (m)</source>
      <translation>측점 거리(m)</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>No unit has a displacement to show.</source>
      <translation>변위를 보일 블록이 없습니다.</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Decisions and corrections</source>
      <translation>결정과 수정</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Confirmed by</source>
      <translation>확인자</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Comment</source>
      <translation>의견</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>inspect on site</source>
      <translation>현장 점검</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>No reviewer has decided on this epoch pair.</source>
      <translation>이 시기 쌍을 결정한 검토자가 없습니다.</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Correction</source>
      <translation>수정</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>By</source>
      <translation>수행자</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Map of displacements</source>
      <translation>변위 지도</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Displacement of the units' centres.</source>
      <translation>블록 중심의 변위.</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Histogram of displacements</source>
      <translation>변위 히스토그램</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Displacements of all units with the thresholds of the next section.</source>
      <translation>모든 블록의 변위와 다음 절의 문턱값.</translation>
    </message>
    <message>
      <location filename="../core/section_map.html" />
      <source>Map of the units by class</source>
      <translation>등급별 블록 지도</translation>
    </message>
    <message>
      <location filename="../core/section_map.html" />
      <source>Units by class and control points; coordinates in {crs}.</source>
      <translation>등급별 블록과 기준점. 좌표계 {crs}.</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Method, settings and versions</source>
      <translation>방법, 설정, 버전</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Units are found in the point cloud as four cones with a common centre, adjusted to their points (Gauss-Helmert model), and brought into the frame of the survey control; displacements are differences of the feature points that follow from the adjusted model, tested against their covariance (after Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds).</source>
      <translation>블록은 공통 중심을 가진 네 원뿔로 점군에서 찾아 그 점에 조정(가우스-헬머트 모델)하고 기준점계로 옮긴다. 변위는 조정된 모델에서 나온 특징점의 차이이며 공분산에 대해 검정한다(Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds에 따름).</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Time</source>
      <translation>시각</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>σ0 of the registration</source>
      <translation>정합의 σ0</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Software</source>
      <translation>소프트웨어</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Settings</source>
      <translation>설정</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Written {moment} by {software}.</source>
      <translation>{moment}에 {software}(으)로 작성.</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Quality of the units</source>
      <translation>블록의 품질</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Uncertain units</source>
      <translation>불확실한 블록</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Points to surface, median (mm)</source>
      <translation>점에서 표면까지 거리, 중앙값(mm)</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Largest overlap</source>
      <translation>최대 겹침</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Pairs too close</source>
      <translation>너무 가까운 쌍</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Overlap is the share of a unit's volume inside another one; two solid units cannot overlap, nor can their centres come closer than half a height. A gap is a place where a unit is likely missing in the result; the layer gaps shows them.</source>
      <translation>겹침은 한 블록의 부피 중 다른 블록 안에 있는 비율입니다. 단단한 두 블록은 겹칠 수 없고 중심이 높이의 절반보다 가까워질 수도 없습니다. 결손 위치는 결과에 블록이 빠졌을 가능성이 큰 곳이며 레이어 gaps에 표시됩니다.</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>The result was made by a version that did not state the quality of its units.</source>
      <translation>이 결과는 블록의 품질을 기록하지 않는 버전으로 만들어졌습니다.</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Summary</source>
      <translation>요약</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units judged</source>
      <translation>평가한 블록</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Significant displacements</source>
      <translation>유의한 변위</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Lost</source>
      <translation>소실</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Relocated</source>
      <translation>이탈</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>New</source>
      <translation>신규</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Not seen in the later epoch</source>
      <translation>뒤 시기에 안 보임</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Displaced by 5 cm or more</source>
      <translation>5 cm 이상 변위</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Displaced by 10 cm or more</source>
      <translation>10 cm 이상 변위</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Decided by reviewers</source>
      <translation>검토자가 결정</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Rejected by reviewers</source>
      <translation>검토자가 기각</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units known to be missing</source>
      <translation>없는 것으로 알려진 블록</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Completeness</source>
      <translation>완전성</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units rejected by reviewers and left out of all figures, maps and tables below: {count}.</source>
      <translation>검토자가 기각해 아래 모든 수치, 지도, 표에서 뺀 블록: {count}.</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units that no reviewer has decided on yet: {count}.</source>
      <translation>아직 결정되지 않은 블록: {count}.</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>Units with the largest displacements</source>
      <translation>변위가 가장 큰 블록</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>East {e}, north {n}, up {h} cm; rotation {turn}; p {p}</source>
      <translation>동 {e}, 북 {n}, 위 {h} cm; 회전 {turn}; p {p}</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>Plan and section of {unit}</source>
      <translation>{unit}의 평면과 단면</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>Series of {unit}</source>
      <translation>{unit}의 시계열</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>No displacement is significant.</source>
      <translation>유의한 변위가 없습니다.</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>control used</source>
      <translation>사용한 기준점</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>control not used</source>
      <translation>사용하지 않은 기준점</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>arrows: significant horizontal displacements, enlarged {scale} times</source>
      <translation>화살표: 유의한 수평 변위, {scale}배 확대</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>3D displacement (cm)</source>
      <translation>3D 변위(cm)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>all units</source>
      <translation>모든 블록</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>units</source>
      <translation>블록 수</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>plan</source>
      <translation>평면</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>section {azimuth}°</source>
      <translation>단면 {azimuth}°</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>chainage along the axis (m)</source>
      <translation>축을 따른 측점 거리(m)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>units ≥ 10 cm (%)</source>
      <translation>10 cm 이상 블록(%)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>easting (m)</source>
      <translation>동 좌표(m)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>northing (m)</source>
      <translation>북 좌표(m)</translation>
    </message>
  </context>
</TS>
