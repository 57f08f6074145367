<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt_PT" sourcelanguage="en">
  <context>
    <name>tetratrack</name>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Units at the common centre of their cones, with orientation, standard deviations (m, degrees), score and status.</source>
      <translation>Blocos no centro comum dos seus cones, com orientação, desvios-padrão (m, graus), pontuação e estado.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Centre and the four joints of three cones (f123, f124, f134, f234) of every unit, with covariance (m, m²).</source>
      <translation>Centro e as quatro junções de três cones (f123, f124, f134, f234) de cada bloco, com covariância (m, m²).</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Displacement of every feature point between consecutive epochs (m), with test statistic and class.</source>
      <translation>Deslocamento de cada ponto característico entre épocas consecutivas (m), com estatística de teste e classe.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Residuals at the control points (m), with normalised residual; disturbed points are marked.</source>
      <translation>Resíduos nos pontos de apoio (m), com resíduo normalizado; os pontos perturbados estão assinalados.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Feature points less surveyed check points (m).</source>
      <translation>Pontos característicos menos pontos de verificação medidos (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Monitoring</source>
      <translation>Monitorização</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Single steps</source>
      <translation>Passos isolados</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Planning and simulation</source>
      <translation>Planeamento e simulação</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Inputs and outputs</source>
      <translation>Entradas e saídas</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Limits</source>
      <translation>Limites</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>The engine's result holds no layer {layer}.</source>
      <translation>O resultado do motor não contém a camada {layer}.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Numbers for models</source>
      <translation>Números para modelos</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Displacement report</source>
      <translation>Relatório de deslocamentos</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Writes the report of a result as reviewed so far: summary, control quality, displacement map and table, worst units, damage figures, method, settings and versions.</source>
      <translation>Escreve o relatório de um resultado conforme revisto até agora: resumo, qualidade do apoio, mapa e tabela de deslocamentos, piores blocos, índices de dano, método, definições e versões.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Rejected units are left out of the statistics and listed apart. PDF needs the library weasyprint in the engine.</source>
      <translation>Os blocos rejeitados ficam fora das estatísticas e são listados à parte. O PDF precisa da biblioteca weasyprint no motor.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>report,HTML,PDF,damage,displacement</source>
      <translation>relatório,HTML,PDF,dano,deslocamento</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>GeoPackage written by Monitor a survey.</source>
      <translation>GeoPackage escrito por Monitorizar um levantamento.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>HTML in one file, or PDF; the ending decides.</source>
      <translation>HTML num ficheiro, ou PDF; a extensão decide.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Result</source>
      <translation>Resultado</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Report</source>
      <translation>Relatório</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Extract feature points</source>
      <translation>Extrair pontos característicos</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Derives the centre and the four points where three cone surfaces meet on the outside of each unit, with the covariance carried over from the fit. These points can be surveyed by total station as well.</source>
      <translation>Calcula o centro e os quatro pontos onde três superfícies cónicas se encontram no exterior de cada bloco, com a covariância propagada do ajustamento. Estes pontos podem também ser medidos com estação total.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>A joint is marked as observed only where points lie next to it; otherwise it follows from the rest of the unit.</source>
      <translation>Uma junção só é marcada como observada se houver pontos junto dela; caso contrário resulta do resto do bloco.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>feature points,cone intersection,centre,covariance propagation</source>
      <translation>pontos característicos,interseção de cones,centro,propagação de covariância</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Layer of units from Fit tetrapods or Monitor a survey.</source>
      <translation>Camada de blocos de Ajustar tetrápodes ou Monitorizar um levantamento.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Fitted units</source>
      <translation>Blocos ajustados</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Points</source>
      <translation>Pontos</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Fit tetrapods</source>
      <translation>Ajustar tetrápodes</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Fits four equal cones that share a centre to the points of each unit by an iterated Gauss–Helmert adjustment with robust weights, end discs and removal of the curvature bias; gives pose, radius, taper and their covariance.</source>
      <translation>Ajusta quatro cones iguais com centro comum aos pontos de cada bloco por um ajustamento de Gauss-Helmert iterado com pesos robustos, discos terminais e remoção do viés de curvatura; dá pose, raio, conicidade e a sua covariância.</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>With one visible leg the twist about its axis is undetermined: the unit says so in its large standard deviation.</source>
      <translation>Com uma só perna visível a rotação em torno do seu eixo fica indeterminada: o grande desvio-padrão do bloco di-lo.</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>adjustment,Gauss-Helmert,least squares,cone,pose,covariance</source>
      <translation>ajustamento,Gauss-Helmert,mínimos quadrados,cone,pose,covariância</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Layer of units from Segment tetrapods, with the fields qx, qy, qz, qw of their orientation.</source>
      <translation>Camada de blocos de Segmentar tetrápodes, com os campos qx, qy, qz, qw da sua orientação.</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Units found</source>
      <translation>Blocos encontrados</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Units fitted</source>
      <translation>Blocos ajustados (número)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>LAS, LAZ or COPC files, a folder of them, a virtual point cloud (.vpc) or point cloud layers; coordinates in metres.</source>
      <translation>Ficheiros LAS, LAZ ou COPC, uma pasta, uma nuvem de pontos virtual (.vpc) ou camadas de nuvem de pontos; coordenadas em metros.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Projected CRS in metres; empty takes that of the tiles, and a local frame if they declare none.</source>
      <translation>SRC projetado em metros; vazio usa o dos blocos de dados, e um referencial local se não declararem nenhum.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Label of this survey in all results, for example its date.</source>
      <translation>Nome deste levantamento em todos os resultados, por exemplo a data.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Drives the temporal controller; empty takes the date of the first tile.</source>
      <translation>Comanda o controlador temporal; vazio usa a data do primeiro bloco de dados.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Estimates both from the best-seen units and holds them: moulds differ by centimetres from the standard proportions.</source>
      <translation>Estima ambos com os blocos mais bem vistos e fixa-os: os moldes diferem centímetros das proporções normalizadas.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Type of unit</source>
      <translation>Tipo de bloco</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Catalogue name with the mass in tonnes, such as tetrapod 8 t; or tetrapod with a height of your own.</source>
      <translation>Nome de catálogo com a massa em toneladas, como tetrapod 8 t; ou tetrapod com altura própria.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>From the plane under three legs to the top of the fourth, in metres; overrides the catalogue.</source>
      <translation>Do plano sob três pernas ao topo da quarta, em metros; prevalece sobre o catálogo.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Radius of a leg's cone at the unit's centre, in metres; empty takes 0.264 H.</source>
      <translation>Raio do cone de uma perna no centro do bloco, em metros; vazio usa 0,264 H.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Loss of radius per metre along the leg's axis; empty takes 0.176.</source>
      <translation>Perda de raio por metro ao longo do eixo da perna; vazio usa 0,176.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>From the centre to the end disc, in metres; empty takes 0.644 H.</source>
      <translation>Do centro ao disco terminal, em metros; vazio usa 0,644 H.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Built tetrapods are tetrahedral; 120° between leg 1 and the others repeats the published equations.</source>
      <translation>Os tetrápodes reais são tetraédricos; 120° entre a perna 1 e as outras repete as equações publicadas.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Polygon inside which units are looked for; its outer ring is used. Empty means everywhere.</source>
      <translation>Polígono onde se procuram blocos; usa-se o seu anel exterior. Vazio: em toda a parte.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Polygons around surfaces that do not move, such as the crown wall: they tie epochs without control to the earliest with control, or to the first.</source>
      <translation>Polígonos em torno de superfícies que não se movem, como o muro de coroamento: ligam as épocas sem controlo à primeira que o tem, ou à primeira de todas.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Blocks of the survey worked on at the same time; each takes about 1 GB of memory.</source>
      <translation>Partes do levantamento processadas ao mesmo tempo; cada uma ocupa cerca de 1 GB de memória.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Surveyed targets: point layer or CSV with point_id, easting, northing, height, sd_e, sd_n, sd_h (m).</source>
      <translation>Alvos medidos: camada de pontos ou CSV com point_id, easting, northing, height, sd_e, sd_n, sd_h (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The same targets as measured in this epoch's cloud: point layer or CSV with point_id, x, y, z (m).</source>
      <translation>Os mesmos alvos medidos na nuvem desta época: camada de pontos ou CSV com point_id, x, y, z (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Surveyed joints of cones, for validation only: CSV or layer with point_id, unit_easting, unit_northing, unit_height and position (m).</source>
      <translation>Junções de cones medidas, só para validação: CSV ou camada com point_id, unit_easting, unit_northing, unit_height e posição (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Give the height H of the unit, or choose a catalogue name with its mass, such as tetrapod 8 t.</source>
      <translation>Indique a altura H do bloco, ou escolha um nome de catálogo com a massa, como tetrapod 8 t.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The type of unit must be tetrapod, or a catalogue name such as tetrapod 8 t.</source>
      <translation>O tipo de bloco tem de ser tetrapod, ou um nome de catálogo como tetrapod 8 t.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Control points and targets in the cloud belong together: give both, or neither.</source>
      <translation>Pontos de apoio e alvos na nuvem vão juntos: indique ambos ou nenhum.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>CRS of the results</source>
      <translation>SRC dos resultados</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Epoch</source>
      <translation>Época</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Time of the survey (UTC)</source>
      <translation>Hora do levantamento (UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Calibrate radius and taper</source>
      <translation>Calibrar raio e conicidade</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Height H of the unit (m)</source>
      <translation>Altura H do bloco (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Cone radius at the centre (m)</source>
      <translation>Raio do cone no centro (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Taper of the leg</source>
      <translation>Conicidade da perna</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Leg length (m)</source>
      <translation>Comprimento da perna (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Angle between the legs</source>
      <translation>Ângulo entre as pernas</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Area of interest</source>
      <translation>Área de interesse</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Stable areas</source>
      <translation>Áreas estáveis</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Worker processes</source>
      <translation>Processos de trabalho</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Control points</source>
      <translation>Pontos de apoio</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Targets in the cloud</source>
      <translation>Alvos na nuvem</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Check points</source>
      <translation>Pontos de verificação</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The cone radius must be smaller than half the height of the unit.</source>
      <translation>O raio do cone tem de ser menor do que metade da altura do bloco.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The area of interest holds no polygon.</source>
      <translation>A área de interesse não contém nenhum polígono.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The area of interest has several separate parts; give one polygon.</source>
      <translation>A área de interesse tem várias partes separadas; indique um só polígono.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Point cloud tiles</source>
      <translation>Ficheiros de nuvem de pontos</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>tetrahedral (109.5°)</source>
      <translation>tetraédrico (109,5°)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>as in the paper (120°)</source>
      <translation>como no artigo (120°)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{crs} is geographic; choose a projected CRS in metres.</source>
      <translation>{crs} é geográfico; escolha um SRC projetado em metros.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: no LAS or LAZ file is given.</source>
      <translation>{where}: não foi indicado nenhum ficheiro LAS ou LAZ.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: there is no file or layer {path}.</source>
      <translation>{where}: não existe o ficheiro ou camada {path}.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{layer} cannot be written: {reason}.</source>
      <translation>{layer} não pode ser escrito: {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{layer} has no field {fields}; it has {present}.</source>
      <translation>{layer} não tem o campo {fields}; tem {present}.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: the folder {path} holds no LAS or LAZ file.</source>
      <translation>{where}: a pasta {path} não contém ficheiros LAS ou LAZ.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: {path} is not a virtual point cloud.</source>
      <translation>{where}: {path} não é uma nuvem de pontos virtual.</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Inspect tiles</source>
      <translation>Inspecionar ficheiros</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Lists point cloud tiles with their extent, CRS, number and density of points and range of heights. Run it first: it shows missing CRS, gaps, overlaps and tiles too thin to find units in.</source>
      <translation>Lista os ficheiros de nuvem de pontos com extensão, SRC, número e densidade de pontos e gama de altitudes. Execute primeiro: mostra SRC em falta, lacunas, sobreposições e ficheiros demasiado esparsos.</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Reads headers and a sample of points; a damaged tile is named and ends the run.</source>
      <translation>Lê cabeçalhos e uma amostra de pontos; um ficheiro danificado é nomeado e termina a execução.</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>point cloud,LAS,LAZ,tile index,density,CRS,extent</source>
      <translation>nuvem de pontos,LAS,LAZ,índice,densidade,SRC,extensão</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>One rectangle per tile with file, CRS, points, density (points/m²) and heights (m).</source>
      <translation>Um retângulo por ficheiro com nome, SRC, pontos, densidade (pontos/m²) e altitudes (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Tile index</source>
      <translation>Índice de ficheiros</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Tiles</source>
      <translation>Ficheiros</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Median density (points/m²)</source>
      <translation>Densidade mediana (pontos/m²)</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>CRS of the tiles</source>
      <translation>SRC dos ficheiros</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Monitor a survey</source>
      <translation>Monitorizar um levantamento</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>All steps at once: registers every epoch to survey control, finds the tetrapods, fits four cones that share a centre, derives feature points and tests their displacements. Give a survey.toml, or the epochs and the unit.</source>
      <translation>Todos os passos de uma vez: regista cada época ao apoio topográfico, encontra os tetrápodes, ajusta quatro cones de centro comum, calcula pontos característicos e testa os seus deslocamentos. Indique um survey.toml, ou as épocas e o bloco.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Units of which less than about 5 % is seen are not found. Without control the cloud's own frame is used, and the result says so.</source>
      <translation>Blocos vistos em menos de cerca de 5 % não são encontrados. Sem apoio usa-se o referencial da própria nuvem, e o resultado di-lo.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>tetrapod,armour unit,breakwater,displacement,monitoring,LAS,LAZ,deformation</source>
      <translation>tetrápode,bloco de manto,quebra-mar,deslocamento,monitorização,LAS,LAZ,deformação</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>A survey.toml; if given, it states everything, and the fields for epochs, unit, CRS and area are not used.</source>
      <translation>Um survey.toml; se indicado, decide tudo, e os campos de épocas, bloco, SRC e área não são usados.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Label</source>
      <translation>Nome</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Time (UTC)</source>
      <translation>Hora (UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>One row per epoch: label, time such as 2025-03-14T02:30, folder or files of tiles (separated by ;), CSV files or layers.</source>
      <translation>Uma linha por época: nome, hora como 2025-03-14T02:30, pasta ou ficheiros (separados por ;), ficheiros CSV ou camadas.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Writes a top view of each epoch as GeoTIFF beside the result, as a backdrop.</source>
      <translation>Escreve uma vista de cima de cada época como GeoTIFF junto ao resultado, como fundo.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Adds all layers to the project as a group with their styles.</source>
      <translation>Junta todas as camadas ao projeto como grupo com os seus estilos.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>GeoPackage with units, feature points, displacements, residuals, epochs and reviews, in the survey's CRS, times in UTC.</source>
      <translation>GeoPackage com blocos, pontos característicos, deslocamentos, resíduos, épocas e revisões, no SRC do levantamento, horas em UTC.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Survey file</source>
      <translation>Ficheiro do levantamento</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Epochs</source>
      <translation>Épocas</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Shaded relief of each epoch</source>
      <translation>Relevo sombreado de cada época</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Load the result</source>
      <translation>Carregar o resultado</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Units moved</source>
      <translation>Blocos movidos</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>RMSE at check points (m)</source>
      <translation>EMQ nos pontos de verificação (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Give a survey.toml, or at least one epoch with its tiles.</source>
      <translation>Indique um survey.toml, ou pelo menos uma época com os seus ficheiros.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Every epoch needs six columns: label, time, tiles, control points, targets, check points.</source>
      <translation>Cada época precisa de seis colunas: nome, hora, ficheiros, pontos de apoio, alvos, pontos de verificação.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Epoch {label}</source>
      <translation>Época {label}</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{where}: {path} cannot be read as a point layer or CSV file.</source>
      <translation>{where}: {path} não pode ser lido como camada de pontos ou ficheiro CSV.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>The folder {folder} does not exist.</source>
      <translation>A pasta {folder} não existe.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Plan a survey: detectable displacement</source>
      <translation>Planear um levantamento: deslocamento detetável</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Computes which displacement and rotation of a unit a planned survey will find, from point density, noise, visible share and registration: the Cramér–Rao bound of the adjustment for the unit's geometry, and Baarda's detectability.</source>
      <translation>Calcula que deslocamento e rotação de um bloco um levantamento planeado encontrará, a partir da densidade de pontos, ruído, parte visível e registo: limite de Cramér-Rao do ajustamento para a geometria do bloco, e detetabilidade de Baarda.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>White noise is averaged over the points of a unit; whatever does not average out must be stated as systematic part.</source>
      <translation>O ruído branco é promediado pelos pontos de um bloco; o que não se promedeia tem de ser indicado como parte sistemática.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>planning,detectability,point density,noise,Cramér-Rao bound,minimal detectable displacement</source>
      <translation>planeamento,detetabilidade,densidade de pontos,ruído,limite de Cramér-Rao,deslocamento mínimo detetável</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Point density (points/m²)</source>
      <translation>Densidade de pontos (pontos/m²)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>On a surface that faces the instrument, all flight strips or stations together.</source>
      <translation>Numa superfície virada para o instrumento, todas as faixas ou estações juntas.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Noise of a point (m)</source>
      <translation>Ruído de um ponto (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation along the surface normal, in metres.</source>
      <translation>Desvio-padrão ao longo da normal à superfície, em metros.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Visible share of a unit</source>
      <translation>Parte visível de um bloco</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share of a unit's surface that holds points, 0 to 1; in a pile 0.05 to 0.5.</source>
      <translation>Parte da superfície de um bloco que tem pontos, 0 a 1; num manto 0,05 a 0,5.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Registration (m)</source>
      <translation>Registo (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of an epoch's registration at the unit, per coordinate, in metres.</source>
      <translation>Desvio-padrão do registo de uma época no bloco, por coordenada, em metros.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Systematic part (m)</source>
      <translation>Parte sistemática (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Strip offsets, roughness and growth that do not average out, per coordinate, in metres.</source>
      <translation>Desvios de faixas, rugosidade e incrustações que não se promedeiam, por coordenada, em metros.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Line of sight from the vertical (degrees)</source>
      <translation>Linha de visada a partir da vertical (graus)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>0 from the air; about 70 from the crown wall.</source>
      <translation>0 do ar; cerca de 70 do muro-cortina.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Calibrated and held; otherwise they are estimated for every unit, which costs accuracy.</source>
      <translation>Calibrados e fixos; caso contrário são estimados para cada bloco, com perda de exatidão.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Level of significance</source>
      <translation>Nível de significância</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Probability of a false alarm for one unit.</source>
      <translation>Probabilidade de falso alarme para um bloco.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Power</source>
      <translation>Potência</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Probability with which the displacement is found.</source>
      <translation>Probabilidade de encontrar o deslocamento.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Points on a unit</source>
      <translation>Pontos num bloco</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of the centre (m)</source>
      <translation>Desvio-padrão do centro (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of the rotation (degrees)</source>
      <translation>Desvio-padrão da rotação (graus)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of a displacement (m)</source>
      <translation>Desvio-padrão de um deslocamento (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable displacement, worst direction (m)</source>
      <translation>Deslocamento detetável, pior direção (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable displacement, mean (m)</source>
      <translation>Deslocamento detetável, média (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable rotation (degrees)</source>
      <translation>Rotação detetável (graus)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>The level of significance must be below the power.</source>
      <translation>O nível de significância tem de ser menor do que a potência.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Radius and taper are known</source>
      <translation>Raio e conicidade conhecidos</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Register to control</source>
      <translation>Registar ao apoio</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Estimates the rigid transformation from an epoch's cloud to survey control from targets, weighted by their standard deviations, and finds disturbed targets by data snooping on normalised residuals.</source>
      <translation>Estima a transformação rígida da nuvem de uma época para o apoio a partir de alvos ponderados pelos desvios-padrão, e encontra alvos perturbados por data snooping dos resíduos normalizados.</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Needs three targets that do not lie in one line; an outlier is found from four, and named surely from five.</source>
      <translation>Precisa de três alvos não alinhados; um erro grosseiro encontra-se com quatro e nomeia-se com segurança com cinco.</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>registration,control points,targets,transformation,data snooping,georeferencing</source>
      <translation>registo,pontos de apoio,alvos,transformação,data snooping,georreferenciação</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>GeoPackage whose table epochs holds the seven parameters and their covariance.</source>
      <translation>GeoPackage cuja tabela epochs contém os sete parâmetros e a sua covariância.</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Registration</source>
      <translation>Registo (resultado)</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>RMSE at control points (m)</source>
      <translation>EMQ nos pontos de apoio (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Disturbed targets</source>
      <translation>Alvos perturbados</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Register views</source>
      <translation>Registar vistas</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Brings overlapping views of a depth camera or scanner stations into the frame of the first by multiway ICP with a pose graph, and writes one cloud in which every view keeps its number as point source id.</source>
      <translation>Leva vistas sobrepostas de uma câmara de profundidade ou estações de scanner ao referencial da primeira por ICP múltiplo com grafo de poses, e escreve uma nuvem em que cada vista mantém o seu número como identificador de origem.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Views must overlap by a third or more and be roughly aligned; views that do not connect are named.</source>
      <translation>As vistas têm de se sobrepor um terço ou mais e estar aproximadamente alinhadas; as que não se ligam são nomeadas.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>registration,ICP,pose graph,depth camera,multi-view</source>
      <translation>registo,ICP,grafo de poses,câmara de profundidade,multivista</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Resolution at which views are matched, in metres; empty derives it from the point spacing.</source>
      <translation>Resolução a que as vistas são comparadas, em metros; vazio deduz-na do espaçamento dos pontos.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>One LAZ file in the frame of the first view.</source>
      <translation>Um ficheiro LAZ no referencial da primeira vista.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Views</source>
      <translation>Vistas</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Voxel size (m)</source>
      <translation>Tamanho do vóxel (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Registered cloud</source>
      <translation>Nuvem registada</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>RMSE between views (m)</source>
      <translation>EMQ entre vistas (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Segment tetrapods</source>
      <translation>Segmentar tetrápodes</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Finds every tetrapod in a pile: cones from pairs of oriented points, legs that agree on a common centre and on the angles between them, and verification against the visible surface and against empty space.</source>
      <translation>Encontra cada tetrápode de um manto: cones a partir de pares de pontos orientados, pernas que concordam num centro comum e nos ângulos entre si, e verificação com a superfície visível e o espaço vazio.</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Units of which less than about 5 % is seen are not found; weak evidence has the status uncertain. Poses are approximate: fit them next.</source>
      <translation>Blocos vistos em menos de cerca de 5 % não são encontrados; evidência fraca tem o estado incerto. As poses são aproximadas: ajuste-as a seguir.</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>segmentation,RANSAC,cone,tetrapod,armour unit,detection</source>
      <translation>segmentação,RANSAC,cone,tetrápode,bloco de manto,deteção</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Simulate a survey</source>
      <translation>Simular um levantamento</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Writes a simulated survey of a tetrapod slope with known poses: LAZ tiles, control, check points and survey.toml. Use it to try the chain, to train, or to test a planned density and noise.</source>
      <translation>Escreve o levantamento simulado de um talude de tetrápodes de poses conhecidas: ficheiros LAZ, apoio, pontos de verificação e survey.toml. Serve para experimentar a cadeia, treinar ou testar uma densidade e um ruído planeados.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Simulated surfaces are cleaner than real ones; judge a plan with some reserve.</source>
      <translation>As superfícies simuladas são mais limpas do que as reais; julgue um plano com reserva.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>simulation,synthetic,ground truth,test data</source>
      <translation>simulação,sintético,verdade do terreno,dados de teste</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>UAV laser scanner</source>
      <translation>scanner laser em drone</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>terrestrial laser scanner</source>
      <translation>scanner laser terrestre</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>photogrammetry</source>
      <translation>fotogrametria</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>depth camera</source>
      <translation>câmara de profundidade</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Decides viewpoints, hidden parts and, unless stated, noise and density.</source>
      <translation>Decide os pontos de vista, as partes ocultas e, salvo indicação, o ruído e a densidade.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Number of units on the slope.</source>
      <translation>Número de blocos no talude.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Number of surveys; some units move between them.</source>
      <translation>Número de levantamentos; alguns blocos movem-se entre eles.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Standard deviation of the range, in metres; empty takes that of the instrument.</source>
      <translation>Desvio-padrão da distância, em metros; vazio usa o do instrumento.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>On the ground; empty takes that of the instrument.</source>
      <translation>No terreno; vazio usa a do instrumento.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>The same seed gives the same survey.</source>
      <translation>A mesma semente dá o mesmo levantamento.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Receives tiles, CSV files, survey.toml and truth.</source>
      <translation>Recebe ficheiros, CSV, survey.toml e verdade.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Instrument</source>
      <translation>Instrumento</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Units</source>
      <translation>Blocos</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Seed</source>
      <translation>Semente</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Survey folder</source>
      <translation>Pasta do levantamento</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>survey.toml of the simulated survey</source>
      <translation>survey.toml do levantamento simulado</translation>
    </message>
    <message>
      <location filename="../algorithms/survey_algorithm.py" />
      <source>The tiles declare no CRS: results are in a local frame. Choose the CRS of the results to change that.</source>
      <translation>Os ficheiros não declaram SRC: os resultados estão num referencial local. Escolha o SRC dos resultados para mudar isso.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Track displacements</source>
      <translation>Acompanhar deslocamentos</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Recognises each unit in all epochs, finds the stable units by a global congruence test and tests the displacement of every feature point and the rotation of every unit against it, with the covariance of fit and registration.</source>
      <translation>Reconhece cada bloco em todas as épocas, encontra os blocos estáveis por um teste global de congruência e testa contra eles o deslocamento de cada ponto característico e a rotação de cada bloco, com a covariância do ajustamento e do registo.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>A rotation near 60° or more is ambiguous by the symmetry of the tetrapod and is reported as such.</source>
      <translation>Uma rotação perto de 60° ou mais é ambígua pela simetria do tetrápode e é assinalada como tal.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>displacement,deformation analysis,congruence test,epoch,monitoring</source>
      <translation>deslocamento,análise de deformações,teste de congruência,época,monitorização</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Layers of units from Fit tetrapods: one per epoch, each with its own label and time, all in one CRS.</source>
      <translation>Camadas de blocos de Ajustar tetrápodes: uma por época, cada uma com o seu nome e hora, todas num SRC.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>GeoPackages from Register to control, one per epoch; without them the clouds' own frames are taken as registered.</source>
      <translation>GeoPackages de Registar ao apoio, um por época; sem eles os referenciais das nuvens são tomados como registados.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Fitted units of all epochs</source>
      <translation>Blocos ajustados de todas as épocas</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Registrations</source>
      <translation>Registos</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Give the units of at least two epochs.</source>
      <translation>Indique os blocos de pelo menos duas épocas.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>The layers of units have different CRS: {crs}.</source>
      <translation>As camadas de blocos têm SRC diferentes: {crs}.</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Validate against check points</source>
      <translation>Validar com pontos de verificação</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Compares feature points of one epoch with the same points surveyed by total station or GNSS. Check points never take part in the fit: their differences show the accuracy that was reached.</source>
      <translation>Compara pontos característicos de uma época com os mesmos pontos medidos por estação total ou GNSS. Os pontos de verificação nunca entram no ajustamento: as suas diferenças mostram a exatidão alcançada.</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>A check point is matched by the approximate centre of its unit; one that matches no unit is named and left out.</source>
      <translation>Um ponto de verificação é emparelhado pelo centro aproximado do seu bloco; o que não encontra nenhum é nomeado e omitido.</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>validation,accuracy,check points,total station,GNSS,RMSE</source>
      <translation>validação,exatidão,pontos de verificação,estação total,GNSS,EMQ</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Layer from Extract feature points, of one epoch.</source>
      <translation>Camada de Extrair pontos característicos, de uma época.</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Feature points</source>
      <translation>Pontos característicos</translation>
    </message>
    <message>
      <location filename="../plugin/engine.py" />
      <source>The tetratrack engine is not installed: open Settings &gt; Options &gt; Tetratrack and create its environment or choose one.</source>
      <translation>O motor tetratrack não está instalado: abra Configurações &gt; Opções &gt; Tetratrack e crie o seu ambiente ou escolha um.</translation>
    </message>
    <message>
      <location filename="../plugin/engine.py" />
      <source>The engine ended unexpectedly (exit code {code}); QGIS and your data are unharmed.</source>
      <translation>O motor terminou inesperadamente (código {code}); o QGIS e os seus dados estão intactos.</translation>
    </message>
    <message>
      <location filename="../plugin/engine.py" />
      <source>The engine could not be started with {python}: {reason}.</source>
      <translation>Não foi possível iniciar o motor com {python}: {reason}.</translation>
    </message>
    <message>
      <location filename="../plugin/engine_task.py" />
      <source>Cancelled.</source>
      <translation>Cancelado.</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>found</source>
      <translation>encontrado</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>uncertain</source>
      <translation>incerto</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>new</source>
      <translation>novo</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>relocated</source>
      <translation>arrastado</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>lost: the place is empty</source>
      <translation>perdido: o lugar está vazio</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>unseen: known from another epoch</source>
      <translation>não visto: conhecido de outra época</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>unexplained points where a unit fits</source>
      <translation>pontos inexplicados onde cabe um bloco</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>hole where a unit fits</source>
      <translation>buraco onde cabe um bloco</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>arrow of 10 mm: 50 mm; ellipse: 95 %</source>
      <translation>seta de 10 mm: 50 mm; elipse: 95 %</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>below the detection limit</source>
      <translation>abaixo do limite de deteção</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>significant, up to 50 mm</source>
      <translation>significativo, até 50 mm</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>50 to 100 mm: watch</source>
      <translation>50 a 100 mm: vigilância</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>more than 100 mm: alert</source>
      <translation>mais de 100 mm: alerta</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>relocated unit</source>
      <translation>bloco arrastado</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>uncertain unit</source>
      <translation>bloco incerto</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>observed</source>
      <translation>observado</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>derived from the rest of the unit</source>
      <translation>deduzido do resto do bloco</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>used</source>
      <translation>usado</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>disturbed, not used</source>
      <translation>perturbado, não usado</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>not used</source>
      <translation>não usado</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>check point</source>
      <translation>ponto de verificação</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Gaps</source>
      <translation>Lacunas</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Displacements</source>
      <translation>Deslocamentos</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Displacements, other pairs and datum</source>
      <translation>Deslocamentos, outros pares e outro datum</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Control residuals</source>
      <translation>Resíduos de apoio</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Check residuals</source>
      <translation>Resíduos de verificação</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Reviews</source>
      <translation>Revisões</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create a Python environment in {folder} and download about {size} of libraries into it?</source>
      <translation>Criar um ambiente Python em {folder} e descarregar para lá cerca de {size} de bibliotecas?</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Creating the tetratrack engine</source>
      <translation>A criar o motor tetratrack</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python interpreter of the engine</source>
      <translation>Interpretador Python do motor</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Empty uses the environment that the plugin creates.</source>
      <translation>Vazio usa o ambiente que o módulo cria.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create the engine's environment…</source>
      <translation>Criar o ambiente do motor…</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Engine</source>
      <translation>Motor</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>State</source>
      <translation>Estado</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>The engine is ready.</source>
      <translation>O motor está pronto.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python 3.11 or later was not found: install it, or choose an interpreter of the engine above.</source>
      <translation>Não foi encontrado Python 3.11 ou posterior: instale-o, ou escolha acima um interpretador do motor.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>The engine's environment could not be created: {reason}</source>
      <translation>Não foi possível criar o ambiente do motor: {reason}</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Used: {python}</source>
      <translation>Em uso: {python}</translation>
    </message>
    <message>
      <location filename="../plugin/provider.py" />
      <source>Tetratrack: displacements of tetrapods</source>
      <translation>Tetratrack: deslocamentos de tetrápodes</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Survey description</source>
      <translation>Descrição do levantamento</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Survey (*.toml)</source>
      <translation>Levantamento (*.toml)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fit again after a click on the unit (earlier epoch)</source>
      <translation>Ajustar de novo após clicar no bloco (época anterior)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fit again after a click on the unit (later epoch)</source>
      <translation>Ajustar de novo após clicar no bloco (época posterior)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints of legs (earlier epoch)</source>
      <translation>Fixar por três junções de pernas (época anterior)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints of legs (later epoch)</source>
      <translation>Fixar por três junções de pernas (época posterior)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pick feature points beside the fit (earlier epoch)</source>
      <translation>Marcar pontos característicos ao lado do ajustamento (época anterior)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pick feature points beside the fit (later epoch)</source>
      <translation>Marcar pontos característicos ao lado do ajustamento (época posterior)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Placeholder for a unit not found</source>
      <translation>Marcador de um bloco não encontrado</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Merge the two selected units</source>
      <translation>Fundir os dois blocos selecionados</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Split at the later epoch: two units taken for one</source>
      <translation>Dividir na época posterior: dois blocos tomados por um</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Delete: not a unit</source>
      <translation>Eliminar: não é um bloco</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Take back the last correction</source>
      <translation>Anular a última correção</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Read the points around the units…</source>
      <translation>Ler os pontos à volta dos blocos…</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The points around the units are needed: read them from the correction menu.</source>
      <translation>São precisos os pontos à volta dos blocos: leia-os no menu de correção.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>There are no points here; click on the cloud.</source>
      <translation>Não há pontos aqui; clique na nuvem.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The unit has no pose in any epoch to take its size from.</source>
      <translation>O bloco não tem pose em nenhuma época de onde tirar o tamanho.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>pinned by three joints</source>
      <translation>fixado por três junções</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The unit was not found in this epoch: pin it by three joints instead.</source>
      <translation>O bloco não foi encontrado nesta época: fixe-o antes por três junções.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Select the two units to merge.</source>
      <translation>Selecione os dois blocos a fundir.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>There is no correction to take back.</source>
      <translation>Não há correção para anular.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Reading points around units</source>
      <translation>A ler pontos à volta dos blocos</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Points read.</source>
      <translation>Pontos lidos.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Select a unit first.</source>
      <translation>Selecione primeiro um bloco.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click the middle of the unit on the map or in a view; Escape ends.</source>
      <translation>Clique no meio do bloco no mapa ou numa vista; Escape termina.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click three joints where three legs meet, on the map or in the views; Escape ends.</source>
      <translation>Clique em três junções onde três pernas se encontram, no mapa ou nas vistas; Escape termina.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click a joint where three legs meet; Escape ends.</source>
      <translation>Clique numa junção onde três pernas se encontram; Escape termina.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click where the unit lies on the map; Escape ends.</source>
      <translation>Clique onde está o bloco no mapa; Escape termina.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fitting {unit} again</source>
      <translation>A ajustar {unit} de novo</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} was fitted again.</source>
      <translation>{unit} foi ajustado de novo.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} pinned; the picks fit within {length}.</source>
      <translation>{unit} fixado; as marcas concordam dentro de {length}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{feature} picked, {length} from the fit.</source>
      <translation>{feature} marcado, a {length} do ajustamento.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Placeholder {name} stored; it counts as a unit not found.</source>
      <translation>Marcador {name} guardado; conta como bloco não encontrado.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{count} of 3 joints.</source>
      <translation>{count} de 3 junções.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{other} is now {keep}.</source>
      <translation>{other} é agora {keep}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} is called {name} from {epoch} on.</source>
      <translation>{unit} chama-se {name} a partir de {epoch}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} was deleted; take it back from the correction menu.</source>
      <translation>{unit} foi eliminado; recupere-o no menu de correção.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Taken back: {kind} {unit}.</source>
      <translation>Retirado: {kind} {unit}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Check point</source>
      <translation>Ponto de verificação</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Feature</source>
      <translation>Ponto característico</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Surveyed</source>
      <translation>Medido</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Fitted</source>
      <translation>Ajustado</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Difference</source>
      <translation>Diferença</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>3D displacement</source>
      <translation>Deslocamento 3D</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>in heights H, in Dn</source>
      <translation>em alturas H, em Dn</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Easting</source>
      <translation>Este</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Northing</source>
      <translation>Norte</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Height</source>
      <translation>Altitude</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Horizontal</source>
      <translation>Horizontal</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>significant</source>
      <translation>significativo</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>not significant</source>
      <translation>não significativo</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Detection limit</source>
      <translation>Limite de deteção</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Seen</source>
      <translation>Visto</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Score</source>
      <translation>Pontuação</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Legs seen</source>
      <translation>Pernas vistas</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{shown} of {all} units shown</source>
      <translation>{shown} de {all} blocos mostrados</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} significant</source>
      <translation>{count} significativos</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} decided</source>
      <translation>{count} decididos</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} rejected, excluded from statistics and map</source>
      <translation>{count} rejeitados, fora das estatísticas e do mapa</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Displacement</source>
      <translation>Deslocamento</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>none: one of the two positions is not known</source>
      <translation>nenhum: uma das duas posições é desconhecida</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Rotation</source>
      <translation>Rotação</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Test against no motion</source>
      <translation>Teste contra imobilidade</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Check points ({unit})</source>
      <translation>Pontos de verificação ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Nobody has decided on this unit yet.</source>
      <translation>Ainda ninguém decidiu sobre este bloco.</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} lost</source>
      <translation>{count} perdidos</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} new</source>
      <translation>{count} novos</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>largest {length}</source>
      <translation>máximo {length}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>taken back</source>
      <translation>retirado</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Picked by hand</source>
      <translation>Marcado à mão</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{feature}, {epoch}: picked {length} from the fit ({who})</source>
      <translation>{feature}, {epoch}: marcado a {length} do ajustamento ({who})</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Displacement review</source>
      <translation>Revisão de deslocamentos</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Open a result</source>
      <translation>Abrir um resultado</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>GeoPackage (*.gpkg)</source>
      <translation>GeoPackage (*.gpkg)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Previous unit (Up, or P for the previous undecided)</source>
      <translation>Bloco anterior (Cima, ou P para o anterior por decidir)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Next unit (Down, or N for the next undecided)</source>
      <translation>Bloco seguinte (Baixo, ou N para o seguinte por decidir)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Zoom to the unit and flash it (Z)</source>
      <translation>Aproximar ao bloco e fazê-lo piscar (Z)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The map follows the selection</source>
      <translation>O mapa segue a seleção</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Show all units</source>
      <translation>Mostrar todos os blocos</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Correct a unit</source>
      <translation>Corrigir um bloco</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Write the report…</source>
      <translation>Escrever o relatório…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Export the alarm list…</source>
      <translation>Exportar a lista de alarmes…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>PDF (*.pdf);;Web page (*.html)</source>
      <translation>PDF (*.pdf);;Página web (*.html)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Alarm list</source>
      <translation>Lista de alarmes</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Threshold (cm)</source>
      <translation>Limiar (cm)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>CSV (*.csv);;GeoJSON (*.geojson)</source>
      <translation>CSV (*.csv);;GeoJSON (*.geojson)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Decisions of another reviewer were taken in.</source>
      <translation>Foram incorporadas decisões de outro revisor.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>In polygons</source>
      <translation>Em polígonos</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>No unit passes the filter.</source>
      <translation>Nenhum bloco passa o filtro.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Confirmed.</source>
      <translation>Confirmado.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Writing the report</source>
      <translation>A escrever o relatório</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Make a polygon layer active first.</source>
      <translation>Ative primeiro uma camada de polígonos.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>In the map window</source>
      <translation>Na janela do mapa</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Everywhere</source>
      <translation>Em toda a parte</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{title}…</source>
      <translation>{title}…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{name} is read-only: you can look, but decisions cannot be stored.</source>
      <translation>{name} é só de leitura: pode ver, mas não se podem guardar decisões.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{units}: {decision}, stored.</source>
      <translation>{units}: {decision}, guardado.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Taken back: {units}.</source>
      <translation>Retirado: {units}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Report written to {name}.</source>
      <translation>Relatório escrito em {name}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{count} units written to {name}.</source>
      <translation>{count} blocos escritos em {name}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Units reviewed</source>
      <translation>Blocos revistos</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements reviewed</source>
      <translation>Deslocamentos revistos</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements reviewed, other pair or datum</source>
      <translation>Deslocamentos revistos, outro par ou datum</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Rejected units (excluded)</source>
      <translation>Blocos rejeitados (excluídos)</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacement review: {name}</source>
      <translation>Revisão de deslocamentos: {name}</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Open the result.gpkg of a survey with two epochs or more to review its displacements.</source>
      <translation>Abra o result.gpkg de um levantamento com duas épocas ou mais para rever os deslocamentos.</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Open result…</source>
      <translation>Abrir resultado…</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Epochs compared</source>
      <translation>Épocas comparadas</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Reference of the displacements</source>
      <translation>Referência dos deslocamentos</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>All classes</source>
      <translation>Todas as classes</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Classes shown</source>
      <translation>Classes mostradas</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Least 3D displacement shown; lost, new and relocated units are always shown</source>
      <translation>Menor deslocamento 3D mostrado; blocos perdidos, novos e arrastados são sempre mostrados</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Area of the units shown</source>
      <translation>Área dos blocos mostrados</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Undecided only</source>
      <translation>Só por decidir</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Unit…</source>
      <translation>Bloco…</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Comment, stored with the decision</source>
      <translation>Comentário, guardado com a decisão</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Reviewer</source>
      <translation>Revisor</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Your name or initials, stored with every decision</source>
      <translation>O seu nome ou iniciais, guardados com cada decisão</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>In the active layer's polygons</source>
      <translation>Nos polígonos da camada ativa</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Accept</source>
      <translation>Aceitar</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The displacement is right (A)</source>
      <translation>O deslocamento está certo (A)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Reject</source>
      <translation>Rejeitar</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The displacement is wrong: it leaves statistics, maps and report (R)</source>
      <translation>O deslocamento está errado: sai das estatísticas, mapas e relatório (R)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Inspect</source>
      <translation>Inspecionar</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Inspect on site (I)</source>
      <translation>Inspecionar no local (I)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Confirm</source>
      <translation>Confirmar</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Confirm another reviewer's decision (C)</source>
      <translation>Confirmar a decisão de outro revisor (C)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Undo</source>
      <translation>Anular</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Take back your last decision (U)</source>
      <translation>Retirar a sua última decisão (U)</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Plan</source>
      <translation>Planta</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Select a unit</source>
      <translation>Selecione um bloco</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>N</source>
      <translation>N</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>No displacement of this unit</source>
      <translation>Sem deslocamento deste bloco</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>centre</source>
      <translation>centro</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Section {azimuth}°</source>
      <translation>Secção {azimuth}°</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>3D displacement ({unit})</source>
      <translation>Deslocamento 3D ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>detection limit</source>
      <translation>limite de deteção</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Series</source>
      <translation>Série</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Section along the displacement</source>
      <translation>Secção ao longo do deslocamento</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Direction of the section, from grid north; each outline is cut through its own centre</source>
      <translation>Direção da secção, a partir do norte da quadrícula; cada contorno é cortado pelo seu próprio centro</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Numbers</source>
      <translation>Números</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>History</source>
      <translation>Histórico</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>points not read yet</source>
      <translation>pontos ainda não lidos</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>stable</source>
      <translation>estável</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>moved</source>
      <translation>movido</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>rotated</source>
      <translation>rodado</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>lost</source>
      <translation>perdido</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>unseen</source>
      <translation>não visto</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>deleted</source>
      <translation>eliminado</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>merged</source>
      <translation>fundido</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>split</source>
      <translation>dividido</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>new pose</source>
      <translation>nova pose</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>placeholder</source>
      <translation>marcador</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Unit</source>
      <translation>Bloco</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Class</source>
      <translation>Classe</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Displ.</source>
      <translation>Desl.</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Horiz.</source>
      <translation>Horiz.</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Vert.</source>
      <translation>Vert.</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Rot.</source>
      <translation>Rot.</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>p</source>
      <translation>p</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Decision</source>
      <translation>Decisão</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Name of the unit, the same in all epochs</source>
      <translation>Nome do bloco, o mesmo em todas as épocas</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Class of the displacement, or the unit's fate</source>
      <translation>Classe do deslocamento, ou destino do bloco</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Rotation between the epochs (degrees)</source>
      <translation>Rotação entre as épocas (graus)</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Probability of so large a displacement if the unit stood still; bold where significant</source>
      <translation>Probabilidade de um deslocamento tão grande se o bloco estivesse parado; a negrito se significativo</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Share of the unit's surface that holds points, in the worse epoch</source>
      <translation>Parte da superfície do bloco que tem pontos, na pior época</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Decision of the reviewers</source>
      <translation>Decisão dos revisores</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Who decided, and ✓ who confirmed</source>
      <translation>Quem decidiu, e ✓ quem confirmou</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>accepted</source>
      <translation>aceite</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>rejected</source>
      <translation>rejeitado</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>inspect</source>
      <translation>inspecionar</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>stable units and control</source>
      <translation>blocos estáveis e apoio</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>control points alone</source>
      <translation>só pontos de apoio</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>decided</source>
      <translation>decidiu</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>confirmed</source>
      <translation>confirmou</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>took back</source>
      <translation>retirou</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>3D displacement of the centre ({unit})</source>
      <translation>Deslocamento 3D do centro ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Horizontal displacement of the centre ({unit})</source>
      <translation>Deslocamento horizontal do centro ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Vertical displacement of the centre, positive up ({unit})</source>
      <translation>Deslocamento vertical do centro, positivo para cima ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Monitor a survey…</source>
      <translation>Monitorizar um levantamento…</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Comparison with surveyed check points</source>
      <translation>Comparação com os pontos de verificação medidos</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Picked by hand (cm)</source>
      <translation>Marcado à mão (cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Fitting (cm)</source>
      <translation>Ajustamento (cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Surveyed (cm)</source>
      <translation>Medido (cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Error, picked (cm)</source>
      <translation>Erro, marcado (cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Error, fitting (cm)</source>
      <translation>Erro, ajustamento (cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>3D displacements of the same feature point, in the control frame (after Chan and Lichti, Table 1).</source>
      <translation>Deslocamentos 3D do mesmo ponto característico, no referencial de apoio (segundo Chan and Lichti, tabela 1).</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>The survey has no check points that both epochs share.</source>
      <translation>O levantamento não tem pontos de verificação comuns às duas épocas.</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Survey control</source>
      <translation>Apoio topográfico</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Congruence of the stable units</source>
      <translation>Congruência dos blocos estáveis</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Units that stand still together: {stable} of {all}; test of their congruence: p {p}.</source>
      <translation>Blocos imóveis em conjunto: {stable} de {all}; teste da sua congruência: p {p}.</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Their common motion against the control points: east {e}, north {n}, up {h} cm; p {p}.</source>
      <translation>O seu movimento comum face aos pontos de apoio: este {e}, norte {n}, cima {h} cm; p {p}.</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Point</source>
      <translation>Ponto</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>East (mm)</source>
      <translation>Este (mm)</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>North (mm)</source>
      <translation>Norte (mm)</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Height (mm)</source>
      <translation>Altitude (mm)</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Use</source>
      <translation>Uso</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>disturbed, left out</source>
      <translation>perturbado, omitido</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Residuals of the registration; w is the largest normalised residual of the three coordinates.</source>
      <translation>Resíduos do registo; w é o maior resíduo normalizado das três coordenadas.</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>There is no survey control: displacements are relative to the frame of the clouds.</source>
      <translation>Não há apoio topográfico: os deslocamentos referem-se ao referencial das nuvens.</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Damage</source>
      <translation>Danos</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>H = {height} m, Dn = {diameter} m. Lost and relocated units count as displaced by every threshold.</source>
      <translation>H = {height} m, Dn = {diameter} m. Blocos perdidos e arrastados contam como deslocados em todos os limiares.</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Displaced by at least</source>
      <translation>Deslocado pelo menos</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Threshold (m)</source>
      <translation>Limiar (m)</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Share</source>
      <translation>Parte</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>over {width} m: units displaced by one Dn or more, relocated or lost, per Dn of width (van der Meer, 1988).</source>
      <translation>em {width} m: blocos deslocados um Dn ou mais, arrastados ou perdidos, por Dn de largura (van der Meer, 1988).</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Sections along the axis</source>
      <translation>Secções ao longo do eixo</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Share of displaced units per section</source>
      <translation>Parte de blocos deslocados por secção</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Chainage (m)</source>
      <translation>Distância ao longo do eixo (m)</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>No unit has a displacement to show.</source>
      <translation>Nenhum bloco tem deslocamento para mostrar.</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Decisions and corrections</source>
      <translation>Decisões e correções</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Confirmed by</source>
      <translation>Confirmado por</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Comment</source>
      <translation>Comentário</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>inspect on site</source>
      <translation>inspecionar no local</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>No reviewer has decided on this epoch pair.</source>
      <translation>Nenhum revisor decidiu sobre este par de épocas.</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Correction</source>
      <translation>Correção</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>By</source>
      <translation>Por</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Map of displacements</source>
      <translation>Mapa de deslocamentos</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Displacement of the units' centres.</source>
      <translation>Deslocamento dos centros dos blocos.</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Histogram of displacements</source>
      <translation>Histograma de deslocamentos</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Displacements of all units with the thresholds of the next section.</source>
      <translation>Deslocamentos de todos os blocos com os limiares da secção seguinte.</translation>
    </message>
    <message>
      <location filename="../core/section_map.html" />
      <source>Map of the units by class</source>
      <translation>Mapa dos blocos por classe</translation>
    </message>
    <message>
      <location filename="../core/section_map.html" />
      <source>Units by class and control points; coordinates in {crs}.</source>
      <translation>Blocos por classe e pontos de apoio; coordenadas em {crs}.</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Method, settings and versions</source>
      <translation>Método, definições e versões</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Units are found in the point cloud as four cones with a common centre, adjusted to their points (Gauss-Helmert model), and brought into the frame of the survey control; displacements are differences of the feature points that follow from the adjusted model, tested against their covariance (after Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds).</source>
      <translation>Os blocos são encontrados na nuvem de pontos como quatro cones de centro comum, ajustados aos seus pontos (modelo de Gauss-Helmert) e levados ao referencial de apoio; os deslocamentos são diferenças dos pontos característicos do modelo ajustado, testadas face à sua covariância (segundo Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds).</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Time</source>
      <translation>Hora</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>σ0 of the registration</source>
      <translation>σ0 do registo</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Software</source>
      <translation>Programa</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Settings</source>
      <translation>Definições</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Written {moment} by {software}.</source>
      <translation>Escrito em {moment} por {software}.</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Quality of the units</source>
      <translation>Qualidade dos blocos</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Uncertain units</source>
      <translation>Blocos incertos</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Points to surface, median (mm)</source>
      <translation>Pontos à superfície, mediana (mm)</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Largest overlap</source>
      <translation>Maior sobreposição</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Pairs too close</source>
      <translation>Pares demasiado próximos</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Overlap is the share of a unit's volume inside another one; two solid units cannot overlap, nor can their centres come closer than half a height. A gap is a place where a unit is likely missing in the result; the layer gaps shows them.</source>
      <translation>A sobreposição é a parte do volume de um bloco dentro de outro; dois blocos sólidos não se podem sobrepor, nem os seus centros ficar a menos de meia altura. Uma lacuna é um lugar onde provavelmente falta um bloco no resultado; a camada gaps mostra-as.</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>The result was made by a version that did not state the quality of its units.</source>
      <translation>O resultado foi feito por uma versão que não indicava a qualidade dos seus blocos.</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Summary</source>
      <translation>Resumo</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units judged</source>
      <translation>Blocos avaliados</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Significant displacements</source>
      <translation>Deslocamentos significativos</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Lost</source>
      <translation>Perdidos</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Relocated</source>
      <translation>Arrastados</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>New</source>
      <translation>Novos</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Not seen in the later epoch</source>
      <translation>Não vistos na época posterior</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Displaced by 5 cm or more</source>
      <translation>Deslocados 5 cm ou mais</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Displaced by 10 cm or more</source>
      <translation>Deslocados 10 cm ou mais</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Decided by reviewers</source>
      <translation>Decididos por revisores</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Rejected by reviewers</source>
      <translation>Rejeitados por revisores</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units known to be missing</source>
      <translation>Blocos que se sabe faltarem</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Completeness</source>
      <translation>Completude</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units rejected by reviewers and left out of all figures, maps and tables below: {count}.</source>
      <translation>Blocos rejeitados por revisores e excluídos de todos os números, mapas e tabelas abaixo: {count}.</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units that no reviewer has decided on yet: {count}.</source>
      <translation>Blocos sobre os quais ainda nenhum revisor decidiu: {count}.</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>Units with the largest displacements</source>
      <translation>Blocos com maiores deslocamentos</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>East {e}, north {n}, up {h} cm; rotation {turn}; p {p}</source>
      <translation>Este {e}, norte {n}, cima {h} cm; rotação {turn}; p {p}</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>Plan and section of {unit}</source>
      <translation>Planta e secção de {unit}</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>Series of {unit}</source>
      <translation>Série de {unit}</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>No displacement is significant.</source>
      <translation>Nenhum deslocamento é significativo.</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>control used</source>
      <translation>apoio usado</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>control not used</source>
      <translation>apoio não usado</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>arrows: significant horizontal displacements, enlarged {scale} times</source>
      <translation>setas: deslocamentos horizontais significativos, ampliados {scale} vezes</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>3D displacement (cm)</source>
      <translation>Deslocamento 3D (cm)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>all units</source>
      <translation>todos os blocos</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>units</source>
      <translation>blocos</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>plan</source>
      <translation>planta</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>section {azimuth}°</source>
      <translation>secção {azimuth}°</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>chainage along the axis (m)</source>
      <translation>distância ao longo do eixo (m)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>units ≥ 10 cm (%)</source>
      <translation>blocos ≥ 10 cm (%)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>easting (m)</source>
      <translation>este (m)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>northing (m)</source>
      <translation>norte (m)</translation>
    </message>
  </context>
</TS>
