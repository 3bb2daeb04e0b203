# Figure 12.4 - pressure of the two contacts.   In: fig_12_4.csv, fig_12_4_nodes.csv   Out: fig_12_4.svg
load 'style.gp'
set xlabel 'distance from the axis {/:Italic x} [mm]'
set ylabel 'contact pressure [MPa]'
set xrange [0:1.25]
set yrange [0:27]
set key bottom left
plot data.'/fig_12_4.csv' using 'x':'hertz' with lines ls 7 title 'Hertz', \
     data.'/fig_12_4_nodes.csv' using 'x':'lower' with points ls 1 ps 0.7 title 'lower contact', \
     data.'/fig_12_4_nodes.csv' using 'x':'upper' with points ls 2 pt 4 ps 1.2 title 'upper contact'
