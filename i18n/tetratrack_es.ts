<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES" sourcelanguage="en">
  <context>
    <name>tetratrack</name>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Units at the common centre of their cones, with orientation, standard deviations (m, degrees), score and status.</source>
      <translation>Piezas en el centro común de sus conos, con orientación, desviaciones típicas (m, grados), puntuación y estado.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Centre and the four joints of three cones (f123, f124, f134, f234) of every unit, with covariance (m, m²).</source>
      <translation>Centro y las cuatro uniones de tres conos (f123, f124, f134, f234) de cada pieza, con covarianza (m, m²).</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Displacement of every feature point between consecutive epochs (m), with test statistic and class.</source>
      <translation>Desplazamiento de cada punto característico entre épocas consecutivas (m), con estadístico de prueba y clase.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Residuals at the control points (m), with normalised residual; disturbed points are marked.</source>
      <translation>Residuos en los puntos de control (m), con residuo normalizado; los puntos perturbados van marcados.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Feature points less surveyed check points (m).</source>
      <translation>Puntos característicos menos puntos de comprobación medidos (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Monitoring</source>
      <translation>Seguimiento</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Single steps</source>
      <translation>Pasos sueltos</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Planning and simulation</source>
      <translation>Planificación y simulación</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Inputs and outputs</source>
      <translation>Entradas y salidas</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Limits</source>
      <translation>Límites</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>The engine's result holds no layer {layer}.</source>
      <translation>El resultado del motor no contiene la capa {layer}.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Numbers for models</source>
      <translation>Números para modelos</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Compare with design</source>
      <translation>Comparar con el proyecto</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Compares the units of one epoch with a placement plan and with a design profile: deviation and turn of every unit, places without a unit, distance from the design surface, and whether that is within the tolerance.</source>
      <translation>Compara las piezas de una época con un plan de colocación y con un perfil de proyecto: desviación y giro de cada pieza, lugares sin pieza, distancia a la superficie de proyecto y si está dentro de la tolerancia.</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>A unit stands at the place of its own name, or at the nearest free one within one height H. Within or outside is said where the standard deviations leave no doubt of 5 % or more, open where they do.</source>
      <translation>Una pieza está en el lugar de su propio nombre, o en el lugar libre más próximo a menos de una altura H. Se dice dentro o fuera cuando las desviaciones típicas no dejan duda del 5 % o más; si no, queda abierto.</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>design,plan,placement,profile,tolerance,as-built,DXF</source>
      <translation>proyecto,plan,colocación,perfil,tolerancia,as-built,DXF</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>GeoPackage with the layers plan_deviations, plan_unmatched and profile_deviations, those that were asked for.</source>
      <translation>GeoPackage con las capas plan_deviations, plan_unmatched y profile_deviations, las que se pidieron.</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Deviations</source>
      <translation>Desviaciones</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Units outside the tolerance of the plan</source>
      <translation>Piezas fuera de la tolerancia del plan</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Planned places without a unit</source>
      <translation>Lugares previstos sin pieza</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Units outside the tolerance of the profile</source>
      <translation>Piezas fuera de la tolerancia del perfil</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Cross-sections and crest</source>
      <translation>Secciones y coronación</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Cuts the structure across its axis: outlines of the blocks of every epoch, surface of the points and design in each section, height and width of the crest of each reach, and settlement along the structure.</source>
      <translation>Corta la estructura transversalmente a su eje: contornos de las piezas de cada época, superficie de los puntos y proyecto en cada sección, cota y anchura de la coronación de cada tramo, y asiento a lo largo de la estructura.</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Points are those read around the units for the review (unit-points); without them sections show blocks alone.</source>
      <translation>Los puntos son los leídos alrededor de las piezas para la revisión (unit-points); sin ellos las secciones muestran solo las piezas.</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>profile,section,crest,settlement,chainage</source>
      <translation>perfil,sección,coronación,asiento,progresiva</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>GeoPackage with the layers sections, crest and settlement.</source>
      <translation>GeoPackage con las capas sections, crest y settlement.</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Sections</source>
      <translation>Secciones</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Label of an epoch; empty for both takes the latest pair.</source>
      <translation>Etiqueta de una época; ambas vacías toman el par más reciente.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Displacement report</source>
      <translation>Informe de desplazamientos</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Writes the report of a result as reviewed so far: summary, control quality, displacement map and table, worst units, damage figures, method, settings and versions.</source>
      <translation>Escribe el informe de un resultado según su revisión actual: resumen, calidad del control, mapa y tabla de desplazamientos, peores piezas, índices de daño, método, ajustes y versiones.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Rejected units are left out of the statistics and listed apart. PDF needs the library weasyprint in the engine.</source>
      <translation>Las piezas rechazadas quedan fuera de las estadísticas y se listan aparte. El PDF necesita la biblioteca weasyprint en el motor.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>report,HTML,PDF,damage,displacement</source>
      <translation>informe,HTML,PDF,daño,desplazamiento</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>that of the result</source>
      <translation>la del resultado</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>stable units and control</source>
      <translation>piezas estables y control</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>control points alone</source>
      <translation>solo puntos de control</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>What the displacements are stated against, in all of the report.</source>
      <translation>Aquello respecto a lo que se dan los desplazamientos, en todo el informe.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Places easting,northing along it, separated by blanks; damage is then stated by sections.</source>
      <translation>Puntos este,norte a lo largo de él, separados por espacios; los daños se dan entonces por tramos.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>0.09, 0.30 and 0.61 m (US Army Corps of Engineers)</source>
      <translation>0,09, 0,30 y 0,61 m (US Army Corps of Engineers)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>5 and 10 cm</source>
      <translation>5 y 10 cm</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>0.5 and 1 Dn (nominal diameter)</source>
      <translation>0,5 y 1 Dn (diámetro nominal)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Limits by which the units are counted that moved.</source>
      <translation>Límites con los que se cuentan las piezas que se movieron.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>So many of those that moved most get views, series and decisions of their own.</source>
      <translation>Tantos de los que más se movieron reciben vistas, series y decisiones propias.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>HTML in one file, or PDF; the ending decides.</source>
      <translation>HTML en un archivo, o PDF; decide la extensión.</translation>
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
      <translation>Referencia de los desplazamientos</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Axis of the structure</source>
      <translation>Eje de la estructura</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length looked at (m)</source>
      <translation>Longitud considerada (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of the structure in metres, for the damage number N_od.</source>
      <translation>Longitud de la estructura en metros, para el número de daño N_od.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of a section (m)</source>
      <translation>Longitud de un tramo (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of the sections along the axis, in metres.</source>
      <translation>Longitud de los tramos a lo largo del eje, en metros.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Movement bands</source>
      <translation>Clases de movimiento</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Units shown one by one</source>
      <translation>Piezas mostradas una a una</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Report</source>
      <translation>Informe</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Give both epochs, or neither for the latest pair.</source>
      <translation>Indique ambas épocas, o ninguna para el par más reciente.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Export as-built model</source>
      <translation>Exportar modelo según lo construido</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Writes the units of one epoch as bodies at their fitted poses, coloured by class, with uncertainty and movement as properties, for CAD, BIM and 3D viewers. The ending of the file chooses the format: glTF (.glb), Wavefront (.obj), DXF, IFC4x3 or the poses alone (.json).</source>
      <translation>Escribe las piezas de una época como cuerpos en sus poses ajustadas, coloreados por clase, con incertidumbre y movimiento como propiedades, para CAD, BIM y visores 3D. La extensión del archivo elige el formato: glTF (.glb), Wavefront (.obj), DXF, IFC4x3 o solo las poses (.json).</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Bodies have 24 plane faces a leg. glTF, OBJ, IFC and JSON hold coordinates less a reduction point that stands in the file; DXF holds coordinates of the survey CRS and needs the library ezdxf in the engine.</source>
      <translation>Los cuerpos tienen 24 caras planas por pata. glTF, OBJ, IFC y JSON contienen coordenadas menos un punto de reducción indicado en el archivo; DXF contiene coordenadas del SRC del levantamiento y necesita la biblioteca ezdxf en el motor.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>model,3D,glTF,GLB,OBJ,DXF,IFC,BIM,CAD,as-built</source>
      <translation>modelo,3D,glTF,GLB,OBJ,DXF,IFC,BIM,CAD,según lo construido</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Label of the epoch whose units are written; the latest one with units unless given.</source>
      <translation>Etiqueta de la época cuyas piezas se escriben; si no se indica, la última con piezas.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>File to write; its ending decides the format.</source>
      <translation>Archivo a escribir; su extensión decide el formato.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Model</source>
      <translation>Modelo</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Extract feature points</source>
      <translation>Extraer puntos característicos</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Derives the centre and the four points where three cone surfaces meet on the outside of each unit, with the covariance carried over from the fit. These points can be surveyed by total station as well.</source>
      <translation>Calcula el centro y los cuatro puntos donde tres superficies cónicas se encuentran por fuera de cada pieza, con la covarianza propagada del ajuste. Estos puntos también pueden medirse con estación total.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>A joint is marked as observed only where points lie next to it; otherwise it follows from the rest of the unit.</source>
      <translation>Una unión se marca como observada solo si hay puntos junto a ella; si no, se deduce del resto de la pieza.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>feature points,cone intersection,centre,covariance propagation</source>
      <translation>puntos característicos,intersección de conos,centro,propagación de covarianza</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Layer of units from Fit tetrapods or Monitor a survey.</source>
      <translation>Capa de piezas de Ajustar tetrápodos o Seguir un levantamiento.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Points d1 to d4, which crews can measure and paint.</source>
      <translation>Puntos d1 a d4, que las cuadrillas pueden medir y pintar.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>From the centre to the end disc, in metres; empty takes 0.644 H.</source>
      <translation>Del centro al disco extremo, en metros; vacío toma 0,644 H.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Fitted units</source>
      <translation>Piezas ajustadas</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Centres of the end discs as well</source>
      <translation>También los centros de los discos de los extremos</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Leg length (m)</source>
      <translation>Longitud de la pata (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Points</source>
      <translation>Puntos</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Fit tetrapods</source>
      <translation>Ajustar tetrápodos</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Fits four equal cones that share a centre to the points of each unit by an iterated Gauss–Helmert adjustment with robust weights, end discs and removal of the curvature bias; gives pose, radius, taper and their covariance.</source>
      <translation>Ajusta cuatro conos iguales con un centro común a los puntos de cada pieza mediante un ajuste de Gauss-Helmert iterado con pesos robustos, discos extremos y eliminación del sesgo de curvatura; da pose, radio, conicidad y su covarianza.</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>With one visible leg the twist about its axis is undetermined: the unit says so in its large standard deviation.</source>
      <translation>Con una sola pata visible, el giro alrededor de su eje queda indeterminado: lo dice la gran desviación típica de la pieza.</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>adjustment,Gauss-Helmert,least squares,cone,pose,covariance</source>
      <translation>ajuste,Gauss-Helmert,mínimos cuadrados,cono,pose,covarianza</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Layer of units from Segment tetrapods, with the fields qx, qy, qz, qw of their orientation.</source>
      <translation>Capa de piezas de Segmentar tetrápodos, con los campos qx, qy, qz, qw de su orientación.</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Units found</source>
      <translation>Piezas encontradas</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Units fitted</source>
      <translation>Piezas ajustadas (número)</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Inspect tiles</source>
      <translation>Inspeccionar teselas</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Lists point cloud tiles with their extent, CRS, number and density of points and range of heights. Run it first: it shows missing CRS, gaps, overlaps and tiles too thin to find units in.</source>
      <translation>Lista las teselas de nube de puntos con extensión, SRC, número y densidad de puntos y rango de alturas. Ejecútelo primero: muestra SRC ausentes, huecos, solapes y teselas demasiado pobres.</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Reads headers and a sample of points; a damaged tile is named and ends the run.</source>
      <translation>Lee las cabeceras y una muestra de puntos; una tesela dañada se nombra y termina la ejecución.</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>point cloud,LAS,LAZ,tile index,density,CRS,extent</source>
      <translation>nube de puntos,LAS,LAZ,índice de teselas,densidad,SRC,extensión</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>One rectangle per tile with file, CRS, points, density (points/m²) and heights (m).</source>
      <translation>Un rectángulo por tesela con archivo, SRC, puntos, densidad (puntos/m²) y alturas (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Tile index</source>
      <translation>Índice de teselas</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Tiles</source>
      <translation>Teselas</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Median density (points/m²)</source>
      <translation>Densidad mediana (puntos/m²)</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>CRS of the tiles</source>
      <translation>SRC de las teselas</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Monitor a survey</source>
      <translation>Seguir un levantamiento</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>All steps at once: registers every epoch to survey control, finds the tetrapods, fits four cones that share a centre, derives feature points and tests their displacements. Give a survey.toml, or the epochs and the unit.</source>
      <translation>Todos los pasos a la vez: registra cada época al control topográfico, encuentra los tetrápodos, ajusta cuatro conos con centro común, calcula puntos característicos y prueba sus desplazamientos. Indique un survey.toml, o las épocas y la pieza.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Units of which less than about 5 % is seen are not found. Without control the cloud's own frame is used, and the result says so.</source>
      <translation>No se encuentran piezas de las que se ve menos de un 5 % aproximadamente. Sin control se usa el sistema propio de la nube, y el resultado lo dice.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>tetrapod,armour unit,breakwater,displacement,monitoring,LAS,LAZ,deformation</source>
      <translation>tetrápodo,pieza de manto,dique,desplazamiento,seguimiento,LAS,LAZ,deformación</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>A survey.toml; if given, it states everything, and the fields for epochs, unit, CRS and area are not used.</source>
      <translation>Un survey.toml; si se indica, lo decide todo, y los campos de épocas, pieza, SRC y área no se usan.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Label</source>
      <translation>Nombre</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Time (UTC)</source>
      <translation>Hora (UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Control points</source>
      <translation>Puntos de control</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Targets in the cloud</source>
      <translation>Dianas en la nube</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Check points</source>
      <translation>Puntos de comprobación</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Epochs</source>
      <translation>Épocas</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>One row per epoch: label, time such as 2025-03-14T02:30, folder or files of tiles (separated by ;), CSV files or layers.</source>
      <translation>Una fila por época: nombre, hora como 2025-03-14T02:30, carpeta o archivos de teselas (separados por ;), archivos CSV o capas.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Writes a top view of each epoch as GeoTIFF beside the result, as a backdrop.</source>
      <translation>Escribe una vista superior de cada época como GeoTIFF junto al resultado, de fondo.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Adds all layers to the project as a group with their styles.</source>
      <translation>Añade todas las capas al proyecto como grupo con sus estilos.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>GeoPackage with units, feature points, displacements, residuals, epochs and reviews, in the survey's CRS, times in UTC.</source>
      <translation>GeoPackage con piezas, puntos característicos, desplazamientos, residuos, épocas y revisiones, en el SRC del levantamiento, horas en UTC.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Survey file</source>
      <translation>Archivo del levantamiento</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Shaded relief of each epoch</source>
      <translation>Relieve sombreado de cada época</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Load the result</source>
      <translation>Cargar el resultado</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Result</source>
      <translation>Resultado</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Units moved</source>
      <translation>Piezas movidas</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>RMSE at check points (m)</source>
      <translation>EMC en puntos de comprobación (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Give a survey.toml, or at least one epoch with its tiles.</source>
      <translation>Indique un survey.toml, o al menos una época con sus teselas.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Every epoch needs six columns: label, time, tiles, control points, targets, check points.</source>
      <translation>Cada época necesita seis columnas: nombre, hora, teselas, puntos de control, dianas, puntos de comprobación.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{place}: {time} is no time; write it as 2025-03-14, 2025-03-14T02:30 (UTC) or 2025-03-14T11:30+09:00.</source>
      <translation>{place}: {time} no es una fecha; escriba 2025-03-14, 2025-03-14T02:30 (UTC) o 2025-03-14T11:30+09:00.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{where}: there is no file or layer {path}.</source>
      <translation>{where}: no existe el archivo o capa {path}.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{where}: {path} cannot be read as a point layer or CSV file.</source>
      <translation>{where}: {path} no se puede leer como capa de puntos o archivo CSV.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>The folder {folder} does not exist.</source>
      <translation>La carpeta {folder} no existe.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Relief {epoch}</source>
      <translation>Relieve {epoch}</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>New survey from a folder</source>
      <translation>Nuevo levantamiento desde una carpeta</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Writes a survey.toml from what the files in a folder say: epochs and times, CRS, control, targets and check points, and the size of the units from the cloud itself.</source>
      <translation>Escribe un survey.toml a partir de lo que dicen los archivos de una carpeta: épocas y horas, SRC, control, dianas y puntos de comprobación, y el tamaño de las piezas según la propia nube.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Every value stands with its reason; what the files leave open is asked for in the log.</source>
      <translation>Cada valor lleva su razón; lo que los archivos dejan abierto se pregunta en el registro.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>new survey,folder,tiles,epochs,size of units,survey.toml</source>
      <translation>nuevo levantamiento,carpeta,teselas,épocas,tamaño de las piezas,survey.toml</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Folder with the tiles of all epochs; tables of control lie in it or beside it.</source>
      <translation>Carpeta con las teselas de todas las épocas; las tablas de control están en ella o a su lado.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Point cloud tiles</source>
      <translation>Teselas de nube de puntos</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Instead of a folder: point cloud layers, or files, of all epochs.</source>
      <translation>En lugar de una carpeta: capas de nubes de puntos, o archivos, de todas las épocas.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Projected CRS in metres; needed only where the tiles declare none.</source>
      <translation>SRC proyectado en metros; solo hace falta si las teselas no declaran ninguno.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Empty estimates it from the cloud.</source>
      <translation>Vacío: se estima a partir de la nube.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Text file to look through, correct and run.</source>
      <translation>Archivo de texto para revisar, corregir y ejecutar.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Folder of tiles</source>
      <translation>Carpeta de teselas</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>CRS of the results</source>
      <translation>SRC de los resultados</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Height of the units (m)</source>
      <translation>Altura de las piezas (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Survey</source>
      <translation>Levantamiento</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Give a folder of tiles, or tiles.</source>
      <translation>Indique una carpeta de teselas, o teselas.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Plan a survey: detectable displacement</source>
      <translation>Planificar un levantamiento: desplazamiento detectable</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Computes which displacement and rotation of a unit a planned survey will find, from point density, noise, visible share and registration: the Cramér–Rao bound of the adjustment for the unit's geometry, and Baarda's detectability.</source>
      <translation>Calcula qué desplazamiento y giro de una pieza hallará un levantamiento previsto, según densidad de puntos, ruido, parte visible y registro: cota de Cramér-Rao del ajuste para la geometría de la pieza, y detectabilidad de Baarda.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>White noise is averaged over the points of a unit; whatever does not average out must be stated as systematic part. The shares of units found are those measured on simulated piles of that density and noise, seen from above.</source>
      <translation>El ruido blanco se promedia sobre los puntos de una pieza; lo que no se promedia debe indicarse como parte sistemática. Las partes de piezas halladas son las medidas en mantos simulados de esa densidad y ese ruido, vistos desde arriba.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>planning,detectability,point density,noise,Cramér-Rao bound,minimal detectable displacement</source>
      <translation>planificación,detectabilidad,densidad de puntos,ruido,cota de Cramér-Rao,desplazamiento mínimo detectable</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Point density (points/m²)</source>
      <translation>Densidad de puntos (puntos/m²)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>On a surface that faces the instrument, all flight strips or stations together.</source>
      <translation>Sobre una superficie frente al instrumento, todas las pasadas o estaciones juntas.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Noise of a point (m)</source>
      <translation>Ruido de un punto (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation along the surface normal, in metres.</source>
      <translation>Desviación típica a lo largo de la normal a la superficie, en metros.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Visible share of a unit</source>
      <translation>Parte visible de una pieza</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share of a unit's surface that holds points, 0 to 1; in a pile 0.05 to 0.5.</source>
      <translation>Parte de la superficie de una pieza que tiene puntos, 0 a 1; en un manto de 0,05 a 0,5.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Registration (m)</source>
      <translation>Registro (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of an epoch's registration at the unit, per coordinate, in metres.</source>
      <translation>Desviación típica del registro de una época en la pieza, por coordenada, en metros.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Systematic part (m)</source>
      <translation>Parte sistemática (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Strip offsets, roughness and growth that do not average out, per coordinate, in metres.</source>
      <translation>Desfases de pasadas, rugosidad e incrustaciones que no se promedian, por coordenada, en metros.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Line of sight from the vertical (degrees)</source>
      <translation>Visual respecto a la vertical (grados)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>0 from the air; about 70 from the crown wall.</source>
      <translation>0 desde el aire; unos 70 desde el espaldón.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Calibrated and held; otherwise they are estimated for every unit, which costs accuracy.</source>
      <translation>Calibrados y fijados; si no, se estiman para cada pieza, a costa de la precisión.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Level of significance</source>
      <translation>Nivel de significación</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Probability of a false alarm for one unit.</source>
      <translation>Probabilidad de falsa alarma para una pieza.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Power</source>
      <translation>Potencia</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Probability with which the displacement is found.</source>
      <translation>Probabilidad de hallar el desplazamiento.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>What the survey detects over point density and visible share, beside the plan.</source>
      <translation>Lo que el levantamiento detecta según la densidad de puntos y la parte visible, junto al plan.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Points on a unit</source>
      <translation>Puntos en una pieza</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of the centre (m)</source>
      <translation>Desviación típica del centro (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of the rotation (degrees)</source>
      <translation>Desviación típica del giro (grados)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of a displacement (m)</source>
      <translation>Desviación típica de un desplazamiento (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable displacement, worst direction (m)</source>
      <translation>Desplazamiento detectable, peor dirección (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable displacement, mean (m)</source>
      <translation>Desplazamiento detectable, media (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable rotation (degrees)</source>
      <translation>Giro detectable (grados)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Points per square of a unit's height</source>
      <translation>Puntos por cuadrado de la altura de una pieza</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 30 % or more</source>
      <translation>Parte hallada de las piezas vistas en un 30 % o más</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 15–30 %</source>
      <translation>Parte hallada de las piezas vistas en un 15–30 %</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 5–15 %</source>
      <translation>Parte hallada de las piezas vistas en un 5–15 %</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>The level of significance must be below the power.</source>
      <translation>El nivel de significación debe ser menor que la potencia.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Radius and taper are known</source>
      <translation>Radio y conicidad conocidos</translation>
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
      <translation>{file} no se puede escribir: {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/provider.py" />
      <source>Tetratrack: displacements of tetrapods</source>
      <translation>Tetratrack: desplazamientos de tetrápodos</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Register to control</source>
      <translation>Registrar al control</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Estimates the rigid transformation from an epoch's cloud to survey control from targets, weighted by their standard deviations, and finds disturbed targets by data snooping on normalised residuals.</source>
      <translation>Estima la transformación rígida de la nube de una época al control a partir de dianas ponderadas por sus desviaciones típicas, y halla dianas perturbadas por data snooping de los residuos normalizados.</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Needs three targets that do not lie in one line; an outlier is found from four, and named surely from five.</source>
      <translation>Necesita tres dianas no alineadas; un error se halla con cuatro y se nombra con seguridad con cinco.</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>registration,control points,targets,transformation,data snooping,georeferencing</source>
      <translation>registro,puntos de control,dianas,transformación,data snooping,georreferenciación</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>GeoPackage whose table epochs holds the seven parameters and their covariance.</source>
      <translation>GeoPackage cuya tabla epochs contiene los siete parámetros y su covarianza.</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Registration</source>
      <translation>Registro</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>RMSE at control points (m)</source>
      <translation>EMC en puntos de control (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Disturbed targets</source>
      <translation>Dianas perturbadas</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Register views</source>
      <translation>Registrar vistas</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Brings overlapping views of a depth camera or scanner stations into the frame of the first by multiway ICP with a pose graph, and writes one cloud in which every view keeps its number as point source id.</source>
      <translation>Lleva vistas solapadas de una cámara de profundidad o de estaciones de escáner al sistema de la primera mediante ICP múltiple con grafo de poses, y escribe una nube en la que cada vista conserva su número como identificador de origen.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Views must overlap by a third or more and be roughly aligned; views that do not connect are named.</source>
      <translation>Las vistas deben solaparse un tercio o más y estar más o menos alineadas; las que no conectan se nombran.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>registration,ICP,pose graph,depth camera,multi-view</source>
      <translation>registro,ICP,grafo de poses,cámara de profundidad,multivista</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Resolution at which views are matched, in metres; empty derives it from the point spacing.</source>
      <translation>Resolución a la que se comparan las vistas, en metros; vacío la deduce del espaciado de puntos.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>One LAZ file in the frame of the first view.</source>
      <translation>Un archivo LAZ en el sistema de la primera vista.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Views</source>
      <translation>Vistas</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Voxel size (m)</source>
      <translation>Tamaño de vóxel (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Registered cloud</source>
      <translation>Nube registrada</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>RMSE between views (m)</source>
      <translation>EMC entre vistas (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Points less blocks</source>
      <translation>Puntos menos piezas</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Writes the points around the units of one epoch with their distance to the nearest fitted unit, coloured from blue (10 cm or more within a body) through white to red (10 cm or more outside): what is red is debris, a unit that was missed, or one that is broken.</source>
      <translation>Escribe los puntos alrededor de las piezas de una época con su distancia a la pieza ajustada más próxima, coloreados de azul (10 cm o más dentro de un cuerpo) a rojo (10 cm o más fuera) pasando por blanco: lo rojo son escombros, una pieza no encontrada o una rota.</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Points are those read around the units for the review (unit-points), in the control frame. For units lower than 2 m, and models of a tank, colours end at 5 % of the height H instead of 10 cm; points near no unit have the distance 10 m.</source>
      <translation>Los puntos son los leídos alrededor de las piezas para la revisión (unit-points), en el marco de control. Para piezas de menos de 2 m y modelos de tanque, los colores terminan en el 5 % de la altura H en lugar de 10 cm; los puntos lejos de toda pieza tienen la distancia 10 m.</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>residuals,LAZ,LAS,point cloud,distance</source>
      <translation>residuos,LAZ,LAS,nube de puntos,distancia</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Point cloud with the dimensions distance (m) and unit.</source>
      <translation>Nube de puntos con las dimensiones distance (m) y unit.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Label of the epoch whose units are looked at; the latest one with units unless given.</source>
      <translation>Nombre de la época cuyas piezas se miran; por defecto la última que las tiene.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Degrees a unit may be turned from its planned orientation.</source>
      <translation>Grados que una pieza puede estar girada respecto a la orientación prevista.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>GeoPackage written by Monitor a survey.</source>
      <translation>GeoPackage escrito por Seguir un levantamiento.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Path of a CSV unit_id,easting,northing,height with the planned centres, optionally qx,qy,qz,qw, or of a layer of points with heights (FILE|layername=NAME).</source>
      <translation>Ruta de un CSV unit_id,easting,northing,height con los centros previstos, opcionalmente qx,qy,qz,qw, o de una capa de puntos con cotas (FILE|layername=NAME).</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of places (m)</source>
      <translation>Tolerancia de los lugares (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres a unit may be from its planned place.</source>
      <translation>Metros que una pieza puede distar de su lugar previsto.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of turns (°)</source>
      <translation>Tolerancia de los giros (°)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Path of a DXF or of a layer of lines with heights: a single line is a cross-section along the whole structure, several are its edges.</source>
      <translation>Ruta de un DXF o de una capa de líneas con cotas: una sola línea es una sección a lo largo de toda la estructura, varias son sus aristas.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres a unit may be off the design profile.</source>
      <translation>Metros que una pieza puede distar del perfil de proyecto.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Places easting,northing along it, separated by blanks; the centreline of the units unless given.</source>
      <translation>Lugares easting,northing a lo largo del eje, separados por espacios; por defecto la línea central de las piezas.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Distance of the sections (m)</source>
      <translation>Distancia de las secciones (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres along the axis; four heights of a unit unless given.</source>
      <translation>Metros a lo largo del eje; por defecto cuatro alturas de pieza.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Epoch</source>
      <translation>Época</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Placement plan</source>
      <translation>Plan de colocación</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Design profile</source>
      <translation>Perfil de proyecto</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of the profile (m)</source>
      <translation>Tolerancia del perfil (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>outermost point of a unit</source>
      <translation>punto más exterior de una pieza</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>centre of a unit</source>
      <translation>centro de una pieza</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>What is judged against the design profile; both distances are written.</source>
      <translation>Lo que se juzga frente al perfil de proyecto; se escriben ambas distancias.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>All files (*.*)</source>
      <translation>Todos los archivos (*.*)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Judged against the profile</source>
      <translation>Juzgado frente al perfil</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Segment tetrapods</source>
      <translation>Segmentar tetrápodos</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Finds every tetrapod in a pile: cones from pairs of oriented points, legs that agree on a common centre and on the angles between them, and verification against the visible surface and against empty space.</source>
      <translation>Encuentra cada tetrápodo de un manto: conos a partir de pares de puntos orientados, patas que coinciden en un centro y en sus ángulos, y verificación con la superficie visible y el espacio vacío.</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Units of which less than about 5 % is seen are not found; weak evidence has the status uncertain. Poses are approximate: fit them next.</source>
      <translation>No se encuentran piezas de las que se ve menos de un 5 % aproximadamente; la evidencia débil tiene estado incierto. Las poses son aproximadas: ajústelas después.</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>segmentation,RANSAC,cone,tetrapod,armour unit,detection</source>
      <translation>segmentación,RANSAC,cono,tetrápodo,pieza de manto,detección</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Simulate a survey</source>
      <translation>Simular un levantamiento</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Writes a simulated survey of a tetrapod slope with known poses: LAZ tiles, control, check points and survey.toml. Use it to try the chain, to train, or to test a planned density and noise.</source>
      <translation>Escribe el levantamiento simulado de un talud de tetrápodos de poses conocidas: teselas LAZ, control, puntos de comprobación y survey.toml. Sirve para probar la cadena, formarse o ensayar una densidad y un ruido previstos.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Simulated surfaces are cleaner than real ones; judge a plan with some reserve.</source>
      <translation>Las superficies simuladas son más limpias que las reales; juzgue un plan con reserva.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>simulation,synthetic,ground truth,test data</source>
      <translation>simulación,sintético,verdad terreno,datos de prueba</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>UAV laser scanner</source>
      <translation>escáner láser en dron</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>terrestrial laser scanner</source>
      <translation>escáner láser terrestre</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>photogrammetry</source>
      <translation>fotogrametría</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>depth camera</source>
      <translation>cámara de profundidad</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Decides viewpoints, hidden parts and, unless stated, noise and density.</source>
      <translation>Decide los puntos de vista, las partes ocultas y, si no se indican, ruido y densidad.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Number of units on the slope.</source>
      <translation>Número de piezas en el talud.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Number of surveys; some units move between them.</source>
      <translation>Número de levantamientos; algunas piezas se mueven entre ellos.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Standard deviation of the range, in metres; empty takes that of the instrument.</source>
      <translation>Desviación típica de la distancia, en metros; vacío toma la del instrumento.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>On the ground; empty takes that of the instrument.</source>
      <translation>En el suelo; vacío toma la del instrumento.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>A coast of this length, of stretches that hold the number of units each; empty gives one site.</source>
      <translation>Una costa de esta longitud, hecha de tramos con ese número de unidades cada uno; vacío da un solo emplazamiento.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Error of the trajectory along the site in metres, root mean square of each coordinate; empty for none.</source>
      <translation>Error de la trayectoria a lo largo del emplazamiento, en metros, media cuadrática por coordenada; vacío para ninguno.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>The same seed gives the same survey.</source>
      <translation>La misma semilla da el mismo levantamiento.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Receives tiles, CSV files, survey.toml and truth.</source>
      <translation>Recibe teselas, archivos CSV, survey.toml y verdad.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Instrument</source>
      <translation>Instrumento</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Units</source>
      <translation>Piezas</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Length of a coast (m)</source>
      <translation>Longitud de una costa (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Bend of every epoch (m)</source>
      <translation>Flexión de cada época (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Seed</source>
      <translation>Semilla</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Survey folder</source>
      <translation>Carpeta del levantamiento</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>survey.toml of the simulated survey</source>
      <translation>survey.toml del levantamiento simulado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>The tetratrack engine is not installed: open Settings &gt; Options &gt; Tetratrack and create its environment or choose one.</source>
      <translation>El motor tetratrack no está instalado: abra Configuración &gt; Opciones &gt; Tetratrack y cree su entorno o elija uno.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>Create or choose the engine…</source>
      <translation>Crear o elegir el motor…</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>Make the environment again…</source>
      <translation>Crear el entorno de nuevo…</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>The engine ended unexpectedly (exit code {code}); QGIS and your data are unharmed.</source>
      <translation>El motor terminó de forma inesperada (código {code}); QGIS y sus datos están intactos.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>QGIS runs version {plugin} of the plugin, but its files are of version {engine}: restart QGIS.</source>
      <translation>QGIS usa la versión {plugin} del complemento, pero sus archivos son de la versión {engine}: reinicie QGIS.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>The engine could not be started with {python}: {reason}.</source>
      <translation>No se pudo iniciar el motor con {python}: {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/environment.py" />
      <source>The tetratrack engine was made for another version of the plugin: let it be brought up to date in Settings &gt; Options.</source>
      <translation>El motor tetratrack se creó para otra versión del complemento: actualícelo en Configuración &gt; Opciones.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/environment.py" />
      <source>The Python that the tetratrack engine was made with is gone: let its environment be made again in Settings &gt; Options.</source>
      <translation>El Python con el que se creó el motor tetratrack ya no existe: cree de nuevo su entorno en Configuración &gt; Opciones.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Unit</source>
      <translation>Pieza</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Point</source>
      <translation>Punto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Unit in the plan</source>
      <translation>Pieza en el plan</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Section</source>
      <translation>Sección</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Time</source>
      <translation>Hora</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Until</source>
      <translation>Hasta</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>From epoch</source>
      <translation>De la época</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>To epoch</source>
      <translation>A la época</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>From</source>
      <translation>De</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>To</source>
      <translation>A</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Feature point</source>
      <translation>Punto característico</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Type of unit</source>
      <translation>Tipo de pieza</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Status</source>
      <translation>Estado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Class</source>
      <translation>Clase</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Kind</source>
      <translation>Tipo</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Grade</source>
      <translation>Grado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Datum</source>
      <translation>Referencia</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reference epoch</source>
      <translation>Época de referencia</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>May be</source>
      <translation>Puede ser</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest units</source>
      <translation>Piezas más próximas</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Decision</source>
      <translation>Decisión</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Comment</source>
      <translation>Comentario</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reviewer</source>
      <translation>Revisor</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reviewed</source>
      <translation>Revisado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Confirmed by</source>
      <translation>Confirmado por</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Confirmed</source>
      <translation>Confirmado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Editor</source>
      <translation>Editor</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Edited</source>
      <translation>Editado</translation>
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
      <translation>Marcado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reason</source>
      <translation>Motivo</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Known by</source>
      <translation>Conocido por</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Software</source>
      <translation>Programa</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>File</source>
      <translation>Archivo</translation>
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
      <translation>Observación</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>LAS version</source>
      <translation>Versión LAS</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Point format</source>
      <translation>Formato de puntos</translation>
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
      <translation>Radio</translation>
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
      <translation>Desplazamiento horizontal</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement</source>
      <translation>Desplazamiento</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Azimuth</source>
      <translation>Acimut</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. easting</source>
      <translation>Desv. típica este</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. northing</source>
      <translation>Desv. típica norte</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. height</source>
      <translation>Desv. típica altura</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Rotation</source>
      <translation>Giro</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. rotation</source>
      <translation>Desv. típica giro</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Detectable</source>
      <translation>Detectable</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement / H</source>
      <translation>Desplazamiento / H</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement / Dn</source>
      <translation>Desplazamiento / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Missing of a leg</source>
      <translation>Falta de una pata</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Distance of the points</source>
      <translation>Distancia de los puntos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest centre</source>
      <translation>Centro más próximo</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along the structure</source>
      <translation>A lo largo de la obra</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along, from</source>
      <translation>A lo largo, de</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along, to</source>
      <translation>A lo largo, a</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Correlation length</source>
      <translation>Longitud de correlación</translation>
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
      <translation>Desviación típica</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. displacement</source>
      <translation>Desv. típica del desplazamiento</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest of the other side</source>
      <translation>Más próximo del otro lado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height of the design</source>
      <translation>Cota del proyecto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Centre off the design</source>
      <translation>Desvío del centro al proyecto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Outermost point off the design</source>
      <translation>Desvío del punto extremo al proyecto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height of the crest</source>
      <translation>Cota de coronación</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Highest top</source>
      <translation>Punto más alto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Width of the crest</source>
      <translation>Ancho de coronación</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Change</source>
      <translation>Variación</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. change</source>
      <translation>Desv. típica de la variación</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>95 % band, from</source>
      <translation>Banda del 95 %, desde</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>95 % band, to</source>
      <translation>Banda del 95 %, hasta</translation>
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
      <translation>Puntos/m²</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Legs seen</source>
      <translation>Patas vistas</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Probability of a broken leg</source>
      <translation>Probabilidad de pata rota</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Share seen</source>
      <translation>Parte vista</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Probability</source>
      <translation>Probabilidad</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Share supported</source>
      <translation>Parte respaldada</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Overlap</source>
      <translation>Solape</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Observed</source>
      <translation>Observado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Normalised residual</source>
      <translation>Residuo normalizado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Disturbed</source>
      <translation>Perturbado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Strip</source>
      <translation>Pasada</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Layer of the armour</source>
      <translation>Capa del manto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Packing</source>
      <translation>Compacidad</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Spacing / Dn</source>
      <translation>Separación / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Turn against the neighbour</source>
      <translation>Giro respecto al vecino</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Off the surface</source>
      <translation>Desvío de la superficie</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Off the surface / Dn</source>
      <translation>Desvío de la superficie / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Contacts</source>
      <translation>Contactos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Free gap</source>
      <translation>Holgura</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>In a column</source>
      <translation>En columna</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}</source>
      <translation>Pata {number}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}: missing</source>
      <translation>Pata {number}: falta</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}: probability of a break</source>
      <translation>Pata {number}: probabilidad de rotura</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>LAS, LAZ, COPC, E57 or PLY files, a folder of them, a virtual point cloud (.vpc) or point cloud layers; coordinates in metres.</source>
      <translation>Archivos LAS, LAZ, COPC, E57 o PLY, una carpeta, una nube de puntos virtual (.vpc) o capas de nube de puntos; coordenadas en metros.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Projected CRS in metres; empty takes that of the tiles, and a local frame if they declare none.</source>
      <translation>SRC proyectado en metros; vacío toma el de las teselas, y un sistema local si no declaran ninguno.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Label of this survey in all results, for example its date.</source>
      <translation>Nombre de este levantamiento en todos los resultados, por ejemplo su fecha.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Drives the temporal controller; empty takes the date of the first tile.</source>
      <translation>Gobierna el controlador temporal; vacío toma la fecha de la primera tesela.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Estimates both from the best-seen units and holds them: moulds differ by centimetres from the standard proportions.</source>
      <translation>Estima ambos con las piezas mejor vistas y los fija: los moldes difieren en centímetros de las proporciones estándar.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Catalogue name with the mass in tonnes, such as tetrapod 8 t; or tetrapod with a height of your own.</source>
      <translation>Nombre de catálogo con la masa en toneladas, como tetrapod 8 t; o tetrapod con altura propia.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>From the plane under three legs to the top of the fourth, in metres; overrides the catalogue.</source>
      <translation>Del plano bajo tres patas a la punta de la cuarta, en metros; prevalece sobre el catálogo.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Radius of a leg's cone at the unit's centre, in metres; empty takes 0.264 H.</source>
      <translation>Radio del cono de una pata en el centro de la pieza, en metros; vacío toma 0,264 H.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Loss of radius per metre along the leg's axis; empty takes 0.176.</source>
      <translation>Pérdida de radio por metro a lo largo del eje de la pata; vacío toma 0,176.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Built tetrapods are tetrahedral; 120° between leg 1 and the others repeats the published equations.</source>
      <translation>Los tetrápodos reales son tetraédricos; 120° entre la pata 1 y las demás repite las ecuaciones publicadas.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Polygon inside which units are looked for; its outer ring is used. Empty means everywhere.</source>
      <translation>Polígono dentro del cual se buscan piezas; se usa su anillo exterior. Vacío: en todas partes.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Polygons around surfaces that do not move, such as the crown wall: they tie epochs without control to the earliest with control, or to the first.</source>
      <translation>Polígonos alrededor de superficies que no se mueven, como el espaldón: enlazan las épocas sin control con la primera que lo tiene, o con la primera de todas.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>the survey itself tells</source>
      <translation>lo dice el propio levantamiento</translation>
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
      <translation>Los vuelos largos se doblan centímetros en decenas a cientos de metros. El propio levantamiento dice, por sus unidades y dianas, si la nube de una época está doblada; rígido la mantiene recta (emplazamientos cortos, una sola estación), elástico la deja doblarse ante cualquier indicio.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Blocks of the survey worked on at the same time; each takes about 1 GB of memory.</source>
      <translation>Bloques del levantamiento procesados a la vez; cada uno ocupa aproximadamente 1 GB de memoria.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Surveyed targets: point layer or CSV with point_id, easting, northing, height, sd_e, sd_n, sd_h (m).</source>
      <translation>Dianas medidas: capa de puntos o CSV con point_id, easting, northing, height, sd_e, sd_n, sd_h (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The same targets as measured in this epoch's cloud: point layer or CSV with point_id, x, y, z (m).</source>
      <translation>Las mismas dianas medidas en la nube de esta época: capa de puntos o CSV con point_id, x, y, z (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Surveyed joints of cones, for validation only: CSV or layer with point_id, unit_easting, unit_northing, unit_height and position (m).</source>
      <translation>Uniones de conos medidas, solo para validación: CSV o capa con point_id, unit_easting, unit_northing, unit_height y posición (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Give the height H of the unit, or choose a catalogue name with its mass, such as tetrapod 8 t.</source>
      <translation>Indique la altura H de la pieza, o elija un nombre de catálogo con su masa, como tetrapod 8 t.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The type of unit must be tetrapod, or a catalogue name such as tetrapod 8 t.</source>
      <translation>El tipo de pieza debe ser tetrapod, o un nombre de catálogo como tetrapod 8 t.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Control points and targets in the cloud belong together: give both, or neither.</source>
      <translation>Los puntos de control y las dianas en la nube van juntos: indique ambos o ninguno.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Time of the survey (UTC)</source>
      <translation>Hora del levantamiento (UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Epoch {label} (row {row})</source>
      <translation>Época {label} (fila {row})</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Calibrate radius and taper</source>
      <translation>Calibrar radio y conicidad</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Height H of the unit (m)</source>
      <translation>Altura H de la pieza (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Cone radius at the centre (m)</source>
      <translation>Radio del cono en el centro (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Taper of the leg</source>
      <translation>Conicidad de la pata</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Angle between the legs</source>
      <translation>Ángulo entre las patas</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Area of interest</source>
      <translation>Área de interés</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Stable areas</source>
      <translation>Áreas estables</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Frames of the epochs</source>
      <translation>Marcos de las épocas</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Worker processes</source>
      <translation>Procesos de trabajo</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The cone radius must be smaller than half the height of the unit.</source>
      <translation>El radio del cono debe ser menor que la mitad de la altura de la pieza.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The area of interest holds no polygon.</source>
      <translation>El área de interés no contiene ningún polígono.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The area of interest has several separate parts; give one polygon.</source>
      <translation>El área de interés tiene varias partes separadas; indique un solo polígono.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Virtual point clouds (*.vpc)</source>
      <translation>Nubes de puntos virtuales (*.vpc)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Epoch in row {row}</source>
      <translation>Época de la fila {row}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>tetrahedral (109.5°)</source>
      <translation>tetraédrico (109,5°)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>as in the paper (120°)</source>
      <translation>como en el artículo (120°)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{crs} is geographic; choose a projected CRS in metres.</source>
      <translation>{crs} es geográfico; elija un SRC proyectado en metros.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{where}: no point cloud is given.</source>
      <translation>{where}: no se indica ninguna nube de puntos.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The layers {one} and {other} have different CRS, and that of {one} is set by hand. Set the same one for both.</source>
      <translation>Las capas {one} y {other} tienen SRC distintos, y el de {one} se ha fijado a mano. Fije el mismo para ambas.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} cannot be written: {reason}.</source>
      <translation>No se puede escribir {layer}: {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} has no field {fields}; it has {present}.</source>
      <translation>{layer} no tiene el campo {fields}; tiene {present}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Point clouds ({endings})</source>
      <translation>Nubes de puntos ({endings})</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{where}: the folder {path} holds no point cloud (LAS, LAZ, COPC, E57, PLY).</source>
      <translation>{where}: la carpeta {path} no contiene nubes de puntos (LAS, LAZ, COPC, E57, PLY).</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} cannot be transformed to the CRS of the results: {reason}.</source>
      <translation>{layer} no se puede transformar al SRC de los resultados: {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>error as targets see it</source>
      <translation>error visto por las dianas</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>difference of two epochs as units see it</source>
      <translation>diferencia de dos épocas vista por las piezas</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>strip against its epoch</source>
      <translation>pasada respecto a su época</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>moved as one</source>
      <translation>se movió en bloque</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>no common motion that could be told</source>
      <translation>sin movimiento común discernible</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>found</source>
      <translation>encontrada</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>uncertain</source>
      <translation>incierta</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>new</source>
      <translation>nueva</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>relocated</source>
      <translation>arrastrada</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>stable</source>
      <translation>estable</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>moved</source>
      <translation>movida</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>rotated</source>
      <translation>girada</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>lost: the place is empty</source>
      <translation>perdida: el lugar está vacío</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>unseen: known from another epoch</source>
      <translation>no vista: conocida de otra época</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>unexplained points where a unit fits</source>
      <translation>puntos sin explicar donde cabe una pieza</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>hole where a unit fits</source>
      <translation>hueco donde cabe una pieza</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>below the detection limit</source>
      <translation>bajo el límite de detección</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>significant</source>
      <translation>significativo</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>watch</source>
      <translation>vigilar</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>alert or more</source>
      <translation>alerta o más</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>relocated unit</source>
      <translation>pieza arrastrada</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>uncertain unit</source>
      <translation>pieza incierta</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>missing end of a broken leg</source>
      <translation>extremo que falta de una pata rota</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>observed</source>
      <translation>observado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>derived from the rest of the unit</source>
      <translation>deducido del resto de la pieza</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>used</source>
      <translation>usado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>disturbed, not used</source>
      <translation>perturbado, no usado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>not used</source>
      <translation>no usado</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>check point</source>
      <translation>punto de comprobación</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>placeholder for a unit not found</source>
      <translation>marcador de una pieza no encontrada</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>place of a correction</source>
      <translation>lugar de una corrección</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>picked by hand</source>
      <translation>marcado a mano</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Outlines of the units</source>
      <translation>Contornos de las piezas</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Surfaces of the units (3D)</source>
      <translation>Superficies de las piezas (3D)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Placement of the units</source>
      <translation>Colocación de las piezas</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Gaps</source>
      <translation>Huecos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Feature points</source>
      <translation>Puntos característicos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Displacements</source>
      <translation>Desplazamientos</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Displacements, other pairs and datum</source>
      <translation>Desplazamientos, otros pares y otro datum</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Errors of bent frames</source>
      <translation>Errores de los marcos curvados</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Stretches that moved as one</source>
      <translation>Tramos que se movieron en bloque</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Control residuals</source>
      <translation>Residuos de control</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Check residuals</source>
      <translation>Residuos de comprobación</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Reviews</source>
      <translation>Revisiones</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Corrections and placeholders</source>
      <translation>Correcciones y marcadores</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Points picked by hand</source>
      <translation>Puntos marcados a mano</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>watch: over {length}</source>
      <translation>vigilar: más de {length}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>alert or more: over {length}</source>
      <translation>alerta o más: más de {length}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>arrow of 10 mm: {length}, at most 30 mm long; ellipse: 95 %</source>
      <translation>flecha de 10 mm: {length}, como máximo 30 mm; elipse: 95 %</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>Which displacement a planned survey detects</source>
      <translation>Qué desplazamiento detecta un levantamiento previsto</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>A unit that moves by {length} in its worst direction is found with the chosen power; the mark in the chart.</source>
      <translation>Una pieza que se mueve {length} en su peor dirección se encuentra con la potencia elegida; la marca del gráfico.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>{share} % of a unit seen</source>
      <translation>{share} % de una pieza vista</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>Detectable displacement ({unit})</source>
      <translation>Desplazamiento detectable ({unit})</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>The epochs and the unit given</source>
      <translation>Las épocas y la pieza indicadas</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>{table}, row {row}</source>
      <translation>{table}, fila {row}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>{table}, field names</source>
      <translation>{table}, nombres de los campos</translation>
    </message>
    <message>
      <location filename="../algorithms/survey_algorithm.py" />
      <source>The tiles declare no CRS: results are in a local frame. Choose the CRS of the results to change that.</source>
      <translation>Las teselas no declaran SRC: los resultados están en un sistema local. Elija el SRC de los resultados para cambiarlo.</translation>
    </message>
    <message>
      <location filename="../algorithms/survey_algorithm.py" />
      <source>Epoch {label}</source>
      <translation>Época {label}</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Track displacements</source>
      <translation>Seguir desplazamientos</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Recognises each unit in all epochs, finds the stable units by a global congruence test and tests the displacement of every feature point and the rotation of every unit against it, with the covariance of fit and registration.</source>
      <translation>Reconoce cada pieza en todas las épocas, halla las piezas estables con una prueba global de congruencia y prueba frente a ellas el desplazamiento de cada punto característico y el giro de cada pieza, con la covarianza del ajuste y del registro.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>A rotation near 60° or more is ambiguous by the symmetry of the tetrapod and is reported as such.</source>
      <translation>Un giro cercano a 60° o mayor es ambiguo por la simetría del tetrápodo y se indica como tal.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>displacement,deformation analysis,congruence test,epoch,monitoring</source>
      <translation>desplazamiento,análisis de deformación,prueba de congruencia,época,seguimiento</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Layers of units from Fit tetrapods: one per epoch, each with its own label and time, all in one CRS.</source>
      <translation>Capas de piezas de Ajustar tetrápodos: una por época, cada una con su nombre y hora, todas en un SRC.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>GeoPackages from Register to control, one per epoch; without them the clouds' own frames are taken as registered.</source>
      <translation>GeoPackages de Registrar al control, uno por época; sin ellos los sistemas propios de las nubes se toman por registrados.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Fitted units of all epochs</source>
      <translation>Piezas ajustadas de todas las épocas</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Registrations</source>
      <translation>Registros</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Give the units of at least two epochs.</source>
      <translation>Indique las piezas de al menos dos épocas.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>The layers of units have different CRS: {crs}.</source>
      <translation>Las capas de piezas tienen SRC distintos: {crs}.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>no CRS</source>
      <translation>sin SRC</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Validate against check points</source>
      <translation>Validar con puntos de comprobación</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Compares feature points of one epoch with the same points surveyed by total station or GNSS. Check points never take part in the fit: their differences show the accuracy that was reached.</source>
      <translation>Compara los puntos característicos de una época con los mismos puntos medidos con estación total o GNSS. Los puntos de comprobación nunca entran en el ajuste: sus diferencias muestran la exactitud lograda.</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>A check point is matched by the approximate centre of its unit; one that matches no unit is named and left out.</source>
      <translation>Un punto de comprobación se empareja por el centro aproximado de su pieza; el que no encuentra ninguna se nombra y se omite.</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>validation,accuracy,check points,total station,GNSS,RMSE</source>
      <translation>validación,exactitud,puntos de comprobación,estación total,GNSS,EMC</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Layer from Extract feature points, of one epoch.</source>
      <translation>Capa de Extraer puntos característicos, de una época.</translation>
    </message>
    <message>
      <location filename="../plugin/engine_task.py" />
      <source>Cancelled.</source>
      <translation>Cancelado.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Creating the tetratrack engine</source>
      <translation>Creando el motor tetratrack</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Another window of QGIS is creating the engine at this moment.</source>
      <translation>Otra ventana de QGIS está creando el motor en este momento.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Making an empty environment</source>
      <translation>Creando un entorno vacío</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Trying the libraries</source>
      <translation>Probando las bibliotecas</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine's environment could not be created: {reason} (everything that was said: {log})</source>
      <translation>No se pudo crear el entorno del motor: {reason} (toda la salida: {log})</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Compiling, so that the first run need not wait</source>
      <translation>Compilando, para que la primera ejecución no espere</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Looking for the libraries</source>
      <translation>Buscando las bibliotecas</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Fetching {name}: {done} of about {all} MB</source>
      <translation>Descargando {name}: {done} de unos {all} MB</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Unpacking libraries: {count} of {all}</source>
      <translation>Descomprimiendo bibliotecas: {count} de {all}</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine needs {needed} GB on the disk of {folder}, and {free} GB are free.</source>
      <translation>El motor necesita {needed} GB en el disco de {folder}, y hay {free} GB libres.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>{wheels} holds no wheels.</source>
      <translation>{wheels} no contiene ningún wheel.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>{wheels} lacks {count} of the wheels that this version of the plugin needs: {names}.</source>
      <translation>Faltan en {wheels} {count} de los wheels que necesita esta versión del complemento: {names}.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine in use cannot be replaced now: wait until its runs have ended.</source>
      <translation>El motor en uso no se puede sustituir ahora: espere a que terminen sus ejecuciones.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Unpacking {file}</source>
      <translation>Descomprimiendo {file}</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Choose a file…</source>
      <translation>Elegir un archivo…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Add an epoch</source>
      <translation>Añadir una época</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Remove the selected epochs</source>
      <translation>Quitar las épocas seleccionadas</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>user-defined</source>
      <translation>personalizado</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Choose…</source>
      <translation>Elegir…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Table of points</source>
      <translation>Tabla de puntos</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Tables (*.csv *.txt *.gpkg);;All files (*)</source>
      <translation>Tablas (*.csv *.txt *.gpkg);;Todos los archivos (*)</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Files…</source>
      <translation>Archivos…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Folder…</source>
      <translation>Carpeta…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Layer {name}</source>
      <translation>Capa {name}</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_wrapper.py" />
      <source>{count} epochs…</source>
      <translation>{count} épocas…</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Arrows move, + and - zoom, Home resets; Enter picks the point in the middle</source>
      <translation>Las flechas mueven, + y - amplían, Inicio restablece; Intro elige el punto del centro</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Plan of the unit</source>
      <translation>Planta de la unidad</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Section of the unit</source>
      <translation>Sección de la unidad</translation>
    </message>
    <message>
      <location filename="../plugin/length_widget.py" />
      <source>Length in the project's unit</source>
      <translation>Longitud en la unidad del proyecto</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python 3.11 to 3.13 was not found: install it, or choose an interpreter of the engine above.</source>
      <translation>No se encontró Python 3.11 a 3.13: instálelo o elija arriba un intérprete del motor.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create a Python environment in {folder} and download libraries into it? It takes about {size} of disk.</source>
      <translation>¿Crear un entorno de Python en {folder} y descargar bibliotecas en él? Ocupa unos {size} de disco.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create a Python environment in {folder} from the wheels in {wheels}? It takes about {size} of disk.</source>
      <translation>¿Crear un entorno de Python en {folder} a partir de los wheels de {wheels}? Ocupa unos {size} de disco.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Try again…</source>
      <translation>Reintentar…</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python interpreter of the engine</source>
      <translation>Intérprete de Python del motor</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Empty uses the environment that the plugin creates; a folder of an environment will do.</source>
      <translation>Vacío usa el entorno que crea el complemento; sirve la carpeta de un entorno.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Folder or ZIP of wheels</source>
      <translation>Carpeta o ZIP de wheels</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>For computers without a network: what was fetched on another one. Empty fetches the libraries.</source>
      <translation>Para equipos sin red: lo descargado en otro equipo. Vacío descarga las bibliotecas.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create the engine's environment…</source>
      <translation>Crear el entorno del motor…</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Cancel</source>
      <translation>Cancelar</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Show the log</source>
      <translation>Mostrar el registro</translation>
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
      <translation>El motor está listo.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} is no file.</source>
      <translation>{python} no es un archivo.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} is no Python interpreter.</source>
      <translation>{python} no es un intérprete de Python.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} is Python {version}; the engine needs 3.11 or later.</source>
      <translation>{python} es Python {version}; el motor necesita 3.11 o posterior.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} lacks the engine's libraries: {modules}.</source>
      <translation>A {python} le faltan las bibliotecas del motor: {modules}.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Used: {python}</source>
      <translation>En uso: {python}</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Can be used: {python}</source>
      <translation>Se puede usar: {python}</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the disk is full</source>
      <translation>el disco está lleno</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>this Python cannot make environments; on Debian and Ubuntu install python3-venv first</source>
      <translation>este Python no puede crear entornos; en Debian y Ubuntu instale antes python3-venv</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy wants a user name and password: state them in Settings &gt; Options &gt; Network</source>
      <translation>el proxy pide usuario y contraseña: indíquelos en Configuración &gt; Opciones &gt; Red</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy is of the kind SOCKS, which the installer does not know; choose a folder of wheels</source>
      <translation>el proxy es de tipo SOCKS, que el instalador no conoce; elija una carpeta de wheels</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the registry's certificate is not trusted: import your network's authority in Settings &gt; Options &gt; Authentication</source>
      <translation>el certificado del repositorio no es de confianza: importe la autoridad de su red en Configuración &gt; Opciones &gt; Autenticación</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy cannot be reached: see Settings &gt; Options &gt; Network</source>
      <translation>no se puede alcanzar el proxy: vea Configuración &gt; Opciones &gt; Red</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>a file is not the one that this version of the plugin needs: it was damaged or changed on its way; try again</source>
      <translation>un archivo no es el que necesita esta versión del complemento: se dañó o cambió por el camino; inténtelo de nuevo</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the connection broke while a file was fetched; try again, what is complete is not fetched twice</source>
      <translation>la conexión se cortó mientras se descargaba un archivo; inténtelo de nuevo, lo completo no se descarga dos veces</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>no package registry can be reached from this computer; without a network choose a folder of wheels</source>
      <translation>no se puede alcanzar ningún repositorio de paquetes desde este equipo; sin red elija una carpeta de wheels</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>a library of the system is missing; on Debian and Ubuntu install libegl1 libgl1 libgomp1</source>
      <translation>falta una biblioteca del sistema; en Debian y Ubuntu instale libegl1 libgl1 libgomp1</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>Displacements of armour units</source>
      <translation>Desplazamientos de las piezas del manto</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>Legend</source>
      <translation>Leyenda</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>{pair}, datum: {datum}</source>
      <translation>{pair}, referencia: {datum}</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Ended: nothing was stored.</source>
      <translation>Terminado: no se guardó nada.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints</source>
      <translation>Fijar por tres uniones</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fit again after a click on the unit (earlier epoch)</source>
      <translation>Ajustar de nuevo tras un clic en la pieza (época anterior)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fit again after a click on the unit (later epoch)</source>
      <translation>Ajustar de nuevo tras un clic en la pieza (época posterior)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints of legs (earlier epoch)</source>
      <translation>Fijar por tres uniones de patas (época anterior)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints of legs (later epoch)</source>
      <translation>Fijar por tres uniones de patas (época posterior)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pick feature points beside the fit (earlier epoch)</source>
      <translation>Señalar puntos característicos junto al ajuste (época anterior)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pick feature points beside the fit (later epoch)</source>
      <translation>Señalar puntos característicos junto al ajuste (época posterior)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Placeholder for a unit not found</source>
      <translation>Marcador de una pieza no encontrada</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Merge the two selected units</source>
      <translation>Fusionar las dos piezas seleccionadas</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Split at the later epoch: two units taken for one</source>
      <translation>Dividir en la época posterior: dos piezas tomadas por una</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Delete: not a unit</source>
      <translation>Eliminar: no es una pieza</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Take back your last correction</source>
      <translation>Deshacer su última corrección</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Read the points around the units…</source>
      <translation>Leer los puntos alrededor de las piezas…</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The points around the units are needed: read them from the correction menu.</source>
      <translation>Hacen falta los puntos alrededor de las piezas: léalos desde el menú de corrección.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>There are no points here; click on the cloud.</source>
      <translation>Aquí no hay puntos; haga clic sobre la nube.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The unit has no pose in any epoch to take its size from.</source>
      <translation>La pieza no tiene pose en ninguna época de la que tomar su tamaño.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Nothing was stored: pick the three joints again.</source>
      <translation>No se guardó nada: marque de nuevo las tres uniones.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>pinned by three joints</source>
      <translation>fijada por tres uniones</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The three points do not fit the shape of {unit}: they are {misfit} off, where {worst} would be usual. Were they joints of this unit? Store the pose all the same?</source>
      <translation>Los tres puntos no encajan con la forma de {unit}: se desvían {misfit}, cuando lo habitual sería {worst}. ¿Eran uniones de esta pieza? ¿Guardar la pose de todos modos?</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The unit was not found in this epoch: pin it by three joints instead.</source>
      <translation>La pieza no se encontró en esta época: fíjela por tres uniones.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Select the two units to merge.</source>
      <translation>Seleccione las dos piezas que se fusionan.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>There is no correction of yours to take back.</source>
      <translation>No hay ninguna corrección suya que deshacer.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Survey description</source>
      <translation>Descripción del levantamiento</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Survey (*.toml)</source>
      <translation>Levantamiento (*.toml)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Reading points around units</source>
      <translation>Leyendo puntos alrededor de las piezas</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Points read.</source>
      <translation>Puntos leídos.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Select a unit first.</source>
      <translation>Seleccione primero una pieza.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click the middle of the unit on the map or in a view; Escape ends.</source>
      <translation>Haga clic en el centro de la pieza en el mapa o en una vista; Escape termina.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click three joints where three legs meet, on the map or in the views; Escape ends.</source>
      <translation>Haga clic en tres uniones donde se encuentran tres patas, en el mapa o en las vistas; Escape termina.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click a joint where three legs meet; Escape ends.</source>
      <translation>Haga clic en una unión donde se encuentran tres patas; Escape termina.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click where the unit lies on the map; Escape ends.</source>
      <translation>Haga clic donde está la pieza en el mapa; Escape termina.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fitting {unit} again</source>
      <translation>Ajustando {unit} de nuevo</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} was fitted again.</source>
      <translation>{unit} se ajustó de nuevo.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} pinned; the picks fit within {length}.</source>
      <translation>{unit} fijada; las marcas encajan dentro de {length}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{feature} picked, {length} from the fit.</source>
      <translation>{feature} señalado, a {length} del ajuste.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Placeholder {name} stored; it counts as a unit not found.</source>
      <translation>Marcador {name} guardado; cuenta como pieza no encontrada.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{count} of 3 joints.</source>
      <translation>{count} de 3 uniones.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{other} is now {keep}.</source>
      <translation>{other} es ahora {keep}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} is called {name} from {epoch} on.</source>
      <translation>{unit} se llama {name} desde {epoch}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} was deleted; take it back from the correction menu.</source>
      <translation>{unit} se eliminó; recupérela desde el menú de corrección.</translation>
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
        <numerusform>%n significativa</numerusform>
        <numerusform>%n significativas</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n decided</source>
      <translation>
        <numerusform>%n decidida</numerusform>
        <numerusform>%n decididas</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n rejected, excluded from statistics and map</source>
      <translation>
        <numerusform>%n rechazada, fuera de estadísticas y mapa</numerusform>
        <numerusform>%n rechazadas, fuera de estadísticas y mapa</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Leg</source>
      <translation>Pata</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Its end</source>
      <translation>Su extremo</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Probability of a break</source>
      <translation>Probabilidad de rotura</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Points to</source>
      <translation>Apunta a</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Check point</source>
      <translation>Punto de comprobación</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Feature</source>
      <translation>Punto característico</translation>
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
      <translation>Diferencia</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n lost</source>
      <translation>
        <numerusform>%n perdida</numerusform>
        <numerusform>%n perdidas</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n new</source>
      <translation>
        <numerusform>%n nueva</numerusform>
        <numerusform>%n nuevas</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n with a broken leg</source>
      <translation>
        <numerusform>%n con una pata rota</numerusform>
        <numerusform>%n con una pata rota</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>3D displacement</source>
      <translation>Desplazamiento 3D</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>in heights H, in nominal diameters Dn</source>
      <translation>en alturas H, en diámetros nominales Dn</translation>
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
      <translation>no significativo</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Detection limit</source>
      <translation>Límite de detección</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{length}, towards {azimuth}° from grid north</source>
      <translation>{length}, hacia {azimuth}° desde el norte de la cuadrícula</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Score of the fit, 0 to 1</source>
      <translation>Puntuación del ajuste, 0 a 1</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Legs seen, of four</source>
      <translation>Patas vistas, de cuatro</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Broken legs</source>
      <translation>Patas rotas</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Ends not seen, of legs</source>
      <translation>Extremos no vistos, de las patas</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n of {all} units shown</source>
      <translation>
        <numerusform>%n de {all} piezas mostrada</numerusform>
        <numerusform>%n de {all} piezas mostradas</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>none: one of the two positions is not known</source>
      <translation>ninguno: una de las dos posiciones es desconocida</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Test against no motion</source>
      <translation>Prueba frente a inmovilidad</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Missing ({unit})</source>
      <translation>Falta ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Check points ({unit})</source>
      <translation>Puntos de comprobación ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Nobody has decided on this unit yet.</source>
      <translation>Nadie ha decidido aún sobre esta pieza.</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>largest {length}</source>
      <translation>máximo {length}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Seen in {epoch}</source>
      <translation>Visto en {epoch}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Legs</source>
      <translation>Patas</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Points to: degrees from grid north, and above the horizon</source>
      <translation>Apunta a: grados desde el norte de la cuadrícula, y sobre el horizonte</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>± one standard deviation</source>
      <translation>± una desviación típica</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Picked by hand</source>
      <translation>Señalado a mano</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>taken back by {who}</source>
      <translation>deshecho por {who}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{feature}, {epoch}: picked {length} from the fit ({who})</source>
      <translation>{feature}, {epoch}: señalado a {length} del ajuste ({who})</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_dock.py" />
      <source>%n units</source>
      <translation>
        <numerusform>%n pieza</numerusform>
        <numerusform>%n piezas</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Displacement review</source>
      <translation>Revisión de desplazamientos</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Open a result</source>
      <translation>Abrir un resultado</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>GeoPackage (*.gpkg)</source>
      <translation>GeoPackage (*.gpkg)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Previous unit (Up, or P for the previous undecided)</source>
      <translation>Pieza anterior (Arriba, o P para la anterior sin decidir)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Next unit (Down, or N for the next undecided)</source>
      <translation>Pieza siguiente (Abajo, o N para la siguiente sin decidir)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Zoom to the unit and flash it (Z)</source>
      <translation>Acercar a la pieza y destellarla (Z)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The map follows the selection</source>
      <translation>El mapa sigue a la selección</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Show all units</source>
      <translation>Mostrar todas las piezas</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>A click on the map picks the unit or arrow there</source>
      <translation>Un clic en el mapa elige la pieza o la flecha que hay allí</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Correct a unit</source>
      <translation>Corregir una pieza</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Write the report…</source>
      <translation>Escribir el informe…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Report with more choices…</source>
      <translation>Informe con más opciones…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>A page to print, with the map as it stands</source>
      <translation>Una página para imprimir, con el mapa tal como está</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Export the alarm list…</source>
      <translation>Exportar la lista de alarmas…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Web page (*.html);;PDF (*.pdf)</source>
      <translation>Página web (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Alarm list</source>
      <translation>Lista de alarmas</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>CSV (*.csv);;GeoJSON (*.geojson)</source>
      <translation>CSV (*.csv);;GeoJSON (*.geojson)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Decisions of another reviewer were taken in.</source>
      <translation>Se incorporaron decisiones de otro revisor.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Corrections of another reviewer were taken in.</source>
      <translation>Se incorporaron las correcciones de otro revisor.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>A run replaced the result: its numbers are shown now.</source>
      <translation>Un cálculo ha sustituido el resultado: ahora se muestran sus valores.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>In polygons</source>
      <translation>En polígonos</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>No unit passes the filter.</source>
      <translation>Ninguna pieza pasa el filtro.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Enter your name or initials first: they stand beside every decision.</source>
      <translation>Introduzca primero su nombre o iniciales: figuran junto a cada decisión.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Confirmed.</source>
      <translation>Confirmado.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Writing the report</source>
      <translation>Escribiendo el informe</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Threshold ({unit})</source>
      <translation>Umbral ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{name} was closed with its layers. Every decision is stored: open it again to go on.</source>
      <translation>{name} se cerró con sus capas. Todas las decisiones están guardadas: ábralo de nuevo para continuar.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Make a polygon layer active first.</source>
      <translation>Active primero una capa de polígonos.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The active layer holds no polygon.</source>
      <translation>La capa activa no contiene ningún polígono.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>In the map window</source>
      <translation>En la ventana del mapa</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Everywhere</source>
      <translation>En todas partes</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The page {name} is in the project's layouts.</source>
      <translation>La página {name} está en las composiciones del proyecto.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{title}…</source>
      <translation>{title}…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{name} is read-only: you can look, but decisions cannot be stored.</source>
      <translation>{name} es de solo lectura: puede mirar, pero no se pueden guardar decisiones.</translation>
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
      <translation>Informe escrito en {name}.</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_dock.py" />
      <source>Units written to {name}: %n.</source>
      <translation>
        <numerusform>%n pieza escrita en {name}.</numerusform>
        <numerusform>%n piezas escritas en {name}.</numerusform>
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
      <translation>Modelo, secciones y proyecto</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Export as-built model…</source>
      <translation>Exportar modelo as-built…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Compare with design…</source>
      <translation>Comparar con el proyecto…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Cross-sections and crest…</source>
      <translation>Secciones y coronación…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Points less blocks…</source>
      <translation>Puntos menos piezas…</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Units reviewed</source>
      <translation>Piezas revisadas</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements reviewed</source>
      <translation>Desplazamientos revisados</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements reviewed, other pair or datum</source>
      <translation>Desplazamientos revisados, otro par o datum</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Rejected units (excluded)</source>
      <translation>Piezas rechazadas (excluidas)</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Placeholders and corrections</source>
      <translation>Marcadores y correcciones</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacement review: {name}</source>
      <translation>Revisión de desplazamientos: {name}</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements: {datum}</source>
      <translation>Desplazamientos: {datum}</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Epochs compared</source>
      <translation>Épocas comparadas</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>All classes</source>
      <translation>Todas las clases</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Classes shown</source>
      <translation>Clases mostradas</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Least 3D displacement shown; lost, new and relocated units are always shown</source>
      <translation>Menor desplazamiento 3D mostrado; las piezas perdidas, nuevas y arrastradas se muestran siempre</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Area of the units shown</source>
      <translation>Área de las piezas mostradas</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Undecided only</source>
      <translation>Solo sin decidir</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>On the map too</source>
      <translation>También en el mapa</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The map shows only the units that the list shows</source>
      <translation>El mapa muestra solo las piezas que muestra la lista</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Unit…</source>
      <translation>Pieza…</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Comment, stored with the decision</source>
      <translation>Comentario, guardado con la decisión</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Your name or initials, stored with every decision</source>
      <translation>Su nombre o iniciales, guardados con cada decisión</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>In the active layer's polygons</source>
      <translation>En los polígonos de la capa activa</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Accept</source>
      <translation>Aceptar</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The displacement is right (A)</source>
      <translation>El desplazamiento es correcto (A)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Reject</source>
      <translation>Rechazar</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The displacement is wrong: it leaves statistics, maps and report (R)</source>
      <translation>El desplazamiento es erróneo: sale de estadísticas, mapas e informe (R)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Inspect</source>
      <translation>Inspeccionar</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Inspect on site (I)</source>
      <translation>Inspeccionar en el lugar (I)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Confirm</source>
      <translation>Confirmar</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Confirm another reviewer's decision (C)</source>
      <translation>Confirmar la decisión de otro revisor (C)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Undo</source>
      <translation>Deshacer</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Take back your last decision (U)</source>
      <translation>Retirar su última decisión (U)</translation>
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
      <translation>Seleccione una pieza</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>N</source>
      <translation>N</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Section {azimuth}°</source>
      <translation>Sección {azimuth}°</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Series</source>
      <translation>Serie</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Section along the displacement</source>
      <translation>Sección a lo largo del desplazamiento</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Direction of the section, from grid north; each outline is cut through its own centre</source>
      <translation>Dirección de la sección, desde el norte de la cuadrícula; cada contorno se corta por su propio centro</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Read the points…</source>
      <translation>Leer los puntos…</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Reads the points around the units from the tiles of the survey, for the views and for picking</source>
      <translation>Lee de las teselas del levantamiento los puntos alrededor de las piezas, para las vistas y el marcado</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Numbers</source>
      <translation>Números</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>History</source>
      <translation>Historial</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>points not read yet</source>
      <translation>puntos aún no leídos</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>lost</source>
      <translation>perdida</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>unseen</source>
      <translation>no vista</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>deleted</source>
      <translation>eliminada</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>merged</source>
      <translation>fusionada</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>split</source>
      <translation>dividida</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>new pose</source>
      <translation>nueva pose</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>points picked</source>
      <translation>puntos marcados</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>placeholder</source>
      <translation>marcador</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Displ.</source>
      <translation>Despl.</translation>
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
      <translation>Giro</translation>
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
      <translation>Rotas</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Name of the unit, the same in all epochs</source>
      <translation>Nombre de la pieza, el mismo en todas las épocas</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Class of the displacement, or the unit's fate</source>
      <translation>Clase del desplazamiento, o destino de la pieza</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Rotation between the epochs (degrees)</source>
      <translation>Giro entre las épocas (grados)</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Probability of so large a displacement if the unit stood still; bold where significant</source>
      <translation>Probabilidad de un desplazamiento tan grande si la pieza no se movió; en negrita si es significativo</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Share of the unit's surface that holds points, in the worse epoch</source>
      <translation>Parte de la superficie de la pieza que tiene puntos, en la peor época</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Numbers of the legs that are broken; the page Numbers says how sure that is, and which ends are not seen</source>
      <translation>Números de las patas rotas; la página Números dice con qué certeza, y qué extremos no se ven</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Decision of the reviewers</source>
      <translation>Decisión de los revisores</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Who decided, and ✓ who confirmed</source>
      <translation>Quién decidió, y ✓ quién confirmó</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>whole</source>
      <translation>entera</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>broken</source>
      <translation>rota</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>not seen</source>
      <translation>no se ve</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>accepted</source>
      <translation>aceptado</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>rejected</source>
      <translation>rechazado</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>inspect</source>
      <translation>inspeccionar</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>decided</source>
      <translation>decidió</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>confirmed</source>
      <translation>confirmó</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>took back</source>
      <translation>retiró</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>changed the numbers, which ended</source>
      <translation>cambió las cifras, lo que puso fin a</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>brought back the numbers of</source>
      <translation>restableció las cifras de</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>3D displacement of the centre ({unit})</source>
      <translation>Desplazamiento 3D del centro ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Horizontal displacement of the centre ({unit})</source>
      <translation>Desplazamiento horizontal del centro ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Vertical displacement of the centre, positive up ({unit})</source>
      <translation>Desplazamiento vertical del centro, positivo hacia arriba ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>3D displacement since {epoch} ({unit}), bands of 95 %</source>
      <translation>Desplazamiento 3D desde {epoch} ({unit}), bandas del 95 %</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>No displacement of this unit</source>
      <translation>Sin desplazamiento de esta pieza</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>centre</source>
      <translation>centro</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>detection limit</source>
      <translation>límite de detección</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Open result…</source>
      <translation>Abrir resultado…</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Take the point cloud layers</source>
      <translation>Tomar las capas de nubes de puntos</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>The files of the project's point cloud layers, in place of a folder</source>
      <translation>Los archivos de las capas de nubes de puntos del proyecto, en lugar de una carpeta</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>estimated from the cloud</source>
      <translation>estimada a partir de la nube</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>as the tiles declare</source>
      <translation>como declaran las teselas</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Run</source>
      <translation>Ejecutar</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Open the result.gpkg of a survey with two epochs or more to review its displacements.</source>
      <translation>Abra el result.gpkg de un levantamiento con dos épocas o más para revisar sus desplazamientos.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Or make one: choose the folder that holds the tiles of all epochs, look through the table, press Run.</source>
      <translation>O cree uno: elija la carpeta con las teselas de todas las épocas, repase la tabla y pulse Ejecutar.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Height H of the unit</source>
      <translation>Altura H de la pieza</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Looking at the tiles</source>
      <translation>Examinando las teselas</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Writing the survey</source>
      <translation>Escribiendo el levantamiento</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>The project has no point cloud layer that lies in a file: choose a folder instead.</source>
      <translation>El proyecto no tiene ninguna capa de nube de puntos en un archivo: elija una carpeta.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Choose where the result is to be written.</source>
      <translation>Elija dónde escribir el resultado.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Answer first what is asked above.</source>
      <translation>Responda primero a lo que se pregunta arriba.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Units of {heights} m height.</source>
      <translation>Piezas de {heights} m de altura.</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Monitor a survey…</source>
      <translation>Seguir un levantamiento…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Try the sample…</source>
      <translation>Probar el ejemplo…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Engine…</source>
      <translation>Motor…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>An engine is needed before anything can be computed.</source>
      <translation>Se necesita un motor antes de calcular nada.</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>The sample cannot be copied to {folder}: {reason}.</source>
      <translation>El ejemplo no se puede copiar en {folder}: {reason}.</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>Tetrapods in 3D</source>
      <translation>Tetrápodos en 3D</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>Displacements in 3D</source>
      <translation>Desplazamientos en 3D</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>significant displacement, enlarged {scale} times</source>
      <translation>desplazamiento significativo, ampliado {scale} veces</translation>
    </message>
    <message>
      <location filename="../core/report/templates/report.html" />
      <source>a local frame</source>
      <translation>un sistema local</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>Blocks</source>
      <translation>Piezas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>View of the blocks by class</source>
      <translation>Vista de las piezas por clase</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>Fitted units of {epoch} by class, seen from the low side.</source>
      <translation>Piezas ajustadas de {epoch} por clase, vistas desde el lado bajo.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Castings</source>
      <translation>Piezas hormigonadas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Mould {name} of an earlier survey, of {units} units, is held.</source>
      <translation>Se mantiene el molde {name} de un levantamiento anterior, de {units} piezas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>The mould was learned from {units} units of this survey.</source>
      <translation>El molde se determinó a partir de {units} piezas de este levantamiento.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>H = {height} m: radius {radius} m, taper {taper}. Size of single castings ± {size}, radius of single legs ± {leg} mm (one standard deviation).</source>
      <translation>H = {height} m: radio {radius} m, conicidad {taper}. Tamaño de las piezas ± {size}, radio de las patas ± {leg} mm (una desviación estándar).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Departure of the mould from its cones: along a leg, and unrolled around it. What is alike on all units is held; how single castings differ widens the standard deviations where two epochs see other surfaces.</source>
      <translation>Desviación del molde respecto de sus conos: a lo largo de una pata y desarrollada alrededor. Lo común a todas las piezas se mantiene; lo que las distingue amplía las desviaciones estándar donde dos épocas ven otras superficies.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Too few units show enough of themselves for a mould: cones are held, and castings vary as the literature says.</source>
      <translation>Muy pocas piezas se ven lo suficiente para un molde: se mantienen los conos, y las piezas varían como dice la bibliografía.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs seen whole: {whole}, broken: {broken}; the ends of {unseen} are not seen, and nothing is said of them.</source>
      <translation>Patas vistas enteras: {whole}, rotas: {broken}; el extremo de {unseen} no se ve, y nada se dice de ellas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Broken leg</source>
      <translation>Pata rota</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Missing (m)</source>
      <translation>Falta (m)</translation>
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
      <translation>Altura (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs whose ends are not seen</source>
      <translation>Patas cuyo extremo no se ve</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Whither a leg points: degrees from grid north clockwise, and above the horizon. The place is that of the face of fracture, or of the leg's whole end where the result does not say how much of it is missing.</source>
      <translation>Hacia dónde apunta una pata: grados desde el norte de la cuadrícula en sentido horario, y sobre el horizonte. La posición es la de la cara de rotura, o la del extremo de la pata entera cuando el resultado no dice cuánto falta.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs by section along the axis</source>
      <translation>Patas por sección a lo largo del eje</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Chainage (m)</source>
      <translation>Progresiva (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Units with a broken leg</source>
      <translation>Piezas con una pata rota</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs seen whole</source>
      <translation>Patas vistas enteras</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Ends not seen</source>
      <translation>Extremos no vistos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>The result was made by a version that said nothing of legs.</source>
      <translation>El resultado procede de una versión que nada decía de las patas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Comparison with surveyed check points</source>
      <translation>Comparación con los puntos de comprobación medidos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Picked by hand (cm)</source>
      <translation>Señalado a mano (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Fitting (cm)</source>
      <translation>Ajuste (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Surveyed (cm)</source>
      <translation>Medido (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Error, picked (cm)</source>
      <translation>Error, señalado (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Error, fitting (cm)</source>
      <translation>Error, ajuste (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>3D displacements of the same feature point, in the control frame (after Chan and Lichti, Table 1).</source>
      <translation>Desplazamientos 3D del mismo punto característico, en el sistema de control (según Chan and Lichti, tabla 1).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>The survey has no check points that both epochs share.</source>
      <translation>El levantamiento no tiene puntos de comprobación comunes a ambas épocas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Survey control</source>
      <translation>Control topográfico</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Congruence of the stable units</source>
      <translation>Congruencia de las piezas estables</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Units that stand still together: {stable} of {all}; test of their congruence: p {p}.</source>
      <translation>Piezas inmóviles en conjunto: {stable} de {all}; prueba de su congruencia: p {p}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Their common motion against the control points: east {e}, north {n}, up {h} cm; p {p}.</source>
      <translation>Su movimiento común respecto a los puntos de control: este {e}, norte {n}, arriba {h} cm; p {p}.</translation>
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
      <translation>Altura (mm)</translation>
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
      <translation>Residuos del registro; w es el mayor residuo normalizado de las tres coordenadas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>There is no survey control: displacements are relative to the frame of the clouds.</source>
      <translation>No hay control topográfico: los desplazamientos se refieren al sistema de las nubes.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Damage</source>
      <translation>Daños</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>H = {height} m, Dn = {diameter} m. Lost and relocated units count as displaced by every threshold.</source>
      <translation>H = {height} m, Dn = {diameter} m. Las piezas perdidas y arrastradas cuentan como desplazadas en todos los umbrales.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Displaced by at least</source>
      <translation>Desplazada al menos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Threshold (m)</source>
      <translation>Umbral (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Share</source>
      <translation>Parte</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>State of the armour in the words of Campos et al. (2020):</source>
      <translation>Estado del manto en los términos de Campos et al. (2020):</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>No damage: no unit moved by one Dn or is lost. Initiation of damage: some did. Iribarren's damage: neighbours of the outer layer did. Initiation of destruction: a unit of the layer below did. Destruction cannot be told from units.</source>
      <translation>Sin daño: ninguna pieza se movió un Dn ni se perdió. Inicio de avería: algunas. Avería de Iribarren: vecinas de la capa exterior. Inicio de destrucción: una pieza de la capa inferior. La destrucción no se ve por las piezas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>over {width} m: units displaced by one Dn or more, relocated or lost, per Dn of width (van der Meer, 1988).</source>
      <translation>en {width} m: piezas desplazadas un Dn o más, arrastradas o perdidas, por Dn de ancho (van der Meer, 1988).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Sections along the axis</source>
      <translation>Secciones a lo largo del eje</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Share of displaced units per section</source>
      <translation>Parte de piezas desplazadas por sección</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>No unit has a displacement to show.</source>
      <translation>Ninguna pieza tiene desplazamiento que mostrar.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>Decisions and corrections</source>
      <translation>Decisiones y correcciones</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>inspect on site</source>
      <translation>inspeccionar en el lugar</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>No reviewer has decided on this epoch pair.</source>
      <translation>Ningún revisor ha decidido sobre este par de épocas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>Correction</source>
      <translation>Corrección</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>By</source>
      <translation>Por</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>As-built against design</source>
      <translation>Construido frente al proyecto</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Map of the units against the design</source>
      <translation>Mapa de las piezas frente al proyecto</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units of {epoch} against the design; coordinates in {crs}.</source>
      <translation>Piezas de {epoch} frente al proyecto; coordenadas en {crs}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units at a planned place</source>
      <translation>Piezas en un lugar previsto</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Within the tolerance</source>
      <translation>Dentro de la tolerancia</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Outside the tolerance</source>
      <translation>Fuera de la tolerancia</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Cannot be told</source>
      <translation>No se puede decir</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Deviation, median and largest (cm)</source>
      <translation>Desviación, mediana y máxima (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Planned</source>
      <translation>Previsto</translation>
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
      <translation>Arriba (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Deviation (cm)</source>
      <translation>Desviación (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Rotation (°)</source>
      <translation>Rotación (°)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>The {count} units farthest from their place; all stand in the file of tetratrack design.</source>
      <translation>Las {count} piezas más alejadas de su lugar; todas están en el archivo de tetratrack design.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units under the profile's lines</source>
      <translation>Piezas bajo las líneas del perfil</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Centre off the design, mean and RMS (m)</source>
      <translation>Centro respecto al proyecto, media y RMS (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Outermost point, mean and RMS (m)</source>
      <translation>Punto extremo, media y RMS (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>A unit is within or outside the tolerance where its standard deviation leaves no doubt of 5 % or more.</source>
      <translation>Una pieza está dentro o fuera de la tolerancia cuando su desviación típica no deja duda del 5 % o más.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Map of displacements</source>
      <translation>Mapa de desplazamientos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Displacement of the units' centres.</source>
      <translation>Desplazamiento de los centros de las piezas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Histogram of displacements</source>
      <translation>Histograma de desplazamientos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Displacements of all units with the thresholds of the next section.</source>
      <translation>Desplazamientos de todas las piezas con los umbrales de la sección siguiente.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Units, one by one</source>
      <translation>Piezas, una a una</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Zoom in</source>
      <translation>Acercar</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Zoom out</source>
      <translation>Alejar</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Whole map</source>
      <translation>Mapa completo</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Arrows</source>
      <translation>Flechas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Map of the units by class</source>
      <translation>Mapa de las piezas por clase</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Search</source>
      <translation>Buscar</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>all</source>
      <translation>todas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Displacement from (cm)</source>
      <translation>Desplazamiento desde (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>significant only</source>
      <translation>solo significativos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Displacement (cm)</source>
      <translation>Desplazamiento (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Blocks of both epochs</source>
      <translation>Piezas de ambas épocas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>transparent</source>
      <translation>transparente</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Whole scene</source>
      <translation>Escena completa</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Drag turns, shift and drag moves, the wheel or two fingers zoom.</source>
      <translation>Arrastrar gira, Mayús y arrastrar desplaza, la rueda o dos dedos acercan.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>This browser shows no 3D (WebGL): the picture of the blocks below stands for it.</source>
      <translation>Este navegador no muestra 3D (WebGL): la imagen de las piezas de abajo la sustituye.</translation>
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
      <translation>Arriba</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>{shown} of {all} units</source>
      <translation>{shown} de {all} piezas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>enlarged {times} times</source>
      <translation>ampliadas {times} veces</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>dashed: cut short</source>
      <translation>a trazos: acortadas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Control point</source>
      <translation>Punto de control</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Control point, not used</source>
      <translation>Punto de control, no usado</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Frames and common motion</source>
      <translation>Marcos y movimiento común</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The clouds of these epochs are bent. What targets say of the bend is removed from positions and from displacements in datum control; what resting units say besides, from displacements in datum stable.</source>
      <translation>Las nubes de estas épocas están curvadas. Lo que las dianas dicen de la curvatura se quita de las posiciones y de los desplazamientos en la referencia control; lo que dicen además las piezas en reposo, de los desplazamientos en la referencia stable.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Bend, mean (mm)</source>
      <translation>Curvatura, media (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Bend, largest (mm)</source>
      <translation>Curvatura, máxima (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Left unknown, mean (mm)</source>
      <translation>Queda sin conocer, media (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Correlation length (m)</source>
      <translation>Longitud de correlación (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Targets used</source>
      <translation>Dianas usadas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Error of the clouds along the structure with its 95 % band.</source>
      <translation>Error de las nubes a lo largo de la estructura con su banda del 95 %.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>No bend of the clouds could be told from the noise of units and targets: frames are held stiff.</source>
      <translation>Ninguna curvatura de las nubes se distingue del ruido de las piezas y las dianas: los marcos se mantienen rígidos.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Flight strips or stations drift against each other along the structure; this is removed.</source>
      <translation>Las pasadas de vuelo o las estaciones derivan entre sí a lo largo de la estructura; esa deriva se quita.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The cloud of {epoch} was aligned by its units alone: a motion of the whole structure cannot be seen.</source>
      <translation>La nube de {epoch} se alineó solo por sus piezas: un movimiento de toda la estructura no se puede ver.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Common motion of stretches</source>
      <translation>Movimiento común de los tramos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Both epochs show too few units to tell a common motion of stretches.</source>
      <translation>Ambas épocas muestran muy pocas piezas para discernir un movimiento común de tramos.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Mean displacement of the units of each stretch against the targets; the band holds what is not known of the frames.</source>
      <translation>Desplazamiento medio de las piezas de cada tramo respecto a las dianas; la banda contiene lo que no se conoce de los marcos.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Not both epochs have survey control: stretches are compared with each other, and a motion of all of them cannot be told.</source>
      <translation>No ambas épocas tienen puntos de control: los tramos se comparan entre sí, y un movimiento de todos no se puede discernir.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Height change and horizontal motion of stretches with their 95 % bands.</source>
      <translation>Cambio de altura y movimiento horizontal de los tramos con sus bandas del 95 %.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>From (m)</source>
      <translation>Desde (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>To (m)</source>
      <translation>Hasta (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>No stretch moved as a whole by more than its band.</source>
      <translation>Ningún tramo se movió en bloque más que su banda.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Of {untold} of {all} stretches a common motion of one hundredth of the unit height cannot be told from the bend of the clouds: targets stand too far away.</source>
      <translation>En {untold} de {all} tramos, un movimiento común de una centésima de la altura de la pieza no se distingue de la curvatura de las nubes: las dianas están demasiado lejos.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The result says nothing of its frames.</source>
      <translation>El resultado no dice nada de sus referencias.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Units by class and control points; coordinates in {crs}.</source>
      <translation>Piezas por clase y puntos de control; coordenadas en {crs}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Map of a part with the units' names</source>
      <translation>Mapa de una parte con los nombres de las piezas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Part {number} of {all} along the structure.</source>
      <translation>Parte {number} de {all} a lo largo de la estructura.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Method, settings and versions</source>
      <translation>Método, ajustes y versiones</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Units are found in the point cloud as four cones with a common centre, adjusted to their points (Gauss-Helmert model), and brought into the frame of the survey control; displacements are differences of the feature points that follow from the adjusted model, tested against their covariance (after Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds).</source>
      <translation>Las piezas se encuentran en la nube de puntos como cuatro conos con un centro común, se ajustan a sus puntos (modelo de Gauss-Helmert) y se llevan al sistema de control; los desplazamientos son diferencias de los puntos característicos del modelo ajustado, probadas frente a su covarianza (según Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>σ0 of the registration</source>
      <translation>σ0 del registro</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Settings</source>
      <translation>Ajustes</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Written {moment} by {software}.</source>
      <translation>Escrito el {moment} por {software}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Placement</source>
      <translation>Colocación</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units with neighbours on all sides</source>
      <translation>Piezas con vecinas por todos los lados</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Nearest centre, median and 5 % (Dn)</source>
      <translation>Centro más cercano, mediana y 5 % (Dn)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Turn between neighbours, and expected at random</source>
      <translation>Giro entre vecinos, y esperado al azar</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Difference from turns at random, p</source>
      <translation>Diferencia con el azar, p</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Contacts of a unit, mean</source>
      <translation>Contactos de una pieza, media</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Free gap to the nearest unit, median (cm)</source>
      <translation>Holgura a la pieza más próxima, mediana (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units in a column, of those with one below</source>
      <translation>Piezas en columna, de las que tienen una debajo</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Off the surface of their neighbours, RMS and largest (m)</source>
      <translation>Fuera de la superficie de los vecinos, RMS y máximo (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Layer from outside</source>
      <translation>Capa desde el exterior</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units per 100 m²</source>
      <translation>Piezas por 100 m²</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Packing density, units per Dn²</source>
      <translation>Densidad de colocación, piezas por Dn²</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Share of the design number</source>
      <translation>Parte del número de proyecto</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units of {epoch}, each in the plane through its neighbours; those at the edge do not count for density. Only units that were found are counted: hidden ones of a lower layer are not. The design number is {packing} units per Dn² and layer (Shore Protection Manual, 1984).</source>
      <translation>Piezas de {epoch}, cada una en el plano de sus vecinas; las del borde no cuentan para la densidad. Solo se cuentan las piezas encontradas, no las ocultas de una capa inferior. El número de proyecto es {packing} piezas por Dn² y capa (Shore Protection Manual, 1984).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest and cross-sections</source>
      <translation>Coronación y secciones</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest height along the structure</source>
      <translation>Cota de coronación a lo largo de la estructura</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Mean height of the tops of the crest's units in each reach, with its 95 % band.</source>
      <translation>Cota media de la cima de las piezas de coronación de cada tramo, con su banda del 95 %.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest height (m)</source>
      <translation>Cota de coronación (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Highest (m)</source>
      <translation>Más alto (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest width (m)</source>
      <translation>Anchura de coronación (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Change (mm)</source>
      <translation>Cambio (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>The crest of a reach are the units whose top lies less than 0.5 Dn below the highest one; its width is that of their outlines across the axis; the change is that of units that are the crest's in both epochs. Settlement of whole stretches stands under frames and common motion.</source>
      <translation>La coronación de un tramo son las piezas cuya cima está a menos de 0,5 Dn por debajo de la más alta; su anchura es la de sus contornos a través del eje; el cambio es el de las piezas que son de la coronación en ambas épocas. El asiento de tramos enteros está en marcos y movimiento común.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Cross-sections</source>
      <translation>Secciones</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Quality of the units</source>
      <translation>Calidad de las piezas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Uncertain units</source>
      <translation>Piezas inciertas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Points to surface, median (mm)</source>
      <translation>Puntos a la superficie, mediana (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Largest overlap</source>
      <translation>Mayor solape</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Pairs too close</source>
      <translation>Pares demasiado cercanos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Overlap is the share of a unit's volume inside another one; two solid units cannot overlap, nor can their centres come closer than half a height. A gap is a place where a unit is likely missing in the result; the layer gaps shows them.</source>
      <translation>El solape es la parte del volumen de una pieza dentro de otra; dos piezas sólidas no pueden solaparse ni acercar sus centros a menos de media altura. Un hueco es un lugar donde probablemente falta una pieza en el resultado; la capa gaps los muestra.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>The result does not state the quality of its units.</source>
      <translation>El resultado no indica la calidad de sus piezas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Summary</source>
      <translation>Resumen</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units judged</source>
      <translation>Piezas evaluadas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Significant displacements</source>
      <translation>Desplazamientos significativos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Lost</source>
      <translation>Perdidas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Relocated</source>
      <translation>Arrastradas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>New</source>
      <translation>Nuevas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Not seen in the later epoch</source>
      <translation>No vistas en la época posterior</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Uncertain, not counted</source>
      <translation>Inciertas, no contadas</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Displaced by 5 cm or more</source>
      <translation>Desplazadas 5 cm o más</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Displaced by 10 cm or more</source>
      <translation>Desplazadas 10 cm o más</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Decided by reviewers</source>
      <translation>Decididas por revisores</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Rejected by reviewers</source>
      <translation>Rechazadas por revisores</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units known to be missing</source>
      <translation>Piezas que se sabe que faltan</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Completeness</source>
      <translation>Completitud</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units rejected by reviewers and left out of all figures, maps and tables below: {count}.</source>
      <translation>Piezas rechazadas por revisores y excluidas de todas las cifras, mapas y tablas siguientes: {count}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units that no reviewer has decided on yet: {count}.</source>
      <translation>Piezas sobre las que aún no ha decidido ningún revisor: {count}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Units with the largest displacements</source>
      <translation>Piezas con mayores desplazamientos</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>East {e}, north {n}, up {h} cm; rotation {turn}; p {p}</source>
      <translation>Este {e}, norte {n}, arriba {h} cm; giro {turn}; p {p}</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Plan and section of {unit}</source>
      <translation>Planta y sección de {unit}</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Series of {unit}</source>
      <translation>Serie de {unit}</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>No displacement is significant.</source>
      <translation>Ningún desplazamiento es significativo.</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>control used</source>
      <translation>control usado</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>control not used</source>
      <translation>control no usado</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>arrows: significant horizontal displacements, enlarged {scale} times</source>
      <translation>flechas: desplazamientos horizontales significativos, ampliados {scale} veces</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>3D displacement (cm)</source>
      <translation>Desplazamiento 3D (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>all units</source>
      <translation>todas las piezas</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>units</source>
      <translation>piezas</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>plan</source>
      <translation>planta</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>section {azimuth}°</source>
      <translation>sección {azimuth}°</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>chainage along the axis (m)</source>
      <translation>progresiva a lo largo del eje (m)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>Height change</source>
      <translation>Cambio de altura</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>Horizontal motion</source>
      <translation>Movimiento horizontal</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>units ≥ 10 cm (%)</source>
      <translation>piezas ≥ 10 cm (%)</translation>
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
      <translation>mínimo y máximo alrededor de la pata</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>mean around the leg</source>
      <translation>media alrededor de la pata</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>end disc</source>
      <translation>disco del extremo</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>share of the leg, from the unit's centre</source>
      <translation>parte de la pata, desde el centro</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>outside the cone (mm)</source>
      <translation>fuera del cono (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>around the leg (degrees)</source>
      <translation>alrededor de la pata (grados)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>no damage</source>
      <translation>sin daño</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>initiation of damage</source>
      <translation>inicio de avería</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>Iribarren's damage</source>
      <translation>avería de Iribarren</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>initiation of destruction</source>
      <translation>inicio de destrucción</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>within</source>
      <translation>dentro</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>outside</source>
      <translation>fuera</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>cannot be told</source>
      <translation>no se puede decir</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>chainage {along} m, axis at {east} / {north}</source>
      <translation>progresiva {along} m, eje en {east} / {north}</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>height (m)</source>
      <translation>cota (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>offset from the axis, left positive (m)</source>
      <translation>distancia al eje, izquierda positiva (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>crest height (m)</source>
      <translation>cota de coronación (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>within the tolerance</source>
      <translation>dentro de la tolerancia</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>outside the tolerance</source>
      <translation>fuera de la tolerancia</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>not judged</source>
      <translation>no juzgado</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>planned place without a unit</source>
      <translation>lugar previsto sin pieza</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>unit without a planned place</source>
      <translation>pieza sin lugar previsto</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>surface of the points</source>
      <translation>superficie de los puntos</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>design</source>
      <translation>proyecto</translation>
    </message>
  </context>
</TS>
