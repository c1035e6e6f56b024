# SPDX-License-Identifier: GPL-3.0-or-later
# Draws what studies.sh computed; `folder` holds the CSV files and takes the pictures.
set datafile separator ','
set datafile missing NaN
set style data lines
set terminal pngcairo size 1350,450 font 'sans,11'
set grid lc rgb '#dddddd'
set key left top Left reverse samplen 2 spacing 1.1
set linetype 1 lw 2 lc rgb '#1b4f8a'
set linetype 2 lw 2 lc rgb '#d1495b'
set linetype 3 lw 2 lc rgb '#2e8b57'
set linetype 4 lw 2 lc rgb '#e08e0b'
set linetype 5 lw 2 lc rgb '#6a4c93'
set linetype 6 lw 2 lc rgb '#00798c'
degrees = 180 / pi

# Rows that are not wanted become missing points, which lines pass over.
if_is(a, b, value) = (a eq b) ? value : NaN
if_near(a, b, value) = abs(a - b) < 1e-9 ? value : NaN

bending = folder.'/bending.csv'
set output folder.'/bending.png'
set multiplot layout 1,3
set ylabel 'bending angle of 85 mm, degrees'
set xlabel 'pressure, kPa'
set title 'effective rods (fitted)'
plot [0:300] for [w in '2.5 3 4 5 10'] bending using \
  (if_near($2, real(w), $3)):(if_is(strcol(1), 'rods', $5)) title '2:'.w
set xlabel 'width of the thicker columns, mm; the others 2 mm'
plot [2:10] for [p in '40 60 80'] bending using \
  (if_near($3, real(p), $2)):(if_is(strcol(1), 'rods', $5)) title p.' kPa'
set xlabel 'pressure, kPa'
set title 'distributed columns (nothing fitted)'
plot [0:100] for [w in '2.5 3 3.5 4 5'] bending using \
  (if_near($2, real(w), $3)):(if_is(strcol(1), 'distributed', $5)) title '2:'.w
unset multiplot

twisting = folder.'/twisting.csv'
set output folder.'/twisting.png'
set multiplot layout 1,3
set xlabel 'strip angle, degrees from the circumference'
set key right top
do for [joint in 'paper clear-span'] {
  set ylabel 'twist per deformed length, degrees per mm'
  set title 'joint = "'.joint.'"'
  plot [20:70][0:1.4] for [p in '20 30 40 50 60'] twisting using \
    (if_near($3, real(p), $2)):(if_is(strcol(1), joint, -$5 * degrees)) title p.' kPa'
}
set ylabel 'stretch'
plot [20:70] for [p in '20 30 40 50 60'] twisting using \
  (if_near($3, real(p), $2)):(if_is(strcol(1), 'clear-span', $4)) title p.' kPa'
unset multiplot

set output folder.'/two-families.png'
set multiplot layout 1,2
set xlabel 'angle of the second family, degrees; the first is at 30'
set ylabel 'twist per deformed length, degrees per mm'
set title '40 kPa'
set key off
plot [20:160] folder.'/two-families.csv' using 1:(-$4 * degrees)
set ylabel 'stretch'
plot [20:160] folder.'/two-families.csv' using 1:3
unset multiplot
