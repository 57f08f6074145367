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
      <location filename="../algorithms/comparedesign.py" />
      <source>Compare with design</source>
      <translation>Comparar com o projeto</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Compares the units of one epoch with a placement plan and with a design profile: deviation and turn of every unit, places without a unit, distance from the design surface, and whether that is within the tolerance.</source>
      <translation>Compara os blocos de uma época com um plano de colocação e com um perfil de projeto: desvio e rotação de cada bloco, lugares sem bloco, distância à superfície de projeto, e se isso está dentro da tolerância.</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>A unit stands at the place of its own name, or at the nearest free one within one height H. Within or outside is said where the standard deviations leave no doubt of 5 % or more, open where they do.</source>
      <translation>Um bloco está no lugar do seu próprio nome, ou no lugar livre mais próximo a menos de uma altura H. Diz-se dentro ou fora quando os desvios-padrão não deixam dúvida de 5 % ou mais; senão fica em aberto.</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>design,plan,placement,profile,tolerance,as-built,DXF</source>
      <translation>projeto,plano,colocação,perfil,tolerância,conforme construído,DXF</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>GeoPackage with the layers plan_deviations, plan_unmatched and profile_deviations, those that were asked for.</source>
      <translation>GeoPackage com as camadas plan_deviations, plan_unmatched e profile_deviations, as que foram pedidas.</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Deviations</source>
      <translation>Desvios</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Units outside the tolerance of the plan</source>
      <translation>Blocos fora da tolerância do plano</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Planned places without a unit</source>
      <translation>Lugares planeados sem bloco</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Units outside the tolerance of the profile</source>
      <translation>Blocos fora da tolerância do perfil</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Cross-sections and crest</source>
      <translation>Cortes e coroamento</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Cuts the structure across its axis: outlines of the blocks of every epoch, surface of the points and design in each section, height and width of the crest of each reach, and settlement along the structure.</source>
      <translation>Corta a estrutura transversalmente ao eixo: contornos dos blocos de cada época, superfície dos pontos e projeto em cada corte, cota e largura do coroamento de cada troço, e assentamento ao longo da estrutura.</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Points are those read around the units for the review (unit-points); without them sections show blocks alone.</source>
      <translation>Os pontos são os lidos à volta dos blocos para a revisão (unit-points); sem eles os cortes mostram só os blocos.</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>profile,section,crest,settlement,chainage</source>
      <translation>perfil,corte,coroamento,assentamento,distância</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>GeoPackage with the layers sections, crest and settlement.</source>
      <translation>GeoPackage com as camadas sections, crest e settlement.</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Sections</source>
      <translation>Cortes</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Label of an epoch; empty for both takes the latest pair.</source>
      <translation>Rótulo de uma época; ambos vazios tomam o par mais recente.</translation>
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
      <source>that of the result</source>
      <translation>a do resultado</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>stable units and control</source>
      <translation>blocos estáveis e apoio</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>control points alone</source>
      <translation>só pontos de apoio</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>What the displacements are stated against, in all of the report.</source>
      <translation>Aquilo em relação a que os deslocamentos são dados, em todo o relatório.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Places easting,northing along it, separated by blanks; damage is then stated by sections.</source>
      <translation>Pontos leste,norte ao longo dele, separados por espaços; os danos são então dados por trechos.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>0.09, 0.30 and 0.61 m (US Army Corps of Engineers)</source>
      <translation>0,09, 0,30 e 0,61 m (US Army Corps of Engineers)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>5 and 10 cm</source>
      <translation>5 e 10 cm</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>0.5 and 1 Dn (nominal diameter)</source>
      <translation>0,5 e 1 Dn (diâmetro nominal)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Limits by which the units are counted that moved.</source>
      <translation>Limites pelos quais se contam os blocos que se moveram.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>So many of those that moved most get views, series and decisions of their own.</source>
      <translation>Tantos dos que mais se moveram recebem vistas, séries e decisões próprias.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>HTML in one file, or PDF; the ending decides.</source>
      <translation>HTML num ficheiro, ou PDF; a extensão decide.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Earlier epoch</source>
      <translation>Época anterior</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Later epoch</source>
      <translation>Época posterior</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Reference of the displacements</source>
      <translation>Referência dos deslocamentos</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Axis of the structure</source>
      <translation>Eixo da estrutura</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length looked at (m)</source>
      <translation>Comprimento considerado (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of the structure in metres, for the damage number N_od.</source>
      <translation>Comprimento da estrutura em metros, para o número de dano N_od.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of a section (m)</source>
      <translation>Comprimento de um trecho (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of the sections along the axis, in metres.</source>
      <translation>Comprimento dos trechos ao longo do eixo, em metros.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Movement bands</source>
      <translation>Classes de movimento</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Units shown one by one</source>
      <translation>Blocos mostrados um a um</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Report</source>
      <translation>Relatório</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Give both epochs, or neither for the latest pair.</source>
      <translation>Indique as duas épocas, ou nenhuma para o par mais recente.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Export as-built model</source>
      <translation>Exportar modelo conforme construído</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Writes the units of one epoch as bodies at their fitted poses, coloured by class, with uncertainty and movement as properties, for CAD, BIM and 3D viewers. The ending of the file chooses the format: glTF (.glb), Wavefront (.obj), DXF, IFC4x3 or the poses alone (.json).</source>
      <translation>Escreve os blocos de uma época como corpos nas poses ajustadas, coloridos por classe, com incerteza e movimento como propriedades, para CAD, BIM e visualizadores 3D. A extensão do ficheiro escolhe o formato: glTF (.glb), Wavefront (.obj), DXF, IFC4x3 ou apenas as poses (.json).</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Bodies have 24 plane faces a leg. glTF, OBJ, IFC and JSON hold coordinates less a reduction point that stands in the file; DXF holds coordinates of the survey CRS and needs the library ezdxf in the engine.</source>
      <translation>Os corpos têm 24 faces planas por perna. glTF, OBJ, IFC e JSON contêm coordenadas menos um ponto de redução indicado no ficheiro; DXF contém coordenadas do SRC do levantamento e precisa da biblioteca ezdxf no motor.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>model,3D,glTF,GLB,OBJ,DXF,IFC,BIM,CAD,as-built</source>
      <translation>modelo,3D,glTF,GLB,OBJ,DXF,IFC,BIM,CAD,conforme construído</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Label of the epoch whose units are written; the latest one with units unless given.</source>
      <translation>Rótulo da época cujos blocos são escritos; por omissão, a última com blocos.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>File to write; its ending decides the format.</source>
      <translation>Ficheiro a escrever; a extensão decide o formato.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Model</source>
      <translation>Modelo</translation>
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
      <source>Points d1 to d4, which crews can measure and paint.</source>
      <translation>Pontos d1 a d4, que as equipas podem medir e pintar.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>From the centre to the end disc, in metres; empty takes 0.644 H.</source>
      <translation>Do centro ao disco terminal, em metros; vazio usa 0,644 H.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Fitted units</source>
      <translation>Blocos ajustados</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Centres of the end discs as well</source>
      <translation>Também os centros dos discos das extremidades</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Leg length (m)</source>
      <translation>Comprimento da perna (m)</translation>
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
      <source>Control points</source>
      <translation>Pontos de apoio</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Targets in the cloud</source>
      <translation>Alvos na nuvem</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Check points</source>
      <translation>Pontos de verificação</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Epochs</source>
      <translation>Épocas</translation>
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
      <source>Result</source>
      <translation>Resultado</translation>
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
      <source>{place}: {time} is no time; write it as 2025-03-14, 2025-03-14T02:30 (UTC) or 2025-03-14T11:30+09:00.</source>
      <translation>{place}: {time} não é uma data; escreva 2025-03-14, 2025-03-14T02:30 (UTC) ou 2025-03-14T11:30+09:00.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{where}: there is no file or layer {path}.</source>
      <translation>{where}: não existe o ficheiro ou camada {path}.</translation>
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
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Relief {epoch}</source>
      <translation>Relevo {epoch}</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>New survey from a folder</source>
      <translation>Novo levantamento a partir de uma pasta</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Writes a survey.toml from what the files in a folder say: epochs and times, CRS, control, targets and check points, and the size of the units from the cloud itself.</source>
      <translation>Escreve um survey.toml a partir do que dizem os ficheiros de uma pasta: épocas e horas, SRC, apoio, alvos e pontos de verificação, e o tamanho dos blocos a partir da própria nuvem.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Every value stands with its reason; what the files leave open is asked for in the log.</source>
      <translation>Cada valor traz a sua razão; o que os ficheiros deixam em aberto é perguntado no registo.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>new survey,folder,tiles,epochs,size of units,survey.toml</source>
      <translation>novo levantamento,pasta,blocos de pontos,épocas,tamanho dos blocos,survey.toml</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Folder with the tiles of all epochs; tables of control lie in it or beside it.</source>
      <translation>Pasta com os ficheiros de todas as épocas; as tabelas de apoio estão nela ou ao lado.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Point cloud tiles</source>
      <translation>Ficheiros de nuvem de pontos</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Instead of a folder: point cloud layers, or files, of all epochs.</source>
      <translation>Em vez de uma pasta: camadas de nuvens de pontos, ou ficheiros, de todas as épocas.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Projected CRS in metres; needed only where the tiles declare none.</source>
      <translation>SRC projetado em metros; só é preciso se os ficheiros não declararem nenhum.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Empty estimates it from the cloud.</source>
      <translation>Vazio: estima-se a partir da nuvem.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Text file to look through, correct and run.</source>
      <translation>Ficheiro de texto para rever, corrigir e executar.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Folder of tiles</source>
      <translation>Pasta de nuvens de pontos</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>CRS of the results</source>
      <translation>SRC dos resultados</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Height of the units (m)</source>
      <translation>Altura dos blocos (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Survey</source>
      <translation>Levantamento</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Give a folder of tiles, or tiles.</source>
      <translation>Indique uma pasta de blocos, ou blocos.</translation>
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
      <source>White noise is averaged over the points of a unit; whatever does not average out must be stated as systematic part. The shares of units found are those measured on simulated piles of that density and noise, seen from above.</source>
      <translation>O ruído branco é promediado pelos pontos de um bloco; o que não se promedeia tem de ser indicado como parte sistemática. As partes de blocos encontrados são as medidas em mantos simulados com essa densidade e esse ruído, vistos de cima.</translation>
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
      <source>What the survey detects over point density and visible share, beside the plan.</source>
      <translation>O que o levantamento deteta segundo a densidade de pontos e a parte visível, ao lado do plano.</translation>
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
      <source>Points per square of a unit's height</source>
      <translation>Pontos por quadrado da altura de um bloco</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 30 % or more</source>
      <translation>Parte encontrada dos blocos vistos em 30 % ou mais</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 15–30 %</source>
      <translation>Parte encontrada dos blocos vistos em 15–30 %</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 5–15 %</source>
      <translation>Parte encontrada dos blocos vistos em 5–15 %</translation>
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
      <location filename="../algorithms/planningdetectability.py" />
      <source>Chart</source>
      <translation>Gráfico</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Web page (*.html)</source>
      <translation>Página web (*.html)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>{file} cannot be written: {reason}.</source>
      <translation>{file} não pode ser escrito: {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/provider.py" />
      <source>Tetratrack: displacements of tetrapods</source>
      <translation>Tetratrack: deslocamentos de tetrápodes</translation>
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
      <location filename="../algorithms/residualpoints.py" />
      <source>Points less blocks</source>
      <translation>Pontos menos blocos</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Writes the points around the units of one epoch with their distance to the nearest fitted unit, coloured from blue (10 cm or more within a body) through white to red (10 cm or more outside): what is red is debris, a unit that was missed, or one that is broken.</source>
      <translation>Escreve os pontos à volta dos blocos de uma época com a distância ao bloco ajustado mais próximo, coloridos de azul (10 cm ou mais dentro de um corpo) a vermelho (10 cm ou mais fora), passando por branco: o que é vermelho são detritos, um bloco não encontrado ou um bloco partido.</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Points are those read around the units for the review (unit-points), in the control frame. For units lower than 2 m, and models of a tank, colours end at 5 % of the height H instead of 10 cm; points near no unit have the distance 10 m.</source>
      <translation>Os pontos são os lidos à volta dos blocos para a revisão (unit-points), no referencial de controlo. Para blocos com menos de 2 m e modelos de tanque, as cores terminam em 5 % da altura H em vez de 10 cm; os pontos longe de qualquer bloco têm a distância 10 m.</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>residuals,LAZ,LAS,point cloud,distance</source>
      <translation>resíduos,LAZ,LAS,nuvem de pontos,distância</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Point cloud with the dimensions distance (m) and unit.</source>
      <translation>Nuvem de pontos com as dimensões distance (m) e unit.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Label of the epoch whose units are looked at; the latest one with units unless given.</source>
      <translation>Nome da época cujos blocos são vistos; por omissão a última que os tem.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Degrees a unit may be turned from its planned orientation.</source>
      <translation>Graus que um bloco pode estar rodado em relação à orientação planeada.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>GeoPackage written by Monitor a survey.</source>
      <translation>GeoPackage escrito por Monitorizar um levantamento.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Path of a CSV unit_id,easting,northing,height with the planned centres, optionally qx,qy,qz,qw, or of a layer of points with heights (FILE|layername=NAME).</source>
      <translation>Caminho de um CSV unit_id,easting,northing,height com os centros planeados, opcionalmente qx,qy,qz,qw, ou de uma camada de pontos com cotas (FILE|layername=NAME).</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of places (m)</source>
      <translation>Tolerância dos lugares (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres a unit may be from its planned place.</source>
      <translation>Metros a que um bloco pode estar do lugar planeado.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of turns (°)</source>
      <translation>Tolerância das rotações (°)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Path of a DXF or of a layer of lines with heights: a single line is a cross-section along the whole structure, several are its edges.</source>
      <translation>Caminho de um DXF ou de uma camada de linhas com cotas: uma só linha é um corte ao longo de toda a estrutura, várias são as suas arestas.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres a unit may be off the design profile.</source>
      <translation>Metros a que um bloco pode estar do perfil de projeto.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Places easting,northing along it, separated by blanks; the centreline of the units unless given.</source>
      <translation>Lugares easting,northing ao longo do eixo, separados por espaços; por omissão a linha central dos blocos.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Distance of the sections (m)</source>
      <translation>Distância dos cortes (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres along the axis; four heights of a unit unless given.</source>
      <translation>Metros ao longo do eixo; por omissão quatro alturas de bloco.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Epoch</source>
      <translation>Época</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Placement plan</source>
      <translation>Plano de colocação</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Design profile</source>
      <translation>Perfil de projeto</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of the profile (m)</source>
      <translation>Tolerância do perfil (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>outermost point of a unit</source>
      <translation>ponto mais exterior de um bloco</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>centre of a unit</source>
      <translation>centro de um bloco</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>What is judged against the design profile; both distances are written.</source>
      <translation>O que é julgado face ao perfil de projeto; ambas as distâncias são escritas.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>All files (*.*)</source>
      <translation>Todos os ficheiros (*.*)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Judged against the profile</source>
      <translation>Julgado face ao perfil</translation>
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
      <source>A coast of this length, of stretches that hold the number of units each; empty gives one site.</source>
      <translation>Uma costa deste comprimento, feita de troços com esse número de unidades cada; vazio dá um só local.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Error of the trajectory along the site in metres, root mean square of each coordinate; empty for none.</source>
      <translation>Erro da trajetória ao longo do local, em metros, média quadrática por coordenada; vazio para nenhum.</translation>
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
      <source>Length of a coast (m)</source>
      <translation>Comprimento de uma costa (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Bend of every epoch (m)</source>
      <translation>Flexão de cada época (m)</translation>
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
      <location filename="../algorithms/support/engine.py" />
      <source>The tetratrack engine is not installed: open Settings &gt; Options &gt; Tetratrack and create its environment or choose one.</source>
      <translation>O motor tetratrack não está instalado: abra Configurações &gt; Opções &gt; Tetratrack e crie o seu ambiente ou escolha um.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>Create or choose the engine…</source>
      <translation>Criar ou escolher o motor…</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>Make the environment again…</source>
      <translation>Criar o ambiente de novo…</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>The engine ended unexpectedly (exit code {code}); QGIS and your data are unharmed.</source>
      <translation>O motor terminou inesperadamente (código {code}); o QGIS e os seus dados estão intactos.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>QGIS runs version {plugin} of the plugin, but its files are of version {engine}: restart QGIS.</source>
      <translation>O QGIS usa a versão {plugin} do módulo, mas os ficheiros são da versão {engine}: reinicie o QGIS.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>The engine could not be started with {python}: {reason}.</source>
      <translation>Não foi possível iniciar o motor com {python}: {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/environment.py" />
      <source>The tetratrack engine was made for another version of the plugin: let it be brought up to date in Settings &gt; Options.</source>
      <translation>O motor tetratrack foi criado para outra versão do módulo: atualize-o em Configurações &gt; Opções.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/environment.py" />
      <source>The Python that the tetratrack engine was made with is gone: let its environment be made again in Settings &gt; Options.</source>
      <translation>O Python com que o motor tetratrack foi criado já não existe: crie de novo o seu ambiente em Configurações &gt; Opções.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Unit</source>
      <translation>Bloco</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Point</source>
      <translation>Ponto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Unit in the plan</source>
      <translation>Bloco no plano</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Section</source>
      <translation>Secção</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Time</source>
      <translation>Hora</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Until</source>
      <translation>Até</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>From epoch</source>
      <translation>Da época</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>To epoch</source>
      <translation>Até à época</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>From</source>
      <translation>De</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>To</source>
      <translation>Até</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Feature point</source>
      <translation>Ponto característico</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Type of unit</source>
      <translation>Tipo de bloco</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Status</source>
      <translation>Estado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Class</source>
      <translation>Classe</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Kind</source>
      <translation>Tipo</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Grade</source>
      <translation>Grau</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Datum</source>
      <translation>Referência</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reference epoch</source>
      <translation>Época de referência</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>May be</source>
      <translation>Pode ser</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest units</source>
      <translation>Blocos mais próximos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Decision</source>
      <translation>Decisão</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Comment</source>
      <translation>Comentário</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reviewer</source>
      <translation>Revisor</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reviewed</source>
      <translation>Revisto em</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Confirmed by</source>
      <translation>Confirmado por</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Confirmed</source>
      <translation>Confirmado em</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Editor</source>
      <translation>Editor</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Edited</source>
      <translation>Editado em</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Taken back</source>
      <translation>Anulado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Picked by</source>
      <translation>Marcado por</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Picked</source>
      <translation>Marcado em</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reason</source>
      <translation>Motivo</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Known by</source>
      <translation>Conhecido por</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Software</source>
      <translation>Programa</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>File</source>
      <translation>Ficheiro</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>CRS</source>
      <translation>SRC</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Measured</source>
      <translation>Medido</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Verdict</source>
      <translation>Veredicto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Remark</source>
      <translation>Observação</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>LAS version</source>
      <translation>Versão LAS</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Point format</source>
      <translation>Formato de pontos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>COPC</source>
      <translation>COPC</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height H</source>
      <translation>Altura H</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Area</source>
      <translation>Área</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Radius</source>
      <translation>Raio</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Easting component</source>
      <translation>Componente este</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Northing component</source>
      <translation>Componente norte</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height component</source>
      <translation>Componente altura</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Horizontal displacement</source>
      <translation>Deslocamento horizontal</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement</source>
      <translation>Deslocamento</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Azimuth</source>
      <translation>Azimute</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. easting</source>
      <translation>Desvio padrão este</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. northing</source>
      <translation>Desvio padrão norte</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. height</source>
      <translation>Desvio padrão altura</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Rotation</source>
      <translation>Rotação</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. rotation</source>
      <translation>Desvio padrão rotação</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Detectable</source>
      <translation>Detetável</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement / H</source>
      <translation>Deslocamento / H</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement / Dn</source>
      <translation>Deslocamento / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Missing of a leg</source>
      <translation>Falta de uma perna</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Distance of the points</source>
      <translation>Distância dos pontos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest centre</source>
      <translation>Centro mais próximo</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along the structure</source>
      <translation>Ao longo da estrutura</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along, from</source>
      <translation>Ao longo, de</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along, to</source>
      <translation>Ao longo, até</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Correlation length</source>
      <translation>Comprimento de correlação</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Lowest height</source>
      <translation>Altura mínima</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Greatest height</source>
      <translation>Altura máxima</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev.</source>
      <translation>Desvio padrão</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. displacement</source>
      <translation>Desvio padrão do deslocamento</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest of the other side</source>
      <translation>Mais próximo do outro lado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height of the design</source>
      <translation>Cota do projeto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Centre off the design</source>
      <translation>Desvio do centro ao projeto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Outermost point off the design</source>
      <translation>Desvio do ponto extremo ao projeto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height of the crest</source>
      <translation>Cota do coroamento</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Highest top</source>
      <translation>Topo mais alto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Width of the crest</source>
      <translation>Largura do coroamento</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Change</source>
      <translation>Variação</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. change</source>
      <translation>Desvio padrão da variação</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>95 % band, from</source>
      <translation>Faixa de 95 %, de</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>95 % band, to</source>
      <translation>Faixa de 95 %, até</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>p-value</source>
      <translation>valor p</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>p-value, adjusted</source>
      <translation>valor p, ajustado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Significant</source>
      <translation>Significativo</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Sigma 0</source>
      <translation>Sigma 0</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Used</source>
      <translation>Usado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Points/m²</source>
      <translation>Pontos/m²</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Legs seen</source>
      <translation>Pernas vistas</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Probability of a broken leg</source>
      <translation>Probabilidade de perna partida</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Share seen</source>
      <translation>Parte vista</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Probability</source>
      <translation>Probabilidade</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Share supported</source>
      <translation>Parte apoiada</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Overlap</source>
      <translation>Sobreposição</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Observed</source>
      <translation>Observado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Normalised residual</source>
      <translation>Resíduo normalizado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Disturbed</source>
      <translation>Perturbado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Strip</source>
      <translation>Faixa</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Layer of the armour</source>
      <translation>Camada do manto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Packing</source>
      <translation>Compacidade</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Spacing / Dn</source>
      <translation>Espaçamento / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Turn against the neighbour</source>
      <translation>Rotação face ao vizinho</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Off the surface</source>
      <translation>Desvio da superfície</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Off the surface / Dn</source>
      <translation>Desvio da superfície / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Contacts</source>
      <translation>Contactos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Free gap</source>
      <translation>Folga</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>In a column</source>
      <translation>Em coluna</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}</source>
      <translation>Perna {number}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}: missing</source>
      <translation>Perna {number}: falta</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}: probability of a break</source>
      <translation>Perna {number}: probabilidade de rotura</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>LAS, LAZ, COPC, E57 or PLY files, a folder of them, a virtual point cloud (.vpc) or point cloud layers; coordinates in metres.</source>
      <translation>Ficheiros LAS, LAZ, COPC, E57 ou PLY, uma pasta, uma nuvem de pontos virtual (.vpc) ou camadas de nuvem de pontos; coordenadas em metros.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Projected CRS in metres; empty takes that of the tiles, and a local frame if they declare none.</source>
      <translation>SRC projetado em metros; vazio usa o dos blocos de dados, e um referencial local se não declararem nenhum.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Label of this survey in all results, for example its date.</source>
      <translation>Nome deste levantamento em todos os resultados, por exemplo a data.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Drives the temporal controller; empty takes the date of the first tile.</source>
      <translation>Comanda o controlador temporal; vazio usa a data do primeiro bloco de dados.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Estimates both from the best-seen units and holds them: moulds differ by centimetres from the standard proportions.</source>
      <translation>Estima ambos com os blocos mais bem vistos e fixa-os: os moldes diferem centímetros das proporções normalizadas.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Catalogue name with the mass in tonnes, such as tetrapod 8 t; or tetrapod with a height of your own.</source>
      <translation>Nome de catálogo com a massa em toneladas, como tetrapod 8 t; ou tetrapod com altura própria.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>From the plane under three legs to the top of the fourth, in metres; overrides the catalogue.</source>
      <translation>Do plano sob três pernas ao topo da quarta, em metros; prevalece sobre o catálogo.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Radius of a leg's cone at the unit's centre, in metres; empty takes 0.264 H.</source>
      <translation>Raio do cone de uma perna no centro do bloco, em metros; vazio usa 0,264 H.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Loss of radius per metre along the leg's axis; empty takes 0.176.</source>
      <translation>Perda de raio por metro ao longo do eixo da perna; vazio usa 0,176.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Built tetrapods are tetrahedral; 120° between leg 1 and the others repeats the published equations.</source>
      <translation>Os tetrápodes reais são tetraédricos; 120° entre a perna 1 e as outras repete as equações publicadas.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Polygon inside which units are looked for; its outer ring is used. Empty means everywhere.</source>
      <translation>Polígono onde se procuram blocos; usa-se o seu anel exterior. Vazio: em toda a parte.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Polygons around surfaces that do not move, such as the crown wall: they tie epochs without control to the earliest with control, or to the first.</source>
      <translation>Polígonos em torno de superfícies que não se movem, como o muro de coroamento: ligam as épocas sem controlo à primeira que o tem, ou à primeira de todas.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>the survey itself tells</source>
      <translation>o próprio levantamento diz</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>rigid</source>
      <translation>rígido</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>elastic</source>
      <translation>elástico</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Long flights bend by centimetres over tens to hundreds of metres. The survey itself tells by its units and targets whether an epoch's cloud is bent; rigid holds it stiff (short sites, one set-up), elastic lets it bend on any evidence.</source>
      <translation>Os voos longos dobram centímetros ao longo de dezenas a centenas de metros. O próprio levantamento diz, pelas suas unidades e alvos, se a nuvem de uma época está dobrada; rígido mantém-na direita (locais curtos, uma só estação), elástico deixa-a dobrar a qualquer indício.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Blocks of the survey worked on at the same time; each takes about 1 GB of memory.</source>
      <translation>Partes do levantamento processadas ao mesmo tempo; cada uma ocupa cerca de 1 GB de memória.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Surveyed targets: point layer or CSV with point_id, easting, northing, height, sd_e, sd_n, sd_h (m).</source>
      <translation>Alvos medidos: camada de pontos ou CSV com point_id, easting, northing, height, sd_e, sd_n, sd_h (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The same targets as measured in this epoch's cloud: point layer or CSV with point_id, x, y, z (m).</source>
      <translation>Os mesmos alvos medidos na nuvem desta época: camada de pontos ou CSV com point_id, x, y, z (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Surveyed joints of cones, for validation only: CSV or layer with point_id, unit_easting, unit_northing, unit_height and position (m).</source>
      <translation>Junções de cones medidas, só para validação: CSV ou camada com point_id, unit_easting, unit_northing, unit_height e posição (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Give the height H of the unit, or choose a catalogue name with its mass, such as tetrapod 8 t.</source>
      <translation>Indique a altura H do bloco, ou escolha um nome de catálogo com a massa, como tetrapod 8 t.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The type of unit must be tetrapod, or a catalogue name such as tetrapod 8 t.</source>
      <translation>O tipo de bloco tem de ser tetrapod, ou um nome de catálogo como tetrapod 8 t.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Control points and targets in the cloud belong together: give both, or neither.</source>
      <translation>Pontos de apoio e alvos na nuvem vão juntos: indique ambos ou nenhum.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Time of the survey (UTC)</source>
      <translation>Hora do levantamento (UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Epoch {label} (row {row})</source>
      <translation>Época {label} (linha {row})</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Calibrate radius and taper</source>
      <translation>Calibrar raio e conicidade</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Height H of the unit (m)</source>
      <translation>Altura H do bloco (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Cone radius at the centre (m)</source>
      <translation>Raio do cone no centro (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Taper of the leg</source>
      <translation>Conicidade da perna</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Angle between the legs</source>
      <translation>Ângulo entre as pernas</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Area of interest</source>
      <translation>Área de interesse</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Stable areas</source>
      <translation>Áreas estáveis</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Frames of the epochs</source>
      <translation>Referenciais das épocas</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Worker processes</source>
      <translation>Processos de trabalho</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The cone radius must be smaller than half the height of the unit.</source>
      <translation>O raio do cone tem de ser menor do que metade da altura do bloco.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The area of interest holds no polygon.</source>
      <translation>A área de interesse não contém nenhum polígono.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The area of interest has several separate parts; give one polygon.</source>
      <translation>A área de interesse tem várias partes separadas; indique um só polígono.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Virtual point clouds (*.vpc)</source>
      <translation>Nuvens de pontos virtuais (*.vpc)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Epoch in row {row}</source>
      <translation>Época da linha {row}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>tetrahedral (109.5°)</source>
      <translation>tetraédrico (109,5°)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>as in the paper (120°)</source>
      <translation>como no artigo (120°)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{crs} is geographic; choose a projected CRS in metres.</source>
      <translation>{crs} é geográfico; escolha um SRC projetado em metros.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{where}: no point cloud is given.</source>
      <translation>{where}: não foi indicada nenhuma nuvem de pontos.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The layers {one} and {other} have different CRS, and that of {one} is set by hand. Set the same one for both.</source>
      <translation>As camadas {one} e {other} têm SRC diferentes, e o de {one} foi definido à mão. Defina o mesmo para ambas.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} cannot be written: {reason}.</source>
      <translation>{layer} não pode ser escrito: {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} has no field {fields}; it has {present}.</source>
      <translation>{layer} não tem o campo {fields}; tem {present}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Point clouds ({endings})</source>
      <translation>Nuvens de pontos ({endings})</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{where}: the folder {path} holds no point cloud (LAS, LAZ, COPC, E57, PLY).</source>
      <translation>{where}: a pasta {path} não contém nuvens de pontos (LAS, LAZ, COPC, E57, PLY).</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} cannot be transformed to the CRS of the results: {reason}.</source>
      <translation>{layer} não pode ser transformado para o SRC dos resultados: {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>error as targets see it</source>
      <translation>erro visto pelos alvos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>difference of two epochs as units see it</source>
      <translation>diferença de duas épocas vista pelas peças</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>strip against its epoch</source>
      <translation>faixa em relação à sua época</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>moved as one</source>
      <translation>moveu-se em bloco</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>no common motion that could be told</source>
      <translation>sem movimento comum discernível</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>found</source>
      <translation>encontrado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>uncertain</source>
      <translation>incerto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>new</source>
      <translation>novo</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>relocated</source>
      <translation>arrastado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>stable</source>
      <translation>estável</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>moved</source>
      <translation>movido</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>rotated</source>
      <translation>rodado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>lost: the place is empty</source>
      <translation>perdido: o lugar está vazio</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>unseen: known from another epoch</source>
      <translation>não visto: conhecido de outra época</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>unexplained points where a unit fits</source>
      <translation>pontos inexplicados onde cabe um bloco</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>hole where a unit fits</source>
      <translation>buraco onde cabe um bloco</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>below the detection limit</source>
      <translation>abaixo do limite de deteção</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>significant</source>
      <translation>significativo</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>watch</source>
      <translation>vigiar</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>alert or more</source>
      <translation>alerta ou mais</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>relocated unit</source>
      <translation>bloco arrastado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>uncertain unit</source>
      <translation>bloco incerto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>missing end of a broken leg</source>
      <translation>ponta em falta de uma perna partida</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>observed</source>
      <translation>observado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>derived from the rest of the unit</source>
      <translation>deduzido do resto do bloco</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>used</source>
      <translation>usado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>disturbed, not used</source>
      <translation>perturbado, não usado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>not used</source>
      <translation>não usado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>check point</source>
      <translation>ponto de verificação</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>placeholder for a unit not found</source>
      <translation>marcador de um bloco não encontrado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>place of a correction</source>
      <translation>lugar de uma correção</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>picked by hand</source>
      <translation>marcado à mão</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Outlines of the units</source>
      <translation>Contornos dos blocos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Surfaces of the units (3D)</source>
      <translation>Superfícies dos blocos (3D)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Placement of the units</source>
      <translation>Colocação dos blocos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Gaps</source>
      <translation>Lacunas</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Feature points</source>
      <translation>Pontos característicos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Displacements</source>
      <translation>Deslocamentos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Displacements, other pairs and datum</source>
      <translation>Deslocamentos, outros pares e outro datum</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Errors of bent frames</source>
      <translation>Erros dos referenciais curvados</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Stretches that moved as one</source>
      <translation>Troços que se moveram em bloco</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Control residuals</source>
      <translation>Resíduos de apoio</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Check residuals</source>
      <translation>Resíduos de verificação</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Reviews</source>
      <translation>Revisões</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Corrections and placeholders</source>
      <translation>Correções e marcadores</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Points picked by hand</source>
      <translation>Pontos marcados à mão</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>watch: over {length}</source>
      <translation>vigiar: mais de {length}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>alert or more: over {length}</source>
      <translation>alerta ou mais: mais de {length}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>arrow of 10 mm: {length}, at most 30 mm long; ellipse: 95 %</source>
      <translation>seta de 10 mm: {length}, no máximo 30 mm; elipse: 95 %</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>Which displacement a planned survey detects</source>
      <translation>Que deslocamento um levantamento planeado deteta</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>A unit that moves by {length} in its worst direction is found with the chosen power; the mark in the chart.</source>
      <translation>Um bloco que se move {length} na pior direção é encontrado com a potência escolhida; a marca no gráfico.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>{share} % of a unit seen</source>
      <translation>{share} % de um bloco vistos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>Detectable displacement ({unit})</source>
      <translation>Deslocamento detetável ({unit})</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>The epochs and the unit given</source>
      <translation>As épocas e o bloco indicados</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>{table}, row {row}</source>
      <translation>{table}, linha {row}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>{table}, field names</source>
      <translation>{table}, nomes dos campos</translation>
    </message>
    <message>
      <location filename="../algorithms/survey_algorithm.py" />
      <source>The tiles declare no CRS: results are in a local frame. Choose the CRS of the results to change that.</source>
      <translation>Os ficheiros não declaram SRC: os resultados estão num referencial local. Escolha o SRC dos resultados para mudar isso.</translation>
    </message>
    <message>
      <location filename="../algorithms/survey_algorithm.py" />
      <source>Epoch {label}</source>
      <translation>Época {label}</translation>
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
      <location filename="../algorithms/trackdisplacements.py" />
      <source>no CRS</source>
      <translation>sem SRC</translation>
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
      <location filename="../plugin/engine_task.py" />
      <source>Cancelled.</source>
      <translation>Cancelado.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Creating the tetratrack engine</source>
      <translation>A criar o motor tetratrack</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Another window of QGIS is creating the engine at this moment.</source>
      <translation>Outra janela do QGIS está a criar o motor neste momento.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Making an empty environment</source>
      <translation>A criar um ambiente vazio</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Trying the libraries</source>
      <translation>A experimentar as bibliotecas</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine's environment could not be created: {reason} (everything that was said: {log})</source>
      <translation>O ambiente do motor não pôde ser criado: {reason} (toda a saída: {log})</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Compiling, so that the first run need not wait</source>
      <translation>A compilar, para que a primeira execução não espere</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Looking for the libraries</source>
      <translation>À procura das bibliotecas</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Fetching {name}: {done} of about {all} MB</source>
      <translation>A obter {name}: {done} de cerca de {all} MB</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Unpacking libraries: {count} of {all}</source>
      <translation>A descompactar bibliotecas: {count} de {all}</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine needs {needed} GB on the disk of {folder}, and {free} GB are free.</source>
      <translation>O motor precisa de {needed} GB no disco de {folder}, e {free} GB estão livres.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>{wheels} holds no wheels.</source>
      <translation>{wheels} não contém nenhum wheel.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>{wheels} lacks {count} of the wheels that this version of the plugin needs: {names}.</source>
      <translation>Faltam em {wheels} {count} dos wheels de que esta versão do módulo precisa: {names}.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine in use cannot be replaced now: wait until its runs have ended.</source>
      <translation>O motor em uso não pode ser substituído agora: espere que as suas execuções terminem.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Unpacking {file}</source>
      <translation>A descompactar {file}</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Choose a file…</source>
      <translation>Escolher um ficheiro…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Add an epoch</source>
      <translation>Adicionar uma época</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Remove the selected epochs</source>
      <translation>Remover as épocas selecionadas</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>user-defined</source>
      <translation>personalizado</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Choose…</source>
      <translation>Escolher…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Table of points</source>
      <translation>Tabela de pontos</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Tables (*.csv *.txt *.gpkg);;All files (*)</source>
      <translation>Tabelas (*.csv *.txt *.gpkg);;Todos os ficheiros (*)</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Files…</source>
      <translation>Ficheiros…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Folder…</source>
      <translation>Pasta…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Layer {name}</source>
      <translation>Camada {name}</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_wrapper.py" />
      <source>{count} epochs…</source>
      <translation>{count} épocas…</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Arrows move, + and - zoom, Home resets; Enter picks the point in the middle</source>
      <translation>As setas movem, + e - ampliam, Home repõe; Enter escolhe o ponto do meio</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Plan of the unit</source>
      <translation>Planta da unidade</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Section of the unit</source>
      <translation>Corte da unidade</translation>
    </message>
    <message>
      <location filename="../plugin/length_widget.py" />
      <source>Length in the project's unit</source>
      <translation>Comprimento na unidade do projeto</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python 3.11 to 3.13 was not found: install it, or choose an interpreter of the engine above.</source>
      <translation>O Python 3.11 a 3.13 não foi encontrado: instale-o ou escolha acima um interpretador do motor.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create a Python environment in {folder} and download libraries into it? It takes about {size} of disk.</source>
      <translation>Criar um ambiente Python em {folder} e descarregar bibliotecas para lá? Ocupa cerca de {size} de disco.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create a Python environment in {folder} from the wheels in {wheels}? It takes about {size} of disk.</source>
      <translation>Criar um ambiente Python em {folder} a partir dos wheels em {wheels}? Ocupa cerca de {size} de disco.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Try again…</source>
      <translation>Tentar de novo…</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python interpreter of the engine</source>
      <translation>Interpretador Python do motor</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Empty uses the environment that the plugin creates; a folder of an environment will do.</source>
      <translation>Vazio usa o ambiente que o módulo cria; a pasta de um ambiente serve.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Folder or ZIP of wheels</source>
      <translation>Pasta ou ZIP de wheels</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>For computers without a network: what was fetched on another one. Empty fetches the libraries.</source>
      <translation>Para computadores sem rede: o que foi obtido noutro. Vazio obtém as bibliotecas.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create the engine's environment…</source>
      <translation>Criar o ambiente do motor…</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Cancel</source>
      <translation>Cancelar</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Show the log</source>
      <translation>Mostrar o registo</translation>
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
      <source>{python} is no file.</source>
      <translation>{python} não é um ficheiro.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} is no Python interpreter.</source>
      <translation>{python} não é um interpretador de Python.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} is Python {version}; the engine needs 3.11 or later.</source>
      <translation>{python} é Python {version}; o motor precisa de 3.11 ou posterior.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} lacks the engine's libraries: {modules}.</source>
      <translation>Faltam a {python} as bibliotecas do motor: {modules}.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Used: {python}</source>
      <translation>Em uso: {python}</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Can be used: {python}</source>
      <translation>Pode ser usado: {python}</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the disk is full</source>
      <translation>o disco está cheio</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>this Python cannot make environments; on Debian and Ubuntu install python3-venv first</source>
      <translation>este Python não consegue criar ambientes; em Debian e Ubuntu instale primeiro python3-venv</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy wants a user name and password: state them in Settings &gt; Options &gt; Network</source>
      <translation>o proxy pede utilizador e senha: indique-os em Configurações &gt; Opções &gt; Rede</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy is of the kind SOCKS, which the installer does not know; choose a folder of wheels</source>
      <translation>o proxy é do tipo SOCKS, que o instalador não conhece; escolha uma pasta de wheels</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the registry's certificate is not trusted: import your network's authority in Settings &gt; Options &gt; Authentication</source>
      <translation>o certificado do repositório não é de confiança: importe a autoridade da sua rede em Configurações &gt; Opções &gt; Autenticação</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy cannot be reached: see Settings &gt; Options &gt; Network</source>
      <translation>o proxy não pode ser alcançado: veja Configurações &gt; Opções &gt; Rede</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>a file is not the one that this version of the plugin needs: it was damaged or changed on its way; try again</source>
      <translation>um ficheiro não é o de que esta versão do módulo precisa: foi danificado ou alterado no caminho; tente de novo</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the connection broke while a file was fetched; try again, what is complete is not fetched twice</source>
      <translation>a ligação caiu enquanto um ficheiro era obtido; tente de novo, o que está completo não é obtido duas vezes</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>no package registry can be reached from this computer; without a network choose a folder of wheels</source>
      <translation>nenhum repositório de pacotes pode ser alcançado deste computador; sem rede escolha uma pasta de wheels</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>a library of the system is missing; on Debian and Ubuntu install libegl1 libgl1 libgomp1</source>
      <translation>falta uma biblioteca do sistema; em Debian e Ubuntu instale libegl1 libgl1 libgomp1</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>Displacements of armour units</source>
      <translation>Deslocamentos dos blocos do manto</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>Legend</source>
      <translation>Legenda</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>{pair}, datum: {datum}</source>
      <translation>{pair}, referência: {datum}</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Ended: nothing was stored.</source>
      <translation>Terminado: nada foi guardado.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints</source>
      <translation>Fixar por três junções</translation>
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
      <source>Take back your last correction</source>
      <translation>Desfazer a sua última correção</translation>
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
      <source>Nothing was stored: pick the three joints again.</source>
      <translation>Nada foi guardado: marque de novo as três junções.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>pinned by three joints</source>
      <translation>fixado por três junções</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The three points do not fit the shape of {unit}: they are {misfit} off, where {worst} would be usual. Were they joints of this unit? Store the pose all the same?</source>
      <translation>Os três pontos não condizem com a forma de {unit}: desvio de {misfit}, quando {worst} seria o habitual. Eram junções deste bloco? Guardar a pose mesmo assim?</translation>
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
      <source>There is no correction of yours to take back.</source>
      <translation>Não há correção sua para desfazer.</translation>
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
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n significant</source>
      <translation>
        <numerusform>%n significativo</numerusform>
        <numerusform>%n significativos</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n decided</source>
      <translation>
        <numerusform>%n decidido</numerusform>
        <numerusform>%n decididos</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n rejected, excluded from statistics and map</source>
      <translation>
        <numerusform>%n rejeitado, fora das estatísticas e do mapa</numerusform>
        <numerusform>%n rejeitados, fora das estatísticas e do mapa</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Leg</source>
      <translation>Perna</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Its end</source>
      <translation>A ponta</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Probability of a break</source>
      <translation>Probabilidade de rotura</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Points to</source>
      <translation>Aponta para</translation>
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
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n lost</source>
      <translation>
        <numerusform>%n perdido</numerusform>
        <numerusform>%n perdidos</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n new</source>
      <translation>
        <numerusform>%n novo</numerusform>
        <numerusform>%n novos</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n with a broken leg</source>
      <translation>
        <numerusform>%n com uma perna partida</numerusform>
        <numerusform>%n com uma perna partida</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>3D displacement</source>
      <translation>Deslocamento 3D</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>in heights H, in nominal diameters Dn</source>
      <translation>em alturas H, em diâmetros nominais Dn</translation>
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
      <translation>Altura</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Horizontal</source>
      <translation>Horizontal</translation>
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
      <source>{length}, towards {azimuth}° from grid north</source>
      <translation>{length}, para {azimuth}° a partir do norte da quadrícula</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Score of the fit, 0 to 1</source>
      <translation>Pontuação do ajuste, 0 a 1</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Legs seen, of four</source>
      <translation>Pernas vistas, de quatro</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Broken legs</source>
      <translation>Pernas partidas</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Ends not seen, of legs</source>
      <translation>Pontas não vistas, das pernas</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n of {all} units shown</source>
      <translation>
        <numerusform>%n de {all} blocos mostrado</numerusform>
        <numerusform>%n de {all} blocos mostrados</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>none: one of the two positions is not known</source>
      <translation>nenhum: uma das duas posições é desconhecida</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Test against no motion</source>
      <translation>Teste contra imobilidade</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Missing ({unit})</source>
      <translation>Em falta ({unit})</translation>
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
      <source>largest {length}</source>
      <translation>máximo {length}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Seen in {epoch}</source>
      <translation>Visto em {epoch}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Legs</source>
      <translation>Pernas</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Points to: degrees from grid north, and above the horizon</source>
      <translation>Aponta para: graus a partir do norte da quadrícula, e acima do horizonte</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>± one standard deviation</source>
      <translation>± um desvio-padrão</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Picked by hand</source>
      <translation>Marcado à mão</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>taken back by {who}</source>
      <translation>desfeito por {who}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{feature}, {epoch}: picked {length} from the fit ({who})</source>
      <translation>{feature}, {epoch}: marcado a {length} do ajustamento ({who})</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_dock.py" />
      <source>%n units</source>
      <translation>
        <numerusform>%n bloco</numerusform>
        <numerusform>%n blocos</numerusform>
      </translation>
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
      <source>A click on the map picks the unit or arrow there</source>
      <translation>Um clique no mapa escolhe o bloco ou a seta nesse lugar</translation>
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
      <source>Report with more choices…</source>
      <translation>Relatório com mais opções…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>A page to print, with the map as it stands</source>
      <translation>Uma página para imprimir, com o mapa como está</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Export the alarm list…</source>
      <translation>Exportar a lista de alarmes…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Web page (*.html);;PDF (*.pdf)</source>
      <translation>Página web (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Alarm list</source>
      <translation>Lista de alarmes</translation>
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
      <source>Corrections of another reviewer were taken in.</source>
      <translation>As correções de outro revisor foram incorporadas.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>A run replaced the result: its numbers are shown now.</source>
      <translation>Um cálculo substituiu o resultado: os seus valores são agora mostrados.</translation>
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
      <source>Enter your name or initials first: they stand beside every decision.</source>
      <translation>Introduza primeiro o seu nome ou iniciais: ficam ao lado de cada decisão.</translation>
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
      <source>Threshold ({unit})</source>
      <translation>Limiar ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{name} was closed with its layers. Every decision is stored: open it again to go on.</source>
      <translation>{name} foi fechado com as suas camadas. Todas as decisões estão guardadas: abra-o de novo para continuar.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Make a polygon layer active first.</source>
      <translation>Ative primeiro uma camada de polígonos.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The active layer holds no polygon.</source>
      <translation>A camada ativa não contém nenhum polígono.</translation>
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
      <source>The page {name} is in the project's layouts.</source>
      <translation>A página {name} está nas composições do projeto.</translation>
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
    <message numerus="yes">
      <location filename="../plugin/review_dock.py" />
      <source>Units written to {name}: %n.</source>
      <translation>
        <numerusform>%n bloco escrito em {name}.</numerusform>
        <numerusform>%n blocos escritos em {name}.</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Open 3D view</source>
      <translation>Abrir vista 3D</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Model, sections and design</source>
      <translation>Modelo, cortes e projeto</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Export as-built model…</source>
      <translation>Exportar modelo conforme construído…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Compare with design…</source>
      <translation>Comparar com o projeto…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Cross-sections and crest…</source>
      <translation>Cortes e coroamento…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Points less blocks…</source>
      <translation>Pontos menos blocos…</translation>
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
      <source>Placeholders and corrections</source>
      <translation>Marcadores e correções</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacement review: {name}</source>
      <translation>Revisão de deslocamentos: {name}</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements: {datum}</source>
      <translation>Deslocamentos: {datum}</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Epochs compared</source>
      <translation>Épocas comparadas</translation>
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
      <source>On the map too</source>
      <translation>No mapa também</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The map shows only the units that the list shows</source>
      <translation>O mapa mostra só os blocos que a lista mostra</translation>
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
      <location filename="../plugin/review_panels.py" />
      <source>Open</source>
      <translation>Abrir</translation>
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
      <source>Section {azimuth}°</source>
      <translation>Secção {azimuth}°</translation>
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
      <source>Read the points…</source>
      <translation>Ler os pontos…</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Reads the points around the units from the tiles of the survey, for the views and for picking</source>
      <translation>Lê dos blocos de dados do levantamento os pontos em torno das unidades, para as vistas e a marcação</translation>
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
      <source>points picked</source>
      <translation>pontos marcados</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>placeholder</source>
      <translation>marcador</translation>
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
      <source>Seen</source>
      <translation>Visto</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Broken</source>
      <translation>Partidas</translation>
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
      <source>Numbers of the legs that are broken; the page Numbers says how sure that is, and which ends are not seen</source>
      <translation>Números das pernas partidas; a página Números diz com que certeza, e que pontas não se veem</translation>
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
      <source>whole</source>
      <translation>inteira</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>broken</source>
      <translation>partida</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>not seen</source>
      <translation>não se vê</translation>
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
      <source>changed the numbers, which ended</source>
      <translation>alterou os números, o que pôs fim a</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>brought back the numbers of</source>
      <translation>repôs os números de</translation>
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
      <location filename="../plugin/series_view.py" />
      <source>3D displacement since {epoch} ({unit}), bands of 95 %</source>
      <translation>Deslocamento 3D desde {epoch} ({unit}), bandas de 95 %</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>No displacement of this unit</source>
      <translation>Sem deslocamento deste bloco</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>centre</source>
      <translation>centro</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>detection limit</source>
      <translation>limite de deteção</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Open result…</source>
      <translation>Abrir resultado…</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Take the point cloud layers</source>
      <translation>Usar as camadas de nuvens de pontos</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>The files of the project's point cloud layers, in place of a folder</source>
      <translation>Os ficheiros das camadas de nuvens de pontos do projeto, em vez de uma pasta</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>estimated from the cloud</source>
      <translation>estimada a partir da nuvem</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>as the tiles declare</source>
      <translation>como os blocos declaram</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Run</source>
      <translation>Executar</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Open the result.gpkg of a survey with two epochs or more to review its displacements.</source>
      <translation>Abra o result.gpkg de um levantamento com duas épocas ou mais para rever os deslocamentos.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Or make one: choose the folder that holds the tiles of all epochs, look through the table, press Run.</source>
      <translation>Ou faça um: escolha a pasta com os blocos de todas as épocas, veja a tabela, prima Executar.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Height H of the unit</source>
      <translation>Altura H do bloco</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Looking at the tiles</source>
      <translation>A examinar os blocos</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Writing the survey</source>
      <translation>A escrever o levantamento</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>The project has no point cloud layer that lies in a file: choose a folder instead.</source>
      <translation>O projeto não tem camada de nuvem de pontos num ficheiro: escolha antes uma pasta.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Choose where the result is to be written.</source>
      <translation>Escolha onde escrever o resultado.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Answer first what is asked above.</source>
      <translation>Responda primeiro ao que é perguntado acima.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Units of {heights} m height.</source>
      <translation>Blocos de {heights} m de altura.</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Monitor a survey…</source>
      <translation>Monitorizar um levantamento…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Try the sample…</source>
      <translation>Experimentar o exemplo…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Engine…</source>
      <translation>Motor…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>An engine is needed before anything can be computed.</source>
      <translation>É preciso um motor antes de qualquer cálculo.</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>The sample cannot be copied to {folder}: {reason}.</source>
      <translation>O exemplo não pode ser copiado para {folder}: {reason}.</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>Tetrapods in 3D</source>
      <translation>Tetrápodes em 3D</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>Displacements in 3D</source>
      <translation>Deslocamentos em 3D</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>significant displacement, enlarged {scale} times</source>
      <translation>deslocamento significativo, ampliado {scale} vezes</translation>
    </message>
    <message>
      <location filename="../core/report/templates/report.html" />
      <source>a local frame</source>
      <translation>um referencial local</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>Blocks</source>
      <translation>Blocos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>View of the blocks by class</source>
      <translation>Vista dos blocos por classe</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>Fitted units of {epoch} by class, seen from the low side.</source>
      <translation>Blocos ajustados de {epoch} por classe, vistos do lado baixo.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Castings</source>
      <translation>Blocos moldados</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Mould {name} of an earlier survey, of {units} units, is held.</source>
      <translation>O molde {name} de um levantamento anterior, de {units} blocos, é mantido.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>The mould was learned from {units} units of this survey.</source>
      <translation>O molde foi determinado a partir de {units} blocos deste levantamento.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>H = {height} m: radius {radius} m, taper {taper}. Size of single castings ± {size}, radius of single legs ± {leg} mm (one standard deviation).</source>
      <translation>H = {height} m: raio {radius} m, conicidade {taper}. Tamanho dos blocos ± {size}, raio das pernas ± {leg} mm (um desvio padrão).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Departure of the mould from its cones: along a leg, and unrolled around it. What is alike on all units is held; how single castings differ widens the standard deviations where two epochs see other surfaces.</source>
      <translation>Desvio do molde em relação aos cones: ao longo de uma perna e desenrolado à volta dela. O que é comum a todos os blocos é mantido; o que os distingue alarga os desvios padrão onde duas épocas veem outras superfícies.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Too few units show enough of themselves for a mould: cones are held, and castings vary as the literature says.</source>
      <translation>Há poucos blocos suficientemente visíveis para um molde: os cones são mantidos e os blocos variam como diz a literatura.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs seen whole: {whole}, broken: {broken}; the ends of {unseen} are not seen, and nothing is said of them.</source>
      <translation>Pernas vistas inteiras: {whole}, partidas: {broken}; a ponta de {unseen} não se vê, e nada se diz delas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Broken leg</source>
      <translation>Perna partida</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Missing (m)</source>
      <translation>Em falta (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Break: easting (m)</source>
      <translation>Rotura: este (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Northing (m)</source>
      <translation>Norte (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Height (m)</source>
      <translation>Altitude (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs whose ends are not seen</source>
      <translation>Pernas cuja ponta não se vê</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Whither a leg points: degrees from grid north clockwise, and above the horizon. The place is that of the face of fracture, or of the leg's whole end where the result does not say how much of it is missing.</source>
      <translation>Para onde aponta uma perna: graus a partir do norte da quadrícula no sentido dos ponteiros do relógio, e acima do horizonte. A posição é a da face da rotura, ou a da ponta da perna inteira quando o resultado não diz quanto falta.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs by section along the axis</source>
      <translation>Pernas por secção ao longo do eixo</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Chainage (m)</source>
      <translation>Distância ao longo do eixo (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Units with a broken leg</source>
      <translation>Blocos com uma perna partida</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs seen whole</source>
      <translation>Pernas vistas inteiras</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Ends not seen</source>
      <translation>Pontas não vistas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>The result was made by a version that said nothing of legs.</source>
      <translation>O resultado foi feito por uma versão que nada dizia das pernas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Comparison with surveyed check points</source>
      <translation>Comparação com os pontos de verificação medidos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Picked by hand (cm)</source>
      <translation>Marcado à mão (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Fitting (cm)</source>
      <translation>Ajustamento (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Surveyed (cm)</source>
      <translation>Medido (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Error, picked (cm)</source>
      <translation>Erro, marcado (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Error, fitting (cm)</source>
      <translation>Erro, ajustamento (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>3D displacements of the same feature point, in the control frame (after Chan and Lichti, Table 1).</source>
      <translation>Deslocamentos 3D do mesmo ponto característico, no referencial de apoio (segundo Chan and Lichti, tabela 1).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>The survey has no check points that both epochs share.</source>
      <translation>O levantamento não tem pontos de verificação comuns às duas épocas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Survey control</source>
      <translation>Apoio topográfico</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Congruence of the stable units</source>
      <translation>Congruência dos blocos estáveis</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Units that stand still together: {stable} of {all}; test of their congruence: p {p}.</source>
      <translation>Blocos imóveis em conjunto: {stable} de {all}; teste da sua congruência: p {p}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Their common motion against the control points: east {e}, north {n}, up {h} cm; p {p}.</source>
      <translation>O seu movimento comum face aos pontos de apoio: este {e}, norte {n}, cima {h} cm; p {p}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>East (mm)</source>
      <translation>Este (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>North (mm)</source>
      <translation>Norte (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Height (mm)</source>
      <translation>Altitude (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Use</source>
      <translation>Uso</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>disturbed, left out</source>
      <translation>perturbado, omitido</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Residuals of the registration; w is the largest normalised residual of the three coordinates.</source>
      <translation>Resíduos do registo; w é o maior resíduo normalizado das três coordenadas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>There is no survey control: displacements are relative to the frame of the clouds.</source>
      <translation>Não há apoio topográfico: os deslocamentos referem-se ao referencial das nuvens.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Damage</source>
      <translation>Danos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>H = {height} m, Dn = {diameter} m. Lost and relocated units count as displaced by every threshold.</source>
      <translation>H = {height} m, Dn = {diameter} m. Blocos perdidos e arrastados contam como deslocados em todos os limiares.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Displaced by at least</source>
      <translation>Deslocado pelo menos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Threshold (m)</source>
      <translation>Limiar (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Share</source>
      <translation>Parte</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>State of the armour in the words of Campos et al. (2020):</source>
      <translation>Estado do manto nos termos de Campos et al. (2020):</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>No damage: no unit moved by one Dn or is lost. Initiation of damage: some did. Iribarren's damage: neighbours of the outer layer did. Initiation of destruction: a unit of the layer below did. Destruction cannot be told from units.</source>
      <translation>Sem dano: nenhum bloco se moveu um Dn ou se perdeu. Início de dano: alguns. Dano de Iribarren: vizinhos da camada exterior. Início de destruição: um bloco da camada inferior. A destruição não se vê pelos blocos.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>over {width} m: units displaced by one Dn or more, relocated or lost, per Dn of width (van der Meer, 1988).</source>
      <translation>em {width} m: blocos deslocados um Dn ou mais, arrastados ou perdidos, por Dn de largura (van der Meer, 1988).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Sections along the axis</source>
      <translation>Secções ao longo do eixo</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Share of displaced units per section</source>
      <translation>Parte de blocos deslocados por secção</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>No unit has a displacement to show.</source>
      <translation>Nenhum bloco tem deslocamento para mostrar.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>Decisions and corrections</source>
      <translation>Decisões e correções</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>inspect on site</source>
      <translation>inspecionar no local</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>No reviewer has decided on this epoch pair.</source>
      <translation>Nenhum revisor decidiu sobre este par de épocas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>Correction</source>
      <translation>Correção</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>By</source>
      <translation>Por</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>As-built against design</source>
      <translation>Construído face ao projeto</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Map of the units against the design</source>
      <translation>Mapa dos blocos face ao projeto</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units of {epoch} against the design; coordinates in {crs}.</source>
      <translation>Blocos de {epoch} face ao projeto; coordenadas em {crs}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units at a planned place</source>
      <translation>Blocos num lugar planeado</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Within the tolerance</source>
      <translation>Dentro da tolerância</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Outside the tolerance</source>
      <translation>Fora da tolerância</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Cannot be told</source>
      <translation>Não se pode dizer</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Deviation, median and largest (cm)</source>
      <translation>Desvio, mediana e máximo (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Planned</source>
      <translation>Planeado</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>East (cm)</source>
      <translation>Este (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>North (cm)</source>
      <translation>Norte (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Up (cm)</source>
      <translation>Acima (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Deviation (cm)</source>
      <translation>Desvio (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Rotation (°)</source>
      <translation>Rotação (°)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>The {count} units farthest from their place; all stand in the file of tetratrack design.</source>
      <translation>Os {count} blocos mais afastados do seu lugar; todos estão no ficheiro de tetratrack design.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units under the profile's lines</source>
      <translation>Blocos sob as linhas do perfil</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Centre off the design, mean and RMS (m)</source>
      <translation>Centro face ao projeto, média e RMS (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Outermost point, mean and RMS (m)</source>
      <translation>Ponto extremo, média e RMS (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>A unit is within or outside the tolerance where its standard deviation leaves no doubt of 5 % or more.</source>
      <translation>Um bloco está dentro ou fora da tolerância quando o seu desvio-padrão não deixa dúvida de 5 % ou mais.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Map of displacements</source>
      <translation>Mapa de deslocamentos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Displacement of the units' centres.</source>
      <translation>Deslocamento dos centros dos blocos.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Histogram of displacements</source>
      <translation>Histograma de deslocamentos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Displacements of all units with the thresholds of the next section.</source>
      <translation>Deslocamentos de todos os blocos com os limiares da secção seguinte.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Units, one by one</source>
      <translation>Blocos, um a um</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Zoom in</source>
      <translation>Ampliar</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Zoom out</source>
      <translation>Reduzir</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Whole map</source>
      <translation>Mapa inteiro</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Arrows</source>
      <translation>Setas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Map of the units by class</source>
      <translation>Mapa dos blocos por classe</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Search</source>
      <translation>Procurar</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>all</source>
      <translation>todas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Displacement from (cm)</source>
      <translation>Deslocamento a partir de (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>significant only</source>
      <translation>só significativos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Displacement (cm)</source>
      <translation>Deslocamento (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Blocks of both epochs</source>
      <translation>Blocos das duas épocas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>transparent</source>
      <translation>transparente</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Whole scene</source>
      <translation>Cena inteira</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Drag turns, shift and drag moves, the wheel or two fingers zoom.</source>
      <translation>Arrastar roda, Shift e arrastar move, a roda ou dois dedos ampliam.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>This browser shows no 3D (WebGL): the picture of the blocks below stands for it.</source>
      <translation>Este navegador não mostra 3D (WebGL): a imagem dos blocos abaixo substitui-a.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>East</source>
      <translation>Este</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>North</source>
      <translation>Norte</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Up</source>
      <translation>Acima</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>{shown} of {all} units</source>
      <translation>{shown} de {all} blocos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>enlarged {times} times</source>
      <translation>ampliadas {times} vezes</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>dashed: cut short</source>
      <translation>a tracejado: encurtadas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Control point</source>
      <translation>Ponto de controlo</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Control point, not used</source>
      <translation>Ponto de controlo, não usado</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Frames and common motion</source>
      <translation>Referenciais e movimento comum</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The clouds of these epochs are bent. What targets say of the bend is removed from positions and from displacements in datum control; what resting units say besides, from displacements in datum stable.</source>
      <translation>As nuvens destas épocas estão curvadas. O que os alvos dizem da curvatura é retirado das posições e dos deslocamentos na referência control; o que dizem além disso as peças em repouso, dos deslocamentos na referência stable.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Bend, mean (mm)</source>
      <translation>Curvatura, média (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Bend, largest (mm)</source>
      <translation>Curvatura, máxima (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Left unknown, mean (mm)</source>
      <translation>Fica por conhecer, média (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Correlation length (m)</source>
      <translation>Comprimento de correlação (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Targets used</source>
      <translation>Alvos usados</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Error of the clouds along the structure with its 95 % band.</source>
      <translation>Erro das nuvens ao longo da estrutura com a sua faixa de 95 %.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>No bend of the clouds could be told from the noise of units and targets: frames are held stiff.</source>
      <translation>Nenhuma curvatura das nuvens se distingue do ruído das peças e dos alvos: os referenciais mantêm-se rígidos.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Flight strips or stations drift against each other along the structure; this is removed.</source>
      <translation>As faixas de voo ou as estações derivam entre si ao longo da estrutura; essa deriva é retirada.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The cloud of {epoch} was aligned by its units alone: a motion of the whole structure cannot be seen.</source>
      <translation>A nuvem de {epoch} foi alinhada apenas pelas suas peças: um movimento de toda a estrutura não se pode ver.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Common motion of stretches</source>
      <translation>Movimento comum dos troços</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Both epochs show too few units to tell a common motion of stretches.</source>
      <translation>Ambas as épocas mostram poucos blocos para discernir um movimento comum de troços.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Mean displacement of the units of each stretch against the targets; the band holds what is not known of the frames.</source>
      <translation>Deslocamento médio das peças de cada troço em relação aos alvos; a faixa contém o que não se conhece dos referenciais.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Not both epochs have survey control: stretches are compared with each other, and a motion of all of them cannot be told.</source>
      <translation>Nem ambas as épocas têm pontos de apoio: os troços são comparados entre si, e um movimento de todos não se pode discernir.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Height change and horizontal motion of stretches with their 95 % bands.</source>
      <translation>Variação de altura e movimento horizontal dos troços com as suas faixas de 95 %.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>From (m)</source>
      <translation>De (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>To (m)</source>
      <translation>Até (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>No stretch moved as a whole by more than its band.</source>
      <translation>Nenhum troço se moveu em bloco mais do que a sua faixa.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Of {untold} of {all} stretches a common motion of one hundredth of the unit height cannot be told from the bend of the clouds: targets stand too far away.</source>
      <translation>Em {untold} de {all} troços, um movimento comum de um centésimo da altura da peça não se distingue da curvatura das nuvens: os alvos estão demasiado longe.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The result says nothing of its frames.</source>
      <translation>O resultado nada diz dos seus referenciais.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Units by class and control points; coordinates in {crs}.</source>
      <translation>Blocos por classe e pontos de apoio; coordenadas em {crs}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Map of a part with the units' names</source>
      <translation>Mapa de uma parte com os nomes dos blocos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Part {number} of {all} along the structure.</source>
      <translation>Parte {number} de {all} ao longo da estrutura.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Method, settings and versions</source>
      <translation>Método, definições e versões</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Units are found in the point cloud as four cones with a common centre, adjusted to their points (Gauss-Helmert model), and brought into the frame of the survey control; displacements are differences of the feature points that follow from the adjusted model, tested against their covariance (after Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds).</source>
      <translation>Os blocos são encontrados na nuvem de pontos como quatro cones de centro comum, ajustados aos seus pontos (modelo de Gauss-Helmert) e levados ao referencial de apoio; os deslocamentos são diferenças dos pontos característicos do modelo ajustado, testadas face à sua covariância (segundo Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>σ0 of the registration</source>
      <translation>σ0 do registo</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Settings</source>
      <translation>Definições</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Written {moment} by {software}.</source>
      <translation>Escrito em {moment} por {software}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Placement</source>
      <translation>Colocação</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units with neighbours on all sides</source>
      <translation>Blocos com vizinhos de todos os lados</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Nearest centre, median and 5 % (Dn)</source>
      <translation>Centro mais próximo, mediana e 5 % (Dn)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Turn between neighbours, and expected at random</source>
      <translation>Rotação entre vizinhos, e esperada ao acaso</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Difference from turns at random, p</source>
      <translation>Diferença face ao acaso, p</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Contacts of a unit, mean</source>
      <translation>Contactos de um bloco, média</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Free gap to the nearest unit, median (cm)</source>
      <translation>Folga ao bloco mais próximo, mediana (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units in a column, of those with one below</source>
      <translation>Blocos em coluna, dos que têm um abaixo</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Off the surface of their neighbours, RMS and largest (m)</source>
      <translation>Fora da superfície dos vizinhos, RMS e máximo (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Layer from outside</source>
      <translation>Camada desde o exterior</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units per 100 m²</source>
      <translation>Blocos por 100 m²</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Packing density, units per Dn²</source>
      <translation>Densidade de colocação, blocos por Dn²</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Share of the design number</source>
      <translation>Parte do número de projeto</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units of {epoch}, each in the plane through its neighbours; those at the edge do not count for density. Only units that were found are counted: hidden ones of a lower layer are not. The design number is {packing} units per Dn² and layer (Shore Protection Manual, 1984).</source>
      <translation>Blocos de {epoch}, cada um no plano dos seus vizinhos; os da borda não contam para a densidade. Só se contam os blocos encontrados, não os escondidos de uma camada inferior. O número de projeto é {packing} blocos por Dn² e camada (Shore Protection Manual, 1984).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest and cross-sections</source>
      <translation>Coroamento e cortes</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest height along the structure</source>
      <translation>Cota do coroamento ao longo da estrutura</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Mean height of the tops of the crest's units in each reach, with its 95 % band.</source>
      <translation>Cota média do topo dos blocos do coroamento de cada troço, com a sua banda de 95 %.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest height (m)</source>
      <translation>Cota do coroamento (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Highest (m)</source>
      <translation>Mais alto (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest width (m)</source>
      <translation>Largura do coroamento (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Change (mm)</source>
      <translation>Variação (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>The crest of a reach are the units whose top lies less than 0.5 Dn below the highest one; its width is that of their outlines across the axis; the change is that of units that are the crest's in both epochs. Settlement of whole stretches stands under frames and common motion.</source>
      <translation>O coroamento de um troço são os blocos cujo topo está menos de 0,5 Dn abaixo do mais alto; a largura é a dos seus contornos transversalmente ao eixo; a variação é a dos blocos que são do coroamento em ambas as épocas. O assentamento de troços inteiros está em referenciais e movimento comum.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Cross-sections</source>
      <translation>Cortes</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Quality of the units</source>
      <translation>Qualidade dos blocos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Uncertain units</source>
      <translation>Blocos incertos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Points to surface, median (mm)</source>
      <translation>Pontos à superfície, mediana (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Largest overlap</source>
      <translation>Maior sobreposição</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Pairs too close</source>
      <translation>Pares demasiado próximos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Overlap is the share of a unit's volume inside another one; two solid units cannot overlap, nor can their centres come closer than half a height. A gap is a place where a unit is likely missing in the result; the layer gaps shows them.</source>
      <translation>A sobreposição é a parte do volume de um bloco dentro de outro; dois blocos sólidos não se podem sobrepor, nem os seus centros ficar a menos de meia altura. Uma lacuna é um lugar onde provavelmente falta um bloco no resultado; a camada gaps mostra-as.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>The result does not state the quality of its units.</source>
      <translation>O resultado não indica a qualidade dos seus blocos.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Summary</source>
      <translation>Resumo</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units judged</source>
      <translation>Blocos avaliados</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Significant displacements</source>
      <translation>Deslocamentos significativos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Lost</source>
      <translation>Perdidos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Relocated</source>
      <translation>Arrastados</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>New</source>
      <translation>Novos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Not seen in the later epoch</source>
      <translation>Não vistos na época posterior</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Uncertain, not counted</source>
      <translation>Incertos, não contados</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Displaced by 5 cm or more</source>
      <translation>Deslocados 5 cm ou mais</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Displaced by 10 cm or more</source>
      <translation>Deslocados 10 cm ou mais</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Decided by reviewers</source>
      <translation>Decididos por revisores</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Rejected by reviewers</source>
      <translation>Rejeitados por revisores</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units known to be missing</source>
      <translation>Blocos que se sabe faltarem</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Completeness</source>
      <translation>Completude</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units rejected by reviewers and left out of all figures, maps and tables below: {count}.</source>
      <translation>Blocos rejeitados por revisores e excluídos de todos os números, mapas e tabelas abaixo: {count}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units that no reviewer has decided on yet: {count}.</source>
      <translation>Blocos sobre os quais ainda nenhum revisor decidiu: {count}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Units with the largest displacements</source>
      <translation>Blocos com maiores deslocamentos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>East {e}, north {n}, up {h} cm; rotation {turn}; p {p}</source>
      <translation>Este {e}, norte {n}, cima {h} cm; rotação {turn}; p {p}</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Plan and section of {unit}</source>
      <translation>Planta e secção de {unit}</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Series of {unit}</source>
      <translation>Série de {unit}</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>No displacement is significant.</source>
      <translation>Nenhum deslocamento é significativo.</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>control used</source>
      <translation>apoio usado</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>control not used</source>
      <translation>apoio não usado</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>arrows: significant horizontal displacements, enlarged {scale} times</source>
      <translation>setas: deslocamentos horizontais significativos, ampliados {scale} vezes</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>3D displacement (cm)</source>
      <translation>Deslocamento 3D (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>all units</source>
      <translation>todos os blocos</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>units</source>
      <translation>blocos</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>plan</source>
      <translation>planta</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>section {azimuth}°</source>
      <translation>secção {azimuth}°</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>chainage along the axis (m)</source>
      <translation>distância ao longo do eixo (m)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>Height change</source>
      <translation>Variação de altura</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>Horizontal motion</source>
      <translation>Movimento horizontal</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>units ≥ 10 cm (%)</source>
      <translation>blocos ≥ 10 cm (%)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>easting (m)</source>
      <translation>este (m)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>northing (m)</source>
      <translation>norte (m)</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>least and most around the leg</source>
      <translation>mínimo e máximo à volta da perna</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>mean around the leg</source>
      <translation>média à volta da perna</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>end disc</source>
      <translation>disco da ponta</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>share of the leg, from the unit's centre</source>
      <translation>parte da perna, desde o centro</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>outside the cone (mm)</source>
      <translation>fora do cone (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>around the leg (degrees)</source>
      <translation>à volta da perna (graus)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>no damage</source>
      <translation>sem dano</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>initiation of damage</source>
      <translation>início de dano</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>Iribarren's damage</source>
      <translation>dano de Iribarren</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>initiation of destruction</source>
      <translation>início de destruição</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>within</source>
      <translation>dentro</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>outside</source>
      <translation>fora</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>cannot be told</source>
      <translation>não se pode dizer</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>chainage {along} m, axis at {east} / {north}</source>
      <translation>distância {along} m, eixo em {east} / {north}</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>height (m)</source>
      <translation>cota (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>offset from the axis, left positive (m)</source>
      <translation>afastamento do eixo, esquerda positiva (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>crest height (m)</source>
      <translation>cota do coroamento (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>within the tolerance</source>
      <translation>dentro da tolerância</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>outside the tolerance</source>
      <translation>fora da tolerância</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>not judged</source>
      <translation>não julgado</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>planned place without a unit</source>
      <translation>lugar planeado sem bloco</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>unit without a planned place</source>
      <translation>bloco sem lugar planeado</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>surface of the points</source>
      <translation>superfície dos pontos</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>design</source>
      <translation>projeto</translation>
    </message>
  </context>
</TS>
