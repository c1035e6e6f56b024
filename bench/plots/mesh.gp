# SPDX-License-Identifier: GPL-3.0-or-later
# Error of wrapped meshes against the time to make them, and what `build` states of it.
# gnuplot -e "data='FOLDER'; pictures='FOLDER'" bench/plots/mesh.gp
set datafile separator ","
set terminal svg size 800,520 font "sans,13" background "white"
set logscale xy
set grid
set format y "10^{%T}"
set key bottom left
of(name, column) = strcol(1) eq name ? column : NaN
file = data."/mesh_error.csv"

set output pictures."/mesh_error.svg"
set xlabel "time to make the mesh (ms)"
set ylabel "largest distance from the true surface (mm)"
plot for [name in '"lattice" "lattice with fillets" "horseshoes" "horseshoes with fillets" "liner"'] \
       file using 8:(of(name, $4)) skip 1 with linespoints pt 7 ps 0.7 lw 1.5 title name

set output pictures."/mesh_estimate.svg"
set xlabel "largest distance found (mm)"
set ylabel "stated distance (mm)"
set key top left
plot x with lines lc "gray" title "equal", \
     for [name in '"lattice" "lattice with fillets" "horseshoes" "horseshoes with fillets" "liner"'] \
       file using 4:(of(name, $5)) skip 1 with linespoints pt 7 ps 0.7 lw 1.5 title name
