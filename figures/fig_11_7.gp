# Figure 11.7 - both bodies next to the contact: left the pressure on each, right their largest shear stress.
# In: fig_11_7.csv, fig_11_7_plate.csv, fig_11_7_arrows.csv   Out: fig_11_7.svg
width = 640; height = 530
load 'style.gp'
load 'bodies.gp'
set size ratio -1
unset key; unset grid
set xlabel '{/:Italic x} [mm]' offset 0,0.4
set ylabel '{/:Italic y} [mm]' offset 1,0
set xrange [-2.3:2.3]
set yrange [-2.3:2.3]
set xtics 1
set ytics 1
set lmargin at screen 0.1
set rmargin at screen 0.83
set tmargin at screen 0.985
set bmargin at screen 0.13
set palette maxcolors 12
set cbrange [0:7.8]
set cblabel 'largest shear stress [MPa]' offset 1,0
set cbtics 1.3
set label 1 'disc' at -2.1,2 left front
set label 2 'plate' at -2.1,-2 left front
set label 3 'pressure,' at -1.05,1.2 center front textcolor rgb RED
set label 4 '24.6 MPa' at -1.05,1.0 center front textcolor rgb RED
shear(file) = "'".file."' using 'x':'y':'value' with polygons fs solid noborder fc palette, '' using 'x':'y' with lines lc rgb '#60ffffff' lw 0.3 dt 1"
disc = data.'/fig_11_7.csv'
plate = data.'/fig_11_7_plate.csv'
arrows = data.'/fig_11_7_arrows.csv'
eval 'plot '.body(disc, -1).', '.body(plate, -1).', '.shear(disc).', '.shear(plate).', '.pressing(arrows, 0.035, -1).', '.pressing(arrows, -0.035, -1)
