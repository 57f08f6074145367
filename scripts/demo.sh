#!/usr/bin/env bash
# Set everything up and run the sample survey: two epochs of a simulated breakwater, from tiles to displacements.
# Usage: scripts/demo.sh [FOLDER]   the result goes to FOLDER/result.gpkg (default: demo/)
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

folder="${1:-demo}"
setup_system
setup_engine
step "sample survey" "run: .venv/bin/tetratrack run tests/data/sample/survey.toml --output $folder/result.gpkg"
mkdir -p "$folder"
.venv/bin/tetratrack run tests/data/sample/survey.toml --output "$folder/result.gpkg"
cat <<END

Done: $folder/result.gpkg
  in QGIS    Layer > Add Layer > Add Vector Layer, choose $folder/result.gpkg: styles come with it
  in Python  geopandas.read_file("$folder/result.gpkg", layer="displacements")
  your own   .venv/bin/tetratrack template > survey.toml, fill it in,
             .venv/bin/tetratrack run survey.toml --output result.gpkg
END
