# Figure 11.1 - contact pressure.   In: fig_11_1.csv, fig_11_1_nodes.csv, fig_11_1_nts.csv   Out: fig_11_1.svg
load 'style.gp'
set xlabel 'distance from the axis {/:Italic x} [mm]'
set ylabel 'contact pressure {/:Italic p} [MPa]'
set xrange [0:1.25]
set yrange [0:30]
set xtics 0.2
set key bottom left
plot data.'/fig_11_1.csv' using 'x':'theory' with lines ls 7 title 'closed form (43)', \
     data.'/fig_11_1_nodes.csv' using 'x':'p' with points ls 1 title 'mortar, meshes match', \
     data.'/fig_11_1_nts.csv' using 'x':'p' with points ls 5 title 'node to segment, not matching', \
     data.'/fig_11_1.csv' using 'x':'paper' with lines ls 2 title 'ellipse of the paper''s numbers', \
     data.'/fig_11_1.csv' using 'x':'abaqus' with lines ls 3 title 'ellipse of its ABAQUS numbers'
