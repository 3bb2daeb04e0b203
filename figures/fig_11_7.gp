# Figure 11.7 - both bodies next to the contact.   In: fig_11_7.csv, fig_11_7_plate.csv   Out: fig_11_7.svg
width = 470; height = 500
load 'style.gp'
set size ratio -1
unset key; unset grid
set xlabel '{/:Italic x} [mm]'
set ylabel '{/:Italic y} [mm]'
set xrange [0:2.5]
set yrange [-2.5:2.5]
set xtics 0.5
set ytics 0.5
set rmargin 11
set palette maxcolors 12
set cbrange [0:7.8]
set cblabel 'largest shear stress [MPa]' offset 1,0
set cbtics 1.3
plot data.'/fig_11_7.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     '' using 'x':'y' with lines lc rgb '#60ffffff' lw 0.3 dt 1, \
     data.'/fig_11_7_plate.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     '' using 'x':'y' with lines lc rgb '#60ffffff' lw 0.3 dt 1
