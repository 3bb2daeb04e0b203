# Figure 12.5 - stress across the loaded diameter.   In: fig_12_5.csv, fig_12_5_nodes.csv   Out: fig_12_5.svg
load 'style.gp'
set xlabel 'depth below the contact {/:Italic z} [mm]'
set ylabel '{/:Italic σ_x} [MPa]'
set logscale x
set xrange [1:50]
set yrange [-1.6:0.4]
set ytics 0.4
set xtics (1, 2, 5, 10, 20, 50)
set key bottom right
plot 0 with lines lc rgb GREY lw 0.8 notitle, \
     data.'/fig_12_5.csv' using 'depth':'lines' with lines ls 8 title 'two line loads (45)', \
     data.'/fig_12_5.csv' using 'depth':'arcs' with lines ls 2 title 'arcs (Hondros)', \
     data.'/fig_12_5.csv' using 'depth':'plates' with lines ls 7 title 'plates, integral', \
     data.'/fig_12_5_nodes.csv' using 'depth':'across' with points ls 1 ps 0.5 title 'mesh'
