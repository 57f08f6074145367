#!/usr/bin/env bash
# Set everything up and run the sample survey: two epochs of a simulated breakwater, from tiles to displacements.
# Usage: scripts/demo.sh [FOLDER]   the result goes to FOLDER/result.gpkg (default: demo/)
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

folder="${1:-demo}"
setup_system
setup_engine
step "sample survey" "run: .venv/bin/tetratrack demo $folder"
began=$SECONDS
.venv/bin/tetratrack demo "$folder"
cat <<END

Done in $((SECONDS - began)) s (with the set-up $SECONDS s): $folder/result.gpkg
  look at    $folder/report.html in a browser
  in QGIS    Layer > Add Layer > Add Vector Layer, choose $folder/result.gpkg: styles come with it
  in Python  geopandas.read_file("$folder/result.gpkg", layer="displacements")
  your own   .venv/bin/tetratrack run FOLDER_OF_TILES --output result.gpkg
END
