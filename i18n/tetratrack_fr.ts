<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
  <context>
    <name>tetratrack</name>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Units at the common centre of their cones, with orientation, standard deviations (m, degrees), score and status.</source>
      <translation>Blocs au centre commun de leurs cônes, avec orientation, écarts-types (m, degrés), score et état.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Centre and the four joints of three cones (f123, f124, f134, f234) of every unit, with covariance (m, m²).</source>
      <translation>Centre et les quatre jonctions de trois cônes (f123, f124, f134, f234) de chaque bloc, avec covariance (m, m²).</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Displacement of every feature point between consecutive epochs (m), with test statistic and class.</source>
      <translation>Déplacement de chaque point caractéristique entre époques consécutives (m), avec statistique de test et classe.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Residuals at the control points (m), with normalised residual; disturbed points are marked.</source>
      <translation>Résidus aux points d'appui (m), avec résidu normalisé ; les points perturbés sont marqués.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Feature points less surveyed check points (m).</source>
      <translation>Points caractéristiques moins points de contrôle levés (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Monitoring</source>
      <translation>Suivi</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Single steps</source>
      <translation>Étapes séparées</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Planning and simulation</source>
      <translation>Planification et simulation</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Inputs and outputs</source>
      <translation>Entrées et sorties</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Limits</source>
      <translation>Limites</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>The engine's result holds no layer {layer}.</source>
      <translation>Le résultat du moteur ne contient pas de couche {layer}.</translation>
    </message>
    <message>
      <location filename="../algorithms/base.py" />
      <source>Numbers for models</source>
      <translation>Nombres pour les modèles</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Compare with design</source>
      <translation>Comparer au projet</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Compares the units of one epoch with a placement plan and with a design profile: deviation and turn of every unit, places without a unit, distance from the design surface, and whether that is within the tolerance.</source>
      <translation>Compare les blocs d'une époque à un plan de pose et à un profil de projet : écart et rotation de chaque bloc, places sans bloc, distance à la surface de projet, et si cela est dans la tolérance.</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>A unit stands at the place of its own name, or at the nearest free one within one height H. Within or outside is said where the standard deviations leave no doubt of 5 % or more, open where they do.</source>
      <translation>Un bloc est à la place de son propre nom, ou à la plus proche place libre à moins d'une hauteur H. « Dans » ou « hors » est dit lorsque les écarts-types ne laissent pas un doute de 5 % ou plus, sinon c'est indécis.</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>design,plan,placement,profile,tolerance,as-built,DXF</source>
      <translation>projet,plan,pose,profil,tolérance,récolement,DXF</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>GeoPackage with the layers plan_deviations, plan_unmatched and profile_deviations, those that were asked for.</source>
      <translation>GeoPackage avec les couches plan_deviations, plan_unmatched et profile_deviations, celles qui sont demandées.</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Deviations</source>
      <translation>Écarts</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Units outside the tolerance of the plan</source>
      <translation>Blocs hors de la tolérance du plan</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Planned places without a unit</source>
      <translation>Places prévues sans bloc</translation>
    </message>
    <message>
      <location filename="../algorithms/comparedesign.py" />
      <source>Units outside the tolerance of the profile</source>
      <translation>Blocs hors de la tolérance du profil</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Cross-sections and crest</source>
      <translation>Coupes et crête</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Cuts the structure across its axis: outlines of the blocks of every epoch, surface of the points and design in each section, height and width of the crest of each reach, and settlement along the structure.</source>
      <translation>Coupe l'ouvrage en travers de son axe : contours des blocs de chaque époque, surface des points et projet dans chaque coupe, hauteur et largeur de la crête de chaque tronçon, et tassement le long de l'ouvrage.</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Points are those read around the units for the review (unit-points); without them sections show blocks alone.</source>
      <translation>Les points sont ceux lus autour des blocs pour la revue (unit-points) ; sans eux les coupes ne montrent que les blocs.</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>profile,section,crest,settlement,chainage</source>
      <translation>profil,coupe,crête,tassement,abscisse</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>GeoPackage with the layers sections, crest and settlement.</source>
      <translation>GeoPackage avec les couches sections, crest et settlement.</translation>
    </message>
    <message>
      <location filename="../algorithms/crosssections.py" />
      <source>Sections</source>
      <translation>Coupes</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Label of an epoch; empty for both takes the latest pair.</source>
      <translation>Libellé d'une époque ; vide pour les deux prend la paire la plus récente.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Displacement report</source>
      <translation>Rapport de déplacement</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Writes the report of a result as reviewed so far: summary, control quality, displacement map and table, worst units, damage figures, method, settings and versions.</source>
      <translation>Écrit le rapport d'un résultat dans l'état actuel de la vérification : résumé, qualité de l'appui, carte et tableau des déplacements, blocs les plus touchés, indices de dommage, méthode, réglages et versions.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Rejected units are left out of the statistics and listed apart. PDF needs the library weasyprint in the engine.</source>
      <translation>Les blocs rejetés sont exclus des statistiques et listés à part. Le PDF demande la bibliothèque weasyprint dans le moteur.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>report,HTML,PDF,damage,displacement</source>
      <translation>rapport,HTML,PDF,dommage,déplacement</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>that of the result</source>
      <translation>celle du résultat</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>stable units and control</source>
      <translation>blocs stables et appui</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>control points alone</source>
      <translation>points d'appui seuls</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>What the displacements are stated against, in all of the report.</source>
      <translation>Ce par rapport à quoi les déplacements sont donnés, dans tout le rapport.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Places easting,northing along it, separated by blanks; damage is then stated by sections.</source>
      <translation>Points est,nord le long de celui-ci, séparés par des espaces ; les dommages sont alors donnés par sections.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>0.09, 0.30 and 0.61 m (US Army Corps of Engineers)</source>
      <translation>0,09, 0,30 et 0,61 m (US Army Corps of Engineers)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>5 and 10 cm</source>
      <translation>5 et 10 cm</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>0.5 and 1 Dn (nominal diameter)</source>
      <translation>0,5 et 1 Dn (diamètre nominal)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Limits by which the units are counted that moved.</source>
      <translation>Limites d'après lesquelles sont comptés les blocs qui se sont déplacés.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>So many of those that moved most get views, series and decisions of their own.</source>
      <translation>Autant de ceux qui ont le plus bougé reçoivent leurs vues, séries et décisions.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>HTML in one file, or PDF; the ending decides.</source>
      <translation>HTML en un fichier, ou PDF ; l'extension décide.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Earlier epoch</source>
      <translation>Époque antérieure</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Later epoch</source>
      <translation>Époque ultérieure</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Reference of the displacements</source>
      <translation>Référence des déplacements</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Axis of the structure</source>
      <translation>Axe de l'ouvrage</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length looked at (m)</source>
      <translation>Longueur considérée (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of the structure in metres, for the damage number N_od.</source>
      <translation>Longueur de l'ouvrage en mètres, pour le nombre de dommage N_od.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of a section (m)</source>
      <translation>Longueur d'une section (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Length of the sections along the axis, in metres.</source>
      <translation>Longueur des sections le long de l'axe, en mètres.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Movement bands</source>
      <translation>Classes de mouvement</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Units shown one by one</source>
      <translation>Blocs montrés un par un</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Report</source>
      <translation>Rapport</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Give both epochs, or neither for the latest pair.</source>
      <translation>Indiquez les deux époques, ou aucune pour la paire la plus récente.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Export as-built model</source>
      <translation>Exporter le modèle tel que construit</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Writes the units of one epoch as bodies at their fitted poses, coloured by class, with uncertainty and movement as properties, for CAD, BIM and 3D viewers. The ending of the file chooses the format: glTF (.glb), Wavefront (.obj), DXF, IFC4x3 or the poses alone (.json).</source>
      <translation>Écrit les blocs d'une époque comme corps à leurs poses ajustées, colorés par classe, avec incertitude et mouvement comme propriétés, pour la CAO, le BIM et les visionneuses 3D. L'extension du fichier choisit le format : glTF (.glb), Wavefront (.obj), DXF, IFC4x3 ou les poses seules (.json).</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Bodies have 24 plane faces a leg. glTF, OBJ, IFC and JSON hold coordinates less a reduction point that stands in the file; DXF holds coordinates of the survey CRS and needs the library ezdxf in the engine.</source>
      <translation>Les corps ont 24 faces planes par branche. glTF, OBJ, IFC et JSON contiennent des coordonnées réduites d'un point indiqué dans le fichier ; DXF contient les coordonnées du SCR du levé et demande la bibliothèque ezdxf dans le moteur.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>model,3D,glTF,GLB,OBJ,DXF,IFC,BIM,CAD,as-built</source>
      <translation>modèle,3D,glTF,GLB,OBJ,DXF,IFC,BIM,CAO,tel que construit</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Label of the epoch whose units are written; the latest one with units unless given.</source>
      <translation>Libellé de l'époque dont les blocs sont écrits ; à défaut la dernière qui en a.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>File to write; its ending decides the format.</source>
      <translation>Fichier à écrire ; son extension décide du format.</translation>
    </message>
    <message>
      <location filename="../algorithms/exportmodel.py" />
      <source>Model</source>
      <translation>Modèle</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Extract feature points</source>
      <translation>Extraire les points caractéristiques</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Derives the centre and the four points where three cone surfaces meet on the outside of each unit, with the covariance carried over from the fit. These points can be surveyed by total station as well.</source>
      <translation>Calcule le centre et les quatre points où trois surfaces coniques se rencontrent à l'extérieur de chaque bloc, avec la covariance propagée de l'ajustement. Ces points peuvent aussi être levés à la station totale.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>A joint is marked as observed only where points lie next to it; otherwise it follows from the rest of the unit.</source>
      <translation>Une jonction n'est marquée observée que si des points la bordent ; sinon elle découle du reste du bloc.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>feature points,cone intersection,centre,covariance propagation</source>
      <translation>points caractéristiques,intersection de cônes,centre,propagation de covariance</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Layer of units from Fit tetrapods or Monitor a survey.</source>
      <translation>Couche de blocs d'Ajuster les tétrapodes ou de Suivre un levé.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Points d1 to d4, which crews can measure and paint.</source>
      <translation>Points d1 à d4, que les équipes peuvent mesurer et peindre.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>From the centre to the end disc, in metres; empty takes 0.644 H.</source>
      <translation>Du centre au disque d'extrémité, en mètres ; vide prend 0,644 H.</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Fitted units</source>
      <translation>Blocs ajustés</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Centres of the end discs as well</source>
      <translation>Aussi les centres des disques d'extrémité</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Leg length (m)</source>
      <translation>Longueur de branche (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/extractfeaturepoints.py" />
      <source>Points</source>
      <translation>Points</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Fit tetrapods</source>
      <translation>Ajuster les tétrapodes</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Fits four equal cones that share a centre to the points of each unit by an iterated Gauss–Helmert adjustment with robust weights, end discs and removal of the curvature bias; gives pose, radius, taper and their covariance.</source>
      <translation>Ajuste quatre cônes égaux de même centre aux points de chaque bloc par une compensation de Gauss-Helmert itérée, avec poids robustes, disques d'extrémité et suppression du biais de courbure ; donne la pose, le rayon, la conicité et leur covariance.</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>With one visible leg the twist about its axis is undetermined: the unit says so in its large standard deviation.</source>
      <translation>Avec une seule branche visible, la rotation autour de son axe est indéterminée : le grand écart-type du bloc le montre.</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>adjustment,Gauss-Helmert,least squares,cone,pose,covariance</source>
      <translation>compensation,Gauss-Helmert,moindres carrés,cône,pose,covariance</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Layer of units from Segment tetrapods, with the fields qx, qy, qz, qw of their orientation.</source>
      <translation>Couche de blocs de Segmenter les tétrapodes, avec les champs qx, qy, qz, qw de leur orientation.</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Units found</source>
      <translation>Blocs trouvés</translation>
    </message>
    <message>
      <location filename="../algorithms/fittetrapods.py" />
      <source>Units fitted</source>
      <translation>Blocs ajustés (nombre)</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Inspect tiles</source>
      <translation>Inspecter les dalles</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Lists point cloud tiles with their extent, CRS, number and density of points and range of heights. Run it first: it shows missing CRS, gaps, overlaps and tiles too thin to find units in.</source>
      <translation>Liste les dalles de nuage de points avec étendue, SCR, nombre et densité de points et plage d'altitudes. À lancer d'abord : montre les SCR manquants, lacunes, recouvrements et dalles trop clairsemées.</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Reads headers and a sample of points; a damaged tile is named and ends the run.</source>
      <translation>Lit les en-têtes et un échantillon de points ; une dalle endommagée est nommée et arrête l'exécution.</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>point cloud,LAS,LAZ,tile index,density,CRS,extent</source>
      <translation>nuage de points,LAS,LAZ,index de dalles,densité,SCR,étendue</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>One rectangle per tile with file, CRS, points, density (points/m²) and heights (m).</source>
      <translation>Un rectangle par dalle avec fichier, SCR, points, densité (points/m²) et altitudes (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Tile index</source>
      <translation>Index des dalles</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Tiles</source>
      <translation>Dalles</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>Median density (points/m²)</source>
      <translation>Densité médiane (points/m²)</translation>
    </message>
    <message>
      <location filename="../algorithms/inspecttiles.py" />
      <source>CRS of the tiles</source>
      <translation>SCR des dalles</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Monitor a survey</source>
      <translation>Suivre un levé</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>All steps at once: registers every epoch to survey control, finds the tetrapods, fits four cones that share a centre, derives feature points and tests their displacements. Give a survey.toml, or the epochs and the unit.</source>
      <translation>Toutes les étapes en une fois : rattache chaque époque à l'appui topographique, trouve les tétrapodes, ajuste quatre cônes de même centre, calcule les points caractéristiques et teste leurs déplacements. Donnez un survey.toml, ou les époques et le bloc.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Units of which less than about 5 % is seen are not found. Without control the cloud's own frame is used, and the result says so.</source>
      <translation>Les blocs vus à moins d'environ 5 % ne sont pas trouvés. Sans appui, le repère propre du nuage est utilisé et le résultat le dit.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>tetrapod,armour unit,breakwater,displacement,monitoring,LAS,LAZ,deformation</source>
      <translation>tétrapode,bloc de carapace,digue,déplacement,suivi,LAS,LAZ,déformation</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>A survey.toml; if given, it states everything, and the fields for epochs, unit, CRS and area are not used.</source>
      <translation>Un survey.toml ; s'il est donné, il décide de tout, et les champs époques, bloc, SCR et zone ne servent pas.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Label</source>
      <translation>Nom</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Time (UTC)</source>
      <translation>Heure (UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Control points</source>
      <translation>Points d'appui</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Targets in the cloud</source>
      <translation>Cibles dans le nuage</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Check points</source>
      <translation>Points de contrôle</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Epochs</source>
      <translation>Époques</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>One row per epoch: label, time such as 2025-03-14T02:30, folder or files of tiles (separated by ;), CSV files or layers.</source>
      <translation>Une ligne par époque : nom, heure telle que 2025-03-14T02:30, dossier ou fichiers de dalles (séparés par ;), fichiers CSV ou couches.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Writes a top view of each epoch as GeoTIFF beside the result, as a backdrop.</source>
      <translation>Écrit une vue de dessus de chaque époque en GeoTIFF à côté du résultat, comme fond.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Adds all layers to the project as a group with their styles.</source>
      <translation>Ajoute toutes les couches au projet en un groupe avec leurs styles.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>GeoPackage with units, feature points, displacements, residuals, epochs and reviews, in the survey's CRS, times in UTC.</source>
      <translation>GeoPackage avec blocs, points caractéristiques, déplacements, résidus, époques et vérifications, dans le SCR du levé, heures en UTC.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Survey file</source>
      <translation>Fichier de levé</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Shaded relief of each epoch</source>
      <translation>Relief ombré de chaque époque</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Load the result</source>
      <translation>Charger le résultat</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Result</source>
      <translation>Résultat</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Units moved</source>
      <translation>Blocs déplacés</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>RMSE at check points (m)</source>
      <translation>EQM aux points de contrôle (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Give a survey.toml, or at least one epoch with its tiles.</source>
      <translation>Donnez un survey.toml, ou au moins une époque avec ses dalles.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Every epoch needs six columns: label, time, tiles, control points, targets, check points.</source>
      <translation>Chaque époque demande six colonnes : nom, heure, dalles, points d'appui, cibles, points de contrôle.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{place}: {time} is no time; write it as 2025-03-14, 2025-03-14T02:30 (UTC) or 2025-03-14T11:30+09:00.</source>
      <translation>{place} : {time} n'est pas une date ; écrivez 2025-03-14, 2025-03-14T02:30 (UTC) ou 2025-03-14T11:30+09:00.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{where}: there is no file or layer {path}.</source>
      <translation>{where} : il n'y a pas de fichier ou de couche {path}.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>{where}: {path} cannot be read as a point layer or CSV file.</source>
      <translation>{where} : {path} ne peut être lu comme couche de points ou fichier CSV.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>The folder {folder} does not exist.</source>
      <translation>Le dossier {folder} n'existe pas.</translation>
    </message>
    <message>
      <location filename="../algorithms/monitorsurvey.py" />
      <source>Relief {epoch}</source>
      <translation>Relief {epoch}</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>New survey from a folder</source>
      <translation>Nouveau levé à partir d'un dossier</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Writes a survey.toml from what the files in a folder say: epochs and times, CRS, control, targets and check points, and the size of the units from the cloud itself.</source>
      <translation>Écrit un survey.toml d'après ce que disent les fichiers d'un dossier : époques et heures, SCR, points d'appui, cibles et points de contrôle, et la taille des blocs d'après le nuage lui-même.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Every value stands with its reason; what the files leave open is asked for in the log.</source>
      <translation>Chaque valeur est accompagnée de sa raison ; ce que les fichiers laissent ouvert est demandé dans le journal.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>new survey,folder,tiles,epochs,size of units,survey.toml</source>
      <translation>nouveau levé,dossier,dalles,époques,taille des blocs,survey.toml</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Folder with the tiles of all epochs; tables of control lie in it or beside it.</source>
      <translation>Dossier contenant les dalles de toutes les époques ; les tables des points d'appui s'y trouvent ou à côté.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Point cloud tiles</source>
      <translation>Dalles de nuage de points</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Instead of a folder: point cloud layers, or files, of all epochs.</source>
      <translation>Au lieu d’un dossier : couches de nuages de points, ou fichiers, de toutes les époques.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Projected CRS in metres; needed only where the tiles declare none.</source>
      <translation>SCR projeté en mètres ; nécessaire seulement si les dalles n'en déclarent pas.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Empty estimates it from the cloud.</source>
      <translation>Vide : estimée d'après le nuage.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Text file to look through, correct and run.</source>
      <translation>Fichier texte à relire, corriger et exécuter.</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Folder of tiles</source>
      <translation>Dossier de dalles</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>CRS of the results</source>
      <translation>SCR des résultats</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Height of the units (m)</source>
      <translation>Hauteur des blocs (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Survey</source>
      <translation>Levé</translation>
    </message>
    <message>
      <location filename="../algorithms/newsurvey.py" />
      <source>Give a folder of tiles, or tiles.</source>
      <translation>Indiquez un dossier de dalles, ou des dalles.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Plan a survey: detectable displacement</source>
      <translation>Planifier un levé : déplacement détectable</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Computes which displacement and rotation of a unit a planned survey will find, from point density, noise, visible share and registration: the Cramér–Rao bound of the adjustment for the unit's geometry, and Baarda's detectability.</source>
      <translation>Calcule quel déplacement et quelle rotation d'un bloc un levé prévu trouvera, selon densité de points, bruit, part visible et rattachement : borne de Cramér-Rao de la compensation pour la géométrie du bloc, et détectabilité de Baarda.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>White noise is averaged over the points of a unit; whatever does not average out must be stated as systematic part. The shares of units found are those measured on simulated piles of that density and noise, seen from above.</source>
      <translation>Le bruit blanc se moyenne sur les points d'un bloc ; ce qui ne se moyenne pas doit être donné comme part systématique. Les parts de blocs trouvés sont celles mesurées sur des carapaces simulées de cette densité et de ce bruit, vues d'en haut.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>planning,detectability,point density,noise,Cramér-Rao bound,minimal detectable displacement</source>
      <translation>planification,détectabilité,densité de points,bruit,borne de Cramér-Rao,déplacement minimal détectable</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Point density (points/m²)</source>
      <translation>Densité de points (points/m²)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>On a surface that faces the instrument, all flight strips or stations together.</source>
      <translation>Sur une surface face à l'instrument, toutes bandes de vol ou stations ensemble.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Noise of a point (m)</source>
      <translation>Bruit d'un point (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation along the surface normal, in metres.</source>
      <translation>Écart-type le long de la normale à la surface, en mètres.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Visible share of a unit</source>
      <translation>Part visible d'un bloc</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share of a unit's surface that holds points, 0 to 1; in a pile 0.05 to 0.5.</source>
      <translation>Part de la surface d'un bloc qui porte des points, 0 à 1 ; dans un talus 0,05 à 0,5.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Registration (m)</source>
      <translation>Rattachement (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of an epoch's registration at the unit, per coordinate, in metres.</source>
      <translation>Écart-type du rattachement d'une époque au bloc, par coordonnée, en mètres.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Systematic part (m)</source>
      <translation>Part systématique (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Strip offsets, roughness and growth that do not average out, per coordinate, in metres.</source>
      <translation>Décalages de bandes, rugosité et salissures qui ne se moyennent pas, par coordonnée, en mètres.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Line of sight from the vertical (degrees)</source>
      <translation>Ligne de visée par rapport à la verticale (degrés)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>0 from the air; about 70 from the crown wall.</source>
      <translation>0 depuis les airs ; environ 70 depuis le mur de couronnement.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Calibrated and held; otherwise they are estimated for every unit, which costs accuracy.</source>
      <translation>Étalonnés et fixés ; sinon estimés pour chaque bloc, au prix de la précision.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Level of significance</source>
      <translation>Niveau de signification</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Probability of a false alarm for one unit.</source>
      <translation>Probabilité d'une fausse alerte pour un bloc.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Power</source>
      <translation>Puissance</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Probability with which the displacement is found.</source>
      <translation>Probabilité de trouver le déplacement.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>What the survey detects over point density and visible share, beside the plan.</source>
      <translation>Ce que le levé détecte selon la densité de points et la part visible, à côté du plan.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Points on a unit</source>
      <translation>Points sur un bloc</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of the centre (m)</source>
      <translation>Écart-type du centre (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of the rotation (degrees)</source>
      <translation>Écart-type de la rotation (degrés)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Standard deviation of a displacement (m)</source>
      <translation>Écart-type d'un déplacement (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable displacement, worst direction (m)</source>
      <translation>Déplacement détectable, pire direction (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable displacement, mean (m)</source>
      <translation>Déplacement détectable, moyenne (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Detectable rotation (degrees)</source>
      <translation>Rotation détectable (degrés)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Points per square of a unit's height</source>
      <translation>Points par carré de la hauteur d'un bloc</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 30 % or more</source>
      <translation>Part trouvée des blocs vus à 30 % ou plus</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 15–30 %</source>
      <translation>Part trouvée des blocs vus à 15–30 %</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Share found of the units seen to 5–15 %</source>
      <translation>Part trouvée des blocs vus à 5–15 %</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>The level of significance must be below the power.</source>
      <translation>Le niveau de signification doit être inférieur à la puissance.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Radius and taper are known</source>
      <translation>Rayon et conicité connus</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Chart</source>
      <translation>Graphique</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Web page (*.html)</source>
      <translation>Page web (*.html)</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>{file} cannot be written: {reason}.</source>
      <translation>{file} ne peut pas être écrit : {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/provider.py" />
      <source>Tetratrack: displacements of tetrapods</source>
      <translation>Tetratrack : déplacements de tétrapodes</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Register to control</source>
      <translation>Rattacher à l'appui</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Estimates the rigid transformation from an epoch's cloud to survey control from targets, weighted by their standard deviations, and finds disturbed targets by data snooping on normalised residuals.</source>
      <translation>Estime la transformation rigide du nuage d'une époque vers l'appui à partir de cibles pondérées par leurs écarts-types, et trouve les cibles perturbées par data snooping sur les résidus normalisés.</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Needs three targets that do not lie in one line; an outlier is found from four, and named surely from five.</source>
      <translation>Demande trois cibles non alignées ; une faute se détecte à partir de quatre et se nomme sûrement à partir de cinq.</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>registration,control points,targets,transformation,data snooping,georeferencing</source>
      <translation>rattachement,points d'appui,cibles,transformation,data snooping,géoréférencement</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>GeoPackage whose table epochs holds the seven parameters and their covariance.</source>
      <translation>GeoPackage dont la table epochs contient les sept paramètres et leur covariance.</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Registration</source>
      <translation>Rattachement</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>RMSE at control points (m)</source>
      <translation>EQM aux points d'appui (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/registertocontrol.py" />
      <source>Disturbed targets</source>
      <translation>Cibles perturbées</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Register views</source>
      <translation>Assembler les vues</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Brings overlapping views of a depth camera or scanner stations into the frame of the first by multiway ICP with a pose graph, and writes one cloud in which every view keeps its number as point source id.</source>
      <translation>Amène les vues recouvrantes d'une caméra de profondeur ou de stations de scanner dans le repère de la première par ICP multivue avec graphe de poses, et écrit un nuage où chaque vue garde son numéro comme identifiant de source.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Views must overlap by a third or more and be roughly aligned; views that do not connect are named.</source>
      <translation>Les vues doivent se recouvrir d'un tiers ou plus et être à peu près alignées ; celles qui ne se relient pas sont nommées.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>registration,ICP,pose graph,depth camera,multi-view</source>
      <translation>assemblage,ICP,graphe de poses,caméra de profondeur,multivue</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Resolution at which views are matched, in metres; empty derives it from the point spacing.</source>
      <translation>Résolution à laquelle les vues sont comparées, en mètres ; vide la tire de l'espacement des points.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>One LAZ file in the frame of the first view.</source>
      <translation>Un fichier LAZ dans le repère de la première vue.</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Views</source>
      <translation>Vues</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Voxel size (m)</source>
      <translation>Taille de voxel (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>Registered cloud</source>
      <translation>Nuage assemblé</translation>
    </message>
    <message>
      <location filename="../algorithms/registerviews.py" />
      <source>RMSE between views (m)</source>
      <translation>EQM entre vues (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Points less blocks</source>
      <translation>Points moins blocs</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Writes the points around the units of one epoch with their distance to the nearest fitted unit, coloured from blue (10 cm or more within a body) through white to red (10 cm or more outside): what is red is debris, a unit that was missed, or one that is broken.</source>
      <translation>Écrit les points autour des blocs d'une époque avec leur distance au bloc ajusté le plus proche, colorés du bleu (10 cm ou plus dans un corps) au rouge (10 cm ou plus dehors) en passant par le blanc : ce qui est rouge est un débris, un bloc non trouvé ou un bloc cassé.</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Points are those read around the units for the review (unit-points), in the control frame. For units lower than 2 m, and models of a tank, colours end at 5 % of the height H instead of 10 cm; points near no unit have the distance 10 m.</source>
      <translation>Les points sont ceux lus autour des blocs pour la revue (unit-points), dans le repère des points de contrôle. Pour des blocs de moins de 2 m et des modèles en bassin, les couleurs s'arrêtent à 5 % de la hauteur H au lieu de 10 cm ; les points loin de tout bloc ont la distance 10 m.</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>residuals,LAZ,LAS,point cloud,distance</source>
      <translation>résidus,LAZ,LAS,nuage de points,distance</translation>
    </message>
    <message>
      <location filename="../algorithms/residualpoints.py" />
      <source>Point cloud with the dimensions distance (m) and unit.</source>
      <translation>Nuage de points avec les dimensions distance (m) et unit.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Label of the epoch whose units are looked at; the latest one with units unless given.</source>
      <translation>Nom de l'époque dont les blocs sont regardés ; par défaut la dernière qui en a.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Degrees a unit may be turned from its planned orientation.</source>
      <translation>Degrés dont un bloc peut être tourné par rapport à l'orientation prévue.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>GeoPackage written by Monitor a survey.</source>
      <translation>GeoPackage écrit par Suivre un levé.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Path of a CSV unit_id,easting,northing,height with the planned centres, optionally qx,qy,qz,qw, or of a layer of points with heights (FILE|layername=NAME).</source>
      <translation>Chemin d'un CSV unit_id,easting,northing,height des centres prévus, éventuellement qx,qy,qz,qw, ou d'une couche de points avec altitudes (FILE|layername=NAME).</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of places (m)</source>
      <translation>Tolérance des places (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres a unit may be from its planned place.</source>
      <translation>Mètres dont un bloc peut s'écarter de sa place prévue.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of turns (°)</source>
      <translation>Tolérance des rotations (°)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Path of a DXF or of a layer of lines with heights: a single line is a cross-section along the whole structure, several are its edges.</source>
      <translation>Chemin d'un DXF ou d'une couche de lignes avec altitudes : une seule ligne est une coupe le long de tout l'ouvrage, plusieurs en sont les arêtes.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres a unit may be off the design profile.</source>
      <translation>Mètres dont un bloc peut s'écarter du profil de projet.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Places easting,northing along it, separated by blanks; the centreline of the units unless given.</source>
      <translation>Places easting,northing le long de l'axe, séparées par des espaces ; par défaut la ligne médiane des blocs.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Distance of the sections (m)</source>
      <translation>Distance des coupes (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Metres along the axis; four heights of a unit unless given.</source>
      <translation>Mètres le long de l'axe ; par défaut quatre hauteurs de bloc.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Epoch</source>
      <translation>Époque</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Placement plan</source>
      <translation>Plan de pose</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Design profile</source>
      <translation>Profil de projet</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Tolerance of the profile (m)</source>
      <translation>Tolérance du profil (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>outermost point of a unit</source>
      <translation>point le plus extérieur d'un bloc</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>centre of a unit</source>
      <translation>centre d'un bloc</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>What is judged against the design profile; both distances are written.</source>
      <translation>Ce qui est jugé par rapport au profil de projet ; les deux distances sont écrites.</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>All files (*.*)</source>
      <translation>Tous les fichiers (*.*)</translation>
    </message>
    <message>
      <location filename="../algorithms/result_algorithm.py" />
      <source>Judged against the profile</source>
      <translation>Jugé par rapport au profil</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Segment tetrapods</source>
      <translation>Segmenter les tétrapodes</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Finds every tetrapod in a pile: cones from pairs of oriented points, legs that agree on a common centre and on the angles between them, and verification against the visible surface and against empty space.</source>
      <translation>Trouve chaque tétrapode d'un talus : cônes à partir de paires de points orientés, branches d'accord sur un centre commun et sur leurs angles, et vérification contre la surface visible et l'espace vide.</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Units of which less than about 5 % is seen are not found; weak evidence has the status uncertain. Poses are approximate: fit them next.</source>
      <translation>Les blocs vus à moins d'environ 5 % ne sont pas trouvés ; une preuve faible a l'état incertain. Les poses sont approchées : ajustez-les ensuite.</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>segmentation,RANSAC,cone,tetrapod,armour unit,detection</source>
      <translation>segmentation,RANSAC,cône,tétrapode,bloc de carapace,détection</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Simulate a survey</source>
      <translation>Simuler un levé</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Writes a simulated survey of a tetrapod slope with known poses: LAZ tiles, control, check points and survey.toml. Use it to try the chain, to train, or to test a planned density and noise.</source>
      <translation>Écrit le levé simulé d'un talus de tétrapodes de poses connues : dalles LAZ, appui, points de contrôle et survey.toml. Pour essayer la chaîne, se former, ou éprouver une densité et un bruit prévus.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Simulated surfaces are cleaner than real ones; judge a plan with some reserve.</source>
      <translation>Les surfaces simulées sont plus propres que les vraies ; jugez un plan avec réserve.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>simulation,synthetic,ground truth,test data</source>
      <translation>simulation,synthétique,vérité terrain,données d'essai</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>UAV laser scanner</source>
      <translation>scanner laser sur drone</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>terrestrial laser scanner</source>
      <translation>scanner laser terrestre</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>photogrammetry</source>
      <translation>photogrammétrie</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>depth camera</source>
      <translation>caméra de profondeur</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Decides viewpoints, hidden parts and, unless stated, noise and density.</source>
      <translation>Décide des points de vue, des parties cachées et, sauf indication, du bruit et de la densité.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Number of units on the slope.</source>
      <translation>Nombre de blocs sur le talus.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Number of surveys; some units move between them.</source>
      <translation>Nombre de levés ; quelques blocs bougent entre eux.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Standard deviation of the range, in metres; empty takes that of the instrument.</source>
      <translation>Écart-type de la distance, en mètres ; vide prend celui de l'instrument.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>On the ground; empty takes that of the instrument.</source>
      <translation>Au sol ; vide prend celle de l'instrument.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>A coast of this length, of stretches that hold the number of units each; empty gives one site.</source>
      <translation>Une côte de cette longueur, faite de tronçons contenant chacun le nombre de blocs ; vide donne un seul site.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Error of the trajectory along the site in metres, root mean square of each coordinate; empty for none.</source>
      <translation>Erreur de la trajectoire le long du site, en mètres, moyenne quadratique par coordonnée ; vide pour aucune.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>The same seed gives the same survey.</source>
      <translation>La même graine donne le même levé.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Receives tiles, CSV files, survey.toml and truth.</source>
      <translation>Reçoit dalles, fichiers CSV, survey.toml et vérité.</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Instrument</source>
      <translation>Instrument</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Units</source>
      <translation>Blocs</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Length of a coast (m)</source>
      <translation>Longueur d'une côte (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Bend of every epoch (m)</source>
      <translation>Flexion de chaque époque (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Seed</source>
      <translation>Graine</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>Survey folder</source>
      <translation>Dossier du levé</translation>
    </message>
    <message>
      <location filename="../algorithms/simulatesurvey.py" />
      <source>survey.toml of the simulated survey</source>
      <translation>survey.toml du levé simulé</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>The tetratrack engine is not installed: open Settings &gt; Options &gt; Tetratrack and create its environment or choose one.</source>
      <translation>Le moteur tetratrack n'est pas installé : ouvrez Préférences &gt; Options &gt; Tetratrack et créez son environnement ou choisissez-en un.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>Create or choose the engine…</source>
      <translation>Créer ou choisir le moteur…</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>Make the environment again…</source>
      <translation>Recréer l'environnement…</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>The engine ended unexpectedly (exit code {code}); QGIS and your data are unharmed.</source>
      <translation>Le moteur s'est arrêté de façon inattendue (code {code}) ; QGIS et vos données sont intacts.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>QGIS runs version {plugin} of the plugin, but its files are of version {engine}: restart QGIS.</source>
      <translation>QGIS utilise la version {plugin} de l'extension, mais ses fichiers sont de la version {engine} : redémarrez QGIS.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/engine.py" />
      <source>The engine could not be started with {python}: {reason}.</source>
      <translation>Le moteur n'a pas pu démarrer avec {python} : {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/environment.py" />
      <source>The tetratrack engine was made for another version of the plugin: let it be brought up to date in Settings &gt; Options.</source>
      <translation>Le moteur tetratrack a été créé pour une autre version de l'extension : mettez-le à jour dans Préférences &gt; Options.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/environment.py" />
      <source>The Python that the tetratrack engine was made with is gone: let its environment be made again in Settings &gt; Options.</source>
      <translation>Le Python avec lequel le moteur tetratrack a été créé a disparu : recréez son environnement dans Préférences &gt; Options.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Unit</source>
      <translation>Bloc</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Point</source>
      <translation>Point</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Unit in the plan</source>
      <translation>Bloc dans le plan</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Section</source>
      <translation>Section</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Time</source>
      <translation>Heure</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Until</source>
      <translation>Jusqu’à</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>From epoch</source>
      <translation>De l’époque</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>To epoch</source>
      <translation>À l’époque</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>From</source>
      <translation>De</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>To</source>
      <translation>À</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Feature point</source>
      <translation>Point caractéristique</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Type of unit</source>
      <translation>Type de bloc</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Status</source>
      <translation>État</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Class</source>
      <translation>Classe</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Kind</source>
      <translation>Genre</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Grade</source>
      <translation>Degré</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Datum</source>
      <translation>Référence</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reference epoch</source>
      <translation>Époque de référence</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>May be</source>
      <translation>Peut être</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest units</source>
      <translation>Blocs les plus proches</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Decision</source>
      <translation>Décision</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Comment</source>
      <translation>Commentaire</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reviewer</source>
      <translation>Vérificateur</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reviewed</source>
      <translation>Examiné le</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Confirmed by</source>
      <translation>Confirmé par</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Confirmed</source>
      <translation>Confirmé le</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Editor</source>
      <translation>Éditeur</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Edited</source>
      <translation>Modifié le</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Taken back</source>
      <translation>Annulé</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Picked by</source>
      <translation>Pointé par</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Picked</source>
      <translation>Pointé le</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Reason</source>
      <translation>Raison</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Known by</source>
      <translation>Connu par</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Software</source>
      <translation>Logiciel</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>File</source>
      <translation>Fichier</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>CRS</source>
      <translation>SCR</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Measured</source>
      <translation>Mesuré</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Verdict</source>
      <translation>Verdict</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Remark</source>
      <translation>Remarque</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>LAS version</source>
      <translation>Version LAS</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Point format</source>
      <translation>Format de points</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>COPC</source>
      <translation>COPC</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height H</source>
      <translation>Hauteur H</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Area</source>
      <translation>Aire</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Radius</source>
      <translation>Rayon</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Easting component</source>
      <translation>Composante est</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Northing component</source>
      <translation>Composante nord</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height component</source>
      <translation>Composante altitude</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Horizontal displacement</source>
      <translation>Déplacement horizontal</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement</source>
      <translation>Déplacement</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Azimuth</source>
      <translation>Azimut</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. easting</source>
      <translation>Écart type est</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. northing</source>
      <translation>Écart type nord</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. height</source>
      <translation>Écart type altitude</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Rotation</source>
      <translation>Rotation</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. rotation</source>
      <translation>Écart type rotation</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Detectable</source>
      <translation>Détectable</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement / H</source>
      <translation>Déplacement / H</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Displacement / Dn</source>
      <translation>Déplacement / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Missing of a leg</source>
      <translation>Manque d’une branche</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Distance of the points</source>
      <translation>Distance des points</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest centre</source>
      <translation>Centre le plus proche</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along the structure</source>
      <translation>Le long de l’ouvrage</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along, from</source>
      <translation>Le long, de</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Along, to</source>
      <translation>Le long, à</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Correlation length</source>
      <translation>Longueur de corrélation</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Lowest height</source>
      <translation>Altitude minimale</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Greatest height</source>
      <translation>Altitude maximale</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev.</source>
      <translation>Écart type</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. displacement</source>
      <translation>Écart type du déplacement</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Nearest of the other side</source>
      <translation>Plus proche de l'autre côté</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height of the design</source>
      <translation>Altitude du projet</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Centre off the design</source>
      <translation>Écart du centre au projet</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Outermost point off the design</source>
      <translation>Écart du point extrême au projet</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Height of the crest</source>
      <translation>Altitude de la crête</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Highest top</source>
      <translation>Sommet le plus haut</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Width of the crest</source>
      <translation>Largeur de la crête</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Change</source>
      <translation>Variation</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Std. dev. change</source>
      <translation>Écart type de la variation</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>95 % band, from</source>
      <translation>Bande à 95 %, de</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>95 % band, to</source>
      <translation>Bande à 95 %, à</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>p-value</source>
      <translation>valeur p</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>p-value, adjusted</source>
      <translation>valeur p, ajustée</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Significant</source>
      <translation>Significatif</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Sigma 0</source>
      <translation>Sigma 0</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Used</source>
      <translation>Utilisé</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Points/m²</source>
      <translation>Points/m²</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Legs seen</source>
      <translation>Branches vues</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Probability of a broken leg</source>
      <translation>Probabilité d’une branche cassée</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Share seen</source>
      <translation>Part vue</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Probability</source>
      <translation>Probabilité</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Share supported</source>
      <translation>Part soutenue</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Overlap</source>
      <translation>Recouvrement</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Observed</source>
      <translation>Observé</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Normalised residual</source>
      <translation>Résidu normalisé</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Disturbed</source>
      <translation>Perturbé</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Strip</source>
      <translation>Bande</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Layer of the armour</source>
      <translation>Couche de la carapace</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Packing</source>
      <translation>Compacité</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Spacing / Dn</source>
      <translation>Espacement / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Turn against the neighbour</source>
      <translation>Rotation par rapport au voisin</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Off the surface</source>
      <translation>Écart à la surface</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Off the surface / Dn</source>
      <translation>Écart à la surface / Dn</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Contacts</source>
      <translation>Contacts</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Free gap</source>
      <translation>Jeu libre</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>In a column</source>
      <translation>En colonne</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}</source>
      <translation>Branche {number}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}: missing</source>
      <translation>Branche {number} : manque</translation>
    </message>
    <message>
      <location filename="../algorithms/support/field_titles.py" />
      <source>Leg {number}: probability of a break</source>
      <translation>Branche {number} : probabilité de rupture</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>LAS, LAZ, COPC, E57 or PLY files, a folder of them, a virtual point cloud (.vpc) or point cloud layers; coordinates in metres.</source>
      <translation>Fichiers LAS, LAZ, COPC, E57 ou PLY, un dossier, un nuage de points virtuel (.vpc) ou des couches de nuages de points ; coordonnées en mètres.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Projected CRS in metres; empty takes that of the tiles, and a local frame if they declare none.</source>
      <translation>SCR projeté en mètres ; vide prend celui des dalles, et un repère local si elles n'en déclarent pas.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Label of this survey in all results, for example its date.</source>
      <translation>Nom de ce levé dans tous les résultats, par exemple sa date.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Drives the temporal controller; empty takes the date of the first tile.</source>
      <translation>Pilote le contrôleur temporel ; vide prend la date de la première dalle.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Estimates both from the best-seen units and holds them: moulds differ by centimetres from the standard proportions.</source>
      <translation>Estime les deux à partir des blocs les mieux vus et les fixe : les moules diffèrent de plusieurs centimètres des proportions standard.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Catalogue name with the mass in tonnes, such as tetrapod 8 t; or tetrapod with a height of your own.</source>
      <translation>Nom de catalogue avec la masse en tonnes, par exemple tetrapod 8 t ; ou tetrapod avec votre propre hauteur.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>From the plane under three legs to the top of the fourth, in metres; overrides the catalogue.</source>
      <translation>Du plan sous trois branches au sommet de la quatrième, en mètres ; prime sur le catalogue.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Radius of a leg's cone at the unit's centre, in metres; empty takes 0.264 H.</source>
      <translation>Rayon du cône d'une branche au centre du bloc, en mètres ; vide prend 0,264 H.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Loss of radius per metre along the leg's axis; empty takes 0.176.</source>
      <translation>Perte de rayon par mètre le long de l'axe de la branche ; vide prend 0,176.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Built tetrapods are tetrahedral; 120° between leg 1 and the others repeats the published equations.</source>
      <translation>Les tétrapodes réels sont tétraédriques ; 120° entre la branche 1 et les autres reproduit les équations publiées.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Polygon inside which units are looked for; its outer ring is used. Empty means everywhere.</source>
      <translation>Polygone dans lequel les blocs sont cherchés ; son anneau extérieur est utilisé. Vide : partout.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Polygons around surfaces that do not move, such as the crown wall: they tie epochs without control to the earliest with control, or to the first.</source>
      <translation>Polygones autour de surfaces qui ne bougent pas, comme le mur de couronnement : ils rattachent les époques sans points d'appui à la première qui en a, ou à la première de toutes.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>the survey itself tells</source>
      <translation>le levé lui-même le dit</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>rigid</source>
      <translation>rigide</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>elastic</source>
      <translation>élastique</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Long flights bend by centimetres over tens to hundreds of metres. The survey itself tells by its units and targets whether an epoch's cloud is bent; rigid holds it stiff (short sites, one set-up), elastic lets it bend on any evidence.</source>
      <translation>Les longs vols fléchissent de quelques centimètres sur des dizaines à des centaines de mètres. Le levé lui-même dit, par ses blocs et ses cibles, si le nuage d'une époque est fléchi ; rigide le tient droit (sites courts, une seule station), élastique le laisse fléchir au moindre indice.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Blocks of the survey worked on at the same time; each takes about 1 GB of memory.</source>
      <translation>Secteurs du levé traités en même temps ; chacun prend environ 1 Go de mémoire.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Surveyed targets: point layer or CSV with point_id, easting, northing, height, sd_e, sd_n, sd_h (m).</source>
      <translation>Cibles levées : couche de points ou CSV avec point_id, easting, northing, height, sd_e, sd_n, sd_h (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The same targets as measured in this epoch's cloud: point layer or CSV with point_id, x, y, z (m).</source>
      <translation>Les mêmes cibles mesurées dans le nuage de cette époque : couche de points ou CSV avec point_id, x, y, z (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Surveyed joints of cones, for validation only: CSV or layer with point_id, unit_easting, unit_northing, unit_height and position (m).</source>
      <translation>Jonctions de cônes levées, pour validation seulement : CSV ou couche avec point_id, unit_easting, unit_northing, unit_height et position (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Give the height H of the unit, or choose a catalogue name with its mass, such as tetrapod 8 t.</source>
      <translation>Donnez la hauteur H du bloc, ou choisissez un nom de catalogue avec sa masse, par exemple tetrapod 8 t.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The type of unit must be tetrapod, or a catalogue name such as tetrapod 8 t.</source>
      <translation>Le type de bloc doit être tetrapod, ou un nom de catalogue tel que tetrapod 8 t.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Control points and targets in the cloud belong together: give both, or neither.</source>
      <translation>Points d'appui et cibles dans le nuage vont ensemble : donnez les deux, ou aucun.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Time of the survey (UTC)</source>
      <translation>Heure du levé (UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Epoch {label} (row {row})</source>
      <translation>Époque {label} (ligne {row})</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Calibrate radius and taper</source>
      <translation>Étalonner rayon et conicité</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Height H of the unit (m)</source>
      <translation>Hauteur H du bloc (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Cone radius at the centre (m)</source>
      <translation>Rayon du cône au centre (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Taper of the leg</source>
      <translation>Conicité de la branche</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Angle between the legs</source>
      <translation>Angle entre les branches</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Area of interest</source>
      <translation>Zone d'intérêt</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Stable areas</source>
      <translation>Zones stables</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Frames of the epochs</source>
      <translation>Repères des époques</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Worker processes</source>
      <translation>Processus de calcul</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The cone radius must be smaller than half the height of the unit.</source>
      <translation>Le rayon du cône doit être inférieur à la moitié de la hauteur du bloc.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The area of interest holds no polygon.</source>
      <translation>La zone d'intérêt ne contient aucun polygone.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The area of interest has several separate parts; give one polygon.</source>
      <translation>La zone d'intérêt a plusieurs parties séparées ; donnez un seul polygone.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Virtual point clouds (*.vpc)</source>
      <translation>Nuages de points virtuels (*.vpc)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Epoch in row {row}</source>
      <translation>Époque de la ligne {row}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>tetrahedral (109.5°)</source>
      <translation>tétraédrique (109,5°)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>as in the paper (120°)</source>
      <translation>comme dans l'article (120°)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{crs} is geographic; choose a projected CRS in metres.</source>
      <translation>{crs} est géographique ; choisissez un SCR projeté en mètres.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{where}: no point cloud is given.</source>
      <translation>{where} : aucun nuage de points n'est donné.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>The layers {one} and {other} have different CRS, and that of {one} is set by hand. Set the same one for both.</source>
      <translation>Les couches {one} et {other} ont des SCR différents, et celui de {one} est défini à la main. Définissez le même pour les deux.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} cannot be written: {reason}.</source>
      <translation>{layer} ne peut pas être écrit : {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} has no field {fields}; it has {present}.</source>
      <translation>{layer} n'a pas de champ {fields} ; elle a {present}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>Point clouds ({endings})</source>
      <translation>Nuages de points ({endings})</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{where}: the folder {path} holds no point cloud (LAS, LAZ, COPC, E57, PLY).</source>
      <translation>{where} : le dossier {path} ne contient aucun nuage de points (LAS, LAZ, COPC, E57, PLY).</translation>
    </message>
    <message>
      <location filename="../algorithms/support/inputs.py" />
      <source>{layer} cannot be transformed to the CRS of the results: {reason}.</source>
      <translation>{layer} ne peut pas être transformé dans le SCR des résultats : {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>error as targets see it</source>
      <translation>erreur vue par les cibles</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>difference of two epochs as units see it</source>
      <translation>différence de deux époques vue par les blocs</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>strip against its epoch</source>
      <translation>bande par rapport à son époque</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>moved as one</source>
      <translation>déplacé d'un bloc</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>no common motion that could be told</source>
      <translation>pas de mouvement commun décelable</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>found</source>
      <translation>trouvé</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>uncertain</source>
      <translation>incertain</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>new</source>
      <translation>nouveau</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>relocated</source>
      <translation>emporté</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>stable</source>
      <translation>stable</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>moved</source>
      <translation>déplacé</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>rotated</source>
      <translation>tourné</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>lost: the place is empty</source>
      <translation>perdu : la place est vide</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>unseen: known from another epoch</source>
      <translation>non vu : connu d'une autre époque</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>unexplained points where a unit fits</source>
      <translation>points inexpliqués là où un bloc tient</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>hole where a unit fits</source>
      <translation>trou où un bloc tient</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>below the detection limit</source>
      <translation>sous la limite de détection</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>significant</source>
      <translation>significatif</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>watch</source>
      <translation>surveiller</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>alert or more</source>
      <translation>alerte ou plus</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>relocated unit</source>
      <translation>bloc emporté</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>uncertain unit</source>
      <translation>bloc incertain</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>missing end of a broken leg</source>
      <translation>bout manquant d’une branche cassée</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>observed</source>
      <translation>observé</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>derived from the rest of the unit</source>
      <translation>déduit du reste du bloc</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>used</source>
      <translation>utilisé</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>disturbed, not used</source>
      <translation>perturbé, non utilisé</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>not used</source>
      <translation>non utilisé</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>check point</source>
      <translation>point de contrôle</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>placeholder for a unit not found</source>
      <translation>place d’un bloc non trouvé</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>place of a correction</source>
      <translation>lieu d’une correction</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>picked by hand</source>
      <translation>pointé à la main</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Outlines of the units</source>
      <translation>Contours des blocs</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Surfaces of the units (3D)</source>
      <translation>Surfaces des blocs (3D)</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Placement of the units</source>
      <translation>Pose des blocs</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Gaps</source>
      <translation>Lacunes</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Feature points</source>
      <translation>Points caractéristiques</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Displacements</source>
      <translation>Déplacements</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Displacements, other pairs and datum</source>
      <translation>Déplacements, autres paires et autre référence</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Errors of bent frames</source>
      <translation>Erreurs des repères courbés</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Stretches that moved as one</source>
      <translation>Tronçons déplacés d'un bloc</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Control residuals</source>
      <translation>Résidus aux points d'appui</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Check residuals</source>
      <translation>Écarts aux points de contrôle</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Reviews</source>
      <translation>Vérifications</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Corrections and placeholders</source>
      <translation>Corrections et places</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>Points picked by hand</source>
      <translation>Points pointés à la main</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>watch: over {length}</source>
      <translation>surveiller : plus de {length}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>alert or more: over {length}</source>
      <translation>alerte ou plus : plus de {length}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/layers.py" />
      <source>arrow of 10 mm: {length}, at most 30 mm long; ellipse: 95 %</source>
      <translation>flèche de 10 mm : {length}, longueur maximale 30 mm ; ellipse : 95 %</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>Which displacement a planned survey detects</source>
      <translation>Quel déplacement un levé prévu détecte</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>A unit that moves by {length} in its worst direction is found with the chosen power; the mark in the chart.</source>
      <translation>Un bloc qui bouge de {length} dans sa pire direction est trouvé avec la puissance choisie ; la marque du graphique.</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>{share} % of a unit seen</source>
      <translation>{share} % d’un bloc vus</translation>
    </message>
    <message>
      <location filename="../algorithms/support/plan_chart.py" />
      <source>Detectable displacement ({unit})</source>
      <translation>Déplacement détectable ({unit})</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>The epochs and the unit given</source>
      <translation>Les époques et le bloc indiqués</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>{table}, row {row}</source>
      <translation>{table}, ligne {row}</translation>
    </message>
    <message>
      <location filename="../algorithms/support/wording.py" />
      <source>{table}, field names</source>
      <translation>{table}, noms des champs</translation>
    </message>
    <message>
      <location filename="../algorithms/survey_algorithm.py" />
      <source>The tiles declare no CRS: results are in a local frame. Choose the CRS of the results to change that.</source>
      <translation>Les dalles ne déclarent aucun SCR : les résultats sont dans un repère local. Choisissez le SCR des résultats pour changer cela.</translation>
    </message>
    <message>
      <location filename="../algorithms/survey_algorithm.py" />
      <source>Epoch {label}</source>
      <translation>Époque {label}</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Track displacements</source>
      <translation>Suivre les déplacements</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Recognises each unit in all epochs, finds the stable units by a global congruence test and tests the displacement of every feature point and the rotation of every unit against it, with the covariance of fit and registration.</source>
      <translation>Reconnaît chaque bloc à toutes les époques, trouve les blocs stables par un test global de congruence et teste contre eux le déplacement de chaque point caractéristique et la rotation de chaque bloc, avec la covariance de l'ajustement et du rattachement.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>A rotation near 60° or more is ambiguous by the symmetry of the tetrapod and is reported as such.</source>
      <translation>Une rotation proche de 60° ou plus est ambiguë par la symétrie du tétrapode et signalée comme telle.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>displacement,deformation analysis,congruence test,epoch,monitoring</source>
      <translation>déplacement,analyse de déformation,test de congruence,époque,suivi</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Layers of units from Fit tetrapods: one per epoch, each with its own label and time, all in one CRS.</source>
      <translation>Couches de blocs d'Ajuster les tétrapodes : une par époque, chacune avec son nom et son heure, toutes dans un même SCR.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>GeoPackages from Register to control, one per epoch; without them the clouds' own frames are taken as registered.</source>
      <translation>GeoPackages de Rattacher à l'appui, un par époque ; sans eux, les repères propres des nuages passent pour rattachés.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Fitted units of all epochs</source>
      <translation>Blocs ajustés de toutes les époques</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Registrations</source>
      <translation>Rattachements</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>Give the units of at least two epochs.</source>
      <translation>Donnez les blocs d'au moins deux époques.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>The layers of units have different CRS: {crs}.</source>
      <translation>Les couches de blocs ont des SCR différents : {crs}.</translation>
    </message>
    <message>
      <location filename="../algorithms/trackdisplacements.py" />
      <source>no CRS</source>
      <translation>sans SCR</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Validate against check points</source>
      <translation>Valider aux points de contrôle</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Compares feature points of one epoch with the same points surveyed by total station or GNSS. Check points never take part in the fit: their differences show the accuracy that was reached.</source>
      <translation>Compare les points caractéristiques d'une époque aux mêmes points levés à la station totale ou par GNSS. Les points de contrôle n'entrent jamais dans l'ajustement : leurs écarts montrent la précision atteinte.</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>A check point is matched by the approximate centre of its unit; one that matches no unit is named and left out.</source>
      <translation>Un point de contrôle est apparié par le centre approché de son bloc ; celui qui n'en trouve aucun est nommé et écarté.</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>validation,accuracy,check points,total station,GNSS,RMSE</source>
      <translation>validation,précision,points de contrôle,station totale,GNSS,EQM</translation>
    </message>
    <message>
      <location filename="../algorithms/validatesurvey.py" />
      <source>Layer from Extract feature points, of one epoch.</source>
      <translation>Couche d'Extraire les points caractéristiques, d'une époque.</translation>
    </message>
    <message>
      <location filename="../plugin/engine_task.py" />
      <source>Cancelled.</source>
      <translation>Annulé.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Creating the tetratrack engine</source>
      <translation>Création du moteur tetratrack</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Another window of QGIS is creating the engine at this moment.</source>
      <translation>Une autre fenêtre de QGIS est en train de créer le moteur.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Making an empty environment</source>
      <translation>Création d'un environnement vide</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Trying the libraries</source>
      <translation>Essai des bibliothèques</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine's environment could not be created: {reason} (everything that was said: {log})</source>
      <translation>L'environnement du moteur n'a pas pu être créé : {reason} (toute la sortie : {log})</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Compiling, so that the first run need not wait</source>
      <translation>Compilation, pour que la première exécution n’attende pas</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Looking for the libraries</source>
      <translation>Recherche des bibliothèques</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Fetching {name}: {done} of about {all} MB</source>
      <translation>Téléchargement de {name} : {done} sur environ {all} Mo</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Unpacking libraries: {count} of {all}</source>
      <translation>Décompression des bibliothèques : {count} sur {all}</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine needs {needed} GB on the disk of {folder}, and {free} GB are free.</source>
      <translation>Le moteur a besoin de {needed} Go sur le disque de {folder}, et {free} Go sont libres.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>{wheels} holds no wheels.</source>
      <translation>{wheels} ne contient aucun wheel.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>{wheels} lacks {count} of the wheels that this version of the plugin needs: {names}.</source>
      <translation>Il manque dans {wheels} {count} des wheels dont cette version de l'extension a besoin : {names}.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>The engine in use cannot be replaced now: wait until its runs have ended.</source>
      <translation>Le moteur en service ne peut pas être remplacé maintenant : attendez la fin de ses calculs.</translation>
    </message>
    <message>
      <location filename="../plugin/environment_task.py" />
      <source>Unpacking {file}</source>
      <translation>Décompression de {file}</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Choose a file…</source>
      <translation>Choisir un fichier…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Add an epoch</source>
      <translation>Ajouter une époque</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Remove the selected epochs</source>
      <translation>Retirer les époques sélectionnées</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>user-defined</source>
      <translation>personnalisé</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Choose…</source>
      <translation>Choisir…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Table of points</source>
      <translation>Table de points</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Tables (*.csv *.txt *.gpkg);;All files (*)</source>
      <translation>Tables (*.csv *.txt *.gpkg);;Tous les fichiers (*)</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Files…</source>
      <translation>Fichiers…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Folder…</source>
      <translation>Dossier…</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_table.py" />
      <source>Layer {name}</source>
      <translation>Couche {name}</translation>
    </message>
    <message>
      <location filename="../plugin/epoch_wrapper.py" />
      <source>{count} epochs…</source>
      <translation>{count} époques…</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Arrows move, + and - zoom, Home resets; Enter picks the point in the middle</source>
      <translation>Les flèches déplacent, + et - zooment, Début rétablit ; Entrée choisit le point au milieu</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Plan of the unit</source>
      <translation>Plan du bloc</translation>
    </message>
    <message>
      <location filename="../plugin/keyboard.py" />
      <source>Section of the unit</source>
      <translation>Coupe du bloc</translation>
    </message>
    <message>
      <location filename="../plugin/length_widget.py" />
      <source>Length in the project's unit</source>
      <translation>Longueur dans l'unité du projet</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python 3.11 to 3.13 was not found: install it, or choose an interpreter of the engine above.</source>
      <translation>Python 3.11 à 3.13 est introuvable : installez-le ou choisissez ci-dessus un interpréteur pour le moteur.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create a Python environment in {folder} and download libraries into it? It takes about {size} of disk.</source>
      <translation>Créer un environnement Python dans {folder} et y télécharger des bibliothèques ? Il occupe environ {size} sur le disque.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create a Python environment in {folder} from the wheels in {wheels}? It takes about {size} of disk.</source>
      <translation>Créer un environnement Python dans {folder} à partir des wheels de {wheels} ? Il occupe environ {size} sur le disque.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Try again…</source>
      <translation>Réessayer…</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python interpreter of the engine</source>
      <translation>Interpréteur Python du moteur</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Empty uses the environment that the plugin creates; a folder of an environment will do.</source>
      <translation>Vide utilise l'environnement que crée l'extension ; le dossier d'un environnement convient.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Folder or ZIP of wheels</source>
      <translation>Dossier ou ZIP de wheels</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>For computers without a network: what was fetched on another one. Empty fetches the libraries.</source>
      <translation>Pour les ordinateurs sans réseau : ce qui a été téléchargé sur un autre. Vide : les bibliothèques sont téléchargées.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create the engine's environment…</source>
      <translation>Créer l'environnement du moteur…</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Cancel</source>
      <translation>Annuler</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Show the log</source>
      <translation>Afficher le journal</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Engine</source>
      <translation>Moteur</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>State</source>
      <translation>État</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>The engine is ready.</source>
      <translation>Le moteur est prêt.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} is no file.</source>
      <translation>{python} n'est pas un fichier.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} is no Python interpreter.</source>
      <translation>{python} n'est pas un interpréteur Python.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} is Python {version}; the engine needs 3.11 or later.</source>
      <translation>{python} est Python {version} ; le moteur demande 3.11 ou plus.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>{python} lacks the engine's libraries: {modules}.</source>
      <translation>Il manque à {python} les bibliothèques du moteur : {modules}.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Used: {python}</source>
      <translation>Utilisé : {python}</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Can be used: {python}</source>
      <translation>Utilisable : {python}</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the disk is full</source>
      <translation>le disque est plein</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>this Python cannot make environments; on Debian and Ubuntu install python3-venv first</source>
      <translation>ce Python ne peut pas créer d'environnements ; sous Debian et Ubuntu, installez d'abord python3-venv</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy wants a user name and password: state them in Settings &gt; Options &gt; Network</source>
      <translation>le proxy demande un nom d'utilisateur et un mot de passe : indiquez-les dans Préférences &gt; Options &gt; Réseau</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy is of the kind SOCKS, which the installer does not know; choose a folder of wheels</source>
      <translation>le proxy est de type SOCKS, que l'installateur ne connaît pas ; choisissez un dossier de wheels</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the registry's certificate is not trusted: import your network's authority in Settings &gt; Options &gt; Authentication</source>
      <translation>le certificat du dépôt n'est pas reconnu : importez l'autorité de votre réseau dans Préférences &gt; Options &gt; Authentification</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the proxy cannot be reached: see Settings &gt; Options &gt; Network</source>
      <translation>le proxy est inaccessible : voyez Préférences &gt; Options &gt; Réseau</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>a file is not the one that this version of the plugin needs: it was damaged or changed on its way; try again</source>
      <translation>un fichier n'est pas celui dont cette version de l'extension a besoin : il a été endommagé ou modifié en chemin ; réessayez</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>the connection broke while a file was fetched; try again, what is complete is not fetched twice</source>
      <translation>la connexion a été coupée pendant un téléchargement ; réessayez, ce qui est complet n'est pas téléchargé deux fois</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>no package registry can be reached from this computer; without a network choose a folder of wheels</source>
      <translation>aucun dépôt de paquets n'est accessible depuis cet ordinateur ; sans réseau, choisissez un dossier de wheels</translation>
    </message>
    <message>
      <location filename="../plugin/pip_words.py" />
      <source>a library of the system is missing; on Debian and Ubuntu install libegl1 libgl1 libgomp1</source>
      <translation>une bibliothèque du système manque ; sous Debian et Ubuntu, installez libegl1 libgl1 libgomp1</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>Displacements of armour units</source>
      <translation>Déplacements des blocs de carapace</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>Legend</source>
      <translation>Légende</translation>
    </message>
    <message>
      <location filename="../plugin/print_map.py" />
      <source>{pair}, datum: {datum}</source>
      <translation>{pair}, référence : {datum}</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Ended: nothing was stored.</source>
      <translation>Terminé : rien n'a été enregistré.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints</source>
      <translation>Fixer par trois jonctions</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fit again after a click on the unit (earlier epoch)</source>
      <translation>Réajuster après un clic sur le bloc (époque antérieure)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fit again after a click on the unit (later epoch)</source>
      <translation>Réajuster après un clic sur le bloc (époque postérieure)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints of legs (earlier epoch)</source>
      <translation>Fixer par trois jonctions de branches (époque antérieure)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints of legs (later epoch)</source>
      <translation>Fixer par trois jonctions de branches (époque postérieure)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pick feature points beside the fit (earlier epoch)</source>
      <translation>Pointer des points caractéristiques à côté de l'ajustement (époque antérieure)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pick feature points beside the fit (later epoch)</source>
      <translation>Pointer des points caractéristiques à côté de l'ajustement (époque postérieure)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Placeholder for a unit not found</source>
      <translation>Emplacement réservé pour un bloc non trouvé</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Merge the two selected units</source>
      <translation>Fusionner les deux blocs choisis</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Split at the later epoch: two units taken for one</source>
      <translation>Scinder à l'époque postérieure : deux blocs pris pour un</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Delete: not a unit</source>
      <translation>Supprimer : pas un bloc</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Take back your last correction</source>
      <translation>Annuler votre dernière correction</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Read the points around the units…</source>
      <translation>Lire les points autour des blocs…</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The points around the units are needed: read them from the correction menu.</source>
      <translation>Les points autour des blocs sont nécessaires : lisez-les par le menu de correction.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>There are no points here; click on the cloud.</source>
      <translation>Il n'y a pas de points ici ; cliquez sur le nuage.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The unit has no pose in any epoch to take its size from.</source>
      <translation>Le bloc n'a de pose à aucune époque pour en tirer sa taille.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Nothing was stored: pick the three joints again.</source>
      <translation>Rien n'a été enregistré : pointez de nouveau les trois jonctions.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>pinned by three joints</source>
      <translation>fixé par trois jonctions</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The three points do not fit the shape of {unit}: they are {misfit} off, where {worst} would be usual. Were they joints of this unit? Store the pose all the same?</source>
      <translation>Les trois points ne correspondent pas à la forme de {unit} : écart de {misfit}, contre {worst} d'ordinaire. Étaient-ce des jonctions de ce bloc ? Enregistrer la pose quand même ?</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>The unit was not found in this epoch: pin it by three joints instead.</source>
      <translation>Le bloc n'a pas été trouvé à cette époque : fixez-le plutôt par trois jonctions.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Select the two units to merge.</source>
      <translation>Choisissez les deux blocs à fusionner.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>There is no correction of yours to take back.</source>
      <translation>Vous n'avez aucune correction à annuler.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Survey description</source>
      <translation>Description du levé</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Survey (*.toml)</source>
      <translation>Levé (*.toml)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Reading points around units</source>
      <translation>Lecture des points autour des blocs</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Points read.</source>
      <translation>Points lus.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Select a unit first.</source>
      <translation>Choisissez d'abord un bloc.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click the middle of the unit on the map or in a view; Escape ends.</source>
      <translation>Cliquez le milieu du bloc sur la carte ou dans une vue ; Échap termine.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click three joints where three legs meet, on the map or in the views; Escape ends.</source>
      <translation>Cliquez trois jonctions où trois branches se rencontrent, sur la carte ou dans les vues ; Échap termine.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click a joint where three legs meet; Escape ends.</source>
      <translation>Cliquez une jonction où trois branches se rencontrent ; Échap termine.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click where the unit lies on the map; Escape ends.</source>
      <translation>Cliquez l'emplacement du bloc sur la carte ; Échap termine.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Fitting {unit} again</source>
      <translation>Réajustement de {unit}</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} was fitted again.</source>
      <translation>{unit} a été réajusté.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} pinned; the picks fit within {length}.</source>
      <translation>{unit} fixé ; les pointés s'accordent à {length} près.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{feature} picked, {length} from the fit.</source>
      <translation>{feature} pointé, à {length} de l'ajustement.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Placeholder {name} stored; it counts as a unit not found.</source>
      <translation>Emplacement {name} enregistré ; il compte comme bloc non trouvé.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{count} of 3 joints.</source>
      <translation>{count} jonctions sur 3.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{other} is now {keep}.</source>
      <translation>{other} est désormais {keep}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} is called {name} from {epoch} on.</source>
      <translation>{unit} s'appelle {name} à partir de {epoch}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>{unit} was deleted; take it back from the correction menu.</source>
      <translation>{unit} a été supprimé ; annulez par le menu de correction.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Taken back: {kind} {unit}.</source>
      <translation>Repris : {kind} {unit}.</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n significant</source>
      <translation>
        <numerusform>%n significatif</numerusform>
        <numerusform>%n significatifs</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n decided</source>
      <translation>
        <numerusform>%n décidé</numerusform>
        <numerusform>%n décidés</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n rejected, excluded from statistics and map</source>
      <translation>
        <numerusform>%n rejeté, exclu des statistiques et de la carte</numerusform>
        <numerusform>%n rejetés, exclus des statistiques et de la carte</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Leg</source>
      <translation>Branche</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Its end</source>
      <translation>Son bout</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Probability of a break</source>
      <translation>Probabilité de rupture</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Points to</source>
      <translation>Pointe vers</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Check point</source>
      <translation>Point de contrôle</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Feature</source>
      <translation>Point caractéristique</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Surveyed</source>
      <translation>Levé</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Fitted</source>
      <translation>Ajusté</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Difference</source>
      <translation>Écart</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n lost</source>
      <translation>
        <numerusform>%n perdu</numerusform>
        <numerusform>%n perdus</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n new</source>
      <translation>
        <numerusform>%n nouveau</numerusform>
        <numerusform>%n nouveaux</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n with a broken leg</source>
      <translation>
        <numerusform>%n avec une branche cassée</numerusform>
        <numerusform>%n avec une branche cassée</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>3D displacement</source>
      <translation>Déplacement 3D</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>in heights H, in nominal diameters Dn</source>
      <translation>en hauteurs H, en diamètres nominaux Dn</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Easting</source>
      <translation>Est</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Northing</source>
      <translation>Nord</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Height</source>
      <translation>Hauteur</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Horizontal</source>
      <translation>Horizontal</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>not significant</source>
      <translation>non significatif</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Detection limit</source>
      <translation>Limite de détection</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{length}, towards {azimuth}° from grid north</source>
      <translation>{length}, vers {azimuth}° depuis le nord de la grille</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Score of the fit, 0 to 1</source>
      <translation>Score de l'ajustement, 0 à 1</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Legs seen, of four</source>
      <translation>Branches vues, sur quatre</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Broken legs</source>
      <translation>Branches cassées</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Ends not seen, of legs</source>
      <translation>Bouts non vus, des branches</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_details.py" />
      <source>%n of {all} units shown</source>
      <translation>
        <numerusform>%n bloc sur {all} montré</numerusform>
        <numerusform>%n blocs sur {all} montrés</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>none: one of the two positions is not known</source>
      <translation>aucun : une des deux positions est inconnue</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Test against no motion</source>
      <translation>Test contre l'immobilité</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Missing ({unit})</source>
      <translation>Manque ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Check points ({unit})</source>
      <translation>Points de contrôle ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Nobody has decided on this unit yet.</source>
      <translation>Personne n'a encore décidé de ce bloc.</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>largest {length}</source>
      <translation>maximum {length}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Seen in {epoch}</source>
      <translation>Vu en {epoch}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Legs</source>
      <translation>Branches</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Points to: degrees from grid north, and above the horizon</source>
      <translation>Pointe vers : degrés depuis le nord de la grille, et au-dessus de l’horizon</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>± one standard deviation</source>
      <translation>± un écart-type</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Picked by hand</source>
      <translation>Pointé à la main</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>taken back by {who}</source>
      <translation>annulé par {who}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{feature}, {epoch}: picked {length} from the fit ({who})</source>
      <translation>{feature}, {epoch} : pointé à {length} de l'ajustement ({who})</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_dock.py" />
      <source>%n units</source>
      <translation>
        <numerusform>%n bloc</numerusform>
        <numerusform>%n blocs</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Displacement review</source>
      <translation>Vérification des déplacements</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Open a result</source>
      <translation>Ouvrir un résultat</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>GeoPackage (*.gpkg)</source>
      <translation>GeoPackage (*.gpkg)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Previous unit (Up, or P for the previous undecided)</source>
      <translation>Bloc précédent (Haut, ou P pour le précédent non décidé)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Next unit (Down, or N for the next undecided)</source>
      <translation>Bloc suivant (Bas, ou N pour le suivant non décidé)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Zoom to the unit and flash it (Z)</source>
      <translation>Zoomer sur le bloc et le faire clignoter (Z)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The map follows the selection</source>
      <translation>La carte suit la sélection</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Show all units</source>
      <translation>Montrer tous les blocs</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>A click on the map picks the unit or arrow there</source>
      <translation>Un clic sur la carte choisit le bloc ou la flèche qui s’y trouve</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Correct a unit</source>
      <translation>Corriger un bloc</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Write the report…</source>
      <translation>Écrire le rapport…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Report with more choices…</source>
      <translation>Rapport avec plus de choix…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>A page to print, with the map as it stands</source>
      <translation>Une page à imprimer, avec la carte telle quelle</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Export the alarm list…</source>
      <translation>Exporter la liste d'alerte…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Web page (*.html);;PDF (*.pdf)</source>
      <translation>Page web (*.html);;PDF (*.pdf)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Alarm list</source>
      <translation>Liste d'alerte</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>CSV (*.csv);;GeoJSON (*.geojson)</source>
      <translation>CSV (*.csv);;GeoJSON (*.geojson)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Decisions of another reviewer were taken in.</source>
      <translation>Les décisions d'un autre vérificateur ont été reprises.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Corrections of another reviewer were taken in.</source>
      <translation>Les corrections d'un autre relecteur ont été prises en compte.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>A run replaced the result: its numbers are shown now.</source>
      <translation>Un calcul a remplacé le résultat : ses valeurs sont maintenant affichées.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>In polygons</source>
      <translation>Dans les polygones</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>No unit passes the filter.</source>
      <translation>Aucun bloc ne passe le filtre.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Enter your name or initials first: they stand beside every decision.</source>
      <translation>Entrez d'abord votre nom ou vos initiales : ils figurent à côté de chaque décision.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Confirmed.</source>
      <translation>Confirmé.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Writing the report</source>
      <translation>Écriture du rapport</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Threshold ({unit})</source>
      <translation>Seuil ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{name} was closed with its layers. Every decision is stored: open it again to go on.</source>
      <translation>{name} a été fermé avec ses couches. Toutes les décisions sont enregistrées : rouvrez-le pour continuer.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Make a polygon layer active first.</source>
      <translation>Activez d'abord une couche de polygones.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The active layer holds no polygon.</source>
      <translation>La couche active ne contient aucun polygone.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>In the map window</source>
      <translation>Dans la fenêtre de carte</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Everywhere</source>
      <translation>Partout</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>The page {name} is in the project's layouts.</source>
      <translation>La page {name} est dans les mises en page du projet.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{title}…</source>
      <translation>{title}…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{name} is read-only: you can look, but decisions cannot be stored.</source>
      <translation>{name} est en lecture seule : vous pouvez regarder, mais aucune décision ne peut être enregistrée.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{units}: {decision}, stored.</source>
      <translation>{units} : {decision}, enregistré.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Taken back: {units}.</source>
      <translation>Repris : {units}.</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Report written to {name}.</source>
      <translation>Rapport écrit dans {name}.</translation>
    </message>
    <message numerus="yes">
      <location filename="../plugin/review_dock.py" />
      <source>Units written to {name}: %n.</source>
      <translation>
        <numerusform>%n bloc écrit dans {name}.</numerusform>
        <numerusform>%n blocs écrits dans {name}.</numerusform>
      </translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Open 3D view</source>
      <translation>Ouvrir la vue 3D</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Model, sections and design</source>
      <translation>Modèle, coupes et projet</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Export as-built model…</source>
      <translation>Exporter le modèle tel que construit…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Compare with design…</source>
      <translation>Comparer au projet…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Cross-sections and crest…</source>
      <translation>Coupes et crête…</translation>
    </message>
    <message>
      <location filename="../plugin/review_exports.py" />
      <source>Points less blocks…</source>
      <translation>Points moins blocs…</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Units reviewed</source>
      <translation>Blocs vérifiés</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements reviewed</source>
      <translation>Déplacements vérifiés</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements reviewed, other pair or datum</source>
      <translation>Déplacements vérifiés, autre paire ou référence</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Rejected units (excluded)</source>
      <translation>Blocs rejetés (exclus)</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Placeholders and corrections</source>
      <translation>Places et corrections</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacement review: {name}</source>
      <translation>Vérification des déplacements : {name}</translation>
    </message>
    <message>
      <location filename="../plugin/review_map.py" />
      <source>Displacements: {datum}</source>
      <translation>Déplacements : {datum}</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Epochs compared</source>
      <translation>Époques comparées</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>All classes</source>
      <translation>Toutes les classes</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Classes shown</source>
      <translation>Classes montrées</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Least 3D displacement shown; lost, new and relocated units are always shown</source>
      <translation>Plus petit déplacement 3D montré ; blocs perdus, nouveaux et emportés sont toujours montrés</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Area of the units shown</source>
      <translation>Zone des blocs montrés</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Undecided only</source>
      <translation>Non décidés seulement</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>On the map too</source>
      <translation>Sur la carte aussi</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The map shows only the units that the list shows</source>
      <translation>La carte ne montre que les blocs que montre la liste</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Unit…</source>
      <translation>Bloc…</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Comment, stored with the decision</source>
      <translation>Commentaire, enregistré avec la décision</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Your name or initials, stored with every decision</source>
      <translation>Votre nom ou vos initiales, enregistrés avec chaque décision</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>In the active layer's polygons</source>
      <translation>Dans les polygones de la couche active</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Accept</source>
      <translation>Accepter</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The displacement is right (A)</source>
      <translation>Le déplacement est juste (A)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Reject</source>
      <translation>Rejeter</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>The displacement is wrong: it leaves statistics, maps and report (R)</source>
      <translation>Le déplacement est faux : il quitte statistiques, cartes et rapport (R)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Inspect</source>
      <translation>Inspecter</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Inspect on site (I)</source>
      <translation>Inspecter sur place (I)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Confirm</source>
      <translation>Confirmer</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Confirm another reviewer's decision (C)</source>
      <translation>Confirmer la décision d'un autre vérificateur (C)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Undo</source>
      <translation>Annuler</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Take back your last decision (U)</source>
      <translation>Reprendre votre dernière décision (U)</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Open</source>
      <translation>Ouvrir</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Plan</source>
      <translation>Plan</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Select a unit</source>
      <translation>Choisissez un bloc</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>N</source>
      <translation>N</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Section {azimuth}°</source>
      <translation>Coupe {azimuth}°</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Series</source>
      <translation>Série</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Section along the displacement</source>
      <translation>Coupe le long du déplacement</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Direction of the section, from grid north; each outline is cut through its own centre</source>
      <translation>Direction de la coupe, depuis le nord de la grille ; chaque contour est coupé par son propre centre</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Read the points…</source>
      <translation>Lire les points…</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Reads the points around the units from the tiles of the survey, for the views and for picking</source>
      <translation>Lit dans les dalles du levé les points autour des blocs, pour les vues et le pointage</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>Numbers</source>
      <translation>Nombres</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>History</source>
      <translation>Historique</translation>
    </message>
    <message>
      <location filename="../plugin/review_tabs.py" />
      <source>points not read yet</source>
      <translation>points pas encore lus</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>lost</source>
      <translation>perdu</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>unseen</source>
      <translation>non vu</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>deleted</source>
      <translation>supprimé</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>merged</source>
      <translation>fusionné</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>split</source>
      <translation>scindé</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>new pose</source>
      <translation>nouvelle pose</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>points picked</source>
      <translation>points pointés</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>placeholder</source>
      <translation>emplacement réservé</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Displ.</source>
      <translation>Dépl.</translation>
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
      <translation>Vu</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Broken</source>
      <translation>Cassées</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Name of the unit, the same in all epochs</source>
      <translation>Nom du bloc, le même à toutes les époques</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Class of the displacement, or the unit's fate</source>
      <translation>Classe du déplacement, ou sort du bloc</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Rotation between the epochs (degrees)</source>
      <translation>Rotation entre les époques (degrés)</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Probability of so large a displacement if the unit stood still; bold where significant</source>
      <translation>Probabilité d'un déplacement aussi grand si le bloc était immobile ; en gras si significatif</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Share of the unit's surface that holds points, in the worse epoch</source>
      <translation>Part de la surface du bloc qui porte des points, à l'époque la moins bonne</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Numbers of the legs that are broken; the page Numbers says how sure that is, and which ends are not seen</source>
      <translation>Numéros des branches cassées ; la page Nombres dit avec quelle certitude, et quels bouts ne sont pas vus</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Decision of the reviewers</source>
      <translation>Décision des vérificateurs</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Who decided, and ✓ who confirmed</source>
      <translation>Qui a décidé, et ✓ qui a confirmé</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>whole</source>
      <translation>entière</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>broken</source>
      <translation>cassée</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>not seen</source>
      <translation>pas vu</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>accepted</source>
      <translation>accepté</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>rejected</source>
      <translation>rejeté</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>inspect</source>
      <translation>inspecter</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>decided</source>
      <translation>a décidé</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>confirmed</source>
      <translation>a confirmé</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>took back</source>
      <translation>a repris</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>changed the numbers, which ended</source>
      <translation>a changé les chiffres, ce qui a mis fin à</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>brought back the numbers of</source>
      <translation>a rétabli les chiffres de</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>3D displacement of the centre ({unit})</source>
      <translation>Déplacement 3D du centre ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Horizontal displacement of the centre ({unit})</source>
      <translation>Déplacement horizontal du centre ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Vertical displacement of the centre, positive up ({unit})</source>
      <translation>Déplacement vertical du centre, positif vers le haut ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>3D displacement since {epoch} ({unit}), bands of 95 %</source>
      <translation>Déplacement 3D depuis {epoch} ({unit}), bandes à 95 %</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>No displacement of this unit</source>
      <translation>Aucun déplacement de ce bloc</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>centre</source>
      <translation>centre</translation>
    </message>
    <message>
      <location filename="../plugin/series_view.py" />
      <source>detection limit</source>
      <translation>limite de détection</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Open result…</source>
      <translation>Ouvrir un résultat…</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Take the point cloud layers</source>
      <translation>Prendre les couches de nuages de points</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>The files of the project's point cloud layers, in place of a folder</source>
      <translation>Les fichiers des couches de nuages de points du projet, au lieu d'un dossier</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>estimated from the cloud</source>
      <translation>estimée d’après le nuage</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>as the tiles declare</source>
      <translation>comme le déclarent les dalles</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Run</source>
      <translation>Exécuter</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Open the result.gpkg of a survey with two epochs or more to review its displacements.</source>
      <translation>Ouvrez le result.gpkg d'un levé de deux époques ou plus pour vérifier ses déplacements.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Or make one: choose the folder that holds the tiles of all epochs, look through the table, press Run.</source>
      <translation>Ou faites-en un : choisissez le dossier qui contient les dalles de toutes les époques, parcourez la table, appuyez sur Exécuter.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Height H of the unit</source>
      <translation>Hauteur H du bloc</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Looking at the tiles</source>
      <translation>Examen des dalles</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Writing the survey</source>
      <translation>Écriture du levé</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>The project has no point cloud layer that lies in a file: choose a folder instead.</source>
      <translation>Le projet n’a aucune couche de nuage de points dans un fichier : choisissez plutôt un dossier.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Choose where the result is to be written.</source>
      <translation>Choisissez où écrire le résultat.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Answer first what is asked above.</source>
      <translation>Répondez d’abord à ce qui est demandé ci-dessus.</translation>
    </message>
    <message>
      <location filename="../plugin/start_page.py" />
      <source>Units of {heights} m height.</source>
      <translation>Blocs de {heights} m de hauteur.</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Monitor a survey…</source>
      <translation>Suivre un levé…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Try the sample…</source>
      <translation>Essayer l'exemple…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Engine…</source>
      <translation>Moteur…</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>An engine is needed before anything can be computed.</source>
      <translation>Un moteur est nécessaire avant tout calcul.</translation>
    </message>
    <message>
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>The sample cannot be copied to {folder}: {reason}.</source>
      <translation>L'exemple ne peut pas être copié dans {folder} : {reason}.</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>Tetrapods in 3D</source>
      <translation>Tétrapodes en 3D</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>Displacements in 3D</source>
      <translation>Déplacements en 3D</translation>
    </message>
    <message>
      <location filename="../plugin/view_3d.py" />
      <source>significant displacement, enlarged {scale} times</source>
      <translation>déplacement significatif, agrandi {scale} fois</translation>
    </message>
    <message>
      <location filename="../core/report/templates/report.html" />
      <source>a local frame</source>
      <translation>un repère local</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>Blocks</source>
      <translation>Blocs</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>View of the blocks by class</source>
      <translation>Vue des blocs par classe</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_blocks.html" />
      <source>Fitted units of {epoch} by class, seen from the low side.</source>
      <translation>Blocs ajustés de {epoch} par classe, vus du côté bas.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Castings</source>
      <translation>Blocs coulés</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Mould {name} of an earlier survey, of {units} units, is held.</source>
      <translation>Le moule {name} d'un levé antérieur, tiré de {units} blocs, est imposé.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>The mould was learned from {units} units of this survey.</source>
      <translation>Le moule a été déterminé à partir de {units} blocs de ce levé.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>H = {height} m: radius {radius} m, taper {taper}. Size of single castings ± {size}, radius of single legs ± {leg} mm (one standard deviation).</source>
      <translation>H = {height} m : rayon {radius} m, conicité {taper}. Taille des blocs ± {size}, rayon des branches ± {leg} mm (un écart-type).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Departure of the mould from its cones: along a leg, and unrolled around it. What is alike on all units is held; how single castings differ widens the standard deviations where two epochs see other surfaces.</source>
      <translation>Écart du moule à ses cônes : le long d'une branche, et déroulé autour d'elle. Ce qui est commun à tous les blocs est imposé ; ce qui les distingue élargit les écarts-types là où deux époques voient d'autres surfaces.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Too few units show enough of themselves for a mould: cones are held, and castings vary as the literature says.</source>
      <translation>Trop peu de blocs se montrent assez pour un moule : les cônes sont imposés, et les blocs varient comme le dit la littérature.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs seen whole: {whole}, broken: {broken}; the ends of {unseen} are not seen, and nothing is said of them.</source>
      <translation>Branches vues entières : {whole}, cassées : {broken} ; le bout de {unseen} n'est pas vu, et rien n'en est dit.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Broken leg</source>
      <translation>Branche cassée</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Missing (m)</source>
      <translation>Manque (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Break: easting (m)</source>
      <translation>Cassure : est (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Northing (m)</source>
      <translation>Nord (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Height (m)</source>
      <translation>Altitude (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs whose ends are not seen</source>
      <translation>Branches dont le bout n’est pas vu</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Whither a leg points: degrees from grid north clockwise, and above the horizon. The place is that of the face of fracture, or of the leg's whole end where the result does not say how much of it is missing.</source>
      <translation>Vers où pointe une branche : degrés depuis le nord de la grille dans le sens des aiguilles d'une montre, et au-dessus de l'horizon. La position est celle de la cassure, ou celle du bout de la branche entière lorsque le résultat ne dit pas combien il en manque.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs by section along the axis</source>
      <translation>Branches par section le long de l’axe</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Chainage (m)</source>
      <translation>Abscisse (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Units with a broken leg</source>
      <translation>Blocs avec une branche cassée</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Legs seen whole</source>
      <translation>Branches vues entières</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>Ends not seen</source>
      <translation>Bouts non vus</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_castings.html" />
      <source>The result was made by a version that said nothing of legs.</source>
      <translation>Le résultat vient d'une version qui ne disait rien des branches.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Comparison with surveyed check points</source>
      <translation>Comparaison avec les points de contrôle levés</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Picked by hand (cm)</source>
      <translation>Pointé à la main (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Fitting (cm)</source>
      <translation>Ajustement (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Surveyed (cm)</source>
      <translation>Levé (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Error, picked (cm)</source>
      <translation>Erreur, pointé (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>Error, fitting (cm)</source>
      <translation>Erreur, ajustement (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>3D displacements of the same feature point, in the control frame (after Chan and Lichti, Table 1).</source>
      <translation>Déplacements 3D du même point caractéristique, dans le repère d'appui (d'après Chan and Lichti, tableau 1).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_check.html" />
      <source>The survey has no check points that both epochs share.</source>
      <translation>Le levé n'a pas de points de contrôle communs aux deux époques.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Survey control</source>
      <translation>Appui topographique</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Congruence of the stable units</source>
      <translation>Congruence des blocs stables</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Units that stand still together: {stable} of {all}; test of their congruence: p {p}.</source>
      <translation>Blocs immobiles ensemble : {stable} sur {all} ; test de leur congruence : p {p}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Their common motion against the control points: east {e}, north {n}, up {h} cm; p {p}.</source>
      <translation>Leur mouvement commun par rapport aux points d'appui : est {e}, nord {n}, haut {h} cm ; p {p}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>East (mm)</source>
      <translation>Est (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>North (mm)</source>
      <translation>Nord (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Height (mm)</source>
      <translation>Altitude (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Use</source>
      <translation>Emploi</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>disturbed, left out</source>
      <translation>perturbé, écarté</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>Residuals of the registration; w is the largest normalised residual of the three coordinates.</source>
      <translation>Résidus du rattachement ; w est le plus grand résidu normalisé des trois coordonnées.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_control.html" />
      <source>There is no survey control: displacements are relative to the frame of the clouds.</source>
      <translation>Il n'y a pas d'appui : les déplacements se rapportent au repère des nuages.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Damage</source>
      <translation>Dommages</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>H = {height} m, Dn = {diameter} m. Lost and relocated units count as displaced by every threshold.</source>
      <translation>H = {height} m, Dn = {diameter} m. Les blocs perdus et emportés comptent comme déplacés à tous les seuils.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Displaced by at least</source>
      <translation>Déplacé d'au moins</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Threshold (m)</source>
      <translation>Seuil (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Share</source>
      <translation>Part</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>State of the armour in the words of Campos et al. (2020):</source>
      <translation>État de la carapace selon les termes de Campos et al. (2020) :</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>No damage: no unit moved by one Dn or is lost. Initiation of damage: some did. Iribarren's damage: neighbours of the outer layer did. Initiation of destruction: a unit of the layer below did. Destruction cannot be told from units.</source>
      <translation>Aucun dommage : aucun bloc n'a bougé d'un Dn ni n'est perdu. Début de dommage : certains l'ont fait. Dommage d'Iribarren : des voisins de la couche extérieure. Début de destruction : un bloc de la couche inférieure. La destruction ne se voit pas aux blocs.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>over {width} m: units displaced by one Dn or more, relocated or lost, per Dn of width (van der Meer, 1988).</source>
      <translation>sur {width} m : blocs déplacés d'un Dn ou plus, emportés ou perdus, par Dn de largeur (van der Meer, 1988).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Sections along the axis</source>
      <translation>Sections le long de l'axe</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>Share of displaced units per section</source>
      <translation>Part de blocs déplacés par section</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_damage.html" />
      <source>No unit has a displacement to show.</source>
      <translation>Aucun bloc n'a de déplacement à montrer.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>Decisions and corrections</source>
      <translation>Décisions et corrections</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>inspect on site</source>
      <translation>inspecter sur place</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>No reviewer has decided on this epoch pair.</source>
      <translation>Aucun vérificateur n'a décidé de cette paire d'époques.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>Correction</source>
      <translation>Correction</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_decisions.html" />
      <source>By</source>
      <translation>Par</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>As-built against design</source>
      <translation>Ouvrage réalisé et projet</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Map of the units against the design</source>
      <translation>Carte des blocs par rapport au projet</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units of {epoch} against the design; coordinates in {crs}.</source>
      <translation>Blocs de {epoch} par rapport au projet ; coordonnées en {crs}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units at a planned place</source>
      <translation>Blocs à une place prévue</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Within the tolerance</source>
      <translation>Dans la tolérance</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Outside the tolerance</source>
      <translation>Hors de la tolérance</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Cannot be told</source>
      <translation>Indécis</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Deviation, median and largest (cm)</source>
      <translation>Écart, médiane et maximum (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Planned</source>
      <translation>Prévu</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>East (cm)</source>
      <translation>Est (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>North (cm)</source>
      <translation>Nord (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Up (cm)</source>
      <translation>Haut (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Deviation (cm)</source>
      <translation>Écart (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Rotation (°)</source>
      <translation>Rotation (°)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>The {count} units farthest from their place; all stand in the file of tetratrack design.</source>
      <translation>Les {count} blocs les plus éloignés de leur place ; tous sont dans le fichier de tetratrack design.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Units under the profile's lines</source>
      <translation>Blocs sous les lignes du profil</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Centre off the design, mean and RMS (m)</source>
      <translation>Centre par rapport au projet, moyenne et RMS (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>Outermost point, mean and RMS (m)</source>
      <translation>Point extrême, moyenne et RMS (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_design.html" />
      <source>A unit is within or outside the tolerance where its standard deviation leaves no doubt of 5 % or more.</source>
      <translation>Un bloc est dans ou hors de la tolérance lorsque son écart-type ne laisse pas un doute de 5 % ou plus.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Map of displacements</source>
      <translation>Carte des déplacements</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Displacement of the units' centres.</source>
      <translation>Déplacement des centres des blocs.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Histogram of displacements</source>
      <translation>Histogramme des déplacements</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_displacements.html" />
      <source>Displacements of all units with the thresholds of the next section.</source>
      <translation>Déplacements de tous les blocs avec les seuils de la section suivante.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Units, one by one</source>
      <translation>Les blocs un par un</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Zoom in</source>
      <translation>Zoom avant</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Zoom out</source>
      <translation>Zoom arrière</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Whole map</source>
      <translation>Carte entière</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Arrows</source>
      <translation>Flèches</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Map of the units by class</source>
      <translation>Carte des blocs par classe</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Search</source>
      <translation>Rechercher</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>all</source>
      <translation>toutes</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Displacement from (cm)</source>
      <translation>Déplacement à partir de (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>significant only</source>
      <translation>significatifs seulement</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Displacement (cm)</source>
      <translation>Déplacement (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Blocks of both epochs</source>
      <translation>Blocs des deux époques</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>transparent</source>
      <translation>transparent</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Whole scene</source>
      <translation>Scène entière</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Drag turns, shift and drag moves, the wheel or two fingers zoom.</source>
      <translation>Glisser tourne, Maj et glisser déplace, la molette ou deux doigts zooment.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>This browser shows no 3D (WebGL): the picture of the blocks below stands for it.</source>
      <translation>Ce navigateur n'affiche pas de 3D (WebGL) : l'image des blocs ci-dessous la remplace.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>East</source>
      <translation>Est</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>North</source>
      <translation>Nord</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Up</source>
      <translation>Haut</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>{shown} of {all} units</source>
      <translation>{shown} blocs sur {all}</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>enlarged {times} times</source>
      <translation>agrandies {times} fois</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>dashed: cut short</source>
      <translation>en tirets : raccourcies</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Control point</source>
      <translation>Point de contrôle</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_explorer.html" />
      <source>Control point, not used</source>
      <translation>Point de contrôle, non utilisé</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Frames and common motion</source>
      <translation>Repères et mouvement commun</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The clouds of these epochs are bent. What targets say of the bend is removed from positions and from displacements in datum control; what resting units say besides, from displacements in datum stable.</source>
      <translation>Les nuages de ces époques sont courbés. Ce que les cibles en disent est retiré des positions et des déplacements dans la référence control ; ce que disent en outre les blocs immobiles, des déplacements dans la référence stable.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Bend, mean (mm)</source>
      <translation>Courbure, moyenne (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Bend, largest (mm)</source>
      <translation>Courbure, maximale (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Left unknown, mean (mm)</source>
      <translation>Reste inconnu, moyenne (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Correlation length (m)</source>
      <translation>Longueur de corrélation (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Targets used</source>
      <translation>Cibles utilisées</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Error of the clouds along the structure with its 95 % band.</source>
      <translation>Erreur des nuages le long de l'ouvrage avec sa bande à 95 %.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>No bend of the clouds could be told from the noise of units and targets: frames are held stiff.</source>
      <translation>Aucune courbure des nuages ne se distingue du bruit des blocs et des cibles : les repères restent rigides.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Flight strips or stations drift against each other along the structure; this is removed.</source>
      <translation>Les bandes de vol ou les stations dérivent entre elles le long de l'ouvrage ; cette dérive est retirée.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The cloud of {epoch} was aligned by its units alone: a motion of the whole structure cannot be seen.</source>
      <translation>Le nuage de {epoch} a été aligné par ses seuls blocs : un mouvement de tout l'ouvrage ne peut pas être vu.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Common motion of stretches</source>
      <translation>Mouvement commun des tronçons</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Both epochs show too few units to tell a common motion of stretches.</source>
      <translation>Les deux époques montrent trop peu de blocs pour déceler un mouvement commun de tronçons.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Mean displacement of the units of each stretch against the targets; the band holds what is not known of the frames.</source>
      <translation>Déplacement moyen des blocs de chaque tronçon par rapport aux cibles ; la bande contient ce qui reste inconnu des repères.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Not both epochs have survey control: stretches are compared with each other, and a motion of all of them cannot be told.</source>
      <translation>Les deux époques n'ont pas toutes deux des points d'appui : les tronçons sont comparés entre eux, et un mouvement de tous ne peut pas être décelé.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Height change and horizontal motion of stretches with their 95 % bands.</source>
      <translation>Variation de hauteur et mouvement horizontal des tronçons avec leurs bandes à 95 %.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>From (m)</source>
      <translation>De (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>To (m)</source>
      <translation>À (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>No stretch moved as a whole by more than its band.</source>
      <translation>Aucun tronçon ne s'est déplacé d'un bloc de plus que sa bande.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>Of {untold} of {all} stretches a common motion of one hundredth of the unit height cannot be told from the bend of the clouds: targets stand too far away.</source>
      <translation>Pour {untold} tronçons sur {all}, un mouvement commun d'un centième de la hauteur du bloc ne se distingue pas de la courbure des nuages : les cibles sont trop loin.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_frames.html" />
      <source>The result says nothing of its frames.</source>
      <translation>Le résultat ne dit rien de ses repères.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Units by class and control points; coordinates in {crs}.</source>
      <translation>Blocs par classe et points d'appui ; coordonnées en {crs}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Map of a part with the units' names</source>
      <translation>Carte d'une partie avec les noms des blocs</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_map.html" />
      <source>Part {number} of {all} along the structure.</source>
      <translation>Partie {number} sur {all} le long de l'ouvrage.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Method, settings and versions</source>
      <translation>Méthode, réglages et versions</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Units are found in the point cloud as four cones with a common centre, adjusted to their points (Gauss-Helmert model), and brought into the frame of the survey control; displacements are differences of the feature points that follow from the adjusted model, tested against their covariance (after Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds).</source>
      <translation>Les blocs sont trouvés dans le nuage de points comme quatre cônes de même centre, ajustés à leurs points (modèle de Gauss-Helmert) et amenés dans le repère d'appui ; les déplacements sont des différences des points caractéristiques tirés du modèle ajusté, testées contre leur covariance (d'après Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>σ0 of the registration</source>
      <translation>σ0 du rattachement</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Settings</source>
      <translation>Réglages</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_method.html" />
      <source>Written {moment} by {software}.</source>
      <translation>Écrit le {moment} par {software}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Placement</source>
      <translation>Pose des blocs</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units with neighbours on all sides</source>
      <translation>Blocs entourés de voisins</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Nearest centre, median and 5 % (Dn)</source>
      <translation>Centre le plus proche, médiane et 5 % (Dn)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Turn between neighbours, and expected at random</source>
      <translation>Rotation entre voisins, et attendue au hasard</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Difference from turns at random, p</source>
      <translation>Différence avec le hasard, p</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Contacts of a unit, mean</source>
      <translation>Contacts d'un bloc, moyenne</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Free gap to the nearest unit, median (cm)</source>
      <translation>Jeu au bloc le plus proche, médiane (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units in a column, of those with one below</source>
      <translation>Blocs en colonne, parmi ceux qui en ont un dessous</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Off the surface of their neighbours, RMS and largest (m)</source>
      <translation>Écart à la surface des voisins, RMS et maximum (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Layer from outside</source>
      <translation>Couche depuis l'extérieur</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units per 100 m²</source>
      <translation>Blocs par 100 m²</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Packing density, units per Dn²</source>
      <translation>Densité de pose, blocs par Dn²</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Share of the design number</source>
      <translation>Part du nombre de projet</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_placement.html" />
      <source>Units of {epoch}, each in the plane through its neighbours; those at the edge do not count for density. Only units that were found are counted: hidden ones of a lower layer are not. The design number is {packing} units per Dn² and layer (Shore Protection Manual, 1984).</source>
      <translation>Blocs de {epoch}, chacun dans le plan de ses voisins ; ceux du bord ne comptent pas pour la densité. Seuls les blocs trouvés sont comptés, pas ceux cachés d'une couche inférieure. Le nombre de projet est de {packing} blocs par Dn² et couche (Shore Protection Manual, 1984).</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest and cross-sections</source>
      <translation>Crête et coupes</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest height along the structure</source>
      <translation>Hauteur de la crête le long de l'ouvrage</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Mean height of the tops of the crest's units in each reach, with its 95 % band.</source>
      <translation>Hauteur moyenne du sommet des blocs de crête de chaque tronçon, avec sa bande à 95 %.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest height (m)</source>
      <translation>Hauteur de crête (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Highest (m)</source>
      <translation>Plus haut (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Crest width (m)</source>
      <translation>Largeur de crête (m)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Change (mm)</source>
      <translation>Changement (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>The crest of a reach are the units whose top lies less than 0.5 Dn below the highest one; its width is that of their outlines across the axis; the change is that of units that are the crest's in both epochs. Settlement of whole stretches stands under frames and common motion.</source>
      <translation>La crête d'un tronçon sont les blocs dont le sommet est à moins de 0,5 Dn sous le plus haut ; sa largeur est celle de leurs contours en travers de l'axe ; le changement est celui des blocs qui sont de la crête aux deux époques. Le tassement de tronçons entiers figure sous repères et mouvement commun.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_profiles.html" />
      <source>Cross-sections</source>
      <translation>Coupes</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Quality of the units</source>
      <translation>Qualité des blocs</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Uncertain units</source>
      <translation>Blocs incertains</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Points to surface, median (mm)</source>
      <translation>Points à la surface, médiane (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Largest overlap</source>
      <translation>Plus grand recouvrement</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Pairs too close</source>
      <translation>Paires trop proches</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>Overlap is the share of a unit's volume inside another one; two solid units cannot overlap, nor can their centres come closer than half a height. A gap is a place where a unit is likely missing in the result; the layer gaps shows them.</source>
      <translation>Le recouvrement est la part du volume d'un bloc située dans un autre ; deux blocs pleins ne peuvent se recouvrir, ni leurs centres s'approcher à moins d'une demi-hauteur. Une lacune est un endroit où un bloc manque probablement dans le résultat ; la couche gaps les montre.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_quality.html" />
      <source>The result does not state the quality of its units.</source>
      <translation>Le résultat n'indique pas la qualité de ses blocs.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Summary</source>
      <translation>Résumé</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units judged</source>
      <translation>Blocs jugés</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Significant displacements</source>
      <translation>Déplacements significatifs</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Lost</source>
      <translation>Perdus</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Relocated</source>
      <translation>Emportés</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>New</source>
      <translation>Nouveaux</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Not seen in the later epoch</source>
      <translation>Non vus à l'époque postérieure</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Uncertain, not counted</source>
      <translation>Incertains, non comptés</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Displaced by 5 cm or more</source>
      <translation>Déplacés de 5 cm ou plus</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Displaced by 10 cm or more</source>
      <translation>Déplacés de 10 cm ou plus</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Decided by reviewers</source>
      <translation>Décidés par les vérificateurs</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Rejected by reviewers</source>
      <translation>Rejetés par les vérificateurs</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units known to be missing</source>
      <translation>Blocs que l'on sait manquants</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Completeness</source>
      <translation>Complétude</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units rejected by reviewers and left out of all figures, maps and tables below: {count}.</source>
      <translation>Blocs rejetés par les vérificateurs et exclus de tous les chiffres, cartes et tableaux ci-dessous : {count}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_summary.html" />
      <source>Units that no reviewer has decided on yet: {count}.</source>
      <translation>Blocs sans décision jusqu'ici : {count}.</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Units with the largest displacements</source>
      <translation>Blocs aux plus grands déplacements</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>East {e}, north {n}, up {h} cm; rotation {turn}; p {p}</source>
      <translation>Est {e}, nord {n}, haut {h} cm ; rotation {turn} ; p {p}</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Plan and section of {unit}</source>
      <translation>Plan et coupe de {unit}</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>Series of {unit}</source>
      <translation>Série de {unit}</translation>
    </message>
    <message>
      <location filename="../core/report/templates/section_worst.html" />
      <source>No displacement is significant.</source>
      <translation>Aucun déplacement n'est significatif.</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>control used</source>
      <translation>appui utilisé</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>control not used</source>
      <translation>appui non utilisé</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>arrows: significant horizontal displacements, enlarged {scale} times</source>
      <translation>flèches : déplacements horizontaux significatifs, agrandis {scale} fois</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>3D displacement (cm)</source>
      <translation>Déplacement 3D (cm)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>all units</source>
      <translation>tous les blocs</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>units</source>
      <translation>blocs</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>plan</source>
      <translation>plan</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>section {azimuth}°</source>
      <translation>coupe {azimuth}°</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>chainage along the axis (m)</source>
      <translation>abscisse le long de l'axe (m)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>Height change</source>
      <translation>Variation de hauteur</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>Horizontal motion</source>
      <translation>Mouvement horizontal</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>units ≥ 10 cm (%)</source>
      <translation>blocs ≥ 10 cm (%)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>easting (m)</source>
      <translation>est (m)</translation>
    </message>
    <message>
      <location filename="../core/report/figures.py" />
      <source>northing (m)</source>
      <translation>nord (m)</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>least and most around the leg</source>
      <translation>minimum et maximum autour de la branche</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>mean around the leg</source>
      <translation>moyenne autour de la branche</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>end disc</source>
      <translation>disque d'extrémité</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>share of the leg, from the unit's centre</source>
      <translation>part de la branche, depuis le centre</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>outside the cone (mm)</source>
      <translation>hors du cône (mm)</translation>
    </message>
    <message>
      <location filename="../core/report/mould_figures.py" />
      <source>around the leg (degrees)</source>
      <translation>autour de la branche (degrés)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>no damage</source>
      <translation>aucun dommage</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>initiation of damage</source>
      <translation>début de dommage</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>Iribarren's damage</source>
      <translation>dommage d'Iribarren</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>initiation of destruction</source>
      <translation>début de destruction</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>within</source>
      <translation>dans</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>outside</source>
      <translation>hors</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>cannot be told</source>
      <translation>indécis</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>chainage {along} m, axis at {east} / {north}</source>
      <translation>abscisse {along} m, axe à {east} / {north}</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>height (m)</source>
      <translation>hauteur (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>offset from the axis, left positive (m)</source>
      <translation>distance à l'axe, gauche positive (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>crest height (m)</source>
      <translation>hauteur de crête (m)</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>within the tolerance</source>
      <translation>dans la tolérance</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>outside the tolerance</source>
      <translation>hors de la tolérance</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>not judged</source>
      <translation>non jugé</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>planned place without a unit</source>
      <translation>place prévue sans bloc</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>unit without a planned place</source>
      <translation>bloc sans place prévue</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>surface of the points</source>
      <translation>surface des points</translation>
    </message>
    <message>
      <location filename="../core/report/structure_figures.py" />
      <source>design</source>
      <translation>projet</translation>
    </message>
  </context>
</TS>
