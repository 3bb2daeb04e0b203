# Figure 12.3 - stress across the loaded diameter.   In: fig_12_3.csv, fig_12_3_nodes.csv   Out: fig_12_3.svg
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
     data.'/fig_12_3.csv' using 'depth':'lines' with lines ls 8 title 'two line loads (45)', \
     data.'/fig_12_3.csv' using 'depth':'arcs' with lines ls 2 title 'Hondros, arcs as wide as the contact', \
     data.'/fig_12_3.csv' using 'depth':'plates' with lines ls 7 title 'between plates, integral', \
     data.'/fig_12_3_nodes.csv' using 'depth':'across' with points ls 1 ps 0.5 title 'ours, nodes on the axis'
