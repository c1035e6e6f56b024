# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot -e "data='FOLDER'; pictures='DIR'" stability.gp: the four maps of stability_map.csv.
set terminal svg size 800,640 font "sans,13" background "white"
set output pictures."/stability.svg"
set datafile separator ","

# Colours by what was answered, as in stability_study.cpp.
set palette maxcolors 6 defined (0 "#4c9f70", 1 "#f2c14e", 2 "#5b8db8", 3 "#9b7fb8", 4 "#c9c9c9", 5 "#d62828")
set cbrange [-0.5:5.5]
unset colorbox
unset key
set style fill solid noborder
set tics out nomirror font ",11"

file = data."/stability_map.csv"
stats file using (strcol(1) eq "stiffness" ? column(4) : 1/0) nooutput
n = STATS_max
# Place of a value on an axis that runs evenly in the logarithm.
place(v, low, high) = n * log(v / low) / log(high / low)
angle_place(v) = n / 2.0 * (1 + (v == 90 ? 0 : (v > 90 ? 1 : -1) * -log10(1 - abs(v - 90) / 90.0 * 89.991 / 89.99 + 1e-12) / 4))

set multiplot layout 2,2 margins 0.11,0.97,0.2,0.96 spacing 0.13,0.14
set xrange [-0.5:n + 0.5]
set yrange [-0.5:n + 0.5]

set ytics ("0.01" place(0.01, 0.01, 100), "0.1" place(0.1, 0.01, 100), "1" place(1, 0.01, 100), "10" place(10, 0.01, 100), "100" place(100, 0.01, 100))
set ylabel "pressure over reference" offset 1
set xlabel "E of the lattice over {/Symbol m} of the liner" offset 0,0.4
set xtics ("10^{-3}" 0, "1" place(1, 1e-3, 1e9), "10^3" place(1e3, 1e-3, 1e9), "10^6" place(1e6, 1e-3, 1e9), "10^9" n)
plot file using (strcol(1) eq "stiffness" ? column(4) : 1/0):5:(0.5):(0.5):6 with boxxyerror fillcolor palette

set xlabel "inner over outer radius of the wall"
set xtics ("0.05" 0, "0.5 " n - place(0.5, 1e-3, 0.95), "0.9" n - place(0.1, 1e-3, 0.95), "0.99" n - place(0.01, 1e-3, 0.95), "0.999" n)
set ylabel "strand angle {/Symbol a}, degrees"
set ytics ("0.01" 0, "1" angle_place(1), "90" angle_place(90), "179" angle_place(179), "179.99" n)
plot file using (strcol(1) eq "wall" ? column(4) : 1/0):5:(0.5):(0.5):6 with boxxyerror fillcolor palette

set ylabel "pressure over reference"
set ytics ("0.01" place(0.01, 0.01, 100), "0.1" place(0.1, 0.01, 100), "1" place(1, 0.01, 100), "10" place(10, 0.01, 100), "100" place(100, 0.01, 100))
set xlabel "horseshoe width over radius, w/R_h"
set xtics ("10^{-3}" 0, "0.01" place(0.01, 1e-3, 100), "0.1" place(0.1, 1e-3, 100), "1" place(1, 1e-3, 100), "10" place(10, 1e-3, 100), "100" n)
plot file using (strcol(1) eq "horseshoe" ? column(4) : 1/0):5:(0.5):(0.5):6 with boxxyerror fillcolor palette

set xlabel "width ratio of the tube's halves"
set xtics ("1" 0, "10" place(10, 1, 1000), "100" place(100, 1, 1000), "1000" n)
plot file using (strcol(1) eq "widths" ? column(4) : 1/0):5:(0.5):(0.5):6 with boxxyerror fillcolor palette

# The legend, in a strip of its own below the panels.
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 0
set tmargin at screen 0.08
unset xlabel
unset ylabel
unset tics
unset border
set xrange [0:6]
set yrange [0:1]
array words[6] = ["stable", "unstable", "branch ended", "law ended", "unsupported", "wrong"]
set for [i=1:6] label i words[i] at i - 0.76, 0.5 left font ",12"
plot for [i=1:6] '+' using (i - 0.87):(0.5):(0.07):(0.18):(i - 1.0) every ::0::0 with boxxyerror fillcolor palette
unset multiplot
