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
      <source>GeoPackage written by Monitor a survey.</source>
      <translation>GeoPackage écrit par Suivre un levé.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>HTML in one file, or PDF; the ending decides.</source>
      <translation>HTML en un fichier, ou PDF ; l'extension décide.</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Result</source>
      <translation>Résultat</translation>
    </message>
    <message>
      <location filename="../algorithms/displacementreport.py" />
      <source>Report</source>
      <translation>Rapport</translation>
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
      <source>Fitted units</source>
      <translation>Blocs ajustés</translation>
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
      <translation>Avec une seule jambe visible, la rotation autour de son axe est indéterminée : le grand écart-type du bloc le montre.</translation>
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
      <location filename="../algorithms/inputs.py" />
      <source>LAS, LAZ or COPC files, a folder of them, a virtual point cloud (.vpc) or point cloud layers; coordinates in metres.</source>
      <translation>Fichiers LAS, LAZ ou COPC, un dossier, un nuage de points virtuel (.vpc) ou des couches de nuages de points ; coordonnées en mètres.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Projected CRS in metres; empty takes that of the tiles, and a local frame if they declare none.</source>
      <translation>SCR projeté en mètres ; vide prend celui des dalles, et un repère local si elles n'en déclarent pas.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Label of this survey in all results, for example its date.</source>
      <translation>Nom de ce levé dans tous les résultats, par exemple sa date.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Drives the temporal controller; empty takes the date of the first tile.</source>
      <translation>Pilote le contrôleur temporel ; vide prend la date de la première dalle.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Estimates both from the best-seen units and holds them: moulds differ by centimetres from the standard proportions.</source>
      <translation>Estime les deux à partir des blocs les mieux vus et les fixe : les moules diffèrent de plusieurs centimètres des proportions standard.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Type of unit</source>
      <translation>Type de bloc</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Catalogue name with the mass in tonnes, such as tetrapod 8 t; or tetrapod with a height of your own.</source>
      <translation>Nom de catalogue avec la masse en tonnes, par exemple tetrapod 8 t ; ou tetrapod avec votre propre hauteur.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>From the plane under three legs to the top of the fourth, in metres; overrides the catalogue.</source>
      <translation>Du plan sous trois jambes au sommet de la quatrième, en mètres ; prime sur le catalogue.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Radius of a leg's cone at the unit's centre, in metres; empty takes 0.264 H.</source>
      <translation>Rayon du cône d'une jambe au centre du bloc, en mètres ; vide prend 0,264 H.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Loss of radius per metre along the leg's axis; empty takes 0.176.</source>
      <translation>Perte de rayon par mètre le long de l'axe de la jambe ; vide prend 0,176.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>From the centre to the end disc, in metres; empty takes 0.644 H.</source>
      <translation>Du centre au disque d'extrémité, en mètres ; vide prend 0,644 H.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Built tetrapods are tetrahedral; 120° between leg 1 and the others repeats the published equations.</source>
      <translation>Les tétrapodes réels sont tétraédriques ; 120° entre la jambe 1 et les autres reproduit les équations publiées.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Polygon inside which units are looked for; its outer ring is used. Empty means everywhere.</source>
      <translation>Polygone dans lequel les blocs sont cherchés ; son anneau extérieur est utilisé. Vide : partout.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Polygons around surfaces that do not move, such as the crown wall: they tie epochs without control to the earliest with control, or to the first.</source>
      <translation>Polygones autour de surfaces qui ne bougent pas, comme le mur de couronnement : ils rattachent les époques sans points d'appui à la première qui en a, ou à la première de toutes.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Blocks of the survey worked on at the same time; each takes about 1 GB of memory.</source>
      <translation>Secteurs du levé traités en même temps ; chacun prend environ 1 Go de mémoire.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Surveyed targets: point layer or CSV with point_id, easting, northing, height, sd_e, sd_n, sd_h (m).</source>
      <translation>Cibles levées : couche de points ou CSV avec point_id, easting, northing, height, sd_e, sd_n, sd_h (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The same targets as measured in this epoch's cloud: point layer or CSV with point_id, x, y, z (m).</source>
      <translation>Les mêmes cibles mesurées dans le nuage de cette époque : couche de points ou CSV avec point_id, x, y, z (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Surveyed joints of cones, for validation only: CSV or layer with point_id, unit_easting, unit_northing, unit_height and position (m).</source>
      <translation>Jonctions de cônes levées, pour validation seulement : CSV ou couche avec point_id, unit_easting, unit_northing, unit_height et position (m).</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Give the height H of the unit, or choose a catalogue name with its mass, such as tetrapod 8 t.</source>
      <translation>Donnez la hauteur H du bloc, ou choisissez un nom de catalogue avec sa masse, par exemple tetrapod 8 t.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The type of unit must be tetrapod, or a catalogue name such as tetrapod 8 t.</source>
      <translation>Le type de bloc doit être tetrapod, ou un nom de catalogue tel que tetrapod 8 t.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Control points and targets in the cloud belong together: give both, or neither.</source>
      <translation>Points d'appui et cibles dans le nuage vont ensemble : donnez les deux, ou aucun.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>CRS of the results</source>
      <translation>SCR des résultats</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Epoch</source>
      <translation>Époque</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Time of the survey (UTC)</source>
      <translation>Heure du levé (UTC)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Calibrate radius and taper</source>
      <translation>Étalonner rayon et conicité</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Height H of the unit (m)</source>
      <translation>Hauteur H du bloc (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Cone radius at the centre (m)</source>
      <translation>Rayon du cône au centre (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Taper of the leg</source>
      <translation>Conicité de la jambe</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Leg length (m)</source>
      <translation>Longueur de jambe (m)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Angle between the legs</source>
      <translation>Angle entre les jambes</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Area of interest</source>
      <translation>Zone d'intérêt</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Stable areas</source>
      <translation>Zones stables</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Worker processes</source>
      <translation>Processus de calcul</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Control points</source>
      <translation>Points d'appui</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Targets in the cloud</source>
      <translation>Cibles dans le nuage</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Check points</source>
      <translation>Points de contrôle</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The cone radius must be smaller than half the height of the unit.</source>
      <translation>Le rayon du cône doit être inférieur à la moitié de la hauteur du bloc.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The area of interest holds no polygon.</source>
      <translation>La zone d'intérêt ne contient aucun polygone.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>The area of interest has several separate parts; give one polygon.</source>
      <translation>La zone d'intérêt a plusieurs parties séparées ; donnez un seul polygone.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>Point cloud tiles</source>
      <translation>Dalles de nuage de points</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>tetrahedral (109.5°)</source>
      <translation>tétraédrique (109,5°)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>as in the paper (120°)</source>
      <translation>comme dans l'article (120°)</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{crs} is geographic; choose a projected CRS in metres.</source>
      <translation>{crs} est géographique ; choisissez un SCR projeté en mètres.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: no LAS or LAZ file is given.</source>
      <translation>{where} : aucun fichier LAS ou LAZ n'est donné.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: there is no file or layer {path}.</source>
      <translation>{where} : il n'y a pas de fichier ou de couche {path}.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{layer} cannot be written: {reason}.</source>
      <translation>{layer} ne peut pas être écrit : {reason}.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{layer} has no field {fields}; it has {present}.</source>
      <translation>{layer} n'a pas de champ {fields} ; elle a {present}.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: the folder {path} holds no LAS or LAZ file.</source>
      <translation>{where} : le dossier {path} ne contient aucun fichier LAS ou LAZ.</translation>
    </message>
    <message>
      <location filename="../algorithms/inputs.py" />
      <source>{where}: {path} is not a virtual point cloud.</source>
      <translation>{where} : {path} n'est pas un nuage de points virtuel.</translation>
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
      <source>Epochs</source>
      <translation>Époques</translation>
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
      <source>Epoch {label}</source>
      <translation>Époque {label}</translation>
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
      <source>White noise is averaged over the points of a unit; whatever does not average out must be stated as systematic part.</source>
      <translation>Le bruit blanc se moyenne sur les points d'un bloc ; ce qui ne se moyenne pas doit être donné comme part systématique.</translation>
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
      <source>The level of significance must be below the power.</source>
      <translation>Le niveau de signification doit être inférieur à la puissance.</translation>
    </message>
    <message>
      <location filename="../algorithms/planningdetectability.py" />
      <source>Radius and taper are known</source>
      <translation>Rayon et conicité connus</translation>
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
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Segment tetrapods</source>
      <translation>Segmenter les tétrapodes</translation>
    </message>
    <message>
      <location filename="../algorithms/segmenttetrapods.py" />
      <source>Finds every tetrapod in a pile: cones from pairs of oriented points, legs that agree on a common centre and on the angles between them, and verification against the visible surface and against empty space.</source>
      <translation>Trouve chaque tétrapode d'un talus : cônes à partir de paires de points orientés, jambes d'accord sur un centre commun et sur leurs angles, et vérification contre la surface visible et l'espace vide.</translation>
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
      <location filename="../algorithms/survey_algorithm.py" />
      <source>The tiles declare no CRS: results are in a local frame. Choose the CRS of the results to change that.</source>
      <translation>Les dalles ne déclarent aucun SCR : les résultats sont dans un repère local. Choisissez le SCR des résultats pour changer cela.</translation>
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
      <location filename="../algorithms/validatesurvey.py" />
      <source>Feature points</source>
      <translation>Points caractéristiques</translation>
    </message>
    <message>
      <location filename="../plugin/engine.py" />
      <source>The tetratrack engine is not installed: open Settings &gt; Options &gt; Tetratrack and create its environment or choose one.</source>
      <translation>Le moteur tetratrack n'est pas installé : ouvrez Préférences &gt; Options &gt; Tetratrack et créez son environnement ou choisissez-en un.</translation>
    </message>
    <message>
      <location filename="../plugin/engine.py" />
      <source>The engine ended unexpectedly (exit code {code}); QGIS and your data are unharmed.</source>
      <translation>Le moteur s'est arrêté de façon inattendue (code {code}) ; QGIS et vos données sont intacts.</translation>
    </message>
    <message>
      <location filename="../plugin/engine.py" />
      <source>The engine could not be started with {python}: {reason}.</source>
      <translation>Le moteur n'a pas pu démarrer avec {python} : {reason}.</translation>
    </message>
    <message>
      <location filename="../plugin/engine_task.py" />
      <source>Cancelled.</source>
      <translation>Annulé.</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>found</source>
      <translation>trouvé</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>uncertain</source>
      <translation>incertain</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>new</source>
      <translation>nouveau</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>relocated</source>
      <translation>emporté</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>lost: the place is empty</source>
      <translation>perdu : la place est vide</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>unseen: known from another epoch</source>
      <translation>non vu : connu d'une autre époque</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>unexplained points where a unit fits</source>
      <translation>points inexpliqués là où un bloc tient</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>hole where a unit fits</source>
      <translation>trou où un bloc tient</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>arrow of 10 mm: 50 mm; ellipse: 95 %</source>
      <translation>flèche de 10 mm : 50 mm ; ellipse : 95 %</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>below the detection limit</source>
      <translation>sous la limite de détection</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>significant, up to 50 mm</source>
      <translation>significatif, jusqu'à 50 mm</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>50 to 100 mm: watch</source>
      <translation>50 à 100 mm : vigilance</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>more than 100 mm: alert</source>
      <translation>plus de 100 mm : alerte</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>relocated unit</source>
      <translation>bloc emporté</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>uncertain unit</source>
      <translation>bloc incertain</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>observed</source>
      <translation>observé</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>derived from the rest of the unit</source>
      <translation>déduit du reste du bloc</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>used</source>
      <translation>utilisé</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>disturbed, not used</source>
      <translation>perturbé, non utilisé</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>not used</source>
      <translation>non utilisé</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>check point</source>
      <translation>point de contrôle</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Gaps</source>
      <translation>Lacunes</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Displacements</source>
      <translation>Déplacements</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Displacements, other pairs and datum</source>
      <translation>Déplacements, autres paires et autre référence</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Control residuals</source>
      <translation>Résidus aux points d'appui</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Check residuals</source>
      <translation>Écarts aux points de contrôle</translation>
    </message>
    <message>
      <location filename="../plugin/layers.py" />
      <source>Reviews</source>
      <translation>Vérifications</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create a Python environment in {folder} and download about {size} of libraries into it?</source>
      <translation>Créer un environnement Python dans {folder} et y télécharger environ {size} de bibliothèques ?</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Creating the tetratrack engine</source>
      <translation>Création du moteur tetratrack</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Python interpreter of the engine</source>
      <translation>Interpréteur Python du moteur</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Empty uses the environment that the plugin creates.</source>
      <translation>Vide utilise l'environnement que l'extension crée.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Create the engine's environment…</source>
      <translation>Créer l'environnement du moteur…</translation>
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
      <source>Python 3.11 or later was not found: install it, or choose an interpreter of the engine above.</source>
      <translation>Python 3.11 ou plus récent est introuvable : installez-le, ou choisissez ci-dessus un interpréteur du moteur.</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>The engine's environment could not be created: {reason}</source>
      <translation>L'environnement du moteur n'a pas pu être créé : {reason}</translation>
    </message>
    <message>
      <location filename="../plugin/options.py" />
      <source>Used: {python}</source>
      <translation>Utilisé : {python}</translation>
    </message>
    <message>
      <location filename="../plugin/provider.py" />
      <source>Tetratrack: displacements of tetrapods</source>
      <translation>Tetratrack : déplacements de tétrapodes</translation>
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
      <translation>Fixer par trois jonctions de jambes (époque antérieure)</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Pin by three joints of legs (later epoch)</source>
      <translation>Fixer par trois jonctions de jambes (époque postérieure)</translation>
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
      <source>Take back the last correction</source>
      <translation>Annuler la dernière correction</translation>
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
      <source>pinned by three joints</source>
      <translation>fixé par trois jonctions</translation>
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
      <source>There is no correction to take back.</source>
      <translation>Il n'y a pas de correction à annuler.</translation>
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
      <translation>Cliquez trois jonctions où trois jambes se rencontrent, sur la carte ou dans les vues ; Échap termine.</translation>
    </message>
    <message>
      <location filename="../plugin/review_corrections.py" />
      <source>Click a joint where three legs meet; Escape ends.</source>
      <translation>Cliquez une jonction où trois jambes se rencontrent ; Échap termine.</translation>
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
    <message>
      <location filename="../plugin/review_details.py" />
      <source>3D displacement</source>
      <translation>Déplacement 3D</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>in heights H, in Dn</source>
      <translation>en hauteurs H, en Dn</translation>
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
      <translation>significatif</translation>
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
      <source>Seen</source>
      <translation>Vu</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Score</source>
      <translation>Score</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Legs seen</source>
      <translation>Jambes vues</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{shown} of {all} units shown</source>
      <translation>{shown} blocs sur {all} montrés</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} significant</source>
      <translation>{count} significatifs</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} decided</source>
      <translation>{count} décidés</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} rejected, excluded from statistics and map</source>
      <translation>{count} rejetés, exclus des statistiques et de la carte</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Displacement</source>
      <translation>Déplacement</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>none: one of the two positions is not known</source>
      <translation>aucun : une des deux positions est inconnue</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Rotation</source>
      <translation>Rotation</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Test against no motion</source>
      <translation>Test contre l'immobilité</translation>
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
      <source>{count} lost</source>
      <translation>{count} perdus</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{count} new</source>
      <translation>{count} nouveaux</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>largest {length}</source>
      <translation>maximum {length}</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>taken back</source>
      <translation>repris</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>Picked by hand</source>
      <translation>Pointé à la main</translation>
    </message>
    <message>
      <location filename="../plugin/review_details.py" />
      <source>{feature}, {epoch}: picked {length} from the fit ({who})</source>
      <translation>{feature}, {epoch} : pointé à {length} de l'ajustement ({who})</translation>
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
      <source>Export the alarm list…</source>
      <translation>Exporter la liste d'alerte…</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>PDF (*.pdf);;Web page (*.html)</source>
      <translation>PDF (*.pdf);;Page web (*.html)</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Alarm list</source>
      <translation>Liste d'alerte</translation>
    </message>
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>Threshold (cm)</source>
      <translation>Seuil (cm)</translation>
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
      <source>Make a polygon layer active first.</source>
      <translation>Activez d'abord une couche de polygones.</translation>
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
    <message>
      <location filename="../plugin/review_dock.py" />
      <source>{count} units written to {name}.</source>
      <translation>{count} blocs écrits dans {name}.</translation>
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
      <source>Displacement review: {name}</source>
      <translation>Vérification des déplacements : {name}</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Open the result.gpkg of a survey with two epochs or more to review its displacements.</source>
      <translation>Ouvrez le result.gpkg d'un levé de deux époques ou plus pour vérifier ses déplacements.</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Open result…</source>
      <translation>Ouvrir un résultat…</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Epochs compared</source>
      <translation>Époques comparées</translation>
    </message>
    <message>
      <location filename="../plugin/review_panels.py" />
      <source>Reference of the displacements</source>
      <translation>Référence des déplacements</translation>
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
      <source>Reviewer</source>
      <translation>Vérificateur</translation>
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
      <source>No displacement of this unit</source>
      <translation>Aucun déplacement de ce bloc</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>centre</source>
      <translation>centre</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>Section {azimuth}°</source>
      <translation>Coupe {azimuth}°</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>3D displacement ({unit})</source>
      <translation>Déplacement 3D ({unit})</translation>
    </message>
    <message>
      <location filename="../plugin/review_plots.py" />
      <source>detection limit</source>
      <translation>limite de détection</translation>
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
      <source>stable</source>
      <translation>stable</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>moved</source>
      <translation>déplacé</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>rotated</source>
      <translation>tourné</translation>
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
      <source>placeholder</source>
      <translation>emplacement réservé</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Unit</source>
      <translation>Bloc</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>Class</source>
      <translation>Classe</translation>
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
      <source>Decision</source>
      <translation>Décision</translation>
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
      <source>stable units and control</source>
      <translation>blocs stables et appui</translation>
    </message>
    <message>
      <location filename="../plugin/review_text.py" />
      <source>control points alone</source>
      <translation>points d'appui seuls</translation>
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
      <location filename="../plugin/tetratrack_plugin.py" />
      <source>Monitor a survey…</source>
      <translation>Suivre un levé…</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Comparison with surveyed check points</source>
      <translation>Comparaison avec les points de contrôle levés</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Picked by hand (cm)</source>
      <translation>Pointé à la main (cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Fitting (cm)</source>
      <translation>Ajustement (cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Surveyed (cm)</source>
      <translation>Levé (cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Error, picked (cm)</source>
      <translation>Erreur, pointé (cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>Error, fitting (cm)</source>
      <translation>Erreur, ajustement (cm)</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>3D displacements of the same feature point, in the control frame (after Chan and Lichti, Table 1).</source>
      <translation>Déplacements 3D du même point caractéristique, dans le repère d'appui (d'après Chan and Lichti, tableau 1).</translation>
    </message>
    <message>
      <location filename="../core/section_check.html" />
      <source>The survey has no check points that both epochs share.</source>
      <translation>Le levé n'a pas de points de contrôle communs aux deux époques.</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Survey control</source>
      <translation>Appui topographique</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Congruence of the stable units</source>
      <translation>Congruence des blocs stables</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Units that stand still together: {stable} of {all}; test of their congruence: p {p}.</source>
      <translation>Blocs immobiles ensemble : {stable} sur {all} ; test de leur congruence : p {p}.</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Their common motion against the control points: east {e}, north {n}, up {h} cm; p {p}.</source>
      <translation>Leur mouvement commun par rapport aux points d'appui : est {e}, nord {n}, haut {h} cm ; p {p}.</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Point</source>
      <translation>Point</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>East (mm)</source>
      <translation>Est (mm)</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>North (mm)</source>
      <translation>Nord (mm)</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Height (mm)</source>
      <translation>Altitude (mm)</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Use</source>
      <translation>Emploi</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>disturbed, left out</source>
      <translation>perturbé, écarté</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>Residuals of the registration; w is the largest normalised residual of the three coordinates.</source>
      <translation>Résidus du rattachement ; w est le plus grand résidu normalisé des trois coordonnées.</translation>
    </message>
    <message>
      <location filename="../core/section_control.html" />
      <source>There is no survey control: displacements are relative to the frame of the clouds.</source>
      <translation>Il n'y a pas d'appui : les déplacements se rapportent au repère des nuages.</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Damage</source>
      <translation>Dommages</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>H = {height} m, Dn = {diameter} m. Lost and relocated units count as displaced by every threshold.</source>
      <translation>H = {height} m, Dn = {diameter} m. Les blocs perdus et emportés comptent comme déplacés à tous les seuils.</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Displaced by at least</source>
      <translation>Déplacé d'au moins</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Threshold (m)</source>
      <translation>Seuil (m)</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Share</source>
      <translation>Part</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>over {width} m: units displaced by one Dn or more, relocated or lost, per Dn of width (van der Meer, 1988).</source>
      <translation>sur {width} m : blocs déplacés d'un Dn ou plus, emportés ou perdus, par Dn de largeur (van der Meer, 1988).</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Sections along the axis</source>
      <translation>Sections le long de l'axe</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Share of displaced units per section</source>
      <translation>Part de blocs déplacés par section</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>Chainage (m)</source>
      <translation>Abscisse (m)</translation>
    </message>
    <message>
      <location filename="../core/section_damage.html" />
      <source>No unit has a displacement to show.</source>
      <translation>Aucun bloc n'a de déplacement à montrer.</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Decisions and corrections</source>
      <translation>Décisions et corrections</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Confirmed by</source>
      <translation>Confirmé par</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Comment</source>
      <translation>Commentaire</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>inspect on site</source>
      <translation>inspecter sur place</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>No reviewer has decided on this epoch pair.</source>
      <translation>Aucun vérificateur n'a décidé de cette paire d'époques.</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>Correction</source>
      <translation>Correction</translation>
    </message>
    <message>
      <location filename="../core/section_decisions.html" />
      <source>By</source>
      <translation>Par</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Map of displacements</source>
      <translation>Carte des déplacements</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Displacement of the units' centres.</source>
      <translation>Déplacement des centres des blocs.</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Histogram of displacements</source>
      <translation>Histogramme des déplacements</translation>
    </message>
    <message>
      <location filename="../core/section_displacements.html" />
      <source>Displacements of all units with the thresholds of the next section.</source>
      <translation>Déplacements de tous les blocs avec les seuils de la section suivante.</translation>
    </message>
    <message>
      <location filename="../core/section_map.html" />
      <source>Map of the units by class</source>
      <translation>Carte des blocs par classe</translation>
    </message>
    <message>
      <location filename="../core/section_map.html" />
      <source>Units by class and control points; coordinates in {crs}.</source>
      <translation>Blocs par classe et points d'appui ; coordonnées en {crs}.</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Method, settings and versions</source>
      <translation>Méthode, réglages et versions</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Units are found in the point cloud as four cones with a common centre, adjusted to their points (Gauss-Helmert model), and brought into the frame of the survey control; displacements are differences of the feature points that follow from the adjusted model, tested against their covariance (after Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds).</source>
      <translation>Les blocs sont trouvés dans le nuage de points comme quatre cônes de même centre, ajustés à leurs points (modèle de Gauss-Helmert) et amenés dans le repère d'appui ; les déplacements sont des différences des points caractéristiques tirés du modèle ajusté, testées contre leur covariance (d'après Chan and Lichti, Toward Seawall Monitoring via Tracking Model-Derived Feature Points of Tetrapods from 3D Point Clouds).</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Time</source>
      <translation>Heure</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>σ0 of the registration</source>
      <translation>σ0 du rattachement</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Software</source>
      <translation>Logiciel</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Settings</source>
      <translation>Réglages</translation>
    </message>
    <message>
      <location filename="../core/section_method.html" />
      <source>Written {moment} by {software}.</source>
      <translation>Écrit le {moment} par {software}.</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Quality of the units</source>
      <translation>Qualité des blocs</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Uncertain units</source>
      <translation>Blocs incertains</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Points to surface, median (mm)</source>
      <translation>Points à la surface, médiane (mm)</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Largest overlap</source>
      <translation>Plus grand recouvrement</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Pairs too close</source>
      <translation>Paires trop proches</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>Overlap is the share of a unit's volume inside another one; two solid units cannot overlap, nor can their centres come closer than half a height. A gap is a place where a unit is likely missing in the result; the layer gaps shows them.</source>
      <translation>Le recouvrement est la part du volume d'un bloc située dans un autre ; deux blocs pleins ne peuvent se recouvrir, ni leurs centres s'approcher à moins d'une demi-hauteur. Une lacune est un endroit où un bloc manque probablement dans le résultat ; la couche gaps les montre.</translation>
    </message>
    <message>
      <location filename="../core/section_quality.html" />
      <source>The result was made by a version that did not state the quality of its units.</source>
      <translation>Le résultat vient d'une version qui n'indiquait pas la qualité de ses blocs.</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Summary</source>
      <translation>Résumé</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units judged</source>
      <translation>Blocs jugés</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Significant displacements</source>
      <translation>Déplacements significatifs</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Lost</source>
      <translation>Perdus</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Relocated</source>
      <translation>Emportés</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>New</source>
      <translation>Nouveaux</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Not seen in the later epoch</source>
      <translation>Non vus à l'époque postérieure</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Displaced by 5 cm or more</source>
      <translation>Déplacés de 5 cm ou plus</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Displaced by 10 cm or more</source>
      <translation>Déplacés de 10 cm ou plus</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Decided by reviewers</source>
      <translation>Décidés par les vérificateurs</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Rejected by reviewers</source>
      <translation>Rejetés par les vérificateurs</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units known to be missing</source>
      <translation>Blocs que l'on sait manquants</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Completeness</source>
      <translation>Complétude</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units rejected by reviewers and left out of all figures, maps and tables below: {count}.</source>
      <translation>Blocs rejetés par les vérificateurs et exclus de tous les chiffres, cartes et tableaux ci-dessous : {count}.</translation>
    </message>
    <message>
      <location filename="../core/section_summary.html" />
      <source>Units that no reviewer has decided on yet: {count}.</source>
      <translation>Blocs sans décision jusqu'ici : {count}.</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>Units with the largest displacements</source>
      <translation>Blocs aux plus grands déplacements</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>East {e}, north {n}, up {h} cm; rotation {turn}; p {p}</source>
      <translation>Est {e}, nord {n}, haut {h} cm ; rotation {turn} ; p {p}</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>Plan and section of {unit}</source>
      <translation>Plan et coupe de {unit}</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>Series of {unit}</source>
      <translation>Série de {unit}</translation>
    </message>
    <message>
      <location filename="../core/section_worst.html" />
      <source>No displacement is significant.</source>
      <translation>Aucun déplacement n'est significatif.</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>control used</source>
      <translation>appui utilisé</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>control not used</source>
      <translation>appui non utilisé</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>arrows: significant horizontal displacements, enlarged {scale} times</source>
      <translation>flèches : déplacements horizontaux significatifs, agrandis {scale} fois</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>3D displacement (cm)</source>
      <translation>Déplacement 3D (cm)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>all units</source>
      <translation>tous les blocs</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>units</source>
      <translation>blocs</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>plan</source>
      <translation>plan</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>section {azimuth}°</source>
      <translation>coupe {azimuth}°</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>chainage along the axis (m)</source>
      <translation>abscisse le long de l'axe (m)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>units ≥ 10 cm (%)</source>
      <translation>blocs ≥ 10 cm (%)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>easting (m)</source>
      <translation>est (m)</translation>
    </message>
    <message>
      <location filename="../core/report_figures.py" />
      <source>northing (m)</source>
      <translation>nord (m)</translation>
    </message>
  </context>
</TS>
